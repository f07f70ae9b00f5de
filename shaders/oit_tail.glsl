// For: oit_buffers.h
// The pixel buffer, and what a fragment adds to the tail: sums that do not depend on the order, in integers so that rounding
// does not either. The layers of a pixel are taken as mixed evenly: optical depths add, colours are weighted by them.
#if OIT_KEEPS && OIT_PASS == OIT_COUNT
layout(std430, binding = OIT_BINDING_PIXELS) coherent buffer oit_pixels { uint oit_pixel[]; };
#else
layout(std430, binding = OIT_BINDING_PIXELS) buffer oit_pixels { uint oit_pixel[]; };
#endif

#if OIT_ASYNC || OIT_KEEPS
// Light and optical depth of one fragment: colours up to 4 and optical depths up to 11 make less than 64 each. By one chain of
// roundings, whichever shader asks.
vec4 oit_tail_amounts(vec4 color, uint blend, uint covered)
{
#if OIT_HAS_COVERAGE // the tail knows no samples: a fragment is as much thinner as it covers less of the pixel
    color *= vec4(vec3(OIT_PREMULTIPLIED == 1 ? OIT_SHARE(covered) : 1.0), OIT_SHARE(covered));
#endif
    OIT_PRECISE float thickness = min(-log(1.0 - min(color.a, 0.999999)), 11.0);
    vec3 c = clamp(color.rgb, 0.0, 4.0);
#if OIT_PREMULTIPLIED
    c = color.a > 0.0 ? min(c / color.a, vec3(4.0)) : c;
    float weight = color.a > 0.0 ? thickness : 1.0;
#else
    float weight = thickness;
#endif
#if OIT_HAS_BLEND
    if (blend == 1u) { // add
        c = clamp(color.rgb, 0.0, 4.0); // premultiplied light needs no alpha
        weight = OIT_PREMULTIPLIED == 1 ? 1.0 : color.a;
        thickness = 0.0;
    } else if (blend == 2u) { // multiply
        OIT_PRECISE float keep = 1.0 - color.a * (1.0 - min((c.r + c.g + c.b) / 3.0, 1.0));
        thickness = min(-log(max(keep, 1.0e-6)), 11.0);
        weight = 0.0;
    }
#endif
    OIT_PRECISE vec3 light = c * weight;
    return vec4(light, thickness);
}

#if OIT_TAIL_WORDS == 6
// Where the count is not known before. In units of 2^-26, with 16 more bits by carries: how many there are follows from the
// sum alone. A fragment makes less than one, so that 65,535 fragments do not overflow.
void oit_add_to_tail(uint p, vec4 amounts)
{
    uvec4 parts = uvec4(amounts * 67108864.0 + 0.5);
    for (uint c = 0u; c < 4u; ++c) {
        uint before = atomicAdd(oit_pixel[OIT_TAIL(p) + c], parts[c]);
        if (before > 0xffffffffu - parts[c])
            atomicAdd(oit_pixel[OIT_TAIL(p) + 4u + (c >> 1u)], 1u << (16u * (c & 1u)));
    }
}
#endif
#endif
