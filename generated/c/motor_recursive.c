/* motor_recursive.c: Finite-time observer: Direct-drive arm as its paper draws it: a copy, a filter and one delay.
 *
 * Generated; motor_recursive.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "motor_recursive.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "motor_recursive.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "motor_recursive.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* The bits of a number. */
typedef union {
    float value;
    uint32_t bits;
} motor_recursive_f32_cell_t;

/* The bits of a number. */
static uint32_t motor_recursive_f32_to_bits(float x)
{
    motor_recursive_f32_cell_t cell;
    cell.value = x;
    return cell.bits;
}

/* The bit of the sign. */
#define MOTOR_RECURSIVE_SIGN_F32 UINT32_C(0x80000000)

/* The bits of the largest magnitude. */
#define MOTOR_RECURSIVE_MAGNITUDE_F32 UINT32_C(0x7FFFFFFF)

/* The bits of infinity. */
#define MOTOR_RECURSIVE_INFINITY_F32 UINT32_C(0x7F800000)

/* The bits of the only NaN that is returned. */
#define MOTOR_RECURSIVE_NAN_F32 UINT32_C(0x7FC00000)

/* The number with these bits. */
static float motor_recursive_f32_from_bits(uint32_t bits)
{
    motor_recursive_f32_cell_t cell;
    cell.bits = bits;
    return cell.value;
}

/* The number significand / 2^63 * 2^exponent, with the top bit of the significand set. */
typedef struct {
    uint64_t significand;
    int32_t exponent;
} motor_recursive_scaled_t;

/* A number with a sign. */
typedef struct {
    motor_recursive_scaled_t magnitude;
    int negative;
} motor_recursive_signed_t;

/* The angle quadrant * pi/2 + rest. */
typedef struct {
    motor_recursive_signed_t rest;
    uint32_t quadrant;
} motor_recursive_turned_t;

/* Attaches a sign. */
static motor_recursive_signed_t motor_recursive_signed(motor_recursive_scaled_t magnitude, int negative)
{
    motor_recursive_signed_t result;
    result.magnitude = magnitude;
    result.negative = negative;
    return result;
}

/* A number below 1 as fixed point with 64 fraction bits. */
static uint64_t motor_recursive_fraction(motor_recursive_scaled_t a)
{
    const int32_t shift = -1 - a.exponent;
    if (shift > 63) {
        return 0;
    }
    return a.significand >> shift;
}

/* The upper half of the product, at most 2 too small. */
static uint64_t motor_recursive_mul_high(uint64_t a, uint64_t b)
{
    const uint64_t a_high = a >> 32;
    const uint64_t a_low = a & 0xFFFFFFFFu;
    const uint64_t b_high = b >> 32;
    const uint64_t b_low = b & 0xFFFFFFFFu;
    const uint64_t cross = ((a_high * b_low) >> 32) + ((a_low * b_high) >> 32);
    return a_high * b_high + cross;
}

/* The square of a number below 1 as fixed point with 64 fraction bits. */
static uint64_t motor_recursive_squared_fraction(motor_recursive_scaled_t a)
{
    const uint64_t x = motor_recursive_fraction(a);
    return motor_recursive_mul_high(x, x);
}

/* Makes a number of a significand that has its top bit set. */
static motor_recursive_scaled_t motor_recursive_scaled(uint64_t significand, int32_t exponent)
{
    motor_recursive_scaled_t result;
    result.significand = significand;
    result.exponent = exponent;
    return result;
}

/* Makes a number of a significand of at least 2^62. */
static motor_recursive_scaled_t motor_recursive_settled(uint64_t significand, int32_t exponent)
{
    if ((significand >> 63) == 0) {
        return motor_recursive_scaled(significand << 1, exponent - 1);
    }
    return motor_recursive_scaled(significand, exponent);
}

/* (1 - cos(r)) / r^2 in powers of -r^2. */
static const uint64_t MOTOR_RECURSIVE_COSINE[8] = {
    UINT64_C(0x8000000000000000), UINT64_C(0x0AAAAAAAAAAAAAA8), UINT64_C(0x005B05B05B05B02B),
    UINT64_C(0x0001A01A01A01865), UINT64_C(0x0000049F93EDD666), UINT64_C(0x00000008F76C6243),
    UINT64_C(0x000000000C9C9706), UINT64_C(0x00000000000D551B)};

