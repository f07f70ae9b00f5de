// For: oit_buffers.h
// A pixel's run in its order without a sort, for what looks at few of its records: picking, the depth of the composite.

// Where the run of pixel p lies, and how many records it has; false where it did not fit into the pool.
bool oit_find_run(uint p, out uint base, out uint n)
{
    uint start = oit_pixel[OIT_START(p)], end = oit_pixel[OIT_START(p + 1u)];
    bool fits = true;
#if OIT_ASYNC
    fits = end <= oit_pool.z;
#if OIT_STORE == OIT_PREDICT
    fits = fits && int(oit_pixel[OIT_LEFT(p)]) >= 0;
#endif
#endif
    // Fragments that were counted and did not come have left the first places empty.
    if (fits)
        start += uint(max(int(oit_pixel[OIT_LEFT(p)]), 0));
    n = end - start;
#if OIT_ASYNC && OIT_STORE == OIT_PREDICT // the run was as long as guessed
    n = fits ? n : oit_pixel[OIT_SEEN(p)];
#endif
    base = (start - oit_pool.y) * uint(OIT_VECTORS);
    return fits;
}

// The record that comes next after `last`, or the first one after OIT_NONE; OIT_NONE after the last.
uint oit_next(uint base, uint n, uint last)
{
    uint best = OIT_NONE, nearest = OIT_NONE;
    uint before = last == OIT_NONE ? 0u : oit_record_depth(last);
    for (uint i = 0u; i < n; ++i) {
        uint at = base + i * uint(OIT_VECTORS), depth = oit_record_depth(at);
        if (depth < before || depth > nearest)
            continue;
        if (last != OIT_NONE && depth == before && !oit_after(at, last))
            continue;
        if (best != OIT_NONE && depth == nearest && !oit_after(best, at))
            continue;
        best = at;
        nearest = depth;
    }
    return best;
}
