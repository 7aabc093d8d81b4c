//! The start of a motion, in the variables of the quadrature.

use crate::real::{Lanes, Real, Vector, sin_cos_below_eighth};
use crate::state::State;

/// A start of a motion.
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
    /// Converts [tilt, tilt rate, yaw rate, spin rate], in rad and rad/s, for tilts below π/2.
    #[inline(always)]
    pub(super) fn new([tilt, tilt_rate, yaw_rate, spin_rate]: [T; 4]) -> Self {
        let half = T::from(0.5);
        let (sin, cos) = sin_cos_below_eighth(half * tilt);
        let y = sin / cos;
        let w = yaw_rate * (sin * cos + sin * cos);
        Start {
            y,
            eta: y.ln(),
            p: tilt_rate,
            w,
            // This form is accurate if the two rates are large and nearly cancel, as in a near-collision.
            s: (spin_rate + yaw_rate) - w * y,
        }
    }
}

impl<V: Vector> Start<V> {
    #[inline(always)]
    pub(super) fn load(start: &Start<Lanes>) -> Self {
        Start {
            y: V::load(&start.y),
            eta: V::load(&start.eta),
            p: V::load(&start.p),
            w: V::load(&start.w),
            s: V::load(&start.s),
        }
    }

    #[inline(always)]
    pub(super) fn store(&self) -> Start<Lanes> {
        Start {
            y: self.y.store(),
            eta: self.eta.store(),
            p: self.p.store(),
            w: self.w.store(),
            s: self.s.store(),
        }
    }
}

impl Start<Lanes> {
    /// The start in one lane.
    #[inline(always)]
    pub(super) fn lane(&self, place: usize) -> Start<f64> {
        Start {
            y: self.y.0[place],
            eta: self.eta.0[place],
            p: self.p.0[place],
            w: self.w.0[place],
            s: self.s.0[place],
        }
    }
}

impl Start<f64> {
    pub(super) fn of(start: &State) -> Self {
        Start::new([start.tilt, start.tilt_rate, start.yaw_rate, start.spin_rate])
    }
}
