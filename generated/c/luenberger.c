/* luenberger.c: Finite-time observer: Direct-drive arm on a permanent-magnet DC motor, errors by their poles.
 *
 * Generated; luenberger.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "luenberger.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "luenberger.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "luenberger.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* The bits of a number. */
typedef union {
    float value;
    uint32_t bits;
} luenberger_f32_cell_t;

/* The bits of a number. */
static uint32_t luenberger_f32_to_bits(float x)
{
    luenberger_f32_cell_t cell;
    cell.value = x;
    return cell.bits;
}

/* The bit of the sign. */
#define LUENBERGER_SIGN_F32 UINT32_C(0x80000000)

/* The bits of the largest magnitude. */
#define LUENBERGER_MAGNITUDE_F32 UINT32_C(0x7FFFFFFF)

/* The bits of infinity. */
#define LUENBERGER_INFINITY_F32 UINT32_C(0x7F800000)

/* The bits of the only NaN that is returned. */
#define LUENBERGER_NAN_F32 UINT32_C(0x7FC00000)

/* The number with these bits. */
static float luenberger_f32_from_bits(uint32_t bits)
{
    luenberger_f32_cell_t cell;
    cell.bits = bits;
    return cell.value;
}

/* The number significand / 2^63 * 2^exponent, with the top bit of the significand set. */
typedef struct {
    uint64_t significand;
    int32_t exponent;
} luenberger_scaled_t;

/* A number with a sign. */
typedef struct {
    luenberger_scaled_t magnitude;
    int negative;
} luenberger_signed_t;

/* The angle quadrant * pi/2 + rest. */
typedef struct {
    luenberger_signed_t rest;
    uint32_t quadrant;
} luenberger_turned_t;

/* Attaches a sign. */
static luenberger_signed_t luenberger_signed(luenberger_scaled_t magnitude, int negative)
{
    luenberger_signed_t result;
    result.magnitude = magnitude;
    result.negative = negative;
    return result;
}

/* A number below 1 as fixed point with 64 fraction bits. */
static uint64_t luenberger_fraction(luenberger_scaled_t a)
{
    const int32_t shift = -1 - a.exponent;
    if (shift > 63) {
        return 0;
    }
    return a.significand >> shift;
}

/* The upper half of the product, at most 2 too small. */
static uint64_t luenberger_mul_high(uint64_t a, uint64_t b)
{
    const uint64_t a_high = a >> 32;
    const uint64_t a_low = a & 0xFFFFFFFFu;
    const uint64_t b_high = b >> 32;
    const uint64_t b_low = b & 0xFFFFFFFFu;
    const uint64_t cross = ((a_high * b_low) >> 32) + ((a_low * b_high) >> 32);
    return a_high * b_high + cross;
}

/* The square of a number below 1 as fixed point with 64 fraction bits. */
static uint64_t luenberger_squared_fraction(luenberger_scaled_t a)
{
    const uint64_t x = luenberger_fraction(a);
    return luenberger_mul_high(x, x);
}

/* Makes a number of a significand that has its top bit set. */
static luenberger_scaled_t luenberger_scaled(uint64_t significand, int32_t exponent)
{
    luenberger_scaled_t result;
    result.significand = significand;
    result.exponent = exponent;
    return result;
}

/* Makes a number of a significand of at least 2^62. */
static luenberger_scaled_t luenberger_settled(uint64_t significand, int32_t exponent)
{
    if ((significand >> 63) == 0) {
        return luenberger_scaled(significand << 1, exponent - 1);
    }
    return luenberger_scaled(significand, exponent);
}

/* (1 - cos(r)) / r^2 in powers of -r^2. */
static const uint64_t LUENBERGER_COSINE[8] = {
    UINT64_C(0x8000000000000000), UINT64_C(0x0AAAAAAAAAAAAAA8), UINT64_C(0x005B05B05B05B02B),
    UINT64_C(0x0001A01A01A01865), UINT64_C(0x0000049F93EDD666), UINT64_C(0x00000008F76C6243),
    UINT64_C(0x000000000C9C9706), UINT64_C(0x00000000000D551B)};

