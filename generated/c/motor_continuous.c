/* motor_continuous.c: Finite-time observer: Direct-drive arm as its paper prints the observer: integrals over the window.
 *
 * Generated; motor_continuous.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "motor_continuous.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "motor_continuous.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "motor_continuous.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* weights by age, from age 0
 *   [0] q from y
 *   [1] dq from y
 *   [2] i from y
 *   [3] dq from u
 *   [4] i from u
 *   [5] dq from sin(q)
 *   [6] i from sin(q)
 */
static const double MOTOR_CONTINUOUS_WINDOW[100][7] = {
    {
        1.0, 100.59836699369282, -18.65015933345139, 0.00027119944052978335, 0.03625234320377115,
        -0.01149603710390493, 3.0018594891161986e-5
    },
    {
        0.0, -12.480209855041075, 2.3135442257757597, 0.0007109279394296624, 0.029673029678306945,
        -0.04135840731883154, 0.0005634572020781466
    },
    {
        0.0, -7.044779448042571, 1.3057825058355992, 0.0010215455672084757, 0.024280678354165763,
        -0.022756380317526876, 0.0008337104976437018
    },
    {
        0.0, -8.358617716182527, 1.5492777662193402, 0.0012310810994715484, 0.01986192552479434,
        -0.02681555592765422, 0.0011355004178727702
    },
    {
        0.0, -7.226833146425113, 1.3394316402897757, 0.0013621135100866744, 0.016241677305283968,
        -0.02281635507660566, 0.0012839761192333776
    },
    {
        0.0, -6.564050944979524, 1.2165559102827324, 0.0014327752808925664, 0.013276254611143488,
        -0.02045734260826718, 0.0013745940792750182
    },
    {
        0.0, -5.952306141752503, 1.1031596037507347, 0.0014575778694668634, 0.010847764788833134,
        -0.018328211571945575, 0.0014133089995512242
    },
    {
        0.0, -5.389616043280742, 0.9988693278837659, 0.001448089152274827, 0.008859480712237683,
        -0.016408787669004967, 0.0014132971974584155
    },
    {
        0.0, -4.873597478756197, 0.9032388493336342, 0.0014134882034959626, 0.007232047229052706,
        -0.014680261652704212, 0.0013849607386407325
    },
    {
        0.0, -4.4016248232351405, 0.8157780835314604, 0.0013610193849661033, 0.0059003668673517015,
        -0.013125182872500998, 0.0013364680094054364
    },
    {
        0.0, -3.9709425861835723, 0.7359737339003285, 0.0012963636408751683, 0.004811043246218499,
        -0.011727427977000944, 0.0012741927265339885
    },
    {
        0.0, -3.5787507743982756, 0.6633049297598156, 0.001223941750141975, 0.0039202823800280244,
        -0.010472153207281476, 0.0012030702984172264
    },
    {
        0.0, -3.2222686154873568, 0.597254889841098, 0.0011471616957251644, 0.003192169922214127,
        -0.009345735465296802, 0.001126886746183484
    },
    {
        0.0, -2.8987811577369857, 0.5373194415034283, 0.0010686201687113456, 0.002597257056767878,
        -0.008335706189734284, 0.0010485126298534044
    },
    {
        0.0, -2.6056723901659415, 0.48301306539168104, 0.0009902664574105568, 0.0021113997854630387,
        -0.007430681147222802, 0.0009700921595719387
    },
    {
        0.0, -2.3404478167681515, 0.4338730047588699, 0.0009135355130019419, 0.0017148062449579616,
        -0.006620288507453592, 0.0008931958160231718
    },
    {
        0.0, -2.100748841768454, 0.3894618725532368, 0.000839455779844574, 0.001391254805644072,
        -0.005895096981628347, 0.000818943283681684
    },
    {
        0.0, -1.884360853914434, 0.3493691031757207, 0.0007687363860193342, 0.0011274523696876225,
        -0.005246545336161474, 0.0007481022552402703
    },
    {
        0.0, -1.6892165175276603, 0.3132115258957645, 0.0007018374713003196, 0.0009125077588674628,
        -0.00466687422444153, 0.000681167645851344
    },
    {
        0.0, -1.5133954699681342, 0.28063328027853424, 0.0006390267552280267, 0.000737499576822244,
        -0.004149060989707232, 0.000618424921090089
    },
    {
        0.0, -1.3551213760035725, 0.2513052481743808, 0.0005804248921904903, 0.0005951216203188428,
        -0.0036867578662423844, 0.00056000055944927
    },
    {
        0.0, -1.212757088417151, 0.2249241398464681, 0.0005260417026823846, 0.0004793919439516165,
        -0.0032742338315494366, 0.0005059021113549563
    },
    {
        0.0, -1.0847985021141493, 0.20121134202450464, 0.00047580499307428847,
        0.0003854141703711292, -0.0029063202286885967, 0.00045604985971079456
    },
    {
        0.0, -0.9698675587064203, 0.17991161173014855, 0.0004295833661296759, 0.0003091816806925463,
        -0.0025783601772614243, 0.00041030171343131583
    },
    {
        0.0, -0.8667047541033226, 0.16079168052672058, 0.0003872041694618161, 0.0002474169967758694,
        -0.002286161716842479, 0.0003684726602179751
    },
    {
        0.0, -0.7741614181501874, 0.14363881850702118, 0.00034846751946788454,
        0.00019744004398872519, -0.00202595457257351, 0.00033034985558769674
    },
    {
        0.0, -0.6911919688564092, 0.1282593951174506, 0.00031315716603689896, 0.0001570601135488278,
        -0.0017943503947343128, 0.00029570422173422054
    },
    {
        0.0, -0.6168462910029832, 0.11447746422811646, 0.0002810488219161405,
        0.00012448727168550258, -0.0015883062988498859, 0.00026429926386804114
    },
    {
        0.0, -0.5502623472712848, 0.10213339321125237, 0.0002519164646015155, 9.825972485993123e-5,
        -0.0014050915174378662, 0.00023589767642221915
    },
    {
        0.0, -0.4906590973390237, 0.0910825497883353, 0.00022553702350481194, 7.718427586868071e-5,
        -0.001242256966562157, 0.000210266201340712
    },
    {
        0.0, -0.43732977489453956, 0.08119405572779687, 0.00020169378724381733,
        6.0287519233859556e-5, -0.0010976075281162515, 0.00018717911100468498
    },
    {
        0.0, -0.38963555280371875, 0.0723496128584903, 0.00018017880214700504, 4.677584589876941e-5,
        -0.0009691768507637076, 0.00016642061545011928
    },
    {
        0.0, -0.34699961156936143, 0.06444240409666156, 0.00016079448094569748,
        3.600267335762425e-5, -0.0008552044775656365, 0.00014778643431560153
    },
    {
        0.0, -0.30890161481404, 0.05737607009385422, 0.0001433545980682713, 2.7441601465069048e-5,
        -0.0007541151156217297, 0.00013108472591790807
    },
    {
        0.0, -0.2748725870359825, 0.051063760560535056, 0.00012768481324320334,
        2.0664427391557828e-5, -0.0006644998718344367, 0.00011613652692679048
    },
    {
        0.0, -0.2444901827203736, 0.045427258192591136, 0.00011362283685208998,
        1.5323144624712473e-5, -0.0005850992886255468, 0.00010277582461529256
    },
    {
        0.0, -0.21737433154124966, 0.04039617233433666, 0.00010101832749046457,
        1.1135208045079056e-5, -0.0005147880236674568, 9.084935822066401e-5
    },
    {
        0.0, -0.1931832414638921, 0.03590719897913355, 8.973259353876812e-5, 7.871476069239434e-6,
        -0.00045256102811592287, 8.021622543741927e-5
    },
    {
        0.0, -0.1716097397347128, 0.03190344337844217, 7.963815543294833e-5, 5.346346696975086e-6,
        -0.0003975210882058962, 7.074735355806034e-5
    },
    {
        0.0, -0.15237793076917958, 0.028333801355056993, 7.061821310821225e-5,
        3.4096911626177387e-6, -0.0003488676052198921, 6.23248815267474e-5
    },
    {
        0.0, -0.13524014961410716, 0.025152395358923104, 6.256605323984016e-5,
        1.9402601733473523e-6, -0.0003058864986324999, 5.4841488563075744e-5
    },
    {
        0.0, -0.11997418980622833, 0.022318061334437058, 5.5384422985914277e-5,
        8.402962100593063e-7, -0.0002679411265879842, 4.819969654638909e-5
    },
    {
        0.0, -0.106380784945779, 0.019793882562897852, 4.898489059066826e-5, 3.113336097938173e-8,
        -0.0002344641267241514, 4.231116661745065e-5
    },
    {
        0.0, -0.09428132405060667, 0.01754676678419268, 4.3287208140592754e-5,
        -5.503944642853915e-7, -0.0002049500886822811, 3.7096005121144006e-5
    },
    {
        0.0, -0.08351578167375864, 0.015547063073325753, 3.8218687738055096e-5,
        -9.548837876578286e-7, -0.00017894897742564198, 3.248208981035121e-5
    },
    {
        0.0, -0.07394084479401801, 0.013768215138721084, 3.371359917218844e-5,
        -1.2227506296295053e-6, -0.00015606023372730164, 2.840442393695339e-5
    },
    {
        0.0, -0.06542821957698665, 0.012186447911650057, 2.9712594663179816e-5,
        -1.3861770011823442e-6, -0.00013592748489110845, 2.480452329199925e-5
    },
    {
        0.0, -0.05786310221793766, 0.010780484503028206, 2.6162164302286262e-5,
        -1.4706956043144674e-6, -0.00011823380495467063, 2.162983927817564e-5
    },
    {
        0.0, -0.05114279918965665, 0.009531290810225607, 2.301412429856469e-5,
        -1.4964789058469932e-6, -0.00010269746931178335, 1.883321958598366e-5
    },
    {
        0.0, -0.045175483308884774, 0.00842184525878521, 2.0225138986901974e-5,
        -1.4793867624006894e-6, -8.906815390930816e-5, 1.6372406905097512e-5
    },
    {
        0.0, -0.039879073089424524, 0.007436931359421792, 1.775627667924879e-5,
        -1.431816947333941e-6, -7.712353394727129e-5, 1.4209575257164958e-5
    },
    {
        0.0, -0.03518022385854842, 0.0065629509475710465, 1.5572598794117137e-5,
        -1.3633948751546384e-6, -6.666624136918332e-5, 1.231090292358795e-5
    },
    {
        0.0, -0.03101342006958029, 0.0057877561498948585, 1.3642781231452428e-5,
        -1.281532217117276e-6, -5.752114440078766e-5, 1.0646180511499336e-5
    },
    {
        0.0, -0.027320159143573282, 0.005100498288834317, 1.1938766632938643e-5,
        -1.1918786921315887e-6, -4.9532916007748385e-5, 9.188452412971404e-6
    },
    {
        0.0, -0.024048218015097916, 0.00449149209221781, 1.0435445950953112e-5,
        -1.0986868853364831e-6, -4.2563861423545375e-5, 7.913689734190366e-6
    },
    {
        0.0, -0.021150994341013318, 0.003952093720039792, 9.11036761804025e-6,
        -1.005106316793022e-6, -3.649197787433697e-5, 6.8004926771257894e-6
    },
    {
        0.0, -0.018586915057600687, 0.003474591254996302, 7.943472543073629e-6,
        -9.134200103563833e-7, -3.120922232278471e-5, 5.829820325582311e-6
    },
    {
        0.0, -0.016318905642283343, 0.0030521064275161546, 6.9168531443395315e-6,
        -8.252343794485987e-7, -2.661996549142159e-5, 4.9847458041538725e-6
    },
    {
        0.0, -0.01431391405361251, 0.0026785064602868427, 6.0145346509420996e-6,
        -7.416312549925991e-7, -2.2639612630232064e-5, 4.250234829645764e-6
    },
    {
        0.0, -0.012542483889915105, 0.0023483250221364572, 5.222276952155572e-6,
        -6.632892514632353e-7, -1.919337348335882e-5, 3.6129457498848593e-6
    },
    {
        0.0, -0.010978371825865451, 0.0020566913771344615, 4.527395341706407e-6,
        -5.905803344704768e-7, -1.6215165705444937e-5, 3.061049256620789e-6
    },
    {
        0.0, -0.009598204860264364, 0.0017992669024735847, 3.918598584243226e-6,
        -5.236463638804937e-7, -1.3646637596805674e-5, 2.5840660613270805e-6
    },
    {
        0.0, -0.008381173340526179, 0.0015721882286568105, 3.3858428196118083e-6,
        -4.624594962177764e-7, -1.143629748475841e-5, 2.1727209304612597e-6
    },
    {
        0.0, -0.007308756122797074, 0.0013720163282955244, 2.9201999132713457e-6,
        -4.0686960290956587e-7, -9.538738391054362e-6, 1.8188115865903707e-6
    },
    {
        0.0, -0.006364474584188197, 0.0011956909459708677, 2.5137389554317015e-6,
        -3.5664126726298826e-7, -7.913947806229746e-6, 1.515091091087593e-6
    },
    {
        0.0, -0.005533672528125554, 0.001040489821642818, 2.1594197051335443e-6,
        -3.1148243866569466e-7, -6.5266934534262875e-6, 1.25516243092259e-6
    },
    {
        0.0, -0.004803319317983099, 0.0009039922145082849, 1.8509968669721086e-6,
        -2.7106642750533706e-7, -5.3459768783204244e-6, 1.03338413502852e-6
    },
    {
        0.0, -0.004161833840515746, 0.0007840462834808083, 1.5829341763646392e-6,
        -2.3504860243140837e-7, -4.344547558721171e-6, 8.447858438951332e-7
    },
    {
        0.0, -0.0035989271415297953, 0.000678739925031709, 1.3503273534152908e-6,
        -2.0307888949620882e-7, -3.498470996674695e-6, 6.849928488120349e-7
    },
    {
        0.0, -0.003105461793945854, 0.0005863747094077994, 1.148835065046503e-6,
        -1.7481095948396943e-7, -2.786744946199906e-6, 5.501587042315649e-7
    },
    {
        0.0, -0.0026733262549923577, 0.0005054425926068079, 9.746171098608551e-7,
        -1.4990881642081326e-7, -2.1909585489195384e-6, 4.369050978972373e-7
    },
    {
        0.0, -0.0022953226466311846, 0.0004346051143027875, 8.242791100518093e-7,
        -1.2805135952766697e-7, -1.6949897049523922e-6, 3.422682386999059e-7
    },
    {
        0.0, -0.001965066553226237, 0.0003726748214966267, 6.948230595968057e-7,
        -1.0893537673756382e-7, -1.2847365039255238e-6, 2.636510917970737e-7
    },
    {
        0.0, -0.0016768975745452546, 0.0003185986843217545, 5.836031380332406e-7,
        -9.227733544199854e-8, -9.478789866638745e-7, 1.9878085455611311e-7
    },
    {
        0.0, -0.0014257995019235686, 0.00027144329443767575, 4.882862544931252e-7,
        -7.78142613452633e-8, -6.736679072696785e-7, 1.4567112560814807e-7
    },
    {
        0.0, -0.001207329102178635, 0.00023038165804609793, 4.0681683755723757e-7,
        -6.530393590995303e-8, -4.5273752265342554e-7, 1.0258827300914538e-7
    },
    {
        0.0, -0.0010175525988901598, 0.00019468141499623547, 3.3738543311559653e-7,
        -5.4524594189488685e-8, -2.769397563950545e-7, 6.802155650167082e-8
    },
    {
        0.0, -0.0008529890350864381, 0.00016369433291711814, 2.784007150372667e-7,
        -4.527426567389784e-8, -1.3919736994883865e-7, 4.065660346716594e-8
    },
    {
        0.0, -0.000710559786235094, 0.0001368469410162214, 2.284645523166466e-7,
        -3.736986933451588e-8, -3.33740301256658e-8, 1.935187866765764e-8
    },
    {
        0.0, -0.0005875435686633479, 0.00011363218228888014, 1.8634981173502602e-7,
        -3.0646148882028884e-8, 4.584060938703105e-8, 3.117824605347894e-9
    },
    {
        0.0, -0.00048153635698016127, 9.36019755490946e-5, 1.5098060721138178e-7,
        -2.4954514159904135e-8, 1.0303249016722406e-7, -8.901617423354475e-9
    },
    {
        0.0, -0.0003904156855113304, 7.636059006210922e-5, 1.214147361639408e-7,
        -2.0161838611495965e-8, 1.4215288978381436e-7, -1.7445365450797455e-8
    },
    {
        0.0, -0.0003123088638871599, 6.15587457616826e-5, 9.682806960290851e-8,
        -1.614925009379884e-8, 1.6659765274378784e-7, -2.314966688307051e-8
    },
    {
        0.0, -0.0002455646863724097, 4.888836118707935e-5, 7.650068655218694e-8,
        -1.2810942320956414e-8, 1.7927709747229356e-7, -2.6560888756677527e-8
    },
    {
        0.0, -0.00018872825887067895, 3.80778794820807e-5, 5.980456496834626e-8,
        -1.0053026383481356e-8, 1.8267765493778287e-7, -2.8146814474288112e-8
    },
    {
        0.0, -0.00014051860728583489, 2.888811015607104e-5, 4.6192660789629756e-8,
        -7.792435680144465e-9, 1.7891617832104737e-7, -2.8306613476470306e-8
    },
    {
        0.0, -9.980876654674542e-5, 2.110853090155104e-5, 3.518922429385168e-8,
        -5.955892874238932e-9, 1.6978775942661999e-7, -2.7379632502769978e-8
    },
    {
        0.0, -6.560808151800609e-5, 1.4553999670845843e-5, 2.6381218745696602e-8,
        -4.4789438653650216e-9, 1.568077950265565e-7, -2.565314111004772e-8
    },
    {
        0.0, -3.704647960668239e-5, 9.061832507250655e-6, 1.9410720531998955e-8,
        -3.3050610262377034e-9, 1.412489638257725e-7, -2.3369149775067093e-8
    },
    {
        0.0, -1.3360500473921362e-5, 4.489207365375873e-6, 1.3968192766243029e-8,
        -2.3848159089142074e-9, 1.241737011834172e-7, -2.0730406052957424e-8
    },
    {
        0.0, 6.119108822750233e-6, 7.108583987319884e-7, 9.78653582685425e-9,
        -1.6751201292043224e-9, 1.0646269316518795e-7, -1.7905662748073757e-8
    },
    {
        0.0, 2.197840441961273e-5, -2.382971009338085e-6, 6.635828602485704e-9,
        -1.1385320735118988e-9, 8.883985308518617e-8, -1.5034301746509473e-8
    },
    {
        0.0, 3.473001477936818e-5, -4.888344796512938e-6, 4.318683465323659e-9,
        -7.4262634393351e-10, 7.189419166010718e-8, -1.2230387939601478e-8
    },
    {
        0.0, 4.48218047575613e-5, -6.889245638547232e-6, 2.666146284282035e-9,
        -4.594223890054313e-10, 5.609894556041079e-8, -9.5862194257991e-9
    },
    {
        0.0, 5.264455630976817e-5, -8.459003797170885e-6, 1.5340802183331824e-9,
        -2.6486849827377175e-10, 4.182828789153705e-8, -7.1754328150656824e-9
    },
    {
        0.0, 5.853877441610379e-5, -9.661563531332907e-6, 7.999786819919316e-10,
        -1.3837722050465613e-10, 2.9371907426452677e-8, -5.055715885768549e-9
    },
    {
        0.0, 6.281150085969515e-5, -1.055447888570993e-5, 3.6015882802193284e-10,
        -6.240825951770486e-11, 1.8945917549421876e-8, -3.2708624384297384e-9
    },
    {
        0.0, 6.832193807105065e-5, -1.1638224507510174e-5, 1.2704054948430624e-10,
        -2.2051254901281143e-11, 1.0747245545034191e-8, -1.8603673043632163e-9
    },
    {
        0.0, 5.6532812381221376e-5, -9.695269728135802e-6, 2.762140436561325e-11,
        -4.804328210313499e-12, 4.7402749087128445e-9, -8.224440610231705e-10
    },
    {
        0.0, 8.770688096765129e-5, -1.5201239659177055e-5, 2.8046371545147288e-12,
        -4.909916357380435e-13, 1.2169596640775666e-9, -2.1163498951074856e-10
    }
};

