/* kalman.c: Finite-time observer: Velocity of a free pendulum from its encoder, by a Kalman filter.
 *
 * Generated; kalman.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "kalman.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "kalman.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "kalman.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* The bits of a number. */
typedef union {
    float value;
    uint32_t bits;
} kalman_f32_cell_t;

/* The bits of a number. */
static uint32_t kalman_f32_to_bits(float x)
{
    kalman_f32_cell_t cell;
    cell.value = x;
    return cell.bits;
}

/* The bit of the sign. */
#define KALMAN_SIGN_F32 UINT32_C(0x80000000)

/* The bits of the largest magnitude. */
#define KALMAN_MAGNITUDE_F32 UINT32_C(0x7FFFFFFF)

/* The bits of infinity. */
#define KALMAN_INFINITY_F32 UINT32_C(0x7F800000)

/* The bits of the only NaN that is returned. */
#define KALMAN_NAN_F32 UINT32_C(0x7FC00000)

/* The number with these bits. */
static float kalman_f32_from_bits(uint32_t bits)
{
    kalman_f32_cell_t cell;
    cell.bits = bits;
    return cell.value;
}

/* The number significand / 2^63 * 2^exponent, with the top bit of the significand set. */
typedef struct {
    uint64_t significand;
    int32_t exponent;
} kalman_scaled_t;

/* A number with a sign. */
typedef struct {
    kalman_scaled_t magnitude;
    int negative;
} kalman_signed_t;

/* The angle quadrant * pi/2 + rest. */
typedef struct {
    kalman_signed_t rest;
    uint32_t quadrant;
} kalman_turned_t;

/* Attaches a sign. */
static kalman_signed_t kalman_signed(kalman_scaled_t magnitude, int negative)
{
    kalman_signed_t result;
    result.magnitude = magnitude;
    result.negative = negative;
    return result;
}

/* A number below 1 as fixed point with 64 fraction bits. */
static uint64_t kalman_fraction(kalman_scaled_t a)
{
    const int32_t shift = -1 - a.exponent;
    if (shift > 63) {
        return 0;
    }
    return a.significand >> shift;
}

/* The upper half of the product, at most 2 too small. */
static uint64_t kalman_mul_high(uint64_t a, uint64_t b)
{
    const uint64_t a_high = a >> 32;
    const uint64_t a_low = a & 0xFFFFFFFFu;
    const uint64_t b_high = b >> 32;
    const uint64_t b_low = b & 0xFFFFFFFFu;
    const uint64_t cross = ((a_high * b_low) >> 32) + ((a_low * b_high) >> 32);
    return a_high * b_high + cross;
}

/* The square of a number below 1 as fixed point with 64 fraction bits. */
static uint64_t kalman_squared_fraction(kalman_scaled_t a)
{
    const uint64_t x = kalman_fraction(a);
    return kalman_mul_high(x, x);
}

/* Makes a number of a significand that has its top bit set. */
static kalman_scaled_t kalman_scaled(uint64_t significand, int32_t exponent)
{
    kalman_scaled_t result;
    result.significand = significand;
    result.exponent = exponent;
    return result;
}

/* Makes a number of a significand of at least 2^62. */
static kalman_scaled_t kalman_settled(uint64_t significand, int32_t exponent)
{
    if ((significand >> 63) == 0) {
        return kalman_scaled(significand << 1, exponent - 1);
    }
    return kalman_scaled(significand, exponent);
}

/* (1 - cos(r)) / r^2 in powers of -r^2. */
static const uint64_t KALMAN_COSINE[8] = {
    UINT64_C(0x8000000000000000), UINT64_C(0x0AAAAAAAAAAAAAA8), UINT64_C(0x005B05B05B05B02B),
    UINT64_C(0x0001A01A01A01865), UINT64_C(0x0000049F93EDD666), UINT64_C(0x00000008F76C6243),
    UINT64_C(0x000000000C9C9706), UINT64_C(0x00000000000D551B)};

