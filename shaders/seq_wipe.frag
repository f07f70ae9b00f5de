// For: transparency.h
// Makes a texture of depths forget what was within the boxes.
void main()
{
    gl_FragDepth = TR_CLEAR_DEPTH;
}
