/* lossy_encoder.c: Finite-time observer: Speed and acceleration of an arm from an encoder on a bus that loses frames.
 *
 * Generated; lossy_encoder.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "lossy_encoder.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "lossy_encoder.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "lossy_encoder.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* orthonormal rows of the window, oldest first
 *   [0] y in direction 1
 *   [1] y in direction 2
 *   [2] y in direction 3
 */
static const float LOSSY_ENCODER_ROWS[130][3] = {
    { 0.0873704f, -0.14786872f, 0.18212998f },
    { 0.0873704f, -0.14555827f, 0.17345387f },
    { 0.0873704f, -0.14324783f, 0.16491438f },
    { 0.0873704f, -0.14093737f, 0.15651155f },
    { 0.0873704f, -0.13862692f, 0.14824533f },
    { 0.0873704f, -0.13631648f, 0.14011575f },
    { 0.0873704f, -0.13400602f, 0.1321228f },
    { 0.0873704f, -0.13169558f, 0.124266475f },
    { 0.0873704f, -0.12938513f, 0.11654679f },
    { 0.0873704f, -0.12707467f, 0.108963735f },
    { 0.0873704f, -0.124764234f, 0.10151731f },
    { 0.0873704f, -0.12245378f, 0.09420752f },
    { 0.0873704f, -0.12014333f, 0.08703435f },
    { 0.0873704f, -0.117832884f, 0.07999782f },
    { 0.0873704f, -0.11552244f, 0.07309793f },
    { 0.0873704f, -0.11321199f, 0.066334665f },
    { 0.0873704f, -0.11090154f, 0.059708025f },
    { 0.0873704f, -0.10859109f, 0.053218026f },
    { 0.0873704f, -0.10628064f, 0.04686465f },
    { 0.0873704f, -0.10397019f, 0.040647913f },
    { 0.0873704f, -0.101659745f, 0.034567807f },
    { 0.0873704f, -0.0993493f, 0.028624328f },
    { 0.0873704f, -0.09703884f, 0.022817483f },
    { 0.0873704f, -0.094728395f, 0.017147271f },
    { 0.0873704f, -0.09241795f, 0.011613689f },
    { 0.0873704f, -0.0901075f, 0.00621674f },
    { 0.0873704f, -0.08779705f, 0.0009564215f },
    { 0.0873704f, -0.085486606f, -0.0041672653f },
    { 0.0873704f, -0.08317615f, -0.00915432f },
    { 0.0873704f, -0.0808657f, -0.014004743f },
    { 0.0873704f, -0.078555256f, -0.018718535f },
    { 0.0873704f, -0.07624481f, -0.023295695f },
    { 0.0873704f, -0.07393436f, -0.027736222f },
    { 0.0873704f, -0.071623914f, -0.03204012f },
    { 0.0873704f, -0.06931346f, -0.036207385f },
    { 0.0873704f, -0.06700301f, -0.04023802f },
    { 0.0873704f, -0.064692564f, -0.04413202f },
    { 0.0873704f, -0.062382117f, -0.04788939f },
    { 0.0873704f, -0.060071666f, -0.05151013f },
    { 0.0873704f, -0.05776122f, -0.054994237f },
    { 0.0873704f, -0.05545077f, -0.05834171f },
    { 0.0873704f, -0.05314032f, -0.061552554f },
    { 0.0873704f, -0.050829872f, -0.06462677f },
    { 0.0873704f, -0.04851942f, -0.067564346f },
    { 0.0873704f, -0.046208974f, -0.070365295f },
    { 0.0873704f, -0.043898527f, -0.073029615f },
    { 0.0873704f, -0.041588075f, -0.0755573f },
    { 0.0873704f, -0.039277628f, -0.077948354f },
    { 0.0873704f, -0.03696718f, -0.08020277f },
    { 0.0873704f, -0.03465673f, -0.08232056f },
    { 0.0873704f, -0.032346282f, -0.084301725f },
    { 0.0873704f, -0.030035833f, -0.08614625f },
    { 0.0873704f, -0.027725386f, -0.08785415f },
    { 0.0873704f, -0.025414936f, -0.08942541f },
    { 0.0873704f, -0.023104487f, -0.09086004f },
    { 0.0873704f, -0.020794038f, -0.09215804f },
    { 0.0873704f, -0.01848359f, -0.09331941f },
    { 0.0873704f, -0.016173141f, -0.09434415f },
    { 0.0873704f, -0.013862693f, -0.095232256f },
    { 0.0873704f, -0.0115522435f, -0.09598373f },
    { 0.0873704f, -0.009241795f, -0.09659857f },
    { 0.0873704f, -0.0069313464f, -0.09707678f },
    { 0.0873704f, -0.0046208976f, -0.09741836f },
    { 0.0873704f, -0.0023104488f, -0.0976233f },
    { 0.0873704f, 0.0f, -0.097691625f },
    { 0.0873704f, 0.0023104488f, -0.0976233f },
    { 0.0873704f, 0.0046208976f, -0.09741836f },
    { 0.0873704f, 0.0069313464f, -0.09707678f },
    { 0.0873704f, 0.009241795f, -0.09659857f },
    { 0.0873704f, 0.0115522435f, -0.09598373f },
    { 0.0873704f, 0.013862693f, -0.095232256f },
    { 0.0873704f, 0.016173141f, -0.09434415f },
    { 0.0873704f, 0.01848359f, -0.09331941f },
    { 0.0873704f, 0.020794038f, -0.09215804f },
    { 0.0873704f, 0.023104487f, -0.09086004f },
    { 0.0873704f, 0.025414936f, -0.08942541f },
    { 0.0873704f, 0.027725386f, -0.08785415f },
    { 0.0873704f, 0.030035833f, -0.08614625f },
    { 0.0873704f, 0.032346282f, -0.084301725f },
    { 0.0873704f, 0.03465673f, -0.08232056f },
    { 0.0873704f, 0.03696718f, -0.08020277f },
    { 0.0873704f, 0.039277628f, -0.077948354f },
    { 0.0873704f, 0.041588075f, -0.0755573f },
    { 0.0873704f, 0.043898527f, -0.073029615f },
    { 0.0873704f, 0.046208974f, -0.070365295f },
    { 0.0873704f, 0.04851942f, -0.067564346f },
    { 0.0873704f, 0.050829872f, -0.06462677f },
    { 0.0873704f, 0.05314032f, -0.061552554f },
    { 0.0873704f, 0.05545077f, -0.05834171f },
    { 0.0873704f, 0.05776122f, -0.054994237f },
    { 0.0873704f, 0.060071666f, -0.05151013f },
    { 0.0873704f, 0.062382117f, -0.04788939f },
    { 0.0873704f, 0.064692564f, -0.04413202f },
    { 0.0873704f, 0.06700301f, -0.04023802f },
    { 0.0873704f, 0.06931346f, -0.036207385f },
    { 0.0873704f, 0.071623914f, -0.03204012f },
    { 0.0873704f, 0.07393436f, -0.027736222f },
    { 0.0873704f, 0.07624481f, -0.023295695f },
    { 0.0873704f, 0.078555256f, -0.018718535f },
    { 0.0873704f, 0.0808657f, -0.014004743f },
    { 0.0873704f, 0.08317615f, -0.00915432f },
    { 0.0873704f, 0.085486606f, -0.0041672653f },
    { 0.0873704f, 0.08779705f, 0.0009564215f },
    { 0.0873704f, 0.0901075f, 0.00621674f },
    { 0.0873704f, 0.09241795f, 0.011613689f },
    { 0.0873704f, 0.094728395f, 0.017147271f },
    { 0.0873704f, 0.09703884f, 0.022817483f },
    { 0.0873704f, 0.0993493f, 0.028624328f },
    { 0.0873704f, 0.101659745f, 0.034567807f },
    { 0.0873704f, 0.10397019f, 0.040647913f },
    { 0.0873704f, 0.10628064f, 0.04686465f },
    { 0.0873704f, 0.10859109f, 0.053218026f },
    { 0.0873704f, 0.11090154f, 0.059708025f },
    { 0.0873704f, 0.11321199f, 0.066334665f },
    { 0.0873704f, 0.11552244f, 0.07309793f },
    { 0.0873704f, 0.117832884f, 0.07999782f },
    { 0.0873704f, 0.12014333f, 0.08703435f },
    { 0.0873704f, 0.12245378f, 0.09420752f },
    { 0.0873704f, 0.124764234f, 0.10151731f },
    { 0.0873704f, 0.12707467f, 0.108963735f },
    { 0.0873704f, 0.12938513f, 0.11654679f },
    { 0.0873704f, 0.13169558f, 0.124266475f },
    { 0.0873704f, 0.13400602f, 0.1321228f },
    { 0.0873704f, 0.13631648f, 0.14011575f },
    { 0.0873704f, 0.13862692f, 0.14824533f },
    { 0.0873704f, 0.14093737f, 0.15651155f },
    { 0.0873704f, 0.14324783f, 0.16491438f },
    { 0.0873704f, 0.14555827f, 0.17345387f },
    { 0.0873704f, 0.14786872f, 0.18212998f },
    { 0.0873704f, 0.15017916f, 0.19094272f }
};

