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
    float t51;
    float t58;
    float t60;
    float t62;
    float t64;
    float t66;
    float t68;
    float t70;
    float t72;
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
    float t86;
    float t87;
    float t212;
    float t217;
    float t222;
    float t224;
    float t226;
    float t228;
    float t304;
    float t305;
    float t306;
    drive_irregular_status t314;
    int flags[2]; /* t45, t205 */
} drive_irregular_work;

/* Part 1 of a step. */
static void drive_irregular_part_1(drive_irregular_state *state, const drive_irregular_measurements *measurements, const drive_irregular_inputs *inputs, drive_irregular_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    const uint32_t t0 = state->newest;
    const uint32_t t1 = (t0 < 100U) ? t0 : 100U;
    const float t2 = measurements->y;
    const int t3 = (-1e30f <= t2) && (t2 <= 1e30f);
    const float t4 = inputs->u;
    const int t5 = (-1e30f <= t4) && (t4 <= 1e30f);
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
    work->t51 = 0.0f + t50;
    const float t52 = state->y[work->t46];
    const float t53 = t52 - 0.0f;
    const float t54 = t50 * 0.09950372f;
    const float t55 = t50 * -0.18124144f;
    const float t56 = t50 * 0.5611647f;
    const float t57 = t54 * t54;
    work->t58 = 0.0f + t57;
    const float t59 = t54 * t55;
    work->t60 = 0.0f + t59;
    const float t61 = t54 * t56;
    work->t62 = 0.0f + t61;
    const float t63 = t55 * t55;
    work->t64 = 0.0f + t63;
    const float t65 = t55 * t56;
    work->t66 = 0.0f + t65;
    const float t67 = t56 * t56;
    work->t68 = 0.0f + t67;
    const float t69 = t54 * t53;
    work->t70 = 0.0f + t69;
    const float t71 = t55 * t53;
    work->t72 = 0.0f + t71;
    const float t73 = t56 * t53;
    work->t74 = 0.0f + t73;
}

/* Part 3 of a step. */
static void drive_irregular_part_3(const drive_irregular_state *state, drive_irregular_work *work)
{
    work->t75 = work->t58;
    work->t76 = work->t60;
    work->t77 = work->t62;
    work->t78 = work->t64;
    work->t79 = work->t66;
    work->t80 = work->t68;
    work->t81 = work->t70;
    work->t82 = work->t72;
    work->t83 = work->t74;
    work->t84 = 0.0f;
    work->t85 = 0.0f;
    work->t86 = 0.0f;
    work->t87 = work->t51;
    uint32_t t88 = work->t46;
    for (uint32_t row = 0U; row < 100U; ++row) {
        const float *const gains = DRIVE_IRREGULAR_ROWS[row];
        const uint32_t t89 = (t88 < 100U) ? (t88 + 1U) : 0U;
        const float t90 = state->u[t89];
        const float t92 = 0.0009994135f * work->t85;
        const float t94 = 7.021338e-6f * work->t86;
        const float t95 = work->t84 + t92;
        const float t96 = t95 + t94;
        const float t97 = 9.516694e-8f * t90;
        const float t98 = t96 + t97;
        const float t100 = 0.998745f * work->t85;
        const float t102 = 0.0135869365f * work->t86;
        const float t103 = t100 + t102;
        const float t104 = 0.00028085354f * t90;
        const float t105 = t103 + t104;
        const float t107 = -0.032970965f * work->t85;
        const float t109 = 0.81849164f * work->t86;
        const float t110 = t107 + t109;
        const float t111 = 0.036250554f * t90;
        const float t112 = t110 + t111;
        const float t113 = gains[0];
        const float t114 = gains[1];
        const float t115 = gains[2];
        const float t116 = state->has_y[t89];
        const float t117 = work->t87 + t116;
        const float t118 = state->y[t89];
        const float t119 = t118 - t98;
        const float t120 = t116 * t113;
        const float t121 = t116 * t114;
        const float t122 = t116 * t115;
        const float t123 = t120 * t120;
        const float t124 = work->t75 + t123;
        const float t125 = t120 * t121;
        const float t126 = work->t76 + t125;
        const float t127 = t120 * t122;
        const float t128 = work->t77 + t127;
        const float t129 = t121 * t121;
        const float t130 = work->t78 + t129;
        const float t131 = t121 * t122;
        const float t132 = work->t79 + t131;
        const float t133 = t122 * t122;
        const float t134 = work->t80 + t133;
        const float t135 = t120 * t119;
        const float t136 = work->t81 + t135;
        const float t137 = t121 * t119;
        const float t138 = work->t82 + t137;
        const float t139 = t122 * t119;
        const float t140 = work->t83 + t139;
        work->t75 = t124;
        work->t76 = t126;
        work->t77 = t128;
        work->t78 = t130;
        work->t79 = t132;
        work->t80 = t134;
        work->t81 = t136;
        work->t82 = t138;
        work->t83 = t140;
        work->t84 = t98;
        work->t85 = t105;
        work->t86 = t112;
        work->t87 = t117;
        t88 = t89;
    }
}

