//! One broken Program for each rule.

use super::super::builder::Builder;
use super::super::{
    Carried, Cell, CellId, CellKind, Field, Function, Kind, Loop, Op, Program, Scalar, Statement, Status, Table,
    TableId, Type, Value,
};
use super::{Flaw, check};

/// Cells `p` (float), `n` (index), `r` (ring of 3); table `T` of 3 rows and 2 columns; the loop is
/// statement 3 and carries `t2` (a slot) and `t3` (a float).
fn sound() -> Program {
    let field =
        |name: &str| Field { name: name.to_owned(), unit: String::new(), doc: String::new(), kind: Kind::Float };
    let mut b = Builder::new("sound", Scalar::F32, 0.5);
    let (y, u) = (b.measurement(field("y")), b.input(field("u")));
    let (p, n, r) = (b.float_cell("p", "", 0.5), b.index_cell("n", "", 1), b.ring("r", "", 3, 0.0));
    let columns = vec!["a".to_owned(), "b".to_owned()];
    let table = b.table("T", "", columns, vec![vec![1.0, 2.0]; 3]);
    let slot = b.index(2);
    let measured = b.read_measurement(y);
    b.section("window");
    let ends = b.loop_over(table, &[slot, measured], |b, carried| {
        let (x, gain, other) = (b.read_ring(r, carried[0]), b.gain(0), b.gain(1));
        let product = b.mul(gain, x);
        let sum = b.add(carried[1], product);
        let sum = b.add(sum, other);
        vec![b.retreat(carried[0], 3), sum]
    });
    b.section("state");
    let (applied, count, old) = (b.read_input(u), b.read(n), b.read(p));
    let count = b.count_up(count, 7);
    let slot = b.at_most(count, 2);
    b.set(n, count);
    b.set_ring(r, slot, applied);
    let looked_up = b.lookup(table, slot, 1);
    let new = b.sum(&[old, looked_up, ends[1]]);
    b.set(p, new);
    b.estimate(field("x"), new);
    let status = b.status(Status::Converged);
    b.report(status);
    b.finish()
}

/// The flaw of the sound Program after the change.
fn flaw(change: impl FnOnce(&mut Program)) -> Flaw {
    let mut program = sound();
    change(&mut program);
    check(&program).expect_err("the program is broken").flaw
}

/// The flaw of the sound Program with another operation at its end.
fn flaw_of(op: Op) -> Flaw {
    flaw(|program| program.body.push(Statement::Let { value: Value(100), op }))
}

/// The loop of the sound Program.
fn inner(program: &mut Program) -> &mut Loop {
    let found = program.body.iter_mut().find_map(|statement| match statement {
        Statement::Loop(inner) => Some(inner),
        _ => None,
    });
    found.expect("the sound program has a loop")
}

/// A value of that type in the sound Program, visible at its end.
fn any(r#type: Type) -> Value {
    let program = sound();
    let found = program.body.iter().find_map(|statement| match (statement, r#type) {
        (Statement::Let { value, op: Op::Measurement(_) }, Type::Float)
        | (Statement::Let { value, op: Op::Cell(CellId(1)) }, Type::Index)
        | (Statement::Let { value, op: Op::Status(_) }, Type::Status) => Some(*value),
        _ => None,
    });
    found.expect("the sound program has one")
}

/// Claim: the Program that the others break is sound.
#[test]
fn sound_is_sound() {
    assert_eq!(check(&sound()), Ok(()));
}

/// Claim: an error names the statement and the flaw.
#[test]
fn errors_name_the_statement() {
    let mut program = sound();
    program.body.push(Statement::SetCell { cell: CellId(0), value: Value(99) });
    let error = check(&program).expect_err("t99 is not defined");
    assert_eq!(error.to_string(), "`p := t99`: t99 is not defined here");
}

