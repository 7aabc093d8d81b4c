//! Lanes: eight numbers that are calculated with at once.
//!
//! Every operation is the `f64` one, lane by lane, so that what a lane computes does not depend on its
//! neighbours and is to the last bit what `f64` alone computes. All is inlined: compiled into a function
//! that may use vector instructions, an operation is one or two of them.

use super::{Real, even_and_odd};
use core::array::from_fn;
use core::hint::black_box;
use core::ops::{Add, Div, Mul, Neg, Not, Sub};

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

// Written so that compilers see registers of masks: a step of falls takes a sixth fewer instructions than with loops.
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

    /// Holds where either does.
    #[inline(always)]
    #[must_use]
    pub fn or(self, other: Mask) -> Mask {
        Mask(from_fn(|i| self.0[i] | other.0[i]))
    }

    /// Holds where both do.
    #[inline(always)]
    #[must_use]
    pub fn and(self, other: Mask) -> Mask {
        Mask(from_fn(|i| self.0[i] & other.0[i]))
    }
}

impl Not for Mask {
    type Output = Mask;
    #[inline(always)]
    fn not(self) -> Mask {
        Mask(from_fn(|i| !self.0[i]))
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
        black_box(even_and_odd(rows, black_box(x)))
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
    fn rough_ln(self) -> Lanes {
        self.each(Real::rough_ln)
    }

    #[inline(always)]
    fn atan(self) -> Lanes {
        self.each(Real::atan)
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
    fn min(self, other: Lanes) -> Lanes {
        self.each_with(other, |a, b| if a < b { a } else { b })
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

#[cfg(test)]
mod tests {
    use super::{LANES, Lanes};
    use crate::real::Real;
    use core::array::from_fn;

    /// A formula with every operation, that takes numbers of any size.
    fn formula<T: Real>(a: T, b: T) -> T {
        let (sin, cos) = (a * b).sin_cos();
        let sum = (sin / b - cos * a).abs().sqrt() + (-(a * a)).exp().max(b);
        sum.where_negative(a, b.odd_power(1.5) + sum)
    }

    #[test]
    fn each_lane_computes_what_a_number_alone_does() {
        let numbers: [[f64; LANES]; 2] =
            from_fn(|k| from_fn(|i| libm::sin((3 * i + 7 * k + 1) as f64)));
        let together = formula(Lanes(numbers[0]), Lanes(numbers[1]));
        for (i, found) in together.0.into_iter().enumerate() {
            let alone = formula(numbers[0][i], numbers[1][i]);
            assert_eq!(found.to_bits(), alone.to_bits());
        }
    }

    #[test]
    fn a_mask_chooses_lane_by_lane_and_a_nan_is_at_most_nothing() {
        let (one, two) = (Lanes::from(1.0), Lanes::from(2.0));
        let mut mixed = one;
        mixed.0[3] = 3.0;
        mixed.0[5] = f64::NAN;
        let small = mixed.at_most(two);
        assert_eq!(small.bits(), 0b1101_0111);
        assert_eq!((!small).bits(), 0b0010_1000);
        assert_eq!(small.choose(two, one).0[3], 1.0);
        assert_eq!(small.or(!small).and(small), small);
    }
}
