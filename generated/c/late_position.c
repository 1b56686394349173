/* late_position.c: Finite-time observer: Cart with a camera that is 40 ms late and a wheel counter that is not.
 *
 * Generated; late_position.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "late_position.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "late_position.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "late_position.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* weights by age, from age 0
 *   [0] position from camera
 *   [1] speed from camera
 *   [2] slope from camera
 *   [3] wheel from camera
 *   [4] position from wheel
 *   [5] speed from wheel
 *   [6] slope from wheel
 *   [7] wheel from wheel
 *   [8] position from force
 *   [9] speed from force
 *   [10] slope from force
 *   [11] wheel from force
 *   [12] position from tanh(20*wheel)
 *   [13] speed from tanh(20*wheel)
 *   [14] slope from tanh(20*wheel)
 *   [15] wheel from tanh(20*wheel)
 */
static const float LATE_POSITION_WINDOW[37][16] = {
    {
        0.047390148f, 0.13512354f, 0.39632303f, 0.12525287f, 0.0119850375f, 0.111759536f, 0.477297f,
        0.09847645f, 1.3441785e-5f, 0.003923384f, -0.0002590573f, 0.0004893101f, -4.430366e-6f,
        -0.0019739482f, 8.8529196e-5f, -0.00016721488f
    },
    {
        0.045536764f, 0.11808942f, 0.324395f, 0.11021525f, 0.011627435f, 0.10704156f, 0.4525815f,
        0.094475575f, 3.6174537e-5f, 0.0037343442f, -0.0009283456f, 0.0012382189f, -2.5558358e-5f,
        -0.003835473f, 0.0005657785f, -0.00089256896f
    },
    {
        0.043741114f, 0.10181705f, 0.25645748f, 0.09582357f, 0.011266964f, 0.10228581f, 0.42766824f,
        0.090442665f, 5.1321655e-5f, 0.0034797548f, -0.0018721084f, 0.0016906804f, -4.4271634e-5f,
        -0.0036114587f, 0.0013819889f, -0.0014853724f
    },
    {
        0.04200366f, 0.086312525f, 0.19254246f, 0.08208304f, 0.010903603f, 0.09749202f, 0.4025559f,
        0.08637749f, 6.1236475e-5f, 0.0031824491f, -0.0029898046f, 0.001928526f, -5.6634693e-5f,
        -0.0033338824f, 0.0024198906f, -0.0018246876f
    },
    {
        0.040324874f, 0.07158203f, 0.13268231f, 0.06899888f, 0.010537333f, 0.09265993f, 0.37724325f,
        0.08227983f, 6.6717024e-5f, 0.0028566404f, -0.0042148842f, 0.0020098726f, -6.436533e-5f,
        -0.0030215678f, 0.0035952737f, -0.0019803748f
    },
    {
        0.038705226f, 0.057631765f, 0.07690956f, 0.05657637f, 0.0101681305f, 0.08778933f,
        0.3517291f, 0.0781495f, 6.8156456e-5f, 0.0025125206f, -0.005498604f, 0.0019774472f,
        -6.772578e-5f, -0.0026856505f, 0.004853855f, -0.002001579f
    },
    {
        0.03714519f, 0.04446801f, 0.025257047f, 0.04482082f, 0.009795978f, 0.08287998f, 0.32601255f,
        0.0739863f, 6.659878e-5f, 0.0021600612f, -0.006797246f, 0.0018651296f, -6.7591245e-5f,
        -0.002336643f, 0.006148181f, -0.0019267843f
    },
    {
        0.035645243f, 0.03209708f, -0.022242125f, 0.03373758f, 0.009420856f, 0.07793174f,
        0.3000928f, 0.069790095f, 6.283706e-5f, 0.0018067886f, -0.00807788f, 0.0016981433f,
        -6.487408e-5f, -0.0019832335f, 0.0074401926f, -0.0017853271f
    },
    {
        0.03420587f, 0.02052534f, -0.065554604f, 0.02333206f, 0.009042747f, 0.07294446f, 0.2739694f,
        0.06556075f, 5.7477657e-5f, 0.00145841f, -0.009315613f, 0.0014952921f, -6.026941e-5f,
        -0.0016319951f, 0.008701174f, -0.0015990614f
    },
    {
        0.032827552f, 0.009759211f, -0.10464676f, 0.013609699f, 0.008661638f, 0.067918085f,
        0.24764237f, 0.061298218f, 5.098787e-5f, 0.0011192748f, -0.010491551f, 0.0012706151f,
        -5.4310658e-5f, -0.0012879225f, 0.0099093765f, -0.0013842909f
    },
    {
        0.03151079f, -0.00019483763f, -0.13948469f, 0.004575985f, 0.008277515f, 0.06285263f,
        0.22111215f, 0.05700249f, 4.373124e-5f, 0.0007927174f, -0.011591292f, 0.0010346152f,
        -4.7410733e-5f, -0.00095483335f, 0.01104826f, -0.0011531987f
    },
    {
        0.030256068f, -0.009330282f, -0.17003423f, -0.0037635497f, 0.0078903735f, 0.057748232f,
        0.19438006f, 0.052673668f, 3.5993668e-5f, 0.00048131138f, -0.012603812f, 0.0007951663f,
        -3.989249e-5f, -0.0006356636f, 0.012105193f, -0.00091490825f
    },
    {
        0.029063892f, -0.017640548f, -0.19626093f, -0.011403331f, 0.00750021f, 0.052605197f,
        0.16744837f, 0.048311982f, 2.8002763e-5f, 0.00018705687f, -0.013520635f, 0.00055818754f,
        -3.20113e-5f, -0.00033268656f, 0.013070482f, -0.00067626836f
    },
    {
        0.02793476f, -0.025119007f, -0.21813008f, -0.018337736f, 0.0071070325f, 0.04742403f,
        0.14032081f, 0.04391783f, 1.9942201e-5f, -8.848033e-5f, -0.014335225f, 0.00032814126f,
        -2.397179e-5f, -4.7675396e-5f, 0.013936665f, -0.00044243413f
    },
    {
        0.026869182f, -0.031758975f, -0.23560666f, -0.024561102f, 0.0067108576f, 0.042205546f,
        0.11300291f, 0.03949186f, 1.19623155e-5f, -0.00034406615f, -0.015042534f, 0.00010840251f,
        -1.5940204e-5f, 0.0002179773f, 0.014697983f, -0.00021729787f
    },
    {
        0.025867663f, -0.037553724f, -0.24865541f, -0.030067716f, 0.0063117184f, 0.036950946f,
        0.08550281f, 0.035035018f, 4.18795e-6f, -0.00057872245f, -0.015638668f, -9.846811e-5f,
        -8.053571e-6f, 0.00046317079f, 0.015349988f, -3.8079352e-6f
    },
    {
        0.024930721f, -0.04249646f, -0.25724074f, -0.034851823f, 0.0059096664f, 0.03166197f,
        0.057832062f, 0.030548701f, -3.2757407e-6f, -0.0007916715f, -0.016120652f, -0.00029052226f,
        -4.2647955e-7f, 0.00068703113f, 0.015889263f, 0.00019579557f
    },
    {
        0.024058875f, -0.04658034f, -0.26132685f, -0.038907617f, 0.0055047814f, 0.026341077f,
        0.03000687f, 0.026034884f, -1.0339024e-5f, -0.0009822953f, -0.01648624f, -0.00046627483f,
        6.8439317e-6f, 0.00088886323f, 0.016313208f, 0.00037980656f
    },
    {
        0.023252647f, -0.04979847f, -0.26087752f, -0.04222925f, 0.005097179f, 0.020991707f,
        0.0020497157f, 0.021496331f, -1.6924454e-5f, -0.0011501064f, -0.016733808f, -0.0006245941f,
        1.3674296e-5f, 0.0010681164f, 0.016619898f, 0.00054692436f
    },
    {
        0.022512564f, -0.05214389f, -0.2558564f, -0.044810824f, 0.004687025f, 0.015618627f,
        -0.026008438f, 0.016936874f, -2.2964601e-5f, -0.0012947277f, -0.016862255f, -0.0007646214f,
        1.9992334e-5f, 0.00122436f, 0.016807977f, 0.00069615955f
    },
    {
        0.021839159f, -0.05360959f, -0.24622673f, -0.046646394f, 0.004274551f, 0.010228377f,
        -0.05412517f, 0.012361786f, -2.8400413e-5f, -0.0014158783f, -0.016870957f, -0.000885713f,
        2.573492e-5f, 0.0013572655f, 0.016876586f, 0.00082676497f
    },
    {
        0.021232964f, -0.054188512f, -0.2319515f, -0.047729973f, 0.003860079f, 0.0048299134f,
        -0.08224261f, 0.007778284f, -3.31801e-5f, -0.0015133664f, -0.016759742f, -0.0009873982f,
        3.0846706e-5f, 0.0014665974f, 0.016825326f, 0.0009381862f
    },
    {
        0.020694522f, -0.053873528f, -0.2129934f, -0.048055515f, 0.0034440537f, -0.0005645558f,
        -0.11028199f, 0.0031962132f, -3.7258385e-5f, -0.0015870855f, -0.016528886f, -0.0010693514f,
        3.527921e-5f, 0.0015522065f, 0.016654247f, 0.0010300272f
    },
    {
        0.020224376f, -0.052657455f, -0.18931481f, -0.047616933f, 0.0030270836f, -0.0059384317f,
        -0.13813637f, -0.0013710342f, -4.0596155e-5f, -0.0016370169f, -0.01617914f, -0.0011313744f,
        3.8990253e-5f, 0.0016140296f, 0.016363865f, 0.0011020269f
    },
    {
        0.019823074f, -0.05053306f, -0.16087781f, -0.04640809f, 0.0026099996f, -0.011269185f,
        -0.16566072f, -0.005905276f, -4.3160308e-5f, -0.001663235f, -0.015711784f, -0.0011733865f,
        4.194372e-5f, 0.0016520942f, 0.015955186f, 0.0011540465f
    },
    {
        0.01949117f, -0.047493048f, -0.1276442f, -0.0444228f, 0.0021939327f, -0.01652628f,
        -0.1926587f, -0.010381867f, -4.4923992e-5f, -0.0016659207f, -0.015128709f, -0.0011954245f,
        4.410962e-5f, 0.0016665265f, 0.0154297855f, 0.0011860637f
    },
    {
        0.01922922f, -0.04353006f, -0.08957544f, -0.04165483f, 0.001780419f, -0.021668378f,
        -0.21886455f, -0.014767431f, -4.5867095e-5f, -0.0016453788f, -0.014432539f, -0.0011976494f,
        4.5464403e-5f, 0.0016575677f, 0.014789913f, 0.0011981766f
    },
    {
        0.019037789f, -0.03863669f, -0.04663269f, -0.038097885f, 0.0013715415f, -0.026639547f,
        -0.24391888f, -0.019016812f, -4.597709e-5f, -0.0016020645f, -0.01362681f, -0.0011803618f,
        4.5991674e-5f, 0.001625595f, 0.014038629f, 0.0011906143f
    },
    {
        0.01891744f, -0.032805454f, 0.0012231905f, -0.03374563f, 0.00097012136f, -0.031364165f,
        -0.26733598f, -0.023068946f, -4.5250345e-5f, -0.0015366211f, -0.012716207f, -0.001144028f,
        4.5683217e-5f, 0.0015711543f, 0.013180021f, 0.0011637576f
    },
    {
        0.018868744f, -0.026028829f, 0.054031666f, -0.028591685f, 0.00057997653f, -0.035740025f,
        -0.28845948f, -0.026841301f, -4.3693937e-5f, -0.0014499307f, -0.011706895f, -0.0010893178f,
        4.4540582e-5f, 0.0014950035f, 0.012219484f, 0.001118171f
    },
    {
        0.018892279f, -0.018299216f, 0.111832514f, -0.022629602f, 0.0002062703f, -0.03962903f,
        -0.30640274f, -0.030222358f, -4.1328225e-5f, -0.0013431839f, -0.010606972f, -0.0010171583f,
        4.2577245e-5f, 0.0013981721f, 0.011164107f, 0.0010546476f
    },
    {
        0.018988624f, -0.009608964f, 0.17466584f, -0.015852893f, -0.00014401769f, -0.042844646f,
        -0.31996816f, -0.03306148f, -3.819033e-5f, -0.0012179739f, -0.009427068f, -0.0009288085f,
        3.982161e-5f, 0.001282043f, 0.010023195f, 0.00097427337f
    },
    {
        0.019158363f, 4.9644023e-5f, 0.24257207f, -0.008255016f, -0.0004614561f, -0.04513494f,
        -0.32753855f, -0.0351552f, -3.433891e-5f, -0.001076425f, -0.008181175f, -0.0008259615f,
        3.632112e-5f, 0.0011484631f, 0.008808983f, 0.0008785148f
    },
    {
        0.019402089f, 0.010684387f, 0.31559193f, 0.00017062674f, -0.00073330407f, -0.046159714f,
        -0.32693028f, -0.036228776f, -2.9860626e-5f, -0.0009213649f, -0.0068877516f,
        -0.00071088294f, 3.2147807e-5f, 0.0009998918f, 0.007537588f, 0.0007693378f
    },
    {
        0.01972039f, 0.022303104f, 0.39376652f, 0.009430683f, -0.00094235316f, -0.045459613f,
        -0.31519493f, -0.03591122f, -2.487886e-5f, -0.0007565588f, -0.0055712247f, -0.00058659894f,
        2.7405877e-5f, 0.0008396033f, 0.0062303124f, 0.0006493706f
    },
    {
        0.02011387f, 0.0349137f, 0.4771372f, 0.019531855f, -0.0010653642f, -0.042414445f,
        -0.28835198f, -0.03370165f, -1.956555e-5f, -0.0005870246f, -0.0042640157f, -0.00045715057f,
        2.2241858e-5f, 0.0006719595f, 0.004915388f, 0.00052212266f
    },
    {
        0.02058313f, 0.04852414f, 0.5657458f, 0.030480897f, -0.0010709576f, -0.036186896f,
        -0.24102752f, -0.028923817f, -1.4157147e-5f, -0.00041945893f, -0.003009272f,
        -0.00032793745f, 1.685844e-5f, 0.000502777f, 0.0036303396f, 0.0003922817f
    }
};

