/* alpha_beta.c: Finite-time observer: Climb rate from a barometer.
 *
 * Generated; alpha_beta.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "alpha_beta.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "alpha_beta.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "alpha_beta.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

void alpha_beta_init(alpha_beta_state *state)
{
    state->altitude = 0.0f;
    state->daltitude = 0.0f;
    state->good = 0U;
    state->clean = 0U;
}

void alpha_beta_step(alpha_beta_state *state, const alpha_beta_measurements *measurements,
                     alpha_beta_estimate *estimate)
{
    /* samples: outside its range, infinite or NaN means missing */
    const float t0 = measurements->altitude;
    const int t1 = (-500.0f <= t0) && (t0 <= 12000.0f);

    /* prediction by the plant */
    const float t2 = state->altitude;
    const float t3 = state->daltitude;
    const float t5 = 0.02f * t3;
    const float t6 = t2 + t5;

    /* correction by the innovation */
    const int t7 = (-500.0f <= t6) && (t6 <= 12000.0f);
    const int t8 = t1 || t7;
    const int t9 = !t8;
    const float t11 = t0 - t6;
    const float t12 = t1 ? t11 : 0.0f;
    const float t14 = 0.1f * t12;
    const float t16 = 0.13167019f * t12;
    const float t17 = t6 + t14;
    const float t18 = t3 + t16;

    /* the first sample starts the observer; so does a state beyond all bounds */
    const uint32_t t20 = state->good;
    const int t21 = t20 == 0U;
    const int t22 = t21 || t9;
    const int t23 = (-1e37f <= t17) && (t17 <= 1e37f);
    const int t24 = !t23;
    const int t25 = t22 || t24;
    const int t26 = (-1e37f <= t18) && (t18 <= 1e37f);
    const int t27 = !t26;
    const int t28 = t25 || t27;
    const float t29 = t1 ? t0 : 0.0f;
    const float t30 = t28 ? t29 : t17;
    state->altitude = t30;
    const float t31 = t28 ? 0.0f : t18;
    state->daltitude = t31;
    const uint32_t t33 = t1 ? 1U : 0U;
    const uint32_t t34 = (t20 < 319U) ? (t20 + 1U) : 319U;
    const uint32_t t35 = t1 ? t34 : t20;
    const uint32_t t36 = t28 ? t33 : t35;
    state->good = t36;
    const uint32_t t37 = state->clean;
    const uint32_t t38 = (t37 < 379U) ? (t37 + 1U) : 379U;
    const uint32_t t39 = t1 ? t38 : 0U;
    const uint32_t t41 = t28 ? 379U : t39;
    state->clean = t41;

    /* the estimate */
    const int t44 = 318U < t36;
    const int t45 = 378U < t41;
    const alpha_beta_status t49 = t45 ? ALPHA_BETA_CONVERGED : ALPHA_BETA_COASTING;
    const alpha_beta_status t50 = t44 ? t49 : ALPHA_BETA_CONVERGING;

    estimate->altitude = t30;
    estimate->daltitude = t31;
    estimate->status = t50;
}
