/* arm_resets.c: Finite-time observer: An arm that goes round, by two copies that are reset: raw counts, and now and then nonsense.
 *
 * Generated; arm_resets.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "arm_resets.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "arm_resets.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "arm_resets.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* The bits of a number. */
typedef union {
    float value;
    uint32_t bits;
} arm_resets_f32_cell_t;

/* The bits of a number. */
static uint32_t arm_resets_f32_to_bits(float x)
{
    arm_resets_f32_cell_t cell;
    cell.value = x;
    return cell.bits;
}

/* The bit of the sign. */
#define ARM_RESETS_SIGN_F32 UINT32_C(0x80000000)

/* The bits of the largest magnitude. */
#define ARM_RESETS_MAGNITUDE_F32 UINT32_C(0x7FFFFFFF)

/* The bits of infinity. */
#define ARM_RESETS_INFINITY_F32 UINT32_C(0x7F800000)

/* The bits of the only NaN that is returned. */
#define ARM_RESETS_NAN_F32 UINT32_C(0x7FC00000)

/* The number with these bits. */
static float arm_resets_f32_from_bits(uint32_t bits)
{
    arm_resets_f32_cell_t cell;
    cell.bits = bits;
    return cell.value;
}

/* The number significand / 2^63 * 2^exponent, with the top bit of the significand set. */
typedef struct {
    uint64_t significand;
    int32_t exponent;
} arm_resets_scaled_t;

/* A number with a sign. */
typedef struct {
    arm_resets_scaled_t magnitude;
    int negative;
} arm_resets_signed_t;

/* The angle quadrant * pi/2 + rest. */
typedef struct {
    arm_resets_signed_t rest;
    uint32_t quadrant;
} arm_resets_turned_t;

/* Attaches a sign. */
static arm_resets_signed_t arm_resets_signed(arm_resets_scaled_t magnitude, int negative)
{
    arm_resets_signed_t result;
    result.magnitude = magnitude;
    result.negative = negative;
    return result;
}

/* A number below 1 as fixed point with 64 fraction bits. */
static uint64_t arm_resets_fraction(arm_resets_scaled_t a)
{
    const int32_t shift = -1 - a.exponent;
    if (shift > 63) {
        return 0;
    }
    return a.significand >> shift;
}

/* The upper half of the product, at most 2 too small. */
static uint64_t arm_resets_mul_high(uint64_t a, uint64_t b)
{
    const uint64_t a_high = a >> 32;
    const uint64_t a_low = a & 0xFFFFFFFFu;
    const uint64_t b_high = b >> 32;
    const uint64_t b_low = b & 0xFFFFFFFFu;
    const uint64_t cross = ((a_high * b_low) >> 32) + ((a_low * b_high) >> 32);
    return a_high * b_high + cross;
}

/* The square of a number below 1 as fixed point with 64 fraction bits. */
static uint64_t arm_resets_squared_fraction(arm_resets_scaled_t a)
{
    const uint64_t x = arm_resets_fraction(a);
    return arm_resets_mul_high(x, x);
}

/* Makes a number of a significand that has its top bit set. */
static arm_resets_scaled_t arm_resets_scaled(uint64_t significand, int32_t exponent)
{
    arm_resets_scaled_t result;
    result.significand = significand;
    result.exponent = exponent;
    return result;
}

/* Makes a number of a significand of at least 2^62. */
static arm_resets_scaled_t arm_resets_settled(uint64_t significand, int32_t exponent)
{
    if ((significand >> 63) == 0) {
        return arm_resets_scaled(significand << 1, exponent - 1);
    }
    return arm_resets_scaled(significand, exponent);
}

/* (1 - cos(r)) / r^2 in powers of -r^2. */
static const uint64_t ARM_RESETS_COSINE[8] = {
    UINT64_C(0x8000000000000000), UINT64_C(0x0AAAAAAAAAAAAAA8), UINT64_C(0x005B05B05B05B02B),
    UINT64_C(0x0001A01A01A01865), UINT64_C(0x0000049F93EDD666), UINT64_C(0x00000008F76C6243),
    UINT64_C(0x000000000C9C9706), UINT64_C(0x00000000000D551B)};

