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
#pragma GCC optimize("fp-contract=off")
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
    float t66;
    float t81;
    float t83;
    differentiator_euler_status t90;
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
    const float t8 = t0 - t6;
    const float t9 = t1 ? t8 : 0.0f;
    const uint32_t t10 = state->left;
    const uint32_t t11 = (t10 < 105U) ? t10 : 105U;
    const uint32_t t12 = (t11 > 0U) ? (t11 - 1U) : 0U;
    const uint32_t t13 = t1 ? t12 : t11;
    const float t14 = (float)t13;
    const float t16 = 0.03125f * t14;
    const float t18 = t16 + 0.46875f;
    const float t19 = t18 * t18;
    const float t20 = t19 * t18;
    const float t21 = 0.46875f * t19;
    const float t23 = 0.15f * t20;
    const float t24 = t21 + t23;
    const float t26 = 0.05859375f * t18;
    const float t28 = 0.046875f * t19;
    const float t30 = 0.0075f * t20;
    const float t31 = t26 + t28;
    const float t32 = t31 + t30;
    const float t35 = 0.0029296875f * t18;
    const float t37 = 0.001171875f * t19;
    const float t39 = 0.000125f * t20;
    const float t40 = 0.0018310547f + t35;
    const float t41 = t40 + t37;
    const float t42 = t41 + t39;
    const float t43 = t32 + t42;
    const float t44 = t24 + t43;
    const float t45 = t20 + t44;
    const float t46 = t9 / t45;
    const float t47 = t44 * t46;
    const float t48 = t43 * t46;
    const float t49 = t42 * t46;
    const float t50 = t6 + t47;
    const float t51 = t5 + t48;
    const float t52 = t4 + t49;

    /* the first sample starts the observer; so does a state beyond all bounds */
    const uint32_t t54 = state->good;
    const int t55 = t54 == 0U;
    const int t56 = (-1e34f <= t50) && (t50 <= 1e34f);
    const int t57 = !t56;
    const int t58 = t55 || t57;
    const int t59 = (-1e34f <= t51) && (t51 <= 1e34f);
    const int t60 = !t59;
    const int t61 = t58 || t60;
    const int t62 = (-1e34f <= t52) && (t52 <= 1e34f);
    const int t63 = !t62;
    const int t64 = t61 || t63;
    const float t65 = t1 ? t0 : 0.0f;
    work->t66 = t64 ? t65 : t50;
    state->xi1 = work->t66;
    const float t67 = t64 ? 0.0f : t51;
    state->xi2 = t67;
    const float t68 = t64 ? 0.0f : t52;
    state->xi3 = t68;
    const uint32_t t70 = t64 ? 105U : t13;
    state->left = t70;
    const uint32_t t72 = t1 ? 1U : 0U;
    const uint32_t t73 = (t54 < 106U) ? (t54 + 1U) : 106U;
    const uint32_t t74 = t1 ? t73 : t54;
    const uint32_t t75 = t64 ? t72 : t74;
    state->good = t75;
    const uint32_t t76 = state->clean;
    const uint32_t t77 = (t76 < 106U) ? (t76 + 1U) : 106U;
    const uint32_t t78 = t1 ? t77 : 0U;
    const uint32_t t79 = t64 ? t72 : t78;
    state->clean = t79;

    /* the estimate */
    work->t81 = 2.0f * t67;
    work->t83 = 4.0f * t68;
    const int t87 = 105U < t75;
    const int t88 = 105U < t79;
    const differentiator_euler_status t89 = t88 ? DIFFERENTIATOR_EULER_CONVERGED : DIFFERENTIATOR_EULER_COASTING;
    work->t90 = t87 ? t89 : DIFFERENTIATOR_EULER_CONVERGING;
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

    estimate->temperature = work.t66;
    estimate->dtemperature = work.t81;
    estimate->d2temperature = work.t83;
    estimate->status = work.t90;
}
