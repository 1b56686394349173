/* joint_wrapped.c: Finite-time observer: A joint that turns any number of times, its encoder shows one turn and now and then nonsense.
 *
 * Generated; joint_wrapped.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "joint_wrapped.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "joint_wrapped.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "joint_wrapped.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* The bits of a number. */
typedef union {
    float value;
    uint32_t bits;
} joint_wrapped_f32_cell_t;

/* The bits of a number. */
static uint32_t joint_wrapped_f32_to_bits(float x)
{
    joint_wrapped_f32_cell_t cell;
    cell.value = x;
    return cell.bits;
}

/* The bit of the sign. */
#define JOINT_WRAPPED_SIGN_F32 UINT32_C(0x80000000)

/* The bits of the largest magnitude. */
#define JOINT_WRAPPED_MAGNITUDE_F32 UINT32_C(0x7FFFFFFF)

/* The bits of infinity. */
#define JOINT_WRAPPED_INFINITY_F32 UINT32_C(0x7F800000)

/* The bits of the only NaN that is returned. */
#define JOINT_WRAPPED_NAN_F32 UINT32_C(0x7FC00000)

/* The number with these bits. */
static float joint_wrapped_f32_from_bits(uint32_t bits)
{
    joint_wrapped_f32_cell_t cell;
    cell.bits = bits;
    return cell.value;
}

/* The number significand / 2^63 * 2^exponent, with the top bit of the significand set. */
typedef struct {
    uint64_t significand;
    int32_t exponent;
} joint_wrapped_scaled_t;

/* A number with a sign. */
typedef struct {
    joint_wrapped_scaled_t magnitude;
    int negative;
} joint_wrapped_signed_t;

/* The angle quadrant * pi/2 + rest. */
typedef struct {
    joint_wrapped_signed_t rest;
    uint32_t quadrant;
} joint_wrapped_turned_t;

/* Attaches a sign. */
static joint_wrapped_signed_t joint_wrapped_signed(joint_wrapped_scaled_t magnitude, int negative)
{
    joint_wrapped_signed_t result;
    result.magnitude = magnitude;
    result.negative = negative;
    return result;
}

/* A number below 1 as fixed point with 64 fraction bits. */
static uint64_t joint_wrapped_fraction(joint_wrapped_scaled_t a)
{
    const int32_t shift = -1 - a.exponent;
    if (shift > 63) {
        return 0;
    }
    return a.significand >> shift;
}

/* The upper half of the product, at most 2 too small. */
static uint64_t joint_wrapped_mul_high(uint64_t a, uint64_t b)
{
    const uint64_t a_high = a >> 32;
    const uint64_t a_low = a & 0xFFFFFFFFu;
    const uint64_t b_high = b >> 32;
    const uint64_t b_low = b & 0xFFFFFFFFu;
    const uint64_t cross = ((a_high * b_low) >> 32) + ((a_low * b_high) >> 32);
    return a_high * b_high + cross;
}

/* The square of a number below 1 as fixed point with 64 fraction bits. */
static uint64_t joint_wrapped_squared_fraction(joint_wrapped_scaled_t a)
{
    const uint64_t x = joint_wrapped_fraction(a);
    return joint_wrapped_mul_high(x, x);
}

/* Makes a number of a significand that has its top bit set. */
static joint_wrapped_scaled_t joint_wrapped_scaled(uint64_t significand, int32_t exponent)
{
    joint_wrapped_scaled_t result;
    result.significand = significand;
    result.exponent = exponent;
    return result;
}

/* Makes a number of a significand of at least 2^62. */
static joint_wrapped_scaled_t joint_wrapped_settled(uint64_t significand, int32_t exponent)
{
    if ((significand >> 63) == 0) {
        return joint_wrapped_scaled(significand << 1, exponent - 1);
    }
    return joint_wrapped_scaled(significand, exponent);
}

/* (1 - cos(r)) / r^2 in powers of -r^2. */
static const uint64_t JOINT_WRAPPED_COSINE[8] = {
    UINT64_C(0x8000000000000000), UINT64_C(0x0AAAAAAAAAAAAAA8), UINT64_C(0x005B05B05B05B02B),
    UINT64_C(0x0001A01A01A01865), UINT64_C(0x0000049F93EDD666), UINT64_C(0x00000008F76C6243),
    UINT64_C(0x000000000C9C9706), UINT64_C(0x00000000000D551B)};

