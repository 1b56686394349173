//! What a step costs: operations, RAM, stack and flash, counted from the Program.
//!
//! In: a checked [`Program`]. Out: numbers that hold for every call, since a step has no branch but
//! a select and no loop but a counted one: its worst case is its mean. Operations and table bytes
//! are exact; RAM is exact for a 32-bit target with natural alignment; stack and flash are upper
//! estimates whose terms are documented in `memory`.

mod memory;

use std::collections::BTreeMap;
use std::fmt;

use super::{Function, Loop, Op, Program, Statement};

/// The cost of one call of the step function.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Cost {
    /// Float additions, subtractions and changes of sign.
    pub additions: u64,
    /// Float multiplications.
    pub multiplications: u64,
    /// Float divisions.
    pub divisions: u64,
    /// Comparisons of floats (a range counts as two), logic, and selects of any type.
    pub comparisons_and_selects: u64,
    /// Elementary functions.
    pub calls: BTreeMap<Function, u64>,
    /// Reads of fields, cells, rings and tables.
    pub loads: u64,
    /// Writes of cells and rings, and of what is returned.
    pub stores: u64,
    /// Operations and comparisons of indices, conversions to and from float, and steps of loops.
    pub index_operations: u64,
    /// Float additions, multiplications, divisions, comparisons and selects, and each call with its
    /// weight.
    pub flops_worst: u64,
    /// The state of one observer.
    pub ram_bytes: u64,
    /// The constant tables.
    pub table_bytes: u64,
    /// An upper estimate of the stack that a call takes.
    pub stack_bytes: u64,
    /// An upper estimate of code and constants, without the runtime's elementary functions.
    pub flash_bytes: u64,
}

/// The cost of a checked Program. `weights` has the operations of each elementary function by its
/// name in the runtime, such as `("sin_f32", 266)`; one that is not listed counts as one.
#[must_use]
pub fn cost(program: &Program, weights: &[(&str, u32)]) -> Cost {
    let mut cost = Cost {
        stores: program.estimates.len() as u64 + 1,
        ram_bytes: memory::ram(program),
        table_bytes: memory::tables(program),
        stack_bytes: memory::stack(program),
        flash_bytes: memory::flash(program),
        ..Cost::default()
    };
    cost.count(program, &program.body, 1);
    let called: u64 = (cost.calls.iter())
        .map(|(function, times)| {
            let name = format!("{}_{}", function.name(), program.scalar);
            let weight = weights.iter().find(|(listed, _)| *listed == name);
            times * weight.map_or(1, |(_, weight)| u64::from(*weight))
        })
        .sum();
    cost.flops_worst = cost.additions + cost.multiplications + cost.divisions + cost.comparisons_and_selects + called;
    cost
}

impl Cost {
    /// Counts statements that are executed so many times.
    fn count(&mut self, program: &Program, body: &[Statement], times: u64) {
        for statement in body {
            match statement {
                Statement::Section(_) => {}
                Statement::Let { op, .. } => self.operation(op, times),
                Statement::SetCell { .. } | Statement::SetRing { .. } => self.stores += times,
                Statement::Loop(Loop { table, body, .. }) => {
                    let rows = program.tables[usize::from(table.0)].rows.len() as u64;
                    self.index_operations += rows;
                    self.count(program, body, rows);
                }
            }
        }
    }

    /// Counts an operation that is executed so many times; constants cost nothing.
    fn operation(&mut self, op: &Op, times: u64) {
        let counter = match op {
            Op::Float(_) | Op::Bool(_) | Op::Status(_) | Op::Index(_) => return,
            Op::Neg(_) | Op::Add(..) | Op::Sub(..) => &mut self.additions,
            Op::Mul(..) => &mut self.multiplications,
            Op::Div(..) => &mut self.divisions,
            Op::Call(function, _) => self.calls.entry(*function).or_default(),
            Op::InRange { .. } => {
                self.comparisons_and_selects += times;
                &mut self.comparisons_and_selects
            }
            Op::Less(..) | Op::LessEqual(..) | Op::And(..) | Op::Or(..) | Op::Not(_) | Op::Select { .. } => {
                &mut self.comparisons_and_selects
            }
            Op::IndexLess(..)
            | Op::IndexEqual(..)
            | Op::Advance { .. }
            | Op::Retreat { .. }
            | Op::CountUp { .. }
            | Op::CountDown(_)
            | Op::AtMost { .. }
            | Op::WrapAdd(..)
            | Op::Difference { .. }
            | Op::Remainder { .. }
            | Op::ToFloat(_)
            | Op::SignedToFloat(_)
            | Op::FromFloat(_) => &mut self.index_operations,
            Op::Measurement(_)
            | Op::Count(_)
            | Op::Input(_)
            | Op::Given(_)
            | Op::Vouched
            | Op::Cell(_)
            | Op::Ring { .. }
            | Op::Lookup { .. }
            | Op::Gain { .. } => &mut self.loads,
        };
        *counter += times;
    }
}

