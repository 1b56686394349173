/* counter.c: Finite-time observer: Speed and acceleration from a counter of 32 bits that may overflow.
 *
 * Generated; counter.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "counter.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "counter.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "counter.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* weights by age, from age 1
 *   [0] x from y
 *   [1] v from y
 *   [2] a from y
 */
static const float COUNTER_WINDOW[20][3] = {
    { 0.28966686f, 51.214005f, 3952.569f },
    { 0.22868437f, 34.758835f, 2436.9224f },
    { 0.1733484f, 20.086779f, 1099.5869f },
    { 0.12365895f, 7.1978364f, -59.43713f },
    { 0.07961603f, -3.9079914f, -1040.1498f },
    { 0.04121965f, -13.230705f, -1842.551f },
    { 0.008469791f, -20.770306f, -2466.6409f },
    { -0.01863354f, -26.52679f, -2912.4194f },
    { -0.040090345f, -30.500164f, -3179.8865f },
    { -0.055900622f, -32.690422f, -3269.0422f },
    { -0.06606437f, -33.097565f, -3179.8865f },
    { -0.07058159f, -31.721596f, -2912.4194f },
    { -0.069452286f, -28.562513f, -2466.6409f },
    { -0.06267645f, -23.620316f, -1842.551f },
    { -0.050254095f, -16.895004f, -1040.1498f },
    { -0.032185204f, -8.3865795f, -59.43713f },
    { -0.008469791f, 1.90496f, 1099.5869f },
    { 0.02089215f, 13.979613f, 2436.9224f },
    { 0.055900622f, 27.83738f, 3952.569f },
    { 0.09655562f, 43.47826f, 5646.5273f }
};

/* x towards zero as a signed number, two's complement, as far as single precision has them; NaN as 0. */
static uint32_t counter_index_from_f32(float x)
{
    if (x >= 2147483520.0f) {
        return 2147483520U;
    }
    if (x <= -2147483648.0f) {
        return 2147483648U;
    }
    if (x > 0.0f) {
        return (uint32_t)x;
    }
    return (x < 0.0f) ? (0U - (uint32_t)(-x)) : 0U;
}

/* What one part of a step hands to the next. */
typedef struct {
    uint32_t t8;
    uint32_t t56;
    float t59;
    uint32_t t62;
    uint32_t t70;
    float t106;
    float t107;
    float t108;
    counter_status t115;
} counter_work;

/* Part 1 of a step. */
static void counter_part_1(counter_state *state, const counter_measurements *measurements, counter_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    const uint32_t t0 = state->newest;
    const uint32_t t1 = (t0 < 20U) ? t0 : 20U;
    const uint32_t t2 = state->count;
    const int t4 = 20U < t2;
    const uint32_t t5 = (uint32_t)measurements->y;

    /* prediction, for a sample that is missing */
    work->t8 = (t1 < 20U) ? (t1 + 1U) : 0U;
    const float t9 = state->ahead_y;
    const uint32_t t10 = state->y[t1];
    const uint32_t t11 = t10 - 0U;
    const float t12 = (t11 < 2147483648U) ? (float)t11 : -(float)(0U - t11);
    const float t13 = 1e-6f * t12;
    const float t14 = t13 + t9;
    const float t16 = t14 * 0.00023283064f;
    const float t18 = t16 + 1.2582912e7f;
    const float t19 = t18 - 1.2582912e7f;
    const float t21 = t19 * 4294.9673f;
    const float t22 = t14 - t21;
    const uint32_t t23 = t5 - t10;
    const float t24 = (t23 < 2147483648U) ? (float)t23 : -(float)(0U - t23);
    const float t25 = 1e-6f * t24;
    const float t26 = t25 - t9;
    const float t27 = t26 * 0.00023283064f;
    const float t28 = t27 + 1.2582912e7f;
    const float t29 = t28 - 1.2582912e7f;
    const float t30 = t29 * 4294.9673f;
    const float t31 = t26 - t30;
    const int t32 = (-4294.9673f <= t22) && (t22 <= 4294.9673f);
    const int t33 = (-0.001f <= t31) && (t31 <= 0.001f);
    const int t34 = !t33;
    const int t35 = t32 && t34;
    const int t36 = t4 && t35;
    const uint32_t t37 = state->rejected_y;
    const int t39 = t37 < 19U;
    const int t40 = t36 && t39;
    const uint32_t t41 = (t37 < 20U) ? (t37 + 1U) : 20U;
    const uint32_t t42 = t40 ? t41 : 0U;
    state->rejected_y = t42;
    const int t43 = !t40;
    const int t44 = !t39;
    const int t45 = t36 && t44;
    const int t46 = t4 && t32;
    const int t47 = t43 || t46;
    const int t48 = !t47;
    const float t50 = t9 * 1000000.0f;
    const float t51 = t50 + 1.2582912e7f;
    const float t52 = t51 - 1.2582912e7f;
    const uint32_t t53 = counter_index_from_f32(t52);
    const uint32_t t54 = t10 + t53;
    const uint32_t t55 = t46 ? t54 : t10;
    work->t56 = t43 ? t5 : t55;
    const uint32_t t57 = work->t56 - 0U;
    const float t58 = (t57 < 2147483648U) ? (float)t57 : -(float)(0U - t57);
    work->t59 = 1e-6f * t58;
    const uint32_t t60 = state->since;
    const uint32_t t61 = (t60 < 4294967295U) ? (t60 + 1U) : 4294967295U;
    work->t62 = t43 ? 0U : t61;
    state->since = work->t62;

    /* how much of the window is good */
    const int t63 = !t45;
    const int t64 = t4 && t63;
    const uint32_t t66 = (t2 < 21U) ? (t2 + 1U) : 21U;
    const uint32_t t67 = t48 ? 0U : t66;
    const uint32_t t68 = t63 ? t66 : 1U;
    const uint32_t t69 = t43 ? t68 : 0U;
    work->t70 = t64 ? t67 : t69;
    state->count = work->t70;
    const uint32_t t71 = state->coasting;
    const uint32_t t72 = (t71 > 0U) ? (t71 - 1U) : 0U;
    const uint32_t t74 = t43 ? t72 : 21U;
    state->coasting = t74;

    /* into the window */
    state->newest = work->t8;
    state->y[work->t8] = work->t56;
}

