//! What happens on the way: extremes of the tilt, the upright edge, and changes of the contact.

use super::contacts::{Contacts, Phase};
use super::step_bounds::{StepBounds, are_clear};
use super::step_record::{Polynomial, StepRecord};
use super::track::Instant;
use super::{FACE_DOWN_TILT, Options, STOPPED_TILT, Track, turns};
use crate::error_scale::ErrorScale;
use crate::law::Dynamics;
use crate::solve::Step;
use crate::state::{COORDINATES, Coordinates, RIGID_COORDINATES, TIME};

/// What happened.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EventKind {
    /// The tilt is smallest: the near-collision.
    TiltMin,
    /// The tilt is largest.
    TiltMax,
    /// The base is vertical, tilt π/2: a disk stands on its edge on its way from one face to the other.
    OnEdge,
    /// Friction no longer holds the rim: it begins to slip.
    Slip,
    /// The slip has stopped and friction holds the rim: it rolls.
    Stick,
    /// The normal force is zero and about to turn negative: the rim leaves the table.
    LiftOff,
    /// The rim strikes the table.
    Land,
    /// The topple tilt is reached; the motion ends.
    Topple,
    /// The base lands flat; the motion ends.
    FaceDown,
    /// The energy is spent: all but the last 1e-10 of it or, where the base has come down flat under
    /// a resistance, all but the last hundredth. The motion ends.
    Rest,
    /// Rigid-body mechanics with this friction has no one answer; the motion ends.
    Painleve,
}

impl EventKind {
    /// The name that the user reads.
    pub fn name(self) -> &'static str {
        match self {
            EventKind::TiltMin => "tilt_min",
            EventKind::TiltMax => "tilt_max",
            EventKind::OnEdge => "on_edge",
            EventKind::Slip => "slip",
            EventKind::Stick => "stick",
            EventKind::LiftOff => "lift_off",
            EventKind::Land => "land",
            EventKind::Topple => "topple",
            EventKind::FaceDown => "face_down",
            EventKind::Rest => "rest",
            EventKind::Painleve => "painleve",
        }
    }
}

/// Something that happened, and the coordinates at that moment.
#[derive(Debug, Clone, Copy)]
pub struct Event {
    /// What.
    pub kind: EventKind,
    /// Where and when.
    pub at: Instant,
}

/// Looked at inside each step, and where the tilt is extreme: a topple tilt is not stepped over, and
/// the normal force can dip below zero unseen only within a quarter of a step.
const SAMPLES: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];

/// The part of the energy at the start at which a motion counts as over.
const REST_ENERGY: f64 = 1e-10;

/// The same where a resistance has worn the motion down until the base lies flat: what is left is
/// spent in the last slap.
const REST_ENERGY_FLAT: f64 = 1e-2;

/// Painlevé's paradox counts as reached where so little is left of what determines the normal force.
const PARADOX: f64 = 1e-6;

/// What a phase ends with.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Switch {
    /// What was to be followed is followed.
    Done,
    Topple,
    /// The tilt is zero.
    Flat,
    /// Resistance has stopped the contact point's running round the rim, and the tilt is all but zero.
    StoppedRunning,
    /// The normal force is zero.
    LiftOff,
    /// Friction can no longer hold the rim.
    Break,
    /// Slip has stopped.
    Stop,
    Land,
    Rest,
    Paradox,
}

/// When a motion has been followed far enough.
#[derive(Debug, Clone, Copy)]
pub(super) enum Goal {
    /// At a time, s.
    Time(f64),
    /// After one turn; at a time (s) at the latest.
    Turn(f64),
    /// When it rises again and |w| has fallen to this, rad/s.
    Passed(f64),
}

impl Goal {
    /// Whether more is asked for than where the motion ends.
    pub(super) fn wants_the_way(self) -> bool {
        !matches!(self, Goal::Turn(_))
    }
}

/// A change of sign of the tilt rate that is not yet known to be more than rounding.
enum Crossing {
    /// Between two looks into a step.
    Within {
        record: Box<StepRecord>,
        dense: Box<Polynomial>,
        from: f64,
        to: f64,
    },
    /// At once, in a landing or a flight through upright.
    Jump(Instant),
}

/// A finished step, and the polynomial that it is.
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

/// Where the tilt rate changes sign between two looks.
fn extreme(dense: &Polynomial, from: &Sample, to: &Sample) -> Option<f64> {
    let reverses = (from.u.p < 0.0) != (to.u.p < 0.0);
    reverses.then(|| dense.root(from.x, to.x, |u| Coordinates::from_array(u).p))
}

