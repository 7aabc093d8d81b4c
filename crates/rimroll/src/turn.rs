//! The angle of turn: its limits in closed form, the approach to them, the friction and normal force that
//! the near-collision requires, and the turn of finite motions by quadrature ([`exact`]).

mod closed_forms;
pub mod exact;
mod inner_problem;

pub use closed_forms::{
    NearCollision, disk_turn_limit, error_law, error_law_coefficient, lift_off_rate,
    needed_friction, painleve_friction, point_mass_turn_limit, slip_rate, tall_turn_limit,
    turn_limit, turn_limit_with_spin,
};
pub use inner_problem::{Arrival, Passage, passage, turn_limit_of};

use crate::body::Body;
use crate::law::{IdealLaw, Parameters};
use crate::real::Real;

/// The two moments of inertia J′ and K′ whose ratio determines the turn: J and K (about the rim and about
/// the centre of the base) without slip, A + mR² and A without friction.
pub(crate) fn inertias(body: &Body, law: IdealLaw) -> (f64, f64) {
    // They do not depend on gravity.
    inertias_of(&Parameters::new(body, 1.0), law)
}

/// [`inertias`] for any number type.
pub(crate) fn inertias_of<T: Real>(k: &Parameters<T>, law: IdealLaw) -> (T, T) {
    let rim = k.m * k.r * k.r;
    let inertia = match law {
        IdealLaw::NoSlip => k.a + k.m * k.h * k.h,
        IdealLaw::Frictionless => k.a,
    };
    (inertia + rim, inertia)
}
