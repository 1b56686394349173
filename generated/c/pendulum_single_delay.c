/* pendulum_single_delay.c: Finite-time observer: Velocity of a free pendulum from its encoder, reduced order.
 *
 * Generated; pendulum_single_delay.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "pendulum_single_delay.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "pendulum_single_delay.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "pendulum_single_delay.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* weights by age, from age 0
 *   [0] theta from theta
 *   [1] omega from theta
 *   [2] omega from sin(theta)
 */
static const float PENDULUM_SINGLE_DELAY_WINDOW[51][3] = {
    { 1.0f, 19.20685f, 0.03190316f },
    { 0.0f, 0.3614265f, 0.06297732f },
    { 0.0f, 0.35688573f, 0.061716523f },
    { 0.0f, 0.35158855f, 0.060432903f },
    { 0.0f, 0.3454899f, 0.059126798f },
    { 0.0f, 0.33854255f, 0.057798605f },
    { 0.0f, 0.33069706f, 0.05644877f },
    { 0.0f, 0.3219017f, 0.0550778f },
    { 0.0f, 0.31210223f, 0.05368626f },
    { 0.0f, 0.3012419f, 0.052274786f },
    { 0.0f, 0.28926128f, 0.05084407f },
    { 0.0f, 0.27609822f, 0.04939489f },
    { 0.0f, 0.26168764f, 0.04792809f },
    { 0.0f, 0.2459615f, 0.0464446f },
    { 0.0f, 0.22884859f, 0.044945426f },
    { 0.0f, 0.21027443f, 0.043431677f },
    { 0.0f, 0.19016112f, 0.04190454f },
    { 0.0f, 0.16842724f, 0.040365312f },
    { 0.0f, 0.14498766f, 0.038815387f },
    { 0.0f, 0.11975334f, 0.037256278f },
    { 0.0f, 0.09263125f, 0.035689604f },
    { 0.0f, 0.06352417f, 0.034117106f },
    { 0.0f, 0.03233048f, 0.03254066f },
    { 0.0f, -0.0010559898f, 0.030962266f },
    { 0.0f, -0.03674616f, 0.02938407f },
    { 0.0f, -0.07485591f, 0.027808366f },
    { 0.0f, -0.11550626f, 0.026237601f },
    { 0.0f, -0.15882364f, 0.02467439f },
    { 0.0f, -0.20494005f, 0.023121512f },
    { 0.0f, -0.25399333f, 0.02158193f },
    { 0.0f, -0.30612746f, 0.020058796f },
    { 0.0f, -0.36149266f, 0.018555457f },
    { 0.0f, -0.4202458f, 0.017075468f },
    { 0.0f, -0.48255065f, 0.015622605f },
    { 0.0f, -0.5485781f, 0.014200866f },
    { 0.0f, -0.61850655f, 0.012814493f },
    { 0.0f, -0.69252205f, 0.011467976f },
    { 0.0f, -0.7708189f, 0.010166066f },
    { 0.0f, -0.8535997f, 0.008913792f },
    { 0.0f, -0.9410759f, 0.0077164667f },
    { 0.0f, -1.0334681f, 0.006579708f },
    { 0.0f, -1.1310064f, 0.0055094464f },
    { 0.0f, -1.2339307f, 0.0045119445f },
    { 0.0f, -1.3424914f, 0.0035938087f },
    { 0.0f, -1.4569495f, 0.0027620082f },
    { 0.0f, -1.5775774f, 0.0020238904f },
    { 0.0f, -1.7046587f, 0.0013871982f },
    { 0.0f, -1.8384899f, 0.0008600887f },
    { 0.0f, -1.9793792f, 0.00045115198f },
    { 0.0f, -2.1276486f, 0.00016943112f },
    { 0.0f, -2.2836337f, 2.4442485e-5f }
};

/* The bits of a number. */
typedef union {
    float value;
    uint32_t bits;
} pendulum_single_delay_f32_cell_t;

