//! The sentence that tells the user how a motion ended.

use super::contacts::{Contacts, Phase};
use super::events::was_stopped;
use super::track::{Instant, Track};
use super::{FACE_DOWN_TILT, Options, Status};
use crate::error::formatted;
use crate::solve::Work;
use crate::turn::painleve_friction_at;

/// A time (s) to the microsecond, or in full if it is shorter than a millisecond.
fn formatted_time(t: f64) -> String {
    if t == 0.0 || t >= 1e-3 {
        format!("{t:.6}")
    } else {
        formatted(t)
    }
}

/// The sentence for the user.
pub(super) fn message(
    status: Status,
    contacts: &Contacts,
    track: &Track,
    options: &Options,
    work: &Work,
) -> String {
    let end = track.end();
    let t = formatted_time(end.t);
    match status {
        Status::Finished => format!("followed for the whole {} s", formatted(end.t)),
        Status::Toppled if end.phase == Phase::Lying => format!(
            "toppled: the tilt reached pi/2 at t = {t} s, where its side meets the table; landing there \
             without rebound it {}",
            after_toppling(contacts, &end)
        ),
        Status::Toppled if end.phase == Phase::Flying => format!(
            "toppled in the air: the tilt reached {:.6} rad at t = {t} s, the rim being off the table",
            end.tilt()
        ),
        Status::Toppled => format!(
            "toppled: the tilt reached {:.6} rad at t = {t} s",
            end.tilt()
        ),
        Status::LiftedOff => format!(
            "lifted off at t = {t} s: to stay on the table the rim would have to be pulled down"
        ),
        Status::FaceDown if end.w == 0.0 && end.s == 0.0 => format!(
            "face down at t = {t} s: without any sideways motion the whole rim meets the table at once, \
             and rigid-body mechanics does not say what follows from simultaneous impacts at every point \
             of it. A start with a yaw_rate or spin_rate, however small beside the others (1e-12 of \
             them will do), can be followed past this point"
        ),
        Status::FaceDown if was_stopped(&end) => format!(
            "face down at t = {t} s: resistance has stopped the contact point on the rim, and the base comes \
             down flat, tilting at {:.4} rad/s and spinning about its axis at {:.4} rad/s. Rigid-body \
             mechanics does not say what follows from simultaneous impacts at every point of it",
            end.p, end.s
        ),
        Status::FaceDown => format!(
            "face down at t = {t} s: the tilt falls below {FACE_DOWN_TILT:e} rad, where the contact point \
             would run round the rim in less time than the last digit of t can tell. A start with a \
             larger yaw_rate or spin_rate can be followed past this point"
        ),
        Status::AtRest => format!(
            "at rest at t = {t} s: the base lies flat, and the last {:.1e} of the energy goes with it",
            remaining_energy(contacts, track)
        ),
        Status::Painleve => format!(
            "ended in Painlevé's paradox at t = {t} s: sliding as it does, the rim would be pressed down by \
             its own friction, and rigid-body mechanics has no one answer. At the tilt of {:.6} rad this \
             starts at a friction of {:.4}",
            end.tilt(),
            painleve_friction_at(contacts.parameters(), &end)
        ),
        Status::Failed if work.steps >= options.max_steps => format!(
            "stopped at t = {t} s after max_steps = {} steps",
            options.max_steps
        ),
        Status::Failed => format!("the solver found no step short enough at t = {t} s"),
        Status::Interrupted => format!("interrupted at t = {t} s"),
    }
}

/// What a body does after its side has met the table.
fn after_toppling(contacts: &Contacts, end: &Instant) -> String {
    let k = contacts.parameters();
    let [along, across] = contacts.dynamics(end.phase).slip(end);
    let sliding = libm::hypot(along, across);
    let turning = k.r * (end.s.abs() + end.w.abs());
    if sliding + turning < 1e-3 * (k.g * k.r).sqrt() {
        return "comes to rest".to_owned();
    }
    format!(
        "goes on, sliding at {sliding:.3} m/s, spinning about its axis at {:.3} rad/s and turning about \
         the vertical at {:.3} rad/s",
        end.s, end.w
    )
}

/// The fraction of the initial energy that is left at the end.
fn remaining_energy(contacts: &Contacts, track: &Track) -> f64 {
    let energy = |at: &Instant| contacts.dynamics(at.phase).energy(at).total();
    energy(&track.end()) / energy(&track.start())
}
