/* lossy_position.c: Finite-time observer: Cart with a camera that is 40 ms late and loses pictures, and a wheel counter.
 *
 * Generated; lossy_position.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "lossy_position.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "lossy_position.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "lossy_position.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* orthonormal rows of the window, oldest first
 *   [0] camera in direction 1
 *   [1] camera in direction 2
 *   [2] camera in direction 3
 *   [3] camera in direction 4
 *   [4] wheel in direction 1
 *   [5] wheel in direction 2
 *   [6] wheel in direction 3
 *   [7] wheel in direction 4
 */
static const float LOSSY_POSITION_ROWS[40][8] = {
    {
        0.16439898f, -0.10963551f, 0.061747305f, 0.040597763f, 0.0f, 0.046017345f, -0.07894017f,
        0.49602282f
    },
    {
        0.16439898f, -0.10258875f, 0.050287135f, 0.035768975f, 0.0f, 0.079741165f, -0.13261756f,
        0.33621165f
    },
    {
        0.16439898f, -0.09559814f, 0.03956245f, 0.031169508f, 0.0f, 0.10436063f, -0.1676181f,
        0.2193062f
    },
    {
        0.16439898f, -0.08866323f, 0.029567389f, 0.026797527f, 0.0f, 0.12223834f, -0.18882045f,
        0.13417424f
    },
    {
        0.16439898f, -0.08178358f, 0.020296138f, 0.022651225f, 0.0f, 0.13512449f, -0.1998385f,
        0.07256892f
    },
    {
        0.16439898f, -0.07495875f, 0.01174293f, 0.0187288f, 0.0f, 0.14431566f, -0.20334923f,
        0.02838092f
    },
    {
        0.16439898f, -0.068188295f, 0.0039020434f, 0.015028469f, 0.0f, 0.15077236f, -0.20133543f,
        -0.0029155738f
    },
    {
        0.16439898f, -0.06147179f, -0.0032321974f, 0.011548464f, 0.0f, 0.15520611f, -0.19526576f,
        -0.024673268f
    },
    {
        0.16439898f, -0.054808803f, -0.009665423f, 0.0082870275f, 0.0f, 0.15814401f, -0.18622787f,
        -0.039375816f
    },
    {
        0.16439898f, -0.048198905f, -0.0154032195f, 0.0052424194f, 0.0f, 0.15997653f, -0.17502728f,
        -0.048863072f
    },
    {
        0.16439898f, -0.04164168f, -0.020451128f, 0.0024129106f, 0.0f, 0.16099289f, -0.16226041f,
        -0.054497927f
    },
    {
        0.16439898f, -0.0351367f, -0.024814647f, -0.00020321197f, 0.0f, 0.16140735f, -0.14836882f,
        -0.057289965f
    },
    {
        0.16439898f, -0.028683553f, -0.028499225f, -0.0026076487f, 0.0f, 0.1613786f, -0.13367936f,
        -0.057987005f
    },
    {
        0.16439898f, -0.022281826f, -0.03151028f, -0.004802087f, 0.0f, 0.16102421f, -0.11843385f,
        -0.057142958f
    },
    {
        0.16439898f, -0.015931107f, -0.03385317f, -0.006788199f, 0.0f, 0.16043122f, -0.10281118f,
        -0.05516809f
    },
    {
        0.16439898f, -0.009630992f, -0.035533223f, -0.008567645f, 0.0f, 0.1596641f, -0.086943604f,
        -0.052366234f
    },
    {
        0.16439898f, -0.0033810763f, -0.036555722f, -0.010142072f, 0.0f, 0.15877059f, -0.0709288f,
        -0.048962403f
    },
    {
        0.16439898f, 0.0028190392f, -0.036925904f, -0.011513115f, 0.0f, 0.15778604f, -0.054838873f,
        -0.045123205f
    },
    {
        0.16439898f, 0.008969751f, -0.036648966f, -0.012682391f, 0.0f, 0.15673663f, -0.03872697f,
        -0.040971972f
    },
    {
        0.16439898f, 0.015071454f, -0.035730068f, -0.013651512f, 0.0f, 0.15564172f, -0.022632185f,
        -0.036599994f
    },
    {
        0.16439898f, 0.021124538f, -0.034174323f, -0.014422069f, 0.0f, 0.15451561f, -0.0065832213f,
        -0.03207482f
    },
    {
        0.16439898f, 0.027129391f, -0.031986807f, -0.014995647f, 0.0f, 0.15336892f, 0.009398923f,
        -0.027446399f
    },
    {
        0.16439898f, 0.033086397f, -0.029172549f, -0.015373814f, 0.0f, 0.15220946f, 0.025298957f,
        -0.022751663f
    },
    {
        0.16439898f, 0.038995937f, -0.025736548f, -0.015558127f, 0.0f, 0.15104303f, 0.041105807f,
        -0.018017884f
    },
    {
        0.16439898f, 0.04485839f, -0.021683756f, -0.015550132f, 0.0f, 0.14987385f, 0.056811534f,
        -0.013265192f
    },
    {
        0.16439898f, 0.050674126f, -0.01701909f, -0.01535136f, 0.0f, 0.1487051f, 0.07241051f,
        -0.00850841f
    },
    {
        0.16439898f, 0.056443527f, -0.011747422f, -0.014963332f, 0.0f, 0.14753906f, 0.08789881f,
        -0.0037584505f
    },
    {
        0.16439898f, 0.062166955f, -0.0058735902f, -0.0143875545f, 0.0f, 0.14637743f, 0.103273794f,
        0.0009766878f
    },
    {
        0.16439898f, 0.06784478f, 0.0005976063f, -0.013625525f, 0.0f, 0.14522143f, 0.118533745f,
        0.0056911544f
    },
    {
        0.16439898f, 0.07347736f, 0.0076614087f, -0.0126787275f, 0.0f, 0.14407195f, 0.13367765f,
        0.010380693f
    },
    {
        0.16439898f, 0.07906506f, 0.015313095f, -0.011548634f, 0.0f, 0.14292966f, 0.14870499f,
        0.015042226f
    },
    {
        0.16439898f, 0.084608234f, 0.023547981f, -0.010236705f, 0.0f, 0.14179498f, 0.16361561f,
        0.01967355f
    },
    {
        0.16439898f, 0.09010725f, 0.032361418f, -0.008744389f, 0.0f, 0.14066827f, 0.1784097f,
        0.024273112f
    },
    {
        0.16439898f, 0.095562436f, 0.0417488f, -0.007073124f, 0.0f, 0.13954972f, 0.19308756f,
        0.028839828f
    },
    {
        0.16439898f, 0.100974165f, 0.05170555f, -0.005224335f, 0.0f, 0.13843949f, 0.20764971f,
        0.033372976f
    },
    {
        0.16439898f, 0.10634277f, 0.062227134f, -0.0031994374f, 0.0f, 0.13733765f, 0.22209674f,
        0.037872095f
    },
    { 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.13624428f, 0.23642935f, 0.042336907f },
    { 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.13515937f, 0.25064823f, 0.046767294f },
    { 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.13408291f, 0.2647542f, 0.051163226f },
    { 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.13301492f, 0.27874807f, 0.055524763f }
};

