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
#pragma GCC optimize("fp-contract=off")
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
        0.02845563f, 0.009093693f, 0.024881342f, 0.008490728f, 0.012868842f, 0.11753469f,
        0.4938206f, 0.10384394f, 1.2962092e-5f, 0.0039202496f, -0.00026802561f, 0.00048639686f,
        -4.266438e-6f, -0.001972877f, 9.1594e-5f, -0.00016621931f
    },
    {
        0.028330969f, 0.007973084f, 0.0202336f, 0.007498579f, 0.01250995f, 0.11265863f, 0.4679478f,
        0.099720284f, 3.4431392e-5f, 0.0037230349f, -0.0009603204f, 0.0012276948f, -2.4502464e-5f,
        -0.003828601f, 0.00058530935f, -0.00088617764f
    },
    {
        0.02820993f, 0.0069016786f, 0.015846938f, 0.0065480415f, 0.01214818f, 0.107743524f,
        0.441868f, 0.095563605f, 4.7743008e-5f, 0.0034567474f, -0.001936159f, 0.0016692363f,
        -4.1651158e-5f, -0.0035945424f, 0.0014294153f, -0.0014696167f
    },
    {
        0.028092543f, 0.005879872f, 0.011723459f, 0.005639449f, 0.011783509f, 0.1027891f,
        0.4155798f, 0.09137366f, 5.5407054e-5f, 0.0031453439f, -0.00309132f, 0.0018938808f,
        -5.1959898e-5f, -0.003303988f, 0.00250235f, -0.001796798f
    },
    {
        0.027978834f, 0.0049080625f, 0.007865274f, 0.004773139f, 0.011415914f, 0.09779509f,
        0.3890819f, 0.08715024f, 5.8715334e-5f, 0.0028063832f, -0.00434912f, 0.0019628354f,
        -5.7407877e-5f, -0.0029775705f, 0.003714253f, -0.0019392467f
    },
    {
        0.027868833f, 0.003986652f, 0.0042745145f, 0.003949451f, 0.011045374f, 0.09276127f,
        0.3623731f, 0.08289312f, 5.848613e-5f, 0.0024528427f, -0.0056528077f, 0.0019214153f,
        -5.8847978e-5f, -0.002630379f, 0.004999089f, -0.001949767f
    },
    {
        0.027762573f, 0.003116045f, 0.0009533285f, 0.0031687266f, 0.01067187f, 0.08768741f,
        0.33545244f, 0.07860213f, 5.575358e-5f, 0.0020944928f, -0.006959886f, 0.001803335f,
        -5.7293164e-5f, -0.0022737368f, 0.006307505f, -0.0018676111f
    },
    {
        0.027660083f, 0.0022966496f, -0.0020961189f, 0.0024313116f, 0.01029538f, 0.082573324f,
        0.30831912f, 0.074277095f, 5.128705e-5f, 0.0017385746f, -0.0082388595f, 0.0016335737f,
        -5.363858e-5f, -0.001916086f, 0.0076027783f, -0.0017219079f
    },
    {
        0.02756139f, 0.0015288774f, -0.0048716445f, 0.0017375541f, 0.009915887f, 0.077418886f,
        0.28097266f, 0.069917895f, 4.5659726e-5f, 0.0013904547f, -0.009466387f, 0.0014306386f,
        -4.8550613e-5f, -0.0015636839f, 0.008857694f, -0.0015342392f
    },
    {
        0.02746653f, 0.00081314286f, -0.007371049f, 0.0010878041f, 0.009533373f, 0.072224006f,
        0.25341305f, 0.06552445f, 3.9299404e-5f, 0.0010541113f, -0.0106251715f, 0.0012082427f,
        -4.2526124e-5f, -0.0012211682f, 0.010052085f, -0.0013205952f
    },
    {
        0.027375529f, 0.00014986398f, -0.009592114f, 0.00048241552f, 0.009147824f, 0.06698872f,
        0.22564088f, 0.061096765f, 3.252612e-5f, 0.000732493f, -0.011702392f, 0.000976546f,
        -3.5936344e-5f, -0.00089197693f, 0.011171002f, -0.0010928239f
    },
    {
        0.02728842f, -0.00046053797f, -0.011532605f, -7.825553e-5f, 0.008759227f, 0.061713144f,
        0.19765747f, 0.056634925f, 2.5580042e-5f, 0.00042778553f, -0.012688556f, 0.0007430766f,
        -2.9059389e-5f, -0.00057865813f, 0.012203372f, -0.0008597037f
    },
    {
        0.027205233f, -0.0010176382f, -0.013190266f, -0.0005938498f, 0.008367576f, 0.05639758f,
        0.16946529f, 0.052139148f, 1.86421e-5f, 0.00014160824f, -0.013576632f, 0.0005134118f,
        -2.2104332e-5f, -0.00028310023f, 0.013140993f, -0.00062773866f
    },
    {
        0.027126001f, -0.0015210087f, -0.014562827f, -0.0010640053f, 0.00797287f, 0.05104254f,
        0.14106824f, 0.047609832f, 1.1849288e-5f, -0.00012483993f, -0.014361425f, 0.0002916832f,
        -1.5229047e-5f, -6.7020264e-6f, 0.013977798f, -0.00040174724f
    },
    {
        0.027050756f, -0.0019702178f, -0.015647998f, -0.001488357f, 0.007575116f, 0.045648836f,
        0.112472236f, 0.0430476f, 5.3059844e-6f, -0.00037067267f, -0.015039106f, 8.095006e-5f,
        -8.553412e-6f, 0.00024950152f, 0.014709307f, -0.00018529817f
    },
    {
        0.026979528f, -0.0023648303f, -0.01644347f, -0.0018665369f, 0.0071743326f, 0.040217668f,
        0.083685875f, 0.038453404f, -9.0767645e-7f, -0.0005952369f, -0.015606866f, -0.0001165237f,
        -2.1690855e-6f, 0.00048474636f, 0.015332226f, 1.8966643e-5f
    },
    {
        0.026912352f, -0.002704408f, -0.016946917f, -0.0021981744f, 0.0067705526f, 0.034750797f,
        0.05472138f, 0.033828624f, -6.729608e-6f, -0.00079805433f, -0.01606267f, -0.00029906526f,
        3.853262e-6f, 0.000698471f, 0.01584415f, 0.0002090934f
    },
    {
        0.026849259f, -0.002988509f, -0.017155994f, -0.0024828955f, 0.0063638305f, 0.029250702f,
        0.0255959f, 0.02917522f, -1.2111203e-5f, -0.000978779f, -0.01640507f, -0.00046544176f,
        9.45861e-6f, 0.0008902663f, 0.016243352f, 0.00038364003f
    },
    {
        0.02679028f, -0.0032166871f, -0.017068334f, -0.0027203234f, 0.0059542474f, 0.023720853f,
        -0.003666796f, 0.02449595f, -1.7013977e-5f, -0.0011371667f, -0.016633078f, -0.00061474927f,
        1.4603651e-5f, 0.0010598393f, 0.016528623f, 0.000541546f
    },
    {
        0.026735451f, -0.0033884936f, -0.016681556f, -0.002910078f, 0.0055419225f, 0.018166061f,
        -0.03303397f, 0.01979463f, -2.1407108e-5f, -0.001273053f, -0.016746083f, -0.0007463312f,
        1.9253903e-5f, 0.0012069871f, 0.016699167f, 0.00068203686f
    },
    {
        0.026684806f, -0.0035034753f, -0.015993256f, -0.003051777f, 0.005127026f, 0.012592939f,
        -0.06246078f, 0.015076519f, -2.526566e-5f, -0.0013863392f, -0.016743787f, -0.0008597195f,
        2.3381612e-5f, 0.001331579f, 0.016754534f, 0.0008045544f
    },
    {
        0.026638374f, -0.0035611764f, -0.015001013f, -0.0031450337f, 0.004709795f, 0.007010531f,
        -0.09188604f, 0.010348817f, -2.8569331e-5f, -0.001476984f, -0.016626189f, -0.00095459254f,
        2.696425e-5f, 0.0014335458f, 0.016694574f, 0.0009087067f
    },
    {
        0.026596194f, -0.0035611363f, -0.013702385f, -0.0031894594f, 0.004290561f, 0.0014311795f,
        -0.12122652f, 0.005621353f, -3.1301613e-5f, -0.0015449997f, -0.016393578f, -0.0010307463f,
        2.9983463e-5f, 0.0015128729f, 0.016519433f, 0.0009942328f
    },
    {
        0.026558297f, -0.0035028914f, -0.012094912f, -0.003184662f, 0.0038697799f, -0.0041283364f,
        -0.15036917f, 0.00090749474f, -3.3449265e-5f, -0.001590454f, -0.016046567f, -0.001088076f,
        3.2424407e-5f, 0.0015696f, 0.016229559f, 0.0010609796f
    },
    {
        0.026524717f, -0.0033859743f, -0.010176114f, -0.0031302457f, 0.0034480751f, -0.009645239f,
        -0.17916076f, -0.003774603f, -3.500208e-5f, -0.0016134764f, -0.015586143f, -0.0011265675f,
        3.427537e-5f, 0.001603825f, 0.015825743f, 0.0011088878f
    },
    {
        0.026495492f, -0.0032099136f, -0.007943488f, -0.0030258123f, 0.003026299f, -0.015088655f,
        -0.20739372f, -0.008400327f, -3.5952915e-5f, -0.0016142699f, -0.01501376f, -0.0011462953f,
        3.5527668e-5f, 0.0016157129f, 0.015309198f, 0.0011379877f
    },
    {
        0.026470654f, -0.0029742343f, -0.0053945147f, -0.0028709602f, 0.002605611f, -0.02041678f,
        -0.23478726f, -0.012936344f, -3.6297995e-5f, -0.0015931295f, -0.0143314665f, -0.0011474303f,
        3.61758e-5f, 0.0016055108f, 0.014681662f, 0.001148401f
    },
    {
        0.02645024f, -0.0026784574f, -0.002526653f, -0.0026652839f, 0.0021875857f, -0.025573056f,
        -0.2609616f, -0.017337551f, -3.6037483e-5f, -0.0015504691f, -0.0135420915f, -0.0011302545f,
        3.6217898e-5f, 0.0015735707f, 0.013945557f, 0.0011403522f
    },
    {
        0.026434282f, -0.0023221003f, 0.0006626581f, -0.0024083755f, 0.0017743581f, -0.030481009f,
        -0.28540337f, -0.021542953f, -3.517641e-5f, -0.0014868587f, -0.012649502f, -0.0010951872f,
        3.565647e-5f, 0.0015203808f, 0.013104207f, 0.0011141897f
    },
    {
        0.026422821f, -0.0019046764f, 0.004176001f, -0.0020998234f, 0.0013688201f, -0.035037275f,
        -0.30741906f, -0.025470106f, -3.372605e-5f, -0.0014030768f, -0.011658947f, -0.0010428227f,
        3.4499542e-5f, 0.0014466107f, 0.012162136f, 0.0010704166f
    },
    {
        0.02641589f, -0.0014256954f, 0.008015978f, -0.0017392131f, 0.0009748851f, -0.039102197f,
        -0.32607162f, -0.029007608f, -3.1705815e-5f, -0.0013001794f, -0.010577536f, -0.00097398413f,
        3.2762266e-5f, 0.0013531705f, 0.011125478f, 0.0010097364f
    },
    {
        0.026413525f, -0.00088466256f, 0.012185212f, -0.0013261262f, 0.0005978451f, -0.042487126f,
        -0.34009558f, -0.032004975f, -2.91459e-5f, -0.0011795965f, -0.009414878f, -0.00088979775f,
        3.0469197e-5f, 0.0012412947f, 0.010002532f, 0.0009331167f
    },
    {
        0.026415765f, -0.00028107964f, 0.01668635f, -0.00086014107f, 0.00024485376f, -0.04493727f,
        -0.34778202f, -0.034258954f, -2.609088e-5f, -0.0010432615f, -0.008183949f, -0.00079179497f,
        2.7657376e-5f, 0.0011126522f, 0.008804507f, 0.00084187655f
    },
    {
        0.026422644f, 0.00038555582f, 0.021522054f, -0.0003408331f, -7.442265e-5f, -0.046108574f,
        -0.34682333f, -0.03549507f, -2.2604605e-5f, -0.000893785f, -0.006902268f, -0.0006820508f,
        2.438055e-5f, 0.00096949877f, 0.0075465403f, 0.000737806f
    },
    {
        0.026434202f, 0.0011157502f, 0.026695017f, 0.00023222613f, -0.00034692592f, -0.045536466f,
        -0.33410394f, -0.0353427f, -1.8776833e-5f, -0.00073469226f, -0.0055934805f, -0.0005633716f,
        2.0714895e-5f, 0.0008148798f, 0.0062490636f, 0.00062332803f
    },
    {
        0.026450476f, 0.0019100141f, 0.03220794f, 0.00085946836f, -0.0005550192f, -0.042593695f,
        -0.3054175f, -0.033301458f, -1.4732187e-5f, -0.00057074154f, -0.0042894976f,
        -0.00043954913f, 1.676675e-5f, 0.0006529067f, 0.004939652f, 0.00050171744f
    },
    {
        0.026471503f, 0.002768862f, 0.038063563f, 0.0015413287f, -0.0006748849f, -0.03643344f,
        -0.2550853f, -0.028695751f, -1.0642275e-5f, -0.00040835506f, -0.0030333856f,
        -0.00031570386f, 1.2683082e-5f, 0.000489129f, 0.00365552f, 0.0003773978f
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

/* Bits of the sign, of the largest magnitude, of infinity, of the only NaN returned, of 1. */
#define LATE_POSITION_SIGN_F32 UINT32_C(0x80000000)
#define LATE_POSITION_MAGNITUDE_F32 UINT32_C(0x7FFFFFFF)
#define LATE_POSITION_INFINITY_F32 UINT32_C(0x7F800000)
#define LATE_POSITION_NAN_F32 UINT32_C(0x7FC00000)
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

/* 1 / log(2) with 127 fraction bits. */
#define LATE_POSITION_LOG2_E UINT64_C(0xB8AA3B295C17F0BB)
#define LATE_POSITION_LOG2_E_LOW UINT64_C(0xBE87FED0691D3E88)

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
    float t12;
    uint32_t t13;
    uint32_t t15;
    float t27;
    float t36;
    float t46;
    uint32_t t73;
    float t84;
    float t85;
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
    uint32_t t100;
    float t154;
    float t246;
    float t250;
    float t253;
    float t256;
    float t259;
    float t263;
    float t266;
    float t269;
    float t272;
    uint32_t t273;
    float t274;
    float t277;
    float t280;
    float t283;
    float t325;
    float t326;
    float t327;
    float t328;
    late_position_status t335;
} late_position_work;

