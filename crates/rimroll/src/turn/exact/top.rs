//! A start next to the balance point, where the tilt's energy G is a small difference of large parts.
//!
//! There the loss of height, as the body turns about its rim by Δ from the start, and the energy that yaw and spin lose
//! are taken from the start on, where G = I φ̇² is known in full:
//!
//! ```text
//! z₀ − z = z₀ (1 − cos Δ) − ρ₀ sin Δ
//! ```
//!
//! So G keeps its digits however long the body lingers there.

use super::antiderivative::Antiderivative;
use super::ridge::Balance;
use super::scalar::Scalar;
use super::start::Start;
use super::tilting::{Conserved, Point, ROUNDING, Tilting, sin_and_versine};
use crate::law::Parameters;

/// So near to the balance point, in η, what a start has of energy is little beside that of its height.
const NEAR: f64 = 1.0;

/// So much nearer, and so slow, G loses digits that count.
const NEXT: f64 = 0.05;

/// A body that passes the balance point with less G, over its [curvature](Balance), or lacks no more, lingers.
const LITTLE: f64 = 0.01;

/// So far beyond start and balance point, in η, G need not be as exact.
const REACH: f64 = 0.2;

/// Chebyshev points for up to NEAR + 2 REACH.
const POINTS: usize = 24;

/// Whether a start is so near to the balance point, and so slow, that many at a time would lose digits; A is the least
/// there is of inertia.
pub(super) fn is_on_top(start: &Start<f64>, a: f64, balance: &Balance) -> bool {
    let drive = a * start.p * start.p;
    (start.eta - balance.eta).abs() < NEXT && drive < NEXT * NEXT * balance.curvature
}

/// Whether a motion from near the balance point lingers there.
pub(super) fn lingers<T: Scalar>(
    motion: &dyn Tilting<T>,
    start: &Start<T>,
    balance: &Balance,
) -> bool {
    let drive = motion.at(balance.y.into(), balance.eta.into()).drive;
    (start.eta.value() - balance.eta).abs() < NEAR
        && drive.value().abs() < LITTLE * balance.curvature
}

/// The motion from such a start.
pub(super) struct OnTop<'a, T> {
    motion: &'a dyn Tilting<T>,
    start: Start<T>,
    drive_start: T,
    /// 2mg ρ and 2mg z at the start.
    levers: [T; 2],
    /// What yaw and spin have lost of G, from the start on.
    lost: Antiderivative<T, POINTS>,
    /// Where it ends, in η from the start.
    range: [T; 2],
}

impl<'a, T: Scalar> OnTop<'a, T> {
    /// Of a motion that is followed up to `end`; that and the balance point in η.
    pub(super) fn new(
        motion: &'a dyn Tilting<T>,
        k: &Parameters<T>,
        start: Start<T>,
        [balance, end]: [f64; 2],
    ) -> Self {
        let Start { y, eta, p, .. } = start;
        let (balance, end) = (balance - eta.value(), end - eta.value());
        let (from, to) = (
            balance.min(0.0) - REACH,
            (balance.max(0.0) + REACH).min(end),
        );
        let weight = T::from(2.0) * k.m * k.g;
        let (sin, versine) = sin_and_versine(y);
        let cos = T::from(1.0) - versine;
        let lost = |away: T| {
            let at = motion.at(y + y * away.exp_m1(), eta + away);
            at.slope + weight * at.sin * (k.r * at.cos - k.h * at.sin)
        };
        OnTop {
            motion,
            start,
            drive_start: motion.at(y, eta).inertia * p * p,
            levers: [
                weight * (k.r * cos - k.h * sin),
                weight * (k.r * sin + k.h * cos),
            ],
            lost: Antiderivative::new(from, to, lost),
            range: [from, to].map(T::from),
        }
    }

    /// G.
    fn drive(&self, y: T, away: T) -> T {
        let tangent = (y - self.start.y) / (T::from(1.0) + y * self.start.y);
        let (sin, versine) = sin_and_versine(tangent);
        let [beside, above] = self.levers;
        self.drive_start + (above * versine - beside * sin) + self.lost.at(away)
    }
}

impl<T: Scalar> Tilting<T> for OnTop<'_, T> {
    fn conserved(&self) -> Conserved<T> {
        self.motion.conserved()
    }

    fn at(&self, y: T, eta: T) -> Point<T> {
        let point = self.motion.at(y, eta);
        let away = eta - self.start.eta;
        let [from, to] = self.range;
        let near = self.drive(y, away);
        let drive = (to - away).where_negative(point.drive, near);
        Point {
            drive: (away - from).where_negative(point.drive, drive),
            ..point
        }
    }

    fn terms(&self, point: &Point<T>) -> [T; 2] {
        self.motion.terms(point)
    }

    /// The weight's part has the rounding of the way from the start; what yaw and spin have lost, that of all
    /// the way on which it is summed up.
    fn rounding(&self, point: &Point<T>, eta: T) -> T {
        let away = eta - self.start.eta;
        let [from, to] = self.range;
        let is_outside = (away - from).min(to - away).value() < 0.0;
        if is_outside {
            return self.motion.rounding(point, eta);
        }
        let [weight, turning] = self.terms(point);
        T::from(ROUNDING) * (self.drive_start.abs() + weight * away.abs() + turning * (to - from))
    }

    fn lowest(&self) -> T {
        self.motion.lowest()
    }

    fn highest(&self) -> T {
        self.motion.highest()
    }

    fn gap_beyond(&self, y: T) -> T {
        self.motion.gap_beyond(y)
    }

    fn pressing(&self, point: &Point<T>) -> T {
        self.motion.pressing(point)
    }

    fn resting(&self, point: &Point<T>) -> T {
        self.motion.resting(point)
    }

    fn surely_pressing(&self, low: &Point<T>, high: &Point<T>) -> T {
        self.motion.surely_pressing(low, high)
    }
}
