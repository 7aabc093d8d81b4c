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

/// Σ weight · stage of the first `count` components, summed in the order of the row.
#[inline(always)]
fn weigh<T: Real, const N: usize>(row: Row, stages: &[[T; N]; 16], count: usize) -> [T; N] {
    let mut sum = [T::from(0.0); N];
    for &(stage, weight) in row {
        let (stage, weight) = (&stages[stage], T::from(weight));
        for i in 0..count {
            sum[i] = sum[i] + weight * stage[i];
        }
    }
    sum
}

/// u + h Σ weight · stage.
#[inline(always)]
fn combine<T: Real, const N: usize>(
    u: &[T; N],
    h: T,
    row: Row,
    stages: &[[T; N]; 16],
    count: usize,
) -> [T; N] {
    let mut end = *u;
    let sum = weigh(row, stages, count);
    for i in 0..N {
        end[i] = end[i] + h * sum[i];
    }
    end
}

impl<T: Real, const N: usize> Step<T, N> {
    /// Evaluations of the right-hand side that a step costs, given the rates at its start.
    pub const EVALUATIONS: usize = 12;

    /// A step of length h from `start`, where the rates are `rates`.
    pub fn take<S: System<T, N>>(system: &S, start: &[T; N], rates: &[T; N], h: T) -> Self {
        // Each with a count that is known when it is compiled.
        if system.only_first() {
            Self::take_first(S::FIRST, system, start, rates, h)
        } else {
            Self::take_first(N, system, start, rates, h)
        }
    }

    #[inline(always)]
    fn take_first<S: System<T, N>>(
        count: usize,
        system: &S,
        start: &[T; N],
        rates: &[T; N],
        h: T,
    ) -> Self {
        let mut stages = [[T::from(0.0); N]; 16];
        stages[0] = *rates;
        // Written out, so that the weights are constants of the code.
        macro_rules! stages {
            ($($i:literal)*) => {
                $(stages[$i + 1] = system.rates(&combine(start, h, STAGES[$i], &stages, count));)*
            };
        }
        stages!(0 1 2 3 4 5 6 7 8 9 10);
        let end = combine(start, h, SOLUTION, &stages, count);
        stages[12] = system.rates(&end);
        Step {
            h,
            start: *start,
            end,
            stages,
        }
    }

    /// Rates at the end: the first stage of the next step.
    pub fn end_rates(&self) -> &[T; N] {
        &self.stages[12]
    }

    /// The estimated error over what the tolerance allows: the step is good when this is ≤ 1.
    #[inline]
    pub fn error<S: System<T, N>>(&self, system: &S, tolerance: f64) -> T {
        let at_start = system.scale(&self.start);
        let at_end = system.scale(&self.end);
        let count = system.changing();
        let fifth = weigh(ERROR_5, &self.stages, count);
        let third = weigh(ERROR_3, &self.stages, count);
        let (mut sum5, mut sum3) = (T::from(0.0), T::from(0.0));
        for i in 0..count {
            let allowed = T::from(tolerance) * at_start[i].max(at_end[i]);
            sum5 = sum5 + (fifth[i] / allowed) * (fifth[i] / allowed);
            sum3 = sum3 + (third[i] / allowed) * (third[i] / allowed);
        }
        // Where nothing is wrong, not 0/0.
        const NEVER_ZERO: f64 = 1e-300;
        let both = (sum5 + T::from(0.01) * sum3) * T::from(count as f64);
        self.h * sum5 / both.max(T::from(NEVER_ZERO)).sqrt()
    }

    /// The same step cut at the fraction x: a step of its own, so of the full order, not an
    /// interpolation.
    pub fn cut(&self, system: &impl System<T, N>, x: T) -> Self {
        Step::take(system, &self.start, &self.stages[0], x * self.h)
    }

    /// The step as a polynomial of its fraction; three more evaluations of the right-hand side.
    pub fn dense(&mut self, system: &impl System<T, N>) -> Dense<T, N> {
        let count = system.changing();
        for (i, row) in EXTRA_STAGES.iter().enumerate() {
            let at = combine(&self.start, self.h, row, &self.stages, count);
            self.stages[13 + i] = system.rates(&at);
        }
        let h = self.h;
        let mut coefficients = [[T::from(0.0); N]; 7];
        let rise: [T; N] = core::array::from_fn(|i| self.end[i] - self.start[i]);
        let first = self.stages[0].map(|rate| h * rate);
        let last = self.stages[12].map(|rate| h * rate);
        coefficients[0] = rise;
        coefficients[1] = core::array::from_fn(|i| first[i] - rise[i]);
        coefficients[2] = core::array::from_fn(|i| T::from(2.0) * rise[i] - (first[i] + last[i]));
        for (j, row) in DENSE.iter().enumerate() {
            coefficients[3 + j] = weigh(row, &self.stages, count).map(|v| h * v);
        }
        Dense {
            h,
            start: self.start,
            end: self.end,
            coefficients,
        }
    }
}
