//! Which samples may enter the state: bounds such that nothing computed from them overflows.
//!
//! Every sum of a step is at most its gain times the largest sample. With samples within
//! [`Guard::bound`], a power of ten, every partial sum in any order stays below a sixteenth of the
//! largest float, far beyond any physical quantity.

use crate::diagnostic::{Diagnostic, codes};
use crate::expr::bounds::Interval;
use crate::expr::{Constant, Function, Node, NodeKind, Symbol};
use crate::plant::{Output, Plant};
use crate::program::Scalar;

use super::injections::scale_of;
use crate::sampled::settled::round;

/// Bounds on what may enter the state.
#[derive(Clone, Debug)]
pub struct Guard {
    /// On inputs, injections and outputs without a range.
    pub bound: f64,
    /// Per output.
    pub outputs: Vec<(f64, f64)>,
    /// Per injection: whether it can pass the bound or be no number, and must be looked at.
    pub injections: Vec<bool>,
}

impl Guard {
    /// Finds the bound from the largest sums of a step for samples of magnitude 1: of samples, and of products of two; a
    /// range that the target's floats cannot hold is an error.
    pub(crate) fn with_gain(plant: &Plant, gain: f64, square: f64) -> Result<Self, Vec<Diagnostic>> {
        let (largest, exponents) = match plant.scalar {
            Scalar::F32 => (f64::from(f32::MAX), 0..=37),
            Scalar::F64 => (f64::MAX, 0..=307),
        };
        let gain = gain.max(largest_sample(plant));
        let powers = exponents.rev().map(|e| format!("1e{e}").parse::<f64>().unwrap_or(1.0));
        let bound = powers.map(|b| plant.scalar_value(b)).find(|b| 16.0 * b * (gain + b * square) <= largest);
        let Some(bound) = bound else {
            let gain = gain.max(square);
            let message = format!("the gains, up to {gain:.1e}, are too large for {}", plant.scalar);
            let error = Diagnostic::error(codes::OUT_OF_RANGE, plant.span.clone(), message).measured(gain);
            let help = match plant.scalar {
                Scalar::F32 => "a longer window, states in larger units, or `scalar = \"f64\"`",
                Scalar::F64 => "a longer window, or states in larger units",
            };
            return Err(vec![error.help(help)]);
        };
        let mut found = Vec::new();
        let outputs: Vec<(f64, f64)> =
            plant.outputs.iter().map(|o| output_range(plant, o, bound, &mut found)).collect();
        if !found.is_empty() {
            return Err(found);
        }
        let ranges = Ranges { plant, bound, outputs: &outputs, largest };
        let needs = |node: &Node| ranges.enclose(node).is_none_or(|range| range.magnitude() > bound);
        let injections = plant.injections.iter().map(|injection| needs(&injection.node)).collect();
        Ok(Self { bound, outputs, injections })
    }
}

pub(crate) fn lost(plant: &Plant, what: &str, weight: f64) -> Diagnostic {
    let message = format!("a weight of the design is too {what} for {}", plant.scalar);
    Diagnostic::error(codes::OUT_OF_RANGE, plant.span.clone(), message)
        .label(format!("this design has {weight:.1e}"))
        .measured(weight)
        .help("choose units in which states and outputs have similar sizes, or write `scalar = \"f64\"`")
}

fn output_range(plant: &Plant, output: &Output, bound: f64, found: &mut Vec<Diagnostic>) -> (f64, f64) {
    let (low, high) = match (&output.wrap, &output.range) {
        // What is folded is within half a turn, but for rounding; the declared range is of the sample before that.
        (Some(wrap), _) => (-round(&wrap.turn, plant.scalar), round(&wrap.turn, plant.scalar)),
        (None, Some((low, high))) => (round(low, plant.scalar), round(high, plant.scalar)),
        (None, None) => return (-bound, bound),
    };
    if !(low >= -bound && high <= bound) {
        let (span, what, help) = match &output.wrap {
            Some(wrap) => {
                (wrap.span.clone(), "a turn", "write the output, and the states that it shows, in a larger unit")
            }
            None => (output.range_span.clone(), "the range", "narrow the range to what the sensor can show"),
        };
        let message = format!("{what} of `{}` is wider than can be computed with", output.label.name);
        let error = Diagnostic::error(codes::OUT_OF_RANGE, span, message);
        found.push(error.label(format!("at most ±{bound:.0e} in {}", plant.scalar)).help(help));
    }
    (low, high)
}

