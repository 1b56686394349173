/* sqrt(v) for 1/4 <= v < 1, both with 64 fraction bits, off by less than 2^-60. */
static uint64_t deadbeat_root(uint64_t v)
{
    const uint64_t inverse = deadbeat_reciprocal_root(v >> 32);
    const uint64_t covered = deadbeat_mul_high(v, (inverse * inverse) << 2);
    const uint64_t gap = (UINT64_C(1) << 62) - covered;
    const uint64_t coarse = gap >> 5;
    const uint64_t series = (gap << 1) + ((3 * coarse * coarse) >> 53);
    const uint64_t start = (((v >> 32) * inverse) << 2) + (((v & 0xFFFFFFFFu) * inverse) >> 30);
    return start + deadbeat_mul_high(start, series);
}
