/* pendulum_impulsive.c: Finite-time observer: Velocity of a free pendulum from its encoder, by two copies of it.
 *
 * Generated; pendulum_impulsive.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "pendulum_impulsive.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "pendulum_impulsive.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "pendulum_impulsive.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* The bits of a number. */
typedef union {
    float value;
    uint32_t bits;
} pendulum_impulsive_f32_cell_t;

/* The bits of a number. */
static uint32_t pendulum_impulsive_f32_to_bits(float x)
{
    pendulum_impulsive_f32_cell_t cell;
    cell.value = x;
    return cell.bits;
}

/* The bit of the sign. */
#define PENDULUM_IMPULSIVE_SIGN_F32 UINT32_C(0x80000000)

/* The bits of the largest magnitude. */
#define PENDULUM_IMPULSIVE_MAGNITUDE_F32 UINT32_C(0x7FFFFFFF)

/* The bits of infinity. */
#define PENDULUM_IMPULSIVE_INFINITY_F32 UINT32_C(0x7F800000)

/* The bits of the only NaN that is returned. */
#define PENDULUM_IMPULSIVE_NAN_F32 UINT32_C(0x7FC00000)

/* The number with these bits. */
static float pendulum_impulsive_f32_from_bits(uint32_t bits)
{
    pendulum_impulsive_f32_cell_t cell;
    cell.bits = bits;
    return cell.value;
}

/* The number significand / 2^63 * 2^exponent, with the top bit of the significand set. */
typedef struct {
    uint64_t significand;
    int32_t exponent;
} pendulum_impulsive_scaled_t;

/* A number with a sign. */
typedef struct {
    pendulum_impulsive_scaled_t magnitude;
    int negative;
} pendulum_impulsive_signed_t;

/* The angle quadrant * pi/2 + rest. */
typedef struct {
    pendulum_impulsive_signed_t rest;
    uint32_t quadrant;
} pendulum_impulsive_turned_t;

/* Attaches a sign. */
static pendulum_impulsive_signed_t pendulum_impulsive_signed(pendulum_impulsive_scaled_t magnitude, int negative)
{
    pendulum_impulsive_signed_t result;
    result.magnitude = magnitude;
    result.negative = negative;
    return result;
}

/* A number below 1 as fixed point with 64 fraction bits. */
static uint64_t pendulum_impulsive_fraction(pendulum_impulsive_scaled_t a)
{
    const int32_t shift = -1 - a.exponent;
    if (shift > 63) {
        return 0;
    }
    return a.significand >> shift;
}

/* The upper half of the product, at most 2 too small. */
static uint64_t pendulum_impulsive_mul_high(uint64_t a, uint64_t b)
{
    const uint64_t a_high = a >> 32;
    const uint64_t a_low = a & 0xFFFFFFFFu;
    const uint64_t b_high = b >> 32;
    const uint64_t b_low = b & 0xFFFFFFFFu;
    const uint64_t cross = ((a_high * b_low) >> 32) + ((a_low * b_high) >> 32);
    return a_high * b_high + cross;
}

/* The square of a number below 1 as fixed point with 64 fraction bits. */
static uint64_t pendulum_impulsive_squared_fraction(pendulum_impulsive_scaled_t a)
{
    const uint64_t x = pendulum_impulsive_fraction(a);
    return pendulum_impulsive_mul_high(x, x);
}

/* Makes a number of a significand that has its top bit set. */
static pendulum_impulsive_scaled_t pendulum_impulsive_scaled(uint64_t significand, int32_t exponent)
{
    pendulum_impulsive_scaled_t result;
    result.significand = significand;
    result.exponent = exponent;
    return result;
}

/* Makes a number of a significand of at least 2^62. */
static pendulum_impulsive_scaled_t pendulum_impulsive_settled(uint64_t significand, int32_t exponent)
{
    if ((significand >> 63) == 0) {
        return pendulum_impulsive_scaled(significand << 1, exponent - 1);
    }
    return pendulum_impulsive_scaled(significand, exponent);
}

/* (1 - cos(r)) / r^2 in powers of -r^2. */
static const uint64_t PENDULUM_IMPULSIVE_COSINE[8] = {
    UINT64_C(0x8000000000000000), UINT64_C(0x0AAAAAAAAAAAAAA8), UINT64_C(0x005B05B05B05B02B),
    UINT64_C(0x0001A01A01A01865), UINT64_C(0x0000049F93EDD666), UINT64_C(0x00000008F76C6243),
    UINT64_C(0x000000000C9C9706), UINT64_C(0x00000000000D551B)};

