// For: oit_buffers.h
// Between the two geometry passes of the stores that keep the k nearest: what is kept of each pixel. With more than k
// fragments the limit is the greatest of its k + 1 smallest keys. Fewer than k + 1 lie below, and those that equal it,
// which do not all fit, go to the tail together: which ones are kept depends on the set of fragments alone.
layout(local_size_x = 128) in;
layout(std430, binding = OIT_BINDING_PIXELS) buffer oit_pixels { uint oit_pixel[]; };
shared uint oit_all[5];     // needed, deepest, lost pixels, lost fragments
shared uint oit_classes[4]; // pixels by how many fragments are kept

uint oit_kept(uint p, uint count)
{
    uint limit = OIT_NONE, kept = count;
    if (count > OIT_LAYERS) {
        limit = 0u;
        kept = 0u;
        for (uint i = 0u; i <= OIT_LAYERS; ++i)
            limit = max(limit, oit_pixel[OIT_KEY(p, i)]);
        for (uint i = 0u; i <= OIT_LAYERS; ++i)
            kept += oit_pixel[OIT_KEY(p, i)] < limit ? 1u : 0u;
    }
    oit_pixel[OIT_LIMIT(p)] = limit;
    return kept;
}

void oit_keep_nearest(uint p)
{
    uint count = oit_pixel[OIT_LEFT(p)];
    uint kept = oit_kept(p, count);
    oit_pixel[OIT_START(p)] = p * OIT_LAYERS;
    oit_pixel[OIT_LEFT(p)] = OIT_LAYERS;
    atomicAdd(oit_all[0], count);
    atomicMax(oit_all[1], count);
    atomicAdd(oit_all[2], kept < count ? 1u : 0u);
    atomicAdd(oit_all[3], count - kept);
    if (kept > 0u)
        atomicAdd(oit_classes[kept <= 8u ? 0u : min(uint(findMSB(kept - 1u)) - 2u, 3u)], 1u);
}

void main()
{
    uint block = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    uint self = gl_LocalInvocationID.x;
    if (self < 4u)
        oit_all[self] = oit_classes[self] = 0u;
    barrier();
    for (uint i = 0u; i < 8u; ++i) {
        uint p = block * OIT_BLOCK + 128u * i + self;
        if (p < oit_pool.x)
            oit_keep_nearest(p);
    }
    barrier();
    if (self < 4u && oit_classes[self] > 0u)
        atomicAdd(oit_pixel[OIT_PIXELS + self], oit_classes[self]);
    if (self == 0u && block == 0u)
        oit_pixel[OIT_START(oit_pool.x)] = oit_pool.x * OIT_LAYERS;
    if (self == 0u) {
        atomicAdd(oit_pixel[OIT_NEEDED], oit_all[0]);
        atomicMax(oit_pixel[OIT_DEEPEST], oit_all[1]);
        atomicAdd(oit_pixel[OIT_LOST_PIXELS], oit_all[2]);
        atomicAdd(oit_pixel[OIT_LOST], oit_all[3]);
    }
}
