//! The path through the coordinates: accepted steps, to be evaluated at any time.

use crate::solve::Dense;
use crate::state::{COORDINATES, Coordinates};

/// Index of the time among the coordinates.
pub(super) const TIME: usize = 4;

/// The accepted steps of a motion.
pub struct Track {
    start: Coordinates<f64>,
    steps: Vec<Dense<COORDINATES>>,
}

impl Track {
    pub(super) fn new(start: Coordinates<f64>) -> Self {
        Track {
            start,
            steps: Vec::new(),
        }
    }

    pub(super) fn push(&mut self, step: Dense<COORDINATES>) {
        self.steps.push(step);
    }

    /// The coordinates at the end so far.
    pub fn end(&self) -> Coordinates<f64> {
        self.steps
            .last()
            .map_or(self.start, |step| Coordinates::from_array(&step.end))
    }

    /// The start and the ends of all steps.
    pub fn nodes(&self) -> impl Iterator<Item = Coordinates<f64>> + '_ {
        core::iter::once(self.start).chain(
            self.steps
                .iter()
                .map(|step| Coordinates::from_array(&step.end)),
        )
    }

    /// The coordinates at a time, s; times outside the motion give its ends.
    pub fn at(&self, t: f64) -> Coordinates<f64> {
        if t <= self.start.t {
            return self.start;
        }
        let index = self.steps.partition_point(|step| step.end[TIME] < t);
        match self.steps.get(index) {
            Some(step) => Coordinates::from_array(&step.at(step.where_component(TIME, t))),
            None => self.end(),
        }
    }

    /// `per_step` samples inside each step and its end, after the start: close together just where
    /// the motion is fast.
    pub fn samples(&self, per_step: usize) -> Vec<Coordinates<f64>> {
        let inside = |step: &Dense<COORDINATES>| {
            let mut states: Vec<_> = (1..per_step)
                .map(|i| step.at(i as f64 / per_step as f64))
                .collect();
            states.push(step.end);
            states
        };
        core::iter::once(self.start)
            .chain(
                self.steps
                    .iter()
                    .flat_map(inside)
                    .map(|u| Coordinates::from_array(&u)),
            )
            .collect()
    }
}
