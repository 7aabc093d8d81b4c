//! The state of a motion at a moment: its coordinates and the kind of contact.

use crate::state::Coordinates;
use core::ops::Deref;

/// The kind of contact between rim and table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Phase {
    /// The rim rolls: its lowest point is at rest.
    Rolling,
    /// The lowest point of the rim slips.
    Sliding,
    /// The rim is off the table.
    Flying,
    /// The body lies on its side: the end of a motion that topples.
    Lying,
}

impl Phase {
    /// The name that users read.
    pub fn name(self) -> &'static str {
        match self {
            Phase::Rolling => "rolling",
            Phase::Sliding => "sliding",
            Phase::Flying => "flying",
            Phase::Lying => "lying",
        }
    }
}

/// The coordinates and the phase at a moment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Instant {
    /// The phase, which determines the law that holds.
    pub phase: Phase,
    /// The coordinates.
    pub u: Coordinates<f64>,
}

impl Deref for Instant {
    type Target = Coordinates<f64>;

    fn deref(&self) -> &Coordinates<f64> {
        &self.u
    }
}
