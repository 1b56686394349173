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
#pragma GCC optimize("fp-contract=off")
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
    float t9;
    uint32_t t10;
    float t19;
    uint32_t t27;
    uint32_t t38;
    float t79;
    float t81;
    float t83;
    float t85;
    float t87;
    float t89;
    float t91;
    float t93;
    float t95;
    float t96;
    float t97;
    float t98;
    float t99;
    float t100;
    float t101;
    float t102;
    float t103;
    float t104;
    float t105;
    float t106;
    float t107;
    uint32_t t108;
    uint32_t t109;
    float t119;
    float t126;
    float t166;
    float t168;
    float t170;
    float t172;
    float t174;
    float t176;
    float t178;
    float t180;
    float t182;
    float t183;
    float t227;
    float t233;
    float t236;
    float t276;
    float t277;
    float t278;
    two_rates_status t286;
    int flags[2]; /* t37, t208 */
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
    work->t9 = t7 ? t6 : t8;
    work->t10 = (t1 < 40U) ? (t1 + 1U) : 0U;
    const uint32_t t13 = state->slot_camera;
    const uint32_t t14 = (t13 < 40U) ? t13 : 40U;
    const uint32_t t15 = (t14 < 40U) ? (t14 + 1U) : 0U;
    state->slot_camera = t15;
    const float t16 = state->camera[t14];
    const float t17 = t3 ? t2 : t16;
    const float t18 = state->wheel[t1];
    work->t19 = t5 ? t4 : t18;
    const float t20 = t3 ? 1.0f : 0.0f;
    const float t21 = t5 ? 1.0f : 0.0f;
    const uint32_t t22 = state->count;
    const int t23 = t3 || t5;
    const uint32_t t25 = state->since;
    const uint32_t t26 = (t25 < 4294967295U) ? (t25 + 1U) : 4294967295U;
    work->t27 = t23 ? 0U : t26;
    state->since = work->t27;

    /* how much of the window is good */
    const int t29 = 40U < t22;
    const uint32_t t31 = (t22 < 42U) ? (t22 + 1U) : 42U;
    const uint32_t t32 = t7 ? t31 : 1U;
    const uint32_t t33 = t29 ? t31 : t32;
    state->count = t33;
    const uint32_t t34 = state->coasting;
    const uint32_t t35 = (t34 > 0U) ? (t34 - 1U) : 0U;
    const uint32_t t36 = t7 ? t35 : 40U;
    state->coasting = t36;

    /* into the window */
    state->newest = work->t10;
    state->camera[t15] = t17;
    state->wheel[work->t10] = work->t19;
    state->has_camera[work->t10] = 0.0f;
    state->has_camera[t15] = t20;
    state->has_wheel[work->t10] = t21;
    state->force[work->t10] = work->t9;
    work->flags[0] = 40U < t33;
}

/* Part 2 of a step. */
static void two_rates_part_2(const two_rates_state *state, two_rates_work *work)
{
    /* rows of the window, oldest first; those without a sample count nothing */
    work->t38 = (work->t10 < 40U) ? (work->t10 + 1U) : 0U;
    const float t44 = state->has_camera[work->t38];
    const float t45 = state->camera[work->t38];
    const float t46 = t45 - 0.0f;
    const float t48 = 200.0f * t46;
    const float t49 = t44 * 0.16012815f;
    const float t50 = t44 * -0.114321806f;
    const float t51 = t44 * 0.05932351f;
    const float t52 = t49 * t49;
    const float t53 = 0.0f + t52;
    const float t54 = t49 * t50;
    const float t55 = 0.0f + t54;
    const float t56 = t49 * t51;
    const float t57 = 0.0f + t56;
    const float t58 = t50 * t50;
    const float t59 = 0.0f + t58;
    const float t60 = t50 * t51;
    const float t61 = 0.0f + t60;
    const float t62 = t51 * t51;
    const float t63 = 0.0f + t62;
    const float t64 = t49 * t48;
    const float t65 = 0.0f + t64;
    const float t66 = t50 * t48;
    const float t67 = 0.0f + t66;
    const float t68 = t51 * t48;
    const float t69 = 0.0f + t68;
    const float t70 = state->has_wheel[work->t38];
    const float t71 = state->wheel[work->t38];
    const float t72 = t71 - 0.0f;
    const float t74 = 50.0f * t72;
    const float t75 = t70 * 0.0f;
    const float t76 = t70 * 0.16625516f;
    const float t77 = t70 * -0.2578622f;
    const float t78 = t75 * t75;
    work->t79 = t53 + t78;
    const float t80 = t75 * t76;
    work->t81 = t55 + t80;
    const float t82 = t75 * t77;
    work->t83 = t57 + t82;
    const float t84 = t76 * t76;
    work->t85 = t59 + t84;
    const float t86 = t76 * t77;
    work->t87 = t61 + t86;
    const float t88 = t77 * t77;
    work->t89 = t63 + t88;
    const float t90 = t75 * t74;
    work->t91 = t65 + t90;
    const float t92 = t76 * t74;
    work->t93 = t67 + t92;
    const float t94 = t77 * t74;
    work->t95 = t69 + t94;
}

