//! What is known at each sample besides the outputs.

/// Something known at each sample.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Signal {
    /// What it is.
    pub source: Source,
    /// Which part of a sample interval its value is of.
    pub part: Part,
    /// In the user's names.
    pub text: String,
}

/// What a signal is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// An input of the plant.
    Input(usize),
    /// A nonlinear injection of the plant.
    Injection(usize),
}

/// Which part of a sample interval a signal's value is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// Constant since the previous call.
    Held,
    /// Straight from sample to sample: the value now.
    Runs,
    /// A cubic through four samples: the value now.
    Curves,
    /// Evaluated at the previous sample with the input since then: the interval's start.
    Start,
    /// Evaluated at the sample now with the input until now: the interval's end.
    End,
}

impl Part {
    /// Calls between the sample that M counts by and the call that brings the value.
    pub const fn lag(self) -> usize {
        match self {
            Self::Held | Self::Start => 1,
            Self::Runs | Self::Curves | Self::End => 0,
        }
    }
}