/// The looks, and one more wherever the tilt is extreme between two of them: what is reached there may be
/// left again before the next look.
fn with_extremes(dense: &Polynomial, samples: &[Sample]) -> Vec<Sample> {
    let mut all = Vec::with_capacity(samples.len() + 1);
    for (i, sample) in samples.iter().enumerate() {
        let before = i.checked_sub(1).map(|before| &samples[before]);
        // A release from rest has its extreme where it begins: nothing has happened yet.
        let between = before
            .and_then(|before| extreme(dense, before, sample))
            .filter(|&x| x > 0.0);
        all.extend(between.map(|x| Sample::at(dense, x)));
        all.push(*sample);
    }
    all
}

/// A fraction of a step not before `from`, from which a flight that begins there and is over by `to`
/// can be seen to land.
fn in_the_air(dense: &Polynomial, from: f64, to: f64) -> f64 {
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

/// Watches the steps go by.
pub(super) struct Watch<'a> {
    contacts: &'a Contacts,
    error_scale: ErrorScale<f64>,
    goal: Goal,
    topple: Option<(f64, f64)>,
    start_energy: f64,
    /// A tilt rate counts as having a sign when it is larger than this part of its scale: a steady
    /// wobble has none.
    significant: f64,
    /// The last such sign, and at first [that of the release](turns::direction_at_release).
    direction: f64,
    started_on_first_face: bool,
    crossing: Option<Crossing>,
    events: Vec<Event>,
}

impl<'a> Watch<'a> {
    pub(super) fn new(
        contacts: &'a Contacts,
        options: &Options,
        goal: Goal,
        start: &Instant,
    ) -> Self {
        let energy = energy_above_rest(contacts.dynamics(start.phase), start);
        Watch {
            contacts,
            error_scale: ErrorScale::new(contacts.parameters()),
            goal,
            topple: options.topple_tilt.map(libm::sincos),
            start_energy: energy,
            significant: 10.0 * options.rtol,
            started_on_first_face: start.cos > 0.0,
            direction: turns::direction_at_release(start),
            crossing: None,
            events: Vec::new(),
        }
    }

    /// What happened, in order of time.
    pub(super) fn into_events(self) -> Vec<Event> {
        self.events
    }

    /// Notes an event in its place: that a tilt was extreme is known only some time after.
    pub(super) fn note(&mut self, kind: EventKind, at: Instant) {
        let earlier = |event: &Event| event.at.t.total_cmp(&at.t).is_le();
        let place = self.events.partition_point(earlier);
        self.events.insert(place, Event { kind, at });
    }

    /// The motion has changed at once from `before`, and with it perhaps the sign of the tilt rate.
    pub(super) fn note_jump(&mut self, before: &Coordinates<f64>, at: Instant) {
        if (before.p < 0.0) != (at.p < 0.0) {
            self.crossing = Some(Crossing::Jump(at));
        }
        self.follow_tilt_rate(&at);
    }

    /// Whether a body whose contact point resistance has stopped has no energy to speak of any more.
    pub(super) fn has_spent_its_energy(&self, at: &Instant) -> bool {
        let energy = energy_above_rest(self.contacts.dynamics(at.phase), at);
        energy < REST_ENERGY_FLAT * self.start_energy
    }

    /// What a phase can end with, and the sign that its level has before.
    fn switches(&self, phase: Phase) -> impl Iterator<Item = (Switch, f64)> + use<> {
        let dry = self.contacts.dry().is_some();
        let ideal = !self.contacts.can_fly();
        let resists = self.contacts.contact_law().resists();
        let loses = !ideal || resists;
        let on_table = phase != Phase::Flying;
        let in_time = !matches!(self.goal, Goal::Passed(_));
        [
            (Switch::Done, -1.0, true),
            (Switch::Topple, -1.0, self.topple.is_some()),
            (Switch::LiftOff, 1.0, on_table),
            (Switch::Flat, 1.0, in_time),
            (Switch::StoppedRunning, 1.0, in_time && on_table && resists),
            (Switch::Break, 1.0, dry && phase == Phase::Rolling),
            (Switch::Stop, 1.0, dry && phase == Phase::Sliding),
            (Switch::Paradox, 1.0, !ideal && phase == Phase::Sliding),
            (Switch::Land, 1.0, !on_table),
            (Switch::Rest, 1.0, loses && in_time && on_table),
        ]
        .into_iter()
        .filter(|&(.., possible)| possible)
        .map(|(switch, before, _)| (switch, before))
    }

    /// Whether there is no motion to follow: the start cannot be or must not be left.
    pub(super) fn at_start(&self, start: &Instant) -> Option<Switch> {
        self.switches(start.phase)
            .filter(|(switch, _)| !matches!(switch, Switch::Break | Switch::Stop | Switch::Land))
            .find(|&(switch, before)| before * self.level(switch, start.phase, start) < 0.0)
            .map(|(switch, _)| switch)
    }

