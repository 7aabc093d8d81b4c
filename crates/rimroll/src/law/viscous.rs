//! Viscous friction, T = −c u: a rim on a film of oil whose thickness does not depend on the load.
//!
//! Where a force this large would lift the rim off the film, it is reduced to T = −λ c u with the λ < 1 at
//! which the normal force is zero.

use super::{Friction, FrictionForce};
use crate::real::Real;

/// Viscous friction on a rim that slips.
#[derive(Debug, Clone, Copy)]
pub struct Viscous<T> {
    /// c, N s/m.
    pub coefficient: T,
}

impl<T: Real> Friction<T> for Viscous<T> {
    fn friction_force(&self, slip: [T; 2]) -> FrictionForce<T> {
        let zero = T::from(0.0);
        FrictionForce {
            numerator: [zero, zero],
            denominator: T::from(1.0),
            load_independent: Some([-self.coefficient * slip[0], -self.coefficient * slip[1]]),
        }
    }
}
