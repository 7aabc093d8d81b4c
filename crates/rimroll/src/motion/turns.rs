//! The angle of turn: how far the yaw, and with it the contact point, runs from one rest of the
//! tilt to the next through a near-collision.

use super::events::{Event, EventKind};
use crate::state::Coordinates;

/// From one tilt maximum to the next, through a minimum: the paper's turn when that is a near-collision.
///
/// The first begins at the release or, where the tilt rises there, at the maximum that follows: the sign of
/// the tilt rate decides, however small it is, and at a tilt rate of exactly 0 the sign of the tilt's
/// acceleration. A disk that passes the vertical ends one turn there and begins another.
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

/// The events at which the base leans least or most, for a motion that starts on the first face or not.
/// Which face the body is on is counted from edge to edge, not read off the tilt, which where it only just
/// reaches π/2 is on the one side or the other by rounding.
fn leans(
    mut on_first_face: bool,
    events: &[Event],
) -> impl Iterator<Item = (Lean, &Coordinates<f64>)> {
    events.iter().filter_map(move |event| {
        let lean = match event.kind {
            EventKind::TiltMin if on_first_face => Lean::Least,
            EventKind::TiltMax if !on_first_face => Lean::Least,
            EventKind::TiltMin | EventKind::TiltMax => Lean::Most,
            EventKind::OnEdge => {
                on_first_face = !on_first_face;
                Lean::Most
            }
            _ => return None,
        };
        Some((lean, &event.at.u))
    })
}

/// Which way the tilt goes at the release: −1 where it falls, 1 where it rises, by however little. 0 at
/// rest, where its acceleration decides: the first clear direction after that is no reversal.
///
/// A turn counts from the release unless the tilt rises there, then from the maximum that follows.
pub(crate) fn direction_at_release(start: &Coordinates<f64>) -> f64 {
    if start.p == 0.0 {
        0.0
    } else {
        start.p.signum()
    }
}

fn tilt_from_nearest_face(u: &Coordinates<f64>) -> f64 {
    libm::atan2(u.sin, u.cos.abs())
}

/// The turns between the events of a motion.
pub(super) fn turns(start: &Coordinates<f64>, events: &[Event]) -> Vec<Turn> {
    turns_and_rest(start, events).0
}

/// Where the first turn of a motion that starts on the first face, or not, was over, if it was.
pub(super) fn first_over(on_first_face: bool, events: &[Event]) -> Option<Coordinates<f64>> {
    let mut leans = leans(on_first_face, events);
    leans.find(|&(lean, _)| lean == Lean::Least)?;
    leans
        .find(|&(lean, _)| lean == Lean::Most)
        .map(|(_, at)| *at)
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
    for (lean, at) in leans(start.cos > 0.0, events) {
        match lean {
            Lean::Least => lowest = Some(*at),
            Lean::Most => {
                if let Some(low) = lowest.take() {
                    turns.push(Turn::between(&from, &low, at));
                }
                from = *at;
            }
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
