//! Cutting a long step into functions, the same for both languages.
//!
//! A step of at most [`ROOM`] lines stays one function. A longer one is cut at its sections, a
//! longer section between its statements, and a loop with a longer body gets functions for the
//! parts of its body, called once a row. What crosses from one function to another travels in one
//! plain struct, so a cut changes neither an operation nor their order.

use super::plan::{Function, Reach};
use crate::program::{Loop, Op, Program, Statement, TableId, Value};

/// The most lines of one function: clippy's bound is 100, and a long name may break a line in two.
const ROOM: usize = 90;

/// A piece of a function.
pub enum Item<'a> {
    /// A statement other than a loop.
    Plain(&'a Statement),
    /// A loop.
    Loop {
        /// Its table and what it carries; its body is `items`.
        source: &'a Loop,
        items: Vec<Item<'a>>,
    },
    /// A call of a function that stands before.
    Call(usize),
}

impl Item<'_> {
    /// The values that it defines by itself.
    pub fn defines(&self) -> Vec<Value> {
        match self {
            Self::Plain(Statement::Let { value, .. }) => vec![*value],
            Self::Loop { source, .. } => source.carried.iter().map(|carried| carried.value).collect(),
            Self::Plain(_) | Self::Call(_) => vec![],
        }
    }

    /// The values that it uses by itself.
    pub fn uses(&self) -> Vec<Value> {
        match self {
            Self::Plain(Statement::Let { op, .. }) => op.operands(),
            Self::Plain(Statement::SetCell { value, .. }) => vec![*value],
            Self::Plain(Statement::SetRing { slot, value, .. }) => vec![*slot, *value],
            Self::Loop { source, .. } => {
                source.carried.iter().flat_map(|carried| [carried.start, carried.next]).collect()
            }
            Self::Plain(_) | Self::Call(_) => vec![],
        }
    }
}

/// Calls `visitor` for every item, those inside loops too.
pub fn visit<'i, 'a>(items: &'i [Item<'a>], visitor: &mut impl FnMut(&'i Item<'a>)) {
    for item in items {
        visitor(item);
        if let Item::Loop { items, .. } = item {
            visit(items, visitor);
        }
    }
}

/// The functions of a Program: the parts of its step; the parts of its start, if it has one, and that itself; the step
/// itself last.
pub fn functions(program: &Program) -> Vec<Function<'_>> {
    let mut functions = vec![];
    let result = program.estimates.len() + 3;
    let items = fit(&program.body, ROOM.saturating_sub(result), None, &mut functions);
    if let Some(start) = &program.init_at {
        let parts = functions.len();
        let items = fit(start, ROOM, None, &mut functions);
        functions.push(Function { items, row: None, reach: Reach::default(), starts: true });
        functions[parts..].iter_mut().for_each(|function| function.starts = true);
    }
    functions.push(Function { items, row: None, reach: Reach::default(), starts: false });
    functions
}

/// The statements themselves if they fit, else calls of new functions that hold them.
fn fit<'a>(
    statements: &'a [Statement],
    room: usize,
    row: Option<TableId>,
    functions: &mut Vec<Function<'a>>,
) -> Vec<Item<'a>> {
    if statements.iter().map(lines).sum::<usize>() <= room {
        return statements.iter().map(whole).collect();
    }
    let mut calls = vec![];
    for chunk in chunks(statements) {
        let items = match chunk {
            [.., Statement::Loop(source)] if lines(&chunk[chunk.len() - 1]) > ROOM => {
                let room = ROOM.saturating_sub(frame(source));
                let items = fit(&source.body, room, Some(source.table), functions);
                let before = chunk[..chunk.len() - 1].iter().map(whole);
                before.chain([Item::Loop { source, items }]).collect()
            }
            _ => chunk.iter().map(whole).collect(),
        };
        functions.push(Function { items, row, reach: Reach::default(), starts: false });
        calls.push(Item::Call(functions.len() - 1));
    }
    calls
}

/// A statement in one piece.
fn whole(statement: &Statement) -> Item<'_> {
    match statement {
        Statement::Loop(source) => Item::Loop { source, items: source.body.iter().map(whole).collect() },
        plain => Item::Plain(plain),
    }
}

/// Consecutive statements of at most [`ROOM`] lines each, cut before a section where possible. A
/// statement that is longer by itself ends its chunk, with nothing but its heading before it.
fn chunks(statements: &[Statement]) -> Vec<&[Statement]> {
    let mut chunks = vec![];
    let mut rest = statements;
    while !rest.is_empty() {
        let (chunk, behind) = rest.split_at(cut(rest));
        chunks.push(chunk);
        rest = behind;
    }
    chunks
}

