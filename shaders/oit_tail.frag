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
    ivec2 where = ivec2(gl_FragCoord.xy) - oit_area.xy;
    uint p = uint(where.y) * uint(oit_area.z) + uint(where.x);
    uint start = oit_pixel[OIT_START(p)], end = oit_pixel[OIT_START(p + 1u)];
#if OIT_STORE == OIT_PREDICT
    int left = OIT_TRUE_LEFT(oit_pixel[OIT_LEFT(p)]);
    if ((end <= oit_pool.z && left >= 0) || int(end - start) == left)
        discard;
#else
    if (end <= oit_pool.z || end == start)
        discard;
#endif
    uint at = OIT_TAIL(p);
    vec4 sums = vec4(uvec4(oit_pixel[at], oit_pixel[at + 1u], oit_pixel[at + 2u], oit_pixel[at + 3u]));
#if OIT_TAIL_WORDS == 6
    uvec2 carries = uvec2(oit_pixel[at + 4u], oit_pixel[at + 5u]);
    sums = sums * exp2(-24.0) + 256.0 * vec4(uvec4(carries.x & 0xffffu, carries.x >> 16u, carries.y & 0xffffu, carries.y >> 16u));
#else
    sums *= exp2(float(findMSB(end - start) - 25));
#endif
    vec3 light = sums.rgb;
    float thickness = sums.a;
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
