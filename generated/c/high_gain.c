/* high_gain.c: Finite-time observer: Swing of a crane's load, followed with high gain.
 *
 * Generated; high_gain.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "high_gain.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "high_gain.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "high_gain.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* The bits of a number. */
typedef union {
    float value;
    uint32_t bits;
} high_gain_f32_cell_t;

/* The bits of a number. */
static uint32_t high_gain_f32_to_bits(float x)
{
    high_gain_f32_cell_t cell;
    cell.value = x;
    return cell.bits;
}

/* The bit of the sign. */
#define HIGH_GAIN_SIGN_F32 UINT32_C(0x80000000)

/* The bits of the largest magnitude. */
#define HIGH_GAIN_MAGNITUDE_F32 UINT32_C(0x7FFFFFFF)

/* The bits of infinity. */
#define HIGH_GAIN_INFINITY_F32 UINT32_C(0x7F800000)

/* The bits of the only NaN that is returned. */
#define HIGH_GAIN_NAN_F32 UINT32_C(0x7FC00000)

/* The number with these bits. */
static float high_gain_f32_from_bits(uint32_t bits)
{
    high_gain_f32_cell_t cell;
    cell.bits = bits;
    return cell.value;
}

/* The number significand / 2^63 * 2^exponent, with the top bit of the significand set. */
typedef struct {
    uint64_t significand;
    int32_t exponent;
} high_gain_scaled_t;

/* A number with a sign. */
typedef struct {
    high_gain_scaled_t magnitude;
    int negative;
} high_gain_signed_t;

/* The angle quadrant * pi/2 + rest. */
typedef struct {
    high_gain_signed_t rest;
    uint32_t quadrant;
} high_gain_turned_t;

/* Attaches a sign. */
static high_gain_signed_t high_gain_signed(high_gain_scaled_t magnitude, int negative)
{
    high_gain_signed_t result;
    result.magnitude = magnitude;
    result.negative = negative;
    return result;
}

/* A number below 1 as fixed point with 64 fraction bits. */
static uint64_t high_gain_fraction(high_gain_scaled_t a)
{
    const int32_t shift = -1 - a.exponent;
    if (shift > 63) {
        return 0;
    }
    return a.significand >> shift;
}

/* The upper half of the product, at most 2 too small. */
static uint64_t high_gain_mul_high(uint64_t a, uint64_t b)
{
    const uint64_t a_high = a >> 32;
    const uint64_t a_low = a & 0xFFFFFFFFu;
    const uint64_t b_high = b >> 32;
    const uint64_t b_low = b & 0xFFFFFFFFu;
    const uint64_t cross = ((a_high * b_low) >> 32) + ((a_low * b_high) >> 32);
    return a_high * b_high + cross;
}

/* The square of a number below 1 as fixed point with 64 fraction bits. */
static uint64_t high_gain_squared_fraction(high_gain_scaled_t a)
{
    const uint64_t x = high_gain_fraction(a);
    return high_gain_mul_high(x, x);
}

/* Makes a number of a significand that has its top bit set. */
static high_gain_scaled_t high_gain_scaled(uint64_t significand, int32_t exponent)
{
    high_gain_scaled_t result;
    result.significand = significand;
    result.exponent = exponent;
    return result;
}

/* Makes a number of a significand of at least 2^62. */
static high_gain_scaled_t high_gain_settled(uint64_t significand, int32_t exponent)
{
    if ((significand >> 63) == 0) {
        return high_gain_scaled(significand << 1, exponent - 1);
    }
    return high_gain_scaled(significand, exponent);
}

/* (1 - cos(r)) / r^2 in powers of -r^2. */
static const uint64_t HIGH_GAIN_COSINE[8] = {
    UINT64_C(0x8000000000000000), UINT64_C(0x0AAAAAAAAAAAAAA8), UINT64_C(0x005B05B05B05B02B),
    UINT64_C(0x0001A01A01A01865), UINT64_C(0x0000049F93EDD666), UINT64_C(0x00000008F76C6243),
    UINT64_C(0x000000000C9C9706), UINT64_C(0x00000000000D551B)};

/* cos(r) for 0 < r <= pi/4, relative error below 2^-60. */
static high_gain_scaled_t high_gain_cosine(high_gain_scaled_t r)
{
    const uint64_t z = high_gain_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = HIGH_GAIN_COSINE[6] - ((HIGH_GAIN_COSINE[7] * z_high) >> 32);
    const uint64_t c5 = HIGH_GAIN_COSINE[5] - ((tail * z_high) >> 32);
    const uint64_t c4 = HIGH_GAIN_COSINE[4] - high_gain_mul_high(c5, z);
    const uint64_t c3 = HIGH_GAIN_COSINE[3] - high_gain_mul_high(c4, z);
    const uint64_t c2 = HIGH_GAIN_COSINE[2] - high_gain_mul_high(c3, z);
    const uint64_t c1 = HIGH_GAIN_COSINE[1] - high_gain_mul_high(c2, z);
    const uint64_t c0 = HIGH_GAIN_COSINE[0] - high_gain_mul_high(c1, z);
    return high_gain_settled((UINT64_C(1) << 63) - (high_gain_mul_high(c0, z) >> 1), 0);
}

