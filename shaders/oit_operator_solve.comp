// For: oit_buffers.h
// One iteration: equation 8 of one field, and equation 9 of beta and gamma (Carnecky 2013, section 5.4), as distances in
// steps to the nearest source. Distances are relaxed where they lie: one that is read while it changes is still that of a
// path, and after n iterations all of up to n are right; greater ones are cut when they are used. OIT_STEP: x: 1: equation
// 9; y: 1: equation 8, from oit_before to oit_set_after; z: whose boundary is kept there: 1 beta, 2 gamma, 0 none;
// oit_set[0].x: lambda times the weight of the sum.
uint oit_nearer(uint distance, uint other)
{
    return other < OIT_BLOCKED - 1u ? min(distance, other + 1u) : distance;
}

bool oit_is_kept(uint steps)
{
    return steps == 0u || steps == OIT_BLOCKED;
}

void oit_relax(uint slot, uint others[4])
{
    uint word = oit_surface[OIT_IN_REACH + slot], low = word & 65535u, high = word >> 16u, beta = low, gamma = high;
    for (uint d = 0u; d < 4u; ++d)
        if (others[d] != OIT_NONE) {
            uint other = oit_surface[OIT_IN_REACH + others[d]];
            beta = oit_nearer(beta, other & 65535u);
            gamma = oit_nearer(gamma, other >> 16u);
        }
    beta = oit_is_kept(low) ? low : beta;
    gamma = oit_is_kept(high) ? high : gamma;
    if (beta != low || gamma != high)
        oit_surface[OIT_IN_REACH + slot] = beta | gamma << 16u;
}

void oit_diffuse(uint slot, uint others[4])
{
    float value = oit_before(slot), sum = 0.0;
    for (uint d = 0u; d < 4u; ++d)
        if (others[d] != OIT_NONE)
            sum += oit_before(others[d]) - value;
    if (OIT_STEP.z != 0u && oit_is_kept(oit_steps(slot, OIT_STEP.z == 2u)))
        sum = 0.0;
    oit_set_after(slot, value + oit_set[0].x * sum);
}

void oit_operate(uint p)
{
    uint first, n = oit_list(p, first), firsts[4];
    if (n == 0u)
        return;
    for (uint d = 0u; d < 4u; ++d) {
        uint q;
        if (oit_beside(p, d, q))
            oit_list(q, firsts[d]);
    }
    for (uint i = 0u; i < n; ++i) {
        uint others[4];
        for (uint d = 0u; d < 4u; ++d) {
            uint layer = oit_link(first + i, d);
            others[d] = layer == OIT_NONE ? OIT_NONE : firsts[d] + layer;
        }
        if (OIT_STEP.x != 0u)
            oit_relax(first + i, others);
        if (OIT_STEP.y != 0u)
            oit_diffuse(first + i, others);
    }
}
