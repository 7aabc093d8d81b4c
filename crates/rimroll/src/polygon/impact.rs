//! Impacts: corners come down on the table.
//!
//! The corners that touch stay down or leave upward. Of all supports (one corner, an edge, the face) after whose impact no
//! touching corner moves downward, the one that loses the least energy follows. Without friction this is the plastic
//! impact of Moreau (1988), the projection of the velocities on those that the table allows, in the metric of
//! the kinetic energy. It contains the two impacts of the literature:
//!
//! * the old corner leaves, if that takes it upward: angular momentum about the new corner is conserved (without
//!   slip), as in the rolling polygon of Ruina, Bertram & Srinivasan (2005);
//! * otherwise both corners stay, and angular momentum about the edge is conserved.
//!
//! A block that comes down flat passes on to the opposite edge, as Housner (1963) assumed, for all corners touch and
//! the nearest allowed velocity is that about the far edge. No impact gains energy, because each is a projection.
//!
//! Without slip the impulses that stop a corner may have to pull it down, where its friction lifts it. A body that lands
//! or rebounds so has no support. One that rolls from corner to corner keeps the rule above: its impulses and the force
//! between them are together that of a round rim in the limit of many corners, and that does not pull.
//!
//! With a coefficient of restitution e, from 0 (plastic) to 1, the impulses of the rebound are e times those of the
//! compression (Poisson), and corners that are at rest on the table stay there. With the velocities q before the impact
//! and p after the plastic one,
//!
//! ```text
//! after = p + e (p − Q q).
//! ```
//!
//! * Without friction, Q q = q, which is the generalised Newton law of Moreau (1988).
//! * Without slip, the friction stops the sliding of the corners at once, and they stick while they rebound: Q projects q, in
//!   the metric of the kinetic energy, on the motions in which the corners of the plastic support move only vertically.
//!
//! Since Q is a projection, the impact takes at least the part 1 − e² of the energy that a plastic one takes. Where all
//! corners that were down are in the plastic support (two contacts), they stay down while the others rebound.

use super::body::PolygonalBody;
use super::pose::Pose;
use super::support::{Support, SupportedBody};
use super::{Vector, cross, dot, length, minus, plus, times};
use crate::law::IdealLaw;

/// The support and the pose after an impact.
pub(super) struct AfterImpact {
    pub supported: SupportedBody,
    pub pose: Pose,
}

/// Which supports an impact may lead to.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Allowed {
    /// All after which no touching corner moves downward: the body rolls from corner to corner.
    Any,
    /// The supports among these whose corners are not pulled down: the body lands or rebounds.
    Pushing,
    /// The supports that hold all touching corners: they approach so slowly that the next of ever smaller impacts would follow
    /// at once.
    Together,
}

/// The outcome of a plastic impact of the corners `touching`, those that were carrying included.
pub(super) fn plastic(
    before: &SupportedBody,
    at: &Pose,
    touching: &[i64],
    allowed_supports: Allowed,
) -> Option<AfterImpact> {
    let approach = touching
        .iter()
        .map(|&k| -before.gap(at, k).1)
        .fold(0.0, f64::max);
    // In flight the rate of a height is the difference of two rates.
    let rounding = match before.support {
        Support::Flight(_) => 1e-14 * before.body.round().radius() * length(at.rate),
        _ => 0.0,
    };
    let allowed = -1e-9 * approach - rounding;
    let stays_allowed = |after: &AfterImpact| {
        let rate = |&k: &i64| after.supported.gap(&after.pose, k).1;
        // The corners that are down move within rounding.
        let down = after.supported.corners();
        let others = touching.iter().filter(|k| !down.contains(k));
        others.map(rate).all(|rate| rate >= allowed)
    };
    let candidates = supports(&before.body, touching);
    let mut best: Option<(f64, AfterImpact)> = None;
    for support in candidates {
        let holds_all = match support {
            Support::Corner(_) => touching.len() == 1,
            Support::Edge(_) => touching.len() == 2,
            Support::Face(_) | Support::Flight(_) => true,
        };
        if allowed_supports == Allowed::Together && !holds_all {
            continue;
        }
        let after = impact(before, at, support);
        if !stays_allowed(&after)
            || allowed_supports == Allowed::Pushing && pulls(before, at, &after)
        {
            continue;
        }
        let energy = after.supported.kinetic(&after.pose);
        if best.as_ref().is_none_or(|&(most, _)| energy > most) {
            best = Some((energy, after));
        }
    }
    best.map(|(_, after)| after)
}

