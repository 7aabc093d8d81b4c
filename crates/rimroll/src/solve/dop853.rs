//! One step of the explicit Runge-Kutta method of order 8 by Dormand and Prince, with an error
//! estimate of orders 5 and 3 and dense output of order 7 (DOP853).
//!
//! Source: Hairer, Nørsett & Wanner, *Solving Ordinary Differential Equations I*, sections II.5,
//! II.6 and II.10. Use it for smooth systems at tolerances from 1e-5 down to rounding.

use super::tableau::{DENSE, ERROR_3, ERROR_5, EXTRA_STAGES, Row, SOLUTION, STAGES};
use super::{Dense, System};
use crate::real::Real;

/// A finished step from `start` to `end`.
#[derive(Debug, Clone)]
pub struct Step<T, const N: usize> {
    /// The step's length.
    pub h: T,
    /// State at the start.
    pub start: [T; N],
    /// State at the end.
    pub end: [T; N],
    /// The stages: 12 of the step, the slope at its end, 3 for the dense output.
    stages: [[T; N]; 16],
}

/// Σ weight · stage, summed in the order of the row.
#[inline(always)]
fn weigh<T: Real, const N: usize>(row: Row, stages: &[[T; N]; 16]) -> [T; N] {
    let mut sum = [T::from(0.0); N];
    for &(stage, weight) in row {
        let (stage, weight) = (&stages[stage], T::from(weight));
        for i in 0..N {
            sum[i] = sum[i] + weight * stage[i];
        }
    }
    sum
}

/// u + h Σ weight · stage.
#[inline(always)]
fn combine<T: Real, const N: usize>(u: &[T; N], h: T, row: Row, stages: &[[T; N]; 16]) -> [T; N] {
    let mut end = *u;
    let sum = weigh(row, stages);
    for i in 0..N {
        end[i] = end[i] + h * sum[i];
    }
    end
}

impl<T: Real, const N: usize> Step<T, N> {
    /// Evaluations of the right-hand side that a step costs, given the rates at its start.
    pub const EVALUATIONS: usize = 12;

    /// A step of length h from `start`, where the rates are `rates`.
    pub fn take(system: &impl System<T, N>, start: &[T; N], rates: &[T; N], h: T) -> Self {
        let mut step = Step::still(start, rates);
        step.attempt(system, h, 1.0);
        step
    }

    /// A step of no length, to begin from.
    pub fn still(start: &[T; N], rates: &[T; N]) -> Self {
        let mut stages = [[T::from(0.0); N]; 16];
        stages[0] = *rates;
        stages[12] = *rates;
        Step {
            h: T::from(0.0),
            start: *start,
            end: *start,
            stages,
        }
    }

    /// Begins the next step where this one has ended.
    #[inline(always)]
    pub fn begin_next(&mut self) {
        self.start = self.end;
        self.stages[0] = self.stages[12];
    }

    /// Goes from the start by the length h, whatever the step was before.
    #[inline(always)]
    pub(super) fn go<S: System<T, N>>(&mut self, system: &S, h: T) {
        let (start, stages) = (&self.start, &mut self.stages);
        // Written out, so that the weights are constants of the code.
        macro_rules! stages {
            ($($i:literal)*) => {
                $(stages[$i + 1] = system.rates(&combine(start, h, STAGES[$i], stages));)*
            };
        }
        stages!(0 1 2 3 4 5 6 7 8 9 10);
        self.h = h;
        self.end = combine(start, h, SOLUTION, stages);
        stages[12] = system.rates(&self.end);
    }

    /// Goes from the start by the length h, and gives the [`Self::error`].
    ///
    /// On processors that have wide registers they are used: the operations and their order stay the
    /// same, and so do the results.
    pub fn attempt<S: System<T, N>>(&mut self, system: &S, h: T, tolerance: f64) -> T {
        #[cfg(target_arch = "x86_64")]
        if std::arch::is_x86_feature_detected!("avx2") {
            // SAFETY: the processor has what is asked for.
            return unsafe { self.attempt_wide(system, h, tolerance) };
        }
        self.go(system, h);
        self.error(system, tolerance)
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2")]
    unsafe fn attempt_wide<S: System<T, N>>(&mut self, system: &S, h: T, tolerance: f64) -> T {
        self.go(system, h);
        self.error(system, tolerance)
    }

    /// Rates at the start.
    pub fn start_rates(&self) -> &[T; N] {
        &self.stages[0]
    }

    /// Rates at the end: the first stage of the next step.
    pub fn end_rates(&self) -> &[T; N] {
        &self.stages[12]
    }

    /// The estimated error over what the tolerance allows: the step is good when this is ≤ 1.
    #[inline(always)]
    pub fn error<S: System<T, N>>(&self, system: &S, tolerance: f64) -> T {
        let at_start = system.scale(&self.start);
        let at_end = system.scale(&self.end);
        let fifth = weigh(ERROR_5, &self.stages);
        let third = weigh(ERROR_3, &self.stages);
        let (mut sum5, mut sum3) = (T::from(0.0), T::from(0.0));
        for i in 0..N {
            let allowed = T::from(1.0) / (T::from(tolerance) * at_start[i].max(at_end[i]));
            let (fifth, third) = (fifth[i] * allowed, third[i] * allowed);
            sum5 = sum5 + fifth * fifth;
            sum3 = sum3 + third * third;
        }
        // Where nothing is wrong, not 0/0.
        const NEVER_ZERO: f64 = 1e-300;
        let both = (sum5 + T::from(0.01) * sum3) * T::from(N as f64);
        self.h * sum5 / both.max(T::from(NEVER_ZERO)).sqrt()
    }

    /// The step as a polynomial of its fraction; three more evaluations of the right-hand side.
    pub fn dense<S: System<T, N>>(&mut self, system: &S) -> Dense<T, N> {
        #[cfg(target_arch = "x86_64")]
        if std::arch::is_x86_feature_detected!("avx2") {
            // SAFETY: the processor has what is asked for.
            return unsafe { self.dense_wide(system) };
        }
        self.polynomial(system)
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2")]
    unsafe fn dense_wide<S: System<T, N>>(&mut self, system: &S) -> Dense<T, N> {
        self.polynomial(system)
    }

    #[inline(always)]
    fn polynomial<S: System<T, N>>(&mut self, system: &S) -> Dense<T, N> {
        for (i, row) in EXTRA_STAGES.iter().enumerate() {
            let at = combine(&self.start, self.h, row, &self.stages);
            self.stages[13 + i] = system.rates(&at);
        }
        let h = self.h;
        let rise: [T; N] = core::array::from_fn(|i| self.end[i] - self.start[i]);
        let first = self.stages[0].map(|rate| h * rate);
        let last = self.stages[12].map(|rate| h * rate);
        let mut coefficients = [rise; 7];
        coefficients[1] = core::array::from_fn(|i| first[i] - rise[i]);
        coefficients[2] = core::array::from_fn(|i| T::from(2.0) * rise[i] - (first[i] + last[i]));
        for (coefficient, row) in coefficients[3..].iter_mut().zip(&DENSE) {
            *coefficient = weigh(row, &self.stages).map(|v| h * v);
        }
        Dense {
            h,
            start: self.start,
            end: self.end,
            coefficients,
        }
    }
}
