// For: oit_buffers.h
// Records laid one behind the other, front to back (Carnecky 2013, section 4.6): oit_sum is what has come of them so far,
// oit_through how much is still seen of what is behind.
#if OIT_HAS_BLEND
#define OIT_THROUGH vec3
#else
#define OIT_THROUGH float
#endif
vec3 oit_sum = vec3(0.0);
OIT_THROUGH oit_through = OIT_THROUGH(1.0);

// Below 2^-24 of it nothing behind can change a float that is brighter than that.
bool oit_visible()
{
#if OIT_HAS_BLEND
    return max(oit_through.r, max(oit_through.g, oit_through.b)) > 5.9604645e-8;
#else
    return oit_through > 5.9604645e-8;
#endif
}

void oit_lay(uint at)
{
#if OIT_COVERED == OIT_BY_SAMPLE
    if ((OIT_WORD(at, OIT_AT_COVERAGE) >> uint(gl_SampleID) & 1u) == 0u)
        return;
#endif
    uvec4 words = oit_record_words(at);
    vec4 color = oit_unpack_color(words);
#if OIT_COVERED == OIT_BY_SHARE
    color *= vec4(vec3(OIT_PREMULTIPLIED == 1 ? OIT_SHARE(OIT_WORD(at, OIT_AT_COVERAGE)) : 1.0),
                  OIT_SHARE(OIT_WORD(at, OIT_AT_COVERAGE)));
#endif
#if OIT_PREMULTIPLIED
    vec3 light = color.rgb;
#else
    vec3 light = color.a * color.rgb;
#endif
#if OIT_HAS_BLEND
#if OIT_COLOR == OIT_COLOR_8
    uint blend = words.x >> 30u;
#else
    uint blend = OIT_WORD(at, OIT_AT_BLEND);
#endif
    if (blend == 2u) { // multiply: seen through a filter of that colour
        oit_through *= 1.0 - color.a + light;
        return;
    }
    oit_sum += oit_through * light;
    if (blend == 1u) // add: light, which hides nothing
        return;
#else
    oit_sum += oit_through * light;
#endif
    oit_through *= 1.0 - color.a;
}

// All records of one depth, in their order, each found anew: ties are rare.
void oit_lay_group(uint base, uint count, uint depth)
{
    uint last = OIT_NONE;
    for (;;) {
        uint best = OIT_NONE;
        for (uint i = 0u; i < count; ++i) {
            uint at = base + i * uint(OIT_VECTORS);
            if (oit_record_depth(at) != depth || (last != OIT_NONE && !oit_after(at, last)))
                continue;
            if (best == OIT_NONE || oit_after(best, at))
                best = at;
        }
        if (best == OIT_NONE)
            return;
        oit_lay(best);
        last = best;
    }
}

// What oit_i_add_network writes is made of these: registers d (depth) and o (where the record lies).
#define L(d, o, i) uint d = OIT_NONE, o = base; if (i < n) { o = base + i * uint(OIT_VECTORS); d = oit_record_depth(o); }
#define S(d, o, e, p) { bool g = e < d; uint t = g ? p : o; p = g ? o : p; o = t; t = min(d, e); e = max(d, e); d = t; }
#define T(d, e, i) tie = tie || (d == e && i < n);
#define D(d, o) uint d = OIT_NONE, o = base;
#define I(d, o) { s = s || x < d; uint t = d; d = s ? x : d; x = s ? t : x; t = o; o = s ? y : o; y = s ? t : y; }
uint oit_order[OIT_CLASS + OIT_DEEP];
