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
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
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
    uint32_t t15;
    double t19;
    double t23;
    double t27;
    uint32_t t34;
    double t76;
    uint32_t t88;
    double t176;
    double t185;
    double t187;
    double t189;
    double t191;
    double t193;
    double t195;
    double t197;
    double t199;
    double t201;
    double t202;
    double t203;
    double t204;
    double t205;
    double t206;
    double t207;
    double t208;
    double t209;
    double t210;
    double t211;
    double t212;
    double t213;
    double t214;
    uint32_t t215;
    uint32_t t216;
    double t225;
    double t232;
    double t239;
    double t292;
    double t299;
    double t306;
    double t307;
    double t308;
    double t309;
    double t310;
    double t311;
    double t319;
    double t321;
    double t323;
    double t325;
    double t327;
    double t329;
    double t331;
    double t333;
    double t335;
    double t407;
    double t412;
    double t417;
    double t419;
    double t421;
    double t423;
    double t496;
    double t497;
    double t498;
    bus_sensor_status t506;
    int flags[2]; /* t87, t400 */
} bus_sensor_work;

/* Part 1 of a step. */
static void bus_sensor_part_1(bus_sensor_state *state, const bus_sensor_measurements *measurements, const bus_sensor_inputs *inputs, bus_sensor_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    const uint32_t t0 = state->newest;
    const uint32_t t1 = (t0 < 50U) ? t0 : 50U;
    const double t2 = measurements->y;
    const int t3 = (-1e300 <= t2) && (t2 <= 1e300);
    const double t4 = inputs->u;
    const int t5 = (-1e300 <= t4) && (t4 <= 1e300);
    const double t6 = state->u[t1];
    const double t7 = t5 ? t4 : t6;
    const double t8 = measurements->y_age;
    const int t9 = (0.0 <= t8) && (t8 <= 0.001);
    const int t10 = t3 && t9;
    const double t12 = t8 * 1000.0;
    const double t14 = t10 ? t12 : 0.0;
    work->t15 = (t1 < 50U) ? (t1 + 1U) : 0U;
    const double t16 = state->next_q;
    const double t18 = 9.51669369298718e-8 * t7;
    work->t19 = t16 + t18;
    const double t20 = state->next_dq;
    const double t22 = 0.00028085352143270324 * t7;
    work->t23 = t20 + t22;
    const double t24 = state->next_i;
    const double t26 = 0.03625055341190064 * t7;
    work->t27 = t24 + t26;
    const double t29 = state->y[t1];
    const double t30 = t10 ? t2 : t29;
    const uint32_t t32 = state->since;
    const uint32_t t33 = (t32 < 4294967295U) ? (t32 + 1U) : 4294967295U;
    work->t34 = t10 ? 0U : t33;
    state->since = work->t34;
    const uint32_t t35 = state->calls;
    const int t36 = 0U < t35;
    const int t37 = t10 && t36;
    const double t38 = t37 ? 1.0 : 0.0;
    const uint32_t t39 = state->count;
    const double t41 = 8.744465871977893e-24 * t14;
    const double t43 = t41 + 5.76409954770789e-22;
    const double t44 = t43 * t14;
    const double t46 = t44 + 3.50725668613831e-20;
    const double t47 = t46 * t14;
    const double t49 = t47 + 1.956208177981075e-18;
    const double t50 = t49 * t14;
    const double t52 = t50 + 9.919045977187666e-17;
    const double t53 = t52 * t14;
    const double t55 = t53 + 4.5265492078125e-15;
    const double t56 = t55 * t14;
    const double t58 = t56 + 1.8361665226190475e-13;
    const double t59 = t58 * t14;
    const double t61 = t59 + 6.5172575e-12;
    const double t62 = t61 * t14;
    const double t64 = t62 + 1.98275e-10;
    const double t65 = t64 * t14;
    const double t67 = t65 + 5.025e-9;
    const double t68 = t67 * t14;
    const double t70 = t68 + 1e-7;
    const double t71 = t70 * t14;
    const double t72 = t71 * t14;
    const double t73 = t72 * t14;
    const double t74 = t73 * t7;
    const double t75 = t30 + t74;
    work->t76 = t10 ? t75 : t30;

    /* how much of the window is good */
    const int t78 = 50U < t39;
    const uint32_t t80 = (t39 < 51U) ? (t39 + 1U) : 51U;
    const uint32_t t81 = t5 ? t80 : 1U;
    const uint32_t t82 = t78 ? t80 : t81;
    state->count = t82;
    const uint32_t t83 = state->coasting;
    const uint32_t t84 = (t83 > 0U) ? (t83 - 1U) : 0U;
    const uint32_t t85 = t5 ? t84 : 50U;
    state->coasting = t85;

    /* into the window */
    state->newest = work->t15;
    state->y[work->t15] = work->t76;
    state->has_y[work->t15] = t38;
    state->age_y[work->t15] = t14;
    state->u[work->t15] = t7;
    const uint32_t t86 = (t35 < 4294967295U) ? (t35 + 1U) : 4294967295U;
    state->calls = t86;
    work->flags[0] = 50U < t82;
}

