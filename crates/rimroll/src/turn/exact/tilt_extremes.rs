//! The smallest and the largest tilt: the zeros of the tilt's energy G.

use super::tilt_equation::{Point, TiltEquation};
use crate::real::{Mask, Real, Vector};

/// A turning point of the tilt.
#[derive(Debug, Clone, Copy)]
pub(super) struct Extreme<T> {
    /// tan(φ/2).
    pub(super) y: T,
    /// Its logarithm.
    pub(super) eta: T,
    /// The motion there.
    pub(super) point: Point<T>,
    /// Relative change of y, or change of η, in the last Newton step.
    pub(super) change: T,
}

impl<T: Copy> Extreme<T> {
    /// y and η.
    #[inline(always)]
    pub(super) fn position(&self) -> [T; 2] {
        [self.y, self.eta]
    }
}

impl<T: Real> Extreme<T> {
    /// The singular coefficient c of a smallest tilt y_c, with ψ ≈ c ∫ y_c dη / √(y² − y_c²) nearby.
    #[inline(always)]
    pub(super) fn singular_coefficient(&self) -> T {
        self.point.w * (T::from(2.0) * self.point.inertia / self.point.slope).sqrt()
    }
}

/// The smallest tilt, from a guess of y and η, by `rounds` Newton iterations.
#[inline(always)]
pub(super) fn lowest<T: Real>(
    motion: &(impl TiltEquation<T> + ?Sized),
    guess: [T; 2],
    rounds: usize,
) -> Extreme<T> {
    let mut search = Search::from(guess);
    for _ in 0..rounds {
        let excess = search.excess(motion);
        search.step(lower(excess));
    }
    search.finish(motion)
}

/// The largest tilt, from a guess of y and η, by `rounds` Newton iterations.
#[inline(always)]
pub(super) fn highest<T: Real>(
    motion: &(impl TiltEquation<T> + ?Sized),
    guess: [T; 2],
    rounds: usize,
) -> Extreme<T> {
    let mut search = Search::from(guess);
    for _ in 0..rounds {
        let excess = search.excess(motion);
        search.step(higher(excess));
    }
    search.finish(motion)
}

/// Both turning points, in at most `rounds` Newton iterations. The two iterations alternate, so that the processor can
/// overlap them. A lane has converged when the relative change of y is below `tolerance`. Its value then stays fixed,
/// whatever the other lanes do, and the iteration ends when all lanes have converged.
#[inline(always)]
pub(super) fn lowest_and_highest<V: Vector>(
    motion: &impl TiltEquation<V>,
    [low, high]: [[V; 2]; 2],
    rounds: usize,
    tolerance: f64,
) -> [Extreme<V>; 2] {
    let (mut low, mut high) = (Search::from(low), Search::from(high));
    for _ in 0..rounds {
        let has_converged = [low.has_converged(tolerance), high.has_converged(tolerance)];
        if has_converged[0].and(has_converged[1]).in_all() {
            break;
        }
        let excess = [low.excess(motion), high.excess(motion)];
        low.step_unless(has_converged[0], lower(excess[0]));
        high.step_unless(has_converged[1], higher(excess[1]));
    }
    [low.finish(motion), high.finish(motion)]
}

/// The state of a Newton iteration.
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
    fn excess(&self, motion: &(impl TiltEquation<T> + ?Sized)) -> T {
        let point = motion.at(self.y, self.eta);
        point.drive / point.slope
    }

    #[inline(always)]
    fn step(&mut self, factor: T) {
        self.change = factor - T::from(1.0);
        self.y = self.y * factor;
        self.eta = self.eta + factor.ln();
    }

    #[inline(always)]
    fn finish(self, motion: &(impl TiltEquation<T> + ?Sized)) -> Extreme<T> {
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
    fn has_converged(&self, tolerance: f64) -> V::Mask {
        self.change.abs().at_most(V::from(tolerance))
    }

    #[inline(always)]
    fn step_unless(&mut self, has_converged: V::Mask, factor: V) {
        let Search { y, eta, change } = *self;
        self.step(factor);
        self.y = has_converged.choose(y, self.y);
        self.eta = has_converged.choose(eta, self.eta);
        self.change = has_converged.choose(change, self.change);
    }
}

/// The factor by which a Newton iteration in the variable y⁻² changes y. The energy of yaw is nearly linear in y⁻².
#[inline(always)]
fn lower<T: Real>(excess: T) -> T {
    let one = T::from(1.0);
    one / (one + (excess + excess)).sqrt()
}

/// The factor by which a Newton iteration in the variable y changes y.
#[inline(always)]
fn higher<T: Real>(excess: T) -> T {
    T::from(1.0) - excess
}
