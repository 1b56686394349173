/* bus_sensor.c: Finite-time observer: Speed and current of a motor whose position comes over a bus with its time stamp.
 *
 * Generated; bus_sensor.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "bus_sensor.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "bus_sensor.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "bus_sensor.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* orthonormal rows of the window, oldest first
 *   [0] state q in direction 1
 *   [1] state q in direction 2
 *   [2] state q in direction 3
 *   [3] state dq in direction 1
 *   [4] state dq in direction 2
 *   [5] state dq in direction 3
 *   [6] state i in direction 1
 *   [7] state i in direction 2
 *   [8] state i in direction 3
 */
static const double BUS_SENSOR_ROWS[50][9] = {
    {
        0.14002800840280097, -0.2344664946534277, 0.4073199474123979, 0.0, 10.291129583624546,
        -135.65034260918813, 0.0, -0.3397348388610457, 1908.3758883817297
    },
    {
        0.14002800840280097, -0.22418378531951932, 0.285148504197266, 0.0, 10.273598360335278,
        -109.55112132153218, 0.0, -0.6173786058771802, 1566.4622643222162
    },
    {
        0.14002800840280097, -0.2139205463590972, 0.18666028620241149, 0.0, 10.252316810414632,
        -88.13021289627302, 0.0, -0.8440496912335711, 1285.7482993603717
    },
    {
        0.14002800840280097, -0.20368016800312236, 0.10760942748511873, 0.0, 10.227982203059337,
        -70.55023023309265, 0.0, -1.0288764100667946, 1055.27999322484
    },
    {
        0.14002800840280097, -0.19346540771523327, 0.04451004640920104, 0.0, 10.201166906564755,
        -56.12366844708157, 0.0, -1.1793532017900223, 866.0639786302013
    },
    {
        0.14002800840280097, -0.1832785035474101, -0.005499782410505875, 0.0, 10.172340744439488,
        -44.28607777273901, 0.0, -1.301633074066225, 710.7165917922673
    },
    {
        0.14002800840280097, -0.17312126720598187, -0.04476970879395865, 0.0, 10.141889350045707,
        -34.57403819223442, 0.0, -1.4007677028628325, 583.1757550576764
    },
    {
        0.14002800840280097, -0.16299516045958073, -0.07522879819540791, 0.0, 10.110129235980418,
        -26.60707633762399, 0.0, -1.4809045575133426, 478.4644290424361
    },
    {
        0.14002800840280097, -0.15290135787063314, -0.09846081129178483, 0.0, 10.077320166219208,
        -20.07281904787925, 0.0, -1.5454487427875254, 392.4964039638327
    },
    {
        0.14002800840280097, -0.14284079829831078, -0.11576600943897768, 0.0, 10.043675313795159,
        -14.714804258838505, 0.0, -1.597195873197035, 321.9168519644765
    },
    {
        0.14002800840280097, -0.13281422718271424, -0.12821189770194982, 0.0, 10.009369600375283,
        -10.322473595772204, 0.0, -1.63844116441436, 263.9714186332043
    },
    {
        0.14002800840280097, -0.12282223126033863, -0.13667488549858442, 0.0, 9.97454654315271,
        -6.722956170299826, 0.0, -1.6710689986528817, 216.3987455533252
    },
    {
        0.14002800840280097, -0.11286526706553081, -0.14187449049405804, 0.0, 9.939323876226997,
        -3.7743229778409066, 0.0, -1.696626458931787, 177.34223000898118
    },
    {
        0.14002800840280097, -0.10294368433017183, -0.14440142041330697, 0.0, 9.903798165824274,
        -1.3600486759709456, 0.0, -1.716383701600679, 145.27757863203232
    },
    {
        0.14002800840280097, -0.0930577451947414, -0.144740628549872, 0.0, 9.86804859944773,
        0.6155353628312201, 0.0, -1.7313835229155008, 118.95332806599528
    },
    {
        0.14002800840280097, -0.08320763998047771, -0.14329024261840564, 0.0, 9.832140096814811,
        2.2309741501176044, 0.0, -1.742482053799303, 97.34201170851857
    },
    {
        0.14002800840280097, -0.07339350013815588, -0.14037710557219363, 0.0, 9.796125863973128,
        3.5507540010483383, 0.0, -1.750382170734992, 79.60006701367718
    },
    {
        0.14002800840280097, -0.06361540887883754, -0.13626953480279178, 0.0, 9.760049490259291,
        4.62781887059916, 0.0, -1.7556609265139316, 65.03491890006795
    },
    {
        0.14002800840280097, -0.05387340990149182, -0.1311877975975881, 0.0, 9.723946669926264,
        5.5056362961575465, 0.0, -1.7587920712135603, 53.07795482895068
    },
    {
        0.14002800840280097, -0.0441675145581259, -0.12531271161737656, 0.0, 9.687846615618994,
        6.219893561492064, 0.0, -1.7601645421933731, 43.26233701507459
    },
    {
        0.14002800840280097, -0.03449770773609336, -0.11879270599258307, 0.0, 9.651773218853762,
        6.799890267976688, 0.0, -1.760097644606014, 35.20478598220654
    },
    {
        0.14002800840280097, -0.024863952687191257, -0.11174961856870404, 0.0, 9.615746002784485,
        7.269681652483073, 0.0, -1.758853514781066, 28.59062464090715
    },
    {
        0.14002800840280097, -0.01526619499205911, -0.1042834555148952, 0.0, 9.579780904434136,
        7.649017265259034, 0.0, -1.756647352814317, 23.161499294684916
    },
    {
        0.14002800840280097, -0.005704365814651799, -0.09647629902010188, 0.0, 9.543890916914904,
        7.954111635869522, 0.0, -1.753655823647619, 18.705298436870695
    },
    {
        0.14002800840280097, 0.0038216154261443928, -0.08839551555871178, 0.0, 9.50808661669746,
        8.198276999295727, 0.0, -1.7500239544572775, 15.047875960374823
    },
    {
        0.14002800840280097, 0.013311838863426828, -0.08009638991529035, 0.0, 9.47237659650411,
        8.392442771748176, 0.0, -1.7458707974934713, 12.046255812342686
    },
    {
        0.14002800840280097, 0.022766402382070203, -0.07162428775054702, 0.0, 9.436767820718059,
        8.545582046619122, 0.0, -1.741294079339976, 9.583052933070157
    },
    {
        0.14002800840280097, 0.03218541014107703, -0.06301643109392595, 0.0, 9.401265917177414,
        8.665061752839708, 0.0, -1.7363740180126404, 7.561892779073047
    },
    {
        0.14002800840280097, 0.04156897136074988, -0.05430335604425404, 0.0, 9.365875416740337,
        8.756930139143995, 0.0, -1.7311764568433703, 5.903650695878889
    },
    {
        0.14002800840280097, 0.05091719932728424, -0.045510109559344446, 0.0, 9.330599949969665,
        8.826152802141113, 0.0, -1.7257554374367166, 4.54336439740113
    },
    {
        0.14002800840280097, 0.06023021057586504, -0.036657232034463895, 0.0, 9.295442408612075,
        8.876806468228759, 0.0, -1.7201553120982538, 3.4276990739951283
    },
    {
        0.14002800840280097, 0.06950812422031563, -0.027761564010856103, 0.0, 9.260405078173182,
        8.912238090897153, 0.0, -1.714412478163709, 2.5128662153757917
    },
    {
        0.14002800840280097, 0.07875106140306669, -0.018836908492905844, 0.0, 9.225489746762044,
        8.93519547154722, 0.0, -1.7085568019040098, 1.762914938948857
    },
    {
        0.14002800840280097, 0.08795914484390821, -0.009894574718243973, 0.0, 9.190697794452534,
        8.947934500767968, 0.0, -1.7026127875683952, 1.1483291496123487
    },
    {
        0.14002800840280097, 0.09713249846984216, -0.0009438245992780808, 0.0, 9.156030266648878,
        8.952307204726855, 0.0, -1.6966005371827764, 0.6448757909106227
    },
    {
        0.14002800840280097, 0.10627124711151857, 0.00800776074321767, 0.0, 9.12148793431839,
        8.949834032324688, 0.0, -1.6905365385556224, 0.23265924523939951
    },
    {
        0.14002800840280097, 0.11537551625433617, 0.016953980051901643, 0.0, 9.087071343442018,
        8.941763203826786, 0.0, -1.6844343122401304, -0.10465501507381865
    },
    {
        0.14002800840280097, 0.12444543183442217, 0.02588976486748396, 0.0, 9.052780855612623,
        8.929119436808959, 0.0, -1.6783049426977992, -0.38047781966440414
    },
    {
        0.14002800840280097, 0.13348112007145674, 0.034810976685374174, 0.0, 9.018616681365394,
        8.912743950749869, 0.0, -1.672157514389945, -0.6058196066196001
    },
    {
        0.14002800840280097, 0.1424827073317468, 0.0437142404191504, 0.0, 8.984578907541309,
        8.893327311286171, 0.0, -1.665999469813905, -0.7897200634634395
    },
    {
        0.14002800840280097, 0.151450320016133, 0.05259680767236858, 0.0, 8.950667519751622,
        8.871436395743775, 0.0, -1.6598369034548817, -0.9396008676248689
    },
    {
        0.14002800840280097, 0.16038408446828425, 0.06145644448338008, 0.0, 8.916882420820263,
        8.847536532165385, 0.0, -1.6536748031237518, -1.0615552906473178
    },
    {
        0.14002800840280097, 0.16928412689972921, 0.07029133916278509, 0.0, 8.88322344592405,
        8.822009675719876, 0.0, -1.6475172480981124, -1.1605859667629461
    },
    {
        0.14002800840280097, 0.17815057332862808, 0.07910002662718305, 0.0, 8.849690375021769,
        8.795169331753991, 0.0, -1.64136757179826, -1.2408001037805423
    },
    {
        0.14002800840280097, 0.18698354952982382, 0.08788132627658196, 0.0, 8.816282943057383,
        8.767272807797886, 0.0, -1.6352284953459235, -1.3055697535958912
    },
    {
        0.14002800840280097, 0.19578318099415287, 0.0966342909913152, 0.0, 8.783000848335796,
        8.738531272609317, 0.0, -1.6291022372173796, -1.3576633962276992
    },
    {
        0.14002800840280097, 0.20454959289535676, 0.10535816525820756, 0.0, 8.749843759398233,
        8.709118014769942, 0.0, -1.6229906032697723, -1.3993539719094878
    },
    {
        0.14002800840280097, 0.21328291006323316, 0.11405235079196513, 0.0, 8.716811320665842,
        8.679175223092011, 0.0, -1.6168950606535908, -1.4325075767493058
    },
    {
        0.14002800840280097, 0.22198325696190802, 0.12271637831023316, 0.0, 8.683903157071928,
        8.648819553413452, 0.0, -1.6108167984954902, -1.4586562829436998
    },
    {
        0.14002800840280097, 0.23065075767231122, 0.13134988436088954, 0.0, 8.651118877863917,
        8.618146699003066, 0.0, -1.6047567777194058, -1.4790579250578624
    }
};

