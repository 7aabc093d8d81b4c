//! A law is added in the documented way: one type and one line in the list.

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