/* The bits of a number. */
typedef union {
    float value;
    uint32_t bits;
} late_position_f32_cell_t;

/* The bits of a number. */
static uint32_t late_position_f32_to_bits(float x)
{
    late_position_f32_cell_t cell;
    cell.value = x;
    return cell.bits;
}

/* The bit of the sign. */
#define LATE_POSITION_SIGN_F32 UINT32_C(0x80000000)

/* The bits of the largest magnitude. */
#define LATE_POSITION_MAGNITUDE_F32 UINT32_C(0x7FFFFFFF)

/* The bits of infinity. */
#define LATE_POSITION_INFINITY_F32 UINT32_C(0x7F800000)

/* The bits of the only NaN that is returned. */
#define LATE_POSITION_NAN_F32 UINT32_C(0x7FC00000)

/* The bits of 1. */
#define LATE_POSITION_ONE_F32 UINT32_C(0x3F800000)

/* The number with these bits. */
static float late_position_f32_from_bits(uint32_t bits)
{
    late_position_f32_cell_t cell;
    cell.bits = bits;
    return cell.value;
}

/* The number significand / 2^63 * 2^exponent, with the top bit of the significand set. */
typedef struct {
    uint64_t significand;
    int32_t exponent;
} late_position_scaled_t;

/* A number below 1 as fixed point with 64 fraction bits. */
static uint64_t late_position_fraction(late_position_scaled_t a)
{
    const int32_t shift = -1 - a.exponent;
    if (shift > 63) {
        return 0;
    }
    return a.significand >> shift;
}

