/* lossy_arm.c: Finite-time observer: Speed of an arm from an absolute encoder that wraps and loses frames.
 *
 * Generated; lossy_arm.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "lossy_arm.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "lossy_arm.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "lossy_arm.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* orthonormal rows of the window, oldest first
 *   [0] y in direction 1
 *   [1] y in direction 2
 */
static const float LOSSY_ARM_ROWS[25][2] = {
    { 0.19611613f, -0.30269817f },
    { 0.19611613f, -0.2759701f },
    { 0.19611613f, -0.24929541f },
    { 0.19611613f, -0.22267404f },
    { 0.19611613f, -0.19610587f },
    { 0.19611613f, -0.16959076f },
    { 0.19611613f, -0.14312863f },
    { 0.19611613f, -0.11671939f },
    { 0.19611613f, -0.0903629f },
    { 0.19611613f, -0.06405908f },
    { 0.19611613f, -0.037807807f },
    { 0.19611613f, -0.011608985f },
    { 0.19611613f, 0.01453749f },
    { 0.19611613f, 0.040631723f },
    { 0.19611613f, 0.06667382f },
    { 0.19611613f, 0.09266389f },
    { 0.19611613f, 0.11860202f },
    { 0.19611613f, 0.14448833f },
    { 0.19611613f, 0.17032292f },
    { 0.19611613f, 0.19610591f },
    { 0.19611613f, 0.22183737f },
    { 0.19611613f, 0.24751742f },
    { 0.19611613f, 0.27314615f },
    { 0.19611613f, 0.2987237f },
    { 0.19611613f, 0.32425013f }
};

/* The bits of a number. */
typedef union {
    float value;
    uint32_t bits;
} lossy_arm_f32_cell_t;

/* The bits of a number. */
static uint32_t lossy_arm_f32_to_bits(float x)
{
    lossy_arm_f32_cell_t cell;
    cell.value = x;
    return cell.bits;
}

/* Bits of the sign, of the largest magnitude, of infinity, of the only NaN returned, of 1. */
#define LOSSY_ARM_SIGN_F32 UINT32_C(0x80000000)
#define LOSSY_ARM_MAGNITUDE_F32 UINT32_C(0x7FFFFFFF)
#define LOSSY_ARM_INFINITY_F32 UINT32_C(0x7F800000)
#define LOSSY_ARM_NAN_F32 UINT32_C(0x7FC00000)
#define LOSSY_ARM_ONE_F32 UINT32_C(0x3F800000)

/* The number with these bits. */
static float lossy_arm_f32_from_bits(uint32_t bits)
{
    lossy_arm_f32_cell_t cell;
    cell.bits = bits;
    return cell.value;
}

/* The number significand / 2^63 * 2^exponent, with the top bit of the significand set. */
typedef struct {
    uint64_t significand;
    int32_t exponent;
} lossy_arm_scaled_t;

/* A number with a sign. */
typedef struct {
    lossy_arm_scaled_t magnitude;
    int negative;
} lossy_arm_signed_t;

/* The angle quadrant * pi/2 + rest. */
typedef struct {
    lossy_arm_signed_t rest;
    uint32_t quadrant;
} lossy_arm_turned_t;

/* Attaches a sign. */
static lossy_arm_signed_t lossy_arm_signed(lossy_arm_scaled_t magnitude, int negative)
{
    lossy_arm_signed_t result;
    result.magnitude = magnitude;
    result.negative = negative;
    return result;
}

/* A number below 1 as fixed point with 64 fraction bits. */
static uint64_t lossy_arm_fraction(lossy_arm_scaled_t a)
{
    const int32_t shift = -1 - a.exponent;
    if (shift > 63) {
        return 0;
    }
    return a.significand >> shift;
}

/* The upper half of the product, at most 2 too small. */
static uint64_t lossy_arm_mul_high(uint64_t a, uint64_t b)
{
    const uint64_t a_high = a >> 32;
    const uint64_t a_low = a & 0xFFFFFFFFu;
    const uint64_t b_high = b >> 32;
    const uint64_t b_low = b & 0xFFFFFFFFu;
    const uint64_t cross = ((a_high * b_low) >> 32) + ((a_low * b_high) >> 32);
    return a_high * b_high + cross;
}

