//! A recording through several steps at once, and their scores.

use deadbeat_codegen::program::Status;
use deadbeat_codegen::program::cost::{Cost, cost};
use deadbeat_codegen::{Generated, Settings};

use super::super::columns::{Columns, Selection, Signals};
use super::super::files::{explained, open};
use super::super::interface::{Answer, Interface};
use super::super::progress::Progress;
use super::super::recording::Recording;
use super::super::replay::{Replay, Sample};
use super::super::{Failure, read_spec, show};
use super::group::Group;
use super::score::{Pair, Score};
use super::track::{self, Track};

/// What came out.
pub struct Contest {
    /// May be empty.
    pub title: String,
    /// The recording's name.
    pub log: String,
    /// Of the recording.
    pub rows: usize,
    /// Remarks on the recording, a line each.
    pub remarks: String,
    /// Per row, s.
    pub times: Vec<f64>,
    /// In the order in which they were given.
    pub rivals: Vec<Rival>,
    /// In the order in which they were given.
    pub quantities: Vec<Quantity>,
}

/// One of the steps.
pub struct Rival {
    /// The specification's name, or its file's where two have the same.
    pub name: String,
    /// The specification's file.
    pub file: String,
    pub method: &'static str,
    /// s.
    pub sample_time: f64,
    pub cost: Cost,
    /// The first row with an estimate that has converged.
    pub converged_row: Option<usize>,
    /// From the first row on until then, s.
    pub converged_after: Option<f64>,
}

/// A quantity that all estimate, and what it is compared with.
pub struct Quantity {
    /// As the first of the specifications has it.
    pub answer: Answer,
    /// The column of the reference.
    pub column: String,
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

/// A specification that is taking part.
struct Entrant {
    name: String,
    file: String,
    generated: Generated,
    interface: Interface,
    /// Per reference: the place of its estimate.
    places: Vec<usize>,
}

impl Entrant {
    fn replay(&self) -> Replay<'_> {
        Replay::new(&self.generated.plant, &self.interface, &self.generated.program)
    }
}

impl Contest {
    /// Holds it; `None` when a specification is wrong, which has been said.
    pub fn hold(group: &Group, settings: Settings) -> Result<Option<Self>, Failure> {
        let Some(entrants) = entrants(group, settings)? else { return Ok(None) };
        let read: Vec<_> = entrants.iter().map(|it| (&it.generated.plant, &it.interface)).collect();
        group.signals.check(&read)?;
        let columns: Vec<&str> = group.signals.reference.iter().map(|(_, column)| column.as_str()).collect();
        let elsewhere = group.reference_log.as_deref().map(|path| track::read(path, &columns)).transpose()?;
        let mut contest = replayed(group, &entrants)?;
        let times = contest.times.clone();
        for (r, quantity) in contest.quantities.iter_mut().enumerate() {
            match &elsewhere {
                Some(tracks) => quantity.reference = tracks[r].clone(),
                None => quantity.reference.times.clone_from(&times),
            }
            quantity.judge(&times, &entrants, r);
        }
        Ok(Some(contest))
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
            Pair { answer, times, estimate, reference, rows }.score(entrant.generated.plant.sample_time_s())
        };
        self.scores = entrants.iter().zip(&self.estimates).map(score).collect();
    }
}

/// Designs every specification; `None` when one is wrong.
fn entrants(group: &Group, settings: Settings) -> Result<Option<Vec<Entrant>>, Failure> {
    if group.signals.reference.is_empty() {
        return Err(Failure::Misused("name what to compare with: --reference STATE=COLUMN".into()));
    }
    if group.specs.is_empty() {
        return Err(Failure::Misused(format!("no specification is named for {}", group.log.display())));
    }
    let mut all: Vec<Entrant> = Vec::new();
    let mut wrong = false;
    for path in &group.specs {
        match read_spec(path, settings)?.design() {
            Ok(generated) => {
                show(&generated.report);
                let interface = Interface::of(&generated);
                let file = path.display().to_string();
                let places = places(&interface, &group.signals, &file)?;
                all.push(Entrant { name: generated.plant.name.clone(), file, generated, interface, places });
            }
            Err(report) => {
                show(&report);
                wrong = true;
            }
        }
    }
    let names: Vec<String> = all.iter().map(|it| it.name.clone()).collect();
    for entrant in &mut all {
        if names.iter().filter(|name| **name == entrant.name).count() > 1 {
            entrant.name.clone_from(&entrant.file);
        }
    }
    Ok((!wrong).then_some(all))
}

