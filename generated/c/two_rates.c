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
    float t81;
    float t90;
    float t92;
    float t94;
    float t96;
    float t98;
    float t100;
    float t102;
    float t104;
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
    float t117;
    float t118;
    float t119;
    uint32_t t120;
    uint32_t t121;
    float t130;
    float t136;
    float t170;
    float t178;
    float t180;
    float t182;
    float t184;
    float t186;
    float t188;
    float t190;
    float t192;
    float t194;
    float t195;
    float t299;
    float t300;
    float t301;
    float t342;
    float t343;
    float t344;
    two_rates_status t352;
    int flags[5]; /* t46, t291, t293, t297, t298 */
} two_rates_work;

/* Part 1 of a step. */
static void two_rates_part_1(two_rates_state *state, const two_rates_measurements *measurements, const two_rates_inputs *inputs, two_rates_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    const uint32_t t0 = state->newest;
    const uint32_t t1 = (t0 < 40U) ? t0 : 40U;
    const float t2 = measurements->camera;
    const int t3 = (-1e30f <= t2) && (t2 <= 1e30f);
    const float t4 = measurements->wheel;
    const int t5 = (-1e30f <= t4) && (t4 <= 1e30f);
    const float t6 = inputs->force;
    const int t7 = (-1e30f <= t6) && (t6 <= 1e30f);
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
    const float t54 = 0.0f + t53;
    const float t55 = state->camera[work->t47];
    const float t56 = t55 - 0.0f;
    const float t58 = 200.0f * t56;
    const float t59 = t53 * 0.16012815f;
    const float t60 = t53 * -0.114321806f;
    const float t61 = t53 * 0.05932351f;
    const float t62 = t59 * t59;
    const float t63 = 0.0f + t62;
    const float t64 = t59 * t60;
    const float t65 = 0.0f + t64;
    const float t66 = t59 * t61;
    const float t67 = 0.0f + t66;
    const float t68 = t60 * t60;
    const float t69 = 0.0f + t68;
    const float t70 = t60 * t61;
    const float t71 = 0.0f + t70;
    const float t72 = t61 * t61;
    const float t73 = 0.0f + t72;
    const float t74 = t59 * t58;
    const float t75 = 0.0f + t74;
    const float t76 = t60 * t58;
    const float t77 = 0.0f + t76;
    const float t78 = t61 * t58;
    const float t79 = 0.0f + t78;
    const float t80 = state->has_wheel[work->t47];
    work->t81 = t54 + t80;
    const float t82 = state->wheel[work->t47];
    const float t83 = t82 - 0.0f;
    const float t85 = 50.0f * t83;
    const float t86 = t80 * 0.0f;
    const float t87 = t80 * 0.16625516f;
    const float t88 = t80 * -0.2578622f;
    const float t89 = t86 * t86;
    work->t90 = t63 + t89;
    const float t91 = t86 * t87;
    work->t92 = t65 + t91;
    const float t93 = t86 * t88;
    work->t94 = t67 + t93;
    const float t95 = t87 * t87;
    work->t96 = t69 + t95;
    const float t97 = t87 * t88;
    work->t98 = t71 + t97;
    const float t99 = t88 * t88;
    work->t100 = t73 + t99;
    const float t101 = t86 * t85;
    work->t102 = t75 + t101;
    const float t103 = t87 * t85;
    work->t104 = t77 + t103;
    const float t105 = t88 * t85;
    work->t106 = t79 + t105;
}

