//! The reduction to one degree of freedom, the tilt, that the two ideal laws share.
//!
//! Under both laws the tilt determines the other velocities, so conservation of energy gives the tilt rate
//! at each tilt: I φ̇² = G(φ). The independent variable is η = ln y with y = tan(φ/2), dφ = sin φ dη. In η
//! the near-collision is not shorter than the rest of the motion, for any smallest tilt.

use crate::real::{Real, fieldwise, sin_cos_below_eighth};
use crate::state::State;

/// Relative rounding error bound of the terms of G.
pub(super) const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// If sin φ is smaller than this, the base counts as flat on the table, as in a simulated motion.
pub(super) const FLAT: f64 = crate::ending::FACE_DOWN_TILT;

/// Distance in η from a turning point below which rounding errors dominate G.
pub(super) const SHORT: f64 = 3e-6;

/// The motion at one tilt.
#[derive(Debug, Clone, Copy)]
pub(super) struct Point<T> {
    /// sin φ.
    pub(super) sin: T,
    /// cos φ.
    pub(super) cos: T,
    /// w = ψ̇ sin φ, rad/s.
    pub(super) w: T,
    /// s = θ̇ + ψ̇ cos φ, rad/s.
    pub(super) s: T,
    /// I, kg m²: J = A + mH² + mR² without slip, A + mρ² without friction.
    pub(super) inertia: T,
    /// G = I φ̇², J.
    pub(super) drive: T,
    /// dG/dη, J.
    pub(super) slope: T,
}

/// The rates of yaw and time with respect to η: dψ/dη = `yaw`/√`square`, dt/dη = `time`/√`square`.
#[derive(Debug, Clone, Copy)]
pub(super) struct YawAndTimeRates<T> {
    pub(super) yaw: T,
    pub(super) time: T,
    /// Has the sign of G.
    pub(super) square: T,
}

impl<T: Real> YawAndTimeRates<T> {
    /// dψ = w √(I/G) dη, dt = sin φ √(I/G) dη.
    #[inline(always)]
    pub(super) fn of(point: &Point<T>) -> Self {
        YawAndTimeRates {
            yaw: point.w * point.inertia,
            time: point.sin * point.inertia,
            square: point.inertia * point.drive,
        }
    }
}

/// Conserved quantities, which determine a motion of a given body.
pub(super) type Conserved<T> = [T; 4];

/// A motion under one of the laws, from a start.
pub(super) trait TiltEquation<T: Real> {
    /// The conserved quantities.
    fn conserved(&self) -> Conserved<T>;

    /// The motion at tan(φ/2) = y with the logarithm η.
    fn at(&self, y: T, eta: T) -> Point<T>;

    /// The rates of yaw and time at y, which a law may compute without divisions.
    #[inline(always)]
    fn pace(&self, y: T, eta: T) -> YawAndTimeRates<T> {
        YawAndTimeRates::of(&self.at(y, eta))
    }

    /// The magnitudes of the terms of G at a point: those of energy and gravity, and those of yaw and spin, J.
    fn terms(&self, point: &Point<T>) -> [T; 2];

    /// A bound of the rounding error of G at a point, J.
    #[inline(always)]
    fn rounding(&self, point: &Point<T>, _eta: T) -> T {
        let [weight, gyroscopic] = self.terms(point);
        T::from(ROUNDING) * (weight + gyroscopic)
    }

    /// A guess of the smallest tilt, tan(φ/2).
    fn guess_lowest(&self) -> T;

    /// A guess of the largest tilt, tan(φ/2), without the energy of yaw and spin. NaN if the energy suffices to
    /// pass the balance point.
    fn guess_highest(&self) -> T;

    /// Estimated distance in η from a largest tilt at y to the next root of G above it.
    fn gap_beyond(&self, y: T) -> T;

    /// A finite quantity with the sign of the normal force N.
    fn scaled_normal_force(&self, point: &Point<T>) -> T;

    /// The scale of [`Self::scaled_normal_force`]: its approximate value under static weight.
    fn scaled_weight(&self, point: &Point<T>) -> T;

    /// A lower bound that is positive only if the normal force is positive everywhere between two tilts, the second
    /// of which is below the balance point. It can be negative even if the normal force is positive.
    fn normal_force_bound(&self, low: &Point<T>, high: &Point<T>) -> T;
}

/// sin φ and 1 − cos φ.
#[inline(always)]
pub(super) fn sin_and_versine<T: Real>(y: T) -> (T, T) {
    let sin = T::from(2.0) * y / (T::from(1.0) + y * y);
    (sin, sin * y)
}

