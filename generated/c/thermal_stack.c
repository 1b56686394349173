/* thermal_stack.c: Finite-time observer: Heater, block and sensor, a discrete model identified at 2 Hz.
 *
 * Generated; thermal_stack.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "thermal_stack.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "thermal_stack.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "thermal_stack.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* weights by age, from age 0
 *   [0] heater from sensor
 *   [1] block from sensor
 *   [2] sensor from sensor
 *   [3] heater from power
 *   [4] block from power
 *   [5] sensor from power
 *   [6] heater from ambient
 *   [7] block from ambient
 *   [8] sensor from ambient
 */
static const double THERMAL_STACK_WINDOW[20][9] = {
    {
        0.09901593660389385, 0.11268476614498317, 0.11339341676219682, 0.9, 0.0, 0.0, 0.0, 0.002,
        0.0
    },
    {
        0.09780481844133934, 0.11167473985357014, 0.11280381372675098, 0.738, 0.045, 0.0,
        0.00018039362535844246, 0.0018149260935420067, 0.00035464263329512127
    },
    {
        0.09568805737225514, 0.10970869291059972, 0.11133962259676018, 0.609218856570565,
        0.07773583710469516, 0.007979459249140229, 0.0002773590444935697, 0.0016173522458862435,
        0.0005684102301098594
    },
    {
        0.09250807474343406, 0.10661688372595442, 0.10884167785159918, 0.5058000408889686,
        0.1001338119582905, 0.019332386761766823, 0.00031187107424762044, 0.0014133070177007726,
        0.0006767684073095875
    },
    {
        0.08809527828188364, 0.1022156466091001, 0.10513672438290869, 0.4217731326995257,
        0.11390913370406561, 0.031079846309114516, 0.0003005715338735005, 0.0012076928545168993,
        0.0007073133651664342
    },
    {
        0.08227289024181567, 0.09631208988750875, 0.10004129802132612, 0.35261682832576485,
        0.12057857886396403, 0.04140002468971867, 0.00025678190572673724, 0.0010046193673721798,
        0.0006816277697145487
    },
    {
        0.07486514339967142, 0.08871222624956983, 0.0933686208040044, 0.29492339210597873,
        0.12147837043432455, 0.04928464506414666, 0.00019129323641348624, 0.0008076593084944394,
        0.0006167176227914496
    },
    {
        0.06571027948483317, 0.07923401263580625, 0.08493982556858423, 0.24614127934620603,
        0.11778459819727101, 0.054289555465407875, 0.00011297899598801355, 0.0006200419579186946,
        0.0005261216801862313
    },
    {
        0.05468030547646418, 0.06772731583222942, 0.07460130664171986, 0.20437787647361924,
        0.11053431457493286, 0.056355173285824664, 2.9264826574145538e-5, 0.0004447934133539346,
        0.0004207628721677913
    },
    {
        0.041710158576814683, 0.054103539782146194, 0.06225063808336725, 0.16824831730628606,
        0.10064598975190847, 0.05567840671815153, -5.352079498716455e-5, 0.0002848285118767005,
        0.00030959335230848224
    },
    {
        0.026839856320918513, 0.038378609430241274, 0.047874360234623006, 0.13675940230394334,
        0.08893835311379071, 0.05262214393582511, -0.00012989963838473009, 0.0001429944464889775,
        0.00020007007219605488
    },
    {
        0.010274437165793902, 0.02073427947073664, 0.031602077423619014, 0.10921996802557712,
        0.07614682459931038, 0.04765173465178782, -0.00019509325418888164, 2.206120828914988e-5,
        9.84851583285436e-5
    },
    {
        -0.007531875579740172, 0.0016044238576804956, 0.013782823867897134, 0.08517077556172341,
        0.06293677335794039, 0.04129033847685824, -0.0002449696602882309, -7.535160823243675e-5,
        1.0163980408065237e-5
    },
    {
        -0.02575870288039986, -0.018204807110123105, -0.004908342300130374, 0.064328218604128,
        0.049912742968281285, 0.03408676711020523, -0.00027609639225845367, -0.0001469288052253329,
        -6.046716289409145e-5
    },
    {
        -0.04305831205253289, -0.03734913187027106, -0.02332291314974384, 0.04653697042956975,
        0.03762255111642066, 0.02659063786525123, -0.00028591880500968936, -0.00019091991598085698,
        -0.00010995315613324748
    },
    {
        -0.05733503763656626, -0.05371887833430483, -0.03963658629480592, 0.031727142639529186,
        0.026554793805895663, 0.01933037703650794, -0.0002730940900928023, -0.0002065420898632641,
        -0.00013604396177119323
    },
    {
        -0.06544525954662761, -0.06412951784001955, -0.051073333519239594, 0.01987163993732588,
        0.017127733898911, 0.012789920030084664, -0.00023802584170660627, -0.000194575605739345,
        -0.00013812703360537745
    },
    {
        -0.06279143765616621, -0.06390250105219061, -0.05353119953160384, 0.010939163310208581,
        0.00966679066797176, 0.007379876168548431, -0.00018366226868907963, -0.0001582202171567088,
        -0.00011791304731136065
    },
    {
        -0.04277526457710867, -0.046300137724842275, -0.04107726104305592, 0.004837712868866745,
        0.004366813461710894, 0.003398454893704099, -0.00011664470509293632,
        -0.00010430432459147774, -8.045249840707414e-5
    },
    {
        0.003936042348424907, -0.0017667873993094231, -0.005268850269374251, 0.0013424186878796636,
        0.0012339397352946837, 0.0009765517986781932, -4.8923703291614405e-5,
        -4.4970248130739586e-5, -3.558988777404971e-5
    }
};

