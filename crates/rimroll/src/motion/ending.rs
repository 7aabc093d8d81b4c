//! The ending of a motion, in numbers and as a sentence for the user.

use super::contacts::{Contacts, Phase};
use super::events::TerminalEvent;
use super::track::{Instant, Track};
use super::{FACE_DOWN_TILT, Options, Status};
use crate::error::formatted;
use crate::solve::Work;
use crate::turn::painleve_friction_at;

/// The unit of the angles in a sentence.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AngleUnit {
    /// rad.
    Radians,
    /// °.
    Degrees,
}

impl AngleUnit {
    fn formatted(self, angle: f64) -> String {
        match self {
            AngleUnit::Radians => format!("{angle:.6} rad"),
            AngleUnit::Degrees => format!("{:.3}°", angle.to_degrees()),
        }
    }

    /// The angle to one significant digit.
    fn rounded(self, angle: f64) -> String {
        match self {
            AngleUnit::Radians => format!("{angle:.0e} rad"),
            AngleUnit::Degrees => format!("{:.0e}°", angle.to_degrees()),
        }
    }

    fn right_angle(self) -> &'static str {
        match self {
            AngleUnit::Radians => "pi/2",
            AngleUnit::Degrees => "90°",
        }
    }
}

/// The ending of a motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ending {
    /// The kind of ending.
    pub kind: EndingKind,
    /// The time of the ending, s.
    pub t: f64,
    /// φ at the ending, rad.
    pub tilt: f64,
}

/// The kind of ending, in more detail than its [`Status`], with the numbers that belong to it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum EndingKind {
    /// The duration is reached.
    Finished,
    /// The topple tilt is reached on the rim.
    Toppled,
    /// The topple tilt is reached with the rim off the table.
    ToppledInTheAir,
    /// The side meets the table.
    FellOnItsSide(OnItsSide),
    /// The normal force would become negative.
    LiftedOff,
    /// The base comes down flat without any sideways motion.
    FaceDown,
    /// The tilt falls below [`FACE_DOWN_TILT`].
    TooFlat,
    /// Resistance has stopped the contact point on the rim, and the base comes down flat.
    StoppedRunning {
        /// φ̇, rad/s.
        tilt_rate: f64,
        /// s, rad/s.
        axial_spin: f64,
    },
    /// The base lies flat.
    AtRest {
        /// The remaining fraction of the initial energy, which is lost.
        energy_left: f64,
    },
    /// The Painlevé paradox.
    Painleve {
        /// The coefficient of friction at which it begins at this tilt.
        friction: f64,
    },
    /// The maximal number of steps is reached.
    OutOfSteps {
        /// The maximal number of steps.
        max_steps: usize,
    },
    /// The step size of the solver underflowed.
    NoStep,
    /// The caller stopped the computation.
    Interrupted,
}

/// The motion of a body whose side has just struck the table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OnItsSide {
    /// The speed of sliding, m/s.
    pub sliding: f64,
    /// s, the spin about the axis, rad/s.
    pub axial_spin: f64,
    /// The rate of rotation about the vertical, rad/s.
    pub turning: f64,
    /// Whether all of these are negligible.
    pub is_at_rest: bool,
}

impl Ending {
    /// The ending of a motion with this status and the terminal event of its last phase.
    pub(super) fn new(
        (status, last_event): (Status, Option<TerminalEvent>),
        contacts: &Contacts,
        track: &Track,
        options: &Options,
        work: &Work,
    ) -> Ending {
        let end = track.end();
        let kind = match status {
            Status::Finished => EndingKind::Finished,
            Status::Toppled if end.phase == Phase::Lying => {
                EndingKind::FellOnItsSide(OnItsSide::new(contacts, &end))
            }
            Status::Toppled if end.phase == Phase::Flying => EndingKind::ToppledInTheAir,
            Status::Toppled => EndingKind::Toppled,
            Status::LiftedOff => EndingKind::LiftedOff,
            Status::FaceDown if end.w == 0.0 && end.s == 0.0 => EndingKind::FaceDown,
            Status::FaceDown if last_event == Some(TerminalEvent::StoppedRunning) => {
                EndingKind::StoppedRunning {
                    tilt_rate: end.p,
                    axial_spin: end.s,
                }
            }
            Status::FaceDown => EndingKind::TooFlat,
            Status::AtRest => EndingKind::AtRest {
                energy_left: remaining_energy(contacts, track),
            },
            Status::Painleve => EndingKind::Painleve {
                friction: painleve_friction_at(contacts.parameters(), &end),
            },
            Status::Failed if work.steps >= options.max_steps => EndingKind::OutOfSteps {
                max_steps: options.max_steps,
            },
            Status::Failed => EndingKind::NoStep,
            Status::Interrupted => EndingKind::Interrupted,
        };
        Ending {
            kind,
            t: end.t,
            tilt: end.tilt(),
        }
    }

