/* two_mass_drive.c: Finite-time observer: Motor and load on an elastic shaft, both angles measured.
 *
 * Generated; two_mass_drive.h says from what and how.
 */
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "two_mass_drive.c needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

#include "two_mass_drive.h"

#include <float.h>
#if defined(FLT_EVAL_METHOD)
#if (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16) /* 16: as 0, with _Float16 in hardware */
#error "two_mass_drive.c needs each operation rounded to its own type: see FLT_EVAL_METHOD"
#endif
#endif

/* weights by age, from age 0
 *   [0] motor_angle from motor_angle
 *   [1] load_angle from motor_angle
 *   [2] motor_speed from motor_angle
 *   [3] load_speed from motor_angle
 *   [4] motor_angle from load_angle
 *   [5] load_angle from load_angle
 *   [6] motor_speed from load_angle
 *   [7] load_speed from load_angle
 *   [8] motor_angle from torque
 *   [9] load_angle from torque
 *   [10] motor_speed from torque
 *   [11] load_speed from torque
 *   [12] motor_angle from sin(load_angle)
 *   [13] load_angle from sin(load_angle)
 *   [14] motor_speed from sin(load_angle)
 *   [15] load_speed from sin(load_angle)
 */
static const double TWO_MASS_DRIVE_WINDOW[41][16] = {
    {
        0.24955123482911712, 0.3807710314842262, 66.79813791182573, 25.22764851979025,
        0.003807710314842262, 0.009082302622060607, 1.5534173705669811, 0.6848311244592576,
        3.1175051578884022e-6, -1.5793286325987508e-6, 0.02461869399169247, -8.404056287847784e-5,
        1.950228796469844e-9, -1.2364819221467667e-6, -2.895235838926766e-5, -0.007492821569308232
    },
    {
        0.2167407247448528, 0.3056001476944857, 52.83676001618501, 19.71495672043762,
        0.0036803949545000138, 0.008734887090353761, 1.495389397656943, 0.6566477478074801,
        1.7705326361225138e-5, -1.0668979320218405e-5, 0.047339618853605964, -0.0005504605571299572,
        -1.268360342857228e-8, -7.383874996787321e-6, -0.00021756249253296358, -0.01494533006422181
    },
    {
        0.1852487959127026, 0.2357299199395281, 39.76517958649261, 14.636963220456954,
        0.003550442431653537, 0.008376870246577349, 1.4355818298150085, 0.6275949745569587,
        3.0714050049419136e-5, -2.708242565875668e-5, 0.04323718238706181, -0.0013874915047459699,
        -9.624336233927664e-8, -1.4614281437413775e-5, -0.0005445798822713657, -0.014855692525504442
    },
    {
        0.15527726163889957, 0.17156673441774, 27.665402600885177, 10.020752021773678,
        0.003417449119690366, 0.008007439318334598, 1.3738306550849038, 0.5976186367038424,
        3.867956580865432e-5, -4.880064369097717e-5, 0.037759775196177105, -0.0024703006070379125,
        -2.7487452014341947e-7, -2.1598198924563222e-5, -0.0009738704538931326,
        -0.014724728173306383
    },
    {
        0.12701203528316576, 0.11345305514602062, 16.60870487263015, 5.888164895400144,
        0.003281043191891057, 0.007625909377591711, 1.3099933218400943, 0.5666750507061068,
        4.231885342954342e-5, -7.391739982963868e-5, 0.03127939995676735, -0.003672197454423842,
        -5.590351696341658e-7, -2.8247324781577455e-5, -0.0014849559492790918, -0.01454924904366773
    },
    {
        0.10062069615367922, 0.061662522080864854, 6.654642910384954, 2.2554746791148133,
        0.0031408894896392528, 0.007231733144435695, 1.2439507170632653, 0.5347316708881946,
        4.234315691264395e-5, -0.00010066454203481982, 0.024148848863350576, -0.004878881884229708,
        -9.481552975838193e-7, -3.44695860997278e-5, -0.0020553284262905328, -0.014326171267763926
    },
    {
        0.07625024712954336, 0.01639582009595674, -2.149805825315797, -0.8668782063353779,
        0.0029966940071767477, 0.006824509249119184, 1.1756088858333473, 0.5017676164086122,
        3.9446746315006615e-5, -0.0001274356027254217, 0.016696752347740297, -0.005989878827199407,
        -1.4327566970235153e-6, -4.0174177570041995e-5, -0.002661490935254048, -0.014052824052364033
    },
    {
        0.05402509336891789, -0.022222622056679645, -9.77096133853936, -3.474482081644287,
        0.0028482079341872217, 0.00640398883413813, 1.1049004681584749, 0.46777406390874726,
        3.429642548710615e-5, -0.00015280570980256321, 0.009223229376812272, -0.0069196721320446625,
        -1.996502851175521e-6, -4.527603678208926e-5, -0.0032799116995639653, -0.013727211925561108
    },
    {
        0.034045269149048867, -0.054147052970910846, -16.189007816997567, -5.569079995484065,
        0.0026952312021161825, 0.005970080396680265, 1.0317858324140718, 0.432754499485944,
        2.7521945705507184e-5, -0.00017554753703878453, 0.001996200097187929, -0.007598522809629582,
        -2.618145883061695e-6, -4.969970101200961e-5, -0.0038878789344897655, -0.013348227345776164
    },
    {
        0.016384937218419843, -0.07941190017422972, -21.398399987560765, -7.158623004606246,
        0.002537615485466664, 0.0055228527918005765, 0.9562538880538787, 0.3967248252537056,
        1.9707467564060748e-5, -0.0001946430933813081, -0.004751590093364465, -0.007972962509674365,
        -3.2733411036375454e-6, -5.338250343744801e-5, -0.004464245811329258, -0.01291581185795553
    },
    {
        0.0010911820490143653, -0.09813232286739815, -25.40810227155067, -8.257249227203504,
        0.0023752666152946976, 0.005062536337900586, 0.878322563920539, 0.35971331744841734,
        1.1384193828690914e-5, -0.00020929122149693078, -0.01082479829572567, -0.00800595851551192,
        -3.93630355260164e-6, -5.627708108060794e-5, -0.004990057574324195, -0.012431065079526682
    },
    {
        -0.011816884909618158, -0.11050379769506605, -28.24165583705699, -8.885188026066544,
        0.0022081463687011857, 0.004589521988269595, 0.7980389423502321, 0.32176043479566063,
        3.0242746057624657e-6, -0.0002189107480615839, -0.016066939704263525, -0.007676752032686113,
        -4.581285136808062e-6, -5.8353181344986033e-5, -0.005449055401453045, -0.01189630189126088
    },
    {
        -0.02234869341708324, -0.11680073086953524, -29.937070661935113, -9.068589573253712,
        0.002036273605205339, 0.004104358555332206, 0.7154790432986688, 0.2829184776395522,
        -4.963936537718541e-6, -0.00022313930076571926, -0.02036106009774364,
        -0.0069803769714018304, -5.1838554538192966e-6, -5.95987685282974e-5, -0.005828054222695939,
        -0.011315059276170603
    },
    {
        -0.030542445274873882, -0.11737410163161711, -30.546541796707565, -8.839280950945236,
        0.0018597247284101433, 0.003607747997570043, 0.6307472568668943, 0.24325110014445245,
        -1.2239220573798653e-5, -0.00022182787866525564, -0.02362962735628131,
        -0.005926871698703655, -5.721974061528879e-6, -6.0020445918476146e-5, -0.006117194325842468,
        -0.010692055274936817
    },
    {
        -0.03646500094858636, -0.11264815377498906, -30.135991126991723, -8.234450843083385,
        0.0016786334592467913, 0.00310053880257046, 0.5439754268261431, 0.20283267967824595,
        -1.8529394542192606e-5, -0.00021503133227180208, -0.025833657065832537,
        -0.004540201283952037, -6.1768467357914546e-6, -5.964322277303642e-5,
        -0.0063100691461407685, -0.010033103491914776
    },
    {
        -0.040211419191571486, -0.10311616364294664, -28.78443805528043, -7.296265758414551,
        0.0014931899152219846, 0.0025837175230200484, 0.455321591981401, 0.1617475492584255,
        -2.363177060349251e-5, -0.00020299497659290335, -0.02697109985988721,
        -0.0028569125045081706, -6.533563062651028e-6, -5.85096684165177e-5, -0.006403734109044855,
        -0.009344987475377034
    },
    {
        -0.04190415103319527, -0.08933532448735534, -26.583204626457487, -6.071421586795619,
        0.0013036389983944552, 0.0020583985454225386, 0.3649683964224356, 0.12008910066470485,
        -2.7412191069109523e-5, -0.00018613762319854036, -0.027074530202892896,
        -0.0009245482460915084, -6.781517456592659e-6, -5.6678507652102276e-5,
        -0.006398603733863493, -0.008635300094505152
    },
    {
        -0.04169189367977869, -0.07192079821803529, -23.634962684767295, -4.6106351164193855,
        0.001110278103176845, 0.0015258121935975719, 0.2731211838377357, 0.0779587674734696,
        -2.9802681810819476e-5, -0.00016503137536156098, -0.026208187660302987,
        0.001200148141647025, -6.914620299602365e-6, -5.422272247479206e-5, -0.0062982463716089124,
        -0.007912253730464992
    },
    {
        -0.039748114044792685, -0.05153899622829499, -20.05263264669469, -2.9680809195647404,
        0.000913454163396096, 0.0009872912903317642, 0.180005795060271, 0.03546489882927752,
        -3.079778953162606e-5, -0.0001403785825301454, -0.024464432156130693, 0.003453204548177754,
        -6.931310279119315e-6, -5.122723451787303e-5, -0.006109087907236351, -0.007184467678165485
    },
    {
        -0.03626925572653001, -0.028900161024530715, -15.958145379462257, -1.200779738627216,
        0.0007135600662487937, 0.0004442563206379087, 0.08586609182448665, -0.0072784637830803104,
        -3.0449690235136953e-5, -0.00011298639606070469, -0.02195968413436429, 0.005765531003916019,
        -6.834383091900646e-6, -4.77862506076467e-5, -0.005840037472829439, -0.00646073960939659
    },
    {
        -0.031472647235986924, -0.004750329686186087, -11.481080464536099, 0.6320548368728296,
        0.0005110304687569305, -0.0001018006413251075, -0.00903876670668517, -0.05015289318456319,
        -2.8862176531044346e-5, -8.373940658957503e-5, -0.018829928775381793, 0.008065130642369783,
        -6.630655406513115e-6, -4.400036011451499e-5, -0.005502049666299482, -0.005749808269421406
    },
    {
        -0.025594133095595727, 0.020137231384198397, -6.757195776667826, 2.4697040266078027,
        0.00030633705996537116, -0.0006493330627522035, -0.10443726478374121, -0.09303695181451592,
        -2.6183649852396955e-5, -5.3570874079873785e-5, -0.015225870350365657, 0.010279369934975812,
        -6.330486277215189e-6, -3.997347736942742e-5, -0.005107638926527011, -0.005060114762391621
    },
    {
        -0.01888545303269892, 0.04497102350477346, -1.9268648000048827, 4.250657970280606,
        9.998331932880057e-5, -0.0011967579462796806, -0.2000486554383866, -0.1358076199523443,
        -2.2599259957845098e-5, -2.3433083990962433e-5, -0.011307828323107212, 0.012337266416129583,
        -5.947181021424824e-6, -3.5809725189930854e-5, -0.004670362562147461, -0.004399569823056028
    },
    {
        -0.01161139783419897, 0.0689506412584064, 2.866560586241829, 5.913348000014292,
        -0.00010750117157897631, -0.0017424744810732734, -0.29558623491219954, -0.17834176026229445,
        -1.832234800353071e-5, 5.732623149745563e-6, -0.007240470848078089, 0.014171751790574822,
        -5.496304865074312e-6, -3.1610356485729354e-5, -0.004204289454076578, -0.003775334372338171
    },
    {
        -0.004046773467195581, 0.09127631803456751, 7.478443007158649, 7.396888462177963,
        -0.00031556680082376004, -0.0022848831339119225, -0.39076072845535265, -0.22051760143710458,
        -1.3585360785780338e-5, 3.302559644345788e-5, -0.003187483807075428, 0.01572186866473972,
        -4.994935387198631e-6, -2.747080997616596e-5, -0.00372347164342791, -0.00319362041399182
    },
    {
        0.0035267922356805284, 0.1111585791036065, 11.764588432022803, 8.641819257397001,
        -0.0005236503127402892, -0.0028224049553363276, -0.48528374800640045, -0.26221622327802546,
        -8.630412307626975e-6, 5.7614845062808935e-5, 0.0006937255619378184, 0.01693486016299867,
        -4.460883928895697e-6, -2.3477993268250657e-5, -0.0032414358741883666,
        -0.0026595189525212117
    },
    {
        0.010824163714759855, 0.12782788710336762, 15.582990538421523, 9.59084015222079,
        -0.0007311814362092249, -0.0033535008706221765, -0.5788712809205174, -0.3033230253181558,
        -3.69967448162327e-6, 7.876669852325052e-5, 0.004257192073431145, 0.01776811336444524,
        -3.911916654109794e-6, -1.9707881960850095e-5, -0.0027707116868644624,
        -0.0021768611049391663
    },
    {
        0.01756009413502837, 0.14054416351983856, 18.795569750592055, 10.189527907151698,
        -0.0009375896775605389, -0.0038766907227414456, -0.671247168046178, -0.34372916107850043,
        9.742185357806763e-7, 9.587064207912327e-5, 0.00737332693648943, 0.01819091980106798,
        -3.365005852535556e-6, -1.6223517134974745e-5, -0.002322411863700363, -0.0017481179489445176
    },
    {
        0.02345266418277304, 0.14860606983363267, 21.26988591450074, 10.387027364866636,
        -0.0011423111981668053, -0.004390571834655361, -0.7621465290753149, -0.38333292024441307,
        5.177568216219445e-6, 0.00010846284204570333, 0.009933530741588124, 0.018186019160291653,
        -2.835641360684586e-6, -1.307347566661207e-5, -0.0019058799217077532, -0.0013743439079748165
    },
    {
        0.02822672224573012, 0.15135993349823854, 22.880803636155573, 10.136707849594167,
        -0.0013447956948034964, -0.0048938368612709, -0.851319093219944, -0.42204104146435095,
        8.724630918903413e-6, 0.00011624691320434893, 0.01185439810818091, 0.01775089579081038,
        -2.337230658476532e-6, -1.0290878388842258e-5, -0.0015284179554329361, -0.001055167631450734
    },
    {
        0.0316172845041038, 0.14820820681307006, 23.512089627340302, 9.39677654255151,
        -0.0015445131998310206, -0.005385290707186889, -0.938532393903633, -0.4597699391007484,
        1.1466084020767052e-5, 0.00011911152509603586, 0.013081433724630153, 0.016898801569287206,
        -1.8806142983988448e-6, -7.892990390344136e-6, -0.0011951064707129272,
        -0.0007888334001884827
    },
    {
        0.03337285344263723, 0.13861735103640555, 23.05792197360076, 8.130840916600484,
        -0.0017409607182188645, -0.005863866294919888, -1.0235747872974734, -0.4964468280993291,
        1.3296773565415554e-5, 0.00011714449528134075, 0.013592207536058843, 0.015659483088008047,
        -1.4737208748701536e-6, -5.881455846508143e-6, -0.000908725951670351, -0.0005722950877149834
    },
    {
        0.033258613776900744, 0.12212504371539776, 21.424292059077313, 6.308412832064027,
        -0.0019336686193981685, -0.006328638979564199, -1.106258256169746, -0.532010732180739,
        1.4162589968064437e-5, 0.00011064307477463924, 0.013398886047475567, 0.014079595904359306,
        -1.1213827847420368e-6, -4.243196935514498e-6, -0.0006697877979044191,
        -0.0004013636546306853
    },
    {
        0.031059465770327654, 0.0983466141408406, 18.530280944781932, 3.905347509912829,
        -0.0021222067038957995, -0.006778839419701412, -1.1864209626424747, -0.5664133617869194,
        1.4066332746689993e-5, 0.00010012019299025612, 0.01255008697008283, 0.012222793680602176,
        -8.253306162948431e-7, -2.9519928098178848e-6, -0.00047667999280623336,
        -0.00027090806278370417
    },
    {
        0.026582857396456598, 0.06698061999538152, 14.309193291280947, 0.9042113020290163,
        -0.0023061898676588343, -0.00721386473069682, -1.2639295160367923, -0.5996198496216345,
        1.3072442007935467e-5, 8.63064957350567e-5, 0.011132015593149773, 0.010169485360566114,
        -5.843801918716385e-7, -1.970740501759818e-6, -0.0003259304556867573, -0.0001751083871394092
    },
    {
        0.01966137876147792, 0.027813487571806565, 8.709533430659773, -2.7054270364261583,
        -0.0024852832908996538, -0.007633287765135997, -1.3386809250168694, -0.631609333195207,
        1.131049324584578e-5, 7.014807904853774e-5, 0.009268853143617408, 0.008016258998556368,
        -3.94822143633731e-7, -1.2543852786144286e-6, -0.00021258853086112458,
        -0.00010775879460205235
    },
    {
        0.010155084627711334, -0.019276851705514107, 1.695809910506109, -6.926786008854587,
        -0.0026592070831428978, -0.008036864385867683, -1.4106042066778817, -0.6623753755008329,
        8.977372626339002e-6, 5.279989298165938e-5, 0.007122379820808788, 0.005874976392341001,
        -2.5101949392635154e-7, -7.534935715768745e-7, -0.00013072251864131376,
        -6.261696958942325e-5
    },
    {
        -0.0020464862545766125, -0.0743183844301929, -6.750843263802342, -11.755745487059453,
        -0.0028277403218890987, -0.008424538619704653, -1.4796616290305842, -0.691926216794906,
        6.338072016890533e-6, 3.561486163899412e-5, 0.0048908279756124315, 0.0038715481925077418,
        -1.4621411736099712e-7, -4.1842743178633686e-7, -7.402860010266999e-5,
        -3.3795514675783895e-5
    },
    {
        -0.01702262302082145, -0.13724354190444457, -16.632238393696184, -17.180807806823076,
        -0.0029907244288673858, -0.008796445604042476, -1.545849567472116, -0.7202848524058615,
        3.7250662424582667e-6, 2.0128837886038036e-5, 0.002806973847655312, 0.0021444045805039122,
        -7.353826055451046e-8, -2.0406575983236815e-7, -3.654399367809481e-5, -1.618985948706766e-5
    },
    {
        -0.03482011012886174, -0.20788886146146313, -27.932906353547317, -23.18314736853739,
        -0.0031480658351620825, -0.009152912264214766, -1.6091989602537333, -0.7474889335329157,
        1.5362590501466772e-6, 8.041581942579618e-6, 0.0011354891824278943, 0.0008426818440408926,
        -2.722256953587699e-8, -7.500455354100503e-8, -1.3454750998743103e-5, -5.936289939659057e-6
    },
    {
        -0.055452270722160454, -0.2859958002016851, -40.62007452536994, -29.736749213151022,
        -0.003299737894486262, -0.009494455686020649, -1.6697753526114074, -0.7735904900941711,
        2.3150867823126854e-7, 1.1940215546669495e-6, 0.0001695867248565987, 0.00012415015021259695,
        -3.987407301427839e-9, -1.1156353459547344e-8, -1.9862948904970684e-6, -8.928795652774033e-7
    }
};

