/* two_mass_kalman.c: Finite-time observer: Motor and load on an elastic shaft, both angles measured and weighed by their noise.
 *
 * Generated; two_mass_kalman.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "two_mass_kalman.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "two_mass_kalman.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "two_mass_kalman.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* What one part of a step hands to the next. */
typedef struct {
    double t0;
    double t2;
    double t30;
    double t47;
    double t64;
    double t81;
    double t136;
    double t138;
    double t139;
    double t140;
    two_mass_kalman_status t159;
    int flags[4]; /* t1, t3, t8, t82 */
} two_mass_kalman_work;

/* Part 1 of a step. */
static void two_mass_kalman_part_1(two_mass_kalman_state *state, const two_mass_kalman_measurements *measurements, const two_mass_kalman_inputs *inputs, two_mass_kalman_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    work->t0 = measurements->motor_angle;
    work->flags[0] = (-628.3185307179587 <= work->t0) && (work->t0 <= 628.3185307179587);
    work->t2 = measurements->load_angle;
    work->flags[1] = (-628.3185307179587 <= work->t2) && (work->t2 <= 628.3185307179587);
    const double t4 = inputs->torque;
    const int t5 = (-1e303 <= t4) && (t4 <= 1e303);
    const double t6 = state->last_torque;
    const double t7 = t5 ? t4 : t6;
    state->last_torque = t7;
    work->flags[2] = work->flags[0] && work->flags[1];

    /* prediction by the plant */
    const double t9 = state->motor_angle;
    const double t10 = state->load_angle;
    const double t11 = state->motor_speed;
    const double t12 = state->load_speed;
    const double t13 = state->last_known0;
    const double t15 = 0.9950249142262294 * t9;
    const double t17 = 0.004975085773770609 * t10;
    const double t19 = 0.0004966821156547011 * t11;
    const double t21 = 3.3178843452988937e-6 * t12;
    const double t23 = 8.293894840854371e-6 * t13;
    const double t25 = 4.154200521167732e-6 * t7;
    const double t26 = t15 + t17;
    const double t27 = t26 + t19;
    const double t28 = t21 + t23;
    const double t29 = t28 + t25;
    work->t30 = t27 + t29;
    const double t32 = 0.0009950171547541218 * t9;
    const double t34 = 0.9990049828452459 * t10;
    const double t36 = 6.635768690597788e-7 * t11;
    const double t38 = 0.0004993364231309402 * t12;
    const double t40 = 7.887698495792626e-9 * t13;
    const double t42 = 2.493229099786935e-9 * t7;
    const double t43 = t32 + t34;
    const double t44 = t43 + t36;
    const double t45 = t38 + t40;
    const double t46 = t45 + t42;
    work->t47 = t44 + t46;
    const double t49 = -19.840741551425655 * t9;
    const double t51 = 19.840741551425655 * t10;
    const double t53 = 0.9851045434505166 * t11;
    const double t55 = 0.014895456549483436 * t12;
    const double t57 = 0.024772020841425907 * t13;
    const double t59 = 0.024896190724044205 * t7;
    const double t60 = t49 + t51;
    const double t61 = t60 + t53;
    const double t62 = t55 + t57;
    const double t63 = t62 + t59;
    work->t64 = t61 + t63;
    const double t66 = 3.9681483102851307 * t9;
    const double t68 = -3.9681483102851307 * t10;
    const double t70 = 0.002979091309896687 * t11;
    const double t72 = 0.9970209086901033 * t12;
    const double t74 = 4.559583171481875e-5 * t13;
    const double t76 = 2.076185519115912e-5 * t7;
    const double t77 = t66 + t68;
    const double t78 = t77 + t70;
    const double t79 = t72 + t74;
    const double t80 = t79 + t76;
    work->t81 = t78 + t80;
    state->last_known0 = t7;
    work->flags[3] = t5 && work->flags[2];
}