/* The bits of a number. */
static uint32_t pendulum_single_delay_f32_to_bits(float x)
{
    pendulum_single_delay_f32_cell_t cell;
    cell.value = x;
    return cell.bits;
}

/* The bit of the sign. */
#define PENDULUM_SINGLE_DELAY_SIGN_F32 UINT32_C(0x80000000)

/* The bits of the largest magnitude. */
#define PENDULUM_SINGLE_DELAY_MAGNITUDE_F32 UINT32_C(0x7FFFFFFF)

/* The bits of infinity. */
#define PENDULUM_SINGLE_DELAY_INFINITY_F32 UINT32_C(0x7F800000)

/* The bits of the only NaN that is returned. */
#define PENDULUM_SINGLE_DELAY_NAN_F32 UINT32_C(0x7FC00000)

/* The number with these bits. */
static float pendulum_single_delay_f32_from_bits(uint32_t bits)
{
    pendulum_single_delay_f32_cell_t cell;
    cell.bits = bits;
    return cell.value;
}

/* The number significand / 2^63 * 2^exponent, with the top bit of the significand set. */
typedef struct {
    uint64_t significand;
    int32_t exponent;
} pendulum_single_delay_scaled_t;

/* A number with a sign. */
typedef struct {
    pendulum_single_delay_scaled_t magnitude;
    int negative;
} pendulum_single_delay_signed_t;

/* The angle quadrant * pi/2 + rest. */
typedef struct {
    pendulum_single_delay_signed_t rest;
    uint32_t quadrant;
} pendulum_single_delay_turned_t;

/* Attaches a sign. */
static pendulum_single_delay_signed_t pendulum_single_delay_signed(pendulum_single_delay_scaled_t magnitude, int negative)
{
    pendulum_single_delay_signed_t result;
    result.magnitude = magnitude;
    result.negative = negative;
    return result;
}

/* A number below 1 as fixed point with 64 fraction bits. */
static uint64_t pendulum_single_delay_fraction(pendulum_single_delay_scaled_t a)
{
    const int32_t shift = -1 - a.exponent;
    if (shift > 63) {
        return 0;
    }
    return a.significand >> shift;
}

/* The upper half of the product, at most 2 too small. */
static uint64_t pendulum_single_delay_mul_high(uint64_t a, uint64_t b)
{
    const uint64_t a_high = a >> 32;
    const uint64_t a_low = a & 0xFFFFFFFFu;
    const uint64_t b_high = b >> 32;
    const uint64_t b_low = b & 0xFFFFFFFFu;
    const uint64_t cross = ((a_high * b_low) >> 32) + ((a_low * b_high) >> 32);
    return a_high * b_high + cross;
}

/* The square of a number below 1 as fixed point with 64 fraction bits. */
static uint64_t pendulum_single_delay_squared_fraction(pendulum_single_delay_scaled_t a)
{
    const uint64_t x = pendulum_single_delay_fraction(a);
    return pendulum_single_delay_mul_high(x, x);
}

/* Makes a number of a significand that has its top bit set. */
static pendulum_single_delay_scaled_t pendulum_single_delay_scaled(uint64_t significand, int32_t exponent)
{
    pendulum_single_delay_scaled_t result;
    result.significand = significand;
    result.exponent = exponent;
    return result;
}

/* Makes a number of a significand of at least 2^62. */
static pendulum_single_delay_scaled_t pendulum_single_delay_settled(uint64_t significand, int32_t exponent)
{
    if ((significand >> 63) == 0) {
        return pendulum_single_delay_scaled(significand << 1, exponent - 1);
    }
    return pendulum_single_delay_scaled(significand, exponent);
}

/* (1 - cos(r)) / r^2 in powers of -r^2. */
static const uint64_t PENDULUM_SINGLE_DELAY_COSINE[8] = {
    UINT64_C(0x8000000000000000), UINT64_C(0x0AAAAAAAAAAAAAA8), UINT64_C(0x005B05B05B05B02B),
    UINT64_C(0x0001A01A01A01865), UINT64_C(0x0000049F93EDD666), UINT64_C(0x00000008F76C6243),
    UINT64_C(0x000000000C9C9706), UINT64_C(0x00000000000D551B)};

