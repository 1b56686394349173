//! Writes loops.

use std::mem;

use super::super::{Carried, Loop, Op, Statement, TableId, Type, Value};
use super::{Builder, TOP};

impl Builder {
    /// Runs `body` once for each row of the table. `body` gets the carried values and returns what
    /// they are in the next iteration; the result is what they are behind the loop.
    pub fn loop_over(
        &mut self,
        table: TableId,
        starts: &[Value],
        body: impl FnOnce(&mut Self, &[Value]) -> Vec<Value>,
    ) -> Vec<Value> {
        assert!(self.row.is_none(), "a loop inside a loop");
        assert!(self.scope == TOP, "a loop in a start");
        self.require("loop", self.context().table(table).map(|_| ()));
        let values: Vec<Value> = starts.iter().map(|start| self.name(self.type_of(*start), None)).collect();

        let before = mem::take(&mut self.program.body);
        self.loops += 1;
        self.scope = self.loops;
        self.row = Some(table);
        self.shared.enter();
        let next = body(self, &values);
        assert_eq!(next.len(), starts.len(), "a loop returns what it carries");
        let next: Vec<Value> = next.into_iter().map(|next| self.own(next)).collect();
        self.shared.leave();
        self.row = None;
        self.scope = TOP;
        let body = mem::replace(&mut self.program.body, before);

        let carried = (values.iter().zip(starts).zip(next))
            .map(|((value, start), next)| Carried { value: *value, start: *start, next })
            .collect();
        for (value, start) in values.iter().zip(starts) {
            self.require("loop", self.has(*value, self.type_of(*start)));
        }
        self.program.body.push(Statement::Loop(Loop { table, carried, body }));
        values
    }

    /// The same value, defined in the loop's body: what a loop hands on must be, and must not be
    /// what it carries. `x - 0` is `x` for every float.
    fn own(&mut self, value: Value) -> Value {
        if self.definitions[value.0 as usize].scope == self.scope {
            return value;
        }
        match self.type_of(value) {
            Type::Float => {
                let zero = self.float(0.0);
                self.define(Op::Sub(value, zero))
            }
            Type::Index => self.define(Op::AtMost { value, max: u32::MAX }),
            Type::Bool => {
                let opposite = self.define(Op::Not(value));
                self.define(Op::Not(opposite))
            }
            Type::Status => {
                let condition = self.boolean(true);
                self.define(Op::Select { condition, then: value, otherwise: value })
            }
        }
    }
}
