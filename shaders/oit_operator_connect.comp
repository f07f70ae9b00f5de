// For: oit_buffers.h
// What each surface fragment likes best of the pixels beside its own (Carnecky 2013, section 4.4, equations 1 to 3; Murray
// 2016, section 5.1), found by looking at all of them. Whether that is mutual is seen in a pass after this, when all have
// chosen. After oit_operator_pairs.glsl. OIT_STEP: x: direction; z: criterion.
#define OIT_BY_DEPTH 0u
#define OIT_BY_UV 1u
#define OIT_PUBLISHED 2u
#define OIT_MURRAY 3u

oit_side oit_look_toward(uint slot, uint direction)
{
    return oit_toward(oit_look(slot), direction);
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

// Algorithm 2, lines 12 to 17: none of the list to which i belongs may measure less toward the same candidate.
bool oit_published_holds(uint first, uint n, uint i, uint candidate, uint direction, float least)
{
    for (uint k = 0u; k < n; ++k)
        if (k != i && oit_is_surface(first + k) && oit_measure(oit_look_toward(first + k, direction), candidate) < least)
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

uint oit_choose(uint first, uint n, uint i, uint direction, uint other, uint m)
{
    float least;
    oit_side side = oit_look_toward(first + i, direction);
    uint best = (OIT_STEP.w & OIT_CHOOSE_GROUPED) != 0u ? oit_best_of_part(side, other, m, least)
                                                        : oit_best_of_all(side, other, m, least);
    if (OIT_STEP.z == OIT_PUBLISHED && best != OIT_NONE && oit_set[1].x == 0.0 &&
        !oit_published_holds(first, n, i, other + best, direction, least))
        best = OIT_NONE;
    return best;
}

void oit_operate(uint p)
{
    uint direction = OIT_STEP.x, first, n = oit_list(p, first), q, other;
    uint m = oit_beside(p, direction, q) ? oit_list(q, other) : 0u;
    for (uint i = 0u; i < n; ++i) {
        uint best = OIT_NONE;
        if (m > 0u && oit_is_surface(first + i))
            best = oit_choose(first, n, i, direction, other, m);
        oit_set_link(first + i, direction, best);
    }
    if ((OIT_STEP.w & OIT_CHOOSE_COUNTS) != 0u)
        atomicAdd(oit_surface[0], oit_pairs);
}