/* The upper half of the product, at most 2 too small. */
static uint64_t late_position_mul_high(uint64_t a, uint64_t b)
{
    const uint64_t a_high = a >> 32;
    const uint64_t a_low = a & 0xFFFFFFFFu;
    const uint64_t b_high = b >> 32;
    const uint64_t b_low = b & 0xFFFFFFFFu;
    const uint64_t cross = ((a_high * b_low) >> 32) + ((a_low * b_high) >> 32);
    return a_high * b_high + cross;
}

/* The square of a number below 1 as fixed point with 64 fraction bits. */
static uint64_t late_position_squared_fraction(late_position_scaled_t a)
{
    const uint64_t x = late_position_fraction(a);
    return late_position_mul_high(x, x);
}

/* Makes a number of a significand that has its top bit set. */
static late_position_scaled_t late_position_scaled(uint64_t significand, int32_t exponent)
{
    late_position_scaled_t result;
    result.significand = significand;
    result.exponent = exponent;
    return result;
}

/* Makes a number of a significand of at least 2^62. */
static late_position_scaled_t late_position_settled(uint64_t significand, int32_t exponent)
{
    if ((significand >> 63) == 0) {
        return late_position_scaled(significand << 1, exponent - 1);
    }
    return late_position_scaled(significand, exponent);
}

