//! How steps approach a corner of the table's acceleration.

use super::StepSize;
use crate::motion::phase_system::{IndependentVariable, PhaseSystem};
use crate::state::{COORDINATES, Coordinates, TIME};

/// How steps approach the next corner of the table's acceleration, at which one has to end.
///
/// With respect to τ or σ, the size of the step that ends there is not known before. So a step that comes near the
/// corner is made with respect to the time. In a near-collision, whose steps are far shorter than the time to the
/// corner, steps are made with respect to τ.
pub(super) struct CornerApproach<'a> {
    pub(super) phase_system: &'a PhaseSystem<'a>,
    pub(super) variable: IndependentVariable,
    /// The corner, s; infinite if there is none.
    pub(super) corner: f64,
}

impl CornerApproach<'_> {
    /// dt/dτ or dt/dσ.
    pub(super) fn time_rate(&self, u: &[f64; COORDINATES]) -> f64 {
        let u = Coordinates::from_array(u);
        u.sin * self.phase_system.sundman_factor(&u)
    }

    /// A step of size h in the regularized variable.
    pub(super) fn regularized(&self, u: &[f64; COORDINATES], h: f64) -> f64 {
        match self.variable {
            IndependentVariable::Regularized => h,
            IndependentVariable::Time => h / self.time_rate(u),
        }
    }

    /// A step of h seconds.
    pub(super) fn in_time(&self, h: f64) -> StepSize {
        let variable = IndependentVariable::Time;
        StepSize { variable, h }
    }

    /// The size of a step from `u` if it should be made with respect to the other variable.
    pub(super) fn other_variable(&self, u: &[f64; COORDINATES], h: f64) -> Option<StepSize> {
        // The fractions of the time to the corner beyond which the variable is changed. They differ, so that the
        // variable does not change back at once.
        const NEAR: f64 = 0.25;
        const FAR: f64 = 0.02;
        if self.corner == f64::INFINITY {
            return (self.variable == IndependentVariable::Time).then(|| StepSize {
                variable: IndependentVariable::Regularized,
                h: self.regularized(u, h),
            });
        }
        let remaining = self.corner - u[TIME];
        match self.variable {
            IndependentVariable::Regularized => {
                let h = h * self.time_rate(u);
                (h > NEAR * remaining).then(|| self.in_time(h))
            }
            IndependentVariable::Time => (h < FAR * remaining).then(|| StepSize {
                variable: IndependentVariable::Regularized,
                h: self.regularized(u, h),
            }),
        }
    }

    /// Whether so many steps of this size remain to the corner that an implicit step, which has to end there too, could
    /// take less time.
    pub(super) fn is_long(&self, u: &[f64; COORDINATES], h: f64) -> bool {
        // The cost of an implicit step, in explicit steps.
        const COST: f64 = 100.0;
        if self.corner == f64::INFINITY {
            return true;
        }
        let h = match self.variable {
            IndependentVariable::Time => h,
            IndependentVariable::Regularized => h * self.time_rate(u),
        };
        self.corner - u[TIME] > COST * h
    }

    /// Limits the size of a step with respect to the time. Returns the time to the corner.
    pub(super) fn limit(&self, u: &[f64; COORDINATES], h: &mut f64) -> f64 {
        let remaining = self.corner - u[TIME];
        if self.variable == IndependentVariable::Time {
            // Two equal steps are better than a long and a very short one.
            *h = if *h >= remaining {
                remaining
            } else {
                h.min(0.5 * remaining)
            };
        }
        remaining
    }
}