/* cos(r) for 0 < r <= pi/4, relative error below 2^-60. */
static pendulum_impulsive_scaled_t pendulum_impulsive_cosine(pendulum_impulsive_scaled_t r)
{
    const uint64_t z = pendulum_impulsive_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = PENDULUM_IMPULSIVE_COSINE[6] - ((PENDULUM_IMPULSIVE_COSINE[7] * z_high) >> 32);
    const uint64_t c5 = PENDULUM_IMPULSIVE_COSINE[5] - ((tail * z_high) >> 32);
    const uint64_t c4 = PENDULUM_IMPULSIVE_COSINE[4] - pendulum_impulsive_mul_high(c5, z);
    const uint64_t c3 = PENDULUM_IMPULSIVE_COSINE[3] - pendulum_impulsive_mul_high(c4, z);
    const uint64_t c2 = PENDULUM_IMPULSIVE_COSINE[2] - pendulum_impulsive_mul_high(c3, z);
    const uint64_t c1 = PENDULUM_IMPULSIVE_COSINE[1] - pendulum_impulsive_mul_high(c2, z);
    const uint64_t c0 = PENDULUM_IMPULSIVE_COSINE[0] - pendulum_impulsive_mul_high(c1, z);
    return pendulum_impulsive_settled((UINT64_C(1) << 63) - (pendulum_impulsive_mul_high(c0, z) >> 1), 0);
}

/* (1 - sin(r) / r) / r^2 in powers of -r^2. */
static const uint64_t PENDULUM_IMPULSIVE_SINE[7] = {
    UINT64_C(0x2AAAAAAAAAAAAAA6), UINT64_C(0x0222222222222160), UINT64_C(0x000D00D00D00C575),
    UINT64_C(0x00002E3BC74A673D), UINT64_C(0x0000006B9914A637), UINT64_C(0x00000000B090498C),
    UINT64_C(0x0000000000D552BC)};

/* sin(r) for 0 < r <= pi/4, relative error below 2^-60. */
static pendulum_impulsive_scaled_t pendulum_impulsive_sine(pendulum_impulsive_scaled_t r)
{
    const uint64_t z = pendulum_impulsive_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = PENDULUM_IMPULSIVE_SINE[5] - ((PENDULUM_IMPULSIVE_SINE[6] * z_high) >> 32);
    const uint64_t c4 = PENDULUM_IMPULSIVE_SINE[4] - ((tail * z_high) >> 32);
    const uint64_t c3 = PENDULUM_IMPULSIVE_SINE[3] - pendulum_impulsive_mul_high(c4, z);
    const uint64_t c2 = PENDULUM_IMPULSIVE_SINE[2] - pendulum_impulsive_mul_high(c3, z);
    const uint64_t c1 = PENDULUM_IMPULSIVE_SINE[1] - pendulum_impulsive_mul_high(c2, z);
    const uint64_t c0 = PENDULUM_IMPULSIVE_SINE[0] - pendulum_impulsive_mul_high(c1, z);
    const uint64_t lost = pendulum_impulsive_mul_high(r.significand, pendulum_impulsive_mul_high(c0, z));
    return pendulum_impulsive_settled(r.significand - lost, r.exponent);
}

/* The sine of an angle. */
static pendulum_impulsive_signed_t pendulum_impulsive_sine_at(pendulum_impulsive_turned_t angle)
{
    const int back = (angle.quadrant & 2) != 0;
    if ((angle.quadrant & 1) != 0) {
        return pendulum_impulsive_signed(pendulum_impulsive_cosine(angle.rest.magnitude), back);
    }
    return pendulum_impulsive_signed(pendulum_impulsive_sine(angle.rest.magnitude), back != angle.rest.negative);
}

/* Makes an angle of its parts. */
static pendulum_impulsive_turned_t pendulum_impulsive_turned(pendulum_impulsive_signed_t rest, uint32_t quadrant)
{
    pendulum_impulsive_turned_t result;
    result.rest = rest;
    result.quadrant = quadrant;
    return result;
}