/// The supports that touching corners can form.
fn supports(body: &PolygonalBody, touching: &[i64]) -> Vec<Support> {
    let count = i64::from(body.corners());
    let touches = |k: i64| touching.iter().any(|&other| (other - k) % count == 0);
    let corners = touching.iter().map(|&k| Support::Corner(k));
    let edges = touching
        .iter()
        .filter(|&&k| touches(k + 1))
        .map(|&k| Support::Edge(k));
    let face = (touching.len() > 2).then(|| Support::Face(touching[0]));
    corners.chain(edges).chain(face).collect()
}

/// The impact after which a given support carries the body.
fn impact(before: &SupportedBody, at: &Pose, support: Support) -> AfterImpact {
    let supported = SupportedBody::new(&before.body, before.law, before.gravity, support);
    let rate = match before.law {
        IdealLaw::NoSlip => sticking(before, at, support),
        IdealLaw::Frictionless => sliding(before, at, support),
    };
    AfterImpact {
        supported,
        pose: Pose { rate, ..*at },
    }
}

/// The corners of the support come to rest.
fn sticking(before: &SupportedBody, at: &Pose, support: Support) -> Vector {
    let body = &before.body;
    let k = support.corner();
    let b = body.corner(k);
    let momentum = plus(
        body.inertia(at.rate),
        -body.mass(),
        cross(b, before.velocity(at)),
    );
    match support {
        Support::Corner(_) => body.per_inertia_about(b, momentum),
        Support::Edge(_) => {
            let edge = body.edge(k);
            times(dot(edge, momentum) / body.edge_inertia(k), edge)
        }
        Support::Face(_) | Support::Flight(_) => [0.0; 3],
    }
}

/// Whether a corner that comes to rest would have to be pulled down. Without friction the projection excludes this.
fn pulls(before: &SupportedBody, at: &Pose, after: &AfterImpact) -> bool {
    let AfterImpact { supported, pose } = after;
    let body = &supported.body;
    if supported.law == IdealLaw::Frictionless {
        return false;
    }
    let gained = minus(supported.velocity(pose), before.velocity(at));
    let turned = minus(pose.rate, at.rate);
    let speed = length(before.velocity(at)) + body.round().radius() * length(at.rate);
    let least = -1e-9 * body.mass() * speed;
    let total = body.mass() * dot(at.up, gained);
    match supported.support {
        Support::Edge(k) => {
            let (edge, first) = (body.edge(k), body.corner(k));
            let over = minus(body.corner(k + 1), first);
            let moment = plus(body.inertia(turned), -body.mass(), cross(first, gained));
            let second = dot(cross(edge, at.up), moment) / length(over);
            second < least || total - second < least
        }
        _ => total < least,
    }
}

/// The corners of the support stop moving downward; on its face the body can still turn about the vertical.
fn sliding(before: &SupportedBody, at: &Pose, support: Support) -> Vector {
    let body = &before.body;
    let k = support.corner();
    let lever = |k| cross(body.corner(k), at.up);
    let mobility = |j, k| 1.0 / body.mass() + dot(lever(j), body.per_inertia(lever(k)));
    let approach = |k| -before.gap(at, k).1;
    let struck = |rate: Vector, k, impulse| plus(rate, impulse, body.per_inertia(lever(k)));
    match support {
        Support::Corner(_) => struck(at.rate, k, approach(k) / mobility(k, k)),
        Support::Edge(_) => {
            let (a, b, c) = (mobility(k, k), mobility(k + 1, k + 1), mobility(k, k + 1));
            let (p, q) = (approach(k), approach(k + 1));
            let determinant = a * b - c * c;
            let impulses = [(b * p - c * q) / determinant, (a * q - c * p) / determinant];
            struck(struck(at.rate, k, impulses[0]), k + 1, impulses[1])
        }
        Support::Face(_) | Support::Flight(_) => [0.0, 0.0, at.rate[2]],
    }
}

/// The most impacts at one time: a rebound may press another touching corner down, which then rebounds.
const MOST: usize = 32;

/// The outcome of an impact of the corners `touching` with restitution.
pub(super) fn resolve(
    before: &SupportedBody,
    at: &Pose,
    touching: &[i64],
    restitution: f64,
) -> Option<AfterImpact> {
    let rolls = restitution == 0.0 && !before.support.is_flight();
    let supports = if rolls {
        Allowed::Any
    } else {
        Allowed::Pushing
    };
    let mut after = plastic(before, at, touching, supports)?;
    if restitution == 0.0 {
        return Some(after);
    }
    after = rebound(before, at, &after, restitution);
    for _ in 0..MOST {
        let rate = |&k: &i64| after.supported.gap(&after.pose, k).1;
        let fastest = touching
            .iter()
            .map(rate)
            .fold(0.0, |a: f64, b| a.max(b.abs()));
        if touching
            .iter()
            .map(rate)
            .all(|rate| rate >= -1e-9 * fastest)
        {
            return Some(after);
        }
        let next = plastic(&after.supported, &after.pose, touching, supports)?;
        after = rebound(&after.supported, &after.pose, &next, restitution);
    }
    plastic(&after.supported, &after.pose, touching, supports)
}

