//! Sums of magnitudes over all that entered before a call, where the gains go round: exactly, however slowly they die out.
//!
//! The past is a sequence of calls that repeats. Stretches of it are put together two by two ([`stretch`]), and whole turns
//! to twice as many, by squaring in multiprecision. Over a stretch in which a cause keeps its sign the sum of the
//! magnitudes is the magnitude of the sum, which is known; only stretches with a change of sign are looked into. That a
//! sign stays is not believed but follows from intervals around all that the stretch has.

mod stretch;

use std::cell::Cell;
use std::ops::Range;

use nalgebra::{DMatrix, RowDVector};

use super::errors::{Errors, Sums};
use super::rounds::{Rounds, norm};
use crate::numbers::count;
use crate::program::Scalar;
use crate::promise::kernel::Kernel;
use stretch::{Stretch, Within, square};

/// What may be left of the past when its sums count as complete.
const COMPLETE: f64 = 1e-13;
/// A share of a sum that is bounded instead of formed.
const NOTHING: f64 = 1e-13;
/// Multiplications spent on changes of sign, over all calls and states; what is left is bounded by its energy, which is
/// 1.11 times the sum for an oscillation.
const MOST_WORK: f64 = 2e8;
/// Multiplications spent on a turn as a whole, by what its first calls take; beyond, there is no bound.
const MOST_SPENT: f64 = 4e9;
/// How often that is looked at.
const LOOKS: usize = 64;
/// What looking at a stretch costs besides.
const VISIT: f64 = 100.0;
/// What is left of an error over a stretch that is so bounded, at least.
const HARDLY: f64 = 0.95;
/// Calls of a turn that counts as short.
const SHORT_TURN: usize = 16;
/// What the first sample may add to a sum that counts as complete.
const NEGLIGIBLE: f64 = 1e-7;
/// Groups of calls with the first sample that are looked at, each longer than all before by one part in so many.
const MOST_GROUPS: usize = 64;
const GROWTH: usize = 8;

/// The past of any call of gains that go round.
pub(super) struct Past<'a> {
    errors: &'a Errors<'a>,
    kernel: Option<&'a Kernel>,
    /// States from the coordinates.
    back: DMatrix<f64>,
    /// The coordinates of states.
    to: DMatrix<f64>,
    /// K of a turn's calls in the coordinates, n x p, and I - K C.
    gains: Vec<DMatrix<f64>>,
    corrections: Vec<DMatrix<f64>>,
    /// Per power of two: stretches of so many calls of a turn, newest first.
    tree: Vec<Vec<Stretch>>,
    /// 2^i turns, and those that one has.
    turns: Vec<Stretch>,
    places: Vec<At>,
    within: Within,
    /// Multiplications for each state at each call.
    work: f64,
    /// Multiplications so far.
    spent: Cell<f64>,
}

/// A stretch by its place.
#[derive(Clone, Copy, Debug)]
enum At {
    /// 2^i calls of a turn, and which.
    Tree(usize, usize),
    /// 2^i turns.
    Turns(usize),
}

/// The sums of one state.
struct Row {
    /// What leads to the state from where the calls begin.
    leads: RowDVector<f64>,
    /// Magnitudes, by cause.
    sums: Vec<f64>,
    /// Squares, by output.
    squares: Vec<f64>,
    /// Multiplications.
    work: f64,
}

