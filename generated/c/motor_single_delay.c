/* motor_single_delay.c: Finite-time observer: Direct-drive arm: speed and current from the position, reduced order.
 *
 * Generated; motor_single_delay.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "motor_single_delay.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "motor_single_delay.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "motor_single_delay.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* weights by age, from age 0
 *   [0] q from y
 *   [1] dq from y
 *   [2] i from y
 *   [3] dq from u
 *   [4] i from u
 *   [5] dq from sin(q)
 *   [6] i from sin(q)
 */
static const float MOTOR_SINGLE_DELAY_WINDOW[100][7] = {
    { 1.0f, 9.419504f, -1.7473943f, 0.0002799571f, 0.036250718f, -0.017438471f, 0.00019188081f },
    { 0.0f, 0.08880401f, -0.016473863f, 0.00076708867f, 0.029662618f, -0.03462481f, 0.001075231f },
    { 0.0f, 0.0881185f, -0.016346699f, 0.0011598326f, 0.024255043f, -0.03423341f, 0.0019598445f },
    { 0.0f, 0.08737649f, -0.01620905f, 0.0014750626f, 0.019816697f, -0.033826772f, 0.0026703002f },
    { 0.0f, 0.086576134f, -0.016060578f, 0.0017266322f, 0.016174102f, -0.033407416f, 0.003237731f },
    { 0.0f, 0.08571555f, -0.015900932f, 0.0019259164f, 0.013184835f, -0.03297741f, 0.0036876993f },
    { 0.0f, 0.08479279f, -0.015729757f, 0.0020822543f, 0.01073196f, -0.032538466f, 0.004041193f },
    { 0.0f, 0.0838059f, -0.01554668f, 0.0022033143f, 0.008719473f, -0.032091998f, 0.004315445f },
    {
        0.0f, 0.08275282f, -0.015351326f, 0.0022953926f, 0.0070685535f, -0.031639174f, 0.0045246063f
    },
    {
        0.0f, 0.08163147f, -0.015143307f, 0.0023636594f, 0.0057144887f, -0.031180965f, 0.0046802955f
    },
    {
        0.0f, 0.08043969f, -0.014922224f, 0.0024123597f, 0.0046041477f, -0.030718174f, 0.0047920537f
    },
    { 0.0f, 0.079175286f, -0.0146876685f, 0.00244498f, 0.0036939103f, -0.030251471f, 0.004867717f },
    { 0.0f, 0.07783601f, -0.014439222f, 0.0024643831f, 0.0029479633f, -0.029781422f, 0.00491372f },
    { 0.0f, 0.07641952f, -0.014176453f, 0.00247292f, 0.002336903f, -0.029308494f, 0.004935348f },
    { 0.0f, 0.07492345f, -0.013898921f, 0.0024725227f, 0.0018365893f, -0.02883309f, 0.0049369424f },
    { 0.0f, 0.07334535f, -0.013606173f, 0.002464777f, 0.0014272019f, -0.028355548f, 0.0049220696f },
    {
        0.0f, 0.07168272f, -0.013297743f, 0.0024509865f, 0.0010924684f, -0.027876163f, 0.0048936605f
    },
    {
        0.0f, 0.06993298f, -0.012973155f, 0.0024322225f, 0.0008190287f, -0.027395185f, 0.0048541236f
    },
    {
        0.0f, 0.06809351f, -0.012631918f, 0.0024093648f, 0.00059591373f, -0.026912836f, 0.004805439f
    },
    {
        0.0f, 0.06616158f, -0.012273531f, 0.0023831376f, 0.00041411773f, -0.026429314f,
        0.0047492348f
    },
    { 0.0f, 0.06413443f, -0.01189748f, 0.0023541364f, 0.00026624647f, -0.025944795f, 0.004686851f },
    { 0.0f, 0.0620092f, -0.0115032345f, 0.0023228507f, 0.00014622907f, -0.02545944f, 0.00461939f },
    { 0.0f, 0.059782974f, -0.0110902535f, 0.0022896843f, 4.908105e-5f, -0.024973396f, 0.00454776f },
    {
        0.0f, 0.057452753f, -0.010657981f, 0.0022549692f, -2.9290157e-5f, -0.0244868f, 0.0044727107f
    },
    { 0.0f, 0.055015463f, -0.010205845f, 0.00221898f, -9.224482e-5f, -0.023999788f, 0.00439486f },
    {
        0.0f, 0.05246795f, -0.009733263f, 0.002181943f, -0.00014254202f, -0.023512485f,
        0.0043147183f
    },
    {
        0.0f, 0.04980698f, -0.009239634f, 0.0021440457f, -0.00018244726f, -0.02302501f,
        0.0042327098f
    },
    {
        0.0f, 0.04702923f, -0.008724341f, 0.002105443f, -0.00021382078f, -0.022537487f,
        0.0041491846f
    },
    {
        0.0f, 0.04413131f, -0.008186755f, 0.0020662644f, -0.00023819019f, -0.022050036f,
        0.004064435f
    },
    {
        0.0f, 0.04110972f, -0.007626227f, 0.0020266168f, -0.00025680993f, -0.021562776f,
        0.003978705f
    },
    {
        0.0f, 0.037960883f, -0.007042095f, 0.0019865904f, -0.0002707102f, -0.021075826f,
        0.0038921987f
    },
    {
        0.0f, 0.034681138f, -0.0064336783f, 0.0019462605f, -0.0002807372f, -0.020589313f,
        0.0038050876f
    },
    {
        0.0f, 0.031266715f, -0.0058002784f, 0.0019056908f, -0.0002875859f, -0.020103354f,
        0.0037175177f
    },
    {
        0.0f, 0.027713768f, -0.00514118f, 0.0018649354f, -0.00029182725f, -0.01961808f,
        0.0036296132f
    },
    {
        0.0f, 0.02401834f, -0.0044556507f, 0.0018240408f, -0.00029393038f, -0.019133622f,
        0.0035414805f
    },
    {
        0.0f, 0.020176377f, -0.0037429382f, 0.0017830468f, -0.00029428082f, -0.018650107f,
        0.003453212f
    },
    {
        0.0f, 0.016183728f, -0.0030022722f, 0.0017419884f, -0.00029319542f, -0.018167678f,
        0.0033648894f
    },
    {
        0.0f, 0.012036137f, -0.0022328633f, 0.0017008962f, -0.00029093472f, -0.017686471f,
        0.0032765837f
    },
    {
        0.0f, 0.007729244f, -0.0014339028f, 0.0016597979f, -0.0002877131f, -0.017206635f,
        0.00318836f
    },
    {
        0.0f, 0.0032585799f, -0.0006045614f, 0.0016187179f, -0.00028370693f, -0.016728316f,
        0.0031002765f
    },
    {
        0.0f, -0.0013804316f, 0.00025600966f, 0.0015776791f, -0.0002790614f, -0.01625167f,
        0.0030123873f
    },
    {
        0.0f, -0.0061924774f, 0.0011486799f, 0.0015367025f, -0.00027389632f, -0.015776856f,
        0.0029247424f
    },
    {
        0.0f, -0.011182356f, 0.0020743394f, 0.001495808f, -0.00026831034f, -0.015304039f,
        0.00283739f
    },
    {
        0.0f, -0.016354978f, 0.0030338992f, 0.0014550142f, -0.00026238503f, -0.014833389f,
        0.002750375f
    },
    {
        0.0f, -0.02171537f, 0.0040282914f, 0.0014143395f, -0.00025618786f, -0.014365081f,
        0.0026637418f
    },
    {
        0.0f, -0.027268669f, 0.00505847f, 0.0013738015f, -0.0002497747f, -0.013899296f,
        0.0025775335f
    },
    {
        0.0f, -0.033020128f, 0.0061254087f, 0.0013334176f, -0.00024319199f, -0.013436222f,
        0.0024917927f
    },
    {
        0.0f, -0.038975116f, 0.0072301035f, 0.001293205f, -0.0002364784f, -0.012976053f,
        0.0024065613f
    },
    {
        0.0f, -0.045139108f, 0.00837357f, 0.0012531809f, -0.00022966623f, -0.01251899f,
        0.0023218822f
    },
    {
        0.0f, -0.051517688f, 0.009556844f, 0.0012133628f, -0.00022278259f, -0.012065236f,
        0.0022377975f
    },
    {
        0.0f, -0.058116544f, 0.010780981f, 0.001173768f, -0.00021585038f, -0.011615008f,
        0.0021543503f
    },
    {
        0.0f, -0.064941466f, 0.012047054f, 0.0011344143f, -0.00020888899f, -0.011168525f,
        0.0020715848f
    },
    {
        0.0f, -0.07199832f, 0.013356155f, 0.0010953199f, -0.000201915f, -0.010726014f, 0.0019895453f
    },
    {
        0.0f, -0.07929307f, 0.014709385f, 0.0010565032f, -0.00019494268f, -0.0102877095f,
        0.001908277f
    },
    {
        0.0f, -0.086831726f, 0.016107861f, 0.0010179828f, -0.00018798448f, -0.009853854f,
        0.001827827f
    },
    {
        0.0f, -0.09462035f, 0.01755271f, 0.0009797784f, -0.00018105128f, -0.009424698f,
        0.0017482424f
    },
    {
        0.0f, -0.10266501f, 0.019045053f, 0.0009419096f, -0.00017415277f, -0.009000498f,
        0.0016695725f
    },
    {
        0.0f, -0.11097178f, 0.020586021f, 0.0009043969f, -0.00016729767f, -0.008581521f,
        0.0015918673f
    },
    {
        0.0f, -0.11954667f, 0.022176728f, 0.0008672611f, -0.00016049392f, -0.00816804f,
        0.0015151785f
    },
    {
        0.0f, -0.12839559f, 0.02381827f, 0.0008305238f, -0.00015374883f, -0.0077603385f,
        0.0014395589f
    },
    {
        0.0f, -0.13752429f, 0.025511712f, 0.00079420715f, -0.00014706925f, -0.007358707f,
        0.0013650631f
    },
    {
        0.0f, -0.14693828f, 0.027258076f, 0.00075833395f, -0.00014046165f, -0.0069634453f,
        0.0012917473f
    },
    {
        0.0f, -0.15664268f, 0.029058315f, 0.00072292774f, -0.00013393223f, -0.006574863f,
        0.0012196689f
    },
    {
        0.0f, -0.16664219f, 0.0309133f, 0.0006880126f, -0.00012748697f, -0.006193278f, 0.0011488872f
    },
    {
        0.0f, -0.17694087f, 0.032823782f, 0.00065361336f, -0.00012113173f, -0.0058190166f,
        0.0010794633f
    },
    {
        0.0f, -0.18754196f, 0.034790363f, 0.00061975565f, -0.00011487228f, -0.005452416f,
        0.0010114595f
    },
    {
        0.0f, -0.1984476f, 0.03681344f, 0.0005864659f, -0.00010871434f, -0.005093822f,
        0.00094494043f
    },
    {
        0.0f, -0.20965862f, 0.03889317f, 0.00055377104f, -0.00010266361f, -0.00474359f,
        0.00087997195f
    },
    { 0.0f, -0.22117406f, 0.04102937f, 0.00052169897f, -9.672583e-5f, -0.004402085f, 0.000816622f },
    { 0.0f, -0.23299076f, 0.04322146f, 0.0004902783f, -9.090677e-5f, -0.0040696817f, 0.00075496f },
    {
        0.0f, -0.24510276f, 0.045468327f, 0.00045953845f, -8.521226e-5f, -0.003746763f,
        0.00069505716f
    },
    {
        0.0f, -0.25750062f, 0.04776822f, 0.00042950956f, -7.9648205e-5f, -0.0034337214f,
        0.00063698634f
    },
    {
        0.0f, -0.2701704f, 0.050118558f, 0.00040022255f, -7.4220596e-5f, -0.0031309584f,
        0.00058082206f
    },
    {
        0.0f, -0.28309262f, 0.052515734f, 0.00037170912f, -6.893553e-5f, -0.0028388829f,
        0.0005266402f
    },
    {
        0.0f, -0.29624096f, 0.05495485f, 0.00034400166f, -6.379918e-5f, -0.0025579114f,
        0.0004745182f
    },
    {
        0.0f, -0.30958033f, 0.057429407f, 0.0003171333f, -5.8817852e-5f, -0.0022884673f,
        0.00042453437f
    },
    {
        0.0f, -0.32306483f, 0.059930887f, 0.00029113778f, -5.3997905e-5f, -0.0020309784f,
        0.0003767683f
    },
    { 0.0f, -0.33663514f, 0.06244828f, 0.0002660495f, -4.9345814e-5f, -0.0017858765f, 0.0003313f },
    {
        0.0f, -0.35021505f, 0.06496746f, 0.00024190327f, -4.4868124e-5f, -0.0015535946f,
        0.00028820985f
    },
    {
        0.0f, -0.36370745f, 0.06747041f, 0.00021873433f, -4.057143e-5f, -0.0013345643f,
        0.0002475779f
    },
    {
        0.0f, -0.37698922f, 0.06993428f, 0.0001965782f, -3.6462377e-5f, -0.0011292127f,
        0.00020948342f
    },
    {
        0.0f, -0.3899048f, 0.07233023f, 0.00017547038f, -3.25476e-5f, -0.0009379575f, 0.00017400389f
    },
    {
        0.0f, -0.4022584f, 0.07462192f, 0.00015544625f, -2.8833685e-5f, -0.00076120184f,
        0.00014121411f
    },
    {
        0.0f, -0.41380414f, 0.07676376f, 0.00013654068f, -2.5327141e-5f, -0.0005993276f,
        0.00011118491f
    },
    {
        0.0f, -0.42423388f, 0.07869857f, 0.00011878766f, -2.2034294e-5f, -0.0004526863f,
        8.398153e-5f
    },
    {
        0.0f, -0.4331622f, 0.080354854f, 0.00010221988f, -1.8961224e-5f, -0.00032158868f,
        5.9661597e-5f
    },
    {
        0.0f, -0.44010758f, 0.0816433f, 8.6868014e-5f, -1.6113643e-5f, -0.00020629099f,
        3.8272658e-5f
    },
    {
        0.0f, -0.44446912f, 0.08245243f, 7.276006e-5f, -1.3496758e-5f, -0.00010697819f,
        1.9849027e-5f
    },
    { 0.0f, -0.4454978f, 0.08264329f, 5.992036e-5f, -1.111509e-5f, -2.374291e-5f, 4.407895e-6f },
    { 0.0f, -0.4422604f, 0.082042776f, 4.836838e-5f, -8.972265e-6f, 4.344073e-5f, -8.055541e-6f },
    {
        0.0f, -0.43359506f, 0.08043534f, 3.8117283e-5f, -7.0707288e-6f, 9.4749805e-5f,
        -1.7574124e-5f
    },
    {
        0.0f, -0.41805604f, 0.07755281f, 2.9172046e-5f, -5.4114134e-6f, 0.00013055315f,
        -2.4216275e-5f
    },
    { 0.0f, -0.39384496f, 0.07306156f, 2.152719e-5f, -3.993305e-6f, 0.00015146189f, -2.809536e-5f },
    {
        0.0f, -0.35872576f, 0.06654679f, 1.5163897e-5f, -2.8129189e-6f, 0.00015839234f,
        -2.9381354e-5f
    },
    {
        0.0f, -0.30991864f, 0.057492834f, 1.00464595e-5f, -1.8636335e-6f, 0.000152644f,
        -2.831532e-5f
    },
    {
        0.0f, -0.24396895f, 0.04525884f, 6.1178503e-6f, -1.1348731e-6f, 0.00013599673f,
        -2.5227437e-5f
    },
    {
        0.0f, -0.156584f, 0.029048478f, 3.294213e-6f, -6.1108403e-7f, 0.00011083138f, -2.0559355e-5f
    },
    {
        0.0f, -0.042430636f, 0.007872426f, 1.4580163e-6f, -2.7046582e-7f, 8.027965e-5f,
        -1.4892027e-5f
    },
    { 0.0f, 0.1051161f, -0.019498285f, 4.495459e-7f, -8.3392045e-8f, 4.841033e-5f, -8.980234e-6f },
    {
        0.0f, 0.29428497f, -0.054590143f, 5.6329192e-8f, -1.04492335e-8f, 2.0460591e-5f,
        -3.7954976e-6f
    }
};

