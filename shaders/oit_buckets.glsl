// For: oit_buffers.h
// What the bucketed store keeps beside the runs, for those who look for fragments of one part. After the blocks of
// oit_record.glsl. Records of a bucket are numbered from `first` on and ordered as they are composed.

// Place of the i-th record of the pixel, by part and depth; OIT_VECTORS vectors each.
uint oit_bucket_record(uint p, uint i)
{
    return oit_pixel[OIT_KEY(p, i)];
}

// Where the records of a part lie in the order of oit_bucket_record; false: the pixel has none.
bool oit_find_bucket(uint p, uint part, out uint first, out uint count)
{
    first = count = 0u;
    for (uint i = 0u, slot = part % OIT_LAYERS; i < OIT_LAYERS; ++i) {
        uint range = oit_pixel[OIT_BUCKET(p, slot) + 1u];
        if (range == 0u)
            return false;
        if (oit_pixel[OIT_BUCKET(p, slot)] == part) {
            first = range & 0xffffu;
            count = range >> 16u;
            return true;
        }
        slot = slot + 1u < OIT_LAYERS ? slot + 1u : 0u;
    }
    return false;
}
