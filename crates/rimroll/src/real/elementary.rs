//! eˣ − 1, ln x, and trigonometric and inverse hyperbolic functions without branches. They use only + − × ÷ √
//! and operations on the bits of the exponent, so that sixteen lanes give the same bits as a scalar.

use super::Real;
use super::register::{ROUNDER, Register};
#[cfg(feature = "ground")]
use core::f64::consts::FRAC_2_PI;
use core::f64::consts::{FRAC_PI_2, FRAC_PI_4, LN_2, SQRT_2};

/// ln 2 as a sum. The first term has so few bits that its product with an exponent is exact.
const LN_2_HIGH: f64 = 6.931_471_803_691_238_2e-1;
const LN_2_LOW: f64 = 1.908_214_929_270_587_7e-10;

/// Numbers with access to the exponent and the fraction.
pub trait FloatBits: Real {
    /// 2ᵏ, given k + [`ROUNDER`] with |k| < 1023.
    fn ldexp_one(shifted: Self) -> Self;

    /// [k, m] with x = 2ᵏ m and m between √½ and √2, for normal x > 0.
    fn frexp(self) -> [Self; 2];

    /// An approximation of the 16th root of a/b for positive numbers, up to 6 % too large. The bits of a positive
    /// number, read as an integer, approximate its binary logarithm within 0.1, up to a scale and an offset.
    fn approx_16th_root_of(a: Self, b: Self) -> Self;
}

impl FloatBits for f64 {
    #[inline(always)]
    fn ldexp_one(shifted: f64) -> f64 {
        Register::ldexp_one(shifted)
    }

    #[inline(always)]
    fn frexp(self) -> [f64; 2] {
        Register::frexp(self)
    }

    #[inline(always)]
    fn approx_16th_root_of(a: f64, b: f64) -> f64 {
        Register::approx_16th_root_of(a, b)
    }
}

/// eˣ − 1 for |x| ≤ 700, to 2 units in the last place.
#[inline(always)]
pub(super) fn exp_m1<T: FloatBits>(x: T) -> T {
    // x = k ln 2 + r with |r| ≤ ln 2 / 2; eˣ − 1 = 2ᵏ (eʳ − 1) + (2ᵏ − 1).
    let shifted = x * T::from(1.0 / LN_2) + T::from(ROUNDER);
    let k = shifted - T::from(ROUNDER);
    let r = (x - k * T::from(LN_2_HIGH)) - k * T::from(LN_2_LOW);
    let power = T::ldexp_one(shifted);
    // The series of eʳ to r¹³, with separate sums of even and odd terms. The remainder is less than 1e-17 r.
    let rr = r * r;
    let (mut even, mut odd) = (T::from(0.0), T::from(0.0));
    for [even_coefficient, odd_coefficient] in INVERSE_FACTORIALS {
        even = even * rr + T::from(even_coefficient);
        odd = odd * rr + T::from(odd_coefficient);
    }
    power * (r + rr * (even + r * odd)) + (power - T::from(1.0))
}

/// 1/12!, 1/13!; … 1/2!, 1/3!.
const INVERSE_FACTORIALS: [[f64; 2]; 6] = [
    [1.0 / 479_001_600.0, 1.0 / 6_227_020_800.0],
    [1.0 / 3_628_800.0, 1.0 / 39_916_800.0],
    [1.0 / 40_320.0, 1.0 / 362_880.0],
    [1.0 / 720.0, 1.0 / 5_040.0],
    [1.0 / 24.0, 1.0 / 120.0],
    [0.5, 1.0 / 6.0],
];

/// ln x for normal x > 0, with an absolute error of up to 4e-4.
#[inline(always)]
pub(super) fn approx_ln<T: FloatBits>(x: T) -> T {
    let [k, m] = x.frexp();
    let f = m - T::from(1.0);
    let mut sum = T::from(0.0);
    for coefficient in [-1.0 / 6.0, 0.2, -0.25, 1.0 / 3.0, -0.5, 1.0] {
        sum = sum * f + T::from(coefficient);
    }
    k * T::from(LN_2) + f * sum
}

