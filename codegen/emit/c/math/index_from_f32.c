/* x towards zero as a signed number, two's complement, as far as single precision has them; NaN as 0. */
static uint32_t deadbeat_index_from_f32(float x)
{
    if (x >= 2147483520.0f) {
        return 2147483520U;
    }
    if (x <= -2147483648.0f) {
        return 2147483648U;
    }
    if (x > 0.0f) {
        return (uint32_t)x;
    }
    return (x < 0.0f) ? (0U - (uint32_t)(-x)) : 0U;
}
