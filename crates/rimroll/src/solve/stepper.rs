//! Integration by explicit steps of adaptive size.

use super::{Step, Stuck, System, Work};
use crate::real::{FloatBits, Real};

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

/// The estimated error of a step. The step is accepted if `error_squared` ≤ `allowed`.
#[derive(Debug, Clone, Copy)]
pub struct ErrorEstimate<T> {
    /// The square of the error relative to the tolerance, times `allowed`.
    pub error_squared: T,
    /// The bound of `error_squared`. Keeping both avoids a division.
    pub allowed: T,
}

impl<T: Real> ErrorEstimate<T> {
    /// The estimate for a step of size h with `count` components (Hairer, Nørsett & Wanner 1993, section
    /// II.10). `fifth` and `third` are the sums of the squares of the error estimates of orders 5 and 3, each
    /// divided by h and by the allowed error of the component.
    #[inline(always)]
    pub fn new(h: T, fifth: T, third: T, count: usize) -> Self {
        // Avoids 0/0 where both estimates are zero.
        const NEVER_ZERO: f64 = 1e-300;
        let both = (fifth + T::from(0.01) * third) * T::from(count as f64);
        let error = h * fifth;
        ErrorEstimate {
            error_squared: error * error,
            allowed: both.max(T::from(NEVER_ZERO)),
        }
    }
}

impl ErrorEstimate<f64> {
    /// Whether the error is finite.
    #[inline]
    pub fn is_finite(&self) -> bool {
        // A NaN compares as false.
        self.error_squared < f64::INFINITY
    }

    /// The square of the error relative to the tolerance.
    #[inline]
    pub fn relative_squared(&self) -> f64 {
        self.error_squared / self.allowed
    }

    /// Whether the step is accepted.
    #[inline]
    pub fn is_accepted(&self) -> bool {
        self.is_finite() && self.error_squared <= self.allowed
    }
}

impl<T: FloatBits> ErrorEstimate<T> {
    /// The factor 0.9 e^(−1/8) from this step size to the next, where e is the error relative to the
    /// tolerance (section II.4).
    ///
    /// The next step has to wait for this number, so a cheap approximation of the root is used. It is up to
    /// 6 % too large; the margin of 0.86 in place of 0.9 compensates for the typical excess.
    #[inline(always)]
    pub fn next_factor(&self) -> T {
        const MARGIN: f64 = 0.86;
        T::from(MARGIN) * T::approx_16th_root_of(self.allowed, self.error_squared)
    }
}
