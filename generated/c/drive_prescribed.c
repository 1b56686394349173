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
#pragma GCC optimize("fp-contract=off")
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
    double t27;
    double t44;
    double t61;
    double t78;
    uint32_t t90;
    double t159;
    double t160;
    double t161;
    double t162;
    double t178;
    double t179;
    double t180;
    double t181;
    drive_prescribed_status t200;
    int flags[2]; /* t1, t79 */
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
    state->last_torque = t5;

    /* prediction by the plant */
    const double t6 = state->motor_angle;
    const double t7 = state->load_angle;
    const double t8 = state->motor_speed;
    const double t9 = state->load_speed;
    const double t10 = state->last_known0;
    const double t12 = 0.9950249142262294 * t6;
    const double t14 = 0.004975085773770609 * t7;
    const double t16 = 0.0004966821156547011 * t8;
    const double t18 = 3.3178843452988937e-6 * t9;
    const double t20 = 8.293894840854371e-6 * t10;
    const double t22 = 4.154200521167732e-6 * t5;
    const double t23 = t12 + t14;
    const double t24 = t23 + t16;
    const double t25 = t18 + t20;
    const double t26 = t25 + t22;
    work->t27 = t24 + t26;
    const double t29 = 0.0009950171547541218 * t6;
    const double t31 = 0.9990049828452459 * t7;
    const double t33 = 6.635768690597788e-7 * t8;
    const double t35 = 0.0004993364231309402 * t9;
    const double t37 = 7.887698495792626e-9 * t10;
    const double t39 = 2.493229099786935e-9 * t5;
    const double t40 = t29 + t31;
    const double t41 = t40 + t33;
    const double t42 = t35 + t37;
    const double t43 = t42 + t39;
    work->t44 = t41 + t43;
    const double t46 = -19.840741551425655 * t6;
    const double t48 = 19.840741551425655 * t7;
    const double t50 = 0.9851045434505166 * t8;
    const double t52 = 0.014895456549483436 * t9;
    const double t54 = 0.024772020841425907 * t10;
    const double t56 = 0.024896190724044205 * t5;
    const double t57 = t46 + t48;
    const double t58 = t57 + t50;
    const double t59 = t52 + t54;
    const double t60 = t59 + t56;
    work->t61 = t58 + t60;
    const double t63 = 3.9681483102851307 * t6;
    const double t65 = -3.9681483102851307 * t7;
    const double t67 = 0.002979091309896687 * t8;
    const double t69 = 0.9970209086901033 * t9;
    const double t71 = 4.559583171481875e-5 * t10;
    const double t73 = 2.076185519115912e-5 * t5;
    const double t74 = t63 + t65;
    const double t75 = t74 + t67;
    const double t76 = t69 + t71;
    const double t77 = t76 + t73;
    work->t78 = t75 + t77;
    state->last_known0 = t5;
    work->flags[1] = t3 && work->flags[0];
}

/* Part 2 of a step. */
static void drive_prescribed_part_2(const drive_prescribed_state *state, drive_prescribed_work *work)
{
    /* correction by the innovation */
    const double t81 = work->t0 - work->t27;
    const double t82 = work->flags[0] ? t81 : 0.0;
    const uint32_t t83 = state->left;
    const uint32_t t84 = (t83 < 160U) ? t83 : 160U;
    const uint32_t t85 = (t84 > 0U) ? (t84 - 1U) : 0U;
    const int t87 = t84 == 0U;
    const uint32_t t89 = t87 ? 160U : t85;
    work->t90 = work->flags[0] ? t89 : t84;
    const double t91 = (double)work->t90;
    const double t93 = 0.015625 * t91;
    const double t95 = t93 + 0.625;
    const double t96 = t95 * t95;
    const double t97 = t96 * t95;
    const double t98 = t97 * t95;
    const double t100 = 0.75 * t97;
    const double t102 = 0.2109375 * t96;
    const double t104 = 0.0263671875 * t95;
    const double t106 = t104 + 0.0012359619140625;
    const double t107 = t102 + t106;
    const double t108 = t100 + t107;
    const double t109 = t98 + t108;
    const double t110 = t82 / t109;
    const double t111 = t108 * t110;
    const double t112 = t107 * t110;
    const double t113 = t106 * t110;
    const double t114 = 0.0012359619140625 * t110;
    const double t116 = 1.0120722888660778 * t111;
    const double t118 = -0.012072288866077755 * t82;
    const double t119 = t116 + t118;
    const double t121 = -0.20241445777321554 * t111;
    const double t123 = 100.70186134480515 * t113;
    const double t125 = -0.10076206921647075 * t114;
    const double t127 = 0.0024144577732155507 * t82;
    const double t128 = t121 + t123;
    const double t129 = t128 + t125;
    const double t130 = t129 + t127;
    const double t132 = -12.157031761761674 * t111;
    const double t134 = 2016.0536790584729 * t112;
    const double t136 = 1006.0099839270049 * t113;
    const double t138 = 669.8681911240197 * t114;
    const double t140 = -23.879016211648374 * t82;
    const double t141 = t132 + t134;
    const double t142 = t136 + t138;
    const double t143 = t142 + t140;
    const double t144 = t141 + t143;
    const double t146 = 2.431406352352335 * t111;
    const double t148 = -403.2107358116946 * t112;
    const double t150 = -201.20199678540098 * t113;
    const double t152 = 201269.7490513855 * t114;
    const double t154 = 4.775803242329674 * t82;
    const double t155 = t146 + t148;
    const double t156 = t150 + t152;
    const double t157 = t156 + t154;
    const double t158 = t155 + t157;
    work->t159 = work->t27 + t119;
    work->t160 = work->t44 + t130;
    work->t161 = work->t61 + t144;
    work->t162 = work->t78 + t158;
}