/* The number of zero bits above the highest one bit; x is not 0. */
static int32_t late_position_leading_zeros(uint64_t x)
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
static late_position_scaled_t late_position_normalised(uint64_t significand, int32_t exponent)
{
    const int32_t shift = late_position_leading_zeros(significand);
    return late_position_scaled(significand << shift, exponent - shift);
}

/* The finite positive number with these bits, not 0; exact. */
static late_position_scaled_t late_position_unpacked_f32(uint32_t magnitude)
{
    const int32_t field = (int32_t)(magnitude >> 23);
    const uint64_t digits = (uint64_t)magnitude << 40;
    if (field == 0) {
        return late_position_normalised(digits, -126);
    }
    return late_position_scaled(digits | (UINT64_C(1) << 63), field - 127);
}

/* a b, relative error below 2^-60. */
static late_position_scaled_t late_position_product(late_position_scaled_t a, late_position_scaled_t b)
{
    return late_position_settled(late_position_mul_high(a.significand, b.significand),
                            a.exponent + b.exponent + 1);
}

/* x rounded to the nearest, ties to even, with subnormals and overflow, and the sign put in. */
static float late_position_rounded_f32(uint32_t sign, late_position_scaled_t x)
{
    const int32_t field = x.exponent + 127;
    if (field >= 255) {
        return late_position_f32_from_bits(sign | LATE_POSITION_INFINITY_F32);
    }
    const int32_t shift = (field > 0) ? 40 : 41 - field;
    if (shift > 63) {
        const int least = shift == 64 && x.significand > (UINT64_C(1) << 63);
        return late_position_f32_from_bits(least ? sign + 1 : sign);
    }
    const uint64_t kept = x.significand >> shift;
    const uint64_t rest = x.significand - (kept << shift);
    const uint64_t half = UINT64_C(1) << (shift - 1);
    const uint64_t odd = kept & 1;
    const uint64_t up = (rest + odd > half) ? 1 : 0;
    const uint32_t base = (field > 0) ? ((uint32_t)(field - 1)) << 23 : 0;
    return late_position_f32_from_bits(sign | (base + ((uint32_t)(kept + up))));
}

/* 2^126 / d for d >= 2^63, off by less than 2^-61 of itself.
   
   A 16-bit quotient, one Newton step to 28 bits, one step of third order. */
static uint64_t late_position_reciprocal(uint64_t d)
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
    return (second << 31) + (late_position_mul_high(series, second << 32) >> 29);
}

/* a / b, relative error below 2^-59. */
static late_position_scaled_t late_position_quotient(late_position_scaled_t a, late_position_scaled_t b)
{
    const uint64_t high = late_position_mul_high(a.significand, late_position_reciprocal(b.significand));
    return late_position_normalised(high, a.exponent - b.exponent + 1);
}

/* The first 64 bits of 1 / log(2), 63 of them behind the point. */
#define LATE_POSITION_LOG2_E UINT64_C(0xB8AA3B295C17F0BB)

/* (2^g - 1) / g for 0 <= g < 1/16. */
static const uint64_t LATE_POSITION_EXP2[7] = {
    UINT64_C(0xB17217F7D1CF7AA4), UINT64_C(0x3D7F7BFF05899176), UINT64_C(0x0E35846B8325C9E5),
    UINT64_C(0x0276556DC0C05222), UINT64_C(0x005762071187A944), UINT64_C(0x000A17B98000087C),
    UINT64_C(0x00010573837C79AD)};

/* 2^(k/16) with 63 fraction bits. */
static const uint64_t LATE_POSITION_EXP2_TABLE[16] = {
    UINT64_C(0x8000000000000000), UINT64_C(0x85AAC367CC487B15), UINT64_C(0x8B95C1E3EA8BD6E7),
    UINT64_C(0x91C3D373AB11C336), UINT64_C(0x9837F0518DB8A96F), UINT64_C(0x9EF5326091A111AE),
    UINT64_C(0xA5FED6A9B15138EA), UINT64_C(0xAD583EEA42A14AC6), UINT64_C(0xB504F333F9DE6484),
    UINT64_C(0xBD08A39F580C36BF), UINT64_C(0xC5672A115506DADD), UINT64_C(0xCE248C151F8480E4),
    UINT64_C(0xD744FCCAD69D6AF4), UINT64_C(0xE0CCDEEC2A94E111), UINT64_C(0xEAC0C6E7DD24392F),
    UINT64_C(0xF5257D152486CC2C)};

