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
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
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
    float t12;
    float t64;
    float t65;
    float t66;
    float t84;
    float t104;
    float t106;
    robust_exact_status t114;
    int flags[2]; /* t1, t9 */
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
    const int t7 = (-6.2831855f <= t6) && (t6 <= 6.2831855f);
    const int t8 = work->flags[0] || t7;
    work->flags[1] = !t8;
    const float t11 = work->t0 - t6;
    work->t12 = work->flags[0] ? t11 : 0.0f;
    const int t13 = work->t12 <= 0.0f;
    const float t14 = 0.0f - work->t12;
    const float t15 = t13 ? t14 : work->t12;
    const int t17 = 5.5e-5f < t15;
    const float t18 = t17 ? 5.5e-5f : t15;
    const float t19 = t15 - t18;
    const float t21 = t19 * 18181.818f;
    float t23 = t21;
    float t24 = 1.0f;
    for (uint32_t row = 0U; row < 6U; ++row) {
        const float *const gains = ROBUST_EXACT_SCALES[row];
        const float t25 = gains[0];
        const float t26 = gains[1];
        const float t27 = gains[2];
        const int t28 = t25 <= t23;
        const float t29 = t23 * t26;
        const float t30 = t24 * t27;
        const float t31 = t28 ? t29 : t23;
        const float t32 = t28 ? t30 : t24;
        t23 = t31;
        t24 = t32;
    }
    const float t34 = 2.0f * t24;
    const float t36 = t21 / 1.9907243f;
    const int t37 = t34 < t36;
    const float t38 = t37 ? t34 : t36;
    float t40 = t38;
    for (uint32_t row = 0U; row < 7U; ++row) {
        const float t41 = t40 + 1.9374586f;
        const float t42 = t40 + t41;
        const float t43 = t41 * t40;
        const float t44 = t43 + 1.9907243f;
        const float t45 = t42 * t40;
        const float t46 = t45 + t44;
        const float t47 = t44 * t40;
        const float t48 = t47 - t21;
        const float t49 = t48 / t46;
        const float t50 = t40 - t49;
        t40 = t50;
    }
    const int t52 = work->t12 < 0.0f;
    const float t53 = t52 ? -1.0f : 1.0f;
    const float t54 = t53 * t18;
    const float t56 = 0.00010948984f * t40;
    const float t57 = t18 + t56;
    const float t58 = t53 * t57;
    const float t59 = t40 * t40;
    const float t61 = 0.00010656023f * t59;
    const float t62 = t57 + t61;
    const float t63 = t53 * t62;
    work->t64 = t6 + t63;
    work->t65 = t5 + t58;
    work->t66 = t4 + t54;
}

/* Part 2 of a step. */
static void robust_exact_part_2(robust_exact_state *state, robust_exact_work *work)
{
    /* the first sample starts the observer; so does a state beyond all bounds */
    const uint32_t t68 = state->good;
    const int t69 = t68 == 0U;
    const int t70 = t69 || work->flags[1];
    const int t71 = (-12.566371f <= work->t12) && (work->t12 <= 12.566371f);
    const int t72 = !t71;
    const int t73 = t70 || t72;
    const int t74 = (-1e25f <= work->t64) && (work->t64 <= 1e25f);
    const int t75 = !t74;
    const int t76 = t73 || t75;
    const int t77 = (-1e25f <= work->t65) && (work->t65 <= 1e25f);
    const int t78 = !t77;
    const int t79 = t76 || t78;
    const int t80 = (-1e25f <= work->t66) && (work->t66 <= 1e25f);
    const int t81 = !t80;
    const int t82 = t79 || t81;
    const float t83 = work->flags[0] ? work->t0 : 0.0f;
    work->t84 = t82 ? t83 : work->t64;
    state->xi1 = work->t84;
    const float t85 = t82 ? 0.0f : work->t65;
    state->xi2 = t85;
    const float t86 = t82 ? 0.0f : work->t66;
    state->xi3 = t86;
    const int t87 = (-0.001655f <= work->t12) && (work->t12 <= 0.001655f);
    const uint32_t t89 = work->flags[0] ? 1U : 0U;
    const uint32_t t90 = (t68 < 4U) ? (t68 + 1U) : 4U;
    const uint32_t t91 = t87 ? t90 : 1U;
    const uint32_t t92 = work->flags[0] ? t91 : t68;
    const uint32_t t93 = t82 ? t89 : t92;
    state->good = t93;
    const uint32_t t94 = state->clean;
    const uint32_t t95 = (t94 < 4U) ? (t94 + 1U) : 4U;
    const uint32_t t96 = t87 ? t95 : 1U;
    const uint32_t t97 = work->flags[0] ? t96 : 0U;
    const uint32_t t99 = t82 ? 4U : t97;
    state->clean = t99;

    /* the estimate */
    const float t101 = 200.0f * t85;
    const float t103 = 100.0f * t86;
    work->t104 = t101 + t103;
    work->t106 = 40000.0f * t86;
    const int t108 = 3U < t93;
    const int t109 = 3U < t99;
    const robust_exact_status t113 = t109 ? ROBUST_EXACT_CONVERGED : ROBUST_EXACT_COASTING;
    work->t114 = t108 ? t113 : ROBUST_EXACT_CONVERGING;
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

    estimate->angle = work.t84;
    estimate->dangle = work.t104;
    estimate->d2angle = work.t106;
    estimate->status = work.t114;
}
