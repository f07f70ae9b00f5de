// For: oit_buffers.h
// The pixels' runs in the order of their slots over the target, each surface with the opacity that the operators made
// (Carnecky 2013, section 5.5, algorithm 3) and shaded by its curvature (Murray 2016, section 5.2). OIT_STEP: x: bits: 1:
// base, 2: beta and gamma, 4: shade, 8: algorithm 3 as printed, 16: contours; y, z: profiles of beta and gamma; oit_set[0]:
// their p; oit_set[2]: colour of contours.
// OIT_EXTRA_STEP and oit_set[7]: as oit_value says.
#if OIT_MODE == OIT_MODE_DUAL
layout(location = 0, index = 0) out highp vec4 oit_out;
layout(location = 0, index = 1) out highp vec4 oit_keep;
#else
layout(location = 0) out highp vec4 oit_out;
#endif
layout(location = 16) uniform highp vec4 oit_shades[32];
#if OIT_HAS_BLEND
#define OIT_THROUGH vec3
#else
#define OIT_THROUGH float
#endif
vec3 oit_sum = vec3(0.0);
OIT_THROUGH oit_through = OIT_THROUGH(1.0);
uint oit_here = 0u; // the pixel

bool oit_visible()
{
#if OIT_HAS_BLEND
    return max(oit_through.r, max(oit_through.g, oit_through.b)) > 5.9604645e-8;
#else
    return oit_through > 5.9604645e-8;
#endif
}

// e^x - 1, whose difference loses its digits near 0.
float oit_expm1(float x)
{
    return abs(x) < 0.01 ? x * (1.0 + x * (0.5 + x * (1.0 / 6.0 + x * (1.0 / 24.0)))) : exp(x) - 1.0;
}

// Equations 10 and 11. 1 - (1 - u)^2 is u (2 - u): nothing cancels, and p = 0 is the limit.
float oit_profile(uint kind, float u, float p)
{
    if (kind == 0u || u <= 0.0 || u >= 1.0)
        return clamp(u, 0.0, 1.0);
    if (kind == 2u)
        return p > 0.0 ? pow(u, p) : 1.0;
    float v = u * (2.0 - u);
    return p > 1.0e-6 ? exp(p * (v - 1.0)) * oit_expm1(-p * v) / oit_expm1(-p) : v;
}

float oit_halo(uint slot)
{
    return oit_profile(OIT_STEP.z, oit_value(OIT_GAMMA, slot), oit_set[0].y);
}

float oit_outline(uint slot)
{
    return oit_profile(OIT_STEP.y, oit_value(OIT_BETA, slot), oit_set[0].x);
}

vec3 oit_shade(float kappa)
{
    float at = clamp(0.5 * kappa + 0.5, 0.0, 1.0) * 31.0;
    uint cell = min(uint(at), 30u);
    return mix(oit_shades[cell].rgb, oit_shades[cell + 1u].rgb, at - float(cell));
}

// rgb not multiplied by alpha, and the fragment's opacity.
vec4 oit_surface_color(uint slot, vec4 color)
{
    uint what = OIT_STEP.x;
    if ((what & 1u) != 0u)
        color.a = oit_value(OIT_BASE, slot);
    float line = 0.0;
#if OIT_CONTOURS
    if ((what & 16u) != 0u)
        line = oit_contour(oit_here, slot);
    color.a += (1.0 - color.a) * line;
#endif
    if ((what & 2u) != 0u)
        color.a = (1.0 - oit_halo(slot)) * (color.a + (1.0 - color.a) * oit_outline(slot));
    if ((what & 4u) != 0u)
        color.rgb *= oit_shade(oit_value(OIT_KAPPA, slot));
    color.rgb = mix(color.rgb, oit_set[2].rgb, line);
    return color;
}

void oit_lay(uint slot)
{
    uint at = oit_record(slot), blend = oit_record_blend(at);
    vec4 color = oit_record_color(at);
    float printed = color.a;
#if OIT_PREMULTIPLIED
    color.rgb = color.a > 0.0 ? color.rgb / color.a : vec3(0.0);
#endif
    if (blend == 0u) {
        color = oit_surface_color(slot, color);
        printed = (OIT_STEP.x & 8u) != 0u && (OIT_STEP.x & 1u) != 0u ? oit_value(OIT_BASE, slot) : color.a;
    }
    vec3 light = color.a * color.rgb;
#if OIT_HAS_BLEND
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
    oit_through *= 1.0 - printed;
}

#if OIT_KEEPS
// Behind what is kept, all that is not.
void oit_lay_tail(uint p)
{
    if (oit_pixel[OIT_LIMIT(p)] == OIT_NONE)
        return;
    vec4 tail = oit_tail_light(oit_tail_sums(p));
    oit_sum += oit_through * tail.rgb;
    oit_through *= tail.a;
}
#endif

void main()
{
    ivec2 where = ivec2(gl_FragCoord.xy) - oit_area.xy;
    uint p = uint(where.y) * uint(oit_area.z) + uint(where.x), first, n = oit_list(p, first);
    if (n == 0u)
        discard;
    oit_here = p;
    for (uint i = 0u; i < n && oit_visible(); ++i)
        oit_lay(first + i);
#if OIT_KEEPS
    oit_lay_tail(p);
#endif
#if OIT_MODE == OIT_MODE_DUAL
    oit_out = vec4(oit_sum, 0.0);
    oit_keep = vec4(oit_light.w * oit_through, 0.0);
#elif OIT_MODE == OIT_MODE_FILTER
    oit_out = vec4(oit_light.w * oit_through, 0.0);
#elif OIT_MODE == OIT_MODE_LIGHT
    oit_out = vec4(oit_sum, 0.0);
#else
    oit_out = vec4(oit_sum, oit_light.w * oit_through);
#endif
}
