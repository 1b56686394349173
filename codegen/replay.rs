//! Recordings through a step.
//!
//! Knows rows, a Program's fields and what estimates are worth. Never knows a disk, a terminal, arguments or exit codes.
//!
//! In go a design and the bytes of a recording, CSV with a header; out come the estimates row by row, as numbers, and a
//! [`Verdict`]. The step runs in the interpreter, which gives the bits of the generated Rust and C. Memory does not grow
//! with the recording, but for [`compare`], which keeps what it ranks.
//!
//! ```
//! use deadbeat_codegen::Generator;
//! use deadbeat_codegen::figure::Curves;
//! use deadbeat_codegen::replay::{Recording, Replay, Signals};
//!
//! let spec = r#"
//! deadbeat = 1
//! name = "cart"
//! [states]
//! x = { unit = "m", derivative = 'v' }
//! v = { unit = "m/s", derivative = '0' }
//! [outputs]
//! x = { value = 'x' }
//! [observer.window]
//! window = 0.2
//! [target]
//! sample_time = 0.1
//! scalar = "f64"
//! "#;
//! let generated = Generator::new(spec, "cart.toml").design().expect("a right specification");
//!
//! // From any reader; a column that is named like a state is what its estimate is compared with.
//! let text = "t,x,v\n0.0,1.0,2\n0.1,1.2,2\n0.2,1.4,2\n0.3,1.6,2\n";
//! let recording = Recording::open(text.as_bytes(), "cart.csv")?;
//! let mut replay = Replay::new(&generated, recording, &Signals::default())?;
//! let mut curves = Curves::new(&replay);
//! for step in replay.by_ref() {
//!     let step = step?;
//!     println!("{} s: {:?}, {:?}", step.sample.t, step.sample.estimate, step.sample.status);
//!     curves.add(&step);
//! }
//!
//! let verdict = replay.verdict();
//! assert_eq!((verdict.rows, verdict.converged_from), (4, Some(3)));
//! assert!(verdict.errors("v").and_then(|errors| errors.max).expect("it is compared") < 1e-14);
//! let svg = curves.figure(&verdict).to_string();
//! assert!(svg.starts_with("<svg"));
//! # Ok::<(), deadbeat_codegen::replay::ReplayError>(())
//! ```

pub mod compare;

mod clock;
mod columns;
mod grid;
mod interface;
mod mistake;
mod over;
mod recording;
mod residual;
mod selection;
mod signals;
mod steps;
mod verdict;

pub use clock::TimeUnit;
pub use grid::TimeError;
pub use interface::{Answer, Count, Interface, Measured, MeasuredKind};
pub use mistake::{ReplayError, SignalError};
pub use over::{Replay, Step};
pub use recording::{Recording, RecordingError};
pub use residual::Residual;
pub use signals::Signals;
pub use steps::{Row, Sample, Steps};
pub use verdict::{Compared, Errors, Verdict};

pub(crate) use interface::{fold, number};