#[test]
fn definitions() {
    let float = any(Type::Float);
    assert_eq!(flaw_of(Op::Neg(Value(100))), Flaw::Undefined(Value(100)));
    assert_eq!(flaw(|p| p.status = Value(99)), Flaw::Undefined(Value(99)));
    assert_eq!(flaw(|p| p.estimates[0].1 = Value(99)), Flaw::Undefined(Value(99)));
    let again = Statement::Let { value: float, op: Op::Float(1.0) };
    assert_eq!(flaw(|p| p.body.push(again)), Flaw::DefinedTwice(float));
    let carried = flaw(|p| inner(p).carried[1].value = float);
    assert_eq!(carried, Flaw::DefinedTwice(float));
}

#[test]
fn scopes() {
    let hidden = inner(&mut sound()).carried[1].next;
    assert_eq!(flaw_of(Op::Neg(hidden)), Flaw::Undefined(hidden));
    assert_eq!(flaw(|p| inner(p).carried[0].start = hidden), Flaw::Undefined(hidden));
    let outer = any(Type::Float);
    assert_eq!(flaw(|p| inner(p).carried[1].next = outer), Flaw::NextNotInBody(outer));
    let other = inner(&mut sound()).carried[0].value;
    assert_eq!(flaw(|p| inner(p).carried[1].next = other), Flaw::NextNotInBody(other));
}

#[test]
fn types() {
    let (float, index, status) = (any(Type::Float), any(Type::Index), any(Type::Status));
    let wrong = |value, expected, found| Flaw::WrongType { value, expected, found };
    assert_eq!(flaw_of(Op::Add(float, index)), wrong(index, Type::Float, Type::Index));
    assert_eq!(flaw_of(Op::Not(float)), wrong(float, Type::Bool, Type::Float));
    assert_eq!(flaw_of(Op::IndexLess(index, float)), wrong(float, Type::Index, Type::Float));
    let select = |condition, then, otherwise| Op::Select { condition, then, otherwise };
    assert_eq!(flaw_of(select(index, float, float)), wrong(index, Type::Bool, Type::Index));
    assert_eq!(flaw(|p| p.status = float), wrong(float, Type::Status, Type::Float));
    assert_eq!(flaw(|p| p.estimates[0].1 = status), wrong(status, Type::Float, Type::Status));
    let set = Statement::SetCell { cell: CellId(1), value: float };
    assert_eq!(flaw(|p| p.body.push(set)), wrong(float, Type::Index, Type::Float));
    let next = inner(&mut sound()).carried[0].next;
    assert_eq!(flaw(|p| inner(p).carried[1].next = next), wrong(next, Type::Float, Type::Index));
}

#[test]
fn select_branches_agree() {
    let mut program = sound();
    let (float, index) = (any(Type::Float), any(Type::Index));
    let condition = Value(100);
    program.body.push(Statement::Let { value: condition, op: Op::Bool(true) });
    let op = Op::Select { condition, then: float, otherwise: index };
    program.body.push(Statement::Let { value: Value(101), op });
    let expected = Flaw::WrongType { value: index, expected: Type::Float, found: Type::Index };
    assert_eq!(check(&program).map_err(|error| error.flaw), Err(expected));
}

#[test]
fn arities() {
    let float = any(Type::Float);
    for (function, given) in [(Function::Sin, 2), (Function::Pow, 1)] {
        assert_eq!(flaw_of(Op::Call(function, vec![float; given])), Flaw::Arity { function, given });
    }
}

#[test]
fn constants() {
    for x in [0.1, 1e300, 1e-60] {
        assert_eq!(flaw_of(Op::Float(x)), Flaw::NotRepresentable(x));
        assert_eq!(flaw(|p| p.tables[0].rows[1][1] = x), Flaw::NotRepresentable(x));
        assert_eq!(flaw(|p| p.cells[0].kind = CellKind::Float { init: x }), Flaw::NotRepresentable(x));
    }
    assert_eq!(flaw_of(Op::Float(f64::INFINITY)), Flaw::NotRepresentable(f64::INFINITY));
    assert!(matches!(flaw_of(Op::Float(f64::NAN)), Flaw::NotRepresentable(_)));
    let value = any(Type::Float);
    assert_eq!(flaw_of(Op::InRange { value, low: 2.0, high: 1.0 }), Flaw::EmptyRange { low: 2.0, high: 1.0 });
    assert_eq!(flaw_of(Op::InRange { value, low: 0.1, high: 1.0 }), Flaw::NotRepresentable(0.1));
    assert_eq!(flaw(|p| p.sample_time = 0.1), Flaw::NotRepresentable(0.1));
    assert_eq!(flaw(|p| p.sample_time = 0.0), Flaw::SampleTime(0.0));
}

