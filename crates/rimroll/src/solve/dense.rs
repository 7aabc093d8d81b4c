//! A finished step as a polynomial: dense output.

use super::root;
use crate::real::Real;

/// A step that can be evaluated at any fraction x in [0, 1].
#[derive(Debug, Clone)]
pub struct Dense<T, const N: usize> {
    /// The step's length.
    pub h: T,
    /// State at x = 0.
    pub start: [T; N],
    /// State at x = 1.
    pub end: [T; N],
    /// c₀ … c₆ of the rise x (c₀ + (1 − x) (c₁ + x (c₂ + (1 − x) (c₃ + …)))).
    pub(super) coefficients: [[T; N]; 7],
}

impl<T: Real, const N: usize> Dense<T, N> {
    /// A step of no length.
    pub fn still(state: [T; N]) -> Self {
        Dense {
            h: T::from(0.0),
            start: state,
            end: state,
            coefficients: [[T::from(0.0); N]; 7],
        }
    }

    /// The same with components that stay what they are in `rest`, after the first N.
    pub fn widened<const M: usize>(&self, rest: &[T; M]) -> Dense<T, M> {
        let widened = |first: &[T; N], rest: &[T; M]| {
            let mut all = *rest;
            all[..N].copy_from_slice(first);
            all
        };
        Dense {
            h: self.h,
            start: widened(&self.start, rest),
            end: widened(&self.end, rest),
            coefficients: self
                .coefficients
                .map(|coefficient| widened(&coefficient, &[T::from(0.0); M])),
        }
    }

    /// The state at the fraction x.
    pub fn at(&self, x: T) -> [T; N] {
        core::array::from_fn(|i| self.component(i, x))
    }

    /// One component of the state at the fraction x.
    pub fn component(&self, i: usize, x: T) -> T {
        let mut sum = T::from(0.0);
        for (j, coefficient) in self.coefficients.iter().enumerate().rev() {
            let factor = if j % 2 == 0 { x } else { T::from(1.0) - x };
            sum = (sum + coefficient[i]) * factor;
        }
        self.start[i] + sum
    }
}

impl<const N: usize> Dense<f64, N> {
    /// The fraction between `from` and `to` where `function` of the state changes sign.
    pub fn root(&self, from: f64, to: f64, function: impl Fn(&[f64; N]) -> f64) -> f64 {
        root::bracketed_root(from, to, |x| function(&self.at(x)))
    }

    /// The fraction at which a component that grows over the step has the given value.
    pub fn where_component(&self, i: usize, value: f64) -> f64 {
        root::bracketed_root(0.0, 1.0, |x| self.component(i, x) - value)
    }
}
