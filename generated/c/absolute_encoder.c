/* absolute_encoder.c: Finite-time observer: Speed of a drive from the counts of an encoder of one turn.
 *
 * Generated; absolute_encoder.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "absolute_encoder.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "absolute_encoder.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "absolute_encoder.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* weights by age, from age 1
 *   [0] q from y
 *   [1] dq from y
 *   [2] dq from u
 */
static const float ABSOLUTE_ENCODER_WINDOW[19][3] = {
    { 0.0f, 1.9896967f, 0.018441869f },
    { 0.0f, 1.8872669f, 0.017362881f },
    { 0.0f, 1.7533362f, 0.016251868f },
    { 0.0f, 1.58349f, 0.015111989f },
    { 0.0f, 1.3728054f, 0.013947159f },
    { 0.0f, 1.1157975f, 0.012762144f },
    { 0.0f, 0.8063605f, 0.011562678f },
    { 0.0f, 0.4377017f, 0.010355587f },
    { 0.0f, 0.0022701724f, 0.009148927f },
    { 0.0f, -0.5083227f, 0.007952139f },
    { 0.0f, -1.1033906f, 0.006776216f },
    { 0.0f, -1.7932678f, 0.005633901f },
    { 0.0f, -2.5894153f, 0.00453989f },
    { 0.0f, -3.5045373f, 0.0035110714f },
    { 0.0f, -4.552708f, 0.0025667779f },
    { 0.0f, -5.7495146f, 0.0017290782f },
    { 0.0f, -7.11221f, 0.0010230923f },
    { 0.0f, -8.659884f, 0.0004773408f },
    { 0.0f, -10.413651f, 0.00012413405f }
};

/* x towards zero as a signed number, two's complement, as far as single precision has them; NaN as 0. */
static uint32_t absolute_encoder_index_from_f32(float x)
{
    if (x >= 2147483520.0f) {
        return 2147483520U;
    }
    if (x <= -2147483648.0f) {
        return 2147483648U;
    }
    if (x > 0.0f) {
        return (uint32_t)x;
    }
    return (x < 0.0f) ? (0U - (uint32_t)(-x)) : 0U;
}

/* What one part of a step hands to the next. */
typedef struct {
    uint32_t t1;
    uint32_t t2;
    uint32_t t5;
    float t17;
    uint32_t t18;
    uint32_t t81;
    float t94;
    uint32_t t97;
    float t165;
    float t166;
    absolute_encoder_status t173;
    int flags[5]; /* t4, t15, t68, t70, t73 */
} absolute_encoder_work;

/* Part 1 of a step. */
static void absolute_encoder_part_1(const absolute_encoder_state *state, const absolute_encoder_measurements *measurements, const absolute_encoder_inputs *inputs, absolute_encoder_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    const uint32_t t0 = state->newest;
    work->t1 = (t0 < 20U) ? t0 : 20U;
    work->t2 = state->count;
    work->flags[0] = 20U < work->t2;
    work->t5 = (uint32_t)measurements->y;
    const float t14 = inputs->u;
    work->flags[1] = (-1e33f <= t14) && (t14 <= 1e33f);
    const float t16 = state->u[work->t1];
    work->t17 = work->flags[1] ? t14 : t16;
}

