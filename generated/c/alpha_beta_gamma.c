/* alpha_beta_gamma.c: Finite-time observer: Position, speed and acceleration of a slide from its scale.
 *
 * Generated; alpha_beta_gamma.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "alpha_beta_gamma.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "alpha_beta_gamma.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "alpha_beta_gamma.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

void alpha_beta_gamma_init(alpha_beta_gamma_state *state)
{
    state->x = 0.0;
    state->dx = 0.0;
    state->d2x = 0.0;
    state->good = 0U;
    state->clean = 0U;
}

void alpha_beta_gamma_step(alpha_beta_gamma_state *state, const alpha_beta_gamma_measurements *measurements,
                           alpha_beta_gamma_estimate *estimate)
{
    /* samples: outside its range, infinite or NaN means missing */
    const double t0 = measurements->x;
    const int t1 = (-1e303 <= t0) && (t0 <= 1e303);

    /* prediction by the plant */
    const double t2 = state->x;
    const double t3 = state->dx;
    const double t4 = state->d2x;
    const double t6 = 0.001 * t3;
    const double t8 = 5e-7 * t4;
    const double t9 = t2 + t6;
    const double t10 = t9 + t8;
    const double t11 = 0.001 * t4;
    const double t12 = t3 + t11;

    /* correction by the innovation */
    const double t14 = t0 - t10;
    const double t15 = t1 ? t14 : 0.0;
    const double t17 = 0.3 * t15;
    const double t19 = 35.58372292031252 * t15;
    const double t21 = 1408.5437037707204 * t15;
    const double t22 = t10 + t17;
    const double t23 = t12 + t19;
    const double t24 = t4 + t21;

    /* the first sample starts the observer; so does a state beyond all bounds */
    const uint32_t t26 = state->good;
    const int t27 = t26 == 0U;
    const int t28 = (-1e303 <= t22) && (t22 <= 1e303);
    const int t29 = !t28;
    const int t30 = t27 || t29;
    const int t31 = (-1e303 <= t23) && (t23 <= 1e303);
    const int t32 = !t31;
    const int t33 = t30 || t32;
    const int t34 = (-1e303 <= t24) && (t24 <= 1e303);
    const int t35 = !t34;
    const int t36 = t33 || t35;
    const double t37 = t1 ? t0 : 0.0;
    const double t38 = t36 ? t37 : t22;
    state->x = t38;
    const double t39 = t36 ? 0.0 : t23;
    state->dx = t39;
    const double t40 = t36 ? 0.0 : t24;
    state->d2x = t40;
    const uint32_t t42 = t1 ? 1U : 0U;
    const uint32_t t43 = (t26 < 197U) ? (t26 + 1U) : 197U;
    const uint32_t t44 = t1 ? t43 : t26;
    const uint32_t t45 = t36 ? t42 : t44;
    state->good = t45;
    const uint32_t t46 = state->clean;
    const uint32_t t47 = (t46 < 217U) ? (t46 + 1U) : 217U;
    const uint32_t t48 = t1 ? t47 : 0U;
    const uint32_t t50 = t36 ? 217U : t48;
    state->clean = t50;

    /* the estimate */
    const int t53 = 196U < t45;
    const int t54 = 216U < t50;
    const alpha_beta_gamma_status t58 = t54 ? ALPHA_BETA_GAMMA_CONVERGED : ALPHA_BETA_GAMMA_COASTING;
    const alpha_beta_gamma_status t59 = t53 ? t58 : ALPHA_BETA_GAMMA_CONVERGING;

    estimate->x = t38;
    estimate->dx = t39;
    estimate->d2x = t40;
    estimate->status = t59;
}
