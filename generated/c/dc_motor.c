/* dc_motor.c: Finite-time observer: Direct-drive arm on a permanent-magnet DC motor.
 *
 * Generated; dc_motor.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "dc_motor.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "dc_motor.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "dc_motor.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* weights by age, from age 0
 *   [0] q from y
 *   [1] dq from y
 *   [2] i from y
 *   [3] q from u
 *   [4] dq from u
 *   [5] i from u
 *   [6] q from sin(q)
 *   [7] dq from sin(q)
 *   [8] i from sin(q)
 */
static const float DC_MOTOR_WINDOW[100][9] = {
    {
        0.039815735f, 0.570504f, -0.105833046f, 9.137779e-8f, 0.00028079923f, 0.036250565f,
        -5.599527e-6f, -0.017490076f, 0.00020145394f
    },
    {
        0.03924415f, 0.55918366f, -0.10373303f, 6.0154923e-7f, 0.0007726222f, 0.029661592f,
        -3.3353706e-5f, -0.034931563f, 0.001132136f
    },
    {
        0.0386704f, 0.5478204f, -0.101625055f, 1.5186571e-6f, 0.0011737501f, 0.024252461f,
        -6.5520166e-5f, -0.034832835f, 0.0020710428f
    },
    {
        0.038094476f, 0.536414f, -0.09950909f, 2.7469714e-6f, 0.0015001289f, 0.019812046f,
        -9.627276e-5f, -0.034702234f, 0.0028327052f
    },
    {
        0.037516367f, 0.52496445f, -0.09738511f, 4.2082956e-6f, 0.0017648572f, 0.016167011f,
        -0.00012562309f, -0.03454257f, 0.0034483122f
    },
    {
        0.036936067f, 0.5134715f, -0.09525307f, 5.838829e-6f, 0.001978697f, 0.013175043f,
        -0.00015358534f, -0.03435625f, 0.0039434857f
    },
    {
        0.03635357f, 0.50193495f, -0.09311296f, 7.586589e-6f, 0.0021504906f, 0.010719301f,
        -0.00018017576f, -0.03414532f, 0.004339278f
    },
    {
        0.035768867f, 0.49035472f, -0.090964735f, 9.409297e-6f, 0.002287506f, 0.008703855f,
        -0.00020541236f, -0.03391156f, 0.0046529886f
    },
    {
        0.035181943f, 0.4787306f, -0.08880837f, 1.12726375e-5f, 0.002395716f, 0.007049943f,
        -0.00022931454f, -0.033656497f, 0.0048988364f
    },
    {
        0.0345928f, 0.4670624f, -0.08664383f, 1.3148837e-5f, 0.002480033f, 0.0056929f,
        -0.00025190282f, -0.03338149f, 0.00508851f
    },
    {
        0.03400142f, 0.45535004f, -0.08447109f, 1.501549e-5f, 0.002544497f, 0.0045796353f,
        -0.00027319876f, -0.033087716f, 0.0052316235f
    },
    {
        0.0334078f, 0.44359323f, -0.08229012f, 1.68546e-5f, 0.0025924316f, 0.003666557f,
        -0.00029322458f, -0.03277625f, 0.0053360844f
    },
    {
        0.032811932f, 0.4317919f, -0.08010088f, 1.8651786e-5f, 0.0026265734f, 0.0029178758f,
        -0.0003120032f, -0.032448046f, 0.0054084007f
    },
    {
        0.032213807f, 0.41994584f, -0.077903345f, 2.0395639e-5f, 0.0026491764f, 0.0023042061f,
        -0.00032955804f, -0.03210397f, 0.0054539316f
    },
    {
        0.031613413f, 0.4080549f, -0.07569748f, 2.207719e-5f, 0.0026620983f, 0.0018014214f,
        -0.00034591297f, -0.031744823f, 0.0054770927f
    },
    {
        0.031010743f, 0.39611888f, -0.07348326f, 2.3689472e-5f, 0.0026668713f, 0.0013897117f,
        -0.0003610921f, -0.031371348f, 0.005481525f
    },
    {
        0.03040579f, 0.38413763f, -0.07126064f, 2.5227157e-5f, 0.002664761f, 0.0010528115f,
        -0.00037511994f, -0.030984232f, 0.005470233f
    },
    {
        0.029798545f, 0.37211096f, -0.06902961f, 2.668627e-5f, 0.0026568132f, 0.00077736523f,
        -0.00038802117f, -0.030584129f, 0.005445699f
    },
    {
        0.029188998f, 0.36003876f, -0.06679011f, 2.806394e-5f, 0.0026438946f, 0.0005524066f,
        -0.00039982065f, -0.03017166f, 0.0054099774f
    },
    {
        0.028577141f, 0.34792078f, -0.06454214f, 2.935821e-5f, 0.002626723f, 0.00036893066f,
        -0.0004105434f, -0.029747419f, 0.0053647705f
    },
    {
        0.027962966f, 0.3357569f, -0.06228564f, 3.0567862e-5f, 0.0026058955f, 0.00021954307f,
        -0.00042021455f, -0.029311975f, 0.00531149f
    },
    {
        0.027346464f, 0.32354692f, -0.060020592f, 3.16923e-5f, 0.0025819098f, 9.8171484e-5f,
        -0.00042885932f, -0.028865883f, 0.0052513126f
    },
    {
        0.026727624f, 0.31129065f, -0.057746965f, 3.2731416e-5f, 0.0025551813f, -1.7081922e-7f,
        -0.00043650303f, -0.02840968f, 0.005185219f
    },
    {
        0.026106441f, 0.29898798f, -0.055464722f, 3.3685526e-5f, 0.0025260581f, -7.9579375e-5f,
        -0.000443171f, -0.027943894f, 0.00511403f
    },
    {
        0.025482904f, 0.28663868f, -0.053173833f, 3.4555283e-5f, 0.002494834f, -0.00014341799f,
        -0.00044888872f, -0.027469043f, 0.005038435f
    },
    {
        0.024857003f, 0.2742426f, -0.050874263f, 3.534161e-5f, 0.0024617568f, -0.00019444975f,
        -0.0004536816f, -0.02698563f, 0.004959016f
    },
    {
        0.024228733f, 0.26179954f, -0.048565984f, 3.6045665e-5f, 0.002427037f, -0.0002349445f,
        -0.00045757508f, -0.026494162f, 0.0048762662f
    },
    {
        0.023598082f, 0.24930938f, -0.046248958f, 3.6668793e-5f, 0.0023908557f, -0.00026676717f,
        -0.0004605947f, -0.02599513f, 0.004790606f
    },
    {
        0.022965042f, 0.2367719f, -0.04392316f, 3.7212485e-5f, 0.0023533676f, -0.0002914502f,
        -0.00046276595f, -0.025489027f, 0.0047023967f
    },
    {
        0.022329604f, 0.22418694f, -0.041588552f, 3.7678365e-5f, 0.0023147073f, -0.00031025312f,
        -0.00046411436f, -0.024976341f, 0.00461195f
    },
    {
        0.021691758f, 0.21155433f, -0.039245103f, 3.8068152e-5f, 0.002274993f, -0.00032421132f,
        -0.00046466547f, -0.024457555f, 0.0045195376f
    },
    {
        0.021051498f, 0.19887389f, -0.036892783f, 3.838366e-5f, 0.0022343285f, -0.0003341762f,
        -0.0004644448f, -0.023933152f, 0.0044253976f
    },
    {
        0.020408813f, 0.18614545f, -0.034531564f, 3.8626764e-5f, 0.0021928062f, -0.0003408482f,
        -0.0004634779f, -0.023403611f, 0.004329743f
    },
    {
        0.019763697f, 0.17336887f, -0.032161407f, 3.8799393e-5f, 0.0021505093f, -0.00034480362f,
        -0.00046179025f, -0.022869408f, 0.0042327615f
    },
    {
        0.019116137f, 0.16054395f, -0.029782284f, 3.890353e-5f, 0.0021075136f, -0.00034651696f,
        -0.00045940743f, -0.022331022f, 0.0041346247f
    },
    {
        0.018466128f, 0.14767054f, -0.027394166f, 3.8941194e-5f, 0.002063888f, -0.00034637918f,
        -0.00045635496f, -0.021788925f, 0.004035489f
    },
    {
        0.01781366f, 0.13474847f, -0.024997024f, 3.8914433e-5f, 0.0020196964f, -0.00034471258f,
        -0.00045265837f, -0.021243595f, 0.0039354977f
    },
    {
        0.017158726f, 0.12177762f, -0.022590829f, 3.882532e-5f, 0.001974999f, -0.00034178307f,
        -0.00044834314f, -0.0206955f, 0.003834784f
    },
    {
        0.016501317f, 0.1087578f, -0.020175552f, 3.8675946e-5f, 0.0019298517f, -0.00033781037f,
        -0.00044343484f, -0.020145118f, 0.0037334734f
    },
    {
        0.015841424f, 0.09568889f, -0.017751168f, 3.8468424e-5f, 0.0018843082f, -0.00033297614f,
        -0.00043795895f, -0.01959292f, 0.0036316845f
    },
    {
        0.015179042f, 0.082570754f, -0.015317652f, 3.8204882e-5f, 0.0018384194f, -0.00032743093f,
        -0.00043194098f, -0.019039374f, 0.0035295298f
    },
    {
        0.014514163f, 0.06940327f, -0.012874982f, 3.788745e-5f, 0.0017922344f, -0.00032129962f,
        -0.00042540644f, -0.018484956f, 0.0034271176f
    },
    {
        0.013846779f, 0.056186337f, -0.01042314f, 3.7518275e-5f, 0.0017458008f, -0.0003146861f,
        -0.00041838078f, -0.017930133f, 0.0033245524f
    },
    {
        0.013176886f, 0.042919863f, -0.007962106f, 3.7099508e-5f, 0.0016991649f, -0.00030767702f,
        -0.0004108895f, -0.017375378f, 0.0032219356f
    },
    {
        0.012504478f, 0.02960378f, -0.005491869f, 3.6633308e-5f, 0.0016523717f, -0.00030034484f,
        -0.00040295813f, -0.01682116f, 0.0031193655f
    },
    {
        0.01182955f, 0.016238043f, -0.0030124213f, 3.6121837e-5f, 0.0016054657f, -0.00029275037f,
        -0.00039461209f, -0.016267952f, 0.0030169394f
    },
    {
        0.0111521f, 0.002822643f, -0.00052376086f, 3.5567256e-5f, 0.0015584902f, -0.00028494486f,
        -0.00038587683f, -0.015716221f, 0.0029147519f
    },
    {
        0.010472125f, -0.010642393f, 0.0019741075f, 3.497174e-5f, 0.0015114883f, -0.0002769718f,
        -0.00037677787f, -0.015166439f, 0.0028128966f
    },
    {
        0.009789625f, -0.02415699f, 0.0044811694f, 3.4337463e-5f, 0.0014645027f, -0.0002688682f,
        -0.00036734063f, -0.014619076f, 0.002711466f
    },
    {
        0.009104601f, -0.03772101f, 0.006997401f, 3.366659e-5f, 0.001417575f, -0.00026066572f,
        -0.00035759053f, -0.014074599f, 0.0026105514f
    },
    {
        0.008417059f, -0.051334266f, 0.009522764f, 3.2961296e-5f, 0.0013707473f, -0.00025239174f,
        -0.00034755305f, -0.013533481f, 0.0025102436f
    },
    {
        0.0077270046f, -0.06499645f, 0.012057206f, 3.2223765e-5f, 0.0013240611f, -0.00024407008f,
        -0.00033725364f, -0.012996191f, 0.0024106326f
    },
    {
        0.00703445f, -0.07870718f, 0.014600652f, 3.1456162e-5f, 0.0012775575f, -0.00023572161f,
        -0.00032671768f, -0.012463198f, 0.0023118078f
    },
    {
        0.0063394094f, -0.09246594f, 0.017153008f, 3.066067e-5f, 0.0012312775f, -0.00022736483f,
        -0.00031597062f, -0.011934971f, 0.0022138585f
    },
    {
        0.0056419047f, -0.10627204f, 0.019714147f, 2.9839468e-5f, 0.0011852622f, -0.00021901623f,
        -0.0003050379f, -0.011411981f, 0.0021168732f
    },
    {
        0.004941963f, -0.12012462f, 0.022283908f, 2.899473e-5f, 0.0011395524f, -0.00021069073f,
        -0.00029394485f, -0.010894696f, 0.00202094f
    },
    {
        0.004239621f, -0.13402258f, 0.024862088f, 2.8128632e-5f, 0.0010941888f, -0.00020240186f,
        -0.00028271694f, -0.0103835855f, 0.0019261475f
    },
    {
        0.0035349235f, -0.14796455f, 0.02744843f, 2.7243352e-5f, 0.0010492118f, -0.0001941621f,
        -0.00027137948f, -0.009879119f, 0.0018325832f
    },
    {
        0.002827929f, -0.1619488f, 0.030042619f, 2.6341066e-5f, 0.0010046621f, -0.00018598301f,
        -0.00025995792f, -0.009381765f, 0.0017403351f
    },
    {
        0.00211871f, -0.17597319f, 0.03264425f, 2.5423951e-5f, 0.0009605802f, -0.00017787542f,
        -0.00024847756f, -0.008891991f, 0.0016494906f
    },
    {
        0.0014073572f, -0.19003507f, 0.03525284f, 2.449418e-5f, 0.00091700634f, -0.00016984958f,
        -0.00023696377f, -0.008410267f, 0.0015601369f
    },
    {
        0.00069398334f, -0.20413117f, 0.037867773f, 2.355393e-5f, 0.0008739809f, -0.00016191519f,
        -0.00022544185f, -0.007937059f, 0.0014723613f
    },
    {
        -2.1272092e-5f, -0.21825746f, 0.04048831f, 2.2605374e-5f, 0.00083154434f, -0.00015408156f,
        -0.00021393712f, -0.007472835f, 0.0013862507f
    },
    {
        -0.00073823705f, -0.23240899f, 0.043113526f, 2.1650681e-5f, 0.00078973663f, -0.00014635769f,
        -0.00020247484f, -0.007018061f, 0.001301892f
    },
    {
        -0.0014566997f, -0.24657966f, 0.0457423f, 2.0692023e-5f, 0.00074859813f, -0.00013875225f,
        -0.00019108022f, -0.0065732026f, 0.0012193717f
    },
    {
        -0.0021764f, -0.2607621f, 0.04837325f, 1.973157e-5f, 0.0007081689f, -0.00013127371f,
        -0.0001797785f, -0.0061387247f, 0.0011387762f
    },
    {
        -0.0028970188f, -0.2749471f, 0.05100468f, 1.8771485e-5f, 0.0006684889f, -0.00012393034f,
        -0.00016859476f, -0.0057150903f, 0.0010601914f
    },
    {
        -0.003618165f, -0.28912362f, 0.05363453f, 1.781393e-5f, 0.00062959816f, -0.000116730225f,
        -0.00015755411f, -0.0053027603f, 0.0009837033f
    },
    {
        -0.0043393606f, -0.303278f, 0.05626028f, 1.6861068e-5f, 0.00059153646f, -0.00010968132f,
        -0.00014668156f, -0.0049021947f, 0.00090939703f
    },
    {
        -0.00506002f, -0.3173936f, 0.05887884f, 1.5915051e-5f, 0.00055434357f, -0.00010279146f,
        -0.000136002f, -0.0045138504f, 0.00083735754f
    },
    {
        -0.0057794293f, -0.3314502f, 0.06148644f, 1.4978029e-5f, 0.000518059f, -9.606836e-5f,
        -0.00012554023f, -0.004138181f, 0.000767669f
    },
    {
        -0.006496716f, -0.34542298f, 0.0640785f, 1.4052145e-5f, 0.00048272221f, -8.951964e-5f,
        -0.00011532091f, -0.0037756367f, 0.000700415f
    },
    {
        -0.0072108135f, -0.35928175f, 0.066649415f, 1.3139534e-5f, 0.00044837233f, -8.315283e-5f,
        -0.00010536853f, -0.0034266626f, 0.0006356782f
    },
    {
        -0.007920423f, -0.37298968f, 0.06919235f, 1.2242321e-5f, 0.00041504824f, -7.6975346e-5f,
        -9.5707364e-5f, -0.0030916985f, 0.0005735401f
    },
    {
        -0.008623959f, -0.3865019f, 0.07169897f, 1.1362618e-5f, 0.0003827885f, -7.0994516e-5f,
        -8.6361455e-5f, -0.0027711769f, 0.0005140811f
    },
    {
        -0.009319487f, -0.39976364f, 0.07415913f, 1.0502526e-5f, 0.00035163132f, -6.5217566e-5f,
        -7.735453e-5f, -0.0024655217f, 0.00045737988f
    },
    {
        -0.010004651f, -0.4127082f, 0.076560445f, 9.664124e-6f, 0.0003216143f, -5.9651593e-5f,
        -6.8709945e-5f, -0.002175147f, 0.00040351314f
    },
    {
        -0.010676577f, -0.42525423f, 0.078887835f, 8.8494735e-6f, 0.00029277455f, -5.430357e-5f,
        -6.0450602e-5f, -0.001900453f, 0.00035255525f
    },
    {
        -0.011331763f, -0.43730268f, 0.08112292f, 8.060607e-6f, 0.00026514835f, -4.9180315e-5f,
        -5.2598833e-5f, -0.0016418252f, 0.00030457767f
    },
    {
        -0.011965941f, -0.4487328f, 0.08324331f, 7.2995244e-6f, 0.00023877116f, -4.4288463e-5f,
        -4.5176315e-5f, -0.0013996297f, 0.00025964837f
    },
    {
        -0.012573909f, -0.45939752f, 0.08522171f, 6.568189e-6f, 0.00021367728f, -3.9634433e-5f,
        -3.8203885e-5f, -0.0011742092f, 0.00021783091f
    },
    {
        -0.013149331f, -0.46911764f, 0.08702487f, 5.868514e-6f, 0.0001898997f, -3.5224388e-5f,
        -3.170138e-5f, -0.0009658782f, 0.00017918364f
    },
    {
        -0.013684486f, -0.47767478f, 0.0886123f, 5.2023565e-6f, 0.00016746976f, -3.1064174e-5f,
        -2.5687408e-5f, -0.0007749164f, 0.00014375847f
    },
    {
        -0.014169967f, -0.484803f, 0.089934655f, 4.5715005e-6f, 0.00014641677f, -2.7159263e-5f,
        -2.0179075e-5f, -0.0006015614f, 0.00011159947f
    },
    {
        -0.014594314f, -0.49017832f, 0.09093184f, 3.977645e-6f, 0.00012676763f, -2.3514667e-5f,
        -1.5191674e-5f, -0.00044599918f, 8.274115e-5f
    },
    {
        -0.014943567f, -0.493406f, 0.09153062f, 3.4223829e-6f, 0.00010854627f, -2.0134843e-5f,
        -1.0738266e-5f, -0.00030835308f, 5.720639e-5f
    },
    {
        -0.015200719f, -0.4940053f, 0.09164183f, 2.907178e-6f, 9.177297e-5f, -1.7023573e-5f,
        -6.829209e-6f, -0.00018866979f, 3.500386e-5f
    },
    {
        -0.015345055f, -0.4913906f, 0.09115681f, 2.433338e-6f, 7.6463584e-5f, -1.4183806e-5f,
        -3.4715586e-6f, -8.690285e-5f, 1.6124945e-5f
    },
    {
        -0.015351337f, -0.48484847f, 0.08994324f, 2.00198e-6f, 6.262857e-5f, -1.16175e-5f,
        -6.68349e-7f, -2.8921213e-6f, 5.3993693e-7f
    },
    {
        -0.015188829f, -0.47351003f, 0.087839924f, 1.613987e-6f, 5.027183e-5f, -9.325381e-6f,
        1.5822854e-6f, 6.3661006e-5f, -1.1806554e-5f
    },
    {
        -0.014820088f, -0.4563169f, 0.084650524f, 1.2699595e-6f, 3.9389226e-5f, -7.306694e-6f,
        3.2881806e-6f, 0.00011322385f, -2.1001215e-5f
    },
    {
        -0.014199504f, -0.43197978f, 0.080135874f, 9.70152e-7f, 2.9966872e-5f, -5.558867e-6f,
        4.4644453e-6f, 0.00014646929f, -2.7168866e-5f
    },
    {
        -0.013271525f, -0.39892843f, 0.07400469f, 7.1439763e-7f, 2.1978976e-5f, -4.0771206e-6f,
        5.1350507e-6f, 0.00016432065f, -3.0480789e-5f
    },
    {
        -0.011968482f, -0.35525015f, 0.06590214f, 5.02017e-7f, 1.5385249e-5f, -2.8539855e-6f,
        5.334761e-6f, 0.00016800631f, -3.116486e-5f
    },
    {
        -0.010207956f, -0.29861522f, 0.05539606f, 3.3170534e-7f, 1.0127739e-5f, -1.8787143e-6f,
        5.111492e-6f, 0.0001591264f, -2.9517894e-5f
    },
    {
        -0.007889551f, -0.22618589f, 0.04196003f, 2.0139656e-7f, 6.126972e-6f, -1.1365669e-6f,
        4.5291777e-6f, 0.00013973376f, -2.5920719e-5f
    },
    {
        -0.0048909886f, -0.13450585f, 0.024952877f, 1.0809692e-7f, 3.2772577e-6f, -6.079397e-7f,
        3.6712665e-6f, 0.00011243278f, -2.085646e-5f
    },
    {
        -0.0010633238f, -0.019365126f, 0.0035936306f, 4.768268e-8f, 1.4409684e-6f, -2.6730373e-7f,
        2.6449768e-6f, 8.049976e-5f, -1.4932883e-5f
    },
    {
        0.003774859f, 0.12436407f, -0.023068944f, 1.46535815e-8f, 4.415696e-7f, -8.1912525e-8f,
        1.5864819e-6f, 4.802935e-5f, -8.909574e-6f
    },
    {
        0.0098445285f, 0.3029275f, -0.05619347f, 1.8325622e-9f, 5.5133413e-8f, -1.0227425e-8f,
        6.672246e-7f, 2.0113122e-5f, -3.7310456e-6f
    }
};

