//! Several steps over one recording: what their estimates are worth beside each other.
//!
//! In go designs, a recording and the columns to compare with; out comes a score for each. All are scored over the same
//! rows, those on which every one of them has converged. Series are kept for that: 8 bytes a row for the time, and for
//! each specification and each reference.

pub mod group;
pub mod report;

mod contest;
mod entrant;
mod score;
mod track;

pub use contest::{Contest, Quantity, Rival};
pub use entrant::Entrant;
pub use group::Group;
pub use score::Score;
pub use track::Track;