/* Part 3 of a step. */
static void drive_prescribed_part_3(drive_prescribed_state *state, drive_prescribed_work *work)
{
    /* the first sample starts the observer; so does a state beyond all bounds */
    const uint32_t t163 = state->good;
    const int t164 = t163 == 0U;
    const int t165 = (-1e301 <= work->t159) && (work->t159 <= 1e301);
    const int t166 = !t165;
    const int t167 = t164 || t166;
    const int t168 = (-1e301 <= work->t160) && (work->t160 <= 1e301);
    const int t169 = !t168;
    const int t170 = t167 || t169;
    const int t171 = (-1e301 <= work->t161) && (work->t161 <= 1e301);
    const int t172 = !t171;
    const int t173 = t170 || t172;
    const int t174 = (-1e301 <= work->t162) && (work->t162 <= 1e301);
    const int t175 = !t174;
    const int t176 = t173 || t175;
    const double t177 = work->flags[0] ? work->t0 : 0.0;
    work->t178 = t176 ? t177 : work->t159;
    state->motor_angle = work->t178;
    work->t179 = t176 ? 0.0 : work->t160;
    state->load_angle = work->t179;
    work->t180 = t176 ? 0.0 : work->t161;
    state->motor_speed = work->t180;
    work->t181 = t176 ? 0.0 : work->t162;
    state->load_speed = work->t181;
    const uint32_t t182 = t176 ? 160U : work->t90;
    state->left = t182;
    const uint32_t t184 = work->flags[0] ? 1U : 0U;
    const uint32_t t185 = (t163 < 161U) ? (t163 + 1U) : 161U;
    const uint32_t t186 = work->flags[0] ? t185 : t163;
    const uint32_t t187 = t176 ? t184 : t186;
    state->good = t187;
    const uint32_t t188 = state->clean;
    const uint32_t t189 = (t188 < 238U) ? (t188 + 1U) : 238U;
    const uint32_t t190 = work->flags[1] ? t189 : 0U;
    const uint32_t t192 = t176 ? 238U : t190;
    state->clean = t192;

    /* the estimate */
    const int t194 = 160U < t187;
    const int t195 = 237U < t192;
    const drive_prescribed_status t199 = t195 ? DRIVE_PRESCRIBED_CONVERGED : DRIVE_PRESCRIBED_COASTING;
    work->t200 = t194 ? t199 : DRIVE_PRESCRIBED_CONVERGING;
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
    state->last_known0 = 0.0;
    state->last_torque = 0.0;
}

void drive_prescribed_step(drive_prescribed_state *state, const drive_prescribed_measurements *measurements,
                           const drive_prescribed_inputs *inputs, drive_prescribed_estimate *estimate)
{
    drive_prescribed_work work;
    drive_prescribed_part_1(state, measurements, inputs, &work);
    drive_prescribed_part_2(state, &work);
    drive_prescribed_part_3(state, &work);

    estimate->motor_angle = work.t178;
    estimate->load_angle = work.t179;
    estimate->motor_speed = work.t180;
    estimate->load_speed = work.t181;
    estimate->status = work.t200;
}
