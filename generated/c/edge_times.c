/* edge_times.c: Finite-time observer: Speed and acceleration of a shaft from the times of its encoder's edges.
 *
 * Generated; edge_times.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "edge_times.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "edge_times.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "edge_times.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* orthonormal rows of the window, oldest first
 *   [0] state q in direction 1
 *   [1] state q in direction 2
 *   [2] state q in direction 3
 *   [3] state dq in direction 1
 *   [4] state dq in direction 2
 *   [5] state dq in direction 3
 *   [6] state ddq in direction 1
 *   [7] state ddq in direction 2
 *   [8] state ddq in direction 3
 */
static const float EDGE_TIMES_ROWS[50][9] = {
    { 0.14002801f, -0.22831272f, 0.25979215f, 0.0f, 9.51303f, -34.703217f, 0.0f, 0.0f, 1445.9674f },
    { 0.14002801f, -0.21879968f, 0.22581191f, 0.0f, 9.51303f, -33.25725f, 0.0f, 0.0f, 1445.9674f },
    { 0.14002801f, -0.20928666f, 0.19327764f, 0.0f, 9.51303f, -31.811283f, 0.0f, 0.0f, 1445.9674f },
    { 0.14002801f, -0.19977362f, 0.16218935f, 0.0f, 9.51303f, -30.365316f, 0.0f, 0.0f, 1445.9674f },
    { 0.14002801f, -0.1902606f, 0.13254702f, 0.0f, 9.51303f, -28.919348f, 0.0f, 0.0f, 1445.9674f },
    { 0.14002801f, -0.18074757f, 0.10435065f, 0.0f, 9.51303f, -27.473381f, 0.0f, 0.0f, 1445.9674f },
    {
        0.14002801f, -0.17123453f, 0.077600256f, 0.0f, 9.51303f, -26.027414f, 0.0f, 0.0f, 1445.9674f
    },
    {
        0.14002801f, -0.16172151f, 0.052295823f, 0.0f, 9.51303f, -24.581446f, 0.0f, 0.0f, 1445.9674f
    },
    { 0.14002801f, -0.15220848f, 0.02843736f, 0.0f, 9.51303f, -23.135479f, 0.0f, 0.0f, 1445.9674f },
    {
        0.14002801f, -0.14269544f, 0.0060248645f, 0.0f, 9.51303f, -21.689512f, 0.0f, 0.0f,
        1445.9674f
    },
    {
        0.14002801f, -0.13318242f, -0.0149416635f, 0.0f, 9.51303f, -20.243544f, 0.0f, 0.0f,
        1445.9674f
    },
    {
        0.14002801f, -0.123669386f, -0.034462225f, 0.0f, 9.51303f, -18.797577f, 0.0f, 0.0f,
        1445.9674f
    },
    {
        0.14002801f, -0.11415636f, -0.052536815f, 0.0f, 9.51303f, -17.351608f, 0.0f, 0.0f,
        1445.9674f
    },
    {
        0.14002801f, -0.10464333f, -0.069165446f, 0.0f, 9.51303f, -15.905642f, 0.0f, 0.0f,
        1445.9674f
    },
    { 0.14002801f, -0.0951303f, -0.0843481f, 0.0f, 9.51303f, -14.459674f, 0.0f, 0.0f, 1445.9674f },
    {
        0.14002801f, -0.08561727f, -0.09808479f, 0.0f, 9.51303f, -13.013707f, 0.0f, 0.0f, 1445.9674f
    },
    {
        0.14002801f, -0.07610424f, -0.110375516f, 0.0f, 9.51303f, -11.5677395f, 0.0f, 0.0f,
        1445.9674f
    },
    {
        0.14002801f, -0.06659121f, -0.12122027f, 0.0f, 9.51303f, -10.121772f, 0.0f, 0.0f, 1445.9674f
    },
    { 0.14002801f, -0.05707818f, -0.13061906f, 0.0f, 9.51303f, -8.675804f, 0.0f, 0.0f, 1445.9674f },
    { 0.14002801f, -0.04756515f, -0.13857187f, 0.0f, 9.51303f, -7.229837f, 0.0f, 0.0f, 1445.9674f },
    {
        0.14002801f, -0.03805212f, -0.14507873f, 0.0f, 9.51303f, -5.7838697f, 0.0f, 0.0f, 1445.9674f
    },
    { 0.14002801f, -0.02853909f, -0.15013961f, 0.0f, 9.51303f, -4.337902f, 0.0f, 0.0f, 1445.9674f },
    {
        0.14002801f, -0.01902606f, -0.15375453f, 0.0f, 9.51303f, -2.8919349f, 0.0f, 0.0f, 1445.9674f
    },
    {
        0.14002801f, -0.00951303f, -0.15592349f, 0.0f, 9.51303f, -1.4459674f, 0.0f, 0.0f, 1445.9674f
    },
    { 0.14002801f, 0.0f, -0.15664648f, 0.0f, 9.51303f, 0.0f, 0.0f, 0.0f, 1445.9674f },
    { 0.14002801f, 0.00951303f, -0.15592349f, 0.0f, 9.51303f, 1.4459674f, 0.0f, 0.0f, 1445.9674f },
    { 0.14002801f, 0.01902606f, -0.15375453f, 0.0f, 9.51303f, 2.8919349f, 0.0f, 0.0f, 1445.9674f },
    { 0.14002801f, 0.02853909f, -0.15013961f, 0.0f, 9.51303f, 4.337902f, 0.0f, 0.0f, 1445.9674f },
    { 0.14002801f, 0.03805212f, -0.14507873f, 0.0f, 9.51303f, 5.7838697f, 0.0f, 0.0f, 1445.9674f },
    { 0.14002801f, 0.04756515f, -0.13857187f, 0.0f, 9.51303f, 7.229837f, 0.0f, 0.0f, 1445.9674f },
    { 0.14002801f, 0.05707818f, -0.13061906f, 0.0f, 9.51303f, 8.675804f, 0.0f, 0.0f, 1445.9674f },
    { 0.14002801f, 0.06659121f, -0.12122027f, 0.0f, 9.51303f, 10.121772f, 0.0f, 0.0f, 1445.9674f },
    {
        0.14002801f, 0.07610424f, -0.110375516f, 0.0f, 9.51303f, 11.5677395f, 0.0f, 0.0f, 1445.9674f
    },
    { 0.14002801f, 0.08561727f, -0.09808479f, 0.0f, 9.51303f, 13.013707f, 0.0f, 0.0f, 1445.9674f },
    { 0.14002801f, 0.0951303f, -0.0843481f, 0.0f, 9.51303f, 14.459674f, 0.0f, 0.0f, 1445.9674f },
    { 0.14002801f, 0.10464333f, -0.069165446f, 0.0f, 9.51303f, 15.905642f, 0.0f, 0.0f, 1445.9674f },
    { 0.14002801f, 0.11415636f, -0.052536815f, 0.0f, 9.51303f, 17.351608f, 0.0f, 0.0f, 1445.9674f },
    {
        0.14002801f, 0.123669386f, -0.034462225f, 0.0f, 9.51303f, 18.797577f, 0.0f, 0.0f, 1445.9674f
    },
    {
        0.14002801f, 0.13318242f, -0.0149416635f, 0.0f, 9.51303f, 20.243544f, 0.0f, 0.0f, 1445.9674f
    },
    { 0.14002801f, 0.14269544f, 0.0060248645f, 0.0f, 9.51303f, 21.689512f, 0.0f, 0.0f, 1445.9674f },
    { 0.14002801f, 0.15220848f, 0.02843736f, 0.0f, 9.51303f, 23.135479f, 0.0f, 0.0f, 1445.9674f },
    { 0.14002801f, 0.16172151f, 0.052295823f, 0.0f, 9.51303f, 24.581446f, 0.0f, 0.0f, 1445.9674f },
    { 0.14002801f, 0.17123453f, 0.077600256f, 0.0f, 9.51303f, 26.027414f, 0.0f, 0.0f, 1445.9674f },
    { 0.14002801f, 0.18074757f, 0.10435065f, 0.0f, 9.51303f, 27.473381f, 0.0f, 0.0f, 1445.9674f },
    { 0.14002801f, 0.1902606f, 0.13254702f, 0.0f, 9.51303f, 28.919348f, 0.0f, 0.0f, 1445.9674f },
    { 0.14002801f, 0.19977362f, 0.16218935f, 0.0f, 9.51303f, 30.365316f, 0.0f, 0.0f, 1445.9674f },
    { 0.14002801f, 0.20928666f, 0.19327764f, 0.0f, 9.51303f, 31.811283f, 0.0f, 0.0f, 1445.9674f },
    { 0.14002801f, 0.21879968f, 0.22581191f, 0.0f, 9.51303f, 33.25725f, 0.0f, 0.0f, 1445.9674f },
    { 0.14002801f, 0.22831272f, 0.25979215f, 0.0f, 9.51303f, 34.703217f, 0.0f, 0.0f, 1445.9674f },
    { 0.14002801f, 0.23782575f, 0.29521835f, 0.0f, 9.51303f, 36.149185f, 0.0f, 0.0f, 1445.9674f }
};

