//! What crosses from one function to another, and what each function touches.

use std::collections::{BTreeMap, BTreeSet};

use super::super::split::{self, Item};
use super::Plan;
use crate::program::{Op, Statement, Value};

/// What a function touches, itself or through what it calls.
#[derive(Clone, Copy, Default)]
pub struct Reach {
    pub state: Access,
    pub work: Access,
    pub measurements: bool,
    pub inputs: bool,
    /// The estimate that a start is given.
    pub given: bool,
}

/// How something is used.
#[derive(Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Access {
    #[default]
    None,
    Read,
    Write,
}

impl<'a> Plan<'a> {
    /// The values that one function defines and another uses.
    pub(super) fn crossing_values(&self) -> Vec<Value> {
        let mut homes = BTreeMap::new();
        let mut uses = BTreeSet::new();
        for (at, function) in self.functions.iter().enumerate() {
            split::visit(&function.items, &mut |item| {
                homes.extend(item.defines().into_iter().map(|value| (value, at)));
                uses.extend(item.uses().into_iter().map(|value| (value, at)));
            });
        }
        let step = self.functions.len() - 1;
        uses.extend(self.program.estimates.iter().map(|(_, value)| (*value, step)));
        uses.insert((self.program.status, step));
        let crosses = |(value, at): &(Value, usize)| homes[value] != *at && self.constant(*value).is_none();
        let crossing: BTreeSet<Value> = uses.into_iter().filter(crosses).map(|(value, _)| value).collect();
        crossing.into_iter().collect()
    }

    /// What the items touch; the functions that they call are done.
    pub(super) fn reach(&self, items: &[Item<'a>]) -> Reach {
        let mut reach = Reach::default();
        split::visit(items, &mut |item| {
            reach = reach.and(self.reach_of(item));
        });
        reach
    }

    /// What one item touches by itself.
    fn reach_of(&self, item: &Item<'a>) -> Reach {
        let mut reach = match item {
            Item::Call(callee) => self.functions[*callee].reach,
            Item::Plain(Statement::SetCell { .. } | Statement::SetRing { .. }) => {
                Reach { state: Access::Write, ..Reach::default() }
            }
            Item::Plain(Statement::Let { op, .. }) => Reach {
                state: match op {
                    Op::Cell(_) | Op::Ring { .. } => Access::Read,
                    _ => Access::None,
                },
                measurements: matches!(op, Op::Measurement(_) | Op::Count(_)),
                inputs: matches!(op, Op::Input(_)),
                given: matches!(op, Op::Given(_) | Op::Vouched),
                work: Access::None,
            },
            Item::Plain(_) | Item::Loop { .. } => Reach::default(),
        };
        let crosses = |value: &Value| self.crossing.binary_search(value).is_ok();
        if item.uses().iter().any(crosses) {
            reach.work = reach.work.max(Access::Read);
        }
        if item.defines().iter().any(crosses) {
            reach.work = Access::Write;
        }
        reach
    }
}

impl Reach {
    /// What two pieces of code touch together.
    fn and(self, other: Self) -> Self {
        Self {
            state: self.state.max(other.state),
            work: self.work.max(other.work),
            measurements: self.measurements || other.measurements,
            inputs: self.inputs || other.inputs,
            given: self.given || other.given,
        }
    }
}
