//! From the specification's texts to the plant's parts.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use crate::decimal;
use crate::diagnostic::{Diagnostic, codes};
use crate::expr::{Atom, Constant, Meaning, Node, Poly, Symbol};
use crate::names;
use crate::spec::{self, Hold, Named, Quantity, Spec, Text};

use super::expression::{exists, read_constant, read_expression};
use super::measurable::Measurable;
use super::modes::gone_within_a_sample;
use super::outputs::{Shown, plain_output};
use super::sensor::Sensor;
use super::{
    Disturbance, Injection, Input, Label, Output, Parameter, Plant, State, Unknown, Vouched, combine, split, words,
};

/// Most states, inputs or outputs of a plant.
const MOST: usize = 256;

/// The names known so far and the mistakes found so far.
pub(super) struct Reading<'a> {
    pub(super) spec: &'a Spec,
    pub(super) known: Vec<(String, Meaning)>,
    pub(super) found: Vec<Diagnostic>,
}

/// A, B, C and what else a plant's equations hold.
struct Parts {
    a: Vec<Vec<Constant>>,
    b: Vec<Vec<Constant>>,
    c: Vec<Vec<Constant>>,
    /// Per output: per input, and a constant.
    direct: Vec<(Vec<Constant>, Constant)>,
    offset: Vec<Constant>,
    injections: Vec<Injection>,
    gammas: Vec<Vec<Poly>>,
    disturbances: Vec<Vec<Constant>>,
}

impl<'a> Reading<'a> {
    /// Starts with nothing known and no mistake.
    pub(super) fn new(spec: &'a Spec) -> Self {
        Self { spec, known: Vec::new(), found: Vec::new() }
    }

    /// The plant, and the mistakes and warnings.
    pub(super) fn finish(mut self) -> (Option<Plant>, Vec<Diagnostic>) {
        (self.plant(), self.found)
    }

    fn plant(&mut self) -> Option<Plant> {
        let spec = self.spec;
        self.known = spec.parameters.iter().map(|p| (p.named.name.value.clone(), Meaning::Later)).collect();
        let names = self.shape();
        self.read_parameters();
        let sample_time = self.positive(&spec.target.sample_time, "the sample time");
        let jitter = self.at_least_zero(
            spec.target.jitter.as_ref(),
            "the jitter",
            "write by how many seconds the times of samples may differ from those of calls",
        );
        let ahead = self.ahead();
        let names = names?;
        let known = (sample_time.as_ref(), jitter.as_ref().and_then(Option::as_ref).filter(|jitter| !jitter.is_zero()));
        let outputs: Vec<Option<(Output, Sensor)>> = spec.outputs.iter().map(|o| self.output(o, known)).collect();
        let initial: Vec<Option<Constant>> = spec.states.iter().map(|s| self.optional(s.initial.as_ref())).collect();
        let bounds: Vec<Option<Constant>> = spec.disturbances.iter().map(|d| self.bound(d)).collect();
        let late: Vec<bool> = outputs.iter().map(|o| o.as_ref().is_some_and(|(o, _)| o.delay.is_some())).collect();
        let parts = if spec.matrices.is_some() { self.by_matrices(&names) } else { self.by_equations(&late) };
        let parts = parts?;
        self.check_uses(&parts);
        let (mut outputs, mut sensors): (Vec<Output>, Vec<Sensor>) =
            outputs.into_iter().collect::<Option<Vec<_>>>()?.into_iter().unzip();
        outputs.extend(names.outputs.iter().skip(outputs.len()).map(|name| plain_output(unnamed(name))));
        sensors.resize_with(outputs.len(), Sensor::plain);
        for (output, direct) in outputs.iter_mut().zip(parts.direct) {
            self.add_direct(output, direct)?;
        }
        let delayed: Vec<bool> = outputs.iter().map(|o| o.delay.is_some()).collect();
        let mut measured = Measurable::new(&parts.c, &delayed).weights;
        let initial: Vec<Constant> = initial.into_iter().collect::<Option<_>>()?;
        let states = (0..names.states.len()).map(|i| State {
            label: spec.states.get(i).map_or_else(|| unnamed(&names.states[i]), |s| label(&s.named)),
            initial: initial.get(i).cloned().unwrap_or_default(),
            measured: std::mem::take(&mut measured[i]),
            equation: spec.states.get(i).and_then(|s| s.change.as_ref()).map(one_line).unwrap_or_default(),
        });
        let states = states.collect();
        let inputs = (0..names.inputs.len()).map(|i| Input {
            label: spec.inputs.get(i).map_or_else(|| unnamed(&names.inputs[i]), |u| label(&u.named)),
            hold: spec.inputs.get(i).map_or(Hold::Zero, |u| u.hold),
        });
        let unknowns = spec.unknowns.iter().zip(parts.gammas);
        let disturbances = spec.disturbances.iter().zip(bounds.into_iter().collect::<Option<Vec<_>>>()?);
        let plant = Plant {
            source: spec.source.clone(),
            name: spec.name.value.clone(),
            title: spec.title.clone(),
            origin: spec.origin.clone(),
            discrete: spec.discrete,
            states,
            inputs: inputs.collect(),
            outputs,
            unknowns: unknowns.map(|(u, gamma)| Unknown { label: label(u), gamma }).collect(),
            disturbances: disturbances
                .zip(parts.disturbances)
                .map(|((d, bound), column)| Disturbance { label: label(&d.named), bound, column })
                .collect(),
            a: parts.a,
            b: parts.b,
            c: parts.c,
            offset: parts.offset,
            injections: parts.injections,
            parameters: spec.parameters.iter().zip(&self.known).filter_map(parameter).collect(),
            sample_time: (sample_time?, spec.target.sample_time.span()),
            scalar: spec.target.scalar,
            ahead: ahead?.filter(|(ahead, _)| !ahead.is_zero()),
            jitter: jitter?,
            coasted: spec.target.coasted || sensors.iter().any(|s| s.gate.is_some() || s.aged.is_some()),
            init_at: spec.target.init_at,
            vouched: if spec.target.exact_start { Vouched::Exact } else { Vouched::Bounded },
            span: spec.observer.method.span.clone(),
        };
        self.found.extend(gone_within_a_sample(&plant));
        self.with_turns(plant, &sensors)
    }

