//! The number types of the mechanics.
//!
//! The equations are generic over [`Real`]: they run on `f64`, on SIMD lanes and on dual numbers, which give
//! exact derivatives. Results must agree to the last bit on every machine. So an implementation uses + − × ÷
//! and the square root, which IEEE 754 defines to the last bit, and `libm` for all other functions. It uses
//! neither the platform's mathematical library nor a fused multiply-add.

mod dual;
mod elementary;
mod lanes;
mod register;
mod simd_dispatch;
#[cfg(target_arch = "x86_64")]
mod x86;

pub(crate) use elementary::{FloatBits, approx_acosh, approx_asinh, asinh, sin_cos_below_eighth};
#[cfg(feature = "ground")]
pub(crate) use elementary::{sin_cos_of_small, sin_cos_without_branches};

pub use dual::{Dual, Slope, Slopes};
pub(crate) use lanes::{Bits, Mask, Packed, Part, Vector};
pub use lanes::{LANES, Lanes};
#[cfg(test)]
pub(crate) use simd_dispatch::in_every_width;
pub(crate) use simd_dispatch::{SimdKernel, Task, call_vectorized, run_widest};
#[cfg(target_arch = "x86_64")]
pub(crate) use x86::Avx2;

use core::ops::{Add, Div, Mul, Neg, Sub};

/// A real number, or a type with the arithmetic of one.
pub trait Real:
    Copy
    + From<f64>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// (sin x, cos x).
    fn sin_cos(self) -> (Self, Self);
    /// √x.
    fn sqrt(self) -> Self;
    /// eˣ.
    fn exp(self) -> Self;
    /// eˣ − 1, for |x| ≤ 700.
    fn exp_m1(self) -> Self;
    /// ln x, for finite x ≥ 1e-300.
    fn ln(self) -> Self;
    /// ln x with an absolute error of up to 4e-4.
    fn approx_ln(self) -> Self;
    /// The angle in (−π/2, π/2) whose tangent is x.
    fn atan(self) -> Self;
    /// |x|.
    fn abs(self) -> Self;
    /// The larger of x and `other`.
    fn max(self, other: Self) -> Self;
    /// The smaller of x and `other`.
    fn min(self, other: Self) -> Self;
    /// `yes` where x < 0, else `no`.
    fn where_negative(self, yes: Self, no: Self) -> Self;
    /// Four polynomials in x, with the coefficients in order of decreasing power.
    #[inline(always)]
    fn polynomials<C: Copy + Into<Self>>(rows: &[[C; 4]], x: Self) -> [Self; 4] {
        even_and_odd(rows, x)
    }
    /// |x|ⁿ with the sign of x, for n ≥ 1.
    fn odd_power(self, n: f64) -> Self;
}

/// Evaluates polynomials by their even and odd powers, which gives the processor twice as many independent sums.
#[inline(always)]
fn even_and_odd<T: Real, C: Copy + Into<T>>(rows: &[[C; 4]], x: T) -> [T; 4] {
    let square = x * x;
    let (mut even, mut odd) = ([T::from(0.0); 4], [T::from(0.0); 4]);
    let (pairs, last) = rows.as_chunks::<2>();
    for [higher, lower] in pairs {
        for j in 0..4 {
            odd[j] = odd[j] * square + higher[j].into();
            even[j] = even[j] * square + lower[j].into();
        }
    }
    for j in 0..4 {
        even[j] = odd[j] * x + even[j];
        if let [row] = last {
            even[j] = even[j] * x + row[j].into();
        }
    }
    even
}

/// A single number, plain or dual, and not lanes of numbers, so that a formula can branch on its value.
pub trait Scalar: Real {
    /// The value without derivatives.
    fn value(self) -> f64;
    /// The angle of the point (`x`, this number), rad.
    fn atan2(self, x: Self) -> Self;
    /// √(x² + y²).
    fn hypot(self, y: Self) -> Self;
}

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

/// Converts structs of numbers between number types, field by field: implements `map` and `write` for a struct `S<T>`
/// over the number type `T`. The list of fields has the numbers first and, after a semicolon, the fields that are such
/// structs themselves.
macro_rules! fieldwise {
    ($name:ident { $($number:ident),*; $($part:ident),* }) => {
        impl<T> $name<T> {
            /// Converts each number to another number type.
            #[inline(always)]
            pub(crate) fn map<U>(&self, f: impl Fn(&T) -> U) -> $name<U> {
                $name {
                    $($number: f(&self.$number),)*
                    $($part: self.$part.map(&f),)*
                }
            }

            /// Writes each number into its counterpart.
            #[inline(always)]
            pub(crate) fn write<U>(&self, to: &mut $name<U>, f: impl Fn(&T, &mut U)) {
                $(f(&self.$number, &mut to.$number);)*
                $(self.$part.write(&mut to.$part, &f);)*
            }
        }
    };
}
pub(crate) use fieldwise;
