//! The ending of a computed motion.

use super::contacts::Contacts;
use super::event_detector::TerminalEvent;
use super::instant::{Instant, Phase};
use super::options::Options;
use super::track::Track;
use crate::ending::{Ending, EndingKind, OnItsSide, Status};
use crate::solve::Work;

/// The ending of a motion with this status and the terminal event of its last phase.
pub(super) fn ending(
    (status, last_event): (Status, Option<TerminalEvent>),
    contacts: &Contacts,
    track: &Track,
    options: &Options,
    work: &Work,
) -> Ending {
    let end = track.end();
    let kind = match status {
        Status::Finished => EndingKind::Finished,
        Status::Toppled if end.phase == Phase::Lying => {
            EndingKind::FellOnItsSide(on_its_side(contacts, &end))
        }
        Status::Toppled if end.phase == Phase::Flying => EndingKind::ToppledInTheAir,
        Status::Toppled => EndingKind::Toppled,
        Status::LiftedOff => EndingKind::LiftedOff,
        Status::FaceDown if end.w == 0.0 && end.s == 0.0 => EndingKind::FaceDown,
        Status::FaceDown if last_event == Some(TerminalEvent::StoppedRunning) => {
            EndingKind::StoppedRunning {
                tilt_rate: end.p,
                axial_spin: end.s,
            }
        }
        Status::FaceDown => EndingKind::TooFlat,
        Status::AtRest => EndingKind::AtRest {
            energy_left: remaining_energy(contacts, track),
        },
        Status::Painleve => EndingKind::Painleve {
            friction: contacts.parameters().painleve_friction(&end),
        },
        Status::Failed if work.steps >= options.max_steps => EndingKind::OutOfSteps {
            max_steps: options.max_steps,
        },
        Status::Failed => EndingKind::NoStep,
        Status::Interrupted => EndingKind::Interrupted,
    };
    Ending {
        kind,
        t: end.t,
        tilt: end.tilt(),
    }
}

fn on_its_side(contacts: &Contacts, end: &Instant) -> OnItsSide {
    let k = contacts.parameters();
    let [along, across] = contacts.dynamics(end.phase).slip(end);
    let sliding = libm::hypot(along, across);
    let turning = k.r * (end.s.abs() + end.w.abs());
    OnItsSide {
        sliding,
        axial_spin: end.s,
        turning: end.w,
        is_at_rest: sliding + turning < 1e-3 * (k.g * k.r).sqrt(),
    }
}

/// The fraction of the initial energy that is left at the end.
fn remaining_energy(contacts: &Contacts, track: &Track) -> f64 {
    let energy = |at: &Instant| contacts.dynamics(at.phase).energy(at).total();
    energy(&track.end()) / energy(&track.start())
}
