//! A contest as text, JSON and Markdown.

use std::fmt::Write as _;

use crate::numbers::short;

#[cfg(feature = "json")]
use super::super::residual::Residual;
use super::contest::{Contest, Quantity, Rival};
use super::score::Score;

/// The columns behind the specification and its method.
const HEADS: [&str; 7] = ["RMSE", "99 %", "maximum", "lag [s]", "converged [s]", "RAM [bytes]", "operations"];

/// A row behind the specification and its method.
fn cells(rival: &Rival, score: &Score) -> [String; 7] {
    let shown = |value: Option<f64>| value.map_or_else(|| "-".to_owned(), short);
    [
        shown(score.rms),
        shown(score.p99),
        shown(score.max),
        shown(score.lag),
        shown(rival.converged_after.map(in_microseconds)),
        rival.cost.ram_bytes.to_string(),
        rival.cost.flops_worst.to_string(),
    ]
}

/// A time without the digits that the difference of two times has too many.
fn in_microseconds(time: f64) -> f64 {
    (time * 1e6).round() / 1e6
}

/// The quantity with its unit, and its reference.
fn heading(quantity: &Quantity) -> String {
    let unit = &quantity.answer.unit;
    let unit = if unit.is_empty() { String::new() } else { format!(" [{unit}]") };
    format!("`{}`{unit} against `{}`", quantity.answer.name, quantity.column)
}

/// Over which rows the errors are.
fn compared(contest: &Contest, quantity: &Quantity) -> String {
    match (quantity.compared.first(), quantity.compared.last()) {
        (Some(first), Some(last)) => format!(
            "errors over the {} of {} rows that all have converged on (rows {} to {})",
            quantity.compared.len(),
            contest.rows,
            first + 1,
            last + 1
        ),
        _ => {
            let late = contest.rivals.iter().find(|rival| rival.converged_row.is_none());
            let why = late.map_or_else(
                || "the reference is known on none of them".to_owned(),
                |rival| format!("`{}` never does", rival.name),
            );
            format!("nothing to compare: all have converged on none of {} rows; {why}", contest.rows)
        }
    }
}

/// The contest for people.
pub fn text(contest: &Contest) -> String {
    let mut text = String::new();
    if !contest.title.is_empty() {
        let _ = writeln!(text, "{}", contest.title);
    }
    let _ = writeln!(text, "{}", contest.log);
    for remark in &contest.remarks {
        let _ = writeln!(text, "{remark}");
    }
    for quantity in &contest.quantities {
        let _ = write!(text, "\n{}: {}\n\n", heading(quantity), compared(contest, quantity));
        let mut rows = vec![vec![String::new(), "method".to_owned()]];
        rows[0].extend(HEADS.map(str::to_owned));
        for (rival, score) in contest.rivals.iter().zip(&quantity.scores) {
            let mut row = vec![rival.name.clone(), rival.method.to_owned()];
            row.extend(cells(rival, score));
            rows.push(row);
        }
        text += &aligned(&rows);
    }
    let residuals = contest.rivals.iter().flat_map(|rival| rival.residuals.iter().map(move |it| (rival, it)));
    for (place, (rival, residual)) in residuals.enumerate() {
        let _ = writeln!(text, "{}{}: {}", if place == 0 { "\n" } else { "" }, rival.name, residual.shown());
    }
    text
}

/// Words to the left, numbers to the right.
fn aligned(rows: &[Vec<String>]) -> String {
    let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
    let mut text = String::new();
    for row in rows {
        let cell = |(column, cell): (usize, &String)| {
            let width = width(column);
            if column < 2 { format!("{cell:<width$}") } else { format!("{cell:>width$}") }
        };
        let line: Vec<String> = row.iter().enumerate().map(cell).collect();
        let _ = writeln!(text, "{}", line.join("  ").trim_end());
    }
    text
}

/// The contest for a page.
pub fn markdown(contest: &Contest) -> String {
    let title = if contest.title.is_empty() { &contest.log } else { &contest.title };
    let mut text = format!("**{title}**\n");
    for quantity in &contest.quantities {
        let _ = write!(text, "\n{}; {}.\n\n", heading(quantity), compared(contest, quantity));
        let _ = writeln!(text, "| specification | method | {} |", HEADS.join(" | "));
        let _ = writeln!(text, "|---|---|{}", "---|".repeat(HEADS.len()));
        for (rival, score) in contest.rivals.iter().zip(&quantity.scores) {
            let row = cells(rival, score).join(" | ");
            let _ = writeln!(text, "| `{}` | `{}` | {row} |", rival.name, rival.method);
        }
    }
    text
}

/// The contest for machines, in SI units; the keys are those of the manual.
#[cfg(feature = "json")]
pub fn json(contest: &Contest) -> serde_json::Value {
    let states = contest.quantities.iter().map(|quantity| quantity_json(contest, quantity));
    serde_json::json!({
        "title": contest.title,
        "log": contest.log,
        "rows": contest.rows,
        "remarks": contest.remarks,
        "states": states.collect::<Vec<_>>(),
    })
}

#[cfg(feature = "json")]
fn quantity_json(contest: &Contest, quantity: &Quantity) -> serde_json::Value {
    let rows = contest.rivals.iter().zip(&quantity.scores).map(|(rival, score)| {
        serde_json::json!({
            "specification": rival.name,
            "file": rival.file,
            "method": rival.method,
            "rms": score.rms,
            "p99": score.p99,
            "max": score.max,
            "lag": score.lag,
            "converged_after": rival.converged_after,
            "converged_row": rival.converged_row.map(|row| row + 1),
            "ram_bytes": rival.cost.ram_bytes,
            "operations": rival.cost.flops_worst,
            "beyond_bound": score.beyond,
            "residuals": rival.residuals.iter().map(Residual::to_json).collect::<Vec<_>>(),
        })
    });
    let compared = &quantity.compared;
    serde_json::json!({
        "state": quantity.answer.name,
        "unit": quantity.answer.unit,
        "reference": quantity.column,
        "compared_rows": compared.len(),
        "first_compared_row": compared.first().map(|row| row + 1),
        "last_compared_row": compared.last().map(|row| row + 1),
        "specifications": rows.collect::<Vec<_>>(),
    })
}
