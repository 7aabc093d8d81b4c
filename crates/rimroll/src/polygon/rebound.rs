//! Impacts with a coefficient of restitution e, from 0 (plastic) to 1.
//!
//! The impulses of the rebound are e times those of the compression (Poisson), and corners that are at rest on the table
//! stay there. With the velocities q before the impact and p after the plastic one,
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

use super::impact::{AfterImpact, Allowed, plastic};
use super::pose::Pose;
use super::support::{Support, SupportedBody};
use super::vector::{Vector, cross, dot, minus, plus, times};
use crate::law::IdealLaw;

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
