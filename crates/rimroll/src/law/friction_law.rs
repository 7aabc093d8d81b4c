//! The list of friction laws.
//!
//! A new law is a file beside this one, with a type that implements [`FrictionModel`] and, if the friction
//! is dry, [`DryFrictionModel`], and one line in the list below (besides its `mod`, `pub use` and `use`). Its
//! name, its parameters, their bounds, its equations of motion and its part in impacts follow from these.

use super::{
    Coulomb, DryDynamics, DryFrictionModel, Dynamics, FrictionModel, Frictionless, InPlace,
    NamedParameters, NoFriction, NoSlip, OnTable, Parameters, Resistance, Resisted, Sliding,
    Stribeck, Table, Tabulated, Viscous,
};
use crate::body::Body;
use crate::error::InvalidInput;
use crate::real::Scalar;
use crate::state::{Coordinates, State};

/// The name that users type.
const IN_PLACE: &str = "in_place";

/// Selects what only dry friction has.
macro_rules! if_dry {
    (dry, $value:expr) => {
        Some($value)
    };
    (smooth, $value:expr) => {
        None
    };
}

/// Defines [`FrictionLaw`] and [`SlidingDynamics`] for a list of laws.
macro_rules! friction_laws {
    ($($(#[doc = $doc:literal])* $law:ident: $kind:ident,)*) => {
        /// The friction between rim and table.
        #[derive(Debug, Clone, PartialEq)]
        pub enum FrictionLaw {
            /// The rim never slips.
            NoSlip,
            /// The table exerts only a normal force.
            Frictionless,
            /// The body wobbles without leaving its place: [`InPlace`](super::InPlace).
            InPlace,
            $($(#[doc = $doc])* $law($law),)*
        }

        impl FrictionLaw {
            /// The names that users type, in the order in which they are listed.
            pub const NAMES: &[&str] = &[
                IdealLaw::NoSlip.name(),
                IdealLaw::Frictionless.name(),
                IN_PLACE,
                $($law::NAME,)*
            ];

            /// The name that a user types.
            pub fn name(&self) -> &'static str {
                match self {
                    FrictionLaw::NoSlip => IdealLaw::NoSlip.name(),
                    FrictionLaw::Frictionless => IdealLaw::Frictionless.name(),
                    FrictionLaw::InPlace => IN_PLACE,
                    $(FrictionLaw::$law(_) => $law::NAME,)*
                }
            }

            /// The friction law with this name and these parameters.
            ///
            /// # Errors
            /// Refuses an unknown name and parameters from which no law can be made.
            pub fn named(name: &str, given: &NamedParameters<'_>) -> Result<Self, InvalidInput> {
                let typed = name.replace('-', "_");
                match IdealLaw::from_name(&typed) {
                    Ok(IdealLaw::NoSlip) => return Ok(FrictionLaw::NoSlip),
                    Ok(IdealLaw::Frictionless) => return Ok(FrictionLaw::Frictionless),
                    Err(_) if typed == IN_PLACE => return Ok(FrictionLaw::InPlace),
                    Err(_) => {}
                }
                $(if typed == $law::NAME {
                    return $law::from_named(given).map(FrictionLaw::$law);
                })*
                Err(InvalidInput::UnknownName {
                    what: "law",
                    name: name.to_owned(),
                    choices: FrictionLaw::NAMES.join(", "),
                })
            }

            /// Checks the parameters.
            pub(crate) fn check(&self) -> Result<(), InvalidInput> {
                match self {
                    FrictionLaw::NoSlip | FrictionLaw::Frictionless | FrictionLaw::InPlace => Ok(()),
                    $(FrictionLaw::$law(law) => law.check(),)*
                }
            }

            /// This law with all coefficients of friction multiplied by `factor`.
            pub(crate) fn scaled(&self, factor: f64) -> Self {
                match self {
                    FrictionLaw::NoSlip => FrictionLaw::NoSlip,
                    FrictionLaw::Frictionless => FrictionLaw::Frictionless,
                    FrictionLaw::InPlace => FrictionLaw::InPlace,
                    $(FrictionLaw::$law(law) => FrictionLaw::$law(law.scaled(factor)),)*
                }
            }

            /// [`FrictionModel::impact_coefficient`].
            pub(crate) fn impact_coefficient<T: Scalar>(&self, slip_speed: T) -> T {
                match self {
                    FrictionLaw::NoSlip | FrictionLaw::Frictionless | FrictionLaw::InPlace => 0.0.into(),
                    $(FrictionLaw::$law(law) => law.impact_coefficient(slip_speed),)*
                }
            }

            /// μ_s of dry friction; `None` for other laws.
            pub(crate) fn static_friction(&self) -> Option<f64> {
                match self {
                    FrictionLaw::NoSlip | FrictionLaw::Frictionless | FrictionLaw::InPlace => None,
                    $(#[allow(unused_variables)]
                    FrictionLaw::$law(law) => if_dry!($kind, law.static_friction()),)*
                }
            }
        }

        $(impl From<$law> for FrictionLaw {
            fn from(law: $law) -> Self {
                FrictionLaw::$law(law)
            }
        })*

        /// The dynamics of a rim that slides, with resistance.
        #[derive(Clone)]
        pub(crate) enum SlidingDynamics<T: Scalar> {
            /// The rim cannot slide.
            Never,
            Frictionless(Resisted<Frictionless<T>>),
            /// Without friction on a table that moves.
            StayingBehind(Resisted<OnTable<Sliding<T, NoFriction>, T>>),
            $($law(Resisted<OnTable<Sliding<T, <$law as FrictionModel>::Friction<T>>, T>>),)*
        }

        impl<T: Scalar> SlidingDynamics<T> {
            /// The dynamics on a table, with the arguments of [`Resisted::new`].
            pub(crate) fn new(
                friction: &FrictionLaw,
                k: Parameters<T>,
                table: &Table<T>,
                resistance: Resistance,
                tolerance: f64,
            ) -> Self {
                match friction {
                    FrictionLaw::NoSlip | FrictionLaw::InPlace => SlidingDynamics::Never,
                    FrictionLaw::Frictionless if table.moves() => {
                        let sliding = OnTable::new(Sliding::new(k, NoFriction), table);
                        SlidingDynamics::StayingBehind(Resisted::new(sliding, resistance, tolerance))
                    }
                    FrictionLaw::Frictionless => {
                        let sliding = Frictionless::new(k);
                        SlidingDynamics::Frictionless(Resisted::new(sliding, resistance, tolerance))
                    }
                    $(FrictionLaw::$law(law) => {
                        let sliding = OnTable::new(Sliding::new(k, law.friction::<T>()), table);
                        SlidingDynamics::$law(Resisted::new(sliding, resistance, tolerance))
                    })*
                }
            }

            /// The equations of motion, if the rim can slide.
            pub(crate) fn dynamics(&self) -> Option<&dyn Dynamics<T>> {
                match self {
                    SlidingDynamics::Never => None,
                    SlidingDynamics::Frictionless(dynamics) => Some(dynamics),
                    SlidingDynamics::StayingBehind(dynamics) => Some(dynamics),
                    $(SlidingDynamics::$law(dynamics) => Some(dynamics),)*
                }
            }

            /// Whether the friction is dry.
            pub(crate) fn is_dry(&self) -> bool {
                let dry: Option<()> = match self {
                    SlidingDynamics::Never
                    | SlidingDynamics::Frictionless(_)
                    | SlidingDynamics::StayingBehind(_) => None,
                    $(SlidingDynamics::$law(_) => if_dry!($kind, ()),)*
                };
                dry.is_some()
            }
        }

        impl SlidingDynamics<f64> {
            /// The equations of motion, if the friction is dry.
            pub(crate) fn dry(&self) -> Option<&dyn DryDynamics> {
                match self {
                    SlidingDynamics::Never
                    | SlidingDynamics::Frictionless(_)
                    | SlidingDynamics::StayingBehind(_) => None,
                    $(#[allow(unused_variables)]
                    SlidingDynamics::$law(dynamics) => if_dry!($kind, dynamics),)*
                }
            }
        }
    };
}

friction_laws! {
    /// Dry friction: the rim sticks while |T| ≤ μ_s N; when it slips, |T| = μN, opposite to the slip.
    Coulomb: dry,
    /// Viscous friction: T = −c u.
    Viscous: smooth,
    /// Regularised dry friction that falls from static to kinetic.
    Stribeck: smooth,
    /// Dry friction whose kinetic coefficient is a function of the slip speed.
    Tabulated: dry,
}

impl FrictionLaw {
    /// Dry friction whose static and kinetic coefficients are equal.
    pub fn coulomb(friction: f64) -> Self {
        Coulomb::uniform(friction).into()
    }

    /// Whether the rim never slips.
    pub fn never_slips(&self) -> bool {
        matches!(self, FrictionLaw::NoSlip | FrictionLaw::InPlace)
    }

    /// The ideal law that this is, if it is one.
    pub fn ideal(&self) -> Option<IdealLaw> {
        match self {
            FrictionLaw::NoSlip => Some(IdealLaw::NoSlip),
            FrictionLaw::Frictionless => Some(IdealLaw::Frictionless),
            _ => None,
        }
    }

    /// Whether the rim can leave the table and land again. Where it cannot, motions end at a lift-off.
    pub(crate) fn covers_flight(&self) -> bool {
        self.ideal().is_none() && *self != FrictionLaw::InPlace
    }

    /// The start of a motion under this law. The rim does not slip; without friction, the centre of mass has no
    /// horizontal velocity.
    ///
    /// # Errors
    /// Refuses a start that contradicts the law: [`InPlace::start`].
    pub(crate) fn start(&self, start: &State) -> Result<Coordinates<f64>, InvalidInput> {
        match self {
            FrictionLaw::InPlace => InPlace::start(start),
            _ => Ok(Coordinates::from_state(start)),
        }
    }
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

/// The paper's two laws, which have closed forms. All friction laws lie between them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum IdealLaw {
    /// [`NoSlip`].
    NoSlip,
    /// [`Frictionless`].
    Frictionless,
}

impl IdealLaw {
    /// Both laws, in the order in which they are listed to the user.
    pub const ALL: [IdealLaw; 2] = [IdealLaw::NoSlip, IdealLaw::Frictionless];

    /// The name that users type.
    pub const fn name(self) -> &'static str {
        match self {
            IdealLaw::NoSlip => "no_slip",
            IdealLaw::Frictionless => "frictionless",
        }
    }

    /// The law of that name; `-` may replace `_`.
    ///
    /// # Errors
    /// Refuses an unknown name and lists the known ones.
    pub fn from_name(name: &str) -> Result<IdealLaw, InvalidInput> {
        let wanted = name.replace('-', "_");
        IdealLaw::ALL
            .into_iter()
            .find(|law| law.name() == wanted)
            .ok_or_else(|| InvalidInput::UnknownName {
                what: "law",
                name: name.to_owned(),
                choices: IdealLaw::ALL.map(IdealLaw::name).join(", "),
            })
    }

    /// The equations of motion of a body under gravity g (m/s²).
    pub fn dynamics(self, body: &Body, gravity: f64) -> Box<dyn Dynamics<f64> + Send + Sync> {
        let parameters = Parameters::new(body, gravity);
        match self {
            IdealLaw::NoSlip => Box::new(NoSlip::new(parameters)),
            IdealLaw::Frictionless => Box::new(Frictionless::new(parameters)),
        }
    }
}

/// A law is added in the documented way: one type and one line in the list.
#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::not_negative;
    use crate::law::DynamicsExt;
    use crate::law::{Friction, FrictionForce};
    use crate::presets;
    use crate::real::Real;
    use crate::state::{Coordinates, State};

    /// T = −c |u| u, the drag of a fluid.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct Quadratic<T = f64> {
        /// c, N s²/m².
        pub coefficient: T,
    }

    impl<T: Real> Friction<T> for Quadratic<T> {
        fn friction_force(&self, slip: [T; 2]) -> FrictionForce<T> {
            let speed = (slip[0] * slip[0] + slip[1] * slip[1]).sqrt();
            let zero = T::from(0.0);
            FrictionForce {
                numerator: [zero, zero],
                denominator: T::from(1.0),
                load_independent: Some(slip.map(|u| -self.coefficient * speed * u)),
            }
        }
    }

    impl FrictionModel for Quadratic {
        const NAME: &'static str = "quadratic";

        type Friction<T: Scalar> = Quadratic<T>;

        fn from_named(given: &NamedParameters<'_>) -> Result<Self, InvalidInput> {
            let coefficient = given.number("coefficient");
            Ok(Quadratic { coefficient })
        }

        fn check(&self) -> Result<(), InvalidInput> {
            not_negative("coefficient", self.coefficient, "N s2/m2")?;
            Ok(())
        }

        fn scaled(&self, factor: f64) -> Self {
            Quadratic {
                coefficient: self.coefficient * factor,
            }
        }

        fn impact_coefficient<T: Scalar>(&self, _slip_speed: T) -> T {
            0.0.into()
        }

        fn friction<T: Scalar>(&self) -> Quadratic<T> {
            Quadratic {
                coefficient: self.coefficient.into(),
            }
        }
    }

    friction_laws! {
        /// Coulomb friction, to see both kinds in one list.
        Coulomb: dry,
        /// The new law.
        Quadratic: smooth,
    }

    const COEFFICIENT: f64 = 0.3;

    fn quadratic() -> FrictionLaw {
        let numbers = [("coefficient".to_owned(), COEFFICIENT)];
        let given = NamedParameters {
            numbers: &numbers,
            tables: &[],
        };
        FrictionLaw::named("quadratic", &given).expect("a law in the list")
    }

    #[test]
    fn a_new_law_has_a_name_bounds_and_scaling() {
        let law = quadratic();
        assert_eq!(law.name(), "quadratic");
        let names = [
            "no_slip",
            "frictionless",
            "in_place",
            "coulomb",
            "quadratic",
        ];
        assert_eq!(FrictionLaw::NAMES, names);
        assert_eq!(law.static_friction(), None);
        assert_eq!(law.impact_coefficient(1.0), 0.0);
        let twice = Quadratic {
            coefficient: 2.0 * COEFFICIENT,
        };
        assert_eq!(law.scaled(2.0), twice.into());
        assert!(law.check().is_ok());
        let refused = law
            .scaled(-1.0)
            .check()
            .expect_err("a negative coefficient");
        assert!(refused.to_string().starts_with("coefficient"), "{refused}");
    }

    #[test]
    fn a_new_law_has_equations_of_motion_that_lose_what_friction_takes() {
        let can = presets::can_2007().expect("the paper's can");
        let k = Parameters::new(&can, 9.8);
        let sliding = SlidingDynamics::new(
            &quadratic(),
            k,
            &Table::AtRest,
            Resistance::default(),
            1e-12,
        );
        assert!(sliding.dry().is_none() && !sliding.is_dry());
        let dynamics = sliding.dynamics().expect("the rim can slide");
        let start = State {
            tilt: 0.3,
            tilt_rate: -0.4,
            yaw_rate: 1.5,
            spin_rate: 2.0,
            ..State::default()
        };
        let u = Coordinates {
            slip_x: 0.3,
            slip_y: -0.4,
            ..Coordinates::from_state(&start)
        };
        let rates = dynamics.rates(&u);
        // c |u|³ per unit of time; dt = sin φ dτ.
        let lost = COEFFICIENT * 0.125 * u.sin;
        assert!((rates.friction_loss - lost).abs() < 1e-14);
        // The energy along the motion, by a central difference: exact to h².
        let h = 1e-5;
        let energy = |h: f64| dynamics.energy(&u.plus(h, &rates)).total();
        let change = (energy(h) - energy(-h)) / (2.0 * h);
        assert!(
            (change + lost).abs() < 1e-9 * energy(0.0),
            "{change} {lost}"
        );
    }
}