/* The bits of a number. */
typedef union {
    float value;
    uint32_t bits;
} lossy_position_f32_cell_t;

/* The bits of a number. */
static uint32_t lossy_position_f32_to_bits(float x)
{
    lossy_position_f32_cell_t cell;
    cell.value = x;
    return cell.bits;
}

/* Bits of the sign, of the largest magnitude, of infinity, of the only NaN returned, of 1. */
#define LOSSY_POSITION_SIGN_F32 UINT32_C(0x80000000)
#define LOSSY_POSITION_MAGNITUDE_F32 UINT32_C(0x7FFFFFFF)
#define LOSSY_POSITION_INFINITY_F32 UINT32_C(0x7F800000)
#define LOSSY_POSITION_NAN_F32 UINT32_C(0x7FC00000)
#define LOSSY_POSITION_ONE_F32 UINT32_C(0x3F800000)

/* The number with these bits. */
static float lossy_position_f32_from_bits(uint32_t bits)
{
    lossy_position_f32_cell_t cell;
    cell.bits = bits;
    return cell.value;
}

/* The number significand / 2^63 * 2^exponent, with the top bit of the significand set. */
typedef struct {
    uint64_t significand;
    int32_t exponent;
} lossy_position_scaled_t;

/* A number below 1 as fixed point with 64 fraction bits. */
static uint64_t lossy_position_fraction(lossy_position_scaled_t a)
{
    const int32_t shift = -1 - a.exponent;
    if (shift > 63) {
        return 0;
    }
    return a.significand >> shift;
}

/* The upper half of the product, at most 2 too small. */
static uint64_t lossy_position_mul_high(uint64_t a, uint64_t b)
{
    const uint64_t a_high = a >> 32;
    const uint64_t a_low = a & 0xFFFFFFFFu;
    const uint64_t b_high = b >> 32;
    const uint64_t b_low = b & 0xFFFFFFFFu;
    const uint64_t cross = ((a_high * b_low) >> 32) + ((a_low * b_high) >> 32);
    return a_high * b_high + cross;
}

/* The square of a number below 1 as fixed point with 64 fraction bits. */
static uint64_t lossy_position_squared_fraction(lossy_position_scaled_t a)
{
    const uint64_t x = lossy_position_fraction(a);
    return lossy_position_mul_high(x, x);
}

/* Makes a number of a significand that has its top bit set. */
static lossy_position_scaled_t lossy_position_scaled(uint64_t significand, int32_t exponent)
{
    lossy_position_scaled_t result;
    result.significand = significand;
    result.exponent = exponent;
    return result;
}

/* Makes a number of a significand of at least 2^62. */
static lossy_position_scaled_t lossy_position_settled(uint64_t significand, int32_t exponent)
{
    if ((significand >> 63) == 0) {
        return lossy_position_scaled(significand << 1, exponent - 1);
    }
    return lossy_position_scaled(significand, exponent);
}

/* The number of zero bits above the highest one bit; x is not 0. */
static int32_t lossy_position_leading_zeros(uint64_t x)
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
static lossy_position_scaled_t lossy_position_normalised(uint64_t significand, int32_t exponent)
{
    const int32_t shift = lossy_position_leading_zeros(significand);
    return lossy_position_scaled(significand << shift, exponent - shift);
}

/* The finite positive number with these bits, not 0; exact. */
static lossy_position_scaled_t lossy_position_unpacked_f32(uint32_t magnitude)
{
    const int32_t field = (int32_t)(magnitude >> 23);
    const uint64_t digits = (uint64_t)magnitude << 40;
    if (field == 0) {
        return lossy_position_normalised(digits, -126);
    }
    return lossy_position_scaled(digits | (UINT64_C(1) << 63), field - 127);
}

/* a b, relative error below 2^-60. */
static lossy_position_scaled_t lossy_position_product(lossy_position_scaled_t a, lossy_position_scaled_t b)
{
    return lossy_position_settled(lossy_position_mul_high(a.significand, b.significand),
                            a.exponent + b.exponent + 1);
}

