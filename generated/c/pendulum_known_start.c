/* pendulum_known_start.c: Finite-time observer: Velocity of a pendulum that is let go from where it was held.
 *
 * Generated; pendulum_known_start.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "pendulum_known_start.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "pendulum_known_start.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "pendulum_known_start.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* The bits of a number. */
typedef union {
    float value;
    uint32_t bits;
} pendulum_known_start_f32_cell_t;

/* The bits of a number. */
static uint32_t pendulum_known_start_f32_to_bits(float x)
{
    pendulum_known_start_f32_cell_t cell;
    cell.value = x;
    return cell.bits;
}

/* The bit of the sign. */
#define PENDULUM_KNOWN_START_SIGN_F32 UINT32_C(0x80000000)

/* The bits of the largest magnitude. */
#define PENDULUM_KNOWN_START_MAGNITUDE_F32 UINT32_C(0x7FFFFFFF)

/* The bits of infinity. */
#define PENDULUM_KNOWN_START_INFINITY_F32 UINT32_C(0x7F800000)

/* The bits of the only NaN that is returned. */
#define PENDULUM_KNOWN_START_NAN_F32 UINT32_C(0x7FC00000)

/* The number with these bits. */
static float pendulum_known_start_f32_from_bits(uint32_t bits)
{
    pendulum_known_start_f32_cell_t cell;
    cell.bits = bits;
    return cell.value;
}

/* The number significand / 2^63 * 2^exponent, with the top bit of the significand set. */
typedef struct {
    uint64_t significand;
    int32_t exponent;
} pendulum_known_start_scaled_t;

/* A number with a sign. */
typedef struct {
    pendulum_known_start_scaled_t magnitude;
    int negative;
} pendulum_known_start_signed_t;

/* The angle quadrant * pi/2 + rest. */
typedef struct {
    pendulum_known_start_signed_t rest;
    uint32_t quadrant;
} pendulum_known_start_turned_t;

/* Attaches a sign. */
static pendulum_known_start_signed_t pendulum_known_start_signed(pendulum_known_start_scaled_t magnitude, int negative)
{
    pendulum_known_start_signed_t result;
    result.magnitude = magnitude;
    result.negative = negative;
    return result;
}

/* A number below 1 as fixed point with 64 fraction bits. */
static uint64_t pendulum_known_start_fraction(pendulum_known_start_scaled_t a)
{
    const int32_t shift = -1 - a.exponent;
    if (shift > 63) {
        return 0;
    }
    return a.significand >> shift;
}

/* The upper half of the product, at most 2 too small. */
static uint64_t pendulum_known_start_mul_high(uint64_t a, uint64_t b)
{
    const uint64_t a_high = a >> 32;
    const uint64_t a_low = a & 0xFFFFFFFFu;
    const uint64_t b_high = b >> 32;
    const uint64_t b_low = b & 0xFFFFFFFFu;
    const uint64_t cross = ((a_high * b_low) >> 32) + ((a_low * b_high) >> 32);
    return a_high * b_high + cross;
}

/* The square of a number below 1 as fixed point with 64 fraction bits. */
static uint64_t pendulum_known_start_squared_fraction(pendulum_known_start_scaled_t a)
{
    const uint64_t x = pendulum_known_start_fraction(a);
    return pendulum_known_start_mul_high(x, x);
}

/* Makes a number of a significand that has its top bit set. */
static pendulum_known_start_scaled_t pendulum_known_start_scaled(uint64_t significand, int32_t exponent)
{
    pendulum_known_start_scaled_t result;
    result.significand = significand;
    result.exponent = exponent;
    return result;
}

/* Makes a number of a significand of at least 2^62. */
static pendulum_known_start_scaled_t pendulum_known_start_settled(uint64_t significand, int32_t exponent)
{
    if ((significand >> 63) == 0) {
        return pendulum_known_start_scaled(significand << 1, exponent - 1);
    }
    return pendulum_known_start_scaled(significand, exponent);
}

