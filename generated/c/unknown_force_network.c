/* unknown_force_network.c: Finite-time observer: Sprung mass in a force field that a network of three Gaussians and a sine describe.
 *
 * Generated; unknown_force_network.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "unknown_force_network.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "unknown_force_network.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "unknown_force_network.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* what the outputs show of the state at the window's start, orthonormal, by sample from the second
 *   [0] column 1 at x
 *   [1] column 2 at x
 */
static const double UNKNOWN_FORCE_NETWORK_SHOWN[100][2] = {
    { -0.13930435139258493, 0.008873280008329355 },
    { -0.13846824589419704, 0.01780552738053582 },
    { -0.13707845201194543, 0.026666576380758113 },
    { -0.1351405270685476, 0.03542099462615216 },
    { -0.13266222018022175, 0.04403377611473782 },
    { -0.12965344127055253, 0.052470481202738346 },
    { -0.1261262214440083, 0.060697374317242106 },
    { -0.12209466487756244, 0.06868155885351944 },
    { -0.11757489242278867, 0.07639110871758532 },
    { -0.11258497714394626, 0.08379519598801281 },
    { -0.10714487204981725, 0.09086421418652038 },
    { -0.10127633030827175, 0.09756989666441497 },
    { -0.09500281826259685, 0.10388542963150292 },
    { -0.08834942159740773, 0.10978555937550384 },
    { -0.08134274502935233, 0.11524669324323254 },
    { -0.07401080592371301, 0.12024699397975912 },
    { -0.06638292226229685, 0.12476646704831626 },
    { -0.058489595410593946, 0.1287870405817904 },
    { -0.050362388152978485, 0.13229263764609767 },
    { -0.042033798483649305, 0.13526924052648706 },
    { -0.03353712965797803, 0.13770494677971173 },
    { -0.024906357023885987, 0.13959001682793412 },
    { -0.016175992165746955, 0.14091691290405298 },
    { -0.007380944904058962, 0.14168032919272272 },
    { 0.0014436162972974694, 0.14187721304654136 },
    { 0.010262404958029816, 0.14150677719257038 },
    { 0.019040157680312357, 0.14057050288037712 },
    { 0.02774177515536588, 0.13907213395901097 },
    { 0.03633246251389996, 0.13701766190659856 },
    { 0.04477786845920315, 0.13441530187241868 },
    { 0.0530442226265342, 0.1312754598272573 },
    { 0.06109847061955987, 0.1276106909533971 },
    { 0.06890840618387362, 0.12343564944062653 },
    { 0.07644279998907727, 0.11876702988901684 },
    { 0.08367152450446909, 0.1136235005527783 },
    { 0.09056567446900181, 0.10802562869213109 },
    { 0.09709768247379175, 0.10199579833168375 },
    { 0.10324142919500257, 0.09555812075417618 },
    { 0.10897234783631958, 0.08873833808749267 },
    { 0.11426752236338361, 0.08156372037046872 },
    { 0.11910577913737783, 0.07406295650909088 },
    { 0.1234677715813552, 0.06626603955911956 },
    { 0.12733605754075433, 0.058204146793851365 },
    { 0.1306951690287646, 0.04990951503659017 },
    { 0.13353167407765215, 0.041415311756330495 },
    { 0.13583423044872392, 0.032755502442098974 },
    { 0.13759363098616148, 0.023964714786279533 },
    { 0.13880284043336968, 0.015078100220007929 },
    { 0.13945702356462403, 0.006131193354309563 },
    { 0.13955356451952738, -0.002840230110971483 },
    { 0.13909207726296424, -0.01180029644227723 },
    { 0.13807440712872654, -0.020713177319444775 },
    { 0.13650462344063863, -0.029543233101222224 },
    { 0.13438900324068698, -0.0382551553363205 },
    { 0.13173600618922057, -0.04681410795014684 },
    { 0.12855624073758748, -0.05518586654266128 },
    { 0.12486242170847223, -0.06333695524035034 },
    { 0.12066931945355583, -0.07123478055509257 },
    { 0.11599370079180037, -0.07884776171465877 },
    { 0.11085426196452579, -0.08614545694369889 },
    { 0.10527155387536971, -0.09309868519025985 },
    { 0.09926789991407038, -0.0996796428110903 },
    { 0.09286730669266828, -0.10586201474914728 },
    { 0.08609536805106255, -0.11162107975874207 },
    { 0.07897916271577188, -0.11693380925756591 },
    { 0.07154714602112867, -0.12177895941031842 },
    { 0.06382903612587706, -0.1261371560757275 },
    { 0.055855695180156865, -0.12999097227728565 },
    { 0.047659005918047094, -0.13332499788792318 },
    { 0.03927174416913425, -0.13612590124997231 },
    { 0.030727447798889286, -0.13838248248402482 },
    { 0.022060282601916895, -0.1400857182735183 },
    { 0.013304905684325423, -0.141228797945973 },
    { 0.004496326881505749, -0.14180715070660224 },
    { -0.004330231234536731, -0.14181846391539765 },
    { -0.013139474198512944, -0.1412626923346063 },
    { -0.0218961767826583, -0.14014205830962143 },
    { -0.030565323850683022, -0.13846104288256345 },
    { -0.039112250371636695, -0.13622636787408549 },
    { -0.0475027800338182, -0.1334469690050521 },
    { -0.05570336190446013, -0.13013396016556827 },
    { -0.06368120458873132, -0.12630058897423577 },
    { -0.07140440735160009, -0.12196218380533982 },
    { -0.07884208767824569, -0.11713609249578695 },
    { -0.08596450476294652, -0.1118416129768849 },
    { -0.09274317843265377, -0.1060999161083444 },
    { -0.09915100302971513, -0.09993396102306448 },
    { -0.10516235579836944, -0.0933684033212089 },
    { -0.11075319934161046, -0.08642949648067527 },
    { -0.11590117773872945, -0.07914498687818343 },
    { -0.12058570593919399, -0.07154400284075882 },
    { -0.12478805207540708, -0.06365693817125692 },
    { -0.128491412365205, -0.055515330613671594 },
    { -0.131680978304584, -0.0471517357442037 },
    { -0.1343439958819741, -0.038599596792358054 },
    { -0.13646981657728247, -0.029893110912610373 },
    { -0.13804993994177758, -0.021067092441379515 },
    { -0.13907804758855175, -0.012156833686094735 },
    { -0.13955002845764522, -0.0031979638030160966 },
    { -0.13946399525480563, 0.005773693671891355 }
};

/* The number significand / 2^63 * 2^exponent, with the top bit of the significand set. */
typedef struct {
    uint64_t significand;
    int32_t exponent;
} unknown_force_network_scaled_t;

/* A number with a sign. */
typedef struct {
    unknown_force_network_scaled_t magnitude;
    int negative;
} unknown_force_network_signed_t;

/* The angle quadrant * pi/2 + rest. */
typedef struct {
    unknown_force_network_signed_t rest;
    uint32_t quadrant;
} unknown_force_network_turned_t;

/* Attaches a sign. */
static unknown_force_network_signed_t unknown_force_network_signed(unknown_force_network_scaled_t magnitude, int negative)
{
    unknown_force_network_signed_t result;
    result.magnitude = magnitude;
    result.negative = negative;
    return result;
}

/* A number below 1 as fixed point with 64 fraction bits. */
static uint64_t unknown_force_network_fraction(unknown_force_network_scaled_t a)
{
    const int32_t shift = -1 - a.exponent;
    if (shift > 63) {
        return 0;
    }
    return a.significand >> shift;
}

/* The upper half of the product, at most 2 too small. */
static uint64_t unknown_force_network_mul_high(uint64_t a, uint64_t b)
{
    const uint64_t a_high = a >> 32;
    const uint64_t a_low = a & 0xFFFFFFFFu;
    const uint64_t b_high = b >> 32;
    const uint64_t b_low = b & 0xFFFFFFFFu;
    const uint64_t cross = ((a_high * b_low) >> 32) + ((a_low * b_high) >> 32);
    return a_high * b_high + cross;
}

/* The square of a number below 1 as fixed point with 64 fraction bits. */
static uint64_t unknown_force_network_squared_fraction(unknown_force_network_scaled_t a)
{
    const uint64_t x = unknown_force_network_fraction(a);
    return unknown_force_network_mul_high(x, x);
}

/* Makes a number of a significand that has its top bit set. */
static unknown_force_network_scaled_t unknown_force_network_scaled(uint64_t significand, int32_t exponent)
{
    unknown_force_network_scaled_t result;
    result.significand = significand;
    result.exponent = exponent;
    return result;
}

