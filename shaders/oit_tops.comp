// For: oit_buffers.h
// The scan, second of three: sums of blocks become what lies before each block. One work group, whatever the size.
layout(local_size_x = 128) in;
layout(std430, binding = OIT_BINDING_PIXELS) buffer oit_pixels { uint oit_pixel[]; };

void main()
{
    uint self = gl_LocalInvocationID.x;
    uint each = (oit_pool.w + 127u) / 128u;
    uint first = min(self * each, oit_pool.w), end = min(first + each, oit_pool.w);
    uint sum = 0u;
    for (uint b = first; b < end; ++b)
        sum = oit_add(sum, oit_pixel[OIT_SUM(b)]);
    uint before = oit_scan(self, sum);
    for (uint b = first; b < end; ++b) {
        uint here = oit_pixel[OIT_SUM(b)];
        oit_pixel[OIT_SUM(b)] = before;
        before = oit_add(before, here);
    }
    if (self == 127u) {
        oit_pixel[OIT_START(oit_pool.x)] = oit_add(before, oit_all_lost(before));
        oit_pixel[OIT_TOTAL] = before;
        if (OIT_STORE != OIT_PREDICT || !OIT_DIRECT)
            oit_pixel[OIT_NEEDED] = max(oit_pixel[OIT_NEEDED], before);
    }
}
