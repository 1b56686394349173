//! Claim: the interpreter computes what a Program says, bit for bit (NaN equals NaN).
//!
//! The reference walks the statements one by one and computes each operation as it is written.
#![expect(
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    reason = "an `f32` Program rounds to `f32`, which is what is tested"
)]

use crate::support::random_program;

use std::collections::{BTreeSet, HashMap};

use deadbeat_codegen::program::builder::Builder;
use deadbeat_codegen::program::check::check;
use deadbeat_codegen::program::interp::Interpreter;
use deadbeat_codegen::program::listing::listing;
use deadbeat_codegen::program::{
    CellKind, Field, Function, Kind, Op, Program, Scalar, Statement, Status, TableId, Value,
};

use random_program::{random_inputs, random_program};

/// How many Programs, and how many steps of each.
const SEEDS: u64 = 300;
const STEPS: usize = 50;

/// A value at run time.
#[derive(Clone, Copy)]
enum Datum {
    /// Holds an `f32` exactly in an `F32` Program.
    Float(f64),
    Index(u32),
    Bool(bool),
    Status(Status),
}

/// The obvious semantics.
struct Reference<'a> {
    program: &'a Program,
    values: HashMap<Value, Datum>,
    cells: Vec<Vec<Datum>>,
}

/// A call of the runtime by name.
macro_rules! elementary {
    ($function:expr, $a:expr, $b:expr; $($name:ident $single:ident $double:ident),+) => {
        match $function {
            $(Function::$name => (deadbeat_math::$single($a as f32), deadbeat_math::$double($a)),)+
            Function::Atan2 => {
                (deadbeat_math::atan2_f32($a as f32, $b as f32), deadbeat_math::atan2_f64($a, $b))
            }
            Function::Pow => (deadbeat_math::pow_f32($a as f32, $b as f32), deadbeat_math::pow_f64($a, $b)),
        }
    };
}

impl<'a> Reference<'a> {
    fn new(program: &'a Program) -> Self {
        let cells = program.cells.iter().map(|cell| match cell.kind {
            CellKind::Float { init } => vec![Datum::Float(init)],
            CellKind::Index { init } => vec![Datum::Index(init)],
            CellKind::Ring { len, init } => vec![Datum::Float(init); len as usize],
            CellKind::Counts { len, init, .. } => vec![Datum::Index(init); len as usize],
        });
        Self { program, values: HashMap::new(), cells: cells.collect() }
    }

    /// The start from an estimate.
    fn start_at(&mut self, estimates: &[f64], vouched: bool) {
        *self = Self::new(self.program);
        if let Some(start) = &self.program.init_at {
            self.body(start, &(estimates.to_vec(), vec![f64::from(u8::from(vouched))]), None);
        }
    }

    fn step(&mut self, given: &(Vec<f64>, Vec<f64>)) -> (Vec<f64>, Status) {
        self.values.clear();
        self.body(&self.program.body, given, None);
        let estimates = self.program.estimates.iter().map(|(_, value)| number(&self.values[value])).collect();
        let Datum::Status(status) = self.values[&self.program.status] else { panic!("not a status") };
        (estimates, status)
    }

    fn body(&mut self, body: &[Statement], given: &(Vec<f64>, Vec<f64>), row: Option<(TableId, usize)>) {
        for statement in body {
            match statement {
                Statement::Section(_) => {}
                Statement::Let { value, op } => {
                    let datum = self.compute(op, given, row);
                    self.values.insert(*value, datum);
                }
                Statement::SetCell { cell, value } => {
                    self.cells[usize::from(cell.0)][0] = self.values[value];
                }
                Statement::SetRing { ring, slot, value } => {
                    let slot = self.index(*slot) as usize;
                    let kept = match (&self.program.cells[usize::from(ring.0)].kind, self.values[value]) {
                        (CellKind::Counts { bits: 16, .. }, Datum::Index(x)) => Datum::Index(x % 0x1_0000),
                        (_, kept) => kept,
                    };
                    self.cells[usize::from(ring.0)][slot] = kept;
                }
                Statement::Loop(inner) => {
                    for carried in &inner.carried {
                        self.values.insert(carried.value, self.values[&carried.start]);
                    }
                    for row in 0..self.program.tables[usize::from(inner.table.0)].rows.len() {
                        self.body(&inner.body, given, Some((inner.table, row)));
                        let next: Vec<Datum> = inner.carried.iter().map(|it| self.values[&it.next]).collect();
                        for (carried, next) in inner.carried.iter().zip(next) {
                            self.values.insert(carried.value, next);
                        }
                    }
                }
            }
        }
    }

