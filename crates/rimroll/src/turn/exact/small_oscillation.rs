//! Oscillations of small amplitude, in which the tilt's energy G is a small difference of large terms.
//!
//! dG/dη suffers no such cancellation. Its integral from the start, where G = I φ̇² is known to full
//! precision, gives G to full precision.

use super::antiderivative::Antiderivative;
use super::start::Start;
use super::tilt_equation::{Conserved, Point, ROUNDING, TiltEquation};
use super::tilt_extremes::Extreme;
use crate::real::Real;

/// Maximum distance in η between the turning points.
pub(super) const MAX_SPAN: f64 = 0.4;

/// Number of Chebyshev points, more than sufficient for an entire function on so short an interval.
const POINTS: usize = 16;

/// A motion whose η is measured from its start.
pub(super) struct SmallOscillation<'a, T> {
    motion: &'a dyn TiltEquation<T>,
    start: Start<T>,
    drive_start: T,
    gained: Antiderivative<T, POINTS>,
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

    /// The bound for the change of G since the start, plus that for G at the start.
    fn rounding(&self, point: &Point<T>, eta: T) -> T {
        self.motion.rounding(point, eta) * eta.abs() + T::from(ROUNDING) * self.drive_start.abs()
    }

    fn guess_lowest(&self) -> T {
        self.motion.guess_lowest()
    }

    fn guess_highest(&self) -> T {
        self.motion.guess_highest()
    }

    /// A distance that is large compared with the oscillation.
    fn gap_beyond(&self, _: T) -> T {
        T::from(1.0)
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
}
