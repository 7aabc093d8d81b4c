//! Dry friction (Coulomb, Amontons): as long as the rim slips, T = −μN u/|u|.
//!
//! This is one half of the law. A rim that does not slip rolls, which is [`NoSlip`](super::NoSlip),
//! as long as |T| ≤ μ_s N; the halves are joined by events, without regularisation (see
//! [`motion`](crate::motion)).

use super::{DryFriction, Friction, FrictionForce};
use crate::real::{Real, fieldwise};

/// The friction of a rim that slips.
#[derive(Debug, Clone, Copy)]
pub struct Coulomb<T> {
    /// μ, of slipping.
    pub friction: T,
}

fieldwise!(Coulomb { friction; });

impl<T: Real> Coulomb<T> {
    /// The friction on a slip in the direction of a unit vector, however small.
    #[inline(always)]
    pub fn against(&self, direction: [T; 2]) -> FrictionForce<T> {
        FrictionForce::per_normal(direction, self.friction)
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
