//! The computed motion of a body with corners.

use super::body::PolygonalBody;
use super::pose::{COORDINATES, Pose};
use super::support::{Support, SupportedBody};
use crate::ending::Status;
use crate::motion::Turn;
use crate::number_format::{AngleUnit, formatted_time};
use crate::solve::{Dense, Work};
use crate::state::State;

/// The quantities of [`Observables`], in order.
pub const COLUMNS: [&str; 19] = [
    "t",
    "tilt",
    "tilt_rate",
    "yaw",
    "yaw_rate",
    "spin",
    "spin_rate",
    "x",
    "y",
    "z",
    "contact_x",
    "contact_y",
    "corner",
    "normal",
    "friction",
    "kinetic",
    "potential",
    "energy",
    "impact_loss",
];

/// All quantities at one time (SI): time; state; centre of mass; middle of the support; its first corner, from 0
/// to n − 1; normal force and size of the friction; energies; and the energy that impacts have taken so far.
pub type Observables = [f64; COLUMNS.len()];

/// The kind of an event.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PolygonEventKind {
    /// The tilt is largest.
    TiltMax,
    /// The tilt is smallest, other than at an impact.
    TiltMin,
    /// Corners come down on the table.
    Impact,
    /// One end of an edge leaves the table.
    CornerLift,
    /// The force of the table vanishes.
    LiftOff,
    /// The topple tilt is reached.
    Topple,
}

impl PolygonEventKind {
    /// The name that the user reads.
    pub fn name(self) -> &'static str {
        match self {
            PolygonEventKind::TiltMax => "tilt_max",
            PolygonEventKind::TiltMin => "tilt_min",
            PolygonEventKind::Impact => "impact",
            PolygonEventKind::CornerLift => "corner_lift",
            PolygonEventKind::LiftOff => "lift_off",
            PolygonEventKind::Topple => "topple",
        }
    }
}

/// An event: its kind, the body after it, and the energy that it took, J.
pub struct PolygonEvent {
    /// What happened.
    pub kind: PolygonEventKind,
    pub(super) at: Instant,
    /// The energy that an impact took, J.
    pub loss: f64,
}

impl PolygonEvent {
    /// All quantities after the event.
    pub fn observables(&self) -> Observables {
        self.at.observables()
    }

    /// The support after the event.
    pub fn support(&self) -> Support {
        self.at.supported.support
    }
}

/// The motion of a body with corners.
pub struct PolygonMotion {
    /// What moves.
    pub body: PolygonalBody,
    pub(super) start: Instant,
    pub(super) segments: Vec<StepRecord>,
    /// The events in order.
    pub events: Vec<PolygonEvent>,
    /// The turns from one large tilt maximum to the next.
    pub turns: Vec<Turn>,
    /// The way in which it ended.
    pub status: Status,
    /// Counts of the work done.
    pub work: Work,
}

impl PolygonMotion {
    /// The quantities at the start and at the ends of all steps, with `per_step` moments a step. An impact appears
    /// twice, before and after.
    pub fn samples(&self, per_step: usize) -> Vec<Observables> {
        let mut samples = vec![self.start.observables()];
        let mut support = self.start.supported.support;
        for segment in &self.segments {
            if !segment.supported.support.is_same_phase(support) {
                support = segment.supported.support;
                samples.push(segment.at(0.0).observables());
            }
            let inside =
                (1..=per_step).map(|i| segment.at(i as f64 / per_step as f64).observables());
            samples.extend(inside);
        }
        samples
    }

    /// The quantities at a time (s), after an impact at that time; outside the motion those at its ends.
    pub fn at(&self, t: f64) -> Observables {
        if t < 0.0 {
            return self.start.observables();
        }
        let index = self.segments.partition_point(|segment| segment.end() <= t);
        match (self.segments.get(index), self.segments.last()) {
            (Some(segment), _) => {
                let length = segment.end() - segment.t;
                segment
                    .at(((t - segment.t) / length).clamp(0.0, 1.0))
                    .observables()
            }
            (None, Some(last)) => last.at(1.0).observables(),
            (None, None) => self.start.observables(),
        }
    }

    /// The supports and the times (s) at which they begin to carry the body.
    pub fn supports(&self) -> Vec<(Support, f64)> {
        let mut supports = vec![(self.start.supported.support, 0.0)];
        for segment in &self.segments {
            if supports
                .last()
                .is_none_or(|&(last, _)| !last.is_same_phase(segment.supported.support))
            {
                supports.push((segment.supported.support, segment.t));
            }
        }
        supports
    }

    /// How the motion ended, in a sentence.
    pub fn message(&self, unit: AngleUnit) -> String {
        let end = self.segments.last().map_or(self.start, |last| last.at(1.0));
        let t = formatted_time(end.t);
        let tilt = unit.formatted(end.pose.tilt());
        match self.status {
            Status::Finished => format!("reached the duration, t = {t}, at a tilt of {tilt}"),
            Status::Toppled => format!("toppled: reached the tilt {tilt} at t = {t}"),
            Status::LiftedOff => format!(
                "lifted off at t = {t}, at a tilt of {tilt}: to stay on the table a corner would have to be pulled down, \
                 and without its friction it would go through the table"
            ),
            Status::AtRest => format!("stands on its base at t = {t}: impacts took the energy"),
            Status::Interrupted => format!("was interrupted at t = {t}"),
            _ => format!(
                "cannot be followed beyond t = {t}: out of steps, or no step is small enough"
            ),
        }
    }
}

