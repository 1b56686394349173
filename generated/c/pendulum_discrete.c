/* pendulum_discrete.c: Finite-time observer: A pendulum that is measured at every second call.
 *
 * Generated; pendulum_discrete.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "pendulum_discrete.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "pendulum_discrete.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "pendulum_discrete.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* The number significand / 2^63 * 2^exponent, with the top bit of the significand set. */
typedef struct {
    uint64_t significand;
    int32_t exponent;
} pendulum_discrete_scaled_t;

/* A number with a sign. */
typedef struct {
    pendulum_discrete_scaled_t magnitude;
    int negative;
} pendulum_discrete_signed_t;

/* The angle quadrant * pi/2 + rest. */
typedef struct {
    pendulum_discrete_signed_t rest;
    uint32_t quadrant;
} pendulum_discrete_turned_t;

/* Attaches a sign. */
static pendulum_discrete_signed_t pendulum_discrete_signed(pendulum_discrete_scaled_t magnitude, int negative)
{
    pendulum_discrete_signed_t result;
    result.magnitude = magnitude;
    result.negative = negative;
    return result;
}

/* A number below 1 as fixed point with 64 fraction bits. */
static uint64_t pendulum_discrete_fraction(pendulum_discrete_scaled_t a)
{
    const int32_t shift = -1 - a.exponent;
    if (shift > 63) {
        return 0;
    }
    return a.significand >> shift;
}

/* The upper half of the product, at most 2 too small. */
static uint64_t pendulum_discrete_mul_high(uint64_t a, uint64_t b)
{
    const uint64_t a_high = a >> 32;
    const uint64_t a_low = a & 0xFFFFFFFFu;
    const uint64_t b_high = b >> 32;
    const uint64_t b_low = b & 0xFFFFFFFFu;
    const uint64_t cross = ((a_high * b_low) >> 32) + ((a_low * b_high) >> 32);
    return a_high * b_high + cross;
}

/* The square of a number below 1 as fixed point with 64 fraction bits. */
static uint64_t pendulum_discrete_squared_fraction(pendulum_discrete_scaled_t a)
{
    const uint64_t x = pendulum_discrete_fraction(a);
    return pendulum_discrete_mul_high(x, x);
}

/* Makes a number of a significand that has its top bit set. */
static pendulum_discrete_scaled_t pendulum_discrete_scaled(uint64_t significand, int32_t exponent)
{
    pendulum_discrete_scaled_t result;
    result.significand = significand;
    result.exponent = exponent;
    return result;
}

/* Makes a number of a significand of at least 2^62. */
static pendulum_discrete_scaled_t pendulum_discrete_settled(uint64_t significand, int32_t exponent)
{
    if ((significand >> 63) == 0) {
        return pendulum_discrete_scaled(significand << 1, exponent - 1);
    }
    return pendulum_discrete_scaled(significand, exponent);
}

/* (1 - cos(r)) / r^2 in powers of -r^2. */
static const uint64_t PENDULUM_DISCRETE_COSINE[8] = {
    UINT64_C(0x8000000000000000), UINT64_C(0x0AAAAAAAAAAAAAA8), UINT64_C(0x005B05B05B05B02B),
    UINT64_C(0x0001A01A01A01865), UINT64_C(0x0000049F93EDD666), UINT64_C(0x00000008F76C6243),
    UINT64_C(0x000000000C9C9706), UINT64_C(0x00000000000D551B)};

/* cos(r) for 0 < r <= pi/4, relative error below 2^-60. */
static pendulum_discrete_scaled_t pendulum_discrete_cosine(pendulum_discrete_scaled_t r)
{
    const uint64_t z = pendulum_discrete_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = PENDULUM_DISCRETE_COSINE[6] - ((PENDULUM_DISCRETE_COSINE[7] * z_high) >> 32);
    const uint64_t c5 = PENDULUM_DISCRETE_COSINE[5] - ((tail * z_high) >> 32);
    const uint64_t c4 = PENDULUM_DISCRETE_COSINE[4] - pendulum_discrete_mul_high(c5, z);
    const uint64_t c3 = PENDULUM_DISCRETE_COSINE[3] - pendulum_discrete_mul_high(c4, z);
    const uint64_t c2 = PENDULUM_DISCRETE_COSINE[2] - pendulum_discrete_mul_high(c3, z);
    const uint64_t c1 = PENDULUM_DISCRETE_COSINE[1] - pendulum_discrete_mul_high(c2, z);
    const uint64_t c0 = PENDULUM_DISCRETE_COSINE[0] - pendulum_discrete_mul_high(c1, z);
    return pendulum_discrete_settled((UINT64_C(1) << 63) - (pendulum_discrete_mul_high(c0, z) >> 1), 0);
}

