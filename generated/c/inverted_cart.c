/* inverted_cart.c: Finite-time observer: Pendulum upright on a cart, linear and unstable, with a known ground motion.
 *
 * Generated; inverted_cart.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "inverted_cart.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "inverted_cart.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "inverted_cart.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* weights by age, from age 0
 *   [0] x from x
 *   [1] angle from x
 *   [2] dx from x
 *   [3] dangle from x
 *   [4] x from angle
 *   [5] angle from angle
 *   [6] dx from angle
 *   [7] dangle from angle
 *   [8] x from force
 *   [9] angle from force
 *   [10] dx from force
 *   [11] dangle from force
 *   [12] x from sin(2*pi*1.5*t)
 *   [13] angle from sin(2*pi*1.5*t)
 *   [14] dx from sin(2*pi*1.5*t)
 *   [15] dangle from sin(2*pi*1.5*t)
 */
static const double INVERTED_CART_WINDOW[20][16] = {
    {
        0.1767395432265461, -0.0007660059788442085, 2.5664022962530613, -0.05738821011930295,
        -0.0007660059788442085, 0.18100285797748933, -0.0049698286698639255, 2.7644613758252077,
        1.8748757506494503e-5, 4.654072389735991e-5, 0.009029093647886134, 0.022564393686686234,
        9.609823499049665e-10, 1.0237863329924245e-6, 1.0377255010454328e-8, 0.0007465930097635614
    },
    {
        0.1639016753428798, -0.0007352502027909528, 2.3112335694098274, -0.052222462954538584,
        -0.0004939119905625967, 0.16724934243613343, -0.00018688824090537393, 2.4890381228322394,
        5.2530773178440556e-5, 0.00013011812245837184, 0.008853855264886955, 0.022109861072412088,
        6.466010297089249e-9, 5.934605935234997e-6, 9.563276686444082e-8, 0.0014768332108962066
    },
    {
        0.1510520993488436, -0.0006932853973465064, 2.05583277299295, -0.04688561880935766,
        -0.00025139230938365516, 0.15362629655870771, 0.004015734165358903, 2.215567250901053,
        7.917837975643128e-5, 0.00019552891408565392, 0.008580830700992753, 0.021408034072236688,
        1.6113614740294984e-8, 1.0845486074017212e-5, 2.7747985312966853e-7, 0.0014395043907320818
    },
    {
        0.13819082080990688, -0.000641012100234611, 1.8001999769099148, -0.04139580422820851,
        -3.8284469733659706e-5, 0.1401231243274556, 0.007640787569427391, 1.9438359315569116,
        9.926082132385575e-5, 0.00024437915038084214, 0.0082212300818297, 0.020489318562176045,
        2.8419463359519468e-8, 1.4612398726597497e-5, 5.262110234211536e-7, 0.0013866774365293103
    },
    {
        0.1253178433303528, -0.0005793236542784749, 1.5443352125199983, -0.03577104594626096,
        0.00014555107503586457, 0.12672932113929578, 0.010690570836567933, 1.6736326513935298,
        0.00011334961144012093, 0.0002782470640767089, 0.007786315382424902, 0.01938372997696393,
        4.205013638942026e-8, 1.733957322510808e-5, 8.112990175886407e-7, 0.0013203494098667173
    },
    {
        0.11243316856082382, -0.0005091069031140308, 1.2882384727528997, -0.030029284938784363,
        0.0003002310569898789, 0.11343446563203931, 0.013166934381537054, 1.4047470473889971,
        0.00012201860015860132, 0.000298685545910482, 0.007287401757040118, 0.018120941874621193,
        5.5823374889032636e-8, 1.9129607729031896e-5, 1.1056617051642422e-6, 0.0012424954143560386
    },
    {
        0.09953679620434876, -0.00043124288197101475, 1.0319097121974985, -0.02418839040639595,
        0.000425849480180839, 0.10022821157392568, 0.015071281523924854, 1.1369697430866814,
        0.00012584404547284235, 0.00030722459134568665, 0.006735858961671434, 0.0167303340856623,
        6.871279493795661e-8, 2.0083627505105952e-5, 1.385756076426874e-6, 0.0011550717125107983
    },
    {
        0.0866287240208563, -0.00034660750405958164, 0.7753488471608028, -0.01826617370707278,
        0.0005224776895130205, 0.08710027981016524, 0.016404569495114305, 0.870092185513535,
        0.0001254046892349399, 0.00030537371998781113, 0.006143112870130861, 0.015241040503362198,
        7.985289395649066e-8, 2.030144147553563e-5, 1.6316783492745362e-6, 0.0010600188201699869
    },
    {
        0.07370894783017738, -0.00025607224309685345, 0.5185557556971307, -0.012280402245781342,
        0.0005901644219504109, 0.07404045026021927, 0.017167310097572247, 0.6039064827087706,
        0.00012128183759552655, 0.0002946243705104315, 0.005520647084738627, 0.013681996571125489,
        8.854435251204665e-8, 1.9881697217648014e-5, 1.8272702618691092e-6, 0.0009592645821241879
    },
    {
        0.060777461513539265, -0.00016050481250488963, 0.2615302776075398, -0.006248813332547767,
        0.0006289358401046593, 0.061038553959586725, 0.017359570016918475, 0.3382052417363325,
        0.00011405944602033639, 0.00027645227388268964, 0.0048800046427683215, 0.012081986522677004,
        9.425963533720254e-8, 1.892203459649776e-5, 1.960231628452741e-6, 0.0008547272325720689
    },
    {
        0.047834257013551554, -6.076984180907697e-5, 0.004272214409498386, -0.0001891280197691718,
        0.0006387955482258409, 0.04808446513990064, 0.016980970786948532, 0.0727814070549363,
        0.00010432420894389584, 0.0002523198076661725, 0.004232789819901251, 0.01046969043052807,
        9.664889565035499e-8, 1.751923821051307e-5, 2.022239243225352e-6, 0.0007483184440191891
    },
    {
        0.03487932433268427, 4.227044923614395e-5, -0.253218670723229, 0.005880935070447353,
        0.0006197245906050759, 0.035168093341165337, 0.016030688407515356, -0.1925719008802947,
        9.266565412650976e-5, 0.00022367833412926676, 0.0035906700320615472, 0.008873731117965718,
        9.554618723851134e-8, 1.576938882903101e-5, 2.0090722247271282e-6, 0.0006419463682189026
    },
    {
        0.02191265153023632, 0.00014775557826896774, -0.5109426530505367, 0.011943645918137407,
        0.00057168143238433, 0.022279375549990113, 0.01450745261490405, -0.45806154691040957,
        7.967624178637943e-5, 0.00019197052490994764, 0.0029653778371197285, 0.007322720989662514,
        9.097598913370084e-8, 1.3768013999519244e-5, 1.92074390079604e-6, 0.0005375186727467118
    },
    {
        0.008934224717791732, 0.0002548261291653412, -0.7689000463858481, 0.017981249265740063,
        0.0004946019227549994, 0.009408268357693452, 0.012409545804063128, -0.7238945424851851,
        6.595146858441323e-5, 0.0001586326749436774, 0.002368713038069783, 0.005845308835912671,
        8.316004809017997e-8, 1.1610238001414227e-5, 1.7616403418763936e-6, 0.00043694557679475475
    },
    {
        -0.00405597194684013, 0.0003626230815843726, -1.0270912032460007, 0.023975950755972128,
        0.0003883992405131525, -0.003455259867833352, 0.0097348016017839, -0.9902782071214529,
        5.208997654507573e-5, 0.0001250970083616336, 0.0018125448894034846, 0.004470226665465229,
        7.252454444945294e-8, 9.390931322823358e-6, 1.5406656582482453e-6, 0.00034214288977219373
    },
    {
        -0.01705795626720548, 0.00047028714069134194, -1.2855165150312686, 0.02990990303650169,
        0.0002529638219255308, -0.016321236802605034, 0.006480603089647289, -1.2574203301331324,
        3.869366700247117e-5, 9.27939790558406e-5, 0.001308814408525712, 0.0032263366219476095,
        5.970758736452523e-8, 7.204859835839675e-6, 1.2713941846372556e-6, 0.00025503505630009076
    },
    {
        -0.030071748017314274, 0.0005769580665356571, -1.5441764122356683, 0.035765191820578704,
        8.816327084660952e-5, -0.029199693985460635, 0.00264388067528406, -1.5255293327591453,
        2.63678196667829e-5, 6.31545686019367e-5, 0.0008695367941761298, 0.002142678038952618,
        4.556704574415807e-8, 5.146833845901906e-6, 9.722296836584946e-7, 0.00017755821119593327
    },
    {
        -0.04309736895228306, 0.0006817740025607303, -1.803071364687719, 0.04152382189274405,
        -0.00010615774898683251, -0.0421006746415182, -0.0017788903897801092, -1.7948144308157132,
        1.5721216912193103e-5, 3.7612584227264546e-5, 0.0005068039539458555, 0.0012485146889990432,
        3.118872167260103e-8, 3.311857190499938e-6, 6.665717076540339e-7, 0.00011166324805330072
    },
    {
        -0.05613484282052111, 0.0007838708027219696, -2.0622018818218484, 0.04716770304869329,
        -0.0003301776395710979, -0.055034241516267575, -0.006791692847699225, -2.065485797999982,
        7.366273393496493e-6, 1.7606959511721423e-5, 0.00023278714310277172, 0.0005733822817706911,
        1.7894873460761867e-8, 1.7952765625756443e-6, 3.829892667113048e-7, 5.9318905036256926e-5
    },
    {
        -0.0691841953774696, 0.0008823813566878941, -2.3215685129806656, 0.05267863595831826,
        -0.0005840980122623589, -0.06801048472641255, -0.01239897062958329, -2.3377547299724455,
        1.919171104802601e-6, 4.584060511351411e-6, 5.973971706611773e-5, 0.00014713626729091954,
        7.253095891441576e-9, 6.929312342018027e-7, 1.554019590056177e-7, 2.2514871525926847e-5
    }
};