    /// The key `ahead`, with its place.
    fn ahead(&mut self) -> Option<Option<(Constant, Range<usize>)>> {
        let ahead = self.spec.observer.ahead.as_ref();
        let value = self.at_least_zero(ahead, "`ahead`", "write by how many seconds later the estimate is for")?;
        Some(value.zip(ahead.map(Quantity::span)))
    }

    /// Parameters may use those before them.
    fn read_parameters(&mut self) {
        for (place, parameter) in self.spec.parameters.iter().enumerate() {
            // When it is wrong and reported, a stand-in keeps its uses from being reported too.
            let value = self.constant(&parameter.value).unwrap_or_else(Constant::one);
            self.known[place].1 = Meaning::Parameter(value);
        }
    }

    /// Declares states, inputs, unknowns and disturbances for the expressions; the names of all parts.
    fn shape(&mut self) -> Option<Shape> {
        let spec = self.spec;
        let mut shape = Shape {
            states: spec.states.iter().map(|s| s.named.name.value.clone()).collect(),
            inputs: spec.inputs.iter().map(|u| u.named.name.value.clone()).collect(),
            outputs: spec.outputs.iter().map(|y| y.named.name.value.clone()).collect(),
        };
        if let Some(matrices) = &spec.matrices {
            let n = matrices.a.as_ref()?.0.len();
            let m = matrices.b.as_ref().map_or(0, |b| b.0.first().map_or(0, Vec::len));
            let p = matrices.c.as_ref()?.0.len();
            self.fit(&mut shape.states, n, "x", "states", "rows of A");
            self.fit(&mut shape.inputs, m, "u", "inputs", "columns of B");
            self.fit(&mut shape.outputs, p, "y", "outputs", "rows of C");
        }
        for (names, what) in [(&shape.states, "states"), (&shape.inputs, "inputs"), (&shape.outputs, "outputs")] {
            if names.len() > MOST {
                let message = format!("the plant has {} {what}", names.len());
                let error = Diagnostic::error(codes::TOO_LARGE, spec.observer.method.span.clone(), message);
                self.found.push(error.label(format!("at most {MOST} are designed")));
                return None;
            }
        }
        let mut declare = |names: &[String], symbol: fn(usize) -> Symbol| {
            self.known.extend(names.iter().enumerate().map(|(i, name)| (name.clone(), Meaning::Symbol(symbol(i)))));
        };
        let names = |named: Vec<&Named>| -> Vec<String> { named.iter().map(|n| n.name.value.clone()).collect() };
        declare(&shape.states, Symbol::State);
        declare(&shape.inputs, Symbol::Input);
        declare(&names(spec.unknowns.iter().collect()), Symbol::Unknown);
        declare(&names(spec.disturbances.iter().map(|d| &d.named).collect()), Symbol::Disturbance);
        Some(shape)
    }