/* The number significand / 2^63 * 2^exponent, with the top bit of the significand set. */
typedef struct {
    uint64_t significand;
    int32_t exponent;
} motor_continuous_scaled_t;

/* A number with a sign. */
typedef struct {
    motor_continuous_scaled_t magnitude;
    int negative;
} motor_continuous_signed_t;

/* The angle quadrant * pi/2 + rest. */
typedef struct {
    motor_continuous_signed_t rest;
    uint32_t quadrant;
} motor_continuous_turned_t;

/* Attaches a sign. */
static motor_continuous_signed_t motor_continuous_signed(motor_continuous_scaled_t magnitude, int negative)
{
    motor_continuous_signed_t result;
    result.magnitude = magnitude;
    result.negative = negative;
    return result;
}

/* A number below 1 as fixed point with 64 fraction bits. */
static uint64_t motor_continuous_fraction(motor_continuous_scaled_t a)
{
    const int32_t shift = -1 - a.exponent;
    if (shift > 63) {
        return 0;
    }
    return a.significand >> shift;
}

/* The upper half of the product, at most 2 too small. */
static uint64_t motor_continuous_mul_high(uint64_t a, uint64_t b)
{
    const uint64_t a_high = a >> 32;
    const uint64_t a_low = a & 0xFFFFFFFFu;
    const uint64_t b_high = b >> 32;
    const uint64_t b_low = b & 0xFFFFFFFFu;
    const uint64_t cross = ((a_high * b_low) >> 32) + ((a_low * b_high) >> 32);
    return a_high * b_high + cross;
}

