// For: oit_buffers.h
// OIT_STORE_PREDICT, after the fill: how many fragments came to each pixel, what the frame was like, and which pixels got
// more than their runs hold. What such a pixel has stored goes to its tail, where the rest is already: so it does not show
// which came first.
layout(local_size_x = 128) in;
shared uint oit_totals[OIT_HEADER];

void oit_settle(uint p, inout uint deepest)
{
    uint start = oit_pixel[OIT_START(p)], end = oit_pixel[OIT_START(p + 1u)];
    int left = OIT_TRUE_LEFT(oit_pixel[OIT_LEFT(p)]);
    uint seen = end - start - uint(left);
    oit_pixel[OIT_SEEN(p)] = seen;
    if (seen == 0u)
        return;
    if (OIT_DIRECT) {
        deepest = max(deepest, seen);
        atomicAdd(oit_totals[OIT_NEEDED], seen);
        atomicAdd(oit_totals[OIT_PIXELS + oit_class(seen)], 1u);
    } else if (OIT_ASYNC == 0) { // counted: nothing is lost, and what is too much was not stored
        atomicAdd(oit_totals[OIT_EXTRA], uint(max(-left, 0)));
        return;
    }
    if (left >= 0 && end <= oit_pool.z)
        return;
    atomicAdd(oit_totals[OIT_LOST_PIXELS], 1u);
    atomicAdd(oit_totals[OIT_LOST], seen);
#if OIT_ASYNC
    for (uint i = start; i < end && end <= oit_pool.z; ++i)
        oit_add_to_tail(p, oit_record_amounts(i * uint(OIT_VECTORS)));
#endif
}

void main()
{
    uint block = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    uint self = gl_LocalInvocationID.x, deepest = 0u;
    if (self < OIT_HEADER)
        oit_totals[self] = 0u;
    barrier();
    for (uint i = 0u; i < 8u; ++i) {
        uint p = block * OIT_BLOCK + 128u * i + self;
        if (p < oit_pool.x)
            oit_settle(p, deepest);
    }
    atomicMax(oit_totals[OIT_DEEPEST], deepest);
    barrier();
    if (self == OIT_DEEPEST)
        atomicMax(oit_pixel[OIT_DEEPEST], oit_totals[OIT_DEEPEST]);
    else if (self < OIT_HEADER && oit_totals[self] > 0u)
        atomicAdd(oit_pixel[self], oit_totals[self]);
}
