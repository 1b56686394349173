//! The sums over the window: loops over tables of weights, newest sample first.
//!
//! Ages are cut into segments in which the same signals have weights. A segment of at least
//! [`SHORTEST_LOOP`] ages is a loop over a table whose rows are the ages; a shorter one is written
//! out. As long as there are few (state, signal) pairs, one loop serves all signals and each pair
//! has a sum of its own, so that the additions of one do not wait for those of another; else each
//! signal has its loop, and the sums of the states run through all of them.
//!
//! Of an output that wraps, differences to the newest sample are summed. Each is the one before it plus the step from
//! sample to sample, folded into half a turn, so that the output may turn any number of times within the window. Its
//! weights for a state add up to the direction of the turn: what is left out is that times the newest sample, whose own
//! weight is not needed.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use crate::plant::Plant;
use crate::program::Value;
use crate::program::builder::Builder;
use crate::step::front::counts::Counts;
use crate::step::front::fold;

use super::super::{Functional, Weights};
use crate::step::kept::Kept;

/// Ages from which on a loop is shorter than its contents.
const SHORTEST_LOOP: usize = 8;
/// Sums that run side by side; a Cortex-M4F has 32 float registers.
const MOST_SUMS: usize = 16;

/// One signal of the window.
struct Track<'a> {
    name: String,
    kept: Kept,
    weights: &'a Weights,
    anchor: Option<Anchor>,
}

/// What an output's samples are subtracted from.
#[derive(Clone, Copy, Debug)]
pub struct Anchor {
    /// The newest sample, as it is kept: a float, or a count.
    pub newest: Value,
    /// One turn, in the output's unit.
    pub turn: f64,
}

impl Track<'_> {
    /// The ages whose samples are summed.
    fn ages(&self) -> Range<usize> {
        let ages = self.weights.ages();
        if self.anchor.is_some() { ages.start.max(1)..ages.end.max(1) } else { ages }
    }

    /// At the newest sample of an output with an anchor.
    fn at_newest(&self, b: &mut Builder) -> Option<Moved> {
        self.anchor.map(|anchor| Moved { sample: anchor.newest, total: b.float(0.0) })
    }

    /// What is summed of the sample at a slot; `moved` is of the sample one call younger, and becomes that of this one.
    fn sample(&self, b: &mut Builder, slot: Value, moved: &mut Option<Moved>) -> Value {
        let (Some(anchor), Some(younger)) = (self.anchor, *moved) else { return self.kept.read(b, slot) };
        let counted: Option<(Value, Counts)> = self.kept.count(b, Some(slot));
        let (sample, step) = match counted {
            Some((count, counts)) => (count, counts.steps(b, count, younger.sample)),
            None => {
                let sample = self.kept.read(b, slot);
                let step = b.sub(sample, younger.sample);
                (sample, fold(b, step, anchor.turn))
            }
        };
        let total = b.add(younger.total, step);
        *moved = Some(Moved { sample, total });
        counted.map_or(total, |(_, counts)| counts.in_unit(b, total))
    }
}

/// How far an output that wraps was from its newest sample.
#[derive(Clone, Copy)]
struct Moved {
    /// As it is kept.
    sample: Value,
    /// In the output's unit, or in counts.
    total: Value,
}

/// Running sums by state and, where there are few, by track.
type Sums = BTreeMap<(usize, usize), Value>;

/// The estimate of each state from the whole window; rings of `len` samples hold it, or more than it. Of outputs with
/// an anchor it is less their newest sample times the direction of their turn.
pub fn estimate(
    b: &mut Builder,
    plant: &Plant,
    functional: &Functional,
    (outputs, signals): (&[Kept], &[Kept]),
    anchors: &[Option<Anchor>],
    (newest, len): (Value, u32),
) -> Vec<Value> {
    let measured = plant.outputs.iter().zip(&functional.outputs).zip(outputs.iter().zip(anchors));
    let known = functional.signals.iter().zip(&functional.knowns).zip(signals);
    let tracks: Vec<Track> = measured
        .map(|((output, weights), (kept, anchor))| {
            let name = output.label.name.clone();
            Track { name, kept: *kept, weights, anchor: *anchor }
        })
        .chain(known.map(|((signal, weights), kept)| Track {
            name: signal.text.clone(),
            kept: *kept,
            weights,
            anchor: None,
        }))
        .collect();
    let apart = pairs(&tracks) <= MOST_SUMS;
    let loops = if apart { 1 } else { tracks.len().max(1) };
    let mut sums = Sums::new();
    for tracks in tracks.chunks(tracks.len().div_ceil(loops).max(1)) {
        let moved = tracks.iter().map(|track| track.at_newest(b)).collect();
        let mut window = Window { plant, tracks, apart, sums, len, slot: newest, moved };
        for (begin, end) in segments(tracks) {
            if end - begin >= SHORTEST_LOOP {
                window.in_a_loop(b, begin, end);
            } else {
                window.written_out(b, begin, end);
            }
        }
        sums = window.sums;
    }
    (0..plant.states.len())
        .map(|i| {
            let mut terms: Vec<Value> = sums.iter().filter(|((state, _), _)| *state == i).map(|(_, v)| *v).collect();
            let constant = functional.constant[i].value(plant.scalar);
            if constant != 0.0 {
                terms.push(b.float(constant));
            }
            b.sum(&terms)
        })
        .collect()
}

