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
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
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
    uint32_t t19;
    uint32_t t36;
    uint32_t t44;
    float t148;
    float t151;
    adaptive_window_status t156;
    int flags[1]; /* t1 */
} adaptive_window_work;

/* Part 1 of a step. */
static void adaptive_window_part_1(adaptive_window_state *state, const adaptive_window_measurements *measurements, adaptive_window_work *work)
{
    /* the sample: outside its range, infinite or NaN means missing */
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
    const float t15 = t12 - t14;
    const float t16 = state->last_angle;
    const uint32_t t17 = state->since;
    const uint32_t t18 = (t17 < 17U) ? (t17 + 1U) : 17U;
    work->t19 = 0U;
    const float t20 = t15 - t16;
    const float t21 = t20 * 0.15915494f;
    const float t22 = t21 + 1.2582912e7f;
    const float t23 = t22 - 1.2582912e7f;
    const float t25 = t23 * 6.2831855f;
    const float t26 = t20 - t25;
    const float t27 = (float)t18;
    const uint32_t t28 = state->newest;
    const uint32_t t29 = (t28 < 15U) ? t28 : 15U;
    const uint32_t t30 = (t29 < 15U) ? (t29 + 1U) : 0U;
    const uint32_t t31 = work->flags[0] ? t30 : t29;
    const float t32 = state->moves[t31];
    const float t33 = state->gaps[t31];
    const float t34 = work->flags[0] ? t26 : t32;
    const float t35 = work->flags[0] ? t27 : t33;
    state->moves[t31] = t34;
    state->gaps[t31] = t35;
    state->newest = t31;
    work->t36 = work->flags[0] ? work->t19 : t18;
    state->since = work->t36;
    const float t37 = work->flags[0] ? t15 : t16;
    state->last_angle = t37;
    const uint32_t t38 = state->samples;
    const uint32_t t39 = (t38 < 17U) ? (t38 + 1U) : 17U;
    const uint32_t t40 = work->flags[0] ? t39 : t38;
    state->samples = t40;

    /* the line through each number of samples */
    const uint32_t t43 = state->newest;
    work->t44 = (t43 < 15U) ? t43 : 15U;
    uint32_t t45 = work->t44;
    uint32_t t46 = work->t19;
    float t47 = 0.0f;
    float t48 = 0.0f;
    float t49 = 1.0f;
    float t50 = 0.0f;
    float t51 = 0.0f;
    float t52 = 0.0f;
    float t53 = 0.0f;
    for (uint32_t row = 0U; row < 16U; ++row) {
        const float t54 = state->gaps[t45];
        const float t55 = state->moves[t45];
        const float t56 = t47 + t54;
        const float t57 = t48 - t55;
        const float t58 = t49 + 1.0f;
        const float t59 = t56 * t56;
        const float t60 = t56 * t57;
        const float t61 = t50 + t56;
        const float t62 = t51 + t59;
        const float t63 = t52 + t57;
        const float t64 = t53 + t60;
        const float t65 = t58 * t62;
        const float t66 = t61 * t61;
        const float t67 = t65 - t66;
        const float t68 = t58 * t64;
        const float t69 = t61 * t63;
        const float t70 = t68 - t69;
        const float t71 = t70 / t67;
        const float t72 = t71 * t61;
        const float t73 = t63 - t72;
        const float t74 = t73 / t58;
        state->slopes[t46] = t71;
        state->levels[t46] = t74;
        const uint32_t t75 = ((t45 >= 1U) && (t45 < 16U)) ? (t45 - 1U) : 15U;
        const uint32_t t76 = (t46 < 15U) ? (t46 + 1U) : 0U;
        t45 = t75;
        t46 = t76;
        t47 = t56;
        t48 = t57;
        t49 = t58;
        t50 = t61;
        t51 = t62;
        t52 = t63;
        t53 = t64;
    }
}

