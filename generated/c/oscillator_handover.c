/* oscillator_handover.c: Finite-time observer: Mass on a spring, by a prescribed time and then by a steady Kalman filter.
 *
 * Generated; oscillator_handover.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "oscillator_handover.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "oscillator_handover.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "oscillator_handover.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* What one part of a step hands to the next. */
typedef struct {
    float t84;
    float t85;
    uint32_t t92;
    uint32_t t97;
    oscillator_handover_status t105;
} oscillator_handover_work;

/* Part 1 of a step. */
static void oscillator_handover_part_1(oscillator_handover_state *state, const oscillator_handover_measurements *measurements, const oscillator_handover_inputs *inputs, oscillator_handover_work *work)
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
    const float t66 = 0.11395966f * t26;
    const float t68 = 0.68907154f * t26;
    const int t70 = t27 == 0U;
    const float t71 = t70 ? t66 : t56;
    const float t72 = t70 ? t68 : t64;
    const float t73 = t15 + t71;
    const float t74 = t22 + t72;

    /* the first sample starts the observer; so does a state beyond all bounds */
    const uint32_t t75 = state->good;
    const int t76 = t75 == 0U;
    const int t77 = (-1e35f <= t73) && (t73 <= 1e35f);
    const int t78 = !t77;
    const int t79 = t76 || t78;
    const int t80 = (-1e35f <= t74) && (t74 <= 1e35f);
    const int t81 = !t80;
    const int t82 = t79 || t81;
    const float t83 = t1 ? t0 : 0.0f;
    work->t84 = t82 ? t83 : t73;
    state->position = work->t84;
    work->t85 = t82 ? 0.0f : t74;
    state->speed = work->t85;
    const uint32_t t87 = t82 ? 90U : t30;
    state->left = t87;
    const uint32_t t89 = t1 ? 1U : 0U;
    const uint32_t t90 = (t75 < 91U) ? (t75 + 1U) : 91U;
    const uint32_t t91 = t1 ? t90 : t75;
    work->t92 = t82 ? t89 : t91;
    state->good = work->t92;
    const uint32_t t93 = state->clean;
    const uint32_t t94 = (t93 < 231U) ? (t93 + 1U) : 231U;
    const uint32_t t95 = t23 ? t94 : 0U;
    work->t97 = t82 ? 231U : t95;
    state->clean = work->t97;
}

/* Part 2 of a step. */
static void oscillator_handover_part_2(oscillator_handover_work *work)
{
    /* the estimate */
    const int t99 = 90U < work->t92;
    const int t100 = 230U < work->t97;
    const oscillator_handover_status t104 = t100 ? OSCILLATOR_HANDOVER_CONVERGED : OSCILLATOR_HANDOVER_COASTING;
    work->t105 = t99 ? t104 : OSCILLATOR_HANDOVER_CONVERGING;
}

void oscillator_handover_init(oscillator_handover_state *state)
{
    state->position = 0.0f;
    state->speed = 0.0f;
    state->left = 90U;
    state->good = 0U;
    state->clean = 0U;
    state->last_force = 0.0f;
}

void oscillator_handover_step(oscillator_handover_state *state, const oscillator_handover_measurements *measurements,
                              const oscillator_handover_inputs *inputs, oscillator_handover_estimate *estimate)
{
    oscillator_handover_work work;
    oscillator_handover_part_1(state, measurements, inputs, &work);
    oscillator_handover_part_2(&work);

    estimate->position = work.t84;
    estimate->speed = work.t85;
    estimate->status = work.t105;
}
