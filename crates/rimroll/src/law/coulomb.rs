//! Dry friction (Coulomb, Amontons): while the rim slips, T = −μN u/|u|.
//!
//! This is one half of the law. While |T| ≤ μ_s N suffices, the rim rolls, which is
//! [`NoSlip`](super::NoSlip). Events join the two halves, without regularisation (see
//! [`motion`](crate::motion)).

use super::{DryFriction, Friction, FrictionForce};
use crate::real::{Real, fieldwise};

/// Coulomb friction on a rim that slips.
#[derive(Debug, Clone, Copy)]
pub struct Coulomb<T> {
    /// μ, the kinetic coefficient.
    pub friction: T,
}

fieldwise!(Coulomb { friction; });

impl<T: Real> Coulomb<T> {
    /// The friction in the limit of vanishing slip in the direction of a unit vector.
    #[inline(always)]
    pub fn against(&self, direction: [T; 2]) -> FrictionForce<T> {
        FrictionForce::proportional_to_normal(direction, self.friction)
    }
}

impl<T: Real> Friction<T> for Coulomb<T> {
    #[inline(always)]
    fn friction_force(&self, slip: [T; 2]) -> FrictionForce<T> {
        self.dry_friction_force(slip)
    }
}

impl<T: Real> DryFriction<T> for Coulomb<T> {
    #[inline(always)]
    fn coefficient(&self, _speed: T) -> T {
        self.friction
    }
}
