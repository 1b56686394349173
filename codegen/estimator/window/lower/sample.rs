//! What a window foretells of its outputs, and what a call's samples are worth to it.

use crate::program::Value;
use crate::program::builder::Builder;
use crate::step::known::Known;
use crate::step::logic::all;
use crate::step::reading::{self, Foretells, Foretold, Reading};
use crate::step::sensors::Sensors;

use super::{Lowering, Sampled, There, late_len};

impl<'a> Lowering<'a> {
    /// Reads a call whose missing samples are predicted.
    pub(crate) fn sample(&mut self) -> Sampled<'a> {
        self.builder.section("samples: outside its range, infinite or NaN means missing");
        let before = self.before();
        let count = self.builder.read(self.cells.count);
        self.had_converged(count, 1);
        let sensors = self.sensors(before);
        let reading = reading::read(self, &sensors, Some("prediction, for a sample that is missing"));
        let expected = self.expected(&reading.good, count);
        let (late, on_time): (Vec<_>, Vec<_>) =
            expected.into_iter().enumerate().partition(|(o, _)| self.functional.delays[*o] > 0);
        let on_time: Vec<Value> = on_time.into_iter().map(|(_, good)| good).collect();
        let newest = self.builder.advance(before, self.kept());
        self.worth(reading, newest, (&on_time, late), There::default())
    }

    /// What a call is worth; `on_time` and `late` say which samples were good, or missing as foreseen.
    pub(super) fn worth(
        &mut self,
        reading: Reading<'a>,
        newest: Value,
        (on_time, late): (&[Value], Vec<(usize, Value)>),
        there: There,
    ) -> Sampled<'a> {
        let b = &mut self.builder;
        let of_now: Vec<Value> = on_time.iter().copied().chain(reading.known.of_sample()).collect();
        let newest_good = all(b, &of_now);
        let samples_good = late.iter().fold(newest_good, |all, (_, good)| b.and(all, *good));
        let interval_good = all(b, &reading.known.of_interval());
        Sampled { reading, newest, samples_good, interval_good, newest_good, late, there }
    }

    /// Whether each sample is good, or missing as measurements at irregular times are.
    pub(super) fn expected(&mut self, good: &[Value], count: Value) -> Vec<Value> {
        let Some(gaps) = self.functional.gaps else { return good.to_vec() };
        // Predictions need a first sample; a solve over what is there does not.
        let started =
            if self.functional.irregular.is_some() { self.builder.boolean(true) } else { self.counted(count, 1) };
        let most = super::bounded(gaps.most);
        let mut expected = Vec::new();
        for (good, cell) in good.iter().zip(self.cells.gaps.clone()) {
            let before = self.builder.read(cell);
            let more = self.builder.count_up(before, most);
            let none = self.builder.index(0);
            let missing = self.builder.select(*good, none, more);
            self.builder.set(cell, missing);
            let longest = self.builder.index(most);
            let within = self.builder.index_less(missing, longest);
            let foreseen = self.builder.and(started, within);
            expected.push(self.builder.or(*good, foreseen));
        }
        expected
    }

    /// The sensors, with where their newest values stand.
    pub(super) fn sensors(&self, before: Value) -> Sensors<'a> {
        Sensors { newest: Some(before), ..self.sensors.clone() }
    }

    /// Slot of the newest values before this call.
    pub(super) fn before(&mut self) -> Value {
        let before = self.builder.read(self.cells.newest);
        self.builder.at_most(before, self.kept() - 1)
    }

    /// Where an output is foretold to be, from what [`Lowering::predict`] says of it.
    fn at(&mut self, output: usize, further: Value) -> Foretold {
        let before = self.before();
        let last = self.sensors.outputs[output].read(&mut self.builder, before);
        Foretold { place: self.placed(output, further, last), further }
    }
}

impl<'a> Foretells<'a> for Lowering<'a> {
    fn builder(&mut self) -> &mut Builder {
        &mut self.builder
    }

    fn foretells(&mut self, known: &Known) -> Option<Vec<Foretold>> {
        let before = self.before();
        self.builder.advance(before, self.kept());
        let further: Vec<Value> = (0..self.plant.outputs.len()).map(|o| self.predict(o, &known.values)).collect();
        Some(further.into_iter().enumerate().map(|(o, further)| self.at(o, further)).collect())
    }

    /// A late sample is foretold from an estimate of some calls ago, which must have converged.
    fn believed(&mut self, output: usize) -> Value {
        let count = self.builder.read(self.cells.count);
        self.had_converged(count, late_len(self.functional, output).max(1))
    }

    fn settles(&mut self, output: usize, known: &Known, foretold: Foretold) -> Option<Foretold> {
        let before = self.before();
        let further = self.refine(output, foretold.further, &known.all(), before);
        Some(self.at(output, further))
    }
}
