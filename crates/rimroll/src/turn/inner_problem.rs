//! The limiting turn under any friction, from the inner problem of the near-collision.
//!
//! As ε → 0 the duration and the tilt of the near-collision vanish. Gravity and the gyroscopic terms, which
//! have a factor sin φ, become negligible. The inner problem consists of the equations of motion at
//! sin φ = 0, cos φ = 1, with respect to τ (′ = φ d/dt). It contains neither tilt nor time: its solution is
//! an orbit from (φ̇, φψ̇) = (−ω, 0), the end of the tipping phase, to (φ̇_out, 0), the beginning of the
//! rise, and the turn is the yaw along it. So the limit is computed by the same laws, phases and steps as
//! every motion.
//!
//! It depends on the body, the friction, and the slip and spin on arrival, relative to Hω and ω. For a body
//! that arrives without slip and spin it is the no-slip limit if the coefficient of Coulomb friction is
//! μ ≥ μ* = mHR/(A + mH²), and the frictionless limit if μ = 0. For the paper's can it is monotone between
//! the two; for a low, wide body it can first rise slightly above the frictionless limit.

use super::{needed_friction, turn_limit, turn_limit_with_spin};
use crate::body::Body;
use crate::contact_law::ContactLaw;
use crate::error::{InvalidInput, bounded, finite, positive};
use crate::law::FrictionLaw;
use crate::law::IdealLaw;
use crate::law::{Coulomb, DynamicsExt, Viscous};
use crate::motion::{Contacts, Options, Phase, Status, pass_near_collision, simulate};
use crate::state::{Coordinates, State};
use core::ops::ControlFlow;
use std::sync::Arc;

/// The motion of a body at the end of its tipping phase.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arrival {
    /// ω = −φ̇, rad/s.
    pub tipping_rate: f64,
    /// The velocity of the rim's lowest point along e_x1 (toward the base's centre), m/s.
    pub slip: f64,
    /// s about the symmetry axis, rad/s, positive in the direction of the turn.
    pub spin: f64,
    /// The largest |T|/N during the tipping phase, which is the coefficient of friction that tipping without
    /// slip needs; NaN if unknown.
    pub friction_ratio: f64,
}

impl Arrival {
    /// An arrival without slip and spin.
    pub fn at_rest() -> Self {
        Arrival {
            tipping_rate: 1.0,
            slip: 0.0,
            spin: 0.0,
            friction_ratio: f64::NAN,
        }
    }

    /// The arrival of a body released at `start` in the limit ε → 0, that is, without sideways motion: the
    /// yaw rate and the spin rate of `start` are not used.
    ///
    /// # Errors
    /// Refuses what [`simulate`] refuses, and a start from which the base does not come down flat.
    pub fn from_start(
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
            let why = "the tipping phase does not end flat";
            return Err(InvalidInput::no_near_collision(why, Some(fall.ending)));
        }
        if fall.trajectory.phases().any(|at| at.phase == Phase::Flying) {
            let why = "the rim lifts off on the way down";
            return Err(InvalidInput::no_near_collision(why, None));
        }
        let end = fall.trajectory.end();
        let ratio = |contact: crate::law::Contact<f64>| {
            libm::hypot(contact.along, contact.across) / contact.normal
        };
        let ratios = fall
            .trajectory
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

    /// Refuses a spin, which a body that wobbles in place does not have at zero tilt.
    fn without_spin(&self) -> Result<(), InvalidInput> {
        let bound = "0 for a body that wobbles in place";
        bounded("spin", self.spin, |spin| spin == 0.0, bound, "rad/s").map(|_| ())
    }
}

/// The outcome of a near-collision.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Passage {
    /// The limiting angle of turn, rad.
    pub turn: f64,
    /// φ̇ at the beginning of the rise, rad/s.
    pub rising_rate: f64,
    /// s at the beginning of the rise, rad/s, positive in the direction of the turn. It makes the yaw drift
    /// on.
    pub spin: f64,
    /// The slip along e_x1 and e_y1 at the beginning of the rise, m/s.
    pub slip: [f64; 2],
    /// The fraction of the kinetic energy (of tipping, spin and slip) that friction dissipates.
    pub loss: f64,
}

/// The limiting angle of turn under any friction, rad. It is a closed form where one exists, otherwise the
/// solution of the inner problem, accurate to 3e-8 rad. Restitution has no influence, since it
/// needs a flight. Resistance is left out, although dry rolling resistance can end the near-collision.
///
/// # Errors
/// Refuses an arrival with a tipping rate ≤ 0 or numbers that are not finite, and one whose
/// near-collision is not completed because the rim lifts off or meets the Painlevé paradox.
pub fn turn_limit_of(
    body: &Body,
    friction: &FrictionLaw,
    arrival: &Arrival,
) -> Result<f64, InvalidInput> {
    arrival.check()?;
    let at_rest = arrival.slip == 0.0 && arrival.spin == 0.0;
    match friction {
        FrictionLaw::NoSlip => turn_limit_with_spin(body, arrival.spin, arrival.tipping_rate),
        FrictionLaw::InPlace => arrival
            .without_spin()
            .map(|()| turn_limit(body, IdealLaw::NoSlip)),
        // The impulse of a viscous force vanishes with the duration of the near-collision.
        FrictionLaw::Frictionless
        | FrictionLaw::Viscous(Viscous { .. })
        | FrictionLaw::Coulomb(Coulomb { friction: 0.0, .. }) => {
            Ok(turn_limit(body, IdealLaw::Frictionless))
        }
        _ if at_rest && sticks(friction, needed_friction(body)) => {
            Ok(turn_limit(body, IdealLaw::NoSlip))
        }
        _ => Ok(passage(body, friction, arrival)?.turn),
    }
}

