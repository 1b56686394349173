/* low_pass.c: Finite-time observer: Speed of a hobby motor from a magnetic encoder of 12 bits.
 *
 * Generated; low_pass.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "low_pass.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "low_pass.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "low_pass.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

void low_pass_init(low_pass_state *state)
{
    state->last_angle = 0.0f;
    state->since = 0U;
    state->quotient = 0.0f;
    state->dangle = 0.0f;
    state->good = 0U;
    state->clean = 0U;
}

void low_pass_step(low_pass_state *state, const low_pass_measurements *measurements,
                   low_pass_estimate *estimate)
{
    /* the sample: outside its range, infinite or NaN means missing */
    const float t0 = measurements->angle;
    const int t1 = (-6588397.5f <= t0) && (t0 <= 6588397.5f);
    const float t3 = t0 * 0.15915494f;
    const float t5 = t3 + 1.2582912e7f;
    const float t6 = t5 - 1.2582912e7f;
    const float t8 = t6 * 6.28125f;
    const float t9 = t0 - t8;
    const float t11 = t6 * 0.0019350052f;
    const float t12 = t9 - t11;
    const float t14 = t6 * 3.019916e-7f;
    const float t15 = t12 - t14;
    const uint32_t t17 = state->good;
    const int t18 = 0U < t17;

    /* the quotient: new where the sample has changed */
    const float t21 = state->last_angle;
    const float t22 = t15 - t21;
    const float t23 = t22 * 0.15915494f;
    const float t24 = t23 + 1.2582912e7f;
    const float t25 = t24 - 1.2582912e7f;
    const float t27 = t25 * 6.2831855f;
    const float t28 = t22 - t27;
    const int t29 = t1 && t18;
    const float t30 = t29 ? t28 : 0.0f;
    const int t31 = 0.0f < t30;
    const int t32 = t30 < 0.0f;
    const int t33 = t31 || t32;
    const uint32_t t34 = state->since;
    const uint32_t t35 = (t34 < 4294967295U) ? (t34 + 1U) : 4294967295U;
    const float t36 = (float)t35;
    const float t37 = 0.001f * t36;
    const float t38 = t30 / t37;
    const float t39 = state->quotient;
    const float t40 = t33 ? t38 : t39;
    const int t41 = !t18;
    const int t42 = t33 || t41;
    const uint32_t t43 = t42 ? 0U : t35;
    const float t44 = t1 ? t15 : t21;
    state->quotient = t40;
    state->since = t43;
    state->last_angle = t44;

    /* the filter */
    const float t45 = state->dangle;
    const float t47 = 0.16666667f * t40;
    const float t49 = 0.8333333f * t45;
    const float t50 = t49 + t47;
    state->dangle = t50;
    const float t51 = state->last_angle;
    const uint32_t t52 = (t17 < 77U) ? (t17 + 1U) : 77U;
    const uint32_t t53 = t1 ? t52 : t17;
    state->good = t53;
    const uint32_t t55 = state->clean;
    const uint32_t t56 = (t55 < 76U) ? (t55 + 1U) : 76U;
    const uint32_t t57 = t1 ? t56 : 0U;
    const uint32_t t58 = t18 ? t57 : 76U;
    state->clean = t58;
    const int t60 = 76U < t53;
    const int t61 = 75U < t58;
    const low_pass_status t65 = t61 ? LOW_PASS_CONVERGED : LOW_PASS_COASTING;
    const low_pass_status t66 = t60 ? t65 : LOW_PASS_CONVERGING;

    estimate->angle = t51;
    estimate->dangle = t50;
    estimate->status = t66;
}
