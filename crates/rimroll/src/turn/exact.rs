//! The turn by quadrature, under the two laws without loss.
//!
//! Under no slip and without friction, energy is conserved and the tilt determines the other velocities.
//! The whole motion is therefore a quadrature (the paper states this for the frictionless law, section
//! "Frictionless sliding"). The smallest and the largest tilt are roots of the tilt's energy. Yaw and time
//! are integrals, which Gauss-Legendre rules evaluate with spectral convergence. Three measures keep the
//! accuracy for any smallest tilt:
//!
//! * the independent variable ln tan(φ/2) (`tilt_equation`), in which the near-collision and the rest of the
//!   motion have similar lengths,
//! * for no slip, a table of the body's fundamental solutions (`fundamental_solutions`),
//! * a closed form for the part of the yaw that the near-collision alone produces (`segments`).
//!
//! `scalar` handles one start with any outcome. In batches of sixteen lanes, `rocking_batch` handles starts that
//! rock and `toppling_batch` starts that topple. `many_bodies` groups many starts by their bodies. `in_place` is the turn
//! of a body that wobbles in place, for which the tilt also determines the yaw rate.

mod balance_passage;
mod batch;
mod dispatch;
mod frictionless;
mod fundamental_solutions;
mod in_place;
mod lane_groups;
mod many_bodies;
mod no_slip;
mod quadrature_rule;
mod rocking_batch;
mod scalar;
mod segments;
mod sign_search;
mod small_energy;
mod tilt_equation;
mod tilt_extremes;
mod toppling_batch;

use crate::body::Body;
use crate::error::{InvalidInput, positive};
use crate::law::{IdealLaw, Parameters};
use crate::motion::{Fall, Options, Outcome, PARAMETERS, Slope, Status, fall};
use crate::real::{Dual, Scalar, Slopes};
use crate::state::State;
use balance_passage::Balance;
use core::f64::consts::FRAC_PI_2;
use dispatch::Engine;
use frictionless::FrictionlessTilt;
use fundamental_solutions::Fundamental;
pub use fundamental_solutions::watershed_slope;
pub use in_place::turn_in_place;
pub use many_bodies::ExactRows;
use no_slip::NoSlipTilt;
#[cfg(feature = "threads")]
use rayon::prelude::*;
use scalar::{Quadrature, quadrature_of};
use tilt_equation::{Start, TiltEquation, half_tangent};

/// Distance in η from the balance point within which a body with its turning point there lingers.
const LINGERING: f64 = 0.03;

/// The first turn of a motion and its outcome. Quantities that do not exist are NaN.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ExactTurn {
    /// How the turn ended. It ends with [`Outcome::LiftedOff`] at any tilt at which the rim leaves the table.
    pub ending: Outcome,
    /// What became of the body. This equals `ending`, except that a body whose rim leaves the table as it
    /// rises past the balance point falls over.
    pub outcome: Outcome,
    /// Change of yaw, rad, from the release to the end through the smallest tilt. If the tilt increases at
    /// the release, the turn begins at the following largest tilt.
    pub turn: f64,
    /// The smallest tilt, rad.
    pub min_tilt: f64,
    /// The tilt at the end, rad. If the body rocked, this is the largest tilt.
    pub max_tilt: f64,
    /// Time of the smallest tilt, s.
    pub min_time: f64,
    /// Time of the end, s.
    pub time: f64,
    /// Change of yaw from the release to the end, rad, including the part before the turn begins.
    pub yaw: f64,
}

/// A body under one of the two ideal laws, prepared for many starts.
pub struct Exact {
    body: Body,
    law: IdealLaw,
    parameters: Parameters<f64>,
    /// For no slip: covers all tilts below the end.
    table: Option<Fundamental<f64>>,
    /// For no slip: covers the tilts up to the balance point, with fewer terms.
    rocking_table: Option<Fundamental<f64>>,
    balance: Balance,
    options: Options,
}

impl Exact {
    /// Prepares the body for starts under gravity g (m/s²). `topple_tilt` (rad) is that of [`Options`].
    ///
    /// # Errors
    /// Refuses numbers outside their bounds.
    pub fn new(
        body: &Body,
        law: IdealLaw,
        gravity: f64,
        topple_tilt: Option<f64>,
    ) -> Result<Exact, InvalidInput> {
        let options = options(body, gravity, topple_tilt)?;
        let parameters = Parameters::new(body, gravity);
        let rolls = law == IdealLaw::NoSlip;
        let mut exact = Exact {
            body: *body,
            law,
            parameters,
            table: None,
            rocking_table: None,
            balance: Balance::new(body, gravity, end(&options).0),
            options,
        };
        exact.table = rolls.then(|| Fundamental::new(parameters, exact.end().0));
        exact.rocking_table = rolls.then(|| Fundamental::new(parameters, exact.highest()));
        Ok(exact)
    }

    fn end(&self) -> (f64, Outcome) {
        end(&self.options)
    }

