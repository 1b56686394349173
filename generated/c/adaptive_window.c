/* adaptive_window.c: Finite-time observer: Speed of a humanoid's joint from its encoder of 12 bits.
 *
 * Generated; adaptive_window.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "adaptive_window.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "adaptive_window.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "adaptive_window.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* What one part of a step hands to the next. */
typedef struct {
    uint32_t t5;
    uint32_t t16;
    uint32_t t24;
    float t123;
    float t126;
    adaptive_window_status t131;
    int flags[1]; /* t1 */
} adaptive_window_work;

/* Part 1 of a step. */
static void adaptive_window_part_1(adaptive_window_state *state, const adaptive_window_measurements *measurements, adaptive_window_work *work)
{
    /* the sample: outside its range, infinite or NaN means missing */
    const float t0 = measurements->angle;
    work->flags[0] = (-1e26f <= t0) && (t0 <= 1e26f);
    const float t2 = state->last_angle;
    const uint32_t t3 = state->since;
    const uint32_t t4 = (t3 < 17U) ? (t3 + 1U) : 17U;
    work->t5 = 0U;
    const float t6 = t0 - t2;
    const float t7 = (float)t4;
    const uint32_t t8 = state->newest;
    const uint32_t t9 = (t8 < 15U) ? t8 : 15U;
    const uint32_t t10 = (t9 < 15U) ? (t9 + 1U) : 0U;
    const uint32_t t11 = work->flags[0] ? t10 : t9;
    const float t12 = state->moves[t11];
    const float t13 = state->gaps[t11];
    const float t14 = work->flags[0] ? t6 : t12;
    const float t15 = work->flags[0] ? t7 : t13;
    state->moves[t11] = t14;
    state->gaps[t11] = t15;
    state->newest = t11;
    work->t16 = work->flags[0] ? work->t5 : t4;
    state->since = work->t16;
    const float t17 = work->flags[0] ? t0 : t2;
    state->last_angle = t17;
    const uint32_t t18 = state->samples;
    const uint32_t t19 = (t18 < 17U) ? (t18 + 1U) : 17U;
    const uint32_t t20 = work->flags[0] ? t19 : t18;
    state->samples = t20;

    /* the line through each number of samples */
    const uint32_t t23 = state->newest;
    work->t24 = (t23 < 15U) ? t23 : 15U;
    uint32_t t25 = work->t24;
    uint32_t t26 = work->t5;
    float t27 = 0.0f;
    float t28 = 0.0f;
    float t29 = 1.0f;
    float t30 = 0.0f;
    float t31 = 0.0f;
    float t32 = 0.0f;
    float t33 = 0.0f;
    for (uint32_t row = 0U; row < 16U; ++row) {
        const float t34 = state->gaps[t25];
        const float t35 = state->moves[t25];
        const float t36 = t27 + t34;
        const float t37 = t28 - t35;
        const float t38 = t29 + 1.0f;
        const float t39 = t36 * t36;
        const float t40 = t36 * t37;
        const float t41 = t30 + t36;
        const float t42 = t31 + t39;
        const float t43 = t32 + t37;
        const float t44 = t33 + t40;
        const float t45 = t38 * t42;
        const float t46 = t41 * t41;
        const float t47 = t45 - t46;
        const float t48 = t38 * t44;
        const float t49 = t41 * t43;
        const float t50 = t48 - t49;
        const float t51 = t50 / t47;
        const float t52 = t51 * t41;
        const float t53 = t43 - t52;
        const float t54 = t53 / t38;
        state->slopes[t26] = t51;
        state->levels[t26] = t54;
        const uint32_t t55 = ((t25 >= 1U) && (t25 < 16U)) ? (t25 - 1U) : 15U;
        const uint32_t t56 = (t26 < 15U) ? (t26 + 1U) : 0U;
        t25 = t55;
        t26 = t56;
        t27 = t36;
        t28 = t37;
        t29 = t38;
        t30 = t41;
        t31 = t42;
        t32 = t43;
        t33 = t44;
    }
}

