//! The friction and normal force that the motion requires.

use super::inertias;
use crate::body::Body;
use crate::error::{InvalidInput, positive};
use crate::law::IdealLaw;

/// The coefficient of friction needed to roll through the near-collision: μ* = mHR/(A + mH²).
///
/// |T|/N tends to this value and stays there through the whole near-collision, however violent (the paper
/// notes "only a finite coefficient" in its simulation figure and gives no formula).
pub fn needed_friction(body: &Body) -> f64 {
    body.mass() * body.height() * body.radius() / body.base_inertia()
}

/// The tipping rate on arrival, rad/s, above which rolling without slip requires a negative normal force
/// just before the near-collision: ω = √(gK/(JH)). Infinite for a disk.
///
/// # Errors
/// Refuses gravity ≤ 0.
pub fn lift_off_rate(body: &Body, gravity: f64) -> Result<f64, InvalidInput> {
    let g = positive("gravity", gravity, "m/s2")?;
    let (j, k) = inertias(body, IdealLaw::NoSlip);
    Ok((g * k / (j * body.height())).sqrt())
}

/// The tipping rate on arrival, rad/s, above which the end of the tipping phase needs a coefficient of
/// friction larger than μ*: ω = √(2mgHK/(J(K + mH²))). For a disk it is 0; a disk needs its largest
/// coefficient elsewhere.
///
/// # Errors
/// Refuses gravity ≤ 0.
pub fn slip_rate(body: &Body, gravity: f64) -> Result<f64, InvalidInput> {
    let g = positive("gravity", gravity, "m/s2")?;
    let (j, k) = inertias(body, IdealLaw::NoSlip);
    let (m, h) = (body.mass(), body.height());
    Ok((2.0 * m * g * h * k / (j * (k + m * h * h))).sqrt())
}

/// The smallest coefficient of friction at which a sliding body can meet the Painlevé paradox:
/// 2 √(q (1 + q)) with q = A/(m (R² + H²)). Below it the normal force is determined at every tilt.
///
/// At a given tilt the paradox begins at μ = (A + mρ²)/(m|ρ|z), for a slip along e_x1. With
/// ρ = L sin α, z = L cos α, L² = R² + H² and α measured from the balance point, that is
/// q/t + (1 + q) t for t = tan |α|, with a minimum at t² = q/(1 + q). A tilt with that α always lies
/// between upright and π/2, on one side of the balance point or the other.
pub fn painleve_friction(body: &Body) -> f64 {
    let (r, h) = (body.radius(), body.height());
    let q = body.transverse_inertia() / (body.mass() * (r * r + h * h));
    2.0 * (q * (1.0 + q)).sqrt()
}
