//! All quantities of a motion at one instant, as users read them.

use crate::law::{Contact, Dynamics, DynamicsExt};
use crate::state::Coordinates;

/// The names of the quantities at one instant, in SI units and radians.
///
/// `x`, `y`, `z` are the centre of mass. The contact point (in flight: the point below the rim's lowest
/// point), friction and slip are vectors in the plane of the table. `friction_ratio` is |T|/N. For a rim that
/// slides the law prescribes it; for a rim that rolls it is the coefficient that rolling needs, which is
/// infinite where friction is needed and the normal force is zero, as at a lift-off from rolling.
pub const COLUMNS: [&str; 26] = [
    "t",
    "tilt",
    "tilt_rate",
    "yaw",
    "yaw_rate",
    "spin",
    "spin_rate",
    "axial_spin",
    "x",
    "y",
    "z",
    "contact_x",
    "contact_y",
    "normal_force",
    "friction_x",
    "friction_y",
    "friction_ratio",
    "slip_x",
    "slip_y",
    "gap",
    "kinetic_energy",
    "potential_energy",
    "friction_loss",
    "resistance_loss",
    "impact_loss",
    "ground_work",
];

/// The quantities at one instant: a number for each of [`COLUMNS`].
pub type Observables = [f64; COLUMNS.len()];

/// The first quantities of [`Observables`]: time, position and motion, which do not depend on the law.
pub type Pose = [f64; 8];

/// The quantities that follow from the coordinates alone.
pub fn pose(u: &Coordinates<f64>) -> Pose {
    let state = u.state();
    [
        u.t,
        state.tilt,
        state.tilt_rate,
        state.yaw,
        state.yaw_rate,
        state.spin,
        state.spin_rate,
        u.s,
    ]
}

/// All quantities of a motion under these equations of motion at `u`. The force of the table (N) is given where the base
/// is level and the equations do not contain it.
pub(super) fn observables(
    dynamics: &dyn Dynamics<f64>,
    u: &Coordinates<f64>,
    force: Option<Contact<f64>>,
) -> Observables {
    let k = dynamics.parameters();
    let [t, tilt, tilt_rate, yaw, yaw_rate, spin, spin_rate, s] = pose(u);
    let (sin_yaw, cos_yaw) = libm::sincos(u.yaw);
    let [x, y] = u.center();
    let rho = k.rho(u);
    let scale = if force.is_some() { 1.0 } else { u.sin };
    let force = force.unwrap_or_else(|| dynamics.contact(u));
    let (along, across) = (force.along / scale, force.across / scale);
    let friction = (force.along * force.along + force.across * force.across).sqrt();
    let needed = match dynamics.friction_ratio(u) {
        Some(ratio) if ratio.is_finite() => ratio,
        _ if friction == 0.0 => 0.0,
        _ if force.normal > 0.0 => friction / force.normal,
        // Without a normal force there is no friction at any coefficient.
        _ => f64::INFINITY,
    };
    let energy = dynamics.energy(u);
    let [slip_along, slip_across] = dynamics.slip(u);
    [
        t,
        tilt,
        tilt_rate,
        yaw,
        yaw_rate,
        spin,
        spin_rate,
        s,
        x,
        y,
        k.z(u) + u.gap,
        x - rho * cos_yaw,
        y - rho * sin_yaw,
        force.normal / scale,
        along * cos_yaw - across * sin_yaw,
        along * sin_yaw + across * cos_yaw,
        needed,
        slip_along * cos_yaw - slip_across * sin_yaw,
        slip_along * sin_yaw + slip_across * cos_yaw,
        u.gap,
        energy.kinetic,
        energy.potential,
        u.friction_loss,
        u.resistance_loss,
        u.impact_loss,
        u.ground_work,
    ]
}