/* Makes a number of a significand of at least 2^62. */
static unknown_force_network_scaled_t unknown_force_network_settled(uint64_t significand, int32_t exponent)
{
    if ((significand >> 63) == 0) {
        return unknown_force_network_scaled(significand << 1, exponent - 1);
    }
    return unknown_force_network_scaled(significand, exponent);
}

/* (1 - cos(r)) / r^2 in powers of -r^2. */
static const uint64_t UNKNOWN_FORCE_NETWORK_COSINE[8] = {
    UINT64_C(0x8000000000000000), UINT64_C(0x0AAAAAAAAAAAAAA8), UINT64_C(0x005B05B05B05B02B),
    UINT64_C(0x0001A01A01A01865), UINT64_C(0x0000049F93EDD666), UINT64_C(0x00000008F76C6243),
    UINT64_C(0x000000000C9C9706), UINT64_C(0x00000000000D551B)};

/* cos(r) for 0 < r <= pi/4, relative error below 2^-60. */
static unknown_force_network_scaled_t unknown_force_network_cosine(unknown_force_network_scaled_t r)
{
    const uint64_t z = unknown_force_network_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = UNKNOWN_FORCE_NETWORK_COSINE[6] - ((UNKNOWN_FORCE_NETWORK_COSINE[7] * z_high) >> 32);
    const uint64_t c5 = UNKNOWN_FORCE_NETWORK_COSINE[5] - ((tail * z_high) >> 32);
    const uint64_t c4 = UNKNOWN_FORCE_NETWORK_COSINE[4] - unknown_force_network_mul_high(c5, z);
    const uint64_t c3 = UNKNOWN_FORCE_NETWORK_COSINE[3] - unknown_force_network_mul_high(c4, z);
    const uint64_t c2 = UNKNOWN_FORCE_NETWORK_COSINE[2] - unknown_force_network_mul_high(c3, z);
    const uint64_t c1 = UNKNOWN_FORCE_NETWORK_COSINE[1] - unknown_force_network_mul_high(c2, z);
    const uint64_t c0 = UNKNOWN_FORCE_NETWORK_COSINE[0] - unknown_force_network_mul_high(c1, z);
    return unknown_force_network_settled((UINT64_C(1) << 63) - (unknown_force_network_mul_high(c0, z) >> 1), 0);
}

/* (1 - sin(r) / r) / r^2 in powers of -r^2. */
static const uint64_t UNKNOWN_FORCE_NETWORK_SINE[7] = {
    UINT64_C(0x2AAAAAAAAAAAAAA6), UINT64_C(0x0222222222222160), UINT64_C(0x000D00D00D00C575),
    UINT64_C(0x00002E3BC74A673D), UINT64_C(0x0000006B9914A637), UINT64_C(0x00000000B090498C),
    UINT64_C(0x0000000000D552BC)};

/* sin(r) for 0 < r <= pi/4, relative error below 2^-60. */
static unknown_force_network_scaled_t unknown_force_network_sine(unknown_force_network_scaled_t r)
{
    const uint64_t z = unknown_force_network_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = UNKNOWN_FORCE_NETWORK_SINE[5] - ((UNKNOWN_FORCE_NETWORK_SINE[6] * z_high) >> 32);
    const uint64_t c4 = UNKNOWN_FORCE_NETWORK_SINE[4] - ((tail * z_high) >> 32);
    const uint64_t c3 = UNKNOWN_FORCE_NETWORK_SINE[3] - unknown_force_network_mul_high(c4, z);
    const uint64_t c2 = UNKNOWN_FORCE_NETWORK_SINE[2] - unknown_force_network_mul_high(c3, z);
    const uint64_t c1 = UNKNOWN_FORCE_NETWORK_SINE[1] - unknown_force_network_mul_high(c2, z);
    const uint64_t c0 = UNKNOWN_FORCE_NETWORK_SINE[0] - unknown_force_network_mul_high(c1, z);
    const uint64_t lost = unknown_force_network_mul_high(r.significand, unknown_force_network_mul_high(c0, z));
    return unknown_force_network_settled(r.significand - lost, r.exponent);
}

/* The sine of an angle. */
static unknown_force_network_signed_t unknown_force_network_sine_at(unknown_force_network_turned_t angle)
{
    const int back = (angle.quadrant & 2) != 0;
    if ((angle.quadrant & 1) != 0) {
        return unknown_force_network_signed(unknown_force_network_cosine(angle.rest.magnitude), back);
    }
    return unknown_force_network_signed(unknown_force_network_sine(angle.rest.magnitude), back != angle.rest.negative);
}

/* Makes an angle of its parts. */
static unknown_force_network_turned_t unknown_force_network_turned(unknown_force_network_signed_t rest, uint32_t quadrant)
{
    unknown_force_network_turned_t result;
    result.rest = rest;
    result.quadrant = quadrant;
    return result;
}

/* The number of zero bits above the highest one bit; x is not 0. */
static int32_t unknown_force_network_leading_zeros(uint64_t x)
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
static unknown_force_network_scaled_t unknown_force_network_normalised(uint64_t significand, int32_t exponent)
{
    const int32_t shift = unknown_force_network_leading_zeros(significand);
    return unknown_force_network_scaled(significand << shift, exponent - shift);
}

/* a b, relative error below 2^-60. */
static unknown_force_network_scaled_t unknown_force_network_product(unknown_force_network_scaled_t a, unknown_force_network_scaled_t b)
{
    return unknown_force_network_settled(unknown_force_network_mul_high(a.significand, b.significand),
                            a.exponent + b.exponent + 1);
}

/* pi with 62 fraction bits; as a significand also pi/2 and pi/4. */
#define UNKNOWN_FORCE_NETWORK_PI UINT64_C(0xC90FDAA22168C235)

/* The angle of (high, low) / 2^126 quarter turns, its rest exact to 2^-60 of itself. */
static unknown_force_network_turned_t unknown_force_network_turned_from_quarters(uint64_t high, uint64_t low)
{
    const uint64_t eighths = high >> 61;
    const int negative = (eighths & 1) != 0;
    uint64_t upper = (high << 2) | (low >> 62);
    uint64_t lower = low << 2;
    if (negative) {
        upper = (lower == 0) ? (UINT64_C(0) - upper) : UINT64_MAX - upper;
        lower = (UINT64_C(0) - lower);
    }
    const int32_t shift = unknown_force_network_leading_zeros(upper | 1);
    const uint64_t significand = (upper << shift) | ((lower >> 1) >> (63 - shift));
    const unknown_force_network_signed_t rest = unknown_force_network_signed(
        unknown_force_network_product(unknown_force_network_scaled(significand, -1 - shift), unknown_force_network_scaled(UNKNOWN_FORCE_NETWORK_PI, 0)),
        negative);
    return unknown_force_network_turned(rest, (uint32_t)(((eighths + 1) >> 1) & 3));
}

/* The cosine of an angle: the sine a quarter turn later. */
static unknown_force_network_signed_t unknown_force_network_cosine_at(unknown_force_network_turned_t angle)
{
    return unknown_force_network_sine_at(unknown_force_network_turned(angle.rest, angle.quadrant + 1));
}

/* The first 64 bits of 1 / log(2), 63 of them behind the point. */
#define UNKNOWN_FORCE_NETWORK_LOG2_E UINT64_C(0xB8AA3B295C17F0BB)

/* The 64 bits of 1 / log(2) that follow. */
#define UNKNOWN_FORCE_NETWORK_LOG2_E_LOW UINT64_C(0xBE87FED0691D3E88)

/* (2^g - 1) / g for 0 <= g < 1/16. */
static const uint64_t UNKNOWN_FORCE_NETWORK_EXP2[7] = {
    UINT64_C(0xB17217F7D1CF7AA4), UINT64_C(0x3D7F7BFF05899176), UINT64_C(0x0E35846B8325C9E5),
    UINT64_C(0x0276556DC0C05222), UINT64_C(0x005762071187A944), UINT64_C(0x000A17B98000087C),
    UINT64_C(0x00010573837C79AD)};

