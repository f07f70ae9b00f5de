// For: oit_buffers.h
// What each surface fragment likes best of the pixels beside its own by predicted depth and normal, as oit_operator_connect
// finds it, without looking at all of them: runs are sorted, and distance ascends with depth. From the predicted depth
// outward on both sides, the nearer gap first, until the gap alone weighs more than the best so far. After
// oit_operator_pairs.glsl. oit_set[1].y: -1 where the eye looks along +z, whose distances fall from the eye on.
// Loops end where their conditions stand: a driver that masks lanes goes round once more for a condition at the top.

// The run of a pixel beside, at the place where the predicted depth belongs: the two records around it. Surfaces mostly
// keep their order, so that the next fragment's place is near.
struct oit_window
{
    uint first, count, from; // from: of the one behind
    uint before, behind;     // records
    float low, high;         // their distances, ascending from the eye on
};

float oit_ascending(uint at)
{
    return oit_distance(oit_record_window_depth(at)) * oit_set[1].y;
}

oit_window oit_open(uint p, uint direction)
{
    uint q;
    oit_window w = oit_window(0u, 0u, 0u, 0u, 0u, -OIT_NEVER, OIT_NEVER);
    if (oit_beside(p, direction, q))
        w.count = oit_list(q, w.first);
    if (w.count > 0u) {
        w.behind = oit_record(w.first);
        w.high = oit_ascending(w.behind);
    }
    return w;
}

// On to where what is before comes before `place`, and what is behind does not.
void oit_move(inout oit_window w, float place)
{
    bool on;
    do {
        bool up = w.from < w.count && w.high < place, down = w.from > 0u && !up && !(w.low < place);
        w.from += up ? 1u : down ? 0xffffffffu : 0u;
        uint index = up ? w.from : w.from - 1u, at = 0u;
        float distance = up ? OIT_NEVER : -OIT_NEVER;
        if ((up || down) && index < w.count) {
            at = oit_record(w.first + index);
            distance = oit_ascending(at);
        }
        if (up) {
            w.before = w.behind;
            w.low = w.high;
            w.behind = at;
            w.high = distance;
        } else if (down) {
            w.behind = w.before;
            w.high = w.low;
            w.before = at;
            w.low = distance;
        }
        on = up ? w.from < w.count && w.high < place : down && w.from > 0u && !(w.low < place);
    } while (on);
}

uint oit_choose(oit_side side, uint direction, inout oit_window w)
{
    side = oit_toward(side, direction);
    float place = side.predicted * oit_set[1].y, least = OIT_NEVER;
    oit_move(w, place);
    uint before = w.from - 1u, behind = w.from, best = OIT_NONE; // before: beyond the run when it has passed 0
    uint at_before = w.before, at_behind = w.behind;
    float gap_before = abs(place - w.low) * OIT_PER_RADIUS, gap_behind = abs(place - w.high) * OIT_PER_RADIUS;
    gap_before = before < w.count ? gap_before : OIT_NEVER;
    gap_behind = behind < w.count ? gap_behind : OIT_NEVER;
    bool on;
    do {
        bool back = gap_before < gap_behind;
        float gap = back ? gap_before : gap_behind;
        uint i = back ? before : behind, at = back ? at_before : at_behind, next = back ? i - 1u : i + 1u;
        on = !(OIT_DEPTH_WEIGHT * gap > least) && i < w.count;
        if (on) {
            float measure = oit_may_join(side, at) ? oit_measure_by_depth(side, at, gap) : OIT_NEVER;
            bool better = measure < least || (measure == least && best != OIT_NONE && i < best);
            least = better ? measure : least;
            best = better ? i : best;
            gap = OIT_NEVER;
            if (next < w.count) {
                at = oit_record(w.first + next);
                gap = abs(place - oit_ascending(at)) * OIT_PER_RADIUS;
            }
            before = back ? next : before;
            behind = back ? behind : next;
            at_before = back ? at : at_before;
            at_behind = back ? at_behind : at;
            gap_before = back ? gap : gap_before;
            gap_behind = back ? gap_behind : gap;
            on = !(OIT_DEPTH_WEIGHT * min(gap_before, gap_behind) > least);
        }
    } while (on);
    return best;
}

void oit_set_links(uint slot, uvec4 layers)
{
    bool wide = OIT_IN_FAR_LINKS != 0u;
    layers = min(layers, uvec4(wide ? 65535u : 255u));
    uvec2 pairs = layers.xz | layers.yw << (wide ? 16u : 8u);
    oit_surface[OIT_IN_LINKS + slot] = wide ? pairs.x : pairs.x | pairs.y << 16u;
    if (wide)
        oit_surface[OIT_IN_FAR_LINKS + slot] = pairs.y;
}

void oit_operate(uint p)
{
    uint first, n = oit_list(p, first);
    oit_window left = oit_open(p, OIT_LEFTWARD), right = oit_open(p, OIT_RIGHTWARD);
    oit_window down = oit_open(p, OIT_DOWNWARD), up = oit_open(p, OIT_UPWARD);
    for (uint i = 0u; i < n; ++i) {
        oit_side side = oit_look(first + i);
        uvec4 layers;
        layers.x = oit_choose(side, OIT_LEFTWARD, left);
        layers.y = oit_choose(side, OIT_RIGHTWARD, right);
        layers.z = oit_choose(side, OIT_DOWNWARD, down);
        layers.w = oit_choose(side, OIT_UPWARD, up);
        oit_set_links(first + i, oit_is_surface(first + i) ? layers : uvec4(OIT_NONE));
    }
    if ((OIT_STEP.w & OIT_CHOOSE_COUNTS) != 0u)
        atomicAdd(oit_surface[0], oit_pairs);
}
