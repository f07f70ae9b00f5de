// For: oit_buffers.h
// What is not chosen by what it has chosen is no neighbour (Carnecky 2013, figure 7b). In place: a link that another
// invocation has taken away meanwhile was not to this fragment, or would have stayed.
void oit_operate(uint p)
{
    uint first, n = oit_list(p, first), q, other;
    for (uint direction = 0u; direction < 4u; ++direction) {
        if (!oit_beside(p, direction, q))
            continue;
        oit_list(q, other);
        bool wide = OIT_IN_FAR_LINKS != 0u;
        uint none = wide ? 65535u << (16u * (direction & 1u)) : 255u << (8u * direction);
        uint at = wide && direction >= 2u ? OIT_IN_FAR_LINKS : OIT_IN_LINKS;
        for (uint i = 0u; i < n; ++i) {
            uint layer = oit_link(first + i, direction);
            if (layer != OIT_NONE && oit_link(other + layer, direction ^ 1u) != i)
                oit_surface[at + first + i] |= none;
        }
    }
}
