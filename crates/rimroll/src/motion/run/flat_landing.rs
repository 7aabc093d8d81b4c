//! The motion after the whole base of a body has come down flat at once.

use super::pass_near_collision;
use crate::ending::{FACE_DOWN_TILT, Status};
use crate::law::DynamicsExt;
use crate::motion::contacts::Contacts;
use crate::motion::flat_landing::{
    FlatLanding, fallen, on_face_of, on_first_face, plastic_factor, rocked_over,
};
use crate::motion::instant::{Instant, Phase};
use crate::motion::level_base::{FLAT_TILT, UPLIFT_TILT};
use crate::motion::options::Options;
use crate::solve::Dense;
use crate::state::{COORDINATES, Coordinates};
use std::sync::Arc;

/// The body with its base flat, at the end of the fall over the gap, and the side on which it passes upright: the sign of
/// the yaw's change, or `None` where it falls in a plane within rounding errors. A disk on its other face is turned to
/// its first one.
pub(super) fn fallen_flat(contacts: &Contacts, at: &Instant) -> (Instant, Option<f64>) {
    let first = on_first_face(at);
    if first.w == 0.0 && contacts.flat_gap() == 0.0 {
        return (Instant { u: first, ..*at }, None);
    }
    let friction = &contacts.contact_law().friction;
    let rolls = at.phase == Phase::Rolling;
    let u = fallen(contacts.dynamics(at.phase), friction, rolls, &first);
    let side = contacts.is_beside_plane(&first).then_some(first.w.signum());
    (Instant { u, ..*at }, side)
}

/// The coordinates after the base of a body at `at`, which is its first face, has come down flat on a side or in a plane;
/// `None` where the motion ends. This is the landing number `landing` of the motion.
pub(super) fn landed(
    contacts: &Arc<Contacts>,
    options: &Options,
    (at, side): (&Instant, Option<f64>),
    landing: u64,
) -> Option<Coordinates<f64>> {
    match options.flat {
        FlatLanding::Stop => None,
        FlatLanding::Smooth(drawn) => {
            let side = side.unwrap_or_else(|| drawn.sign(landing));
            smooth(contacts, options, at, side)
        }
        FlatLanding::Housner => Some(after_collision(contacts, at, None)),
        FlatLanding::Restitution(factor) => Some(after_collision(contacts, at, Some(factor))),
    }
}

/// The rest of the fall of a body whose contact point resistance has stopped: a rotation about the contact point, until the
/// base is flat or the body is lifted again. Resistance only keeps the contact point where it is.
pub(super) fn last_fall(contacts: &Contacts, at: &Instant) -> Dense<f64, COORDINATES> {
    let flat = if contacts.moves() {
        FLAT_TILT
    } else {
        FACE_DOWN_TILT
    };
    let u = contacts.without_running(at.phase, &on_first_face(at));
    let u = Coordinates {
        sin: u.sin.max(flat),
        ..u
    };
    let free = contacts.without_resistance();
    let rates = |u: &Coordinates<f64>| free.dynamics(at.phase).rates(u);
    let at_start = rates(&u);
    let (drop, acceleration) = (u.sin - flat, at_start.p / u.sin);
    let rate_after = |acceleration: f64| {
        let square = u.p * u.p - 2.0 * acceleration * drop;
        -square.max(0.0).sqrt()
    };
    let p = rate_after(acceleration);
    let time = if p < 0.0 {
        -2.0 * drop / (u.p + p)
    } else {
        -u.p / acceleration
    };
    // The rates half-way, where resistance holds the contact point, too: by these the energy changes by the work of table
    // and friction.
    let half_way = Coordinates {
        p: 0.5 * (u.p + p),
        sin: 0.5 * (u.sin + flat),
        cos: 1.0,
        ..u.plus(0.5 * time / u.sin, &at_start)
    };
    let half_way = contacts.without_running(at.phase, &half_way);
    let mean = rates(&half_way);
    let end = Coordinates {
        sin: flat,
        cos: 1.0,
        p: rate_after(mean.p / half_way.sin),
        ..u.plus(time / half_way.sin, &mean)
    };
    let end = on_face_of(at, &contacts.without_running(at.phase, &end));
    Dense::line(time, at.u.into_array(), end.into_array())
}

/// The coordinates after a collision on the flat base, with the lost energy, where φ̇ is multiplied by `factor` or by that
/// of a plastic collision.
fn after_collision(contacts: &Contacts, at: &Instant, factor: Option<f64>) -> Coordinates<f64> {
    let k = contacts.parameters();
    let rolls = at.phase == Phase::Rolling;
    let factor = factor.unwrap_or_else(|| plastic_factor(k, rolls));
    let velocity = contacts.dynamics(at.phase).center_velocity(at);
    let u = rocked_over(k, at, factor, (!rolls).then_some(velocity));
    with_loss(contacts, at, at.phase, u)
}

/// `u` with the energy that it has less than `at` added to the loss in impacts.
pub(super) fn with_loss(
    contacts: &Contacts,
    at: &Instant,
    phase: Phase,
    u: Coordinates<f64>,
) -> Coordinates<f64> {
    let before = contacts.dynamics(at.phase).energy(at).total();
    let after = contacts.dynamics(phase).energy(&u).total();
    Coordinates {
        impact_loss: u.impact_loss + (before - after),
        ..u
    }
}

/// The body after a near-collision in the limit of vanishing sideways motion.
fn smooth(
    contacts: &Arc<Contacts>,
    options: &Options,
    at: &Instant,
    side: f64,
) -> Option<Coordinates<f64>> {
    // The turn is off by as much, in radians.
    const SIDEWAYS: f64 = 1e-9;
    let sideways = SIDEWAYS * at.p.abs();
    let start = Coordinates {
        sin: 0.0,
        cos: 1.0,
        w: side * sideways,
        ..at.u
    };
    let contacts = Arc::new(contacts.without_resistance());
    let (trajectory, status) = pass_near_collision(&contacts, start, sideways, options);
    let end = trajectory.end();
    let is_same = |a: f64, b: f64| (a - b).abs() < 1e3 * sideways;
    let s = if is_same(end.s, at.s) { at.s } else { end.s };
    (status == Status::Finished).then_some(Coordinates {
        sin: UPLIFT_TILT,
        cos: 1.0,
        w: 0.0,
        s,
        ..end.u
    })
}
