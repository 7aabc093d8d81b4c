//! Dual numbers a + b ε with ε² = 0: run a formula on them and b is its exact derivative.

use super::Real;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// A value and its derivative along one direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dual {
    /// The value itself.
    pub value: f64,
    /// Its derivative along the chosen direction.
    pub slope: f64,
}

impl From<f64> for Dual {
    fn from(value: f64) -> Self {
        Dual { value, slope: 0.0 }
    }
}

impl Add for Dual {
    type Output = Dual;
    fn add(self, other: Dual) -> Dual {
        Dual {
            value: self.value + other.value,
            slope: self.slope + other.slope,
        }
    }
}

impl Sub for Dual {
    type Output = Dual;
    fn sub(self, other: Dual) -> Dual {
        Dual {
            value: self.value - other.value,
            slope: self.slope - other.slope,
        }
    }
}

impl Mul for Dual {
    type Output = Dual;
    fn mul(self, other: Dual) -> Dual {
        Dual {
            value: self.value * other.value,
            slope: self.slope * other.value + self.value * other.slope,
        }
    }
}

impl Div for Dual {
    type Output = Dual;
    fn div(self, other: Dual) -> Dual {
        let value = self.value / other.value;
        Dual {
            value,
            slope: (self.slope - value * other.slope) / other.value,
        }
    }
}

impl Neg for Dual {
    type Output = Dual;
    fn neg(self) -> Dual {
        Dual {
            value: -self.value,
            slope: -self.slope,
        }
    }
}

impl Real for Dual {
    fn sin_cos(self) -> (Dual, Dual) {
        let (sin, cos) = libm::sincos(self.value);
        (self.chain(sin, cos), self.chain(cos, -sin))
    }

    fn sqrt(self) -> Dual {
        let root = self.value.sqrt();
        self.chain(root, 0.5 / root)
    }

    fn exp(self) -> Dual {
        let power = libm::exp(self.value);
        self.chain(power, power)
    }

    fn abs(self) -> Dual {
        if self.is_negative() { -self } else { self }
    }

    fn max(self, other: Dual) -> Dual {
        if self.value > other.value {
            self
        } else {
            other
        }
    }

    fn is_negative(self) -> bool {
        self.value < 0.0
    }

    fn odd_power(self, n: f64) -> Dual {
        let slope = n * libm::pow(self.value.abs(), n - 1.0);
        self.chain(self.value.odd_power(n), slope)
    }
}

impl Dual {
    /// f of this number, given f and f′ at its value.
    fn chain(self, f: f64, derivative: f64) -> Dual {
        Dual {
            value: f,
            slope: derivative * self.slope,
        }
    }
}