impl<'a> Past<'a> {
    /// Of errors whose gains go round from the first call on; `calls` are those before the last call that is asked for one
    /// by one. `None` where the error does not die out.
    pub(super) fn new(errors: &'a Errors<'a>, kernel: Option<&'a Kernel>, calls: usize) -> Option<Self> {
        let far = &errors.far().calm(errors.turn())?;
        let mut rounds = Rounds::new(far, errors.turn());
        let levels = rounds.levels(COMPLETE)?;
        let (to, back) = (far.to.doubles(), far.back.doubles());
        let gains: Vec<DMatrix<f64>> = errors.turn().iter().map(|gain| &to * gain).collect();
        let (c, identity) = (far.c.doubles(), errors.identity());
        let corrections: Vec<DMatrix<f64>> = gains.iter().map(|gain| &identity - gain * &c).collect();
        let within = Within {
            outputs: errors.plant.outputs.len(),
            disturbances: if kernel.is_some() { errors.plant.disturbances.len() } else { 0 },
            parts: kernel.map_or(1, |kernel| kernel.parts().len()),
            signals: errors.signals.len(),
            carried: if errors.plant.scalar == Scalar::F32 {
                errors.order() * (1 + errors.plant.outputs.len())
            } else {
                0
            },
            square: kernel.map_or(0.0, |kernel| kernel.length() * kernel.length()),
        };
        let work = MOST_WORK / count(gains.len() * errors.order());
        let (tree, turns, places) = (Vec::new(), Vec::new(), Vec::new());
        let spent = Cell::new(0.0);
        let mut past = Self { errors, kernel, back, to, gains, corrections, tree, turns, places, within, work, spent };
        past.plant_tree(&far.phi.doubles());
        let most = usize::BITS - (calls / past.turn()).leading_zeros();
        past.wind(&mut rounds, levels.max(most as usize));
        Some(past)
    }

    /// Calls of a turn.
    fn turn(&self) -> usize {
        self.gains.len()
    }

    fn plant_tree(&mut self, phi: &DMatrix<f64>) {
        let turn = self.turn();
        let mut level: Vec<Stretch> = (0..turn).map(|place| self.call(turn - 1 - place, phi)).collect();
        while !level.is_empty() {
            let next = level.chunks_exact(2).map(|two| two[0].then(&two[1])).collect();
            self.tree.push(std::mem::replace(&mut level, next));
        }
    }

    /// The stretch of one call of a turn.
    fn call(&self, place: usize, phi: &DMatrix<f64>) -> Stretch {
        let (gain, correction) = (&self.gains[place], &self.corrections[place]);
        let transition = correction * phi;
        let entering = correction * &self.to;
        let mut columns = vec![gain.clone()];
        let mut slope = DMatrix::zeros(self.errors.order(), 0);
        if let Some(kernel) = self.kernel.filter(|_| self.within.disturbances > 0) {
            let parts = |d: usize| kernel.parts().iter().map(move |part| part.column(d));
            let all: Vec<_> = (0..self.within.disturbances).flat_map(parts).collect();
            columns.push(&entering * DMatrix::from_columns(&all));
            slope = entering.abs() * kernel.slope();
        }
        let before = &self.corrections[(place + self.turn() - 1) % self.turn()];
        for [begin, end] in self.errors.effects() {
            // A value at a call ends an interval and begins the next.
            let both = &entering * begin + &transition * (before * (&self.to * end));
            columns.push(DMatrix::from_columns(&[both]));
        }
        if self.within.carried > 0 {
            let carried = &self.to * &self.errors.from_carried;
            let made_of = self.errors.made_of(place);
            columns.push(carried.clone());
            columns.extend(made_of.column_iter().map(|made| &carried * DMatrix::from_diagonal(&made.into_owned())));
        }
        columns.push(&self.to * self.errors.starts());
        let all: Vec<_> = columns.iter().flat_map(DMatrix::column_iter).collect();
        let all = DMatrix::from_columns(&all);
        let sums = all.columns(0, self.within.width()).into_owned();
        let energy = (0..self.within.outputs).map(|o| gain.column(o) * gain.column(o).transpose()).collect();
        Stretch {
            calls: 1.0,
            longest: norm(&transition),
            transition,
            sums,
            low: all.clone(),
            high: all.clone(),
            radius: all.column_iter().map(|column| column.iter().any(|x| *x != 0.0).then_some(0.0)).collect(),
            middle: all,
            slope,
            energy,
        }
    }

