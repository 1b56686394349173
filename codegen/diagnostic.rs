//! A user's mistake as data: a code, the place, a measured number, a way out.
//!
//! Knows texts, places in them, numbers. Never knows what a rule is about, nor the terminal.
//!
//! In: what a stage found. Out: text for people ([`Report::render`]), JSON for machines
//! ([`Report::to_json`]). All mistakes of one stage travel together; a stage with a mistake has no
//! output, so nothing half-checked reaches the next.

pub(crate) mod letters;

use std::ops::Range;
use std::sync::Arc;

use annotate_snippets::renderer::DecorStyle;
use annotate_snippets::{Annotation, AnnotationKind, Group, Level as SnippetLevel, Origin, Renderer, Snippet};
use serde::Serialize;

/// The specification's text and the name under which messages mention it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Source {
    /// As the user wrote it: a path, or `-`; empty for a mistake that is in no file.
    pub name: Arc<str>,
    /// The whole text; empty where a file could not be read, and messages then show its name alone.
    pub text: Arc<str>,
}

impl Source {
    /// Line and column, both from 1, of a byte offset; the column counts characters.
    pub fn position(&self, offset: usize) -> (usize, usize) {
        let before = &self.text[..self.floor(offset)];
        let line = before.matches('\n').count() + 1;
        let column = before.rsplit('\n').next().unwrap_or("").chars().count() + 1;
        (line, column)
    }

    /// The nearest character boundary at or before `offset`.
    fn floor(&self, offset: usize) -> usize {
        floor_boundary(&self.text, offset)
    }

    /// The span with both ends inside the text and on character boundaries.
    fn clamp(&self, span: &Range<usize>) -> Range<usize> {
        let start = self.floor(span.start);
        start..self.floor(span.end).max(start)
    }
}

/// The nearest character boundary of a text at or before an offset.
pub fn floor_boundary(text: &str, offset: usize) -> usize {
    (0..=offset.min(text.len())).rev().find(|at| text.is_char_boundary(*at)).unwrap_or(0)
}

/// How bad it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Level {
    /// Nothing is generated.
    Error,
    /// Something is generated that the user should look at.
    Warning,
}

/// A stretch of the specification and what to say of it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Label {
    /// Bytes of the whole file.
    pub span: Range<usize>,
    /// Behind the carets; may be empty.
    pub text: String,
}

/// A replacement that mends the mistake.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Patch {
    /// Bytes of the whole file.
    pub span: Range<usize>,
    /// What should stand there.
    pub text: String,
}

/// One mistake or warning.
#[derive(Clone, Debug, PartialEq)]
pub struct Diagnostic {
    /// `DB` and four digits; the table is [`codes`].
    pub code: &'static str,
    /// Error or warning.
    pub level: Level,
    /// One line, lower case, names in backticks.
    pub message: String,
    /// The first is the place, the others are context.
    pub labels: Vec<Label>,
    /// What was measured, in the words of the message (a rank, a singular value, a number of samples).
    pub measured: Option<f64>,
    /// What to do.
    pub help: Option<String>,
    /// The help as an edit.
    pub patch: Option<Patch>,
}

impl Diagnostic {
    /// An error at a place.
    pub fn error(code: &'static str, span: Range<usize>, message: impl Into<String>) -> Self {
        Self {
            code,
            level: Level::Error,
            message: message.into(),
            labels: vec![Label { span, text: String::new() }],
            measured: None,
            help: None,
            patch: None,
        }
    }

    /// A warning at a place.
    pub fn warning(code: &'static str, span: Range<usize>, message: impl Into<String>) -> Self {
        Self { level: Level::Warning, ..Self::error(code, span, message) }
    }

    /// Says something behind the carets.
    #[must_use]
    pub fn label(mut self, text: impl Into<String>) -> Self {
        self.labels[0].text = text.into();
        self
    }

    /// Points at a second place.
    #[must_use]
    pub fn context(mut self, span: Range<usize>, text: impl Into<String>) -> Self {
        self.labels.push(Label { span, text: text.into() });
        self
    }

    /// Adds the number that was measured.
    #[must_use]
    pub fn measured(mut self, value: f64) -> Self {
        self.measured = Some(value);
        self
    }

    /// Says what to do.
    #[must_use]
    pub fn help(mut self, text: impl Into<String>) -> Self {
        self.help = Some(text.into());
        self
    }

    /// Says what to do as an edit.
    #[must_use]
    pub fn patch(mut self, span: Range<usize>, text: impl Into<String>) -> Self {
        self.patch = Some(Patch { span, text: text.into() });
        self
    }
}

