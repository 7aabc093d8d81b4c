//! The line that separates the starts that come down to the left from those that come down to the right.
//!
//! Under both ideal laws l = ψ̇ sin² φ and s = θ̇ + ψ̇ cos φ obey linear equations with the tilt as
//! independent variable. The body comes down flat if l = 0 at φ = 0, so the starts that do lie on a
//! straight line in the plane of yaw and spin rates, whatever the tilt rate and gravity.

use super::fundamental_solutions::regular_solution;
use crate::body::Body;
use crate::error::{InvalidInput, bounded};
use crate::law::{IdealLaw, Parameters};
use core::f64::consts::FRAC_PI_2;

/// Yaw rate over spin rate of the starts at a tilt (rad) that come down flat, dimensionless.
///
/// Frictionless: A l + C s cos φ and s are constant and l = 0 at φ = 0, hence
/// C/(A (1 + cos φ) − C cos φ). No slip: the solution of the linear equations that is regular at φ = 0.
/// The paper says only that the side depends sensitively on the start.
///
/// # Errors
/// Refuses a tilt outside (0, π/2).
pub fn watershed_slope(body: &Body, law: IdealLaw, tilt: f64) -> Result<f64, InvalidInput> {
    let leans = |tilt: f64| 0.0 < tilt && tilt < FRAC_PI_2;
    bounded("tilt", tilt, leans, "inside (0, pi/2)", "rad")?;
    let (sin, cos) = libm::sincos(tilt);
    let (a, c) = (body.transverse_inertia(), body.axial_inertia());
    Ok(match law {
        IdealLaw::Frictionless => {
            // This is a sum of two terms that are not negative. For a flat body, C = 2A, the first one is zero.
            let half = libm::sin(0.5 * tilt);
            c / ((2.0 * a - c) * cos + 2.0 * a * half * half)
        }
        IdealLaw::NoSlip => {
            // Gravity does not enter the linear equations.
            let [l, s] = regular_solution(&Parameters::new(body, 1.0), tilt);
            let yaw_rate = l / (sin * sin);
            yaw_rate / (s - yaw_rate * cos)
        }
    })
}
