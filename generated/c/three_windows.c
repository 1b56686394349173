/* three_windows.c: Finite-time observer: An arm's speed and acceleration, quick, smooth and smoother, from one buffer.
 *
 * Generated; three_windows.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "three_windows.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "three_windows.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "three_windows.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* weights by age, from age 0
 *   [0] q from y
 *   [1] dq from y
 *   [2] d2q from y
 */
static const float THREE_WINDOWS_WINDOW[11][3] = {
    { 0.5804196f, 220.27972f, 34965.035f },
    { 0.37762237f, 106.29371f, 13986.014f },
    { 0.20979021f, 15.617716f, -2331.0024f },
    { 0.07692308f, -51.748253f, -13986.014f },
    { -0.02097902f, -95.8042f, -20979.021f },
    { -0.08391608f, -116.55012f, -23310.023f },
    { -0.11188811f, -113.986015f, -20979.021f },
    { -0.10489511f, -88.111885f, -13986.014f },
    { -0.062937066f, -38.92774f, -2331.0024f },
    { 0.013986014f, 33.566433f, 13986.014f },
    { 0.12587413f, 129.37064f, 34965.035f }
};

/* weights by age, from age 0
 *   [0] q from y
 *   [1] dq from y
 *   [2] d2q from y
 */
static const float THREE_WINDOWS_WINDOW_2[31][3] = {
    { 0.2558651f, 33.541058f, 1832.8446f },
    { 0.22324046f, 27.639296f, 1466.2756f },
    { 0.19244868f, 22.116745f, 1124.9873f },
    { 0.16348973f, 16.973404f, 808.9797f },
    { 0.13636364f, 12.209273f, 518.2526f },
    { 0.11107038f, 7.8243504f, 252.80615f },
    { 0.08760997f, 3.818637f, 12.640307f },
    { 0.0659824f, 0.19213267f, -202.24492f },
    { 0.046187684f, -3.0551622f, -391.84952f },
    { 0.028225806f, -5.9232483f, -556.1735f },
    { 0.012096774f, -8.412125f, -695.2169f },
    { -0.0021994135f, -10.521791f, -808.9797f },
    { -0.014662757f, -12.25225f, -897.46185f },
    { -0.025293255f, -13.603498f, -960.6634f },
    { -0.03409091f, -14.575539f, -998.5843f },
    { -0.04105572f, -15.168369f, -1011.2246f },
    { -0.046187684f, -15.38199f, -998.5843f },
    { -0.049486805f, -15.216402f, -960.6634f },
    { -0.05095308f, -14.671605f, -897.46185f },
    { -0.05058651f, -13.747599f, -808.9797f },
    { -0.048387095f, -12.444383f, -695.2169f },
    { -0.044354837f, -10.761958f, -556.1735f },
    { -0.038489737f, -8.700324f, -391.84952f },
    { -0.03079179f, -6.25948f, -202.24492f },
    { -0.021260997f, -3.4394276f, 12.640307f },
    { -0.009897361f, -0.24016584f, 252.80615f },
    { 0.0032991203f, 3.3383052f, 518.2526f },
    { 0.018328445f, 7.295985f, 808.9797f },
    { 0.035190616f, 11.6328745f, 1124.9873f },
    { 0.05388563f, 16.348974f, 1466.2756f },
    { 0.07441349f, 21.44428f, 1832.8446f }
};

/* weights by age, from age 0
 *   [0] q from y
 *   [1] dq from y
 *   [2] d2q from y
 */