/// Estimated distance in η from a largest tilt at y = tan(φ/2) to the next root of G above it, without the energy of
/// yaw and spin. R sin φ + H cos φ has equal values at both.
#[inline(always)]
pub(super) fn gap_beyond<T: Real>(radius: T, height: T, y: T) -> T {
    let (sin, versine) = sin_and_versine(y);
    let two = T::from(2.0);
    let rise = radius * sin - height * versine;
    let next = rise / (rise + two * height) / y;
    // This is slightly less than ln(next/y). A largest tilt past the balance point is due to yaw or spin, and the
    // next root is unknown. It is taken to be far; the error estimate of the rule detects if it is not.
    let gap = two * (next - y) / (next + y);
    gap.where_negative(two, gap)
}

/// tan(φ/2) at a tilt φ (rad).
pub(super) fn half_tangent(tilt: f64) -> f64 {
    let (sin, cos) = libm::sincos(tilt);
    sin / (1.0 + cos)
}

/// tan(φ/2) at which the centre of mass is `rise` higher than upright: R sin φ + H cos φ = H + rise.
#[inline(always)]
pub(super) fn half_tangent_at_rise<T: Real>(radius: T, height: T, rise: T) -> T {
    let two = T::from(2.0);
    rise / (radius + (radius * radius - rise * (rise + two * height)).sqrt())
}

/// A start of a motion.
#[derive(Debug, Clone, Copy)]
pub(super) struct Start<T> {
    /// tan(φ/2).
    pub(super) y: T,
    /// Its logarithm.
    pub(super) eta: T,
    /// φ̇, rad/s.
    pub(super) p: T,
    /// w = ψ̇ sin φ, rad/s.
    pub(super) w: T,
    /// s = θ̇ + ψ̇ cos φ, rad/s.
    pub(super) s: T,
}

impl<T: Real> Start<T> {
    /// Converts [tilt, tilt rate, yaw rate, spin rate], in rad and rad/s, for tilts below π/2.
    #[inline(always)]
    pub(super) fn new([tilt, tilt_rate, yaw_rate, spin_rate]: [T; 4]) -> Self {
        let half = T::from(0.5);
        let (sin, cos) = sin_cos_below_eighth(half * tilt);
        let y = sin / cos;
        let w = yaw_rate * (sin * cos + sin * cos);
        Start {
            y,
            eta: y.ln(),
            p: tilt_rate,
            w,
            // This form is accurate if the two rates are large and nearly cancel, as in a near-collision.
            s: (spin_rate + yaw_rate) - w * y,
        }
    }
}

fieldwise!(Start { y, eta, p, w, s; });

impl Start<f64> {
    pub(super) fn of(start: &State) -> Self {
        Start::new([start.tilt, start.tilt_rate, start.yaw_rate, start.spin_rate])
    }
}

#[cfg(test)]
mod tests {
    use super::{TiltEquation, YawAndTimeRates};
    use crate::law::Parameters;
    use crate::presets;
    use crate::state::State;
    use crate::turn::exact::frictionless::FrictionlessTilt;
    use crate::turn::exact::fundamental_solutions::Fundamental;
    use crate::turn::exact::no_slip::NoSlipTilt;
    use crate::turn::exact::tilt_equation::Start;

    /// The largest relative difference of dψ/dη and dt/dη from w √(I/G) and sin φ √(I/G), and the number of tilts
    /// compared.
    fn off(motion: &impl TiltEquation<f64>) -> (f64, usize) {
        let rates = |pace: YawAndTimeRates<f64>| {
            [pace.yaw, pace.time].map(|part| part / pace.square.sqrt())
        };
        let etas = (-60..0).map(|i| 0.1 * f64::from(i));
        let moving = etas.filter(|&eta| motion.at(libm::exp(eta), eta).drive > 0.0);
        moving.fold((0.0, 0), |(most, count), eta| {
            let y = libm::exp(eta);
            let (quick, plain) = (
                rates(motion.pace(y, eta)),
                rates(YawAndTimeRates::of(&motion.at(y, eta))),
            );
            let off = (0..2).map(|i| (quick[i] / plain[i] - 1.0).abs());
            (off.fold(most, f64::max), count + 1)
        })
    }

    #[test]
    fn the_pace_without_divisions_agrees_with_the_definition() {
        let k = Parameters::new(&presets::can_2007().unwrap(), 9.8);
        let start = Start::of(&State {
            tilt: 0.5,
            tilt_rate: -2.0,
            yaw_rate: 0.7,
            spin_rate: -0.4,
            ..State::default()
        });
        let table = Fundamental::new(k, 1.0);
        // Near the smallest tilt G is a small difference; here it is at least 1 % of its terms.
        for (off, count) in [
            off(&NoSlipTilt::new(&table, &start)),
            off(&FrictionlessTilt::new(k, &start)),
        ] {
            assert!(count > 20, "{count}");
            assert!(off < 1e-13, "{off:e}");
        }
    }
}
