//! Turns of a body with corners.

use super::motion::PolygonEvent;
use super::step_record::Instant;
use crate::motion::Turn;
use crate::state::State;

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
