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
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
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
    uint32_t t8;
    float t12;
    float t16;
    float t20;
    float t23;
    uint32_t t46;
    float t57;
    float t59;
    float t61;
    float t63;
    float t65;
    float t67;
    float t69;
    float t71;
    float t73;
    float t74;
    float t75;
    float t76;
    float t77;
    float t78;
    float t79;
    float t80;
    float t81;
    float t82;
    float t83;
    float t84;
    float t85;
    float t180;
    float t186;
    float t192;
    float t229;
    float t230;
    float t231;
    drive_irregular_status t239;
    int flags[2]; /* t45, t162 */
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
    const float t7 = t5 ? t4 : t6;
    work->t8 = (t1 < 100U) ? (t1 + 1U) : 0U;
    const float t9 = state->next_q;
    const float t11 = 9.516694e-8f * t7;
    work->t12 = t9 + t11;
    const float t13 = state->next_dq;
    const float t15 = 0.00028085354f * t7;
    work->t16 = t13 + t15;
    const float t17 = state->next_i;
    const float t19 = 0.036250554f * t7;
    work->t20 = t17 + t19;
    const float t22 = state->y[t1];
    work->t23 = t3 ? t2 : t22;
    const float t25 = t3 ? 1.0f : 0.0f;
    const uint32_t t26 = state->count;
    const uint32_t t27 = state->since_y;
    const uint32_t t28 = (t27 < 10U) ? (t27 + 1U) : 10U;
    const uint32_t t30 = t3 ? 0U : t28;
    state->since_y = t30;
    const int t32 = t30 < 10U;
    const int t33 = t3 || t32;

    /* how much of the window is good */
    const int t35 = 100U < t26;
    const uint32_t t37 = (t26 < 101U) ? (t26 + 1U) : 101U;
    const uint32_t t38 = t5 ? t37 : 1U;
    const uint32_t t39 = t35 ? t37 : t38;
    state->count = t39;
    const uint32_t t40 = state->coasting;
    const uint32_t t41 = (t40 > 0U) ? (t40 - 1U) : 0U;
    const uint32_t t42 = t5 ? t41 : 100U;
    const uint32_t t44 = t33 ? t42 : 101U;
    state->coasting = t44;

    /* into the window */
    state->newest = work->t8;
    state->y[work->t8] = work->t23;
    state->has_y[work->t8] = t25;
    state->u[work->t8] = t7;
    work->flags[0] = 100U < t39;
}

/* Part 2 of a step. */
static void drive_irregular_part_2(const drive_irregular_state *state, drive_irregular_work *work)
{
    /* rows of the window, oldest first; those without a sample count nothing */
    work->t46 = (work->t8 < 100U) ? (work->t8 + 1U) : 0U;
    const float t50 = state->has_y[work->t46];
    const float t51 = state->y[work->t46];
    const float t52 = t51 - 0.0f;
    const float t53 = t50 * 0.09950372f;
    const float t54 = t50 * -0.18124144f;
    const float t55 = t50 * 0.5611647f;
    const float t56 = t53 * t53;
    work->t57 = 0.0f + t56;
    const float t58 = t53 * t54;
    work->t59 = 0.0f + t58;
    const float t60 = t53 * t55;
    work->t61 = 0.0f + t60;
    const float t62 = t54 * t54;
    work->t63 = 0.0f + t62;
    const float t64 = t54 * t55;
    work->t65 = 0.0f + t64;
    const float t66 = t55 * t55;
    work->t67 = 0.0f + t66;
    const float t68 = t53 * t52;
    work->t69 = 0.0f + t68;
    const float t70 = t54 * t52;
    work->t71 = 0.0f + t70;
    const float t72 = t55 * t52;
    work->t73 = 0.0f + t72;
}

