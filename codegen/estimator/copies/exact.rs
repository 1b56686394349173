//! All numbers of the observer at one precision, in the coordinates (y, `x_r`).

use crate::diagnostic::Diagnostic;
use crate::expr::Constant;
use crate::plant::Plant;
use crate::real::{Matrix, NormTooLarge, Precision, Real, Singular, exponential, inverse};
use crate::sampled::Source;
use crate::sampled::coordinates::{Blocks, Coordinates};
use crate::sampled::model::{Model, signals};

use super::Form;
use super::known::{Known, Run, taps};
use crate::sampled::model::Between;

/// What is designed.
#[derive(Clone, Debug)]
pub struct Choice {
    /// Which discretisation.
    pub form: Form,
    /// How signals run between samples.
    pub between: Between,
    /// N.
    pub period: usize,
    /// Places of the plant's states that make up `x_r`.
    pub rest: Vec<usize>,
    /// L, (n-p) x p.
    pub gain: Vec<Vec<Constant>>,
}

/// Why there are no numbers.
#[derive(Debug)]
pub enum Failure {
    /// The plant, in words.
    Plant(Vec<Diagnostic>),
    /// Both copies carry some error alike: Q - P has no inverse at this precision.
    Alike,
    /// The second copy moves too fast for the sample time.
    TooFast(NormTooLarge),
}

impl From<NormTooLarge> for Failure {
    fn from(error: NormTooLarge) -> Self {
        Self::TooFast(error)
    }
}

impl From<Singular> for Failure {
    fn from(_: Singular) -> Self {
        Self::Alike
    }
}

/// [`super::Update`] before it is rounded.
#[derive(Clone, Debug)]
pub struct ExactUpdate {
    /// Of the copy that drives it.
    pub copy: Matrix,
    /// Of the outputs, by age.
    pub outputs: Vec<Matrix>,
    /// Per known and age, one column.
    pub knowns: Vec<Vec<Matrix>>,
    /// One column.
    pub constant: Matrix,
}

/// How two copies carry the error that they start with, and how the reset takes it away.
#[derive(Clone, Debug)]
pub struct Pair {
    /// H, of the second copy over one call; the continuous form's is 001's (5).
    pub h: Matrix,
    /// G, (7).
    pub g: Matrix,
    /// Of the first copy over a period: `Phi_rr^N`, `e^(F22 nu)`.
    pub p: Matrix,
    /// Of the second: `H^N`, `e^(H nu)`.
    pub q: Matrix,
    /// X = P (Q - P)^-1.
    pub x: Matrix,
}

/// 001's constants of the plant in continuous time.
#[derive(Clone, Debug)]
pub struct Continuous {
    /// F11 = yy, F12 = yr, F21 = ry, F22 = rr.
    pub f: Blocks,
    /// Both copies.
    pub pair: Pair,
}

impl Continuous {
    /// E^-1 = X Q, of (6).
    pub fn e_inverse(&self) -> Matrix {
        &self.pair.x * &self.pair.q
    }
}

/// The observer at one precision.
#[derive(Clone, Debug)]
pub struct Exact {
    /// T.
    pub coordinates: Coordinates,
    /// Phi, n x n, in the plant's states.
    pub phi: Matrix,
    /// The effect of each known that keeps its value, n x knowns, in the plant's states.
    pub gamma: Matrix,
    /// L.
    pub gain: Matrix,
    /// Both copies.
    pub pair: Pair,
    /// z1.
    pub first: ExactUpdate,
    /// z2.
    pub second: ExactUpdate,
    /// w.
    pub predictor: ExactUpdate,
    /// Of the plant in continuous time, where the form is.
    pub continuous: Option<Continuous>,
}

/// The plant's coefficients in the coordinates (y, `x_r`).
struct Coefficients {
    coordinates: Coordinates,
    model: Model,
    /// T A T^-1.
    a: Matrix,
    /// Per known, T times its column.
    columns: Vec<Matrix>,
    /// T c.
    offset: Matrix,
    /// s; `None` for a discrete plant.
    h: Option<Real>,
}

