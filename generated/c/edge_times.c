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
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
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
    uint32_t t25;
    float t26;
    float t27;
    float t28;
    float t32;
    float t35;
    uint32_t t39;
    uint32_t t48;
    float t80;
    float t82;
    float t84;
    float t86;
    float t88;
    float t90;
    float t92;
    float t94;
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
    float t108;
    float t109;
    uint32_t t110;
    uint32_t t111;
    float t117;
    float t119;
    float t128;
    float t164;
    float t166;
    float t168;
    float t170;
    float t172;
    float t174;
    float t176;
    float t178;
    float t180;
    float t181;
    float t228;
    float t230;
    float t233;
    float t265;
    float t266;
    float t267;
    edge_times_status t275;
    int flags[2]; /* t47, t206 */
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
    const float t18 = measurements->edge_age;
    const int t19 = (0.0f <= t18) && (t18 <= 0.01f);
    const int t20 = t3 && t19;
    const float t22 = t18 * 100.0f;
    const float t24 = t20 ? t22 : 0.0f;
    work->t25 = (t1 < 50U) ? (t1 + 1U) : 0U;
    work->t26 = state->next_q;
    work->t27 = state->next_dq;
    work->t28 = state->next_ddq;
    const float t30 = work->t26 * 0.15915494f;
    const float t31 = t30 + 1.2582912e7f;
    work->t32 = t31 - 1.2582912e7f;
    const float t34 = state->edge[t1];
    work->t35 = t20 ? t17 : t34;
    const uint32_t t37 = state->since;
    const uint32_t t38 = (t37 < 4294967295U) ? (t37 + 1U) : 4294967295U;
    work->t39 = t20 ? 0U : t38;
    state->since = work->t39;
    const float t40 = t20 ? 1.0f : 0.0f;
    const uint32_t t41 = state->count;

    /* how much of the window is good */
    const uint32_t t44 = (t41 < 51U) ? (t41 + 1U) : 51U;
    state->count = t44;
    const uint32_t t45 = state->coasting;
    const uint32_t t46 = (t45 > 0U) ? (t45 - 1U) : 0U;
    state->coasting = t46;

    /* into the window */
    state->newest = work->t25;
    state->edge[work->t25] = work->t35;
    state->has_edge[work->t25] = t40;
    state->age_edge[work->t25] = t24;
    work->flags[0] = 50U < t44;
}

/* Part 2 of a step. */
static void edge_times_part_2(const edge_times_state *state, edge_times_work *work)
{
    /* rows of the window, oldest first; those without a sample count nothing */
    work->t48 = (work->t25 < 50U) ? (work->t25 + 1U) : 0U;
    const float t49 = state->age_edge[work->t48];
    const float t51 = -0.01f * t49;
    const float t53 = 5e-5f * t49;
    const float t54 = t53 * t49;
    const float t56 = t51 * 0.0f;
    const float t57 = t54 * 0.0f;
    const float t58 = 0.14002801f + t56;
    const float t59 = t58 + t57;
    const float t62 = t51 * 9.51303f;
    const float t63 = -0.23782575f + t62;
    const float t64 = t63 + t57;
    const float t67 = t51 * -36.149185f;
    const float t69 = t54 * 1445.9674f;
    const float t70 = 0.29521835f + t67;
    const float t71 = t70 + t69;
    const float t72 = state->has_edge[work->t48];
    const float t73 = 0.0f + t56;
    const float t74 = t73 + t57;
    const float t75 = 0.0f - t74;
    const float t76 = t72 * t59;
    const float t77 = t72 * t64;
    const float t78 = t72 * t71;
    const float t79 = t76 * t76;
    work->t80 = 0.0f + t79;
    const float t81 = t76 * t77;
    work->t82 = 0.0f + t81;
    const float t83 = t76 * t78;
    work->t84 = 0.0f + t83;
    const float t85 = t77 * t77;
    work->t86 = 0.0f + t85;
    const float t87 = t77 * t78;
    work->t88 = 0.0f + t87;
    const float t89 = t78 * t78;
    work->t90 = 0.0f + t89;
    const float t91 = t76 * t75;
    work->t92 = 0.0f + t91;
    const float t93 = t77 * t75;
    work->t94 = 0.0f + t93;
    const float t95 = t78 * t75;
    work->t96 = 0.0f + t95;
}

