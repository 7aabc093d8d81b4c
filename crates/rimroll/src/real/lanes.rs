//! Lanes: eight numbers that are calculated with at once.
//!
//! Every operation is the `f64` one, lane by lane, so that what a lane computes does not depend on its
//! neighbours and is to the last bit what `f64` alone computes. All is inlined: compiled into a function
//! that may use vector instructions, an operation is one or two of them.

use super::Real;
use core::array::from_fn;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// How many lanes there are.
pub const LANES: usize = 8;

/// Eight numbers side by side.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(align(64))]
pub struct Lanes(pub [f64; LANES]);

/// A yes or no for each lane, as 0 or all ones.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(align(64))]
pub struct Mask([u64; LANES]);

impl Lanes {
    /// Whether a lane is at most the other's; a NaN is not.
    #[inline(always)]
    pub fn at_most(self, other: Lanes) -> Mask {
        Mask(from_fn(
            |i| {
                if self.0[i] <= other.0[i] { u64::MAX } else { 0 }
            },
        ))
    }

    /// The smaller in each lane.
    #[inline(always)]
    pub fn min(self, other: Lanes) -> Lanes {
        self.each_with(other, |a, b| if a < b { a } else { b })
    }

    #[inline(always)]
    fn each_with(self, other: Lanes, f: impl Fn(f64, f64) -> f64) -> Lanes {
        let mut result = self;
        for i in 0..LANES {
            result.0[i] = f(self.0[i], other.0[i]);
        }
        result
    }

    #[inline(always)]
    fn each(self, f: impl Fn(f64) -> f64) -> Lanes {
        let mut result = self;
        for i in 0..LANES {
            result.0[i] = f(self.0[i]);
        }
        result
    }
}

impl Mask {
    /// `yes` where it holds, else `no`.
    #[inline(always)]
    pub fn choose(self, yes: Lanes, no: Lanes) -> Lanes {
        let mut result = no;
        for i in 0..LANES {
            let (a, b) = (yes.0[i].to_bits(), no.0[i].to_bits());
            result.0[i] = f64::from_bits((a & self.0[i]) | (b & !self.0[i]));
        }
        result
    }

    /// The lanes where it holds, as bits.
    #[inline(always)]
    pub fn bits(self) -> u8 {
        let mut bits = 0;
        for i in 0..LANES {
            bits |= ((self.0[i] & 1) as u8) << i;
        }
        bits
    }

    /// Holds where both do.
    #[inline(always)]
    pub fn and(self, other: Mask) -> Mask {
        Mask(from_fn(|i| self.0[i] & other.0[i]))
    }
}

impl From<f64> for Lanes {
    #[inline(always)]
    fn from(value: f64) -> Self {
        Lanes([value; LANES])
    }
}

impl Add for Lanes {
    type Output = Lanes;
    #[inline(always)]
    fn add(self, other: Lanes) -> Lanes {
        self.each_with(other, |a, b| a + b)
    }
}

impl Sub for Lanes {
    type Output = Lanes;
    #[inline(always)]
    fn sub(self, other: Lanes) -> Lanes {
        self.each_with(other, |a, b| a - b)
    }
}

impl Mul for Lanes {
    type Output = Lanes;
    #[inline(always)]
    fn mul(self, other: Lanes) -> Lanes {
        self.each_with(other, |a, b| a * b)
    }
}

impl Div for Lanes {
    type Output = Lanes;
    #[inline(always)]
    fn div(self, other: Lanes) -> Lanes {
        self.each_with(other, |a, b| a / b)
    }
}

impl Neg for Lanes {
    type Output = Lanes;
    #[inline(always)]
    fn neg(self) -> Lanes {
        self.each(|a| -a)
    }
}

impl Real for Lanes {
    #[inline(always)]
    fn sin_cos(self) -> (Lanes, Lanes) {
        let pairs = self.0.map(libm::sincos);
        (
            Lanes(pairs.map(|pair| pair.0)),
            Lanes(pairs.map(|pair| pair.1)),
        )
    }

    #[inline(always)]
    fn sqrt(self) -> Lanes {
        self.each(f64::sqrt)
    }

    #[inline(always)]
    fn exp(self) -> Lanes {
        self.each(libm::exp)
    }

    #[inline(always)]
    fn polynomials<C: Copy + Into<Lanes>>(rows: &[[C; 4]], x: Lanes) -> [Lanes; 4] {
        // Among other sums compilers lose the order of the lanes, and shuffle them in every round.
        let x = core::hint::black_box(x);
        let mut sums = [Lanes::from(0.0); 4];
        for row in rows {
            for (sum, &coefficient) in sums.iter_mut().zip(row) {
                *sum = *sum * x + coefficient.into();
            }
        }
        core::hint::black_box(sums)
    }

    #[inline(always)]
    fn exp_m1(self) -> Lanes {
        self.each(Real::exp_m1)
    }

    #[inline(always)]
    fn ln(self) -> Lanes {
        self.each(Real::ln)
    }

    #[inline(always)]
    fn atan(self) -> Lanes {
        self.each(libm::atan)
    }

    #[inline(always)]
    fn abs(self) -> Lanes {
        self.each(f64::abs)
    }

    #[inline(always)]
    fn max(self, other: Lanes) -> Lanes {
        self.each_with(other, |a, b| if a > b { a } else { b })
    }

    #[inline(always)]
    fn odd_power(self, n: f64) -> Lanes {
        self.each(|a| a.odd_power(n))
    }

    #[inline(always)]
    fn where_negative(self, yes: Lanes, no: Lanes) -> Lanes {
        let mut result = no;
        for i in 0..LANES {
            result.0[i] = if self.0[i] < 0.0 { yes.0[i] } else { no.0[i] };
        }
        result
    }
}