/* Part 2 of a step. */
static void absolute_encoder_part_2(absolute_encoder_state *state, absolute_encoder_work *work)
{
    /* prediction, for a sample that is missing */
    work->t18 = (work->t1 < 20U) ? (work->t1 + 1U) : 0U;
    const float t19 = state->ahead_y;
    const float t21 = 9.98668e-6f * work->t17;
    const float t22 = t19 + t21;
    const uint32_t t23 = state->y[work->t1];
    const float t24 = (float)t23;
    const float t25 = t24 * 0.00024414063f;
    const float t26 = t25 + 1.2582912e7f;
    const float t27 = t26 - 1.2582912e7f;
    const float t28 = t27 * 4096.0f;
    const float t29 = t24 - t28;
    const float t30 = 0.0015339808f * t29;
    const float t31 = t30 + 0.0007669904f;
    const float t32 = t31 * 0.15915494f;
    const float t33 = t32 + 1.2582912e7f;
    const float t34 = t33 - 1.2582912e7f;
    const float t35 = t34 * 6.2831855f;
    const float t36 = t31 - t35;
    const float t37 = t36 + t22;
    const float t38 = t37 * 0.15915494f;
    const float t39 = t38 + 1.2582912e7f;
    const float t40 = t39 - 1.2582912e7f;
    const float t41 = t40 * 6.2831855f;
    const float t42 = t37 - t41;
    const uint32_t t43 = (((work->t5 - t23) + 32768U) & 65535U) - 32768U;
    const float t44 = (t43 < 2147483648U) ? (float)t43 : -(float)(0U - t43);
    const float t45 = t44 * 0.00024414063f;
    const float t46 = t45 + 1.2582912e7f;
    const float t47 = t46 - 1.2582912e7f;
    const float t48 = t47 * 4096.0f;
    const float t49 = t44 - t48;
    const float t50 = 0.0015339808f * t49;
    const float t51 = t50 - t22;
    const float t52 = t51 * 0.15915494f;
    const float t53 = t52 + 1.2582912e7f;
    const float t54 = t53 - 1.2582912e7f;
    const float t55 = t54 * 6.2831855f;
    const float t56 = t51 - t55;
    const int t57 = (-6.2831855f <= t42) && (t42 <= 6.2831855f);
    const int t58 = (-0.05f <= t56) && (t56 <= 0.05f);
    const int t59 = !t58;
    const int t60 = t57 && t59;
    const int t61 = work->flags[0] && t60;
    const uint32_t t62 = state->rejected_y;
    const int t64 = t62 < 19U;
    const int t65 = t61 && t64;
    const uint32_t t66 = (t62 < 20U) ? (t62 + 1U) : 20U;
    const uint32_t t67 = t65 ? t66 : 0U;
    state->rejected_y = t67;
    work->flags[2] = !t65;
    const int t69 = !t64;
    work->flags[3] = t61 && t69;
    const int t71 = work->flags[0] && t57;
    const int t72 = work->flags[2] || t71;
    work->flags[4] = !t72;
    const float t75 = t22 * 651.8986f;
    const float t76 = t75 + 1.2582912e7f;
    const float t77 = t76 - 1.2582912e7f;
    const uint32_t t78 = absolute_encoder_index_from_f32(t77);
    const uint32_t t79 = t23 + t78;
    const uint32_t t80 = t71 ? t79 : t23;
    work->t81 = work->flags[2] ? work->t5 : t80;
    const float t82 = (float)work->t81;
    const float t83 = t82 * 0.00024414063f;
    const float t84 = t83 + 1.2582912e7f;
    const float t85 = t84 - 1.2582912e7f;
    const float t86 = t85 * 4096.0f;
    const float t87 = t82 - t86;
    const float t88 = 0.0015339808f * t87;
    const float t89 = t88 + 0.0007669904f;
    const float t90 = t89 * 0.15915494f;
    const float t91 = t90 + 1.2582912e7f;
    const float t92 = t91 - 1.2582912e7f;
    const float t93 = t92 * 6.2831855f;
    work->t94 = t89 - t93;
    const uint32_t t95 = state->since;
    const uint32_t t96 = (t95 < 4294967295U) ? (t95 + 1U) : 4294967295U;
    work->t97 = work->flags[2] ? 0U : t96;
    state->since = work->t97;
}

