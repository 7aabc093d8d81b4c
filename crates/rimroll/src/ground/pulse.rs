//! Pulses of the table in closed form.

use crate::error::{InvalidInput, positive, within};
use crate::real::Real;
use core::f64::consts::{PI, TAU};

/// The largest acceleration that a ground may have, m/s².
pub(super) const MAX_ACCELERATION: f64 = 1e9;

/// A pulse that begins at t = 0: an amplitude times a function of time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pulse {
    /// The amplitude along x, y and z, m/s².
    pub amplitude: [f64; 3],
    /// The function of time.
    pub shape: Shape,
    /// The time at which the pulse ends, s.
    pub duration: f64,
}

/// A function of time with the largest value 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Shape {
    /// 1.
    Constant,
    /// sin(2πt/T).
    Sine {
        /// T, s.
        period: f64,
    },
    /// cos(2πt/T).
    Cosine {
        /// T, s.
        period: f64,
    },
    /// The symmetric Ricker wavelet (1 − 2x²) exp(−x²) with x = π (t − t₀)/T.
    Ricker {
        /// T, s.
        period: f64,
        /// t₀, s.
        center: f64,
    },
}

impl Pulse {
    /// Checks the numbers.
    pub(super) fn check(&self) -> Result<(), InvalidInput> {
        for amplitude in self.amplitude {
            let bound = "between -1e9 and 1e9";
            within("amplitude", amplitude, MAX_ACCELERATION, bound, "m/s2")?;
        }
        positive("duration", self.duration, "s")?;
        match self.shape {
            Shape::Constant => {}
            Shape::Sine { period } | Shape::Cosine { period } => {
                positive("period", period, "s")?;
            }
            Shape::Ricker { period, center } => {
                positive("period", period, "s")?;
                within("center", center, 1e9, "between -1e9 and 1e9", "s")?;
            }
        }
        Ok(())
    }
}

impl Pulse {
    /// The first and the second integral of the shape from 0 to a time t >= 0 (s), in s and s²: the velocity and the
    /// displacement for an amplitude of 1. After the end of the pulse the first is constant.
    pub(super) fn integrals(&self, t: f64) -> [f64; 2] {
        let acting = t.min(self.duration);
        let [velocity, moved] = self.shape.integrals(acting);
        [velocity, moved + velocity * (t - acting)]
    }
}

impl Shape {
    /// The first and the second integral from 0 to a time (s), in s and s².
    fn integrals(&self, t: f64) -> [f64; 2] {
        match *self {
            Shape::Constant => [t, 0.5 * t * t],
            Shape::Sine { period } => {
                let rate = TAU / period;
                let sin = libm::sin(rate * t);
                [one_less_cos(rate * t) / rate, (t - sin / rate) / rate]
            }
            Shape::Cosine { period } => {
                let rate = TAU / period;
                let rise = one_less_cos(rate * t);
                [libm::sin(rate * t) / rate, rise / (rate * rate)]
            }
            // The integral of (1 − 2x²) exp(−x²) is x exp(−x²), that of x exp(−x²) is −exp(−x²)/2.
            Shape::Ricker { period, center } => {
                let rate = PI / period;
                let [from, x] = [-rate * center, rate * (t - center)];
                let [before, after] = [from, x].map(|x| libm::exp(-x * x));
                [
                    (x * after - from * before) / rate,
                    0.5 * (before - after) / (rate * rate) - from * before * t / rate,
                ]
            }
        }
    }

    /// The period, s; infinite for a constant.
    pub(super) fn period(&self) -> f64 {
        match *self {
            Shape::Constant => f64::INFINITY,
            Shape::Sine { period } | Shape::Cosine { period } | Shape::Ricker { period, .. } => {
                period
            }
        }
    }

    /// The value at a time, s.
    #[inline(always)]
    pub(super) fn at<T: Real>(&self, t: T) -> T {
        match *self {
            Shape::Constant => T::from(1.0),
            Shape::Sine { period } => (T::from(TAU / period) * t).sin_cos().0,
            Shape::Cosine { period } => (T::from(TAU / period) * t).sin_cos().1,
            Shape::Ricker { period, center } => {
                let x = T::from(PI / period) * (t - T::from(center));
                let square = x * x;
                (T::from(1.0) - T::from(2.0) * square) * (-square).exp()
            }
        }
    }
}

/// 1 − cos α without cancellation.
fn one_less_cos(angle: f64) -> f64 {
    let half = libm::sin(0.5 * angle);
    2.0 * half * half
}
