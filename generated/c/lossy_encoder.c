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
    uint32_t t14;
    float t49;
    float t50;
    float t51;
    float t52;
    float t53;
    float t54;
    float t55;
    float t56;
    float t57;
    float t58;
    float t59;
    float t60;
    float t140;
    float t146;
    float t149;
    float t181;
    float t182;
    float t183;
    lossy_encoder_status t191;
    int flags[2]; /* t20, t123 */
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
    const uint32_t t12 = state->since;
    const uint32_t t13 = (t12 < 4294967295U) ? (t12 + 1U) : 4294967295U;
    work->t14 = t3 ? 0U : t13;
    state->since = work->t14;

    /* how much of the window is good */
    const uint32_t t17 = (t10 < 131U) ? (t10 + 1U) : 131U;
    state->count = t17;
    const uint32_t t18 = state->coasting;
    const uint32_t t19 = (t18 > 0U) ? (t18 - 1U) : 0U;
    state->coasting = t19;

    /* into the window */
    state->newest = work->t4;
    state->y[work->t4] = work->t8;
    state->has_y[work->t4] = t9;
    work->flags[0] = 130U < t17;
}

/* Part 2 of a step. */
static void lossy_encoder_part_2(const lossy_encoder_state *state, lossy_encoder_work *work)
{
    /* rows of the window, oldest first; those without a sample count nothing */
    const uint32_t t21 = (work->t4 < 130U) ? (work->t4 + 1U) : 0U;
    const float t25 = state->has_y[t21];
    const float t26 = state->y[t21];
    const float t27 = t26 - 0.0f;
    const float t28 = t25 * 0.0873704f;
    const float t29 = t25 * -0.15017916f;
    const float t30 = t25 * 0.19094272f;
    const float t31 = t28 * t28;
    const float t32 = 0.0f + t31;
    const float t33 = t28 * t29;
    const float t34 = 0.0f + t33;
    const float t35 = t28 * t30;
    const float t36 = 0.0f + t35;
    const float t37 = t29 * t29;
    const float t38 = 0.0f + t37;
    const float t39 = t29 * t30;
    const float t40 = 0.0f + t39;
    const float t41 = t30 * t30;
    const float t42 = 0.0f + t41;
    const float t43 = t28 * t27;
    const float t44 = 0.0f + t43;
    const float t45 = t29 * t27;
    const float t46 = 0.0f + t45;
    const float t47 = t30 * t27;
    const float t48 = 0.0f + t47;
    work->t49 = t32;
    work->t50 = t34;
    work->t51 = t36;
    work->t52 = t38;
    work->t53 = t40;
    work->t54 = t42;
    work->t55 = t44;
    work->t56 = t46;
    work->t57 = t48;
    work->t58 = 0.0f;
    work->t59 = 0.0f;
    work->t60 = 0.0f;
    uint32_t t61 = t21;
    for (uint32_t row = 0U; row < 130U; ++row) {
        const float *const gains = LOSSY_ENCODER_ROWS[row];
        const uint32_t t62 = (t61 < 130U) ? (t61 + 1U) : 0U;
        const float t64 = 0.001f * work->t59;
        const float t66 = 5e-7f * work->t60;
        const float t67 = work->t58 + t64;
        const float t68 = t67 + t66;
        const float t69 = 0.001f * work->t60;
        const float t70 = work->t59 + t69;
        const float t71 = gains[0];
        const float t72 = gains[1];
        const float t73 = gains[2];
        const float t74 = state->has_y[t62];
        const float t75 = state->y[t62];
        const float t76 = t75 - t68;
        const float t77 = t74 * t71;
        const float t78 = t74 * t72;
        const float t79 = t74 * t73;
        const float t80 = t77 * t77;
        const float t81 = work->t49 + t80;
        const float t82 = t77 * t78;
        const float t83 = work->t50 + t82;
        const float t84 = t77 * t79;
        const float t85 = work->t51 + t84;
        const float t86 = t78 * t78;
        const float t87 = work->t52 + t86;
        const float t88 = t78 * t79;
        const float t89 = work->t53 + t88;
        const float t90 = t79 * t79;
        const float t91 = work->t54 + t90;
        const float t92 = t77 * t76;
        const float t93 = work->t55 + t92;
        const float t94 = t78 * t76;
        const float t95 = work->t56 + t94;
        const float t96 = t79 * t76;
        const float t97 = work->t57 + t96;
        const float t98 = work->t60 - 0.0f;
        work->t49 = t81;
        work->t50 = t83;
        work->t51 = t85;
        work->t52 = t87;
        work->t53 = t89;
        work->t54 = t91;
        work->t55 = t93;
        work->t56 = t95;
        work->t57 = t97;
        work->t58 = t68;
        work->t59 = t70;
        work->t60 = t98;
        t61 = t62;
    }
}

