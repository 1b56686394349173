/* two_rates.c: Finite-time observer: Cart with a camera at 20 Hz and a wheel counter at 100 Hz.
 *
 * Generated; two_rates.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "two_rates.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "two_rates.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "two_rates.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* orthonormal rows of the window, oldest first
 *   [0] camera in direction 1
 *   [1] camera in direction 2
 *   [2] camera in direction 3
 *   [3] wheel in direction 1
 *   [4] wheel in direction 2
 *   [5] wheel in direction 3
 */
static const float TWO_RATES_ROWS[40][6] = {
    { 0.16012815f, -0.10769813f, 0.049310327f, 0.0f, 0.16493043f, -0.24281687f },
    { 0.16012815f, -0.10112723f, 0.03989656f, 0.0f, 0.16361625f, -0.2278914f },
    { 0.16012815f, -0.09460869f, 0.03107743f, 0.0f, 0.16231254f, -0.21308486f },
    { 0.16012815f, -0.08814209f, 0.022848198f, 0.0f, 0.16101922f, -0.1983963f },
    { 0.16012815f, -0.08172701f, 0.015204166f, 0.0f, 0.1597362f, -0.18382478f },
    { 0.16012815f, -0.075363055f, 0.008140668f, 0.0f, 0.15846342f, -0.16936937f },
    { 0.16012815f, -0.069049805f, 0.0016530812f, 0.0f, 0.15720077f, -0.15502913f },
    { 0.16012815f, -0.06278686f, -0.0042631854f, 0.0f, 0.15594818f, -0.14080316f },
    { 0.16012815f, -0.05657382f, -0.009612683f, 0.0f, 0.15470557f, -0.12669055f },
    { 0.16012815f, -0.050410286f, -0.014399929f, 0.0f, 0.15347286f, -0.11269039f },
    { 0.16012815f, -0.04429586f, -0.018629402f, 0.0f, 0.15224998f, -0.09880178f },
    { 0.16012815f, -0.038230155f, -0.022305546f, 0.0f, 0.15103683f, -0.085023835f },
    { 0.16012815f, -0.032212783f, -0.025432773f, 0.0f, 0.14983337f, -0.07135568f },
    { 0.16012815f, -0.026243359f, -0.028015453f, 0.0f, 0.14863947f, -0.057796426f },
    { 0.16012815f, -0.0203215f, -0.030057928f, 0.0f, 0.1474551f, -0.04434522f },
    { 0.16012815f, -0.014446826f, -0.0315645f, 0.0f, 0.14628017f, -0.03100119f },
    { 0.16012815f, -0.008618961f, -0.03253944f, 0.0f, 0.1451146f, -0.017763488f },
    { 0.16012815f, -0.002837534f, -0.032986984f, 0.0f, 0.14395832f, -0.0046312646f },
    { 0.16012815f, 0.0028978263f, -0.032911338f, 0.0f, 0.14281124f, 0.00839632f },
    { 0.16012815f, 0.008587487f, -0.032316662f, 0.0f, 0.14167331f, 0.021320099f },
    { 0.16012815f, 0.014231811f, -0.031207101f, 0.0f, 0.14054444f, 0.0341409f },
    { 0.16012815f, 0.019831162f, -0.029586753f, 0.0f, 0.13942458f, 0.046859544f },
    { 0.16012815f, 0.025385896f, -0.027459688f, 0.0f, 0.13831362f, 0.059476845f },
    { 0.16012815f, 0.03089637f, -0.024829946f, 0.0f, 0.13721153f, 0.07199361f },
    { 0.16012815f, 0.036362935f, -0.02170153f, 0.0f, 0.13611822f, 0.084410645f },
    { 0.16012815f, 0.041785944f, -0.018078415f, 0.0f, 0.13503361f, 0.096728735f },
    { 0.16012815f, 0.04716574f, -0.013964539f, 0.0f, 0.13395765f, 0.10894867f },
    { 0.16012815f, 0.05250267f, -0.009363818f, 0.0f, 0.13289027f, 0.12107124f },
    { 0.16012815f, 0.057797074f, -0.0042801285f, 0.0f, 0.1318314f, 0.13309722f },
    { 0.16012815f, 0.063049294f, 0.0012826815f, 0.0f, 0.13078095f, 0.14502737f },
    { 0.16012815f, 0.068259664f, 0.007320794f, 0.0f, 0.12973887f, 0.15686247f },
    { 0.16012815f, 0.07342851f, 0.013830421f, 0.0f, 0.1287051f, 0.16860326f },
    { 0.16012815f, 0.07855618f, 0.020807806f, 0.0f, 0.12767957f, 0.18025048f },
    { 0.16012815f, 0.08364299f, 0.028249223f, 0.0f, 0.12666221f, 0.19180492f },
    { 0.16012815f, 0.08868927f, 0.036150973f, 0.0f, 0.12565295f, 0.20326728f },
    { 0.16012815f, 0.09369533f, 0.04450939f, 0.0f, 0.12465174f, 0.21463831f },
    { 0.16012815f, 0.09866151f, 0.05332083f, 0.0f, 0.1236585f, 0.22591874f },
    { 0.16012815f, 0.10358812f, 0.06258169f, 0.0f, 0.122673176f, 0.23710927f },
    { 0.0f, 0.0f, 0.0f, 0.0f, 0.12169571f, 0.24821065f },
    { 0.0f, 0.0f, 0.0f, 0.0f, 0.12072603f, 0.25922358f }
};

