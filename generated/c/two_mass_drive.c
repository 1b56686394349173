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
#pragma GCC optimize("fp-contract=off")
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
        0.07872406377772792, 0.040739383098486, 7.921341154036726, 1.8380694140884566,
        0.040739383098486, 0.06840055730576089, 9.62976622776305, 4.3106344301959965,
        3.8270634017784045e-6, -1.6691687565991186e-7, 0.024863259875280375, 1.3115398874010478e-5,
        4.744832912878872e-8, -1.1636501371926649e-6, -1.9083153188637953e-5, -0.007488379500532441
    },
    {
        0.07456272624575845, 0.03605432727255418, 6.211902512416829, 1.7045781600963026,
        0.039860481782432, 0.06621927463307296, 9.4829516701569, 4.084928738257156,
        2.2529661477865013e-5, -1.121425728296024e-6, 0.04899268611788545, 0.00010409738997764806,
        2.9790330496634633e-7, -6.890036163074922e-6, -0.00015094229154264912, -0.01491541862055163
    },
    {
        0.07001960265489794, 0.03164724617325003, 4.519618143990852, 1.595937568100651,
        0.0390579376781562, 0.06398239701505948, 9.332706257911967, 3.8542529139190167,
        4.3099762271875844e-5, -2.864228639336117e-6, 0.047429508217472514, 0.0002611961509293631,
        7.164013703337079e-7, -1.3335580417459541e-5, -0.0003728541121595671, -0.014779176557216748
    },
    {
        0.06512767748764166, 0.027543306537221972, 2.860192916159638, 1.5112211658676318,
        0.03832515388915955, 0.06168489110439079, 9.175889017548082, 3.6187922516283497,
        6.128996380754526e-5, -5.219888452803397e-6, 0.04530211093082398, 0.0004712011228298099,
        1.2386624091201567e-6, -1.924745627719672e-5, -0.0006601064564922988, -0.014586162277792337
    },
    {
        0.05992454004893351, 0.02376432296806009, 1.2491250015081967, 1.4492027654967736,
        0.03765461255445328, 0.059322393980348866, 9.009400314548241, 3.3787919889652507,
        7.706060401318251e-5, -8.02134735015809e-6, 0.042680747252915874, 0.0007319640042424283,
        1.810640071951513e-6, -2.462353542372116e-5, -0.0010052297463869146, -0.014339422826881193
    },
    {
        0.05445198672157167, 0.020328454379427784, -0.29848352886702717, 1.4083676332644985,
        0.03703795439747775, 0.05689127386020102, 8.830219734693157, 3.134555072674435,
        9.040418609289076e-5, -1.1110402489057505e-5, 0.03963901038210332, 0.001039955530195317,
        2.386074525640912e-6, -2.946239995061542e-5, -0.0013994625948981663, -0.014042283638681362
    },
    {
        0.04875556768163603, 0.01724994086199715, -1.7681136215312745, 1.3869272742397143,
        0.036466069383016976, 0.05438868272581285, 8.635443467295879, 2.886439201742121,
        0.00010134435108537809, -1.4339643722974156e-5, 0.03625262866590332, 0.0013903756902496932,
        2.9264345458443367e-6, -3.3763814989146436e-5, -0.001833022897044242, -0.013698324545183337
    },
    {
        0.04288408287015514, 0.014538884635639088, -3.146011382068536, 1.3828376970043392,
        0.035929197522865254, 0.05181260013321015, 8.422320733473201, 2.6348531744519255,
        0.00010993440758899779, -1.7574156719380486e-5, 0.0325982608333292, 0.0017772837829531044,
        3.400749231600821e-6, -3.75291544222247e-5, -0.0022953823279271935, -0.013311351472538948
    },
    {
        0.03688903268711267, 0.012201078260843086, -4.419363187314492, 1.3938209802150188,
        0.03541703873702585, 0.04916186757029505, 8.188288808592263, 2.380252575072519,
        0.00011625545200369029, -2.0692968959593372e-5, 0.02875230983101147, 0.0021937461488750346,
        3.7853363282552373e-6, -4.076177424282701e-5, -0.002775539843642402, -0.012885364363532636
    },
    {
        0.03082402948594019, 0.01023788275170206, -5.5764615717154085, 1.4173899207693035,
        0.034918870554812444, 0.04643621283424895, 7.931006199542319, 2.123134844224391,
        0.00012041411813589671, -2.3590220435342637e-5, 0.024789773003255015, 0.002631999167029508,
        4.063435522826744e-6, -4.346732912949104e-5, -0.003262289911408801, -0.01242452192153456
    },
    {
        0.02474417649277536, 0.008646157662872812, -6.6068597758093555, 1.450875503515965,
        0.03442367233099751, 0.0436362640141405, 7.648383554430979, 1.8640337849377882,
        0.00012253999985225566, -2.617604541468241e-5, 0.02078314552677187, 0.003083624878425294,
        4.2247562931576594e-6, -4.565402887991727e-5, -0.0037444813889041966, -0.011933103819184445
    },
    {
        0.018705421247598865, 0.007418244621123631, -7.501512956066699, 1.4914568952811598,
        0.033920254557584906, 0.04076355278461603, 7.3386119045523195, 1.6035135638474785,
        0.0001227827945899047, -2.837715636394915e-5, 0.01680139294363726, 0.0035397364188243354,
        4.26495093380188e-6, -4.7332832446696915e-5, -0.004211263225031533, -0.011415471052660933
    },
    {
        0.012763891057314224, 0.006542005145280749, -8.252904192040006, 1.5361936319501088,
        0.03339739177319393, 0.03782050684191031, 7.000187865816852, 1.342162273776418,
        0.00012130921888423454, -3.0137125912259727e-5, 0.012909007348823717, 0.003991170303047766,
        4.185024235044117e-6, -4.8517578439080756e-5, -0.004652313460604624, -0.010876025149201734
    },
    {
        0.006975218258196233, 0.006000912953841941, -8.855153587617961, 1.5820596368961655,
        0.03284395751056963, 0.034810431442323764, 6.631935459002315, 1.080585130049936,
        0.000118299749619193, -3.1416367558950424e-5, 0.009165160302221392, 0.004428682507267044,
        3.990691947094919e-6, -4.92250520737903e-5, -0.0050580483623206265, -0.010319166951182556
    },
    {
        0.0013938633021681873, 0.005774200304797873, -9.304108946505133, 1.6259786825960347,
        0.03224905967932734, 0.03173748013425828, 6.233024244849621, 0.8193973781726915,
        0.0001139452464128346, -3.219182058105047e-5, 0.005622963872755108, 0.004843145244956238,
        3.6917006128594965e-6, -4.947498965860901e-5, -0.005419808920823744, -0.009749255704329551
    },
    {
        -0.003927556195634113, 0.005837057255062959, -9.59741670592, 1.6648608851787747,
        0.0316021747564399, 0.028606614906330954, 5.802983510802465, 0.5592169949188728,
        0.0001084435114061121, -3.2456349227292574e-5, 0.0023288494097768097, 0.005225741327224277,
        3.301121596334283e-6, -4.929002275777811e-5, -0.00573002237704341, -0.009170569170490247
    },
    {
        -0.008938922284210268, 0.006160882075263699, -9.734572034706588, 1.695639804246112,
        0.03089327915170723, 0.025423556104416503, 5.341712290629654, 0.30065726836813467,
        0.00010199584272260402, -3.221787071946737e-5, -0.0006779282979994112, 0.005568153039111546,
        2.834632169388666e-6, -4.869556520164662e-5, -0.005982336903235206, -0.008587265466947956
    },
    {
        -0.01359325128694968, 0.006713580417388929, -9.716947240132223, 1.7153097078390336,
        0.03011297612980721, 0.022194722598117153, 4.849485045784652, 0.04431934491227971,
        9.480363701997298e-5, -3.149823075650931e-5, -0.003365655843948832, 0.005862742549496677,
        2.3097963502982246e-6, -4.771964704910575e-5, -0.006171728048836178, -0.008003347304827175
    },
    {
        -0.017847298273041066, 0.007459910215832526, -9.547797878915295, 1.7209625551205983,
        0.029252616704577586, 0.01892716280055413, 4.326952887611138, -0.20921516728130393,
        8.706509488154492e-5, -3.0331849071040725e-5, -0.005710391464466959, 0.006102721002253997,
        1.745357818806755e-6, -4.639270047573911e-5, -0.006294576058698725, -0.0074226292591554124
    },
    {
        -0.02166212373613325, 0.008361868714352334, -9.23224622962173, 1.7098242473478162,
        0.028304412974748124, 0.015628477262975865, 3.7751402718222966, -0.4593914484640182,
        7.897208033129308e-5, -2.876416106662824e-5, -0.007696059321595309, 0.006282303608348249,
        1.1605566735276785e-6, -4.474730333036633e-5, -0.006348713674691045, -0.006848708653228831
    },
    {
        -0.025003615189732046, 0.009379117459870724, -8.777242052456609, 1.6792897011044174,
        0.02726154244301998, 0.012306733675997885, 3.1954371504591434, -0.7056884819526091,
        7.070718254167226e-5, -2.6849884616864085e-5, -0.009314408513378211, 0.0063968482701775116,
        5.744810597370122e-7, -4.281788676631108e-5, -0.006333444533235354, -0.006284940580828588
    },
    {
        -0.02784295684451913, 0.010469440595944115, -8.191500835503424, 1.6269563065855546,
        0.026118241951529498, 0.008970375210908902, 2.589586621138378, -0.9476257457861073,
        6.244102389562289e-5, -2.4651143691124806e-5, -0.010564839611430801, 0.006442975517645794,
        5.463793216250478e-9, -4.064041390155372e-5, -0.006249532763385762, -0.0057344175224412755
    },
    {
        -0.030157041076410353, 0.011589231330783958, -7.485420000384901, 1.550655347923992,
        0.02486988997545984, 0.00562812322606663, 1.9596681681845447, -1.1847694967910654,
        5.432985402573433e-5, -2.2235482550028937e-5, -0.011454103557814491, 0.006418667816615811,
        -5.294669447307941e-7, -3.8252036886039225e-5, -0.006099164865025074, -0.00519995393696159
    },
    {
        -0.031928816020238615, 0.012694001053048453, -6.670973811843418, 1.4484809820188729,
        0.02351307614177759, 0.002288875443739428, 1.3080766445461194, -1.4167385663473122,
        4.6513464357777165e-5, -1.9673805797262547e-5, -0.011995879695699822, 0.006323346620544685,
        -1.0150749460674846e-6, -3.569074004885977e-5, -0.005885885397502956, -0.004684076129517994
    },
    {
        -0.0331475643258946, 0.013738905228766257, -5.761588001562344, 1.3188163969015039,
        0.022045656980460886, -0.001038399229278436, 0.6374971965597759, -1.6432095920611092,
        3.911345211293239e-5, -1.703828056250425e-5, -0.012210241532499716, 0.006157925870813534,
        -1.4383347429207448e-6, -3.299497695890338e-5, -0.005614508428788198, -0.004189017610274081
    },
    {
        -0.033809108884037875, 0.014679279939545485, -4.771995373397209, 1.1603568001130338,
        0.02046679706964164, -0.004344768009308585, -0.049123615003379785, -1.863921615440686,
        3.223185675981633e-5, -1.4400237509766587e-5, -0.01212302051407327, 0.005924841005747721,
        -1.7887765735986301e-6, -3.020330925802196e-5, -0.005291007077725174, -0.0037167200696059345
    },
    {
        -0.0339159421586363, 0.015471182719763072, -3.7180739018516995, 0.9721289215800869,
        0.018776994902113427, -0.007621442403226405, -0.7486101952426104, -2.078679982471367,
        2.5950185645721093e-5, -1.1828107212021561e-5, -0.011765079600329053, 0.005628052907524312,
        -2.058753759894696e-6, -2.7354055016092118e-5, -0.004922383821636442, -0.003268840003281769
    },
    {
        -0.03347727664431429, 0.01607193122201678, -2.616669065020081, 0.7535067537013672,
        0.016978092976801123, -0.010859885941551451, -1.457593448539063, -2.287359491632894,
        2.0328839072066608e-5, -9.385427710319889e-6, -0.011171509754726283, 0.005273026594797833,
        -2.2436301896935376e-6, -2.4484954114879217e-5, -0.004516524533353065,
        -0.0028467609285545547
    },
    {
        -0.032509014887778895, 0.016440633188197364, -1.4854023643740442, 0.5042232933908238,
        0.015073271803046144, -0.014051920172661872, -2.1725490745983986, -2.489906742308056,
        1.5406938510025968e-5, -7.128957795886838e-6, -0.01038076357423426, 0.004866684851522535,
        -2.3418870972723606e-6, -2.163285779677949e-5, -0.004082039451590792, -0.0024516110398189045
    },
    {
        -0.03103363846382647, 0.016538701229651336, -0.3424681739313367, 0.22437809620020488,
        0.013067027695807759, -0.017189827618826967, -2.889838198617069, -2.686341645607203,
        1.1202555077791566e-5, -5.106928737151115e-6, -0.009433741176792498, 0.0044173373636191456,
        -2.355149824377391e-6, -1.8833449021697168e-5, -0.0036280944730460933,
        -0.0020842860620754406
    },
    {
        -0.029080016266499975, 0.016330346024682564, 0.7935787720408878, -0.0855594991411798,
        0.010965134433894559, -0.02026645041570752, -3.6057498737416425, -2.8767580692761965,
        7.713328919746104e-6, -3.357464848435867e-6, -0.008372844118027302, 0.003934586309344138,
        -2.2881367042125056e-6, -1.6120999668786228e-5, -0.0031642362811429483,
        -0.0017454769732621657
    },
    {
        -0.026683133453397293, 0.015783041724769485, 1.9040428028569534, -0.42475156692612415,
        0.008774589048826121, -0.023275283393599206, -4.316544965834984, -3.0613235984564784,
        4.917463836830444e-6, -1.9072004986321568e-6, -0.007241013519182995, 0.0034292097110714694,
        -2.1485336146374436e-6, -1.3528169909576383e-5, -0.0027002148933939814,
        -0.0014357021838837633
    },
    {
        -0.02388374335422411, 0.01486795762109147, 2.9703110839158335, -0.791997250350631,
        0.0065035422065435845, -0.026210560410737906, -5.018500907976889, -3.2402784045088477,
        2.7750755104114448e-6, -7.701179290136341e-7, -0.006080768748735932, 0.0029130242004504724,
        -1.946799073861597e-6, -1.1085854276742082e-5, -0.00224580721613628, -0.0011553436855658683
    },
    {
        -0.020727945611653396, 0.013560350458055155, 3.9740790916290973, -1.1857428627038393,
        0.00416121383558154, -0.029067332816004945, -5.707956795449671, -3.4139332247754766,
        1.2298660281807537e-6, 5.337336183526624e-8, -0.004933262909420626, 0.002398729170550809,
        -1.6959059807934645e-6, -8.823078071520374e-6, -0.0018106451421719101,
        -0.0009046866103719478
    },
    {
        -0.017266694751661257, 0.011839912187352013, 4.897575092048235, -1.6040963657092406,
        0.0017577948411352119, -0.03184153899973862, -6.381358281463626, -3.5826664669116672,
        2.1109224351090156e-7, 5.77098846885994e-7, -0.003837371042492707, 0.0018997345829388657,
        -1.4110272136601979e-6, -6.766946806830408e-6, -0.001404051614709704, -0.0006839615810384585
    },
    {
        -0.013555244270214241, 0.009691068430621352, 5.72378090390178, -2.044846103247417,
        -0.0006956640776020923, -0.03453006408626679, -7.035301729764464, -3.7469204621413024,
        -3.64209144252382e-7, 8.295102016536468e-7, -0.002828826377668617, 0.0014299749603100304,
        -1.1091732771624508e-6, -4.942650387804292e-6, -0.0010348879119878279,
        -0.0004933891796892265
    },
    {
        -0.009652532162280522, 0.007103223456133046, 6.436646238735447, -2.505483615899649,
        -0.003187375321636737, -0.03713078892924344, -7.666577082661327, -3.9071969023481268,
        -5.887809434236472e-7, 8.537973384471129e-7, -0.0019394191395187043, 0.0010037123224165697,
        -8.087910150692344e-7, -3.37352270280553e-6, -0.000711415183939195, -0.0003332258199349114
    },
    {
        -0.0056205145968959876, 0.0040709480693187595, 7.0212939556266445, -2.983230310428801,
        -0.005704947657161545, -0.03964262768975488, -8.272208911969695, -4.064051506179567,
        -5.625337936884115e-7, 7.077175970125617e-7, -0.0011962713817306795, 0.0006353310111538515,
        -5.293330689759961e-7, -2.081156252735827e-6, -0.00044117299894651495,
        -0.00020381027526010878
    },
    {
        -0.0015234551483156481, 0.0005941074619896917, 7.464213645374194, -3.4750677090955455,
        -0.008235528369325514, -0.04206555340616337, -8.849495135849333, -4.218087969183489,
        -3.898106666753581e-7, 4.631430675043464e-7, -0.0006212000753848555, 0.00033912749690408867,
        -2.9080825472164826e-7, -1.0855704014620087e-6, -0.00023087733958621174,
        -0.00010561009581011996
    },
    {
        0.0025728223812596838, -0.003322073246485071, 7.753441068605107, -3.977770957213288,
        -0.01076595269768848, -0.044400611102342724, -9.396042906425645, -4.369951262297211,
        -1.765766710820106e-7, 2.053316458091532e-7, -0.0002301792449429314, 0.00012909836026695965,
        -1.1332333819452586e-7, -4.0543080252673236e-7, -8.634012644215867e-5,
        -3.9267136512884745e-5
    },
    {
        0.006601708975791107, -0.007667007318681383, 7.878721112959512, -4.487945224167661,
        -0.013282898839042667, -0.04664991812577776, -9.909801201226655, -4.5203203516436075,
        -2.7584433243220458e-8, 3.1931976933927665e-8, -3.2910347503740933e-5, 1.872969942008092e-5,
        -1.6626817302030586e-8, -5.831656372539563e-8, -1.2411954361456208e-5, -5.641422143739809e-6
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

/* Bits of the sign, of the largest magnitude, of infinity, of the only NaN returned, of 1. */
#define TWO_MASS_DRIVE_SIGN_F64 UINT64_C(0x8000000000000000)
#define TWO_MASS_DRIVE_MAGNITUDE_F64 UINT64_C(0x7FFFFFFFFFFFFFFF)
#define TWO_MASS_DRIVE_INFINITY_F64 UINT64_C(0x7FF0000000000000)
#define TWO_MASS_DRIVE_NAN_F64 UINT64_C(0x7FF8000000000000)
#define TWO_MASS_DRIVE_ONE_F64 UINT64_C(0x3FF0000000000000)

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
    double t20;
    double t35;
    double t47;
    uint32_t t72;
    double t80;
    double t81;
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
    double t148;
    double t195;
    double t196;
    double t197;
    double t198;
    two_mass_drive_status t205;
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
    const double t18 = t4 ? t15 : t17;
    const double t19 = t8 ? t7 : t18;
    work->t20 = two_mass_drive_sin_f64(t19);
    const double t21 = work->t12 - t11;
    const double t23 = 4.154200521167732e-6 * t21;
    const double t24 = t14 + t23;
    const double t25 = state->sin_load_angle[t1];
    const double t26 = work->t20 - t25;
    const double t28 = -3.739843649680403e-9 * t26;
    const double t29 = t24 + t28;
    const int t30 = (-628.3185307179587 <= t29) && (t29 <= 628.3185307179587);
    const int t31 = t4 && t30;
    const double t32 = t31 ? t29 : t16;
    const int t33 = t6 || t31;
    const int t34 = !t33;
    work->t35 = t6 ? t5 : t32;
    const double t37 = 2.493229099786935e-9 * t21;
    const double t38 = t15 + t37;
    const double t40 = -1.249252031270064e-6 * t26;
    const double t41 = t38 + t40;
    const int t42 = (-628.3185307179587 <= t41) && (t41 <= 628.3185307179587);
    const int t43 = t4 && t42;
    const double t44 = t43 ? t41 : t17;
    const int t45 = t8 || t43;
    const int t46 = !t45;
    work->t47 = t8 ? t7 : t44;
    const uint32_t t48 = state->missed_motor_angle;
    const int t49 = 40U < t48;
    const int t50 = !t6;
    const int t51 = t50 && t49;
    const uint32_t t53 = (t48 < 41U) ? (t48 + 1U) : 41U;
    const uint32_t t54 = t6 ? 0U : t53;
    state->missed_motor_angle = t54;
    const uint32_t t55 = state->missed_load_angle;
    const int t56 = 40U < t55;
    const int t57 = !t8;
    const int t58 = t57 && t56;
    const uint32_t t59 = (t55 < 41U) ? (t55 + 1U) : 41U;
    const uint32_t t60 = t8 ? 0U : t59;
    state->missed_load_angle = t60;
    const int t61 = t51 || t58;
    const int t62 = t51 && t58;
    const int t63 = !t62;
    const int t64 = t61 && t63;
    const int t65 = t6 && t8;
    const int t66 = t65 && t10;
    const int t67 = t34 || t46;
    const int t68 = t67 || t64;

    /* how much of the window is good */
    const uint32_t t69 = (t2 < 41U) ? (t2 + 1U) : 41U;
    const uint32_t t70 = t68 ? 0U : t69;
    const uint32_t t71 = t66 ? t69 : 0U;
    work->t72 = t4 ? t70 : t71;
    state->count = work->t72;
    const uint32_t t73 = state->coasting;
    const uint32_t t74 = (t73 > 0U) ? (t73 - 1U) : 0U;
    const uint32_t t76 = t66 ? t74 : 41U;
    state->coasting = t76;

    /* into the window */
    state->newest = work->t13;
    state->motor_angle[work->t13] = work->t35;
    state->load_angle[work->t13] = work->t47;
    state->torque[work->t13] = work->t12;
    state->sin_load_angle[work->t13] = work->t20;
}

