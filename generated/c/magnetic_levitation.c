/* magnetic_levitation.c: Finite-time observer: Ball under an electromagnet, unstable, force nonlinear in gap and current.
 *
 * Generated; magnetic_levitation.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "magnetic_levitation.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "magnetic_levitation.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "magnetic_levitation.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* weights by age, from age 0
 *   [0] gap from gap
 *   [1] speed from gap
 *   [2] gap from current^2/(2*0.068*gap^2) at the start
 *   [3] speed from current^2/(2*0.068*gap^2) at the start
 *   [4] gap from current^2/(2*0.068*gap^2) at the end
 *   [5] speed from current^2/(2*0.068*gap^2) at the end
 */
static const float MAGNETIC_LEVITATION_WINDOW[40][6] = {
    { 1.0f, 250.0f, 0.0f, -3.2105834e-9f, 0.0f, -3.2377916e-9f },
    { 0.0f, 0.0f, 0.0f, -3.1289584e-9f, 0.0f, -3.1561667e-9f },
    { 0.0f, 0.0f, 0.0f, -3.0473333e-9f, 0.0f, -3.0745417e-9f },
    { 0.0f, 0.0f, 0.0f, -2.9657083e-9f, 0.0f, -2.9929166e-9f },
    { 0.0f, 0.0f, 0.0f, -2.8840834e-9f, 0.0f, -2.9112917e-9f },
    { 0.0f, 0.0f, 0.0f, -2.8024583e-9f, 0.0f, -2.8296667e-9f },
    { 0.0f, 0.0f, 0.0f, -2.7208333e-9f, 0.0f, -2.7480416e-9f },
    { 0.0f, 0.0f, 0.0f, -2.6392084e-9f, 0.0f, -2.6664166e-9f },
    { 0.0f, 0.0f, 0.0f, -2.5575833e-9f, 0.0f, -2.5847917e-9f },
    { 0.0f, 0.0f, 0.0f, -2.4759583e-9f, 0.0f, -2.5031666e-9f },
    { 0.0f, 0.0f, 0.0f, -2.3943334e-9f, 0.0f, -2.4215416e-9f },
    { 0.0f, 0.0f, 0.0f, -2.3127082e-9f, 0.0f, -2.3399167e-9f },
    { 0.0f, 0.0f, 0.0f, -2.2310833e-9f, 0.0f, -2.2582918e-9f },
    { 0.0f, 0.0f, 0.0f, -2.1494584e-9f, 0.0f, -2.1766666e-9f },
    { 0.0f, 0.0f, 0.0f, -2.0678332e-9f, 0.0f, -2.0950417e-9f },
    { 0.0f, 0.0f, 0.0f, -1.9862083e-9f, 0.0f, -2.0134168e-9f },
    { 0.0f, 0.0f, 0.0f, -1.9045834e-9f, 0.0f, -1.9317916e-9f },
    { 0.0f, 0.0f, 0.0f, -1.8229583e-9f, 0.0f, -1.8501667e-9f },
    { 0.0f, 0.0f, 0.0f, -1.7413333e-9f, 0.0f, -1.7685416e-9f },
    { 0.0f, 0.0f, 0.0f, -1.6597084e-9f, 0.0f, -1.6869167e-9f },
    { 0.0f, 0.0f, 0.0f, -1.5780833e-9f, 0.0f, -1.6052917e-9f },
    { 0.0f, 0.0f, 0.0f, -1.4964583e-9f, 0.0f, -1.5236666e-9f },
    { 0.0f, 0.0f, 0.0f, -1.4148334e-9f, 0.0f, -1.4420417e-9f },
    { 0.0f, 0.0f, 0.0f, -1.3332083e-9f, 0.0f, -1.3604167e-9f },
    { 0.0f, 0.0f, 0.0f, -1.2515833e-9f, 0.0f, -1.2787916e-9f },
    { 0.0f, 0.0f, 0.0f, -1.1699584e-9f, 0.0f, -1.1971667e-9f },
    { 0.0f, 0.0f, 0.0f, -1.0883333e-9f, 0.0f, -1.1155417e-9f },
    { 0.0f, 0.0f, 0.0f, -1.0067084e-9f, 0.0f, -1.0339166e-9f },
    { 0.0f, 0.0f, 0.0f, -9.2508334e-10f, 0.0f, -9.522917e-10f },
    { 0.0f, 0.0f, 0.0f, -8.4345836e-10f, 0.0f, -8.7066665e-10f },
    { 0.0f, 0.0f, 0.0f, -7.618333e-10f, 0.0f, -7.8904167e-10f },
    { 0.0f, 0.0f, 0.0f, -6.8020833e-10f, 0.0f, -7.074167e-10f },
    { 0.0f, 0.0f, 0.0f, -5.9858335e-10f, 0.0f, -6.2579164e-10f },
    { 0.0f, 0.0f, 0.0f, -5.169583e-10f, 0.0f, -5.4416666e-10f },
    { 0.0f, 0.0f, 0.0f, -4.3533332e-10f, 0.0f, -4.6254167e-10f },
    { 0.0f, 0.0f, 0.0f, -3.5370834e-10f, 0.0f, -3.8091666e-10f },
    { 0.0f, 0.0f, 0.0f, -2.7208333e-10f, 0.0f, -2.9929167e-10f },
    { 0.0f, 0.0f, 0.0f, -1.9045833e-10f, 0.0f, -2.1766666e-10f },
    { 0.0f, 0.0f, 0.0f, -1.0883333e-10f, 0.0f, -1.3604166e-10f },
    { 0.0f, 0.0f, 0.0f, -2.7208333e-11f, 0.0f, -5.4416666e-11f }
};