/* cos(r) for 0 < r <= pi/4, relative error below 2^-60. */
static joint_wrapped_scaled_t joint_wrapped_cosine(joint_wrapped_scaled_t r)
{
    const uint64_t z = joint_wrapped_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = JOINT_WRAPPED_COSINE[6] - ((JOINT_WRAPPED_COSINE[7] * z_high) >> 32);
    const uint64_t c5 = JOINT_WRAPPED_COSINE[5] - ((tail * z_high) >> 32);
    const uint64_t c4 = JOINT_WRAPPED_COSINE[4] - joint_wrapped_mul_high(c5, z);
    const uint64_t c3 = JOINT_WRAPPED_COSINE[3] - joint_wrapped_mul_high(c4, z);
    const uint64_t c2 = JOINT_WRAPPED_COSINE[2] - joint_wrapped_mul_high(c3, z);
    const uint64_t c1 = JOINT_WRAPPED_COSINE[1] - joint_wrapped_mul_high(c2, z);
    const uint64_t c0 = JOINT_WRAPPED_COSINE[0] - joint_wrapped_mul_high(c1, z);
    return joint_wrapped_settled((UINT64_C(1) << 63) - (joint_wrapped_mul_high(c0, z) >> 1), 0);
}

/* (1 - sin(r) / r) / r^2 in powers of -r^2. */
static const uint64_t JOINT_WRAPPED_SINE[7] = {
    UINT64_C(0x2AAAAAAAAAAAAAA6), UINT64_C(0x0222222222222160), UINT64_C(0x000D00D00D00C575),
    UINT64_C(0x00002E3BC74A673D), UINT64_C(0x0000006B9914A637), UINT64_C(0x00000000B090498C),
    UINT64_C(0x0000000000D552BC)};

/* sin(r) for 0 < r <= pi/4, relative error below 2^-60. */
static joint_wrapped_scaled_t joint_wrapped_sine(joint_wrapped_scaled_t r)
{
    const uint64_t z = joint_wrapped_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = JOINT_WRAPPED_SINE[5] - ((JOINT_WRAPPED_SINE[6] * z_high) >> 32);
    const uint64_t c4 = JOINT_WRAPPED_SINE[4] - ((tail * z_high) >> 32);
    const uint64_t c3 = JOINT_WRAPPED_SINE[3] - joint_wrapped_mul_high(c4, z);
    const uint64_t c2 = JOINT_WRAPPED_SINE[2] - joint_wrapped_mul_high(c3, z);
    const uint64_t c1 = JOINT_WRAPPED_SINE[1] - joint_wrapped_mul_high(c2, z);
    const uint64_t c0 = JOINT_WRAPPED_SINE[0] - joint_wrapped_mul_high(c1, z);
    const uint64_t lost = joint_wrapped_mul_high(r.significand, joint_wrapped_mul_high(c0, z));
    return joint_wrapped_settled(r.significand - lost, r.exponent);
}

/* The sine of an angle. */
static joint_wrapped_signed_t joint_wrapped_sine_at(joint_wrapped_turned_t angle)
{
    const int back = (angle.quadrant & 2) != 0;
    if ((angle.quadrant & 1) != 0) {
        return joint_wrapped_signed(joint_wrapped_cosine(angle.rest.magnitude), back);
    }
    return joint_wrapped_signed(joint_wrapped_sine(angle.rest.magnitude), back != angle.rest.negative);
}

/* Makes an angle of its parts. */
static joint_wrapped_turned_t joint_wrapped_turned(joint_wrapped_signed_t rest, uint32_t quadrant)
{
    joint_wrapped_turned_t result;
    result.rest = rest;
    result.quadrant = quadrant;
    return result;
}

/* The number of zero bits above the highest one bit; x is not 0. */
static int32_t joint_wrapped_leading_zeros(uint64_t x)
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
static joint_wrapped_scaled_t joint_wrapped_normalised(uint64_t significand, int32_t exponent)
{
    const int32_t shift = joint_wrapped_leading_zeros(significand);
    return joint_wrapped_scaled(significand << shift, exponent - shift);
}

/* The finite positive number with these bits, not 0; exact. */
static joint_wrapped_scaled_t joint_wrapped_unpacked_f32(uint32_t magnitude)
{
    const int32_t field = (int32_t)(magnitude >> 23);
    const uint64_t digits = (uint64_t)magnitude << 40;
    if (field == 0) {
        return joint_wrapped_normalised(digits, -126);
    }
    return joint_wrapped_scaled(digits | (UINT64_C(1) << 63), field - 127);
}