    /// Whole turns, to powers of two; with the energy of every column.
    fn wind(&mut self, rounds: &mut Rounds, levels: usize) {
        let places: Vec<At> = self.stretches(0, Some(self.turn())).collect();
        let first = self.stretch(places[0]).clone();
        let mut turn = places[1..].iter().fold(first, |turn, at| turn.then(self.stretch(*at)));
        let mut energy = vec![DMatrix::zeros(self.errors.order(), self.errors.order()); self.within.width()];
        let mut before = self.errors.identity();
        for call in &self.tree[0] {
            for (energy, column) in energy.iter_mut().zip((&before * &call.sums).column_iter()) {
                *energy += column * column.transpose();
            }
            before *= &call.transition;
        }
        self.places = places;
        turn.energy = energy;
        turn.transition = rounds.power(0).clone();
        turn.longest = norm(&turn.transition);
        self.turns = vec![turn];
        for level in 1..=levels {
            let last = &self.turns[level - 1];
            let mut twice = last.then(last);
            twice.transition = rounds.power(level).clone();
            twice.longest = norm(&twice.transition);
            self.turns.push(twice);
        }
    }

    fn stretch(&self, at: At) -> &Stretch {
        match at {
            At::Tree(level, place) => &self.tree[level][place],
            At::Turns(level) => &self.turns[level],
        }
    }

    /// The stretches, newest first, of so many calls, or of all, from a place of the turn on that is counted from its newest.
    fn stretches(&self, place: usize, calls: Option<usize>) -> impl Iterator<Item = At> {
        let (turn, mut place, mut left) = (self.turn(), place, calls);
        let mut found = Vec::new();
        while left != Some(0) {
            match left {
                None if place == 0 => {
                    found.push(At::Turns(self.turns.len() - 1));
                    break;
                }
                Some(calls) if place == 0 && calls >= turn && !self.turns.is_empty() => {
                    let turns = calls / turn;
                    found.extend((0..self.turns.len()).filter(|level| turns >> level & 1 == 1).map(At::Turns));
                    left = Some(calls % turn);
                }
                _ => {
                    let fits = |level: &usize| {
                        let calls = 1 << level;
                        place % calls == 0 && place + calls <= turn && left.is_none_or(|left| calls <= left)
                    };
                    let level = (0..self.tree.len()).rev().find(fits).unwrap_or(0);
                    found.push(At::Tree(level, place >> level));
                    place = (place + (1 << level)) % turn;
                    left = left.map(|left| left - (1 << level));
                }
            }
        }
        found.into_iter()
    }

    /// The sums of the worst of the calls from one on; `None` where a turn is too long to look at each of its calls.
    pub(super) fn worst_from(&self, valid: usize) -> Option<Sums> {
        let mut worst = Sums::new(self.errors.plant, self.within.signals);
        let (turn, looks) = (self.turn(), self.turn().div_ceil(LOOKS));
        for (before, first) in (valid..valid + turn).enumerate() {
            (0..self.errors.order()).for_each(|state| self.raise(&mut worst, state, first));
            let done = before + 1;
            if done < turn && done % looks == 0 && self.spent.get() * count(turn) > MOST_SPENT * count(done) {
                return None;
            }
        }
        Some(worst)
    }

    /// Raises the sums of a state to those of the worst call from one on, of its place in the turn. Sums grow, and what the
    /// first sample does dies out: of several calls none has more than the last one's sums and the first one's start.
    fn raise(&self, worst: &mut Sums, state: usize, first: usize) {
        let known = 0..self.within.known();
        let all = self.row(state, first, None, known.clone());
        self.raise_carried(worst, state, first);
        let mut call = first;
        for group in 0..=MOST_GROUPS {
            let leads = self.leads(state, call);
            let later = self.first_sample(&leads, call);
            let small = later.iter().zip(&all.sums).all(|(first, sum)| *first <= NEGLIGIBLE * sum);
            let mut raised = worst.clone();
            self.put(&mut raised, state, &all, later.iter().copied());
            if small || group == MOST_GROUPS || !raised.exceeds(worst) {
                *worst = raised;
                return;
            }
            let turns = call / GROWTH / self.turn();
            if turns <= 1 {
                let now = leads * &self.to * self.errors.starts();
                self.put(
                    worst,
                    state,
                    &self.row(state, call, Some(call), known.clone()),
                    now.iter().map(|first| first.abs()),
                );
                call += self.turn();
            } else {
                call += turns * self.turn();
                self.put(worst, state, &self.row(state, call, Some(call), known.clone()), later.into_iter());
            }
        }
    }

