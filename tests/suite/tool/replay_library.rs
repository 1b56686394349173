//! Claim: who has the library needs no terminal: a recording becomes estimates, errors, a verdict and a picture as data,
//! and what is wrong with it is data too.

use deadbeat_codegen::figure::{Curves, of_contest};
use deadbeat_codegen::program::Status;
use deadbeat_codegen::replay::compare::{Contest, Entrant, report};
use deadbeat_codegen::replay::{Recording, Replay, ReplayError, SignalError, Signals};
use deadbeat_codegen::{Generated, Generator};

/// A cart of constant speed, observed over two samples by one method or another.
fn cart(observer: &str) -> Generated {
    let spec = format!(
        "deadbeat = 1\nname = 'cart'\n[states]\nx = {{ unit = 'm', derivative = 'v' }}\n\
         v = {{ unit = 'm/s', derivative = '0' }}\n[outputs]\nx = {{ value = 'x' }}\n{observer}\n\
         [target]\nsample_time = 0.1\nscalar = 'f64'\n"
    );
    Generator::new(&spec, "cart.toml").design().unwrap_or_else(|report| panic!("{report:?}"))
}

const WINDOW: &str = "[observer.window]\nwindow = 0.2";

/// A cart that starts at 1 m with 2 m/s; its speed stands in a column of another name.
fn recording(rows: u32) -> String {
    let row = |k: u32| format!("{:.1},{:.1},2\n", f64::from(k) * 0.1, 1.0 + f64::from(k) * 0.2);
    (0..rows).map(row).fold("t,x,truth\n".into(), |text, row| text + &row)
}

fn speed_is_truth() -> Signals {
    Signals { reference: vec![("v".into(), "truth".into())], ..Signals::default() }
}

/// Row by row the estimates, at the end the errors and the SVG.
#[test]
fn a_recording_becomes_estimates_a_verdict_and_a_picture() {
    let generated = cart(WINDOW);
    let text = recording(50);
    let log = Recording::open(text.as_bytes(), "cart.csv").unwrap();
    let mut replay = Replay::new(&generated, log, &speed_is_truth()).unwrap();
    let mut curves = Curves::new(&replay);
    let speed = replay.interface().answers.iter().position(|answer| answer.name == "v").unwrap();
    let mut statuses = Vec::new();
    for (row, step) in replay.by_ref().enumerate() {
        let step = step.unwrap();
        statuses.push(step.sample.status);
        let error = (step.sample.estimate[speed] - 2.0).abs();
        assert_eq!(error < 1e-12, row >= 2, "row {row}: off by {error}");
        curves.add(&step);
    }
    assert_eq!(statuses[..3], [Status::Converging, Status::Converging, Status::Converged]);

    let verdict = replay.verdict();
    assert_eq!((verdict.rows, verdict.converged_rows, verdict.converged_from), (50, 48, Some(3)));
    let errors = verdict.errors("v").unwrap();
    assert_eq!(errors.rows, 48);
    assert!(errors.rms().unwrap() <= errors.max.unwrap() && errors.max.unwrap() < 1e-12);
    assert_eq!(verdict.to_json()["errors"]["v"]["max"], errors.max.unwrap());
    let svg = curves.figure(&verdict).to_string();
    assert!(svg.starts_with("<svg") && svg.contains("error of v [m/s]") && svg.trim_end().ends_with("</svg>"));
}

/// Two steps over one recording are scored over the same rows.
#[test]
fn a_contest_is_held_in_memory() {
    let signals = speed_is_truth();
    let entrant =
        |file: &str, window: &str| Entrant::new(file, cart(&format!("[observer.window]\nwindow = {window}")), &signals);
    let entrants = vec![entrant("short.toml", "0.2").unwrap(), entrant("long.toml", "1").unwrap()];
    let text = recording(50);
    let log = Recording::open(text.as_bytes(), "cart.csv").unwrap();
    let mut told = 0;
    let contest = Contest::hold(entrants, &signals, log, None, &mut |rows| told = rows).unwrap();
    assert_eq!((told, contest.rows), (50, 50));
    assert_eq!(contest.rivals.iter().map(|rival| rival.converged_row).collect::<Vec<_>>(), [Some(2), Some(10)]);
    let speed = &contest.quantities[0];
    assert_eq!(speed.compared, (10..50).collect::<Vec<_>>());
    assert!(speed.scores.iter().all(|score| score.max.unwrap() < 1e-12));
    assert!(report::markdown(&contest).contains("short.toml"));
    assert!(of_contest(&contest).to_string().contains("long.toml"));
}

/// A mistake names what it is about; behind it there are no more rows.
#[test]
fn mistakes_are_data() {
    let generated = cart(WINDOW);
    let replay = |text: &'static str, signals: &Signals| {
        Replay::new(&generated, Recording::open(text.as_bytes(), "cart.csv").unwrap(), signals)
    };
    let unknown = Signals { reference: vec![("w".into(), "truth".into())], ..Signals::default() };
    let wrong = replay("t,x\n", &unknown).err().unwrap();
    assert_eq!(wrong, ReplayError::Signals(SignalError::NotEstimated { name: "w".into(), of: None }));

    let Some(ReplayError::Recording(wrong)) = replay("t,y\n", &Signals::default()).err() else { panic!("no `x`") };
    assert_eq!(wrong.message, "there is no column `x`; the columns are `t`, `y`");

    let steps: Vec<_> = replay("t,x\n0,1\n0.1,two\n0.2,3\n", &Signals::default()).unwrap().collect();
    let [Ok(_), Err(wrong)] = steps.as_slice() else { panic!("a row and a mistake") };
    assert_eq!((wrong.line, wrong.column.as_deref()), (Some(3), Some("x")));

    let steps: Vec<_> = replay("t,x\n", &Signals::default()).unwrap().collect();
    let [Err(wrong)] = steps.as_slice() else { panic!("a mistake") };
    assert_eq!(wrong.to_string(), "cart.csv: the recording has no rows");
}
