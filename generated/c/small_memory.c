/* small_memory.c: Finite-time observer: Speed and load of a drive from its encoder, without storing any samples.
 *
 * Generated; small_memory.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "small_memory.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "small_memory.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "small_memory.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* both copies, by calls since they took turns
 *   [0] filling component 0 from angle
 *   [1] filling component 1 from angle
 *   [2] filling component 2 from angle
 *   [3] used component 0 from angle
 *   [4] used component 1 from angle
 *   [5] used component 2 from angle
 *   [6] angle from component 0
 *   [7] angle from component 1
 *   [8] angle from component 2
 *   [9] speed from component 0
 *   [10] speed from component 1
 *   [11] speed from component 2
 *   [12] load from component 0
 *   [13] load from component 1
 *   [14] load from component 2
 */
static const float SMALL_MEMORY_AGES[40][15] = {
    {
        0.125f, -0.3038047f, -0.2626495f, 0.125f, 0.0067844503f, 0.13628846f, 3.1780922f,
        2.4792829f, -1.5838541f, 400.1729f, 331.5651f, -241.12634f, -18913.162f, -15642.395f,
        12175.183f
    },
    {
        0.125f, -0.2958107f, -0.24230279f, 0.125f, 0.014312918f, 0.13557257f, 2.8917975f,
        2.2719104f, -1.4758658f, 352.01633f, 294.48853f, -219.01443f, -16202.354f, -13512.677f,
        10791.687f
    },
    {
        0.125f, -0.28782868f, -0.2224982f, 0.125f, 0.021830102f, 0.13434613f, 2.6345763f,
        2.0846615f, -1.3774766f, 310.1257f, 262.00955f, -199.37833f, -13909.071f, -11698.07f,
        9592.654f
    },
    {
        0.125f, -0.27985862f, -0.2032349f, 0.125f, 0.02933602f, 0.1326099f, 2.4030204f, 1.9152386f,
        -1.2876427f, 273.59683f, 233.48523f, -181.89278f, -11963.278f, -10147.249f, 8550.015f
    },
    {
        0.125f, -0.2719005f, -0.1845121f, 0.125f, 0.036830686f, 0.13036469f, 2.1941788f, 1.7616475f,
        -1.2054543f, 241.67004f, 208.37318f, -166.28131f, -10307.727f, -8818.051f, 7640.4746f
    },
    {
        0.125f, -0.26395434f, -0.16632897f, 0.125f, 0.04431412f, 0.1276112f, 2.0054872f, 1.6221507f,
        -1.130115f, 213.7048f, 186.21422f, -152.30804f, -8895.423f, -7675.6997f, 6844.6255f
    },
    {
        0.125f, -0.25602007f, -0.14868471f, 0.125f, 0.051786337f, 0.12435023f, 1.8347129f,
        1.4952308f, -1.0609257f, 189.15923f, 166.61823f, -139.77101f, -7687.6436f, -6691.399f,
        6146.2246f
    },
    {
        0.125f, -0.24809767f, -0.1315785f, 0.125f, 0.059247352f, 0.12058253f, 1.6799048f,
        1.3795593f, -0.99727166f, 167.57336f, 149.25266f, -128.49672f, -6652.359f, -5841.21f,
        5531.6304f
    },
    {
        0.125f, -0.24018717f, -0.115009576f, 0.125f, 0.06669719f, 0.11630886f, 1.5393547f,
        1.2739689f, -0.93860996f, 148.55559f, 133.83318f, -118.33562f, -5762.982f, -5105.1626f,
        4989.34f
    },
    {
        0.125f, -0.23228852f, -0.09897709f, 0.125f, 0.074135855f, 0.11152998f, 1.4115624f,
        1.1774325f, -0.8844607f, 131.77142f, 120.115906f, -109.15842f, -4997.3687f, -4466.538f,
        4509.6196f
    },
    {
        0.125f, -0.22440171f, -0.08348025f, 0.125f, 0.08156337f, 0.10624665f, 1.2952079f,
        1.0890431f, -0.83439815f, 116.93446f, 107.89108f, -100.853035f, -4337.013f, -3911.2947f,
        4084.2058f
    },
    {
        0.125f, -0.21652673f, -0.06851825f, 0.125f, 0.08897975f, 0.10045962f, 1.1891265f, 1.007999f,
        -0.7880439f, 103.79871f, 96.97774f, -93.321976f, -3766.405f, -3427.6016f, 3706.0588f
    },
    {
        0.125f, -0.20866354f, -0.0540903f, 0.125f, 0.096385024f, 0.094169654f, 1.0922884f,
        0.9335886f, -0.74506086f, 92.15237f, 87.21939f, -86.48024f, -3272.503f, -3005.459f,
        3369.1633f
    },
    {
        0.125f, -0.20081215f, -0.040195584f, 0.125f, 0.10377919f, 0.087377496f, 1.0037814f,
        0.86518043f, -0.70514804f, 81.812614f, 78.48034f, -80.25351f, -2844.312f, -2636.392f,
        3068.3628f
    },
    {
        0.125f, -0.19297251f, -0.026833316f, 0.125f, 0.111162275f, 0.0800839f, 0.92279565f,
        0.8022119f, -0.66803604f, 72.621254f, 70.64264f, -74.57666f, -2472.5361f, -2313.197f,
        2799.2246f
    },
    {
        0.125f, -0.18514463f, -0.014002692f, 0.125f, 0.1185343f, 0.07228962f, 0.8486103f,
        0.74418104f, -0.6334835f, 64.44109f, 63.603508f, -69.392456f, -2149.2961f, -2029.7346f,
        2557.9272f
    },
    {
        0.125f, -0.17732848f, -0.0017029151f, 0.125f, 0.12589526f, 0.063995406f, 0.7805832f,
        0.69063926f, -0.60127354f, 57.152878f, 57.273216f, -64.6505f, -1867.8955f, -1780.7589f,
        2341.168f
    },
    {
        0.125f, -0.16952406f, 0.01006681f, 0.125f, 0.1332452f, 0.05520201f, 0.71814084f,
        0.64118487f, -0.57121086f, 50.652733f, 51.573208f, -60.306305f, -1622.6307f, -1561.7767f,
        2146.084f
    },
    {
        0.125f, -0.16173133f, 0.021307277f, 0.125f, 0.14058413f, 0.04591018f, 0.66077024f,
        0.5954575f, -0.5431195f, 44.849995f, 46.43461f, -56.32052f, -1408.6318f, -1368.9302f,
        1970.1877f
    },
    {
        0.125f, -0.15395027f, 0.03201928f, 0.125f, 0.14791204f, 0.036120657f, 0.6080117f,
        0.55313313f, -0.5168404f, 39.665367f, 41.79687f, -52.65825f, -1221.7317f, -1198.8994f,
        1811.3131f
    },
    {
        0.125f, -0.14618088f, 0.042203613f, 0.125f, 0.15522897f, 0.025834193f, 0.5594527f,
        0.51392025f, -0.49222988f, 35.029366f, 37.60669f, -49.288513f, -1058.3566f, -1048.821f,
        1667.569f
    },
    {
        0.125f, -0.13842314f, 0.051861063f, 0.125f, 0.16253494f, 0.015051531f, 0.51472235f,
        0.47755593f, -0.4691575f, 30.880999f, 33.817043f, -46.183727f, -915.4361f, -916.2204f,
        1537.3003f
    },
    {
        0.125f, -0.13067701f, 0.06099242f, 0.125f, 0.16982996f, 0.0037734143f, 0.4734866f,
        0.44380283f, -0.4475049f, 27.166632f, 30.386368f, -43.319298f, -790.3266f, -798.9542f,
        1419.0559f
    },
    {
        0.125f, -0.122942515f, 0.06959847f, 0.125f, 0.17711404f, -0.007999414f, 0.43544447f,
        0.41244617f, -0.42716458f, 23.839018f, 27.277859f, -40.67325f, -680.7477f, -695.1628f,
        1311.5605f
    },
    {
        0.125f, -0.1152196f, 0.077680014f, 0.125f, 0.1843872f, -0.020266213f, 0.40032405f,
        0.38329148f, -0.40803862f, 20.85647f, 24.458881f, -38.22591f, -584.72876f, -603.22925f,
        1213.6913f
    },
    {
        0.125f, -0.107508264f, 0.08523782f, 0.125f, 0.19164948f, -0.03302624f, 0.36787948f,
        0.35616234f, -0.3900377f, 18.182154f, 21.900446f, -35.95966f, -500.56406f, -521.74524f,
        1124.4572f
    },
    {
        0.125f, -0.099808484f, 0.09227269f, 0.125f, 0.19890085f, -0.04627876f, 0.33788815f,
        0.33089852f, -0.37308028f, 15.783464f, 19.576752f, -33.85866f, -426.7745f, -449.4821f,
        1042.9822f
    },
    {
        0.125f, -0.092120245f, 0.09878539f, 0.125f, 0.20614137f, -0.060023032f, 0.31014827f,
        0.3073543f, -0.35709187f, 13.631505f, 17.464811f, -31.908672f, -362.07553f, -385.36594f,
        968.4905f
    },
    {
        0.125f, -0.08444353f, 0.104776725f, 0.125f, 0.21337102f, -0.07425832f, 0.28447658f,
        0.285397f, -0.34200418f, 11.700629f, 15.54411f, -30.09686f, -305.3498f, -328.4567f,
        900.2935f
    },
    {
        0.125f, -0.07677832f, 0.110247456f, 0.125f, 0.22058985f, -0.088983886f, 0.2607066f,
        0.26490554f, -0.3277547f, 9.96804f, 13.796313f, -28.411652f, -255.62405f, -277.93005f,
        837.77936f
    },
    {
        0.125f, -0.06912461f, 0.11519837f, 0.125f, 0.22779784f, -0.10419899f, 0.2386868f,
        0.24576953f, -0.31428602f, 8.413452f, 12.20501f, -26.842583f, -212.04924f, -233.06221f,
        780.40314f
    },
    {
        0.125f, -0.06148236f, 0.11963025f, 0.125f, 0.23499504f, -0.119902916f, 0.21827911f,
        0.22788793f, -0.30154535f, 7.018788f, 10.755493f, -25.380186f, -173.88374f, -193.21663f,
        727.6788f
    },
    {
        0.125f, -0.053851567f, 0.123543866f, 0.125f, 0.24218145f, -0.13609491f, 0.19935764f,
        0.2111684f, -0.28948417f, 5.767921f, 9.4345665f, -24.015884f, -140.47891f, -157.83276f,
        679.1721f
    },
    {
        0.125f, -0.046232212f, 0.12694f, 0.125f, 0.24935709f, -0.15277426f, 0.18180744f,
        0.19552626f, -0.27805778f, 4.6464458f, 8.230372f, -22.741892f, -111.26671f, -126.416275f,
        634.49475f
    },
    {
        0.125f, -0.03862428f, 0.12981944f, 0.125f, 0.25652197f, -0.16994022f, 0.16552345f,
        0.18088391f, -0.267225f, 3.641482f, 7.132244f, -21.551134f, -85.7491f, -98.530655f,
        593.2985f
    },
    {
        0.125f, -0.03102775f, 0.13218293f, 0.125f, 0.2636761f, -0.18759206f, 0.15040953f,
        0.16717009f, -0.2569477f, 2.7414997f, 6.1305737f, -20.437174f, -63.488956f, -73.79f,
        555.27106f
    },
    {
        0.125f, -0.023442606f, 0.13403127f, 0.125f, 0.27081954f, -0.20572907f, 0.13637768f,
        0.15431933f, -0.24719077f, 1.9361659f, 5.2166996f, -19.394148f, -44.102146f, -51.85269f,
        520.1316f
    },
    {
        0.125f, -0.01586883f, 0.13536522f, 0.125f, 0.27795225f, -0.22435051f, 0.123347156f,
        0.14227137f, -0.23792168f, 1.2162122f, 4.3828f, -18.416712f, -27.250814f, -32.415985f,
        487.62738f
    },
    {
        0.125f, -0.008306407f, 0.13618556f, 0.125f, 0.28507426f, -0.24345565f, 0.11124393f,
        0.13097076f, -0.22911032f, 0.5733166f, 3.62181f, -17.499977f, -12.637483f, -15.21128f,
        457.5308f
    },
    {
        0.125f, -0.00075531955f, 0.13649304f, 0.125f, 0.2921856f, -0.26304376f, 0.1f, 0.12036638f,
        -0.22072877f, 0.0f, 2.9273353f, -16.639484f, 0.0f, 0.0f, 429.63623f
    }
};