#[test]
fn references() {
    let (float, index) = (any(Type::Float), any(Type::Index));
    assert_eq!(flaw_of(Op::Measurement(1)), Flaw::NoSuchField(1));
    assert_eq!(flaw_of(Op::Input(1)), Flaw::NoSuchField(1));
    assert_eq!(flaw_of(Op::Cell(CellId(3))), Flaw::NoSuchCell(CellId(3)));
    assert_eq!(flaw_of(Op::Cell(CellId(2))), Flaw::WrongKind(CellId(2)));
    assert_eq!(flaw_of(Op::Ring { ring: CellId(0), slot: index }), Flaw::WrongKind(CellId(0)));
    let set = Statement::SetRing { ring: CellId(1), slot: index, value: float };
    assert_eq!(flaw(|p| p.body.push(set)), Flaw::WrongKind(CellId(1)));
    let lookup = |table, column| Op::Lookup { table: TableId(table), row: index, column };
    assert_eq!(flaw_of(lookup(1, 0)), Flaw::NoSuchTable(TableId(1)));
    assert_eq!(flaw_of(lookup(0, 2)), Flaw::NoSuchColumn { table: TableId(0), column: 2 });
    assert_eq!(flaw(|p| inner(p).table = TableId(1)), Flaw::NoSuchTable(TableId(1)));
    assert_eq!(flaw_of(Op::Gain { column: 0 }), Flaw::GainOutsideLoop);
    let gain = Statement::Let { value: Value(100), op: Op::Gain { column: 2 } };
    let column = Flaw::NoSuchColumn { table: TableId(0), column: 2 };
    assert_eq!(flaw(|p| inner(p).body.push(gain)), column);
}

#[test]
fn loops_hold_plain_statements() {
    let nested = Statement::Loop(Loop { table: TableId(0), carried: vec![], body: vec![] });
    assert_eq!(flaw(|p| inner(p).body.push(nested)), Flaw::NestedLoop);
    let section = Statement::Section("heading".to_owned());
    assert_eq!(flaw(|p| inner(p).body.push(section)), Flaw::SectionInLoop);
}

#[test]
fn ends_of_rings_and_tables() {
    let index = any(Type::Index);
    let beyond = |at_most| Flaw::OutOfBounds { value: index, at_most, len: 3 };
    assert_eq!(flaw_of(Op::Ring { ring: CellId(2), slot: index }), beyond(u32::MAX));
    let lookup = Op::Lookup { table: TableId(0), row: index, column: 0 };
    assert_eq!(flaw_of(lookup), beyond(u32::MAX));
    let value = any(Type::Float);
    let set = Statement::SetRing { ring: CellId(2), slot: index, value };
    assert_eq!(flaw(|p| p.body.push(set)), beyond(u32::MAX));
    assert_eq!(flaw_of(Op::Advance { slot: index, len: 0 }), Flaw::EmptyRing);
    assert_eq!(flaw_of(Op::Retreat { slot: index, len: 0 }), Flaw::EmptyRing);
    assert_eq!(flaw_of(Op::Remainder { value: index, modulus: 0 }), Flaw::NoModulus);
}

