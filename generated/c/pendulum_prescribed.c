/* pendulum_prescribed.c: Finite-time observer: Velocity of a free pendulum by a prescribed time, from two numbers of state.
 *
 * Generated; pendulum_prescribed.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "pendulum_prescribed.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "pendulum_prescribed.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "pendulum_prescribed.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* The bits of a number. */
typedef union {
    float value;
    uint32_t bits;
} pendulum_prescribed_f32_cell_t;

/* The bits of a number. */
static uint32_t pendulum_prescribed_f32_to_bits(float x)
{
    pendulum_prescribed_f32_cell_t cell;
    cell.value = x;
    return cell.bits;
}

/* The bit of the sign. */
#define PENDULUM_PRESCRIBED_SIGN_F32 UINT32_C(0x80000000)

/* The bits of the largest magnitude. */
#define PENDULUM_PRESCRIBED_MAGNITUDE_F32 UINT32_C(0x7FFFFFFF)

/* The bits of infinity. */
#define PENDULUM_PRESCRIBED_INFINITY_F32 UINT32_C(0x7F800000)

/* The bits of the only NaN that is returned. */
#define PENDULUM_PRESCRIBED_NAN_F32 UINT32_C(0x7FC00000)

/* The number with these bits. */
static float pendulum_prescribed_f32_from_bits(uint32_t bits)
{
    pendulum_prescribed_f32_cell_t cell;
    cell.bits = bits;
    return cell.value;
}

/* The number significand / 2^63 * 2^exponent, with the top bit of the significand set. */
typedef struct {
    uint64_t significand;
    int32_t exponent;
} pendulum_prescribed_scaled_t;

/* A number with a sign. */
typedef struct {
    pendulum_prescribed_scaled_t magnitude;
    int negative;
} pendulum_prescribed_signed_t;

/* The angle quadrant * pi/2 + rest. */
typedef struct {
    pendulum_prescribed_signed_t rest;
    uint32_t quadrant;
} pendulum_prescribed_turned_t;

/* Attaches a sign. */
static pendulum_prescribed_signed_t pendulum_prescribed_signed(pendulum_prescribed_scaled_t magnitude, int negative)
{
    pendulum_prescribed_signed_t result;
    result.magnitude = magnitude;
    result.negative = negative;
    return result;
}

/* A number below 1 as fixed point with 64 fraction bits. */
static uint64_t pendulum_prescribed_fraction(pendulum_prescribed_scaled_t a)
{
    const int32_t shift = -1 - a.exponent;
    if (shift > 63) {
        return 0;
    }
    return a.significand >> shift;
}

/* The upper half of the product, at most 2 too small. */
static uint64_t pendulum_prescribed_mul_high(uint64_t a, uint64_t b)
{
    const uint64_t a_high = a >> 32;
    const uint64_t a_low = a & 0xFFFFFFFFu;
    const uint64_t b_high = b >> 32;
    const uint64_t b_low = b & 0xFFFFFFFFu;
    const uint64_t cross = ((a_high * b_low) >> 32) + ((a_low * b_high) >> 32);
    return a_high * b_high + cross;
}

/* The square of a number below 1 as fixed point with 64 fraction bits. */
static uint64_t pendulum_prescribed_squared_fraction(pendulum_prescribed_scaled_t a)
{
    const uint64_t x = pendulum_prescribed_fraction(a);
    return pendulum_prescribed_mul_high(x, x);
}

/* Makes a number of a significand that has its top bit set. */
static pendulum_prescribed_scaled_t pendulum_prescribed_scaled(uint64_t significand, int32_t exponent)
{
    pendulum_prescribed_scaled_t result;
    result.significand = significand;
    result.exponent = exponent;
    return result;
}

/* Makes a number of a significand of at least 2^62. */
static pendulum_prescribed_scaled_t pendulum_prescribed_settled(uint64_t significand, int32_t exponent)
{
    if ((significand >> 63) == 0) {
        return pendulum_prescribed_scaled(significand << 1, exponent - 1);
    }
    return pendulum_prescribed_scaled(significand, exponent);
}

