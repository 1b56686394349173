//! What adds up in an estimate over the calls, in magnitudes.

use nalgebra::DMatrix;

use crate::plant::Plant;

/// Sums of magnitudes, per state.
#[derive(Clone, Debug)]
pub(in super::super) struct Sums {
    /// Per output.
    pub(in super::super) noise: DMatrix<f64>,
    /// Per output, of squares.
    pub(in super::super) squares: DMatrix<f64>,
    /// Per disturbance.
    pub(in super::super) disturbances: DMatrix<f64>,
    /// Per signal.
    pub(in super::super) signals: DMatrix<f64>,
    /// Per coordinate that the step carries, what is added to it at every call.
    pub(in super::super) carried: DMatrix<f64>,
    /// Per output, of the terms that its correction is the sum of.
    pub(in super::super) gained: DMatrix<f64>,
}

impl Sums {
    pub(in super::super) fn new(plant: &Plant, signals: usize) -> Self {
        let zeros = |columns: usize| DMatrix::zeros(plant.states.len(), columns);
        let p = plant.outputs.len();
        Self {
            noise: zeros(p),
            squares: zeros(p),
            disturbances: zeros(plant.disturbances.len()),
            signals: zeros(signals),
            carried: zeros(plant.states.len()),
            gained: zeros(p),
        }
    }

    pub(super) fn add_noise(&mut self, gains: &DMatrix<f64>) {
        self.noise += gains.abs();
        self.squares += gains.component_mul(gains);
    }
}
