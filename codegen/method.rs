//! The registry of observer methods: one line each.
//!
//! Knows its keys, which estimator it asks for, with which numbers. Never knows how a step is written, nor a language.
//!
//! A method is one file: what it is, its keys, its design. It reads its own table of the
//! specification ([`Method::read`]) and gives something that designs ([`Keyed`]).

pub mod adaptive_window;
pub mod alpha_beta;
mod baseline;
mod between;
mod constant;
pub mod countdown;
pub mod differentiator;
pub mod fixed_time_linear;
pub mod high_gain;
pub mod impulsive;
pub mod kalman;
pub mod low_pass;
pub mod luenberger;
pub mod matrix;
mod noise;
pub mod order;
pub mod parameters;
pub mod pll;
mod poles;
pub mod prescribed_time;
pub mod robust_exact;
pub mod single_delay;
pub mod window;

use crate::plant::features::{Feature, Limit, refused};
use std::any::Any;
use std::fmt::Debug;
use std::ops::Range;
use std::sync::Arc;

use crate::diagnostic::{Diagnostic, Level, Report, Source, codes};
use crate::estimator::Design;
use crate::expr::nearest;
use crate::plant::Plant;
use crate::promise::NamedMatrix;
use crate::spec::reader::Table;
use crate::spec::{Chain, Settings, Spec, Text, Unread};

/// All methods, in the order in which `deadbeat list` shows them.
pub const METHODS: &[Method] = &[
    window::METHOD,
    single_delay::METHOD,
    impulsive::METHOD,
    parameters::METHOD,
    prescribed_time::METHOD,
    differentiator::METHOD,
    luenberger::METHOD,
    kalman::METHOD,
    high_gain::METHOD,
    fixed_time_linear::METHOD,
    robust_exact::METHOD,
    pll::METHOD,
    alpha_beta::METHOD,
    low_pass::METHOD,
    adaptive_window::METHOD,
];

/// What a user can name in `[observer.<name>]`.
pub struct Method {
    /// The table's name.
    pub name: &'static str,
    /// One line for lists.
    pub summary: &'static str,
    /// Paper and equations.
    pub source: &'static str,
    /// Key, unit or choices, meaning.
    pub keys: &'static [(&'static str, &'static str, &'static str)],
    /// How the step can be realised, with a line each; the first is the default.
    pub realizations: &'static [(&'static str, &'static str)],
    /// What it cannot take, with the reasons.
    pub limits: &'static [Limit],
    /// The page that `deadbeat list <method>` prints below these.
    pub page: &'static str,
    /// Reads the method's table; mistakes are reported there and give `None`.
    pub read: fn(&mut Table) -> Option<Arc<dyn Keyed>>,
}

/// A method with its keys read.
pub trait Keyed: Any + Debug + Send + Sync {
    /// Whether its keys stand for the plant.
    fn chain(&self) -> Chain {
        Chain { order: None, key: Some("order"), instead: "leave out `order`" }
    }

    /// The plant whose states are estimated: where unknown constants are estimated too, they are states of it.
    fn observed(&self, plant: Plant) -> Result<Plant, Vec<Diagnostic>> {
        Ok(plant)
    }

    /// What the gains are at one step from the first sample on; for reports. A text says why there is nothing.
    fn at(&self, _plant: &Plant, _step: usize) -> Result<Moment, String> {
        Err("`--at` is for gains that change from step to step, which only `differentiator` and `prescribed-time` \
             have; without it, the design is printed"
            .into())
    }

    /// Features that its own keys ask for, with their places.
    fn asks(&self) -> Vec<(Feature, Range<usize>)> {
        Vec::new()
    }

    /// Designs the observer for a plant, or says everything that stands against it.
    fn design(&self, plant: &Plant) -> Result<Design, Vec<Diagnostic>>;
}

/// An observer with changing gains at one step.
#[derive(Clone, Debug)]
pub struct Moment {
    /// From the first sample on.
    pub step: usize,
    /// Until the prescribed time.
    pub left: usize,
    /// Whether the observer's countdown comes so far.
    pub in_use: bool,
    /// What there is to see.
    pub matrices: Vec<NamedMatrix>,
}