/* Part 3 of a step, for one row of EDGE_TIMES_ROWS. */
static void edge_times_part_3(const edge_times_state *state, edge_times_work *work, const float *gains)
{
    work->t111 = (work->t110 < 50U) ? (work->t110 + 1U) : 0U;
    const float t113 = 0.001f * work->t107;
    const float t115 = 5e-7f * work->t108;
    const float t116 = work->t106 + t113;
    work->t117 = t116 + t115;
    const float t118 = 0.001f * work->t108;
    work->t119 = work->t107 + t118;
    const float t120 = state->edge[work->t110];
    const float t121 = state->edge[work->t111];
    const float t122 = t121 - t120;
    const float t123 = t122 * 0.15915494f;
    const float t124 = t123 + 1.2582912e7f;
    const float t125 = t124 - 1.2582912e7f;
    const float t126 = t125 * 6.2831855f;
    const float t127 = t122 - t126;
    work->t128 = work->t109 + t127;
    const float t129 = state->age_edge[work->t111];
    const float t130 = -0.01f * t129;
    const float t131 = 5e-5f * t129;
    const float t132 = t131 * t129;
    const float t133 = gains[0];
    const float t134 = gains[3];
    const float t135 = t130 * t134;
    const float t136 = gains[6];
    const float t137 = t132 * t136;
    const float t138 = t133 + t135;
    const float t139 = t138 + t137;
    const float t140 = gains[1];
    const float t141 = gains[4];
    const float t142 = t130 * t141;
    const float t143 = gains[7];
    const float t144 = t132 * t143;
    const float t145 = t140 + t142;
    const float t146 = t145 + t144;
    const float t147 = gains[2];
    const float t148 = gains[5];
    const float t149 = t130 * t148;
    const float t150 = gains[8];
    const float t151 = t132 * t150;
    const float t152 = t147 + t149;
    const float t153 = t152 + t151;
    const float t154 = state->has_edge[work->t111];
    const float t155 = t130 * work->t119;
    const float t156 = t132 * work->t108;
    const float t157 = work->t117 + t155;
    const float t158 = t157 + t156;
    const float t159 = work->t128 - t158;
    const float t160 = t154 * t139;
    const float t161 = t154 * t146;
    const float t162 = t154 * t153;
    const float t163 = t160 * t160;
    work->t164 = work->t97 + t163;
    const float t165 = t160 * t161;
    work->t166 = work->t98 + t165;
    const float t167 = t160 * t162;
    work->t168 = work->t99 + t167;
    const float t169 = t161 * t161;
    work->t170 = work->t100 + t169;
    const float t171 = t161 * t162;
    work->t172 = work->t101 + t171;
    const float t173 = t162 * t162;
    work->t174 = work->t102 + t173;
    const float t175 = t160 * t159;
    work->t176 = work->t103 + t175;
    const float t177 = t161 * t159;
    work->t178 = work->t104 + t177;
    const float t179 = t162 * t159;
    work->t180 = work->t105 + t179;
    work->t181 = work->t108 - 0.0f;
}