/* 2^f for f < 1 with 64 fraction bits, as a significand, relative error below 2^-60. */
static uint64_t late_position_exp2_fraction(uint64_t f)
{
    const uint64_t slot = f >> 60;
    const uint64_t g = f & UINT64_C(0x0FFFFFFFFFFFFFFF);
    const uint64_t c5 = LATE_POSITION_EXP2[5] + late_position_mul_high(LATE_POSITION_EXP2[6], g);
    const uint64_t c4 = LATE_POSITION_EXP2[4] + late_position_mul_high(c5, g);
    const uint64_t c3 = LATE_POSITION_EXP2[3] + late_position_mul_high(c4, g);
    const uint64_t c2 = LATE_POSITION_EXP2[2] + late_position_mul_high(c3, g);
    const uint64_t c1 = LATE_POSITION_EXP2[1] + late_position_mul_high(c2, g);
    const uint64_t c0 = LATE_POSITION_EXP2[0] + late_position_mul_high(c1, g);
    const uint64_t base = LATE_POSITION_EXP2_TABLE[slot];
    return base + late_position_mul_high(base, late_position_mul_high(c0, g));
}

/* 2^p or 2^-p for p = (high, low) / 2^127 * 2^exponent, -64 <= exponent <= 10, high's top bit set. */
static late_position_scaled_t late_position_exp2(int negative, uint64_t high, uint64_t low, int32_t exponent)
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
    return late_position_scaled(late_position_exp2_fraction(part), whole);
}

/* (1 - tanh(x) / x) / x^2 in powers of -x^2, for x < 1/8. */
static const uint64_t LATE_POSITION_TANH[6] = {
    UINT64_C(0x55555555555548FD), UINT64_C(0x2222222221E6138E), UINT64_C(0x0DD0DD0D6F8E83BF),
    UINT64_C(0x05993CD988124FEC), UINT64_C(0x0244C11366A29CD2), UINT64_C(0x00E654D08BABB967)};

/* tanh(x) for 0 < x < 1/8, relative error below 2^-60. */
static late_position_scaled_t late_position_small_tanh(late_position_scaled_t x)
{
    const uint64_t z = late_position_squared_fraction(x);
    const uint64_t c4 = LATE_POSITION_TANH[4] - late_position_mul_high(LATE_POSITION_TANH[5], z);
    const uint64_t c3 = LATE_POSITION_TANH[3] - late_position_mul_high(c4, z);
    const uint64_t c2 = LATE_POSITION_TANH[2] - late_position_mul_high(c3, z);
    const uint64_t c1 = LATE_POSITION_TANH[1] - late_position_mul_high(c2, z);
    const uint64_t c0 = LATE_POSITION_TANH[0] - late_position_mul_high(c1, z);
    const uint64_t lost = late_position_mul_high(x.significand, late_position_mul_high(c0, z));
    return late_position_settled(x.significand - lost, x.exponent);
}

/* tanh(x) = (1 - q) / (1 + q) with q = exp(-2 x), for 0 < x < 32, relative error below 2^-58. */
static late_position_scaled_t late_position_tanh(late_position_scaled_t x)
{
    if (x.exponent < -3) {
        return late_position_small_tanh(x);
    }
    const late_position_scaled_t power = late_position_product(x, late_position_scaled(LATE_POSITION_LOG2_E, 1));
    const uint64_t q = late_position_fraction(late_position_exp2(1, power.significand, 0, power.exponent));
    if (q == 0) {
        return late_position_scaled(UINT64_C(1) << 63, 0);
    }
    const late_position_scaled_t less = late_position_normalised((UINT64_C(0) - q), -1);
    return late_position_quotient(less, late_position_scaled((UINT64_C(1) << 63) + (q >> 1), 0));
}

/* Hyperbolic tangent, the nearest float. */
static float late_position_tanh_f32(float x)
{
    const uint32_t bits = late_position_f32_to_bits(x);
    const uint32_t magnitude = bits & LATE_POSITION_MAGNITUDE_F32;
    const uint32_t sign = bits & LATE_POSITION_SIGN_F32;
    if (magnitude > LATE_POSITION_INFINITY_F32) {
        return late_position_f32_from_bits(LATE_POSITION_NAN_F32);
    }
    if (magnitude == 0) {
        return x;
    }
    if (magnitude >= 0x42000000u) {
        return late_position_f32_from_bits(sign | LATE_POSITION_ONE_F32);
    }
    return late_position_rounded_f32(sign, late_position_tanh(late_position_unpacked_f32(magnitude)));
}

/* What one part of a step hands to the next. */
typedef struct {
    uint32_t t2;
    float t12;
    uint32_t t13;
    uint32_t t15;
    float t28;
    float t35;
    float t48;
    uint32_t t75;
    float t86;
    float t87;
    float t88;
    float t89;
    float t90;
    float t91;
    float t92;
    float t93;
    float t94;
    float t95;
    float t96;
    float t97;
    float t98;
    float t99;
    float t100;
    float t101;
    uint32_t t102;
    float t156;
    float t248;
    float t252;
    float t255;
    float t258;
    float t261;
    float t265;
    float t268;
    float t271;
    float t274;
    uint32_t t275;
    float t276;
    float t279;
    float t282;
    float t285;
    float t327;
    float t328;
    float t329;
    float t330;
    late_position_status t337;
    int flags[6]; /* t4, t6, t8, t10, t68, t69 */
} late_position_work;

