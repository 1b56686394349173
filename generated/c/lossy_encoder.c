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
    uint32_t t24;
    float t29;
    float t36;
    float t38;
    float t40;
    float t42;
    float t44;
    float t46;
    float t48;
    float t50;
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
    float t64;
    float t65;
    float t170;
    float t175;
    float t178;
    float t180;
    float t182;
    float t184;
    float t252;
    float t253;
    float t254;
    lossy_encoder_status t262;
    int flags[2]; /* t23, t163 */
} lossy_encoder_work;

/* Part 1 of a step. */
static void lossy_encoder_part_1(lossy_encoder_state *state, const lossy_encoder_measurements *measurements, lossy_encoder_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    const uint32_t t0 = state->newest;
    const uint32_t t1 = (t0 < 130U) ? t0 : 130U;
    const float t2 = measurements->y;
    const int t3 = (-1e29f <= t2) && (t2 <= 1e29f);
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
    work->t24 = (work->t4 < 130U) ? (work->t4 + 1U) : 0U;
    const float t28 = state->has_y[work->t24];
    work->t29 = 0.0f + t28;
    const float t30 = state->y[work->t24];
    const float t31 = t30 - 0.0f;
    const float t32 = t28 * 0.0873704f;
    const float t33 = t28 * -0.15017916f;
    const float t34 = t28 * 0.19094272f;
    const float t35 = t32 * t32;
    work->t36 = 0.0f + t35;
    const float t37 = t32 * t33;
    work->t38 = 0.0f + t37;
    const float t39 = t32 * t34;
    work->t40 = 0.0f + t39;
    const float t41 = t33 * t33;
    work->t42 = 0.0f + t41;
    const float t43 = t33 * t34;
    work->t44 = 0.0f + t43;
    const float t45 = t34 * t34;
    work->t46 = 0.0f + t45;
    const float t47 = t32 * t31;
    work->t48 = 0.0f + t47;
    const float t49 = t33 * t31;
    work->t50 = 0.0f + t49;
    const float t51 = t34 * t31;
    work->t52 = 0.0f + t51;
}

/* Part 3 of a step. */
static void lossy_encoder_part_3(const lossy_encoder_state *state, lossy_encoder_work *work)
{
    work->t53 = work->t36;
    work->t54 = work->t38;
    work->t55 = work->t40;
    work->t56 = work->t42;
    work->t57 = work->t44;
    work->t58 = work->t46;
    work->t59 = work->t48;
    work->t60 = work->t50;
    work->t61 = work->t52;
    work->t62 = 0.0f;
    work->t63 = 0.0f;
    work->t64 = 0.0f;
    work->t65 = work->t29;
    uint32_t t66 = work->t24;
    for (uint32_t row = 0U; row < 130U; ++row) {
        const float *const gains = LOSSY_ENCODER_ROWS[row];
        const uint32_t t67 = (t66 < 130U) ? (t66 + 1U) : 0U;
        const float t69 = 0.001f * work->t63;
        const float t71 = 5e-7f * work->t64;
        const float t72 = work->t62 + t69;
        const float t73 = t72 + t71;
        const float t74 = 0.001f * work->t64;
        const float t75 = work->t63 + t74;
        const float t76 = gains[0];
        const float t77 = gains[1];
        const float t78 = gains[2];
        const float t79 = state->has_y[t67];
        const float t80 = work->t65 + t79;
        const float t81 = state->y[t67];
        const float t82 = t81 - t73;
        const float t83 = t79 * t76;
        const float t84 = t79 * t77;
        const float t85 = t79 * t78;
        const float t86 = t83 * t83;
        const float t87 = work->t53 + t86;
        const float t88 = t83 * t84;
        const float t89 = work->t54 + t88;
        const float t90 = t83 * t85;
        const float t91 = work->t55 + t90;
        const float t92 = t84 * t84;
        const float t93 = work->t56 + t92;
        const float t94 = t84 * t85;
        const float t95 = work->t57 + t94;
        const float t96 = t85 * t85;
        const float t97 = work->t58 + t96;
        const float t98 = t83 * t82;
        const float t99 = work->t59 + t98;
        const float t100 = t84 * t82;
        const float t101 = work->t60 + t100;
        const float t102 = t85 * t82;
        const float t103 = work->t61 + t102;
        const float t104 = work->t64 - 0.0f;
        work->t53 = t87;
        work->t54 = t89;
        work->t55 = t91;
        work->t56 = t93;
        work->t57 = t95;
        work->t58 = t97;
        work->t59 = t99;
        work->t60 = t101;
        work->t61 = t103;
        work->t62 = t73;
        work->t63 = t75;
        work->t64 = t104;
        work->t65 = t80;
        t66 = t67;
    }
}

