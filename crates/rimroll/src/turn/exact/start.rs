//! Where a motion starts, in the terms of the quadrature.

use crate::real::Real;
use crate::state::State;

/// A start.
#[derive(Debug, Clone, Copy)]
pub(super) struct Start<T> {
    /// tan(φ/2).
    pub(super) y: T,
    /// Its logarithm.
    pub(super) eta: T,
    /// φ̇, rad/s.
    pub(super) p: T,
    /// w = ψ̇ sin φ, rad/s.
    pub(super) w: T,
    /// s = θ̇ + ψ̇ cos φ, rad/s.
    pub(super) s: T,
}

impl<T: Real> Start<T> {
    /// From [tilt, tilt rate, yaw rate, spin rate].
    pub(super) fn new([tilt, tilt_rate, yaw_rate, spin_rate]: [T; 4]) -> Self {
        let (sin, cos) = tilt.sin_cos();
        let y = sin / (T::from(1.0) + cos);
        let w = yaw_rate * sin;
        Start {
            y,
            eta: y.ln(),
            p: tilt_rate,
            w,
            // Where the two rates are large and all but cancel, as in a near-collision.
            s: (spin_rate + yaw_rate) - w * y,
        }
    }
}

impl Start<f64> {
    pub(super) fn of(start: &State) -> Self {
        Start::new([start.tilt, start.tilt_rate, start.yaw_rate, start.spin_rate])
    }
}
