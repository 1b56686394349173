//! Splits a right-hand side into `A x + B u + c + phi(y, u, t) + sum eps gamma + sum w d`.
//!
//! The canonical form decides what is linear; the user's own form is kept for what is not, so
//! that the step computes it as it was written.

use std::collections::BTreeMap;
use std::ops::Range;

use dashu_ratio::RBig;

use crate::decimal;
use crate::diagnostic::{Diagnostic, codes};
use crate::expr::{Atom, Constant, Function, Meaning, Monomial, Node, NodeKind, Poly, Symbol};
use crate::spec::{Hold, Spec};

/// Which states the undelayed outputs give at once, and by which weights.
#[derive(Clone, Debug)]
pub struct Measurable {
    /// Per state: outputs and weights; empty when it is not measured.
    pub weights: Vec<Vec<(usize, Constant)>>,
    /// Per state: whether a delayed output shows it.
    late: Vec<bool>,
}

impl Measurable {
    /// Looks at the rows of C; `delayed` marks those that arrive late.
    pub fn new(c: &[Vec<Constant>], delayed: &[bool]) -> Self {
        let n = c.first().map_or(0, Vec::len);
        let rows: Vec<usize> = (0..c.len()).filter(|i| !delayed[*i]).collect();
        let late = (0..n).map(|j| (0..c.len()).any(|i| delayed[i] && !c[i][j].is_zero())).collect();
        Self { weights: by_elimination(c, &rows, n).unwrap_or_else(|| by_single_entries(c, &rows, n)), late }
    }

    fn shows(&self, state: usize) -> bool {
        !self.weights[state].is_empty()
    }
}

/// Gauss-Jordan elimination of [C | I] in rationals; `None` when an entry is not rational.
fn by_elimination(c: &[Vec<Constant>], rows: &[usize], n: usize) -> Option<Vec<Vec<(usize, Constant)>>> {
    let p = rows.len();
    let mut table: Vec<Vec<RBig>> = Vec::new();
    for (place, row) in rows.iter().enumerate() {
        let mut entries: Vec<RBig> = c[*row].iter().map(Constant::as_rational).collect::<Option<_>>()?;
        entries.extend((0..p).map(|k| if k == place { RBig::ONE } else { RBig::ZERO }));
        table.push(entries);
    }
    let mut done = 0;
    for column in 0..n {
        let Some(pivot) = (done..p).find(|row| !table[*row][column].is_zero()) else { continue };
        table.swap(done, pivot);
        let scale = RBig::ONE / &table[done][column];
        table[done].iter_mut().for_each(|x| *x *= &scale);
        let source = table[done].clone();
        for (row, entries) in table.iter_mut().enumerate() {
            if row != done && !entries[column].is_zero() {
                let factor = entries[column].clone();
                entries.iter_mut().zip(&source).for_each(|(x, s)| *x -= &factor * s);
            }
        }
        done += 1;
    }
    let mut weights = vec![Vec::new(); n];
    for row in &table[..done] {
        let states: Vec<usize> = (0..n).filter(|j| !row[*j].is_zero()).collect();
        if let [state] = states.as_slice() {
            let entries = (0..p).filter(|k| !row[n + k].is_zero());
            weights[*state] = entries.map(|k| (rows[k], Constant::from(row[n + k].clone()))).collect();
        }
    }
    Some(weights)
}

/// Rows of C with one entry.
fn by_single_entries(c: &[Vec<Constant>], rows: &[usize], n: usize) -> Vec<Vec<(usize, Constant)>> {
    let mut weights = vec![Vec::new(); n];
    for row in rows {
        let states: Vec<usize> = (0..n).filter(|j| !c[*row][*j].is_zero()).collect();
        if let [state] = states.as_slice()
            && let Ok(inverse) = c[*row][*state].poly().reciprocal()
            && let Ok(weight) = Constant::try_from(inverse)
        {
            weights[*state] = vec![(*row, weight)];
        }
    }
    weights
}

/// How many of each there are.
#[derive(Clone, Copy, Debug)]
#[expect(missing_docs, reason = "the names say it")]
pub struct Sizes {
    pub states: usize,
    pub inputs: usize,
    pub unknowns: usize,
    pub disturbances: usize,
}