/* cos(r) for 0 < r <= pi/4, relative error below 2^-60. */
static pendulum_single_delay_scaled_t pendulum_single_delay_cosine(pendulum_single_delay_scaled_t r)
{
    const uint64_t z = pendulum_single_delay_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = PENDULUM_SINGLE_DELAY_COSINE[6] - ((PENDULUM_SINGLE_DELAY_COSINE[7] * z_high) >> 32);
    const uint64_t c5 = PENDULUM_SINGLE_DELAY_COSINE[5] - ((tail * z_high) >> 32);
    const uint64_t c4 = PENDULUM_SINGLE_DELAY_COSINE[4] - pendulum_single_delay_mul_high(c5, z);
    const uint64_t c3 = PENDULUM_SINGLE_DELAY_COSINE[3] - pendulum_single_delay_mul_high(c4, z);
    const uint64_t c2 = PENDULUM_SINGLE_DELAY_COSINE[2] - pendulum_single_delay_mul_high(c3, z);
    const uint64_t c1 = PENDULUM_SINGLE_DELAY_COSINE[1] - pendulum_single_delay_mul_high(c2, z);
    const uint64_t c0 = PENDULUM_SINGLE_DELAY_COSINE[0] - pendulum_single_delay_mul_high(c1, z);
    return pendulum_single_delay_settled((UINT64_C(1) << 63) - (pendulum_single_delay_mul_high(c0, z) >> 1), 0);
}

/* (1 - sin(r) / r) / r^2 in powers of -r^2. */
static const uint64_t PENDULUM_SINGLE_DELAY_SINE[7] = {
    UINT64_C(0x2AAAAAAAAAAAAAA6), UINT64_C(0x0222222222222160), UINT64_C(0x000D00D00D00C575),
    UINT64_C(0x00002E3BC74A673D), UINT64_C(0x0000006B9914A637), UINT64_C(0x00000000B090498C),
    UINT64_C(0x0000000000D552BC)};

/* sin(r) for 0 < r <= pi/4, relative error below 2^-60. */
static pendulum_single_delay_scaled_t pendulum_single_delay_sine(pendulum_single_delay_scaled_t r)
{
    const uint64_t z = pendulum_single_delay_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = PENDULUM_SINGLE_DELAY_SINE[5] - ((PENDULUM_SINGLE_DELAY_SINE[6] * z_high) >> 32);
    const uint64_t c4 = PENDULUM_SINGLE_DELAY_SINE[4] - ((tail * z_high) >> 32);
    const uint64_t c3 = PENDULUM_SINGLE_DELAY_SINE[3] - pendulum_single_delay_mul_high(c4, z);
    const uint64_t c2 = PENDULUM_SINGLE_DELAY_SINE[2] - pendulum_single_delay_mul_high(c3, z);
    const uint64_t c1 = PENDULUM_SINGLE_DELAY_SINE[1] - pendulum_single_delay_mul_high(c2, z);
    const uint64_t c0 = PENDULUM_SINGLE_DELAY_SINE[0] - pendulum_single_delay_mul_high(c1, z);
    const uint64_t lost = pendulum_single_delay_mul_high(r.significand, pendulum_single_delay_mul_high(c0, z));
    return pendulum_single_delay_settled(r.significand - lost, r.exponent);
}

/* The sine of an angle. */
static pendulum_single_delay_signed_t pendulum_single_delay_sine_at(pendulum_single_delay_turned_t angle)
{
    const int back = (angle.quadrant & 2) != 0;
    if ((angle.quadrant & 1) != 0) {
        return pendulum_single_delay_signed(pendulum_single_delay_cosine(angle.rest.magnitude), back);
    }
    return pendulum_single_delay_signed(pendulum_single_delay_sine(angle.rest.magnitude), back != angle.rest.negative);
}