/* What one part of a step hands to the next. */
typedef struct {
    uint32_t t18;
    float t28;
    uint32_t t34;
    uint32_t t41;
    float t73;
    float t75;
    float t77;
    float t79;
    float t81;
    float t83;
    float t85;
    float t87;
    float t89;
    float t90;
    float t91;
    float t92;
    float t93;
    float t94;
    float t95;
    float t96;
    float t97;
    float t98;
    float t99;
    float t100;
    float t101;
    float t102;
    uint32_t t103;
    uint32_t t104;
    float t110;
    float t112;
    float t122;
    float t158;
    float t160;
    float t162;
    float t164;
    float t166;
    float t168;
    float t170;
    float t172;
    float t174;
    float t175;
    float t222;
    float t224;
    float t227;
    float t265;
    float t266;
    float t267;
    edge_times_status t275;
    int flags[2]; /* t40, t200 */
} edge_times_work;

/* Part 1 of a step. */
static void edge_times_part_1(edge_times_state *state, const edge_times_measurements *measurements, edge_times_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    const uint32_t t0 = state->newest;
    const uint32_t t1 = (t0 < 50U) ? t0 : 50U;
    const float t2 = measurements->edge;
    const int t3 = (-6588397.5f <= t2) && (t2 <= 6588397.5f);
    const float t5 = t2 * 0.15915494f;
    const float t7 = t5 + 1.2582912e7f;
    const float t8 = t7 - 1.2582912e7f;
    const float t10 = t8 * 6.28125f;
    const float t11 = t2 - t10;
    const float t13 = t8 * 0.0019350052f;
    const float t14 = t11 - t13;
    const float t16 = t8 * 3.019916e-7f;
    const float t17 = t14 - t16;
    work->t18 = (t1 < 50U) ? (t1 + 1U) : 0U;
    const float t19 = measurements->edge_age;
    const int t20 = (0.0f <= t19) && (t19 <= 0.01f);
    const int t21 = t3 && t20;
    const float t23 = t19 * 100.0f;
    const float t25 = t21 ? t23 : 0.0f;
    const float t27 = state->edge[t1];
    work->t28 = t21 ? t17 : t27;
    const float t29 = t21 ? 1.0f : 0.0f;
    const uint32_t t30 = state->count;
    const uint32_t t32 = state->since;
    const uint32_t t33 = (t32 < 4294967295U) ? (t32 + 1U) : 4294967295U;
    work->t34 = t21 ? 0U : t33;
    state->since = work->t34;

    /* how much of the window is good */
    const uint32_t t37 = (t30 < 51U) ? (t30 + 1U) : 51U;
    state->count = t37;
    const uint32_t t38 = state->coasting;
    const uint32_t t39 = (t38 > 0U) ? (t38 - 1U) : 0U;
    state->coasting = t39;

    /* into the window */
    state->newest = work->t18;
    state->edge[work->t18] = work->t28;
    state->has_edge[work->t18] = t29;
    state->age_edge[work->t18] = t25;
    work->flags[0] = 50U < t37;
}