/* The square of a number below 1 as fixed point with 64 fraction bits. */
static uint64_t lossy_arm_squared_fraction(lossy_arm_scaled_t a)
{
    const uint64_t x = lossy_arm_fraction(a);
    return lossy_arm_mul_high(x, x);
}

/* Makes a number of a significand that has its top bit set. */
static lossy_arm_scaled_t lossy_arm_scaled(uint64_t significand, int32_t exponent)
{
    lossy_arm_scaled_t result;
    result.significand = significand;
    result.exponent = exponent;
    return result;
}

/* Makes a number of a significand of at least 2^62. */
static lossy_arm_scaled_t lossy_arm_settled(uint64_t significand, int32_t exponent)
{
    if ((significand >> 63) == 0) {
        return lossy_arm_scaled(significand << 1, exponent - 1);
    }
    return lossy_arm_scaled(significand, exponent);
}

/* (1 - cos(r)) / r^2 in powers of -r^2. */
static const uint64_t LOSSY_ARM_COSINE[8] = {
    UINT64_C(0x8000000000000000), UINT64_C(0x0AAAAAAAAAAAAAA8), UINT64_C(0x005B05B05B05B02B),
    UINT64_C(0x0001A01A01A01865), UINT64_C(0x0000049F93EDD666), UINT64_C(0x00000008F76C6243),
    UINT64_C(0x000000000C9C9706), UINT64_C(0x00000000000D551B)};

/* cos(r) for 0 < r <= pi/4, relative error below 2^-60. */
static lossy_arm_scaled_t lossy_arm_cosine(lossy_arm_scaled_t r)
{
    const uint64_t z = lossy_arm_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = LOSSY_ARM_COSINE[6] - ((LOSSY_ARM_COSINE[7] * z_high) >> 32);
    const uint64_t c5 = LOSSY_ARM_COSINE[5] - ((tail * z_high) >> 32);
    const uint64_t c4 = LOSSY_ARM_COSINE[4] - lossy_arm_mul_high(c5, z);
    const uint64_t c3 = LOSSY_ARM_COSINE[3] - lossy_arm_mul_high(c4, z);
    const uint64_t c2 = LOSSY_ARM_COSINE[2] - lossy_arm_mul_high(c3, z);
    const uint64_t c1 = LOSSY_ARM_COSINE[1] - lossy_arm_mul_high(c2, z);
    const uint64_t c0 = LOSSY_ARM_COSINE[0] - lossy_arm_mul_high(c1, z);
    return lossy_arm_settled((UINT64_C(1) << 63) - (lossy_arm_mul_high(c0, z) >> 1), 0);
}

/* (1 - sin(r) / r) / r^2 in powers of -r^2. */
static const uint64_t LOSSY_ARM_SINE[7] = {
    UINT64_C(0x2AAAAAAAAAAAAAA6), UINT64_C(0x0222222222222160), UINT64_C(0x000D00D00D00C575),
    UINT64_C(0x00002E3BC74A673D), UINT64_C(0x0000006B9914A637), UINT64_C(0x00000000B090498C),
    UINT64_C(0x0000000000D552BC)};

/* sin(r) for 0 < r <= pi/4, relative error below 2^-60. */
static lossy_arm_scaled_t lossy_arm_sine(lossy_arm_scaled_t r)
{
    const uint64_t z = lossy_arm_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = LOSSY_ARM_SINE[5] - ((LOSSY_ARM_SINE[6] * z_high) >> 32);
    const uint64_t c4 = LOSSY_ARM_SINE[4] - ((tail * z_high) >> 32);
    const uint64_t c3 = LOSSY_ARM_SINE[3] - lossy_arm_mul_high(c4, z);
    const uint64_t c2 = LOSSY_ARM_SINE[2] - lossy_arm_mul_high(c3, z);
    const uint64_t c1 = LOSSY_ARM_SINE[1] - lossy_arm_mul_high(c2, z);
    const uint64_t c0 = LOSSY_ARM_SINE[0] - lossy_arm_mul_high(c1, z);
    const uint64_t lost = lossy_arm_mul_high(r.significand, lossy_arm_mul_high(c0, z));
    return lossy_arm_settled(r.significand - lost, r.exponent);
}

