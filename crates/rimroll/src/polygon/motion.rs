//! The computed motion of a body with corners.

use super::body::PolygonalBody;
use super::segment::{Instant, Segment};
use super::support::Support;
use crate::ending::Status;
use crate::motion::Turn;
use crate::solve::Work;
use crate::state::State;
use crate::text::{AngleUnit, formatted_time};

/// The quantities of a [`Moment`], in order.
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
pub type Moment = [f64; COLUMNS.len()];

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
    pub fn moment(&self) -> Moment {
        self.at.moment()
    }

    /// The support after the event.
    pub fn support(&self) -> Support {
        self.at.carried.support
    }
}

/// The motion of a body with corners.
pub struct PolygonMotion {
    /// What moves.
    pub body: PolygonalBody,
    pub(super) start: Instant,
    pub(super) segments: Vec<Segment>,
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
    pub fn samples(&self, per_step: usize) -> Vec<Moment> {
        let mut samples = vec![self.start.moment()];
        let mut support = self.start.carried.support;
        for segment in &self.segments {
            if !segment.carried.support.is_same_phase(support) {
                support = segment.carried.support;
                samples.push(segment.at(0.0).moment());
            }
            let inside = (1..=per_step).map(|i| segment.at(i as f64 / per_step as f64).moment());
            samples.extend(inside);
        }
        samples
    }

    /// The quantities at a time (s), after an impact at that time; outside the motion those at its ends.
    pub fn at(&self, t: f64) -> Moment {
        if t < 0.0 {
            return self.start.moment();
        }
        let index = self.segments.partition_point(|segment| segment.end() <= t);
        match (self.segments.get(index), self.segments.last()) {
            (Some(segment), _) => {
                let length = segment.end() - segment.t;
                segment
                    .at(((t - segment.t) / length).clamp(0.0, 1.0))
                    .moment()
            }
            (None, Some(last)) => last.at(1.0).moment(),
            (None, None) => self.start.moment(),
        }
    }

    /// The supports and the times (s) at which they begin to carry the body.
    pub fn supports(&self) -> Vec<(Support, f64)> {
        let mut supports = vec![(self.start.carried.support, 0.0)];
        for segment in &self.segments {
            if supports
                .last()
                .is_none_or(|&(last, _)| !last.is_same_phase(segment.carried.support))
            {
                supports.push((segment.carried.support, segment.t));
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
        let near = self.carried.support.middle_spin(&self.carried.body);
        self.pose.state(near)
    }

    /// All quantities.
    pub(super) fn moment(&self) -> Moment {
        let Instant {
            pose,
            carried,
            anchor,
            ..
        } = self;
        let state = self.state();
        let [x, y] = carried.center(pose, *anchor);
        let z = carried.height(pose);
        let middle = pose.on_table(carried.middle());
        let reaction = carried.reaction(pose);
        let corner = carried.support.corner();
        let kinetic = carried.kinetic(pose);
        let potential = carried.body.mass() * carried.gravity * z;
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
            corner.rem_euclid(i64::from(carried.body.corners())) as f64,
            reaction.normal[0] + reaction.normal[1],
            reaction.friction,
            kinetic,
            potential,
            kinetic + potential,
            self.lost,
        ]
    }
}
