//! Random Programs and random inputs for tests that compare back ends.
//!
//! A Program is a function of its seed. Over a few hundred seeds every operation and statement
//! occurs, in both scalar types, in and out of loops, with constants from the smallest subnormal to
//! the largest number. Results need not be finite; slots and rows are always in bounds.

use deadbeat_codegen::program::builder::Builder;
use deadbeat_codegen::program::{CellId, Field, Function, Kind, Program, Scalar, Status, TableId, Value};

/// The Program of that seed.
pub fn random_program(seed: u64) -> Program {
    let mut random = Random::new(seed);
    let scalar = if random.chance(2) { Scalar::F32 } else { Scalar::F64 };
    let mut writer = Writer {
        b: Builder::new(&format!("random_{seed}"), scalar, 0.125),
        random,
        pools: Pools::default(),
        cells: vec![],
        rings: vec![],
        counts: vec![],
        tables: vec![],
        columns: None,
        calls: seed.is_multiple_of(CALLING),
    };
    writer.declare();
    for part in 0..writer.random.between(1, 3) {
        writer.b.section(&format!("part {part}"));
        writer.statements(20);
        writer.inner();
    }
    writer.statements(10);
    writer.finish()
}

/// Measurements and inputs for that many steps: ordinary numbers, zeros of both signs, subnormals,
/// huge numbers, infinities and NaN; counts anywhere in their range. Numbers are exact in the
/// Program's scalar type.
pub fn random_inputs(seed: u64, program: &Program, steps: usize) -> Vec<(Vec<f64>, Vec<f64>)> {
    let mut random = Random::new(!seed);
    let mut numbers = |fields: &[Field]| {
        let number = |field: &Field| match field.kind {
            Kind::Count { bits, signed } => random.count(bits, signed),
            Kind::Float | Kind::Index => random.sample(program.scalar),
        };
        fields.iter().map(number).collect()
    };
    (0..steps).map(|_| (numbers(&program.measurements), numbers(&program.inputs))).collect()
}

/// Marsaglia's xorshift64.
struct Random(u64);

impl Random {
    /// Neighbouring seeds give unrelated sequences.
    fn new(seed: u64) -> Self {
        let mut random = Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1);
        for _ in 0..8 {
            random.next();
        }
        random
    }

    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0.wrapping_mul(0x2545_f491_4f6c_dd1d)
    }

    /// Any number from `low` to `high`.
    fn between(&mut self, low: u32, high: u32) -> u32 {
        let range = u64::from(high - low) + 1;
        low + u32::try_from((self.next() >> 32) % range).expect("a remainder of less than 2^32 + 1 values")
    }

    /// True once in `n` times.
    fn chance(&mut self, n: u32) -> bool {
        self.between(1, n) == 1
    }

    fn pick<T: Copy>(&mut self, all: &[T]) -> T {
        let last = u32::try_from(all.len()).expect("a short list") - 1;
        all[self.between(0, last) as usize]
    }

    /// A finite number of the scalar type.
    fn constant(&mut self, scalar: Scalar) -> f64 {
        let ordinary = (f64::from(self.between(0, 1 << 20)) - f64::from(1 << 19)) / f64::from(1 << 17);
        let extreme = match scalar {
            Scalar::F32 => [1e-45_f32, 1e-39, f32::MIN_POSITIVE, 1e-20, 1e20, f32::MAX].map(f64::from),
            Scalar::F64 => [5e-324, 1e-310, f64::MIN_POSITIVE, 1e-150, 1e150, f64::MAX],
        };
        let bits = self.next();
        let any = match scalar {
            Scalar::F32 => f64::from(f32::from_bits((bits >> 32) as u32)),
            Scalar::F64 => f64::from_bits(bits),
        };
        let sign = self.pick(&[1.0, -1.0]);
        match self.between(0, 9) {
            0 => sign * 0.0,
            1 => sign * self.pick(&[0.5, 1.0, 2.0, 3.0]),
            2 => sign * self.pick(&extreme),
            3 if any.is_finite() => any,
            _ => ordinary,
        }
    }

    /// What a counter may show: often one of its ends.
    fn count(&mut self, bits: u8, signed: bool) -> f64 {
        let all = self.next() >> (64 - u32::from(bits));
        let raw = self.pick(&[all, all, 0, 1, u64::from(u32::MAX >> (32 - bits)), 1 << (bits - 1)]);
        let raw = u32::try_from(raw).expect("at most 32 bits");
        if signed { f64::from((raw << (32 - bits)).cast_signed() >> (32 - bits)) } else { f64::from(raw) }
    }

    /// A number that a sensor may give, or not a number.
    fn sample(&mut self, scalar: Scalar) -> f64 {
        match self.between(0, 19) {
            0 => f64::NAN,
            1 => f64::INFINITY,
            2 => f64::NEG_INFINITY,
            _ => self.constant(scalar),
        }
    }
}