/* What one part of a step hands to the next. */
typedef struct {
    double t7;
    uint32_t t8;
    double t61;
    uint32_t t64;
    uint32_t t76;
    double t172;
    double t174;
    double t176;
    double t178;
    double t180;
    double t182;
    double t184;
    double t186;
    double t188;
    double t189;
    double t190;
    double t191;
    double t192;
    double t193;
    double t194;
    double t195;
    double t196;
    double t197;
    double t198;
    double t199;
    double t200;
    uint32_t t201;
    uint32_t t202;
    double t212;
    double t220;
    double t228;
    double t281;
    double t288;
    double t295;
    double t296;
    double t297;
    double t299;
    double t300;
    double t307;
    double t309;
    double t311;
    double t313;
    double t315;
    double t317;
    double t319;
    double t321;
    double t323;
    double t366;
    double t372;
    double t378;
    double t427;
    double t428;
    double t429;
    bus_sensor_status t437;
    int flags[2]; /* t75, t348 */
} bus_sensor_work;

/* Part 1 of a step. */
static void bus_sensor_part_1(bus_sensor_state *state, const bus_sensor_measurements *measurements, const bus_sensor_inputs *inputs, bus_sensor_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    const uint32_t t0 = state->newest;
    const uint32_t t1 = (t0 < 50U) ? t0 : 50U;
    const double t2 = measurements->y;
    const int t3 = (-1e297 <= t2) && (t2 <= 1e297);
    const double t4 = inputs->u;
    const int t5 = (-1e297 <= t4) && (t4 <= 1e297);
    const double t6 = state->u[t1];
    work->t7 = t5 ? t4 : t6;
    work->t8 = (t1 < 50U) ? (t1 + 1U) : 0U;
    const double t9 = measurements->y_age;
    const int t10 = (0.0 <= t9) && (t9 <= 0.001);
    const int t11 = t3 && t10;
    const double t13 = t9 * 1000.0;
    const double t15 = t11 ? t13 : 0.0;
    const double t17 = state->y[t1];
    const double t18 = t11 ? t2 : t17;
    const uint32_t t19 = state->calls;
    const int t21 = 0U < t19;
    const int t22 = t11 && t21;
    const double t23 = t22 ? 1.0 : 0.0;
    const uint32_t t24 = state->count;
    const double t26 = 8.744465871977893e-24 * t15;
    const double t28 = t26 + 5.76409954770789e-22;
    const double t29 = t28 * t15;
    const double t31 = t29 + 3.50725668613831e-20;
    const double t32 = t31 * t15;
    const double t34 = t32 + 1.956208177981075e-18;
    const double t35 = t34 * t15;
    const double t37 = t35 + 9.919045977187666e-17;
    const double t38 = t37 * t15;
    const double t40 = t38 + 4.5265492078125e-15;
    const double t41 = t40 * t15;
    const double t43 = t41 + 1.8361665226190475e-13;
    const double t44 = t43 * t15;
    const double t46 = t44 + 6.5172575e-12;
    const double t47 = t46 * t15;
    const double t49 = t47 + 1.98275e-10;
    const double t50 = t49 * t15;
    const double t52 = t50 + 5.025e-9;
    const double t53 = t52 * t15;
    const double t55 = t53 + 1e-7;
    const double t56 = t55 * t15;
    const double t57 = t56 * t15;
    const double t58 = t57 * t15;
    const double t59 = t58 * work->t7;
    const double t60 = t18 + t59;
    work->t61 = t11 ? t60 : t18;
    const uint32_t t62 = state->since;
    const uint32_t t63 = (t62 < 4294967295U) ? (t62 + 1U) : 4294967295U;
    work->t64 = t11 ? 0U : t63;
    state->since = work->t64;

    /* how much of the window is good */
    const int t66 = 50U < t24;
    const uint32_t t68 = (t24 < 51U) ? (t24 + 1U) : 51U;
    const uint32_t t69 = t5 ? t68 : 1U;
    const uint32_t t70 = t66 ? t68 : t69;
    state->count = t70;
    const uint32_t t71 = state->coasting;
    const uint32_t t72 = (t71 > 0U) ? (t71 - 1U) : 0U;
    const uint32_t t73 = t5 ? t72 : 50U;
    state->coasting = t73;

    /* into the window */
    state->newest = work->t8;
    state->y[work->t8] = work->t61;
    state->has_y[work->t8] = t23;
    state->age_y[work->t8] = t15;
    state->u[work->t8] = work->t7;
    const uint32_t t74 = (t19 < 4294967295U) ? (t19 + 1U) : 4294967295U;
    state->calls = t74;
    work->flags[0] = 50U < t70;
}

