/* fixed_time_linear.c: Finite-time observer: A shaker table's position, velocity and the force on it, from its position alone, after three samples.
 *
 * Generated; fixed_time_linear.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "fixed_time_linear.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "fixed_time_linear.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "fixed_time_linear.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

void fixed_time_linear_init(fixed_time_linear_state *state)
{
    state->x = 0.0;
    state->v = 0.0;
    state->i = 0.0;
    state->good = 0U;
    state->clean = 0U;
    state->last_u = 0.0;
}

void fixed_time_linear_step(fixed_time_linear_state *state, const fixed_time_linear_measurements *measurements,
                            const fixed_time_linear_inputs *inputs, fixed_time_linear_estimate *estimate)
{
    /* samples: outside its range, infinite or NaN means missing */
    const double t0 = measurements->x;
    const int t1 = (-0.05 <= t0) && (t0 <= 0.05);
    const double t2 = inputs->u;
    const int t3 = (-1e302 <= t2) && (t2 <= 1e302);
    const double t4 = state->last_u;
    const double t5 = t3 ? t2 : t4;

    /* prediction by the plant */
    const double t6 = state->x;
    const double t7 = state->v;
    const double t8 = state->i;
    const double t10 = 0.9982041332477858 * t6;
    const double t12 = 0.001992815790884861 * t7;
    const double t14 = 7.850168344964657e-5 * t8;
    const double t16 = 1.314616648760578e-6 * t5;
    const double t17 = t10 + t12;
    const double t18 = t17 + t14;
    const double t19 = t18 + t16;
    const double t21 = -1.7935342117963746 * t6;
    const double t23 = 0.9922256858751313 * t7;
    const double t25 = 0.07775008954915326 * t8;
    const double t27 = 0.0019625420862411642 * t5;
    const double t28 = t21 + t23;
    const double t29 = t28 + t25;
    const double t30 = t29 + t27;
    const double t32 = 0.951229424500714 * t8;
    const double t34 = 0.04877057549928599 * t5;
    const double t35 = t32 + t34;
    state->last_u = t5;
    const int t36 = t3 && t1;

    /* correction by the innovation */
    const int t37 = (-0.05 <= t19) && (t19 <= 0.05);
    const int t38 = t1 || t37;
    const int t39 = !t38;
    const double t41 = t0 - t19;
    const double t42 = t1 ? t41 : 0.0;
    const double t44 = 740.3052731775781 * t42;
    const double t46 = 5963.73289513634 * t42;
    const double t47 = t19 + t42;
    const double t48 = t30 + t44;
    const double t49 = t35 + t46;

    /* the first sample starts the observer; so does a state beyond all bounds */
    const uint32_t t51 = state->good;
    const int t52 = t51 == 0U;
    const int t53 = t52 || t39;
    const int t54 = (-1e302 <= t47) && (t47 <= 1e302);
    const int t55 = !t54;
    const int t56 = t53 || t55;
    const int t57 = (-1e302 <= t48) && (t48 <= 1e302);
    const int t58 = !t57;
    const int t59 = t56 || t58;
    const int t60 = (-1e302 <= t49) && (t49 <= 1e302);
    const int t61 = !t60;
    const int t62 = t59 || t61;
    const double t63 = t1 ? t0 : 0.0;
    const double t64 = t62 ? t63 : t47;
    state->x = t64;
    const double t65 = t62 ? 0.0 : t48;
    state->v = t65;
    const double t66 = t62 ? 0.0 : t49;
    state->i = t66;
    const uint32_t t68 = t1 ? 1U : 0U;
    const uint32_t t69 = (t51 < 3U) ? (t51 + 1U) : 3U;
    const uint32_t t70 = t1 ? t69 : t51;
    const uint32_t t71 = t62 ? t68 : t70;
    state->good = t71;
    const uint32_t t72 = state->clean;
    const uint32_t t73 = (t72 < 3U) ? (t72 + 1U) : 3U;
    const uint32_t t74 = t36 ? t73 : 0U;
    const uint32_t t76 = t62 ? 3U : t74;
    state->clean = t76;

    /* the estimate */
    const int t78 = 2U < t71;
    const int t79 = 2U < t76;
    const fixed_time_linear_status t83 = t79 ? FIXED_TIME_LINEAR_CONVERGED : FIXED_TIME_LINEAR_COASTING;
    const fixed_time_linear_status t84 = t78 ? t83 : FIXED_TIME_LINEAR_CONVERGING;

    estimate->x = t64;
    estimate->v = t65;
    estimate->i = t66;
    estimate->status = t84;
}