/* (1 - sin(r) / r) / r^2 in powers of -r^2. */
static const uint64_t PENDULUM_DISCRETE_SINE[7] = {
    UINT64_C(0x2AAAAAAAAAAAAAA6), UINT64_C(0x0222222222222160), UINT64_C(0x000D00D00D00C575),
    UINT64_C(0x00002E3BC74A673D), UINT64_C(0x0000006B9914A637), UINT64_C(0x00000000B090498C),
    UINT64_C(0x0000000000D552BC)};

/* sin(r) for 0 < r <= pi/4, relative error below 2^-60. */
static pendulum_discrete_scaled_t pendulum_discrete_sine(pendulum_discrete_scaled_t r)
{
    const uint64_t z = pendulum_discrete_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = PENDULUM_DISCRETE_SINE[5] - ((PENDULUM_DISCRETE_SINE[6] * z_high) >> 32);
    const uint64_t c4 = PENDULUM_DISCRETE_SINE[4] - ((tail * z_high) >> 32);
    const uint64_t c3 = PENDULUM_DISCRETE_SINE[3] - pendulum_discrete_mul_high(c4, z);
    const uint64_t c2 = PENDULUM_DISCRETE_SINE[2] - pendulum_discrete_mul_high(c3, z);
    const uint64_t c1 = PENDULUM_DISCRETE_SINE[1] - pendulum_discrete_mul_high(c2, z);
    const uint64_t c0 = PENDULUM_DISCRETE_SINE[0] - pendulum_discrete_mul_high(c1, z);
    const uint64_t lost = pendulum_discrete_mul_high(r.significand, pendulum_discrete_mul_high(c0, z));
    return pendulum_discrete_settled(r.significand - lost, r.exponent);
}

/* The sine of an angle. */
static pendulum_discrete_signed_t pendulum_discrete_sine_at(pendulum_discrete_turned_t angle)
{
    const int back = (angle.quadrant & 2) != 0;
    if ((angle.quadrant & 1) != 0) {
        return pendulum_discrete_signed(pendulum_discrete_cosine(angle.rest.magnitude), back);
    }
    return pendulum_discrete_signed(pendulum_discrete_sine(angle.rest.magnitude), back != angle.rest.negative);
}

/* Makes an angle of its parts. */
static pendulum_discrete_turned_t pendulum_discrete_turned(pendulum_discrete_signed_t rest, uint32_t quadrant)
{
    pendulum_discrete_turned_t result;
    result.rest = rest;
    result.quadrant = quadrant;
    return result;
}

/* The number of zero bits above the highest one bit; x is not 0. */
static int32_t pendulum_discrete_leading_zeros(uint64_t x)
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
static pendulum_discrete_scaled_t pendulum_discrete_normalised(uint64_t significand, int32_t exponent)
{
    const int32_t shift = pendulum_discrete_leading_zeros(significand);
    return pendulum_discrete_scaled(significand << shift, exponent - shift);
}

/* a b, relative error below 2^-60. */
static pendulum_discrete_scaled_t pendulum_discrete_product(pendulum_discrete_scaled_t a, pendulum_discrete_scaled_t b)
{
    return pendulum_discrete_settled(pendulum_discrete_mul_high(a.significand, b.significand),
                            a.exponent + b.exponent + 1);
}

/* pi with 62 fraction bits; as a significand also pi/2 and pi/4. */
#define PENDULUM_DISCRETE_PI UINT64_C(0xC90FDAA22168C235)

