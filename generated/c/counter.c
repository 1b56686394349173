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
#pragma GCC optimize("fp-contract=off")
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

void counter_init(counter_state *state)
{
    for (uint32_t slot = 0U; slot < 21U; ++slot) {
        state->y[slot] = 0U;
    }
    state->newest = 20U;
    state->count = 0U;
    state->coasting = 0U;
}

void counter_step(counter_state *state, const counter_measurements *measurements,
                  counter_estimate *estimate)
{
    /* samples: outside its range, infinite or NaN means missing */
    const uint32_t t0 = state->newest;
    const uint32_t t1 = (t0 < 20U) ? t0 : 20U;
    const uint32_t t2 = state->count;
    const uint32_t t4 = (uint32_t)measurements->y;
    const uint32_t t7 = t4 - 0U;
    const float t8 = (t7 < 2147483648U) ? (float)t7 : -(float)(0U - t7);
    const float t9 = 1e-6f * t8;

    /* prediction, for a sample that is missing */
    const uint32_t t10 = (t1 < 20U) ? (t1 + 1U) : 0U;

    /* how much of the window is good */
    const uint32_t t11 = (t2 < 21U) ? (t2 + 1U) : 21U;
    state->count = t11;
    const uint32_t t12 = state->coasting;
    const uint32_t t13 = (t12 > 0U) ? (t12 - 1U) : 0U;
    state->coasting = t13;

    /* into the window */
    state->newest = t10;
    state->y[t10] = t4;

    /* the sums over the window, newest sample first */
    const uint32_t t14 = ((t10 >= 1U) && (t10 < 21U)) ? (t10 - 1U) : 20U;
    float t16 = 0.0f;
    float t17 = 0.0f;
    float t18 = 0.0f;
    uint32_t t19 = t14;
    for (uint32_t row = 0U; row < 20U; ++row) {
        const float *const gains = COUNTER_WINDOW[row];
        const uint32_t t20 = state->y[t19];
        const uint32_t t21 = t20 - t4;
        const float t22 = (t21 < 2147483648U) ? (float)t21 : -(float)(0U - t21);
        const float t23 = 1e-6f * t22;
        const float t24 = gains[0];
        const float t25 = t24 * t23;
        const float t26 = t16 + t25;
        const float t27 = gains[1];
        const float t28 = t27 * t23;
        const float t29 = t17 + t28;
        const float t30 = gains[2];
        const float t31 = t30 * t23;
        const float t32 = t18 + t31;
        const uint32_t t33 = ((t19 >= 1U) && (t19 < 21U)) ? (t19 - 1U) : 20U;
        t16 = t26;
        t17 = t29;
        t18 = t32;
        t19 = t33;
    }

    /* the estimate; until the window is full, the start */
    const float t34 = t16 + t9;
    const int t35 = 20U < t11;
    const float t36 = t35 ? t34 : t9;
    const float t37 = t35 ? t17 : 0.0f;
    const float t38 = t35 ? t18 : 0.0f;
    const uint32_t t39 = state->coasting;
    const int t40 = t39 == 0U;
    const counter_status t44 = t40 ? COUNTER_CONVERGED : COUNTER_COASTING;
    const counter_status t45 = t35 ? t44 : COUNTER_CONVERGING;

    estimate->x = t36;
    estimate->v = t37;
    estimate->a = t38;
    estimate->status = t45;
}
