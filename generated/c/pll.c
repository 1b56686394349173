/* pll.c: Finite-time observer: Speed of a motor's shaft as a drive has it: 8192 counts, 8 kHz.
 *
 * Generated; pll.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "pll.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "pll.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "pll.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

void pll_init(pll_state *state)
{
    state->angle = 0.0f;
    state->dangle = 0.0f;
    state->good = 0U;
    state->clean = 0U;
}

void pll_step(pll_state *state, const pll_measurements *measurements,
              pll_estimate *estimate)
{
    /* samples: outside its range, infinite or NaN means missing */
    const float t0 = measurements->angle;
    const int t1 = (-1e34f <= t0) && (t0 <= 1e34f);

    /* prediction by the plant */
    const float t2 = state->angle;
    const float t3 = state->dangle;
    const float t5 = 0.000125f * t3;
    const float t6 = t2 + t5;

    /* correction by the innovation */
    const float t8 = t0 - t6;
    const float t9 = t1 ? t8 : 0.0f;
    const float t11 = 0.25f * t9;
    const float t13 = 125.0f * t9;
    const float t14 = t6 + t11;
    const float t15 = t3 + t13;

    /* the first sample starts the observer; so does a state beyond all bounds */
    const uint32_t t17 = state->good;
    const int t18 = t17 == 0U;
    const int t19 = (-1e34f <= t14) && (t14 <= 1e34f);
    const int t20 = !t19;
    const int t21 = t18 || t20;
    const int t22 = (-1e34f <= t15) && (t15 <= 1e34f);
    const int t23 = !t22;
    const int t24 = t21 || t23;
    const float t25 = t1 ? t0 : 0.0f;
    const float t26 = t24 ? t25 : t14;
    state->angle = t26;
    const float t27 = t24 ? 0.0f : t15;
    state->dangle = t27;
    const uint32_t t29 = t1 ? 1U : 0U;
    const uint32_t t30 = (t17 < 158U) ? (t17 + 1U) : 158U;
    const uint32_t t31 = t1 ? t30 : t17;
    const uint32_t t32 = t24 ? t29 : t31;
    state->good = t32;
    const uint32_t t33 = state->clean;
    const uint32_t t34 = (t33 < 190U) ? (t33 + 1U) : 190U;
    const uint32_t t35 = t1 ? t34 : 0U;
    const uint32_t t37 = t24 ? 190U : t35;
    state->clean = t37;

    /* the estimate */
    const int t40 = 157U < t32;
    const int t41 = 189U < t37;
    const pll_status t45 = t41 ? PLL_CONVERGED : PLL_COASTING;
    const pll_status t46 = t40 ? t45 : PLL_CONVERGING;

    estimate->angle = t26;
    estimate->dangle = t27;
    estimate->status = t46;
}
