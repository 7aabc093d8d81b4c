//! A solver for smooth autonomous systems u′ = f(u): it knows no mechanics.
//!
//! [`Stepper`] advances by steps of its own choice; each [`Step`] can be evaluated anywhere inside
//! (dense output) and asked where a function of the state changes sign (events). What relaxes too fast
//! for explicit steps is done by [`Collocation`].

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
pub use stiff::Implicit;

use crate::real::Real;

/// An autonomous system of N first-order equations, in numbers of the type T: each lane of lanes, and the
/// slopes of dual numbers, go with the steps of their values.
pub trait System<T: Real, const N: usize> {
    /// How many components, the first, no rate and no size depends on: inside a step they are as they
    /// were at its start, in what is given to `rates` and to `scale`.
    const IGNORABLE: usize = 0;

    /// u′ = f(u).
    fn rates(&self, u: &[T; N]) -> [T; N];

    /// For each component the size that an error is to be compared with.
    fn scale(&self, u: &[T; N]) -> [T; N];
}

/// Why no further step could be made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stuck {
    /// The rates are not finite or change too fast for any step.
    StepUnderflow,
}

/// How much work was done.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Work {
    /// Steps accepted.
    pub steps: usize,
    /// Steps tried again shorter.
    pub rejected: usize,
    /// Evaluations of the right-hand side.
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

/// Steps through a system with the error of each step held below a tolerance.
pub struct Stepper<'a, S, const N: usize> {
    system: &'a S,
    tolerance: f64,
    /// Length of the next step to try.
    h: f64,
    step: Step<f64, N>,
    /// Work so far.
    pub work: Work,
}

impl<'a, S: System<f64, N>, const N: usize> Stepper<'a, S, N> {
    /// A solver at the start `u`; `h` is a first guess for the step and need not be good.
    pub fn new(system: &'a S, u: [f64; N], h: f64, tolerance: f64) -> Self {
        Stepper {
            system,
            tolerance,
            h,
            step: Step::still(&u, &system.rates(&u)),
            work: Work {
                evaluations: 1,
                ..Work::default()
            },
        }
    }

    /// Makes one step, as long as the tolerance allows.
    ///
    /// The next step is [`Estimate::next_factor`] times as long, within a factor of 5 down and 8 up.
    ///
    /// # Errors
    /// When no step is short enough.
    pub fn advance(&mut self) -> Result<&mut Step<f64, N>, Stuck> {
        let mut grow_at_most = 8.0;
        self.step.begin_next();
        loop {
            let estimate = self.step.attempt(self.system, self.h, self.tolerance);
            self.work.evaluations += Step::<f64, N>::EVALUATIONS;
            if estimate.is_good() {
                self.h *= estimate.next_factor().clamp(0.2, grow_at_most);
                self.work.steps += 1;
                return Ok(&mut self.step);
            }
            self.work.rejected += 1;
            grow_at_most = 1.0;
            self.h *= if estimate.is_number() {
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
