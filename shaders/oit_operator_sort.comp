// For: oit_buffers.h
// The order of each pixel's run, before the first operator: a fragment's slot is how many come before it. Eight at a time
// are counted while the depths of the run pass by once: no array, no dependence from one step to the next.

// Of records of one depth as they are composed.
uint oit_before_ties(uint base, uint n, uint i)
{
    uint at = base + i * uint(OIT_VECTORS), before = 0u;
    for (uint k = 0u; k < n; ++k) {
        uint other = base + k * uint(OIT_VECTORS);
        if (k != i && oit_record_depth(other) == oit_record_depth(at) && oit_after(at, other))
            ++before;
    }
    return before;
}

void oit_operate(uint p)
{
    if (p == 0u)
        oit_surface[0] = 0u; // pairs compared since
    uint first, n = oit_list(p, first), base = first * uint(OIT_VECTORS);
    for (uint i = 0u; i < n; i += 8u) {
        uint own[8], before[8], alike[8];
        for (uint k = 0u; k < 8u; ++k) {
            own[k] = i + k < n ? oit_record_depth(base + (i + k) * uint(OIT_VECTORS)) : OIT_NONE;
            before[k] = alike[k] = 0u;
        }
        for (uint k = 0u; k < n; ++k) {
            uint depth = oit_record_depth(base + k * uint(OIT_VECTORS));
            for (uint j = 0u; j < 8u; ++j) {
                before[j] += depth < own[j] ? 1u : 0u;
                alike[j] += depth == own[j] ? 1u : 0u;
            }
        }
        for (uint k = 0u; k < 8u && i + k < n; ++k) {
            uint place = before[k];
            if (alike[k] > 1u)
                place += oit_before_ties(base, n, i + k);
            oit_surface[OIT_IN_ORDER + first + place] = first + i + k;
        }
    }
}