/* What one part of a step hands to the next. */
typedef struct {
    uint32_t t15;
    double t21;
    uint32_t t31;
    double t101;
    double t102;
    double t103;
    thermal_stack_status t110;
} thermal_stack_work;

/* Part 1 of a step. */
static void thermal_stack_part_1(thermal_stack_state *state, const thermal_stack_measurements *measurements, const thermal_stack_inputs *inputs, thermal_stack_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    const uint32_t t0 = state->newest;
    const uint32_t t1 = (t0 < 20U) ? t0 : 20U;
    const uint32_t t2 = state->count;
    const int t4 = 20U < t2;
    const double t5 = measurements->sensor;
    const int t6 = (-50.0 <= t5) && (t5 <= 200.0);
    const double t7 = inputs->power;
    const int t8 = (-1e306 <= t7) && (t7 <= 1e306);
    const double t9 = state->power[t1];
    const double t10 = t8 ? t7 : t9;
    const double t11 = inputs->ambient;
    const int t12 = (-1e306 <= t11) && (t11 <= 1e306);
    const double t13 = state->ambient[t1];
    const double t14 = t12 ? t11 : t13;

    /* prediction, for a sample that is missing */
    work->t15 = (t1 < 20U) ? (t1 + 1U) : 0U;
    const double t16 = state->ahead_sensor;
    const double t17 = state->sensor[t1];
    const int t18 = (-50.0 <= t16) && (t16 <= 200.0);
    const int t19 = t4 && t18;
    const double t20 = t19 ? t16 : t17;
    work->t21 = t6 ? t5 : t20;
    const int t22 = t6 || t19;
    const int t23 = !t22;
    const int t24 = t8 && t12;

    /* how much of the window is good */
    const uint32_t t27 = (t2 < 21U) ? (t2 + 1U) : 21U;
    const uint32_t t28 = t23 ? 0U : t27;
    const uint32_t t29 = t24 ? t27 : 1U;
    const uint32_t t30 = t6 ? t29 : 0U;
    work->t31 = t4 ? t28 : t30;
    state->count = work->t31;
    const uint32_t t32 = state->coasting;
    const uint32_t t33 = (t32 > 0U) ? (t32 - 1U) : 0U;
    const uint32_t t34 = t24 ? t33 : 20U;
    const uint32_t t36 = t6 ? t34 : 21U;
    state->coasting = t36;

    /* into the window */
    state->newest = work->t15;
    state->sensor[work->t15] = work->t21;
    state->power[work->t15] = t10;
    state->ambient[work->t15] = t14;
}

