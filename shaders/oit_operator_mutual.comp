// For: oit_buffers.h
// What is not chosen by what it has chosen is no neighbour (Carnecky 2013, figure 7b). In place: a link that another
// invocation has taken away meanwhile was not to this fragment, or would have stayed.
void oit_operate(uint p)
{
    uint first, n = oit_list(p, first), firsts[4];
    bool wide = OIT_IN_FAR_LINKS != 0u;
    for (uint d = 0u; d < 4u; ++d) {
        uint q;
        firsts[d] = 0u;
        if (oit_beside(p, d, q))
            oit_list(q, firsts[d]);
    }
    for (uint i = 0u; i < n; ++i) {
        uvec2 none = uvec2(0u); // of the two words, or all in the first
        for (uint d = 0u; d < 4u; ++d) {
            uint layer = oit_link(first + i, d);
            bool lost = layer != OIT_NONE && oit_link(firsts[d] + layer, d ^ 1u) != i;
            none[wide ? d >> 1u : 0u] |= lost ? (wide ? 65535u << 16u * (d & 1u) : 255u << 8u * d) : 0u;
        }
        if (none.x != 0u)
            oit_surface[OIT_IN_LINKS + first + i] |= none.x;
        if (none.y != 0u)
            oit_surface[OIT_IN_FAR_LINKS + first + i] |= none.y;
    }
}
