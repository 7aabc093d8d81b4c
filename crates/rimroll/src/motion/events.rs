//! What happens on the way: extremes of the tilt, the upright edge, and the ends of the contact.

use super::track::TIME;
use super::{FACE_DOWN_TILT, Options, Rolling, Status, Track};
use crate::solve::{Dense, Step};
use crate::state::{COORDINATES, Coordinates};

/// What happened.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EventKind {
    /// The tilt is smallest: the near-collision.
    TiltMin,
    /// The tilt is largest.
    TiltMax,
    /// The base is vertical, tilt π/2: a disk stands on its edge on its way from one face to the other.
    OnEdge,
    /// The topple tilt is reached; the motion ends.
    Topple,
    /// The normal force is zero and about to turn negative; the motion ends.
    LiftOff,
    /// The base lands flat; the motion ends.
    FaceDown,
}

impl EventKind {
    /// The name that the user reads.
    pub fn name(self) -> &'static str {
        match self {
            EventKind::TiltMin => "tilt_min",
            EventKind::TiltMax => "tilt_max",
            EventKind::OnEdge => "on_edge",
            EventKind::Topple => "topple",
            EventKind::LiftOff => "lift_off",
            EventKind::FaceDown => "face_down",
        }
    }
}

/// Something that happened, and the coordinates at that moment.
#[derive(Debug, Clone, Copy)]
pub struct Event {
    /// What.
    pub kind: EventKind,
    /// Where and when.
    pub at: Coordinates<f64>,
}

/// Looked at inside each step, and where the tilt is extreme: a topple tilt is not stepped over, and
/// the normal force can dip below zero unseen only within a quarter of a step.
const LOOKS: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];

/// What ends a motion, with the sign that its function has before.
const ENDINGS: [(Ending, f64); 4] = [
    (Ending::TimeUp, -1.0),
    (Ending::Topple, -1.0),
    (Ending::LiftOff, 1.0),
    (Ending::FaceDown, 1.0),
];

#[derive(Clone, Copy)]
enum Ending {
    TimeUp,
    Topple,
    LiftOff,
    FaceDown,
}

impl Ending {
    fn outcome(self) -> (Status, Option<EventKind>) {
        match self {
            Ending::TimeUp => (Status::Finished, None),
            Ending::Topple => (Status::Toppled, Some(EventKind::Topple)),
            Ending::LiftOff => (Status::LiftedOff, Some(EventKind::LiftOff)),
            Ending::FaceDown => (Status::FaceDown, Some(EventKind::FaceDown)),
        }
    }
}

/// A change of sign of the tilt rate, between two looks, that is not yet known to be more than
/// rounding.
struct Crossing {
    step: Step<COORDINATES>,
    dense: Dense<COORDINATES>,
    from: f64,
    to: f64,
}

/// Where the tilt rate changes sign between two fractions of a step.
fn extreme(dense: &Dense<COORDINATES>, from: f64, to: f64) -> Option<f64> {
    let rate = |u: &[f64; COORDINATES]| Coordinates::from_array(u).p;
    let reverses = (rate(&dense.at(from)) < 0.0) != (rate(&dense.at(to)) < 0.0);
    reverses.then(|| dense.root(from, to, rate))
}

/// Watches the steps go by.
pub(super) struct Watch<'a> {
    rolling: &'a Rolling<'a>,
    duration: f64,
    topple: Option<(f64, f64)>,
    /// A tilt rate counts as having a sign when it is larger than this part of its scale: a steady
    /// wobble has none.
    significant: f64,
    /// The last such sign, 0 before there is one.
    direction: f64,
    crossing: Option<Crossing>,
    events: Vec<Event>,
}

impl<'a> Watch<'a> {
    pub(super) fn new(
        rolling: &'a Rolling<'a>,
        options: &Options,
        start: &Coordinates<f64>,
    ) -> Self {
        let mut watch = Watch {
            rolling,
            duration: options.duration,
            topple: options.topple_tilt.map(libm::sincos),
            significant: 10.0 * options.rtol,
            direction: 0.0,
            crossing: None,
            events: Vec::new(),
        };
        watch.direction = watch.sign_of_tilt_rate(start);
        watch
    }

    pub(super) fn into_events(mut self) -> Vec<Event> {
        self.events.sort_by(|a, b| a.at.t.total_cmp(&b.at.t));
        self.events
    }

    /// Whether there is no motion to follow: the start cannot be or must not be left.
    pub(super) fn at_start(&mut self, start: &Coordinates<f64>) -> Option<Status> {
        let over = |ending: Ending, before: f64| before * self.level(ending, start) < 0.0;
        let (ending, _) = ENDINGS
            .into_iter()
            .find(|&(ending, before)| over(ending, before))?;
        Some(self.end_with(ending, *start))
    }

    /// Takes in an accepted step: notes what happened and adds it to the track, cut short where the
    /// motion ends.
    pub(super) fn pass(&mut self, step: Step<COORDINATES>, track: &mut Track) -> Option<Status> {
        let dense = step.clone().dense(self.rolling);
        let ending = self.first_ending(&dense);
        let until = ending.map_or(1.0, |(_, x)| x);
        self.note_extremes(&step, &dense, until);
        self.note_on_edge(&step, &dense, until);
        let Some((ending, x)) = ending else {
            track.push(dense);
            return None;
        };
        let mut last = self.refine(&step, &dense, x, |watch, u| watch.level(ending, u));
        if matches!(ending, Ending::TimeUp) {
            // Not a rounding error short of what was asked for.
            last.end[TIME] = self.duration;
        }
        let at = Coordinates::from_array(&last.end);
        track.push(last.dense(self.rolling));
        Some(self.end_with(ending, at))
    }

