//! What the emitters promise of each other and of the texts that they are given.

use super::{Door, Header, c_header, c_source, rust, rust_tokens};
use crate::program::builder::Builder;
use crate::program::{Field, Function, Kind, Program, Scalar, Status};

/// A Program with all that a file can hold, and texts that try to leave their place.
fn program() -> Program {
    let field = |name: &str, doc: &str| Field {
        name: name.to_owned(),
        unit: "rad_s".to_owned(),
        doc: doc.to_owned(),
        kind: Kind::Float,
    };
    let mut b = Builder::new("arm", Scalar::F32, 0.125);
    let y = b.measurement(field("theta", "*/ int hidden; /*"));
    let u = b.input(field("torque", ""));
    let ring = b.ring("ring", "by slot ??/", 3, 0.0);
    let newest = b.index_cell("newest", "", 2);
    let rows = vec![vec![0.5, 3.140_625], vec![1e20_f32.into(), 123_456.5], vec![-0.25, 2.0]];
    let table = b.table("H", "*/ a table", vec!["first".to_owned(), "second */".to_owned()], rows);
    b.section("the sample */");
    let (y, u) = (b.read_measurement(y), b.read_input(u));
    let slot = b.read(newest);
    let slot = b.advance(slot, 3);
    b.set(newest, slot);
    b.set_ring(ring, slot, y);
    b.section("the window");
    let sine = b.call(Function::Sin, &[u]);
    let ends = b.loop_over(table, &[sine, slot], |b, carried| {
        let (first, second, x) = (b.gain(0), b.gain(1), b.read_ring(ring, carried[1]));
        let (p, q) = (b.mul(first, x), b.mul(second, x));
        let sum = b.add(p, q);
        vec![b.add(carried[0], sum), b.retreat(carried[1], 3)]
    });
    b.estimate(field("theta", "[angle]"), ends[0]);
    let (good, yes, no) = (b.in_range(y, -1.0, 2.0), b.status(Status::Converged), b.status(Status::Coasting));
    let status = b.select(good, yes, no);
    b.report(status);
    b.finish()
}

fn header() -> Header {
    Header { title: "Observer of arm_1 */".to_owned(), lines: vec!["a * b */ c".to_owned(), "```".to_owned()] }
}

/// The temporaries that a text defines or assigns, in order.
fn temporaries(text: &str) -> Vec<String> {
    let assigned = text.lines().filter_map(|line| line.split_once(" = ")).map(|(left, _)| left);
    let names = assigned.filter_map(|left| left.split(&[' ', ':', '.', '>'][..]).find(|word| is_temporary(word)));
    names.map(str::to_owned).collect()
}

/// `t0`, `t1`, …
fn is_temporary(word: &str) -> bool {
    word.strip_prefix('t').is_some_and(|digits| !digits.is_empty() && digits.chars().all(|c| c.is_ascii_digit()))
}

/// Claim: both languages define and assign the same temporaries in the same order.
#[test]
fn languages_agree_line_for_line() {
    let rust = temporaries(&rust(&program(), &header(), Door::File));
    let c = c_source(&program(), &header());
    let step = c.find("void arm_step").unwrap_or(0);
    assert!(rust.len() > 12, "{rust:?}");
    assert_eq!(rust, temporaries(&c[step..]));
}

/// Claim: the tokens for a macro are the items of the file.
#[test]
fn tokens_are_the_file() {
    let print = |file: syn::Result<syn::File>| prettyplease::unparse(&file.expect("items"));
    let file = print(syn::parse_file(&rust(&program(), &header(), Door::Include)));
    assert_eq!(print(syn::parse2(rust_tokens(&program()))), file);
}

/// Claim: a file that is included has no inner documentation or attribute.
#[test]
fn included_files_can_be_included() {
    let text = rust(&program(), &header(), Door::Include);
    assert!(!text.contains("//!") && !text.contains("#!["), "{text}");
}

/// Claim: no text of the specification leaves its comment.
#[test]
fn comments_end_where_they_should() {
    for text in [c_header(&program(), &header()), c_source(&program(), &header())] {
        assert_eq!(text.matches("/*").count(), text.matches("*/").count());
        assert!(!text.contains("??/"));
        for comment in text.split("/*").skip(1) {
            assert_eq!(comment.matches("*/").count(), 1, "{comment}");
        }
    }
}

/// Claim: a table may have a name that the generator uses itself.
#[test]
fn names_are_kept_apart() {
    let c = c_source(&program(), &header());
    assert!(c.contains("ARM_H_2[3][2]"), "{c}");
    assert!(rust(&program(), &header(), Door::File).contains("static H_2: [[f32; 2]; 3]"));
}
