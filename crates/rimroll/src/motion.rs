//! A whole motion, from the start until its time is up or rigid-body mechanics does not determine it further.
//!
//! [`simulate`] integrates the [`Coordinates`] with respect to τ. A motion consists of smooth phases of
//! rolling, sliding and flying, each under its own law, which are joined by events without
//! regularisation: `contacts` decides which law holds and what follows it, `events` when a phase is over,
//! `onset` integrates slip from rest, and `run` combines them.

mod contacts;
mod ending;
mod events;
mod fall;
mod mechanics;
mod moment;
mod onset;
mod outcome;
mod phase_dynamics;
mod run;
mod sensitivity;
mod step_bounds;
mod step_record;
mod track;
mod turns;

pub(crate) use contacts::Transition;
pub use contacts::{Contacts, Phase};
pub use ending::{AngleUnit, Ending, EndingKind, OnItsSide};
pub use events::{Event, EventKind};
pub(crate) use fall::FallRecord;
pub use fall::{EndState, Fall, fall};
pub use moment::{COLUMNS, Moment, Pose, moment, pose};
pub use outcome::Outcome;
pub(crate) use run::{pass_near_collision, stopped};
pub use sensitivity::{PARAMETERS, Sensitivity, Slope};
pub use track::{Instant, LookUp, Track};
pub use turns::Turn;
pub(crate) use turns::direction_at_release;

use crate::body::Body;
use crate::contact_law::ContactLaw;
use crate::error::{InvalidInput, bounded, positive};
use crate::law::Dynamics;
use crate::solve::Work;
use crate::state::{Coordinates, State};
use core::f64::consts::{FRAC_PI_2, PI};
use core::ops::ControlFlow;
use events::Goal;
use run::Run;
use std::sync::Arc;

/// Standard gravity, m/s² (exact by convention). The paper used 9.8.
pub const STANDARD_GRAVITY: f64 = 9.80665;

/// Below this tilt (rad) the base counts as flat on the table: the contact point would run round the
/// rim in less time than the last digit of t can resolve.
pub const FACE_DOWN_TILT: f64 = 1e-16;

/// Below this tilt (rad) the base also counts as flat if resistance has stopped the contact point on the
/// rim for good: the gap under the rim is then smaller than an atom.
pub const STOPPED_TILT: f64 = 1e-9;

/// Options of a simulation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options {
    /// The duration of the motion, s.
    pub duration: f64,
    /// g, m/s².
    pub gravity: f64,
    /// The target error over tens of rocking motions, relative to the error scale of each coordinate. Below
    /// 1e-13 rounding dominates. The error of a step may be a fiftieth of `rtol`, and the errors add up:
    /// after thousands of steps the energy can be off by a few hundred times `rtol`.
    pub rtol: f64,
    /// The tilt at which the body counts as toppled, rad. `None` means π/2 for a body with height, where
    /// its side meets the table, and no limit for a disk, which can stand on its edge and fall to either
    /// face.
    pub topple_tilt: Option<f64>,
    /// The maximal number of steps.
    pub max_steps: usize,
}

impl Default for Options {
    fn default() -> Self {
        Options {
            duration: 2.0,
            gravity: STANDARD_GRAVITY,
            rtol: 1e-10,
            topple_tilt: None,
            max_steps: 1_000_000,
        }
    }
}

impl Options {
    /// The tolerance of one step, relative to the error scale of each coordinate.
    ///
    /// The errors of the steps add up, so the tolerance of a step is a fiftieth of `rtol`. Measured over 20
    /// rocking motions of a can, a disk, a coin and a bottle under both ideal laws, the error of the energy
    /// is then at most 0.4 rtol, and those of the yaw and of the times of the near-collisions at most 2 rtol.
    /// Below 5e-15 the error estimate would consist of rounding errors.
    pub(crate) fn step_tolerance(&self) -> f64 {
        (0.02 * self.rtol).max(5e-15)
    }

    /// The index of the first body and start from which no motion can be computed, if there is one.
    pub fn first_refused<'a>(
        &self,
        starts: impl IntoIterator<Item = (&'a Body, State)>,
    ) -> Option<usize> {
        let mut checks = self.checks(starts);
        checks.position(|check| check.is_err())
    }

    /// Checks many bodies and starts.
    pub(crate) fn check_all<'a>(
        &self,
        starts: impl IntoIterator<Item = (&'a Body, State)>,
    ) -> Result<(), InvalidInput> {
        // An empty list does not make invalid options acceptable.
        self.check_numbers()?;
        self.checks(starts).collect()
    }

    fn checks<'a>(
        &self,
        starts: impl IntoIterator<Item = (&'a Body, State)>,
    ) -> impl Iterator<Item = Result<(), InvalidInput>> {
        let mut last: Option<(&Body, Options)> = None;
        starts.into_iter().map(move |(body, start)| {
            let options = match last {
                Some((known, options)) if known == body => options,
                _ => self.completed(body)?,
            };
            last = Some((body, options));
            options.check(&start)
        })
    }

    /// Checks the options and a start, and fills in the body's default topple tilt.
    pub(crate) fn checked(self, body: &Body, start: &State) -> Result<Options, InvalidInput> {
        let options = self.completed(body)?;
        options.check(start)?;
        Ok(options)
    }