/* Part 1 of a step. */
static void late_position_part_1(late_position_state *state, const late_position_measurements *measurements, const late_position_inputs *inputs, late_position_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    const uint32_t t0 = state->newest;
    const uint32_t t1 = (t0 < 40U) ? t0 : 40U;
    const uint32_t t2 = state->count;
    const int t4 = 40U < t2;
    const float t5 = measurements->camera;
    const int t6 = (-1e36f <= t5) && (t5 <= 1e36f);
    const float t7 = measurements->wheel;
    const int t8 = (-20.0f <= t7) && (t7 <= 20.0f);
    const float t9 = inputs->force;
    const int t10 = (-1e36f <= t9) && (t9 <= 1e36f);
    const float t11 = state->force[t1];
    work->t12 = t10 ? t9 : t11;

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
    const float t23 = t4 ? t20 : t22;
    const float t24 = t8 ? t7 : t23;
    const float t26 = 20.0f * t24;
    work->t27 = late_position_tanh_f32(t26);
    const float t28 = state->tanh_20_wheel[t1];
    const int t29 = (-1e36f <= t16) && (t16 <= 1e36f);
    const int t31 = 43U < t2;
    const int t32 = t31 && t29;
    const float t33 = t32 ? t16 : t21;
    const int t34 = t6 || t32;
    const int t35 = !t34;
    work->t36 = t6 ? t5 : t33;
    const float t37 = work->t27 - t28;
    const float t39 = -0.00018548031f * t37;
    const float t40 = t20 + t39;
    const int t41 = (-20.0f <= t40) && (t40 <= 20.0f);
    const int t42 = t4 && t41;
    const float t43 = t42 ? t40 : t22;
    const int t44 = t8 || t42;
    const int t45 = !t44;
    work->t46 = t8 ? t7 : t43;
    const uint32_t t47 = state->missed_camera;
    const int t49 = 36U < t47;
    const int t50 = !t6;
    const int t51 = t50 && t49;
    const uint32_t t53 = (t47 < 37U) ? (t47 + 1U) : 37U;
    const uint32_t t54 = t6 ? 0U : t53;
    state->missed_camera = t54;
    const uint32_t t55 = state->missed_wheel;
    const int t56 = 40U < t55;
    const int t57 = !t8;
    const int t58 = t57 && t56;
    const uint32_t t59 = (t55 < 41U) ? (t55 + 1U) : 41U;
    const uint32_t t60 = t8 ? 0U : t59;
    state->missed_wheel = t60;
    const int t61 = t51 || t58;
    const int t62 = t51 && t58;
    const int t63 = !t62;
    const int t64 = t61 && t63;
    const int t65 = t8 && t6;
    const int t66 = t35 || t45;
    const int t67 = t66 || t64;

    /* how much of the window is good */
    const uint32_t t69 = (t2 < 44U) ? (t2 + 1U) : 44U;
    const uint32_t t70 = t67 ? 0U : t69;
    const uint32_t t71 = t10 ? t69 : 1U;
    const uint32_t t72 = t65 ? t71 : 0U;
    work->t73 = t4 ? t70 : t72;
    state->count = work->t73;
    const uint32_t t74 = state->coasting;
    const uint32_t t75 = (t74 > 0U) ? (t74 - 1U) : 0U;
    const uint32_t t76 = t10 ? t75 : 40U;
    const int t78 = t76 < 37U;
    const uint32_t t79 = t78 ? 37U : t76;
    const uint32_t t80 = t6 ? t76 : t79;
    const uint32_t t82 = t8 ? t80 : 41U;
    state->coasting = t82;
}