/* Part 2 of a step. */
static void bus_sensor_part_2(const bus_sensor_state *state, bus_sensor_work *work)
{
    /* rows of the window, oldest first; those without a sample count nothing */
    work->t76 = (work->t8 < 50U) ? (work->t8 + 1U) : 0U;
    const double t77 = state->age_y[work->t76];
    const double t79 = 5.272062832054933e-22 * t77;
    const double t81 = t79 + 3.207869236890387e-20;
    const double t82 = t81 * t77;
    const double t84 = t82 + 1.7892217754977797e-18;
    const double t85 = t84 * t77;
    const double t87 = t85 + 9.072333535001539e-17;
    const double t88 = t87 * t77;
    const double t90 = t88 + 4.140152618468725e-15;
    const double t91 = t90 * t77;
    const double t93 = t91 + 1.6794271487480158e-13;
    const double t94 = t93 * t77;
    const double t96 = t94 + 5.9609292152777776e-12;
    const double t97 = t96 * t77;
    const double t99 = t97 + 1.8134934166666665e-10;
    const double t100 = t99 * t77;
    const double t102 = t100 + 4.5954583333333335e-9;
    const double t103 = t102 * t77;
    const double t105 = t103 + 9.083333333333333e-8;
    const double t106 = t105 * t77;
    const double t108 = t106 + -5e-7;
    const double t109 = t108 * t77;
    const double t111 = t109 + -0.001;
    const double t112 = t111 * t77;
    const double t114 = 2.841951408392815e-21 * t77;
    const double t116 = t114 + 1.7292298643123669e-19;
    const double t117 = t116 * t77;
    const double t119 = t117 + 9.644955886880351e-18;
    const double t120 = t119 * t77;
    const double t122 = t120 + 4.890520444952687e-16;
    const double t123 = t122 * t77;
    const double t125 = t123 + 2.2317853448672246e-14;
    const double t126 = t125 * t77;
    const double t128 = t126 + 9.053098415625e-13;
    const double t129 = t128 * t77;
    const double t131 = t129 + 3.2132914145833336e-11;
    const double t132 = t131 * t77;
    const double t134 = t132 + 9.77588625e-10;
    const double t135 = t134 * t77;
    const double t137 = t135 + 2.4784375e-8;
    const double t138 = t137 * t77;
    const double t140 = t138 + 5.025e-7;
    const double t141 = t140 * t77;
    const double t143 = t141 + 7.5e-6;
    const double t144 = t143 * t77;
    const double t145 = t144 * t77;
    const double t147 = t112 * 0.0;
    const double t148 = t145 * 0.0;
    const double t149 = 0.14002800840280097 + t147;
    const double t150 = t149 + t148;
    const double t153 = t112 * 10.304061080238904;
    const double t154 = -0.2447645132938934 + t153;
    const double t155 = t154 + t148;
    const double t158 = t112 * -167.44782171324155;
    const double t160 = t145 * 2324.8312399871534;
    const double t161 = 0.5583461494624352 + t158;
    const double t162 = t161 + t160;
    const double t163 = state->has_y[work->t76];
    const double t164 = state->y[work->t76];
    const double t165 = 0.0 + t147;
    const double t166 = t165 + t148;
    const double t167 = t164 - t166;
    const double t168 = t163 * t150;
    const double t169 = t163 * t155;
    const double t170 = t163 * t162;
    const double t171 = t168 * t168;
    work->t172 = 0.0 + t171;
    const double t173 = t168 * t169;
    work->t174 = 0.0 + t173;
    const double t175 = t168 * t170;
    work->t176 = 0.0 + t175;
    const double t177 = t169 * t169;
    work->t178 = 0.0 + t177;
    const double t179 = t169 * t170;
    work->t180 = 0.0 + t179;
    const double t181 = t170 * t170;
    work->t182 = 0.0 + t181;
    const double t183 = t168 * t167;
    work->t184 = 0.0 + t183;
    const double t185 = t169 * t167;
    work->t186 = 0.0 + t185;
    const double t187 = t170 * t167;
    work->t188 = 0.0 + t187;
}

