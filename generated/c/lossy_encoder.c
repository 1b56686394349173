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
#pragma GCC optimize("fp-contract=off")
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
    float t8;
    float t46;
    float t47;
    float t48;
    float t49;
    float t50;
    float t51;
    float t52;
    float t53;
    float t54;
    float t55;
    float t56;
    float t57;
    float t137;
    float t143;
    float t146;
    float t178;
    float t179;
    float t180;
    lossy_encoder_status t188;
    int flags[2]; /* t17, t120 */
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
    const float t7 = state->y[t1];
    work->t8 = t3 ? t2 : t7;
    const float t9 = t3 ? 1.0f : 0.0f;
    const uint32_t t10 = state->count;

    /* how much of the window is good */
    const uint32_t t14 = (t10 < 131U) ? (t10 + 1U) : 131U;
    state->count = t14;
    const uint32_t t15 = state->coasting;
    const uint32_t t16 = (t15 > 0U) ? (t15 - 1U) : 0U;
    state->coasting = t16;

    /* into the window */
    state->newest = work->t4;
    state->y[work->t4] = work->t8;
    state->has_y[work->t4] = t9;
    work->flags[0] = 130U < t14;
}

/* Part 2 of a step. */
static void lossy_encoder_part_2(const lossy_encoder_state *state, lossy_encoder_work *work)
{
    /* rows of the window, oldest first; those without a sample count nothing */
    const uint32_t t18 = (work->t4 < 130U) ? (work->t4 + 1U) : 0U;
    const float t22 = state->has_y[t18];
    const float t23 = state->y[t18];
    const float t24 = t23 - 0.0f;
    const float t25 = t22 * 0.0873704f;
    const float t26 = t22 * -0.15017916f;
    const float t27 = t22 * 0.19094272f;
    const float t28 = t25 * t25;
    const float t29 = 0.0f + t28;
    const float t30 = t25 * t26;
    const float t31 = 0.0f + t30;
    const float t32 = t25 * t27;
    const float t33 = 0.0f + t32;
    const float t34 = t26 * t26;
    const float t35 = 0.0f + t34;
    const float t36 = t26 * t27;
    const float t37 = 0.0f + t36;
    const float t38 = t27 * t27;
    const float t39 = 0.0f + t38;
    const float t40 = t25 * t24;
    const float t41 = 0.0f + t40;
    const float t42 = t26 * t24;
    const float t43 = 0.0f + t42;
    const float t44 = t27 * t24;
    const float t45 = 0.0f + t44;
    work->t46 = t29;
    work->t47 = t31;
    work->t48 = t33;
    work->t49 = t35;
    work->t50 = t37;
    work->t51 = t39;
    work->t52 = t41;
    work->t53 = t43;
    work->t54 = t45;
    work->t55 = 0.0f;
    work->t56 = 0.0f;
    work->t57 = 0.0f;
    uint32_t t58 = t18;
    for (uint32_t row = 0U; row < 130U; ++row) {
        const float *const gains = LOSSY_ENCODER_ROWS[row];
        const uint32_t t59 = (t58 < 130U) ? (t58 + 1U) : 0U;
        const float t61 = 0.001f * work->t56;
        const float t63 = 5e-7f * work->t57;
        const float t64 = work->t55 + t61;
        const float t65 = t64 + t63;
        const float t66 = 0.001f * work->t57;
        const float t67 = work->t56 + t66;
        const float t68 = gains[0];
        const float t69 = gains[1];
        const float t70 = gains[2];
        const float t71 = state->has_y[t59];
        const float t72 = state->y[t59];
        const float t73 = t72 - t65;
        const float t74 = t71 * t68;
        const float t75 = t71 * t69;
        const float t76 = t71 * t70;
        const float t77 = t74 * t74;
        const float t78 = work->t46 + t77;
        const float t79 = t74 * t75;
        const float t80 = work->t47 + t79;
        const float t81 = t74 * t76;
        const float t82 = work->t48 + t81;
        const float t83 = t75 * t75;
        const float t84 = work->t49 + t83;
        const float t85 = t75 * t76;
        const float t86 = work->t50 + t85;
        const float t87 = t76 * t76;
        const float t88 = work->t51 + t87;
        const float t89 = t74 * t73;
        const float t90 = work->t52 + t89;
        const float t91 = t75 * t73;
        const float t92 = work->t53 + t91;
        const float t93 = t76 * t73;
        const float t94 = work->t54 + t93;
        const float t95 = work->t57 - 0.0f;
        work->t46 = t78;
        work->t47 = t80;
        work->t48 = t82;
        work->t49 = t84;
        work->t50 = t86;
        work->t51 = t88;
        work->t52 = t90;
        work->t53 = t92;
        work->t54 = t94;
        work->t55 = t65;
        work->t56 = t67;
        work->t57 = t95;
        t58 = t59;
    }
}

