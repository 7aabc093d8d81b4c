//! Detection of the events in a step, and their location.

use super::contacts::{Contacts, STANDING_TILT};
use super::event::{Event, EventKind};
use super::event_exclusion::{EventExclusion, are_clear};
use super::instant::{Instant, Phase};
use super::options::Options;
use super::step_record::{Polynomial, StepRecord};
use super::topple_tilt::ToppleTilt;
use super::trajectory::Trajectory;
use super::turns;
use crate::ending::{FACE_DOWN_TILT, STOPPED_TILT};
use crate::error_scale::ErrorScale;
use crate::law::{Dynamics, DynamicsExt};
use crate::solve::Step;
use crate::state::{COORDINATES, Coordinates, RIGID_COORDINATES, TIME};

/// The fractions of a step at which the event functions are sampled, in addition to the extrema of the tilt and
/// to the dips of the contact forces. So no topple tilt is missed, and the normal force or the friction cone
/// margin can be negative unnoticed only within a fraction of a quarter of a step.
const SAMPLES: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];

/// The fraction of the initial energy at which a motion counts as over.
const REST_ENERGY: f64 = 1e-10;

/// The fraction of the initial energy below which a motion counts as over once resistance has brought the base
/// down flat. The last impact dissipates this energy.
const REST_ENERGY_FLAT: f64 = 1e-2;

/// The value of [`Dynamics::consistency`] at which the Painlevé paradox counts as reached.
const PARADOX: f64 = 1e-6;

/// The terminal events of a phase.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum TerminalEvent {
    /// The goal is reached.
    Done,
    Topple,
    /// The tilt is zero.
    Flat,
    /// Resistance has stopped the contact point on the rim, and the tilt is nearly zero.
    StoppedRunning,
    /// The normal force is zero.
    LiftOff,
    /// Friction can no longer hold the rim.
    SlipOnset,
    /// The slip has stopped.
    SlipEnd,
    Land,
    Rest,
    Paradox,
    /// The acceleration of the table has a corner. The phase continues.
    Corner,
}

/// The goal of a simulation.
#[derive(Debug, Clone, Copy)]
pub(super) enum Goal {
    /// A time, s.
    Time(f64),
    /// A time (s), where only the events and the end are wanted, and not the trajectory.
    End(f64),
    /// The end of the first turn, or a time (s) if that comes first.
    Turn(f64),
    /// The end of a near-collision: the tilt rises, and |w| has fallen to this value, rad/s.
    Passed(f64),
}

impl Goal {
    /// Whether time passes. In the inner problem of the near-collision it stands still.
    pub(super) fn needs_time(self) -> bool {
        !matches!(self, Goal::Passed(_))
    }

    /// Whether the whole trajectory is needed, and not only its end.
    pub(super) fn needs_trajectory(self) -> bool {
        !matches!(self, Goal::Turn(_) | Goal::End(_))
    }
}

/// A sign change of the tilt rate that might still be a rounding error.
enum Crossing {
    /// Between two samples of a step.
    Within {
        record: Box<StepRecord>,
        dense: Box<Polynomial>,
        from: f64,
        to: f64,
    },
    /// In a jump: an impact, or the change of coordinates in a flight through upright.
    Jump(Instant),
}

/// A finished step with its dense output.
#[derive(Clone, Copy)]
struct StepPart<'p> {
    record: &'p StepRecord,
    dense: &'p Polynomial,
}

/// A fraction of a step, and the coordinates there.
#[derive(Clone, Copy)]
struct Sample {
    x: f64,
    u: Coordinates<f64>,
}

impl Sample {
    fn at(dense: &Polynomial, x: f64) -> Sample {
        let u = Coordinates::from_array(&dense.at(x));
        Sample { x, u }
    }
}

/// The fraction of the step at which the tilt rate changes sign between two samples.
fn tilt_extremum(dense: &Polynomial, from: &Sample, to: &Sample) -> Option<f64> {
    let reverses = (from.u.p < 0.0) != (to.u.p < 0.0);
    reverses.then(|| dense.root(from.x, to.x, |u| Coordinates::from_array(u).p))
}

/// The samples, with one more at each extremum of the tilt between two of them. A tilt reached there can be
/// left again before the next sample.
fn with_extrema(dense: &Polynomial, samples: &[Sample]) -> Vec<Sample> {
    let mut all = Vec::with_capacity(samples.len() + 1);
    for (i, sample) in samples.iter().enumerate() {
        let before = i.checked_sub(1).map(|before| &samples[before]);
        // The extremum at a release from rest is no event.
        let between = before
            .and_then(|before| tilt_extremum(dense, before, sample))
            .filter(|&x| x > 0.0);
        all.extend(between.map(|x| Sample::at(dense, x)));
        all.push(*sample);
    }
    all
}

