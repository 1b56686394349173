/* camera_luenberger.c: Finite-time observer: Part on a linear axis, seen by a camera 25 times a second, controlled 200 times.
 *
 * Generated; camera_luenberger.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "camera_luenberger.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "camera_luenberger.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "camera_luenberger.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

void camera_luenberger_init(camera_luenberger_state *state)
{
    state->x = 0.0f;
    state->v = 0.0f;
    state->good = 0U;
    state->clean = 0U;
    state->last_i = 0.0f;
    state->until_x = 0U;
}

void camera_luenberger_step(camera_luenberger_state *state, const camera_luenberger_measurements *measurements,
                            const camera_luenberger_inputs *inputs, camera_luenberger_estimate *estimate)
{
    /* samples: outside its range, infinite or NaN means missing */
    const float t0 = measurements->x;
    const int t1 = (-1.0f <= t0) && (t0 <= 2.0f);
    const float t2 = inputs->i;
    const int t3 = (-1e36f <= t2) && (t2 <= 1e36f);
    const float t4 = state->last_i;
    const float t5 = t3 ? t2 : t4;
    const uint32_t t8 = state->until_x;
    const int t9 = t8 == 0U;
    const uint32_t t10 = (t8 > 0U) ? (t8 - 1U) : 0U;
    const uint32_t t11 = t9 ? 7U : t10;
    state->until_x = t11;
    const int t12 = t1 && t9;

    /* prediction by the plant */
    const float t13 = state->x;
    const float t14 = state->v;
    const float t16 = 0.0049688797f * t14;
    const float t18 = 4.9792317e-5f * t5;
    const float t19 = t13 + t16;
    const float t20 = t19 + t18;
    const float t22 = 0.9875778f * t14;
    const float t24 = 0.019875519f * t5;
    const float t25 = t22 + t24;
    const int t26 = !t9;
    const int t27 = t12 || t26;
    state->last_i = t5;
    const int t28 = t3 && t27;

    /* correction by the innovation */
    const int t29 = (-1.0f <= t20) && (t20 <= 2.0f);
    const int t30 = t12 || t29;
    const int t31 = !t30;
    const float t33 = t0 - t20;
    const float t34 = t12 ? t33 : 0.0f;
    const float t36 = 0.5034147f * t34;
    const float t38 = 1.4840468f * t34;
    const float t39 = t20 + t36;
    const float t40 = t25 + t38;

    /* the first sample starts the observer; so does a state beyond all bounds */
    const uint32_t t41 = state->good;
    const int t42 = t41 == 0U;
    const int t43 = t42 || t31;
    const int t44 = (-1e36f <= t39) && (t39 <= 1e36f);
    const int t45 = !t44;
    const int t46 = t43 || t45;
    const int t47 = (-1e36f <= t40) && (t40 <= 1e36f);
    const int t48 = !t47;
    const int t49 = t46 || t48;
    const float t50 = t12 ? t0 : 0.0f;
    const float t51 = t49 ? t50 : t39;
    state->x = t51;
    const float t52 = t49 ? 0.0f : t40;
    state->v = t52;
    const uint32_t t54 = t12 ? 1U : 0U;
    const uint32_t t55 = (t41 < 48U) ? (t41 + 1U) : 48U;
    const uint32_t t56 = t12 ? t55 : t41;
    const uint32_t t57 = t49 ? t54 : t56;
    state->good = t57;
    const uint32_t t58 = state->clean;
    const uint32_t t59 = (t58 < 432U) ? (t58 + 1U) : 432U;
    const uint32_t t60 = t28 ? t59 : 0U;
    const uint32_t t62 = t49 ? 432U : t60;
    state->clean = t62;

    /* the estimate */
    const int t65 = 47U < t57;
    const int t66 = 431U < t62;
    const camera_luenberger_status t70 = t66 ? CAMERA_LUENBERGER_CONVERGED : CAMERA_LUENBERGER_COASTING;
    const camera_luenberger_status t71 = t65 ? t70 : CAMERA_LUENBERGER_CONVERGING;

    estimate->x = t51;
    estimate->v = t52;
    estimate->status = t71;
}
