// For: oit_buffers.h
// Many iterations of equation 8 at once, along rows or along columns: the binomial weights of so many steps, over the
// fragments that up to seven links lead to. Where the surface ends the walk turns back, which is what leaving out a link's
// term does in each step. Rows after columns are not quite both at a time: the error is in docs/smart.md.
// A work item takes 32 pixels in turn and follows each chain of links through them once, with what lies around in
// registers: a link and a value are read for each fragment, however wide the weights. Links are mutual. OIT_STEP: x: 0
// rows, 1 columns; oit_set[0], oit_set[1]: weights of the fragment itself, of one link each way, ...
#define OIT_OWN_MAIN 1
const uint oit_reach = 32u, oit_wide = 7u;
uint oit_firsts[46], oit_counts[46]; // of the 32 pixels, and of seven on either side

// One link on from a fragment of a pixel, or turned where there is none.
struct oit_walker
{
    uint slot, place, direction;
};

uint oit_ahead()
{
    return 2u * OIT_STEP.x + 1u;
}

// False where the chain ends. Without a branch: some drivers go both ways.
bool oit_walk(inout oit_walker w)
{
    uint layer = oit_link(w.slot, w.direction), place = w.direction == oit_ahead() ? w.place + 1u : w.place - 1u;
    bool on = layer != OIT_NONE;
    w.direction = on ? w.direction : w.direction ^ 1u;
    w.place = on ? place : w.place;
    w.slot = on ? oit_firsts[w.place] + layer : w.slot;
    return on;
}

// What lies around the fragment that is written next, seven links each way, and the slots of those ahead.
float oit_around[15];
uint oit_slots[8];

void oit_take(uint slot)
{
    for (int k = 0; k < 14; ++k)
        oit_around[k] = oit_around[k + 1];
    for (int k = 0; k < 7; ++k)
        oit_slots[k] = oit_slots[k + 1];
    oit_around[14] = oit_before(slot);
    oit_slots[7] = slot;
}

float oit_weigh()
{
    float sum = oit_around[7] * oit_set[0].x;
    sum += (oit_around[6] + oit_around[8]) * oit_set[0].y;
    sum += (oit_around[5] + oit_around[9]) * oit_set[0].z;
    sum += (oit_around[4] + oit_around[10]) * oit_set[0].w;
    sum += (oit_around[3] + oit_around[11]) * oit_set[1].x;
    sum += (oit_around[2] + oit_around[12]) * oit_set[1].y;
    sum += (oit_around[1] + oit_around[13]) * oit_set[1].z;
    return sum + (oit_around[0] + oit_around[14]) * oit_set[1].w;
}

// From where the chain begins or comes into the stretch to where either ends: at most `left` fragments.
void oit_follow(uint slot, uint place, uint left)
{
    oit_walker w = oit_walker(slot, place, oit_ahead() ^ 1u);
    for (uint k = 0u; k < oit_wide; ++k) { // where the next eight push them to
        oit_walk(w);
        for (int i = 14; i > 8; --i)
            oit_around[i] = oit_around[i - 1];
        oit_around[8] = oit_before(w.slot);
    }
    w = oit_walker(slot, place, oit_ahead());
    oit_take(slot);
    for (uint k = 1u; left > 0u; ++k) {
        left = oit_walk(w) ? left : min(left, min(k, oit_wide));
        oit_take(w.slot);
        if (k >= oit_wide) {
            oit_set_after(oit_slots[0], oit_weigh());
            --left;
        }
    }
}

// On to where a chain begins or comes into the stretch, from the i-th of the pixel at `place` on. False: there is none.
bool oit_find(inout uint place, inout uint i, uint end)
{
    while (place < end) {
        bool there = i < oit_counts[place];
        if (there && (place == oit_wide || oit_link(oit_firsts[place] + i, oit_ahead() ^ 1u) == OIT_NONE))
            return true;
        i = there ? i + 1u : 0u;
        place = there ? place : place + 1u;
    }
    return false;
}

void main()
{
    oit_take_numbers();
    uvec2 size = uvec2(oit_area.zw), at = gl_GlobalInvocationID.xy;
    bool column = OIT_STEP.x != 0u;
    uvec2 start = column ? uvec2(at.x, at.y * oit_reach) : uvec2(at.y * oit_reach, at.x); // x is what is long
    if (any(greaterThanEqual(start, size)))
        return;
    uint p = start.y * size.x + start.x, stride = column ? size.x : 1u, from = column ? start.y : start.x;
    uint rest = (column ? size.y : size.x) - from, end = oit_wide + min(oit_reach, rest);
    for (uint k = oit_wide - min(oit_wide, from); k < oit_wide + min(oit_reach + oit_wide, rest); ++k)
        oit_counts[k] = oit_list(p + k * stride - oit_wide * stride, oit_firsts[k]);
    for (uint place = oit_wide, i = 0u; oit_find(place, i, end); ++i)
        oit_follow(oit_firsts[place] + i, place, end - place);
}