/// The flaw of reading the ring of three slots at the result of `ops`, the first of which is `t100`.
fn bound(ops: impl IntoIterator<Item = Op>) -> Option<u32> {
    let mut program = sound();
    let mut slot = Value(99);
    for op in ops {
        slot = Value(slot.0 + 1);
        program.body.push(Statement::Let { value: slot, op });
    }
    let op = Op::Ring { ring: CellId(2), slot };
    program.body.push(Statement::Let { value: Value(200), op });
    match check(&program).map_err(|error| error.flaw) {
        Err(Flaw::OutOfBounds { at_most, .. }) => Some(at_most),
        verdict => {
            assert_eq!(verdict, Ok(()));
            None
        }
    }
}

/// Claim: each index operation has the bound that its meaning gives, and no smaller one.
#[test]
fn bounds_of_operations() {
    let (cell, t100, t101) = (Op::Cell(CellId(1)), Value(100), Value(101));
    let after = |op: Op| bound([cell.clone(), op]);
    assert_eq!(bound([Op::Index(2)]), None);
    assert_eq!(bound([Op::Index(3)]), Some(3));
    assert_eq!(after(Op::Advance { slot: t100, len: 3 }), None);
    assert_eq!(after(Op::Advance { slot: t100, len: 4 }), Some(3));
    assert_eq!(after(Op::Retreat { slot: t100, len: 3 }), None);
    assert_eq!(after(Op::Retreat { slot: t100, len: 4 }), Some(3));
    assert_eq!(after(Op::CountUp { count: t100, max: 2 }), None);
    assert_eq!(after(Op::CountUp { count: t100, max: 3 }), Some(3));
    assert_eq!(after(Op::AtMost { value: t100, max: 2 }), None);
    assert_eq!(after(Op::Remainder { value: t100, modulus: 3 }), None);
    assert_eq!(after(Op::Remainder { value: t100, modulus: 4 }), Some(3));
    assert_eq!(after(Op::AtMost { value: t100, max: 5 }), Some(5));
    assert_eq!(after(Op::CountDown(t100)), Some(u32::MAX));
    assert_eq!(bound([Op::Index(2), Op::AtMost { value: t100, max: 5 }]), None);
    assert_eq!(bound([Op::Index(2), Op::CountDown(t100)]), None);
    let select = Op::Select { condition: Value(102), then: t100, otherwise: t101 };
    let chosen = |a, b| bound([Op::Index(a), Op::Index(b), Op::Bool(true), select.clone()]);
    assert_eq!(chosen(1, 2), None);
    assert_eq!(chosen(2, 4), Some(4));
    assert_eq!(chosen(5, 2), Some(5));
}

/// Claim: what a loop carries is bounded by its start and by everything that it is handed on,
/// through as many carried values as it takes.
#[test]
fn bounds_of_carried_values() {
    let chain = |last: u32| {
        let mut program = sound();
        let (start, value) = (Value(100), |at: u32| Value(110 + at));
        program.body.push(Statement::Let { value: start, op: Op::Index(0) });
        let shift = (0..4).map(|at| {
            let op = if at < 3 { Op::CountDown(value(at + 1)) } else { Op::Index(last) };
            Statement::Let { value: Value(120 + at), op }
        });
        let read = Op::Ring { ring: CellId(2), slot: value(0) };
        let body = shift.chain([Statement::Let { value: Value(130), op: read }]).collect();
        let carried = (0..4).map(|at| Carried { value: value(at), start, next: Value(120 + at) }).collect();
        program.body.push(Statement::Loop(Loop { table: TableId(0), carried, body }));
        check(&program).map_err(|error| error.flaw)
    };
    assert_eq!(chain(2), Ok(()));
    assert_eq!(chain(3), Err(Flaw::OutOfBounds { value: Value(110), at_most: 3, len: 3 }));
}