/* The number significand / 2^63 * 2^exponent, with the top bit of the significand set. */
typedef struct {
    uint64_t significand;
    int32_t exponent;
} inverted_cart_scaled_t;

/* A number with a sign. */
typedef struct {
    inverted_cart_scaled_t magnitude;
    int negative;
} inverted_cart_signed_t;

/* The angle quadrant * pi/2 + rest. */
typedef struct {
    inverted_cart_signed_t rest;
    uint32_t quadrant;
} inverted_cart_turned_t;

/* Attaches a sign. */
static inverted_cart_signed_t inverted_cart_signed(inverted_cart_scaled_t magnitude, int negative)
{
    inverted_cart_signed_t result;
    result.magnitude = magnitude;
    result.negative = negative;
    return result;
}

/* A number below 1 as fixed point with 64 fraction bits. */
static uint64_t inverted_cart_fraction(inverted_cart_scaled_t a)
{
    const int32_t shift = -1 - a.exponent;
    if (shift > 63) {
        return 0;
    }
    return a.significand >> shift;
}

/* The upper half of the product, at most 2 too small. */
static uint64_t inverted_cart_mul_high(uint64_t a, uint64_t b)
{
    const uint64_t a_high = a >> 32;
    const uint64_t a_low = a & 0xFFFFFFFFu;
    const uint64_t b_high = b >> 32;
    const uint64_t b_low = b & 0xFFFFFFFFu;
    const uint64_t cross = ((a_high * b_low) >> 32) + ((a_low * b_high) >> 32);
    return a_high * b_high + cross;
}