/* The number of zero bits above the highest one bit; x is not 0. */
static int32_t pendulum_impulsive_leading_zeros(uint64_t x)
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
static pendulum_impulsive_scaled_t pendulum_impulsive_normalised(uint64_t significand, int32_t exponent)
{
    const int32_t shift = pendulum_impulsive_leading_zeros(significand);
    return pendulum_impulsive_scaled(significand << shift, exponent - shift);
}

/* The finite positive number with these bits, not 0; exact. */
static pendulum_impulsive_scaled_t pendulum_impulsive_unpacked_f32(uint32_t magnitude)
{
    const int32_t field = (int32_t)(magnitude >> 23);
    const uint64_t digits = (uint64_t)magnitude << 40;
    if (field == 0) {
        return pendulum_impulsive_normalised(digits, -126);
    }
    return pendulum_impulsive_scaled(digits | (UINT64_C(1) << 63), field - 127);
}

/* 2/pi after 32 zero bits. */
static const uint32_t PENDULUM_IMPULSIVE_TWO_OVER_PI_F32[9] = {
    UINT32_C(0x00000000), UINT32_C(0xA2F9836E), UINT32_C(0x4E441529),
    UINT32_C(0xFC2757D1), UINT32_C(0xF534DDC0), UINT32_C(0xDB629599),
    UINT32_C(0x3C439041), UINT32_C(0xFE5163AB), UINT32_C(0xDEBBC561)};

/* 32 bits of 2/pi from bit 32 slot + shift on. */
static uint64_t pendulum_impulsive_window_f32(uint32_t slot, uint32_t shift)
{
    const uint64_t first = (uint64_t)(PENDULUM_IMPULSIVE_TWO_OVER_PI_F32[slot]);
    const uint64_t second = (uint64_t)(PENDULUM_IMPULSIVE_TWO_OVER_PI_F32[slot + 1]);
    return (((first << 32) | second) >> (32 - shift)) & 0xFFFFFFFFu;
}

/* a b, relative error below 2^-60. */
static pendulum_impulsive_scaled_t pendulum_impulsive_product(pendulum_impulsive_scaled_t a, pendulum_impulsive_scaled_t b)
{
    return pendulum_impulsive_settled(pendulum_impulsive_mul_high(a.significand, b.significand),
                            a.exponent + b.exponent + 1);
}

/* pi with 62 fraction bits; as a significand also pi/2 and pi/4. */
#define PENDULUM_IMPULSIVE_PI UINT64_C(0xC90FDAA22168C235)

/* The angle of (high, low) / 2^126 quarter turns, its rest exact to 2^-60 of itself. */
static pendulum_impulsive_turned_t pendulum_impulsive_turned_from_quarters(uint64_t high, uint64_t low)
{
    const uint64_t eighths = high >> 61;
    const int negative = (eighths & 1) != 0;
    uint64_t upper = (high << 2) | (low >> 62);
    uint64_t lower = low << 2;
    if (negative) {
        upper = (lower == 0) ? (UINT64_C(0) - upper) : UINT64_MAX - upper;
        lower = (UINT64_C(0) - lower);
    }
    const int32_t shift = pendulum_impulsive_leading_zeros(upper | 1);
    const uint64_t significand = (upper << shift) | ((lower >> 1) >> (63 - shift));
    const pendulum_impulsive_signed_t rest = pendulum_impulsive_signed(
        pendulum_impulsive_product(pendulum_impulsive_scaled(significand, -1 - shift), pendulum_impulsive_scaled(PENDULUM_IMPULSIVE_PI, 0)),
        negative);
    return pendulum_impulsive_turned(rest, (uint32_t)(((eighths + 1) >> 1) & 3));
}

/* The angle with these bits, positive and finite, its rest exact to 2^-38 of itself. */
static pendulum_impulsive_turned_t pendulum_impulsive_reduce_f32(uint32_t magnitude)
{
    if (magnitude <= 0x3F490FDAu) {
        return pendulum_impulsive_turned(pendulum_impulsive_signed(pendulum_impulsive_unpacked_f32(magnitude), 0), 0);
    }
    const uint64_t digits = (uint64_t)((magnitude & 0x007FFFFFu) | 0x00800000u);
    const uint32_t start = (magnitude >> 23) - 120;
    const uint32_t slot = start >> 5;
    const uint32_t shift = start & 31;
    const uint64_t upper = (pendulum_impulsive_window_f32(slot, shift) * digits) << 32;
    const uint64_t middle = pendulum_impulsive_window_f32(slot + 1, shift) * digits;
    const uint64_t lower = pendulum_impulsive_window_f32(slot + 2, shift) * digits;
    return pendulum_impulsive_turned_from_quarters(((upper + middle) + (lower >> 32)), lower << 32);
}

