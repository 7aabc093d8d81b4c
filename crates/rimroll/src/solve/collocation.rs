//! Collocation at the seven right Radau points: the solution is a polynomial of degree 7 that satisfies the
//! differential equations at the points. The method is implicit and suits stiff systems.
//!
//! Source: Hairer & Wanner, *Solving Ordinary Differential Equations II*, section IV.5 (Radau IIA,
//! stage order 7, order 13).

use super::Dense;
use crate::real::Real;
use std::sync::LazyLock;

/// The number of points.
pub const POINTS: usize = 7;

/// The zeros of P₇(2x − 1) − P₆(2x − 1) in (0, 1].
pub const RADAU: [f64; POINTS] = [
    0.029316427159784891972,
    0.14807859966848429185,
    0.3369846902811542991,
    0.55867151877155013208,
    0.76923386203005450092,
    0.92694567131974111485,
    1.0,
];

type Matrix = [[f64; POINTS]; POINTS];

/// The coefficients of the method.
pub struct Collocation {
    /// The Runge-Kutta matrix: a_ij is ∫₀^{c_i} of the Lagrange polynomial of the point j.
    pub integral: Matrix,
    /// Maps values at the points to their Legendre coefficient of degree 6.
    pub last: [f64; POINTS],
    /// Maps increments at the points, over a step of size 1, to that coefficient of the rate.
    pub last_of_rises: [f64; POINTS],
    /// Maps increments at the points to the coefficients of [`Dense`].
    to_dense: Matrix,
}

static RADAU_IIA: LazyLock<Collocation> = LazyLock::new(Collocation::computed);

impl Collocation {
    /// The method, whose coefficients are computed once.
    pub fn get() -> &'static Self {
        &RADAU_IIA
    }

    fn computed() -> Self {
        // Row i holds P₀ … P₇ at 2c_i − 1.
        let legendre = RADAU.map(|c| {
            let x = 2.0 * c - 1.0;
            let mut row = [1.0; POINTS + 1];
            row[1] = x;
            for k in 1..POINTS {
                let n = k as f64;
                row[k + 1] = ((2.0 * n + 1.0) * x * row[k] - n * row[k - 1]) / (n + 1.0);
            }
            row
        });
        let values: Matrix = legendre.map(|row| core::array::from_fn(|k| row[k]));
        // ∫ P_k(2x − 1) dx = (P_{k+1} − P_{k−1}) / (2 (2k + 1)), zero at x = 0.
        let integrals: Matrix = core::array::from_fn(|i| {
            core::array::from_fn(|k| match k {
                0 => RADAU[i],
                _ => (legendre[i][k + 1] - legendre[i][k - 1]) / (2.0 * (2 * k + 1) as f64),
            })
        });
        let to_legendre = inverse(&values);
        let dense_basis: Matrix = RADAU.map(|x| {
            let mut value = 1.0;
            core::array::from_fn(|j| {
                value *= if j % 2 == 0 { x } else { 1.0 - x };
                value
            })
        });
        let integral = product(&integrals, &to_legendre);
        let last = to_legendre[POINTS - 1];
        Collocation {
            last_of_rises: product(&[last; POINTS], &inverse(&integral))[0],
            integral,
            last,
            to_dense: inverse(&dense_basis),
        }
    }

    /// The step of size h that passes through `start` and the given states at the points.
    pub fn through<const N: usize>(
        &self,
        h: f64,
        start: &[f64; N],
        states: &[[f64; N]; POINTS],
    ) -> Dense<f64, N> {
        let mut coefficients = [[0.0; N]; POINTS];
        for (row, coefficient) in self.to_dense.iter().zip(&mut coefficients) {
            for (weight, state) in row.iter().zip(states) {
                for i in 0..N {
                    coefficient[i] += weight * (state[i] - start[i]);
                }
            }
        }
        Dense {
            h,
            start: *start,
            end: states[POINTS - 1],
            coefficients,
        }
    }
}

impl Collocation {
    /// The estimated error of a component over a step of size h, relative to its scale, from its rates at the points.
    /// The contribution of the highest Legendre polynomial bounds that of the omitted ones.
    #[inline(always)]
    pub fn error<T: Real>(&self, h: T, rates: &[T; POINTS], scale: T) -> T {
        let mut highest = T::from(0.0);
        for (weight, rate) in self.last.iter().zip(rates) {
            highest = highest + T::from(*weight) * *rate;
        }
        (T::from(0.05) * h * highest / scale).abs()
    }

    /// The part of a step up to the fraction x, as a separate step.
    pub fn cut<const N: usize>(&self, step: &Dense<f64, N>, x: f64) -> Dense<f64, N> {
        self.through(x * step.h, &step.start, &RADAU.map(|c| step.at(x * c)))
    }
}

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    core::array::from_fn(|i| core::array::from_fn(|j| (0..POINTS).map(|k| a[i][k] * b[k][j]).sum()))
}

fn inverse(matrix: &Matrix) -> Matrix {
    let mut columns = [[0.0; POINTS]; POINTS];
    for (j, column) in columns.iter_mut().enumerate() {
        let mut unit = [0.0; POINTS];
        unit[j] = 1.0;
        *column = solved(*matrix, unit);
    }
    core::array::from_fn(|i| core::array::from_fn(|j| columns[j][i]))
}

/// The solution x of `matrix` x = `right`, by Gaussian elimination with partial pivoting.
pub fn solved(mut matrix: Matrix, mut right: [f64; POINTS]) -> [f64; POINTS] {
    for i in 0..POINTS {
        let mut pivot = i;
        for row in i + 1..POINTS {
            if matrix[row][i].abs() > matrix[pivot][i].abs() {
                pivot = row;
            }
        }
        matrix.swap(i, pivot);
        right.swap(i, pivot);
        let (done, below) = matrix.split_at_mut(i + 1);
        for (row, value) in below.iter_mut().zip(i + 1..) {
            let factor = row[i] / done[i][i];
            for (element, above) in row.iter_mut().zip(&done[i]) {
                *element -= factor * above;
            }
            right[value] -= factor * right[i];
        }
    }
    for i in (0..POINTS).rev() {
        for k in i + 1..POINTS {
            right[i] -= matrix[i][k] * right[k];
        }
        right[i] /= matrix[i][i];
    }
    right
}

#[cfg(test)]
mod tests {
    use super::{Collocation, POINTS, RADAU};

    #[test]
    fn integrates_powers_exactly_and_passes_through_its_points() {
        let method = Collocation::get();
        for power in 0..POINTS as u32 {
            let f = RADAU.map(|c| (0..power).fold(1.0, |product, _| product * c));
            for i in 0..POINTS {
                let sum: f64 = (0..POINTS).map(|j| method.integral[i][j] * f[j]).sum();
                let exact = f[i] * RADAU[i] / f64::from(power + 1);
                assert!((sum - exact).abs() < 1e-14, "{power} {i}: {sum} {exact}");
            }
        }
        let states = RADAU.map(|c| [1.0 + c * c * c, c]);
        let dense = method.through(0.3, &[1.0, 0.0], &states);
        for x in [0.0, 0.2, 0.7, 1.0] {
            assert!((dense.at(x)[0] - 1.0 - x * x * x).abs() < 1e-14);
        }
    }
}