/// One right-hand side, split. Coefficients are constant polynomials.
pub struct Side {
    /// Row of A.
    pub states: Vec<Poly>,
    /// Row of B.
    pub inputs: Vec<Poly>,
    /// Entry of c.
    pub offset: Poly,
    /// Entries of the gammas, which may vary.
    pub unknowns: Vec<Poly>,
    /// Entries of the disturbances' columns.
    pub disturbances: Vec<Poly>,
    /// Nonlinear functions by their monic canonical form, with coefficients.
    pub nonlinear: BTreeMap<Poly, (Node, Poly)>,
}

/// Splits a right-hand side; what cannot be split is reported and gives `None`.
pub fn side(
    right: &Node,
    measurable: &Measurable,
    sizes: Sizes,
    known: &[(String, Meaning)],
    found: &mut Vec<Diagnostic>,
) -> Option<Side> {
    let before = found.len();
    let mut side = Side {
        states: vec![Poly::default(); sizes.states],
        inputs: vec![Poly::default(); sizes.inputs],
        offset: Poly::default(),
        unknowns: vec![Poly::default(); sizes.unknowns],
        disturbances: vec![Poly::default(); sizes.disturbances],
        nonlinear: BTreeMap::new(),
    };
    let mut rest = Poly::default();
    for (monomial, coefficient) in right.poly.terms() {
        let (fixed, varying) = monomial.split();
        let term = Poly::monomial(fixed, coefficient.clone());
        let add = |place: &mut Poly| *place = std::mem::take(place).plus(&term).unwrap_or_default();
        match classify(&varying, measurable) {
            Class::Offset => add(&mut side.offset),
            Class::State(j) => add(&mut side.states[j]),
            Class::Input(i) => add(&mut side.inputs[i]),
            Class::Disturbance(k) => add(&mut side.disturbances[k]),
            Class::Unknown(k, factor) => {
                let gamma = term.times(&factor).unwrap_or_default();
                side.unknowns[k] = std::mem::take(&mut side.unknowns[k]).plus(&gamma).unwrap_or_default();
            }
            Class::Nonlinear => {
                let whole = Poly::monomial(monomial.clone(), coefficient.clone());
                rest = rest.plus(&whole).unwrap_or_default();
            }
            Class::Mistake(mistake) => found.push(mistake.explain(&varying, right, measurable, known)),
        }
    }
    nonlinear(right, rest, measurable, &mut side.nonlinear);
    (found.len() == before).then_some(side)
}

/// What a monomial's varying part is.
enum Class {
    Offset,
    State(usize),
    Input(usize),
    Unknown(usize, Poly),
    Disturbance(usize),
    Nonlinear,
    Mistake(Mistake),
}

enum Mistake {
    State(usize),
    Unknown(usize),
    Disturbance(usize),
}

fn classify(varying: &Monomial, measurable: &Measurable) -> Class {
    match varying.as_symbol() {
        Some(Symbol::State(j)) => return Class::State(j),
        Some(Symbol::Input(i)) => return Class::Input(i),
        Some(Symbol::Unknown(k)) => return Class::Unknown(k, Poly::from(RBig::ONE)),
        Some(Symbol::Disturbance(k)) => return Class::Disturbance(k),
        Some(Symbol::Time) => return Class::Nonlinear,
        None => {}
    }
    let symbols = varying.symbols();
    if symbols.is_empty() {
        return Class::Offset;
    }
    for symbol in &symbols {
        match *symbol {
            Symbol::State(j) if !measurable.shows(j) => return Class::Mistake(Mistake::State(j)),
            Symbol::Disturbance(k) => return Class::Mistake(Mistake::Disturbance(k)),
            Symbol::Unknown(k) => return factor_of_unknown(varying, k),
            _ => {}
        }
    }
    Class::Nonlinear
}

/// `eps * gamma(t, y, u)`: the unknown once, outside every function.
fn factor_of_unknown(varying: &Monomial, k: usize) -> Class {
    let mut gamma = Poly::from(RBig::ONE);
    for (atom, exponent) in varying.factors() {
        if matches!(atom, Atom::Symbol(Symbol::Unknown(which)) if *which == k) && *exponent == 1 {
            continue;
        }
        match Poly::from(atom.clone()).power(*exponent).and_then(|factor| gamma.times(&factor)) {
            Ok(product) => gamma = product,
            Err(_) => return Class::Mistake(Mistake::Unknown(k)),
        }
    }
    if gamma.symbols().iter().any(|s| matches!(s, Symbol::Unknown(_))) {
        return Class::Mistake(Mistake::Unknown(k));
    }
    Class::Unknown(k, gamma)
}