/* x rounded to the nearest, ties to even, with subnormals and overflow, and the sign put in. */
static float pendulum_impulsive_rounded_f32(uint32_t sign, pendulum_impulsive_scaled_t x)
{
    const int32_t field = x.exponent + 127;
    if (field >= 255) {
        return pendulum_impulsive_f32_from_bits(sign | PENDULUM_IMPULSIVE_INFINITY_F32);
    }
    const int32_t shift = (field > 0) ? 40 : 41 - field;
    if (shift > 63) {
        const int least = shift == 64 && x.significand > (UINT64_C(1) << 63);
        return pendulum_impulsive_f32_from_bits(least ? sign + 1 : sign);
    }
    const uint64_t kept = x.significand >> shift;
    const uint64_t rest = x.significand - (kept << shift);
    const uint64_t half = UINT64_C(1) << (shift - 1);
    const uint64_t odd = kept & 1;
    const uint64_t up = (rest + odd > half) ? 1 : 0;
    const uint32_t base = (field > 0) ? ((uint32_t)(field - 1)) << 23 : 0;
    return pendulum_impulsive_f32_from_bits(sign | (base + ((uint32_t)(kept + up))));
}

/* The sign bit of a negative number, else 0. */
static uint32_t pendulum_impulsive_sign_f32(int negative)
{
    if (negative) {
        return PENDULUM_IMPULSIVE_SIGN_F32;
    }
    return 0;
}

/* Sine of an angle in radians, the nearest float. */
static float pendulum_impulsive_sin_f32(float x)
{
    const uint32_t bits = pendulum_impulsive_f32_to_bits(x);
    const uint32_t magnitude = bits & PENDULUM_IMPULSIVE_MAGNITUDE_F32;
    if (magnitude >= PENDULUM_IMPULSIVE_INFINITY_F32) {
        return pendulum_impulsive_f32_from_bits(PENDULUM_IMPULSIVE_NAN_F32);
    }
    if (magnitude == 0) {
        return x;
    }
    const pendulum_impulsive_signed_t value = pendulum_impulsive_sine_at(pendulum_impulsive_reduce_f32(magnitude));
    return pendulum_impulsive_rounded_f32((bits & PENDULUM_IMPULSIVE_SIGN_F32) ^ pendulum_impulsive_sign_f32(value.negative),
                                value.magnitude);
}

/* What one part of a step hands to the next. */
typedef struct {
    float t21;
    float t30;
    uint32_t t52;
    float t56;
    float t64;
    float t65;
    float t94;
    pendulum_impulsive_status t99;
    int flags[3]; /* t85, t87, t88 */
} pendulum_impulsive_work;