impl Coefficients {
    fn new(plant: &Plant, rest: &[usize], knowns: &[Known], precision: Precision) -> Result<Self, Failure> {
        // The model refuses every constant that has no value at this precision.
        let model = Model::new(plant, &signals(plant), precision).map_err(Failure::Plant)?;
        let value = |constant: &Constant| constant.evaluate(precision).unwrap_or_else(|_| Real::zero(precision));
        let n = plant.states.len();
        let coordinates = Coordinates::new(&model.c, rest.to_vec())?;
        let a = Matrix::from_fn(n, n, |i, j| value(&plant.a[i][j]));
        let column = |known: &Known| {
            let column = Matrix::from_fn(n, 1, |i, _| match known.source {
                Source::Input(u) => value(&plant.b[i][u]),
                Source::Injection(k) => value(&plant.injections[k].column[i]),
            });
            &coordinates.into * &column
        };
        let columns = knowns.iter().map(column).collect();
        let offset = &coordinates.into * &Matrix::from_fn(n, 1, |i, _| value(&plant.offset[i]));
        let a = &(&coordinates.into * &a) * &coordinates.back;
        let h = (!plant.discrete).then(|| value(&plant.sample_time.0));
        Ok(Self { coordinates, model, a, columns, offset, h })
    }

    /// What a column does over one interval of x' = a x + column w, by the known's own values.
    fn taps(&self, known: &Known, a: &Matrix, column: &Matrix) -> Result<Vec<Matrix>, NormTooLarge> {
        let all = taps(known.run, a, column, self.h.as_ref())?;
        Ok(if known.jumps { vec![all[known.ago].clone()] } else { all })
    }
}

/// The observer's constants.
pub fn exact(plant: &Plant, choice: &Choice, knowns: &[Known], precision: Precision) -> Result<Exact, Failure> {
    let k = Coefficients::new(plant, &choice.rest, knowns, precision)?;
    let gain = value(&choice.gain, k.coordinates.outputs(), precision);
    let p = k.coordinates.outputs();
    let n = k.a.rows();
    let above = |m: &Matrix| m.block(0..p, 0..m.cols());
    let below = |m: &Matrix| m.block(p..n, 0..m.cols());

    // One interval of the whole plant: the predictor in both forms, both copies in the exact one.
    let blocks = k.coordinates.blocks(&k.model.phi);
    let mut effects = Vec::new();
    for (known, column) in knowns.iter().zip(&k.columns) {
        effects.push(k.taps(known, &k.a, column)?);
    }
    let constant = taps(Run::Held, &k.a, &k.offset, k.h.as_ref())?.swap_remove(0);
    let each = |part: &dyn Fn(&Matrix) -> Matrix| -> Vec<Vec<Matrix>> {
        effects.iter().map(|taps| taps.iter().map(part).collect()).collect()
    };
    let nothing = |rows: usize| Matrix::zeros(rows, p, precision);
    let predictor = ExactUpdate {
        copy: blocks.yr.clone(),
        outputs: vec![nothing(p), blocks.yy.clone()],
        knowns: each(&above),
        constant: above(&constant),
    };
    let whole = effects.iter().map(|taps| taps.iter().skip(1).fold(taps[0].clone(), |sum, tap| &sum + tap));
    let gamma = whole.reduce(|all, one| all.hcat(&one)).unwrap_or_else(|| Matrix::zeros(n, 0, precision));
    let gamma = &k.coordinates.back * &gamma;

    let (pair, first, second, continuous) = if choice.form == Form::Continuous {
        let (continuous, first, second) = continuous_copies(&k, &gain, choice, knowns)?;
        (continuous.pair.clone(), first, second, Some(continuous))
    } else {
        let pair = pair(&blocks, &gain, |m| Ok(m.powi(choice.period as u64)))?;
        let shifted = |m: &Matrix| &below(m) + &(&gain * &above(m));
        let first = ExactUpdate {
            copy: blocks.rr.clone(),
            outputs: vec![nothing(n - p), blocks.ry.clone()],
            knowns: each(&below),
            constant: below(&constant),
        };
        let second = ExactUpdate {
            copy: pair.h.clone(),
            outputs: vec![nothing(n - p), pair.g.clone()],
            knowns: each(&shifted),
            constant: shifted(&constant),
        };
        (pair, first, second, None)
    };
    let phi = k.model.phi;
    Ok(Exact { coordinates: k.coordinates, phi, gamma, gain, pair, first, second, predictor, continuous })
}