/* What one part of a step hands to the next. */
typedef struct {
    uint32_t t4;
    float t5;
    float t6;
    float t7;
    float t10;
    uint32_t t14;
    float t52;
    float t53;
    float t54;
    float t55;
    float t56;
    float t57;
    float t58;
    float t59;
    float t60;
    float t61;
    float t62;
    float t63;
    float t157;
    float t160;
    float t163;
    float t181;
    float t182;
    float t183;
    lossy_encoder_status t191;
    int flags[3]; /* t23, t126, t165 */
} lossy_encoder_work;

/* Part 1 of a step. */
static void lossy_encoder_part_1(lossy_encoder_state *state, const lossy_encoder_measurements *measurements, lossy_encoder_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    const uint32_t t0 = state->newest;
    const uint32_t t1 = (t0 < 130U) ? t0 : 130U;
    const float t2 = measurements->y;
    const int t3 = (-1e26f <= t2) && (t2 <= 1e26f);
    work->t4 = (t1 < 130U) ? (t1 + 1U) : 0U;
    work->t5 = state->next_q;
    work->t6 = state->next_dq;
    work->t7 = state->next_ddq;
    const float t9 = state->y[t1];
    work->t10 = t3 ? t2 : t9;
    const uint32_t t12 = state->since;
    const uint32_t t13 = (t12 < 4294967295U) ? (t12 + 1U) : 4294967295U;
    work->t14 = t3 ? 0U : t13;
    state->since = work->t14;
    const float t16 = t3 ? 1.0f : 0.0f;
    const uint32_t t17 = state->count;

    /* how much of the window is good */
    const uint32_t t20 = (t17 < 131U) ? (t17 + 1U) : 131U;
    state->count = t20;
    const uint32_t t21 = state->coasting;
    const uint32_t t22 = (t21 > 0U) ? (t21 - 1U) : 0U;
    state->coasting = t22;

    /* into the window */
    state->newest = work->t4;
    state->y[work->t4] = work->t10;
    state->has_y[work->t4] = t16;
    work->flags[0] = 130U < t20;
}

