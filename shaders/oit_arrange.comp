// For: oit_buffers.h
// After the second geometry pass of the bucketed store (Murray 2016, section 4.1): the fragments of each pixel grouped by
// part, and by depth within a part (reordering of Z), and where each group lies (bucket creation). The places in Z are
// ordered, not the records, which stay where they are.
layout(local_size_x = 128) in;

// One more fragment of that part. Its slot is part mod k, or the next that is free: there are k, and no more parts. Of two
// parts that meet the smaller takes the slot and the other moves on; so the table is the one that the paper gets from parts
// in ascending order, in whatever order they come.
void oit_count_part(uint p, uint part)
{
    uint count = 1u, slot = part % OIT_LAYERS;
    for (uint i = 0u; i < OIT_LAYERS; ++i) {
        uint at = OIT_BUCKET(p, slot), there = oit_pixel[at], others = oit_pixel[at + 1u];
        if (others > 0u && there == part) {
            oit_pixel[at + 1u] = others + 1u;
            return;
        }
        if (others == 0u || part < there) {
            oit_pixel[at] = part;
            oit_pixel[at + 1u] = count;
            if (others == 0u)
                return;
            part = there;
            count = others;
        }
        slot = slot + 1u < OIT_LAYERS ? slot + 1u : 0u;
    }
}

// Into its bucket, behind the fragments that are composed before it.
void oit_place(uint p, uint place)
{
    uint part = OIT_WORD(place * uint(OIT_VECTORS), OIT_AT_PART), first, count;
    uint at = oit_find_bucket(p, part, first, count), to = first + count;
    for (; to > first && oit_after(oit_bucket_record(p, to - 1u) * uint(OIT_VECTORS), place * uint(OIT_VECTORS)); --to)
        oit_pixel[OIT_KEY(p, to)] = oit_bucket_record(p, to - 1u);
    oit_pixel[OIT_KEY(p, to)] = place;
    oit_pixel[at] += 1u << 16u;
}

void oit_arrange(uint p)
{
    uint end = oit_pixel[OIT_START(p + 1u)];
    uint start = oit_pixel[OIT_START(p)] + uint(max(int(oit_pixel[OIT_LEFT(p)]), 0));
    for (uint slot = 0u; slot < OIT_LAYERS; ++slot)
        oit_pixel[OIT_BUCKET(p, slot) + 1u] = 0u;
    for (uint place = start; place < end; ++place)
        oit_count_part(p, OIT_WORD(place * uint(OIT_VECTORS), OIT_AT_PART));
    uint first = 0u;
    for (uint slot = 0u; slot < OIT_LAYERS; ++slot) {
        uint at = OIT_BUCKET(p, slot) + 1u, count = oit_pixel[at];
        oit_pixel[at] = count > 0u ? OIT_BUCKET_USED | first : 0u;
        first += count;
    }
    for (uint place = start; place < end; ++place)
        oit_place(p, place);
}

void main()
{
    uint block = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    uint first = block * OIT_BLOCK + gl_LocalInvocationID.x;
    for (uint i = 0u; i < 8u; ++i)
        if (first + 128u * i < oit_pool.x)
            oit_arrange(first + 128u * i);
}
