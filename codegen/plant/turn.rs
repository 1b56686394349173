//! Whether a plant does not change when an output jumps by a turn: exactly, by symbols.
//!
//! A turn w of output o is harmless if there is a direction s with `A s = 0` (discrete: `A s = s`), `C s = 1` for the
//! output and 0 for the others, such that no nonlinear term changes under `x -> x + w s`: the state moves along s
//! and nothing else tells the difference.

use crate::diagnostic::{Diagnostic, codes};
use crate::expr::poly::{Atom, Monomial, Poly, PolyError};
use crate::expr::{Constant, Function, List, Symbol};
use crate::real::Rational;

use super::elimination::reduce;
use super::sensor::{Sensor, Wrap};
use super::{Plant, moved};

/// The turn of an output, proven. Else why it is none.
pub(super) fn wrap(plant: &Plant, output: usize, sensor: &Sensor) -> Result<Option<Wrap>, Box<Diagnostic>> {
    let Some((turn, span)) = &sensor.turn else { return Ok(None) };
    let direction = direction(plant, output, turn, span)?;
    let wrap = Wrap { turn: turn.clone(), direction, span: span.clone() };
    match moved::besides(plant, output, &wrap).iter().find(|moved| !moved.turns) {
        Some(first) if !sensor.turn_moves => Err(Box::new(moved::refusal(plant, output, &wrap, first))),
        _ => Ok(Some(wrap)),
    }
}

/// The direction of a turn of an output, or why there is none: at the given place.
fn direction(
    plant: &Plant,
    output: usize,
    turn: &Constant,
    span: &std::ops::Range<usize>,
) -> Result<Vec<Constant>, Box<Diagnostic>> {
    let Some(direction) = linear(plant, output) else { return Err(Box::new(no_direction(plant, output, span))) };
    let moved: Result<Vec<Poly>, _> = direction.iter().map(|s| Ok(s.times(turn)?.poly().clone())).collect();
    let moved = moved.map_err(|_: PolyError| Box::new(refusal(plant, output, span).label("too large to tell")))?;
    let shift = Shift { moved: &moved };
    for injection in &plant.injections {
        if !shift.keeps(&injection.node.poly) {
            let label = format!(
                "`{}` is not the same a turn of `{}` further",
                injection.text, plant.outputs[output].label.name
            );
            return Err(Box::new(
                refusal(plant, output, span).label(label).context(injection.node.span.clone(), "this changes"),
            ));
        }
    }
    for unknown in &plant.unknowns {
        if unknown.gamma.iter().any(|factor| !shift.keeps(factor)) {
            let label = format!("the factor of `{}` is not the same a turn further", unknown.label.name);
            return Err(Box::new(refusal(plant, output, span).label(label)));
        }
    }
    Ok(direction)
}

fn refusal(plant: &Plant, output: usize, span: &std::ops::Range<usize>) -> Diagnostic {
    let message = format!("the plant changes when `{}` jumps by a turn", plant.outputs[output].label.name);
    let help = "leave `wrap` out and hand over an angle that counts turns, or write the model so that only differences \
                and periodic functions of the angle stand in it";
    Diagnostic::error(codes::METHOD_CANNOT, span.clone(), message).help(help)
}

/// Says which state the turn of an output moves, and what of the plant sees it.
fn no_direction(plant: &Plant, output: usize, span: &std::ops::Range<usize>) -> Diagnostic {
    let shown: Vec<usize> = (0..plant.states.len()).filter(|j| !plant.c[output][*j].is_zero()).collect();
    let names: Vec<&str> = shown.iter().map(|j| plant.states[*j].label.name.as_str()).collect();
    let others = |j: usize| (0..plant.outputs.len()).find(|o| *o != output && !plant.c[*o][j].is_zero());
    let label = if let Some(other) = shown.iter().find_map(|j| others(*j)) {
        format!("`{}` shows it too", plant.outputs[other].label.name)
    } else {
        let felt: Vec<&str> = (0..plant.states.len())
            .filter(|i| shown.iter().any(|j| !held(plant, *i, *j).is_zero()))
            .map(|i| plant.states[i].label.name.as_str())
            .collect();
        format!("{} stands in the equation of {} as it is", List(&names), List(&felt))
    };
    refusal(plant, output, span).label(label)
}