/* The bits of a number. */
typedef union {
    float value;
    uint32_t bits;
} motor_single_delay_f32_cell_t;

/* The bits of a number. */
static uint32_t motor_single_delay_f32_to_bits(float x)
{
    motor_single_delay_f32_cell_t cell;
    cell.value = x;
    return cell.bits;
}

/* The bit of the sign. */
#define MOTOR_SINGLE_DELAY_SIGN_F32 UINT32_C(0x80000000)

/* The bits of the largest magnitude. */
#define MOTOR_SINGLE_DELAY_MAGNITUDE_F32 UINT32_C(0x7FFFFFFF)

/* The bits of infinity. */
#define MOTOR_SINGLE_DELAY_INFINITY_F32 UINT32_C(0x7F800000)

/* The bits of the only NaN that is returned. */
#define MOTOR_SINGLE_DELAY_NAN_F32 UINT32_C(0x7FC00000)

/* The number with these bits. */
static float motor_single_delay_f32_from_bits(uint32_t bits)
{
    motor_single_delay_f32_cell_t cell;
    cell.bits = bits;
    return cell.value;
}

/* The number significand / 2^63 * 2^exponent, with the top bit of the significand set. */
typedef struct {
    uint64_t significand;
    int32_t exponent;
} motor_single_delay_scaled_t;