/* x rounded to the nearest, ties to even, with subnormals and overflow, and the sign put in. */
static float lossy_position_rounded_f32(uint32_t sign, lossy_position_scaled_t x)
{
    const int32_t field = x.exponent + 127;
    if (field >= 255) {
        return lossy_position_f32_from_bits(sign | LOSSY_POSITION_INFINITY_F32);
    }
    const int32_t shift = (field > 0) ? 40 : 41 - field;
    if (shift > 63) {
        const int least = shift == 64 && x.significand > (UINT64_C(1) << 63);
        return lossy_position_f32_from_bits(least ? sign + 1 : sign);
    }
    const uint64_t kept = x.significand >> shift;
    const uint64_t rest = x.significand - (kept << shift);
    const uint64_t half = UINT64_C(1) << (shift - 1);
    const uint64_t odd = kept & 1;
    const uint64_t up = (rest + odd > half) ? 1 : 0;
    const uint32_t base = (field > 0) ? ((uint32_t)(field - 1)) << 23 : 0;
    return lossy_position_f32_from_bits(sign | (base + ((uint32_t)(kept + up))));
}

/* 2^126 / d for d >= 2^63, off by less than 2^-61 of itself.
   
   A 16-bit quotient, one Newton step to 28 bits, one step of third order. */
static uint64_t lossy_position_reciprocal(uint64_t d)
{
    const uint64_t d_high = d >> 32;
    const uint64_t d_low = d & 0xFFFFFFFFu;
    const uint32_t top = (uint32_t)(d >> 48);
    const uint64_t guess = (uint64_t)(UINT32_C(0xFFFFFFFF) / (top + 1));
    const uint64_t gap = ((UINT64_C(1) << 48) - (d_high + 1) * guess) >> 2;
    const uint64_t second = (guess << 15) + ((guess * gap) >> 31);
    const uint64_t covered = d_high * second + ((d_low * second) >> 32);
    const uint64_t rest = (UINT64_C(1) << 63) - covered;
    const uint64_t brief = rest >> 3;
    const uint64_t series = (rest << 29) + ((brief * brief) >> 28);
    return (second << 31) + (lossy_position_mul_high(series, second << 32) >> 29);
}

/* a / b, relative error below 2^-59. */
static lossy_position_scaled_t lossy_position_quotient(lossy_position_scaled_t a, lossy_position_scaled_t b)
{
    const uint64_t high = lossy_position_mul_high(a.significand, lossy_position_reciprocal(b.significand));
    return lossy_position_normalised(high, a.exponent - b.exponent + 1);
}

/* 1 / log(2) with 127 fraction bits. */
#define LOSSY_POSITION_LOG2_E UINT64_C(0xB8AA3B295C17F0BB)
#define LOSSY_POSITION_LOG2_E_LOW UINT64_C(0xBE87FED0691D3E88)

/* (2^g - 1) / g for 0 <= g < 1/16. */
static const uint64_t LOSSY_POSITION_EXP2[7] = {
    UINT64_C(0xB17217F7D1CF7AA4), UINT64_C(0x3D7F7BFF05899176), UINT64_C(0x0E35846B8325C9E5),
    UINT64_C(0x0276556DC0C05222), UINT64_C(0x005762071187A944), UINT64_C(0x000A17B98000087C),
    UINT64_C(0x00010573837C79AD)};

/* 2^(k/16) with 63 fraction bits. */
static const uint64_t LOSSY_POSITION_EXP2_TABLE[16] = {
    UINT64_C(0x8000000000000000), UINT64_C(0x85AAC367CC487B15), UINT64_C(0x8B95C1E3EA8BD6E7),
    UINT64_C(0x91C3D373AB11C336), UINT64_C(0x9837F0518DB8A96F), UINT64_C(0x9EF5326091A111AE),
    UINT64_C(0xA5FED6A9B15138EA), UINT64_C(0xAD583EEA42A14AC6), UINT64_C(0xB504F333F9DE6484),
    UINT64_C(0xBD08A39F580C36BF), UINT64_C(0xC5672A115506DADD), UINT64_C(0xCE248C151F8480E4),
    UINT64_C(0xD744FCCAD69D6AF4), UINT64_C(0xE0CCDEEC2A94E111), UINT64_C(0xEAC0C6E7DD24392F),
    UINT64_C(0xF5257D152486CC2C)};

/* 2^f for f < 1 with 64 fraction bits, as a significand, relative error below 2^-60. */
static uint64_t lossy_position_exp2_fraction(uint64_t f)
{
    const uint64_t slot = f >> 60;
    const uint64_t g = f & UINT64_C(0x0FFFFFFFFFFFFFFF);
    const uint64_t c5 = LOSSY_POSITION_EXP2[5] + lossy_position_mul_high(LOSSY_POSITION_EXP2[6], g);
    const uint64_t c4 = LOSSY_POSITION_EXP2[4] + lossy_position_mul_high(c5, g);
    const uint64_t c3 = LOSSY_POSITION_EXP2[3] + lossy_position_mul_high(c4, g);
    const uint64_t c2 = LOSSY_POSITION_EXP2[2] + lossy_position_mul_high(c3, g);
    const uint64_t c1 = LOSSY_POSITION_EXP2[1] + lossy_position_mul_high(c2, g);
    const uint64_t c0 = LOSSY_POSITION_EXP2[0] + lossy_position_mul_high(c1, g);
    const uint64_t base = LOSSY_POSITION_EXP2_TABLE[slot];
    return base + lossy_position_mul_high(base, lossy_position_mul_high(c0, g));
}

/* 2^p or 2^-p for p = (high, low) / 2^127 * 2^exponent, -64 <= exponent <= 10, high's top bit set. */
static lossy_position_scaled_t lossy_position_exp2(int negative, uint64_t high, uint64_t low, int32_t exponent)
{
    int32_t whole = 0;
    uint64_t part = high;
    if (exponent >= 0) {
        whole = (int32_t)(high >> (63 - exponent));
        part = (high << (exponent + 1)) | (low >> (63 - exponent));
    } else {
        part >>= -1 - exponent;
    }
    if (negative) {
        whole = (part == 0) ? -whole : -1 - whole;
        part = (UINT64_C(0) - part);
    }
    return lossy_position_scaled(lossy_position_exp2_fraction(part), whole);
}

