//! A Program ready to run: its code, its constants in their places, its cells at their start.

use std::ops::Range;

use super::super::{CellId, CellKind, Kind, Program, Status};
use super::allocate::{Code, allocate};
use super::arithmetic::{Number, counted};
use super::execute::{Memory, Rows};
use super::instruction::{Block, Class, Content, Place};
use super::schedule::schedule;
use super::select::select;

/// A Program with its state, in the float type `F`.
pub(super) struct Machine<F> {
    code: Code,
    measurements: Vec<(Kind, u16)>,
    inputs: Vec<u16>,
    /// How many stages of the code are the start.
    start: usize,
    tables: Vec<Rows<F>>,
    memory: Memory<F>,
}

impl<F: Number> Machine<F> {
    /// The machine of a checked Program, at its start.
    pub fn new(program: &Program) -> Self {
        let (blocks, estimates, status) = select(program);
        let blocks: Vec<Block> = blocks
            .into_iter()
            .map(|block| match block {
                Block::Once(body) => Block::Once(schedule(&body)),
                Block::PerRow(table, body) => Block::PerRow(table, schedule(&body)),
            })
            .collect();
        let code = allocate(&blocks, fixed(program), &estimates, status);
        let rings = (program.cells.iter())
            .map(|cell| match cell.kind {
                CellKind::Ring { len, .. } => vec![F::default(); len as usize],
                _ => vec![],
            })
            .collect();
        let counts = (program.cells.iter())
            .map(|cell| match cell.kind {
                CellKind::Counts { len, .. } => vec![0; len as usize],
                _ => vec![],
            })
            .collect();
        let tables = (program.tables.iter())
            .map(|table| Rows {
                columns: table.columns.len(),
                elements: table.rows.iter().flatten().map(|x| F::from_f64(*x)).collect(),
            })
            .collect();
        let memory = Memory::new(rings, counts);
        let register = |class, content| code.fixed[&Place { class, content }];
        let measurements = (0..=u16::MAX).zip(&program.measurements);
        let inputs = (0..=u16::MAX).zip(&program.inputs);
        let mut machine = Self {
            measurements: (measurements)
                .map(|(at, field)| (field.kind, register(class_of(field.kind), Content::Measurement(at))))
                .collect(),
            inputs: inputs.map(|(at, _)| register(Class::Float, Content::Input(at))).collect(),
            start: usize::from(program.init_at.is_some()),
            code,
            tables,
            memory,
        };
        machine.load_constants();
        machine.reset(program);
        machine
    }

    /// Puts the constants into their registers, which nothing writes.
    fn load_constants(&mut self) {
        for (place, register) in &self.code.fixed {
            match *place {
                Place { class: Class::Float, content: Content::Constant(bits) } => {
                    self.memory.floats[usize::from(*register)] = F::from_f64(f64::from_bits(bits));
                }
                Place { class: Class::Word, content: Content::Constant(word) } => {
                    self.memory.words[usize::from(*register)] =
                        u32::try_from(word).unwrap_or_else(|_| unreachable!("words are below 2^32"));
                }
                _ => {}
            }
        }
    }

    /// Gives every cell its start.
    pub fn reset(&mut self, program: &Program) {
        for (at, cell) in cells(program) {
            match cell {
                CellKind::Float { init } => {
                    self.memory.floats[self.register(Class::Float, Content::Cell(at))] = F::from_f64(*init);
                }
                CellKind::Index { init } => {
                    self.memory.words[self.register(Class::Word, Content::Cell(at))] = *init;
                }
                CellKind::Ring { init, .. } => {
                    self.memory.rings[usize::from(at.0)].fill(F::from_f64(*init));
                }
                CellKind::Counts { init, .. } => self.memory.counts[usize::from(at.0)].fill(*init),
            }
        }
    }

    /// What every cell holds.
    pub fn cells(&self, program: &Program) -> Vec<Vec<f64>> {
        cells(program)
            .map(|(at, cell)| match cell {
                CellKind::Float { .. } => {
                    let register = self.register(Class::Float, Content::Cell(at));
                    vec![self.memory.floats[register].to_f64()]
                }
                CellKind::Index { .. } => {
                    let register = self.register(Class::Word, Content::Cell(at));
                    vec![f64::from(self.memory.words[register])]
                }
                CellKind::Ring { .. } => {
                    let ring = &self.memory.rings[usize::from(at.0)];
                    ring.iter().map(|x| x.to_f64()).collect()
                }
                CellKind::Counts { .. } => {
                    self.memory.counts[usize::from(at.0)].iter().map(|x| f64::from(*x)).collect()
                }
            })
            .collect()
    }

