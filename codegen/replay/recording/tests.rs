//! What is read of a recording, and what is said of a wrong one.

use std::io::Read;

use super::rows::LONGEST_ROW;
use super::{Recording, RecordingError};

fn open(text: &[u8]) -> Result<Recording<&[u8]>, RecordingError> {
    Recording::open(text, "r.csv")
}

fn rows(text: &str, names: &[&str]) -> Result<Vec<Vec<f64>>, RecordingError> {
    let mut recording = open(text.as_bytes())?;
    recording.select(names)?;
    let (mut rows, mut row) = (Vec::new(), vec![0.0; names.len()]);
    while recording.next_row(&mut row)? {
        rows.push(row.clone());
    }
    Ok(rows)
}

fn complaint(text: &str, names: &[&str]) -> String {
    rows(text, names).unwrap_err().to_string()
}

#[test]
fn selected_columns_come_in_the_order_of_the_selection() {
    let mut recording = open(b"t,a,b\n1,2,3\n").unwrap();
    assert_eq!(recording.columns(), ["t", "a", "b"]);
    assert_eq!(recording.select(&["b", "t"]).unwrap(), [2, 0]);
    let mut row = [0.0; 2];
    assert!(recording.next_row(&mut row).unwrap());
    assert_eq!((row, recording.line()), ([3.0, 1.0], 2));
    assert!(!recording.next_row(&mut row).unwrap());
    assert!(!recording.next_row(&mut row).unwrap());
}

#[test]
fn the_preamble_is_tolerated() {
    let text = "\u{feff}# rig 3, \"left\n\n  # 1 kHz\r\n t , \"a \"\"x\"\"\" ,b\r\n1,2,3";
    assert_eq!(open(text.as_bytes()).unwrap().columns(), ["t", "a \"x\"", "b"]);
    assert_eq!(rows(text, &["t", "b"]).unwrap(), [[1.0, 3.0]]);
    assert_eq!(complaint(&text.replace('3', "x"), &["b"]), "r.csv:5: column `b`: `x` is not a number");
}

#[test]
fn zero_rows_are_not_an_error() {
    assert!(rows("t,a", &["t"]).unwrap().is_empty());
    assert!(rows("t,a\r\n\r\n", &["t"]).unwrap().is_empty());
}

#[test]
fn a_header_is_required() {
    assert_eq!(complaint("", &[]), "r.csv: there is no header row");
    assert_eq!(complaint("\n# only\n", &[]), "r.csv: there is no header row");
}

#[test]
fn columns_that_are_not_selected_may_have_any_name() {
    let text = ",t,alt,alt,\n0,1,2,3,\n";
    assert_eq!(rows(text, &["t"]).unwrap(), [[1.0]]);
    assert_eq!(complaint(text, &["alt"]), "r.csv: columns 3 and 4 are both named `alt`");
    let error = open(b"t,\xe9\n").err().unwrap();
    assert_eq!(error.to_string(), "r.csv:1: the name of column 2 is not UTF-8: `\u{fffd}`");
}

#[test]
fn cells_are_separated_by_what_the_header_has() {
    for text in [
        "t;a\n0,5;1,25\n1;\n",
        "t\ta\n0,5\t1,25\n1\t\n",
        "sep=;\nt;a\r\n0.5;1.25\r\n1;\r\n",
        "# t\ta\n0,5\t1,25\n1\t\n",
    ] {
        let rows = rows(text, &["t", "a"]).unwrap();
        assert_eq!(
            (rows[0].as_slice(), rows[1][0], rows[1][1].is_nan()),
            ([0.5, 1.25].as_slice(), 1.0, true),
            "{text}"
        );
    }
    assert_eq!(rows("\"a;b\",t\n1,2\n", &["a;b", "t"]).unwrap(), [[1.0, 2.0]], "a quoted sign separates nothing");
    assert_eq!(complaint("t;a\n1;1.234,5\n", &["a"]), "r.csv:2: column `a`: `1.234,5` is not a number");
    assert_eq!(complaint("t,a\n1,\"1,5\"\n", &["a"]), "r.csv:2: column `a`: `1,5` is not a number");
}

