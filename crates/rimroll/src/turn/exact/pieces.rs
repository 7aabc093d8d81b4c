//! Yaw and time along a piece of the motion, by quadrature in the tilt:
//!
//! ```text
//! dψ = w √(I/G) dη        dt = sin φ √(I/G) dη
//! ```
//!
//! At the smallest and the largest tilt G is zero; there η = η_end ± Λτ² makes the integrand an even
//! analytic function of τ, for which a Gauss-Legendre rule gains digits with every node.

use super::extremes::Extreme;
use super::ridge::Ridge;
use super::rule::{Node, Rule};
use super::tilting::{Point, Tilting};
use crate::real::Real;
use core::ops::{Add, Sub};

/// Error of the yaw of a piece, rad, or relative to a larger one.
const YAW_TOLERANCE: f64 = 3e-14;

/// Error of the time of a piece, relative to it.
const TIME_TOLERANCE: f64 = 1e-11;

/// Where the table pushes less than this part of the weight at a node or a look, it may have to pull between two.
pub(super) const LEAST_PUSH: f64 = 0.05;

/// Yaw and time along a piece, and what tells how well the rule has resolved it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Piece<T> {
    /// rad.
    pub(super) yaw: T,
    /// s.
    pub(super) time: T,
    /// The last Legendre coefficients of both integrands that the rule can see: one, or, where they may
    /// swing through zero, one beside it.
    last: [[T; 2]; 2],
    /// Those four degrees lower.
    before: [[T; 2]; 2],
    /// Above zero if the table pushed little at a node, or had to pull, where that was watched.
    pub(super) pull: T,
}

impl<T: Real> Piece<T> {
    #[inline(always)]
    pub(super) fn nothing() -> Self {
        let zero = T::from(0.0);
        Piece {
            yaw: zero,
            time: zero,
            last: [[zero; 2]; 2],
            before: [[zero; 2]; 2],
            pull: T::from(f64::NEG_INFINITY),
        }
    }
}

impl<T: Copy> Piece<T> {
    /// Number by number.
    pub(super) fn map<U>(&self, f: impl Fn(T) -> U) -> Piece<U> {
        Piece {
            yaw: f(self.yaw),
            time: f(self.time),
            last: self.last.map(|pair| pair.map(&f)),
            before: self.before.map(|pair| pair.map(&f)),
            pull: f(self.pull),
        }
    }
}

impl Piece<f64> {
    /// How much another, by another rule, differs, in tolerances, of a motion that lasts `whole` (s) or as
    /// long as the piece itself.
    pub(super) fn difference(&self, other: &Piece<f64>, whole: f64) -> f64 {
        let yaw = (self.yaw - other.yaw).abs() / (YAW_TOLERANCE * (1.0 + self.yaw.abs()));
        let time = (self.time - other.time).abs() / (TIME_TOLERANCE * self.time.abs().max(whole));
        if yaw > time { yaw } else { time }
    }

    /// Whether a rule of n nodes has made no error that counts.
    ///
    /// Legendre coefficients of an analytic function fall off like ρ^−k with the degree k, the error of
    /// the rule like ρ^−4n: what is seen of the former at k = 2n − 2 is carried on to there.
    pub(super) fn is_resolved(&self, nodes: usize) -> bool {
        let larger = |[one, beside]: [[f64; 2]; 2], i: usize| one[i].abs().max(beside[i].abs());
        let resolved = |i: usize, tolerance: f64| {
            let (mut error, before) = (larger(self.last, i), larger(self.before, i));
            if error > tolerance {
                let ratio = (error / before).min(1.0);
                error = (0..nodes / 2).fold(error, |error, _| error * ratio);
            }
            error <= tolerance
        };
        let finite = self.yaw.is_finite() && self.time.is_finite();
        finite
            && resolved(0, YAW_TOLERANCE * (1.0 + self.yaw.abs()))
            && resolved(1, TIME_TOLERANCE * self.time.abs())
    }

    /// The same where the coefficients swing, so that their last ratio may deceive: as they have fallen off
    /// from the first to the last they also have to go on.
    pub(super) fn is_surely_resolved(&self, nodes: usize) -> bool {
        const MARGIN: f64 = 30.0;
        let resolved = |i: usize, whole: f64, tolerance: f64| {
            let last = self.last[0][i].abs().max(self.last[1][i].abs());
            MARGIN * last * last <= tolerance * whole.abs()
        };
        self.is_resolved(nodes)
            && resolved(0, self.yaw, YAW_TOLERANCE * (1.0 + self.yaw.abs()))
            && resolved(1, self.time, TIME_TOLERANCE * self.time.abs())
    }
}

impl<T: Real> Add for Piece<T> {
    type Output = Piece<T>;
    #[inline(always)]
    fn add(self, other: Piece<T>) -> Piece<T> {
        Piece {
            yaw: self.yaw + other.yaw,
            time: self.time + other.time,
            ..self
        }
    }
}

impl<T: Real> Sub for Piece<T> {
    type Output = Piece<T>;
    #[inline(always)]
    fn sub(self, other: Piece<T>) -> Piece<T> {
        Piece {
            yaw: self.yaw - other.yaw,
            time: self.time - other.time,
            ..self
        }
    }
}

