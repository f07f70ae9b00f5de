// For: oit_buffers.h
// Distances carried 32 pixels along a row or a column in one pass, both ways: a work item takes a stretch of 32 pixels in
// turn, where they lie. Stretches side by side take turns, too: what lies beyond the ends of one does not change while it is
// read, so that the result depends on nothing but the values before. Never less than the true distance: each is that of a
// path. OIT_STEP: x: 0 rows, 1 columns; y: number of the pass: four are a round; z: 1: the second, fourth, ... stretches;
// w: where a word for each 32 x 32 pixels lies, one more than the last pass that changed something there; 0: none.
#define OIT_OWN_MAIN 1
const uint oit_reach = 32u;

uint oit_nearer(uint own, uint other)
{
    bool kept = own == 0u || own == OIT_BLOCKED;
    return !kept && other < OIT_BLOCKED - 1u ? min(own, other + 1u) : own;
}

// To pixel p from the one beside, of which these are the slots.
bool oit_carry(uint p, uint direction, inout uint other)
{
    uint first, n = oit_list(p, first);
    bool changed = false;
    for (uint i = 0u; i < n; ++i) {
        uint slot = first + i, layer = oit_link(slot, direction), own = oit_surface[OIT_IN_REACH + slot];
        uint come = layer == OIT_NONE ? own : oit_surface[OIT_IN_REACH + other + layer];
        uint word = oit_nearer(own & 65535u, come & 65535u) | oit_nearer(own >> 16u, come >> 16u) << 16u;
        if (word != own) {
            oit_surface[OIT_IN_REACH + slot] = word;
            changed = true;
        }
    }
    other = first;
    return changed;
}

// Whether nothing has changed here and on either side since the stretch was looked at last, a round ago.
bool oit_is_done(uint tile, uint step, bool low, bool high)
{
    if (OIT_STEP.w == 0u || OIT_STEP.y < 4u)
        return false;
    uint last = oit_surface[OIT_STEP.w + tile];
    last = max(last, low ? oit_surface[OIT_STEP.w + tile - step] : 0u);
    last = max(last, high ? oit_surface[OIT_STEP.w + tile + step] : 0u);
    return last + 3u <= OIT_STEP.y;
}

void main()
{
    oit_take_numbers();
    uvec2 size = uvec2(oit_area.zw), tiles = (size + oit_reach - 1u) / oit_reach;
    uvec2 at = uvec2(gl_GlobalInvocationID.x, 2u * gl_GlobalInvocationID.y + OIT_STEP.z); // x across, y along
    bool column = OIT_STEP.x != 0u, changed = false;
    uvec2 start = column ? uvec2(at.x, at.y * oit_reach) : uvec2(at.y * oit_reach, at.x), tile = start / oit_reach;
    if (any(greaterThanEqual(start, size)))
        return;
    uint p = start.y * size.x + start.x, stride = column ? size.x : 1u, back = column ? OIT_DOWNWARD : OIT_LEFTWARD;
    uint rest = column ? size.y - start.y : size.x - start.x, n = min(oit_reach, rest), own = tile.y * tiles.x + tile.x, other;
    if (oit_is_done(own, column ? tiles.x : 1u, at.y > 0u, rest > n))
        return;
    oit_list(at.y > 0u ? p - stride : p, other);
    for (uint i = 0u; i < n; ++i)
        changed = oit_carry(p + i * stride, back, other) || changed;
    oit_list(rest > n ? p + n * stride : p, other);
    for (uint i = n; i > 0u; --i)
        changed = oit_carry(p + (i - 1u) * stride, back + 1u, other) || changed;
    if (changed && OIT_STEP.w != 0u)
        oit_surface[OIT_STEP.w + own] = OIT_STEP.y + 1u;
}
