/* drive_prescribed.c: Finite-time observer: Load of an elastic drive from the motor's angle, again and again by a prescribed time.
 *
 * Generated; drive_prescribed.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "drive_prescribed.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "drive_prescribed.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "drive_prescribed.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* What one part of a step hands to the next. */
typedef struct {
    double t0;
    double t26;
    double t43;
    double t60;
    double t77;
    uint32_t t89;
    double t158;
    double t159;
    double t160;
    double t161;
    double t177;
    double t178;
    double t179;
    double t180;
    drive_prescribed_status t199;
    int flags[2]; /* t1, t78 */
} drive_prescribed_work;

/* Part 1 of a step. */
static void drive_prescribed_part_1(drive_prescribed_state *state, const drive_prescribed_measurements *measurements, const drive_prescribed_inputs *inputs, drive_prescribed_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    work->t0 = measurements->motor_angle;
    work->flags[0] = (-1e301 <= work->t0) && (work->t0 <= 1e301);
    const double t2 = inputs->torque;
    const int t3 = (-1e301 <= t2) && (t2 <= 1e301);
    const double t4 = state->last_torque;
    const double t5 = t3 ? t2 : t4;

    /* prediction by the plant */
    const double t6 = state->motor_angle;
    const double t7 = state->load_angle;
    const double t8 = state->motor_speed;
    const double t9 = state->load_speed;
    const double t11 = 0.9950249142262294 * t6;
    const double t13 = 0.004975085773770609 * t7;
    const double t15 = 0.0004966821156547011 * t8;
    const double t17 = 3.3178843452988937e-6 * t9;
    const double t19 = 8.293894840854371e-6 * t4;
    const double t21 = 4.154200521167732e-6 * t5;
    const double t22 = t11 + t13;
    const double t23 = t22 + t15;
    const double t24 = t17 + t19;
    const double t25 = t24 + t21;
    work->t26 = t23 + t25;
    const double t28 = 0.0009950171547541218 * t6;
    const double t30 = 0.9990049828452459 * t7;
    const double t32 = 6.635768690597788e-7 * t8;
    const double t34 = 0.0004993364231309402 * t9;
    const double t36 = 7.887698495792626e-9 * t4;
    const double t38 = 2.493229099786935e-9 * t5;
    const double t39 = t28 + t30;
    const double t40 = t39 + t32;
    const double t41 = t34 + t36;
    const double t42 = t41 + t38;
    work->t43 = t40 + t42;
    const double t45 = -19.840741551425655 * t6;
    const double t47 = 19.840741551425655 * t7;
    const double t49 = 0.9851045434505166 * t8;
    const double t51 = 0.014895456549483436 * t9;
    const double t53 = 0.024772020841425907 * t4;
    const double t55 = 0.024896190724044205 * t5;
    const double t56 = t45 + t47;
    const double t57 = t56 + t49;
    const double t58 = t51 + t53;
    const double t59 = t58 + t55;
    work->t60 = t57 + t59;
    const double t62 = 3.9681483102851307 * t6;
    const double t64 = -3.9681483102851307 * t7;
    const double t66 = 0.002979091309896687 * t8;
    const double t68 = 0.9970209086901033 * t9;
    const double t70 = 4.559583171481875e-5 * t4;
    const double t72 = 2.076185519115912e-5 * t5;
    const double t73 = t62 + t64;
    const double t74 = t73 + t66;
    const double t75 = t68 + t70;
    const double t76 = t75 + t72;
    work->t77 = t74 + t76;
    state->last_torque = t5;
    work->flags[1] = t3 && work->flags[0];
}

