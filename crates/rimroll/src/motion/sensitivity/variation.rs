//! Phases of a motion, repeated in dual numbers.

use super::collocated::Linearised;
use super::shaken_slope::{Number, SHAKEN_PARAMETERS, ShakenSlope, sizes_of_parameters};
use super::{CoordinatesAndRates, values};
use crate::law::{DynamicsExt, Parameters};
use crate::motion::contacts::Contacts;
use crate::motion::instant::Phase;
use crate::motion::level_base::{LevelBase, LevelMotion, PLACES};
use crate::motion::phase_dynamics::PhaseDynamics;
use crate::motion::phase_system::IndependentVariable;
use crate::motion::step_record::{Polynomial, StepRecord};
use crate::real::{Dual, Slope as _, Slopes};
use crate::solve::{Collocation, POINTS, RADAU, Step};
use crate::state::{COORDINATES, Coordinates, TIME};

/// The number of parameters.
const PARAMETERS: usize = SHAKEN_PARAMETERS.len();

/// The body and gravity, and the factor on the acceleration of the table, with their derivatives.
#[derive(Clone, Copy)]
pub(super) struct Variation {
    pub(super) k: Parameters<Number>,
    pub(super) factor: Number,
}

impl Variation {
    /// These values without derivatives.
    fn constant(&self) -> Variation {
        let [m, r, h, a, c, g] = self.k.as_array().map(|dual: Number| dual.value.into());
        Variation {
            k: Parameters { m, r, h, a, c, g },
            factor: self.factor.value.into(),
        }
    }

    /// The equations of motion for steps that begin at a time, s.
    pub(super) fn phases(&self, contacts: &Contacts, t: f64) -> PhaseDynamics<Number> {
        contacts.varied_phases_from(self.k, self.factor, t)
    }

