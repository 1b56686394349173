//! What several modules share: plants as a person would write them down, the corpus, compilers.

pub mod collocation;
pub mod compile;
pub mod corpus;
pub mod depth;
pub mod fleet;
pub mod golden;
pub mod impulsive;
pub mod linear;
pub mod pages;
pub mod plant;
pub mod random_program;
pub mod truths;
