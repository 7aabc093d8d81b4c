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

impl Shape {
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