    /// The result of one operation, rounded once.
    fn compute(&self, op: &Op, given: &(Vec<f64>, Vec<f64>), row: Option<(TableId, usize)>) -> Datum {
        match op {
            Op::Float(x) => Datum::Float(*x),
            Op::Neg(a) => Datum::Float(-self.float(*a)),
            Op::Add(a, b) => self.arithmetic(*a, *b, |a, b| a + b, |a, b| a + b),
            Op::Sub(a, b) => self.arithmetic(*a, *b, |a, b| a - b, |a, b| a - b),
            Op::Mul(a, b) => self.arithmetic(*a, *b, |a, b| a * b, |a, b| a * b),
            Op::Div(a, b) => self.arithmetic(*a, *b, |a, b| a / b, |a, b| a / b),
            Op::Call(function, arguments) => self.call(*function, arguments),
            Op::Less(a, b) => Datum::Bool(self.float(*a) < self.float(*b)),
            Op::LessEqual(a, b) => Datum::Bool(self.float(*a) <= self.float(*b)),
            Op::InRange { value, low, high } => Datum::Bool((*low..=*high).contains(&self.float(*value))),
            Op::Bool(truth) => Datum::Bool(*truth),
            Op::And(a, b) => Datum::Bool(self.truth(*a) && self.truth(*b)),
            Op::Or(a, b) => Datum::Bool(self.truth(*a) || self.truth(*b)),
            Op::Not(a) => Datum::Bool(!self.truth(*a)),
            Op::Status(status) => Datum::Status(*status),
            Op::Select { condition, then, otherwise } => {
                self.values[if self.truth(*condition) { then } else { otherwise }]
            }
            Op::IndexLess(a, b) => Datum::Bool(self.index(*a) < self.index(*b)),
            Op::IndexEqual(a, b) => Datum::Bool(self.index(*a) == self.index(*b)),
            Op::Measurement(at) | Op::Given(at) => self.rounded(given.0[usize::from(*at)]),
            Op::Input(at) => self.rounded(given.1[usize::from(*at)]),
            Op::Vouched => Datum::Bool(given.1[0] > 0.0),
            Op::Cell(cell) => self.cells[usize::from(cell.0)][0],
            Op::Ring { ring, slot } => self.cells[usize::from(ring.0)][self.index(*slot) as usize],
            Op::Lookup { table, row, column } => self.element(*table, self.index(*row) as usize, *column),
            Op::Gain { column } => {
                let (table, row) = row.expect("a gain is in a loop");
                self.element(table, row, *column)
            }
            Op::ToFloat(a) => match self.program.scalar {
                Scalar::F32 => Datum::Float(f64::from(self.index(*a) as f32)),
                Scalar::F64 => Datum::Float(f64::from(self.index(*a))),
            },
            Op::SignedToFloat(a) => {
                let signed = i64::from(self.index(*a)) - if self.index(*a) >= 1 << 31 { 1 << 32 } else { 0 };
                match self.program.scalar {
                    Scalar::F32 => Datum::Float(f64::from(signed as f32)),
                    Scalar::F64 => Datum::Float(signed as f64),
                }
            }
            Op::Count(at) => {
                let wrapped = (given.0[usize::from(*at)] as i64).rem_euclid(1 << 32);
                assert!(matches!(self.program.measurements[usize::from(*at)].kind, Kind::Count { .. }));
                Datum::Index(u32::try_from(wrapped).expect("below 2^32"))
            }
            _ => Datum::Index(self.count(op)),
        }
    }