#[test]
fn words_stand_for_missing_samples() {
    let text = "a,b,c,d,e,f,g\nNULL,N/A,-,null,#N/A,None,--\n1,1,1,1,1,1,1\n";
    let rows = rows(text, &["a", "b", "c", "d", "e", "f", "g"]).unwrap();
    assert!(rows.len() == 2 && rows[0].iter().all(|value| value.is_nan()), "{rows:?}");
}

#[test]
fn a_row_of_units_is_no_row() {
    let recording = open("t,q,n\n[ms],rad/s^2,-\n1,2,3\n".as_bytes()).unwrap();
    assert_eq!(recording.header().units, ["[ms]", "rad/s^2", "-"]);
    assert_eq!(rows("t,q\ns,1/s\n1,2\n", &["t", "q"]).unwrap(), [[1.0, 2.0]]);
    assert_eq!(complaint("t,q\n1,two\n", &["q"]), "r.csv:2: column `q`: `two` is not a number");
    assert_eq!(complaint("t,q\ns,rad\nms,deg\n", &["q"]), "r.csv:3: column `q`: `deg` is not a number", "once");
}

#[test]
fn a_comment_may_be_the_header() {
    assert_eq!(rows("# of rig 3\n# t,q\n0,5\n1,6\n", &["t", "q"]).unwrap(), [[0.0, 5.0], [1.0, 6.0]]);
    assert_eq!(complaint("# t\n0,5\n", &["t"]), "r.csv:2: there is no header row: the first row has numbers only");
}

#[test]
fn a_missing_column_lists_the_others_and_suggests_the_nearest() {
    let error = rows("t,theta,omega\n", &["t", "teta"]).unwrap_err();
    assert_eq!(error.to_string(), "r.csv: there is no column `teta`; the columns are `t`, `theta`, `omega`");
    assert_eq!(error.help.as_deref(), Some("did you mean `theta`?"));
    assert_eq!(rows("t,theta\n", &["Theta"]).unwrap_err().help.as_deref(), Some("did you mean `theta`?"));
    assert_eq!(rows("t,theta\n", &["voltage"]).unwrap_err().help, None);
    assert_eq!(rows("t,u [V]\n", &["u"]).unwrap_err().help.as_deref(), Some("did you mean `u [V]`?"));
    assert!(rows("t theta\n1 2\n", &["t"]).unwrap_err().help.unwrap().contains("commas"));
}

#[test]
fn missing_samples_and_special_numbers() {
    let text = "a,b,c,d,e,f\n, NaN ,\"\",nan,inf,-Infinity\n1e3,.5,-0,+2,\" 7 \",1E-300\n";
    let rows = rows(text, &["a", "b", "c", "d", "e", "f"]).unwrap();
    assert!(rows[0][..4].iter().all(|v| v.is_nan()));
    assert_eq!(rows[0][4..], [f64::INFINITY, f64::NEG_INFINITY]);
    assert_eq!(rows[1], [1e3, 0.5, 0.0, 2.0, 7.0, 1e-300]);
}

#[test]
fn a_bad_number_is_named_by_line_and_column() {
    let error = rows("t,theta\n0,1\n1,1.2.3\n", &["theta"]).unwrap_err();
    assert_eq!(error.to_string(), "r.csv:3: column `theta`: `1.2.3` is not a number");
    assert!(error.help.unwrap().starts_with("this is cell 2 of the row"));
    assert_eq!(complaint("t\n1 2\n", &["t"]), "r.csv:2: column `t`: `1 2` is not a number");
    assert_eq!(complaint("t\n# note\n", &["t"]), "r.csv:2: column `t`: `# note` is not a number");
    assert_eq!(complaint("a,b\n1,\"2\n3\"\n", &["b"]), "r.csv:2: column `b`: `2 3` is not a number");
    let long = format!("t\n{}\n", "ä".repeat(500));
    assert_eq!(complaint(&long, &["t"]), format!("r.csv:2: column `t`: `{}…` is not a number", "ä".repeat(24)));
}

#[test]
fn columns_that_are_not_selected_may_hold_anything() {
    assert_eq!(rows("t,note\n1,\"a, b\"\n2,\"x\n\"\"y\"\"\"\n", &["t"]).unwrap(), [[1.0], [2.0]]);
}