/* The square of a number below 1 as fixed point with 64 fraction bits. */
static uint64_t motor_continuous_squared_fraction(motor_continuous_scaled_t a)
{
    const uint64_t x = motor_continuous_fraction(a);
    return motor_continuous_mul_high(x, x);
}

/* Makes a number of a significand that has its top bit set. */
static motor_continuous_scaled_t motor_continuous_scaled(uint64_t significand, int32_t exponent)
{
    motor_continuous_scaled_t result;
    result.significand = significand;
    result.exponent = exponent;
    return result;
}

/* Makes a number of a significand of at least 2^62. */
static motor_continuous_scaled_t motor_continuous_settled(uint64_t significand, int32_t exponent)
{
    if ((significand >> 63) == 0) {
        return motor_continuous_scaled(significand << 1, exponent - 1);
    }
    return motor_continuous_scaled(significand, exponent);
}

/* (1 - cos(r)) / r^2 in powers of -r^2. */
static const uint64_t MOTOR_CONTINUOUS_COSINE[8] = {
    UINT64_C(0x8000000000000000), UINT64_C(0x0AAAAAAAAAAAAAA8), UINT64_C(0x005B05B05B05B02B),
    UINT64_C(0x0001A01A01A01865), UINT64_C(0x0000049F93EDD666), UINT64_C(0x00000008F76C6243),
    UINT64_C(0x000000000C9C9706), UINT64_C(0x00000000000D551B)};