/* cos(r) for 0 < r <= pi/4, relative error below 2^-60. */
static motor_recursive_scaled_t motor_recursive_cosine(motor_recursive_scaled_t r)
{
    const uint64_t z = motor_recursive_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = MOTOR_RECURSIVE_COSINE[6] - ((MOTOR_RECURSIVE_COSINE[7] * z_high) >> 32);
    const uint64_t c5 = MOTOR_RECURSIVE_COSINE[5] - ((tail * z_high) >> 32);
    const uint64_t c4 = MOTOR_RECURSIVE_COSINE[4] - motor_recursive_mul_high(c5, z);
    const uint64_t c3 = MOTOR_RECURSIVE_COSINE[3] - motor_recursive_mul_high(c4, z);
    const uint64_t c2 = MOTOR_RECURSIVE_COSINE[2] - motor_recursive_mul_high(c3, z);
    const uint64_t c1 = MOTOR_RECURSIVE_COSINE[1] - motor_recursive_mul_high(c2, z);
    const uint64_t c0 = MOTOR_RECURSIVE_COSINE[0] - motor_recursive_mul_high(c1, z);
    return motor_recursive_settled((UINT64_C(1) << 63) - (motor_recursive_mul_high(c0, z) >> 1), 0);
}

/* (1 - sin(r) / r) / r^2 in powers of -r^2. */
static const uint64_t MOTOR_RECURSIVE_SINE[7] = {
    UINT64_C(0x2AAAAAAAAAAAAAA6), UINT64_C(0x0222222222222160), UINT64_C(0x000D00D00D00C575),
    UINT64_C(0x00002E3BC74A673D), UINT64_C(0x0000006B9914A637), UINT64_C(0x00000000B090498C),
    UINT64_C(0x0000000000D552BC)};

/* sin(r) for 0 < r <= pi/4, relative error below 2^-60. */
static motor_recursive_scaled_t motor_recursive_sine(motor_recursive_scaled_t r)
{
    const uint64_t z = motor_recursive_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = MOTOR_RECURSIVE_SINE[5] - ((MOTOR_RECURSIVE_SINE[6] * z_high) >> 32);
    const uint64_t c4 = MOTOR_RECURSIVE_SINE[4] - ((tail * z_high) >> 32);
    const uint64_t c3 = MOTOR_RECURSIVE_SINE[3] - motor_recursive_mul_high(c4, z);
    const uint64_t c2 = MOTOR_RECURSIVE_SINE[2] - motor_recursive_mul_high(c3, z);
    const uint64_t c1 = MOTOR_RECURSIVE_SINE[1] - motor_recursive_mul_high(c2, z);
    const uint64_t c0 = MOTOR_RECURSIVE_SINE[0] - motor_recursive_mul_high(c1, z);
    const uint64_t lost = motor_recursive_mul_high(r.significand, motor_recursive_mul_high(c0, z));
    return motor_recursive_settled(r.significand - lost, r.exponent);
}

/* The sine of an angle. */
static motor_recursive_signed_t motor_recursive_sine_at(motor_recursive_turned_t angle)
{
    const int back = (angle.quadrant & 2) != 0;
    if ((angle.quadrant & 1) != 0) {
        return motor_recursive_signed(motor_recursive_cosine(angle.rest.magnitude), back);
    }
    return motor_recursive_signed(motor_recursive_sine(angle.rest.magnitude), back != angle.rest.negative);
}

/* Makes an angle of its parts. */
static motor_recursive_turned_t motor_recursive_turned(motor_recursive_signed_t rest, uint32_t quadrant)
{
    motor_recursive_turned_t result;
    result.rest = rest;
    result.quadrant = quadrant;
    return result;
}

