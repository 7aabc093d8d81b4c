//! The turn of a body that wobbles in place.
//!
//! I ψ̇ is constant (see [`InPlace`]), so that the tilt determines the yaw rate. With y = tan(φ/2),
//!
//! ```text
//! J φ̇² = 2E − 2mg (z − H) − (I ψ̇)²/I        I = sin² φ κ,    κ = A + C y² + m (R y + H)²
//! ```

use super::scalar::quadrature_of;
use super::tilt_equation::Start;
use super::tilt_equation::{
    Conserved, Point, TiltEquation, gap_beyond, half_tangent_at_rise, sin_and_versine,
};
use super::{ExactTurn, end, is_beyond, options, resolved, turn_of_fall};
use crate::body::Body;
use crate::error::InvalidInput;
use crate::law::{FrictionLaw, InPlace, Parameters};
use crate::motion::fall;
use crate::real::Real;
use crate::state::State;
use crate::turn::exact::balance_passage::Balance;

/// The first turn of a body that [wobbles in place](InPlace) under gravity g (m/s²). `topple_tilt` (rad) is that of
/// [`Options`](crate::Options). A spin rate of 0 stands for that which the law demands.
///
/// # Errors
/// Refuses numbers outside their bounds, and a spin rate that is neither 0 nor the opposite of the yaw rate.
pub fn turn_in_place(
    body: &Body,
    start: &State,
    gravity: f64,
    topple_tilt: Option<f64>,
) -> Result<ExactTurn, InvalidInput> {
    let options = options(body, gravity, topple_tilt)?;
    options.check(start)?;
    InPlace::start(start)?;
    let start = State {
        yaw: 0.0,
        spin: 0.0,
        spin_rate: -start.yaw_rate,
        ..*start
    };
    let k = Parameters::new(body, gravity);
    let quadrature = if is_beyond(&start, &options) {
        None
    } else {
        let (start, end) = (Start::of(&start), end(&options));
        let balance = Balance::new(body, gravity, end.0);
        quadrature_of(&InPlaceTilt::new(k, &start), &k, start, end, balance)
    };
    match quadrature {
        Some(quadrature) => Ok(resolved(&quadrature, &k)),
        None => {
            let fall = fall(body, &start, &FrictionLaw::InPlace.into(), &options)?;
            Ok(turn_of_fall(&fall, &start))
        }
    }
}

/// The motion in place from one start.
#[derive(Debug, Clone, Copy)]
struct InPlaceTilt<T> {
    k: Parameters<T>,
    /// K = A + mH² and J = K + mR².
    base_inertia: T,
    rim_inertia: T,
    /// I ψ̇.
    yaw_momentum: T,
    /// 2E relative to the body at rest upright, J.
    energy: T,
    /// `energy` without that of yaw, J.
    tilting_energy: T,
}

impl<T: Real> InPlaceTilt<T> {
    fn new(k: Parameters<T>, start: &Start<T>) -> Self {
        let Start { y, p, w, .. } = *start;
        let (sin, versine) = sin_and_versine(y);
        let base_inertia = k.a + k.m * k.h * k.h;
        let rim_inertia = base_inertia + k.m * k.r * k.r;
        let rise = k.r * sin - k.h * versine;
        let tilting_energy = rim_inertia * p * p + T::from(2.0) * k.m * k.g * rise;
        let [inertia, _] = inertia_of_w(&k, y);
        InPlaceTilt {
            k,
            base_inertia,
            rim_inertia,
            yaw_momentum: sin * inertia * w,
            energy: tilting_energy + inertia * w * w,
            tilting_energy,
        }
    }
}

/// κ and half of dκ/dy, kg m².
fn inertia_of_w<T: Real>(k: &Parameters<T>, y: T) -> [T; 2] {
    let lever = k.r * y + k.h;
    [
        k.a + k.c * y * y + k.m * lever * lever,
        k.c * y + k.m * k.r * lever,
    ]
}

impl<T: Real> TiltEquation<T> for InPlaceTilt<T> {
    fn conserved(&self) -> Conserved<T> {
        let zero = T::from(0.0);
        [self.yaw_momentum, self.energy, self.tilting_energy, zero]
    }

    fn at(&self, y: T, _: T) -> Point<T> {
        let k = &self.k;
        let two = T::from(2.0);
        let (sin, versine) = sin_and_versine(y);
        let cos = T::from(1.0) - versine;
        let [inertia, growth] = inertia_of_w(k, y);
        let w = self.yaw_momentum / (sin * inertia);
        let weight = two * k.m * k.g;
        Point {
            sin,
            cos,
            w,
            s: -(y * w),
            inertia: self.rim_inertia,
            drive: self.energy - inertia * w * w - weight * (k.r * sin - k.h * versine),
            // dI/dη = 2 sin² φ (κ cos φ + y dκ/dy / 2)
            slope: two * w * w * (inertia * cos + y * growth)
                - weight * sin * (k.r * cos - k.h * sin),
        }
    }

    fn terms(&self, at: &Point<T>) -> [T; 2] {
        let k = &self.k;
        let two = T::from(2.0);
        let weight = two * k.m * k.g * (k.r + k.h) * at.sin;
        let [inertia, _] = inertia_of_w(k, at.sin / (T::from(1.0) + at.cos));
        [
            self.tilting_energy.abs() + weight,
            two * inertia * at.w * at.w,
        ]
    }

    fn guess_lowest(&self) -> T {
        T::from(0.5) * self.yaw_momentum.abs() / (self.base_inertia * self.energy).sqrt()
    }

    fn guess_highest(&self) -> T {
        let k = &self.k;
        half_tangent_at_rise(k.r, k.h, self.tilting_energy / (T::from(2.0) * k.m * k.g))
    }

    fn gap_beyond(&self, y: T) -> T {
        gap_beyond(self.k.r, self.k.h, y)
    }

    /// 2 N J sin φ / m, from N = m (g + ρ φ̈ − z φ̇²) and dG/dη = 2 J φ̈ sin φ.
    fn scaled_normal_force(&self, at: &Point<T>) -> T {
        let k = &self.k;
        let (rho, z) = (k.r * at.cos - k.h * at.sin, k.r * at.sin + k.h * at.cos);
        T::from(2.0) * at.sin * (k.g * self.rim_inertia - z * at.drive) + rho * at.slope
    }

    fn scaled_weight(&self, at: &Point<T>) -> T {
        T::from(2.0) * self.k.g * self.rim_inertia * at.sin
    }

    /// I increases with the tilt, so that the yaw only adds to φ̈.
    fn normal_force_bound(&self, _: &Point<T>, _: &Point<T>) -> T {
        let k = &self.k;
        let z = (k.r * k.r + k.h * k.h).sqrt();
        k.g * self.base_inertia - z * self.energy
    }
}
