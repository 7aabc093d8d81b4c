//! One motion by rimroll's core, as a Rust user calls it.

#[path = "../../peers-rs/src/protocol.rs"]
mod protocol;

use core::ops::ControlFlow;
use protocol::{Law, Question};
use rimroll::{IdealLaw, Options, State, presets, simulate};

/// The yaw and the tilt after two seconds.
fn motion(question: &Question) -> Result<Vec<f64>, String> {
    if question.task != "motion" || question.method != "rimroll_core" {
        return Err(format!("knows no {} by {}", question.task, question.method));
    }
    if question.coordinates != "regular" {
        return Err(format!("knows no coordinates {}", question.coordinates));
    }
    let can = presets::can_2007().map_err(|error| error.to_string())?;
    let law = match question.law {
        Law::NoSlip => IdealLaw::NoSlip,
        Law::Frictionless => IdealLaw::Frictionless,
    };
    let options = Options {
        duration: 2.0,
        gravity: 9.8,
        rtol: question.tolerance,
        ..Options::default()
    };
    let [first, ..] = question.starts[..] else {
        return Err("has no start".into());
    };
    let start = State {
        tilt: first.tilt,
        tilt_rate: first.tilt_rate,
        yaw_rate: first.yaw_rate,
        spin_rate: first.spin_rate,
        ..State::default()
    };
    let motion = simulate(&can, &start, law, &options, |_| ControlFlow::Continue(()))
        .map_err(|error| error.to_string())?;
    let end = motion.track.end().u;
    Ok(vec![end.yaw, end.tilt()])
}

fn main() {
    protocol::serve(motion);
}