/* The number of zero bits above the highest one bit; x is not 0. */
static int32_t motor_recursive_leading_zeros(uint64_t x)
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
static motor_recursive_scaled_t motor_recursive_normalised(uint64_t significand, int32_t exponent)
{
    const int32_t shift = motor_recursive_leading_zeros(significand);
    return motor_recursive_scaled(significand << shift, exponent - shift);
}

/* The finite positive number with these bits, not 0; exact. */
static motor_recursive_scaled_t motor_recursive_unpacked_f32(uint32_t magnitude)
{
    const int32_t field = (int32_t)(magnitude >> 23);
    const uint64_t digits = (uint64_t)magnitude << 40;
    if (field == 0) {
        return motor_recursive_normalised(digits, -126);
    }
    return motor_recursive_scaled(digits | (UINT64_C(1) << 63), field - 127);
}

/* 2/pi after 32 zero bits. */
static const uint32_t MOTOR_RECURSIVE_TWO_OVER_PI_F32[9] = {
    UINT32_C(0x00000000), UINT32_C(0xA2F9836E), UINT32_C(0x4E441529),
    UINT32_C(0xFC2757D1), UINT32_C(0xF534DDC0), UINT32_C(0xDB629599),
    UINT32_C(0x3C439041), UINT32_C(0xFE5163AB), UINT32_C(0xDEBBC561)};

/* 32 bits of 2/pi from bit 32 slot + shift on. */
static uint64_t motor_recursive_window_f32(uint32_t slot, uint32_t shift)
{
    const uint64_t first = (uint64_t)(MOTOR_RECURSIVE_TWO_OVER_PI_F32[slot]);
    const uint64_t second = (uint64_t)(MOTOR_RECURSIVE_TWO_OVER_PI_F32[slot + 1]);
    return (((first << 32) | second) >> (32 - shift)) & 0xFFFFFFFFu;
}

/* a b, relative error below 2^-60. */
static motor_recursive_scaled_t motor_recursive_product(motor_recursive_scaled_t a, motor_recursive_scaled_t b)
{
    return motor_recursive_settled(motor_recursive_mul_high(a.significand, b.significand),
                            a.exponent + b.exponent + 1);
}

/* pi with 62 fraction bits; as a significand also pi/2 and pi/4. */
#define MOTOR_RECURSIVE_PI UINT64_C(0xC90FDAA22168C235)

/* The angle of (high, low) / 2^126 quarter turns, its rest exact to 2^-60 of itself. */
static motor_recursive_turned_t motor_recursive_turned_from_quarters(uint64_t high, uint64_t low)
{
    const uint64_t eighths = high >> 61;
    const int negative = (eighths & 1) != 0;
    uint64_t upper = (high << 2) | (low >> 62);
    uint64_t lower = low << 2;
    if (negative) {
        upper = (lower == 0) ? (UINT64_C(0) - upper) : UINT64_MAX - upper;
        lower = (UINT64_C(0) - lower);
    }
    const int32_t shift = motor_recursive_leading_zeros(upper | 1);
    const uint64_t significand = (upper << shift) | ((lower >> 1) >> (63 - shift));
    const motor_recursive_signed_t rest = motor_recursive_signed(
        motor_recursive_product(motor_recursive_scaled(significand, -1 - shift), motor_recursive_scaled(MOTOR_RECURSIVE_PI, 0)),
        negative);
    return motor_recursive_turned(rest, (uint32_t)(((eighths + 1) >> 1) & 3));
}

/* The angle with these bits, positive and finite, its rest exact to 2^-38 of itself. */
static motor_recursive_turned_t motor_recursive_reduce_f32(uint32_t magnitude)
{
    if (magnitude <= 0x3F490FDAu) {
        return motor_recursive_turned(motor_recursive_signed(motor_recursive_unpacked_f32(magnitude), 0), 0);
    }
    const uint64_t digits = (uint64_t)((magnitude & 0x007FFFFFu) | 0x00800000u);
    const uint32_t start = (magnitude >> 23) - 120;
    const uint32_t slot = start >> 5;
    const uint32_t shift = start & 31;
    const uint64_t upper = (motor_recursive_window_f32(slot, shift) * digits) << 32;
    const uint64_t middle = motor_recursive_window_f32(slot + 1, shift) * digits;
    const uint64_t lower = motor_recursive_window_f32(slot + 2, shift) * digits;
    return motor_recursive_turned_from_quarters(((upper + middle) + (lower >> 32)), lower << 32);
}

