//! Sixteen starts at a time that nothing turns back below the end: which come down and topple, and which fall over
//! as they are.
//!
//! As [`rocking`](super::rocking): without a branch, and each lane says whether the formulas held for it. That
//! the tilt does not turn back on the way, and that the table pushes, is seen at the nodes of the rules.

use super::extremes::lowest;
use super::ridge::{Balance, Ridge};
use super::rocking::{ROUNDS, is_lowest};
use super::rule::{Rule, nodes_across, nodes_towards};
use super::segments::{MIN_PUSH, Segment, across, from_lowest_passing};
use super::start::Start;
use super::tilting::{Conserved, Point, Tilting};
use super::{FLAT, Outcome, SAMPLES};
use crate::real::{Bits, Lanes, Mask, Vector};

/// So much of the way up to the balance point, in η, belongs to its passage.
const NEAR: f64 = 0.7;

/// A piece from the smallest tilt that is shorter, in η, is left to [`scalar`](super::scalar).
const LEAST: f64 = 1e-2;

/// Below this width of the ridge, in η, G is rounding.
const NARROWEST: f64 = 1e-2;

/// Nor may rounding be more than this part of G at the balance point over the narrowest ridge, as that of
/// the energy of a fast spin can be.
const MAX_ROUNDING: f64 = 1e-3;

/// Looks at G farther apart, in η, may miss something.
const FARTHEST: f64 = 0.25;

/// Where a motion may pass.
#[derive(Debug, Clone, Copy)]
pub(super) struct ToppleLimits {
    pub(super) balance: Balance,
    /// Where it ends: tan(φ/2) and its logarithm.
    pub(super) end: [f64; 2],
    pub(super) ending: Outcome,
}

/// How sixteen motions pass.
#[derive(Debug, Clone, Copy)]
pub(super) struct Toppling {
    /// y, η and [`Extreme::singular_coefficient`] at the smallest tilt.
    pub(super) low: [Lanes; 3],
    /// The smallest tilt, rad.
    pub(super) tilt: Lanes,
    pub(super) conserved: Conserved<Lanes>,
    /// Of the [`Ridge`].
    pub(super) width: Lanes,
    /// About how many nodes the stretches need.
    pub(super) nodes: [Lanes; 3],
    /// The lanes that come down, and sixteen at a time can go on with, as bits.
    pub(super) sound: Bits,
}

/// What is on the way of starts that fall.
#[inline(always)]
pub(super) fn toppling<V: Vector>(
    motion: &impl Tilting<V>,
    start: &Start<V>,
    way: &ToppleLimits,
) -> Toppling {
    let guess = motion.lowest();
    let low = lowest(motion, [guess, guess.ln()], ROUNDS);
    let balance = motion.at(way.balance.y.into(), way.balance.eta.into());
    let end = motion.at(way.end[0].into(), way.end[1].into());
    let first = motion.at(start.y, start.eta);
    let ridge = Ridge::new(way.balance, balance.drive);
    let rounding = motion.rounding(&balance, way.balance.eta.into());
    let most_rounding = MAX_ROUNDING * NARROWEST * NARROWEST * way.balance.curvature;
    let foot = split(start.eta, way) - low.eta;
    let sound = is_lowest(&low)
        .and(V::from(FLAT).at_most(low.point.sin))
        .and(V::from(0.0).at_most(balance.drive))
        .and(V::from(NARROWEST).at_most(ridge.width()))
        .and(rounding.at_most(V::from(most_rounding)))
        .and(V::from(0.0).at_most(end.drive))
        .and(V::from(0.0).at_most(motion.pressing(&first)))
        .and(V::from(0.0).at_most(motion.pressing(&end)))
        .and(V::from(LEAST).at_most(foot));
    let from_split = split(start.eta, way);
    let half = V::from(0.5);
    let (to_split, to_start) = (ridge.clock(from_split), ridge.clock(start.eta));
    let to_end = ridge.clock(way.end[1].into());
    let rest = V::from(way.balance.eta) - from_split;
    Toppling {
        low: V::store_all([low.y, low.eta, low.singular_coefficient()]),
        tilt: (V::from(2.0) * low.y.atan()).store(),
        conserved: V::store_all(motion.conserved()),
        width: ridge.width().store(),
        nodes: V::store_all([
            nodes_towards(foot, rest, ridge.width()),
            nodes_across(half * (to_start - to_split)),
            nodes_across(half * (to_end - to_start)),
        ]),
        sound: sound.bits(),
    }
}

/// Which starts that rise fall over as they are: the tilt does not turn back, and the table pushes.
#[inline(always)]
pub(super) fn falling_back<V: Vector>(
    motion: &impl Tilting<V>,
    start: &Start<V>,
    way: &ToppleLimits,
) -> Bits {
    let zero = V::from(0.0);
    let step = (V::from(way.end[1]) - start.eta) * V::from(1.0 / SAMPLES as f64);
    // Between two looks G may be smaller by a quarter of this, but where it grows.
    let margin = step * step * V::from(way.balance.curvature);
    let first = motion.at(start.y, start.eta);
    let rising = zero.at_most(first.slope);
    let mut sound = rising
        .or(margin.at_most(first.drive))
        .and(step.at_most(V::from(FARTHEST)))
        .and(surely_pushes(motion, &first));
    for look in 1..=SAMPLES {
        let away = step * V::from(look as f64);
        let y = start.y + start.y * away.exp_m1();
        let point = motion.at(y, start.eta + away);
        let stays = margin.at_most(point.drive).or(zero.at_most(point.slope));
        sound = sound
            .and(stays)
            .and(zero.at_most(point.drive))
            .and(surely_pushes(motion, &point));
    }
    sound.bits()
}

/// Whether the table pushes so much that it need not pull next to there.
#[inline(always)]
fn surely_pushes<V: Vector>(motion: &impl Tilting<V>, point: &Point<V>) -> V::Mask {
    (V::from(MIN_PUSH) * motion.resting(point)).at_most(motion.pressing(point))
}

/// Where the piece from the smallest tilt ends: at the start or, where that is nearer to the balance point or past
/// it, short of that.
#[inline(always)]
fn split<V: Vector>(start: V, way: &ToppleLimits) -> V {
    start.min(V::from(way.balance.eta - NEAR))
}

impl ToppleLimits {
    /// Whether a start is so far up that it has a stretch of its own.
    pub(super) fn has_approach(&self, eta: f64) -> bool {
        eta > self.balance.eta - NEAR
    }
}

/// The pieces of which such a turn is made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Stretch {
    /// From the smallest tilt up to the start or short of the balance point.
    Foot,
    /// From there to the start.
    Approach,
    /// From the start to the end.
    Rest,
}

/// Yaw and time of a stretch, over a ridge of some width.
#[inline(always)]
pub(super) fn stretch<V: Vector>(
    stretch: Stretch,
    motion: &impl Tilting<V>,
    start: &Start<V>,
    low: [V; 3],
    width: V,
    way: &ToppleLimits,
    rule: &Rule,
) -> Segment<V> {
    let split = split(start.eta, way);
    let end = V::from(way.end[1]);
    let ridge = Ridge::of_width(way.balance, width);
    match stretch {
        Stretch::Foot => from_lowest_passing(motion, low, split - low[1], rule),
        Stretch::Approach => across(motion, [split, start.eta], &ridge, rule),
        Stretch::Rest => across(motion, [start.eta, end], &ridge, rule),
    }
}
