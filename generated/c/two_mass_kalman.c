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
    double t108;
    double t109;
    double t110;
    double t111;
    double t128;
    double t130;
    double t131;
    double t132;
    two_mass_kalman_status t149;
    int flags[2]; /* t8, t82 */
} two_mass_kalman_work;

/* Part 1 of a step. */
static void two_mass_kalman_part_1(two_mass_kalman_state *state, const two_mass_kalman_measurements *measurements, const two_mass_kalman_inputs *inputs, two_mass_kalman_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    work->t0 = measurements->motor_angle;
    const int t1 = (-628.3185307179587 <= work->t0) && (work->t0 <= 628.3185307179587);
    work->t2 = measurements->load_angle;
    const int t3 = (-628.3185307179587 <= work->t2) && (work->t2 <= 628.3185307179587);
    const double t4 = inputs->torque;
    const int t5 = (-1e303 <= t4) && (t4 <= 1e303);
    const double t6 = state->last_torque;
    const double t7 = t5 ? t4 : t6;
    state->last_torque = t7;
    work->flags[0] = t1 && t3;

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
    const double t30 = t27 + t29;
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
    const double t47 = t44 + t46;
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
    const double t64 = t61 + t63;
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
    const double t81 = t78 + t80;
    state->last_known0 = t7;
    work->flags[1] = t5 && work->flags[0];

    /* correction by the innovation */
    const double t84 = work->t0 - t30;
    const double t85 = t1 ? t84 : 0.0;
    const double t86 = work->t2 - t47;
    const double t87 = t3 ? t86 : 0.0;
    const double t89 = 0.6252170978732445 * t85;
    const double t91 = 0.002542111325138867 * t87;
    const double t92 = t89 + t91;
    const double t94 = 0.050842226502777345 * t85;
    const double t96 = 0.23729546780627317 * t87;
    const double t97 = t94 + t96;
    const double t99 = 588.5924566111323 * t85;
    const double t101 = 7.518009944344432 * t87;
    const double t102 = t99 + t101;
    const double t104 = 15.768605939992751 * t85;
    const double t106 = 64.50265025518871 * t87;
    const double t107 = t104 + t106;
    work->t108 = t30 + t92;
    work->t109 = t47 + t97;
    work->t110 = t64 + t102;
    work->t111 = t81 + t107;
}

/* Part 2 of a step. */
static void two_mass_kalman_part_2(two_mass_kalman_state *state, two_mass_kalman_work *work)
{
    /* the first sample starts the observer; so does a state beyond all bounds */
    const uint32_t t113 = state->good;
    const int t114 = t113 == 0U;
    const int t115 = (-1e303 <= work->t108) && (work->t108 <= 1e303);
    const int t116 = !t115;
    const int t117 = t114 || t116;
    const int t118 = (-1e303 <= work->t109) && (work->t109 <= 1e303);
    const int t119 = !t118;
    const int t120 = t117 || t119;
    const int t121 = (-1e303 <= work->t110) && (work->t110 <= 1e303);
    const int t122 = !t121;
    const int t123 = t120 || t122;
    const int t124 = (-1e303 <= work->t111) && (work->t111 <= 1e303);
    const int t125 = !t124;
    const int t126 = t123 || t125;
    const double t127 = work->flags[0] ? work->t0 : 0.0;
    work->t128 = t126 ? t127 : work->t108;
    state->motor_angle = work->t128;
    const double t129 = work->flags[0] ? work->t2 : 0.0;
    work->t130 = t126 ? t129 : work->t109;
    state->load_angle = work->t130;
    work->t131 = t126 ? 0.0 : work->t110;
    state->motor_speed = work->t131;
    work->t132 = t126 ? 0.0 : work->t111;
    state->load_speed = work->t132;
    const uint32_t t134 = work->flags[0] ? 1U : 0U;
    const uint32_t t135 = (t113 < 102U) ? (t113 + 1U) : 102U;
    const uint32_t t136 = work->flags[0] ? t135 : t113;
    const uint32_t t137 = t126 ? t134 : t136;
    state->good = t137;
    const uint32_t t138 = state->clean;
    const uint32_t t139 = (t138 < 102U) ? (t138 + 1U) : 102U;
    const uint32_t t140 = work->flags[1] ? t139 : 0U;
    const uint32_t t141 = t126 ? t134 : t140;
    state->clean = t141;

    /* the estimate */
    const int t146 = 101U < t137;
    const int t147 = 101U < t141;
    const two_mass_kalman_status t148 = t147 ? TWO_MASS_KALMAN_CONVERGED : TWO_MASS_KALMAN_COASTING;
    work->t149 = t146 ? t148 : TWO_MASS_KALMAN_CONVERGING;
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

    estimate->motor_angle = work.t128;
    estimate->load_angle = work.t130;
    estimate->motor_speed = work.t131;
    estimate->load_speed = work.t132;
    estimate->status = work.t149;
}
