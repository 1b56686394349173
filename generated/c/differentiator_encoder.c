/* differentiator_encoder.c: Finite-time observer: Speed and acceleration of a shaft from its encoder, with no model of what drives it.
 *
 * Generated; differentiator_encoder.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "differentiator_encoder.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "differentiator_encoder.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "differentiator_encoder.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

void differentiator_encoder_init(differentiator_encoder_state *state)
{
    state->xi1 = 0.0f;
    state->xi2 = 0.0f;
    state->xi3 = 0.0f;
    state->left = 180U;
    state->good = 0U;
    state->clean = 0U;
}

void differentiator_encoder_step(differentiator_encoder_state *state, const differentiator_encoder_measurements *measurements,
                                 differentiator_encoder_estimate *estimate)
{
    /* samples: outside its range, infinite or NaN means missing */
    const float t0 = measurements->angle;
    const int t1 = (-6.5f <= t0) && (t0 <= 6.5f);

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
    const uint32_t t11 = (t10 < 180U) ? t10 : 180U;
    const uint32_t t12 = (t11 > 0U) ? (t11 - 1U) : 0U;
    const uint32_t t13 = t1 ? t12 : t11;
    const float t14 = (float)t13;
    const float t16 = 0.03125f * t14;
    const float t18 = t16 + 0.625f;
    const float t19 = t18 * t18;
    const float t20 = t19 * t18;
    const float t22 = 0.9375f * t19;
    const float t24 = 0.29296875f * t18;
    const float t26 = t24 + 0.030517578f;
    const float t27 = t22 + t26;
    const float t28 = t20 + t27;
    const float t29 = t9 / t28;
    const float t30 = t27 * t29;
    const float t31 = t26 * t29;
    const float t32 = 0.030517578f * t29;
    const float t33 = t6 + t30;
    const float t34 = t5 + t31;
    const float t35 = t4 + t32;

    /* the first sample starts the observer; so does a state beyond all bounds */
    const uint32_t t37 = state->good;
    const int t38 = t37 == 0U;
    const int t39 = (-1e28f <= t33) && (t33 <= 1e28f);
    const int t40 = !t39;
    const int t41 = t38 || t40;
    const int t42 = (-1e28f <= t34) && (t34 <= 1e28f);
    const int t43 = !t42;
    const int t44 = t41 || t43;
    const int t45 = (-1e28f <= t35) && (t35 <= 1e28f);
    const int t46 = !t45;
    const int t47 = t44 || t46;
    const float t48 = t1 ? t0 : 0.0f;
    const float t49 = t47 ? t48 : t33;
    state->xi1 = t49;
    const float t50 = t47 ? 0.0f : t34;
    state->xi2 = t50;
    const float t51 = t47 ? 0.0f : t35;
    state->xi3 = t51;
    const uint32_t t53 = t47 ? 180U : t13;
    state->left = t53;
    const uint32_t t55 = t1 ? 1U : 0U;
    const uint32_t t56 = (t37 < 181U) ? (t37 + 1U) : 181U;
    const uint32_t t57 = t1 ? t56 : t37;
    const uint32_t t58 = t47 ? t55 : t57;
    state->good = t58;
    const uint32_t t59 = state->clean;
    const uint32_t t60 = (t59 < 181U) ? (t59 + 1U) : 181U;
    const uint32_t t61 = t1 ? t60 : 0U;
    const uint32_t t62 = t47 ? t55 : t61;
    state->clean = t62;

    /* the estimate */
    const float t64 = 1000.0f * t50;
    const float t66 = 500.0f * t51;
    const float t67 = t64 + t66;
    const float t69 = 1000000.0f * t51;
    const int t73 = 180U < t58;
    const int t74 = 180U < t62;
    const differentiator_encoder_status t75 = t74 ? DIFFERENTIATOR_ENCODER_CONVERGED : DIFFERENTIATOR_ENCODER_COASTING;
    const differentiator_encoder_status t76 = t73 ? t75 : DIFFERENTIATOR_ENCODER_CONVERGING;

    estimate->angle = t49;
    estimate->dangle = t67;
    estimate->d2angle = t69;
    estimate->status = t76;
}
