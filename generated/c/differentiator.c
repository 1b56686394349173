/* differentiator.c: Finite-time observer: A signal and three derivatives, all at once every 2.5 s.
 *
 * Generated; differentiator.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "differentiator.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "differentiator.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "differentiator.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* What one part of a step hands to the next. */
typedef struct {
    double t62;
    double t63;
    double t64;
    double t65;
    uint32_t t71;
    uint32_t t76;
    double t84;
    double t88;
    double t90;
    differentiator_status t98;
} differentiator_work;

/* Part 1 of a step. */
static void differentiator_part_1(differentiator_state *state, const differentiator_measurements *measurements, differentiator_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    const double t0 = measurements->y;
    const int t1 = (-1e294 <= t0) && (t0 <= 1e294);

    /* prediction by the plant */
    const double t2 = state->xi1;
    const double t3 = state->xi2;
    const double t4 = state->xi3;
    const double t5 = state->xi4;
    const double t6 = t4 + t5;
    const double t7 = t3 + t6;
    const double t8 = t2 + t7;

    /* correction by the innovation */
    const double t10 = t0 - t8;
    const double t11 = t1 ? t10 : 0.0;
    const uint32_t t12 = state->left;
    const uint32_t t13 = (t12 < 249U) ? t12 : 249U;
    const uint32_t t14 = (t13 > 0U) ? (t13 - 1U) : 0U;
    const int t16 = t13 == 0U;
    const uint32_t t18 = t16 ? 249U : t14;
    const uint32_t t19 = t1 ? t18 : t13;
    const double t20 = (double)t19;
    const double t22 = 0.125 * t20;
    const double t23 = t22 + 0.125;
    const double t24 = t23 * t23;
    const double t25 = t24 * t23;
    const double t26 = t25 * t23;
    const double t28 = 14.375 * t25;
    const double t30 = 77.24609375 * t24;
    const double t32 = 183.89892578125 * t23;
    const double t34 = t32 + 163.6505126953125;
    const double t35 = t30 + t34;
    const double t36 = t28 + t35;
    const double t37 = t26 + t36;
    const double t38 = t11 / t37;
    const double t39 = t36 * t38;
    const double t40 = t35 * t38;
    const double t41 = t34 * t38;
    const double t42 = 163.6505126953125 * t38;
    const double t43 = t8 + t39;
    const double t44 = t7 + t40;
    const double t45 = t6 + t41;
    const double t46 = t5 + t42;

    /* the first sample starts the observer; so does a state beyond all bounds */
    const uint32_t t47 = state->good;
    const int t48 = t47 == 0U;
    const int t49 = (-1e294 <= t43) && (t43 <= 1e294);
    const int t50 = !t49;
    const int t51 = t48 || t50;
    const int t52 = (-1e294 <= t44) && (t44 <= 1e294);
    const int t53 = !t52;
    const int t54 = t51 || t53;
    const int t55 = (-1e294 <= t45) && (t45 <= 1e294);
    const int t56 = !t55;
    const int t57 = t54 || t56;
    const int t58 = (-1e294 <= t46) && (t46 <= 1e294);
    const int t59 = !t58;
    const int t60 = t57 || t59;
    const double t61 = t1 ? t0 : 0.0;
    work->t62 = t60 ? t61 : t43;
    state->xi1 = work->t62;
    work->t63 = t60 ? 0.0 : t44;
    state->xi2 = work->t63;
    work->t64 = t60 ? 0.0 : t45;
    state->xi3 = work->t64;
    work->t65 = t60 ? 0.0 : t46;
    state->xi4 = work->t65;
    const uint32_t t66 = t60 ? 249U : t19;
    state->left = t66;
    const uint32_t t68 = t1 ? 1U : 0U;
    const uint32_t t69 = (t47 < 250U) ? (t47 + 1U) : 250U;
    const uint32_t t70 = t1 ? t69 : t47;
    work->t71 = t60 ? t68 : t70;
    state->good = work->t71;
    const uint32_t t72 = state->clean;
    const uint32_t t73 = (t72 < 191U) ? (t72 + 1U) : 191U;
    const uint32_t t74 = t1 ? t73 : 0U;
    work->t76 = t60 ? 191U : t74;
    state->clean = work->t76;
}

/* Part 2 of a step. */
static void differentiator_part_2(differentiator_work *work)
{
    /* the estimate */
    const double t78 = 100.0 * work->t63;
    const double t80 = 50.0 * work->t64;
    const double t82 = 33.333333333333336 * work->t65;
    const double t83 = t78 + t80;
    work->t84 = t83 + t82;
    const double t86 = 10000.0 * work->t64;
    const double t87 = 10000.0 * work->t65;
    work->t88 = t86 + t87;
    work->t90 = 1000000.0 * work->t65;
    const int t92 = 249U < work->t71;
    const int t93 = 190U < work->t76;
    const differentiator_status t97 = t93 ? DIFFERENTIATOR_CONVERGED : DIFFERENTIATOR_COASTING;
    work->t98 = t92 ? t97 : DIFFERENTIATOR_CONVERGING;
}

void differentiator_init(differentiator_state *state)
{
    state->xi1 = 0.0;
    state->xi2 = 0.0;
    state->xi3 = 0.0;
    state->xi4 = 0.0;
    state->left = 249U;
    state->good = 0U;
    state->clean = 0U;
}

void differentiator_step(differentiator_state *state, const differentiator_measurements *measurements,
                         differentiator_estimate *estimate)
{
    differentiator_work work;
    differentiator_part_1(state, measurements, &work);
    differentiator_part_2(&work);

    estimate->y = work.t62;
    estimate->dy = work.t84;
    estimate->d2y = work.t88;
    estimate->d3y = work.t90;
    estimate->status = work.t98;
}
