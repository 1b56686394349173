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
    uint32_t t34;
    float t45;
    float t47;
    float t49;
    float t51;
    float t53;
    float t55;
    float t57;
    float t59;
    float t61;
    float t62;
    float t63;
    float t64;
    float t65;
    float t66;
    float t67;
    float t68;
    float t69;
    float t70;
    float t71;
    float t72;
    float t73;
    float t171;
    float t177;
    float t183;
    float t232;
    float t233;
    float t234;
    drive_irregular_status t242;
    int flags[2]; /* t33, t153 */
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
    const uint32_t t14 = state->count;
    const uint32_t t15 = state->since_y;
    const uint32_t t16 = (t15 < 10U) ? (t15 + 1U) : 10U;
    const uint32_t t18 = t3 ? 0U : t16;
    state->since_y = t18;
    const int t20 = t18 < 10U;
    const int t21 = t3 || t20;

    /* how much of the window is good */
    const int t23 = 100U < t14;
    const uint32_t t25 = (t14 < 101U) ? (t14 + 1U) : 101U;
    const uint32_t t26 = t5 ? t25 : 1U;
    const uint32_t t27 = t23 ? t25 : t26;
    state->count = t27;
    const uint32_t t28 = state->coasting;
    const uint32_t t29 = (t28 > 0U) ? (t28 - 1U) : 0U;
    const uint32_t t30 = t5 ? t29 : 100U;
    const uint32_t t32 = t21 ? t30 : 101U;
    state->coasting = t32;

    /* into the window */
    state->newest = work->t8;
    state->y[work->t8] = work->t12;
    state->has_y[work->t8] = t13;
    state->u[work->t8] = work->t7;
    work->flags[0] = 100U < t27;
}

/* Part 2 of a step. */
static void drive_irregular_part_2(const drive_irregular_state *state, drive_irregular_work *work)
{
    /* rows of the window, oldest first; those without a sample count nothing */
    work->t34 = (work->t8 < 100U) ? (work->t8 + 1U) : 0U;
    const float t38 = state->has_y[work->t34];
    const float t39 = state->y[work->t34];
    const float t40 = t39 - 0.0f;
    const float t41 = t38 * 0.09950372f;
    const float t42 = t38 * -0.18124144f;
    const float t43 = t38 * 0.5611647f;
    const float t44 = t41 * t41;
    work->t45 = 0.0f + t44;
    const float t46 = t41 * t42;
    work->t47 = 0.0f + t46;
    const float t48 = t41 * t43;
    work->t49 = 0.0f + t48;
    const float t50 = t42 * t42;
    work->t51 = 0.0f + t50;
    const float t52 = t42 * t43;
    work->t53 = 0.0f + t52;
    const float t54 = t43 * t43;
    work->t55 = 0.0f + t54;
    const float t56 = t41 * t40;
    work->t57 = 0.0f + t56;
    const float t58 = t42 * t40;
    work->t59 = 0.0f + t58;
    const float t60 = t43 * t40;
    work->t61 = 0.0f + t60;
}

/* Part 3 of a step. */
static void drive_irregular_part_3(const drive_irregular_state *state, drive_irregular_work *work)
{
    work->t62 = work->t45;
    work->t63 = work->t47;
    work->t64 = work->t49;
    work->t65 = work->t51;
    work->t66 = work->t53;
    work->t67 = work->t55;
    work->t68 = work->t57;
    work->t69 = work->t59;
    work->t70 = work->t61;
    work->t71 = 0.0f;
    work->t72 = 0.0f;
    work->t73 = 0.0f;
    uint32_t t74 = work->t34;
    for (uint32_t row = 0U; row < 100U; ++row) {
        const float *const gains = DRIVE_IRREGULAR_ROWS[row];
        const uint32_t t75 = (t74 < 100U) ? (t74 + 1U) : 0U;
        const float t76 = state->u[t75];
        const float t78 = 0.0009994135f * work->t72;
        const float t80 = 7.021338e-6f * work->t73;
        const float t81 = work->t71 + t78;
        const float t82 = t81 + t80;
        const float t84 = 9.516694e-8f * t76;
        const float t85 = t82 + t84;
        const float t87 = 0.998745f * work->t72;
        const float t89 = 0.0135869365f * work->t73;
        const float t90 = t87 + t89;
        const float t92 = 0.00028085354f * t76;
        const float t93 = t90 + t92;
        const float t95 = -0.032970965f * work->t72;
        const float t97 = 0.81849164f * work->t73;
        const float t98 = t95 + t97;
        const float t100 = 0.036250554f * t76;
        const float t101 = t98 + t100;
        const float t102 = gains[0];
        const float t103 = gains[1];
        const float t104 = gains[2];
        const float t105 = state->has_y[t75];
        const float t106 = state->y[t75];
        const float t107 = t106 - t85;
        const float t108 = t105 * t102;
        const float t109 = t105 * t103;
        const float t110 = t105 * t104;
        const float t111 = t108 * t108;
        const float t112 = work->t62 + t111;
        const float t113 = t108 * t109;
        const float t114 = work->t63 + t113;
        const float t115 = t108 * t110;
        const float t116 = work->t64 + t115;
        const float t117 = t109 * t109;
        const float t118 = work->t65 + t117;
        const float t119 = t109 * t110;
        const float t120 = work->t66 + t119;
        const float t121 = t110 * t110;
        const float t122 = work->t67 + t121;
        const float t123 = t108 * t107;
        const float t124 = work->t68 + t123;
        const float t125 = t109 * t107;
        const float t126 = work->t69 + t125;
        const float t127 = t110 * t107;
        const float t128 = work->t70 + t127;
        work->t62 = t112;
        work->t63 = t114;
        work->t64 = t116;
        work->t65 = t118;
        work->t66 = t120;
        work->t67 = t122;
        work->t68 = t124;
        work->t69 = t126;
        work->t70 = t128;
        work->t71 = t85;
        work->t72 = t93;
        work->t73 = t101;
        t74 = t75;
    }
}

