//! The limiting turn under any friction: the near-collision by itself, computed.
//!
//! As ε → 0 the near-collision happens in no time and at no tilt. Gravity and the gyroscopic terms,
//! everything with a factor sin φ, vanish beside the rest; what is left are the equations of motion at
//! sin φ = 0, cos φ = 1, on the clock τ (′ = φ d/dt). They know no tilt and no time: an orbit from
//! (φ̇, φψ̇) = (−ω, 0), the end of the tipping phase, to (φ̇_out, 0), the beginning of the rise. The turn
//! is all the yaw on the way. So the limit comes from the same laws, phases and steps as every
//! motion.
//!
//! It depends on the body and the friction, and on the slip and the spin with which the body arrives,
//! relative to Hω and ω. For Coulomb friction μ ≥ μ* = mHR/(A + mH²) and a body that arrives at
//! rest on its rim, it is the no-slip limit; for μ = 0 the frictionless one. For the paper's can it falls from
//! one to the other; that of a low, wide body may first rise above the frictionless one by a little.

use super::{needed_friction, turn_limit, turn_limit_with_spin};
use crate::body::Body;
use crate::contact_law::{ContactLaw, FrictionLaw};
use crate::error::{InvalidInput, finite, positive};
use crate::law::IdealLaw;
use crate::motion::{Contacts, Options, Phase, Status, pass_near_collision, simulate};
use crate::state::{Coordinates, State};
use core::ops::ControlFlow;
use std::sync::Arc;

/// How a body comes down on the table, at the end of its tipping phase.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arrival {
    /// ω = −φ̇, rad/s.
    pub tipping_rate: f64,
    /// u, m/s: velocity of the rim's lowest point along e_x1, from it toward the base's centre.
    pub slip: f64,
    /// s, rad/s: about the symmetry axis, positive in the direction of the turn.
    pub spin: f64,
    /// The largest |T|/N on the way down: the friction that tipping without slip needs; NaN where it
    /// is not known.
    pub friction_ratio: f64,
}

impl Arrival {
    /// At rest on the rim, without spin.
    pub fn at_rest() -> Self {
        Arrival {
            tipping_rate: 1.0,
            slip: 0.0,
            spin: 0.0,
            friction_ratio: f64::NAN,
        }
    }

    /// How a body that is let go without any sideways motion arrives: the tipping phase of `start`,
    /// whose yaw rate and spin rate are not used, in its limit ε → 0.
    ///
    /// # Errors
    /// Refuses what [`simulate`] refuses, and a start from which the base does not come down flat.
    pub fn of(
        body: &Body,
        start: &State,
        contact_law: &ContactLaw,
        gravity: f64,
    ) -> Result<Arrival, InvalidInput> {
        let start = State {
            yaw_rate: 0.0,
            spin_rate: 0.0,
            ..*start
        };
        let options = Options {
            duration: 1e3,
            gravity,
            rtol: 1e-12,
            ..Options::default()
        };
        let fall = simulate(body, &start, contact_law.clone(), &options, |_| {
            ControlFlow::Continue(())
        })?;
        if fall.status != Status::FaceDown {
            return Err(InvalidInput::NoNearCollision {
                why: format!("the tipping phase does not end flat: {}", fall.message),
            });
        }
        if fall.track.phases().any(|at| at.phase == Phase::Flying) {
            return Err(InvalidInput::NoNearCollision {
                why: "the rim lifts off on the way down".to_owned(),
            });
        }
        let end = fall.track.end();
        let ratio = |contact: crate::law::Contact<f64>| {
            libm::hypot(contact.along, contact.across) / contact.normal
        };
        let ratios = fall
            .track
            .nodes()
            .map(|at| ratio(fall.dynamics(&at).contact(&at)));
        Ok(Arrival {
            tipping_rate: -end.p,
            slip: fall.dynamics(&end).slip(&end)[0],
            spin: 0.0,
            friction_ratio: ratios.fold(0.0, f64::max),
        })
    }

