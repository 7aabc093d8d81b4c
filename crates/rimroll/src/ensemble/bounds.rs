//! The bounds of a fall in lanes.

use crate::error_scale::ErrorScale;
use crate::motion::{FACE_DOWN_TILT, Options, ToppleTilt};
use crate::state::Coordinates;

/// The bounds of all falls of an ensemble.
pub(super) struct Bounds {
    /// The maximal duration, s.
    pub duration: f64,
    /// Below this sin φ the base may lie flat on the table.
    pub flat: f64,
    /// The tolerance of one step, relative to the error scales.
    pub tolerance: f64,
    /// [`Options::significant_tilt_rate`].
    significant: f64,
    /// A fall that takes more steps is left to the scalar solver.
    pub max_steps: f64,
}

impl Bounds {
    /// The bounds of falls with these options, which must have been checked.
    pub(super) fn of(options: &Options) -> Bounds {
        Bounds {
            duration: options.duration,
            flat: 10.0 * FACE_DOWN_TILT,
            tolerance: options.step_tolerance(),
            significant: options.significant_tilt_rate(),
            max_steps: (options.max_steps as f64).min(2000.0) - 1.0,
        }
    }

    /// Whether a fall can start in lanes at these coordinates, inside all bounds.
    pub(super) fn are_far_from(&self, u: &Coordinates<f64>, topple: &ToppleTilt<f64>) -> bool {
        let in_time = u.t < self.duration && self.max_steps > 0.0;
        u.sin > self.flat && u.cos > 0.0 && topple.below(u) > 0.0 && in_time
    }

    /// The sign of the tilt rate, or 0 if the sign is not significant.
    pub(super) fn sign_of_tilt_rate(&self, u: &Coordinates<f64>, scale: &ErrorScale<f64>) -> f64 {
        scale.sign_of_tilt_rate(u, self.significant)
    }
}