/* What one part of a step hands to the next. */
typedef struct {
    uint32_t t10;
    float t14;
    float t18;
    float t19;
    float t27;
    uint32_t t32;
    uint32_t t47;
    float t88;
    float t90;
    float t92;
    float t94;
    float t96;
    float t98;
    float t100;
    float t102;
    float t104;
    float t105;
    float t106;
    float t107;
    float t108;
    float t109;
    float t110;
    float t111;
    float t112;
    float t113;
    float t114;
    float t115;
    float t116;
    uint32_t t117;
    uint32_t t118;
    float t127;
    float t133;
    float t173;
    float t175;
    float t177;
    float t179;
    float t181;
    float t183;
    float t185;
    float t187;
    float t189;
    float t190;
    float t248;
    float t251;
    float t254;
    float t274;
    float t275;
    float t276;
    two_rates_status t284;
    int flags[3]; /* t46, t215, t256 */
} two_rates_work;

/* Part 1 of a step. */
static void two_rates_part_1(two_rates_state *state, const two_rates_measurements *measurements, const two_rates_inputs *inputs, two_rates_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    const uint32_t t0 = state->newest;
    const uint32_t t1 = (t0 < 40U) ? t0 : 40U;
    const float t2 = measurements->camera;
    const int t3 = (-1e25f <= t2) && (t2 <= 1e25f);
    const float t4 = measurements->wheel;
    const int t5 = (-1e25f <= t4) && (t4 <= 1e25f);
    const float t6 = inputs->force;
    const int t7 = (-1e25f <= t6) && (t6 <= 1e25f);
    const float t8 = state->force[t1];
    const float t9 = t7 ? t6 : t8;
    work->t10 = (t1 < 40U) ? (t1 + 1U) : 0U;
    const float t11 = state->next_position;
    const float t13 = 1.9946774e-5f * t9;
    work->t14 = t11 + t13;
    const float t15 = state->next_speed;
    const float t17 = 0.0039840424f * t9;
    work->t18 = t15 + t17;
    work->t19 = state->next_slope;
    const uint32_t t21 = state->slot_camera;
    const uint32_t t22 = (t21 < 40U) ? t21 : 40U;
    const uint32_t t23 = (t22 < 40U) ? (t22 + 1U) : 0U;
    state->slot_camera = t23;
    const float t24 = state->camera[t22];
    const float t25 = t3 ? t2 : t24;
    const float t26 = state->wheel[t1];
    work->t27 = t5 ? t4 : t26;
    const int t28 = t3 || t5;
    const uint32_t t30 = state->since;
    const uint32_t t31 = (t30 < 4294967295U) ? (t30 + 1U) : 4294967295U;
    work->t32 = t28 ? 0U : t31;
    state->since = work->t32;
    const float t35 = t3 ? 1.0f : 0.0f;
    const float t36 = t5 ? 1.0f : 0.0f;
    const uint32_t t37 = state->count;

    /* how much of the window is good */
    const int t38 = 40U < t37;
    const uint32_t t40 = (t37 < 42U) ? (t37 + 1U) : 42U;
    const uint32_t t41 = t7 ? t40 : 1U;
    const uint32_t t42 = t38 ? t40 : t41;
    state->count = t42;
    const uint32_t t43 = state->coasting;
    const uint32_t t44 = (t43 > 0U) ? (t43 - 1U) : 0U;
    const uint32_t t45 = t7 ? t44 : 40U;
    state->coasting = t45;

    /* into the window */
    state->newest = work->t10;
    state->camera[t23] = t25;
    state->wheel[work->t10] = work->t27;
    state->has_camera[work->t10] = 0.0f;
    state->has_camera[t23] = t35;
    state->has_wheel[work->t10] = t36;
    state->force[work->t10] = t9;
    work->flags[0] = 40U < t42;
}