/* The angle of (high, low) / 2^126 quarter turns, its rest exact to 2^-60 of itself. */
static pendulum_discrete_turned_t pendulum_discrete_turned_from_quarters(uint64_t high, uint64_t low)
{
    const uint64_t eighths = high >> 61;
    const int negative = (eighths & 1) != 0;
    uint64_t upper = (high << 2) | (low >> 62);
    uint64_t lower = low << 2;
    if (negative) {
        upper = (lower == 0) ? (UINT64_C(0) - upper) : UINT64_MAX - upper;
        lower = (UINT64_C(0) - lower);
    }
    const int32_t shift = pendulum_discrete_leading_zeros(upper | 1);
    const uint64_t significand = (upper << shift) | ((lower >> 1) >> (63 - shift));
    const pendulum_discrete_signed_t rest = pendulum_discrete_signed(
        pendulum_discrete_product(pendulum_discrete_scaled(significand, -1 - shift), pendulum_discrete_scaled(PENDULUM_DISCRETE_PI, 0)),
        negative);
    return pendulum_discrete_turned(rest, (uint32_t)(((eighths + 1) >> 1) & 3));
}

/* The bits of a number. */
typedef union {
    double value;
    uint64_t bits;
} pendulum_discrete_f64_cell_t;

/* The bits of a number. */
static uint64_t pendulum_discrete_f64_to_bits(double x)
{
    pendulum_discrete_f64_cell_t cell;
    cell.value = x;
    return cell.bits;
}

/* The bit of the sign. */
#define PENDULUM_DISCRETE_SIGN_F64 UINT64_C(0x8000000000000000)

/* The bits of the largest magnitude. */
#define PENDULUM_DISCRETE_MAGNITUDE_F64 UINT64_C(0x7FFFFFFFFFFFFFFF)

/* The bits of infinity. */
#define PENDULUM_DISCRETE_INFINITY_F64 UINT64_C(0x7FF0000000000000)

/* The bits of the only NaN that is returned. */
#define PENDULUM_DISCRETE_NAN_F64 UINT64_C(0x7FF8000000000000)

/* The number with these bits. */
static double pendulum_discrete_f64_from_bits(uint64_t bits)
{
    pendulum_discrete_f64_cell_t cell;
    cell.bits = bits;
    return cell.value;
}

/* The finite positive number with these bits, not 0; exact. */
static pendulum_discrete_scaled_t pendulum_discrete_unpacked_f64(uint64_t magnitude)
{
    const int32_t field = (int32_t)(magnitude >> 52);
    const uint64_t digits = magnitude << 11;
    if (field == 0) {
        return pendulum_discrete_normalised(digits, -1022);
    }
    return pendulum_discrete_scaled(digits | (UINT64_C(1) << 63), field - 1023);
}

/* 2/pi after 64 zero bits. */
static const uint32_t PENDULUM_DISCRETE_TWO_OVER_PI_F64[40] = {
    UINT32_C(0x00000000), UINT32_C(0x00000000), UINT32_C(0xA2F9836E), UINT32_C(0x4E441529),
    UINT32_C(0xFC2757D1), UINT32_C(0xF534DDC0), UINT32_C(0xDB629599), UINT32_C(0x3C439041),
    UINT32_C(0xFE5163AB), UINT32_C(0xDEBBC561), UINT32_C(0xB7246E3A), UINT32_C(0x424DD2E0),
    UINT32_C(0x06492EEA), UINT32_C(0x09D1921C), UINT32_C(0xFE1DEB1C), UINT32_C(0xB129A73E),
    UINT32_C(0xE88235F5), UINT32_C(0x2EBB4484), UINT32_C(0xE99C7026), UINT32_C(0xB45F7E41),
    UINT32_C(0x3991D639), UINT32_C(0x835339F4), UINT32_C(0x9C845F8B), UINT32_C(0xBDF9283B),
    UINT32_C(0x1FF897FF), UINT32_C(0xDE05980F), UINT32_C(0xEF2F118B), UINT32_C(0x5A0A6D1F),
    UINT32_C(0x6D367ECF), UINT32_C(0x27CB09B7), UINT32_C(0x4F463F66), UINT32_C(0x9E5FEA2D),
    UINT32_C(0x7527BAC7), UINT32_C(0xEBE5F17B), UINT32_C(0x3D0739F7), UINT32_C(0x8A5292EA),
    UINT32_C(0x6BFB5FB1), UINT32_C(0x1F8D5D08), UINT32_C(0x56033046), UINT32_C(0xFC7B6BAB)};

