//! How a motion changes with its start, its body and gravity: the accepted steps again, on dual numbers.
//!
//! The steps give the derivative of the coordinates u at a fixed reading of the solver's clock τ. What is
//! fixed is another thing, the time or an event g(u) = 0, so the clock moves with a parameter θ:
//!
//! ```text
//! du/dθ at g = 0:   ∂u/∂θ − u′ (∂g/∂θ)/g′        ′ = d/dτ
//! ```
//!
//! The lengths of the steps are held; the derivative is then that of an order-8 solution.

use super::events::EventKind;
use super::mechanics::{Mechanics, first};
use super::track::Track;
use super::{Motion, Turn};
use crate::error::InvalidInput;
use crate::law::{Dynamics, Frictionless, NoSlip, Parameters};
use crate::motion::Phase;
use crate::real::{Dual, Slopes};
use crate::solve::Step;
use crate::state::{Coordinates, RIGID_COORDINATES, TIME};
use core::ops::ControlFlow;

/// How many steps lie between two questions to the caller whether to stop: on any machine, they take some
/// thousandths of a second.
const STEPS_BETWEEN_REPORTS: usize = 256;

/// The derivatives of a turn take two steps, and two searches for them.
const TURNS_BETWEEN_REPORTS: usize = 64;

/// What a motion is computed from, in the order of [`Slope`]; SI units and radians.
pub const PARAMETERS: [&str; 12] = [
    "tilt",
    "tilt_rate",
    "yaw",
    "yaw_rate",
    "spin",
    "spin_rate",
    "mass",
    "radius",
    "height",
    "transverse_inertia",
    "axial_inertia",
    "gravity",
];

/// A derivative by each of [`PARAMETERS`].
pub type Slope = [f64; PARAMETERS.len()];

type Number = Dual<Slopes<{ PARAMETERS.len() }>>;

/// The derivatives of a motion that one smooth law governs.
pub struct Sensitivity {
    law: Smooth,
    /// The coordinates at the start of each step, and at the end of the last.
    starts: Vec<[Number; RIGID_COORDINATES]>,
    turns: Vec<Slope>,
}

/// One law that holds all the way.
#[expect(clippy::large_enum_variant, reason = "there is but one of it")]
enum Smooth {
    Rolling(NoSlip<Number>),
    Gliding(Frictionless<Number>),
}

impl Smooth {
    fn step(&self, start: &[Number; RIGID_COORDINATES], h: f64) -> [Number; RIGID_COORDINATES] {
        let h = h.into();
        match self {
            Smooth::Rolling(law) => Step::take(&Mechanics::new(law), start, h).end,
            Smooth::Gliding(law) => Step::take(&Mechanics::new(law), start, h).end,
        }
    }

    fn rates(&self, u: &Coordinates<Number>) -> Coordinates<Number> {
        match self {
            Smooth::Rolling(law) => law.rates(u),
            Smooth::Gliding(law) => law.rates(u),
        }
    }
}

/// The coordinates at a moment and their rates, by the clock τ.
struct Moving {
    u: Coordinates<Number>,
    rates: Coordinates<Number>,
}

impl Sensitivity {
    /// The sensitivity of a motion from its start on; none when `watch` breaks off the work.
    pub(super) fn of(
        motion: &Motion,
        watch: &mut dyn FnMut(f64) -> ControlFlow<()>,
    ) -> Result<Option<Sensitivity>, InvalidInput> {
        let mut sensitivity = Sensitivity {
            law: smooth_law(motion)?,
            starts: vec![first(&start(&motion.track.start()).into_array())],
            turns: Vec::new(),
        };
        let followed = sensitivity.follow(motion, watch);
        Ok(followed.is_continue().then_some(sensitivity))
    }

    fn follow(
        &mut self,
        motion: &Motion,
        watch: &mut dyn FnMut(f64) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        for records in motion.track.records().chunks(STEPS_BETWEEN_REPORTS) {
            watch(records[0].start[TIME])?;
            for (record, i) in records.iter().zip(self.starts.len() - 1..) {
                self.starts.push(self.law.step(&self.starts[i], record.h));
            }
        }
        for turns in motion.turns.chunks(TURNS_BETWEEN_REPORTS) {
            watch(motion.track.end().t)?;
            for turn in turns {
                self.turns.push(self.of_turn(motion, turn));
            }
        }
        ControlFlow::Continue(())
    }