impl Mistake {
    fn explain(
        &self,
        varying: &Monomial,
        right: &Node,
        measurable: &Measurable,
        known: &[(String, Meaning)],
    ) -> Diagnostic {
        let symbol = match *self {
            Self::State(j) => Symbol::State(j),
            Self::Unknown(k) => Symbol::Unknown(k),
            Self::Disturbance(k) => Symbol::Disturbance(k),
        };
        let span = culprit(right, varying, Some(symbol));
        let name = name_of(symbol, known);
        let what = shortened(describe(varying, known));
        match *self {
            Self::State(j) if measurable.late[j] => {
                let message = format!("nonlinear in `{name}`, which is measured late");
                Diagnostic::error(codes::DELAYED_INJECTION, span, message)
                    .label(format!("`{what}` needs `{name}` at once"))
                    .help(format!("measure `{name}` without delay, or approximate the term by a linear one"))
            }
            Self::State(_) => {
                let message = format!("nonlinear in `{name}`, which is not measured");
                Diagnostic::error(codes::NONLINEAR_STATE, span, message)
                    .label(format!("`{what}` is not linear in `{name}`"))
                    .help(format!("no observer method accepts this: measure `{name}` as an output of its own, or approximate the term by a linear one"))
            }
            Self::Unknown(_) => {
                let message = format!("the unknown `{name}` must enter affinely");
                Diagnostic::error(codes::NOT_AFFINE, span, message)
                    .label(format!("this contains `{what}`"))
                    .help(format!("write `{name}` times a function of t, inputs and measured states"))
            }
            Self::Disturbance(_) => {
                let message = format!("the disturbance `{name}` must enter linearly");
                Diagnostic::error(codes::NOT_AFFINE, span, message)
                    .label(format!("this contains `{what}`"))
                    .help(format!("write a constant times `{name}`"))
            }
        }
    }
}

/// The smallest part of the tree that holds the monomial; failing that, the name itself.
pub fn culprit(node: &Node, varying: &Monomial, symbol: Option<Symbol>) -> Range<usize> {
    let holds = |child: &Node| child.poly.terms().any(|(m, _)| m.split().1 == *varying);
    match children(node).into_iter().find(|child| holds(child)) {
        Some(child) => culprit(child, varying, symbol),
        None if holds(node) => node.span.clone(),
        None => symbol.and_then(|s| find_symbol(node, s)).unwrap_or_else(|| node.span.clone()),
    }
}

fn find_symbol(node: &Node, symbol: Symbol) -> Option<Range<usize>> {
    match &node.kind {
        NodeKind::Symbol(found) if *found == symbol => Some(node.span.clone()),
        _ => children(node).into_iter().find_map(|child| find_symbol(child, symbol)),
    }
}

fn children(node: &Node) -> Vec<&Node> {
    match &node.kind {
        NodeKind::Constant | NodeKind::Symbol(_) => Vec::new(),
        NodeKind::Sum(parts) | NodeKind::Product(parts) => parts.iter().map(|(_, part)| part).collect(),
        NodeKind::Power(base, _) => vec![base],
        NodeKind::Call(_, arguments) => arguments.iter().collect(),
    }
}

/// Collects the nonlinear terms: the user's own where they are purely nonlinear, else monomial by monomial.
fn nonlinear(right: &Node, mut rest: Poly, measurable: &Measurable, into: &mut BTreeMap<Poly, (Node, Poly)>) {
    for (coefficient, core) in flatten(right, Poly::from(RBig::ONE)) {
        let pure = core.poly.terms().all(|(m, _)| matches!(classify(&m.split().1, measurable), Class::Nonlinear));
        let Ok(whole) = coefficient.times(&core.poly) else { continue };
        if !pure || whole.is_zero() {
            continue;
        }
        let Ok(difference) = rest.clone().plus(&whole.negated()) else { continue };
        rest = difference;
        insert(into, core.clone(), coefficient);
    }
    for (monomial, coefficient) in rest.terms() {
        let (fixed, varying) = monomial.split();
        insert(into, Node::from_monomial(&varying, &right.span), Poly::monomial(fixed, coefficient.clone()));
    }
    into.retain(|_, (_, coefficient)| !coefficient.is_zero());
}

/// Adds a term; equal functions share an entry whatever their scale.
fn insert(into: &mut BTreeMap<Poly, (Node, Poly)>, node: Node, coefficient: Poly) {
    let (monic, leading) = node.poly.monic();
    let (first, sum) = into.entry(monic).or_insert_with(|| (node, Poly::default()));
    let ratio = &leading / &first.poly.monic().1;
    if let Ok(more) = coefficient.times(&ratio.into()) {
        *sum = std::mem::take(sum).plus(&more).unwrap_or_default();
    }
}