fn rebound(
    before: &SupportedBody,
    at: &Pose,
    stopped: &AfterImpact,
    restitution: f64,
) -> AfterImpact {
    let beyond = |stopped: Vector, stuck| plus(stopped, restitution, minus(stopped, stuck));
    let held = stopped.supported.corners();
    let down = before.corners();
    let count = i64::from(before.body.corners());
    let is_held = |k: &i64| held.iter().any(|other| (other - k) % count == 0);
    let stays_down = !down.is_empty() && down.iter().all(is_held);
    let (supported, pose) = (&stopped.supported, &stopped.pose);
    match (before.law, stays_down) {
        (_, true) => {
            let stuck = match before.law {
                IdealLaw::NoSlip => without_turning(before, at),
                IdealLaw::Frictionless => at.rate,
            };
            AfterImpact {
                supported: *before,
                pose: Pose {
                    rate: beyond(pose.rate, stuck),
                    ..*at
                },
            }
        }
        (IdealLaw::Frictionless, false) => {
            let rise = supported.rise(pose);
            let rise = rise + restitution * (rise - before.rise(at));
            released(
                supported,
                at,
                beyond(pose.rate, at.rate),
                times(rise, at.up),
            )
        }
        (IdealLaw::NoSlip, false) => {
            let (stuck, approach) = without_sliding(before, at, supported.support);
            let rate = beyond(pose.rate, stuck);
            let upward = times(-restitution * approach, at.up);
            let arm = supported.body.corner(supported.support.corner());
            released(supported, at, rate, plus(upward, 1.0, cross(arm, rate)))
        }
    }
}

fn released(supported: &SupportedBody, at: &Pose, rate: Vector, velocity: Vector) -> AfterImpact {
    let (supported, pose) = supported.released(at, rate, velocity);
    AfterImpact { supported, pose }
}

/// Q q of a body that pivots about corners that stay down: the angular velocity without its vertical part.
fn without_turning(before: &SupportedBody, at: &Pose) -> Vector {
    let arm = before.body.corner(before.support.corner());
    let turned = before.body.per_inertia_about(arm, at.up);
    plus(at.rate, -dot(at.up, at.rate) / dot(at.up, turned), turned)
}

/// Q q where the corners of a support move only vertically: the angular velocity, and the vertical velocity of the first
/// corner.
///
/// Vertical impulses change neither the vertical momentum that friction leaves, nor do horizontal ones at the corner b the
/// angular momentum about it. With V = Γ · v and g = b × Γ the former give the vertical velocity V + g · Ω of the corner, and
/// the latter (I_b − m g gᵀ) Ω = I q − m b × v + m V g, in all directions on one corner and in the horizontal ones else.
fn without_sliding(before: &SupportedBody, at: &Pose, support: Support) -> (Vector, f64) {
    let body = &before.body;
    let (mass, arm) = (body.mass(), body.corner(support.corner()));
    let velocity = before.velocity(at);
    let (sinking, lever) = (dot(at.up, velocity), cross(arm, at.up));
    let momentum = plus(body.inertia(at.rate), -mass, cross(arm, velocity));
    let momentum = plus(momentum, mass * sinking, lever);
    let rate = match support {
        Support::Corner(_) => {
            let alone = body.per_inertia_about(arm, momentum);
            let back = body.per_inertia_about(arm, lever);
            let share = mass * dot(lever, alone) / (1.0 - mass * dot(lever, back));
            plus(alone, share, back)
        }
        _ => {
            let along = body.edge(support.corner());
            let across = cross(along, at.up);
            let inertia = |a: Vector, b: Vector| {
                dot(a, body.inertia_about(arm, b)) - mass * dot(lever, a) * dot(lever, b)
            };
            let (a, b) = (inertia(along, along), inertia(across, across));
            let c = inertia(along, across);
            let (p, q) = (dot(along, momentum), dot(across, momentum));
            let determinant = a * b - c * c;
            plus(
                times((b * p - c * q) / determinant, along),
                (a * q - c * p) / determinant,
                across,
            )
        }
    };
    (rate, sinking + dot(lever, rate))
}