/* Part 2 of a step. */
static void edge_times_part_2(const edge_times_state *state, edge_times_work *work)
{
    /* rows of the window, oldest first; those without a sample count nothing */
    work->t41 = (work->t18 < 50U) ? (work->t18 + 1U) : 0U;
    const float t42 = state->age_edge[work->t41];
    const float t44 = -0.01f * t42;
    const float t46 = 5e-5f * t42;
    const float t47 = t46 * t42;
    const float t49 = t44 * 0.0f;
    const float t50 = t47 * 0.0f;
    const float t51 = 0.14002801f + t49;
    const float t52 = t51 + t50;
    const float t55 = t44 * 9.51303f;
    const float t56 = -0.23782575f + t55;
    const float t57 = t56 + t50;
    const float t60 = t44 * -36.149185f;
    const float t62 = t47 * 1445.9674f;
    const float t63 = 0.29521835f + t60;
    const float t64 = t63 + t62;
    const float t65 = state->has_edge[work->t41];
    const float t66 = 0.0f + t49;
    const float t67 = t66 + t50;
    const float t68 = 0.0f - t67;
    const float t69 = t65 * t52;
    const float t70 = t65 * t57;
    const float t71 = t65 * t64;
    const float t72 = t69 * t69;
    work->t73 = 0.0f + t72;
    const float t74 = t69 * t70;
    work->t75 = 0.0f + t74;
    const float t76 = t69 * t71;
    work->t77 = 0.0f + t76;
    const float t78 = t70 * t70;
    work->t79 = 0.0f + t78;
    const float t80 = t70 * t71;
    work->t81 = 0.0f + t80;
    const float t82 = t71 * t71;
    work->t83 = 0.0f + t82;
    const float t84 = t69 * t68;
    work->t85 = 0.0f + t84;
    const float t86 = t70 * t68;
    work->t87 = 0.0f + t86;
    const float t88 = t71 * t68;
    work->t89 = 0.0f + t88;
}