/* (1 - cos(r)) / r^2 in powers of -r^2. */
static const uint64_t PENDULUM_PRESCRIBED_COSINE[8] = {
    UINT64_C(0x8000000000000000), UINT64_C(0x0AAAAAAAAAAAAAA8), UINT64_C(0x005B05B05B05B02B),
    UINT64_C(0x0001A01A01A01865), UINT64_C(0x0000049F93EDD666), UINT64_C(0x00000008F76C6243),
    UINT64_C(0x000000000C9C9706), UINT64_C(0x00000000000D551B)};

/* cos(r) for 0 < r <= pi/4, relative error below 2^-60. */
static pendulum_prescribed_scaled_t pendulum_prescribed_cosine(pendulum_prescribed_scaled_t r)
{
    const uint64_t z = pendulum_prescribed_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = PENDULUM_PRESCRIBED_COSINE[6] - ((PENDULUM_PRESCRIBED_COSINE[7] * z_high) >> 32);
    const uint64_t c5 = PENDULUM_PRESCRIBED_COSINE[5] - ((tail * z_high) >> 32);
    const uint64_t c4 = PENDULUM_PRESCRIBED_COSINE[4] - pendulum_prescribed_mul_high(c5, z);
    const uint64_t c3 = PENDULUM_PRESCRIBED_COSINE[3] - pendulum_prescribed_mul_high(c4, z);
    const uint64_t c2 = PENDULUM_PRESCRIBED_COSINE[2] - pendulum_prescribed_mul_high(c3, z);
    const uint64_t c1 = PENDULUM_PRESCRIBED_COSINE[1] - pendulum_prescribed_mul_high(c2, z);
    const uint64_t c0 = PENDULUM_PRESCRIBED_COSINE[0] - pendulum_prescribed_mul_high(c1, z);
    return pendulum_prescribed_settled((UINT64_C(1) << 63) - (pendulum_prescribed_mul_high(c0, z) >> 1), 0);
}

/* (1 - sin(r) / r) / r^2 in powers of -r^2. */
static const uint64_t PENDULUM_PRESCRIBED_SINE[7] = {
    UINT64_C(0x2AAAAAAAAAAAAAA6), UINT64_C(0x0222222222222160), UINT64_C(0x000D00D00D00C575),
    UINT64_C(0x00002E3BC74A673D), UINT64_C(0x0000006B9914A637), UINT64_C(0x00000000B090498C),
    UINT64_C(0x0000000000D552BC)};

/* sin(r) for 0 < r <= pi/4, relative error below 2^-60. */
static pendulum_prescribed_scaled_t pendulum_prescribed_sine(pendulum_prescribed_scaled_t r)
{
    const uint64_t z = pendulum_prescribed_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = PENDULUM_PRESCRIBED_SINE[5] - ((PENDULUM_PRESCRIBED_SINE[6] * z_high) >> 32);
    const uint64_t c4 = PENDULUM_PRESCRIBED_SINE[4] - ((tail * z_high) >> 32);
    const uint64_t c3 = PENDULUM_PRESCRIBED_SINE[3] - pendulum_prescribed_mul_high(c4, z);
    const uint64_t c2 = PENDULUM_PRESCRIBED_SINE[2] - pendulum_prescribed_mul_high(c3, z);
    const uint64_t c1 = PENDULUM_PRESCRIBED_SINE[1] - pendulum_prescribed_mul_high(c2, z);
    const uint64_t c0 = PENDULUM_PRESCRIBED_SINE[0] - pendulum_prescribed_mul_high(c1, z);
    const uint64_t lost = pendulum_prescribed_mul_high(r.significand, pendulum_prescribed_mul_high(c0, z));
    return pendulum_prescribed_settled(r.significand - lost, r.exponent);
}

/* The sine of an angle. */
static pendulum_prescribed_signed_t pendulum_prescribed_sine_at(pendulum_prescribed_turned_t angle)
{
    const int back = (angle.quadrant & 2) != 0;
    if ((angle.quadrant & 1) != 0) {
        return pendulum_prescribed_signed(pendulum_prescribed_cosine(angle.rest.magnitude), back);
    }
    return pendulum_prescribed_signed(pendulum_prescribed_sine(angle.rest.magnitude), back != angle.rest.negative);
}

