//! Yaw and time along a piece of the motion, by quadrature in the tilt:
//!
//! ```text
//! dψ = w √(I/G) dη        dt = sin φ √(I/G) dη
//! ```
//!
//! At the smallest and the largest tilt G is zero; there η = η_end ± Λτ² makes the integrand an even
//! analytic function of τ, for which a Gauss-Legendre rule gains digits with every node.

use super::MAX_OUTER;
use super::ridge::Ridge;
use super::rule::{Node, Rule, below};
use super::tilting::{Pace, Point, Tilting};
use crate::real::{Bits, Lanes, Mask, Real, Vector};
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
pub(super) const MIN_PUSH: f64 = 0.05;

/// Yaw and time along a piece, and what tells how well the rule has resolved it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Segment<T> {
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

/// What sixteen lanes are told of a piece.
#[derive(Debug, Clone, Copy)]
pub(super) struct Integral {
    /// rad.
    pub(super) yaw: Lanes,
    /// s.
    pub(super) time: Lanes,
    /// Where the rule has made no error that counts, as bits.
    pub(super) resolved: Bits,
    /// Where the table pushed at every node, if that was watched.
    pub(super) pushed: Bits,
}

impl<T: Real> Segment<T> {
    #[inline(always)]
    pub(super) fn nothing() -> Self {
        let zero = T::from(0.0);
        Segment {
            yaw: zero,
            time: zero,
            last: [[zero; 2]; 2],
            before: [[zero; 2]; 2],
            pull: T::from(f64::NEG_INFINITY),
        }
    }
}

impl<T: Copy> Segment<T> {
    /// Number by number.
    pub(super) fn map<U>(&self, f: impl Fn(T) -> U) -> Segment<U> {
        Segment {
            yaw: f(self.yaw),
            time: f(self.time),
            last: self.last.map(|pair| pair.map(&f)),
            before: self.before.map(|pair| pair.map(&f)),
            pull: f(self.pull),
        }
    }
}

impl Segment<f64> {
    /// How much another, by another rule, differs, in tolerances, of a motion that lasts `whole` (s) or as
    /// long as the piece itself.
    pub(super) fn difference(&self, other: &Segment<f64>, whole: f64) -> f64 {
        let yaw = (self.yaw - other.yaw).abs() / (YAW_DIFFERENCE * (1.0 + self.yaw.abs()));
        let time = (self.time - other.time).abs() / (TIME_DIFFERENCE * self.time.abs().max(whole));
        if yaw > time { yaw } else { time }
    }
}

impl<V: Vector> Segment<V> {
    /// As a rule of n nodes tells it.
    #[inline(always)]
    pub(super) fn integral(&self, nodes: usize) -> Integral {
        self.integral_where(self.is_resolved(nodes))
    }

    /// The same where the coefficients swing, so that their last ratio may deceive: as they have fallen off
    /// from the first to the last they also have to go on.
    #[inline(always)]
    pub(super) fn integral_if_sure(&self, nodes: usize) -> Integral {
        let margin = V::from(30.0);
        let [yaw, time] = self.tolerances();
        let [of_yaw, of_time] = larger(self.last);
        let is_sure = self
            .is_resolved(nodes)
            .and((margin * of_yaw * of_yaw).at_most(yaw * self.yaw.abs()))
            .and((margin * of_time * of_time).at_most(time * self.time.abs()));
        self.integral_where(is_sure)
    }

    /// Legendre coefficients of an analytic function fall off like ρ^−k with the degree k, the error of
    /// a rule of n nodes like ρ^−4n: what is seen of the former at k = 2n − 2 is carried on to there.
    #[inline(always)]
    fn is_resolved(&self, nodes: usize) -> V::Mask {
        let [yaw, time] = self.tolerances();
        let (last, before) = (larger(self.last), larger(self.before));
        carried_on(last[0], before[0], nodes)
            .at_most(yaw)
            .and(carried_on(last[1], before[1], nodes).at_most(time))
    }

    #[inline(always)]
    fn integral_where(&self, is_resolved: V::Mask) -> Integral {
        Integral {
            yaw: self.yaw.store(),
            time: self.time.store(),
            resolved: is_resolved.bits(),
            pushed: self.pull.at_most(V::from(0.0)).bits(),
        }
    }

    /// Errors of yaw and time that do not count.
    #[inline(always)]
    fn tolerances(&self) -> [V; 2] {
        [
            V::from(YAW_TOLERANCE) * (V::from(1.0) + self.yaw.abs()),
            V::from(TIME_TOLERANCE) * self.time.abs(),
        ]
    }
}

