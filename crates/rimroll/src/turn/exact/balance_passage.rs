//! The change of variable for the passage over the balance point.
//!
//! The tilt rate has a minimum there: G ≈ G_b + c (η − η_b)² with c = mg √(R² + H²) sin² φ_b, so G nearly
//! vanishes at η_b ± iδ, δ² = G_b/c. With η = η_b + δ sinh u, the length of the passage in u grows only like
//! ln 1/δ and the singularities of the integrand are at u = ± i π/2, for any δ.

use super::tilt_equation::half_tangent;
use crate::body::Body;
use crate::real::{Real, asinh};

/// The maximum of δ in the change of variable. A larger δ would gain nothing.
const MAX_WIDTH: f64 = 1.0;

/// The balance point, or the end of the motion if that is at a smaller tilt.
#[derive(Debug, Clone, Copy)]
pub(super) struct Balance {
    /// tan(φ/2).
    pub(super) y: f64,
    /// η, the logarithm of y.
    pub(super) eta: f64,
    /// The curvature c of G there, J.
    pub(super) curvature: f64,
    /// 2mg times the height of the centre of mass relative to upright, J.
    pub(super) energy: f64,
}

impl Balance {
    /// The balance point of a body whose motion ends at tan(φ/2) = `end`.
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

/// The change of variable of one passage. G has a minimum there because the potential energy has its maximum.
#[derive(Debug, Clone, Copy)]
pub(super) struct BalancePassage<T> {
    balance: Balance,
    /// δ, in η.
    width: T,
}

impl<T: Real> BalancePassage<T> {
    /// The change of variable for a given G at the balance point.
    #[inline(always)]
    pub(super) fn new(balance: Balance, drive: T) -> Self {
        let width = (drive * T::from(1.0 / balance.curvature)).sqrt();
        let over = width - T::from(MAX_WIDTH);
        BalancePassage {
            balance,
            width: over.where_negative(width, T::from(MAX_WIDTH)),
        }
    }

    /// The change of variable with a known width.
    #[inline(always)]
    pub(super) fn of_width(balance: Balance, width: T) -> Self {
        BalancePassage { balance, width }
    }

    /// δ, at most [`MAX_WIDTH`].
    #[inline(always)]
    pub(super) fn width(&self) -> T {
        self.width
    }

    /// u at η.
    #[inline(always)]
    pub(super) fn u(&self, eta: T) -> T {
        asinh((eta - T::from(self.balance.eta)) / self.width)
    }

    /// y, η and dη/du at u.
    #[inline(always)]
    pub(super) fn at(&self, u: T) -> (T, T, T) {
        let (half, one) = (T::from(0.5), T::from(1.0));
        let up = u.abs().exp_m1();
        let down = up / (up + one);
        let sinh = half * (up + down);
        let offset = self.width * u.where_negative(-sinh, sinh);
        let y = T::from(self.balance.y);
        let rate = self.width * (one + half * (up - down));
        (
            y + y * offset.exp_m1(),
            T::from(self.balance.eta) + offset,
            rate,
        )
    }
}