/* (1 - cos(r)) / r^2 in powers of -r^2. */
static const uint64_t PENDULUM_KNOWN_START_COSINE[8] = {
    UINT64_C(0x8000000000000000), UINT64_C(0x0AAAAAAAAAAAAAA8), UINT64_C(0x005B05B05B05B02B),
    UINT64_C(0x0001A01A01A01865), UINT64_C(0x0000049F93EDD666), UINT64_C(0x00000008F76C6243),
    UINT64_C(0x000000000C9C9706), UINT64_C(0x00000000000D551B)};

/* cos(r) for 0 < r <= pi/4, relative error below 2^-60. */
static pendulum_known_start_scaled_t pendulum_known_start_cosine(pendulum_known_start_scaled_t r)
{
    const uint64_t z = pendulum_known_start_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = PENDULUM_KNOWN_START_COSINE[6] - ((PENDULUM_KNOWN_START_COSINE[7] * z_high) >> 32);
    const uint64_t c5 = PENDULUM_KNOWN_START_COSINE[5] - ((tail * z_high) >> 32);
    const uint64_t c4 = PENDULUM_KNOWN_START_COSINE[4] - pendulum_known_start_mul_high(c5, z);
    const uint64_t c3 = PENDULUM_KNOWN_START_COSINE[3] - pendulum_known_start_mul_high(c4, z);
    const uint64_t c2 = PENDULUM_KNOWN_START_COSINE[2] - pendulum_known_start_mul_high(c3, z);
    const uint64_t c1 = PENDULUM_KNOWN_START_COSINE[1] - pendulum_known_start_mul_high(c2, z);
    const uint64_t c0 = PENDULUM_KNOWN_START_COSINE[0] - pendulum_known_start_mul_high(c1, z);
    return pendulum_known_start_settled((UINT64_C(1) << 63) - (pendulum_known_start_mul_high(c0, z) >> 1), 0);
}

/* (1 - sin(r) / r) / r^2 in powers of -r^2. */
static const uint64_t PENDULUM_KNOWN_START_SINE[7] = {
    UINT64_C(0x2AAAAAAAAAAAAAA6), UINT64_C(0x0222222222222160), UINT64_C(0x000D00D00D00C575),
    UINT64_C(0x00002E3BC74A673D), UINT64_C(0x0000006B9914A637), UINT64_C(0x00000000B090498C),
    UINT64_C(0x0000000000D552BC)};

/* sin(r) for 0 < r <= pi/4, relative error below 2^-60. */
static pendulum_known_start_scaled_t pendulum_known_start_sine(pendulum_known_start_scaled_t r)
{
    const uint64_t z = pendulum_known_start_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = PENDULUM_KNOWN_START_SINE[5] - ((PENDULUM_KNOWN_START_SINE[6] * z_high) >> 32);
    const uint64_t c4 = PENDULUM_KNOWN_START_SINE[4] - ((tail * z_high) >> 32);
    const uint64_t c3 = PENDULUM_KNOWN_START_SINE[3] - pendulum_known_start_mul_high(c4, z);
    const uint64_t c2 = PENDULUM_KNOWN_START_SINE[2] - pendulum_known_start_mul_high(c3, z);
    const uint64_t c1 = PENDULUM_KNOWN_START_SINE[1] - pendulum_known_start_mul_high(c2, z);
    const uint64_t c0 = PENDULUM_KNOWN_START_SINE[0] - pendulum_known_start_mul_high(c1, z);
    const uint64_t lost = pendulum_known_start_mul_high(r.significand, pendulum_known_start_mul_high(c0, z));
    return pendulum_known_start_settled(r.significand - lost, r.exponent);
}

/* The sine of an angle. */
static pendulum_known_start_signed_t pendulum_known_start_sine_at(pendulum_known_start_turned_t angle)
{
    const int back = (angle.quadrant & 2) != 0;
    if ((angle.quadrant & 1) != 0) {
        return pendulum_known_start_signed(pendulum_known_start_cosine(angle.rest.magnitude), back);
    }
    return pendulum_known_start_signed(pendulum_known_start_sine(angle.rest.magnitude), back != angle.rest.negative);
}

/* Makes an angle of its parts. */
static pendulum_known_start_turned_t pendulum_known_start_turned(pendulum_known_start_signed_t rest, uint32_t quadrant)
{
    pendulum_known_start_turned_t result;
    result.rest = rest;
    result.quadrant = quadrant;
    return result;
}