/* Part 3 of a step, for one row of BUS_SENSOR_ROWS. */
static void bus_sensor_part_3(const bus_sensor_state *state, bus_sensor_work *work, const double *gains)
{
    work->t202 = (work->t201 < 50U) ? (work->t201 + 1U) : 0U;
    const double t203 = state->u[work->t202];
    const double t205 = 0.000999413586572696 * work->t199;
    const double t207 = 7.021338035817581e-6 * work->t200;
    const double t208 = work->t198 + t205;
    const double t209 = t208 + t207;
    const double t211 = 9.51669369298718e-8 * t203;
    work->t212 = t209 + t211;
    const double t214 = 0.9987450097089235 * work->t199;
    const double t216 = 0.013586936191426924 * work->t200;
    const double t217 = t214 + t216;
    const double t219 = 0.00028085352143270324 * t203;
    work->t220 = t217 + t219;
    const double t222 = -0.03297096515786267 * work->t199;
    const double t224 = 0.8184916562359931 * work->t200;
    const double t225 = t222 + t224;
    const double t227 = 0.03625055341190064 * t203;
    work->t228 = t225 + t227;
    const double t229 = state->age_y[work->t202];
    const double t230 = 5.272062832054933e-22 * t229;
    const double t231 = t230 + 3.207869236890387e-20;
    const double t232 = t231 * t229;
    const double t233 = t232 + 1.7892217754977797e-18;
    const double t234 = t233 * t229;
    const double t235 = t234 + 9.072333535001539e-17;
    const double t236 = t235 * t229;
    const double t237 = t236 + 4.140152618468725e-15;
    const double t238 = t237 * t229;
    const double t239 = t238 + 1.6794271487480158e-13;
    const double t240 = t239 * t229;
    const double t241 = t240 + 5.9609292152777776e-12;
    const double t242 = t241 * t229;
    const double t243 = t242 + 1.8134934166666665e-10;
    const double t244 = t243 * t229;
    const double t245 = t244 + 4.5954583333333335e-9;
    const double t246 = t245 * t229;
    const double t247 = t246 + 9.083333333333333e-8;
    const double t248 = t247 * t229;
    const double t249 = t248 + -5e-7;
    const double t250 = t249 * t229;
    const double t251 = t250 + -0.001;
    const double t252 = t251 * t229;
    const double t253 = 2.841951408392815e-21 * t229;
    const double t254 = t253 + 1.7292298643123669e-19;
    const double t255 = t254 * t229;
    const double t256 = t255 + 9.644955886880351e-18;
    const double t257 = t256 * t229;
    const double t258 = t257 + 4.890520444952687e-16;
    const double t259 = t258 * t229;
    const double t260 = t259 + 2.2317853448672246e-14;
    const double t261 = t260 * t229;
    const double t262 = t261 + 9.053098415625e-13;
    const double t263 = t262 * t229;
    const double t264 = t263 + 3.2132914145833336e-11;
    const double t265 = t264 * t229;
    const double t266 = t265 + 9.77588625e-10;
    const double t267 = t266 * t229;
    const double t268 = t267 + 2.4784375e-8;
    const double t269 = t268 * t229;
    const double t270 = t269 + 5.025e-7;
    const double t271 = t270 * t229;
    const double t272 = t271 + 7.5e-6;
    const double t273 = t272 * t229;
    const double t274 = t273 * t229;
    const double t275 = gains[0];
    const double t276 = gains[3];
    const double t277 = t252 * t276;
    const double t278 = gains[6];
    const double t279 = t274 * t278;
    const double t280 = t275 + t277;
    work->t281 = t280 + t279;
    const double t282 = gains[1];
    const double t283 = gains[4];
    const double t284 = t252 * t283;
    const double t285 = gains[7];
    const double t286 = t274 * t285;
    const double t287 = t282 + t284;
    work->t288 = t287 + t286;
    const double t289 = gains[2];
    const double t290 = gains[5];
    const double t291 = t252 * t290;
    const double t292 = gains[8];
    const double t293 = t274 * t292;
    const double t294 = t289 + t291;
    work->t295 = t294 + t293;
    work->t296 = state->has_y[work->t202];
    work->t297 = state->y[work->t202];
    const double t298 = t252 * work->t220;
    work->t299 = t274 * work->t228;
    work->t300 = work->t212 + t298;
}