/* x rounded to the nearest, ties to even, with subnormals and overflow, and the sign put in. */
static float motor_recursive_rounded_f32(uint32_t sign, motor_recursive_scaled_t x)
{
    const int32_t field = x.exponent + 127;
    if (field >= 255) {
        return motor_recursive_f32_from_bits(sign | MOTOR_RECURSIVE_INFINITY_F32);
    }
    const int32_t shift = (field > 0) ? 40 : 41 - field;
    if (shift > 63) {
        const int least = shift == 64 && x.significand > (UINT64_C(1) << 63);
        return motor_recursive_f32_from_bits(least ? sign + 1 : sign);
    }
    const uint64_t kept = x.significand >> shift;
    const uint64_t rest = x.significand - (kept << shift);
    const uint64_t half = UINT64_C(1) << (shift - 1);
    const uint64_t odd = kept & 1;
    const uint64_t up = (rest + odd > half) ? 1 : 0;
    const uint32_t base = (field > 0) ? ((uint32_t)(field - 1)) << 23 : 0;
    return motor_recursive_f32_from_bits(sign | (base + ((uint32_t)(kept + up))));
}

/* The sign bit of a negative number, else 0. */
static uint32_t motor_recursive_sign_f32(int negative)
{
    if (negative) {
        return MOTOR_RECURSIVE_SIGN_F32;
    }
    return 0;
}

/* Sine of an angle in radians, the nearest float. */
static float motor_recursive_sin_f32(float x)
{
    const uint32_t bits = motor_recursive_f32_to_bits(x);
    const uint32_t magnitude = bits & MOTOR_RECURSIVE_MAGNITUDE_F32;
    if (magnitude >= MOTOR_RECURSIVE_INFINITY_F32) {
        return motor_recursive_f32_from_bits(MOTOR_RECURSIVE_NAN_F32);
    }
    if (magnitude == 0) {
        return x;
    }
    const motor_recursive_signed_t value = motor_recursive_sine_at(motor_recursive_reduce_f32(magnitude));
    return motor_recursive_rounded_f32((bits & MOTOR_RECURSIVE_SIGN_F32) ^ motor_recursive_sign_f32(value.negative),
                                value.magnitude);
}

/* What one part of a step hands to the next. */
typedef struct {
    float t10;
    uint32_t t11;
    float t14;
    float t21;
    float t32;
    uint32_t t39;
    float t82;
    float t83;
    float t90;
    float t96;
    float t148;
    float t157;
    float t174;
    float t175;
    float t176;
    motor_recursive_status t183;
    int flags[1]; /* t4 */
} motor_recursive_work;

