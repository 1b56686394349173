//! Claim: names of states, inputs and outputs may have capitals; generated fields have none, recordings are read under
//! either name, and two names that differ by case only are refused.

use std::path::Path;

use deadbeat_codegen::replay::{Recording, Replay, Signals};
use deadbeat_codegen::{Generator, Language};

const CYLINDER: &str = "deadbeat = 1\nname = 'cylinder'\n[states]\nT = { derivative = '-0.5*T + 2*F' }\n\
    P1 = { derivative = 'T - sin(P1)' }\n[inputs]\nF = { hold = 'zero' }\n[outputs]\n\
    P1 = { value = 'P1', noise = 1e-3 }\n[observer.window]\nwindow = 0.2\n[target]\nsample_time = 0.01\n\
    scalar = 'f64'\n";

#[test]
fn capitals_are_taken() {
    let generator = Generator::new(CYLINDER, "cylinder.toml");
    let generated = generator.design().unwrap_or_else(|report| panic!("{}", report.render(false)));
    let fields: Vec<&str> = generated.program.estimates.iter().map(|(field, _)| field.name.as_str()).collect();
    assert_eq!(fields[..2], ["cap_t", "p1"], "the time is called `t`");
    assert_eq!(generated.program.inputs[0].name, "f");
    let output = generator.generate().unwrap();
    for file in output
        .files()
        .iter()
        .filter(|file| file.language == Language::C && Path::new(&file.name).extension().is_some_and(|it| it == "h"))
    {
        assert!(file.text.contains("double p1;") && file.text.contains("double f;"), "{}", file.text);
        assert!(file.text.contains("T' = -0.5*T + 2*F"), "equations stand as they are written");
    }
    // At rest where sin(P1) = T and T = 4 F, under the names of either.
    let f = 0.2;
    let (pressure, heat) = ((4.0_f64 * f).asin(), 4.0 * f);
    for head in ["t,P1,F,T", "t,p1,f,cap_t"] {
        let row = |k: i32| format!("{},{pressure},{f},{heat}\n", f64::from(k) * 0.01);
        let rows = (0..60).map(row).collect::<Vec<_>>().concat();
        let recording = Recording::open(std::io::Cursor::new(format!("{head}\n{rows}")), "rest.csv").unwrap();
        let mut replay = Replay::new(&generated, recording, &Signals::default()).unwrap();
        assert!(replay.by_ref().all(|step| step.is_ok()));
        let verdict = replay.verdict();
        let error = verdict.errors("cap_t").and_then(|errors| errors.max).expect("it is compared");
        assert!(error < 1e-9, "{head}: {error}");
    }
    let signals = Signals {
        map: vec![("F".into(), "power".into())],
        reference: vec![("T".into(), "heat".into())],
        ..Signals::default()
    };
    let row = |k: i32| format!("{},{pressure},{f},{heat}\n", f64::from(k) * 0.01);
    let rows = (0..60).map(row).collect::<Vec<_>>().concat();
    let recording = Recording::open(std::io::Cursor::new(format!("t,P1,power,heat\n{rows}")), "rest.csv").unwrap();
    let mut replay = Replay::new(&generated, recording, &signals).unwrap();
    assert!(replay.by_ref().all(|step| step.is_ok()));
    assert!(replay.verdict().errors("cap_t").is_some());
}

#[test]
fn names_that_differ_by_case_are_one_field() {
    for (from, to) in [("P1 = { derivative", "t_ = { derivative"), ("F = {", "p1 = {")] {
        let text = CYLINDER.replace(from, to);
        let report = Generator::new(&text, "cylinder.toml").check();
        assert!(report.has_errors(), "{to}: {}", report.render(false));
    }
    let text = CYLINDER.replace("F = {", "p1 = {");
    let report = Generator::new(&text, "cylinder.toml").check().render(false);
    assert!(report.contains("`P1` and `p1` would be one field, `p1`"), "{report}");
}
