// For: oit_buffers.h
// Counts to zero; with the first slab of a frame the totals too.
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
#if OIT_STORE != OIT_EXACT && OIT_ASYNC
        for (uint c = 0u; c < uint(OIT_TAIL_WORDS); ++c)
            oit_pixel[OIT_TAIL(p) + c] = 0u;
#endif
    }
    if (oit_step.x != 0u && first < OIT_HEADER && !OIT_AGAIN)
        oit_pixel[first] = 0u;
    if (first == OIT_TAKEN)
        oit_pixel[first] = 0u;
}
