/* two_mass_kalman.c: Finite-time observer: Motor and load on an elastic shaft, both angles measured and weighed by their noise.
 *
 * Generated; two_mass_kalman.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "two_mass_kalman.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "two_mass_kalman.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "two_mass_kalman.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* The number significand / 2^63 * 2^exponent, with the top bit of the significand set. */
typedef struct {
    uint64_t significand;
    int32_t exponent;
} two_mass_kalman_scaled_t;

/* A number with a sign. */
typedef struct {
    two_mass_kalman_scaled_t magnitude;
    int negative;
} two_mass_kalman_signed_t;

/* The angle quadrant * pi/2 + rest. */
typedef struct {
    two_mass_kalman_signed_t rest;
    uint32_t quadrant;
} two_mass_kalman_turned_t;

/* Attaches a sign. */
static two_mass_kalman_signed_t two_mass_kalman_signed(two_mass_kalman_scaled_t magnitude, int negative)
{
    two_mass_kalman_signed_t result;
    result.magnitude = magnitude;
    result.negative = negative;
    return result;
}

/* A number below 1 as fixed point with 64 fraction bits. */
static uint64_t two_mass_kalman_fraction(two_mass_kalman_scaled_t a)
{
    const int32_t shift = -1 - a.exponent;
    if (shift > 63) {
        return 0;
    }
    return a.significand >> shift;
}

/* The upper half of the product, at most 2 too small. */
static uint64_t two_mass_kalman_mul_high(uint64_t a, uint64_t b)
{
    const uint64_t a_high = a >> 32;
    const uint64_t a_low = a & 0xFFFFFFFFu;
    const uint64_t b_high = b >> 32;
    const uint64_t b_low = b & 0xFFFFFFFFu;
    const uint64_t cross = ((a_high * b_low) >> 32) + ((a_low * b_high) >> 32);
    return a_high * b_high + cross;
}

/* The square of a number below 1 as fixed point with 64 fraction bits. */
static uint64_t two_mass_kalman_squared_fraction(two_mass_kalman_scaled_t a)
{
    const uint64_t x = two_mass_kalman_fraction(a);
    return two_mass_kalman_mul_high(x, x);
}

/* Makes a number of a significand that has its top bit set. */
static two_mass_kalman_scaled_t two_mass_kalman_scaled(uint64_t significand, int32_t exponent)
{
    two_mass_kalman_scaled_t result;
    result.significand = significand;
    result.exponent = exponent;
    return result;
}

/* Makes a number of a significand of at least 2^62. */
static two_mass_kalman_scaled_t two_mass_kalman_settled(uint64_t significand, int32_t exponent)
{
    if ((significand >> 63) == 0) {
        return two_mass_kalman_scaled(significand << 1, exponent - 1);
    }
    return two_mass_kalman_scaled(significand, exponent);
}

/* (1 - cos(r)) / r^2 in powers of -r^2. */
static const uint64_t TWO_MASS_KALMAN_COSINE[8] = {
    UINT64_C(0x8000000000000000), UINT64_C(0x0AAAAAAAAAAAAAA8), UINT64_C(0x005B05B05B05B02B),
    UINT64_C(0x0001A01A01A01865), UINT64_C(0x0000049F93EDD666), UINT64_C(0x00000008F76C6243),
    UINT64_C(0x000000000C9C9706), UINT64_C(0x00000000000D551B)};

/* cos(r) for 0 < r <= pi/4, relative error below 2^-60. */
static two_mass_kalman_scaled_t two_mass_kalman_cosine(two_mass_kalman_scaled_t r)
{
    const uint64_t z = two_mass_kalman_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = TWO_MASS_KALMAN_COSINE[6] - ((TWO_MASS_KALMAN_COSINE[7] * z_high) >> 32);
    const uint64_t c5 = TWO_MASS_KALMAN_COSINE[5] - ((tail * z_high) >> 32);
    const uint64_t c4 = TWO_MASS_KALMAN_COSINE[4] - two_mass_kalman_mul_high(c5, z);
    const uint64_t c3 = TWO_MASS_KALMAN_COSINE[3] - two_mass_kalman_mul_high(c4, z);
    const uint64_t c2 = TWO_MASS_KALMAN_COSINE[2] - two_mass_kalman_mul_high(c3, z);
    const uint64_t c1 = TWO_MASS_KALMAN_COSINE[1] - two_mass_kalman_mul_high(c2, z);
    const uint64_t c0 = TWO_MASS_KALMAN_COSINE[0] - two_mass_kalman_mul_high(c1, z);
    return two_mass_kalman_settled((UINT64_C(1) << 63) - (two_mass_kalman_mul_high(c0, z) >> 1), 0);
}

