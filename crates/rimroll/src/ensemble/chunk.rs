//! A piece of work: some trials, with the numbers of the bodies in them.

use super::Release;
use super::limits::{Limits, Topple};
use crate::error_scale::ErrorScale;
use crate::law::Parameters;
use crate::motion::Options;

/// Some of the trials of an ensemble.
pub(super) struct Chunk<'a> {
    pub trials: &'a [Release<'a>],
    pub options: &'a Options,
    pub limits: Limits,
    bodies: Vec<BodyNumbers>,
    /// For each trial the place of its body among them.
    body_of: Vec<usize>,
}

/// What the falls of a body are computed from.
#[derive(Clone)]
pub(super) struct BodyNumbers {
    /// The place of the body among those of the piece: two bodies of one place are the same.
    pub place: usize,
    pub parameters: Parameters<f64>,
    pub error_scale: ErrorScale<f64>,
    pub topple: Topple<f64>,
}

impl<'a> Chunk<'a> {
    /// Trials that have been checked, with the options of the ensemble. Bodies that follow one another and are
    /// equal count as one.
    pub(super) fn new(trials: &'a [Release<'a>], options: &'a Options) -> Self {
        let mut bodies: Vec<BodyNumbers> = Vec::new();
        let mut body_of = Vec::with_capacity(trials.len());
        for (i, &(body, ..)) in trials.iter().enumerate() {
            if i == 0 || trials[i - 1].0 != body {
                let parameters = Parameters::new(body, options.gravity);
                bodies.push(BodyNumbers {
                    place: bodies.len(),
                    parameters,
                    error_scale: ErrorScale::new(&parameters),
                    topple: Topple::at(options.topple_tilt_of(body)),
                });
            }
            body_of.push(bodies.len() - 1);
        }
        Chunk {
            trials,
            options,
            limits: Limits::of(options),
            bodies,
            body_of,
        }
    }

    /// The body of a trial.
    pub(super) fn body(&self, index: usize) -> &BodyNumbers {
        &self.bodies[self.body_of[index]]
    }
}
