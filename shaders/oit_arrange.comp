// For: oit_buffers.h
// After the second geometry pass of the bucketed store (Murray 2016, section 4.1): the fragments of each pixel grouped by
// part, and by depth within a part (reordering of Z), and where each group lies (bucket creation). The places in Z are
// ordered, not the records, which stay where they are.
layout(local_size_x = 128) in;

// By part, then as composed.
bool oit_comes_after(uint a, uint b)
{
    uint x = OIT_WORD(a, OIT_AT_PART), y = OIT_WORD(b, OIT_AT_PART);
    return x != y ? x > y : oit_after(a, b);
}

uint oit_record_at(uint p, uint i)
{
    return oit_bucket_record(p, i) * uint(OIT_VECTORS);
}

// By insertion: few, and often nearly in order.
void oit_reorder(uint p, uint start, uint count)
{
    for (uint i = 0u; i < count; ++i) {
        uint place = start + i, to = i;
        for (; to > 0u && oit_comes_after(oit_record_at(p, to - 1u), place * uint(OIT_VECTORS)); --to)
            oit_pixel[OIT_KEY(p, to)] = oit_pixel[OIT_KEY(p, to - 1u)];
        oit_pixel[OIT_KEY(p, to)] = place;
    }
}

// The slot of a part is part mod k, or the next that is free. One is: there are k, and at most k parts.
void oit_insert_bucket(uint p, uint part, uint first, uint count)
{
    uint slot = part % OIT_LAYERS;
    while (oit_pixel[OIT_BUCKET(p, slot) + 1u] != 0u)
        slot = slot + 1u < OIT_LAYERS ? slot + 1u : 0u;
    oit_pixel[OIT_BUCKET(p, slot)] = part;
    oit_pixel[OIT_BUCKET(p, slot) + 1u] = first | count << 16u;
}

void oit_arrange(uint p)
{
    uint end = oit_pixel[OIT_START(p + 1u)];
    uint start = oit_pixel[OIT_START(p)] + uint(max(int(oit_pixel[OIT_LEFT(p)]), 0));
    uint count = end - start, first = 0u;
    oit_reorder(p, start, count);
    for (uint slot = 0u; slot < OIT_LAYERS; ++slot)
        oit_pixel[OIT_BUCKET(p, slot) + 1u] = 0u;
    for (uint i = 1u; i <= count; ++i) {
        uint part = OIT_WORD(oit_record_at(p, first), OIT_AT_PART);
        if (i < count && OIT_WORD(oit_record_at(p, i), OIT_AT_PART) == part)
            continue;
        oit_insert_bucket(p, part, first, i - first);
        first = i;
    }
}

void main()
{
    uint block = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    uint first = block * OIT_BLOCK + gl_LocalInvocationID.x;
    for (uint i = 0u; i < 8u; ++i)
        if (first + 128u * i < oit_pool.x)
            oit_arrange(first + 128u * i);
}