/* Part 2 of a step. */
static void two_mass_kalman_part_2(two_mass_kalman_state *state, two_mass_kalman_work *work)
{
    /* correction by the innovation */
    const int t83 = (-628.3185307179587 <= work->t30) && (work->t30 <= 628.3185307179587);
    const int t84 = work->flags[0] || t83;
    const int t85 = !t84;
    const int t86 = (-628.3185307179587 <= work->t47) && (work->t47 <= 628.3185307179587);
    const int t87 = work->flags[1] || t86;
    const int t88 = !t87;
    const int t89 = t85 || t88;
    const double t91 = work->t0 - work->t30;
    const double t92 = work->flags[0] ? t91 : 0.0;
    const double t93 = work->t2 - work->t47;
    const double t94 = work->flags[1] ? t93 : 0.0;
    const double t96 = 0.6252170978732445 * t92;
    const double t98 = 0.002542111325138867 * t94;
    const double t99 = t96 + t98;
    const double t101 = 0.050842226502777345 * t92;
    const double t103 = 0.23729546780627317 * t94;
    const double t104 = t101 + t103;
    const double t106 = 588.5924566111323 * t92;
    const double t108 = 7.518009944344432 * t94;
    const double t109 = t106 + t108;
    const double t111 = 15.768605939992751 * t92;
    const double t113 = 64.50265025518871 * t94;
    const double t114 = t111 + t113;
    const double t115 = work->t30 + t99;
    const double t116 = work->t47 + t104;
    const double t117 = work->t64 + t109;
    const double t118 = work->t81 + t114;

    /* the first sample starts the observer; so does a state beyond all bounds */
    const uint32_t t120 = state->good;
    const int t121 = t120 == 0U;
    const int t122 = t121 || t89;
    const int t123 = (-1e303 <= t115) && (t115 <= 1e303);
    const int t124 = !t123;
    const int t125 = t122 || t124;
    const int t126 = (-1e303 <= t116) && (t116 <= 1e303);
    const int t127 = !t126;
    const int t128 = t125 || t127;
    const int t129 = (-1e303 <= t117) && (t117 <= 1e303);
    const int t130 = !t129;
    const int t131 = t128 || t130;
    const int t132 = (-1e303 <= t118) && (t118 <= 1e303);
    const int t133 = !t132;
    const int t134 = t131 || t133;
    const double t135 = work->flags[2] ? work->t0 : 0.0;
    work->t136 = t134 ? t135 : t115;
    state->motor_angle = work->t136;
    const double t137 = work->flags[2] ? work->t2 : 0.0;
    work->t138 = t134 ? t137 : t116;
    state->load_angle = work->t138;
    work->t139 = t134 ? 0.0 : t117;
    state->motor_speed = work->t139;
    work->t140 = t134 ? 0.0 : t118;
    state->load_speed = work->t140;
    const uint32_t t142 = work->flags[2] ? 1U : 0U;
    const uint32_t t143 = (t120 < 114U) ? (t120 + 1U) : 114U;
    const uint32_t t144 = work->flags[2] ? t143 : t120;
    const uint32_t t145 = t134 ? t142 : t144;
    state->good = t145;
    const uint32_t t146 = state->clean;
    const uint32_t t147 = (t146 < 125U) ? (t146 + 1U) : 125U;
    const uint32_t t148 = work->flags[3] ? t147 : 0U;
    const uint32_t t150 = t134 ? 125U : t148;
    state->clean = t150;

    /* the estimate */
    const int t153 = 113U < t145;
    const int t154 = 124U < t150;
    const two_mass_kalman_status t158 = t154 ? TWO_MASS_KALMAN_CONVERGED : TWO_MASS_KALMAN_COASTING;
    work->t159 = t153 ? t158 : TWO_MASS_KALMAN_CONVERGING;
}

void two_mass_kalman_init(two_mass_kalman_state *state)
{
    state->motor_angle = 0.0;
    state->load_angle = 0.0;
    state->motor_speed = 0.0;
    state->load_speed = 0.0;
    state->good = 0U;
    state->clean = 0U;
    state->last_known0 = 0.0;
    state->last_torque = 0.0;
}

void two_mass_kalman_step(two_mass_kalman_state *state, const two_mass_kalman_measurements *measurements,
                          const two_mass_kalman_inputs *inputs, two_mass_kalman_estimate *estimate)
{
    two_mass_kalman_work work;
    two_mass_kalman_part_1(state, measurements, inputs, &work);
    two_mass_kalman_part_2(state, &work);

    estimate->motor_angle = work.t136;
    estimate->load_angle = work.t138;
    estimate->motor_speed = work.t139;
    estimate->load_speed = work.t140;
    estimate->status = work.t159;
}