/* The bits of a number. */
typedef union {
    float value;
    uint32_t bits;
} dc_motor_f32_cell_t;

/* The bits of a number. */
static uint32_t dc_motor_f32_to_bits(float x)
{
    dc_motor_f32_cell_t cell;
    cell.value = x;
    return cell.bits;
}

/* The bit of the sign. */
#define DC_MOTOR_SIGN_F32 UINT32_C(0x80000000)

/* The bits of the largest magnitude. */
#define DC_MOTOR_MAGNITUDE_F32 UINT32_C(0x7FFFFFFF)

/* The bits of infinity. */
#define DC_MOTOR_INFINITY_F32 UINT32_C(0x7F800000)

/* The bits of the only NaN that is returned. */
#define DC_MOTOR_NAN_F32 UINT32_C(0x7FC00000)

/* The number with these bits. */
static float dc_motor_f32_from_bits(uint32_t bits)
{
    dc_motor_f32_cell_t cell;
    cell.bits = bits;
    return cell.value;
}

/* The number significand / 2^63 * 2^exponent, with the top bit of the significand set. */
typedef struct {
    uint64_t significand;
    int32_t exponent;
} dc_motor_scaled_t;

/* A number with a sign. */
typedef struct {
    dc_motor_scaled_t magnitude;
    int negative;
} dc_motor_signed_t;

