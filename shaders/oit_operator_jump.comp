// For: oit_buffers.h
// Distances carried 32 pixels along a row or a column in one pass, both ways: a work item takes 32 pixels in turn, and
// what lies beyond its ends as it was before the pass, so that the result depends on nothing but the values before
// (they go from oit_before to oit_set_after). Never less than the true distance: each is that of a path. OIT_STEP: x: 0
// rows, 1 columns; y: number of the pass; z: 1: until nothing changes.
#define OIT_OWN_MAIN 1
const uint oit_reach = 32u;

// In words 4 to 7 of the header, in turn, whether a pass has changed anything. Both passes before this one have not: all
// is as it will be, and the same in both places.
bool oit_is_stable()
{
    return OIT_STEP.z != 0u && oit_surface[4u + (OIT_STEP.y + 3u & 3u)] + oit_surface[4u + (OIT_STEP.y + 2u & 3u)] == 0u;
}

uint oit_nearer(uint own, uint other)
{
    bool kept = own == 0u || own == OIT_BLOCKED;
    return !kept && other < OIT_BLOCKED - 1u ? min(own, other + 1u) : own;
}

// All of pixel p toward which values come from `direction`; inside: they are of this pass.
bool oit_carry(uint p, uint direction, bool inside, bool again)
{
    uint first, n = oit_list(p, first), q, other;
    bool changed = false, beside = oit_beside(p, direction, q);
    if (beside)
        oit_list(q, other);
    for (uint i = 0u; i < n; ++i) {
        uint slot = first + i, layer = beside ? oit_link(slot, direction) : OIT_NONE;
        uint own = oit_surface[(again ? OIT_IN_AFTER : OIT_IN_BEFORE) + slot], word = own;
        if (layer != OIT_NONE) {
            uint come = oit_surface[(inside ? OIT_IN_AFTER : OIT_IN_BEFORE) + other + layer];
            word = oit_nearer(own & 65535u, come & 65535u) | oit_nearer(own >> 16u, come >> 16u) << 16u;
        }
        if (word != own || !again)
            oit_surface[OIT_IN_AFTER + slot] = word;
        changed = changed || word != own;
    }
    return changed;
}

void main()
{
    oit_take_numbers();
    uvec2 size = uvec2(oit_area.zw), at = gl_GlobalInvocationID.xy;
    bool column = OIT_STEP.x != 0u, changed = false;
    if (at == uvec2(0u))
        oit_surface[4u + (OIT_STEP.y + 1u & 3u)] = 0u;
    uvec2 start = column ? uvec2(at.x, at.y * oit_reach) : uvec2(at.y * oit_reach, at.x); // x is what is long
    if (any(greaterThanEqual(start, size)) || oit_is_stable())
        return;
    uint p = start.y * size.x + start.x, stride = column ? size.x : 1u;
    uint n = min(oit_reach, column ? size.y - start.y : size.x - start.x), back = column ? 2u : 0u;
    for (uint i = 0u; i < n; ++i)
        changed = oit_carry(p + i * stride, back, i > 0u, false) || changed;
    for (uint i = n; i > 0u; --i)
        changed = oit_carry(p + (i - 1u) * stride, back + 1u, i < n, true) || changed;
    if (changed)
        oit_surface[4u + (OIT_STEP.y & 3u)] = 1u;
}