/// Everything that one stage, or all of them, had to say about one specification.
#[derive(Clone, Debug, PartialEq)]
pub struct Report {
    /// What the spans point into.
    pub source: Source,
    /// In the order of their places in the file.
    pub diagnostics: Vec<Diagnostic>,
    /// What is said of further files, where several were asked for at once.
    pub others: Vec<Report>,
}

impl Report {
    /// Sorted by place; equal entries are said once.
    pub fn new(source: Source, mut diagnostics: Vec<Diagnostic>) -> Self {
        diagnostics.sort_by_key(|d| (d.labels[0].span.start, d.code));
        diagnostics.dedup();
        Self { source, diagnostics, others: vec![] }
    }

    /// An error of a whole file or folder, by its name, or of a request, without one.
    pub(crate) fn without_place(name: &str, code: &'static str, message: String, help: &str) -> Self {
        let source = Source { name: name.into(), text: "".into() };
        Self::new(source, vec![Diagnostic::error(code, 0..0, message).help(help)])
    }

    /// Several reports as one; nothing when there are none.
    pub(crate) fn all(reports: Vec<Self>) -> Option<Self> {
        let mut reports = reports.into_iter();
        let mut first = reports.next()?;
        first.others.extend(reports);
        Some(first)
    }

    /// Whether anything forbids generation.
    pub fn has_errors(&self) -> bool {
        self.diagnostics.iter().any(|d| d.level == Level::Error) || self.others.iter().any(Self::has_errors)
    }

    /// The report as text, with colours when `styled`; empty when there is nothing to say.
    pub fn render(&self, styled: bool) -> String {
        let own = self.diagnostics.iter().map(|diagnostic| self.render_one(diagnostic, styled) + "\n\n");
        own.chain(self.others.iter().map(|other| other.render(styled))).collect()
    }

    fn render_one(&self, diagnostic: &Diagnostic, styled: bool) -> String {
        let level = match diagnostic.level {
            Level::Error => SnippetLevel::ERROR,
            Level::Warning => SnippetLevel::WARNING,
        };
        let title = level.primary_title(&*diagnostic.message).id(diagnostic.code);
        let mut group = if !self.source.text.is_empty() {
            title.element(self.snippet(diagnostic))
        } else if !self.source.name.is_empty() {
            title.element(Origin::path(&*self.source.name))
        } else {
            Group::with_title(title)
        };
        if let Some(help) = &diagnostic.help {
            group = group.element(SnippetLevel::HELP.message(&**help));
        }
        let renderer = if styled { Renderer::styled() } else { Renderer::plain() };
        renderer.decor_style(DecorStyle::Ascii).render(&[group])
    }

    /// The lines that a diagnostic points at.
    fn snippet<'a>(&'a self, diagnostic: &'a Diagnostic) -> Snippet<'a, Annotation<'a>> {
        let mut snippet = Snippet::source(&*self.source.text).path(&*self.source.name).fold(true);
        for (place, label) in diagnostic.labels.iter().enumerate() {
            let kind = if place == 0 { AnnotationKind::Primary } else { AnnotationKind::Context };
            let annotation = kind.span(self.source.clamp(&label.span));
            snippet =
                snippet.annotation(if label.text.is_empty() { annotation } else { annotation.label(&*label.text) });
        }
        snippet
    }

    /// The report for machines: one object per diagnostic, in an array.
    #[cfg(feature = "json")]
    pub fn to_json(&self) -> serde_json::Value {
        self.objects().into()
    }

    #[cfg(feature = "json")]
    fn objects(&self) -> Vec<serde_json::Value> {
        let own = self.diagnostics.iter().map(|d| self.one_to_json(d));
        own.chain(self.others.iter().flat_map(Self::objects)).collect()
    }

    #[cfg(feature = "json")]
    fn one_to_json(&self, diagnostic: &Diagnostic) -> serde_json::Value {
        let (line, column) = self.source.position(diagnostic.labels[0].span.start);
        let patch = diagnostic
            .patch
            .as_ref()
            .map(|p| serde_json::json!({ "start": p.span.start, "end": p.span.end, "text": p.text }));
        serde_json::json!({
            "code": diagnostic.code, "level": diagnostic.level, "message": diagnostic.message,
            "file": &*self.source.name, "line": line, "column": column, "label": diagnostic.labels[0].text,
            "measured": diagnostic.measured, "help": diagnostic.help, "patch": patch,
        })
    }
}

