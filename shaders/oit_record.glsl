// For: oit_buffers.h
// Records read back: the order of two, colour, how it is laid over what is behind.
#if !defined(OIT_SETTLES) && !defined(OIT_ARRANGES)
layout(std430, binding = OIT_BINDING_PIXELS) readonly buffer oit_pixels { uint oit_pixel[]; };
#elif defined(OIT_ARRANGES)
layout(std430, binding = OIT_BINDING_PIXELS) buffer oit_pixels { uint oit_pixel[]; };
#endif
layout(std430, binding = OIT_BINDING_RECORDS) readonly buffer oit_fragments { OIT_VECTOR oit_data[]; };

// Whether the record at a comes after that at b; by their words, then by where they lie, which only tells apart records
// that are alike in every word.
bool oit_after(uint a, uint b)
{
    for (uint i = 0u; i < uint(OIT_VECTORS); ++i) {
        OIT_VECTOR x = oit_data[a + i], y = oit_data[b + i];
        for (int k = 0; k < OIT_LANES; ++k)
            if (x[k] != y[k])
                return x[k] > y[k];
    }
    return a > b;
}

// Word i of the record at `at`; i is a constant.
#define OIT_WORD(at, i) oit_data[(at) + uint((i) / OIT_LANES)][(i) % OIT_LANES]

uint oit_record_depth(uint at)
{
    return oit_data[at].x;
}

// The words of the colour; of one vector where they lie in one, which some drivers load much faster.
uvec4 oit_record_words(uint at)
{
#if OIT_COLOR != OIT_COLOR_FLOAT && OIT_LANES == 4 && OIT_AT_COLOR < 3
    uvec4 w = oit_data[at];
    return uvec4(w[OIT_AT_COLOR], w[OIT_AT_COLOR + 1], 0u, 0u);
#elif OIT_COLOR != OIT_COLOR_FLOAT
    return uvec4(OIT_WORD(at, OIT_AT_COLOR), OIT_WORD(at, OIT_AT_COLOR + 1), 0u, 0u);
#else
    return uvec4(OIT_WORD(at, OIT_AT_COLOR), OIT_WORD(at, OIT_AT_COLOR + 1), OIT_WORD(at, OIT_AT_COLOR + 2),
                 OIT_WORD(at, OIT_AT_COLOR + 3));
#endif
}

#if defined(OIT_SETTLES) && OIT_ASYNC
// What the record adds to the tail.
vec4 oit_record_amounts(uint at)
{
    uvec4 words = oit_record_words(at);
#if OIT_HAS_BLEND && OIT_COLOR == OIT_COLOR_8
    return oit_tail_amounts(oit_unpack_color(words), words.x >> 30u);
#elif OIT_HAS_BLEND
    return oit_tail_amounts(oit_unpack_color(words), OIT_WORD(at, OIT_AT_BLEND));
#else
    return oit_tail_amounts(oit_unpack_color(words), 0u);
#endif
}
#endif