/* Part 2 of a step. */
static void adaptive_window_part_2(adaptive_window_state *state, adaptive_window_work *work)
{
    /* the longest that leaves no sample further off than the deviation */
    const uint32_t t59 = state->samples;
    const float t60 = state->slopes[work->t5];
    const float t61 = state->levels[work->t5];
    const float t62 = state->gaps[work->t24];
    const int t63 = t62 <= 16.0f;
    const int t65 = 1U < t59;
    const int t66 = t63 && t65;
    uint32_t t68 = 2U;
    uint32_t t69 = work->t5;
    uint32_t t70 = work->t24;
    float t71 = 0.0f;
    float t72 = 0.0f;
    int t73 = 1;
    int t74 = t66;
    float t75 = t60;
    float t76 = t61;
    for (uint32_t row = 0U; row < 150U; ++row) {
        const uint32_t t77 = (t68 > 0U) ? (t68 - 1U) : 0U;
        const uint32_t t78 = (t77 < 15U) ? t77 : 15U;
        const float t79 = state->slopes[t78];
        const float t80 = state->levels[t78];
        const float t81 = t79 * t71;
        const float t82 = t80 + t81;
        const float t83 = t72 - t82;
        const int t84 = (-0.0015339808f <= t83) && (t83 <= 0.0015339808f);
        const int t85 = t73 && t84;
        const int t86 = t69 == t68;
        const int t87 = t71 <= 16.0f;
        const int t88 = t68 < t59;
        const int t89 = t85 && t87;
        const int t90 = t89 && t88;
        const int t91 = t90 && t74;
        const int t92 = t86 && t91;
        const float t93 = t92 ? t79 : t75;
        const float t94 = t92 ? t80 : t76;
        const int t95 = t86 ? t91 : t74;
        const int t96 = t86 ? 1 : t85;
        const float t97 = state->gaps[t70];
        const float t98 = state->moves[t70];
        const float t99 = t71 + t97;
        const float t100 = t72 - t98;
        const float t101 = t86 ? 0.0f : t99;
        const float t102 = t86 ? 0.0f : t100;
        const uint32_t t103 = ((t70 >= 1U) && (t70 < 16U)) ? (t70 - 1U) : 15U;
        const uint32_t t104 = (t68 < 16U) ? (t68 + 1U) : 16U;
        const uint32_t t105 = (t69 < 16U) ? (t69 + 1U) : 16U;
        const uint32_t t106 = t86 ? work->t24 : t103;
        const uint32_t t107 = t86 ? t104 : t68;
        const uint32_t t108 = t86 ? work->t5 : t105;
        t68 = t107;
        t69 = t108;
        t70 = t106;
        t71 = t101;
        t72 = t102;
        t73 = t96;
        t74 = t95;
        t75 = t93;
        t76 = t94;
    }

    /* the estimate: the line at this call, and its slope */
    const uint32_t t109 = state->known;
    const int t110 = t109 == 1U;
    const int t111 = work->flags[0] ? t66 : t110;
    const float t112 = state->slope;
    const float t113 = state->level;
    const float t114 = t66 ? t75 : 0.0f;
    const float t115 = t66 ? t76 : 0.0f;
    const float t116 = work->flags[0] ? t114 : t112;
    const float t117 = work->flags[0] ? t115 : t113;
    state->slope = t116;
    state->level = t117;
    const uint32_t t118 = t111 ? 1U : work->t5;
    state->known = t118;
    const float t119 = state->last_angle;
    const float t120 = (float)work->t16;
    const float t121 = t116 * t120;
    const float t122 = t117 - t121;
    work->t123 = t119 + t122;
    const float t125 = t116 / 0.001f;
    work->t126 = 0.0f - t125;
    const adaptive_window_status t130 = work->flags[0] ? ADAPTIVE_WINDOW_CONVERGED : ADAPTIVE_WINDOW_COASTING;
    work->t131 = t111 ? t130 : ADAPTIVE_WINDOW_CONVERGING;
}

void adaptive_window_init(adaptive_window_state *state)
{
    state->last_angle = 0.0f;
    state->since = 0U;
    for (uint32_t slot = 0U; slot < 16U; ++slot) {
        state->moves[slot] = 0.0f;
    }
    for (uint32_t slot = 0U; slot < 16U; ++slot) {
        state->gaps[slot] = 1.0f;
    }
    state->newest = 15U;
    state->samples = 0U;
    for (uint32_t slot = 0U; slot < 16U; ++slot) {
        state->slopes[slot] = 0.0f;
    }
    for (uint32_t slot = 0U; slot < 16U; ++slot) {
        state->levels[slot] = 0.0f;
    }
    state->slope = 0.0f;
    state->level = 0.0f;
    state->known = 0U;
}

void adaptive_window_step(adaptive_window_state *state, const adaptive_window_measurements *measurements,
                          adaptive_window_estimate *estimate)
{
    adaptive_window_work work;
    adaptive_window_part_1(state, measurements, &work);
    adaptive_window_part_2(state, &work);

    estimate->angle = work.t123;
    estimate->dangle = work.t126;
    estimate->status = work.t131;
}