/* A number with a sign. */
typedef struct {
    motor_single_delay_scaled_t magnitude;
    int negative;
} motor_single_delay_signed_t;

/* The angle quadrant * pi/2 + rest. */
typedef struct {
    motor_single_delay_signed_t rest;
    uint32_t quadrant;
} motor_single_delay_turned_t;

/* Attaches a sign. */
static motor_single_delay_signed_t motor_single_delay_signed(motor_single_delay_scaled_t magnitude, int negative)
{
    motor_single_delay_signed_t result;
    result.magnitude = magnitude;
    result.negative = negative;
    return result;
}

/* A number below 1 as fixed point with 64 fraction bits. */
static uint64_t motor_single_delay_fraction(motor_single_delay_scaled_t a)
{
    const int32_t shift = -1 - a.exponent;
    if (shift > 63) {
        return 0;
    }
    return a.significand >> shift;
}

/* The upper half of the product, at most 2 too small. */
static uint64_t motor_single_delay_mul_high(uint64_t a, uint64_t b)
{
    const uint64_t a_high = a >> 32;
    const uint64_t a_low = a & 0xFFFFFFFFu;
    const uint64_t b_high = b >> 32;
    const uint64_t b_low = b & 0xFFFFFFFFu;
    const uint64_t cross = ((a_high * b_low) >> 32) + ((a_low * b_high) >> 32);
    return a_high * b_high + cross;
}