/// A specification with its method's keys read.
///
/// # Errors
/// Every mistake of the file at once; where only keys are wrong, those in its equations too.
pub fn read(source: Source, settings: Settings) -> Result<(Spec, Arc<dyn Keyed>), Report> {
    let mut keyed = None;
    let spec = Spec::parse(source, settings, &mut |name, table| {
        let (method, keys) = read_keys(name, table)?;
        let chain = (keys.chain(), method.several_outputs());
        keyed = Some(keys);
        Some(chain)
    });
    let spec = spec.map_err(|Unread { report, rest }| {
        let equations = rest.and_then(|rest| Plant::new(&rest).err()).map(|report| report.diagnostics);
        let mistakes =
            equations.into_iter().flatten().filter(|d| d.level == Level::Error && d.code.starts_with("DB02"));
        Report::new(report.source, report.diagnostics.into_iter().chain(mistakes).collect())
    })?;
    let keyed = keyed.unwrap_or_else(|| unreachable!("a specification without an observer is refused"));
    Ok((spec, keyed))
}

/// What a plant's specification asks for that its method cannot take.
pub fn refusals(plant: &Plant, name: &str, keyed: &(dyn Keyed + 'static)) -> Vec<Diagnostic> {
    let limits = METHODS.iter().find(|method| method.name == name).map_or(&[][..], |method| method.limits);
    refused(plant, name, limits, (keyed, keyed.asks()))
}

impl Method {
    /// The method of that name, or a sentence that says what there is.
    ///
    /// # Errors
    /// There is none.
    pub fn named(name: &str) -> Result<&'static Self, String> {
        let known = || METHODS.iter().map(|method| method.name);
        METHODS.iter().find(|method| method.name == name).ok_or_else(|| {
            let close = nearest(name, known()).map(|close| format!("did you mean `{close}`? "));
            let all = known().collect::<Vec<_>>().join(", ");
            format!("there is no method `{name}`; {}the methods are: {all}", close.unwrap_or_default())
        })
    }

    /// What stands against a feature whatever the specification.
    fn never(&self, feature: Feature) -> Option<&'static Limit> {
        self.against(feature).find(|limit| limit.words().is_none())
    }

    /// Why it takes one output; empty where it takes more.
    fn several_outputs(&self) -> String {
        self.never(Feature::Outputs).map_or(String::new(), |limit| limit.sentence(self.name))
    }

    /// Refuses what a key of the table asks for that the method never takes, and has no such key for.
    fn refuse_keys(&self, table: &Table) -> bool {
        let left_out = table.has_word("missing", "left-out");
        let asked = [(left_out, Feature::LeftOut, "missing"), (table.has_list("window"), Feature::Windows, "window")];
        let refused = asked.iter().filter(|(is_asked, ..)| *is_asked).filter_map(|(_, feature, key)| {
            let limit = self.never(*feature)?;
            Some(limit.refusal(self.name, table.key_span(key)))
        });
        refused.map(|refusal| table.report(refusal)).count() > 0
    }
}

/// The keys of a method's table, by the method's name.
fn read_keys(name: &Text, mut table: Table) -> Option<(&'static Method, Arc<dyn Keyed>)> {
    let known = || METHODS.iter().map(|method| method.name);
    let Some(method) = METHODS.iter().find(|method| method.name == name.value) else {
        let message = format!("there is no observer method `{}`", name.value.escape_debug());
        let error = Diagnostic::error(codes::UNKNOWN_METHOD, name.span.clone(), message);
        table.report(match nearest(&name.value, known()) {
            Some(close) => error.help(format!("did you mean `{close}`?")).patch(name.span.clone(), close),
            None => error.help(format!("the methods are: {}", known().collect::<Vec<_>>().join(", "))),
        });
        return None;
    };
    if method.refuse_keys(&table) {
        return None;
    }
    let keyed = (method.read)(&mut table);
    table.finish();
    keyed.map(|keyed| (method, keyed))
}

/// What a unit test of a method needs: a plant from a specification's text.
#[cfg(test)]
pub fn designed(text: &str) -> Result<(Plant, Design), String> {
    let source = Source { name: "test.toml".into(), text: text.into() };
    let (spec, keyed) = read(source.clone(), Settings::default()).map_err(|r| r.render(false))?;
    let (plant, _) = Plant::new(&spec).map_err(|r| r.render(false))?;
    let plant = keyed.observed(plant).map_err(|found| Report::new(source.clone(), found).render(false))?;
    let refused = refusals(&plant, &spec.observer.method.value, keyed.as_ref());
    if !refused.is_empty() {
        return Err(Report::new(source, refused).render(false));
    }
    let design = keyed.design(&plant).map_err(|found| Report::new(source, found).render(false))?;
    Ok((plant, design))
}
