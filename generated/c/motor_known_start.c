/* motor_known_start.c: Finite-time observer: Direct-drive arm whose rest position is known when it is switched on.
 *
 * Generated; motor_known_start.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "motor_known_start.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "motor_known_start.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "motor_known_start.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* weights by age, from age 0
 *   [0] q from y
 *   [1] dq from y
 *   [2] i from y
 *   [3] q from u
 *   [4] dq from u
 *   [5] i from u
 *   [6] q from sin(q)
 *   [7] dq from sin(q)
 *   [8] i from sin(q)
 */
static const float MOTOR_KNOWN_START_WINDOW[40][9] = {
    {
        0.11743375f, 5.473251f, -0.8574648f, 8.3991125e-8f, 0.00028033264f, 0.036250636f,
        -5.1468805e-6f, -0.017461484f, 0.00019707064f
    },
    {
        0.1119514f, 5.121008f, -0.80587155f, 5.457008e-7f, 0.0007690974f, 0.029662132f,
        -3.0214998e-5f, -0.034733485f, 0.0011017529f
    },
    {
        0.106451176f, 4.7676826f, -0.7541124f, 1.3413129e-6f, 0.0011625733f, 0.024254177f,
        -5.7156332e-5f, -0.034305967f, 0.0019901402f
    },
    {
        0.100933634f, 4.4133253f, -0.7021932f, 2.3516845e-6f, 0.0014752577f, 0.019815868f,
        -8.0321915e-5f, -0.033699535f, 0.0026785468f
    },
    {
        0.095399484f, 4.057999f, -0.6501213f, 3.482221e-6f, 0.0017192547f, 0.016174026f,
        -9.990163e-5f, -0.032929342f, 0.0031999564f
    },
    {
        0.089849606f, 3.7017817f, -0.5979056f, 4.658479e-6f, 0.0019047043f, 0.013186438f,
        -0.00011608877f, -0.03201017f, 0.0035817937f
    },
    {
        0.084285066f, 3.3447697f, -0.5455572f, 5.822556e-6f, 0.0020401333f, 0.010736316f,
        -0.00012907939f, -0.030956501f, 0.0038469192f
    },
    {
        0.07870721f, 2.9870806f, -0.49308994f, 6.9301254e-6f, 0.002132744f, 0.008727746f,
        -0.00013907166f, -0.02978255f, 0.0040144455f
    },
    {
        0.07311769f, 2.628859f, -0.44052067f, 7.948001e-6f, 0.00218865f, 0.007081952f,
        -0.00014626549f, -0.028502317f, 0.0041004075f
    },
    {
        0.0675185f, 2.270283f, -0.3878701f, 8.85214e-6f, 0.0022130716f, 0.0057342276f,
        -0.00015086203f, -0.02712961f, 0.0041183103f
    },
    {
        0.061912145f, 1.9115695f, -0.33516362f, 9.6259955e-6f, 0.0022104946f, 0.0046314187f,
        -0.00015306332f, -0.025678065f, 0.004079584f
    },
    {
        0.056301646f, 1.5529842f, -0.28243232f, 1.0259168e-5f, 0.0021848008f, 0.0037298573f,
        -0.000153072f, -0.024161173f, 0.0039939494f
    },
    {
        0.050690714f, 1.1948522f, -0.22971427f, 1.0746298e-5f, 0.0021393765f, 0.00299366f,
        -0.00015109098f, -0.022592278f, 0.0038697256f
    },
    {
        0.04508389f, 0.8375701f, -0.17705597f, 1.1086147e-5f, 0.0020771986f, 0.0023933384f,
        -0.00014732314f, -0.020984586f, 0.003714076f
    },
    {
        0.03948673f, 0.48162234f, -0.124514215f, 1.1280852e-5f, 0.0020009074f, 0.0019046526f,
        -0.00014197106f, -0.019351166f, 0.0035332132f
    },
    {
        0.033905998f, 0.12760009f, -0.07215837f, 1.1335297e-5f, 0.001912866f, 0.0015076725f,
        -0.00013523668f, -0.017704941f, 0.0033325648f
    },
    {
        0.02834997f, -0.22377549f, -0.020073064f, 1.1256605e-5f, 0.001815207f, 0.0011860066f,
        -0.00012732105f, -0.016058683f, 0.0031169106f
    },
    {
        0.02282873f, -0.5716249f, 0.03163842f, 1.105371e-5f, 0.0017098719f, 0.0009261691f,
        -0.000118423864f, -0.014424982f, 0.0028904923f
    },
    {
        0.017354589f, -0.9148757f, 0.08285014f, 1.0737004e-5f, 0.0015986431f, 0.00071705977f,
        -0.000108743145f, -0.012816233f, 0.0026571034f
    },
    {
        0.011942552f, -1.2522205f, 0.13340853f, 1.03180355e-5f, 0.0014831689f, 0.0005495375f,
        -9.8474695e-5f, -0.0112446f, 0.0024201614f
    },
    {
        0.0066109197f, -1.5820659f, 0.18312638f, 9.80926e-6f, 0.0013649832f, 0.00041607005f,
        -8.7811575e-5f, -0.009721972f, 0.0021827659f
    },
    {
        0.0013819956f, -1.9024698f, 0.23177546f, 9.223817e-6f, 0.0012455216f, 0.00031044683f,
        -7.6943434e-5f, -0.008259916f, 0.0019477423f
    },
    {
        -0.003717035f, -2.2110653f, 0.27907768f, 8.57535e-6f, 0.0011261329f, 0.00022754286f,
        -6.605566e-5f, -0.0068696053f, 0.0017176783f
    },
    {
        -0.008653042f, -2.504969f, 0.32469407f, 7.877821e-6f, 0.0010080877f, 0.0001631253f,
        -5.5328477e-5f, -0.0055617457f, 0.001494947f
    },
    {
        -0.013385653f, -2.7806668f, 0.36821166f, 7.145366e-6f, 0.0008925835f, 0.000113694834f,
        -4.4935714e-5f, -0.0043464727f, 0.001281725f
    },
    {
        -0.017865676f, -3.0338786f, 0.40912724f, 6.3921325e-6f, 0.00078074745f, 7.635564e-5f,
        -3.5043424e-5f, -0.0032332325f, 0.0010800008f
    },
    {
        -0.022033181f, -3.2593884f, 0.44682774f, 5.632134e-6f, 0.00067363575f, 4.8708836e-5f,
        -2.5808138e-5f, -0.0022306344f, 0.00089157687f
    },
    {
        -0.025815148f, -3.4508433f, 0.48056623f, 4.8790935e-6f, 0.0005722309f, 2.8765433e-5f,
        -1.737478e-5f, -0.0013462692f, 0.00071806414f
    },
    {
        -0.029122623f, -3.6005034f, 0.50943285f, 4.146272e-6f, 0.00047743562f, 1.48751715e-5f,
        -9.87411e-6f, -0.00058648956f, 0.00056086865f
    },
    {
        -0.03184724f, -3.6989408f, 0.5323191f, 3.446287e-6f, 0.00039006383f, 5.6686604e-6f,
        -3.4196257e-6f, 4.3858792e-5f, 0.0004211709f
    },
    {
        -0.033856984f, -3.7346704f, 0.54787475f, 2.7908982e-6f, 0.00031082818f, 1.0437248e-8f,
        1.8962203e-6f, 0.00054176484f, 0.0002998959f
    },
    {
        -0.034991052f, -3.6937022f, 0.5544549f, 2.1907645e-6f, 0.0002403236f, -3.0388371e-6f,
        6.006617e-6f, 0.0009064515f, 0.00019767327f
    },
    {
        -0.03505356f, -3.558996f, 0.55005604f, 1.6551564e-6f, 0.0001790062f, -4.252527e-6f,
        8.875996e-6f, 0.0011398622f, 0.00011478589f
    },
    {
        -0.033805896f, -3.3097937f, 0.5322375f, 1.1916148e-6f, 0.00012716674f, -4.2616934e-6f,
        1.05068575e-5f, 0.0012472541f, 5.110512e-5f
    },
    {
        -0.030957418f, -2.9208121f, 0.4980265f, 8.0554054e-7f, 8.489782e-5f, -3.5732144e-6f,
        1.0948071e-5f, 0.0012379196f, 6.0097145e-6f
    },
    {
        -0.026154097f, -2.3612545f, 0.44380194f, 4.997024e-7f, 5.2053034e-5f, -2.5830543e-6f,
        1.0305001e-5f, 0.001126067f, -2.1714352e-5f
    },
    {
        -0.018964706f, -1.5936081f, 0.36515307f, 2.736415e-7f, 2.8197031e-5f, -1.5852087e-6f,
        8.75183e-6f, 0.0009318922f, -3.3997258e-5f
    },
    {
        -0.008863986f, -0.5721818f, 0.25670746f, 1.2294902e-7f, 1.2544196e-5f, -7.7666454e-7f,
        6.5465706e-6f, 0.0006828838f, -3.363668e-5f
    },
    {
        0.0047878516f, 0.7586782f, 0.1119212f, 3.839108e-8f, 3.883658e-6f, -2.5857727e-7f,
        4.049349e-6f, 0.00041541405f, -2.448297e-5f
    },
    {
        0.022770094f, 2.46676f, -0.07717642f, 4.8439404e-9f, 4.8770215e-7f, -3.3704527e-8f,
        1.744677e-6f, 0.0001766756f, -1.1665484e-5f
    }
};

