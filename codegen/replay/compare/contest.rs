//! A recording through several steps at once, and their scores.

use std::io::Read;

use crate::program::Status;
use crate::program::cost::{Cost, cost};

use super::super::columns::Columns;
use super::super::interface::{Answer, Interface};
use super::super::mistake::{ReplayError, SignalError};
use super::super::recording::Recording;
use super::super::residual::Residual;
use super::super::selection::{Selection, Source};
use super::super::signals::Signals;
use super::super::steps::{Sample, Steps};
use super::entrant::Entrant;
use super::score::{Pair, Score};
use super::track::Track;

/// What came out.
#[derive(Clone, Debug)]
pub struct Contest {
    /// For reports and figures; empty until it is given.
    pub title: String,
    /// The recording's name.
    pub log: String,
    /// Of the recording.
    pub rows: usize,
    /// Remarks on the recording, a line each.
    pub remarks: Vec<String>,
    /// Per row, s.
    pub times: Vec<f64>,
    /// In the order in which they were given.
    pub rivals: Vec<Rival>,
    /// In the order in which they were given.
    pub quantities: Vec<Quantity>,
}

/// One of the steps.
#[derive(Clone, Debug)]
pub struct Rival {
    /// The specification's name, or its file's where two have the same.
    pub name: String,
    /// The specification's file.
    pub file: String,
    /// The name of its method.
    pub method: &'static str,
    /// s.
    pub sample_time: f64,
    /// Of a call.
    pub cost: Cost,
    /// The first row with an estimate that has converged.
    pub converged_row: Option<usize>,
    /// From the first row on until then, s.
    pub converged_after: Option<f64>,
    /// The samples against what the estimates before them foretold, per output.
    pub residuals: Vec<Residual>,
}

/// A quantity that all estimate, and what it is compared with.
#[derive(Clone, Debug)]
pub struct Quantity {
    /// As the first of the specifications has it.
    pub answer: Answer,
    /// The column of the reference.
    pub column: String,
    /// What it is compared with.
    pub reference: Track,
    /// Per row: the reference, NaN where it is not known.
    pub known: Vec<f64>,
    /// Rows on which every estimate has converged and the reference is known.
    pub compared: Vec<usize>,
    /// Per rival, per row; NaN before convergence.
    pub estimates: Vec<Vec<f64>>,
    /// Per rival.
    pub scores: Vec<Score>,
}

impl Contest {
    /// Holds it, over every row of a recording: `signals.reference` says what is compared, with columns of the
    /// recording, or with tracks from elsewhere, one for each. `progress` is told how many rows there were.
    ///
    /// # Errors
    /// When the signals name what no step has, or the recording is wrong or does not fit one of the steps.
    pub fn hold<R: Read>(
        mut entrants: Vec<Entrant>,
        signals: &Signals,
        recording: Recording<R>,
        elsewhere: Option<&[Track]>,
        progress: &mut dyn FnMut(u64),
    ) -> Result<Self, ReplayError> {
        told_apart(&mut entrants);
        let interfaces: Vec<&Interface> = entrants.iter().map(Entrant::interface).collect();
        signals.check(&interfaces)?;
        let mut contest = replayed(&entrants, signals, recording, elsewhere.is_none(), progress)?;
        let times = contest.times.clone();
        for (r, quantity) in contest.quantities.iter_mut().enumerate() {
            match elsewhere {
                Some(tracks) => quantity.reference = tracks[r].clone(),
                None => quantity.reference.times.clone_from(&times),
            }
            quantity.judge(&times, &entrants, r);
        }
        Ok(contest)
    }
}

/// Those that have a name in common are called by their files.
fn told_apart(all: &mut [Entrant]) {
    let names: Vec<String> = all.iter().map(|it| it.name.clone()).collect();
    for entrant in all {
        if names.iter().filter(|name| **name == entrant.name).count() > 1 {
            entrant.name.clone_from(&entrant.file);
        }
    }
}

impl Quantity {
    /// Finds the rows to compare and scores every estimate on them.
    fn judge(&mut self, times: &[f64], entrants: &[Entrant], r: usize) {
        let mut from = 0;
        self.known = times.iter().map(|time| self.reference.at(*time, &self.answer.turns, &mut from)).collect();
        let everyone =
            |row: &usize| self.known[*row].is_finite() && self.estimates.iter().all(|it| it[*row].is_finite());
        self.compared = (0..times.len()).filter(everyone).collect();
        let score = |(entrant, estimate): (&Entrant, &Vec<f64>)| {
            let answer = &entrant.interface.answers[entrant.places[r]];
            let (reference, rows) = (&self.reference, &self.compared);
            let bound = answer.bound(&entrant.generated.design);
            Pair { answer, times, estimate, reference, rows, bound }.score(entrant.generated.plant.sample_time_s())
        };
        self.scores = entrants.iter().zip(&self.estimates).map(score).collect();
    }
}