/* Part 2 of a step. */
static void two_mass_drive_part_2(const two_mass_drive_state *state, two_mass_drive_work *work)
{
    /* the sums over the window, newest sample first */
    double t78 = 0.0;
    double t79 = 0.0;
    work->t80 = 0.0;
    work->t81 = 0.0;
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
    uint32_t t94 = work->t13;
    for (uint32_t row = 0U; row < 41U; ++row) {
        const double *const gains = TWO_MASS_DRIVE_WINDOW[row];
        const double t95 = state->motor_angle[t94];
        const double t96 = gains[0];
        const double t97 = t96 * t95;
        const double t98 = t78 + t97;
        const double t99 = gains[1];
        const double t100 = t99 * t95;
        const double t101 = work->t82 + t100;
        const double t102 = gains[2];
        const double t103 = t102 * t95;
        const double t104 = work->t86 + t103;
        const double t105 = gains[3];
        const double t106 = t105 * t95;
        const double t107 = work->t90 + t106;
        const double t108 = state->load_angle[t94];
        const double t109 = gains[4];
        const double t110 = t109 * t108;
        const double t111 = t79 + t110;
        const double t112 = gains[5];
        const double t113 = t112 * t108;
        const double t114 = work->t83 + t113;
        const double t115 = gains[6];
        const double t116 = t115 * t108;
        const double t117 = work->t87 + t116;
        const double t118 = gains[7];
        const double t119 = t118 * t108;
        const double t120 = work->t91 + t119;
        const double t121 = state->torque[t94];
        const double t122 = gains[8];
        const double t123 = t122 * t121;
        const double t124 = work->t80 + t123;
        const double t125 = gains[9];
        const double t126 = t125 * t121;
        const double t127 = work->t84 + t126;
        const double t128 = gains[10];
        const double t129 = t128 * t121;
        const double t130 = work->t88 + t129;
        const double t131 = gains[11];
        const double t132 = t131 * t121;
        const double t133 = work->t92 + t132;
        const double t134 = state->sin_load_angle[t94];
        const double t135 = gains[12];
        const double t136 = t135 * t134;
        const double t137 = work->t81 + t136;
        const double t138 = gains[13];
        const double t139 = t138 * t134;
        const double t140 = work->t85 + t139;
        const double t141 = gains[14];
        const double t142 = t141 * t134;
        const double t143 = work->t89 + t142;
        const double t144 = gains[15];
        const double t145 = t144 * t134;
        const double t146 = work->t93 + t145;
        const uint32_t t147 = ((t94 >= 1U) && (t94 < 41U)) ? (t94 - 1U) : 40U;
        t78 = t98;
        t79 = t111;
        work->t80 = t124;
        work->t81 = t137;
        work->t82 = t101;
        work->t83 = t114;
        work->t84 = t127;
        work->t85 = t140;
        work->t86 = t104;
        work->t87 = t117;
        work->t88 = t130;
        work->t89 = t143;
        work->t90 = t107;
        work->t91 = t120;
        work->t92 = t133;
        work->t93 = t146;
        t94 = t147;
    }
    work->t148 = t78 + t79;
}