    /// Names of a plant by matrices: all given, or `x1`, `x2`, …
    fn fit(&mut self, names: &mut Vec<String>, count: usize, letter: &str, table: &str, what: &str) {
        let named = names.len();
        names.truncate(count);
        names.extend((named + 1..=count).map(|i| format!("{letter}{i}")));
        if named != 0 && named != count {
            let message = format!("[{table}] names {named}, but there are {count} {what}");
            let span = self.spec.matrices.as_ref().map_or(0..0, |m| m.span.clone());
            self.found.push(Diagnostic::error(codes::SHAPE, span, message).help("name all of them, or none"));
        }
    }

    /// Reads an expression; its mistakes are collected.
    pub(super) fn node(&mut self, text: &Text) -> Option<Node> {
        read_expression(text, &self.known, &mut self.found)
    }

    /// A quantity as a constant whose value exists.
    pub(super) fn constant(&mut self, quantity: &Quantity) -> Option<Constant> {
        read_constant(quantity, &self.known, &mut self.found)
    }

    fn exists(&mut self, constant: &Constant, span: &Range<usize>) -> bool {
        exists(constant, span, &mut self.found)
    }

    fn optional(&mut self, quantity: Option<&Quantity>) -> Option<Constant> {
        quantity.map_or(Some(Constant::default()), |q| self.constant(q))
    }

    fn positive(&mut self, quantity: &Quantity, what: &str) -> Option<Constant> {
        let value = self.constant(quantity)?;
        self.not_below_zero(&value, quantity, what, false, "write the seconds between two calls").then_some(value)
    }

    pub(super) fn not_below_zero(
        &mut self,
        value: &Constant,
        quantity: &Quantity,
        what: &str,
        zero_is_fine: bool,
        help: &str,
    ) -> bool {
        let number = value.to_f64().unwrap_or(f64::NAN);
        if number > 0.0 || (zero_is_fine && number == 0.0) {
            return true;
        }
        let wanted = if zero_is_fine { "at least 0" } else { "above 0" };
        let message = format!("{what} must be {wanted}, not {}", decimal::show(number));
        let error = Diagnostic::error(codes::BAD_NUMBER, quantity.span(), message).measured(number);
        self.found.push(error.help(help));
        false
    }

    pub(super) fn at_least_zero(
        &mut self,
        quantity: Option<&Quantity>,
        what: &str,
        help: &str,
    ) -> Option<Option<Constant>> {
        let Some(quantity) = quantity else { return Some(None) };
        let value = self.constant(quantity)?;
        self.not_below_zero(&value, quantity, what, true, help).then_some(Some(value))
    }

    fn bound(&mut self, disturbance: &spec::Disturbance) -> Option<Constant> {
        self.at_least_zero(disturbance.bound.as_ref(), "the bound of a disturbance", "write its largest magnitude")?
    }

    fn by_matrices(&mut self, shape: &Shape) -> Option<Parts> {
        let matrices = self.spec.matrices.clone().unwrap_or_else(|| unreachable!("called for a plant by matrices"));
        let (n, m, p) = (shape.states.len(), shape.inputs.len(), shape.outputs.len());
        self.refuse_in_matrices();
        // The shape of the others follows from that of A.
        let a = self.matrix(matrices.a.as_ref()?, n, n, "A")?;
        let b = matrices.b.as_ref().map_or(Some(vec![Vec::new(); n]), |b| self.matrix(b, n, m, "B"));
        let c = self.matrix(matrices.c.as_ref()?, p, n, "C");
        let d = matrices.d.as_ref().map_or(Some(vec![vec![Constant::default(); m]; p]), |d| self.matrix(d, p, m, "D"));
        Some(Parts {
            a,
            b: b?,
            c: c?,
            direct: d?.into_iter().map(|row| (row, Constant::default())).collect(),
            offset: vec![Constant::default(); n],
            injections: Vec::new(),
            gammas: Vec::new(),
            disturbances: Vec::new(),
        })
    }

    /// Unknowns and disturbances have no place in A, B, C.
    fn refuse_in_matrices(&mut self) {
        let unknowns = self.spec.unknowns.iter().map(|u| (u, "unknown"));
        let disturbances = self.spec.disturbances.iter().map(|d| (&d.named, "disturbance"));
        for (named, what) in unknowns.chain(disturbances) {
            let message = format!("the {what} `{}` enters no matrix", named.name.value);
            let error = Diagnostic::error(codes::BAD_COMBINATION, named.name.span.clone(), message);
            self.found.push(error.help("write the plant as equations"));
        }
    }

