/* pendulum_turning.c: Finite-time observer: A driven pendulum that goes round, seen by an encoder of one turn.
 *
 * Generated; pendulum_turning.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "pendulum_turning.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "pendulum_turning.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "pendulum_turning.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* weights by age, from age 1
 *   [0] q from y
 *   [1] dq from y
 *   [2] load from y
 *   [3] q from tau
 *   [4] dq from tau
 *   [5] load from tau
 *   [6] q from sin(q)
 *   [7] dq from sin(q)
 *   [8] load from sin(q)
 */
static const float PENDULUM_TURNING_WINDOW[29][9] = {
    {
        0.22195871f, 13.604253f, 44.73121f, 3.3116376e-5f, 0.015364128f, -0.0034831841f,
        -6.173054e-5f, -0.04186008f, 0.00550351f
    },
    {
        0.1916382f, 10.910868f, 34.460903f, 4.711264e-5f, 0.014157639f, -0.007345106f,
        -0.0001076515f, -0.03917578f, 0.014092135f
    },
    {
        0.16308019f, 8.398417f, 24.93416f, 5.5242803e-5f, 0.012636686f, -0.01217393f,
        -0.00013674391f, -0.035545263f, 0.02567148f
    },
    {
        0.13628899f, 6.067351f, 16.152822f, 5.8431284e-5f, 0.010881674f, -0.017666282f,
        -0.00015153638f, -0.03118967f, 0.0394045f
    },
    {
        0.111269005f, 3.9181154f, 8.118728f, 5.754207e-5f, 0.008966836f, -0.023544073f,
        -0.00015439739f, -0.026313802f, 0.05452114f
    },
    {
        0.088024594f, 1.9511613f, 0.8337275f, 5.3378702e-5f, 0.00696024f, -0.029554503f,
        -0.0001475353f, -0.021106109f, 0.07031832f
    },
    {
        0.066560164f, 0.16693874f, -5.700328f, 4.6684283e-5f, 0.0049237823f, -0.035470057f,
        -0.00013299844f, -0.015738709f, 0.08615992f
    },
    {
        0.0468801f, -1.4341004f, -11.481582f, 3.8141476e-5f, 0.0029131898f, -0.041088503f,
        -0.000112675f, -0.010367377f, 0.101476826f
    },
    {
        0.02898882f, -2.8515031f, -16.508173f, 2.8372528e-5f, 0.0009780233f, -0.04623289f,
        -8.829315e-5f, -0.0051315525f, 0.115766846f
    },
    {
        0.012890746f, -4.0848155f, -20.778236f, 1.7939254e-5f, -0.0008383255f, -0.050751552f,
        -6.142099e-5f, -0.00015433587f, 0.1285948f
    },
    {
        -0.0014096885f, -5.1335826f, -24.289902f, 7.343051e-6f, -0.0024986318f, -0.0545181f,
        -3.34666e-5f, 0.004457508f, 0.13959242f
    },
    {
        -0.013908041f, -5.9973483f, -27.041292f, -2.9751034e-6f, -0.0039718384f, -0.057431422f,
        -5.678003e-6f, 0.008613551f, 0.14845844f
    },
    {
        -0.024599854f, -6.675655f, -29.03053f, -1.2634647e-5f, -0.005233056f, -0.059415694f,
        2.0856796e-5f, 0.012239699f, 0.15495852f
    },
    {
        -0.033480663f, -7.168044f, -30.255732f, -2.131543e-5f, -0.006263561f, -0.06042036f,
        4.520981e-5f, 0.015278194f, 0.15892528f
    },
    {
        -0.040545993f, -7.474056f, -30.715008f, -2.8757717e-5f, -0.007050798f, -0.060420156f,
        6.6613065e-5f, 0.017687611f, 0.16025834f
    },
    {
        -0.04579135f, -7.5932302f, -30.406464f, -3.4762175e-5f, -0.007588377f, -0.059415076f,
        8.445859e-5f, 0.019442862f, 0.15892419f
    },
    {
        -0.049212243f, -7.5251045f, -29.328201f, -3.9189887e-5f, -0.007876077f, -0.05743041f,
        9.8298435e-5f, 0.02053519f, 0.15495636f
    },
    {
        -0.050804153f, -7.269216f, -27.47832f, -4.196234e-5f, -0.007919841f, -0.054516714f,
        0.00010784464f, 0.02097217f, 0.14845526f
    },
    {
        -0.050562564f, -6.825101f, -24.854908f, -4.3061427e-5f, -0.0077317813f, -0.050749835f,
        0.00011296925f, 0.02077772f, 0.13958831f
    },
    {
        -0.048482943f, -6.192293f, -21.456057f, -4.2529453e-5f, -0.007330176f, -0.046230886f,
        0.0001137043f, 0.019992081f, 0.12858987f
    },
    {
        -0.04456074f, -5.370327f, -17.279848f, -4.046912e-5f, -0.00673947f, -0.04108627f,
        0.00011024184f, 0.018671839f, 0.11576124f
    },
    {
        -0.03879141f, -4.358734f, -12.324361f, -3.704355e-5f, -0.0059902766f, -0.035467666f,
        0.00010293392f, 0.016889906f, 0.1014707f
    },
    {
        -0.031170378f, -3.1570458f, -6.5876675f, -3.2476262e-5f, -0.0051193745f, -0.029552028f,
        9.2292576e-5f, 0.014735533f, 0.08615348f
    },
    {
        -0.02169307f, -1.7647928f, -0.0678367f, -2.7051197e-5f, -0.004169712f, -0.023541601f,
        7.898987e-5f, 0.012314308f, 0.07031176f
    },
    {
        -0.010354894f, -0.18150328f, 7.237067f, -2.11127e-5f, -0.003190403f, -0.017663915f,
        6.3857864e-5f, 0.009748153f, 0.054514732f
    },
    {
        0.0028487465f, 1.5932947f, 15.328985f, -1.5065531e-5f, -0.0022367325f, -0.012171777f,
        4.7888643e-5f, 0.0071753296f, 0.039398514f
    },
    {
        0.017922465f, 3.5600748f, 24.209862f, -9.374869e-6f, -0.0013701514f, -0.0073432853f,
        3.2234308e-5f, 0.004750435f, 0.025666216f
    },
    {
        0.034870885f, 5.719311f, 33.88165f, -4.566309e-6f, -0.00065828074f, -0.0034818265f,
        1.8206983e-5f, 0.002644406f, 0.014087926f
    },
    {
        0.05369864f, 8.071481f, 44.346302f, -1.225871e-6f, -0.00017491032f, -0.0009160753f,
        7.278843e-6f, 0.0010445204f, 0.005500713f
    }
};