/* The square of a number below 1 as fixed point with 64 fraction bits. */
static uint64_t motor_single_delay_squared_fraction(motor_single_delay_scaled_t a)
{
    const uint64_t x = motor_single_delay_fraction(a);
    return motor_single_delay_mul_high(x, x);
}

/* Makes a number of a significand that has its top bit set. */
static motor_single_delay_scaled_t motor_single_delay_scaled(uint64_t significand, int32_t exponent)
{
    motor_single_delay_scaled_t result;
    result.significand = significand;
    result.exponent = exponent;
    return result;
}

/* Makes a number of a significand of at least 2^62. */
static motor_single_delay_scaled_t motor_single_delay_settled(uint64_t significand, int32_t exponent)
{
    if ((significand >> 63) == 0) {
        return motor_single_delay_scaled(significand << 1, exponent - 1);
    }
    return motor_single_delay_scaled(significand, exponent);
}

/* (1 - cos(r)) / r^2 in powers of -r^2. */
static const uint64_t MOTOR_SINGLE_DELAY_COSINE[8] = {
    UINT64_C(0x8000000000000000), UINT64_C(0x0AAAAAAAAAAAAAA8), UINT64_C(0x005B05B05B05B02B),
    UINT64_C(0x0001A01A01A01865), UINT64_C(0x0000049F93EDD666), UINT64_C(0x00000008F76C6243),
    UINT64_C(0x000000000C9C9706), UINT64_C(0x00000000000D551B)};