/// From the smallest tilt up by `length` in η.
///
/// The closer to a face-down collision, the more of the yaw is ∫ y_c dη / √(y² − y_c²), times its
/// factor at y_c: that part is done in closed form, so that the rule need not resolve it.
///
/// If `PASSES`, on to the balance point and over it, to both sides of which the integrand is singular, so that
/// its Legendre coefficients swing; and the table's push is watched.
#[inline(always)]
pub(super) fn from_lowest<const PASSES: bool, T: Real>(
    motion: &impl Tilting<T>,
    low: &Extreme<T>,
    length: T,
    rule: &Rule,
) -> Piece<T> {
    let two = T::from(2.0);
    let factor = low.point.w * (two * low.point.inertia / low.point.slope).sqrt();
    let risen = |excess: T| excess * (excess + two);
    let whole = risen(length.exp_m1()).sqrt().atan();
    let mut piece = Piece::nothing();
    for node in &rule.nodes {
        let above = length * T::from(node.at * node.at);
        let excess = above.exp_m1();
        let y = low.y + low.y * excess;
        let point = motion.at(y, low.eta + above);
        // √(I/G) and 1/√(y²/y_c² − 1) by one division.
        let (drive, rise) = ((point.inertia * point.drive).sqrt(), risen(excess).sqrt());
        let both = length * T::from(2.0 * node.at) / (drive * rise);
        let (pace, split) = (point.inertia * rise * both, factor * drive * both);
        let integrands = [point.w * pace - split, point.sin * pace];
        piece.add_node(integrands, node);
        if PASSES {
            piece.look_beside(integrands, node.beside);
            piece.watch(motion, &point);
        }
    }
    piece.yaw = piece.yaw + factor * whole;
    piece
}

/// From `length` in η below the largest tilt, at y and η, up to it.
#[inline(always)]
pub(super) fn to_highest<T: Real>(
    motion: &impl Tilting<T>,
    [y_high, eta_high]: [T; 2],
    length: T,
    rule: &Rule,
) -> Piece<T> {
    let mut piece = Piece::nothing();
    for node in &rule.nodes {
        let below = length * T::from(-node.at * node.at);
        let y = y_high + y_high * below.exp_m1();
        let point = motion.at(y, eta_high + below);
        let measure = length * T::from(2.0 * node.at);
        piece.add_node(paced(&point, measure), node);
    }
    piece
}

/// From one η to another without a turning back, over the balance point or to its side.
#[inline(always)]
pub(super) fn across<T: Real>(
    motion: &impl Tilting<T>,
    [from, to]: [T; 2],
    ridge: &Ridge<T>,
    rule: &Rule,
) -> Piece<T> {
    let (first, last) = (ridge.clock(from), ridge.clock(to));
    let half = T::from(0.5) * (last - first);
    let middle = first + half;
    let mut piece = Piece::nothing();
    for node in &rule.nodes {
        let mut paced_at = |at: f64| {
            let (y, eta, rate) = ridge.at(middle + half * T::from(at));
            let point = motion.at(y, eta);
            piece.watch(motion, &point);
            paced(&point, half * rate)
        };
        let (up, down) = (paced_at(node.at), paced_at(-node.at));
        piece.add_node([up[0] + down[0], up[1] + down[1]], node);
        piece.look_beside([up[0] - down[0], up[1] - down[1]], node.odd);
    }
    piece
}

/// Between the start, where √G is `speed`, and the extreme, at y and η, so close to it that G has no
/// digits left in between: by √G as clock, and Simpson's rule. Right to the square of `length` and less.
#[inline(always)]
pub(super) fn short<T: Real>(
    motion: &impl Tilting<T>,
    [y_extreme, eta_extreme]: [T; 2],
    length: T,
    speed: T,
) -> Piece<T> {
    let mut piece = Piece::nothing();
    for (part, weight) in [(0.0, 1.0), (0.5, 4.0), (1.0, 1.0)] {
        let away = length * T::from(part * part);
        let y = y_extreme + y_extreme * away.exp_m1();
        let point = motion.at(y, eta_extreme + away);
        let slowness = T::from(weight / 3.0) * point.inertia.sqrt() * speed / point.slope.abs();
        piece.yaw = piece.yaw + point.w * slowness;
        piece.time = piece.time + point.sin * slowness;
    }
    piece
}

/// dψ and dt for a bit dη = `measure`.
#[inline(always)]
fn paced<T: Real>(point: &Point<T>, measure: T) -> [T; 2] {
    let pace = point.inertia * measure / (point.inertia * point.drive).sqrt();
    [point.w * pace, point.sin * pace]
}

impl<T: Real> Piece<T> {
    #[inline(always)]
    fn add_node(&mut self, integrands: [T; 2], node: &Node) {
        self.yaw = self.yaw + T::from(node.weight) * integrands[0];
        self.time = self.time + T::from(node.weight) * integrands[1];
        self.look(0, integrands, [node.last, node.before]);
    }

    #[inline(always)]
    fn look_beside(&mut self, integrands: [T; 2], weights: [f64; 2]) {
        self.look(1, integrands, weights);
    }

    #[inline(always)]
    fn look(&mut self, beside: usize, integrands: [T; 2], [last, before]: [f64; 2]) {
        for (i, integrand) in integrands.into_iter().enumerate() {
            self.last[beside][i] = self.last[beside][i] + T::from(last) * integrand;
            self.before[beside][i] = self.before[beside][i] + T::from(before) * integrand;
        }
    }

    #[inline(always)]
    fn watch(&mut self, motion: &impl Tilting<T>, point: &Point<T>) {
        let least = T::from(LEAST_PUSH) * motion.resting(point);
        self.pull = self.pull.max(least - motion.pressing(point));
    }
}
