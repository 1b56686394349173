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
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
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
        0.17676697496624147, 0.014295153250133892, 2.5680695621305105, 0.0586878904008786,
        0.00014295153250133892, 0.1809893011903116, 0.013095980356630735, 2.764013814158315,
        1.8696500692984467e-5, 4.6199290428113765e-5, 0.009028029533648573, 0.022561781753411832,
        -1.7525893903388896e-10, 1.0238032167484426e-6, -1.220589341660613e-8, 0.0007465935687527704
    },
    {
        0.16392126385783706, 0.008333676770245858, 2.3123429273473155, -0.0011543414936114084,
        0.0001399265303643064, 0.16723791578915922, 0.012410682368957662, 2.4887181094986217,
        5.233757528518322e-5, 0.00012888877379307371, 0.00884992259159054, 0.0221008858796081,
        -1.1448321774002624e-9, 5.934719990491249e-6, -5.563499744470325e-8, 0.0014768369535429924
    },
    {
        0.15106480596815644, 0.0034848083074538873, 2.05646669664508, -0.04441322328783421,
        0.00013671855453118998, 0.15361678566910883, 0.011729246238881571, 2.2153614305119524,
        7.878544482749917e-5, 0.00019311252040643157, 0.008572835933600385, 0.021391513686030716,
        -2.768616076885105e-9, 1.0845774679050265e-5, -9.780958500045315e-8, 0.0014395136723017671
    },
    {
        0.13819757007786054, -0.0003415006468616343, 1.8004361784237095, -0.07290112468915295,
        0.00013332485948917364, 0.14011531611746814, 0.011051137268627746, 1.9437310257892622,
        9.863579698152595e-5, 0.00024067566745379306, 0.008208519320940692, 0.02046593451580141,
        -4.696467075665402e-9, 1.4612913557854433e-5, -1.3197615985483752e-7, 0.0013866936824276097
    },
    {
        0.12531952369764582, -0.0032345805309527543, 1.544246699059517, -0.0884205229867063,
        0.00012974255421565678, 0.12672300367020903, 0.010375823247848215, 1.6736154486436985,
        0.00011248318681334467, 0.00027331137792536276, 0.007768704125078789, 0.019355403580571064,
        -6.648881613598151e-9, 1.734033968671536e-5, -1.5660475276898912e-7, 0.0013203732133597104
    },
    {
        0.11243063304776234, -0.005283113277705993, 1.287893599363629, -0.09276540762366692,
        0.0001259685998953329, 0.11342942793904066, 0.009702774039081163, 1.4048043924765325,
        0.00012092114120963275, 0.0002926873866688601, 0.007265105585394728, 0.018090292170147834,
        -8.414418629233522e-9, 1.9130626309239885e-5, -1.7107758669028704e-7, 0.0012425266503871117
    },
    {
        0.09953086303652513, -0.006575201387524712, 1.0313722310510238, -0.08772267842502898,
        0.00012199980752157299, 0.10022424350167251, 0.009031461164745987, 1.1370885270000508,
        0.00012454226250302675, 0.0003004124783231655, 0.006709425053515292, 0.01670021693405114,
        -9.842997746281306e-9, 2.0084876597343415e-5, -1.755554681655337e-7, 0.001155109661335193
    },
    {
        0.08662017723780192, -0.007198436562859713, 0.7746779532174578, -0.07507353857004151,
        0.00011783283538022023, 0.08709717184895607, 0.008361357395352239, 0.8702593351898593,
        0.00012393833138798414, 0.0002980429037942093, 0.006113352226104287, 0.01521416836826311,
        -1.083924468362774e-8, 2.030288124729495e-5, -1.7084483360263802e-7, 0.0010600622954306288
    },
    {
        0.07369853786745958, -0.007239967957824562, 0.5178061288215297, -0.05659488339451871,
        0.00011346418641381134, 0.07403799338263627, 0.007691936338601563, 0.6041089508395965,
        0.00011970040920784306, 0.00028708874187462284, 0.005488567367929816, 0.01366063863966859,
        -1.1355878655281419e-8, 1.9883274155316453e-5, -1.582653411724156e-7, 0.0009593120588870471
    },
    {
        0.06076590575875051, -0.006786570096042454, 0.26075212116914515, -0.03406068610521793,
        0.00010889020546414552, 0.06103653945748247, 0.007022672029062405, 0.33842999659149575,
        0.00011241893969329616, 0.00026902021255507274, 0.004846743527021107, 0.012067748880022721,
        -1.1387136558827778e-8, 1.892368639856211e-5, -1.3951789960027626e-7, 0.0008547769717268047
    },
    {
        0.04782224033661983, -0.005924710509623013, 0.003511290397636122, -0.009243381486278785,
        0.00010410707639102724, 0.04808268446160195, 0.006353038518097583, 0.07301542231658457,
        0.00010268385023207708, 0.00024527394852794397, 0.0041995487437209, 0.010463376080760882,
        -1.0962228779083866e-8, 1.7520898745363333e-5, -1.1655302546668083e-7, 0.0007483686103326542
    },
    {
        0.03486749959091301, -0.004740617151960313, -0.25392101004320405, 0.016084751323638055,
        9.911081906491172e-5, 0.03516633792876735, 0.005682509463725046, -0.19234165628144437,
        9.108465274929961e-5, 0.0002172592313430781, 0.003558648255434215, 0.008875279719568991,
        -1.0138821457689988e-8, 1.5770992916941334e-5, -9.143942091562854e-8, 0.0006419951402065919
    },
    {
        0.021901640048462727, -0.0033203456368772802, -0.511549436915915, 0.04015020590538863,
        9.389728623108358e-5, 0.022277436676613655, 0.005010557720091928, -0.45784811896450506,
        7.821054427759749e-5, 0.000186364198640576, 0.0029357066988706954, 0.007331228249362271,
        -8.996540099370765e-9, 1.3769501821358786e-5, -6.623266386231792e-8, 0.0005375643434018214
    },
    {
        0.008924616744033158, -0.0017498463565164594, -0.7693786607287437, 0.06117686440610983,
        8.846216024289788e-5, 0.009405936964578922, 0.004336654926241717, -0.7237110022862958,
        6.465050729597953e-5, 0.00015396202885720192, 0.0023423903115754765, 0.005859125580177531,
        -7.630489401560281e-9, 1.1611558979304305e-5, -4.284390289467458e-8, 0.0004369866450875287
    },
    {
        -0.004063616809901295, -0.00011503153029279338, -1.0274133692803542, 0.07738461107909249,
        8.280094966151111e-5, -0.0034581933345228092, 0.0036602710938537096, -0.9901376610721921,
        5.099340991614624e-5, 0.00012141710978065603, 0.0017903691345428215, 0.004487137684467455,
        -6.144784206026106e-9, 9.392047360376592e-6, -2.2908449078750175e-8, 0.0003421781437050519
    },
    {
        -0.017063108654566582, 0.0014981577628194996, -1.285658271218641, 0.0869879424351367,
        7.690898571942403e-5, -0.01632498255539826, 0.0029808741936330676, -1.2573359301788092,
        3.782810599490543e-5, 9.009119730989039e-5, 0.0012913192177074566, 0.003243819456395467,
        -4.646086479053981e-9, 7.205747847858638e-6, -7.65415680509203e-9, 0.00025506364917801634
    },
    {
        -0.030073908417513652, 0.0030036845163966767, -1.5441180996164228, 0.08819457292090932,
        7.078141864505238e-5, -0.029204463059738842, 0.0022979297400286683, -1.5255142866594287,
        2.5743535251279247e-5, 6.134957076971549e-5, 0.0008569248301107466, 0.0021582419559664787,
        -3.2371432306742957e-9, 5.1474875495451935e-6, 2.230514347992482e-9, 0.00017757973364812289
    },
    {
        -0.04309606734648279, 0.004315348640764614, -1.8027976155668084, 0.07920403503612401,
        6.441321384543201e-5, -0.042106679060349074, 0.0016109003739545923, -1.7948820124618294,
        1.532882346691032e-5, 3.656719112417179e-5, 0.0004988806765424789, 0.0012601201691924172,
        -2.0103202833257725e-9, 3.312288172008786e-6, 6.7288650079182e-9, 0.0001116777992225118
    },
    {
        -0.05612963834453434, 0.005346719666901368, -2.0617016118010425, 0.0582062727968158,
        5.779914794405428e-5, -0.05504169445604184, 0.0009192454431894527, -2.0656493577854977,
        7.1733828484530655e-6, 1.7134868435518124e-5, 0.00022889412246415147, 0.0005799414159822903,
        -1.041126796260142e-9, 1.7955146757603143e-6, 6.628857269845573e-9, 5.932716723800802e-5
    },
    {
        -0.06917467600647345, 0.0060110692575375485, -2.3208349163316555, 0.02338022744657973,
        5.0933804670713384e-5, -0.06801960068341219, 0.0002224205801259109, -2.3380277052257346,
        1.8670126307756314e-6, 4.465444924218529e-6, 5.86874290262425e-5, 0.00014909453806501456,
        -3.8172544389029426e-10, 6.930244290800707e-7, 3.6566608660470776e-9, 2.2518193572092315e-5
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

/* The bit of the sign. */
#define INVERTED_CART_SIGN_F64 UINT64_C(0x8000000000000000)

/* The bits of the largest magnitude. */
#define INVERTED_CART_MAGNITUDE_F64 UINT64_C(0x7FFFFFFFFFFFFFFF)

/* The bits of infinity. */
#define INVERTED_CART_INFINITY_F64 UINT64_C(0x7FF0000000000000)

/* The bits of the only NaN that is returned. */
#define INVERTED_CART_NAN_F64 UINT64_C(0x7FF8000000000000)

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
    const int t68 = t40 || t49;
    const int t69 = t68 || t67;
    const int t70 = t6 && t8;

    /* how much of the window is good */
    const uint32_t t72 = (t2 < 21U) ? (t2 + 1U) : 21U;
    const uint32_t t73 = t69 ? 0U : t72;
    const uint32_t t74 = t10 ? t72 : 1U;
    const uint32_t t75 = t70 ? t74 : 0U;
    work->t76 = t4 ? t73 : t75;
    state->count = work->t76;
    const uint32_t t77 = state->coasting;
    const uint32_t t78 = (t77 > 0U) ? (t77 - 1U) : 0U;
    const uint32_t t79 = t10 ? t78 : 20U;
    const uint32_t t81 = t70 ? t79 : 21U;
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
    const double t156 = -0.08223123665659744 * work->t154;
    const double t157 = work->t84 + t156;
    const double t159 = 0.006221303472788336 * work->t154;
    const double t160 = work->t88 + t159;
    const double t162 = -2.580202396123767 * work->t154;
    const double t163 = work->t92 + t162;
    const double t165 = -0.02710758568861546 * work->t154;
    const double t166 = work->t96 + t165;
    const double t167 = state->angle[work->t100];
    const double t169 = 4.381157060013194e-5 * t167;
    const double t170 = work->t85 + t169;
    const double t172 = -0.08105052459161606 * t167;
    const double t173 = work->t89 + t172;
    const double t175 = -0.00048012272345942066 * t167;
    const double t176 = work->t93 + t175;
    const double t178 = -2.612229734832813 * t167;
    const double t179 = work->t97 + t178;
    const double t180 = state->sin_2_pi_1_5_t[work->t100];
    const double t182 = -5.442313416638647e-11 * t180;
    const double t183 = work->t87 + t182;
    const double t185 = 1.0131707886406653e-7 * t180;
    const double t186 = work->t91 + t185;
    const double t188 = 6.109537976205512e-10 * t180;
    const double t189 = work->t95 + t188;
    const double t191 = 3.2654145601730514e-6 * t180;
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