/// The values that may be used now.
#[derive(Clone, Default)]
struct Pools {
    floats: Vec<Value>,
    indices: Vec<Value>,
    truths: Vec<Value>,
    statuses: Vec<Value>,
    /// Indices with a bound that they do not exceed.
    slots: Vec<(Value, u32)>,
}

/// A Program being written at random.
struct Writer {
    b: Builder,
    random: Random,
    pools: Pools,
    cells: Vec<CellId>,
    rings: Vec<(CellId, u32)>,
    counts: Vec<(CellId, u32)>,
    /// With their numbers of rows and columns.
    tables: Vec<(TableId, u32, u16)>,
    /// In a loop, the columns of its table.
    columns: Option<u16>,
    /// Whether elementary functions occur.
    calls: bool,
}

/// One Program in so many calls elementary functions: each brings the runtime's C with it, which is
/// most of what there is to compile.
const CALLING: u64 = 5;

/// The first cells hold floats, the others indices.
const FLOAT_CELLS: usize = 3;

impl Writer {
    /// The interface, the cells, the tables, and a first value of each type.
    fn declare(&mut self) {
        for at in 0..self.random.between(1, 3) {
            let field = self.b.measurement(field(&format!("y{at}"), "rad"));
            let value = self.b.read_measurement(field);
            self.pools.floats.push(value);
        }
        for at in 0..self.random.between(0, 2) {
            let kind = Kind::Count { bits: self.random.pick(&[16, 32]), signed: self.random.chance(2) };
            let field = self.b.measurement(Field { kind, ..field(&format!("n{at}"), "") });
            let value = self.b.read_count(field);
            self.pools.indices.push(value);
        }
        for at in 0..self.random.between(0, 2) {
            let field = self.b.input(field(&format!("u{at}"), "V"));
            let value = self.b.read_input(field);
            self.pools.floats.push(value);
        }
        for _ in 0..FLOAT_CELLS {
            let init = self.constant();
            self.cells.push(self.b.float_cell("state", "a float", init));
        }
        for _ in 0..2 {
            let init = self.random.pick(&[0, 1, 5, u32::MAX]);
            self.cells.push(self.b.index_cell("count", "an index", init));
        }
        for _ in 0..2 {
            let (len, init) = (self.random.between(1, 9), self.constant());
            self.rings.push((self.b.ring("window", "samples", len, init), len));
        }
        for bits in [16, 32] {
            let (len, init) = (self.random.between(1, 9), self.random.pick(&[0, 7, u32::MAX >> (32 - bits)]));
            self.counts.push((self.b.counts("counts", "raw samples", len, bits, init), len));
        }
        for _ in 0..2 {
            let (rows, columns) = (self.random.between(1, 7), self.random.pick(&[1, 2, 3]));
            let names = (0..columns).map(|at| format!("column {at}")).collect();
            let elements = (0..rows).map(|_| (0..columns).map(|_| self.constant()).collect()).collect();
            self.tables.push((self.b.table("GAINS", "gains", names, elements), rows, columns));
        }
        self.truth();
        self.index();
        self.status();
    }

    /// About that many statements.
    fn statements(&mut self, count: u32) {
        for _ in 0..count {
            match self.random.between(0, 19) {
                10 if self.calls => self.call(),
                0..=7 | 10 => self.arithmetic(),
                8 | 9 => self.float(),
                11 | 12 => self.truth(),
                13 | 14 => self.index(),
                15 | 16 => self.slot(),
                17 => self.status(),
                _ => self.write(),
            }
        }
    }

    /// A loop that carries values of every type.
    fn inner(&mut self) {
        let (table, _, columns) = self.random.pick(&self.tables);
        let outside = self.pools.clone();
        let (slot, bound) = self.fresh_slot();
        let mut starts = vec![slot, self.any_truth(), self.any_index(), self.any_status()];
        for _ in 0..self.random.between(1, 3) {
            starts.push(self.any_float());
        }
        let ends = self.looped(table, columns, &starts, bound);
        self.pools = outside;
        self.receive(&ends, bound);
    }

