// For: oit_buffers.h
// Boundary conditions of beta and gamma (Carnecky 2013, section 5.3): a missing neighbour (red) makes beta 1, being
// underneath (green) keeps it 0, being before (blue) makes gamma 1. By layer indices, surfaces only, and without the
// differences that linked surfaces make which merely change places: what is left is surfaces that begin on the way to the
// neighbour less those that end on it. OIT_STEP: x: 1: plain indices (published); y: 1: nothing is kept at 0, since equation
// 9 as published has no b; equation 8 has; z: as OIT_STEP.w of jumps.

// Of those before `layer` in the list: how many are surfaces without a link that way; or, published, how many surfaces.
// Kept from one call to the next, since layers mostly ascend.
struct oit_ends
{
    uint layer, count;
};

uint oit_is_end(uint slot, uint direction)
{
    if (!oit_is_surface(slot))
        return 0u;
    return OIT_STEP.x != 0u || oit_link(slot, direction) == OIT_NONE ? 1u : 0u;
}

uint oit_ends_before(inout oit_ends ends, uint first, uint layer, uint direction)
{
    for (; ends.layer < layer; ++ends.layer)
        ends.count += oit_is_end(first + ends.layer, direction);
    for (; ends.layer > layer; --ends.layer)
        ends.count -= oit_is_end(first + ends.layer - 1u, direction);
    return ends.count;
}

// Bits by fragment: 1: a link is missing, 2: an index falls, 4: one rises. Collected in the word of the reach.
void oit_bound_along(uint p, uint first, uint n, uint direction)
{
    uint q, other;
    if (!oit_beside(p, direction, q))
        return;
    oit_list(q, other);
    oit_ends there = oit_ends(0u, 0u);
    uint here = 0u;
    for (uint i = 0u; i < n; ++i) {
        uint layer = oit_link(first + i, direction), bits = 1u;
        if (layer != OIT_NONE) {
            uint ends = oit_ends_before(there, other, layer, direction ^ 1u);
            bits = ends > here ? 4u : ends < here ? 2u : 0u;
        }
        here += oit_is_end(first + i, direction);
        oit_surface[OIT_IN_REACH + first + i] |= bits;
    }
}

void oit_operate(uint p)
{
    uint first, n = oit_list(p, first);
    for (uint i = 0u; i < n; ++i)
        oit_surface[OIT_IN_REACH + first + i] = 0u;
    for (uint direction = 0u; direction < 4u; ++direction)
        oit_bound_along(p, first, n, direction);
    for (uint i = 0u; i < n; ++i) {
        uint slot = first + i, bits = oit_is_surface(slot) ? oit_surface[OIT_IN_REACH + slot] : 0u;
        bool missing = (bits & 1u) != 0u, under = (bits & 2u) != 0u && OIT_STEP.y == 0u, before = (bits & 4u) != 0u;
        oit_surface[OIT_IN_REACH + slot] =
            (missing ? 0u : under ? OIT_BLOCKED : OIT_UNREACHED) | (before ? 0u : OIT_UNREACHED) << 16u;
        if (OIT_IN_BETA != 0u)
            oit_surface[OIT_IN_BETA + slot] = floatBitsToUint(missing ? 1.0 : 0.0);
        if (OIT_IN_GAMMA != 0u)
            oit_surface[OIT_IN_GAMMA + slot] = floatBitsToUint(before ? 1.0 : 0.0);
    }
    uvec2 at = uvec2(p % uint(oit_area.z), p / uint(oit_area.z));
    if (OIT_STEP.z != 0u && all(equal(at & 31u, uvec2(0u)))) // no pass of jumps has changed anything there
        oit_surface[OIT_STEP.z + at.y / 32u * ((uint(oit_area.z) + 31u) / 32u) + at.x / 32u] = 0u;
}
