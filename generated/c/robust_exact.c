/* robust_exact.c: Finite-time observer: Speed and acceleration of an axis of unknown mechanics, from its encoder.
 *
 * Generated; robust_exact.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "robust_exact.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "robust_exact.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "robust_exact.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* powers of two for the start of Newton's method
 *   [0] 2^(n k)
 *   [1] 2^(-n k)
 *   [2] 2^k
 */
static const float ROBUST_EXACT_SCALES[6][3] = {
    { 7.9228163e28f, 1.2621775e-29f, 4.2949673e9f },
    { 2.8147498e14f, 3.5527137e-15f, 65536.0f },
    { 1.6777216e7f, 5.9604645e-8f, 256.0f },
    { 4096.0f, 0.00024414063f, 16.0f },
    { 64.0f, 0.015625f, 4.0f },
    { 8.0f, 0.125f, 2.0f }
};

/* What one part of a step hands to the next. */
typedef struct {
    float t0;
    float t9;
    float t61;
    float t62;
    float t63;
    float t80;
    float t99;
    float t101;
    robust_exact_status t109;
    int flags[1]; /* t1 */
} robust_exact_work;

/* Part 1 of a step. */
static void robust_exact_part_1(const robust_exact_state *state, const robust_exact_measurements *measurements, robust_exact_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    work->t0 = measurements->angle;
    work->flags[0] = (-6.2831855f <= work->t0) && (work->t0 <= 6.2831855f);

    /* prediction by the plant */
    const float t2 = state->xi1;
    const float t3 = state->xi2;
    const float t4 = state->xi3;
    const float t5 = t3 + t4;
    const float t6 = t2 + t5;

    /* correction by the innovation */
    const float t8 = work->t0 - t6;
    work->t9 = work->flags[0] ? t8 : 0.0f;
    const int t10 = work->t9 <= 0.0f;
    const float t11 = 0.0f - work->t9;
    const float t12 = t10 ? t11 : work->t9;
    const int t14 = 5.5e-5f < t12;
    const float t15 = t14 ? 5.5e-5f : t12;
    const float t16 = t12 - t15;
    const float t18 = t16 * 18181.818f;
    float t20 = t18;
    float t21 = 1.0f;
    for (uint32_t row = 0U; row < 6U; ++row) {
        const float *const gains = ROBUST_EXACT_SCALES[row];
        const float t22 = gains[0];
        const float t23 = gains[1];
        const float t24 = gains[2];
        const int t25 = t22 <= t20;
        const float t26 = t20 * t23;
        const float t27 = t21 * t24;
        const float t28 = t25 ? t26 : t20;
        const float t29 = t25 ? t27 : t21;
        t20 = t28;
        t21 = t29;
    }
    const float t31 = 2.0f * t21;
    const float t33 = t18 / 1.9907243f;
    const int t34 = t31 < t33;
    const float t35 = t34 ? t31 : t33;
    float t37 = t35;
    for (uint32_t row = 0U; row < 7U; ++row) {
        const float t38 = t37 + 1.9374586f;
        const float t39 = t37 + t38;
        const float t40 = t38 * t37;
        const float t41 = t40 + 1.9907243f;
        const float t42 = t39 * t37;
        const float t43 = t42 + t41;
        const float t44 = t41 * t37;
        const float t45 = t44 - t18;
        const float t46 = t45 / t43;
        const float t47 = t37 - t46;
        t37 = t47;
    }
    const int t49 = work->t9 < 0.0f;
    const float t50 = t49 ? -1.0f : 1.0f;
    const float t51 = t50 * t15;
    const float t53 = 0.00010948984f * t37;
    const float t54 = t15 + t53;
    const float t55 = t50 * t54;
    const float t56 = t37 * t37;
    const float t58 = 0.00010656023f * t56;
    const float t59 = t54 + t58;
    const float t60 = t50 * t59;
    work->t61 = t6 + t60;
    work->t62 = t5 + t55;
    work->t63 = t4 + t51;
}

/* Part 2 of a step. */
static void robust_exact_part_2(robust_exact_state *state, robust_exact_work *work)
{
    /* the first sample starts the observer; so does a state beyond all bounds */
    const uint32_t t65 = state->good;
    const int t66 = t65 == 0U;
    const int t67 = (-12.566371f <= work->t9) && (work->t9 <= 12.566371f);
    const int t68 = !t67;
    const int t69 = t66 || t68;
    const int t70 = (-1e25f <= work->t61) && (work->t61 <= 1e25f);
    const int t71 = !t70;
    const int t72 = t69 || t71;
    const int t73 = (-1e25f <= work->t62) && (work->t62 <= 1e25f);
    const int t74 = !t73;
    const int t75 = t72 || t74;
    const int t76 = (-1e25f <= work->t63) && (work->t63 <= 1e25f);
    const int t77 = !t76;
    const int t78 = t75 || t77;
    const float t79 = work->flags[0] ? work->t0 : 0.0f;
    work->t80 = t78 ? t79 : work->t61;
    state->xi1 = work->t80;
    const float t81 = t78 ? 0.0f : work->t62;
    state->xi2 = t81;
    const float t82 = t78 ? 0.0f : work->t63;
    state->xi3 = t82;
    const int t83 = (-0.001655f <= work->t9) && (work->t9 <= 0.001655f);
    const uint32_t t85 = work->flags[0] ? 1U : 0U;
    const uint32_t t86 = (t65 < 4U) ? (t65 + 1U) : 4U;
    const uint32_t t87 = t83 ? t86 : 1U;
    const uint32_t t88 = work->flags[0] ? t87 : t65;
    const uint32_t t89 = t78 ? t85 : t88;
    state->good = t89;
    const uint32_t t90 = state->clean;
    const uint32_t t91 = (t90 < 4U) ? (t90 + 1U) : 4U;
    const uint32_t t92 = t83 ? t91 : 1U;
    const uint32_t t93 = work->flags[0] ? t92 : 0U;
    const uint32_t t94 = t78 ? t85 : t93;
    state->clean = t94;

    /* the estimate */
    const float t96 = 200.0f * t81;
    const float t98 = 100.0f * t82;
    work->t99 = t96 + t98;
    work->t101 = 40000.0f * t82;
    const int t106 = 3U < t89;
    const int t107 = 3U < t94;
    const robust_exact_status t108 = t107 ? ROBUST_EXACT_CONVERGED : ROBUST_EXACT_COASTING;
    work->t109 = t106 ? t108 : ROBUST_EXACT_CONVERGING;
}

void robust_exact_init(robust_exact_state *state)
{
    state->xi1 = 0.0f;
    state->xi2 = 0.0f;
    state->xi3 = 0.0f;
    state->good = 0U;
    state->clean = 0U;
}

void robust_exact_step(robust_exact_state *state, const robust_exact_measurements *measurements,
                       robust_exact_estimate *estimate)
{
    robust_exact_work work;
    robust_exact_part_1(state, measurements, &work);
    robust_exact_part_2(state, &work);

    estimate->angle = work.t80;
    estimate->dangle = work.t99;
    estimate->d2angle = work.t101;
    estimate->status = work.t109;
}