/* (1 - tanh(x) / x) / x^2 in powers of -x^2, for x < 1/8. */
static const uint64_t LOSSY_POSITION_TANH[6] = {
    UINT64_C(0x55555555555548FD), UINT64_C(0x2222222221E6138E), UINT64_C(0x0DD0DD0D6F8E83BF),
    UINT64_C(0x05993CD988124FEC), UINT64_C(0x0244C11366A29CD2), UINT64_C(0x00E654D08BABB967)};

/* tanh(x) for 0 < x < 1/8, relative error below 2^-60. */
static lossy_position_scaled_t lossy_position_small_tanh(lossy_position_scaled_t x)
{
    const uint64_t z = lossy_position_squared_fraction(x);
    const uint64_t c4 = LOSSY_POSITION_TANH[4] - lossy_position_mul_high(LOSSY_POSITION_TANH[5], z);
    const uint64_t c3 = LOSSY_POSITION_TANH[3] - lossy_position_mul_high(c4, z);
    const uint64_t c2 = LOSSY_POSITION_TANH[2] - lossy_position_mul_high(c3, z);
    const uint64_t c1 = LOSSY_POSITION_TANH[1] - lossy_position_mul_high(c2, z);
    const uint64_t c0 = LOSSY_POSITION_TANH[0] - lossy_position_mul_high(c1, z);
    const uint64_t lost = lossy_position_mul_high(x.significand, lossy_position_mul_high(c0, z));
    return lossy_position_settled(x.significand - lost, x.exponent);
}

/* tanh(x) = (1 - q) / (1 + q) with q = exp(-2 x), for 0 < x < 32, relative error below 2^-58. */
static lossy_position_scaled_t lossy_position_tanh(lossy_position_scaled_t x)
{
    if (x.exponent < -3) {
        return lossy_position_small_tanh(x);
    }
    const lossy_position_scaled_t power = lossy_position_product(x, lossy_position_scaled(LOSSY_POSITION_LOG2_E, 1));
    const uint64_t q = lossy_position_fraction(lossy_position_exp2(1, power.significand, 0, power.exponent));
    if (q == 0) {
        return lossy_position_scaled(UINT64_C(1) << 63, 0);
    }
    const lossy_position_scaled_t less = lossy_position_normalised((UINT64_C(0) - q), -1);
    return lossy_position_quotient(less, lossy_position_scaled((UINT64_C(1) << 63) + (q >> 1), 0));
}

/* Hyperbolic tangent, the nearest float. */
static float lossy_position_tanh_f32(float x)
{
    const uint32_t bits = lossy_position_f32_to_bits(x);
    const uint32_t magnitude = bits & LOSSY_POSITION_MAGNITUDE_F32;
    const uint32_t sign = bits & LOSSY_POSITION_SIGN_F32;
    if (magnitude > LOSSY_POSITION_INFINITY_F32) {
        return lossy_position_f32_from_bits(LOSSY_POSITION_NAN_F32);
    }
    if (magnitude == 0) {
        return x;
    }
    if (magnitude >= 0x42000000u) {
        return lossy_position_f32_from_bits(sign | LOSSY_POSITION_ONE_F32);
    }
    return lossy_position_rounded_f32(sign, lossy_position_tanh(lossy_position_unpacked_f32(magnitude)));
}

/* What one part of a step hands to the next. */
typedef struct {
    float t9;
    uint32_t t10;
    float t20;
    uint32_t t32;
    float t34;
    float t43;
    float t44;
    uint32_t t45;
    float t48;
    float t51;
    float t54;
    float t57;
    float t61;
    uint32_t t94;
    float t145;
    float t146;
    float t147;
    float t149;
    float t150;
    float t151;
    float t152;
    float t153;
    float t154;
    float t156;
    float t158;
    float t159;
    float t160;
    float t162;
    float t163;
    float t164;
    float t165;
    float t166;
    float t167;
    float t168;
    float t169;
    float t170;
    float t171;
    float t172;
    float t173;
    float t174;
    float t175;
    float t176;
    float t177;
    float t178;
    float t179;
    float t180;
    uint32_t t181;
    uint32_t t182;
    float t198;
    float t209;
    float t224;
    float t246;
    float t248;
    float t250;
    float t252;
    float t254;
    float t256;
    float t258;
    float t260;
    float t262;
    float t264;
    float t266;
    float t268;
    float t272;
    float t273;
    float t274;
    float t275;
    float t276;
    float t278;
    float t280;
    float t282;
    float t284;
    float t286;
    float t288;
    float t290;
    float t292;
    float t294;
    float t296;
    float t298;
    float t300;
    float t302;
    float t304;
    float t305;
    float t383;
    float t392;
    float t398;
    float t407;
    float t458;
    float t459;
    float t460;
    float t461;
    lossy_position_status t469;
    int flags[6]; /* t5, t7, t39, t82, t93, t354 */
} lossy_position_work;

