//! How an estimation error moves from call to call, and what is left of an initial one.
//!
//! `e = (I - K C) Phi e`: noise v enters by -K v, a disturbance by (I - K C) before its correction.
//!
//! All of it is in doubles, in coordinates in which the size of an error is the root mean square of what it does to
//! the outputs over the next n calls: there the step itself is well scaled, whatever the units. What is left of an
//! initial error is measured over all calls until the promised one.

mod size;
mod sums;

use nalgebra::{DMatrix, DVector};

use super::exact::Exact;
use super::far::Far;
use super::rounds::Rounds;
use super::schedule::Schedule;
use crate::plant::Plant;
use crate::promise::CONTRACTED;
use crate::promise::kernel::Kernel;
use crate::real::{Matrix, Real};
use crate::sampled::Signal;
pub(super) use size::coordinates;
pub(super) use sums::Sums;

/// Multiplications spent on the calls of a recovery.
const MOST_RECOVERY: usize = 20_000_000;
/// Places of a countdown from which a recovery is followed.
const MOST_PLACES: usize = 64;

/// How the errors move.
pub struct Errors<'a> {
    pub(super) plant: &'a Plant,
    pub(super) signals: &'a [Signal],
    /// Coordinates from states and states from coordinates, n x n.
    pub(super) to: DMatrix<f64>,
    pub(super) back: DMatrix<f64>,
    /// Coordinates of the size over all calls from these, and states from those; n x n.
    far: DMatrix<f64>,
    far_to: DMatrix<f64>,
    wide: Far,
    phi: DMatrix<f64>,
    c: DMatrix<f64>,
    /// Per signal: its effects at the beginning and at the end of an interval, n x 1, in states.
    effects: Vec<[DVector<f64>; 2]>,
    /// K, n x p, of the calls after the first sample, and of those that follow, over and over; in the coordinates.
    lead: Vec<DMatrix<f64>>,
    pub(super) cycle: Vec<DMatrix<f64>>,
    /// The latter in states.
    turn: Vec<DMatrix<f64>>,
    /// What the step carries, as coordinates of these and as states; n x n.
    carried: DMatrix<f64>,
    pub(super) from_carried: DMatrix<f64>,
    /// What the step carries from states, n x n.
    pub(super) into_carried: DMatrix<f64>,
    /// Sums of magnitudes that the gain of each call is made of, n x p, of what the step carries; lead and cycle.
    made_of: [Vec<DMatrix<f64>>; 2],
}

/// What is left of an initial error at a call.
#[derive(Clone, Debug)]
pub struct Remaining {
    /// Of the worst initial error of the states that the first sample does not show, in size; at that call or later.
    pub share: f64,
    /// Per state, per initial error of a state.
    pub by_state: DMatrix<f64>,
}

impl<'a> Errors<'a> {
    /// For a design and its schedule, with the size of an error over the calls until the promised one; `None` where the
    /// coordinates cannot be formed.
    pub fn new(
        plant: &'a Plant,
        signals: &'a [Signal],
        exact: &Exact,
        schedule: &Schedule,
        valid: usize,
    ) -> Option<Self> {
        let model = &exact.model;
        let n = plant.states.len();
        let (to, back) = coordinates(&model.phi, &model.c, n)?;
        let wide = Far::new(&model.phi, &model.c, schedule.lead.len().max(valid))?;
        let effect = |part: &Option<Matrix>| match part {
            Some(column) => DVector::from_iterator(n, column.iter().map(Real::to_f64)),
            None => DVector::zeros(n),
        };
        let effects = model.effects.iter().map(|e| [effect(&e.at_begin), effect(&e.at_end)]).collect();
        let phi = (&(&to * &model.phi) * &back).doubles();
        let c = (&model.c * &back).doubles();
        let (far, far_to) = ((&wide.to * &back).doubles(), (&to * &wide.back).doubles());
        let (to, back) = (to.doubles(), back.doubles());
        let of = |gains: &[DMatrix<f64>]| gains.iter().map(|gain| &to * gain).collect();
        let (lead, cycle) = (of(&schedule.lead), of(&schedule.cycle));
        let turn = schedule.cycle.clone();
        let (from_carried, into_carried) = exact.frame()?;
        let carried = &to * &from_carried;
        let made_of = |gains: &[DMatrix<f64>]| gains.iter().map(|gain| exact.made_of(&into_carried, gain)).collect();
        let made_of = [made_of(&schedule.lead), made_of(&schedule.cycle)];
        Some(Self {
            plant,
            signals,
            to,
            back,
            far,
            far_to,
            wide,
            phi,
            c,
            effects,
            lead,
            cycle,
            turn,
            carried,
            from_carried,
            into_carried,
            made_of,
        })
    }

