/* pendulum.c: Finite-time observer: Velocity of a free pendulum from its encoder.
 *
 * Generated; pendulum.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "pendulum.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "pendulum.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "pendulum.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* weights by age, from age 0
 *   [0] theta from theta
 *   [1] omega from theta
 *   [2] theta from sin(theta)
 *   [3] omega from sin(theta)
 */
static const float PENDULUM_WINDOW[51][4] = {
    { 0.07610685f, 2.2574034f, 9.888401e-6f, 0.03208457f },
    { 0.07384937f, 2.1672065f, 5.8538666e-5f, 0.06404643f },
    { 0.071591735f, 2.0770035f, 0.000113145914f, 0.06375895f },
    { 0.069333956f, 1.9867942f, 0.0001631521f, 0.063338116f },
    { 0.06707602f, 1.896579f, 0.00020870252f, 0.06278972f },
    { 0.064817935f, 1.8063577f, 0.00024994247f, 0.06211958f },
    { 0.062559694f, 1.7161304f, 0.0002870173f, 0.06133348f },
    { 0.060301308f, 1.625897f, 0.0003200722f, 0.06043723f },
    { 0.058042765f, 1.5356575f, 0.00034925257f, 0.05943663f },
    { 0.05578407f, 1.445412f, 0.00037470364f, 0.05833748f },
    { 0.053525224f, 1.3551604f, 0.00039657074f, 0.057145588f },
    { 0.051266227f, 1.2649027f, 0.00041499914f, 0.05586675f },
    { 0.049007077f, 1.174639f, 0.00043013418f, 0.05450677f },
    { 0.046747778f, 1.0843692f, 0.00044212112f, 0.053071454f },
    { 0.044488322f, 0.9940933f, 0.00045110527f, 0.051566597f },
    { 0.042228717f, 0.90381134f, 0.00045723192f, 0.049998004f },
    { 0.03996896f, 0.81352335f, 0.00046064638f, 0.048371475f },
    { 0.037709054f, 0.7232292f, 0.0004614939f, 0.046692815f },
    { 0.03544899f, 0.6329291f, 0.00045991986f, 0.044967826f },
    { 0.03318878f, 0.54262286f, 0.00045606948f, 0.043202307f },
    { 0.030928414f, 0.45231056f, 0.0004500881f, 0.04140206f },
    { 0.028667897f, 0.36199218f, 0.000442121f, 0.03957289f },
    { 0.026407229f, 0.27166775f, 0.00043231348f, 0.0377206f },
    { 0.024146408f, 0.18133722f, 0.00042081083f, 0.035850983f },
    { 0.021885436f, 0.09100064f, 0.00040775834f, 0.03396985f },
    { 0.019624311f, 0.000657981f, 0.00039330134f, 0.032082997f },
    { 0.017363034f, -0.08969075f, 0.0003775851f, 0.030196233f },
    { 0.015101606f, -0.18004556f, 0.0003607549f, 0.028315354f },
    { 0.012840025f, -0.27040645f, 0.00034295607f, 0.026446164f },
    { 0.010578292f, -0.3607734f, 0.0003243339f, 0.024594462f },
    { 0.008316408f, -0.45114642f, 0.0003050337f, 0.022766054f },
    { 0.006054371f, -0.54152554f, 0.00028520072f, 0.02096674f },
    { 0.003792182f, -0.63191074f, 0.0002649803f, 0.019202322f },
    { 0.0015298411f, -0.72230196f, 0.0002445177f, 0.017478602f },
    { -0.00073265197f, -0.8126993f, 0.00022395825f, 0.015801381f },
    { -0.002995297f, -0.90310276f, 0.00020344724f, 0.014176464f },
    { -0.0052580945f, -0.9935122f, 0.00018312995f, 0.0126096485f },
    { -0.007521044f, -1.0839278f, 0.00016315168f, 0.01110674f },
    { -0.009784145f, -1.1743494f, 0.00014365774f, 0.009673538f },
    { -0.012047399f, -1.2647772f, 0.00012479343f, 0.008315845f },
    { -0.014310805f, -1.355211f, 0.00010670402f, 0.007039464f },
    { -0.016574362f, -1.4456509f, 8.953482e-5f, 0.0058501964f },
    { -0.018838074f, -1.5360968f, 7.343114e-5f, 0.0047538434f },
    { -0.021101937f, -1.6265489f, 5.8538255e-5f, 0.0037562072f },
    { -0.02336595f, -1.717007f, 4.5001478e-5f, 0.0028630898f },
    { -0.025630116f, -1.8074713f, 3.2966094e-5f, 0.0020802934f },
    { -0.027894435f, -1.8979416f, 2.2577406e-5f, 0.0014136195f },
    { -0.030158907f, -1.9884179f, 1.3980707e-5f, 0.0008688701f },
    { -0.03242353f, -2.0789003f, 7.3212964e-6f, 0.00045184718f },
    { -0.034688305f, -2.169389f, 2.7444696e-6f, 0.0001683526f },
    { -0.036953233f, -2.2598836f, 3.9552268e-7f, 2.4188279e-5f }
};

