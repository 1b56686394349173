/* motor_intermittent.c: Finite-time observer: Direct-drive arm whose position arrives at irregular times.
 *
 * Generated; motor_intermittent.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "motor_intermittent.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "motor_intermittent.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "motor_intermittent.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
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
static const float MOTOR_INTERMITTENT_WINDOW[100][7] = {
    { 1.0f, 28.094048f, -5.2116547f, 0.00027817988f, 0.03625105f, -0.017329566f, 0.00017167821f },
    { 0.0f, -0.5668353f, 0.10515213f, 0.0007553789f, 0.02966479f, -0.03397549f, 0.00095477735f },
    { 0.0f, -0.5655637f, 0.10491621f, 0.0011302192f, 0.024260536f, -0.032954775f, 0.0017226487f },
    { 0.0f, -0.56375873f, 0.104581356f, 0.001421393f, 0.019826652f, -0.031942885f, 0.0023208254f },
    { 0.0f, -0.561455f, 0.10415397f, 0.0016442444f, 0.016189385f, -0.030942414f, 0.0027804559f },
    { 0.0f, -0.55868524f, 0.10364014f, 0.0018113687f, 0.013206084f, -0.029955452f, 0.003127105f },
    { 0.0f, -0.55548084f, 0.10304567f, 0.0019331038f, 0.010759628f, -0.028983673f, 0.0033817538f },
    { 0.0f, -0.5518716f, 0.10237611f, 0.0020179339f, 0.008753862f, -0.028028395f, 0.0035616183f },
    { 0.0f, -0.5478859f, 0.10163672f, 0.0020728216f, 0.0071098423f, -0.02709066f, 0.0036808245f },
    { 0.0f, -0.54355085f, 0.10083252f, 0.0021034798f, 0.0057627535f, -0.026171261f, 0.0037509599f },
    { 0.0f, -0.5388922f, 0.09996829f, 0.0021145947f, 0.0046593854f, -0.025270807f, 0.0037815287f },
    { 0.0f, -0.53393435f, 0.09904856f, 0.0021100105f, 0.0037560496f, -0.024389738f, 0.0037803242f },
    { 0.0f, -0.5287007f, 0.09807767f, 0.002092879f, 0.00301688f, -0.023528365f, 0.003753734f },
    { 0.0f, -0.5232133f, 0.09705971f, 0.0020657836f, 0.0024124298f, -0.022686886f, 0.0037069928f },
    { 0.0f, -0.5174933f, 0.0959986f, 0.0020308413f, 0.0019185243f, -0.021865405f, 0.0036443877f },
    { 0.0f, -0.5115607f, 0.09489804f, 0.0019897858f, 0.0015153161f, -0.021063956f, 0.0035694279f },
    { 0.0f, -0.50543433f, 0.09376155f, 0.0019440359f, 0.0011865112f, -0.020282505f, 0.003484984f },
    { 0.0f, -0.49913234f, 0.09259248f, 0.0018947519f, 0.00091873325f, -0.01952097f, 0.0033934016f },
    { 0.0f, -0.49267182f, 0.091394f, 0.0018428819f, 0.00070100033f, -0.018779222f, 0.0032965965f },
    { 0.0f, -0.48606896f, 0.09016912f, 0.0017891994f, 0.0005242975f, -0.018057099f, 0.00319613f },
    { 0.0f, -0.47933915f, 0.08892069f, 0.001734335f, 0.00038122397f, -0.017354406f, 0.0030932736f },
    { 0.0f, -0.47249696f, 0.0876514f, 0.0016788014f, 0.00026570476f, -0.016670931f, 0.0029890598f },
    {
        0.0f, -0.46555614f, 0.08636383f, 0.0016230146f, 0.00017275295f, -0.016006434f, 0.0028843258f
    },
    { 0.0f, -0.45852974f, 0.08506038f, 0.0015673115f, 9.8275195e-5f, -0.015360662f, 0.0027797476f },
    { 0.0f, -0.45143014f, 0.08374335f, 0.0015119634f, 3.891171e-5f, -0.014733347f, 0.00267587f },
    { 0.0f, -0.44426897f, 0.0824149f, 0.0014571887f, -8.095009e-6f, -0.014124213f, 0.0025731283f },
    {
        0.0f, -0.43705723f, 0.08107707f, 0.0014031612f, -4.5007993e-5f, -0.013532972f, 0.0024718703f
    },
    { 0.0f, -0.42980534f, 0.07973179f, 0.0013500189f, -7.36843e-5f, -0.01295933f, 0.0023723696f },
    { 0.0f, -0.42252308f, 0.07838088f, 0.0012978701f, -9.564766e-5f, -0.012402989f, 0.0022748406f },
    {
        0.0f, -0.4152197f, 0.077026054f, 0.0012467984f, -0.00011214817f, -0.011863645f,
        0.0021794485f
    },
    {
        0.0f, -0.4079039f, 0.07566892f, 0.0011968683f, -0.00012421125f, -0.011340991f, 0.0020863183f
    },
    { 0.0f, -0.40058386f, 0.074311f, 0.0011481269f, -0.00013267786f, -0.010834717f, 0.001995542f },
    {
        0.0f, -0.39326727f, 0.07295373f, 0.0011006085f, -0.00013823752f, -0.010344516f, 0.001907185f
    },
    {
        0.0f, -0.38596138f, 0.07159843f, 0.0010543362f, -0.00014145544f, -0.009870074f,
        0.0018212897f
    },
    {
        0.0f, -0.3786729f, 0.07024637f, 0.0010093241f, -0.00014279476f, -0.009411081f, 0.0017378813f
    },
    {
        0.0f, -0.3714082f, 0.068898715f, 0.00096557883f, -0.00014263479f, -0.008967226f,
        0.0016569701f
    },
    {
        0.0f, -0.3641732f, 0.067556575f, 0.0009231011f, -0.0001412861f, -0.008538201f, 0.0015785543f
    },
    {
        0.0f, -0.35697344f, 0.06622098f, 0.0008818867f, -0.00013900273f, -0.008123698f,
        0.0015026225f
    },
    {
        0.0f, -0.34981412f, 0.06489287f, 0.0008419274f, -0.00013599242f, -0.0077234083f,
        0.0014291552f
    },
    {
        0.0f, -0.34270003f, 0.06357316f, 0.0008032117f, -0.00013242483f, -0.007337028f,
        0.0013581271f
    },
    {
        0.0f, -0.33563563f, 0.062262665f, 0.0007657256f, -0.00012843838f, -0.006964256f,
        0.001289507f
    },
    {
        0.0f, -0.32862505f, 0.06096216f, 0.0007294528f, -0.00012414585f, -0.006604791f,
        0.0012232604f
    },
    {
        0.0f, -0.32167217f, 0.059672356f, 0.00069437554f, -0.000119639015f, -0.006258337f,
        0.001159349f
    },
    {
        0.0f, -0.31478053f, 0.058393907f, 0.0006604745f, -0.000114992356f, -0.005924599f,
        0.0010977323f
    },
    {
        0.0f, -0.30795333f, 0.057127416f, 0.0006277295f, -0.000110266206f, -0.005603286f,
        0.0010383679f
    },
    {
        0.0f, -0.3011936f, 0.055873442f, 0.00059611956f, -0.000105509265f, -0.00529411f,
        0.0009812115f
    },
    {
        0.0f, -0.29450402f, 0.054632485f, 0.0005656229f, -0.00010076072f, -0.0049967864f,
        0.00092621834f
    },
    { 0.0f, -0.2878871f, 0.053405f, 0.0005362174f, -9.605193e-5f, -0.0047110333f, 0.0008733425f },
    {
        0.0f, -0.28134504f, 0.05219141f, 0.00050788076f, -9.1407856e-5f, -0.0044365735f,
        0.00082253764f
    },
    { 0.0f, -0.2748799f, 0.050992083f, 0.00048059033f, -8.68482e-5f, -0.004173133f, 0.0007737572f },
    {
        0.0f, -0.26849338f, 0.049807344f, 0.00045432337f, -8.23884e-5f, -0.003920441f,
        0.00072695455f
    },
    {
        0.0f, -0.2621871f, 0.048637487f, 0.0004290572f, -7.804032e-5f, -0.0036782308f, 0.0006820831f
    },
    {
        0.0f, -0.25596237f, 0.047482762f, 0.00040476906f, -7.3813e-5f, -0.0034462393f,
        0.00063909637f
    },
    {
        0.0f, -0.24982038f, 0.046343382f, 0.0003814364f, -6.97131e-5f, -0.0032242078f, 0.0005979484f
    },
    {
        0.0f, -0.24376203f, 0.04521952f, 0.0003590367f, -6.574537e-5f, -0.003011881f, 0.00055859325f
    },
    {
        0.0f, -0.23778808f, 0.044111315f, 0.00033754765f, -6.191299e-5f, -0.0028090072f,
        0.0005209858f
    },
    {
        0.0f, -0.23189908f, 0.043018866f, 0.00031694717f, -5.8217884e-5f, -0.0026153391f,
        0.00048508114f
    },
    {
        0.0f, -0.22609536f, 0.041942243f, 0.00029721338f, -5.4660908e-5f, -0.0024306336f,
        0.00045083498f
    },
    {
        0.0f, -0.22037709f, 0.040881466f, 0.00027832465f, -5.124211e-5f, -0.0022546507f,
        0.00041820362f
    },
    {
        0.0f, -0.21474418f, 0.039836526f, 0.00026025958f, -4.796085e-5f, -0.002087155f,
        0.00038714393f
    },
    {
        0.0f, -0.20919636f, 0.03880737f, 0.00024299706f, -4.4815948e-5f, -0.0019279143f,
        0.0003576134f
    },
    {
        0.0f, -0.20373312f, 0.037793905f, 0.00022651632f, -4.180578e-5f, -0.0017767013f,
        0.0003295702f
    },
    {
        0.0f, -0.19835372f, 0.036795996f, 0.00021079682f, -3.892838e-5f, -0.0016332917f,
        0.00030297306f
    },
    {
        0.0f, -0.19305718f, 0.035813455f, 0.00019581831f, -3.6181515e-5f, -0.0014974652f,
        0.0002777814f
    },
    {
        0.0f, -0.18784222f, 0.034846045f, 0.00018156091f, -3.3562723e-5f, -0.0013690055f,
        0.0002539553f
    },
    {
        0.0f, -0.18270728f, 0.033893485f, 0.00016800499f, -3.106939e-5f, -0.0012476997f,
        0.0002314555f
    },
    {
        0.0f, -0.17765044f, 0.032955408f, 0.00015513125f, -2.8698765e-5f, -0.0011333388f,
        0.0002102433f
    },
    {
        0.0f, -0.17266946f, 0.032031406f, 0.00014292066f, -2.6448017e-5f, -0.0010257171f,
        0.00019028074f
    },
    {
        0.0f, -0.16776162f, 0.031120976f, 0.00013135458f, -2.4314237e-5f, -0.0009246326f,
        0.0001715304f
    },
    {
        0.0f, -0.16292383f, 0.030223534f, 0.00012041457f, -2.2294478e-5f, -0.00082988647f,
        0.0001539555f
    },
    {
        0.0f, -0.15815236f, 0.029338399f, 0.00011008255f, -2.0385763e-5f, -0.0007412832f,
        0.00013751982f
    },
    {
        0.0f, -0.15344293f, 0.028464776f, 0.000100340716f, -1.8585099e-5f, -0.00065863034f,
        0.00012218775f
    },
    {
        0.0f, -0.1487906f, 0.027601741f, 9.117155e-5f, -1.6889495e-5f, -0.0005817384f,
        0.000107924156f
    },
    {
        0.0f, -0.14418955f, 0.026748221f, 8.2557795e-5f, -1.5295958e-5f, -0.00051042065f,
        9.4694435e-5f
    },
    {
        0.0f, -0.13963309f, 0.025902975f, 7.448248e-5f, -1.3801514e-5f, -0.00044449276f,
        8.246444e-5f
    },
    {
        0.0f, -0.13511346f, 0.025064558f, 6.6928864e-5f, -1.24031985e-5f, -0.0003837728f,
        7.120043e-5f
    },
    { 0.0f, -0.13062161f, 0.0242313f, 5.9880455e-5f, -1.109807e-5f, -0.00032808082f, 6.086906e-5f },
    {
        0.0f, -0.1261471f, 0.023401259f, 5.3320986e-5f, -9.883204e-6f, -0.00027723843f,
        5.1437255e-5f
    },
    {
        0.0f, -0.12167781f, 0.022572184f, 4.7234375e-5f, -8.755697e-6f, -0.00023106871f,
        4.2872198e-5f
    },
    {
        0.0f, -0.11719961f, 0.02174146f, 4.1604726e-5f, -7.712666e-6f, -0.00018939546f, 3.514122e-5f
    },
    {
        0.0f, -0.11269613f, 0.020906048f, 3.6416295e-5f, -6.751241e-6f, -0.00015204289f,
        2.8211723e-5f
    },
    {
        0.0f, -0.10814834f, 0.020062417f, 3.1653457e-5f, -5.8685673e-6f, -0.00011883499f,
        2.2051063e-5f
    },
    {
        0.0f, -0.103534065f, 0.019206457f, 2.7300659e-5f, -5.0617964e-6f, -8.959484e-5f,
        1.6626424e-5f
    },
    {
        0.0f, -0.09882753f, 0.018333383f, 2.3342407e-5f, -4.3280825e-6f, -6.414385e-5f,
        1.1904684e-5f
    },
    {
        0.0f, -0.093998715f, 0.01743763f, 1.9763193e-5f, -3.664573e-6f, -4.2300853e-5f, 7.852241e-6f
    },
    { 0.0f, -0.0890126f, 0.0165127f, 1.6547445e-5f, -3.068399e-6f, -2.3881052e-5f, 4.4348176e-6f },
    {
        0.0f, -0.083828405f, 0.015551029f, 1.367947e-5f, -2.5366662e-6f, -8.694784e-6f, 1.617235e-6f
    },
    {
        0.0f, -0.07839854f, 0.0145437885f, 1.1143373e-5f, -2.0664386e-6f, 3.4538848e-6f,
        -6.3685144e-7f
    },
    {
        0.0f, -0.07266747f, 0.013480681f, 8.922968e-6f, -1.6547247e-6f, 1.2768829e-5f,
        -2.3652583e-6f
    },
    {
        0.0f, -0.0665704f, 0.012349683f, 7.0016818e-6f, -1.2984591e-6f, 1.9463796e-5f,
        -3.6076342e-6f
    },
    { 0.0f, -0.060031634f, 0.011136757f, 5.3624303e-6f, -9.9448e-7f, 2.376466e-5f, -4.405877e-6f },
    { 0.0f, -0.0529628f, 0.009825509f, 3.9874844e-6f, -7.39505e-7f, 2.5912048e-5f, -4.8046218e-6f },
    {
        0.0f, -0.045260627f, 0.008396785f, 2.8583079e-6f, -5.3010035e-7f, 2.6164413e-5f,
        -4.85181e-6f
    },
    {
        0.0f, -0.03680446f, 0.0068282024f, 1.95537e-6f, -3.6264714e-7f, 2.4801619e-5f,
        -4.5993547e-6f
    },
    { 0.0f, -0.02745327f, 0.005093603f, 1.257927e-6f, -2.3330091e-7f, 2.212912e-5f, -4.103916e-6f },
    {
        0.0f, -0.017042203f, 0.0031624075f, 7.437676e-7f, -1.3794417e-7f, 1.8482855e-5f,
        -3.427809e-6f
    },
    {
        0.0f, -0.005378519f, 0.0009988648f, 3.8891423e-7f, -7.2131414e-8f, 1.4234959e-5f,
        -2.640062e-6f
    },
    {
        0.0f, 0.0077631488f, -0.0014388289f, 1.6727552e-7f, -3.102466e-8f, 9.800445e-6f,
        -1.8176567e-6f
    },
    {
        0.0f, 0.022646355f, -0.00419956f, 5.0239866e-8f, -9.3180805e-9f, 5.6450003e-6f,
        -1.0469756e-6f
    },
    {
        0.0f, 0.039579336f, -0.0073405034f, 6.200426e-9f, -1.1500094e-9f, 2.2941235e-6f,
        -4.2549496e-7f
    }
};

/* The bits of a number. */
typedef union {
    float value;
    uint32_t bits;
} motor_intermittent_f32_cell_t;