/* The bits of a number. */
typedef union {
    float value;
    uint32_t bits;
} pendulum_turning_f32_cell_t;

/* The bits of a number. */
static uint32_t pendulum_turning_f32_to_bits(float x)
{
    pendulum_turning_f32_cell_t cell;
    cell.value = x;
    return cell.bits;
}

/* The bit of the sign. */
#define PENDULUM_TURNING_SIGN_F32 UINT32_C(0x80000000)

/* The bits of the largest magnitude. */
#define PENDULUM_TURNING_MAGNITUDE_F32 UINT32_C(0x7FFFFFFF)

/* The bits of infinity. */
#define PENDULUM_TURNING_INFINITY_F32 UINT32_C(0x7F800000)

/* The bits of the only NaN that is returned. */
#define PENDULUM_TURNING_NAN_F32 UINT32_C(0x7FC00000)

/* The number with these bits. */
static float pendulum_turning_f32_from_bits(uint32_t bits)
{
    pendulum_turning_f32_cell_t cell;
    cell.bits = bits;
    return cell.value;
}

/* The number significand / 2^63 * 2^exponent, with the top bit of the significand set. */
typedef struct {
    uint64_t significand;
    int32_t exponent;
} pendulum_turning_scaled_t;

/* A number with a sign. */
typedef struct {
    pendulum_turning_scaled_t magnitude;
    int negative;
} pendulum_turning_signed_t;

/* The angle quadrant * pi/2 + rest. */
typedef struct {
    pendulum_turning_signed_t rest;
    uint32_t quadrant;
} pendulum_turning_turned_t;

/* Attaches a sign. */
static pendulum_turning_signed_t pendulum_turning_signed(pendulum_turning_scaled_t magnitude, int negative)
{
    pendulum_turning_signed_t result;
    result.magnitude = magnitude;
    result.negative = negative;
    return result;
}