    /// Runs `computation` on the equations of a body with this yaw whose base is level, in steps that begin at a time, s.
    pub(super) fn with_level<R>(
        &self,
        contacts: &Contacts,
        (phase, t): (Phase, f64),
        yaw: Number,
        computation: impl FnOnce(&LevelMotion<'_, Number>) -> R,
    ) -> R {
        let phases = self.phases(contacts, t);
        let stretch = contacts.ground().map(|ground| ground.stretch(t));
        computation(&LevelMotion::new(&phases, phase, yaw, stretch, self.factor))
    }

    /// The coordinates at the fraction x of a step that begins at `start`.
    pub(super) fn followed(
        &self,
        contacts: &Contacts,
        record: &StepRecord,
        start: &Coordinates<Number>,
        x: f64,
    ) -> Coordinates<Number> {
        let h = x * record.h;
        let t = record.start[TIME];
        match record.phase {
            phase if is_collocated(contacts, record) => {
                self.collocated(contacts, record, phase, start, x)
            }
            Phase::Standing | Phase::Lying => Coordinates {
                t: start.t + Number::from(h),
                ..*start
            },
            Phase::SlidingFlat | Phase::FlyingLevel => {
                let mut all = start.into_array();
                let changing = PLACES.map(|place| all[place]);
                let end = self.with_level(contacts, (record.phase, t), start.yaw, |motion| {
                    Step::take(motion, &changing, h.into()).end
                });
                for (component, place) in end.into_iter().zip(PLACES) {
                    all[place] = component;
                }
                Coordinates::from_array(&all)
            }
            phase => self
                .in_parts(contacts, record, start, x)
                .unwrap_or_else(|| self.collocated(contacts, record, phase, start, x)),
        }
    }

    /// [`Self::followed`] for an explicit step: in one step if that suits the derivatives, too, or in smaller ones. `None`
    /// if there would be very many.
    ///
    /// The size of a step keeps the errors of the coordinates small. Those of the derivatives are larger where the rates have
    /// a kink. They grow without bound where the coordinates stay near an equilibrium for which the step is too long: at a
    /// straight slip, or in a plane, out of which no rounding error pushes the body.
    fn in_parts(
        &self,
        contacts: &Contacts,
        record: &StepRecord,
        start: &Coordinates<Number>,
        x: f64,
    ) -> Option<Coordinates<Number>> {
        const MOST_TRIES: usize = 60;
        let phases = self.phases(contacts, record.start[TIME]);
        let phase_system = phases.phase_system(record.phase, record.variable);
        let accuracy = DerivativeAccuracy::new(contacts);
        let mut at = start.into_array();
        // All parts are powers of two, so that their sum is exact.
        let (mut done, mut part) = (0.0, 1.0);
        for _ in 0..MOST_TRIES {
            let h = part * x * record.h;
            let step: Step<Number, COORDINATES> = Step::take(&phase_system, &at, h.into());
            if accuracy.suffices(&step) {
                at = step.end;
                done += part;
                if done == 1.0 {
                    return Some(Coordinates::from_array(&at));
                }
                part = (2.0 * part).min(1.0 - done);
            } else {
                part *= 0.5;
            }
        }
        None
    }

    /// [`Self::followed`] for a step whose dense output is a polynomial. The derivatives are those at a fixed time.
    fn collocated(
        &self,
        contacts: &Contacts,
        record: &StepRecord,
        phase: Phase,
        start: &Coordinates<Number>,
        x: f64,
    ) -> Coordinates<Number> {
        let dense = record.dense(contacts);
        let at_start = rates(contacts, record, &values(start));
        let start = CoordinatesAndRates {
            u: *start,
            rates: at_start,
        }
        .at_fixed_time();
        let t = record.start[TIME];
        let constant = self.constant();
        if phase == Phase::SlidingFlat {
            let linearised = Linearised {
                varied: |u: &Coordinates<Number>| self.flat_rates(contacts, t, u),
                constant: |u: &Coordinates<Number>| constant.flat_rates(contacts, t, u),
            };
            let speed = |u: &[f64; COORDINATES]| flat_time_rate(contacts, record, u);
            let time_rates = RADAU.map(|c| record.h * speed(&dense.at(c)));
            return linearised.followed(&dense, &time_rates, &start, x);
        }
        let (varied, constant) = (self.phases(contacts, t), constant.phases(contacts, t));
        let in_time = |phases: &PhaseDynamics<Number>, u: &Coordinates<Number>| {
            let per_time = Number::from(1.0) / u.sin;
            let rates = phases.in_phase(phase).rates(u).into_array();
            Coordinates::from_array(&rates.map(|rate| rate * per_time))
        };
        let linearised = Linearised {
            varied: |u: &Coordinates<Number>| in_time(&varied, u),
            constant: |u: &Coordinates<Number>| in_time(&constant, u),
        };
        let time_rates = match record.variable {
            IndependentVariable::Time => [record.h; POINTS],
            IndependentVariable::Regularized => time_rates(contacts, record, &dense),
        };
        linearised.followed(&dense, &time_rates, &start, x)
    }

    /// The rates with respect to the time of a level base that slides, in steps that begin at a time, s.
    fn flat_rates(
        &self,
        contacts: &Contacts,
        t: f64,
        u: &Coordinates<Number>,
    ) -> Coordinates<Number> {
        let rates = self.with_level(contacts, (Phase::SlidingFlat, t), u.yaw, |motion| {
            let all = u.into_array();
            motion.rates_in_time(&PLACES.map(|place| all[place]))
        });
        let mut all = [Number::from(0.0); COORDINATES];
        for (rate, place) in rates.into_iter().zip(PLACES) {
            all[place] = rate;
        }
        Coordinates::from_array(&all)
    }

    /// The coordinates at an event at the end of a step: with the derivatives at a fixed value of a function. An event that
    /// comes with a corner of the table's acceleration has a fixed time, at which the derivatives are already.
    pub(super) fn at_event(
        &self,
        contacts: &Contacts,
        record: &StepRecord,
        u: &Coordinates<Number>,
        function: impl Fn(&Variation, &Coordinates<Number>) -> Number,
    ) -> Coordinates<Number> {
        if ends_at_corner(contacts, record) {
            return *u;
        }
        let rates = rates(contacts, record, &values(u));
        let along = core::array::from_fn(|i| Dual {
            value: u.into_array()[i].value,
            slope: first(rates.into_array()[i]),
        });
        let rate = function(&self.constant(), &Coordinates::from_array(&along));
        let g = (function(self, u), rate.slope.0[0]);
        CoordinatesAndRates { u: *u, rates }.fixed(&g)
    }
}

/// How accurate derivatives have to be.
struct DerivativeAccuracy {
    /// The errors over the largest derivative by the same parameter, which is at least [`Self::LEAST`].
    tolerance: f64,
    parameters: ShakenSlope,
    /// The natural units of the coordinates that matter, or infinity.
    units: [f64; COORDINATES],
}

impl DerivativeAccuracy {
    /// A derivative in natural units that counts as none: that by the mass consists of rounding errors.
    const LEAST: f64 = 1e-3;

