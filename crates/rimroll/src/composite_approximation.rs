//! The composite (matched asymptotic) approximation, which the paper calls "pasted": it describes in
//! words "the pasting-together of two qualitatively distinct motions of vastly different time-scales".
//!
//! The outer solution is an inverted pendulum that tips in a vertical plane; the inner solution is a
//! [`NearCollision`]. They match in φ = ω |t − t_c|, so the composite approximation is
//!
//! ```text
//! φ ≈ φ_pendulum(|t − t_c|) + √(φ_c² + ω² (t − t_c)²) − ω |t − t_c|
//! ψ ≈ ψ₀ ± √(J′/K′) [π/2 + arctan(ω (t − t_c)/φ_c)]
//! ```
//!
//! It is uniformly valid, with an error of order φ_c ln φ_c in ψ and φ_c² ln φ_c in φ. The parameters of
//! the near-collision, ω and φ_c = |l| √(K′/J′)/ω, follow from the initial state alone: l = ψ̇ sin² φ and
//! the spin obey linear equations with the pendulum's tilt as independent variable.

use crate::body::Body;
use crate::error::{InvalidInput, positive};
use crate::law::IdealLaw;
use crate::motion::{EventKind, Motion, Options, Status, simulate};
use crate::number_format::formatted;
use crate::state::State;
use crate::turn::NearCollision;
use core::ops::ControlFlow;

/// Sideways rates are scaled by this factor so that their squares vanish beside all other terms. The full
/// equations then reduce exactly to the pendulum and the linear equations for the sideways motion.
const INFINITESIMAL: f64 = 1e-100;

/// The largest allowed ratio of the smallest to the largest tilt. Beyond it the time scales of the two
/// motions are not well separated, and the error of the approximation exceeds a tenth.
const MAX_TILT_RATIO: f64 = 0.1;

/// One rocking motion, from a tilt maximum (or the release) through the near-collision to its mirror image.
pub struct Composite {
    /// The near-collision in the middle.
    pub near_collision: NearCollision,
    /// t_c, s after the release.
    pub time: f64,
    /// The time for which the pendulum falls, s. The approximation holds for |t − t_c| up to this time.
    pub half_width: f64,
    yaw: f64,
    fall: Motion,
}

impl Composite {
    /// φ at the time t (s), rad. Beyond the half width, the outer solution keeps its last value.
    pub fn tilt(&self, t: f64) -> f64 {
        let away = (t - self.time).abs();
        let pendulum = self.fall.trajectory.at(self.half_width - away).tilt();
        let straight = self.near_collision.tipping_rate * away;
        pendulum + (self.near_collision.tilt(away) - straight)
    }

    /// ψ at the time t (s), rad.
    pub fn yaw(&self, t: f64) -> f64 {
        let before = self.near_collision.stretch * core::f64::consts::FRAC_PI_2;
        self.yaw + before + self.near_collision.yaw(t - self.time)
    }
}

/// The composite approximation for a body released at `start` under gravity (m/s²).
///
/// # Errors
/// Refuses what [`simulate`] refuses, and a start that never comes down, that has no sideways motion (the
/// body falls flat), or that has so much of it that the smallest tilt is not small.
pub fn composite(
    body: &Body,
    start: &State,
    law: IdealLaw,
    gravity: f64,
) -> Result<Composite, InvalidInput> {
    start.check()?;
    positive("gravity", gravity, "m/s2")?;
    let planar = State {
        yaw: 0.0,
        spin: 0.0,
        yaw_rate: start.yaw_rate * INFINITESIMAL,
        spin_rate: start.spin_rate * INFINITESIMAL,
        ..*start
    };
    let options = Options {
        duration: 1e6 * (body.radius() / gravity).sqrt(),
        gravity,
        rtol: 1e-13,
        ..Options::default()
    };
    let simulated =
        |from: &State| simulate(body, from, law, &options, |_| ControlFlow::Continue(()));

    let (top, since_release) = top_of_the_fall(&planar, simulated)?;
    let fall = simulated(&top)?;
    if fall.status != Status::FaceDown {
        let why = "its plane pendulum does not come down";
        return Err(InvalidInput::no_near_collision(why, Some(fall.ending)));
    }
    let end = fall.trajectory.end();
    if end.cos < 0.0 {
        let why = "it falls to the disk's other face; turn the disk over, tilt -> pi - tilt";
        return Err(InvalidInput::no_near_collision(why, None));
    }
    let half_width = end.t + end.sin / -end.p;
    let tipping_rate = -end.p;
    let l = end.w * end.sin / INFINITESIMAL;
    if l == 0.0 {
        let why = "with hardly any yaw rate and spin rate it falls face down";
        return Err(InvalidInput::no_near_collision(why, None));
    }
    let stretch = NearCollision::new(body, law, 1.0, tipping_rate, l.signum())?.stretch;
    let min_tilt = l / (tipping_rate * stretch);
    if min_tilt > MAX_TILT_RATIO * top.tilt {
        let why = format!(
            "the smallest tilt, {} rad, would be no small part of the largest, {} rad; \
             reduce yaw rate and spin rate",
            formatted(min_tilt),
            formatted(top.tilt)
        );
        return Err(InvalidInput::no_near_collision(&why, None));
    }
    Ok(Composite {
        near_collision: NearCollision {
            min_tilt,
            tipping_rate,
            stretch,
        },
        time: half_width + since_release,
        half_width,
        yaw: start.yaw,
        fall,
    })
}

/// The tilt maximum before or after the release, and its time relative to the release (s). If the
/// release was too fast to have started from a tilt maximum, it is the release itself.
fn top_of_the_fall(
    start: &State,
    simulated: impl Fn(&State) -> Result<Motion, InvalidInput>,
) -> Result<(State, f64), InvalidInput> {
    if start.tilt_rate == 0.0 {
        return Ok((*start, 0.0));
    }
    // Reversing time changes the sign of all rates.
    let time = start.tilt_rate.signum();
    let rise = simulated(&reversed(start, time))?;
    let top = rise.events.iter().find(|e| e.kind == EventKind::TiltMax);
    match top {
        Some(top) => Ok((reversed(&top.at.state(), time), time * top.at.t)),
        None => Ok((*start, 0.0)),
    }
}

fn reversed(state: &State, time: f64) -> State {
    State {
        tilt_rate: time * state.tilt_rate,
        yaw_rate: time * state.yaw_rate,
        spin_rate: time * state.spin_rate,
        ..*state
    }
}
