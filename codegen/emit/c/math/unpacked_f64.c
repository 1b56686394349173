/* The finite positive number with these bits, not 0; exact. */
static deadbeat_scaled_t deadbeat_unpacked_f64(uint64_t magnitude)
{
    const int32_t field = (int32_t)(magnitude >> 52);
    const uint64_t digits = magnitude << 11;
    if (field == 0) {
        return deadbeat_normalised(digits, -1022);
    }
    return deadbeat_scaled(digits | (UINT64_C(1) << 63), field - 1023);
}