/* The square of a number below 1 as fixed point with 64 fraction bits. */
static uint64_t inverted_cart_squared_fraction(inverted_cart_scaled_t a)
{
    const uint64_t x = inverted_cart_fraction(a);
    return inverted_cart_mul_high(x, x);
}

/* Makes a number of a significand that has its top bit set. */
static inverted_cart_scaled_t inverted_cart_scaled(uint64_t significand, int32_t exponent)
{
    inverted_cart_scaled_t result;
    result.significand = significand;
    result.exponent = exponent;
    return result;
}

/* Makes a number of a significand of at least 2^62. */
static inverted_cart_scaled_t inverted_cart_settled(uint64_t significand, int32_t exponent)
{
    if ((significand >> 63) == 0) {
        return inverted_cart_scaled(significand << 1, exponent - 1);
    }
    return inverted_cart_scaled(significand, exponent);
}

/* (1 - cos(r)) / r^2 in powers of -r^2. */
static const uint64_t INVERTED_CART_COSINE[8] = {
    UINT64_C(0x8000000000000000), UINT64_C(0x0AAAAAAAAAAAAAA8), UINT64_C(0x005B05B05B05B02B),
    UINT64_C(0x0001A01A01A01865), UINT64_C(0x0000049F93EDD666), UINT64_C(0x00000008F76C6243),
    UINT64_C(0x000000000C9C9706), UINT64_C(0x00000000000D551B)};

/* cos(r) for 0 < r <= pi/4, relative error below 2^-60. */
static inverted_cart_scaled_t inverted_cart_cosine(inverted_cart_scaled_t r)
{
    const uint64_t z = inverted_cart_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = INVERTED_CART_COSINE[6] - ((INVERTED_CART_COSINE[7] * z_high) >> 32);
    const uint64_t c5 = INVERTED_CART_COSINE[5] - ((tail * z_high) >> 32);
    const uint64_t c4 = INVERTED_CART_COSINE[4] - inverted_cart_mul_high(c5, z);
    const uint64_t c3 = INVERTED_CART_COSINE[3] - inverted_cart_mul_high(c4, z);
    const uint64_t c2 = INVERTED_CART_COSINE[2] - inverted_cart_mul_high(c3, z);
    const uint64_t c1 = INVERTED_CART_COSINE[1] - inverted_cart_mul_high(c2, z);
    const uint64_t c0 = INVERTED_CART_COSINE[0] - inverted_cart_mul_high(c1, z);
    return inverted_cart_settled((UINT64_C(1) << 63) - (inverted_cart_mul_high(c0, z) >> 1), 0);
}

/* (1 - sin(r) / r) / r^2 in powers of -r^2. */
static const uint64_t INVERTED_CART_SINE[7] = {
    UINT64_C(0x2AAAAAAAAAAAAAA6), UINT64_C(0x0222222222222160), UINT64_C(0x000D00D00D00C575),
    UINT64_C(0x00002E3BC74A673D), UINT64_C(0x0000006B9914A637), UINT64_C(0x00000000B090498C),
    UINT64_C(0x0000000000D552BC)};