/// How often samples are added where the parabola through three of them has a minimum near zero.
const DIP_ROUNDS: usize = 2;

/// The place of the minimum of a parabola through three samples (place, positive value) if it lies between the
/// outer ones and below a quarter of the middle value.
fn dip([(x, a), (y, b), (z, c)]: [(f64, f64); 3]) -> Option<f64> {
    let (before, after) = ((b - a) / (y - x), (c - b) / (z - y));
    let curvature = (after - before) / (z - x);
    let slope = before + (y - x) * curvature;
    let place = y - slope / (2.0 * curvature);
    let is_low = slope * slope > 3.0 * curvature * b;
    let is_between = curvature > 0.0 && x < place && place < z;
    (a.min(b).min(c) > 0.0 && is_between && is_low && place != y).then_some(place)
}

/// A fraction of a step from `from` on at which the gap is positive, for a flight that begins at `from` and
/// ends before `to`. The event function of landing has a sign change between that fraction and `to`.
fn fraction_with_gap(dense: &Polynomial, from: f64, to: f64) -> f64 {
    let gap = |x: f64| Coordinates::from_array(&dense.at(x)).gap;
    let halves = (1..40).scan(to - from, |width, _| {
        *width *= 0.5;
        Some(from + *width)
    });
    if gap(from) > 0.0 {
        return from;
    }
    halves.into_iter().find(|&x| gap(x) > 0.0).unwrap_or(from)
}

/// Detects and locates the events in each accepted step.
pub(super) struct EventDetector<'a> {
    contacts: &'a Contacts,
    error_scale: ErrorScale<f64>,
    goal: Goal,
    topple: Option<ToppleTilt<f64>>,
    start_energy: f64,
    /// [`Options::significant_tilt_rate`].
    significant: f64,
    /// The last significant sign; at first [that of the release](turns::direction_at_release).
    direction: f64,
    started_on_first_face: bool,
    crossing: Option<Crossing>,
    events: Vec<Event>,
    /// The largest tilt at a maximum, rad.
    #[cfg(feature = "ground")]
    largest_maximum: f64,
    /// The time at which steps have to end, s.
    corner: f64,
}

impl<'a> EventDetector<'a> {
    pub(super) fn new(
        contacts: &'a Contacts,
        options: &Options,
        goal: Goal,
        start: &Instant,
    ) -> Self {
        let energy = energy_above_rest(contacts.dynamics(start.phase), start);
        EventDetector {
            contacts,
            error_scale: ErrorScale::new(contacts.parameters()),
            goal,
            topple: options.topple_tilt.map(ToppleTilt::at),
            start_energy: energy,
            significant: options.significant_tilt_rate(),
            started_on_first_face: start.cos > 0.0,
            direction: turns::direction_at_release(start),
            crossing: None,
            events: Vec::new(),
            #[cfg(feature = "ground")]
            largest_maximum: 0.0,
            corner: f64::INFINITY,
        }
    }

    /// Forgets in which direction the tilt changes, for a body that stands flat.
    pub(super) fn forget_direction(&mut self) {
        self.direction = 0.0;
        self.crossing = None;
    }

    /// Steps from now on are cut at a corner of the table's acceleration, at this time (s).
    pub(super) fn cut_steps_at(&mut self, corner: f64) {
        self.corner = corner;
    }

    /// The last significant sign of the tilt rate, or 0.
    #[cfg(feature = "ground")]
    pub(super) fn direction(&self) -> f64 {
        self.direction
    }

    /// The largest tilt at a maximum so far, rad.
    #[cfg(feature = "ground")]
    pub(super) fn largest_maximum(&self) -> f64 {
        self.largest_maximum
    }

    /// Takes account of an extremum of the tilt, after which the tilt rate has another significant sign. Without an instant
    /// it is not added to the events.
    #[cfg(feature = "ground")]
    pub(super) fn reverse(&mut self, direction: f64, at: Option<Instant>) {
        self.crossing = None;
        self.direction = direction;
        if let Some(at) = at {
            self.add(extremum_kind(direction), at);
        }
    }

    /// The goal of the simulation.
    #[cfg(feature = "ground")]
    pub(super) fn goal(&self) -> Goal {
        self.goal
    }