/* The bits of a number. */
typedef union {
    float value;
    uint32_t bits;
} motor_known_start_f32_cell_t;

/* The bits of a number. */
static uint32_t motor_known_start_f32_to_bits(float x)
{
    motor_known_start_f32_cell_t cell;
    cell.value = x;
    return cell.bits;
}

/* The bit of the sign. */
#define MOTOR_KNOWN_START_SIGN_F32 UINT32_C(0x80000000)

/* The bits of the largest magnitude. */
#define MOTOR_KNOWN_START_MAGNITUDE_F32 UINT32_C(0x7FFFFFFF)

/* The bits of infinity. */
#define MOTOR_KNOWN_START_INFINITY_F32 UINT32_C(0x7F800000)

/* The bits of the only NaN that is returned. */
#define MOTOR_KNOWN_START_NAN_F32 UINT32_C(0x7FC00000)

/* The number with these bits. */
static float motor_known_start_f32_from_bits(uint32_t bits)
{
    motor_known_start_f32_cell_t cell;
    cell.bits = bits;
    return cell.value;
}

/* The number significand / 2^63 * 2^exponent, with the top bit of the significand set. */
typedef struct {
    uint64_t significand;
    int32_t exponent;
} motor_known_start_scaled_t;

/* A number with a sign. */
typedef struct {
    motor_known_start_scaled_t magnitude;
    int negative;
} motor_known_start_signed_t;