/* Part 3 of a step, for one row of TWO_RATES_ROWS. */
static void two_rates_part_3(const two_rates_state *state, two_rates_work *work, const float *gains)
{
    work->t121 = (work->t120 < 40U) ? (work->t120 + 1U) : 0U;
    const float t122 = state->force[work->t121];
    const float t124 = 0.009960107f * work->t117;
    const float t126 = 4.9866932e-5f * work->t118;
    const float t127 = work->t116 + t124;
    const float t128 = t127 + t126;
    const float t129 = 1.9946774e-5f * t122;
    work->t130 = t128 + t129;
    const float t132 = 0.99203193f * work->t117;
    const float t133 = 0.009960107f * work->t118;
    const float t134 = t132 + t133;
    const float t135 = 0.0039840424f * t122;
    work->t136 = t134 + t135;
    const float t137 = gains[0];
    const float t138 = gains[1];
    const float t139 = gains[2];
    const float t140 = gains[3];
    const float t141 = gains[4];
    const float t142 = gains[5];
    const float t143 = state->has_camera[work->t121];
    const float t144 = work->t119 + t143;
    const float t145 = state->camera[work->t121];
    const float t146 = t145 - work->t130;
    const float t147 = 200.0f * t146;
    const float t148 = t143 * t137;
    const float t149 = t143 * t138;
    const float t150 = t143 * t139;
    const float t151 = t148 * t148;
    const float t152 = work->t107 + t151;
    const float t153 = t148 * t149;
    const float t154 = work->t108 + t153;
    const float t155 = t148 * t150;
    const float t156 = work->t109 + t155;
    const float t157 = t149 * t149;
    const float t158 = work->t110 + t157;
    const float t159 = t149 * t150;
    const float t160 = work->t111 + t159;
    const float t161 = t150 * t150;
    const float t162 = work->t112 + t161;
    const float t163 = t148 * t147;
    const float t164 = work->t113 + t163;
    const float t165 = t149 * t147;
    const float t166 = work->t114 + t165;
    const float t167 = t150 * t147;
    const float t168 = work->t115 + t167;
    const float t169 = state->has_wheel[work->t121];
    work->t170 = t144 + t169;
    const float t171 = state->wheel[work->t121];
    const float t172 = t171 - work->t136;
    const float t173 = 50.0f * t172;
    const float t174 = t169 * t140;
    const float t175 = t169 * t141;
    const float t176 = t169 * t142;
    const float t177 = t174 * t174;
    work->t178 = t152 + t177;
    const float t179 = t174 * t175;
    work->t180 = t154 + t179;
    const float t181 = t174 * t176;
    work->t182 = t156 + t181;
    const float t183 = t175 * t175;
    work->t184 = t158 + t183;
    const float t185 = t175 * t176;
    work->t186 = t160 + t185;
    const float t187 = t176 * t176;
    work->t188 = t162 + t187;
    const float t189 = t174 * t173;
    work->t190 = t164 + t189;
    const float t191 = t175 * t173;
    work->t192 = t166 + t191;
    const float t193 = t176 * t173;
    work->t194 = t168 + t193;
    work->t195 = work->t118 - 0.0f;
}

/* Part 4 of a step. */
static void two_rates_part_4(const two_rates_state *state, two_rates_work *work)
{
    work->t107 = work->t90;
    work->t108 = work->t92;
    work->t109 = work->t94;
    work->t110 = work->t96;
    work->t111 = work->t98;
    work->t112 = work->t100;
    work->t113 = work->t102;
    work->t114 = work->t104;
    work->t115 = work->t106;
    work->t116 = 0.0f;
    work->t117 = 0.0f;
    work->t118 = 0.0f;
    work->t119 = work->t81;
    work->t120 = work->t47;
    for (uint32_t row = 0U; row < 40U; ++row) {
        const float *const gains = TWO_RATES_ROWS[row];
        two_rates_part_3(state, work, gains);
        work->t107 = work->t178;
        work->t108 = work->t180;
        work->t109 = work->t182;
        work->t110 = work->t184;
        work->t111 = work->t186;
        work->t112 = work->t188;
        work->t113 = work->t190;
        work->t114 = work->t192;
        work->t115 = work->t194;
        work->t116 = work->t130;
        work->t117 = work->t136;
        work->t118 = work->t195;
        work->t119 = work->t170;
        work->t120 = work->t121;
    }
}

