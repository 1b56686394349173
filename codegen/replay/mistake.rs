//! What can be wrong between a recording and a step, as data.

use std::fmt;

use super::recording::RecordingError;

/// Why there is no replay, or no more of it.
#[derive(Clone, Debug, PartialEq)]
pub enum ReplayError {
    /// What the caller named is not there.
    Signals(SignalError),
    /// The recording is wrong, or does not fit the step.
    Recording(RecordingError),
}

/// What a caller's [`Signals`](super::Signals) name that a step or a recording does not have.
#[derive(Clone, Debug, PartialEq)]
pub enum SignalError {
    /// In `map`: no step reads it.
    NotRead {
        /// As the caller wrote it.
        name: String,
        /// Whether there are several steps.
        several: bool,
    },
    /// In `age`: no step asks for its age.
    NotAged {
        /// As the caller wrote it.
        name: String,
        /// Whether there are several steps.
        several: bool,
    },
    /// In `age`: `map` has a column for the same age.
    AgedTwice {
        /// Of the output.
        name: String,
    },
    /// In `age`: the recording has no time.
    Timeless {
        /// Of the output.
        name: String,
    },
    /// In `reference`: the step does not estimate it.
    NotEstimated {
        /// As the caller wrote it.
        name: String,
        /// The specification and what it estimates, where there are several.
        of: Option<(String, Vec<String>)>,
    },
    /// Without a time in the recording its rows are a sample time apart, which has to be the same for all steps.
    Apart {
        /// Of the recording.
        log: String,
        /// A specification and its sample time, s.
        one: (String, f64),
        /// Another.
        other: (String, f64),
    },
}

impl SignalError {
    /// The message, with the lists of [`Signals`](super::Signals) (`map`, `reference`, `age`) called what the caller's
    /// user knows them by.
    pub fn told(&self, list: impl Fn(&str) -> String) -> String {
        let (map, reference, age) = (list("map"), list("reference"), list("age"));
        let of = |several: bool| if several { "of any specification" } else { "of the specification" };
        match self {
            Self::NotRead { name, several } => {
                format!("{map}: `{name}` is neither an output nor an input {}, nor `t`", of(*several))
            }
            Self::NotAged { name, several } => {
                format!("{age}: `{name}` is not an output {} whose age is measured", of(*several))
            }
            Self::AgedTwice { name } => format!("{age} {name}: {map} names a column for `{name}_age` already"),
            Self::Timeless { name } => {
                format!("{age} {name}: an age is the time `t` less the sensor's, and the recording has no column `t`")
            }
            Self::NotEstimated { name, of: None } => {
                format!("{reference}: `{name}` is not a state of the specification")
            }
            Self::NotEstimated { name, of: Some((file, states)) } => {
                let list: Vec<String> = states.iter().map(|state| format!("`{state}`")).collect();
                format!("{reference}: `{name}` is not a state of {file}; its states are {}", list.join(", "))
            }
            Self::Apart { log, one, other } => format!(
                "{log} has no column `t`: its rows are {} s apart for {}, and {} s for {}",
                one.1, one.0, other.1, other.0
            ),
        }
    }
}

impl fmt::Display for SignalError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.told(|list| format!("`{list}`")))
    }
}

impl fmt::Display for ReplayError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Signals(error) => error.fmt(f),
            Self::Recording(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for SignalError {}
impl std::error::Error for ReplayError {}

impl From<SignalError> for ReplayError {
    fn from(error: SignalError) -> Self {
        Self::Signals(error)
    }
}

impl From<RecordingError> for ReplayError {
    fn from(error: RecordingError) -> Self {
        Self::Recording(error)
    }
}
