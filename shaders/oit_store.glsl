// For: oit_buffers.h
// What a fragment shader calls: oit_store(fragment), or oit_store(color). Counts in the count pass; in the fill pass writes
// one record of OIT_VECTORS vectors into the pixel's run. Records are written so that their words, compared one after the
// other, give the order in which they are composed: depth, part, key, and all else for fragments that tie.
layout(early_fragment_tests) in;
#if OIT_HAS_COVERAGE && OIT_POST_DEPTH
layout(post_depth_coverage) in;
#endif
#if OIT_PASS == OIT_FILL && OIT_STORE != OIT_FETCH
layout(std430, binding = OIT_BINDING_FRAGMENTS) writeonly buffer oit_fragments { OIT_VECTOR oit_data[]; };
#endif

#define OIT_BLEND_OVER 0u
#define OIT_BLEND_ADD 1u
#define OIT_BLEND_MULTIPLY 2u
#define OIT_BLEND_LINE 3u

struct oit_fragment
{
    vec4 color; // rgb and alpha
#if OIT_HAS_PART
    uint part;
#endif
#if OIT_HAS_KEY
    uint key;
#endif
#if OIT_HAS_BLEND
    uint blend;
#endif
#if OIT_HAS_NORMAL
    vec3 normal;
#endif
#if OIT_HAS_UV
    vec2 uv;
#endif
#if OIT_HOST_WORDS > 0
    uint words[OIT_HOST_WORDS];
#endif
};

// NaN and infinities by their bits: compilers may take comparisons with them away.
float oit_finite(float x)
{
    return (floatBitsToUint(x) & 0x7f800000u) == 0x7f800000u ? 0.0 : x;
}

vec4 oit_finite(vec4 color)
{
    vec3 c = vec3(oit_finite(color.r), oit_finite(color.g), oit_finite(color.b));
    return vec4(c, clamp(oit_finite(color.a), 0.0, 1.0));
}

#if OIT_HAS_SLOPE && OIT_PASS == OIT_FILL
// What the window depth gains a pixel to the right and a pixel up, for operators; taken where control flow is uniform, as
// below.
#if OIT_ES
#define OIT_DEPTH_SLOPE vec2(dFdx(gl_FragCoord.z), dFdy(gl_FragCoord.z))
#else
vec2 oit_depth_slope = vec2(dFdx(gl_FragCoord.z), dFdy(gl_FragCoord.z));
#define OIT_DEPTH_SLOPE oit_depth_slope
#endif
#endif

#if OIT_HAS_COVERAGE
// The samples that the fragment covers and that lie before the host's opaque things. Where the driver knows coverage only
// from before the depth test, and where the host wants it, each sample is a fragment of its own.
uint oit_coverage()
{
#if OIT_POST_DEPTH
    return uint(gl_SampleMaskIn[0]);
#else
    return 1u << uint(gl_SampleID);
#endif
}

#if OIT_POST_DEPTH
// The middle of the pixel may lie beyond the edge of the triangle, where the planes of a body's front and back have crossed
// already: the depth is that at the middle of the samples that are covered. Derivatives are taken where control flow is
// uniform, before whatever the host's main does; ES has no such place.
#if OIT_ES
#define OIT_SLOPE vec2(dFdx(gl_FragCoord.z), dFdy(gl_FragCoord.z))
#else
vec2 oit_slope = vec2(dFdx(gl_FragCoord.z), dFdy(gl_FragCoord.z));
#define OIT_SLOPE oit_slope
#endif

float oit_depth()
{
    vec2 slope = OIT_SLOPE, sum = vec2(0.0);
    uint covered = oit_coverage();
    if (covered == oit_samples.x)
        return gl_FragCoord.z;
    for (uint i = 0u; i < 8u; ++i) {
        vec4 two = oit_positions[i >> 1u];
        sum += (covered >> i & 1u) != 0u ? ((i & 1u) != 0u ? two.zw : two.xy) : vec2(0.0);
    }
    return clamp(gl_FragCoord.z + dot(slope, sum / float(max(bitCount(covered), 1))), 0.0, 1.0);
}
#else
#define oit_depth() gl_FragCoord.z
#endif
#else
#define oit_depth() gl_FragCoord.z
#endif

// Ascends from the eye on, in either convention. A depth of -0.0 is 0.0.
uint oit_depth_bits()
{
    uint bits = floatBitsToUint(oit_depth());
    bits = bits > 0x7fffffffu ? 0u : bits;
#if OIT_REVERSED_Z
    bits = 0x7fffffffu - bits;
#endif
    return bits;
}