/* Part 1 of a step. */
static void lossy_position_part_1(lossy_position_state *state, const lossy_position_measurements *measurements, const lossy_position_inputs *inputs, lossy_position_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    const uint32_t t0 = state->newest;
    const uint32_t t1 = (t0 < 40U) ? t0 : 40U;
    const float t2 = measurements->camera;
    const int t3 = (-1e25f <= t2) && (t2 <= 1e25f);
    const float t4 = measurements->wheel;
    work->flags[0] = (-20.0f <= t4) && (t4 <= 20.0f);
    const float t6 = inputs->force;
    work->flags[1] = (-1e25f <= t6) && (t6 <= 1e25f);
    const float t8 = state->force[t1];
    work->t9 = work->flags[1] ? t6 : t8;
    work->t10 = (t1 < 40U) ? (t1 + 1U) : 0U;

    /* prediction, for nonlinear terms of a sample that is missing */
    const float t11 = state->tanh_20_wheel[t1];
    const float t12 = state->next_position;
    const float t14 = 1.9946774e-5f * work->t9;
    const float t16 = state->next_speed;
    const float t18 = 0.0039840424f * work->t9;
    work->t20 = state->next_slope;
    const float t21 = state->next_wheel;
    const float t23 = 0.0005427591f * work->t9;
    const float t25 = -0.00018548031f * t11;
    const float t26 = t23 + t25;
    const float t27 = t21 + t26;
    const uint32_t t30 = state->slot_camera;
    const uint32_t t31 = (t30 < 40U) ? t30 : 40U;
    work->t32 = (t31 < 40U) ? (t31 + 1U) : 0U;
    state->slot_camera = work->t32;
    const float t33 = state->camera[work->t32];
    work->t34 = t3 ? t2 : t33;
    const float t35 = state->wheel[t1];
    const int t36 = (-20.0f <= t27) && (t27 <= 20.0f);
    const uint32_t t37 = state->known;
    work->flags[2] = t37 == 1U;
    const int t40 = work->flags[2] && t36;
    const float t41 = t40 ? t27 : t35;
    const float t42 = work->flags[0] ? t4 : t41;
    work->t43 = t3 ? 1.0f : 0.0f;
    work->t44 = work->flags[0] ? 1.0f : 0.0f;
    work->t45 = state->count;
    const float t47 = 20.0f * t42;
    work->t48 = lossy_position_tanh_f32(t47);
    const float t49 = -6.653355e-6f * work->t48;
    const float t50 = t14 + t49;
    work->t51 = t12 + t50;
    const float t52 = -0.0019946774f * work->t48;
    const float t53 = t18 + t52;
    work->t54 = t16 + t53;
    const float t55 = -0.00018548031f * work->t48;
    const float t56 = t23 + t55;
    work->t57 = t21 + t56;
    const int t58 = (-20.0f <= work->t57) && (work->t57 <= 20.0f);
    const int t59 = work->flags[2] && t58;
    const float t60 = t59 ? work->t57 : t42;
    work->t61 = work->flags[0] ? t4 : t60;
    const int t62 = !work->flags[0];
    const int t63 = !t58;
    const int t64 = work->flags[2] && t63;
    const int t65 = t62 && t64;
    const uint32_t t66 = state->missed_camera;
    const int t68 = 40U < t66;
    const int t69 = !t3;
    const int t70 = t69 && t68;
    const uint32_t t72 = (t66 < 41U) ? (t66 + 1U) : 41U;
    const uint32_t t73 = t3 ? 0U : t72;
    state->missed_camera = t73;
    const uint32_t t74 = state->missed_wheel;
    const int t75 = 40U < t74;
    const int t76 = t62 && t75;
    const uint32_t t77 = (t74 < 41U) ? (t74 + 1U) : 41U;
    const uint32_t t78 = work->flags[0] ? 0U : t77;
    state->missed_wheel = t78;
    const int t79 = t70 && t76;
    const int t80 = !t79;
    const int t81 = t76 && t80;
    work->flags[3] = t65 || t81;
}

/* Part 2 of a step. */
static void lossy_position_part_2(lossy_position_state *state, lossy_position_work *work)
{
    /* how much of the window is good */
    const int t83 = 40U < work->t45;
    const uint32_t t84 = (work->t45 < 44U) ? (work->t45 + 1U) : 44U;
    const uint32_t t85 = work->flags[3] ? 0U : t84;
    const uint32_t t86 = work->flags[1] ? t84 : 1U;
    const uint32_t t87 = t83 ? t85 : t86;
    state->count = t87;
    const uint32_t t88 = state->coasting;
    const uint32_t t89 = (t88 > 0U) ? (t88 - 1U) : 0U;
    const uint32_t t90 = work->flags[1] ? t89 : 40U;
    const uint32_t t92 = work->flags[0] ? t90 : 41U;
    state->coasting = t92;

    /* into the window */
    state->newest = work->t10;
    state->camera[work->t32] = work->t34;
    state->wheel[work->t10] = work->t61;
    state->has_camera[work->t10] = 0.0f;
    state->has_camera[work->t32] = work->t43;
    state->has_wheel[work->t10] = work->t44;
    state->force[work->t10] = work->t9;
    state->tanh_20_wheel[work->t10] = work->t48;
    work->flags[4] = 40U < t87;
}

