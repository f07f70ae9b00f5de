// For: oit_buffers.h
// Colour and coverage of a record, from the words that hold them.
#define OIT_COVERAGE_OF(word) ((word) >> uint(OIT_COVERAGE_SHIFT))

vec4 oit_unpack_color(uvec4 w)
{
#if OIT_COLOR == OIT_COLOR_8
    return vec4(vec3(uvec3(w.x, w.x >> 10u, w.x >> 20u) & 1023u) * (1.0 / 1023.0), uintBitsToFloat(w.y));
#elif OIT_COLOR == OIT_COLOR_HALF
    return vec4(unpackHalf2x16(w.x), unpackHalf2x16(w.y));
#else
    return uintBitsToFloat(w);
#endif
}
