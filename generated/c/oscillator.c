/* oscillator.c: Finite-time observer: Mass on a spring, its speed from its position by a prescribed time.
 *
 * Generated; oscillator.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "oscillator.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "oscillator.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "oscillator.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* What one part of a step hands to the next. */
typedef struct {
    float t77;
    float t78;
    oscillator_status t98;
} oscillator_work;

/* Part 1 of a step. */
static void oscillator_part_1(oscillator_state *state, const oscillator_measurements *measurements, const oscillator_inputs *inputs, oscillator_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    const float t0 = measurements->position;
    const int t1 = (-1e35f <= t0) && (t0 <= 1e35f);
    const float t2 = inputs->force;
    const int t3 = (-1e35f <= t2) && (t2 <= 1e35f);
    const float t4 = state->last_force;
    const float t5 = t3 ? t2 : t4;

    /* prediction by the plant */
    const float t6 = state->position;
    const float t7 = state->speed;
    const float t9 = 0.99875194f * t6;
    const float t11 = 0.009975869f * t7;
    const float t13 = 4.9923e-5f * t5;
    const float t14 = t9 + t11;
    const float t15 = t14 + t13;
    const float t17 = -0.24939673f * t6;
    const float t19 = 0.9947616f * t7;
    const float t20 = 0.009975869f * t5;
    const float t21 = t17 + t19;
    const float t22 = t21 + t20;
    state->last_force = t5;
    const int t23 = t3 && t1;

    /* correction by the innovation */
    const float t25 = t0 - t15;
    const float t26 = t1 ? t25 : 0.0f;
    const uint32_t t27 = state->left;
    const uint32_t t28 = (t27 < 90U) ? t27 : 90U;
    const uint32_t t29 = (t28 > 0U) ? (t28 - 1U) : 0U;
    const uint32_t t30 = t1 ? t29 : t28;
    const float t31 = (float)t30;
    const float t33 = 0.0625f * t31;
    const float t35 = t33 + 0.625f;
    const float t36 = t35 * t35;
    const float t38 = 0.02f * t36;
    const float t39 = t35 + t38;
    const float t42 = 0.01f * t35;
    const float t44 = 0.0001f * t36;
    const float t45 = 0.21875f + t42;
    const float t46 = t45 + t44;
    const float t47 = t39 + t46;
    const float t48 = t36 + t47;
    const float t49 = t26 / t48;
    const float t50 = t47 * t49;
    const float t51 = t46 * t49;
    const float t53 = 1.004008f * t50;
    const float t55 = -0.0040080105f * t26;
    const float t56 = t53 + t55;
    const float t58 = -0.27615973f * t50;
    const float t60 = 100.2419f * t51;
    const float t62 = -0.24894966f * t26;
    const float t63 = t58 + t60;
    const float t64 = t63 + t62;
    const float t65 = t15 + t56;
    const float t66 = t22 + t64;

    /* the first sample starts the observer; so does a state beyond all bounds */
    const uint32_t t68 = state->good;
    const int t69 = t68 == 0U;
    const int t70 = (-1e35f <= t65) && (t65 <= 1e35f);
    const int t71 = !t70;
    const int t72 = t69 || t71;
    const int t73 = (-1e35f <= t66) && (t66 <= 1e35f);
    const int t74 = !t73;
    const int t75 = t72 || t74;
    const float t76 = t1 ? t0 : 0.0f;
    work->t77 = t75 ? t76 : t65;
    state->position = work->t77;
    work->t78 = t75 ? 0.0f : t66;
    state->speed = work->t78;
    const uint32_t t80 = t75 ? 90U : t30;
    state->left = t80;
    const uint32_t t82 = t1 ? 1U : 0U;
    const uint32_t t83 = (t68 < 91U) ? (t68 + 1U) : 91U;
    const uint32_t t84 = t1 ? t83 : t68;
    const uint32_t t85 = t75 ? t82 : t84;
    state->good = t85;
    const uint32_t t86 = state->clean;
    const uint32_t t87 = (t86 < 40U) ? (t86 + 1U) : 40U;
    const uint32_t t88 = t23 ? t87 : 0U;
    const uint32_t t90 = t75 ? 40U : t88;
    state->clean = t90;

    /* the estimate */
    const int t92 = 90U < t85;
    const int t93 = 39U < t90;
    const oscillator_status t97 = t93 ? OSCILLATOR_CONVERGED : OSCILLATOR_COASTING;
    work->t98 = t92 ? t97 : OSCILLATOR_CONVERGING;
}

void oscillator_init(oscillator_state *state)
{
    state->position = 0.0f;
    state->speed = 0.0f;
    state->left = 90U;
    state->good = 0U;
    state->clean = 0U;
    state->last_force = 0.0f;
}

void oscillator_step(oscillator_state *state, const oscillator_measurements *measurements,
                     const oscillator_inputs *inputs, oscillator_estimate *estimate)
{
    oscillator_work work;
    oscillator_part_1(state, measurements, inputs, &work);

    estimate->position = work.t77;
    estimate->speed = work.t78;
    estimate->status = work.t98;
}