/* Part 2 of a step. */
static void adaptive_window_part_2(adaptive_window_state *state, adaptive_window_work *work)
{
    /* the longest that leaves no sample further off than the deviation */
    const uint32_t t79 = state->samples;
    const float t80 = state->slopes[work->t19];
    const float t81 = state->levels[work->t19];
    const float t82 = state->gaps[work->t44];
    const int t83 = t82 <= 16.0f;
    const int t85 = 1U < t79;
    const int t86 = t83 && t85;
    uint32_t t88 = 2U;
    uint32_t t89 = work->t19;
    uint32_t t90 = work->t44;
    float t91 = 0.0f;
    float t92 = 0.0f;
    int t93 = 1;
    int t94 = t86;
    float t95 = t80;
    float t96 = t81;
    for (uint32_t row = 0U; row < 150U; ++row) {
        const uint32_t t97 = (t88 > 0U) ? (t88 - 1U) : 0U;
        const uint32_t t98 = (t97 < 15U) ? t97 : 15U;
        const float t99 = state->slopes[t98];
        const float t100 = state->levels[t98];
        const float t101 = t99 * t91;
        const float t102 = t100 + t101;
        const float t103 = t92 - t102;
        const int t104 = (-0.0015339808f <= t103) && (t103 <= 0.0015339808f);
        const int t105 = t93 && t104;
        const int t106 = t89 == t88;
        const int t107 = t91 <= 16.0f;
        const int t108 = t88 < t79;
        const int t109 = t105 && t107;
        const int t110 = t109 && t108;
        const int t111 = t110 && t94;
        const int t112 = t106 && t111;
        const float t113 = t112 ? t99 : t95;
        const float t114 = t112 ? t100 : t96;
        const int t115 = t106 ? t111 : t94;
        const int t116 = t106 ? 1 : t105;
        const float t117 = state->gaps[t90];
        const float t118 = state->moves[t90];
        const float t119 = t91 + t117;
        const float t120 = t92 - t118;
        const float t121 = t106 ? 0.0f : t119;
        const float t122 = t106 ? 0.0f : t120;
        const uint32_t t123 = ((t90 >= 1U) && (t90 < 16U)) ? (t90 - 1U) : 15U;
        const uint32_t t124 = (t88 < 16U) ? (t88 + 1U) : 16U;
        const uint32_t t125 = (t89 < 16U) ? (t89 + 1U) : 16U;
        const uint32_t t126 = t106 ? work->t44 : t123;
        const uint32_t t127 = t106 ? t124 : t88;
        const uint32_t t128 = t106 ? work->t19 : t125;
        t88 = t127;
        t89 = t128;
        t90 = t126;
        t91 = t121;
        t92 = t122;
        t93 = t116;
        t94 = t115;
        t95 = t113;
        t96 = t114;
    }

    /* the estimate: the line at this call, and its slope */
    const uint32_t t129 = state->known;
    const int t130 = t129 == 1U;
    const int t131 = work->flags[0] ? t86 : t130;
    const float t132 = state->slope;
    const float t133 = state->level;
    const float t134 = t86 ? t95 : 0.0f;
    const float t135 = t86 ? t96 : 0.0f;
    const float t136 = work->flags[0] ? t134 : t132;
    const float t137 = work->flags[0] ? t135 : t133;
    state->slope = t136;
    state->level = t137;
    const uint32_t t138 = t131 ? 1U : work->t19;
    state->known = t138;
    const float t139 = state->last_angle;
    const float t140 = (float)work->t36;
    const float t141 = t136 * t140;
    const float t142 = t137 - t141;
    const float t143 = t139 + t142;
    const float t144 = t143 * 0.15915494f;
    const float t145 = t144 + 1.2582912e7f;
    const float t146 = t145 - 1.2582912e7f;
    const float t147 = t146 * 6.2831855f;
    work->t148 = t143 - t147;
    const float t150 = t136 / 0.001f;
    work->t151 = 0.0f - t150;
    const adaptive_window_status t155 = work->flags[0] ? ADAPTIVE_WINDOW_CONVERGED : ADAPTIVE_WINDOW_COASTING;
    work->t156 = t131 ? t155 : ADAPTIVE_WINDOW_CONVERGING;
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

    estimate->angle = work.t148;
    estimate->dangle = work.t151;
    estimate->status = work.t156;
}