static const float THREE_WINDOWS_WINDOW_3[101][3] = {
    { 0.085670985f, 3.4096498f, 56.544773f },
    { 0.082289614f, 3.2283673f, 53.15209f },
    { 0.07896478f, 3.0505118f, 49.82794f },
    { 0.07569649f, 2.8760831f, 46.572334f },
    { 0.07248475f, 2.7050815f, 43.385265f },
    { 0.069329545f, 2.5375068f, 40.266735f },
    { 0.06623089f, 2.373359f, 37.216743f },
    { 0.063188784f, 2.2126381f, 34.23529f },
    { 0.06020322f, 2.0553443f, 31.322378f },
    { 0.057274204f, 1.9014775f, 28.478004f },
    { 0.05440173f, 1.7510375f, 25.702171f },
    { 0.051585797f, 1.6040245f, 22.994875f },
    { 0.04882641f, 1.4604385f, 20.35612f },
    { 0.04612357f, 1.3202794f, 17.785902f },
    { 0.04347728f, 1.1835473f, 15.284224f },
    { 0.040887527f, 1.0502421f, 12.851086f },
    { 0.038354322f, 0.9203639f, 10.4864855f },
    { 0.03587766f, 0.79391265f, 8.190425f },
    { 0.033457544f, 0.6708883f, 5.9629035f },
    { 0.031093972f, 0.551291f, 3.8039212f },
    { 0.028786944f, 0.4351206f, 1.7134781f },
    { 0.026536463f, 0.32237718f, -0.30842605f },
    { 0.024342526f, 0.2130607f, -2.261791f },
    { 0.022205133f, 0.1071712f, -4.146617f },
    { 0.020124285f, 0.0047086375f, -5.9629035f },
    { 0.018099982f, -0.094326966f, -7.710651f },
    { 0.016132224f, -0.18993561f, -9.389859f },
    { 0.014221011f, -0.2821173f, -11.000529f },
    { 0.012366342f, -0.37087205f, -12.542659f },
    { 0.010568218f, -0.45619982f, -14.016251f },
    { 0.0088266395f, -0.53810066f, -15.421302f },
    { 0.007141605f, -0.6165745f, -16.757814f },
    { 0.005513116f, -0.6916214f, -18.02579f },
    { 0.003941171f, -0.76324135f, -19.225224f },
    { 0.0024257707f, -0.83143437f, -20.35612f },
    { 0.0009669156f, -0.8962004f, -21.418476f },
    { -0.00043539476f, -0.9575395f, -22.412292f },
    { -0.0017811604f, -1.0154517f, -23.33757f },
    { -0.0030703812f, -1.0699368f, -24.19431f },
    { -0.004303057f, -1.120995f, -24.98251f },
    { -0.0054791886f, -1.1686263f, -25.702171f },
    { -0.0065987753f, -1.2128305f, -26.353292f },
    { -0.007661817f, -1.253608f, -26.935875f },
    { -0.008668314f, -1.2909583f, -27.449919f },
    { -0.0096182665f, -1.3248818f, -27.895422f },
    { -0.010511674f, -1.3553783f, -28.272387f },
    { -0.011348536f, -1.3824478f, -28.580814f },
    { -0.012128854f, -1.4060904f, -28.8207f },
    { -0.012852628f, -1.426306f, -28.992048f },
    { -0.013519856f, -1.4430946f, -29.094856f },
    { -0.014130539f, -1.4564563f, -29.129126f },
    { -0.014684678f, -1.4663911f, -29.094856f },
    { -0.0151822725f, -1.4728988f, -28.992048f },
    { -0.015623322f, -1.4759797f, -28.8207f },
    { -0.016007826f, -1.4756336f, -28.580814f },
    { -0.016335785f, -1.4718605f, -28.272387f },
    { -0.0166072f, -1.4646604f, -27.895422f },
    { -0.01682207f, -1.4540335f, -27.449919f },
    { -0.016980397f, -1.4399796f, -26.935875f },
    { -0.017082177f, -1.4224986f, -26.353292f },
    { -0.017127411f, -1.4015907f, -25.702171f },
    { -0.017116103f, -1.3772559f, -24.98251f },
    { -0.017048249f, -1.3494942f, -24.19431f },
    { -0.01692385f, -1.3183055f, -23.33757f },
    { -0.016742907f, -1.2836897f, -22.412292f },
    { -0.01650542f, -1.2456471f, -21.418476f },
    { -0.016211387f, -1.2041775f, -20.35612f },
    { -0.015860809f, -1.159281f, -19.225224f },
    { -0.015453687f, -1.1109575f, -18.02579f },
    { -0.01499002f, -1.059207f, -16.757814f },
    { -0.014469808f, -1.0040296f, -15.421302f },
    { -0.013893051f, -0.9454252f, -14.016251f },
    { -0.01325975f, -0.8833939f, -12.542659f },
    { -0.012569903f, -0.8179356f, -11.000529f },
    { -0.011823513f, -0.7490503f, -9.389859f },
    { -0.011020577f, -0.67673814f, -7.710651f },
    { -0.010161096f, -0.600999f, -5.9629035f },
    { -0.009245071f, -0.5218329f, -4.146617f },
    { -0.008272501f, -0.4392398f, -2.261791f },
    { -0.0072433855f, -0.35321978f, -0.30842605f },
    { -0.006157726f, -0.26377282f, 1.7134781f },
    { -0.0050155213f, -0.17089887f, 3.8039212f },
    { -0.0038167723f, -0.07459798f, 5.9629035f },
    { -0.0025614784f, 0.02512987f, 8.190425f },
    { -0.0012496396f, 0.12828468f, 10.4864855f },
    { 0.00011874403f, 0.23486644f, 12.851086f },
    { 0.0015436724f, 0.34487516f, 15.284224f },
    { 0.0030251455f, 0.4583108f, 17.785902f },
    { 0.0045631635f, 0.57517344f, 20.35612f },
    { 0.006157726f, 0.69546306f, 22.994875f },
    { 0.0078088334f, 0.8191796f, 25.702171f },
    { 0.009516486f, 0.9463231f, 28.478004f },
    { 0.011280683f, 1.0768936f, 31.322378f },
    { 0.013101424f, 1.2108909f, 34.23529f },
    { 0.014978711f, 1.3483154f, 37.216743f },
    { 0.016912542f, 1.4891666f, 40.266735f },
    { 0.018902918f, 1.6334449f, 43.385265f },
    { 0.020949839f, 1.7811501f, 46.572334f },
    { 0.023053305f, 1.9322823f, 49.82794f },
    { 0.025213316f, 2.0868416f, 53.15209f },
    { 0.027429871f, 2.2448275f, 56.544773f }
};

