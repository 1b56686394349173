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
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
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
    const int t7 = (-6.5f <= t6) && (t6 <= 6.5f);
    const int t8 = t1 || t7;
    const int t9 = !t8;
    const float t11 = t0 - t6;
    const float t12 = t1 ? t11 : 0.0f;
    const uint32_t t13 = state->left;
    const uint32_t t14 = (t13 < 180U) ? t13 : 180U;
    const uint32_t t15 = (t14 > 0U) ? (t14 - 1U) : 0U;
    const uint32_t t16 = t1 ? t15 : t14;
    const float t17 = (float)t16;
    const float t19 = 0.03125f * t17;
    const float t21 = t19 + 0.625f;
    const float t22 = t21 * t21;
    const float t23 = t22 * t21;
    const float t25 = 0.9375f * t22;
    const float t27 = 0.29296875f * t21;
    const float t29 = t27 + 0.030517578f;
    const float t30 = t25 + t29;
    const float t31 = t23 + t30;
    const float t32 = t12 / t31;
    const float t33 = t30 * t32;
    const float t34 = t29 * t32;
    const float t35 = 0.030517578f * t32;
    const float t36 = t6 + t33;
    const float t37 = t5 + t34;
    const float t38 = t4 + t35;

    /* the first sample starts the observer; so does a state beyond all bounds */
    const uint32_t t40 = state->good;
    const int t41 = t40 == 0U;
    const int t42 = t41 || t9;
    const int t43 = (-1e28f <= t36) && (t36 <= 1e28f);
    const int t44 = !t43;
    const int t45 = t42 || t44;
    const int t46 = (-1e28f <= t37) && (t37 <= 1e28f);
    const int t47 = !t46;
    const int t48 = t45 || t47;
    const int t49 = (-1e28f <= t38) && (t38 <= 1e28f);
    const int t50 = !t49;
    const int t51 = t48 || t50;
    const float t52 = t1 ? t0 : 0.0f;
    const float t53 = t51 ? t52 : t36;
    state->xi1 = t53;
    const float t54 = t51 ? 0.0f : t37;
    state->xi2 = t54;
    const float t55 = t51 ? 0.0f : t38;
    state->xi3 = t55;
    const uint32_t t57 = t51 ? 180U : t16;
    state->left = t57;
    const uint32_t t59 = t1 ? 1U : 0U;
    const uint32_t t60 = (t40 < 181U) ? (t40 + 1U) : 181U;
    const uint32_t t61 = t1 ? t60 : t40;
    const uint32_t t62 = t51 ? t59 : t61;
    state->good = t62;
    const uint32_t t63 = state->clean;
    const uint32_t t64 = (t63 < 70U) ? (t63 + 1U) : 70U;
    const uint32_t t65 = t1 ? t64 : 0U;
    const uint32_t t67 = t51 ? 70U : t65;
    state->clean = t67;

    /* the estimate */
    const float t69 = 1000.0f * t54;
    const float t71 = 500.0f * t55;
    const float t72 = t69 + t71;
    const float t74 = 1000000.0f * t55;
    const int t76 = 180U < t62;
    const int t77 = 69U < t67;
    const differentiator_encoder_status t81 = t77 ? DIFFERENTIATOR_ENCODER_CONVERGED : DIFFERENTIATOR_ENCODER_COASTING;
    const differentiator_encoder_status t82 = t76 ? t81 : DIFFERENTIATOR_ENCODER_CONVERGING;

    estimate->angle = t53;
    estimate->dangle = t72;
    estimate->d2angle = t74;
    estimate->status = t82;
}
