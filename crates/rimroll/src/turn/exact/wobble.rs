//! A tilt that hardly changes, so that its energy G is a small difference of large parts.
//!
//! dG/dη is not that small and keeps its digits. Integrated from the start, where G = I φ̇² is known
//! in full, it gives G in full.

use super::antiderivative::Antiderivative;
use super::extremes::Extreme;
use super::start::Start;
use super::tilting::{Conserved, Point, ROUNDING, Tilting};
use crate::real::Real;

/// Up to this length in η.
pub(super) const LONGEST: f64 = 0.4;

/// Chebyshev points: for an entire function over so short a stretch more than enough.
const POINTS: usize = 16;

/// One motion whose η counts from its start.
pub(super) struct Wobble<'a, T> {
    motion: &'a dyn Tilting<T>,
    start: Start<T>,
    drive_start: T,
    gained: Antiderivative<T, POINTS>,
}

impl<'a, T: Real> Wobble<'a, T> {
    /// From a start, for η between `from` and `to` counted from it.
    pub(super) fn new(motion: &'a dyn Tilting<T>, start: Start<T>, from: f64, to: f64) -> Self {
        let Start { y, eta, p, .. } = start;
        let slope = |away: T| motion.at(y + y * away.exp_m1(), eta + away).slope;
        Wobble {
            motion,
            start,
            drive_start: motion.at(y, eta).inertia * p * p,
            gained: Antiderivative::new(from, to, slope),
        }
    }

    /// An extreme, from a guess of η by so many rounds of Newton's iteration: in η, which of a small swing has more
    /// digits than y.
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

impl<T: Real> Tilting<T> for Wobble<'_, T> {
    fn conserved(&self) -> Conserved<T> {
        self.motion.conserved()
    }

    fn at(&self, y: T, eta: T) -> Point<T> {
        Point {
            drive: self.drive_start + self.gained.at(eta),
            ..self.motion.at(y, self.start.eta + eta)
        }
    }

    fn terms(&self, point: &Point<T>) -> [T; 2] {
        self.motion.terms(point)
    }

    /// What is added to G on the way has its rounding, and what there was at the start.
    fn rounding(&self, point: &Point<T>, eta: T) -> T {
        self.motion.rounding(point, eta) * eta.abs() + T::from(ROUNDING) * self.drive_start.abs()
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