/// Of two coefficients beside one another the larger, for yaw and time.
#[inline(always)]
fn larger<T: Real>([one, beside]: [[T; 2]; 2]) -> [T; 2] {
    [
        one[0].abs().max(beside[0].abs()),
        one[1].abs().max(beside[1].abs()),
    ]
}

/// The error of a rule of n nodes, from coefficients four degrees apart.
#[inline(always)]
fn carried_on<T: Real>(last: T, before: T, nodes: usize) -> T {
    const TINY: f64 = 1e-300;
    let ratio = (last / before.max(T::from(TINY))).min(T::from(1.0));
    last * power(ratio, nodes / 2)
}

/// xⁿ.
#[inline(always)]
fn power<T: Real>(x: T, n: usize) -> T {
    let (mut square, mut left, mut product) = (x, n, T::from(1.0));
    while left > 0 {
        if left % 2 == 1 {
            product = product * square;
        }
        square = square * square;
        left /= 2;
    }
    product
}

impl<T: Real> Add for Segment<T> {
    type Output = Segment<T>;
    #[inline(always)]
    fn add(self, other: Segment<T>) -> Segment<T> {
        Segment {
            yaw: self.yaw + other.yaw,
            time: self.time + other.time,
            ..self
        }
    }
}

impl<T: Real> Sub for Segment<T> {
    type Output = Segment<T>;
    #[inline(always)]
    fn sub(self, other: Segment<T>) -> Segment<T> {
        Segment {
            yaw: self.yaw - other.yaw,
            time: self.time - other.time,
            ..self
        }
    }
}

/// From the smallest tilt, where y, η and [`Extreme::singular_coefficient`](super::extremes::Extreme::singular_coefficient) are `low`, up
/// by `length` in η.
///
/// The closer to a face-down collision, the more of the yaw is ∫ y_c dη / √(y² − y_c²), times its
/// factor at y_c: that part is done in closed form, so that the rule need not resolve it.
#[inline(always)]
pub(super) fn from_lowest<T: Real>(
    motion: &(impl Tilting<T> + ?Sized),
    low: [T; 3],
    length: T,
    rule: &Rule,
) -> Segment<T> {
    let mut segment = Segment::nothing();
    for node in &rule.nodes {
        let above = Above::lowest(low, length, T::from(node.at));
        let pace = motion.pace(above.y, above.eta);
        segment.add_node(above.integrands(&pace), node);
    }
    segment.yaw = segment.yaw + singular_yaw(low, length);
    segment
}

/// The same on to the balance point and over it, to both sides of which the integrand is singular, so that
/// its Legendre coefficients swing; the table's push is watched.
#[inline(always)]
pub(super) fn from_lowest_passing<T: Real>(
    motion: &(impl Tilting<T> + ?Sized),
    low: [T; 3],
    length: T,
    rule: &Rule,
) -> Segment<T> {
    let mut segment = Segment::nothing();
    for node in &rule.nodes {
        let above = Above::lowest(low, length, T::from(node.at));
        let point = motion.at(above.y, above.eta);
        segment.watch(motion, &point);
        let integrands = above.integrands(&Pace::of(&point));
        segment.add_node(integrands, node);
        segment.look_beside(integrands, node.beside);
    }
    segment.yaw = segment.yaw + singular_yaw(low, length);
    segment
}

/// What the part in closed form comes to.
#[inline(always)]
fn singular_yaw<T: Real>([_, _, singular_coefficient]: [T; 3], length: T) -> T {
    singular_coefficient * risen(length.exp_m1()).sqrt().atan()
}

/// A node above the smallest tilt.
struct Above<T> {
    y: T,
    eta: T,
    /// y over the smallest, less 1.
    excess: T,
    singular_coefficient: T,
    /// dη/dτ.
    measure: T,
}

impl<T: Real> Above<T> {
    #[inline(always)]
    fn lowest([y_low, eta_low, singular_coefficient]: [T; 3], length: T, at: T) -> Self {
        let above = length * (at * at);
        let excess = above.exp_m1();
        Above {
            y: y_low + y_low * excess,
            eta: eta_low + above,
            excess,
            singular_coefficient,
            measure: length * (at + at),
        }
    }

    /// Of yaw, without the part in closed form, and time.
    #[inline(always)]
    fn integrands(&self, pace: &Pace<T>) -> [T; 2] {
        // 1/√square and 1/√(y²/y_c² − 1) by one division.
        let (root, rise) = (pace.square.sqrt(), risen(self.excess).sqrt());
        let both = self.measure / (root * rise);
        let rate = rise * both;
        [
            pace.yaw * rate - self.singular_coefficient * root * both,
            pace.time * rate,
        ]
    }
}

/// (1 + e)² − 1.
#[inline(always)]
fn risen<T: Real>(excess: T) -> T {
    excess * (excess + T::from(2.0))
}