    /// The events in order of time.
    pub(super) fn into_events(self) -> Vec<Event> {
        self.events
    }

    /// Inserts an event in order of time, since an extremum of the tilt is only confirmed some time later. A motion that
    /// is not finite fails, and has no further event.
    pub(super) fn add(&mut self, kind: EventKind, at: Instant) {
        if !at.u.is_finite() {
            return;
        }
        #[cfg(feature = "ground")]
        if kind == EventKind::TiltMax {
            self.largest_maximum = self.largest_maximum.max(at.tilt());
        }
        let earlier = |event: &Event| event.at.t.total_cmp(&at.t).is_le();
        let index = self.events.partition_point(earlier);
        self.events.insert(index, Event { kind, at });
    }

    /// Takes account of a jump of the motion from `before`, which can change the sign of the tilt rate.
    pub(super) fn process_jump(&mut self, before: &Coordinates<f64>, at: Instant) {
        if (before.p < 0.0) != (at.p < 0.0) {
            self.crossing = Some(Crossing::Jump(at));
        }
        self.update_direction(&at);
    }

    /// Whether the remaining energy of a body whose contact point resistance has stopped is negligible.
    pub(super) fn has_spent_its_energy(&self, at: &Instant) -> bool {
        let energy = energy_above_rest(self.contacts.dynamics(at.phase), at);
        energy < REST_ENERGY_FLAT * self.start_energy
    }

    /// The possible terminal events of a phase, with the signs of their event functions before the event.
    fn terminal_events(&self, phase: Phase) -> impl Iterator<Item = (TerminalEvent, f64)> + use<> {
        let dry = self.contacts.dry().is_some();
        let ideal = !self.contacts.can_fly();
        let resists = self.contacts.contact_law().resists();
        let loses = !ideal || resists;
        let on_table = phase != Phase::Flying;
        let in_time = !matches!(self.goal, Goal::Passed(_));
        [
            (TerminalEvent::Done, -1.0, true),
            (TerminalEvent::Topple, 1.0, self.topple.is_some()),
            (TerminalEvent::LiftOff, 1.0, on_table),
            (TerminalEvent::Flat, 1.0, in_time),
            (
                TerminalEvent::StoppedRunning,
                1.0,
                in_time && on_table && resists,
            ),
            (
                TerminalEvent::SlipOnset,
                1.0,
                dry && phase == Phase::Rolling,
            ),
            (TerminalEvent::SlipEnd, 1.0, dry && phase == Phase::Sliding),
            (
                TerminalEvent::Paradox,
                1.0,
                !ideal && phase == Phase::Sliding,
            ),
            (TerminalEvent::Land, 1.0, !on_table),
            (
                TerminalEvent::Rest,
                1.0,
                (loses || self.contacts.moves()) && in_time && on_table,
            ),
            (TerminalEvent::Corner, -1.0, self.corner.is_finite()),
        ]
        .into_iter()
        .filter(|&(.., possible)| possible)
        .map(|(event, before, _)| (event, before))
    }

    /// The terminal event that has already occurred at the start, if there is one.
    pub(super) fn event_at_start(&self, start: &Instant) -> Option<TerminalEvent> {
        self.terminal_events(start.phase)
            .filter(|(event, _)| {
                !matches!(
                    event,
                    TerminalEvent::SlipOnset | TerminalEvent::SlipEnd | TerminalEvent::Land
                )
            })
            .find(|&(event, before)| before * self.event_function(event, start.phase, start) < 0.0)
            .map(|(event, _)| event)
    }

    /// Whether the exclusion tests show that a step contains no event, as most steps do.
    #[inline]
    pub(super) fn is_uneventful<const N: usize>(&self, phase: Phase, step: &Step<f64, N>) -> bool {
        if self.direction == 0.0 {
            return false;
        }
        let bounds = EventExclusion::new(step);
        let side = bounds.end().cos.signum();
        bounds.stays_above(0.0, |u| self.direction * u.p)
            && bounds.stays_above(0.0, |u| side * u.cos)
            && match self.goal {
                Goal::Time(end) | Goal::End(end) | Goal::Turn(end)
                    if N == RIGID_COORDINATES && !self.contacts.can_fly() =>
                {
                    self.excludes_ideal_endings(&bounds, end)
                }
                _ => self.excludes_endings(phase, &bounds),
            }
    }

