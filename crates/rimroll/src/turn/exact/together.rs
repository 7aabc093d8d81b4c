//! Eight starts at a time that rock, as most in a study do.
//!
//! The same formulas as for one start alone, without a branch. Each lane says afterwards whether they
//! held for it: whether the iterations met, the rules resolved, the table pushed all the way. What comes
//! out for a start depends on nothing but that start.

use super::extremes::{Extreme, highest, lowest};
use super::pieces::{Piece, from_lowest, short, to_highest};
use super::rule::{Rule, nodes_from_lowest, nodes_to_highest};
use super::start::Start;
use super::tilting::Tilting;
use super::wobble::LONGEST;
use super::{MOST_OUTER, SHORT};
use crate::real::{Lanes, Mask, Real};

/// Newton's iterations for the extremes.
pub(super) const ROUNDS: usize = 3;

/// What the change of the last of them may be: its square is below rounding.
const MET: f64 = 1e-8;

/// Where eight motions turn back.
#[derive(Debug, Clone, Copy)]
pub(super) struct Extremes {
    pub(super) low: Extreme<Lanes>,
    pub(super) high: Extreme<Lanes>,
    /// About how many nodes the foot, the head and the leg need.
    pub(super) nodes: [Lanes; 3],
    /// Of head and leg, minus the square of the τ where the integrand is singular.
    pub(super) square: [Lanes; 2],
    /// The lanes for which these are what they are meant to be, and eight at a time can go on with.
    pub(super) sound: Mask,
}

/// The smallest and the largest tilts, for bodies that rock up to `most`, tan(φ/2), and where dG/dη is there at least
/// `least_slope`.
#[inline(always)]
pub(super) fn extremes(
    motion: &impl Tilting<Lanes>,
    start: &Start<Lanes>,
    most: f64,
    least_slope: f64,
) -> Extremes {
    let guess = |y: Lanes| [y, y.ln()];
    let low = lowest(motion, guess(motion.lowest()), ROUNDS);
    let high = highest(motion, guess(motion.highest()), ROUNDS);
    let zero = Lanes::from(0.0);
    let span = high.eta - low.eta;
    let from_start = high.eta - start.eta;
    let sound = is_lowest(&low)
        .and(high.change.at_most(Lanes::from(MET)))
        // Where it all but lingers G is rounding.
        .and(high.point.slope.at_most(Lanes::from(-least_slope)))
        .and(zero.at_most(motion.surely_pressing(&low.point, &high.point)))
        .and(Lanes::from(super::FLAT).at_most(low.point.sin))
        .and(high.y.at_most(Lanes::from(most)))
        .and(Lanes::from(LONGEST).at_most(span))
        // The start lies in the upper piece.
        .and(from_start.at_most(outer(span)))
        .and((-from_start).at_most(Lanes::from(1e-12)));
    let outer = outer(span);
    let lengths = [outer, from_start.max(Lanes::from(SHORT))];
    let gap = motion.gap_beyond(high.y);
    let square = lengths.map(|length| gap / length);
    let [head, leg] = [0, 1].map(|i| nodes_to_highest(square[i], span / lengths[i]));
    Extremes {
        low,
        high,
        nodes: [nodes_from_lowest(span - outer, outer), head, leg],
        square,
        sound,
    }
}

/// The lanes in which the iteration has met a smallest tilt.
#[inline(always)]
pub(super) fn is_lowest(low: &Extreme<Lanes>) -> Mask {
    let rises = Lanes::from(0.0).at_most(low.point.slope);
    low.change.at_most(Lanes::from(MET)).and(rises)
}

/// How much of a way, in η, belongs to the largest tilt.
#[inline(always)]
fn outer(span: Lanes) -> Lanes {
    (span * Lanes::from(0.5)).min(Lanes::from(MOST_OUTER))
}

/// The pieces of which a turn is made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Part {
    /// From the smallest tilt up.
    Foot,
    /// On to the largest tilt.
    Head,
    /// From the start's tilt to the largest.
    Leg,
    /// The same where the start all but is the largest.
    ShortLeg,
}

/// Yaw and time of a part, between the smallest and the largest tilt at y and η.
#[inline(always)]
pub(super) fn part(
    part: Part,
    motion: &impl Tilting<Lanes>,
    start: &Start<Lanes>,
    [y_low, eta_low]: [Lanes; 2],
    high: [Lanes; 2],
    rule: &Rule,
) -> Piece<Lanes> {
    let [_, eta_high] = high;
    let span = eta_high - eta_low;
    let leg = eta_high - start.eta;
    match part {
        Part::Foot => {
            let low = Extreme {
                y: y_low,
                eta: eta_low,
                point: motion.at(y_low, eta_low),
                change: Lanes::from(0.0),
            };
            from_lowest::<false, Lanes>(motion, &low, span - outer(span), rule)
        }
        Part::Head => to_highest(motion, high, outer(span), rule),
        Part::Leg => to_highest(motion, high, leg, rule),
        Part::ShortLeg => {
            let speed = motion.at(start.y, start.eta).inertia.sqrt() * start.p.abs();
            short(motion, high, -leg, speed)
        }
    }
}
