/* shaft_counter.c: Finite-time observer: A motor's shaft by an encoder of 2156 counts a turn, read from a timer of 16 bits that runs freely.
 *
 * Generated; shaft_counter.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "shaft_counter.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "shaft_counter.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "shaft_counter.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

void shaft_counter_init(shaft_counter_state *state)
{
    state->angle = 0.0f;
    state->speed = 0.0f;
    state->good = 0U;
    state->clean = 0U;
    state->count_encoder = 32768U;
    state->within_encoder = 428U;
    state->last_current = 0.0f;
}

void shaft_counter_step(shaft_counter_state *state, const shaft_counter_measurements *measurements,
                        const shaft_counter_inputs *inputs, shaft_counter_estimate *estimate)
{
    /* samples: outside its range, infinite or NaN means missing */
    const uint32_t t0 = (uint32_t)measurements->encoder;
    const uint32_t t2 = state->count_encoder;
    const uint32_t t3 = state->within_encoder;
    const uint32_t t4 = (((t0 - t2) + 32768U) & 65535U) - 32768U;
    const uint32_t t7 = t4 + 2147483648U;
    const uint32_t t8 = t7 % 2156U;
    const uint32_t t9 = t3 + t8;
    const uint32_t t10 = t9 + 152U;
    const uint32_t t11 = t10 % 2156U;
    const float t12 = (float)t11;
    const float t14 = t12 * 0.0004638219f;
    const float t16 = t14 + 1.2582912e7f;
    const float t17 = t16 - 1.2582912e7f;
    const float t19 = t17 * 2156.0f;
    const float t20 = t12 - t19;
    const float t21 = 0.002914279f * t20;
    const float t22 = inputs->current;
    const int t23 = (-1e36f <= t22) && (t22 <= 1e36f);
    const float t24 = state->last_current;
    const float t25 = t23 ? t22 : t24;

    /* prediction by the plant */
    const float t26 = state->angle;
    const float t27 = state->speed;
    const float t29 = 0.0009985015f * t27;
    const float t31 = 1.9980014e-5f * t25;
    const float t32 = t26 + t29;
    const float t33 = t32 + t31;
    const float t35 = 0.9970045f * t27;
    const float t37 = 0.03994006f * t25;
    const float t38 = t35 + t37;
    state->count_encoder = t0;
    state->within_encoder = t11;
    state->last_current = t25;

    /* correction by the innovation */
    const float t39 = t33 - t26;
    const int t40 = (-3.1415927f <= t39) && (t39 <= 3.1415927f);
    const int t41 = !t40;
    const float t43 = t21 - t33;
    const float t45 = t43 * 0.15915494f;
    const float t46 = t45 + 1.2582912e7f;
    const float t47 = t46 - 1.2582912e7f;
    const float t49 = t47 * 6.2831855f;
    const float t50 = t43 - t49;
    const float t52 = 0.16222021f * t50;
    const float t54 = 6.8407664f * t50;
    const float t55 = t33 + t52;
    const float t56 = t38 + t54;
    const float t57 = t55 * 0.15915494f;
    const float t58 = t57 + 1.2582912e7f;
    const float t59 = t58 - 1.2582912e7f;
    const float t60 = t59 * 6.2831855f;
    const float t61 = t55 - t60;

    /* the first sample starts the observer; so does a state beyond all bounds */
    const uint32_t t63 = state->good;
    const int t64 = t63 == 0U;
    const int t65 = t64 || t41;
    const int t66 = (-1e36f <= t61) && (t61 <= 1e36f);
    const int t67 = !t66;
    const int t68 = t65 || t67;
    const int t69 = (-1e36f <= t56) && (t56 <= 1e36f);
    const int t70 = !t69;
    const int t71 = t68 || t70;
    const float t72 = t71 ? t21 : t61;
    state->angle = t72;
    const float t73 = t71 ? 0.0f : t56;
    state->speed = t73;
    const uint32_t t75 = (t63 < 194U) ? (t63 + 1U) : 194U;
    const uint32_t t76 = t71 ? 1U : t75;
    state->good = t76;
    const uint32_t t77 = state->clean;
    const uint32_t t78 = (t77 < 229U) ? (t77 + 1U) : 229U;
    const uint32_t t79 = t23 ? t78 : 0U;
    const uint32_t t81 = t71 ? 229U : t79;
    state->clean = t81;

    /* the estimate */
    const int t84 = 193U < t76;
    const int t85 = 228U < t81;
    const shaft_counter_status t89 = t85 ? SHAFT_COUNTER_CONVERGED : SHAFT_COUNTER_COASTING;
    const shaft_counter_status t90 = t84 ? t89 : SHAFT_COUNTER_CONVERGING;

    estimate->angle = t72;
    estimate->speed = t73;
    estimate->status = t90;
}
