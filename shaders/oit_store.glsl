// For: oit_buffers.h
// What a fragment shader calls: oit_store(fragment), or oit_store(color). Counts in the count pass; in the fill pass writes
// one record of OIT_WORDS words into the pixel's run. Records are written so that their words, compared one after the
// other, give the order in which they are composed: depth, part, key, and all else for fragments that tie.
layout(early_fragment_tests) in;
layout(std430, binding = OIT_BINDING_PIXELS) buffer oit_pixels { uint oit_pixel[]; };
#if OIT_PASS == OIT_FILL
layout(std430, binding = OIT_BINDING_FRAGMENTS) writeonly buffer oit_fragments { uint oit_word[]; };
#endif

#define OIT_BLEND_OVER 0u
#define OIT_BLEND_ADD 1u
#define OIT_BLEND_MULTIPLY 2u

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

// Ascends from the eye on, in either convention. A depth of -0.0 is 0.0.
uint oit_depth_bits()
{
    uint bits = floatBitsToUint(gl_FragCoord.z);
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

void oit_write(uint at, oit_fragment f)
{
    vec4 color = oit_finite(f.color);
    oit_word[at++] = oit_depth_bits();
#if OIT_HAS_PART
    oit_word[at++] = f.part;
#endif
#if OIT_HAS_KEY
    oit_word[at++] = f.key;
#endif
#if OIT_COLOR == OIT_COLOR_8
    uvec3 c = uvec3(clamp(color.rgb, 0.0, 1.0) * 255.0 + 0.5);
    uint packed_color = c.r | c.g << 8u | c.b << 16u;
#if OIT_HAS_BLEND
    packed_color |= f.blend << 24u;
#endif
    oit_word[at++] = packed_color;
    oit_word[at++] = floatBitsToUint(color.a);
#elif OIT_COLOR == OIT_COLOR_HALF
    vec3 c = clamp(color.rgb, -65504.0, 65504.0);
    oit_word[at++] = packHalf2x16(c.rg);
    oit_word[at++] = packHalf2x16(vec2(c.b, color.a));
#else
    oit_word[at++] = floatBitsToUint(color.r);
    oit_word[at++] = floatBitsToUint(color.g);
    oit_word[at++] = floatBitsToUint(color.b);
    oit_word[at++] = floatBitsToUint(color.a);
#endif
#if OIT_HAS_BLEND && OIT_COLOR != OIT_COLOR_8
    oit_word[at++] = f.blend;
#endif
#if OIT_HAS_NORMAL
    oit_word[at++] = oit_pack_normal(f.normal);
#endif
#if OIT_HAS_UV
    oit_word[at++] = floatBitsToUint(f.uv.x);
    oit_word[at++] = floatBitsToUint(f.uv.y);
#endif
#if OIT_HOST_WORDS > 0
    for (int i = 0; i < OIT_HOST_WORDS; ++i)
        oit_word[at++] = f.words[i];
#endif
}

#if OIT_ASYNC
// The tail: sums that do not depend on the order, in integers so that rounding does not either. The layers of a pixel are
// taken as mixed evenly: optical depths add, colours are weighted by them. Bits are shared out by the count of the
// pixel, so that no sum overflows: colours up to 4 and optical depths up to 11 make less than 64 a fragment.
void oit_to_tail(uint p, uint count, oit_fragment f)
{
    vec4 color = oit_finite(f.color);
    float scale = exp2(float(26 - findMSB(count) - 1));
    float thickness = min(-log(1.0 - min(color.a, 0.999999)), 11.0);
    vec3 c = clamp(color.rgb, 0.0, 4.0);
#if OIT_PREMULTIPLIED
    c = color.a > 0.0 ? min(c / color.a, vec3(4.0)) : c;
    float weight = color.a > 0.0 ? thickness : 1.0;
#else
    float weight = thickness;
#endif
#if OIT_HAS_BLEND
    if (f.blend == OIT_BLEND_ADD) {
        weight = OIT_PREMULTIPLIED == 1 ? max(color.a, 1.0e-6) : color.a;
        thickness = 0.0;
    } else if (f.blend == OIT_BLEND_MULTIPLY) {
        float keep = 1.0 - color.a + color.a * min((c.r + c.g + c.b) / 3.0, 1.0);
        thickness = min(-log(max(keep, 1.0e-6)), 11.0);
        weight = 0.0;
    }
#endif
    uvec4 parts = uvec4(vec4(c * weight, thickness) * scale + 0.5);
    atomicAdd(oit_pixel[OIT_TAIL(p)], parts.r);
    atomicAdd(oit_pixel[OIT_TAIL(p) + 1u], parts.g);
    atomicAdd(oit_pixel[OIT_TAIL(p) + 2u], parts.b);
    atomicAdd(oit_pixel[OIT_TAIL(p) + 3u], parts.a);
}
#endif
#endif

void oit_store(oit_fragment f)
{
    uint p = oit_pixel_index();
#if OIT_PASS == OIT_COUNT
    atomicAdd(oit_pixel[OIT_LEFT(p)], 1u);
#else
    uint start = oit_pixel[OIT_START(p)], end = oit_pixel[OIT_START(p + 1u)];
    uint left = atomicAdd(oit_pixel[OIT_LEFT(p)], 0xffffffffu);
    // Nothing is written outside of the run, however many fragments come: 0, and what wraps below it, are beyond any count.
    if (left - 1u >= end - start) {
        atomicAdd(oit_pixel[OIT_EXTRA], 1u);
        return;
    }
#if OIT_ASYNC
    if (end > oit_pool.z) {
        oit_to_tail(p, end - start, f);
        return;
    }
#endif
    oit_write((start + left - 1u - oit_pool.y) * uint(OIT_WORDS), f);
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
