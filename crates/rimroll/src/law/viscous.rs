//! Viscous friction, T = −c u: a rim on a film of oil whose thickness does not depend on the load.
//!
//! Where a force this large would lift the rim off the film, it is reduced to T = −λ c u with the λ < 1 at
//! which the normal force is zero.

use super::{Friction, FrictionForce, FrictionModel, NamedParameters};
use crate::error::{InvalidInput, not_negative};
use crate::real::{Real, Scalar};

/// Viscous friction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Viscous<T = f64> {
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

impl FrictionModel for Viscous {
    const NAME: &'static str = "viscous";

    type Friction<T: Scalar> = Viscous<T>;

    /// `coefficient`.
    fn from_named(given: &NamedParameters<'_>) -> Result<Self, InvalidInput> {
        let coefficient = given.number("coefficient");
        Ok(Viscous { coefficient })
    }

    fn check(&self) -> Result<(), InvalidInput> {
        not_negative("coefficient", self.coefficient, "N s/m")?;
        Ok(())
    }

    fn scaled(&self, factor: f64) -> Self {
        Viscous {
            coefficient: self.coefficient * factor,
        }
    }

    /// The impulse of a force that does not depend on the normal force vanishes with the duration of the
    /// impact.
    fn impact_coefficient<T: Scalar>(&self, _slip_speed: T) -> T {
        0.0.into()
    }

    fn friction<T: Scalar>(&self) -> Viscous<T> {
        Viscous {
            coefficient: self.coefficient.into(),
        }
    }
}
