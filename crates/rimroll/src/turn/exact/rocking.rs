//! Sixteen starts at a time that rock, as most in a study do.
//!
//! The same formulas as for one start alone, without a branch. Each lane says afterwards whether they
//! held for it: whether the iterations met, the rules resolved, the table pushed all the way. What comes
//! out for a start depends on nothing but that start.

use super::extremes::{Extreme, lowest_and_highest};
use super::rule::{Rule, nodes_from_lowest, nodes_to_highest};
use super::segments::{Segment, from_lowest, outer_to_highest, short, to_highest};
use super::start::Start;
use super::tilting::{Conserved, Tilting};
use super::wobble::LONGEST;
use super::{MAX_OUTER, SHORT};
use crate::real::{Bits, Lanes, Mask, Vector};

/// Newton's iterations for the extremes.
pub(super) const ROUNDS: usize = 3;

/// What the change of the last of them may be: its square is below rounding.
const MET: f64 = 1e-8;

/// Where sixteen motions turn back.
#[derive(Debug, Clone, Copy)]
pub(super) struct Extremes {
    /// y, η and [`Extreme::singular_coefficient`] at the smallest tilt.
    pub(super) low: [Lanes; 3],
    /// y and η at the largest.
    pub(super) high: [Lanes; 2],
    /// Both tilts, rad.
    pub(super) tilts: [Lanes; 2],
    pub(super) conserved: Conserved<Lanes>,
    /// About how many nodes the foot, the head and the leg need.
    pub(super) nodes: [Lanes; 3],
    /// Of head and leg, minus the square of the τ where the integrand is singular.
    pub(super) square: [Lanes; 2],
    /// The lanes for which these are what they are meant to be, and sixteen at a time can go on with, as bits.
    pub(super) sound: Bits,
}

/// The smallest and the largest tilts, for bodies that rock up to `most`, tan(φ/2), and where dG/dη is there at least
/// `least_slope`.
#[inline(always)]
pub(super) fn extremes<V: Vector>(
    motion: &impl Tilting<V>,
    start: &Start<V>,
    most: f64,
    least_slope: f64,
) -> Extremes {
    let (guess_low, guess_high) = (motion.lowest(), motion.highest());
    let guesses = [[guess_low, guess_low.ln()], [guess_high, guess_high.ln()]];
    let [low, high] = lowest_and_highest(motion, guesses, ROUNDS, MET);
    let (zero, two) = (V::from(0.0), V::from(2.0));
    let span = high.eta - low.eta;
    let from_start = high.eta - start.eta;
    let sound = is_lowest(&low)
        .and(high.change.at_most(V::from(MET)))
        // Where it all but lingers G is rounding.
        .and(high.point.slope.at_most(V::from(-least_slope)))
        .and(zero.at_most(motion.surely_pressing(&low.point, &high.point)))
        .and(V::from(super::FLAT).at_most(low.point.sin))
        .and(high.y.at_most(V::from(most)))
        .and(V::from(LONGEST).at_most(span))
        // The start lies in the upper piece.
        .and(from_start.at_most(outer(span)))
        .and((-from_start).at_most(V::from(1e-12)));
    let outer = outer(span);
    let leg = from_start.max(V::from(SHORT));
    let gap = motion.gap_beyond(high.y);
    let square = [gap / outer, gap / leg];
    Extremes {
        low: V::store_all([low.y, low.eta, low.singular_coefficient()]),
        high: V::store_all(high.place()),
        tilts: V::store_all([two * low.y.atan(), two * high.y.atan()]),
        conserved: V::store_all(motion.conserved()),
        nodes: V::store_all([
            nodes_from_lowest(span - outer, outer),
            nodes_to_highest(square[0], span / outer),
            nodes_to_highest(square[1], span / leg),
        ]),
        square: V::store_all(square),
        sound: sound.bits(),
    }
}

/// The lanes in which the iteration has met a smallest tilt.
#[inline(always)]
pub(super) fn is_lowest<V: Vector>(low: &Extreme<V>) -> V::Mask {
    let rises = V::from(0.0).at_most(low.point.slope);
    low.change.at_most(V::from(MET)).and(rises)
}

/// How much of a way, in η, belongs to the largest tilt.
#[inline(always)]
fn outer<V: Vector>(span: V) -> V {
    (span * V::from(0.5)).min(V::from(MAX_OUTER))
}

/// The pieces of which a turn is made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum TurnPart {
    /// From the smallest tilt up.
    Foot,
    /// On to the largest tilt.
    Head,
    /// From the start's tilt to the largest.
    Leg,
    /// The same where the start all but is the largest.
    ShortLeg,
}

/// Yaw and time of a part, as [`Extremes`] tells of the smallest and the largest tilt.
#[inline(always)]
pub(super) fn part<V: Vector>(
    part: TurnPart,
    motion: &impl Tilting<V>,
    start: &Start<V>,
    low: [V; 3],
    high: [V; 2],
    rule: &Rule,
) -> Segment<V> {
    let ([_, eta_low, _], [_, eta_high]) = (low, high);
    let span = eta_high - eta_low;
    let leg = eta_high - start.eta;
    match part {
        TurnPart::Foot => from_lowest(motion, low, span - outer(span), rule),
        TurnPart::Head if is_longest(outer(span)) => outer_to_highest(motion, high, rule),
        TurnPart::Head => to_highest(motion, high, outer(span), rule),
        TurnPart::Leg => to_highest(motion, high, leg, rule),
        TurnPart::ShortLeg => {
            let speed = motion.at(start.y, start.eta).inertia.sqrt() * start.p.abs();
            short(motion, high, -leg, speed)
        }
    }
}

/// Whether the outer part is as long as it gets, in all lanes.
#[inline(always)]
fn is_longest<V: Vector>(outer: V) -> bool {
    V::from(MAX_OUTER).at_most(outer).in_all()
}
