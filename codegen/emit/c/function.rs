//! The step and the functions that it is split into.

use super::super::plan::{Access, Function};
use super::{C, Part};
use crate::names;

impl C<'_> {
    /// A function that holds a part of the step or of the start.
    pub fn part(&self, at: usize, of: &str, part: &Function) -> Part {
        let doc = match part.row {
            Some(table) => {
                format!("Part {} of {of}, for one row of {}.", at + 1, self.plan.names.prefixed_table(table))
            }
            None => format!("Part {} of {of}.", at + 1),
        };
        let parameters: Vec<String> = self.parameters(part).into_iter().map(|(declared, _)| declared).collect();
        Part { doc, name: names::part(at), parameters: parameters.join(", "), lines: self.statements(part) }
    }

    /// The statements of the step itself.
    pub fn step(&self, step: &Function) -> Vec<String> {
        let program = self.plan.program;
        let reach = step.reach;
        let ignored = [
            ("state", reach.state == Access::None),
            ("measurements", !reach.measurements),
            ("inputs", !reach.inputs && !program.inputs.is_empty()),
        ];
        let mut lines: Vec<String> =
            ignored.iter().filter(|(_, is)| *is).map(|(name, _)| format!("(void){name};")).collect();
        lines.extend(self.own_work(step));
        lines.extend(self.statements(step));
        if !lines.is_empty() {
            lines.push(String::new());
        }
        for (field, value) in &program.estimates {
            lines.push(format!("estimate->{} = {};", field.name, self.result(*value)));
        }
        lines.push(format!("estimate->status = {};", self.result(program.status)));
        lines
    }

    /// The statements of the start itself.
    pub fn start_at(&self, start: &Function) -> Vec<String> {
        let ignored = (!start.reach.given).then(|| "(void)estimate;".to_owned());
        ignored.into_iter().chain(self.own_work(start)).chain(self.statements(start)).collect()
    }

    /// The struct of what crosses, where a function has parts.
    fn own_work(&self, function: &Function) -> Option<String> {
        (function.reach.work > Access::None).then(|| format!("{}_work work;", self.plan.names.lower))
    }

    /// The call of a function that holds a part of the step.
    pub fn call_part(&self, callee: usize) -> String {
        let part = &self.plan.functions[callee];
        let arguments: Vec<&str> = self
            .parameters(part)
            .into_iter()
            .map(|(_, name)| if name == "work" && part.row.is_none() { "&work" } else { name })
            .collect();
        format!("{}_{}({});", self.plan.names.lower, names::part(callee), arguments.join(", "))
    }

    /// What a part is called with: the declarations, and the names of the parameters.
    fn parameters(&self, part: &Function) -> Vec<(String, &'static str)> {
        let name = &self.plan.names.lower;
        let pointer = |access: Access, what: &'static str| match access {
            Access::None => None,
            Access::Read => Some((format!("const {name}_{what} *{what}"), what)),
            Access::Write => Some((format!("{name}_{what} *{what}"), what)),
        };
        let read = |is_read: bool| if is_read { Access::Read } else { Access::None };
        let reach = part.reach;
        let all = [
            pointer(reach.state, "state"),
            pointer(read(reach.measurements), "measurements"),
            pointer(read(reach.inputs), "inputs"),
            pointer(read(reach.given), "estimate"),
            pointer(reach.work, "work"),
            self.plan.row_of(part).map(|_| (format!("const {} *gains", self.scalar()), "gains")),
        ];
        all.into_iter().flatten().collect()
    }
}
