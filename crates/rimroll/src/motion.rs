//! A whole motion, from the start until its time is up or rigid-body mechanics does not determine it further.
//!
//! [`simulate`] integrates the [`Coordinates`] with respect to τ. A motion consists of smooth phases of
//! rolling, sliding and flying, each under its own law, which are joined by events without
//! regularisation: `contacts` decides which law holds and what follows it, `event_detector` when a phase is over,
//! `slip_onset` integrates slip from rest, and `run` combines them.

mod contacts;
mod describe_ending;
mod event;
mod event_detector;
mod event_exclusion;
mod fall;
mod flat_landing;
mod instant;
mod level_base;
mod model_validity;
mod observables;
mod options;
mod outcome;
mod phase_dynamics;
mod phase_system;
mod run;
#[cfg(feature = "ground")]
mod sample_to_sample;
mod sensitivity;
mod shaken;
pub(crate) mod slip_onset;
mod step_record;
mod topple_tilt;
mod trajectory;
mod turns;

pub(crate) use contacts::Transition;
pub use contacts::{Contacts, STANDING_TILT};
pub use event::{Event, EventKind};
pub(crate) use fall::FallRecord;
pub use fall::{EndState, Fall, fall};
pub use flat_landing::{FlatLanding, Side};
pub use instant::{Instant, Phase};
use level_base::LevelBase;
pub use model_validity::{SPEED_OF_SOUND, UNEVENNESS, Validity};
use observables::observables;
pub use observables::{COLUMNS, Observables, Pose, pose};
pub use options::{Options, STANDARD_GRAVITY};
pub use outcome::Outcome;
pub(crate) use run::{pass_near_collision, stopped};
pub use sensitivity::{
    PARAMETERS, SHAKEN_PARAMETERS, Sensitivity, ShakenSensitivity, ShakenSlope, Slope,
};
#[cfg(feature = "ground")]
pub(crate) use shaken::{PreparedMotion, shaken_batch};
pub use shaken::{Shaken, shaken};
pub(crate) use topple_tilt::ToppleTilt;
pub use trajectory::{LookUp, Trajectory};
pub use turns::Turn;
pub(crate) use turns::direction_at_release;

pub use crate::ending::{Ending, EndingKind, FACE_DOWN_TILT, OnItsSide, STOPPED_TILT, Status};
pub use crate::number_format::AngleUnit;

use crate::body::Body;
use crate::contact_law::ContactLaw;
use crate::error::InvalidInput;
use crate::ground::Ground;
use crate::law::{Dynamics, FrictionLaw};
use crate::solve::Work;
use crate::state::{Coordinates, State};
use core::ops::ControlFlow;
use event_detector::Goal;
use run::Run;
use std::sync::Arc;

/// A computed motion.
pub struct Motion {
    /// The laws with the body's parameters, for forces and energies.
    pub contacts: Arc<Contacts>,
    /// Every accepted step, with dense output.
    pub trajectory: Trajectory,
    /// The events in order of time.
    pub events: Vec<Event>,
    /// The angles of turn.
    pub turns: Vec<Turn>,
    /// The way in which the motion ended.
    pub status: Status,
    /// The way in which the motion ended, with the time, the tilt and further numbers.
    pub ending: Ending,
    /// The work of the solver.
    pub work: Work,
    /// What followed where the whole base came down flat at once.
    flat: FlatLanding,
}

impl Motion {
    /// The law that holds at an instant of the motion.
    pub fn dynamics(&self, at: &Instant) -> &dyn Dynamics<f64> {
        self.contacts.dynamics(at.phase)
    }

    /// Whether the table moves.
    pub fn moves(&self) -> bool {
        self.contacts.moves()
    }

    /// The time at which the body overturned, s; `None` if it did not.
    pub fn overturning_time(&self) -> Option<f64> {
        let (k, end) = (self.contacts.parameters(), self.trajectory.end());
        shaken::overturning_time(k, self.status, &self.events, &end)
    }