/* Part 1 of a step. */
static void late_position_part_1(late_position_state *state, const late_position_measurements *measurements, const late_position_inputs *inputs, late_position_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    const uint32_t t0 = state->newest;
    const uint32_t t1 = (t0 < 40U) ? t0 : 40U;
    work->t2 = state->count;
    work->flags[0] = 40U < work->t2;
    const float t5 = measurements->camera;
    work->flags[1] = (-1e36f <= t5) && (t5 <= 1e36f);
    const float t7 = measurements->wheel;
    work->flags[2] = (-20.0f <= t7) && (t7 <= 20.0f);
    const float t9 = inputs->force;
    work->flags[3] = (-1e36f <= t9) && (t9 <= 1e36f);
    const float t11 = state->force[t1];
    work->t12 = work->flags[3] ? t9 : t11;

    /* prediction, for a sample that is missing */
    work->t13 = (t1 < 40U) ? (t1 + 1U) : 0U;
    const uint32_t t14 = state->ahead_camera_slot;
    work->t15 = (t14 < 3U) ? t14 : 3U;
    const float t16 = state->ahead_camera[work->t15];
    const float t17 = state->ahead_wheel;
    const float t19 = 0.0005427591f * work->t12;
    const float t20 = t17 + t19;
    const float t21 = state->camera[t1];
    const float t22 = state->wheel[t1];
    const int t24 = 43U < work->t2;
    const int t25 = (-1e36f <= t16) && (t16 <= 1e36f);
    const int t26 = t24 && t25;
    const float t27 = t26 ? t16 : t21;
    work->t28 = work->flags[1] ? t5 : t27;
    const int t29 = (-20.0f <= t20) && (t20 <= 20.0f);
    const int t30 = work->flags[0] && t29;
    const float t31 = t30 ? t20 : t22;
    const float t32 = work->flags[2] ? t7 : t31;
    const float t34 = 20.0f * t32;
    work->t35 = late_position_tanh_f32(t34);
    const float t36 = state->tanh_20_wheel[t1];
    const int t37 = work->flags[1] || t26;
    const int t38 = !t37;
    const float t39 = work->t35 - t36;
    const float t41 = -0.00018548031f * t39;
    const float t42 = t20 + t41;
    const int t43 = (-20.0f <= t42) && (t42 <= 20.0f);
    const int t44 = work->flags[0] && t43;
    const float t45 = t44 ? t42 : t22;
    const int t46 = work->flags[2] || t44;
    const int t47 = !t46;
    work->t48 = work->flags[2] ? t7 : t45;
    const uint32_t t49 = state->missed_camera;
    const int t51 = 36U < t49;
    const int t52 = !work->flags[1];
    const int t53 = t52 && t51;
    const uint32_t t55 = (t49 < 37U) ? (t49 + 1U) : 37U;
    const uint32_t t56 = work->flags[1] ? 0U : t55;
    state->missed_camera = t56;
    const uint32_t t57 = state->missed_wheel;
    const int t58 = 40U < t57;
    const int t59 = !work->flags[2];
    const int t60 = t59 && t58;
    const uint32_t t61 = (t57 < 41U) ? (t57 + 1U) : 41U;
    const uint32_t t62 = work->flags[2] ? 0U : t61;
    state->missed_wheel = t62;
    const int t63 = t53 || t60;
    const int t64 = t53 && t60;
    const int t65 = !t64;
    const int t66 = t63 && t65;
    const int t67 = t38 || t47;
    work->flags[4] = t67 || t66;
    work->flags[5] = work->flags[2] && work->flags[1];
}

/* Part 2 of a step. */
static void late_position_part_2(late_position_state *state, late_position_work *work)
{
    /* how much of the window is good */
    const uint32_t t71 = (work->t2 < 44U) ? (work->t2 + 1U) : 44U;
    const uint32_t t72 = work->flags[4] ? 0U : t71;
    const uint32_t t73 = work->flags[3] ? t71 : 1U;
    const uint32_t t74 = work->flags[5] ? t73 : 0U;
    work->t75 = work->flags[0] ? t72 : t74;
    state->count = work->t75;
    const uint32_t t76 = state->coasting;
    const uint32_t t77 = (t76 > 0U) ? (t76 - 1U) : 0U;
    const uint32_t t78 = work->flags[3] ? t77 : 40U;
    const int t80 = t78 < 37U;
    const uint32_t t81 = t80 ? 37U : t78;
    const uint32_t t82 = work->flags[1] ? t78 : t81;
    const uint32_t t84 = work->flags[2] ? t82 : 41U;
    state->coasting = t84;

    /* into the window */
    state->newest = work->t13;
    state->camera[work->t13] = work->t28;
    state->wheel[work->t13] = work->t48;
    state->force[work->t13] = work->t12;
    state->tanh_20_wheel[work->t13] = work->t35;
}