    /// The loop; the builder changes hands for the time of its body.
    fn looped(&mut self, table: TableId, columns: u16, starts: &[Value], bound: u32) -> Vec<Value> {
        let mut builder = std::mem::replace(&mut self.b, Builder::new("none", Scalar::F32, 1.0));
        let ends = builder.loop_over(table, starts, |b, carried| {
            std::mem::swap(&mut self.b, b);
            self.columns = Some(columns);
            self.receive(carried, bound);
            self.statements(8);
            let next = self.hand_on(carried, bound);
            self.columns = None;
            std::mem::swap(&mut self.b, b);
            next
        });
        self.b = builder;
        ends
    }

    /// What a loop carries can be used.
    fn receive(&mut self, carried: &[Value], bound: u32) {
        self.pools.slots.push((carried[0], bound));
        self.pools.truths.push(carried[1]);
        self.pools.indices.extend([carried[0], carried[2]]);
        self.pools.statuses.push(carried[3]);
        self.pools.floats.extend(&carried[4..]);
    }

    /// The next carried values: mostly new ones, sums of products among them, sometimes each
    /// other's or what stands outside of the loop.
    fn hand_on(&mut self, carried: &[Value], bound: u32) -> Vec<Value> {
        let slot = match self.random.between(0, 3) {
            0 => self.b.advance(carried[0], bound + 1),
            1 => self.b.count_down(carried[0]),
            _ => self.b.retreat(carried[0], bound + 1),
        };
        let mut next = vec![slot, self.any_truth(), self.any_index(), self.any_status()];
        for sum in &carried[4..] {
            next.push(match self.random.between(0, 3) {
                0 => self.any_float(),
                _ => self.accumulate(*sum),
            });
        }
        next
    }

    /// `sum + gain * x` or `sum - gain * x`.
    fn accumulate(&mut self, sum: Value) -> Value {
        let (gain, x) = (self.gain(), self.any_float());
        let product = self.b.mul(gain, x);
        match self.random.between(0, 2) {
            0 => self.b.add(sum, product),
            1 => self.b.add(product, sum),
            _ => self.b.sub(sum, product),
        }
    }

    /// An element of the loop's row; outside of a loop a constant.
    fn gain(&mut self) -> Value {
        if let Some(columns) = self.columns {
            let column = self.random.between(0, u32::from(columns) - 1);
            self.b.gain(u16::try_from(column).expect("a column of the table"))
        } else {
            let constant = self.constant();
            self.b.float(constant)
        }
    }

    /// A float from floats.
    fn arithmetic(&mut self) {
        let (a, b) = (self.any_float(), self.any_float());
        let value = match self.random.between(0, 11) {
            0 => self.b.neg(a),
            1 | 2 => self.b.add(a, b),
            3 => self.b.sub(a, b),
            4 | 5 => self.b.mul(a, b),
            6 => self.b.div(a, b),
            7 => {
                let condition = self.any_truth();
                self.b.select(condition, a, b)
            }
            8 => self.composed(a, b),
            _ => self.accumulate(a),
        };
        self.pools.floats.push(value);
    }

    /// One of the forms of several operations.
    fn composed(&mut self, a: Value, b: Value) -> Value {
        match self.random.between(0, 5) {
            0 => self.b.absolute(a),
            1 => self.b.sign(a),
            2 => self.b.minimum(a, b),
            3 => self.b.maximum(a, b),
            4 => {
                let exponent = self.random.between(0, 9);
                self.b.power(a, exponent)
            }
            _ => {
                let terms: Vec<Value> = (0..self.random.between(0, 9)).map(|_| self.any_float()).collect();
                self.b.sum(&terms)
            }
        }
    }

    /// A float from somewhere else.
    fn float(&mut self) {
        let value = match self.random.between(0, 5) {
            0 => {
                let cell = self.random.pick(&self.cells[..FLOAT_CELLS]);
                self.b.read(cell)
            }
            5 => {
                let index = self.any_index();
                self.b.signed_to_float(index)
            }
            1 => {
                let (ring, len) = self.random.pick(&self.rings);
                let slot = self.slot_below(len);
                self.b.read_ring(ring, slot)
            }
            2 => {
                let (table, rows, columns) = self.random.pick(&self.tables);
                let (row, column) = (self.slot_below(rows), self.random.between(0, u32::from(columns) - 1));
                self.b.lookup(table, row, u16::try_from(column).expect("a column of the table"))
            }
            3 => {
                let index = self.any_index();
                self.b.to_float(index)
            }
            _ => self.gain(),
        };
        self.pools.floats.push(value);
    }

