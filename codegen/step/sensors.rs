//! The sensors of a plant as a step reads them: what is asked of them, and where their last values stand.

use crate::plant::Plant;
use crate::program::builder::Builder;
use crate::program::{CellId, Field, Value};
use crate::sampled::Source;

use super::front;
use super::front::counts::Counts;
use super::guard::Guard;
use super::injections::Injections;
use super::kept::Kept;
use super::known::Term;
use super::report::field;

/// What a reading goes by.
#[derive(Clone)]
pub(crate) struct Sensors<'a> {
    pub(crate) plant: &'a Plant,
    pub(crate) guard: Guard,
    /// The inputs and nonlinear terms that the estimator asks for.
    pub(crate) terms: Vec<Term>,
    /// During a call, the slot of the newest values, where they stand in windows.
    pub(crate) newest: Option<Value>,
    /// Per output: the counter whose counts are taken as they come.
    pub(crate) counters: Vec<Option<Counts>>,
    /// Per output: what stood for it.
    pub(crate) outputs: Vec<Kept>,
    /// Per term: its values.
    pub(crate) values: Vec<Kept>,
    /// Per input: the last good value, where it is no term.
    pub(crate) inputs: Vec<CellId>,
    /// Calls since init.
    pub(crate) calls: CellId,
    /// Per output, where it matters that one is gone while others are not: calls missing in a row, and how many are
    /// too many.
    pub(crate) missed: Vec<(CellId, u32)>,
    /// Per output with a gate: samples rejected in a row.
    pub(crate) rejected: Vec<Option<CellId>>,
    /// Rejected samples in a row that are no accident, where a gate does not say how many.
    pub(crate) patience: u32,
    /// Calls since a sample was accepted, where they are asked for.
    pub(crate) coasted: Option<CellId>,
}

impl<'a> Sensors<'a> {
    /// Where the values of an input stand that is a term.
    pub(crate) fn input(&self, input: usize) -> Option<Kept> {
        let term = self.terms.iter().position(|term| term.source == Source::Input(input))?;
        Some(self.values[term])
    }

    /// Whether any output has a gate.
    pub(crate) fn gated(&self) -> bool {
        self.rejected.iter().any(Option::is_some)
    }

    /// What a term brought at the last call; at the first one, before which nothing is known of it, an input that runs
    /// straight is taken to have been what it is.
    pub(crate) fn begun(&self, b: &mut Builder, term: usize, now: Value) -> Value {
        let before = self.values[term].newest(b, self.newest);
        if !(self.terms[term].ramps && self.plant.init_at) {
            return before;
        }
        let (calls, none) = (b.read(self.calls), b.index(0));
        let first = b.index_equal(calls, none);
        b.select(first, now, before)
    }

    /// The nonlinear terms with the inputs of this call.
    pub(crate) fn injections(&self, inputs: &[Value]) -> Injections<'a> {
        Injections::new(self.plant, self.calls, inputs.to_vec())
    }

    /// Counts the call.
    pub(crate) fn count_call(&self, b: &mut Builder) {
        let calls = b.read(self.calls);
        let calls = b.count_up(calls, u32::MAX);
        b.set(self.calls, calls);
    }
}

/// The counters of a plant, with what is kept of them.
pub(crate) fn counters(b: &mut Builder, plant: &Plant) -> Vec<Option<Counts>> {
    plant.outputs.iter().map(|output| Counts::declare(b, plant, output)).collect()
}

/// Declares what the caller hands over: samples, their ages where they come with them, inputs.
pub(crate) fn declare(b: &mut Builder, plant: &Plant) {
    for output in &plant.outputs {
        b.measurement(front::measurement(output));
    }
    for output in plant.outputs.iter().filter(|output| output.aged.is_some()) {
        b.measurement(field(&format!("{}_age", output.label.name), "s", "how old the sample is"));
    }
    for input in &plant.inputs {
        let input: Field = field(&input.label.name, &input.label.unit, &input.label.doc);
        b.input(input);
    }
}