/* Makes an angle of its parts. */
static pendulum_single_delay_turned_t pendulum_single_delay_turned(pendulum_single_delay_signed_t rest, uint32_t quadrant)
{
    pendulum_single_delay_turned_t result;
    result.rest = rest;
    result.quadrant = quadrant;
    return result;
}

/* The number of zero bits above the highest one bit; x is not 0. */
static int32_t pendulum_single_delay_leading_zeros(uint64_t x)
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
static pendulum_single_delay_scaled_t pendulum_single_delay_normalised(uint64_t significand, int32_t exponent)
{
    const int32_t shift = pendulum_single_delay_leading_zeros(significand);
    return pendulum_single_delay_scaled(significand << shift, exponent - shift);
}

/* The finite positive number with these bits, not 0; exact. */
static pendulum_single_delay_scaled_t pendulum_single_delay_unpacked_f32(uint32_t magnitude)
{
    const int32_t field = (int32_t)(magnitude >> 23);
    const uint64_t digits = (uint64_t)magnitude << 40;
    if (field == 0) {
        return pendulum_single_delay_normalised(digits, -126);
    }
    return pendulum_single_delay_scaled(digits | (UINT64_C(1) << 63), field - 127);
}

/* 2/pi after 32 zero bits. */
static const uint32_t PENDULUM_SINGLE_DELAY_TWO_OVER_PI_F32[9] = {
    UINT32_C(0x00000000), UINT32_C(0xA2F9836E), UINT32_C(0x4E441529),
    UINT32_C(0xFC2757D1), UINT32_C(0xF534DDC0), UINT32_C(0xDB629599),
    UINT32_C(0x3C439041), UINT32_C(0xFE5163AB), UINT32_C(0xDEBBC561)};

/* 32 bits of 2/pi from bit 32 slot + shift on. */
static uint64_t pendulum_single_delay_window_f32(uint32_t slot, uint32_t shift)
{
    const uint64_t first = (uint64_t)(PENDULUM_SINGLE_DELAY_TWO_OVER_PI_F32[slot]);
    const uint64_t second = (uint64_t)(PENDULUM_SINGLE_DELAY_TWO_OVER_PI_F32[slot + 1]);
    return (((first << 32) | second) >> (32 - shift)) & 0xFFFFFFFFu;
}

/* a b, relative error below 2^-60. */
static pendulum_single_delay_scaled_t pendulum_single_delay_product(pendulum_single_delay_scaled_t a, pendulum_single_delay_scaled_t b)
{
    return pendulum_single_delay_settled(pendulum_single_delay_mul_high(a.significand, b.significand),
                            a.exponent + b.exponent + 1);
}

/* pi with 62 fraction bits; as a significand also pi/2 and pi/4. */
#define PENDULUM_SINGLE_DELAY_PI UINT64_C(0xC90FDAA22168C235)

/* The angle of (high, low) / 2^126 quarter turns, its rest exact to 2^-60 of itself. */
static pendulum_single_delay_turned_t pendulum_single_delay_turned_from_quarters(uint64_t high, uint64_t low)
{
    const uint64_t eighths = high >> 61;
    const int negative = (eighths & 1) != 0;
    uint64_t upper = (high << 2) | (low >> 62);
    uint64_t lower = low << 2;
    if (negative) {
        upper = (lower == 0) ? (UINT64_C(0) - upper) : UINT64_MAX - upper;
        lower = (UINT64_C(0) - lower);
    }
    const int32_t shift = pendulum_single_delay_leading_zeros(upper | 1);
    const uint64_t significand = (upper << shift) | ((lower >> 1) >> (63 - shift));
    const pendulum_single_delay_signed_t rest = pendulum_single_delay_signed(
        pendulum_single_delay_product(pendulum_single_delay_scaled(significand, -1 - shift), pendulum_single_delay_scaled(PENDULUM_SINGLE_DELAY_PI, 0)),
        negative);
    return pendulum_single_delay_turned(rest, (uint32_t)(((eighths + 1) >> 1) & 3));
}

