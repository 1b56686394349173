//! Single definition before use, scopes and types of a Program's statements.

use std::collections::{HashMap, HashSet};

use super::super::{Kind, Loop, Program, Statement, TableId, Type, Value};
use super::typing::{Context, expect};
use super::{At, CheckError, Flaw};

/// Whether the statements, the estimates and the status use values as they are defined.
pub(super) fn check(program: &Program) -> Result<(), CheckError> {
    let mut scope = Scope { program, types: HashMap::new(), hidden: HashSet::new(), starting: false };
    if let Some(start) = &program.init_at {
        scope.starting = true;
        scope.body(start, None)?;
        scope.starting = false;
        scope.hidden.extend(scope.types.keys().copied());
    }
    scope.body(&program.body, None)?;
    for (field, value) in &program.estimates {
        let r#type = if field.kind == Kind::Index { Type::Index } else { Type::Float };
        scope.has(*value, r#type).at(program, format!("estimate `{}`", field.name))?;
    }
    scope.has(program.status, Type::Status).at(program, "status")
}

/// What is defined so far.
struct Scope<'a> {
    program: &'a Program,
    types: HashMap<Value, Type>,
    /// Values of loops that have ended, and of the start.
    hidden: HashSet<Value>,
    /// Whether the statements are those of the start.
    starting: bool,
}

impl Scope<'_> {
    /// Checks and defines, in a loop over `row` or at the top level.
    fn body(&mut self, body: &[Statement], row: Option<TableId>) -> Result<(), CheckError> {
        for statement in body {
            match statement {
                Statement::Loop(_) if self.starting => Err(Flaw::LoopInStart).at(self.program, statement)?,
                Statement::Loop(inner) if row.is_none() => self.enter(inner, statement)?,
                _ => self.statement(statement, row).at(self.program, statement)?,
            }
        }
        Ok(())
    }

    /// A statement that is not a loop.
    fn statement(&mut self, statement: &Statement, row: Option<TableId>) -> Result<(), Flaw> {
        let context = if self.starting { Context::starting(self.program) } else { Context::of(self.program, row) };
        match statement {
            Statement::Section(_) if row.is_some() => Err(Flaw::SectionInLoop),
            Statement::Section(text) => super::interface::one_line(text),
            Statement::Let { value, op } => {
                let r#type = context.type_of(op, |operand| self.visible(operand))?;
                self.define(*value, r#type)
            }
            Statement::SetCell { cell, value } => self.has(*value, context.scalar_cell(*cell)?),
            Statement::SetRing { ring, slot, value } => {
                let element = context.element(*ring)?;
                self.has(*slot, Type::Index)?;
                self.has(*value, element)
            }
            Statement::Loop(_) => Err(Flaw::NestedLoop),
        }
    }

    /// A loop: what it carries stays visible behind it, what its body defines does not.
    fn enter(&mut self, inner: &Loop, statement: &Statement) -> Result<(), CheckError> {
        self.carried(inner).at(self.program, statement)?;
        self.body(&inner.body, Some(inner.table))?;
        let own: HashSet<Value> = inner.body.iter().filter_map(defined).collect();
        for carried in &inner.carried {
            self.handed_on(carried.value, carried.next, &own).at(self.program, statement)?;
        }
        self.hidden.extend(own);
        Ok(())
    }

    /// Defines what a loop carries, each with the type of its start.
    fn carried(&mut self, inner: &Loop) -> Result<(), Flaw> {
        Context::of(self.program, None).table(inner.table)?;
        let types: Result<Vec<Type>, Flaw> = inner.carried.iter().map(|carried| self.visible(carried.start)).collect();
        (inner.carried.iter().zip(types?)).try_for_each(|(carried, r#type)| self.define(carried.value, r#type))
    }

    /// Whether a loop may hand `next` on as the next `value`.
    fn handed_on(&self, value: Value, next: Value, own: &HashSet<Value>) -> Result<(), Flaw> {
        if !own.contains(&next) {
            return Err(Flaw::NextNotInBody(next));
        }
        self.has(next, self.visible(value)?)
    }

    /// A new value.
    fn define(&mut self, value: Value, r#type: Type) -> Result<(), Flaw> {
        match self.types.insert(value, r#type) {
            None => Ok(()),
            Some(_) => Err(Flaw::DefinedTwice(value)),
        }
    }

    /// The type of a value that may be used now.
    fn visible(&self, value: Value) -> Result<Type, Flaw> {
        let r#type = self.types.get(&value).filter(|_| !self.hidden.contains(&value));
        r#type.copied().ok_or(Flaw::Undefined(value))
    }

    /// Whether a value may be used now with that type.
    fn has(&self, value: Value, r#type: Type) -> Result<(), Flaw> {
        self.visible(value).and_then(|found| expect(value, found, r#type))
    }
}

/// The value that a statement defines.
fn defined(statement: &Statement) -> Option<Value> {
    match statement {
        Statement::Let { value, .. } => Some(*value),
        _ => None,
    }
}
