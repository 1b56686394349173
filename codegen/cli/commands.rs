//! The commands that do not replay: check, design, generate, verify.

use std::path::PathBuf;

use deadbeat_codegen::{Difference, Generated, Output, Report, specifications};
use serde_json::{Value, json};
use similar::TextDiff;

use super::{Common, End, Failure, Target, one_standard_input, print, read_spec, show};

/// Designs every specification; all or none.
fn designed(specs: &[PathBuf], common: &Common) -> Result<Option<Vec<(Generated, Output)>>, Failure> {
    one_standard_input(specs)?;
    let Some(specs) = found(specs) else { return Ok(None) };
    let mut all = Vec::new();
    let mut wrong = false;
    for path in &specs {
        let read = read_spec(path, common.settings());
        match read.and_then(|generator| Ok((generator.design()?, generator))) {
            Ok((generated, generator)) => {
                show(&generated.report);
                let output = Output::new(&generated, generator.source());
                all.push((generated, output));
            }
            Err(report) => {
                show(&report);
                wrong = true;
            }
        }
    }
    if let Some(twice) = first_double(&all) {
        return Err(Failure::Wrong(format!("two specifications are named `{twice}` and would write the same files")));
    }
    Ok((!wrong).then_some(all))
}

/// The files that arguments stand for; what is wrong with them is shown.
fn found(arguments: &[PathBuf]) -> Option<Vec<PathBuf>> {
    specifications(arguments).inspect_err(show).ok()
}

fn first_double(all: &[(Generated, Output)]) -> Option<&str> {
    let mut names: Vec<&str> = all.iter().map(|(generated, _)| generated.plant.name.as_str()).collect();
    names.sort_unstable();
    names.windows(2).find(|pair| pair[0] == pair[1]).map(|pair| pair[0])
}

/// `deadbeat check`
pub fn check(specs: &[PathBuf], common: &Common) -> Result<End, Failure> {
    one_standard_input(specs)?;
    let Some(specs) = found(specs) else { return Ok(End::Wrong) };
    let mut reports = Vec::new();
    for path in &specs {
        // One that cannot be read says nothing of the others.
        reports.push(match read_spec(path, common.settings()) {
            Ok(generator) => generator.check(),
            Err(unread) => unread,
        });
    }
    if common.json() {
        let all: Vec<Value> =
            reports.iter().flat_map(|r| r.to_json().as_array().cloned().unwrap_or_default()).collect();
        print(&format!("{:#}\n", Value::Array(all)))?;
    } else {
        reports.iter().for_each(show);
        let fine = reports.iter().filter(|r| !r.has_errors()).count();
        print(&format!("{fine} of {} fine\n", reports.len()))?;
    }
    Ok(if reports.iter().any(Report::has_errors) { End::Wrong } else { End::Fine })
}

/// `deadbeat design`
pub fn design(spec: &PathBuf, common: &Common) -> Result<End, Failure> {
    let generated = match read_spec(spec, common.settings())?.design() {
        Ok(generated) => generated,
        Err(report) => {
            show(&report);
            return Ok(End::Wrong);
        }
    };
    show(&generated.report);
    print(&if common.json() { format!("{:#}\n", generated.to_json()) } else { generated.to_text() })?;
    Ok(End::Fine)
}

/// `deadbeat design --at`
pub fn at(spec: &PathBuf, step: usize, common: &Common) -> Result<End, Failure> {
    match read_spec(spec, common.settings())?.at(step) {
        Ok(Ok(moment)) => {
            print(&if common.json() { format!("{:#}\n", moment.to_json()) } else { moment.to_text() })?;
            Ok(End::Fine)
        }
        Ok(Err(why)) => Err(Failure::Misused(why)),
        Err(report) => {
            show(&report);
            Ok(End::Wrong)
        }
    }
}

/// `deadbeat generate`
pub fn generate(specs: &[PathBuf], target: &Target, common: &Common) -> Result<End, Failure> {
    let Some(all) = designed(specs, common)? else { return Ok(End::Wrong) };
    let mut written = Vec::new();
    for (_, output) in all {
        let paths = output.only(&target.languages()).write_to(&target.out);
        written.extend(
            paths.map_err(|error| Failure::Wrong(format!("cannot write into {}: {error}", target.out.display())))?,
        );
    }
    let names: Vec<String> = written.iter().map(|path| path.display().to_string()).collect();
    print(&if common.json() {
        format!("{:#}\n", json!({ "written": names }))
    } else if names.is_empty() {
        "nothing has changed\n".into()
    } else {
        names.iter().fold(String::new(), |text, name| text + "wrote " + name + "\n")
    })?;
    Ok(End::Fine)
}

/// `deadbeat verify`
pub fn verify(specs: &[PathBuf], target: &Target, common: &Common) -> Result<End, Failure> {
    let Some(all) = designed(specs, common)? else { return Ok(End::Wrong) };
    let outputs: Vec<Output> = all.into_iter().map(|(_, output)| output.only(&target.languages())).collect();
    let differences = Output::verify(&outputs, &target.out)
        .map_err(|error| Failure::Wrong(format!("cannot read {}: {error}", target.out.display())))?;
    print(&if common.json() {
        let list: Vec<Value> = differences.iter().map(difference_json).collect();
        format!("{:#}\n", json!({ "differences": list }))
    } else if differences.is_empty() {
        format!("{} is up to date\n", target.out.display())
    } else {
        differences.iter().map(difference_text).collect()
    })?;
    Ok(if differences.is_empty() { End::Fine } else { End::Differs })
}

fn difference_text(difference: &Difference) -> String {
    match difference {
        Difference::Missing(path) => format!("missing: {}\n", path.display()),
        Difference::LeftOver(path) => format!("left over, no specification makes it: {}\n", path.display()),
        Difference::Stale { path, found, wanted } => {
            let path = path.display();
            let diff = TextDiff::from_lines(found, wanted);
            let unified =
                diff.unified_diff().header(&format!("{path} (on disk)"), &format!("{path} (generated)")).to_string();
            format!("stale: {path}\n{unified}")
        }
    }
}

fn difference_json(difference: &Difference) -> Value {
    let (kind, path) = match difference {
        Difference::Missing(path) => ("missing", path),
        Difference::LeftOver(path) => ("left over", path),
        Difference::Stale { path, .. } => ("stale", path),
    };
    json!({ "kind": kind, "path": path.display().to_string() })
}