/* Part 2 of a step. */
static void bus_sensor_part_2(const bus_sensor_state *state, bus_sensor_work *work)
{
    /* rows of the window, oldest first; those without a sample count nothing */
    work->t88 = (work->t15 < 50U) ? (work->t15 + 1U) : 0U;
    const double t89 = state->age_y[work->t88];
    const double t91 = 5.272062832054933e-22 * t89;
    const double t93 = t91 + 3.207869236890387e-20;
    const double t94 = t93 * t89;
    const double t96 = t94 + 1.7892217754977797e-18;
    const double t97 = t96 * t89;
    const double t99 = t97 + 9.072333535001539e-17;
    const double t100 = t99 * t89;
    const double t102 = t100 + 4.140152618468725e-15;
    const double t103 = t102 * t89;
    const double t105 = t103 + 1.6794271487480158e-13;
    const double t106 = t105 * t89;
    const double t108 = t106 + 5.9609292152777776e-12;
    const double t109 = t108 * t89;
    const double t111 = t109 + 1.8134934166666665e-10;
    const double t112 = t111 * t89;
    const double t114 = t112 + 4.5954583333333335e-9;
    const double t115 = t114 * t89;
    const double t117 = t115 + 9.083333333333333e-8;
    const double t118 = t117 * t89;
    const double t120 = t118 + -5e-7;
    const double t121 = t120 * t89;
    const double t123 = t121 + -0.001;
    const double t124 = t123 * t89;
    const double t126 = 2.841951408392815e-21 * t89;
    const double t128 = t126 + 1.7292298643123669e-19;
    const double t129 = t128 * t89;
    const double t131 = t129 + 9.644955886880351e-18;
    const double t132 = t131 * t89;
    const double t134 = t132 + 4.890520444952687e-16;
    const double t135 = t134 * t89;
    const double t137 = t135 + 2.2317853448672246e-14;
    const double t138 = t137 * t89;
    const double t140 = t138 + 9.053098415625e-13;
    const double t141 = t140 * t89;
    const double t143 = t141 + 3.2132914145833336e-11;
    const double t144 = t143 * t89;
    const double t146 = t144 + 9.77588625e-10;
    const double t147 = t146 * t89;
    const double t149 = t147 + 2.4784375e-8;
    const double t150 = t149 * t89;
    const double t152 = t150 + 5.025e-7;
    const double t153 = t152 * t89;
    const double t155 = t153 + 7.5e-6;
    const double t156 = t155 * t89;
    const double t157 = t156 * t89;
    const double t159 = t124 * 0.0;
    const double t160 = t157 * 0.0;
    const double t161 = 0.14002800840280097 + t159;
    const double t162 = t161 + t160;
    const double t165 = t124 * 10.304061080238904;
    const double t166 = -0.2447645132938934 + t165;
    const double t167 = t166 + t160;
    const double t170 = t124 * -167.44782171324155;
    const double t172 = t157 * 2324.8312399871534;
    const double t173 = 0.5583461494624352 + t170;
    const double t174 = t173 + t172;
    const double t175 = state->has_y[work->t88];
    work->t176 = 0.0 + t175;
    const double t177 = state->y[work->t88];
    const double t178 = 0.0 + t159;
    const double t179 = t178 + t160;
    const double t180 = t177 - t179;
    const double t181 = t175 * t162;
    const double t182 = t175 * t167;
    const double t183 = t175 * t174;
    const double t184 = t181 * t181;
    work->t185 = 0.0 + t184;
    const double t186 = t181 * t182;
    work->t187 = 0.0 + t186;
    const double t188 = t181 * t183;
    work->t189 = 0.0 + t188;
    const double t190 = t182 * t182;
    work->t191 = 0.0 + t190;
    const double t192 = t182 * t183;
    work->t193 = 0.0 + t192;
    const double t194 = t183 * t183;
    work->t195 = 0.0 + t194;
    const double t196 = t181 * t180;
    work->t197 = 0.0 + t196;
    const double t198 = t182 * t180;
    work->t199 = 0.0 + t198;
    const double t200 = t183 * t180;
    work->t201 = 0.0 + t200;
}

