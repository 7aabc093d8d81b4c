//! The turn by quadrature, under the two laws without loss.
//!
//! Without slip and without friction energy is conserved and the other velocities follow from the tilt,
//! so that the whole motion is quadrature (the paper says so of the frictionless one, section
//! "Frictionless sliding"). No steps are made: the smallest and the largest tilt are roots, and yaw and
//! time integrals with a rule that gains digits with every node. What makes that work however near the
//! near-collision is:
//!
//! * the tilt's logarithm as clock (`tilting`), in which the collision and the rest of the motion are of
//!   like length,
//! * for rolling, a table of the body's fundamental solutions (`fundamental`),
//! * the part of the yaw that the collision alone makes in closed form (`segments`).
//!
//! `scalar` treats one start with all that can become of it; `rocking` sixteen at a time that rock,
//! `toppling` sixteen that topple. `bodies` sorts many starts by their bodies.

mod antiderivative;
mod batch;
mod bodies;
mod dispatch;
mod extremes;
mod fundamental;
mod ridge;
mod rocking;
mod rolling;
mod rule;
mod scalar;
mod segments;
mod sensitivity;
mod sign_search;
mod sliding;
mod start;
mod tilting;
mod top;
mod toppling;
mod waiting;
mod watershed;
mod wobble;

use crate::body::Body;
use crate::error::{InvalidInput, positive};
use crate::law::{IdealLaw, Parameters};
use crate::motion::{Fall, Options, Outcome, Status, fall};
use crate::state::State;
pub use bodies::ExactRows;
use core::f64::consts::FRAC_PI_2;
use dispatch::Engine;
use fundamental::Fundamental;
use ridge::Balance;
use rolling::Rolling;
use scalar::{Quadrature, Scalar, ScalarQuadrature};
use sliding::Sliding;
use start::Start;
use tilting::Tilting;
use top::{OnTop, lingers};
pub use watershed::watershed_slope;

/// Below this sin φ the base counts as flat on the table, as in a simulated motion.
const FLAT: f64 = crate::motion::FACE_DOWN_TILT;

/// Nearer to an extreme than this, in η, G has no digits left.
const SHORT: f64 = 3e-6;

/// A body that turns back so near to the balance point, in η, lingers.
const LINGERING: f64 = 0.03;

/// Of the way between the smallest and the largest tilt, in η, at most this much belongs to the latter.
const MAX_OUTER: f64 = 2.6;

/// Points at which the sign of a function is looked at in search of a first root.
const SAMPLES: usize = 24;

/// The first turn of a motion, and what became of it. What does not exist is NaN.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ExactTurn {
    /// How it ended. A rim that leaves the table ends the turn wherever the body leans.
    pub ending: Outcome,
    /// What became of the body: the same, except that it falls over if its rim leaves the table as it rises
    /// past the balance point.
    pub outcome: Outcome,
    /// Change of yaw from the release, or the largest tilt after it, through the smallest tilt to the
    /// end, rad.
    pub turn: f64,
    /// The smallest tilt, rad.
    pub min_tilt: f64,
    /// The tilt at the end, the largest if it rocked, rad.
    pub max_tilt: f64,
    /// When the tilt was smallest, s.
    pub min_time: f64,
    /// When it was over, s.
    pub time: f64,
    /// Change of yaw from the release to the end, rad: the turn, and what came before it.
    pub yaw: f64,
}

/// A body under one of the two laws, ready for many starts.
pub struct Exact {
    body: Body,
    law: IdealLaw,
    parameters: Parameters<f64>,
    /// For rolling, over all tilts below the end.
    table: Option<Fundamental<f64>>,
    /// For rolling, over the tilts in which a body rocks: shorter.
    rocking_table: Option<Fundamental<f64>>,
    balance: Balance,
    options: Options,
}