/* Part 3 of a step. */
static void drive_irregular_part_3(const drive_irregular_state *state, drive_irregular_work *work)
{
    work->t74 = work->t57;
    work->t75 = work->t59;
    work->t76 = work->t61;
    work->t77 = work->t63;
    work->t78 = work->t65;
    work->t79 = work->t67;
    work->t80 = work->t69;
    work->t81 = work->t71;
    work->t82 = work->t73;
    work->t83 = 0.0f;
    work->t84 = 0.0f;
    work->t85 = 0.0f;
    uint32_t t86 = work->t46;
    for (uint32_t row = 0U; row < 100U; ++row) {
        const float *const gains = DRIVE_IRREGULAR_ROWS[row];
        const uint32_t t87 = (t86 < 100U) ? (t86 + 1U) : 0U;
        const float t88 = state->u[t87];
        const float t90 = 0.0009994135f * work->t84;
        const float t92 = 7.021338e-6f * work->t85;
        const float t93 = work->t83 + t90;
        const float t94 = t93 + t92;
        const float t95 = 9.516694e-8f * t88;
        const float t96 = t94 + t95;
        const float t98 = 0.998745f * work->t84;
        const float t100 = 0.0135869365f * work->t85;
        const float t101 = t98 + t100;
        const float t102 = 0.00028085354f * t88;
        const float t103 = t101 + t102;
        const float t105 = -0.032970965f * work->t84;
        const float t107 = 0.81849164f * work->t85;
        const float t108 = t105 + t107;
        const float t109 = 0.036250554f * t88;
        const float t110 = t108 + t109;
        const float t111 = gains[0];
        const float t112 = gains[1];
        const float t113 = gains[2];
        const float t114 = state->has_y[t87];
        const float t115 = state->y[t87];
        const float t116 = t115 - t96;
        const float t117 = t114 * t111;
        const float t118 = t114 * t112;
        const float t119 = t114 * t113;
        const float t120 = t117 * t117;
        const float t121 = work->t74 + t120;
        const float t122 = t117 * t118;
        const float t123 = work->t75 + t122;
        const float t124 = t117 * t119;
        const float t125 = work->t76 + t124;
        const float t126 = t118 * t118;
        const float t127 = work->t77 + t126;
        const float t128 = t118 * t119;
        const float t129 = work->t78 + t128;
        const float t130 = t119 * t119;
        const float t131 = work->t79 + t130;
        const float t132 = t117 * t116;
        const float t133 = work->t80 + t132;
        const float t134 = t118 * t116;
        const float t135 = work->t81 + t134;
        const float t136 = t119 * t116;
        const float t137 = work->t82 + t136;
        work->t74 = t121;
        work->t75 = t123;
        work->t76 = t125;
        work->t77 = t127;
        work->t78 = t129;
        work->t79 = t131;
        work->t80 = t133;
        work->t81 = t135;
        work->t82 = t137;
        work->t83 = t96;
        work->t84 = t103;
        work->t85 = t110;
        t86 = t87;
    }
}