/* The angle quadrant * pi/2 + rest. */
typedef struct {
    dc_motor_signed_t rest;
    uint32_t quadrant;
} dc_motor_turned_t;

/* Attaches a sign. */
static dc_motor_signed_t dc_motor_signed(dc_motor_scaled_t magnitude, int negative)
{
    dc_motor_signed_t result;
    result.magnitude = magnitude;
    result.negative = negative;
    return result;
}

/* A number below 1 as fixed point with 64 fraction bits. */
static uint64_t dc_motor_fraction(dc_motor_scaled_t a)
{
    const int32_t shift = -1 - a.exponent;
    if (shift > 63) {
        return 0;
    }
    return a.significand >> shift;
}

/* The upper half of the product, at most 2 too small. */
static uint64_t dc_motor_mul_high(uint64_t a, uint64_t b)
{
    const uint64_t a_high = a >> 32;
    const uint64_t a_low = a & 0xFFFFFFFFu;
    const uint64_t b_high = b >> 32;
    const uint64_t b_low = b & 0xFFFFFFFFu;
    const uint64_t cross = ((a_high * b_low) >> 32) + ((a_low * b_high) >> 32);
    return a_high * b_high + cross;
}

/* The square of a number below 1 as fixed point with 64 fraction bits. */
static uint64_t dc_motor_squared_fraction(dc_motor_scaled_t a)
{
    const uint64_t x = dc_motor_fraction(a);
    return dc_motor_mul_high(x, x);
}