/* The bits of a number. */
typedef union {
    float value;
    uint32_t bits;
} pendulum_f32_cell_t;

/* The bits of a number. */
static uint32_t pendulum_f32_to_bits(float x)
{
    pendulum_f32_cell_t cell;
    cell.value = x;
    return cell.bits;
}

/* The bit of the sign. */
#define PENDULUM_SIGN_F32 UINT32_C(0x80000000)

/* The bits of the largest magnitude. */
#define PENDULUM_MAGNITUDE_F32 UINT32_C(0x7FFFFFFF)

/* The bits of infinity. */
#define PENDULUM_INFINITY_F32 UINT32_C(0x7F800000)

/* The bits of the only NaN that is returned. */
#define PENDULUM_NAN_F32 UINT32_C(0x7FC00000)

/* The number with these bits. */
static float pendulum_f32_from_bits(uint32_t bits)
{
    pendulum_f32_cell_t cell;
    cell.bits = bits;
    return cell.value;
}

/* The number significand / 2^63 * 2^exponent, with the top bit of the significand set. */
typedef struct {
    uint64_t significand;
    int32_t exponent;
} pendulum_scaled_t;

/* A number with a sign. */
typedef struct {
    pendulum_scaled_t magnitude;
    int negative;
} pendulum_signed_t;

/* The angle quadrant * pi/2 + rest. */
typedef struct {
    pendulum_signed_t rest;
    uint32_t quadrant;
} pendulum_turned_t;

/* Attaches a sign. */
static pendulum_signed_t pendulum_signed(pendulum_scaled_t magnitude, int negative)
{
    pendulum_signed_t result;
    result.magnitude = magnitude;
    result.negative = negative;
    return result;
}

/* A number below 1 as fixed point with 64 fraction bits. */
static uint64_t pendulum_fraction(pendulum_scaled_t a)
{
    const int32_t shift = -1 - a.exponent;
    if (shift > 63) {
        return 0;
    }
    return a.significand >> shift;
}

/* The upper half of the product, at most 2 too small. */
static uint64_t pendulum_mul_high(uint64_t a, uint64_t b)
{
    const uint64_t a_high = a >> 32;
    const uint64_t a_low = a & 0xFFFFFFFFu;
    const uint64_t b_high = b >> 32;
    const uint64_t b_low = b & 0xFFFFFFFFu;
    const uint64_t cross = ((a_high * b_low) >> 32) + ((a_low * b_high) >> 32);
    return a_high * b_high + cross;
}

/* The square of a number below 1 as fixed point with 64 fraction bits. */
static uint64_t pendulum_squared_fraction(pendulum_scaled_t a)
{
    const uint64_t x = pendulum_fraction(a);
    return pendulum_mul_high(x, x);
}

/* Makes a number of a significand that has its top bit set. */
static pendulum_scaled_t pendulum_scaled(uint64_t significand, int32_t exponent)
{
    pendulum_scaled_t result;
    result.significand = significand;
    result.exponent = exponent;
    return result;
}