/* Part 4 of a step, for one row of BUS_SENSOR_ROWS. */
static void bus_sensor_part_4(bus_sensor_work *work)
{
    const double t301 = work->t300 + work->t299;
    const double t302 = work->t297 - t301;
    const double t303 = work->t296 * work->t281;
    const double t304 = work->t296 * work->t288;
    const double t305 = work->t296 * work->t295;
    const double t306 = t303 * t303;
    work->t307 = work->t189 + t306;
    const double t308 = t303 * t304;
    work->t309 = work->t190 + t308;
    const double t310 = t303 * t305;
    work->t311 = work->t191 + t310;
    const double t312 = t304 * t304;
    work->t313 = work->t192 + t312;
    const double t314 = t304 * t305;
    work->t315 = work->t193 + t314;
    const double t316 = t305 * t305;
    work->t317 = work->t194 + t316;
    const double t318 = t303 * t302;
    work->t319 = work->t195 + t318;
    const double t320 = t304 * t302;
    work->t321 = work->t196 + t320;
    const double t322 = t305 * t302;
    work->t323 = work->t197 + t322;
}

/* Part 5 of a step. */
static void bus_sensor_part_5(const bus_sensor_state *state, bus_sensor_work *work)
{
    work->t189 = work->t172;
    work->t190 = work->t174;
    work->t191 = work->t176;
    work->t192 = work->t178;
    work->t193 = work->t180;
    work->t194 = work->t182;
    work->t195 = work->t184;
    work->t196 = work->t186;
    work->t197 = work->t188;
    work->t198 = 0.0;
    work->t199 = 0.0;
    work->t200 = 0.0;
    work->t201 = work->t76;
    for (uint32_t row = 0U; row < 50U; ++row) {
        const double *const gains = BUS_SENSOR_ROWS[row];
        bus_sensor_part_3(state, work, gains);
        bus_sensor_part_4(work);
        work->t189 = work->t307;
        work->t190 = work->t309;
        work->t191 = work->t311;
        work->t192 = work->t313;
        work->t193 = work->t315;
        work->t194 = work->t317;
        work->t195 = work->t319;
        work->t196 = work->t321;
        work->t197 = work->t323;
        work->t198 = work->t212;
        work->t199 = work->t220;
        work->t200 = work->t228;
        work->t201 = work->t202;
    }
}