/* cos(r) for 0 < r <= pi/4, relative error below 2^-60. */
static arm_resets_scaled_t arm_resets_cosine(arm_resets_scaled_t r)
{
    const uint64_t z = arm_resets_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = ARM_RESETS_COSINE[6] - ((ARM_RESETS_COSINE[7] * z_high) >> 32);
    const uint64_t c5 = ARM_RESETS_COSINE[5] - ((tail * z_high) >> 32);
    const uint64_t c4 = ARM_RESETS_COSINE[4] - arm_resets_mul_high(c5, z);
    const uint64_t c3 = ARM_RESETS_COSINE[3] - arm_resets_mul_high(c4, z);
    const uint64_t c2 = ARM_RESETS_COSINE[2] - arm_resets_mul_high(c3, z);
    const uint64_t c1 = ARM_RESETS_COSINE[1] - arm_resets_mul_high(c2, z);
    const uint64_t c0 = ARM_RESETS_COSINE[0] - arm_resets_mul_high(c1, z);
    return arm_resets_settled((UINT64_C(1) << 63) - (arm_resets_mul_high(c0, z) >> 1), 0);
}

/* (1 - sin(r) / r) / r^2 in powers of -r^2. */
static const uint64_t ARM_RESETS_SINE[7] = {
    UINT64_C(0x2AAAAAAAAAAAAAA6), UINT64_C(0x0222222222222160), UINT64_C(0x000D00D00D00C575),
    UINT64_C(0x00002E3BC74A673D), UINT64_C(0x0000006B9914A637), UINT64_C(0x00000000B090498C),
    UINT64_C(0x0000000000D552BC)};

/* sin(r) for 0 < r <= pi/4, relative error below 2^-60. */
static arm_resets_scaled_t arm_resets_sine(arm_resets_scaled_t r)
{
    const uint64_t z = arm_resets_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = ARM_RESETS_SINE[5] - ((ARM_RESETS_SINE[6] * z_high) >> 32);
    const uint64_t c4 = ARM_RESETS_SINE[4] - ((tail * z_high) >> 32);
    const uint64_t c3 = ARM_RESETS_SINE[3] - arm_resets_mul_high(c4, z);
    const uint64_t c2 = ARM_RESETS_SINE[2] - arm_resets_mul_high(c3, z);
    const uint64_t c1 = ARM_RESETS_SINE[1] - arm_resets_mul_high(c2, z);
    const uint64_t c0 = ARM_RESETS_SINE[0] - arm_resets_mul_high(c1, z);
    const uint64_t lost = arm_resets_mul_high(r.significand, arm_resets_mul_high(c0, z));
    return arm_resets_settled(r.significand - lost, r.exponent);
}

/* The sine of an angle. */
static arm_resets_signed_t arm_resets_sine_at(arm_resets_turned_t angle)
{
    const int back = (angle.quadrant & 2) != 0;
    if ((angle.quadrant & 1) != 0) {
        return arm_resets_signed(arm_resets_cosine(angle.rest.magnitude), back);
    }
    return arm_resets_signed(arm_resets_sine(angle.rest.magnitude), back != angle.rest.negative);
}

/* Makes an angle of its parts. */
static arm_resets_turned_t arm_resets_turned(arm_resets_signed_t rest, uint32_t quadrant)
{
    arm_resets_turned_t result;
    result.rest = rest;
    result.quadrant = quadrant;
    return result;
}

/* The number of zero bits above the highest one bit; x is not 0. */
static int32_t arm_resets_leading_zeros(uint64_t x)
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
static arm_resets_scaled_t arm_resets_normalised(uint64_t significand, int32_t exponent)
{
    const int32_t shift = arm_resets_leading_zeros(significand);
    return arm_resets_scaled(significand << shift, exponent - shift);
}