/* Part 3 of a step, for one row of EDGE_TIMES_ROWS. */
static void edge_times_part_3(const edge_times_state *state, edge_times_work *work, const float *gains)
{
    work->t104 = (work->t103 < 50U) ? (work->t103 + 1U) : 0U;
    const float t106 = 0.001f * work->t100;
    const float t108 = 5e-7f * work->t101;
    const float t109 = work->t99 + t106;
    work->t110 = t109 + t108;
    const float t111 = 0.001f * work->t101;
    work->t112 = work->t100 + t111;
    const float t113 = state->edge[work->t103];
    const float t114 = state->edge[work->t104];
    const float t115 = t114 - t113;
    const float t116 = t115 * 0.15915494f;
    const float t117 = t116 + 1.2582912e7f;
    const float t118 = t117 - 1.2582912e7f;
    const float t120 = t118 * 6.2831855f;
    const float t121 = t115 - t120;
    work->t122 = work->t102 + t121;
    const float t123 = state->age_edge[work->t104];
    const float t124 = -0.01f * t123;
    const float t125 = 5e-5f * t123;
    const float t126 = t125 * t123;
    const float t127 = gains[0];
    const float t128 = gains[3];
    const float t129 = t124 * t128;
    const float t130 = gains[6];
    const float t131 = t126 * t130;
    const float t132 = t127 + t129;
    const float t133 = t132 + t131;
    const float t134 = gains[1];
    const float t135 = gains[4];
    const float t136 = t124 * t135;
    const float t137 = gains[7];
    const float t138 = t126 * t137;
    const float t139 = t134 + t136;
    const float t140 = t139 + t138;
    const float t141 = gains[2];
    const float t142 = gains[5];
    const float t143 = t124 * t142;
    const float t144 = gains[8];
    const float t145 = t126 * t144;
    const float t146 = t141 + t143;
    const float t147 = t146 + t145;
    const float t148 = state->has_edge[work->t104];
    const float t149 = t124 * work->t112;
    const float t150 = t126 * work->t101;
    const float t151 = work->t110 + t149;
    const float t152 = t151 + t150;
    const float t153 = work->t122 - t152;
    const float t154 = t148 * t133;
    const float t155 = t148 * t140;
    const float t156 = t148 * t147;
    const float t157 = t154 * t154;
    work->t158 = work->t90 + t157;
    const float t159 = t154 * t155;
    work->t160 = work->t91 + t159;
    const float t161 = t154 * t156;
    work->t162 = work->t92 + t161;
    const float t163 = t155 * t155;
    work->t164 = work->t93 + t163;
    const float t165 = t155 * t156;
    work->t166 = work->t94 + t165;
    const float t167 = t156 * t156;
    work->t168 = work->t95 + t167;
    const float t169 = t154 * t153;
    work->t170 = work->t96 + t169;
    const float t171 = t155 * t153;
    work->t172 = work->t97 + t171;
    const float t173 = t156 * t153;
    work->t174 = work->t98 + t173;
    work->t175 = work->t101 - 0.0f;
}