/* 2^(k/16) with 63 fraction bits. */
static const uint64_t UNKNOWN_FORCE_NETWORK_EXP2_TABLE[16] = {
    UINT64_C(0x8000000000000000), UINT64_C(0x85AAC367CC487B15), UINT64_C(0x8B95C1E3EA8BD6E7),
    UINT64_C(0x91C3D373AB11C336), UINT64_C(0x9837F0518DB8A96F), UINT64_C(0x9EF5326091A111AE),
    UINT64_C(0xA5FED6A9B15138EA), UINT64_C(0xAD583EEA42A14AC6), UINT64_C(0xB504F333F9DE6484),
    UINT64_C(0xBD08A39F580C36BF), UINT64_C(0xC5672A115506DADD), UINT64_C(0xCE248C151F8480E4),
    UINT64_C(0xD744FCCAD69D6AF4), UINT64_C(0xE0CCDEEC2A94E111), UINT64_C(0xEAC0C6E7DD24392F),
    UINT64_C(0xF5257D152486CC2C)};

/* 2^f for f < 1 with 64 fraction bits, as a significand, relative error below 2^-60. */
static uint64_t unknown_force_network_exp2_fraction(uint64_t f)
{
    const uint64_t slot = f >> 60;
    const uint64_t g = f & UINT64_C(0x0FFFFFFFFFFFFFFF);
    const uint64_t c5 = UNKNOWN_FORCE_NETWORK_EXP2[5] + unknown_force_network_mul_high(UNKNOWN_FORCE_NETWORK_EXP2[6], g);
    const uint64_t c4 = UNKNOWN_FORCE_NETWORK_EXP2[4] + unknown_force_network_mul_high(c5, g);
    const uint64_t c3 = UNKNOWN_FORCE_NETWORK_EXP2[3] + unknown_force_network_mul_high(c4, g);
    const uint64_t c2 = UNKNOWN_FORCE_NETWORK_EXP2[2] + unknown_force_network_mul_high(c3, g);
    const uint64_t c1 = UNKNOWN_FORCE_NETWORK_EXP2[1] + unknown_force_network_mul_high(c2, g);
    const uint64_t c0 = UNKNOWN_FORCE_NETWORK_EXP2[0] + unknown_force_network_mul_high(c1, g);
    const uint64_t base = UNKNOWN_FORCE_NETWORK_EXP2_TABLE[slot];
    return base + unknown_force_network_mul_high(base, unknown_force_network_mul_high(c0, g));
}

/* 2^p or 2^-p for p = (high, low) / 2^127 * 2^exponent, -64 <= exponent <= 10, high's top bit set. */
static unknown_force_network_scaled_t unknown_force_network_exp2(int negative, uint64_t high, uint64_t low, int32_t exponent)
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
    return unknown_force_network_scaled(unknown_force_network_exp2_fraction(part), whole);
}

/* The bits of a number. */
typedef union {
    double value;
    uint64_t bits;
} unknown_force_network_f64_cell_t;

/* The bits of a number. */
static uint64_t unknown_force_network_f64_to_bits(double x)
{
    unknown_force_network_f64_cell_t cell;
    cell.value = x;
    return cell.bits;
}

/* The bit of the sign. */
#define UNKNOWN_FORCE_NETWORK_SIGN_F64 UINT64_C(0x8000000000000000)

/* The bits of the largest magnitude. */
#define UNKNOWN_FORCE_NETWORK_MAGNITUDE_F64 UINT64_C(0x7FFFFFFFFFFFFFFF)

/* The bits of infinity. */
#define UNKNOWN_FORCE_NETWORK_INFINITY_F64 UINT64_C(0x7FF0000000000000)

/* The bits of the only NaN that is returned. */
#define UNKNOWN_FORCE_NETWORK_NAN_F64 UINT64_C(0x7FF8000000000000)

/* The bits of 1. */
#define UNKNOWN_FORCE_NETWORK_ONE_F64 UINT64_C(0x3FF0000000000000)

/* The number with these bits. */
static double unknown_force_network_f64_from_bits(uint64_t bits)
{
    unknown_force_network_f64_cell_t cell;
    cell.bits = bits;
    return cell.value;
}

/* The finite positive number with these bits, not 0; exact. */
static unknown_force_network_scaled_t unknown_force_network_unpacked_f64(uint64_t magnitude)
{
    const int32_t field = (int32_t)(magnitude >> 52);
    const uint64_t digits = magnitude << 11;
    if (field == 0) {
        return unknown_force_network_normalised(digits, -1022);
    }
    return unknown_force_network_scaled(digits | (UINT64_C(1) << 63), field - 1023);
}