/* What one part of a step hands to the next. */
typedef struct {
    uint32_t t7;
    float t13;
    uint32_t t21;
    float t28;
    float t29;
    float t30;
    float t61;
    float t62;
    float t63;
    float t89;
    float t90;
    float t91;
    float t92;
    float t93;
    float t94;
    float t95;
    float t96;
    float t97;
    uint32_t t111;
    three_windows_status t116;
    int flags[2]; /* t43, t60 */
} three_windows_work;

/* Part 1 of a step. */
static void three_windows_part_1(three_windows_state *state, const three_windows_measurements *measurements, three_windows_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    const uint32_t t0 = state->newest;
    const uint32_t t1 = (t0 < 100U) ? t0 : 100U;
    const uint32_t t2 = state->count;
    const int t4 = 10U < t2;
    const float t5 = measurements->y;
    const int t6 = (-1e32f <= t5) && (t5 <= 1e32f);

    /* prediction, for a sample that is missing */
    work->t7 = (t1 < 100U) ? (t1 + 1U) : 0U;
    const float t8 = state->ahead_y;
    const float t9 = state->y[t1];
    const int t10 = (-1e32f <= t8) && (t8 <= 1e32f);
    const int t11 = t4 && t10;
    const float t12 = t11 ? t8 : t9;
    work->t13 = t6 ? t5 : t12;
    const int t14 = t6 || t11;
    const int t15 = !t14;

    /* how much of the window is good */
    const uint32_t t18 = (t2 < 101U) ? (t2 + 1U) : 101U;
    const uint32_t t19 = t15 ? 0U : t18;
    const uint32_t t20 = t6 ? t18 : 0U;
    work->t21 = t4 ? t19 : t20;
    state->count = work->t21;
    const uint32_t t22 = state->coasting;
    const uint32_t t23 = (t22 > 0U) ? (t22 - 1U) : 0U;
    const uint32_t t26 = t6 ? t23 : 101U;
    state->coasting = t26;

    /* into the window */
    state->newest = work->t7;
    state->y[work->t7] = work->t13;

    /* the sums over the window, newest sample first */
    work->t28 = 0.0f;
    work->t29 = 0.0f;
    work->t30 = 0.0f;
    uint32_t t31 = work->t7;
    for (uint32_t row = 0U; row < 11U; ++row) {
        const float *const gains = THREE_WINDOWS_WINDOW[row];
        const float t32 = state->y[t31];
        const float t33 = gains[0];
        const float t34 = t33 * t32;
        const float t35 = work->t28 + t34;
        const float t36 = gains[1];
        const float t37 = t36 * t32;
        const float t38 = work->t29 + t37;
        const float t39 = gains[2];
        const float t40 = t39 * t32;
        const float t41 = work->t30 + t40;
        const uint32_t t42 = ((t31 >= 1U) && (t31 < 101U)) ? (t31 - 1U) : 100U;
        work->t28 = t35;
        work->t29 = t38;
        work->t30 = t41;
        t31 = t42;
    }
    work->flags[0] = 10U < work->t21;

    /* the sums over a window of 31 samples */
    float t44 = 0.0f;
    float t45 = 0.0f;
    float t46 = 0.0f;
    uint32_t t47 = work->t7;
    for (uint32_t row = 0U; row < 31U; ++row) {
        const float *const gains = THREE_WINDOWS_WINDOW_2[row];
        const float t48 = state->y[t47];
        const float t49 = gains[0];
        const float t50 = t49 * t48;
        const float t51 = t44 + t50;
        const float t52 = gains[1];
        const float t53 = t52 * t48;
        const float t54 = t45 + t53;
        const float t55 = gains[2];
        const float t56 = t55 * t48;
        const float t57 = t46 + t56;
        const uint32_t t58 = ((t47 >= 1U) && (t47 < 101U)) ? (t47 - 1U) : 100U;
        t44 = t51;
        t45 = t54;
        t46 = t57;
        t47 = t58;
    }
    work->flags[1] = 30U < work->t21;
    work->t61 = work->flags[1] ? t44 : work->t28;
    work->t62 = work->flags[1] ? t45 : work->t29;
    work->t63 = work->flags[1] ? t46 : work->t30;
}