/// What each code stands for; `DB01` the file, `DB02` the plant, `DB03` the design, `DB04` the step, `DB05` what
/// was asked for.
pub mod codes {
    macro_rules! codes {
        ($($name:ident $code:literal $text:literal)*) => {
            $(#[doc = $text] pub const $name: &str = $code;)*
            /// All of them with their meaning.
            pub const ALL: &[(&str, &str)] = &[$(($code, $text)),*];
        };
    }
    codes! {
        SYNTAX "DB0101" "the file is not TOML"
        UNKNOWN_KEY "DB0102" "a key that means nothing here"
        MISSING_KEY "DB0103" "a key that must be there"
        WRONG_TYPE "DB0104" "a value of another type"
        BAD_NAME "DB0105" "a name that Rust or C cannot carry"
        DUPLICATE_NAME "DB0106" "one name for two things"
        BAD_NUMBER "DB0107" "a number outside what can be computed with"
        BAD_CHOICE "DB0108" "a word that is none of the choices"
        BAD_COMBINATION "DB0109" "keys that do not go together"
        EXPRESSION_SYNTAX "DB0201" "an expression that cannot be read"
        UNKNOWN_NAME "DB0202" "a name that is not declared"
        NONLINEAR_STATE "DB0203" "a nonlinearity in a state that is not measured"
        NOT_AFFINE "DB0204" "an unknown or disturbance that does not enter affinely"
        OUTPUT_NOT_LINEAR "DB0205" "an output that is not linear in the states"
        DOMAIN "DB0206" "a constant outside a function's domain"
        TOO_LARGE "DB0207" "an expression or constant too large to expand"
        SHAPE "DB0208" "matrices whose shapes do not fit"
        UNUSED "DB0209" "something declared and not used"
        DELAYED_INJECTION "DB0210" "a nonlinearity in a measurement that arrives late"
        NOT_CONSTANT "DB0211" "a quantity that must be a constant"
        UNITS "DB0212" "units that contradict each other, or are missing"
        HELD_IN_OUTPUT "DB0213" "an input that is held until the sample stands in an output"
        UNOBSERVABLE "DB0301" "a state that the outputs do not show"
        NOT_WHOLE "DB0302" "a time that is not a whole number of samples"
        WINDOW_TOO_SHORT "DB0303" "a window with too few samples"
        DELAY_TOO_LONG "DB0304" "a delay longer than the window"
        METHOD_CANNOT "DB0305" "something that this method does not do"
        UNKNOWN_METHOD "DB0306" "no such observer method"
        PRECISION "DB0307" "constants that do not settle in multiprecision"
        CHECK_FAILED "DB0308" "a design that fails its own check"
        UNPROVED "DB0309" "convergence that is not proved"
        WEAK "DB0310" "an initial error that the promised step has not removed"
        REALIZATION "DB0311" "a realisation that may not run for this plant"
        NOISE "DB0312" "gains that leave more noise than signal"
        WEAK_SAMPLES "DB0313" "a motion that is over before the next sample"
        OUT_OF_RANGE "DB0401" "a constant outside the target's float range"
        TIME_RESOLUTION "DB0402" "time that loses resolution in the target's float"
        WINDOW_TOO_LONG "DB0403" "a window too long to design"
        FLOAT_RESOLUTION "DB0404" "samples that the target's float resolves more coarsely than their noise"
        ROUNDING "DB0405" "rounding in the step that is larger than what the noise does"
        FILE "DB0501" "a file or folder that cannot be read or written"
        REQUEST "DB0502" "a request without a specification, without a folder, or with one name twice"
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every code is used for one thing only.
    #[test]
    fn codes_are_unique() {
        let mut seen: Vec<_> = codes::ALL.iter().map(|(code, _)| code).collect();
        seen.sort();
        seen.dedup();
        assert_eq!(seen.len(), codes::ALL.len());
    }

    /// A report shows the place, the number and the way out.
    #[test]
    fn a_report_reads_as_designed() {
        let source = Source { name: "specs/motor.toml".into(), text: "a = 1\nload = { unit = \"rad/s^2\" }\n".into() };
        let diagnostic = Diagnostic::error(codes::UNOBSERVABLE, 6..10, "state `load` cannot be estimated from `y`")
            .label("rank 3 of 4; smallest singular value 3.1e-17")
            .help("measure `i` as well");
        let text = Report::new(source, vec![diagnostic]).render(false);
        assert!(text.contains("error[DB0301]: state `load` cannot be estimated from `y`"), "{text}");
        assert!(text.contains("specs/motor.toml:2:1"), "{text}");
        assert!(text.contains("^^^^ rank 3 of 4; smallest singular value 3.1e-17"), "{text}");
        assert!(text.contains("help: measure `i` as well"), "{text}");
    }

    /// Positions count characters, and offsets outside the text are brought inside.
    #[test]
    fn positions_are_in_characters() {
        let source = Source { name: "s".into(), text: "é\nxé = 1".into() };
        assert_eq!(source.position(6), (2, 3));
        assert_eq!(source.position(1_000), (2, 7));
    }
}
