//! One recording through one step, row by row.

use std::io::Read;

use crate::generated::Generated;

use super::columns::Columns;
use super::interface::Interface;
use super::mistake::ReplayError;
use super::recording::{Recording, RecordingError};
use super::selection::Selection;
use super::signals::Signals;
use super::steps::{Row, Sample, Steps};
use super::verdict::{Compared, Verdict};

/// A recording on its way through a step: an iterator over its rows.
///
/// Behind an error there are no more rows. A recording without rows is an error.
pub struct Replay<'a, R> {
    recording: Recording<R>,
    columns: Columns,
    cells: Vec<f64>,
    steps: Steps<'a>,
    ended: bool,
}

/// A row of the recording and what the step made of it.
#[derive(Clone, Debug)]
pub struct Step {
    /// What the step was given.
    pub row: Row,
    /// What it gave.
    pub sample: Sample,
}

impl<'a, R: Read> Replay<'a, R> {
    /// Finds the columns: outputs, inputs and the time `t` by their names, or as the signals say. Columns that are
    /// named like a state are compared with it, unless the step reads them.
    ///
    /// # Errors
    /// When the signals name what is not there, or the recording lacks a column.
    pub fn new(generated: &'a Generated, mut recording: Recording<R>, signals: &Signals) -> Result<Self, ReplayError> {
        let steps = Steps::new(generated);
        signals.check(&[steps.interface()])?;
        signals.check_references(steps.interface())?;
        let mut selection = Selection::default();
        let header = recording.header().clone();
        let columns = Columns::find(&generated.plant, steps.interface(), signals, &header, &mut selection, true)?;
        let width = selection.apply(&mut recording)?;
        Ok(Self { recording, columns, cells: vec![0.0; width], steps, ended: false })
    }

    /// The fields of the step.
    pub fn interface(&self) -> &Interface {
        self.steps.interface()
    }

    /// The design that is replayed.
    pub fn generated(&self) -> &'a Generated {
        self.steps.generated()
    }

    /// Per field of the estimate: whether there is a column to compare it with.
    pub fn compared(&self) -> Vec<bool> {
        self.columns.compared()
    }

    /// What the rows so far came to.
    pub fn verdict(&self) -> Verdict {
        let steps = &self.steps;
        let fields = self.interface().answers.iter().zip(&steps.errors).zip(self.compared());
        let compared = fields.filter(|(_, compared)| *compared);
        let negative_ages = self.columns.negative_ages;
        Verdict {
            rows: steps.rows,
            converged_rows: steps.converged_rows,
            coasting_rows: steps.coasting_rows,
            converged_from: steps.converged_from,
            left_out: steps.left_out,
            negative_ages,
            compared: compared
                .map(|((answer, errors), _)| Compared { answer: answer.clone(), errors: errors.clone() })
                .collect(),
            residuals: steps.residuals(),
            remarks: self.columns.remark.iter().cloned().chain(steps.remarks(negative_ages)).collect(),
        }
    }

    fn step(&mut self) -> Result<Option<Step>, RecordingError> {
        if !self.recording.next_row(&mut self.cells)? {
            if self.steps.rows == 0 {
                return Err(self.recording.has_no_rows());
            }
            return self.steps.judge().map(|()| None).map_err(|error| self.recording.unfit_whole(&error));
        }
        let steps = &self.steps;
        let row = self.columns.row(&self.cells, &self.recording, |now| steps.time_of_call(now))?;
        let sample = self.steps.feed(&row).map_err(|error| self.recording.unfit(&error))?;
        Ok(Some(Step { row, sample }))
    }
}

impl<R: Read> Iterator for Replay<'_, R> {
    type Item = Result<Step, RecordingError>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.ended {
            return None;
        }
        let step = self.step().transpose();
        self.ended = !matches!(step, Some(Ok(_)));
        step
    }
}