uint oit_pixel_index()
{
    ivec2 at = ivec2(gl_FragCoord.xy) - oit_area.xy;
    return uint(at.y) * uint(oit_area.z) + uint(at.x);
}

#if OIT_KEEPS
// By what the k nearest are chosen, the same in both geometry passes: all bits of the depth, or (Murray 2016, section 4.2)
// 16 of it and then 16 of the part. Never OIT_NONE.
uint oit_key(oit_fragment f)
{
#if OIT_KEY_BITS == 16
    uint depth = uint(clamp(gl_FragCoord.z, 0.0, 1.0) * 65534.0);
#if OIT_REVERSED_Z
    depth = 65534u - depth;
#endif
    return depth << 16u | (f.part & 0xffffu);
#else
    return oit_depth_bits();
#endif
}
#endif

#if OIT_KEEPS && OIT_PASS == OIT_COUNT
// Leaves the k + 1 smallest keys of the pixel in its k + 1 words, in no order. A word only ever gets smaller, and by a
// swap that fails where another fragment was there before. So when the swap succeeds, all that was read of the other words
// is still an upper bound of them: the key that goes is the greatest of the k + 2, whatever else is under way, and a key
// that is not less than all words read is not less than all words are. The smallest k + 1 stay, in any order of arrival.
// No word ever exceeds the limit once it is set, which spares most fragments the search.
void oit_select(uint p, uint key)
{
    uint place = atomicAdd(oit_pixel[OIT_LEFT(p)], 1u);
    if (place <= OIT_LAYERS && atomicCompSwap(oit_pixel[OIT_KEY(p, place)], OIT_NONE, key) == OIT_NONE)
        return;
    while (key < oit_pixel[OIT_LIMIT(p)]) {
        uint most = 0u, second = 0u, at = 0u;
        for (uint i = 0u; i <= OIT_LAYERS; ++i) {
            uint other = oit_pixel[OIT_KEY(p, i)];
            second = max(second, min(other, most));
            at = other >= most ? i : at;
            most = max(most, other);
        }
        if (key >= most)
            return;
        if (atomicCompSwap(oit_pixel[OIT_KEY(p, at)], most, key) == most) {
            atomicMin(oit_pixel[OIT_LIMIT(p)], max(second, key));
            return;
        }
    }
}
#endif

#if OIT_PASS == OIT_FILL
#if OIT_HAS_NORMAL
// The octahedron unfolded: both coordinates of a direction in 16 bits each. A normal of no length is that toward the eye.
uint oit_pack_normal(vec3 n)
{
    n = vec3(oit_finite(n.x), oit_finite(n.y), oit_finite(n.z));
    float size = abs(n.x) + abs(n.y) + abs(n.z);
    n = size > 0.0 && size < 1.0e38 ? n / size : vec3(0.0, 0.0, 1.0);
    vec2 folded = (1.0 - abs(n.yx)) * vec2(n.x < 0.0 ? -1.0 : 1.0, n.y < 0.0 ? -1.0 : 1.0);
    return packSnorm2x16(n.z < 0.0 ? folded : n.xy);
}
#endif

void oit_pack(oit_fragment f, out uint w[OIT_VECTORS * OIT_LANES])
{
    vec4 color = oit_finite(f.color);
    for (int i = 0; i < OIT_VECTORS * OIT_LANES; ++i)
        w[i] = 0u;
    w[0] = oit_depth_bits();
#if OIT_HAS_PART
    w[OIT_AT_PART] = f.part;
#endif
#if OIT_HAS_KEY
    w[OIT_AT_KEY] = f.key;
#endif
#if OIT_COLOR == OIT_COLOR_8
    uvec3 c = uvec3(clamp(color.rgb, 0.0, 1.0) * 1023.0 + 0.5);
    w[OIT_AT_COLOR] = c.r | c.g << 10u | c.b << 20u;
#if OIT_HAS_BLEND
    w[OIT_AT_COLOR] |= f.blend << 30u;
#endif
    w[OIT_AT_COLOR + 1] = floatBitsToUint(color.a);
#elif OIT_COLOR == OIT_COLOR_HALF
    vec3 c = clamp(color.rgb, -65504.0, 65504.0);
    w[OIT_AT_COLOR] = packHalf2x16(c.rg);
    w[OIT_AT_COLOR + 1] = packHalf2x16(vec2(c.b, color.a));
#else
    for (int i = 0; i < 4; ++i)
        w[OIT_AT_COLOR + i] = floatBitsToUint(color[i]);
#endif
#if OIT_HAS_BLEND && OIT_COLOR != OIT_COLOR_8
    w[OIT_AT_BLEND] = f.blend & 255u;
#endif
#if OIT_HAS_NORMAL
    w[OIT_AT_NORMAL] = oit_pack_normal(f.normal);
#endif
#if OIT_HAS_UV
    w[OIT_AT_UV] = floatBitsToUint(f.uv.x);
    w[OIT_AT_UV + 1] = floatBitsToUint(f.uv.y);
#endif
#if OIT_HAS_COVERAGE
    w[OIT_AT_COVERAGE] |= oit_coverage() << uint(OIT_COVERAGE_SHIFT);
#endif
#if OIT_HAS_SLOPE // halves reach from 2^-24 to 65504: scaled, from 1.5e-11 to 16 a pixel
    w[OIT_AT_SLOPE] = packHalf2x16(clamp(OIT_DEPTH_SLOPE * 4096.0, -65504.0, 65504.0));
#endif
#if OIT_HOST_WORDS > 0
    for (int i = 0; i < OIT_HOST_WORDS; ++i)
        w[OIT_AT_HOST + i] = f.words[i];
#endif
}

