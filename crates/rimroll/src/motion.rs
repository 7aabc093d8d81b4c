//! A whole motion: from the start until time is up or the contact changes its nature.
//!
//! [`simulate`] steps through the [`Coordinates`] by the solver's clock τ, notes the tilt's minima and
//! maxima on the way, and ends where the law no longer holds: toppled, lifted off, face down.

mod events;
mod moment;
mod track;
mod turns;

pub use events::{Event, EventKind};
pub use moment::{COLUMNS, Moment, moment};
pub use track::Track;
pub use turns::Turn;

use crate::body::Body;
use crate::error::{InvalidInput, bounded, positive, shown};
use crate::law::{Law, LawKind};
use crate::solve::{Stepper, Stuck, System, Work};
use crate::state::{COORDINATES, Coordinates, State};
use core::f64::consts::{FRAC_PI_2, PI};
use core::ops::ControlFlow;
use events::Watch;

/// Standard gravity, m/s² (exact by convention). The paper used 9.8.
pub const STANDARD_GRAVITY: f64 = 9.80665;

/// Below this tilt (rad) the base counts as flat on the table: the contact point would run round the
/// rim in less time than the last digit of t can tell.
pub const FACE_DOWN_TILT: f64 = 1e-16;

/// How to simulate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options {
    /// How long to follow the motion, s.
    pub duration: f64,
    /// g, m/s².
    pub gravity: f64,
    /// Error to aim at over some tens of rockings, relative to the size of each coordinate; from 1e-13
    /// on rounding decides.
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
    /// Errors of the energy add up from step to step, so a step is held to a fiftieth of `rtol`:
    /// measured over 20 rockings of the can, the energy then keeps to 0.2 rtol. Below 5e-15 rounding
    /// would be taken for error.
    fn step_tolerance(&self) -> f64 {
        (0.02 * self.rtol).max(5e-15)
    }

    /// Checks the numbers and fills in the body's own topple tilt.
    fn checked(mut self, body: &Body, start: &State) -> Result<Options, InvalidInput> {
        start.check()?;
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
        if self.topple_tilt.is_none() && body.height() > 0.0 {
            self.topple_tilt = Some(FRAC_PI_2);
        }
        if let Some(topple) = self.topple_tilt {
            // Past this tilt the centre of mass would be under the table.
            let most = (FRAC_PI_2 + body.balance_tilt()).min(PI);
            bounded(
                "topple_tilt",
                topple,
                |tilt| tilt > 0.0 && tilt < most,
                &format!("inside (0, {most}), where the centre of mass is over the table"),
                "rad",
            )?;
            bounded(
                "tilt",
                start.tilt,
                |tilt| tilt < topple,
                &format!("below topple_tilt = {topple} rad"),
                "rad",
            )?;
        }
        Ok(self)
    }
}

/// How a motion ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Status {
    /// Time was up.
    Finished,
    /// The topple tilt was reached.
    Toppled,
    /// The normal force would have turned negative.
    LiftedOff,
    /// The whole rim met the table at once.
    FaceDown,
    /// The solver could not go on.
    Failed,
    /// The caller asked to stop.
    Interrupted,
}

impl Status {
    /// The name that the user reads.
    pub fn name(self) -> &'static str {
        match self {
            Status::Finished => "finished",
            Status::Toppled => "toppled",
            Status::LiftedOff => "lifted_off",
            Status::FaceDown => "face_down",
            Status::Failed => "failed",
            Status::Interrupted => "interrupted",
        }
    }
}

/// A computed motion.
pub struct Motion {
    /// The law with the body's numbers, for forces and energy along the way.
    pub law: Box<dyn Law<f64> + Send + Sync>,
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

/// The mechanics as the solver sees them.
struct Rolling<'a> {
    law: &'a dyn Law<f64>,
    radius: f64,
    /// √(g/R): the rate of falling, a yardstick for rates.
    falling_rate: f64,
}

impl<'a> Rolling<'a> {
    fn new(law: &'a dyn Law<f64>) -> Self {
        let k = law.parameters();
        Rolling {
            law,
            radius: k.r,
            falling_rate: (k.g / k.r).sqrt(),
        }
    }
}

