// For: oit_buffers.h
// What the bucketed store keeps beside the runs, for those who look for fragments of one part. After the blocks of
// oit_record.glsl. Records of a bucket are numbered from `first` on and ordered as they are composed.
#define OIT_BUCKET_USED 0x80000000u

// Place of the i-th record of the pixel, by bucket and depth; OIT_VECTORS vectors each.
uint oit_bucket_record(uint p, uint i)
{
    return oit_pixel[OIT_KEY(p, i)];
}

// Which records a part has, in the order of oit_bucket_record. Returns where its bucket says so; 0: the pixel has none.
uint oit_find_bucket(uint p, uint part, out uint first, out uint count)
{
    uint slot = OIT_LAYERS > 0u ? part % OIT_LAYERS : 0u;
    first = count = 0u;
    for (uint i = 0u; i < OIT_LAYERS; ++i) {
        uint at = OIT_BUCKET(p, slot), range = oit_pixel[at + 1u];
        if (range == 0u)
            break;
        if (oit_pixel[at] == part) {
            first = range & 0xffffu;
            count = range >> 16u & 0x7fffu;
            return at + 1u;
        }
        slot = slot + 1u < OIT_LAYERS ? slot + 1u : 0u;
    }
    return 0u;
}
