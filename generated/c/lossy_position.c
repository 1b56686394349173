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
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
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

/* The bit of the sign. */
#define LOSSY_POSITION_SIGN_F32 UINT32_C(0x80000000)

/* The bits of the largest magnitude. */
#define LOSSY_POSITION_MAGNITUDE_F32 UINT32_C(0x7FFFFFFF)

/* The bits of infinity. */
#define LOSSY_POSITION_INFINITY_F32 UINT32_C(0x7F800000)

/* The bits of the only NaN that is returned. */
#define LOSSY_POSITION_NAN_F32 UINT32_C(0x7FC00000)

/* The bits of 1. */
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

/* The first 64 bits of 1 / log(2), 63 of them behind the point. */
#define LOSSY_POSITION_LOG2_E UINT64_C(0xB8AA3B295C17F0BB)

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
    uint32_t t31;
    float t33;
    float t44;
    float t47;
    float t50;
    float t53;
    float t61;
    uint32_t t66;
    float t84;
    float t85;
    uint32_t t86;
    uint32_t t98;
    float t149;
    float t150;
    float t151;
    float t153;
    float t154;
    float t155;
    float t156;
    float t157;
    float t158;
    float t160;
    float t162;
    float t163;
    float t164;
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
    float t181;
    float t182;
    float t183;
    float t184;
    uint32_t t185;
    uint32_t t186;
    float t202;
    float t213;
    float t228;
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
    float t270;
    float t272;
    float t276;
    float t277;
    float t278;
    float t279;
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
    float t306;
    float t308;
    float t309;
    float t387;
    float t396;
    float t402;
    float t411;
    float t462;
    float t463;
    float t464;
    float t465;
    lossy_position_status t473;
    int flags[6]; /* t5, t7, t37, t82, t97, t358 */
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

    /* prediction of what the samples show */
    work->t10 = (t1 < 40U) ? (t1 + 1U) : 0U;
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
    const uint32_t t29 = state->slot_camera;
    const uint32_t t30 = (t29 < 40U) ? t29 : 40U;
    work->t31 = (t30 < 40U) ? (t30 + 1U) : 0U;
    state->slot_camera = work->t31;
    const float t32 = state->camera[t30];
    work->t33 = t3 ? t2 : t32;
    const float t34 = state->wheel[t1];
    const uint32_t t35 = state->known;
    work->flags[2] = t35 == 1U;
    const int t38 = (-20.0f <= t27) && (t27 <= 20.0f);
    const int t39 = work->flags[2] && t38;
    const float t40 = t39 ? t27 : t34;
    const float t41 = work->flags[0] ? t4 : t40;
    const float t43 = 20.0f * t41;
    work->t44 = lossy_position_tanh_f32(t43);
    const float t45 = -6.653355e-6f * work->t44;
    const float t46 = t14 + t45;
    work->t47 = t12 + t46;
    const float t48 = -0.0019946774f * work->t44;
    const float t49 = t18 + t48;
    work->t50 = t16 + t49;
    const float t51 = -0.00018548031f * work->t44;
    const float t52 = t23 + t51;
    work->t53 = t21 + t52;
    const int t54 = (-20.0f <= work->t53) && (work->t53 <= 20.0f);
    const int t55 = work->flags[2] && t54;
    const float t56 = t55 ? work->t53 : t34;
    const int t57 = !work->flags[0];
    const int t58 = !t54;
    const int t59 = work->flags[2] && t58;
    const int t60 = t57 && t59;
    work->t61 = work->flags[0] ? t4 : t56;
    const int t62 = t3 || work->flags[0];
    const uint32_t t64 = state->since;
    const uint32_t t65 = (t64 < 4294967295U) ? (t64 + 1U) : 4294967295U;
    work->t66 = t62 ? 0U : t65;
    state->since = work->t66;
    const uint32_t t67 = state->missed_camera;
    const int t69 = 40U < t67;
    const int t70 = !t3;
    const int t71 = t70 && t69;
    const uint32_t t72 = (t67 < 41U) ? (t67 + 1U) : 41U;
    const uint32_t t73 = t3 ? 0U : t72;
    state->missed_camera = t73;
    const uint32_t t74 = state->missed_wheel;
    const int t75 = 40U < t74;
    const int t76 = t57 && t75;
    const uint32_t t77 = (t74 < 41U) ? (t74 + 1U) : 41U;
    const uint32_t t78 = work->flags[0] ? 0U : t77;
    state->missed_wheel = t78;
    const int t79 = t71 && t76;
    const int t80 = !t79;
    const int t81 = t76 && t80;
    work->flags[3] = t60 || t81;
    work->t84 = t3 ? 1.0f : 0.0f;
    work->t85 = work->flags[0] ? 1.0f : 0.0f;
    work->t86 = state->count;
}

