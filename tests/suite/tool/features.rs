//! Claim: what a method cannot take is said in one place: a refusal, `deadbeat list` and the manual's matrix are made of
//! it. What is not in it is not refused.

use std::fs;
use std::process::Command;

use deadbeat_codegen::internals::method::matrix::{self, Cell};
use deadbeat_codegen::internals::method::read;
use deadbeat_codegen::{Feature, Generator, Limit, METHODS, Plant, Settings, Source};

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
    let of_observer = |keys: &str| {
        let (before, table) = text.split_once("[observer.")?;
        let (method, rest) = table.split_once("]\n")?;
        Some(format!("{before}[observer.{method}]\n{keys}\n{rest}"))
    };
    let value_of = |key: &str| {
        let line = text.lines().find_map(|line| line.strip_prefix(key)?.trim_start().strip_prefix('='))?;
        Some(line.split('#').next().unwrap_or(line).trim().to_owned())
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
        Feature::Delay => of_output(&format!("delay = {}", value_of("sample_time")?)),
        Feature::Outputs => {
            let state = text.split_once("[states]\n")?.1.split_once(" = ")?.0;
            Some(text.replacen("[outputs]\n", &format!("[outputs]\nsecond = {{ value = '{state}' }}\n"), 1))
        }
        Feature::LeftOut => of_observer("missing = \"left-out\""),
        Feature::Windows => match value_of("window") {
            None => of_observer("window = [1, 2]"),
            Some(one) if one.starts_with('[') => Some(text.to_owned()),
            Some(one) => Some(text.replacen(&format!("\nwindow = {one}"), &format!("\nwindow = [{one}]"), 1)),
        },
        Feature::Ahead | Feature::Wrap | Feature::Counter | Feature::Missing => None,
    }
}

/// Whether a text's plant can be asked that at all, whatever its method: a late output, for example, is in no nonlinear
/// term.
fn is_plant(text: &str) -> bool {
    let source = Source { name: "asked.toml".into(), text: text.into() };
    read(source, Settings::default()).map_or(true, |(spec, _)| Plant::new(&spec).is_ok())
}

/// Every specification of the corpus is asked for what it does not ask: refused with the reason of the matrix where that
/// stands for all plants, and not for a method's sake where nothing stands there.
#[test]
fn a_refusal_says_what_the_matrix_says() {
    let users = METHODS.iter().flat_map(|method| names_of(method.name).into_iter().map(move |name| (method, name)));
    let asked = users.flat_map(|(method, name)| Feature::ALL.map(|feature| (method, name.clone(), feature)));
    let jobs: Vec<_> = asked
        .filter_map(|(method, name, feature)| Some((method, feature, asking(&corpus(&name), feature)?, name)))
        .filter(|(_, _, text, _)| is_plant(text))
        .collect();
    let cells = side_by_side(&jobs, |(method, feature, text, name)| {
        let said = Generator::new(text, name).check().render(false);
        let cell = method.cell(*feature);
        match cell {
            Cell::Refused => {
                let always = |limit: &&'static Limit| limit.words().is_none();
                let limit = method.against(*feature).find(always).expect("a limit");
                assert!(said.contains(limit.why), "{name} with `{}`:\n{said}", feature.key());
            }
            Cell::Taken => {
                let line = format!("cannot take {}", feature.words());
                assert!(!said.contains(&line), "{name} with `{}`:\n{said}", feature.key());
            }
            Cell::Partly => {}
        }
        cell
    });
    let count = |wanted: Cell| cells.iter().filter(|cell| **cell == wanted).count();
    let (refused, taken) = (count(Cell::Refused), count(Cell::Taken));
    assert!(refused > 100 && taken > 150, "{refused} refused, {taken} taken");
}

/// `deadbeat list` prints the matrix, a method's page each of its reasons, and its JSON the same.
#[test]
fn the_list_says_what_stands_against_a_feature() {
    let list = |arguments: &[&str]| succeed(Command::new(env!("CARGO_BIN_EXE_deadbeat")).arg("list").args(arguments));
    let all = list(&[]);
    let rows: Vec<Vec<&str>> = all.lines().map(|line| line.split_whitespace().collect()).collect();
    assert!(rows.contains(&Feature::ALL.map(Feature::key).to_vec()), "{all}");
    for method in METHODS {
        let word = |feature| match method.cell(feature) {
            Cell::Taken => "yes",
            Cell::Partly => "partly",
            Cell::Refused => "-",
        };
        let row: Vec<&str> = std::iter::once(method.name).chain(Feature::ALL.map(word)).collect();
        assert!(rows.contains(&row), "{row:?} is in the list\n{all}");
        let line = all.lines().find(|line| line.split_whitespace().eq(row.iter().copied())).expect("the row");
        assert!(line.chars().count() <= 120, "{line}");
        let (page, json) = (list(&[method.name]), list(&[method.name, "--format", "json"]));
        let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
        let whys: Vec<&str> =
            json["cannot"].as_array().expect("a list").iter().filter_map(|limit| limit["why"].as_str()).collect();
        assert_eq!(whys, method.limits.iter().map(|limit| limit.why).collect::<Vec<_>>(), "{}", method.name);
        for limit in method.limits {
            let reason = format!("{}; {}", limit.why, limit.instead);
            let said = page.lines().any(|line| line.contains(limit.feature.words()) && line.ends_with(&reason));
            assert!(said, "{}: `{}`\n{page}", method.name, limit.feature.key());
        }
    }
}
