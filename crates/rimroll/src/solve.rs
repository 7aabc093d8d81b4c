//! A solver for smooth autonomous systems u′ = f(u), independent of the mechanics.
//!
//! [`Stepper`] integrates with adaptive step size. Each [`Step`] has dense output, which also locates events,
//! that is, sign changes of a function of the state. [`Collocation`] integrates systems that are too stiff
//! for explicit steps.

mod collocation;
mod dense_output;
mod dop853;
mod implicit;
mod root;
mod stage_sums;
mod stepper;
pub(crate) mod tableau;

pub use collocation::{Collocation, POINTS, RADAU, solved};
pub use dense_output::Dense;
pub use dop853::Step;
pub use implicit::{Implicit, ImplicitStep};
pub use root::{bracketed_root, bracketed_root_in};
pub use stepper::{ErrorEstimate, Stepper};

use crate::real::Real;

/// An autonomous system of N first-order equations over the number type T.
pub trait System<T: Real, const N: usize> {
    /// The number of leading components on which no rate and no error scale depends. Within a step, `rates`
    /// and `scale` receive them with their values at the start of the step.
    const IGNORABLE: usize = 0;

    /// u′ = f(u).
    fn rates(&self, u: &[T; N]) -> [T; N];

    /// The error scale of each component.
    fn scale(&self, u: &[T; N]) -> [T; N];
}

/// The reason why the integration cannot continue.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stuck {
    /// The rates are not finite or change too fast for any step.
    StepUnderflow,
}

/// Counts of the work done.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Work {
    /// Steps accepted.
    pub steps: usize,
    /// Steps rejected and repeated with a smaller step size.
    pub rejected: usize,
    /// Evaluations of the right-hand side, including those on dual numbers for derivatives.
    pub evaluations: usize,
}

impl core::ops::Add for Work {
    type Output = Work;
    fn add(self, other: Work) -> Work {
        Work {
            steps: self.steps + other.steps,
            rejected: self.rejected + other.rejected,
            evaluations: self.evaluations + other.evaluations,
        }
    }
}