/* cos(r) for 0 < r <= pi/4, relative error below 2^-60. */
static luenberger_scaled_t luenberger_cosine(luenberger_scaled_t r)
{
    const uint64_t z = luenberger_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = LUENBERGER_COSINE[6] - ((LUENBERGER_COSINE[7] * z_high) >> 32);
    const uint64_t c5 = LUENBERGER_COSINE[5] - ((tail * z_high) >> 32);
    const uint64_t c4 = LUENBERGER_COSINE[4] - luenberger_mul_high(c5, z);
    const uint64_t c3 = LUENBERGER_COSINE[3] - luenberger_mul_high(c4, z);
    const uint64_t c2 = LUENBERGER_COSINE[2] - luenberger_mul_high(c3, z);
    const uint64_t c1 = LUENBERGER_COSINE[1] - luenberger_mul_high(c2, z);
    const uint64_t c0 = LUENBERGER_COSINE[0] - luenberger_mul_high(c1, z);
    return luenberger_settled((UINT64_C(1) << 63) - (luenberger_mul_high(c0, z) >> 1), 0);
}

/* (1 - sin(r) / r) / r^2 in powers of -r^2. */
static const uint64_t LUENBERGER_SINE[7] = {
    UINT64_C(0x2AAAAAAAAAAAAAA6), UINT64_C(0x0222222222222160), UINT64_C(0x000D00D00D00C575),
    UINT64_C(0x00002E3BC74A673D), UINT64_C(0x0000006B9914A637), UINT64_C(0x00000000B090498C),
    UINT64_C(0x0000000000D552BC)};

/* sin(r) for 0 < r <= pi/4, relative error below 2^-60. */
static luenberger_scaled_t luenberger_sine(luenberger_scaled_t r)
{
    const uint64_t z = luenberger_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = LUENBERGER_SINE[5] - ((LUENBERGER_SINE[6] * z_high) >> 32);
    const uint64_t c4 = LUENBERGER_SINE[4] - ((tail * z_high) >> 32);
    const uint64_t c3 = LUENBERGER_SINE[3] - luenberger_mul_high(c4, z);
    const uint64_t c2 = LUENBERGER_SINE[2] - luenberger_mul_high(c3, z);
    const uint64_t c1 = LUENBERGER_SINE[1] - luenberger_mul_high(c2, z);
    const uint64_t c0 = LUENBERGER_SINE[0] - luenberger_mul_high(c1, z);
    const uint64_t lost = luenberger_mul_high(r.significand, luenberger_mul_high(c0, z));
    return luenberger_settled(r.significand - lost, r.exponent);
}

/* The sine of an angle. */
static luenberger_signed_t luenberger_sine_at(luenberger_turned_t angle)
{
    const int back = (angle.quadrant & 2) != 0;
    if ((angle.quadrant & 1) != 0) {
        return luenberger_signed(luenberger_cosine(angle.rest.magnitude), back);
    }
    return luenberger_signed(luenberger_sine(angle.rest.magnitude), back != angle.rest.negative);
}

/* Makes an angle of its parts. */
static luenberger_turned_t luenberger_turned(luenberger_signed_t rest, uint32_t quadrant)
{
    luenberger_turned_t result;
    result.rest = rest;
    result.quadrant = quadrant;
    return result;
}

/* The number of zero bits above the highest one bit; x is not 0. */
static int32_t luenberger_leading_zeros(uint64_t x)
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
static luenberger_scaled_t luenberger_normalised(uint64_t significand, int32_t exponent)
{
    const int32_t shift = luenberger_leading_zeros(significand);
    return luenberger_scaled(significand << shift, exponent - shift);
}

