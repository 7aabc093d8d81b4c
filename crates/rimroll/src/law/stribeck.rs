//! Dry friction made smooth, with Stribeck's fall from static to kinetic friction:
//!
//! ```text
//! T = −μ(|u|) N u/√(u² + v₀²),     μ(v) = μ_k + (μ_s − μ_k) exp(−(v/v_s)²)
//! ```
//!
//! With μ_s = μ_k it is regularised Coulomb friction, which most physics engines use in some form: the
//! rim creeps where it should stick, by some v₀ |T|/(μN). Source of the falling curve:
//! Armstrong-Hélouvry, Dupont & Canudas de Wit, Automatica 30 (1994), Eq. (3).

use super::{Friction, FrictionForce};
use crate::real::Real;

/// The friction of a rim on a table that holds it by creeping.
#[derive(Debug, Clone, Copy)]
pub struct Stribeck<T> {
    /// μ_k, of fast slip.
    pub friction: T,
    /// μ_s, of slow slip.
    pub static_friction: T,
    /// v_s, over which the one gives way to the other, m/s.
    pub stribeck_speed: T,
    /// v₀, below which friction gives way to creep, m/s.
    pub creep_speed: T,
}

impl<T: Real> Friction<T> for Stribeck<T> {
    fn friction_force(&self, slip: [T; 2]) -> FrictionForce<T> {
        let square = slip[0] * slip[0] + slip[1] * slip[1];
        let fading = (-square / (self.stribeck_speed * self.stribeck_speed)).exp();
        let friction = self.friction + (self.static_friction - self.friction) * fading;
        let smoothed = (square + self.creep_speed * self.creep_speed).sqrt();
        FrictionForce::per_normal(slip, friction / smoothed)
    }
}
