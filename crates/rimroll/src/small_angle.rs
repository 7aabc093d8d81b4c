//! The paper's heuristic small-angle treatment: the lean as a vector in the plane.
//!
//! Source: Srinivasan & Ruina (2007), section "An alternate heuristic small angle treatment". The
//! lean has length φ and direction ψ, like a position in polar coordinates; gravity and the spin about
//! the vertical are left out. Angular momentum A q̈ = M_G has no moment across q, and along q it
//! says, without slip as without friction, J′ φ̈ = K′ φ ψ̇². So
//!
//! ```text
//! q̈ = −(1 − K′/J′) h² q/|q|⁴        h = q × q̇
//! ```
//!
//! a central force with the inverse cube of the distance: the lean runs along one of Cotes's spirals,
//! φ = φ_c / cos(ψ √(K′/J′)), which turns by π √(J′/K′) where a straight line would by π.
//! Errata: the printed M_G without slip lacks a factor m, and its parts along e_x1 and e_z have the
//! wrong sign; the printed `M` without friction is the mass m.

use crate::error::{InvalidInput, positive};
use crate::solve::{Stepper, System};
use crate::turn::NearCollision;

/// The lean in the plane: position, velocity and time.
const PLANE: usize = 5;

struct InverseCube {
    /// (1 − K′/J′) h².
    strength: f64,
    /// Duration of the near-collision, s.
    time: f64,
}

impl System<f64, PLANE> for InverseCube {
    fn rates(&self, u: &[f64; PLANE]) -> [f64; PLANE] {
        let [x, y, vx, vy, _] = *u;
        let square = x * x + y * y;
        let pull = -self.strength / (square * square);
        [vx, vy, pull * x, pull * y, 1.0]
    }

    fn scale(&self, u: &[f64; PLANE]) -> [f64; PLANE] {
        let [x, y, vx, vy, t] = *u;
        let (distance, speed) = ((x * x + y * y).sqrt(), (vx * vx + vy * vy).sqrt());
        [distance, distance, speed, speed, self.time + t]
    }
}

/// Integrates the plane vector from the smallest tilt on, until `until` (s): samples of
/// (t, φ, ψ − ψ_c) at the solver's steps. The motion before is its mirror image.
///
/// # Errors
/// Refuses a time that is not finite or ≤ 0.
pub fn lean_vector(near: &NearCollision, until: f64) -> Result<Vec<[f64; 3]>, InvalidInput> {
    positive("until", until, "s")?;
    let sideways = near.tipping_rate * near.stretch;
    let moment = near.min_tilt * sideways;
    let system = InverseCube {
        strength: (1.0 - 1.0 / (near.stretch * near.stretch)) * moment * moment,
        time: near.min_tilt / near.tipping_rate,
    };
    let start = [near.min_tilt, 0.0, 0.0, sideways, 0.0];
    let mut stepper = Stepper::new(&system, start, 0.01 * system.time, 1e-13);
    let mut samples = vec![[0.0, near.min_tilt, 0.0]];
    let mut yaw = 0.0;
    while let Ok(step) = stepper.advance() {
        let dense = step.dense(&system);
        for i in 1..=4 {
            let x = f64::from(i) / 4.0;
            let [[ax, ay, ..], [bx, by, .., t]] = [dense.at(x - 0.25), dense.at(x)];
            if t > until {
                return Ok(samples);
            }
            // The angle between neighbours adds up beyond π, which that of one vector would not.
            yaw += libm::atan2(ax * by - ay * bx, ax * bx + ay * by);
            samples.push([t, (bx * bx + by * by).sqrt(), yaw]);
        }
    }
    Ok(samples)
}