/* What one part of a step hands to the next. */
typedef struct {
    float t8;
    float t11;
    float t17;
    uint32_t t26;
    uint32_t t31;
    float t47;
    float t49;
    float t51;
    float t53;
    float t55;
    uint32_t t57;
    float t58;
    float t59;
    float t60;
    float t61;
    float t62;
    uint32_t t63;
    uint32_t t107;
    float t128;
    float t131;
    float t133;
    float t140;
    float t141;
    float t142;
    small_memory_status t148;
    int flags[4]; /* t4, t6, t28, t32 */
} small_memory_work;

/* Part 1 of a step. */
static void small_memory_part_1(small_memory_state *state, const small_memory_measurements *measurements, const small_memory_inputs *inputs, small_memory_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    const uint32_t t0 = state->count;
    const int t2 = 40U < t0;
    const float t3 = measurements->angle;
    work->flags[0] = (-1e31f <= t3) && (t3 <= 1e31f);
    const float t5 = inputs->torque;
    work->flags[1] = (-1e31f <= t5) && (t5 <= 1e31f);
    const float t7 = state->torque;
    work->t8 = work->flags[1] ? t5 : t7;

    /* prediction, for a sample that is missing */
    const float t9 = state->ahead_angle;
    work->t11 = 0.00024987504f * work->t8;
    const float t12 = t9 + work->t11;
    const float t13 = state->angle;
    const int t14 = (-1e31f <= t12) && (t12 <= 1e31f);
    const int t15 = t2 && t14;
    const float t16 = t15 ? t12 : t13;
    work->t17 = work->flags[0] ? t3 : t16;
    const int t18 = work->flags[0] || t15;
    const int t19 = !t18;

    /* how much of the window is good */
    const uint32_t t22 = (t0 < 41U) ? (t0 + 1U) : 41U;
    const uint32_t t23 = t19 ? 0U : t22;
    const uint32_t t24 = work->flags[1] ? t22 : 1U;
    const uint32_t t25 = work->flags[0] ? t24 : 0U;
    work->t26 = t2 ? t23 : t25;
    state->count = work->t26;

    /* into the window */
    state->angle = work->t17;
    state->torque = work->t8;

    /* two copies, restarted by turns; both with the first sample of a window */
    work->flags[2] = work->t26 < 2U;
    const uint32_t t29 = state->age;
    const uint32_t t30 = (t29 < 39U) ? (t29 + 1U) : 0U;
    work->t31 = work->flags[2] ? 0U : t30;
    state->age = work->t31;
    work->flags[3] = work->t31 == 0U;
    const float t33 = state->used_angle;
    const float t34 = state->used_speed;
    const float t35 = state->used_statistic;
    const float t36 = state->used_statistic_2;
    const float t37 = state->used_statistic_3;
    const uint32_t t38 = state->used_replaced;
    const float t39 = state->filling_angle;
    const float t40 = state->filling_speed;
    const float t41 = state->filling_statistic;
    const float t42 = state->filling_statistic_2;
    const float t43 = state->filling_statistic_3;
    const uint32_t t44 = state->filling_replaced;
    const float t46 = work->flags[3] ? t39 : t33;
    work->t47 = work->flags[2] ? 0.0f : t46;
    const float t48 = work->flags[3] ? t40 : t34;
    work->t49 = work->flags[2] ? 0.0f : t48;
    const float t50 = work->flags[3] ? t41 : t35;
    work->t51 = work->flags[2] ? 0.0f : t50;
    const float t52 = work->flags[3] ? t42 : t36;
    work->t53 = work->flags[2] ? 0.0f : t52;
    const float t54 = work->flags[3] ? t43 : t37;
    work->t55 = work->flags[2] ? 0.0f : t54;
    const uint32_t t56 = work->flags[3] ? t44 : t38;
    work->t57 = work->flags[2] ? 0U : t56;
    work->t58 = work->flags[3] ? 0.0f : t39;
    work->t59 = work->flags[3] ? 0.0f : t40;
    work->t60 = work->flags[3] ? 0.0f : t41;
    work->t61 = work->flags[3] ? 0.0f : t42;
    work->t62 = work->flags[3] ? 0.0f : t43;
    work->t63 = work->flags[3] ? 0U : t44;
}

