/* oscillator_known_start.c: Finite-time observer: Mass on a spring, observed from a known state on.
 *
 * Generated; oscillator_known_start.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "oscillator_known_start.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "oscillator_known_start.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "oscillator_known_start.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* What one part of a step hands to the next. */
typedef struct {
    float t80;
    float t81;
    uint32_t t88;
    uint32_t t93;
    oscillator_known_start_status t103;
} oscillator_known_start_work;

/* Part 1 of a step. */
static void oscillator_known_start_part_1(oscillator_known_start_state *state, const oscillator_known_start_measurements *measurements, const oscillator_known_start_inputs *inputs, oscillator_known_start_work *work)
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
    const uint32_t t70 = state->given;
    const int t71 = t70 == 0U;
    const int t72 = t69 && t71;
    const int t73 = (-1e35f <= t65) && (t65 <= 1e35f);
    const int t74 = !t73;
    const int t75 = t72 || t74;
    const int t76 = (-1e35f <= t66) && (t66 <= 1e35f);
    const int t77 = !t76;
    const int t78 = t75 || t77;
    const float t79 = t1 ? t0 : 0.0f;
    work->t80 = t78 ? t79 : t65;
    state->position = work->t80;
    work->t81 = t78 ? 0.0f : t66;
    state->speed = work->t81;
    const uint32_t t83 = t78 ? 90U : t30;
    state->left = t83;
    const uint32_t t85 = t1 ? 1U : 0U;
    const uint32_t t86 = (t68 < 91U) ? (t68 + 1U) : 91U;
    const uint32_t t87 = t1 ? t86 : t68;
    work->t88 = t78 ? t85 : t87;
    state->good = work->t88;
    const uint32_t t89 = state->clean;
    const uint32_t t90 = (t89 < 40U) ? (t89 + 1U) : 40U;
    const uint32_t t91 = t23 ? t90 : 0U;
    work->t93 = t78 ? 40U : t91;
    state->clean = work->t93;
    const int t94 = t1 || t78;
    const uint32_t t95 = t94 ? 0U : t70;
    state->given = t95;
}

/* Part 2 of a step. */
static void oscillator_known_start_part_2(oscillator_known_start_work *work)
{
    /* the estimate */
    const int t97 = 90U < work->t88;
    const int t98 = 39U < work->t93;
    const oscillator_known_start_status t102 = t98 ? OSCILLATOR_KNOWN_START_CONVERGED : OSCILLATOR_KNOWN_START_COASTING;
    work->t103 = t97 ? t102 : OSCILLATOR_KNOWN_START_CONVERGING;
}

void oscillator_known_start_init(oscillator_known_start_state *state)
{
    state->position = 0.0f;
    state->speed = 0.0f;
    state->left = 90U;
    state->good = 0U;
    state->clean = 0U;
    state->last_force = 0.0f;
    state->given = 0U;
}

void oscillator_known_start_init_at(oscillator_known_start_state *state, const oscillator_known_start_estimate *estimate)
{
    oscillator_known_start_init(state);
    /* the given state */
    const int t104 = estimate->status == OSCILLATOR_KNOWN_START_CONVERGED;
    const float t105 = estimate->position;
    const int t106 = (-1e35f <= t105) && (t105 <= 1e35f);
    const float t108 = t106 ? t105 : 0.0f;
    const float t109 = estimate->speed;
    const int t110 = (-1e35f <= t109) && (t109 <= 1e35f);
    const float t111 = t110 ? t109 : 0.0f;
    const int t112 = t104 && t106;
    const int t113 = t112 && t110;
    state->position = t108;
    state->speed = t111;

    /* how far it is trusted */
    const uint32_t t117 = t113 ? 0U : 90U;
    state->left = t117;
    const uint32_t t119 = t113 ? 91U : 0U;
    state->good = t119;
    state->clean = 40U;
    const uint32_t t121 = t113 ? 0U : 1U;
    state->given = t121;
}

void oscillator_known_start_step(oscillator_known_start_state *state, const oscillator_known_start_measurements *measurements,
                                 const oscillator_known_start_inputs *inputs, oscillator_known_start_estimate *estimate)
{
    oscillator_known_start_work work;
    oscillator_known_start_part_1(state, measurements, inputs, &work);
    oscillator_known_start_part_2(&work);

    estimate->position = work.t80;
    estimate->speed = work.t81;
    estimate->status = work.t103;
}