/* Part 2 of a step. */
static void lossy_encoder_part_2(const lossy_encoder_state *state, lossy_encoder_work *work)
{
    /* rows of the window, oldest first; those without a sample count nothing */
    const uint32_t t24 = (work->t4 < 130U) ? (work->t4 + 1U) : 0U;
    const float t28 = state->has_y[t24];
    const float t29 = state->y[t24];
    const float t30 = t29 - 0.0f;
    const float t31 = t28 * 0.0873704f;
    const float t32 = t28 * -0.15017916f;
    const float t33 = t28 * 0.19094272f;
    const float t34 = t31 * t31;
    const float t35 = 0.0f + t34;
    const float t36 = t31 * t32;
    const float t37 = 0.0f + t36;
    const float t38 = t31 * t33;
    const float t39 = 0.0f + t38;
    const float t40 = t32 * t32;
    const float t41 = 0.0f + t40;
    const float t42 = t32 * t33;
    const float t43 = 0.0f + t42;
    const float t44 = t33 * t33;
    const float t45 = 0.0f + t44;
    const float t46 = t31 * t30;
    const float t47 = 0.0f + t46;
    const float t48 = t32 * t30;
    const float t49 = 0.0f + t48;
    const float t50 = t33 * t30;
    const float t51 = 0.0f + t50;
    work->t52 = t35;
    work->t53 = t37;
    work->t54 = t39;
    work->t55 = t41;
    work->t56 = t43;
    work->t57 = t45;
    work->t58 = t47;
    work->t59 = t49;
    work->t60 = t51;
    work->t61 = 0.0f;
    work->t62 = 0.0f;
    work->t63 = 0.0f;
    uint32_t t64 = t24;
    for (uint32_t row = 0U; row < 130U; ++row) {
        const float *const gains = LOSSY_ENCODER_ROWS[row];
        const uint32_t t65 = (t64 < 130U) ? (t64 + 1U) : 0U;
        const float t67 = 0.001f * work->t62;
        const float t69 = 5e-7f * work->t63;
        const float t70 = work->t61 + t67;
        const float t71 = t70 + t69;
        const float t72 = 0.001f * work->t63;
        const float t73 = work->t62 + t72;
        const float t74 = gains[0];
        const float t75 = gains[1];
        const float t76 = gains[2];
        const float t77 = state->has_y[t65];
        const float t78 = state->y[t65];
        const float t79 = t78 - t71;
        const float t80 = t77 * t74;
        const float t81 = t77 * t75;
        const float t82 = t77 * t76;
        const float t83 = t80 * t80;
        const float t84 = work->t52 + t83;
        const float t85 = t80 * t81;
        const float t86 = work->t53 + t85;
        const float t87 = t80 * t82;
        const float t88 = work->t54 + t87;
        const float t89 = t81 * t81;
        const float t90 = work->t55 + t89;
        const float t91 = t81 * t82;
        const float t92 = work->t56 + t91;
        const float t93 = t82 * t82;
        const float t94 = work->t57 + t93;
        const float t95 = t80 * t79;
        const float t96 = work->t58 + t95;
        const float t97 = t81 * t79;
        const float t98 = work->t59 + t97;
        const float t99 = t82 * t79;
        const float t100 = work->t60 + t99;
        const float t101 = work->t63 - 0.0f;
        work->t52 = t84;
        work->t53 = t86;
        work->t54 = t88;
        work->t55 = t90;
        work->t56 = t92;
        work->t57 = t94;
        work->t58 = t96;
        work->t59 = t98;
        work->t60 = t100;
        work->t61 = t71;
        work->t62 = t73;
        work->t63 = t101;
        t64 = t65;
    }
}