/* Part 3 of a step. */
static void lossy_position_part_3(const lossy_position_state *state, lossy_position_work *work)
{
    /* rows of the window, oldest first; those without a sample count nothing */
    work->t94 = (work->t10 < 40U) ? (work->t10 + 1U) : 0U;
    const float t100 = state->has_camera[work->t94];
    const float t101 = state->camera[work->t94];
    const float t102 = t101 - 0.0f;
    const float t104 = 200.0f * t102;
    const float t105 = t100 * 0.16439898f;
    const float t106 = t100 * -0.11673887f;
    const float t107 = t100 * 0.07394887f;
    const float t108 = t100 * 0.045657706f;
    const float t109 = t105 * t105;
    const float t110 = 0.0f + t109;
    const float t111 = t105 * t106;
    const float t112 = 0.0f + t111;
    const float t113 = t105 * t107;
    const float t114 = 0.0f + t113;
    const float t115 = t105 * t108;
    const float t116 = 0.0f + t115;
    const float t117 = t106 * t106;
    const float t118 = 0.0f + t117;
    const float t119 = t106 * t107;
    const float t120 = 0.0f + t119;
    const float t121 = t106 * t108;
    const float t122 = 0.0f + t121;
    const float t123 = t107 * t107;
    const float t124 = 0.0f + t123;
    const float t125 = t107 * t108;
    const float t126 = 0.0f + t125;
    const float t127 = t108 * t108;
    const float t128 = 0.0f + t127;
    const float t129 = t105 * t104;
    const float t130 = 0.0f + t129;
    const float t131 = t106 * t104;
    const float t132 = 0.0f + t131;
    const float t133 = t107 * t104;
    const float t134 = 0.0f + t133;
    const float t135 = t108 * t104;
    const float t136 = 0.0f + t135;
    const float t137 = state->has_wheel[work->t94];
    const float t138 = state->wheel[work->t94];
    const float t139 = t138 - 0.0f;
    const float t141 = 50.0f * t139;
    const float t142 = t137 * 0.0f;
    const float t143 = t137 * 0.71376675f;
    const float t144 = t142 * t142;
    work->t145 = t110 + t144;
    work->t146 = t112 + t144;
    work->t147 = t114 + t144;
    const float t148 = t142 * t143;
    work->t149 = t116 + t148;
    work->t150 = t118 + t144;
    work->t151 = t120 + t144;
    work->t152 = t122 + t148;
    work->t153 = t124 + t144;
    work->t154 = t126 + t148;
    const float t155 = t143 * t143;
    work->t156 = t128 + t155;
    const float t157 = t142 * t141;
    work->t158 = t130 + t157;
    work->t159 = t132 + t157;
    work->t160 = t134 + t157;
    const float t161 = t143 * t141;
    work->t162 = t136 + t161;
}

/* Part 4 of a step, for one row of LOSSY_POSITION_ROWS. */
static void lossy_position_part_4(const lossy_position_state *state, lossy_position_work *work, const float *gains)
{
    work->t182 = (work->t181 < 40U) ? (work->t181 + 1U) : 0U;
    const float t183 = state->tanh_20_wheel[work->t181];
    const float t184 = state->force[work->t182];
    const float t185 = state->tanh_20_wheel[work->t182];
    const float t187 = 0.009960107f * work->t178;
    const float t189 = 4.9866932e-5f * work->t179;
    const float t190 = work->t177 + t187;
    const float t191 = t190 + t189;
    const float t193 = -1.3293418e-5f * t183;
    const float t194 = 1.9946774e-5f * t184;
    const float t195 = -6.653355e-6f * t185;
    const float t196 = t194 + t195;
    const float t197 = t191 + t193;
    work->t198 = t197 + t196;
    const float t200 = 0.99203193f * work->t178;
    const float t201 = 0.009960107f * work->t179;
    const float t202 = t200 + t201;
    const float t204 = -0.0019893653f * t183;
    const float t205 = 0.0039840424f * t184;
    const float t206 = -0.0019946774f * t185;
    const float t207 = t205 + t206;
    const float t208 = t202 + t204;
    work->t209 = t208 + t207;
    const float t211 = 0.25809625f * work->t178;
    const float t213 = 0.0013568978f * work->t179;
    const float t215 = 0.7408182f * work->t180;
    const float t216 = t211 + t213;
    const float t217 = t216 + t215;
    const float t219 = -0.0003572788f * t183;
    const float t220 = 0.0005427591f * t184;
    const float t221 = -0.00018548031f * t185;
    const float t222 = t220 + t221;
    const float t223 = t217 + t219;
    work->t224 = t223 + t222;
    const float t225 = gains[0];
    const float t226 = gains[1];
    const float t227 = gains[2];
    const float t228 = gains[3];
    const float t229 = gains[4];
    const float t230 = gains[5];
    const float t231 = gains[6];
    const float t232 = gains[7];
    const float t233 = state->has_camera[work->t182];
    const float t234 = state->camera[work->t182];
    const float t235 = t234 - work->t198;
    const float t236 = 200.0f * t235;
    const float t237 = t233 * t225;
    const float t238 = t233 * t226;
    const float t239 = t233 * t227;
    const float t240 = t233 * t228;
    const float t241 = t237 * t237;
    const float t242 = work->t163 + t241;
    const float t243 = t237 * t238;
    const float t244 = work->t164 + t243;
    const float t245 = t237 * t239;
    work->t246 = work->t165 + t245;
    const float t247 = t237 * t240;
    work->t248 = work->t166 + t247;
    const float t249 = t238 * t238;
    work->t250 = work->t167 + t249;
    const float t251 = t238 * t239;
    work->t252 = work->t168 + t251;
    const float t253 = t238 * t240;
    work->t254 = work->t169 + t253;
    const float t255 = t239 * t239;
    work->t256 = work->t170 + t255;
    const float t257 = t239 * t240;
    work->t258 = work->t171 + t257;
    const float t259 = t240 * t240;
    work->t260 = work->t172 + t259;
    const float t261 = t237 * t236;
    work->t262 = work->t173 + t261;
    const float t263 = t238 * t236;
    work->t264 = work->t174 + t263;
    const float t265 = t239 * t236;
    work->t266 = work->t175 + t265;
    const float t267 = t240 * t236;
    work->t268 = work->t176 + t267;
    const float t269 = state->has_wheel[work->t182];
    const float t270 = state->wheel[work->t182];
    const float t271 = t270 - work->t224;
    work->t272 = 50.0f * t271;
    work->t273 = t269 * t229;
    work->t274 = t269 * t230;
    work->t275 = t269 * t231;
    work->t276 = t269 * t232;
    const float t277 = work->t273 * work->t273;
    work->t278 = t242 + t277;
    const float t279 = work->t273 * work->t274;
    work->t280 = t244 + t279;
}