/// H, G, P, Q and X; `over` gives a copy's transition over a period.
pub(super) fn pair(
    blocks: &Blocks,
    gain: &Matrix,
    over: impl Fn(&Matrix) -> Result<Matrix, NormTooLarge>,
) -> Result<Pair, Failure> {
    let h = &blocks.rr + &(gain * &blocks.yr);
    let g = &(&blocks.ry + &(gain * &blocks.yy)) - &(&h * gain);
    let (p, q) = (over(&blocks.rr)?, over(&h)?);
    // A first copy that has forgotten everything by itself needs no second one.
    let x = if p.is_zero() { p.clone() } else { &p * &inverse(&(&q - &p))? };
    Ok(Pair { h, g, p, q, x })
}

/// 001's copies (9) sampled, with the outputs and signals running between samples.
fn continuous_copies(
    k: &Coefficients,
    gain: &Matrix,
    choice: &Choice,
    knowns: &[Known],
) -> Result<(Continuous, ExactUpdate, ExactUpdate), Failure> {
    let continuous = continuous(k, gain, choice.period)?;
    let (p, n) = (k.coordinates.outputs(), k.a.rows());
    let below = |m: &Matrix| m.block(p..n, 0..m.cols());
    let shifted = |m: &Matrix| &below(m) + &(gain * &m.block(0..p, 0..m.cols()));
    let h = k.h.as_ref();
    let copy = |a: &Matrix, of_outputs: &Matrix, part: &dyn Fn(&Matrix) -> Matrix| -> Result<ExactUpdate, Failure> {
        let step = h.map_or_else(|| Ok(a.clone()), |h| exponential(&a.scale(h)))?;
        let mut all = Vec::new();
        for (known, column) in knowns.iter().zip(&k.columns) {
            all.push(k.taps(known, a, &part(column))?);
        }
        Ok(ExactUpdate {
            copy: step,
            outputs: taps(choice.between.into(), a, of_outputs, h)?,
            knowns: all,
            constant: taps(Run::Held, a, &part(&k.offset), h)?.swap_remove(0),
        })
    };
    let first = copy(&continuous.f.rr, &continuous.f.ry, &below)?;
    let second = copy(&continuous.pair.h, &continuous.pair.g, &shifted)?;
    Ok((continuous, first, second))
}

fn continuous(k: &Coefficients, gain: &Matrix, period: usize) -> Result<Continuous, Failure> {
    let (p, n) = (k.coordinates.outputs(), k.a.rows());
    let f = Blocks {
        yy: k.a.block(0..p, 0..p),
        yr: k.a.block(0..p, p..n),
        ry: k.a.block(p..n, 0..p),
        rr: k.a.block(p..n, p..n),
    };
    let over = |m: &Matrix| -> Result<Matrix, NormTooLarge> {
        let step = k.h.as_ref().map_or_else(|| Ok(m.clone()), |h| exponential(&m.scale(h)))?;
        Ok(step.powi(period as u64))
    };
    let pair = pair(&f, gain, over)?;
    Ok(Continuous { f, pair })
}

/// 001's constants for a plant in continuous time whose copies may be of the other form: what Theorem 2 speaks of.
pub fn in_continuous_time(plant: &Plant, choice: &Choice, precision: Precision) -> Result<Continuous, Failure> {
    let k = Coefficients::new(plant, &choice.rest, &[], precision)?;
    let gain = value(&choice.gain, k.coordinates.outputs(), precision);
    continuous(&k, &gain, choice.period)
}

fn value(gain: &[Vec<Constant>], outputs: usize, precision: Precision) -> Matrix {
    let entry = |constant: &Constant| constant.evaluate(precision).unwrap_or_else(|_| Real::zero(precision));
    Matrix::from_fn(gain.len(), outputs, |i, o| entry(&gain[i][o]))
}

impl Exact {
    /// What a reset leaves of the error that both copies started with, `P + X (P - Q)`, against P; 0 in exact
    /// arithmetic.
    pub fn left(&self) -> f64 {
        let Pair { p, q, x, .. } = &self.pair;
        let left = (p + &(x * &(p - q))).max_abs();
        let scale = p.max_abs();
        if left.is_zero() { 0.0 } else { left.checked_div(&scale).map_or(f64::INFINITY, |ratio| ratio.to_f64()) }
    }
}
