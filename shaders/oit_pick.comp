// For: oit_buffers.h
// One fragment of one pixel, the one that `layer` others come before, with all its words; and how many there are.
layout(local_size_x = 128) in;
layout(std430, binding = OIT_BINDING_REPORT) buffer oit_picks { uint oit_pick[]; }; // x, y, layer; layers, found; record

void main()
{
    ivec2 where = ivec2(oit_pick[0], oit_pick[1]) - oit_area.xy;
    uint self = gl_LocalInvocationID.x, layer = oit_pick[2], base, n;
    bool fits = oit_find_run(uint(where.y) * uint(oit_area.z) + uint(where.x), base, n);
    bool found = fits && layer < n;
    if (self == 0u) {
        oit_pick[3] = n;
        oit_pick[4] = found ? 1u : 0u;
    }
    for (uint i = self; found && i < n; i += 128u) {
        uint at = base + i * uint(OIT_VECTORS), before = 0u;
        for (uint k = 0u; k < n; ++k)
            before += oit_after(at, base + k * uint(OIT_VECTORS)) ? 1u : 0u;
        for (uint k = 0u; before == layer && k < uint(OIT_VECTORS); ++k)
            for (int lane = 0; lane < OIT_LANES; ++lane)
                oit_pick[5u + k * uint(OIT_LANES) + uint(lane)] = oit_data[at + k][lane];
    }
}
