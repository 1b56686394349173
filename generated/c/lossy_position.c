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
    float t143;
    float t151;
    float t152;
    float t153;
    float t155;
    float t156;
    float t157;
    float t158;
    float t159;
    float t160;
    float t162;
    float t164;
    float t165;
    float t166;
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
    float t185;
    float t186;
    float t187;
    uint32_t t188;
    uint32_t t189;
    float t205;
    float t216;
    float t231;
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
    float t274;
    float t276;
    float t278;
    float t281;
    float t282;
    float t283;
    float t284;
    float t285;
    float t287;
    float t289;
    float t291;
    float t293;
    float t295;
    float t297;
    float t299;
    float t301;
    float t303;
    float t305;
    float t307;
    float t309;
    float t311;
    float t313;
    float t314;
    float t336;
    float t387;
    float t389;
    float t391;
    float t394;
    float t396;
    float t398;
    float t399;
    float t401;
    float t403;
    float t405;
    float t406;
    float t408;
    float t411;
    float t412;
    float t414;
    float t416;
    float t417;
    float t418;
    float t505;
    float t506;
    float t507;
    float t508;
    float t569;
    float t570;
    float t571;
    float t572;
    lossy_position_status t580;
    int flags[10]; /* t5, t7, t37, t82, t97, t410, t496, t498, t503, t504 */
} lossy_position_work;

/* Part 1 of a step. */
static void lossy_position_part_1(lossy_position_state *state, const lossy_position_measurements *measurements, const lossy_position_inputs *inputs, lossy_position_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    const uint32_t t0 = state->newest;
    const uint32_t t1 = (t0 < 40U) ? t0 : 40U;
    const float t2 = measurements->camera;
    const int t3 = (-1e31f <= t2) && (t2 <= 1e31f);
    const float t4 = measurements->wheel;
    work->flags[0] = (-20.0f <= t4) && (t4 <= 20.0f);
    const float t6 = inputs->force;
    work->flags[1] = (-1e31f <= t6) && (t6 <= 1e31f);
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
    const float t105 = 0.0f + t104;
    const float t106 = state->camera[work->t98];
    const float t107 = t106 - 0.0f;
    const float t109 = 200.0f * t107;
    const float t110 = t104 * 0.16439898f;
    const float t111 = t104 * -0.11673887f;
    const float t112 = t104 * 0.07394887f;
    const float t113 = t104 * 0.045657706f;
    const float t114 = t110 * t110;
    const float t115 = 0.0f + t114;
    const float t116 = t110 * t111;
    const float t117 = 0.0f + t116;
    const float t118 = t110 * t112;
    const float t119 = 0.0f + t118;
    const float t120 = t110 * t113;
    const float t121 = 0.0f + t120;
    const float t122 = t111 * t111;
    const float t123 = 0.0f + t122;
    const float t124 = t111 * t112;
    const float t125 = 0.0f + t124;
    const float t126 = t111 * t113;
    const float t127 = 0.0f + t126;
    const float t128 = t112 * t112;
    const float t129 = 0.0f + t128;
    const float t130 = t112 * t113;
    const float t131 = 0.0f + t130;
    const float t132 = t113 * t113;
    const float t133 = 0.0f + t132;
    const float t134 = t110 * t109;
    const float t135 = 0.0f + t134;
    const float t136 = t111 * t109;
    const float t137 = 0.0f + t136;
    const float t138 = t112 * t109;
    const float t139 = 0.0f + t138;
    const float t140 = t113 * t109;
    const float t141 = 0.0f + t140;
    const float t142 = state->has_wheel[work->t98];
    work->t143 = t105 + t142;
    const float t144 = state->wheel[work->t98];
    const float t145 = t144 - 0.0f;
    const float t147 = 50.0f * t145;
    const float t148 = t142 * 0.0f;
    const float t149 = t142 * 0.71376675f;
    const float t150 = t148 * t148;
    work->t151 = t115 + t150;
    work->t152 = t117 + t150;
    work->t153 = t119 + t150;
    const float t154 = t148 * t149;
    work->t155 = t121 + t154;
    work->t156 = t123 + t150;
    work->t157 = t125 + t150;
    work->t158 = t127 + t154;
    work->t159 = t129 + t150;
    work->t160 = t131 + t154;
    const float t161 = t149 * t149;
    work->t162 = t133 + t161;
    const float t163 = t148 * t147;
    work->t164 = t135 + t163;
    work->t165 = t137 + t163;
    work->t166 = t139 + t163;
    const float t167 = t149 * t147;
    work->t168 = t141 + t167;
}

