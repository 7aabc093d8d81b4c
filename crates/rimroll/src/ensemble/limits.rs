//! What a fall must not cross unseen.

use crate::error_scale::ErrorScale;
use crate::motion::{FACE_DOWN_TILT, Options};
use crate::real::{Real, fieldwise};
use crate::state::Coordinates;

/// The limits of all falls of an ensemble.
pub(super) struct Limits {
    /// s.
    pub duration: f64,
    /// Below this sine the base may be flat.
    pub flat: f64,
    /// What one step may err, relative to the sizes.
    pub tolerance: f64,
    /// A tilt rate counts as having a sign when it is larger than this part of its size.
    significant: f64,
    /// A fall of more steps is followed by itself.
    pub max_steps: f64,
}

impl Limits {
    /// The limits of falls with these options, which have been checked.
    pub(super) fn of(options: &Options) -> Limits {
        Limits {
            duration: options.duration,
            flat: 10.0 * FACE_DOWN_TILT,
            tolerance: options.step_tolerance(),
            significant: 10.0 * options.rtol,
            max_steps: (options.max_steps as f64).min(2000.0) - 1.0,
        }
    }

    /// Whether a fall that starts here has some way to go to a limit.
    pub(super) fn are_far_from(&self, u: &Coordinates<f64>, topple: &Topple<f64>) -> bool {
        let in_time = u.t < self.duration && self.max_steps > 0.0;
        u.sin > self.flat && u.cos > 0.0 && topple.below(u) > 0.0 && in_time
    }

    /// −1 or 1 when the tilt clearly falls or rises, 0 when it cannot be told.
    pub(super) fn sign_of_tilt_rate(&self, u: &Coordinates<f64>, by: &ErrorScale<f64>) -> f64 {
        by.sign_of_tilt_rate(u, self.significant)
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
    /// The limits of a body that counts as toppled at a tilt (rad), if at any.
    pub(super) fn at(tilt: Option<f64>) -> Self {
        // Beyond the tilt π no body gets.
        let (sin, cos) = tilt.map_or((0.0, -1.0), libm::sincos);
        Topple { sin, cos }
    }

    /// Whether this is not past the tilt π/2, at which the base is upright.
    pub(super) fn is_at_most_upright(&self) -> bool {
        self.cos > -1e-9
    }
}

impl<T: Real> Topple<T> {
    /// The sine of the tilt that is missing to where the body counts as toppled.
    #[inline(always)]
    pub(super) fn below(&self, u: &Coordinates<T>) -> T {
        u.cos * self.sin - u.sin * self.cos
    }
}