/* Part 2 of a step. */
static void lossy_position_part_2(lossy_position_state *state, lossy_position_work *work)
{
    /* how much of the window is good */
    const int t87 = 40U < work->t86;
    const uint32_t t88 = (work->t86 < 44U) ? (work->t86 + 1U) : 44U;
    const uint32_t t89 = work->flags[3] ? 0U : t88;
    const uint32_t t90 = work->flags[1] ? t88 : 1U;
    const uint32_t t91 = t87 ? t89 : t90;
    state->count = t91;
    const uint32_t t92 = state->coasting;
    const uint32_t t93 = (t92 > 0U) ? (t92 - 1U) : 0U;
    const uint32_t t94 = work->flags[1] ? t93 : 40U;
    const uint32_t t96 = work->flags[0] ? t94 : 41U;
    state->coasting = t96;

    /* into the window */
    state->newest = work->t10;
    state->camera[work->t31] = work->t33;
    state->wheel[work->t10] = work->t61;
    state->has_camera[work->t10] = 0.0f;
    state->has_camera[work->t31] = work->t84;
    state->has_wheel[work->t10] = work->t85;
    state->force[work->t10] = work->t9;
    state->tanh_20_wheel[work->t10] = work->t44;
    work->flags[4] = 40U < t91;
}

/* Part 3 of a step. */
static void lossy_position_part_3(const lossy_position_state *state, lossy_position_work *work)
{
    /* rows of the window, oldest first; those without a sample count nothing */
    work->t98 = (work->t10 < 40U) ? (work->t10 + 1U) : 0U;
    const float t104 = state->has_camera[work->t98];
    const float t105 = state->camera[work->t98];
    const float t106 = t105 - 0.0f;
    const float t108 = 200.0f * t106;
    const float t109 = t104 * 0.16439898f;
    const float t110 = t104 * -0.11673887f;
    const float t111 = t104 * 0.07394887f;
    const float t112 = t104 * 0.045657706f;
    const float t113 = t109 * t109;
    const float t114 = 0.0f + t113;
    const float t115 = t109 * t110;
    const float t116 = 0.0f + t115;
    const float t117 = t109 * t111;
    const float t118 = 0.0f + t117;
    const float t119 = t109 * t112;
    const float t120 = 0.0f + t119;
    const float t121 = t110 * t110;
    const float t122 = 0.0f + t121;
    const float t123 = t110 * t111;
    const float t124 = 0.0f + t123;
    const float t125 = t110 * t112;
    const float t126 = 0.0f + t125;
    const float t127 = t111 * t111;
    const float t128 = 0.0f + t127;
    const float t129 = t111 * t112;
    const float t130 = 0.0f + t129;
    const float t131 = t112 * t112;
    const float t132 = 0.0f + t131;
    const float t133 = t109 * t108;
    const float t134 = 0.0f + t133;
    const float t135 = t110 * t108;
    const float t136 = 0.0f + t135;
    const float t137 = t111 * t108;
    const float t138 = 0.0f + t137;
    const float t139 = t112 * t108;
    const float t140 = 0.0f + t139;
    const float t141 = state->has_wheel[work->t98];
    const float t142 = state->wheel[work->t98];
    const float t143 = t142 - 0.0f;
    const float t145 = 50.0f * t143;
    const float t146 = t141 * 0.0f;
    const float t147 = t141 * 0.71376675f;
    const float t148 = t146 * t146;
    work->t149 = t114 + t148;
    work->t150 = t116 + t148;
    work->t151 = t118 + t148;
    const float t152 = t146 * t147;
    work->t153 = t120 + t152;
    work->t154 = t122 + t148;
    work->t155 = t124 + t148;
    work->t156 = t126 + t152;
    work->t157 = t128 + t148;
    work->t158 = t130 + t152;
    const float t159 = t147 * t147;
    work->t160 = t132 + t159;
    const float t161 = t146 * t145;
    work->t162 = t134 + t161;
    work->t163 = t136 + t161;
    work->t164 = t138 + t161;
    const float t165 = t147 * t145;
    work->t166 = t140 + t165;
}

