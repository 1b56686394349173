/* swing_up.c: Finite-time observer: Speed of a swinging arm whose encoder shows one turn.
 *
 * Generated; swing_up.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "swing_up.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "swing_up.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "swing_up.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

void swing_up_init(swing_up_state *state)
{
    for (uint32_t slot = 0U; slot < 3U; ++slot) {
        state->y[slot] = 0.0f;
    }
    state->newest = 2U;
    state->count = 0U;
    state->coasting = 0U;
    state->ahead_y = 0.0f;
}

void swing_up_step(swing_up_state *state, const swing_up_measurements *measurements,
                   swing_up_estimate *estimate)
{
    /* samples: outside its range, infinite or NaN means missing */
    const uint32_t t0 = state->newest;
    const uint32_t t1 = (t0 < 2U) ? t0 : 2U;
    const uint32_t t2 = state->count;
    const int t4 = 2U < t2;
    const float t5 = measurements->y;
    const int t6 = (-6588397.5f <= t5) && (t5 <= 6588397.5f);
    const float t8 = t5 * 0.15915494f;
    const float t10 = t8 + 1.2582912e7f;
    const float t11 = t10 - 1.2582912e7f;
    const float t13 = t11 * 6.28125f;
    const float t14 = t5 - t13;
    const float t16 = t11 * 0.0019350052f;
    const float t17 = t14 - t16;
    const float t19 = t11 * 3.019916e-7f;
    const float t20 = t17 - t19;

    /* prediction, for a sample that is missing */
    const uint32_t t21 = (t1 < 2U) ? (t1 + 1U) : 0U;
    const float t22 = state->ahead_y;
    const float t23 = state->y[t1];
    const float t24 = t23 + t22;
    const float t25 = t24 * 0.15915494f;
    const float t26 = t25 + 1.2582912e7f;
    const float t27 = t26 - 1.2582912e7f;
    const float t29 = t27 * 6.2831855f;
    const float t30 = t24 - t29;
    const int t31 = (-6.2831855f <= t30) && (t30 <= 6.2831855f);
    const int t32 = t4 && t31;
    const float t33 = t32 ? t30 : t23;
    const float t34 = t6 ? t20 : t33;
    const int t35 = t6 || t32;
    const int t36 = !t35;

    /* how much of the window is good */
    const uint32_t t38 = (t2 < 3U) ? (t2 + 1U) : 3U;
    const uint32_t t39 = t36 ? 0U : t38;
    const uint32_t t40 = t6 ? t38 : 0U;
    const uint32_t t41 = t4 ? t39 : t40;
    state->count = t41;
    const uint32_t t42 = state->coasting;
    const uint32_t t43 = (t42 > 0U) ? (t42 - 1U) : 0U;
    const uint32_t t45 = t6 ? t43 : 3U;
    state->coasting = t45;

    /* into the window */
    state->newest = t21;
    state->y[t21] = t34;

    /* the sums over the window, newest sample first */
    const uint32_t t47 = ((t21 >= 1U) && (t21 < 3U)) ? (t21 - 1U) : 2U;
    const float t48 = state->y[t47];
    const float t49 = t48 - t34;
    const float t50 = t49 * 0.15915494f;
    const float t51 = t50 + 1.2582912e7f;
    const float t52 = t51 - 1.2582912e7f;
    const float t53 = t52 * 6.2831855f;
    const float t54 = t49 - t53;
    const float t55 = 0.0f + t54;
    const float t57 = 0.33333334f * t55;
    const float t58 = 0.0f * t55;
    const uint32_t t59 = ((t47 >= 1U) && (t47 < 3U)) ? (t47 - 1U) : 2U;
    const float t60 = state->y[t59];
    const float t61 = t60 - t48;
    const float t62 = t61 * 0.15915494f;
    const float t63 = t62 + 1.2582912e7f;
    const float t64 = t63 - 1.2582912e7f;
    const float t65 = t64 * 6.2831855f;
    const float t66 = t61 - t65;
    const float t67 = t55 + t66;
    const float t69 = -0.16666667f * t67;
    const float t70 = t57 + t69;
    const float t72 = -100.0f * t67;
    const float t73 = t58 + t72;

    /* the next measurement, as far as it is known */
    const float t75 = 0.005f * t73;
    const float t76 = t70 + t75;
    state->ahead_y = t76;

    /* the estimate; until the window is full, the start */
    const float t77 = t70 + t34;
    const int t78 = 2U < t41;
    const float t79 = t78 ? t77 : t34;
    const float t80 = t78 ? t73 : 0.0f;
    const uint32_t t81 = state->coasting;
    const int t82 = t81 == 0U;
    const swing_up_status t86 = t82 ? SWING_UP_CONVERGED : SWING_UP_COASTING;
    const swing_up_status t87 = t78 ? t86 : SWING_UP_CONVERGING;

    estimate->q = t79;
    estimate->dq = t80;
    estimate->status = t87;
}
