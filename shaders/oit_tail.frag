// For: oit_buffers.h
// The pixels whose runs did not fit, from the sums of oit_to_tail: layers of mean colour, as thick as all together.
layout(std430, binding = OIT_BINDING_PIXELS) readonly buffer oit_pixels { uint oit_pixel[]; };
#if OIT_MODE == OIT_MODE_DUAL
layout(location = 0, index = 0) out highp vec4 oit_out;
layout(location = 0, index = 1) out highp vec4 oit_keep;
#else
layout(location = 0) out highp vec4 oit_out;
#endif

void main()
{
#if OIT_HAS_COVERAGE
    if (OIT_OUTSIDE)
        discard;
#endif
    ivec2 where = ivec2(gl_FragCoord.xy) - oit_area.xy;
    uint p = uint(where.y) * uint(oit_area.z) + uint(where.x);
    uint start = oit_pixel[OIT_START(p)], end = oit_pixel[OIT_START(p + 1u)];
    if (end <= oit_pool.z || end == start)
        discard;
    float unit = exp2(float(findMSB(end - start) - 25));
    uint at = OIT_TAIL(p);
    vec3 light = vec3(uvec3(oit_pixel[at], oit_pixel[at + 1u], oit_pixel[at + 2u])) * unit;
    float thickness = float(oit_pixel[at + 3u]) * unit;
    float through = exp(-thickness);
    // (1 - e^-t) / t, whose quotient loses its digits near 0.
    vec3 sum = light * (thickness > 1.0e-3 ? (1.0 - through) / thickness : 1.0 - 0.5 * thickness);
#if OIT_MODE == OIT_MODE_DUAL
    oit_out = vec4(sum, 0.0);
    oit_keep = vec4(vec3(oit_light.w * through), 0.0);
#elif OIT_MODE == OIT_MODE_FILTER
    oit_out = vec4(vec3(oit_light.w * through), 0.0);
#elif OIT_MODE == OIT_MODE_LIGHT
    oit_out = vec4(sum, 0.0);
#else
    oit_out = vec4(sum, oit_light.w * through);
#endif
}
