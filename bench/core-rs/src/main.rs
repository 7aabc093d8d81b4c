//! The turn of the can and one motion, computed by rimroll's core as a Rust user calls it.

mod column;
#[path = "../../peers-rs/src/protocol.rs"]
mod protocol;

use core::ops::ControlFlow;
use protocol::{Law, Question, Repeated, Start};
use rimroll::turn::exact::Exact;
use rimroll::{Body, ContactLaw, IdealLaw, Options, State, ensemble, presets, simulate};

const GRAVITY: f64 = 9.8;

fn answer(question: &Question) -> Result<Vec<f64>, String> {
    if question.task == "shaken" {
        return column::end_tilts(question);
    }
    let can = presets::can_2007().map_err(|error| error.to_string())?;
    let starts: Vec<_> = question.starts.iter().map(state).collect();
    let law = match question.law {
        Law::NoSlip => IdealLaw::NoSlip,
        Law::Frictionless => IdealLaw::Frictionless,
    };
    let options = Options {
        duration: if question.task == "motion" { 2.0 } else { 10.0 },
        gravity: GRAVITY,
        rtol: question.tolerance,
        ..Options::default()
    };
    match question.method.as_str() {
        "core_motion" => motion(&can, &starts, law, &options),
        "core_quadrature" => quadrature(&can, &starts, law),
        "core_ensemble" => stepping(&can, &starts, law, &options),
        other => Err(format!("knows no method {other}")),
    }
}

fn state(start: &Start) -> State {
    State {
        tilt: start.tilt,
        tilt_rate: start.tilt_rate,
        yaw_rate: start.yaw_rate,
        spin_rate: start.spin_rate,
        ..State::default()
    }
}

/// The yaw and the tilt after two seconds.
fn motion(
    can: &Body,
    starts: &[State],
    law: IdealLaw,
    options: &Options,
) -> Result<Vec<f64>, String> {
    let motion = simulate(can, &starts[0], law, options, |_| ControlFlow::Continue(()))
        .map_err(|error| error.to_string())?;
    let end = motion.trajectory.end().u;
    Ok(vec![end.yaw, end.tilt()])
}

fn quadrature(can: &Body, starts: &[State], law: IdealLaw) -> Result<Vec<f64>, String> {
    let exact = Exact::new(can, law, GRAVITY, None).map_err(|error| error.to_string())?;
    let turns = exact.turns(starts).map_err(|error| error.to_string())?;
    Ok(turns.iter().map(|turn| turn.turn).collect())
}

fn stepping(
    can: &Body,
    starts: &[State],
    law: IdealLaw,
    options: &Options,
) -> Result<Vec<f64>, String> {
    let trials: Vec<_> = starts
        .iter()
        .map(|&at| (can, at, ContactLaw::from(law)))
        .collect();
    let falls = ensemble(&trials, options, |_| ControlFlow::Continue(()))
        .map_err(|error| error.to_string())?;
    let angle = |turn: Option<rimroll::motion::Turn>| turn.map_or(f64::NAN, |turn| turn.angle);
    Ok(falls.iter().map(|fall| angle(fall.turn)).collect())
}

fn main() {
    protocol::serve(Repeated::AtOnce, answer);
}