/* Part 4 of a step. */
static void drive_irregular_part_4(drive_irregular_work *work)
{
    /* the window's start from the samples that are there */
    const int t130 = 0.000127305f < work->t62;
    const float t131 = t130 ? work->t62 : 1.0f;
    const float t132 = work->t63 / t131;
    const float t133 = t132 * work->t63;
    const float t134 = work->t65 - t133;
    const float t135 = t132 * work->t64;
    const float t136 = work->t66 - t135;
    const float t137 = t132 * work->t68;
    const float t138 = work->t69 - t137;
    const float t139 = work->t64 / t131;
    const float t140 = t139 * work->t64;
    const float t141 = work->t67 - t140;
    const float t142 = t139 * work->t68;
    const float t143 = work->t70 - t142;
    const int t144 = 0.000127305f < t134;
    const int t145 = t130 && t144;
    const float t146 = t144 ? t134 : 1.0f;
    const float t147 = t136 / t146;
    const float t148 = t147 * t136;
    const float t149 = t141 - t148;
    const float t150 = t147 * t138;
    const float t151 = t143 - t150;
    const int t152 = 0.000127305f < t149;
    work->flags[1] = t145 && t152;
    const float t154 = t152 ? t149 : 1.0f;
    const float t155 = t151 / t154;
    const float t156 = t136 * t155;
    const float t157 = t138 - t156;
    const float t158 = t157 / t146;
    const float t159 = work->t63 * t158;
    const float t160 = work->t68 - t159;
    const float t161 = work->t64 * t155;
    const float t162 = t160 - t161;
    const float t163 = t162 / t131;
    const float t164 = 0.09950372f * t163;
    const float t166 = 0.1602242f * t158;
    const float t168 = 0.06513793f * t155;
    const float t169 = t164 + t166;
    const float t170 = t169 + t168;
    work->t171 = t170 + work->t71;
    const float t173 = 2.8118842f * t158;
    const float t175 = 1.8418168f * t155;
    const float t176 = t173 + t175;
    work->t177 = t176 + work->t72;
    const float t179 = -0.52162856f * t158;
    const float t181 = -0.34166777f * t155;
    const float t182 = t179 + t181;
    work->t183 = t182 + work->t73;
}

/* Part 5 of a step. */
static void drive_irregular_part_5(drive_irregular_state *state, drive_irregular_work *work)
{
    /* without enough samples, the model's prediction */
    const uint32_t t184 = state->known;
    const int t185 = t184 == 1U;
    const float t186 = state->next_q;
    const float t188 = 9.516694e-8f * work->t7;
    const float t189 = t186 + t188;
    const int t190 = (-1e21f <= t189) && (t189 <= 1e21f);
    const int t191 = t185 && t190;
    const float t192 = work->flags[1] ? work->t171 : t189;
    const float t193 = state->next_dq;
    const float t195 = 0.00028085354f * work->t7;
    const float t196 = t193 + t195;
    const int t197 = (-1e21f <= t196) && (t196 <= 1e21f);
    const int t198 = t191 && t197;
    const float t199 = work->flags[1] ? work->t177 : t196;
    const float t200 = state->next_i;
    const float t202 = 0.036250554f * work->t7;
    const float t203 = t200 + t202;
    const int t204 = (-1e21f <= t203) && (t203 <= 1e21f);
    const int t205 = t198 && t204;
    const float t206 = work->flags[1] ? work->t183 : t203;
    const int t207 = work->flags[1] || t205;
    const int t208 = work->flags[0] && t207;
    const uint32_t t209 = t208 ? 1U : 0U;
    state->known = t209;
    const float t211 = 0.0009994135f * t199;
    const float t213 = 7.021338e-6f * t206;
    const float t214 = t192 + t211;
    const float t215 = t214 + t213;
    const int t216 = (-1e21f <= t215) && (t215 <= 1e21f);
    const float t217 = t216 ? t215 : 0.0f;
    state->next_q = t217;
    const float t219 = 0.998745f * t199;
    const float t221 = 0.0135869365f * t206;
    const float t222 = t219 + t221;
    const int t223 = (-1e21f <= t222) && (t222 <= 1e21f);
    const float t224 = t223 ? t222 : 0.0f;
    state->next_dq = t224;
    const float t226 = -0.032970965f * t199;
    const float t228 = 0.81849164f * t206;
    const float t229 = t226 + t228;
    const int t230 = (-1e21f <= t229) && (t229 <= 1e21f);
    const float t231 = t230 ? t229 : 0.0f;
    state->next_i = t231;

    /* the estimate; until there is one, the start */
    work->t232 = t208 ? t192 : work->t12;
    work->t233 = t208 ? t199 : 0.0f;
    work->t234 = t208 ? t206 : 0.0f;
    const uint32_t t235 = state->coasting;
    const int t236 = t235 == 0U;
    const int t237 = work->flags[1] && t236;
    const drive_irregular_status t241 = t237 ? DRIVE_IRREGULAR_CONVERGED : DRIVE_IRREGULAR_COASTING;
    work->t242 = t208 ? t241 : DRIVE_IRREGULAR_CONVERGING;
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

    estimate->q = work.t232;
    estimate->dq = work.t233;
    estimate->i = work.t234;
    estimate->status = work.t242;
}
