// For: oit_buffers.h
// Sums that stay at the largest number instead of starting again from zero, and their prefix sum over a work group.
uint oit_add(uint a, uint b)
{
    uint sum = a + b;
    return sum < a ? 0xffffffffu : sum;
}

// OIT_STORE_LINKED, and the list was too small for `total`: which records it has depends on which came first, so all pixels
// are lost alike: by this much their runs are moved, beyond the pool.
uint oit_all_lost(uint total)
{
    return OIT_STORE == OIT_LINKED && OIT_ASYNC == 1 && OIT_DIRECT && total > oit_pool.z ? oit_pool.z : 0u;
}

// 0 for up to 8, then one more for each doubling.
uint oit_class(uint count)
{
    return count <= 8u ? 0u : min(uint(findMSB(count - 1u)) - 2u, 4u);
}
#ifdef OIT_SCANS
shared uint oit_scanned[128];

// What lies before this invocation. All 128 must call it.
uint oit_scan(uint self, uint value)
{
    oit_scanned[self] = value;
    barrier();
    for (uint reach = 1u; reach < 128u; reach <<= 1u) {
        uint other = self >= reach ? oit_scanned[self - reach] : 0u;
        barrier();
        oit_scanned[self] = oit_add(oit_scanned[self], other);
        barrier();
    }
    return self > 0u ? oit_scanned[self - 1u] : 0u;
}
#endif