/* 2/pi after 32 zero bits. */
static const uint32_t JOINT_WRAPPED_TWO_OVER_PI_F32[9] = {
    UINT32_C(0x00000000), UINT32_C(0xA2F9836E), UINT32_C(0x4E441529),
    UINT32_C(0xFC2757D1), UINT32_C(0xF534DDC0), UINT32_C(0xDB629599),
    UINT32_C(0x3C439041), UINT32_C(0xFE5163AB), UINT32_C(0xDEBBC561)};

/* 32 bits of 2/pi from bit 32 slot + shift on. */
static uint64_t joint_wrapped_window_f32(uint32_t slot, uint32_t shift)
{
    const uint64_t first = (uint64_t)(JOINT_WRAPPED_TWO_OVER_PI_F32[slot]);
    const uint64_t second = (uint64_t)(JOINT_WRAPPED_TWO_OVER_PI_F32[slot + 1]);
    return (((first << 32) | second) >> (32 - shift)) & 0xFFFFFFFFu;
}

/* a b, relative error below 2^-60. */
static joint_wrapped_scaled_t joint_wrapped_product(joint_wrapped_scaled_t a, joint_wrapped_scaled_t b)
{
    return joint_wrapped_settled(joint_wrapped_mul_high(a.significand, b.significand),
                            a.exponent + b.exponent + 1);
}

/* pi with 62 fraction bits; as a significand also pi/2 and pi/4. */
#define JOINT_WRAPPED_PI UINT64_C(0xC90FDAA22168C235)

/* The angle of (high, low) / 2^126 quarter turns, its rest exact to 2^-60 of itself. */
static joint_wrapped_turned_t joint_wrapped_turned_from_quarters(uint64_t high, uint64_t low)
{
    const uint64_t eighths = high >> 61;
    const int negative = (eighths & 1) != 0;
    uint64_t upper = (high << 2) | (low >> 62);
    uint64_t lower = low << 2;
    if (negative) {
        upper = (lower == 0) ? (UINT64_C(0) - upper) : UINT64_MAX - upper;
        lower = (UINT64_C(0) - lower);
    }
    const int32_t shift = joint_wrapped_leading_zeros(upper | 1);
    const uint64_t significand = (upper << shift) | ((lower >> 1) >> (63 - shift));
    const joint_wrapped_signed_t rest = joint_wrapped_signed(
        joint_wrapped_product(joint_wrapped_scaled(significand, -1 - shift), joint_wrapped_scaled(JOINT_WRAPPED_PI, 0)),
        negative);
    return joint_wrapped_turned(rest, (uint32_t)(((eighths + 1) >> 1) & 3));
}

/* The angle with these bits, positive and finite, its rest exact to 2^-38 of itself. */
static joint_wrapped_turned_t joint_wrapped_reduce_f32(uint32_t magnitude)
{
    if (magnitude <= 0x3F490FDAu) {
        return joint_wrapped_turned(joint_wrapped_signed(joint_wrapped_unpacked_f32(magnitude), 0), 0);
    }
    const uint64_t digits = (uint64_t)((magnitude & 0x007FFFFFu) | 0x00800000u);
    const uint32_t start = (magnitude >> 23) - 120;
    const uint32_t slot = start >> 5;
    const uint32_t shift = start & 31;
    const uint64_t upper = (joint_wrapped_window_f32(slot, shift) * digits) << 32;
    const uint64_t middle = joint_wrapped_window_f32(slot + 1, shift) * digits;
    const uint64_t lower = joint_wrapped_window_f32(slot + 2, shift) * digits;
    return joint_wrapped_turned_from_quarters(((upper + middle) + (lower >> 32)), lower << 32);
}

/* x rounded to the nearest, ties to even, with subnormals and overflow, and the sign put in. */
static float joint_wrapped_rounded_f32(uint32_t sign, joint_wrapped_scaled_t x)
{
    const int32_t field = x.exponent + 127;
    if (field >= 255) {
        return joint_wrapped_f32_from_bits(sign | JOINT_WRAPPED_INFINITY_F32);
    }
    const int32_t shift = (field > 0) ? 40 : 41 - field;
    if (shift > 63) {
        const int least = shift == 64 && x.significand > (UINT64_C(1) << 63);
        return joint_wrapped_f32_from_bits(least ? sign + 1 : sign);
    }
    const uint64_t kept = x.significand >> shift;
    const uint64_t rest = x.significand - (kept << shift);
    const uint64_t half = UINT64_C(1) << (shift - 1);
    const uint64_t odd = kept & 1;
    const uint64_t up = (rest + odd > half) ? 1 : 0;
    const uint32_t base = (field > 0) ? ((uint32_t)(field - 1)) << 23 : 0;
    return joint_wrapped_f32_from_bits(sign | (base + ((uint32_t)(kept + up))));
}

