/* The first guess of 1/sqrt(v), never too large (30 fraction bits). */
static const uint64_t DEADBEAT_RECIPROCAL_ROOT[3] = {UINT64_C(0xA6D2AA9B), UINT64_C(0xCD34B71A),
                                                     UINT64_C(0x66589918)};

/* 1/sqrt(v) for 1/4 <= v < 1 (32 fraction bits in, 30 out), too small by less than 2^-27.
   
   A quadratic, then y (1 + e/2 + 3 e^2/8) with e = 1 - v y^2 twice, each less
   a margin of four units that keeps e positive whatever is rounded off. */
static uint64_t deadbeat_reciprocal_root(uint64_t v)
{
    const uint64_t slope = DEADBEAT_RECIPROCAL_ROOT[1] - ((DEADBEAT_RECIPROCAL_ROOT[2] * v) >> 32);
    const uint64_t first = DEADBEAT_RECIPROCAL_ROOT[0] - ((slope * v) >> 32);
    const uint64_t first_gap = (UINT64_C(1) << 30) - ((((first * first) >> 30) * v) >> 32);
    const uint64_t first_step = (first_gap >> 1) + ((3 * first_gap * first_gap) >> 33);
    const uint64_t second = first + ((first * first_step) >> 30) - 4;
    const uint64_t second_gap = (UINT64_C(1) << 30) - ((((second * second) >> 30) * v) >> 32);
    const uint64_t second_step = (second_gap >> 1) + ((3 * second_gap * second_gap) >> 33);
    return second + ((second * second_step) >> 30) - 4;
}
