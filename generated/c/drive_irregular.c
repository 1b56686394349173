/* drive_irregular.c: Finite-time observer: Speed and current of a motor whose position arrives over a bus, at irregular times.
 *
 * Generated; drive_irregular.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "drive_irregular.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "drive_irregular.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "drive_irregular.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* orthonormal rows of the window, oldest first
 *   [0] y in direction 1
 *   [1] y in direction 2
 *   [2] y in direction 3
 */
static const float DRIVE_IRREGULAR_ROWS[100][3] = {
    { 0.09950372f, -0.17719738f, 0.43499765f },
    { 0.09950372f, -0.17315935f, 0.3318832f },
    { 0.09950372f, -0.16912894f, 0.24769339f },
    { 0.09950372f, -0.16510752f, 0.17903918f },
    { 0.09950372f, -0.16109616f, 0.123138115f },
    { 0.09950372f, -0.15709575f, 0.077705786f },
    { 0.09950372f, -0.15310697f, 0.04086666f },
    { 0.09950372f, -0.14913042f, 0.011080927f },
    { 0.09950372f, -0.14516656f, -0.012915624f },
    { 0.09950372f, -0.14121576f, -0.032160915f },
    { 0.09950372f, -0.1372783f, -0.04750709f },
    { 0.09950372f, -0.13335443f, -0.05965375f },
    { 0.09950372f, -0.1294443f, -0.06917529f },
    { 0.09950372f, -0.12554806f, -0.076543264f },
    { 0.09950372f, -0.12166584f, -0.08214484f },
    { 0.09950372f, -0.11779768f, -0.08629788f },
    { 0.09950372f, -0.113943644f, -0.08926332f },
    { 0.09950372f, -0.11010376f, -0.09125541f },
    { 0.09950372f, -0.10627806f, -0.09245004f },
    { 0.09950372f, -0.10246653f, -0.09299161f },
    { 0.09950372f, -0.09866918f, -0.09299867f },
    { 0.09950372f, -0.094885975f, -0.09256854f },
    { 0.09950372f, -0.09111691f, -0.09178112f },
    { 0.09950372f, -0.08736196f, -0.090702f },
    { 0.09950372f, -0.08362109f, -0.08938502f },
    { 0.09950372f, -0.07989425f, -0.08787438f },
    { 0.09950372f, -0.07618143f, -0.08620637f },
    { 0.09950372f, -0.07248256f, -0.08441077f },
    { 0.09950372f, -0.06879761f, -0.082512036f },
    { 0.09950372f, -0.065126546f, -0.08053021f },
    { 0.09950372f, -0.0614693f, -0.07848178f },
    { 0.09950372f, -0.057825845f, -0.076380245f },
    { 0.09950372f, -0.05419612f, -0.0742367f },
    { 0.09950372f, -0.050580084f, -0.07206024f },
    { 0.09950372f, -0.046977688f, -0.06985834f },
    { 0.09950372f, -0.04338888f, -0.06763711f },
    { 0.09950372f, -0.03981361f, -0.06540157f },
    { 0.09950372f, -0.036251836f, -0.063155845f },
    { 0.09950372f, -0.0327035f, -0.0609033f },
    { 0.09950372f, -0.029168554f, -0.058646698f },
    { 0.09950372f, -0.025646951f, -0.056388307f },
    { 0.09950372f, -0.022138642f, -0.05412998f },
    { 0.09950372f, -0.018643575f, -0.051873226f },
    { 0.09950372f, -0.0151617f, -0.049619287f },
    { 0.09950372f, -0.011692969f, -0.047369175f },
    { 0.09950372f, -0.008237334f, -0.04512371f },
    { 0.09950372f, -0.0047947434f, -0.042883568f },
    { 0.09950372f, -0.0013651493f, -0.040649287f },
    { 0.09950372f, 0.0020514973f, -0.038421314f },
    { 0.09950372f, 0.0054552453f, -0.036200006f },
    { 0.09950372f, 0.008846142f, -0.03398565f },
    { 0.09950372f, 0.012224238f, -0.031778473f },
    { 0.09950372f, 0.015589581f, -0.029578667f },
    { 0.09950372f, 0.018942216f, -0.02738637f },
    { 0.09950372f, 0.022282196f, -0.025201699f },
    { 0.09950372f, 0.025609566f, -0.02302474f },
    { 0.09950372f, 0.028924374f, -0.02085556f },
    { 0.09950372f, 0.032226667f, -0.018694209f },
    { 0.09950372f, 0.03551649f, -0.016540723f },
    { 0.09950372f, 0.038793895f, -0.014395124f },
    { 0.09950372f, 0.042058926f, -0.012257426f },
    { 0.09950372f, 0.045311626f, -0.010127635f },
    { 0.09950372f, 0.04855205f, -0.00800575f },
    { 0.09950372f, 0.05178024f, -0.0058917664f },
    { 0.09950372f, 0.05499624f, -0.0037856728f },
    { 0.09950372f, 0.0582001f, -0.0016874565f },
    { 0.09950372f, 0.06139186f, 0.0004028993f },
    { 0.09950372f, 0.064571574f, 0.002485413f },
    { 0.09950372f, 0.067739286f, 0.004560106f },
    { 0.09950372f, 0.07089503f, 0.0066269995f },
    { 0.09950372f, 0.07403886f, 0.008686117f },
    { 0.09950372f, 0.07717083f, 0.010737483f },
    { 0.09950372f, 0.080290966f, 0.012781124f },
    { 0.09950372f, 0.083399326f, 0.014817064f },
    { 0.09950372f, 0.08649595f, 0.016845329f },
    { 0.09950372f, 0.08958088f, 0.018865949f },
    { 0.09950372f, 0.09265417f, 0.020878946f },
    { 0.09950372f, 0.09571585f, 0.022884352f },
    { 0.09950372f, 0.09876597f, 0.02488219f },
    { 0.09950372f, 0.10180458f, 0.026872491f },
    { 0.09950372f, 0.10483171f, 0.028855283f },
    { 0.09950372f, 0.10784742f, 0.030830592f },
    { 0.09950372f, 0.11085174f, 0.032798443f },
    { 0.09950372f, 0.113844715f, 0.03475887f },
    { 0.09950372f, 0.11682639f, 0.036711894f },
    { 0.09950372f, 0.11979681f, 0.03865755f },
    { 0.09950372f, 0.12275602f, 0.04059586f },
    { 0.09950372f, 0.12570405f, 0.04252685f },
    { 0.09950372f, 0.12864096f, 0.04445055f },
    { 0.09950372f, 0.13156678f, 0.046366993f },
    { 0.09950372f, 0.13448153f, 0.048276197f },
    { 0.09950372f, 0.13738531f, 0.050178196f },
    { 0.09950372f, 0.1402781f, 0.052073013f },
    { 0.09950372f, 0.14315999f, 0.053960674f },
    { 0.09950372f, 0.14603098f, 0.05584121f },
    { 0.09950372f, 0.14889114f, 0.05771465f },
    { 0.09950372f, 0.1517405f, 0.05958101f },
    { 0.09950372f, 0.1545791f, 0.06144033f },
    { 0.09950372f, 0.15740699f, 0.06329263f },
    { 0.09950372f, 0.1602242f, 0.06513793f }
};