    fn matrix(&mut self, rows: &spec::Rows, height: usize, width: usize, letter: &str) -> Option<Vec<Vec<Constant>>> {
        let (rows, span) = rows;
        let widths: BTreeSet<usize> = rows.iter().map(Vec::len).collect();
        if rows.len() != height || widths != BTreeSet::from([width]) || height == 0 || width == 0 {
            let list: Vec<String> = widths.iter().map(usize::to_string).collect();
            let (message, help) = match letter {
                _ if height == 0 || width == 0 => {
                    (format!("{letter} is empty"), "write a list of rows, such as `[[0, 1], [0, 0]]`")
                }
                "A" => ("A must be square".into(), "A has one row and one column per state"),
                "B" => (format!("B must be {height} x {width}"), "B has one row per state and one column per input"),
                "D" => (format!("D must be {height} x {width}"), "D has one row per output and one column per input"),
                _ => (
                    format!("{letter} must be {height} x {width}"),
                    "C has one row per output and one column per state",
                ),
            };
            let plural = if rows.len() == 1 { "" } else { "s" };
            let label = match list.as_slice() {
                [] => "this has no rows".to_owned(),
                list => format!("this has {} row{plural} of {}", rows.len(), list.join(" or ")),
            };
            self.found.push(Diagnostic::error(codes::SHAPE, span.clone(), message).label(label).help(help));
            return None;
        }
        let rows: Vec<Option<Vec<Constant>>> = rows
            .iter()
            .map(|row| {
                let row: Vec<Option<Constant>> = row.iter().map(|q| self.constant(q)).collect();
                row.into_iter().collect()
            })
            .collect();
        rows.into_iter().collect()
    }

    fn by_equations(&mut self, late: &[bool]) -> Option<Parts> {
        let spec = self.spec;
        let shown: Vec<Option<Shown>> = spec.outputs.iter().map(|o| self.output_row(o.value.as_ref()?)).collect();
        let rights: Vec<Option<Node>> =
            spec.states.iter().map(|s| s.change.as_ref().and_then(|text| self.node(text))).collect();
        let shown: Vec<Shown> = shown.into_iter().collect::<Option<_>>()?;
        let (c, direct): (Vec<_>, Vec<_>) = shown.into_iter().map(|s| (s.states, (s.inputs, s.constant))).unzip();
        let rights: Vec<Node> = rights.into_iter().collect::<Option<_>>()?;
        let stays = |(j, right): (usize, &Node)| {
            let own = if spec.discrete { Poly::from(Atom::Symbol(Symbol::State(j))) } else { Poly::default() };
            right.poly == own
        };
        let constant = rights.iter().enumerate().map(stays).collect();
        let measurable = Measurable { constant, ..Measurable::new(&c, late) };
        let sizes = split::Sizes {
            states: spec.states.len(),
            inputs: spec.inputs.len(),
            unknowns: spec.unknowns.len(),
            disturbances: spec.disturbances.len(),
        };
        let sides: Vec<Option<split::Side>> = rights
            .iter()
            .enumerate()
            .map(|right| split::side(right, &measurable, sizes, &self.known, &mut self.found))
            .collect();
        let sides: Vec<split::Side> = sides.into_iter().collect::<Option<_>>()?;
        self.assemble(&rights, sides, c, direct)
    }

    /// Coefficients that exist.
    pub(super) fn constants(&mut self, row: Vec<Poly>, span: &Range<usize>) -> Option<Vec<Constant>> {
        let row: Vec<Constant> = row
            .into_iter()
            .map(|poly| Constant::try_from(poly).unwrap_or_else(|_| unreachable!("a coefficient has been split off")))
            .collect();
        row.iter().all(|constant| self.exists(constant, span)).then_some(row)
    }