/* 2/pi after 64 zero bits. */
static const uint32_t UNKNOWN_FORCE_NETWORK_TWO_OVER_PI_F64[40] = {
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
static uint64_t unknown_force_network_window_f64(uint32_t slot, uint32_t shift)
{
    const uint64_t first = (uint64_t)(UNKNOWN_FORCE_NETWORK_TWO_OVER_PI_F64[slot]);
    const uint64_t second = (uint64_t)(UNKNOWN_FORCE_NETWORK_TWO_OVER_PI_F64[slot + 1]);
    return (((first << 32) | second) >> (32 - shift)) & 0xFFFFFFFFu;
}

/* A 128-bit unsigned integer. */
typedef struct {
    uint64_t high;
    uint64_t low;
} unknown_force_network_pair_t;

/* Makes a 128-bit integer of its halves. */
static unknown_force_network_pair_t unknown_force_network_pair(uint64_t high, uint64_t low)
{
    unknown_force_network_pair_t result;
    result.high = high;
    result.low = low;
    return result;
}

/* The exact 128-bit product. */
static unknown_force_network_pair_t unknown_force_network_mul_full(uint64_t a, uint64_t b)
{
    const uint64_t a_high = a >> 32;
    const uint64_t a_low = a & 0xFFFFFFFFu;
    const uint64_t b_high = b >> 32;
    const uint64_t b_low = b & 0xFFFFFFFFu;
    const uint64_t lowest = a_low * b_low;
    const uint64_t first = a_high * b_low + (lowest >> 32);
    const uint64_t second = a_low * b_high + (first & 0xFFFFFFFFu);
    const uint64_t high = a_high * b_high + (first >> 32) + (second >> 32);
    return unknown_force_network_pair(high, (second << 32) | (lowest & 0xFFFFFFFFu));
}

/* The angle with these bits, positive and finite, its rest exact to 2^-60 of itself. */
static unknown_force_network_turned_t unknown_force_network_reduce_f64(uint64_t magnitude)
{
    if (magnitude <= UINT64_C(0x3FE921FB54442D18)) {
        return unknown_force_network_turned(unknown_force_network_signed(unknown_force_network_unpacked_f64(magnitude), 0), 0);
    }
    const uint64_t digits = (magnitude & UINT64_C(0x000FFFFFFFFFFFFF)) | (UINT64_C(1) << 52);
    const uint32_t start = ((uint32_t)(magnitude >> 52)) - 1013;
    const uint32_t slot = start >> 5;
    const uint32_t shift = start & 31;
    const uint64_t upper =
        (unknown_force_network_window_f64(slot, shift) << 32) | unknown_force_network_window_f64(slot + 1, shift);
    const uint64_t middle =
        (unknown_force_network_window_f64(slot + 2, shift) << 32) | unknown_force_network_window_f64(slot + 3, shift);
    const uint64_t lower =
        (unknown_force_network_window_f64(slot + 4, shift) << 32) | unknown_force_network_window_f64(slot + 5, shift);
    const unknown_force_network_pair_t center = unknown_force_network_mul_full(middle, digits);
    const uint64_t low = (center.low + (unknown_force_network_mul_high(lower, digits)));
    const uint64_t carry = (low < center.low) ? 1 : 0;
    const uint64_t high = ((upper * digits) + (center.high + carry));
    return unknown_force_network_turned_from_quarters(high, low);
}

/* x rounded to the nearest, ties to even, with subnormals and overflow, and the sign put in. */
static double unknown_force_network_rounded_f64(uint64_t sign, unknown_force_network_scaled_t x)
{
    const int32_t field = x.exponent + 1023;
    if (field >= 2047) {
        return unknown_force_network_f64_from_bits(sign | UNKNOWN_FORCE_NETWORK_INFINITY_F64);
    }
    const int32_t shift = (field > 0) ? 11 : 12 - field;
    if (shift > 63) {
        const int least = shift == 64 && x.significand > (UINT64_C(1) << 63);
        return unknown_force_network_f64_from_bits(least ? sign + 1 : sign);
    }
    const uint64_t kept = x.significand >> shift;
    const uint64_t rest = x.significand - (kept << shift);
    const uint64_t half = UINT64_C(1) << (shift - 1);
    const uint64_t odd = kept & 1;
    const uint64_t up = (rest + odd > half) ? 1 : 0;
    const uint64_t base = (field > 0) ? ((uint64_t)(field - 1)) << 52 : 0;
    return unknown_force_network_f64_from_bits(sign | (base + (kept + up)));
}

/* The sign bit of a negative number, else 0. */
static uint64_t unknown_force_network_sign_f64(int negative)
{
    if (negative) {
        return UNKNOWN_FORCE_NETWORK_SIGN_F64;
    }
    return 0;
}

/* Sine of an angle in radians, error below 0.51 ulp. */
static double unknown_force_network_sin_f64(double x)
{
    const uint64_t bits = unknown_force_network_f64_to_bits(x);
    const uint64_t magnitude = bits & UNKNOWN_FORCE_NETWORK_MAGNITUDE_F64;
    if (magnitude >= UNKNOWN_FORCE_NETWORK_INFINITY_F64) {
        return unknown_force_network_f64_from_bits(UNKNOWN_FORCE_NETWORK_NAN_F64);
    }
    if (magnitude == 0) {
        return x;
    }
    const unknown_force_network_signed_t value = unknown_force_network_sine_at(unknown_force_network_reduce_f64(magnitude));
    return unknown_force_network_rounded_f64((bits & UNKNOWN_FORCE_NETWORK_SIGN_F64) ^ unknown_force_network_sign_f64(value.negative),
                                value.magnitude);
}

/* Cosine of an angle in radians, error below 0.51 ulp. */
static double unknown_force_network_cos_f64(double x)
{
    const uint64_t magnitude = unknown_force_network_f64_to_bits(x) & UNKNOWN_FORCE_NETWORK_MAGNITUDE_F64;
    if (magnitude >= UNKNOWN_FORCE_NETWORK_INFINITY_F64) {
        return unknown_force_network_f64_from_bits(UNKNOWN_FORCE_NETWORK_NAN_F64);
    }
    if (magnitude == 0) {
        return unknown_force_network_f64_from_bits(UNKNOWN_FORCE_NETWORK_ONE_F64);
    }
    const unknown_force_network_signed_t value = unknown_force_network_cosine_at(unknown_force_network_reduce_f64(magnitude));
    return unknown_force_network_rounded_f64(unknown_force_network_sign_f64(value.negative), value.magnitude);
}

/* The sum of two 128-bit integers; the caller knows that it fits. */
static unknown_force_network_pair_t unknown_force_network_pair_sum(unknown_force_network_pair_t a, unknown_force_network_pair_t b)
{
    const uint64_t low = (a.low + b.low);
    const uint64_t carry = (low < a.low) ? 1 : 0;
    return unknown_force_network_pair(a.high + b.high + carry, low);
}

/* The upper half of the product of 128 by 64 bits as 128 of 192 bits, at most 3 too small. */
static unknown_force_network_pair_t unknown_force_network_pair_times(unknown_force_network_pair_t a, uint64_t b)
{
    const uint64_t below = unknown_force_network_mul_high(a.low, b);
    return unknown_force_network_pair_sum(unknown_force_network_mul_full(a.high, b), unknown_force_network_pair(0, below));
}

/* Exponential function, error below 0.51 ulp. */
static double unknown_force_network_exp_f64(double x)
{
    const uint64_t bits = unknown_force_network_f64_to_bits(x);
    const uint64_t magnitude = bits & UNKNOWN_FORCE_NETWORK_MAGNITUDE_F64;
    const int negative = bits != magnitude;
    if (magnitude > UNKNOWN_FORCE_NETWORK_INFINITY_F64) {
        return unknown_force_network_f64_from_bits(UNKNOWN_FORCE_NETWORK_NAN_F64);
    }
    if (magnitude >= UINT64_C(0x4090000000000000)) {
        return unknown_force_network_f64_from_bits(negative ? 0 : UNKNOWN_FORCE_NETWORK_INFINITY_F64);
    }
    if (magnitude < UINT64_C(0x3C00000000000000)) {
        return unknown_force_network_f64_from_bits(UNKNOWN_FORCE_NETWORK_ONE_F64);
    }
    const unknown_force_network_scaled_t operand = unknown_force_network_unpacked_f64(magnitude);
    const unknown_force_network_pair_t power = unknown_force_network_pair_times(
        unknown_force_network_pair(UNKNOWN_FORCE_NETWORK_LOG2_E, UNKNOWN_FORCE_NETWORK_LOG2_E_LOW), operand.significand);
    const int32_t shift = ((power.high >> 63) == 0) ? 1 : 0;
    const uint64_t high = (power.high << shift) | ((power.low >> 1) >> (63 - shift));
    const int32_t exponent = operand.exponent + 1 - shift;
    return unknown_force_network_rounded_f64(0, unknown_force_network_exp2(negative, high, power.low << shift, exponent));
}

/* What one part of a step hands to the next. */
typedef struct {
    uint32_t t5;
    double t14;
    uint32_t t15;
    uint32_t t27;
    double t32;
    double t33;
    double t41;
    double t46;
    double t47;
    double t51;
    double t57;
    double t63;
    double t72;
    uint32_t t78;
    uint32_t t85;
    double t89;
    double t90;
    double t91;
    uint32_t t92;
    double t93;
    double t94;
    double t95;
    double t96;
    double t97;
    double t98;
    double t99;
    double t100;
    double t101;
    double t102;
    double t103;
    double t104;
    double t105;
    double t106;
    double t107;
    double t108;
    double t109;
    double t110;
    double t111;
    double t112;
    double t113;
    double t114;
    double t115;
    double t116;
    uint32_t t117;
    double t125;
    double t131;
    double t141;
    double t150;
    double t159;
    double t166;
    double t175;
    double t182;
    double t193;
    double t202;
    double t203;
    double t204;
    double t206;
    double t208;
    double t210;
    double t212;
    double t214;
    double t216;
    double t218;
    double t220;
    double t222;
    double t224;
    double t226;
    double t228;
    double t230;
    double t232;
    double t234;
    double t256;
    double t258;
    double t260;
    double t262;
    double t264;
    double t266;
    double t268;
    double t270;
    double t272;
    double t274;
    double t276;
    double t278;
    double t280;
    double t282;
    uint32_t t283;
    double t284;
    double t285;
    double t286;
    double t287;
    double t288;
    double t289;
    double t290;
    double t291;
    double t292;
    double t293;
    double t294;
    double t295;
    double t296;
    double t297;
    double t298;
    double t299;
    double t300;
    double t301;
    double t302;
    double t303;
    double t304;
    double t305;
    double t306;
    double t307;
    uint32_t t308;
    double t316;
    double t322;
    double t332;
    double t341;
    double t350;
    double t357;
    double t366;
    double t373;
    double t384;
    double t393;
    double t394;
    double t395;
    double t397;
    double t401;
    double t405;
    double t406;
    double t407;
    double t419;
    double t421;
    double t423;
    double t425;
    double t427;
    double t429;
    double t431;
    double t433;
    double t435;
    double t437;
    double t439;
    double t441;
    double t443;
    double t445;
    double t517;
    double t520;
    double t525;
    double t532;
    double t581;
    double t595;
    double t597;
    double t598;
    double t599;
    double t600;
    double t628;
    double t629;
    double t630;
    double t631;
    double t632;
    double t633;
    unknown_force_network_status t640;
    int flags[4]; /* t7, t534, t542, t544 */
} unknown_force_network_work;

/* Part 1 of a step. */
static void unknown_force_network_part_1(unknown_force_network_state *state, const unknown_force_network_measurements *measurements, const unknown_force_network_inputs *inputs, unknown_force_network_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    const uint32_t t0 = state->newest;
    const uint32_t t1 = (t0 < 100U) ? t0 : 100U;
    const uint32_t t2 = state->count;
    const int t4 = 100U < t2;
    work->t5 = state->found;
    work->flags[0] = 0U < work->t5;
    const int t8 = t4 && work->flags[0];
    const double t9 = measurements->x;
    const int t10 = (-3.0 <= t9) && (t9 <= 3.0);
    const double t11 = inputs->u;
    const int t12 = (-1e152 <= t11) && (t11 <= 1e152);
    const double t13 = state->u[t1];
    work->t14 = t12 ? t11 : t13;

    /* prediction, for a sample that is missing */
    work->t15 = (t1 < 100U) ? (t1 + 1U) : 0U;
    const double t16 = state->ahead_x;
    const double t18 = 4.9983335555396836e-5 * work->t14;
    const double t19 = t16 + t18;
    const double t20 = state->x[t1];
    const int t21 = (-3.0 <= t19) && (t19 <= 3.0);
    const int t22 = t8 && t21;
    const double t23 = t22 ? t19 : t20;
    const double t24 = t10 ? t9 : t23;
    work->t27 = state->calls;
    const double t28 = (double)work->t27;
    const double t30 = t28 * 0.01;
    const double t31 = 3.0 * t30;
    work->t32 = unknown_force_network_sin_f64(t31);
    work->t33 = unknown_force_network_cos_f64(t31);
    const double t36 = -6.25 * t24;
    const double t37 = -1.5625 + t36;
    const double t38 = t24 * t24;
    const double t39 = -6.25 * t38;
    const double t40 = t37 + t39;
    work->t41 = unknown_force_network_exp_f64(t40);
    const double t43 = 6.25 * t24;
    const double t44 = -1.5625 + t43;
    const double t45 = t44 + t39;
    work->t46 = unknown_force_network_exp_f64(t45);
    work->t47 = unknown_force_network_exp_f64(t39);
    const double t48 = state->exp_1_5625_6_25_x_6_25_x_2[t1];
    const double t49 = work->t41 - t48;
    work->t51 = state->found_left;
    const double t52 = 0.0001333066692062081 * work->t51;
    const double t53 = t52 * t49;
    const double t54 = t19 + t53;
    const double t55 = state->exp_1_5625_6_25_x_6_25_x_2_2[t1];
    const double t56 = work->t46 - t55;
    work->t57 = state->found_right;
    const double t58 = 0.0001333066692062081 * work->t57;
    const double t59 = t58 * t56;
    const double t60 = t54 + t59;
    const double t61 = state->exp_6_25_x_2[t1];
    const double t62 = work->t47 - t61;
    work->t63 = state->found_middle;
    const double t64 = 0.0001333066692062081 * work->t63;
    const double t65 = t64 * t62;
    const double t66 = t60 + t65;
    const int t67 = (-3.0 <= t66) && (t66 <= 3.0);
    const int t68 = t8 && t67;
    const double t69 = t68 ? t66 : t20;
    const int t70 = t10 || t68;
    const int t71 = !t70;
    work->t72 = t10 ? t9 : t69;

    /* how much of the window is good */
    const uint32_t t74 = (t2 < 101U) ? (t2 + 1U) : 101U;
    const uint32_t t75 = t71 ? 0U : t74;
    const uint32_t t76 = t12 ? t74 : 1U;
    const uint32_t t77 = t10 ? t76 : 0U;
    work->t78 = t8 ? t75 : t77;
    state->count = work->t78;
    const uint32_t t79 = state->coasting;
    const uint32_t t80 = (t79 > 0U) ? (t79 - 1U) : 0U;
    const uint32_t t81 = t12 ? t80 : 100U;
    const uint32_t t83 = t10 ? t81 : 101U;
    state->coasting = t83;
}

/* Part 2 of a step. */
static void unknown_force_network_part_2(unknown_force_network_state *state, const unknown_force_network_work *work)
{
    /* into the window */
    state->newest = work->t15;
    state->x[work->t15] = work->t72;
    state->u[work->t15] = work->t14;
    state->sin_3_t[work->t15] = work->t32;
    state->cos_3_t[work->t15] = work->t33;
    state->exp_1_5625_6_25_x_6_25_x_2[work->t15] = work->t41;
    state->exp_1_5625_6_25_x_6_25_x_2_2[work->t15] = work->t46;
    state->exp_6_25_x_2[work->t15] = work->t47;
    const uint32_t t84 = (work->t27 < 4294967295U) ? (work->t27 + 1U) : 4294967295U;
    state->calls = t84;
}

/* Part 3 of a step. */
static void unknown_force_network_part_3(const unknown_force_network_state *state, unknown_force_network_work *work)
{
    /* the responses over the window, oldest sample first */
    work->t85 = (work->t15 < 100U) ? (work->t15 + 1U) : 0U;
    work->t89 = state->x[work->t85];
    work->t90 = -0.1395834251997742 * work->t89;
    work->t91 = -9.444865444777348e-5 * work->t89;
}

/* Part 4 of a step, for one row of UNKNOWN_FORCE_NETWORK_SHOWN. */
static void unknown_force_network_part_4(const unknown_force_network_state *state, unknown_force_network_work *work, const double *gains)
{
    work->t117 = (work->t92 < 100U) ? (work->t92 + 1U) : 0U;
    const double t119 = 0.9980006665777841 * work->t93;
    const double t121 = 0.00999333466653969 * work->t94;
    const double t122 = state->u[work->t117];
    const double t123 = 4.9983335555396836e-5 * t122;
    const double t124 = t119 + t121;
    work->t125 = t124 + t123;
    const double t127 = -0.3997333866615876 * work->t93;
    const double t128 = 0.9980006665777841 * work->t94;
    const double t129 = 0.00999333466653969 * t122;
    const double t130 = t127 + t128;
    work->t131 = t130 + t129;
    const double t132 = 0.9980006665777841 * work->t95;
    const double t133 = 0.00999333466653969 * work->t96;
    const double t134 = state->exp_1_5625_6_25_x_6_25_x_2[work->t92];
    const double t136 = 0.0002665600152369665 * t134;
    const double t137 = state->exp_1_5625_6_25_x_6_25_x_2[work->t117];
    const double t138 = 0.0001333066692062081 * t137;
    const double t139 = t132 + t133;
    const double t140 = t139 + t136;
    work->t141 = t140 + t138;
    const double t142 = -0.3997333866615876 * work->t95;
    const double t143 = 0.9980006665777841 * work->t96;
    const double t145 = 0.039960008888000054 * t134;
    const double t147 = 0.03998666844431747 * t137;
    const double t148 = t142 + t143;
    const double t149 = t148 + t145;
    work->t150 = t149 + t147;
    const double t151 = 0.9980006665777841 * work->t97;
    const double t152 = 0.00999333466653969 * work->t98;
    const double t153 = state->exp_6_25_x_2[work->t92];
    const double t154 = 0.0002665600152369665 * t153;
    const double t155 = state->exp_6_25_x_2[work->t117];
    const double t156 = 0.0001333066692062081 * t155;
    const double t157 = t151 + t152;
    const double t158 = t157 + t154;
    work->t159 = t158 + t156;
    const double t160 = -0.3997333866615876 * work->t97;
    const double t161 = 0.9980006665777841 * work->t98;
    const double t162 = 0.039960008888000054 * t153;
    const double t163 = 0.03998666844431747 * t155;
    const double t164 = t160 + t161;
    const double t165 = t164 + t162;
    work->t166 = t165 + t163;
    const double t167 = 0.9980006665777841 * work->t99;
    const double t168 = 0.00999333466653969 * work->t100;
    const double t169 = state->exp_1_5625_6_25_x_6_25_x_2_2[work->t92];
    const double t170 = 0.0002665600152369665 * t169;
    const double t171 = state->exp_1_5625_6_25_x_6_25_x_2_2[work->t117];
    const double t172 = 0.0001333066692062081 * t171;
    const double t173 = t167 + t168;
    const double t174 = t173 + t170;
    work->t175 = t174 + t172;
    const double t176 = -0.3997333866615876 * work->t99;
    const double t177 = 0.9980006665777841 * work->t100;
    const double t178 = 0.039960008888000054 * t169;
    const double t179 = 0.03998666844431747 * t171;
    const double t180 = t176 + t177;
    const double t181 = t180 + t178;
    work->t182 = t181 + t179;
    const double t183 = 0.9980006665777841 * work->t101;
    const double t184 = 0.00999333466653969 * work->t102;
    const double t185 = state->sin_3_t[work->t92];
    const double t187 = 0.0003998366893428102 * t185;
    const double t188 = state->cos_3_t[work->t92];
    const double t190 = 3.999020097185029e-6 * t188;
    const double t191 = t183 + t184;
    const double t192 = t191 + t187;
    work->t193 = t192 + t190;
    const double t194 = -0.3997333866615876 * work->t101;
    const double t195 = 0.9980006665777841 * work->t102;
    const double t197 = 0.07993468027202597 * t185;
    const double t199 = 0.0011995100680284305 * t188;
    const double t200 = t194 + t195;
    const double t201 = t200 + t197;
    work->t202 = t201 + t199;
    work->t203 = gains[0];
    work->t204 = gains[1];
    const double t205 = state->x[work->t117];
    work->t206 = t205 - work->t125;
    const double t207 = work->t203 * work->t141;
    work->t208 = work->t103 + t207;
    const double t209 = work->t204 * work->t141;
    work->t210 = work->t104 + t209;
    const double t211 = work->t203 * work->t159;
    work->t212 = work->t105 + t211;
    const double t213 = work->t204 * work->t159;
    work->t214 = work->t106 + t213;
    const double t215 = work->t203 * work->t175;
    work->t216 = work->t107 + t215;
}

/* Part 5 of a step, for one row of UNKNOWN_FORCE_NETWORK_SHOWN. */
static void unknown_force_network_part_5(unknown_force_network_work *work)
{
    const double t217 = work->t204 * work->t175;
    work->t218 = work->t108 + t217;
    const double t219 = work->t203 * work->t193;
    work->t220 = work->t109 + t219;
    const double t221 = work->t204 * work->t193;
    work->t222 = work->t110 + t221;
    const double t223 = work->t203 * work->t206;
    work->t224 = work->t111 + t223;
    const double t225 = work->t204 * work->t206;
    work->t226 = work->t112 + t225;
    const double t227 = work->t141 * work->t141;
    work->t228 = work->t113 + t227;
    const double t229 = work->t159 * work->t159;
    work->t230 = work->t114 + t229;
    const double t231 = work->t175 * work->t175;
    work->t232 = work->t115 + t231;
    const double t233 = work->t193 * work->t193;
    work->t234 = work->t116 + t233;
}

/* Part 6 of a step. */
static void unknown_force_network_part_6(const unknown_force_network_state *state, unknown_force_network_work *work)
{
    work->t92 = work->t85;
    work->t93 = 0.0;
    work->t94 = 0.0;
    work->t95 = 0.0;
    work->t96 = 0.0;
    work->t97 = 0.0;
    work->t98 = 0.0;
    work->t99 = 0.0;
    work->t100 = 0.0;
    work->t101 = 0.0;
    work->t102 = 0.0;
    work->t103 = 0.0;
    work->t104 = 0.0;
    work->t105 = 0.0;
    work->t106 = 0.0;
    work->t107 = 0.0;
    work->t108 = 0.0;
    work->t109 = 0.0;
    work->t110 = 0.0;
    work->t111 = work->t90;
    work->t112 = work->t91;
    work->t113 = 0.0;
    work->t114 = 0.0;
    work->t115 = 0.0;
    work->t116 = 0.0;
    for (uint32_t row = 0U; row < 100U; ++row) {
        const double *const gains = UNKNOWN_FORCE_NETWORK_SHOWN[row];
        unknown_force_network_part_4(state, work, gains);
        unknown_force_network_part_5(work);
        work->t92 = work->t117;
        work->t93 = work->t125;
        work->t94 = work->t131;
        work->t95 = work->t141;
        work->t96 = work->t150;
        work->t97 = work->t159;
        work->t98 = work->t166;
        work->t99 = work->t175;
        work->t100 = work->t182;
        work->t101 = work->t193;
        work->t102 = work->t202;
        work->t103 = work->t208;
        work->t104 = work->t210;
        work->t105 = work->t212;
        work->t106 = work->t214;
        work->t107 = work->t216;
        work->t108 = work->t218;
        work->t109 = work->t220;
        work->t110 = work->t222;
        work->t111 = work->t224;
        work->t112 = work->t226;
        work->t113 = work->t228;
        work->t114 = work->t230;
        work->t115 = work->t232;
        work->t116 = work->t234;
    }
}

/* Part 7 of a step. */
static void unknown_force_network_part_7(unknown_force_network_work *work)
{
    const double t235 = -0.1395834251997742 * work->t103;
    const double t236 = -9.444865444777348e-5 * work->t104;
    const double t237 = t235 + t236;
    const double t238 = 0.0 - t237;
    const double t239 = -0.1395834251997742 * work->t105;
    const double t240 = -9.444865444777348e-5 * work->t106;
    const double t241 = t239 + t240;
    const double t242 = 0.0 - t241;
    const double t243 = -0.1395834251997742 * work->t107;
    const double t244 = -9.444865444777348e-5 * work->t108;
    const double t245 = t243 + t244;
    const double t246 = 0.0 - t245;
    const double t247 = -0.1395834251997742 * work->t109;
    const double t248 = -9.444865444777348e-5 * work->t110;
    const double t249 = t247 + t248;
    const double t250 = 0.0 - t249;
    const double t251 = -0.1395834251997742 * work->t111;
    const double t252 = -9.444865444777348e-5 * work->t112;
    const double t253 = t251 + t252;
    const double t254 = work->t89 - t253;
    const double t255 = t238 * t238;
    work->t256 = 0.0 + t255;
    const double t257 = t242 * t238;
    work->t258 = 0.0 + t257;
    const double t259 = t242 * t242;
    work->t260 = 0.0 + t259;
    const double t261 = t246 * t238;
    work->t262 = 0.0 + t261;
    const double t263 = t246 * t242;
    work->t264 = 0.0 + t263;
    const double t265 = t246 * t246;
    work->t266 = 0.0 + t265;
    const double t267 = t250 * t238;
    work->t268 = 0.0 + t267;
    const double t269 = t250 * t242;
    work->t270 = 0.0 + t269;
    const double t271 = t250 * t246;
    work->t272 = 0.0 + t271;
    const double t273 = t250 * t250;
    work->t274 = 0.0 + t273;
    const double t275 = t238 * t254;
    work->t276 = 0.0 + t275;
    const double t277 = t242 * t254;
    work->t278 = 0.0 + t277;
    const double t279 = t246 * t254;
    work->t280 = 0.0 + t279;
    const double t281 = t250 * t254;
    work->t282 = 0.0 + t281;
}

/* Part 8 of a step, for one row of UNKNOWN_FORCE_NETWORK_SHOWN. */
static void unknown_force_network_part_8(const unknown_force_network_state *state, unknown_force_network_work *work, const double *gains)
{
    work->t308 = (work->t283 < 100U) ? (work->t283 + 1U) : 0U;
    const double t310 = 0.9980006665777841 * work->t284;
    const double t312 = 0.00999333466653969 * work->t285;
    const double t313 = state->u[work->t308];
    const double t314 = 4.9983335555396836e-5 * t313;
    const double t315 = t310 + t312;
    work->t316 = t315 + t314;
    const double t318 = -0.3997333866615876 * work->t284;
    const double t319 = 0.9980006665777841 * work->t285;
    const double t320 = 0.00999333466653969 * t313;
    const double t321 = t318 + t319;
    work->t322 = t321 + t320;
    const double t323 = 0.9980006665777841 * work->t286;
    const double t324 = 0.00999333466653969 * work->t287;
    const double t325 = state->exp_1_5625_6_25_x_6_25_x_2[work->t283];
    const double t327 = 0.0002665600152369665 * t325;
    const double t328 = state->exp_1_5625_6_25_x_6_25_x_2[work->t308];
    const double t329 = 0.0001333066692062081 * t328;
    const double t330 = t323 + t324;
    const double t331 = t330 + t327;
    work->t332 = t331 + t329;
    const double t333 = -0.3997333866615876 * work->t286;
    const double t334 = 0.9980006665777841 * work->t287;
    const double t336 = 0.039960008888000054 * t325;
    const double t338 = 0.03998666844431747 * t328;
    const double t339 = t333 + t334;
    const double t340 = t339 + t336;
    work->t341 = t340 + t338;
    const double t342 = 0.9980006665777841 * work->t288;
    const double t343 = 0.00999333466653969 * work->t289;
    const double t344 = state->exp_6_25_x_2[work->t283];
    const double t345 = 0.0002665600152369665 * t344;
    const double t346 = state->exp_6_25_x_2[work->t308];
    const double t347 = 0.0001333066692062081 * t346;
    const double t348 = t342 + t343;
    const double t349 = t348 + t345;
    work->t350 = t349 + t347;
    const double t351 = -0.3997333866615876 * work->t288;
    const double t352 = 0.9980006665777841 * work->t289;
    const double t353 = 0.039960008888000054 * t344;
    const double t354 = 0.03998666844431747 * t346;
    const double t355 = t351 + t352;
    const double t356 = t355 + t353;
    work->t357 = t356 + t354;
    const double t358 = 0.9980006665777841 * work->t290;
    const double t359 = 0.00999333466653969 * work->t291;
    const double t360 = state->exp_1_5625_6_25_x_6_25_x_2_2[work->t283];
    const double t361 = 0.0002665600152369665 * t360;
    const double t362 = state->exp_1_5625_6_25_x_6_25_x_2_2[work->t308];
    const double t363 = 0.0001333066692062081 * t362;
    const double t364 = t358 + t359;
    const double t365 = t364 + t361;
    work->t366 = t365 + t363;
    const double t367 = -0.3997333866615876 * work->t290;
    const double t368 = 0.9980006665777841 * work->t291;
    const double t369 = 0.039960008888000054 * t360;
    const double t370 = 0.03998666844431747 * t362;
    const double t371 = t367 + t368;
    const double t372 = t371 + t369;
    work->t373 = t372 + t370;
    const double t374 = 0.9980006665777841 * work->t292;
    const double t375 = 0.00999333466653969 * work->t293;
    const double t376 = state->sin_3_t[work->t283];
    const double t378 = 0.0003998366893428102 * t376;
    const double t379 = state->cos_3_t[work->t283];
    const double t381 = 3.999020097185029e-6 * t379;
    const double t382 = t374 + t375;
    const double t383 = t382 + t378;
    work->t384 = t383 + t381;
    const double t385 = -0.3997333866615876 * work->t292;
    const double t386 = 0.9980006665777841 * work->t293;
    const double t388 = 0.07993468027202597 * t376;
    const double t390 = 0.0011995100680284305 * t379;
    const double t391 = t385 + t386;
    const double t392 = t391 + t388;
    work->t393 = t392 + t390;
    work->t394 = gains[0];
    work->t395 = gains[1];
    const double t396 = state->x[work->t308];
    work->t397 = t396 - work->t316;
    const double t398 = work->t394 * work->t103;
    const double t399 = work->t395 * work->t104;
    const double t400 = t398 + t399;
    work->t401 = work->t332 - t400;
    const double t402 = work->t394 * work->t105;
    const double t403 = work->t395 * work->t106;
    const double t404 = t402 + t403;
    work->t405 = work->t350 - t404;
    work->t406 = work->t394 * work->t107;
    work->t407 = work->t395 * work->t108;
}

/* Part 9 of a step, for one row of UNKNOWN_FORCE_NETWORK_SHOWN. */
static void unknown_force_network_part_9(unknown_force_network_work *work)
{
    const double t408 = work->t406 + work->t407;
    const double t409 = work->t366 - t408;
    const double t410 = work->t394 * work->t109;
    const double t411 = work->t395 * work->t110;
    const double t412 = t410 + t411;
    const double t413 = work->t384 - t412;
    const double t414 = work->t394 * work->t111;
    const double t415 = work->t395 * work->t112;
    const double t416 = t414 + t415;
    const double t417 = work->t397 - t416;
    const double t418 = work->t401 * work->t401;
    work->t419 = work->t294 + t418;
    const double t420 = work->t405 * work->t401;
    work->t421 = work->t295 + t420;
    const double t422 = work->t405 * work->t405;
    work->t423 = work->t296 + t422;
    const double t424 = t409 * work->t401;
    work->t425 = work->t297 + t424;
    const double t426 = t409 * work->t405;
    work->t427 = work->t298 + t426;
    const double t428 = t409 * t409;
    work->t429 = work->t299 + t428;
    const double t430 = t413 * work->t401;
    work->t431 = work->t300 + t430;
    const double t432 = t413 * work->t405;
    work->t433 = work->t301 + t432;
    const double t434 = t413 * t409;
    work->t435 = work->t302 + t434;
    const double t436 = t413 * t413;
    work->t437 = work->t303 + t436;
    const double t438 = work->t401 * t417;
    work->t439 = work->t304 + t438;
    const double t440 = work->t405 * t417;
    work->t441 = work->t305 + t440;
    const double t442 = t409 * t417;
    work->t443 = work->t306 + t442;
    const double t444 = t413 * t417;
    work->t445 = work->t307 + t444;
}

/* Part 10 of a step. */
static void unknown_force_network_part_10(const unknown_force_network_state *state, unknown_force_network_work *work)
{
    work->t283 = work->t85;
    work->t284 = 0.0;
    work->t285 = 0.0;
    work->t286 = 0.0;
    work->t287 = 0.0;
    work->t288 = 0.0;
    work->t289 = 0.0;
    work->t290 = 0.0;
    work->t291 = 0.0;
    work->t292 = 0.0;
    work->t293 = 0.0;
    work->t294 = work->t256;
    work->t295 = work->t258;
    work->t296 = work->t260;
    work->t297 = work->t262;
    work->t298 = work->t264;
    work->t299 = work->t266;
    work->t300 = work->t268;
    work->t301 = work->t270;
    work->t302 = work->t272;
    work->t303 = work->t274;
    work->t304 = work->t276;
    work->t305 = work->t278;
    work->t306 = work->t280;
    work->t307 = work->t282;
    for (uint32_t row = 0U; row < 100U; ++row) {
        const double *const gains = UNKNOWN_FORCE_NETWORK_SHOWN[row];
        unknown_force_network_part_8(state, work, gains);
        unknown_force_network_part_9(work);
        work->t283 = work->t308;
        work->t284 = work->t316;
        work->t285 = work->t322;
        work->t286 = work->t332;
        work->t287 = work->t341;
        work->t288 = work->t350;
        work->t289 = work->t357;
        work->t290 = work->t366;
        work->t291 = work->t373;
        work->t292 = work->t384;
        work->t293 = work->t393;
        work->t294 = work->t419;
        work->t295 = work->t421;
        work->t296 = work->t423;
        work->t297 = work->t425;
        work->t298 = work->t427;
        work->t299 = work->t429;
        work->t300 = work->t431;
        work->t301 = work->t433;
        work->t302 = work->t435;
        work->t303 = work->t437;
        work->t304 = work->t439;
        work->t305 = work->t441;
        work->t306 = work->t443;
        work->t307 = work->t445;
    }
}

/* Part 11 of a step. */
static void unknown_force_network_part_11(unknown_force_network_work *work)
{
    /* the unknowns, where the signals excite them */
    const double t448 = 1e-12 * work->t113;
    const int t449 = t448 < work->t294;
    const int t450 = 1.0020841800044864e-292 < work->t294;
    const int t451 = 0.0 <= work->t113;
    const int t452 = t449 && t450;
    const int t453 = t452 && t451;
    const double t454 = t453 ? work->t294 : 1.0;
    const double t455 = work->t295 / t454;
    const double t456 = work->t295 * t455;
    const double t457 = work->t296 - t456;
    const double t458 = 1e-12 * work->t114;
    const int t459 = t458 < t457;
    const int t460 = 1.0020841800044864e-292 < t457;
    const int t461 = 0.0 <= work->t114;
    const int t462 = t459 && t460;
    const int t463 = t462 && t461;
    const int t464 = t453 && t463;
    const double t465 = t463 ? t457 : 1.0;
    const double t466 = work->t297 / t454;
    const double t467 = work->t297 * t455;
    const double t468 = work->t298 - t467;
    const double t469 = t468 / t465;
    const double t470 = work->t297 * t466;
    const double t471 = t468 * t469;
    const double t472 = t470 + t471;
    const double t473 = work->t299 - t472;
    const double t474 = 1e-12 * work->t115;
    const int t475 = t474 < t473;
    const int t476 = 1.0020841800044864e-292 < t473;
    const int t477 = 0.0 <= work->t115;
    const int t478 = t475 && t476;
    const int t479 = t478 && t477;
    const int t480 = t464 && t479;
    const double t481 = t479 ? t473 : 1.0;
    const double t482 = work->t300 / t454;
    const double t483 = work->t300 * t455;
    const double t484 = work->t301 - t483;
    const double t485 = t484 / t465;
    const double t486 = work->t300 * t466;
    const double t487 = t484 * t469;
    const double t488 = t486 + t487;
    const double t489 = work->t302 - t488;
    const double t490 = t489 / t481;
    const double t491 = work->t300 * t482;
    const double t492 = t484 * t485;
    const double t493 = t489 * t490;
    const double t494 = t491 + t492;
    const double t495 = t494 + t493;
    const double t496 = work->t303 - t495;
    const double t497 = 1e-12 * work->t116;
    const int t498 = t497 < t496;
    const int t499 = 1.0020841800044864e-292 < t496;
    const int t500 = 0.0 <= work->t116;
    const int t501 = t498 && t499;
    const int t502 = t501 && t500;
    const int t503 = t480 && t502;
    const double t504 = t502 ? t496 : 1.0;
    const double t505 = work->t304 * t455;
    const double t506 = work->t305 - t505;
    const double t507 = work->t304 * t466;
    const double t508 = t506 * t469;
    const double t509 = t507 + t508;
    const double t510 = work->t306 - t509;
    const double t511 = work->t304 * t482;
    const double t512 = t506 * t485;
    const double t513 = t510 * t490;
    const double t514 = t511 + t512;
    const double t515 = t514 + t513;
    const double t516 = work->t307 - t515;
    work->t517 = t516 / t504;
    const double t518 = t510 / t481;
    const double t519 = work->t517 * t490;
    work->t520 = t518 - t519;
    const double t521 = t506 / t465;
    const double t522 = work->t517 * t485;
    const double t523 = work->t520 * t469;
    const double t524 = t522 + t523;
    work->t525 = t521 - t524;
    const double t526 = work->t304 / t454;
    const double t527 = work->t517 * t482;
    const double t528 = work->t520 * t466;
    const double t529 = work->t525 * t455;
    const double t530 = t527 + t528;
    const double t531 = t530 + t529;
    work->t532 = t526 - t531;
    const int t533 = (-1e152 <= work->t532) && (work->t532 <= 1e152);
    work->flags[1] = t503 && t533;
}

/* Part 12 of a step. */
static void unknown_force_network_part_12(unknown_force_network_state *state, unknown_force_network_work *work)
{
    const int t535 = (-1e152 <= work->t525) && (work->t525 <= 1e152);
    const int t536 = work->flags[1] && t535;
    const int t537 = (-1e152 <= work->t520) && (work->t520 <= 1e152);
    const int t538 = t536 && t537;
    const int t539 = (-1e152 <= work->t517) && (work->t517 <= 1e152);
    const int t540 = t538 && t539;
    const int t541 = 100U < work->t78;
    work->flags[2] = t541 && t540;
    const int t543 = work->flags[2] || work->flags[0];
    work->flags[3] = t541 && t543;
    const uint32_t t545 = (work->t5 < 1U) ? (work->t5 + 1U) : 1U;
    const uint32_t t546 = work->flags[3] ? t545 : 0U;
    state->found = t546;
    const double t547 = work->flags[2] ? work->t532 : work->t51;
    state->found_left = t547;
    const double t548 = work->flags[2] ? work->t525 : work->t63;
    state->found_middle = t548;
    const double t549 = work->flags[2] ? work->t520 : work->t57;
    state->found_right = t549;
    const double t550 = state->found_shake;
    const double t551 = work->flags[2] ? work->t517 : t550;
    state->found_shake = t551;

    /* the estimate; until the unknowns have been found, the start */
    const double t552 = t547 * work->t103;
    const double t553 = t548 * work->t105;
    const double t554 = t549 * work->t107;
    const double t555 = t551 * work->t109;
    const double t556 = t552 + t553;
    const double t557 = t556 + t554;
    const double t558 = t557 + t555;
    const double t559 = work->t111 - t558;
    const double t560 = t547 * work->t104;
    const double t561 = t548 * work->t106;
    const double t562 = t549 * work->t108;
    const double t563 = t551 * work->t110;
    const double t564 = t560 + t561;
    const double t565 = t564 + t562;
    const double t566 = t565 + t563;
    const double t567 = work->t112 - t566;
    const double t569 = -0.13946399525480563 * t559;
    const double t571 = 0.005773693671891355 * t567;
    const double t572 = t547 * work->t95;
    const double t573 = t548 * work->t97;
    const double t574 = t549 * work->t99;
    const double t575 = t551 * work->t101;
    const double t576 = work->t93 + t569;
    const double t577 = t576 + t571;
    const double t578 = t572 + t573;
    const double t579 = t578 + t574;
    const double t580 = t579 + t575;
    work->t581 = t577 + t580;
    const double t583 = 0.03651115887972404 * t559;
    const double t585 = 0.8966090134237592 * t567;
    const double t586 = t547 * work->t96;
    const double t587 = t548 * work->t98;
    const double t588 = t549 * work->t100;
    const double t589 = t551 * work->t102;
    const double t590 = work->t94 + t583;
    const double t591 = t590 + t585;
    const double t592 = t586 + t587;
    const double t593 = t592 + t588;
    const double t594 = t593 + t589;
    work->t595 = t591 + t594;
    work->t597 = 8.0 * t547;
    work->t598 = 8.0 * t548;
    work->t599 = 8.0 * t549;
    work->t600 = 8.0 * t551;
}

/* Part 13 of a step. */
static void unknown_force_network_part_13(unknown_force_network_state *state, unknown_force_network_work *work)
{
    /* the next measurement, as far as it is known */
    const double t602 = 0.9980006665777841 * work->t581;
    const double t604 = 0.00999333466653969 * work->t595;
    const double t606 = state->found_shake;
    const double t607 = 0.0003998366893428102 * t606;
    const double t608 = t607 * work->t32;
    const double t610 = 3.999020097185029e-6 * t606;
    const double t611 = t610 * work->t33;
    const double t613 = state->found_left;
    const double t614 = 0.0003998666844431747 * t613;
    const double t615 = t614 * work->t41;
    const double t616 = state->found_right;
    const double t617 = 0.0003998666844431747 * t616;
    const double t618 = t617 * work->t46;
    const double t619 = state->found_middle;
    const double t620 = 0.0003998666844431747 * t619;
    const double t621 = t620 * work->t47;
    const double t622 = t602 + t604;
    const double t623 = t622 + t608;
    const double t624 = t611 + t615;
    const double t625 = t624 + t618;
    const double t626 = t625 + t621;
    const double t627 = t623 + t626;
    state->ahead_x = t627;
    work->t628 = work->flags[3] ? work->t581 : work->t72;
    work->t629 = work->flags[3] ? work->t595 : 0.0;
    work->t630 = work->flags[3] ? work->t597 : 0.0;
    work->t631 = work->flags[3] ? work->t598 : 0.0;
    work->t632 = work->flags[3] ? work->t599 : 0.0;
    work->t633 = work->flags[3] ? work->t600 : 0.0;
    const uint32_t t634 = state->coasting;
    const int t635 = t634 == 0U;
    const unknown_force_network_status t639 = t635 ? UNKNOWN_FORCE_NETWORK_CONVERGED : UNKNOWN_FORCE_NETWORK_COASTING;
    work->t640 = work->flags[2] ? t639 : UNKNOWN_FORCE_NETWORK_CONVERGING;
}

void unknown_force_network_init(unknown_force_network_state *state)
{
    for (uint32_t slot = 0U; slot < 101U; ++slot) {
        state->x[slot] = 0.0;
    }
    for (uint32_t slot = 0U; slot < 101U; ++slot) {
        state->u[slot] = 0.0;
    }
    for (uint32_t slot = 0U; slot < 101U; ++slot) {
        state->sin_3_t[slot] = 0.0;
    }
    for (uint32_t slot = 0U; slot < 101U; ++slot) {
        state->cos_3_t[slot] = 0.0;
    }
    for (uint32_t slot = 0U; slot < 101U; ++slot) {
        state->exp_1_5625_6_25_x_6_25_x_2[slot] = 0.0;
    }
    for (uint32_t slot = 0U; slot < 101U; ++slot) {
        state->exp_1_5625_6_25_x_6_25_x_2_2[slot] = 0.0;
    }
    for (uint32_t slot = 0U; slot < 101U; ++slot) {
        state->exp_6_25_x_2[slot] = 0.0;
    }
    state->newest = 100U;
    state->count = 0U;
    state->coasting = 0U;
    state->ahead_x = 0.0;
    state->calls = 0U;
    state->found = 0U;
    state->found_left = 0.0;
    state->found_middle = 0.0;
    state->found_right = 0.0;
    state->found_shake = 0.0;
}

void unknown_force_network_step(unknown_force_network_state *state, const unknown_force_network_measurements *measurements,
                                const unknown_force_network_inputs *inputs, unknown_force_network_estimate *estimate)
{
    unknown_force_network_work work;
    unknown_force_network_part_1(state, measurements, inputs, &work);
    unknown_force_network_part_2(state, &work);
    unknown_force_network_part_3(state, &work);
    unknown_force_network_part_6(state, &work);
    unknown_force_network_part_7(&work);
    unknown_force_network_part_10(state, &work);
    unknown_force_network_part_11(&work);
    unknown_force_network_part_12(state, &work);
    unknown_force_network_part_13(state, &work);

    estimate->x = work.t628;
    estimate->v = work.t629;
    estimate->left = work.t630;
    estimate->middle = work.t631;
    estimate->right = work.t632;
    estimate->shake = work.t633;
    estimate->status = work.t640;
}