    /// The plant in coordinates of the size until the promised call.
    pub(super) fn far(&self) -> &Far {
        &self.wide
    }

    /// K of the calls that go round, n x p, of states.
    pub(super) fn turn(&self) -> &[DMatrix<f64>] {
        &self.turn
    }

    /// Which of them a call has.
    pub(super) fn place(&self, call: usize) -> usize {
        let turn = self.turn.len();
        (call + turn - 1 + self.lead.len() * (turn - 1)) % turn
    }

    /// Sums of magnitudes that a gain of those that go round is made of, n x p, of what the step carries.
    pub(super) fn made_of(&self, place: usize) -> &DMatrix<f64> {
        let [_, cycle] = &self.made_of;
        &cycle[place]
    }

    /// Per signal: its effects at the beginning and at the end of an interval, n x 1, of states.
    pub(super) fn effects(&self) -> &[[DVector<f64>; 2]] {
        &self.effects
    }

    /// n.
    pub(super) fn order(&self) -> usize {
        self.phi.nrows()
    }

    /// The transition over no call.
    pub(super) fn identity(&self) -> DMatrix<f64> {
        DMatrix::identity(self.order(), self.order())
    }

    /// What is left of an initial error at a call.
    pub fn remaining(&self, call: usize) -> Remaining {
        if self.lead.is_empty() {
            let wide = Rounds::new(&self.wide, &self.turn).after(call);
            return self.left(&(&self.far_to * wide * &self.far));
        }
        let mut transition = self.identity();
        for k in 1..=call {
            transition = self.transition(k) * transition;
        }
        let mut remaining = self.left(&transition);
        // A slower gain afterwards may let it rise again before it falls.
        let most = MOST_RECOVERY / self.order().pow(3);
        let mut fallen = 0;
        for k in call + 1..=call + most {
            transition = self.transition(k) * transition;
            let share = self.left(&transition).share;
            remaining.share = remaining.share.max(share);
            fallen = if share <= 0.5 * remaining.share { fallen + 1 } else { 0 };
            if fallen > self.cycle.len() {
                break;
            }
        }
        remaining
    }

    /// Calls that leave no more of any error than the first convergence did, where the last gains go on; a millionth is
    /// enough.
    pub fn recovery(&self, valid: usize, share: f64) -> usize {
        let mut rounds = Rounds::new(&self.wide, &self.turn);
        // A countdown that goes round is met anywhere.
        let stride = self.cycle.len().div_ceil(MOST_PLACES);
        let places = (0..self.cycle.len()).step_by(stride);
        let most = MOST_RECOVERY / self.order().pow(3);
        let share = share.max(CONTRACTED);
        let calls = places.map(|place| rounds.until_from(self.place(valid + place + 1), share).unwrap_or(most));
        calls.max().unwrap_or(1).max(1) + stride - 1
    }

    fn left(&self, transition: &DMatrix<f64>) -> Remaining {
        let by_state = &self.back * transition * &self.to;
        let hidden: Vec<usize> = (0..self.order()).filter(|i| self.plant.states[*i].measured.is_empty()).collect();
        if hidden.is_empty() {
            return Remaining { share: 0.0, by_state };
        }
        let columns = span((&self.far * &self.to).select_columns(&hidden));
        let share = (&self.far * transition * &self.far_to * columns).norm();
        Remaining { share, by_state }
    }

    /// The spectral radius of the last gain's transition, or of a whole cycle's.
    pub fn radius(&self) -> f64 {
        let first = self.lead.len() + 1;
        let turn = (first..first + self.cycle.len()).fold(self.identity(), |turn, call| self.transition(call) * turn);
        turn.complex_eigenvalues()
            .iter()
            .map(|z| deadbeat_math::sqrt_f64(z.re * z.re + z.im * z.im))
            .fold(0.0, f64::max)
    }

    /// The gain of a call, from 1.
    pub(super) fn gain(&self, call: usize) -> &DMatrix<f64> {
        Self::of_call(&self.lead, &self.cycle, call)
    }

    /// What it is made of.
    fn magnitudes(&self, call: usize) -> &DMatrix<f64> {
        let [lead, cycle] = &self.made_of;
        Self::of_call(lead, cycle, call)
    }

    fn of_call<'s>(lead: &'s [DMatrix<f64>], cycle: &'s [DMatrix<f64>], call: usize) -> &'s DMatrix<f64> {
        lead.get(call - 1).unwrap_or_else(|| &cycle[(call - 1 - lead.len()) % cycle.len()])
    }

    /// The magnitudes of `C Phi`, p x n: what an error of the states does to the innovations of the next call.
    pub(super) fn foretold(&self) -> DMatrix<f64> {
        (&self.c * &self.phi * &self.to).abs()
    }

