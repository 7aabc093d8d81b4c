//! Batches of sixteen starts that rock, as most starts in a study do.
//!
//! The formulas are those of the scalar code, without branches. A mask marks the lanes for which they are
//! valid: the Newton iterations converged, the rules resolved the integrals, and the normal force stayed
//! positive. The result for a start depends on that start alone.

use super::quadrature_rule::{MAX_OUTER, Rule, nodes_from_lowest, nodes_to_highest};
use super::segments::{Segment, from_lowest, outer_to_highest, short, to_highest};
use super::small_energy::MAX_SPAN;
use super::tilt_equation::Start;
use super::tilt_equation::{Conserved, FLAT, SHORT, TiltEquation};
use super::tilt_extremes::{Extreme, lowest_and_highest};
use crate::real::{Bits, Lanes, Mask, Vector};

/// Maximum number of Newton iterations for the extremes.
pub(super) const ROUNDS: usize = 3;

/// Maximum relative change of the last Newton iteration. Its square is below rounding.
const MAX_CHANGE: f64 = 1e-8;

/// The turning points of sixteen motions.
#[derive(Debug, Clone, Copy)]
pub(super) struct Extremes {
    /// y, η and [`Extreme::singular_coefficient`] at the smallest tilt.
    pub(super) low: [Lanes; 3],
    /// y and η at the largest tilt.
    pub(super) high: [Lanes; 2],
    /// The smallest and the largest tilt, rad.
    pub(super) tilts: [Lanes; 2],
    pub(super) conserved: Conserved<Lanes>,
    /// Estimated numbers of nodes for the segments from the smallest tilt, to the largest tilt, and from the start
    /// to the largest tilt.
    pub(super) nodes: [Lanes; 3],
    /// −τ² at the singularity of the integrand, for the two segments that end at the largest tilt.
    pub(super) square: [Lanes; 2],
    /// The lanes for which these numbers are valid and batch quadrature is accurate, as bits.
    pub(super) valid: Bits,
}

/// The turning points of bodies that rock below tan(φ/2) = `max_y`, with |dG/dη| of at least `min_slope` at the largest
/// tilt.
#[inline(always)]
pub(super) fn extremes<V: Vector>(
    motion: &impl TiltEquation<V>,
    start: &Start<V>,
    max_y: f64,
    min_slope: f64,
) -> Extremes {
    let (guess_low, guess_high) = (motion.guess_lowest(), motion.guess_highest());
    let guesses = [[guess_low, guess_low.ln()], [guess_high, guess_high.ln()]];
    let [low, high] = lowest_and_highest(motion, guesses, ROUNDS, MAX_CHANGE);
    let (zero, two) = (V::from(0.0), V::from(2.0));
    let span = high.eta - low.eta;
    let from_start = high.eta - start.eta;
    let valid = is_lowest(&low)
        .and(high.change.at_most(V::from(MAX_CHANGE)))
        // If the body nearly lingers, rounding errors dominate G.
        .and(high.point.slope.at_most(V::from(-min_slope)))
        .and(zero.at_most(motion.normal_force_bound(&low.point, &high.point)))
        .and(V::from(FLAT).at_most(low.point.sin))
        .and(high.y.at_most(V::from(max_y)))
        .and(V::from(MAX_SPAN).at_most(span))
        // The start lies in the segment next to the largest tilt.
        .and(from_start.at_most(outer(span)))
        .and((-from_start).at_most(V::from(1e-12)));
    let outer = outer(span);
    let start_to_highest = from_start.max(V::from(SHORT));
    let gap = motion.gap_beyond(high.y);
    let square = [gap / outer, gap / start_to_highest];
    Extremes {
        low: V::store_all([low.y, low.eta, low.singular_coefficient()]),
        high: V::store_all(high.position()),
        tilts: V::store_all([two * low.y.atan(), two * high.y.atan()]),
        conserved: V::store_all(motion.conserved()),
        nodes: V::store_all([
            nodes_from_lowest(span - outer, outer),
            nodes_to_highest(square[0], span / outer),
            nodes_to_highest(square[1], span / start_to_highest),
        ]),
        square: V::store_all(square),
        valid: valid.bits(),
    }
}

/// The lanes in which the iteration has converged to a smallest tilt.
#[inline(always)]
pub(super) fn is_lowest<V: Vector>(low: &Extreme<V>) -> V::Mask {
    let rises = V::from(0.0).at_most(low.point.slope);
    low.change.at_most(V::from(MAX_CHANGE)).and(rises)
}

/// The length in η of the segment next to the largest tilt, where both turning points are `span` apart.
#[inline(always)]
fn outer<V: Vector>(span: V) -> V {
    (span * V::from(0.5)).min(V::from(MAX_OUTER))
}

/// The segments of a rocking turn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum TurnPart {
    /// From the smallest tilt to the split.
    FromLowest,
    /// From the split to the largest tilt.
    ToHighest,
    /// From the start to the largest tilt.
    StartToHighest,
    /// From the start to the largest tilt, where these nearly coincide.
    ShortStartToHighest,
}

/// Yaw and time of a segment. `low` and `high` are those of [`Extremes`].
#[inline(always)]
pub(super) fn turn_part<V: Vector>(
    part: TurnPart,
    motion: &impl TiltEquation<V>,
    start: &Start<V>,
    low: [V; 3],
    high: [V; 2],
    rule: &Rule,
) -> Segment<V> {
    let ([_, eta_low, _], [_, eta_high]) = (low, high);
    let span = eta_high - eta_low;
    let start_to_highest = eta_high - start.eta;
    match part {
        TurnPart::FromLowest => from_lowest(motion, low, span - outer(span), rule),
        TurnPart::ToHighest if is_longest(outer(span)) => outer_to_highest(motion, high, rule),
        TurnPart::ToHighest => to_highest(motion, high, outer(span), rule),
        TurnPart::StartToHighest => to_highest(motion, high, start_to_highest, rule),
        TurnPart::ShortStartToHighest => {
            let speed = motion.at(start.y, start.eta).inertia.sqrt() * start.p.abs();
            short(motion, high, -start_to_highest, speed)
        }
    }
}

/// Whether the segment next to the largest tilt has its maximum length in all lanes.
#[inline(always)]
fn is_longest<V: Vector>(outer: V) -> bool {
    V::from(MAX_OUTER).at_most(outer).in_all()
}
