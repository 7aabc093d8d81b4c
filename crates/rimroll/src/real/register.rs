//! Registers: the trait, and its implementation for a single number. SIMD registers are in [`x86`](super::x86).

/// 1.5 · 2⁵². After this number is added, the lowest bits hold the nearest integer.
pub(super) const ROUNDER: f64 = 6_755_399_441_055_744.0;

/// The number of fraction bits of a double.
pub(super) const FRACTION: u32 = 52;

/// The bits of √½.
pub(super) const SQRT_HALF_BITS: u64 = 0x3FE6_A09E_667F_3BCD;

/// The bits of 1.
pub(super) const ONE_BITS: i64 = 1.0_f64.to_bits().cast_signed();

/// A register of one or more numbers. Each operation acts elementwise as on `f64`.
pub trait Register: Copy + core::fmt::Debug {
    /// A Boolean for each number.
    type Flags: Copy + core::fmt::Debug;
    /// The count of numbers in the register.
    const WIDTH: usize;
    /// Whether an operation on all lanes is a function of its own. Then kernels consist of calls: they compile in a
    /// fraction of the time, and run slower.
    const OUTLINED: bool;

    /// A register with the same number in every element.
    fn all(value: f64) -> Self;
    /// Loads the first [`Register::WIDTH`] numbers.
    fn load(numbers: &[f64]) -> Self;
    /// Stores into the first [`Register::WIDTH`] numbers.
    fn store(a: Self, numbers: &mut [f64]);

    /// a + b.
    fn add(a: Self, b: Self) -> Self;
    /// a − b.
    fn sub(a: Self, b: Self) -> Self;
    /// a · b.
    fn mul(a: Self, b: Self) -> Self;
    /// a / b.
    fn div(a: Self, b: Self) -> Self;
    /// −a.
    fn neg(a: Self) -> Self;
    /// √a.
    fn sqrt(a: Self) -> Self;
    /// |a|.
    fn abs(a: Self) -> Self;
    /// a where a > b, else b.
    fn max(a: Self, b: Self) -> Self;
    /// a where a < b, else b.
    fn min(a: Self, b: Self) -> Self;

    /// a < b.
    fn less(a: Self, b: Self) -> Self::Flags;
    /// a ≤ b.
    fn at_most(a: Self, b: Self) -> Self::Flags;
    /// `yes` where a flag is set, else `no`.
    fn choose(flags: Self::Flags, yes: Self, no: Self) -> Self;
    /// a ∧ b.
    fn and(a: Self::Flags, b: Self::Flags) -> Self::Flags;
    /// a ∨ b.
    fn or(a: Self::Flags, b: Self::Flags) -> Self::Flags;
    /// ¬a.
    fn not(a: Self::Flags) -> Self::Flags;
    /// The flags, with their origin hidden from the optimizer where that matters
    /// ([`Mask::opaque`](super::Mask::opaque)).
    fn opaque(a: Self::Flags) -> Self::Flags {
        a
    }
    /// The flags as the lowest bits.
    fn bits(a: Self::Flags) -> u8;

    /// As [`FloatBits::ldexp_one`](super::FloatBits::ldexp_one).
    fn ldexp_one(shifted: Self) -> Self;
    /// As [`FloatBits::frexp`](super::FloatBits::frexp).
    fn frexp(x: Self) -> [Self; 2];
    /// As [`FloatBits::approx_16th_root_of`](super::FloatBits::approx_16th_root_of).
    fn approx_16th_root_of(a: Self, b: Self) -> Self;
}

/// Defines functions that are always inlined.
macro_rules! inlined {
    ($($name:ident($($argument:ident: $kind:ty),*) -> $result:ty = $value:expr;)*) => {
        $(#[inline(always)]
        fn $name($($argument: $kind),*) -> $result {
            $value
        })*
    };
}
#[cfg(target_arch = "x86_64")]
pub(super) use inlined;

/// A flag is a mask of 64 equal bits, as SIMD comparisons give it, so that compilers can vectorize these operations.
impl Register for f64 {
    type Flags = u64;
    const WIDTH: usize = 1;
    /// On x86-64 this type serves old processors, which lack AVX2, and debug builds.
    const OUTLINED: bool = cfg!(target_arch = "x86_64");

    inlined! {
        all(value: f64) -> f64 = value;
        load(numbers: &[f64]) -> f64 = numbers[0];
        store(a: f64, numbers: &mut [f64]) -> () = numbers[0] = a;
        add(a: f64, b: f64) -> f64 = a + b;
        sub(a: f64, b: f64) -> f64 = a - b;
        mul(a: f64, b: f64) -> f64 = a * b;
        div(a: f64, b: f64) -> f64 = a / b;
        neg(a: f64) -> f64 = -a;
        sqrt(a: f64) -> f64 = a.sqrt();
        abs(a: f64) -> f64 = a.abs();
        max(a: f64, b: f64) -> f64 = if a > b { a } else { b };
        min(a: f64, b: f64) -> f64 = if a < b { a } else { b };
        less(a: f64, b: f64) -> u64 = if a < b { u64::MAX } else { 0 };
        at_most(a: f64, b: f64) -> u64 = if a <= b { u64::MAX } else { 0 };
        choose(flags: u64, yes: f64, no: f64) -> f64 =
            f64::from_bits((yes.to_bits() & flags) | (no.to_bits() & !flags));
        and(a: u64, b: u64) -> u64 = a & b;
        or(a: u64, b: u64) -> u64 = a | b;
        not(a: u64) -> u64 = !a;
        bits(a: u64) -> u8 = (a & 1) as u8;
        ldexp_one(shifted: f64) -> f64 =
            f64::from_bits((shifted.to_bits() << FRACTION).wrapping_add(1.0_f64.to_bits()));
    }

    #[inline(always)]
    fn approx_16th_root_of(a: f64, b: f64) -> f64 {
        let logarithm = a.to_bits().wrapping_sub(b.to_bits()).cast_signed();
        f64::from_bits((logarithm >> 4).wrapping_add(ONE_BITS).cast_unsigned())
    }

    #[inline(always)]
    fn frexp(x: f64) -> [f64; 2] {
        let bits = x.to_bits().wrapping_sub(SQRT_HALF_BITS);
        let exponent = (bits as i64) >> FRACTION;
        let m = f64::from_bits(x.to_bits().wrapping_sub((exponent as u64) << FRACTION));
        // This converts an integer to a double. The conversion instruction has no SIMD form.
        let k = f64::from_bits(ROUNDER.to_bits().wrapping_add(exponent as u64)) - ROUNDER;
        [k, m]
    }
}