/* The bits of a number. */
static uint32_t motor_intermittent_f32_to_bits(float x)
{
    motor_intermittent_f32_cell_t cell;
    cell.value = x;
    return cell.bits;
}

/* The bit of the sign. */
#define MOTOR_INTERMITTENT_SIGN_F32 UINT32_C(0x80000000)

/* The bits of the largest magnitude. */
#define MOTOR_INTERMITTENT_MAGNITUDE_F32 UINT32_C(0x7FFFFFFF)

/* The bits of infinity. */
#define MOTOR_INTERMITTENT_INFINITY_F32 UINT32_C(0x7F800000)

/* The bits of the only NaN that is returned. */
#define MOTOR_INTERMITTENT_NAN_F32 UINT32_C(0x7FC00000)

/* The number with these bits. */
static float motor_intermittent_f32_from_bits(uint32_t bits)
{
    motor_intermittent_f32_cell_t cell;
    cell.bits = bits;
    return cell.value;
}

/* The number significand / 2^63 * 2^exponent, with the top bit of the significand set. */
typedef struct {
    uint64_t significand;
    int32_t exponent;
} motor_intermittent_scaled_t;

/* A number with a sign. */
typedef struct {
    motor_intermittent_scaled_t magnitude;
    int negative;
} motor_intermittent_signed_t;