/// The length of the first chunk.
fn cut(statements: &[Statement]) -> usize {
    let is_heading = |statement: &Statement| matches!(statement, Statement::Section(_));
    let mut total = 0;
    let fits = statements.iter().take_while(|statement| {
        total += lines(statement);
        total <= ROOM
    });
    let fitting = fits.count();
    if fitting == statements.len() {
        return fitting;
    }
    let is_work = |statement: &Statement| lines(statement) > 0;
    let section = (1..=fitting).rev().find(|at| is_heading(&statements[*at]) && statements[..*at].iter().any(is_work));
    let alone = if statements[..fitting].iter().any(is_work) { fitting } else { fitting + 1 };
    section.unwrap_or(alone)
}

/// How many lines a statement takes in Rust, at most; comments do not count.
fn lines(statement: &Statement) -> usize {
    match statement {
        Statement::Section(_)
        | Statement::Let { op: Op::Float(_) | Op::Index(_) | Op::Bool(_) | Op::Status(_), .. } => 0,
        Statement::Let { op: Op::InRange { .. }, .. } => 3,
        Statement::Let { .. } | Statement::SetCell { .. } | Statement::SetRing { .. } => 1,
        Statement::Loop(source) => frame(source) + source.body.iter().map(lines).sum::<usize>(),
    }
}

/// The lines of a loop around its body.
fn frame(source: &Loop) -> usize {
    2 + 2 * source.carried.len()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::builder::Builder;
    use crate::program::{Field, Kind, Scalar, Status};

    /// A chain of additions and products.
    fn chain(b: &mut Builder, start: Value, length: usize) -> Value {
        (0..length).fold(start, |x, at| if at % 2 == 0 { b.add(x, start) } else { b.mul(x, start) })
    }

    /// A Program with sections of these lengths and a loop whose body has that many operations.
    fn program(sections: &[usize], body: usize) -> Program {
        let field = || Field { name: "y".to_owned(), unit: String::new(), doc: String::new(), kind: Kind::Float };
        let mut b = Builder::new("long", Scalar::F64, 1.0);
        let y = b.measurement(field());
        let table = b.table("GAINS", "", vec!["gain".to_owned()], vec![vec![0.5]; 3]);
        let mut x = b.read_measurement(y);
        for length in sections {
            b.section("a section");
            x = chain(&mut b, x, *length);
        }
        b.section("the loop");
        let ends = b.loop_over(table, &[x], |b, carried| {
            let gain = b.gain(0);
            let product = b.mul(gain, carried[0]);
            vec![chain(b, product, body)]
        });
        b.estimate(field(), ends[0]);
        let status = b.status(Status::Converged);
        b.report(status);
        b.finish()
    }

    /// The values in the order in which the functions define them.
    fn order(functions: &[Function], items: &[Item], values: &mut Vec<Value>) {
        for item in items {
            values.extend(item.defines());
            match item {
                Item::Plain(_) => {}
                Item::Loop { items, .. } => order(functions, items, values),
                Item::Call(callee) => order(functions, &functions[*callee].items, values),
            }
        }
    }

    /// Claim: whatever the lengths, no function is longer than its room, and the calls run every
    /// statement once and in order.
    #[test]
    fn keeps_order_and_room() {
        for sections in [&[3][..], &[40, 30, 60], &[300, 2, 89], &[1, 1, 1, 200]] {
            for body in [4, 85, 95, 400] {
                let program = program(sections, body);
                let functions = functions(&program);
                let length = |items: &[Item]| items.iter().map(height).sum::<usize>();
                assert!(functions.iter().all(|it| length(&it.items) <= ROOM), "{sections:?} {body}");
                let mut values = vec![];
                order(&functions, &functions[functions.len() - 1].items, &mut values);
                assert_eq!(values.len(), sections.iter().sum::<usize>() + body + 5);
                assert!(values.is_sorted(), "{values:?}");
                let total = program.body.iter().map(lines).sum::<usize>();
                assert_eq!(functions.len() == 1, total <= ROOM - 4);
            }
        }
    }

    /// The lines of an item.
    fn height(item: &Item) -> usize {
        match item {
            Item::Plain(statement) => lines(statement),
            Item::Loop { source, items } => frame(source) + items.iter().map(height).sum::<usize>(),
            Item::Call(_) => 1,
        }
    }
}