/// ln x = k ln 2 + ln m for normal x > 0. The error is at most 2 units in the last place of the largest of the
/// three logarithms.
#[inline(always)]
pub(super) fn ln<T: FloatBits>(x: T) -> T {
    // ln m = 2 artanh f, f = (m − 1)/(m + 1).
    let [k, m] = x.frexp();
    let (one, two) = (T::from(1.0), T::from(2.0));
    let f = (m - one) / (m + one);
    let ff = f * f;
    let mut sum = T::from(1.0 / 23.0);
    for odd in [21.0, 19.0, 17.0, 15.0, 13.0, 11.0, 9.0, 7.0, 5.0, 3.0] {
        sum = sum * ff + T::from(1.0 / odd);
    }
    k * T::from(LN_2_HIGH) + (two * (f + f * ff * sum) + k * T::from(LN_2_LOW))
}

/// The angle in (−π/2, π/2) whose tangent is x, to 2 units in the last place.
#[inline(always)]
pub(super) fn atan<T: Real>(x: T) -> T {
    const TAN_PI_8: f64 = SQRT_2 - 1.0;
    const TAN_3_PI_8: f64 = SQRT_2 + 1.0;
    let (zero, one) = (T::from(0.0), T::from(1.0));
    let size = x.abs();
    // After subtraction of 0, π/4 or π/2 the angle is at most π/8 in magnitude. Its tangent is
    // t = numerator/denominator.
    let (to_eighth, to_quarter) = (T::from(TAN_PI_8) - size, T::from(TAN_3_PI_8) - size);
    let numerator = to_quarter.where_negative(-one, to_eighth.where_negative(size - one, size));
    let denominator = to_quarter.where_negative(size, to_eighth.where_negative(size + one, one));
    let (eighth, quarter) = (T::from(FRAC_PI_4), T::from(FRAC_PI_2));
    let subtracted = to_quarter.where_negative(quarter, to_eighth.where_negative(eighth, zero));
    let t = numerator / denominator;
    // The series of atan t to t⁴¹. The remainder is less than 1e-17 t.
    let tt = t * t;
    let pair = tt * tt;
    let (mut even, mut odd) = (zero, zero);
    for n in (1..=10).rev() {
        odd = odd * pair - T::from(1.0 / f64::from(4 * n - 1));
        even = even * pair + T::from(1.0 / f64::from(4 * n + 1));
    }
    let angle = subtracted + (t + t * tt * (odd + tt * even));
    x.where_negative(-angle, angle)
}

/// (sin x, cos x) for |x| ≤ π/4.
#[inline(always)]
pub(crate) fn sin_cos_below_eighth<T: Real>(x: T) -> (T, T) {
    let one = T::from(1.0);
    let square = x * x;
    // The series of sin x to x¹⁷ and of cos x to x¹⁶. The remainders are less than 1e-17.
    let (mut sin, mut cos) = (one, one);
    for n in (1..=8).rev() {
        let (sin_divisor, cos_divisor) = (2 * n * (2 * n + 1), 2 * n * (2 * n - 1));
        sin = one - square * T::from(1.0 / f64::from(sin_divisor)) * sin;
        cos = one - square * T::from(1.0 / f64::from(cos_divisor)) * cos;
    }
    (x * sin, cos)
}

/// (sin x, cos x) for |x| ≤ 1e6, to a few units in the last place of 1.
#[cfg(feature = "ground")]
#[inline(always)]
pub(crate) fn sin_cos_without_branches<T: Real>(x: T) -> (T, T) {
    // x = k π/2 + r. The first two terms of π/2 have so few bits that their products with k are exact.
    const HIGH: f64 = 1.570_796_326_734_125_6;
    const MIDDLE: f64 = 6.077_100_506_303_966e-11;
    const LOW: f64 = 2.022_266_248_795_950_6e-21;
    let k = nearest(x * T::from(FRAC_2_PI));
    let r = ((x - k * T::from(HIGH)) - k * T::from(MIDDLE)) - k * T::from(LOW);
    let (sin, cos) = sin_cos_below_eighth(r);
    // k modulo 4, from −2 to 2.
    let quarter = k - T::from(4.0) * nearest(k * T::from(0.25));
    let odd = (quarter.abs() - T::from(1.0)).abs() - T::from(0.5);
    let half = T::from(1.5) - quarter.abs();
    let (from_sin, from_cos) = (odd.where_negative(cos, sin), odd.where_negative(sin, cos));
    // Both change sign after half a turn; for odd quarters the sine has the sign of k and the cosine the opposite one.
    let sign_of_odd = quarter.where_negative(-T::from(1.0), T::from(1.0));
    let sign_of_even = half.where_negative(-T::from(1.0), T::from(1.0));
    (
        odd.where_negative(sign_of_odd, sign_of_even) * from_sin,
        odd.where_negative(-sign_of_odd, sign_of_even) * from_cos,
    )
}