#[test]
fn names() {
    let name = |name: &str| Flaw::Name(name.to_owned());
    let same = |name: &str| Flaw::SameName(name.to_owned());
    assert_eq!(flaw(|p| "Big".clone_into(&mut p.name)), name("Big"));
    assert_eq!(flaw(|p| "2nd".clone_into(&mut p.measurements[0].name)), name("2nd"));
    assert_eq!(flaw(|p| "a-b".clone_into(&mut p.inputs[0].name)), name("a-b"));
    assert_eq!(flaw(|p| String::new().clone_into(&mut p.estimates[0].0.name)), name(""));
    assert_eq!(flaw(|p| "é".clone_into(&mut p.cells[0].name)), name("é"));
    assert_eq!(flaw(|p| "gains".clone_into(&mut p.tables[0].name)), name("gains"));
    assert_eq!(flaw(|p| "n".clone_into(&mut p.cells[0].name)), same("n"));
    assert_eq!(flaw(|p| p.tables.push(p.tables[0].clone())), same("T"));
    assert_eq!(flaw(|p| p.measurements.push(p.measurements[0].clone())), same("y"));
    assert_eq!(flaw(|p| p.measurements.clear()), Flaw::NoMeasurement);
}

#[test]
fn texts_are_one_line() {
    let two_lines = || "one\ntwo".to_owned();
    let flaws = [
        flaw(|p| p.measurements[0].doc = two_lines()),
        flaw(|p| p.inputs[0].unit = two_lines()),
        flaw(|p| p.cells[0].doc = two_lines()),
        flaw(|p| p.tables[0].doc = two_lines()),
        flaw(|p| p.tables[0].columns[0] = two_lines()),
        flaw(|p| p.body.push(Statement::Section(two_lines()))),
    ];
    for flaw in flaws {
        assert_eq!(flaw, Flaw::NotOneLine(two_lines()));
    }
}

#[test]
fn shapes() {
    assert_eq!(flaw(|p| p.tables[0].rows.clear()), Flaw::EmptyTable);
    assert_eq!(flaw(|p| p.tables[0].rows[1].push(1.0)), Flaw::RaggedRow(1));
    let table = Table { name: "E".to_owned(), doc: String::new(), columns: vec![], rows: vec![vec![]] };
    assert_eq!(flaw(|p| p.tables.push(table)), Flaw::EmptyTable);
    let kind = CellKind::Ring { len: 0, init: 0.0 };
    let cell = Cell { name: "e".to_owned(), doc: String::new(), kind };
    assert_eq!(flaw(|p| p.cells.push(cell)), Flaw::EmptyRing);
}

/// The sound Program with a count of 16 bits as its second measurement and a ring of counts as its last cell.
fn counting(change: impl FnOnce(&mut Program)) -> Result<(), Flaw> {
    let mut program = sound();
    let kind = Kind::Count { bits: 16, signed: false };
    program.measurements.push(Field { name: "m".to_owned(), unit: String::new(), doc: String::new(), kind });
    let kind = CellKind::Counts { len: 3, init: 65_535, bits: 16 };
    program.cells.push(Cell { name: "c".to_owned(), doc: String::new(), kind });
    change(&mut program);
    check(&program).map_err(|error| error.flaw)
}

