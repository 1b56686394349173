//! Injections as operations: the user's own form, with its constants folded and rounded once.

use crate::diagnostic::{Diagnostic, codes};
use crate::expr::{Constant, Function, Node, NodeKind, Poly, Symbol};
use crate::plant::{Output, Plant};
use crate::program::builder::Builder;
use crate::program::{self, CellId, Scalar, Value};
use crate::sampled::settled::round;

use super::composed;

/// When an injection is evaluated.
pub enum Moment {
    /// With the samples of this call.
    Now,
    /// With the samples of so many calls before.
    Ago(u32),
    /// In a start, with what a given state shows: one call before the first.
    Given,
}

/// The samples that an injection is evaluated with, by output.
#[derive(Clone, Copy)]
pub enum Samples<'a> {
    /// At hand.
    These(&'a [Value]),
    /// To be read from where they are kept.
    Kept(&'a dyn Fn(&mut Builder, usize) -> Value),
}

/// What injections are evaluated from.
pub struct Injections<'a> {
    plant: &'a Plant,
    calls: CellId,
    /// Per input: the value used in this call.
    pub inputs: Vec<Value>,
}

/// The sample that a measured output would show at the initial state.
pub fn initial_output(plant: &Plant, output: usize, scalar: Scalar) -> f64 {
    let mut sum = Poly::default();
    for (state, c) in plant.states.iter().zip(&plant.c[output]) {
        let product = c.poly().times(state.initial.poly()).unwrap_or_default();
        sum = sum.plus(&product).unwrap_or_default();
    }
    let value = Constant::try_from(sum).map_or(0.0, |constant| round(&constant, scalar));
    let turn = plant.outputs[output].wrap.as_ref().map(|wrap| round(&wrap.turn, scalar));
    // What only fills the buffer need not be further away than folded samples are.
    let far = turn.is_some_and(|turn| value.abs() > turn / 2.0);
    if value.is_finite() && !far { value } else { 0.0 }
}

/// Whether an injection is evaluated with an output's samples.
pub fn needed(plant: &Plant, output: usize) -> bool {
    let shows = |symbol: &Symbol| match symbol {
        Symbol::State(j) => plant.states[*j].measured.iter().any(|(o, _)| *o == output),
        _ => false,
    };
    plant.injections.iter().any(|injection| injection.symbols().iter().any(shows))
}

/// Refuses constants of the injections and of the start that the target's floats cannot hold.
pub fn check(plant: &Plant) -> Result<(), Vec<Diagnostic>> {
    let mut found = Vec::new();
    let mut refuse = |constant: &Constant, span: &std::ops::Range<usize>| {
        let value = round(constant, plant.scalar);
        if value.is_nan() {
            found.push(
                Diagnostic::error(codes::DOMAIN, span.clone(), "a constant in this has no usable value")
                    .label("a division by zero, or a root of rounding"),
            );
        } else if !value.is_finite() {
            let size = constant.to_f64().unwrap_or(f64::INFINITY);
            let message = format!("a constant is too large for {}", plant.scalar);
            let error = Diagnostic::error(codes::OUT_OF_RANGE, span.clone(), message).measured(size);
            let help = if plant.scalar == Scalar::F32 {
                "write `scalar = \"f64\"`, or scale the states"
            } else {
                "scale the states"
            };
            found.push(error.label(format!("this has {size:e} in it")).help(help));
        }
    };
    for injection in &plant.injections {
        constants(&injection.node, &mut |constant| refuse(constant, &injection.node.span));
    }
    for state in &plant.states {
        refuse(&state.initial, &state.label.span);
        state.measured.iter().for_each(|(_, weight)| refuse(weight, &state.label.span));
    }
    for output in &plant.outputs {
        let turn = output.wrap.as_ref().map(|wrap| &wrap.turn);
        let gate = output.gate.as_ref().map(|gate| &gate.size);
        let shift = output.shift();
        let all = [turn, gate, output.quantum.as_ref(), shift.as_ref()].into_iter().flatten();
        all.chain(&output.feedthrough).for_each(|constant| refuse(constant, &output.label.span));
    }
    refuse(&plant.sample_time.0, &plant.sample_time.1);
    found.extend(plant.outputs.iter().filter_map(|output| lost_in_division(plant, output)));
    if found.is_empty() { Ok(()) } else { Err(found) }
}

