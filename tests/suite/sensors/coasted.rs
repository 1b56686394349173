//! Claim: with `coasted = true` every shape of observer says how many calls ago a sample was accepted: 0 in the call of
//! one, one more in each call without, from the start on.

use deadbeat_codegen::Generator;
use deadbeat_codegen::program::Kind;
use deadbeat_codegen::program::interp::Interpreter;

const OBSERVERS: [&str; 7] = [
    "[observer.window]\nwindow = 0.4",
    "[observer.window]\nwindow = 0.4\nmissing = 'left-out'",
    "[observer.single-delay]\nwindow = 0.4",
    "[observer.impulsive]\nwindow = 0.4",
    "[observer.impulsive]\nwindow = 0.4\nmeasured_every = 2",
    "[observer.prescribed-time]\ntime = 0.4",
    "[observer.parameters]\nwindow = 0.4",
];

fn text(observer: &str) -> String {
    let (force, unknowns) =
        if observer.contains("parameters") { (" + load*t", "[unknowns]\nload = {}\n") } else { ("", "") };
    format!(
        "deadbeat = 1\nname = 'm'\n[states]\nq = {{ derivative = 'v' }}\nv = {{ derivative = '-4*q{force}' }}\n\
         [outputs]\nq = {{ value = 'q' }}\n{unknowns}{observer}\n[target]\nsample_time = 0.02\nscalar = 'f64'\ncoasted = true\n"
    )
}

#[test]
fn calls_since_the_newest_accepted_sample_are_counted() {
    for observer in OBSERVERS {
        let generated =
            Generator::new(&text(observer), "m.toml").design().unwrap_or_else(|r| panic!("{}", r.render(false)));
        let fields = &generated.program.estimates;
        let place = fields.iter().position(|(field, _)| field.name == "coasted").expect("a field of the estimate");
        assert_eq!(fields[place].0.kind, Kind::Index);
        let every = if observer.contains("measured_every") { 2 } else { 1 };
        let mut interpreter = Interpreter::new(&generated.program);
        let (mut estimate, mut expected) = (vec![0.0; fields.len()], 0);
        for call in 0..90 {
            let missing = call < 3 || (40..44).contains(&call) || call == 60;
            let sample = if missing { f64::NAN } else { (0.04 * f64::from(call)).cos() };
            interpreter.step(&[sample], &[], &mut estimate);
            expected = if !missing && call % every == 0 { 0 } else { expected + 1 };
            assert_eq!(estimate[place], f64::from(expected), "{observer}, call {call}");
        }
    }
}