    /// The operations whose result is an index.
    fn count(&self, op: &Op) -> u32 {
        match *op {
            Op::Index(number) => number,
            Op::Advance { slot, len } => match self.index(slot) {
                slot if slot < len - 1 => slot + 1,
                _ => 0,
            },
            Op::Retreat { slot, len } => match self.index(slot) {
                slot if slot >= 1 && slot < len => slot - 1,
                _ => len - 1,
            },
            Op::CountUp { count, max } => match self.index(count) {
                count if count < max => count + 1,
                _ => max,
            },
            Op::CountDown(count) => match self.index(count) {
                0 => 0,
                count => count - 1,
            },
            Op::AtMost { value, max } => self.index(value).min(max),
            Op::Remainder { value, modulus } => self.index(value) - self.index(value) / modulus * modulus,
            Op::WrapAdd(a, b) => modulo(i64::from(self.index(a)) + i64::from(self.index(b)), 32),
            Op::Difference { a, b, bits } => {
                let difference = modulo(i64::from(self.index(a)) - i64::from(self.index(b)), bits);
                let is_negative = difference >= 1 << (bits - 1);
                modulo(i64::from(difference) - if is_negative { 1 << bits } else { 0 }, 32)
            }
            Op::FromFloat(a) => {
                let ends = match self.program.scalar {
                    Scalar::F32 => [-2_147_483_648.0, 2_147_483_520.0],
                    Scalar::F64 => [-2_147_483_648.0, 2_147_483_647.0],
                };
                let x = self.float(a);
                let within = if x.is_nan() { 0.0 } else { x.max(ends[0]).min(ends[1]) };
                modulo(within.trunc() as i64, 32)
            }
            _ => panic!("{op:?} has no index as its result"),
        }
    }

    fn arithmetic(&self, a: Value, b: Value, single: fn(f32, f32) -> f32, double: fn(f64, f64) -> f64) -> Datum {
        let (a, b) = (self.float(a), self.float(b));
        Datum::Float(match self.program.scalar {
            Scalar::F32 => f64::from(single(a as f32, b as f32)),
            Scalar::F64 => double(a, b),
        })
    }

    fn call(&self, function: Function, arguments: &[Value]) -> Datum {
        let a = self.float(arguments[0]);
        let b = arguments.get(1).map_or(0.0, |b| self.float(*b));
        let (single, double) = elementary!(function, a, b;
            Sin sin_f32 sin_f64, Cos cos_f32 cos_f64, Tan tan_f32 tan_f64, Asin asin_f32 asin_f64,
            Acos acos_f32 acos_f64, Atan atan_f32 atan_f64, Exp exp_f32 exp_f64, Log log_f32 log_f64,
            Sqrt sqrt_f32 sqrt_f64, Tanh tanh_f32 tanh_f64);
        Datum::Float(match self.program.scalar {
            Scalar::F32 => f64::from(single),
            Scalar::F64 => double,
        })
    }

    fn rounded(&self, x: f64) -> Datum {
        Datum::Float(match self.program.scalar {
            Scalar::F32 => f64::from(x as f32),
            Scalar::F64 => x,
        })
    }

    fn element(&self, table: TableId, row: usize, column: u16) -> Datum {
        Datum::Float(self.program.tables[usize::from(table.0)].rows[row][usize::from(column)])
    }

    fn float(&self, value: Value) -> f64 {
        let Datum::Float(x) = self.values[&value] else { panic!("{value} is not a float") };
        x
    }

    fn index(&self, value: Value) -> u32 {
        let Datum::Index(x) = self.values[&value] else { panic!("{value} is not an index") };
        x
    }

    fn truth(&self, value: Value) -> bool {
        let Datum::Bool(x) = self.values[&value] else { panic!("{value} is not a truth value") };
        x
    }

    /// What the cells hold, as the interpreter tells it.
    fn cells(&self) -> Vec<Vec<f64>> {
        self.cells.iter().map(|cell| cell.iter().map(number).collect()).collect()
    }
}

/// What a cell or an estimate holds, as the interpreter tells it.
fn number(datum: &Datum) -> f64 {
    match *datum {
        Datum::Float(x) => x,
        Datum::Index(x) => f64::from(x),
        Datum::Bool(_) | Datum::Status(_) => panic!("no cell or estimate holds that"),
    }
}

/// The number modulo 2^`bits`.
fn modulo(x: i64, bits: u8) -> u32 {
    u32::try_from(x.rem_euclid(1 << bits)).expect("at most 32 bits")
}

/// The same bits, or NaN in both.
fn same(a: &[f64], b: &[f64]) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan())
}

