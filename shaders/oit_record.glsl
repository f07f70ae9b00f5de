// For: oit_buffers.h
// Records read back: the order of two, colour, how it is laid over what is behind.
#ifndef OIT_SETTLES
#ifdef OIT_ARRANGES
layout(std430, binding = OIT_BINDING_PIXELS) buffer oit_pixels { uint oit_pixel[]; };
#else
layout(std430, binding = OIT_BINDING_PIXELS) readonly buffer oit_pixels { uint oit_pixel[]; };
#endif
#endif
#ifndef OIT_BINDING_RECORDS
#define OIT_BINDING_RECORDS OIT_BINDING_FRAGMENTS
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

// The words by which records are sorted and composed: the first OIT_SORTED of them, depth to colour and blend, in two
// vectors; zeros after them. What a record carries beyond cannot be seen in the picture.
void oit_load(uint at, out uvec4 r, out uvec4 q)
{
    q = uvec4(0u);
#if OIT_LANES == 4
    r = oit_data[at];
#if OIT_SORTED > 4
    q = oit_data[at + 1u];
#endif
#else
    r = uvec4(oit_data[at], oit_data[at + 1u]);
#if OIT_SORTED > 4
    q.xy = oit_data[at + 2u];
#endif
#if OIT_SORTED > 6
    q.zw = oit_data[at + 3u];
#endif
#endif
#if OIT_SORTED < 4
    r.w = 0u;
#endif
#if OIT_SORTED < 6
    q.y = 0u;
#endif
#if OIT_SORTED < 7
    q.z = 0u;
#endif
#if OIT_SORTED < 8
    q.w = 0u;
#endif
}

#if defined(OIT_SETTLES) && OIT_ASYNC
// What the record adds to the tail.
vec4 oit_record_amounts(uint at)
{
    uvec4 r, q;
    uint blend = 0u, covered = 0u;
    oit_load(at, r, q);
    uvec4 words = oit_color_words(r, q);
#if OIT_HAS_BLEND && OIT_COLOR == OIT_COLOR_8
    blend = words.x >> 30u;
#elif OIT_HAS_BLEND
    blend = OIT_SORTED_WORD(OIT_AT_BLEND) & 255u;
#endif
#if OIT_HAS_COVERAGE
    covered = OIT_COVERAGE_OF(OIT_SORTED_WORD(OIT_AT_COVERAGE));
#endif
    return oit_tail_amounts(oit_unpack_color(words), blend, covered);
}
#endif
