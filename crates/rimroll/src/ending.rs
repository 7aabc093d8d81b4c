//! How a motion ended, in numbers and as a sentence for the user.

use crate::number_format::{AngleUnit, formatted, formatted_time};

/// Below this tilt (rad) the base counts as flat on the table: the contact point would run round the
/// rim in less time than the last digit of t can resolve.
pub const FACE_DOWN_TILT: f64 = 1e-16;

/// Below this tilt (rad) the base also counts as flat if resistance has stopped the contact point on the
/// rim for good: the gap under the rim is then smaller than an atom.
pub const STOPPED_TILT: f64 = 1e-9;

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
    /// The base comes down flat over a gap.
    GapClosed {
        /// [`Options::flat_gap`](crate::Options::flat_gap), m.
        gap: f64,
    },
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
    /// The status that corresponds to this ending.
    pub fn status(&self) -> Status {
        match self.kind {
            EndingKind::Finished => Status::Finished,
            EndingKind::Toppled | EndingKind::ToppledInTheAir | EndingKind::FellOnItsSide(_) => {
                Status::Toppled
            }
            EndingKind::LiftedOff => Status::LiftedOff,
            EndingKind::FaceDown
            | EndingKind::GapClosed { .. }
            | EndingKind::TooFlat
            | EndingKind::StoppedRunning { .. } => Status::FaceDown,
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
                "toppled in the air: the tilt reached {tilt} at t = {t} s, with the rim off the table"
            ),
            EndingKind::Toppled => format!("toppled: the tilt reached {tilt} at t = {t} s"),
            EndingKind::LiftedOff => format!(
                "lifted off at t = {t} s: to stay on the table the rim would have to be pulled down"
            ),
            EndingKind::FaceDown => format!(
                "face down at t = {t} s: without any sideways motion the whole rim meets the table at once, \
                 and rigid-body mechanics does not say what follows from simultaneous impacts at every point \
                 of it. A start with a yaw rate or spin rate, however small beside the others (1e-12 of \
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
            EndingKind::GapClosed { gap } => format!(
                "face down at t = {t} s: the opposite point of the rim is at most {} m above the table, the gap \
                 below which the base comes down flat, and rigid-body mechanics does not say what follows from simultaneous \
                 impacts at every point of it",
                formatted(gap)
            ),
            EndingKind::TooFlat => format!(
                "face down at t = {t} s: the tilt falls below {}, where the contact point \
                 would run round the rim in less time than the last digit of t can resolve. A start with a \
                 larger yaw rate or spin rate can be followed past this point",
                unit.rounded(FACE_DOWN_TILT)
            ),
            EndingKind::AtRest { energy_left } => format!(
                "at rest at t = {t} s: the base lies flat, and the last {energy_left:.1e} of the energy is lost"
            ),
            EndingKind::Painleve { friction } => format!(
                "ended in Painlevé's paradox at t = {t} s: sliding as it does, the rim would be pressed down by \
                 its own friction, and rigid-body mechanics has no one answer. At the tilt of {tilt} this \
                 starts at a friction of {friction:.4}"
            ),
            EndingKind::OutOfSteps { max_steps } => {
                format!("stopped at t = {t} s after {max_steps} steps, the limit max_steps")
            }
            EndingKind::NoStep => format!("the solver found no step short enough at t = {t} s"),
            EndingKind::Interrupted => format!("interrupted at t = {t} s"),
        }
    }
}

impl OnItsSide {
    fn in_words(self) -> String {
        if self.is_at_rest {
            return "comes to rest".to_owned();
        }
        format!(
            "continues to slide at {:.3} m/s, spins about its axis at {:.3} rad/s and turns about the vertical at \
             {:.3} rad/s",
            self.sliding, self.axial_spin, self.turning
        )
    }
}