impl System<COORDINATES> for Rolling<'_> {
    fn rates(&self, u: &[f64; COORDINATES]) -> [f64; COORDINATES] {
        self.law.rates(&Coordinates::from_array(u)).into_array()
    }

    /// w and s obey linear equations and pass through the tipping phase as small as the start made
    /// them, to become large in the collision; so each is held to its own size, with a floor of what
    /// the other one feeds into it. sin φ is held to its own size for the same reason.
    fn scale(&self, u: &[f64; COORDINATES]) -> [f64; COORDINATES] {
        const NEVER_ZERO: f64 = 1e-200;
        let u = Coordinates::from_array(u);
        Coordinates {
            yaw: 1.0,
            spin: 1.0,
            x: self.radius,
            y: self.radius,
            t: 1.0 / self.falling_rate,
            sin: u.sin,
            cos: 1.0,
            p: u.p.abs() + u.w.abs() + u.sin * self.falling_rate,
            w: u.w.abs() + u.sin * u.s.abs() + NEVER_ZERO,
            s: u.s.abs() + u.sin * u.w.abs() + NEVER_ZERO,
        }
        .into_array()
    }
}

/// Follows a body from a start under a contact law.
///
/// `watch` is called now and then with the time reached (s); it can end the work early.
///
/// # Errors
/// Refuses a start or options outside their bounds. Everything that can happen to a valid start is
/// not an error but a [`Status`].
pub fn simulate(
    body: &Body,
    start: &State,
    law: LawKind,
    options: &Options,
    mut watch: impl FnMut(f64) -> ControlFlow<()>,
) -> Result<Motion, InvalidInput> {
    let options = options.checked(body, start)?;
    let law = law.of(body, options.gravity);
    let rolling = Rolling::new(&*law);
    let start = Coordinates::from_state(start);
    let rate = start.p.abs() + start.w.abs() + start.s.abs() + rolling.falling_rate;
    let mut stepper = Stepper::new(
        &rolling,
        start.into_array(),
        0.01 / rate,
        options.step_tolerance(),
    );
    let mut track = Track::new(start);
    let mut lookout = Watch::new(&rolling, &options, &start);

    let mut ending = lookout.at_start(&start);
    while ending.is_none() {
        if stepper.work.steps >= options.max_steps {
            ending = Some(Status::Failed);
        } else if stepper.work.steps % 4096 == 4095 && watch(track.end().t).is_break() {
            ending = Some(Status::Interrupted);
        } else {
            match stepper.advance() {
                Ok(step) => ending = lookout.pass(step, &mut track),
                Err(Stuck::StepUnderflow) => ending = Some(Status::Failed),
            }
        }
    }
    let status = ending.unwrap_or(Status::Failed);
    let work = stepper.work;
    let events = lookout.into_events();
    let message = message(status, &track, &options, &work);
    Ok(Motion {
        turns: turns::turns(&start, &events),
        law,
        track,
        events,
        status,
        message,
        work,
    })
}

/// A time, s, to the microsecond, or as it is when that would show nothing of it.
fn moment_of(t: f64) -> String {
    if t == 0.0 || t >= 1e-3 {
        format!("{t:.6}")
    } else {
        shown(t)
    }
}

/// The ending in a sentence.
fn message(status: Status, track: &Track, options: &Options, work: &Work) -> String {
    let end = track.end();
    let t = moment_of(end.t);
    match status {
        Status::Finished => format!("followed for the whole {} s", shown(end.t)),
        Status::Toppled => format!(
            "toppled: the tilt reached {:.6} rad at t = {t} s",
            end.tilt()
        ),
        Status::LiftedOff => format!(
            "lifted off at t = {t} s: to stay on the table the rim would have to be pulled down"
        ),
        Status::FaceDown if end.w == 0.0 && end.s == 0.0 => format!(
            "face down at t = {t} s: without any sideways motion the whole rim meets the table at once, \
             and rigid-body mechanics does not say what follows from simultaneous impacts at every point \
             of it. A start with a yaw_rate or spin_rate, however small beside the others (1e-12 of \
             them will do), can be followed past this point"
        ),
        Status::FaceDown => format!(
            "face down at t = {t} s: the tilt falls below {FACE_DOWN_TILT:e} rad, where the contact point \
             would run round the rim in less time than the last digit of t can tell. A start with a \
             larger yaw_rate or spin_rate can be followed past this point"
        ),
        Status::Failed if work.steps >= options.max_steps => format!(
            "stopped at t = {t} s after max_steps = {} steps",
            options.max_steps
        ),
        Status::Failed => format!("the solver found no step short enough at t = {t} s"),
        Status::Interrupted => format!("interrupted at t = {t} s"),
    }
}