/* Part 2 of a step. */
static void thermal_stack_part_2(thermal_stack_state *state, thermal_stack_work *work)
{
    /* the sums over the window, newest sample first */
    double t38 = 0.0;
    double t39 = 0.0;
    double t40 = 0.0;
    double t41 = 0.0;
    double t42 = 0.0;
    double t43 = 0.0;
    double t44 = 0.0;
    double t45 = 0.0;
    double t46 = 0.0;
    uint32_t t47 = work->t15;
    for (uint32_t row = 0U; row < 20U; ++row) {
        const double *const gains = THERMAL_STACK_WINDOW[row];
        const double t48 = state->sensor[t47];
        const double t49 = gains[0];
        const double t50 = t49 * t48;
        const double t51 = t38 + t50;
        const double t52 = gains[1];
        const double t53 = t52 * t48;
        const double t54 = t41 + t53;
        const double t55 = gains[2];
        const double t56 = t55 * t48;
        const double t57 = t44 + t56;
        const double t58 = state->power[t47];
        const double t59 = gains[3];
        const double t60 = t59 * t58;
        const double t61 = t39 + t60;
        const double t62 = gains[4];
        const double t63 = t62 * t58;
        const double t64 = t42 + t63;
        const double t65 = gains[5];
        const double t66 = t65 * t58;
        const double t67 = t45 + t66;
        const double t68 = state->ambient[t47];
        const double t69 = gains[6];
        const double t70 = t69 * t68;
        const double t71 = t40 + t70;
        const double t72 = gains[7];
        const double t73 = t72 * t68;
        const double t74 = t43 + t73;
        const double t75 = gains[8];
        const double t76 = t75 * t68;
        const double t77 = t46 + t76;
        const uint32_t t78 = ((t47 >= 1U) && (t47 < 21U)) ? (t47 - 1U) : 20U;
        t38 = t51;
        t39 = t61;
        t40 = t71;
        t41 = t54;
        t42 = t64;
        t43 = t74;
        t44 = t57;
        t45 = t67;
        t46 = t77;
        t47 = t78;
    }
    const double t79 = state->sensor[t47];
    const double t81 = 0.09039071824495325 * t79;
    const double t82 = t38 + t81;
    const double t84 = 0.0830863723451623 * t79;
    const double t85 = t41 + t84;
    const double t87 = 0.06575535582370828 * t79;
    const double t88 = t44 + t87;
    const double t89 = t82 + t39;
    const double t90 = t89 + t40;
    const double t91 = t85 + t42;
    const double t92 = t91 + t43;
    const double t93 = t88 + t45;
    const double t94 = t93 + t46;

    /* the next measurement, as far as it is known */
    const double t96 = 0.2 * t92;
    const double t98 = 0.8 * t94;
    const double t99 = t96 + t98;
    state->ahead_sensor = t99;

    /* the estimate; until the window is full, the start */
    const int t100 = 20U < work->t31;
    work->t101 = t100 ? t90 : 0.0;
    work->t102 = t100 ? t92 : 0.0;
    work->t103 = t100 ? t94 : work->t21;
    const uint32_t t104 = state->coasting;
    const int t105 = t104 == 0U;
    const thermal_stack_status t109 = t105 ? THERMAL_STACK_CONVERGED : THERMAL_STACK_COASTING;
    work->t110 = t100 ? t109 : THERMAL_STACK_CONVERGING;
}

void thermal_stack_init(thermal_stack_state *state)
{
    for (uint32_t slot = 0U; slot < 21U; ++slot) {
        state->sensor[slot] = 20.0;
    }
    for (uint32_t slot = 0U; slot < 21U; ++slot) {
        state->power[slot] = 0.0;
    }
    for (uint32_t slot = 0U; slot < 21U; ++slot) {
        state->ambient[slot] = 0.0;
    }
    state->newest = 20U;
    state->count = 0U;
    state->coasting = 0U;
    state->ahead_sensor = 0.0;
}

void thermal_stack_step(thermal_stack_state *state, const thermal_stack_measurements *measurements,
                        const thermal_stack_inputs *inputs, thermal_stack_estimate *estimate)
{
    thermal_stack_work work;
    thermal_stack_part_1(state, measurements, inputs, &work);
    thermal_stack_part_2(state, &work);

    estimate->heater = work.t101;
    estimate->block = work.t102;
    estimate->sensor = work.t103;
    estimate->status = work.t110;
}