/* cos(r) for 0 < r <= pi/4, relative error below 2^-60. */
static kalman_scaled_t kalman_cosine(kalman_scaled_t r)
{
    const uint64_t z = kalman_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = KALMAN_COSINE[6] - ((KALMAN_COSINE[7] * z_high) >> 32);
    const uint64_t c5 = KALMAN_COSINE[5] - ((tail * z_high) >> 32);
    const uint64_t c4 = KALMAN_COSINE[4] - kalman_mul_high(c5, z);
    const uint64_t c3 = KALMAN_COSINE[3] - kalman_mul_high(c4, z);
    const uint64_t c2 = KALMAN_COSINE[2] - kalman_mul_high(c3, z);
    const uint64_t c1 = KALMAN_COSINE[1] - kalman_mul_high(c2, z);
    const uint64_t c0 = KALMAN_COSINE[0] - kalman_mul_high(c1, z);
    return kalman_settled((UINT64_C(1) << 63) - (kalman_mul_high(c0, z) >> 1), 0);
}

/* (1 - sin(r) / r) / r^2 in powers of -r^2. */
static const uint64_t KALMAN_SINE[7] = {
    UINT64_C(0x2AAAAAAAAAAAAAA6), UINT64_C(0x0222222222222160), UINT64_C(0x000D00D00D00C575),
    UINT64_C(0x00002E3BC74A673D), UINT64_C(0x0000006B9914A637), UINT64_C(0x00000000B090498C),
    UINT64_C(0x0000000000D552BC)};

/* sin(r) for 0 < r <= pi/4, relative error below 2^-60. */
static kalman_scaled_t kalman_sine(kalman_scaled_t r)
{
    const uint64_t z = kalman_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = KALMAN_SINE[5] - ((KALMAN_SINE[6] * z_high) >> 32);
    const uint64_t c4 = KALMAN_SINE[4] - ((tail * z_high) >> 32);
    const uint64_t c3 = KALMAN_SINE[3] - kalman_mul_high(c4, z);
    const uint64_t c2 = KALMAN_SINE[2] - kalman_mul_high(c3, z);
    const uint64_t c1 = KALMAN_SINE[1] - kalman_mul_high(c2, z);
    const uint64_t c0 = KALMAN_SINE[0] - kalman_mul_high(c1, z);
    const uint64_t lost = kalman_mul_high(r.significand, kalman_mul_high(c0, z));
    return kalman_settled(r.significand - lost, r.exponent);
}

/* The sine of an angle. */
static kalman_signed_t kalman_sine_at(kalman_turned_t angle)
{
    const int back = (angle.quadrant & 2) != 0;
    if ((angle.quadrant & 1) != 0) {
        return kalman_signed(kalman_cosine(angle.rest.magnitude), back);
    }
    return kalman_signed(kalman_sine(angle.rest.magnitude), back != angle.rest.negative);
}

/* Makes an angle of its parts. */
static kalman_turned_t kalman_turned(kalman_signed_t rest, uint32_t quadrant)
{
    kalman_turned_t result;
    result.rest = rest;
    result.quadrant = quadrant;
    return result;
}

/* The number of zero bits above the highest one bit; x is not 0. */
static int32_t kalman_leading_zeros(uint64_t x)
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
static kalman_scaled_t kalman_normalised(uint64_t significand, int32_t exponent)
{
    const int32_t shift = kalman_leading_zeros(significand);
    return kalman_scaled(significand << shift, exponent - shift);
}

/* The finite positive number with these bits, not 0; exact. */
static kalman_scaled_t kalman_unpacked_f32(uint32_t magnitude)
{
    const int32_t field = (int32_t)(magnitude >> 23);
    const uint64_t digits = (uint64_t)magnitude << 40;
    if (field == 0) {
        return kalman_normalised(digits, -126);
    }
    return kalman_scaled(digits | (UINT64_C(1) << 63), field - 127);
}

