//! The tilt of a body that rolls without slip.
//!
//! l = ψ̇ sin² φ and s = θ̇ + ψ̇ cos φ obey linear equations with the tilt as independent variable.
//! [`Fundamental`] holds their solutions for the body. The tilt obeys
//!
//! ```text
//! J φ̇² = 2E − 2mg (z − H) − K w² + 2mHR s w − (C + mR²) s²      w = l / sin φ
//! ```

use super::fundamental_solutions::Fundamental;
use super::tilt_equation::Start;
use super::tilt_equation::{
    Conserved, Point, TiltEquation, YawAndTimeRates, gap_beyond, half_tangent_at_rise,
    sin_and_versine,
};
use crate::real::Real;

/// The motion of a rolling body from one start. C is the number type of the body's constants, T that of the start.
#[derive(Debug, Clone, Copy)]
pub(super) struct NoSlipTilt<'a, C, T> {
    body: &'a Fundamental<C>,
    /// Coefficient of the solution that is regular at φ = 0, where (l, s) = (0, 1).
    regular: T,
    /// Coefficient of the solution that tends to (l, s) = (1, κ ln y) there, which is l at φ = 0.
    singular: T,
    /// 2E relative to the body at rest upright, J.
    energy: T,
    /// `energy` without that of yaw and spin, J.
    tilting_energy: T,
}

impl<'a, C: Copy + Into<T>, T: Real> NoSlipTilt<'a, C, T> {
    #[inline(always)]
    pub(super) fn new(body: &'a Fundamental<C>, start: &Start<T>) -> Self {
        let Start { y, eta, w, s, .. } = *start;
        let (sin, _) = sin_and_versine(y);
        let l = w * sin;
        let [l_regular, s_regular, l_singular, s_singular] = body.solutions(y, eta);
        let tilting_energy = Self::tilting_energy(body, start);
        let mut tilt = NoSlipTilt {
            body,
            // The Wronskian determinant is −1 at every tilt.
            regular: s * l_singular - l * s_singular,
            singular: l * s_regular - s * l_regular,
            energy: tilting_energy,
            tilting_energy,
        };
        tilt.energy = tilting_energy + tilt.yaw_and_spin_energy(w, s);
        tilt
    }

    /// Twice the energy relative to the body at rest upright, without that of yaw and spin, J.
    #[inline(always)]
    pub(super) fn tilting_energy(body: &Fundamental<C>, start: &Start<T>) -> T {
        let [m, r, h, _, _, g] = body.parameters.as_array::<T>();
        let (sin, versine) = sin_and_versine(start.y);
        let rim_inertia: T = body.rim_inertia.into();
        rim_inertia * start.p * start.p + T::from(2.0) * m * g * (r * sin - h * versine)
    }

    /// The motion with the quantities of [`TiltEquation::conserved`].
    #[inline(always)]
    pub(super) fn from_conserved(body: &'a Fundamental<C>, conserved: Conserved<T>) -> Self {
        let [regular, singular, energy, tilting_energy] = conserved;
        NoSlipTilt {
            body,
            regular,
            singular,
            energy,
            tilting_energy,
        }
    }

    /// Twice the kinetic energy of yaw and spin, J.
    #[inline(always)]
    fn yaw_and_spin_energy(&self, w: T, s: T) -> T {
        let (k, mhr): (T, T) = (self.body.base_inertia.into(), self.body.mhr.into());
        let axial: T = self.body.axial_inertia.into();
        w * (k * w - T::from(2.0) * mhr * s) + axial * s * s
    }
}