    fn new(contacts: &Contacts) -> Self {
        let k = contacts.parameters();
        let rate = (k.g / k.r).sqrt();
        let units = Coordinates {
            yaw: 1.0,
            spin: 1.0,
            t: 1.0 / rate,
            sin: 1.0,
            cos: 1.0,
            p: rate,
            w: rate,
            s: rate,
            x1: k.r,
            y1: k.r,
            slip_x: k.r * rate,
            slip_y: k.r * rate,
            gap: k.r,
            gap_rate: k.r * rate,
            friction_loss: f64::INFINITY,
            resistance_loss: f64::INFINITY,
            impact_loss: f64::INFINITY,
            ground_work: f64::INFINITY,
        };
        DerivativeAccuracy {
            // Rounding errors of the derivatives at a fixed τ are far larger than those at a fixed time.
            tolerance: (100.0 * contacts.tolerance()).max(1e-9),
            parameters: sizes_of_parameters(k),
            units: units.into_array(),
        }
    }

    /// Whether the derivatives by all parameters are accurate in a step.
    fn suffices(&self, step: &Step<Number, COORDINATES>) -> bool {
        let [fifth, third] = step.errors().map(|errors| self.sizes(&errors, step));
        let sizes = [self.sizes(&step.start, step), self.sizes(&step.end, step)];
        (0..PARAMETERS).all(|i| {
            let (fifth, third) = (fifth[i], third[i]);
            let both = libm::hypot(fifth, 0.1 * third).max(f64::MIN_POSITIVE);
            let size = sizes[0][i].max(sizes[1][i]).max(Self::LEAST);
            let relative = fifth * fifth / both / size;
            // It is NaN where there is no derivative.
            relative.is_nan() || relative <= self.tolerance
        })
    }