/* The sine of an angle. */
static lossy_arm_signed_t lossy_arm_sine_at(lossy_arm_turned_t angle)
{
    const int back = (angle.quadrant & 2) != 0;
    if ((angle.quadrant & 1) != 0) {
        return lossy_arm_signed(lossy_arm_cosine(angle.rest.magnitude), back);
    }
    return lossy_arm_signed(lossy_arm_sine(angle.rest.magnitude), back != angle.rest.negative);
}

/* Makes an angle of its parts. */
static lossy_arm_turned_t lossy_arm_turned(lossy_arm_signed_t rest, uint32_t quadrant)
{
    lossy_arm_turned_t result;
    result.rest = rest;
    result.quadrant = quadrant;
    return result;
}

/* The number of zero bits above the highest one bit; x is not 0. */
static int32_t lossy_arm_leading_zeros(uint64_t x)
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
static lossy_arm_scaled_t lossy_arm_normalised(uint64_t significand, int32_t exponent)
{
    const int32_t shift = lossy_arm_leading_zeros(significand);
    return lossy_arm_scaled(significand << shift, exponent - shift);
}

/* The finite positive number with these bits, not 0; exact. */
static lossy_arm_scaled_t lossy_arm_unpacked_f32(uint32_t magnitude)
{
    const int32_t field = (int32_t)(magnitude >> 23);
    const uint64_t digits = (uint64_t)magnitude << 40;
    if (field == 0) {
        return lossy_arm_normalised(digits, -126);
    }
    return lossy_arm_scaled(digits | (UINT64_C(1) << 63), field - 127);
}

/* 2/pi after 32 zero bits. */
static const uint32_t LOSSY_ARM_TWO_OVER_PI_F32[9] = {
    UINT32_C(0x00000000), UINT32_C(0xA2F9836E), UINT32_C(0x4E441529),
    UINT32_C(0xFC2757D1), UINT32_C(0xF534DDC0), UINT32_C(0xDB629599),
    UINT32_C(0x3C439041), UINT32_C(0xFE5163AB), UINT32_C(0xDEBBC561)};

/* 32 bits of 2/pi from bit 32 slot + shift on. */
static uint64_t lossy_arm_window_f32(uint32_t slot, uint32_t shift)
{
    const uint64_t first = (uint64_t)(LOSSY_ARM_TWO_OVER_PI_F32[slot]);
    const uint64_t second = (uint64_t)(LOSSY_ARM_TWO_OVER_PI_F32[slot + 1]);
    return (((first << 32) | second) >> (32 - shift)) & 0xFFFFFFFFu;
}

/* a b, relative error below 2^-60. */
static lossy_arm_scaled_t lossy_arm_product(lossy_arm_scaled_t a, lossy_arm_scaled_t b)
{
    return lossy_arm_settled(lossy_arm_mul_high(a.significand, b.significand),
                            a.exponent + b.exponent + 1);
}

/* pi with 62 fraction bits; as a significand also pi/2 and pi/4. */
#define LOSSY_ARM_PI UINT64_C(0xC90FDAA22168C235)

/* The angle of (high, low) / 2^126 quarter turns, its rest exact to 2^-60 of itself. */
static lossy_arm_turned_t lossy_arm_turned_from_quarters(uint64_t high, uint64_t low)
{
    const uint64_t eighths = high >> 61;
    const int negative = (eighths & 1) != 0;
    uint64_t upper = (high << 2) | (low >> 62);
    uint64_t lower = low << 2;
    if (negative) {
        upper = (lower == 0) ? (UINT64_C(0) - upper) : UINT64_MAX - upper;
        lower = (UINT64_C(0) - lower);
    }
    const int32_t shift = lossy_arm_leading_zeros(upper | 1);
    const uint64_t significand = (upper << shift) | ((lower >> 1) >> (63 - shift));
    const lossy_arm_signed_t rest = lossy_arm_signed(
        lossy_arm_product(lossy_arm_scaled(significand, -1 - shift), lossy_arm_scaled(LOSSY_ARM_PI, 0)),
        negative);
    return lossy_arm_turned(rest, (uint32_t)(((eighths + 1) >> 1) & 3));
}