/// Refuses a turn, or one count, whose reciprocal the target's floats cannot hold.
fn lost_in_division(plant: &Plant, output: &Output) -> Option<Diagnostic> {
    let turn = output.wrap.as_ref().map(|wrap| (&wrap.turn, "turn"));
    let count = output.quantum.as_ref().map(|quantum| (quantum, "count"));
    let (size, what) = turn.into_iter().chain(count).find(|(size, _)| {
        let reciprocal = plant.scalar_value(1.0 / round(size, plant.scalar));
        !reciprocal.is_finite()
    })?;
    let size = size.to_f64().unwrap_or(0.0);
    let message = format!("one {what} of `{}` is too small for {}", output.label.name, plant.scalar);
    let error = Diagnostic::error(codes::OUT_OF_RANGE, output.label.span.clone(), message).measured(size);
    Some(error.label(format!("it is {size:e}")).help("give the output, and the states that it shows, a smaller unit"))
}

/// Visits the constants that the evaluation of a node will carry.
fn constants(node: &Node, visit: &mut dyn FnMut(&Constant)) {
    match &node.kind {
        NodeKind::Constant => visit(&constant_of(node)),
        NodeKind::Symbol(_) => {}
        NodeKind::Sum(parts) => parts.iter().for_each(|(_, part)| constants(part, visit)),
        NodeKind::Product(factors) => {
            let (scale, varying) = scale_of(factors);
            visit(&scale);
            for (_, factor) in varying {
                constants(factor, visit);
            }
        }
        NodeKind::Power(base, _) => constants(base, visit),
        NodeKind::Call(_, arguments) => arguments.iter().for_each(|a| constants(a, visit)),
    }
}

fn constant_of(node: &Node) -> Constant {
    Constant::try_from(node.poly.clone()).unwrap_or_else(|_| unreachable!("a constant node is constant"))
}

/// The product of a product's constant factors, exactly, and the other factors.
pub(super) fn scale_of(factors: &[(bool, Node)]) -> (Constant, Vec<&(bool, Node)>) {
    let mut scale = Poly::from(crate::real::Rational::ONE);
    let mut varying = Vec::new();
    for factor in factors {
        let (divided, node) = factor;
        let product = match node.kind {
            NodeKind::Constant if *divided => node.poly.reciprocal().and_then(|r| scale.times(&r)),
            NodeKind::Constant => scale.times(&node.poly),
            _ => {
                varying.push(factor);
                continue;
            }
        };
        match product {
            Ok(product) => scale = product,
            Err(_) => varying.push(factor),
        }
    }
    (Constant::try_from(scale).unwrap_or_else(|_| unreachable!("constants times constants")), varying)
}

impl<'a> Injections<'a> {
    /// Injections of a plant, with the inputs of this call.
    pub fn new(plant: &'a Plant, calls: CellId, inputs: Vec<Value>) -> Self {
        Self { plant, calls, inputs }
    }

    /// Evaluates an injection with the samples that the moment asks for, by output.
    pub fn evaluate(&self, b: &mut Builder, k: usize, moment: &Moment, samples: Samples) -> Value {
        let place = Place { of: self, moment, samples };
        place.node(b, &self.plant.injections[k].node)
    }
}

/// Where and when a node is evaluated.
struct Place<'a> {
    of: &'a Injections<'a>,
    moment: &'a Moment,
    samples: Samples<'a>,
}