/* Part 2 of a step. */
static void late_position_part_2(late_position_state *state, const late_position_work *work)
{
    /* into the window */
    state->newest = work->t13;
    state->camera[work->t13] = work->t36;
    state->wheel[work->t13] = work->t46;
    state->force[work->t13] = work->t12;
    state->tanh_20_wheel[work->t13] = work->t27;
}

/* Part 3 of a step. */
static void late_position_part_3(const late_position_state *state, late_position_work *work)
{
    /* the sums over the window, newest sample first */
    work->t84 = 0.0f;
    work->t85 = 0.0f;
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
    work->t100 = work->t13;
    for (uint32_t row = 0U; row < 37U; ++row) {
        const float *const gains = LATE_POSITION_WINDOW[row];
        const float t101 = state->camera[work->t100];
        const float t102 = gains[0];
        const float t103 = t102 * t101;
        const float t104 = work->t84 + t103;
        const float t105 = gains[1];
        const float t106 = t105 * t101;
        const float t107 = work->t88 + t106;
        const float t108 = gains[2];
        const float t109 = t108 * t101;
        const float t110 = work->t92 + t109;
        const float t111 = gains[3];
        const float t112 = t111 * t101;
        const float t113 = work->t96 + t112;
        const float t114 = state->wheel[work->t100];
        const float t115 = gains[4];
        const float t116 = t115 * t114;
        const float t117 = work->t85 + t116;
        const float t118 = gains[5];
        const float t119 = t118 * t114;
        const float t120 = work->t89 + t119;
        const float t121 = gains[6];
        const float t122 = t121 * t114;
        const float t123 = work->t93 + t122;
        const float t124 = gains[7];
        const float t125 = t124 * t114;
        const float t126 = work->t97 + t125;
        const float t127 = state->force[work->t100];
        const float t128 = gains[8];
        const float t129 = t128 * t127;
        const float t130 = work->t86 + t129;
        const float t131 = gains[9];
        const float t132 = t131 * t127;
        const float t133 = work->t90 + t132;
        const float t134 = gains[10];
        const float t135 = t134 * t127;
        const float t136 = work->t94 + t135;
        const float t137 = gains[11];
        const float t138 = t137 * t127;
        const float t139 = work->t98 + t138;
        const float t140 = state->tanh_20_wheel[work->t100];
        const float t141 = gains[12];
        const float t142 = t141 * t140;
        const float t143 = work->t87 + t142;
        const float t144 = gains[13];
        const float t145 = t144 * t140;
        const float t146 = work->t91 + t145;
        const float t147 = gains[14];
        const float t148 = t147 * t140;
        const float t149 = work->t95 + t148;
        const float t150 = gains[15];
        const float t151 = t150 * t140;
        const float t152 = work->t99 + t151;
        const uint32_t t153 = ((work->t100 >= 1U) && (work->t100 < 41U)) ? (work->t100 - 1U) : 40U;
        work->t84 = t104;
        work->t85 = t117;
        work->t86 = t130;
        work->t87 = t143;
        work->t88 = t107;
        work->t89 = t120;
        work->t90 = t133;
        work->t91 = t146;
        work->t92 = t110;
        work->t93 = t123;
        work->t94 = t136;
        work->t95 = t149;
        work->t96 = t113;
        work->t97 = t126;
        work->t98 = t139;
        work->t99 = t152;
        work->t100 = t153;
    }
    work->t154 = state->wheel[work->t100];
}

