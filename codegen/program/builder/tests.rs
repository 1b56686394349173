//! What the builder folds, shares and prunes, and what it leaves alone.

use super::super::check::check;
use super::super::{CellKind, Function, Op, Program, Scalar, Statement, Status, Value};
use super::{Builder, Field, Kind};

fn field(name: &str) -> Field {
    Field { name: name.to_owned(), unit: String::new(), doc: String::new(), kind: Kind::Float }
}

fn builder(scalar: Scalar) -> Builder {
    let mut b = Builder::new("example", scalar, 0.125);
    b.measurement(field("y"));
    b
}

/// The finished Program with the one estimate; it passes the check.
fn finish(mut b: Builder, estimate: Value) -> Program {
    b.estimate(field("x"), estimate);
    let status = b.status(Status::Converged);
    b.report(status);
    let program = b.finish();
    assert_eq!(check(&program), Ok(()));
    program
}

/// The operations in order, those in loops included, without the status constant.
fn ops(program: &Program) -> Vec<Op> {
    fn walk(body: &[Statement], ops: &mut Vec<Op>) {
        for statement in body {
            match statement {
                Statement::Let { op: Op::Status(_), .. } => {}
                Statement::Let { op, .. } => ops.push(op.clone()),
                Statement::Loop(inner) => walk(&inner.body, ops),
                _ => {}
            }
        }
    }
    let mut ops_in_order = vec![];
    walk(&program.body, &mut ops_in_order);
    ops_in_order
}

/// Claim: constants are folded in the target's type, so 0.1 + 0.2 differs between f32 and f64.
#[test]
fn folds_in_the_target_type() {
    let mut b = builder(Scalar::F32);
    let (x, y) = (b.float(f64::from(0.1_f32)), b.float(f64::from(0.2_f32)));
    let sum = b.add(x, y);
    assert_eq!(ops(&finish(b, sum)), [Op::Float(f64::from(0.1_f32 + 0.2_f32))]);

    let mut b = builder(Scalar::F64);
    let (x, y) = (b.float(0.1), b.float(0.2));
    let sum = b.add(x, y);
    assert_eq!(ops(&finish(b, sum)), [Op::Float(0.1 + 0.2)]);
}

/// Claim: a result that is not finite stays an operation, since no constant may be infinite.
#[test]
fn does_not_fold_to_infinity() {
    let mut b = builder(Scalar::F32);
    let huge = b.float(f64::from(f32::MAX));
    let product = b.mul(huge, huge);
    assert!(matches!(ops(&finish(b, product))[..], [Op::Float(_), Op::Mul(..)]));
}

/// Claim: `1 * x` is `x`; `x + 0`, `0 * x`, `x / 2` and `2 * x` against `x * 2` stay.
#[test]
fn rewrites_only_what_is_exact() {
    let mut b = builder(Scalar::F64);
    let y = b.read_measurement(0);
    let (zero, one, two) = (b.float(0.0), b.float(1.0), b.float(2.0));
    assert_eq!(b.mul(one, y), y);
    assert_eq!(b.mul(y, one), y);
    assert_ne!(b.add(y, zero), y);
    assert_ne!(b.mul(zero, y), zero);
    assert_ne!(b.mul(two, y), b.mul(y, two));
    let half = b.div(y, two);
    let program = finish(b, half);
    assert!(matches!(ops(&program)[..], [_, _, Op::Div(..)]));
}

/// Claim: known conditions and equal branches decide a select.
#[test]
fn decides_selects() {
    let mut b = builder(Scalar::F64);
    let (y, zero) = (b.read_measurement(0), b.float(0.0));
    let condition = b.less(y, zero);
    let (yes, no) = (b.boolean(true), b.boolean(false));
    assert_eq!(b.select(condition, y, y), y);
    assert_eq!(b.select(yes, y, zero), y);
    assert_eq!(b.select(no, y, zero), zero);
    assert_eq!(b.and(yes, condition), condition);
    assert_eq!(b.and(condition, no), no);
    assert_eq!(b.or(condition, yes), yes);
    assert_eq!(b.or(no, condition), condition);
    assert_eq!(b.not(yes), no);
}

/// Claim: the same operation is one value; a write ends the sharing of reads of that cell only.
#[test]
fn shares_reads_between_writes() {
    let mut b = builder(Scalar::F64);
    let (p, q) = (b.float_cell("p", "", 0.0), b.float_cell("p", "", 1.0));
    let y = b.read_measurement(0);
    let (first, other) = (b.read(p), b.read(q));
    assert_eq!(b.read(p), first);
    b.set(p, y);
    assert_ne!(b.read(p), first);
    assert_eq!(b.read(q), other);
    assert_eq!(b.add(first, y), b.add(first, y));
    let zero = b.float(0.0);
    assert_ne!(b.float(-0.0), zero);
}