    /// Whether it is clear at a glance that nothing happens in a step, as in most.
    #[inline]
    pub(super) fn is_uneventful<const N: usize>(&self, phase: Phase, step: &Step<f64, N>) -> bool {
        if self.direction == 0.0 {
            return false;
        }
        let bounds = StepBounds::new(step);
        let side = bounds.end().cos.signum();
        bounds.stays_above(0.0, |u| self.direction * u.p)
            && bounds.stays_above(0.0, |u| side * u.cos)
            && match self.goal {
                Goal::Time(end) | Goal::Turn(end)
                    if N == RIGID_COORDINATES && !self.contacts.can_fly() =>
                {
                    self.stays_on_an_ideal_table(&bounds, end)
                }
                _ => self.ends_by_nothing(phase, &bounds),
            }
    }

    /// Whether it does not come near any of the few endings under an ideal law.
    #[inline(always)]
    fn stays_on_an_ideal_table(&self, bounds: &StepBounds, end: f64) -> bool {
        let upright = |(sin, cos)| bounds.stays_above(0.0, |u| u.cos * sin - u.sin * cos);
        bounds.end().t < end
            && bounds.stays_above(FACE_DOWN_TILT, |u| u.sin)
            && self.topple.is_none_or(upright)
            && bounds.keeps_contact(self.contacts.parameters())
    }

    /// Whether it does not come near any ending.
    fn ends_by_nothing(&self, phase: Phase, bounds: &StepBounds) -> bool {
        let three_points = bounds.three_points();
        self.switches(phase).all(|(switch, before)| {
            are_clear([0, 1, 2].map(|i| before * self.level(switch, phase, &three_points[i])))
        })
    }

    /// Takes in an accepted step: notes what happened and adds it to the track, cut short where the
    /// phase ends.
    pub(super) fn pass(
        &mut self,
        record: StepRecord,
        dense: &Polynomial,
        track: &mut Track,
    ) -> Option<Switch> {
        let phase = record.phase;
        let part = StepPart {
            record: &record,
            dense,
        };
        let samples = SAMPLES.map(|x| Sample::at(dense, x)).to_vec();
        let closer = with_extremes(dense, &samples);
        let Some((switch, x)) = self.first_ending(phase, dense, &closer) else {
            self.note_extremes(part, &samples);
            self.note_on_edge(part, &closer);
            track.push(record);
            return self.has_turned().then_some(Switch::Done);
        };
        let up_to_the_end = |mut samples: Vec<Sample>| {
            samples.retain(|sample| sample.x < x);
            samples.push(Sample::at(dense, x));
            samples
        };
        let mut last = self.refine(part, x, |u| self.level(switch, phase, u));
        if let (Switch::Done, Goal::Time(duration) | Goal::Turn(duration)) = (switch, self.goal) {
            // Neither a rounding error short of what was asked for nor one beyond it.
            last.end[TIME] = duration;
        }
        self.note_extremes(part, &up_to_the_end(samples));
        self.note_on_edge(part, &up_to_the_end(closer));
        // Each time is right but for rounding, and nothing happens after the end.
        for event in &mut self.events {
            if event.at.t > last.end[TIME] {
                event.at.u = Coordinates::from_array(&last.end);
            }
        }
        track.push(last);
        Some(switch)
    }

    /// Whether one turn was asked for and is over.
    fn has_turned(&self) -> bool {
        matches!(self.goal, Goal::Turn(_))
            && turns::end_of_first_turn(self.started_on_first_face, &self.events).is_some()
    }

    /// A function of the coordinates that changes sign where the phase ends.
    fn level(&self, switch: Switch, phase: Phase, u: &Coordinates<f64>) -> f64 {
        let law = self.contacts.dynamics(phase);
        match switch {
            Switch::Done => match self.goal {
                Goal::Time(duration) | Goal::Turn(duration) => u.t - duration,
                Goal::Passed(w) if u.p > 0.0 => w - u.w.abs(),
                Goal::Passed(_) => -1.0,
            },
            // sin(φ − φ_topple) has the sign of φ − φ_topple within (0, π).
            Switch::Topple => self
                .topple
                .map_or(-1.0, |(sin, cos)| u.sin * cos - u.cos * sin),
            Switch::LiftOff if phase == Phase::Sliding => self.contacts.scaled_normal_force(u),
            Switch::LiftOff => law.contact(u).normal,
            Switch::Flat => u.sin - FACE_DOWN_TILT,
            Switch::StoppedRunning => self.over_stopped(phase, u),
            Switch::Break => self.contacts.friction_cone_margin(u),
            Switch::Stop => u.slip_speed() - self.contacts.stopped_speed(u),
            Switch::Paradox => law.consistency(u) - PARADOX,
            Switch::Land => u.gap,
            Switch::Rest => energy_above_rest(law, u) - REST_ENERGY * self.start_energy,
        }
    }

