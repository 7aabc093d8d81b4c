//! A stretch of a motion: one step of the solver.

use super::pose::{COORDINATES, Pose, SUPPORTED};
use super::support::SupportedBody;
use crate::solve::{Dense, Stepper, Stuck, Work};

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

/// The steps of a phase.
pub(super) enum Steps<'a> {
    OnSupport(
        &'a SupportedBody,
        Box<Stepper<'a, SupportedBody, SUPPORTED>>,
    ),
    InFlight(
        &'a SupportedBody,
        Box<Stepper<'a, SupportedBody, COORDINATES>>,
    ),
}

impl<'a> Steps<'a> {
    /// From a pose, with a first guess of the step (s) and a tolerance.
    pub fn new(supported: &'a SupportedBody, from: &Pose, h: f64, tolerance: f64) -> Steps<'a> {
        match supported.support.is_flight() {
            true => {
                let stepper = Stepper::new(supported, from.into_array(), h, tolerance);
                Steps::InFlight(supported, Box::new(stepper))
            }
            false => {
                let stepper = Stepper::new(supported, from.on_support(), h, tolerance);
                Steps::OnSupport(supported, Box::new(stepper))
            }
        }
    }

    pub fn work(&self) -> Work {
        match self {
            Steps::OnSupport(_, stepper) => stepper.work,
            Steps::InFlight(_, stepper) => stepper.work,
        }
    }

    /// The next step as a polynomial.
    pub fn advance(&mut self) -> Result<Dense<f64, COORDINATES>, Stuck> {
        match self {
            Steps::OnSupport(supported, stepper) => {
                let step = stepper.advance()?.dense(*supported);
                Ok(step.widened(&[0.0; COORDINATES]))
            }
            Steps::InFlight(supported, stepper) => Ok(stepper.advance()?.dense(*supported)),
        }
    }
}
