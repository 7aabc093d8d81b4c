//! Dense output: a finished step as a polynomial.

use super::root;
use crate::real::Real;

/// The polynomial of a step, which can be evaluated at any fraction x in [0, 1] of the step.
#[derive(Debug, Clone)]
pub struct Dense<T, const N: usize> {
    /// The step size.
    pub h: T,
    /// State at x = 0.
    pub start: [T; N],
    /// State at x = 1.
    pub end: [T; N],
    /// c₀ … c₆ of the increment x (c₀ + (1 − x) (c₁ + x (c₂ + (1 − x) (c₃ + …)))).
    pub(super) coefficients: [[T; N]; 7],
}

impl<T: Real, const N: usize> Dense<T, N> {
    /// A step of size zero.
    pub fn empty(state: [T; N]) -> Self {
        Dense {
            h: T::from(0.0),
            start: state,
            end: state,
            coefficients: [[T::from(0.0); N]; 7],
        }
    }

    /// This step with M components, of which those after the first N keep their values in `constant`.
    pub fn widened<const M: usize>(&self, constant: &[T; M]) -> Dense<T, M> {
        let widened = |leading: &[T; N], constant: &[T; M]| {
            let mut components = *constant;
            components[..N].copy_from_slice(leading);
            components
        };
        Dense {
            h: self.h,
            start: widened(&self.start, constant),
            end: widened(&self.end, constant),
            coefficients: self
                .coefficients
                .map(|coefficient| widened(&coefficient, &[T::from(0.0); M])),
        }
    }

    /// The N components of this step among M, at the given places. The others keep their values in `constant`.
    pub fn placed<const M: usize>(&self, constant: &[T; M], places: &[usize; N]) -> Dense<T, M> {
        let placed = |components: &[T; N], constant: &[T; M]| {
            let mut all = *constant;
            for (component, &place) in components.iter().zip(places) {
                all[place] = *component;
            }
            all
        };
        Dense {
            h: self.h,
            start: placed(&self.start, constant),
            end: placed(&self.end, constant),
            coefficients: self
                .coefficients
                .map(|coefficient| placed(&coefficient, &[T::from(0.0); M])),
        }
    }

    /// A step on which all components change linearly.
    pub fn line(h: T, start: [T; N], end: [T; N]) -> Self {
        let mut line = Dense::empty(start);
        line.h = h;
        line.end = end;
        line.coefficients[0] = core::array::from_fn(|i| end[i] - start[i]);
        line
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
    /// The step shortened to the fraction x.
    pub fn cut(&self, x: f64) -> Dense<f64, N> {
        super::Collocation::get().cut(self, x)
    }

    /// The fraction between `from` and `to` where `function` of the state changes sign.
    pub fn root(&self, from: f64, to: f64, function: impl Fn(&[f64; N]) -> f64) -> f64 {
        root::bracketed_root(from, to, |x| function(&self.at(x)))
    }

    /// The fraction at which a component that increases over the step has the given value.
    pub fn fraction_where(&self, i: usize, value: f64) -> f64 {
        root::bracketed_root(0.0, 1.0, |x| self.component(i, x) - value)
    }
}