/* The angle quadrant * pi/2 + rest. */
typedef struct {
    motor_known_start_signed_t rest;
    uint32_t quadrant;
} motor_known_start_turned_t;

/* Attaches a sign. */
static motor_known_start_signed_t motor_known_start_signed(motor_known_start_scaled_t magnitude, int negative)
{
    motor_known_start_signed_t result;
    result.magnitude = magnitude;
    result.negative = negative;
    return result;
}

/* A number below 1 as fixed point with 64 fraction bits. */
static uint64_t motor_known_start_fraction(motor_known_start_scaled_t a)
{
    const int32_t shift = -1 - a.exponent;
    if (shift > 63) {
        return 0;
    }
    return a.significand >> shift;
}

/* The upper half of the product, at most 2 too small. */
static uint64_t motor_known_start_mul_high(uint64_t a, uint64_t b)
{
    const uint64_t a_high = a >> 32;
    const uint64_t a_low = a & 0xFFFFFFFFu;
    const uint64_t b_high = b >> 32;
    const uint64_t b_low = b & 0xFFFFFFFFu;
    const uint64_t cross = ((a_high * b_low) >> 32) + ((a_low * b_high) >> 32);
    return a_high * b_high + cross;
}

/* The square of a number below 1 as fixed point with 64 fraction bits. */
static uint64_t motor_known_start_squared_fraction(motor_known_start_scaled_t a)
{
    const uint64_t x = motor_known_start_fraction(a);
    return motor_known_start_mul_high(x, x);
}

/* Makes a number of a significand that has its top bit set. */
static motor_known_start_scaled_t motor_known_start_scaled(uint64_t significand, int32_t exponent)
{
    motor_known_start_scaled_t result;
    result.significand = significand;
    result.exponent = exponent;
    return result;
}

/* Makes a number of a significand of at least 2^62. */
static motor_known_start_scaled_t motor_known_start_settled(uint64_t significand, int32_t exponent)
{
    if ((significand >> 63) == 0) {
        return motor_known_start_scaled(significand << 1, exponent - 1);
    }
    return motor_known_start_scaled(significand, exponent);
}

/* (1 - cos(r)) / r^2 in powers of -r^2. */
static const uint64_t MOTOR_KNOWN_START_COSINE[8] = {
    UINT64_C(0x8000000000000000), UINT64_C(0x0AAAAAAAAAAAAAA8), UINT64_C(0x005B05B05B05B02B),
    UINT64_C(0x0001A01A01A01865), UINT64_C(0x0000049F93EDD666), UINT64_C(0x00000008F76C6243),
    UINT64_C(0x000000000C9C9706), UINT64_C(0x00000000000D551B)};

