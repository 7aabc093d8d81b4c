//! The derivatives of a motion with respect to its initial state, its body and gravity: the accepted steps
//! are repeated in dual numbers (forward-mode automatic differentiation).
//!
//! The steps give the derivative of the coordinates u at fixed τ. The derivative at a fixed time, or at an
//! event g(u) = 0, follows from it because τ then depends on the parameter θ:
//!
//! ```text
//! du/dθ at g = 0:   ∂u/∂θ − u′ (∂g/∂θ)/g′        ′ = d/dτ
//! ```
//!
//! The step sizes are held constant, so the derivative is that of a solution of order 8.
//!
//! Where one ideal law holds for the whole motion, that is all. Other motions consist of phases that are joined by events,
//! and some of their steps are implicit: `saltation` and `collocated` continue the derivatives over these. Their derivatives
//! have errors of their own, so that a step is repeated in parts where it does not suit them: see `variation`.

mod collocated;
mod on_moving_table;
mod saltation;
mod shaken_slope;
mod variation;

pub use on_moving_table::ShakenSensitivity;
pub use shaken_slope::{SHAKEN_PARAMETERS, ShakenSlope};

use self::saltation::refused;
use super::Motion;
use super::event::EventKind;
use super::flat_landing::FlatLanding;
use super::instant::Phase;
use super::phase_system::{IndependentVariable, PhaseSystem, leading};
use super::trajectory::Trajectory;
use super::turns::Turn;
use crate::error::InvalidInput;
use crate::law::{DynamicsExt, FrictionLaw, Frictionless, NoSlip, Parameters};
use crate::real::{Dual, Slopes};
use crate::solve::Step;
use crate::state::{COORDINATES, Coordinates, RIGID_COORDINATES, TIME};
use core::ops::ControlFlow;

/// The number of steps between two calls of `watch`: they take a few milliseconds on any machine.
const STEPS_BETWEEN_REPORTS: usize = 256;

/// The number of turns between two calls of `watch`. A turn takes two steps and two searches for them.
const TURNS_BETWEEN_REPORTS: usize = 64;

/// The parameters of a motion, in the order of [`Slope`]; SI units and radians.
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

/// The derivatives with respect to each of [`PARAMETERS`].
pub type Slope = [f64; PARAMETERS.len()];

type Number = Dual<Slopes<{ PARAMETERS.len() }>>;

/// The derivatives of a motion on a table at rest.
pub struct Sensitivity(Method);

enum Method {
    Smooth(Box<SmoothSensitivity>),
    Joined(Box<ShakenSensitivity>, Vec<Slope>),
}

/// The derivatives of a motion under one smooth law.
struct SmoothSensitivity {
    dynamics: Smooth,
    /// The coordinates at the start of each step and at the end of the last one.
    starts: Vec<[Number; RIGID_COORDINATES]>,
    turns: Vec<Slope>,
}

/// A smooth law that holds for the whole motion.
#[expect(clippy::large_enum_variant, reason = "there is only one instance")]
enum Smooth {
    Rolling(NoSlip<Number>),
    Frictionless(Frictionless<Number>),
}

impl Smooth {
    fn step(&self, start: &[Number; RIGID_COORDINATES], h: f64) -> [Number; RIGID_COORDINATES] {
        let h = h.into();
        match self {
            Smooth::Rolling(dynamics) => {
                Step::take(
                    &PhaseSystem::new(dynamics, IndependentVariable::Regularized),
                    start,
                    h,
                )
                .end
            }
            Smooth::Frictionless(dynamics) => {
                Step::take(
                    &PhaseSystem::new(dynamics, IndependentVariable::Regularized),
                    start,
                    h,
                )
                .end
            }
        }
    }

    fn rates(&self, u: &Coordinates<Number>) -> Coordinates<Number> {
        match self {
            Smooth::Rolling(dynamics) => dynamics.rates(u),
            Smooth::Frictionless(dynamics) => dynamics.rates(u),
        }
    }
}

impl Motion {
    /// The derivatives of the motion with respect to its initial state, its body and gravity. They cost about
    /// thirty times as much as the motion itself, and more where dry friction or resistance acts.
    ///
    /// `watch` is called every few hundred steps with the time (s) that the derivatives have reached,
    /// beginning with 0. If it breaks, the result is `None`.
    ///
    /// # Errors
    /// Refuses a table that moves, for which there is [`Motion::shaken_sensitivity`], a body that passes through upright
    /// in flight, and one whose base comes down flat and smoothly under friction or with resistance.
    pub fn sensitivity(
        &self,
        mut watch: impl FnMut(f64) -> ControlFlow<()>,
    ) -> Result<Option<Sensitivity>, InvalidInput> {
        Sensitivity::new(self, &mut watch)
    }
}

