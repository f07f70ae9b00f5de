// For: oit_buffers.h
// Layers of each pixel by part, and by depth within a part (Murray 2016, section 4.1: buckets), for searches that look at
// one part alone.
void oit_operate(uint p)
{
    uint first, n = oit_list(p, first);
    for (uint i = 0u; i < n; ++i) {
        uint part = oit_part_of(first + i), before = 0u;
        for (uint k = 0u; k < n; ++k) {
            uint other = oit_part_of(first + k);
            before += other < part || (other == part && k < i) ? 1u : 0u;
        }
        oit_surface[OIT_IN_GROUPED + first + before] = i;
    }
}