/* Part 3 of a step. */
static void lossy_encoder_part_3(lossy_encoder_state *state, lossy_encoder_work *work)
{
    /* the window's start from the samples that are there */
    const int t103 = 0.015625f < work->t52;
    const float t104 = t103 ? work->t52 : 1.0f;
    const float t105 = work->t53 / t104;
    const float t106 = t105 * work->t53;
    const float t107 = work->t55 - t106;
    const float t108 = t105 * work->t54;
    const float t109 = work->t56 - t108;
    const float t110 = t105 * work->t58;
    const float t111 = work->t59 - t110;
    const float t112 = work->t54 / t104;
    const float t113 = t112 * work->t54;
    const float t114 = work->t57 - t113;
    const float t115 = t112 * work->t58;
    const float t116 = work->t60 - t115;
    const int t117 = 0.015625f < t107;
    const int t118 = t103 && t117;
    const float t119 = t117 ? t107 : 1.0f;
    const float t120 = t109 / t119;
    const float t121 = t120 * t109;
    const float t122 = t114 - t121;
    const float t123 = t120 * t111;
    const float t124 = t116 - t123;
    const int t125 = 0.015625f < t122;
    work->flags[1] = t118 && t125;
    const float t127 = t125 ? t122 : 1.0f;
    const float t128 = t124 / t127;
    const float t129 = t109 * t128;
    const float t130 = t111 - t129;
    const float t131 = t130 / t119;
    const float t132 = work->t53 * t131;
    const float t133 = work->t58 - t132;
    const float t134 = work->t54 * t128;
    const float t135 = t133 - t134;
    const float t136 = t135 / t104;
    const float t137 = 0.0873704f * t136;
    const float t139 = 0.15017916f * t131;
    const float t140 = 0.19094272f * t128;
    const float t141 = t137 + t139;
    const float t142 = t141 + t140;
    const float t143 = t142 + work->t61;
    const float t145 = 2.3104486f * t131;
    const float t147 = 8.881057f * t128;
    const float t148 = t145 + t147;
    const float t149 = t148 + work->t62;
    const float t151 = 136.63164f * t128;
    const float t152 = t151 + work->t63;

    /* without enough samples, the model's prediction */
    const uint32_t t153 = state->known;
    const int t154 = t153 == 1U;
    const int t155 = (-1e26f <= work->t5) && (work->t5 <= 1e26f);
    const int t156 = t154 && t155;
    work->t157 = work->flags[1] ? t143 : work->t5;
    const int t158 = (-1e26f <= work->t6) && (work->t6 <= 1e26f);
    const int t159 = t156 && t158;
    work->t160 = work->flags[1] ? t149 : work->t6;
    const int t161 = (-1e26f <= work->t7) && (work->t7 <= 1e26f);
    const int t162 = t159 && t161;
    work->t163 = work->flags[1] ? t152 : work->t7;
    const int t164 = work->flags[1] || t162;
    work->flags[2] = work->flags[0] && t164;
    const uint32_t t166 = work->flags[2] ? 1U : 0U;
    state->known = t166;
    const float t168 = 0.001f * work->t160;
    const float t170 = 5e-7f * work->t163;
    const float t171 = work->t157 + t168;
    const float t172 = t171 + t170;
    const int t173 = (-1e26f <= t172) && (t172 <= 1e26f);
    const float t174 = t173 ? t172 : 0.0f;
    state->next_q = t174;
    const float t175 = 0.001f * work->t163;
    const float t176 = work->t160 + t175;
    const int t177 = (-1e26f <= t176) && (t176 <= 1e26f);
    const float t178 = t177 ? t176 : 0.0f;
    state->next_dq = t178;
    const int t179 = (-1e26f <= work->t163) && (work->t163 <= 1e26f);
    const float t180 = t179 ? work->t163 : 0.0f;
    state->next_ddq = t180;
}