/* (1 - sin(r) / r) / r^2 in powers of -r^2. */
static const uint64_t TWO_MASS_KALMAN_SINE[7] = {
    UINT64_C(0x2AAAAAAAAAAAAAA6), UINT64_C(0x0222222222222160), UINT64_C(0x000D00D00D00C575),
    UINT64_C(0x00002E3BC74A673D), UINT64_C(0x0000006B9914A637), UINT64_C(0x00000000B090498C),
    UINT64_C(0x0000000000D552BC)};

/* sin(r) for 0 < r <= pi/4, relative error below 2^-60. */
static two_mass_kalman_scaled_t two_mass_kalman_sine(two_mass_kalman_scaled_t r)
{
    const uint64_t z = two_mass_kalman_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = TWO_MASS_KALMAN_SINE[5] - ((TWO_MASS_KALMAN_SINE[6] * z_high) >> 32);
    const uint64_t c4 = TWO_MASS_KALMAN_SINE[4] - ((tail * z_high) >> 32);
    const uint64_t c3 = TWO_MASS_KALMAN_SINE[3] - two_mass_kalman_mul_high(c4, z);
    const uint64_t c2 = TWO_MASS_KALMAN_SINE[2] - two_mass_kalman_mul_high(c3, z);
    const uint64_t c1 = TWO_MASS_KALMAN_SINE[1] - two_mass_kalman_mul_high(c2, z);
    const uint64_t c0 = TWO_MASS_KALMAN_SINE[0] - two_mass_kalman_mul_high(c1, z);
    const uint64_t lost = two_mass_kalman_mul_high(r.significand, two_mass_kalman_mul_high(c0, z));
    return two_mass_kalman_settled(r.significand - lost, r.exponent);
}

/* The sine of an angle. */
static two_mass_kalman_signed_t two_mass_kalman_sine_at(two_mass_kalman_turned_t angle)
{
    const int back = (angle.quadrant & 2) != 0;
    if ((angle.quadrant & 1) != 0) {
        return two_mass_kalman_signed(two_mass_kalman_cosine(angle.rest.magnitude), back);
    }
    return two_mass_kalman_signed(two_mass_kalman_sine(angle.rest.magnitude), back != angle.rest.negative);
}

/* Makes an angle of its parts. */
static two_mass_kalman_turned_t two_mass_kalman_turned(two_mass_kalman_signed_t rest, uint32_t quadrant)
{
    two_mass_kalman_turned_t result;
    result.rest = rest;
    result.quadrant = quadrant;
    return result;
}

/* The number of zero bits above the highest one bit; x is not 0. */
static int32_t two_mass_kalman_leading_zeros(uint64_t x)
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
static two_mass_kalman_scaled_t two_mass_kalman_normalised(uint64_t significand, int32_t exponent)
{
    const int32_t shift = two_mass_kalman_leading_zeros(significand);
    return two_mass_kalman_scaled(significand << shift, exponent - shift);
}

/* a b, relative error below 2^-60. */
static two_mass_kalman_scaled_t two_mass_kalman_product(two_mass_kalman_scaled_t a, two_mass_kalman_scaled_t b)
{
    return two_mass_kalman_settled(two_mass_kalman_mul_high(a.significand, b.significand),
                            a.exponent + b.exponent + 1);
}

/* pi with 62 fraction bits; as a significand also pi/2 and pi/4. */
#define TWO_MASS_KALMAN_PI UINT64_C(0xC90FDAA22168C235)

/* The angle of (high, low) / 2^126 quarter turns, its rest exact to 2^-60 of itself. */
static two_mass_kalman_turned_t two_mass_kalman_turned_from_quarters(uint64_t high, uint64_t low)
{
    const uint64_t eighths = high >> 61;
    const int negative = (eighths & 1) != 0;
    uint64_t upper = (high << 2) | (low >> 62);
    uint64_t lower = low << 2;
    if (negative) {
        upper = (lower == 0) ? (UINT64_C(0) - upper) : UINT64_MAX - upper;
        lower = (UINT64_C(0) - lower);
    }
    const int32_t shift = two_mass_kalman_leading_zeros(upper | 1);
    const uint64_t significand = (upper << shift) | ((lower >> 1) >> (63 - shift));
    const two_mass_kalman_signed_t rest = two_mass_kalman_signed(
        two_mass_kalman_product(two_mass_kalman_scaled(significand, -1 - shift), two_mass_kalman_scaled(TWO_MASS_KALMAN_PI, 0)),
        negative);
    return two_mass_kalman_turned(rest, (uint32_t)(((eighths + 1) >> 1) & 3));
}