/* 32 bits of 2/pi from bit 32 slot + shift on. */
static uint64_t pendulum_discrete_window_f64(uint32_t slot, uint32_t shift)
{
    const uint64_t first = (uint64_t)(PENDULUM_DISCRETE_TWO_OVER_PI_F64[slot]);
    const uint64_t second = (uint64_t)(PENDULUM_DISCRETE_TWO_OVER_PI_F64[slot + 1]);
    return (((first << 32) | second) >> (32 - shift)) & 0xFFFFFFFFu;
}

/* A 128-bit unsigned integer. */
typedef struct {
    uint64_t high;
    uint64_t low;
} pendulum_discrete_pair_t;

/* Makes a 128-bit integer of its halves. */
static pendulum_discrete_pair_t pendulum_discrete_pair(uint64_t high, uint64_t low)
{
    pendulum_discrete_pair_t result;
    result.high = high;
    result.low = low;
    return result;
}

/* The exact 128-bit product. */
static pendulum_discrete_pair_t pendulum_discrete_mul_full(uint64_t a, uint64_t b)
{
    const uint64_t a_high = a >> 32;
    const uint64_t a_low = a & 0xFFFFFFFFu;
    const uint64_t b_high = b >> 32;
    const uint64_t b_low = b & 0xFFFFFFFFu;
    const uint64_t lowest = a_low * b_low;
    const uint64_t first = a_high * b_low + (lowest >> 32);
    const uint64_t second = a_low * b_high + (first & 0xFFFFFFFFu);
    const uint64_t high = a_high * b_high + (first >> 32) + (second >> 32);
    return pendulum_discrete_pair(high, (second << 32) | (lowest & 0xFFFFFFFFu));
}

/* The angle with these bits, positive and finite, its rest exact to 2^-60 of itself. */
static pendulum_discrete_turned_t pendulum_discrete_reduce_f64(uint64_t magnitude)
{
    if (magnitude <= UINT64_C(0x3FE921FB54442D18)) {
        return pendulum_discrete_turned(pendulum_discrete_signed(pendulum_discrete_unpacked_f64(magnitude), 0), 0);
    }
    const uint64_t digits = (magnitude & UINT64_C(0x000FFFFFFFFFFFFF)) | (UINT64_C(1) << 52);
    const uint32_t start = ((uint32_t)(magnitude >> 52)) - 1013;
    const uint32_t slot = start >> 5;
    const uint32_t shift = start & 31;
    const uint64_t upper =
        (pendulum_discrete_window_f64(slot, shift) << 32) | pendulum_discrete_window_f64(slot + 1, shift);
    const uint64_t middle =
        (pendulum_discrete_window_f64(slot + 2, shift) << 32) | pendulum_discrete_window_f64(slot + 3, shift);
    const uint64_t lower =
        (pendulum_discrete_window_f64(slot + 4, shift) << 32) | pendulum_discrete_window_f64(slot + 5, shift);
    const pendulum_discrete_pair_t center = pendulum_discrete_mul_full(middle, digits);
    const uint64_t low = (center.low + (pendulum_discrete_mul_high(lower, digits)));
    const uint64_t carry = (low < center.low) ? 1 : 0;
    const uint64_t high = ((upper * digits) + (center.high + carry));
    return pendulum_discrete_turned_from_quarters(high, low);
}

/* x rounded to the nearest, ties to even, with subnormals and overflow, and the sign put in. */
static double pendulum_discrete_rounded_f64(uint64_t sign, pendulum_discrete_scaled_t x)
{
    const int32_t field = x.exponent + 1023;
    if (field >= 2047) {
        return pendulum_discrete_f64_from_bits(sign | PENDULUM_DISCRETE_INFINITY_F64);
    }
    const int32_t shift = (field > 0) ? 11 : 12 - field;
    if (shift > 63) {
        const int least = shift == 64 && x.significand > (UINT64_C(1) << 63);
        return pendulum_discrete_f64_from_bits(least ? sign + 1 : sign);
    }
    const uint64_t kept = x.significand >> shift;
    const uint64_t rest = x.significand - (kept << shift);
    const uint64_t half = UINT64_C(1) << (shift - 1);
    const uint64_t odd = kept & 1;
    const uint64_t up = (rest + odd > half) ? 1 : 0;
    const uint64_t base = (field > 0) ? ((uint64_t)(field - 1)) << 52 : 0;
    return pendulum_discrete_f64_from_bits(sign | (base + (kept + up)));
}

