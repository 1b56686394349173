//! The reading of a call's sensors, from what the caller measured to what the estimator works with.
//!
//! Samples and inputs are read and guarded; what needs no sample is evaluated; the estimator foretells the samples; those
//! that are too far off are rejected; for those that are not there its word stands in; then the rest is evaluated, and
//! what stands in is settled with it.

use crate::program::builder::Builder;
use crate::program::{Value, place};

use super::gate::Look;
use super::kept::Kept;
use super::known::Known;
use super::logic::any;
use super::missing::abandoned;
use super::sensors::Sensors;
use super::{coasting, front};

/// What an output should show.
#[derive(Clone, Copy)]
pub(crate) struct Foretold {
    /// In its unit; of one that wraps, within half a turn of zero.
    pub(crate) place: Value,
    /// Of a counter: how much further than the last count.
    pub(crate) further: Value,
}

impl Foretold {
    /// Of an output that is kept as a float.
    pub(crate) fn at(place: Value) -> Self {
        Self { place, further: place }
    }
}

/// What a reading asks of an estimator.
pub(crate) trait Foretells<'a> {
    /// The step being written.
    fn builder(&mut self) -> &mut Builder;

    /// Whether it follows an output that turns on, so that a sample is taken a whole number of turns from its angle.
    fn unfolds(&self) -> bool {
        false
    }

    /// Takes from `good` what is no sample of this call, whatever it says.
    fn screen(&mut self, _good: &mut [Value]) {}

    /// Per output, what it should show by what is known before the samples; where nobody asks, none.
    fn foretells(&mut self, known: &Known) -> Option<Vec<Foretold>>;

    /// Whether the estimate that foretells an output has converged, so that a gate may go by it.
    fn believed(&mut self, output: usize) -> Value;

    /// Whether that can stand in for a sample; where it never does, none: then the last value stays.
    fn stands_in(&mut self, output: usize) -> Option<Value> {
        Some(self.believed(output))
    }

    /// What stands in for a sample, and whether it can: `place` where it is `usable`, else the last value.
    fn instead(&mut self, _output: usize, (place, usable): (Value, Value), last: Value) -> (Value, Value) {
        (self.builder().select(usable, place, last), usable)
    }

    /// What an output should show, with everything known; none where what stood in for it stays.
    fn settles(&mut self, output: usize, known: &Known, foretold: Foretold) -> Option<Foretold>;

    /// Whether the estimate is lost with a sample that is not `good`.
    fn lost(&mut self, good: Value, word: &Word) -> Value {
        let b = self.builder();
        let covered = b.or(good, word.usable);
        b.not(covered)
    }

    /// Per output, whether it was there when it was last due.
    fn present(&mut self, good: &[Value]) -> Vec<Value> {
        good.to_vec()
    }

    /// The last value that stood for an output.
    fn last(&mut self, _output: usize, kept: Kept, newest: Option<Value>) -> Value {
        kept.newest(self.builder(), newest)
    }
}

/// What stands in for a sample.
pub(crate) struct Word {
    value: Value,
    /// Whether the estimate that it comes from is one.
    pub(crate) known: Value,
    /// Whether it is within the output's range.
    pub(crate) sane: Value,
    /// Whether it can stand in; else the last value does.
    usable: Value,
}

/// What a call brought.
pub(crate) struct Reading<'a> {
    /// Per output: what stands for it.
    pub(crate) outputs: Vec<Value>,
    /// Per output, where it is kept as a count: that.
    pub(crate) counts: Vec<Option<Value>>,
    /// Per output: whether a sample was accepted.
    pub(crate) good: Vec<Value>,
    /// Inputs and nonlinear terms.
    pub(crate) known: Known<'a>,
    /// Per term.
    pub(crate) signals: Vec<Value>,
    /// Whether the estimate is lost with a sample that is missing.
    pub(crate) lost: Value,
    /// Whether so many samples of an output were rejected that the observer starts again with it; where that can be.
    pub(crate) again: Option<Value>,
    /// Calls since a sample was accepted, where that is asked for.
    pub(crate) coasted: Option<Value>,
}