/* The number of zero bits above the highest one bit; x is not 0. */
static int32_t pendulum_known_start_leading_zeros(uint64_t x)
{
#if defined(__GNUC__) && (defined(__ARM_FEATURE_CLZ) || defined(__LZCNT__))
    const uint32_t upper = (uint32_t)(x >> 32);
    return upper != 0 ? __builtin_clz(upper) : 32 + __builtin_clz((uint32_t)x);
#else
    uint32_t rest = (uint32_t)(x >> 32);
    int32_t count = 0;
    if (rest == 0) {
        rest = (uint32_t)x;
        count = 32;
    }
    if ((rest >> 16) == 0) {
        rest <<= 16;
        count += 16;
    }
    if ((rest >> 24) == 0) {
        rest <<= 8;
        count += 8;
    }
    if ((rest >> 28) == 0) {
        rest <<= 4;
        count += 4;
    }
    if ((rest >> 30) == 0) {
        rest <<= 2;
        count += 2;
    }
    if ((rest >> 31) == 0) {
        count += 1;
    }
    return count;
#endif
}

/* Makes a number of any significand but 0. */
static pendulum_known_start_scaled_t pendulum_known_start_normalised(uint64_t significand, int32_t exponent)
{
    const int32_t shift = pendulum_known_start_leading_zeros(significand);
    return pendulum_known_start_scaled(significand << shift, exponent - shift);
}

/* The finite positive number with these bits, not 0; exact. */
static pendulum_known_start_scaled_t pendulum_known_start_unpacked_f32(uint32_t magnitude)
{
    const int32_t field = (int32_t)(magnitude >> 23);
    const uint64_t digits = (uint64_t)magnitude << 40;
    if (field == 0) {
        return pendulum_known_start_normalised(digits, -126);
    }
    return pendulum_known_start_scaled(digits | (UINT64_C(1) << 63), field - 127);
}

/* 2/pi after 32 zero bits. */
static const uint32_t PENDULUM_KNOWN_START_TWO_OVER_PI_F32[9] = {
    UINT32_C(0x00000000), UINT32_C(0xA2F9836E), UINT32_C(0x4E441529),
    UINT32_C(0xFC2757D1), UINT32_C(0xF534DDC0), UINT32_C(0xDB629599),
    UINT32_C(0x3C439041), UINT32_C(0xFE5163AB), UINT32_C(0xDEBBC561)};

/* 32 bits of 2/pi from bit 32 slot + shift on. */
static uint64_t pendulum_known_start_window_f32(uint32_t slot, uint32_t shift)
{
    const uint64_t first = (uint64_t)(PENDULUM_KNOWN_START_TWO_OVER_PI_F32[slot]);
    const uint64_t second = (uint64_t)(PENDULUM_KNOWN_START_TWO_OVER_PI_F32[slot + 1]);
    return (((first << 32) | second) >> (32 - shift)) & 0xFFFFFFFFu;
}

/* a b, relative error below 2^-60. */
static pendulum_known_start_scaled_t pendulum_known_start_product(pendulum_known_start_scaled_t a, pendulum_known_start_scaled_t b)
{
    return pendulum_known_start_settled(pendulum_known_start_mul_high(a.significand, b.significand),
                            a.exponent + b.exponent + 1);
}

/* pi with 62 fraction bits; as a significand also pi/2 and pi/4. */
#define PENDULUM_KNOWN_START_PI UINT64_C(0xC90FDAA22168C235)

/* The angle of (high, low) / 2^126 quarter turns, its rest exact to 2^-60 of itself. */
static pendulum_known_start_turned_t pendulum_known_start_turned_from_quarters(uint64_t high, uint64_t low)
{
    const uint64_t eighths = high >> 61;
    const int negative = (eighths & 1) != 0;
    uint64_t upper = (high << 2) | (low >> 62);
    uint64_t lower = low << 2;
    if (negative) {
        upper = (lower == 0) ? (UINT64_C(0) - upper) : UINT64_MAX - upper;
        lower = (UINT64_C(0) - lower);
    }
    const int32_t shift = pendulum_known_start_leading_zeros(upper | 1);
    const uint64_t significand = (upper << shift) | ((lower >> 1) >> (63 - shift));
    const pendulum_known_start_signed_t rest = pendulum_known_start_signed(
        pendulum_known_start_product(pendulum_known_start_scaled(significand, -1 - shift), pendulum_known_start_scaled(PENDULUM_KNOWN_START_PI, 0)),
        negative);
    return pendulum_known_start_turned(rest, (uint32_t)(((eighths + 1) >> 1) & 3));
}