/* Part 4 of a step. */
static void edge_times_part_4(const edge_times_state *state, edge_times_work *work)
{
    work->t97 = work->t80;
    work->t98 = work->t82;
    work->t99 = work->t84;
    work->t100 = work->t86;
    work->t101 = work->t88;
    work->t102 = work->t90;
    work->t103 = work->t92;
    work->t104 = work->t94;
    work->t105 = work->t96;
    work->t106 = 0.0f;
    work->t107 = 0.0f;
    work->t108 = 0.0f;
    work->t109 = 0.0f;
    work->t110 = work->t48;
    for (uint32_t row = 0U; row < 50U; ++row) {
        const float *const gains = EDGE_TIMES_ROWS[row];
        edge_times_part_3(state, work, gains);
        work->t97 = work->t164;
        work->t98 = work->t166;
        work->t99 = work->t168;
        work->t100 = work->t170;
        work->t101 = work->t172;
        work->t102 = work->t174;
        work->t103 = work->t176;
        work->t104 = work->t178;
        work->t105 = work->t180;
        work->t106 = work->t117;
        work->t107 = work->t119;
        work->t108 = work->t181;
        work->t109 = work->t128;
        work->t110 = work->t111;
    }
}

/* Part 5 of a step. */
static void edge_times_part_5(const edge_times_state *state, edge_times_work *work)
{
    /* the window's start from the samples that are there */
    const int t183 = 0.015625f < work->t97;
    const float t184 = t183 ? work->t97 : 1.0f;
    const float t185 = work->t98 / t184;
    const float t186 = t185 * work->t98;
    const float t187 = work->t100 - t186;
    const float t188 = t185 * work->t99;
    const float t189 = work->t101 - t188;
    const float t190 = t185 * work->t103;
    const float t191 = work->t104 - t190;
    const float t192 = work->t99 / t184;
    const float t193 = t192 * work->t99;
    const float t194 = work->t102 - t193;
    const float t195 = t192 * work->t103;
    const float t196 = work->t105 - t195;
    const int t197 = 0.015625f < t187;
    const int t198 = t183 && t197;
    const float t199 = t197 ? t187 : 1.0f;
    const float t200 = t189 / t199;
    const float t201 = t200 * t189;
    const float t202 = t194 - t201;
    const float t203 = t200 * t191;
    const float t204 = t196 - t203;
    const int t205 = 0.015625f < t202;
    work->flags[1] = t198 && t205;
    const float t207 = t205 ? t202 : 1.0f;
    const float t208 = t204 / t207;
    const float t209 = t189 * t208;
    const float t210 = t191 - t209;
    const float t211 = t210 / t199;
    const float t212 = work->t98 * t211;
    const float t213 = work->t103 - t212;
    const float t214 = work->t99 * t208;
    const float t215 = t213 - t214;
    const float t216 = t215 / t184;
    const float t217 = 0.14002801f * t216;
    const float t219 = 0.23782575f * t211;
    const float t220 = 0.29521835f * t208;
    const float t221 = t217 + t219;
    const float t222 = t221 + t220;
    const float t223 = t222 + work->t106;
    const float t224 = 9.51303f * t211;
    const float t226 = 36.149185f * t208;
    const float t227 = t224 + t226;
    work->t228 = t227 + work->t107;
    const float t229 = 1445.9674f * t208;
    work->t230 = t229 + work->t108;
    const float t231 = state->edge[work->t25];
    const float t232 = t231 - work->t109;
    work->t233 = t223 + t232;
}

/* Part 6 of a step. */
static void edge_times_part_6(edge_times_state *state, edge_times_work *work)
{
    /* without enough samples, the model's prediction */
    const uint32_t t234 = state->known;
    const int t235 = t234 == 1U;
    const float t237 = work->t32 * -6.2831855f;
    const float t238 = work->t26 + t237;
    const int t239 = (-1e24f <= t238) && (t238 <= 1e24f);
    const int t240 = t235 && t239;
    const float t241 = work->flags[1] ? work->t233 : t238;
    const int t242 = (-1e24f <= work->t27) && (work->t27 <= 1e24f);
    const int t243 = t240 && t242;
    const float t244 = work->flags[1] ? work->t228 : work->t27;
    const int t245 = (-1e24f <= work->t28) && (work->t28 <= 1e24f);
    const int t246 = t243 && t245;
    const float t247 = work->flags[1] ? work->t230 : work->t28;
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
    work->t265 = t249 ? t241 : work->t35;
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
    estimate->coasted = work.t39;
    estimate->status = work.t275;
}