impl Sensitivity {
    /// The sensitivity of a motion; `None` if `watch` breaks.
    fn new(
        motion: &Motion,
        watch: &mut dyn FnMut(f64) -> ControlFlow<()>,
    ) -> Result<Option<Sensitivity>, InvalidInput> {
        if motion.contacts.moves() {
            return Err(refused("its table moves, which takes another computation"));
        }
        let method = match smooth_law(motion) {
            Some(dynamics) => SmoothSensitivity::new(dynamics, motion, watch)
                .map(|smooth| Method::Smooth(Box::new(smooth))),
            None => ShakenSensitivity::new(motion, watch)?.map(|joined| {
                let turns = joined.turns().iter().map(at_rest).collect();
                Method::Joined(Box::new(joined), turns)
            }),
        };
        Ok(method.map(Sensitivity))
    }

    /// Derivatives of tilt, tilt rate, yaw, yaw rate, spin and spin rate at a time (s) of the motion; NaN where there is
    /// none.
    pub fn at(&self, motion: &Motion, t: f64) -> [Slope; 6] {
        match &self.0 {
            Method::Smooth(smooth) => smooth.at(&motion.trajectory, t),
            Method::Joined(joined, _) => joined.at(motion, t).map(|slope| at_rest(&slope)),
        }
    }

    /// Derivatives of the angles of turn.
    pub fn turns(&self) -> &[Slope] {
        match &self.0 {
            Method::Smooth(smooth) => &smooth.turns,
            Method::Joined(_, turns) => turns,
        }
    }
}

/// The derivatives by the parameters that a motion on a table at rest has.
fn at_rest(slope: &ShakenSlope) -> Slope {
    core::array::from_fn(|i| slope[i])
}

/// The coordinates at a moment, and their rates with respect to τ or to the time.
struct CoordinatesAndRates<const K: usize> {
    u: Coordinates<Dual<Slopes<K>>>,
    rates: Coordinates<f64>,
}

impl SmoothSensitivity {
    /// The sensitivity of a motion under this law; `None` if `watch` breaks.
    fn new(
        dynamics: Smooth,
        motion: &Motion,
        watch: &mut dyn FnMut(f64) -> ControlFlow<()>,
    ) -> Option<SmoothSensitivity> {
        let mut sensitivity = SmoothSensitivity {
            dynamics,
            starts: vec![leading(&start(&motion.trajectory.start()).into_array())],
            turns: Vec::new(),
        };
        let completed = sensitivity.differentiate(motion, watch);
        completed.is_continue().then_some(sensitivity)
    }

    fn differentiate(
        &mut self,
        motion: &Motion,
        watch: &mut dyn FnMut(f64) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        for records in motion.trajectory.records().chunks(STEPS_BETWEEN_REPORTS) {
            watch(records[0].start[TIME])?;
            for (record, i) in records.iter().zip(self.starts.len() - 1..) {
                self.starts
                    .push(self.dynamics.step(&self.starts[i], record.h));
            }
        }
        for turns in motion.turns.chunks(TURNS_BETWEEN_REPORTS) {
            watch(motion.trajectory.end().t)?;
            for turn in turns {
                self.turns.push(turn_slope(motion, turn, |t| {
                    self.locate(&motion.trajectory, t)
                }));
            }
        }
        ControlFlow::Continue(())
    }

    fn at(&self, trajectory: &Trajectory, t: f64) -> [Slope; 6] {
        state_slopes(&self.locate(trajectory, t).at_fixed_time())
    }

    fn locate(&self, trajectory: &Trajectory, t: f64) -> CoordinatesAndRates<{ PARAMETERS.len() }> {
        let (index, x) = trajectory.locate(t);
        let at = match trajectory.records().get(index) {
            Some(record) => self.dynamics.step(&self.starts[index], x * record.h),
            None => self.starts[0],
        };
        let u = Coordinates::from_first(&at);
        let rates = values(&self.dynamics.rates(&u));
        CoordinatesAndRates { u, rates }
    }
}