    /// The register of something that keeps its register.
    fn register(&self, class: Class, content: Content) -> usize {
        usize::from(self.code.fixed[&Place { class, content }])
    }

    /// One step.
    pub fn step(&mut self, measurements: &[f64], inputs: &[f64], estimates: &mut [f64]) -> Status {
        for (x, (kind, register)) in measurements.iter().zip(&self.measurements) {
            match *kind {
                Kind::Count { bits, signed } => self.memory.words[usize::from(*register)] = counted(*x, bits, signed),
                Kind::Float | Kind::Index => self.memory.floats[usize::from(*register)] = F::from_f64(*x),
            }
        }
        for (x, register) in inputs.iter().zip(&self.inputs) {
            self.memory.floats[usize::from(*register)] = F::from_f64(*x);
        }
        self.execute(self.start..self.code.stages.len());
        for (estimate, (class, register)) in estimates.iter_mut().zip(&self.code.estimates) {
            *estimate = match class {
                Class::Float => self.memory.floats[usize::from(*register)].to_f64(),
                Class::Word => self.memory.words[usize::from(*register)].into(),
            };
        }
        match self.memory.words[usize::from(self.code.status)] {
            0 => Status::Converging,
            1 => Status::Converged,
            _ => Status::Coasting,
        }
    }

    /// Gives every cell its start from an estimate.
    pub fn start_at(&mut self, program: &Program, given: &[f64], vouched: bool) {
        self.reset(program);
        for (at, (x, (field, _))) in (0..=u16::MAX).zip(given.iter().zip(&program.estimates)) {
            if field.kind == Kind::Float {
                let register = self.register(Class::Float, Content::Given(at));
                self.memory.floats[register] = F::from_f64(*x);
            }
        }
        let register = self.register(Class::Word, Content::Vouched);
        self.memory.words[register] = u32::from(vouched);
        self.execute(0..self.start);
    }

    /// Executes some stages.
    fn execute(&mut self, stages: Range<usize>) {
        for stage in &self.code.stages[stages] {
            match stage.rows_of {
                None => self.memory.execute(&stage.runs, &self.code.operands, &self.tables, &[]),
                Some(table) => {
                    let table = &self.tables[usize::from(table.0)];
                    for row in table.elements.chunks_exact(table.columns) {
                        self.memory.execute(&stage.runs, &self.code.operands, &self.tables, row);
                    }
                }
            }
        }
    }
}

/// The cells with their numbers.
fn cells(program: &Program) -> impl Iterator<Item = (CellId, &CellKind)> {
    (0..=u16::MAX).map(CellId).zip(program.cells.iter().map(|cell| &cell.kind))
}

/// Where a field is.
fn class_of(kind: Kind) -> Class {
    match kind {
        Kind::Float => Class::Float,
        Kind::Count { .. } | Kind::Index => Class::Word,
    }
}

/// What has a register whether or not an instruction names it.
fn fixed(program: &Program) -> Vec<Place> {
    let float = |content| Place { class: Class::Float, content };
    let cells = cells(program).filter_map(|(at, cell)| match cell {
        CellKind::Float { .. } => Some(float(Content::Cell(at))),
        CellKind::Index { .. } => Some(Place { class: Class::Word, content: Content::Cell(at) }),
        CellKind::Ring { .. } | CellKind::Counts { .. } => None,
    });
    let measurements = (0..=u16::MAX).zip(&program.measurements);
    let inputs = (0..=u16::MAX).zip(&program.inputs);
    let given = (0..=u16::MAX).zip(&program.estimates).filter(|_| program.init_at.is_some());
    let vouched = program.init_at.iter().map(|_| Place { class: Class::Word, content: Content::Vouched });
    cells
        .chain(given.map(|(at, _)| float(Content::Given(at))))
        .chain(vouched)
        .chain(measurements.map(|(at, field)| Place { class: class_of(field.kind), content: Content::Measurement(at) }))
        .chain(inputs.map(|(at, _)| float(Content::Input(at))))
        .collect()
}