/* The angle with these bits, positive and finite, its rest exact to 2^-38 of itself. */
static pendulum_known_start_turned_t pendulum_known_start_reduce_f32(uint32_t magnitude)
{
    if (magnitude <= 0x3F490FDAu) {
        return pendulum_known_start_turned(pendulum_known_start_signed(pendulum_known_start_unpacked_f32(magnitude), 0), 0);
    }
    const uint64_t digits = (uint64_t)((magnitude & 0x007FFFFFu) | 0x00800000u);
    const uint32_t start = (magnitude >> 23) - 120;
    const uint32_t slot = start >> 5;
    const uint32_t shift = start & 31;
    const uint64_t upper = (pendulum_known_start_window_f32(slot, shift) * digits) << 32;
    const uint64_t middle = pendulum_known_start_window_f32(slot + 1, shift) * digits;
    const uint64_t lower = pendulum_known_start_window_f32(slot + 2, shift) * digits;
    return pendulum_known_start_turned_from_quarters(((upper + middle) + (lower >> 32)), lower << 32);
}

/* x rounded to the nearest, ties to even, with subnormals and overflow, and the sign put in. */
static float pendulum_known_start_rounded_f32(uint32_t sign, pendulum_known_start_scaled_t x)
{
    const int32_t field = x.exponent + 127;
    if (field >= 255) {
        return pendulum_known_start_f32_from_bits(sign | PENDULUM_KNOWN_START_INFINITY_F32);
    }
    const int32_t shift = (field > 0) ? 40 : 41 - field;
    if (shift > 63) {
        const int least = shift == 64 && x.significand > (UINT64_C(1) << 63);
        return pendulum_known_start_f32_from_bits(least ? sign + 1 : sign);
    }
    const uint64_t kept = x.significand >> shift;
    const uint64_t rest = x.significand - (kept << shift);
    const uint64_t half = UINT64_C(1) << (shift - 1);
    const uint64_t odd = kept & 1;
    const uint64_t up = (rest + odd > half) ? 1 : 0;
    const uint32_t base = (field > 0) ? ((uint32_t)(field - 1)) << 23 : 0;
    return pendulum_known_start_f32_from_bits(sign | (base + ((uint32_t)(kept + up))));
}

/* The sign bit of a negative number, else 0. */
static uint32_t pendulum_known_start_sign_f32(int negative)
{
    if (negative) {
        return PENDULUM_KNOWN_START_SIGN_F32;
    }
    return 0;
}

/* Sine of an angle in radians, the nearest float. */
static float pendulum_known_start_sin_f32(float x)
{
    const uint32_t bits = pendulum_known_start_f32_to_bits(x);
    const uint32_t magnitude = bits & PENDULUM_KNOWN_START_MAGNITUDE_F32;
    if (magnitude >= PENDULUM_KNOWN_START_INFINITY_F32) {
        return pendulum_known_start_f32_from_bits(PENDULUM_KNOWN_START_NAN_F32);
    }
    if (magnitude == 0) {
        return x;
    }
    const pendulum_known_start_signed_t value = pendulum_known_start_sine_at(pendulum_known_start_reduce_f32(magnitude));
    return pendulum_known_start_rounded_f32((bits & PENDULUM_KNOWN_START_SIGN_F32) ^ pendulum_known_start_sign_f32(value.negative),
                                value.magnitude);
}

/* What one part of a step hands to the next. */
typedef struct {
    uint32_t t0;
    uint32_t t3;
    float t25;
    float t34;
    float t42;
    uint32_t t56;
    float t59;
    float t67;
    float t68;
    float t117;
    pendulum_known_start_status t122;
    int flags[6]; /* t2, t5, t8, t33, t57, t70 */
} pendulum_known_start_work;

