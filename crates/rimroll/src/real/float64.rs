//! `f64` as a number type.

use super::{Real, Scalar, elementary};

impl Scalar for f64 {
    #[inline(always)]
    fn value(self) -> f64 {
        self
    }

    #[inline]
    fn atan2(self, x: Self) -> Self {
        libm::atan2(self, x)
    }

    #[inline]
    fn hypot(self, y: Self) -> Self {
        libm::hypot(self, y)
    }
}

impl Real for f64 {
    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        libm::sincos(self)
    }

    #[inline]
    fn sqrt(self) -> Self {
        f64::sqrt(self)
    }

    #[inline]
    fn exp(self) -> Self {
        libm::exp(self)
    }

    #[inline(always)]
    fn exp_m1(self) -> Self {
        elementary::exp_m1(self)
    }

    #[inline(always)]
    fn ln(self) -> Self {
        elementary::ln(self)
    }

    #[inline(always)]
    fn approx_ln(self) -> Self {
        elementary::approx_ln(self)
    }

    #[inline(always)]
    fn atan(self) -> Self {
        elementary::atan(self)
    }

    #[inline]
    fn abs(self) -> Self {
        f64::abs(self)
    }

    #[inline]
    fn max(self, other: Self) -> Self {
        if self > other { self } else { other }
    }

    #[inline]
    fn min(self, other: Self) -> Self {
        if self < other { self } else { other }
    }

    #[inline]
    fn where_negative(self, yes: Self, no: Self) -> Self {
        if self < 0.0 { yes } else { no }
    }

    #[inline]
    fn odd_power(self, n: f64) -> Self {
        libm::pow(self.abs(), n).copysign(self)
    }
}