/* cos(r) for 0 < r <= pi/4, relative error below 2^-60. */
static motor_single_delay_scaled_t motor_single_delay_cosine(motor_single_delay_scaled_t r)
{
    const uint64_t z = motor_single_delay_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = MOTOR_SINGLE_DELAY_COSINE[6] - ((MOTOR_SINGLE_DELAY_COSINE[7] * z_high) >> 32);
    const uint64_t c5 = MOTOR_SINGLE_DELAY_COSINE[5] - ((tail * z_high) >> 32);
    const uint64_t c4 = MOTOR_SINGLE_DELAY_COSINE[4] - motor_single_delay_mul_high(c5, z);
    const uint64_t c3 = MOTOR_SINGLE_DELAY_COSINE[3] - motor_single_delay_mul_high(c4, z);
    const uint64_t c2 = MOTOR_SINGLE_DELAY_COSINE[2] - motor_single_delay_mul_high(c3, z);
    const uint64_t c1 = MOTOR_SINGLE_DELAY_COSINE[1] - motor_single_delay_mul_high(c2, z);
    const uint64_t c0 = MOTOR_SINGLE_DELAY_COSINE[0] - motor_single_delay_mul_high(c1, z);
    return motor_single_delay_settled((UINT64_C(1) << 63) - (motor_single_delay_mul_high(c0, z) >> 1), 0);
}

/* (1 - sin(r) / r) / r^2 in powers of -r^2. */
static const uint64_t MOTOR_SINGLE_DELAY_SINE[7] = {
    UINT64_C(0x2AAAAAAAAAAAAAA6), UINT64_C(0x0222222222222160), UINT64_C(0x000D00D00D00C575),
    UINT64_C(0x00002E3BC74A673D), UINT64_C(0x0000006B9914A637), UINT64_C(0x00000000B090498C),
    UINT64_C(0x0000000000D552BC)};

/* sin(r) for 0 < r <= pi/4, relative error below 2^-60. */
static motor_single_delay_scaled_t motor_single_delay_sine(motor_single_delay_scaled_t r)
{
    const uint64_t z = motor_single_delay_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = MOTOR_SINGLE_DELAY_SINE[5] - ((MOTOR_SINGLE_DELAY_SINE[6] * z_high) >> 32);
    const uint64_t c4 = MOTOR_SINGLE_DELAY_SINE[4] - ((tail * z_high) >> 32);
    const uint64_t c3 = MOTOR_SINGLE_DELAY_SINE[3] - motor_single_delay_mul_high(c4, z);
    const uint64_t c2 = MOTOR_SINGLE_DELAY_SINE[2] - motor_single_delay_mul_high(c3, z);
    const uint64_t c1 = MOTOR_SINGLE_DELAY_SINE[1] - motor_single_delay_mul_high(c2, z);
    const uint64_t c0 = MOTOR_SINGLE_DELAY_SINE[0] - motor_single_delay_mul_high(c1, z);
    const uint64_t lost = motor_single_delay_mul_high(r.significand, motor_single_delay_mul_high(c0, z));
    return motor_single_delay_settled(r.significand - lost, r.exponent);
}