/// An entry of A, discrete of A - I.
fn held(plant: &Plant, i: usize, j: usize) -> Constant {
    let one = Constant::one();
    // What is too large to subtract from is not zero either.
    if plant.discrete && i == j { plant.a[i][j].minus(&one).unwrap_or(one) } else { plant.a[i][j].clone() }
}

/// s of the linear part: one state alone where that suffices, else by elimination where all is rational.
fn linear(plant: &Plant, output: usize) -> Option<Vec<Constant>> {
    let n = plant.states.len();
    let alone = |j: usize| {
        let unseen = (0..plant.outputs.len()).all(|o| (o == output) != plant.c[o][j].is_zero());
        unseen && (0..n).all(|i| held(plant, i, j).is_zero())
    };
    if let Some(j) = (0..n).find(|j| alone(*j)) {
        let weight = Constant::one().over(&plant.c[output][j]).ok()?;
        return Some((0..n).map(|i| if i == j { weight.clone() } else { Constant::default() }).collect());
    }
    let mut rows: Vec<Vec<Rational>> = Vec::new();
    for i in 0..n {
        let mut row: Vec<Rational> = (0..n).map(|j| held(plant, i, j).as_rational()).collect::<Option<_>>()?;
        row.push(Rational::ZERO);
        rows.push(row);
    }
    for (o, entries) in plant.c.iter().enumerate() {
        let mut row: Vec<Rational> = entries.iter().map(Constant::as_rational).collect::<Option<_>>()?;
        row.push(if o == output { Rational::ONE } else { Rational::ZERO });
        rows.push(row);
    }
    solve(rows, n).map(|s| s.into_iter().map(Constant::from).collect())
}

/// A solution of `rows [s; -1] = 0`, with what is free at zero; `None` where there is none.
fn solve(mut rows: Vec<Vec<Rational>>, n: usize) -> Option<Vec<Rational>> {
    let pivots = reduce(&mut rows, n);
    if rows[pivots.len()..].iter().any(|row| !row[n].is_zero()) {
        return None;
    }
    let mut solution = vec![Rational::ZERO; n];
    for (row, column) in pivots.into_iter().enumerate() {
        solution[column].clone_from(&rows[row][n]);
    }
    Some(solution)
}

/// `x -> x + moved`.
struct Shift<'a> {
    /// Per state: what is added; constant.
    moved: &'a [Poly],
}

impl Shift<'_> {
    /// Whether an expression is the same after the shift.
    fn keeps(&self, poly: &Poly) -> bool {
        self.change(poly).is_some_and(|change| change.is_zero())
    }

    /// By which constant an expression changes; `None` where that is no constant, or none that is found.
    fn change(&self, poly: &Poly) -> Option<Poly> {
        let mut change = Poly::default();
        for (monomial, coefficient) in poly.terms() {
            let (fixed, varying) = monomial.split();
            if let Some(Symbol::State(j)) = varying.as_symbol() {
                let term = Poly::monomial(fixed, coefficient.clone()).times(&self.moved[j]).ok()?;
                change = change.plus(&term).ok()?;
            } else if !self.keeps_all(&varying) {
                return None;
            }
        }
        Some(change)
    }

    /// Whether every factor of a monomial is the same after the shift.
    fn keeps_all(&self, monomial: &Monomial) -> bool {
        monomial.factors().iter().all(|(atom, _)| match atom {
            Atom::Symbol(Symbol::State(j)) => self.moved[*j].is_zero(),
            Atom::Pi | Atom::Symbol(_) => true,
            Atom::Reciprocal(sum) => self.keeps(sum),
            Atom::Call(function, arguments) => {
                arguments.iter().all(|argument| self.keeps(argument)) || self.is_period(*function, arguments)
            }
        })
    }

    /// Whether the arguments change by a whole number of the function's periods.
    fn is_period(&self, function: Function, arguments: &[Poly]) -> bool {
        let halves = match function {
            Function::Sin | Function::Cos => 2,
            Function::Tan => 1,
            _ => return false,
        };
        let [argument] = arguments else { return false };
        let period = Poly::from(Atom::Pi).times(&Poly::from(Rational::from(halves)));
        let count = || self.change(argument)?.times(&period.ok()?.reciprocal().ok()?).ok()?.as_rational();
        count().is_some_and(|count| count.is_int())
    }
}