/* Part 4 of a step. */
static void drive_irregular_part_4(drive_irregular_work *work)
{
    /* the state from the samples that are there, and its variance */
    const float t150 = 0.0001f * work->t75;
    const float t151 = t150 + 9.8607613e-32f;
    const float t152 = 0.0001f * work->t78;
    const float t153 = t152 + 9.8607613e-32f;
    const float t154 = 0.0001f * work->t80;
    const float t155 = t154 + 9.8607613e-32f;
    const int t156 = t151 < work->t75;
    const float t157 = t156 ? work->t75 : 1.0f;
    const float t158 = work->t76 / t157;
    const float t159 = work->t77 / t157;
    const float t160 = t158 * work->t76;
    const float t161 = work->t78 - t160;
    const float t162 = t158 * work->t77;
    const float t163 = work->t79 - t162;
    const float t164 = t158 * work->t81;
    const float t165 = work->t82 - t164;
    const float t166 = t159 * work->t77;
    const float t167 = work->t80 - t166;
    const float t168 = t159 * work->t81;
    const float t169 = work->t83 - t168;
    const float t170 = work->t81 / t157;
    const float t171 = t158 * 0.012437965f;
    const float t172 = 0.020028025f - t171;
    const float t173 = t159 * 0.012437965f;
    const float t174 = 0.008142241f - t173;
    const float t175 = 0.012437965f * t170;
    const float t176 = 0.012437965f / t157;
    const float t177 = 0.012437965f * t176;
    const int t178 = t153 < t161;
    const int t179 = t156 && t178;
    const float t180 = t178 ? t161 : 1.0f;
    const float t181 = t163 / t180;
    const float t182 = t181 * t163;
    const float t183 = t167 - t182;
    const float t184 = t181 * t165;
    const float t185 = t169 - t184;
    const float t186 = t165 / t180;
    const float t187 = t181 * t172;
    const float t188 = t174 - t187;
    const float t189 = t172 * t186;
    const float t190 = t175 + t189;
    const float t191 = t172 / t180;
    const float t192 = t172 * t191;
    const float t193 = t177 + t192;
    const float t194 = t181 * 0.021967845f;
    const float t195 = 0.014389194f - t194;
    const float t196 = 0.021967845f * t186;
    const float t197 = 0.021967845f / t180;
    const float t198 = 0.021967845f * t197;
    const float t199 = t181 * -0.032601785f;
    const float t200 = -0.021354236f - t199;
    const float t201 = -0.032601785f * t186;
    const float t202 = -0.032601785f / t180;
    const float t203 = -0.032601785f * t202;
    const int t204 = t155 < t183;
    work->flags[1] = t179 && t204;
    const float t206 = t204 ? t183 : 1.0f;
    const float t207 = t185 / t206;
    const float t208 = t188 * t207;
    const float t209 = t190 + t208;
    const float t210 = t188 / t206;
    const float t211 = t188 * t210;
    work->t212 = t193 + t211;
    const float t213 = t195 * t207;
    const float t214 = t196 + t213;
    const float t215 = t195 / t206;
    const float t216 = t195 * t215;
    work->t217 = t198 + t216;
    const float t218 = t200 * t207;
    const float t219 = t201 + t218;
    const float t220 = t200 / t206;
    const float t221 = t200 * t220;
    work->t222 = t203 + t221;
    work->t224 = 8.0f * t209;
    work->t226 = 128.0f * t214;
    work->t228 = 16.0f * t219;
}

