/* car_rates.c: Finite-time observer: Speed and position of a car: wheel speed at 50 Hz, position at 10 Hz, acceleration with an offset.
 *
 * Generated; car_rates.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "car_rates.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "car_rates.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "car_rates.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* gain by calls since every output was due
 *   [0] x from speed
 *   [1] x from position
 *   [2] v from speed
 *   [3] v from position
 *   [4] offset from speed
 *   [5] offset from position
 */
static const double CAR_RATES_GAINS[5][6] = {
    {
        0.015129272474383794, 0.11527434555479144, 0.17465316476530426, 0.00015129272474383794,
        0.1573515016141616, 0.00013210134420497634
    },
    { 0.015671345542865096, 0.0, 0.17465408798692864, 0.0, 0.15735233476099464, 0.0 },
    { 0.016126872147142004, 0.0, 0.17465473978734372, 0.0, 0.15735291053103065, 0.0 },
    { 0.016509533096269544, 0.0, 0.17465519961704679, 0.0, 0.15735330645990822, 0.0 },
    { 0.016830849649174643, 0.0, 0.17465552373110288, 0.0, 0.15735357706390735, 0.0 }
};

/* What one part of a step hands to the next. */
typedef struct {
    double t0;
    double t2;
    double t58;
    double t59;
    double t60;
    double t73;
    double t75;
    double t76;
    car_rates_status t95;
    int flags[3]; /* t32, t33, t34 */
} car_rates_work;

/* Part 1 of a step. */
static void car_rates_part_1(car_rates_state *state, const car_rates_measurements *measurements, const car_rates_inputs *inputs, car_rates_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    work->t0 = measurements->speed;
    const int t1 = (-1e306 <= work->t0) && (work->t0 <= 1e306);
    work->t2 = measurements->position;
    const int t3 = (-1e306 <= work->t2) && (work->t2 <= 1e306);
    const double t4 = inputs->a;
    const int t5 = (-1e306 <= t4) && (t4 <= 1e306);
    const double t6 = state->last_a;
    const double t7 = t5 ? t4 : t6;
    const uint32_t t10 = state->until_position;
    const int t11 = t10 == 0U;
    const uint32_t t12 = (t10 > 0U) ? (t10 - 1U) : 0U;
    const uint32_t t13 = t11 ? 4U : t12;
    state->until_position = t13;
    const int t14 = t3 && t11;

    /* prediction by the plant */
    const double t15 = state->x;
    const double t16 = state->v;
    const double t17 = state->offset;
    const double t19 = 0.02 * t16;
    const double t21 = 0.0002 * t17;
    const double t22 = 0.0002 * t7;
    const double t23 = t15 + t19;
    const double t24 = t23 + t21;
    const double t25 = t24 + t22;
    const double t26 = 0.02 * t17;
    const double t27 = 0.02 * t7;
    const double t28 = t16 + t26;
    const double t29 = t28 + t27;
    const int t30 = !t11;
    const int t31 = t14 || t30;
    work->flags[0] = t1 && t31;
    work->flags[1] = t1 && t14;
    state->last_a = t7;
    work->flags[2] = t5 && work->flags[0];

    /* correction by the innovation */
    const double t36 = work->t0 - t29;
    const double t37 = t1 ? t36 : 0.0;
    const double t38 = work->t2 - t25;
    const double t39 = t14 ? t38 : 0.0;
    const uint32_t t40 = state->phase;
    const uint32_t t41 = (t40 < 4U) ? t40 : 4U;
    const uint32_t t42 = (t41 < 4U) ? (t41 + 1U) : 0U;
    state->phase = t42;
    const double t43 = CAR_RATES_GAINS[t41][0];
    const double t44 = t43 * t37;
    const double t45 = CAR_RATES_GAINS[t41][1];
    const double t46 = t45 * t39;
    const double t47 = t44 + t46;
    const double t48 = CAR_RATES_GAINS[t41][2];
    const double t49 = t48 * t37;
    const double t50 = CAR_RATES_GAINS[t41][3];
    const double t51 = t50 * t39;
    const double t52 = t49 + t51;
    const double t53 = CAR_RATES_GAINS[t41][4];
    const double t54 = t53 * t37;
    const double t55 = CAR_RATES_GAINS[t41][5];
    const double t56 = t55 * t39;
    const double t57 = t54 + t56;
    work->t58 = t25 + t47;
    work->t59 = t29 + t52;
    work->t60 = t17 + t57;
}

/* Part 2 of a step. */
static void car_rates_part_2(car_rates_state *state, car_rates_work *work)
{
    /* the first sample starts the observer; so does a state beyond all bounds */
    const uint32_t t61 = state->good;
    const int t62 = t61 == 0U;
    const int t63 = (-1e306 <= work->t58) && (work->t58 <= 1e306);
    const int t64 = !t63;
    const int t65 = t62 || t64;
    const int t66 = (-1e306 <= work->t59) && (work->t59 <= 1e306);
    const int t67 = !t66;
    const int t68 = t65 || t67;
    const int t69 = (-1e306 <= work->t60) && (work->t60 <= 1e306);
    const int t70 = !t69;
    const int t71 = t68 || t70;
    const double t72 = work->flags[1] ? work->t2 : 0.0;
    work->t73 = t71 ? t72 : work->t58;
    state->x = work->t73;
    const double t74 = work->flags[1] ? work->t0 : 0.0;
    work->t75 = t71 ? t74 : work->t59;
    state->v = work->t75;
    work->t76 = t71 ? 0.0 : work->t60;
    state->offset = work->t76;
    const uint32_t t78 = work->flags[1] ? 1U : 0U;
    const uint32_t t79 = (t61 < 694U) ? (t61 + 1U) : 694U;
    const uint32_t t80 = work->flags[0] ? t79 : t61;
    const uint32_t t81 = t71 ? t78 : t80;
    state->good = t81;
    const uint32_t t82 = state->clean;
    const uint32_t t83 = (t82 < 881U) ? (t82 + 1U) : 881U;
    const uint32_t t84 = work->flags[2] ? t83 : 0U;
    const uint32_t t86 = t71 ? 881U : t84;
    state->clean = t86;

    /* the estimate */
    const int t89 = 693U < t81;
    const int t90 = 880U < t86;
    const car_rates_status t94 = t90 ? CAR_RATES_CONVERGED : CAR_RATES_COASTING;
    work->t95 = t89 ? t94 : CAR_RATES_CONVERGING;
}

void car_rates_init(car_rates_state *state)
{
    state->x = 0.0;
    state->v = 0.0;
    state->offset = 0.0;
    state->good = 0U;
    state->clean = 0U;
    state->last_a = 0.0;
    state->phase = 0U;
    state->until_position = 0U;
}

void car_rates_step(car_rates_state *state, const car_rates_measurements *measurements,
                    const car_rates_inputs *inputs, car_rates_estimate *estimate)
{
    car_rates_work work;
    car_rates_part_1(state, measurements, inputs, &work);
    car_rates_part_2(state, &work);

    estimate->x = work.t73;
    estimate->v = work.t75;
    estimate->offset = work.t76;
    estimate->status = work.t95;
}