impl Instant {
    /// The angles and their rates.
    pub(super) fn state(&self) -> State {
        let near = self.supported.support.middle_spin(&self.supported.body);
        self.pose.state(near)
    }

    /// All quantities.
    pub(super) fn observables(&self) -> Observables {
        let Instant {
            pose,
            supported,
            anchor,
            ..
        } = self;
        let state = self.state();
        let [x, y] = supported.center(pose, *anchor);
        let z = supported.height(pose);
        let middle = pose.on_table(supported.middle());
        let reaction = supported.reaction(pose);
        let normal = reaction.normal[0] + reaction.normal[1];
        // The table does not pull: where it would have to, the body leaves it at this moment.
        let (normal, friction) = if normal <= 0.0 {
            (0.0, 0.0)
        } else {
            (normal, reaction.friction)
        };
        let corner = supported.support.corner();
        let kinetic = supported.kinetic(pose);
        let potential = supported.body.mass() * supported.gravity * z;
        [
            self.t,
            state.tilt,
            state.tilt_rate,
            state.yaw,
            state.yaw_rate,
            state.spin,
            state.spin_rate,
            x,
            y,
            z,
            x + middle[0],
            y + middle[1],
            corner.rem_euclid(i64::from(supported.body.corners())) as f64,
            normal,
            friction,
            kinetic,
            potential,
            kinetic + potential,
            self.lost,
        ]
    }
}

/// The turns between the events of a motion.
///
/// As a corner follows another, the tilt has a small maximum in between. So only maxima count between which the tilt falls
/// below half of the lower one; as a round body's turn, the first begins at the release or at the maximum that follows.
pub(super) fn turns(start: &Instant, events: &[PolygonEvent], end: &Instant) -> Vec<Turn> {
    let mut turns = Vec::new();
    let mut high = Extremum::of(start);
    let mut low: Option<Extremum> = None;
    let mut next: Option<Extremum> = None;
    let places = events.iter().map(|event| &event.at).chain([end]);
    for at in places.map(Extremum::of) {
        match (&mut low, &mut next) {
            (None, _) if at.tilt() >= high.tilt() => high = at,
            (None, _) if at.tilt() < 0.5 * high.tilt() => low = Some(at),
            (None, _) => {}
            (Some(lowest), None) if at.tilt() < lowest.tilt() => *lowest = at,
            (Some(lowest), None) if at.tilt() > 2.0 * lowest.tilt() => next = Some(at),
            (Some(_), None) => {}
            (Some(_), Some(highest)) if at.tilt() >= highest.tilt() => *highest = at,
            (Some(lowest), Some(highest)) if at.tilt() < 0.5 * highest.tilt() => {
                turns.push(Extremum::turn(&high, lowest, highest));
                high = *highest;
                low = Some(at);
                next = None;
            }
            (Some(_), Some(_)) => {}
        }
    }
    if let (Some(lowest), Some(highest)) = (low, next)
        && highest.t < end.t
    {
        turns.push(Extremum::turn(&high, &lowest, &highest));
    }
    turns
}

#[derive(Clone, Copy)]
struct Extremum {
    t: f64,
    state: State,
}

impl Extremum {
    fn of(at: &Instant) -> Extremum {
        Extremum {
            t: at.t,
            state: at.state(),
        }
    }

    fn tilt(&self) -> f64 {
        self.state.tilt
    }

    fn turn(from: &Extremum, low: &Extremum, to: &Extremum) -> Turn {
        Turn {
            angle: to.state.yaw - from.state.yaw,
            min_tilt: low.state.tilt,
            t: low.t,
            yaw_rate: low.state.yaw_rate,
            start: from.t,
            end: to.t,
            max_tilt: to.state.tilt,
        }
    }
}

/// A step, or a jump of no length.
pub(super) struct StepRecord {
    /// The time at its start, s.
    pub t: f64,
    pub dense: Dense<f64, COORDINATES>,
    /// The fraction of the step at which the segment ends.
    pub until: f64,
    pub supported: SupportedBody,
    /// See [`SupportedBody::center`].
    pub anchor: [f64; 2],
    /// The energy that impacts have taken so far, J.
    pub lost: f64,
}

/// The body at one time.
#[derive(Clone, Copy)]
pub(super) struct Instant {
    pub t: f64,
    pub pose: Pose,
    pub supported: SupportedBody,
    pub anchor: [f64; 2],
    pub lost: f64,
}

impl StepRecord {
    /// A jump to this instant.
    pub fn jump(to: &Instant) -> StepRecord {
        StepRecord {
            t: to.t,
            dense: Dense::empty(to.pose.into_array()),
            until: 1.0,
            supported: to.supported,
            anchor: to.anchor,
            lost: to.lost,
        }
    }

    /// The time at its end, s.
    pub fn end(&self) -> f64 {
        self.t + self.until * self.dense.h
    }

    /// At a fraction of the segment.
    pub fn at(&self, fraction: f64) -> Instant {
        let x = fraction * self.until;
        Instant {
            t: self.t + x * self.dense.h,
            pose: Pose::from_array(&self.dense.at(x)),
            supported: self.supported,
            anchor: self.anchor,
            lost: self.lost,
        }
    }
}
