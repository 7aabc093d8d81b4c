//! Position and motion of a body with corners, in coordinates that are regular where it stands flat.

use super::{Vector, cross, length, times};
use crate::state::State;
use core::f64::consts::FRAC_PI_2;

/// The number of integrated coordinates on a support.
pub(super) const SUPPORTED: usize = 7;

/// The number of coordinates, with those of the height in flight.
pub(super) const COORDINATES: usize = 9;

/// Orientation and angular velocity.
///
/// Yaw and spin lose their meaning where the base is flat, and the corners differ in height there by next to nothing. The
/// upward direction in the body's axes and the sum χ = yaw + spin stay regular:
///
/// ```text
/// dΓ/dt = Γ × Ω,      dχ/dt = Ω_z + (Γ_x Ω_x + Γ_y Ω_y)/(1 + Γ_z).
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Pose {
    /// Γ, the unit vector upward: (sin φ cos θ, −sin φ sin θ, cos φ).
    pub up: Vector,
    /// Ω, rad/s.
    pub rate: Vector,
    /// χ = ψ + θ, rad.
    pub heading: f64,
    /// In flight, the height of the centre of mass, m; 0 on a support, which determines it.
    pub height: f64,
    /// In flight, the rate of the height, m/s.
    pub rise: f64,
}

impl Pose {
    pub fn from_array(u: &[f64; COORDINATES]) -> Pose {
        Pose {
            height: u[7],
            rise: u[8],
            ..Pose::supported([u[0], u[1], u[2], u[3], u[4], u[5], u[6]])
        }
    }

    pub fn into_array(self) -> [f64; COORDINATES] {
        let [a, b, c, p, q, r, heading] = self.on_support();
        [a, b, c, p, q, r, heading, self.height, self.rise]
    }

    /// From the coordinates on a support.
    pub fn supported(u: [f64; SUPPORTED]) -> Pose {
        let [a, b, c, p, q, r, heading] = u;
        Pose {
            up: [a, b, c],
            rate: [p, q, r],
            heading,
            height: 0.0,
            rise: 0.0,
        }
    }

    /// The coordinates on a support.
    pub fn on_support(&self) -> [f64; SUPPORTED] {
        let ([a, b, c], [p, q, r]) = (self.up, self.rate);
        [a, b, c, p, q, r, self.heading]
    }

    pub fn from_state(state: &State) -> Pose {
        // The double next to π/2 stands for π/2, so that a flat body rolls on its side in a plane.
        let (sin, cos) = match state.tilt == FRAC_PI_2 {
            true => (1.0, 0.0),
            false => libm::sincos(state.tilt),
        };
        let (sin_spin, cos_spin) = libm::sincos(state.spin);
        let up = [sin * cos_spin, -sin * sin_spin, cos];
        let across = [sin_spin, cos_spin, 0.0];
        let axial = [0.0, 0.0, state.spin_rate];
        Pose {
            up,
            rate: core::array::from_fn(|i| {
                state.yaw_rate * up[i] + axial[i] - state.tilt_rate * across[i]
            }),
            heading: state.yaw + state.spin,
            height: 0.0,
            rise: 0.0,
        }
    }

    /// This pose with |Γ| set to 1, from which errors of steps let it drift.
    pub fn normalised(self) -> Pose {
        let up = times(1.0 / length(self.up), self.up);
        Pose { up, ..self }
    }

    /// sin φ.
    pub fn sin_tilt(&self) -> f64 {
        libm::hypot(self.up[0], self.up[1])
    }

    /// φ, rad.
    pub fn tilt(&self) -> f64 {
        libm::atan2(self.sin_tilt(), self.up[2])
    }

    /// φ̇ sin φ, rad/s.
    pub fn tilting(&self) -> f64 {
        self.up[1] * self.rate[0] - self.up[0] * self.rate[1]
    }

    /// The angles and their rates; of all spins that differ by whole turns, the one nearest to `near`.
    pub fn state(&self, near: f64) -> State {
        let sin = self.sin_tilt();
        let (sin_near, cos_near) = libm::sincos(near);
        // e_x2, turned back by the spin `near`, is along the first axis where the spin is `near`.
        let along = self.up[0] * cos_near - self.up[1] * sin_near;
        let across = self.up[0] * sin_near + self.up[1] * cos_near;
        let spin = near - libm::atan2(across, along);
        let is_flat = sin == 0.0;
        let tilt_rate = if is_flat { 0.0 } else { self.tilting() / sin };
        let turning = self.up[0] * self.rate[0] + self.up[1] * self.rate[1];
        let yaw_rate = if is_flat { 0.0 } else { turning / (sin * sin) };
        State {
            tilt: self.tilt(),
            tilt_rate,
            yaw: self.heading - spin,
            yaw_rate,
            spin,
            spin_rate: self.rate[2] - yaw_rate * self.up[2],
        }
    }

    /// Γ̇ and χ̇.
    pub fn kinematics(&self) -> (Vector, f64) {
        let level = self.up[0] * self.rate[0] + self.up[1] * self.rate[1];
        let heading = self.rate[2] + level / (1.0 + self.up[2]);
        (cross(self.up, self.rate), heading)
    }

    /// A vector of the body in the axes of the table: the shortest rotation that takes Γ to the vertical, and a
    /// rotation by χ about it.
    pub fn on_table(&self, a: Vector) -> Vector {
        let [x, y, z] = self.up;
        let level = x * a[0] + y * a[1];
        let upright = [
            a[0] - x * (a[2] + level / (1.0 + z)),
            a[1] - y * (a[2] + level / (1.0 + z)),
            level + z * a[2],
        ];
        let (sin, cos) = libm::sincos(self.heading);
        [
            cos * upright[0] - sin * upright[1],
            sin * upright[0] + cos * upright[1],
            upright[2],
        ]
    }

    /// A vector of the table in the axes of the body, the inverse of [`Self::on_table`].
    pub fn in_body(&self, a: Vector) -> Vector {
        let [x, y, z] = self.up;
        let (sin, cos) = libm::sincos(self.heading);
        let (p, q) = (cos * a[0] + sin * a[1], cos * a[1] - sin * a[0]);
        let shift = a[2] - (x * p + y * q) / (1.0 + z);
        [p + x * shift, q + y * shift, z * a[2] - x * p - y * q]
    }
}