/* What one part of a step hands to the next. */
typedef struct {
    float t7;
    uint32_t t8;
    float t12;
    uint32_t t26;
    float t37;
    float t39;
    float t41;
    float t43;
    float t45;
    float t47;
    float t49;
    float t51;
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
    float t163;
    float t169;
    float t175;
    float t224;
    float t225;
    float t226;
    drive_irregular_status t234;
    int flags[2]; /* t25, t145 */
} drive_irregular_work;

/* Part 1 of a step. */
static void drive_irregular_part_1(drive_irregular_state *state, const drive_irregular_measurements *measurements, const drive_irregular_inputs *inputs, drive_irregular_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    const uint32_t t0 = state->newest;
    const uint32_t t1 = (t0 < 100U) ? t0 : 100U;
    const float t2 = measurements->y;
    const int t3 = (-1e21f <= t2) && (t2 <= 1e21f);
    const float t4 = inputs->u;
    const int t5 = (-1e21f <= t4) && (t4 <= 1e21f);
    const float t6 = state->u[t1];
    work->t7 = t5 ? t4 : t6;
    work->t8 = (t1 < 100U) ? (t1 + 1U) : 0U;
    const float t11 = state->y[t1];
    work->t12 = t3 ? t2 : t11;
    const float t13 = t3 ? 1.0f : 0.0f;

    /* how much of the window is good */
    const uint32_t t14 = state->count;
    const int t16 = 100U < t14;
    const uint32_t t19 = (t14 < 101U) ? (t14 + 1U) : 101U;
    const uint32_t t20 = t5 ? t19 : 1U;
    const uint32_t t21 = t16 ? t19 : t20;
    state->count = t21;
    const uint32_t t22 = state->coasting;
    const uint32_t t23 = (t22 > 0U) ? (t22 - 1U) : 0U;
    const uint32_t t24 = t5 ? t23 : 100U;
    state->coasting = t24;

    /* into the window */
    state->newest = work->t8;
    state->y[work->t8] = work->t12;
    state->has_y[work->t8] = t13;
    state->u[work->t8] = work->t7;
    work->flags[0] = 100U < t21;
}

