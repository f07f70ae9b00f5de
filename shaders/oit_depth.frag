// For: oit_buffers.h
// The depth of the composite: of the fragment with which the transmittance falls below oit_output.x. Where it never does,
// what the host has put there stays. Written as a depth and as a colour; masks say which of them is taken.
layout(location = 0) out highp vec4 oit_out;

void main()
{
#if OIT_HAS_COVERAGE
    if (OIT_OUTSIDE)
        discard;
#endif
    ivec2 where = ivec2(gl_FragCoord.xy) - oit_area.xy;
    uint base, n, at = OIT_NONE;
    if (!oit_find_run(uint(where.y) * uint(oit_area.z) + uint(where.x), base, n))
        discard;
    for (uint i = 0u; i < n; ++i) {
        at = oit_next(base, n, at);
        oit_lay(at);
#if OIT_HAS_BLEND
        float through = max(oit_through.r, max(oit_through.g, oit_through.b));
#else
        float through = oit_through;
#endif
        if (through < oit_output.x) {
#if OIT_REVERSED_Z
            float depth = uintBitsToFloat(0x7fffffffu - oit_record_depth(at));
#else
            float depth = uintBitsToFloat(oit_record_depth(at));
#endif
            gl_FragDepth = depth;
            oit_out = vec4(depth);
            return;
        }
    }
    discard;
}