/* The sine of an angle. */
static motor_single_delay_signed_t motor_single_delay_sine_at(motor_single_delay_turned_t angle)
{
    const int back = (angle.quadrant & 2) != 0;
    if ((angle.quadrant & 1) != 0) {
        return motor_single_delay_signed(motor_single_delay_cosine(angle.rest.magnitude), back);
    }
    return motor_single_delay_signed(motor_single_delay_sine(angle.rest.magnitude), back != angle.rest.negative);
}

/* Makes an angle of its parts. */
static motor_single_delay_turned_t motor_single_delay_turned(motor_single_delay_signed_t rest, uint32_t quadrant)
{
    motor_single_delay_turned_t result;
    result.rest = rest;
    result.quadrant = quadrant;
    return result;
}

/* The number of zero bits above the highest one bit; x is not 0. */
static int32_t motor_single_delay_leading_zeros(uint64_t x)
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
static motor_single_delay_scaled_t motor_single_delay_normalised(uint64_t significand, int32_t exponent)
{
    const int32_t shift = motor_single_delay_leading_zeros(significand);
    return motor_single_delay_scaled(significand << shift, exponent - shift);
}

/* The finite positive number with these bits, not 0; exact. */
static motor_single_delay_scaled_t motor_single_delay_unpacked_f32(uint32_t magnitude)
{
    const int32_t field = (int32_t)(magnitude >> 23);
    const uint64_t digits = (uint64_t)magnitude << 40;
    if (field == 0) {
        return motor_single_delay_normalised(digits, -126);
    }
    return motor_single_delay_scaled(digits | (UINT64_C(1) << 63), field - 127);
}

/* 2/pi after 32 zero bits. */
static const uint32_t MOTOR_SINGLE_DELAY_TWO_OVER_PI_F32[9] = {
    UINT32_C(0x00000000), UINT32_C(0xA2F9836E), UINT32_C(0x4E441529),
    UINT32_C(0xFC2757D1), UINT32_C(0xF534DDC0), UINT32_C(0xDB629599),
    UINT32_C(0x3C439041), UINT32_C(0xFE5163AB), UINT32_C(0xDEBBC561)};

/* 32 bits of 2/pi from bit 32 slot + shift on. */
static uint64_t motor_single_delay_window_f32(uint32_t slot, uint32_t shift)
{
    const uint64_t first = (uint64_t)(MOTOR_SINGLE_DELAY_TWO_OVER_PI_F32[slot]);
    const uint64_t second = (uint64_t)(MOTOR_SINGLE_DELAY_TWO_OVER_PI_F32[slot + 1]);
    return (((first << 32) | second) >> (32 - shift)) & 0xFFFFFFFFu;
}

/* a b, relative error below 2^-60. */
static motor_single_delay_scaled_t motor_single_delay_product(motor_single_delay_scaled_t a, motor_single_delay_scaled_t b)
{
    return motor_single_delay_settled(motor_single_delay_mul_high(a.significand, b.significand),
                            a.exponent + b.exponent + 1);
}

/* pi with 62 fraction bits; as a significand also pi/2 and pi/4. */
#define MOTOR_SINGLE_DELAY_PI UINT64_C(0xC90FDAA22168C235)

/* The angle of (high, low) / 2^126 quarter turns, its rest exact to 2^-60 of itself. */
static motor_single_delay_turned_t motor_single_delay_turned_from_quarters(uint64_t high, uint64_t low)
{
    const uint64_t eighths = high >> 61;
    const int negative = (eighths & 1) != 0;
    uint64_t upper = (high << 2) | (low >> 62);
    uint64_t lower = low << 2;
    if (negative) {
        upper = (lower == 0) ? (UINT64_C(0) - upper) : UINT64_MAX - upper;
        lower = (UINT64_C(0) - lower);
    }
    const int32_t shift = motor_single_delay_leading_zeros(upper | 1);
    const uint64_t significand = (upper << shift) | ((lower >> 1) >> (63 - shift));
    const motor_single_delay_signed_t rest = motor_single_delay_signed(
        motor_single_delay_product(motor_single_delay_scaled(significand, -1 - shift), motor_single_delay_scaled(MOTOR_SINGLE_DELAY_PI, 0)),
        negative);
    return motor_single_delay_turned(rest, (uint32_t)(((eighths + 1) >> 1) & 3));
}

/* The angle with these bits, positive and finite, its rest exact to 2^-38 of itself. */
static motor_single_delay_turned_t motor_single_delay_reduce_f32(uint32_t magnitude)
{
    if (magnitude <= 0x3F490FDAu) {
        return motor_single_delay_turned(motor_single_delay_signed(motor_single_delay_unpacked_f32(magnitude), 0), 0);
    }
    const uint64_t digits = (uint64_t)((magnitude & 0x007FFFFFu) | 0x00800000u);
    const uint32_t start = (magnitude >> 23) - 120;
    const uint32_t slot = start >> 5;
    const uint32_t shift = start & 31;
    const uint64_t upper = (motor_single_delay_window_f32(slot, shift) * digits) << 32;
    const uint64_t middle = motor_single_delay_window_f32(slot + 1, shift) * digits;
    const uint64_t lower = motor_single_delay_window_f32(slot + 2, shift) * digits;
    return motor_single_delay_turned_from_quarters(((upper + middle) + (lower >> 32)), lower << 32);
}