/// Claim: integers stand only where the interface and the cells have integers.
#[test]
fn counts() {
    let (float, index) = (any(Type::Float), any(Type::Index));
    let wrong = |value, expected, found| Err(Flaw::WrongType { value, expected, found });
    let with = |op: Op| counting(|p| p.body.push(Statement::Let { value: Value(100), op }));
    assert_eq!(with(Op::Count(1)), Ok(()));
    assert_eq!(with(Op::Count(0)), Err(Flaw::WrongField(0)));
    assert_eq!(with(Op::Count(2)), Err(Flaw::NoSuchField(2)));
    assert_eq!(with(Op::Measurement(1)), Err(Flaw::WrongField(1)));
    assert_eq!(with(Op::Difference { a: index, b: index, bits: 24 }), Err(Flaw::Width(24)));
    assert_eq!(with(Op::Difference { a: index, b: float, bits: 16 }), wrong(float, Type::Index, Type::Float));
    assert_eq!(with(Op::WrapAdd(float, index)), wrong(float, Type::Index, Type::Float));
    assert_eq!(with(Op::SignedToFloat(float)), wrong(float, Type::Index, Type::Float));
    assert_eq!(with(Op::FromFloat(index)), wrong(index, Type::Float, Type::Index));
    assert_eq!(with(Op::Cell(CellId(3))), Err(Flaw::WrongKind(CellId(3))));
    let beyond = Err(Flaw::OutOfBounds { value: index, at_most: u32::MAX, len: 3 });
    assert_eq!(with(Op::Ring { ring: CellId(3), slot: index }), beyond);

    let set = |ring, value| {
        counting(|p| {
            p.body.push(Statement::Let { value: Value(100), op: Op::Index(2) });
            p.body.push(Statement::SetRing { ring: CellId(ring), slot: Value(100), value });
        })
    };
    assert_eq!(set(3, index), Ok(()));
    assert_eq!(set(3, float), wrong(float, Type::Index, Type::Float));
    assert_eq!(set(2, index), wrong(index, Type::Float, Type::Index));

    let kind = |kind: Kind| counting(|p| p.measurements[1].kind = kind);
    assert_eq!(kind(Kind::Count { bits: 8, signed: true }), Err(Flaw::Width(8)));
    assert_eq!(kind(Kind::Index), Err(Flaw::WrongPart(Kind::Index)));
    let count = Kind::Count { bits: 32, signed: true };
    assert_eq!(counting(|p| p.inputs[0].kind = count), Err(Flaw::WrongPart(count)));
    assert_eq!(counting(|p| p.estimates[0].0.kind = count), Err(Flaw::WrongPart(count)));
    let x = sound().estimates[0].1;
    assert_eq!(counting(|p| p.estimates[0].0.kind = Kind::Index), wrong(x, Type::Index, Type::Float));

    let cell = |len, init, bits| counting(|p| p.cells[3].kind = CellKind::Counts { len, init, bits });
    assert_eq!(cell(0, 0, 16), Err(Flaw::EmptyRing));
    assert_eq!(cell(3, 65_536, 16), Err(Flaw::TooLarge { number: 65_536, bits: 16 }));
    assert_eq!(cell(3, u32::MAX, 32), Ok(()));
    assert_eq!(cell(3, 0, 64), Err(Flaw::Width(64)));
}

/// Claim: a start has the estimate and no samples, a step the other way round; neither sees the other's values.
#[test]
fn starts() {
    let start = |statements: Vec<Statement>| {
        let mut program = sound();
        program.init_at = Some(statements);
        check(&program).map_err(|error| error.flaw)
    };
    let (value, cell) = (Value(100), CellId(0));
    let given = |at| Statement::Let { value, op: Op::Given(at) };
    let with = |op: Op| start(vec![Statement::Let { value, op }]);
    assert_eq!(start(vec![given(0), Statement::SetCell { cell, value }]), Ok(()));
    assert_eq!(with(Op::Given(1)), Err(Flaw::NoSuchField(1)));
    assert_eq!(with(Op::Measurement(0)), Err(Flaw::NoSample));
    assert_eq!(with(Op::Input(0)), Err(Flaw::NoSample));
    assert_eq!(flaw_of(Op::Given(0)), Flaw::NotAStart);
    assert_eq!(flaw_of(Op::Vouched), Flaw::NotAStart);
    let float = any(Type::Float);
    assert_eq!(with(Op::Neg(float)), Err(Flaw::Undefined(float)));
    let mut program = sound();
    program.init_at = Some(vec![given(0)]);
    program.body.push(Statement::Let { value: Value(101), op: Op::Neg(value) });
    assert_eq!(check(&program).map_err(|error| error.flaw), Err(Flaw::Undefined(value)));
    let inner = Statement::Loop(Loop { table: TableId(0), carried: vec![], body: vec![] });
    assert_eq!(start(vec![inner]), Err(Flaw::LoopInStart));
    let beyond = Flaw::OutOfBounds { value, at_most: 3, len: 3 };
    let set = Statement::SetRing { ring: CellId(2), slot: value, value: Value(101) };
    let one = Statement::Let { value: Value(101), op: Op::Float(1.0) };
    assert_eq!(start(vec![Statement::Let { value, op: Op::Index(3) }, one, set]), Err(beyond));
}
