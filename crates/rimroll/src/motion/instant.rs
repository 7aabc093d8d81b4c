//! The state of a motion at an instant: its coordinates and the kind of contact.

use crate::state::Coordinates;
use core::ops::Deref;

/// Whether motions have phases in which the base is level. Those are compiled with moving tables only.
pub(super) const LEVEL_PHASES: bool = cfg!(feature = "ground");

/// The kind of contact between rim and table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Phase {
    /// The rim rolls: its lowest point is at rest.
    Rolling,
    /// The lowest point of the rim slips.
    Sliding,
    /// The rim is off the table.
    Flying,
    /// The base lies flat on the table and does not slip.
    Standing,
    /// The base lies flat on the table and slips.
    SlidingFlat,
    /// The base is level and off the table.
    FlyingLevel,
    /// The body lies on its side: the end of a motion that topples.
    Lying,
}

impl Phase {
    /// Whether the base is level, so that the tilt is zero.
    pub fn is_level(self) -> bool {
        LEVEL_PHASES
            && matches!(
                self,
                Phase::Standing | Phase::SlidingFlat | Phase::FlyingLevel
            )
    }

    /// The name that users read.
    pub fn name(self) -> &'static str {
        match self {
            Phase::Rolling => "rolling",
            Phase::Sliding => "sliding",
            Phase::Flying => "flying",
            Phase::Standing => "standing",
            Phase::SlidingFlat => "sliding_flat",
            Phase::FlyingLevel => "flying_level",
            Phase::Lying => "lying",
        }
    }
}

/// The coordinates and the phase at an instant.
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