/* The angle quadrant * pi/2 + rest. */
typedef struct {
    motor_intermittent_signed_t rest;
    uint32_t quadrant;
} motor_intermittent_turned_t;

/* Attaches a sign. */
static motor_intermittent_signed_t motor_intermittent_signed(motor_intermittent_scaled_t magnitude, int negative)
{
    motor_intermittent_signed_t result;
    result.magnitude = magnitude;
    result.negative = negative;
    return result;
}

/* A number below 1 as fixed point with 64 fraction bits. */
static uint64_t motor_intermittent_fraction(motor_intermittent_scaled_t a)
{
    const int32_t shift = -1 - a.exponent;
    if (shift > 63) {
        return 0;
    }
    return a.significand >> shift;
}

/* The upper half of the product, at most 2 too small. */
static uint64_t motor_intermittent_mul_high(uint64_t a, uint64_t b)
{
    const uint64_t a_high = a >> 32;
    const uint64_t a_low = a & 0xFFFFFFFFu;
    const uint64_t b_high = b >> 32;
    const uint64_t b_low = b & 0xFFFFFFFFu;
    const uint64_t cross = ((a_high * b_low) >> 32) + ((a_low * b_high) >> 32);
    return a_high * b_high + cross;
}

/* The square of a number below 1 as fixed point with 64 fraction bits. */
static uint64_t motor_intermittent_squared_fraction(motor_intermittent_scaled_t a)
{
    const uint64_t x = motor_intermittent_fraction(a);
    return motor_intermittent_mul_high(x, x);
}