/* Makes an angle of its parts. */
static pendulum_prescribed_turned_t pendulum_prescribed_turned(pendulum_prescribed_signed_t rest, uint32_t quadrant)
{
    pendulum_prescribed_turned_t result;
    result.rest = rest;
    result.quadrant = quadrant;
    return result;
}

/* The number of zero bits above the highest one bit; x is not 0. */
static int32_t pendulum_prescribed_leading_zeros(uint64_t x)
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
static pendulum_prescribed_scaled_t pendulum_prescribed_normalised(uint64_t significand, int32_t exponent)
{
    const int32_t shift = pendulum_prescribed_leading_zeros(significand);
    return pendulum_prescribed_scaled(significand << shift, exponent - shift);
}

/* The finite positive number with these bits, not 0; exact. */
static pendulum_prescribed_scaled_t pendulum_prescribed_unpacked_f32(uint32_t magnitude)
{
    const int32_t field = (int32_t)(magnitude >> 23);
    const uint64_t digits = (uint64_t)magnitude << 40;
    if (field == 0) {
        return pendulum_prescribed_normalised(digits, -126);
    }
    return pendulum_prescribed_scaled(digits | (UINT64_C(1) << 63), field - 127);
}

/* 2/pi after 32 zero bits. */
static const uint32_t PENDULUM_PRESCRIBED_TWO_OVER_PI_F32[9] = {
    UINT32_C(0x00000000), UINT32_C(0xA2F9836E), UINT32_C(0x4E441529),
    UINT32_C(0xFC2757D1), UINT32_C(0xF534DDC0), UINT32_C(0xDB629599),
    UINT32_C(0x3C439041), UINT32_C(0xFE5163AB), UINT32_C(0xDEBBC561)};

/* 32 bits of 2/pi from bit 32 slot + shift on. */
static uint64_t pendulum_prescribed_window_f32(uint32_t slot, uint32_t shift)
{
    const uint64_t first = (uint64_t)(PENDULUM_PRESCRIBED_TWO_OVER_PI_F32[slot]);
    const uint64_t second = (uint64_t)(PENDULUM_PRESCRIBED_TWO_OVER_PI_F32[slot + 1]);
    return (((first << 32) | second) >> (32 - shift)) & 0xFFFFFFFFu;
}

/* a b, relative error below 2^-60. */
static pendulum_prescribed_scaled_t pendulum_prescribed_product(pendulum_prescribed_scaled_t a, pendulum_prescribed_scaled_t b)
{
    return pendulum_prescribed_settled(pendulum_prescribed_mul_high(a.significand, b.significand),
                            a.exponent + b.exponent + 1);
}

/* pi with 62 fraction bits; as a significand also pi/2 and pi/4. */
#define PENDULUM_PRESCRIBED_PI UINT64_C(0xC90FDAA22168C235)

/* The angle of (high, low) / 2^126 quarter turns, its rest exact to 2^-60 of itself. */
static pendulum_prescribed_turned_t pendulum_prescribed_turned_from_quarters(uint64_t high, uint64_t low)
{
    const uint64_t eighths = high >> 61;
    const int negative = (eighths & 1) != 0;
    uint64_t upper = (high << 2) | (low >> 62);
    uint64_t lower = low << 2;
    if (negative) {
        upper = (lower == 0) ? (UINT64_C(0) - upper) : UINT64_MAX - upper;
        lower = (UINT64_C(0) - lower);
    }
    const int32_t shift = pendulum_prescribed_leading_zeros(upper | 1);
    const uint64_t significand = (upper << shift) | ((lower >> 1) >> (63 - shift));
    const pendulum_prescribed_signed_t rest = pendulum_prescribed_signed(
        pendulum_prescribed_product(pendulum_prescribed_scaled(significand, -1 - shift), pendulum_prescribed_scaled(PENDULUM_PRESCRIBED_PI, 0)),
        negative);
    return pendulum_prescribed_turned(rest, (uint32_t)(((eighths + 1) >> 1) & 3));
}