    /// C, p x n, of states.
    pub(super) fn shown(&self) -> DMatrix<f64> {
        &self.c * &self.to
    }

    /// I - K C of a call.
    fn correction(&self, call: usize) -> DMatrix<f64> {
        self.identity() - self.gain(call) * &self.c
    }

    /// (I - K C) Phi of a call.
    pub(super) fn transition(&self, call: usize) -> DMatrix<f64> {
        self.correction(call) * &self.phi
    }

    /// Adds what entered at a call for rows that lead from its estimate to what is asked for; gives the rows that lead
    /// from the estimate of the call before. `begun` is what a signal's value did by the interval that it began.
    pub(super) fn enter(
        &self,
        sums: &mut Sums,
        rows: &DMatrix<f64>,
        begun: &mut DMatrix<f64>,
        call: usize,
        kernel: Option<&Kernel>,
    ) -> DMatrix<f64> {
        sums.add_noise(&(rows * self.gain(call)));
        let carried = (rows * &self.carried).abs();
        sums.gained += &carried * self.magnitudes(call);
        sums.carried += carried;
        let rows = rows * self.correction(call);
        let acc = &rows * &self.to;
        if let Some(kernel) = kernel {
            kernel.add(&acc, &mut sums.disturbances);
        }
        for (s, [begin, end]) in self.effects.iter().enumerate() {
            let both = begun.column(s) + &acc * end;
            let mut sum = sums.signals.column_mut(s);
            sum += both.abs();
            begun.set_column(s, &(&acc * begin));
        }
        rows * &self.phi
    }

    /// Sums of magnitudes in the estimate of a call over what entered in the last `calls` of them; with the first
    /// sample, where that is all. Also the rows that lead from what was before.
    pub(super) fn at(&self, call: usize, calls: usize, kernel: Option<&Kernel>) -> (Sums, DMatrix<f64>) {
        let mut sums = Sums::new(self.plant, self.signals.len());
        let mut rows = self.back.clone();
        let mut begun = DMatrix::zeros(self.order(), self.signals.len());
        for k in (call + 1 - calls..=call).rev() {
            rows = self.enter(&mut sums, &rows, &mut begun, k, kernel);
        }
        self.finish(&mut sums, &rows, &begun, calls == call);
        (sums, rows)
    }

    /// Adds what the oldest interval's signals began, and the first sample where it is the one before.
    pub(super) fn finish(&self, sums: &mut Sums, rows: &DMatrix<f64>, begun: &DMatrix<f64>, started: bool) {
        sums.signals += begun.abs();
        if started {
            sums.carried += (rows * &self.carried).abs();
            sums.add_noise(&(rows * &self.to * self.starts()));
        }
    }

    /// Whether the gains go round from the first call on.
    pub(super) fn goes_round(&self) -> bool {
        let turned = self.lead.iter().rev().zip(self.cycle.iter().rev().cycle());
        turned.into_iter().all(|(lead, cycle)| lead == cycle)
    }

    /// The weights of the first sample in the state at the start, n x p.
    pub(super) fn starts(&self) -> DMatrix<f64> {
        let mut starts = DMatrix::zeros(self.order(), self.plant.outputs.len());
        for (i, state) in self.plant.states.iter().enumerate() {
            state.measured.iter().for_each(|(o, weight)| starts[(i, *o)] = weight.to_f64().unwrap_or(0.0));
        }
        starts
    }
}

/// The first call from which on no more than a share is left of an initial error of the states that the first sample does
/// not show, in the size over as many calls as given, where the gains, n x p, go round from the first call on.
pub(super) fn until(
    plant: &Plant,
    exact: &Exact,
    schedule: &Schedule,
    over: usize,
    share: f64,
) -> Option<Result<usize, f64>> {
    let far = Far::new(&exact.model.phi, &exact.model.c, over)?;
    let hidden: Vec<usize> = (0..plant.states.len()).filter(|i| plant.states[*i].measured.is_empty()).collect();
    let mut rounds = Rounds::new(&far, &schedule.cycle);
    if hidden.is_empty() {
        return Some(rounds.levels(share).map(|_| 0).ok_or_else(|| rounds.radius()));
    }
    let start = span(far.to.doubles().select_columns(&hidden));
    Some(rounds.until(&start, share).ok_or_else(|| rounds.radius()))
}

/// An orthonormal basis of columns, by their directions.
fn span(mut columns: DMatrix<f64>) -> DMatrix<f64> {
    // Squares of what is far below one would vanish.
    columns.column_iter_mut().for_each(|mut column| column /= column.amax().max(f64::MIN_POSITIVE));
    columns.qr().q()
}