/* Part 3 of a step. */
static void late_position_part_3(const late_position_state *state, late_position_work *work)
{
    /* the sums over the window, newest sample first */
    work->t86 = 0.0f;
    work->t87 = 0.0f;
    work->t88 = 0.0f;
    work->t89 = 0.0f;
    work->t90 = 0.0f;
    work->t91 = 0.0f;
    work->t92 = 0.0f;
    work->t93 = 0.0f;
    work->t94 = 0.0f;
    work->t95 = 0.0f;
    work->t96 = 0.0f;
    work->t97 = 0.0f;
    work->t98 = 0.0f;
    work->t99 = 0.0f;
    work->t100 = 0.0f;
    work->t101 = 0.0f;
    work->t102 = work->t13;
    for (uint32_t row = 0U; row < 37U; ++row) {
        const float *const gains = LATE_POSITION_WINDOW[row];
        const float t103 = state->camera[work->t102];
        const float t104 = gains[0];
        const float t105 = t104 * t103;
        const float t106 = work->t86 + t105;
        const float t107 = gains[1];
        const float t108 = t107 * t103;
        const float t109 = work->t90 + t108;
        const float t110 = gains[2];
        const float t111 = t110 * t103;
        const float t112 = work->t94 + t111;
        const float t113 = gains[3];
        const float t114 = t113 * t103;
        const float t115 = work->t98 + t114;
        const float t116 = state->wheel[work->t102];
        const float t117 = gains[4];
        const float t118 = t117 * t116;
        const float t119 = work->t87 + t118;
        const float t120 = gains[5];
        const float t121 = t120 * t116;
        const float t122 = work->t91 + t121;
        const float t123 = gains[6];
        const float t124 = t123 * t116;
        const float t125 = work->t95 + t124;
        const float t126 = gains[7];
        const float t127 = t126 * t116;
        const float t128 = work->t99 + t127;
        const float t129 = state->force[work->t102];
        const float t130 = gains[8];
        const float t131 = t130 * t129;
        const float t132 = work->t88 + t131;
        const float t133 = gains[9];
        const float t134 = t133 * t129;
        const float t135 = work->t92 + t134;
        const float t136 = gains[10];
        const float t137 = t136 * t129;
        const float t138 = work->t96 + t137;
        const float t139 = gains[11];
        const float t140 = t139 * t129;
        const float t141 = work->t100 + t140;
        const float t142 = state->tanh_20_wheel[work->t102];
        const float t143 = gains[12];
        const float t144 = t143 * t142;
        const float t145 = work->t89 + t144;
        const float t146 = gains[13];
        const float t147 = t146 * t142;
        const float t148 = work->t93 + t147;
        const float t149 = gains[14];
        const float t150 = t149 * t142;
        const float t151 = work->t97 + t150;
        const float t152 = gains[15];
        const float t153 = t152 * t142;
        const float t154 = work->t101 + t153;
        const uint32_t t155 = ((work->t102 >= 1U) && (work->t102 < 41U)) ? (work->t102 - 1U) : 40U;
        work->t86 = t106;
        work->t87 = t119;
        work->t88 = t132;
        work->t89 = t145;
        work->t90 = t109;
        work->t91 = t122;
        work->t92 = t135;
        work->t93 = t148;
        work->t94 = t112;
        work->t95 = t125;
        work->t96 = t138;
        work->t97 = t151;
        work->t98 = t115;
        work->t99 = t128;
        work->t100 = t141;
        work->t101 = t154;
        work->t102 = t155;
    }
    work->t156 = state->wheel[work->t102];
}