/* Part 3 of a step, for one row of BUS_SENSOR_ROWS. */
static void bus_sensor_part_3(const bus_sensor_state *state, bus_sensor_work *work, const double *gains)
{
    work->t216 = (work->t215 < 50U) ? (work->t215 + 1U) : 0U;
    const double t217 = state->u[work->t216];
    const double t219 = 0.000999413586572696 * work->t212;
    const double t221 = 7.021338035817581e-6 * work->t213;
    const double t222 = work->t211 + t219;
    const double t223 = t222 + t221;
    const double t224 = 9.51669369298718e-8 * t217;
    work->t225 = t223 + t224;
    const double t227 = 0.9987450097089235 * work->t212;
    const double t229 = 0.013586936191426924 * work->t213;
    const double t230 = t227 + t229;
    const double t231 = 0.00028085352143270324 * t217;
    work->t232 = t230 + t231;
    const double t234 = -0.03297096515786267 * work->t212;
    const double t236 = 0.8184916562359931 * work->t213;
    const double t237 = t234 + t236;
    const double t238 = 0.03625055341190064 * t217;
    work->t239 = t237 + t238;
    const double t240 = state->age_y[work->t216];
    const double t241 = 5.272062832054933e-22 * t240;
    const double t242 = t241 + 3.207869236890387e-20;
    const double t243 = t242 * t240;
    const double t244 = t243 + 1.7892217754977797e-18;
    const double t245 = t244 * t240;
    const double t246 = t245 + 9.072333535001539e-17;
    const double t247 = t246 * t240;
    const double t248 = t247 + 4.140152618468725e-15;
    const double t249 = t248 * t240;
    const double t250 = t249 + 1.6794271487480158e-13;
    const double t251 = t250 * t240;
    const double t252 = t251 + 5.9609292152777776e-12;
    const double t253 = t252 * t240;
    const double t254 = t253 + 1.8134934166666665e-10;
    const double t255 = t254 * t240;
    const double t256 = t255 + 4.5954583333333335e-9;
    const double t257 = t256 * t240;
    const double t258 = t257 + 9.083333333333333e-8;
    const double t259 = t258 * t240;
    const double t260 = t259 + -5e-7;
    const double t261 = t260 * t240;
    const double t262 = t261 + -0.001;
    const double t263 = t262 * t240;
    const double t264 = 2.841951408392815e-21 * t240;
    const double t265 = t264 + 1.7292298643123669e-19;
    const double t266 = t265 * t240;
    const double t267 = t266 + 9.644955886880351e-18;
    const double t268 = t267 * t240;
    const double t269 = t268 + 4.890520444952687e-16;
    const double t270 = t269 * t240;
    const double t271 = t270 + 2.2317853448672246e-14;
    const double t272 = t271 * t240;
    const double t273 = t272 + 9.053098415625e-13;
    const double t274 = t273 * t240;
    const double t275 = t274 + 3.2132914145833336e-11;
    const double t276 = t275 * t240;
    const double t277 = t276 + 9.77588625e-10;
    const double t278 = t277 * t240;
    const double t279 = t278 + 2.4784375e-8;
    const double t280 = t279 * t240;
    const double t281 = t280 + 5.025e-7;
    const double t282 = t281 * t240;
    const double t283 = t282 + 7.5e-6;
    const double t284 = t283 * t240;
    const double t285 = t284 * t240;
    const double t286 = gains[0];
    const double t287 = gains[3];
    const double t288 = t263 * t287;
    const double t289 = gains[6];
    const double t290 = t285 * t289;
    const double t291 = t286 + t288;
    work->t292 = t291 + t290;
    const double t293 = gains[1];
    const double t294 = gains[4];
    const double t295 = t263 * t294;
    const double t296 = gains[7];
    const double t297 = t285 * t296;
    const double t298 = t293 + t295;
    work->t299 = t298 + t297;
    const double t300 = gains[2];
    const double t301 = gains[5];
    const double t302 = t263 * t301;
    const double t303 = gains[8];
    const double t304 = t285 * t303;
    const double t305 = t300 + t302;
    work->t306 = t305 + t304;
    work->t307 = state->has_y[work->t216];
    work->t308 = work->t214 + work->t307;
    work->t309 = state->y[work->t216];
    work->t310 = t263 * work->t232;
    work->t311 = t285 * work->t239;
}