/* Makes a number of a significand that has its top bit set. */
static motor_intermittent_scaled_t motor_intermittent_scaled(uint64_t significand, int32_t exponent)
{
    motor_intermittent_scaled_t result;
    result.significand = significand;
    result.exponent = exponent;
    return result;
}

/* Makes a number of a significand of at least 2^62. */
static motor_intermittent_scaled_t motor_intermittent_settled(uint64_t significand, int32_t exponent)
{
    if ((significand >> 63) == 0) {
        return motor_intermittent_scaled(significand << 1, exponent - 1);
    }
    return motor_intermittent_scaled(significand, exponent);
}

/* (1 - cos(r)) / r^2 in powers of -r^2. */
static const uint64_t MOTOR_INTERMITTENT_COSINE[8] = {
    UINT64_C(0x8000000000000000), UINT64_C(0x0AAAAAAAAAAAAAA8), UINT64_C(0x005B05B05B05B02B),
    UINT64_C(0x0001A01A01A01865), UINT64_C(0x0000049F93EDD666), UINT64_C(0x00000008F76C6243),
    UINT64_C(0x000000000C9C9706), UINT64_C(0x00000000000D551B)};

/* cos(r) for 0 < r <= pi/4, relative error below 2^-60. */
static motor_intermittent_scaled_t motor_intermittent_cosine(motor_intermittent_scaled_t r)
{
    const uint64_t z = motor_intermittent_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = MOTOR_INTERMITTENT_COSINE[6] - ((MOTOR_INTERMITTENT_COSINE[7] * z_high) >> 32);
    const uint64_t c5 = MOTOR_INTERMITTENT_COSINE[5] - ((tail * z_high) >> 32);
    const uint64_t c4 = MOTOR_INTERMITTENT_COSINE[4] - motor_intermittent_mul_high(c5, z);
    const uint64_t c3 = MOTOR_INTERMITTENT_COSINE[3] - motor_intermittent_mul_high(c4, z);
    const uint64_t c2 = MOTOR_INTERMITTENT_COSINE[2] - motor_intermittent_mul_high(c3, z);
    const uint64_t c1 = MOTOR_INTERMITTENT_COSINE[1] - motor_intermittent_mul_high(c2, z);
    const uint64_t c0 = MOTOR_INTERMITTENT_COSINE[0] - motor_intermittent_mul_high(c1, z);
    return motor_intermittent_settled((UINT64_C(1) << 63) - (motor_intermittent_mul_high(c0, z) >> 1), 0);
}