/* The angle with these bits, positive and finite, its rest exact to 2^-38 of itself. */
static pendulum_prescribed_turned_t pendulum_prescribed_reduce_f32(uint32_t magnitude)
{
    if (magnitude <= 0x3F490FDAu) {
        return pendulum_prescribed_turned(pendulum_prescribed_signed(pendulum_prescribed_unpacked_f32(magnitude), 0), 0);
    }
    const uint64_t digits = (uint64_t)((magnitude & 0x007FFFFFu) | 0x00800000u);
    const uint32_t start = (magnitude >> 23) - 120;
    const uint32_t slot = start >> 5;
    const uint32_t shift = start & 31;
    const uint64_t upper = (pendulum_prescribed_window_f32(slot, shift) * digits) << 32;
    const uint64_t middle = pendulum_prescribed_window_f32(slot + 1, shift) * digits;
    const uint64_t lower = pendulum_prescribed_window_f32(slot + 2, shift) * digits;
    return pendulum_prescribed_turned_from_quarters(((upper + middle) + (lower >> 32)), lower << 32);
}

/* x rounded to the nearest, ties to even, with subnormals and overflow, and the sign put in. */
static float pendulum_prescribed_rounded_f32(uint32_t sign, pendulum_prescribed_scaled_t x)
{
    const int32_t field = x.exponent + 127;
    if (field >= 255) {
        return pendulum_prescribed_f32_from_bits(sign | PENDULUM_PRESCRIBED_INFINITY_F32);
    }
    const int32_t shift = (field > 0) ? 40 : 41 - field;
    if (shift > 63) {
        const int least = shift == 64 && x.significand > (UINT64_C(1) << 63);
        return pendulum_prescribed_f32_from_bits(least ? sign + 1 : sign);
    }
    const uint64_t kept = x.significand >> shift;
    const uint64_t rest = x.significand - (kept << shift);
    const uint64_t half = UINT64_C(1) << (shift - 1);
    const uint64_t odd = kept & 1;
    const uint64_t up = (rest + odd > half) ? 1 : 0;
    const uint32_t base = (field > 0) ? ((uint32_t)(field - 1)) << 23 : 0;
    return pendulum_prescribed_f32_from_bits(sign | (base + ((uint32_t)(kept + up))));
}

/* The sign bit of a negative number, else 0. */
static uint32_t pendulum_prescribed_sign_f32(int negative)
{
    if (negative) {
        return PENDULUM_PRESCRIBED_SIGN_F32;
    }
    return 0;
}

/* Sine of an angle in radians, the nearest float. */
static float pendulum_prescribed_sin_f32(float x)
{
    const uint32_t bits = pendulum_prescribed_f32_to_bits(x);
    const uint32_t magnitude = bits & PENDULUM_PRESCRIBED_MAGNITUDE_F32;
    if (magnitude >= PENDULUM_PRESCRIBED_INFINITY_F32) {
        return pendulum_prescribed_f32_from_bits(PENDULUM_PRESCRIBED_NAN_F32);
    }
    if (magnitude == 0) {
        return x;
    }
    const pendulum_prescribed_signed_t value = pendulum_prescribed_sine_at(pendulum_prescribed_reduce_f32(magnitude));
    return pendulum_prescribed_rounded_f32((bits & PENDULUM_PRESCRIBED_SIGN_F32) ^ pendulum_prescribed_sign_f32(value.negative),
                                value.magnitude);
}

/* What one part of a step hands to the next. */
typedef struct {
    float t75;
    float t76;
    pendulum_prescribed_status t96;
} pendulum_prescribed_work;