/* Makes a number of a significand that has its top bit set. */
static dc_motor_scaled_t dc_motor_scaled(uint64_t significand, int32_t exponent)
{
    dc_motor_scaled_t result;
    result.significand = significand;
    result.exponent = exponent;
    return result;
}

/* Makes a number of a significand of at least 2^62. */
static dc_motor_scaled_t dc_motor_settled(uint64_t significand, int32_t exponent)
{
    if ((significand >> 63) == 0) {
        return dc_motor_scaled(significand << 1, exponent - 1);
    }
    return dc_motor_scaled(significand, exponent);
}

/* (1 - cos(r)) / r^2 in powers of -r^2. */
static const uint64_t DC_MOTOR_COSINE[8] = {
    UINT64_C(0x8000000000000000), UINT64_C(0x0AAAAAAAAAAAAAA8), UINT64_C(0x005B05B05B05B02B),
    UINT64_C(0x0001A01A01A01865), UINT64_C(0x0000049F93EDD666), UINT64_C(0x00000008F76C6243),
    UINT64_C(0x000000000C9C9706), UINT64_C(0x00000000000D551B)};

/* cos(r) for 0 < r <= pi/4, relative error below 2^-60. */
static dc_motor_scaled_t dc_motor_cosine(dc_motor_scaled_t r)
{
    const uint64_t z = dc_motor_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = DC_MOTOR_COSINE[6] - ((DC_MOTOR_COSINE[7] * z_high) >> 32);
    const uint64_t c5 = DC_MOTOR_COSINE[5] - ((tail * z_high) >> 32);
    const uint64_t c4 = DC_MOTOR_COSINE[4] - dc_motor_mul_high(c5, z);
    const uint64_t c3 = DC_MOTOR_COSINE[3] - dc_motor_mul_high(c4, z);
    const uint64_t c2 = DC_MOTOR_COSINE[2] - dc_motor_mul_high(c3, z);
    const uint64_t c1 = DC_MOTOR_COSINE[1] - dc_motor_mul_high(c2, z);
    const uint64_t c0 = DC_MOTOR_COSINE[0] - dc_motor_mul_high(c1, z);
    return dc_motor_settled((UINT64_C(1) << 63) - (dc_motor_mul_high(c0, z) >> 1), 0);
}

