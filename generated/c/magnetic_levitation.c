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
#pragma GCC optimize("fp-contract=off")
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
    uint32_t t11;
    float t42;
    uint32_t t51;
    float t105;
    float t106;
    magnetic_levitation_status t113;
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
    work->t11 = (t1 < 40U) ? (t1 + 1U) : 0U;
    const float t12 = t10 * t10;
    const float t14 = state->gap[t1];
    const float t15 = t14 * t14;
    const float t16 = 0.136f * t15;
    const float t17 = t12 / t16;
    const int t18 = (-1e34f <= t17) && (t17 <= 1e34f);
    const float t19 = state->injection[t1];
    const float t20 = t18 ? t17 : t19;
    const float t21 = state->ahead_gap;
    const float t23 = -3.265e-13f * t20;
    const float t24 = t21 + t23;
    const float t25 = t4 ? t24 : t14;
    const float t26 = t6 ? t5 : t25;
    const float t27 = t26 * t26;
    const float t28 = 0.136f * t27;
    const float t29 = t12 / t28;
    const int t30 = (-1e34f <= t29) && (t29 <= 1e34f);
    const float t31 = state->injection_2[t1];
    const float t32 = t30 ? t29 : t31;
    const float t33 = t32 - t20;
    const float t35 = -1.0883333e-13f * t33;
    const float t36 = t24 + t35;
    const int t37 = (0.001f <= t36) && (t36 <= 0.03f);
    const int t38 = t4 && t37;
    const float t39 = t38 ? t36 : t14;
    const int t40 = t6 || t38;
    const int t41 = !t40;
    work->t42 = t6 ? t5 : t39;
    const int t43 = t8 && t18;
    const int t44 = t43 && t30;

    /* how much of the window is good */
    const uint32_t t47 = (t2 < 41U) ? (t2 + 1U) : 41U;
    const uint32_t t48 = t41 ? 0U : t47;
    const uint32_t t49 = t44 ? t47 : 1U;
    const uint32_t t50 = t6 ? t49 : 0U;
    work->t51 = t4 ? t48 : t50;
    state->count = work->t51;
    const uint32_t t52 = state->coasting;
    const uint32_t t53 = (t52 > 0U) ? (t52 - 1U) : 0U;
    const uint32_t t54 = t44 ? t53 : 40U;
    const uint32_t t56 = t6 ? t54 : 41U;
    state->coasting = t56;

    /* into the window */
    state->newest = work->t11;
    state->gap[work->t11] = work->t42;
    state->injection[work->t11] = t20;
    state->injection_2[work->t11] = t32;
}

/* Part 2 of a step. */
static void magnetic_levitation_part_2(magnetic_levitation_state *state, magnetic_levitation_work *work)
{
    /* the sums over the window, newest sample first */
    float t58 = 0.0f;
    float t59 = 0.0f;
    float t60 = 0.0f;
    float t61 = 0.0f;
    float t62 = 0.0f;
    float t63 = 0.0f;
    uint32_t t64 = work->t11;
    for (uint32_t row = 0U; row < 40U; ++row) {
        const float *const gains = MAGNETIC_LEVITATION_WINDOW[row];
        const float t65 = state->gap[t64];
        const float t66 = gains[0];
        const float t67 = t66 * t65;
        const float t68 = t58 + t67;
        const float t69 = gains[1];
        const float t70 = t69 * t65;
        const float t71 = t61 + t70;
        const float t72 = state->injection[t64];
        const float t73 = gains[2];
        const float t74 = t73 * t72;
        const float t75 = t59 + t74;
        const float t76 = gains[3];
        const float t77 = t76 * t72;
        const float t78 = t62 + t77;
        const float t79 = state->injection_2[t64];
        const float t80 = gains[4];
        const float t81 = t80 * t79;
        const float t82 = t60 + t81;
        const float t83 = gains[5];
        const float t84 = t83 * t79;
        const float t85 = t63 + t84;
        const uint32_t t86 = ((t64 >= 1U) && (t64 < 41U)) ? (t64 - 1U) : 40U;
        t58 = t68;
        t59 = t75;
        t60 = t82;
        t61 = t71;
        t62 = t78;
        t63 = t85;
        t64 = t86;
    }
    const float t87 = state->gap[t64];
    const float t88 = 0.0f * t87;
    const float t89 = t58 + t88;
    const float t91 = -250.0f * t87;
    const float t92 = t61 + t91;
    const float t93 = t89 + t59;
    const float t94 = t93 + t60;
    const float t96 = t92 + t62;
    const float t97 = t96 + t63;
    const float t98 = t97 + 0.01962f;

    /* the next measurement, as far as it is known */
    const float t100 = 0.0001f * t98;
    const float t102 = t94 + t100;
    const float t103 = t102 + 4.905e-8f;
    state->ahead_gap = t103;

    /* the estimate; until the window is full, the start */
    const int t104 = 40U < work->t51;
    work->t105 = t104 ? t94 : work->t42;
    work->t106 = t104 ? t98 : 0.0f;
    const uint32_t t107 = state->coasting;
    const int t108 = t107 == 0U;
    const magnetic_levitation_status t112 = t108 ? MAGNETIC_LEVITATION_CONVERGED : MAGNETIC_LEVITATION_COASTING;
    work->t113 = t104 ? t112 : MAGNETIC_LEVITATION_CONVERGING;
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

    estimate->gap = work.t105;
    estimate->speed = work.t106;
    estimate->status = work.t113;
}
