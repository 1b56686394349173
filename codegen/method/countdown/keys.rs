//! What the table says: the time, one gain law, what follows; still as written.

use std::ops::Range;

use crate::diagnostic::{Diagnostic, codes};
use crate::estimator::corrector::After;
use crate::spec::Quantity;
use crate::spec::reader::Table;

/// Rows of the keys' table that all countdowns share.
pub const TIME: (&str, &str, &str) =
    ("time", "s", "T, a whole number of samples from the first one on: the countdown's end");
/// 003's gains.
pub const EFIMOV_ORLOV: (&str, &str, &str) =
    ("efimov-orlov", "{ L = [n numbers] }", "003 (4): gains L_i (T/(T-t))^i; L_i in 1/s^i, above 0");
/// 004's gains.
pub const HOLLOWAY_KRSTIC: (&str, &str, &str) = (
    "holloway-krstic",
    "{ m, l = [n numbers] }",
    "004 (22), (23): m >= 1, l the coefficients of a stable polynomial, l_i in 1/s^i; all 0 by default",
);
/// One number.
pub const POLES: (&str, &str, &str) = (
    "poles",
    "{ p }",
    "all poles of A - L C at -p/T: L_i = C(n,i) (p/T)^i; the default, with p = 10, or 4n - 8 above 4 states",
);
/// What follows the countdown.
pub const AFTER: (&str, &str, &str) = (
    "after",
    "\"hold\" | \"restart\" | \"handover\"",
    "the last gain stays, the countdown starts again (003 (21)), or a steady Kalman gain takes over",
);
/// Where it ends.
pub const STOP_BEFORE: (&str, &str, &str) =
    ("stop_before", "steps", "the fewest steps left; N/10 by default, N/5 for a restart");
/// 004's way to say it.
pub const MAX_GAIN: (&str, &str, &str) =
    ("max_gain", "1/s^i", "instead of `stop_before`: the largest g_i, as 004 limits them (after Theorem 1)");

/// What the first sample does not show.
pub const INITIAL: (&str, &str, &str) = (
    "initial",
    "[numbers]",
    "the states that the first sample does not show, in order; their own `initial` by default",
);

/// A gain law as written.
#[derive(Clone, Debug)]
pub enum LawKeys {
    /// 003.
    EfimovOrlov(Vec<Quantity>, Range<usize>),
    /// 004.
    HollowayKrstic(usize, Option<Vec<Quantity>>, Range<usize>),
    /// All poles at -p/T.
    Poles(Quantity),
}

/// What all countdowns read.
#[derive(Clone, Debug)]
pub struct Keys {
    /// T.
    pub time: Quantity,
    /// The law; `None` for the default.
    pub law: Option<LawKeys>,
    /// What follows.
    pub after: (After, Range<usize>),
    /// Steps, with their place.
    pub stop_before: Option<(usize, Range<usize>)>,
    /// The largest `g_i`.
    pub max_gain: Option<Quantity>,
}

/// Reads the keys; `handover` says whether there is a gain to hand over to.
pub fn read(table: &mut Table) -> Option<Keys> {
    let time = table.quantity("time");
    if time.is_none() && !table.has("time") {
        table.missing("time", "write `time = …`, the seconds from the first sample to the prescribed time");
    }
    let law = read_law(table);
    let words = [("hold", After::Hold), ("restart", After::Restart), ("handover", After::Handover)];
    let after = (table.choice("after", &words, After::Hold), table.key_span("after"));
    let stop_before = steps(table, "stop_before");
    let max_gain = table.quantity("max_gain");
    if let (Some((_, span)), Some(gain)) = (&stop_before, &max_gain) {
        let message = "`stop_before` and `max_gain` say the same thing twice";
        let error = Diagnostic::error(codes::BAD_COMBINATION, gain.span(), message);
        table.report(error.context(span.clone(), "the other").help("leave one of them out"));
    }
    Some(Keys { time: time?, law: law?, after, stop_before, max_gain })
}

/// The one law of a table; `Some(None)` where there is none.
fn read_law(table: &mut Table) -> Option<Option<LawKeys>> {
    let mut laws = Vec::new();
    if let Some(mut keys) = table.table("efimov-orlov", "`efimov-orlov`") {
        let list = keys.list("L");
        if list.is_none() && !keys.has("L") {
            keys.missing("L", "write `L = [..]`, one gain per state");
        }
        keys.finish();
        let span = table.key_span("efimov-orlov");
        laws.push((list.map(|(list, place)| LawKeys::EfimovOrlov(list, place)), span));
    }
    if let Some(mut keys) = table.table("holloway-krstic", "`holloway-krstic`") {
        let m = steps(&mut keys, "m");
        if m.is_none() && !keys.has("m") {
            keys.missing("m", "write `m = 1`, or more for a faster decay at the end");
        }
        let l = keys.list("l");
        let span = keys.key_span("l");
        keys.finish();
        let law = m.map(|(m, _)| LawKeys::HollowayKrstic(m, l.map(|(l, _)| l), span));
        laws.push((law, table.key_span("holloway-krstic")));
    }
    if let Some(mut keys) = table.table("poles", "`poles`") {
        let p = keys.quantity("p");
        if p.is_none() && !keys.has("p") {
            keys.missing("p", "write `p = 10`: the poles lie at -p/T");
        }
        keys.finish();
        laws.push((p.map(LawKeys::Poles), table.key_span("poles")));
    }
    if let [(_, first), (_, second), ..] = laws.as_slice() {
        let error = Diagnostic::error(codes::BAD_COMBINATION, second.clone(), "an observer has one gain law");
        table.report(error.context(first.clone(), "the other").help("leave one of them out"));
        return None;
    }
    match laws.pop() {
        Some((law, _)) => law.map(Some),
        None => Some(None),
    }
}

/// A number of steps, if the key is there.
fn steps(table: &mut Table, key: &str) -> Option<(usize, Range<usize>)> {
    let (number, span) = table.whole(key)?;
    match usize::try_from(number.numerator().clone()) {
        Ok(steps @ ..=1_000_000) => Some((steps, span)),
        _ => {
            let message = format!("`{key}` must be a whole number from 0 to 1000000");
            table.report(Diagnostic::error(codes::BAD_NUMBER, span, message));
            None
        }
    }
}