/* The number significand / 2^63 * 2^exponent, with the top bit of the significand set. */
typedef struct {
    uint64_t significand;
    int32_t exponent;
} two_mass_drive_scaled_t;

/* A number with a sign. */
typedef struct {
    two_mass_drive_scaled_t magnitude;
    int negative;
} two_mass_drive_signed_t;

/* The angle quadrant * pi/2 + rest. */
typedef struct {
    two_mass_drive_signed_t rest;
    uint32_t quadrant;
} two_mass_drive_turned_t;

/* Attaches a sign. */
static two_mass_drive_signed_t two_mass_drive_signed(two_mass_drive_scaled_t magnitude, int negative)
{
    two_mass_drive_signed_t result;
    result.magnitude = magnitude;
    result.negative = negative;
    return result;
}

/* A number below 1 as fixed point with 64 fraction bits. */
static uint64_t two_mass_drive_fraction(two_mass_drive_scaled_t a)
{
    const int32_t shift = -1 - a.exponent;
    if (shift > 63) {
        return 0;
    }
    return a.significand >> shift;
}

/* The upper half of the product, at most 2 too small. */
static uint64_t two_mass_drive_mul_high(uint64_t a, uint64_t b)
{
    const uint64_t a_high = a >> 32;
    const uint64_t a_low = a & 0xFFFFFFFFu;
    const uint64_t b_high = b >> 32;
    const uint64_t b_low = b & 0xFFFFFFFFu;
    const uint64_t cross = ((a_high * b_low) >> 32) + ((a_low * b_high) >> 32);
    return a_high * b_high + cross;
}