/* Part 3 of a step. */
static void lossy_encoder_part_3(lossy_encoder_work *work)
{
    /* the window's start from the samples that are there */
    const int t100 = 0.015625f < work->t49;
    const float t101 = t100 ? work->t49 : 1.0f;
    const float t102 = work->t50 / t101;
    const float t103 = t102 * work->t50;
    const float t104 = work->t52 - t103;
    const float t105 = t102 * work->t51;
    const float t106 = work->t53 - t105;
    const float t107 = t102 * work->t55;
    const float t108 = work->t56 - t107;
    const float t109 = work->t51 / t101;
    const float t110 = t109 * work->t51;
    const float t111 = work->t54 - t110;
    const float t112 = t109 * work->t55;
    const float t113 = work->t57 - t112;
    const int t114 = 0.015625f < t104;
    const int t115 = t100 && t114;
    const float t116 = t114 ? t104 : 1.0f;
    const float t117 = t106 / t116;
    const float t118 = t117 * t106;
    const float t119 = t111 - t118;
    const float t120 = t117 * t108;
    const float t121 = t113 - t120;
    const int t122 = 0.015625f < t119;
    work->flags[1] = t115 && t122;
    const float t124 = t122 ? t119 : 1.0f;
    const float t125 = t121 / t124;
    const float t126 = t106 * t125;
    const float t127 = t108 - t126;
    const float t128 = t127 / t116;
    const float t129 = work->t50 * t128;
    const float t130 = work->t55 - t129;
    const float t131 = work->t51 * t125;
    const float t132 = t130 - t131;
    const float t133 = t132 / t101;
    const float t134 = 0.0873704f * t133;
    const float t136 = 0.15017916f * t128;
    const float t137 = 0.19094272f * t125;
    const float t138 = t134 + t136;
    const float t139 = t138 + t137;
    work->t140 = t139 + work->t58;
    const float t142 = 2.3104486f * t128;
    const float t144 = 8.881057f * t125;
    const float t145 = t142 + t144;
    work->t146 = t145 + work->t59;
    const float t148 = 136.63164f * t125;
    work->t149 = t148 + work->t60;
}

/* Part 4 of a step. */
static void lossy_encoder_part_4(lossy_encoder_state *state, lossy_encoder_work *work)
{
    /* without enough samples, the model's prediction */
    const uint32_t t150 = state->known;
    const int t151 = t150 == 1U;
    const float t152 = state->next_q;
    const int t153 = (-1e26f <= t152) && (t152 <= 1e26f);
    const int t154 = t151 && t153;
    const float t155 = work->flags[1] ? work->t140 : t152;
    const float t156 = state->next_dq;
    const int t157 = (-1e26f <= t156) && (t156 <= 1e26f);
    const int t158 = t154 && t157;
    const float t159 = work->flags[1] ? work->t146 : t156;
    const float t160 = state->next_ddq;
    const int t161 = (-1e26f <= t160) && (t160 <= 1e26f);
    const int t162 = t158 && t161;
    const float t163 = work->flags[1] ? work->t149 : t160;
    const int t164 = work->flags[1] || t162;
    const int t165 = work->flags[0] && t164;
    const uint32_t t166 = t165 ? 1U : 0U;
    state->known = t166;
    const float t168 = 0.001f * t159;
    const float t170 = 5e-7f * t163;
    const float t171 = t155 + t168;
    const float t172 = t171 + t170;
    const int t173 = (-1e26f <= t172) && (t172 <= 1e26f);
    const float t174 = t173 ? t172 : 0.0f;
    state->next_q = t174;
    const float t175 = 0.001f * t163;
    const float t176 = t159 + t175;
    const int t177 = (-1e26f <= t176) && (t176 <= 1e26f);
    const float t178 = t177 ? t176 : 0.0f;
    state->next_dq = t178;
    const int t179 = (-1e26f <= t163) && (t163 <= 1e26f);
    const float t180 = t179 ? t163 : 0.0f;
    state->next_ddq = t180;

    /* the estimate; until there is one, the start */
    work->t181 = t165 ? t155 : work->t8;
    work->t182 = t165 ? t159 : 0.0f;
    work->t183 = t165 ? t163 : 0.0f;
    const uint32_t t184 = state->coasting;
    const int t185 = t184 == 0U;
    const int t186 = work->flags[1] && t185;
    const lossy_encoder_status t190 = t186 ? LOSSY_ENCODER_CONVERGED : LOSSY_ENCODER_COASTING;
    work->t191 = t165 ? t190 : LOSSY_ENCODER_CONVERGING;
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
    lossy_encoder_part_3(&work);
    lossy_encoder_part_4(state, &work);

    estimate->q = work.t181;
    estimate->dq = work.t182;
    estimate->ddq = work.t183;
    estimate->coasted = work.t14;
    estimate->status = work.t191;
}