/* cos(r) for 0 < r <= pi/4, relative error below 2^-60. */
static motor_known_start_scaled_t motor_known_start_cosine(motor_known_start_scaled_t r)
{
    const uint64_t z = motor_known_start_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = MOTOR_KNOWN_START_COSINE[6] - ((MOTOR_KNOWN_START_COSINE[7] * z_high) >> 32);
    const uint64_t c5 = MOTOR_KNOWN_START_COSINE[5] - ((tail * z_high) >> 32);
    const uint64_t c4 = MOTOR_KNOWN_START_COSINE[4] - motor_known_start_mul_high(c5, z);
    const uint64_t c3 = MOTOR_KNOWN_START_COSINE[3] - motor_known_start_mul_high(c4, z);
    const uint64_t c2 = MOTOR_KNOWN_START_COSINE[2] - motor_known_start_mul_high(c3, z);
    const uint64_t c1 = MOTOR_KNOWN_START_COSINE[1] - motor_known_start_mul_high(c2, z);
    const uint64_t c0 = MOTOR_KNOWN_START_COSINE[0] - motor_known_start_mul_high(c1, z);
    return motor_known_start_settled((UINT64_C(1) << 63) - (motor_known_start_mul_high(c0, z) >> 1), 0);
}

/* (1 - sin(r) / r) / r^2 in powers of -r^2. */
static const uint64_t MOTOR_KNOWN_START_SINE[7] = {
    UINT64_C(0x2AAAAAAAAAAAAAA6), UINT64_C(0x0222222222222160), UINT64_C(0x000D00D00D00C575),
    UINT64_C(0x00002E3BC74A673D), UINT64_C(0x0000006B9914A637), UINT64_C(0x00000000B090498C),
    UINT64_C(0x0000000000D552BC)};

/* sin(r) for 0 < r <= pi/4, relative error below 2^-60. */
static motor_known_start_scaled_t motor_known_start_sine(motor_known_start_scaled_t r)
{
    const uint64_t z = motor_known_start_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = MOTOR_KNOWN_START_SINE[5] - ((MOTOR_KNOWN_START_SINE[6] * z_high) >> 32);
    const uint64_t c4 = MOTOR_KNOWN_START_SINE[4] - ((tail * z_high) >> 32);
    const uint64_t c3 = MOTOR_KNOWN_START_SINE[3] - motor_known_start_mul_high(c4, z);
    const uint64_t c2 = MOTOR_KNOWN_START_SINE[2] - motor_known_start_mul_high(c3, z);
    const uint64_t c1 = MOTOR_KNOWN_START_SINE[1] - motor_known_start_mul_high(c2, z);
    const uint64_t c0 = MOTOR_KNOWN_START_SINE[0] - motor_known_start_mul_high(c1, z);
    const uint64_t lost = motor_known_start_mul_high(r.significand, motor_known_start_mul_high(c0, z));
    return motor_known_start_settled(r.significand - lost, r.exponent);
}

/* The sine of an angle. */
static motor_known_start_signed_t motor_known_start_sine_at(motor_known_start_turned_t angle)
{
    const int back = (angle.quadrant & 2) != 0;
    if ((angle.quadrant & 1) != 0) {
        return motor_known_start_signed(motor_known_start_cosine(angle.rest.magnitude), back);
    }
    return motor_known_start_signed(motor_known_start_sine(angle.rest.magnitude), back != angle.rest.negative);
}

/* Makes an angle of its parts. */
static motor_known_start_turned_t motor_known_start_turned(motor_known_start_signed_t rest, uint32_t quadrant)
{
    motor_known_start_turned_t result;
    result.rest = rest;
    result.quadrant = quadrant;
    return result;
}

/* The number of zero bits above the highest one bit; x is not 0. */
static int32_t motor_known_start_leading_zeros(uint64_t x)
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
static motor_known_start_scaled_t motor_known_start_normalised(uint64_t significand, int32_t exponent)
{
    const int32_t shift = motor_known_start_leading_zeros(significand);
    return motor_known_start_scaled(significand << shift, exponent - shift);
}

/* The finite positive number with these bits, not 0; exact. */
static motor_known_start_scaled_t motor_known_start_unpacked_f32(uint32_t magnitude)
{
    const int32_t field = (int32_t)(magnitude >> 23);
    const uint64_t digits = (uint64_t)magnitude << 40;
    if (field == 0) {
        return motor_known_start_normalised(digits, -126);
    }
    return motor_known_start_scaled(digits | (UINT64_C(1) << 63), field - 127);
}

/* 2/pi after 32 zero bits. */
static const uint32_t MOTOR_KNOWN_START_TWO_OVER_PI_F32[9] = {
    UINT32_C(0x00000000), UINT32_C(0xA2F9836E), UINT32_C(0x4E441529),
    UINT32_C(0xFC2757D1), UINT32_C(0xF534DDC0), UINT32_C(0xDB629599),
    UINT32_C(0x3C439041), UINT32_C(0xFE5163AB), UINT32_C(0xDEBBC561)};

