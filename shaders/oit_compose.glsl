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

#if OIT_ADAPTIVE
// Adaptive transparency (Carnecky 2013, equation 5): each of a pixel's n layers gets 1 - (1 - s)^(1/n), so that together they
// hide as much as one of opacity s, however many there are. Here s is a fragment's own alpha. Layers are what that changes:
// neither light that is added nor filters, nor what is opaque, nor what lies behind that.
float oit_layers = 1.0;

// Alpha, where the record is laid over what is behind it, else 0; and how much of what is composed it covers.
float oit_over_alpha(uint at, out float part)
{
    uvec4 r, q;
    oit_load(at, r, q);
    part = 1.0;
#if OIT_COVERED == OIT_BY_SAMPLE
    part = float(OIT_COVERAGE_OF(OIT_SORTED_WORD(OIT_AT_COVERAGE)) >> uint(gl_SampleID) & 1u);
#elif OIT_COVERED == OIT_BY_SHARE
    part = OIT_SHARE(OIT_COVERAGE_OF(OIT_SORTED_WORD(OIT_AT_COVERAGE)));
#endif
#if OIT_HAS_BLEND && OIT_COLOR == OIT_COLOR_8
    if (OIT_SORTED_WORD(OIT_AT_COLOR) >> 30u != 0u)
        return 0.0;
#elif OIT_HAS_BLEND
    if ((OIT_SORTED_WORD(OIT_AT_BLEND) & 255u) != 0u)
        return 0.0;
#endif
    return oit_unpack_color(oit_color_words(r, q)).a;
}

void oit_count_layers(uint base, uint n)
{
    uint wall = OIT_NONE;
    float part;
    for (uint i = 0u; i < n; ++i) {
        uint at = base + i * uint(OIT_VECTORS);
        if (oit_over_alpha(at, part) >= 1.0 && part == 1.0)
            wall = min(wall, oit_record_depth(at));
    }
    oit_layers = 0.0;
    for (uint i = 0u; i < n; ++i) {
        uint at = base + i * uint(OIT_VECTORS);
        float alpha = oit_over_alpha(at, part);
        if (alpha > 0.0 && alpha < 1.0 && oit_record_depth(at) < wall)
            oit_layers += part;
    }
}

// 1 - (1 - alpha)^(1/n) = 1 - e^(log(1 - alpha) / n); by series where the plain functions lose their digits, or are none
// too good on some drivers: log(1 - a) = -2 artanh(a / (2 - a)).
float oit_adapt(float alpha)
{
    if (!(alpha > 0.0 && alpha < 1.0 && oit_layers > 1.0))
        return alpha;
    float z = alpha / (2.0 - alpha), y = z * z, t = log(1.0 - alpha);
    if (alpha < 0.5)
        t = -2.0 * z * (1.0 + y * (1.0 / 3.0 + y * (1.0 / 5.0 + y * (1.0 / 7.0 + y * (1.0 / 9.0 + y * (1.0 / 11.0 + y / 13.0))))));
    t /= oit_layers;
    if (t < -0.3)
        return 1.0 - exp(t);
    return -t * (1.0 + t / 2.0 * (1.0 + t / 3.0 * (1.0 + t / 4.0 * (1.0 + t / 5.0 * (1.0 + t / 6.0 * (1.0 + t / 7.0))))));
}
#endif

void oit_lay(uvec4 r, uvec4 q)
{
#if OIT_COVERED == OIT_BY_SAMPLE
    if ((OIT_COVERAGE_OF(OIT_SORTED_WORD(OIT_AT_COVERAGE)) >> uint(gl_SampleID) & 1u) == 0u)
        return;
#endif
    uvec4 words = oit_color_words(r, q);
    vec4 color = oit_unpack_color(words);
#if OIT_ADAPTIVE && OIT_HAS_BLEND && OIT_COLOR == OIT_COLOR_8
    float adapted = words.x >> 30u == 0u ? oit_adapt(color.a) : color.a;
#elif OIT_ADAPTIVE && OIT_HAS_BLEND
    float adapted = (OIT_SORTED_WORD(OIT_AT_BLEND) & 255u) == 0u ? oit_adapt(color.a) : color.a;
#elif OIT_ADAPTIVE
    float adapted = oit_adapt(color.a);
#endif
#if OIT_ADAPTIVE
    if (adapted != color.a)
        color = vec4(color.rgb * (OIT_PREMULTIPLIED == 1 ? adapted / color.a : 1.0), adapted);
#endif
#if OIT_COVERED == OIT_BY_SHARE
    color *= vec4(vec3(OIT_PREMULTIPLIED == 1 ? OIT_SHARE(OIT_COVERAGE_OF(OIT_SORTED_WORD(OIT_AT_COVERAGE))) : 1.0),
                  OIT_SHARE(OIT_COVERAGE_OF(OIT_SORTED_WORD(OIT_AT_COVERAGE))));
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
    uint blend = OIT_SORTED_WORD(OIT_AT_BLEND) & 255u;
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

#if OIT_STORE != OIT_FETCH
void oit_lay(uint at)
{
    uvec4 r, q;
    oit_load(at, r, q);
    oit_lay(r, q);
}
#endif

#if OIT_DEEP
// Behind what is opaque all weights are zero, so that to stop there changes no bit.
bool oit_visible()
{
#if OIT_HAS_BLEND
    return max(oit_through.r, max(oit_through.g, oit_through.b)) > 0.0;
#else
    return oit_through > 0.0;
#endif
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

// What oit_i_put_selection writes is made of these: registers d (depth) and o (where the record lies).
#define D(d, o) uint d = OIT_NONE, o = base;
#define I(d, o) { s = s || x < d; uint t = d; d = s ? x : d; x = s ? t : x; t = o; o = s ? y : o; y = s ? t : y; }
uint oit_order[OIT_CLASS + 1];
#else
// By all their words, so that two of which neither comes after the other are alike: ties need no further care.
bool oit_words_after(uvec4 a, uvec4 b, bool more)
{
    return a.x > b.x || (a.x == b.x && (a.y > b.y || (a.y == b.y && (a.z > b.z || (a.z == b.z && (a.w > b.w || (a.w == b.w && more)))))));
}

// What oit_i_put_network writes is made of these: registers r and q (oit_load), swapped where they are in the wrong order,
// then laid. Each record is read once; what is not there comes after all that is, and has no colour and no alpha.
#define L(r, q, i) uvec4 r = uvec4(OIT_NONE, 0u, 0u, 0u), q = uvec4(0u); if (i < n) oit_load(base + i * uint(OIT_VECTORS), r, q);
#if OIT_SORTED > 4
#define S(r, q, u, v) { bool g = oit_words_after(r, u, oit_words_after(q, v, false)); uvec4 t = g ? u : r; u = g ? r : u; r = t; t = g ? v : q; v = g ? q : v; q = t; }
#else
#define S(r, q, u, v) { bool g = oit_words_after(r, u, false); uvec4 t = g ? u : r; u = g ? r : u; r = t; }
#endif
#define Y(r, q, i) oit_lay(r, q);
#endif
