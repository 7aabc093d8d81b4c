//! A whole motion: from the start until time is up or mechanics has no more to say.
//!
//! [`simulate`] steps through the [`Coordinates`] by the solver's clock τ. A motion is made of phases,
//! rolling, sliding and flying, each smooth and with its own law; events join them without
//! regularisation: `contacts` says which law holds and what follows, `events` when a phase is over,
//! `onset` how slip comes out of rest, `run` puts them together.

mod contacts;
mod events;
mod fall;
mod mechanics;
mod message;
mod moment;
mod onset;
mod outcome;
mod run;
mod sensitivity;
mod step_bounds;
mod step_record;
mod track;
mod turns;

pub(crate) use contacts::Transition;
pub use contacts::{Contacts, Phase};
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
use message::message;
use run::Run;
use std::sync::Arc;

/// Standard gravity, m/s² (exact by convention). The paper used 9.8.
pub const STANDARD_GRAVITY: f64 = 9.80665;

/// Below this tilt (rad) the base counts as flat on the table: the contact point would run round the
/// rim in less time than the last digit of t can tell.
pub const FACE_DOWN_TILT: f64 = 1e-16;

/// Below this tilt (rad) the base counts as flat, too, once resistance has stopped the contact point on the
/// rim for good ([`Contacts::has_stopped_running`]): the rim is then over the table by less than an atom's
/// width.
pub const STOPPED_TILT: f64 = 1e-9;

/// How to simulate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options {
    /// How long to follow the motion, s.
    pub duration: f64,
    /// g, m/s².
    pub gravity: f64,
    /// Error to aim at over some tens of rockings, relative to the size of each coordinate; from 1e-13
    /// on rounding decides. A step may err by a fiftieth of it, and the errors of steps add up: after thousands
    /// of steps the energy can be off by some hundred times `rtol`.
    pub rtol: f64,
    /// The tilt at which the body counts as toppled, rad. `None`: π/2 for a body with height, where
    /// its side meets the table; never for a disk, which may stand on its edge and fall to either
    /// face.
    pub topple_tilt: Option<f64>,
    /// Most steps to make before giving up.
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
    /// What one step may err, relative to the size of each coordinate.
    ///
    /// Errors add up from step to step, so a step is held to a fiftieth of `rtol`. Measured over 20
    /// rockings of a can, a disk, a coin and a bottle under both ideal laws, the energy then keeps to
    /// 0.4 rtol, and the yaw and the times of the near-collisions to 2 rtol. Below 5e-15 rounding
    /// would be taken for error.
    pub(crate) fn step_tolerance(&self) -> f64 {
        (0.02 * self.rtol).max(5e-15)
    }

    /// Which of many bodies and starts are the first from which no motion can be computed, if any are.
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
        // Also where nothing starts.
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

    /// Checks the numbers and a start, and fills in the body's own topple tilt.
    pub(crate) fn checked(self, body: &Body, start: &State) -> Result<Options, InvalidInput> {
        let options = self.completed(body)?;
        options.check(start)?;
        Ok(options)
    }

    /// Checks the numbers and fills in the body's own topple tilt.
    fn completed(mut self, body: &Body) -> Result<Options, InvalidInput> {
        self.check_numbers()?;
        self.topple_tilt = self.topple_tilt_of(body);
        if let Some(topple) = self.topple_tilt {
            // Past this tilt the centre of mass would be under the table.
            let most = (FRAC_PI_2 + body.balance_tilt()).min(PI);
            let within = topple > 0.0 && (topple <= FRAC_PI_2 || topple < most);
            if !within {
                // Put into words only where it is needed: this is asked of every body.
                let bound =
                    format!("inside (0, {most}), where the centre of mass is over the table");
                bounded("topple_tilt", topple, |_| false, &bound, "rad")?;
            }
        }
        Ok(self)
    }

    /// The tilt (rad) at which a body counts as toppled, if at any.
    pub(crate) fn topple_tilt_of(&self, body: &Body) -> Option<f64> {
        let has_side = body.height() > 0.0;
        self.topple_tilt.or_else(|| has_side.then_some(FRAC_PI_2))
    }

    /// Checks the numbers that bound any motion, of whatever body.
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

    /// Checks a start, by options that are complete.
    pub(crate) fn check(&self, start: &State) -> Result<(), InvalidInput> {
        start.check()?;
        if let Some(topple) = self.topple_tilt
            && start.tilt >= topple
        {
            // Put into words only for those who miss it: this is asked of every start.
            let bound = format!("below topple_tilt = {topple} rad");
            bounded("tilt", start.tilt, |_| false, &bound, "rad")?;
        }
        Ok(())
    }
}

/// How a motion ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Status {
    /// Time was up.
    Finished,
    /// The topple tilt was reached.
    Toppled,
    /// The normal force would have turned negative, and the law knows no flight.
    LiftedOff,
    /// The whole rim met the table at once.
    FaceDown,
    /// Its energy is spent, and it lies flat.
    AtRest,
    /// Painlevé's paradox: rigid-body mechanics with this friction has no one answer.
    Painleve,
    /// The solver could not go on.
    Failed,
    /// The caller asked to stop.
    Interrupted,
}

impl Status {
    /// All of them, in the order of their codes, `status as usize`.
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
    /// The laws with the body's numbers, for forces and energy along the way.
    pub contacts: Arc<Contacts>,
    /// Every accepted step, to be evaluated anywhere.
    pub track: Track,
    /// What happened on the way, in order of time.
    pub events: Vec<Event>,
    /// The angles of turn.
    pub turns: Vec<Turn>,
    /// How it ended.
    pub status: Status,
    /// How it ended, in a sentence.
    pub message: String,
    /// What it cost.
    pub work: Work,
}

impl Motion {
    /// The law that holds at an instant of the motion.
    pub fn dynamics(&self, at: &Instant) -> &dyn Dynamics<f64> {
        self.contacts.dynamics(at.phase)
    }

    /// The derivatives of the motion by its start, its body and gravity: some thirty times the work
    /// of the motion itself.
    ///
    /// `watch` is called every few hundred steps with the time (s) that the derivatives have reached,
    /// from 0 on; when it breaks off the work, the result is `None`.
    ///
    /// # Errors
    /// Where the motion is not smooth in them: offered is rolling without slip and sliding without
    /// friction, each all the way and without resistance.
    pub fn sensitivity(
        &self,
        mut watch: impl FnMut(f64) -> ControlFlow<()>,
    ) -> Result<Option<Sensitivity>, InvalidInput> {
        Sensitivity::of(self, &mut watch)
    }

    /// All that is known at an instant of the motion.
    pub fn moment(&self, at: &Instant) -> Moment {
        moment(self.dynamics(at), at)
    }
}

/// Follows a body from a start on a surface. The rim is at rest where it touches the table at the
/// start; without friction, the centre of mass is.
///
/// `watch` is called now and then with the time reached (s); it can end the work early.
///
/// # Errors
/// Refuses a start, a surface or options outside their bounds. Everything that can happen to a valid
/// start is not an error but a [`Status`].
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
    let (track, events, work) = run.into_parts();
    Ok(Motion {
        turns: turns::turns(&start, &events),
        message: message(status, &contacts, &track, &options, &work),
        contacts,
        track,
        events,
        status,
        work,
    })
}
