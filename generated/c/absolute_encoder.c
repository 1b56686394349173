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
#pragma GCC optimize("fp-contract=off")
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
    uint32_t t2;
    float t16;
    uint32_t t17;
    uint32_t t74;
    float t81;
    uint32_t t84;
    float t148;
    float t149;
    absolute_encoder_status t156;
    int flags[5]; /* t4, t14, t61, t63, t66 */
} absolute_encoder_work;

/* Part 1 of a step. */
static void absolute_encoder_part_1(absolute_encoder_state *state, const absolute_encoder_measurements *measurements, const absolute_encoder_inputs *inputs, absolute_encoder_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    const uint32_t t0 = state->newest;
    const uint32_t t1 = (t0 < 20U) ? t0 : 20U;
    work->t2 = state->count;
    work->flags[0] = 20U < work->t2;
    const uint32_t t5 = (uint32_t)measurements->y;
    const float t13 = inputs->u;
    work->flags[1] = (-1e35f <= t13) && (t13 <= 1e35f);
    const float t15 = state->u[t1];
    work->t16 = work->flags[1] ? t13 : t15;

    /* prediction, for a sample that is missing */
    work->t17 = (t1 < 20U) ? (t1 + 1U) : 0U;
    const float t18 = state->ahead_y;
    const float t20 = 9.98668e-6f * work->t16;
    const float t21 = t18 + t20;
    const uint32_t t22 = state->y[t1];
    const float t23 = (float)t22;
    const float t24 = t23 * 0.00024414063f;
    const float t25 = t24 + 1.2582912e7f;
    const float t26 = t25 - 1.2582912e7f;
    const float t27 = t26 * 4096.0f;
    const float t28 = t23 - t27;
    const float t29 = 0.0015339808f * t28;
    const float t30 = t29 + t21;
    const float t31 = t30 * 0.15915494f;
    const float t32 = t31 + 1.2582912e7f;
    const float t33 = t32 - 1.2582912e7f;
    const float t34 = t33 * 6.2831855f;
    const float t35 = t30 - t34;
    const uint32_t t36 = (((t5 - t22) + 32768U) & 65535U) - 32768U;
    const float t37 = (t36 < 2147483648U) ? (float)t36 : -(float)(0U - t36);
    const float t38 = t37 * 0.00024414063f;
    const float t39 = t38 + 1.2582912e7f;
    const float t40 = t39 - 1.2582912e7f;
    const float t41 = t40 * 4096.0f;
    const float t42 = t37 - t41;
    const float t43 = 0.0015339808f * t42;
    const float t44 = t43 - t21;
    const float t45 = t44 * 0.15915494f;
    const float t46 = t45 + 1.2582912e7f;
    const float t47 = t46 - 1.2582912e7f;
    const float t48 = t47 * 6.2831855f;
    const float t49 = t44 - t48;
    const int t50 = (-6.2831855f <= t35) && (t35 <= 6.2831855f);
    const int t51 = (-0.05f <= t49) && (t49 <= 0.05f);
    const int t52 = !t51;
    const int t53 = t50 && t52;
    const int t54 = work->flags[0] && t53;
    const uint32_t t55 = state->rejected_y;
    const int t57 = t55 < 19U;
    const int t58 = t54 && t57;
    const uint32_t t59 = (t55 < 20U) ? (t55 + 1U) : 20U;
    const uint32_t t60 = t58 ? t59 : 0U;
    state->rejected_y = t60;
    work->flags[2] = !t58;
    const int t62 = !t57;
    work->flags[3] = t54 && t62;
    const int t64 = work->flags[0] && t50;
    const int t65 = work->flags[2] || t64;
    work->flags[4] = !t65;
    const float t68 = t21 * 651.8986f;
    const float t69 = t68 + 1.2582912e7f;
    const float t70 = t69 - 1.2582912e7f;
    const uint32_t t71 = absolute_encoder_index_from_f32(t70);
    const uint32_t t72 = t22 + t71;
    const uint32_t t73 = t64 ? t72 : t22;
    work->t74 = work->flags[2] ? t5 : t73;
    const float t75 = (float)work->t74;
    const float t76 = t75 * 0.00024414063f;
    const float t77 = t76 + 1.2582912e7f;
    const float t78 = t77 - 1.2582912e7f;
    const float t79 = t78 * 4096.0f;
    const float t80 = t75 - t79;
    work->t81 = 0.0015339808f * t80;
    const uint32_t t82 = state->since;
    const uint32_t t83 = (t82 < 4294967295U) ? (t82 + 1U) : 4294967295U;
    work->t84 = work->flags[2] ? 0U : t83;
    state->since = work->t84;
}

