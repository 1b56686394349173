//! Runs a Program on this machine, with the bits that its compiled forms have.
//!
//! In: a checked [`Program`], then measurements and inputs. Out: estimates and statuses. An `f32`
//! Program computes in `f32`; its operations are executed one by one, as the Program says, and
//! neither contracted nor reassociated: what is reordered or fused below is dispatch, not
//! arithmetic. A NaN is a NaN: its sign and payload are not part of the meaning.
//!
//! `select` chooses instructions, `schedule` orders them into runs, `allocate` numbers their
//! registers, `machine` holds constants and state, `execute` runs.

mod allocate;
pub(super) mod arithmetic;
mod execute;
mod instruction;
mod machine;
mod schedule;
mod select;

use self::machine::Machine;
use super::check::check;
use super::{Program, Scalar, Status};

/// A Program with its state.
pub struct Interpreter {
    program: Program,
    machine: Typed,
}

/// The machine in the Program's float type.
enum Typed {
    F32(Machine<f32>),
    F64(Machine<f64>),
}

impl Interpreter {
    /// The Program at its start.
    ///
    /// # Panics
    /// For a Program that [`check`] refuses, or that has more than 65,536 floats or more than
    /// 65,536 indices, truth values and statuses in use at one time (constants and scalar cells
    /// included; rings and tables not).
    #[must_use]
    pub fn new(program: &Program) -> Self {
        if let Err(error) = check(program) {
            panic!("program `{}`: {error}", program.name);
        }
        let machine = match program.scalar {
            Scalar::F32 => Typed::F32(Machine::new(program)),
            Scalar::F64 => Typed::F64(Machine::new(program)),
        };
        Self { program: program.clone(), machine }
    }

    /// One call of the step function.
    ///
    /// Measurements and inputs are rounded to nearest even if the Program computes in `f32`;
    /// estimates are widened exactly. A measurement that is a count is a whole number that its
    /// counter can show; of another number the fraction is cut off, what is beyond the counter's
    /// range is its end, and NaN is 0.
    ///
    /// # Panics
    /// If a slice has not exactly one element for each field.
    pub fn step(&mut self, measurements: &[f64], inputs: &[f64], estimates: &mut [f64]) -> Status {
        assert_eq!(measurements.len(), self.program.measurements.len(), "one per measurement");
        assert_eq!(inputs.len(), self.program.inputs.len(), "one per input");
        assert_eq!(estimates.len(), self.program.estimates.len(), "one per estimate");
        match &mut self.machine {
            Typed::F32(machine) => machine.step(measurements, inputs, estimates),
            Typed::F64(machine) => machine.step(measurements, inputs, estimates),
        }
    }

    /// Name and content of every cell, in the Program's order; a scalar cell has one element, an
    /// index is widened exactly.
    #[must_use]
    pub fn cells(&self) -> Vec<(String, Vec<f64>)> {
        let contents = match &self.machine {
            Typed::F32(machine) => machine.cells(&self.program),
            Typed::F64(machine) => machine.cells(&self.program),
        };
        let names = self.program.cells.iter().map(|cell| cell.name.clone());
        names.zip(contents).collect()
    }

    /// Starts from an estimate, a number for each of its fields; with [`Status::Converged`] the caller vouches for it.
    /// Without `init_at` in the Program it is [`Interpreter::reset`].
    ///
    /// # Panics
    /// If there is not one number for each estimate.
    pub fn start_at(&mut self, given: &[f64], status: Status) {
        assert_eq!(given.len(), self.program.estimates.len(), "one per estimate");
        let vouched = status == Status::Converged;
        match &mut self.machine {
            _ if self.program.init_at.is_none() => self.reset(),
            Typed::F32(machine) => machine.start_at(&self.program, given, vouched),
            Typed::F64(machine) => machine.start_at(&self.program, given, vouched),
        }
    }

    /// Puts every cell back to its start.
    pub fn reset(&mut self) {
        match &mut self.machine {
            Typed::F32(machine) => machine.reset(&self.program),
            Typed::F64(machine) => machine.reset(&self.program),
        }
    }
}
