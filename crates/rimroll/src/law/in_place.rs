//! Wobbling in place: the rim rolls without slip on the circle on which the body stood, θ = −ψ.
//!
//! Studies of free-standing columns in earthquakes use this law: M. F. Vassiliou et al., Earthquake Eng. Struct. Dyn.
//! 46 (2017) 2261. It leaves out that a real column can roll away from where it stood.
//!
//! Beside the force, the table exerts a twisting moment that is as large as it takes and does no work. The body rotates
//! about e_y1 and about e_x1 + tan(φ/2) e_z, so this moment is along e_z − tan(φ/2) e_x1: nearly vertical at a small
//! tilt.
//!
//! Two coordinates remain, tilt and yaw, with the inertias J and I:
//!
//! ```text
//! L = J φ̇²/2 + I ψ̇²/2 − mgz        I = A sin² φ + C (1 − cos φ)² + m (R − ρ)²
//! J φ̈ = (dI/dφ) ψ̇²/2 − mgρ        I ψ̇ = constant
//! ```
//!
//! The twisting moment has no component along e_y1, so φ̈ is that of [`NoSlip`] in the same state. In our coordinates
//! the constraint is s = −w tan(φ/2). With
//!
//! ```text
//! I = (1 − cos φ) E,    E = K (1 + cos φ) + (C + mR²)(1 − cos φ) + 2mHR sin φ        K = A + mH²
//! ```
//!
//! I ψ̇ = −s E and w/s = −sin φ/(1 − cos φ), hence
//!
//! ```text
//! ṡ/s = −(dE/dφ) φ̇/E        ẇ/w = ṡ/s − φ̇/sin φ
//! ```
//!
//! In this form the error of each stays relative to its own size. E is positive at all tilts, also where a disk lies on
//! its other face.
//!
//! On a table with the horizontal acceleration (a₁, a₂), the inertial force adds (m z/J) a₁ to φ̈ and m (R − ρ) a₂
//! to the rate of I ψ̇.

use super::{Contact, Dynamics, InertialEffect, Movable, NoSlip, Parameters, Response};
use crate::error::{InvalidInput, bounded};
use crate::real::Real;
use crate::state::{Coordinates, State};

/// The equations of motion in place.
#[derive(Debug, Clone, Copy)]
pub struct InPlace<T> {
    /// The equations without the twisting moment.
    rolling: NoSlip<T>,
    /// E = `e` + `e_of_cos` cos φ + `e_of_sin` sin φ.
    e: T,
    e_of_cos: T,
    e_of_sin: T,
}

impl<T: Real> InPlace<T> {
    /// The equations for one body under one gravity.
    pub fn new(k: Parameters<T>) -> Self {
        let base_inertia = k.a + k.m * k.h * k.h;
        let c_rolling = k.c + k.m * k.r * k.r;
        InPlace {
            rolling: NoSlip::new(k),
            e: base_inertia + c_rolling,
            e_of_cos: base_inertia - c_rolling,
            e_of_sin: T::from(2.0) * k.m * k.h * k.r,
        }
    }

    /// I ψ̇ = −s E, which is constant on a table at rest, kg m²/s.
    pub fn yaw_momentum(&self, u: &Coordinates<T>) -> T {
        -(u.s * self.e_at(u))
    }

    /// E.
    #[inline(always)]
    fn e_at(&self, u: &Coordinates<T>) -> T {
        self.e + self.e_of_cos * u.cos + self.e_of_sin * u.sin
    }

    /// (dp/dτ, dw/dτ, ds/dτ).
    #[inline(always)]
    fn accelerations(&self, u: &Coordinates<T>) -> [T; 3] {
        let [dp, ..] = self.rolling.accelerations(u);
        // −d ln E/dτ.
        let growth = u.p * u.sin * (self.e_of_cos * u.sin - self.e_of_sin * u.cos) / self.e_at(u);
        [dp, u.w * (growth - u.p), u.s * growth]
    }

