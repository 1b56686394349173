/* The angle with these bits, positive and finite, its rest exact to 2^-60 of itself. */
static deadbeat_turned_t deadbeat_reduce_f64(uint64_t magnitude)
{
    if (magnitude <= UINT64_C(0x3FE921FB54442D18)) {
        return deadbeat_turned(deadbeat_signed(deadbeat_unpacked_f64(magnitude), 0), 0);
    }
    const uint64_t digits = (magnitude & UINT64_C(0x000FFFFFFFFFFFFF)) | (UINT64_C(1) << 52);
    const uint32_t start = ((uint32_t)(magnitude >> 52)) - 1013;
    const uint32_t slot = start >> 5;
    const uint32_t shift = start & 31;
    const uint64_t upper =
        (deadbeat_window_f64(slot, shift) << 32) | deadbeat_window_f64(slot + 1, shift);
    const uint64_t middle =
        (deadbeat_window_f64(slot + 2, shift) << 32) | deadbeat_window_f64(slot + 3, shift);
    const uint64_t lower =
        (deadbeat_window_f64(slot + 4, shift) << 32) | deadbeat_window_f64(slot + 5, shift);
    const deadbeat_pair_t center = deadbeat_mul_full(middle, digits);
    const uint64_t low = (center.low + (deadbeat_mul_high(lower, digits)));
    const uint64_t carry = (low < center.low) ? 1 : 0;
    const uint64_t high = ((upper * digits) + (center.high + carry));
    return deadbeat_turned_from_quarters(high, low);
}