/* cos(r) for 0 < r <= pi/4, relative error below 2^-60. */
static motor_continuous_scaled_t motor_continuous_cosine(motor_continuous_scaled_t r)
{
    const uint64_t z = motor_continuous_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = MOTOR_CONTINUOUS_COSINE[6] - ((MOTOR_CONTINUOUS_COSINE[7] * z_high) >> 32);
    const uint64_t c5 = MOTOR_CONTINUOUS_COSINE[5] - ((tail * z_high) >> 32);
    const uint64_t c4 = MOTOR_CONTINUOUS_COSINE[4] - motor_continuous_mul_high(c5, z);
    const uint64_t c3 = MOTOR_CONTINUOUS_COSINE[3] - motor_continuous_mul_high(c4, z);
    const uint64_t c2 = MOTOR_CONTINUOUS_COSINE[2] - motor_continuous_mul_high(c3, z);
    const uint64_t c1 = MOTOR_CONTINUOUS_COSINE[1] - motor_continuous_mul_high(c2, z);
    const uint64_t c0 = MOTOR_CONTINUOUS_COSINE[0] - motor_continuous_mul_high(c1, z);
    return motor_continuous_settled((UINT64_C(1) << 63) - (motor_continuous_mul_high(c0, z) >> 1), 0);
}