/* Part 3 of a step. */
static void two_mass_drive_part_3(two_mass_drive_state *state, two_mass_drive_work *work)
{
    const double t149 = work->t148 + work->t80;
    const double t150 = t149 + work->t81;
    const double t151 = work->t82 + work->t83;
    const double t152 = t151 + work->t84;
    const double t153 = t152 + work->t85;
    const double t154 = work->t86 + work->t87;
    const double t155 = t154 + work->t88;
    const double t156 = t155 + work->t89;
    const double t157 = work->t90 + work->t91;
    const double t158 = t157 + work->t92;
    const double t159 = t158 + work->t93;

    /* the next measurement, as far as it is known */
    const double t161 = 0.9950249142262294 * t150;
    const double t163 = 0.004975085773770609 * t153;
    const double t165 = 0.0004966821156547011 * t156;
    const double t167 = 3.3178843452988937e-6 * t159;
    const double t169 = 1.2448095362022102e-5 * work->t12;
    const double t171 = -1.557139139336934e-8 * work->t20;
    const double t172 = t161 + t163;
    const double t173 = t172 + t165;
    const double t174 = t167 + t169;
    const double t175 = t174 + t171;
    const double t176 = t173 + t175;
    state->ahead_motor_angle = t176;
    const double t178 = 0.0009950171547541218 * t150;
    const double t180 = 0.9990049828452459 * t153;
    const double t182 = 6.635768690597788e-7 * t156;
    const double t184 = 0.0004993364231309402 * t159;
    const double t186 = 1.038092759557956e-8 * work->t12;
    const double t188 = -3.7468857217213263e-6 * work->t20;
    const double t189 = t178 + t180;
    const double t190 = t189 + t182;
    const double t191 = t184 + t186;
    const double t192 = t191 + t188;
    const double t193 = t190 + t192;
    state->ahead_load_angle = t193;

    /* the estimate; until the window is full, the start */
    const int t194 = 40U < work->t72;
    work->t195 = t194 ? t150 : work->t35;
    work->t196 = t194 ? t153 : work->t47;
    work->t197 = t194 ? t156 : 0.0;
    work->t198 = t194 ? t159 : 0.0;
    const uint32_t t199 = state->coasting;
    const int t200 = t199 == 0U;
    const two_mass_drive_status t204 = t200 ? TWO_MASS_DRIVE_CONVERGED : TWO_MASS_DRIVE_COASTING;
    work->t205 = t194 ? t204 : TWO_MASS_DRIVE_CONVERGING;
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

    estimate->motor_angle = work.t195;
    estimate->load_angle = work.t196;
    estimate->motor_speed = work.t197;
    estimate->load_speed = work.t198;
    estimate->status = work.t205;
}