/* sin(r) for 0 < r <= pi/4, relative error below 2^-60. */
static inverted_cart_scaled_t inverted_cart_sine(inverted_cart_scaled_t r)
{
    const uint64_t z = inverted_cart_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = INVERTED_CART_SINE[5] - ((INVERTED_CART_SINE[6] * z_high) >> 32);
    const uint64_t c4 = INVERTED_CART_SINE[4] - ((tail * z_high) >> 32);
    const uint64_t c3 = INVERTED_CART_SINE[3] - inverted_cart_mul_high(c4, z);
    const uint64_t c2 = INVERTED_CART_SINE[2] - inverted_cart_mul_high(c3, z);
    const uint64_t c1 = INVERTED_CART_SINE[1] - inverted_cart_mul_high(c2, z);
    const uint64_t c0 = INVERTED_CART_SINE[0] - inverted_cart_mul_high(c1, z);
    const uint64_t lost = inverted_cart_mul_high(r.significand, inverted_cart_mul_high(c0, z));
    return inverted_cart_settled(r.significand - lost, r.exponent);
}

/* The sine of an angle. */
static inverted_cart_signed_t inverted_cart_sine_at(inverted_cart_turned_t angle)
{
    const int back = (angle.quadrant & 2) != 0;
    if ((angle.quadrant & 1) != 0) {
        return inverted_cart_signed(inverted_cart_cosine(angle.rest.magnitude), back);
    }
    return inverted_cart_signed(inverted_cart_sine(angle.rest.magnitude), back != angle.rest.negative);
}

/* Makes an angle of its parts. */
static inverted_cart_turned_t inverted_cart_turned(inverted_cart_signed_t rest, uint32_t quadrant)
{
    inverted_cart_turned_t result;
    result.rest = rest;
    result.quadrant = quadrant;
    return result;
}

/* The number of zero bits above the highest one bit; x is not 0. */
static int32_t inverted_cart_leading_zeros(uint64_t x)
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
static inverted_cart_scaled_t inverted_cart_normalised(uint64_t significand, int32_t exponent)
{
    const int32_t shift = inverted_cart_leading_zeros(significand);
    return inverted_cart_scaled(significand << shift, exponent - shift);
}

/* a b, relative error below 2^-60. */
static inverted_cart_scaled_t inverted_cart_product(inverted_cart_scaled_t a, inverted_cart_scaled_t b)
{
    return inverted_cart_settled(inverted_cart_mul_high(a.significand, b.significand),
                            a.exponent + b.exponent + 1);
}

/* pi with 62 fraction bits; as a significand also pi/2 and pi/4. */
#define INVERTED_CART_PI UINT64_C(0xC90FDAA22168C235)

/* The angle of (high, low) / 2^126 quarter turns, its rest exact to 2^-60 of itself. */
static inverted_cart_turned_t inverted_cart_turned_from_quarters(uint64_t high, uint64_t low)
{
    const uint64_t eighths = high >> 61;
    const int negative = (eighths & 1) != 0;
    uint64_t upper = (high << 2) | (low >> 62);
    uint64_t lower = low << 2;
    if (negative) {
        upper = (lower == 0) ? (UINT64_C(0) - upper) : UINT64_MAX - upper;
        lower = (UINT64_C(0) - lower);
    }
    const int32_t shift = inverted_cart_leading_zeros(upper | 1);
    const uint64_t significand = (upper << shift) | ((lower >> 1) >> (63 - shift));
    const inverted_cart_signed_t rest = inverted_cart_signed(
        inverted_cart_product(inverted_cart_scaled(significand, -1 - shift), inverted_cart_scaled(INVERTED_CART_PI, 0)),
        negative);
    return inverted_cart_turned(rest, (uint32_t)(((eighths + 1) >> 1) & 3));
}

/* The bits of a number. */
typedef union {
    double value;
    uint64_t bits;
} inverted_cart_f64_cell_t;

/* The bits of a number. */
static uint64_t inverted_cart_f64_to_bits(double x)
{
    inverted_cart_f64_cell_t cell;
    cell.value = x;
    return cell.bits;
}

/* Bits of the sign, of the largest magnitude, of infinity, of the only NaN returned, of 1. */
#define INVERTED_CART_SIGN_F64 UINT64_C(0x8000000000000000)
#define INVERTED_CART_MAGNITUDE_F64 UINT64_C(0x7FFFFFFFFFFFFFFF)
#define INVERTED_CART_INFINITY_F64 UINT64_C(0x7FF0000000000000)
#define INVERTED_CART_NAN_F64 UINT64_C(0x7FF8000000000000)
#define INVERTED_CART_ONE_F64 UINT64_C(0x3FF0000000000000)

/* The number with these bits. */
static double inverted_cart_f64_from_bits(uint64_t bits)
{
    inverted_cart_f64_cell_t cell;
    cell.bits = bits;
    return cell.value;
}

/* The finite positive number with these bits, not 0; exact. */
static inverted_cart_scaled_t inverted_cart_unpacked_f64(uint64_t magnitude)
{
    const int32_t field = (int32_t)(magnitude >> 52);
    const uint64_t digits = magnitude << 11;
    if (field == 0) {
        return inverted_cart_normalised(digits, -1022);
    }
    return inverted_cart_scaled(digits | (UINT64_C(1) << 63), field - 1023);
}