    /// Whether the motion ended before it was determined whether the body overturns: it stopped early, the table still
    /// moved, or the body had enough energy to reach its balance tilt.
    pub fn is_undecided(&self) -> bool {
        let end = self.trajectory.end();
        shaken::is_undecided(&self.contacts, self.status, &self.events, &end)
    }

    /// Whether the body stands at the end and the table no longer moves.
    pub fn stands(&self) -> bool {
        shaken::stands(&self.contacts, self.status, &self.trajectory.end())
    }

    /// A sentence on how the motion ended, with angles in radians.
    pub fn message(&self) -> String {
        self.ending.sentence(AngleUnit::Radians)
    }

    /// All quantities at an instant of the motion.
    pub fn observables(&self, at: &Instant) -> Observables {
        let force = at
            .phase
            .is_level()
            .then(|| LevelBase::new(&self.contacts, at.yaw).force(at));
        observables(self.dynamics(at), at, force)
    }
}

/// Simulates the motion of a body from a start under a contact law. At the start the rim does not slip;
/// without friction, the centre of mass has no horizontal velocity.
///
/// `watch` is called every few hundred steps with the time reached (s); it can end the computation early.
///
/// # Errors
/// Refuses a start, a contact law or options outside their bounds. Whatever happens to a valid start is not
/// an error but a [`Status`].
pub fn simulate(
    body: &Body,
    start: &State,
    contact_law: impl Into<ContactLaw>,
    options: &Options,
    watch: impl FnMut(f64) -> ControlFlow<()>,
) -> Result<Motion, InvalidInput> {
    simulate_on(None, body, start, contact_law, options, watch)
}

/// As [`simulate`], on a table that moves with `ground`. Coordinates, velocities and energies are relative to the
/// table, which is at rest after the end of `ground`.
///
/// # Errors
/// As [`simulate`].
pub fn simulate_on(
    ground: Option<Arc<Ground>>,
    body: &Body,
    start: &State,
    contact_law: impl Into<ContactLaw>,
    options: &Options,
    mut watch: impl FnMut(f64) -> ControlFlow<()>,
) -> Result<Motion, InvalidInput> {
    let (options, contacts, start) = prepared(ground, body, start, &contact_law.into(), options)?;
    let goal = Goal::Time(options.duration);
    let mut run = Run::new(&contacts, &options, goal, start);
    let status = run.follow_to_the_end(&mut watch);
    let last_event = run.last_event();
    let (trajectory, events, work) = run.into_parts();
    Ok(Motion {
        turns: turns::turns(&start, &events),
        ending: describe_ending::describe_ending(
            (status, last_event),
            &contacts,
            &trajectory,
            &options,
            &work,
        ),
        contacts,
        trajectory,
        events,
        status,
        work,
        flat: options.flat,
    })
}

/// What a simulation begins with: its completed options, the laws with the body's parameters, and the coordinates at
/// the start.
fn prepared(
    ground: Option<Arc<Ground>>,
    body: &Body,
    start: &State,
    contact_law: &ContactLaw,
    options: &Options,
) -> Result<(Options, Arc<Contacts>, Coordinates<f64>), InvalidInput> {
    contact_law.check()?;
    let options = options.checked_standing_or_tilted(body, start)?;
    let (gravity, tolerance) = (options.gravity, options.step_tolerance());
    let contacts = Contacts::on_table(body, contact_law, ground, gravity, tolerance)
        .with_flat_gap(options.flat_gap);
    let mut start: Coordinates<f64> = contact_law.friction.start(start)?;
    if contacts.moves() && contact_law.friction == FrictionLaw::Frictionless {
        // Only on a table that moves is the slip without friction a coordinate.
        let [along, across] = contacts.parameters().rolling_velocity(&start);
        (start.slip_x, start.slip_y) = (-along, -across);
    }
    Ok((options, Arc::new(contacts), start))
}

#[cfg(test)]
mod tests;