/// The nearest whole number, for |x| < 2⁵¹.
#[cfg(feature = "ground")]
#[inline(always)]
fn nearest<T: Real>(x: T) -> T {
    (x + T::from(ROUNDER)) - T::from(ROUNDER)
}

/// (sin x, cos x) for |x| ≤ 0.1, to a few units in the last place of 1.
#[cfg(feature = "ground")]
#[inline(always)]
pub(crate) fn sin_cos_of_small<T: Real>(x: T) -> (T, T) {
    let (one, square) = (T::from(1.0), x * x);
    // The series of sin x to x⁹ and of cos x to x⁸. The remainders are less than 3e-17.
    let (mut sin, mut cos) = (T::from(1.0 / 362_880.0), T::from(1.0 / 40_320.0));
    for (sin_coefficient, cos_coefficient) in [
        (-1.0 / 5_040.0, -1.0 / 720.0),
        (1.0 / 120.0, 1.0 / 24.0),
        (-1.0 / 6.0, -0.5),
    ] {
        sin = sin * square + T::from(sin_coefficient);
        cos = cos * square + T::from(cos_coefficient);
    }
    (x * (one + square * sin), one + square * cos)
}

/// arsinh x for |x| < 1e150. The absolute error is of the order of rounding errors.
#[inline(always)]
pub(crate) fn asinh<T: Real>(x: T) -> T {
    let size = x.abs();
    let positive = (size + (size * size + T::from(1.0)).sqrt()).ln();
    x.where_negative(-positive, positive)
}

/// arsinh x for x ≥ 0, with an absolute error of up to 4e-4.
#[inline(always)]
pub(crate) fn approx_asinh<T: Real>(x: T) -> T {
    (x + (x * x + T::from(1.0)).sqrt()).approx_ln()
}

/// arcosh x for x ≥ 1, with an absolute error of up to 4e-4.
#[inline(always)]
pub(crate) fn approx_acosh<T: Real>(x: T) -> T {
    (x + (x * x - T::from(1.0)).sqrt()).approx_ln()
}

#[cfg(test)]
mod tests {
    use super::{
        approx_ln, atan, exp_m1, ln, sin_cos_below_eighth, sin_cos_of_small,
        sin_cos_without_branches,
    };
    use core::f64::consts::FRAC_PI_4;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn exponentials_and_logarithms_agree_with_libm(x in -40.0..40.0_f64, scale in -60.0..0.0_f64) {
            let x = x * libm::exp(scale);
            let expected = libm::expm1(x);
            prop_assert!((exp_m1(x) - expected).abs() <= 4.0 * f64::EPSILON * expected.abs());
            let y = libm::exp(x);
            prop_assert!((ln(y) - libm::log(y)).abs() <= 3.0 * f64::EPSILON * libm::log(y).abs());
            prop_assert!((approx_ln(y) - libm::log(y)).abs() <= 4e-4);
        }

        #[test]
        fn trigonometric_functions_agree_with_libm(exponent in -30.0..30.0_f64, sign in prop::bool::ANY) {
            let x = if sign { libm::exp(exponent) } else { -libm::exp(exponent) };
            prop_assert!((atan(x) - libm::atan(x)).abs() <= 2.0 * f64::EPSILON * libm::atan(x).abs());
            let angle = libm::fmod(x, FRAC_PI_4);
            let (sin, cos) = sin_cos_below_eighth(angle);
            prop_assert!((sin - libm::sin(angle)).abs() <= 2.0 * f64::EPSILON * angle.abs());
            prop_assert!((cos - libm::cos(angle)).abs() <= 2.0 * f64::EPSILON);
        }

        #[test]
        fn sine_and_cosine_without_branches_agree_with_libm(x in -1e6..1e6_f64, scale in -20.0..0.0_f64) {
            let close = |(sin, cos): (f64, f64), x: f64| {
                (sin - libm::sin(x)).abs().max((cos - libm::cos(x)).abs()) <= 3.0 * f64::EPSILON
            };
            let x = x * libm::exp(scale);
            prop_assert!(close(sin_cos_without_branches(x), x));
            let small = libm::fmod(x, 0.1);
            prop_assert!(close(sin_cos_of_small(small), small));
        }
    }
}