/* Part 4 of a step. */
static void drive_irregular_part_4(drive_irregular_work *work)
{
    /* the window's start from the samples that are there */
    const int t139 = 0.000127305f < work->t74;
    const float t140 = t139 ? work->t74 : 1.0f;
    const float t141 = work->t75 / t140;
    const float t142 = t141 * work->t75;
    const float t143 = work->t77 - t142;
    const float t144 = t141 * work->t76;
    const float t145 = work->t78 - t144;
    const float t146 = t141 * work->t80;
    const float t147 = work->t81 - t146;
    const float t148 = work->t76 / t140;
    const float t149 = t148 * work->t76;
    const float t150 = work->t79 - t149;
    const float t151 = t148 * work->t80;
    const float t152 = work->t82 - t151;
    const int t153 = 0.000127305f < t143;
    const int t154 = t139 && t153;
    const float t155 = t153 ? t143 : 1.0f;
    const float t156 = t145 / t155;
    const float t157 = t156 * t145;
    const float t158 = t150 - t157;
    const float t159 = t156 * t147;
    const float t160 = t152 - t159;
    const int t161 = 0.000127305f < t158;
    work->flags[1] = t154 && t161;
    const float t163 = t161 ? t158 : 1.0f;
    const float t164 = t160 / t163;
    const float t165 = t145 * t164;
    const float t166 = t147 - t165;
    const float t167 = t166 / t155;
    const float t168 = work->t75 * t167;
    const float t169 = work->t80 - t168;
    const float t170 = work->t76 * t164;
    const float t171 = t169 - t170;
    const float t172 = t171 / t140;
    const float t173 = 0.09950372f * t172;
    const float t175 = 0.1602242f * t167;
    const float t177 = 0.06513793f * t164;
    const float t178 = t173 + t175;
    const float t179 = t178 + t177;
    work->t180 = t179 + work->t83;
    const float t182 = 2.8118842f * t167;
    const float t184 = 1.8418168f * t164;
    const float t185 = t182 + t184;
    work->t186 = t185 + work->t84;
    const float t188 = -0.52162856f * t167;
    const float t190 = -0.34166777f * t164;
    const float t191 = t188 + t190;
    work->t192 = t191 + work->t85;
}

/* Part 5 of a step. */
static void drive_irregular_part_5(drive_irregular_state *state, drive_irregular_work *work)
{
    /* without enough samples, the model's prediction */
    const uint32_t t193 = state->known;
    const int t194 = t193 == 1U;
    const int t195 = (-1e21f <= work->t12) && (work->t12 <= 1e21f);
    const int t196 = t194 && t195;
    const float t197 = work->flags[1] ? work->t180 : work->t12;
    const int t198 = (-1e21f <= work->t16) && (work->t16 <= 1e21f);
    const int t199 = t196 && t198;
    const float t200 = work->flags[1] ? work->t186 : work->t16;
    const int t201 = (-1e21f <= work->t20) && (work->t20 <= 1e21f);
    const int t202 = t199 && t201;
    const float t203 = work->flags[1] ? work->t192 : work->t20;
    const int t204 = work->flags[1] || t202;
    const int t205 = work->flags[0] && t204;
    const uint32_t t206 = t205 ? 1U : 0U;
    state->known = t206;
    const float t208 = 0.0009994135f * t200;
    const float t210 = 7.021338e-6f * t203;
    const float t211 = t197 + t208;
    const float t212 = t211 + t210;
    const int t213 = (-1e21f <= t212) && (t212 <= 1e21f);
    const float t214 = t213 ? t212 : 0.0f;
    state->next_q = t214;
    const float t216 = 0.998745f * t200;
    const float t218 = 0.0135869365f * t203;
    const float t219 = t216 + t218;
    const int t220 = (-1e21f <= t219) && (t219 <= 1e21f);
    const float t221 = t220 ? t219 : 0.0f;
    state->next_dq = t221;
    const float t223 = -0.032970965f * t200;
    const float t225 = 0.81849164f * t203;
    const float t226 = t223 + t225;
    const int t227 = (-1e21f <= t226) && (t226 <= 1e21f);
    const float t228 = t227 ? t226 : 0.0f;
    state->next_i = t228;

    /* the estimate; until there is one, the start */
    work->t229 = t205 ? t197 : work->t23;
    work->t230 = t205 ? t200 : 0.0f;
    work->t231 = t205 ? t203 : 0.0f;
    const uint32_t t232 = state->coasting;
    const int t233 = t232 == 0U;
    const int t234 = work->flags[1] && t233;
    const drive_irregular_status t238 = t234 ? DRIVE_IRREGULAR_CONVERGED : DRIVE_IRREGULAR_COASTING;
    work->t239 = t205 ? t238 : DRIVE_IRREGULAR_CONVERGING;
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
    state->since_y = 0U;
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

    estimate->q = work.t229;
    estimate->dq = work.t230;
    estimate->i = work.t231;
    estimate->status = work.t239;
}
