//! The figure of a contest: per quantity all estimates with the reference, and their errors below.

use deadbeat_codegen::describe::short;

use super::super::svg::{Cell, Column, Curve, Entry, Figure, Panel, Role};
use super::super::thin::Thin;
use super::contest::{Contest, Quantity};

/// Pixel columns of a panel.
const COLUMNS: usize = 420;
/// The second column shows so many times the longest convergence.
const CONVERGENCES_IN_ZOOM: f64 = 4.0;
/// And at least so many rows.
const ROWS_IN_ZOOM: usize = 100;

/// The finished figure.
pub fn figure(contest: &Contest) -> Figure {
    let start = contest.times.first().copied().unwrap_or(0.0);
    let zoom = zoom(contest) - start;
    let mut legend = vec![Entry { name: "reference".into(), role: Role::Reference }];
    let rivals = contest.rivals.iter().enumerate();
    legend.extend(rivals.map(|(k, rival)| Entry { name: rival.name.clone(), role: Role::Rival(k) }));
    let title = if contest.title.is_empty() { contest.log.clone() } else { contest.title.clone() };
    Figure {
        description: format!("{title}. {}.", sentence(contest)),
        subtitle: contest.remarks.trim_end().to_owned(),
        title,
        x_label: "time [s]".into(),
        legend,
        columns: vec![
            Column { title: "the whole recording".into(), x_range: None },
            Column { title: format!("the first {} s", short(zoom)), x_range: Some((start, start + zoom)) },
        ],
        panels: contest.quantities.iter().flat_map(|quantity| panels(contest, quantity, start + zoom)).collect(),
    }
}

/// Where the second column ends, s.
fn zoom(contest: &Contest) -> f64 {
    let start = contest.times.first().copied().unwrap_or(0.0);
    let longest = contest.rivals.iter().filter_map(|rival| rival.converged_after).fold(0.0, f64::max);
    let rows = contest.times.get(ROWS_IN_ZOOM).or(contest.times.last()).copied().unwrap_or(start);
    rows.max(start + CONVERGENCES_IN_ZOOM * longest)
}

/// The errors in words.
fn sentence(contest: &Contest) -> String {
    let of = |quantity: &Quantity| {
        let scores = contest.rivals.iter().zip(&quantity.scores);
        let list: Vec<String> =
            scores.map(|(rival, score)| format!("{} {}", rival.name, score.rms.map_or("-".into(), short))).collect();
        let unit = &quantity.answer.unit;
        format!("Error of {}, RMS: {} {unit}", quantity.answer.name, list.join(", ")).trim_end().to_owned()
    };
    contest.quantities.iter().map(of).collect::<Vec<_>>().join("; ")
}

/// The quantity, and below it the errors; the largest errors are drawn first, so that they hide nothing.
fn panels(contest: &Contest, quantity: &Quantity, zoom_end: f64) -> [Panel; 2] {
    let answer = &quantity.answer;
    let unit = if answer.unit.is_empty() { String::new() } else { format!(" [{}]", answer.unit) };
    let mut order: Vec<usize> = (0..contest.rivals.len()).collect();
    order.sort_by(|a, b| {
        let rms = |k: &usize| quantity.scores[*k].rms.unwrap_or(f64::INFINITY);
        rms(b).total_cmp(&rms(a))
    });
    let mut from = 0;
    let reference: Vec<f64> =
        contest.times.iter().map(|time| quantity.reference.at(*time, &answer.turns, &mut from)).collect();
    let thinned = |end: f64, value: &dyn Fn(usize) -> f64| {
        let mut thin = Thin::new(COLUMNS);
        for (row, time) in contest.times.iter().enumerate().take_while(|(_, time)| **time <= end) {
            thin.push(*time, value(row));
        }
        thin.points()
    };
    let curve = |role: Role, end: f64, value: &dyn Fn(usize) -> f64| Curve {
        label: String::new(),
        role,
        points: thinned(end, value),
    };
    let cell = |end: f64| {
        let mut curves = vec![curve(Role::Reference, end, &|row| reference[row])];
        let estimates = order.iter().map(|k| (k, &quantity.estimates[*k]));
        curves.extend(estimates.map(|(k, estimate)| curve(Role::Rival(*k), end, &|row| estimate[row])));
        Cell { curves, ..Cell::default() }
    };
    let errors = |end: f64| {
        let estimates = order.iter().map(|k| (k, &quantity.estimates[*k]));
        let error = |estimate: &[f64], row: usize| answer.error(estimate[row], reference[row]);
        let curves = estimates.map(|(k, estimate)| curve(Role::RivalError(*k), end, &|row| error(estimate, row)));
        Cell { curves: curves.collect(), ..Cell::default() }
    };
    let whole = f64::INFINITY;
    [
        Panel {
            y_label: format!("{}{unit}", answer.name),
            title: answer.doc.clone(),
            cells: vec![cell(whole), cell(zoom_end)],
        },
        Panel {
            y_label: format!("error of {}{unit}", answer.name),
            title: format!("against {}", quantity.column),
            cells: vec![errors(whole), errors(zoom_end)],
        },
    ]
}
