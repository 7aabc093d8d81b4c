//! The outcome of a motion on a table that moves: a motion of which only the end and the extremes are kept.

#[cfg(feature = "ground")]
mod batch;

#[cfg(feature = "ground")]
pub(crate) use batch::shaken_batch;

use super::contacts::Contacts;
use super::event::{Event, EventKind};
use super::event_detector::Goal;
use super::instant::{Instant, Phase};
use super::options::Options;
use super::prepared;
use super::run::Run;
use crate::body::Body;
use crate::contact_law::ContactLaw;
use crate::ending::Status;
use crate::error::InvalidInput;
use crate::ground::Ground;
use crate::law::{DynamicsExt, FrictionLaw, Parameters};
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
    /// Whether the motion ended before it was determined whether the body overturns.
    pub undecided: bool,
    /// Whether the body stands at the end and the table no longer moves.
    pub stands: bool,
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
        let end = topple.map_or_else(|| trajectory.end(), |event| event.at);
        let (max_tilt, max_tilt_time) = largest_tilt(start, &events, &end);
        let k = self.contacts.parameters();
        let (from, to) = (footprint(k, start), footprint(k, &end));
        Shaken {
            status,
            overturning_time: overturning_time(k, status, &events, &end),
            undecided: is_undecided(&self.contacts, status, &events, &end),
            stands: stands(&self.contacts, status, &end),
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

/// Whether a motion ended before it was determined whether the body overturns.
///
/// It is determined where the body has overturned, or where the table no longer moves and the body stands, slides flat,
/// leans less than its balance tilt with too little energy to reach it, or repeats a rocking that loses no energy. A
/// motion may also stop with too little energy where the base comes down flat: an impact adds none.
pub(super) fn is_undecided(
    contacts: &Contacts,
    status: Status,
    events: &[Event],
    end: &Instant,
) -> bool {
    let k = contacts.parameters();
    if overturning_time(k, status, events, end).is_some() || status == Status::AtRest {
        return false;
    }
    let is_safe = matches!(end.phase, Phase::Standing | Phase::SlidingFlat)
        || !k.is_past_balance(end.tilt())
            && energy_of_tilting(contacts, end) < k.m * k.g * (libm::hypot(k.r, k.h) - k.h)
        || repeats_itself(contacts, events, end);
    !matches!(status, Status::Finished | Status::FaceDown)
        || !is_safe
        || !ground_is_over(contacts, end)
}

/// Whether the tilt is periodic: the body has passed a minimum and a maximum of the tilt on a table at rest, without loss
/// and change of contact. The other half of the period is the same, backward.
fn repeats_itself(contacts: &Contacts, events: &[Event], end: &Instant) -> bool {
    let law = contacts.contact_law();
    let loses_nothing = law.resistance.is_none()
        && (end.phase == Phase::Rolling || matches!(law.friction, FrictionLaw::Frictionless));
    let ground_end = contacts.ground().map_or(0.0, |ground| ground.duration());
    let is_extremum = |event: &&Event| {
        matches!(event.kind, EventKind::TiltMin | EventKind::TiltMax) && event.at.t >= ground_end
    };
    let has = |kind| {
        let mut extrema = events.iter().rev().take_while(is_extremum);
        extrema.any(|event| event.kind == kind)
    };
    loses_nothing && has(EventKind::TiltMin) && has(EventKind::TiltMax)
}

/// Whether a body stands at the end of its motion and the table no longer moves.
pub(super) fn stands(contacts: &Contacts, status: Status, end: &Instant) -> bool {
    status == Status::AtRest || end.phase == Phase::Standing && ground_is_over(contacts, end)
}

fn ground_is_over(contacts: &Contacts, end: &Instant) -> bool {
    contacts
        .ground()
        .is_none_or(|ground| end.t >= ground.duration())
}

/// The energy above that of standing, J, without that of a frictionless glide, which cannot tilt the body.
fn energy_of_tilting(contacts: &Contacts, at: &Instant) -> f64 {
    let dynamics = contacts.dynamics(at.phase);
    let energy = dynamics.energy(at);
    let glide = match contacts.contact_law().friction {
        FrictionLaw::Frictionless => {
            let [vx, vy] = dynamics.center_velocity(at);
            0.5 * dynamics.parameters().m * (vx * vx + vy * vy)
        }
        _ => 0.0,
    };
    energy.kinetic + energy.potential - glide
}

/// The largest tilt (rad) and its time (s), which is that of a maximum, of an impact or of an end of the motion.
pub(super) fn largest_tilt(
    start: &Coordinates<f64>,
    events: &[Event],
    end: &Coordinates<f64>,
) -> (f64, f64) {
    let maxima = events
        .iter()
        .filter(|event| matches!(event.kind, EventKind::TiltMax | EventKind::Land));
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
