/* x rounded to the nearest, ties to even, with subnormals and overflow, and the sign put in. */
static float deadbeat_rounded_f32(uint32_t sign, deadbeat_scaled_t x)
{
    const int32_t field = x.exponent + 127;
    if (field >= 255) {
        return deadbeat_f32_from_bits(sign | DEADBEAT_INFINITY_F32);
    }
    const int32_t shift = (field > 0) ? 40 : 41 - field;
    if (shift > 63) {
        const int least = shift == 64 && x.significand > (UINT64_C(1) << 63);
        return deadbeat_f32_from_bits(least ? sign + 1 : sign);
    }
    const uint64_t kept = x.significand >> shift;
    const uint64_t rest = x.significand - (kept << shift);
    const uint64_t half = UINT64_C(1) << (shift - 1);
    const uint64_t odd = kept & 1;
    const uint64_t up = (rest + odd > half) ? 1 : 0;
    const uint32_t base = (field > 0) ? ((uint32_t)(field - 1)) << 23 : 0;
    return deadbeat_f32_from_bits(sign | (base + ((uint32_t)(kept + up))));
}
