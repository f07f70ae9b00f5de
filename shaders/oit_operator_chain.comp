// For: oit_buffers.h
// Many iterations of equation 8 at once, along rows or along columns: the binomial weights of so many steps, over the
// fragments that up to 15 links lead to. Where the surface ends the walk turns back, which is what leaving out a link's
// term does in each step. Rows after columns are not quite both at a time: the error is in docs/smart.md. OIT_STEP: x: 0
// rows, 1 columns; y: links to follow; oit_set[0 ... 3]: weights of the fragment itself, of one link each way, ...
float oit_weight(uint k)
{
    return oit_set[k >> 2u][k & 3u];
}

float oit_walk(uint p, uint slot, uint direction)
{
    float sum = 0.0;
    for (uint k = 1u; k <= OIT_STEP.y; ++k) {
        uint next = oit_neighbour(p, slot, direction);
        if (next == OIT_NONE) {
            direction ^= 1u;
        } else {
            slot = next;
            oit_beside(p, direction, p);
        }
        sum += oit_weight(k) * oit_before(slot);
    }
    return sum;
}

void oit_operate(uint p)
{
    uint first, n = oit_list(p, first);
    for (uint i = 0u; i < n; ++i)
        oit_set_after(first + i, oit_weight(0u) * oit_before(first + i) + oit_walk(p, first + i, 2u * OIT_STEP.x) +
                                     oit_walk(p, first + i, 2u * OIT_STEP.x + 1u));
}
