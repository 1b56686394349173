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
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
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

/* The bit of the sign. */
#define LOSSY_ARM_SIGN_F32 UINT32_C(0x80000000)

/* The bits of the largest magnitude. */
#define LOSSY_ARM_MAGNITUDE_F32 UINT32_C(0x7FFFFFFF)

/* The bits of infinity. */
#define LOSSY_ARM_INFINITY_F32 UINT32_C(0x7F800000)

/* The bits of the only NaN that is returned. */
#define LOSSY_ARM_NAN_F32 UINT32_C(0x7FC00000)

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
    uint32_t t1;
    float t17;
    float t21;
    uint32_t t22;
    float t73;
    float t76;
    float t79;
    float t82;
    float t92;
    uint32_t t95;
    float t97;
    uint32_t t107;
    float t131;
    float t132;
    float t133;
    float t134;
    float t135;
    float t136;
    float t137;
    float t138;
    float t139;
    float t251;
    float t254;
    float t292;
    float t293;
    lossy_arm_status t301;
    int flags[8]; /* t3, t19, t44, t113, t241, t243, t248, t249 */
} lossy_arm_work;

/* Part 1 of a step. */
static void lossy_arm_part_1(const lossy_arm_state *state, const lossy_arm_measurements *measurements, const lossy_arm_inputs *inputs, lossy_arm_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    const uint32_t t0 = state->newest;
    work->t1 = (t0 < 25U) ? t0 : 25U;
    const float t2 = measurements->y;
    work->flags[0] = (-6588397.5f <= t2) && (t2 <= 6588397.5f);
    const float t5 = t2 * 0.15915494f;
    const float t7 = t5 + 1.2582912e7f;
    const float t8 = t7 - 1.2582912e7f;
    const float t10 = t8 * 6.28125f;
    const float t11 = t2 - t10;
    const float t13 = t8 * 0.0019350052f;
    const float t14 = t11 - t13;
    const float t16 = t8 * 3.019916e-7f;
    work->t17 = t14 - t16;
    const float t18 = inputs->u;
    work->flags[1] = (-1e29f <= t18) && (t18 <= 1e29f);
    const float t20 = state->u[work->t1];
    work->t21 = work->flags[1] ? t18 : t20;
}

