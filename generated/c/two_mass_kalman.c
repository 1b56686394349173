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
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
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
    double t28;
    double t45;
    double t62;
    double t79;
    double t135;
    double t137;
    double t138;
    double t139;
    two_mass_kalman_status t158;
    int flags[4]; /* t1, t3, t80, t81 */
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

    /* prediction by the plant */
    const double t8 = state->motor_angle;
    const double t9 = state->load_angle;
    const double t10 = state->motor_speed;
    const double t11 = state->load_speed;
    const double t13 = 0.9950249142262294 * t8;
    const double t15 = 0.004975085773770609 * t9;
    const double t17 = 0.0004966821156547011 * t10;
    const double t19 = 3.3178843452988937e-6 * t11;
    const double t21 = 8.293894840854371e-6 * t6;
    const double t23 = 4.154200521167732e-6 * t7;
    const double t24 = t13 + t15;
    const double t25 = t24 + t17;
    const double t26 = t19 + t21;
    const double t27 = t26 + t23;
    work->t28 = t25 + t27;
    const double t30 = 0.0009950171547541218 * t8;
    const double t32 = 0.9990049828452459 * t9;
    const double t34 = 6.635768690597788e-7 * t10;
    const double t36 = 0.0004993364231309402 * t11;
    const double t38 = 7.887698495792626e-9 * t6;
    const double t40 = 2.493229099786935e-9 * t7;
    const double t41 = t30 + t32;
    const double t42 = t41 + t34;
    const double t43 = t36 + t38;
    const double t44 = t43 + t40;
    work->t45 = t42 + t44;
    const double t47 = -19.840741551425655 * t8;
    const double t49 = 19.840741551425655 * t9;
    const double t51 = 0.9851045434505166 * t10;
    const double t53 = 0.014895456549483436 * t11;
    const double t55 = 0.024772020841425907 * t6;
    const double t57 = 0.024896190724044205 * t7;
    const double t58 = t47 + t49;
    const double t59 = t58 + t51;
    const double t60 = t53 + t55;
    const double t61 = t60 + t57;
    work->t62 = t59 + t61;
    const double t64 = 3.9681483102851307 * t8;
    const double t66 = -3.9681483102851307 * t9;
    const double t68 = 0.002979091309896687 * t10;
    const double t70 = 0.9970209086901033 * t11;
    const double t72 = 4.559583171481875e-5 * t6;
    const double t74 = 2.076185519115912e-5 * t7;
    const double t75 = t64 + t66;
    const double t76 = t75 + t68;
    const double t77 = t70 + t72;
    const double t78 = t77 + t74;
    work->t79 = t76 + t78;
    work->flags[2] = work->flags[0] && work->flags[1];
    state->last_torque = t7;
    work->flags[3] = t5 && work->flags[2];
}

/* Part 2 of a step. */
static void two_mass_kalman_part_2(two_mass_kalman_state *state, two_mass_kalman_work *work)
{
    /* correction by the innovation */
    const int t82 = (-628.3185307179587 <= work->t28) && (work->t28 <= 628.3185307179587);
    const int t83 = work->flags[0] || t82;
    const int t84 = !t83;
    const int t85 = (-628.3185307179587 <= work->t45) && (work->t45 <= 628.3185307179587);
    const int t86 = work->flags[1] || t85;
    const int t87 = !t86;
    const int t88 = t84 || t87;
    const double t90 = work->t0 - work->t28;
    const double t91 = work->flags[0] ? t90 : 0.0;
    const double t92 = work->t2 - work->t45;
    const double t93 = work->flags[1] ? t92 : 0.0;
    const double t95 = 0.6252170978732445 * t91;
    const double t97 = 0.002542111325138867 * t93;
    const double t98 = t95 + t97;
    const double t100 = 0.050842226502777345 * t91;
    const double t102 = 0.23729546780627317 * t93;
    const double t103 = t100 + t102;
    const double t105 = 588.5924566111323 * t91;
    const double t107 = 7.518009944344432 * t93;
    const double t108 = t105 + t107;
    const double t110 = 15.768605939992751 * t91;
    const double t112 = 64.50265025518871 * t93;
    const double t113 = t110 + t112;
    const double t114 = work->t28 + t98;
    const double t115 = work->t45 + t103;
    const double t116 = work->t62 + t108;
    const double t117 = work->t79 + t113;

    /* the first sample starts the observer; so does a state beyond all bounds */
    const uint32_t t119 = state->good;
    const int t120 = t119 == 0U;
    const int t121 = t120 || t88;
    const int t122 = (-1e303 <= t114) && (t114 <= 1e303);
    const int t123 = !t122;
    const int t124 = t121 || t123;
    const int t125 = (-1e303 <= t115) && (t115 <= 1e303);
    const int t126 = !t125;
    const int t127 = t124 || t126;
    const int t128 = (-1e303 <= t116) && (t116 <= 1e303);
    const int t129 = !t128;
    const int t130 = t127 || t129;
    const int t131 = (-1e303 <= t117) && (t117 <= 1e303);
    const int t132 = !t131;
    const int t133 = t130 || t132;
    const double t134 = work->flags[2] ? work->t0 : 0.0;
    work->t135 = t133 ? t134 : t114;
    state->motor_angle = work->t135;
    const double t136 = work->flags[2] ? work->t2 : 0.0;
    work->t137 = t133 ? t136 : t115;
    state->load_angle = work->t137;
    work->t138 = t133 ? 0.0 : t116;
    state->motor_speed = work->t138;
    work->t139 = t133 ? 0.0 : t117;
    state->load_speed = work->t139;
    const uint32_t t141 = work->flags[2] ? 1U : 0U;
    const uint32_t t142 = (t119 < 113U) ? (t119 + 1U) : 113U;
    const uint32_t t143 = work->flags[2] ? t142 : t119;
    const uint32_t t144 = t133 ? t141 : t143;
    state->good = t144;
    const uint32_t t145 = state->clean;
    const uint32_t t146 = (t145 < 125U) ? (t145 + 1U) : 125U;
    const uint32_t t147 = work->flags[3] ? t146 : 0U;
    const uint32_t t149 = t133 ? 125U : t147;
    state->clean = t149;

    /* the estimate */
    const int t152 = 112U < t144;
    const int t153 = 124U < t149;
    const two_mass_kalman_status t157 = t153 ? TWO_MASS_KALMAN_CONVERGED : TWO_MASS_KALMAN_COASTING;
    work->t158 = t152 ? t157 : TWO_MASS_KALMAN_CONVERGING;
}

void two_mass_kalman_init(two_mass_kalman_state *state)
{
    state->motor_angle = 0.0;
    state->load_angle = 0.0;
    state->motor_speed = 0.0;
    state->load_speed = 0.0;
    state->good = 0U;
    state->clean = 0U;
    state->last_torque = 0.0;
}

void two_mass_kalman_step(two_mass_kalman_state *state, const two_mass_kalman_measurements *measurements,
                          const two_mass_kalman_inputs *inputs, two_mass_kalman_estimate *estimate)
{
    two_mass_kalman_work work;
    two_mass_kalman_part_1(state, measurements, inputs, &work);
    two_mass_kalman_part_2(state, &work);

    estimate->motor_angle = work.t135;
    estimate->load_angle = work.t137;
    estimate->motor_speed = work.t138;
    estimate->load_speed = work.t139;
    estimate->status = work.t158;
}