/* Part 4 of a step, for one row of BUS_SENSOR_ROWS. */
static void bus_sensor_part_4(bus_sensor_work *work)
{
    const double t312 = work->t225 + work->t310;
    const double t313 = t312 + work->t311;
    const double t314 = work->t309 - t313;
    const double t315 = work->t307 * work->t292;
    const double t316 = work->t307 * work->t299;
    const double t317 = work->t307 * work->t306;
    const double t318 = t315 * t315;
    work->t319 = work->t202 + t318;
    const double t320 = t315 * t316;
    work->t321 = work->t203 + t320;
    const double t322 = t315 * t317;
    work->t323 = work->t204 + t322;
    const double t324 = t316 * t316;
    work->t325 = work->t205 + t324;
    const double t326 = t316 * t317;
    work->t327 = work->t206 + t326;
    const double t328 = t317 * t317;
    work->t329 = work->t207 + t328;
    const double t330 = t315 * t314;
    work->t331 = work->t208 + t330;
    const double t332 = t316 * t314;
    work->t333 = work->t209 + t332;
    const double t334 = t317 * t314;
    work->t335 = work->t210 + t334;
}

/* Part 5 of a step. */
static void bus_sensor_part_5(const bus_sensor_state *state, bus_sensor_work *work)
{
    work->t202 = work->t185;
    work->t203 = work->t187;
    work->t204 = work->t189;
    work->t205 = work->t191;
    work->t206 = work->t193;
    work->t207 = work->t195;
    work->t208 = work->t197;
    work->t209 = work->t199;
    work->t210 = work->t201;
    work->t211 = 0.0;
    work->t212 = 0.0;
    work->t213 = 0.0;
    work->t214 = work->t176;
    work->t215 = work->t88;
    for (uint32_t row = 0U; row < 50U; ++row) {
        const double *const gains = BUS_SENSOR_ROWS[row];
        bus_sensor_part_3(state, work, gains);
        bus_sensor_part_4(work);
        work->t202 = work->t319;
        work->t203 = work->t321;
        work->t204 = work->t323;
        work->t205 = work->t325;
        work->t206 = work->t327;
        work->t207 = work->t329;
        work->t208 = work->t331;
        work->t209 = work->t333;
        work->t210 = work->t335;
        work->t211 = work->t225;
        work->t212 = work->t232;
        work->t213 = work->t239;
        work->t214 = work->t308;
        work->t215 = work->t216;
    }
}

