//! Claim: no observer is refused for being slow. The number of calls until it has converged is the smallest that keeps
//! what is promised, its gains are the sums over its whole past, however long that is, and where outputs come at rates of
//! their own or a countdown goes round nothing is added to them for want of patience.
//!
//! The right values were computed without the crate: gains of a Riccati equation and powers of error maps with 50 digits
//! (mpmath), sums over millions of calls from the eigenvalues of the map of a turn, and of random entries call by call
//! (numpy).

use crate::support::plant;

use deadbeat_codegen::Generated;
use plant::designed;

const SLOW: &str = "deadbeat = 1
name = \"slow\"
[states]
q = { derivative = 'w' }
w = { derivative = '0' }
[outputs]
q = { value = 'q' }
[observer.luenberger]
poles = [-0.02, -0.06]
[target]
sample_time = 1e-3
";

/// A barometer at 50 Hz, an accelerometer with a bias at 400 Hz.
const ALTITUDE: &str = "deadbeat = 1
name = \"altitude\"
[states]
z = { derivative = 'vz' }
vz = { derivative = 'acc - bias' }
bias = { derivative = '0' }
[inputs]
acc = {}
[outputs]
baro = { value = 'z', noise = 0.1, every = 8 }
[observer.kalman]
process_noise = [0, 1e-6, 1e-10]
[target]
sample_time = 2.5e-3
";

/// A receiver at 5 Hz, an accelerometer with a bias at 1 kHz.
const RECEIVER: &str = "deadbeat = 1
name = \"receiver\"
[states]
p = { derivative = 'v' }
v = { derivative = 'acc + b' }
b = { derivative = '0' }
[inputs]
acc = {}
[outputs]
gnss = { value = 'p', noise = 1.5, every = 200 }
[observer.kalman]
process_noise = [0, 1e-4, 1e-8]
[target]
sample_time = 1e-3
";

/// One output at every third call.
const RARE: &str = "deadbeat = 1
name = \"rare\"
[states]
x1 = { derivative = 'x2' }
x2 = { derivative = 'w1' }
[outputs]
y1 = { value = 'x1', noise = 1e-3, every = 3 }
[disturbances]
w1 = { bound = 0.02 }
[observer.kalman]
process_noise = [0, 1e-6]
[target]
sample_time = 0.01
scalar = \"f64\"
";

/// Two outputs, one at every fourth call.
const MIXED: &str = "deadbeat = 1
name = \"mixed\"
[states]
x1 = { derivative = '-1.906*x1 + 0.688*x2 - 1.371*x3 + 1.848*x4 - 0.991*u1 + w1' }
x2 = { derivative = '-0.421*x1 + 0.877*x2 + 1.320*x3 - 1.223*x4 + 0.128*u1' }
x3 = { derivative = '-1.894*x1 - 0.070*x2 - 1.787*x3 - 0.488*x4 + 0.567*u1 + 0.3*w1' }
x4 = { derivative = '0.062*x1 + 1.144*x2 + 0.566*x3 - 0.300*x4 + 0.857*u1' }
[inputs]
u1 = {}
[outputs]
y1 = { value = '0.218*x1 - 0.988*x2 - 0.016*x3 - 0.217*x4', noise = 1e-3 }
y2 = { value = '-0.954*x1 - 0.126*x2 + 0.981*x3 - 0.999*x4', noise = 4e-3, every = 4 }
[disturbances]
w1 = { bound = 0.02 }
[observer.kalman]
process_noise = [1e-3, 1e-3, 1e-3, 1e-3]
[target]
sample_time = 0.03
scalar = \"f64\"
";

/// A share by which a number printed may be above the exact one: four digits are printed, and an oscillation that is
/// hardly damped is bounded by its energy.
const ABOVE: f64 = 5e-5;

fn near(what: &str, found: f64, exact: f64) {
    assert!(found > exact * (1.0 - 1e-6) && found < exact * (1.0 + ABOVE), "{what}: {found:e}, exactly {exact:e}");
}

/// Worst-case and white gains from one output.
fn gains(generated: &Generated, output: usize, worst: &[f64], white: &[f64]) {
    let (name, certificate) = (&generated.plant.name, &generated.design.certificate);
    for (i, worst) in worst.iter().enumerate() {
        near(&format!("{name}, worst of state {i}"), certificate.noise_gain_l1[i][output], *worst);
    }
    for (i, white) in white.iter().enumerate() {
        near(&format!("{name}, white of state {i}"), certificate.noise_gain_l2[i][output], *white);
    }
}

/// The map of a call is known in closed form: `M^k = (z1^k (M - z2) - z2^k (M - z1)) / (z1 - z2)`.
#[test]
fn a_slow_filter_has_its_calls_and_its_sums() {
    let generated = designed(SLOW);
    let design = &generated.design;
    gains(&generated, 0, &[1.222_213_33, 0.023_094_01], &[6.891_980_85e-3, 9.486_832_98e-5]);
    let valid = design.valid_from_step;
    // 712,780 calls leave 9.6595857e-7 of a velocity, each by 2.0000e-5 less.
    let left = 9.659_585_7e-7 * (1.0 + 2e-5 * (712_780.0 - deadbeat_codegen::internals::numbers::count(valid)));
    assert!((design.certificate.initial_gain[1][1] - left).abs() < 1e-6 * left);
    let share = |calls: usize| size(calls, valid) / size(0, valid);
    assert!(share(valid) <= 1e-6 && share(valid - 1) > 1e-6, "{valid}: {:e}", share(valid));
}

