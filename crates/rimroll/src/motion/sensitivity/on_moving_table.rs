//! The derivatives of a motion on a table that moves.

use super::saltation::{Saltation, flat_function, refused, tilt_from};
use super::shaken_slope::{
    Number, SHAKEN_PARAMETERS, ShakenSlope, all_or_none, without, without_rounding_across,
};
use super::variation::{Variation, ends_at_corner, rates};
use super::{
    CoordinatesAndRates, PARAMETERS, STEPS_BETWEEN_REPORTS, parameter, start, state_slopes,
    turn_slope, values, varied_parameters, with_values,
};
use crate::ending::Status;
use crate::error::InvalidInput;
use crate::law::FrictionLaw;
use crate::motion::Motion;
use crate::motion::event::EventKind;
use crate::motion::instant::Phase;
use crate::motion::shaken::{footprint, largest_tilt};
use crate::motion::step_record::StepRecord;
use crate::state::{Coordinates, TIME};
use core::ops::ControlFlow;

/// The derivatives of a motion on a table that moves.
///
/// There is no derivative by tilt, tilt rate, yaw rate and spin rate of a start that stands; by the spin rate of a body that
/// wobbles in place, which is not free; by parameters that would take the motion out of its plane, after the whole base
/// has come down flat at once or a rim that slips has landed in that plane; and by any parameter after a slip that has
/// stopped without a deceleration.
pub struct ShakenSensitivity {
    variation: Variation,
    start: Coordinates<Number>,
    /// The coordinates at the start of each step.
    starts: Vec<Coordinates<Number>>,
    end: Coordinates<Number>,
    uplift_time: Option<ShakenSlope>,
    turns: Vec<ShakenSlope>,
}

impl Motion {
    /// The derivatives of a motion on a table that moves, as [`Motion::sensitivity`] gives those on a table at rest.
    ///
    /// # Errors
    /// Refuses a table at rest, a body that passes through upright in flight, and one whose base comes down flat and
    /// smoothly under friction or with resistance.
    pub fn shaken_sensitivity(
        &self,
        mut watch: impl FnMut(f64) -> ControlFlow<()>,
    ) -> Result<Option<ShakenSensitivity>, InvalidInput> {
        if !self.contacts.moves() {
            return Err(refused("its table is at rest"));
        }
        ShakenSensitivity::new(self, &mut watch)
    }
}

impl ShakenSensitivity {
    /// The sensitivity of a motion; `None` if `watch` breaks. On a table at rest the derivatives by the factor on its
    /// acceleration are zero.
    pub(super) fn new(
        motion: &Motion,
        watch: &mut dyn FnMut(f64) -> ControlFlow<()>,
    ) -> Result<Option<ShakenSensitivity>, InvalidInput> {
        let variation = Variation {
            k: varied_parameters(motion.contacts.parameters()),
            factor: parameter(1.0, PARAMETERS.len()),
        };
        let start = shaken_start(motion, &variation);
        let mut sensitivity = ShakenSensitivity {
            variation,
            start,
            starts: Vec::with_capacity(motion.trajectory.records().len()),
            end: start,
            uplift_time: None,
            turns: Vec::new(),
        };
        let completed = sensitivity.differentiate(motion, watch)?;
        Ok(completed.is_continue().then_some(sensitivity))
    }

    fn differentiate(
        &mut self,
        motion: &Motion,
        watch: &mut dyn FnMut(f64) -> ControlFlow<()>,
    ) -> Result<ControlFlow<()>, InvalidInput> {
        let start = self.start.t.value;
        let first = motion.events.first();
        if first.is_some_and(|event| event.kind == EventKind::FaceDown && event.at.t == start) {
            return Err(refused("the base comes down flat from below flat_gap"));
        }
        let mut before: Option<&StepRecord> = None;
        for (i, record) in motion.trajectory.records().iter().enumerate() {
            if i % STEPS_BETWEEN_REPORTS == 0 && watch(record.start[TIME]).is_break() {
                return Ok(ControlFlow::Break(()));
            }
            if let Some(before) = before {
                let saltation = Saltation {
                    motion,
                    variation: &self.variation,
                    before,
                    after: record,
                };
                let stood = matches!(before.phase, Phase::Standing | Phase::SlidingFlat);
                let is_lifted = stood && !record.phase.is_level();
                if is_lifted && self.uplift_time.is_none() {
                    self.uplift_time = Some(saltation.at_departure(&self.end).t.slope.0);
                }
                self.end = saltation.crossed(&self.end)?;
            }
            self.push(motion, record);
            before = Some(record);
        }
        if let Some(last) = before {
            self.end = self.ended(motion, last);
        }
        if watch(motion.trajectory.end().t).is_break() {
            return Ok(ControlFlow::Break(()));
        }
        let turns = motion.turns.iter();
        self.turns = turns
            .map(|turn| turn_slope(motion, turn, |t| self.locate(motion, t)))
            .collect();
        Ok(ControlFlow::Continue(()))
    }

