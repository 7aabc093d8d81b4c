//! Rolling without slip: the contact point of the rim is at rest.
//!
//! Source: Srinivasan & Ruina (2007), Eqs. `generalcyl`, `noslip_eqs` and appendix A, printed
//! correctly, in an equivalent form. Rows 1 and 3 of Q q̈ = S, with l = ψ̇ sin² φ and
//! s = θ̇ + ψ̇ cos φ, are linear in (l, s) with the tilt as independent variable:
//!
//! ```text
//! (A + mH²) l̇/sinφ − mHR ṡ = C s φ̇ − mHR w φ̇
//! −mHR l̇/sinφ + (C + mR²) ṡ = mR² w φ̇                w = ψ̇ sin φ = l / sin φ
//! ```
//!
//! Their determinant D = C K + mR² A is a constant. Row 2 is, with K = A + mH², J = K + mR²,
//!
//! ```text
//! J φ̈ = K w ψ̇ cosφ − mHR s ψ̇ cosφ − (C + mR²) w s + mHR w² − mgρ
//! ```
//!
//! On a table with the horizontal acceleration (a₁, a₂), the inertial force adds (m z/J) a₁ to φ̈, (mHC/D) a₂ to ẇ
//! and −(mRA/D) a₂ to ṡ.

use super::{Contact, Dynamics, InertialEffect, Movable, Parameters, Response};
use crate::real::{Real, fieldwise};
use crate::state::Coordinates;

/// The equations of motion without slip, with the coefficients that are constant for a body.
#[derive(Debug, Clone, Copy)]
pub struct NoSlip<T> {
    k: Parameters<T>,
    /// K/J with K = A + mH² and J = K + mR².
    base_inertia: T,
    /// mHR/J.
    mhr: T,
    /// (C + mR²)/J.
    c_rolling: T,
    /// mgR/J and mgH/J, the coefficients of cos φ and sin φ in mgρ/J.
    weight_of_cos: T,
    weight_of_sin: T,
    /// l̇/(φ̇ sin φ) = `l_of_s` s − `l_of_w` w.
    l_of_s: T,
    l_of_w: T,
    /// ṡ/φ̇ = `s_of_w` w + `s_of_s` s.
    s_of_w: T,
    s_of_s: T,
    /// C/R.
    c_over_r: T,
}

fieldwise!(NoSlip {
    base_inertia, mhr, c_rolling, weight_of_cos, weight_of_sin, l_of_s, l_of_w, s_of_w, s_of_s, c_over_r; k
});

impl<T: Real> NoSlip<T> {
    /// The equations for one body under one gravity.
    pub fn new(k: Parameters<T>) -> Self {
        let mhr = k.m * k.h * k.r;
        let mrr = k.m * k.r * k.r;
        let base_inertia = k.a + k.m * k.h * k.h;
        let c_rolling = k.c + mrr;
        let rim_inertia = base_inertia + mrr;
        let determinant = k.c * base_inertia + mrr * k.a;
        NoSlip {
            k,
            base_inertia: base_inertia / rim_inertia,
            mhr: mhr / rim_inertia,
            c_rolling: c_rolling / rim_inertia,
            weight_of_cos: k.m * k.g * k.r / rim_inertia,
            weight_of_sin: k.m * k.g * k.h / rim_inertia,
            l_of_s: k.c * c_rolling / determinant,
            l_of_w: k.c * mhr / determinant,
            s_of_w: mrr * k.a / determinant,
            s_of_s: k.c * mhr / determinant,
            c_over_r: k.c / k.r,
        }
    }

    /// (dp/dτ, dw/dτ, ds/dτ).
    #[inline(always)]
    pub(super) fn accelerations(&self, u: &Coordinates<T>) -> [T; 3] {
        let (falling, level) = (u.sin * u.p, u.w * u.cos);
        let through_collision = level * (self.base_inertia * u.w - self.mhr * u.s);
        let gyroscopic = u.w * (self.mhr * u.w - self.c_rolling * u.s);
        let weight = self.weight_of_sin * u.sin - self.weight_of_cos * u.cos;
        let dp = through_collision + u.sin * (gyroscopic + weight);
        let dw = falling * (self.l_of_s * u.s - self.l_of_w * u.w) - u.p * level;
        let ds = falling * (self.s_of_w * u.w + self.s_of_s * u.s);
        [dp, dw, ds]
    }
}

impl<T: Real> Dynamics<T> for NoSlip<T> {
    fn parameters(&self) -> &Parameters<T> {
        &self.k
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

    /// Friction from horizontal momentum along e_x1, and from the axial moment C ṡ = −R T_y.
    #[inline(always)]
    fn contact(&self, u: &Coordinates<T>) -> Contact<T> {
        let NoSlip { k, .. } = self;
        let [dp, _, ds] = self.accelerations(u);
        let along = u.w * (k.h * u.w - k.r * u.s) - k.z(u) * dp - u.sin * k.rho(u) * u.p * u.p;
        Contact {
            along: k.m * along,
            across: -self.c_over_r * ds,
            normal: k.normal(u, dp),
        }
    }

    #[inline(always)]
    fn center_velocity(&self, u: &Coordinates<T>) -> [T; 2] {
        self.k.rolling_velocity(u)
    }

    fn slip(&self, _: &Coordinates<T>) -> [T; 2] {
        [T::from(0.0), T::from(0.0)]
    }

    /// Without the reaction, the moments would accelerate the slip along e_y1 by H L_x/A − R L_z/C.
    #[inline(always)]
    fn constrained_response(&self, _: &Coordinates<T>, moment: [T; 2]) -> Option<Response<T>> {
        let k = &self.k;
        let slip = k.h * moment[0] / k.a - k.r * moment[1] / k.c;
        let across = -slip / k.sideways_mobility();
        Some(Response::to(k, moment, across))
    }

    fn is_conservative(&self) -> bool {
        true
    }
}

impl<T: Real> Movable<T> for NoSlip<T> {
    #[inline(always)]
    fn set_gravity(&mut self, gravity: T) {
        let ratio = gravity * (T::from(1.0) / self.k.g);
        self.weight_of_cos = ratio * self.weight_of_cos;
        self.weight_of_sin = ratio * self.weight_of_sin;
        self.k.g = gravity;
    }

    // Reciprocals of constants are computed once for all stages of a step.
    #[inline(always)]
    fn inertial_effect(&self, u: &Coordinates<T>, [along, across]: [T; 2]) -> InertialEffect<T> {
        let k = &self.k;
        let per_radius = T::from(1.0) / k.r;
        // m/J = (mgR/J)/(gR), mHC/D = (mHRC/D)/R and mRA/D = (mR²A/D)/R.
        let p_of_along = self.weight_of_cos * per_radius * (T::from(1.0) / k.g);
        let p = p_of_along * (u.sin * k.z(u)) * along;
        let w = (self.s_of_s * per_radius) * u.sin * across;
        let s = -((self.s_of_w * per_radius) * u.sin * across);
        InertialEffect {
            p,
            w,
            s,
            slip: [T::from(0.0); 2],
            contact: Contact {
                along: k.m * (u.sin * along - k.z(u) * p),
                across: -(self.c_over_r * s),
                normal: k.m * k.rho(u) * p,
            },
        }
    }
}
