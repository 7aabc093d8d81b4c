//! Motions whose tilt energy G is a small difference of large terms: oscillations of small amplitude, and starts next to
//! the balance point.
//!
//! At the start G = I φ̇² is known to full precision, and dG/dη suffers no cancellation. In an oscillation the integral of
//! dG/dη from the start therefore gives G to full precision. Next to the balance point only the energy that yaw and spin
//! lose is integrated, and the loss of height as the tilt increases by Δ is
//!
//! ```text
//! z₀ − z = z₀ (1 − cos Δ) − ρ₀ sin Δ
//! ```
//!
//! This is accurate however long the body lingers there.

use super::balance_passage::Balance;
use super::tilt_equation::{Conserved, Point, ROUNDING, Start, TiltEquation, sin_and_versine};
use super::tilt_extremes::Extreme;
use crate::law::Parameters;
use crate::real::{Real, Scalar};
use core::f64::consts::PI;

/// What does not depend on the form of G: the part of [`TiltEquation`] that is that of the field `motion`.
macro_rules! as_in_the_motion {
    () => {
        fn conserved(&self) -> Conserved<T> {
            self.motion.conserved()
        }

        fn terms(&self, point: &Point<T>) -> [T; 2] {
            self.motion.terms(point)
        }

        fn guess_lowest(&self) -> T {
            self.motion.guess_lowest()
        }

        fn guess_highest(&self) -> T {
            self.motion.guess_highest()
        }

        fn scaled_normal_force(&self, point: &Point<T>) -> T {
            self.motion.scaled_normal_force(point)
        }

        fn scaled_weight(&self, point: &Point<T>) -> T {
            self.motion.scaled_weight(point)
        }

        fn normal_force_bound(&self, low: &Point<T>, high: &Point<T>) -> T {
            self.motion.normal_force_bound(low, high)
        }
    };
}

/// Maximum distance in η between the turning points.
pub(super) const MAX_SPAN: f64 = 0.4;

/// Number of Chebyshev points, more than sufficient for an entire function on so short an interval.
const OSCILLATION_POINTS: usize = 16;

/// A motion whose η is measured from its start.
pub(super) struct SmallOscillation<'a, T> {
    motion: &'a dyn TiltEquation<T>,
    start: Start<T>,
    drive_start: T,
    gained: Antiderivative<T, OSCILLATION_POINTS>,
}

impl<'a, T: Real> SmallOscillation<'a, T> {
    /// The motion from a start, for η between `from` and `to` relative to it.
    pub(super) fn new(
        motion: &'a dyn TiltEquation<T>,
        start: Start<T>,
        from: f64,
        to: f64,
    ) -> Self {
        let Start { y, eta, p, .. } = start;
        let slope = |away: T| motion.at(y + y * away.exp_m1(), eta + away).slope;
        SmallOscillation {
            motion,
            start,
            drive_start: motion.at(y, eta).inertia * p * p,
            gained: Antiderivative::new(from, to, slope),
        }
    }

    /// A turning point, from a guess of η by the given number of Newton iterations. The variable is the relative η,
    /// which for a small oscillation has more significant digits than y.
    pub(super) fn extreme(&self, mut eta: T, rounds: usize) -> Extreme<T> {
        let y_start = self.start.y;
        let y = |eta: T| y_start + y_start * eta.exp_m1();
        let mut change = T::from(0.0);
        for _ in 0..rounds {
            let point = self.at(y(eta), eta);
            change = -point.drive / point.slope;
            eta = eta + change;
        }
        Extreme {
            y: y(eta),
            eta,
            point: self.at(y(eta), eta),
            change: change.abs(),
        }
    }
}

impl<T: Real> TiltEquation<T> for SmallOscillation<'_, T> {
    as_in_the_motion!();

    fn at(&self, y: T, eta: T) -> Point<T> {
        Point {
            drive: self.drive_start + self.gained.at(eta),
            ..self.motion.at(y, self.start.eta + eta)
        }
    }

    /// The bound for the change of G since the start, plus that for G at the start.
    fn rounding(&self, point: &Point<T>, eta: T) -> T {
        self.motion.rounding(point, eta) * eta.abs() + T::from(ROUNDING) * self.drive_start.abs()
    }

    /// A distance that is large compared with the oscillation.
    fn gap_beyond(&self, _: T) -> T {
        T::from(1.0)
    }
}

/// Distance in η from the balance point within which a start can linger there.
const NEAR: f64 = 1.0;

/// Distance in η from the balance point, and bound of the passage's width in η, below which G loses significant digits.
const VERY_NEAR: f64 = 0.05;

/// Maximum |G| at the balance point, relative to the [curvature](Balance) there, of a body that lingers.
const MAX_DRIVE: f64 = 0.01;

/// Distance in η beyond the start and the balance point up to which this form of G is used.
const MARGIN: f64 = 0.2;

/// Number of Chebyshev points, for an interval of up to NEAR + 2 MARGIN in η.
const BALANCE_POINTS: usize = 24;

/// Whether a start is so near to the balance point, and so slow, that the batch code would lose digits. A is a lower
/// bound of the inertia I.
pub(super) fn is_near_balance(start: &Start<f64>, a: f64, balance: &Balance) -> bool {
    let drive = a * start.p * start.p;
    (start.eta - balance.eta).abs() < VERY_NEAR && drive < VERY_NEAR * VERY_NEAR * balance.curvature
}