/* Part 5 of a step. */
static void two_rates_part_5(two_rates_work *work)
{
    /* the state from the samples that are there, and its variance */
    const float t204 = 0.0001f * work->t107;
    const float t205 = t204 + 9.8607613e-32f;
    const float t206 = 0.0001f * work->t110;
    const float t207 = t206 + 9.8607613e-32f;
    const float t208 = 0.0001f * work->t112;
    const float t209 = t208 + 9.8607613e-32f;
    const int t210 = t205 < work->t107;
    const float t211 = t210 ? work->t107 : 1.0f;
    const float t212 = work->t108 / t211;
    const float t213 = work->t109 / t211;
    const float t214 = t212 * work->t108;
    const float t215 = work->t110 - t214;
    const float t216 = t212 * work->t109;
    const float t217 = work->t111 - t216;
    const float t218 = t212 * work->t113;
    const float t219 = work->t114 - t218;
    const float t220 = t213 * work->t109;
    const float t221 = work->t112 - t220;
    const float t222 = t213 * work->t113;
    const float t223 = work->t115 - t222;
    const float t224 = work->t113 / t211;
    const float t225 = t212 * 0.05124101f;
    const float t226 = 0.03626364f - t225;
    const float t227 = t213 * 0.05124101f;
    const float t228 = 0.026379956f - t227;
    const float t229 = 0.05124101f * t224;
    const float t230 = 0.05124101f / t211;
    const float t231 = 0.05124101f * t230;
    const int t232 = t207 < t215;
    const int t233 = t210 && t232;
    const float t234 = t232 ? t215 : 1.0f;
    const float t235 = t217 / t234;
    const float t236 = t235 * t217;
    const float t237 = t221 - t236;
    const float t238 = t235 * t219;
    const float t239 = t223 - t238;
    const float t240 = t219 / t234;
    const float t241 = t235 * t226;
    const float t242 = t228 - t241;
    const float t243 = t226 * t240;
    const float t244 = t229 + t243;
    const float t245 = t226 / t234;
    const float t246 = t226 * t245;
    const float t247 = t231 + t246;
    const float t248 = t235 * 0.03863233f;
    const float t249 = 0.082951546f - t248;
    const float t250 = 0.03863233f * t240;
    const float t251 = 0.03863233f / t234;
    const float t252 = 0.03863233f * t251;
    const int t253 = t209 < t237;
    const int t254 = t233 && t253;
    const float t255 = t253 ? t237 : 1.0f;
    const float t256 = t239 / t255;
    const float t257 = t242 * t256;
    const float t258 = t244 + t257;
    const float t259 = t242 / t255;
    const float t260 = t242 * t259;
    const float t261 = t247 + t260;
    const float t262 = t249 * t256;
    const float t263 = t250 + t262;
    const float t264 = t249 / t255;
    const float t265 = t249 * t264;
    const float t266 = t252 + t265;
    const float t267 = 0.10434171f * t256;
    const float t268 = 0.10434171f / t255;
    const float t269 = 0.10434171f * t268;
    const float t271 = 0.015625f * t258;
    const float t273 = 0.0625f * t263;
    const float t275 = 0.25f * t267;

    /* what it is worth */
    const float t277 = t261 * 0.5450689f;
    const int t278 = 0.0f < t277;
    const float t279 = t278 ? t277 : 0.0f;
    const float t281 = t266 * 0.88691145f;
    const int t282 = t279 < t281;
    const float t283 = t282 ? t281 : t279;
    const float t285 = t269 * 0.67655134f;
    const int t286 = t283 < t285;
    const float t287 = t286 ? t285 : t283;
    const int t290 = t287 <= 1.3221358e8f;
    work->flags[1] = t254 && t290;
    const int t292 = t287 <= 132.2136f;
    work->flags[2] = work->flags[1] && t292;
    const float t294 = work->t119 + 0.0f;
    const float t295 = t287 * t294;
    const int t296 = t295 <= 1.0f;
    work->flags[3] = work->flags[2] && t296;
    work->flags[4] = 0.0f < work->t119;
    work->t299 = t271 + work->t116;
    work->t300 = t273 + work->t117;
    work->t301 = t275 + work->t118;
}