/* (1 - sin(r) / r) / r^2 in powers of -r^2. */
static const uint64_t MOTOR_INTERMITTENT_SINE[7] = {
    UINT64_C(0x2AAAAAAAAAAAAAA6), UINT64_C(0x0222222222222160), UINT64_C(0x000D00D00D00C575),
    UINT64_C(0x00002E3BC74A673D), UINT64_C(0x0000006B9914A637), UINT64_C(0x00000000B090498C),
    UINT64_C(0x0000000000D552BC)};

/* sin(r) for 0 < r <= pi/4, relative error below 2^-60. */
static motor_intermittent_scaled_t motor_intermittent_sine(motor_intermittent_scaled_t r)
{
    const uint64_t z = motor_intermittent_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = MOTOR_INTERMITTENT_SINE[5] - ((MOTOR_INTERMITTENT_SINE[6] * z_high) >> 32);
    const uint64_t c4 = MOTOR_INTERMITTENT_SINE[4] - ((tail * z_high) >> 32);
    const uint64_t c3 = MOTOR_INTERMITTENT_SINE[3] - motor_intermittent_mul_high(c4, z);
    const uint64_t c2 = MOTOR_INTERMITTENT_SINE[2] - motor_intermittent_mul_high(c3, z);
    const uint64_t c1 = MOTOR_INTERMITTENT_SINE[1] - motor_intermittent_mul_high(c2, z);
    const uint64_t c0 = MOTOR_INTERMITTENT_SINE[0] - motor_intermittent_mul_high(c1, z);
    const uint64_t lost = motor_intermittent_mul_high(r.significand, motor_intermittent_mul_high(c0, z));
    return motor_intermittent_settled(r.significand - lost, r.exponent);
}