/// Solves the inner problem of the near-collision.
///
/// # Errors
/// As [`turn_limit_of`].
pub fn passage(
    body: &Body,
    friction: &FrictionLaw,
    arrival: &Arrival,
) -> Result<Passage, InvalidInput> {
    let at_rest = arrival.slip == 0.0 && arrival.spin == 0.0;
    let needed = needed_friction(body);
    match *friction {
        FrictionLaw::InPlace => {
            arrival.without_spin()?;
            computed_passage(body, friction, arrival)
        }
        _ if at_rest && sticks(friction, needed) => {
            computed_passage(body, &FrictionLaw::NoSlip, arrival)
        }
        FrictionLaw::Coulomb(Coulomb { friction, .. })
            if at_rest && friction > needed * (1.0 - NEAR_CRITICAL) =>
        {
            just_below_rolling(
                body,
                arrival,
                (needed - friction) / (needed * NEAR_CRITICAL),
            )
        }
        _ => computed_passage(body, friction, arrival),
    }
}

/// Whether the rim sticks if that needs the coefficient of friction `needed`.
fn sticks(friction: &FrictionLaw, needed: f64) -> bool {
    friction.static_friction().is_some_and(|f| f >= needed)
}

/// The relative distance to μ* within which results are interpolated.
const NEAR_CRITICAL: f64 = 1e-4;

/// Interpolates linearly between the solution without slip (`fraction` 0, at μ*) and the solution at
/// μ = μ* (1 − [`NEAR_CRITICAL`]) (`fraction` 1). Just below μ* the slip is so slow that the equation for
/// its direction is too stiff to integrate, and all results are linear in μ to within their accuracy.
fn just_below_rolling(
    body: &Body,
    arrival: &Arrival,
    fraction: f64,
) -> Result<Passage, InvalidInput> {
    let close = FrictionLaw::coulomb(needed_friction(body) * (1.0 - NEAR_CRITICAL));
    let sliding = computed_passage(body, &close, arrival)?;
    let rolling = computed_passage(body, &FrictionLaw::NoSlip, arrival)?;
    let between = |rolling: f64, sliding: f64| rolling + fraction * (sliding - rolling);
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
    // The sideways rate, relative to ω, at which the integration begins and ends. The departures of first
    // and second order account for the rest of the orbit, so the error is of third order in this number.
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
    let (trajectory, status) = pass_near_collision(&contacts, start, FAINT * rate, &options);
    let end = trajectory.end();
    if status != Status::Finished {
        let why = match status {
            Status::Painleve => "with this friction it meets Painlevé's paradox",
            _ => "the rim lifts off on the way through it, or falls back flat",
        };
        return Err(InvalidInput::no_near_collision(why, None));
    }
    let kinetic = |u: &crate::motion::Instant| contacts.dynamics(u.phase).energy(u).kinetic;
    let (before, after) = (kinetic(&trajectory.start()), kinetic(&end));
    let dynamics = contacts.dynamics(end.phase);
    let [slip_x, slip_y] = dynamics.slip(&end);
    let end = Coordinates {
        slip_x,
        slip_y,
        ..end.u
    };
    let linear = linear_departure(|u| dynamics.rates(u), &end, -end.p);
    let quadratic = quadratic_departure(&dynamics.rates(&end), &linear, &end, -end.p);
    let last = end.plus(-1.0, &linear).plus(-1.0, &quadratic);
    Ok(Passage {
        turn: last.yaw,
        rising_rate: last.p,
        spin: last.s,
        slip: [last.slip_x, last.slip_y],
        loss: (before - after) / before,
    })
}

/// The departure of the orbit at `u` from a fixed point, to first order in w, where w ~ e^{κτ}. The frame
/// has yawed by w/κ, and the velocities have not turned with it.
fn linear_departure(
    rates: impl Fn(&Coordinates<f64>) -> Coordinates<f64>,
    u: &Coordinates<f64>,
    kappa: f64,
) -> Coordinates<f64> {
    // Terms of second order are below rounding here.
    const CLOSER: f64 = 1e-7;
    let closer = Coordinates {
        w: CLOSER * u.w,
        ..*u
    };
    let departure = Coordinates::zero().plus(1.0 / (CLOSER * kappa), &rates(&closer));
    Coordinates {
        w: 0.0,
        ..departure
    }
}

/// The departure to second order in w: the remainder of the rates grows like e^{2κτ}.
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
