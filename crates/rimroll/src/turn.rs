//! The angle of turn in closed form: its limits, how a motion approaches them, and what the
//! near-collision asks of the table.

mod contact;
mod convergence;
pub mod exact;
mod inner;
mod limit;
mod near_collision;

pub(crate) use contact::painleve_friction_at;
pub use contact::{
    lift_off_rate, needed_friction, painleve_friction, slip_rate, steady_wobble_rate,
};
pub use convergence::{error_law, error_law_coefficient};
pub use inner::{Arrival, Passage, passage, turn_limit_of};
pub use limit::{
    disk_turn_limit, point_mass_turn_limit, tall_turn_limit, turn_limit, turn_limit_with_spin,
};
pub use near_collision::NearCollision;

use crate::body::Body;
use crate::law::IdealLaw;

/// The two moments of inertia whose ratio J′/K′ decides the turn: without slip J and K (about the
/// rim and about the centre of the base), without friction A + mR² and A.
pub(crate) fn inertias(body: &Body, law: IdealLaw) -> (f64, f64) {
    let mrr = body.mass() * body.radius() * body.radius();
    let k = match law {
        IdealLaw::NoSlip => body.base_inertia(),
        IdealLaw::Frictionless => body.transverse_inertia(),
    };
    (k + mrr, k)
}