    /// The upper bound of the tilt of a rocking body, as tan(φ/2): the balance point.
    fn highest(&self) -> f64 {
        self.balance.y
    }

    /// The minimum of |dG/dη| at the largest tilt, below which a rocking body lingers there.
    fn min_slope(&self) -> f64 {
        LINGERING * self.balance.curvature
    }

    /// Whether the start lies outside the range of the quadrature.
    fn is_beyond(&self, start: &State) -> bool {
        is_beyond(start, &self.options)
    }

    /// The turn of one start.
    ///
    /// # Errors
    /// Refuses a start outside its bounds.
    pub fn turn(&self, start: &State) -> Result<ExactTurn, InvalidInput> {
        self.check(start)?;
        Ok(self.turn_of(start))
    }

    fn check(&self, start: &State) -> Result<(), InvalidInput> {
        self.options.check(start)
    }

    /// The engine for starts that rock.
    fn rocking_engine(&self) -> Engine<'_> {
        self.engine(&self.rocking_table)
    }

    /// The engine for all other starts.
    fn general_engine(&self) -> Engine<'_> {
        self.engine(&self.table)
    }

    fn engine<'a>(&'a self, table: &'a Option<Fundamental<f64>>) -> Engine<'a> {
        match table {
            Some(table) => Engine::NoSlip(table),
            None => Engine::Frictionless(&self.parameters),
        }
    }

    fn turn_of(&self, start: &State) -> ExactTurn {
        let quadrature = if self.is_beyond(start) {
            None
        } else {
            self.quadrature(start)
        };
        match quadrature {
            Some(quadrature) => resolved(&quadrature, &self.parameters),
            None => self.stepped(start),
        }
    }

    fn quadrature(&self, start: &State) -> Option<Quadrature<f64>> {
        let start = Start::of(start);
        match &self.table {
            Some(table) => self.scalar(&NoSlipTilt::new(table, &start), &self.parameters, start),
            None => self.scalar(
                &FrictionlessTilt::new(self.parameters, &start),
                &self.parameters,
                start,
            ),
        }
    }

    fn scalar<T: Scalar>(
        &self,
        motion: &dyn TiltEquation<T>,
        k: &Parameters<T>,
        start: Start<T>,
    ) -> Option<Quadrature<T>> {
        quadrature_of(motion, k, start, self.end(), self.balance)
    }

    /// The turn by time integration, for starts outside the range of the quadrature.
    fn stepped(&self, start: &State) -> ExactTurn {
        // Zero initial yaw and spin make the result independent of them to the last bit.
        let start = &State {
            yaw: 0.0,
            spin: 0.0,
            ..*start
        };
        let fall = fall(&self.body, start, &self.law.into(), &self.options)
            .expect("start and options were checked");
        turn_of_fall(&fall, start)
    }
}

/// The options of a motion for the quadrature, or in its place.
fn options(body: &Body, gravity: f64, topple_tilt: Option<f64>) -> Result<Options, InvalidInput> {
    let gravity = positive("gravity", gravity, "m/s2")?;
    let options = Options {
        gravity,
        topple_tilt,
        duration: 1000.0 * natural_time(body, gravity),
        rtol: 1e-13,
        ..Options::default()
    };
    // With a start that is always valid, this checks the options.
    let start = State {
        tilt: 1e-300,
        ..State::default()
    };
    options.checked(body, &start)
}

/// Whether a start lies outside the range of the quadrature.
fn is_beyond(start: &State, options: &Options) -> bool {
    start.tilt >= FRAC_PI_2 || options.topple_tilt > Some(FRAC_PI_2)
}

/// The end of a motion without an upper turning point, as tan(φ/2), and its outcome. For a disk this can be
/// the vertical: its turn ends there, and it falls to the other face.
fn end(options: &Options) -> (f64, Outcome) {
    match options.topple_tilt {
        Some(tilt) if tilt < FRAC_PI_2 => (half_tangent(tilt), Outcome::Toppled),
        Some(tilt) if tilt == FRAC_PI_2 => (1.0, Outcome::Toppled),
        _ => (1.0, Outcome::Rocked),
    }
}

/// √(J/(mg√(R² + H²))), the time scale of falling over, s.
fn natural_time(body: &Body, gravity: f64) -> f64 {
    let arm = libm::hypot(body.radius(), body.height());
    (body.rim_inertia() / (body.mass() * gravity * arm)).sqrt()
}

/// The turn of a quadrature. A body that lifts off as it rises past the balance point falls over.
fn resolved(quadrature: &Quadrature<f64>, k: &Parameters<f64>) -> ExactTurn {
    let turn = turn_of_quadrature(quadrature);
    match turn.ending {
        Outcome::LiftedOff => ExactTurn {
            outcome: Outcome::lifted_off(k.is_past_balance(turn.max_tilt)),
            ..turn
        },
        _ => turn,
    }
}