/* (1 - sin(r) / r) / r^2 in powers of -r^2. */
static const uint64_t MOTOR_CONTINUOUS_SINE[7] = {
    UINT64_C(0x2AAAAAAAAAAAAAA6), UINT64_C(0x0222222222222160), UINT64_C(0x000D00D00D00C575),
    UINT64_C(0x00002E3BC74A673D), UINT64_C(0x0000006B9914A637), UINT64_C(0x00000000B090498C),
    UINT64_C(0x0000000000D552BC)};

/* sin(r) for 0 < r <= pi/4, relative error below 2^-60. */
static motor_continuous_scaled_t motor_continuous_sine(motor_continuous_scaled_t r)
{
    const uint64_t z = motor_continuous_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = MOTOR_CONTINUOUS_SINE[5] - ((MOTOR_CONTINUOUS_SINE[6] * z_high) >> 32);
    const uint64_t c4 = MOTOR_CONTINUOUS_SINE[4] - ((tail * z_high) >> 32);
    const uint64_t c3 = MOTOR_CONTINUOUS_SINE[3] - motor_continuous_mul_high(c4, z);
    const uint64_t c2 = MOTOR_CONTINUOUS_SINE[2] - motor_continuous_mul_high(c3, z);
    const uint64_t c1 = MOTOR_CONTINUOUS_SINE[1] - motor_continuous_mul_high(c2, z);
    const uint64_t c0 = MOTOR_CONTINUOUS_SINE[0] - motor_continuous_mul_high(c1, z);
    const uint64_t lost = motor_continuous_mul_high(r.significand, motor_continuous_mul_high(c0, z));
    return motor_continuous_settled(r.significand - lost, r.exponent);
}

/* The sine of an angle. */
static motor_continuous_signed_t motor_continuous_sine_at(motor_continuous_turned_t angle)
{
    const int back = (angle.quadrant & 2) != 0;
    if ((angle.quadrant & 1) != 0) {
        return motor_continuous_signed(motor_continuous_cosine(angle.rest.magnitude), back);
    }
    return motor_continuous_signed(motor_continuous_sine(angle.rest.magnitude), back != angle.rest.negative);
}

/* Makes an angle of its parts. */
static motor_continuous_turned_t motor_continuous_turned(motor_continuous_signed_t rest, uint32_t quadrant)
{
    motor_continuous_turned_t result;
    result.rest = rest;
    result.quadrant = quadrant;
    return result;
}

/* The number of zero bits above the highest one bit; x is not 0. */
static int32_t motor_continuous_leading_zeros(uint64_t x)
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
static motor_continuous_scaled_t motor_continuous_normalised(uint64_t significand, int32_t exponent)
{
    const int32_t shift = motor_continuous_leading_zeros(significand);
    return motor_continuous_scaled(significand << shift, exponent - shift);
}