/* Part 1 of a step. */
static void motor_recursive_part_1(motor_recursive_state *state, const motor_recursive_measurements *measurements, const motor_recursive_inputs *inputs, motor_recursive_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    const uint32_t t0 = state->newest;
    const uint32_t t1 = (t0 < 100U) ? t0 : 100U;
    const uint32_t t2 = state->count;
    work->flags[0] = 100U < t2;
    const float t5 = measurements->y;
    const int t6 = (-1e34f <= t5) && (t5 <= 1e34f);
    const float t7 = inputs->u;
    const int t8 = (-1e34f <= t7) && (t7 <= 1e34f);
    const float t9 = state->u;
    work->t10 = t8 ? t7 : t9;

    /* prediction, for a sample that is missing */
    work->t11 = (t1 < 100U) ? (t1 + 1U) : 0U;
    const float t12 = state->ahead_y;
    work->t14 = 9.516694e-8f * work->t10;
    const float t15 = t12 + work->t14;
    const float t16 = state->y;
    const int t17 = (-1e34f <= t15) && (t15 <= 1e34f);
    const int t18 = work->flags[0] && t17;
    const float t19 = t18 ? t15 : t16;
    const float t20 = t6 ? t5 : t19;
    work->t21 = motor_recursive_sin_f32(t20);
    const float t22 = state->sin_q;
    const float t23 = work->t21 - t22;
    const float t25 = -5.8317214e-6f * t23;
    const float t26 = t15 + t25;
    const int t27 = (-1e34f <= t26) && (t26 <= 1e34f);
    const int t28 = work->flags[0] && t27;
    const float t29 = t28 ? t26 : t16;
    const int t30 = t6 || t28;
    const int t31 = !t30;
    work->t32 = t6 ? t5 : t29;

    /* how much of the window is good */
    const uint32_t t35 = (t2 < 101U) ? (t2 + 1U) : 101U;
    const uint32_t t36 = t31 ? 0U : t35;
    const uint32_t t37 = t8 ? t35 : 1U;
    const uint32_t t38 = t6 ? t37 : 0U;
    work->t39 = work->flags[0] ? t36 : t38;
    state->count = work->t39;
    const uint32_t t40 = state->coasting;
    const uint32_t t41 = (t40 > 0U) ? (t40 - 1U) : 0U;
    const uint32_t t42 = t8 ? t41 : 100U;
    const uint32_t t44 = t6 ? t42 : 101U;
    state->coasting = t44;

    /* into the window */
    state->newest = work->t11;
    state->y = work->t32;
    state->u = work->t10;
    state->sin_q = work->t21;
}

/* Part 2 of a step. */
static void motor_recursive_part_2(motor_recursive_state *state, motor_recursive_work *work)
{
    /* copy and filter; they start with the first sample of a window */
    const int t46 = work->t39 < 2U;
    const float t48 = state->copy_q;
    const float t49 = state->copy_dq;
    const float t50 = state->copy_i;
    const float t51 = state->filter;
    const float t52 = state->filter_2;
    const float t53 = state->filter_3;
    const float t54 = state->filter_4;
    const float t55 = t46 ? 0.0f : t48;
    const float t56 = t46 ? 0.0f : t49;
    const float t57 = t46 ? 0.0f : t50;
    const float t58 = t46 ? 0.0f : t51;
    const float t59 = t46 ? 0.0f : t52;
    const float t60 = t46 ? 0.0f : t53;
    const float t61 = t46 ? 0.0f : t54;
    const float t62 = state->innovation[work->t11];
    const float t63 = work->flags[0] ? t62 : 0.0f;
    const float t64 = t46 ? 0.0f : t63;
    const float t65 = -5.8317214e-6f * work->t21;
    const float t66 = t55 + work->t14;
    const float t67 = t66 + t65;
    const float t69 = 0.00028085354f * work->t10;
    const float t71 = -0.017493403f * work->t21;
    const float t72 = t56 + t69;
    const float t73 = t72 + t71;
    const float t75 = 0.036250554f * work->t10;
    const float t77 = 0.00020207113f * work->t21;
    const float t78 = t57 + t75;
    const float t79 = t78 + t77;
    const float t80 = t46 ? 0.0f : t67;
    const float t81 = t46 ? 0.0f : t73;
    work->t82 = t46 ? 0.0f : t79;
    work->t83 = work->t32 - t80;
    const float t85 = 0.860708f * t58;
    const float t86 = 0.860708f * t60;
    const float t87 = t85 + t86;
    const float t89 = -8.146846e-9f * t64;
    work->t90 = t87 - t89;
    state->filter = work->t90;
    const float t91 = 0.860708f * t59;
    const float t92 = 0.860708f * t61;
    const float t93 = t91 + t92;
    const float t95 = -5.4369764e-8f * t64;
    work->t96 = t93 - t95;
    state->filter_2 = work->t96;
    const float t98 = 0.74134284f * t60;
    const float t100 = 0.02986321f * t61;
    const float t101 = t98 + t100;
    const float t103 = 0.0010004044f * work->t83;
    const float t104 = t101 + t103;
    const float t106 = -4.93195e-10f * t64;
    const float t107 = t104 - t106;
    state->filter_3 = t107;
    const float t109 = -0.012306268f * t60;
    const float t111 = 0.904606f * t61;
    const float t112 = t109 + t111;
    const float t114 = -8.028295e-6f * work->t83;
    const float t115 = t112 + t114;
    const float t117 = -2.658611e-9f * t64;
    const float t118 = t115 - t117;
    state->filter_4 = t118;
    const float t119 = 0.860708f * t80;
    const float t121 = 0.0009994135f * t81;
    const float t123 = 7.021338e-6f * work->t82;
    const float t124 = t119 + t121;
    const float t125 = t124 + t123;
    const float t127 = 0.13929202f * work->t32;
    const float t128 = t125 + t127;
    const float t130 = -1.1661682e-5f * work->t21;
    const float t131 = t128 + t130;
    const float t133 = 0.998745f * t81;
    const float t135 = 0.0135869365f * work->t82;
    const float t136 = t133 + t135;
    const float t138 = -0.017486073f * work->t21;
    const float t139 = t136 + t138;
    const float t141 = -0.032970965f * t81;
    const float t143 = 0.81849164f * work->t82;
    const float t144 = t141 + t143;
    const float t146 = 0.0003942745f * work->t21;
    const float t147 = t144 + t146;
    state->copy_q = t131;
    state->copy_dq = t139;
    state->copy_i = t147;
    work->t148 = t80 + work->t83;
    const float t150 = -359.093f * work->t90;
    const float t152 = 41.185257f * work->t96;
    const float t153 = t81 + t150;
    const float t154 = t153 + t152;
    const float t156 = 144.68756f * work->t83;
    work->t157 = t154 + t156;
}