/// `204 multiplications, 204 additions, 1 sin; RAM 420 bytes; constants 816 bytes`
impl fmt::Display for Cost {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let plural = |count: u64, one: &str| match count {
            1 => format!("1 {one}"),
            _ => format!("{count} {one}s"),
        };
        let counted =
            [(self.multiplications, "multiplication"), (self.additions, "addition"), (self.divisions, "division")];
        let operations = counted.iter().filter(|(count, _)| *count > 0).map(|(count, name)| plural(*count, name));
        let calls = self.calls.iter().map(|(function, count)| format!("{count} {}", function.name()));
        let listed: Vec<String> = operations.chain(calls).collect();
        let listed = if listed.is_empty() { "no arithmetic".to_owned() } else { listed.join(", ") };
        let (ram, constants) = (plural(self.ram_bytes, "byte"), plural(self.table_bytes, "byte"));
        write!(f, "{listed}; RAM {ram}; constants {constants}")
    }
}

#[cfg(test)]
mod tests {
    use super::super::builder::Builder;
    use super::super::{Field, Kind, Scalar, Status};
    use super::*;

    /// A window of 100 samples weighted by two columns, and the sine of one sum.
    fn window(scalar: Scalar) -> Program {
        let field =
            |name: &str| Field { name: name.to_owned(), unit: String::new(), doc: String::new(), kind: Kind::Float };
        let mut b = Builder::new("window", scalar, 0.5);
        let y = b.measurement(field("y"));
        let head = b.index_cell("head", "", 0);
        let ring = b.ring("ring", "", 100, 0.0);
        let columns = vec![String::new(), String::new()];
        let table = b.table("GAINS", "", columns, vec![vec![0.5, 2.0]; 100]);
        let (before, y) = (b.read(head), b.read_measurement(y));
        let slot = b.advance(before, 100);
        b.set_ring(ring, slot, y);
        b.set(head, slot);
        let zero = b.float(0.0);
        let ends = b.loop_over(table, &[slot, zero, zero], |b, carried| {
            let x = b.read_ring(ring, carried[0]);
            let (first, second) = (b.gain(0), b.gain(1));
            let (first, second) = (b.mul(first, x), b.mul(second, x));
            vec![b.retreat(carried[0], 100), b.add(carried[1], first), b.add(carried[2], second)]
        });
        let sine = b.call(Function::Sin, &[ends[1]]);
        let inside = b.in_range(sine, -0.5, 0.5);
        let chosen = b.select(inside, sine, ends[2]);
        b.estimate(field("x"), chosen);
        let status = b.status(Status::Converged);
        b.report(status);
        b.finish()
    }

    /// Claim: a loop's body counts once for each row, and the line says it all.
    #[test]
    fn counts() {
        let cost = cost(&window(Scalar::F32), &[("sin_f64", 1000), ("sin_f32", 266)]);
        assert_eq!((cost.multiplications, cost.additions, cost.divisions), (200, 200, 0));
        assert_eq!((cost.loads, cost.stores, cost.index_operations), (302, 4, 201));
        assert_eq!((cost.comparisons_and_selects, cost.flops_worst), (3, 669));
        assert_eq!(cost.ram_bytes, 404);
        assert_eq!(cost.table_bytes, 800);
        let line = "200 multiplications, 200 additions, 1 sin; RAM 404 bytes; constants 800 bytes";
        assert_eq!(cost.to_string(), line);
    }

    /// Claim: doubles are aligned to 8 bytes in the state.
    #[test]
    fn alignment() {
        assert_eq!(cost(&window(Scalar::F64), &[]).ram_bytes, 8 + 800);
    }

    /// Claim: a ring of 16-bit counts takes 2 bytes for each, and a 4-byte cell behind it is aligned.
    #[test]
    fn counts_are_small() {
        let field = |name: &str, kind| Field { name: name.to_owned(), unit: String::new(), doc: String::new(), kind };
        let ram = |bits| {
            let mut b = Builder::new("counts", Scalar::F64, 0.5);
            let n = b.measurement(field("n", Kind::Count { bits, signed: true }));
            let (ring, last) = (b.counts("ring", "", 5, bits, 0), b.index_cell("last", "", 0));
            let (slot, now) = (b.index(3), b.read_count(n));
            b.set_ring(ring, slot, now);
            let before = b.read(last);
            b.set(last, now);
            let kept = b.read_ring(ring, slot);
            let sum = b.wrap_add(before, kept);
            b.estimate(field("sum", Kind::Float), sum);
            let status = b.status(Status::Converged);
            b.report(status);
            cost(&b.finish(), &[]).ram_bytes
        };
        assert_eq!((ram(16), ram(32)), (16, 24));
    }

    /// Claim: what is not there is not listed.
    #[test]
    fn empty_line() {
        let cost = Cost { ram_bytes: 1, divisions: 1, ..Cost::default() };
        assert_eq!(cost.to_string(), "1 division; RAM 1 byte; constants 0 bytes");
        assert_eq!(Cost::default().to_string(), "no arithmetic; RAM 0 bytes; constants 0 bytes");
    }
}