/* (1 - sin(r) / r) / r^2 in powers of -r^2. */
static const uint64_t DC_MOTOR_SINE[7] = {
    UINT64_C(0x2AAAAAAAAAAAAAA6), UINT64_C(0x0222222222222160), UINT64_C(0x000D00D00D00C575),
    UINT64_C(0x00002E3BC74A673D), UINT64_C(0x0000006B9914A637), UINT64_C(0x00000000B090498C),
    UINT64_C(0x0000000000D552BC)};

/* sin(r) for 0 < r <= pi/4, relative error below 2^-60. */
static dc_motor_scaled_t dc_motor_sine(dc_motor_scaled_t r)
{
    const uint64_t z = dc_motor_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = DC_MOTOR_SINE[5] - ((DC_MOTOR_SINE[6] * z_high) >> 32);
    const uint64_t c4 = DC_MOTOR_SINE[4] - ((tail * z_high) >> 32);
    const uint64_t c3 = DC_MOTOR_SINE[3] - dc_motor_mul_high(c4, z);
    const uint64_t c2 = DC_MOTOR_SINE[2] - dc_motor_mul_high(c3, z);
    const uint64_t c1 = DC_MOTOR_SINE[1] - dc_motor_mul_high(c2, z);
    const uint64_t c0 = DC_MOTOR_SINE[0] - dc_motor_mul_high(c1, z);
    const uint64_t lost = dc_motor_mul_high(r.significand, dc_motor_mul_high(c0, z));
    return dc_motor_settled(r.significand - lost, r.exponent);
}

