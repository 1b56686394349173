/* The angle with these bits, positive and finite, its rest exact to 2^-38 of itself. */
static deadbeat_turned_t deadbeat_reduce_f32(uint32_t magnitude)
{
    if (magnitude <= 0x3F490FDAu) {
        return deadbeat_turned(deadbeat_signed(deadbeat_unpacked_f32(magnitude), 0), 0);
    }
    const uint64_t digits = (uint64_t)((magnitude & 0x007FFFFFu) | 0x00800000u);
    const uint32_t start = (magnitude >> 23) - 120;
    const uint32_t slot = start >> 5;
    const uint32_t shift = start & 31;
    const uint64_t upper = (deadbeat_window_f32(slot, shift) * digits) << 32;
    const uint64_t middle = deadbeat_window_f32(slot + 1, shift) * digits;
    const uint64_t lower = deadbeat_window_f32(slot + 2, shift) * digits;
    return deadbeat_turned_from_quarters(((upper + middle) + (lower >> 32)), lower << 32);
}