/* The sine of an angle. */
static motor_intermittent_signed_t motor_intermittent_sine_at(motor_intermittent_turned_t angle)
{
    const int back = (angle.quadrant & 2) != 0;
    if ((angle.quadrant & 1) != 0) {
        return motor_intermittent_signed(motor_intermittent_cosine(angle.rest.magnitude), back);
    }
    return motor_intermittent_signed(motor_intermittent_sine(angle.rest.magnitude), back != angle.rest.negative);
}

/* Makes an angle of its parts. */
static motor_intermittent_turned_t motor_intermittent_turned(motor_intermittent_signed_t rest, uint32_t quadrant)
{
    motor_intermittent_turned_t result;
    result.rest = rest;
    result.quadrant = quadrant;
    return result;
}

/* The number of zero bits above the highest one bit; x is not 0. */
static int32_t motor_intermittent_leading_zeros(uint64_t x)
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
static motor_intermittent_scaled_t motor_intermittent_normalised(uint64_t significand, int32_t exponent)
{
    const int32_t shift = motor_intermittent_leading_zeros(significand);
    return motor_intermittent_scaled(significand << shift, exponent - shift);
}

/* The finite positive number with these bits, not 0; exact. */
static motor_intermittent_scaled_t motor_intermittent_unpacked_f32(uint32_t magnitude)
{
    const int32_t field = (int32_t)(magnitude >> 23);
    const uint64_t digits = (uint64_t)magnitude << 40;
    if (field == 0) {
        return motor_intermittent_normalised(digits, -126);
    }
    return motor_intermittent_scaled(digits | (UINT64_C(1) << 63), field - 127);
}

/* 2/pi after 32 zero bits. */
static const uint32_t MOTOR_INTERMITTENT_TWO_OVER_PI_F32[9] = {
    UINT32_C(0x00000000), UINT32_C(0xA2F9836E), UINT32_C(0x4E441529),
    UINT32_C(0xFC2757D1), UINT32_C(0xF534DDC0), UINT32_C(0xDB629599),
    UINT32_C(0x3C439041), UINT32_C(0xFE5163AB), UINT32_C(0xDEBBC561)};

/* 32 bits of 2/pi from bit 32 slot + shift on. */
static uint64_t motor_intermittent_window_f32(uint32_t slot, uint32_t shift)
{
    const uint64_t first = (uint64_t)(MOTOR_INTERMITTENT_TWO_OVER_PI_F32[slot]);
    const uint64_t second = (uint64_t)(MOTOR_INTERMITTENT_TWO_OVER_PI_F32[slot + 1]);
    return (((first << 32) | second) >> (32 - shift)) & 0xFFFFFFFFu;
}

/* a b, relative error below 2^-60. */
static motor_intermittent_scaled_t motor_intermittent_product(motor_intermittent_scaled_t a, motor_intermittent_scaled_t b)
{
    return motor_intermittent_settled(motor_intermittent_mul_high(a.significand, b.significand),
                            a.exponent + b.exponent + 1);
}

/* pi with 62 fraction bits; as a significand also pi/2 and pi/4. */
#define MOTOR_INTERMITTENT_PI UINT64_C(0xC90FDAA22168C235)

/* The angle of (high, low) / 2^126 quarter turns, its rest exact to 2^-60 of itself. */
static motor_intermittent_turned_t motor_intermittent_turned_from_quarters(uint64_t high, uint64_t low)
{
    const uint64_t eighths = high >> 61;
    const int negative = (eighths & 1) != 0;
    uint64_t upper = (high << 2) | (low >> 62);
    uint64_t lower = low << 2;
    if (negative) {
        upper = (lower == 0) ? (UINT64_C(0) - upper) : UINT64_MAX - upper;
        lower = (UINT64_C(0) - lower);
    }
    const int32_t shift = motor_intermittent_leading_zeros(upper | 1);
    const uint64_t significand = (upper << shift) | ((lower >> 1) >> (63 - shift));
    const motor_intermittent_signed_t rest = motor_intermittent_signed(
        motor_intermittent_product(motor_intermittent_scaled(significand, -1 - shift), motor_intermittent_scaled(MOTOR_INTERMITTENT_PI, 0)),
        negative);
    return motor_intermittent_turned(rest, (uint32_t)(((eighths + 1) >> 1) & 3));
}

/* The angle with these bits, positive and finite, its rest exact to 2^-38 of itself. */
static motor_intermittent_turned_t motor_intermittent_reduce_f32(uint32_t magnitude)
{
    if (magnitude <= 0x3F490FDAu) {
        return motor_intermittent_turned(motor_intermittent_signed(motor_intermittent_unpacked_f32(magnitude), 0), 0);
    }
    const uint64_t digits = (uint64_t)((magnitude & 0x007FFFFFu) | 0x00800000u);
    const uint32_t start = (magnitude >> 23) - 120;
    const uint32_t slot = start >> 5;
    const uint32_t shift = start & 31;
    const uint64_t upper = (motor_intermittent_window_f32(slot, shift) * digits) << 32;
    const uint64_t middle = motor_intermittent_window_f32(slot + 1, shift) * digits;
    const uint64_t lower = motor_intermittent_window_f32(slot + 2, shift) * digits;
    return motor_intermittent_turned_from_quarters(((upper + middle) + (lower >> 32)), lower << 32);
}

