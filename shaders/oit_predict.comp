// For: oit_buffers.h
// OIT_STORE_PREDICT: how long the run of each pixel shall be: the most that it or a neighbour had in the frame before, and
// some headroom; or, where the frame is filled again, what it had. Clears totals, and the sums of pixels that were lost.
layout(local_size_x = 128) in;
layout(std430, binding = OIT_BINDING_PIXELS) buffer oit_pixels { uint oit_pixel[]; };

uint oit_most_around(uint p)
{
    ivec2 size = oit_area.zw, at = ivec2(int(p) % size.x, int(p) / size.x);
    ivec2 low = max(at - 1, ivec2(0)), high = min(at + 1, size - 1);
    uint most = 0u;
    for (int y = low.y; y <= high.y; ++y)
        for (int x = low.x; x <= high.x; ++x)
            most = max(most, oit_pixel[OIT_SEEN(uint(y * size.x + x))]);
    // Sixteenths, rounded up.
    return most + (most >> 4u) * uint(OIT_HEADROOM) + (((most & 15u) * uint(OIT_HEADROOM) + 15u) >> 4u);
}

void main()
{
    uint block = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    uint first = block * OIT_BLOCK + gl_LocalInvocationID.x;
    for (uint i = 0u; i < 8u; ++i) {
        uint p = first + 128u * i;
        if (p >= oit_pool.x)
            continue;
#if OIT_HAS_COVERAGE
        oit_pixel[OIT_EDGE(p)] = 0u;
#endif
#if OIT_ASYNC
        if (oit_pixel[OIT_LEFT(p)] >= OIT_UNFIT >> 1u) // less than none left, or unfit
            for (uint c = 0u; c < uint(OIT_TAIL_WORDS); ++c)
                oit_pixel[OIT_TAIL(p) + c] = 0u;
#endif
        oit_pixel[OIT_WANTED(p)] = OIT_DIRECT ? oit_most_around(p) : oit_pixel[OIT_SEEN(p)];
    }
    if (first < OIT_HEADER)
        oit_pixel[first] = 0u;
}