/* Part 3 of a step. */
static void lossy_encoder_part_3(lossy_encoder_work *work)
{
    /* the window's start from the samples that are there */
    const int t97 = 0.015625f < work->t46;
    const float t98 = t97 ? work->t46 : 1.0f;
    const float t99 = work->t47 / t98;
    const float t100 = t99 * work->t47;
    const float t101 = work->t49 - t100;
    const float t102 = t99 * work->t48;
    const float t103 = work->t50 - t102;
    const float t104 = t99 * work->t52;
    const float t105 = work->t53 - t104;
    const float t106 = work->t48 / t98;
    const float t107 = t106 * work->t48;
    const float t108 = work->t51 - t107;
    const float t109 = t106 * work->t52;
    const float t110 = work->t54 - t109;
    const int t111 = 0.015625f < t101;
    const int t112 = t97 && t111;
    const float t113 = t111 ? t101 : 1.0f;
    const float t114 = t103 / t113;
    const float t115 = t114 * t103;
    const float t116 = t108 - t115;
    const float t117 = t114 * t105;
    const float t118 = t110 - t117;
    const int t119 = 0.015625f < t116;
    work->flags[1] = t112 && t119;
    const float t121 = t119 ? t116 : 1.0f;
    const float t122 = t118 / t121;
    const float t123 = t103 * t122;
    const float t124 = t105 - t123;
    const float t125 = t124 / t113;
    const float t126 = work->t47 * t125;
    const float t127 = work->t52 - t126;
    const float t128 = work->t48 * t122;
    const float t129 = t127 - t128;
    const float t130 = t129 / t98;
    const float t131 = 0.0873704f * t130;
    const float t133 = 0.15017916f * t125;
    const float t134 = 0.19094272f * t122;
    const float t135 = t131 + t133;
    const float t136 = t135 + t134;
    work->t137 = t136 + work->t55;
    const float t139 = 2.3104486f * t125;
    const float t141 = 8.881057f * t122;
    const float t142 = t139 + t141;
    work->t143 = t142 + work->t56;
    const float t145 = 136.63164f * t122;
    work->t146 = t145 + work->t57;
}

/* Part 4 of a step. */
static void lossy_encoder_part_4(lossy_encoder_state *state, lossy_encoder_work *work)
{
    /* without enough samples, the model's prediction */
    const uint32_t t147 = state->known;
    const int t148 = t147 == 1U;
    const float t149 = state->next_q;
    const int t150 = (-1e26f <= t149) && (t149 <= 1e26f);
    const int t151 = t148 && t150;
    const float t152 = work->flags[1] ? work->t137 : t149;
    const float t153 = state->next_dq;
    const int t154 = (-1e26f <= t153) && (t153 <= 1e26f);
    const int t155 = t151 && t154;
    const float t156 = work->flags[1] ? work->t143 : t153;
    const float t157 = state->next_ddq;
    const int t158 = (-1e26f <= t157) && (t157 <= 1e26f);
    const int t159 = t155 && t158;
    const float t160 = work->flags[1] ? work->t146 : t157;
    const int t161 = work->flags[1] || t159;
    const int t162 = work->flags[0] && t161;
    const uint32_t t163 = t162 ? 1U : 0U;
    state->known = t163;
    const float t165 = 0.001f * t156;
    const float t167 = 5e-7f * t160;
    const float t168 = t152 + t165;
    const float t169 = t168 + t167;
    const int t170 = (-1e26f <= t169) && (t169 <= 1e26f);
    const float t171 = t170 ? t169 : 0.0f;
    state->next_q = t171;
    const float t172 = 0.001f * t160;
    const float t173 = t156 + t172;
    const int t174 = (-1e26f <= t173) && (t173 <= 1e26f);
    const float t175 = t174 ? t173 : 0.0f;
    state->next_dq = t175;
    const int t176 = (-1e26f <= t160) && (t160 <= 1e26f);
    const float t177 = t176 ? t160 : 0.0f;
    state->next_ddq = t177;

    /* the estimate; until there is one, the start */
    work->t178 = t162 ? t152 : work->t8;
    work->t179 = t162 ? t156 : 0.0f;
    work->t180 = t162 ? t160 : 0.0f;
    const uint32_t t181 = state->coasting;
    const int t182 = t181 == 0U;
    const int t183 = work->flags[1] && t182;
    const lossy_encoder_status t187 = t183 ? LOSSY_ENCODER_CONVERGED : LOSSY_ENCODER_COASTING;
    work->t188 = t162 ? t187 : LOSSY_ENCODER_CONVERGING;
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
}

void lossy_encoder_step(lossy_encoder_state *state, const lossy_encoder_measurements *measurements,
                        lossy_encoder_estimate *estimate)
{
    lossy_encoder_work work;
    lossy_encoder_part_1(state, measurements, &work);
    lossy_encoder_part_2(state, &work);
    lossy_encoder_part_3(&work);
    lossy_encoder_part_4(state, &work);

    estimate->q = work.t178;
    estimate->dq = work.t179;
    estimate->ddq = work.t180;
    estimate->status = work.t188;
}