/* x rounded to the nearest, ties to even, with subnormals and overflow, and the sign put in. */
static float motor_intermittent_rounded_f32(uint32_t sign, motor_intermittent_scaled_t x)
{
    const int32_t field = x.exponent + 127;
    if (field >= 255) {
        return motor_intermittent_f32_from_bits(sign | MOTOR_INTERMITTENT_INFINITY_F32);
    }
    const int32_t shift = (field > 0) ? 40 : 41 - field;
    if (shift > 63) {
        const int least = shift == 64 && x.significand > (UINT64_C(1) << 63);
        return motor_intermittent_f32_from_bits(least ? sign + 1 : sign);
    }
    const uint64_t kept = x.significand >> shift;
    const uint64_t rest = x.significand - (kept << shift);
    const uint64_t half = UINT64_C(1) << (shift - 1);
    const uint64_t odd = kept & 1;
    const uint64_t up = (rest + odd > half) ? 1 : 0;
    const uint32_t base = (field > 0) ? ((uint32_t)(field - 1)) << 23 : 0;
    return motor_intermittent_f32_from_bits(sign | (base + ((uint32_t)(kept + up))));
}

/* The sign bit of a negative number, else 0. */
static uint32_t motor_intermittent_sign_f32(int negative)
{
    if (negative) {
        return MOTOR_INTERMITTENT_SIGN_F32;
    }
    return 0;
}

/* Sine of an angle in radians, the nearest float. */
static float motor_intermittent_sin_f32(float x)
{
    const uint32_t bits = motor_intermittent_f32_to_bits(x);
    const uint32_t magnitude = bits & MOTOR_INTERMITTENT_MAGNITUDE_F32;
    if (magnitude >= MOTOR_INTERMITTENT_INFINITY_F32) {
        return motor_intermittent_f32_from_bits(MOTOR_INTERMITTENT_NAN_F32);
    }
    if (magnitude == 0) {
        return x;
    }
    const motor_intermittent_signed_t value = motor_intermittent_sine_at(motor_intermittent_reduce_f32(magnitude));
    return motor_intermittent_rounded_f32((bits & MOTOR_INTERMITTENT_SIGN_F32) ^ motor_intermittent_sign_f32(value.negative),
                                value.magnitude);
}

/* What one part of a step hands to the next. */
typedef struct {
    uint32_t t11;
    float t21;
    float t32;
    uint32_t t47;
    float t119;
    float t120;
    float t121;
    motor_intermittent_status t128;
} motor_intermittent_work;

/* Part 1 of a step. */
static void motor_intermittent_part_1(motor_intermittent_state *state, const motor_intermittent_measurements *measurements, const motor_intermittent_inputs *inputs, motor_intermittent_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    const uint32_t t0 = state->newest;
    const uint32_t t1 = (t0 < 100U) ? t0 : 100U;
    const uint32_t t2 = state->count;
    const int t4 = 100U < t2;
    const float t5 = measurements->y;
    const int t6 = (-20.0f <= t5) && (t5 <= 20.0f);
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
    const int t17 = (-20.0f <= t15) && (t15 <= 20.0f);
    const int t18 = t4 && t17;
    const float t19 = t18 ? t15 : t16;
    const float t20 = t6 ? t5 : t19;
    work->t21 = motor_intermittent_sin_f32(t20);
    const float t22 = state->sin_q[t1];
    const float t23 = work->t21 - t22;
    const float t25 = -5.8317214e-6f * t23;
    const float t26 = t15 + t25;
    const int t27 = (-20.0f <= t26) && (t26 <= 20.0f);
    const int t28 = t4 && t27;
    const float t29 = t28 ? t26 : t16;
    const int t30 = t6 || t28;
    const int t31 = !t30;
    work->t32 = t6 ? t5 : t29;
    const int t34 = 0U < t2;
    const uint32_t t35 = state->since_y;
    const uint32_t t36 = (t35 < 8U) ? (t35 + 1U) : 8U;
    const uint32_t t37 = t6 ? 0U : t36;
    state->since_y = t37;
    const int t39 = t37 < 8U;
    const int t40 = t34 && t39;
    const int t41 = t6 || t40;

    /* how much of the window is good */
    const uint32_t t43 = (t2 < 429U) ? (t2 + 1U) : 429U;
    const uint32_t t44 = t31 ? 0U : t43;
    const uint32_t t45 = t8 ? t43 : 1U;
    const uint32_t t46 = t41 ? t45 : 0U;
    work->t47 = t4 ? t44 : t46;
    state->count = work->t47;
    const uint32_t t48 = state->coasting;
    const uint32_t t49 = (t48 > 0U) ? (t48 - 1U) : 0U;
    const uint32_t t50 = t8 ? t49 : 100U;
    const uint32_t t52 = t41 ? t50 : 429U;
    state->coasting = t52;

    /* into the window */
    state->newest = work->t11;
    state->y[work->t11] = work->t32;
    state->u[work->t11] = t10;
    state->sin_q[work->t11] = work->t21;
}