/* Part 4 of a step. */
static void lossy_encoder_part_4(lossy_encoder_work *work)
{
    /* the state from the samples that are there, and its variance */
    const float t113 = 0.0001f * work->t53;
    const float t114 = t113 + 9.8607613e-32f;
    const float t115 = 0.0001f * work->t56;
    const float t116 = t115 + 9.8607613e-32f;
    const float t117 = 0.0001f * work->t58;
    const float t118 = t117 + 9.8607613e-32f;
    const int t119 = t114 < work->t53;
    const float t120 = t119 ? work->t53 : 1.0f;
    const float t121 = work->t54 / t120;
    const float t122 = work->t55 / t120;
    const float t123 = t121 * work->t54;
    const float t124 = work->t56 - t123;
    const float t125 = t121 * work->t55;
    const float t126 = work->t57 - t125;
    const float t127 = t121 * work->t59;
    const float t128 = work->t60 - t127;
    const float t129 = t122 * work->t55;
    const float t130 = work->t58 - t129;
    const float t131 = t122 * work->t59;
    const float t132 = work->t61 - t131;
    const float t133 = work->t59 / t120;
    const float t134 = t121 * 0.0109213f;
    const float t135 = 0.018772395f - t134;
    const float t136 = t122 * 0.0109213f;
    const float t137 = 0.02386784f - t136;
    const float t138 = 0.0109213f * t133;
    const float t139 = 0.0109213f / t120;
    const float t140 = 0.0109213f * t139;
    const int t141 = t116 < t124;
    const int t142 = t119 && t141;
    const float t143 = t141 ? t124 : 1.0f;
    const float t144 = t126 / t143;
    const float t145 = t144 * t126;
    const float t146 = t130 - t145;
    const float t147 = t144 * t128;
    const float t148 = t132 - t147;
    const float t149 = t128 / t143;
    const float t150 = t144 * t135;
    const float t151 = t137 - t150;
    const float t152 = t135 * t149;
    const float t153 = t138 + t152;
    const float t154 = t135 / t143;
    const float t155 = t135 * t154;
    const float t156 = t140 + t155;
    const float t157 = t144 * 0.004512595f;
    const float t158 = 0.017345814f - t157;
    const float t159 = 0.004512595f * t149;
    const float t160 = 0.004512595f / t143;
    const float t161 = 0.004512595f * t160;
    const int t162 = t118 < t146;
    work->flags[1] = t142 && t162;
    const float t164 = t162 ? t146 : 1.0f;
    const float t165 = t148 / t164;
    const float t166 = t151 * t165;
    const float t167 = t153 + t166;
    const float t168 = t151 / t164;
    const float t169 = t151 * t168;
    work->t170 = t156 + t169;
    const float t171 = t158 * t165;
    const float t172 = t159 + t171;
    const float t173 = t158 / t164;
    const float t174 = t158 * t173;
    work->t175 = t161 + t174;
    const float t176 = 0.016678667f * t165;
    const float t177 = 0.016678667f / t164;
    work->t178 = 0.016678667f * t177;
    work->t180 = 8.0f * t167;
    work->t182 = 512.0f * t172;
    work->t184 = 8192.0f * t176;
}