/* The sine of an angle. */
static dc_motor_signed_t dc_motor_sine_at(dc_motor_turned_t angle)
{
    const int back = (angle.quadrant & 2) != 0;
    if ((angle.quadrant & 1) != 0) {
        return dc_motor_signed(dc_motor_cosine(angle.rest.magnitude), back);
    }
    return dc_motor_signed(dc_motor_sine(angle.rest.magnitude), back != angle.rest.negative);
}

/* Makes an angle of its parts. */
static dc_motor_turned_t dc_motor_turned(dc_motor_signed_t rest, uint32_t quadrant)
{
    dc_motor_turned_t result;
    result.rest = rest;
    result.quadrant = quadrant;
    return result;
}

/* The number of zero bits above the highest one bit; x is not 0. */
static int32_t dc_motor_leading_zeros(uint64_t x)
{
#if defined(__GNUC__) && (defined(__ARM_FEATURE_CLZ) || defined(__LZCNT__))
    const uint32_t upper = (uint32_t)(x >> 32);
    return upper != 0 ? __builtin_clz(upper) : 32 + __builtin_clz((uint32_t)x);
#else
    uint32_t rest = (uint32_t)(x >> 32);
    int32_t count = 0;
    if (rest == 0) {
        rest = (uint32_t)x;
        count = 32;
    }
    if ((rest >> 16) == 0) {
        rest <<= 16;
        count += 16;
    }
    if ((rest >> 24) == 0) {
        rest <<= 8;
        count += 8;
    }
    if ((rest >> 28) == 0) {
        rest <<= 4;
        count += 4;
    }
    if ((rest >> 30) == 0) {
        rest <<= 2;
        count += 2;
    }
    if ((rest >> 31) == 0) {
        count += 1;
    }
    return count;
#endif
}

/* Makes a number of any significand but 0. */
static dc_motor_scaled_t dc_motor_normalised(uint64_t significand, int32_t exponent)
{
    const int32_t shift = dc_motor_leading_zeros(significand);
    return dc_motor_scaled(significand << shift, exponent - shift);
}

/* The finite positive number with these bits, not 0; exact. */
static dc_motor_scaled_t dc_motor_unpacked_f32(uint32_t magnitude)
{
    const int32_t field = (int32_t)(magnitude >> 23);
    const uint64_t digits = (uint64_t)magnitude << 40;
    if (field == 0) {
        return dc_motor_normalised(digits, -126);
    }
    return dc_motor_scaled(digits | (UINT64_C(1) << 63), field - 127);
}

/* 2/pi after 32 zero bits. */
static const uint32_t DC_MOTOR_TWO_OVER_PI_F32[9] = {
    UINT32_C(0x00000000), UINT32_C(0xA2F9836E), UINT32_C(0x4E441529),
    UINT32_C(0xFC2757D1), UINT32_C(0xF534DDC0), UINT32_C(0xDB629599),
    UINT32_C(0x3C439041), UINT32_C(0xFE5163AB), UINT32_C(0xDEBBC561)};

/* 32 bits of 2/pi from bit 32 slot + shift on. */
static uint64_t dc_motor_window_f32(uint32_t slot, uint32_t shift)
{
    const uint64_t first = (uint64_t)(DC_MOTOR_TWO_OVER_PI_F32[slot]);
    const uint64_t second = (uint64_t)(DC_MOTOR_TWO_OVER_PI_F32[slot + 1]);
    return (((first << 32) | second) >> (32 - shift)) & 0xFFFFFFFFu;
}

/* a b, relative error below 2^-60. */
static dc_motor_scaled_t dc_motor_product(dc_motor_scaled_t a, dc_motor_scaled_t b)
{
    return dc_motor_settled(dc_motor_mul_high(a.significand, b.significand),
                            a.exponent + b.exponent + 1);
}

/* pi with 62 fraction bits; as a significand also pi/2 and pi/4. */
#define DC_MOTOR_PI UINT64_C(0xC90FDAA22168C235)