/* The angle with these bits, positive and finite, its rest exact to 2^-38 of itself. */
static lossy_arm_turned_t lossy_arm_reduce_f32(uint32_t magnitude)
{
    if (magnitude <= 0x3F490FDAu) {
        return lossy_arm_turned(lossy_arm_signed(lossy_arm_unpacked_f32(magnitude), 0), 0);
    }
    const uint64_t digits = (uint64_t)((magnitude & 0x007FFFFFu) | 0x00800000u);
    const uint32_t start = (magnitude >> 23) - 120;
    const uint32_t slot = start >> 5;
    const uint32_t shift = start & 31;
    const uint64_t upper = (lossy_arm_window_f32(slot, shift) * digits) << 32;
    const uint64_t middle = lossy_arm_window_f32(slot + 1, shift) * digits;
    const uint64_t lower = lossy_arm_window_f32(slot + 2, shift) * digits;
    return lossy_arm_turned_from_quarters(((upper + middle) + (lower >> 32)), lower << 32);
}

/* x rounded to the nearest, ties to even, with subnormals and overflow, and the sign put in. */
static float lossy_arm_rounded_f32(uint32_t sign, lossy_arm_scaled_t x)
{
    const int32_t field = x.exponent + 127;
    if (field >= 255) {
        return lossy_arm_f32_from_bits(sign | LOSSY_ARM_INFINITY_F32);
    }
    const int32_t shift = (field > 0) ? 40 : 41 - field;
    if (shift > 63) {
        const int least = shift == 64 && x.significand > (UINT64_C(1) << 63);
        return lossy_arm_f32_from_bits(least ? sign + 1 : sign);
    }
    const uint64_t kept = x.significand >> shift;
    const uint64_t rest = x.significand - (kept << shift);
    const uint64_t half = UINT64_C(1) << (shift - 1);
    const uint64_t odd = kept & 1;
    const uint64_t up = (rest + odd > half) ? 1 : 0;
    const uint32_t base = (field > 0) ? ((uint32_t)(field - 1)) << 23 : 0;
    return lossy_arm_f32_from_bits(sign | (base + ((uint32_t)(kept + up))));
}

/* The sign bit of a negative number, else 0. */
static uint32_t lossy_arm_sign_f32(int negative)
{
    if (negative) {
        return LOSSY_ARM_SIGN_F32;
    }
    return 0;
}

/* Sine of an angle in radians, the nearest float. */
static float lossy_arm_sin_f32(float x)
{
    const uint32_t bits = lossy_arm_f32_to_bits(x);
    const uint32_t magnitude = bits & LOSSY_ARM_MAGNITUDE_F32;
    if (magnitude >= LOSSY_ARM_INFINITY_F32) {
        return lossy_arm_f32_from_bits(LOSSY_ARM_NAN_F32);
    }
    if (magnitude == 0) {
        return x;
    }
    const lossy_arm_signed_t value = lossy_arm_sine_at(lossy_arm_reduce_f32(magnitude));
    return lossy_arm_rounded_f32((bits & LOSSY_ARM_SIGN_F32) ^ lossy_arm_sign_f32(value.negative),
                                value.magnitude);
}

/* What one part of a step hands to the next. */
typedef struct {
    uint32_t t22;
    float t53;
    float t56;
    float t59;
    float t62;
    float t68;
    uint32_t t76;
    float t105;
    float t106;
    float t107;
    float t108;
    float t109;
    float t110;
    float t111;
    float t112;
    float t215;
    float t216;
    lossy_arm_status t224;
    int flags[2]; /* t37, t88 */
} lossy_arm_work;