/* The square of a number below 1 as fixed point with 64 fraction bits. */
static uint64_t two_mass_drive_squared_fraction(two_mass_drive_scaled_t a)
{
    const uint64_t x = two_mass_drive_fraction(a);
    return two_mass_drive_mul_high(x, x);
}

/* Makes a number of a significand that has its top bit set. */
static two_mass_drive_scaled_t two_mass_drive_scaled(uint64_t significand, int32_t exponent)
{
    two_mass_drive_scaled_t result;
    result.significand = significand;
    result.exponent = exponent;
    return result;
}

/* Makes a number of a significand of at least 2^62. */
static two_mass_drive_scaled_t two_mass_drive_settled(uint64_t significand, int32_t exponent)
{
    if ((significand >> 63) == 0) {
        return two_mass_drive_scaled(significand << 1, exponent - 1);
    }
    return two_mass_drive_scaled(significand, exponent);
}

/* (1 - cos(r)) / r^2 in powers of -r^2. */
static const uint64_t TWO_MASS_DRIVE_COSINE[8] = {
    UINT64_C(0x8000000000000000), UINT64_C(0x0AAAAAAAAAAAAAA8), UINT64_C(0x005B05B05B05B02B),
    UINT64_C(0x0001A01A01A01865), UINT64_C(0x0000049F93EDD666), UINT64_C(0x00000008F76C6243),
    UINT64_C(0x000000000C9C9706), UINT64_C(0x00000000000D551B)};