/// Reads a call; `why` says what a prediction is for.
pub(crate) fn read<'a, E: Foretells<'a>>(e: &mut E, sensors: &Sensors<'a>, why: Option<&str>) -> Reading<'a> {
    let mut reader = Reader { e, sensors };
    let (mut measured, mut good, mut known) = reader.samples();
    if let Some(why) = why {
        reader.e.builder().section(why);
    }
    known.before_the_samples(reader.e.builder(), sensors);
    let foretold = reader.e.foretells(&known);
    let (candidates, again) = match &foretold {
        Some(foretold) => {
            reader.unfold(foretold, &mut measured);
            let again = reader.doubt(foretold, &measured, &mut good);
            (reader.candidates(foretold, &measured, &good), again)
        }
        None => (measured.clone(), None),
    };
    known.with_the_samples(reader.e.builder(), sensors, &candidates);
    let (mut lost, mut outputs, mut counts) = (Vec::new(), Vec::new(), Vec::new());
    for (o, candidate) in candidates.into_iter().enumerate() {
        let foretold = foretold.as_ref().map(|foretold| foretold[o]);
        let settled = foretold.and_then(|foretold| reader.settle(o, (measured[o], good[o]), &known, foretold));
        let (output, count, astray) = settled.map_or((candidate, None, None), |(o, c, lost)| (o, c, Some(lost)));
        outputs.push(output);
        counts.push(count);
        lost.extend(astray);
    }
    let replaced: Vec<bool> = (0..outputs.len()).map(|o| reader.e.stands_in(o).is_some()).collect();
    let present = reader.e.present(&good);
    let b = reader.e.builder();
    for ((o, counter), good) in sensors.counters.iter().enumerate().zip(&good) {
        if let Some(counter) = counter {
            counter.keep(b, o, *good);
        }
    }
    let coasted = sensors.coasted.map(|cell| coasting::count(b, cell, &good));
    lost.extend(abandoned(b, &sensors.missed, &present, &replaced));
    let (lost, signals) = (any(b, &lost), known.all());
    Reading { outputs, counts, good, known, signals, lost, again, coasted }
}

struct Reader<'r, 'a, E> {
    e: &'r mut E,
    sensors: &'r Sensors<'a>,
}

impl<'a, E: Foretells<'a>> Reader<'_, 'a, E> {
    /// The samples without the inputs that they have in them, which are good, and the inputs.
    fn samples(&mut self) -> (Vec<Value>, Vec<Value>, Known<'a>) {
        let (plant, ranges) = (self.sensors.plant, &self.sensors.guard.outputs);
        let (b, counters) = (self.e.builder(), &self.sensors.counters);
        let read: Vec<_> =
            ranges.iter().enumerate().map(|(o, range)| front::read(b, plant, o, counters[o], *range)).collect();
        let known = Known::inputs(b, self.sensors);
        let inputs = &known.injections.inputs;
        let bare = read.into_iter().zip(ranges).enumerate();
        let (measured, mut good): (Vec<Value>, Vec<Value>) =
            bare.map(|(o, (sample, range))| front::without_inputs(b, plant, o, sample, inputs, *range)).unzip();
        self.e.screen(&mut good);
        (measured, good, known)
    }

    /// Samples of outputs that wrap, as near as their angles come to what stands in for them.
    fn unfold(&mut self, foretold: &[Foretold], measured: &mut [Value]) {
        if !self.e.unfolds() {
            return;
        }
        let plant = self.sensors.plant;
        for (o, output) in plant.outputs.iter().enumerate().filter(|(_, output)| output.wrap.is_some()) {
            let last = self.e.last(o, self.sensors.outputs[o], self.sensors.newest);
            let near = self.word(o, foretold[o], last).map_or(last, |word| word.value);
            let b = self.e.builder();
            let off = b.sub(measured[o], near);
            let off = front::folded(b, output, off, plant.scalar);
            measured[o] = b.add(near, off);
        }
    }

    /// Takes from `good` what is further from its place than its gate; whether one output has lost patience.
    fn doubt(&mut self, foretold: &[Foretold], measured: &[Value], good: &mut [Value]) -> Option<Value> {
        let mut again = Vec::new();
        for (o, good) in good.iter_mut().enumerate() {
            let sensors = self.sensors;
            let (Some(gate), Some(rejected)) = (&sensors.plant.outputs[o].gate, sensors.rejected[o]) else { continue };
            let known = self.e.believed(o);
            let distance = self.distance(o, measured[o], foretold[o]);
            let (low, high) = sensors.guard.outputs[o];
            let b = self.e.builder();
            let usable = b.in_range(foretold[o].place, low, high);
            let look = Look { gate, rejected, patience: sensors.patience, distance, known, usable };
            let (still, jumped) = look.judge(b, sensors.plant, *good);
            *good = still;
            again.push(jumped);
        }
        (!again.is_empty()).then(|| any(self.e.builder(), &again))
    }

    /// How far a sample is from its place; of a counter, in counts, so that nothing is lost however far it has counted.
    fn distance(&mut self, output: usize, measured: Value, foretold: Foretold) -> Value {
        let (sensors, b) = (self.sensors, self.e.builder());
        let plant = sensors.plant;
        let distance = match sensors.outputs[output].count(b, self.sensors.newest) {
            Some((last, counts)) => {
                let now = b.read_count(place(output));
                let moved = counts.moved(b, now, last);
                b.sub(moved, foretold.further)
            }
            None => b.sub(measured, foretold.place),
        };
        front::folded(b, &plant.outputs[output], distance, plant.scalar)
    }

    /// Per output, what nonlinear terms are evaluated with.
    fn candidates(&mut self, foretold: &[Foretold], measured: &[Value], good: &[Value]) -> Vec<Value> {
        let mut candidates = Vec::new();
        for (o, foretold) in foretold.iter().enumerate() {
            let last = self.e.last(o, self.sensors.outputs[o], self.sensors.newest);
            let instead = self.word(o, *foretold, last).map_or(last, |word| word.value);
            candidates.push(self.e.builder().select(good[o], measured[o], instead));
        }
        candidates
    }

    /// What stands in for a sample, where something does.
    fn word(&mut self, output: usize, foretold: Foretold, last: Value) -> Option<Word> {
        let (low, high) = self.sensors.guard.outputs[output];
        let known = self.e.stands_in(output)?;
        let b = self.e.builder();
        let sane = b.in_range(foretold.place, low, high);
        let usable = b.and(known, sane);
        let (value, usable) = self.e.instead(output, (foretold.place, usable), last);
        Some(Word { value, known, sane, usable })
    }

    /// What stands for an output with everything known, its count where it is kept as one, and whether the estimate is
    /// lost with it.
    fn settle(
        &mut self,
        output: usize,
        (measured, good): (Value, Value),
        known: &Known,
        foretold: Foretold,
    ) -> Option<(Value, Option<Value>, Value)> {
        let settled = self.e.settles(output, known, foretold)?;
        let last = self.e.last(output, self.sensors.outputs[output], self.sensors.newest);
        let word = self.word(output, settled, last)?;
        let lost = self.e.lost(good, &word);
        let b = self.e.builder();
        if let Some((last, counts)) = self.sensors.outputs[output].count(b, self.sensors.newest) {
            // The count that is nearest to so much further than the last one.
            let now = b.read_count(place(output));
            let foretold = counts.further(b, last, settled.further);
            let instead = b.select(word.usable, foretold, last);
            let count = b.select(good, now, instead);
            return Some((counts.place(b, count), Some(count), lost));
        }
        Some((b.select(good, measured, word.value), None, lost))
    }
}
