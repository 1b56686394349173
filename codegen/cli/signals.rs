//! What the columns of a recording mean, as arguments.

use clap::Args;
use deadbeat_codegen::replay::{RecordingError, ReplayError, SignalError, TimeUnit};

use super::Failure;

/// The lists, each of them repeated arguments, and the unit of the time.
#[derive(Args, Clone, Debug, Default)]
pub struct Signals {
    /// A measurement, an input or the time `t` that has another name in the recording, may be repeated
    #[arg(long, value_name = "NAME=COLUMN", value_parser = renaming)]
    map: Vec<(String, String)>,
    /// A state and the column to compare it with, also with a factor, as in 'w=vel*pi/180'; may be repeated
    #[arg(long, value_name = "STATE=COLUMN", value_parser = renaming)]
    reference: Vec<(String, String)>,
    /// An output whose age is measured, and the column with its sensor's own time, s; may be repeated
    #[arg(long, value_name = "OUTPUT=COLUMN", value_parser = renaming)]
    age: Vec<(String, String)>,
    /// The unit of the time: s, ms, us, ns, min or h; by default what the name of its column or a row of units says, or s
    #[arg(long, value_name = "UNIT", value_parser = unit)]
    time_unit: Option<TimeUnit>,
}

fn unit(text: &str) -> Result<TimeUnit, String> {
    TimeUnit::named(text).ok_or_else(|| format!("the units are {}", TimeUnit::ALL.map(TimeUnit::sign).join(", ")))
}

fn renaming(text: &str) -> Result<(String, String), String> {
    match text.split_once('=').map(|(name, column)| (name.trim(), column.trim())) {
        Some((name, column)) if !name.is_empty() && !column.is_empty() => Ok((name.to_owned(), column.to_owned())),
        _ => Err("write NAME=COLUMN".into()),
    }
}

impl Signals {
    /// As a replay takes them.
    pub fn given(&self) -> deadbeat_codegen::replay::Signals {
        let Self { map, reference, age, time_unit } = self.clone();
        deadbeat_codegen::replay::Signals { map, reference, age, time_unit }
    }
}

impl From<SignalError> for Failure {
    /// The arguments are wrong, or those of a file that stands for them.
    fn from(error: SignalError) -> Self {
        Self::Misused(error.told(|list| format!("--{list}")))
    }
}

impl From<RecordingError> for Failure {
    /// What is wrong with a recording, and what to do.
    fn from(error: RecordingError) -> Self {
        let help = error.help.as_ref().map_or(String::new(), |help| format!("\nhelp: {help}"));
        Self::Wrong(format!("{error}{help}"))
    }
}

impl From<ReplayError> for Failure {
    fn from(error: ReplayError) -> Self {
        match error {
            ReplayError::Signals(error) => error.into(),
            ReplayError::Recording(error) => error.into(),
        }
    }
}
