//! Dual numbers a + b ε with ε² = 0. A formula evaluated on them gives its exact derivative as b.

use super::{Real, Scalar};
use core::ops::{Add, Div, Mul, Neg, Sub};

/// A value and its derivative along one direction or, with [`Slopes`], along several.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dual<S = f64> {
    /// The value.
    pub value: f64,
    /// The derivative.
    pub slope: S,
}

/// The type of a derivative: an element of a vector space.
pub trait Slope: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<f64, Output = Self> {
    /// The derivative of a constant.
    const ZERO: Self;
}

impl Slope for f64 {
    const ZERO: f64 = 0.0;
}

/// Derivatives along K directions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Slopes<const K: usize>(pub [f64; K]);

impl<const K: usize> Slope for Slopes<K> {
    const ZERO: Self = Slopes([0.0; K]);
}

impl<const K: usize> Add for Slopes<K> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let mut result = self;
        for i in 0..K {
            result.0[i] += other.0[i];
        }
        result
    }
}

impl<const K: usize> Sub for Slopes<K> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        let mut result = self;
        for i in 0..K {
            result.0[i] -= other.0[i];
        }
        result
    }
}

impl<const K: usize> Mul<f64> for Slopes<K> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, factor: f64) -> Self {
        let mut result = self;
        for i in 0..K {
            result.0[i] *= factor;
        }
        result
    }
}

impl<S: Slope> From<f64> for Dual<S> {
    #[inline(always)]
    fn from(value: f64) -> Self {
        Dual {
            value,
            slope: S::ZERO,
        }
    }
}

impl<S: Slope> Add for Dual<S> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Dual {
            value: self.value + other.value,
            slope: self.slope + other.slope,
        }
    }
}

impl<S: Slope> Sub for Dual<S> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Dual {
            value: self.value - other.value,
            slope: self.slope - other.slope,
        }
    }
}

impl<S: Slope> Mul for Dual<S> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Dual {
            value: self.value * other.value,
            slope: self.slope * other.value + other.slope * self.value,
        }
    }
}

impl<S: Slope> Div for Dual<S> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        Dual {
            value,
            slope: (self.slope - other.slope * value) * (1.0 / other.value),
        }
    }
}

impl<S: Slope> Neg for Dual<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Dual {
            value: -self.value,
            slope: self.slope * -1.0,
        }
    }
}

impl<S: Slope> Real for Dual<S> {
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = libm::sincos(self.value);
        (self.chain(sin, cos), self.chain(cos, -sin))
    }

    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.chain(root, 0.5 / root)
    }

    fn exp(self) -> Self {
        let power = libm::exp(self.value);
        self.chain(power, power)
    }

    fn exp_m1(self) -> Self {
        let value = Real::exp_m1(self.value);
        self.chain(value, value + 1.0)
    }

    fn ln(self) -> Self {
        self.chain(Real::ln(self.value), 1.0 / self.value)
    }

    fn approx_ln(self) -> Self {
        self.ln()
    }

    fn atan(self) -> Self {
        let slope = 1.0 / (1.0 + self.value * self.value);
        self.chain(Real::atan(self.value), slope)
    }

    fn abs(self) -> Self {
        self.where_negative(-self, self)
    }

    fn max(self, other: Self) -> Self {
        if self.value > other.value {
            self
        } else {
            other
        }
    }

    fn min(self, other: Self) -> Self {
        if self.value < other.value {
            self
        } else {
            other
        }
    }

    fn where_negative(self, yes: Self, no: Self) -> Self {
        if self.value < 0.0 { yes } else { no }
    }

    fn odd_power(self, n: f64) -> Self {
        let slope = n * libm::pow(self.value.abs(), n - 1.0);
        self.chain(self.value.odd_power(n), slope)
    }
}

impl<S: Slope> Scalar for Dual<S> {
    #[inline(always)]
    fn value(self) -> f64 {
        self.value
    }

    fn atan2(self, x: Self) -> Self {
        let per_square = 1.0 / (self.value * self.value + x.value * x.value);
        Dual {
            value: libm::atan2(self.value, x.value),
            slope: (self.slope * x.value - x.slope * self.value) * per_square,
        }
    }

    fn hypot(self, y: Self) -> Self {
        let value = libm::hypot(self.value, y.value);
        Dual {
            value,
            slope: (self.slope * self.value + y.slope * y.value) * (1.0 / value),
        }
    }
}

impl<S: Slope> Dual<S> {
    /// The chain rule: f of this number, given f and f′ at its value.
    pub(crate) fn chain(self, f: f64, derivative: f64) -> Self {
        Dual {
            value: f,
            slope: self.slope * derivative,
        }
    }
}