/* The angle with these bits, positive and finite, its rest exact to 2^-38 of itself. */
static pendulum_single_delay_turned_t pendulum_single_delay_reduce_f32(uint32_t magnitude)
{
    if (magnitude <= 0x3F490FDAu) {
        return pendulum_single_delay_turned(pendulum_single_delay_signed(pendulum_single_delay_unpacked_f32(magnitude), 0), 0);
    }
    const uint64_t digits = (uint64_t)((magnitude & 0x007FFFFFu) | 0x00800000u);
    const uint32_t start = (magnitude >> 23) - 120;
    const uint32_t slot = start >> 5;
    const uint32_t shift = start & 31;
    const uint64_t upper = (pendulum_single_delay_window_f32(slot, shift) * digits) << 32;
    const uint64_t middle = pendulum_single_delay_window_f32(slot + 1, shift) * digits;
    const uint64_t lower = pendulum_single_delay_window_f32(slot + 2, shift) * digits;
    return pendulum_single_delay_turned_from_quarters(((upper + middle) + (lower >> 32)), lower << 32);
}

/* x rounded to the nearest, ties to even, with subnormals and overflow, and the sign put in. */
static float pendulum_single_delay_rounded_f32(uint32_t sign, pendulum_single_delay_scaled_t x)
{
    const int32_t field = x.exponent + 127;
    if (field >= 255) {
        return pendulum_single_delay_f32_from_bits(sign | PENDULUM_SINGLE_DELAY_INFINITY_F32);
    }
    const int32_t shift = (field > 0) ? 40 : 41 - field;
    if (shift > 63) {
        const int least = shift == 64 && x.significand > (UINT64_C(1) << 63);
        return pendulum_single_delay_f32_from_bits(least ? sign + 1 : sign);
    }
    const uint64_t kept = x.significand >> shift;
    const uint64_t rest = x.significand - (kept << shift);
    const uint64_t half = UINT64_C(1) << (shift - 1);
    const uint64_t odd = kept & 1;
    const uint64_t up = (rest + odd > half) ? 1 : 0;
    const uint32_t base = (field > 0) ? ((uint32_t)(field - 1)) << 23 : 0;
    return pendulum_single_delay_f32_from_bits(sign | (base + ((uint32_t)(kept + up))));
}

/* The sign bit of a negative number, else 0. */
static uint32_t pendulum_single_delay_sign_f32(int negative)
{
    if (negative) {
        return PENDULUM_SINGLE_DELAY_SIGN_F32;
    }
    return 0;
}

/* Sine of an angle in radians, the nearest float. */
static float pendulum_single_delay_sin_f32(float x)
{
    const uint32_t bits = pendulum_single_delay_f32_to_bits(x);
    const uint32_t magnitude = bits & PENDULUM_SINGLE_DELAY_MAGNITUDE_F32;
    if (magnitude >= PENDULUM_SINGLE_DELAY_INFINITY_F32) {
        return pendulum_single_delay_f32_from_bits(PENDULUM_SINGLE_DELAY_NAN_F32);
    }
    if (magnitude == 0) {
        return x;
    }
    const pendulum_single_delay_signed_t value = pendulum_single_delay_sine_at(pendulum_single_delay_reduce_f32(magnitude));
    return pendulum_single_delay_rounded_f32((bits & PENDULUM_SINGLE_DELAY_SIGN_F32) ^ pendulum_single_delay_sign_f32(value.negative),
                                value.magnitude);
}

void pendulum_single_delay_init(pendulum_single_delay_state *state)
{
    for (uint32_t slot = 0U; slot < 51U; ++slot) {
        state->theta[slot] = 0.0f;
    }
    for (uint32_t slot = 0U; slot < 51U; ++slot) {
        state->sin_theta[slot] = 0.0f;
    }
    state->newest = 50U;
    state->count = 0U;
    state->coasting = 0U;
    state->ahead_theta = 0.0f;
}