/// Compares one run of a Program, from its start.
fn compare(program: &Program, interpreter: &mut Interpreter, inputs: &[(Vec<f64>, Vec<f64>)]) {
    let mut reference = Reference::new(program);
    let (mut estimates, mut status) = (vec![0.0; program.estimates.len()], Status::Converging);
    for (step, given) in inputs.iter().enumerate() {
        if step == inputs.len() / 2 && program.init_at.is_some() {
            interpreter.start_at(&estimates, status);
            reference.start_at(&estimates, status == Status::Converged);
        }
        status = interpreter.step(&given.0, &given.1, &mut estimates);
        let (expected, expected_status) = reference.step(given);
        let place = || format!("step {step} of {}", listing(program));
        assert!(same(&estimates, &expected), "{estimates:?} is not {expected:?} in {}", place());
        assert_eq!(status, expected_status, "{}", place());
        for ((name, held), expected) in interpreter.cells().iter().zip(reference.cells()) {
            assert!(same(held, &expected), "{name}: {held:?} is not {expected:?} in {}", place());
        }
    }
}

#[test]
fn agrees_with_the_reference() {
    for seed in 0..SEEDS {
        let program = random_program(seed);
        assert_eq!(check(&program), Ok(()), "seed {seed}");
        let inputs = random_inputs(seed, &program, STEPS);
        let mut interpreter = Interpreter::new(&program);
        compare(&program, &mut interpreter, &inputs);
        interpreter.reset();
        compare(&program, &mut interpreter, &inputs[..STEPS / 5]);
    }
}

/// Claim: the same seed gives the same Program and inputs.
#[test]
fn seeds_are_reproducible() {
    let (program, again) = (random_program(7), random_program(7));
    assert_eq!(program, again);
    let bits = |inputs: Vec<(Vec<f64>, Vec<f64>)>| -> Vec<u64> {
        inputs.iter().flat_map(|(y, u)| y.iter().chain(u)).map(|x| x.to_bits()).collect()
    };
    assert_eq!(bits(random_inputs(7, &program, 9)), bits(random_inputs(7, &again, 9)));
}

/// The kind of an operation, functions told apart.
fn kind(op: &Op) -> String {
    let text = format!("{op:?}");
    let end = text.find(['(', ' ']).unwrap_or(text.len());
    match op {
        Op::Call(function, _) => function.name().to_owned(),
        _ => text[..end].to_owned(),
    }
}

/// Claim: the seeds leave no operation out, neither at the top level nor, where it can stand there,
/// in a loop, in either scalar type.
#[test]
fn seeds_cover_every_operation() {
    let everything: BTreeSet<String> = [
        "Float",
        "Neg",
        "Add",
        "Sub",
        "Mul",
        "Div",
        "Less",
        "LessEqual",
        "InRange",
        "Bool",
        "And",
        "Or",
        "Not",
        "Status",
        "Select",
        "Index",
        "IndexLess",
        "IndexEqual",
        "Advance",
        "Retreat",
        "CountUp",
        "CountDown",
        "AtMost",
        "ToFloat",
        "SignedToFloat",
        "FromFloat",
        "Remainder",
        "WrapAdd",
        "Difference",
        "Measurement",
        "Count",
        "Input",
        "Given",
        "Vouched",
        "Cell",
        "Ring",
        "Lookup",
        "Gain",
    ]
    .into_iter()
    .chain(Function::ALL.map(Function::name))
    .map(str::to_owned)
    .collect();
    for scalar in [Scalar::F32, Scalar::F64] {
        let mut seen = BTreeSet::new();
        let mut statements = BTreeSet::new();
        for program in (0..SEEDS).map(random_program).filter(|program| program.scalar == scalar) {
            for statement in program.body.iter().chain(program.init_at.iter().flatten()) {
                let inside = match statement {
                    Statement::Loop(inner) => inner.body.as_slice(),
                    _ => &[],
                };
                for (place, statement) in inside.iter().map(|it| ("loop", it)).chain([("top", statement)]) {
                    match statement {
                        Statement::Let { op, .. } => drop(seen.insert(kind(op))),
                        Statement::SetCell { .. } => drop(statements.insert((place, "SetCell"))),
                        Statement::SetRing { .. } => drop(statements.insert((place, "SetRing"))),
                        Statement::Section(_) => drop(statements.insert((place, "Section"))),
                        Statement::Loop(_) => drop(statements.insert((place, "Loop"))),
                    }
                }
            }
        }
        assert_eq!(seen, everything, "{scalar}");
        assert_eq!(statements.len(), 6, "{scalar}: {statements:?}");
    }
}

