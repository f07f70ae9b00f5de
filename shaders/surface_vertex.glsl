// For: transparency.h
// Vertex stage. What every vertex shader of a sequence shares.
//
// Passes compare depths for equality: all programs that draw an object must compute the very same position.
invariant gl_Position;
