//! Derivatives over a step whose dense output is a polynomial: an implicit step, or one at the onset of a slip.
//!
//! With z the derivative of the coordinates at a fixed time, f their rates with respect to the time and x the fraction of
//! the step,
//!
//! ```text
//! dz/dx = dt/dx (∂f/∂u z + ∂f/∂θ)
//! ```
//!
//! along the known step. This linear equation is solved by [`Collocation`] at the points of the step, which suits stiff
//! laws. At the onset of a slip the direction of friction changes with the slip at a rate that grows without bound; the
//! first point of the method is inside the step, and the polynomial is the one solution that stays regular.

use super::shaken_slope::Number;
use crate::motion::step_record::Polynomial;
use crate::real::{Dual, Slopes};
use crate::solve::{Collocation, POINTS, RADAU};
use crate::state::{COORDINATES, Coordinates};

/// The number of parameters.
const K: usize = super::SHAKEN_PARAMETERS.len();

/// The number of unknowns: all coordinates at all points.
const UNKNOWNS: usize = POINTS * COORDINATES;

/// The rates with respect to the time, as functions of the coordinates.
pub(super) struct Linearised<P, C> {
    /// With the derivatives of the parameters.
    pub(super) varied: P,
    /// With constant parameters.
    pub(super) constant: C,
}

impl<P, C> Linearised<P, C>
where
    P: Fn(&Coordinates<Number>) -> Coordinates<Number>,
    C: Fn(&Coordinates<Number>) -> Coordinates<Number>,
{
    /// The coordinates at the fraction x of a step, with their derivatives at a fixed time, given those at its start.
    /// `time_rates` are dt/dx at the points.
    pub(super) fn followed(
        &self,
        dense: &Polynomial,
        time_rates: &[f64; POINTS],
        start: &Coordinates<Number>,
        x: f64,
    ) -> Coordinates<Number> {
        let method = Collocation::get();
        let start_slopes = start.into_array().map(|dual| dual.slope.0);
        let mut matrix = vec![[0.0; UNKNOWNS]; UNKNOWNS];
        let mut right = vec![[0.0; K]; UNKNOWNS];
        for (i, row) in matrix.iter_mut().enumerate() {
            row[i] = 1.0;
            right[i] = start_slopes[i % COORDINATES];
        }
        for j in 0..POINTS {
            let u = dense.at(RADAU[j]);
            let (jacobian, forcing) = (self.jacobian(&u), self.forcing(&u));
            for i in 0..POINTS {
                let weight = method.integral[i][j] * time_rates[j];
                for a in 0..COORDINATES {
                    let row = i * COORDINATES + a;
                    for b in 0..COORDINATES {
                        matrix[row][j * COORDINATES + b] -= weight * jacobian[a][b];
                    }
                    for (sum, rate) in right[row].iter_mut().zip(forcing[a]) {
                        *sum += weight * rate;
                    }
                }
            }
        }
        solve(&mut matrix, &mut right);
        let values = dense.at(x);
        let slopes: [[f64; COORDINATES]; K] = core::array::from_fn(|parameter| {
            let states = core::array::from_fn(|j| {
                core::array::from_fn(|a| right[j * COORDINATES + a][parameter])
            });
            if x == 1.0 {
                return states[POINTS - 1];
            }
            let start = start_slopes.map(|slopes| slopes[parameter]);
            method.through(1.0, &start, &states).at(x)
        });
        Coordinates::from_array(&core::array::from_fn(|a| Dual {
            value: values[a],
            slope: Slopes(core::array::from_fn(|parameter| slopes[parameter][a])),
        }))
    }

    /// ∂f/∂θ.
    fn forcing(&self, u: &[f64; COORDINATES]) -> [[f64; K]; COORDINATES] {
        let rates = (self.varied)(&Coordinates::from_array(&u.map(Number::from)));
        rates.into_array().map(|rate| rate.slope.0)
    }

    /// `[a][b]` is the derivative of the rate of coordinate a with respect to coordinate b.
    fn jacobian(&self, u: &[f64; COORDINATES]) -> [[f64; COORDINATES]; COORDINATES] {
        let mut jacobian = [[0.0; COORDINATES]; COORDINATES];
        for first in (0..COORDINATES).step_by(K) {
            let seeded = core::array::from_fn(|b| Dual {
                value: u[b],
                slope: Slopes(core::array::from_fn(|k| f64::from(first + k == b))),
            });
            let rates = (self.constant)(&Coordinates::from_array(&seeded)).into_array();
            for (row, rate) in jacobian.iter_mut().zip(rates) {
                for (entry, slope) in row[first..].iter_mut().zip(rate.slope.0) {
                    *entry = slope;
                }
            }
        }
        jacobian
    }
}

/// Solves linear equations in place, by Gaussian elimination with pivots that are largest in relation to their rows.
fn solve(matrix: &mut [[f64; UNKNOWNS]], right: &mut [[f64; K]]) {
    for (row, right) in matrix.iter_mut().zip(right.iter_mut()) {
        let largest = row.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
        row.iter_mut().for_each(|x| *x /= largest);
        right.iter_mut().for_each(|x| *x /= largest);
    }
    for i in 0..UNKNOWNS {
        let by_size = |a: &usize, b: &usize| matrix[*a][i].abs().total_cmp(&matrix[*b][i].abs());
        let pivot = (i..UNKNOWNS).max_by(by_size).unwrap_or(i);
        matrix.swap(i, pivot);
        right.swap(i, pivot);
        let (above, below) = matrix.split_at_mut(i + 1);
        let (right_above, right_below) = right.split_at_mut(i + 1);
        for (row, right) in below.iter_mut().zip(right_below) {
            let factor = row[i] / above[i][i];
            if factor == 0.0 {
                continue;
            }
            for (entry, pivot) in row[i..].iter_mut().zip(&above[i][i..]) {
                *entry -= factor * pivot;
            }
            for (entry, pivot) in right.iter_mut().zip(right_above[i]) {
                *entry -= factor * pivot;
            }
        }
    }
    for i in (0..UNKNOWNS).rev() {
        for j in i + 1..UNKNOWNS {
            let factor = matrix[i][j];
            let solved = right[j];
            for (entry, solved) in right[i].iter_mut().zip(solved) {
                *entry -= factor * solved;
            }
        }
        let pivot = matrix[i][i];
        right[i].iter_mut().for_each(|entry| *entry /= pivot);
    }
}