    /// Derivatives of tilt, tilt rate, yaw, yaw rate, spin and spin rate at a time (s) of the motion.
    pub fn at(&self, track: &Track, t: f64) -> [Slope; 6] {
        let at = self.rates_under(track, t);
        let u = at.fixed(&(at.u.t, at.rates.t));
        let tilt = u.sin.slope * u.cos.value - u.cos.slope * u.sin.value;
        let [yaw_rate, spin_rate] = [u.yaw_rate(), u.spin_rate()].map(|rate| rate.slope);
        [
            tilt,
            u.p.slope,
            u.yaw.slope,
            yaw_rate,
            u.spin.slope,
            spin_rate,
        ]
        .map(|slopes| slopes.0)
    }

    /// Derivatives of the angles of turn.
    pub fn turns(&self) -> &[Slope] {
        &self.turns
    }

    fn rates_under(&self, track: &Track, t: f64) -> Moving {
        let (index, x) = track.locate(t);
        let at = match track.records().get(index) {
            Some(record) => self.law.step(&self.starts[index], x * record.h),
            None => self.starts[0],
        };
        let u = Coordinates::from_first(&at);
        let rates = self.law.rates(&u);
        Moving { u, rates }
    }

    /// How far the yaw runs from one extreme of the tilt (or the release) to the next.
    fn of_turn(&self, motion: &Motion, turn: &Turn) -> Slope {
        let yaw = |t: f64| {
            let at = self.rates_under(&motion.track, t);
            let earlier = motion.events.partition_point(|event| event.at.t < t);
            let here = motion.events[earlier..]
                .iter()
                .take_while(|event| event.at.t == t);
            let is_here = |kind| here.clone().any(|event| event.kind == kind);
            if is_here(EventKind::OnEdge) {
                at.fixed(&(at.u.cos, at.rates.cos)).yaw.slope
            } else if is_here(EventKind::TiltMax) || is_here(EventKind::TiltMin) {
                at.fixed(&(at.u.p, at.rates.p)).yaw.slope
            } else {
                at.u.yaw.slope
            }
        };
        (yaw(turn.end) - yaw(turn.start)).0
    }
}

impl Moving {
    /// The coordinates with their derivatives where something, given with its rate, keeps its value.
    fn fixed(&self, kept: &(Number, Number)) -> Coordinates<Number> {
        let delay = kept.0.slope * (-1.0 / kept.1.value);
        let (u, rates) = (self.u.into_array(), self.rates.into_array());
        Coordinates::from_array(&core::array::from_fn(|i| Dual {
            value: u[i].value,
            slope: u[i].slope + delay * rates[i].value,
        }))
    }
}

/// A number with slope 1 along its own direction.
fn parameter(value: f64, index: usize) -> Number {
    Dual {
        value,
        slope: Slopes(core::array::from_fn(|i| f64::from(i == index))),
    }
}

/// The coordinates at the start, as they are, with their derivatives.
fn start(at: &Coordinates<f64>) -> Coordinates<Number> {
    let state = at.state().numbers();
    let duals = Coordinates::starting(core::array::from_fn(|i| parameter(state[i], i)));
    let (values, duals) = (at.into_array(), duals.into_array());
    Coordinates::from_array(&core::array::from_fn(|i| Dual {
        value: values[i],
        slope: duals[i].slope,
    }))
}

/// The law on dual numbers, where one smooth law holds all the way.
fn smooth_law(motion: &Motion) -> Result<Smooth, InvalidInput> {
    let refused = |why: &str| InvalidInput::NoSensitivity {
        why: why.to_owned(),
    };
    let phase = motion.track.start().phase;
    if motion.track.phases().any(|at| at.phase != phase) {
        return Err(refused(
            "the contact changes on the way, which joins laws that are not the same",
        ));
    }
    if !motion.contacts.dynamics(phase).is_conservative() {
        return Err(refused(
            "only rolling without slip and frictionless sliding are, without resistance",
        ));
    }
    let k = motion.contacts.parameters();
    let [m, r, h, a, c, g] = [(k.m, 6), (k.r, 7), (k.h, 8), (k.a, 9), (k.c, 10), (k.g, 11)]
        .map(|(value, index)| parameter(value, index));
    let k = Parameters { m, r, h, a, c, g };
    Ok(match phase {
        Phase::Rolling => Smooth::Rolling(NoSlip::new(k)),
        _ => Smooth::Gliding(Frictionless::new(k)),
    })
}