/* 2/pi after 32 zero bits. */
static const uint32_t KALMAN_TWO_OVER_PI_F32[9] = {
    UINT32_C(0x00000000), UINT32_C(0xA2F9836E), UINT32_C(0x4E441529),
    UINT32_C(0xFC2757D1), UINT32_C(0xF534DDC0), UINT32_C(0xDB629599),
    UINT32_C(0x3C439041), UINT32_C(0xFE5163AB), UINT32_C(0xDEBBC561)};

/* 32 bits of 2/pi from bit 32 slot + shift on. */
static uint64_t kalman_window_f32(uint32_t slot, uint32_t shift)
{
    const uint64_t first = (uint64_t)(KALMAN_TWO_OVER_PI_F32[slot]);
    const uint64_t second = (uint64_t)(KALMAN_TWO_OVER_PI_F32[slot + 1]);
    return (((first << 32) | second) >> (32 - shift)) & 0xFFFFFFFFu;
}

/* a b, relative error below 2^-60. */
static kalman_scaled_t kalman_product(kalman_scaled_t a, kalman_scaled_t b)
{
    return kalman_settled(kalman_mul_high(a.significand, b.significand),
                            a.exponent + b.exponent + 1);
}

/* pi with 62 fraction bits; as a significand also pi/2 and pi/4. */
#define KALMAN_PI UINT64_C(0xC90FDAA22168C235)

/* The angle of (high, low) / 2^126 quarter turns, its rest exact to 2^-60 of itself. */
static kalman_turned_t kalman_turned_from_quarters(uint64_t high, uint64_t low)
{
    const uint64_t eighths = high >> 61;
    const int negative = (eighths & 1) != 0;
    uint64_t upper = (high << 2) | (low >> 62);
    uint64_t lower = low << 2;
    if (negative) {
        upper = (lower == 0) ? (UINT64_C(0) - upper) : UINT64_MAX - upper;
        lower = (UINT64_C(0) - lower);
    }
    const int32_t shift = kalman_leading_zeros(upper | 1);
    const uint64_t significand = (upper << shift) | ((lower >> 1) >> (63 - shift));
    const kalman_signed_t rest = kalman_signed(
        kalman_product(kalman_scaled(significand, -1 - shift), kalman_scaled(KALMAN_PI, 0)),
        negative);
    return kalman_turned(rest, (uint32_t)(((eighths + 1) >> 1) & 3));
}

/* The angle with these bits, positive and finite, its rest exact to 2^-38 of itself. */
static kalman_turned_t kalman_reduce_f32(uint32_t magnitude)
{
    if (magnitude <= 0x3F490FDAu) {
        return kalman_turned(kalman_signed(kalman_unpacked_f32(magnitude), 0), 0);
    }
    const uint64_t digits = (uint64_t)((magnitude & 0x007FFFFFu) | 0x00800000u);
    const uint32_t start = (magnitude >> 23) - 120;
    const uint32_t slot = start >> 5;
    const uint32_t shift = start & 31;
    const uint64_t upper = (kalman_window_f32(slot, shift) * digits) << 32;
    const uint64_t middle = kalman_window_f32(slot + 1, shift) * digits;
    const uint64_t lower = kalman_window_f32(slot + 2, shift) * digits;
    return kalman_turned_from_quarters(((upper + middle) + (lower >> 32)), lower << 32);
}

/* x rounded to the nearest, ties to even, with subnormals and overflow, and the sign put in. */
static float kalman_rounded_f32(uint32_t sign, kalman_scaled_t x)
{
    const int32_t field = x.exponent + 127;
    if (field >= 255) {
        return kalman_f32_from_bits(sign | KALMAN_INFINITY_F32);
    }
    const int32_t shift = (field > 0) ? 40 : 41 - field;
    if (shift > 63) {
        const int least = shift == 64 && x.significand > (UINT64_C(1) << 63);
        return kalman_f32_from_bits(least ? sign + 1 : sign);
    }
    const uint64_t kept = x.significand >> shift;
    const uint64_t rest = x.significand - (kept << shift);
    const uint64_t half = UINT64_C(1) << (shift - 1);
    const uint64_t odd = kept & 1;
    const uint64_t up = (rest + odd > half) ? 1 : 0;
    const uint32_t base = (field > 0) ? ((uint32_t)(field - 1)) << 23 : 0;
    return kalman_f32_from_bits(sign | (base + ((uint32_t)(kept + up))));
}

