// For: oit_buffers.h
// OIT_STORE_FETCH, after a geometry pass: the layers that it left, laid behind those of the passes before, and taken away for
// the next. With OIT_FIRST, before the first: nothing laid yet.
#if OIT_FIRST == 0
void oit_lay_next(uvec4 layer, inout uvec4 last, inout uint copies)
{
    if (layer.x == OIT_NONE)
        return;
    copies = layer == last ? copies + 1u : 1u;
    last = layer;
    oit_lay(layer, uvec4(0u));
}
#endif

void main()
{
    ivec2 where = ivec2(gl_FragCoord.xy) - oit_area.xy;
    uint p = uint(where.y) * uint(oit_area.z) + uint(where.x), at = OIT_LAID(p);
#if OIT_FIRST
    for (uint i = 0u; i < 8u; ++i)
        oit_pixel[at + i] = 0u;
    for (uint i = 8u; i < 11u; ++i)
        oit_pixel[at + i] = floatBitsToUint(1.0);
    if (p == 0u && oit_step.x != 0u)
        for (uint i = 0u; i < OIT_HEADER; ++i)
            oit_pixel[i] = 0u;
#else
    uvec4 last = uvec4(oit_pixel[at], oit_pixel[at + 1u], oit_pixel[at + 2u], oit_pixel[at + 3u]);
    uint copies = oit_pixel[at + 4u];
    if (copies == 0u)
        oit_pixel[OIT_LEFT(p)] = oit_seen.y;
    for (uint c = 0u; c < 3u; ++c)
        oit_sum[c] = uintBitsToFloat(oit_pixel[at + 5u + c]);
#if OIT_HAS_BLEND
    for (uint c = 0u; c < 3u; ++c)
        oit_through[c] = uintBitsToFloat(oit_pixel[at + 8u + c]);
#else
    oit_through = uintBitsToFloat(oit_pixel[at + 8u]);
#endif
#define OIT_LAY_NEXT(l) oit_lay_next(l, last, copies);
    OIT_EACH_LAYER(OIT_LAY_NEXT)
    for (uint c = 0u; c < 4u; ++c)
        oit_pixel[at + c] = last[c];
    oit_pixel[at + 4u] = copies;
    vec3 through = vec3(oit_through);
    for (uint c = 0u; c < 3u; ++c) {
        oit_pixel[at + 5u + c] = floatBitsToUint(oit_sum[c]);
        oit_pixel[at + 8u + c] = floatBitsToUint(through[c]);
    }
#endif
#define OIT_TAKE_AWAY(l) l = uvec4(OIT_NONE);
    OIT_EACH_LAYER(OIT_TAKE_AWAY)
    oit_seen = uvec2(0u);
}