/* Part 4 of a step, for one row of LOSSY_POSITION_ROWS. */
static void lossy_position_part_4(const lossy_position_state *state, lossy_position_work *work, const float *gains)
{
    work->t189 = (work->t188 < 40U) ? (work->t188 + 1U) : 0U;
    const float t190 = state->tanh_20_wheel[work->t188];
    const float t191 = state->force[work->t189];
    const float t192 = state->tanh_20_wheel[work->t189];
    const float t194 = 0.009960107f * work->t184;
    const float t196 = 4.9866932e-5f * work->t185;
    const float t197 = work->t183 + t194;
    const float t198 = t197 + t196;
    const float t200 = -1.3293418e-5f * t190;
    const float t201 = 1.9946774e-5f * t191;
    const float t202 = -6.653355e-6f * t192;
    const float t203 = t201 + t202;
    const float t204 = t198 + t200;
    work->t205 = t204 + t203;
    const float t207 = 0.99203193f * work->t184;
    const float t208 = 0.009960107f * work->t185;
    const float t209 = t207 + t208;
    const float t211 = -0.0019893653f * t190;
    const float t212 = 0.0039840424f * t191;
    const float t213 = -0.0019946774f * t192;
    const float t214 = t212 + t213;
    const float t215 = t209 + t211;
    work->t216 = t215 + t214;
    const float t218 = 0.25809625f * work->t184;
    const float t220 = 0.0013568978f * work->t185;
    const float t222 = 0.7408182f * work->t186;
    const float t223 = t218 + t220;
    const float t224 = t223 + t222;
    const float t226 = -0.0003572788f * t190;
    const float t227 = 0.0005427591f * t191;
    const float t228 = -0.00018548031f * t192;
    const float t229 = t227 + t228;
    const float t230 = t224 + t226;
    work->t231 = t230 + t229;
    const float t232 = gains[0];
    const float t233 = gains[1];
    const float t234 = gains[2];
    const float t235 = gains[3];
    const float t236 = gains[4];
    const float t237 = gains[5];
    const float t238 = gains[6];
    const float t239 = gains[7];
    const float t240 = state->has_camera[work->t189];
    const float t241 = work->t187 + t240;
    const float t242 = state->camera[work->t189];
    const float t243 = t242 - work->t205;
    const float t244 = 200.0f * t243;
    const float t245 = t240 * t232;
    const float t246 = t240 * t233;
    const float t247 = t240 * t234;
    const float t248 = t240 * t235;
    const float t249 = t245 * t245;
    const float t250 = work->t169 + t249;
    const float t251 = t245 * t246;
    work->t252 = work->t170 + t251;
    const float t253 = t245 * t247;
    work->t254 = work->t171 + t253;
    const float t255 = t245 * t248;
    work->t256 = work->t172 + t255;
    const float t257 = t246 * t246;
    work->t258 = work->t173 + t257;
    const float t259 = t246 * t247;
    work->t260 = work->t174 + t259;
    const float t261 = t246 * t248;
    work->t262 = work->t175 + t261;
    const float t263 = t247 * t247;
    work->t264 = work->t176 + t263;
    const float t265 = t247 * t248;
    work->t266 = work->t177 + t265;
    const float t267 = t248 * t248;
    work->t268 = work->t178 + t267;
    const float t269 = t245 * t244;
    work->t270 = work->t179 + t269;
    const float t271 = t246 * t244;
    work->t272 = work->t180 + t271;
    const float t273 = t247 * t244;
    work->t274 = work->t181 + t273;
    const float t275 = t248 * t244;
    work->t276 = work->t182 + t275;
    const float t277 = state->has_wheel[work->t189];
    work->t278 = t241 + t277;
    const float t279 = state->wheel[work->t189];
    const float t280 = t279 - work->t231;
    work->t281 = 50.0f * t280;
    work->t282 = t277 * t236;
    work->t283 = t277 * t237;
    work->t284 = t277 * t238;
    work->t285 = t277 * t239;
    const float t286 = work->t282 * work->t282;
    work->t287 = t250 + t286;
}