/* The finite positive number with these bits, not 0; exact. */
static arm_resets_scaled_t arm_resets_unpacked_f32(uint32_t magnitude)
{
    const int32_t field = (int32_t)(magnitude >> 23);
    const uint64_t digits = (uint64_t)magnitude << 40;
    if (field == 0) {
        return arm_resets_normalised(digits, -126);
    }
    return arm_resets_scaled(digits | (UINT64_C(1) << 63), field - 127);
}

/* 2/pi after 32 zero bits. */
static const uint32_t ARM_RESETS_TWO_OVER_PI_F32[9] = {
    UINT32_C(0x00000000), UINT32_C(0xA2F9836E), UINT32_C(0x4E441529),
    UINT32_C(0xFC2757D1), UINT32_C(0xF534DDC0), UINT32_C(0xDB629599),
    UINT32_C(0x3C439041), UINT32_C(0xFE5163AB), UINT32_C(0xDEBBC561)};

/* 32 bits of 2/pi from bit 32 slot + shift on. */
static uint64_t arm_resets_window_f32(uint32_t slot, uint32_t shift)
{
    const uint64_t first = (uint64_t)(ARM_RESETS_TWO_OVER_PI_F32[slot]);
    const uint64_t second = (uint64_t)(ARM_RESETS_TWO_OVER_PI_F32[slot + 1]);
    return (((first << 32) | second) >> (32 - shift)) & 0xFFFFFFFFu;
}

/* a b, relative error below 2^-60. */
static arm_resets_scaled_t arm_resets_product(arm_resets_scaled_t a, arm_resets_scaled_t b)
{
    return arm_resets_settled(arm_resets_mul_high(a.significand, b.significand),
                            a.exponent + b.exponent + 1);
}

/* pi with 62 fraction bits; as a significand also pi/2 and pi/4. */
#define ARM_RESETS_PI UINT64_C(0xC90FDAA22168C235)

/* The angle of (high, low) / 2^126 quarter turns, its rest exact to 2^-60 of itself. */
static arm_resets_turned_t arm_resets_turned_from_quarters(uint64_t high, uint64_t low)
{
    const uint64_t eighths = high >> 61;
    const int negative = (eighths & 1) != 0;
    uint64_t upper = (high << 2) | (low >> 62);
    uint64_t lower = low << 2;
    if (negative) {
        upper = (lower == 0) ? (UINT64_C(0) - upper) : UINT64_MAX - upper;
        lower = (UINT64_C(0) - lower);
    }
    const int32_t shift = arm_resets_leading_zeros(upper | 1);
    const uint64_t significand = (upper << shift) | ((lower >> 1) >> (63 - shift));
    const arm_resets_signed_t rest = arm_resets_signed(
        arm_resets_product(arm_resets_scaled(significand, -1 - shift), arm_resets_scaled(ARM_RESETS_PI, 0)),
        negative);
    return arm_resets_turned(rest, (uint32_t)(((eighths + 1) >> 1) & 3));
}

/* The angle with these bits, positive and finite, its rest exact to 2^-38 of itself. */
static arm_resets_turned_t arm_resets_reduce_f32(uint32_t magnitude)
{
    if (magnitude <= 0x3F490FDAu) {
        return arm_resets_turned(arm_resets_signed(arm_resets_unpacked_f32(magnitude), 0), 0);
    }
    const uint64_t digits = (uint64_t)((magnitude & 0x007FFFFFu) | 0x00800000u);
    const uint32_t start = (magnitude >> 23) - 120;
    const uint32_t slot = start >> 5;
    const uint32_t shift = start & 31;
    const uint64_t upper = (arm_resets_window_f32(slot, shift) * digits) << 32;
    const uint64_t middle = arm_resets_window_f32(slot + 1, shift) * digits;
    const uint64_t lower = arm_resets_window_f32(slot + 2, shift) * digits;
    return arm_resets_turned_from_quarters(((upper + middle) + (lower >> 32)), lower << 32);
}