/* Part 4 of a step. */
static void late_position_part_4(const late_position_state *state, late_position_work *work)
{
    const float t156 = -0.00067436247f * work->t154;
    const float t157 = work->t85 + t156;
    const float t159 = -0.025912454f * work->t154;
    const float t160 = work->t89 + t159;
    const float t162 = -0.17544106f * work->t154;
    const float t163 = work->t93 + t162;
    const float t165 = -0.020613518f * work->t154;
    const float t166 = work->t97 + t165;
    const float t167 = state->force[work->t100];
    const float t169 = -6.7420488e-6f * t167;
    const float t170 = work->t86 + t169;
    const float t172 = -0.00025620064f * t167;
    const float t173 = work->t90 + t172;
    const float t175 = -0.0018832656f * t167;
    const float t176 = work->t94 + t175;
    const float t178 = -0.00019874866f * t167;
    const float t179 = work->t98 + t178;
    const float t180 = state->tanh_20_wheel[work->t100];
    const float t182 = 8.665618e-6f * t180;
    const float t183 = work->t87 + t182;
    const float t185 = 0.00033103646f * t180;
    const float t186 = work->t91 + t185;
    const float t188 = 0.0024468915f * t180;
    const float t189 = work->t95 + t188;
    const float t191 = 0.00025634188f * t180;
    const float t192 = work->t99 + t191;
    const uint32_t t193 = ((work->t100 >= 1U) && (work->t100 < 41U)) ? (work->t100 - 1U) : 40U;
    const float t194 = state->wheel[t193];
    const float t196 = -0.00051002926f * t194;
    const float t197 = t157 + t196;
    const float t199 = -0.009487389f * t194;
    const float t200 = t160 + t199;
    const float t202 = -0.056135755f * t194;
    const float t203 = t163 + t202;
    const float t205 = -0.007823485f * t194;
    const float t206 = t166 + t205;
    const float t207 = state->force[t193];
    const float t209 = -3.3518997e-6f * t207;
    const float t210 = t170 + t209;
    const float t212 = -0.00012597693f * t207;
    const float t213 = t173 + t212;
    const float t215 = -0.00091757893f * t207;
    const float t216 = t176 + t215;
    const float t218 = -9.8015036e-5f * t207;
    const float t219 = t179 + t218;
    const float t220 = state->tanh_20_wheel[t193];
    const float t222 = 4.989935e-6f * t220;
    const float t223 = t183 + t222;
    const float t225 = 0.00018873787f * t220;
    const float t226 = t186 + t225;
    const float t228 = 0.0013815487f * t220;
    const float t229 = t189 + t228;
    const float t231 = 0.00014661238f * t220;
    const float t232 = t192 + t231;
    const uint32_t t233 = ((t193 >= 1U) && (t193 < 41U)) ? (t193 - 1U) : 40U;
    const float t234 = state->wheel[t233];
    const float t236 = -0.00012326038f * t234;
    const float t237 = t197 + t236;
    const float t239 = 0.01492521f * t234;
    const float t240 = t200 + t239;
    const float t242 = 0.11680113f * t234;
    const float t243 = t203 + t242;
    const float t245 = 0.011336513f * t234;
    work->t246 = t206 + t245;
    const float t247 = state->force[t233];
    const float t249 = -9.074858e-7f * t247;
    work->t250 = t210 + t249;
    const float t252 = -3.347316e-5f * t247;
    work->t253 = t213 + t252;
    const float t255 = -0.00024219413f * t247;
    work->t256 = t216 + t255;
    const float t258 = -2.6098507e-5f * t247;
    work->t259 = t219 + t258;
    const float t260 = state->tanh_20_wheel[t233];
    const float t262 = 2.031227e-6f * t260;
    work->t263 = t223 + t262;
    const float t265 = 7.587662e-5f * t260;
    work->t266 = t226 + t265;
    const float t268 = 0.00055097224f * t260;
    work->t269 = t229 + t268;
    const float t271 = 5.9092672e-5f * t260;
    work->t272 = t232 + t271;
    work->t273 = ((t233 >= 1U) && (t233 < 41U)) ? (t233 - 1U) : 40U;
    work->t274 = state->wheel[work->t273];
    const float t276 = 0.00056509016f * work->t274;
    work->t277 = t237 + t276;
    const float t279 = 0.05013785f * work->t274;
    work->t280 = t240 + t279;
    const float t282 = 0.3622286f * work->t274;
    work->t283 = t243 + t282;
}