/* Part 6 of a step. */
static void two_rates_part_6(two_rates_state *state, two_rates_work *work)
{
    /* without enough samples, the model's prediction */
    const uint32_t t302 = state->known;
    const int t303 = t302 == 1U;
    const int t304 = (-1e30f <= work->t14) && (work->t14 <= 1e30f);
    const int t305 = t303 && t304;
    const int t306 = (-1e30f <= work->t18) && (work->t18 <= 1e30f);
    const int t307 = t305 && t306;
    const int t308 = (-1e30f <= work->t19) && (work->t19 <= 1e30f);
    const int t309 = t307 && t308;
    const uint32_t t310 = state->poor;
    const uint32_t t311 = (t310 < 123U) ? (t310 + 1U) : 123U;
    const uint32_t t312 = work->flags[4] ? t311 : t310;
    const uint32_t t313 = work->flags[2] ? 0U : t312;
    state->poor = t313;
    const int t315 = t313 < 123U;
    const int t316 = t315 && t309;
    const int t317 = !t316;
    const int t318 = work->flags[2] || t317;
    const int t319 = work->flags[1] && t318;
    const float t320 = t319 ? work->t299 : work->t14;
    const float t321 = t319 ? work->t300 : work->t18;
    const float t322 = t319 ? work->t301 : work->t19;
    const int t323 = t319 || t309;
    const int t324 = work->flags[0] && t323;
    const uint32_t t325 = t324 ? 1U : 0U;
    state->known = t325;
    const float t327 = 0.009960107f * t321;
    const float t329 = 4.9866932e-5f * t322;
    const float t330 = t320 + t327;
    const float t331 = t330 + t329;
    const int t332 = (-1e30f <= t331) && (t331 <= 1e30f);
    const float t333 = t332 ? t331 : 0.0f;
    state->next_position = t333;
    const float t335 = 0.99203193f * t321;
    const float t336 = 0.009960107f * t322;
    const float t337 = t335 + t336;
    const int t338 = (-1e30f <= t337) && (t337 <= 1e30f);
    const float t339 = t338 ? t337 : 0.0f;
    state->next_speed = t339;
    const int t340 = (-1e30f <= t322) && (t322 <= 1e30f);
    const float t341 = t340 ? t322 : 0.0f;
    state->next_slope = t341;

    /* the estimate; until there is one, the start */
    work->t342 = t324 ? t320 : 0.0f;
    work->t343 = t324 ? t321 : work->t27;
    work->t344 = t324 ? t322 : 0.0f;
    const uint32_t t345 = state->coasting;
    const int t346 = t345 == 0U;
    const int t347 = work->flags[3] && t346;
    const two_rates_status t351 = t347 ? TWO_RATES_CONVERGED : TWO_RATES_COASTING;
    work->t352 = t324 ? t351 : TWO_RATES_CONVERGING;
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
    state->poor = 123U;
    state->since = 0U;
}

void two_rates_step(two_rates_state *state, const two_rates_measurements *measurements,
                    const two_rates_inputs *inputs, two_rates_estimate *estimate)
{
    two_rates_work work;
    two_rates_part_1(state, measurements, inputs, &work);
    two_rates_part_2(state, &work);
    two_rates_part_4(state, &work);
    two_rates_part_5(&work);
    two_rates_part_6(state, &work);

    estimate->position = work.t342;
    estimate->speed = work.t343;
    estimate->slope = work.t344;
    estimate->coasted = work.t32;
    estimate->status = work.t352;
}
