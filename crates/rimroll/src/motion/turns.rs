//! The angle of turn: the change of the yaw, and so of the contact point's azimuth, from one tilt maximum to
//! the next through a near-collision.

use super::event::{Event, EventKind};
use crate::state::Coordinates;

/// A turn from one tilt maximum to the next through a tilt minimum. It is the paper's turn if the minimum
/// is a near-collision.
///
/// The first turn begins at the release or, if the tilt rises there, at the maximum that follows. The sign of
/// the tilt rate decides, however small it is, and at a tilt rate of exactly 0 the sign of the tilt
/// acceleration. A disk that passes the vertical ends one turn there and begins another.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Turn {
    /// Change of yaw from one tilt maximum (or the release) to the next, rad, with its sign.
    pub angle: f64,
    /// Smallest tilt, rad; for a disk on its other face, measured from that face.
    pub min_tilt: f64,
    /// Time of the smallest tilt, s.
    pub t: f64,
    /// ψ̇ at the smallest tilt, rad/s.
    pub yaw_rate: f64,
    /// Time of the preceding tilt maximum (or release), s.
    pub start: f64,
    /// Time of the following tilt maximum, s.
    pub end: f64,
    /// The following tilt maximum, rad.
    pub max_tilt: f64,
}

/// An extremum of the lean, the tilt from the nearest face.
#[derive(Clone, Copy, PartialEq)]
enum Lean {
    Min,
    Max,
}

/// The events at extrema of the lean. `on_first_face` is the face on which the motion starts. The present
/// face is known by counting the passages over the edge; the tilt itself can be on either side of π/2 by
/// rounding where it only just reaches π/2.
fn lean_extrema(
    mut on_first_face: bool,
    events: &[Event],
) -> impl Iterator<Item = (Lean, &Coordinates<f64>)> {
    events.iter().filter_map(move |event| {
        let lean = match event.kind {
            EventKind::TiltMin if on_first_face => Lean::Min,
            EventKind::TiltMax if !on_first_face => Lean::Min,
            EventKind::TiltMin | EventKind::TiltMax => Lean::Max,
            EventKind::OnEdge => {
                on_first_face = !on_first_face;
                Lean::Max
            }
            _ => return None,
        };
        Some((lean, &event.at.u))
    })
}

/// The sign of the tilt rate at the release, however small the rate is. It is 0 at rest, where the
/// acceleration decides: the first sign after the release is then no reversal.
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
    turns_and_unfinished(start, events).0
}

/// The coordinates at the end of the first turn, if it was completed.
pub(super) fn end_of_first_turn(on_first_face: bool, events: &[Event]) -> Option<Coordinates<f64>> {
    let mut lean_extrema = lean_extrema(on_first_face, events);
    lean_extrema.find(|&(lean, _)| lean == Lean::Min)?;
    lean_extrema
        .find(|&(lean, _)| lean == Lean::Max)
        .map(|(_, at)| *at)
}

/// The first turn of a motion. It can be cut short by the end of the motion, for example by toppling.
pub(super) fn first_turn(
    start: &Coordinates<f64>,
    events: &[Event],
    end: &Coordinates<f64>,
) -> Option<Turn> {
    let (turns, unfinished) = turns_and_unfinished(start, events);
    let cut_short = unfinished.map(|turn| Turn::between(&turn.from, &turn.lowest, end));
    turns.into_iter().next().or(cut_short)
}

/// The start and the tilt minimum of a turn that is not complete.
struct Unfinished {
    from: Coordinates<f64>,
    lowest: Coordinates<f64>,
}

fn turns_and_unfinished(
    start: &Coordinates<f64>,
    events: &[Event],
) -> (Vec<Turn>, Option<Unfinished>) {
    let mut turns = Vec::new();
    let mut from = *start;
    let mut lowest: Option<Coordinates<f64>> = None;
    for (lean, at) in lean_extrema(start.cos > 0.0, events) {
        match lean {
            Lean::Min => lowest = Some(*at),
            Lean::Max => {
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
    /// The turn between two states through the tilt minimum `low`.
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
