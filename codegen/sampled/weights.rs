//! Constants of a design times values, as operations; what is structurally zero is not written.

use crate::program::Value;
use crate::program::builder::Builder;

use super::settled::Settled;

/// A constant of a design.
pub(crate) fn constant(b: &mut Builder, value: Settled) -> Value {
    let value = value.value(b.scalar());
    b.float(value)
}

/// A constant of a design times a value.
pub(crate) fn product(b: &mut Builder, weight: Settled, value: Value) -> Value {
    let weight = constant(b, weight);
    b.mul(weight, value)
}

/// Weights times values, each that there is.
pub(crate) fn terms<'a>(
    b: &mut Builder,
    pairs: impl IntoIterator<Item = (&'a Option<Settled>, &'a Value)>,
) -> Vec<Value> {
    let mut terms = Vec::new();
    for (weight, value) in pairs {
        if let Some(weight) = weight {
            terms.push(product(b, *weight, *value));
        }
    }
    terms
}

/// Adds weights times values to the terms of a sum.
pub(crate) fn push_products(b: &mut Builder, sum: &mut Vec<Value>, weights: &[Option<Settled>], values: &[Value]) {
    sum.extend(terms(b, weights.iter().zip(values)));
}

/// A row of weights times values.
pub(crate) fn row(b: &mut Builder, weights: &[Option<Settled>], values: &[Value]) -> Value {
    let terms = terms(b, weights.iter().zip(values));
    b.sum(&terms)
}

/// A matrix times values.
pub(crate) fn products(b: &mut Builder, matrix: &[Vec<Option<Settled>>], values: &[Value]) -> Vec<Value> {
    matrix.iter().map(|weights| row(b, weights, values)).collect()
}
