// For: oit_buffers.h
// The totals into a buffer of their own, which the CPU reads when its fence has passed.
layout(local_size_x = 1) in;
layout(std430, binding = OIT_BINDING_PIXELS) readonly buffer oit_pixels { uint oit_pixel[]; };
layout(std430, binding = OIT_BINDING_REPORT) writeonly buffer oit_report { uint oit_total[]; };

void main()
{
    for (uint i = 0u; i < 16u; ++i)
        oit_total[i] = oit_pixel[i];
}