/* Part 2 of a step. */
static void counter_part_2(counter_state *state, counter_work *work)
{
    /* the sums over the window, newest sample first */
    const uint32_t t76 = ((work->t8 >= 1U) && (work->t8 < 21U)) ? (work->t8 - 1U) : 20U;
    float t77 = 0.0f;
    float t78 = 0.0f;
    float t79 = 0.0f;
    uint32_t t80 = t76;
    uint32_t t81 = work->t56;
    float t82 = 0.0f;
    for (uint32_t row = 0U; row < 20U; ++row) {
        const float *const gains = COUNTER_WINDOW[row];
        const uint32_t t83 = state->y[t80];
        const uint32_t t84 = t83 - t81;
        const float t85 = (t84 < 2147483648U) ? (float)t84 : -(float)(0U - t84);
        const float t86 = t82 + t85;
        const float t87 = 1e-6f * t86;
        const float t88 = gains[0];
        const float t89 = t88 * t87;
        const float t90 = t77 + t89;
        const float t91 = gains[1];
        const float t92 = t91 * t87;
        const float t93 = t78 + t92;
        const float t94 = gains[2];
        const float t95 = t94 * t87;
        const float t96 = t79 + t95;
        const uint32_t t97 = ((t80 >= 1U) && (t80 < 21U)) ? (t80 - 1U) : 20U;
        t77 = t90;
        t78 = t93;
        t79 = t96;
        t80 = t97;
        t81 = t83;
        t82 = t86;
    }

    /* the next measurement, as far as it is known */
    const float t99 = 0.001f * t78;
    const float t101 = 5e-7f * t79;
    const float t102 = t77 + t99;
    const float t103 = t102 + t101;
    state->ahead_y = t103;

    /* the estimate; until the window is full, the start */
    const float t104 = t77 + work->t59;
    const int t105 = 20U < work->t70;
    work->t106 = t105 ? t104 : work->t59;
    work->t107 = t105 ? t78 : 0.0f;
    work->t108 = t105 ? t79 : 0.0f;
    const uint32_t t109 = state->coasting;
    const int t110 = t109 == 0U;
    const counter_status t114 = t110 ? COUNTER_CONVERGED : COUNTER_COASTING;
    work->t115 = t105 ? t114 : COUNTER_CONVERGING;
}

void counter_init(counter_state *state)
{
    for (uint32_t slot = 0U; slot < 21U; ++slot) {
        state->y[slot] = 0U;
    }
    state->newest = 20U;
    state->count = 0U;
    state->rejected_y = 0U;
    state->coasting = 0U;
    state->ahead_y = 0.0f;
    state->since = 0U;
}

void counter_step(counter_state *state, const counter_measurements *measurements,
                  counter_estimate *estimate)
{
    counter_work work;
    counter_part_1(state, measurements, &work);
    counter_part_2(state, &work);

    estimate->x = work.t106;
    estimate->v = work.t107;
    estimate->a = work.t108;
    estimate->coasted = work.t62;
    estimate->status = work.t115;
}