/// The terms of a sum with their constant coefficients; constants are taken out of products and carried into sums.
fn flatten(node: &Node, coefficient: Poly) -> Vec<(Poly, Node)> {
    match &node.kind {
        NodeKind::Constant => Vec::new(),
        NodeKind::Sum(terms) => terms
            .iter()
            .flat_map(|(minus, term)| {
                let signed = if *minus { coefficient.clone().negated() } else { coefficient.clone() };
                flatten(term, signed)
            })
            .collect(),
        NodeKind::Product(factors) => flatten_product(node, factors, coefficient),
        _ => vec![(coefficient, node.clone())],
    }
}

fn flatten_product(node: &Node, factors: &[(bool, Node)], coefficient: Poly) -> Vec<(Poly, Node)> {
    let (constants, varying): (Vec<_>, Vec<_>) =
        factors.iter().partition(|(_, f)| matches!(f.kind, NodeKind::Constant));
    let mut scale = Ok(coefficient.clone());
    for (divided, constant) in &constants {
        let factor = if *divided { constant.poly.reciprocal() } else { Ok(constant.poly.clone()) };
        scale = scale.and_then(|product| product.times(&factor?));
    }
    let Ok(scale) = scale else { return vec![(coefficient, node.clone())] };
    if let [(false, only)] = varying.as_slice() {
        return flatten(only, scale);
    }
    let mut poly = Ok(Poly::from(RBig::ONE));
    for (divided, factor) in &varying {
        let factor = if *divided { factor.poly.reciprocal() } else { Ok(factor.poly.clone()) };
        poly = poly.and_then(|product| product.times(&factor?));
    }
    match poly {
        Ok(poly) => {
            let kind = NodeKind::Product(varying.into_iter().cloned().collect());
            vec![(scale, Node { kind, poly, span: node.span.clone() })]
        }
        Err(_) => vec![(coefficient, node.clone())],
    }
}

/// How a function behaves between samples, which decides its hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Change {
    /// With zero-order-hold inputs only: constant between samples.
    Held,
    /// With outputs, time and first-order-hold inputs: runs on between samples.
    Runs,
    /// With both: runs on, and jumps at the samples.
    RunsAndJumps,
}

/// The behaviour of a function between samples, given the holds of the inputs.
pub fn change(poly: &Poly, hold: impl Fn(usize) -> Hold) -> Change {
    let (mut held, mut runs) = (false, false);
    for symbol in poly.symbols() {
        match symbol {
            Symbol::Input(i) if hold(i) == Hold::Zero => held = true,
            _ => runs = true,
        }
    }
    match (held, runs) {
        (_, false) => Change::Held,
        (false, true) => Change::Runs,
        (true, true) => Change::RunsAndJumps,
    }
}

/// As few functions as possible: one per distinct function, or one per state where that is fewer.
pub fn combine(terms: BTreeMap<Poly, (Node, Vec<Poly>)>, spec: &Spec) -> Vec<(Node, Vec<Poly>)> {
    let mut groups: BTreeMap<Change, Vec<(Node, Vec<Poly>)>> = BTreeMap::new();
    for (poly, entry) in terms {
        groups.entry(change(&poly, |i| spec.inputs[i].hold)).or_default().push(entry);
    }
    groups.into_values().flat_map(combine_group).collect()
}

fn combine_group(functions: Vec<(Node, Vec<Poly>)>) -> Vec<(Node, Vec<Poly>)> {
    let n = functions.first().map_or(0, |(_, column)| column.len());
    let rows: Vec<usize> = (0..n).filter(|i| functions.iter().any(|(_, column)| !column[*i].is_zero())).collect();
    if functions.len() <= rows.len() {
        return functions;
    }
    rows.iter()
        .map(|row| {
            let mut column = vec![Poly::default(); n];
            column[*row] = Poly::from(RBig::ONE);
            (sum_of(&functions, *row), column)
        })
        .collect()
}