/* Part 6 of a step. */
static void bus_sensor_part_6(bus_sensor_work *work)
{
    /* the window's start from the samples that are there */
    const int t325 = 0.015625000000000003 < work->t189;
    const double t326 = t325 ? work->t189 : 1.0;
    const double t327 = work->t190 / t326;
    const double t328 = t327 * work->t190;
    const double t329 = work->t192 - t328;
    const double t330 = t327 * work->t191;
    const double t331 = work->t193 - t330;
    const double t332 = t327 * work->t195;
    const double t333 = work->t196 - t332;
    const double t334 = work->t191 / t326;
    const double t335 = t334 * work->t191;
    const double t336 = work->t194 - t335;
    const double t337 = t334 * work->t195;
    const double t338 = work->t197 - t337;
    const int t339 = 0.015625000000000003 < t329;
    const int t340 = t325 && t339;
    const double t341 = t339 ? t329 : 1.0;
    const double t342 = t331 / t341;
    const double t343 = t342 * t331;
    const double t344 = t336 - t343;
    const double t345 = t342 * t333;
    const double t346 = t338 - t345;
    const int t347 = 0.015625000000000003 < t344;
    work->flags[1] = t340 && t347;
    const double t349 = t347 ? t344 : 1.0;
    const double t350 = t346 / t349;
    const double t351 = t331 * t350;
    const double t352 = t333 - t351;
    const double t353 = t352 / t341;
    const double t354 = work->t190 * t353;
    const double t355 = work->t195 - t354;
    const double t356 = work->t191 * t350;
    const double t357 = t355 - t356;
    const double t358 = t357 / t326;
    const double t359 = 0.14002800840280097 * t358;
    const double t361 = 0.23065075767231122 * t353;
    const double t363 = 0.13134988436088954 * t350;
    const double t364 = t359 + t361;
    const double t365 = t364 + t363;
    work->t366 = t365 + work->t198;
    const double t368 = 8.651118877863917 * t353;
    const double t370 = 8.618146699003066 * t350;
    const double t371 = t368 + t370;
    work->t372 = t371 + work->t199;
    const double t374 = -1.6047567777194058 * t353;
    const double t376 = -1.4790579250578624 * t350;
    const double t377 = t374 + t376;
    work->t378 = t377 + work->t200;
}