/* Part 2 of a step. */
static void two_rates_part_2(const two_rates_state *state, two_rates_work *work)
{
    /* rows of the window, oldest first; those without a sample count nothing */
    work->t47 = (work->t10 < 40U) ? (work->t10 + 1U) : 0U;
    const float t53 = state->has_camera[work->t47];
    const float t54 = state->camera[work->t47];
    const float t55 = t54 - 0.0f;
    const float t57 = 200.0f * t55;
    const float t58 = t53 * 0.16012815f;
    const float t59 = t53 * -0.114321806f;
    const float t60 = t53 * 0.05932351f;
    const float t61 = t58 * t58;
    const float t62 = 0.0f + t61;
    const float t63 = t58 * t59;
    const float t64 = 0.0f + t63;
    const float t65 = t58 * t60;
    const float t66 = 0.0f + t65;
    const float t67 = t59 * t59;
    const float t68 = 0.0f + t67;
    const float t69 = t59 * t60;
    const float t70 = 0.0f + t69;
    const float t71 = t60 * t60;
    const float t72 = 0.0f + t71;
    const float t73 = t58 * t57;
    const float t74 = 0.0f + t73;
    const float t75 = t59 * t57;
    const float t76 = 0.0f + t75;
    const float t77 = t60 * t57;
    const float t78 = 0.0f + t77;
    const float t79 = state->has_wheel[work->t47];
    const float t80 = state->wheel[work->t47];
    const float t81 = t80 - 0.0f;
    const float t83 = 50.0f * t81;
    const float t84 = t79 * 0.0f;
    const float t85 = t79 * 0.16625516f;
    const float t86 = t79 * -0.2578622f;
    const float t87 = t84 * t84;
    work->t88 = t62 + t87;
    const float t89 = t84 * t85;
    work->t90 = t64 + t89;
    const float t91 = t84 * t86;
    work->t92 = t66 + t91;
    const float t93 = t85 * t85;
    work->t94 = t68 + t93;
    const float t95 = t85 * t86;
    work->t96 = t70 + t95;
    const float t97 = t86 * t86;
    work->t98 = t72 + t97;
    const float t99 = t84 * t83;
    work->t100 = t74 + t99;
    const float t101 = t85 * t83;
    work->t102 = t76 + t101;
    const float t103 = t86 * t83;
    work->t104 = t78 + t103;
}

/* Part 3 of a step, for one row of TWO_RATES_ROWS. */
static void two_rates_part_3(const two_rates_state *state, two_rates_work *work, const float *gains)
{
    work->t118 = (work->t117 < 40U) ? (work->t117 + 1U) : 0U;
    const float t119 = state->force[work->t118];
    const float t121 = 0.009960107f * work->t115;
    const float t123 = 4.9866932e-5f * work->t116;
    const float t124 = work->t114 + t121;
    const float t125 = t124 + t123;
    const float t126 = 1.9946774e-5f * t119;
    work->t127 = t125 + t126;
    const float t129 = 0.99203193f * work->t115;
    const float t130 = 0.009960107f * work->t116;
    const float t131 = t129 + t130;
    const float t132 = 0.0039840424f * t119;
    work->t133 = t131 + t132;
    const float t134 = gains[0];
    const float t135 = gains[1];
    const float t136 = gains[2];
    const float t137 = gains[3];
    const float t138 = gains[4];
    const float t139 = gains[5];
    const float t140 = state->has_camera[work->t118];
    const float t141 = state->camera[work->t118];
    const float t142 = t141 - work->t127;
    const float t143 = 200.0f * t142;
    const float t144 = t140 * t134;
    const float t145 = t140 * t135;
    const float t146 = t140 * t136;
    const float t147 = t144 * t144;
    const float t148 = work->t105 + t147;
    const float t149 = t144 * t145;
    const float t150 = work->t106 + t149;
    const float t151 = t144 * t146;
    const float t152 = work->t107 + t151;
    const float t153 = t145 * t145;
    const float t154 = work->t108 + t153;
    const float t155 = t145 * t146;
    const float t156 = work->t109 + t155;
    const float t157 = t146 * t146;
    const float t158 = work->t110 + t157;
    const float t159 = t144 * t143;
    const float t160 = work->t111 + t159;
    const float t161 = t145 * t143;
    const float t162 = work->t112 + t161;
    const float t163 = t146 * t143;
    const float t164 = work->t113 + t163;
    const float t165 = state->has_wheel[work->t118];
    const float t166 = state->wheel[work->t118];
    const float t167 = t166 - work->t133;
    const float t168 = 50.0f * t167;
    const float t169 = t165 * t137;
    const float t170 = t165 * t138;
    const float t171 = t165 * t139;
    const float t172 = t169 * t169;
    work->t173 = t148 + t172;
    const float t174 = t169 * t170;
    work->t175 = t150 + t174;
    const float t176 = t169 * t171;
    work->t177 = t152 + t176;
    const float t178 = t170 * t170;
    work->t179 = t154 + t178;
    const float t180 = t170 * t171;
    work->t181 = t156 + t180;
    const float t182 = t171 * t171;
    work->t183 = t158 + t182;
    const float t184 = t169 * t168;
    work->t185 = t160 + t184;
    const float t186 = t170 * t168;
    work->t187 = t162 + t186;
    const float t188 = t171 * t168;
    work->t189 = t164 + t188;
    work->t190 = work->t116 - 0.0f;
}

