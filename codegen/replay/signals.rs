//! What a caller says of a recording's columns.

use crate::names;

use super::clock::TimeUnit;
use super::interface::Interface;
use super::mistake::SignalError;

/// What the columns of a recording mean, where their names do not say it: pairs of a name and a column.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Signals {
    /// A measurement, an input or the time `t` that has another name in the recording. Behind the name of a column a factor
    /// may stand, as in `angle*pi/180`; so it may in references.
    pub map: Vec<(String, String)>,
    /// A state and the column to compare it with.
    pub reference: Vec<(String, String)>,
    /// An output whose age is measured, and the column with its sensor's own time, s.
    pub age: Vec<(String, String)>,
    /// The unit of the time, where neither the name of its column nor a row of units says it.
    pub time_unit: Option<TimeUnit>,
}

impl Signals {
    /// Refuses names that none of these steps knows; references are left to [`Signals::check_references`].
    ///
    /// # Errors
    /// With the first of them.
    pub fn check(&self, all: &[&Interface]) -> Result<(), SignalError> {
        let several = all.len() != 1;
        let input = |it: &Interface, name: &str| it.inputs.iter().any(|input| input == name);
        let measured = |it: &Interface, name: &str| it.measurements.iter().any(|m| m.name == name);
        let known = |name: &str| {
            let name = &names::field(name);
            name == "t" || all.iter().any(|it| input(it, name) || measured(it, name))
        };
        if let Some((name, _)) = self.map.iter().find(|(name, _)| !known(name)) {
            return Err(SignalError::NotRead { name: name.clone(), several });
        }
        let aged = |name: &str| all.iter().any(|it| measured(it, &age_of(&names::field(name))));
        if let Some((name, _)) = self.age.iter().find(|(name, _)| !aged(name)) {
            return Err(SignalError::NotAged { name: name.clone(), several });
        }
        match self.age.iter().find(|(name, _)| found(&self.map, &age_of(name)).is_some()) {
            Some((name, _)) => Err(SignalError::AgedTwice { name: name.clone() }),
            None => Ok(()),
        }
    }

    /// Refuses references to what one step does not estimate.
    ///
    /// # Errors
    /// With the first of them.
    pub fn check_references(&self, interface: &Interface) -> Result<(), SignalError> {
        let known = |name: &str| interface.quantities().any(|(_, answer)| answer.name == names::field(name));
        match self.reference.iter().find(|(name, _)| !known(name)) {
            Some((name, _)) => Err(SignalError::NotEstimated { name: name.clone(), of: None }),
            None => Ok(()),
        }
    }

    /// The column of a field: what was said, or what is called like it or like what the specification writes for it.
    pub(super) fn column_of(&self, field: &str, written: &str, there: &[String]) -> String {
        let has = |name: &str| there.iter().any(|column| column == name);
        let own = if has(written) && !has(field) { written } else { field };
        found(&self.map, field).unwrap_or_else(|| own.to_owned())
    }
}

/// The field that says how old an output's sample is.
fn age_of(output: &str) -> String {
    format!("{output}_age")
}

/// The column that a list has for a name.
pub(super) fn found(list: &[(String, String)], name: &str) -> Option<String> {
    list.iter().find(|(from, _)| names::field(from) == name).map(|(_, column)| column.clone())
}
