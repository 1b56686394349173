//! The key `poles` of a method: as many as there are states, left of the imaginary axis, closed under conjugation.

use std::ops::Range;

use crate::decimal::show;
use crate::diagnostic::{Diagnostic, codes};
use crate::estimator::corrector::placement::Pole;
use crate::expr::Constant;
use crate::numbers::count;
use crate::plant::Plant;
use crate::real::{Precision, Real};
use crate::spec::Quantity;
use crate::spec::reader::Table;

/// The key as it is written.
#[derive(Clone, Debug)]
pub(super) struct Poles {
    entries: Vec<(Vec<Quantity>, Range<usize>)>,
    span: Range<usize>,
}

/// A pole exactly.
#[derive(Clone, Debug)]
pub(super) struct Exact {
    re: Constant,
    im: Constant,
    span: Range<usize>,
}

/// Reads the key, if it is there.
pub(super) fn read(table: &mut Table) -> Option<Poles> {
    let span = table.key_span("poles");
    Some(Poles { entries: table.complex_list("poles")?, span })
}

impl Poles {
    /// The poles, after everything that stands against them was reported.
    pub(super) fn check(&self, plant: &Plant, found: &mut Vec<Diagnostic>) -> Option<Vec<Exact>> {
        let before = found.len();
        let mut poles = Vec::new();
        for (parts, span) in &self.entries {
            let mut parts = parts.iter().map(|part| plant.constant(part, found));
            let (re, im) = (parts.next().flatten(), parts.next().unwrap_or_else(|| Some(Constant::default())));
            if let (Some(re), Some(im)) = (re, im) {
                poles.push(Exact { re, im, span: span.clone() });
            }
        }
        if found.len() > before {
            return None;
        }
        self.count(plant, found);
        for pole in &poles {
            pole.check_side(found);
        }
        check_pairs(&poles, found);
        (found.len() == before).then_some(poles)
    }

    fn count(&self, plant: &Plant, found: &mut Vec<Diagnostic>) {
        let (given, states) = (self.entries.len(), plant.states.len());
        if given == states {
            return;
        }
        let message = "`poles` needs as many entries as there are states";
        let error = Diagnostic::error(codes::SHAPE, self.span.clone(), message)
            .label(format!("{given} for {states} states"))
            .measured(count(given));
        found.push(error.help("a complex pole and its conjugate are two entries: `[-3, 4], [-3, -4]`"));
    }
}

impl Exact {
    /// The value of a part, for comparisons and messages.
    fn parts(&self) -> (f64, f64) {
        (self.re.to_f64().unwrap_or(f64::NAN), self.im.to_f64().unwrap_or(f64::NAN))
    }

    fn check_side(&self, found: &mut Vec<Diagnostic>) {
        let (re, _) = self.parts();
        if re < 0.0 {
            return;
        }
        let message = format!("with a pole at {}, the error does not die out", self.shown());
        let error = Diagnostic::error(codes::BAD_NUMBER, self.span.clone(), message).measured(re);
        found.push(error.help("a negative real part: minus one over the time constant"));
    }

    /// As a person writes it.
    fn shown(&self) -> String {
        match self.parts() {
            (re, 0.0) => show(re),
            (re, im) => format!("[{}, {}]", show(re), show(im)),
        }
    }

    /// Magnitude.
    pub(super) fn size(&self) -> f64 {
        let (re, im) = self.parts();
        deadbeat_math::sqrt_f64(re * re + im * im)
    }

    /// Minus the real part.
    pub(super) fn decay(&self) -> f64 {
        -self.parts().0
    }

    /// The imaginary part's magnitude.
    pub(super) fn turns(&self) -> f64 {
        self.parts().1.abs()
    }

    /// Its place in the file.
    pub(super) fn span(&self) -> Range<usize> {
        self.span.clone()
    }

    /// At a precision.
    pub(super) fn at(&self, p: Precision) -> Pole {
        let value = |c: &Constant| c.evaluate(p).unwrap_or_else(|_| Real::zero(p));
        Pole { re: value(&self.re), im: value(&self.im) }
    }
}

/// Reports a pole off the real axis whose conjugate is not there as often as itself.
fn check_pairs(poles: &[Exact], found: &mut Vec<Diagnostic>) {
    let mut alone: Vec<&Exact> = Vec::new();
    for pole in poles.iter().filter(|pole| !pole.im.is_zero()) {
        let (re, im) = pole.parts();
        match alone.iter().position(|other| other.parts() == (re, -im)) {
            Some(place) => drop(alone.remove(place)),
            None => alone.push(pole),
        }
    }
    for pole in alone {
        let (re, im) = pole.parts();
        let message = format!("the complex pole {} needs its conjugate", pole.shown());
        let error = Diagnostic::error(codes::BAD_NUMBER, pole.span.clone(), message).measured(im);
        found.push(error.help(format!("add `[{}, {}]`", show(re), show(-im))));
    }
}
