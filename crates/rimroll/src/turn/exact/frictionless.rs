//! The tilt of a body that slides without friction.
//!
//! s = θ̇ + ψ̇ cos φ and the vertical angular momentum A l + C s cos φ are constant (Eqs. `slipangmom` and
//! `generalcyl`), hence
//!
//! ```text
//! l = l₀ + (C s/A)(1 − cos φ)           w = l / sin φ
//! (A + mρ²) φ̇² = 2E − A w² − 2mg (z − H)
//! ```

use super::tilt_equation::Start;
use super::tilt_equation::{
    Conserved, Point, TiltEquation, YawAndTimeRates, gap_beyond, half_tangent_at_rise,
    sin_and_versine,
};
use crate::law::Parameters;
use crate::real::Real;

/// The motion of a frictionless body from one start. C is the number type of the body's constants, T that of the
/// start.
#[derive(Debug, Clone, Copy)]
pub(super) struct FrictionlessTilt<C, T> {
    k: Parameters<C>,
    /// s, rad/s.
    s: T,
    /// l₀ = l at φ = 0, rad/s.
    l_flat: T,
    /// C s/A, rad/s.
    l_of_versine: T,
    /// 2E relative to the body at rest upright, without the energy of spin, J.
    energy: T,
    /// `energy` without that of yaw, J.
    tilting_energy: T,
}

impl<C: Copy + Into<T>, T: Real> FrictionlessTilt<C, T> {
    #[inline(always)]
    pub(super) fn new(k: Parameters<C>, start: &Start<T>) -> Self {
        let Start { y, w, s, .. } = *start;
        let [_, _, _, a, c, _] = k.as_array::<T>();
        let (sin, versine) = sin_and_versine(y);
        let l_of_versine = c * s / a;
        let tilting_energy = Self::tilting_energy(&k, start);
        FrictionlessTilt {
            k,
            s,
            l_flat: w * sin - l_of_versine * versine,
            l_of_versine,
            energy: tilting_energy + a * w * w,
            tilting_energy,
        }
    }

    /// Twice the energy relative to the body at rest upright, without that of yaw and spin, J.
    #[inline(always)]
    pub(super) fn tilting_energy(k: &Parameters<C>, start: &Start<T>) -> T {
        let [m, r, h, a, _, g] = k.as_array::<T>();
        let (sin, versine) = sin_and_versine(start.y);
        let rho = r * (T::from(1.0) - versine) - h * sin;
        let rise = r * sin - h * versine;
        (a + m * rho * rho) * start.p * start.p + T::from(2.0) * m * g * rise
    }

    /// The motion with the quantities of [`TiltEquation::conserved`].
    #[inline(always)]
    pub(super) fn from_conserved(k: Parameters<C>, conserved: Conserved<T>) -> Self {
        let [s, l_flat, energy, tilting_energy] = conserved;
        let (a, c): (T, T) = (k.a.into(), k.c.into());
        FrictionlessTilt {
            k,
            s,
            l_flat,
            l_of_versine: c * s / a,
            energy,
            tilting_energy,
        }
    }
}

impl<C: Copy + Into<T>, T: Real> TiltEquation<T> for FrictionlessTilt<C, T> {
    #[inline(always)]
    fn conserved(&self) -> Conserved<T> {
        [self.s, self.l_flat, self.energy, self.tilting_energy]
    }

    #[inline(always)]
    fn at(&self, y: T, _: T) -> Point<T> {
        let [m, r, h, a, _, g] = self.k.as_array::<T>();
        let two = T::from(2.0);
        let (sin, versine) = sin_and_versine(y);
        let cos = T::from(1.0) - versine;
        let rho = r * cos - h * sin;
        let w = (self.l_flat + self.l_of_versine * versine) / sin;
        let weight = two * m * g;
        Point {
            sin,
            cos,
            w,
            s: self.s,
            inertia: a + m * rho * rho,
            drive: self.energy - a * w * w - weight * (r * sin - h * versine),
            slope: -weight * rho * sin - two * a * w * (self.l_of_versine * sin - w * cos),
        }
    }

    /// With q = 1 + y², sin φ = 2y/q and 1 − cos φ = 2y²/q, the products P = G sin² φ q³ and I q² are polynomials in
    /// y and l q, and w √(I/G) = l I q⁴/√(I q⁵ P).
    #[inline(always)]
    fn pace(&self, y: T, _: T) -> YawAndTimeRates<T> {
        let [m, r, h, a, _, g] = self.k.as_array::<T>();
        let (two, four) = (T::from(2.0), T::from(4.0));
        let yy = y * y;
        let q = T::from(1.0) + yy;
        let lq = self.l_flat * q + self.l_of_versine * (yy + yy);
        let rho = r * (T::from(1.0) - yy) - two * h * y;
        let inertia = a * (q * q) + m * (rho * rho);
        let fallen = self.energy * q - four * m * g * y * (r - h * y);
        let drive = four * yy * fallen - a * (lq * lq) * q;
        YawAndTimeRates {
            yaw: lq * q * inertia,
            time: four * yy * inertia,
            square: inertia * (q * q * q) * drive,
        }
    }

    #[inline(always)]
    fn terms(&self, at: &Point<T>) -> [T; 2] {
        let [m, r, h, a, _, g] = self.k.as_array::<T>();
        let two = T::from(2.0);
        let weight = two * m * g * (r + h) * at.sin;
        // The two terms of w may nearly cancel, too.
        let parts = (self.l_flat.abs() + (self.l_of_versine * (at.sin * at.sin)).abs()) / at.sin;
        let gyroscopic = two * a * (at.w * parts).abs();
        [self.energy.abs() + weight, gyroscopic]
    }

    #[inline(always)]
    fn guess_lowest(&self) -> T {
        let a: T = self.k.a.into();
        T::from(0.5) * self.l_flat.abs() * (a / self.energy).sqrt()
    }

    #[inline(always)]
    fn guess_highest(&self) -> T {
        let [m, r, h, .., g] = self.k.as_array::<T>();
        half_tangent_at_rise(r, h, self.tilting_energy / (T::from(2.0) * m * g))
    }

    #[inline(always)]
    fn gap_beyond(&self, y: T) -> T {
        gap_beyond(self.k.r.into(), self.k.h.into(), y)
    }

    /// N (A + mρ²) sin φ / m, from the vertical momentum balance N = m (g + ρ φ̈ − z φ̇²).
    #[inline(always)]
    fn scaled_normal_force(&self, at: &Point<T>) -> T {
        let [_, r, h, a, c, g] = self.k.as_array::<T>();
        let (rho, z) = (r * at.cos - h * at.sin, r * at.sin + h * at.cos);
        let falling = a * at.sin * (g - z * at.drive / at.inertia);
        falling + rho * at.w * (a * at.w * at.cos - c * at.sin * at.s)
    }

    #[inline(always)]
    fn scaled_weight(&self, at: &Point<T>) -> T {
        let g: T = self.k.g.into();
        g * at.inertia * at.sin
    }

    /// For any w, the gyroscopic term of `scaled_normal_force` is at least −ρ (C s)² sin φ / (4 A cos φ).
    #[inline(always)]
    fn normal_force_bound(&self, _: &Point<T>, high: &Point<T>) -> T {
        let [_, r, h, a, c, g] = self.k.as_array::<T>();
        let z = (r * r + h * h).sqrt();
        let cs = c * self.s;
        a * g - z * self.energy - r * cs * cs / (T::from(4.0) * a * high.cos)
    }
}
