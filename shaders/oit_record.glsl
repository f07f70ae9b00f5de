// For: oit_buffers.h
// Records read back: the order of two, colour, how it is laid over what is behind.
#ifdef OIT_ARRANGES
layout(std430, binding = OIT_BINDING_PIXELS) buffer oit_pixels { uint oit_pixel[]; };
#else
layout(std430, binding = OIT_BINDING_PIXELS) readonly buffer oit_pixels { uint oit_pixel[]; };
#endif
layout(std430, binding = OIT_BINDING_FRAGMENTS) readonly buffer oit_fragments { OIT_VECTOR oit_data[]; };

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

// The words by which records are sorted and composed: the first OIT_SORTED of them, depth to colour and blend, in two
// vectors; zeros after them. What a record carries beyond cannot be seen in the picture.
#define OIT_COVERAGE_OF(word) ((word) >> uint(OIT_COVERAGE_SHIFT))
#define OIT_SORTED_WORD(i) ((i) < 4 ? r[(i) & 3] : q[(i) & 3])
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

uvec4 oit_color_words(uvec4 r, uvec4 q)
{
    uvec4 w = uvec4(OIT_SORTED_WORD(OIT_AT_COLOR), OIT_SORTED_WORD(OIT_AT_COLOR + 1), 0u, 0u);
#if OIT_COLOR == OIT_COLOR_FLOAT
    w.z = OIT_SORTED_WORD(OIT_AT_COLOR + 2);
    w.w = OIT_SORTED_WORD(OIT_AT_COLOR + 3);
#endif
    return w;
}