/// Whether a motion from near the balance point lingers there.
pub(super) fn lingers<T: Scalar>(
    motion: &dyn TiltEquation<T>,
    start: &Start<T>,
    balance: &Balance,
) -> bool {
    let drive = motion.at(balance.y.into(), balance.eta.into()).drive;
    (start.eta.value() - balance.eta).abs() < NEAR
        && drive.value().abs() < MAX_DRIVE * balance.curvature
}

/// The motion from a start next to the balance point.
pub(super) struct NearBalance<'a, T> {
    motion: &'a dyn TiltEquation<T>,
    start: Start<T>,
    drive_start: T,
    /// 2mg ρ and 2mg z at the start, J.
    levers: [T; 2],
    /// The gain of G from the energy that yaw and spin have lost since the start, J.
    lost: Antiderivative<T, BALANCE_POINTS>,
    /// The interval in which this form of G is used, as η relative to the start.
    range: [T; 2],
}

impl<'a, T: Scalar> NearBalance<'a, T> {
    /// The motion from a start. `balance` and `end` are the η of the balance point and of the end of the motion.
    pub(super) fn new(
        motion: &'a dyn TiltEquation<T>,
        k: &Parameters<T>,
        start: Start<T>,
        [balance, end]: [f64; 2],
    ) -> Self {
        let Start { y, eta, p, .. } = start;
        let (balance, end) = (balance - eta.value(), end - eta.value());
        let (from, to) = (
            balance.min(0.0) - MARGIN,
            (balance.max(0.0) + MARGIN).min(end),
        );
        let weight = T::from(2.0) * k.m * k.g;
        let (sin, versine) = sin_and_versine(y);
        let cos = T::from(1.0) - versine;
        let lost = |away: T| {
            let at = motion.at(y + y * away.exp_m1(), eta + away);
            at.slope + weight * at.sin * (k.r * at.cos - k.h * at.sin)
        };
        NearBalance {
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

    /// G, J.
    fn drive(&self, y: T, away: T) -> T {
        let tangent = (y - self.start.y) / (T::from(1.0) + y * self.start.y);
        let (sin, versine) = sin_and_versine(tangent);
        let [beside, above] = self.levers;
        self.drive_start + (above * versine - beside * sin) + self.lost.at(away)
    }
}

impl<T: Scalar> TiltEquation<T> for NearBalance<'_, T> {
    as_in_the_motion!();

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

    /// The gravity term has a rounding error proportional to the distance from the start. The error of the
    /// antiderivative is proportional to the length of its interval.
    fn rounding(&self, point: &Point<T>, eta: T) -> T {
        let away = eta - self.start.eta;
        let [from, to] = self.range;
        let is_outside = (away - from).min(to - away).value() < 0.0;
        if is_outside {
            return self.motion.rounding(point, eta);
        }
        let [weight, gyroscopic] = self.terms(point);
        T::from(ROUNDING)
            * (self.drive_start.abs() + weight * away.abs() + gyroscopic * (to - from))
    }

    fn gap_beyond(&self, y: T) -> T {
        self.motion.gap_beyond(y)
    }
}

/// The integral of a smooth function f from zero, on a short interval, by the Chebyshev interpolant of f at N points.
struct Antiderivative<T, const N: usize> {
    /// Centre and half-length of the interval.
    middle: f64,
    half: f64,
    /// Coefficients of the Chebyshev polynomials T₁ … T_N.
    coefficients: [T; N],
    at_zero: T,
}

impl<T: Real, const N: usize> Antiderivative<T, N> {
    /// The antiderivative for arguments between `from` and `to`.
    fn new(from: f64, to: f64, f: impl Fn(T) -> T) -> Self {
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let angle = |i: usize| PI * (i as f64 + 0.5) / N as f64;
        let values: [T; N] =
            core::array::from_fn(|i| f(T::from(middle + half * libm::cos(angle(i)))));
        let coefficient = |n: usize| {
            let weight = |i: usize| T::from(libm::cos(n as f64 * angle(i)) * 2.0 / N as f64);
            (0..N).fold(T::from(0.0), |sum, i| sum + weight(i) * values[i])
        };
        let of_f: [T; N] = core::array::from_fn(coefficient);
        let after = |n: usize| of_f.get(n + 1).map_or(T::from(0.0), |&next| next);
        let coefficients = core::array::from_fn(|i| {
            let n = i + 1;
            T::from(half / (2 * n) as f64) * (of_f[n - 1] - after(n))
        });
        let mut sum = Antiderivative {
            middle,
            half,
            coefficients,
            at_zero: T::from(0.0),
        };
        sum.at_zero = sum.at(T::from(0.0));
        sum
    }

    /// The integral from zero to x, by Clenshaw's recurrence.
    fn at(&self, x: T) -> T {
        let u = (x - T::from(self.middle)) * T::from(1.0 / self.half);
        let (mut next, mut one_after) = (T::from(0.0), T::from(0.0));
        for &coefficient in self.coefficients.iter().rev() {
            let this = T::from(2.0) * u * next - one_after + coefficient;
            (next, one_after) = (this, next);
        }
        u * next - one_after - self.at_zero
    }
}