/* Part 5 of a step, for one row of LOSSY_POSITION_ROWS. */
static void lossy_position_part_5(lossy_position_work *work)
{
    const float t288 = work->t282 * work->t283;
    work->t289 = work->t252 + t288;
    const float t290 = work->t282 * work->t284;
    work->t291 = work->t254 + t290;
    const float t292 = work->t282 * work->t285;
    work->t293 = work->t256 + t292;
    const float t294 = work->t283 * work->t283;
    work->t295 = work->t258 + t294;
    const float t296 = work->t283 * work->t284;
    work->t297 = work->t260 + t296;
    const float t298 = work->t283 * work->t285;
    work->t299 = work->t262 + t298;
    const float t300 = work->t284 * work->t284;
    work->t301 = work->t264 + t300;
    const float t302 = work->t284 * work->t285;
    work->t303 = work->t266 + t302;
    const float t304 = work->t285 * work->t285;
    work->t305 = work->t268 + t304;
    const float t306 = work->t282 * work->t281;
    work->t307 = work->t270 + t306;
    const float t308 = work->t283 * work->t281;
    work->t309 = work->t272 + t308;
    const float t310 = work->t284 * work->t281;
    work->t311 = work->t274 + t310;
    const float t312 = work->t285 * work->t281;
    work->t313 = work->t276 + t312;
    work->t314 = work->t185 - 0.0f;
}

/* Part 6 of a step. */
static void lossy_position_part_6(const lossy_position_state *state, lossy_position_work *work)
{
    work->t169 = work->t151;
    work->t170 = work->t152;
    work->t171 = work->t153;
    work->t172 = work->t155;
    work->t173 = work->t156;
    work->t174 = work->t157;
    work->t175 = work->t158;
    work->t176 = work->t159;
    work->t177 = work->t160;
    work->t178 = work->t162;
    work->t179 = work->t164;
    work->t180 = work->t165;
    work->t181 = work->t166;
    work->t182 = work->t168;
    work->t183 = 0.0f;
    work->t184 = 0.0f;
    work->t185 = 0.0f;
    work->t186 = 0.0f;
    work->t187 = work->t143;
    work->t188 = work->t98;
    for (uint32_t row = 0U; row < 40U; ++row) {
        const float *const gains = LOSSY_POSITION_ROWS[row];
        lossy_position_part_4(state, work, gains);
        lossy_position_part_5(work);
        work->t169 = work->t287;
        work->t170 = work->t289;
        work->t171 = work->t291;
        work->t172 = work->t293;
        work->t173 = work->t295;
        work->t174 = work->t297;
        work->t175 = work->t299;
        work->t176 = work->t301;
        work->t177 = work->t303;
        work->t178 = work->t305;
        work->t179 = work->t307;
        work->t180 = work->t309;
        work->t181 = work->t311;
        work->t182 = work->t313;
        work->t183 = work->t205;
        work->t184 = work->t216;
        work->t185 = work->t314;
        work->t186 = work->t231;
        work->t187 = work->t278;
        work->t188 = work->t189;
    }
}

