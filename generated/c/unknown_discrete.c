/* unknown_discrete.c: Finite-time observer: Tank and sensor with an unknown leak, a discrete model by the paper's two stages.
 *
 * Generated; unknown_discrete.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "unknown_discrete.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "unknown_discrete.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "unknown_discrete.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* weights by age, from age 0
 *   [0] level from shown
 *   [1] shown from shown
 *   [2] leak from shown
 *   [3] level from pump
 *   [4] shown from pump
 *   [5] leak from pump
 */
static const float UNKNOWN_DISCRETE_WINDOW[20][6] = {
    { 0.19689804f, 0.11111111f, -0.029211646f, 0.05f, 0.0f, 0.0f },
    { 0.2933528f, 0.22353908f, -0.025516914f, 0.04604653f, 0.013333334f, 0.0004381747f },
    { 0.26877892f, 0.20993666f, -0.021807358f, 0.038657878f, 0.019046914f, 0.0011188872f },
    { 0.24340966f, 0.19549705f, -0.018108638f, 0.02932563f, 0.019703098f, 0.001906253f },
    { 0.21710289f, 0.17996332f, -0.014458066f, 0.019096611f, 0.017102567f, 0.002706578f },
    { 0.18965954f, 0.16297056f, -0.010909606f, 0.00870838f, 0.012516537f, 0.0034562326f },
    { 0.16079943f, 0.14399953f, -0.007541035f, -0.0013150898f, 0.0068508624f, 0.004113402f },
    { 0.13012646f, 0.12231066f, -0.004464157f, -0.010595291f, 0.0007631119f, 0.0046526557f },
    { 0.09707915f, 0.09684963f, -0.0018393972f, -0.018849833f, -0.0052523236f, 0.00506163f },
    { -0.13603832f, -0.044998612f, 0.029314985f, -0.02585554f, -0.010800143f, 0.0053394074f },
    { -0.15166107f, -0.0691045f, 0.026551798f, -0.028465744f, -0.013866167f, 0.005058202f },
    { -0.1731083f, -0.10363986f, 0.022291595f, -0.027810635f, -0.014849694f, 0.0044366685f },
    { -0.20285839f, -0.15307648f, 0.015886417f, -0.024597742f, -0.013880699f, 0.0036493025f },
    { -0.08247442f, -0.046540964f, 0.012235844f, -0.019203234f, -0.010836536f, 0.0028489775f },
    { -0.058556397f, -0.033043835f, 0.0086873835f, -0.014150267f, -0.007985107f, 0.002099323f },
    { -0.0358509f, -0.020230945f, 0.005318813f, -0.009720684f, -0.0054854583f, 0.0014421534f },
    { -0.015111525f, -0.008527552f, 0.0022419344f, -0.006085902f, -0.0034343223f, 0.0009028999f },
    { 0.002580392f, 0.0014561354f, -0.000382825f, -0.0033292535f, -0.0018787239f, 0.00049392553f },
    { 0.015675208f, 0.008845643f, -0.002325562f, -0.0014569229f, -0.000822153f, 0.000216148f },
    { 0.02195418f, 0.012388917f, -0.0032571058f, -0.0003988907f, -0.00022509716f, 5.9179125e-5f }
};

/* What one part of a step hands to the next. */
typedef struct {
    float t17;
    uint32_t t26;
    float t71;
    float t72;
    float t73;
    float t80;
    float t81;
    float t82;
    unknown_discrete_status t89;
} unknown_discrete_work;