/* x rounded to the nearest, ties to even, with subnormals and overflow, and the sign put in. */
static float motor_single_delay_rounded_f32(uint32_t sign, motor_single_delay_scaled_t x)
{
    const int32_t field = x.exponent + 127;
    if (field >= 255) {
        return motor_single_delay_f32_from_bits(sign | MOTOR_SINGLE_DELAY_INFINITY_F32);
    }
    const int32_t shift = (field > 0) ? 40 : 41 - field;
    if (shift > 63) {
        const int least = shift == 64 && x.significand > (UINT64_C(1) << 63);
        return motor_single_delay_f32_from_bits(least ? sign + 1 : sign);
    }
    const uint64_t kept = x.significand >> shift;
    const uint64_t rest = x.significand - (kept << shift);
    const uint64_t half = UINT64_C(1) << (shift - 1);
    const uint64_t odd = kept & 1;
    const uint64_t up = (rest + odd > half) ? 1 : 0;
    const uint32_t base = (field > 0) ? ((uint32_t)(field - 1)) << 23 : 0;
    return motor_single_delay_f32_from_bits(sign | (base + ((uint32_t)(kept + up))));
}

/* The sign bit of a negative number, else 0. */
static uint32_t motor_single_delay_sign_f32(int negative)
{
    if (negative) {
        return MOTOR_SINGLE_DELAY_SIGN_F32;
    }
    return 0;
}

/* Sine of an angle in radians, the nearest float. */
static float motor_single_delay_sin_f32(float x)
{
    const uint32_t bits = motor_single_delay_f32_to_bits(x);
    const uint32_t magnitude = bits & MOTOR_SINGLE_DELAY_MAGNITUDE_F32;
    if (magnitude >= MOTOR_SINGLE_DELAY_INFINITY_F32) {
        return motor_single_delay_f32_from_bits(MOTOR_SINGLE_DELAY_NAN_F32);
    }
    if (magnitude == 0) {
        return x;
    }
    const motor_single_delay_signed_t value = motor_single_delay_sine_at(motor_single_delay_reduce_f32(magnitude));
    return motor_single_delay_rounded_f32((bits & MOTOR_SINGLE_DELAY_SIGN_F32) ^ motor_single_delay_sign_f32(value.negative),
                                value.magnitude);
}

/* What one part of a step hands to the next. */
typedef struct {
    uint32_t t11;
    float t21;
    float t32;
    uint32_t t39;
    float t109;
    float t110;
    float t111;
    motor_single_delay_status t118;
} motor_single_delay_work;

/* Part 1 of a step. */
static void motor_single_delay_part_1(motor_single_delay_state *state, const motor_single_delay_measurements *measurements, const motor_single_delay_inputs *inputs, motor_single_delay_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    const uint32_t t0 = state->newest;
    const uint32_t t1 = (t0 < 100U) ? t0 : 100U;
    const uint32_t t2 = state->count;
    const int t4 = 100U < t2;
    const float t5 = measurements->y;
    const int t6 = (-1e35f <= t5) && (t5 <= 1e35f);
    const float t7 = inputs->u;
    const int t8 = (-1e35f <= t7) && (t7 <= 1e35f);
    const float t9 = state->u[t1];
    const float t10 = t8 ? t7 : t9;

    /* prediction, for a sample that is missing */
    work->t11 = (t1 < 100U) ? (t1 + 1U) : 0U;
    const float t12 = state->ahead_y;
    const float t14 = 9.516694e-8f * t10;
    const float t15 = t12 + t14;
    const float t16 = state->y[t1];
    const int t17 = (-1e35f <= t15) && (t15 <= 1e35f);
    const int t18 = t4 && t17;
    const float t19 = t18 ? t15 : t16;
    const float t20 = t6 ? t5 : t19;
    work->t21 = motor_single_delay_sin_f32(t20);
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
    const uint32_t t35 = (t2 < 101U) ? (t2 + 1U) : 101U;
    const uint32_t t36 = t31 ? 0U : t35;
    const uint32_t t37 = t8 ? t35 : 1U;
    const uint32_t t38 = t6 ? t37 : 0U;
    work->t39 = t4 ? t36 : t38;
    state->count = work->t39;
    const uint32_t t40 = state->coasting;
    const uint32_t t41 = (t40 > 0U) ? (t40 - 1U) : 0U;
    const uint32_t t42 = t8 ? t41 : 100U;
    const uint32_t t44 = t6 ? t42 : 101U;
    state->coasting = t44;

    /* into the window */
    state->newest = work->t11;
    state->y[work->t11] = work->t32;
    state->u[work->t11] = t10;
    state->sin_q[work->t11] = work->t21;
}