/* The angle of (high, low) / 2^126 quarter turns, its rest exact to 2^-60 of itself. */
static dc_motor_turned_t dc_motor_turned_from_quarters(uint64_t high, uint64_t low)
{
    const uint64_t eighths = high >> 61;
    const int negative = (eighths & 1) != 0;
    uint64_t upper = (high << 2) | (low >> 62);
    uint64_t lower = low << 2;
    if (negative) {
        upper = (lower == 0) ? (UINT64_C(0) - upper) : UINT64_MAX - upper;
        lower = (UINT64_C(0) - lower);
    }
    const int32_t shift = dc_motor_leading_zeros(upper | 1);
    const uint64_t significand = (upper << shift) | ((lower >> 1) >> (63 - shift));
    const dc_motor_signed_t rest = dc_motor_signed(
        dc_motor_product(dc_motor_scaled(significand, -1 - shift), dc_motor_scaled(DC_MOTOR_PI, 0)),
        negative);
    return dc_motor_turned(rest, (uint32_t)(((eighths + 1) >> 1) & 3));
}

/* The angle with these bits, positive and finite, its rest exact to 2^-38 of itself. */
static dc_motor_turned_t dc_motor_reduce_f32(uint32_t magnitude)
{
    if (magnitude <= 0x3F490FDAu) {
        return dc_motor_turned(dc_motor_signed(dc_motor_unpacked_f32(magnitude), 0), 0);
    }
    const uint64_t digits = (uint64_t)((magnitude & 0x007FFFFFu) | 0x00800000u);
    const uint32_t start = (magnitude >> 23) - 120;
    const uint32_t slot = start >> 5;
    const uint32_t shift = start & 31;
    const uint64_t upper = (dc_motor_window_f32(slot, shift) * digits) << 32;
    const uint64_t middle = dc_motor_window_f32(slot + 1, shift) * digits;
    const uint64_t lower = dc_motor_window_f32(slot + 2, shift) * digits;
    return dc_motor_turned_from_quarters(((upper + middle) + (lower >> 32)), lower << 32);
}

/* x rounded to the nearest, ties to even, with subnormals and overflow, and the sign put in. */
static float dc_motor_rounded_f32(uint32_t sign, dc_motor_scaled_t x)
{
    const int32_t field = x.exponent + 127;
    if (field >= 255) {
        return dc_motor_f32_from_bits(sign | DC_MOTOR_INFINITY_F32);
    }
    const int32_t shift = (field > 0) ? 40 : 41 - field;
    if (shift > 63) {
        const int least = shift == 64 && x.significand > (UINT64_C(1) << 63);
        return dc_motor_f32_from_bits(least ? sign + 1 : sign);
    }
    const uint64_t kept = x.significand >> shift;
    const uint64_t rest = x.significand - (kept << shift);
    const uint64_t half = UINT64_C(1) << (shift - 1);
    const uint64_t odd = kept & 1;
    const uint64_t up = (rest + odd > half) ? 1 : 0;
    const uint32_t base = (field > 0) ? ((uint32_t)(field - 1)) << 23 : 0;
    return dc_motor_f32_from_bits(sign | (base + ((uint32_t)(kept + up))));
}

/* The sign bit of a negative number, else 0. */
static uint32_t dc_motor_sign_f32(int negative)
{
    if (negative) {
        return DC_MOTOR_SIGN_F32;
    }
    return 0;
}

/* Sine of an angle in radians, the nearest float. */
static float dc_motor_sin_f32(float x)
{
    const uint32_t bits = dc_motor_f32_to_bits(x);
    const uint32_t magnitude = bits & DC_MOTOR_MAGNITUDE_F32;
    if (magnitude >= DC_MOTOR_INFINITY_F32) {
        return dc_motor_f32_from_bits(DC_MOTOR_NAN_F32);
    }
    if (magnitude == 0) {
        return x;
    }
    const dc_motor_signed_t value = dc_motor_sine_at(dc_motor_reduce_f32(magnitude));
    return dc_motor_rounded_f32((bits & DC_MOTOR_SIGN_F32) ^ dc_motor_sign_f32(value.negative),
                                value.magnitude);
}

/* What one part of a step hands to the next. */
typedef struct {
    uint32_t t11;
    float t21;
    float t32;
    uint32_t t39;
    float t123;
    float t124;
    float t125;
    dc_motor_status t132;
} dc_motor_work;

/* Part 1 of a step. */
static void dc_motor_part_1(dc_motor_state *state, const dc_motor_measurements *measurements, const dc_motor_inputs *inputs, dc_motor_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    const uint32_t t0 = state->newest;
    const uint32_t t1 = (t0 < 100U) ? t0 : 100U;
    const uint32_t t2 = state->count;
    const int t4 = 100U < t2;
    const float t5 = measurements->y;
    const int t6 = (-1e35f <= t5) && (t5 <= 1e35f);
    const float t7 = inputs->u;
    const int t8 = (-1e35f <= t7) && (t7 <= 1e35f);
    const float t9 = state->u[t1];
    const float t10 = t8 ? t7 : t9;

    /* prediction, for a sample that is missing */
    work->t11 = (t1 < 100U) ? (t1 + 1U) : 0U;
    const float t12 = state->ahead_y;
    const float t14 = 9.516694e-8f * t10;
    const float t15 = t12 + t14;
    const float t16 = state->y[t1];
    const int t17 = (-1e35f <= t15) && (t15 <= 1e35f);
    const int t18 = t4 && t17;
    const float t19 = t18 ? t15 : t16;
    const float t20 = t6 ? t5 : t19;
    work->t21 = dc_motor_sin_f32(t20);
    const float t22 = state->sin_q[t1];
    const float t23 = work->t21 - t22;
    const float t25 = -5.8317214e-6f * t23;
    const float t26 = t15 + t25;
    const int t27 = (-1e35f <= t26) && (t26 <= 1e35f);
    const int t28 = t4 && t27;
    const float t29 = t28 ? t26 : t16;
    const int t30 = t6 || t28;
    const int t31 = !t30;
    work->t32 = t6 ? t5 : t29;

    /* how much of the window is good */
    const uint32_t t35 = (t2 < 101U) ? (t2 + 1U) : 101U;
    const uint32_t t36 = t31 ? 0U : t35;
    const uint32_t t37 = t8 ? t35 : 1U;
    const uint32_t t38 = t6 ? t37 : 0U;
    work->t39 = t4 ? t36 : t38;
    state->count = work->t39;
    const uint32_t t40 = state->coasting;
    const uint32_t t41 = (t40 > 0U) ? (t40 - 1U) : 0U;
    const uint32_t t42 = t8 ? t41 : 100U;
    const uint32_t t44 = t6 ? t42 : 101U;
    state->coasting = t44;

    /* into the window */
    state->newest = work->t11;
    state->y[work->t11] = work->t32;
    state->u[work->t11] = t10;
    state->sin_q[work->t11] = work->t21;
}

