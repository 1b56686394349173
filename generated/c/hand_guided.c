/* hand_guided.c: Finite-time observer: Speed of an arm moved by hand, without the outliers of its bus.
 *
 * Generated; hand_guided.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "hand_guided.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "hand_guided.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "hand_guided.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* weights by age, from age 0
 *   [0] q from y
 *   [1] dq from y
 *   [2] d2q from y
 */
static const float HAND_GUIDED_WINDOW[132][3] = {
    { 0.066156745f, 2.0123239f, 25.504738f },
    { 0.06415717f, 1.930592f, 24.336582f },
    { 0.062183104f, 1.8500371f, 23.186398f },
    { 0.060234543f, 1.7706593f, 22.054186f },
    { 0.058311485f, 1.6924589f, 20.939945f },
    { 0.05641393f, 1.6154354f, 19.843676f },
    { 0.054541882f, 1.5395892f, 18.765377f },
    { 0.05269534f, 1.46492f, 17.705051f },
    { 0.050874304f, 1.391428f, 16.662697f },
    { 0.04907877f, 1.3191131f, 15.638313f },
    { 0.04730874f, 1.2479755f, 14.631903f },
    { 0.045564216f, 1.1780149f, 13.643463f },
    { 0.043845195f, 1.1092315f, 12.672995f },
    { 0.042151682f, 1.0416253f, 11.720498f },
    { 0.040483672f, 0.97519606f, 10.785974f },
    { 0.038841166f, 0.90994406f, 9.86942f },
    { 0.037224166f, 0.84586924f, 8.970839f },
    { 0.03563267f, 0.7829715f, 8.090229f },
    { 0.03406668f, 0.72125095f, 7.2275906f },
    { 0.032526195f, 0.66070753f, 6.382924f },
    { 0.031011213f, 0.60134125f, 5.556229f },
    { 0.029521735f, 0.5431521f, 4.7475057f },
    { 0.028057763f, 0.4861401f, 3.956754f },
    { 0.026619297f, 0.43030524f, 3.1839738f },
    { 0.025206333f, 0.37564752f, 2.4291654f },
    { 0.023818875f, 0.32216692f, 1.6923286f },
    { 0.022456922f, 0.2698635f, 0.9734633f },
    { 0.021120474f, 0.2187372f, 0.27256972f },
    { 0.019809531f, 0.16878806f, -0.41035223f },
    { 0.018524092f, 0.120016046f, -1.0753026f },
    { 0.017264158f, 0.07242118f, -1.7222812f },
    { 0.016029729f, 0.026003452f, -2.3512883f },
    { 0.014820804f, -0.019237133f, -2.9623237f },
    { 0.0136373835f, -0.06330057f, -3.5553875f },
    { 0.012479468f, -0.106186874f, -4.13048f },
    { 0.011347058f, -0.14789604f, -4.6876f },
    { 0.0102401525f, -0.18842804f, -5.226749f },
    { 0.009158752f, -0.22778292f, -5.747926f },
    { 0.008102856f, -0.26596066f, -6.251132f },
    { 0.007072464f, -0.30296126f, -6.7363663f },
    { 0.0060675773f, -0.3387847f, -7.2036285f },
    { 0.005088195f, -0.373431f, -7.6529193f },
    { 0.0041343183f, -0.40690017f, -8.084238f },
    { 0.0032059457f, -0.4391922f, -8.497586f },
    { 0.0023030778f, -0.47030708f, -8.8929615f },
    { 0.0014257149f, -0.5002448f, -9.270366f },
    { 0.00057385664f, -0.5290054f, -9.629799f },
    { -0.00025249692f, -0.5565889f, -9.971259f },
    { -0.0010533457f, -0.5829952f, -10.294749f },
    { -0.0018286898f, -0.6082244f, -10.600266f },
    { -0.002578529f, -0.6322764f, -10.887813f },
    { -0.0033028636f, -0.6551513f, -11.157387f },
    { -0.0040016933f, -0.67684907f, -11.40899f },
    { -0.0046750186f, -0.69736964f, -11.642621f },
    { -0.005322839f, -0.71671313f, -11.858281f },
    { -0.0059451545f, -0.73487943f, -12.055968f },
    { -0.0065419655f, -0.7518686f, -12.235685f },
    { -0.007113272f, -0.76768064f, -12.397429f },
    { -0.007659073f, -0.78231555f, -12.541203f },
    { -0.008179369f, -0.7957733f, -12.667005f },
    { -0.0086741615f, -0.8080539f, -12.774834f },
    { -0.009143448f, -0.8191574f, -12.864692f },
    { -0.009587231f, -0.82908374f, -12.936579f },
    { -0.0100055095f, -0.8378329f, -12.990494f },
    { -0.010398282f, -0.845405f, -13.026437f },
    { -0.010765551f, -0.85179985f, -13.044409f },
    { -0.011107313f, -0.85701764f, -13.044409f },
    { -0.011423573f, -0.86105824f, -13.026437f },
    { -0.011714326f, -0.86392176f, -12.990494f },
    { -0.011979576f, -0.8656081f, -12.936579f },
    { -0.01221932f, -0.86611724f, -12.864692f },
    { -0.012433561f, -0.8654493f, -12.774834f },
    { -0.012622295f, -0.86360425f, -12.667005f },
    { -0.012785526f, -0.860582f, -12.541203f },
    { -0.012923251f, -0.8563826f, -12.397429f },
    { -0.013035472f, -0.85100615f, -12.235685f },
    { -0.013122188f, -0.84445244f, -12.055968f },
    { -0.013183399f, -0.83672166f, -11.858281f },
    { -0.013219106f, -0.82781374f, -11.642621f },
    { -0.013229308f, -0.81772864f, -11.40899f },
    { -0.013214005f, -0.8064664f, -11.157387f },
    { -0.013173197f, -0.7940271f, -10.887813f },
    { -0.013106885f, -0.7804106f, -10.600266f },
    { -0.013015068f, -0.7656169f, -10.294749f },
    { -0.012897747f, -0.7496461f, -9.971259f },
    { -0.01275492f, -0.73249817f, -9.629799f },
    { -0.012586589f, -0.71417314f, -9.270366f },
    { -0.012392753f, -0.6946709f, -8.8929615f },
    { -0.012173411f, -0.67399156f, -8.497586f },
    { -0.011928567f, -0.6521351f, -8.084238f },
    { -0.011658216f, -0.6291014f, -7.6529193f },
    { -0.011362361f, -0.60489064f, -7.2036285f },
    { -0.011041001f, -0.5795027f, -6.7363663f },
    { -0.010694137f, -0.5529376f, -6.251132f },
    { -0.010321768f, -0.5251954f, -5.747926f },
    { -0.009923894f, -0.49627608f, -5.226749f },
    { -0.009500516f, -0.4661796f, -4.6876f },
    { -0.009051632f, -0.43490598f, -4.13048f },
    { -0.008577243f, -0.40245518f, -3.5553875f },
    { -0.00807735f, -0.36882728f, -2.9623237f },
    { -0.007551953f, -0.33402222f, -2.3512883f },
    { -0.0070010507f, -0.29804003f, -1.7222812f },
    { -0.0064246436f, -0.26088068f, -1.0753026f },
    { -0.0058227316f, -0.2225442f, -0.41035223f },
    { -0.0051953155f, -0.18303058f, 0.27256972f },
    { -0.004542394f, -0.14233981f, 0.9734633f },
    { -0.003863968f, -0.1004719f, 1.6923286f },
    { -0.003160037f, -0.057426848f, 2.4291654f },
    { -0.0024306015f, -0.013204656f, 3.1839738f },
    { -0.0016756613f, 0.032194678f, 3.956754f },
    { -0.0008952163f, 0.07877115f, 4.7475057f },
    { -8.9266585e-5f, 0.12652478f, 5.556229f },
    { 0.0007421879f, 0.17545553f, 6.382924f },
    { 0.0015991471f, 0.22556344f, 7.2275906f },
    { 0.002481611f, 0.27684847f, 8.090229f },
    { 0.0033895797f, 0.32931066f, 8.970839f },
    { 0.004323053f, 0.38294998f, 9.86942f },
    { 0.0052820314f, 0.43776646f, 10.785974f },
    { 0.0062665143f, 0.49376005f, 11.720498f },
    { 0.007276502f, 0.5509308f, 12.672995f },
    { 0.008311994f, 0.6092787f, 13.643463f },
    { 0.0093729915f, 0.66880375f, 14.631903f },
    { 0.010459493f, 0.7295059f, 15.638313f },
    { 0.0115714995f, 0.79138523f, 16.662697f },
    { 0.012709011f, 0.8544417f, 17.705051f },
    { 0.013872027f, 0.9186753f, 18.765377f },
    { 0.015060549f, 0.98408604f, 19.843676f },
    { 0.016274573f, 1.050674f, 20.939945f },
    { 0.017514104f, 1.118439f, 22.054186f },
    { 0.01877914f, 1.1873811f, 23.186398f },
    { 0.02006968f, 1.2575004f, 24.336582f },
    { 0.021385724f, 1.3287969f, 25.504738f }
};