/* (1 - sin(r) / r) / r^2 in powers of -r^2. */
static const uint64_t HIGH_GAIN_SINE[7] = {
    UINT64_C(0x2AAAAAAAAAAAAAA6), UINT64_C(0x0222222222222160), UINT64_C(0x000D00D00D00C575),
    UINT64_C(0x00002E3BC74A673D), UINT64_C(0x0000006B9914A637), UINT64_C(0x00000000B090498C),
    UINT64_C(0x0000000000D552BC)};

/* sin(r) for 0 < r <= pi/4, relative error below 2^-60. */
static high_gain_scaled_t high_gain_sine(high_gain_scaled_t r)
{
    const uint64_t z = high_gain_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = HIGH_GAIN_SINE[5] - ((HIGH_GAIN_SINE[6] * z_high) >> 32);
    const uint64_t c4 = HIGH_GAIN_SINE[4] - ((tail * z_high) >> 32);
    const uint64_t c3 = HIGH_GAIN_SINE[3] - high_gain_mul_high(c4, z);
    const uint64_t c2 = HIGH_GAIN_SINE[2] - high_gain_mul_high(c3, z);
    const uint64_t c1 = HIGH_GAIN_SINE[1] - high_gain_mul_high(c2, z);
    const uint64_t c0 = HIGH_GAIN_SINE[0] - high_gain_mul_high(c1, z);
    const uint64_t lost = high_gain_mul_high(r.significand, high_gain_mul_high(c0, z));
    return high_gain_settled(r.significand - lost, r.exponent);
}

/* The sine of an angle. */
static high_gain_signed_t high_gain_sine_at(high_gain_turned_t angle)
{
    const int back = (angle.quadrant & 2) != 0;
    if ((angle.quadrant & 1) != 0) {
        return high_gain_signed(high_gain_cosine(angle.rest.magnitude), back);
    }
    return high_gain_signed(high_gain_sine(angle.rest.magnitude), back != angle.rest.negative);
}

/* Makes an angle of its parts. */
static high_gain_turned_t high_gain_turned(high_gain_signed_t rest, uint32_t quadrant)
{
    high_gain_turned_t result;
    result.rest = rest;
    result.quadrant = quadrant;
    return result;
}

/* The number of zero bits above the highest one bit; x is not 0. */
static int32_t high_gain_leading_zeros(uint64_t x)
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
static high_gain_scaled_t high_gain_normalised(uint64_t significand, int32_t exponent)
{
    const int32_t shift = high_gain_leading_zeros(significand);
    return high_gain_scaled(significand << shift, exponent - shift);
}

/* The finite positive number with these bits, not 0; exact. */
static high_gain_scaled_t high_gain_unpacked_f32(uint32_t magnitude)
{
    const int32_t field = (int32_t)(magnitude >> 23);
    const uint64_t digits = (uint64_t)magnitude << 40;
    if (field == 0) {
        return high_gain_normalised(digits, -126);
    }
    return high_gain_scaled(digits | (UINT64_C(1) << 63), field - 127);
}

/* 2/pi after 32 zero bits. */
static const uint32_t HIGH_GAIN_TWO_OVER_PI_F32[9] = {
    UINT32_C(0x00000000), UINT32_C(0xA2F9836E), UINT32_C(0x4E441529),
    UINT32_C(0xFC2757D1), UINT32_C(0xF534DDC0), UINT32_C(0xDB629599),
    UINT32_C(0x3C439041), UINT32_C(0xFE5163AB), UINT32_C(0xDEBBC561)};

/* 32 bits of 2/pi from bit 32 slot + shift on. */
static uint64_t high_gain_window_f32(uint32_t slot, uint32_t shift)
{
    const uint64_t first = (uint64_t)(HIGH_GAIN_TWO_OVER_PI_F32[slot]);
    const uint64_t second = (uint64_t)(HIGH_GAIN_TWO_OVER_PI_F32[slot + 1]);
    return (((first << 32) | second) >> (32 - shift)) & 0xFFFFFFFFu;
}

/* a b, relative error below 2^-60. */
static high_gain_scaled_t high_gain_product(high_gain_scaled_t a, high_gain_scaled_t b)
{
    return high_gain_settled(high_gain_mul_high(a.significand, b.significand),
                            a.exponent + b.exponent + 1);
}