/// From `length` in η below the largest tilt, at y and η, up to it.
#[inline(always)]
pub(super) fn to_highest<T: Real>(
    motion: &(impl Tilting<T> + ?Sized),
    high: [T; 2],
    length: T,
    rule: &Rule,
) -> Segment<T> {
    let mut segment = Segment::nothing();
    for node in &rule.nodes {
        let at = T::from(node.at);
        let integrands = below_highest(motion, high, length, at, below(length, at).exp_m1());
        segment.add_node(integrands, node);
    }
    segment
}

/// The same where all lengths are [`MAX_OUTER`], for which the rule knows the exponentials.
#[inline(always)]
pub(super) fn outer_to_highest<V: Vector>(
    motion: &impl Tilting<V>,
    high: [V; 2],
    rule: &Rule,
) -> Segment<V> {
    let mut segment = Segment::nothing();
    let length = V::from(MAX_OUTER);
    for node in &rule.nodes {
        let integrands = below_highest(motion, high, length, V::from(node.at), V::from(node.less));
        segment.add_node(integrands, node);
    }
    segment
}

/// Of yaw and time, at a node below the largest tilt, where y is `less` + 1 times as large as there.
#[inline(always)]
fn below_highest<T: Real>(
    motion: &(impl Tilting<T> + ?Sized),
    [y_high, eta_high]: [T; 2],
    length: T,
    at: T,
    less: T,
) -> [T; 2] {
    let y = y_high + y_high * less;
    let pace = motion.pace(y, eta_high + below(length, at));
    paced(&pace, length * (at + at))
}

/// From one η to another without a turning back, over the balance point or to its side.
#[inline(always)]
pub(super) fn across<T: Real>(
    motion: &(impl Tilting<T> + ?Sized),
    [from, to]: [T; 2],
    ridge: &Ridge<T>,
    rule: &Rule,
) -> Segment<T> {
    let (first, last) = (ridge.clock(from), ridge.clock(to));
    let half = T::from(0.5) * (last - first);
    let middle = first + half;
    let mut segment = Segment::nothing();
    for node in &rule.nodes {
        let mut to_sides = [[T::from(0.0); 2]; 2];
        for (integrands, at) in to_sides.iter_mut().zip([node.at, -node.at]) {
            let (y, eta, rate) = ridge.at(middle + half * T::from(at));
            let point = motion.at(y, eta);
            segment.watch(motion, &point);
            *integrands = paced(&Pace::of(&point), half * rate);
        }
        let [up, down] = to_sides;
        segment.add_node([up[0] + down[0], up[1] + down[1]], node);
        segment.look_beside([up[0] - down[0], up[1] - down[1]], node.odd);
    }
    segment
}

/// Between the start, where √G is `speed`, and the extreme, at y and η, so close to it that G has no
/// digits left in between: by √G as clock, and Simpson's rule. Right to the square of `length` and less.
#[inline(always)]
pub(super) fn short<T: Real>(
    motion: &(impl Tilting<T> + ?Sized),
    [y_extreme, eta_extreme]: [T; 2],
    length: T,
    speed: T,
) -> Segment<T> {
    let mut segment = Segment::nothing();
    for (part, weight) in [(0.0, 1.0), (0.5, 4.0), (1.0, 1.0)] {
        let away = length * T::from(part * part);
        let y = y_extreme + y_extreme * away.exp_m1();
        let point = motion.at(y, eta_extreme + away);
        let slowness = T::from(weight / 3.0) * point.inertia.sqrt() * speed / point.slope.abs();
        segment.yaw = segment.yaw + point.w * slowness;
        segment.time = segment.time + point.sin * slowness;
    }
    segment
}

/// dψ and dt for a bit dη = `measure`.
#[inline(always)]
fn paced<T: Real>(pace: &Pace<T>, measure: T) -> [T; 2] {
    let rate = measure / pace.square.sqrt();
    [pace.yaw * rate, pace.time * rate]
}

impl<T: Real> Segment<T> {
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

    #[expect(
        clippy::needless_range_loop,
        reason = "an iterator's closures might not be inlined"
    )]
    #[inline(always)]
    fn look(&mut self, beside: usize, integrands: [T; 2], [last, before]: [f64; 2]) {
        for i in 0..2 {
            self.last[beside][i] = self.last[beside][i] + T::from(last) * integrands[i];
            self.before[beside][i] = self.before[beside][i] + T::from(before) * integrands[i];
        }
    }

    #[inline(always)]
    fn watch(&mut self, motion: &(impl Tilting<T> + ?Sized), point: &Point<T>) {
        let least = T::from(MIN_PUSH) * motion.resting(point);
        self.pull = self.pull.max(least - motion.pressing(point));
    }
}
