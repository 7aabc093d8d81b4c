//! A chunk of work: some setups and the parameters of their bodies.

use super::bounds::Bounds;
use crate::body::Body;
use crate::contact_law::ContactLaw;
use crate::error_scale::ErrorScale;
use crate::law::Parameters;
use crate::motion::{Options, ToppleTilt};
use crate::state::State;

/// What a fall starts from: the body, its state and the contact law.
pub type Setup<'a> = (&'a Body, State, ContactLaw);

/// Consecutive setups of an ensemble.
pub(super) struct Chunk<'a> {
    pub setups: &'a [Setup<'a>],
    pub options: &'a Options,
    pub bounds: Bounds,
    bodies: Vec<BodyNumbers>,
    /// The index of each setup's body in `bodies`.
    body_of: Vec<usize>,
}

/// The parameters of a body's falls.
#[derive(Clone)]
pub(super) struct BodyNumbers {
    /// The index of the body in its chunk. Bodies with the same index are equal.
    pub place: usize,
    pub parameters: Parameters<f64>,
    pub error_scale: ErrorScale<f64>,
    pub topple: ToppleTilt<f64>,
}

impl<'a> Chunk<'a> {
    /// A chunk of checked setups with the options of the ensemble. Adjacent equal bodies are stored once.
    pub(super) fn new(setups: &'a [Setup<'a>], options: &'a Options) -> Self {
        let mut bodies: Vec<BodyNumbers> = Vec::new();
        let mut body_of = Vec::with_capacity(setups.len());
        for (i, &(body, ..)) in setups.iter().enumerate() {
            if i == 0 || setups[i - 1].0 != body {
                let parameters = Parameters::new(body, options.gravity);
                bodies.push(BodyNumbers {
                    place: bodies.len(),
                    parameters,
                    error_scale: ErrorScale::new(&parameters),
                    topple: options
                        .topple_tilt_of(body)
                        .map_or_else(ToppleTilt::never, ToppleTilt::at),
                });
            }
            body_of.push(bodies.len() - 1);
        }
        Chunk {
            setups,
            options,
            bounds: Bounds::of(options),
            bodies,
            body_of,
        }
    }

    /// The body of the setup with this index.
    pub(super) fn body(&self, index: usize) -> &BodyNumbers {
        &self.bodies[self.body_of[index]]
    }
}
