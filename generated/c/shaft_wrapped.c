/* shaft_wrapped.c: Finite-time observer: Speed of a shaft from an angle within one turn, no plant.
 *
 * Generated; shaft_wrapped.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "shaft_wrapped.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "shaft_wrapped.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "shaft_wrapped.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* What one part of a step hands to the next. */
typedef struct {
    float t15;
    uint32_t t36;
    float t57;
    float t58;
    float t63;
    float t78;
    float t97;
    float t99;
    shaft_wrapped_status t107;
    int flags[2]; /* t1, t23 */
} shaft_wrapped_work;

/* Part 1 of a step. */
static void shaft_wrapped_part_1(const shaft_wrapped_state *state, const shaft_wrapped_measurements *measurements, shaft_wrapped_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    const float t0 = measurements->angle;
    work->flags[0] = (-6588397.5f <= t0) && (t0 <= 6588397.5f);
    const float t3 = t0 * 0.15915494f;
    const float t5 = t3 + 1.2582912e7f;
    const float t6 = t5 - 1.2582912e7f;
    const float t8 = t6 * 6.28125f;
    const float t9 = t0 - t8;
    const float t11 = t6 * 0.0019350052f;
    const float t12 = t9 - t11;
    const float t14 = t6 * 3.019916e-7f;
    work->t15 = t12 - t14;

    /* prediction by the plant */
    const float t16 = state->xi1;
    const float t17 = state->xi2;
    const float t18 = state->xi3;
    const float t19 = t17 + t18;
    const float t20 = t16 + t19;

    /* correction by the innovation */
    const float t21 = t20 - t16;
    const int t22 = (-3.1415927f <= t21) && (t21 <= 3.1415927f);
    work->flags[1] = !t22;
    const float t25 = work->t15 - t20;
    const float t26 = t25 * 0.15915494f;
    const float t27 = t26 + 1.2582912e7f;
    const float t28 = t27 - 1.2582912e7f;
    const float t30 = t28 * 6.2831855f;
    const float t31 = t25 - t30;
    const float t32 = work->flags[0] ? t31 : 0.0f;
    const uint32_t t33 = state->left;
    const uint32_t t34 = (t33 < 80U) ? t33 : 80U;
    const uint32_t t35 = (t34 > 0U) ? (t34 - 1U) : 0U;
    work->t36 = work->flags[0] ? t35 : t34;
    const float t37 = (float)work->t36;
    const float t39 = 0.03125f * t37;
    const float t41 = t39 + 0.625f;
    const float t42 = t41 * t41;
    const float t43 = t42 * t41;
    const float t45 = 0.9375f * t42;
    const float t47 = 0.29296875f * t41;
    const float t49 = t47 + 0.030517578f;
    const float t50 = t45 + t49;
    const float t51 = t43 + t50;
    const float t52 = t32 / t51;
    const float t53 = t50 * t52;
    const float t54 = t49 * t52;
    const float t55 = 0.030517578f * t52;
    const float t56 = t20 + t53;
    work->t57 = t19 + t54;
    work->t58 = t18 + t55;
    const float t59 = t56 * 0.15915494f;
    const float t60 = t59 + 1.2582912e7f;
    const float t61 = t60 - 1.2582912e7f;
    const float t62 = t61 * 6.2831855f;
    work->t63 = t56 - t62;
}

/* Part 2 of a step. */
static void shaft_wrapped_part_2(shaft_wrapped_state *state, shaft_wrapped_work *work)
{
    /* the first sample starts the observer; so does a state beyond all bounds */
    const uint32_t t65 = state->good;
    const int t66 = t65 == 0U;
    const int t67 = t66 || work->flags[1];
    const int t68 = (-1e29f <= work->t63) && (work->t63 <= 1e29f);
    const int t69 = !t68;
    const int t70 = t67 || t69;
    const int t71 = (-1e29f <= work->t57) && (work->t57 <= 1e29f);
    const int t72 = !t71;
    const int t73 = t70 || t72;
    const int t74 = (-1e29f <= work->t58) && (work->t58 <= 1e29f);
    const int t75 = !t74;
    const int t76 = t73 || t75;
    const float t77 = work->flags[0] ? work->t15 : 0.0f;
    work->t78 = t76 ? t77 : work->t63;
    state->xi1 = work->t78;
    const float t79 = t76 ? 0.0f : work->t57;
    state->xi2 = t79;
    const float t80 = t76 ? 0.0f : work->t58;
    state->xi3 = t80;
    const uint32_t t82 = t76 ? 80U : work->t36;
    state->left = t82;
    const uint32_t t84 = work->flags[0] ? 1U : 0U;
    const uint32_t t85 = (t65 < 81U) ? (t65 + 1U) : 81U;
    const uint32_t t86 = work->flags[0] ? t85 : t65;
    const uint32_t t87 = t76 ? t84 : t86;
    state->good = t87;
    const uint32_t t88 = state->clean;
    const uint32_t t89 = (t88 < 53U) ? (t88 + 1U) : 53U;
    const uint32_t t90 = work->flags[0] ? t89 : 0U;
    const uint32_t t92 = t76 ? 53U : t90;
    state->clean = t92;

    /* the estimate */
    const float t94 = 1000.0f * t79;
    const float t96 = 500.0f * t80;
    work->t97 = t94 + t96;
    work->t99 = 1000000.0f * t80;
    const int t101 = 80U < t87;
    const int t102 = 52U < t92;
    const shaft_wrapped_status t106 = t102 ? SHAFT_WRAPPED_CONVERGED : SHAFT_WRAPPED_COASTING;
    work->t107 = t101 ? t106 : SHAFT_WRAPPED_CONVERGING;
}

void shaft_wrapped_init(shaft_wrapped_state *state)
{
    state->xi1 = 0.0f;
    state->xi2 = 0.0f;
    state->xi3 = 0.0f;
    state->left = 80U;
    state->good = 0U;
    state->clean = 0U;
}

void shaft_wrapped_step(shaft_wrapped_state *state, const shaft_wrapped_measurements *measurements,
                        shaft_wrapped_estimate *estimate)
{
    shaft_wrapped_work work;
    shaft_wrapped_part_1(state, measurements, &work);
    shaft_wrapped_part_2(state, &work);

    estimate->angle = work.t78;
    estimate->dangle = work.t97;
    estimate->d2angle = work.t99;
    estimate->status = work.t107;
}
