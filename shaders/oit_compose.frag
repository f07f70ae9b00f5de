// For: oit_buffers.h
// The pixels whose runs have more than OIT_ABOVE and at most OIT_CLASS records, composed over the target; with OIT_DEEP
// all that have more, OIT_CLASS records at a time.
#if OIT_MODE == OIT_MODE_DUAL
layout(location = 0, index = 0) out highp vec4 oit_out;
layout(location = 0, index = 1) out highp vec4 oit_keep;
#else
layout(location = 0) out highp vec4 oit_out;
#endif

// Lays the first m of oit_order. With ties, all records of that depth are laid when the first of them is met; beyond
// the last of a block there may be more of its depth.
void oit_lay_sorted(uint base, uint n, uint m, bool tie, inout uint grouped)
{
    for (uint i = 0u; i < m && oit_visible(); ++i) {
        uint at = oit_order[i];
        bool alone = true;
        uint depth = 0u;
        if (tie) {
            depth = oit_word[at];
            if (depth == grouped)
                continue;
            alone = i + 1u < m ? oit_word[oit_order[i + 1u]] != depth : OIT_DEEP == 0;
        }
        if (alone) {
            oit_lay(at);
        } else {
            oit_lay_group(base, n, depth);
            grouped = depth;
        }
    }
}

void oit_lay_run(uint base, uint n)
{
    uint grouped = OIT_NONE;
#if OIT_DEEP
    uint depth = 0u, at = 0u;
    for (uint done = 0u; done < n && oit_visible(); done += uint(OIT_CLASS)) {
        oit_select(base, n, done > 0u, depth, at);
        oit_lay_sorted(base, n, min(uint(OIT_CLASS), n - done), true, grouped);
    }
#elif OIT_CLASS == 1
    oit_lay(base);
#else
    bool tie = oit_sort(base, n);
    oit_lay_sorted(base, n, n, tie, grouped);
#endif
}

void main()
{
    ivec2 where = ivec2(gl_FragCoord.xy) - oit_area.xy;
    uint p = uint(where.y) * uint(oit_area.z) + uint(where.x);
    uint start = oit_pixel[OIT_START(p)], end = oit_pixel[OIT_START(p + 1u)];
#if OIT_ASYNC
    if (end > oit_pool.z)
        discard;
#endif
    // Fragments that were counted and did not come have left the first places empty.
    start += uint(max(int(oit_pixel[OIT_LEFT(p)]), 0));
    uint n = end - start;
    if (n <= uint(OIT_ABOVE) || (OIT_DEEP == 0 && n > uint(OIT_CLASS)))
        discard;
    oit_lay_run((start - oit_pool.y) * uint(OIT_WORDS), n);
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