    /// What rounding adds to a state at a call, over an endless past: that has what the start adds too.
    fn raise_carried(&self, worst: &mut Sums, state: usize, call: usize) {
        let known = self.within.known();
        let row = self.row(state, call, None, known..self.within.causes());
        let order = self.errors.order();
        for (group, sums) in row.sums[known..].chunks(order).enumerate() {
            match group.checked_sub(1) {
                Some(o) => worst.gained[(state, o)] = worst.gained[(state, o)].max(sums.iter().sum()),
                None => sums.iter().enumerate().for_each(|(j, sum)| {
                    worst.carried[(state, j)] = worst.carried[(state, j)].max(*sum);
                }),
            }
        }
    }

    /// What leads from the first sample to a state at a call.
    fn leads(&self, state: usize, call: usize) -> RowDVector<f64> {
        let mut leads = self.back.row(state).into_owned();
        for at in self.stretches(self.counted(call, 0), Some(call)) {
            leads *= &self.stretch(at).transition;
        }
        leads
    }

    fn put(&self, worst: &mut Sums, state: usize, row: &Row, first: impl Iterator<Item = f64>) {
        let Within { outputs, disturbances, .. } = self.within;
        let raise = |entry: &mut f64, sum: f64| *entry = entry.max(sum);
        for (o, first) in first.enumerate() {
            raise(&mut worst.noise[(state, o)], row.sums[o] + first);
            raise(&mut worst.squares[(state, o)], row.squares[o] + first * first);
        }
        (0..disturbances).for_each(|d| raise(&mut worst.disturbances[(state, d)], row.sums[outputs + d]));
        (0..self.within.signals)
            .for_each(|s| raise(&mut worst.signals[(state, s)], row.sums[outputs + disturbances + s]));
    }

    /// Per output, the most that the first sample does at any call from one on, by what leads to it there.
    fn first_sample(&self, leads: &RowDVector<f64>, call: usize) -> Vec<f64> {
        let mut most = vec![0.0_f64; self.within.outputs];
        let mut leads = leads.clone();
        // As many calls before the first one as after it: the past goes round.
        for at in self.stretches(self.counted(call, call), None) {
            let stretch = self.stretch(at);
            let length = leads.norm();
            for (o, most) in most.iter_mut().enumerate() {
                let (below, above) = stretch.around((&leads, length), self.within.width() + o);
                *most = most.max(below.abs()).max(above.abs());
            }
            leads *= &stretch.transition;
        }
        most
    }

    /// The place of a call, so many before one, counted from the newest of a turn.
    fn counted(&self, call: usize, before: usize) -> usize {
        let turn = self.turn();
        (turn - 1 - self.errors.place(call) + before) % turn
    }

    /// The sums of a state at a call over so many calls that end with it, or over an endless past; of some causes.
    fn row(&self, state: usize, call: usize, calls: Option<usize>, causes: Range<usize>) -> Row {
        let causes: Vec<usize> = causes.collect();
        let mut row = Row {
            leads: self.back.row(state).into_owned(),
            sums: vec![0.0; self.within.causes()],
            squares: vec![0.0; self.within.outputs],
            work: 0.0,
        };
        if calls == Some(0) {
            return row;
        }
        let known = self.within.outputs + self.within.disturbances;
        let entering = &row.leads * &self.corrections[self.errors.place(call)] * &self.to;
        for (s, [_, end]) in self.errors.effects().iter().enumerate() {
            row.sums[known + s] += (&entering * end)[0].abs();
        }
        for at in self.stretches(self.counted(call, 0), calls.map(|calls| calls - 1)) {
            self.pass(&mut row, at, &causes);
        }
        if let Some(calls) = calls {
            // A value at the first sample only begins an interval.
            let last = self.counted(call, calls - 1);
            let place = self.turn() - 1 - last;
            let entering = &row.leads * &self.corrections[place] * &self.to;
            for (s, [begin, _]) in self.errors.effects().iter().enumerate() {
                row.sums[known + s] += (&entering * begin)[0].abs();
            }
            self.pass(&mut row, At::Tree(0, last), &causes[..known]);
        }
        self.spent.set(self.spent.get() + row.work);
        row
    }

