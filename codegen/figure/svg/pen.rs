//! What curves stand for, and how they are drawn for it.

/// What a curve stands for, which determines how it is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// Pale grey, at the bottom; dots when there is room for them.
    Measured,
    /// Black, wide and pale.
    Reference,
    /// Vermilion.
    Error,
    /// Blue, on top.
    Estimate,
    /// One of several estimates, in a colour of its own.
    Rival(usize),
    /// The error of one of several estimates, in the same colour.
    RivalError(usize),
}

/// How curves of a role are drawn.
pub(super) struct Pen {
    pub(super) colour: &'static str,
    /// For text, dark enough to be read on white.
    pub(super) text: &'static str,
    pub(super) width: f64,
    pub(super) opacity: f64,
    pub(super) dashed: bool,
}

/// Colours of rivals, for lines and for text; behind the last one they come again, dashed.
const RIVALS: [(&str, &str); 7] = [
    ("#0072b2", "#0072b2"),
    ("#d55e00", "#c05000"),
    ("#009e73", "#007a59"),
    ("#cc79a7", "#a8487e"),
    ("#e69f00", "#946600"),
    ("#56b4e9", "#2178a8"),
    ("#8c6d46", "#75592f"),
];

impl Pen {
    /// The attribute of a dashed line, behind others.
    pub(super) const fn dash(&self) -> &'static str {
        if self.dashed { r#" stroke-dasharray="6 3""# } else { "" }
    }
}

impl Role {
    /// Curves of a higher layer are drawn over those of a lower one.
    pub(super) const fn layer(self) -> u8 {
        match self {
            Self::Measured => 0,
            Self::Reference => 1,
            Self::Error | Self::RivalError(_) => 2,
            Self::Estimate | Self::Rival(_) => 3,
        }
    }

    /// Whether it is a difference, which is seen against zero.
    pub(super) const fn is_error(self) -> bool {
        matches!(self, Self::Error | Self::RivalError(_))
    }

    pub(super) fn pen(self) -> Pen {
        let pen = |colour, text, width, opacity| Pen { colour, text, width, opacity, dashed: false };
        match self {
            Self::Measured => pen("#b4b4b4", "#737373", 2.25, 1.0),
            Self::Reference => pen("#000000", "#444444", 2.5, 0.4),
            Self::Error => pen("#d55e00", "#c05000", 1.0, 1.0),
            Self::Estimate => pen("#0072b2", "#0072b2", 1.15, 1.0),
            Self::Rival(place) | Self::RivalError(place) => {
                let (colour, text) = RIVALS[place % RIVALS.len()];
                Pen { colour, text, width: 1.15, opacity: 1.0, dashed: place >= RIVALS.len() }
            }
        }
    }
}