/* A number below 1 as fixed point with 64 fraction bits. */
static uint64_t pendulum_turning_fraction(pendulum_turning_scaled_t a)
{
    const int32_t shift = -1 - a.exponent;
    if (shift > 63) {
        return 0;
    }
    return a.significand >> shift;
}

/* The upper half of the product, at most 2 too small. */
static uint64_t pendulum_turning_mul_high(uint64_t a, uint64_t b)
{
    const uint64_t a_high = a >> 32;
    const uint64_t a_low = a & 0xFFFFFFFFu;
    const uint64_t b_high = b >> 32;
    const uint64_t b_low = b & 0xFFFFFFFFu;
    const uint64_t cross = ((a_high * b_low) >> 32) + ((a_low * b_high) >> 32);
    return a_high * b_high + cross;
}

/* The square of a number below 1 as fixed point with 64 fraction bits. */
static uint64_t pendulum_turning_squared_fraction(pendulum_turning_scaled_t a)
{
    const uint64_t x = pendulum_turning_fraction(a);
    return pendulum_turning_mul_high(x, x);
}

/* Makes a number of a significand that has its top bit set. */
static pendulum_turning_scaled_t pendulum_turning_scaled(uint64_t significand, int32_t exponent)
{
    pendulum_turning_scaled_t result;
    result.significand = significand;
    result.exponent = exponent;
    return result;
}

/* Makes a number of a significand of at least 2^62. */
static pendulum_turning_scaled_t pendulum_turning_settled(uint64_t significand, int32_t exponent)
{
    if ((significand >> 63) == 0) {
        return pendulum_turning_scaled(significand << 1, exponent - 1);
    }
    return pendulum_turning_scaled(significand, exponent);
}

/* (1 - cos(r)) / r^2 in powers of -r^2. */
static const uint64_t PENDULUM_TURNING_COSINE[8] = {
    UINT64_C(0x8000000000000000), UINT64_C(0x0AAAAAAAAAAAAAA8), UINT64_C(0x005B05B05B05B02B),
    UINT64_C(0x0001A01A01A01865), UINT64_C(0x0000049F93EDD666), UINT64_C(0x00000008F76C6243),
    UINT64_C(0x000000000C9C9706), UINT64_C(0x00000000000D551B)};

/* cos(r) for 0 < r <= pi/4, relative error below 2^-60. */
static pendulum_turning_scaled_t pendulum_turning_cosine(pendulum_turning_scaled_t r)
{
    const uint64_t z = pendulum_turning_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = PENDULUM_TURNING_COSINE[6] - ((PENDULUM_TURNING_COSINE[7] * z_high) >> 32);
    const uint64_t c5 = PENDULUM_TURNING_COSINE[5] - ((tail * z_high) >> 32);
    const uint64_t c4 = PENDULUM_TURNING_COSINE[4] - pendulum_turning_mul_high(c5, z);
    const uint64_t c3 = PENDULUM_TURNING_COSINE[3] - pendulum_turning_mul_high(c4, z);
    const uint64_t c2 = PENDULUM_TURNING_COSINE[2] - pendulum_turning_mul_high(c3, z);
    const uint64_t c1 = PENDULUM_TURNING_COSINE[1] - pendulum_turning_mul_high(c2, z);
    const uint64_t c0 = PENDULUM_TURNING_COSINE[0] - pendulum_turning_mul_high(c1, z);
    return pendulum_turning_settled((UINT64_C(1) << 63) - (pendulum_turning_mul_high(c0, z) >> 1), 0);
}

/* (1 - sin(r) / r) / r^2 in powers of -r^2. */
static const uint64_t PENDULUM_TURNING_SINE[7] = {
    UINT64_C(0x2AAAAAAAAAAAAAA6), UINT64_C(0x0222222222222160), UINT64_C(0x000D00D00D00C575),
    UINT64_C(0x00002E3BC74A673D), UINT64_C(0x0000006B9914A637), UINT64_C(0x00000000B090498C),
    UINT64_C(0x0000000000D552BC)};