/* The bits of a number. */
typedef union {
    double value;
    uint64_t bits;
} two_mass_kalman_f64_cell_t;

/* The bits of a number. */
static uint64_t two_mass_kalman_f64_to_bits(double x)
{
    two_mass_kalman_f64_cell_t cell;
    cell.value = x;
    return cell.bits;
}

/* Bits of the sign, of the largest magnitude, of infinity, of the only NaN returned, of 1. */
#define TWO_MASS_KALMAN_SIGN_F64 UINT64_C(0x8000000000000000)
#define TWO_MASS_KALMAN_MAGNITUDE_F64 UINT64_C(0x7FFFFFFFFFFFFFFF)
#define TWO_MASS_KALMAN_INFINITY_F64 UINT64_C(0x7FF0000000000000)
#define TWO_MASS_KALMAN_NAN_F64 UINT64_C(0x7FF8000000000000)
#define TWO_MASS_KALMAN_ONE_F64 UINT64_C(0x3FF0000000000000)

/* The number with these bits. */
static double two_mass_kalman_f64_from_bits(uint64_t bits)
{
    two_mass_kalman_f64_cell_t cell;
    cell.bits = bits;
    return cell.value;
}

/* The finite positive number with these bits, not 0; exact. */
static two_mass_kalman_scaled_t two_mass_kalman_unpacked_f64(uint64_t magnitude)
{
    const int32_t field = (int32_t)(magnitude >> 52);
    const uint64_t digits = magnitude << 11;
    if (field == 0) {
        return two_mass_kalman_normalised(digits, -1022);
    }
    return two_mass_kalman_scaled(digits | (UINT64_C(1) << 63), field - 1023);
}