/* Part 4 of a step. */
static void two_rates_part_4(const two_rates_state *state, two_rates_work *work)
{
    work->t105 = work->t88;
    work->t106 = work->t90;
    work->t107 = work->t92;
    work->t108 = work->t94;
    work->t109 = work->t96;
    work->t110 = work->t98;
    work->t111 = work->t100;
    work->t112 = work->t102;
    work->t113 = work->t104;
    work->t114 = 0.0f;
    work->t115 = 0.0f;
    work->t116 = 0.0f;
    work->t117 = work->t47;
    for (uint32_t row = 0U; row < 40U; ++row) {
        const float *const gains = TWO_RATES_ROWS[row];
        two_rates_part_3(state, work, gains);
        work->t105 = work->t173;
        work->t106 = work->t175;
        work->t107 = work->t177;
        work->t108 = work->t179;
        work->t109 = work->t181;
        work->t110 = work->t183;
        work->t111 = work->t185;
        work->t112 = work->t187;
        work->t113 = work->t189;
        work->t114 = work->t127;
        work->t115 = work->t133;
        work->t116 = work->t190;
        work->t117 = work->t118;
    }
}

/* Part 5 of a step. */
static void two_rates_part_5(two_rates_state *state, two_rates_work *work)
{
    /* the window's start from the samples that are there */
    const int t192 = 0.0028044872f < work->t105;
    const float t193 = t192 ? work->t105 : 1.0f;
    const float t194 = work->t106 / t193;
    const float t195 = t194 * work->t106;
    const float t196 = work->t108 - t195;
    const float t197 = t194 * work->t107;
    const float t198 = work->t109 - t197;
    const float t199 = t194 * work->t111;
    const float t200 = work->t112 - t199;
    const float t201 = work->t107 / t193;
    const float t202 = t201 * work->t107;
    const float t203 = work->t110 - t202;
    const float t204 = t201 * work->t111;
    const float t205 = work->t113 - t204;
    const int t206 = 0.0028044872f < t196;
    const int t207 = t192 && t206;
    const float t208 = t206 ? t196 : 1.0f;
    const float t209 = t198 / t208;
    const float t210 = t209 * t198;
    const float t211 = t203 - t210;
    const float t212 = t209 * t200;
    const float t213 = t205 - t212;
    const int t214 = 0.0028044872f < t211;
    work->flags[1] = t207 && t214;
    const float t216 = t214 ? t211 : 1.0f;
    const float t217 = t213 / t216;
    const float t218 = t198 * t217;
    const float t219 = t200 - t218;
    const float t220 = t219 / t208;
    const float t221 = work->t106 * t220;
    const float t222 = work->t111 - t221;
    const float t223 = work->t107 * t217;
    const float t224 = t222 - t223;
    const float t225 = t224 / t193;
    const float t227 = 0.0008006408f * t225;
    const float t229 = 0.0005666194f * t220;
    const float t231 = 0.0004121868f * t217;
    const float t232 = t227 + t229;
    const float t233 = t232 + t231;
    const float t234 = t233 + work->t114;
    const float t236 = 0.0024145206f * t220;
    const float t238 = 0.0051844716f * t217;
    const float t239 = t236 + t238;
    const float t240 = t239 + work->t115;
    const float t242 = 0.026085427f * t217;
    const float t243 = t242 + work->t116;

    /* without enough samples, the model's prediction */
    const uint32_t t244 = state->known;
    const int t245 = t244 == 1U;
    const int t246 = (-1e25f <= work->t14) && (work->t14 <= 1e25f);
    const int t247 = t245 && t246;
    work->t248 = work->flags[1] ? t234 : work->t14;
    const int t249 = (-1e25f <= work->t18) && (work->t18 <= 1e25f);
    const int t250 = t247 && t249;
    work->t251 = work->flags[1] ? t240 : work->t18;
    const int t252 = (-1e25f <= work->t19) && (work->t19 <= 1e25f);
    const int t253 = t250 && t252;
    work->t254 = work->flags[1] ? t243 : work->t19;
    const int t255 = work->flags[1] || t253;
    work->flags[2] = work->flags[0] && t255;
    const uint32_t t257 = work->flags[2] ? 1U : 0U;
    state->known = t257;
    const float t259 = 0.009960107f * work->t251;
    const float t261 = 4.9866932e-5f * work->t254;
    const float t262 = work->t248 + t259;
    const float t263 = t262 + t261;
    const int t264 = (-1e25f <= t263) && (t263 <= 1e25f);
    const float t265 = t264 ? t263 : 0.0f;
    state->next_position = t265;
    const float t267 = 0.99203193f * work->t251;
    const float t268 = 0.009960107f * work->t254;
    const float t269 = t267 + t268;
    const int t270 = (-1e25f <= t269) && (t269 <= 1e25f);
    const float t271 = t270 ? t269 : 0.0f;
    state->next_speed = t271;
    const int t272 = (-1e25f <= work->t254) && (work->t254 <= 1e25f);
    const float t273 = t272 ? work->t254 : 0.0f;
    state->next_slope = t273;
}