/* sin(r) for 0 < r <= pi/4, relative error below 2^-60. */
static pendulum_turning_scaled_t pendulum_turning_sine(pendulum_turning_scaled_t r)
{
    const uint64_t z = pendulum_turning_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = PENDULUM_TURNING_SINE[5] - ((PENDULUM_TURNING_SINE[6] * z_high) >> 32);
    const uint64_t c4 = PENDULUM_TURNING_SINE[4] - ((tail * z_high) >> 32);
    const uint64_t c3 = PENDULUM_TURNING_SINE[3] - pendulum_turning_mul_high(c4, z);
    const uint64_t c2 = PENDULUM_TURNING_SINE[2] - pendulum_turning_mul_high(c3, z);
    const uint64_t c1 = PENDULUM_TURNING_SINE[1] - pendulum_turning_mul_high(c2, z);
    const uint64_t c0 = PENDULUM_TURNING_SINE[0] - pendulum_turning_mul_high(c1, z);
    const uint64_t lost = pendulum_turning_mul_high(r.significand, pendulum_turning_mul_high(c0, z));
    return pendulum_turning_settled(r.significand - lost, r.exponent);
}

/* The sine of an angle. */
static pendulum_turning_signed_t pendulum_turning_sine_at(pendulum_turning_turned_t angle)
{
    const int back = (angle.quadrant & 2) != 0;
    if ((angle.quadrant & 1) != 0) {
        return pendulum_turning_signed(pendulum_turning_cosine(angle.rest.magnitude), back);
    }
    return pendulum_turning_signed(pendulum_turning_sine(angle.rest.magnitude), back != angle.rest.negative);
}

/* Makes an angle of its parts. */
static pendulum_turning_turned_t pendulum_turning_turned(pendulum_turning_signed_t rest, uint32_t quadrant)
{
    pendulum_turning_turned_t result;
    result.rest = rest;
    result.quadrant = quadrant;
    return result;
}

/* The number of zero bits above the highest one bit; x is not 0. */
static int32_t pendulum_turning_leading_zeros(uint64_t x)
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
static pendulum_turning_scaled_t pendulum_turning_normalised(uint64_t significand, int32_t exponent)
{
    const int32_t shift = pendulum_turning_leading_zeros(significand);
    return pendulum_turning_scaled(significand << shift, exponent - shift);
}

/* The finite positive number with these bits, not 0; exact. */
static pendulum_turning_scaled_t pendulum_turning_unpacked_f32(uint32_t magnitude)
{
    const int32_t field = (int32_t)(magnitude >> 23);
    const uint64_t digits = (uint64_t)magnitude << 40;
    if (field == 0) {
        return pendulum_turning_normalised(digits, -126);
    }
    return pendulum_turning_scaled(digits | (UINT64_C(1) << 63), field - 127);
}

/* 2/pi after 32 zero bits. */
static const uint32_t PENDULUM_TURNING_TWO_OVER_PI_F32[9] = {
    UINT32_C(0x00000000), UINT32_C(0xA2F9836E), UINT32_C(0x4E441529),
    UINT32_C(0xFC2757D1), UINT32_C(0xF534DDC0), UINT32_C(0xDB629599),
    UINT32_C(0x3C439041), UINT32_C(0xFE5163AB), UINT32_C(0xDEBBC561)};

/* 32 bits of 2/pi from bit 32 slot + shift on. */
static uint64_t pendulum_turning_window_f32(uint32_t slot, uint32_t shift)
{
    const uint64_t first = (uint64_t)(PENDULUM_TURNING_TWO_OVER_PI_F32[slot]);
    const uint64_t second = (uint64_t)(PENDULUM_TURNING_TWO_OVER_PI_F32[slot + 1]);
    return (((first << 32) | second) >> (32 - shift)) & 0xFFFFFFFFu;
}

/* a b, relative error below 2^-60. */
static pendulum_turning_scaled_t pendulum_turning_product(pendulum_turning_scaled_t a, pendulum_turning_scaled_t b)
{
    return pendulum_turning_settled(pendulum_turning_mul_high(a.significand, b.significand),
                            a.exponent + b.exponent + 1);
}

/* pi with 62 fraction bits; as a significand also pi/2 and pi/4. */
#define PENDULUM_TURNING_PI UINT64_C(0xC90FDAA22168C235)