    /// The force along e_y1 that accelerates the centre of mass at the rates dw/dτ and ds/dτ.
    #[inline(always)]
    fn across(&self, dw: T, ds: T) -> T {
        let k = self.rolling.parameters();
        k.m * (k.r * ds - k.h * dw)
    }
}

impl InPlace<f64> {
    /// The start of a motion: the spin rate that the constraint demands replaces a spin rate of 0.
    ///
    /// # Errors
    /// Refuses a spin rate that is neither 0 nor the opposite of the yaw rate.
    pub fn start(start: &State) -> Result<Coordinates<f64>, InvalidInput> {
        /// A state taken from a motion satisfies the constraint within its error.
        const ACCURACY: f64 = 1e-6;
        let free = start.spin_rate + start.yaw_rate;
        let allowed = |rate: f64| rate == 0.0 || free.abs() <= ACCURACY * start.yaw_rate.abs();
        let bound = "0 or -yaw_rate for a body that wobbles in place";
        bounded("spin_rate", start.spin_rate, allowed, bound, "rad/s")?;
        let u = Coordinates::from_state(start);
        let half_tangent = libm::tan(0.5 * start.tilt);
        Ok(Coordinates {
            s: 0.0 - u.w * half_tangent,
            ..u
        })
    }
}

impl<T: Real> Dynamics<T> for InPlace<T> {
    fn parameters(&self) -> &Parameters<T> {
        self.rolling.parameters()
    }

    #[inline(always)]
    fn reduced_rates(&self, u: &Coordinates<T>) -> Coordinates<T> {
        let [p, w, s] = self.accelerations(u);
        Coordinates {
            p,
            w,
            s,
            ..u.kinematics()
        }
    }

    /// Along e_x1 and e_z that of [`NoSlip`], along e_y1 from the momentum of the centre of mass.
    #[inline(always)]
    fn contact(&self, u: &Coordinates<T>) -> Contact<T> {
        let k = self.rolling.parameters();
        let [_, dw, ds] = self.accelerations(u);
        Contact {
            across: self.across(dw, ds) - k.m * u.w * k.z(u) * u.p,
            ..self.rolling.contact(u)
        }
    }

    #[inline(always)]
    fn center_velocity(&self, u: &Coordinates<T>) -> [T; 2] {
        self.rolling.center_velocity(u)
    }

    fn slip(&self, u: &Coordinates<T>) -> [T; 2] {
        self.rolling.slip(u)
    }

    /// The moments do work on w and s = −w tan(φ/2), and the inertia of w is I/sin² φ = E/(1 + cos φ).
    fn constrained_response(&self, u: &Coordinates<T>, moment: [T; 2]) -> Option<Response<T>> {
        let one = T::from(1.0);
        let [about_x, about_z] = moment;
        let w = ((one + u.cos) * about_x - u.sin * about_z) / self.e_at(u);
        let s = -((u.sin * about_x - (one - u.cos) * about_z) / self.e_at(u));
        let across = self.across(w, s);
        Some(Response { w, s, across })
    }

    fn is_conservative(&self) -> bool {
        true
    }
}

impl<T: Real> Movable<T> for InPlace<T> {
    #[inline(always)]
    fn set_gravity(&mut self, gravity: T) {
        self.rolling.set_gravity(gravity);
    }

    #[inline(always)]
    fn inertial_effect(&self, u: &Coordinates<T>, acceleration: [T; 2]) -> InertialEffect<T> {
        let k = self.rolling.parameters();
        let rolling = self.rolling.inertial_effect(u, acceleration);
        let across = k.m * u.sin * acceleration[1];
        let pushed = across / self.e_at(u);
        let (upright, versine) = (T::from(1.0) + u.cos, T::from(1.0) - u.cos);
        let w = (k.r * u.sin + k.h * upright) * pushed;
        let s = -((k.r * versine + k.h * u.sin) * pushed);
        InertialEffect {
            w,
            s,
            contact: Contact {
                across: across + self.across(w, s),
                ..rolling.contact
            },
            ..rolling
        }
    }
}
