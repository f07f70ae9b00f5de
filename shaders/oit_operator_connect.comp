// For: oit_buffers.h
// What each surface fragment likes best of the pixels beside its own (Carnecky 2013, section 4.4, equations 1 to 3; Murray
// 2016, section 5.1). Whether that is mutual is seen in a pass after this, when all have chosen.
// OIT_STEP: x, y: directions from x to y - 1; z: criterion; w: bits of OIT_CHOOSE_*.
#define OIT_BY_DEPTH 0u
#define OIT_BY_UV 1u
#define OIT_PUBLISHED 2u
#define OIT_MURRAY 3u
#define OIT_CHOOSE_WINDOWED 1u
#define OIT_CHOOSE_COUNTS 2u
#define OIT_CHOOSE_GROUPED 4u
#define OIT_DEPTH_WEIGHT oit_set[0].x
#define OIT_NORMAL_WEIGHT oit_set[0].y
#define OIT_PER_RADIUS oit_set[0].z
#define OIT_LIMIT_APART oit_set[0].w
#define OIT_NEVER uintBitsToFloat(0x7f800000u) // infinity
uint oit_pairs = 0u;

struct oit_side // of a pair: the one that looks
{
    float depth, predicted; // window depth, and distance along the view that its slope makes for the pixel beside
    float ahead;            // what the slope adds to the depth on the way there
    uint direction;
    vec3 normal;
    vec2 uv;
    uint part;
};

float oit_ahead(uint at, uint direction)
{
    vec2 slope = unpackHalf2x16(OIT_WORD(at, OIT_AT_SLOPE)) * (1.0 / 4096.0);
    float ahead = direction < 2u ? slope.x : slope.y;
    return (direction & 1u) != 0u ? ahead : -ahead;
}

oit_side oit_look(uint slot, uint direction)
{
    uint at = oit_record(slot);
    oit_side side;
    side.depth = oit_record_window_depth(at);
    side.direction = direction;
    side.ahead = oit_ahead(at, direction);
    side.predicted = oit_distance(side.depth + side.ahead);
    side.normal = oit_record_normal(at);
    side.part = OIT_WORD(at, OIT_AT_PART);
    side.uv = vec2(0.0);
#if OIT_HAS_UV
    side.uv = oit_uv(slot);
#endif
    return side;
}

// How far apart in depth, in radii.
float oit_apart(oit_side side, uint at)
{
    return abs(side.predicted - oit_distance(oit_record_window_depth(at))) * OIT_PER_RADIUS;
}

// Two units of rounding may leave the product of unit vectors above 1; bends that are not negative are what the window
// stops by.
float oit_bend(oit_side side, uint at)
{
    return max(1.0 - dot(side.normal, oit_record_normal(at)), 0.0);
}

bool oit_may_join(oit_side side, uint at)
{
    ++oit_pairs;
    return OIT_WORD(at, OIT_AT_PART) == side.part && oit_record_blend(at) == 0u;
}

// Within the limit of what its slope predicts, or where a surface is found whose slope changes steadily from the one's to
// the other's: between what the two slopes say. So a surface holds together where it is seen at a grazing angle, and
// beyond the limit nothing is glued to what lies behind it and slopes alike.
bool oit_is_continuous(oit_side side, uint at, float apart)
{
    if (apart <= OIT_LIMIT_APART)
        return true;
    float rise = oit_record_window_depth(at) - side.depth;
    return (rise > side.ahead) != (rise > oit_ahead(at, side.direction));
}

float oit_measure_by_depth(oit_side side, uint at, float apart)
{
    return oit_is_continuous(side, at, apart) ? OIT_DEPTH_WEIGHT * apart + OIT_NORMAL_WEIGHT * oit_bend(side, at)
                                              : OIT_NEVER;
}

float oit_measure(oit_side side, uint slot)
{
    uint at = oit_record(slot);
    if (!oit_may_join(side, at))
        return OIT_NEVER;
#if OIT_HAS_UV
    if (OIT_STEP.z == OIT_BY_UV) {
        float apart = distance(side.uv, oit_uv(slot));
        return apart <= OIT_LIMIT_APART ? apart : OIT_NEVER;
    }
#endif
    if (OIT_STEP.z == OIT_MURRAY) {
        float gap = side.depth - oit_record_window_depth(at);
        return oit_bend(side, at) + gap * gap;
    }
    return oit_measure_by_depth(side, at, oit_apart(side, at));
}

// All of the list; of several that measure the same the nearest to the eye.
uint oit_best_of_all(oit_side side, uint first, uint n, out float least)
{
    uint best = OIT_NONE;
    least = OIT_NEVER;
    for (uint i = 0u; i < n; ++i) {
        float measure = oit_measure(side, first + i);
        best = measure < least ? i : best;
        least = measure < least ? measure : least;
    }
    return best;
}