/* Part 4 of a step, for one row of LOSSY_POSITION_ROWS. */
static void lossy_position_part_4(const lossy_position_state *state, lossy_position_work *work, const float *gains)
{
    work->t186 = (work->t185 < 40U) ? (work->t185 + 1U) : 0U;
    const float t187 = state->tanh_20_wheel[work->t185];
    const float t188 = state->force[work->t186];
    const float t189 = state->tanh_20_wheel[work->t186];
    const float t191 = 0.009960107f * work->t182;
    const float t193 = 4.9866932e-5f * work->t183;
    const float t194 = work->t181 + t191;
    const float t195 = t194 + t193;
    const float t197 = -1.3293418e-5f * t187;
    const float t198 = 1.9946774e-5f * t188;
    const float t199 = -6.653355e-6f * t189;
    const float t200 = t198 + t199;
    const float t201 = t195 + t197;
    work->t202 = t201 + t200;
    const float t204 = 0.99203193f * work->t182;
    const float t205 = 0.009960107f * work->t183;
    const float t206 = t204 + t205;
    const float t208 = -0.0019893653f * t187;
    const float t209 = 0.0039840424f * t188;
    const float t210 = -0.0019946774f * t189;
    const float t211 = t209 + t210;
    const float t212 = t206 + t208;
    work->t213 = t212 + t211;
    const float t215 = 0.25809625f * work->t182;
    const float t217 = 0.0013568978f * work->t183;
    const float t219 = 0.7408182f * work->t184;
    const float t220 = t215 + t217;
    const float t221 = t220 + t219;
    const float t223 = -0.0003572788f * t187;
    const float t224 = 0.0005427591f * t188;
    const float t225 = -0.00018548031f * t189;
    const float t226 = t224 + t225;
    const float t227 = t221 + t223;
    work->t228 = t227 + t226;
    const float t229 = gains[0];
    const float t230 = gains[1];
    const float t231 = gains[2];
    const float t232 = gains[3];
    const float t233 = gains[4];
    const float t234 = gains[5];
    const float t235 = gains[6];
    const float t236 = gains[7];
    const float t237 = state->has_camera[work->t186];
    const float t238 = state->camera[work->t186];
    const float t239 = t238 - work->t202;
    const float t240 = 200.0f * t239;
    const float t241 = t237 * t229;
    const float t242 = t237 * t230;
    const float t243 = t237 * t231;
    const float t244 = t237 * t232;
    const float t245 = t241 * t241;
    const float t246 = work->t167 + t245;
    const float t247 = t241 * t242;
    const float t248 = work->t168 + t247;
    const float t249 = t241 * t243;
    work->t250 = work->t169 + t249;
    const float t251 = t241 * t244;
    work->t252 = work->t170 + t251;
    const float t253 = t242 * t242;
    work->t254 = work->t171 + t253;
    const float t255 = t242 * t243;
    work->t256 = work->t172 + t255;
    const float t257 = t242 * t244;
    work->t258 = work->t173 + t257;
    const float t259 = t243 * t243;
    work->t260 = work->t174 + t259;
    const float t261 = t243 * t244;
    work->t262 = work->t175 + t261;
    const float t263 = t244 * t244;
    work->t264 = work->t176 + t263;
    const float t265 = t241 * t240;
    work->t266 = work->t177 + t265;
    const float t267 = t242 * t240;
    work->t268 = work->t178 + t267;
    const float t269 = t243 * t240;
    work->t270 = work->t179 + t269;
    const float t271 = t244 * t240;
    work->t272 = work->t180 + t271;
    const float t273 = state->has_wheel[work->t186];
    const float t274 = state->wheel[work->t186];
    const float t275 = t274 - work->t228;
    work->t276 = 50.0f * t275;
    work->t277 = t273 * t233;
    work->t278 = t273 * t234;
    work->t279 = t273 * t235;
    work->t280 = t273 * t236;
    const float t281 = work->t277 * work->t277;
    work->t282 = t246 + t281;
    const float t283 = work->t277 * work->t278;
    work->t284 = t248 + t283;
}