    /// The status that corresponds to this ending.
    pub fn status(&self) -> Status {
        match self.kind {
            EndingKind::Finished => Status::Finished,
            EndingKind::Toppled | EndingKind::ToppledInTheAir | EndingKind::FellOnItsSide(_) => {
                Status::Toppled
            }
            EndingKind::LiftedOff => Status::LiftedOff,
            EndingKind::FaceDown | EndingKind::TooFlat | EndingKind::StoppedRunning { .. } => {
                Status::FaceDown
            }
            EndingKind::AtRest { .. } => Status::AtRest,
            EndingKind::Painleve { .. } => Status::Painleve,
            EndingKind::OutOfSteps { .. } | EndingKind::NoStep => Status::Failed,
            EndingKind::Interrupted => Status::Interrupted,
        }
    }

    /// The ending in a sentence.
    pub fn sentence(&self, unit: AngleUnit) -> String {
        let t = formatted_time(self.t);
        let tilt = unit.formatted(self.tilt);
        match self.kind {
            EndingKind::Finished => format!("followed for the whole {} s", formatted(self.t)),
            EndingKind::FellOnItsSide(after) => format!(
                "toppled: the tilt reached {} at t = {t} s, where its side meets the table; landing there \
                 without rebound it {}",
                unit.right_angle(),
                after.in_words()
            ),
            EndingKind::ToppledInTheAir => format!(
                "toppled in the air: the tilt reached {tilt} at t = {t} s, the rim being off the table"
            ),
            EndingKind::Toppled => format!("toppled: the tilt reached {tilt} at t = {t} s"),
            EndingKind::LiftedOff => format!(
                "lifted off at t = {t} s: to stay on the table the rim would have to be pulled down"
            ),
            EndingKind::FaceDown => format!(
                "face down at t = {t} s: without any sideways motion the whole rim meets the table at once, \
                 and rigid-body mechanics does not say what follows from simultaneous impacts at every point \
                 of it. A start with a yaw_rate or spin_rate, however small beside the others (1e-12 of \
                 them will do), can be followed past this point"
            ),
            EndingKind::StoppedRunning {
                tilt_rate,
                axial_spin,
            } => format!(
                "face down at t = {t} s: resistance has stopped the contact point on the rim, and the base comes \
                 down flat, tilting at {tilt_rate:.4} rad/s and spinning about its axis at {axial_spin:.4} rad/s. \
                 Rigid-body mechanics does not say what follows from simultaneous impacts at every point of it"
            ),
            EndingKind::TooFlat => format!(
                "face down at t = {t} s: the tilt falls below {}, where the contact point \
                 would run round the rim in less time than the last digit of t can resolve. A start with a \
                 larger yaw_rate or spin_rate can be followed past this point",
                unit.rounded(FACE_DOWN_TILT)
            ),
            EndingKind::AtRest { energy_left } => format!(
                "at rest at t = {t} s: the base lies flat, and the last {energy_left:.1e} of the energy goes with it"
            ),
            EndingKind::Painleve { friction } => format!(
                "ended in Painlevé's paradox at t = {t} s: sliding as it does, the rim would be pressed down by \
                 its own friction, and rigid-body mechanics has no one answer. At the tilt of {tilt} this \
                 starts at a friction of {friction:.4}"
            ),
            EndingKind::OutOfSteps { max_steps } => {
                format!("stopped at t = {t} s after max_steps = {max_steps} steps")
            }
            EndingKind::NoStep => format!("the solver found no step short enough at t = {t} s"),
            EndingKind::Interrupted => format!("interrupted at t = {t} s"),
        }
    }
}

impl OnItsSide {
    fn new(contacts: &Contacts, end: &Instant) -> OnItsSide {
        let k = contacts.parameters();
        let [along, across] = contacts.dynamics(end.phase).slip(end);
        let sliding = libm::hypot(along, across);
        let turning = k.r * (end.s.abs() + end.w.abs());
        OnItsSide {
            sliding,
            axial_spin: end.s,
            turning: end.w,
            is_at_rest: sliding + turning < 1e-3 * (k.g * k.r).sqrt(),
        }
    }

    fn in_words(self) -> String {
        if self.is_at_rest {
            return "comes to rest".to_owned();
        }
        format!(
            "goes on, sliding at {:.3} m/s, spinning about its axis at {:.3} rad/s and turning about \
             the vertical at {:.3} rad/s",
            self.sliding, self.axial_spin, self.turning
        )
    }
}

/// A time (s) to the microsecond, or in full if it is shorter than a millisecond.
fn formatted_time(t: f64) -> String {
    if t == 0.0 || t >= 1e-3 {
        format!("{t:.6}")
    } else {
        formatted(t)
    }
}

/// The fraction of the initial energy that is left at the end.
fn remaining_energy(contacts: &Contacts, track: &Track) -> f64 {
    let energy = |at: &Instant| contacts.dynamics(at.phase).energy(at).total();
    energy(&track.end()) / energy(&track.start())
}