/* Part 2 of a step. */
static void three_windows_part_2(three_windows_state *state, three_windows_work *work)
{
    /* the sums over a window of 101 samples */
    float t64 = 0.0f;
    float t65 = 0.0f;
    float t66 = 0.0f;
    uint32_t t67 = work->t7;
    for (uint32_t row = 0U; row < 101U; ++row) {
        const float *const gains = THREE_WINDOWS_WINDOW_3[row];
        const float t68 = state->y[t67];
        const float t69 = gains[0];
        const float t70 = t69 * t68;
        const float t71 = t64 + t70;
        const float t72 = gains[1];
        const float t73 = t72 * t68;
        const float t74 = t65 + t73;
        const float t75 = gains[2];
        const float t76 = t75 * t68;
        const float t77 = t66 + t76;
        const uint32_t t78 = ((t67 >= 1U) && (t67 < 101U)) ? (t67 - 1U) : 100U;
        t64 = t71;
        t65 = t74;
        t66 = t77;
        t67 = t78;
    }
    const int t79 = 100U < work->t21;
    const float t80 = t79 ? t64 : work->t61;
    const float t81 = t79 ? t65 : work->t62;
    const float t82 = t79 ? t66 : work->t63;

    /* the next measurement, as far as it is known */
    const float t84 = 0.001f * t81;
    const float t86 = 5e-7f * t82;
    const float t87 = t80 + t84;
    const float t88 = t87 + t86;
    state->ahead_y = t88;

    /* the estimates, shortest window first; until one is full, the start */
    work->t89 = work->flags[0] ? work->t28 : work->t13;
    work->t90 = work->flags[0] ? work->t29 : 0.0f;
    work->t91 = work->flags[0] ? work->t30 : 0.0f;
    work->t92 = work->flags[0] ? work->t61 : work->t13;
    work->t93 = work->flags[0] ? work->t62 : 0.0f;
    work->t94 = work->flags[0] ? work->t63 : 0.0f;
    work->t95 = work->flags[0] ? t80 : work->t13;
    work->t96 = work->flags[0] ? t81 : 0.0f;
    work->t97 = work->flags[0] ? t82 : 0.0f;
    const uint32_t t98 = state->coasting;
    const int t100 = t98 < 91U;
    const int t101 = work->flags[0] && t100;
    const uint32_t t102 = t101 ? 1U : 0U;
    const int t104 = t98 < 71U;
    const int t105 = work->flags[1] && t104;
    const uint32_t t107 = t105 ? 2U : t102;
    const int t108 = t98 < 1U;
    const int t109 = t79 && t108;
    work->t111 = t109 ? 3U : t107;
    const three_windows_status t115 = t100 ? THREE_WINDOWS_CONVERGED : THREE_WINDOWS_COASTING;
    work->t116 = work->flags[0] ? t115 : THREE_WINDOWS_CONVERGING;
}

void three_windows_init(three_windows_state *state)
{
    for (uint32_t slot = 0U; slot < 101U; ++slot) {
        state->y[slot] = 0.0f;
    }
    state->newest = 100U;
    state->count = 0U;
    state->coasting = 0U;
    state->ahead_y = 0.0f;
}

void three_windows_step(three_windows_state *state, const three_windows_measurements *measurements,
                        three_windows_estimate *estimate)
{
    three_windows_work work;
    three_windows_part_1(state, measurements, &work);
    three_windows_part_2(state, &work);

    estimate->q = work.t89;
    estimate->dq = work.t90;
    estimate->d2q = work.t91;
    estimate->q_2 = work.t92;
    estimate->dq_2 = work.t93;
    estimate->d2q_2 = work.t94;
    estimate->q_3 = work.t95;
    estimate->dq_3 = work.t96;
    estimate->d2q_3 = work.t97;
    estimate->windows = work.t111;
    estimate->status = work.t116;
}