/* Part 2 of a step. */
static void absolute_encoder_part_2(absolute_encoder_state *state, absolute_encoder_work *work)
{
    /* how much of the window is good */
    const int t85 = !work->flags[3];
    const int t86 = work->flags[0] && t85;
    const int t87 = work->flags[1] && t85;
    const uint32_t t89 = (work->t2 < 21U) ? (work->t2 + 1U) : 21U;
    const uint32_t t90 = work->flags[4] ? 0U : t89;
    const uint32_t t91 = t87 ? t89 : 1U;
    const uint32_t t92 = work->flags[2] ? t91 : 0U;
    const uint32_t t93 = t86 ? t90 : t92;
    state->count = t93;
    const uint32_t t94 = state->coasting;
    const uint32_t t95 = (t94 > 0U) ? (t94 - 1U) : 0U;
    const uint32_t t96 = work->flags[1] ? t95 : 20U;
    const uint32_t t98 = work->flags[2] ? t96 : 21U;
    state->coasting = t98;

    /* into the window */
    state->newest = work->t17;
    state->y[work->t17] = (uint16_t)work->t74;
    state->u[work->t17] = work->t16;

    /* the sums over the window, newest sample first */
    const float t99 = state->u[work->t17];
    const float t101 = 0.019486334f * t99;
    const uint32_t t102 = ((work->t17 >= 1U) && (work->t17 < 21U)) ? (work->t17 - 1U) : 20U;
    float t104 = 0.0f;
    float t105 = 0.0f;
    float t106 = t101;
    uint32_t t107 = t102;
    for (uint32_t row = 0U; row < 19U; ++row) {
        const float *const gains = ABSOLUTE_ENCODER_WINDOW[row];
        const uint32_t t108 = state->y[t107];
        const uint32_t t109 = (((t108 - work->t74) + 32768U) & 65535U) - 32768U;
        const float t110 = (t109 < 2147483648U) ? (float)t109 : -(float)(0U - t109);
        const float t111 = t110 * 0.00024414063f;
        const float t112 = t111 + 1.2582912e7f;
        const float t113 = t112 - 1.2582912e7f;
        const float t114 = t113 * 4096.0f;
        const float t115 = t110 - t114;
        const float t116 = 0.0015339808f * t115;
        const float t117 = gains[0];
        const float t118 = t117 * t116;
        const float t119 = t104 + t118;
        const float t120 = gains[1];
        const float t121 = t120 * t116;
        const float t122 = t105 + t121;
        const float t123 = state->u[t107];
        const float t124 = gains[2];
        const float t125 = t124 * t123;
        const float t126 = t106 + t125;
        const uint32_t t127 = ((t107 >= 1U) && (t107 < 21U)) ? (t107 - 1U) : 20U;
        t104 = t119;
        t105 = t122;
        t106 = t126;
        t107 = t127;
    }
    const uint32_t t128 = state->y[t107];
    const uint32_t t129 = (((t128 - work->t74) + 32768U) & 65535U) - 32768U;
    const float t130 = (t129 < 2147483648U) ? (float)t129 : -(float)(0U - t129);
    const float t131 = t130 * 0.00024414063f;
    const float t132 = t131 + 1.2582912e7f;
    const float t133 = t132 - 1.2582912e7f;
    const float t134 = t133 * 4096.0f;
    const float t135 = t130 - t134;
    const float t136 = 0.0015339808f * t135;
    const float t137 = 0.0f * t136;
    const float t138 = t104 + t137;
    const float t140 = -12.396859f * t136;
    const float t141 = t105 + t140;
    const float t142 = t141 + t106;

    /* the next measurement, as far as it is known */
    const float t144 = 0.0009980027f * t142;
    const float t145 = t138 + t144;
    state->ahead_y = t145;

    /* the estimate; until the window is full, the start */
    const float t146 = t138 + work->t81;
    const int t147 = 20U < t93;
    work->t148 = t147 ? t146 : work->t81;
    work->t149 = t147 ? t142 : 0.0f;
    const uint32_t t150 = state->coasting;
    const int t151 = t150 == 0U;
    const absolute_encoder_status t155 = t151 ? ABSOLUTE_ENCODER_CONVERGED : ABSOLUTE_ENCODER_COASTING;
    work->t156 = t147 ? t155 : ABSOLUTE_ENCODER_CONVERGING;
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

    estimate->q = work.t148;
    estimate->dq = work.t149;
    estimate->coasted = work.t84;
    estimate->status = work.t156;
}