    fn check(&self) -> Result<(), InvalidInput> {
        positive("tipping_rate", self.tipping_rate, "rad/s")?;
        finite("slip", self.slip)?;
        finite("spin", self.spin)?;
        Ok(())
    }
}

/// What the near-collision makes of an arrival.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Passage {
    /// The limiting angle of turn, rad.
    pub turn: f64,
    /// φ̇ of the beginning rise, rad/s.
    pub rising_rate: f64,
    /// s of it, rad/s, positive in the direction of the turn: what makes the yaw drift on.
    pub spin: f64,
    /// Slip of it along e_x1 and e_y1, m/s.
    pub slip: [f64; 2],
    /// The part of the kinetic energy (of tipping, spin and slip) that friction takes.
    pub loss: f64,
}

/// The limiting angle of turn, rad, on any surface (restitution and resistance do not enter: the
/// first needs a flight, the second time to act). Closed forms where there are any, else the
/// near-collision computed, good to 3e-8 rad.
///
/// # Errors
/// Refuses an arrival with a tipping rate ≤ 0 or numbers that are not finite, and one whose
/// near-collision does not pass: when the rim lifts off on the way, or meets Painlevé's paradox.
pub fn turn_limit_of(
    body: &Body,
    friction: &FrictionLaw,
    arrival: &Arrival,
) -> Result<f64, InvalidInput> {
    arrival.check()?;
    let gentle = arrival.slip == 0.0 && arrival.spin == 0.0;
    match friction {
        FrictionLaw::NoSlip => turn_limit_with_spin(body, arrival.spin, arrival.tipping_rate),
        // In no time a viscous force does nothing.
        FrictionLaw::Frictionless
        | FrictionLaw::Viscous { .. }
        | FrictionLaw::Coulomb { friction: 0.0, .. } => {
            Ok(turn_limit(body, IdealLaw::Frictionless))
        }
        _ if gentle && holds(friction, needed_friction(body)) => {
            Ok(turn_limit(body, IdealLaw::NoSlip))
        }
        _ => Ok(passage(body, friction, arrival)?.turn),
    }
}

/// Computes the near-collision by itself.
///
/// # Errors
/// As [`turn_limit_of`].
pub fn passage(
    body: &Body,
    friction: &FrictionLaw,
    arrival: &Arrival,
) -> Result<Passage, InvalidInput> {
    let gentle = arrival.slip == 0.0 && arrival.spin == 0.0;
    let needed = needed_friction(body);
    match *friction {
        _ if gentle && holds(friction, needed) => {
            computed_passage(body, &FrictionLaw::NoSlip, arrival)
        }
        FrictionLaw::Coulomb { friction, .. } if gentle && friction > needed * (1.0 - CLOSE) => {
            just_below_rolling(body, arrival, (needed - friction) / (needed * CLOSE))
        }
        _ => computed_passage(body, friction, arrival),
    }
}

/// Whether dry friction holds a rim that needs so much of it.
fn holds(friction: &FrictionLaw, needed: f64) -> bool {
    friction.static_friction().is_some_and(|f| f >= needed)
}

/// How close to μ*, relative to it, friction has to be to count as just below.
const CLOSE: f64 = 1e-4;

/// Just below μ* the slip is so slow that its direction is ever stiffer to follow, and everything is as
/// good as linear in μ. `part` is 0 at μ* and 1 where the computation can do it.
fn just_below_rolling(body: &Body, arrival: &Arrival, part: f64) -> Result<Passage, InvalidInput> {
    let close = FrictionLaw::coulomb(needed_friction(body) * (1.0 - CLOSE));
    let sliding = computed_passage(body, &close, arrival)?;
    let rolling = computed_passage(body, &FrictionLaw::NoSlip, arrival)?;
    let between = |rolling: f64, sliding: f64| rolling + part * (sliding - rolling);
    Ok(Passage {
        turn: between(rolling.turn, sliding.turn),
        rising_rate: between(rolling.rising_rate, sliding.rising_rate),
        spin: between(rolling.spin, sliding.spin),
        slip: core::array::from_fn(|i| between(rolling.slip[i], sliding.slip[i])),
        loss: between(rolling.loss, sliding.loss),
    })
}

