//! Integration by explicit steps of adaptive size.

#[cfg(doc)]
use super::ErrorEstimate;
use super::{Step, Stuck, System, Work};

/// Integrates a system by steps whose estimated errors stay below a tolerance.
pub struct Stepper<'a, S, const N: usize> {
    system: &'a S,
    tolerance: f64,
    /// The size of the next step to try.
    pub h: f64,
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
    /// The next step size is [`ErrorEstimate::next_factor`] times this one, limited to a factor from 1/5 to 8.
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
