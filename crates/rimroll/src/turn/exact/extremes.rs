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

/// The smallest tilt, from a guess of y and η, by `rounds` of Newton's iteration in y⁻², of which the energy of
/// yaw is all but a linear function.
#[inline(always)]
pub(super) fn lowest<T: Real>(
    motion: &impl Tilting<T>,
    guess: [T; 2],
    rounds: usize,
) -> Extreme<T> {
    iterate(motion, guess, rounds, |point| {
        let one = T::from(1.0);
        one / (one + T::from(2.0) * point.drive / point.slope).sqrt()
    })
}

/// The largest tilt, from a guess of y and η, by `rounds` of Newton's iteration in y.
#[inline(always)]
pub(super) fn highest<T: Real>(
    motion: &impl Tilting<T>,
    guess: [T; 2],
    rounds: usize,
) -> Extreme<T> {
    iterate(motion, guess, rounds, |point| {
        T::from(1.0) - point.drive / point.slope
    })
}

#[inline(always)]
fn iterate<T: Real>(
    motion: &impl Tilting<T>,
    [mut y, mut eta]: [T; 2],
    rounds: usize,
    factor: impl Fn(&Point<T>) -> T,
) -> Extreme<T> {
    let mut change = T::from(0.0);
    for _ in 0..rounds {
        let factor = factor(&motion.at(y, eta));
        change = factor - T::from(1.0);
        y = y * factor;
        eta = eta + factor.ln();
    }
    Extreme {
        y,
        eta,
        point: motion.at(y, eta),
        change: change.abs(),
    }
}
