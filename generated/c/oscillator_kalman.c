/* oscillator_kalman.c: Finite-time observer: Mass on a spring, its speed by a Kalman filter from the first sample on.
 *
 * Generated; oscillator_kalman.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "oscillator_kalman.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "oscillator_kalman.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "oscillator_kalman.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* gain by calls of the countdown that are left
 *   [0] position from position
 *   [1] speed from position
 */
static const float OSCILLATOR_KALMAN_GAINS[100][2] = {
    { 0.11396158f, 0.6890861f },
    { 0.11396175f, 0.68908846f },
    { 0.11396192f, 0.689091f },
    { 0.11396208f, 0.6890937f },
    { 0.11396222f, 0.6890964f },
    { 0.11396234f, 0.689099f },
    { 0.113962434f, 0.6891015f },
    { 0.11396251f, 0.6891038f },
    { 0.11396255f, 0.6891057f },
    { 0.11396258f, 0.6891071f },
    { 0.11396259f, 0.68910795f },
    { 0.11396259f, 0.689108f },
    { 0.1139626f, 0.6891073f },
    { 0.11396263f, 0.6891056f },
    { 0.11396272f, 0.6891029f },
    { 0.113962896f, 0.6890992f },
    { 0.11396322f, 0.6890945f },
    { 0.11396372f, 0.689089f },
    { 0.11396449f, 0.68908286f },
    { 0.11396559f, 0.6890765f },
    { 0.11396712f, 0.68907034f },
    { 0.11396918f, 0.6890651f },
    { 0.113971874f, 0.6890615f },
    { 0.11397533f, 0.6890607f },
    { 0.11397968f, 0.68906397f },
    { 0.11398506f, 0.68907267f },
    { 0.11399161f, 0.68908864f },
    { 0.113999456f, 0.6891138f },
    { 0.11400874f, 0.6891503f },
    { 0.11401957f, 0.68920046f },
    { 0.114032045f, 0.68926686f },
    { 0.114046216f, 0.6893519f },
    { 0.11406213f, 0.68945825f },
    { 0.11407976f, 0.68958825f },
    { 0.11409903f, 0.6897442f },
    { 0.11411983f, 0.6899279f },
    { 0.114141926f, 0.6901406f },
    { 0.11416507f, 0.6903829f },
    { 0.1141889f, 0.69065446f },
    { 0.114213f, 0.6909538f },
    { 0.11423687f, 0.69127804f },
    { 0.11425996f, 0.6916229f },
    { 0.1142817f, 0.69198227f },
    { 0.114301495f, 0.69234824f },
    { 0.11431879f, 0.692711f },
    { 0.11433309f, 0.6930586f },
    { 0.11434409f, 0.69337755f },
    { 0.114351645f, 0.6936525f },
    { 0.11435596f, 0.6938669f },
    { 0.114357635f, 0.6940036f },
    { 0.114357784f, 0.6940453f },
    { 0.114358194f, 0.6939761f },
    { 0.114361435f, 0.6937822f },
    { 0.11437101f, 0.69345397f },
    { 0.114391506f, 0.69298726f },
    { 0.11442876f, 0.692386f },
    { 0.114489935f, 0.69166416f },
    { 0.11458373f, 0.6908487f },
    { 0.11472043f, 0.6899823f },
    { 0.114911966f, 0.68912613f },
    { 0.11517206f, 0.6883632f },
    { 0.11551612f, 0.6878014f },
    { 0.11596133f, 0.6875766f },
    { 0.116526544f, 0.68785584f },
    { 0.11723223f, 0.6888405f },
    { 0.11810038f, 0.6907694f },
    { 0.119154386f, 0.69392186f },
    { 0.12041897f, 0.69862187f },
    { 0.121920094f, 0.70524156f },
    { 0.12368493f, 0.7142063f },
    { 0.12574185f, 0.7260008f },
    { 0.12812059f, 0.741177f },
    { 0.13085234f, 0.7603641f },
    { 0.13397013f, 0.78428197f },
    { 0.13750923f, 0.8137588f },
    { 0.1415078f, 0.84975445f },
    { 0.14600763f, 0.8933908f },
    { 0.1510552f, 0.94599235f },
    { 0.15670292f, 1.0091399f },
    { 0.1630108f, 1.0847417f },
    { 0.17004853f, 1.1751297f },
    { 0.17789796f, 1.2831887f },
    { 0.18665653f, 1.4125357f },
    { 0.19644146f, 1.5677664f },
    { 0.20739537f, 1.7548059f },
    { 0.21969369f, 1.9814111f },
    { 0.23355457f, 2.2579086f },
    { 0.2492526f, 2.5983002f },
    { 0.26713777f, 3.0219657f },
    { 0.28766254f, 3.5563571f },
    { 0.3114213f, 4.2414083f },
    { 0.3392086f, 5.1370335f },
    { 0.3721084f, 6.3364577f },
    { 0.41163296f, 7.9912205f },
    { 0.45994532f, 10.361188f },
    { 0.5202208f, 13.922945f },
    { 0.5972248f, 19.629976f },
    { 0.69810593f, 29.628351f },
    { 0.8323885f, 49.64283f },
    { 1.0f, 99.71679f }
};

