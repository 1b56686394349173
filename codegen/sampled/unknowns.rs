//! Unknown constants estimated together with the state (002).
//!
//! `x' = A x + ... + sum_i eps_i gamma_i`, `y = C x`: each `eps_i` becomes a state of the plant that does not
//! change ([`augment`]). Where its gamma is constant it is a column of A and a functional over the window
//! finds it with all others; where gamma varies, its response is computed in the step
//! ([`crate::estimator::window::regression`]). [`identifiable`] says which of them the outputs do not tell apart.

pub mod augment;
pub mod functions;
pub mod identifiable;
pub mod paper;
pub mod stages;