/* The sign bit of a negative number, else 0. */
static uint32_t kalman_sign_f32(int negative)
{
    if (negative) {
        return KALMAN_SIGN_F32;
    }
    return 0;
}

/* Sine of an angle in radians, the nearest float. */
static float kalman_sin_f32(float x)
{
    const uint32_t bits = kalman_f32_to_bits(x);
    const uint32_t magnitude = bits & KALMAN_MAGNITUDE_F32;
    if (magnitude >= KALMAN_INFINITY_F32) {
        return kalman_f32_from_bits(KALMAN_NAN_F32);
    }
    if (magnitude == 0) {
        return x;
    }
    const kalman_signed_t value = kalman_sine_at(kalman_reduce_f32(magnitude));
    return kalman_rounded_f32((bits & KALMAN_SIGN_F32) ^ kalman_sign_f32(value.negative),
                                value.magnitude);
}

void kalman_init(kalman_state *state)
{
    state->theta = 0.0f;
    state->omega = 0.0f;
    state->good = 0U;
    state->clean = 0U;
    state->last_theta = 0.0f;
    state->last_known0 = 0.0f;
}

void kalman_step(kalman_state *state, const kalman_measurements *measurements,
                 kalman_estimate *estimate)
{
    /* samples: outside its range, infinite or NaN means missing */
    const float t0 = measurements->theta;
    const int t1 = (-1e36f <= t0) && (t0 <= 1e36f);

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
    const int t21 = (-1e36f <= t18) && (t18 <= 1e36f);
    const float t22 = t21 ? t18 : t20;
    const float t23 = t1 ? t0 : t22;
    const float t24 = kalman_sin_f32(t23);
    const float t25 = 1.070297e-5f * t24;
    const float t26 = t10 + t25;
    const float t27 = 0.03210873f * t24;
    const float t28 = t15 + t27;
    state->last_known0 = t24;
    state->last_theta = t23;

    /* correction by the innovation */
    const float t30 = t23 - t26;
    const float t31 = t1 ? t30 : 0.0f;
    const float t33 = 0.06820253f * t31;
    const float t35 = 2.4086564f * t31;
    const float t36 = t26 + t33;
    const float t37 = t28 + t35;

    /* the first sample starts the observer; so does a state beyond all bounds */
    const uint32_t t39 = state->good;
    const int t40 = t39 == 0U;
    const int t41 = (-1e36f <= t36) && (t36 <= 1e36f);
    const int t42 = !t41;
    const int t43 = t40 || t42;
    const int t44 = (-1e36f <= t37) && (t37 <= 1e36f);
    const int t45 = !t44;
    const int t46 = t43 || t45;
    const float t47 = t1 ? t23 : 0.0f;
    const float t48 = t46 ? t47 : t36;
    state->theta = t48;
    const float t49 = t46 ? 0.0f : t37;
    state->omega = t49;
    const uint32_t t51 = t1 ? 1U : 0U;
    const uint32_t t52 = (t39 < 397U) ? (t39 + 1U) : 397U;
    const uint32_t t53 = t1 ? t52 : t39;
    const uint32_t t54 = t46 ? t51 : t53;
    state->good = t54;
    const uint32_t t55 = state->clean;
    const uint32_t t56 = (t55 < 492U) ? (t55 + 1U) : 492U;
    const uint32_t t57 = t1 ? t56 : 0U;
    const uint32_t t59 = t46 ? 492U : t57;
    state->clean = t59;

    /* the estimate */
    const int t62 = 396U < t54;
    const int t63 = 491U < t59;
    const kalman_status t67 = t63 ? KALMAN_CONVERGED : KALMAN_COASTING;
    const kalman_status t68 = t62 ? t67 : KALMAN_CONVERGING;

    estimate->theta = t48;
    estimate->omega = t49;
    estimate->status = t68;
}