/* What one part of a step hands to the next. */
typedef struct {
    uint32_t t36;
    float t72;
    float t73;
    float t74;
    hand_guided_status t81;
} hand_guided_work;

/* Part 1 of a step. */
static void hand_guided_part_1(hand_guided_state *state, const hand_guided_measurements *measurements, hand_guided_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    const uint32_t t0 = state->newest;
    const uint32_t t1 = (t0 < 131U) ? t0 : 131U;
    const uint32_t t2 = state->count;
    const int t4 = 131U < t2;
    const float t5 = measurements->y;
    const int t6 = (-1e34f <= t5) && (t5 <= 1e34f);

    /* prediction, for a sample that is missing */
    const uint32_t t7 = (t1 < 131U) ? (t1 + 1U) : 0U;
    const float t8 = state->ahead_y;
    const float t9 = state->y[t1];
    const float t10 = t5 - t8;
    const int t11 = (-1e34f <= t8) && (t8 <= 1e34f);
    const int t12 = (-0.1f <= t10) && (t10 <= 0.1f);
    const int t13 = !t12;
    const int t14 = t11 && t13;
    const int t15 = t4 && t14;
    const int t16 = t6 && t15;
    const uint32_t t17 = state->rejected_y;
    const int t20 = t17 < 130U;
    const int t21 = t16 && t20;
    const uint32_t t22 = (t17 < 131U) ? (t17 + 1U) : 131U;
    const uint32_t t23 = t6 ? 0U : t17;
    const uint32_t t24 = t21 ? t22 : t23;
    state->rejected_y = t24;
    const int t25 = !t21;
    const int t26 = !t20;
    const int t27 = t6 && t25;
    const int t28 = t16 && t26;
    const int t29 = t4 && t11;
    const float t30 = t29 ? t8 : t9;
    const float t31 = t27 ? t5 : t30;
    const int t32 = t27 || t29;
    const int t33 = !t32;
    const uint32_t t34 = state->since;
    const uint32_t t35 = (t34 < 4294967295U) ? (t34 + 1U) : 4294967295U;
    work->t36 = t27 ? 0U : t35;
    state->since = work->t36;

    /* how much of the window is good */
    const int t37 = !t28;
    const int t38 = t4 && t37;
    const uint32_t t40 = (t2 < 132U) ? (t2 + 1U) : 132U;
    const uint32_t t41 = t33 ? 0U : t40;
    const uint32_t t42 = t37 ? t40 : 1U;
    const uint32_t t43 = t27 ? t42 : 0U;
    const uint32_t t44 = t38 ? t41 : t43;
    state->count = t44;
    const uint32_t t45 = state->coasting;
    const uint32_t t46 = (t45 > 0U) ? (t45 - 1U) : 0U;
    const uint32_t t48 = t27 ? t46 : 132U;
    state->coasting = t48;

    /* into the window */
    state->newest = t7;
    state->y[t7] = t31;

    /* the sums over the window, newest sample first */
    float t50 = 0.0f;
    float t51 = 0.0f;
    float t52 = 0.0f;
    uint32_t t53 = t7;
    for (uint32_t row = 0U; row < 132U; ++row) {
        const float *const gains = HAND_GUIDED_WINDOW[row];
        const float t54 = state->y[t53];
        const float t55 = gains[0];
        const float t56 = t55 * t54;
        const float t57 = t50 + t56;
        const float t58 = gains[1];
        const float t59 = t58 * t54;
        const float t60 = t51 + t59;
        const float t61 = gains[2];
        const float t62 = t61 * t54;
        const float t63 = t52 + t62;
        const uint32_t t64 = ((t53 >= 1U) && (t53 < 132U)) ? (t53 - 1U) : 131U;
        t50 = t57;
        t51 = t60;
        t52 = t63;
        t53 = t64;
    }

    /* the next measurement, as far as it is known */
    const float t66 = 0.001f * t51;
    const float t68 = 5e-7f * t52;
    const float t69 = t50 + t66;
    const float t70 = t69 + t68;
    state->ahead_y = t70;

    /* the estimate; until the window is full, the start */
    const int t71 = 131U < t44;
    work->t72 = t71 ? t50 : t31;
    work->t73 = t71 ? t51 : 0.0f;
    work->t74 = t71 ? t52 : 0.0f;
    const uint32_t t75 = state->coasting;
    const int t76 = t75 == 0U;
    const hand_guided_status t80 = t76 ? HAND_GUIDED_CONVERGED : HAND_GUIDED_COASTING;
    work->t81 = t71 ? t80 : HAND_GUIDED_CONVERGING;
}

void hand_guided_init(hand_guided_state *state)
{
    for (uint32_t slot = 0U; slot < 132U; ++slot) {
        state->y[slot] = 0.0f;
    }
    state->newest = 131U;
    state->count = 0U;
    state->rejected_y = 0U;
    state->coasting = 0U;
    state->ahead_y = 0.0f;
    state->since = 0U;
}

void hand_guided_step(hand_guided_state *state, const hand_guided_measurements *measurements,
                      hand_guided_estimate *estimate)
{
    hand_guided_work work;
    hand_guided_part_1(state, measurements, &work);

    estimate->q = work.t72;
    estimate->dq = work.t73;
    estimate->d2q = work.t74;
    estimate->coasted = work.t36;
    estimate->status = work.t81;
}
