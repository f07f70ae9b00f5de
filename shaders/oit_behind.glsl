// For: oit_buffers.h
// The tail read back: the sums of oit_to_tail, and what layers that are mixed evenly look like.
#ifndef OIT_CLASS // not after oit_record.glsl
layout(std430, binding = OIT_BINDING_PIXELS) readonly buffer oit_pixels { uint oit_pixel[]; };
#endif

#if OIT_TAIL_WORDS == 6
vec4 oit_tail_sums(uint p)
{
    uint at = OIT_TAIL(p);
    uvec4 low = uvec4(oit_pixel[at], oit_pixel[at + 1u], oit_pixel[at + 2u], oit_pixel[at + 3u]);
    uvec4 carries = uvec4(oit_pixel[at + 4u], oit_pixel[at + 4u] >> 16u, oit_pixel[at + 5u], oit_pixel[at + 5u] >> 16u);
    return vec4(low) * (1.0 / 67108864.0) + vec4(carries & 0xffffu) * 64.0;
}
#else
vec4 oit_tail_sums(uint p, uint count)
{
    uint at = OIT_TAIL(p);
    float unit = exp2(float(findMSB(count) - 25));
    return vec4(oit_pixel[at], oit_pixel[at + 1u], oit_pixel[at + 2u], oit_pixel[at + 3u]) * unit;
}
#endif

// rgb: the light that comes of them; a: how much is seen through them.
vec4 oit_tail_light(vec4 sums)
{
    float thickness = sums.a, through = exp(-thickness);
    // (1 - e^-t) / t, whose quotient loses its digits near 0.
    return vec4(sums.rgb * (thickness > 1.0e-3 ? (1.0 - through) / thickness : 1.0 - 0.5 * thickness), through);
}
