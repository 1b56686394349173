/* camera_prescribed.c: Finite-time observer: The same part, its position and velocity 0.4 s after the camera first sees it.
 *
 * Generated; camera_prescribed.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "camera_prescribed.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "camera_prescribed.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "camera_prescribed.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* What one part of a step hands to the next. */
typedef struct {
    double t78;
    double t79;
    uint32_t t86;
    uint32_t t91;
    camera_prescribed_status t99;
} camera_prescribed_work;

/* Part 1 of a step. */
static void camera_prescribed_part_1(camera_prescribed_state *state, const camera_prescribed_measurements *measurements, const camera_prescribed_inputs *inputs, camera_prescribed_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    const double t0 = measurements->x;
    const int t1 = (-1.0 <= t0) && (t0 <= 2.0);
    const double t2 = inputs->i;
    const int t3 = (-1e305 <= t2) && (t2 <= 1e305);
    const double t4 = state->last_i;
    const double t5 = t3 ? t2 : t4;
    const uint32_t t8 = state->until_x;
    const int t9 = t8 == 0U;
    const uint32_t t10 = (t8 > 0U) ? (t8 - 1U) : 0U;
    const uint32_t t11 = t9 ? 7U : t10;
    state->until_x = t11;
    const int t12 = t1 && t9;

    /* prediction by the plant */
    const double t13 = state->x;
    const double t14 = state->v;
    const double t16 = 0.004968879802447429 * t14;
    const double t18 = 4.979231608411396e-5 * t5;
    const double t19 = t13 + t16;
    const double t20 = t19 + t18;
    const double t22 = 0.9875778004938814 * t14;
    const double t24 = 0.019875519209789715 * t5;
    const double t25 = t22 + t24;
    const int t26 = !t9;
    const int t27 = t12 || t26;
    state->last_i = t5;
    const int t28 = t3 && t27;

    /* correction by the innovation */
    const int t29 = (-1.0 <= t20) && (t20 <= 2.0);
    const int t30 = t12 || t29;
    const int t31 = !t30;
    const double t33 = t0 - t20;
    const double t34 = t12 ? t33 : 0.0;
    const uint32_t t35 = state->left;
    const uint32_t t36 = (t35 < 8U) ? t35 : 8U;
    const uint32_t t37 = (t36 > 0U) ? (t36 - 1U) : 0U;
    const uint32_t t38 = t12 ? t37 : t36;
    const double t39 = (double)t38;
    const double t41 = 0.25 * t39;
    const double t43 = t41 + 0.5;
    const double t44 = t43 * t43;
    const double t46 = 5.0 * t43;
    const double t48 = t46 + 6.25;
    const double t49 = t44 + t48;
    const double t50 = t34 / t49;
    const double t51 = t48 * t50;
    const double t52 = 6.25 * t50;
    const double t54 = 1.1051709180756477 * t51;
    const double t56 = -0.10517091807564763 * t34;
    const double t57 = t54 + t56;
    const double t59 = -2.7629272951891193 * t51;
    const double t61 = 26.270829861937624 * t52;
    const double t63 = 0.26292729518911906 * t34;
    const double t64 = t59 + t61;
    const double t65 = t64 + t63;
    const double t66 = t20 + t57;
    const double t67 = t25 + t65;

    /* the first sample starts the observer; so does a state beyond all bounds */
    const uint32_t t68 = state->good;
    const int t69 = t68 == 0U;
    const int t70 = t69 || t31;
    const int t71 = (-1e305 <= t66) && (t66 <= 1e305);
    const int t72 = !t71;
    const int t73 = t70 || t72;
    const int t74 = (-1e305 <= t67) && (t67 <= 1e305);
    const int t75 = !t74;
    const int t76 = t73 || t75;
    const double t77 = t12 ? t0 : 0.0;
    work->t78 = t76 ? t77 : t66;
    state->x = work->t78;
    work->t79 = t76 ? 0.0 : t67;
    state->v = work->t79;
    const uint32_t t81 = t76 ? 8U : t38;
    state->left = t81;
    const uint32_t t83 = t12 ? 1U : 0U;
    const uint32_t t84 = (t68 < 9U) ? (t68 + 1U) : 9U;
    const uint32_t t85 = t12 ? t84 : t68;
    work->t86 = t76 ? t83 : t85;
    state->good = work->t86;
    const uint32_t t87 = state->clean;
    const uint32_t t88 = (t87 < 67U) ? (t87 + 1U) : 67U;
    const uint32_t t89 = t28 ? t88 : 0U;
    work->t91 = t76 ? 67U : t89;
    state->clean = work->t91;
}

/* Part 2 of a step. */
static void camera_prescribed_part_2(camera_prescribed_work *work)
{
    /* the estimate */
    const int t93 = 8U < work->t86;
    const int t94 = 66U < work->t91;
    const camera_prescribed_status t98 = t94 ? CAMERA_PRESCRIBED_CONVERGED : CAMERA_PRESCRIBED_COASTING;
    work->t99 = t93 ? t98 : CAMERA_PRESCRIBED_CONVERGING;
}

void camera_prescribed_init(camera_prescribed_state *state)
{
    state->x = 0.0;
    state->v = 0.0;
    state->left = 8U;
    state->good = 0U;
    state->clean = 0U;
    state->last_i = 0.0;
    state->until_x = 0U;
}

void camera_prescribed_step(camera_prescribed_state *state, const camera_prescribed_measurements *measurements,
                            const camera_prescribed_inputs *inputs, camera_prescribed_estimate *estimate)
{
    camera_prescribed_work work;
    camera_prescribed_part_1(state, measurements, inputs, &work);
    camera_prescribed_part_2(&work);

    estimate->x = work.t78;
    estimate->v = work.t79;
    estimate->status = work.t99;
}