/* Part 5 of a step, for one row of LOSSY_POSITION_ROWS. */
static void lossy_position_part_5(lossy_position_work *work)
{
    const float t281 = work->t273 * work->t275;
    work->t282 = work->t246 + t281;
    const float t283 = work->t273 * work->t276;
    work->t284 = work->t248 + t283;
    const float t285 = work->t274 * work->t274;
    work->t286 = work->t250 + t285;
    const float t287 = work->t274 * work->t275;
    work->t288 = work->t252 + t287;
    const float t289 = work->t274 * work->t276;
    work->t290 = work->t254 + t289;
    const float t291 = work->t275 * work->t275;
    work->t292 = work->t256 + t291;
    const float t293 = work->t275 * work->t276;
    work->t294 = work->t258 + t293;
    const float t295 = work->t276 * work->t276;
    work->t296 = work->t260 + t295;
    const float t297 = work->t273 * work->t272;
    work->t298 = work->t262 + t297;
    const float t299 = work->t274 * work->t272;
    work->t300 = work->t264 + t299;
    const float t301 = work->t275 * work->t272;
    work->t302 = work->t266 + t301;
    const float t303 = work->t276 * work->t272;
    work->t304 = work->t268 + t303;
    work->t305 = work->t179 - 0.0f;
}

/* Part 6 of a step. */
static void lossy_position_part_6(const lossy_position_state *state, lossy_position_work *work)
{
    work->t163 = work->t145;
    work->t164 = work->t146;
    work->t165 = work->t147;
    work->t166 = work->t149;
    work->t167 = work->t150;
    work->t168 = work->t151;
    work->t169 = work->t152;
    work->t170 = work->t153;
    work->t171 = work->t154;
    work->t172 = work->t156;
    work->t173 = work->t158;
    work->t174 = work->t159;
    work->t175 = work->t160;
    work->t176 = work->t162;
    work->t177 = 0.0f;
    work->t178 = 0.0f;
    work->t179 = 0.0f;
    work->t180 = 0.0f;
    work->t181 = work->t94;
    for (uint32_t row = 0U; row < 40U; ++row) {
        const float *const gains = LOSSY_POSITION_ROWS[row];
        lossy_position_part_4(state, work, gains);
        lossy_position_part_5(work);
        work->t163 = work->t278;
        work->t164 = work->t280;
        work->t165 = work->t282;
        work->t166 = work->t284;
        work->t167 = work->t286;
        work->t168 = work->t288;
        work->t169 = work->t290;
        work->t170 = work->t292;
        work->t171 = work->t294;
        work->t172 = work->t296;
        work->t173 = work->t298;
        work->t174 = work->t300;
        work->t175 = work->t302;
        work->t176 = work->t304;
        work->t177 = work->t198;
        work->t178 = work->t209;
        work->t179 = work->t305;
        work->t180 = work->t224;
        work->t181 = work->t182;
    }
}

/* Part 7 of a step. */
static void lossy_position_part_7(lossy_position_work *work)
{
    /* the window's start from the samples that are there */
    const int t307 = 0.015625f < work->t163;
    const float t308 = t307 ? work->t163 : 1.0f;
    const float t309 = work->t164 / t308;
    const float t310 = t309 * work->t164;
    const float t311 = work->t167 - t310;
    const float t312 = t309 * work->t165;
    const float t313 = work->t168 - t312;
    const float t314 = t309 * work->t166;
    const float t315 = work->t169 - t314;
    const float t316 = t309 * work->t173;
    const float t317 = work->t174 - t316;
    const float t318 = work->t165 / t308;
    const float t319 = t318 * work->t165;
    const float t320 = work->t170 - t319;
    const float t321 = t318 * work->t166;
    const float t322 = work->t171 - t321;
    const float t323 = t318 * work->t173;
    const float t324 = work->t175 - t323;
    const float t325 = work->t166 / t308;
    const float t326 = t325 * work->t166;
    const float t327 = work->t172 - t326;
    const float t328 = t325 * work->t173;
    const float t329 = work->t176 - t328;
    const int t330 = 0.015625f < t311;
    const int t331 = t307 && t330;
    const float t332 = t330 ? t311 : 1.0f;
    const float t333 = t313 / t332;
    const float t334 = t333 * t313;
    const float t335 = t320 - t334;
    const float t336 = t333 * t315;
    const float t337 = t322 - t336;
    const float t338 = t333 * t317;
    const float t339 = t324 - t338;
    const float t340 = t315 / t332;
    const float t341 = t340 * t315;
    const float t342 = t327 - t341;
    const float t343 = t340 * t317;
    const float t344 = t329 - t343;
    const int t345 = 0.015625f < t335;
    const int t346 = t331 && t345;
    const float t347 = t345 ? t335 : 1.0f;
    const float t348 = t337 / t347;
    const float t349 = t348 * t337;
    const float t350 = t342 - t349;
    const float t351 = t348 * t339;
    const float t352 = t344 - t351;
    const int t353 = 0.015625f < t350;
    work->flags[5] = t346 && t353;
    const float t355 = t353 ? t350 : 1.0f;
    const float t356 = t352 / t355;
    const float t357 = t337 * t356;
    const float t358 = t339 - t357;
    const float t359 = t358 / t347;
    const float t360 = t313 * t359;
    const float t361 = t317 - t360;
    const float t362 = t315 * t356;
    const float t363 = t361 - t362;
    const float t364 = t363 / t332;
    const float t365 = work->t164 * t364;
    const float t366 = work->t173 - t365;
    const float t367 = work->t165 * t359;
    const float t368 = t366 - t367;
    const float t369 = work->t166 * t356;
    const float t370 = t368 - t369;
    const float t371 = t370 / t308;
    const float t373 = 0.0008219949f * t371;
    const float t375 = 0.00063696405f * t364;
    const float t377 = 0.0005493616f * t359;
    const float t379 = 3.3166725e-5f * t356;
    const float t380 = t373 + t375;
    const float t381 = t380 + t377;
    const float t382 = t381 + t379;
    work->t383 = t382 + work->t177;
    const float t385 = 0.002589379f * t364;
    const float t387 = 0.006504165f * t359;
    const float t389 = 0.0014001199f * t356;
    const float t390 = t385 + t387;
    const float t391 = t390 + t389;
    work->t392 = t391 + work->t178;
    const float t394 = 0.032337446f * t359;
    const float t396 = 0.009580231f * t356;
    const float t397 = t394 + t396;
    work->t398 = t397 + work->t179;
    const float t400 = 0.0026602983f * t364;
    const float t402 = 0.005574961f * t359;
    const float t404 = 0.0011104953f * t356;
    const float t405 = t400 + t402;
    const float t406 = t405 + t404;
    work->t407 = t406 + work->t180;
}