/* Part 5 of a step. */
static void drive_irregular_part_5(drive_irregular_state *state, drive_irregular_work *work)
{
    /* what it is worth */
    const float t230 = work->t212 * 0.8745885f;
    const int t231 = 0.0f < t230;
    const float t232 = t231 ? t230 : 0.0f;
    const float t234 = work->t217 * 0.761432f;
    const int t235 = t232 < t234;
    const float t236 = t235 ? t234 : t232;
    const float t238 = work->t222 * 0.34573185f;
    const int t239 = t236 < t238;
    const float t240 = t239 ? t238 : t236;
    const int t245 = t240 <= 421225.03f;
    const int t246 = work->flags[1] && t245;
    const int t247 = t240 <= 0.421225f;
    const int t248 = t246 && t247;
    const float t249 = 2.0785816f * work->t87;
    const float t250 = t249 + 24.661118f;
    const float t251 = t240 * t250;
    const int t252 = t251 <= 1.0f;
    const int t253 = t248 && t252;
    const int t254 = 0.0f < work->t87;
    const float t255 = work->t224 + work->t84;
    const float t256 = work->t226 + work->t85;
    const float t257 = work->t228 + work->t86;

    /* without enough samples, the model's prediction */
    const uint32_t t258 = state->known;
    const int t259 = t258 == 1U;
    const int t260 = (-1e30f <= work->t12) && (work->t12 <= 1e30f);
    const int t261 = t259 && t260;
    const int t262 = (-1e30f <= work->t16) && (work->t16 <= 1e30f);
    const int t263 = t261 && t262;
    const int t264 = (-1e30f <= work->t20) && (work->t20 <= 1e30f);
    const int t265 = t263 && t264;
    const uint32_t t266 = state->poor;
    const uint32_t t267 = (t266 < 303U) ? (t266 + 1U) : 303U;
    const uint32_t t268 = t254 ? t267 : t266;
    const uint32_t t269 = t248 ? 0U : t268;
    state->poor = t269;
    const int t271 = t269 < 303U;
    const int t272 = t271 && t265;
    const int t273 = !t272;
    const int t274 = t248 || t273;
    const int t275 = t246 && t274;
    const float t276 = t275 ? t255 : work->t12;
    const float t277 = t275 ? t256 : work->t16;
    const float t278 = t275 ? t257 : work->t20;
    const int t279 = t275 || t265;
    const int t280 = work->flags[0] && t279;
    const uint32_t t281 = t280 ? 1U : 0U;
    state->known = t281;
    const float t283 = 0.0009994135f * t277;
    const float t285 = 7.021338e-6f * t278;
    const float t286 = t276 + t283;
    const float t287 = t286 + t285;
    const int t288 = (-1e30f <= t287) && (t287 <= 1e30f);
    const float t289 = t288 ? t287 : 0.0f;
    state->next_q = t289;
    const float t291 = 0.998745f * t277;
    const float t293 = 0.0135869365f * t278;
    const float t294 = t291 + t293;
    const int t295 = (-1e30f <= t294) && (t294 <= 1e30f);
    const float t296 = t295 ? t294 : 0.0f;
    state->next_dq = t296;
    const float t298 = -0.032970965f * t277;
    const float t300 = 0.81849164f * t278;
    const float t301 = t298 + t300;
    const int t302 = (-1e30f <= t301) && (t301 <= 1e30f);
    const float t303 = t302 ? t301 : 0.0f;
    state->next_i = t303;

    /* the estimate; until there is one, the start */
    work->t304 = t280 ? t276 : work->t23;
    work->t305 = t280 ? t277 : 0.0f;
    work->t306 = t280 ? t278 : 0.0f;
    const uint32_t t307 = state->coasting;
    const int t308 = t307 == 0U;
    const int t309 = t253 && t308;
    const drive_irregular_status t313 = t309 ? DRIVE_IRREGULAR_CONVERGED : DRIVE_IRREGULAR_COASTING;
    work->t314 = t280 ? t313 : DRIVE_IRREGULAR_CONVERGING;
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
    state->poor = 303U;
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

    estimate->q = work.t304;
    estimate->dq = work.t305;
    estimate->i = work.t306;
    estimate->status = work.t314;
}