/* Part 2 of a step. */
static void small_memory_part_2(small_memory_state *state, small_memory_work *work)
{
    /* the copy that fills */
    const float t64 = work->t58 + work->t11;
    const float t66 = 0.49962518f * work->t8;
    const float t67 = work->t59 + t66;
    const float t68 = work->flags[3] ? 0.0f : t64;
    const float t69 = work->flags[3] ? 0.0f : t67;
    const float t70 = work->t17 - t68;
    const float t71 = SMALL_MEMORY_AGES[work->t31][0];
    const float t72 = t71 * t70;
    const float t73 = work->t60 + t72;
    const float t74 = SMALL_MEMORY_AGES[work->t31][1];
    const float t75 = t74 * t70;
    const float t76 = work->t61 + t75;
    const float t77 = SMALL_MEMORY_AGES[work->t31][2];
    const float t78 = t77 * t70;
    const float t79 = work->t62 + t78;
    state->filling_statistic = t73;
    state->filling_statistic_2 = t76;
    state->filling_statistic_3 = t79;
    const float t81 = 0.0009992503f * t69;
    const float t82 = t68 + t81;
    const float t84 = 0.9985011f * t69;
    state->filling_angle = t82;
    state->filling_speed = t84;
    const int t85 = work->flags[1] || work->flags[3];
    const int t86 = work->flags[0] && t85;
    const uint32_t t87 = t86 ? work->t63 : 1U;
    state->filling_replaced = t87;

    /* the copy that is used, and the estimate */
    const float t88 = work->t47 + work->t11;
    const float t89 = work->t49 + t66;
    const float t90 = work->flags[2] ? 0.0f : t88;
    const float t91 = work->flags[2] ? 0.0f : t89;
    const float t92 = work->t17 - t90;
    const float t93 = SMALL_MEMORY_AGES[work->t31][3];
    const float t94 = t93 * t92;
    const float t95 = work->t51 + t94;
    const float t96 = SMALL_MEMORY_AGES[work->t31][4];
    const float t97 = t96 * t92;
    const float t98 = work->t53 + t97;
    const float t99 = SMALL_MEMORY_AGES[work->t31][5];
    const float t100 = t99 * t92;
    const float t101 = work->t55 + t100;
    state->used_statistic = t95;
    state->used_statistic_2 = t98;
    state->used_statistic_3 = t101;
    const float t102 = 0.0009992503f * t91;
    const float t103 = t90 + t102;
    const float t104 = 0.9985011f * t91;
    state->used_angle = t103;
    state->used_speed = t104;
    const int t105 = work->flags[1] || work->flags[2];
    const int t106 = work->flags[0] && t105;
    work->t107 = t106 ? work->t57 : 1U;
    state->used_replaced = work->t107;
    const float t108 = SMALL_MEMORY_AGES[work->t31][6];
    const float t109 = t108 * t95;
    const float t110 = SMALL_MEMORY_AGES[work->t31][7];
    const float t111 = t110 * t98;
    const float t112 = SMALL_MEMORY_AGES[work->t31][8];
    const float t113 = t112 * t101;
    const float t114 = SMALL_MEMORY_AGES[work->t31][9];
    const float t115 = t114 * t95;
    const float t116 = SMALL_MEMORY_AGES[work->t31][10];
    const float t117 = t116 * t98;
    const float t118 = SMALL_MEMORY_AGES[work->t31][11];
    const float t119 = t118 * t101;
    const float t120 = SMALL_MEMORY_AGES[work->t31][12];
    const float t121 = t120 * t95;
    const float t122 = SMALL_MEMORY_AGES[work->t31][13];
    const float t123 = t122 * t98;
    const float t124 = SMALL_MEMORY_AGES[work->t31][14];
    const float t125 = t124 * t101;
    const float t126 = t90 + t109;
    const float t127 = t126 + t111;
    work->t128 = t127 + t113;
    const float t129 = t91 + t115;
    const float t130 = t129 + t117;
    work->t131 = t130 + t119;
    const float t132 = t121 + t123;
    work->t133 = t132 + t125;

    /* the next measurement, as far as it is known */
    const float t134 = 0.0009992503f * work->t131;
    const float t136 = -4.997501e-7f * work->t133;
    const float t137 = work->t128 + t134;
    const float t138 = t137 + t136;
    state->ahead_angle = t138;
}