    /// An elementary function.
    fn call(&mut self) {
        let function = self.random.pick(&Function::ALL);
        let arguments: Vec<Value> = (0..function.arity()).map(|_| self.any_float()).collect();
        let value = self.b.call(function, &arguments);
        self.pools.floats.push(value);
    }

    /// A truth value.
    fn truth(&mut self) {
        let (a, b) = (self.any_float(), self.any_float());
        let value = match self.random.between(0, 8) {
            0 => self.b.less(a, b),
            1 => self.b.less_equal(a, b),
            2 | 3 => {
                let (low, high) = (self.constant(), self.constant());
                self.b.in_range(a, low.min(high), high.max(low))
            }
            kind => self.logic(kind),
        };
        self.pools.truths.push(value);
    }

    /// A truth value from truth values or indices.
    fn logic(&mut self, kind: u32) -> Value {
        let (a, b) = (self.any_truth(), self.any_truth());
        let (m, n) = (self.any_index(), self.any_index());
        match kind {
            4 => self.b.and(a, b),
            5 => self.b.or(a, b),
            6 => self.b.not(a),
            7 => self.b.index_less(m, n),
            _ => self.b.index_equal(m, n),
        }
    }

    /// An index of any size.
    fn index(&mut self) {
        let value = match self.random.between(0, 9) {
            0 => {
                let number = self.random.pick(&[0, 1, 2, 7, 1000, u32::MAX]);
                self.b.index(number)
            }
            kind @ 5..=9 => self.counted(kind),
            1 | 2 => {
                let cell = self.random.pick(&self.cells[FLOAT_CELLS..]);
                self.b.read(cell)
            }
            3 => {
                let count = self.any_index();
                self.b.count_down(count)
            }
            _ => {
                let (condition, a, b) = (self.any_truth(), self.any_index(), self.any_index());
                self.b.select(condition, a, b)
            }
        };
        self.pools.indices.push(value);
    }

    /// An index as a counter's readings are handled.
    fn counted(&mut self, kind: u32) -> Value {
        let (a, b) = (self.any_index(), self.any_index());
        match kind {
            5 => {
                let float = self.any_float();
                self.b.from_float(float)
            }
            6 => self.b.wrap_add(a, b),
            8 => {
                let modulus = self.random.pick(&[1, 2, 3, 2_156, 40_000, u32::MAX]);
                self.b.remainder(a, modulus)
            }
            7 => {
                let bits = self.random.pick(&[16, 32]);
                self.b.wrap_difference(a, b, bits)
            }
            _ => {
                let (ring, len) = self.random.pick(&self.counts);
                let slot = self.slot_below(len);
                self.b.read_ring(ring, slot)
            }
        }
    }

    /// A bounded index.
    fn slot(&mut self) {
        let slot = self.fresh_slot();
        self.pools.slots.push(slot);
        self.pools.indices.push(slot.0);
    }

    /// A bounded index from any index, with its bound.
    fn fresh_slot(&mut self) -> (Value, u32) {
        let (_, len) = self.random.pick(&self.rings);
        (self.slot_below(len), len - 1)
    }

    /// An index below `len`.
    fn slot_below(&mut self, len: u32) -> Value {
        let index = self.any_index();
        match self.random.between(0, 6) {
            0 => {
                let number = self.random.between(0, len - 1);
                self.b.index(number)
            }
            1 => self.b.advance(index, len),
            2 => self.b.retreat(index, len),
            3 => self.b.count_up(index, len - 1),
            4 => self.b.at_most(index, len - 1),
            _ => self.known_slot(index, len),
        }
    }

    /// A slot that is in the pool already, if one is small enough.
    fn known_slot(&mut self, index: Value, len: u32) -> Value {
        let fitting: Vec<Value> =
            self.pools.slots.iter().filter(|(_, bound)| *bound < len).map(|(slot, _)| *slot).collect();
        if fitting.is_empty() { self.b.at_most(index, len - 1) } else { self.random.pick(&fitting) }
    }

