//! Closed forms: the limiting angle of turn, the friction and the normal force that the motion requires, the
//! near-collision in isolation, and the approach of the turn to its limit.

use super::inertias;
use crate::body::Body;
use crate::error::{InvalidInput, bounded, finite, not_negative, positive};
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

/// The motion close to the smallest tilt φ_c, reached at time 0 with yaw 0:
/// φ² = φ_c² + ω² t² and ψ = ± √(J′/K′) arctan(ω t/φ_c), where ω is the tipping rate before and after.
///
/// Source: Eqs. `phiandt` and `psidotandphi` with b₃ = ω² φ_c² and b₂ = ± φ_c ω √(J′/K′).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NearCollision {
    /// φ_c, rad.
    pub min_tilt: f64,
    /// ω, rad/s.
    pub tipping_rate: f64,
    /// √(J′/K′) with the sign of the turn.
    pub stretch: f64,
}

impl NearCollision {
    /// The near-collision of a body; `direction` is 1 or −1, the sign of the turn.
    ///
    /// # Errors
    /// Refuses a smallest tilt or tipping rate ≤ 0 and any other direction.
    pub fn new(
        body: &Body,
        law: IdealLaw,
        min_tilt: f64,
        tipping_rate: f64,
        direction: f64,
    ) -> Result<NearCollision, InvalidInput> {
        positive("min_tilt", min_tilt, "rad")?;
        positive("tipping_rate", tipping_rate, "rad/s")?;
        finite("direction", direction)?;
        bounded(
            "direction",
            direction,
            |d| d == 1.0 || d == -1.0,
            "1 or -1",
            "",
        )?;
        let (j, k) = inertias(body, law);
        Ok(NearCollision {
            min_tilt,
            tipping_rate,
            stretch: direction * (j / k).sqrt(),
        })
    }

    /// φ at the time t (s) from the smallest tilt, rad.
    pub fn tilt(&self, t: f64) -> f64 {
        let far_tilt = self.tipping_rate * t;
        (self.min_tilt * self.min_tilt + far_tilt * far_tilt).sqrt()
    }

    /// ψ at the time t (s) from the smallest tilt, rad.
    pub fn yaw(&self, t: f64) -> f64 {
        self.stretch * libm::atan(self.tipping_rate * t / self.min_tilt)
    }

    /// ψ̇ at the time t (s) from the smallest tilt, rad/s.
    pub fn yaw_rate(&self, t: f64) -> f64 {
        let tilt = self.tilt(t);
        self.stretch * self.min_tilt * self.tipping_rate / (tilt * tilt)
    }
}

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