/* 2/pi after 64 zero bits. */
static const uint32_t INVERTED_CART_TWO_OVER_PI_F64[40] = {
    UINT32_C(0x00000000), UINT32_C(0x00000000), UINT32_C(0xA2F9836E), UINT32_C(0x4E441529),
    UINT32_C(0xFC2757D1), UINT32_C(0xF534DDC0), UINT32_C(0xDB629599), UINT32_C(0x3C439041),
    UINT32_C(0xFE5163AB), UINT32_C(0xDEBBC561), UINT32_C(0xB7246E3A), UINT32_C(0x424DD2E0),
    UINT32_C(0x06492EEA), UINT32_C(0x09D1921C), UINT32_C(0xFE1DEB1C), UINT32_C(0xB129A73E),
    UINT32_C(0xE88235F5), UINT32_C(0x2EBB4484), UINT32_C(0xE99C7026), UINT32_C(0xB45F7E41),
    UINT32_C(0x3991D639), UINT32_C(0x835339F4), UINT32_C(0x9C845F8B), UINT32_C(0xBDF9283B),
    UINT32_C(0x1FF897FF), UINT32_C(0xDE05980F), UINT32_C(0xEF2F118B), UINT32_C(0x5A0A6D1F),
    UINT32_C(0x6D367ECF), UINT32_C(0x27CB09B7), UINT32_C(0x4F463F66), UINT32_C(0x9E5FEA2D),
    UINT32_C(0x7527BAC7), UINT32_C(0xEBE5F17B), UINT32_C(0x3D0739F7), UINT32_C(0x8A5292EA),
    UINT32_C(0x6BFB5FB1), UINT32_C(0x1F8D5D08), UINT32_C(0x56033046), UINT32_C(0xFC7B6BAB)};

/* 32 bits of 2/pi from bit 32 slot + shift on. */
static uint64_t inverted_cart_window_f64(uint32_t slot, uint32_t shift)
{
    const uint64_t first = (uint64_t)(INVERTED_CART_TWO_OVER_PI_F64[slot]);
    const uint64_t second = (uint64_t)(INVERTED_CART_TWO_OVER_PI_F64[slot + 1]);
    return (((first << 32) | second) >> (32 - shift)) & 0xFFFFFFFFu;
}

/* A 128-bit unsigned integer. */
typedef struct {
    uint64_t high;
    uint64_t low;
} inverted_cart_pair_t;

/* Makes a 128-bit integer of its halves. */
static inverted_cart_pair_t inverted_cart_pair(uint64_t high, uint64_t low)
{
    inverted_cart_pair_t result;
    result.high = high;
    result.low = low;
    return result;
}

/* The exact 128-bit product. */
static inverted_cart_pair_t inverted_cart_mul_full(uint64_t a, uint64_t b)
{
    const uint64_t a_high = a >> 32;
    const uint64_t a_low = a & 0xFFFFFFFFu;
    const uint64_t b_high = b >> 32;
    const uint64_t b_low = b & 0xFFFFFFFFu;
    const uint64_t lowest = a_low * b_low;
    const uint64_t first = a_high * b_low + (lowest >> 32);
    const uint64_t second = a_low * b_high + (first & 0xFFFFFFFFu);
    const uint64_t high = a_high * b_high + (first >> 32) + (second >> 32);
    return inverted_cart_pair(high, (second << 32) | (lowest & 0xFFFFFFFFu));
}

/* The angle with these bits, positive and finite, its rest exact to 2^-60 of itself. */
static inverted_cart_turned_t inverted_cart_reduce_f64(uint64_t magnitude)
{
    if (magnitude <= UINT64_C(0x3FE921FB54442D18)) {
        return inverted_cart_turned(inverted_cart_signed(inverted_cart_unpacked_f64(magnitude), 0), 0);
    }
    const uint64_t digits = (magnitude & UINT64_C(0x000FFFFFFFFFFFFF)) | (UINT64_C(1) << 52);
    const uint32_t start = ((uint32_t)(magnitude >> 52)) - 1013;
    const uint32_t slot = start >> 5;
    const uint32_t shift = start & 31;
    const uint64_t upper =
        (inverted_cart_window_f64(slot, shift) << 32) | inverted_cart_window_f64(slot + 1, shift);
    const uint64_t middle =
        (inverted_cart_window_f64(slot + 2, shift) << 32) | inverted_cart_window_f64(slot + 3, shift);
    const uint64_t lower =
        (inverted_cart_window_f64(slot + 4, shift) << 32) | inverted_cart_window_f64(slot + 5, shift);
    const inverted_cart_pair_t center = inverted_cart_mul_full(middle, digits);
    const uint64_t low = (center.low + (inverted_cart_mul_high(lower, digits)));
    const uint64_t carry = (low < center.low) ? 1 : 0;
    const uint64_t high = ((upper * digits) + (center.high + carry));
    return inverted_cart_turned_from_quarters(high, low);
}

