/* x towards zero as a signed number, two's complement; what is beyond their ends as the end, NaN as 0. */
static uint32_t deadbeat_index_from_f64(double x)
{
    if (x >= 2147483647.0) {
        return 2147483647U;
    }
    if (x <= -2147483648.0) {
        return 2147483648U;
    }
    if (x > 0.0) {
        return (uint32_t)x;
    }
    return (x < 0.0) ? (0U - (uint32_t)(-x)) : 0U;
}