/* Part 1 of a step. */
static void lossy_arm_part_1(lossy_arm_state *state, const lossy_arm_measurements *measurements, const lossy_arm_inputs *inputs, lossy_arm_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    const uint32_t t0 = state->newest;
    const uint32_t t1 = (t0 < 25U) ? t0 : 25U;
    const float t2 = measurements->y;
    const int t3 = (-6588397.5f <= t2) && (t2 <= 6588397.5f);
    const float t5 = t2 * 0.15915494f;
    const float t7 = t5 + 1.2582912e7f;
    const float t8 = t7 - 1.2582912e7f;
    const float t10 = t8 * 6.28125f;
    const float t11 = t2 - t10;
    const float t13 = t8 * 0.0019350052f;
    const float t14 = t11 - t13;
    const float t16 = t8 * 3.019916e-7f;
    const float t17 = t14 - t16;
    const float t18 = inputs->u;
    const int t19 = (-1e28f <= t18) && (t18 <= 1e28f);
    const float t20 = state->u[t1];
    const float t21 = t19 ? t18 : t20;
    work->t22 = (t1 < 25U) ? (t1 + 1U) : 0U;

    /* prediction of what the samples show */
    const float t23 = state->sin_q[t1];
    const float t24 = state->next_q;
    const float t26 = 1.5989339e-5f * t21;
    const float t28 = -2.332167e-5f * t23;
    const float t29 = t26 + t28;
    const float t30 = t24 + t29;
    const float t31 = state->next_dq;
    const float t33 = 0.01598401f * t21;
    const uint32_t t35 = state->known;
    work->flags[0] = t35 == 1U;
    const float t40 = state->y[t1];
    const float t41 = t30 * 0.15915494f;
    const float t42 = t41 + 1.2582912e7f;
    const float t43 = t42 - 1.2582912e7f;
    const float t45 = t43 * 6.2831855f;
    const float t46 = t30 - t45;
    const int t47 = (-6.2831855f <= t46) && (t46 <= 6.2831855f);
    const int t48 = work->flags[0] && t47;
    const float t49 = t48 ? t46 : t40;
    const float t50 = t3 ? t17 : t49;
    const float t51 = t3 ? 1.0f : 0.0f;
    const uint32_t t52 = state->count;
    work->t53 = lossy_arm_sin_f32(t50);
    const float t54 = -2.332167e-5f * work->t53;
    const float t55 = t26 + t54;
    work->t56 = t24 + t55;
    const float t57 = -0.03497668f * work->t53;
    const float t58 = t33 + t57;
    work->t59 = t31 + t58;
    const float t60 = work->t56 * 0.15915494f;
    const float t61 = t60 + 1.2582912e7f;
    work->t62 = t61 - 1.2582912e7f;
    const float t63 = work->t62 * 6.2831855f;
    const float t64 = work->t56 - t63;
    const int t65 = (-6.2831855f <= t64) && (t64 <= 6.2831855f);
    const int t66 = work->flags[0] && t65;
    const float t67 = t66 ? t64 : t50;
    work->t68 = t3 ? t17 : t67;
    const int t69 = !t3;
    const int t70 = !t65;
    const int t71 = work->flags[0] && t70;
    const int t72 = t69 && t71;
    const uint32_t t74 = state->since;
    const uint32_t t75 = (t74 < 4294967295U) ? (t74 + 1U) : 4294967295U;
    work->t76 = t3 ? 0U : t75;
    state->since = work->t76;

    /* how much of the window is good */
    const int t78 = 25U < t52;
    const uint32_t t79 = (t52 < 26U) ? (t52 + 1U) : 26U;
    const uint32_t t80 = t72 ? 0U : t79;
    const uint32_t t81 = t19 ? t79 : 1U;
    const uint32_t t82 = t78 ? t80 : t81;
    state->count = t82;
    const uint32_t t83 = state->coasting;
    const uint32_t t84 = (t83 > 0U) ? (t83 - 1U) : 0U;
    const uint32_t t85 = t19 ? t84 : 25U;
    const uint32_t t87 = t3 ? t85 : 26U;
    state->coasting = t87;

    /* into the window */
    state->newest = work->t22;
    state->y[work->t22] = work->t68;
    state->has_y[work->t22] = t51;
    state->u[work->t22] = t21;
    state->sin_q[work->t22] = work->t53;
    work->flags[1] = 25U < t82;
}