/* Part 2 of a step. */
static void drive_irregular_part_2(const drive_irregular_state *state, drive_irregular_work *work)
{
    /* rows of the window, oldest first; those without a sample count nothing */
    work->t26 = (work->t8 < 100U) ? (work->t8 + 1U) : 0U;
    const float t30 = state->has_y[work->t26];
    const float t31 = state->y[work->t26];
    const float t32 = t31 - 0.0f;
    const float t33 = t30 * 0.09950372f;
    const float t34 = t30 * -0.18124144f;
    const float t35 = t30 * 0.5611647f;
    const float t36 = t33 * t33;
    work->t37 = 0.0f + t36;
    const float t38 = t33 * t34;
    work->t39 = 0.0f + t38;
    const float t40 = t33 * t35;
    work->t41 = 0.0f + t40;
    const float t42 = t34 * t34;
    work->t43 = 0.0f + t42;
    const float t44 = t34 * t35;
    work->t45 = 0.0f + t44;
    const float t46 = t35 * t35;
    work->t47 = 0.0f + t46;
    const float t48 = t33 * t32;
    work->t49 = 0.0f + t48;
    const float t50 = t34 * t32;
    work->t51 = 0.0f + t50;
    const float t52 = t35 * t32;
    work->t53 = 0.0f + t52;
}

