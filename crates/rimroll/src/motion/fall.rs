//! One fall: a motion followed through its first turn, of which only the outcome is kept.

use super::contacts::{Contacts, Phase};
use super::events::{EventKind, Goal};
use super::outcome::{Outcome, Tilting};
use super::run::Run;
use super::turns::{Turn, first_over, first_turn};
use super::{Options, Status};
use crate::body::Body;
use crate::contact_law::ContactLaw;
use crate::error::InvalidInput;
use crate::law::Parameters;
use crate::state::{Coordinates, State};
use core::ops::ControlFlow;
use std::sync::Arc;

/// What became of a body let go.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fall {
    /// What became of it.
    pub outcome: Outcome,
    /// How the motion ended; [`Status::Finished`] also when it rocks up to a tilt maximum.
    pub status: Status,
    /// From the release (or the tilt maximum after it) through the tilt minimum to the next tilt
    /// maximum, or to the ending if that comes first. None for a body that does not come down, and
    /// none where time or steps were up before: that turn has no end.
    pub turn: Option<Turn>,
    /// How it was when that was over, or at the end: before the side of a body that topples
    /// meets the table.
    pub end: EndState,
    /// Whether the rim slid on the way.
    pub slid: bool,
    /// Whether it left the table on the way.
    pub flew: bool,
    /// Steps of the solver.
    pub steps: usize,
}

/// How a body is at the end of a fall.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EndState {
    /// Time, s.
    pub t: f64,
    /// φ, rad.
    pub tilt: f64,
    /// ψ, rad.
    pub yaw: f64,
    /// s = θ̇ + ψ̇ cos φ, rad/s.
    pub axial_spin: f64,
    /// Energy lost to friction, J.
    pub friction_loss: f64,
    /// Energy lost to rolling resistance, pivoting friction and air, J.
    pub resistance_loss: f64,
    /// Energy lost in landings, J.
    pub impact_loss: f64,
}

impl EndState {
    /// What of the coordinates is kept.
    pub(crate) fn of(u: &Coordinates<f64>) -> EndState {
        EndState {
            t: u.t,
            tilt: u.tilt(),
            yaw: u.yaw,
            axial_spin: u.s,
            friction_loss: u.friction_loss,
            resistance_loss: u.resistance_loss,
            impact_loss: u.impact_loss,
        }
    }
}

/// What was seen of a body on its way through the first turn.
pub(crate) struct FallRecord {
    /// The first turn, as far as it went.
    pub turn: Option<Turn>,
    /// Whether it is over: the tilt was largest again.
    pub turned: bool,
    /// Whether the rim slid.
    pub slid: bool,
    /// Whether the rim left the table.
    pub flew: bool,
    /// Steps of the solver.
    pub steps: usize,
}

impl Fall {
    /// The fall of a body with these parameters that ended so.
    pub(crate) fn of(
        k: &Parameters<f64>,
        status: Status,
        seen: FallRecord,
        end: &Coordinates<f64>,
    ) -> Fall {
        let end = EndState::of(end);
        let tilting = Tilting {
            came_down: seen.turn.is_some(),
            turned: seen.turned,
            past_balance: k.is_past_balance(end.tilt),
        };
        let outcome = Outcome::of(status, tilting);
        Fall {
            outcome,
            status,
            turn: seen.turn.filter(|_| !outcome.is_cut_short()),
            end,
            slid: seen.slid,
            flew: seen.flew,
            steps: seen.steps,
        }
    }

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
    contact_law: &ContactLaw,
    options: &Options,
) -> Result<Fall, InvalidInput> {
    contact_law.check()?;
    let options = options.checked(body, start)?;
    let contacts = Contacts::new(body, contact_law, options.gravity, options.step_tolerance());
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
    let turned = first_over(start.cos > 0.0, &events);
    let over = turned.or_else(|| topple.map(|event| event.at.u));
    let end = over.unwrap_or_else(|| track.end().u);
    let seen = FallRecord {
        turn: first_turn(&start, &events, &end),
        turned: turned.is_some(),
        slid: was(Phase::Sliding, EventKind::Slip),
        flew: was(Phase::Flying, EventKind::LiftOff),
        steps: work.steps,
    };
    Ok(Fall::of(contacts.parameters(), status, seen, &end))
}