/* Part 3 of a step. */
static void small_memory_part_3(small_memory_work *work)
{
    /* the estimate; until the window is full, the start */
    const int t139 = 40U < work->t26;
    work->t140 = t139 ? work->t128 : work->t17;
    work->t141 = t139 ? work->t131 : 0.0f;
    work->t142 = t139 ? work->t133 : 0.0f;
    const int t143 = work->t107 == 0U;
    const small_memory_status t147 = t143 ? SMALL_MEMORY_CONVERGED : SMALL_MEMORY_COASTING;
    work->t148 = t139 ? t147 : SMALL_MEMORY_CONVERGING;
}

void small_memory_init(small_memory_state *state)
{
    state->angle = 0.0f;
    state->torque = 0.0f;
    state->count = 0U;
    state->ahead_angle = 0.0f;
    state->used_angle = 0.0f;
    state->used_speed = 0.0f;
    state->used_statistic = 0.0f;
    state->used_statistic_2 = 0.0f;
    state->used_statistic_3 = 0.0f;
    state->used_replaced = 0U;
    state->filling_angle = 0.0f;
    state->filling_speed = 0.0f;
    state->filling_statistic = 0.0f;
    state->filling_statistic_2 = 0.0f;
    state->filling_statistic_3 = 0.0f;
    state->filling_replaced = 0U;
    state->age = 0U;
}

void small_memory_step(small_memory_state *state, const small_memory_measurements *measurements,
                       const small_memory_inputs *inputs, small_memory_estimate *estimate)
{
    small_memory_work work;
    small_memory_part_1(state, measurements, inputs, &work);
    small_memory_part_2(state, &work);
    small_memory_part_3(&work);

    estimate->angle = work.t140;
    estimate->speed = work.t141;
    estimate->load = work.t142;
    estimate->status = work.t148;
}