/* x rounded to the nearest, ties to even, with subnormals and overflow, and the sign put in. */
static float arm_resets_rounded_f32(uint32_t sign, arm_resets_scaled_t x)
{
    const int32_t field = x.exponent + 127;
    if (field >= 255) {
        return arm_resets_f32_from_bits(sign | ARM_RESETS_INFINITY_F32);
    }
    const int32_t shift = (field > 0) ? 40 : 41 - field;
    if (shift > 63) {
        const int least = shift == 64 && x.significand > (UINT64_C(1) << 63);
        return arm_resets_f32_from_bits(least ? sign + 1 : sign);
    }
    const uint64_t kept = x.significand >> shift;
    const uint64_t rest = x.significand - (kept << shift);
    const uint64_t half = UINT64_C(1) << (shift - 1);
    const uint64_t odd = kept & 1;
    const uint64_t up = (rest + odd > half) ? 1 : 0;
    const uint32_t base = (field > 0) ? ((uint32_t)(field - 1)) << 23 : 0;
    return arm_resets_f32_from_bits(sign | (base + ((uint32_t)(kept + up))));
}

/* The sign bit of a negative number, else 0. */
static uint32_t arm_resets_sign_f32(int negative)
{
    if (negative) {
        return ARM_RESETS_SIGN_F32;
    }
    return 0;
}

/* Sine of an angle in radians, the nearest float. */
static float arm_resets_sin_f32(float x)
{
    const uint32_t bits = arm_resets_f32_to_bits(x);
    const uint32_t magnitude = bits & ARM_RESETS_MAGNITUDE_F32;
    if (magnitude >= ARM_RESETS_INFINITY_F32) {
        return arm_resets_f32_from_bits(ARM_RESETS_NAN_F32);
    }
    if (magnitude == 0) {
        return x;
    }
    const arm_resets_signed_t value = arm_resets_sine_at(arm_resets_reduce_f32(magnitude));
    return arm_resets_rounded_f32((bits & ARM_RESETS_SIGN_F32) ^ arm_resets_sign_f32(value.negative),
                                value.magnitude);
}

/* What one part of a step hands to the next. */
typedef struct {
    uint32_t t0;
    float t28;
    float t29;
    float t30;
    float t31;
    float t76;
    float t85;
    uint32_t t90;
    float t169;
    float t173;
    arm_resets_status t178;
    int flags[5]; /* t2, t26, t72, t74, t84 */
} arm_resets_work;

