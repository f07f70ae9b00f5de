// For: oit_buffers.h
// The pixels whose runs have at most OIT_CLASS records and are too deep for the program drawn before, composed over the target; with OIT_DEEP
// all that are deeper than the programs that were drawn before, OIT_CLASS records at a time.
#if OIT_MODE == OIT_MODE_DUAL
layout(location = 0, index = 0) out highp vec4 oit_out;
layout(location = 0, index = 1) out highp vec4 oit_keep;
#else
layout(location = 0) out highp vec4 oit_out;
#endif

#if OIT_DEEP
// Lays the first m of oit_order, which holds `known`. Of ties all records of that depth, be they in this block or not, are
// laid when the first of them is met.
void oit_lay_sorted(uint base, uint n, uint m, uint known, inout uint grouped)
{
    for (uint i = 0u; i < m && oit_visible(); ++i) {
        uint at = oit_order[i], depth = oit_record_depth(at);
        if (depth == grouped)
            continue;
        if (i + 1u >= known || oit_record_depth(oit_order[i + 1u]) != depth) {
            oit_lay(at);
        } else {
            oit_lay_group(base, n, depth);
            grouped = depth;
        }
    }
}

void oit_lay_run(uint base, uint n)
{
    uint depth = 0u, at = 0u, grouped = OIT_NONE;
    for (uint done = 0u; done < n && oit_visible(); done += uint(OIT_CLASS)) {
        // One more than are laid, to see whether it ties with the last of them.
        oit_select(base, n, done > 0u, depth, at);
        oit_lay_sorted(base, n, min(uint(OIT_CLASS), n - done), min(uint(OIT_CLASS + 1), n - done), grouped);
    }
}
#endif

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
    uint p = uint(where.y) * uint(oit_area.z) + uint(where.x);
#if OIT_HAS_COVERAGE // each sample by itself where they differ, the whole pixel where not
    if (OIT_OUTSIDE || (oit_pixel[OIT_EDGE(p)] != 0u) != (OIT_COVERED == OIT_BY_SAMPLE))
        discard;
#endif
    uint start = oit_pixel[OIT_START(p)], end = oit_pixel[OIT_START(p + 1u)];
#if OIT_ASYNC
    if (end > oit_pool.z)
        discard;
#endif
#if OIT_ASYNC && OIT_STORE == OIT_PREDICT
    if (int(oit_pixel[OIT_LEFT(p)]) < 0)
        discard;
#endif
    // Fragments that were counted and did not come have left the first places empty.
    start += uint(max(int(oit_pixel[OIT_LEFT(p)]), 0));
    uint n = end - start;
#if OIT_DEEP
    if (n <= oit_step.y)
        discard;
#else
    if (n <= oit_above[OIT_INDEX] || n > uint(OIT_CLASS))
        discard;
#endif
#if OIT_ADAPTIVE
    oit_count_layers((start - oit_pool.y) * uint(OIT_VECTORS), n);
#endif
    oit_lay_run((start - oit_pool.y) * uint(OIT_VECTORS), n);
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