    /// Positive until resistance has stopped the contact point's running and the rim is all but flat.
    fn over_stopped(&self, phase: Phase, u: &Coordinates<f64>) -> f64 {
        if u.sin > STOPPED_TILT || self.contacts.has_stopped_running(phase, u) {
            u.sin - STOPPED_TILT
        } else {
            u.sin
        }
    }

    /// The first ending inside a step and the fraction of the step where it is.
    fn first_ending(
        &self,
        phase: Phase,
        dense: &Polynomial,
        samples: &[Sample],
    ) -> Option<(Switch, f64)> {
        let ends = |sample: &[Sample]| self.ending_between(phase, dense, &sample[0], &sample[1]);
        samples.windows(2).find_map(ends)
    }

    fn ending_between(
        &self,
        phase: Phase,
        dense: &Polynomial,
        from: &Sample,
        to: &Sample,
    ) -> Option<(Switch, f64)> {
        self.switches(phase)
            .filter(|&(switch, before)| before * self.level(switch, phase, &to.u) <= 0.0)
            // A slip that has just begun is slow, too.
            .filter(|&(switch, _)| {
                switch != Switch::Stop || to.u.slip_speed() < from.u.slip_speed()
            })
            .map(|(switch, _)| {
                let level =
                    |u: &[f64; COORDINATES]| self.level(switch, phase, &Coordinates::from_array(u));
                let from = match switch {
                    Switch::Land => in_the_air(dense, from.x, to.x),
                    _ => from.x,
                };
                (switch, dense.root(from, to.x, level))
            })
            .min_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// −1 or 1 when the tilt clearly falls or rises, 0 when it cannot be told.
    fn sign_of_tilt_rate(&self, u: &Coordinates<f64>) -> f64 {
        self.error_scale.sign_of_tilt_rate(u, self.significant)
    }

    fn note_extremes(&mut self, part: StepPart<'_>, samples: &[Sample]) {
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
            self.follow_tilt_rate(&after.u);
        }
    }

    /// Notes an extreme once the tilt rate clearly has the other sign.
    fn follow_tilt_rate(&mut self, u: &Coordinates<f64>) {
        let direction = self.sign_of_tilt_rate(u);
        if direction == 0.0 || direction == self.direction {
            return;
        }
        // The first clear direction after a release from rest is no reversal.
        if let Some(crossing) = self.crossing.take().filter(|_| self.direction != 0.0) {
            let at = self.instant_of(&crossing);
            self.note(extreme_kind(direction), at);
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

    fn note_on_edge(&mut self, part: StepPart<'_>, samples: &[Sample]) {
        // What topples there does not go past it. The cosine of the double next to pi/2 is 6e-17; from a
        // topple tilt farther beyond the edge the edge is passed first.
        if self.topple.is_some_and(|(_, cos)| cos.abs() < 1e-15) {
            return;
        }
        for sample in samples.windows(2) {
            let (before, after) = (&sample[0], &sample[1]);
            if (before.u.cos > 0.0) != (after.u.cos > 0.0) {
                let cos = |u: &[f64; COORDINATES]| Coordinates::from_array(u).cos;
                let x = part.dense.root(before.x, after.x, cos);
                let at = self.instant(part, x, |u| u.cos);
                self.note(EventKind::OnEdge, at);
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

    /// The step cut where `level` is zero, to the accuracy of the steps and not only of the dense
    /// output, which is one order less: x is corrected by the level that a real step finds there.
    fn refine(
        &self,
        part: StepPart<'_>,
        x: f64,
        level: impl Fn(&Coordinates<f64>) -> f64,
    ) -> StepRecord {
        const NUDGE: f64 = 1e-3;
        let StepPart { record, dense } = part;
        let level = |u: &[f64; COORDINATES]| level(&Coordinates::from_array(u));
        let first = record.cut(self.contacts, x);
        if record.is_polynomial() {
            return first;
        }
        let slope = (level(&dense.at(x + NUDGE)) - level(&dense.at(x - NUDGE))) / (2.0 * NUDGE);
        let correction = level(&first.end) / slope;
        // A level that only grazes zero has no slope to go by; then x stays.
        if correction.abs() < 0.01 {
            record.cut(self.contacts, x - correction)
        } else {
            first
        }
    }
}

/// Energy that a body lying flat has lost. One that leans far may have its centre of mass lower yet,
/// and is not at rest for that.
fn energy_above_rest(law: &dyn Dynamics<f64>, u: &Coordinates<f64>) -> f64 {
    let energy = law.energy(u);
    energy.kinetic + energy.potential.abs()
}

fn extreme_kind(direction: f64) -> EventKind {
    if direction > 0.0 {
        EventKind::TiltMin
    } else {
        EventKind::TiltMax
    }
}