/* Part 3 of a step. */
static void motor_recursive_part_3(motor_recursive_state *state, motor_recursive_work *work)
{
    const float t158 = 41.185257f * work->t90;
    const float t160 = -7.099819f * work->t96;
    const float t161 = work->t82 + t158;
    const float t162 = t161 + t160;
    const float t164 = -26.218584f * work->t83;
    const float t165 = t162 + t164;
    state->innovation[work->t11] = work->t83;

    /* the next measurement, as far as it is known */
    const float t166 = 0.0009994135f * work->t157;
    const float t167 = 7.021338e-6f * t165;
    const float t169 = -1.7493403e-5f * work->t21;
    const float t170 = work->t148 + t166;
    const float t171 = t170 + t167;
    const float t172 = t171 + t169;
    state->ahead_y = t172;

    /* the estimate; until the window is full, the start */
    const int t173 = 100U < work->t39;
    work->t174 = t173 ? work->t148 : work->t32;
    work->t175 = t173 ? work->t157 : 0.0f;
    work->t176 = t173 ? t165 : 0.0f;
    const uint32_t t177 = state->coasting;
    const int t178 = t177 == 0U;
    const motor_recursive_status t182 = t178 ? MOTOR_RECURSIVE_CONVERGED : MOTOR_RECURSIVE_COASTING;
    work->t183 = t173 ? t182 : MOTOR_RECURSIVE_CONVERGING;
}

void motor_recursive_init(motor_recursive_state *state)
{
    state->y = 0.0f;
    state->u = 0.0f;
    state->sin_q = 0.0f;
    state->newest = 100U;
    state->count = 0U;
    state->coasting = 0U;
    state->ahead_y = 0.0f;
    state->copy_q = 0.0f;
    state->copy_dq = 0.0f;
    state->copy_i = 0.0f;
    state->filter = 0.0f;
    state->filter_2 = 0.0f;
    state->filter_3 = 0.0f;
    state->filter_4 = 0.0f;
    for (uint32_t slot = 0U; slot < 101U; ++slot) {
        state->innovation[slot] = 0.0f;
    }
}

void motor_recursive_step(motor_recursive_state *state, const motor_recursive_measurements *measurements,
                          const motor_recursive_inputs *inputs, motor_recursive_estimate *estimate)
{
    motor_recursive_work work;
    motor_recursive_part_1(state, measurements, inputs, &work);
    motor_recursive_part_2(state, &work);
    motor_recursive_part_3(state, &work);

    estimate->q = work.t174;
    estimate->dq = work.t175;
    estimate->i = work.t176;
    estimate->status = work.t183;
}