/* Part 5 of a step, for one row of LOSSY_POSITION_ROWS. */
static void lossy_position_part_5(lossy_position_work *work)
{
    const float t285 = work->t277 * work->t279;
    work->t286 = work->t250 + t285;
    const float t287 = work->t277 * work->t280;
    work->t288 = work->t252 + t287;
    const float t289 = work->t278 * work->t278;
    work->t290 = work->t254 + t289;
    const float t291 = work->t278 * work->t279;
    work->t292 = work->t256 + t291;
    const float t293 = work->t278 * work->t280;
    work->t294 = work->t258 + t293;
    const float t295 = work->t279 * work->t279;
    work->t296 = work->t260 + t295;
    const float t297 = work->t279 * work->t280;
    work->t298 = work->t262 + t297;
    const float t299 = work->t280 * work->t280;
    work->t300 = work->t264 + t299;
    const float t301 = work->t277 * work->t276;
    work->t302 = work->t266 + t301;
    const float t303 = work->t278 * work->t276;
    work->t304 = work->t268 + t303;
    const float t305 = work->t279 * work->t276;
    work->t306 = work->t270 + t305;
    const float t307 = work->t280 * work->t276;
    work->t308 = work->t272 + t307;
    work->t309 = work->t183 - 0.0f;
}

/* Part 6 of a step. */
static void lossy_position_part_6(const lossy_position_state *state, lossy_position_work *work)
{
    work->t167 = work->t149;
    work->t168 = work->t150;
    work->t169 = work->t151;
    work->t170 = work->t153;
    work->t171 = work->t154;
    work->t172 = work->t155;
    work->t173 = work->t156;
    work->t174 = work->t157;
    work->t175 = work->t158;
    work->t176 = work->t160;
    work->t177 = work->t162;
    work->t178 = work->t163;
    work->t179 = work->t164;
    work->t180 = work->t166;
    work->t181 = 0.0f;
    work->t182 = 0.0f;
    work->t183 = 0.0f;
    work->t184 = 0.0f;
    work->t185 = work->t98;
    for (uint32_t row = 0U; row < 40U; ++row) {
        const float *const gains = LOSSY_POSITION_ROWS[row];
        lossy_position_part_4(state, work, gains);
        lossy_position_part_5(work);
        work->t167 = work->t282;
        work->t168 = work->t284;
        work->t169 = work->t286;
        work->t170 = work->t288;
        work->t171 = work->t290;
        work->t172 = work->t292;
        work->t173 = work->t294;
        work->t174 = work->t296;
        work->t175 = work->t298;
        work->t176 = work->t300;
        work->t177 = work->t302;
        work->t178 = work->t304;
        work->t179 = work->t306;
        work->t180 = work->t308;
        work->t181 = work->t202;
        work->t182 = work->t213;
        work->t183 = work->t309;
        work->t184 = work->t228;
        work->t185 = work->t186;
    }
}