impl<C: Copy + Into<T>, T: Real> TiltEquation<T> for NoSlipTilt<'_, C, T> {
    #[inline(always)]
    fn conserved(&self) -> Conserved<T> {
        [
            self.regular,
            self.singular,
            self.energy,
            self.tilting_energy,
        ]
    }

    #[inline(always)]
    fn at(&self, y: T, eta: T) -> Point<T> {
        let [m, r, h, _, _, g] = self.body.parameters.as_array::<T>();
        let (k, mhr): (T, T) = (self.body.base_inertia.into(), self.body.mhr.into());
        let axial: T = self.body.axial_inertia.into();
        let [l_of_s, l_of_l, s_of_l] = self.body.rates;
        let (l_of_s, l_of_l, s_of_l): (T, T, T) = (l_of_s.into(), l_of_l.into(), s_of_l.into());
        let two = T::from(2.0);
        let (sin, versine) = sin_and_versine(y);
        let cos = T::from(1.0) - versine;
        let [l_regular, s_regular, l_singular, s_singular] = self.body.solutions(y, eta);
        let s = self.regular * s_regular + self.singular * s_singular;
        let w = (self.regular * l_regular + self.singular * l_singular) / sin;
        let dw = sin * (l_of_s * s - l_of_l * w) - w * cos;
        let ds = sin * (s_of_l * w + l_of_l * s);
        let weight = two * m * g;
        let gyroscopic = (k * w - mhr * s) * dw + (axial * s - mhr * w) * ds;
        Point {
            sin,
            cos,
            w,
            s,
            inertia: self.body.rim_inertia.into(),
            drive: self.energy - self.yaw_and_spin_energy(w, s) - weight * (r * sin - h * versine),
            slope: -weight * sin * (r * cos - h * sin) - two * gyroscopic,
        }
    }

    /// With c = 1 + y², sin φ = 2y/c and 1 − cos φ = 2y²/c, the product P = G sin² φ c³ is a polynomial in y, l
    /// and s, and w √(I/G) = l J c²/√(J c P).
    #[inline(always)]
    fn pace(&self, y: T, eta: T) -> YawAndTimeRates<T> {
        let [m, r, h, _, _, g] = self.body.parameters.as_array::<T>();
        let (k, mhr): (T, T) = (self.body.base_inertia.into(), self.body.mhr.into());
        let axial: T = self.body.axial_inertia.into();
        let inertia: T = self.body.rim_inertia.into();
        let four = T::from(4.0);
        let [l_regular, s_regular, l_singular, s_singular] = self.body.solutions(y, eta);
        let s = self.regular * s_regular + self.singular * s_singular;
        let l = self.regular * l_regular + self.singular * l_singular;
        let yy = y * y;
        let c = T::from(1.0) + yy;
        let lc = l * c;
        let fallen = (self.energy - axial * s * s) * c - four * m * g * y * (r - h * y);
        let lcc = lc * c;
        let drive = four * yy * fallen - lcc * (k * lc - four * mhr * y * s);
        YawAndTimeRates {
            yaw: lcc * inertia,
            time: four * yy * inertia,
            square: inertia * c * drive,
        }
    }

    #[inline(always)]
    fn terms(&self, at: &Point<T>) -> [T; 2] {
        let [m, r, h, _, _, g] = self.body.parameters.as_array::<T>();
        let (k, mhr): (T, T) = (self.body.base_inertia.into(), self.body.mhr.into());
        let axial: T = self.body.axial_inertia.into();
        let two = T::from(2.0);
        let weight = two * m * g * (r + h) * at.sin;
        // s is a sum of two solutions that may nearly cancel, and w depends on it.
        let s = at.s.abs().max(self.regular.abs());
        let gyroscopic = k * at.w * at.w + two * mhr * (s * at.w).abs() + axial * s * s;
        [self.tilting_energy.abs() + weight, gyroscopic + gyroscopic]
    }

    /// The near-collision without gravity, K w² − 2mHR s w + (C + mR²) s² = 2E, with the logarithmic change of s
    /// included by fixed-point iteration.
    #[inline(always)]
    fn guess_lowest(&self) -> T {
        let (k, mhr): (T, T) = (self.body.base_inertia.into(), self.body.mhr.into());
        let (axial, s_of_l): (T, T) = (self.body.axial_inertia.into(), self.body.rates[2].into());
        let mut s = self.regular;
        let mut y = T::from(0.0);
        for _ in 0..2 {
            let pull = self.singular.where_negative(-mhr * s, mhr * s);
            // Where the previous guess was not a tilt, any finite value serves.
            let fall = (self.energy - axial * s * s).max(T::from(0.0));
            let root = (pull * pull + k * fall).sqrt();
            y = T::from(0.5) * self.singular.abs() * k / (pull + root);
            s = self.regular + self.singular * s_of_l * y.ln();
        }
        y
    }

    #[inline(always)]
    fn guess_highest(&self) -> T {
        let [m, r, h, .., g] = self.body.parameters.as_array::<T>();
        half_tangent_at_rise(r, h, self.tilting_energy / (T::from(2.0) * m * g))
    }

    #[inline(always)]
    fn gap_beyond(&self, y: T) -> T {
        let k = &self.body.parameters;
        gap_beyond(k.r.into(), k.h.into(), y)
    }

    /// 2 N J sin φ / m, from the vertical momentum balance N = m (g + ρ φ̈ − z φ̇²) and dG/dη = 2 J φ̈ sin φ.
    #[inline(always)]
    fn scaled_normal_force(&self, at: &Point<T>) -> T {
        let [_, r, h, .., g] = self.body.parameters.as_array::<T>();
        let rim_inertia: T = self.body.rim_inertia.into();
        let (rho, z) = (r * at.cos - h * at.sin, r * at.sin + h * at.cos);
        T::from(2.0) * at.sin * (g * rim_inertia - z * at.drive) + rho * at.slope
    }

    #[inline(always)]
    fn scaled_weight(&self, at: &Point<T>) -> T {
        let g: T = self.body.parameters.g.into();
        T::from(2.0) * g * at.inertia * at.sin
    }

    /// With f = K cos φ / sin φ + mHR and e = mHR cos φ / sin φ + C + mR², yaw and spin contribute to J φ̈
    /// f w² − e s w ≥ −e² s² / 4f ≥ −s² ((mHR)² / (2K sin φ) + (C + mR²)² sin φ / (2K cos φ)).
    #[inline(always)]
    fn normal_force_bound(&self, low: &Point<T>, high: &Point<T>) -> T {
        let [_, r, h, .., g] = self.body.parameters.as_array::<T>();
        let (k, mhr): (T, T) = (self.body.base_inertia.into(), self.body.mhr.into());
        let axial: T = self.body.axial_inertia.into();
        // Between the two tilts |s| may be slightly larger than at both. Omitting the factor 1/2 allows for this.
        let s = low.s.abs().max(high.s.abs()).max(self.regular.abs());
        let pull = mhr * mhr / low.sin + axial * axial * high.sin / high.cos;
        let z = (r * r + h * h).sqrt();
        k * g - z * self.energy - r * s * s * pull / k
    }
}
