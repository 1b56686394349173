//! Which realisation a step takes (window-observers, section 3, decision table).
//!
//! All are looked at, and listed with this plant's numbers; only the chosen one is designed to the last bit.

use crate::diagnostic::{Diagnostic, codes};
use crate::plant::Plant;
use crate::promise::Realization;

use super::Functional;
use super::realize::ping_pong::PingPong;
use super::realize::recursive::Recursive;
use super::realize::two_level::TwoLevel;
use super::realize::{Depth, Load, Refusal, Request, Wanted, Way};
use crate::numbers::count;
use crate::sampled::Part;

/// Weights up to which one sum over the window is best: bit-reproducible, nothing that could rot, few enough.
const FEW_WEIGHTS: usize = 1_000;
/// By how much blocks must be cheaper to be worth their tables.
const CHEAPER: f64 = 1.5;
/// By how much another realisation's round-off may be worse than that of the sum.
const WORSE: f64 = 30.0;
/// The most round-off that anyone may ask for: a tenth of a percent of what the samples can add up to.
const MOST_ROUND_OFF: f64 = 1e-3;

/// What was decided.
pub struct Decision {
    /// The way of the step.
    pub way: Way,
    /// All realisations, the chosen one first.
    pub list: Vec<Realization>,
}

/// A realisation that was looked at.
struct Candidate {
    wanted: Wanted,
    load: Load,
    /// Round-off against the sum of the weights, or why it may not run.
    verdict: Result<f64, Refusal>,
}

impl Candidate {
    fn round_off(&self) -> f64 {
        self.verdict.as_ref().copied().unwrap_or(f64::INFINITY)
    }
}

/// Looks at every realisation and takes the one that is wanted, or the best.
///
/// # Errors
/// That the one that is wanted may not run.
pub fn decide(plant: &Plant, request: &Request) -> Result<Decision, Vec<Diagnostic>> {
    let mut candidates: Vec<Candidate> =
        [Wanted::Fir, Wanted::TwoLevel, Wanted::PingPong, Wanted::Recursive].map(|w| look(plant, request, w)).into();
    let chosen = match request.wanted {
        Wanted::Auto => best(request, &candidates),
        wanted => wanted,
    };
    let refuse = |refusal: &Refusal| match refusal {
        Refusal::Broken(found) => found.clone(),
        Refusal::Unfit(why, number) => vec![refusal_of(request, why, *number, &candidates)],
    };
    if let Some(Err(refusal)) = candidates.iter().find(|c| c.wanted == chosen).map(|c| &c.verdict) {
        return Err(refuse(refusal));
    }
    let way = design(plant, request, chosen, Depth::Settle).map_err(|refusal| refuse(&refusal))?;
    // Looking judges a growing window at some of its ages; now all of them are known.
    let load = way.load().cloned().unwrap_or_else(|| request.functional.load(plant));
    let verdict = judge(plant, request, &load);
    if let Err(refusal) = &verdict {
        return Err(refuse(refusal));
    }
    if let Some(candidate) = candidates.iter_mut().find(|c| c.wanted == chosen) {
        (candidate.load, candidate.verdict) = (load, verdict);
    }
    let mut list: Vec<Realization> = candidates.iter().map(listed).collect();
    list.sort_by_key(|realization| realization.name != chosen.word());
    Ok(Decision { way, list })
}

/// Designs one realisation.
fn design(plant: &Plant, request: &Request, wanted: Wanted, depth: Depth) -> Result<Way, Refusal> {
    let (functional, exact) = (&request.functional, request.exact);
    let form = || {
        let curves = functional.signals.iter().any(|signal| signal.part == Part::Curves);
        let irregular = functional.gaps.is_some() || functional.irregular.is_some();
        match request.form {
            Err(why) => Err(Refusal::Unfit(why.to_owned(), None)),
            Ok(_) if plant.outputs.iter().any(|output| output.wrap.is_some()) => {
                Err(Refusal::Unfit("it sums samples; an output that wraps needs differences".into(), None))
            }
            Ok(_) if !functional.longer.is_empty() => {
                Err(Refusal::Unfit("several windows share one buffer of samples".into(), None))
            }
            Ok(_) if curves => Err(Refusal::Unfit("its copies take straight lines between samples".into(), None)),
            Ok(_) if irregular => Err(Refusal::Unfit("measurements come at irregular times".into(), None)),
            Ok(form) => Ok(form),
        }
    };
    Ok(match wanted {
        Wanted::Auto | Wanted::Fir => turns_add_up(plant, functional).map(|()| Way::Fir)?,
        Wanted::TwoLevel => Way::TwoLevel(Box::new(TwoLevel::new(plant, functional, exact, form()?, depth)?)),
        Wanted::PingPong => Way::PingPong(Box::new(PingPong::new(plant, functional, exact, form()?, depth)?)),
        Wanted::Recursive => Way::Recursive(Box::new(Recursive::new(plant, functional, exact, form()?, depth)?)),
    })
}

