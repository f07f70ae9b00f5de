// For: oit_buffers.h
// Counts to zero; with the first slab of a frame the totals too. Of the stores that keep the k nearest also the keys,
// limits and tails.
layout(local_size_x = 128) in;
layout(std430, binding = OIT_BINDING_PIXELS) writeonly buffer oit_pixels { uint oit_pixel[]; };

void main()
{
    uint block = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    uint first = block * OIT_BLOCK + gl_LocalInvocationID.x;
    for (uint i = 0u; i < 8u; ++i) {
        uint p = first + 128u * i;
        if (p >= oit_pool.x)
            continue;
#if OIT_STORE == OIT_LINKED
        oit_pixel[OIT_HEAD(p)] = 0u;
        if (OIT_AGAIN)
            continue;
#endif
        oit_pixel[OIT_WANTED(p)] = 0u;
#if OIT_HAS_COVERAGE
        oit_pixel[OIT_EDGE(p)] = 0u;
#endif
#if OIT_TAIL_WORDS == 6
        for (uint c = 0u; c < 6u; ++c)
            oit_pixel[OIT_TAIL(p) + c] = 0u;
#endif
    }
#if OIT_KEEPS
    uint each = OIT_LAYERS + 1u, end = min((block + 1u) * OIT_BLOCK, oit_pool.x) * each;
    for (uint i = block * OIT_BLOCK * each + gl_LocalInvocationID.x; i < end; i += 128u)
        oit_pixel[OIT_KEY(0u, i)] = OIT_NONE;
    for (uint i = 0u; i < 8u; ++i) {
        uint p = first + 128u * i;
        if (p >= oit_pool.x)
            break;
        oit_pixel[OIT_LIMIT(p)] = OIT_NONE;
    }
#endif
#if OIT_STORE == OIT_LINKED
    if (first == OIT_TAKEN)
        oit_pixel[first] = 0u;
    if (OIT_AGAIN)
        return;
#endif
    if (oit_step.x != 0u && first < OIT_HEADER)
        oit_pixel[first] = 0u;
}
