//! The keys `process_noise`, `measurement_noise` and `density`: what a Kalman filter is designed for.

use std::ops::Range;

use crate::diagnostic::{Diagnostic, codes};
use crate::estimator::corrector::noise::over_a_sample;
use crate::estimator::corrector::riccati::{Failure, Noise};
use crate::expr::{Constant, List};
use crate::numbers::short;
use crate::plant::Plant;
use crate::real::{Matrix, Precision, Real, zero_order_hold};
use crate::sampled::model::Matrices;
use crate::spec::Quantity;
use crate::spec::reader::Table;

/// The keys, for the table's own messages.
pub(super) const KEYS: [(&str, &str, &str); 3] = [
    ("process_noise", "list or matrix", "Q: variances of the states' own noise, or its covariance matrix"),
    ("measurement_noise", "list or matrix", "R: variances of the outputs' noise, or its covariance matrix"),
    ("density", "true | false", "spectral densities (per Hz), or covariances per sample (default)"),
];

/// The keys as they are written.
#[derive(Clone, Debug)]
pub(super) struct Keys {
    process: Option<Given>,
    measurement: Option<Given>,
    /// With its place.
    density: (bool, Range<usize>),
}

/// A diagonal or a matrix, with its place.
#[derive(Clone, Debug)]
struct Given {
    rows: Vec<Vec<Quantity>>,
    diagonal: bool,
    span: Range<usize>,
}

/// Reads the keys.
pub(super) fn read(table: &mut Table) -> Keys {
    let mut given = |key: &str| -> Option<Given> {
        if table.has_rows(key) {
            return table.matrix(key).map(|(rows, span)| Given { rows, diagonal: false, span });
        }
        table.list(key).map(|(row, span)| Given { rows: vec![row], diagonal: true, span })
    };
    let (process, measurement) = (given("process_noise"), given("measurement_noise"));
    let span = table.key_span("density");
    Keys { process, measurement, density: (table.flag("density").unwrap_or(false), span) }
}

/// What a filter is designed for, exactly.
#[derive(Clone, Debug)]
pub(super) struct Model {
    process: Process,
    measurement: Measurement,
    density: bool,
    /// Of Q and of R, or of the observer's name.
    spans: [Range<usize>; 2],
}

#[derive(Clone, Debug)]
enum Process {
    Covariance(Vec<Vec<Constant>>),
    /// The declared disturbances, each uniform within its bound.
    Disturbances,
}

#[derive(Clone, Debug)]
enum Measurement {
    Covariance(Vec<Vec<Constant>>),
    /// The outputs' noise, each uniform within its bound.
    Bounds(Vec<Constant>),
}

impl Keys {
    /// Whether any of them is there.
    pub(super) fn given(&self) -> bool {
        self.process.is_some() || self.measurement.is_some()
    }

    /// Where the first of them stands, if any is there.
    pub(super) fn place(&self) -> Option<Range<usize>> {
        self.process.as_ref().or(self.measurement.as_ref()).map(|given| given.span.clone())
    }

    /// The noise, after everything that stands against it was reported.
    pub(super) fn check(&self, plant: &Plant, found: &mut Vec<Diagnostic>) -> Option<Model> {
        let before = found.len();
        let (density, place) = self.density.clone();
        if density && plant.discrete {
            let message = "a plant in discrete time has no noise density";
            let error = Diagnostic::error(codes::BAD_COMBINATION, place, message);
            found.push(error.help("leave `density` out, and write covariances per sample"));
        } else if density && self.process.is_none() && self.measurement.is_none() {
            let message = "`density` says what `process_noise` and `measurement_noise` are; neither is there";
            let error = Diagnostic::error(codes::BAD_COMBINATION, place, message);
            found.push(error.help("leave it out: declared bounds are taken as they are"));
        }
        let process = match &self.process {
            Some(given) => {
                given.check("process_noise", plant.states.len(), "state", plant, found).map(Process::Covariance)
            }
            None => disturbances(plant, found),
        };
        let measurement = match &self.measurement {
            Some(given) => {
                let rows = given.check("measurement_noise", plant.outputs.len(), "output", plant, found);
                rows.map(Measurement::Covariance)
            }
            None => bounds(plant, found),
        };
        let span =
            |given: &Option<Given>| given.as_ref().map_or_else(|| plant.span.clone(), |given| given.span.clone());
        let spans = [span(&self.process), span(&self.measurement)];
        let model = Model { process: process?, measurement: measurement?, density, spans };
        (found.len() == before).then_some(model)
    }
}