/* Part 7 of a step. */
static void bus_sensor_part_7(bus_sensor_state *state, bus_sensor_work *work)
{
    /* without enough samples, the model's prediction */
    const uint32_t t379 = state->known;
    const int t380 = t379 == 1U;
    const double t381 = state->next_q;
    const double t383 = 9.51669369298718e-8 * work->t7;
    const double t384 = t381 + t383;
    const int t385 = (-1e297 <= t384) && (t384 <= 1e297);
    const int t386 = t380 && t385;
    const double t387 = work->flags[1] ? work->t366 : t384;
    const double t388 = state->next_dq;
    const double t390 = 0.00028085352143270324 * work->t7;
    const double t391 = t388 + t390;
    const int t392 = (-1e297 <= t391) && (t391 <= 1e297);
    const int t393 = t386 && t392;
    const double t394 = work->flags[1] ? work->t372 : t391;
    const double t395 = state->next_i;
    const double t397 = 0.03625055341190064 * work->t7;
    const double t398 = t395 + t397;
    const int t399 = (-1e297 <= t398) && (t398 <= 1e297);
    const int t400 = t393 && t399;
    const double t401 = work->flags[1] ? work->t378 : t398;
    const int t402 = work->flags[1] || t400;
    const int t403 = work->flags[0] && t402;
    const uint32_t t404 = t403 ? 1U : 0U;
    state->known = t404;
    const double t406 = 0.000999413586572696 * t394;
    const double t408 = 7.021338035817581e-6 * t401;
    const double t409 = t387 + t406;
    const double t410 = t409 + t408;
    const int t411 = (-1e297 <= t410) && (t410 <= 1e297);
    const double t412 = t411 ? t410 : 0.0;
    state->next_q = t412;
    const double t414 = 0.9987450097089235 * t394;
    const double t416 = 0.013586936191426924 * t401;
    const double t417 = t414 + t416;
    const int t418 = (-1e297 <= t417) && (t417 <= 1e297);
    const double t419 = t418 ? t417 : 0.0;
    state->next_dq = t419;
    const double t421 = -0.03297096515786267 * t394;
    const double t423 = 0.8184916562359931 * t401;
    const double t424 = t421 + t423;
    const int t425 = (-1e297 <= t424) && (t424 <= 1e297);
    const double t426 = t425 ? t424 : 0.0;
    state->next_i = t426;

    /* the estimate; until there is one, the start */
    work->t427 = t403 ? t387 : work->t61;
    work->t428 = t403 ? t394 : 0.0;
    work->t429 = t403 ? t401 : 0.0;
    const uint32_t t430 = state->coasting;
    const int t431 = t430 == 0U;
    const int t432 = work->flags[1] && t431;
    const bus_sensor_status t436 = t432 ? BUS_SENSOR_CONVERGED : BUS_SENSOR_COASTING;
    work->t437 = t403 ? t436 : BUS_SENSOR_CONVERGING;
}

