//! Sliding without friction: the table exerts only a normal force.
//!
//! Source: Srinivasan & Ruina (2007), Eqs. `generalcyl`, `nofric_eqs` and appendix A, printed
//! correctly. Row 3 is ṡ = 0 (Eq. `slipangmom`); row 1 is, with l = ψ̇ sin² φ,
//!
//! ```text
//! A l̇/sinφ = C s φ̇            (so A l + C s cosφ, the vertical angular momentum, is conserved)
//! ```
//!
//! and row 2, with w = ψ̇ sin φ,
//!
//! ```text
//! (A + mρ²) φ̈ = A w ψ̇ cosφ − C w s + mρz φ̇² − mgρ
//! ```
//!
//! The horizontal velocity of the centre of mass is constant; it is zero in the frame chosen here.

use super::{Contact, Dynamics, Friction, FrictionForce, Parameters};
use crate::real::{Real, fieldwise};
use crate::state::Coordinates;

/// The friction force that is always zero. A rim that slides under it has a slip among its coordinates, as it must
/// on a table that moves, where the centre of mass stays behind.
#[derive(Debug, Clone, Copy)]
pub(crate) struct NoFriction;

impl<T: Real> Friction<T> for NoFriction {
    #[inline(always)]
    fn friction_force(&self, slip: [T; 2]) -> FrictionForce<T> {
        FrictionForce::proportional_to_normal(slip, T::from(0.0))
    }
}

/// The equations of motion without friction.
#[derive(Debug, Clone, Copy)]
pub struct Frictionless<T> {
    k: Parameters<T>,
    /// C/A.
    c_over_a: T,
}

fieldwise!(Frictionless { c_over_a; k });

impl<T: Real> Frictionless<T> {
    /// The equations for one body under one gravity.
    pub fn new(k: Parameters<T>) -> Self {
        Frictionless {
            k,
            c_over_a: k.c / k.a,
        }
    }

    /// dp/dτ.
    #[inline(always)]
    fn tilt_acceleration(&self, u: &Coordinates<T>) -> T {
        let k = &self.k;
        let rho = k.rho(u);
        // The division comes first, so that the processor can overlap it with the rest.
        let per_inertia = T::from(1.0) / (k.a + k.m * rho * rho);
        let outside_collision = k.m * rho * (k.z(u) * u.p * u.p - k.g) - k.c * u.w * u.s;
        (k.a * u.w * u.w * u.cos + u.sin * outside_collision) * per_inertia
    }
}

impl<T: Real> Dynamics<T> for Frictionless<T> {
    fn parameters(&self) -> &Parameters<T> {
        &self.k
    }

    #[inline(always)]
    fn reduced_rates(&self, u: &Coordinates<T>) -> Coordinates<T> {
        Coordinates {
            p: self.tilt_acceleration(u),
            w: u.p * (u.sin * self.c_over_a * u.s - u.w * u.cos),
            ..u.kinematics()
        }
    }

    /// N = m (g + ρ φ̈ − z φ̇²) with φ̈ from row 2 substituted, which avoids cancellation for A ≪ mR².
    #[inline(always)]
    fn contact(&self, u: &Coordinates<T>) -> Contact<T> {
        let k = &self.k;
        let rho = k.rho(u);
        let falling = k.a * u.sin * (k.g - k.z(u) * u.p * u.p);
        let gyroscopic_term = rho * u.w * (k.a * u.w * u.cos - k.c * u.sin * u.s);
        Contact {
            along: T::from(0.0),
            across: T::from(0.0),
            normal: k.m * (falling + gyroscopic_term) / (k.a + k.m * rho * rho),
        }
    }

    #[inline(always)]
    fn center_velocity(&self, _: &Coordinates<T>) -> [T; 2] {
        [T::from(0.0), T::from(0.0)]
    }

    fn is_conservative(&self) -> bool {
        true
    }
}