fn disturbances(plant: &Plant, found: &mut Vec<Diagnostic>) -> Option<Process> {
    if !plant.disturbances.is_empty() {
        return Some(Process::Disturbances);
    }
    let message = "a Kalman filter needs the process noise";
    let error = Diagnostic::error(codes::MISSING_KEY, plant.span.clone(), message);
    found.push(error.help("write `process_noise = […]`, a variance per state, or declare `[disturbances]`"));
    None
}

fn bounds(plant: &Plant, found: &mut Vec<Diagnostic>) -> Option<Measurement> {
    let mut bounds = Vec::new();
    for output in &plant.outputs {
        match output.noise.as_ref().filter(|noise| !noise.is_zero()) {
            Some(noise) => bounds.push(noise.clone()),
            None => {
                let message = format!("a Kalman filter needs the noise of `{}`", output.label.name);
                let error = Diagnostic::error(codes::MISSING_KEY, output.label.span.clone(), message);
                found.push(error.help("declare its `noise`, above 0, or write `measurement_noise = […]`"));
            }
        }
    }
    (bounds.len() == plant.outputs.len()).then_some(Measurement::Bounds(bounds))
}

impl Given {
    fn check(
        &self,
        key: &str,
        size: usize,
        what: &str,
        plant: &Plant,
        found: &mut Vec<Diagnostic>,
    ) -> Option<Vec<Vec<Constant>>> {
        let shape = if self.diagonal { self.rows[0].len() == size } else { is_square(&self.rows, size) };
        if !shape {
            let message = format!("`{key}` must have a variance per {what}, or be a {size} x {size} matrix");
            let given = match (self.diagonal, self.rows.len(), self.rows[0].len()) {
                (true, _, entries) => format!("{entries} for {size} {what}s"),
                (false, rows, columns) => format!("{rows} x {columns}"),
            };
            found.push(Diagnostic::error(codes::SHAPE, self.span.clone(), message).label(given));
            return None;
        }
        let entries = |row: &Vec<Quantity>, found: &mut Vec<Diagnostic>| -> Option<Vec<Constant>> {
            let row: Vec<Option<Constant>> = row.iter().map(|entry| plant.constant(entry, found)).collect();
            row.into_iter().collect()
        };
        let rows: Vec<Option<Vec<Constant>>> = self.rows.iter().map(|row| entries(row, found)).collect();
        let mut rows: Vec<Vec<Constant>> = rows.into_iter().collect::<Option<_>>()?;
        if self.diagonal {
            let diagonal = rows.swap_remove(0);
            let entry = |i: usize, j: usize| if i == j { diagonal[i].clone() } else { Constant::default() };
            rows = (0..size).map(|i| (0..size).map(|j| entry(i, j)).collect()).collect();
        }
        self.check_values(key, &rows, found).then_some(rows)
    }

    /// Variances are not negative, and covariances symmetric.
    fn check_values(&self, key: &str, rows: &[Vec<Constant>], found: &mut Vec<Diagnostic>) -> bool {
        let before = found.len();
        for (i, row) in rows.iter().enumerate() {
            let variance = row[i].to_f64().unwrap_or(f64::NAN);
            if variance < 0.0 {
                let place = if self.diagonal { &self.rows[0][i] } else { &self.rows[i][i] };
                let message = format!("a variance in `{key}` is negative");
                let error = Diagnostic::error(codes::BAD_NUMBER, place.span(), message).measured(variance);
                found.push(error.help("a variance is the square of a standard deviation"));
            }
            for (j, entry) in row.iter().enumerate().skip(i + 1) {
                if *entry != rows[j][i] {
                    let message = format!("`{key}` is not symmetric");
                    let error = Diagnostic::error(codes::SHAPE, self.rows[i][j].span(), message);
                    let error = error.label("differs from its mirror image").context(self.rows[j][i].span(), "this");
                    found.push(error.help("a covariance is the same from either side"));
                }
            }
        }
        found.len() == before
    }
}

fn is_square(rows: &[Vec<Quantity>], size: usize) -> bool {
    rows.len() == size && rows.iter().all(|row| row.len() == size)
}

/// The variance of what is uniform within a bound: a third of its square.
fn uniform(bound: &Constant, p: Precision) -> Real {
    let bound = bound.evaluate(p).unwrap_or_else(|_| Real::zero(p));
    &(&bound * &bound) / &Real::from_i64(3, p)
}

fn matrix(rows: &[Vec<Constant>], p: Precision) -> Matrix {
    let value = |c: &Constant| c.evaluate(p).unwrap_or_else(|_| Real::zero(p));
    Matrix::from_fn(rows.len(), rows.len(), |i, j| value(&rows[i][j]))
}