/* cos(r) for 0 < r <= pi/4, relative error below 2^-60. */
static two_mass_drive_scaled_t two_mass_drive_cosine(two_mass_drive_scaled_t r)
{
    const uint64_t z = two_mass_drive_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = TWO_MASS_DRIVE_COSINE[6] - ((TWO_MASS_DRIVE_COSINE[7] * z_high) >> 32);
    const uint64_t c5 = TWO_MASS_DRIVE_COSINE[5] - ((tail * z_high) >> 32);
    const uint64_t c4 = TWO_MASS_DRIVE_COSINE[4] - two_mass_drive_mul_high(c5, z);
    const uint64_t c3 = TWO_MASS_DRIVE_COSINE[3] - two_mass_drive_mul_high(c4, z);
    const uint64_t c2 = TWO_MASS_DRIVE_COSINE[2] - two_mass_drive_mul_high(c3, z);
    const uint64_t c1 = TWO_MASS_DRIVE_COSINE[1] - two_mass_drive_mul_high(c2, z);
    const uint64_t c0 = TWO_MASS_DRIVE_COSINE[0] - two_mass_drive_mul_high(c1, z);
    return two_mass_drive_settled((UINT64_C(1) << 63) - (two_mass_drive_mul_high(c0, z) >> 1), 0);
}