/* 32 bits of 2/pi from bit 32 slot + shift on. */
static uint64_t motor_known_start_window_f32(uint32_t slot, uint32_t shift)
{
    const uint64_t first = (uint64_t)(MOTOR_KNOWN_START_TWO_OVER_PI_F32[slot]);
    const uint64_t second = (uint64_t)(MOTOR_KNOWN_START_TWO_OVER_PI_F32[slot + 1]);
    return (((first << 32) | second) >> (32 - shift)) & 0xFFFFFFFFu;
}

/* a b, relative error below 2^-60. */
static motor_known_start_scaled_t motor_known_start_product(motor_known_start_scaled_t a, motor_known_start_scaled_t b)
{
    return motor_known_start_settled(motor_known_start_mul_high(a.significand, b.significand),
                            a.exponent + b.exponent + 1);
}

/* pi with 62 fraction bits; as a significand also pi/2 and pi/4. */
#define MOTOR_KNOWN_START_PI UINT64_C(0xC90FDAA22168C235)

/* The angle of (high, low) / 2^126 quarter turns, its rest exact to 2^-60 of itself. */
static motor_known_start_turned_t motor_known_start_turned_from_quarters(uint64_t high, uint64_t low)
{
    const uint64_t eighths = high >> 61;
    const int negative = (eighths & 1) != 0;
    uint64_t upper = (high << 2) | (low >> 62);
    uint64_t lower = low << 2;
    if (negative) {
        upper = (lower == 0) ? (UINT64_C(0) - upper) : UINT64_MAX - upper;
        lower = (UINT64_C(0) - lower);
    }
    const int32_t shift = motor_known_start_leading_zeros(upper | 1);
    const uint64_t significand = (upper << shift) | ((lower >> 1) >> (63 - shift));
    const motor_known_start_signed_t rest = motor_known_start_signed(
        motor_known_start_product(motor_known_start_scaled(significand, -1 - shift), motor_known_start_scaled(MOTOR_KNOWN_START_PI, 0)),
        negative);
    return motor_known_start_turned(rest, (uint32_t)(((eighths + 1) >> 1) & 3));
}

/* The angle with these bits, positive and finite, its rest exact to 2^-38 of itself. */
static motor_known_start_turned_t motor_known_start_reduce_f32(uint32_t magnitude)
{
    if (magnitude <= 0x3F490FDAu) {
        return motor_known_start_turned(motor_known_start_signed(motor_known_start_unpacked_f32(magnitude), 0), 0);
    }
    const uint64_t digits = (uint64_t)((magnitude & 0x007FFFFFu) | 0x00800000u);
    const uint32_t start = (magnitude >> 23) - 120;
    const uint32_t slot = start >> 5;
    const uint32_t shift = start & 31;
    const uint64_t upper = (motor_known_start_window_f32(slot, shift) * digits) << 32;
    const uint64_t middle = motor_known_start_window_f32(slot + 1, shift) * digits;
    const uint64_t lower = motor_known_start_window_f32(slot + 2, shift) * digits;
    return motor_known_start_turned_from_quarters(((upper + middle) + (lower >> 32)), lower << 32);
}

/* x rounded to the nearest, ties to even, with subnormals and overflow, and the sign put in. */
static float motor_known_start_rounded_f32(uint32_t sign, motor_known_start_scaled_t x)
{
    const int32_t field = x.exponent + 127;
    if (field >= 255) {
        return motor_known_start_f32_from_bits(sign | MOTOR_KNOWN_START_INFINITY_F32);
    }
    const int32_t shift = (field > 0) ? 40 : 41 - field;
    if (shift > 63) {
        const int least = shift == 64 && x.significand > (UINT64_C(1) << 63);
        return motor_known_start_f32_from_bits(least ? sign + 1 : sign);
    }
    const uint64_t kept = x.significand >> shift;
    const uint64_t rest = x.significand - (kept << shift);
    const uint64_t half = UINT64_C(1) << (shift - 1);
    const uint64_t odd = kept & 1;
    const uint64_t up = (rest + odd > half) ? 1 : 0;
    const uint32_t base = (field > 0) ? ((uint32_t)(field - 1)) << 23 : 0;
    return motor_known_start_f32_from_bits(sign | (base + ((uint32_t)(kept + up))));
}

/* The sign bit of a negative number, else 0. */
static uint32_t motor_known_start_sign_f32(int negative)
{
    if (negative) {
        return MOTOR_KNOWN_START_SIGN_F32;
    }
    return 0;
}