/* Part 7 of a step. */
static void lossy_position_part_7(lossy_position_work *work)
{
    /* the state from the samples that are there, and its variance */
    const float t329 = 0.0001f * work->t169;
    const float t330 = t329 + 9.8607613e-32f;
    const float t331 = 0.0001f * work->t173;
    const float t332 = t331 + 9.8607613e-32f;
    const float t333 = 0.0001f * work->t176;
    const float t334 = t333 + 9.8607613e-32f;
    const float t335 = 0.0001f * work->t178;
    work->t336 = t335 + 9.8607613e-32f;
    const int t337 = t330 < work->t169;
    const float t338 = t337 ? work->t169 : 1.0f;
    const float t339 = work->t170 / t338;
    const float t340 = work->t171 / t338;
    const float t341 = work->t172 / t338;
    const float t342 = t339 * work->t170;
    const float t343 = work->t173 - t342;
    const float t344 = t339 * work->t171;
    const float t345 = work->t174 - t344;
    const float t346 = t339 * work->t172;
    const float t347 = work->t175 - t346;
    const float t348 = t339 * work->t179;
    const float t349 = work->t180 - t348;
    const float t350 = t340 * work->t171;
    const float t351 = work->t176 - t350;
    const float t352 = t340 * work->t172;
    const float t353 = work->t177 - t352;
    const float t354 = t340 * work->t179;
    const float t355 = work->t181 - t354;
    const float t356 = t341 * work->t172;
    const float t357 = work->t178 - t356;
    const float t358 = t341 * work->t179;
    const float t359 = work->t182 - t358;
    const float t360 = work->t179 / t338;
    const float t361 = t339 * 0.052607674f;
    const float t362 = 0.0407657f - t361;
    const float t363 = t340 * 0.052607674f;
    const float t364 = 0.03515914f - t363;
    const float t365 = t341 * 0.052607674f;
    const float t366 = 0.0021226704f - t365;
    const float t367 = 0.052607674f * t360;
    const float t368 = 0.052607674f / t338;
    const float t369 = 0.052607674f * t368;
    const int t370 = t332 < t343;
    const int t371 = t337 && t370;
    const float t372 = t370 ? t343 : 1.0f;
    const float t373 = t345 / t372;
    const float t374 = t347 / t372;
    const float t375 = t373 * t345;
    const float t376 = t351 - t375;
    const float t377 = t373 * t347;
    const float t378 = t353 - t377;
    const float t379 = t373 * t349;
    const float t380 = t355 - t379;
    const float t381 = t374 * t347;
    const float t382 = t357 - t381;
    const float t383 = t374 * t349;
    const float t384 = t359 - t383;
    const float t385 = t349 / t372;
    const float t386 = t373 * t362;
    work->t387 = t364 - t386;
    const float t388 = t374 * t362;
    work->t389 = t366 - t388;
    const float t390 = t362 * t385;
    work->t391 = t367 + t390;
    const float t392 = t362 / t372;
    const float t393 = t362 * t392;
    work->t394 = t369 + t393;
    const float t395 = t373 * 0.020715032f;
    work->t396 = 0.05203332f - t395;
    const float t397 = t374 * 0.020715032f;
    work->t398 = 0.011200959f - t397;
    work->t399 = 0.020715032f * t385;
    const float t400 = 0.020715032f / t372;
    work->t401 = 0.020715032f * t400;
    const float t402 = t373 * 0.021282386f;
    work->t403 = 0.04459969f - t402;
    const float t404 = t374 * 0.021282386f;
    work->t405 = 0.008883962f - t404;
    work->t406 = 0.021282386f * t385;
    const float t407 = 0.021282386f / t372;
    work->t408 = 0.021282386f * t407;
    const int t409 = t334 < t376;
    work->flags[5] = t371 && t409;
    work->t411 = t409 ? t376 : 1.0f;
    work->t412 = t378 / work->t411;
    const float t413 = work->t412 * t378;
    work->t414 = t382 - t413;
    const float t415 = work->t412 * t380;
    work->t416 = t384 - t415;
    work->t417 = t380 / work->t411;
    work->t418 = work->t412 * work->t387;
}