/* Part 3 of a step. */
static void absolute_encoder_part_3(absolute_encoder_state *state, absolute_encoder_work *work)
{
    /* how much of the window is good */
    const int t98 = !work->flags[3];
    const int t99 = work->flags[0] && t98;
    const int t100 = work->flags[1] && t98;
    const uint32_t t102 = (work->t2 < 21U) ? (work->t2 + 1U) : 21U;
    const uint32_t t103 = work->flags[4] ? 0U : t102;
    const uint32_t t104 = t100 ? t102 : 1U;
    const uint32_t t105 = work->flags[2] ? t104 : 0U;
    const uint32_t t106 = t99 ? t103 : t105;
    state->count = t106;
    const uint32_t t107 = state->coasting;
    const uint32_t t108 = (t107 > 0U) ? (t107 - 1U) : 0U;
    const uint32_t t109 = work->flags[1] ? t108 : 20U;
    const uint32_t t111 = work->flags[2] ? t109 : 21U;
    state->coasting = t111;

    /* into the window */
    state->newest = work->t18;
    state->y[work->t18] = (uint16_t)work->t81;
    state->u[work->t18] = work->t17;

    /* the sums over the window, newest sample first */
    const float t113 = state->u[work->t18];
    const float t115 = 0.019486334f * t113;
    const uint32_t t116 = ((work->t18 >= 1U) && (work->t18 < 21U)) ? (work->t18 - 1U) : 20U;
    float t117 = 0.0f;
    float t118 = 0.0f;
    float t119 = t115;
    uint32_t t120 = t116;
    uint32_t t121 = work->t81;
    float t122 = 0.0f;
    for (uint32_t row = 0U; row < 19U; ++row) {
        const float *const gains = ABSOLUTE_ENCODER_WINDOW[row];
        const uint32_t t123 = state->y[t120];
        const uint32_t t124 = (((t123 - t121) + 32768U) & 65535U) - 32768U;
        const float t125 = (t124 < 2147483648U) ? (float)t124 : -(float)(0U - t124);
        const float t126 = t125 * 0.00024414063f;
        const float t127 = t126 + 1.2582912e7f;
        const float t128 = t127 - 1.2582912e7f;
        const float t129 = t128 * 4096.0f;
        const float t130 = t125 - t129;
        const float t131 = t122 + t130;
        const float t132 = 0.0015339808f * t131;
        const float t133 = gains[0];
        const float t134 = t133 * t132;
        const float t135 = t117 + t134;
        const float t136 = gains[1];
        const float t137 = t136 * t132;
        const float t138 = t118 + t137;
        const float t139 = state->u[t120];
        const float t140 = gains[2];
        const float t141 = t140 * t139;
        const float t142 = t119 + t141;
        const uint32_t t143 = ((t120 >= 1U) && (t120 < 21U)) ? (t120 - 1U) : 20U;
        t117 = t135;
        t118 = t138;
        t119 = t142;
        t120 = t143;
        t121 = t123;
        t122 = t131;
    }
    const uint32_t t144 = state->y[t120];
    const uint32_t t145 = (((t144 - t121) + 32768U) & 65535U) - 32768U;
    const float t146 = (t145 < 2147483648U) ? (float)t145 : -(float)(0U - t145);
    const float t147 = t146 * 0.00024414063f;
    const float t148 = t147 + 1.2582912e7f;
    const float t149 = t148 - 1.2582912e7f;
    const float t150 = t149 * 4096.0f;
    const float t151 = t146 - t150;
    const float t152 = t122 + t151;
    const float t153 = 0.0015339808f * t152;
    const float t154 = 0.0f * t153;
    const float t155 = t117 + t154;
    const float t157 = -12.396859f * t153;
    const float t158 = t118 + t157;
    const float t159 = t158 + t119;

    /* the next measurement, as far as it is known */
    const float t161 = 0.0009980027f * t159;
    const float t162 = t155 + t161;
    state->ahead_y = t162;

    /* the estimate; until the window is full, the start */
    const float t163 = t155 + work->t94;
    const int t164 = 20U < t106;
    work->t165 = t164 ? t163 : work->t94;
    work->t166 = t164 ? t159 : 0.0f;
    const uint32_t t167 = state->coasting;
    const int t168 = t167 == 0U;
    const absolute_encoder_status t172 = t168 ? ABSOLUTE_ENCODER_CONVERGED : ABSOLUTE_ENCODER_COASTING;
    work->t173 = t164 ? t172 : ABSOLUTE_ENCODER_CONVERGING;
}

void absolute_encoder_init(absolute_encoder_state *state)
{
    for (uint32_t slot = 0U; slot < 21U; ++slot) {
        state->y[slot] = 0U;
    }
    for (uint32_t slot = 0U; slot < 21U; ++slot) {
        state->u[slot] = 0.0f;
    }
    state->newest = 20U;
    state->count = 0U;
    state->rejected_y = 0U;
    state->coasting = 0U;
    state->ahead_y = 0.0f;
    state->since = 0U;
}

void absolute_encoder_step(absolute_encoder_state *state, const absolute_encoder_measurements *measurements,
                           const absolute_encoder_inputs *inputs, absolute_encoder_estimate *estimate)
{
    absolute_encoder_work work;
    absolute_encoder_part_1(state, measurements, inputs, &work);
    absolute_encoder_part_2(state, &work);
    absolute_encoder_part_3(state, &work);

    estimate->q = work.t165;
    estimate->dq = work.t166;
    estimate->coasted = work.t97;
    estimate->status = work.t173;
}
