//! The onset of slip from rest under dry friction: what the steppers of one motion and of a batch share.

use crate::real::Real;

/// A slip begins if its acceleration exceeds −`ROUNDING` times the scale of the accelerations. At loose tolerances
/// sin² φ + cos² φ differs from 1 by up to about 1e-8, and the condition for slip in the rolling and in the sliding
/// equations agrees only to that accuracy.
pub(crate) const ROUNDING: f64 = 1e-6;

/// The safety factor of the step size.
pub(crate) const SAFETY: f64 = 0.8;

/// The components of a horizontal vector along a unit vector and across it.
#[inline(always)]
pub(crate) fn along_and_across<T: Real>([x, y]: [T; 2], [unit_x, unit_y]: [T; 2]) -> [T; 2] {
    [x * unit_x + y * unit_y, y * unit_x - x * unit_y]
}

/// A unit vector rotated by an angle.
pub(crate) fn rotated(e: [f64; 2], angle: f64) -> [f64; 2] {
    let (sin, cos) = libm::sincos(angle);
    [e[0] * cos - e[1] * sin, e[1] * cos + e[0] * sin]
}

/// The time until a slip of this speed stops if the rate of the speed stays the same.
#[inline(always)]
pub(crate) fn until_stop<T: Real>(speed: T, rate: T) -> T {
    speed / (-rate).max(T::from(0.0))
}

/// The factor from one step size to the next, within the bounds after an accepted step.
pub(crate) fn growth(factor: f64) -> f64 {
    factor.clamp(0.3, 4.0)
}

/// The size of the next step, which must not pass the end of a slip that is about to stop.
pub(crate) fn next_step(h: f64, growth: f64, until_stop: f64) -> f64 {
    (h * growth).min(0.9 * until_stop)
}
