//! The contact law that a user chooses: friction, restitution and resistance.

use crate::error::{InvalidInput, bounded, not_negative, positive};
use crate::law::{
    AirDrag, DryFriction, IdealLaw, MAX_FRICTION, PivotingFriction, Resistance, RollingResistance,
    Tabulated,
};

/// A friction law between rim and table, with its parameters.
#[derive(Debug, Clone, PartialEq)]
pub enum FrictionLaw {
    /// The rim never slips.
    NoSlip,
    /// The table exerts only a normal force.
    Frictionless,
    /// Dry friction: the rim sticks while |T| ≤ μ_s N; when it slips, |T| = μN, opposite to the slip.
    Coulomb {
        /// μ.
        friction: f64,
        /// μ_s ≥ μ.
        static_friction: f64,
    },
    /// Viscous friction: T = −c u.
    Viscous {
        /// c, N s/m.
        coefficient: f64,
    },
    /// Regularised dry friction that falls from static to kinetic (see [`Stribeck`](crate::law::Stribeck)).
    Stribeck {
        /// μ_k.
        friction: f64,
        /// μ_s ≥ μ_k.
        static_friction: f64,
        /// v_s, m/s.
        stribeck_speed: f64,
        /// v₀, m/s.
        creep_speed: f64,
    },
    /// Dry friction whose kinetic coefficient is a function of the slip speed.
    Tabulated(Tabulated),
}

impl FrictionLaw {
    /// The names that users type, in the order in which they are listed.
    pub const NAMES: [&str; 6] = [
        "no_slip",
        "frictionless",
        "coulomb",
        "viscous",
        "stribeck",
        "tabulated",
    ];

    /// Dry friction whose static and kinetic coefficients are equal.
    pub fn coulomb(friction: f64) -> Self {
        FrictionLaw::Coulomb {
            friction,
            static_friction: friction,
        }
    }

    /// The name that users type.
    pub fn name(&self) -> &'static str {
        match self {
            FrictionLaw::NoSlip => "no_slip",
            FrictionLaw::Frictionless => "frictionless",
            FrictionLaw::Coulomb { .. } => "coulomb",
            FrictionLaw::Viscous { .. } => "viscous",
            FrictionLaw::Stribeck { .. } => "stribeck",
            FrictionLaw::Tabulated(_) => "tabulated",
        }
    }

    /// The corresponding ideal law, if this is one.
    pub fn ideal(&self) -> Option<IdealLaw> {
        match self {
            FrictionLaw::NoSlip => Some(IdealLaw::NoSlip),
            FrictionLaw::Frictionless => Some(IdealLaw::Frictionless),
            _ => None,
        }
    }

    /// μ_s of dry friction, which lets the rim stick; `None` under all other laws.
    pub(crate) fn static_friction(&self) -> Option<f64> {
        match self {
            FrictionLaw::Coulomb {
                static_friction, ..
            } => Some(*static_friction),
            FrictionLaw::Tabulated(table) => Some(table.static_friction()),
            _ => None,
        }
    }

    /// The coefficient of friction in an impact with this slip speed (m/s). It is 0 where friction does not
    /// depend on the normal force, since the impulse of such a force vanishes in an instant.
    pub(crate) fn friction_in_impact(&self, slip_speed: f64) -> f64 {
        match self {
            FrictionLaw::Coulomb { friction, .. } | FrictionLaw::Stribeck { friction, .. } => {
                *friction
            }
            FrictionLaw::Tabulated(table) => table.coefficient(slip_speed),
            FrictionLaw::Viscous { .. } | FrictionLaw::NoSlip | FrictionLaw::Frictionless => 0.0,
        }
    }

    fn check(&self) -> Result<(), InvalidInput> {
        match *self {
            FrictionLaw::NoSlip | FrictionLaw::Frictionless => {}
            FrictionLaw::Tabulated(ref table) => table.check()?,
            FrictionLaw::Viscous { coefficient } => {
                not_negative("coefficient", coefficient, "N s/m")?;
            }
            FrictionLaw::Coulomb {
                friction,
                static_friction,
            } => check_coefficients(friction, static_friction)?,
            FrictionLaw::Stribeck {
                friction,
                static_friction,
                stribeck_speed,
                creep_speed,
            } => {
                check_coefficients(friction, static_friction)?;
                positive("stribeck_speed", stribeck_speed, "m/s")?;
                positive("creep_speed", creep_speed, "m/s")?;
            }
        }
        Ok(())
    }
}

fn check_coefficients(friction: f64, static_friction: f64) -> Result<(), InvalidInput> {
    let sensible = |f: f64| (0.0..=MAX_FRICTION).contains(&f);
    bounded("friction", friction, sensible, "between 0 and 1e6", "")?;
    bounded(
        "static",
        static_friction,
        |f| (friction..=MAX_FRICTION).contains(&f),
        &format!("between friction = {friction} and 1e6"),
        "",
    )?;
    Ok(())
}