/// A Program that answers how far a counter came since the call before, how far since three calls before by a ring,
/// and the count itself as a float.
fn counter(bits: u8, signed: bool) -> Program {
    let field = |name: &str, kind| Field { name: name.to_owned(), unit: String::new(), doc: String::new(), kind };
    let mut b = Builder::new("counter", Scalar::F32, 0.125);
    let n = b.measurement(field("n", Kind::Count { bits, signed }));
    let last = b.index_cell("last", "the count before", 0);
    let (ring, newest) = (b.counts("ring", "the last counts", 3, bits, 0), b.index_cell("newest", "", 0));
    let (now, before, slot) = (b.read_count(n), b.read(last), b.read(newest));
    b.set(last, now);
    let slot = b.advance(slot, 3);
    b.set(newest, slot);
    let oldest = b.read_ring(ring, slot);
    b.set_ring(ring, slot, now);
    for (name, count) in [("step", before), ("window", oldest)] {
        let moved = b.wrap_difference(now, count, bits);
        let moved = b.signed_to_float(moved);
        b.estimate(field(name, Kind::Float), moved);
    }
    let number = if signed { b.signed_to_float(now) } else { b.to_float(now) };
    b.estimate(field("count", Kind::Float), number);
    b.estimate(field("raw", Kind::Float), now);
    let status = b.status(Status::Converged);
    b.report(status);
    b.finish()
}

/// What the counter's Program answers to these counts.
fn counted(bits: u8, signed: bool, counts: &[f64]) -> Vec<Vec<f64>> {
    let program = counter(bits, signed);
    let mut interpreter = Interpreter::new(&program);
    let mut answer = |count: &f64| {
        let mut estimates = vec![0.0; 4];
        interpreter.step(&[*count], &[], &mut estimates);
        estimates
    };
    counts.iter().map(&mut answer).collect()
}

/// Claim: a counter that overflows moves on by what it counted, in both directions, with 16 and with 32 bits, with and
/// without a sign; and so it does across a window.
#[test]
fn counters_overflow() {
    for (bits, signed) in [(16, true), (16, false), (32, true), (32, false)] {
        let turn = f64::from(bits).exp2();
        let (low, high) = if signed { (-turn / 2.0, turn / 2.0 - 1.0) } else { (0.0, turn - 1.0) };
        let answers = counted(bits, signed, &[high - 1.0, low + 3.0, high, low + 100.0, high - 400.0]);
        let column = |at: usize| answers.iter().map(|it| it[at]).collect::<Vec<_>>();
        assert_eq!(column(0)[1..], [5.0, -4.0, 101.0, -501.0], "{bits} {signed}");
        assert_eq!(column(1)[3..], [102.0, -404.0], "{bits} {signed}");
    }
}

/// Claim: a count is extended by its sign, and a number that its counter cannot show counts as documented.
#[test]
fn counts_are_extended() {
    let answers = counted(16, true, &[-1.0, -32_768.0, 1e9, f64::NAN, -2.75, f64::NEG_INFINITY]);
    let column = |at: usize| answers.iter().map(|it| it[at]).collect::<Vec<_>>();
    assert_eq!(column(2), [-1.0, -32_768.0, 32_767.0, 0.0, -2.0, -32_768.0]);
    assert_eq!(column(3), [4_294_967_295.0, 4_294_934_528.0, 32_767.0, 0.0, 4_294_967_294.0, 4_294_934_528.0]);
    let answers = counted(32, false, &[4_294_967_295.0, -1.0, 1e10]);
    let column = |at: usize| answers.iter().map(|it| it[at]).collect::<Vec<_>>();
    assert_eq!(column(2), [4_294_967_296.0, 0.0, 4_294_967_296.0]);
    assert_eq!(column(3), [4_294_967_295.0, 0.0, 4_294_967_295.0]);
}