/// The largest magnitude of a sample without what inputs and constants it has in it, for both of magnitude 1.
fn largest_sample(plant: &Plant) -> f64 {
    let size = |constant: &Constant| constant.to_f64().unwrap_or(0.0).abs();
    let sum = |output: &Output| {
        1.0 + output.feedthrough.iter().map(size).sum::<f64>() + output.shift().as_ref().map_or(0.0, size)
    };
    plant.outputs.iter().map(sum).fold(1.0, f64::max)
}

/// Between which numbers the steps of an injection's evaluation stay.
struct Ranges<'a> {
    plant: &'a Plant,
    bound: f64,
    outputs: &'a [(f64, f64)],
    largest: f64,
}

impl Ranges<'_> {
    /// `None` when a step may overflow or leave a function's domain.
    fn enclose(&self, node: &Node) -> Option<Interval> {
        let range = match &node.kind {
            NodeKind::Constant => {
                let constant = crate::expr::Constant::try_from(node.poly.clone()).ok()?;
                Interval::point(constant.to_f64().ok()?)
            }
            NodeKind::Symbol(symbol) => self.symbol(*symbol),
            NodeKind::Sum(terms) => self.parts(terms, Interval::point(0.0), |sum, minus, term| {
                sum.plus(if minus { term.times(Interval::point(-1.0)) } else { term })
            })?,
            NodeKind::Product(factors) => self.product(factors)?,
            NodeKind::Power(base, n) => {
                let base = self.enclose(base)?;
                base.power(*n)
            }
            NodeKind::Call(function, arguments) => self.call(*function, arguments)?,
        };
        (range.magnitude() * 2.0 < self.largest).then_some(range)
    }

    fn parts(
        &self,
        parts: &[(bool, Node)],
        start: Interval,
        join: impl Fn(Interval, bool, Interval) -> Interval,
    ) -> Option<Interval> {
        let mut whole = start;
        for (flag, part) in parts {
            whole = join(whole, *flag, self.enclose(part)?);
            if whole.magnitude() * 2.0 >= self.largest {
                return None;
            }
        }
        Some(whole)
    }

    /// The constant factors first, in one, and then the others, as the step multiplies them.
    fn product(&self, factors: &[(bool, Node)]) -> Option<Interval> {
        let (scale, varying) = scale_of(factors);
        let mut product = Interval::point(scale.to_f64().ok()?);
        for (divided, factor) in varying {
            if *divided {
                return None;
            }
            product = product.times(self.enclose(factor)?);
            if product.magnitude() * 2.0 >= self.largest {
                return None;
            }
        }
        Some(product)
    }

    fn call(&self, function: Function, arguments: &[Node]) -> Option<Interval> {
        let ranges = arguments.iter().map(|a| self.enclose(a)).collect::<Option<Vec<_>>>()?;
        match function {
            Function::Sin | Function::Cos | Function::Tanh | Function::Sign => Some(Interval::new(-1.0, 1.0)),
            Function::Atan | Function::Atan2 => Some(Interval::new(-4.0, 4.0)),
            Function::Abs => Some(Interval::new(0.0, ranges[0].magnitude())),
            Function::Min | Function::Max => {
                Some(Interval::new(ranges[0].low.min(ranges[1].low), ranges[0].high.max(ranges[1].high)))
            }
            Function::Exp => Some(Interval::new(0.0, deadbeat_math::exp_f64(ranges[0].high))),
            Function::Exp2 => Some(Interval::new(0.0, deadbeat_math::pow_f64(2.0, ranges[0].high))),
            Function::Cosh | Function::Sinh => {
                let most = deadbeat_math::exp_f64(ranges[0].magnitude());
                Some(Interval::new(-most, most))
            }
            // Three times the square of the root, and one more, are below the argument where that is large.
            Function::Cbrt | Function::Floor => {
                let most = 3.0 * (ranges[0].magnitude() + 9.0);
                Some(Interval::new(-most, most))
            }
            Function::Hypot => Some(Interval::new(0.0, 2.0 * (ranges[0].magnitude() + ranges[1].magnitude()))),
            Function::Tan
            | Function::Asin
            | Function::Acos
            | Function::Log
            | Function::Log10
            | Function::Log2
            | Function::Sqrt
            | Function::Pow => None,
        }
    }

    fn symbol(&self, symbol: Symbol) -> Interval {
        match symbol {
            Symbol::Time => Interval::new(0.0, 4_294_967_296.0 * self.plant.sample_time_s()),
            Symbol::State(j) => self.plant.states[j].measured.iter().fold(Interval::point(0.0), |sum, (o, weight)| {
                let (low, high) = self.outputs[*o];
                sum.plus(Interval::new(low, high).times(Interval::point(weight.to_f64().unwrap_or(0.0))))
            }),
            _ => Interval::new(-self.bound, self.bound),
        }
    }
}
