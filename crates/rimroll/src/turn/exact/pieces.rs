//! Yaw and time along a piece of the motion, by quadrature in the tilt:
//!
//! ```text
//! dψ = w √(I/G) dη        dt = sin φ √(I/G) dη
//! ```
//!
//! At the smallest and the largest tilt G is zero; there η = η_end ± Λτ² makes the integrand an even
//! analytic function of τ, for which a Gauss-Legendre rule gains digits with every node.

use super::ridge::Ridge;
use super::rule::{Node, Rule};
use super::tilting::{Pace, Point, Tilting};
use crate::real::{Lanes, Mask, Real};
use core::ops::{Add, Sub};

/// By how much the yaws of a piece by two rules may differ, rad, or relative to a larger one.
const YAW_DIFFERENCE: f64 = 3e-14;

/// The same for its time, relative to it.
const TIME_DIFFERENCE: f64 = 1e-11;

/// What a rule may tell of its error of the yaw, rad, or relative to a larger one. It is far smaller as a rule.
const YAW_TOLERANCE: f64 = 1e-13;

/// The same of the time, relative to it.
const TIME_TOLERANCE: f64 = 2e-11;

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
    pull: T,
}

/// What eight lanes are told of a piece.
#[derive(Debug, Clone, Copy)]
pub(super) struct Told {
    /// rad.
    pub(super) yaw: Lanes,
    /// s.
    pub(super) time: Lanes,
    /// Where the rule has made no error that counts.
    pub(super) is_resolved: Mask,
    /// Where the table pushed at every node, if that was watched.
    pub(super) is_pushed: Mask,
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
        let yaw = (self.yaw - other.yaw).abs() / (YAW_DIFFERENCE * (1.0 + self.yaw.abs()));
        let time = (self.time - other.time).abs() / (TIME_DIFFERENCE * self.time.abs().max(whole));
        if yaw > time { yaw } else { time }
    }
}

impl Piece<Lanes> {
    /// As a rule of n nodes tells it.
    ///
    /// Legendre coefficients of an analytic function fall off like ρ^−k with the degree k, the error of
    /// the rule like ρ^−4n: what is seen of the former at k = 2n − 2 is carried on to there.
    #[inline(always)]
    pub(super) fn told(&self, nodes: usize) -> Told {
        let [yaw, time] = self.tolerances();
        let last = larger(self.last);
        let before = larger(self.before);
        let is_resolved = carried_on(last[0], before[0], nodes)
            .at_most(yaw)
            .and(carried_on(last[1], before[1], nodes).at_most(time));
        Told {
            yaw: self.yaw,
            time: self.time,
            is_resolved,
            is_pushed: self.pull.at_most(Lanes::from(0.0)),
        }
    }

    /// The same where the coefficients swing, so that their last ratio may deceive: as they have fallen off
    /// from the first to the last they also have to go on.
    #[inline(always)]
    pub(super) fn surely_told(&self, nodes: usize) -> Told {
        let margin = Lanes::from(30.0);
        let (told, [yaw, time]) = (self.told(nodes), self.tolerances());
        let [of_yaw, of_time] = larger(self.last);
        Told {
            is_resolved: told
                .is_resolved
                .and((margin * of_yaw * of_yaw).at_most(yaw * self.yaw.abs()))
                .and((margin * of_time * of_time).at_most(time * self.time.abs())),
            ..told
        }
    }

    /// Errors of yaw and time that do not count.
    #[inline(always)]
    fn tolerances(&self) -> [Lanes; 2] {
        [
            Lanes::from(YAW_TOLERANCE) * (Lanes::from(1.0) + self.yaw.abs()),
            Lanes::from(TIME_TOLERANCE) * self.time.abs(),
        ]
    }
}

// Functions, as closures would not be compiled for the registers that these are.

/// Of two coefficients beside one another the larger, for yaw and time.
#[inline(always)]
fn larger([one, beside]: [[Lanes; 2]; 2]) -> [Lanes; 2] {
    [
        one[0].abs().max(beside[0].abs()),
        one[1].abs().max(beside[1].abs()),
    ]
}

/// The error of a rule of n nodes, from coefficients four degrees apart.
#[inline(always)]
fn carried_on(last: Lanes, before: Lanes, nodes: usize) -> Lanes {
    const TINY: f64 = 1e-300;
    let ratio = (last / before.max(Lanes::from(TINY))).min(Lanes::from(1.0));
    last * power(ratio, nodes / 2)
}

/// xⁿ.
#[inline(always)]
fn power(x: Lanes, n: usize) -> Lanes {
    let (mut square, mut left, mut product) = (x, n, Lanes::from(1.0));
    while left > 0 {
        if left % 2 == 1 {
            product = product * square;
        }
        square = square * square;
        left /= 2;
    }
    product
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

/// From the smallest tilt, where y, η and [`Extreme::grazing`](super::extremes::Extreme::grazing) are `low`, up
/// by `length` in η.
///
/// The closer to a face-down collision, the more of the yaw is ∫ y_c dη / √(y² − y_c²), times its
/// factor at y_c: that part is done in closed form, so that the rule need not resolve it.
///
/// If `PASSES`, on to the balance point and over it, to both sides of which the integrand is singular, so that
/// its Legendre coefficients swing; and the table's push is watched.
#[inline(always)]
pub(super) fn from_lowest<const PASSES: bool, T: Real>(
    motion: &impl Tilting<T>,
    [y_low, eta_low, grazing]: [T; 3],
    length: T,
    rule: &Rule,
) -> Piece<T> {
    let whole = risen(length.exp_m1()).sqrt().atan();
    let mut piece = Piece::nothing();
    for node in &rule.nodes {
        let above = length * T::from(node.at * node.at);
        let excess = above.exp_m1();
        let (y, eta) = (y_low + y_low * excess, eta_low + above);
        let pace = if PASSES {
            let point = motion.at(y, eta);
            piece.watch(motion, &point);
            Pace::of(&point)
        } else {
            motion.pace(y, eta)
        };
        // 1/√square and 1/√(y²/y_c² − 1) by one division.
        let (root, rise) = (pace.square.sqrt(), risen(excess).sqrt());
        let both = length * T::from(2.0 * node.at) / (root * rise);
        let rate = rise * both;
        let integrands = [pace.yaw * rate - grazing * root * both, pace.time * rate];
        piece.add_node(integrands, node);
        if PASSES {
            piece.look_beside(integrands, node.beside);
        }
    }
    piece.yaw = piece.yaw + grazing * whole;
    piece
}

/// (1 + e)² − 1.
#[inline(always)]
fn risen<T: Real>(excess: T) -> T {
    excess * (excess + T::from(2.0))
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
        let pace = motion.pace(y, eta_high + below);
        piece.add_node(paced(&pace, length * T::from(2.0 * node.at)), node);
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
        let mut to_sides = [[T::from(0.0); 2]; 2];
        for (integrands, at) in to_sides.iter_mut().zip([node.at, -node.at]) {
            let (y, eta, rate) = ridge.at(middle + half * T::from(at));
            let point = motion.at(y, eta);
            piece.watch(motion, &point);
            *integrands = paced(&Pace::of(&point), half * rate);
        }
        let [up, down] = to_sides;
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
fn paced<T: Real>(pace: &Pace<T>, measure: T) -> [T; 2] {
    let rate = measure / pace.square.sqrt();
    [pace.yaw * rate, pace.time * rate]
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