fn pairs(tracks: &[Track]) -> usize {
    tracks.iter().map(|t| t.weights.columns.iter().flatten().count()).sum()
}

/// Ages between which no signal begins or ends.
fn segments(tracks: &[Track]) -> Vec<(usize, usize)> {
    let ends = tracks.iter().filter(|t| !t.ages().is_empty()).flat_map(|t| [t.ages().start, t.ages().end]);
    let ends: Vec<usize> = ends.chain([0]).collect::<BTreeSet<_>>().into_iter().collect();
    ends.windows(2).map(|pair| (pair[0], pair[1])).collect()
}

struct Window<'a> {
    plant: &'a Plant,
    tracks: &'a [Track<'a>],
    /// Whether each track has sums of its own.
    apart: bool,
    sums: Sums,
    /// Ring length.
    len: u32,
    /// Slot of the age that comes next.
    slot: Value,
    /// Per track with an anchor: of the age before it.
    moved: Vec<Option<Moved>>,
}

impl Window<'_> {
    fn key(&self, state: usize, track: usize) -> (usize, usize) {
        (state, if self.apart { track } else { 0 })
    }

    /// Tracks with weights at an age, each with its states.
    fn active(&self, age: usize) -> Vec<(usize, Vec<usize>)> {
        let states =
            |t: &Track| (0..self.plant.states.len()).filter(|i| t.weights.columns[*i].is_some()).collect::<Vec<_>>();
        let here = self.tracks.iter().enumerate().filter(|(_, t)| t.ages().contains(&age));
        here.map(|(place, t)| (place, states(t))).filter(|(_, states)| !states.is_empty()).collect()
    }

    fn weight(&self, track: usize, state: usize, age: usize) -> f64 {
        self.tracks[track].weights.at(state, age).value(self.plant.scalar)
    }

    fn written_out(&mut self, b: &mut Builder, begin: usize, end: usize) {
        for age in begin..end {
            for (track, states) in self.active(age) {
                let sample = self.tracks[track].sample(b, self.slot, &mut self.moved[track]);
                for state in states {
                    let weight = b.float(self.weight(track, state, age));
                    let product = b.mul(weight, sample);
                    let key = self.key(state, track);
                    let sum = self.sums.get(&key).map_or(product, |sum| b.add(*sum, product));
                    self.sums.insert(key, sum);
                }
            }
            self.slot = b.retreat(self.slot, self.len);
        }
    }

    fn in_a_loop(&mut self, b: &mut Builder, begin: usize, end: usize) {
        let active = self.active(begin);
        if active.is_empty() {
            (begin..end).for_each(|_| self.slot = b.retreat(self.slot, self.len));
            return;
        }
        let columns: Vec<(usize, usize)> =
            active.iter().flat_map(|(track, states)| states.iter().map(|state| (*track, *state))).collect();
        let docs = columns.iter().map(|(track, state)| {
            format!("{} from {}", self.plant.states[*state].label.name, self.tracks[*track].name)
        });
        let rows =
            (begin..end).map(|age| columns.iter().map(|(track, state)| self.weight(*track, *state, age)).collect());
        let doc = format!("weights by age, from age {begin}");
        let table = b.table("WINDOW", &doc, docs.collect(), rows.collect());
        let keys: Vec<(usize, usize)> = columns
            .iter()
            .map(|(track, state)| self.key(*state, *track))
            .collect::<BTreeSet<_>>()
            .into_iter()
            .collect();
        let mut starts: Vec<Value> =
            keys.iter().map(|key| self.sums.get(key).copied().unwrap_or_else(|| b.float(0.0))).collect();
        starts.push(self.slot);
        let anchored: Vec<usize> =
            active.iter().map(|(track, _)| *track).filter(|track| self.moved[*track].is_some()).collect();
        for moved in anchored.iter().filter_map(|track| self.moved[*track]) {
            starts.extend([moved.sample, moved.total]);
        }
        let (len, first) = (self.len, keys.len() + 1);
        let after = b.loop_over(table, &starts, |b, carried| {
            let slot = carried[keys.len()];
            let mut sums: Sums = keys.iter().copied().zip(carried.iter().copied()).collect();
            let mut moved = vec![None; self.tracks.len()];
            for (track, pair) in anchored.iter().zip(carried[first..].chunks(2)) {
                moved[*track] = Some(Moved { sample: pair[0], total: pair[1] });
            }
            let mut column = 0;
            for (track, states) in &active {
                let sample = self.tracks[*track].sample(b, slot, &mut moved[*track]);
                for state in states {
                    let weight = b.gain(column);
                    let product = b.mul(weight, sample);
                    let key = self.key(*state, *track);
                    let sum = b.add(sums[&key], product);
                    sums.insert(key, sum);
                    column += 1;
                }
            }
            let mut next: Vec<Value> = keys.iter().map(|key| sums[key]).collect();
            next.push(b.retreat(slot, len));
            for moved in anchored.iter().filter_map(|track| moved[*track]) {
                next.extend([moved.sample, moved.total]);
            }
            next
        });
        self.slot = after[keys.len()];
        for (track, pair) in anchored.iter().zip(after[first..].chunks(2)) {
            self.moved[*track] = Some(Moved { sample: pair[0], total: pair[1] });
        }
        self.sums.extend(keys.iter().copied().zip(after));
    }
}