/* Sine of an angle in radians, the nearest float. */
static float motor_known_start_sin_f32(float x)
{
    const uint32_t bits = motor_known_start_f32_to_bits(x);
    const uint32_t magnitude = bits & MOTOR_KNOWN_START_MAGNITUDE_F32;
    if (magnitude >= MOTOR_KNOWN_START_INFINITY_F32) {
        return motor_known_start_f32_from_bits(MOTOR_KNOWN_START_NAN_F32);
    }
    if (magnitude == 0) {
        return x;
    }
    const motor_known_start_signed_t value = motor_known_start_sine_at(motor_known_start_reduce_f32(magnitude));
    return motor_known_start_rounded_f32((bits & MOTOR_KNOWN_START_SIGN_F32) ^ motor_known_start_sign_f32(value.negative),
                                value.magnitude);
}

/* What one part of a step hands to the next. */
typedef struct {
    float t10;
    uint32_t t11;
    float t14;
    float t21;
    float t32;
    uint32_t t39;
    float t61;
    float t75;
    float t89;
    uint32_t t90;
    float t164;
    float t166;
    float t168;
    float t188;
    float t190;
    float t192;
    motor_known_start_status t204;
    int flags[3]; /* t97, t98, t100 */
} motor_known_start_work;

/* Part 1 of a step. */
static void motor_known_start_part_1(motor_known_start_state *state, const motor_known_start_measurements *measurements, const motor_known_start_inputs *inputs, motor_known_start_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    const uint32_t t0 = state->newest;
    const uint32_t t1 = (t0 < 40U) ? t0 : 40U;
    const uint32_t t2 = state->count;
    const int t4 = 40U < t2;
    const float t5 = measurements->y;
    const int t6 = (-1e35f <= t5) && (t5 <= 1e35f);
    const float t7 = inputs->u;
    const int t8 = (-1e35f <= t7) && (t7 <= 1e35f);
    const float t9 = state->u[t1];
    work->t10 = t8 ? t7 : t9;

    /* prediction, for a sample that is missing */
    work->t11 = (t1 < 40U) ? (t1 + 1U) : 0U;
    const float t12 = state->ahead_y;
    work->t14 = 9.516694e-8f * work->t10;
    const float t15 = t12 + work->t14;
    const float t16 = state->y[t1];
    const int t17 = (-1e35f <= t15) && (t15 <= 1e35f);
    const int t18 = t4 && t17;
    const float t19 = t18 ? t15 : t16;
    const float t20 = t6 ? t5 : t19;
    work->t21 = motor_known_start_sin_f32(t20);
    const float t22 = state->sin_q[t1];
    const float t23 = work->t21 - t22;
    const float t25 = -5.8317214e-6f * t23;
    const float t26 = t15 + t25;
    const int t27 = (-1e35f <= t26) && (t26 <= 1e35f);
    const int t28 = t4 && t27;
    const float t29 = t28 ? t26 : t16;
    const int t30 = t6 || t28;
    const int t31 = !t30;
    work->t32 = t6 ? t5 : t29;

    /* how much of the window is good */
    const uint32_t t35 = (t2 < 41U) ? (t2 + 1U) : 41U;
    const uint32_t t36 = t31 ? 0U : t35;
    const uint32_t t37 = t8 ? t35 : 1U;
    const uint32_t t38 = t6 ? t37 : 0U;
    work->t39 = t4 ? t36 : t38;
    state->count = work->t39;
    const uint32_t t40 = state->coasting;
    const uint32_t t41 = (t40 > 0U) ? (t40 - 1U) : 0U;
    const uint32_t t42 = t8 ? t41 : 40U;
    const uint32_t t44 = t6 ? t42 : 41U;
    state->coasting = t44;
}