    /// Goes on to the end of the next step.
    fn push(&mut self, motion: &Motion, record: &StepRecord) {
        let contacts = &motion.contacts;
        let start = with_values(&all_or_none(&self.end), &record.start);
        self.starts.push(start);
        let end = self.variation.followed(contacts, record, &start, 1.0);
        let end = with_values(&end, &record.end);
        let end = without_rounding_across(contacts.parameters(), &end);
        // Where a body has just begun to rock, the derivatives at a fixed τ are those at a fixed time plus 1e8 times the
        // rates and more, so that errors of steps would be amplified as much. Elsewhere it is those at a fixed time that
        // may be large: no time passes with τ where a slip stops.
        // A step without length changes nothing: what comes next may depend on the event before it.
        let at_fixed_time = self.uplift_time.is_some() || ends_at_corner(contacts, record);
        self.end = if at_fixed_time && record.h != 0.0 {
            self.with_rates(motion, record, end).at_fixed_time()
        } else {
            end
        };
    }

    fn with_rates(
        &self,
        motion: &Motion,
        record: &StepRecord,
        u: Coordinates<Number>,
    ) -> CoordinatesAndRates<{ SHAKEN_PARAMETERS.len() }> {
        let rates = rates(&motion.contacts, record, &values(&u));
        CoordinatesAndRates { u, rates }
    }

    /// The coordinates at the end of the motion.
    fn ended(&self, motion: &Motion, last: &StepRecord) -> Coordinates<Number> {
        let at_event = |function: &dyn Fn(&Variation, &Coordinates<Number>) -> Number| {
            self.variation
                .at_event(&motion.contacts, last, &self.end, function)
        };
        let end = Coordinates::from_array(&last.end);
        match motion.status {
            Status::Finished => self.with_rates(motion, last, self.end).at_fixed_time(),
            Status::Toppled if last.phase == Phase::Lying => self.end,
            Status::Toppled => at_event(&|_, u| tilt_from(&end, u)),
            Status::FaceDown => at_event(&flat_function(&motion.contacts, &last.end)),
            Status::LiftedOff if !last.phase.is_level() => at_event(&|variation, u| {
                let phases = variation.phases(&motion.contacts, last.start[TIME]);
                phases.in_phase(last.phase).contact(u).normal
            }),
            _ => without(&self.end, [true; SHAKEN_PARAMETERS.len()]),
        }
    }

    fn locate(&self, motion: &Motion, t: f64) -> CoordinatesAndRates<{ SHAKEN_PARAMETERS.len() }> {
        let (index, x) = motion.trajectory.locate(t);
        let Some(record) = motion.trajectory.records().get(index) else {
            let rates = Coordinates {
                t: 1.0,
                ..Coordinates::zero()
            };
            return CoordinatesAndRates {
                u: self.start,
                rates,
            };
        };
        let start = &self.starts[index];
        let u = self.variation.followed(&motion.contacts, record, start, x);
        self.with_rates(motion, record, u)
    }

    /// Derivatives of tilt, tilt rate, yaw, yaw rate, spin and spin rate at a time (s) of the motion.
    pub fn at(&self, motion: &Motion, t: f64) -> [ShakenSlope; 6] {
        state_slopes(&self.locate(motion, t).at_fixed_time())
    }

    /// Derivatives of the angles of turn.
    pub fn turns(&self) -> &[ShakenSlope] {
        &self.turns
    }

    /// Derivatives of the time of the first uplift, s; `None` for a body that was never lifted.
    pub fn uplift_time(&self) -> Option<ShakenSlope> {
        self.uplift_time
    }

    /// Derivatives of the largest tilt, rad.
    pub fn max_tilt(&self, motion: &Motion) -> ShakenSlope {
        let (start, end) = (motion.trajectory.start(), motion.trajectory.end());
        let (_, t) = largest_tilt(&start, &motion.events, &end);
        // At a maximum or an impact, whose time varies.
        let [tilt, ..] = if t == start.t {
            state_slopes(&self.start)
        } else if t == end.t {
            state_slopes(&self.end)
        } else {
            state_slopes(&self.locate(motion, t).u)
        };
        tilt
    }

    /// Derivatives of the time of the end, s.
    pub fn end_time(&self) -> ShakenSlope {
        self.end.t.slope.0
    }

    /// Derivatives of the displacement of the footprint along x and y from the start to the end, m.
    pub fn residual_displacement(&self) -> [ShakenSlope; 2] {
        let k = &self.variation.k;
        let [from, to] = [&self.start, &self.end].map(|u| footprint(k, u));
        [(to[0] - from[0]).slope.0, (to[1] - from[1]).slope.0]
    }

    /// Derivatives of the change of ψ + θ from the start to the end, rad.
    pub fn residual_yaw(&self) -> ShakenSlope {
        let [from, to] = [&self.start, &self.end].map(|u| u.yaw + u.spin);
        (to - from).slope.0
    }
}

/// The coordinates at the start.
fn shaken_start(motion: &Motion, variation: &Variation) -> Coordinates<Number> {
    let at = motion.trajectory.start();
    let mut u: Coordinates<Number> = start(&at);
    let friction = &motion.contacts.contact_law().friction;
    if *friction == FrictionLaw::InPlace {
        u.s = -(u.w * u.sin / (Number::from(1.0) + u.cos));
    }
    if *friction == FrictionLaw::Frictionless && motion.contacts.moves() {
        let [along, across] = variation.k.rolling_velocity(&u);
        (u.slip_x, u.slip_y) = (-along, -across);
    }
    let stands = at.phase.is_level();
    let is_not_free = |name: &str| match name {
        "tilt" | "tilt_rate" | "yaw_rate" => stands,
        "spin_rate" => stands || *friction == FrictionLaw::InPlace,
        _ => false,
    };
    let u = without(&u, SHAKEN_PARAMETERS.map(is_not_free));
    with_values(&u, &at.into_array())
}