/// Feeds the recording to all of them; the references are columns of it where it has its `own`.
fn replayed<R: Read>(
    entrants: &[Entrant],
    signals: &Signals,
    mut recording: Recording<R>,
    own: bool,
    progress: &mut dyn FnMut(u64),
) -> Result<Contest, ReplayError> {
    let header = recording.header().clone();
    let mut selection = Selection::default();
    let read = Signals { reference: Vec::new(), ..signals.clone() };
    let mut columns = Vec::new();
    for it in entrants {
        columns.push(Columns::find(&it.generated.plant, &it.interface, &read, &header, &mut selection, false)?);
        selection.apply(&mut recording)?;
    }
    let own = signals.reference.iter().filter(|_| own);
    let own: Vec<usize> = own.map(|(_, column)| selection.place(Source::named(column, &header.columns))).collect();
    let width = selection.apply(&mut recording)?;

    let mut contest = Contest::new(entrants, signals, recording.name());
    let mut all: Vec<Steps> = entrants.iter().map(|it| Steps::new(&it.generated)).collect();
    let mut cells = vec![0.0; width];
    while recording.next_row(&mut cells)? {
        for (place, columns) in columns.iter_mut().enumerate() {
            let row = columns.row(&cells, &recording, |now| all[place].time_of_call(now))?;
            let sample = all[place].feed(&row).map_err(|error| entrants[place].unfit(recording.unfit(&error)))?;
            contest.take(place, &entrants[place], &sample)?;
        }
        for (quantity, place) in contest.quantities.iter_mut().zip(&own) {
            quantity.reference.values.push(cells[*place]);
        }
        contest.rows += 1;
        progress(contest.rows as u64);
    }
    if contest.rows == 0 {
        return Err(recording.has_no_rows().into());
    }
    for (steps, entrant) in all.iter().zip(entrants) {
        steps.judge().map_err(|error| entrant.unfit(recording.unfit_whole(&error)))?;
    }
    for (rival, steps) in contest.rivals.iter_mut().zip(&all) {
        rival.residuals = steps.residuals();
    }
    for (steps, columns) in all.iter().zip(&columns) {
        for remark in columns.remark.iter().cloned().chain(steps.remarks(columns.negative_ages)) {
            if !contest.remarks.contains(&remark) {
                contest.remarks.push(remark);
            }
        }
    }
    Ok(contest)
}

impl Contest {
    /// Nothing seen yet.
    fn new(entrants: &[Entrant], signals: &Signals, log: &str) -> Self {
        let rival = |it: &Entrant| Rival {
            name: it.name.clone(),
            file: it.file.clone(),
            method: it.generated.design.method,
            sample_time: it.generated.plant.sample_time_s(),
            cost: cost(&it.generated.program, deadbeat_math::COSTS),
            converged_row: None,
            converged_after: None,
            residuals: Vec::new(),
        };
        let quantity = |(r, (_, column)): (usize, &(String, String))| Quantity {
            answer: entrants[0].interface.answers[entrants[0].places[r]].clone(),
            column: column.clone(),
            reference: Track::default(),
            known: Vec::new(),
            compared: Vec::new(),
            estimates: vec![Vec::new(); entrants.len()],
            scores: Vec::new(),
        };
        Self {
            title: String::new(),
            log: log.to_owned(),
            rows: 0,
            remarks: Vec::new(),
            times: Vec::new(),
            rivals: entrants.iter().map(rival).collect(),
            quantities: signals.reference.iter().enumerate().map(quantity).collect(),
        }
    }

    /// Keeps what one of the steps gave; the first one's time is the row's.
    fn take(&mut self, place: usize, entrant: &Entrant, sample: &Sample) -> Result<(), SignalError> {
        if place == 0 {
            self.times.push(sample.t);
        }
        let (now, first) = (self.times[self.rows], self.times[0]);
        if sample.t != now {
            let (one, other) = (&self.rivals[0], &self.rivals[place]);
            return Err(SignalError::Apart {
                log: self.log.clone(),
                one: (one.file.clone(), one.sample_time),
                other: (other.file.clone(), other.sample_time),
            });
        }
        let converged = sample.status != Status::Converging;
        let rival = &mut self.rivals[place];
        if converged && rival.converged_row.is_none() {
            (rival.converged_row, rival.converged_after) = (Some(self.rows), Some(now - first));
        }
        for (quantity, at) in self.quantities.iter_mut().zip(&entrant.places) {
            let converged = entrant.interface.has_converged(*at, &sample.estimate, sample.status);
            quantity.estimates[place].push(if converged { sample.estimate[*at] } else { f64::NAN });
        }
        Ok(())
    }
}
