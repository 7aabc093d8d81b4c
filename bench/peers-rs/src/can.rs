//! The equations of motion of the paper's can, in rimroll's coordinates and as they are printed.

use crate::protocol::{Law, Start};

// Per unit of mass; the sources are those of `rimroll::presets::can_2007`.
const R: f64 = 0.051;
const H: f64 = 0.069;
const A: f64 = 5.13e-3;
const C: f64 = 2.0e-3;
const G: f64 = 9.8;

/// Autonomous equations u′ = f(u).
pub trait Equations<const N: usize>: Copy {
    /// Where the yaw and the tilt rate stand in u.
    const YAW: usize;
    const TILT_RATE: usize;
    fn of(law: Law) -> Self;
    fn begin(start: &Start) -> [f64; N];
    fn rates(&self, u: &[f64; N]) -> [f64; N];
}

/// (ψ, sin φ, cos φ, φ̇, ψ̇ sin φ, s, t) over τ, dt = sin φ dτ.
#[derive(Clone, Copy)]
pub struct Regular(Law);

impl Equations<7> for Regular {
    const YAW: usize = 0;
    const TILT_RATE: usize = 3;

    fn of(law: Law) -> Self {
        Regular(law)
    }

    fn begin(start: &Start) -> [f64; 7] {
        let (sin, cos) = start.tilt.sin_cos();
        let s = start.spin_rate + start.yaw_rate * cos;
        [0.0, sin, cos, start.tilt_rate, start.yaw_rate * sin, s, 0.0]
    }

    #[inline(always)]
    fn rates(&self, u: &[f64; 7]) -> [f64; 7] {
        let [_, sin, cos, p, w, s, _] = *u;
        let [dp, dw, ds] = match self.0 {
            Law::NoSlip => regular_no_slip(sin, cos, p, w, s),
            Law::Frictionless => regular_frictionless(sin, cos, p, w, s),
        };
        [w, sin * cos * p, -sin * sin * p, dp, dw, ds, sin]
    }
}

#[inline(always)]
fn regular_no_slip(sin: f64, cos: f64, p: f64, w: f64, s: f64) -> [f64; 3] {
    const K: f64 = A + H * H;
    const J: f64 = K + R * R;
    const DETERMINANT: f64 = C * K + R * R * A;
    const L_OF_S: f64 = C * (C + R * R) / DETERMINANT;
    const L_OF_W: f64 = C * H * R / DETERMINANT;
    const S_OF_W: f64 = R * R * A / DETERMINANT;
    let collision = cos * w * (K / J * w - H * R / J * s);
    let elsewhere = w * (H * R / J * w - (C + R * R) / J * s) - G * R / J * cos + G * H / J * sin;
    [
        collision + sin * elsewhere,
        p * (sin * (L_OF_S * s - L_OF_W * w) - w * cos),
        sin * p * (S_OF_W * w + L_OF_W * s),
    ]
}

#[inline(always)]
fn regular_frictionless(sin: f64, cos: f64, p: f64, w: f64, s: f64) -> [f64; 3] {
    let rho = R * cos - H * sin;
    let z = R * sin + H * cos;
    let elsewhere = rho * (z * p * p - G) - C * w * s;
    [
        (A * w * w * cos + sin * elsewhere) / (A + rho * rho),
        p * (sin * (C / A) * s - w * cos),
        0.0,
    ]
}

/// (ψ, φ, θ, ψ̇, φ̇, θ̇) over t: the printed Q q̈ = S, solved by Cramer's rule.
#[derive(Clone, Copy)]
pub struct Printed(Law);

impl Equations<6> for Printed {
    const YAW: usize = 0;
    const TILT_RATE: usize = 4;

    fn of(law: Law) -> Self {
        Printed(law)
    }

    fn begin(start: &Start) -> [f64; 6] {
        let Start {
            tilt,
            tilt_rate,
            yaw_rate,
            spin_rate,
        } = *start;
        [0.0, tilt, 0.0, yaw_rate, tilt_rate, spin_rate]
    }

    #[inline(always)]
    fn rates(&self, u: &[f64; 6]) -> [f64; 6] {
        let [_, phi, _, psi_dot, phi_dot, theta_dot] = *u;
        let (sin, cos) = phi.sin_cos();
        let [psi_ddot, phi_ddot, theta_ddot] = match self.0 {
            Law::NoSlip => printed_no_slip(sin, cos, psi_dot, phi_dot, theta_dot),
            Law::Frictionless => printed_frictionless(sin, cos, psi_dot, phi_dot, theta_dot),
        };
        [psi_dot, phi_dot, theta_dot, psi_ddot, phi_ddot, theta_ddot]
    }
}

/// Eq. (noslip_eqs).
#[inline(always)]
fn printed_no_slip(sin: f64, cos: f64, psi_dot: f64, phi_dot: f64, theta_dot: f64) -> [f64; 3] {
    let q11 = (A + H * H) * sin - H * R * cos;
    let q13 = -H * R;
    let q31 = (C + R * R) * cos - R * H * sin;
    let q33 = C + R * R;
    let s1 = (C - 2.0 * A - 2.0 * H * H) * psi_dot * phi_dot * cos + C * phi_dot * theta_dot
        - 2.0 * H * R * psi_dot * phi_dot * sin;
    let s2 = (C - A + R * R - H * H) * psi_dot * psi_dot * sin * cos
        + (C + R * R) * theta_dot * psi_dot * sin
        + H * R * psi_dot * theta_dot * cos
        + H * R * psi_dot * psi_dot * (cos * cos - sin * sin)
        + G * (R * cos - H * sin);
    let s3 = C * psi_dot * phi_dot * sin + 2.0 * R * psi_dot * phi_dot * (R * sin + H * cos);
    let determinant = q11 * q33 - q13 * q31;
    [
        (s1 * q33 - q13 * s3) / determinant,
        -s2 / (R * R + H * H + A),
        (q11 * s3 - s1 * q31) / determinant,
    ]
}

/// Eq. (nofric_eqs).
#[inline(always)]
fn printed_frictionless(
    sin: f64,
    cos: f64,
    psi_dot: f64,
    phi_dot: f64,
    theta_dot: f64,
) -> [f64; 3] {
    let q22 = -A + 2.0 * H * R * sin * cos - H * H * sin * sin - R * R * cos * cos;
    let s1 =
        -2.0 * A * psi_dot * phi_dot * cos + C * phi_dot * theta_dot + C * phi_dot * psi_dot * cos;
    let s2 = (C - A) * psi_dot * psi_dot * sin * cos + C * theta_dot * psi_dot * sin + G * R * cos
        - G * H * sin
        - H * R * phi_dot * phi_dot * (cos * cos - sin * sin)
        + (H * H - R * R) * phi_dot * phi_dot * sin * cos;
    let psi_ddot = s1 / (A * sin);
    [psi_ddot, s2 / q22, psi_dot * phi_dot * sin - psi_ddot * cos]
}

/// The same motion with the tilt rate as clock, on which its zero is found by ordinary steps
/// (Hénon, Physica D 5 (1982) 412).
#[inline(always)]
pub fn by_tilt_rate<const N: usize, E: Equations<N>>(equations: &E, u: &[f64; N]) -> [f64; N] {
    let rates = equations.rates(u);
    let scale = 1.0 / rates[E::TILT_RATE];
    rates.map(|rate| rate * scale)
}
