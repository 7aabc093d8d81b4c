//! Describes how a computed motion ended, with the numbers that its sentence needs.

use super::contacts::Contacts;
use super::event_detector::TerminalEvent;
use super::instant::{Instant, Phase};
use super::options::Options;
use super::trajectory::Trajectory;
use crate::ending::{Ending, EndingKind, OnItsSide, Status};
use crate::law::DynamicsExt;
use crate::solve::Work;

/// The ending of a motion with this status and the terminal event of its last phase.
pub(super) fn describe_ending(
    (status, last_event): (Status, Option<TerminalEvent>),
    contacts: &Contacts,
    trajectory: &Trajectory,
    options: &Options,
    work: &Work,
) -> Ending {
    let end = trajectory.end();
    let kind = match status {
        Status::Finished => EndingKind::Finished,
        Status::Toppled if end.phase == Phase::Lying => {
            EndingKind::FellOnItsSide(on_its_side(contacts, &end))
        }
        Status::Toppled if end.phase == Phase::Flying => EndingKind::ToppledInTheAir,
        Status::Toppled => EndingKind::Toppled,
        Status::LiftedOff => EndingKind::LiftedOff,
        Status::FaceDown
            if last_event == Some(TerminalEvent::Flat) && contacts.flat_gap() > 0.0 =>
        {
            let gap = contacts.flat_gap();
            EndingKind::GapClosed { gap }
        }
        Status::FaceDown if end.w == 0.0 && end.s == 0.0 => EndingKind::FaceDown,
        Status::FaceDown if last_event == Some(TerminalEvent::StoppedRunning) => {
            EndingKind::StoppedRunning {
                tilt_rate: end.p,
                axial_spin: end.s,
            }
        }
        Status::FaceDown => EndingKind::TooFlat,
        Status::AtRest => EndingKind::AtRest {
            energy_left: remaining_energy(contacts, trajectory),
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
fn remaining_energy(contacts: &Contacts, trajectory: &Trajectory) -> f64 {
    let energy = |at: &Instant| contacts.dynamics(at.phase).energy(at).total();
    energy(&trajectory.end()) / energy(&trajectory.start())
}