/* Part 2 of a step. */
static void lossy_arm_part_2(const lossy_arm_state *state, lossy_arm_work *work)
{
    /* rows of the window, oldest first; those without a sample count nothing */
    const uint32_t t89 = (work->t22 < 25U) ? (work->t22 + 1U) : 0U;
    const float t92 = state->has_y[t89];
    const float t93 = t92 * 0.19611613f;
    const float t94 = t92 * -0.32947975f;
    const float t95 = t93 * t93;
    const float t96 = 0.0f + t95;
    const float t97 = t93 * t94;
    const float t98 = 0.0f + t97;
    const float t99 = t94 * t94;
    const float t100 = 0.0f + t99;
    const float t101 = t93 * 0.0f;
    const float t102 = 0.0f + t101;
    const float t103 = t94 * 0.0f;
    const float t104 = 0.0f + t103;
    work->t105 = t96;
    work->t106 = t98;
    work->t107 = t100;
    work->t108 = t102;
    work->t109 = t104;
    work->t110 = 0.0f;
    work->t111 = 0.0f;
    work->t112 = 0.0f;
    uint32_t t113 = t89;
    for (uint32_t row = 0U; row < 25U; ++row) {
        const float *const gains = LOSSY_ARM_ROWS[row];
        const uint32_t t114 = (t113 < 25U) ? (t113 + 1U) : 0U;
        const float t115 = state->sin_q[t113];
        const float t116 = state->u[t114];
        const float t117 = state->sin_q[t114];
        const float t119 = 0.0019980012f * work->t111;
        const float t120 = work->t110 + t119;
        const float t122 = -4.6631685e-5f * t115;
        const float t123 = 1.5989339e-5f * t116;
        const float t124 = -2.332167e-5f * t117;
        const float t125 = t123 + t124;
        const float t126 = t120 + t122;
        const float t127 = t126 + t125;
        const float t129 = 0.998002f * work->t111;
        const float t131 = -0.034953367f * t115;
        const float t132 = 0.01598401f * t116;
        const float t133 = -0.03497668f * t117;
        const float t134 = t132 + t133;
        const float t135 = t129 + t131;
        const float t136 = t135 + t134;
        const float t137 = state->y[t113];
        const float t138 = state->y[t114];
        const float t139 = t138 - t137;
        const float t140 = t139 * 0.15915494f;
        const float t141 = t140 + 1.2582912e7f;
        const float t142 = t141 - 1.2582912e7f;
        const float t143 = t142 * 6.2831855f;
        const float t144 = t139 - t143;
        const float t145 = work->t112 + t144;
        const float t146 = gains[0];
        const float t147 = gains[1];
        const float t148 = state->has_y[t114];
        const float t149 = t145 - t127;
        const float t150 = t148 * t146;
        const float t151 = t148 * t147;
        const float t152 = t150 * t150;
        const float t153 = work->t105 + t152;
        const float t154 = t150 * t151;
        const float t155 = work->t106 + t154;
        const float t156 = t151 * t151;
        const float t157 = work->t107 + t156;
        const float t158 = t150 * t149;
        const float t159 = work->t108 + t158;
        const float t160 = t151 * t149;
        const float t161 = work->t109 + t160;
        work->t105 = t153;
        work->t106 = t155;
        work->t107 = t157;
        work->t108 = t159;
        work->t109 = t161;
        work->t110 = t127;
        work->t111 = t136;
        work->t112 = t145;
        t113 = t114;
    }
}