impl Place<'_> {
    fn node(&self, b: &mut Builder, node: &Node) -> Value {
        match &node.kind {
            NodeKind::Constant => self.constant(b, &constant_of(node)),
            NodeKind::Symbol(symbol) => self.symbol(b, *symbol),
            NodeKind::Sum(terms) => self.sum(b, terms),
            NodeKind::Product(factors) => self.product(b, factors),
            NodeKind::Power(base, n) => {
                let base = self.node(b, base);
                b.power(base, *n)
            }
            NodeKind::Call(function, arguments) => self.call(b, *function, arguments),
        }
    }

    fn constant(&self, b: &mut Builder, constant: &Constant) -> Value {
        b.float(round(constant, self.of.plant.scalar))
    }

    fn symbol(&self, b: &mut Builder, symbol: Symbol) -> Value {
        match symbol {
            Symbol::Time => self.time(b),
            Symbol::Input(u) => self.of.inputs[u],
            Symbol::State(j) => self.state(b, j),
            Symbol::Unknown(_) | Symbol::Disturbance(_) => unreachable!("an injection is of known quantities"),
        }
    }

    /// Calls since init times the sample time.
    fn time(&self, b: &mut Builder) -> Value {
        if matches!(self.moment, Moment::Given) {
            let h = self.constant(b, &self.of.plant.sample_time.0);
            return b.neg(h);
        }
        let calls = b.read(self.of.calls);
        let calls = match self.moment {
            Moment::Now | Moment::Given => calls,
            Moment::Ago(past) => (0..*past).fold(calls, |calls, _| b.count_down(calls)),
        };
        let calls = b.to_float(calls);
        let h = self.constant(b, &self.of.plant.sample_time.0);
        b.mul(calls, h)
    }

    /// A measured state from the samples.
    fn state(&self, b: &mut Builder, j: usize) -> Value {
        let weights = &self.of.plant.states[j].measured;
        let mut terms = Vec::new();
        for (o, weight) in weights {
            let sample = match self.samples {
                Samples::These(values) => values[*o],
                Samples::Kept(read) => read(b, *o),
            };
            let weight = self.constant(b, weight);
            terms.push(b.mul(weight, sample));
        }
        b.sum(&terms)
    }

    fn sum(&self, b: &mut Builder, terms: &[(bool, Node)]) -> Value {
        let mut sum = None;
        for (minus, term) in terms {
            let value = self.node(b, term);
            sum = Some(match (sum, minus) {
                (None, false) => value,
                (None, true) => b.neg(value),
                (Some(sum), false) => b.add(sum, value),
                (Some(sum), true) => b.sub(sum, value),
            });
        }
        sum.unwrap_or_else(|| b.float(0.0))
    }

    fn product(&self, b: &mut Builder, factors: &[(bool, Node)]) -> Value {
        let (scale, varying) = scale_of(factors);
        let mut product = self.constant(b, &scale);
        for (divided, factor) in varying {
            let value = self.node(b, factor);
            product = if *divided { b.div(product, value) } else { b.mul(product, value) };
        }
        product
    }

    fn call(&self, b: &mut Builder, function: Function, arguments: &[Node]) -> Value {
        let values: Vec<Value> = arguments.iter().map(|a| self.node(b, a)).collect();
        if let Some(value) = composed::call(b, function, &values) {
            return value;
        }
        let runtime = match function {
            Function::Abs => return b.absolute(values[0]),
            Function::Sign => return b.sign(values[0]),
            Function::Min => return b.minimum(values[0], values[1]),
            Function::Max => return b.maximum(values[0], values[1]),
            Function::Sin => program::Function::Sin,
            Function::Cos => program::Function::Cos,
            Function::Tan => program::Function::Tan,
            Function::Asin => program::Function::Asin,
            Function::Acos => program::Function::Acos,
            Function::Atan => program::Function::Atan,
            Function::Atan2 => program::Function::Atan2,
            Function::Exp => program::Function::Exp,
            Function::Log => program::Function::Log,
            Function::Sqrt => program::Function::Sqrt,
            Function::Tanh => program::Function::Tanh,
            Function::Pow => program::Function::Pow,
            _ => unreachable!("the others are composed"),
        };
        b.call(runtime, &values)
    }
}