/// The size of what so many calls leave of a velocity: the root mean square of what it does to the angle, looked at `over`
/// calls at two calls and then at every 256th part.
fn size(calls: usize, over: usize) -> f64 {
    let count = deadbeat_codegen::internals::numbers::count;
    let (h, slow, fast) = (1e-3, -0.02_f64, -0.06_f64);
    let time = count(calls) * h;
    // e_q' = e_w - 0.08 e_q, e_w' = -0.0012 e_q, sampled: the sampled gains are those of exactly these poles.
    let [z1, z2] = [slow * h, fast * h].map(f64::exp);
    // K of the current estimator with poles z1, z2: 1 - K_1 = z1 z2, and the trace gives K_2.
    let k1 = 1.0 - z1 * z2;
    let k2 = (1.0 - k1 + 1.0 - z1 - z2) / h;
    let (m_qw, m_ww) = ((1.0 - k1) * h, 1.0 - k2 * h);
    let [p1, p2] = [slow * time, fast * time].map(f64::exp);
    let (q, w) = (m_qw * (p1 - p2) / (z1 - z2), (p1 * (m_ww - z2) - p2 * (m_ww - z1)) / (z1 - z2));
    let stride = over.div_ceil(256).max(1);
    let looks = [0, 1].into_iter().chain((2..over).step_by(stride).enumerate().map(|(i, _)| 1 + (i + 1) * stride));
    let squares: Vec<f64> = looks.map(|look| (q + w * count(look) * h).powi(2)).collect();
    (squares.iter().sum::<f64>() / count(squares.len())).sqrt()
}

#[test]
fn filters_of_slow_biases_are_designed() {
    let altitude = designed(ALTITUDE);
    gains(&altitude, 0, &[1.445_873_45, 1.505_287_71, 0.015_042_21], &[0.183_779_21, 0.166_139_4, 0.001_646_36]);
    let receiver = designed(RECEIVER);
    gains(&receiver, 0, &[1.501_629_15, 0.877_821_83, 0.008_753_82], &[0.459_277_53, 0.231_903_17, 0.002_280_84]);
    for (generated, radius) in [(altitude, 0.999_800_019_999), (receiver, 0.998_001_998_682)] {
        let said = format!("{:?}", generated.design.convergence);
        let found = said.split("radius: ").nth(1).and_then(|rest| rest.split(',').next()).unwrap();
        assert!((found.parse::<f64>().unwrap() - radius).abs() < 2e-12, "{said}");
    }
}

#[test]
fn outputs_at_rates_of_their_own_have_exact_gains() {
    let rare = designed(RARE);
    assert_eq!(rare.design.valid_from_step, 198);
    gains(&rare, 0, &[1.471_670_36, 9.559_916_22], &[]);
    let mixed = designed(MIXED);
    gains(&mixed, 0, &[0.233_957_38, 1.085_195_16, 0.256_628_43, 0.524_067_98], &[]);
    gains(&mixed, 1, &[0.476_916_2, 0.183_138_11, 0.546_859_22, 1.001_202_05], &[]);
    // Disturbances within a sample: from above, by less than two parts in a thousand.
    let disturbed = |generated: &Generated, exact: &[f64]| {
        for (gains, exact) in generated.design.certificate.disturbance_gain_l1.iter().zip(exact) {
            assert!(gains[0] >= exact * (1.0 - 1e-4) && gains[0] < exact * 1.002, "{gains:?}, exactly {exact}");
        }
    };
    disturbed(&rare, &[0.011_815_18, 0.167_384_68]);
    disturbed(&mixed, &[0.266_011_72, 0.109_658_05, 0.124_477_58, 0.246_595_96]);
}

/// However long the rounds are: what noise at its bound does in the same round of more samples has a limit, from which it
/// is half as far with twice as many.
#[test]
fn a_countdown_that_goes_round_has_a_bound_at_any_length() {
    let bound = |time: f64| {
        let text = format!(
            "deadbeat = 1\nname = \"rounds\"\n[outputs]\ny = {{ noise = 1e-4 }}\n[observer.differentiator]\n\
             order = 3\ntime = {time}\nafter = \"restart\"\n[target]\nsample_time = 1e-3\n"
        );
        let generated = designed(&text);
        // Of the second derivative, in units of the noise over the squared time.
        generated.design.certificate.error_bound[2].expect("a bound") * time * time / 1e-4
    };
    let [short, middle, long] = [0.5, 1.0, 2.0].map(bound);
    let nearer = (long - middle) / (middle - short);
    assert!((nearer - 0.5).abs() < 0.05, "{short} in 500 calls, {middle} in 1000, {long} in 2000");
}