/* (1 - sin(r) / r) / r^2 in powers of -r^2. */
static const uint64_t TWO_MASS_DRIVE_SINE[7] = {
    UINT64_C(0x2AAAAAAAAAAAAAA6), UINT64_C(0x0222222222222160), UINT64_C(0x000D00D00D00C575),
    UINT64_C(0x00002E3BC74A673D), UINT64_C(0x0000006B9914A637), UINT64_C(0x00000000B090498C),
    UINT64_C(0x0000000000D552BC)};

/* sin(r) for 0 < r <= pi/4, relative error below 2^-60. */
static two_mass_drive_scaled_t two_mass_drive_sine(two_mass_drive_scaled_t r)
{
    const uint64_t z = two_mass_drive_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = TWO_MASS_DRIVE_SINE[5] - ((TWO_MASS_DRIVE_SINE[6] * z_high) >> 32);
    const uint64_t c4 = TWO_MASS_DRIVE_SINE[4] - ((tail * z_high) >> 32);
    const uint64_t c3 = TWO_MASS_DRIVE_SINE[3] - two_mass_drive_mul_high(c4, z);
    const uint64_t c2 = TWO_MASS_DRIVE_SINE[2] - two_mass_drive_mul_high(c3, z);
    const uint64_t c1 = TWO_MASS_DRIVE_SINE[1] - two_mass_drive_mul_high(c2, z);
    const uint64_t c0 = TWO_MASS_DRIVE_SINE[0] - two_mass_drive_mul_high(c1, z);
    const uint64_t lost = two_mass_drive_mul_high(r.significand, two_mass_drive_mul_high(c0, z));
    return two_mass_drive_settled(r.significand - lost, r.exponent);
}

/* The sine of an angle. */
static two_mass_drive_signed_t two_mass_drive_sine_at(two_mass_drive_turned_t angle)
{
    const int back = (angle.quadrant & 2) != 0;
    if ((angle.quadrant & 1) != 0) {
        return two_mass_drive_signed(two_mass_drive_cosine(angle.rest.magnitude), back);
    }
    return two_mass_drive_signed(two_mass_drive_sine(angle.rest.magnitude), back != angle.rest.negative);
}

/* Makes an angle of its parts. */
static two_mass_drive_turned_t two_mass_drive_turned(two_mass_drive_signed_t rest, uint32_t quadrant)
{
    two_mass_drive_turned_t result;
    result.rest = rest;
    result.quadrant = quadrant;
    return result;
}

/* The number of zero bits above the highest one bit; x is not 0. */
static int32_t two_mass_drive_leading_zeros(uint64_t x)
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
static two_mass_drive_scaled_t two_mass_drive_normalised(uint64_t significand, int32_t exponent)
{
    const int32_t shift = two_mass_drive_leading_zeros(significand);
    return two_mass_drive_scaled(significand << shift, exponent - shift);
}

/* a b, relative error below 2^-60. */
static two_mass_drive_scaled_t two_mass_drive_product(two_mass_drive_scaled_t a, two_mass_drive_scaled_t b)
{
    return two_mass_drive_settled(two_mass_drive_mul_high(a.significand, b.significand),
                            a.exponent + b.exponent + 1);
}

/* pi with 62 fraction bits; as a significand also pi/2 and pi/4. */
#define TWO_MASS_DRIVE_PI UINT64_C(0xC90FDAA22168C235)

/* The angle of (high, low) / 2^126 quarter turns, its rest exact to 2^-60 of itself. */
static two_mass_drive_turned_t two_mass_drive_turned_from_quarters(uint64_t high, uint64_t low)
{
    const uint64_t eighths = high >> 61;
    const int negative = (eighths & 1) != 0;
    uint64_t upper = (high << 2) | (low >> 62);
    uint64_t lower = low << 2;
    if (negative) {
        upper = (lower == 0) ? (UINT64_C(0) - upper) : UINT64_MAX - upper;
        lower = (UINT64_C(0) - lower);
    }
    const int32_t shift = two_mass_drive_leading_zeros(upper | 1);
    const uint64_t significand = (upper << shift) | ((lower >> 1) >> (63 - shift));
    const two_mass_drive_signed_t rest = two_mass_drive_signed(
        two_mass_drive_product(two_mass_drive_scaled(significand, -1 - shift), two_mass_drive_scaled(TWO_MASS_DRIVE_PI, 0)),
        negative);
    return two_mass_drive_turned(rest, (uint32_t)(((eighths + 1) >> 1) & 3));
}

/* The bits of a number. */
typedef union {
    double value;
    uint64_t bits;
} two_mass_drive_f64_cell_t;

/* The bits of a number. */
static uint64_t two_mass_drive_f64_to_bits(double x)
{
    two_mass_drive_f64_cell_t cell;
    cell.value = x;
    return cell.bits;
}

/* The bit of the sign. */
#define TWO_MASS_DRIVE_SIGN_F64 UINT64_C(0x8000000000000000)

/* The bits of the largest magnitude. */
#define TWO_MASS_DRIVE_MAGNITUDE_F64 UINT64_C(0x7FFFFFFFFFFFFFFF)

/* The bits of infinity. */
#define TWO_MASS_DRIVE_INFINITY_F64 UINT64_C(0x7FF0000000000000)

/* The bits of the only NaN that is returned. */
#define TWO_MASS_DRIVE_NAN_F64 UINT64_C(0x7FF8000000000000)

/* The number with these bits. */
static double two_mass_drive_f64_from_bits(uint64_t bits)
{
    two_mass_drive_f64_cell_t cell;
    cell.bits = bits;
    return cell.value;
}

/* The finite positive number with these bits, not 0; exact. */
static two_mass_drive_scaled_t two_mass_drive_unpacked_f64(uint64_t magnitude)
{
    const int32_t field = (int32_t)(magnitude >> 52);
    const uint64_t digits = magnitude << 11;
    if (field == 0) {
        return two_mass_drive_normalised(digits, -1022);
    }
    return two_mass_drive_scaled(digits | (UINT64_C(1) << 63), field - 1023);
}

