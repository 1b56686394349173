/* 2^126 / d for d >= 2^63, off by less than 2^-61 of itself.
   
   A 16-bit quotient, one Newton step to 28 bits, one step of third order. */
static uint64_t deadbeat_reciprocal(uint64_t d)
{
    const uint64_t d_high = d >> 32;
    const uint64_t d_low = d & 0xFFFFFFFFu;
    const uint32_t top = (uint32_t)(d >> 48);
    const uint64_t guess = (uint64_t)(UINT32_C(0xFFFFFFFF) / (top + 1));
    const uint64_t gap = ((UINT64_C(1) << 48) - (d_high + 1) * guess) >> 2;
    const uint64_t second = (guess << 15) + ((guess * gap) >> 31);
    const uint64_t covered = d_high * second + ((d_low * second) >> 32);
    const uint64_t rest = (UINT64_C(1) << 63) - covered;
    const uint64_t brief = rest >> 3;
    const uint64_t series = (rest << 29) + ((brief * brief) >> 28);
    return (second << 31) + (deadbeat_mul_high(series, second << 32) >> 29);
}
