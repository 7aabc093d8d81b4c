//! The initial states and options that the tests share.

use core::f64::consts::PI;
use core::ops::ControlFlow;
use rimroll::{Body, ContactLaw, Motion, Options, State, simulate};

/// The gravity of Srinivasan & Ruina (2007), m/s².
pub const PAPER_GRAVITY: f64 = 9.8;

/// The start of the paper's simulation figure, with ψ̇ = θ̇ = 0.005 rad/s there.
pub fn paper_start(sideways: f64) -> State {
    State {
        tilt: PI / 6.0,
        tilt_rate: -0.5,
        yaw_rate: sideways,
        spin_rate: sideways,
        ..State::default()
    }
}

/// The paper's gravity, and a tolerance at which rounding dominates.
pub fn tight(duration: f64) -> Options {
    Options {
        duration,
        gravity: PAPER_GRAVITY,
        rtol: 1e-13,
        ..Options::default()
    }
}

/// Simulates a start that is known to be valid.
pub fn follow(
    body: &Body,
    start: &State,
    contact_law: impl Into<ContactLaw>,
    options: &Options,
) -> Motion {
    simulate(body, start, contact_law, options, |_| {
        ControlFlow::Continue(())
    })
    .expect("valid input")
}