/* Part 2 of a step. */
static void drive_prescribed_part_2(const drive_prescribed_state *state, drive_prescribed_work *work)
{
    /* correction by the innovation */
    const double t80 = work->t0 - work->t26;
    const double t81 = work->flags[0] ? t80 : 0.0;
    const uint32_t t82 = state->left;
    const uint32_t t83 = (t82 < 160U) ? t82 : 160U;
    const uint32_t t84 = (t83 > 0U) ? (t83 - 1U) : 0U;
    const int t86 = t83 == 0U;
    const uint32_t t88 = t86 ? 160U : t84;
    work->t89 = work->flags[0] ? t88 : t83;
    const double t90 = (double)work->t89;
    const double t92 = 0.015625 * t90;
    const double t94 = t92 + 0.625;
    const double t95 = t94 * t94;
    const double t96 = t95 * t94;
    const double t97 = t96 * t94;
    const double t99 = 0.75 * t96;
    const double t101 = 0.2109375 * t95;
    const double t103 = 0.0263671875 * t94;
    const double t105 = t103 + 0.0012359619140625;
    const double t106 = t101 + t105;
    const double t107 = t99 + t106;
    const double t108 = t97 + t107;
    const double t109 = t81 / t108;
    const double t110 = t107 * t109;
    const double t111 = t106 * t109;
    const double t112 = t105 * t109;
    const double t113 = 0.0012359619140625 * t109;
    const double t115 = 1.0120722888660778 * t110;
    const double t117 = -0.012072288866077755 * t81;
    const double t118 = t115 + t117;
    const double t120 = -0.20241445777321554 * t110;
    const double t122 = 100.70186134480515 * t112;
    const double t124 = -0.10076206921647075 * t113;
    const double t126 = 0.0024144577732155507 * t81;
    const double t127 = t120 + t122;
    const double t128 = t127 + t124;
    const double t129 = t128 + t126;
    const double t131 = -12.157031761761674 * t110;
    const double t133 = 2016.0536790584729 * t111;
    const double t135 = 1006.0099839270049 * t112;
    const double t137 = 669.8681911240197 * t113;
    const double t139 = -23.879016211648374 * t81;
    const double t140 = t131 + t133;
    const double t141 = t135 + t137;
    const double t142 = t141 + t139;
    const double t143 = t140 + t142;
    const double t145 = 2.431406352352335 * t110;
    const double t147 = -403.2107358116946 * t111;
    const double t149 = -201.20199678540098 * t112;
    const double t151 = 201269.7490513855 * t113;
    const double t153 = 4.775803242329674 * t81;
    const double t154 = t145 + t147;
    const double t155 = t149 + t151;
    const double t156 = t155 + t153;
    const double t157 = t154 + t156;
    work->t158 = work->t26 + t118;
    work->t159 = work->t43 + t129;
    work->t160 = work->t60 + t143;
    work->t161 = work->t77 + t157;
}

/* Part 3 of a step. */
static void drive_prescribed_part_3(drive_prescribed_state *state, drive_prescribed_work *work)
{
    /* the first sample starts the observer; so does a state beyond all bounds */
    const uint32_t t162 = state->good;
    const int t163 = t162 == 0U;
    const int t164 = (-1e301 <= work->t158) && (work->t158 <= 1e301);
    const int t165 = !t164;
    const int t166 = t163 || t165;
    const int t167 = (-1e301 <= work->t159) && (work->t159 <= 1e301);
    const int t168 = !t167;
    const int t169 = t166 || t168;
    const int t170 = (-1e301 <= work->t160) && (work->t160 <= 1e301);
    const int t171 = !t170;
    const int t172 = t169 || t171;
    const int t173 = (-1e301 <= work->t161) && (work->t161 <= 1e301);
    const int t174 = !t173;
    const int t175 = t172 || t174;
    const double t176 = work->flags[0] ? work->t0 : 0.0;
    work->t177 = t175 ? t176 : work->t158;
    state->motor_angle = work->t177;
    work->t178 = t175 ? 0.0 : work->t159;
    state->load_angle = work->t178;
    work->t179 = t175 ? 0.0 : work->t160;
    state->motor_speed = work->t179;
    work->t180 = t175 ? 0.0 : work->t161;
    state->load_speed = work->t180;
    const uint32_t t181 = t175 ? 160U : work->t89;
    state->left = t181;
    const uint32_t t183 = work->flags[0] ? 1U : 0U;
    const uint32_t t184 = (t162 < 161U) ? (t162 + 1U) : 161U;
    const uint32_t t185 = work->flags[0] ? t184 : t162;
    const uint32_t t186 = t175 ? t183 : t185;
    state->good = t186;
    const uint32_t t187 = state->clean;
    const uint32_t t188 = (t187 < 238U) ? (t187 + 1U) : 238U;
    const uint32_t t189 = work->flags[1] ? t188 : 0U;
    const uint32_t t191 = t175 ? 238U : t189;
    state->clean = t191;

    /* the estimate */
    const int t193 = 160U < t186;
    const int t194 = 237U < t191;
    const drive_prescribed_status t198 = t194 ? DRIVE_PRESCRIBED_CONVERGED : DRIVE_PRESCRIBED_COASTING;
    work->t199 = t193 ? t198 : DRIVE_PRESCRIBED_CONVERGING;
}

void drive_prescribed_init(drive_prescribed_state *state)
{
    state->motor_angle = 0.0;
    state->load_angle = 0.0;
    state->motor_speed = 0.0;
    state->load_speed = 0.0;
    state->left = 160U;
    state->good = 0U;
    state->clean = 0U;
    state->last_torque = 0.0;
}

void drive_prescribed_step(drive_prescribed_state *state, const drive_prescribed_measurements *measurements,
                           const drive_prescribed_inputs *inputs, drive_prescribed_estimate *estimate)
{
    drive_prescribed_work work;
    drive_prescribed_part_1(state, measurements, inputs, &work);
    drive_prescribed_part_2(state, &work);
    drive_prescribed_part_3(state, &work);

    estimate->motor_angle = work.t177;
    estimate->load_angle = work.t178;
    estimate->motor_speed = work.t179;
    estimate->load_speed = work.t180;
    estimate->status = work.t199;
}