/* The finite positive number with these bits, not 0; exact. */
static luenberger_scaled_t luenberger_unpacked_f32(uint32_t magnitude)
{
    const int32_t field = (int32_t)(magnitude >> 23);
    const uint64_t digits = (uint64_t)magnitude << 40;
    if (field == 0) {
        return luenberger_normalised(digits, -126);
    }
    return luenberger_scaled(digits | (UINT64_C(1) << 63), field - 127);
}

/* 2/pi after 32 zero bits. */
static const uint32_t LUENBERGER_TWO_OVER_PI_F32[9] = {
    UINT32_C(0x00000000), UINT32_C(0xA2F9836E), UINT32_C(0x4E441529),
    UINT32_C(0xFC2757D1), UINT32_C(0xF534DDC0), UINT32_C(0xDB629599),
    UINT32_C(0x3C439041), UINT32_C(0xFE5163AB), UINT32_C(0xDEBBC561)};

/* 32 bits of 2/pi from bit 32 slot + shift on. */
static uint64_t luenberger_window_f32(uint32_t slot, uint32_t shift)
{
    const uint64_t first = (uint64_t)(LUENBERGER_TWO_OVER_PI_F32[slot]);
    const uint64_t second = (uint64_t)(LUENBERGER_TWO_OVER_PI_F32[slot + 1]);
    return (((first << 32) | second) >> (32 - shift)) & 0xFFFFFFFFu;
}

/* a b, relative error below 2^-60. */
static luenberger_scaled_t luenberger_product(luenberger_scaled_t a, luenberger_scaled_t b)
{
    return luenberger_settled(luenberger_mul_high(a.significand, b.significand),
                            a.exponent + b.exponent + 1);
}

/* pi with 62 fraction bits; as a significand also pi/2 and pi/4. */
#define LUENBERGER_PI UINT64_C(0xC90FDAA22168C235)

/* The angle of (high, low) / 2^126 quarter turns, its rest exact to 2^-60 of itself. */
static luenberger_turned_t luenberger_turned_from_quarters(uint64_t high, uint64_t low)
{
    const uint64_t eighths = high >> 61;
    const int negative = (eighths & 1) != 0;
    uint64_t upper = (high << 2) | (low >> 62);
    uint64_t lower = low << 2;
    if (negative) {
        upper = (lower == 0) ? (UINT64_C(0) - upper) : UINT64_MAX - upper;
        lower = (UINT64_C(0) - lower);
    }
    const int32_t shift = luenberger_leading_zeros(upper | 1);
    const uint64_t significand = (upper << shift) | ((lower >> 1) >> (63 - shift));
    const luenberger_signed_t rest = luenberger_signed(
        luenberger_product(luenberger_scaled(significand, -1 - shift), luenberger_scaled(LUENBERGER_PI, 0)),
        negative);
    return luenberger_turned(rest, (uint32_t)(((eighths + 1) >> 1) & 3));
}

/* The angle with these bits, positive and finite, its rest exact to 2^-38 of itself. */
static luenberger_turned_t luenberger_reduce_f32(uint32_t magnitude)
{
    if (magnitude <= 0x3F490FDAu) {
        return luenberger_turned(luenberger_signed(luenberger_unpacked_f32(magnitude), 0), 0);
    }
    const uint64_t digits = (uint64_t)((magnitude & 0x007FFFFFu) | 0x00800000u);
    const uint32_t start = (magnitude >> 23) - 120;
    const uint32_t slot = start >> 5;
    const uint32_t shift = start & 31;
    const uint64_t upper = (luenberger_window_f32(slot, shift) * digits) << 32;
    const uint64_t middle = luenberger_window_f32(slot + 1, shift) * digits;
    const uint64_t lower = luenberger_window_f32(slot + 2, shift) * digits;
    return luenberger_turned_from_quarters(((upper + middle) + (lower >> 32)), lower << 32);
}