impl Model {
    /// Covariances per sample.
    pub(super) fn at(&self, plant: &Plant, p: Precision) -> Result<Noise, Vec<Diagnostic>> {
        let matrices = Matrices::new(plant, &[], p)?;
        let too_fast = |error| matrices.too_fast(plant, error);
        let process = match &self.process {
            Process::Covariance(rows) if self.density => {
                over_a_sample(&matrices.a, &matrix(rows, p), &matrices.h).map_err(too_fast)?
            }
            Process::Covariance(rows) => matrix(rows, p),
            Process::Disturbances => disturbed(plant, &matrices, p)?,
        };
        let measurement =
            match &self.measurement {
                Measurement::Covariance(rows) if self.density => matrix(rows, p).map(|density| density / &matrices.h),
                Measurement::Covariance(rows) => matrix(rows, p),
                Measurement::Bounds(bounds) => Matrix::from_fn(bounds.len(), bounds.len(), |i, j| {
                    if i == j { uniform(&bounds[i], p) } else { Real::zero(p) }
                }),
            };
        Ok(Noise { process, measurement })
    }

    /// What it was taken from, a line each.
    pub(super) fn notes(&self, plant: &Plant) -> Vec<String> {
        let mut notes = Vec::new();
        if let Process::Disturbances = self.process {
            let names: Vec<&str> = plant.disturbances.iter().map(|d| d.label.name.as_str()).collect();
            notes.push(format!(
                "process noise from the disturbances {}: uniform within the bound (variance bound^2/3), new at every sample and held until the next",
                names.join(", ")
            ));
        }
        if let Measurement::Bounds(bounds) = &self.measurement {
            let shown = plant.outputs.iter().zip(bounds).map(|(output, bound)| {
                let bound = bound.to_f64().unwrap_or(f64::NAN);
                format!("{} {}", output.label.name, short(bound / deadbeat_math::sqrt_f64(3.0)))
            });
            let shown: Vec<String> = shown.collect();
            notes.push(format!(
                "measurement noise from the outputs' bounds: uniform (variance bound^2/3); standard deviations {}",
                shown.join(", ")
            ));
        }
        notes
    }

    /// A failure of the filter in words.
    pub(super) fn said(&self, plant: &Plant, failure: Failure) -> Vec<Diagnostic> {
        let [process, measurement] = self.spans.clone();
        vec![match failure {
            Failure::MeasurementNoise(_) => {
                let message = "the measurement noise has a combination without variance, or a negative one";
                Diagnostic::error(codes::BAD_NUMBER, measurement, message)
                    .help("every output, and every combination of them, needs some noise: a positive definite matrix")
            }
            Failure::ProcessNoise => {
                let message = "the process noise has a combination with negative variance";
                Diagnostic::error(codes::BAD_NUMBER, process, message)
                    .help("a covariance matrix: no product of two deviations is smaller than their covariance")
            }
            Failure::Undetectable => {
                let message = "a motion that does not die out is not seen by the outputs";
                Diagnostic::error(codes::UNOBSERVABLE, plant.span.clone(), message)
                    .help("measure it, or leave it out of the model")
            }
            Failure::Unexcited => {
                let message = "a motion that neither grows nor dies out has no process noise: its gain goes to 0";
                let error = Diagnostic::error(codes::METHOD_CANNOT, process, message);
                let names = self.quiet(plant);
                let error = if names.is_empty() { error } else { error.label(format!("none enters {}", List(&names))) };
                error.help("give it some: the variance by which it wanders from sample to sample")
            }
        }]
    }

    /// States whose own noise is structurally zero.
    fn quiet<'a>(&self, plant: &'a Plant) -> Vec<&'a str> {
        let quiet = |i: usize| match &self.process {
            Process::Covariance(rows) => rows[i][i].is_zero(),
            Process::Disturbances => plant.disturbances.iter().all(|d| d.column[i].is_zero()),
        };
        (0..plant.states.len()).filter(|i| quiet(*i)).map(|i| plant.states[i].label.name.as_str()).collect()
    }
}

/// The covariance of the declared disturbances, each held over a sample.
fn disturbed(plant: &Plant, matrices: &Matrices, p: Precision) -> Result<Matrix, Vec<Diagnostic>> {
    let n = plant.states.len();
    let mut sum = Matrix::zeros(n, n, p);
    for disturbance in &plant.disturbances {
        let value = |i: usize| disturbance.column[i].evaluate(p).unwrap_or_else(|_| Real::zero(p));
        let column = Matrix::from_fn(n, 1, |i, _| value(i));
        let effect = if plant.discrete {
            column
        } else {
            let held = zero_order_hold(&matrices.a, &column, &matrices.h);
            held.map_err(|error| matrices.too_fast(plant, error))?.1
        };
        sum = &sum + &(&effect * &effect.transpose()).scale(&uniform(&disturbance.bound, p));
    }
    Ok(sum)
}
