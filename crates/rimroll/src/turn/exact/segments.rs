//! Yaw and time along a segment of the motion, by quadrature in the tilt:
//!
//! ```text
//! dψ = w √(I/G) dη        dt = sin φ √(I/G) dη
//! ```
//!
//! At the smallest and the largest tilt, G is zero. There the change of variable η = η_end ± Λτ² makes the
//! integrand an even analytic function of τ, for which Gauss-Legendre rules converge geometrically.

use super::balance_passage::BalancePassage;
use super::quadrature_rule::{MAX_OUTER, Node, Rule, below};
use super::tilt_equation::{Point, TiltEquation, YawAndTimeRates};
use crate::real::{Bits, Lanes, Mask, Real, Vector};
use core::ops::{Add, Sub};

/// Tolerated difference of the yaw of a segment between two rules: rad, or relative where the yaw exceeds 1 rad.
const YAW_DIFFERENCE: f64 = 3e-14;

/// Tolerated relative difference of the time of a segment between two rules.
const TIME_DIFFERENCE: f64 = 1e-11;

/// Tolerance for the error estimate of the yaw: rad, or relative where the yaw exceeds 1 rad. The actual error is
/// usually far smaller.
const YAW_TOLERANCE: f64 = 1e-13;

/// Relative tolerance for the error estimate of the time.
const TIME_TOLERANCE: f64 = 2e-11;

/// Minimum of the normal force at a node or sample, relative to its value under static weight. Where it is smaller,
/// it may be negative between two samples.
pub(super) const MIN_NORMAL_FORCE: f64 = 0.05;

/// Yaw and time along a segment, with the Legendre coefficients that estimate the error of the rule.
#[derive(Debug, Clone, Copy)]
pub(super) struct Segment<T> {
    /// rad.
    pub(super) yaw: T,
    /// s.
    pub(super) time: T,
    /// The last Legendre coefficients of both integrands that the rule resolves. The second pair holds their
    /// neighbours, where the coefficients may oscillate through zero, and otherwise zero.
    last: [[T; 2]; 2],
    /// The coefficients four degrees lower.
    before: [[T; 2]; 2],
    /// Positive if the normal force was below [`MIN_NORMAL_FORCE`] at a node, where it was checked.
    force_deficit: T,
}

/// The integrals along a segment in sixteen lanes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Integral {
    /// rad.
    pub(super) yaw: Lanes,
    /// s.
    pub(super) time: Lanes,
    /// The lanes in which the error estimate is within the tolerances, as bits.
    pub(super) resolved: Bits,
    /// The lanes in which the normal force passed the check at every node, as bits. All bits are set where it was not
    /// checked.
    pub(super) in_contact: Bits,
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
            force_deficit: T::from(f64::NEG_INFINITY),
        }
    }
}

impl<T: Copy> Segment<T> {
    /// Applies a function to every number.
    pub(super) fn map<U>(&self, f: impl Fn(T) -> U) -> Segment<U> {
        Segment {
            yaw: f(self.yaw),
            time: f(self.time),
            last: self.last.map(|pair| pair.map(&f)),
            before: self.before.map(|pair| pair.map(&f)),
            force_deficit: f(self.force_deficit),
        }
    }
}

impl Segment<f64> {
    /// The difference from the result of another rule, in units of the tolerances. The tolerance of the time is
    /// relative to the longer of this segment and `whole` (s).
    pub(super) fn difference(&self, other: &Segment<f64>, whole: f64) -> f64 {
        let yaw = (self.yaw - other.yaw).abs() / (YAW_DIFFERENCE * (1.0 + self.yaw.abs()));
        let time = (self.time - other.time).abs() / (TIME_DIFFERENCE * self.time.abs().max(whole));
        if yaw > time { yaw } else { time }
    }
}

impl<V: Vector> Segment<V> {
    /// The integrals with their error estimate, by a rule of n nodes.
    #[inline(always)]
    pub(super) fn integral(&self, nodes: usize) -> Integral {
        self.integral_where(self.is_resolved(nodes))
    }

