//! The registry of observer methods: one line each.
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
pub mod features;
pub mod fixed_time_linear;
pub mod high_gain;
pub mod impulsive;
pub mod kalman;
pub mod low_pass;
pub mod luenberger;
mod noise;
pub mod order;
pub mod parameters;
pub mod pll;
mod poles;
pub mod prescribed_time;
pub mod robust_exact;
pub mod single_delay;
pub mod window;

use std::fmt::Debug;
use std::sync::Arc;

use crate::design::{Design, NamedMatrix};
use crate::diagnostic::Diagnostic;
use crate::plant::Plant;
use crate::spec::reader::Table;
pub use features::{Cannot, Feature, cannot_count};

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
    /// The page that `deadbeat list <method>` prints below these.
    pub page: &'static str,
    /// Reads the method's table; mistakes are reported there and give `None`.
    pub read: fn(&mut Table) -> Option<Arc<dyn Keyed>>,
}

/// A method with its keys read.
pub trait Keyed: Debug + Send + Sync {
    /// The order of the chain of integrators that stands for the plant: of the key `order`, where it is given.
    fn chain(&self) -> Option<usize> {
        None
    }

    /// The key that stands for the plant; `None` where the method itself does.
    fn chain_key(&self) -> Option<&'static str> {
        Some("order")
    }

    /// What to write in a file that declares a plant and gives `order` too.
    fn instead_of_chain(&self) -> &'static str {
        "leave out `order`"
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

    /// Why something that a specification asks for cannot be done for this plant.
    fn cannot(&self, feature: Feature, plant: &Plant) -> Option<Cannot>;

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

/// What a unit test of a method needs: a plant from a specification's text.
#[cfg(test)]
pub fn designed(text: &str) -> Result<(Plant, Design), String> {
    let source = crate::diagnostic::Source { name: "test.toml".into(), text: text.into() };
    let spec =
        crate::spec::Spec::parse(source.clone(), crate::spec::Settings::default()).map_err(|r| r.render(false))?;
    let (plant, _) = Plant::new(&spec).map_err(|r| r.render(false))?;
    let plant = spec.observer.keyed.observed(plant);
    let plant = plant.map_err(|found| crate::diagnostic::Report::new(source.clone(), found).render(false))?;
    let design = spec.observer.keyed.design(&plant);
    let design = design.map_err(|found| crate::diagnostic::Report::new(source, found).render(false))?;
    Ok((plant, design))
}