/* The angle of (high, low) / 2^126 quarter turns, its rest exact to 2^-60 of itself. */
static pendulum_turning_turned_t pendulum_turning_turned_from_quarters(uint64_t high, uint64_t low)
{
    const uint64_t eighths = high >> 61;
    const int negative = (eighths & 1) != 0;
    uint64_t upper = (high << 2) | (low >> 62);
    uint64_t lower = low << 2;
    if (negative) {
        upper = (lower == 0) ? (UINT64_C(0) - upper) : UINT64_MAX - upper;
        lower = (UINT64_C(0) - lower);
    }
    const int32_t shift = pendulum_turning_leading_zeros(upper | 1);
    const uint64_t significand = (upper << shift) | ((lower >> 1) >> (63 - shift));
    const pendulum_turning_signed_t rest = pendulum_turning_signed(
        pendulum_turning_product(pendulum_turning_scaled(significand, -1 - shift), pendulum_turning_scaled(PENDULUM_TURNING_PI, 0)),
        negative);
    return pendulum_turning_turned(rest, (uint32_t)(((eighths + 1) >> 1) & 3));
}

/* The angle with these bits, positive and finite, its rest exact to 2^-38 of itself. */
static pendulum_turning_turned_t pendulum_turning_reduce_f32(uint32_t magnitude)
{
    if (magnitude <= 0x3F490FDAu) {
        return pendulum_turning_turned(pendulum_turning_signed(pendulum_turning_unpacked_f32(magnitude), 0), 0);
    }
    const uint64_t digits = (uint64_t)((magnitude & 0x007FFFFFu) | 0x00800000u);
    const uint32_t start = (magnitude >> 23) - 120;
    const uint32_t slot = start >> 5;
    const uint32_t shift = start & 31;
    const uint64_t upper = (pendulum_turning_window_f32(slot, shift) * digits) << 32;
    const uint64_t middle = pendulum_turning_window_f32(slot + 1, shift) * digits;
    const uint64_t lower = pendulum_turning_window_f32(slot + 2, shift) * digits;
    return pendulum_turning_turned_from_quarters(((upper + middle) + (lower >> 32)), lower << 32);
}

/* x rounded to the nearest, ties to even, with subnormals and overflow, and the sign put in. */
static float pendulum_turning_rounded_f32(uint32_t sign, pendulum_turning_scaled_t x)
{
    const int32_t field = x.exponent + 127;
    if (field >= 255) {
        return pendulum_turning_f32_from_bits(sign | PENDULUM_TURNING_INFINITY_F32);
    }
    const int32_t shift = (field > 0) ? 40 : 41 - field;
    if (shift > 63) {
        const int least = shift == 64 && x.significand > (UINT64_C(1) << 63);
        return pendulum_turning_f32_from_bits(least ? sign + 1 : sign);
    }
    const uint64_t kept = x.significand >> shift;
    const uint64_t rest = x.significand - (kept << shift);
    const uint64_t half = UINT64_C(1) << (shift - 1);
    const uint64_t odd = kept & 1;
    const uint64_t up = (rest + odd > half) ? 1 : 0;
    const uint32_t base = (field > 0) ? ((uint32_t)(field - 1)) << 23 : 0;
    return pendulum_turning_f32_from_bits(sign | (base + ((uint32_t)(kept + up))));
}

/* The sign bit of a negative number, else 0. */
static uint32_t pendulum_turning_sign_f32(int negative)
{
    if (negative) {
        return PENDULUM_TURNING_SIGN_F32;
    }
    return 0;
}

/* Sine of an angle in radians, the nearest float. */
static float pendulum_turning_sin_f32(float x)
{
    const uint32_t bits = pendulum_turning_f32_to_bits(x);
    const uint32_t magnitude = bits & PENDULUM_TURNING_MAGNITUDE_F32;
    if (magnitude >= PENDULUM_TURNING_INFINITY_F32) {
        return pendulum_turning_f32_from_bits(PENDULUM_TURNING_NAN_F32);
    }
    if (magnitude == 0) {
        return x;
    }
    const pendulum_turning_signed_t value = pendulum_turning_sine_at(pendulum_turning_reduce_f32(magnitude));
    return pendulum_turning_rounded_f32((bits & PENDULUM_TURNING_SIGN_F32) ^ pendulum_turning_sign_f32(value.negative),
                                value.magnitude);
}