    /// A status.
    fn status(&mut self) {
        let constant = self.random.pick(&[Status::Converging, Status::Converged, Status::Coasting]);
        let constant = self.b.status(constant);
        let value = match self.pools.statuses.last() {
            Some(last) => {
                let (last, condition) = (*last, self.any_truth());
                self.b.select(condition, constant, last)
            }
            None => constant,
        };
        self.pools.statuses.push(value);
    }

    /// Writes a cell or an element of a ring.
    fn write(&mut self) {
        match self.random.between(0, 3) {
            3 => {
                let (ring, len) = self.random.pick(&self.counts);
                let (slot, value) = (self.slot_below(len), self.any_index());
                self.b.set_ring(ring, slot, value);
            }
            0 => {
                let (cell, value) = (self.random.pick(&self.cells[..FLOAT_CELLS]), self.any_float());
                self.b.set(cell, value);
            }
            1 => {
                let (cell, value) = (self.random.pick(&self.cells[FLOAT_CELLS..]), self.any_index());
                self.b.set(cell, value);
            }
            _ => {
                let (ring, len) = self.random.pick(&self.rings);
                let (slot, value) = (self.slot_below(len), self.any_float());
                self.b.set_ring(ring, slot, value);
            }
        }
    }

    /// The newest floats and the newest truth value are estimated, so that little is pruned.
    fn finish(mut self) -> Program {
        let newest: Vec<Value> = self.pools.floats.iter().rev().take(8).copied().collect();
        for (at, value) in newest.into_iter().enumerate() {
            self.b.estimate(field(&format!("x{at}"), "rad/s"), value);
        }
        let (truth, index) = (self.any_truth(), self.any_index());
        let (one, count) = (self.b.float(1.0), self.b.to_float(index));
        let flag = self.b.select(truth, one, count);
        self.b.estimate(field("flag", ""), flag);
        self.b.estimate(field("number", ""), index);
        let status = self.any_status();
        self.b.report(status);
        if self.random.chance(2) {
            self.start();
        }
        self.b.finish()
    }

    /// A start from an estimate: some of it goes into cells and rings, often long enough to be split into functions.
    fn start(&mut self) {
        let Self { b, random, cells, rings, .. } = self;
        let length = random.pick(&[3, 20, 120]);
        b.init_at(|b| {
            let mut floats = vec![b.given(0), b.given(1)];
            let mut truths = vec![b.vouched()];
            b.section("from the estimate");
            for _ in 0..length {
                let (x, y, truth) = (random.pick(&floats), random.pick(&floats), random.pick(&truths));
                match random.between(0, 6) {
                    0 => truths.push(b.in_range(x, -1.0, 2.0)),
                    1 => floats.push(b.select(truth, x, y)),
                    2 => floats.push(b.mul(x, y)),
                    3 => floats.push(b.add(x, y)),
                    4 => {
                        let (ring, len) = random.pick(rings);
                        let slot = b.index(len - 1);
                        b.set_ring(ring, slot, x);
                    }
                    5 => b.set(random.pick(&cells[..FLOAT_CELLS]), x),
                    _ => {
                        let (one, nine) = (b.index(1), b.index(9));
                        let chosen = b.select(truth, one, nine);
                        b.set(random.pick(&cells[FLOAT_CELLS..]), chosen);
                    }
                }
            }
        });
    }

    fn constant(&mut self) -> f64 {
        self.random.constant(self.b.scalar())
    }

    /// A recent float more often than an old one.
    fn any_float(&mut self) -> Value {
        let floats = &self.pools.floats;
        let recent = if self.random.chance(2) { floats.len().saturating_sub(6) } else { 0 };
        self.random.pick(&floats[recent..])
    }

    fn any_index(&mut self) -> Value {
        if self.pools.indices.is_empty() { self.b.index(0) } else { self.random.pick(&self.pools.indices) }
    }

    fn any_truth(&mut self) -> Value {
        if self.pools.truths.is_empty() { self.b.boolean(false) } else { self.random.pick(&self.pools.truths) }
    }

    fn any_status(&mut self) -> Value {
        self.random.pick(&self.pools.statuses)
    }
}

/// A field without a description.
fn field(name: &str, unit: &str) -> Field {
    Field { name: name.to_owned(), unit: unit.to_owned(), doc: String::new(), kind: Kind::Float }
}