/* a b, relative error below 2^-60. */
static motor_continuous_scaled_t motor_continuous_product(motor_continuous_scaled_t a, motor_continuous_scaled_t b)
{
    return motor_continuous_settled(motor_continuous_mul_high(a.significand, b.significand),
                            a.exponent + b.exponent + 1);
}

/* pi with 62 fraction bits; as a significand also pi/2 and pi/4. */
#define MOTOR_CONTINUOUS_PI UINT64_C(0xC90FDAA22168C235)

/* The angle of (high, low) / 2^126 quarter turns, its rest exact to 2^-60 of itself. */
static motor_continuous_turned_t motor_continuous_turned_from_quarters(uint64_t high, uint64_t low)
{
    const uint64_t eighths = high >> 61;
    const int negative = (eighths & 1) != 0;
    uint64_t upper = (high << 2) | (low >> 62);
    uint64_t lower = low << 2;
    if (negative) {
        upper = (lower == 0) ? (UINT64_C(0) - upper) : UINT64_MAX - upper;
        lower = (UINT64_C(0) - lower);
    }
    const int32_t shift = motor_continuous_leading_zeros(upper | 1);
    const uint64_t significand = (upper << shift) | ((lower >> 1) >> (63 - shift));
    const motor_continuous_signed_t rest = motor_continuous_signed(
        motor_continuous_product(motor_continuous_scaled(significand, -1 - shift), motor_continuous_scaled(MOTOR_CONTINUOUS_PI, 0)),
        negative);
    return motor_continuous_turned(rest, (uint32_t)(((eighths + 1) >> 1) & 3));
}

/* The bits of a number. */
typedef union {
    double value;
    uint64_t bits;
} motor_continuous_f64_cell_t;

/* The bits of a number. */
static uint64_t motor_continuous_f64_to_bits(double x)
{
    motor_continuous_f64_cell_t cell;
    cell.value = x;
    return cell.bits;
}

/* The bit of the sign. */
#define MOTOR_CONTINUOUS_SIGN_F64 UINT64_C(0x8000000000000000)

/* The bits of the largest magnitude. */
#define MOTOR_CONTINUOUS_MAGNITUDE_F64 UINT64_C(0x7FFFFFFFFFFFFFFF)

/* The bits of infinity. */
#define MOTOR_CONTINUOUS_INFINITY_F64 UINT64_C(0x7FF0000000000000)

/* The bits of the only NaN that is returned. */
#define MOTOR_CONTINUOUS_NAN_F64 UINT64_C(0x7FF8000000000000)

/* The number with these bits. */
static double motor_continuous_f64_from_bits(uint64_t bits)
{
    motor_continuous_f64_cell_t cell;
    cell.bits = bits;
    return cell.value;
}

/* The finite positive number with these bits, not 0; exact. */
static motor_continuous_scaled_t motor_continuous_unpacked_f64(uint64_t magnitude)
{
    const int32_t field = (int32_t)(magnitude >> 52);
    const uint64_t digits = magnitude << 11;
    if (field == 0) {
        return motor_continuous_normalised(digits, -1022);
    }
    return motor_continuous_scaled(digits | (UINT64_C(1) << 63), field - 1023);
}

/* 2/pi after 64 zero bits. */
static const uint32_t MOTOR_CONTINUOUS_TWO_OVER_PI_F64[40] = {
    UINT32_C(0x00000000), UINT32_C(0x00000000), UINT32_C(0xA2F9836E), UINT32_C(0x4E441529),
    UINT32_C(0xFC2757D1), UINT32_C(0xF534DDC0), UINT32_C(0xDB629599), UINT32_C(0x3C439041),
    UINT32_C(0xFE5163AB), UINT32_C(0xDEBBC561), UINT32_C(0xB7246E3A), UINT32_C(0x424DD2E0),
    UINT32_C(0x06492EEA), UINT32_C(0x09D1921C), UINT32_C(0xFE1DEB1C), UINT32_C(0xB129A73E),
    UINT32_C(0xE88235F5), UINT32_C(0x2EBB4484), UINT32_C(0xE99C7026), UINT32_C(0xB45F7E41),
    UINT32_C(0x3991D639), UINT32_C(0x835339F4), UINT32_C(0x9C845F8B), UINT32_C(0xBDF9283B),
    UINT32_C(0x1FF897FF), UINT32_C(0xDE05980F), UINT32_C(0xEF2F118B), UINT32_C(0x5A0A6D1F),
    UINT32_C(0x6D367ECF), UINT32_C(0x27CB09B7), UINT32_C(0x4F463F66), UINT32_C(0x9E5FEA2D),
    UINT32_C(0x7527BAC7), UINT32_C(0xEBE5F17B), UINT32_C(0x3D0739F7), UINT32_C(0x8A5292EA),
    UINT32_C(0x6BFB5FB1), UINT32_C(0x1F8D5D08), UINT32_C(0x56033046), UINT32_C(0xFC7B6BAB)};

/* 32 bits of 2/pi from bit 32 slot + shift on. */
static uint64_t motor_continuous_window_f64(uint32_t slot, uint32_t shift)
{
    const uint64_t first = (uint64_t)(MOTOR_CONTINUOUS_TWO_OVER_PI_F64[slot]);
    const uint64_t second = (uint64_t)(MOTOR_CONTINUOUS_TWO_OVER_PI_F64[slot + 1]);
    return (((first << 32) | second) >> (32 - shift)) & 0xFFFFFFFFu;
}