fn computed_passage(
    body: &Body,
    friction: &FrictionLaw,
    arrival: &Arrival,
) -> Result<Passage, InvalidInput> {
    // The sideways rate from which and to which it is followed, over ω: what is left out is this
    // small to the third order.
    const FAINT: f64 = 1e-3;
    const RTOL: f64 = 1e-11;
    const NO_GRAVITY: f64 = 1e-100;
    arrival.check()?;
    let contact_law = ContactLaw::from(friction.clone());
    contact_law.check()?;
    let options = Options {
        rtol: RTOL,
        ..Options::default()
    };
    let contacts = Contacts::new(body, &contact_law, NO_GRAVITY, options.step_tolerance());
    let contacts = Arc::new(contacts);
    let rate = arrival.tipping_rate;
    let flat = Coordinates {
        cos: 1.0,
        p: -rate,
        w: FAINT * rate,
        s: arrival.spin,
        slip_x: arrival.slip,
        ..Coordinates::zero()
    };
    let first_rates = |u: &Coordinates<f64>| contacts.first_rates(u);
    let linear = linear_departure(first_rates, &flat, rate);
    let near = flat.plus(1.0, &linear);
    let quadratic = quadratic_departure(&contacts.first_rates(&near), &linear, &flat, rate);
    let start = near.plus(1.0, &quadratic);
    let (track, status) = pass_near_collision(&contacts, start, FAINT * rate, &options);
    let end = track.end();
    if status != Status::Finished {
        let why = match status {
            Status::Painleve => "with this friction it meets Painlevé's paradox",
            _ => "the rim lifts off on the way through it, or falls back flat",
        };
        return Err(InvalidInput::NoNearCollision {
            why: why.to_owned(),
        });
    }
    let kinetic = |u: &crate::motion::Instant| contacts.dynamics(u.phase).energy(u).kinetic;
    let (before, after) = (kinetic(&track.start()), kinetic(&end));
    let law = contacts.dynamics(end.phase);
    let [slip_x, slip_y] = law.slip(&end);
    let end = Coordinates {
        slip_x,
        slip_y,
        ..end.u
    };
    let linear = linear_departure(|u| law.rates(u), &end, -end.p);
    let quadratic = quadratic_departure(&law.rates(&end), &linear, &end, -end.p);
    let last = end.plus(-1.0, &linear).plus(-1.0, &quadratic);
    Ok(Passage {
        turn: last.yaw,
        rising_rate: last.p,
        spin: last.s,
        slip: [last.slip_x, last.slip_y],
        loss: (before - after) / before,
    })
}

/// Close to a fixed point, where w ~ e^{κτ}: how far the orbit at `u` has departed from it in the first
/// power of w. The frame has yawed by w/κ, and velocities have not turned with it.
fn linear_departure(
    rates: impl Fn(&Coordinates<f64>) -> Coordinates<f64>,
    u: &Coordinates<f64>,
    kappa: f64,
) -> Coordinates<f64> {
    // Here the second power is nothing beside the first.
    const CLOSER: f64 = 1e-7;
    let closer = Coordinates {
        w: CLOSER * u.w,
        ..*u
    };
    let nothing = Coordinates::zero();
    let departure = nothing.plus(1.0 / (CLOSER * kappa), &rates(&closer));
    Coordinates {
        w: 0.0,
        ..departure
    }
}

/// The same in the second power: what is left of the rates grows like e^{2κτ}.
fn quadratic_departure(
    rates: &Coordinates<f64>,
    linear: &Coordinates<f64>,
    u: &Coordinates<f64>,
    kappa: f64,
) -> Coordinates<f64> {
    let half = |rate: f64, linear: f64| 0.5 * (rate / kappa - linear);
    Coordinates {
        yaw: -half(rates.w, u.w) / kappa,
        p: half(rates.p, linear.p),
        s: half(rates.s, linear.s),
        slip_x: half(rates.slip_x, linear.slip_x),
        slip_y: half(rates.slip_y, linear.slip_y),
        ..Coordinates::zero()
    }
}