/* Part 4 of a step. */
static void edge_times_part_4(const edge_times_state *state, edge_times_work *work)
{
    work->t90 = work->t73;
    work->t91 = work->t75;
    work->t92 = work->t77;
    work->t93 = work->t79;
    work->t94 = work->t81;
    work->t95 = work->t83;
    work->t96 = work->t85;
    work->t97 = work->t87;
    work->t98 = work->t89;
    work->t99 = 0.0f;
    work->t100 = 0.0f;
    work->t101 = 0.0f;
    work->t102 = 0.0f;
    work->t103 = work->t41;
    for (uint32_t row = 0U; row < 50U; ++row) {
        const float *const gains = EDGE_TIMES_ROWS[row];
        edge_times_part_3(state, work, gains);
        work->t90 = work->t158;
        work->t91 = work->t160;
        work->t92 = work->t162;
        work->t93 = work->t164;
        work->t94 = work->t166;
        work->t95 = work->t168;
        work->t96 = work->t170;
        work->t97 = work->t172;
        work->t98 = work->t174;
        work->t99 = work->t110;
        work->t100 = work->t112;
        work->t101 = work->t175;
        work->t102 = work->t122;
        work->t103 = work->t104;
    }
}

/* Part 5 of a step. */
static void edge_times_part_5(const edge_times_state *state, edge_times_work *work)
{
    /* the window's start from the samples that are there */
    const int t177 = 0.015625f < work->t90;
    const float t178 = t177 ? work->t90 : 1.0f;
    const float t179 = work->t91 / t178;
    const float t180 = t179 * work->t91;
    const float t181 = work->t93 - t180;
    const float t182 = t179 * work->t92;
    const float t183 = work->t94 - t182;
    const float t184 = t179 * work->t96;
    const float t185 = work->t97 - t184;
    const float t186 = work->t92 / t178;
    const float t187 = t186 * work->t92;
    const float t188 = work->t95 - t187;
    const float t189 = t186 * work->t96;
    const float t190 = work->t98 - t189;
    const int t191 = 0.015625f < t181;
    const int t192 = t177 && t191;
    const float t193 = t191 ? t181 : 1.0f;
    const float t194 = t183 / t193;
    const float t195 = t194 * t183;
    const float t196 = t188 - t195;
    const float t197 = t194 * t185;
    const float t198 = t190 - t197;
    const int t199 = 0.015625f < t196;
    work->flags[1] = t192 && t199;
    const float t201 = t199 ? t196 : 1.0f;
    const float t202 = t198 / t201;
    const float t203 = t183 * t202;
    const float t204 = t185 - t203;
    const float t205 = t204 / t193;
    const float t206 = work->t91 * t205;
    const float t207 = work->t96 - t206;
    const float t208 = work->t92 * t202;
    const float t209 = t207 - t208;
    const float t210 = t209 / t178;
    const float t211 = 0.14002801f * t210;
    const float t213 = 0.23782575f * t205;
    const float t214 = 0.29521835f * t202;
    const float t215 = t211 + t213;
    const float t216 = t215 + t214;
    const float t217 = t216 + work->t99;
    const float t218 = 9.51303f * t205;
    const float t220 = 36.149185f * t202;
    const float t221 = t218 + t220;
    work->t222 = t221 + work->t100;
    const float t223 = 1445.9674f * t202;
    work->t224 = t223 + work->t101;
    const float t225 = state->edge[work->t18];
    const float t226 = t225 - work->t102;
    work->t227 = t217 + t226;
}

