//! The smallest and the largest tilt: where the tilt's energy G is zero.

use super::tilting::{Point, Tilting};
use crate::real::{Mask, Real, Vector};

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
    #[inline(always)]
    pub(super) fn place(&self) -> [T; 2] {
        [self.y, self.eta]
    }
}

impl<T: Real> Extreme<T> {
    /// Of a smallest tilt at y_c, what ∫ y_c dη / √(y² − y_c²) is to be taken times to be the yaw nearby.
    #[inline(always)]
    pub(super) fn singular_coefficient(&self) -> T {
        self.point.w * (T::from(2.0) * self.point.inertia / self.point.slope).sqrt()
    }
}

/// The smallest tilt, from a guess of y and η, by `rounds` of Newton's iteration.
#[inline(always)]
pub(super) fn lowest<T: Real>(
    motion: &(impl Tilting<T> + ?Sized),
    guess: [T; 2],
    rounds: usize,
) -> Extreme<T> {
    let mut search = Search::from(guess);
    for _ in 0..rounds {
        let excess = search.excess(motion);
        search.go(lower(excess));
    }
    search.met(motion)
}

/// The largest tilt, from a guess of y and η, by `rounds` of Newton's iteration.
#[inline(always)]
pub(super) fn highest<T: Real>(
    motion: &(impl Tilting<T> + ?Sized),
    guess: [T; 2],
    rounds: usize,
) -> Extreme<T> {
    let mut search = Search::from(guess);
    for _ in 0..rounds {
        let excess = search.excess(motion);
        search.go(higher(excess));
    }
    search.met(motion)
}

/// Both, in at most so many `rounds`, by turns, so that a processor need not wait for the one. An extreme whose y the
/// last round has changed by less than `met`, relative to it, has been met: it stays whatever the other lanes do, and
/// where all have there are no more rounds.
#[inline(always)]
pub(super) fn lowest_and_highest<V: Vector>(
    motion: &impl Tilting<V>,
    [low, high]: [[V; 2]; 2],
    rounds: usize,
    met: f64,
) -> [Extreme<V>; 2] {
    let (mut low, mut high) = (Search::from(low), Search::from(high));
    for _ in 0..rounds {
        let has_met = [low.has_met(met), high.has_met(met)];
        if has_met[0].and(has_met[1]).in_all() {
            break;
        }
        let excess = [low.excess(motion), high.excess(motion)];
        low.go_unless(has_met[0], lower(excess[0]));
        high.go_unless(has_met[1], higher(excess[1]));
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
        let change = T::from(f64::INFINITY);
        Search { y, eta, change }
    }

    /// G over dG/dη.
    #[inline(always)]
    fn excess(&self, motion: &(impl Tilting<T> + ?Sized)) -> T {
        let point = motion.at(self.y, self.eta);
        point.drive / point.slope
    }

    #[inline(always)]
    fn go(&mut self, factor: T) {
        self.change = factor - T::from(1.0);
        self.y = self.y * factor;
        self.eta = self.eta + factor.ln();
    }

    #[inline(always)]
    fn met(self, motion: &(impl Tilting<T> + ?Sized)) -> Extreme<T> {
        Extreme {
            y: self.y,
            eta: self.eta,
            point: motion.at(self.y, self.eta),
            change: self.change.abs(),
        }
    }
}

impl<V: Vector> Search<V> {
    #[inline(always)]
    fn has_met(&self, met: f64) -> V::Mask {
        self.change.abs().at_most(V::from(met))
    }

    #[inline(always)]
    fn go_unless(&mut self, has_met: V::Mask, factor: V) {
        let Search { y, eta, change } = *self;
        self.go(factor);
        self.y = has_met.choose(y, self.y);
        self.eta = has_met.choose(eta, self.eta);
        self.change = has_met.choose(change, self.change);
    }
}

/// By which factor a round of Newton's iteration changes y, in y⁻², of which the energy of yaw is all but a linear
/// function.
#[inline(always)]
fn lower<T: Real>(excess: T) -> T {
    let one = T::from(1.0);
    one / (one + (excess + excess)).sqrt()
}

/// The same in y.
#[inline(always)]
fn higher<T: Real>(excess: T) -> T {
    T::from(1.0) - excess
}
