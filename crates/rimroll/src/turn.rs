//! The angle of turn in closed form: its limits, how a motion approaches them, and what the
//! near-collision asks of the table.

mod contact;
mod convergence;
mod limit;
mod near_collision;

pub use contact::{lift_off_rate, needed_friction, slip_rate, steady_wobble_rate};
pub use convergence::{error_law, error_law_coefficient};
pub use limit::{
    disk_turn_limit, point_mass_turn_limit, tall_turn_limit, turn_limit, turn_limit_with_spin,
};
pub use near_collision::NearCollision;

use crate::body::Body;
use crate::law::LawKind;

/// The two moments of inertia whose ratio J′/K′ decides the turn: without slip J and K (about the
/// rim and about the centre of the base), without friction A + mR² and A.
pub(crate) fn inertias(body: &Body, law: LawKind) -> (f64, f64) {
    let mrr = body.mass() * body.radius() * body.radius();
    let k = match law {
        LawKind::NoSlip => body.base_inertia(),
        LawKind::Frictionless => body.transverse_inertia(),
    };
    (k + mrr, k)
}