/* Part 7 of a step. */
static void lossy_position_part_7(lossy_position_work *work)
{
    /* the window's start from the samples that are there */
    const int t311 = 0.015625f < work->t167;
    const float t312 = t311 ? work->t167 : 1.0f;
    const float t313 = work->t168 / t312;
    const float t314 = t313 * work->t168;
    const float t315 = work->t171 - t314;
    const float t316 = t313 * work->t169;
    const float t317 = work->t172 - t316;
    const float t318 = t313 * work->t170;
    const float t319 = work->t173 - t318;
    const float t320 = t313 * work->t177;
    const float t321 = work->t178 - t320;
    const float t322 = work->t169 / t312;
    const float t323 = t322 * work->t169;
    const float t324 = work->t174 - t323;
    const float t325 = t322 * work->t170;
    const float t326 = work->t175 - t325;
    const float t327 = t322 * work->t177;
    const float t328 = work->t179 - t327;
    const float t329 = work->t170 / t312;
    const float t330 = t329 * work->t170;
    const float t331 = work->t176 - t330;
    const float t332 = t329 * work->t177;
    const float t333 = work->t180 - t332;
    const int t334 = 0.015625f < t315;
    const int t335 = t311 && t334;
    const float t336 = t334 ? t315 : 1.0f;
    const float t337 = t317 / t336;
    const float t338 = t337 * t317;
    const float t339 = t324 - t338;
    const float t340 = t337 * t319;
    const float t341 = t326 - t340;
    const float t342 = t337 * t321;
    const float t343 = t328 - t342;
    const float t344 = t319 / t336;
    const float t345 = t344 * t319;
    const float t346 = t331 - t345;
    const float t347 = t344 * t321;
    const float t348 = t333 - t347;
    const int t349 = 0.015625f < t339;
    const int t350 = t335 && t349;
    const float t351 = t349 ? t339 : 1.0f;
    const float t352 = t341 / t351;
    const float t353 = t352 * t341;
    const float t354 = t346 - t353;
    const float t355 = t352 * t343;
    const float t356 = t348 - t355;
    const int t357 = 0.015625f < t354;
    work->flags[5] = t350 && t357;
    const float t359 = t357 ? t354 : 1.0f;
    const float t360 = t356 / t359;
    const float t361 = t341 * t360;
    const float t362 = t343 - t361;
    const float t363 = t362 / t351;
    const float t364 = t317 * t363;
    const float t365 = t321 - t364;
    const float t366 = t319 * t360;
    const float t367 = t365 - t366;
    const float t368 = t367 / t336;
    const float t369 = work->t168 * t368;
    const float t370 = work->t177 - t369;
    const float t371 = work->t169 * t363;
    const float t372 = t370 - t371;
    const float t373 = work->t170 * t360;
    const float t374 = t372 - t373;
    const float t375 = t374 / t312;
    const float t377 = 0.0008219949f * t375;
    const float t379 = 0.00063696405f * t368;
    const float t381 = 0.0005493616f * t363;
    const float t383 = 3.3166725e-5f * t360;
    const float t384 = t377 + t379;
    const float t385 = t384 + t381;
    const float t386 = t385 + t383;
    work->t387 = t386 + work->t181;
    const float t389 = 0.002589379f * t368;
    const float t391 = 0.006504165f * t363;
    const float t393 = 0.0014001199f * t360;
    const float t394 = t389 + t391;
    const float t395 = t394 + t393;
    work->t396 = t395 + work->t182;
    const float t398 = 0.032337446f * t363;
    const float t400 = 0.009580231f * t360;
    const float t401 = t398 + t400;
    work->t402 = t401 + work->t183;
    const float t404 = 0.0026602983f * t368;
    const float t406 = 0.005574961f * t363;
    const float t408 = 0.0011104953f * t360;
    const float t409 = t404 + t406;
    const float t410 = t409 + t408;
    work->t411 = t410 + work->t184;
}