    /// The integrals with a second condition on the error, for oscillating coefficients, where the ratio of the
    /// last ones can mislead: the decrease from the first coefficient to the last, applied once more, must also
    /// reach the tolerances.
    #[inline(always)]
    pub(super) fn conservative_integral(&self, nodes: usize) -> Integral {
        let margin = V::from(30.0);
        let [yaw, time] = self.tolerances();
        let [of_yaw, of_time] = larger(self.last);
        let is_sure = self
            .is_resolved(nodes)
            .and((margin * of_yaw * of_yaw).at_most(yaw * self.yaw.abs()))
            .and((margin * of_time * of_time).at_most(time * self.time.abs()));
        self.integral_where(is_sure)
    }

    /// The Legendre coefficients of an analytic function decrease like ρ^−k with the degree k, and the error of a
    /// rule of n nodes like ρ^−4n. The coefficient at k = 2n − 2 is extrapolated to k = 4n.
    #[inline(always)]
    fn is_resolved(&self, nodes: usize) -> V::Mask {
        let [yaw, time] = self.tolerances();
        let (last, before) = (larger(self.last), larger(self.before));
        extrapolated(last[0], before[0], nodes)
            .at_most(yaw)
            .and(extrapolated(last[1], before[1], nodes).at_most(time))
    }

    #[inline(always)]
    fn integral_where(&self, is_resolved: V::Mask) -> Integral {
        Integral {
            yaw: self.yaw.store(),
            time: self.time.store(),
            resolved: is_resolved.bits(),
            in_contact: self.force_deficit.at_most(V::from(0.0)).bits(),
        }
    }

    /// Absolute tolerances of yaw (rad) and time (s).
    #[inline(always)]
    fn tolerances(&self) -> [V; 2] {
        [
            V::from(YAW_TOLERANCE) * (V::from(1.0) + self.yaw.abs()),
            V::from(TIME_TOLERANCE) * self.time.abs(),
        ]
    }
}

/// The larger of two neighbouring coefficients, for yaw and time.
#[inline(always)]
fn larger<T: Real>([one, neighbours]: [[T; 2]; 2]) -> [T; 2] {
    [
        one[0].abs().max(neighbours[0].abs()),
        one[1].abs().max(neighbours[1].abs()),
    ]
}

