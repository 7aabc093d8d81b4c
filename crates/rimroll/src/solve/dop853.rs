//! One step of the explicit Runge-Kutta method of order 8 by Dormand and Prince, with an error
//! estimate of orders 5 and 3 and dense output of order 7 (DOP853).
//!
//! Source: Hairer, Nørsett & Wanner, *Solving Ordinary Differential Equations I*, sections II.5,
//! II.6 and II.10. Use it for smooth systems at tolerances from 1e-5 down to rounding.

use super::tableau::{DENSE, ERROR_3, ERROR_5, EXTRA_STAGES, Row, SOLUTION, STAGES};
use super::{Dense, System};

/// A finished step from `start` to `end`.
#[derive(Debug, Clone)]
pub struct Step<const N: usize> {
    /// The step's length.
    pub h: f64,
    /// State at the start.
    pub start: [f64; N],
    /// State at the end.
    pub end: [f64; N],
    /// Rates at the end: the first stage of the next step.
    pub end_rates: [f64; N],
    /// The stages: 12 of the step, the slope at its end, 3 for the dense output.
    stages: [[f64; N]; 16],
}

/// u + h Σ weight · stage, summed in the order of the row.
fn combine<S: System<N>, const N: usize>(
    system: &S,
    u: &[f64; N],
    h: f64,
    row: Row,
    stages: &[[f64; N]],
) -> [f64; N] {
    let mut end = *u;
    let sum = weigh(system, row, stages);
    for i in 0..N {
        end[i] += h * sum[i];
    }
    end
}

fn weigh<S: System<N>, const N: usize>(system: &S, row: Row, stages: &[[f64; N]]) -> [f64; N] {
    // Each with a count that is known when it is compiled.
    if system.only_first() {
        weigh_first(S::FIRST, row, stages)
    } else {
        weigh_first(N, row, stages)
    }
}

#[inline(always)]
fn weigh_first<const N: usize>(count: usize, row: Row, stages: &[[f64; N]]) -> [f64; N] {
    let mut sum = [0.0; N];
    for &(stage, weight) in row {
        let stage = &stages[stage];
        for i in 0..count {
            sum[i] += weight * stage[i];
        }
    }
    sum
}

impl<const N: usize> Step<N> {
    /// Evaluations of the right-hand side that a step costs, given the rates at its start.
    pub const EVALUATIONS: usize = 12;

    /// A step of length h from `start`, where the rates are `rates`.
    pub fn take(system: &impl System<N>, start: &[f64; N], rates: &[f64; N], h: f64) -> Step<N> {
        let mut stages = [[0.0; N]; 16];
        stages[0] = *rates;
        for (i, row) in STAGES.iter().enumerate() {
            stages[i + 1] = system.rates(&combine(system, start, h, row, &stages));
        }
        let end = combine(system, start, h, SOLUTION, &stages);
        let end_rates = system.rates(&end);
        stages[12] = end_rates;
        Step {
            h,
            start: *start,
            end,
            end_rates,
            stages,
        }
    }

    /// The estimated error over what the tolerance allows: the step is good when this is ≤ 1.
    pub(super) fn error<S: System<N>>(&self, system: &S, tolerance: f64) -> f64 {
        let at_start = system.scale(&self.start);
        let at_end = system.scale(&self.end);
        let fifth = weigh(system, ERROR_5, &self.stages);
        let third = weigh(system, ERROR_3, &self.stages);
        let count = system.changing();
        let (mut sum5, mut sum3) = (0.0, 0.0);
        for i in 0..count {
            let allowed = tolerance * at_start[i].max(at_end[i]);
            sum5 += (fifth[i] / allowed) * (fifth[i] / allowed);
            sum3 += (third[i] / allowed) * (third[i] / allowed);
        }
        if sum5 == 0.0 {
            return 0.0;
        }
        self.h * sum5 / ((sum5 + 0.01 * sum3) * count as f64).sqrt()
    }

    /// The same step cut at the fraction x: a step of its own, so of the full order, not an
    /// interpolation.
    pub fn cut(&self, system: &impl System<N>, x: f64) -> Step<N> {
        Step::take(system, &self.start, &self.stages[0], x * self.h)
    }

    /// The step as a polynomial of its fraction; three more evaluations of the right-hand side.
    pub fn dense(&mut self, system: &impl System<N>) -> Dense<N> {
        for (i, row) in EXTRA_STAGES.iter().enumerate() {
            let at = combine(system, &self.start, self.h, row, &self.stages);
            self.stages[13 + i] = system.rates(&at);
        }
        let h = self.h;
        let rise: [f64; N] = core::array::from_fn(|i| self.end[i] - self.start[i]);
        let mut coefficients = [[0.0; N]; 7];
        for i in 0..N {
            let (first, last) = (h * self.stages[0][i], h * self.end_rates[i]);
            coefficients[0][i] = rise[i];
            coefficients[1][i] = first - rise[i];
            coefficients[2][i] = 2.0 * rise[i] - (first + last);
        }
        for (j, row) in DENSE.iter().enumerate() {
            coefficients[3 + j] = weigh(system, row, &self.stages).map(|v| h * v);
        }
        Dense {
            h,
            start: self.start,
            end: self.end,
            coefficients,
        }
    }
}
