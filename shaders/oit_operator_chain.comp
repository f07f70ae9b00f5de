// For: oit_buffers.h
// Many iterations of equation 8 at once, along rows or along columns: the binomial weights of so many steps, over the
// fragments that up to 15 links lead to. Where the surface ends the walk turns back, which is what leaving out a link's
// term does in each step. Rows after columns are not quite both at a time: the error is in docs/smart.md. OIT_STEP: x: 0
// rows, 1 columns; y: links to follow; oit_set[0 ... 3]: weights of the fragment itself, of one link each way, ...
uint oit_firsts[31]; // slots of the pixels around, the own one in the middle

float oit_weight(uint k)
{
    return oit_set[k >> 2u][k & 3u];
}

float oit_walk(uint slot, uint direction)
{
    float sum = 0.0;
    uint place = 15u;
    for (uint k = 1u; k <= OIT_STEP.y; ++k) {
        uint layer = oit_link(slot, direction);
        if (layer == OIT_NONE) {
            direction ^= 1u;
        } else {
            place = (direction & 1u) != 0u ? place + 1u : place - 1u;
            slot = oit_firsts[place] + layer;
        }
        sum += oit_weight(k) * oit_before(slot);
    }
    return sum;
}

void oit_operate(uint p)
{
    uint first, n = oit_list(p, first), width = uint(oit_area.z), reach = OIT_STEP.y;
    if (n == 0u)
        return;
    bool column = OIT_STEP.x != 0u;
    uint stride = column ? width : 1u, at = column ? p / width : p % width, end = uint(column ? oit_area.w : oit_area.z);
    for (uint k = 15u - min(at, reach); k <= 15u + min(reach, end - 1u - at); ++k)
        oit_list(p + k * stride - 15u * stride, oit_firsts[k]);
    for (uint i = 0u; i < n; ++i)
        oit_set_after(first + i, oit_weight(0u) * oit_before(first + i) + oit_walk(first + i, 2u * OIT_STEP.x) +
                                     oit_walk(first + i, 2u * OIT_STEP.x + 1u));
}