/* The sign bit of a negative number, else 0. */
static uint32_t joint_wrapped_sign_f32(int negative)
{
    if (negative) {
        return JOINT_WRAPPED_SIGN_F32;
    }
    return 0;
}

/* Sine of an angle in radians, the nearest float. */
static float joint_wrapped_sin_f32(float x)
{
    const uint32_t bits = joint_wrapped_f32_to_bits(x);
    const uint32_t magnitude = bits & JOINT_WRAPPED_MAGNITUDE_F32;
    if (magnitude >= JOINT_WRAPPED_INFINITY_F32) {
        return joint_wrapped_f32_from_bits(JOINT_WRAPPED_NAN_F32);
    }
    if (magnitude == 0) {
        return x;
    }
    const joint_wrapped_signed_t value = joint_wrapped_sine_at(joint_wrapped_reduce_f32(magnitude));
    return joint_wrapped_rounded_f32((bits & JOINT_WRAPPED_SIGN_F32) ^ joint_wrapped_sign_f32(value.negative),
                                value.magnitude);
}

/* What one part of a step hands to the next. */
typedef struct {
    float t20;
    uint32_t t45;
    float t74;
    uint32_t t78;
    float t80;
    float t82;
    float t116;
    float t117;
    joint_wrapped_status t135;
    int flags[3]; /* t70, t71, t83 */
} joint_wrapped_work;

/* Part 1 of a step. */
static void joint_wrapped_part_1(joint_wrapped_state *state, const joint_wrapped_measurements *measurements, const joint_wrapped_inputs *inputs, joint_wrapped_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    const float t0 = measurements->angle;
    const int t1 = (-6588397.5f <= t0) && (t0 <= 6588397.5f);
    const float t3 = t0 * 0.15915494f;
    const float t5 = t3 + 1.2582912e7f;
    const float t6 = t5 - 1.2582912e7f;
    const float t8 = t6 * 6.28125f;
    const float t9 = t0 - t8;
    const float t11 = t6 * 0.0019350052f;
    const float t12 = t9 - t11;
    const float t14 = t6 * 3.019916e-7f;
    const float t15 = t12 - t14;
    const float t16 = inputs->i;
    const int t17 = (-1e36f <= t16) && (t16 <= 1e36f);
    const float t18 = state->last_i;
    const float t19 = t17 ? t16 : t18;

    /* prediction by the plant */
    work->t20 = state->q;
    const float t21 = state->dq;
    const float t22 = state->last_known1;
    const float t24 = 0.0049937554f * t21;
    const float t26 = 4.995836e-5f * t19;
    const float t28 = -0.00016318032f * t22;
    const float t29 = work->t20 + t24;
    const float t30 = t29 + t26;
    const float t31 = t30 + t28;
    const float t33 = 0.9975031f * t21;
    const float t35 = 0.019975021f * t19;
    const float t37 = -0.04891841f * t22;
    const float t38 = t33 + t35;
    const float t39 = t38 + t37;
    const float t41 = -8.161565e-5f * t22;
    const float t42 = t31 + t41;
    work->t45 = state->good;
    const int t46 = 89U < work->t45;
    const float t47 = t15 - t42;
    const float t48 = t47 * 0.15915494f;
    const float t49 = t48 + 1.2582912e7f;
    const float t50 = t49 - 1.2582912e7f;
    const float t52 = t50 * 6.2831855f;
    const float t53 = t47 - t52;
    const int t54 = (-6.2831855f <= t42) && (t42 <= 6.2831855f);
    const int t55 = (-0.3f <= t53) && (t53 <= 0.3f);
    const int t56 = !t55;
    const int t57 = t54 && t56;
    const int t58 = t46 && t57;
    const int t59 = t1 && t58;
    const uint32_t t60 = state->rejected_angle;
    const int t63 = t60 < 88U;
    const int t64 = t59 && t63;
    const uint32_t t65 = (t60 < 89U) ? (t60 + 1U) : 89U;
    const uint32_t t66 = t1 ? 0U : t60;
    const uint32_t t67 = t64 ? t65 : t66;
    state->rejected_angle = t67;
    const int t68 = !t64;
    const int t69 = !t63;
    work->flags[0] = t1 && t68;
    work->flags[1] = t59 && t69;
    const float t72 = state->last_angle;
    const float t73 = t54 ? t42 : t72;
    work->t74 = work->flags[0] ? t15 : t73;
    const float t75 = joint_wrapped_sin_f32(work->t74);
    const uint32_t t76 = state->coasted;
    const uint32_t t77 = (t76 < 4294967295U) ? (t76 + 1U) : 4294967295U;
    work->t78 = work->flags[0] ? 0U : t77;
    state->coasted = work->t78;
    const float t79 = -8.161565e-5f * t75;
    work->t80 = t31 + t79;
    const float t81 = -0.048959192f * t75;
    work->t82 = t39 + t81;
    state->last_i = t19;
    state->last_known1 = t75;
    state->last_angle = work->t74;
    work->flags[2] = t17 && work->flags[0];
}

