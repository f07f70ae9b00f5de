// For: oit_buffers.h
// The tail read back: the sums of oit_add_to_tail or oit_to_tail, and what layers that are mixed evenly look like.
#ifndef OIT_CLASS // not after oit_record.glsl
layout(std430, binding = OIT_BINDING_PIXELS) readonly buffer oit_pixels { uint oit_pixel[]; };
#endif
#if OIT_TAIL_WORDS > 0

// count: of the fragments, which shares out the bits where there are four words.
vec4 oit_tail_sums(uint p, uint count)
{
    uint at = OIT_TAIL(p);
    vec4 sums = vec4(uvec4(oit_pixel[at], oit_pixel[at + 1u], oit_pixel[at + 2u], oit_pixel[at + 3u]));
#if OIT_TAIL_WORDS == 6
    uvec2 carries = uvec2(oit_pixel[at + 4u], oit_pixel[at + 5u]);
    uvec4 high = uvec4(carries.x & 0xffffu, carries.x >> 16u, carries.y & 0xffffu, carries.y >> 16u);
    return sums * exp2(-26.0) + 64.0 * vec4(high);
#else
    return sums * exp2(float(findMSB(count) - 25));
#endif
}

// rgb: the light that comes of them; a: how much is seen through them.
vec4 oit_tail_light(vec4 sums)
{
    float thickness = sums.a, through = exp(-thickness);
    // (1 - e^-t) / t, whose quotient loses its digits near 0.
    return vec4(sums.rgb * (thickness > 1.0e-3 ? (1.0 - through) / thickness : 1.0 - 0.5 * thickness), through);
}
#endif