/* Part 2 of a step. */
static void lossy_arm_part_2(lossy_arm_state *state, lossy_arm_work *work)
{
    /* prediction of what the samples show */
    work->t22 = (work->t1 < 25U) ? (work->t1 + 1U) : 0U;
    const float t23 = state->sin_q[work->t1];
    const float t24 = state->next_q;
    const float t26 = 1.5989339e-5f * work->t21;
    const float t28 = -2.332167e-5f * t23;
    const float t29 = t26 + t28;
    const float t30 = t24 + t29;
    const float t31 = state->next_dq;
    const float t33 = 0.01598401f * work->t21;
    const float t36 = t30 * 0.15915494f;
    const float t37 = t36 + 1.2582912e7f;
    const float t38 = t37 - 1.2582912e7f;
    const float t40 = t38 * 6.2831855f;
    const float t41 = t30 - t40;
    const uint32_t t42 = state->known;
    work->flags[2] = t42 == 1U;
    const float t45 = work->t17 - t41;
    const float t46 = t45 * 0.15915494f;
    const float t47 = t46 + 1.2582912e7f;
    const float t48 = t47 - 1.2582912e7f;
    const float t49 = t48 * 6.2831855f;
    const float t50 = t45 - t49;
    const int t51 = (-6.2831855f <= t41) && (t41 <= 6.2831855f);
    const int t52 = (-0.3f <= t50) && (t50 <= 0.3f);
    const int t53 = !t52;
    const int t54 = t51 && t53;
    const int t55 = work->flags[2] && t54;
    const int t56 = work->flags[0] && t55;
    const uint32_t t57 = state->rejected_y;
    const int t60 = t57 < 24U;
    const int t61 = t56 && t60;
    const uint32_t t62 = (t57 < 25U) ? (t57 + 1U) : 25U;
    const uint32_t t63 = work->flags[0] ? 0U : t57;
    const uint32_t t64 = t61 ? t62 : t63;
    state->rejected_y = t64;
    const int t65 = !t61;
    const int t66 = !t60;
    const int t67 = work->flags[0] && t65;
    const int t68 = t56 && t66;
    const float t69 = state->y[work->t1];
    const int t70 = work->flags[2] && t51;
    const float t71 = t70 ? t41 : t69;
    const float t72 = t67 ? work->t17 : t71;
    work->t73 = lossy_arm_sin_f32(t72);
    const float t74 = -2.332167e-5f * work->t73;
    const float t75 = t26 + t74;
    work->t76 = t24 + t75;
    const float t77 = -0.03497668f * work->t73;
    const float t78 = t33 + t77;
    work->t79 = t31 + t78;
    const float t80 = work->t76 * 0.15915494f;
    const float t81 = t80 + 1.2582912e7f;
    work->t82 = t81 - 1.2582912e7f;
    const float t83 = work->t82 * 6.2831855f;
    const float t84 = work->t76 - t83;
    const int t85 = (-6.2831855f <= t84) && (t84 <= 6.2831855f);
    const int t86 = work->flags[2] && t85;
    const float t87 = t86 ? t84 : t69;
    const int t88 = !t67;
    const int t89 = !t85;
    const int t90 = work->flags[2] && t89;
    const int t91 = t88 && t90;
    work->t92 = t67 ? work->t17 : t87;
    const uint32_t t93 = state->since;
    const uint32_t t94 = (t93 < 4294967295U) ? (t93 + 1U) : 4294967295U;
    work->t95 = t67 ? 0U : t94;
    state->since = work->t95;
    work->t97 = t67 ? 1.0f : 0.0f;
    const uint32_t t98 = state->count;

    /* how much of the window is good */
    const int t100 = 25U < t98;
    const int t101 = !t68;
    const int t102 = t100 && t101;
    const int t103 = work->flags[1] && t101;
    const uint32_t t104 = (t98 < 26U) ? (t98 + 1U) : 26U;
    const uint32_t t105 = t91 ? 0U : t104;
    const uint32_t t106 = t103 ? t104 : 1U;
    work->t107 = t102 ? t105 : t106;
    state->count = work->t107;
    const uint32_t t108 = state->coasting;
    const uint32_t t109 = (t108 > 0U) ? (t108 - 1U) : 0U;
    const uint32_t t110 = work->flags[1] ? t109 : 25U;
    const uint32_t t112 = t67 ? t110 : 26U;
    state->coasting = t112;
}