/* Part 2 of a step. */
static void joint_wrapped_part_2(joint_wrapped_state *state, joint_wrapped_work *work)
{
    /* correction by the innovation */
    const float t84 = work->t80 - work->t20;
    const int t85 = (-3.1415927f <= t84) && (t84 <= 3.1415927f);
    const int t86 = !t85;
    const int t87 = t86 || work->flags[1];
    const float t89 = work->t74 - work->t80;
    const float t90 = t89 * 0.15915494f;
    const float t91 = t90 + 1.2582912e7f;
    const float t92 = t91 - 1.2582912e7f;
    const float t93 = t92 * 6.2831855f;
    const float t94 = t89 - t93;
    const float t95 = work->flags[0] ? t94 : 0.0f;
    const float t97 = 0.26904923f * t95;
    const float t99 = 8.415041f * t95;
    const float t100 = work->t80 + t97;
    const float t101 = work->t82 + t99;
    const float t102 = t100 * 0.15915494f;
    const float t103 = t102 + 1.2582912e7f;
    const float t104 = t103 - 1.2582912e7f;
    const float t105 = t104 * 6.2831855f;
    const float t106 = t100 - t105;

    /* the first sample starts the observer; so does a state beyond all bounds */
    const int t107 = work->t45 == 0U;
    const int t108 = t107 || t87;
    const int t109 = (-1e36f <= t106) && (t106 <= 1e36f);
    const int t110 = !t109;
    const int t111 = t108 || t110;
    const int t112 = (-1e36f <= t101) && (t101 <= 1e36f);
    const int t113 = !t112;
    const int t114 = t111 || t113;
    const float t115 = work->flags[0] ? work->t74 : 0.0f;
    work->t116 = t114 ? t115 : t106;
    state->q = work->t116;
    work->t117 = t114 ? 0.0f : t101;
    state->dq = work->t117;
    const uint32_t t119 = work->flags[0] ? 1U : 0U;
    const uint32_t t120 = (work->t45 < 90U) ? (work->t45 + 1U) : 90U;
    const uint32_t t121 = work->flags[0] ? t120 : work->t45;
    const uint32_t t122 = t114 ? t119 : t121;
    state->good = t122;
    const uint32_t t123 = state->clean;
    const uint32_t t124 = (t123 < 110U) ? (t123 + 1U) : 110U;
    const uint32_t t125 = work->flags[2] ? t124 : 0U;
    const uint32_t t127 = t114 ? 110U : t125;
    state->clean = t127;

    /* the estimate */
    const int t129 = 89U < t122;
    const int t130 = 109U < t127;
    const joint_wrapped_status t134 = t130 ? JOINT_WRAPPED_CONVERGED : JOINT_WRAPPED_COASTING;
    work->t135 = t129 ? t134 : JOINT_WRAPPED_CONVERGING;
}

void joint_wrapped_init(joint_wrapped_state *state)
{
    state->q = 0.0f;
    state->dq = 0.0f;
    state->good = 0U;
    state->clean = 0U;
    state->last_angle = 0.0f;
    state->last_i = 0.0f;
    state->last_known1 = 0.0f;
    state->rejected_angle = 0U;
    state->coasted = 0U;
}

void joint_wrapped_step(joint_wrapped_state *state, const joint_wrapped_measurements *measurements,
                        const joint_wrapped_inputs *inputs, joint_wrapped_estimate *estimate)
{
    joint_wrapped_work work;
    joint_wrapped_part_1(state, measurements, inputs, &work);
    joint_wrapped_part_2(state, &work);

    estimate->q = work.t116;
    estimate->dq = work.t117;
    estimate->coasted = work.t78;
    estimate->status = work.t135;
}