    /// Whether the step contains none of the few terminal events of an ideal law.
    #[inline(always)]
    fn excludes_ideal_endings(&self, bounds: &EventExclusion, end: f64) -> bool {
        let upright = |topple: ToppleTilt<f64>| bounds.stays_above(0.0, |u| topple.below(u));
        let flat = self.contacts.sine_at_gap().max(FACE_DOWN_TILT);
        bounds.end().t < end
            && bounds.stays_above(flat, |u| u.sin)
            && self.topple.is_none_or(upright)
            && bounds.keeps_contact(self.contacts.parameters())
    }

    /// Whether the step contains no terminal event.
    fn excludes_endings(&self, phase: Phase, bounds: &EventExclusion) -> bool {
        let three_points = bounds.three_points();
        self.terminal_events(phase).all(|(event, before)| {
            are_clear(
                [0, 1, 2].map(|i| before * self.event_function(event, phase, &three_points[i])),
            )
        })
    }

    /// Processes an accepted step: locates its events and adds the step to the trajectory, shortened to the end
    /// of the phase if that lies in the step.
    pub(super) fn process(
        &mut self,
        record: StepRecord,
        dense: &Polynomial,
        trajectory: &mut Trajectory,
    ) -> Option<TerminalEvent> {
        let phase = record.phase;
        let part = StepPart {
            record: &record,
            dense,
        };
        let samples = SAMPLES.map(|x| Sample::at(dense, x)).to_vec();
        let with_tilt_extrema = with_extrema(dense, &samples);
        let with_dips = self.with_dips(phase, dense, &with_tilt_extrema);
        let Some((event, x)) = self.first_terminal_event(phase, dense, &with_dips) else {
            self.detect_extrema(part, &samples);
            self.detect_edge(part, &with_tilt_extrema);
            trajectory.push(record);
            return self.has_turned().then_some(TerminalEvent::Done);
        };
        let until_end = |mut samples: Vec<Sample>| {
            samples.retain(|sample| sample.x < x);
            samples.push(Sample::at(dense, x));
            samples
        };
        let mut last = self.refine(part, x, |u| self.event_function(event, phase, u));
        if let (
            TerminalEvent::Done,
            Goal::Time(duration) | Goal::End(duration) | Goal::Turn(duration),
        ) = (event, self.goal)
        {
            // The motion must end exactly at the given time, without a rounding error.
            last.end[TIME] = duration;
        }
        if event == TerminalEvent::Corner {
            last.end[TIME] = self.corner;
        }
        self.detect_extrema(part, &until_end(samples));
        self.detect_edge(part, &until_end(with_tilt_extrema));
        // Rounding must not put an event after the end.
        for event in &mut self.events {
            if event.at.t > last.end[TIME] {
                event.at.u = Coordinates::from_array(&last.end);
            }
        }
        trajectory.push(last);
        Some(event)
    }

    /// Whether the goal is one turn and that turn is complete.
    fn has_turned(&self) -> bool {
        matches!(self.goal, Goal::Turn(_))
            && turns::end_of_first_turn(self.started_on_first_face, &self.events).is_some()
    }

    /// The event function between `from` and the next sample.
    fn function_from(
        &self,
        from: &Sample,
        event: TerminalEvent,
        phase: Phase,
        u: &Coordinates<f64>,
    ) -> f64 {
        // A tilt falls as far as its minimum, where rounding decides on the sign of its rate.
        if event == TerminalEvent::Flat
            && self.contacts.has_gap(phase)
            && self.contacts.is_falling(&from.u)
        {
            return u.sin - self.contacts.sine_at_gap();
        }
        self.event_function(event, phase, u)
    }

    /// The event function: it changes sign at the event.
    fn event_function(&self, event: TerminalEvent, phase: Phase, u: &Coordinates<f64>) -> f64 {
        let dynamics = self.contacts.dynamics(phase);
        match event {
            TerminalEvent::Done => match self.goal {
                Goal::Time(duration) | Goal::End(duration) | Goal::Turn(duration) => u.t - duration,
                Goal::Passed(w) if u.p > 0.0 => w - u.w.abs(),
                Goal::Passed(_) => -1.0,
            },
            TerminalEvent::Topple => self.topple.map_or(1.0, |topple| topple.below(u)),
            TerminalEvent::LiftOff if phase == Phase::Sliding => {
                self.contacts.scaled_normal_force(u)
            }
            TerminalEvent::LiftOff => dynamics.contact(u).normal,
            TerminalEvent::Flat => self.contacts.height_over_flat(phase, u),
            TerminalEvent::StoppedRunning => self.excess_over_stopped(phase, u),
            TerminalEvent::SlipOnset => self.contacts.friction_cone_margin(u),
            TerminalEvent::SlipEnd => u.slip_speed() - self.contacts.stopped_speed(u),
            TerminalEvent::Paradox => dynamics.consistency(u) - PARADOX,
            TerminalEvent::Land => u.gap,
            TerminalEvent::Corner => u.t - self.corner,
            TerminalEvent::Rest if self.contacts.moves() => self.contacts.excess_over_standing(u),
            TerminalEvent::Rest => energy_above_rest(dynamics, u) - REST_ENERGY * self.start_energy,
        }
    }

