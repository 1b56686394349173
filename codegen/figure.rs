//! Pictures of replays.
//!
//! Knows replays, curves, colours and SVG. Never knows a recording's text, a disk, a terminal, arguments or exit codes.
//!
//! [`Curves`] draws one replay while it runs, [`of_contest`] several steps beside each other; both give a [`Figure`],
//! whose `to_string` is the SVG. A figure of anything else is made of [`Panel`]s and [`Curve`]s in the same way. Memory
//! does not grow with the curves: [`Thin`] keeps what a plot can show.

mod contest;
mod curves;
mod svg;
mod thin;

pub use contest::of_contest;
pub use curves::Curves;
pub use svg::{Cell, Column, Curve, Entry, Figure, Marker, Panel, Point, Role};
pub use thin::Thin;
