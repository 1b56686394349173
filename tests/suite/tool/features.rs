//! Claim: what a method cannot take is said in one place: a refusal, `deadbeat list` and the manual's matrix are made of
//! it. What is not in it is not refused.

use std::fs;
use std::process::Command;

use deadbeat_codegen::internals::method::matrix::{self, Cell};
use deadbeat_codegen::internals::plant::features::{Feature, Limit, When};
use deadbeat_codegen::{Generator, METHODS};

use crate::support::corpus::{root, side_by_side, succeed};
use crate::support::plant::corpus;
use crate::support::truths::names_of;

const OPEN: &str = "<!-- matrix -->\n";
const CLOSE: &str = "<!-- /matrix -->";

/// The manual's chapter holds the matrix; `DEADBEAT_BLESS=1` writes it there.
#[test]
fn the_manual_has_the_matrix() {
    let path = root().join("manual/features.md");
    let page = fs::read_to_string(&path).expect("the chapter").replace("\r\n", "\n");
    let (before, rest) = page.split_once(OPEN).expect("the matrix begins");
    let (_, after) = rest.split_once(CLOSE).expect("the matrix ends");
    let expected = format!("{before}{OPEN}\n{}\n{CLOSE}{after}", matrix::markdown());
    if std::env::var("DEADBEAT_BLESS").is_ok_and(|value| value == "1") {
        fs::write(&path, &expected).expect("the chapter is written");
    }
    let written = fs::read_to_string(&path).expect("the chapter").replace("\r\n", "\n");
    assert_eq!(written, expected, "DEADBEAT_BLESS=1 rewrites manual/features.md");
}

/// A specification that asks for something of its first output or of the target; `None` where a plant's other properties
/// decide whether that can be asked for at all.
fn asking(text: &str, feature: Feature) -> Option<String> {
    let of_output = |keys: &str| {
        let (before, outputs) = text.split_once("[outputs]\n")?;
        let output = outputs.lines().find(|line| line.contains('='))?;
        let asked = match output.split_once("= {") {
            Some((name, rest)) => format!("{name}= {{ {keys},{rest}"),
            None => {
                let (name, value) = output.split_once('=')?;
                format!("{name}= {{ value = {}, {keys} }}", value.split('#').next()?.trim())
            }
        };
        Some(format!("{before}[outputs]\n{}", outputs.replacen(output, &asked, 1)))
    };
    let of_target = |keys: &str| {
        text.contains("[target]\n").then(|| text.replacen("[target]\n", &format!("[target]\n{keys}\n"), 1))
    };
    let has = |key: &str| text.contains(&format!(" {key} = ")) || text.contains(&format!("\n{key} = "));
    if has(feature.key()) {
        return Some(text.to_owned());
    }
    match feature {
        Feature::Gate => of_output("gate = 1e3"),
        Feature::Every => of_output("every = 2"),
        Feature::Age => of_output("age = \"measured\""),
        Feature::Coasted => of_target("coasted = true"),
        Feature::InitAt => of_target("init_at = true"),
        Feature::Ahead | Feature::Wrap | Feature::Counter => None,
    }
}

/// Every specification of the corpus is asked for what it does not ask: refused with the reason of the matrix where that
/// stands for all plants, and not for a method's sake where nothing stands there.
#[test]
fn a_refusal_says_what_the_matrix_says() {
    let users = METHODS.iter().flat_map(|method| names_of(method.name).into_iter().map(move |name| (method, name)));
    let asked = users.flat_map(|(method, name)| Feature::ALL.map(|feature| (method, name.clone(), feature)));
    let jobs: Vec<_> = asked
        .filter_map(|(method, name, feature)| Some((method, feature, asking(&corpus(&name), feature)?, name)))
        .collect();
    let cells = side_by_side(&jobs, |(method, feature, text, name)| {
        let said = Generator::new(text, name).check().render(false);
        let cell = method.cell(*feature);
        match cell {
            Cell::Refused => {
                let always = |limit: &&'static Limit| matches!(limit.when, When::Always);
                let limit = method.against(*feature).find(always).expect("a limit");
                assert!(said.contains(limit.why), "{name} with `{}`:\n{said}", feature.key());
            }
            Cell::Taken => {
                let line = format!("cannot take `{}`", feature.key());
                assert!(!said.contains(&line), "{name} with `{}`:\n{said}", feature.key());
            }
            Cell::Partly => {}
        }
        cell
    });
    let count = |wanted: Cell| cells.iter().filter(|cell| **cell == wanted).count();
    let (refused, taken) = (count(Cell::Refused), count(Cell::Taken));
    assert!(refused > 20 && taken > 100, "{refused} refused, {taken} taken");
}

/// `deadbeat list` prints the matrix, a method's page each of its reasons, and its JSON the same.
#[test]
fn the_list_says_what_stands_against_a_feature() {
    let list = |arguments: &[&str]| succeed(Command::new(env!("CARGO_BIN_EXE_deadbeat")).arg("list").args(arguments));
    assert!(list(&[]).contains(&matrix::text()), "the matrix is in the list");
    for method in METHODS {
        let (page, json) = (list(&[method.name]), list(&[method.name, "--format", "json"]));
        let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
        let whys: Vec<&str> =
            json["cannot"].as_array().expect("a list").iter().filter_map(|limit| limit["why"].as_str()).collect();
        assert_eq!(whys, method.limits.iter().map(|limit| limit.why).collect::<Vec<_>>(), "{}", method.name);
        for limit in method.limits {
            let reason = format!("{}; {}", limit.why, limit.instead);
            let said = page.lines().any(|line| line.contains(limit.feature.key()) && line.ends_with(&reason));
            assert!(said, "{}: `{}`\n{page}", method.name, limit.feature.key());
        }
    }
}