#if OIT_STORE == OIT_FETCH
bool oit_before(uvec4 a, uvec4 b)
{
    return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z != b.z ? a.z < b.z : a.w < b.w;
}

// Into the layers of this pass, nearest first; what falls out is for a later pass. What has been composed is passed over:
// all that comes before the last record that was, and of those like it, which no one can tell apart, as many as were.
void oit_put(uint p, uvec4 r)
{
    uint at = OIT_LAID(p), copies = oit_pixel[at + 4u];
    uvec4 last = uvec4(oit_pixel[at], oit_pixel[at + 1u], oit_pixel[at + 2u], oit_pixel[at + 3u]);
    oit_seen.y += 1u;
    if (copies > 0u && !oit_before(last, r)) {
        oit_seen.x += r == last ? 1u : 0u;
        if (r != last || oit_seen.x <= copies)
            return;
    }
#define OIT_EXCHANGE(l) if (oit_before(r, l)) { uvec4 kept = l; l = r; r = kept; }
    OIT_EACH_LAYER(OIT_EXCHANGE)
}
#else
void oit_write(uint at, uint w[OIT_VECTORS * OIT_LANES])
{
    for (int i = 0; i < OIT_VECTORS; ++i)
#if OIT_LANES == 4
        oit_data[at + uint(i)] = uvec4(w[4 * i], w[4 * i + 1], w[4 * i + 2], w[4 * i + 3]);
#else
        oit_data[at + uint(i)] = uvec2(w[2 * i], w[2 * i + 1]);
#endif
}
#endif

#if (OIT_ASYNC || OIT_KEEPS) && OIT_STORE != OIT_FETCH
#if OIT_HAS_COVERAGE
#define OIT_COVERED_NOW oit_coverage()
#else
#define OIT_COVERED_NOW 0u
#endif
#if OIT_HAS_BLEND
#define OIT_BLEND_OF(f) f.blend
#else
#define OIT_BLEND_OF(f) OIT_BLEND_OVER
#endif

#if OIT_KEEPS
void oit_to_tail(uint p, oit_fragment f)
{
    oit_add_to_tail(p, oit_tail_amounts(oit_finite(f.color), OIT_BLEND_OF(f), OIT_COVERED_NOW));
}
#elif OIT_TAIL_WORDS == 6
// With the colour as it would be read back: what is stored of the same pixel is added by others from there.
void oit_to_tail(uint p, oit_fragment f, uint w[OIT_VECTORS * OIT_LANES])
{
    uvec4 words = uvec4(w[OIT_AT_COLOR], w[OIT_AT_COLOR + 1], 0u, 0u);
#if OIT_COLOR == OIT_COLOR_FLOAT
    words.zw = uvec2(w[OIT_AT_COLOR + 2], w[OIT_AT_COLOR + 3]);
#endif
    oit_add_to_tail(p, oit_tail_amounts(oit_unpack_color(words), OIT_BLEND_OF(f), OIT_COVERED_NOW));
}
#else
// Bits are shared out by the count of the pixel, so that no sum overflows.
void oit_to_tail(uint p, uint count, oit_fragment f)
{
    float scale = exp2(float(26 - findMSB(count) - 1));
#if OIT_ADAPTIVE && OIT_HAS_BLEND // equation 5, all fragments of the pixel taken for layers
    scale /= f.color.a < 1.0 && f.blend == OIT_BLEND_OVER ? float(count) : 1.0;
#elif OIT_ADAPTIVE
    scale /= f.color.a < 1.0 ? float(count) : 1.0;
#endif
    uvec4 parts = uvec4(oit_tail_amounts(oit_finite(f.color), OIT_BLEND_OF(f), OIT_COVERED_NOW) * scale + 0.5);
    atomicAdd(oit_pixel[OIT_TAIL(p)], parts.r);
    atomicAdd(oit_pixel[OIT_TAIL(p) + 1u], parts.g);
    atomicAdd(oit_pixel[OIT_TAIL(p) + 2u], parts.b);
    atomicAdd(oit_pixel[OIT_TAIL(p) + 3u], parts.a);
}
#endif
#endif
#endif

