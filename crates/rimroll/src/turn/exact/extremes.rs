//! The smallest and the largest tilt: where the tilt's energy G is zero.

use super::tilting::{Point, Tilting};
use crate::real::Real;

/// A tilt where the motion turns back.
#[derive(Debug, Clone, Copy)]
pub(super) struct Extreme<T> {
    /// tan(φ/2).
    pub(super) y: T,
    /// Its logarithm.
    pub(super) eta: T,
    /// The motion there.
    pub(super) point: Point<T>,
    /// How much the last step of the iteration changed y, relative to it.
    pub(super) change: T,
}

impl<T: Copy> Extreme<T> {
    /// y and η.
    pub(super) fn place(&self) -> [T; 2] {
        [self.y, self.eta]
    }
}

impl<T: Real> Extreme<T> {
    /// Of a smallest tilt at y_c, what ∫ y_c dη / √(y² − y_c²) is to be taken times to be the yaw nearby.
    #[inline(always)]
    pub(super) fn grazing(&self) -> T {
        self.point.w * (T::from(2.0) * self.point.inertia / self.point.slope).sqrt()
    }
}

/// The smallest tilt, from a guess of y and η, by `rounds` of Newton's iteration.
#[inline(always)]
pub(super) fn lowest<T: Real>(
    motion: &impl Tilting<T>,
    guess: [T; 2],
    rounds: usize,
) -> Extreme<T> {
    let mut search = Search::from(guess);
    for _ in 0..rounds {
        search.go_lower(motion);
    }
    search.met(motion)
}

/// The largest tilt, from a guess of y and η, by `rounds` of Newton's iteration.
#[inline(always)]
pub(super) fn highest<T: Real>(
    motion: &impl Tilting<T>,
    guess: [T; 2],
    rounds: usize,
) -> Extreme<T> {
    let mut search = Search::from(guess);
    for _ in 0..rounds {
        search.go_higher(motion);
    }
    search.met(motion)
}

/// Both, in rounds by turns, so that a processor need not wait for the one.
#[inline(always)]
pub(super) fn lowest_and_highest<T: Real>(
    motion: &impl Tilting<T>,
    [low, high]: [[T; 2]; 2],
    rounds: usize,
) -> [Extreme<T>; 2] {
    let (mut low, mut high) = (Search::from(low), Search::from(high));
    for _ in 0..rounds {
        low.go_lower(motion);
        high.go_higher(motion);
    }
    [low.met(motion), high.met(motion)]
}

/// On the way to an extreme.
struct Search<T> {
    y: T,
    eta: T,
    change: T,
}

impl<T: Real> Search<T> {
    #[inline(always)]
    fn from([y, eta]: [T; 2]) -> Self {
        let change = T::from(0.0);
        Search { y, eta, change }
    }

    /// A round of Newton's iteration in y⁻², of which the energy of yaw is all but a linear function.
    #[inline(always)]
    fn go_lower(&mut self, motion: &impl Tilting<T>) {
        let (one, two) = (T::from(1.0), T::from(2.0));
        let point = motion.at(self.y, self.eta);
        self.go(one / (one + two * point.drive / point.slope).sqrt());
    }

    /// A round of Newton's iteration in y.
    #[inline(always)]
    fn go_higher(&mut self, motion: &impl Tilting<T>) {
        let point = motion.at(self.y, self.eta);
        self.go(T::from(1.0) - point.drive / point.slope);
    }

    #[inline(always)]
    fn go(&mut self, factor: T) {
        self.change = factor - T::from(1.0);
        self.y = self.y * factor;
        self.eta = self.eta + factor.ln();
    }

    #[inline(always)]
    fn met(self, motion: &impl Tilting<T>) -> Extreme<T> {
        Extreme {
            y: self.y,
            eta: self.eta,
            point: motion.at(self.y, self.eta),
            change: self.change.abs(),
        }
    }
}