/* What one part of a step hands to the next. */
typedef struct {
    uint32_t t2;
    float t24;
    uint32_t t25;
    float t65;
    float t82;
    uint32_t t85;
    uint32_t t94;
    float t117;
    float t120;
    float t121;
    float t123;
    float t124;
    float t176;
    float t179;
    float t182;
    float t183;
    float t186;
    float t209;
    float t210;
    float t211;
    pendulum_turning_status t218;
    int flags[5]; /* t4, t22, t60, t61, t81 */
} pendulum_turning_work;

/* Part 1 of a step. */
static void pendulum_turning_part_1(pendulum_turning_state *state, const pendulum_turning_measurements *measurements, const pendulum_turning_inputs *inputs, pendulum_turning_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    const uint32_t t0 = state->newest;
    const uint32_t t1 = (t0 < 30U) ? t0 : 30U;
    work->t2 = state->count;
    work->flags[0] = 30U < work->t2;
    const float t5 = measurements->y;
    const int t6 = (-6588397.5f <= t5) && (t5 <= 6588397.5f);
    const float t8 = t5 * 0.15915494f;
    const float t10 = t8 + 1.2582912e7f;
    const float t11 = t10 - 1.2582912e7f;
    const float t13 = t11 * 6.28125f;
    const float t14 = t5 - t13;
    const float t16 = t11 * 0.0019350052f;
    const float t17 = t14 - t16;
    const float t19 = t11 * 3.019916e-7f;
    const float t20 = t17 - t19;
    const float t21 = inputs->tau;
    work->flags[1] = (-1e32f <= t21) && (t21 <= 1e32f);
    const float t23 = state->tau[t1];
    work->t24 = work->flags[1] ? t21 : t23;

    /* prediction, for a sample that is missing */
    work->t25 = (t1 < 30U) ? (t1 + 1U) : 0U;
    const float t26 = state->ahead_y;
    const float t28 = 1.6447366e-5f * work->t24;
    const float t29 = t26 + t28;
    const float t30 = state->y[t1];
    const float t31 = t30 + t29;
    const float t32 = t31 * 0.15915494f;
    const float t33 = t32 + 1.2582912e7f;
    const float t34 = t33 - 1.2582912e7f;
    const float t36 = t34 * 6.2831855f;
    const float t37 = t31 - t36;
    const float t38 = t20 - t37;
    const float t39 = t38 * 0.15915494f;
    const float t40 = t39 + 1.2582912e7f;
    const float t41 = t40 - 1.2582912e7f;
    const float t42 = t41 * 6.2831855f;
    const float t43 = t38 - t42;
    const int t44 = (-6.2831855f <= t37) && (t37 <= 6.2831855f);
    const int t45 = (-0.2f <= t43) && (t43 <= 0.2f);
    const int t46 = !t45;
    const int t47 = t44 && t46;
    const int t48 = work->flags[0] && t47;
    const int t49 = t6 && t48;
    const uint32_t t50 = state->rejected_y;
    const int t53 = t50 < 19U;
    const int t54 = t49 && t53;
    const uint32_t t55 = (t50 < 20U) ? (t50 + 1U) : 20U;
    const uint32_t t56 = t6 ? 0U : t50;
    const uint32_t t57 = t54 ? t55 : t56;
    state->rejected_y = t57;
    const int t58 = !t54;
    const int t59 = !t53;
    work->flags[2] = t6 && t58;
    work->flags[3] = t49 && t59;
    const int t62 = work->flags[0] && t44;
    const float t63 = t62 ? t37 : t30;
    const float t64 = work->flags[2] ? t20 : t63;
    work->t65 = pendulum_turning_sin_f32(t64);
    const float t66 = state->sin_q[t1];
    const float t67 = work->t65 - t66;
    const float t69 = -1.4524367e-5f * t67;
    const float t70 = t29 + t69;
    const float t71 = t30 + t70;
    const float t72 = t71 * 0.15915494f;
    const float t73 = t72 + 1.2582912e7f;
    const float t74 = t73 - 1.2582912e7f;
    const float t75 = t74 * 6.2831855f;
    const float t76 = t71 - t75;
    const int t77 = (-6.2831855f <= t76) && (t76 <= 6.2831855f);
    const int t78 = work->flags[0] && t77;
    const float t79 = t78 ? t76 : t30;
    const int t80 = work->flags[2] || t78;
    work->flags[4] = !t80;
    work->t82 = work->flags[2] ? t20 : t79;
    const uint32_t t83 = state->since;
    const uint32_t t84 = (t83 < 4294967295U) ? (t83 + 1U) : 4294967295U;
    work->t85 = work->flags[2] ? 0U : t84;
    state->since = work->t85;
}