/* Part 2 of a step. */
static void dc_motor_part_2(dc_motor_state *state, dc_motor_work *work)
{
    /* the sums over the window, newest sample first */
    float t46 = 0.0f;
    float t47 = 0.0f;
    float t48 = 0.0f;
    float t49 = 0.0f;
    float t50 = 0.0f;
    float t51 = 0.0f;
    float t52 = 0.0f;
    float t53 = 0.0f;
    float t54 = 0.0f;
    uint32_t t55 = work->t11;
    for (uint32_t row = 0U; row < 100U; ++row) {
        const float *const gains = DC_MOTOR_WINDOW[row];
        const float t56 = state->y[t55];
        const float t57 = gains[0];
        const float t58 = t57 * t56;
        const float t59 = t46 + t58;
        const float t60 = gains[1];
        const float t61 = t60 * t56;
        const float t62 = t49 + t61;
        const float t63 = gains[2];
        const float t64 = t63 * t56;
        const float t65 = t52 + t64;
        const float t66 = state->u[t55];
        const float t67 = gains[3];
        const float t68 = t67 * t66;
        const float t69 = t47 + t68;
        const float t70 = gains[4];
        const float t71 = t70 * t66;
        const float t72 = t50 + t71;
        const float t73 = gains[5];
        const float t74 = t73 * t66;
        const float t75 = t53 + t74;
        const float t76 = state->sin_q[t55];
        const float t77 = gains[6];
        const float t78 = t77 * t76;
        const float t79 = t48 + t78;
        const float t80 = gains[7];
        const float t81 = t80 * t76;
        const float t82 = t51 + t81;
        const float t83 = gains[8];
        const float t84 = t83 * t76;
        const float t85 = t54 + t84;
        const uint32_t t86 = ((t55 >= 1U) && (t55 < 101U)) ? (t55 - 1U) : 100U;
        t46 = t59;
        t47 = t69;
        t48 = t79;
        t49 = t62;
        t50 = t72;
        t51 = t82;
        t52 = t65;
        t53 = t75;
        t54 = t85;
        t55 = t86;
    }
    const float t87 = state->y[t55];
    const float t89 = 0.01741483f * t87;
    const float t90 = t46 + t89;
    const float t92 = 0.5239326f * t87;
    const float t93 = t49 + t92;
    const float t95 = -0.09719117f * t87;
    const float t96 = t52 + t95;
    const float t97 = state->sin_q[t55];
    const float t99 = 1.0160904e-7f * t97;
    const float t100 = t48 + t99;
    const float t102 = 3.0569513e-6f * t97;
    const float t103 = t51 + t102;
    const float t105 = -5.6707427e-7f * t97;
    const float t106 = t54 + t105;
    const float t107 = t90 + t47;
    const float t108 = t107 + t100;
    const float t109 = t93 + t50;
    const float t110 = t109 + t103;
    const float t111 = t96 + t53;
    const float t112 = t111 + t106;

    /* the next measurement, as far as it is known */
    const float t114 = 0.0009994135f * t110;
    const float t116 = 7.021338e-6f * t112;
    const float t118 = -1.7493403e-5f * work->t21;
    const float t119 = t108 + t114;
    const float t120 = t119 + t116;
    const float t121 = t120 + t118;
    state->ahead_y = t121;

    /* the estimate; until the window is full, the start */
    const int t122 = 100U < work->t39;
    work->t123 = t122 ? t108 : work->t32;
    work->t124 = t122 ? t110 : 0.0f;
    work->t125 = t122 ? t112 : 0.0f;
    const uint32_t t126 = state->coasting;
    const int t127 = t126 == 0U;
    const dc_motor_status t131 = t127 ? DC_MOTOR_CONVERGED : DC_MOTOR_COASTING;
    work->t132 = t122 ? t131 : DC_MOTOR_CONVERGING;
}

void dc_motor_init(dc_motor_state *state)
{
    for (uint32_t slot = 0U; slot < 101U; ++slot) {
        state->y[slot] = 0.0f;
    }
    for (uint32_t slot = 0U; slot < 101U; ++slot) {
        state->u[slot] = 0.0f;
    }
    for (uint32_t slot = 0U; slot < 101U; ++slot) {
        state->sin_q[slot] = 0.0f;
    }
    state->newest = 100U;
    state->count = 0U;
    state->coasting = 0U;
    state->ahead_y = 0.0f;
}

void dc_motor_step(dc_motor_state *state, const dc_motor_measurements *measurements,
                   const dc_motor_inputs *inputs, dc_motor_estimate *estimate)
{
    dc_motor_work work;
    dc_motor_part_1(state, measurements, inputs, &work);
    dc_motor_part_2(state, &work);

    estimate->q = work.t123;
    estimate->dq = work.t124;
    estimate->i = work.t125;
    estimate->status = work.t132;
}