/* A 128-bit unsigned integer. */
typedef struct {
    uint64_t high;
    uint64_t low;
} motor_continuous_pair_t;

/* Makes a 128-bit integer of its halves. */
static motor_continuous_pair_t motor_continuous_pair(uint64_t high, uint64_t low)
{
    motor_continuous_pair_t result;
    result.high = high;
    result.low = low;
    return result;
}

/* The exact 128-bit product. */
static motor_continuous_pair_t motor_continuous_mul_full(uint64_t a, uint64_t b)
{
    const uint64_t a_high = a >> 32;
    const uint64_t a_low = a & 0xFFFFFFFFu;
    const uint64_t b_high = b >> 32;
    const uint64_t b_low = b & 0xFFFFFFFFu;
    const uint64_t lowest = a_low * b_low;
    const uint64_t first = a_high * b_low + (lowest >> 32);
    const uint64_t second = a_low * b_high + (first & 0xFFFFFFFFu);
    const uint64_t high = a_high * b_high + (first >> 32) + (second >> 32);
    return motor_continuous_pair(high, (second << 32) | (lowest & 0xFFFFFFFFu));
}

/* The angle with these bits, positive and finite, its rest exact to 2^-60 of itself. */
static motor_continuous_turned_t motor_continuous_reduce_f64(uint64_t magnitude)
{
    if (magnitude <= UINT64_C(0x3FE921FB54442D18)) {
        return motor_continuous_turned(motor_continuous_signed(motor_continuous_unpacked_f64(magnitude), 0), 0);
    }
    const uint64_t digits = (magnitude & UINT64_C(0x000FFFFFFFFFFFFF)) | (UINT64_C(1) << 52);
    const uint32_t start = ((uint32_t)(magnitude >> 52)) - 1013;
    const uint32_t slot = start >> 5;
    const uint32_t shift = start & 31;
    const uint64_t upper =
        (motor_continuous_window_f64(slot, shift) << 32) | motor_continuous_window_f64(slot + 1, shift);
    const uint64_t middle =
        (motor_continuous_window_f64(slot + 2, shift) << 32) | motor_continuous_window_f64(slot + 3, shift);
    const uint64_t lower =
        (motor_continuous_window_f64(slot + 4, shift) << 32) | motor_continuous_window_f64(slot + 5, shift);
    const motor_continuous_pair_t center = motor_continuous_mul_full(middle, digits);
    const uint64_t low = (center.low + (motor_continuous_mul_high(lower, digits)));
    const uint64_t carry = (low < center.low) ? 1 : 0;
    const uint64_t high = ((upper * digits) + (center.high + carry));
    return motor_continuous_turned_from_quarters(high, low);
}

/* x rounded to the nearest, ties to even, with subnormals and overflow, and the sign put in. */
static double motor_continuous_rounded_f64(uint64_t sign, motor_continuous_scaled_t x)
{
    const int32_t field = x.exponent + 1023;
    if (field >= 2047) {
        return motor_continuous_f64_from_bits(sign | MOTOR_CONTINUOUS_INFINITY_F64);
    }
    const int32_t shift = (field > 0) ? 11 : 12 - field;
    if (shift > 63) {
        const int least = shift == 64 && x.significand > (UINT64_C(1) << 63);
        return motor_continuous_f64_from_bits(least ? sign + 1 : sign);
    }
    const uint64_t kept = x.significand >> shift;
    const uint64_t rest = x.significand - (kept << shift);
    const uint64_t half = UINT64_C(1) << (shift - 1);
    const uint64_t odd = kept & 1;
    const uint64_t up = (rest + odd > half) ? 1 : 0;
    const uint64_t base = (field > 0) ? ((uint64_t)(field - 1)) << 52 : 0;
    return motor_continuous_f64_from_bits(sign | (base + (kept + up)));
}

/* The sign bit of a negative number, else 0. */
static uint64_t motor_continuous_sign_f64(int negative)
{
    if (negative) {
        return MOTOR_CONTINUOUS_SIGN_F64;
    }
    return 0;
}

/* Sine of an angle in radians, error below 0.51 ulp. */
static double motor_continuous_sin_f64(double x)
{
    const uint64_t bits = motor_continuous_f64_to_bits(x);
    const uint64_t magnitude = bits & MOTOR_CONTINUOUS_MAGNITUDE_F64;
    if (magnitude >= MOTOR_CONTINUOUS_INFINITY_F64) {
        return motor_continuous_f64_from_bits(MOTOR_CONTINUOUS_NAN_F64);
    }
    if (magnitude == 0) {
        return x;
    }
    const motor_continuous_signed_t value = motor_continuous_sine_at(motor_continuous_reduce_f64(magnitude));
    return motor_continuous_rounded_f64((bits & MOTOR_CONTINUOUS_SIGN_F64) ^ motor_continuous_sign_f64(value.negative),
                                value.magnitude);
}

/* What one part of a step hands to the next. */
typedef struct {
    uint32_t t11;
    double t21;
    double t32;
    uint32_t t39;
    double t109;
    double t110;
    double t111;
    motor_continuous_status t118;
} motor_continuous_work;