/* Part 6 of a step. */
static void two_rates_part_6(const two_rates_state *state, two_rates_work *work)
{
    /* the estimate; until there is one, the start */
    work->t274 = work->flags[2] ? work->t248 : 0.0f;
    work->t275 = work->flags[2] ? work->t251 : work->t27;
    work->t276 = work->flags[2] ? work->t254 : 0.0f;
    const uint32_t t277 = state->coasting;
    const int t278 = t277 == 0U;
    const int t279 = work->flags[1] && t278;
    const two_rates_status t283 = t279 ? TWO_RATES_CONVERGED : TWO_RATES_COASTING;
    work->t284 = work->flags[2] ? t283 : TWO_RATES_CONVERGING;
}

void two_rates_init(two_rates_state *state)
{
    for (uint32_t slot = 0U; slot < 41U; ++slot) {
        state->camera[slot] = 0.0f;
    }
    for (uint32_t slot = 0U; slot < 41U; ++slot) {
        state->wheel[slot] = 0.0f;
    }
    for (uint32_t slot = 0U; slot < 41U; ++slot) {
        state->force[slot] = 0.0f;
    }
    state->newest = 40U;
    state->count = 0U;
    state->coasting = 0U;
    for (uint32_t slot = 0U; slot < 41U; ++slot) {
        state->has_camera[slot] = 0.0f;
    }
    for (uint32_t slot = 0U; slot < 41U; ++slot) {
        state->has_wheel[slot] = 0.0f;
    }
    state->next_position = 0.0f;
    state->next_speed = 0.0f;
    state->next_slope = 0.0f;
    state->known = 0U;
    state->slot_camera = 38U;
    state->since = 0U;
}

void two_rates_step(two_rates_state *state, const two_rates_measurements *measurements,
                    const two_rates_inputs *inputs, two_rates_estimate *estimate)
{
    two_rates_work work;
    two_rates_part_1(state, measurements, inputs, &work);
    two_rates_part_2(state, &work);
    two_rates_part_4(state, &work);
    two_rates_part_5(state, &work);
    two_rates_part_6(state, &work);

    estimate->position = work.t274;
    estimate->speed = work.t275;
    estimate->slope = work.t276;
    estimate->coasted = work.t32;
    estimate->status = work.t284;
}