/* Part 1 of a step. */
static void pendulum_known_start_part_1(const pendulum_known_start_state *state, const pendulum_known_start_measurements *measurements, pendulum_known_start_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    work->t0 = state->count;
    work->flags[0] = 50U < work->t0;
    work->t3 = state->given;
    work->flags[1] = 0U < work->t3;
    const int t6 = work->flags[0] || work->flags[1];
    const float t7 = measurements->theta;
    work->flags[2] = (-1e34f <= t7) && (t7 <= 1e34f);

    /* prediction, for a sample that is missing or not measured now */
    const float t9 = state->sin_theta_1;
    const float t10 = state->z1_omega;
    const float t11 = state->theta_1;
    const float t13 = 0.0009999664f * t10;
    const float t15 = 1.070297e-5f * t9;
    const float t17 = 2.140576e-5f * t9;
    const float t18 = t13 + t11;
    const float t19 = t18 + t15;
    const float t20 = t19 + t17;
    const int t21 = (-1e34f <= t20) && (t20 <= 1e34f);
    const int t22 = t6 && t21;
    const float t23 = t22 ? t20 : t11;
    const float t24 = work->flags[2] ? t7 : t23;
    work->t25 = pendulum_known_start_sin_f32(t24);
    const float t26 = work->t25 - t9;
    const float t27 = 1.070297e-5f * t26;
    const float t28 = t20 + t27;
    const int t29 = (-1e34f <= t28) && (t28 <= 1e34f);
    const int t30 = t6 && t29;
    const float t31 = t30 ? t28 : t11;
    const int t32 = work->flags[2] || t30;
    work->flags[3] = !t32;
    work->t34 = work->flags[2] ? t7 : t31;

    /* both copies, one call on */
    const float t36 = 0.99993277f * t10;
    const float t38 = 0.03210873f * work->t25;
    const float t40 = 0.032108013f * t9;
    const float t41 = t36 + t38;
    work->t42 = t41 + t40;
    const float t43 = state->z2_omega;
    const float t45 = 1.0018027f * t43;
    const float t47 = -0.0033710722f * t11;
    const float t49 = 0.032128744f * work->t25;
    const float t51 = 0.03214804f * t9;
    const float t52 = t45 + t47;
    const float t53 = t52 + t49;
    const float t54 = t53 + t51;

    /* the reset, when a period is full */
    const uint32_t t55 = state->phase;
    work->t56 = (t55 < 49U) ? (t55 + 1U) : 0U;
    work->flags[4] = work->t56 == 0U;
    work->t59 = 1.87f * work->t34;
    const float t60 = t54 - work->t59;
    const float t61 = work->t42 - t60;
    const float t63 = 10.212608f * t61;
    const float t64 = work->t42 + t63;
    const int t65 = (-8.684609e35f <= t64) && (t64 <= 8.684609e35f);
    const float t66 = t64 + work->t59;
    work->t67 = work->flags[4] ? t64 : work->t42;
    work->t68 = work->flags[4] ? t66 : t54;
    const int t69 = !t65;
    work->flags[5] = work->flags[4] && t69;
}

