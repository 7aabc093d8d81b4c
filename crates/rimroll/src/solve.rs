//! A solver for smooth autonomous systems u′ = f(u), independent of the mechanics.
//!
//! [`Stepper`] integrates with adaptive step size. Each [`Step`] has dense output, which also locates events,
//! that is, sign changes of a function of the state. [`Collocation`] integrates systems that are too stiff
//! for explicit steps.

mod collocation;
mod dense;
mod dop853;
mod estimate;
mod registers;
mod root;
mod stiff;
pub(crate) mod tableau;

pub use collocation::{Collocation, POINTS, RADAU, solved};
pub use dense::Dense;
pub use dop853::Step;
pub use estimate::Estimate;
pub use root::{bracketed_root, bracketed_root_in};
pub use stiff::{Found, Implicit};

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

/// Integrates a system by steps whose estimated errors stay below a tolerance.
pub struct Stepper<'a, S, const N: usize> {
    system: &'a S,
    tolerance: f64,
    /// The size of the next step to try.
    h: f64,
    step: Step<f64, N>,
    /// Work so far.
    pub work: Work,
}

impl<'a, S: System<f64, N>, const N: usize> Stepper<'a, S, N> {
    /// A stepper at the initial state `u`; `h` is a first guess for the step size and need not be accurate.
    pub fn new(system: &'a S, u: [f64; N], h: f64, tolerance: f64) -> Self {
        Stepper {
            system,
            tolerance,
            h,
            step: Step::empty(&u, &system.rates(&u)),
            work: Work {
                evaluations: 1,
                ..Work::default()
            },
        }
    }

    /// Makes one step whose error is within the tolerance.
    ///
    /// The next step size is [`Estimate::next_factor`] times this one, limited to a factor from 1/5 to 8.
    ///
    /// # Errors
    /// Fails if the step size underflows.
    pub fn advance(&mut self) -> Result<&mut Step<f64, N>, Stuck> {
        let mut max_factor = 8.0;
        self.step.begin_next();
        loop {
            let estimate = self.step.attempt(self.system, self.h, self.tolerance);
            self.work.evaluations += Step::<f64, N>::EVALUATIONS;
            if estimate.is_accepted() {
                self.h *= estimate.next_factor().clamp(0.2, max_factor);
                self.work.steps += 1;
                return Ok(&mut self.step);
            }
            self.work.rejected += 1;
            max_factor = 1.0;
            self.h *= if estimate.is_finite() {
                estimate.next_factor().clamp(0.2, 1.0)
            } else {
                0.1
            };
            if self.h < 1e-280 || self.work.rejected > 1000 + 10 * self.work.steps {
                return Err(Stuck::StepUnderflow);
            }
        }
    }
}
