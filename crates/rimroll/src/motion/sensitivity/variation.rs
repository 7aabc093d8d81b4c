//! Phases of a motion on a table that moves, repeated in dual numbers.

use super::on_moving_table::Number;
use super::{CoordinatesAndRates, values};
use crate::law::Parameters;
use crate::motion::contacts::Contacts;
use crate::motion::instant::Phase;
use crate::motion::level_equations::{LevelEquations, LevelMotion, PLACES};
use crate::motion::phase_dynamics::PhaseDynamics;
use crate::motion::step_record::StepRecord;
use crate::real::{Dual, Slope as _, Slopes};
use crate::solve::Step;
use crate::state::{COORDINATES, Coordinates, TIME};

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
            Phase::Standing | Phase::Lying => Coordinates {
                t: (t + h).into(),
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
            phase => {
                let phases = self.phases(contacts, t);
                let mechanics = phases.mechanics(phase, record.clock);
                let step: Step<Number, COORDINATES> =
                    Step::take(&mechanics, &start.into_array(), h.into());
                Coordinates::from_array(&step.end)
            }
        }
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
            let stretch = contacts.ground().map(|ground| ground.stretch(t));
            let (k, sliding) = (*contacts.parameters(), contacts.dynamics(Phase::Sliding));
            let motion = LevelMotion {
                equations: LevelEquations::new(k, u.yaw, sliding, contacts.is_dry()),
                stretch: stretch.map(|stretch| (stretch, 1.0)),
                slides: record.phase == Phase::SlidingFlat,
            };
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