/* Part 1 of a step. */
static void pendulum_impulsive_part_1(pendulum_impulsive_state *state, const pendulum_impulsive_measurements *measurements, pendulum_impulsive_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    const uint32_t t0 = state->count;
    const int t2 = 50U < t0;
    const float t3 = measurements->theta;
    const int t4 = (-1e34f <= t3) && (t3 <= 1e34f);

    /* prediction, for a sample that is missing or not measured now */
    const float t5 = state->sin_theta_1;
    const float t6 = state->z1_omega;
    const float t7 = state->theta_1;
    const float t9 = 0.0009999664f * t6;
    const float t11 = 1.070297e-5f * t5;
    const float t13 = 2.140576e-5f * t5;
    const float t14 = t9 + t7;
    const float t15 = t14 + t11;
    const float t16 = t15 + t13;
    const int t17 = (-1e34f <= t16) && (t16 <= 1e34f);
    const int t18 = t2 && t17;
    const float t19 = t18 ? t16 : t7;
    const float t20 = t4 ? t3 : t19;
    work->t21 = pendulum_impulsive_sin_f32(t20);
    const float t22 = work->t21 - t5;
    const float t23 = 1.070297e-5f * t22;
    const float t24 = t16 + t23;
    const int t25 = (-1e34f <= t24) && (t24 <= 1e34f);
    const int t26 = t2 && t25;
    const float t27 = t26 ? t24 : t7;
    const int t28 = t4 || t26;
    const int t29 = !t28;
    work->t30 = t4 ? t3 : t27;

    /* both copies, one call on */
    const float t32 = 0.99993277f * t6;
    const float t34 = 0.03210873f * work->t21;
    const float t36 = 0.032108013f * t5;
    const float t37 = t32 + t34;
    const float t38 = t37 + t36;
    const float t39 = state->z2_omega;
    const float t41 = 1.0018027f * t39;
    const float t43 = -0.0033710722f * t7;
    const float t45 = 0.032128744f * work->t21;
    const float t47 = 0.03214804f * t5;
    const float t48 = t41 + t43;
    const float t49 = t48 + t45;
    const float t50 = t49 + t47;

    /* the reset, when a period is full */
    const uint32_t t51 = state->phase;
    work->t52 = (t51 < 49U) ? (t51 + 1U) : 0U;
    const int t54 = work->t52 == 0U;
    work->t56 = 1.87f * work->t30;
    const float t57 = t50 - work->t56;
    const float t58 = t38 - t57;
    const float t60 = 10.212608f * t58;
    const float t61 = t38 + t60;
    const int t62 = (-8.684609e35f <= t61) && (t61 <= 8.684609e35f);
    const float t63 = t61 + work->t56;
    work->t64 = t54 ? t61 : t38;
    work->t65 = t54 ? t63 : t50;
    const int t66 = !t62;
    const int t67 = t54 && t66;

    /* how much of the period is good */
    const int t68 = t29 || t67;
    const uint32_t t70 = (t0 < 51U) ? (t0 + 1U) : 51U;
    const int t71 = t0 == 0U;
    const uint32_t t72 = t71 ? 1U : t70;
    const int t73 = t2 || t4;
    const uint32_t t74 = t2 ? t70 : t72;
    const uint32_t t75 = t73 ? t74 : 0U;
    const uint32_t t76 = t68 ? 0U : t75;
    state->count = t76;
    const uint32_t t77 = state->clean;
    const uint32_t t78 = (t77 < 51U) ? (t77 + 1U) : 51U;
    const uint32_t t79 = t4 ? t78 : 0U;
    state->clean = t79;
    const int t80 = 50U < t79;
    const int t81 = t54 && t80;
    const uint32_t t82 = state->coasting;
    const uint32_t t83 = t81 ? 0U : t82;
    const uint32_t t84 = t4 ? t83 : 1U;
    state->coasting = t84;
    work->flags[0] = t84 == 0U;
    work->flags[1] = t76 < 2U;
    work->flags[2] = 50U < t76;
}

/* Part 2 of a step. */
static void pendulum_impulsive_part_2(pendulum_impulsive_state *state, pendulum_impulsive_work *work)
{
    /* for the next call */
    const float t90 = work->flags[1] ? 0.0f : work->t64;
    const float t91 = 0.0f + work->t56;
    const float t92 = work->flags[1] ? t91 : work->t65;
    state->z1_omega = t90;
    state->z2_omega = t92;
    const uint32_t t93 = work->flags[1] ? 0U : work->t52;
    state->phase = t93;
    state->theta_1 = work->t30;
    state->sin_theta_1 = work->t21;

    /* the estimate; until it has converged, the start */
    work->t94 = work->flags[2] ? t90 : 0.0f;
    const pendulum_impulsive_status t98 = work->flags[0] ? PENDULUM_IMPULSIVE_CONVERGED : PENDULUM_IMPULSIVE_COASTING;
    work->t99 = work->flags[2] ? t98 : PENDULUM_IMPULSIVE_CONVERGING;
}

void pendulum_impulsive_init(pendulum_impulsive_state *state)
{
    state->z1_omega = 0.0f;
    state->z2_omega = 0.0f;
    state->theta_1 = 0.0f;
    state->sin_theta_1 = 0.0f;
    state->phase = 0U;
    state->count = 0U;
    state->clean = 0U;
    state->coasting = 0U;
}

void pendulum_impulsive_step(pendulum_impulsive_state *state, const pendulum_impulsive_measurements *measurements,
                             pendulum_impulsive_estimate *estimate)
{
    pendulum_impulsive_work work;
    pendulum_impulsive_part_1(state, measurements, &work);
    pendulum_impulsive_part_2(state, &work);

    estimate->theta = work.t30;
    estimate->omega = work.t94;
    estimate->status = work.t99;
}