/* Part 3 of a step. */
static void drive_irregular_part_3(const drive_irregular_state *state, drive_irregular_work *work)
{
    work->t54 = work->t37;
    work->t55 = work->t39;
    work->t56 = work->t41;
    work->t57 = work->t43;
    work->t58 = work->t45;
    work->t59 = work->t47;
    work->t60 = work->t49;
    work->t61 = work->t51;
    work->t62 = work->t53;
    work->t63 = 0.0f;
    work->t64 = 0.0f;
    work->t65 = 0.0f;
    uint32_t t66 = work->t26;
    for (uint32_t row = 0U; row < 100U; ++row) {
        const float *const gains = DRIVE_IRREGULAR_ROWS[row];
        const uint32_t t67 = (t66 < 100U) ? (t66 + 1U) : 0U;
        const float t68 = state->u[t67];
        const float t70 = 0.0009994135f * work->t64;
        const float t72 = 7.021338e-6f * work->t65;
        const float t73 = work->t63 + t70;
        const float t74 = t73 + t72;
        const float t76 = 9.516694e-8f * t68;
        const float t77 = t74 + t76;
        const float t79 = 0.998745f * work->t64;
        const float t81 = 0.0135869365f * work->t65;
        const float t82 = t79 + t81;
        const float t84 = 0.00028085354f * t68;
        const float t85 = t82 + t84;
        const float t87 = -0.032970965f * work->t64;
        const float t89 = 0.81849164f * work->t65;
        const float t90 = t87 + t89;
        const float t92 = 0.036250554f * t68;
        const float t93 = t90 + t92;
        const float t94 = gains[0];
        const float t95 = gains[1];
        const float t96 = gains[2];
        const float t97 = state->has_y[t67];
        const float t98 = state->y[t67];
        const float t99 = t98 - t77;
        const float t100 = t97 * t94;
        const float t101 = t97 * t95;
        const float t102 = t97 * t96;
        const float t103 = t100 * t100;
        const float t104 = work->t54 + t103;
        const float t105 = t100 * t101;
        const float t106 = work->t55 + t105;
        const float t107 = t100 * t102;
        const float t108 = work->t56 + t107;
        const float t109 = t101 * t101;
        const float t110 = work->t57 + t109;
        const float t111 = t101 * t102;
        const float t112 = work->t58 + t111;
        const float t113 = t102 * t102;
        const float t114 = work->t59 + t113;
        const float t115 = t100 * t99;
        const float t116 = work->t60 + t115;
        const float t117 = t101 * t99;
        const float t118 = work->t61 + t117;
        const float t119 = t102 * t99;
        const float t120 = work->t62 + t119;
        work->t54 = t104;
        work->t55 = t106;
        work->t56 = t108;
        work->t57 = t110;
        work->t58 = t112;
        work->t59 = t114;
        work->t60 = t116;
        work->t61 = t118;
        work->t62 = t120;
        work->t63 = t77;
        work->t64 = t85;
        work->t65 = t93;
        t66 = t67;
    }
}

/* Part 4 of a step. */
static void drive_irregular_part_4(drive_irregular_work *work)
{
    /* the window's start from the samples that are there */
    const int t122 = 0.000127305f < work->t54;
    const float t123 = t122 ? work->t54 : 1.0f;
    const float t124 = work->t55 / t123;
    const float t125 = t124 * work->t55;
    const float t126 = work->t57 - t125;
    const float t127 = t124 * work->t56;
    const float t128 = work->t58 - t127;
    const float t129 = t124 * work->t60;
    const float t130 = work->t61 - t129;
    const float t131 = work->t56 / t123;
    const float t132 = t131 * work->t56;
    const float t133 = work->t59 - t132;
    const float t134 = t131 * work->t60;
    const float t135 = work->t62 - t134;
    const int t136 = 0.000127305f < t126;
    const int t137 = t122 && t136;
    const float t138 = t136 ? t126 : 1.0f;
    const float t139 = t128 / t138;
    const float t140 = t139 * t128;
    const float t141 = t133 - t140;
    const float t142 = t139 * t130;
    const float t143 = t135 - t142;
    const int t144 = 0.000127305f < t141;
    work->flags[1] = t137 && t144;
    const float t146 = t144 ? t141 : 1.0f;
    const float t147 = t143 / t146;
    const float t148 = t128 * t147;
    const float t149 = t130 - t148;
    const float t150 = t149 / t138;
    const float t151 = work->t55 * t150;
    const float t152 = work->t60 - t151;
    const float t153 = work->t56 * t147;
    const float t154 = t152 - t153;
    const float t155 = t154 / t123;
    const float t156 = 0.09950372f * t155;
    const float t158 = 0.1602242f * t150;
    const float t160 = 0.06513793f * t147;
    const float t161 = t156 + t158;
    const float t162 = t161 + t160;
    work->t163 = t162 + work->t63;
    const float t165 = 2.8118842f * t150;
    const float t167 = 1.8418168f * t147;
    const float t168 = t165 + t167;
    work->t169 = t168 + work->t64;
    const float t171 = -0.52162856f * t150;
    const float t173 = -0.34166777f * t147;
    const float t174 = t171 + t173;
    work->t175 = t174 + work->t65;
}

