//! The uniformly valid approximation that the paper describes in words: "the pasting-together of two
//! qualitatively distinct motions of vastly different time-scales".
//!
//! Far from the table the body tips in a vertical plane like an inverted pendulum; near it, it is a
//! [`NearCollision`]. Both meet in φ = ω |t − t_c|, so that
//!
//! ```text
//! φ ≈ φ_pendulum(|t − t_c|) + √(φ_c² + ω² (t − t_c)²) − ω |t − t_c|
//! ψ ≈ ψ₀ ± √(J′/K′) [π/2 + arctan(ω (t − t_c)/φ_c)]
//! ```
//!
//! everywhere with an error of the order of φ_c ln φ_c in ψ and φ_c² ln φ_c in φ. What the near-collision needs to know,
//! ω and φ_c = |l| √(K′/J′)/ω, comes from the start alone: l = ψ̇ sin² φ and the spin obey linear
//! equations with the pendulum's tilt as clock.

use crate::body::Body;
use crate::error::{InvalidInput, positive, shown};
use crate::law::IdealLaw;
use crate::motion::{EventKind, Motion, Options, Status, simulate};
use crate::state::State;
use crate::turn::NearCollision;
use core::ops::ControlFlow;

/// Sideways rates are made this small so that their squares vanish beside everything else: what is
/// left of the full equations is the pendulum and, exactly, its linear companion.
const INFINITESIMAL: f64 = 1e-100;

/// The smallest tilt may be this part of the largest: beyond, the two motions are not of different
/// time-scales and the approximation is off by more than a tenth.
const LARGEST_PART: f64 = 0.1;

/// One rocking, from a tilt maximum (or the release) through the near-collision to its mirror image.
pub struct Pasted {
    /// The near-collision in the middle.
    pub near_collision: NearCollision,
    /// t_c, s after the release.
    pub time: f64,
    /// The pendulum falls for this long, s: the approximation holds for |t − t_c| up to it.
    pub half_width: f64,
    yaw: f64,
    fall: Motion,
}

impl Pasted {
    /// φ at the time t (s), rad; held at the last value beyond the half width.
    pub fn tilt(&self, t: f64) -> f64 {
        let away = (t - self.time).abs();
        let pendulum = self.fall.track.at(self.half_width - away).tilt();
        let straight = self.near_collision.tipping_rate * away;
        pendulum + (self.near_collision.tilt(away) - straight)
    }

    /// ψ at the time t (s), rad.
    pub fn yaw(&self, t: f64) -> f64 {
        let before = self.near_collision.stretch * core::f64::consts::FRAC_PI_2;
        self.yaw + before + self.near_collision.yaw(t - self.time)
    }
}

/// Pastes a tipping phase and a near-collision together for a body let go at `start` under gravity
/// (m/s²).
///
/// # Errors
/// Refuses what [`simulate`] refuses, a start that never comes down, one without any sideways motion,
/// which comes down flat, and one with so much of it that it stays far from flat.
pub fn pasted(
    body: &Body,
    start: &State,
    law: IdealLaw,
    gravity: f64,
) -> Result<Pasted, InvalidInput> {
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
    let follow = |from: &State| simulate(body, from, law, &options, |_| ControlFlow::Continue(()));

    let (top, since_release) = top_of_the_fall(&planar, follow)?;
    let fall = follow(&top)?;
    if fall.status != Status::FaceDown {
        return Err(InvalidInput::NoNearCollision {
            why: format!("its plane pendulum does not come down: {}", fall.message),
        });
    }
    let end = fall.track.end();
    if end.cos < 0.0 {
        return Err(InvalidInput::NoNearCollision {
            why: "it falls to the disk's other face; turn the disk over, tilt -> pi - tilt"
                .to_owned(),
        });
    }
    let half_width = end.t + end.sin / -end.p;
    let tipping_rate = -end.p;
    let l = end.w * end.sin / INFINITESIMAL;
    if l == 0.0 {
        return Err(InvalidInput::NoNearCollision {
            why: "with no yaw_rate and spin_rate to speak of it falls face down".to_owned(),
        });
    }
    let stretch = NearCollision::new(body, law, 1.0, tipping_rate, l.signum())?.stretch;
    let min_tilt = l / (tipping_rate * stretch);
    if min_tilt > LARGEST_PART * top.tilt {
        return Err(InvalidInput::NoNearCollision {
            why: format!(
                "the smallest tilt, {} rad, would be no small part of the largest, {} rad; \
                 reduce yaw_rate and spin_rate",
                shown(min_tilt),
                shown(top.tilt)
            ),
        });
    }
    Ok(Pasted {
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

/// The tilt maximum that the pendulum comes from or goes to, and its time after the release (s,
/// negative before it); the release itself when it was flicked too fast to come from any.
fn top_of_the_fall(
    start: &State,
    follow: impl Fn(&State) -> Result<Motion, InvalidInput>,
) -> Result<(State, f64), InvalidInput> {
    if start.tilt_rate == 0.0 {
        return Ok((*start, 0.0));
    }
    // Into the past all rates change sign.
    let time = start.tilt_rate.signum();
    let rise = follow(&reversed(start, time))?;
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