/* Makes a number of a significand of at least 2^62. */
static pendulum_scaled_t pendulum_settled(uint64_t significand, int32_t exponent)
{
    if ((significand >> 63) == 0) {
        return pendulum_scaled(significand << 1, exponent - 1);
    }
    return pendulum_scaled(significand, exponent);
}

/* (1 - cos(r)) / r^2 in powers of -r^2. */
static const uint64_t PENDULUM_COSINE[8] = {
    UINT64_C(0x8000000000000000), UINT64_C(0x0AAAAAAAAAAAAAA8), UINT64_C(0x005B05B05B05B02B),
    UINT64_C(0x0001A01A01A01865), UINT64_C(0x0000049F93EDD666), UINT64_C(0x00000008F76C6243),
    UINT64_C(0x000000000C9C9706), UINT64_C(0x00000000000D551B)};

/* cos(r) for 0 < r <= pi/4, relative error below 2^-60. */
static pendulum_scaled_t pendulum_cosine(pendulum_scaled_t r)
{
    const uint64_t z = pendulum_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = PENDULUM_COSINE[6] - ((PENDULUM_COSINE[7] * z_high) >> 32);
    const uint64_t c5 = PENDULUM_COSINE[5] - ((tail * z_high) >> 32);
    const uint64_t c4 = PENDULUM_COSINE[4] - pendulum_mul_high(c5, z);
    const uint64_t c3 = PENDULUM_COSINE[3] - pendulum_mul_high(c4, z);
    const uint64_t c2 = PENDULUM_COSINE[2] - pendulum_mul_high(c3, z);
    const uint64_t c1 = PENDULUM_COSINE[1] - pendulum_mul_high(c2, z);
    const uint64_t c0 = PENDULUM_COSINE[0] - pendulum_mul_high(c1, z);
    return pendulum_settled((UINT64_C(1) << 63) - (pendulum_mul_high(c0, z) >> 1), 0);
}

/* (1 - sin(r) / r) / r^2 in powers of -r^2. */
static const uint64_t PENDULUM_SINE[7] = {
    UINT64_C(0x2AAAAAAAAAAAAAA6), UINT64_C(0x0222222222222160), UINT64_C(0x000D00D00D00C575),
    UINT64_C(0x00002E3BC74A673D), UINT64_C(0x0000006B9914A637), UINT64_C(0x00000000B090498C),
    UINT64_C(0x0000000000D552BC)};

/* sin(r) for 0 < r <= pi/4, relative error below 2^-60. */
static pendulum_scaled_t pendulum_sine(pendulum_scaled_t r)
{
    const uint64_t z = pendulum_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = PENDULUM_SINE[5] - ((PENDULUM_SINE[6] * z_high) >> 32);
    const uint64_t c4 = PENDULUM_SINE[4] - ((tail * z_high) >> 32);
    const uint64_t c3 = PENDULUM_SINE[3] - pendulum_mul_high(c4, z);
    const uint64_t c2 = PENDULUM_SINE[2] - pendulum_mul_high(c3, z);
    const uint64_t c1 = PENDULUM_SINE[1] - pendulum_mul_high(c2, z);
    const uint64_t c0 = PENDULUM_SINE[0] - pendulum_mul_high(c1, z);
    const uint64_t lost = pendulum_mul_high(r.significand, pendulum_mul_high(c0, z));
    return pendulum_settled(r.significand - lost, r.exponent);
}

/* The sine of an angle. */
static pendulum_signed_t pendulum_sine_at(pendulum_turned_t angle)
{
    const int back = (angle.quadrant & 2) != 0;
    if ((angle.quadrant & 1) != 0) {
        return pendulum_signed(pendulum_cosine(angle.rest.magnitude), back);
    }
    return pendulum_signed(pendulum_sine(angle.rest.magnitude), back != angle.rest.negative);
}

/* Makes an angle of its parts. */
static pendulum_turned_t pendulum_turned(pendulum_signed_t rest, uint32_t quadrant)
{
    pendulum_turned_t result;
    result.rest = rest;
    result.quadrant = quadrant;
    return result;
}

