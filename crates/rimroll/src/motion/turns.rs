//! The angle of turn: how far the yaw, and with it the contact point, runs from one rest of the
//! tilt to the next through a near-collision.

use super::events::{Event, EventKind};
use crate::state::Coordinates;

/// From one tilt maximum to the next, through a minimum: the paper's turn when that is a near-collision.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Turn {
    /// Change of yaw from one tilt maximum (or the release) to the next, rad, with its sign.
    pub angle: f64,
    /// Smallest tilt, rad; for a disk on its other face, counted from that face.
    pub min_tilt: f64,
    /// Time of the smallest tilt, s.
    pub t: f64,
    /// ψ̇ there, rad/s.
    pub yaw_rate: f64,
    /// Time of the tilt maximum (or release) before, s.
    pub start: f64,
    /// Time of the tilt maximum after, s.
    pub end: f64,
    /// The tilt maximum after, rad.
    pub max_tilt: f64,
}

/// How the base stands at an event: nearest to flat, or farthest from it.
#[derive(Clone, Copy, PartialEq)]
enum Lean {
    Least,
    Most,
}

fn lean(event: &Event) -> Option<Lean> {
    let on_first_face = event.at.cos > 0.0;
    match event.kind {
        EventKind::TiltMin if on_first_face => Some(Lean::Least),
        EventKind::TiltMax if !on_first_face => Some(Lean::Least),
        EventKind::TiltMin | EventKind::TiltMax | EventKind::OnEdge => Some(Lean::Most),
        _ => None,
    }
}

fn tilt_from_nearest_face(u: &Coordinates<f64>) -> f64 {
    libm::atan2(u.sin, u.cos.abs())
}

/// The turns between the events of a motion.
pub(super) fn turns(start: &Coordinates<f64>, events: &[Event]) -> Vec<Turn> {
    turns_and_rest(start, events).0
}

/// Where the first turn was over, if it was.
pub(super) fn first_over(events: &[Event]) -> Option<Coordinates<f64>> {
    let is = |wanted| move |event: &&Event| lean(event) == Some(wanted);
    let mut events = events.iter();
    events.find(is(Lean::Least))?;
    events.find(is(Lean::Most)).map(|event| event.at.u)
}

/// The first turn of a motion, which may have ended before the tilt was largest, as by toppling.
pub(super) fn first_turn(
    start: &Coordinates<f64>,
    events: &[Event],
    end: &Coordinates<f64>,
) -> Option<Turn> {
    let (whole, rest) = turns_and_rest(start, events);
    let cut_short = rest.map(|rest| Turn::between(&rest.from, &rest.lowest, end));
    whole.into_iter().next().or(cut_short)
}

/// Where a turn that is not over began and was lowest.
struct Unfinished {
    from: Coordinates<f64>,
    lowest: Coordinates<f64>,
}

fn turns_and_rest(start: &Coordinates<f64>, events: &[Event]) -> (Vec<Turn>, Option<Unfinished>) {
    let mut turns = Vec::new();
    let mut from = *start;
    let mut lowest: Option<Coordinates<f64>> = None;
    for event in events {
        match lean(event) {
            Some(Lean::Least) => lowest = Some(event.at.u),
            Some(Lean::Most) => {
                if let Some(low) = lowest.take() {
                    turns.push(Turn::between(&from, &low, &event.at));
                }
                from = event.at.u;
            }
            None => {}
        }
    }
    (turns, lowest.map(|lowest| Unfinished { from, lowest }))
}

impl Turn {
    /// The turn from one place to another by way of the lowest.
    pub(crate) fn between(
        from: &Coordinates<f64>,
        low: &Coordinates<f64>,
        to: &Coordinates<f64>,
    ) -> Turn {
        Turn {
            angle: to.yaw - from.yaw,
            min_tilt: tilt_from_nearest_face(low),
            t: low.t,
            yaw_rate: low.yaw_rate(),
            start: from.t,
            end: to.t,
            max_tilt: tilt_from_nearest_face(to),
        }
    }
}
