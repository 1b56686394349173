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
    float t73;
    float t81;
    float t83;
    float t85;
    float t87;
    float t89;
    float t91;
    float t93;
    float t95;
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
    float t110;
    float t111;
    uint32_t t112;
    uint32_t t113;
    float t119;
    float t121;
    float t130;
    float t157;
    float t167;
    float t169;
    float t171;
    float t173;
    float t175;
    float t177;
    float t179;
    float t181;
    float t183;
    float t184;
    float t250;
    float t255;
    float t258;
    float t260;
    float t262;
    float t264;
    float t335;
    float t336;
    float t337;
    edge_times_status t345;
    int flags[2]; /* t47, t243 */
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
    work->t73 = 0.0f + t72;
    const float t74 = 0.0f + t56;
    const float t75 = t74 + t57;
    const float t76 = 0.0f - t75;
    const float t77 = t72 * t59;
    const float t78 = t72 * t64;
    const float t79 = t72 * t71;
    const float t80 = t77 * t77;
    work->t81 = 0.0f + t80;
    const float t82 = t77 * t78;
    work->t83 = 0.0f + t82;
    const float t84 = t77 * t79;
    work->t85 = 0.0f + t84;
    const float t86 = t78 * t78;
    work->t87 = 0.0f + t86;
    const float t88 = t78 * t79;
    work->t89 = 0.0f + t88;
    const float t90 = t79 * t79;
    work->t91 = 0.0f + t90;
    const float t92 = t77 * t76;
    work->t93 = 0.0f + t92;
    const float t94 = t78 * t76;
    work->t95 = 0.0f + t94;
    const float t96 = t79 * t76;
    work->t97 = 0.0f + t96;
}

/* Part 3 of a step, for one row of EDGE_TIMES_ROWS. */
static void edge_times_part_3(const edge_times_state *state, edge_times_work *work, const float *gains)
{
    work->t113 = (work->t112 < 50U) ? (work->t112 + 1U) : 0U;
    const float t115 = 0.001f * work->t108;
    const float t117 = 5e-7f * work->t109;
    const float t118 = work->t107 + t115;
    work->t119 = t118 + t117;
    const float t120 = 0.001f * work->t109;
    work->t121 = work->t108 + t120;
    const float t122 = state->edge[work->t112];
    const float t123 = state->edge[work->t113];
    const float t124 = t123 - t122;
    const float t125 = t124 * 0.15915494f;
    const float t126 = t125 + 1.2582912e7f;
    const float t127 = t126 - 1.2582912e7f;
    const float t128 = t127 * 6.2831855f;
    const float t129 = t124 - t128;
    work->t130 = work->t110 + t129;
    const float t131 = state->age_edge[work->t113];
    const float t132 = -0.01f * t131;
    const float t133 = 5e-5f * t131;
    const float t134 = t133 * t131;
    const float t135 = gains[0];
    const float t136 = gains[3];
    const float t137 = t132 * t136;
    const float t138 = gains[6];
    const float t139 = t134 * t138;
    const float t140 = t135 + t137;
    const float t141 = t140 + t139;
    const float t142 = gains[1];
    const float t143 = gains[4];
    const float t144 = t132 * t143;
    const float t145 = gains[7];
    const float t146 = t134 * t145;
    const float t147 = t142 + t144;
    const float t148 = t147 + t146;
    const float t149 = gains[2];
    const float t150 = gains[5];
    const float t151 = t132 * t150;
    const float t152 = gains[8];
    const float t153 = t134 * t152;
    const float t154 = t149 + t151;
    const float t155 = t154 + t153;
    const float t156 = state->has_edge[work->t113];
    work->t157 = work->t111 + t156;
    const float t158 = t132 * work->t121;
    const float t159 = t134 * work->t109;
    const float t160 = work->t119 + t158;
    const float t161 = t160 + t159;
    const float t162 = work->t130 - t161;
    const float t163 = t156 * t141;
    const float t164 = t156 * t148;
    const float t165 = t156 * t155;
    const float t166 = t163 * t163;
    work->t167 = work->t98 + t166;
    const float t168 = t163 * t164;
    work->t169 = work->t99 + t168;
    const float t170 = t163 * t165;
    work->t171 = work->t100 + t170;
    const float t172 = t164 * t164;
    work->t173 = work->t101 + t172;
    const float t174 = t164 * t165;
    work->t175 = work->t102 + t174;
    const float t176 = t165 * t165;
    work->t177 = work->t103 + t176;
    const float t178 = t163 * t162;
    work->t179 = work->t104 + t178;
    const float t180 = t164 * t162;
    work->t181 = work->t105 + t180;
    const float t182 = t165 * t162;
    work->t183 = work->t106 + t182;
    work->t184 = work->t109 - 0.0f;
}