/* The sign bit of a negative number, else 0. */
static uint64_t pendulum_discrete_sign_f64(int negative)
{
    if (negative) {
        return PENDULUM_DISCRETE_SIGN_F64;
    }
    return 0;
}

/* Sine of an angle in radians, error below 0.51 ulp. */
static double pendulum_discrete_sin_f64(double x)
{
    const uint64_t bits = pendulum_discrete_f64_to_bits(x);
    const uint64_t magnitude = bits & PENDULUM_DISCRETE_MAGNITUDE_F64;
    if (magnitude >= PENDULUM_DISCRETE_INFINITY_F64) {
        return pendulum_discrete_f64_from_bits(PENDULUM_DISCRETE_NAN_F64);
    }
    if (magnitude == 0) {
        return x;
    }
    const pendulum_discrete_signed_t value = pendulum_discrete_sine_at(pendulum_discrete_reduce_f64(magnitude));
    return pendulum_discrete_rounded_f64((bits & PENDULUM_DISCRETE_SIGN_F64) ^ pendulum_discrete_sign_f64(value.negative),
                                value.magnitude);
}

/* What one part of a step hands to the next. */
typedef struct {
    uint32_t t0;
    uint32_t t4;
    double t34;
    double t49;
    uint32_t t68;
    double t71;
    double t79;
    double t80;
    double t112;
    pendulum_discrete_status t117;
    int flags[6]; /* t3, t6, t48, t69, t82, t83 */
} pendulum_discrete_work;

/* Part 1 of a step. */
static void pendulum_discrete_part_1(const pendulum_discrete_state *state, const pendulum_discrete_measurements *measurements, pendulum_discrete_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    work->t0 = state->turn;
    const uint32_t t1 = (work->t0 < 1U) ? work->t0 : 1U;
    work->flags[0] = t1 == 0U;
    work->t4 = state->count;
    work->flags[1] = 160U < work->t4;
    const double t7 = measurements->x1;
    const int t8 = (-1e305 <= t7) && (t7 <= 1e305);
    const int t9 = work->flags[0] && t8;

    /* prediction, for a sample that is missing or not measured now */
    const double t10 = state->sin_x1_1;
    const double t11 = state->z1_x2;
    const double t12 = state->x1_1;
    const double t14 = 0.025 * t11;
    const double t16 = -0.00010416666666666667 * t10;
    const double t18 = -0.00020833333333333335 * t10;
    const double t19 = t14 + t12;
    const double t20 = t19 + t16;
    const double t21 = t20 + t18;
    const int t22 = (-1e305 <= t21) && (t21 <= 1e305);
    const int t23 = work->flags[1] && t22;
    const double t24 = t23 ? t21 : t12;
    const int t27 = -1e305 < t21;
    const double t28 = t27 ? t21 : -1e305;
    const int t29 = 1e305 < t28;
    const double t30 = t29 ? 1e305 : t28;
    const int t31 = !work->flags[0];
    const double t32 = work->flags[0] ? t24 : t30;
    const double t33 = t9 ? t7 : t32;
    work->t34 = pendulum_discrete_sin_f64(t33);
    const double t35 = work->t34 - t10;
    const double t36 = -0.00010416666666666667 * t35;
    const double t37 = t21 + t36;
    const int t38 = (-1e305 <= t37) && (t37 <= 1e305);
    const int t39 = work->flags[1] && t38;
    const double t40 = t39 ? t37 : t12;
    const int t41 = -1e305 < t37;
    const double t42 = t41 ? t37 : -1e305;
    const int t43 = 1e305 < t42;
    const double t44 = t43 ? 1e305 : t42;
    const double t45 = work->flags[0] ? t40 : t44;
    const int t46 = t31 || t39;
    const int t47 = t9 || t46;
    work->flags[2] = !t47;
    work->t49 = t9 ? t7 : t45;

    /* both copies, one call on */
    const double t51 = -0.0125 * work->t34;
    const double t52 = -0.0125 * t10;
    const double t53 = t11 + t51;
    const double t54 = t53 + t52;
    const double t55 = state->z2_x2;
    const double t57 = 0.975 * t55;
    const double t59 = -0.025 * t12;
    const double t61 = -0.012395833333333333 * work->t34;
    const double t63 = -0.012291666666666666 * t10;
    const double t64 = t57 + t59;
    const double t65 = t64 + t61;
    const double t66 = t65 + t63;

    /* the reset, when a period is full */
    const uint32_t t67 = state->phase;
    work->t68 = (t67 < 39U) ? (t67 + 1U) : 0U;
    work->flags[3] = work->t68 == 0U;
    const double t70 = -1.0;
    work->t71 = t70 * work->t49;
    const double t72 = t66 - work->t71;
    const double t73 = t54 - t72;
    const double t75 = -1.5704317597836237 * t73;
    const double t76 = t54 + t75;
    const int t77 = (-7.115863519567243e305 <= t76) && (t76 <= 7.115863519567243e305);
    const double t78 = t76 + work->t71;
    work->t79 = work->flags[3] ? t76 : t54;
    work->t80 = work->flags[3] ? t78 : t66;
    const int t81 = !t77;
    work->flags[4] = work->flags[3] && t81;
    work->flags[5] = t9 || t31;
}