/* Part 6 of a step. */
static void bus_sensor_part_6(bus_sensor_work *work)
{
    /* the state from the samples that are there, and its variance */
    const double t345 = 1e-12 * work->t202;
    const double t346 = t345 + 1.0020841800044864e-292;
    const double t347 = 1e-12 * work->t205;
    const double t348 = t347 + 1.0020841800044864e-292;
    const double t349 = 1e-12 * work->t207;
    const double t350 = t349 + 1.0020841800044864e-292;
    const int t351 = t346 < work->t202;
    const double t352 = t351 ? work->t202 : 1.0;
    const double t353 = work->t203 / t352;
    const double t354 = work->t204 / t352;
    const double t355 = t353 * work->t203;
    const double t356 = work->t205 - t355;
    const double t357 = t353 * work->t204;
    const double t358 = work->t206 - t357;
    const double t359 = t353 * work->t208;
    const double t360 = work->t209 - t359;
    const double t361 = t354 * work->t204;
    const double t362 = work->t207 - t361;
    const double t363 = t354 * work->t208;
    const double t364 = work->t210 - t363;
    const double t365 = work->t208 / t352;
    const double t366 = t353 * 0.07001400420140048;
    const double t367 = 0.11532537883615561 - t366;
    const double t368 = t354 * 0.07001400420140048;
    const double t369 = 0.06567494218044477 - t368;
    const double t370 = 0.07001400420140048 * t365;
    const double t371 = 0.07001400420140048 / t352;
    const double t372 = 0.07001400420140048 * t371;
    const int t373 = t348 < t356;
    const int t374 = t351 && t373;
    const double t375 = t373 ? t356 : 1.0;
    const double t376 = t358 / t375;
    const double t377 = t376 * t358;
    const double t378 = t362 - t377;
    const double t379 = t376 * t360;
    const double t380 = t364 - t379;
    const double t381 = t360 / t375;
    const double t382 = t376 * t367;
    const double t383 = t369 - t382;
    const double t384 = t367 * t381;
    const double t385 = t370 + t384;
    const double t386 = t367 / t375;
    const double t387 = t367 * t386;
    const double t388 = t372 + t387;
    const double t389 = t376 * 0.06758686623331185;
    const double t390 = 0.06732927108596146 - t389;
    const double t391 = 0.06758686623331185 * t381;
    const double t392 = 0.06758686623331185 / t375;
    const double t393 = 0.06758686623331185 * t392;
    const double t394 = t376 * -0.10029729860746286;
    const double t395 = -0.0924411203161164 - t394;
    const double t396 = -0.10029729860746286 * t381;
    const double t397 = -0.10029729860746286 / t375;
    const double t398 = -0.10029729860746286 * t397;
    const int t399 = t350 < t378;
    work->flags[1] = t374 && t399;
    const double t401 = t399 ? t378 : 1.0;
    const double t402 = t380 / t401;
    const double t403 = t383 * t402;
    const double t404 = t385 + t403;
    const double t405 = t383 / t401;
    const double t406 = t383 * t405;
    work->t407 = t388 + t406;
    const double t408 = t390 * t402;
    const double t409 = t391 + t408;
    const double t410 = t390 / t401;
    const double t411 = t390 * t410;
    work->t412 = t393 + t411;
    const double t413 = t395 * t402;
    const double t414 = t396 + t413;
    const double t415 = t395 / t401;
    const double t416 = t395 * t415;
    work->t417 = t398 + t416;
    work->t419 = 2.0 * t404;
    work->t421 = 128.0 * t409;
    work->t423 = 16.0 * t414;
}