/// Claim: a loop body uses outer values, reads cells anew, and shares nothing with the outside.
#[test]
fn loops_have_a_scope() {
    let mut b = builder(Scalar::F64);
    let (p, q) = (b.float_cell("p", "", 0.0), b.float_cell("q", "", 0.0));
    let table = b.table("GAINS", "", vec!["g".to_owned()], vec![vec![1.5], vec![2.5]]);
    let y = b.read_measurement(0);
    let (square, before, untouched) = (b.mul(y, y), b.read(p), b.read(q));
    let mut inner = before;
    let sums = b.loop_over(table, &[y], |b, carried| {
        assert_eq!(b.mul(y, y), square);
        inner = b.read(p);
        assert_ne!(inner, before);
        b.set(p, carried[0]);
        let (gain, again) = (b.gain(0), b.gain(0));
        assert_eq!(gain, again);
        let product = b.mul(gain, inner);
        vec![b.add(carried[0], product)]
    });
    assert_ne!(b.read(p), before);
    assert_eq!(b.read(q), untouched);
    finish(b, sums[0]);
}

/// Claim: what a loop hands on is defined in its body even if the closure returns what it got.
#[test]
fn loops_copy_what_they_hand_on() {
    let mut b = builder(Scalar::F64);
    let table = b.table("ROWS", "", vec!["g".to_owned()], vec![vec![0.5]; 3]);
    let y = b.read_measurement(0);
    let (zero, truth, start) = (b.float(0.0), b.less(y, y), b.index(1));
    let ready = b.status(Status::Coasting);
    let swapped = b.loop_over(table, &[y, zero, truth, start, ready], |_, carried| {
        vec![carried[1], carried[0], carried[2], carried[3], carried[4]]
    });
    let as_float = b.to_float(swapped[3]);
    let chosen = b.select(swapped[2], swapped[0], as_float);
    b.report(swapped[4]);
    b.estimate(field("x"), chosen);
    assert_eq!(check(&b.finish()), Ok(()));
}

/// Claim: an accumulator that only feeds itself goes, with its table, loop and section.
#[test]
fn prunes_to_a_fixpoint() {
    let mut b = builder(Scalar::F64);
    let (dead, fed) = (b.float_cell("dead", "", 0.0), b.float_cell("fed", "", 0.0));
    let live = b.float_cell("live", "", 0.0);
    let unused = b.table("UNUSED", "", vec!["g".to_owned()], vec![vec![1.0]]);
    let columns = vec!["a".to_owned(), "b".to_owned(), "c".to_owned()];
    let table = b.table("TABLE", "", columns, vec![vec![1.0, 2.0, 3.0], vec![4.0, 5.0, 6.0]]);
    let y = b.read_measurement(0);
    b.section("nothing that lives");
    let old = b.read(dead);
    let new = b.add(old, y);
    b.set(dead, new);
    let other = b.read(dead);
    b.set(fed, other);
    b.loop_over(unused, &[y], |b, carried| {
        let gain = b.gain(0);
        vec![b.mul(gain, carried[0])]
    });
    b.section("the rest");
    let state = b.read(live);
    let sums = b.loop_over(table, &[state, y], |b, carried| {
        let (unused, gain) = (b.gain(0), b.gain(1));
        vec![b.add(carried[0], gain), b.add(carried[1], unused)]
    });
    b.set(live, sums[0]);
    let program = finish(b, sums[0]);

    assert_eq!(program.cells.len(), 1);
    assert_eq!(program.cells[0].kind, CellKind::Float { init: 0.0 });
    assert_eq!(program.tables.len(), 1);
    assert_eq!(program.tables[0].rows, [[2.0], [5.0]]);
    assert_eq!(program.body[0], Statement::Section("the rest".to_owned()));
    assert!(matches!(&program.body[2], Statement::Loop(inner) if inner.carried.len() == 1));
    let sum = Op::Add(Value(1), Value(2));
    assert_eq!(ops(&program), [Op::Cell(super::CellId(0)), Op::Gain { column: 0 }, sum]);
}

/// Claim: a sum of n terms has n - 1 additions, in chains of at most three, partial sums alike.
#[test]
fn sums_are_balanced() {
    fn depth(program: &Program, value: Value) -> usize {
        let op = program.body.iter().find_map(|statement| match statement {
            Statement::Let { value: defined, op } if *defined == value => Some(op),
            _ => None,
        });
        match op {
            Some(Op::Add(a, b)) => 1 + depth(program, *a).max(depth(program, *b)),
            _ => 0,
        }
    }
    for (terms, expected) in [(1, 0), (4, 3), (5, 3), (16, 6), (17, 6), (64, 9)] {
        let mut b = builder(Scalar::F64);
        let y = b.read_measurement(0);
        let values: Vec<Value> = (0..terms)
            .map(|k| {
                let gain = b.float(f64::from(k) + 2.0);
                b.mul(gain, y)
            })
            .collect();
        let sum = b.sum(&values);
        let program = finish(b, sum);
        let additions = ops(&program).iter().filter(|op| matches!(op, Op::Add(..))).count();
        assert_eq!(additions, values.len() - 1);
        assert_eq!(depth(&program, program.estimates[0].1), expected, "{terms} terms");
    }
}