/* x rounded to the nearest, ties to even, with subnormals and overflow, and the sign put in. */
static float luenberger_rounded_f32(uint32_t sign, luenberger_scaled_t x)
{
    const int32_t field = x.exponent + 127;
    if (field >= 255) {
        return luenberger_f32_from_bits(sign | LUENBERGER_INFINITY_F32);
    }
    const int32_t shift = (field > 0) ? 40 : 41 - field;
    if (shift > 63) {
        const int least = shift == 64 && x.significand > (UINT64_C(1) << 63);
        return luenberger_f32_from_bits(least ? sign + 1 : sign);
    }
    const uint64_t kept = x.significand >> shift;
    const uint64_t rest = x.significand - (kept << shift);
    const uint64_t half = UINT64_C(1) << (shift - 1);
    const uint64_t odd = kept & 1;
    const uint64_t up = (rest + odd > half) ? 1 : 0;
    const uint32_t base = (field > 0) ? ((uint32_t)(field - 1)) << 23 : 0;
    return luenberger_f32_from_bits(sign | (base + ((uint32_t)(kept + up))));
}

/* The sign bit of a negative number, else 0. */
static uint32_t luenberger_sign_f32(int negative)
{
    if (negative) {
        return LUENBERGER_SIGN_F32;
    }
    return 0;
}

/* Sine of an angle in radians, the nearest float. */
static float luenberger_sin_f32(float x)
{
    const uint32_t bits = luenberger_f32_to_bits(x);
    const uint32_t magnitude = bits & LUENBERGER_MAGNITUDE_F32;
    if (magnitude >= LUENBERGER_INFINITY_F32) {
        return luenberger_f32_from_bits(LUENBERGER_NAN_F32);
    }
    if (magnitude == 0) {
        return x;
    }
    const luenberger_signed_t value = luenberger_sine_at(luenberger_reduce_f32(magnitude));
    return luenberger_rounded_f32((bits & LUENBERGER_SIGN_F32) ^ luenberger_sign_f32(value.negative),
                                value.magnitude);
}

/* What one part of a step hands to the next. */
typedef struct {
    float t52;
    float t70;
    float t71;
    float t72;
    float t86;
    float t87;
    float t88;
    luenberger_status t107;
    int flags[2]; /* t1, t60 */
} luenberger_work;

/* Part 1 of a step. */
static void luenberger_part_1(luenberger_state *state, const luenberger_measurements *measurements, const luenberger_inputs *inputs, luenberger_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    const float t0 = measurements->y;
    work->flags[0] = (-1e35f <= t0) && (t0 <= 1e35f);
    const float t2 = inputs->u;
    const int t3 = (-1e35f <= t2) && (t2 <= 1e35f);
    const float t4 = state->last_u;
    const float t5 = t3 ? t2 : t4;

    /* prediction by the plant */
    const float t6 = state->q;
    const float t7 = state->dq;
    const float t8 = state->i;
    const float t9 = state->last_known1;
    const float t11 = 0.0009994135f * t7;
    const float t13 = 7.021338e-6f * t8;
    const float t15 = 9.516694e-8f * t5;
    const float t17 = -1.1661682e-5f * t9;
    const float t18 = t6 + t11;
    const float t19 = t13 + t15;
    const float t20 = t19 + t17;
    const float t21 = t18 + t20;
    const float t23 = 0.998745f * t7;
    const float t25 = 0.0135869365f * t8;
    const float t27 = 0.00028085354f * t5;
    const float t29 = -0.017486073f * t9;
    const float t30 = t23 + t25;
    const float t31 = t30 + t27;
    const float t32 = t31 + t29;
    const float t34 = -0.032970965f * t7;
    const float t36 = 0.81849164f * t8;
    const float t38 = 0.036250554f * t5;
    const float t40 = 0.0003942745f * t9;
    const float t41 = t34 + t36;
    const float t42 = t41 + t38;
    const float t43 = t42 + t40;
    const float t45 = -5.8317214e-6f * t9;
    const float t46 = t21 + t45;
    const float t49 = state->last_y;
    const int t50 = (-1e35f <= t46) && (t46 <= 1e35f);
    const float t51 = t50 ? t46 : t49;
    work->t52 = work->flags[0] ? t0 : t51;
    const float t53 = luenberger_sin_f32(work->t52);
    const float t54 = -5.8317214e-6f * t53;
    const float t55 = t21 + t54;
    const float t56 = -0.017493403f * t53;
    const float t57 = t32 + t56;
    const float t58 = 0.00020207113f * t53;
    const float t59 = t43 + t58;
    state->last_u = t5;
    state->last_known1 = t53;
    state->last_y = work->t52;
    work->flags[1] = t3 && work->flags[0];

    /* correction by the innovation */
    const float t62 = work->t52 - t55;
    const float t63 = work->flags[0] ? t62 : 0.0f;
    const float t65 = 0.028583536f * t63;
    const float t67 = 7.803088f * t63;
    const float t69 = -80.83801f * t63;
    work->t70 = t55 + t65;
    work->t71 = t57 + t67;
    work->t72 = t59 + t69;
}