/* Part 1 of a step. */
static void arm_resets_part_1(arm_resets_state *state, const arm_resets_measurements *measurements, const arm_resets_inputs *inputs, arm_resets_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    work->t0 = state->count;
    work->flags[0] = 10U < work->t0;
    const uint32_t t3 = (uint32_t)measurements->encoder;
    const uint32_t t5 = state->count_encoder;
    const uint32_t t6 = state->within_encoder;
    const uint32_t t7 = t3 - t5;
    const uint32_t t10 = t7 + 2147483648U;
    const uint32_t t11 = t10 % 10000U;
    const uint32_t t12 = t6 + t11;
    const uint32_t t13 = t12 + 6352U;
    const uint32_t t14 = t13 % 10000U;
    const float t15 = (float)t14;
    const float t17 = t15 * 0.0001f;
    const float t19 = t17 + 1.2582912e7f;
    const float t20 = t19 - 1.2582912e7f;
    const float t22 = t20 * 10000.0f;
    const float t23 = t15 - t22;
    const float t24 = 0.0006283185f * t23;
    const float t25 = inputs->i;
    work->flags[1] = (-1e34f <= t25) && (t25 <= 1e34f);
    const float t27 = state->i_1;
    work->t28 = work->flags[1] ? t25 : t27;

    /* prediction, for a sample that is missing or not measured now */
    work->t29 = state->sin_q_1;
    work->t30 = state->z1_dq;
    work->t31 = state->encoder_1;
    const float t33 = 0.0049937554f * work->t30;
    const float t35 = 4.995836e-5f * work->t28;
    const float t37 = -8.161565e-5f * work->t29;
    const float t39 = -0.00016318032f * work->t29;
    const float t40 = t33 + work->t31;
    const float t41 = t35 + t37;
    const float t42 = t41 + t39;
    const float t43 = t40 + t42;
    const int t44 = (-6.2831855f <= t43) && (t43 <= 6.2831855f);
    const int t45 = work->flags[0] && t44;
    const float t46 = t45 ? t43 : work->t31;
    const float t47 = t24 - t46;
    const float t49 = t47 * 0.15915494f;
    const float t50 = t49 + 1.2582912e7f;
    const float t51 = t50 - 1.2582912e7f;
    const float t53 = t51 * 6.2831855f;
    const float t54 = t47 - t53;
    const float t55 = t46 + t54;
    const float t56 = t55 - t43;
    const float t57 = t56 * 0.15915494f;
    const float t58 = t57 + 1.2582912e7f;
    const float t59 = t58 - 1.2582912e7f;
    const float t60 = t59 * 6.2831855f;
    const float t61 = t56 - t60;
    const int t62 = (-0.3f <= t61) && (t61 <= 0.3f);
    const int t63 = !t62;
    const int t64 = t44 && t63;
    const int t65 = work->flags[0] && t64;
    const uint32_t t66 = state->rejected_encoder;
    const int t68 = t66 < 10U;
    const int t69 = t65 && t68;
    const uint32_t t70 = (t66 < 11U) ? (t66 + 1U) : 11U;
    const uint32_t t71 = t69 ? t70 : 0U;
    state->rejected_encoder = t71;
    work->flags[2] = !t69;
    const int t73 = !t68;
    work->flags[3] = t65 && t73;
    const float t75 = work->flags[2] ? t55 : t46;
    work->t76 = arm_resets_sin_f32(t75);
    const float t77 = work->t76 - work->t29;
    const float t78 = -8.161565e-5f * t77;
    const float t79 = t43 + t78;
    const int t80 = (-6.2831855f <= t79) && (t79 <= 6.2831855f);
    const int t81 = work->flags[0] && t80;
    const float t82 = t81 ? t79 : work->t31;
    const int t83 = work->flags[2] || t81;
    work->flags[4] = !t83;
    work->t85 = work->flags[2] ? t55 : t82;
    const uint32_t t86 = work->flags[2] ? t3 : t5;
    state->count_encoder = t86;
    const uint32_t t87 = work->flags[2] ? t14 : t6;
    state->within_encoder = t87;
    const uint32_t t88 = state->since;
    const uint32_t t89 = (t88 < 4294967295U) ? (t88 + 1U) : 4294967295U;
    work->t90 = work->flags[2] ? 0U : t89;
    state->since = work->t90;
}