/* Part 4 of a step. */
static void edge_times_part_4(const edge_times_state *state, edge_times_work *work)
{
    work->t98 = work->t81;
    work->t99 = work->t83;
    work->t100 = work->t85;
    work->t101 = work->t87;
    work->t102 = work->t89;
    work->t103 = work->t91;
    work->t104 = work->t93;
    work->t105 = work->t95;
    work->t106 = work->t97;
    work->t107 = 0.0f;
    work->t108 = 0.0f;
    work->t109 = 0.0f;
    work->t110 = 0.0f;
    work->t111 = work->t73;
    work->t112 = work->t48;
    for (uint32_t row = 0U; row < 50U; ++row) {
        const float *const gains = EDGE_TIMES_ROWS[row];
        edge_times_part_3(state, work, gains);
        work->t98 = work->t167;
        work->t99 = work->t169;
        work->t100 = work->t171;
        work->t101 = work->t173;
        work->t102 = work->t175;
        work->t103 = work->t177;
        work->t104 = work->t179;
        work->t105 = work->t181;
        work->t106 = work->t183;
        work->t107 = work->t119;
        work->t108 = work->t121;
        work->t109 = work->t184;
        work->t110 = work->t130;
        work->t111 = work->t157;
        work->t112 = work->t113;
    }
}

/* Part 5 of a step. */
static void edge_times_part_5(edge_times_work *work)
{
    /* the state from the samples that are there, and its variance */
    const float t193 = 0.0001f * work->t98;
    const float t194 = t193 + 9.8607613e-32f;
    const float t195 = 0.0001f * work->t101;
    const float t196 = t195 + 9.8607613e-32f;
    const float t197 = 0.0001f * work->t103;
    const float t198 = t197 + 9.8607613e-32f;
    const int t199 = t194 < work->t98;
    const float t200 = t199 ? work->t98 : 1.0f;
    const float t201 = work->t99 / t200;
    const float t202 = work->t100 / t200;
    const float t203 = t201 * work->t99;
    const float t204 = work->t101 - t203;
    const float t205 = t201 * work->t100;
    const float t206 = work->t102 - t205;
    const float t207 = t201 * work->t104;
    const float t208 = work->t105 - t207;
    const float t209 = t202 * work->t100;
    const float t210 = work->t103 - t209;
    const float t211 = t202 * work->t104;
    const float t212 = work->t106 - t211;
    const float t213 = work->t104 / t200;
    const float t214 = t201 * 0.017503502f;
    const float t215 = 0.029728219f - t214;
    const float t216 = t202 * 0.017503502f;
    const float t217 = 0.036902294f - t216;
    const float t218 = 0.017503502f * t213;
    const float t219 = 0.017503502f / t200;
    const float t220 = 0.017503502f * t219;
    const int t221 = t196 < t204;
    const int t222 = t199 && t221;
    const float t223 = t221 ? t204 : 1.0f;
    const float t224 = t206 / t223;
    const float t225 = t224 * t206;
    const float t226 = t210 - t225;
    const float t227 = t224 * t208;
    const float t228 = t212 - t227;
    const float t229 = t208 / t223;
    const float t230 = t224 * t215;
    const float t231 = t217 - t230;
    const float t232 = t215 * t229;
    const float t233 = t218 + t232;
    const float t234 = t215 / t223;
    const float t235 = t215 * t234;
    const float t236 = t220 + t235;
    const float t237 = t224 * 0.018580137f;
    const float t238 = 0.07060388f - t237;
    const float t239 = 0.018580137f * t229;
    const float t240 = 0.018580137f / t223;
    const float t241 = 0.018580137f * t240;
    const int t242 = t198 < t226;
    work->flags[1] = t222 && t242;
    const float t244 = t242 ? t226 : 1.0f;
    const float t245 = t228 / t244;
    const float t246 = t231 * t245;
    const float t247 = t233 + t246;
    const float t248 = t231 / t244;
    const float t249 = t231 * t248;
    work->t250 = t236 + t249;
    const float t251 = t238 * t245;
    const float t252 = t239 + t251;
    const float t253 = t238 / t244;
    const float t254 = t238 * t253;
    work->t255 = t241 + t254;
    const float t256 = 0.08825485f * t245;
    const float t257 = 0.08825485f / t244;
    work->t258 = 0.08825485f * t257;
    work->t260 = 8.0f * t247;
    work->t262 = 512.0f * t252;
    work->t264 = 16384.0f * t256;
}