/// The derivatives of the change of yaw from one tilt extremum (or the release) to the next, given the coordinates at a
/// time (s).
fn turn_slope<const K: usize>(
    motion: &Motion,
    turn: &Turn,
    locate: impl Fn(f64) -> CoordinatesAndRates<K>,
) -> [f64; K] {
    let yaw = |t: f64| {
        let at = locate(t);
        let earlier = motion.events.partition_point(|event| event.at.t < t);
        let here = motion.events[earlier..]
            .iter()
            .take_while(|event| event.at.t == t);
        let is_here = |kind| here.clone().any(|event| event.kind == kind);
        if is_here(EventKind::Land) {
            // The tilt rate changes its sign in an impact.
            at.u.yaw.slope
        } else if is_here(EventKind::OnEdge) {
            at.fixed(&(at.u.cos, at.rates.cos)).yaw.slope
        } else if is_here(EventKind::TiltMax) || is_here(EventKind::TiltMin) {
            at.fixed(&(at.u.p, at.rates.p)).yaw.slope
        } else {
            at.u.yaw.slope
        }
    };
    (yaw(turn.end) - yaw(turn.start)).0
}

impl<const K: usize> CoordinatesAndRates<K> {
    /// The coordinates with their derivatives at a fixed value of a function g, given as (g, g′).
    fn fixed(&self, (g, g_rate): &(Dual<Slopes<K>>, f64)) -> Coordinates<Dual<Slopes<K>>> {
        let delay = g.slope * (-1.0 / g_rate);
        let (u, rates) = (self.u.into_array(), self.rates.into_array());
        Coordinates::from_array(&core::array::from_fn(|i| Dual {
            value: u[i].value,
            slope: u[i].slope + delay * rates[i],
        }))
    }

    fn at_fixed_time(&self) -> Coordinates<Dual<Slopes<K>>> {
        Coordinates {
            t: self.u.t.value.into(),
            ..self.fixed(&(self.u.t, self.rates.t))
        }
    }
}

/// Derivatives of tilt, tilt rate, yaw, yaw rate, spin and spin rate.
fn state_slopes<const K: usize>(u: &Coordinates<Dual<Slopes<K>>>) -> [[f64; K]; 6] {
    let tilt = u.sin.slope * u.cos.value - u.cos.slope * u.sin.value;
    let [yaw_rate, spin_rate] = if u.sin.value == 0.0 {
        // The base is level and does not turn. An undefined derivative stays one.
        [u.w.slope, u.s.slope]
    } else {
        [u.yaw_rate(), u.spin_rate()].map(|rate| rate.slope)
    };
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

/// The coordinates without their derivatives.
fn values<const K: usize>(u: &Coordinates<Dual<Slopes<K>>>) -> Coordinates<f64> {
    Coordinates::from_array(&u.into_array().map(|dual| dual.value))
}

/// The coordinates with the same derivatives and other values.
fn with_values<const K: usize>(
    u: &Coordinates<Dual<Slopes<K>>>,
    values: &[f64; COORDINATES],
) -> Coordinates<Dual<Slopes<K>>> {
    let duals = u.into_array();
    Coordinates::from_array(&core::array::from_fn(|i| Dual {
        value: values[i],
        slope: duals[i].slope,
    }))
}

/// A parameter: a dual number whose derivative with respect to itself is 1.
fn parameter<const K: usize>(value: f64, index: usize) -> Dual<Slopes<K>> {
    Dual {
        value,
        slope: Slopes(core::array::from_fn(|i| f64::from(i == index))),
    }
}

/// The coordinates at the start with their derivatives; the values keep their bits.
fn start<const K: usize>(at: &Coordinates<f64>) -> Coordinates<Dual<Slopes<K>>> {
    let state = at.state().numbers();
    let duals = Coordinates::starting(core::array::from_fn(|i| parameter(state[i], i)));
    with_values(&duals, &at.into_array())
}

/// The body and gravity with their derivatives.
fn varied_parameters<const K: usize>(k: &Parameters<f64>) -> Parameters<Dual<Slopes<K>>> {
    let [m, r, h, a, c, g] = [(k.m, 6), (k.r, 7), (k.h, 8), (k.a, 9), (k.c, 10), (k.g, 11)]
        .map(|(value, index)| parameter(value, index));
    Parameters { m, r, h, a, c, g }
}

/// The law in dual numbers, if one smooth law holds for the whole motion.
fn smooth_law(motion: &Motion) -> Option<Smooth> {
    let contacts = &motion.contacts;
    let phase = motion.trajectory.start().phase;
    let is_smooth = contacts.contact_law().friction != FrictionLaw::InPlace
        && motion.flat == FlatLanding::Stop
        && contacts.dynamics(phase).is_conservative()
        && motion.trajectory.phases().all(|at| at.phase == phase);
    let k = varied_parameters(contacts.parameters());
    is_smooth.then(|| match phase {
        Phase::Rolling => Smooth::Rolling(NoSlip::new(k)),
        _ => Smooth::Frictionless(Frictionless::new(k)),
    })
}
