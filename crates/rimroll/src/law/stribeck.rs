//! Regularised dry friction with Stribeck's decrease from static to kinetic friction:
//!
//! ```text
//! T = −μ(|u|) N u/√(u² + v₀²),     μ(v) = μ_k + (μ_s − μ_k) exp(−(v/v_s)²)
//! ```
//!
//! With μ_s = μ_k it is regularised Coulomb friction, which most physics engines use in some form. Where the
//! rim should stick it creeps at a speed of about v₀ |T|/(μN). Source of the curve μ(v):
//! Armstrong-Hélouvry, Dupont & Canudas de Wit, Automatica 30 (1994), Eq. (3).

use super::coulomb::{check_coefficients, named_coefficients};
use super::{Friction, FrictionForce, FrictionModel, NamedParameters};
use crate::error::{InvalidInput, positive};
use crate::real::{Real, Scalar};

/// Stribeck friction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stribeck<T = f64> {
    /// μ_k, at high slip speed.
    pub friction: T,
    /// μ_s, at low slip speed.
    pub static_friction: T,
    /// v_s, the speed scale of the transition from μ_s to μ_k, m/s.
    pub stribeck_speed: T,
    /// v₀, the speed below which the rim creeps, m/s.
    pub creep_speed: T,
}

impl<T: Real> Friction<T> for Stribeck<T> {
    fn friction_force(&self, slip: [T; 2]) -> FrictionForce<T> {
        let square = slip[0] * slip[0] + slip[1] * slip[1];
        let decay = (-square / (self.stribeck_speed * self.stribeck_speed)).exp();
        let friction = self.friction + (self.static_friction - self.friction) * decay;
        let smoothed = (square + self.creep_speed * self.creep_speed).sqrt();
        FrictionForce::proportional_to_normal(slip, friction / smoothed)
    }
}

impl FrictionModel for Stribeck {
    const NAME: &'static str = "stribeck";

    type Friction<T: Scalar> = Stribeck<T>;

    /// `friction`, `stribeck_speed`, `creep_speed`, and `static` if it differs from `friction`.
    fn from_named(given: &NamedParameters<'_>) -> Result<Self, InvalidInput> {
        let (friction, static_friction) = named_coefficients(given);
        Ok(Stribeck {
            friction,
            static_friction,
            stribeck_speed: given.number("stribeck_speed"),
            creep_speed: given.number("creep_speed"),
        })
    }

    fn check(&self) -> Result<(), InvalidInput> {
        check_coefficients(self.friction, self.static_friction)?;
        positive("stribeck_speed", self.stribeck_speed, "m/s")?;
        positive("creep_speed", self.creep_speed, "m/s")?;
        Ok(())
    }

    fn scaled(&self, factor: f64) -> Self {
        Stribeck {
            friction: self.friction * factor,
            static_friction: self.static_friction * factor,
            ..*self
        }
    }

    fn impact_coefficient<T: Scalar>(&self, _slip_speed: T) -> T {
        self.friction.into()
    }

    fn friction<T: Scalar>(&self) -> Stribeck<T> {
        Stribeck {
            friction: self.friction.into(),
            static_friction: self.static_friction.into(),
            stribeck_speed: self.stribeck_speed.into(),
            creep_speed: self.creep_speed.into(),
        }
    }
}