/* Part 8 of a step. */
static void lossy_position_part_8(lossy_position_state *state, lossy_position_work *work)
{
    /* without enough samples, the model's prediction */
    const int t412 = (-1e25f <= work->t47) && (work->t47 <= 1e25f);
    const int t413 = work->flags[2] && t412;
    const float t414 = work->flags[5] ? work->t387 : work->t47;
    const int t415 = (-1e25f <= work->t50) && (work->t50 <= 1e25f);
    const int t416 = t413 && t415;
    const float t417 = work->flags[5] ? work->t396 : work->t50;
    const int t418 = (-1e25f <= work->t20) && (work->t20 <= 1e25f);
    const int t419 = t416 && t418;
    const float t420 = work->flags[5] ? work->t402 : work->t20;
    const int t421 = (-1e25f <= work->t53) && (work->t53 <= 1e25f);
    const int t422 = t419 && t421;
    const float t423 = work->flags[5] ? work->t411 : work->t53;
    const int t424 = work->flags[5] || t422;
    const int t425 = work->flags[4] && t424;
    const uint32_t t426 = t425 ? 1U : 0U;
    state->known = t426;
    const float t428 = 0.009960107f * t417;
    const float t430 = 4.9866932e-5f * t420;
    const float t431 = t414 + t428;
    const float t432 = t431 + t430;
    const float t434 = -1.3293418e-5f * work->t44;
    const float t435 = t432 + t434;
    const int t436 = (-1e25f <= t435) && (t435 <= 1e25f);
    const float t437 = t436 ? t435 : 0.0f;
    state->next_position = t437;
    const float t439 = 0.99203193f * t417;
    const float t440 = 0.009960107f * t420;
    const float t441 = t439 + t440;
    const float t443 = -0.0019893653f * work->t44;
    const float t444 = t441 + t443;
    const int t445 = (-1e25f <= t444) && (t444 <= 1e25f);
    const float t446 = t445 ? t444 : 0.0f;
    state->next_speed = t446;
    const int t447 = (-1e25f <= t420) && (t420 <= 1e25f);
    const float t448 = t447 ? t420 : 0.0f;
    state->next_slope = t448;
    const float t450 = 0.25809625f * t417;
    const float t452 = 0.0013568978f * t420;
    const float t454 = 0.7408182f * t423;
    const float t455 = t450 + t452;
    const float t456 = t455 + t454;
    const float t458 = -0.0003572788f * work->t44;
    const float t459 = t456 + t458;
    const int t460 = (-1e25f <= t459) && (t459 <= 1e25f);
    const float t461 = t460 ? t459 : 0.0f;
    state->next_wheel = t461;

    /* the estimate; until there is one, the start */
    work->t462 = t425 ? t414 : 0.0f;
    work->t463 = t425 ? t417 : 0.0f;
    work->t464 = t425 ? t420 : 0.0f;
    work->t465 = t425 ? t423 : work->t61;
    const uint32_t t466 = state->coasting;
    const int t467 = t466 == 0U;
    const int t468 = work->flags[5] && t467;
    const lossy_position_status t472 = t468 ? LOSSY_POSITION_CONVERGED : LOSSY_POSITION_COASTING;
    work->t473 = t425 ? t472 : LOSSY_POSITION_CONVERGING;
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
    state->since = 0U;
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

    estimate->position = work.t462;
    estimate->speed = work.t463;
    estimate->slope = work.t464;
    estimate->wheel = work.t465;
    estimate->coasted = work.t66;
    estimate->status = work.t473;
}