/* Part 3 of a step. */
static void lossy_arm_part_3(lossy_arm_state *state, lossy_arm_work *work)
{
    /* the window's start from the samples that are there */
    const int t163 = 0.015625f < work->t105;
    const float t164 = t163 ? work->t105 : 1.0f;
    const float t165 = work->t106 / t164;
    const float t166 = t165 * work->t106;
    const float t167 = work->t107 - t166;
    const float t168 = t165 * work->t108;
    const float t169 = work->t109 - t168;
    const int t170 = 0.015625f < t167;
    const int t171 = t163 && t170;
    const float t172 = t170 ? t167 : 1.0f;
    const float t173 = t169 / t172;
    const float t174 = work->t106 * t173;
    const float t175 = work->t108 - t174;
    const float t176 = t175 / t164;
    const float t177 = 0.19611613f * t176;
    const float t179 = 0.32425013f * t173;
    const float t180 = t177 + t179;
    const float t181 = t180 + work->t110;
    const float t183 = 12.750456f * t173;
    const float t184 = t183 + work->t111;
    const float t185 = state->y[work->t22];
    const float t186 = t185 - work->t112;
    const float t187 = t181 + t186;

    /* without enough samples, the model's prediction */
    const float t189 = work->t62 * -6.2831855f;
    const float t190 = work->t56 + t189;
    const int t191 = (-1e28f <= t190) && (t190 <= 1e28f);
    const int t192 = work->flags[0] && t191;
    const float t193 = t171 ? t187 : t190;
    const int t194 = (-1e28f <= work->t59) && (work->t59 <= 1e28f);
    const int t195 = t192 && t194;
    const float t196 = t171 ? t184 : work->t59;
    const int t197 = t171 || t195;
    const int t198 = work->flags[1] && t197;
    const uint32_t t199 = t198 ? 1U : 0U;
    state->known = t199;
    const float t201 = 0.0019980012f * t196;
    const float t202 = t193 + t201;
    const float t204 = -4.6631685e-5f * work->t53;
    const float t205 = t202 + t204;
    const int t206 = (-1e28f <= t205) && (t205 <= 1e28f);
    const float t207 = t206 ? t205 : 0.0f;
    state->next_q = t207;
    const float t209 = 0.998002f * t196;
    const float t211 = -0.034953367f * work->t53;
    const float t212 = t209 + t211;
    const int t213 = (-1e28f <= t212) && (t212 <= 1e28f);
    const float t214 = t213 ? t212 : 0.0f;
    state->next_dq = t214;

    /* the estimate; until there is one, the start */
    work->t215 = t198 ? t193 : work->t68;
    work->t216 = t198 ? t196 : 0.0f;
    const uint32_t t217 = state->coasting;
    const int t218 = t217 == 0U;
    const int t219 = t171 && t218;
    const lossy_arm_status t223 = t219 ? LOSSY_ARM_CONVERGED : LOSSY_ARM_COASTING;
    work->t224 = t198 ? t223 : LOSSY_ARM_CONVERGING;
}

void lossy_arm_init(lossy_arm_state *state)
{
    for (uint32_t slot = 0U; slot < 26U; ++slot) {
        state->y[slot] = 0.0f;
    }
    for (uint32_t slot = 0U; slot < 26U; ++slot) {
        state->u[slot] = 0.0f;
    }
    for (uint32_t slot = 0U; slot < 26U; ++slot) {
        state->sin_q[slot] = 0.0f;
    }
    state->newest = 25U;
    state->count = 0U;
    state->coasting = 0U;
    for (uint32_t slot = 0U; slot < 26U; ++slot) {
        state->has_y[slot] = 0.0f;
    }
    state->next_q = 0.0f;
    state->next_dq = 0.0f;
    state->known = 0U;
    state->since = 0U;
}

void lossy_arm_step(lossy_arm_state *state, const lossy_arm_measurements *measurements,
                    const lossy_arm_inputs *inputs, lossy_arm_estimate *estimate)
{
    lossy_arm_work work;
    lossy_arm_part_1(state, measurements, inputs, &work);
    lossy_arm_part_2(state, &work);
    lossy_arm_part_3(state, &work);

    estimate->q = work.t215;
    estimate->dq = work.t216;
    estimate->coasted = work.t76;
    estimate->status = work.t224;
}
