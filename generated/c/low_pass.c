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
#pragma GCC optimize("fp-contract=off")
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
    const int t1 = (-1e33f <= t0) && (t0 <= 1e33f);
    const uint32_t t3 = state->good;
    const int t4 = 0U < t3;

    /* the quotient: new where the sample has changed */
    const float t7 = state->last_angle;
    const float t8 = t0 - t7;
    const int t9 = t1 && t4;
    const float t10 = t9 ? t8 : 0.0f;
    const int t11 = 0.0f < t10;
    const int t12 = t10 < 0.0f;
    const int t13 = t11 || t12;
    const uint32_t t14 = state->since;
    const uint32_t t15 = (t14 < 4294967295U) ? (t14 + 1U) : 4294967295U;
    const float t16 = (float)t15;
    const float t17 = 0.001f * t16;
    const float t18 = t10 / t17;
    const float t19 = state->quotient;
    const float t20 = t13 ? t18 : t19;
    const int t21 = !t4;
    const int t22 = t13 || t21;
    const uint32_t t23 = t22 ? 0U : t15;
    const float t24 = t1 ? t0 : t7;
    state->quotient = t20;
    state->since = t23;
    state->last_angle = t24;

    /* the filter */
    const float t25 = state->dangle;
    const float t27 = 0.16666667f * t20;
    const float t29 = 0.8333333f * t25;
    const float t30 = t29 + t27;
    state->dangle = t30;
    const float t31 = state->last_angle;
    const uint32_t t32 = (t3 < 77U) ? (t3 + 1U) : 77U;
    const uint32_t t33 = t1 ? t32 : t3;
    state->good = t33;
    const uint32_t t35 = state->clean;
    const uint32_t t36 = (t35 < 76U) ? (t35 + 1U) : 76U;
    const uint32_t t37 = t1 ? t36 : 0U;
    const uint32_t t38 = t4 ? t37 : 76U;
    state->clean = t38;
    const int t40 = 76U < t33;
    const int t41 = 75U < t38;
    const low_pass_status t45 = t41 ? LOW_PASS_CONVERGED : LOW_PASS_COASTING;
    const low_pass_status t46 = t40 ? t45 : LOW_PASS_CONVERGING;

    estimate->angle = t31;
    estimate->dangle = t30;
    estimate->status = t46;
}