/* pi with 62 fraction bits; as a significand also pi/2 and pi/4. */
#define HIGH_GAIN_PI UINT64_C(0xC90FDAA22168C235)

/* The angle of (high, low) / 2^126 quarter turns, its rest exact to 2^-60 of itself. */
static high_gain_turned_t high_gain_turned_from_quarters(uint64_t high, uint64_t low)
{
    const uint64_t eighths = high >> 61;
    const int negative = (eighths & 1) != 0;
    uint64_t upper = (high << 2) | (low >> 62);
    uint64_t lower = low << 2;
    if (negative) {
        upper = (lower == 0) ? (UINT64_C(0) - upper) : UINT64_MAX - upper;
        lower = (UINT64_C(0) - lower);
    }
    const int32_t shift = high_gain_leading_zeros(upper | 1);
    const uint64_t significand = (upper << shift) | ((lower >> 1) >> (63 - shift));
    const high_gain_signed_t rest = high_gain_signed(
        high_gain_product(high_gain_scaled(significand, -1 - shift), high_gain_scaled(HIGH_GAIN_PI, 0)),
        negative);
    return high_gain_turned(rest, (uint32_t)(((eighths + 1) >> 1) & 3));
}

/* The angle with these bits, positive and finite, its rest exact to 2^-38 of itself. */
static high_gain_turned_t high_gain_reduce_f32(uint32_t magnitude)
{
    if (magnitude <= 0x3F490FDAu) {
        return high_gain_turned(high_gain_signed(high_gain_unpacked_f32(magnitude), 0), 0);
    }
    const uint64_t digits = (uint64_t)((magnitude & 0x007FFFFFu) | 0x00800000u);
    const uint32_t start = (magnitude >> 23) - 120;
    const uint32_t slot = start >> 5;
    const uint32_t shift = start & 31;
    const uint64_t upper = (high_gain_window_f32(slot, shift) * digits) << 32;
    const uint64_t middle = high_gain_window_f32(slot + 1, shift) * digits;
    const uint64_t lower = high_gain_window_f32(slot + 2, shift) * digits;
    return high_gain_turned_from_quarters(((upper + middle) + (lower >> 32)), lower << 32);
}

/* x rounded to the nearest, ties to even, with subnormals and overflow, and the sign put in. */
static float high_gain_rounded_f32(uint32_t sign, high_gain_scaled_t x)
{
    const int32_t field = x.exponent + 127;
    if (field >= 255) {
        return high_gain_f32_from_bits(sign | HIGH_GAIN_INFINITY_F32);
    }
    const int32_t shift = (field > 0) ? 40 : 41 - field;
    if (shift > 63) {
        const int least = shift == 64 && x.significand > (UINT64_C(1) << 63);
        return high_gain_f32_from_bits(least ? sign + 1 : sign);
    }
    const uint64_t kept = x.significand >> shift;
    const uint64_t rest = x.significand - (kept << shift);
    const uint64_t half = UINT64_C(1) << (shift - 1);
    const uint64_t odd = kept & 1;
    const uint64_t up = (rest + odd > half) ? 1 : 0;
    const uint32_t base = (field > 0) ? ((uint32_t)(field - 1)) << 23 : 0;
    return high_gain_f32_from_bits(sign | (base + ((uint32_t)(kept + up))));
}

/* The sign bit of a negative number, else 0. */
static uint32_t high_gain_sign_f32(int negative)
{
    if (negative) {
        return HIGH_GAIN_SIGN_F32;
    }
    return 0;
}

/* Sine of an angle in radians, the nearest float. */
static float high_gain_sin_f32(float x)
{
    const uint32_t bits = high_gain_f32_to_bits(x);
    const uint32_t magnitude = bits & HIGH_GAIN_MAGNITUDE_F32;
    if (magnitude >= HIGH_GAIN_INFINITY_F32) {
        return high_gain_f32_from_bits(HIGH_GAIN_NAN_F32);
    }
    if (magnitude == 0) {
        return x;
    }
    const high_gain_signed_t value = high_gain_sine_at(high_gain_reduce_f32(magnitude));
    return high_gain_rounded_f32((bits & HIGH_GAIN_SIGN_F32) ^ high_gain_sign_f32(value.negative),
                                value.magnitude);
}

/* What one part of a step hands to the next. */
typedef struct {
    float t71;
    float t72;
    uint32_t t78;
    uint32_t t83;
    high_gain_status t92;
} high_gain_work;