/* Part 5 of a step. */
static void drive_irregular_part_5(drive_irregular_state *state, drive_irregular_work *work)
{
    /* without enough samples, the model's prediction */
    const uint32_t t176 = state->known;
    const int t177 = t176 == 1U;
    const float t178 = state->next_q;
    const float t180 = 9.516694e-8f * work->t7;
    const float t181 = t178 + t180;
    const int t182 = (-1e21f <= t181) && (t181 <= 1e21f);
    const int t183 = t177 && t182;
    const float t184 = work->flags[1] ? work->t163 : t181;
    const float t185 = state->next_dq;
    const float t187 = 0.00028085354f * work->t7;
    const float t188 = t185 + t187;
    const int t189 = (-1e21f <= t188) && (t188 <= 1e21f);
    const int t190 = t183 && t189;
    const float t191 = work->flags[1] ? work->t169 : t188;
    const float t192 = state->next_i;
    const float t194 = 0.036250554f * work->t7;
    const float t195 = t192 + t194;
    const int t196 = (-1e21f <= t195) && (t195 <= 1e21f);
    const int t197 = t190 && t196;
    const float t198 = work->flags[1] ? work->t175 : t195;
    const int t199 = work->flags[1] || t197;
    const int t200 = work->flags[0] && t199;
    const uint32_t t201 = t200 ? 1U : 0U;
    state->known = t201;
    const float t203 = 0.0009994135f * t191;
    const float t205 = 7.021338e-6f * t198;
    const float t206 = t184 + t203;
    const float t207 = t206 + t205;
    const int t208 = (-1e21f <= t207) && (t207 <= 1e21f);
    const float t209 = t208 ? t207 : 0.0f;
    state->next_q = t209;
    const float t211 = 0.998745f * t191;
    const float t213 = 0.0135869365f * t198;
    const float t214 = t211 + t213;
    const int t215 = (-1e21f <= t214) && (t214 <= 1e21f);
    const float t216 = t215 ? t214 : 0.0f;
    state->next_dq = t216;
    const float t218 = -0.032970965f * t191;
    const float t220 = 0.81849164f * t198;
    const float t221 = t218 + t220;
    const int t222 = (-1e21f <= t221) && (t221 <= 1e21f);
    const float t223 = t222 ? t221 : 0.0f;
    state->next_i = t223;

    /* the estimate; until there is one, the start */
    work->t224 = t200 ? t184 : work->t12;
    work->t225 = t200 ? t191 : 0.0f;
    work->t226 = t200 ? t198 : 0.0f;
    const uint32_t t227 = state->coasting;
    const int t228 = t227 == 0U;
    const int t229 = work->flags[1] && t228;
    const drive_irregular_status t233 = t229 ? DRIVE_IRREGULAR_CONVERGED : DRIVE_IRREGULAR_COASTING;
    work->t234 = t200 ? t233 : DRIVE_IRREGULAR_CONVERGING;
}

void drive_irregular_init(drive_irregular_state *state)
{
    for (uint32_t slot = 0U; slot < 101U; ++slot) {
        state->y[slot] = 0.0f;
    }
    for (uint32_t slot = 0U; slot < 101U; ++slot) {
        state->u[slot] = 0.0f;
    }
    state->newest = 100U;
    state->count = 0U;
    state->coasting = 0U;
    for (uint32_t slot = 0U; slot < 101U; ++slot) {
        state->has_y[slot] = 0.0f;
    }
    state->next_q = 0.0f;
    state->next_dq = 0.0f;
    state->next_i = 0.0f;
    state->known = 0U;
}

void drive_irregular_step(drive_irregular_state *state, const drive_irregular_measurements *measurements,
                          const drive_irregular_inputs *inputs, drive_irregular_estimate *estimate)
{
    drive_irregular_work work;
    drive_irregular_part_1(state, measurements, inputs, &work);
    drive_irregular_part_2(state, &work);
    drive_irregular_part_3(state, &work);
    drive_irregular_part_4(&work);
    drive_irregular_part_5(state, &work);

    estimate->q = work.t224;
    estimate->dq = work.t225;
    estimate->i = work.t226;
    estimate->status = work.t234;
}