    /// Checks the options and fills in the body's default topple tilt.
    fn completed(mut self, body: &Body) -> Result<Options, InvalidInput> {
        self.check_numbers()?;
        self.topple_tilt = self.topple_tilt_of(body);
        if let Some(topple) = self.topple_tilt {
            // Beyond this tilt the centre of mass would be below the table.
            let max = (FRAC_PI_2 + body.balance_tilt()).min(PI);
            let within = topple > 0.0 && (topple <= FRAC_PI_2 || topple < max);
            if !within {
                // The text is formatted only on failure, because this check runs for every body.
                let bound =
                    format!("inside (0, {max}), where the centre of mass is over the table");
                bounded("topple_tilt", topple, |_| false, &bound, "rad")?;
            }
        }
        Ok(self)
    }

    /// The tilt (rad) at which a body counts as toppled, if there is one.
    pub(crate) fn topple_tilt_of(&self, body: &Body) -> Option<f64> {
        let has_side = body.height() > 0.0;
        self.topple_tilt.or_else(|| has_side.then_some(FRAC_PI_2))
    }

    /// Checks the options that do not depend on the body.
    fn check_numbers(&self) -> Result<(), InvalidInput> {
        positive("duration", self.duration, "s")?;
        positive("gravity", self.gravity, "m/s2")?;
        bounded(
            "rtol",
            self.rtol,
            |rtol| (1e-14..=1e-3).contains(&rtol),
            "between 1e-14 and 1e-3",
            "",
        )?;
        if self.max_steps == 0 {
            return Err(InvalidInput::OutOfBounds {
                field: "max_steps",
                value: 0.0,
                bound: ">= 1".to_owned(),
                unit: "",
            });
        }
        Ok(())
    }

    /// Checks a start against completed options.
    pub(crate) fn check(&self, start: &State) -> Result<(), InvalidInput> {
        start.check()?;
        if let Some(topple) = self.topple_tilt
            && start.tilt >= topple
        {
            // The text is formatted only on failure, because this check runs for every start.
            let bound = format!("below topple_tilt = {topple} rad");
            bounded("tilt", start.tilt, |_| false, &bound, "rad")?;
        }
        Ok(())
    }
}

/// The way in which a motion ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Status {
    /// The duration was reached.
    Finished,
    /// The topple tilt was reached.
    Toppled,
    /// The normal force would have become negative, under a law without flight.
    LiftedOff,
    /// The whole rim met the table at once.
    FaceDown,
    /// The energy is spent, and the body lies flat.
    AtRest,
    /// The Painlevé paradox: rigid-body mechanics with this friction has no unique solution.
    Painleve,
    /// The solver could not continue.
    Failed,
    /// The caller stopped the computation.
    Interrupted,
}

impl Status {
    /// All statuses in the order of their codes, `status as usize`.
    pub const ALL: [Status; 8] = [
        Status::Finished,
        Status::Toppled,
        Status::LiftedOff,
        Status::FaceDown,
        Status::AtRest,
        Status::Painleve,
        Status::Failed,
        Status::Interrupted,
    ];

    /// The name that the user reads.
    pub fn name(self) -> &'static str {
        match self {
            Status::Finished => "finished",
            Status::Toppled => "toppled",
            Status::LiftedOff => "lifted_off",
            Status::FaceDown => "face_down",
            Status::AtRest => "at_rest",
            Status::Painleve => "painleve",
            Status::Failed => "failed",
            Status::Interrupted => "interrupted",
        }
    }
}

/// A computed motion.
pub struct Motion {
    /// The laws with the body's parameters, for forces and energies.
    pub contacts: Arc<Contacts>,
    /// Every accepted step, with dense output.
    pub track: Track,
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
}

impl Motion {
    /// The law that holds at an instant of the motion.
    pub fn dynamics(&self, at: &Instant) -> &dyn Dynamics<f64> {
        self.contacts.dynamics(at.phase)
    }

    /// The derivatives of the motion with respect to its initial state, its body and gravity. They cost about
    /// thirty times as much as the motion itself.
    ///
    /// `watch` is called every few hundred steps with the time (s) that the derivatives have reached,
    /// beginning with 0. If it breaks, the result is `None`.
    ///
    /// # Errors
    /// Refuses a motion that is not a smooth function of these parameters. Only rolling without slip and
    /// sliding without friction are supported, each for the whole motion and without resistance.
    pub fn sensitivity(
        &self,
        mut watch: impl FnMut(f64) -> ControlFlow<()>,
    ) -> Result<Option<Sensitivity>, InvalidInput> {
        Sensitivity::new(self, &mut watch)
    }

    /// A sentence on how the motion ended, with angles in radians.
    pub fn message(&self) -> String {
        self.ending.sentence(AngleUnit::Radians)
    }

    /// All quantities at an instant of the motion.
    pub fn moment(&self, at: &Instant) -> Moment {
        moment(self.dynamics(at), at)
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
    mut watch: impl FnMut(f64) -> ControlFlow<()>,
) -> Result<Motion, InvalidInput> {
    let contact_law = contact_law.into();
    contact_law.check()?;
    let options = options.checked(body, start)?;
    let contacts = Contacts::new(
        body,
        &contact_law,
        options.gravity,
        options.step_tolerance(),
    );
    let contacts = Arc::new(contacts);
    let start = Coordinates::from_state(start);
    let goal = Goal::Time(options.duration);
    let mut run = Run::new(&contacts, &options, goal, start);
    let status = run.follow_to_the_end(&mut watch);
    let last_event = run.last_event();
    let (track, events, work) = run.into_parts();
    Ok(Motion {
        turns: turns::turns(&start, &events),
        ending: Ending::new((status, last_event), &contacts, &track, &options, &work),
        contacts,
        track,
        events,
        status,
        work,
    })
}