// The same for a list that is grouped by part: only that part is looked at (Murray 2016, section 5.1).
uint oit_best_of_part(oit_side side, uint first, uint n, out float least)
{
    uint best = OIT_NONE, low = 0u;
    for (uint high = n; low < high;) { // where its group begins
        uint middle = (low + high) / 2u;
        if (oit_part_of(first + oit_surface[OIT_IN_GROUPED + first + middle]) < side.part)
            low = middle + 1u;
        else
            high = middle;
    }
    least = OIT_NEVER;
    for (; low < n; ++low) {
        uint i = oit_surface[OIT_IN_GROUPED + first + low];
        if (oit_part_of(first + i) != side.part)
            break;
        float measure = oit_measure(side, first + i);
        best = measure < least ? i : best;
        least = measure < least ? measure : least;
    }
    return best;
}

float oit_gap(oit_side side, uint first, uint n, uint i)
{
    return i < n ? oit_apart(side, oit_record(first + i)) : OIT_NEVER;
}

// In the order of the slots; oit_set[1].y is -1 where the eye looks along +z, whose distances fall from the eye on.
bool oit_comes_before(uint slot, oit_side side)
{
    return oit_distance(oit_depth(slot)) * oit_set[1].y < side.predicted * oit_set[1].y;
}

// The same, from the predicted depth outward on both sides, the nearer gap first, until the gap alone weighs more than the
// best so far. `from` is where the search of the fragment before began; surfaces mostly keep their order, so that the
// place is near.
uint oit_best_within(oit_side side, uint first, uint n, inout uint from)
{
    while (from < n && oit_comes_before(first + from, side))
        ++from;
    while (from > 0u && !oit_comes_before(first + from - 1u, side))
        --from;
    uint before = from - 1u, behind = from, best = OIT_NONE; // before: beyond n when it has passed 0
    float gap_before = oit_gap(side, first, n, before), gap_behind = oit_gap(side, first, n, behind), least = OIT_NEVER;
    for (;;) {
        bool back = gap_before < gap_behind;
        float gap = back ? gap_before : gap_behind;
        if (OIT_DEPTH_WEIGHT * gap > least || (back ? before : behind) >= n)
            return best;
        uint i = back ? before : behind, at = oit_record(first + i);
        float measure = oit_may_join(side, at) ? oit_measure_by_depth(side, at, gap) : OIT_NEVER;
        if (measure < least || (measure == least && best != OIT_NONE && i < best)) {
            least = measure;
            best = i;
        }
        if (back)
            gap_before = oit_gap(side, first, n, --before);
        else
            gap_behind = oit_gap(side, first, n, ++behind);
    }
}

// Algorithm 2, lines 12 to 17: none of the list to which i belongs may measure less toward the same candidate.
bool oit_published_holds(uint first, uint n, uint i, uint candidate, uint direction, float least)
{
    for (uint k = 0u; k < n; ++k)
        if (k != i && oit_is_surface(first + k) && oit_measure(oit_look(first + k, direction), candidate) < least)
            return false;
    return true;
}

void oit_set_link(uint slot, uint direction, uint layer)
{
    bool wide = OIT_IN_FAR_LINKS != 0u;
    uint bits = wide ? 16u : 8u, none = (1u << bits) - 1u, shift = bits * (wide ? direction & 1u : direction);
    uint at = (wide && direction >= 2u ? OIT_IN_FAR_LINKS : OIT_IN_LINKS) + slot;
    oit_surface[at] = (oit_surface[at] & ~(none << shift)) | min(layer, none) << shift;
}

uint oit_choose(uint first, uint n, uint i, uint direction, uint other, uint m, inout uint from)
{
    float least;
    oit_side side = oit_look(first + i, direction);
    if ((OIT_STEP.w & OIT_CHOOSE_WINDOWED) != 0u)
        return oit_best_within(side, other, m, from);
    uint best = (OIT_STEP.w & OIT_CHOOSE_GROUPED) != 0u ? oit_best_of_part(side, other, m, least)
                                                        : oit_best_of_all(side, other, m, least);
    if (OIT_STEP.z == OIT_PUBLISHED && best != OIT_NONE && oit_set[1].x == 0.0 &&
        !oit_published_holds(first, n, i, other + best, direction, least))
        best = OIT_NONE;
    return best;
}

void oit_operate(uint p)
{
    uint first, n = oit_list(p, first), q, other;
    for (uint direction = OIT_STEP.x; direction < OIT_STEP.y; ++direction) {
        uint m = oit_beside(p, direction, q) ? oit_list(q, other) : 0u, from = 0u;
        for (uint i = 0u; i < n; ++i) {
            uint best = OIT_NONE;
            if (m > 0u && oit_is_surface(first + i))
                best = oit_choose(first, n, i, direction, other, m, from);
            oit_set_link(first + i, direction, best);
        }
    }
    if ((OIT_STEP.w & OIT_CHOOSE_COUNTS) != 0u)
        atomicAdd(oit_surface[0], oit_pairs);
}
