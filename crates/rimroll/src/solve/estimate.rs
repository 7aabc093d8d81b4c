//! How far a step may be off, and how long the next one can be.

use crate::real::{FloatBits, Real};

/// The estimated error of a step: the step is good when `error_squared` ≤ `allowed`.
#[derive(Debug, Clone, Copy)]
pub struct Estimate<T> {
    /// The square of the error over what the tolerance allows, times `allowed`.
    pub error_squared: T,
    /// What that is to be compared with.
    pub allowed: T,
}

impl<T: Real> Estimate<T> {
    /// Of a step of length h with `count` components: from the sums of the squares of its estimates of
    /// orders 5 and 3, each over what the tolerance allows that component and over h (Hairer, Nørsett &
    /// Wanner 1993, section II.10).
    #[inline(always)]
    pub fn new(h: T, fifth: T, third: T, count: usize) -> Self {
        // Where nothing is wrong, not 0/0.
        const NEVER_ZERO: f64 = 1e-300;
        let both = (fifth + T::from(0.01) * third) * T::from(count as f64);
        let error = h * fifth;
        Estimate {
            error_squared: error * error,
            allowed: both.max(T::from(NEVER_ZERO)),
        }
    }
}

impl Estimate<f64> {
    /// Whether it says anything.
    #[inline]
    pub fn is_number(&self) -> bool {
        // Written so that a NaN is none.
        self.error_squared < f64::INFINITY
    }

    /// Whether the step is.
    #[inline]
    pub fn is_good(&self) -> bool {
        self.is_number() && self.error_squared <= self.allowed
    }
}

impl<T: FloatBits> Estimate<T> {
    /// By what factor the next step may be longer than one with this error e (over what is tolerated), to
    /// be good but for a margin: 0.9 e^(−1/8) (section II.4).
    ///
    /// A step waits for it, and a rough one will do: it comes out up to 6 % too long, and the margin is wider
    /// by what is usual of that.
    #[inline(always)]
    pub fn next_factor(&self) -> T {
        const MARGIN: f64 = 0.86;
        T::from(MARGIN) * T::approx_16th_root_of(self.allowed, self.error_squared)
    }
}