/* 2/pi after 64 zero bits. */
static const uint32_t TWO_MASS_KALMAN_TWO_OVER_PI_F64[40] = {
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
static uint64_t two_mass_kalman_window_f64(uint32_t slot, uint32_t shift)
{
    const uint64_t first = (uint64_t)(TWO_MASS_KALMAN_TWO_OVER_PI_F64[slot]);
    const uint64_t second = (uint64_t)(TWO_MASS_KALMAN_TWO_OVER_PI_F64[slot + 1]);
    return (((first << 32) | second) >> (32 - shift)) & 0xFFFFFFFFu;
}

/* A 128-bit unsigned integer. */
typedef struct {
    uint64_t high;
    uint64_t low;
} two_mass_kalman_pair_t;

/* Makes a 128-bit integer of its halves. */
static two_mass_kalman_pair_t two_mass_kalman_pair(uint64_t high, uint64_t low)
{
    two_mass_kalman_pair_t result;
    result.high = high;
    result.low = low;
    return result;
}

/* The exact 128-bit product. */
static two_mass_kalman_pair_t two_mass_kalman_mul_full(uint64_t a, uint64_t b)
{
    const uint64_t a_high = a >> 32;
    const uint64_t a_low = a & 0xFFFFFFFFu;
    const uint64_t b_high = b >> 32;
    const uint64_t b_low = b & 0xFFFFFFFFu;
    const uint64_t lowest = a_low * b_low;
    const uint64_t first = a_high * b_low + (lowest >> 32);
    const uint64_t second = a_low * b_high + (first & 0xFFFFFFFFu);
    const uint64_t high = a_high * b_high + (first >> 32) + (second >> 32);
    return two_mass_kalman_pair(high, (second << 32) | (lowest & 0xFFFFFFFFu));
}

/* The angle with these bits, positive and finite, its rest exact to 2^-60 of itself. */
static two_mass_kalman_turned_t two_mass_kalman_reduce_f64(uint64_t magnitude)
{
    if (magnitude <= UINT64_C(0x3FE921FB54442D18)) {
        return two_mass_kalman_turned(two_mass_kalman_signed(two_mass_kalman_unpacked_f64(magnitude), 0), 0);
    }
    const uint64_t digits = (magnitude & UINT64_C(0x000FFFFFFFFFFFFF)) | (UINT64_C(1) << 52);
    const uint32_t start = ((uint32_t)(magnitude >> 52)) - 1013;
    const uint32_t slot = start >> 5;
    const uint32_t shift = start & 31;
    const uint64_t upper =
        (two_mass_kalman_window_f64(slot, shift) << 32) | two_mass_kalman_window_f64(slot + 1, shift);
    const uint64_t middle =
        (two_mass_kalman_window_f64(slot + 2, shift) << 32) | two_mass_kalman_window_f64(slot + 3, shift);
    const uint64_t lower =
        (two_mass_kalman_window_f64(slot + 4, shift) << 32) | two_mass_kalman_window_f64(slot + 5, shift);
    const two_mass_kalman_pair_t center = two_mass_kalman_mul_full(middle, digits);
    const uint64_t low = (center.low + (two_mass_kalman_mul_high(lower, digits)));
    const uint64_t carry = (low < center.low) ? 1 : 0;
    const uint64_t high = ((upper * digits) + (center.high + carry));
    return two_mass_kalman_turned_from_quarters(high, low);
}

/* x rounded to the nearest, ties to even, with subnormals and overflow, and the sign put in. */
static double two_mass_kalman_rounded_f64(uint64_t sign, two_mass_kalman_scaled_t x)
{
    const int32_t field = x.exponent + 1023;
    if (field >= 2047) {
        return two_mass_kalman_f64_from_bits(sign | TWO_MASS_KALMAN_INFINITY_F64);
    }
    const int32_t shift = (field > 0) ? 11 : 12 - field;
    if (shift > 63) {
        const int least = shift == 64 && x.significand > (UINT64_C(1) << 63);
        return two_mass_kalman_f64_from_bits(least ? sign + 1 : sign);
    }
    const uint64_t kept = x.significand >> shift;
    const uint64_t rest = x.significand - (kept << shift);
    const uint64_t half = UINT64_C(1) << (shift - 1);
    const uint64_t odd = kept & 1;
    const uint64_t up = (rest + odd > half) ? 1 : 0;
    const uint64_t base = (field > 0) ? ((uint64_t)(field - 1)) << 52 : 0;
    return two_mass_kalman_f64_from_bits(sign | (base + (kept + up)));
}

/* The sign bit of a negative number, else 0. */
static uint64_t two_mass_kalman_sign_f64(int negative)
{
    if (negative) {
        return TWO_MASS_KALMAN_SIGN_F64;
    }
    return 0;
}

/* Sine of an angle in radians, error below 0.51 ulp. */
static double two_mass_kalman_sin_f64(double x)
{
    const uint64_t bits = two_mass_kalman_f64_to_bits(x);
    const uint64_t magnitude = bits & TWO_MASS_KALMAN_MAGNITUDE_F64;
    if (magnitude >= TWO_MASS_KALMAN_INFINITY_F64) {
        return two_mass_kalman_f64_from_bits(TWO_MASS_KALMAN_NAN_F64);
    }
    if (magnitude == 0) {
        return x;
    }
    const two_mass_kalman_signed_t value = two_mass_kalman_sine_at(two_mass_kalman_reduce_f64(magnitude));
    return two_mass_kalman_rounded_f64((bits & TWO_MASS_KALMAN_SIGN_F64) ^ two_mass_kalman_sign_f64(value.negative),
                                value.magnitude);
}

/* What one part of a step hands to the next. */
typedef struct {
    double t0;
    double t2;
    double t7;
    double t106;
    double t110;
    double t113;
    double t115;
    double t117;
    double t119;
    double t166;
    double t168;
    double t169;
    double t170;
    two_mass_kalman_status t187;
    int flags[5]; /* t1, t3, t5, t8, t120 */
} two_mass_kalman_work;

/* Part 1 of a step. */
static void two_mass_kalman_part_1(two_mass_kalman_state *state, const two_mass_kalman_measurements *measurements, const two_mass_kalman_inputs *inputs, two_mass_kalman_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    work->t0 = measurements->motor_angle;
    work->flags[0] = (-628.3185307179587 <= work->t0) && (work->t0 <= 628.3185307179587);
    work->t2 = measurements->load_angle;
    work->flags[1] = (-628.3185307179587 <= work->t2) && (work->t2 <= 628.3185307179587);
    const double t4 = inputs->torque;
    work->flags[2] = (-1e303 <= t4) && (t4 <= 1e303);
    const double t6 = state->last_torque;
    work->t7 = work->flags[2] ? t4 : t6;
    state->last_torque = work->t7;
    work->flags[3] = work->flags[0] && work->flags[1];
}

/* Part 2 of a step. */
static void two_mass_kalman_part_2(two_mass_kalman_state *state, two_mass_kalman_work *work)
{
    /* prediction by the plant */
    const double t9 = state->motor_angle;
    const double t10 = state->load_angle;
    const double t11 = state->motor_speed;
    const double t12 = state->load_speed;
    const double t13 = state->last_known0;
    const double t14 = state->last_known1;
    const double t16 = 0.9950249142262294 * t9;
    const double t18 = 0.004975085773770609 * t10;
    const double t20 = 0.0004966821156547011 * t11;
    const double t22 = 3.3178843452988937e-6 * t12;
    const double t24 = 8.293894840854371e-6 * t13;
    const double t26 = 4.154200521167732e-6 * work->t7;
    const double t28 = -1.1831547743688938e-8 * t14;
    const double t29 = t16 + t18;
    const double t30 = t29 + t20;
    const double t31 = t22 + t24;
    const double t32 = t31 + t26;
    const double t33 = t32 + t28;
    const double t34 = t30 + t33;
    const double t36 = 0.0009950171547541218 * t9;
    const double t38 = 0.9990049828452459 * t10;
    const double t40 = 6.635768690597788e-7 * t11;
    const double t42 = 0.0004993364231309402 * t12;
    const double t44 = 7.887698495792626e-9 * t13;
    const double t46 = 2.493229099786935e-9 * work->t7;
    const double t48 = -2.4976336904512624e-6 * t14;
    const double t49 = t36 + t38;
    const double t50 = t49 + t40;
    const double t51 = t42 + t44;
    const double t52 = t51 + t46;
    const double t53 = t52 + t48;
    const double t54 = t50 + t53;
    const double t56 = -19.840741551425655 * t9;
    const double t58 = 19.840741551425655 * t10;
    const double t60 = 0.9851045434505166 * t11;
    const double t62 = 0.014895456549483436 * t12;
    const double t64 = 0.024772020841425907 * t13;
    const double t66 = 0.024896190724044205 * work->t7;
    const double t68 = -6.839374757222813e-5 * t14;
    const double t69 = t56 + t58;
    const double t70 = t69 + t60;
    const double t71 = t62 + t64;
    const double t72 = t71 + t66;
    const double t73 = t72 + t68;
    const double t74 = t70 + t73;
    const double t76 = 3.9681483102851307 * t9;
    const double t78 = -3.9681483102851307 * t10;
    const double t80 = 0.002979091309896687 * t11;
    const double t82 = 0.9970209086901033 * t12;
    const double t84 = 4.559583171481875e-5 * t13;
    const double t86 = 2.076185519115912e-5 * work->t7;
    const double t88 = -0.007486321250485554 * t14;
    const double t89 = t76 + t78;
    const double t90 = t89 + t80;
    const double t91 = t82 + t84;
    const double t92 = t91 + t86;
    const double t93 = t92 + t88;
    const double t94 = t90 + t93;
    const double t96 = -3.739843649680403e-9 * t14;
    const double t97 = t34 + t96;
    const double t99 = -1.249252031270064e-6 * t14;
    const double t100 = t54 + t99;
    const int t103 = (-628.3185307179587 <= t97) && (t97 <= 628.3185307179587);
    const double t104 = state->last_motor_angle;
    const double t105 = t103 ? t97 : t104;
    work->t106 = work->flags[0] ? work->t0 : t105;
    const int t107 = (-628.3185307179587 <= t100) && (t100 <= 628.3185307179587);
    const double t108 = state->last_load_angle;
    const double t109 = t107 ? t100 : t108;
    work->t110 = work->flags[1] ? work->t2 : t109;
    state->last_known0 = work->t7;
    const double t111 = two_mass_kalman_sin_f64(work->t110);
    const double t112 = -3.739843649680403e-9 * t111;
    work->t113 = t34 + t112;
    const double t114 = -1.249252031270064e-6 * t111;
    work->t115 = t54 + t114;
    const double t116 = -3.114278278673868e-5 * t111;
    work->t117 = t74 + t116;
    const double t118 = -0.007493771443442652 * t111;
    work->t119 = t94 + t118;
    state->last_known1 = t111;
    state->last_motor_angle = work->t106;
    state->last_load_angle = work->t110;
    work->flags[4] = work->flags[2] && work->flags[3];
}

/* Part 3 of a step. */
static void two_mass_kalman_part_3(two_mass_kalman_state *state, two_mass_kalman_work *work)
{
    /* correction by the innovation */
    const double t122 = work->t106 - work->t113;
    const double t123 = work->flags[0] ? t122 : 0.0;
    const double t124 = work->t110 - work->t115;
    const double t125 = work->flags[1] ? t124 : 0.0;
    const double t127 = 0.6252170978732445 * t123;
    const double t129 = 0.002542111325138867 * t125;
    const double t130 = t127 + t129;
    const double t132 = 0.050842226502777345 * t123;
    const double t134 = 0.23729546780627317 * t125;
    const double t135 = t132 + t134;
    const double t137 = 588.5924566111323 * t123;
    const double t139 = 7.518009944344432 * t125;
    const double t140 = t137 + t139;
    const double t142 = 15.768605939992751 * t123;
    const double t144 = 64.50265025518871 * t125;
    const double t145 = t142 + t144;
    const double t146 = work->t113 + t130;
    const double t147 = work->t115 + t135;
    const double t148 = work->t117 + t140;
    const double t149 = work->t119 + t145;

    /* the first sample starts the observer; so does a state beyond all bounds */
    const uint32_t t151 = state->good;
    const int t152 = t151 == 0U;
    const int t153 = (-1e303 <= t146) && (t146 <= 1e303);
    const int t154 = !t153;
    const int t155 = t152 || t154;
    const int t156 = (-1e303 <= t147) && (t147 <= 1e303);
    const int t157 = !t156;
    const int t158 = t155 || t157;
    const int t159 = (-1e303 <= t148) && (t148 <= 1e303);
    const int t160 = !t159;
    const int t161 = t158 || t160;
    const int t162 = (-1e303 <= t149) && (t149 <= 1e303);
    const int t163 = !t162;
    const int t164 = t161 || t163;
    const double t165 = work->flags[3] ? work->t106 : 0.0;
    work->t166 = t164 ? t165 : t146;
    state->motor_angle = work->t166;
    const double t167 = work->flags[3] ? work->t110 : 0.0;
    work->t168 = t164 ? t167 : t147;
    state->load_angle = work->t168;
    work->t169 = t164 ? 0.0 : t148;
    state->motor_speed = work->t169;
    work->t170 = t164 ? 0.0 : t149;
    state->load_speed = work->t170;
    const uint32_t t172 = work->flags[3] ? 1U : 0U;
    const uint32_t t173 = (t151 < 102U) ? (t151 + 1U) : 102U;
    const uint32_t t174 = work->flags[3] ? t173 : t151;
    const uint32_t t175 = t164 ? t172 : t174;
    state->good = t175;
    const uint32_t t176 = state->clean;
    const uint32_t t177 = (t176 < 102U) ? (t176 + 1U) : 102U;
    const uint32_t t178 = work->flags[4] ? t177 : 0U;
    const uint32_t t179 = t164 ? t172 : t178;
    state->clean = t179;

    /* the estimate */
    const int t184 = 101U < t175;
    const int t185 = 101U < t179;
    const two_mass_kalman_status t186 = t185 ? TWO_MASS_KALMAN_CONVERGED : TWO_MASS_KALMAN_COASTING;
    work->t187 = t184 ? t186 : TWO_MASS_KALMAN_CONVERGING;
}

void two_mass_kalman_init(two_mass_kalman_state *state)
{
    state->motor_angle = 0.0;
    state->load_angle = 0.0;
    state->motor_speed = 0.0;
    state->load_speed = 0.0;
    state->good = 0U;
    state->clean = 0U;
    state->last_motor_angle = 0.0;
    state->last_load_angle = 0.0;
    state->last_known0 = 0.0;
    state->last_known1 = 0.0;
    state->last_torque = 0.0;
}

void two_mass_kalman_step(two_mass_kalman_state *state, const two_mass_kalman_measurements *measurements,
                          const two_mass_kalman_inputs *inputs, two_mass_kalman_estimate *estimate)
{
    two_mass_kalman_work work;
    two_mass_kalman_part_1(state, measurements, inputs, &work);
    two_mass_kalman_part_2(state, &work);
    two_mass_kalman_part_3(state, &work);

    estimate->motor_angle = work.t166;
    estimate->load_angle = work.t168;
    estimate->motor_speed = work.t169;
    estimate->load_speed = work.t170;
    estimate->status = work.t187;
}