/* The number of zero bits above the highest one bit; x is not 0. */
static int32_t pendulum_leading_zeros(uint64_t x)
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
static pendulum_scaled_t pendulum_normalised(uint64_t significand, int32_t exponent)
{
    const int32_t shift = pendulum_leading_zeros(significand);
    return pendulum_scaled(significand << shift, exponent - shift);
}

/* The finite positive number with these bits, not 0; exact. */
static pendulum_scaled_t pendulum_unpacked_f32(uint32_t magnitude)
{
    const int32_t field = (int32_t)(magnitude >> 23);
    const uint64_t digits = (uint64_t)magnitude << 40;
    if (field == 0) {
        return pendulum_normalised(digits, -126);
    }
    return pendulum_scaled(digits | (UINT64_C(1) << 63), field - 127);
}

/* 2/pi after 32 zero bits. */
static const uint32_t PENDULUM_TWO_OVER_PI_F32[9] = {
    UINT32_C(0x00000000), UINT32_C(0xA2F9836E), UINT32_C(0x4E441529),
    UINT32_C(0xFC2757D1), UINT32_C(0xF534DDC0), UINT32_C(0xDB629599),
    UINT32_C(0x3C439041), UINT32_C(0xFE5163AB), UINT32_C(0xDEBBC561)};

/* 32 bits of 2/pi from bit 32 slot + shift on. */
static uint64_t pendulum_window_f32(uint32_t slot, uint32_t shift)
{
    const uint64_t first = (uint64_t)(PENDULUM_TWO_OVER_PI_F32[slot]);
    const uint64_t second = (uint64_t)(PENDULUM_TWO_OVER_PI_F32[slot + 1]);
    return (((first << 32) | second) >> (32 - shift)) & 0xFFFFFFFFu;
}

/* a b, relative error below 2^-60. */
static pendulum_scaled_t pendulum_product(pendulum_scaled_t a, pendulum_scaled_t b)
{
    return pendulum_settled(pendulum_mul_high(a.significand, b.significand),
                            a.exponent + b.exponent + 1);
}

/* pi with 62 fraction bits; as a significand also pi/2 and pi/4. */
#define PENDULUM_PI UINT64_C(0xC90FDAA22168C235)

/* The angle of (high, low) / 2^126 quarter turns, its rest exact to 2^-60 of itself. */
static pendulum_turned_t pendulum_turned_from_quarters(uint64_t high, uint64_t low)
{
    const uint64_t eighths = high >> 61;
    const int negative = (eighths & 1) != 0;
    uint64_t upper = (high << 2) | (low >> 62);
    uint64_t lower = low << 2;
    if (negative) {
        upper = (lower == 0) ? (UINT64_C(0) - upper) : UINT64_MAX - upper;
        lower = (UINT64_C(0) - lower);
    }
    const int32_t shift = pendulum_leading_zeros(upper | 1);
    const uint64_t significand = (upper << shift) | ((lower >> 1) >> (63 - shift));
    const pendulum_signed_t rest = pendulum_signed(
        pendulum_product(pendulum_scaled(significand, -1 - shift), pendulum_scaled(PENDULUM_PI, 0)),
        negative);
    return pendulum_turned(rest, (uint32_t)(((eighths + 1) >> 1) & 3));
}

/* The angle with these bits, positive and finite, its rest exact to 2^-38 of itself. */
static pendulum_turned_t pendulum_reduce_f32(uint32_t magnitude)
{
    if (magnitude <= 0x3F490FDAu) {
        return pendulum_turned(pendulum_signed(pendulum_unpacked_f32(magnitude), 0), 0);
    }
    const uint64_t digits = (uint64_t)((magnitude & 0x007FFFFFu) | 0x00800000u);
    const uint32_t start = (magnitude >> 23) - 120;
    const uint32_t slot = start >> 5;
    const uint32_t shift = start & 31;
    const uint64_t upper = (pendulum_window_f32(slot, shift) * digits) << 32;
    const uint64_t middle = pendulum_window_f32(slot + 1, shift) * digits;
    const uint64_t lower = pendulum_window_f32(slot + 2, shift) * digits;
    return pendulum_turned_from_quarters(((upper + middle) + (lower >> 32)), lower << 32);
}

