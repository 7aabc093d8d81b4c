//! Viscous friction: T = −c u, as of a rim on a film of oil that is as thick under any load.
//!
//! Where so much of it would lift the rim off the film it gives way, T = −λ c u with the λ < 1 at which
//! nothing presses.

use super::{Friction, FrictionForce};
use crate::real::Real;

/// The friction of a film.
#[derive(Debug, Clone, Copy)]
pub struct Viscous<T> {
    /// c, N s/m.
    pub coefficient: T,
}

impl<T: Real> Friction<T> for Viscous<T> {
    fn friction_force(&self, slip: [T; 2]) -> FrictionForce<T> {
        let zero = T::from(0.0);
        FrictionForce {
            per_normal: [zero, zero],
            of: T::from(1.0),
            own: Some([-self.coefficient * slip[0], -self.coefficient * slip[1]]),
        }
    }
}