void bus_sensor_init(bus_sensor_state *state)
{
    for (uint32_t slot = 0U; slot < 51U; ++slot) {
        state->y[slot] = 0.0;
    }
    for (uint32_t slot = 0U; slot < 51U; ++slot) {
        state->u[slot] = 0.0;
    }
    state->newest = 50U;
    state->count = 0U;
    state->coasting = 0U;
    state->calls = 0U;
    for (uint32_t slot = 0U; slot < 51U; ++slot) {
        state->has_y[slot] = 0.0;
    }
    state->next_q = 0.0;
    state->next_dq = 0.0;
    state->next_i = 0.0;
    state->known = 0U;
    state->since = 0U;
    for (uint32_t slot = 0U; slot < 51U; ++slot) {
        state->age_y[slot] = 0.0;
    }
}

void bus_sensor_step(bus_sensor_state *state, const bus_sensor_measurements *measurements,
                     const bus_sensor_inputs *inputs, bus_sensor_estimate *estimate)
{
    bus_sensor_work work;
    bus_sensor_part_1(state, measurements, inputs, &work);
    bus_sensor_part_2(state, &work);
    bus_sensor_part_5(state, &work);
    bus_sensor_part_6(&work);
    bus_sensor_part_7(state, &work);

    estimate->q = work.t427;
    estimate->dq = work.t428;
    estimate->i = work.t429;
    estimate->coasted = work.t64;
    estimate->status = work.t437;
}