fn turn_of_quadrature(outcome: &Quadrature<f64>) -> ExactTurn {
    let tilt = |y: Option<f64>| y.map_or(f64::NAN, |y| 2.0 * libm::atan(y));
    let of = |segment: &Option<segments::Segment<f64>>,
              number: fn(&segments::Segment<f64>) -> f64| {
        segment.as_ref().map_or(f64::NAN, number)
    };
    let before = outcome.before.unwrap_or(segments::Segment::nothing());
    let turn = of(&outcome.down, |segment| segment.yaw) + of(&outcome.up, |segment| segment.yaw);
    let min_time = before.time + of(&outcome.down, |segment| segment.time);
    ExactTurn {
        ending: outcome.ending,
        outcome: outcome.ending,
        turn,
        min_tilt: tilt(outcome.low),
        max_tilt: tilt(outcome.high),
        min_time,
        time: min_time + of(&outcome.up, |segment| segment.time),
        yaw: before.yaw + turn,
    }
}

fn turn_of_fall(fall: &Fall, start: &State) -> ExactTurn {
    let of_turn =
        |number: fn(&crate::motion::Turn) -> f64| fall.turn.as_ref().map_or(f64::NAN, number);
    let ending = match fall.status {
        Status::LiftedOff => Outcome::LiftedOff,
        _ => fall.outcome,
    };
    ExactTurn {
        ending,
        outcome: fall.outcome,
        turn: of_turn(|turn| turn.angle),
        min_tilt: of_turn(|turn| turn.min_tilt),
        max_tilt: of_turn(|turn| turn.max_tilt),
        min_time: of_turn(|turn| turn.t),
        time: of_turn(|turn| turn.end),
        yaw: fall.end.yaw - start.yaw,
    }
}

/// A number with its derivatives with respect to start, body and gravity.
type Varied = Dual<Slopes<{ PARAMETERS.len() }>>;

impl Exact {
    /// The derivatives of the turns of many starts with respect to each of [`PARAMETERS`] (rad per SI unit), for
    /// bodies that rock or topple, by the quadrature in dual numbers. NaN for other outcomes and for the few starts outside the range of the
    /// quadrature.
    ///
    /// # Errors
    /// As [`Exact::turns`].
    pub fn turn_slopes(&self, starts: &[State]) -> Result<Vec<Slope>, InvalidInput> {
        let slopes = self.turn_slopes_while(starts, || true)?;
        Ok(slopes.expect("nothing has ended the work"))
    }

    /// The derivatives of the turns of many starts, or `None` if `should_continue` returns false. It is called
    /// before each start.
    ///
    /// # Errors
    /// As [`Exact::turns`].
    pub fn turn_slopes_while(
        &self,
        starts: &[State],
        should_continue: impl Fn() -> bool + Sync,
    ) -> Result<Option<Vec<Slope>>, InvalidInput> {
        for start in starts {
            self.check(start)?;
        }
        let k = self.varied_parameters();
        let table = self.table.as_ref().map(|table| Fundamental::like(table, k));
        let slope = |start: &State| {
            let slope = || self.slope_of(start, k, table.as_ref());
            should_continue().then(|| slope().unwrap_or([f64::NAN; PARAMETERS.len()]))
        };
        #[cfg(feature = "threads")]
        let starts = starts.par_iter();
        #[cfg(not(feature = "threads"))]
        let starts = starts.iter();
        Ok(starts.map(slope).collect())
    }

    fn slope_of(
        &self,
        start: &State,
        k: Parameters<Varied>,
        table: Option<&Fundamental<Varied>>,
    ) -> Option<Slope> {
        if self.is_beyond(start) {
            return None;
        }
        let varied = [
            (start.tilt, "tilt"),
            (start.tilt_rate, "tilt_rate"),
            (start.yaw_rate, "yaw_rate"),
            (start.spin_rate, "spin_rate"),
        ];
        let start = Start::new(varied.map(|(value, name)| along(value, name)));
        let outcome = match table {
            Some(table) => self.scalar(&NoSlipTilt::new(table, &start), &k, start),
            None => self.scalar(&FrictionlessTilt::new(k, &start), &k, start),
        }?;
        let known = matches!(outcome.ending, Outcome::Rocked | Outcome::Toppled);
        let turn = (outcome.down? + outcome.up?).yaw;
        known.then_some(turn.slope.0)
    }

    fn varied_parameters(&self) -> Parameters<Varied> {
        let k = self.parameters;
        Parameters {
            m: along(k.m, "mass"),
            r: along(k.r, "radius"),
            h: along(k.h, "height"),
            a: along(k.a, "transverse_inertia"),
            c: along(k.c, "axial_inertia"),
            g: along(k.g, "gravity"),
        }
    }
}

/// A dual number whose slope is 1 in the direction of the named parameter.
fn along(value: f64, name: &str) -> Varied {
    Dual {
        value,
        slope: Slopes(PARAMETERS.map(|parameter| f64::from(u8::from(parameter == name)))),
    }
}