/* Part 3 of a step, for one row of TWO_RATES_ROWS. */
static void two_rates_part_3(const two_rates_state *state, two_rates_work *work, const float *gains)
{
    work->t109 = (work->t108 < 40U) ? (work->t108 + 1U) : 0U;
    const float t110 = state->force[work->t109];
    const float t112 = 0.009960107f * work->t106;
    const float t114 = 4.9866932e-5f * work->t107;
    const float t115 = work->t105 + t112;
    const float t116 = t115 + t114;
    const float t118 = 1.9946774e-5f * t110;
    work->t119 = t116 + t118;
    const float t121 = 0.99203193f * work->t106;
    const float t122 = 0.009960107f * work->t107;
    const float t123 = t121 + t122;
    const float t125 = 0.0039840424f * t110;
    work->t126 = t123 + t125;
    const float t127 = gains[0];
    const float t128 = gains[1];
    const float t129 = gains[2];
    const float t130 = gains[3];
    const float t131 = gains[4];
    const float t132 = gains[5];
    const float t133 = state->has_camera[work->t109];
    const float t134 = state->camera[work->t109];
    const float t135 = t134 - work->t119;
    const float t136 = 200.0f * t135;
    const float t137 = t133 * t127;
    const float t138 = t133 * t128;
    const float t139 = t133 * t129;
    const float t140 = t137 * t137;
    const float t141 = work->t96 + t140;
    const float t142 = t137 * t138;
    const float t143 = work->t97 + t142;
    const float t144 = t137 * t139;
    const float t145 = work->t98 + t144;
    const float t146 = t138 * t138;
    const float t147 = work->t99 + t146;
    const float t148 = t138 * t139;
    const float t149 = work->t100 + t148;
    const float t150 = t139 * t139;
    const float t151 = work->t101 + t150;
    const float t152 = t137 * t136;
    const float t153 = work->t102 + t152;
    const float t154 = t138 * t136;
    const float t155 = work->t103 + t154;
    const float t156 = t139 * t136;
    const float t157 = work->t104 + t156;
    const float t158 = state->has_wheel[work->t109];
    const float t159 = state->wheel[work->t109];
    const float t160 = t159 - work->t126;
    const float t161 = 50.0f * t160;
    const float t162 = t158 * t130;
    const float t163 = t158 * t131;
    const float t164 = t158 * t132;
    const float t165 = t162 * t162;
    work->t166 = t141 + t165;
    const float t167 = t162 * t163;
    work->t168 = t143 + t167;
    const float t169 = t162 * t164;
    work->t170 = t145 + t169;
    const float t171 = t163 * t163;
    work->t172 = t147 + t171;
    const float t173 = t163 * t164;
    work->t174 = t149 + t173;
    const float t175 = t164 * t164;
    work->t176 = t151 + t175;
    const float t177 = t162 * t161;
    work->t178 = t153 + t177;
    const float t179 = t163 * t161;
    work->t180 = t155 + t179;
    const float t181 = t164 * t161;
    work->t182 = t157 + t181;
    work->t183 = work->t107 - 0.0f;
}

/* Part 4 of a step. */
static void two_rates_part_4(const two_rates_state *state, two_rates_work *work)
{
    work->t96 = work->t79;
    work->t97 = work->t81;
    work->t98 = work->t83;
    work->t99 = work->t85;
    work->t100 = work->t87;
    work->t101 = work->t89;
    work->t102 = work->t91;
    work->t103 = work->t93;
    work->t104 = work->t95;
    work->t105 = 0.0f;
    work->t106 = 0.0f;
    work->t107 = 0.0f;
    work->t108 = work->t38;
    for (uint32_t row = 0U; row < 40U; ++row) {
        const float *const gains = TWO_RATES_ROWS[row];
        two_rates_part_3(state, work, gains);
        work->t96 = work->t166;
        work->t97 = work->t168;
        work->t98 = work->t170;
        work->t99 = work->t172;
        work->t100 = work->t174;
        work->t101 = work->t176;
        work->t102 = work->t178;
        work->t103 = work->t180;
        work->t104 = work->t182;
        work->t105 = work->t119;
        work->t106 = work->t126;
        work->t107 = work->t183;
        work->t108 = work->t109;
    }
}