/// The error estimate of a rule of n nodes, extrapolated from coefficients four degrees apart.
#[inline(always)]
fn extrapolated<T: Real>(last: T, before: T, nodes: usize) -> T {
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

/// Integrates from the smallest tilt y_c up to `length` in η above it. `low` is y, η and
/// [`Extreme::singular_coefficient`](super::tilt_extremes::Extreme::singular_coefficient) there.
///
/// As y_c → 0, the integral ∫ y_c dη / √(y² − y_c²) times the singular coefficient becomes the dominant part of the
/// yaw. That part is evaluated in closed form, so that the rule need not resolve it.
#[inline(always)]
pub(super) fn from_lowest<T: Real>(
    motion: &(impl TiltEquation<T> + ?Sized),
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

/// Integrates as [`from_lowest`] for a motion that topples. The integrand has a conjugate pair of singularities near
/// the balance point, so its Legendre coefficients oscillate and the neighbouring ones are computed, too. The normal
/// force is checked at the nodes.
#[inline(always)]
pub(super) fn from_lowest_toppling<T: Real>(
    motion: &(impl TiltEquation<T> + ?Sized),
    low: [T; 3],
    length: T,
    rule: &Rule,
) -> Segment<T> {
    let mut segment = Segment::nothing();
    for node in &rule.nodes {
        let above = Above::lowest(low, length, T::from(node.at));
        let point = motion.at(above.y, above.eta);
        segment.check_normal_force(motion, &point);
        let integrands = above.integrands(&YawAndTimeRates::of(&point));
        segment.add_node(integrands, node);
        segment.add_neighbouring_coefficients(integrands, node.neighbours);
    }
    segment.yaw = segment.yaw + singular_yaw(low, length);
    segment
}

/// The part of the yaw in closed form, rad.
#[inline(always)]
fn singular_yaw<T: Real>([_, _, singular_coefficient]: [T; 3], length: T) -> T {
    singular_coefficient * square_excess(length.exp_m1()).sqrt().atan()
}

/// A node above the smallest tilt.
struct Above<T> {
    y: T,
    eta: T,
    /// y/y_c − 1.
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

    /// The integrands of yaw, without the part in closed form, and of time.
    #[inline(always)]
    fn integrands(&self, pace: &YawAndTimeRates<T>) -> [T; 2] {
        // One division gives both 1/√square and 1/√(y²/y_c² − 1).
        let (root, rise) = (pace.square.sqrt(), square_excess(self.excess).sqrt());
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
fn square_excess<T: Real>(excess: T) -> T {
    excess * (excess + T::from(2.0))
}

/// Integrates from `length` in η below the largest tilt up to it. `high` is y and η there.
#[inline(always)]
pub(super) fn to_highest<T: Real>(
    motion: &(impl TiltEquation<T> + ?Sized),
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

/// Integrates as [`to_highest`] with a length of [`MAX_OUTER`] in all lanes, for which the rule holds the
/// exponentials.
#[inline(always)]
pub(super) fn outer_to_highest<V: Vector>(
    motion: &impl TiltEquation<V>,
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

/// The integrands of yaw and time at a node below the largest tilt y_high, where y = (1 + `less`) y_high.
#[inline(always)]
fn below_highest<T: Real>(
    motion: &(impl TiltEquation<T> + ?Sized),
    [y_high, eta_high]: [T; 2],
    length: T,
    at: T,
    less: T,
) -> [T; 2] {
    let y = y_high + y_high * less;
    let pace = motion.pace(y, eta_high + below(length, at));
    paced(&pace, length * (at + at))
}

/// Integrates between two η without a turning point in between, across the balance point or on one side of it.
#[inline(always)]
pub(super) fn across<T: Real>(
    motion: &(impl TiltEquation<T> + ?Sized),
    [from, to]: [T; 2],
    passage: &BalancePassage<T>,
    rule: &Rule,
) -> Segment<T> {
    let (first, last) = (passage.u(from), passage.u(to));
    let half = T::from(0.5) * (last - first);
    let middle = first + half;
    let mut segment = Segment::nothing();
    for node in &rule.nodes {
        let mut to_sides = [[T::from(0.0); 2]; 2];
        for (integrands, at) in to_sides.iter_mut().zip([node.at, -node.at]) {
            let (y, eta, rate) = passage.at(middle + half * T::from(at));
            let point = motion.at(y, eta);
            segment.check_normal_force(motion, &point);
            *integrands = paced(&YawAndTimeRates::of(&point), half * rate);
        }
        let [up, down] = to_sides;
        segment.add_node([up[0] + down[0], up[1] + down[1]], node);
        segment.add_neighbouring_coefficients([up[0] - down[0], up[1] - down[1]], node.odd);
    }
    segment
}

/// Integrates between the start, where √G is `speed`, and a turning point at y and η so close that rounding errors
/// dominate G in between. Simpson's rule with √G as variable has an error of second or higher order in `length`.
#[inline(always)]
pub(super) fn short<T: Real>(
    motion: &(impl TiltEquation<T> + ?Sized),
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

/// dψ and dt for dη = `measure`.
#[inline(always)]
fn paced<T: Real>(pace: &YawAndTimeRates<T>, measure: T) -> [T; 2] {
    let rate = measure / pace.square.sqrt();
    [pace.yaw * rate, pace.time * rate]
}

impl<T: Real> Segment<T> {
    #[inline(always)]
    fn add_node(&mut self, integrands: [T; 2], node: &Node) {
        self.yaw = self.yaw + T::from(node.weight) * integrands[0];
        self.time = self.time + T::from(node.weight) * integrands[1];
        self.add_coefficients(0, integrands, [node.last, node.before]);
    }

    #[inline(always)]
    fn add_neighbouring_coefficients(&mut self, integrands: [T; 2], weights: [f64; 2]) {
        self.add_coefficients(1, integrands, weights);
    }

    #[expect(
        clippy::needless_range_loop,
        reason = "an iterator's closures might not be inlined"
    )]
    #[inline(always)]
    fn add_coefficients(
        &mut self,
        neighbours: usize,
        integrands: [T; 2],
        [last, before]: [f64; 2],
    ) {
        for i in 0..2 {
            self.last[neighbours][i] = self.last[neighbours][i] + T::from(last) * integrands[i];
            self.before[neighbours][i] =
                self.before[neighbours][i] + T::from(before) * integrands[i];
        }
    }

    #[inline(always)]
    fn check_normal_force(&mut self, motion: &(impl TiltEquation<T> + ?Sized), point: &Point<T>) {
        let least = T::from(MIN_NORMAL_FORCE) * motion.scaled_weight(point);
        self.force_deficit = self
            .force_deficit
            .max(least - motion.scaled_normal_force(point));
    }
}
