//! The bounds of a fall in lanes.

use crate::error_scale::ErrorScale;
use crate::motion::{FACE_DOWN_TILT, Options};
use crate::real::{Real, fieldwise};
use crate::state::Coordinates;

/// The bounds of all falls of an ensemble.
pub(super) struct Limits {
    /// The maximal duration, s.
    pub duration: f64,
    /// Below this sin φ the base may lie flat on the table.
    pub flat: f64,
    /// The tolerance of one step, relative to the error scales.
    pub tolerance: f64,
    /// The sign of a tilt rate is significant if the rate exceeds this fraction of its error scale.
    significant: f64,
    /// A fall that takes more steps is left to the scalar solver.
    pub max_steps: f64,
}

impl Limits {
    /// The bounds of falls with these options, which must have been checked.
    pub(super) fn of(options: &Options) -> Limits {
        Limits {
            duration: options.duration,
            flat: 10.0 * FACE_DOWN_TILT,
            tolerance: options.step_tolerance(),
            significant: 10.0 * options.rtol,
            max_steps: (options.max_steps as f64).min(2000.0) - 1.0,
        }
    }

    /// Whether a fall can start in lanes at these coordinates, inside all bounds.
    pub(super) fn are_far_from(&self, u: &Coordinates<f64>, topple: &Topple<f64>) -> bool {
        let in_time = u.t < self.duration && self.max_steps > 0.0;
        u.sin > self.flat && u.cos > 0.0 && topple.below(u) > 0.0 && in_time
    }

    /// The sign of the tilt rate, or 0 if the sign is not significant.
    pub(super) fn sign_of_tilt_rate(&self, u: &Coordinates<f64>, scale: &ErrorScale<f64>) -> f64 {
        scale.sign_of_tilt_rate(u, self.significant)
    }
}

/// The tilt at which a body counts as toppled, by its sine and cosine.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Topple<T> {
    sin: T,
    cos: T,
}

fieldwise!(Topple { sin, cos; });

impl Topple<f64> {
    /// The topple tilt, rad. With `None` the body never counts as toppled.
    pub(super) fn at(tilt: Option<f64>) -> Self {
        // The tilt never reaches π.
        let (sin, cos) = tilt.map_or((0.0, -1.0), libm::sincos);
        Topple { sin, cos }
    }

    /// Whether the topple tilt is at most π/2, where the base is vertical.
    pub(super) fn is_at_most_upright(&self) -> bool {
        self.cos > -1e-9
    }
}

impl<T: Real> Topple<T> {
    /// sin(topple tilt − φ), an event function that is positive below the topple tilt.
    #[inline(always)]
    pub(super) fn below(&self, u: &Coordinates<T>) -> T {
        u.cos * self.sin - u.sin * self.cos
    }
}
