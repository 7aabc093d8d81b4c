//! A moment of a motion in full: what a user reads off the coordinates.

use crate::law::Dynamics;
use crate::state::Coordinates;

/// What is known at one moment, in SI units and radians. `x`, `y`, `z` are the centre of mass; contact
/// point (in flight: the point under the rim's lowest), friction and slip are on the table.
/// `friction_ratio` is |T|/N: what the law says of a rim that slides, the coefficient that it would need of one
/// that rolls, infinite where it would need friction and nothing presses, as at a lift-off from rolling.
pub const COLUMNS: [&str; 25] = [
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
];

/// One moment: a number for each of [`COLUMNS`].
pub type Moment = [f64; COLUMNS.len()];

/// The first of a [`Moment`]: when, where the body is and how it moves, which no law is needed to tell.
pub type Pose = [f64; 8];

/// What can be read off the coordinates by themselves.
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

/// All that is known when a motion under `law` is at `u`.
pub fn moment(law: &dyn Dynamics<f64>, u: &Coordinates<f64>) -> Moment {
    let k = law.parameters();
    let [t, tilt, tilt_rate, yaw, yaw_rate, spin, spin_rate, s] = pose(u);
    let (sin_yaw, cos_yaw) = libm::sincos(u.yaw);
    let [x, y] = u.center();
    let rho = k.rho(u);
    let force = law.contact(u);
    let (along, across) = (force.along / u.sin, force.across / u.sin);
    let friction = (force.along * force.along + force.across * force.across).sqrt();
    let needed = match law.friction_ratio(u) {
        Some(ratio) if ratio.is_finite() => ratio,
        _ if friction == 0.0 => 0.0,
        _ if force.normal > 0.0 => friction / force.normal,
        // Where nothing presses, no friction is had at any coefficient.
        _ => f64::INFINITY,
    };
    let energy = law.energy(u);
    let [slip_along, slip_across] = law.slip(u);
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
        force.normal / u.sin,
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
    ]
}
