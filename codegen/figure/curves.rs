//! The figure of a replay: per state its estimate with measurement and reference, and the error.

use std::io::Read;

use crate::generated::Generated;
use crate::numbers::{seconds, short};
use crate::plant::Plant;
use crate::real::Rational;
use crate::replay::{Answer, Compared, Interface, MeasuredKind, Replay, Step, Verdict, fold, number};

use super::svg::{Cell, Column, Curve, Figure, Marker, Panel, Role};
use super::thin::Thin;

/// Pixel columns of a panel.
const COLUMNS: usize = 350;
/// The second column shows this many windows from the start.
const WINDOWS_IN_ZOOM: usize = 10;

/// One curve, over everything and over the beginning.
struct Line {
    whole: Thin,
    beginning: Thin,
}

impl Line {
    fn new() -> Self {
        Self { whole: Thin::new(COLUMNS), beginning: Thin::new(COLUMNS) }
    }

    fn push(&mut self, t: f64, y: f64, in_zoom: bool) {
        self.whole.push(t, y);
        if in_zoom {
            self.beginning.push(t, y);
        }
    }
}

/// The curves of one field of the estimate.
struct Quantity {
    /// Its place among the fields.
    field: usize,
    answer: Answer,
    estimate: Line,
    /// With the output that is exactly this state.
    measured: Option<(Measured, Line)>,
    reference: Option<(Line, Line)>,
}

/// How a field of the measurements becomes a curve.
struct Measured {
    /// Its place among the fields.
    field: usize,
    output: usize,
    /// What one unit of the field is in the output's.
    scale: f64,
}

/// All curves of a replay, thinned as they come.
pub struct Curves<'a> {
    generated: &'a Generated,
    interface: Interface,
    quantities: Vec<Quantity>,
    start: Option<f64>,
    zoom_s: f64,
}

impl<'a> Curves<'a> {
    /// Prepares the curves of a replay that is about to begin.
    pub fn new<R: Read>(replay: &Replay<'a, R>) -> Self {
        let (generated, interface, compared) = (replay.generated(), replay.interface(), replay.compared());
        let plant = &generated.plant;
        let quantities = interface.quantities().map(|(field, answer)| Quantity {
            field,
            answer: answer.clone(),
            estimate: Line::new(),
            measured: answer
                .state
                .filter(|state| plant.states[*state].label.name == answer.name)
                .and_then(|state| measured(plant, interface, state))
                .map(|measured| (measured, Line::new())),
            reference: compared[field].then(|| (Line::new(), Line::new())),
        });
        let zoom_s = seconds(WINDOWS_IN_ZOOM * generated.design.window_steps.max(1), plant.sample_time_s());
        Self { generated, interface: interface.clone(), quantities: quantities.collect(), start: None, zoom_s }
    }

    /// Takes one row and what the step made of it.
    pub fn add(&mut self, Step { row, sample }: &Step) {
        let start = *self.start.get_or_insert(sample.t);
        let zoom = sample.t - start <= self.zoom_s;
        let t = sample.t;
        for quantity in &mut self.quantities {
            let estimate = sample.estimate[quantity.field];
            let converged = self.interface.has_converged(quantity.field, &sample.estimate, sample.status);
            let turns = &quantity.answer.turns;
            quantity.estimate.whole.push(t, if converged { estimate } else { f64::NAN });
            if zoom {
                quantity.estimate.beginning.push(t, estimate);
            }
            if let Some((measured, line)) = &mut quantity.measured {
                line.push(t, fold(measured.scale * row.measurements[measured.field], turns), zoom);
            }
            if let Some((reference, error)) = &mut quantity.reference {
                let difference = quantity.answer.error(estimate, row.references[quantity.field]);
                let known = row.references[quantity.field];
                reference.push(t, if turns.is_empty() { known } else { estimate - difference }, zoom);
                error.push(t, if converged { difference } else { f64::NAN }, zoom);
            }
        }
    }

