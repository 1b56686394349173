//! Claim: what the README quotes is what the tool does: its specification is accepted and gives the header
//! that is quoted, its mistake gives the message that is quoted, and the C is that of `generated/c/`.

use std::fs;
use std::path::Path;

use deadbeat_codegen::Generator;

fn read(path: &str) -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(path)).expect(path).replace("\r\n", "\n")
}

/// The block of a language that begins with some text.
fn block(language: &str, start: &str) -> String {
    let readme = read("README.md");
    let fence = format!("```{language}\n");
    let mut blocks = readme.split(&fence).skip(1).filter_map(|rest| rest.split("\n```").next());
    blocks.find(|text| text.starts_with(start)).unwrap_or_else(|| panic!("no {language} block `{start}`")).to_owned()
}

/// Every line of a quotation stands in a text, in this order; `...` leaves some out.
fn assert_quoted(quotation: &str, text: &str) {
    let mut lines = text.lines().map(|line| line.trim_start_matches([' ', '*']).trim_end());
    for line in quotation.lines().map(str::trim).filter(|line| !line.is_empty() && *line != "...") {
        assert!(
            lines.any(|found| found == line),
            "`{line}` is not in the generated file, or not behind the line before"
        );
    }
}

#[test]
fn the_specification_gives_the_quoted_header() {
    let generated = Generator::new(&block("toml", "deadbeat = 1"), "pendulum.toml").generate();
    let output = generated.unwrap_or_else(|report| panic!("{}", report.render(false)));
    let header = output.files().iter().find(|file| file.name == "pendulum.h").expect("a header");
    assert_quoted(&block("text", "Converged"), &header.text);
}

#[test]
fn the_specification_has_twenty_lines() {
    let lines = block("toml", "deadbeat = 1").lines().filter(|line| !line.trim().is_empty()).count();
    assert!(lines <= 20, "{lines} lines");
}

#[test]
fn the_mistake_gives_the_quoted_message() {
    let quoted = block("text", "error");
    let mistaken = quoted.lines().find_map(|line| line.strip_prefix("11 | ")).expect("the line with the mistake");
    let right = block("toml", "deadbeat = 1");
    let text: Vec<&str> = right.lines().map(|line| if line.starts_with("omega") { mistaken } else { line }).collect();
    let report = Generator::new(&text.join("\n"), "pendulum.toml").check();
    assert_eq!(report.render(false).trim_end(), quoted.trim_end());
}

#[test]
fn the_c_is_the_generated_one() {
    assert_quoted(&block("c", "for (uint32_t row"), &read("generated/c/pendulum.c"));
}
