// For: oit_buffers.h
// OIT_STORE_FETCH: what has come of all layers, over the target.
#if OIT_MODE == OIT_MODE_DUAL
layout(location = 0, index = 0) out highp vec4 oit_out;
layout(location = 0, index = 1) out highp vec4 oit_keep;
#else
layout(location = 0) out highp vec4 oit_out;
#endif

void main()
{
    ivec2 where = ivec2(gl_FragCoord.xy) - oit_area.xy;
    uint p = uint(where.y) * uint(oit_area.z) + uint(where.x), at = OIT_LAID(p) + 5u;
    if (oit_pixel[OIT_LEFT(p)] == 0u)
        discard;
    vec3 sum = uintBitsToFloat(uvec3(oit_pixel[at], oit_pixel[at + 1u], oit_pixel[at + 2u]));
    vec3 through = uintBitsToFloat(uvec3(oit_pixel[at + 3u], oit_pixel[at + 4u], oit_pixel[at + 5u]));
#if OIT_MODE == OIT_MODE_DUAL
    oit_out = vec4(sum, 0.0);
    oit_keep = vec4(oit_light.w * through, 0.0);
#elif OIT_MODE == OIT_MODE_FILTER
    oit_out = vec4(oit_light.w * through, 0.0);
#elif OIT_MODE == OIT_MODE_LIGHT
    oit_out = vec4(sum, 0.0);
#else
    oit_out = vec4(sum, oit_light.w * through.r);
#endif
}