/* Part 2 of a step. */
static void pendulum_turning_part_2(pendulum_turning_state *state, pendulum_turning_work *work)
{
    /* how much of the window is good */
    const int t86 = !work->flags[3];
    const int t87 = work->flags[0] && t86;
    const int t88 = work->flags[1] && t86;
    const uint32_t t90 = (work->t2 < 31U) ? (work->t2 + 1U) : 31U;
    const uint32_t t91 = work->flags[4] ? 0U : t90;
    const uint32_t t92 = t88 ? t90 : 1U;
    const uint32_t t93 = work->flags[2] ? t92 : 0U;
    work->t94 = t87 ? t91 : t93;
    state->count = work->t94;
    const uint32_t t95 = state->coasting;
    const uint32_t t96 = (t95 > 0U) ? (t95 - 1U) : 0U;
    const uint32_t t97 = work->flags[1] ? t96 : 30U;
    const uint32_t t99 = work->flags[2] ? t97 : 31U;
    state->coasting = t99;

    /* into the window */
    state->newest = work->t25;
    state->y[work->t25] = work->t82;
    state->tau[work->t25] = work->t24;
    state->sin_q[work->t25] = work->t65;
}

/* Part 3 of a step. */
static void pendulum_turning_part_3(const pendulum_turning_state *state, pendulum_turning_work *work)
{
    /* the sums over the window, newest sample first */
    const float t101 = state->tau[work->t25];
    const float t103 = 1.2269121e-5f * t101;
    const float t105 = 0.016169578f * t101;
    const float t107 = -0.0009168296f * t101;
    const float t108 = state->sin_q[work->t25];
    const float t110 = -1.0834635e-5f * t108;
    const float t112 = -0.021542734f * t108;
    const float t114 = 0.0008096354f * t108;
    const uint32_t t115 = ((work->t25 >= 1U) && (work->t25 < 31U)) ? (work->t25 - 1U) : 30U;
    float t116 = 0.0f;
    work->t117 = t103;
    float t118 = t110;
    float t119 = 0.0f;
    work->t120 = t105;
    work->t121 = t112;
    float t122 = 0.0f;
    work->t123 = t107;
    work->t124 = t114;
    uint32_t t125 = t115;
    float t126 = work->t82;
    float t127 = 0.0f;
    for (uint32_t row = 0U; row < 29U; ++row) {
        const float *const gains = PENDULUM_TURNING_WINDOW[row];
        const float t128 = state->y[t125];
        const float t129 = t128 - t126;
        const float t130 = t129 * 0.15915494f;
        const float t131 = t130 + 1.2582912e7f;
        const float t132 = t131 - 1.2582912e7f;
        const float t133 = t132 * 6.2831855f;
        const float t134 = t129 - t133;
        const float t135 = t127 + t134;
        const float t136 = gains[0];
        const float t137 = t136 * t135;
        const float t138 = t116 + t137;
        const float t139 = gains[1];
        const float t140 = t139 * t135;
        const float t141 = t119 + t140;
        const float t142 = gains[2];
        const float t143 = t142 * t135;
        const float t144 = t122 + t143;
        const float t145 = state->tau[t125];
        const float t146 = gains[3];
        const float t147 = t146 * t145;
        const float t148 = work->t117 + t147;
        const float t149 = gains[4];
        const float t150 = t149 * t145;
        const float t151 = work->t120 + t150;
        const float t152 = gains[5];
        const float t153 = t152 * t145;
        const float t154 = work->t123 + t153;
        const float t155 = state->sin_q[t125];
        const float t156 = gains[6];
        const float t157 = t156 * t155;
        const float t158 = t118 + t157;
        const float t159 = gains[7];
        const float t160 = t159 * t155;
        const float t161 = work->t121 + t160;
        const float t162 = gains[8];
        const float t163 = t162 * t155;
        const float t164 = work->t124 + t163;
        const uint32_t t165 = ((t125 >= 1U) && (t125 < 31U)) ? (t125 - 1U) : 30U;
        t116 = t138;
        work->t117 = t148;
        t118 = t158;
        t119 = t141;
        work->t120 = t151;
        work->t121 = t161;
        t122 = t144;
        work->t123 = t154;
        work->t124 = t164;
        t125 = t165;
        t126 = t128;
        t127 = t135;
    }
    const float t166 = state->y[t125];
    const float t167 = t166 - t126;
    const float t168 = t167 * 0.15915494f;
    const float t169 = t168 + 1.2582912e7f;
    const float t170 = t169 - 1.2582912e7f;
    const float t171 = t170 * 6.2831855f;
    const float t172 = t167 - t171;
    const float t173 = t127 + t172;
    const float t175 = 0.07441038f * t173;
    work->t176 = t116 + t175;
    const float t178 = 10.617059f * t173;
    work->t179 = t119 + t178;
    const float t181 = 55.60578f * t173;
    work->t182 = t122 + t181;
    work->t183 = state->sin_q[t125];
    const float t185 = 1.0820987e-6f * work->t183;
    work->t186 = t118 + t185;
}