    fn end_with(&mut self, ending: Ending, at: Coordinates<f64>) -> Status {
        let (status, kind) = ending.outcome();
        self.events.extend(kind.map(|kind| Event { kind, at }));
        status
    }

    /// A function of the coordinates that changes sign where the motion ends.
    fn level(&self, ending: Ending, u: &Coordinates<f64>) -> f64 {
        match ending {
            Ending::TimeUp => u.t - self.duration,
            // sin(φ − φ_topple) has the sign of φ − φ_topple within (0, π).
            Ending::Topple => self
                .topple
                .map_or(-1.0, |(sin, cos)| u.sin * cos - u.cos * sin),
            Ending::LiftOff => self.rolling.law.contact(u).normal,
            Ending::FaceDown => u.sin - FACE_DOWN_TILT,
        }
    }

    /// The first ending inside a step and the fraction of the step where it is.
    fn first_ending(&self, dense: &Dense<COORDINATES>) -> Option<(Ending, f64)> {
        let mut looks = LOOKS.to_vec();
        looks.extend(
            LOOKS
                .windows(2)
                .filter_map(|look| extreme(dense, look[0], look[1])),
        );
        looks.sort_by(f64::total_cmp);
        for look in looks.windows(2) {
            let (from, to) = (look[0], look[1]);
            let there = Coordinates::from_array(&dense.at(to));
            let first = ENDINGS
                .into_iter()
                .filter(|&(ending, before)| before * self.level(ending, &there) <= 0.0)
                .map(|(ending, _)| {
                    let x = dense.root(from, to, |u| {
                        self.level(ending, &Coordinates::from_array(u))
                    });
                    (ending, x)
                })
                .min_by(|a, b| a.1.total_cmp(&b.1));
            if first.is_some() {
                return first;
            }
        }
        None
    }

    /// −1 or 1 when the tilt clearly falls or rises, 0 when it cannot be told.
    fn sign_of_tilt_rate(&self, u: &Coordinates<f64>) -> f64 {
        let scale = u.p.abs() + u.w.abs() + u.sin * self.rolling.falling_rate;
        if u.p.abs() > self.significant * scale {
            u.p.signum()
        } else {
            0.0
        }
    }

    fn note_extremes(&mut self, step: &Step<COORDINATES>, dense: &Dense<COORDINATES>, until: f64) {
        for look in LOOKS.windows(2) {
            let (from, to) = (look[0], look[1].min(until));
            if from >= to {
                return;
            }
            let before = Coordinates::from_array(&dense.at(from));
            let after = Coordinates::from_array(&dense.at(to));
            if (before.p < 0.0) != (after.p < 0.0) {
                self.crossing = Some(Crossing {
                    step: step.clone(),
                    dense: dense.clone(),
                    from,
                    to,
                });
            }
            let direction = self.sign_of_tilt_rate(&after);
            if direction == 0.0 || direction == self.direction {
                continue;
            }
            // The first clear direction after a release from rest is no reversal.
            if let Some(crossing) = self.crossing.take().filter(|_| self.direction != 0.0) {
                self.note_extreme(&crossing, direction);
            }
            self.direction = direction;
        }
    }

    fn note_extreme(&mut self, crossing: &Crossing, direction: f64) {
        let Crossing {
            step,
            dense,
            from,
            to,
        } = crossing;
        let x = dense.root(*from, *to, |u| Coordinates::from_array(u).p);
        let at = self.refine(step, dense, x, |_, u| u.p).end;
        self.events.push(Event {
            kind: if direction > 0.0 {
                EventKind::TiltMin
            } else {
                EventKind::TiltMax
            },
            at: Coordinates::from_array(&at),
        });
    }

    fn note_on_edge(&mut self, step: &Step<COORDINATES>, dense: &Dense<COORDINATES>, until: f64) {
        let cos = |x: f64| Coordinates::from_array(&dense.at(x)).cos;
        for look in LOOKS.windows(2) {
            let (from, to) = (look[0], look[1].min(until));
            if from < to && (cos(from) > 0.0) != (cos(to) > 0.0) {
                let x = dense.root(from, to, |u| Coordinates::from_array(u).cos);
                let at = self.refine(step, dense, x, |_, u| u.cos).end;
                self.events.push(Event {
                    kind: EventKind::OnEdge,
                    at: Coordinates::from_array(&at),
                });
            }
        }
    }

    /// The step cut where `level` is zero, to the accuracy of the steps and not only of the dense
    /// output, which is one order less: x is corrected by the level that a real step finds there.
    fn refine(
        &self,
        step: &Step<COORDINATES>,
        dense: &Dense<COORDINATES>,
        x: f64,
        level: impl Fn(&Self, &Coordinates<f64>) -> f64,
    ) -> Step<COORDINATES> {
        const NUDGE: f64 = 1e-3;
        let level = |u: &[f64; COORDINATES]| level(self, &Coordinates::from_array(u));
        let slope = (level(&dense.at(x + NUDGE)) - level(&dense.at(x - NUDGE))) / (2.0 * NUDGE);
        let first = step.cut(self.rolling, x);
        let correction = level(&first.end) / slope;
        // A level that only grazes zero has no slope to go by; then x stays.
        if correction.abs() < 0.01 {
            step.cut(self.rolling, x - correction)
        } else {
            first
        }
    }
}