/* Part 1 of a step. */
static void pendulum_prescribed_part_1(pendulum_prescribed_state *state, const pendulum_prescribed_measurements *measurements, pendulum_prescribed_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    const float t0 = measurements->theta;
    const int t1 = (-1e34f <= t0) && (t0 <= 1e34f);

    /* prediction by the plant */
    const float t2 = state->theta;
    const float t3 = state->omega;
    const float t4 = state->last_known0;
    const float t6 = 0.0009999664f * t3;
    const float t8 = 2.140576e-5f * t4;
    const float t9 = t2 + t6;
    const float t10 = t9 + t8;
    const float t12 = 0.99993277f * t3;
    const float t14 = 0.032108013f * t4;
    const float t15 = t12 + t14;
    const float t17 = 1.070297e-5f * t4;
    const float t18 = t10 + t17;
    const float t20 = state->last_theta;
    const int t21 = (-1e34f <= t18) && (t18 <= 1e34f);
    const float t22 = t21 ? t18 : t20;
    const float t23 = t1 ? t0 : t22;
    const float t24 = pendulum_prescribed_sin_f32(t23);
    const float t25 = 1.070297e-5f * t24;
    const float t26 = t10 + t25;
    const float t27 = 0.03210873f * t24;
    const float t28 = t15 + t27;
    state->last_known0 = t24;
    state->last_theta = t23;

    /* correction by the innovation */
    const float t30 = t23 - t26;
    const float t31 = t1 ? t30 : 0.0f;
    const uint32_t t32 = state->left;
    const uint32_t t33 = (t32 < 50U) ? t32 : 50U;
    const uint32_t t34 = (t33 > 0U) ? (t33 - 1U) : 0U;
    const uint32_t t35 = t1 ? t34 : t33;
    const float t36 = (float)t35;
    const float t38 = 0.0625f * t36;
    const float t40 = t38 + 0.625f;
    const float t41 = t40 * t40;
    const float t43 = 1.25f * t40;
    const float t45 = t43 + 0.390625f;
    const float t46 = t41 + t45;
    const float t47 = t31 / t46;
    const float t48 = t45 * t47;
    const float t49 = 0.390625f * t47;
    const float t51 = 1.0000672f * t48;
    const float t53 = -6.722926e-5f * t31;
    const float t54 = t51 + t53;
    const float t56 = -0.06723152f * t48;
    const float t58 = 1000.0336f * t49;
    const float t60 = 4.5196216e-6f * t31;
    const float t61 = t56 + t58;
    const float t62 = t61 + t60;
    const float t63 = t26 + t54;
    const float t64 = t28 + t62;

    /* the first sample starts the observer; so does a state beyond all bounds */
    const uint32_t t66 = state->good;
    const int t67 = t66 == 0U;
    const int t68 = (-1e34f <= t63) && (t63 <= 1e34f);
    const int t69 = !t68;
    const int t70 = t67 || t69;
    const int t71 = (-1e34f <= t64) && (t64 <= 1e34f);
    const int t72 = !t71;
    const int t73 = t70 || t72;
    const float t74 = t1 ? t23 : 0.0f;
    work->t75 = t73 ? t74 : t63;
    state->theta = work->t75;
    work->t76 = t73 ? 0.0f : t64;
    state->omega = work->t76;
    const uint32_t t78 = t73 ? 50U : t35;
    state->left = t78;
    const uint32_t t80 = t1 ? 1U : 0U;
    const uint32_t t81 = (t66 < 51U) ? (t66 + 1U) : 51U;
    const uint32_t t82 = t1 ? t81 : t66;
    const uint32_t t83 = t73 ? t80 : t82;
    state->good = t83;
    const uint32_t t84 = state->clean;
    const uint32_t t85 = (t84 < 29U) ? (t84 + 1U) : 29U;
    const uint32_t t86 = t1 ? t85 : 0U;
    const uint32_t t88 = t73 ? 29U : t86;
    state->clean = t88;

    /* the estimate */
    const int t90 = 50U < t83;
    const int t91 = 28U < t88;
    const pendulum_prescribed_status t95 = t91 ? PENDULUM_PRESCRIBED_CONVERGED : PENDULUM_PRESCRIBED_COASTING;
    work->t96 = t90 ? t95 : PENDULUM_PRESCRIBED_CONVERGING;
}

void pendulum_prescribed_init(pendulum_prescribed_state *state)
{
    state->theta = 0.0f;
    state->omega = 0.0f;
    state->left = 50U;
    state->good = 0U;
    state->clean = 0U;
    state->last_theta = 0.0f;
    state->last_known0 = 0.0f;
}

void pendulum_prescribed_step(pendulum_prescribed_state *state, const pendulum_prescribed_measurements *measurements,
                              pendulum_prescribed_estimate *estimate)
{
    pendulum_prescribed_work work;
    pendulum_prescribed_part_1(state, measurements, &work);

    estimate->theta = work.t75;
    estimate->omega = work.t76;
    estimate->status = work.t96;
}
