//! The passage over the balance point.
//!
//! There the tilt slows down: G ≈ G_b + c (η − η_b)², with c = mg √(R² + H²) sin² φ_b, all but vanishes at
//! η_b ± iδ, δ² = G_b/c. By the clock η = η_b + δ sinh u the passage is of length ln 1/δ and the integrand
//! singular at u = ± i π/2, however near the balance point the body comes to rest.

use super::half_tangent;
use crate::body::Body;
use crate::real::{Real, asinh};

/// Wider than this, in η, the clock need not be slowed.
const WIDEST: f64 = 1.0;

/// The balance point, or the end if that is before it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Balance {
    /// tan(φ/2).
    pub(super) y: f64,
    /// Its logarithm.
    pub(super) eta: f64,
    /// c, J.
    pub(super) curvature: f64,
    /// 2mg times how much higher the centre of mass is there than upright, J.
    pub(super) energy: f64,
}

impl Balance {
    /// Of a body that is followed up to `end`, tan(φ/2).
    pub(super) fn new(body: &Body, gravity: f64, end: f64) -> Self {
        let y = half_tangent(body.balance_tilt()).min(end);
        let sin = 2.0 * y / (1.0 + y * y);
        let arm = libm::hypot(body.radius(), body.height());
        let weight = body.mass() * gravity;
        Balance {
            y,
            eta: Real::ln(y),
            curvature: weight * arm * sin * sin,
            energy: 2.0 * weight * sin * (body.radius() - body.height() * y),
        }
    }
}

/// The clock of one passage.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ridge<T> {
    balance: Balance,
    /// δ.
    width: T,
}

impl<T: Real> Ridge<T> {
    /// From G at the balance point.
    #[inline(always)]
    pub(super) fn new(balance: Balance, drive: T) -> Self {
        let width = (drive * T::from(1.0 / balance.curvature)).sqrt();
        let over = width - T::from(WIDEST);
        Ridge {
            balance,
            width: over.where_negative(width, T::from(WIDEST)),
        }
    }

    /// With a width that is known.
    #[inline(always)]
    pub(super) fn of_width(balance: Balance, width: T) -> Self {
        Ridge { balance, width }
    }

    /// δ, or what stands for it.
    #[inline(always)]
    pub(super) fn width(&self) -> T {
        self.width
    }

    /// u at η.
    #[inline(always)]
    pub(super) fn clock(&self, eta: T) -> T {
        asinh((eta - T::from(self.balance.eta)) / self.width)
    }

    /// y, η and dη/du at u.
    #[inline(always)]
    pub(super) fn at(&self, clock: T) -> (T, T, T) {
        let (half, one) = (T::from(0.5), T::from(1.0));
        let up = clock.abs().exp_m1();
        let down = up / (up + one);
        let sinh = half * (up + down);
        let away = self.width * clock.where_negative(-sinh, sinh);
        let y = T::from(self.balance.y);
        let rate = self.width * (one + half * (up - down));
        (
            y + y * away.exp_m1(),
            T::from(self.balance.eta) + away,
            rate,
        )
    }
}