/* Part 2 of a step. */
static void motor_known_start_part_2(motor_known_start_state *state, motor_known_start_work *work)
{
    /* from the given state, until there is an estimate */
    const uint32_t t45 = ((work->t11 >= 1U) && (work->t11 < 41U)) ? (work->t11 - 1U) : 40U;
    const float t46 = state->sin_q[t45];
    const float t47 = state->given_q;
    const float t48 = state->given_dq;
    const float t49 = state->given_i;
    const float t51 = 0.0009994135f * t48;
    const float t53 = 7.021338e-6f * t49;
    const float t55 = -1.1661682e-5f * t46;
    const float t56 = -5.8317214e-6f * work->t21;
    const float t57 = t47 + t51;
    const float t58 = t57 + t53;
    const float t59 = t55 + work->t14;
    const float t60 = t59 + t56;
    work->t61 = t58 + t60;
    const float t63 = 0.998745f * t48;
    const float t65 = 0.0135869365f * t49;
    const float t67 = -0.017486073f * t46;
    const float t69 = 0.00028085354f * work->t10;
    const float t71 = -0.017493403f * work->t21;
    const float t72 = t63 + t65;
    const float t73 = t67 + t69;
    const float t74 = t73 + t71;
    work->t75 = t72 + t74;
    const float t77 = -0.032970965f * t48;
    const float t79 = 0.81849164f * t49;
    const float t81 = 0.0003942745f * t46;
    const float t83 = 0.036250554f * work->t10;
    const float t85 = 0.00020207113f * work->t21;
    const float t86 = t77 + t79;
    const float t87 = t81 + t83;
    const float t88 = t87 + t85;
    work->t89 = t86 + t88;
    work->t90 = state->given;
    const int t91 = 0U < work->t90;
    const int t92 = (-1e35f <= work->t61) && (work->t61 <= 1e35f);
    const int t93 = t91 && t92;
    const int t94 = (-1e35f <= work->t75) && (work->t75 <= 1e35f);
    const int t95 = t93 && t94;
    const int t96 = (-1e35f <= work->t89) && (work->t89 <= 1e35f);
    work->flags[0] = t95 && t96;
    work->flags[1] = 1U < work->t90;
    work->flags[2] = 2U < work->t90;

    /* into the window */
    state->newest = work->t11;
    state->y[work->t11] = work->t32;
    state->u[work->t11] = work->t10;
    state->sin_q[work->t11] = work->t21;
}

/* Part 3 of a step. */
static void motor_known_start_part_3(motor_known_start_state *state, motor_known_start_work *work)
{
    /* the sums over the window, newest sample first */
    float t102 = 0.0f;
    float t103 = 0.0f;
    float t104 = 0.0f;
    float t105 = 0.0f;
    float t106 = 0.0f;
    float t107 = 0.0f;
    float t108 = 0.0f;
    float t109 = 0.0f;
    float t110 = 0.0f;
    uint32_t t111 = work->t11;
    for (uint32_t row = 0U; row < 40U; ++row) {
        const float *const gains = MOTOR_KNOWN_START_WINDOW[row];
        const float t112 = state->y[t111];
        const float t113 = gains[0];
        const float t114 = t113 * t112;
        const float t115 = t102 + t114;
        const float t116 = gains[1];
        const float t117 = t116 * t112;
        const float t118 = t105 + t117;
        const float t119 = gains[2];
        const float t120 = t119 * t112;
        const float t121 = t108 + t120;
        const float t122 = state->u[t111];
        const float t123 = gains[3];
        const float t124 = t123 * t122;
        const float t125 = t103 + t124;
        const float t126 = gains[4];
        const float t127 = t126 * t122;
        const float t128 = t106 + t127;
        const float t129 = gains[5];
        const float t130 = t129 * t122;
        const float t131 = t109 + t130;
        const float t132 = state->sin_q[t111];
        const float t133 = gains[6];
        const float t134 = t133 * t132;
        const float t135 = t104 + t134;
        const float t136 = gains[7];
        const float t137 = t136 * t132;
        const float t138 = t107 + t137;
        const float t139 = gains[8];
        const float t140 = t139 * t132;
        const float t141 = t110 + t140;
        const uint32_t t142 = ((t111 >= 1U) && (t111 < 41U)) ? (t111 - 1U) : 40U;
        t102 = t115;
        t103 = t125;
        t104 = t135;
        t105 = t118;
        t106 = t128;
        t107 = t138;
        t108 = t121;
        t109 = t131;
        t110 = t141;
        t111 = t142;
    }
    const float t143 = state->y[t111];
    const float t145 = 0.04603194f * t143;
    const float t146 = t102 + t145;
    const float t148 = 4.634631f * t143;
    const float t149 = t105 + t148;
    const float t151 = -0.32029396f * t143;
    const float t152 = t108 + t151;
    const float t153 = state->sin_q[t111];
    const float t155 = 2.685792e-7f * t153;
    const float t156 = t104 + t155;
    const float t158 = 2.7041346e-5f * t153;
    const float t159 = t107 + t158;
    const float t161 = -1.8687958e-6f * t153;
    const float t162 = t110 + t161;
    const float t163 = t146 + t103;
    work->t164 = t163 + t156;
    const float t165 = t149 + t106;
    work->t166 = t165 + t159;
    const float t167 = t152 + t109;
    work->t168 = t167 + t162;

    /* the next measurement, as far as it is known */
    const float t169 = 0.0009994135f * work->t166;
    const float t170 = 7.021338e-6f * work->t168;
    const float t172 = -1.7493403e-5f * work->t21;
    const float t173 = work->t164 + t169;
    const float t174 = t173 + t170;
    const float t175 = t174 + t172;
    state->ahead_y = t175;
}

