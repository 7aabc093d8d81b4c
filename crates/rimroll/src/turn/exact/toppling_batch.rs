//! Batches of sixteen starts that have no upper turning point below the end. Some come down first and then topple;
//! the others fall over without a smallest tilt.
//!
//! As in [`rocking_batch`](super::rocking_batch), the formulas have no branches and a mask marks the lanes for which they are
//! valid. The nodes of the rules show that G and the normal force stay positive between the smallest tilt and the
//! end.

use super::balance_passage::{Balance, BalancePassage};
use super::quadrature_rule::{Rule, nodes_across, nodes_towards};
use super::rocking_batch::{ROUNDS, is_lowest};
use super::segments::{MIN_NORMAL_FORCE, Segment, across, from_lowest_toppling};
use super::sign_search::SAMPLES;
use super::tilt_equation::Start;
use super::tilt_equation::{Conserved, FLAT, Point, TiltEquation};
use super::tilt_extremes::lowest;
use crate::motion::Outcome;
use crate::real::{Bits, Lanes, Mask, Vector};

/// Length in η of the part below the balance point that is integrated as its passage.
const NEAR: f64 = 0.7;

/// Minimum length in η of the segment from the smallest tilt. Shorter ones are left to [`scalar`](super::scalar).
const MIN_LENGTH: f64 = 1e-2;

/// Minimum width in η of the passage. On a narrower passage, rounding errors dominate G.
const MIN_WIDTH: f64 = 1e-2;

/// Maximum of the rounding error bound of G, relative to G at the balance point on the narrowest passage. Fast
/// spin can exceed it.
const MAX_ROUNDING: f64 = 1e-3;

/// Maximum spacing in η of the samples of G. Larger spacing could miss a minimum.
const MAX_SPACING: f64 = 0.25;

/// The limits of a motion that topples.
#[derive(Debug, Clone, Copy)]
pub(super) struct ToppleLimits {
    pub(super) balance: Balance,
    /// The end: tan(φ/2) and its logarithm.
    pub(super) end: [f64; 2],
    pub(super) ending: Outcome,
}

/// Sixteen motions that topple.
#[derive(Debug, Clone, Copy)]
pub(super) struct Toppling {
    /// y, η and [`Extreme::singular_coefficient`](super::tilt_extremes::Extreme::singular_coefficient) at the smallest tilt.
    pub(super) low: [Lanes; 3],
    /// The smallest tilt, rad.
    pub(super) tilt: Lanes,
    pub(super) conserved: Conserved<Lanes>,
    /// Width in η of the [`BalancePassage`].
    pub(super) width: Lanes,
    /// Estimated numbers of nodes for the three [segments](TopplePart).
    pub(super) nodes: [Lanes; 3],
    /// The lanes that come down and topple, and for which batch quadrature is accurate, as bits.
    pub(super) valid: Bits,
}

/// The smallest tilt and the passage for starts with a decreasing tilt.
#[inline(always)]
pub(super) fn toppling<V: Vector>(
    motion: &impl TiltEquation<V>,
    start: &Start<V>,
    limits: &ToppleLimits,
) -> Toppling {
    let guess = motion.guess_lowest();
    let low = lowest(motion, [guess, guess.ln()], ROUNDS);
    let balance = motion.at(limits.balance.y.into(), limits.balance.eta.into());
    let end = motion.at(limits.end[0].into(), limits.end[1].into());
    let first = motion.at(start.y, start.eta);
    let passage = BalancePassage::new(limits.balance, balance.drive);
    let rounding = motion.rounding(&balance, limits.balance.eta.into());
    let max_rounding = MAX_ROUNDING * MIN_WIDTH * MIN_WIDTH * limits.balance.curvature;
    let lower_length = split(start.eta, limits) - low.eta;
    let valid = is_lowest(&low)
        .and(V::from(FLAT).at_most(low.point.sin))
        .and(V::from(0.0).at_most(balance.drive))
        .and(V::from(MIN_WIDTH).at_most(passage.width()))
        .and(rounding.at_most(V::from(max_rounding)))
        .and(V::from(0.0).at_most(end.drive))
        .and(V::from(0.0).at_most(motion.scaled_normal_force(&first)))
        .and(V::from(0.0).at_most(motion.scaled_normal_force(&end)))
        .and(V::from(MIN_LENGTH).at_most(lower_length));
    let from_split = split(start.eta, limits);
    let half = V::from(0.5);
    let (to_split, to_start) = (passage.u(from_split), passage.u(start.eta));
    let to_end = passage.u(limits.end[1].into());
    let rest = V::from(limits.balance.eta) - from_split;
    Toppling {
        low: V::store_all([low.y, low.eta, low.singular_coefficient()]),
        tilt: (V::from(2.0) * low.y.atan()).store(),
        conserved: V::store_all(motion.conserved()),
        width: passage.width().store(),
        nodes: V::store_all([
            nodes_towards(lower_length, rest, passage.width()),
            nodes_across(half * (to_start - to_split)),
            nodes_across(half * (to_end - to_start)),
        ]),
        valid: valid.bits(),
    }
}