/* x rounded to the nearest, ties to even, with subnormals and overflow, and the sign put in. */
static double inverted_cart_rounded_f64(uint64_t sign, inverted_cart_scaled_t x)
{
    const int32_t field = x.exponent + 1023;
    if (field >= 2047) {
        return inverted_cart_f64_from_bits(sign | INVERTED_CART_INFINITY_F64);
    }
    const int32_t shift = (field > 0) ? 11 : 12 - field;
    if (shift > 63) {
        const int least = shift == 64 && x.significand > (UINT64_C(1) << 63);
        return inverted_cart_f64_from_bits(least ? sign + 1 : sign);
    }
    const uint64_t kept = x.significand >> shift;
    const uint64_t rest = x.significand - (kept << shift);
    const uint64_t half = UINT64_C(1) << (shift - 1);
    const uint64_t odd = kept & 1;
    const uint64_t up = (rest + odd > half) ? 1 : 0;
    const uint64_t base = (field > 0) ? ((uint64_t)(field - 1)) << 52 : 0;
    return inverted_cart_f64_from_bits(sign | (base + (kept + up)));
}

/* The sign bit of a negative number, else 0. */
static uint64_t inverted_cart_sign_f64(int negative)
{
    if (negative) {
        return INVERTED_CART_SIGN_F64;
    }
    return 0;
}

/* Sine of an angle in radians, error below 0.51 ulp. */
static double inverted_cart_sin_f64(double x)
{
    const uint64_t bits = inverted_cart_f64_to_bits(x);
    const uint64_t magnitude = bits & INVERTED_CART_MAGNITUDE_F64;
    if (magnitude >= INVERTED_CART_INFINITY_F64) {
        return inverted_cart_f64_from_bits(INVERTED_CART_NAN_F64);
    }
    if (magnitude == 0) {
        return x;
    }
    const inverted_cart_signed_t value = inverted_cart_sine_at(inverted_cart_reduce_f64(magnitude));
    return inverted_cart_rounded_f64((bits & INVERTED_CART_SIGN_F64) ^ inverted_cart_sign_f64(value.negative),
                                value.magnitude);
}

/* What one part of a step hands to the next. */
typedef struct {
    double t12;
    uint32_t t13;
    uint32_t t25;
    double t30;
    double t41;
    double t50;
    uint32_t t76;
    double t84;
    double t85;
    double t86;
    double t87;
    double t88;
    double t89;
    double t90;
    double t91;
    double t92;
    double t93;
    double t94;
    double t95;
    double t96;
    double t97;
    double t98;
    double t99;
    uint32_t t100;
    double t154;
    double t229;
    double t230;
    double t231;
    double t232;
    inverted_cart_status t239;
} inverted_cart_work;

/* Part 1 of a step. */
static void inverted_cart_part_1(inverted_cart_state *state, const inverted_cart_measurements *measurements, const inverted_cart_inputs *inputs, inverted_cart_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    const uint32_t t0 = state->newest;
    const uint32_t t1 = (t0 < 20U) ? t0 : 20U;
    const uint32_t t2 = state->count;
    const int t4 = 20U < t2;
    const double t5 = measurements->x;
    const int t6 = (-1e305 <= t5) && (t5 <= 1e305);
    const double t7 = measurements->angle;
    const int t8 = (-1e305 <= t7) && (t7 <= 1e305);
    const double t9 = inputs->force;
    const int t10 = (-1e305 <= t9) && (t9 <= 1e305);
    const double t11 = state->force[t1];
    work->t12 = t10 ? t9 : t11;

    /* prediction, for a sample that is missing */
    work->t13 = (t1 < 20U) ? (t1 + 1U) : 0U;
    const double t14 = state->ahead_x;
    const double t16 = 2.2720931399270927e-5 * work->t12;
    const double t17 = t14 + t16;
    const double t18 = state->ahead_angle;
    const double t20 = 5.6805228175978704e-5 * work->t12;
    const double t21 = t18 + t20;
    const double t22 = state->x[t1];
    const double t23 = state->angle[t1];
    work->t25 = state->calls;
    const double t26 = (double)work->t25;
    const double t28 = t26 * 0.005;
    const double t29 = 9.42477796076938 * t28;
    work->t30 = inverted_cart_sin_f64(t29);
    const double t31 = state->sin_2_pi_1_5_t[t1];
    const double t32 = work->t30 - t31;
    const double t34 = 4.175538654877078e-12 * t32;
    const double t35 = t17 + t34;
    const int t36 = (-1e305 <= t35) && (t35 <= 1e305);
    const int t37 = t4 && t36;
    const double t38 = t37 ? t35 : t22;
    const int t39 = t6 || t37;
    const int t40 = !t39;
    work->t41 = t6 ? t5 : t38;
    const double t43 = 1.250048720885277e-6 * t32;
    const double t44 = t21 + t43;
    const int t45 = (-1e305 <= t44) && (t44 <= 1e305);
    const int t46 = t4 && t45;
    const double t47 = t46 ? t44 : t23;
    const int t48 = t8 || t46;
    const int t49 = !t48;
    work->t50 = t8 ? t7 : t47;
    const uint32_t t51 = state->missed_x;
    const int t52 = 20U < t51;
    const int t53 = !t6;
    const int t54 = t53 && t52;
    const uint32_t t56 = (t51 < 21U) ? (t51 + 1U) : 21U;
    const uint32_t t57 = t6 ? 0U : t56;
    state->missed_x = t57;
    const uint32_t t58 = state->missed_angle;
    const int t59 = 20U < t58;
    const int t60 = !t8;
    const int t61 = t60 && t59;
    const uint32_t t62 = (t58 < 21U) ? (t58 + 1U) : 21U;
    const uint32_t t63 = t8 ? 0U : t62;
    state->missed_angle = t63;
    const int t64 = t54 || t61;
    const int t65 = t54 && t61;
    const int t66 = !t65;
    const int t67 = t64 && t66;
    const int t68 = t6 && t8;
    const int t69 = t40 || t49;
    const int t70 = t69 || t67;

    /* how much of the window is good */
    const uint32_t t72 = (t2 < 21U) ? (t2 + 1U) : 21U;
    const uint32_t t73 = t70 ? 0U : t72;
    const uint32_t t74 = t10 ? t72 : 1U;
    const uint32_t t75 = t68 ? t74 : 0U;
    work->t76 = t4 ? t73 : t75;
    state->count = work->t76;
    const uint32_t t77 = state->coasting;
    const uint32_t t78 = (t77 > 0U) ? (t77 - 1U) : 0U;
    const uint32_t t79 = t10 ? t78 : 20U;
    const uint32_t t81 = t68 ? t79 : 21U;
    state->coasting = t81;
}