/// The sum of coefficient times function in one row, as a node.
fn sum_of(functions: &[(Node, Vec<Poly>)], row: usize) -> Node {
    let mut poly = Poly::default();
    let mut terms = Vec::new();
    for (node, column) in functions.iter().filter(|(_, column)| !column[row].is_zero()) {
        let coefficient = Node { kind: NodeKind::Constant, poly: column[row].clone(), span: node.span.clone() };
        let whole = column[row].times(&node.poly).unwrap_or_default();
        poly = poly.plus(&whole).unwrap_or_default();
        let kind = NodeKind::Product(vec![(false, coefficient), (false, node.clone())]);
        terms.push((false, Node { kind, poly: whole, span: node.span.clone() }));
    }
    let span = terms.first().map_or(0..0, |(_, term)| term.span.clone());
    Node { kind: NodeKind::Sum(terms), poly, span }
}

/// What the user calls a symbol.
pub fn name_of(symbol: Symbol, known: &[(String, Meaning)]) -> String {
    let matches = |meaning: &Meaning| matches!(meaning, Meaning::Symbol(found) if *found == symbol);
    known.iter().find(|(_, meaning)| matches(meaning)).map_or_else(|| "t".into(), |(name, _)| name.clone())
}

/// An expression's text for a label: its beginning, when it is long.
pub fn shortened(text: String) -> String {
    const LONGEST: usize = 60;
    if text.chars().count() <= LONGEST { text } else { text.chars().take(LONGEST).chain(" …".chars()).collect() }
}

/// A monomial in the user's names.
pub fn describe(monomial: &Monomial, known: &[(String, Meaning)]) -> String {
    let factor = |(atom, exponent): &(Atom, i32)| {
        let base = match atom {
            Atom::Pi => "pi".into(),
            Atom::Symbol(symbol) => name_of(*symbol, known),
            Atom::Reciprocal(sum) => format!("1/({})", describe_poly(sum, known)),
            Atom::Call(Function::Pow, arguments) => {
                format!("({})^({})", describe_poly(&arguments[0], known), describe_poly(&arguments[1], known))
            }
            Atom::Call(function, arguments) => {
                let list: Vec<String> = arguments.iter().map(|a| describe_poly(a, known)).collect();
                format!("{}({})", function.name(), list.join(", "))
            }
        };
        if *exponent == 1 { base } else { format!("{base}^{exponent}") }
    };
    monomial.factors().iter().map(factor).collect::<Vec<_>>().join("*")
}

fn describe_poly(poly: &Poly, known: &[(String, Meaning)]) -> String {
    let term = |(monomial, coefficient): (&Monomial, &RBig)| {
        let what = describe(monomial, known);
        let number = decimal::show(coefficient.to_f64().value());
        match (what.is_empty(), *coefficient == RBig::ONE) {
            (true, _) => number,
            (false, true) => what,
            (false, false) => format!("{number}*{what}"),
        }
    };
    let text = poly.terms().map(term).collect::<Vec<_>>().join(" + ").replace("+ -", "- ");
    if text.is_empty() { "0".into() } else { text }
}

/// A node in the user's names, for comments.
pub fn text_of(node: &Node, known: &[(String, Meaning)]) -> String {
    let flat = |sign: &str, parts: &[(bool, Node)], first: [&str; 2]| {
        let mut text = String::new();
        for (place, (other, part)) in parts.iter().enumerate() {
            let link = match (place, other) {
                (0, other) => first[usize::from(*other)].to_owned(),
                (_, false) => sign[..3].to_owned(),
                (_, true) => sign[3..].to_owned(),
            };
            let inner = text_of(part, known);
            let wrap = matches!(part.kind, NodeKind::Sum(_)) && part.poly.terms().count() > 1 && parts.len() > 1;
            text += &if wrap { format!("{link}({inner})") } else { format!("{link}{inner}") };
        }
        text
    };
    match &node.kind {
        NodeKind::Constant => describe_poly(&node.poly, known),
        NodeKind::Symbol(symbol) => name_of(*symbol, known),
        NodeKind::Sum(parts) => flat(" +  - ", parts, ["", "-"]),
        NodeKind::Product(parts) => flat(" *  / ", parts, ["", "1 / "]).replace(" * ", "*").replace(" / ", "/"),
        NodeKind::Power(base, n) if matches!(base.kind, NodeKind::Symbol(_) | NodeKind::Call(..)) => {
            format!("{}^{n}", text_of(base, known))
        }
        NodeKind::Power(base, n) => format!("({})^{n}", text_of(base, known)),
        NodeKind::Call(Function::Pow, arguments) => {
            format!("({})^({})", text_of(&arguments[0], known), text_of(&arguments[1], known))
        }
        NodeKind::Call(function, arguments) => {
            let list: Vec<String> = arguments.iter().map(|a| text_of(a, known)).collect();
            format!("{}({})", function.name(), list.join(", "))
        }
    }
}
