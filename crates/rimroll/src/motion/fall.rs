//! One fall: a motion followed through its first turn, of which only the outcome is kept.

use super::contacts::{Contacts, Phase};
use super::events::{EventKind, Goal};
use super::run::Run;
use super::turns::{Turn, first_over, first_turn};
use super::{Options, Status};
use crate::body::Body;
use crate::error::InvalidInput;
use crate::solve::Work;
use crate::state::{Coordinates, State};
use crate::surface::Surface;
use core::ops::ControlFlow;
use std::sync::Arc;

/// What became of a body let go.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fall {
    /// How it ended; [`Status::Finished`] also when it rocks up to a tilt maximum.
    pub status: Status,
    /// From the release (or the tilt maximum after it) through the tilt minimum to the next tilt
    /// maximum, or to the ending if that comes first; none for a body that does not come down.
    pub turn: Option<Turn>,
    /// Where it was when that was over, or at the end: before the side of a body that topples
    /// meets the table.
    pub end: Coordinates<f64>,
    /// Whether the rim slid on the way.
    pub slid: bool,
    /// Whether it left the table on the way.
    pub flew: bool,
    /// What it cost.
    pub work: Work,
}

impl Fall {
    /// Energy lost on the way to friction, resistance and impacts, J.
    pub fn energy_lost(&self) -> f64 {
        self.end.friction_loss + self.end.resistance_loss + self.end.impact_loss
    }
}

/// Follows a body from a start through its first turn, at most for the options' duration.
///
/// # Errors
/// As [`simulate`](super::simulate).
pub fn fall(
    body: &Body,
    start: &State,
    surface: &Surface,
    options: &Options,
) -> Result<Fall, InvalidInput> {
    surface.check()?;
    let options = options.checked(body, start)?;
    let contacts = Contacts::new(body, surface, options.gravity, options.step_tolerance());
    let contacts = Arc::new(contacts);
    let start = Coordinates::from_state(start);
    let mut run = Run::new(&contacts, &options, Goal::Turn(options.duration), start);
    let status = run.follow_to_the_end(&mut |_| ControlFlow::Continue(()));
    let (track, events, work) = run.into_parts();
    let was = |phase, begins| {
        let later = events.iter().any(|event| event.kind == begins);
        track.start().phase == phase || later
    };
    let topple = events.iter().find(|event| event.kind == EventKind::Topple);
    let over = first_over(&events).or_else(|| topple.map(|event| event.at.u));
    let end = over.unwrap_or_else(|| track.end().u);
    Ok(Fall {
        turn: first_turn(&start, &events, &end),
        slid: was(Phase::Sliding, EventKind::Slip),
        flew: was(Phase::Flying, EventKind::LiftOff),
        status,
        end,
        work,
    })
}