/* Part 8 of a step. */
static void lossy_position_part_8(lossy_position_state *state, lossy_position_work *work)
{
    /* without enough samples, the model's prediction */
    const int t408 = (-1e25f <= work->t51) && (work->t51 <= 1e25f);
    const int t409 = work->flags[2] && t408;
    const float t410 = work->flags[5] ? work->t383 : work->t51;
    const int t411 = (-1e25f <= work->t54) && (work->t54 <= 1e25f);
    const int t412 = t409 && t411;
    const float t413 = work->flags[5] ? work->t392 : work->t54;
    const int t414 = (-1e25f <= work->t20) && (work->t20 <= 1e25f);
    const int t415 = t412 && t414;
    const float t416 = work->flags[5] ? work->t398 : work->t20;
    const int t417 = (-1e25f <= work->t57) && (work->t57 <= 1e25f);
    const int t418 = t415 && t417;
    const float t419 = work->flags[5] ? work->t407 : work->t57;
    const int t420 = work->flags[5] || t418;
    const int t421 = work->flags[4] && t420;
    const uint32_t t422 = t421 ? 1U : 0U;
    state->known = t422;
    const float t424 = 0.009960107f * t413;
    const float t426 = 4.9866932e-5f * t416;
    const float t427 = t410 + t424;
    const float t428 = t427 + t426;
    const float t430 = -1.3293418e-5f * work->t48;
    const float t431 = t428 + t430;
    const int t432 = (-1e25f <= t431) && (t431 <= 1e25f);
    const float t433 = t432 ? t431 : 0.0f;
    state->next_position = t433;
    const float t435 = 0.99203193f * t413;
    const float t436 = 0.009960107f * t416;
    const float t437 = t435 + t436;
    const float t439 = -0.0019893653f * work->t48;
    const float t440 = t437 + t439;
    const int t441 = (-1e25f <= t440) && (t440 <= 1e25f);
    const float t442 = t441 ? t440 : 0.0f;
    state->next_speed = t442;
    const int t443 = (-1e25f <= t416) && (t416 <= 1e25f);
    const float t444 = t443 ? t416 : 0.0f;
    state->next_slope = t444;
    const float t446 = 0.25809625f * t413;
    const float t448 = 0.0013568978f * t416;
    const float t450 = 0.7408182f * t419;
    const float t451 = t446 + t448;
    const float t452 = t451 + t450;
    const float t454 = -0.0003572788f * work->t48;
    const float t455 = t452 + t454;
    const int t456 = (-1e25f <= t455) && (t455 <= 1e25f);
    const float t457 = t456 ? t455 : 0.0f;
    state->next_wheel = t457;

    /* the estimate; until there is one, the start */
    work->t458 = t421 ? t410 : 0.0f;
    work->t459 = t421 ? t413 : 0.0f;
    work->t460 = t421 ? t416 : 0.0f;
    work->t461 = t421 ? t419 : work->t61;
    const uint32_t t462 = state->coasting;
    const int t463 = t462 == 0U;
    const int t464 = work->flags[5] && t463;
    const lossy_position_status t468 = t464 ? LOSSY_POSITION_CONVERGED : LOSSY_POSITION_COASTING;
    work->t469 = t421 ? t468 : LOSSY_POSITION_CONVERGING;
}

void lossy_position_init(lossy_position_state *state)
{
    for (uint32_t slot = 0U; slot < 41U; ++slot) {
        state->camera[slot] = 0.0f;
    }
    for (uint32_t slot = 0U; slot < 41U; ++slot) {
        state->wheel[slot] = 0.0f;
    }
    for (uint32_t slot = 0U; slot < 41U; ++slot) {
        state->force[slot] = 0.0f;
    }
    for (uint32_t slot = 0U; slot < 41U; ++slot) {
        state->tanh_20_wheel[slot] = 0.0f;
    }
    state->newest = 40U;
    state->count = 0U;
    state->missed_camera = 0U;
    state->missed_wheel = 0U;
    state->coasting = 0U;
    for (uint32_t slot = 0U; slot < 41U; ++slot) {
        state->has_camera[slot] = 0.0f;
    }
    for (uint32_t slot = 0U; slot < 41U; ++slot) {
        state->has_wheel[slot] = 0.0f;
    }
    state->next_position = 0.0f;
    state->next_speed = 0.0f;
    state->next_slope = 0.0f;
    state->next_wheel = 0.0f;
    state->known = 0U;
    state->slot_camera = 36U;
}

void lossy_position_step(lossy_position_state *state, const lossy_position_measurements *measurements,
                         const lossy_position_inputs *inputs, lossy_position_estimate *estimate)
{
    lossy_position_work work;
    lossy_position_part_1(state, measurements, inputs, &work);
    lossy_position_part_2(state, &work);
    lossy_position_part_3(state, &work);
    lossy_position_part_6(state, &work);
    lossy_position_part_7(&work);
    lossy_position_part_8(state, &work);

    estimate->position = work.t458;
    estimate->speed = work.t459;
    estimate->slope = work.t460;
    estimate->wheel = work.t461;
    estimate->status = work.t469;
}
