// For: oit_buffers.h
// OIT_STORE_LINKED, after the fill: the list of each pixel copied into a run of its own (Carnecky 2013, section 4.3, which
// sorts as it copies; ours are sorted where they are composed). Where the list was too small, into the pixel's tail.
layout(local_size_x = 128) in;
layout(std430, binding = OIT_BINDING_FRAGMENTS) writeonly buffer oit_runs { OIT_VECTOR oit_run[]; };

// Without the link, which differs from frame to frame, so that only the fragment's own words are ever compared.
void oit_copy(uint from, uint to)
{
    for (uint i = 0u; i < uint(OIT_VECTORS); ++i) {
        OIT_VECTOR words = oit_data[from + i];
        if (i == uint(OIT_AT_LINK / OIT_LANES))
            words[OIT_AT_LINK % OIT_LANES] = 0u;
        oit_run[to + i] = words;
    }
}

void oit_gather(uint p)
{
    uint end = oit_pixel[OIT_START(p + 1u)], n = end - oit_pixel[OIT_START(p)], found = 0u;
    bool lost = OIT_ASYNC == 1 && end > oit_pool.z;
    for (uint link = oit_pixel[OIT_HEAD(p)]; link != 0u && found < n; ++found) {
        uint at = (link - 1u) * uint(OIT_VECTORS);
#if OIT_ASYNC
        if (lost)
            oit_add_to_tail(p, oit_record_amounts(at));
#endif
        if (!lost)
            oit_copy(at, (end - 1u - found - oit_pool.y) * uint(OIT_VECTORS));
        link = OIT_WORD(at, OIT_AT_LINK);
    }
    if (!lost)
        oit_pixel[OIT_LEFT(p)] = n - found;
}

void main()
{
    uint block = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    uint first = block * OIT_BLOCK + gl_LocalInvocationID.x;
    for (uint i = 0u; i < 8u; ++i)
        if (first + 128u * i < oit_pool.x)
            oit_gather(first + 128u * i);
}