/* Part 4 of a step. */
static void late_position_part_4(const late_position_state *state, late_position_work *work)
{
    const float t158 = -0.00091676513f * work->t156;
    const float t159 = work->t87 + t158;
    const float t161 = -0.025646579f * work->t156;
    const float t162 = work->t91 + t161;
    const float t164 = -0.16596684f * work->t156;
    const float t165 = work->t95 + t164;
    const float t167 = -0.020664772f * work->t156;
    const float t168 = work->t99 + t167;
    const float t169 = state->force[work->t102];
    const float t171 = -8.976167e-6f * t169;
    const float t172 = work->t88 + t171;
    const float t174 = -0.00026281233f * t169;
    const float t175 = work->t92 + t174;
    const float t177 = -0.0018645605f * t169;
    const float t178 = work->t96 + t177;
    const float t180 = -0.00020618188f * t169;
    const float t181 = work->t100 + t180;
    const float t182 = state->tanh_20_wheel[work->t102];
    const float t184 = 1.1533054e-5f * t182;
    const float t185 = work->t89 + t184;
    const float t187 = 0.00033982494f * t182;
    const float t188 = work->t93 + t187;
    const float t190 = 0.002425175f * t182;
    const float t191 = work->t97 + t190;
    const float t193 = 0.0002661146f * t182;
    const float t194 = work->t101 + t193;
    const uint32_t t195 = ((work->t102 >= 1U) && (work->t102 < 41U)) ? (work->t102 - 1U) : 40U;
    const float t196 = state->wheel[t195];
    const float t198 = -0.0005455849f * t196;
    const float t199 = t159 + t198;
    const float t201 = -0.0092674885f * t196;
    const float t202 = t162 + t201;
    const float t204 = -0.053376373f * t196;
    const float t205 = t165 + t204;
    const float t207 = -0.0076920497f * t196;
    const float t208 = t168 + t207;
    const float t209 = state->force[t195];
    const float t211 = -4.4602994e-6f * t209;
    const float t212 = t172 + t211;
    const float t214 = -0.00012906553f * t209;
    const float t215 = t175 + t214;
    const float t217 = -0.0009068481f * t209;
    const float t218 = t178 + t217;
    const float t220 = -0.00010155565f * t209;
    const float t221 = t181 + t220;
    const float t222 = state->tanh_20_wheel[t195];
    const float t224 = 6.6430457e-6f * t222;
    const float t225 = t185 + t224;
    const float t227 = 0.0001934953f * t222;
    const float t228 = t188 + t227;
    const float t230 = 0.0013666875f * t222;
    const float t231 = t191 + t230;
    const float t233 = 0.00015200896f * t222;
    const float t234 = t194 + t233;
    const uint32_t t235 = ((t195 >= 1U) && (t195 < 41U)) ? (t195 - 1U) : 40U;
    const float t236 = state->wheel[t235];
    const float t238 = 0.00011980761f * t236;
    const float t239 = t199 + t238;
    const float t241 = 0.015010394f * t236;
    const float t242 = t202 + t241;
    const float t244 = 0.10996451f * t236;
    const float t245 = t205 + t244;
    const float t247 = 0.011658126f * t236;
    work->t248 = t208 + t247;
    const float t249 = state->force[t235];
    const float t251 = -1.2016934e-6f * t249;
    work->t252 = t212 + t251;
    const float t254 = -3.427747e-5f * t249;
    work->t255 = t215 + t254;
    const float t257 = -0.00023922835f * t249;
    work->t258 = t218 + t257;
    const float t260 = -2.7026394e-5f * t249;
    work->t261 = t221 + t260;
    const float t262 = state->tanh_20_wheel[t235];
    const float t264 = 2.6996076e-6f * t262;
    work->t265 = t225 + t264;
    const float t267 = 7.770854e-5f * t262;
    work->t268 = t228 + t267;
    const float t270 = 0.0005442701f * t262;
    work->t271 = t231 + t270;
    const float t273 = 6.120425e-5f * t262;
    work->t274 = t234 + t273;
    work->t275 = ((t235 >= 1U) && (t235 < 41U)) ? (t235 - 1U) : 40U;
    work->t276 = state->wheel[work->t275];
    const float t278 = 0.0011836652f * work->t276;
    work->t279 = t239 + t278;
    const float t281 = 0.049967952f * work->t276;
    work->t282 = t242 + t281;
    const float t284 = 0.34190255f * work->t276;
    work->t285 = t245 + t284;
}

/* Part 5 of a step. */
static void late_position_part_5(late_position_state *state, late_position_work *work)
{
    const float t287 = 0.03963173f * work->t276;
    const float t288 = work->t248 + t287;
    const float t289 = state->tanh_20_wheel[work->t275];
    const float t291 = 3.9360887e-7f * t289;
    const float t292 = work->t265 + t291;
    const float t294 = 1.1135854e-5f * t289;
    const float t295 = work->t268 + t294;
    const float t297 = 7.775765e-5f * t289;
    const float t298 = work->t271 + t297;
    const float t300 = 8.778847e-6f * t289;
    const float t301 = work->t274 + t300;
    const float t302 = work->t86 + work->t279;
    const float t303 = t302 + work->t252;
    const float t304 = t303 + t292;
    const float t305 = work->t90 + work->t282;
    const float t306 = t305 + work->t255;
    const float t307 = t306 + t295;
    const float t308 = work->t94 + work->t285;
    const float t309 = t308 + work->t258;
    const float t310 = t309 + t298;
    const float t311 = work->t98 + t288;
    const float t312 = t311 + work->t261;
    const float t313 = t312 + t301;

    /* the next measurement, as far as it is known */
    state->ahead_camera[work->t15] = t304;
    const uint32_t t314 = (work->t15 < 3U) ? (work->t15 + 1U) : 0U;
    state->ahead_camera_slot = t314;
    const float t316 = 0.25809625f * t307;
    const float t318 = 0.0013568978f * t310;
    const float t320 = 0.7408182f * t313;
    const float t322 = -0.0005427591f * work->t35;
    const float t323 = t316 + t318;
    const float t324 = t323 + t320;
    const float t325 = t324 + t322;
    state->ahead_wheel = t325;

    /* the estimate; until the window is full, the start */
    const int t326 = 40U < work->t75;
    work->t327 = t326 ? t304 : 0.0f;
    work->t328 = t326 ? t307 : 0.0f;
    work->t329 = t326 ? t310 : 0.0f;
    work->t330 = t326 ? t313 : work->t48;
    const uint32_t t331 = state->coasting;
    const int t332 = t331 == 0U;
    const late_position_status t336 = t332 ? LATE_POSITION_CONVERGED : LATE_POSITION_COASTING;
    work->t337 = t326 ? t336 : LATE_POSITION_CONVERGING;
}

void late_position_init(late_position_state *state)
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
    for (uint32_t slot = 0U; slot < 4U; ++slot) {
        state->ahead_camera[slot] = 0.0f;
    }
    state->ahead_camera_slot = 0U;
    state->ahead_wheel = 0.0f;
}

void late_position_step(late_position_state *state, const late_position_measurements *measurements,
                        const late_position_inputs *inputs, late_position_estimate *estimate)
{
    late_position_work work;
    late_position_part_1(state, measurements, inputs, &work);
    late_position_part_2(state, &work);
    late_position_part_3(state, &work);
    late_position_part_4(state, &work);
    late_position_part_5(state, &work);

    estimate->position = work.t327;
    estimate->speed = work.t328;
    estimate->slope = work.t329;
    estimate->wheel = work.t330;
    estimate->status = work.t337;
}
