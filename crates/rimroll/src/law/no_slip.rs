//! Rolling without slip: the point of the rim that touches the table is at rest.
//!
//! Source: Srinivasan & Ruina (2007), Eqs. `generalcyl`, `noslip_eqs` and appendix A, printed
//! correctly, in an equivalent form. Rows 1 and 3 of Q q̈ = S, with l = ψ̇ sin² φ and
//! s = θ̇ + ψ̇ cos φ, are linear in (l, s) with the tilt as clock:
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

use super::{Contact, Law, Parameters};
use crate::real::Real;
use crate::state::Coordinates;

/// The law; made once for a body, since its coefficients do not change on the way.
#[derive(Debug, Clone, Copy)]
pub struct NoSlip<T> {
    k: Parameters<T>,
    /// K = A + mH².
    base_inertia: T,
    /// J = K + mR².
    rim_inertia: T,
    /// mHR.
    mhr: T,
    /// C + mR².
    c_rolling: T,
    /// l̇/(φ̇ sin φ) = `l_of_s` s − `l_of_w` w.
    l_of_s: T,
    l_of_w: T,
    /// ṡ/φ̇ = `s_of_w` w + `s_of_s` s.
    s_of_w: T,
    s_of_s: T,
}

impl<T: Real> NoSlip<T> {
    /// The law for one body under one gravity.
    pub fn new(k: Parameters<T>) -> Self {
        let mhr = k.m * k.h * k.r;
        let mrr = k.m * k.r * k.r;
        let base_inertia = k.a + k.m * k.h * k.h;
        let c_rolling = k.c + mrr;
        let determinant = k.c * base_inertia + mrr * k.a;
        NoSlip {
            k,
            base_inertia,
            rim_inertia: base_inertia + mrr,
            mhr,
            c_rolling,
            l_of_s: k.c * c_rolling / determinant,
            l_of_w: k.c * mhr / determinant,
            s_of_w: mrr * k.a / determinant,
            s_of_s: k.c * mhr / determinant,
        }
    }

    /// (dp/dτ, dw/dτ, ds/dτ).
    #[inline(always)]
    fn accelerations(&self, u: &Coordinates<T>) -> [T; 3] {
        let NoSlip { k, mhr, .. } = self;
        let through_collision = u.cos * u.w * (self.base_inertia * u.w - *mhr * u.s);
        let elsewhere = u.w * (*mhr * u.w - self.c_rolling * u.s) - k.m * k.g * k.rho(u);
        let dp = (through_collision + u.sin * elsewhere) / self.rim_inertia;
        let dw = u.p * (u.sin * (self.l_of_s * u.s - self.l_of_w * u.w) - u.w * u.cos);
        let ds = u.sin * u.p * (self.s_of_w * u.w + self.s_of_s * u.s);
        [dp, dw, ds]
    }
}

impl<T: Real> Law<T> for NoSlip<T> {
    fn parameters(&self) -> &Parameters<T> {
        &self.k
    }

    #[inline(always)]
    fn rates(&self, u: &Coordinates<T>) -> Coordinates<T> {
        let [p, w, s] = self.accelerations(u);
        Coordinates {
            p,
            w,
            s,
            ..u.kinematics(self.center_velocity(u))
        }
    }

    /// Friction from horizontal momentum along e_x1, and from the axial moment C ṡ = −R T_y.
    fn contact(&self, u: &Coordinates<T>) -> Contact<T> {
        let NoSlip { k, .. } = self;
        let [dp, _, ds] = self.accelerations(u);
        let along = u.w * (k.h * u.w - k.r * u.s) - k.z(u) * dp - u.sin * k.rho(u) * u.p * u.p;
        Contact {
            along: k.m * along,
            across: -k.c * ds / k.r,
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

    /// Moments alone would make the rim slip along e_y1 by H L_x/A − R L_z/C in a second.
    fn hold(&self, moment: [T; 2]) -> Option<T> {
        let k = &self.k;
        let slip = k.h * moment[0] / k.a - k.r * moment[1] / k.c;
        Some(-slip / k.sideways_mobility())
    }

    fn only_moves(&self) -> bool {
        true
    }
}