/* Part 3 of a step. */
static void lossy_arm_part_3(lossy_arm_state *state, lossy_arm_work *work)
{
    /* into the window */
    state->newest = work->t22;
    state->y[work->t22] = work->t92;
    state->has_y[work->t22] = work->t97;
    state->u[work->t22] = work->t21;
    state->sin_q[work->t22] = work->t73;
    work->flags[3] = 25U < work->t107;

    /* rows of the window, oldest first; those without a sample count nothing */
    const uint32_t t114 = (work->t22 < 25U) ? (work->t22 + 1U) : 0U;
    const float t117 = state->has_y[t114];
    const float t118 = 0.0f + t117;
    const float t119 = t117 * 0.19611613f;
    const float t120 = t117 * -0.32947975f;
    const float t121 = t119 * t119;
    const float t122 = 0.0f + t121;
    const float t123 = t119 * t120;
    const float t124 = 0.0f + t123;
    const float t125 = t120 * t120;
    const float t126 = 0.0f + t125;
    const float t127 = t119 * 0.0f;
    const float t128 = 0.0f + t127;
    const float t129 = t120 * 0.0f;
    const float t130 = 0.0f + t129;
    work->t131 = t122;
    work->t132 = t124;
    work->t133 = t126;
    work->t134 = t128;
    work->t135 = t130;
    work->t136 = 0.0f;
    work->t137 = 0.0f;
    work->t138 = 0.0f;
    work->t139 = t118;
    uint32_t t140 = t114;
    for (uint32_t row = 0U; row < 25U; ++row) {
        const float *const gains = LOSSY_ARM_ROWS[row];
        const uint32_t t141 = (t140 < 25U) ? (t140 + 1U) : 0U;
        const float t142 = state->sin_q[t140];
        const float t143 = state->u[t141];
        const float t144 = state->sin_q[t141];
        const float t146 = 0.0019980012f * work->t137;
        const float t147 = work->t136 + t146;
        const float t149 = -4.6631685e-5f * t142;
        const float t150 = 1.5989339e-5f * t143;
        const float t151 = -2.332167e-5f * t144;
        const float t152 = t150 + t151;
        const float t153 = t147 + t149;
        const float t154 = t153 + t152;
        const float t156 = 0.998002f * work->t137;
        const float t158 = -0.034953367f * t142;
        const float t159 = 0.01598401f * t143;
        const float t160 = -0.03497668f * t144;
        const float t161 = t159 + t160;
        const float t162 = t156 + t158;
        const float t163 = t162 + t161;
        const float t164 = state->y[t140];
        const float t165 = state->y[t141];
        const float t166 = t165 - t164;
        const float t167 = t166 * 0.15915494f;
        const float t168 = t167 + 1.2582912e7f;
        const float t169 = t168 - 1.2582912e7f;
        const float t170 = t169 * 6.2831855f;
        const float t171 = t166 - t170;
        const float t172 = work->t138 + t171;
        const float t173 = gains[0];
        const float t174 = gains[1];
        const float t175 = state->has_y[t141];
        const float t176 = work->t139 + t175;
        const float t177 = t172 - t154;
        const float t178 = t175 * t173;
        const float t179 = t175 * t174;
        const float t180 = t178 * t178;
        const float t181 = work->t131 + t180;
        const float t182 = t178 * t179;
        const float t183 = work->t132 + t182;
        const float t184 = t179 * t179;
        const float t185 = work->t133 + t184;
        const float t186 = t178 * t177;
        const float t187 = work->t134 + t186;
        const float t188 = t179 * t177;
        const float t189 = work->t135 + t188;
        work->t131 = t181;
        work->t132 = t183;
        work->t133 = t185;
        work->t134 = t187;
        work->t135 = t189;
        work->t136 = t154;
        work->t137 = t163;
        work->t138 = t172;
        work->t139 = t176;
        t140 = t141;
    }
}

/* Part 4 of a step. */
static void lossy_arm_part_4(const lossy_arm_state *state, lossy_arm_work *work)
{
    /* the state from the samples that are there, and its variance */
    const float t195 = 0.0001f * work->t131;
    const float t196 = t195 + 9.8607613e-32f;
    const float t197 = 0.0001f * work->t133;
    const float t198 = t197 + 9.8607613e-32f;
    const int t199 = t196 < work->t131;
    const float t200 = t199 ? work->t131 : 1.0f;
    const float t201 = work->t132 / t200;
    const float t202 = t201 * work->t132;
    const float t203 = work->t133 - t202;
    const float t204 = t201 * work->t134;
    const float t205 = work->t135 - t204;
    const float t206 = work->t134 / t200;
    const float t207 = t201 * 0.09805807f;
    const float t208 = 0.16212507f - t207;
    const float t209 = 0.09805807f * t206;
    const float t210 = 0.09805807f / t200;
    const float t211 = 0.09805807f * t210;
    const int t212 = t198 < t203;
    const int t213 = t199 && t212;
    const float t214 = t212 ? t203 : 1.0f;
    const float t215 = t205 / t214;
    const float t216 = t208 * t215;
    const float t217 = t209 + t216;
    const float t218 = t208 / t214;
    const float t219 = t208 * t218;
    const float t220 = t211 + t219;
    const float t221 = 0.19922587f * t215;
    const float t222 = 0.19922587f / t214;
    const float t223 = 0.19922587f * t222;
    const float t225 = 2.0f * t217;
    const float t227 = 64.0f * t221;

    /* what it is worth */
    const float t229 = t220 * 0.38187814f;
    const int t230 = 0.0f < t229;
    const float t231 = t230 ? t229 : 0.0f;
    const float t233 = t223 * 0.31925517f;
    const int t234 = t231 < t233;
    const float t235 = t234 ? t233 : t231;
    const int t240 = t235 <= 877401.3f;
    work->flags[4] = t213 && t240;
    const int t242 = t235 <= 0.8774013f;
    work->flags[5] = work->flags[4] && t242;
    const float t244 = 1.0044637f * work->t139;
    const float t245 = t244 + 0.1165732f;
    const float t246 = t235 * t245;
    const int t247 = t246 <= 1.0f;
    work->flags[6] = work->flags[5] && t247;
    work->flags[7] = 0.0f < work->t139;
    const float t250 = t225 + work->t136;
    work->t251 = t227 + work->t137;
    const float t252 = state->y[work->t22];
    const float t253 = t252 - work->t138;
    work->t254 = t250 + t253;
}

