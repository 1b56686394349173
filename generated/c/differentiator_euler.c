/* differentiator_euler.c: Finite-time observer: The first two derivatives of a temperature by implicit Euler's backward differences.
 *
 * Generated; differentiator_euler.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "differentiator_euler.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "differentiator_euler.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "differentiator_euler.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* What one part of a step hands to the next. */
typedef struct {
    float t70;
    float t71;
    float t72;
    uint32_t t79;
    uint32_t t84;
    float t86;
    float t88;
    differentiator_euler_status t96;
} differentiator_euler_work;

/* Part 1 of a step. */
static void differentiator_euler_part_1(differentiator_euler_state *state, const differentiator_euler_measurements *measurements, differentiator_euler_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    const float t0 = measurements->temperature;
    const int t1 = (200.0f <= t0) && (t0 <= 400.0f);

    /* prediction by the plant */
    const float t2 = state->xi1;
    const float t3 = state->xi2;
    const float t4 = state->xi3;
    const float t5 = t3 + t4;
    const float t6 = t2 + t5;

    /* correction by the innovation */
    const int t7 = (200.0f <= t6) && (t6 <= 400.0f);
    const int t8 = t1 || t7;
    const int t9 = !t8;
    const float t11 = t0 - t6;
    const float t12 = t1 ? t11 : 0.0f;
    const uint32_t t13 = state->left;
    const uint32_t t14 = (t13 < 105U) ? t13 : 105U;
    const uint32_t t15 = (t14 > 0U) ? (t14 - 1U) : 0U;
    const uint32_t t16 = t1 ? t15 : t14;
    const float t17 = (float)t16;
    const float t19 = 0.03125f * t17;
    const float t21 = t19 + 0.46875f;
    const float t22 = t21 * t21;
    const float t23 = t22 * t21;
    const float t24 = 0.46875f * t22;
    const float t26 = 0.15f * t23;
    const float t27 = t24 + t26;
    const float t29 = 0.05859375f * t21;
    const float t31 = 0.046875f * t22;
    const float t33 = 0.0075f * t23;
    const float t34 = t29 + t31;
    const float t35 = t34 + t33;
    const float t38 = 0.0029296875f * t21;
    const float t40 = 0.001171875f * t22;
    const float t42 = 0.000125f * t23;
    const float t43 = 0.0018310547f + t38;
    const float t44 = t43 + t40;
    const float t45 = t44 + t42;
    const float t46 = t35 + t45;
    const float t47 = t27 + t46;
    const float t48 = t23 + t47;
    const float t49 = t12 / t48;
    const float t50 = t47 * t49;
    const float t51 = t46 * t49;
    const float t52 = t45 * t49;
    const float t53 = t6 + t50;
    const float t54 = t5 + t51;
    const float t55 = t4 + t52;

    /* the first sample starts the observer; so does a state beyond all bounds */
    const uint32_t t57 = state->good;
    const int t58 = t57 == 0U;
    const int t59 = t58 || t9;
    const int t60 = (-1e34f <= t53) && (t53 <= 1e34f);
    const int t61 = !t60;
    const int t62 = t59 || t61;
    const int t63 = (-1e34f <= t54) && (t54 <= 1e34f);
    const int t64 = !t63;
    const int t65 = t62 || t64;
    const int t66 = (-1e34f <= t55) && (t55 <= 1e34f);
    const int t67 = !t66;
    const int t68 = t65 || t67;
    const float t69 = t1 ? t0 : 0.0f;
    work->t70 = t68 ? t69 : t53;
    state->xi1 = work->t70;
    work->t71 = t68 ? 0.0f : t54;
    state->xi2 = work->t71;
    work->t72 = t68 ? 0.0f : t55;
    state->xi3 = work->t72;
    const uint32_t t74 = t68 ? 105U : t16;
    state->left = t74;
    const uint32_t t76 = t1 ? 1U : 0U;
    const uint32_t t77 = (t57 < 106U) ? (t57 + 1U) : 106U;
    const uint32_t t78 = t1 ? t77 : t57;
    work->t79 = t68 ? t76 : t78;
    state->good = work->t79;
    const uint32_t t80 = state->clean;
    const uint32_t t81 = (t80 < 87U) ? (t80 + 1U) : 87U;
    const uint32_t t82 = t1 ? t81 : 0U;
    work->t84 = t68 ? 87U : t82;
    state->clean = work->t84;
}

/* Part 2 of a step. */
static void differentiator_euler_part_2(differentiator_euler_work *work)
{
    /* the estimate */
    work->t86 = 2.0f * work->t71;
    work->t88 = 4.0f * work->t72;
    const int t90 = 105U < work->t79;
    const int t91 = 86U < work->t84;
    const differentiator_euler_status t95 = t91 ? DIFFERENTIATOR_EULER_CONVERGED : DIFFERENTIATOR_EULER_COASTING;
    work->t96 = t90 ? t95 : DIFFERENTIATOR_EULER_CONVERGING;
}

void differentiator_euler_init(differentiator_euler_state *state)
{
    state->xi1 = 0.0f;
    state->xi2 = 0.0f;
    state->xi3 = 0.0f;
    state->left = 105U;
    state->good = 0U;
    state->clean = 0U;
}

void differentiator_euler_step(differentiator_euler_state *state, const differentiator_euler_measurements *measurements,
                               differentiator_euler_estimate *estimate)
{
    differentiator_euler_work work;
    differentiator_euler_part_1(state, measurements, &work);
    differentiator_euler_part_2(&work);

    estimate->temperature = work.t70;
    estimate->dtemperature = work.t86;
    estimate->d2temperature = work.t88;
    estimate->status = work.t96;
}
