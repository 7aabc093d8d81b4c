//! The antiderivative of a smooth function on a short interval.

use crate::real::Real;
use core::f64::consts::PI;

/// The integral of f from zero, by the Chebyshev interpolant of f at N points.
pub(super) struct Antiderivative<T, const N: usize> {
    /// Centre and half-length of the interval.
    middle: f64,
    half: f64,
    /// Coefficients of the Chebyshev polynomials T₁ … T_N.
    coefficients: [T; N],
    at_zero: T,
}

impl<T: Real, const N: usize> Antiderivative<T, N> {
    /// The antiderivative for arguments between `from` and `to`.
    pub(super) fn new(from: f64, to: f64, f: impl Fn(T) -> T) -> Self {
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let angle = |i: usize| PI * (i as f64 + 0.5) / N as f64;
        let values: [T; N] =
            core::array::from_fn(|i| f(T::from(middle + half * libm::cos(angle(i)))));
        let coefficient = |n: usize| {
            let weight = |i: usize| T::from(libm::cos(n as f64 * angle(i)) * 2.0 / N as f64);
            (0..N).fold(T::from(0.0), |sum, i| sum + weight(i) * values[i])
        };
        let of_f: [T; N] = core::array::from_fn(coefficient);
        let after = |n: usize| of_f.get(n + 1).map_or(T::from(0.0), |&next| next);
        let coefficients = core::array::from_fn(|i| {
            let n = i + 1;
            T::from(half / (2 * n) as f64) * (of_f[n - 1] - after(n))
        });
        let mut sum = Antiderivative {
            middle,
            half,
            coefficients,
            at_zero: T::from(0.0),
        };
        sum.at_zero = sum.at(T::from(0.0));
        sum
    }

    /// The integral from zero to x, by Clenshaw's recurrence.
    pub(super) fn at(&self, x: T) -> T {
        let u = (x - T::from(self.middle)) * T::from(1.0 / self.half);
        let (mut next, mut one_after) = (T::from(0.0), T::from(0.0));
        for &coefficient in self.coefficients.iter().rev() {
            let this = T::from(2.0) * u * next - one_after + coefficient;
            (next, one_after) = (this, next);
        }
        u * next - one_after - self.at_zero
    }
}
