//! A specification that takes part in a contest.

use crate::generated::Generated;

use super::super::interface::Interface;
use super::super::mistake::SignalError;
use super::super::recording::RecordingError;
use super::super::signals::Signals;

/// A specification that takes part in a contest.
#[derive(Clone, Debug)]
pub struct Entrant {
    /// The specification's name.
    pub(super) name: String,
    pub(super) file: String,
    pub(super) generated: Generated,
    pub(super) interface: Interface,
    /// Per reference: the place of its estimate.
    pub(super) places: Vec<usize>,
}

impl Entrant {
    /// Takes a design; `file` stands for its specification in messages, and for its name where two have the same.
    ///
    /// # Errors
    /// When it does not estimate one of the references.
    pub fn new(file: &str, generated: Generated, signals: &Signals) -> Result<Self, SignalError> {
        let interface = Interface::of(&generated);
        let places = places(&interface, signals, file)?;
        Ok(Self { name: generated.plant.name.clone(), file: file.to_owned(), generated, interface, places })
    }

    /// What is wrong between a recording and this one.
    pub(super) fn unfit(&self, error: RecordingError) -> RecordingError {
        let message = format!("{} does not fit the recording: {}", self.file, error.message);
        RecordingError { message, ..error }
    }

    /// The fields of its step.
    pub fn interface(&self) -> &Interface {
        &self.interface
    }
}

/// Where a step has the estimates of the references.
fn places(interface: &Interface, signals: &Signals, file: &str) -> Result<Vec<usize>, SignalError> {
    let place = |(name, _): &(String, String)| {
        let found = interface.quantities().find(|(_, answer)| answer.name == *name).map(|(place, _)| place);
        found.ok_or_else(|| {
            let states = interface.quantities().map(|(_, answer)| answer.name.clone()).collect();
            SignalError::NotEstimated { name: name.clone(), of: Some((file.to_owned(), states)) }
        })
    };
    signals.reference.iter().map(place).collect()
}
