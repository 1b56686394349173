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
#pragma GCC optimize("fp-contract=off")
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
    state->last_u = t5;

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
    const int t36 = t3 && t1;

    /* correction by the innovation */
    const double t38 = t0 - t19;
    const double t39 = t1 ? t38 : 0.0;
    const double t41 = 740.3052731775781 * t39;
    const double t43 = 5963.73289513634 * t39;
    const double t44 = t19 + t39;
    const double t45 = t30 + t41;
    const double t46 = t35 + t43;

    /* the first sample starts the observer; so does a state beyond all bounds */
    const uint32_t t48 = state->good;
    const int t49 = t48 == 0U;
    const int t50 = (-1e302 <= t44) && (t44 <= 1e302);
    const int t51 = !t50;
    const int t52 = t49 || t51;
    const int t53 = (-1e302 <= t45) && (t45 <= 1e302);
    const int t54 = !t53;
    const int t55 = t52 || t54;
    const int t56 = (-1e302 <= t46) && (t46 <= 1e302);
    const int t57 = !t56;
    const int t58 = t55 || t57;
    const double t59 = t1 ? t0 : 0.0;
    const double t60 = t58 ? t59 : t44;
    state->x = t60;
    const double t61 = t58 ? 0.0 : t45;
    state->v = t61;
    const double t62 = t58 ? 0.0 : t46;
    state->i = t62;
    const uint32_t t64 = t1 ? 1U : 0U;
    const uint32_t t65 = (t48 < 3U) ? (t48 + 1U) : 3U;
    const uint32_t t66 = t1 ? t65 : t48;
    const uint32_t t67 = t58 ? t64 : t66;
    state->good = t67;
    const uint32_t t68 = state->clean;
    const uint32_t t69 = (t68 < 3U) ? (t68 + 1U) : 3U;
    const uint32_t t70 = t36 ? t69 : 0U;
    const uint32_t t71 = t58 ? t64 : t70;
    state->clean = t71;

    /* the estimate */
    const int t76 = 2U < t67;
    const int t77 = 2U < t71;
    const fixed_time_linear_status t78 = t77 ? FIXED_TIME_LINEAR_CONVERGED : FIXED_TIME_LINEAR_COASTING;
    const fixed_time_linear_status t79 = t76 ? t78 : FIXED_TIME_LINEAR_CONVERGING;

    estimate->x = t60;
    estimate->v = t61;
    estimate->i = t62;
    estimate->status = t79;
}