/* Part 1 of a step. */
static void high_gain_part_1(high_gain_state *state, const high_gain_measurements *measurements, const high_gain_inputs *inputs, high_gain_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    const float t0 = measurements->sway;
    const int t1 = (-1.0f <= t0) && (t0 <= 1.0f);
    const float t2 = inputs->trolley;
    const int t3 = (-1e36f <= t2) && (t2 <= 1e36f);
    const float t4 = state->last_trolley;
    const float t5 = t3 ? t2 : t4;

    /* prediction by the plant */
    const float t6 = state->sway;
    const float t7 = state->rate;
    const float t8 = state->last_known1;
    const float t10 = 0.0019999f * t7;
    const float t12 = -3.3332222e-7f * t5;
    const float t14 = -2.1799183e-6f * t8;
    const float t15 = t6 + t10;
    const float t16 = t15 + t12;
    const float t17 = t16 + t14;
    const float t18 = state->low_rate;
    const float t20 = -9.9995e-5f * t7;
    const float t22 = -0.00033331665f * t5;
    const float t24 = -0.001634891f * t8;
    const float t25 = t18 + t20;
    const float t26 = t25 + t22;
    const float t27 = t26 + t24;
    const float t29 = -1.0899728e-6f * t8;
    const float t30 = t17 + t29;
    const float t32 = state->last_sway;
    const int t33 = (-1.0f <= t30) && (t30 <= 1.0f);
    const float t34 = t33 ? t30 : t32;
    const float t35 = t1 ? t0 : t34;
    const float t36 = high_gain_sin_f32(t35);
    const float t37 = -1.0899728e-6f * t36;
    const float t38 = t17 + t37;
    const float t39 = -0.0016349455f * t36;
    const float t40 = t27 + t39;
    state->last_trolley = t5;
    state->last_known1 = t36;
    state->last_sway = t35;
    const int t41 = t3 && t1;

    /* correction by the innovation */
    const int t42 = (-1.0f <= t38) && (t38 <= 1.0f);
    const int t43 = t1 || t42;
    const int t44 = !t43;
    const float t46 = t35 - t38;
    const float t47 = t1 ? t46 : 0.0f;
    const float t49 = 0.038735095f * t47;
    const float t51 = 0.19030662f * t47;
    const float t52 = t38 + t49;
    const float t53 = t40 + t51;
    const float t54 = t7 + t53;
    const float t55 = t54 - t7;
    const float t56 = t54 - t55;
    const float t57 = t53 - t55;
    const float t58 = t7 - t56;
    const float t59 = t58 + t57;

    /* the first sample starts the observer; so does a state beyond all bounds */
    const uint32_t t61 = state->good;
    const int t62 = t61 == 0U;
    const int t63 = t62 || t44;
    const int t64 = (-1e36f <= t52) && (t52 <= 1e36f);
    const int t65 = !t64;
    const int t66 = t63 || t65;
    const int t67 = (-1e36f <= t54) && (t54 <= 1e36f);
    const int t68 = !t67;
    const int t69 = t66 || t68;
    const float t70 = t1 ? t35 : 0.0f;
    work->t71 = t69 ? t70 : t52;
    state->sway = work->t71;
    work->t72 = t69 ? 0.0f : t54;
    state->rate = work->t72;
    const float t73 = t69 ? 0.0f : t59;
    state->low_rate = t73;
    const uint32_t t75 = t1 ? 1U : 0U;
    const uint32_t t76 = (t61 < 848U) ? (t61 + 1U) : 848U;
    const uint32_t t77 = t1 ? t76 : t61;
    work->t78 = t69 ? t75 : t77;
    state->good = work->t78;
    const uint32_t t79 = state->clean;
    const uint32_t t80 = (t79 < 1006U) ? (t79 + 1U) : 1006U;
    const uint32_t t81 = t41 ? t80 : 0U;
    work->t83 = t69 ? 1006U : t81;
    state->clean = work->t83;
}

/* Part 2 of a step. */
static void high_gain_part_2(high_gain_work *work)
{
    /* the estimate */
    const int t86 = 847U < work->t78;
    const int t87 = 1005U < work->t83;
    const high_gain_status t91 = t87 ? HIGH_GAIN_CONVERGED : HIGH_GAIN_COASTING;
    work->t92 = t86 ? t91 : HIGH_GAIN_CONVERGING;
}

void high_gain_init(high_gain_state *state)
{
    state->sway = 0.0f;
    state->rate = 0.0f;
    state->low_rate = 0.0f;
    state->good = 0U;
    state->clean = 0U;
    state->last_sway = 0.0f;
    state->last_trolley = 0.0f;
    state->last_known1 = 0.0f;
}

void high_gain_step(high_gain_state *state, const high_gain_measurements *measurements,
                    const high_gain_inputs *inputs, high_gain_estimate *estimate)
{
    high_gain_work work;
    high_gain_part_1(state, measurements, inputs, &work);
    high_gain_part_2(&work);

    estimate->sway = work.t71;
    estimate->rate = work.t72;
    estimate->status = work.t92;
}