/* What one part of a step hands to the next. */
typedef struct {
    uint32_t t20;
    float t44;
    uint32_t t53;
    float t107;
    float t108;
    magnetic_levitation_status t115;
} magnetic_levitation_work;

/* Part 1 of a step. */
static void magnetic_levitation_part_1(magnetic_levitation_state *state, const magnetic_levitation_measurements *measurements, const magnetic_levitation_inputs *inputs, magnetic_levitation_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    const uint32_t t0 = state->newest;
    const uint32_t t1 = (t0 < 40U) ? t0 : 40U;
    const uint32_t t2 = state->count;
    const int t4 = 40U < t2;
    const float t5 = measurements->gap;
    const int t6 = (0.001f <= t5) && (t5 <= 0.03f);
    const float t7 = inputs->current;
    const int t8 = (-1e34f <= t7) && (t7 <= 1e34f);
    const float t9 = state->last_current;
    const float t10 = t8 ? t7 : t9;
    state->last_current = t10;

    /* prediction, for a sample that is missing */
    const float t11 = t10 * t10;
    const float t13 = state->gap[t1];
    const float t14 = t13 * t13;
    const float t15 = 0.136f * t14;
    const float t16 = t11 / t15;
    const int t17 = (-1e34f <= t16) && (t16 <= 1e34f);
    const float t18 = state->injection[t1];
    const float t19 = t17 ? t16 : t18;
    work->t20 = (t1 < 40U) ? (t1 + 1U) : 0U;
    const float t21 = state->ahead_gap;
    const float t23 = -3.265e-13f * t19;
    const float t24 = t21 + t23;
    const int t25 = (0.001f <= t24) && (t24 <= 0.03f);
    const int t26 = t4 && t25;
    const float t27 = t26 ? t24 : t13;
    const float t28 = t6 ? t5 : t27;
    const float t29 = t28 * t28;
    const float t30 = 0.136f * t29;
    const float t31 = t11 / t30;
    const int t32 = (-1e34f <= t31) && (t31 <= 1e34f);
    const float t33 = state->injection_2[t1];
    const float t34 = t32 ? t31 : t33;
    const float t35 = t34 - t19;
    const float t37 = -1.0883333e-13f * t35;
    const float t38 = t24 + t37;
    const int t39 = (0.001f <= t38) && (t38 <= 0.03f);
    const int t40 = t4 && t39;
    const float t41 = t40 ? t38 : t13;
    const int t42 = t6 || t40;
    const int t43 = !t42;
    work->t44 = t6 ? t5 : t41;
    const int t45 = t8 && t17;
    const int t46 = t45 && t32;

    /* how much of the window is good */
    const uint32_t t49 = (t2 < 41U) ? (t2 + 1U) : 41U;
    const uint32_t t50 = t43 ? 0U : t49;
    const uint32_t t51 = t46 ? t49 : 1U;
    const uint32_t t52 = t6 ? t51 : 0U;
    work->t53 = t4 ? t50 : t52;
    state->count = work->t53;
    const uint32_t t54 = state->coasting;
    const uint32_t t55 = (t54 > 0U) ? (t54 - 1U) : 0U;
    const uint32_t t56 = t46 ? t55 : 40U;
    const uint32_t t58 = t6 ? t56 : 41U;
    state->coasting = t58;

    /* into the window */
    state->newest = work->t20;
    state->gap[work->t20] = work->t44;
    state->injection[work->t20] = t19;
    state->injection_2[work->t20] = t34;
}

