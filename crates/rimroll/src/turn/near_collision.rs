//! The near-collision in isolation: the boundary layer of the paper's two sections on the angle of turn,
//! in which gravity is negligible.

use super::inertias;
use crate::body::Body;
use crate::error::{InvalidInput, bounded, finite, positive};
use crate::law::IdealLaw;

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
