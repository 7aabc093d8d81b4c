//! Flight: the rim is off the table and only gravity acts.
//!
//! Euler's equations without moments, in the frame that yaws and tilts, and a falling centre of mass:
//!
//! ```text
//! A (ẇ + ψ̇ φ̇ cosφ) = C φ̇ s,    A φ̈ = A w ψ̇ cosφ − C w s,    ṡ = 0
//! gap̈ = −(g + ρ φ̈ − z φ̇²)       since the rim's lowest point is z below the centre of mass
//! ```

use super::{Contact, Dynamics, InertialEffect, Movable, Parameters};
use crate::real::Real;
use crate::state::Coordinates;

/// The equations of motion in flight.
#[derive(Debug, Clone, Copy)]
pub struct Flight<T> {
    k: Parameters<T>,
}

impl<T: Real> Flight<T> {
    /// The equations for one body under one gravity.
    pub fn new(k: Parameters<T>) -> Self {
        Flight { k }
    }
}

impl<T: Real> Dynamics<T> for Flight<T> {
    fn parameters(&self) -> &Parameters<T> {
        &self.k
    }

    fn reduced_rates(&self, u: &Coordinates<T>) -> Coordinates<T> {
        let k = &self.k;
        let [vx, vy] = self.center_velocity(u);
        let c_over_a = k.c / k.a;
        let p = u.w * (u.w * u.cos - u.sin * c_over_a * u.s);
        let w = u.p * (u.sin * c_over_a * u.s - u.w * u.cos);
        Coordinates {
            p,
            w,
            slip_x: u.w * vy + u.sin * k.rho(u) * u.p * u.p + k.z(u) * p,
            slip_y: k.h * w - u.w * vx,
            gap: u.sin * u.gap_rate,
            gap_rate: -k.normal(u, p) / k.m,
            ..u.kinematics()
        }
    }

    fn contact(&self, _: &Coordinates<T>) -> Contact<T> {
        let zero = T::from(0.0);
        Contact {
            along: zero,
            across: zero,
            normal: zero,
        }
    }

    fn center_velocity(&self, u: &Coordinates<T>) -> [T; 2] {
        let [vx, vy] = self.k.rolling_velocity(u);
        [vx + u.slip_x, vy + u.slip_y]
    }

    fn slip(&self, u: &Coordinates<T>) -> [T; 2] {
        [u.slip_x, u.slip_y]
    }
}

impl<T: Real> Movable<T> for Flight<T> {
    fn set_gravity(&mut self, gravity: T) {
        self.k.g = gravity;
    }

    fn inertial_effect(&self, u: &Coordinates<T>, acceleration: [T; 2]) -> InertialEffect<T> {
        InertialEffect::staying_behind(u, acceleration)
    }
}