/* Part 2 of a step. */
static void motor_single_delay_part_2(motor_single_delay_state *state, motor_single_delay_work *work)
{
    /* the sums over the window, newest sample first */
    float t46 = 0.0f;
    float t47 = 0.0f;
    float t48 = 0.0f;
    float t49 = 0.0f;
    float t50 = 0.0f;
    float t51 = 0.0f;
    float t52 = 0.0f;
    uint32_t t53 = work->t11;
    for (uint32_t row = 0U; row < 100U; ++row) {
        const float *const gains = MOTOR_SINGLE_DELAY_WINDOW[row];
        const float t54 = state->y[t53];
        const float t55 = gains[0];
        const float t56 = t55 * t54;
        const float t57 = t46 + t56;
        const float t58 = gains[1];
        const float t59 = t58 * t54;
        const float t60 = t47 + t59;
        const float t61 = gains[2];
        const float t62 = t61 * t54;
        const float t63 = t50 + t62;
        const float t64 = state->u[t53];
        const float t65 = gains[3];
        const float t66 = t65 * t64;
        const float t67 = t48 + t66;
        const float t68 = gains[4];
        const float t69 = t68 * t64;
        const float t70 = t51 + t69;
        const float t71 = state->sin_q[t53];
        const float t72 = gains[5];
        const float t73 = t72 * t71;
        const float t74 = t49 + t73;
        const float t75 = gains[6];
        const float t76 = t75 * t71;
        const float t77 = t52 + t76;
        const uint32_t t78 = ((t53 >= 1U) && (t53 < 101U)) ? (t53 - 1U) : 100U;
        t46 = t57;
        t47 = t60;
        t48 = t67;
        t49 = t74;
        t50 = t63;
        t51 = t70;
        t52 = t77;
        t53 = t78;
    }
    const float t79 = state->y[t53];
    const float t80 = 0.0f * t79;
    const float t81 = t46 + t80;
    const float t83 = 0.535296f * t79;
    const float t84 = t47 + t83;
    const float t86 = -0.09929901f * t79;
    const float t87 = t50 + t86;
    const float t88 = state->sin_q[t53];
    const float t90 = 3.1232528e-6f * t88;
    const float t91 = t49 + t90;
    const float t93 = -5.7937274e-7f * t88;
    const float t94 = t52 + t93;
    const float t95 = t84 + t48;
    const float t96 = t95 + t91;
    const float t97 = t87 + t51;
    const float t98 = t97 + t94;

    /* the next measurement, as far as it is known */
    const float t100 = 0.0009994135f * t96;
    const float t102 = 7.021338e-6f * t98;
    const float t104 = -1.7493403e-5f * work->t21;
    const float t105 = t81 + t100;
    const float t106 = t105 + t102;
    const float t107 = t106 + t104;
    state->ahead_y = t107;

    /* the estimate; until the window is full, the start */
    const int t108 = 100U < work->t39;
    work->t109 = t108 ? t81 : work->t32;
    work->t110 = t108 ? t96 : 0.0f;
    work->t111 = t108 ? t98 : 0.0f;
    const uint32_t t112 = state->coasting;
    const int t113 = t112 == 0U;
    const motor_single_delay_status t117 = t113 ? MOTOR_SINGLE_DELAY_CONVERGED : MOTOR_SINGLE_DELAY_COASTING;
    work->t118 = t108 ? t117 : MOTOR_SINGLE_DELAY_CONVERGING;
}

void motor_single_delay_init(motor_single_delay_state *state)
{
    for (uint32_t slot = 0U; slot < 101U; ++slot) {
        state->y[slot] = 0.0f;
    }
    for (uint32_t slot = 0U; slot < 101U; ++slot) {
        state->u[slot] = 0.0f;
    }
    for (uint32_t slot = 0U; slot < 101U; ++slot) {
        state->sin_q[slot] = 0.0f;
    }
    state->newest = 100U;
    state->count = 0U;
    state->coasting = 0U;
    state->ahead_y = 0.0f;
}

void motor_single_delay_step(motor_single_delay_state *state, const motor_single_delay_measurements *measurements,
                             const motor_single_delay_inputs *inputs, motor_single_delay_estimate *estimate)
{
    motor_single_delay_work work;
    motor_single_delay_part_1(state, measurements, inputs, &work);
    motor_single_delay_part_2(state, &work);

    estimate->q = work.t109;
    estimate->dq = work.t110;
    estimate->i = work.t111;
    estimate->status = work.t118;
}
