// For: oit_buffers.h
// Records read back: the order of two, colour, how it is laid over what is behind.
layout(std430, binding = OIT_BINDING_PIXELS) readonly buffer oit_pixels { uint oit_pixel[]; };
layout(std430, binding = OIT_BINDING_FRAGMENTS) readonly buffer oit_fragments { uint oit_word[]; };

#define OIT_NONE 0xffffffffu

// Whether the record at a comes after that at b; by their words, then by where they lie, which only tells apart records
// that are alike in every word.
bool oit_after(uint a, uint b)
{
    for (uint i = 0u; i < uint(OIT_WORDS); ++i) {
        uint x = oit_word[a + i], y = oit_word[b + i];
        if (x != y)
            return x > y;
    }
    return a > b;
}

vec4 oit_record_color(uint at)
{
#if OIT_COLOR == OIT_COLOR_8
    uint c = oit_word[at + uint(OIT_AT_COLOR)];
    return vec4(vec3(uvec3(c, c >> 8u, c >> 16u) & 255u) * (1.0 / 255.0), uintBitsToFloat(oit_word[at + uint(OIT_AT_COLOR + 1)]));
#elif OIT_COLOR == OIT_COLOR_HALF
    return vec4(unpackHalf2x16(oit_word[at + uint(OIT_AT_COLOR)]), unpackHalf2x16(oit_word[at + uint(OIT_AT_COLOR + 1)]));
#else
    return vec4(uintBitsToFloat(oit_word[at + uint(OIT_AT_COLOR)]), uintBitsToFloat(oit_word[at + uint(OIT_AT_COLOR + 1)]),
                uintBitsToFloat(oit_word[at + uint(OIT_AT_COLOR + 2)]), uintBitsToFloat(oit_word[at + uint(OIT_AT_COLOR + 3)]));
#endif
}

#if OIT_HAS_BLEND
uint oit_record_blend(uint at)
{
#if OIT_COLOR == OIT_COLOR_8
    return oit_word[at + uint(OIT_AT_COLOR)] >> 24u;
#else
    return oit_word[at + uint(OIT_AT_BLEND)];
#endif
}
#endif