    /// The event function of [`TerminalEvent::StoppedRunning`].
    fn excess_over_stopped(&self, phase: Phase, u: &Coordinates<f64>) -> f64 {
        if !self.contacts.moves() {
            let is_over = u.sin <= STOPPED_TILT && self.contacts.has_stopped_running(phase, u);
            return if is_over || u.sin > STOPPED_TILT {
                u.sin - STOPPED_TILT
            } else {
                u.sin
            };
        }
        // As a body begins to rock, its tilt rate can be negative by rounding.
        if !self.contacts.is_falling(u) {
            return 1.0;
        }
        let is_flat = u.sin <= 0.0;
        if is_flat || u.sin > STANDING_TILT || self.contacts.has_stopped_running(phase, u) {
            u.sin - STANDING_TILT
        } else {
            1.0
        }
    }

    /// The samples, with more where the normal force or the friction cone margin may be negative between them.
    fn with_dips(&self, phase: Phase, dense: &Polynomial, samples: &[Sample]) -> Vec<Sample> {
        let mut all = samples.to_vec();
        for _ in 0..DIP_ROUNDS {
            let mut places: Vec<f64> = self
                .terminal_events(phase)
                .filter(|(event, _)| {
                    matches!(event, TerminalEvent::LiftOff | TerminalEvent::SlipOnset)
                })
                .flat_map(|(event, before)| {
                    let value = |sample: &Sample| {
                        (
                            sample.x,
                            before * self.event_function(event, phase, &sample.u),
                        )
                    };
                    let values: Vec<_> = all.iter().map(value).collect();
                    let dips = values
                        .windows(3)
                        .filter_map(|three| dip([three[0], three[1], three[2]]));
                    dips.collect::<Vec<_>>()
                })
                .collect();
            if places.is_empty() {
                break;
            }
            places.retain(|&place| all.iter().all(|sample| sample.x != place));
            all.extend(places.into_iter().map(|x| Sample::at(dense, x)));
            all.sort_by(|a, b| a.x.total_cmp(&b.x));
        }
        all
    }

    /// The first terminal event inside a step and the fraction of the step at which it occurs.
    fn first_terminal_event(
        &self,
        phase: Phase,
        dense: &Polynomial,
        samples: &[Sample],
    ) -> Option<(TerminalEvent, f64)> {
        let ends =
            |sample: &[Sample]| self.terminal_event_between(phase, dense, &sample[0], &sample[1]);
        samples.windows(2).find_map(ends)
    }