    /// The largest derivatives by each parameter: at a fixed time where a body that stood has begun to rock, because those at
    /// a fixed τ are far larger then, and they have other errors.
    fn sizes(
        &self,
        numbers: &[Number; COORDINATES],
        step: &Step<Number, COORDINATES>,
    ) -> [f64; PARAMETERS] {
        const SMALL: f64 = 1e-2;
        let mut u = Coordinates::from_array(numbers);
        let start = Coordinates::from_array(&step.start);
        let begins_at_fixed_time = start.t.slope.0.iter().all(|x| *x == 0.0 || x.is_nan());
        if begins_at_fixed_time && start.sin.value < SMALL && start.p.value >= 0.0 {
            let rates = values(&Coordinates::from_array(step.end_rates()));
            u = CoordinatesAndRates { u, rates }.at_fixed_time();
        }
        let all = u.into_array();
        core::array::from_fn(|i| {
            let sizes = all.iter().zip(self.units);
            let sizes = sizes.map(|(x, unit)| (x.slope.0[i] / unit).abs());
            self.parameters[i] * sizes.fold(0.0, f64::max)
        })
    }
}

/// Whether the dense output of a step is a polynomial that other steps than explicit ones have made.
fn is_collocated(contacts: &Contacts, record: &StepRecord) -> bool {
    record.is_polynomial()
        && record.h != 0.0
        && match record.phase {
            Phase::Standing | Phase::FlyingLevel | Phase::Lying => false,
            Phase::SlidingFlat => contacts.is_dry(),
            Phase::Rolling | Phase::Sliding | Phase::Flying => true,
        }
}

/// dt/dx at the points of a step, where x is the fraction of the step.
///
/// The steps at an onset of dry slip are made with respect to τ, other implicit ones with respect to the regularized
/// variable of the law. The change of the time over the step shows which.
fn time_rates(contacts: &Contacts, record: &StepRecord, dense: &Polynomial) -> [f64; POINTS] {
    let phases = contacts.phases_from(record.start[TIME]);
    let phase_system = phases.phase_system(record.phase, IndependentVariable::Regularized);
    let points = RADAU.map(|c| Coordinates::from_array(&dense.at(c)));
    let [by_tau, by_sigma] = [false, true].map(|is_scaled| {
        points.map(|u| {
            let factor = if is_scaled {
                phase_system.sundman_factor(&u)
            } else {
                1.0
            };
            record.h * u.sin * factor
        })
    });
    let weights = Collocation::get().integral[POINTS - 1];
    let lasting = record.end[TIME] - record.start[TIME];
    let error = |rates: &[f64; POINTS]| {
        let sum: f64 = weights.iter().zip(rates).map(|(a, b)| a * b).sum();
        (sum - lasting).abs()
    };
    if error(&by_tau) < error(&by_sigma) {
        by_tau
    } else {
        by_sigma
    }
}

/// dt/dσ of a level base that slides.
fn flat_time_rate(contacts: &Contacts, record: &StepRecord, u: &[f64; COORDINATES]) -> f64 {
    let u = Coordinates::from_array(u);
    level_motion(contacts, record, &u).time_rate([u.slip_x, u.slip_y])
}

/// The motion of a level base in a step.
fn level_motion<'a>(
    contacts: &'a Contacts,
    record: &StepRecord,
    u: &Coordinates<f64>,
) -> LevelMotion<'a> {
    let t = record.start[TIME];
    let stretch = contacts.ground().map(|ground| ground.stretch(t));
    LevelBase::new(contacts, u.yaw).motion(record.phase, stretch)
}

/// Whether a step ends, or has no length, at a corner of the table's acceleration.
pub(super) fn ends_at_corner(contacts: &Contacts, record: &StepRecord) -> bool {
    record.h == 0.0 || record.end[TIME] == contacts.corner_after(record.start[TIME])
}

/// A derivative in the first direction.
fn first<const K: usize>(rate: f64) -> Slopes<K> {
    let mut slopes = Slopes::ZERO;
    slopes.0[0] = rate;
    slopes
}

/// The rates in a step, with respect to the time where the base is level and to τ elsewhere.
pub(super) fn rates(
    contacts: &Contacts,
    record: &StepRecord,
    u: &Coordinates<f64>,
) -> Coordinates<f64> {
    let t = record.start[TIME];
    match record.phase {
        Phase::Standing | Phase::Lying => Coordinates {
            t: 1.0,
            ..Coordinates::zero()
        },
        Phase::SlidingFlat | Phase::FlyingLevel => {
            let motion = level_motion(contacts, record, u);
            let u = u.into_array();
            let rates = motion.rates_in_time(&PLACES.map(|place| u[place]));
            let mut all = [0.0; COORDINATES];
            for (rate, place) in rates.into_iter().zip(PLACES) {
                all[place] = rate;
            }
            Coordinates::from_array(&all)
        }
        phase => contacts.phases_from(t).in_phase(phase).rates(u),
    }
}