/* Part 2 of a step. */
static void pendulum_discrete_part_2(pendulum_discrete_state *state, pendulum_discrete_work *work)
{
    /* how much of the period is good */
    const int t84 = work->flags[2] || work->flags[4];
    const uint32_t t86 = (work->t4 < 161U) ? (work->t4 + 1U) : 161U;
    const uint32_t t87 = work->flags[0] ? 1U : 0U;
    const int t88 = work->t4 == 0U;
    const uint32_t t89 = t88 ? t87 : t86;
    const int t90 = work->flags[1] || work->flags[5];
    const uint32_t t91 = work->flags[1] ? t86 : t89;
    const uint32_t t92 = t90 ? t91 : 0U;
    const uint32_t t93 = t84 ? 0U : t92;
    state->count = t93;
    const uint32_t t94 = state->clean;
    const uint32_t t95 = (t94 < 161U) ? (t94 + 1U) : 161U;
    const uint32_t t96 = work->flags[5] ? t95 : 0U;
    state->clean = t96;
    const int t97 = 160U < t96;
    const int t98 = work->flags[3] && t97;
    const uint32_t t99 = state->coasting;
    const uint32_t t100 = t98 ? 0U : t99;
    const uint32_t t101 = work->flags[5] ? t100 : 1U;
    state->coasting = t101;
    const int t102 = t101 == 0U;
    const int t104 = t93 < 2U;
    const int t105 = 160U < t93;

    /* for the next call */
    const double t107 = t104 ? 0.0 : work->t79;
    const double t108 = 0.0 + work->t71;
    const double t109 = t104 ? t108 : work->t80;
    state->z1_x2 = t107;
    state->z2_x2 = t109;
    const uint32_t t110 = t104 ? 0U : work->t68;
    state->phase = t110;
    state->x1_1 = work->t49;
    state->sin_x1_1 = work->t34;
    const uint32_t t111 = (work->t0 < 1U) ? (work->t0 + 1U) : 0U;
    state->turn = t111;

    /* the estimate; until it has converged, the start */
    work->t112 = t105 ? t107 : 0.0;
    const pendulum_discrete_status t116 = t102 ? PENDULUM_DISCRETE_CONVERGED : PENDULUM_DISCRETE_COASTING;
    work->t117 = t105 ? t116 : PENDULUM_DISCRETE_CONVERGING;
}

void pendulum_discrete_init(pendulum_discrete_state *state)
{
    state->z1_x2 = 0.0;
    state->z2_x2 = 0.0;
    state->x1_1 = 0.0;
    state->sin_x1_1 = 0.0;
    state->phase = 0U;
    state->count = 0U;
    state->clean = 0U;
    state->coasting = 0U;
    state->turn = 0U;
}

void pendulum_discrete_step(pendulum_discrete_state *state, const pendulum_discrete_measurements *measurements,
                            pendulum_discrete_estimate *estimate)
{
    pendulum_discrete_work work;
    pendulum_discrete_part_1(state, measurements, &work);
    pendulum_discrete_part_2(state, &work);

    estimate->x1 = work.t49;
    estimate->x2 = work.t112;
    estimate->status = work.t117;
}