    fn terminal_event_between(
        &self,
        phase: Phase,
        dense: &Polynomial,
        from: &Sample,
        to: &Sample,
    ) -> Option<(TerminalEvent, f64)> {
        self.terminal_events(phase)
            .filter(|&(event, before)| {
                before * self.function_from(from, event, phase, &to.u) <= 0.0
            })
            // A slip that has just begun is slow, but it does not end.
            .filter(|&(event, _)| {
                event != TerminalEvent::SlipEnd || to.u.slip_speed() < from.u.slip_speed()
            })
            .map(|(event, _)| {
                let level = |u: &[f64; COORDINATES]| {
                    self.function_from(from, event, phase, &Coordinates::from_array(u))
                };
                let from = match event {
                    TerminalEvent::Land => fraction_with_gap(dense, from.x, to.x),
                    _ => from.x,
                };
                (event, dense.root(from, to.x, level))
            })
            .min_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// The sign of the tilt rate, or 0 if it is not significant.
    fn sign_of_tilt_rate(&self, u: &Coordinates<f64>) -> f64 {
        self.error_scale.sign_of_tilt_rate(u, self.significant)
    }

    fn detect_extrema(&mut self, part: StepPart<'_>, samples: &[Sample]) {
        for sample in samples.windows(2) {
            let (before, after) = (&sample[0], &sample[1]);
            if (before.u.p < 0.0) != (after.u.p < 0.0) {
                self.crossing = Some(Crossing::Within {
                    record: Box::new(part.record.clone()),
                    dense: Box::new(part.dense.clone()),
                    from: before.x,
                    to: after.x,
                });
            }
            self.update_direction(&after.u);
        }
    }

    /// Adds an extremum of the tilt once the opposite sign of the tilt rate is significant.
    fn update_direction(&mut self, u: &Coordinates<f64>) {
        let direction = self.sign_of_tilt_rate(u);
        if direction == 0.0 || direction == self.direction {
            return;
        }
        // The first significant sign after a release from rest is no reversal.
        if let Some(crossing) = self.crossing.take().filter(|_| self.direction != 0.0) {
            let at = self.instant_of(&crossing);
            self.add(extremum_kind(direction), at);
        }
        self.direction = direction;
    }

    fn instant_of(&self, crossing: &Crossing) -> Instant {
        match crossing {
            Crossing::Jump(at) => *at,
            Crossing::Within {
                record,
                dense,
                from,
                to,
            } => {
                let p = |u: &[f64; COORDINATES]| Coordinates::from_array(u).p;
                let x = dense.root(*from, *to, p);
                self.instant(StepPart { record, dense }, x, |u| u.p)
            }
        }
    }

    fn detect_edge(&mut self, part: StepPart<'_>, samples: &[Sample]) {
        // A body that topples at π/2 does not pass over its edge; one with a larger topple tilt passes it first.
        if self.topple.is_some_and(|topple| topple.is_upright()) {
            return;
        }
        for sample in samples.windows(2) {
            let (before, after) = (&sample[0], &sample[1]);
            if (before.u.cos > 0.0) != (after.u.cos > 0.0) {
                let cos = |u: &[f64; COORDINATES]| Coordinates::from_array(u).cos;
                let x = part.dense.root(before.x, after.x, cos);
                let at = self.instant(part, x, |u| u.cos);
                self.add(EventKind::OnEdge, at);
            }
        }
    }

    fn instant(
        &self,
        part: StepPart<'_>,
        x: f64,
        level: impl Fn(&Coordinates<f64>) -> f64,
    ) -> Instant {
        Instant {
            phase: part.record.phase,
            u: Coordinates::from_array(&self.refine(part, x, level).end),
        }
    }

    /// The step shortened to the root of `level` near x. The dense output is one order less accurate than the
    /// steps, so x is corrected by the value of `level` at the end of a recomputed step. Where `level` changes sign
    /// because the acceleration of the table jumps at the end of the step, it has no slope, and the step stays whole.
    fn refine(
        &self,
        part: StepPart<'_>,
        x: f64,
        level: impl Fn(&Coordinates<f64>) -> f64,
    ) -> StepRecord {
        const INCREMENT: f64 = 1e-3;
        if self.is_at_corner(part, x) {
            return part.record.clone();
        }
        let StepPart { record, dense } = part;
        let level = |u: &[f64; COORDINATES]| level(&Coordinates::from_array(u));
        let shortened = record.cut(self.contacts, x);
        if record.is_polynomial() {
            return shortened;
        }
        let slope =
            (level(&dense.at(x + INCREMENT)) - level(&dense.at(x - INCREMENT))) / (2.0 * INCREMENT);
        let correction = level(&shortened.end) / slope;
        // At a double root the slope vanishes and gives no correction.
        if correction.abs() < 0.01 {
            record.cut(self.contacts, x - correction)
        } else {
            shortened
        }
    }

    /// Whether the fraction x of a step is its end except for rounding, and there the acceleration of the table has a
    /// corner.
    fn is_at_corner(&self, part: StepPart<'_>, x: f64) -> bool {
        const ROUNDING: f64 = 4.0 * f64::EPSILON;
        let StepPart { record, dense } = part;
        let (start, end) = (record.start[TIME], record.end[TIME]);
        self.contacts.moves()
            && self.contacts.corner_after(start) == end
            && end - dense.at(x)[TIME] <= ROUNDING * end
    }
}

/// The energy above that of a body lying flat. The absolute value counts, because a body that leans far can
/// have its centre of mass lower than a flat one without being at rest.
fn energy_above_rest(dynamics: &dyn Dynamics<f64>, u: &Coordinates<f64>) -> f64 {
    let energy = dynamics.energy(u);
    energy.kinetic + energy.potential.abs()
}

fn extremum_kind(direction: f64) -> EventKind {
    if direction > 0.0 {
        EventKind::TiltMin
    } else {
        EventKind::TiltMax
    }
}