/* Part 2 of a step. */
static void motor_intermittent_part_2(motor_intermittent_state *state, motor_intermittent_work *work)
{
    /* the sums over the window, newest sample first */
    float t54 = 0.0f;
    float t55 = 0.0f;
    float t56 = 0.0f;
    float t57 = 0.0f;
    float t58 = 0.0f;
    float t59 = 0.0f;
    float t60 = 0.0f;
    uint32_t t61 = work->t11;
    for (uint32_t row = 0U; row < 100U; ++row) {
        const float *const gains = MOTOR_INTERMITTENT_WINDOW[row];
        const float t62 = state->y[t61];
        const float t63 = gains[0];
        const float t64 = t63 * t62;
        const float t65 = t54 + t64;
        const float t66 = gains[1];
        const float t67 = t66 * t62;
        const float t68 = t55 + t67;
        const float t69 = gains[2];
        const float t70 = t69 * t62;
        const float t71 = t58 + t70;
        const float t72 = state->u[t61];
        const float t73 = gains[3];
        const float t74 = t73 * t72;
        const float t75 = t56 + t74;
        const float t76 = gains[4];
        const float t77 = t76 * t72;
        const float t78 = t59 + t77;
        const float t79 = state->sin_q[t61];
        const float t80 = gains[5];
        const float t81 = t80 * t79;
        const float t82 = t57 + t81;
        const float t83 = gains[6];
        const float t84 = t83 * t79;
        const float t85 = t60 + t84;
        const uint32_t t86 = ((t61 >= 1U) && (t61 < 101U)) ? (t61 - 1U) : 100U;
        t54 = t65;
        t55 = t68;
        t56 = t75;
        t57 = t82;
        t58 = t71;
        t59 = t78;
        t60 = t85;
        t61 = t86;
    }
    const float t87 = state->y[t61];
    const float t88 = 0.0f * t87;
    const float t89 = t54 + t88;
    const float t91 = 0.05892262f * t87;
    const float t92 = t55 + t91;
    const float t94 = -0.010928534f * t87;
    const float t95 = t58 + t94;
    const float t96 = state->sin_q[t61];
    const float t98 = 3.4379153e-7f * t96;
    const float t99 = t57 + t98;
    const float t101 = -6.376392e-8f * t96;
    const float t102 = t60 + t101;
    const float t103 = t92 + t56;
    const float t104 = t103 + t99;
    const float t105 = t95 + t59;
    const float t106 = t105 + t102;

    /* the next measurement, as far as it is known */
    const float t108 = 0.0009994135f * t104;
    const float t110 = 7.021338e-6f * t106;
    const float t112 = -1.7493403e-5f * work->t21;
    const float t113 = t89 + t108;
    const float t114 = t113 + t110;
    const float t115 = t114 + t112;
    state->ahead_y = t115;

    /* the estimate; until the window is full, the start */
    const int t116 = 100U < work->t47;
    const int t118 = 428U < work->t47;
    work->t119 = t116 ? t89 : work->t32;
    work->t120 = t116 ? t104 : 0.0f;
    work->t121 = t116 ? t106 : 0.0f;
    const uint32_t t122 = state->coasting;
    const int t123 = t122 == 0U;
    const motor_intermittent_status t127 = t123 ? MOTOR_INTERMITTENT_CONVERGED : MOTOR_INTERMITTENT_COASTING;
    work->t128 = t118 ? t127 : MOTOR_INTERMITTENT_CONVERGING;
}

void motor_intermittent_init(motor_intermittent_state *state)
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
    state->since_y = 0U;
    state->coasting = 0U;
    state->ahead_y = 0.0f;
}

void motor_intermittent_step(motor_intermittent_state *state, const motor_intermittent_measurements *measurements,
                             const motor_intermittent_inputs *inputs, motor_intermittent_estimate *estimate)
{
    motor_intermittent_work work;
    motor_intermittent_part_1(state, measurements, inputs, &work);
    motor_intermittent_part_2(state, &work);

    estimate->q = work.t119;
    estimate->dq = work.t120;
    estimate->i = work.t121;
    estimate->status = work.t128;
}
