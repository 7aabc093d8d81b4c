//! One fall: a motion through its first turn, of which only the outcome is kept.

use super::Motion;
use super::contacts::Contacts;
use super::event::{Event, EventKind};
use super::event_detector::Goal;
use super::instant::Phase;
use super::options::Options;
use super::outcome::{Outcome, TiltHistory};
use super::run::Run;
use super::trajectory::Trajectory;
use super::turns::{Turn, end_of_first_turn, first_turn};
use crate::body::Body;
use crate::contact_law::ContactLaw;
use crate::ending::Status;
use crate::error::InvalidInput;
use crate::law::Parameters;
use crate::state::{Coordinates, State};
use core::ops::ControlFlow;
use std::sync::Arc;

/// The result of a fall.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fall {
    /// The outcome.
    pub outcome: Outcome,
    /// The way in which the motion ended; [`Status::Finished`] also if it rocked up to a tilt maximum.
    pub status: Status,
    /// The turn from the release (or the tilt maximum after it) through the tilt minimum to the next tilt
    /// maximum, or to the end of the motion if that comes first. `None` for a body that does not come down,
    /// and where the time or the steps ran out before the end of the turn.
    pub turn: Option<Turn>,
    /// The state at the end of that turn, or at the end of the motion. For a body that topples, it is the
    /// state before its side meets the table.
    pub end: EndState,
    /// Whether the rim slid.
    pub slid: bool,
    /// Whether the rim left the table.
    pub flew: bool,
    /// The number of steps of the solver.
    pub steps: usize,
}

/// The state of a body at the end of a fall.
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
    /// Energy lost to rolling resistance, pivoting friction and air drag, J.
    pub resistance_loss: f64,
    /// Energy lost in impacts, J.
    pub impact_loss: f64,
}

impl EndState {
    pub(crate) fn new(u: &Coordinates<f64>) -> EndState {
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

/// The facts about a first turn from which the result of a fall is made.
pub(crate) struct FallRecord {
    /// The first turn, complete or not.
    pub turn: Option<Turn>,
    /// Whether the turn is complete: the tilt reached a maximum again.
    pub turned: bool,
    /// Whether the rim slid.
    pub slid: bool,
    /// Whether the rim left the table.
    pub flew: bool,
    /// The number of steps of the solver.
    pub steps: usize,
}

impl Fall {
    /// The result of a fall that ended with `status` at `end`.
    pub(crate) fn new(
        k: &Parameters<f64>,
        status: Status,
        record: FallRecord,
        end: &Coordinates<f64>,
    ) -> Fall {
        let end = EndState::new(end);
        let tilting = TiltHistory {
            came_down: record.turn.is_some(),
            turned: record.turned,
            past_balance: k.is_past_balance(end.tilt),
        };
        let outcome = Outcome::of(status, tilting);
        Fall {
            outcome,
            status,
            turn: record.turn.filter(|_| !outcome.is_cut_short()),
            end,
            slid: record.slid,
            flew: record.flew,
            steps: record.steps,
        }
    }

    /// Energy lost to friction, resistance and impacts, J.
    pub fn energy_lost(&self) -> f64 {
        self.end.friction_loss + self.end.resistance_loss + self.end.impact_loss
    }
}

/// Whether the first turn of a motion is complete, and the coordinates at its end: the tilt maximum, the toppling or the
/// end of the motion, whichever comes first.
fn end_of_fall(trajectory: &Trajectory, events: &[Event]) -> (bool, Coordinates<f64>) {
    let topple = events.iter().find(|event| event.kind == EventKind::Topple);
    let turned = end_of_first_turn(trajectory.start().cos > 0.0, events);
    let over = turned.or_else(|| topple.map(|event| event.at.u));
    (turned.is_some(), over.unwrap_or_else(|| trajectory.end().u))
}

impl Motion {
    /// The turn of [`fall`] from the same start: the first of the turns or, in a motion that ends before its first turn
    /// does, the turn up to that ending. `None` for a body that does not come down, and where the time or the steps ran
    /// out first.
    pub fn first_turn(&self) -> Option<Turn> {
        let (turned, end) = end_of_fall(&self.trajectory, &self.events);
        let ran_out = matches!(
            self.status,
            Status::Finished | Status::Failed | Status::Interrupted
        );
        first_turn(&self.trajectory.start(), &self.events, &end).filter(|_| turned || !ran_out)
    }
}

/// Simulates a body from a start through its first turn, at most for the duration in `options`.
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
    let start = contact_law.friction.start(start)?;
    let mut run = Run::new(&contacts, &options, Goal::Turn(options.duration), start);
    let status = run.follow_to_the_end(&mut |_| ControlFlow::Continue(()));
    let (trajectory, events, work) = run.into_parts();
    let occurred = |phase, first_event| {
        let later = events.iter().any(|event| event.kind == first_event);
        trajectory.start().phase == phase || later
    };
    let (turned, end) = end_of_fall(&trajectory, &events);
    let record = FallRecord {
        turn: first_turn(&start, &events, &end),
        turned,
        slid: occurred(Phase::Sliding, EventKind::Slip),
        flew: occurred(Phase::Flying, EventKind::LiftOff),
        steps: work.steps,
    };
    Ok(Fall::new(contacts.parameters(), status, record, &end))
}