/// Where a step has the estimates of the references.
fn places(interface: &Interface, signals: &Signals, file: &str) -> Result<Vec<usize>, Failure> {
    let place = |(name, _): &(String, String)| {
        let found = interface.quantities().find(|(_, answer)| answer.name == *name).map(|(place, _)| place);
        found.ok_or_else(|| {
            let list: Vec<String> = interface.quantities().map(|(_, answer)| format!("`{}`", answer.name)).collect();
            let list = list.join(", ");
            Failure::Misused(format!("--reference: `{name}` is not a state of {file}; its states are {list}"))
        })
    };
    signals.reference.iter().map(place).collect()
}

/// Feeds the recording to all of them.
fn replayed(group: &Group, entrants: &[Entrant]) -> Result<Contest, Failure> {
    let (source, name) = open(&group.log)?;
    let mut recording = Recording::open(source, &name).map_err(|error| explained(&error))?;
    let there = recording.columns().to_vec();
    let mut selection = Selection::default();
    let signals = Signals { reference: Vec::new(), ..group.signals.clone() };
    let mut columns = Vec::new();
    for it in entrants {
        columns.push(Columns::find(&it.generated.plant, &it.interface, &signals, &there, &mut selection, false)?);
        selection.apply(&mut recording).map_err(|error| explained(&error))?;
    }
    let own = group.signals.reference.iter().filter(|_| group.reference_log.is_none());
    let own: Vec<usize> = own.map(|(_, column)| selection.place(column.clone())).collect();
    let width = selection.apply(&mut recording).map_err(|error| explained(&error))?;

    let mut contest = Contest::new(group, entrants, &name);
    let mut replays: Vec<Replay> = entrants.iter().map(Entrant::replay).collect();
    let mut progress = Progress::new();
    let mut cells = vec![0.0; width];
    while recording.next_row(&mut cells).map_err(|error| explained(&error))? {
        let line = recording.line();
        for (place, columns) in columns.iter_mut().enumerate() {
            let row = columns.row(&cells, &recording)?;
            let sample = replays[place].feed(&row).map_err(|why| {
                let file = &entrants[place].file;
                Failure::Wrong(format!("{name}:{line}: {file} does not fit the recording: {why}"))
            })?;
            contest.take(place, &entrants[place], &sample)?;
        }
        for (quantity, place) in contest.quantities.iter_mut().zip(&own) {
            quantity.reference.values.push(cells[*place]);
        }
        contest.rows += 1;
        progress.show(contest.rows as u64);
    }
    drop(progress);
    if contest.rows == 0 {
        return Err(Failure::Wrong(format!("{name}: the recording has no rows")));
    }
    for (replay, columns) in replays.iter().zip(&columns) {
        for remark in replay.remarks(columns.negative_ages).lines() {
            if !contest.remarks.contains(remark) {
                contest.remarks += remark;
                contest.remarks.push('\n');
            }
        }
    }
    Ok(contest)
}

impl Contest {
    /// Nothing seen yet.
    fn new(group: &Group, entrants: &[Entrant], log: &str) -> Self {
        let rival = |it: &Entrant| Rival {
            name: it.name.clone(),
            file: it.file.clone(),
            method: it.generated.design.method,
            sample_time: it.generated.plant.sample_time_s(),
            cost: cost(&it.generated.program, deadbeat_math::COSTS),
            converged_row: None,
            converged_after: None,
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
            title: group.title.clone(),
            log: log.to_owned(),
            rows: 0,
            remarks: String::new(),
            times: Vec::new(),
            rivals: entrants.iter().map(rival).collect(),
            quantities: group.signals.reference.iter().enumerate().map(quantity).collect(),
        }
    }

    /// Keeps what one of the steps gave; the first one's time is the row's.
    fn take(&mut self, place: usize, entrant: &Entrant, sample: &Sample) -> Result<(), Failure> {
        if place == 0 {
            self.times.push(sample.t);
        }
        let (now, first) = (self.times[self.rows], self.times[0]);
        if sample.t != now {
            let (one, other) = (&self.rivals[0], &entrant.file);
            return Err(Failure::Misused(format!(
                "{} has no column `t`: its rows are {} s apart for {}, and {} s for {other}",
                self.log, one.sample_time, one.file, self.rivals[place].sample_time
            )));
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