#[test]
fn lines_are_counted_through_quotes_blank_lines_and_every_line_end() {
    for end in ["\n", "\r\n"] {
        let text = ["t,note", "1,\"two", "lines\"", "", "  ", "2,b", "x,c"].join(end);
        assert_eq!(complaint(&text, &["t"]), "r.csv:7: column `t`: `x` is not a number");
    }
}

#[test]
fn a_ragged_row_is_named_by_line_and_column() {
    let few = rows("t,a,b\n1,2,3\n1,2\n", &["t"]).unwrap_err();
    assert_eq!(few.to_string(), "r.csv:3: column `b`: the row has 2 cells, the header has 3");
    assert!(few.help.unwrap().starts_with("cell 3 is the first that is missing"));
    let many = rows("t,a\n1,2,5\n", &["t"]).unwrap_err();
    assert_eq!(many.to_string(), "r.csv:2: the row has 3 cells, the header has 2; no column for `5`");
    assert!(many.help.unwrap().starts_with("cell 3 is the first too many"));
    assert_eq!(complaint("t,a\n1\n", &["t"]), "r.csv:2: column `a`: the row has 1 cell, the header has 2");
}

#[test]
fn a_blank_line_in_a_single_column_is_not_guessed_at() {
    assert_eq!(complaint("y\n1\n\n2\n", &["y"]), "r.csv:3: column `y`: a blank line between two samples");
    assert_eq!(rows("y\n1\nnan\n2\n\n\n", &["y"]).unwrap().len(), 3);
}

#[test]
fn invalid_utf_8_is_an_error_in_a_selected_cell() {
    let mut recording = open(b"t,a\n1,2\xff\n").unwrap();
    let error = recording.next_row(&mut [0.0; 2]).unwrap_err();
    assert_eq!(error.to_string(), "r.csv:2: column `a`: `2\u{fffd}` is not UTF-8");
}

#[test]
fn an_open_quote_ends_in_an_error_and_not_in_memory() {
    assert_eq!(complaint("t,a\n1,\"2\n3,4\n", &["t"]), "r.csv:2: a quote is opened and never closed");
    let long = format!("t,a\n0,0\n1,\"2\n{}", "3,4\n".repeat(LONGEST_ROW));
    assert_eq!(complaint(&long, &["t"]), "r.csv:3: a row is longer than 1048576 bytes");
}

#[test]
fn a_source_that_fails_is_reported_with_its_line() {
    struct Broken;
    impl Read for Broken {
        fn read(&mut self, _: &mut [u8]) -> std::io::Result<usize> {
            Err(std::io::Error::other("unplugged"))
        }
    }
    let mut recording = Recording::open(b"t\n1\n".chain(Broken), "-").unwrap();
    assert!(recording.next_row(&mut [0.0]).unwrap());
    assert_eq!(recording.next_row(&mut [0.0]).unwrap_err().to_string(), "-:3: cannot be read: unplugged");
}

#[test]
fn text_behind_a_closing_quote_makes_no_number() {
    assert_eq!(complaint("t,a\n1,\"1\"2\n", &["a"]), "r.csv:2: column `a`: `12\"` is not a number");
    assert_eq!(rows("t,a\n \"1\" , \"2\"\r\n", &["t", "a"]).unwrap(), [[1.0, 2.0]]);
}

#[test]
fn a_source_may_give_its_bytes_one_by_one() {
    struct Dripping<'a>(&'a [u8]);
    impl Read for Dripping<'_> {
        fn read(&mut self, into: &mut [u8]) -> std::io::Result<usize> {
            let count = into.len().min(1);
            self.0.read(&mut into[..count])
        }
    }
    let text = "\u{feff} \"t\" ,\"a, \"\"b\"\"\"\r\n\r\n 1 , \"2\" \r\n3,\"4\"";
    let mut recording = Recording::open(Dripping(text.as_bytes()), "r.csv").unwrap();
    assert_eq!(recording.columns(), ["t", "a, \"b\""]);
    let mut row = [0.0; 2];
    assert!(recording.next_row(&mut row).unwrap());
    assert_eq!((row, recording.line()), ([1.0, 2.0], 3));
    assert!(recording.next_row(&mut row).unwrap());
    assert_eq!((row, recording.line()), ([3.0, 4.0], 4));
    assert!(!recording.next_row(&mut row).unwrap());
}
