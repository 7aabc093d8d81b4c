//! The asymptotic approach of the turn to its limit, which is of order ε ln ε and not a power of ε.

use super::inertias;
use crate::body::Body;
use crate::error::{InvalidInput, positive};
use crate::law::IdealLaw;

/// The coefficient b of the error law |Δψ| = limit + φ_c (b ln φ_c + a) for the turn from tilt maximum to
/// tilt maximum, where φ_c (rad) is the smallest tilt: b = −2 √(J′/K′) R N_p/(K′ ω²).
///
/// ω (rad/s) is the tipping rate on arrival at the table, and N_p is the normal force at the end of the
/// tipping phase: m(gK/J − Hω²) without slip, mA(g − Hω²)/(A + mR²) without friction. J′/K′ is J/K
/// without slip and (A + mR²)/A without friction. For the paper's can and initial state b is −2.69 without
/// slip and −2.72 without friction.
///
/// # Errors
/// Refuses a tipping rate ≤ 0 and gravity ≤ 0.
pub fn error_law_coefficient(
    body: &Body,
    law: IdealLaw,
    tipping_rate: f64,
    gravity: f64,
) -> Result<f64, InvalidInput> {
    let w = positive("tipping_rate", tipping_rate, "rad/s")?;
    let g = positive("gravity", gravity, "m/s2")?;
    let (j, k) = inertias(body, law);
    let centripetal = body.height() * w * w;
    let normal = body.mass()
        * match law {
            IdealLaw::NoSlip => g * k / j - centripetal,
            IdealLaw::Frictionless => (g - centripetal) * k / j,
        };
    Ok(-2.0 * (j / k).sqrt() * body.radius() * normal / (k * w * w))
}

/// The error law φ_c (b ln φ_c + a), rad. The constant a depends on the whole motion and has no known closed
/// form; its relative contribution vanishes as φ_c → 0.
///
/// # Errors
/// Refuses φ_c ≤ 0.
pub fn error_law(min_tilt: f64, b: f64, a: f64) -> Result<f64, InvalidInput> {
    positive("min_tilt", min_tilt, "rad")?;
    Ok(min_tilt * (b * libm::log(min_tilt) + a))
}
