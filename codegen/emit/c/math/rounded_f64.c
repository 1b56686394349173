/* x rounded to the nearest, ties to even, with subnormals and overflow, and the sign put in. */
static double deadbeat_rounded_f64(uint64_t sign, deadbeat_scaled_t x)
{
    const int32_t field = x.exponent + 1023;
    if (field >= 2047) {
        return deadbeat_f64_from_bits(sign | DEADBEAT_INFINITY_F64);
    }
    const int32_t shift = (field > 0) ? 11 : 12 - field;
    if (shift > 63) {
        const int least = shift == 64 && x.significand > (UINT64_C(1) << 63);
        return deadbeat_f64_from_bits(least ? sign + 1 : sign);
    }
    const uint64_t kept = x.significand >> shift;
    const uint64_t rest = x.significand - (kept << shift);
    const uint64_t half = UINT64_C(1) << (shift - 1);
    const uint64_t odd = kept & 1;
    const uint64_t up = (rest + odd > half) ? 1 : 0;
    const uint64_t base = (field > 0) ? ((uint64_t)(field - 1)) << 52 : 0;
    return deadbeat_f64_from_bits(sign | (base + (kept + up)));
}
