//! Dry friction (Coulomb, Amontons): while the rim slips, T = −μN u/|u|.
//!
//! This is one half of the law. While |T| ≤ μ_s N suffices, the rim rolls, which is
//! [`NoSlip`](super::NoSlip). Events join the two halves, without regularisation (see
//! [`motion`](crate::motion)).

use super::{
    DryFriction, DryFrictionModel, Friction, FrictionForce, FrictionModel, NamedParameters,
};
use crate::error::{InvalidInput, bounded};
use crate::real::{Real, Scalar, fieldwise};

/// Coefficients of friction above this are refused.
pub const MAX_FRICTION: f64 = 1e6;

/// Coulomb friction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coulomb<T = f64> {
    /// μ, the kinetic coefficient.
    pub friction: T,
    /// μ_s ≥ μ, the static coefficient.
    pub static_friction: T,
}

fieldwise!(Coulomb { friction, static_friction; });

impl<T: Copy> Coulomb<T> {
    /// The law whose static and kinetic coefficients are equal.
    #[inline(always)]
    pub fn uniform(friction: T) -> Self {
        Coulomb {
            friction,
            static_friction: friction,
        }
    }
}

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

impl FrictionModel for Coulomb {
    const NAME: &'static str = "coulomb";

    type Friction<T: Scalar> = Coulomb<T>;

    /// `friction`, and `static` if it differs.
    fn from_named(given: &NamedParameters<'_>) -> Result<Self, InvalidInput> {
        let (friction, static_friction) = named_coefficients(given);
        Ok(Coulomb {
            friction,
            static_friction,
        })
    }

    fn check(&self) -> Result<(), InvalidInput> {
        check_coefficients(self.friction, self.static_friction)
    }

    fn scaled(&self, factor: f64) -> Self {
        Coulomb {
            friction: self.friction * factor,
            static_friction: self.static_friction * factor,
        }
    }

    fn impact_coefficient<T: Scalar>(&self, _slip_speed: T) -> T {
        self.friction.into()
    }

    fn friction<T: Scalar>(&self) -> Coulomb<T> {
        Coulomb {
            friction: self.friction.into(),
            static_friction: self.static_friction.into(),
        }
    }
}

impl DryFrictionModel for Coulomb {
    fn static_friction(&self) -> f64 {
        self.static_friction
    }
}

/// The kinetic coefficient `friction` and the static one, `static`, which is the same unless given.
pub(super) fn named_coefficients(given: &NamedParameters<'_>) -> (f64, f64) {
    let friction = given.number("friction");
    (friction, given.optional("static").unwrap_or(friction))
}

/// Checks a kinetic and a static coefficient.
pub(super) fn check_coefficients(friction: f64, static_friction: f64) -> Result<(), InvalidInput> {
    let sensible = |f: f64| (0.0..=MAX_FRICTION).contains(&f);
    bounded("friction", friction, sensible, "between 0 and 1e6", "")?;
    bounded(
        "static",
        static_friction,
        |f| (friction..=MAX_FRICTION).contains(&f),
        &format!("between friction = {friction} and 1e6"),
        "",
    )
    .map_err(|error| error.beside("friction"))?;
    Ok(())
}