    /// The finished figure, with the errors of the verdict in it.
    pub fn figure(&self, verdict: &Verdict) -> Figure {
        let Generated { plant, design, .. } = self.generated;
        let title = if plant.title.is_empty() { plant.name.clone() } else { plant.title.clone() };
        let start = self.start.unwrap_or(0.0);
        let first = format!("the first {} s", short(self.zoom_s));
        let panels = self.quantities.iter().flat_map(|quantity| self.panels(verdict, quantity));
        Figure {
            description: format!("{title}. Estimate by {}: {}.", design.method, sentence(verdict)),
            subtitle: format!("{}: {}\n{}", design.method, design.summary, sentence(verdict)),
            title,
            x_label: "time [s]".into(),
            legend: Vec::new(),
            columns: vec![
                Column { title: "the whole recording".into(), x_range: None },
                Column { title: first, x_range: Some((start, start + self.zoom_s)) },
            ],
            panels: panels.collect(),
        }
    }

    /// One panel for the quantity and, with a reference, one for the error.
    fn panels(&self, verdict: &Verdict, quantity: &Quantity) -> Vec<Panel> {
        let (generated, label) = (self.generated, &quantity.answer);
        let unit = if label.unit.is_empty() { String::new() } else { format!(" [{}]", label.unit) };
        let converged =
            self.start.unwrap_or(0.0) + seconds(generated.design.valid_from_step, generated.plant.sample_time_s());
        let marker = || Marker { x: converged, label: format!("converged, {} s", short(converged)) };
        let shown = |whole: bool| {
            let pick = |line: &Line| if whole { line.whole.points() } else { line.beginning.points() };
            let mut curves = Vec::new();
            if let Some((measured, line)) = &quantity.measured {
                let name = format!("measured {}", generated.plant.outputs[measured.output].label.name);
                curves.push(Curve { label: name, role: Role::Measured, points: pick(line) });
            }
            if let Some((reference, _)) = &quantity.reference {
                curves.push(Curve { label: "reference".into(), role: Role::Reference, points: pick(reference) });
            }
            curves.push(Curve { label: "estimate".into(), role: Role::Estimate, points: pick(&quantity.estimate) });
            Cell { curves, marker: (!whole).then(marker), band: None }
        };
        let mut panels = vec![Panel {
            y_label: format!("{}{unit}", label.name),
            title: label.doc.clone(),
            cells: vec![shown(true), shown(false)],
        }];
        if let Some((_, error)) = &quantity.reference {
            let cell = |line: &Thin| Cell {
                curves: vec![Curve { label: "error".into(), role: Role::Error, points: line.points() }],
                marker: None,
                band: None,
            };
            let (rms, max) = verdict.errors(&label.name).cloned().unwrap_or_default().shown();
            panels.push(Panel {
                y_label: format!("error of {}{unit}", label.name),
                title: format!("{rms} RMS, {max} maximum"),
                cells: vec![cell(&error.whole), cell(&error.beginning)],
            });
        }
        panels
    }
}

/// The errors in words.
fn sentence(verdict: &Verdict) -> String {
    let words = |Compared { answer, errors }: &Compared| {
        let (rms, max) = errors.shown();
        (errors.rows, format!("{} {rms} RMS, {max} maximum {}", answer.name, answer.unit))
    };
    let errors: Vec<(u64, String)> = verdict.compared.iter().map(words).collect();
    let Some((rows, _)) = errors.first() else {
        return format!("{} rows, nothing to compare with", verdict.rows);
    };
    // References with gaps of their own are compared over rows of their own.
    if errors.iter().all(|(other, _)| other == rows) {
        let list: Vec<&str> = errors.iter().map(|(_, text)| text.as_str()).collect();
        return format!("error over {rows} converged rows: {}", list.join("; ").trim_end());
    }
    let list: Vec<String> = errors.iter().map(|(rows, text)| format!("{} over {rows}", text.trim_end())).collect();
    format!("error over converged rows: {}", list.join("; "))
}

/// The field of the measurements that is one state, alone and as it is.
fn measured(plant: &Plant, interface: &Interface, state: usize) -> Option<Measured> {
    let row = |output: usize| &plant.c[output];
    let alone = |output: usize| row(output).iter().enumerate().all(|(k, c)| c.is_zero() == (k != state));
    let unit = |output: usize| row(output)[state].as_rational().is_some_and(|c| c == Rational::ONE);
    interface.measurements.iter().enumerate().find_map(|(field, measured)| match measured.kind {
        MeasuredKind::Sample { output, .. } if alone(output) && unit(output) => {
            let quantum = plant.outputs[output].quantum.as_ref().filter(|_| measured.kind.is_count());
            Some(Measured { field, output, scale: quantum.map_or(1.0, number) })
        }
        _ => None,
    })
}