/// Whether the weights of each output that wraps add up to the direction of its turn, so that differences to the newest
/// sample can be summed instead.
fn turns_add_up(plant: &Plant, functional: &Functional) -> Result<(), Refusal> {
    // Each weight is rounded once.
    const ROUNDING: f64 = 1e-12;
    let wraps = plant.outputs.iter().enumerate().filter_map(|(o, output)| Some((o, output.wrap.as_ref()?)));
    for (window, (o, wrap)) in functional.windows().flat_map(|window| wraps.clone().map(move |wrap| (window, wrap))) {
        let weights = &window.outputs[o];
        for (i, s) in wrap.direction.iter().enumerate() {
            let sum: f64 = weights.ages().map(|age| weights.at(i, age).double).sum();
            let off = (sum - s.to_f64().unwrap_or(f64::NAN)).abs();
            if off.is_nan() || off > ROUNDING * weights.l1(i).max(1.0) {
                let name = &plant.outputs[o].label.name;
                let why = format!("the weights of `{name}` do not add up to the direction of a turn");
                return Err(Refusal::Unfit(why, Some(off)));
            }
        }
    }
    Ok(())
}

fn look(plant: &Plant, request: &Request, wanted: Wanted) -> Candidate {
    match design(plant, request, wanted, Depth::Look) {
        Ok(way) => {
            let load = way.load().cloned().unwrap_or_else(|| request.functional.load(plant));
            let verdict = judge(plant, request, &load);
            Candidate { wanted, load, verdict }
        }
        Err(refusal) => Candidate { wanted, load: Load::default(), verdict: Err(refusal) },
    }
}

/// The round-off against the sum of the weights, if a step may have it.
fn judge(plant: &Plant, request: &Request, load: &Load) -> Result<f64, Refusal> {
    let relative = load.relative(&request.functional);
    let most = MOST_ROUND_OFF.max(request.functional.load(plant).relative(&request.functional));
    if relative <= most { Ok(relative) } else { Err(inaccurate(plant, relative)) }
}

fn inaccurate(plant: &Plant, relative: f64) -> Refusal {
    Refusal::Unfit(
        format!("in {}, round-off could reach {relative:.0e} of the sum of its terms", plant.scalar),
        Some(relative),
    )
}

/// The sum, unless it is long and blocks are clearly cheaper and as accurate.
fn best(request: &Request, candidates: &[Candidate]) -> Wanted {
    let find = |wanted: Wanted| candidates.iter().find(|c| c.wanted == wanted);
    let (Some(fir), Some(blocks)) = (find(Wanted::Fir), find(Wanted::TwoLevel)) else { return Wanted::Fir };
    let long = request.functional.pairs() * (request.functional.steps + 1) > FEW_WEIGHTS;
    let cheaper = count(blocks.load.flops) * CHEAPER <= count(fir.load.flops);
    let accurate = blocks.round_off() <= WORSE * fir.round_off();
    if long && cheaper && accurate { Wanted::TwoLevel } else { Wanted::Fir }
}

fn listed(candidate: &Candidate) -> Realization {
    let verdict = match &candidate.verdict {
        Ok(relative) => Ok(format!("round-off below {relative:.0e} of the sum of its terms")),
        Err(refusal) => Err(refusal.why()),
    };
    let Load { words, flops, constants, .. } = candidate.load;
    Realization { name: candidate.wanted.word(), words, flops, constants, verdict }
}

/// What is wrong with what was asked for, and what works instead.
fn refusal_of(request: &Request, why: &str, number: Option<f64>, candidates: &[Candidate]) -> Diagnostic {
    let message = format!("the realisation `{}` may not run for this plant", request.wanted.word());
    let error = Diagnostic::error(codes::REALIZATION, request.span.clone(), message).label(why);
    let error = match number {
        Some(number) => error.measured(number),
        None => error,
    };
    let possible = candidates.iter().filter(|c| c.verdict.is_ok() && c.wanted != request.wanted);
    let words: Vec<String> =
        possible.map(|c| format!("`realization = \"{}\"` ({} flops a step)", c.wanted.word(), c.load.flops)).collect();
    error.help(words.join(" or "))
}