void pendulum_single_delay_step(pendulum_single_delay_state *state, const pendulum_single_delay_measurements *measurements,
                                pendulum_single_delay_estimate *estimate)
{
    /* samples: outside its range, infinite or NaN means missing */
    const uint32_t t0 = state->newest;
    const uint32_t t1 = (t0 < 50U) ? t0 : 50U;
    const uint32_t t2 = state->count;
    const int t4 = 50U < t2;
    const float t5 = measurements->theta;
    const int t6 = (-1e35f <= t5) && (t5 <= 1e35f);

    /* prediction, for a sample that is missing */
    const uint32_t t7 = (t1 < 50U) ? (t1 + 1U) : 0U;
    const float t8 = state->ahead_theta;
    const float t9 = state->theta[t1];
    const int t10 = (-1e35f <= t8) && (t8 <= 1e35f);
    const int t11 = t4 && t10;
    const float t12 = t11 ? t8 : t9;
    const float t13 = t6 ? t5 : t12;
    const float t14 = pendulum_single_delay_sin_f32(t13);
    const float t15 = state->sin_theta[t1];
    const float t16 = t14 - t15;
    const float t18 = 1.070297e-5f * t16;
    const float t19 = t8 + t18;
    const int t20 = (-1e35f <= t19) && (t19 <= 1e35f);
    const int t21 = t4 && t20;
    const float t22 = t21 ? t19 : t9;
    const int t23 = t6 || t21;
    const int t24 = !t23;
    const float t25 = t6 ? t5 : t22;

    /* how much of the window is good */
    const uint32_t t27 = (t2 < 51U) ? (t2 + 1U) : 51U;
    const uint32_t t28 = t24 ? 0U : t27;
    const uint32_t t29 = t6 ? t27 : 0U;
    const uint32_t t30 = t4 ? t28 : t29;
    state->count = t30;
    const uint32_t t31 = state->coasting;
    const uint32_t t32 = (t31 > 0U) ? (t31 - 1U) : 0U;
    const uint32_t t34 = t6 ? t32 : 51U;
    state->coasting = t34;

    /* into the window */
    state->newest = t7;
    state->theta[t7] = t25;
    state->sin_theta[t7] = t14;

    /* the sums over the window, newest sample first */
    float t36 = 0.0f;
    float t37 = 0.0f;
    float t38 = 0.0f;
    uint32_t t39 = t7;
    for (uint32_t row = 0U; row < 51U; ++row) {
        const float *const gains = PENDULUM_SINGLE_DELAY_WINDOW[row];
        const float t40 = state->theta[t39];
        const float t41 = gains[0];
        const float t42 = t41 * t40;
        const float t43 = t36 + t42;
        const float t44 = gains[1];
        const float t45 = t44 * t40;
        const float t46 = t37 + t45;
        const float t47 = state->sin_theta[t39];
        const float t48 = gains[2];
        const float t49 = t48 * t47;
        const float t50 = t38 + t49;
        const uint32_t t51 = ((t39 >= 1U) && (t39 < 51U)) ? (t39 - 1U) : 50U;
        t36 = t43;
        t37 = t46;
        t38 = t50;
        t39 = t51;
    }
    const float t52 = t37 + t38;

    /* the next measurement, as far as it is known */
    const float t54 = 0.0009999664f * t52;
    const float t56 = 3.2108732e-5f * t14;
    const float t57 = t36 + t54;
    const float t58 = t57 + t56;
    state->ahead_theta = t58;

    /* the estimate; until the window is full, the start */
    const int t59 = 50U < t30;
    const float t60 = t59 ? t36 : t25;
    const float t61 = t59 ? t52 : 0.0f;
    const uint32_t t62 = state->coasting;
    const int t63 = t62 == 0U;
    const pendulum_single_delay_status t67 = t63 ? PENDULUM_SINGLE_DELAY_CONVERGED : PENDULUM_SINGLE_DELAY_COASTING;
    const pendulum_single_delay_status t68 = t59 ? t67 : PENDULUM_SINGLE_DELAY_CONVERGING;

    estimate->theta = t60;
    estimate->omega = t61;
    estimate->status = t68;
}