/* Part 2 of a step. */
static void pendulum_known_start_part_2(pendulum_known_start_state *state, pendulum_known_start_work *work)
{
    /* how much of the period is good */
    const int t71 = work->flags[3] || work->flags[5];
    const uint32_t t73 = (work->t0 < 51U) ? (work->t0 + 1U) : 51U;
    const int t74 = work->t0 == 0U;
    const uint32_t t75 = t74 ? 1U : t73;
    const int t76 = work->flags[0] || work->flags[2];
    const uint32_t t77 = work->flags[0] ? t73 : t75;
    const uint32_t t78 = t76 ? t77 : 0U;
    const uint32_t t79 = t71 ? 0U : t78;
    state->count = t79;
    const uint32_t t80 = state->clean;
    const uint32_t t81 = (t80 < 51U) ? (t80 + 1U) : 51U;
    const uint32_t t82 = work->flags[2] ? t81 : 0U;
    state->clean = t82;
    const int t83 = 50U < t82;
    const int t84 = work->flags[4] && t83;
    const uint32_t t85 = state->coasting;
    const uint32_t t86 = t84 ? 0U : t85;
    const uint32_t t87 = work->flags[2] ? t86 : 1U;
    state->coasting = t87;
    const int t88 = t87 == 0U;
    const int t90 = t79 < 2U;
    const int t91 = 50U < t79;
    const int t92 = !work->flags[3];
    const int t93 = work->flags[1] && t92;
    const int t94 = !work->flags[5];
    const int t95 = t93 && t94;
    const int t96 = !t91;
    const int t97 = t95 && t96;
    const int t98 = (-8.684609e35f <= work->t42) && (work->t42 <= 8.684609e35f);
    const int t99 = t97 && t98;
    const int t100 = 1U < work->t3;
    const int t101 = t99 && t100;
    const int t102 = 2U < work->t3;
    const int t103 = t99 && t102;
    const uint32_t t104 = (work->t3 > 0U) ? (work->t3 - 1U) : 0U;
    const uint32_t t105 = t102 ? t104 : work->t3;
    const uint32_t t106 = t99 ? t105 : 0U;
    state->given = t106;

    /* for the next call */
    const float t108 = t99 ? work->t42 : 0.0f;
    const float t109 = t90 ? t108 : work->t67;
    const float t110 = t108 + work->t59;
    const float t111 = t90 ? t110 : work->t68;
    state->z1_omega = t109;
    state->z2_omega = t111;
    const uint32_t t112 = t90 ? 0U : work->t56;
    state->phase = t112;
    state->theta_1 = work->t34;
    state->sin_theta_1 = work->t25;
    const int t113 = t91 || t99;
    const int t114 = t91 || t101;
    const int t115 = t91 || t103;
    const int t116 = t115 && t88;

    /* the estimate; until it has converged, the start */
    work->t117 = t113 ? t109 : 0.0f;
    const pendulum_known_start_status t121 = t116 ? PENDULUM_KNOWN_START_CONVERGED : PENDULUM_KNOWN_START_COASTING;
    work->t122 = t114 ? t121 : PENDULUM_KNOWN_START_CONVERGING;
}

void pendulum_known_start_init(pendulum_known_start_state *state)
{
    state->z1_omega = 0.0f;
    state->z2_omega = 0.0f;
    state->theta_1 = 0.0f;
    state->sin_theta_1 = 0.0f;
    state->phase = 0U;
    state->count = 0U;
    state->clean = 0U;
    state->coasting = 0U;
    state->given = 0U;
}

void pendulum_known_start_init_at(pendulum_known_start_state *state, const pendulum_known_start_estimate *estimate)
{
    pendulum_known_start_init(state);
    /* the given state */
    const int t123 = estimate->status == PENDULUM_KNOWN_START_CONVERGED;
    const float t124 = estimate->theta;
    const int t125 = (-1e34f <= t124) && (t124 <= 1e34f);
    const float t127 = t125 ? t124 : 0.0f;
    const float t128 = estimate->omega;
    const int t129 = (-1e34f <= t128) && (t128 <= 1e34f);
    const float t130 = t129 ? t128 : 0.0f;
    const int t131 = t123 && t125;
    const int t132 = t131 && t129;
    const int t133 = (-8.684609e35f <= t130) && (t130 <= 8.684609e35f);
    const float t134 = t133 ? t130 : 0.0f;
    state->z1_omega = t134;
    const uint32_t t137 = t132 ? 52U : 1U;
    state->given = t137;

    /* what it shows, and what that makes of the nonlinear terms */
    const int t138 = (-1e34f <= t127) && (t127 <= 1e34f);
    const float t139 = t138 ? t127 : 0.0f;
    state->theta_1 = t139;
    const float t140 = pendulum_known_start_sin_f32(t139);
    const int t141 = (-1e34f <= t140) && (t140 <= 1e34f);
    const float t142 = t141 ? t140 : 0.0f;
    state->sin_theta_1 = t142;
}

void pendulum_known_start_step(pendulum_known_start_state *state, const pendulum_known_start_measurements *measurements,
                               pendulum_known_start_estimate *estimate)
{
    pendulum_known_start_work work;
    pendulum_known_start_part_1(state, measurements, &work);
    pendulum_known_start_part_2(state, &work);

    estimate->theta = work.t34;
    estimate->omega = work.t117;
    estimate->status = work.t122;
}