/* Part 2 of a step. */
static void magnetic_levitation_part_2(magnetic_levitation_state *state, magnetic_levitation_work *work)
{
    /* the sums over the window, newest sample first */
    float t60 = 0.0f;
    float t61 = 0.0f;
    float t62 = 0.0f;
    float t63 = 0.0f;
    float t64 = 0.0f;
    float t65 = 0.0f;
    uint32_t t66 = work->t20;
    for (uint32_t row = 0U; row < 40U; ++row) {
        const float *const gains = MAGNETIC_LEVITATION_WINDOW[row];
        const float t67 = state->gap[t66];
        const float t68 = gains[0];
        const float t69 = t68 * t67;
        const float t70 = t60 + t69;
        const float t71 = gains[1];
        const float t72 = t71 * t67;
        const float t73 = t63 + t72;
        const float t74 = state->injection[t66];
        const float t75 = gains[2];
        const float t76 = t75 * t74;
        const float t77 = t61 + t76;
        const float t78 = gains[3];
        const float t79 = t78 * t74;
        const float t80 = t64 + t79;
        const float t81 = state->injection_2[t66];
        const float t82 = gains[4];
        const float t83 = t82 * t81;
        const float t84 = t62 + t83;
        const float t85 = gains[5];
        const float t86 = t85 * t81;
        const float t87 = t65 + t86;
        const uint32_t t88 = ((t66 >= 1U) && (t66 < 41U)) ? (t66 - 1U) : 40U;
        t60 = t70;
        t61 = t77;
        t62 = t84;
        t63 = t73;
        t64 = t80;
        t65 = t87;
        t66 = t88;
    }
    const float t89 = state->gap[t66];
    const float t90 = 0.0f * t89;
    const float t91 = t60 + t90;
    const float t93 = -250.0f * t89;
    const float t94 = t63 + t93;
    const float t95 = t91 + t61;
    const float t96 = t95 + t62;
    const float t98 = t94 + t64;
    const float t99 = t98 + t65;
    const float t100 = t99 + 0.01962f;

    /* the next measurement, as far as it is known */
    const float t102 = 0.0001f * t100;
    const float t104 = t96 + t102;
    const float t105 = t104 + 4.905e-8f;
    state->ahead_gap = t105;

    /* the estimate; until the window is full, the start */
    const int t106 = 40U < work->t53;
    work->t107 = t106 ? t96 : work->t44;
    work->t108 = t106 ? t100 : 0.0f;
    const uint32_t t109 = state->coasting;
    const int t110 = t109 == 0U;
    const magnetic_levitation_status t114 = t110 ? MAGNETIC_LEVITATION_CONVERGED : MAGNETIC_LEVITATION_COASTING;
    work->t115 = t106 ? t114 : MAGNETIC_LEVITATION_CONVERGING;
}

void magnetic_levitation_init(magnetic_levitation_state *state)
{
    for (uint32_t slot = 0U; slot < 41U; ++slot) {
        state->gap[slot] = 0.01f;
    }
    for (uint32_t slot = 0U; slot < 41U; ++slot) {
        state->injection[slot] = 0.0f;
    }
    for (uint32_t slot = 0U; slot < 41U; ++slot) {
        state->injection_2[slot] = 0.0f;
    }
    state->last_current = 0.0f;
    state->newest = 40U;
    state->count = 0U;
    state->coasting = 0U;
    state->ahead_gap = 0.0f;
}

void magnetic_levitation_step(magnetic_levitation_state *state, const magnetic_levitation_measurements *measurements,
                              const magnetic_levitation_inputs *inputs, magnetic_levitation_estimate *estimate)
{
    magnetic_levitation_work work;
    magnetic_levitation_part_1(state, measurements, inputs, &work);
    magnetic_levitation_part_2(state, &work);

    estimate->gap = work.t107;
    estimate->speed = work.t108;
    estimate->status = work.t115;
}
