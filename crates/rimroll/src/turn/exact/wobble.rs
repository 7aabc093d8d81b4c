//! A tilt that hardly changes, so that its energy G is a small difference of large parts.
//!
//! dG/dη is not that small and keeps its digits. Integrated from the start, where G = I φ̇² is known
//! in full, it gives G in full.

use super::tilting::{Conserved, Point, Tilting};
use crate::real::Real;
use core::f64::consts::PI;

/// Up to this length in η.
pub(super) const LONGEST: f64 = 0.4;

/// Chebyshev points: for an entire function over so short a stretch more than enough.
const POINTS: usize = 16;

/// A motion whose η counts from its start.
pub(super) struct Wobble<'a, M, T> {
    motion: &'a M,
    eta_start: T,
    drive_start: T,
    /// Middle and half the length of the stretch.
    middle: f64,
    half: f64,
    /// Chebyshev coefficients of ∫ dG/dη over the stretch.
    integral: [T; POINTS + 1],
}

impl<'a, M: Tilting<T>, T: Real> Wobble<'a, M, T> {
    /// From tan(φ/2), its logarithm and φ̇ at the start, for η between `from` and `to` counted from it.
    pub(super) fn new(motion: &'a M, y: T, eta: T, p: T, from: f64, to: f64) -> Self {
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let angle = |i: usize| PI * (i as f64 + 0.5) / POINTS as f64;
        let slopes: [T; POINTS] = core::array::from_fn(|i| {
            let away = T::from(middle + half * libm::cos(angle(i)));
            motion.at(y + y * away.exp_m1(), eta + away).slope
        });
        let coefficient = |n: usize| {
            let weight = |i: usize| T::from(libm::cos(n as f64 * angle(i)) * 2.0 / POINTS as f64);
            (0..POINTS).fold(T::from(0.0), |sum, i| sum + weight(i) * slopes[i])
        };
        let zero = T::from(0.0);
        let slope: [T; POINTS + 2] =
            core::array::from_fn(|n| if n < POINTS { coefficient(n) } else { zero });
        let mut integral = [zero; POINTS + 1];
        for n in 1..=POINTS {
            integral[n] = T::from(half / (2 * n) as f64) * (slope[n - 1] - slope[n + 1]);
        }
        let inertia = motion.at(y, eta).inertia;
        let mut wobble = Wobble {
            motion,
            eta_start: eta,
            drive_start: zero,
            middle,
            half,
            integral,
        };
        wobble.drive_start = inertia * p * p - wobble.gained(zero);
        wobble
    }

    /// G but for a constant, by Clenshaw's recurrence.
    fn gained(&self, eta: T) -> T {
        let u = (eta - T::from(self.middle)) * T::from(1.0 / self.half);
        let (mut next, mut one_after) = (T::from(0.0), T::from(0.0));
        for &coefficient in self.integral[1..].iter().rev() {
            let this = T::from(2.0) * u * next - one_after + coefficient;
            (next, one_after) = (this, next);
        }
        u * next - one_after
    }
}

impl<M: Tilting<T>, T: Real> Tilting<T> for Wobble<'_, M, T> {
    fn conserved(&self) -> Conserved<T> {
        self.motion.conserved()
    }

    fn at(&self, y: T, eta: T) -> Point<T> {
        Point {
            drive: self.drive_start + self.gained(eta),
            ..self.motion.at(y, self.eta_start + eta)
        }
    }

    fn lowest(&self) -> T {
        self.motion.lowest()
    }

    fn highest(&self) -> T {
        self.motion.highest()
    }

    /// Far, against a tilt that hardly changes.
    fn gap_beyond(&self, _: T) -> T {
        T::from(1.0)
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