/* Part 2 of a step. */
static void luenberger_part_2(luenberger_state *state, luenberger_work *work)
{
    /* the first sample starts the observer; so does a state beyond all bounds */
    const uint32_t t74 = state->good;
    const int t75 = t74 == 0U;
    const int t76 = (-1e35f <= work->t70) && (work->t70 <= 1e35f);
    const int t77 = !t76;
    const int t78 = t75 || t77;
    const int t79 = (-1e35f <= work->t71) && (work->t71 <= 1e35f);
    const int t80 = !t79;
    const int t81 = t78 || t80;
    const int t82 = (-1e35f <= work->t72) && (work->t72 <= 1e35f);
    const int t83 = !t82;
    const int t84 = t81 || t83;
    const float t85 = work->flags[0] ? work->t52 : 0.0f;
    work->t86 = t84 ? t85 : work->t70;
    state->q = work->t86;
    work->t87 = t84 ? 0.0f : work->t71;
    state->dq = work->t87;
    work->t88 = t84 ? 0.0f : work->t72;
    state->i = work->t88;
    const uint32_t t90 = work->flags[0] ? 1U : 0U;
    const uint32_t t91 = (t74 < 416U) ? (t74 + 1U) : 416U;
    const uint32_t t92 = work->flags[0] ? t91 : t74;
    const uint32_t t93 = t84 ? t90 : t92;
    state->good = t93;
    const uint32_t t94 = state->clean;
    const uint32_t t95 = (t94 < 426U) ? (t94 + 1U) : 426U;
    const uint32_t t96 = work->flags[1] ? t95 : 0U;
    const uint32_t t98 = t84 ? 426U : t96;
    state->clean = t98;

    /* the estimate */
    const int t101 = 415U < t93;
    const int t102 = 425U < t98;
    const luenberger_status t106 = t102 ? LUENBERGER_CONVERGED : LUENBERGER_COASTING;
    work->t107 = t101 ? t106 : LUENBERGER_CONVERGING;
}

void luenberger_init(luenberger_state *state)
{
    state->q = 0.0f;
    state->dq = 0.0f;
    state->i = 0.0f;
    state->good = 0U;
    state->clean = 0U;
    state->last_y = 0.0f;
    state->last_u = 0.0f;
    state->last_known1 = 0.0f;
}

void luenberger_step(luenberger_state *state, const luenberger_measurements *measurements,
                     const luenberger_inputs *inputs, luenberger_estimate *estimate)
{
    luenberger_work work;
    luenberger_part_1(state, measurements, inputs, &work);
    luenberger_part_2(state, &work);

    estimate->q = work.t86;
    estimate->dq = work.t87;
    estimate->i = work.t88;
    estimate->status = work.t107;
}
