//! The path through the coordinates: accepted steps, to be evaluated at any time.

use super::contacts::Phase;
use crate::solve::Dense;
use crate::state::{COORDINATES, Coordinates};
use core::ops::Deref;

/// Index of the time among the coordinates.
pub(super) const TIME: usize = 4;

/// The coordinates at a moment, and how the rim meets the table then.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Instant {
    /// Which of the contact's laws holds.
    pub phase: Phase,
    /// Where the body is and how it moves.
    pub u: Coordinates<f64>,
}

impl Deref for Instant {
    type Target = Coordinates<f64>;

    fn deref(&self) -> &Coordinates<f64> {
        &self.u
    }
}

/// The accepted steps of a motion.
pub struct Track {
    start: Instant,
    steps: Vec<(Phase, Dense<f64, COORDINATES>)>,
    /// Whether all of them are wanted, or only the last.
    whole: bool,
}

impl Track {
    pub(super) fn new(start: Instant, whole: bool) -> Self {
        Track {
            start,
            steps: Vec::new(),
            whole,
        }
    }

    pub(super) fn push(&mut self, phase: Phase, step: Dense<f64, COORDINATES>) {
        if !self.whole {
            self.steps.clear();
        }
        self.steps.push((phase, step));
    }

    /// Ends the motion with a sudden change.
    pub(super) fn push_jump(&mut self, to: Instant) {
        self.push(to.phase, Dense::still(to.u.into_array()));
    }

    /// Where the motion began.
    pub fn start(&self) -> Instant {
        self.start
    }

    /// Where the motion has come to so far.
    pub fn end(&self) -> Instant {
        self.steps.last().map_or(self.start, end_of)
    }

    /// Where each phase begins.
    pub fn phases(&self) -> impl Iterator<Item = Instant> + '_ {
        let mut before = None;
        let begins = move |(phase, step): &(Phase, Dense<f64, COORDINATES>)| {
            let changed = before.replace(*phase) != Some(*phase);
            changed.then(|| instant(*phase, &step.start))
        };
        self.steps.iter().filter_map(begins)
    }

    /// Length of the last step on the solver's clock.
    pub(super) fn last_step(&self) -> f64 {
        self.steps.last().map_or(0.0, |(_, step)| step.h)
    }

    /// The start and the ends of all steps, and a second time, as they are after it, the moments at
    /// which the contact changed.
    pub fn nodes(&self) -> impl Iterator<Item = Instant> + '_ {
        self.sampled(1)
    }

    /// The motion at a time, s, after what happens just then; times outside it give its ends.
    pub fn at(&self, t: f64) -> Instant {
        if t <= self.start.t {
            return self.start;
        }
        let index = self.steps.partition_point(|(_, step)| step.end[TIME] <= t);
        match self.steps.get(index) {
            Some((phase, step)) => instant(*phase, &step.at(step.where_component(TIME, t))),
            None => self.end(),
        }
    }

    /// `per_step` samples inside each step and its end, after the start: close together just where
    /// the motion is fast.
    pub fn samples(&self, per_step: usize) -> Vec<Instant> {
        self.sampled(per_step).collect()
    }

    fn sampled(&self, per_step: usize) -> impl Iterator<Item = Instant> + '_ {
        let inside = move |(phase, step): &(Phase, Dense<f64, COORDINATES>)| {
            let mut samples: Vec<_> = (1..per_step)
                .map(|i| instant(*phase, &step.at(i as f64 / per_step as f64)))
                .collect();
            samples.push(instant(*phase, &step.end));
            samples
        };
        let mut before = (self.start.phase, self.start.u.into_array());
        let with_changes = move |piece: &(Phase, Dense<f64, COORDINATES>)| {
            let (phase, step) = piece;
            let (phase_before, end_before) = before;
            before = (*phase, step.end);
            let changed = phase_before != *phase || end_before != step.start;
            let begun = changed.then(|| instant(*phase, &step.start));
            begun.into_iter().chain(inside(piece))
        };
        core::iter::once(self.start).chain(self.steps.iter().flat_map(with_changes))
    }
}

fn instant(phase: Phase, u: &[f64; COORDINATES]) -> Instant {
    Instant {
        phase,
        u: Coordinates::from_array(u),
    }
}

fn end_of((phase, step): &(Phase, Dense<f64, COORDINATES>)) -> Instant {
    instant(*phase, &step.end)
}