/* Part 5 of a step. */
static void two_rates_part_5(two_rates_work *work)
{
    /* the window's start from the samples that are there */
    const int t185 = 0.0028044872f < work->t96;
    const float t186 = t185 ? work->t96 : 1.0f;
    const float t187 = work->t97 / t186;
    const float t188 = t187 * work->t97;
    const float t189 = work->t99 - t188;
    const float t190 = t187 * work->t98;
    const float t191 = work->t100 - t190;
    const float t192 = t187 * work->t102;
    const float t193 = work->t103 - t192;
    const float t194 = work->t98 / t186;
    const float t195 = t194 * work->t98;
    const float t196 = work->t101 - t195;
    const float t197 = t194 * work->t102;
    const float t198 = work->t104 - t197;
    const int t199 = 0.0028044872f < t189;
    const int t200 = t185 && t199;
    const float t201 = t199 ? t189 : 1.0f;
    const float t202 = t191 / t201;
    const float t203 = t202 * t191;
    const float t204 = t196 - t203;
    const float t205 = t202 * t193;
    const float t206 = t198 - t205;
    const int t207 = 0.0028044872f < t204;
    work->flags[1] = t200 && t207;
    const float t209 = t207 ? t204 : 1.0f;
    const float t210 = t206 / t209;
    const float t211 = t191 * t210;
    const float t212 = t193 - t211;
    const float t213 = t212 / t201;
    const float t214 = work->t97 * t213;
    const float t215 = work->t102 - t214;
    const float t216 = work->t98 * t210;
    const float t217 = t215 - t216;
    const float t218 = t217 / t186;
    const float t220 = 0.0008006408f * t218;
    const float t222 = 0.0005666194f * t213;
    const float t224 = 0.0004121868f * t210;
    const float t225 = t220 + t222;
    const float t226 = t225 + t224;
    work->t227 = t226 + work->t105;
    const float t229 = 0.0024145206f * t213;
    const float t231 = 0.0051844716f * t210;
    const float t232 = t229 + t231;
    work->t233 = t232 + work->t106;
    const float t235 = 0.026085427f * t210;
    work->t236 = t235 + work->t107;
}

/* Part 6 of a step. */
static void two_rates_part_6(two_rates_state *state, two_rates_work *work)
{
    /* without enough samples, the model's prediction */
    const uint32_t t237 = state->known;
    const int t238 = t237 == 1U;
    const float t239 = state->next_position;
    const float t241 = 1.9946774e-5f * work->t9;
    const float t242 = t239 + t241;
    const int t243 = (-1e25f <= t242) && (t242 <= 1e25f);
    const int t244 = t238 && t243;
    const float t245 = work->flags[1] ? work->t227 : t242;
    const float t246 = state->next_speed;
    const float t248 = 0.0039840424f * work->t9;
    const float t249 = t246 + t248;
    const int t250 = (-1e25f <= t249) && (t249 <= 1e25f);
    const int t251 = t244 && t250;
    const float t252 = work->flags[1] ? work->t233 : t249;
    const float t253 = state->next_slope;
    const int t254 = (-1e25f <= t253) && (t253 <= 1e25f);
    const int t255 = t251 && t254;
    const float t256 = work->flags[1] ? work->t236 : t253;
    const int t257 = work->flags[1] || t255;
    const int t258 = work->flags[0] && t257;
    const uint32_t t259 = t258 ? 1U : 0U;
    state->known = t259;
    const float t261 = 0.009960107f * t252;
    const float t263 = 4.9866932e-5f * t256;
    const float t264 = t245 + t261;
    const float t265 = t264 + t263;
    const int t266 = (-1e25f <= t265) && (t265 <= 1e25f);
    const float t267 = t266 ? t265 : 0.0f;
    state->next_position = t267;
    const float t269 = 0.99203193f * t252;
    const float t270 = 0.009960107f * t256;
    const float t271 = t269 + t270;
    const int t272 = (-1e25f <= t271) && (t271 <= 1e25f);
    const float t273 = t272 ? t271 : 0.0f;
    state->next_speed = t273;
    const int t274 = (-1e25f <= t256) && (t256 <= 1e25f);
    const float t275 = t274 ? t256 : 0.0f;
    state->next_slope = t275;

    /* the estimate; until there is one, the start */
    work->t276 = t258 ? t245 : 0.0f;
    work->t277 = t258 ? t252 : work->t19;
    work->t278 = t258 ? t256 : 0.0f;
    const uint32_t t279 = state->coasting;
    const int t280 = t279 == 0U;
    const int t281 = work->flags[1] && t280;
    const two_rates_status t285 = t281 ? TWO_RATES_CONVERGED : TWO_RATES_COASTING;
    work->t286 = t258 ? t285 : TWO_RATES_CONVERGING;
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
    two_rates_part_5(&work);
    two_rates_part_6(state, &work);

    estimate->position = work.t276;
    estimate->speed = work.t277;
    estimate->slope = work.t278;
    estimate->coasted = work.t27;
    estimate->status = work.t286;
}
