//! The outcome of a motion on a table that moves: a motion of which only the end and the extremes are kept.

#[cfg(feature = "ground")]
mod batch;

#[cfg(feature = "ground")]
pub(crate) use batch::shaken_batch;

use super::contacts::Contacts;
use super::event::{Event, EventKind};
use super::event_detector::Goal;
use super::options::Options;
use super::prepared;
use super::run::Run;
use crate::body::Body;
use crate::contact_law::ContactLaw;
use crate::ending::Status;
use crate::error::InvalidInput;
use crate::ground::Ground;
use crate::law::Parameters;
use crate::real::Real;
use crate::state::{Coordinates, State};
use core::ops::ControlFlow;
use std::sync::Arc;

/// The outcome of a motion on a table that moves. All quantities are relative to the table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shaken {
    /// The way in which the motion ended.
    pub status: Status,
    /// The time at which the topple tilt was reached or, under a law without flight, at which the rim lifted off beyond
    /// the balance tilt, s; `None` for a body that did not overturn.
    pub overturning_time: Option<f64>,
    /// The largest tilt, rad. For a body that toppled it is the topple tilt.
    pub max_tilt: f64,
    /// The time of the largest tilt, s.
    pub max_tilt_time: f64,
    /// The time of the first uplift of a body that stood flat, s.
    pub uplift_time: Option<f64>,
    /// The time of the end, s.
    pub end_time: f64,
    /// φ at the end, rad.
    pub end_tilt: f64,
    /// Displacement of the footprint along x and y from the start to the end, m. Its centre is that of the circle on
    /// which the base would stand if the body turned upright about the contact point.
    pub residual_displacement: [f64; 2],
    /// Change of ψ + θ from the start to the end, rad: for a body that stands, the angle by which it has turned about
    /// the vertical.
    pub residual_yaw: f64,
    /// Energy lost to friction, J.
    pub friction_loss: f64,
    /// Energy lost to rolling resistance, pivoting friction and air drag, J.
    pub resistance_loss: f64,
    /// Energy lost in impacts, J, without that of the side on the table.
    pub impact_loss: f64,
    /// Work of the ground, J.
    pub ground_work: f64,
    /// The number of steps of the solver.
    pub steps: usize,
}

/// The outcome of a motion as [`simulate_on`](super::simulate_on) computes it, without its trajectory.
///
/// # Errors
/// As [`simulate`](super::simulate).
pub fn shaken(
    ground: Option<Arc<Ground>>,
    body: &Body,
    start: &State,
    contact_law: &ContactLaw,
    options: &Options,
    mut watch: impl FnMut(f64) -> ControlFlow<()>,
) -> Result<Shaken, InvalidInput> {
    let prepared = PreparedMotion::new(ground, body, start, contact_law, options)?;
    let mut run = prepared.run();
    let status = run.follow_to_the_end(&mut watch);
    Ok(prepared.outcome(run, status))
}

/// What a motion begins with.
pub(crate) struct PreparedMotion {
    options: Options,
    contacts: Arc<Contacts>,
    start: Coordinates<f64>,
}

impl PreparedMotion {
    /// # Errors
    /// As [`simulate`](super::simulate).
    pub(crate) fn new(
        ground: Option<Arc<Ground>>,
        body: &Body,
        start: &State,
        contact_law: &ContactLaw,
        options: &Options,
    ) -> Result<Self, InvalidInput> {
        let (options, contacts, start) = prepared(ground, body, start, contact_law, options)?;
        Ok(PreparedMotion {
            options,
            contacts,
            start,
        })
    }

    fn run(&self) -> Run<'_> {
        let goal = Goal::End(self.options.duration);
        Run::new(&self.contacts, &self.options, goal, self.start)
    }

    /// The outcome of a run that has ended.
    fn outcome(&self, run: Run<'_>, status: Status) -> Shaken {
        let start = &self.start;
        let (trajectory, events, work) = run.into_parts();
        let first = |kind| events.iter().find(|event| event.kind == kind);
        let topple = first(EventKind::Topple);
        let end = topple.map_or_else(|| trajectory.end().u, |event| event.at.u);
        let (max_tilt, max_tilt_time) = largest_tilt(start, &events, &end);
        let k = self.contacts.parameters();
        let (from, to) = (footprint(k, start), footprint(k, &end));
        Shaken {
            status,
            overturning_time: overturning_time(k, status, &events, &end),
            max_tilt,
            max_tilt_time,
            uplift_time: first(EventKind::Uplift).map(|event| event.at.t),
            end_time: end.t,
            end_tilt: end.tilt(),
            residual_displacement: [to[0] - from[0], to[1] - from[1]],
            residual_yaw: (end.yaw + end.spin) - (start.yaw + start.spin),
            friction_loss: end.friction_loss,
            resistance_loss: end.resistance_loss,
            impact_loss: end.impact_loss,
            ground_work: end.ground_work,
            steps: work.steps,
        }
    }
}

/// The time at which a body overturned, s: when it reached the topple tilt or, under a law without flight, when the rim
/// lifted off beyond the balance tilt.
pub(super) fn overturning_time(
    k: &Parameters<f64>,
    status: Status,
    events: &[Event],
    end: &Coordinates<f64>,
) -> Option<f64> {
    let topple = events.iter().find(|event| event.kind == EventKind::Topple);
    let lifted_off = || status == Status::LiftedOff && k.is_past_balance(end.tilt());
    match topple {
        Some(event) => Some(event.at.t),
        None => lifted_off().then_some(end.t),
    }
}

/// The largest tilt (rad) and its time (s), which is that of a maximum or of an end of the motion.
pub(super) fn largest_tilt(
    start: &Coordinates<f64>,
    events: &[Event],
    end: &Coordinates<f64>,
) -> (f64, f64) {
    let maxima = events
        .iter()
        .filter(|event| event.kind == EventKind::TiltMax);
    let candidates = maxima.map(|event| (event.at.tilt(), event.at.t));
    candidates
        .chain([(end.tilt(), end.t)])
        .fold((start.tilt(), start.t), |largest, next| {
            if next.0 > largest.0 { next } else { largest }
        })
}

/// The centre of the footprint relative to the place of the centre of mass at the start, m.
pub(super) fn footprint<T: Real>(k: &Parameters<T>, u: &Coordinates<T>) -> [T; 2] {
    let [x, y] = u.center();
    let (sin_yaw, cos_yaw) = u.yaw.sin_cos();
    let toward_axis = k.r - k.rho(u);
    [x + toward_axis * cos_yaw, y + toward_axis * sin_yaw]
}
