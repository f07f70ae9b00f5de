// For: oit_buffers.h
// The scan, third of three: where the run of each pixel starts. A run that ends beyond the pool does not fit; since starts
// ascend, that follows from its end alone and needs no mark.
layout(local_size_x = 128) in;
layout(std430, binding = OIT_BINDING_PIXELS) buffer oit_pixels { uint oit_pixel[]; };

void oit_lose(uint p, uint count)
{
    oit_pixel[OIT_LEFT(p)] = count | OIT_UNFIT;
#if OIT_STORE != OIT_PREDICT // where it is known when all have come
    atomicAdd(oit_pixel[OIT_LOST_PIXELS], 1u);
    atomicAdd(oit_pixel[OIT_LOST], count);
#endif
#if OIT_STORE == OIT_EXACT
    for (uint c = 0u; c < 4u; ++c)
        oit_pixel[OIT_TAIL(p) + c] = 0u;
#endif
}

void main()
{
    uint block = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    uint first = block * OIT_BLOCK + 8u * gl_LocalInvocationID.x;
    uint sum = 0u;
    for (uint p = first; p < first + 8u; ++p)
        sum = oit_add(sum, p < oit_pool.x ? oit_pixel[OIT_WANTED(p)] : 0u);
    uint before = oit_scan(gl_LocalInvocationID.x, sum);
    before = oit_add(before, block < oit_pool.w ? oit_pixel[OIT_SUM(block)] : 0u);
    before = oit_add(before, oit_all_lost(oit_pixel[OIT_TOTAL]));
    for (uint p = first; p < first + 8u && p < oit_pool.x; ++p) {
        uint count = oit_pixel[OIT_WANTED(p)];
        oit_pixel[OIT_START(p)] = before;
#if OIT_STORE == OIT_PREDICT
        oit_pixel[OIT_LEFT(p)] = count;
#endif
        before = oit_add(before, count);
#if OIT_ASYNC
        if (before > oit_pool.z && count > 0u)
            oit_lose(p, count);
#endif
    }
}
