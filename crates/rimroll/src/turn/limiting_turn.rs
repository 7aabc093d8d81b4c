//! The limiting angle of turn as the motion comes arbitrarily close to a face-down collision.

use super::inertias;
use crate::body::Body;
use crate::error::{InvalidInput, finite, not_negative, positive};
use crate::law::IdealLaw;
use core::f64::consts::PI;

/// The limiting angle of turn, rad: π √((A + mR² + mH²)/(A + mH²)) without slip and π √((A + mR²)/A)
/// without friction.
///
/// Source: Srinivasan & Ruina (2007), Eqs. `noslipangleofturn` and `nofricangleofturn`. Erratum: the
/// last two lines of the former print the fraction upside down.
pub fn turn_limit(body: &Body, law: IdealLaw) -> f64 {
    let (j, k) = inertias(body, law);
    PI * (j / k).sqrt()
}

/// The limiting angle without slip of a body that arrives with the tipping rate ω (rad/s) and the spin
/// s = θ̇ + ψ̇ cos φ (rad/s, positive in the direction of the turn):
/// √(J/K) [π + 2 arctan(mHR s / (ω √(JK)))], provided that the contact can push and pull.
///
/// The paper's "independent of initial conditions" is the case s → 0. Close to the limit, a spin against
/// the turn keeps the normal force positive; with a spin along the turn the rim lifts off.
///
/// # Errors
/// Refuses a tipping rate ≤ 0 and a spin that is not finite.
pub fn turn_limit_with_spin(
    body: &Body,
    spin: f64,
    tipping_rate: f64,
) -> Result<f64, InvalidInput> {
    finite("spin", spin)?;
    positive("tipping_rate", tipping_rate, "rad/s")?;
    let (j, k) = inertias(body, IdealLaw::NoSlip);
    let mhr = body.mass() * body.height() * body.radius();
    let lead = libm::atan(mhr * spin / (tipping_rate * (j * k).sqrt()));
    Ok((j / k).sqrt() * (PI + 2.0 * lead))
}

/// The limiting angle of a disk (H = 0) with radius of gyration kR about its axis, rad:
/// π √(2 + k²)/k, whatever the friction.
///
/// Source: Eq. `diskangleofturn`. A uniform disk has k = 1/√2 and turns by π√5, a ring has k = 1 and turns
/// by π√3. The angle grows without bound as k → 0.
///
/// # Errors
/// Refuses k ≤ 0.
pub fn disk_turn_limit(gyration_ratio: f64) -> Result<f64, InvalidInput> {
    let k = positive("gyration_ratio", gyration_ratio, "")?;
    Ok(PI * (1.0 + 2.0 / k / k).sqrt())
}

/// The limiting angle of a tall body, H ≫ R, to first order: π + (π/2) mR²/K′ (rad) with K′ = A + mH²
/// without slip and K′ = A without friction. It exceeds the exact limit by less than (π/8) (mR²/K′)².
///
/// Source: the paper's section "Tall thin containers", extended by one order.
pub fn tall_turn_limit(body: &Body, law: IdealLaw) -> f64 {
    let (j, k) = inertias(body, law);
    PI + 0.5 * PI * (j - k) / k
}

/// The limiting angle without slip of a point mass at height H above the base (A → 0), rad:
/// π √(1 + R²/H²). Without friction, or at H = 0, it is infinite.
///
/// # Errors
/// Refuses a radius ≤ 0 and a height < 0.
pub fn point_mass_turn_limit(radius: f64, height: f64, law: IdealLaw) -> Result<f64, InvalidInput> {
    let r = positive("radius", radius, "m")?;
    let h = not_negative("height", height, "m")?;
    Ok(match law {
        IdealLaw::NoSlip => PI * (1.0 + (r / h) * (r / h)).sqrt(),
        IdealLaw::Frictionless => f64::INFINITY,
    })
}