/* 2/pi after 64 zero bits. */
static const uint32_t TWO_MASS_DRIVE_TWO_OVER_PI_F64[40] = {
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
static uint64_t two_mass_drive_window_f64(uint32_t slot, uint32_t shift)
{
    const uint64_t first = (uint64_t)(TWO_MASS_DRIVE_TWO_OVER_PI_F64[slot]);
    const uint64_t second = (uint64_t)(TWO_MASS_DRIVE_TWO_OVER_PI_F64[slot + 1]);
    return (((first << 32) | second) >> (32 - shift)) & 0xFFFFFFFFu;
}

/* A 128-bit unsigned integer. */
typedef struct {
    uint64_t high;
    uint64_t low;
} two_mass_drive_pair_t;

/* Makes a 128-bit integer of its halves. */
static two_mass_drive_pair_t two_mass_drive_pair(uint64_t high, uint64_t low)
{
    two_mass_drive_pair_t result;
    result.high = high;
    result.low = low;
    return result;
}

/* The exact 128-bit product. */
static two_mass_drive_pair_t two_mass_drive_mul_full(uint64_t a, uint64_t b)
{
    const uint64_t a_high = a >> 32;
    const uint64_t a_low = a & 0xFFFFFFFFu;
    const uint64_t b_high = b >> 32;
    const uint64_t b_low = b & 0xFFFFFFFFu;
    const uint64_t lowest = a_low * b_low;
    const uint64_t first = a_high * b_low + (lowest >> 32);
    const uint64_t second = a_low * b_high + (first & 0xFFFFFFFFu);
    const uint64_t high = a_high * b_high + (first >> 32) + (second >> 32);
    return two_mass_drive_pair(high, (second << 32) | (lowest & 0xFFFFFFFFu));
}

/* The angle with these bits, positive and finite, its rest exact to 2^-60 of itself. */
static two_mass_drive_turned_t two_mass_drive_reduce_f64(uint64_t magnitude)
{
    if (magnitude <= UINT64_C(0x3FE921FB54442D18)) {
        return two_mass_drive_turned(two_mass_drive_signed(two_mass_drive_unpacked_f64(magnitude), 0), 0);
    }
    const uint64_t digits = (magnitude & UINT64_C(0x000FFFFFFFFFFFFF)) | (UINT64_C(1) << 52);
    const uint32_t start = ((uint32_t)(magnitude >> 52)) - 1013;
    const uint32_t slot = start >> 5;
    const uint32_t shift = start & 31;
    const uint64_t upper =
        (two_mass_drive_window_f64(slot, shift) << 32) | two_mass_drive_window_f64(slot + 1, shift);
    const uint64_t middle =
        (two_mass_drive_window_f64(slot + 2, shift) << 32) | two_mass_drive_window_f64(slot + 3, shift);
    const uint64_t lower =
        (two_mass_drive_window_f64(slot + 4, shift) << 32) | two_mass_drive_window_f64(slot + 5, shift);
    const two_mass_drive_pair_t center = two_mass_drive_mul_full(middle, digits);
    const uint64_t low = (center.low + (two_mass_drive_mul_high(lower, digits)));
    const uint64_t carry = (low < center.low) ? 1 : 0;
    const uint64_t high = ((upper * digits) + (center.high + carry));
    return two_mass_drive_turned_from_quarters(high, low);
}

/* x rounded to the nearest, ties to even, with subnormals and overflow, and the sign put in. */
static double two_mass_drive_rounded_f64(uint64_t sign, two_mass_drive_scaled_t x)
{
    const int32_t field = x.exponent + 1023;
    if (field >= 2047) {
        return two_mass_drive_f64_from_bits(sign | TWO_MASS_DRIVE_INFINITY_F64);
    }
    const int32_t shift = (field > 0) ? 11 : 12 - field;
    if (shift > 63) {
        const int least = shift == 64 && x.significand > (UINT64_C(1) << 63);
        return two_mass_drive_f64_from_bits(least ? sign + 1 : sign);
    }
    const uint64_t kept = x.significand >> shift;
    const uint64_t rest = x.significand - (kept << shift);
    const uint64_t half = UINT64_C(1) << (shift - 1);
    const uint64_t odd = kept & 1;
    const uint64_t up = (rest + odd > half) ? 1 : 0;
    const uint64_t base = (field > 0) ? ((uint64_t)(field - 1)) << 52 : 0;
    return two_mass_drive_f64_from_bits(sign | (base + (kept + up)));
}

/* The sign bit of a negative number, else 0. */
static uint64_t two_mass_drive_sign_f64(int negative)
{
    if (negative) {
        return TWO_MASS_DRIVE_SIGN_F64;
    }
    return 0;
}

/* Sine of an angle in radians, error below 0.51 ulp. */
static double two_mass_drive_sin_f64(double x)
{
    const uint64_t bits = two_mass_drive_f64_to_bits(x);
    const uint64_t magnitude = bits & TWO_MASS_DRIVE_MAGNITUDE_F64;
    if (magnitude >= TWO_MASS_DRIVE_INFINITY_F64) {
        return two_mass_drive_f64_from_bits(TWO_MASS_DRIVE_NAN_F64);
    }
    if (magnitude == 0) {
        return x;
    }
    const two_mass_drive_signed_t value = two_mass_drive_sine_at(two_mass_drive_reduce_f64(magnitude));
    return two_mass_drive_rounded_f64((bits & TWO_MASS_DRIVE_SIGN_F64) ^ two_mass_drive_sign_f64(value.negative),
                                value.magnitude);
}

/* What one part of a step hands to the next. */
typedef struct {
    double t12;
    uint32_t t13;
    double t22;
    double t37;
    double t49;
    uint32_t t74;
    double t82;
    double t83;
    double t84;
    double t85;
    double t86;
    double t87;
    double t88;
    double t89;
    double t90;
    double t91;
    double t92;
    double t93;
    double t94;
    double t95;
    double t150;
    double t197;
    double t198;
    double t199;
    double t200;
    two_mass_drive_status t207;
} two_mass_drive_work;

/* Part 1 of a step. */
static void two_mass_drive_part_1(two_mass_drive_state *state, const two_mass_drive_measurements *measurements, const two_mass_drive_inputs *inputs, two_mass_drive_work *work)
{
    /* samples: outside its range, infinite or NaN means missing */
    const uint32_t t0 = state->newest;
    const uint32_t t1 = (t0 < 40U) ? t0 : 40U;
    const uint32_t t2 = state->count;
    const int t4 = 40U < t2;
    const double t5 = measurements->motor_angle;
    const int t6 = (-628.3185307179587 <= t5) && (t5 <= 628.3185307179587);
    const double t7 = measurements->load_angle;
    const int t8 = (-628.3185307179587 <= t7) && (t7 <= 628.3185307179587);
    const double t9 = inputs->torque;
    const int t10 = (-1e304 <= t9) && (t9 <= 1e304);
    const double t11 = state->torque[t1];
    work->t12 = t10 ? t9 : t11;

    /* prediction, for a sample that is missing */
    work->t13 = (t1 < 40U) ? (t1 + 1U) : 0U;
    const double t14 = state->ahead_motor_angle;
    const double t15 = state->ahead_load_angle;
    const double t16 = state->motor_angle[t1];
    const double t17 = state->load_angle[t1];
    const int t18 = (-628.3185307179587 <= t15) && (t15 <= 628.3185307179587);
    const int t19 = t4 && t18;
    const double t20 = t19 ? t15 : t17;
    const double t21 = t8 ? t7 : t20;
    work->t22 = two_mass_drive_sin_f64(t21);
    const double t23 = work->t12 - t11;
    const double t25 = 4.154200521167732e-6 * t23;
    const double t26 = t14 + t25;
    const double t27 = state->sin_load_angle[t1];
    const double t28 = work->t22 - t27;
    const double t30 = -3.739843649680403e-9 * t28;
    const double t31 = t26 + t30;
    const int t32 = (-628.3185307179587 <= t31) && (t31 <= 628.3185307179587);
    const int t33 = t4 && t32;
    const double t34 = t33 ? t31 : t16;
    const int t35 = t6 || t33;
    const int t36 = !t35;
    work->t37 = t6 ? t5 : t34;
    const double t39 = 2.493229099786935e-9 * t23;
    const double t40 = t15 + t39;
    const double t42 = -1.249252031270064e-6 * t28;
    const double t43 = t40 + t42;
    const int t44 = (-628.3185307179587 <= t43) && (t43 <= 628.3185307179587);
    const int t45 = t4 && t44;
    const double t46 = t45 ? t43 : t17;
    const int t47 = t8 || t45;
    const int t48 = !t47;
    work->t49 = t8 ? t7 : t46;
    const uint32_t t50 = state->missed_motor_angle;
    const int t51 = 40U < t50;
    const int t52 = !t6;
    const int t53 = t52 && t51;
    const uint32_t t55 = (t50 < 41U) ? (t50 + 1U) : 41U;
    const uint32_t t56 = t6 ? 0U : t55;
    state->missed_motor_angle = t56;
    const uint32_t t57 = state->missed_load_angle;
    const int t58 = 40U < t57;
    const int t59 = !t8;
    const int t60 = t59 && t58;
    const uint32_t t61 = (t57 < 41U) ? (t57 + 1U) : 41U;
    const uint32_t t62 = t8 ? 0U : t61;
    state->missed_load_angle = t62;
    const int t63 = t53 || t60;
    const int t64 = t53 && t60;
    const int t65 = !t64;
    const int t66 = t63 && t65;
    const int t67 = t36 || t48;
    const int t68 = t67 || t66;
    const int t69 = t6 && t8;
    const int t70 = t69 && t10;

    /* how much of the window is good */
    const uint32_t t71 = (t2 < 41U) ? (t2 + 1U) : 41U;
    const uint32_t t72 = t68 ? 0U : t71;
    const uint32_t t73 = t70 ? t71 : 0U;
    work->t74 = t4 ? t72 : t73;
    state->count = work->t74;
    const uint32_t t75 = state->coasting;
    const uint32_t t76 = (t75 > 0U) ? (t75 - 1U) : 0U;
    const uint32_t t78 = t70 ? t76 : 41U;
    state->coasting = t78;
}

/* Part 2 of a step. */
static void two_mass_drive_part_2(two_mass_drive_state *state, const two_mass_drive_work *work)
{
    /* into the window */
    state->newest = work->t13;
    state->motor_angle[work->t13] = work->t37;
    state->load_angle[work->t13] = work->t49;
    state->torque[work->t13] = work->t12;
    state->sin_load_angle[work->t13] = work->t22;
}

/* Part 3 of a step. */
static void two_mass_drive_part_3(const two_mass_drive_state *state, two_mass_drive_work *work)
{
    /* the sums over the window, newest sample first */
    double t80 = 0.0;
    double t81 = 0.0;
    work->t82 = 0.0;
    work->t83 = 0.0;
    work->t84 = 0.0;
    work->t85 = 0.0;
    work->t86 = 0.0;
    work->t87 = 0.0;
    work->t88 = 0.0;
    work->t89 = 0.0;
    work->t90 = 0.0;
    work->t91 = 0.0;
    work->t92 = 0.0;
    work->t93 = 0.0;
    work->t94 = 0.0;
    work->t95 = 0.0;
    uint32_t t96 = work->t13;
    for (uint32_t row = 0U; row < 41U; ++row) {
        const double *const gains = TWO_MASS_DRIVE_WINDOW[row];
        const double t97 = state->motor_angle[t96];
        const double t98 = gains[0];
        const double t99 = t98 * t97;
        const double t100 = t80 + t99;
        const double t101 = gains[1];
        const double t102 = t101 * t97;
        const double t103 = work->t84 + t102;
        const double t104 = gains[2];
        const double t105 = t104 * t97;
        const double t106 = work->t88 + t105;
        const double t107 = gains[3];
        const double t108 = t107 * t97;
        const double t109 = work->t92 + t108;
        const double t110 = state->load_angle[t96];
        const double t111 = gains[4];
        const double t112 = t111 * t110;
        const double t113 = t81 + t112;
        const double t114 = gains[5];
        const double t115 = t114 * t110;
        const double t116 = work->t85 + t115;
        const double t117 = gains[6];
        const double t118 = t117 * t110;
        const double t119 = work->t89 + t118;
        const double t120 = gains[7];
        const double t121 = t120 * t110;
        const double t122 = work->t93 + t121;
        const double t123 = state->torque[t96];
        const double t124 = gains[8];
        const double t125 = t124 * t123;
        const double t126 = work->t82 + t125;
        const double t127 = gains[9];
        const double t128 = t127 * t123;
        const double t129 = work->t86 + t128;
        const double t130 = gains[10];
        const double t131 = t130 * t123;
        const double t132 = work->t90 + t131;
        const double t133 = gains[11];
        const double t134 = t133 * t123;
        const double t135 = work->t94 + t134;
        const double t136 = state->sin_load_angle[t96];
        const double t137 = gains[12];
        const double t138 = t137 * t136;
        const double t139 = work->t83 + t138;
        const double t140 = gains[13];
        const double t141 = t140 * t136;
        const double t142 = work->t87 + t141;
        const double t143 = gains[14];
        const double t144 = t143 * t136;
        const double t145 = work->t91 + t144;
        const double t146 = gains[15];
        const double t147 = t146 * t136;
        const double t148 = work->t95 + t147;
        const uint32_t t149 = ((t96 >= 1U) && (t96 < 41U)) ? (t96 - 1U) : 40U;
        t80 = t100;
        t81 = t113;
        work->t82 = t126;
        work->t83 = t139;
        work->t84 = t103;
        work->t85 = t116;
        work->t86 = t129;
        work->t87 = t142;
        work->t88 = t106;
        work->t89 = t119;
        work->t90 = t132;
        work->t91 = t145;
        work->t92 = t109;
        work->t93 = t122;
        work->t94 = t135;
        work->t95 = t148;
        t96 = t149;
    }
    work->t150 = t80 + t81;
}

/* Part 4 of a step. */
static void two_mass_drive_part_4(two_mass_drive_state *state, two_mass_drive_work *work)
{
    const double t151 = work->t150 + work->t82;
    const double t152 = t151 + work->t83;
    const double t153 = work->t84 + work->t85;
    const double t154 = t153 + work->t86;
    const double t155 = t154 + work->t87;
    const double t156 = work->t88 + work->t89;
    const double t157 = t156 + work->t90;
    const double t158 = t157 + work->t91;
    const double t159 = work->t92 + work->t93;
    const double t160 = t159 + work->t94;
    const double t161 = t160 + work->t95;

    /* the next measurement, as far as it is known */
    const double t163 = 0.9950249142262294 * t152;
    const double t165 = 0.004975085773770609 * t155;
    const double t167 = 0.0004966821156547011 * t158;
    const double t169 = 3.3178843452988937e-6 * t161;
    const double t171 = 1.2448095362022102e-5 * work->t12;
    const double t173 = -1.557139139336934e-8 * work->t22;
    const double t174 = t163 + t165;
    const double t175 = t174 + t167;
    const double t176 = t169 + t171;
    const double t177 = t176 + t173;
    const double t178 = t175 + t177;
    state->ahead_motor_angle = t178;
    const double t180 = 0.0009950171547541218 * t152;
    const double t182 = 0.9990049828452459 * t155;
    const double t184 = 6.635768690597788e-7 * t158;
    const double t186 = 0.0004993364231309402 * t161;
    const double t188 = 1.038092759557956e-8 * work->t12;
    const double t190 = -3.7468857217213263e-6 * work->t22;
    const double t191 = t180 + t182;
    const double t192 = t191 + t184;
    const double t193 = t186 + t188;
    const double t194 = t193 + t190;
    const double t195 = t192 + t194;
    state->ahead_load_angle = t195;

    /* the estimate; until the window is full, the start */
    const int t196 = 40U < work->t74;
    work->t197 = t196 ? t152 : work->t37;
    work->t198 = t196 ? t155 : work->t49;
    work->t199 = t196 ? t158 : 0.0;
    work->t200 = t196 ? t161 : 0.0;
    const uint32_t t201 = state->coasting;
    const int t202 = t201 == 0U;
    const two_mass_drive_status t206 = t202 ? TWO_MASS_DRIVE_CONVERGED : TWO_MASS_DRIVE_COASTING;
    work->t207 = t196 ? t206 : TWO_MASS_DRIVE_CONVERGING;
}

void two_mass_drive_init(two_mass_drive_state *state)
{
    for (uint32_t slot = 0U; slot < 41U; ++slot) {
        state->motor_angle[slot] = 0.0;
    }
    for (uint32_t slot = 0U; slot < 41U; ++slot) {
        state->load_angle[slot] = 0.0;
    }
    for (uint32_t slot = 0U; slot < 41U; ++slot) {
        state->torque[slot] = 0.0;
    }
    for (uint32_t slot = 0U; slot < 41U; ++slot) {
        state->sin_load_angle[slot] = 0.0;
    }
    state->newest = 40U;
    state->count = 0U;
    state->missed_motor_angle = 0U;
    state->missed_load_angle = 0U;
    state->coasting = 0U;
    state->ahead_motor_angle = 0.0;
    state->ahead_load_angle = 0.0;
}

void two_mass_drive_step(two_mass_drive_state *state, const two_mass_drive_measurements *measurements,
                         const two_mass_drive_inputs *inputs, two_mass_drive_estimate *estimate)
{
    two_mass_drive_work work;
    two_mass_drive_part_1(state, measurements, inputs, &work);
    two_mass_drive_part_2(state, &work);
    two_mass_drive_part_3(state, &work);
    two_mass_drive_part_4(state, &work);

    estimate->motor_angle = work.t197;
    estimate->load_angle = work.t198;
    estimate->motor_speed = work.t199;
    estimate->load_speed = work.t200;
    estimate->status = work.t207;
}
