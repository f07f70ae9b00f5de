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

// Word i of a record whose first eight are r and q.
#define OIT_SORTED_WORD(i) ((i) < 4 ? r[(i) & 3] : q[(i) & 3])

uvec4 oit_color_words(uvec4 r, uvec4 q)
{
    uvec4 w = uvec4(OIT_SORTED_WORD(OIT_AT_COLOR), OIT_SORTED_WORD(OIT_AT_COLOR + 1), 0u, 0u);
#if OIT_COLOR == OIT_COLOR_FLOAT
    w.z = OIT_SORTED_WORD(OIT_AT_COLOR + 2);
    w.w = OIT_SORTED_WORD(OIT_AT_COLOR + 3);
#endif
    return w;
}