impl From<IdealLaw> for FrictionLaw {
    fn from(law: IdealLaw) -> Self {
        match law {
            IdealLaw::NoSlip => FrictionLaw::NoSlip,
            IdealLaw::Frictionless => FrictionLaw::Frictionless,
        }
    }
}

impl From<&FrictionLaw> for FrictionLaw {
    fn from(law: &FrictionLaw) -> Self {
        law.clone()
    }
}

/// Everything about the table that a motion depends on.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactLaw {
    /// Friction on the rim.
    pub friction: FrictionLaw,
    /// W. J. Stronge's energetic coefficient of restitution e of an impact after flight: the fraction e² of
    /// the work of compression is returned. Motions under the two ideal laws have no flight; they end
    /// where the rim would lift off.
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
    /// `friction`, `static` (default: `friction`), `coefficient`, `stribeck_speed`, `creep_speed`,
    /// `restitution`, `rolling_dry`, `rolling_viscous`, `pivoting_length`, `air_coefficient`,
    /// `air_exponent`. Other missing numbers are 0, except the air exponent, which has the default of
    /// [`AirDrag`]. `tables` are lists of numbers: `speeds` and `frictions`.
    ///
    /// # Errors
    /// Refuses an unknown name and what [`ContactLaw::check`] and [`Tabulated::new`] refuse.
    pub fn named(
        law: &str,
        numbers: &[(String, f64)],
        tables: &[(String, Vec<f64>)],
    ) -> Result<ContactLaw, InvalidInput> {
        let table = |name: &str| {
            let given = tables.iter().find(|(n, _)| n == name);
            given.map_or(&[][..], |(_, values)| values)
        };
        let given = |name: &str| numbers.iter().find(|(n, _)| n == name).map(|&(_, v)| v);
        let number = |name: &str| given(name).unwrap_or(0.0);
        let friction = number("friction");
        let static_friction = given("static").unwrap_or(friction);
        let friction = match law.replace('-', "_").as_str() {
            "no_slip" => FrictionLaw::NoSlip,
            "frictionless" => FrictionLaw::Frictionless,
            "coulomb" => FrictionLaw::Coulomb {
                friction,
                static_friction,
            },
            "viscous" => FrictionLaw::Viscous {
                coefficient: number("coefficient"),
            },
            "stribeck" => FrictionLaw::Stribeck {
                friction,
                static_friction,
                stribeck_speed: number("stribeck_speed"),
                creep_speed: number("creep_speed"),
            },
            "tabulated" => FrictionLaw::Tabulated(Tabulated::new(
                table("speeds"),
                table("frictions"),
                given("static"),
            )?),
            _ => {
                return Err(InvalidInput::UnknownName {
                    what: "law",
                    name: law.to_owned(),
                    choices: FrictionLaw::NAMES.join(", "),
                });
            }
        };
        let contact_law = ContactLaw {
            friction,
            restitution: number("restitution"),
            resistance: Resistance {
                rolling: RollingResistance {
                    dry: number("rolling_dry"),
                    viscous: number("rolling_viscous"),
                },
                pivoting: PivotingFriction {
                    length: number("pivoting_length"),
                },
                air: AirDrag {
                    coefficient: number("air_coefficient"),
                    exponent: given("air_exponent").unwrap_or(AirDrag::default().exponent),
                },
            },
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
        let Resistance {
            rolling,
            pivoting,
            air,
        } = self.resistance;
        not_negative("rolling_resistance dry", rolling.dry, "")?;
        not_negative("rolling_resistance viscous", rolling.viscous, "N s/m")?;
        not_negative("pivoting_friction", pivoting.length, "m")?;
        not_negative("air_drag", air.coefficient, "W (s/rad)^exponent")?;
        let moderate = |n: f64| (1.5..=8.0).contains(&n);
        bounded(
            "air_drag exponent",
            air.exponent,
            moderate,
            "between 1.5 and 8",
            "",
        )?;
        Ok(())
    }

    /// This contact law with all coefficients of friction multiplied by `factor`.
    #[must_use]
    pub fn with_friction_scaled(mut self, factor: f64) -> ContactLaw {
        match &mut self.friction {
            FrictionLaw::NoSlip | FrictionLaw::Frictionless => {}
            FrictionLaw::Viscous { coefficient } => *coefficient *= factor,
            FrictionLaw::Tabulated(table) => *table = table.times(factor),
            FrictionLaw::Coulomb {
                friction,
                static_friction,
            }
            | FrictionLaw::Stribeck {
                friction,
                static_friction,
                ..
            } => {
                *friction *= factor;
                *static_friction *= factor;
            }
        }
        self
    }

    /// Whether a motion loses energy to rolling resistance, pivoting friction or air drag.
    pub(crate) fn resists(&self) -> bool {
        !self.resistance.is_none()
    }
}