/* x rounded to the nearest, ties to even, with subnormals and overflow, and the sign put in. */
static float pendulum_rounded_f32(uint32_t sign, pendulum_scaled_t x)
{
    const int32_t field = x.exponent + 127;
    if (field >= 255) {
        return pendulum_f32_from_bits(sign | PENDULUM_INFINITY_F32);
    }
    const int32_t shift = (field > 0) ? 40 : 41 - field;
    if (shift > 63) {
        const int least = shift == 64 && x.significand > (UINT64_C(1) << 63);
        return pendulum_f32_from_bits(least ? sign + 1 : sign);
    }
    const uint64_t kept = x.significand >> shift;
    const uint64_t rest = x.significand - (kept << shift);
    const uint64_t half = UINT64_C(1) << (shift - 1);
    const uint64_t odd = kept & 1;
    const uint64_t up = (rest + odd > half) ? 1 : 0;
    const uint32_t base = (field > 0) ? ((uint32_t)(field - 1)) << 23 : 0;
    return pendulum_f32_from_bits(sign | (base + ((uint32_t)(kept + up))));
}

/* The sign bit of a negative number, else 0. */
static uint32_t pendulum_sign_f32(int negative)
{
    if (negative) {
        return PENDULUM_SIGN_F32;
    }
    return 0;
}

/* Sine of an angle in radians, the nearest float. */
static float pendulum_sin_f32(float x)
{
    const uint32_t bits = pendulum_f32_to_bits(x);
    const uint32_t magnitude = bits & PENDULUM_MAGNITUDE_F32;
    if (magnitude >= PENDULUM_INFINITY_F32) {
        return pendulum_f32_from_bits(PENDULUM_NAN_F32);
    }
    if (magnitude == 0) {
        return x;
    }
    const pendulum_signed_t value = pendulum_sine_at(pendulum_reduce_f32(magnitude));
    return pendulum_rounded_f32((bits & PENDULUM_SIGN_F32) ^ pendulum_sign_f32(value.negative),
                                value.magnitude);
}

void pendulum_init(pendulum_state *state)
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

void pendulum_step(pendulum_state *state, const pendulum_measurements *measurements,
                   pendulum_estimate *estimate)
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
    const float t14 = pendulum_sin_f32(t13);
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
    float t39 = 0.0f;
    uint32_t t40 = t7;
    for (uint32_t row = 0U; row < 51U; ++row) {
        const float *const gains = PENDULUM_WINDOW[row];
        const float t41 = state->theta[t40];
        const float t42 = gains[0];
        const float t43 = t42 * t41;
        const float t44 = t36 + t43;
        const float t45 = gains[1];
        const float t46 = t45 * t41;
        const float t47 = t38 + t46;
        const float t48 = state->sin_theta[t40];
        const float t49 = gains[2];
        const float t50 = t49 * t48;
        const float t51 = t37 + t50;
        const float t52 = gains[3];
        const float t53 = t52 * t48;
        const float t54 = t39 + t53;
        const uint32_t t55 = ((t40 >= 1U) && (t40 < 51U)) ? (t40 - 1U) : 50U;
        t36 = t44;
        t37 = t51;
        t38 = t47;
        t39 = t54;
        t40 = t55;
    }
    const float t56 = t36 + t37;
    const float t57 = t38 + t39;

    /* the next measurement, as far as it is known */
    const float t59 = 0.0009999664f * t57;
    const float t61 = 3.2108732e-5f * t14;
    const float t62 = t56 + t59;
    const float t63 = t62 + t61;
    state->ahead_theta = t63;

    /* the estimate; until the window is full, the start */
    const int t64 = 50U < t30;
    const float t65 = t64 ? t56 : t25;
    const float t66 = t64 ? t57 : 0.0f;
    const uint32_t t67 = state->coasting;
    const int t68 = t67 == 0U;
    const pendulum_status t72 = t68 ? PENDULUM_CONVERGED : PENDULUM_COASTING;
    const pendulum_status t73 = t64 ? t72 : PENDULUM_CONVERGING;

    estimate->theta = t65;
    estimate->omega = t66;
    estimate->status = t73;
}
