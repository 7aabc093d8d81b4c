//! The explicit Runge-Kutta methods of the steps from sample to sample: the pair of orders 5 and 4 by Dormand and Prince
//! with a third solution of order 3, and their method of order 8 ([`tableau`]).
//!
//! Source: Hairer, Nørsett & Wanner, *Solving Ordinary Differential Equations I*, table II.5.2. The third solution is
//! the quadrature of order 3 at the nodes 0, 3/10 and 1. As for the method of order 8 (section II.10), the error is
//! estimated from the differences to both, so that it has the order of the step's own error.

use crate::real::Real;
use crate::solve::ErrorEstimate;
use crate::solve::tableau::{self, Row};

/// The weights of the earlier stages in the argument of each stage. The last row is the solution.
pub(super) const ORDER_5: [Row; 6] = [
    &[(0, 1.0 / 5.0)],
    &[(0, 3.0 / 40.0), (1, 9.0 / 40.0)],
    &[(0, 44.0 / 45.0), (1, -56.0 / 15.0), (2, 32.0 / 9.0)],
    &[
        (0, 19_372.0 / 6_561.0),
        (1, -25_360.0 / 2_187.0),
        (2, 64_448.0 / 6_561.0),
        (3, -212.0 / 729.0),
    ],
    &[
        (0, 9_017.0 / 3_168.0),
        (1, -355.0 / 33.0),
        (2, 46_732.0 / 5_247.0),
        (3, 49.0 / 176.0),
        (4, -5_103.0 / 18_656.0),
    ],
    &[
        (0, 35.0 / 384.0),
        (2, 500.0 / 1_113.0),
        (3, 125.0 / 192.0),
        (4, -2_187.0 / 6_784.0),
        (5, 11.0 / 84.0),
    ],
];

/// The solution of order 5 less those of order 4 and of order 3.
pub(super) const ERRORS_OF_5: [Row; 2] = [
    &[
        (0, 71.0 / 57_600.0),
        (2, -71.0 / 16_695.0),
        (3, 71.0 / 1_920.0),
        (4, -17_253.0 / 339_200.0),
        (5, 22.0 / 525.0),
        (6, -1.0 / 40.0),
    ],
    &[
        (0, 35.0 / 384.0 + 1.0 / 18.0),
        (2, 500.0 / 1_113.0 - 50.0 / 63.0),
        (3, 125.0 / 192.0),
        (4, -2_187.0 / 6_784.0),
        (5, 11.0 / 84.0),
        (6, -11.0 / 42.0),
    ],
];

/// The rows of the method of order 8, in the form of [`ORDER_5`].
pub(super) const ORDER_8: [Row; 12] = {
    let mut rows = [tableau::SOLUTION; 12];
    let mut i = 0;
    while i < tableau::STAGES.len() {
        rows[i] = tableau::STAGES[i];
        i += 1;
    }
    rows
};
pub(super) const ERRORS_OF_8: [Row; 2] = [tableau::ERROR_5, tableau::ERROR_3];

/// The largest number of stages of a step: the rates at its start, at its inner nodes and at its end.
pub(super) const MAX_STAGES: usize = 13;

pub(super) type Stages<T, const N: usize> = [[T; N]; MAX_STAGES];

/// The node of a stage, as a fraction of the step.
pub(super) const fn node(row: Row) -> f64 {
    let (mut sum, mut i) = (0.0, 0);
    while i < row.len() {
        sum += row[i].1;
        i += 1;
    }
    sum
}

/// The first `count` coordinates of the argument of a stage. The others have their values at the start.
#[inline(always)]
pub(super) fn argument<T: Real, const N: usize>(
    row: Row,
    u: &[T; N],
    h: T,
    stages: &Stages<T, N>,
    count: usize,
) -> [T; N] {
    let mut all = *u;
    for (i, argument) in all.iter_mut().enumerate().take(count) {
        *argument = *argument + h * sum(row, stages, i);
    }
    all
}