    /// Adds a stretch, and goes on to what is before it.
    fn pass(&self, row: &mut Row, at: At, causes: &[usize]) {
        let leads = row.leads.clone();
        self.add(row, &leads, at, causes);
        let stretch = self.stretch(at);
        for (sum, energy) in row.squares.iter_mut().zip(&stretch.energy) {
            *sum += square(&leads, energy);
        }
        row.leads = leads * &stretch.transition;
    }

    /// Adds the magnitudes of some causes over a stretch.
    fn add(&self, row: &mut Row, leads: &RowDVector<f64>, at: At, causes: &[usize]) {
        let stretch = self.stretch(at);
        let columns: usize = causes.iter().map(|cause| self.within.columns(*cause).len()).sum();
        row.work += VISIT + count(leads.len() * (leads.len() + 4 * columns));
        if let At::Tree(0, place) = at {
            return self.add_call(row, leads, place, causes);
        }
        let measured = (leads, leads.norm());
        let mut open = Vec::new();
        for cause in causes {
            let sum = &mut row.sums[*cause];
            if let Some(whole) = stretch.of_one_sign(measured, *cause, &self.within) {
                *sum += whole;
                continue;
            }
            let most = stretch.at_most(measured, *cause, &self.within);
            if most <= NOTHING * *sum {
                *sum += most;
            } else {
                open.push(*cause);
            }
        }
        if open.is_empty() || self.is_enough(row, leads, at, &open) {
            return;
        }
        let parts: Vec<At> = match at {
            At::Turns(0) => self.places.clone(),
            At::Turns(level) => vec![At::Turns(level - 1); 2],
            At::Tree(level, place) => vec![At::Tree(level - 1, 2 * place), At::Tree(level - 1, 2 * place + 1)],
        };
        let mut leads = leads.clone();
        for part in parts {
            self.add(row, &leads, part, &open);
            leads *= &self.stretch(part).transition;
        }
    }

    /// Whether so much was spent that a stretch of hardly damped oscillations is bounded by its energy; then that is added.
    fn is_enough(&self, row: &mut Row, leads: &RowDVector<f64>, at: At, causes: &[usize]) -> bool {
        let At::Turns(level) = at else { return false };
        let stretch = &self.turns[level];
        // What is done within a long turn is no oscillation.
        let work = if self.turn() > SHORT_TURN { 50.0 * self.work } else { self.work };
        if row.work < work || (level > 0 && stretch.longest < HARDLY) {
            return false;
        }
        for cause in causes {
            row.sums[*cause] += stretch.by_energy(leads, *cause, &self.within).unwrap_or(f64::INFINITY);
        }
        true
    }

    /// Adds one call, exactly.
    fn add_call(&self, row: &mut Row, leads: &RowDVector<f64>, place: usize, causes: &[usize]) {
        let sums = &self.tree[0][place].sums;
        let mut disturbances = DMatrix::zeros(1, self.within.disturbances);
        if let Some(kernel) =
            self.kernel.filter(|_| causes.iter().any(|cause| self.within.disturbance(*cause).is_some()))
        {
            let entering = leads * &self.corrections[self.turn() - 1 - place] * &self.to;
            kernel.add(&DMatrix::from_rows(&[entering]), &mut disturbances);
        }
        for cause in causes {
            row.sums[*cause] += match self.within.disturbance(*cause) {
                Some(d) => disturbances[(0, d)],
                None => {
                    let column = sums.column(self.within.columns(*cause).start);
                    leads.iter().zip(column.iter()).map(|(a, b)| a * b).sum::<f64>().abs()
                }
            };
        }
    }
}