/// Claim: the composed forms fold to what they say, NaN apart.
#[test]
fn composed_forms() {
    let mut b = builder(Scalar::F64);
    let (low, high, minus_zero) = (b.float(-3.0), b.float(2.0), b.float(-0.0));
    let zero = b.float(0.0);
    assert_eq!((b.absolute(low), b.absolute(minus_zero)), (b.float(3.0), zero));
    assert_eq!((b.sign(low), b.sign(high)), (b.float(-1.0), b.float(1.0)));
    assert_eq!(b.sign(minus_zero), minus_zero);
    assert_eq!((b.minimum(low, high), b.maximum(low, high)), (low, high));
    assert_eq!((b.power(low, 5), b.power(high, 10)), (b.float(-243.0), b.float(1024.0)));
    assert_eq!((b.power(low, 0), b.power(low, 1)), (b.float(1.0), low));
}

/// Claim: misuse panics with the Program's name and the flaw.
#[test]
#[should_panic(expected = "program `example`: Add(Value(0), Value(1)): t1 is of type Index, not Float")]
fn misuse_panics() {
    let mut b = builder(Scalar::F64);
    let (y, slot) = (b.read_measurement(0), b.index(3));
    b.add(y, slot);
}

/// Claim: a value of a loop's body cannot leave it but by being carried.
#[test]
#[should_panic(expected = "is not defined here")]
fn body_values_stay_inside() {
    let mut b = builder(Scalar::F64);
    let table = b.table("ROWS", "", vec!["g".to_owned()], vec![vec![0.5]]);
    let mut inner = None;
    b.loop_over(table, &[], |b, _| {
        inner = Some(b.gain(0));
        vec![]
    });
    b.neg(inner.expect("the loop's body was built"));
}

/// Claim: a call of known arguments is a constant.
#[test]
fn folds_calls() {
    let mut b = builder(Scalar::F64);
    let four = b.float(4.0);
    let root = b.call(Function::Sqrt, &[four]);
    assert_eq!(root, b.float(2.0));
}

/// Claim: a counter's readings fold as they compute, around the ends of 16 and 32 bits.
#[test]
fn folds_counts() {
    let mut b = builder(Scalar::F32);
    let (low, high) = (b.index(3), b.index(0xffff_fffe));
    assert_eq!(b.wrap_difference(low, high, 32), b.index(5));
    assert_eq!(b.wrap_difference(low, high, 16), b.index(5));
    assert_eq!(b.wrap_difference(high, low, 16), b.index(5_u32.wrapping_neg()));
    assert_eq!(b.wrap_add(low, high), b.index(1));
    assert_eq!(b.remainder(high, 1000), b.index(294));
    assert_eq!(b.remainder(high, 1), b.index(0));
    let half = b.index(0x8000);
    assert_eq!(b.wrap_difference(half, low, 16), b.index(0x7ffd));
    let zero = b.index(0);
    assert_eq!(b.wrap_difference(half, zero, 16), b.index(0xffff_8000));
    assert_eq!(b.signed_to_float(high), b.float(-2.0));
    let rounded = b.index(16_777_217);
    assert_eq!(b.signed_to_float(rounded), b.float(16_777_216.0));
    for (x, whole) in [(-2.75, -2), (2.75, 2), (-0.5, 0), (3e9, 2_147_483_520), (-3e9, i32::MIN)] {
        let x = b.float(x);
        assert_eq!(b.from_float(x), b.index(i32::cast_unsigned(whole)));
    }
    let y = b.read_measurement(0);
    let unknown = b.from_float(y);
    assert_eq!(b.wrap_difference(unknown, unknown, 16), zero);
    assert_ne!(b.wrap_difference(unknown, zero, 16), b.wrap_difference(unknown, zero, 32));
}

/// Claim: a ring of counts is read and written as indices, its reads are shared between writes, and an estimate of
/// an index makes its field one.
#[test]
fn rings_of_counts() {
    let mut b = Builder::new("example", Scalar::F32, 0.125);
    let n = b.measurement(Field { kind: Kind::Count { bits: 16, signed: true }, ..field("n") });
    let (ring, unused) = (b.counts("ring", "", 4, 16, 9), b.counts("unused", "", 4, 32, 0));
    let (slot, now) = (b.index(2), b.read_count(n));
    b.set_ring(unused, slot, now);
    let before = b.read_ring(ring, slot);
    assert_eq!(b.read_ring(ring, slot), before);
    b.set_ring(ring, slot, now);
    assert_ne!(b.read_ring(ring, slot), before);
    let moved = b.wrap_difference(now, before, 16);
    let program = finish(b, moved);
    assert_eq!(program.estimates[0].0.kind, Kind::Index);
    assert_eq!(program.cells.len(), 1);
    assert_eq!(program.cells[0].kind, CellKind::Counts { len: 4, init: 9, bits: 16 });
}