/* Part 4 of a step. */
static void lossy_encoder_part_4(const lossy_encoder_state *state, lossy_encoder_work *work)
{
    /* the estimate; until there is one, the start */
    work->t181 = work->flags[2] ? work->t157 : work->t10;
    work->t182 = work->flags[2] ? work->t160 : 0.0f;
    work->t183 = work->flags[2] ? work->t163 : 0.0f;
    const uint32_t t184 = state->coasting;
    const int t185 = t184 == 0U;
    const int t186 = work->flags[1] && t185;
    const lossy_encoder_status t190 = t186 ? LOSSY_ENCODER_CONVERGED : LOSSY_ENCODER_COASTING;
    work->t191 = work->flags[2] ? t190 : LOSSY_ENCODER_CONVERGING;
}

void lossy_encoder_init(lossy_encoder_state *state)
{
    for (uint32_t slot = 0U; slot < 131U; ++slot) {
        state->y[slot] = 0.0f;
    }
    state->newest = 130U;
    state->count = 0U;
    state->coasting = 0U;
    for (uint32_t slot = 0U; slot < 131U; ++slot) {
        state->has_y[slot] = 0.0f;
    }
    state->next_q = 0.0f;
    state->next_dq = 0.0f;
    state->next_ddq = 0.0f;
    state->known = 0U;
    state->since = 0U;
}

void lossy_encoder_step(lossy_encoder_state *state, const lossy_encoder_measurements *measurements,
                        lossy_encoder_estimate *estimate)
{
    lossy_encoder_work work;
    lossy_encoder_part_1(state, measurements, &work);
    lossy_encoder_part_2(state, &work);
    lossy_encoder_part_3(state, &work);
    lossy_encoder_part_4(state, &work);

    estimate->q = work.t181;
    estimate->dq = work.t182;
    estimate->ddq = work.t183;
    estimate->coasted = work.t14;
    estimate->status = work.t191;
}