/* Part 2 of a step. */
static void inverted_cart_part_2(inverted_cart_state *state, const inverted_cart_work *work)
{
    /* into the window */
    state->newest = work->t13;
    state->x[work->t13] = work->t41;
    state->angle[work->t13] = work->t50;
    state->force[work->t13] = work->t12;
    state->sin_2_pi_1_5_t[work->t13] = work->t30;
    const uint32_t t82 = (work->t25 < 4294967295U) ? (work->t25 + 1U) : 4294967295U;
    state->calls = t82;
}

/* Part 3 of a step. */
static void inverted_cart_part_3(const inverted_cart_state *state, inverted_cart_work *work)
{
    /* the sums over the window, newest sample first */
    work->t84 = 0.0;
    work->t85 = 0.0;
    work->t86 = 0.0;
    work->t87 = 0.0;
    work->t88 = 0.0;
    work->t89 = 0.0;
    work->t90 = 0.0;
    work->t91 = 0.0;
    work->t92 = 0.0;
    work->t93 = 0.0;
    work->t94 = 0.0;
    work->t95 = 0.0;
    work->t96 = 0.0;
    work->t97 = 0.0;
    work->t98 = 0.0;
    work->t99 = 0.0;
    work->t100 = work->t13;
    for (uint32_t row = 0U; row < 20U; ++row) {
        const double *const gains = INVERTED_CART_WINDOW[row];
        const double t101 = state->x[work->t100];
        const double t102 = gains[0];
        const double t103 = t102 * t101;
        const double t104 = work->t84 + t103;
        const double t105 = gains[1];
        const double t106 = t105 * t101;
        const double t107 = work->t88 + t106;
        const double t108 = gains[2];
        const double t109 = t108 * t101;
        const double t110 = work->t92 + t109;
        const double t111 = gains[3];
        const double t112 = t111 * t101;
        const double t113 = work->t96 + t112;
        const double t114 = state->angle[work->t100];
        const double t115 = gains[4];
        const double t116 = t115 * t114;
        const double t117 = work->t85 + t116;
        const double t118 = gains[5];
        const double t119 = t118 * t114;
        const double t120 = work->t89 + t119;
        const double t121 = gains[6];
        const double t122 = t121 * t114;
        const double t123 = work->t93 + t122;
        const double t124 = gains[7];
        const double t125 = t124 * t114;
        const double t126 = work->t97 + t125;
        const double t127 = state->force[work->t100];
        const double t128 = gains[8];
        const double t129 = t128 * t127;
        const double t130 = work->t86 + t129;
        const double t131 = gains[9];
        const double t132 = t131 * t127;
        const double t133 = work->t90 + t132;
        const double t134 = gains[10];
        const double t135 = t134 * t127;
        const double t136 = work->t94 + t135;
        const double t137 = gains[11];
        const double t138 = t137 * t127;
        const double t139 = work->t98 + t138;
        const double t140 = state->sin_2_pi_1_5_t[work->t100];
        const double t141 = gains[12];
        const double t142 = t141 * t140;
        const double t143 = work->t87 + t142;
        const double t144 = gains[13];
        const double t145 = t144 * t140;
        const double t146 = work->t91 + t145;
        const double t147 = gains[14];
        const double t148 = t147 * t140;
        const double t149 = work->t95 + t148;
        const double t150 = gains[15];
        const double t151 = t150 * t140;
        const double t152 = work->t99 + t151;
        const uint32_t t153 = ((work->t100 >= 1U) && (work->t100 < 21U)) ? (work->t100 - 1U) : 20U;
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
    work->t154 = state->x[work->t100];
}

/* Part 4 of a step. */
static void inverted_cart_part_4(inverted_cart_state *state, inverted_cart_work *work)
{
    const double t156 = -0.08224545440090494 * work->t154;
    const double t157 = work->t84 + t156;
    const double t159 = 0.0009764349125977824 * work->t154;
    const double t160 = work->t88 + t159;
    const double t162 = -2.581171847748337 * work->t154;
    const double t163 = work->t92 + t162;
    const double t165 = 0.0580382979408871 * work->t154;
    const double t166 = work->t96 + t165;
    const double t167 = state->angle[work->t100];
    const double t169 = -0.00086814384953036 * t167;
    const double t170 = work->t85 + t169;
    const double t172 = -0.08103952963358767 * t167;
    const double t173 = work->t89 + t172;
    const double t175 = -0.018605632411037774 * t167;
    const double t176 = work->t93 + t175;
    const double t178 = -2.611833809346272 * t167;
    const double t179 = work->t97 + t178;
    const double t180 = state->sin_2_pi_1_5_t[work->t100];
    const double t182 = 1.085565634541814e-9 * t180;
    const double t183 = work->t87 + t182;
    const double t185 = 1.0130335653760034e-7 * t180;
    const double t186 = work->t91 + t185;
    const double t188 = 2.3268728104520693e-8 * t180;
    const double t189 = work->t95 + t188;
    const double t191 = 3.264919278386112e-6 * t180;
    const double t192 = work->t99 + t191;
    const double t193 = t157 + t170;
    const double t194 = t193 + work->t86;
    const double t195 = t194 + t183;
    const double t196 = t160 + t173;
    const double t197 = t196 + work->t90;
    const double t198 = t197 + t186;
    const double t199 = t163 + t176;
    const double t200 = t199 + work->t94;
    const double t201 = t200 + t189;
    const double t202 = t166 + t179;
    const double t203 = t202 + work->t98;
    const double t204 = t203 + t192;

    /* the next measurement, as far as it is known */
    const double t206 = 3.3400799328113145e-5 * t198;
    const double t208 = 0.004997728156787819 * t201;
    const double t210 = 5.5670768679088146e-8 * t204;
    const double t212 = 2.0877215753319605e-11 * work->t30;
    const double t213 = t195 + t206;
    const double t214 = t208 + t210;
    const double t215 = t214 + t212;
    const double t216 = t213 + t215;
    state->ahead_x = t216;
    const double t218 = 1.0003897725177409 * t198;
    const double t220 = -5.6798979663364475e-6 * t201;
    const double t222 = 0.005000649614524433 * t204;
    const double t224 = 3.7502436046536086e-6 * work->t30;
    const double t225 = t218 + t220;
    const double t226 = t225 + t222;
    const double t227 = t226 + t224;
    state->ahead_angle = t227;

    /* the estimate; until the window is full, the start */
    const int t228 = 20U < work->t76;
    work->t229 = t228 ? t195 : work->t41;
    work->t230 = t228 ? t198 : work->t50;
    work->t231 = t228 ? t201 : 0.0;
    work->t232 = t228 ? t204 : 0.0;
    const uint32_t t233 = state->coasting;
    const int t234 = t233 == 0U;
    const inverted_cart_status t238 = t234 ? INVERTED_CART_CONVERGED : INVERTED_CART_COASTING;
    work->t239 = t228 ? t238 : INVERTED_CART_CONVERGING;
}

void inverted_cart_init(inverted_cart_state *state)
{
    for (uint32_t slot = 0U; slot < 21U; ++slot) {
        state->x[slot] = 0.0;
    }
    for (uint32_t slot = 0U; slot < 21U; ++slot) {
        state->angle[slot] = 0.0;
    }
    for (uint32_t slot = 0U; slot < 21U; ++slot) {
        state->force[slot] = 0.0;
    }
    for (uint32_t slot = 0U; slot < 21U; ++slot) {
        state->sin_2_pi_1_5_t[slot] = 0.0;
    }
    state->newest = 20U;
    state->count = 0U;
    state->missed_x = 0U;
    state->missed_angle = 0U;
    state->coasting = 0U;
    state->ahead_x = 0.0;
    state->ahead_angle = 0.0;
    state->calls = 0U;
}

void inverted_cart_step(inverted_cart_state *state, const inverted_cart_measurements *measurements,
                        const inverted_cart_inputs *inputs, inverted_cart_estimate *estimate)
{
    inverted_cart_work work;
    inverted_cart_part_1(state, measurements, inputs, &work);
    inverted_cart_part_2(state, &work);
    inverted_cart_part_3(state, &work);
    inverted_cart_part_4(state, &work);

    estimate->x = work.t229;
    estimate->angle = work.t230;
    estimate->dx = work.t231;
    estimate->dangle = work.t232;
    estimate->status = work.t239;
}