/* Part 8 of a step. */
static void lossy_position_part_8(lossy_position_work *work)
{
    const float t419 = work->t389 - work->t418;
    const float t420 = work->t387 * work->t417;
    const float t421 = work->t391 + t420;
    const float t422 = work->t387 / work->t411;
    const float t423 = work->t387 * t422;
    const float t424 = work->t394 + t423;
    const float t425 = work->t412 * work->t396;
    const float t426 = work->t398 - t425;
    const float t427 = work->t396 * work->t417;
    const float t428 = work->t399 + t427;
    const float t429 = work->t396 / work->t411;
    const float t430 = work->t396 * t429;
    const float t431 = work->t401 + t430;
    const float t432 = work->t412 * 0.06467489f;
    const float t433 = 0.019160463f - t432;
    const float t434 = 0.06467489f * work->t417;
    const float t435 = 0.06467489f / work->t411;
    const float t436 = 0.06467489f * t435;
    const float t437 = work->t412 * work->t403;
    const float t438 = work->t405 - t437;
    const float t439 = work->t403 * work->t417;
    const float t440 = work->t406 + t439;
    const float t441 = work->t403 / work->t411;
    const float t442 = work->t403 * t441;
    const float t443 = work->t408 + t442;
    const int t444 = work->t336 < work->t414;
    const int t445 = work->flags[5] && t444;
    const float t446 = t444 ? work->t414 : 1.0f;
    const float t447 = work->t416 / t446;
    const float t448 = t419 * t447;
    const float t449 = t421 + t448;
    const float t450 = t419 / t446;
    const float t451 = t419 * t450;
    const float t452 = t424 + t451;
    const float t453 = t426 * t447;
    const float t454 = t428 + t453;
    const float t455 = t426 / t446;
    const float t456 = t426 * t455;
    const float t457 = t431 + t456;
    const float t458 = t433 * t447;
    const float t459 = t434 + t458;
    const float t460 = t433 / t446;
    const float t461 = t433 * t460;
    const float t462 = t436 + t461;
    const float t463 = t438 * t447;
    const float t464 = t440 + t463;
    const float t465 = t438 / t446;
    const float t466 = t438 * t465;
    const float t467 = t443 + t466;
    const float t469 = 0.015625f * t449;
    const float t471 = 0.125f * t454;
    const float t473 = 0.5f * t459;
    const float t474 = 0.125f * t464;

    /* what it is worth */
    const float t476 = t452 * 0.32999095f;
    const int t477 = 0.0f < t476;
    const float t478 = t477 ? t476 : 0.0f;
    const float t480 = t457 * 0.7327289f;
    const int t481 = t478 < t480;
    const float t482 = t481 ? t480 : t478;
    const float t484 = t462 * 0.49879247f;
    const int t485 = t482 < t484;
    const float t486 = t485 ? t484 : t482;
    const float t488 = t467 * 0.95573866f;
    const int t489 = t486 < t488;
    const float t490 = t489 ? t488 : t486;
    const int t495 = t490 <= 154202.52f;
    work->flags[6] = t445 && t495;
    const int t497 = t490 <= 0.1542025f;
    work->flags[7] = work->flags[6] && t497;
    const float t499 = 1.4428647f * work->t187;
    const float t500 = t499 + 49.84152f;
    const float t501 = t490 * t500;
    const int t502 = t501 <= 1.0f;
    work->flags[8] = work->flags[7] && t502;
    work->flags[9] = 0.0f < work->t187;
    work->t505 = t469 + work->t183;
    work->t506 = t471 + work->t184;
    work->t507 = t473 + work->t185;
    work->t508 = t474 + work->t186;
}