/* Part 4 of a step. */
static void motor_known_start_part_4(motor_known_start_state *state, motor_known_start_work *work)
{
    /* the estimate; until the window is full, the start */
    const int t176 = 40U < work->t39;
    const int t177 = !t176;
    const int t178 = work->flags[0] && t177;
    const int t179 = t178 && work->flags[1];
    const int t180 = t178 && work->flags[2];
    const uint32_t t181 = (work->t90 > 0U) ? (work->t90 - 1U) : 0U;
    const uint32_t t182 = work->flags[2] ? t181 : work->t90;
    const uint32_t t183 = t178 ? t182 : 0U;
    state->given = t183;
    const float t184 = t178 ? work->t61 : 0.0f;
    state->given_q = t184;
    const float t185 = t178 ? work->t75 : 0.0f;
    state->given_dq = t185;
    const float t186 = t178 ? work->t89 : 0.0f;
    state->given_i = t186;
    const float t187 = t176 ? work->t164 : work->t32;
    work->t188 = t178 ? work->t61 : t187;
    const float t189 = t176 ? work->t166 : 0.0f;
    work->t190 = t178 ? work->t75 : t189;
    const float t191 = t176 ? work->t168 : 0.0f;
    work->t192 = t178 ? work->t89 : t191;
    const uint32_t t193 = state->coasting;
    const int t194 = t193 == 0U;
    const int t195 = !t178;
    const int t196 = t195 && t176;
    const int t197 = t196 || t180;
    const int t198 = t197 && t194;
    const int t199 = t176 || t179;
    const motor_known_start_status t203 = t198 ? MOTOR_KNOWN_START_CONVERGED : MOTOR_KNOWN_START_COASTING;
    work->t204 = t199 ? t203 : MOTOR_KNOWN_START_CONVERGING;
}

void motor_known_start_init(motor_known_start_state *state)
{
    for (uint32_t slot = 0U; slot < 41U; ++slot) {
        state->y[slot] = 0.0f;
    }
    for (uint32_t slot = 0U; slot < 41U; ++slot) {
        state->u[slot] = 0.0f;
    }
    for (uint32_t slot = 0U; slot < 41U; ++slot) {
        state->sin_q[slot] = 0.0f;
    }
    state->newest = 40U;
    state->count = 0U;
    state->coasting = 0U;
    state->ahead_y = 0.0f;
    state->given_q = 0.0f;
    state->given_dq = 0.0f;
    state->given_i = 0.0f;
    state->given = 0U;
}

void motor_known_start_init_at(motor_known_start_state *state, const motor_known_start_estimate *estimate)
{
    motor_known_start_init(state);
    /* the given state */
    const int t205 = estimate->status == MOTOR_KNOWN_START_CONVERGED;
    const float t206 = estimate->q;
    const int t207 = (-1e35f <= t206) && (t206 <= 1e35f);
    const float t209 = t207 ? t206 : 0.0f;
    const float t210 = estimate->dq;
    const int t211 = (-1e35f <= t210) && (t210 <= 1e35f);
    const float t212 = t211 ? t210 : 0.0f;
    const float t213 = estimate->i;
    const int t214 = (-1e35f <= t213) && (t213 <= 1e35f);
    const float t215 = t214 ? t213 : 0.0f;
    const int t216 = t205 && t207;
    const int t217 = t216 && t211;
    const int t218 = t217 && t214;
    state->given_q = t209;
    state->given_dq = t212;
    state->given_i = t215;
    const uint32_t t221 = t218 ? 43U : 1U;
    state->given = t221;

    /* what it shows, and what that makes of the nonlinear terms */
    const int t223 = (-1e35f <= t209) && (t209 <= 1e35f);
    const float t224 = t223 ? t209 : 0.0f;
    state->y[40U] = t224;
    const float t225 = motor_known_start_sin_f32(t224);
    const int t226 = (-1e35f <= t225) && (t225 <= 1e35f);
    const float t227 = t226 ? t225 : 0.0f;
    state->sin_q[40U] = t227;
}

void motor_known_start_step(motor_known_start_state *state, const motor_known_start_measurements *measurements,
                            const motor_known_start_inputs *inputs, motor_known_start_estimate *estimate)
{
    motor_known_start_work work;
    motor_known_start_part_1(state, measurements, inputs, &work);
    motor_known_start_part_2(state, &work);
    motor_known_start_part_3(state, &work);
    motor_known_start_part_4(state, &work);

    estimate->q = work.t188;
    estimate->dq = work.t190;
    estimate->i = work.t192;
    estimate->status = work.t204;
}