void oscillator_kalman_init(oscillator_kalman_state *state)
{
    state->position = 0.0f;
    state->speed = 0.0f;
    state->left = 100U;
    state->good = 0U;
    state->clean = 0U;
    state->last_force = 0.0f;
}

void oscillator_kalman_step(oscillator_kalman_state *state, const oscillator_kalman_measurements *measurements,
                            const oscillator_kalman_inputs *inputs, oscillator_kalman_estimate *estimate)
{
    /* samples: outside its range, infinite or NaN means missing */
    const float t0 = measurements->position;
    const int t1 = (-1e35f <= t0) && (t0 <= 1e35f);
    const float t2 = inputs->force;
    const int t3 = (-1e35f <= t2) && (t2 <= 1e35f);
    const float t4 = state->last_force;
    const float t5 = t3 ? t2 : t4;

    /* prediction by the plant */
    const float t6 = state->position;
    const float t7 = state->speed;
    const float t9 = 0.99875194f * t6;
    const float t11 = 0.009975869f * t7;
    const float t13 = 4.9923e-5f * t5;
    const float t14 = t9 + t11;
    const float t15 = t14 + t13;
    const float t17 = -0.24939673f * t6;
    const float t19 = 0.9947616f * t7;
    const float t20 = 0.009975869f * t5;
    const float t21 = t17 + t19;
    const float t22 = t21 + t20;
    state->last_force = t5;
    const int t23 = t3 && t1;

    /* correction by the innovation */
    const float t25 = t0 - t15;
    const float t26 = t1 ? t25 : 0.0f;
    const uint32_t t27 = state->left;
    const uint32_t t28 = (t27 < 100U) ? t27 : 100U;
    const uint32_t t29 = (t28 > 0U) ? (t28 - 1U) : 0U;
    const uint32_t t30 = t1 ? t29 : t28;
    const uint32_t t31 = (t30 < 99U) ? t30 : 99U;
    const float t32 = OSCILLATOR_KALMAN_GAINS[t31][0];
    const float t33 = t32 * t26;
    const float t34 = OSCILLATOR_KALMAN_GAINS[t31][1];
    const float t35 = t34 * t26;
    const float t37 = 0.11395966f * t26;
    const float t39 = 0.68907154f * t26;
    const int t41 = t27 == 0U;
    const float t42 = t41 ? t37 : t33;
    const float t43 = t41 ? t39 : t35;
    const float t44 = t15 + t42;
    const float t45 = t22 + t43;

    /* the first sample starts the observer; so does a state beyond all bounds */
    const uint32_t t46 = state->good;
    const int t47 = t46 == 0U;
    const int t48 = (-1e35f <= t44) && (t44 <= 1e35f);
    const int t49 = !t48;
    const int t50 = t47 || t49;
    const int t51 = (-1e35f <= t45) && (t45 <= 1e35f);
    const int t52 = !t51;
    const int t53 = t50 || t52;
    const float t54 = t1 ? t0 : 0.0f;
    const float t55 = t53 ? t54 : t44;
    state->position = t55;
    const float t56 = t53 ? 0.0f : t45;
    state->speed = t56;
    const uint32_t t58 = t53 ? 100U : t30;
    state->left = t58;
    const uint32_t t60 = t1 ? 1U : 0U;
    const uint32_t t61 = (t46 < 101U) ? (t46 + 1U) : 101U;
    const uint32_t t62 = t1 ? t61 : t46;
    const uint32_t t63 = t53 ? t60 : t62;
    state->good = t63;
    const uint32_t t64 = state->clean;
    const uint32_t t65 = (t64 < 231U) ? (t64 + 1U) : 231U;
    const uint32_t t66 = t23 ? t65 : 0U;
    const uint32_t t68 = t53 ? 231U : t66;
    state->clean = t68;

    /* the estimate */
    const int t70 = 100U < t63;
    const int t71 = 230U < t68;
    const oscillator_kalman_status t75 = t71 ? OSCILLATOR_KALMAN_CONVERGED : OSCILLATOR_KALMAN_COASTING;
    const oscillator_kalman_status t76 = t70 ? t75 : OSCILLATOR_KALMAN_CONVERGING;

    estimate->position = t55;
    estimate->speed = t56;
    estimate->status = t76;
}