#if OIT_PASS == OIT_FILL && OIT_STORE == OIT_LINKED
// Carnecky 2013, algorithm 1. A fragment for which the list is too small counts all the same.
void oit_insert(uint p, oit_fragment f)
{
    uint w[OIT_VECTORS * OIT_LANES];
    oit_pack(f, w);
    uint slot = atomicAdd(oit_pixel[OIT_TAKEN], 1u);
    if (slot >= oit_pool.z) {
#if OIT_ASYNC
        oit_to_tail(p, f, w);
#endif
        return;
    }
    w[OIT_AT_LINK] = atomicExchange(oit_pixel[OIT_HEAD(p)], slot + 1u);
    oit_write(slot * uint(OIT_VECTORS), w);
}
#endif

void oit_store(oit_fragment f)
{
    uint p = oit_pixel_index();
#if OIT_HAS_COVERAGE
    if (OIT_OUTSIDE)
        return;
    if (oit_coverage() != oit_samples.x)
        oit_pixel[OIT_EDGE(p)] = 1u;
#endif
#if OIT_KEEPS && OIT_PASS == OIT_COUNT
    oit_select(p, oit_key(f));
#elif OIT_PASS == OIT_COUNT
    atomicAdd(oit_pixel[OIT_WANTED(p)], 1u);
#elif OIT_STORE == OIT_FETCH
    uint w[4];
    oit_pack(f, w);
    oit_put(p, uvec4(w[0], w[1], w[2], w[3]));
#else
#if OIT_KEEPS
    if (oit_key(f) >= oit_pixel[OIT_LIMIT(p)]) {
        oit_to_tail(p, f);
        return;
    }
#endif
    uint left = atomicAdd(oit_pixel[OIT_LEFT(p)], OIT_STORE == OIT_LINKED && OIT_DIRECT ? 1u : 0xffffffffu);
#if OIT_ASYNC && (OIT_STORE == OIT_EXACT || OIT_STORE == OIT_LINKED)
    if (left >> 30u == 1u) { // OIT_UNFIT, and not what wraps below 0
        if (left == OIT_UNFIT) {
            atomicAdd(oit_pixel[OIT_EXTRA], 1u);
            return;
        }
#if OIT_TAIL_WORDS == 4
        oit_to_tail(p, oit_pixel[OIT_START(p + 1u)] - oit_pixel[OIT_START(p)], f);
#else
        uint words[OIT_VECTORS * OIT_LANES];
        oit_pack(f, words);
        oit_to_tail(p, f, words);
#endif
        return;
    }
#endif
#if OIT_STORE == OIT_LINKED
    if (OIT_DIRECT || left - 1u < oit_pool.z)
        oit_insert(p, f);
    else
        atomicAdd(oit_pixel[OIT_EXTRA], 1u);
#else
    // Nothing is written outside of the run, however many fragments come: after as many as were counted, what is left is
    // 0, and then wraps to more than any pool holds.
    uint w[OIT_VECTORS * OIT_LANES];
    oit_pack(f, w);
    uint slot = oit_pixel[OIT_START(p)] + left - 1u - oit_pool.y;
    if (left - 1u >= oit_pool.z || slot >= oit_pool.z) {
#if OIT_STORE != OIT_PREDICT
        atomicAdd(oit_pixel[OIT_EXTRA], 1u);
#elif OIT_ASYNC
        oit_to_tail(p, f, w);
#endif
        return;
    }
    oit_write(slot * uint(OIT_VECTORS), w);
#endif
#endif
}

void oit_store(vec4 color)
{
    oit_fragment f;
    f.color = color;
#if OIT_HAS_PART
    f.part = 0u;
#endif
#if OIT_HAS_KEY
    f.key = 0u;
#endif
#if OIT_HAS_BLEND
    f.blend = OIT_BLEND_OVER;
#endif
#if OIT_HAS_NORMAL
    f.normal = vec3(0.0, 0.0, 1.0);
#endif
#if OIT_HAS_UV
    f.uv = vec2(0.0);
#endif
#if OIT_HOST_WORDS > 0
    for (int i = 0; i < OIT_HOST_WORDS; ++i)
        f.words[i] = 0u;
#endif
    oit_store(f);
}
