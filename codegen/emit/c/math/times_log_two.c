/* log(2) with 64 fraction bits. */
#define DEADBEAT_LN_2 UINT64_C(0xB17217F7D1CF79AC)

/* |k| log(2) for k but 0, relative error below 2^-60. */
static deadbeat_scaled_t deadbeat_times_log_two(int32_t k)
{
    const int32_t steps = (k < 0) ? -k : k;
    return deadbeat_product(deadbeat_normalised((uint64_t)steps, 63),
                            deadbeat_scaled(DEADBEAT_LN_2, -1));
}