impl Exact {
    /// Prepares for starts under gravity g (m/s²). `topple_tilt` (rad) as in [`Options`].
    ///
    /// # Errors
    /// Refuses numbers outside their bounds.
    pub fn new(
        body: &Body,
        law: IdealLaw,
        gravity: f64,
        topple_tilt: Option<f64>,
    ) -> Result<Exact, InvalidInput> {
        let gravity = positive("gravity", gravity, "m/s2")?;
        let options = Options {
            gravity,
            topple_tilt,
            duration: 1000.0 * natural_time(body, gravity),
            rtol: 1e-13,
            ..Options::default()
        };
        // A start that none refuses shows whether the rest is in order.
        let start = State {
            tilt: 1e-300,
            ..State::default()
        };
        let options = options.checked(body, &start)?;
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

    /// How far a body that rocks may tilt, tan(φ/2): to the balance point.
    fn highest(&self) -> f64 {
        self.balance.y
    }

    /// At the largest tilt of a body that rocks and does not all but linger there, dG/dη is steeper.
    fn least_slope(&self) -> f64 {
        LINGERING * self.balance.curvature
    }

    /// Whether quadrature does not reach the start.
    fn is_beyond(&self, start: &State) -> bool {
        start.tilt >= FRAC_PI_2 || self.options.topple_tilt > Some(FRAC_PI_2)
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

    /// For starts that rock.
    fn rocking_engine(&self) -> Engine<'_> {
        self.engine(&self.rocking_table)
    }

    /// For all others.
    fn passing_engine(&self) -> Engine<'_> {
        self.engine(&self.table)
    }

    fn engine<'a>(&'a self, table: &'a Option<Fundamental<f64>>) -> Engine<'a> {
        match table {
            Some(table) => Engine::Rolling(table),
            None => Engine::Sliding(&self.parameters),
        }
    }

    fn turn_of(&self, start: &State) -> ExactTurn {
        let quadrature = if self.is_beyond(start) {
            None
        } else {
            self.quadrature(start)
        };
        let Some(turn) = quadrature.map(|quadrature| turn_of_quadrature(&quadrature)) else {
            return self.stepped(start);
        };
        match turn.ending {
            Outcome::LiftedOff => ExactTurn {
                outcome: Outcome::lifted_off(self.parameters.is_past_balance(turn.max_tilt)),
                ..turn
            },
            _ => turn,
        }
    }

    fn quadrature(&self, start: &State) -> Option<Quadrature<f64>> {
        let start = Start::of(start);
        match &self.table {
            Some(table) => self.scalar(&Rolling::new(table, &start), &self.parameters, start),
            None => self.scalar(
                &Sliding::new(self.parameters, &start),
                &self.parameters,
                start,
            ),
        }
    }

    fn scalar<T: Scalar>(
        &self,
        motion: &dyn Tilting<T>,
        k: &Parameters<T>,
        start: Start<T>,
    ) -> Option<Quadrature<T>> {
        let (end, balance) = (self.end(), self.balance);
        if lingers(motion, &start, &balance) {
            let motion = OnTop::new(motion, k, start, [balance.eta, libm::log(end.0)]);
            return ScalarQuadrature::new(&motion, start, end, balance).quadrature();
        }
        ScalarQuadrature::new(motion, start, end, balance).quadrature()
    }

    /// The same by steps, where quadrature does not reach.
    fn stepped(&self, start: &State) -> ExactTurn {
        // The turn does not depend on where yaw and spin begin, nor shall its last digit.
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

/// Where a motion ends that nothing turns back, tan(φ/2), and what that is called. A disk may pass
/// the vertical, where its turn is over, and fall to the other face.
fn end(options: &Options) -> (f64, Outcome) {
    match options.topple_tilt {
        Some(tilt) if tilt < FRAC_PI_2 => (half_tangent(tilt), Outcome::Toppled),
        Some(tilt) if tilt == FRAC_PI_2 => (1.0, Outcome::Toppled),
        _ => (1.0, Outcome::Rocked),
    }
}

/// √(J/(mg√(R² + H²))): how long it takes to fall over, s.
fn natural_time(body: &Body, gravity: f64) -> f64 {
    let arm = libm::hypot(body.radius(), body.height());
    (body.rim_inertia() / (body.mass() * gravity * arm)).sqrt()
}

fn half_tangent(tilt: f64) -> f64 {
    let (sin, cos) = libm::sincos(tilt);
    sin / (1.0 + cos)
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