/* Part 6 of a step. */
static void edge_times_part_6(edge_times_state *state, edge_times_work *work)
{
    /* what it is worth */
    const float t266 = work->t250 * 0.5347033f;
    const int t267 = 0.0f < t266;
    const float t268 = t267 ? t266 : 0.0f;
    const float t270 = work->t255 * 0.37771508f;
    const int t271 = t268 < t270;
    const float t272 = t271 ? t270 : t268;
    const float t274 = work->t258 * 0.35502648f;
    const int t275 = t272 < t274;
    const float t276 = t275 ? t274 : t272;
    const int t279 = t276 <= 517593.7f;
    const int t280 = work->flags[1] && t279;
    const int t281 = t276 <= 0.5175937f;
    const int t282 = t280 && t281;
    const float t283 = work->t111 + 0.0f;
    const float t284 = t276 * t283;
    const int t285 = t284 <= 1.0f;
    const int t286 = t282 && t285;
    const int t287 = 0.0f < work->t111;
    const float t288 = work->t260 + work->t107;
    const float t289 = work->t262 + work->t108;
    const float t290 = work->t264 + work->t109;
    const float t291 = state->edge[work->t25];
    const float t292 = t291 - work->t110;
    const float t293 = t288 + t292;

    /* without enough samples, the model's prediction */
    const uint32_t t294 = state->known;
    const int t295 = t294 == 1U;
    const float t297 = work->t32 * -6.2831855f;
    const float t298 = work->t26 + t297;
    const int t299 = (-1e27f <= t298) && (t298 <= 1e27f);
    const int t300 = t295 && t299;
    const int t301 = (-1e27f <= work->t27) && (work->t27 <= 1e27f);
    const int t302 = t300 && t301;
    const int t303 = (-1e27f <= work->t28) && (work->t28 <= 1e27f);
    const int t304 = t302 && t303;
    const uint32_t t305 = state->poor;
    const uint32_t t306 = (t305 < 153U) ? (t305 + 1U) : 153U;
    const uint32_t t307 = t287 ? t306 : t305;
    const uint32_t t308 = t282 ? 0U : t307;
    state->poor = t308;
    const int t310 = t308 < 153U;
    const int t311 = t310 && t304;
    const int t312 = !t311;
    const int t313 = t282 || t312;
    const int t314 = t280 && t313;
    const float t315 = t314 ? t293 : t298;
    const float t316 = t314 ? t289 : work->t27;
    const float t317 = t314 ? t290 : work->t28;
    const int t318 = t314 || t304;
    const int t319 = work->flags[0] && t318;
    const uint32_t t320 = t319 ? 1U : 0U;
    state->known = t320;
    const float t322 = 0.001f * t316;
    const float t324 = 5e-7f * t317;
    const float t325 = t315 + t322;
    const float t326 = t325 + t324;
    const int t327 = (-1e27f <= t326) && (t326 <= 1e27f);
    const float t328 = t327 ? t326 : 0.0f;
    state->next_q = t328;
    const float t329 = 0.001f * t317;
    const float t330 = t316 + t329;
    const int t331 = (-1e27f <= t330) && (t330 <= 1e27f);
    const float t332 = t331 ? t330 : 0.0f;
    state->next_dq = t332;
    const int t333 = (-1e27f <= t317) && (t317 <= 1e27f);
    const float t334 = t333 ? t317 : 0.0f;
    state->next_ddq = t334;

    /* the estimate; until there is one, the start */
    work->t335 = t319 ? t315 : work->t35;
    work->t336 = t319 ? t316 : 0.0f;
    work->t337 = t319 ? t317 : 0.0f;
    const uint32_t t338 = state->coasting;
    const int t339 = t338 == 0U;
    const int t340 = t286 && t339;
    const edge_times_status t344 = t340 ? EDGE_TIMES_CONVERGED : EDGE_TIMES_COASTING;
    work->t345 = t319 ? t344 : EDGE_TIMES_CONVERGING;
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
    state->poor = 153U;
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
    edge_times_part_5(&work);
    edge_times_part_6(state, &work);

    estimate->q = work.t335;
    estimate->dq = work.t336;
    estimate->ddq = work.t337;
    estimate->coasted = work.t39;
    estimate->status = work.t345;
}