/* Part 4 of a step. */
static void pendulum_turning_part_4(pendulum_turning_state *state, pendulum_turning_work *work)
{
    const float t188 = 0.00015439655f * work->t183;
    const float t189 = work->t121 + t188;
    const float t191 = 0.0008086364f * work->t183;
    const float t192 = work->t124 + t191;
    const float t193 = work->t176 + work->t117;
    const float t194 = t193 + work->t186;
    const float t195 = work->t179 + work->t120;
    const float t196 = t195 + t189;
    const float t197 = work->t182 + work->t123;
    const float t198 = t197 + t192;

    /* the next measurement, as far as it is known */
    const float t200 = 0.0019975328f * t196;
    const float t201 = 1.6447366e-5f * t198;
    const float t203 = -4.3564138e-5f * work->t65;
    const float t204 = t194 + t200;
    const float t205 = t204 + t201;
    const float t206 = t205 + t203;
    state->ahead_y = t206;

    /* the estimate; until the window is full, the start */
    const float t207 = t194 + work->t82;
    const int t208 = 30U < work->t94;
    work->t209 = t208 ? t207 : work->t82;
    work->t210 = t208 ? t196 : 0.0f;
    work->t211 = t208 ? t198 : 0.0f;
    const uint32_t t212 = state->coasting;
    const int t213 = t212 == 0U;
    const pendulum_turning_status t217 = t213 ? PENDULUM_TURNING_CONVERGED : PENDULUM_TURNING_COASTING;
    work->t218 = t208 ? t217 : PENDULUM_TURNING_CONVERGING;
}

void pendulum_turning_init(pendulum_turning_state *state)
{
    for (uint32_t slot = 0U; slot < 31U; ++slot) {
        state->y[slot] = 0.0f;
    }
    for (uint32_t slot = 0U; slot < 31U; ++slot) {
        state->tau[slot] = 0.0f;
    }
    for (uint32_t slot = 0U; slot < 31U; ++slot) {
        state->sin_q[slot] = 0.0f;
    }
    state->newest = 30U;
    state->count = 0U;
    state->rejected_y = 0U;
    state->coasting = 0U;
    state->ahead_y = 0.0f;
    state->since = 0U;
}

void pendulum_turning_step(pendulum_turning_state *state, const pendulum_turning_measurements *measurements,
                           const pendulum_turning_inputs *inputs, pendulum_turning_estimate *estimate)
{
    pendulum_turning_work work;
    pendulum_turning_part_1(state, measurements, inputs, &work);
    pendulum_turning_part_2(state, &work);
    pendulum_turning_part_3(state, &work);
    pendulum_turning_part_4(state, &work);

    estimate->q = work.t209;
    estimate->dq = work.t210;
    estimate->load = work.t211;
    estimate->coasted = work.t85;
    estimate->status = work.t218;
}