/* Part 1 of a step. */
static void motor_continuous_part_1(motor_continuous_state *state, const motor_continuous_measurements *measurements, const motor_continuous_inputs *inputs, motor_continuous_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    const uint32_t t0 = state->newest;
    const uint32_t t1 = (t0 < 100U) ? t0 : 100U;
    const uint32_t t2 = state->count;
    const int t4 = 100U < t2;
    const double t5 = measurements->y;
    const int t6 = (-1e304 <= t5) && (t5 <= 1e304);
    const double t7 = inputs->u;
    const int t8 = (-1e304 <= t7) && (t7 <= 1e304);
    const double t9 = state->u[t1];
    const double t10 = t8 ? t7 : t9;

    /* prediction, for a sample that is missing */
    work->t11 = (t1 < 100U) ? (t1 + 1U) : 0U;
    const double t12 = state->ahead_y;
    const double t14 = 9.51669369298718e-8 * t10;
    const double t15 = t12 + t14;
    const double t16 = state->y[t1];
    const int t17 = (-1e304 <= t15) && (t15 <= 1e304);
    const int t18 = t4 && t17;
    const double t19 = t18 ? t15 : t16;
    const double t20 = t6 ? t5 : t19;
    work->t21 = motor_continuous_sin_f64(t20);
    const double t22 = state->sin_q[t1];
    const double t23 = work->t21 - t22;
    const double t25 = -5.831721255555794e-6 * t23;
    const double t26 = t15 + t25;
    const int t27 = (-1e304 <= t26) && (t26 <= 1e304);
    const int t28 = t4 && t27;
    const double t29 = t28 ? t26 : t16;
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
static void motor_continuous_part_2(motor_continuous_state *state, motor_continuous_work *work)
{
    /* the sums over the window, newest sample first */
    double t46 = 0.0;
    double t47 = 0.0;
    double t48 = 0.0;
    double t49 = 0.0;
    double t50 = 0.0;
    double t51 = 0.0;
    double t52 = 0.0;
    uint32_t t53 = work->t11;
    for (uint32_t row = 0U; row < 100U; ++row) {
        const double *const gains = MOTOR_CONTINUOUS_WINDOW[row];
        const double t54 = state->y[t53];
        const double t55 = gains[0];
        const double t56 = t55 * t54;
        const double t57 = t46 + t56;
        const double t58 = gains[1];
        const double t59 = t58 * t54;
        const double t60 = t47 + t59;
        const double t61 = gains[2];
        const double t62 = t61 * t54;
        const double t63 = t50 + t62;
        const double t64 = state->u[t53];
        const double t65 = gains[3];
        const double t66 = t65 * t64;
        const double t67 = t48 + t66;
        const double t68 = gains[4];
        const double t69 = t68 * t64;
        const double t70 = t51 + t69;
        const double t71 = state->sin_q[t53];
        const double t72 = gains[5];
        const double t73 = t72 * t71;
        const double t74 = t49 + t73;
        const double t75 = gains[6];
        const double t76 = t75 * t71;
        const double t77 = t52 + t76;
        const uint32_t t78 = ((t53 >= 1U) && (t53 < 101U)) ? (t53 - 1U) : 100U;
        t46 = t57;
        t47 = t60;
        t48 = t67;
        t49 = t74;
        t50 = t63;
        t51 = t70;
        t52 = t77;
        t53 = t78;
    }
    const double t79 = state->y[t53];
    const double t80 = 0.0 * t79;
    const double t81 = t46 + t80;
    const double t83 = 2.286349724014743e-5 * t79;
    const double t84 = t47 + t83;
    const double t86 = -3.9806022664630145e-6 * t79;
    const double t87 = t50 + t86;
    const double t88 = state->sin_q[t53];
    const double t90 = -2.438562692220541e-11 * t88;
    const double t91 = t49 + t90;
    const double t93 = 4.209928143451634e-12 * t88;
    const double t94 = t52 + t93;
    const double t95 = t84 + t48;
    const double t96 = t95 + t91;
    const double t97 = t87 + t51;
    const double t98 = t97 + t94;

    /* the next measurement, as far as it is known */
    const double t100 = 0.000999413586572696 * t96;
    const double t102 = 7.021338035817581e-6 * t98;
    const double t104 = -1.749340301442286e-5 * work->t21;
    const double t105 = t81 + t100;
    const double t106 = t105 + t102;
    const double t107 = t106 + t104;
    state->ahead_y = t107;

    /* the estimate; until the window is full, the start */
    const int t108 = 100U < work->t39;
    work->t109 = t108 ? t81 : work->t32;
    work->t110 = t108 ? t96 : 0.0;
    work->t111 = t108 ? t98 : 0.0;
    const uint32_t t112 = state->coasting;
    const int t113 = t112 == 0U;
    const motor_continuous_status t117 = t113 ? MOTOR_CONTINUOUS_CONVERGED : MOTOR_CONTINUOUS_COASTING;
    work->t118 = t108 ? t117 : MOTOR_CONTINUOUS_CONVERGING;
}

void motor_continuous_init(motor_continuous_state *state)
{
    for (uint32_t slot = 0U; slot < 101U; ++slot) {
        state->y[slot] = 0.0;
    }
    for (uint32_t slot = 0U; slot < 101U; ++slot) {
        state->u[slot] = 0.0;
    }
    for (uint32_t slot = 0U; slot < 101U; ++slot) {
        state->sin_q[slot] = 0.0;
    }
    state->newest = 100U;
    state->count = 0U;
    state->coasting = 0U;
    state->ahead_y = 0.0;
}

void motor_continuous_step(motor_continuous_state *state, const motor_continuous_measurements *measurements,
                           const motor_continuous_inputs *inputs, motor_continuous_estimate *estimate)
{
    motor_continuous_work work;
    motor_continuous_part_1(state, measurements, inputs, &work);
    motor_continuous_part_2(state, &work);

    estimate->q = work.t109;
    estimate->dq = work.t110;
    estimate->i = work.t111;
    estimate->status = work.t118;
}