/* Part 7 of a step. */
static void bus_sensor_part_7(bus_sensor_state *state, bus_sensor_work *work)
{
    /* what it is worth */
    const double t425 = work->t407 * 0.3046924597603206;
    const int t426 = 0.0 < t425;
    const double t427 = t426 ? t425 : 0.0;
    const double t429 = work->t412 * 0.6570500509555168;
    const int t430 = t427 < t429;
    const double t431 = t430 ? t429 : t427;
    const double t433 = work->t417 * 0.32103940224620026;
    const int t434 = t431 < t433;
    const double t435 = t434 ? t433 : t431;
    const int t438 = t435 <= 482054.65062239644;
    const int t439 = work->flags[1] && t438;
    const int t440 = t435 <= 0.48205465062239644;
    const int t441 = t439 && t440;
    const double t442 = work->t214 + 0.0;
    const double t443 = t435 * t442;
    const int t444 = t443 <= 1.0;
    const int t445 = t441 && t444;
    const int t446 = 0.0 < work->t214;
    const double t447 = work->t419 + work->t211;
    const double t448 = work->t421 + work->t212;
    const double t449 = work->t423 + work->t213;

    /* without enough samples, the model's prediction */
    const uint32_t t450 = state->known;
    const int t451 = t450 == 1U;
    const int t452 = (-1e300 <= work->t19) && (work->t19 <= 1e300);
    const int t453 = t451 && t452;
    const int t454 = (-1e300 <= work->t23) && (work->t23 <= 1e300);
    const int t455 = t453 && t454;
    const int t456 = (-1e300 <= work->t27) && (work->t27 <= 1e300);
    const int t457 = t455 && t456;
    const uint32_t t458 = state->poor;
    const uint32_t t459 = (t458 < 153U) ? (t458 + 1U) : 153U;
    const uint32_t t460 = t446 ? t459 : t458;
    const uint32_t t461 = t441 ? 0U : t460;
    state->poor = t461;
    const int t463 = t461 < 153U;
    const int t464 = t463 && t457;
    const int t465 = !t464;
    const int t466 = t441 || t465;
    const int t467 = t439 && t466;
    const double t468 = t467 ? t447 : work->t19;
    const double t469 = t467 ? t448 : work->t23;
    const double t470 = t467 ? t449 : work->t27;
    const int t471 = t467 || t457;
    const int t472 = work->flags[0] && t471;
    const uint32_t t473 = t472 ? 1U : 0U;
    state->known = t473;
    const double t475 = 0.000999413586572696 * t469;
    const double t477 = 7.021338035817581e-6 * t470;
    const double t478 = t468 + t475;
    const double t479 = t478 + t477;
    const int t480 = (-1e300 <= t479) && (t479 <= 1e300);
    const double t481 = t480 ? t479 : 0.0;
    state->next_q = t481;
    const double t483 = 0.9987450097089235 * t469;
    const double t485 = 0.013586936191426924 * t470;
    const double t486 = t483 + t485;
    const int t487 = (-1e300 <= t486) && (t486 <= 1e300);
    const double t488 = t487 ? t486 : 0.0;
    state->next_dq = t488;
    const double t490 = -0.03297096515786267 * t469;
    const double t492 = 0.8184916562359931 * t470;
    const double t493 = t490 + t492;
    const int t494 = (-1e300 <= t493) && (t493 <= 1e300);
    const double t495 = t494 ? t493 : 0.0;
    state->next_i = t495;

    /* the estimate; until there is one, the start */
    work->t496 = t472 ? t468 : work->t76;
    work->t497 = t472 ? t469 : 0.0;
    work->t498 = t472 ? t470 : 0.0;
    const uint32_t t499 = state->coasting;
    const int t500 = t499 == 0U;
    const int t501 = t445 && t500;
    const bus_sensor_status t505 = t501 ? BUS_SENSOR_CONVERGED : BUS_SENSOR_COASTING;
    work->t506 = t472 ? t505 : BUS_SENSOR_CONVERGING;
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
    state->poor = 153U;
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

    estimate->q = work.t496;
    estimate->dq = work.t497;
    estimate->i = work.t498;
    estimate->coasted = work.t34;
    estimate->status = work.t506;
}