/// The lanes, as bits, of those starts with an increasing tilt that fall over: neither G nor the normal force
/// reaches zero before the end.
#[inline(always)]
pub(super) fn falling_back<V: Vector>(
    motion: &impl TiltEquation<V>,
    start: &Start<V>,
    limits: &ToppleLimits,
) -> Bits {
    let zero = V::from(0.0);
    let step = (V::from(limits.end[1]) - start.eta) * V::from(1.0 / SAMPLES as f64);
    // Where G decreases, it may be smaller between two samples than at both, by up to a quarter of this.
    let margin = step * step * V::from(limits.balance.curvature);
    let first = motion.at(start.y, start.eta);
    let rising = zero.at_most(first.slope);
    let mut valid = rising
        .or(margin.at_most(first.drive))
        .and(step.at_most(V::from(MAX_SPACING)))
        .and(surely_in_contact(motion, &first));
    for sample in 1..=SAMPLES {
        let away = step * V::from(sample as f64);
        let y = start.y + start.y * away.exp_m1();
        let point = motion.at(y, start.eta + away);
        let stays = margin.at_most(point.drive).or(zero.at_most(point.slope));
        valid = valid
            .and(stays)
            .and(zero.at_most(point.drive))
            .and(surely_in_contact(motion, &point));
    }
    valid.bits()
}

/// The lanes in which the normal force is so large that it stays positive nearby.
#[inline(always)]
fn surely_in_contact<V: Vector>(motion: &impl TiltEquation<V>, point: &Point<V>) -> V::Mask {
    (V::from(MIN_NORMAL_FORCE) * motion.scaled_weight(point))
        .at_most(motion.scaled_normal_force(point))
}

/// The end in η of the segment from the smallest tilt: the start, or [`NEAR`] below the balance point if the start
/// is higher.
#[inline(always)]
fn split<V: Vector>(start: V, limits: &ToppleLimits) -> V {
    start.min(V::from(limits.balance.eta - NEAR))
}

impl ToppleLimits {
    /// Whether a start is so near to the balance point, or past it, that the segment to it is split.
    pub(super) fn starts_near_balance(&self, eta: f64) -> bool {
        eta > self.balance.eta - NEAR
    }
}

/// The segments of a turn that ends with toppling.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum TopplePart {
    /// From the smallest tilt to the start, or to the split below the balance point.
    FromLowest,
    /// From the split to the start.
    ToStart,
    /// From the start to the end.
    ToEnd,
}

/// Yaw and time of a segment, for a passage of the given width in η.
#[inline(always)]
pub(super) fn topple_part<V: Vector>(
    part: TopplePart,
    motion: &impl TiltEquation<V>,
    start: &Start<V>,
    low: [V; 3],
    width: V,
    limits: &ToppleLimits,
    rule: &Rule,
) -> Segment<V> {
    let split = split(start.eta, limits);
    let end = V::from(limits.end[1]);
    let passage = BalancePassage::of_width(limits.balance, width);
    match part {
        TopplePart::FromLowest => from_lowest_toppling(motion, low, split - low[1], rule),
        TopplePart::ToStart => across(motion, [split, start.eta], &passage, rule),
        TopplePart::ToEnd => across(motion, [start.eta, end], &passage, rule),
    }
}