/* Part 2 of a step. */
static void arm_resets_part_2(arm_resets_state *state, arm_resets_work *work)
{
    /* both copies, one call on */
    const float t92 = 0.9975031f * work->t30;
    const float t94 = 0.019975021f * work->t28;
    const float t96 = -0.048959192f * work->t76;
    const float t98 = -0.04891841f * work->t29;
    const float t99 = t92 + t94;
    const float t100 = t99 + t96;
    const float t101 = t100 + t98;
    const float t102 = state->z2_dq;
    const float t104 = 1.0068414f * t102;
    const float t106 = -0.012793502f * work->t31;
    const float t108 = 0.020068442f * work->t28;
    const float t110 = -0.049111813f * work->t76;
    const float t112 = -0.049223557f * work->t29;
    const float t113 = t104 + t106;
    const float t114 = t108 + t110;
    const float t115 = t114 + t112;
    const float t116 = t113 + t115;

    /* the reset, when a period is full */
    const uint32_t t117 = state->phase;
    const uint32_t t118 = (t117 < 9U) ? (t117 + 1U) : 0U;
    const int t119 = t118 == 0U;
    const float t121 = 1.87f * work->t85;
    const float t122 = t116 - t121;
    const float t123 = t101 - t122;
    const float t125 = 10.239511f * t123;
    const float t126 = t101 + t125;
    const int t127 = (-8.318399e35f <= t126) && (t126 <= 8.318399e35f);
    const float t128 = t126 + t121;
    const float t129 = t119 ? t126 : t101;
    const float t130 = t119 ? t128 : t116;
    const int t131 = !t127;
    const int t132 = t119 && t131;

    /* how much of the period is good */
    const int t133 = !work->flags[3];
    const int t134 = work->flags[0] && t133;
    const int t135 = work->flags[1] && t133;
    const int t136 = work->flags[4] || t132;
    const uint32_t t138 = (work->t0 < 11U) ? (work->t0 + 1U) : 11U;
    const int t139 = work->t0 == 0U;
    const int t140 = !t135;
    const int t141 = t139 || t140;
    const uint32_t t142 = t141 ? 1U : t138;
    const int t143 = t134 || work->flags[2];
    const uint32_t t144 = t134 ? t138 : t142;
    const uint32_t t145 = t143 ? t144 : 0U;
    const uint32_t t146 = t136 ? 0U : t145;
    state->count = t146;
    const uint32_t t147 = state->clean;
    const uint32_t t148 = (t147 < 11U) ? (t147 + 1U) : 11U;
    const uint32_t t149 = t135 ? t148 : 1U;
    const uint32_t t150 = work->flags[2] ? t149 : 0U;
    state->clean = t150;
    const int t151 = work->flags[2] && t135;
    const int t152 = 10U < t150;
    const int t153 = t119 && t152;
    const uint32_t t154 = state->coasting;
    const uint32_t t155 = t153 ? 0U : t154;
    const uint32_t t156 = t151 ? t155 : 1U;
    state->coasting = t156;
    const int t157 = t156 == 0U;
    const int t159 = t146 < 2U;
    const int t160 = 10U < t146;

    /* for the next call */
    const float t162 = t159 ? 0.0f : t129;
    const float t163 = 0.0f + t121;
    const float t164 = t159 ? t163 : t130;
    const float t165 = work->t85 * 0.15915494f;
    const float t166 = t165 + 1.2582912e7f;
    const float t167 = t166 - 1.2582912e7f;
    const float t168 = t167 * 6.2831855f;
    work->t169 = work->t85 - t168;
    const float t170 = 1.87f * t168;
    const float t171 = t164 - t170;
    state->z1_dq = t162;
    state->z2_dq = t171;
    const uint32_t t172 = t159 ? 0U : t118;
    state->phase = t172;
    state->encoder_1 = work->t169;
    state->i_1 = work->t28;
    state->sin_q_1 = work->t76;

    /* the estimate; until it has converged, the start */
    work->t173 = t160 ? t162 : 0.0f;
    const arm_resets_status t177 = t157 ? ARM_RESETS_CONVERGED : ARM_RESETS_COASTING;
    work->t178 = t160 ? t177 : ARM_RESETS_CONVERGING;
}

void arm_resets_init(arm_resets_state *state)
{
    state->z1_dq = 0.0f;
    state->z2_dq = 0.0f;
    state->count_encoder = 0U;
    state->within_encoder = 0U;
    state->encoder_1 = 0.0f;
    state->i_1 = 0.0f;
    state->sin_q_1 = 0.0f;
    state->phase = 0U;
    state->count = 0U;
    state->clean = 0U;
    state->coasting = 0U;
    state->since = 0U;
    state->rejected_encoder = 0U;
}

void arm_resets_step(arm_resets_state *state, const arm_resets_measurements *measurements,
                     const arm_resets_inputs *inputs, arm_resets_estimate *estimate)
{
    arm_resets_work work;
    arm_resets_part_1(state, measurements, inputs, &work);
    arm_resets_part_2(state, &work);

    estimate->q = work.t169;
    estimate->dq = work.t173;
    estimate->coasted = work.t90;
    estimate->status = work.t178;
}