/// Σ weight · stage of a coordinate. The terms are unrolled, so that the weights are compile-time constants.
#[inline(always)]
fn sum<T: Real, const N: usize>(row: Row, stages: &Stages<T, N>, i: usize) -> T {
    let (first, weight) = row[0];
    let mut sum = T::from(weight) * stages[first][i];
    macro_rules! add {
        ($($term:literal)*) => {
            $(if let Some(&(stage, weight)) = row.get($term) {
                sum = sum + T::from(weight) * stages[stage][i];
            })*
        };
    }
    add!(1 2 3 4 5 6 7 8);
    sum
}

/// The estimate of the error of the first M coordinates relative to the allowed errors, given by their reciprocals.
#[expect(
    clippy::needless_range_loop,
    reason = "an iterator's closures might not be inlined"
)]
#[inline(always)]
pub(super) fn estimate<T: Real, const N: usize, const M: usize>(
    [higher, lower]: [Row; 2],
    h: T,
    stages: &Stages<T, N>,
    per_allowed: &[T; M],
) -> ErrorEstimate<T> {
    let (mut high, mut low) = (T::from(0.0), T::from(0.0));
    for i in 0..M {
        let e = sum(higher, stages, i) * per_allowed[i];
        let f = sum(lower, stages, i) * per_allowed[i];
        high = high + e * e;
        low = low + f * f;
    }
    ErrorEstimate::new(h, high, low, M)
}

#[cfg(test)]
mod tests {
    use super::{ERRORS_OF_5, ERRORS_OF_8, MAX_STAGES, ORDER_5, ORDER_8, Row, Stages, argument};
    use super::{estimate, node};

    /// The error of a step of the pendulum u″ = −sin u, and its estimate.
    fn step(rows: &[Row], errors: [Row; 2], h: f64) -> (f64, f64) {
        let rates = |[u, v]: [f64; 2]| [v, -libm::sin(u)];
        let follow = |start: [f64; 2], h: f64| {
            let mut stages: Stages<f64, 2> = [rates(start); MAX_STAGES];
            let mut end = start;
            for (i, row) in rows.iter().enumerate() {
                end = argument(row, &start, h, &stages, 2);
                stages[i + 1] = rates(end);
            }
            (end, stages)
        };
        let start = [1.0, 0.3];
        let (end, stages) = follow(start, h);
        let exact = (0..64).fold(start, |u, _| follow(u, h / 64.0).0);
        let error = libm::hypot(end[0] - exact[0], end[1] - exact[1]);
        let estimate = estimate(errors, h, &stages, &[1.0; 2]);
        (error, estimate.relative_squared().sqrt())
    }

    #[test]
    fn steps_and_their_estimates_have_their_orders() {
        for (rows, errors, h, orders) in [
            (&ORDER_5[..], ERRORS_OF_5, 0.4, [6, 6]),
            (&ORDER_8[..], ERRORS_OF_8, 0.5, [9, 8]),
        ] {
            let ((error, guess), (half, half_guess)) =
                (step(rows, errors, h), step(rows, errors, 0.5 * h));
            for (ratio, order) in [error / half, guess / half_guess].into_iter().zip(orders) {
                let expected = f64::from(1 << order);
                assert!((0.3..3.0).contains(&(ratio / expected)), "{ratio}");
            }
            assert!((0.1..100.0).contains(&(guess / error)), "{}", guess / error);
        }
    }

    #[test]
    fn the_nodes_are_those_of_the_methods() {
        let nodes = ORDER_5.map(node);
        for (node, expected) in nodes.iter().zip([0.2, 0.3, 0.8, 8.0 / 9.0, 1.0, 1.0]) {
            assert!((node - expected).abs() < 1e-14);
        }
        assert!((node(ORDER_8[4]) - 1.0 / 3.0).abs() < 1e-14);
        assert!((node(ORDER_8[11]) - 1.0).abs() < 1e-14);
    }
}
