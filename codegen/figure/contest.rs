//! The figure of a contest: per quantity all estimates with the reference, and their errors below.

use crate::numbers::short;
use crate::replay::compare::{Contest, Quantity};

use super::svg::{Cell, Column, Curve, Entry, Figure, Panel, Role};
use super::thin::Thin;

/// Pixel columns of a panel.
const COLUMNS: usize = 420;
/// The second column shows this share of the recording,
const SHARE_IN_ZOOM: f64 = 0.05;
/// but at least so many rows, and so many times the longest convergence.
const ROWS_IN_ZOOM: usize = 50;
const CONVERGENCES_IN_ZOOM: f64 = 2.0;

/// Draws a contest: all estimates with the reference, their errors, and where the reference moves most.
pub fn of_contest(contest: &Contest) -> Figure {
    let zoom = zoom(contest);
    let mut legend = vec![Entry { name: "reference".into(), role: Role::Reference }];
    let rivals = contest.rivals.iter().enumerate();
    legend.extend(rivals.map(|(k, rival)| Entry { name: rival.name.clone(), role: Role::Rival(k) }));
    let title = if contest.title.is_empty() { contest.log.clone() } else { contest.title.clone() };
    Figure {
        description: format!("{title}. {}.", sentence(contest)),
        subtitle: contest.remarks.join("\n"),
        title,
        x_label: "time [s]".into(),
        legend,
        columns: vec![
            Column { title: "the whole recording".into(), x_range: None },
            Column { title: "where the reference moves most".into(), x_range: Some(zoom) },
        ],
        panels: contest.quantities.iter().flat_map(|quantity| panels(contest, quantity, zoom)).collect(),
    }
}

/// What the second column shows, s: where the first reference goes through the widest range.
fn zoom(contest: &Contest) -> (f64, f64) {
    let times = &contest.times;
    let Some((first, last)) = times.first().copied().zip(times.last().copied()) else { return (0.0, 1.0) };
    let longest = contest.rivals.iter().filter_map(|rival| rival.converged_after).fold(0.0, f64::max);
    let rows = times.get(ROWS_IN_ZOOM).map_or(last - first, |time| time - first);
    let length = (SHARE_IN_ZOOM * (last - first)).max(rows).max(CONVERGENCES_IN_ZOOM * longest).min(last - first);
    let Some(quantity) = contest.quantities.first() else { return (first, first + length) };
    let mut best = (f64::NEG_INFINITY, first);
    let mut from = 0;
    while let Some(start) = times.get(from).copied().filter(|start| start + length <= last) {
        let until = start + length;
        let within = quantity.compared.partition_point(|row| *row < from);
        let rows = quantity.compared[within..].iter().take_while(|row| times[**row] <= until);
        let (low, high) = rows.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), row| {
            let value = quantity.known[*row];
            (low.min(value), high.max(value))
        });
        if high - low > best.0 {
            best = (high - low, start);
        }
        // Half a length further, so that the search takes a time in proportion to the recording.
        from = times.partition_point(|time| *time <= start + length / 2.0).max(from + 1);
    }
    (best.1, best.1 + length)
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
fn panels(contest: &Contest, quantity: &Quantity, zoom: (f64, f64)) -> [Panel; 2] {
    let answer = &quantity.answer;
    let unit = if answer.unit.is_empty() { String::new() } else { format!(" [{}]", answer.unit) };
    let mut order: Vec<usize> = (0..contest.rivals.len()).collect();
    order.sort_by(|a, b| {
        let rms = |k: &usize| quantity.scores[*k].rms.unwrap_or(f64::INFINITY);
        rms(b).total_cmp(&rms(a))
    });
    let reference = &quantity.known;
    let curve = |role: Role, (start, end): (f64, f64), value: &dyn Fn(usize) -> f64| {
        let mut thin = Thin::new(COLUMNS);
        let shown = contest.times.iter().enumerate().filter(|(_, time)| (start..=end).contains(*time));
        shown.for_each(|(row, time)| thin.push(*time, value(row)));
        Curve { label: String::new(), role, points: thin.points() }
    };
    let cell = |span: (f64, f64)| {
        let mut curves = vec![curve(Role::Reference, span, &|row| reference[row])];
        let estimates = order.iter().map(|k| (k, &quantity.estimates[*k]));
        curves.extend(estimates.map(|(k, estimate)| curve(Role::Rival(*k), span, &|row| estimate[row])));
        Cell { curves, ..Cell::default() }
    };
    let errors = |span: (f64, f64)| {
        let estimates = order.iter().map(|k| (k, &quantity.estimates[*k]));
        let error = |estimate: &[f64], row: usize| answer.error(estimate[row], reference[row]);
        let curves = estimates.map(|(k, estimate)| curve(Role::RivalError(*k), span, &|row| error(estimate, row)));
        Cell { curves: curves.collect(), ..Cell::default() }
    };
    let whole = (f64::NEG_INFINITY, f64::INFINITY);
    [
        Panel {
            y_label: format!("{}{unit}", answer.name),
            title: answer.doc.clone(),
            cells: vec![cell(whole), cell(zoom)],
        },
        Panel {
            y_label: format!("error of {}{unit}", answer.name),
            title: format!("against {}", quantity.column),
            cells: vec![errors(whole), errors(zoom)],
        },
    ]
}