/* Part 5 of a step. */
static void late_position_part_5(late_position_state *state, late_position_work *work)
{
    const float t285 = 0.039110288f * work->t274;
    const float t286 = work->t246 + t285;
    const float t287 = state->tanh_20_wheel[work->t273];
    const float t289 = 2.991004e-7f * t287;
    const float t290 = work->t263 + t289;
    const float t292 = 1.086697e-5f * t287;
    const float t293 = work->t266 + t292;
    const float t295 = 7.863073e-5f * t287;
    const float t296 = work->t269 + t295;
    const float t298 = 8.472704e-6f * t287;
    const float t299 = work->t272 + t298;
    const float t300 = work->t84 + work->t277;
    const float t301 = t300 + work->t250;
    const float t302 = t301 + t290;
    const float t303 = work->t88 + work->t280;
    const float t304 = t303 + work->t253;
    const float t305 = t304 + t293;
    const float t306 = work->t92 + work->t283;
    const float t307 = t306 + work->t256;
    const float t308 = t307 + t296;
    const float t309 = work->t96 + t286;
    const float t310 = t309 + work->t259;
    const float t311 = t310 + t299;

    /* the next measurement, as far as it is known */
    state->ahead_camera[work->t15] = t302;
    const uint32_t t312 = (work->t15 < 3U) ? (work->t15 + 1U) : 0U;
    state->ahead_camera_slot = t312;
    const float t314 = 0.25809625f * t305;
    const float t316 = 0.0013568978f * t308;
    const float t318 = 0.7408182f * t311;
    const float t320 = -0.0005427591f * work->t27;
    const float t321 = t314 + t316;
    const float t322 = t321 + t318;
    const float t323 = t322 + t320;
    state->ahead_wheel = t323;

    /* the estimate; until the window is full, the start */
    const int t324 = 40U < work->t73;
    work->t325 = t324 ? t302 : 0.0f;
    work->t326 = t324 ? t305 : 0.0f;
    work->t327 = t324 ? t308 : 0.0f;
    work->t328 = t324 ? t311 : work->t46;
    const uint32_t t329 = state->coasting;
    const int t330 = t329 == 0U;
    const late_position_status t334 = t330 ? LATE_POSITION_CONVERGED : LATE_POSITION_COASTING;
    work->t335 = t324 ? t334 : LATE_POSITION_CONVERGING;
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

    estimate->position = work.t325;
    estimate->speed = work.t326;
    estimate->slope = work.t327;
    estimate->wheel = work.t328;
    estimate->status = work.t335;
}