/* Part 9 of a step. */
static void lossy_position_part_9(lossy_position_state *state, lossy_position_work *work)
{
    /* without enough samples, the model's prediction */
    const int t509 = (-1e31f <= work->t47) && (work->t47 <= 1e31f);
    const int t510 = work->flags[2] && t509;
    const int t511 = (-1e31f <= work->t50) && (work->t50 <= 1e31f);
    const int t512 = t510 && t511;
    const int t513 = (-1e31f <= work->t20) && (work->t20 <= 1e31f);
    const int t514 = t512 && t513;
    const int t515 = (-1e31f <= work->t53) && (work->t53 <= 1e31f);
    const int t516 = t514 && t515;
    const uint32_t t517 = state->poor;
    const uint32_t t518 = (t517 < 123U) ? (t517 + 1U) : 123U;
    const uint32_t t519 = work->flags[9] ? t518 : t517;
    const uint32_t t520 = work->flags[7] ? 0U : t519;
    state->poor = t520;
    const int t522 = t520 < 123U;
    const int t523 = t522 && t516;
    const int t524 = !t523;
    const int t525 = work->flags[7] || t524;
    const int t526 = work->flags[6] && t525;
    const float t527 = t526 ? work->t505 : work->t47;
    const float t528 = t526 ? work->t506 : work->t50;
    const float t529 = t526 ? work->t507 : work->t20;
    const float t530 = t526 ? work->t508 : work->t53;
    const int t531 = t526 || t516;
    const int t532 = work->flags[4] && t531;
    const uint32_t t533 = t532 ? 1U : 0U;
    state->known = t533;
    const float t535 = 0.009960107f * t528;
    const float t537 = 4.9866932e-5f * t529;
    const float t538 = t527 + t535;
    const float t539 = t538 + t537;
    const float t541 = -1.3293418e-5f * work->t44;
    const float t542 = t539 + t541;
    const int t543 = (-1e31f <= t542) && (t542 <= 1e31f);
    const float t544 = t543 ? t542 : 0.0f;
    state->next_position = t544;
    const float t546 = 0.99203193f * t528;
    const float t547 = 0.009960107f * t529;
    const float t548 = t546 + t547;
    const float t550 = -0.0019893653f * work->t44;
    const float t551 = t548 + t550;
    const int t552 = (-1e31f <= t551) && (t551 <= 1e31f);
    const float t553 = t552 ? t551 : 0.0f;
    state->next_speed = t553;
    const int t554 = (-1e31f <= t529) && (t529 <= 1e31f);
    const float t555 = t554 ? t529 : 0.0f;
    state->next_slope = t555;
    const float t557 = 0.25809625f * t528;
    const float t559 = 0.0013568978f * t529;
    const float t561 = 0.7408182f * t530;
    const float t562 = t557 + t559;
    const float t563 = t562 + t561;
    const float t565 = -0.0003572788f * work->t44;
    const float t566 = t563 + t565;
    const int t567 = (-1e31f <= t566) && (t566 <= 1e31f);
    const float t568 = t567 ? t566 : 0.0f;
    state->next_wheel = t568;

    /* the estimate; until there is one, the start */
    work->t569 = t532 ? t527 : 0.0f;
    work->t570 = t532 ? t528 : 0.0f;
    work->t571 = t532 ? t529 : 0.0f;
    work->t572 = t532 ? t530 : work->t61;
    const uint32_t t573 = state->coasting;
    const int t574 = t573 == 0U;
    const int t575 = work->flags[8] && t574;
    const lossy_position_status t579 = t575 ? LOSSY_POSITION_CONVERGED : LOSSY_POSITION_COASTING;
    work->t580 = t532 ? t579 : LOSSY_POSITION_CONVERGING;
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
    state->poor = 123U;
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
    lossy_position_part_8(&work);
    lossy_position_part_9(state, &work);

    estimate->position = work.t569;
    estimate->speed = work.t570;
    estimate->slope = work.t571;
    estimate->wheel = work.t572;
    estimate->coasted = work.t66;
    estimate->status = work.t580;
}
