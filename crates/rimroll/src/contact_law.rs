//! The contact law that a user chooses: friction, restitution and resistance.

use crate::error::{InvalidInput, bounded};
use crate::law::{FrictionLaw, NamedParameters, Resistance};

/// Everything about the table that a motion depends on.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactLaw {
    /// Friction on the rim.
    pub friction: FrictionLaw,
    /// W. J. Stronge's energetic coefficient of restitution e of an impact after flight: the fraction e² of
    /// the work of compression is returned. Motions without slip, without friction or in place have
    /// no flight; they end where the rim would lift off.
    pub restitution: f64,
    /// Dissipation other than friction.
    pub resistance: Resistance,
}

impl<F: Into<FrictionLaw>> From<F> for ContactLaw {
    fn from(friction: F) -> Self {
        ContactLaw {
            friction: friction.into(),
            restitution: 0.0,
            resistance: Resistance::default(),
        }
    }
}

impl ContactLaw {
    /// A contact law from the name of its friction law and its parameters by name, as users write them:
    /// those of the friction law (its [`FrictionModel::from_named`](crate::law::FrictionModel::from_named)),
    /// `restitution`, and those of [`Resistance`]: `rolling_dry`, `rolling_viscous`, `pivoting_length`,
    /// `air_coefficient`, `air_exponent`. Missing numbers are 0, except the air exponent, which has the default
    /// of [`AirDrag`](crate::law::AirDrag).
    ///
    /// # Errors
    /// Refuses an unknown name, and parameters that are out of bounds.
    pub fn named(
        law: &str,
        numbers: &[(String, f64)],
        tables: &[(String, Vec<f64>)],
    ) -> Result<ContactLaw, InvalidInput> {
        let given = NamedParameters { numbers, tables };
        let contact_law = ContactLaw {
            friction: FrictionLaw::named(law, &given)?,
            restitution: given.number("restitution"),
            resistance: Resistance::from_named(&given),
        };
        contact_law.check()?;
        Ok(contact_law)
    }

    /// Checks every parameter.
    ///
    /// # Errors
    /// Names the first parameter that is out of bounds: coefficients of friction from 0 to 1e6, with the
    /// static one not below the kinetic one; restitution from 0 to 1; the exponent of air drag from 1.5
    /// to 8; all others not negative.
    pub fn check(&self) -> Result<(), InvalidInput> {
        self.friction.check()?;
        let unit = |e: f64| (0.0..=1.0).contains(&e);
        bounded("restitution", self.restitution, unit, "between 0 and 1", "")?;
        self.resistance.check()
    }

    /// This contact law with all coefficients of friction multiplied by `factor`.
    #[must_use]
    pub fn with_friction_scaled(mut self, factor: f64) -> ContactLaw {
        self.friction = self.friction.scaled(factor);
        self
    }

    /// Whether a motion loses energy to rolling resistance, pivoting friction or air drag.
    pub(crate) fn resists(&self) -> bool {
        !self.resistance.is_none()
    }
}