/* Part 5 of a step. */
static void lossy_encoder_part_5(lossy_encoder_state *state, lossy_encoder_work *work)
{
    /* what it is worth */
    const float t186 = work->t170 * 0.25297415f;
    const int t187 = 0.0f < t186;
    const float t188 = t187 ? t186 : 0.0f;
    const float t190 = work->t175 * 0.7477661f;
    const int t191 = t188 < t190;
    const float t192 = t191 ? t190 : t188;
    const float t194 = work->t178 * 0.85701275f;
    const int t195 = t192 < t194;
    const float t196 = t195 ? t194 : t192;
    const int t201 = t196 <= 16859.84f;
    const int t202 = work->flags[1] && t201;
    const int t203 = t196 <= 0.016859839f;
    const int t204 = t202 && t203;
    const float t205 = 2.9686043f * work->t65;
    const float t206 = t205 + 765.5649f;
    const float t207 = t196 * t206;
    const int t208 = t207 <= 1.0f;
    const int t209 = t204 && t208;
    const int t210 = 0.0f < work->t65;
    const float t211 = work->t180 + work->t62;
    const float t212 = work->t182 + work->t63;
    const float t213 = work->t184 + work->t64;

    /* without enough samples, the model's prediction */
    const uint32_t t214 = state->known;
    const int t215 = t214 == 1U;
    const int t216 = (-1e29f <= work->t5) && (work->t5 <= 1e29f);
    const int t217 = t215 && t216;
    const int t218 = (-1e29f <= work->t6) && (work->t6 <= 1e29f);
    const int t219 = t217 && t218;
    const int t220 = (-1e29f <= work->t7) && (work->t7 <= 1e29f);
    const int t221 = t219 && t220;
    const uint32_t t222 = state->poor;
    const uint32_t t223 = (t222 < 393U) ? (t222 + 1U) : 393U;
    const uint32_t t224 = t210 ? t223 : t222;
    const uint32_t t225 = t204 ? 0U : t224;
    state->poor = t225;
    const int t227 = t225 < 393U;
    const int t228 = t227 && t221;
    const int t229 = !t228;
    const int t230 = t204 || t229;
    const int t231 = t202 && t230;
    const float t232 = t231 ? t211 : work->t5;
    const float t233 = t231 ? t212 : work->t6;
    const float t234 = t231 ? t213 : work->t7;
    const int t235 = t231 || t221;
    const int t236 = work->flags[0] && t235;
    const uint32_t t237 = t236 ? 1U : 0U;
    state->known = t237;
    const float t239 = 0.001f * t233;
    const float t241 = 5e-7f * t234;
    const float t242 = t232 + t239;
    const float t243 = t242 + t241;
    const int t244 = (-1e29f <= t243) && (t243 <= 1e29f);
    const float t245 = t244 ? t243 : 0.0f;
    state->next_q = t245;
    const float t246 = 0.001f * t234;
    const float t247 = t233 + t246;
    const int t248 = (-1e29f <= t247) && (t247 <= 1e29f);
    const float t249 = t248 ? t247 : 0.0f;
    state->next_dq = t249;
    const int t250 = (-1e29f <= t234) && (t234 <= 1e29f);
    const float t251 = t250 ? t234 : 0.0f;
    state->next_ddq = t251;

    /* the estimate; until there is one, the start */
    work->t252 = t236 ? t232 : work->t10;
    work->t253 = t236 ? t233 : 0.0f;
    work->t254 = t236 ? t234 : 0.0f;
    const uint32_t t255 = state->coasting;
    const int t256 = t255 == 0U;
    const int t257 = t209 && t256;
    const lossy_encoder_status t261 = t257 ? LOSSY_ENCODER_CONVERGED : LOSSY_ENCODER_COASTING;
    work->t262 = t236 ? t261 : LOSSY_ENCODER_CONVERGING;
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
    state->poor = 393U;
    state->since = 0U;
}

void lossy_encoder_step(lossy_encoder_state *state, const lossy_encoder_measurements *measurements,
                        lossy_encoder_estimate *estimate)
{
    lossy_encoder_work work;
    lossy_encoder_part_1(state, measurements, &work);
    lossy_encoder_part_2(state, &work);
    lossy_encoder_part_3(state, &work);
    lossy_encoder_part_4(&work);
    lossy_encoder_part_5(state, &work);

    estimate->q = work.t252;
    estimate->dq = work.t253;
    estimate->ddq = work.t254;
    estimate->coasted = work.t14;
    estimate->status = work.t262;
}
