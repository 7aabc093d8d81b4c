//! A chunk of work: some setups, the parameters of their bodies, the bounds of their falls, and a fall in progress.

use crate::body::Body;
use crate::contact_law::ContactLaw;
use crate::error_scale::ErrorScale;
use crate::law::Parameters;
use crate::motion::{
    FACE_DOWN_TILT, Fall, FallRecord, Options, Status, ToppleTilt, Turn, direction_at_release,
};
use crate::state::{Coordinates, State};

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

/// The bounds of all falls of an ensemble.
pub(super) struct Bounds {
    /// The maximal duration, s.
    pub duration: f64,
    /// Below this sin φ the base may lie flat on the table.
    pub flat: f64,
    /// The tolerance of one step, relative to the error scales.
    pub tolerance: f64,
    /// [`Options::significant_tilt_rate`].
    significant: f64,
    /// A fall that takes more steps is left to the scalar solver.
    pub max_steps: f64,
}

impl Bounds {
    /// The bounds of falls with these options, which must have been checked.
    pub(super) fn of(options: &Options) -> Bounds {
        Bounds {
            duration: options.duration,
            flat: 10.0 * FACE_DOWN_TILT,
            tolerance: options.step_tolerance(),
            significant: options.significant_tilt_rate(),
            max_steps: (options.max_steps as f64).min(2000.0) - 1.0,
        }
    }

    /// Whether a fall can start in lanes at these coordinates, inside all bounds.
    pub(super) fn are_far_from(&self, u: &Coordinates<f64>, topple: &ToppleTilt<f64>) -> bool {
        let in_time = u.t < self.duration && self.max_steps > 0.0;
        u.sin > self.flat && u.cos > 0.0 && topple.below(u) > 0.0 && in_time
    }

    /// The sign of the tilt rate, or 0 if the sign is not significant.
    pub(super) fn sign_of_tilt_rate(&self, u: &Coordinates<f64>, scale: &ErrorScale<f64>) -> f64 {
        scale.sign_of_tilt_rate(u, self.significant)
    }
}

/// The facts about a fall in progress from which its result is made.
#[derive(Debug, Clone)]
pub(super) struct ActiveFall {
    /// The index of its setup in the chunk.
    pub index: usize,
    /// The beginning of the turn: the release, or a tilt maximum after it.
    pub from: Coordinates<f64>,
    /// The tilt minimum, once it is reached.
    pub lowest: Option<Coordinates<f64>>,
    /// Whether a tilt maximum after the minimum is reached.
    pub turned: bool,
    /// The sign of the tilt rate, or 0 while the sign is not significant.
    pub direction: f64,
    /// The number of accepted steps.
    pub steps: f64,
    /// Whether the rim has slid.
    pub slid: bool,
    /// Energy lost in slips that have ended, J.
    pub friction_loss: f64,
}

impl ActiveFall {
    pub(super) fn new(index: usize, start: &Coordinates<f64>, slid: bool) -> ActiveFall {
        ActiveFall {
            index,
            from: *start,
            lowest: None,
            turned: false,
            direction: direction_at_release(start),
            steps: 0.0,
            slid,
            friction_loss: 0.0,
        }
    }

    /// The result of the fall, which ended with `status` at `end`.
    pub(super) fn result(
        &self,
        k: &Parameters<f64>,
        status: Status,
        end: &Coordinates<f64>,
    ) -> Fall {
        let turn = |lowest| Turn::between(&self.from, lowest, end);
        let record = FallRecord {
            turn: self.lowest.as_ref().map(turn),
            turned: self.turned,
            slid: self.slid,
            // Under a law without flight the fall ends where flight would begin.
            flew: status == Status::LiftedOff,
            steps: self.steps as usize,
        };
        Fall::new(k, status, record, end)
    }
}