/* Part 6 of a step. */
static void edge_times_part_6(edge_times_state *state, edge_times_work *work)
{
    /* without enough samples, the model's prediction */
    const uint32_t t228 = state->known;
    const int t229 = t228 == 1U;
    const float t230 = state->next_q;
    const float t231 = state->next_dq;
    const float t232 = state->next_ddq;
    const float t233 = t230 * 0.15915494f;
    const float t234 = t233 + 1.2582912e7f;
    const float t235 = t234 - 1.2582912e7f;
    const float t237 = t235 * -6.2831855f;
    const float t238 = t230 + t237;
    const int t239 = (-1e24f <= t238) && (t238 <= 1e24f);
    const int t240 = t229 && t239;
    const float t241 = work->flags[1] ? work->t227 : t238;
    const int t242 = (-1e24f <= t231) && (t231 <= 1e24f);
    const int t243 = t240 && t242;
    const float t244 = work->flags[1] ? work->t222 : t231;
    const int t245 = (-1e24f <= t232) && (t232 <= 1e24f);
    const int t246 = t243 && t245;
    const float t247 = work->flags[1] ? work->t224 : t232;
    const int t248 = work->flags[1] || t246;
    const int t249 = work->flags[0] && t248;
    const uint32_t t250 = t249 ? 1U : 0U;
    state->known = t250;
    const float t252 = 0.001f * t244;
    const float t254 = 5e-7f * t247;
    const float t255 = t241 + t252;
    const float t256 = t255 + t254;
    const int t257 = (-1e24f <= t256) && (t256 <= 1e24f);
    const float t258 = t257 ? t256 : 0.0f;
    state->next_q = t258;
    const float t259 = 0.001f * t247;
    const float t260 = t244 + t259;
    const int t261 = (-1e24f <= t260) && (t260 <= 1e24f);
    const float t262 = t261 ? t260 : 0.0f;
    state->next_dq = t262;
    const int t263 = (-1e24f <= t247) && (t247 <= 1e24f);
    const float t264 = t263 ? t247 : 0.0f;
    state->next_ddq = t264;

    /* the estimate; until there is one, the start */
    work->t265 = t249 ? t241 : work->t28;
    work->t266 = t249 ? t244 : 0.0f;
    work->t267 = t249 ? t247 : 0.0f;
    const uint32_t t268 = state->coasting;
    const int t269 = t268 == 0U;
    const int t270 = work->flags[1] && t269;
    const edge_times_status t274 = t270 ? EDGE_TIMES_CONVERGED : EDGE_TIMES_COASTING;
    work->t275 = t249 ? t274 : EDGE_TIMES_CONVERGING;
}

void edge_times_init(edge_times_state *state)
{
    for (uint32_t slot = 0U; slot < 51U; ++slot) {
        state->edge[slot] = 0.0f;
    }
    state->newest = 50U;
    state->count = 0U;
    state->coasting = 0U;
    for (uint32_t slot = 0U; slot < 51U; ++slot) {
        state->has_edge[slot] = 0.0f;
    }
    state->next_q = 0.0f;
    state->next_dq = 0.0f;
    state->next_ddq = 0.0f;
    state->known = 0U;
    state->since = 0U;
    for (uint32_t slot = 0U; slot < 51U; ++slot) {
        state->age_edge[slot] = 0.0f;
    }
}

void edge_times_step(edge_times_state *state, const edge_times_measurements *measurements,
                     edge_times_estimate *estimate)
{
    edge_times_work work;
    edge_times_part_1(state, measurements, &work);
    edge_times_part_2(state, &work);
    edge_times_part_4(state, &work);
    edge_times_part_5(state, &work);
    edge_times_part_6(state, &work);

    estimate->q = work.t265;
    estimate->dq = work.t266;
    estimate->ddq = work.t267;
    estimate->coasted = work.t34;
    estimate->status = work.t275;
}
