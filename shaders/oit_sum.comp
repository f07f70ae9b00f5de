// For: oit_buffers.h
// The scan, first of three: the fragments of each block, those of the deepest pixel, and how deep the pixels are.
layout(local_size_x = 128) in;
layout(std430, binding = OIT_BINDING_PIXELS) buffer oit_pixels { uint oit_pixel[]; };
shared uint oit_sums[128];
shared uint oit_most[128];
shared uint oit_classes[4];

void main()
{
    uint block = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    uint self = gl_LocalInvocationID.x;
    uint sum = 0u, most = 0u;
    if (self < 4u)
        oit_classes[self] = 0u;
    barrier();
    for (uint i = 0u; i < 8u; ++i) {
        uint p = block * OIT_BLOCK + 128u * i + self;
        uint count = p < oit_pool.x ? oit_pixel[OIT_WANTED(p)] : 0u;
        sum = oit_add(sum, count);
        most = max(most, count);
#if OIT_STORE == OIT_FETCH && OIT_ASYNC // layers beyond the passes that the frame has
        if (count > oit_step.w * uint(OIT_FETCHED)) {
            atomicAdd(oit_pixel[OIT_LOST_PIXELS], 1u);
            atomicAdd(oit_pixel[OIT_LOST], count - oit_step.w * uint(OIT_FETCHED));
        }
#endif
        if (count > 0u)
            atomicAdd(oit_classes[oit_class(count)], 1u);
    }
    oit_sums[self] = sum;
    oit_most[self] = most;
    barrier();
    for (uint half_size = 64u; half_size > 0u; half_size >>= 1u) {
        if (self < half_size) {
            oit_sums[self] = oit_add(oit_sums[self], oit_sums[self + half_size]);
            oit_most[self] = max(oit_most[self], oit_most[self + half_size]);
        }
        barrier();
    }
    bool known = OIT_STORE != OIT_PREDICT || !OIT_DIRECT; // what is only guessed is not reported
    if (known && self < 4u && oit_classes[self] > 0u)
        atomicAdd(oit_pixel[OIT_PIXELS + self], oit_classes[self]);
    if (self == 0u && block < oit_pool.w) {
        oit_pixel[OIT_SUM(block)] = oit_sums[0];
        if (known)
            atomicMax(oit_pixel[OIT_DEEPEST], oit_most[0]);
    }
}