/* Part 1 of a step. */
static void unknown_discrete_part_1(unknown_discrete_state *state, const unknown_discrete_measurements *measurements, const unknown_discrete_inputs *inputs, unknown_discrete_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    const uint32_t t0 = state->newest;
    const uint32_t t1 = (t0 < 20U) ? t0 : 20U;
    const uint32_t t2 = state->count;
    const int t4 = 20U < t2;
    const float t5 = measurements->shown;
    const int t6 = (-1.0f <= t5) && (t5 <= 10.0f);
    const float t7 = inputs->pump;
    const int t8 = (-1e36f <= t7) && (t7 <= 1e36f);
    const float t9 = state->pump[t1];
    const float t10 = t8 ? t7 : t9;

    /* prediction, for a sample that is missing */
    const uint32_t t11 = (t1 < 20U) ? (t1 + 1U) : 0U;
    const float t12 = state->ahead_shown;
    const float t13 = state->shown[t1];
    const int t14 = (-1.0f <= t12) && (t12 <= 10.0f);
    const int t15 = t4 && t14;
    const float t16 = t15 ? t12 : t13;
    work->t17 = t6 ? t5 : t16;
    const int t18 = t6 || t15;
    const int t19 = !t18;

    /* how much of the window is good */
    const uint32_t t22 = (t2 < 21U) ? (t2 + 1U) : 21U;
    const uint32_t t23 = t19 ? 0U : t22;
    const uint32_t t24 = t8 ? t22 : 1U;
    const uint32_t t25 = t6 ? t24 : 0U;
    work->t26 = t4 ? t23 : t25;
    state->count = work->t26;
    const uint32_t t27 = state->coasting;
    const uint32_t t28 = (t27 > 0U) ? (t27 - 1U) : 0U;
    const uint32_t t29 = t8 ? t28 : 20U;
    const uint32_t t31 = t6 ? t29 : 21U;
    state->coasting = t31;

    /* into the window */
    state->newest = t11;
    state->shown[t11] = work->t17;
    state->pump[t11] = t10;

    /* the sums over the window, newest sample first */
    float t33 = 0.0f;
    float t34 = 0.0f;
    float t35 = 0.0f;
    float t36 = 0.0f;
    float t37 = 0.0f;
    float t38 = 0.0f;
    uint32_t t39 = t11;
    for (uint32_t row = 0U; row < 20U; ++row) {
        const float *const gains = UNKNOWN_DISCRETE_WINDOW[row];
        const float t40 = state->shown[t39];
        const float t41 = gains[0];
        const float t42 = t41 * t40;
        const float t43 = t33 + t42;
        const float t44 = gains[1];
        const float t45 = t44 * t40;
        const float t46 = t35 + t45;
        const float t47 = gains[2];
        const float t48 = t47 * t40;
        const float t49 = t37 + t48;
        const float t50 = state->pump[t39];
        const float t51 = gains[3];
        const float t52 = t51 * t50;
        const float t53 = t34 + t52;
        const float t54 = gains[4];
        const float t55 = t54 * t50;
        const float t56 = t36 + t55;
        const float t57 = gains[5];
        const float t58 = t57 * t50;
        const float t59 = t38 + t58;
        const uint32_t t60 = ((t39 >= 1U) && (t39 < 21U)) ? (t39 - 1U) : 20U;
        t33 = t43;
        t34 = t53;
        t35 = t46;
        t36 = t56;
        t37 = t49;
        t38 = t59;
        t39 = t60;
    }
    const float t61 = state->shown[t39];
    const float t63 = 0.018242601f * t61;
    const float t64 = t33 + t63;
    const float t66 = 0.010294443f * t61;
    const float t67 = t35 + t66;
    const float t69 = -0.0027064588f * t61;
    const float t70 = t37 + t69;
    work->t71 = t64 + t34;
    work->t72 = t67 + t36;
    work->t73 = t70 + t38;

    /* the next measurement, as far as it is known */
    const float t75 = 0.3f * work->t71;
    const float t77 = 0.7f * work->t72;
    const float t78 = t75 + t77;
    state->ahead_shown = t78;
}

/* Part 2 of a step. */
static void unknown_discrete_part_2(const unknown_discrete_state *state, unknown_discrete_work *work)
{
    /* the estimate; until the window is full, the start */
    const int t79 = 20U < work->t26;
    work->t80 = t79 ? work->t71 : 0.0f;
    work->t81 = t79 ? work->t72 : work->t17;
    work->t82 = t79 ? work->t73 : 0.0f;
    const uint32_t t83 = state->coasting;
    const int t84 = t83 == 0U;
    const unknown_discrete_status t88 = t84 ? UNKNOWN_DISCRETE_CONVERGED : UNKNOWN_DISCRETE_COASTING;
    work->t89 = t79 ? t88 : UNKNOWN_DISCRETE_CONVERGING;
}

void unknown_discrete_init(unknown_discrete_state *state)
{
    for (uint32_t slot = 0U; slot < 21U; ++slot) {
        state->shown[slot] = 0.0f;
    }
    for (uint32_t slot = 0U; slot < 21U; ++slot) {
        state->pump[slot] = 0.0f;
    }
    state->newest = 20U;
    state->count = 0U;
    state->coasting = 0U;
    state->ahead_shown = 0.0f;
}

void unknown_discrete_step(unknown_discrete_state *state, const unknown_discrete_measurements *measurements,
                           const unknown_discrete_inputs *inputs, unknown_discrete_estimate *estimate)
{
    unknown_discrete_work work;
    unknown_discrete_part_1(state, measurements, inputs, &work);
    unknown_discrete_part_2(state, &work);

    estimate->level = work.t80;
    estimate->shown = work.t81;
    estimate->leak = work.t82;
    estimate->status = work.t89;
}
