// For: oit_buffers.h
// The pixels whose runs did not fit, from the sums of oit_to_tail: layers of mean colour, as thick as all together.
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
#if OIT_KEEPS
    // Where some fragments are kept, the tail is laid behind them with the run.
    start += uint(max(int(oit_pixel[OIT_LEFT(p)]), 0));
    if (end != start || oit_pixel[OIT_LIMIT(p)] == OIT_NONE)
        discard;
    vec4 sums = oit_tail_sums(p);
#elif OIT_STORE == OIT_PREDICT
    int left = OIT_TRUE_LEFT(oit_pixel[OIT_LEFT(p)]);
    if ((end <= oit_pool.z && left >= 0) || int(end - start) == left)
        discard;
    vec4 sums = oit_tail_sums(p);
#else
    if (end <= oit_pool.z || end == start)
        discard;
#if OIT_TAIL_WORDS == 6
    vec4 sums = oit_tail_sums(p);
#else
    vec4 sums = oit_tail_sums(p, end - start);
#endif
#endif
    vec4 tail = oit_tail_light(sums);
    vec3 sum = tail.rgb;
    float through = tail.a;
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
