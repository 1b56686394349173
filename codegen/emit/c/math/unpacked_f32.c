/* The finite positive number with these bits, not 0; exact. */
static deadbeat_scaled_t deadbeat_unpacked_f32(uint32_t magnitude)
{
    const int32_t field = (int32_t)(magnitude >> 23);
    const uint64_t digits = (uint64_t)magnitude << 40;
    if (field == 0) {
        return deadbeat_normalised(digits, -126);
    }
    return deadbeat_scaled(digits | (UINT64_C(1) << 63), field - 127);
}