/* Part 5 of a step. */
static void lossy_arm_part_5(lossy_arm_state *state, lossy_arm_work *work)
{
    /* without enough samples, the model's prediction */
    const float t256 = work->t82 * -6.2831855f;
    const float t257 = work->t76 + t256;
    const int t258 = (-1e29f <= t257) && (t257 <= 1e29f);
    const int t259 = work->flags[2] && t258;
    const int t260 = (-1e29f <= work->t79) && (work->t79 <= 1e29f);
    const int t261 = t259 && t260;
    const uint32_t t262 = state->poor;
    const uint32_t t263 = (t262 < 78U) ? (t262 + 1U) : 78U;
    const uint32_t t264 = work->flags[7] ? t263 : t262;
    const uint32_t t265 = work->flags[5] ? 0U : t264;
    state->poor = t265;
    const int t267 = t265 < 78U;
    const int t268 = t267 && t261;
    const int t269 = !t268;
    const int t270 = work->flags[5] || t269;
    const int t271 = work->flags[4] && t270;
    const float t272 = t271 ? work->t254 : t257;
    const float t273 = t271 ? work->t251 : work->t79;
    const int t274 = t271 || t261;
    const int t275 = work->flags[3] && t274;
    const uint32_t t276 = t275 ? 1U : 0U;
    state->known = t276;
    const float t278 = 0.0019980012f * t273;
    const float t279 = t272 + t278;
    const float t281 = -4.6631685e-5f * work->t73;
    const float t282 = t279 + t281;
    const int t283 = (-1e29f <= t282) && (t282 <= 1e29f);
    const float t284 = t283 ? t282 : 0.0f;
    state->next_q = t284;
    const float t286 = 0.998002f * t273;
    const float t288 = -0.034953367f * work->t73;
    const float t289 = t286 + t288;
    const int t290 = (-1e29f <= t289) && (t289 <= 1e29f);
    const float t291 = t290 ? t289 : 0.0f;
    state->next_dq = t291;

    /* the estimate; until there is one, the start */
    work->t292 = t275 ? t272 : work->t92;
    work->t293 = t275 ? t273 : 0.0f;
    const uint32_t t294 = state->coasting;
    const int t295 = t294 == 0U;
    const int t296 = work->flags[6] && t295;
    const lossy_arm_status t300 = t296 ? LOSSY_ARM_CONVERGED : LOSSY_ARM_COASTING;
    work->t301 = t275 ? t300 : LOSSY_ARM_CONVERGING;
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
    state->rejected_y = 0U;
    state->coasting = 0U;
    for (uint32_t slot = 0U; slot < 26U; ++slot) {
        state->has_y[slot] = 0.0f;
    }
    state->next_q = 0.0f;
    state->next_dq = 0.0f;
    state->known = 0U;
    state->poor = 78U;
    state->since = 0U;
}

void lossy_arm_step(lossy_arm_state *state, const lossy_arm_measurements *measurements,
                    const lossy_arm_inputs *inputs, lossy_arm_estimate *estimate)
{
    lossy_arm_work work;
    lossy_arm_part_1(state, measurements, inputs, &work);
    lossy_arm_part_2(state, &work);
    lossy_arm_part_3(state, &work);
    lossy_arm_part_4(state, &work);
    lossy_arm_part_5(state, &work);

    estimate->q = work.t292;
    estimate->dq = work.t293;
    estimate->coasted = work.t95;
    estimate->status = work.t301;
}