    fn assemble(
        &mut self,
        rights: &[Node],
        sides: Vec<split::Side>,
        c: Vec<Vec<Constant>>,
        direct: Vec<(Vec<Constant>, Constant)>,
    ) -> Option<Parts> {
        let spec = self.spec;
        let n = sides.len();
        let mut parts = Parts {
            a: Vec::new(),
            b: Vec::new(),
            c,
            direct,
            offset: Vec::new(),
            injections: Vec::new(),
            gammas: vec![vec![Poly::default(); n]; spec.unknowns.len()],
            disturbances: vec![vec![Constant::default(); n]; spec.disturbances.len()],
        };
        let mut terms: BTreeMap<Poly, (Node, Vec<Poly>)> = BTreeMap::new();
        for (i, side) in sides.into_iter().enumerate() {
            let span = &rights[i].span;
            parts.a.push(self.constants(side.states, span)?);
            parts.b.push(self.constants(side.inputs, span)?);
            parts.offset.append(&mut self.constants(vec![side.offset], span)?);
            for (k, gamma) in side.unknowns.into_iter().enumerate() {
                parts.gammas[k][i] = gamma;
            }
            for (k, value) in self.constants(side.disturbances, span)?.into_iter().enumerate() {
                parts.disturbances[k][i] = value;
            }
            for (key, (node, coefficient)) in side.nonlinear {
                let (first, column) = terms.entry(key).or_insert_with(|| (node.clone(), vec![Poly::default(); n]));
                // Both nodes are multiples of the same monic form; the coefficient is of the first.
                let ratio = &node.poly.monic().1 / &first.poly.monic().1;
                let scaled = coefficient.times(&ratio.into()).ok()?;
                column[i] = std::mem::take(&mut column[i]).plus(&scaled).ok()?;
            }
        }
        for (node, column) in combine::combine(terms, spec) {
            let column = self.constants(column, &node.span)?;
            let text = words::text_of(&node, &self.known);
            parts.injections.push(Injection { node, text, column });
        }
        Some(parts)
    }

    /// Everything declared should enter somewhere.
    fn check_uses(&mut self, parts: &Parts) {
        for (k, unknown) in self.spec.unknowns.iter().enumerate() {
            if parts.gammas.get(k).is_some_and(|gamma| gamma.iter().all(Poly::is_zero)) {
                let message = format!("the unknown `{}` enters no equation", unknown.name.value);
                self.found.push(
                    Diagnostic::error(codes::UNUSED, unknown.name.span.clone(), message)
                        .help("remove it, or use it in a derivative"),
                );
            }
        }
        for (k, disturbance) in self.spec.disturbances.iter().enumerate() {
            if parts.disturbances.get(k).is_some_and(|column| column.iter().all(Constant::is_zero)) {
                let name = &disturbance.named.name;
                let message = format!("the disturbance `{}` enters no equation", name.value);
                self.found.push(Diagnostic::warning(codes::UNUSED, name.span.clone(), message));
            }
        }
        for (i, input) in self.spec.inputs.iter().enumerate() {
            let linear = parts.b.iter().any(|row| row.get(i).is_some_and(|c| !c.is_zero()));
            let elsewhere = parts.injections.iter().any(|j| j.symbols().contains(&Symbol::Input(i)))
                || parts.gammas.iter().flatten().any(|g| g.symbols().contains(&Symbol::Input(i)))
                || parts.direct.iter().any(|(inputs, _)| inputs.get(i).is_some_and(|c| !c.is_zero()));
            if !linear && !elsewhere {
                let message = format!("the input `{}` enters no equation", input.named.name.value);
                self.found.push(Diagnostic::warning(codes::UNUSED, input.named.name.span.clone(), message));
            }
        }
    }
}

/// The names of a plant's parts.
struct Shape {
    states: Vec<String>,
    inputs: Vec<String>,
    outputs: Vec<String>,
}

pub(super) fn label(named: &Named) -> Label {
    Label {
        name: names::field(&named.name.value),
        written: named.name.value.clone(),
        unit: named.unit.clone(),
        doc: named.doc.clone(),
        span: named.name.span.clone(),
    }
}

/// A parameter with its value; those come first among the known names, in the same order.
fn parameter((written, (_, meaning)): (&spec::Parameter, &(String, Meaning))) -> Option<Parameter> {
    match meaning {
        Meaning::Parameter(value) => {
            // No field: it keeps its capitals.
            let name = written.named.name.value.clone();
            Some(Parameter { label: Label { name, ..label(&written.named) }, value: value.clone() })
        }
        _ => None,
    }
}

fn unnamed(name: &str) -> Label {
    let (name, written) = (names::field(name), name.to_owned());
    Label { name, written, unit: String::new(), doc: String::new(), span: 0..0 }
}

/// An expression's text on one line.
pub(super) fn one_line(text: &Text) -> String {
    text.value.split_whitespace().collect::<Vec<_>>().join(" ")
}
