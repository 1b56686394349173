//! The figure of a replay: per state its estimate with measurement and reference, and the error.

use deadbeat_codegen::Generated;
use deadbeat_codegen::describe::short;
use deadbeat_codegen::program::Status;
use deadbeat_codegen::window::seconds;

use super::replay::{Replay, Row, Sample};
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

/// The curves of one state.
struct State {
    estimate: Line,
    /// With the output that is exactly this state.
    measured: Option<(usize, Line)>,
    reference: Option<(Line, Line)>,
}

/// All curves of a replay, thinned as they come.
pub struct Curves {
    states: Vec<State>,
    start: Option<f64>,
    zoom_s: f64,
}

impl Curves {
    /// Prepares the curves; `compared` says which states have a reference.
    pub fn new(generated: &Generated, compared: &[bool]) -> Self {
        let plant = &generated.plant;
        let measured = |j: usize| {
            let alone = |o: &usize| plant.c[*o].iter().enumerate().all(|(k, c)| c.is_zero() == (k != j));
            let unit =
                |o: &usize| plant.c[*o][j].as_rational().is_some_and(|c| c == deadbeat_codegen::real::Rational::ONE);
            (0..plant.outputs.len()).find(|o| alone(o) && unit(o))
        };
        let states = (0..plant.states.len()).map(|j| State {
            estimate: Line::new(),
            measured: measured(j).map(|o| (o, Line::new())),
            reference: compared[j].then(|| (Line::new(), Line::new())),
        });
        let zoom_s = seconds(WINDOWS_IN_ZOOM * generated.design.window_steps.max(1), plant.sample_time_s());
        Self { states: states.collect(), start: None, zoom_s }
    }

    /// Takes one row and what the step made of it.
    pub fn add(&mut self, row: &Row, sample: &Sample) {
        let start = *self.start.get_or_insert(sample.t);
        let zoom = sample.t - start <= self.zoom_s;
        let t = sample.t;
        let converged = sample.status != Status::Converging;
        for (j, state) in self.states.iter_mut().enumerate() {
            let estimate = sample.estimate[j];
            let shown = if converged { estimate } else { f64::NAN };
            state.estimate.whole.push(t, shown);
            if zoom {
                state.estimate.beginning.push(t, estimate);
            }
            if let Some((output, line)) = &mut state.measured {
                line.push(t, row.outputs[*output], zoom);
            }
            if let Some((reference, error)) = &mut state.reference {
                reference.push(t, row.references[j], zoom);
                error.push(t, if converged { estimate - row.references[j] } else { f64::NAN }, zoom);
            }
        }
    }

    /// The finished figure.
    pub fn figure(&self, generated: &Generated, replay: &Replay) -> Figure {
        let plant = &generated.plant;
        let title = if plant.title.is_empty() { plant.name.clone() } else { plant.title.clone() };
        let start = self.start.unwrap_or(0.0);
        let first = format!("the first {} s", short(self.zoom_s));
        let panels = self.states.iter().enumerate().flat_map(|(j, state)| self.panels(generated, replay, j, state));
        Figure {
            description: format!(
                "{title}. Estimate by {}: {}.",
                generated.design.method,
                self.sentence(generated, replay)
            ),
            subtitle: format!(
                "{}: {}\n{}",
                generated.design.method,
                generated.design.summary,
                self.sentence(generated, replay)
            ),
            title,
            x_label: "time [s]".into(),
            columns: vec![
                Column { title: "the whole recording".into(), x_range: None },
                Column { title: first, x_range: Some((start, start + self.zoom_s)) },
            ],
            panels: panels.collect(),
        }
    }

    /// The errors in words.
    fn sentence(&self, generated: &Generated, replay: &Replay) -> String {
        let named = generated.plant.states.iter().zip(&replay.errors).zip(&self.states);
        let errors: Vec<(u64, String)> = named
            .filter(|(_, state)| state.reference.is_some())
            .map(|((state, errors), _)| {
                let (rms, max) = errors.shown();
                (errors.rows, format!("{} {rms} RMS, {max} maximum {}", state.label.name, state.label.unit))
            })
            .collect();
        let Some((rows, _)) = errors.first() else {
            return format!("{} rows, nothing to compare with", replay.rows);
        };
        // References with gaps of their own are compared over rows of their own.
        if errors.iter().all(|(other, _)| other == rows) {
            let list: Vec<&str> = errors.iter().map(|(_, text)| text.as_str()).collect();
            return format!("error over {rows} converged rows: {}", list.join("; ").trim_end());
        }
        let list: Vec<String> = errors.iter().map(|(rows, text)| format!("{} over {rows}", text.trim_end())).collect();
        format!("error over converged rows: {}", list.join("; "))
    }

    /// One panel for the quantity and, with a reference, one for the error.
    fn panels(&self, generated: &Generated, replay: &Replay, j: usize, state: &State) -> Vec<Panel> {
        let label = &generated.plant.states[j].label;
        let unit = if label.unit.is_empty() { String::new() } else { format!(" [{}]", label.unit) };
        let converged =
            self.start.unwrap_or(0.0) + seconds(generated.design.valid_from_step, generated.plant.sample_time_s());
        let marker = || Marker { x: converged, label: format!("converged, {} s", short(converged)) };
        let quantity = |whole: bool| {
            let pick = |line: &Line| if whole { line.whole.points() } else { line.beginning.points() };
            let mut curves = Vec::new();
            if let Some((output, line)) = &state.measured {
                let name = format!("measured {}", generated.plant.outputs[*output].label.name);
                curves.push(Curve { label: name, role: Role::Measured, points: pick(line) });
            }
            if let Some((reference, _)) = &state.reference {
                curves.push(Curve { label: "reference".into(), role: Role::Reference, points: pick(reference) });
            }
            curves.push(Curve { label: "estimate".into(), role: Role::Estimate, points: pick(&state.estimate) });
            Cell { curves, marker: (!whole).then(marker), band: None }
        };
        let mut panels = vec![Panel {
            y_label: format!("{}{unit}", label.name),
            title: label.doc.clone(),
            cells: vec![quantity(true), quantity(false)],
        }];
        if let Some((_, error)) = &state.reference {
            let cell = |line: &Thin| Cell {
                curves: vec![Curve { label: "error".into(), role: Role::Error, points: line.points() }],
                marker: None,
                band: None,
            };
            let (rms, max) = replay.errors[j].shown();
            panels.push(Panel {
                y_label: format!("error of {}{unit}", label.name),
                title: format!("{rms} RMS, {max} maximum"),
                cells: vec![cell(&error.whole), cell(&error.beginning)],
            });
        }
        panels
    }
}
