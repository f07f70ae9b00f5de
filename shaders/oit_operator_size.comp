// For: oit_buffers.h
// How far it is along the surface to the next fragment with a boundary condition, on either side along its row or its
// column: the width of what lies between two silhouettes or halos. Each pass carries that 32 pixels; what has not come is
// not known (65535), at the frame of the picture never. OIT_STEP: x: 0 rows, 1 columns; y: 1: the first of its axis.
#define OIT_OWN_MAIN 1
const uint oit_reach = 32u;

bool oit_is_wall(uint slot)
{
    uint low = oit_steps(slot, false);
    return low == 0u || low == OIT_BLOCKED || oit_steps(slot, true) == 0u;
}

// Toward which it is known from the pixel beside: `direction`. The half of the word that it has.
void oit_carry(uint p, uint direction, uint section)
{
    uint first, n = oit_list(p, first), q, other, shift = 16u * (direction & 1u);
    bool beside = oit_beside(p, direction, q);
    if (beside)
        oit_list(q, other);
    for (uint i = 0u; i < n; ++i) {
        uint slot = first + i, layer = beside ? oit_link(slot, direction) : OIT_NONE, distance = OIT_UNREACHED;
        if (oit_is_wall(slot)) {
            distance = 0u;
        } else if (layer != OIT_NONE) {
            uint come = oit_surface[section + other + layer] >> shift & 65535u;
            distance = come < OIT_BLOCKED ? come + 1u : OIT_UNREACHED;
        }
        uint word = oit_surface[section + slot];
        oit_surface[section + slot] = (word & ~(65535u << shift)) | distance << shift;
    }
}

void oit_forget(uint p, uint section)
{
    uint first, n = oit_list(p, first);
    for (uint i = 0u; i < n; ++i)
        oit_surface[section + first + i] = 0xffffffffu;
}

void main()
{
    oit_take_numbers();
    uvec2 size = uvec2(oit_area.zw), at = gl_GlobalInvocationID.xy;
    bool column = OIT_STEP.x != 0u;
    uvec2 start = column ? uvec2(at.x, at.y * oit_reach) : uvec2(at.y * oit_reach, at.x); // x is what is long
    if (any(greaterThanEqual(start, size)))
        return;
    uint p = start.y * size.x + start.x, stride = column ? size.x : 1u, section = column ? OIT_EXTRA_STEP.z : OIT_IN_SIZES;
    uint n = min(oit_reach, column ? size.y - start.y : size.x - start.x), back = column ? 2u : 0u;
    for (uint i = 0u; i < n && OIT_STEP.y != 0u; ++i)
        oit_forget(p + i * stride, section);
    for (uint i = 0u; i < n && OIT_STEP.y == 0u; ++i)
        oit_carry(p + i * stride, back, section);
    for (uint i = n; i > 0u && OIT_STEP.y == 0u; --i)
        oit_carry(p + (i - 1u) * stride, back + 1u, section);
}
