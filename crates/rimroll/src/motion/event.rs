//! Events: extrema of the tilt, passages over the edge, changes of the contact, and endings.

use super::instant::Instant;

/// The kind of an event.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EventKind {
    /// A minimum of the tilt: the near-collision.
    TiltMin,
    /// A maximum of the tilt.
    TiltMax,
    /// The base is vertical, tilt π/2: a disk passes over its edge from one face to the other.
    OnEdge,
    /// Friction no longer suffices to hold the rim, which begins to slip.
    Slip,
    /// The slip has stopped and friction holds the rim, which rolls.
    Stick,
    /// The normal force is zero and about to become negative: the rim leaves the table.
    LiftOff,
    /// The rim strikes the table.
    Land,
    /// A body that stood flat begins to rock.
    Uplift,
    /// A body that rocked or wobbled stands flat again.
    Stand,
    /// The topple tilt is reached; the motion ends.
    Topple,
    /// The base lands flat; the motion ends.
    FaceDown,
    /// The energy has fallen to 1e-10 of its initial value or, if the base has come down flat under a
    /// resistance, to 1e-2 of it. The motion ends.
    Rest,
    /// Rigid-body mechanics with this friction has no unique solution; the motion ends.
    Painleve,
}

impl EventKind {
    /// The name that the user reads.
    pub fn name(self) -> &'static str {
        match self {
            EventKind::TiltMin => "tilt_min",
            EventKind::TiltMax => "tilt_max",
            EventKind::OnEdge => "on_edge",
            EventKind::Slip => "slip",
            EventKind::Stick => "stick",
            EventKind::LiftOff => "lift_off",
            EventKind::Land => "land",
            EventKind::Uplift => "uplift",
            EventKind::Stand => "stand",
            EventKind::Topple => "topple",
            EventKind::FaceDown => "face_down",
            EventKind::Rest => "rest",
            EventKind::Painleve => "painleve",
        }
    }
}

/// An event and the motion at that instant.
#[derive(Debug, Clone, Copy)]
pub struct Event {
    /// The kind of the event.
    pub kind: EventKind,
    /// The motion at the event.
    pub at: Instant,
}
