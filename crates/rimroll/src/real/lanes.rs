//! SIMD lanes: sixteen numbers on x86-64 and eight on other architectures.
//!
//! Every operation acts on each lane as on an `f64`. So the result of a lane does not depend on its neighbours
//! or on the width of the registers, and equals the scalar result to the last bit. With SIMD registers all functions
//! are inlined into a caller that is compiled for them, where an operation takes one or two instructions per register.

use super::register::Register;
use super::{Real, elementary, even_and_odd};
use core::hint::black_box;
use core::ops::{Add, Div, Mul, Neg, Not, Sub};

/// The number of lanes. Sixteen lanes fill two AVX-512 registers, so that the processor can interleave two dependency
/// chains and hide their latency; more lanes would exceed the number of registers. With narrower registers, long
/// formulas are computed for one part of the lanes at a time (`Vector::Part`).
pub const LANES: usize = if cfg!(target_arch = "x86_64") { 16 } else { 8 };

/// One bit for each lane.
#[cfg(target_arch = "x86_64")]
pub type Bits = u16;
#[cfg(not(target_arch = "x86_64"))]
pub type Bits = u8;

const _: () = assert!(Bits::BITS as usize == LANES);

/// Evaluates an expression for each index below `COUNT`, the number of registers. Up to eight registers it expands to
/// straight code, because a loop that is inlined a thousand times is also unrolled a thousand times, which takes a
/// good part of the compilation time of the core.
macro_rules! for_each_register {
    ($count:expr, $i:ident => $body:expr) => {
        if $count > 8 {
            for $i in 0..$count {
                $body;
            }
        } else {
            for_each_register!(@spelled $count, $i => $body; 0 1 2 3 4 5 6 7);
        }
    };
    (@spelled $count:expr, $i:ident => $body:expr; $($index:literal)*) => {
        $(if $count > $index {
            let $i = $index;
            $body;
        })*
    };
}

/// Numbers packed in `COUNT` registers.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(align(64))]
pub struct Packed<R, const COUNT: usize>(pub [R; COUNT]);

/// The lanes in memory. It is also the vector type for processors whose SIMD registers are not supported here.
pub type Lanes = Packed<f64, LANES>;

/// A mask: a Boolean for each lane.
#[derive(Debug, Clone, Copy)]
pub struct Flagged<R: Register, const COUNT: usize>([R::Flags; COUNT]);

/// All lanes or an equal part of them, in registers.
///
/// Functions that take such a value must be inlined ([`SimdKernel::run`](super::SimdKernel::run)).
pub trait Part: elementary::FloatBits {
    /// The number of parts that make up all lanes.
    const PARTS: usize;

    /// Loads a part of the lanes.
    fn load_part(lanes: &Lanes, part: usize) -> Self;

    /// Stores a part of the lanes.
    fn store_part(self, lanes: &mut Lanes, part: usize);

    /// The index, with its value hidden from the optimizer where compilers assign the lanes to registers. It keeps
    /// them from interleaving several sums, which would make them shuffle the lanes.
    fn opaque(index: usize) -> usize;

    /// Loads a part of the lanes of each array element.
    #[inline(always)]
    fn load_parts<const N: usize>(lanes: &[Lanes; N], part: usize) -> [Self; N] {
        let mut all = [Self::from(0.0); N];
        for i in 0..N {
            all[i] = Self::load_part(&lanes[i], part);
        }
        all
    }

    /// Stores a part of the lanes of each array element.
    #[inline(always)]
    fn store_parts<const N: usize>(all: [Self; N], lanes: &mut [Lanes; N], part: usize) {
        for i in 0..N {
            all[i].store_part(&mut lanes[i], part);
        }
    }
}

/// All lanes in registers.
pub trait Vector: Part {
    /// The part of the lanes for which a long formula fits into the registers of the processor.
    type Part: Part;

    /// A Boolean for each lane.
    type Mask: Mask<Self>;

    /// Loads all lanes.
    #[inline(always)]
    fn load(lanes: &Lanes) -> Self {
        const { assert!(Self::PARTS == 1) };
        Self::load_part(lanes, 0)
    }

    /// Stores all lanes.
    #[inline(always)]
    fn store(self) -> Lanes {
        let mut lanes = Packed([0.0; LANES]);
        self.store_part(&mut lanes, 0);
        lanes
    }

    /// Loads all lanes of each array element.
    #[inline(always)]
    fn load_all<const N: usize>(lanes: &[Lanes; N]) -> [Self; N] {
        Self::load_parts(lanes, 0)
    }

    /// Stores all lanes of each array element.
    #[inline(always)]
    fn store_all<const N: usize>(all: [Self; N]) -> [Lanes; N] {
        let mut lanes = [Lanes::from(0.0); N];
        for i in 0..N {
            lanes[i] = all[i].store();
        }
        lanes
    }

    /// a ≤ b in each lane; false where either is NaN.
    fn at_most(self, other: Self) -> Self::Mask;
}

/// The operations on a Boolean for each lane.
pub trait Mask<L>: Copy + core::fmt::Debug + Not<Output = Self> {
    /// `yes` in the lanes where the mask is set, else `no`.
    fn choose(self, yes: L, no: L) -> L;

    /// The mask, with its origin hidden from the optimizer. Use it to choose numbers that replace numbers in
    /// memory. Compilers that see the comparison emit masked stores, which take ten times as long as full stores on
    /// AMD processors with AVX2.
    #[must_use]
    fn opaque(self) -> Self;

    /// The mask as bits.
    fn bits(self) -> Bits;

    /// Whether the mask is set in all lanes.
    #[inline(always)]
    fn in_all(self) -> bool {
        self.bits() == Bits::MAX
    }

    /// Set in the lanes where either mask is set.
    #[must_use]
    fn or(self, other: Self) -> Self;

    /// Set in the lanes where both masks are set.
    #[must_use]
    fn and(self, other: Self) -> Self;
}

impl<R: Register, const COUNT: usize> Packed<R, COUNT> {
    #[inline(always)]
    fn each(self, f: impl Fn(R) -> R) -> Self {
        if R::OUTLINED {
            return Packed(call_on_each(&self.0, f));
        }
        let mut result = self;
        for_each_register!(COUNT, i => result.0[i] = f(self.0[i]));
        result
    }

    #[inline(always)]
    fn each_with(self, other: Self, f: impl Fn(R, R) -> R) -> Self {
        if R::OUTLINED {
            return Packed(call_on_pairs(&self.0, &other.0, f));
        }
        let mut result = self;
        for_each_register!(COUNT, i => result.0[i] = f(self.0[i], other.0[i]));
        result
    }

    /// Applies a scalar function to each number, where no instruction exists.
    #[inline(always)]
    fn each_number(self, f: impl Fn(f64) -> f64) -> Self {
        let mut numbers = Packed([0.0; LANES]);
        self.store_part(&mut numbers, 0);
        Self::load_part(&Packed(numbers.0.map(f)), 0)
    }
}

impl<R: Register, const COUNT: usize> Part for Packed<R, COUNT> {
    const PARTS: usize = LANES / (COUNT * R::WIDTH);

    #[inline(always)]
    fn load_part(lanes: &Lanes, part: usize) -> Self {
        let mut result = Self::from(0.0);
        for_each_register!(COUNT, i => result.0[i] = R::load(&lanes.0[(part * COUNT + i) * R::WIDTH..]));
        result
    }

    #[inline(always)]
    fn store_part(self, lanes: &mut Lanes, part: usize) {
        for_each_register!(COUNT, i => R::store(self.0[i], &mut lanes.0[(part * COUNT + i) * R::WIDTH..]));
    }

    #[inline(always)]
    fn opaque(index: usize) -> usize {
        if R::WIDTH > 1 {
            index
        } else {
            black_box(index)
        }
    }
}

/// A register type with the part of the lanes that long formulas use.
pub trait Grouped: Register {
    /// As [`Vector::Part`].
    type Part: Part;
}

impl Grouped for f64 {
    type Part = Lanes;
}

impl<R: Grouped, const COUNT: usize> Vector for Packed<R, COUNT> {
    type Part = R::Part;
    type Mask = Flagged<R, COUNT>;

    #[inline(always)]
    fn at_most(self, other: Self) -> Self::Mask {
        if R::OUTLINED {
            return Flagged(call_on_pairs(&self.0, &other.0, R::at_most));
        }
        let mut flags = [R::at_most(self.0[0], other.0[0]); COUNT];
        for_each_register!(COUNT - 1, i => flags[i + 1] = R::at_most(self.0[i + 1], other.0[i + 1]));
        Flagged(flags)
    }
}

impl<R: Register, const COUNT: usize> Mask<Packed<R, COUNT>> for Flagged<R, COUNT> {
    #[inline(always)]
    fn choose(self, yes: Packed<R, COUNT>, no: Packed<R, COUNT>) -> Packed<R, COUNT> {
        if R::OUTLINED {
            return Packed(call_on_triples(&self.0, &yes.0, &no.0, R::choose));
        }
        let mut result = no;
        for_each_register!(COUNT, i => result.0[i] = R::choose(self.0[i], yes.0[i], no.0[i]));
        result
    }

    #[inline(always)]
    fn opaque(self) -> Self {
        let mut result = self;
        for_each_register!(COUNT, i => result.0[i] = R::opaque(self.0[i]));
        result
    }

    #[inline(always)]
    fn bits(self) -> Bits {
        let mut bits = 0;
        for_each_register!(COUNT, i => bits |= Bits::from(R::bits(self.0[i])) << (i * R::WIDTH));
        bits
    }

    #[inline(always)]
    fn or(self, other: Self) -> Self {
        if R::OUTLINED {
            return Flagged(call_on_pairs(&self.0, &other.0, R::or));
        }
        let mut result = self;
        for_each_register!(COUNT, i => result.0[i] = R::or(self.0[i], other.0[i]));
        result
    }

    #[inline(always)]
    fn and(self, other: Self) -> Self {
        if R::OUTLINED {
            return Flagged(call_on_pairs(&self.0, &other.0, R::and));
        }
        let mut result = self;
        for_each_register!(COUNT, i => result.0[i] = R::and(self.0[i], other.0[i]));
        result
    }
}

impl<R: Register, const COUNT: usize> Not for Flagged<R, COUNT> {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        if R::OUTLINED {
            return Flagged(call_on_each(&self.0, R::not));
        }
        let mut result = self;
        for_each_register!(COUNT, i => result.0[i] = R::not(self.0[i]));
        result
    }
}

impl<R: Register, const COUNT: usize> From<f64> for Packed<R, COUNT> {
    #[inline(always)]
    fn from(value: f64) -> Self {
        Packed([R::all(value); COUNT])
    }
}

macro_rules! operators {
    ($($operator:ident $name:ident;)*) => {
        $(impl<R: Register, const COUNT: usize> $operator for Packed<R, COUNT> {
            type Output = Self;
            #[inline(always)]
            fn $name(self, other: Self) -> Self {
                self.each_with(other, R::$name)
            }
        })*
    };
}
operators! { Add add; Sub sub; Mul mul; Div div; }

impl<R: Register, const COUNT: usize> Neg for Packed<R, COUNT> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.each(R::neg)
    }
}

impl<R: Register, const COUNT: usize> Real for Packed<R, COUNT> {
    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let [mut sin, mut cos] = [Lanes::from(0.0); 2];
        self.store_part(&mut sin, 0);
        for i in 0..LANES {
            (sin.0[i], cos.0[i]) = libm::sincos(sin.0[i]);
        }
        (Self::load_part(&sin, 0), Self::load_part(&cos, 0))
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        self.each(R::sqrt)
    }

    #[inline(always)]
    fn exp(self) -> Self {
        self.each_number(libm::exp)
    }

    #[inline(always)]
    fn polynomials<C: Copy + Into<Self>>(rows: &[[C; 4]], x: Self) -> [Self; 4] {
        if R::WIDTH > 1 {
            return even_and_odd(rows, x);
        }
        // `black_box` keeps compilers from interleaving these sums with others, which would make them shuffle the
        // lanes in every round.
        black_box(even_and_odd(rows, black_box(x)))
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

    #[inline(always)]
    fn abs(self) -> Self {
        self.each(R::abs)
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        self.each_with(other, R::max)
    }

    #[inline(always)]
    fn min(self, other: Self) -> Self {
        self.each_with(other, R::min)
    }

    #[inline(always)]
    fn odd_power(self, n: f64) -> Self {
        self.each_number(|a| a.odd_power(n))
    }

    #[inline(always)]
    fn where_negative(self, yes: Self, no: Self) -> Self {
        if R::OUTLINED {
            let negative = call_on_each(&self.0, |a| R::less(a, R::all(0.0)));
            return Flagged::<R, COUNT>(negative).choose(yes, no);
        }
        let mut result = no;
        for_each_register!(COUNT, i => {
            let is_negative = R::less(self.0[i], R::all(0.0));
            result.0[i] = R::choose(is_negative, yes.0[i], no.0[i]);
        });
        result
    }
}

impl<R: Register, const COUNT: usize> elementary::FloatBits for Packed<R, COUNT> {
    #[inline(always)]
    fn ldexp_one(shifted: Self) -> Self {
        shifted.each(R::ldexp_one)
    }

    #[inline(always)]
    fn frexp(self) -> [Self; 2] {
        if R::OUTLINED {
            let exponent = call_on_each(&self.0, |a| R::frexp(a)[0]);
            let mantissa = call_on_each(&self.0, |a| R::frexp(a)[1]);
            return [Packed(exponent), Packed(mantissa)];
        }
        let [mut k, mut m] = [self; 2];
        for_each_register!(COUNT, i => [k.0[i], m.0[i]] = R::frexp(self.0[i]));
        [k, m]
    }

    #[inline(always)]
    fn approx_16th_root_of(a: Self, b: Self) -> Self {
        a.each_with(b, R::approx_16th_root_of)
    }
}

/// Defines functions that act on each element of arrays. They are functions of their own, so that kernels which use them
/// consist of calls. Such kernels compile in a fraction of the time that inlined operations take, and run slower.
macro_rules! elementwise {
    ($($name:ident($($argument:ident: $element:ident),*);)*) => {
        $(#[inline(never)]
        fn $name<$($element: Copy,)* Y: Copy, const COUNT: usize>(
            $($argument: &[$element; COUNT],)*
            f: impl Fn($($element),*) -> Y,
        ) -> [Y; COUNT] {
            let mut result = [f($($argument[0]),*); COUNT];
            for i in 1..COUNT {
                result[i] = f($($argument[i]),*);
            }
            result
        })*
    };
}
elementwise! {
    call_on_each(a: A);
    call_on_pairs(a: A, b: B);
    call_on_triples(a: A, b: B, c: C);
}

#[cfg(test)]
mod tests {
    use super::{LANES, Lanes, Mask, Packed, Vector};
    use crate::real::elementary::FloatBits;
    use crate::real::{Real, SimdKernel, in_every_width};
    use core::array::from_fn;
    use proptest::prelude::*;

    /// A formula with every operation, for arguments of any size.
    fn formula<T: Real>(a: T, b: T) -> T {
        let (sin, cos) = (a * b).sin_cos();
        let sum = (sin / b - cos * a).abs().sqrt() + (-(a * a)).exp().max(b);
        let logarithms = (sum.ln() + sum.approx_ln()).atan() * a.exp_m1();
        sum.where_negative(a, b.odd_power(1.5) + sum) + logarithms.min(b)
    }

    struct Formula([Lanes; 2]);

    impl SimdKernel for Formula {
        type Done = Lanes;
        fn run<V: Vector>(self) -> Lanes {
            let [a, b] = V::load_all(&self.0);
            formula(a, b).store()
        }
    }

    #[test]
    fn each_lane_equals_the_scalar_result() {
        let [a, b]: [Lanes; 2] =
            from_fn(|k| Packed(from_fn(|i| libm::sin((3 * i + 7 * k + 1) as f64))));
        let scalar: [u64; LANES] = from_fn(|i| formula(a.0[i], b.0[i]).to_bits());
        for result in in_every_width(|| Formula([a, b])) {
            assert_eq!(result.0.map(f64::to_bits), scalar);
        }
    }

    /// The operations that consist of a few instructions, for arguments of any value.
    fn instructions<T: FloatBits>(a: T, b: T) -> [T; 12] {
        let [k, m] = a.frexp();
        [
            a + b,
            a - b,
            a * b,
            a / b,
            -a,
            a.abs(),
            a.max(b),
            a.min(b),
            a.where_negative(b, k),
            m,
            T::ldexp_one(a),
            T::approx_16th_root_of(a, b),
        ]
    }

    struct Instructions([Lanes; 2]);

    impl SimdKernel for Instructions {
        type Done = [Lanes; 12];
        fn run<V: Vector>(self) -> [Lanes; 12] {
            let [a, b] = V::load_all(&self.0);
            V::store_all(instructions(a, b))
        }
    }

    /// The bits of a number, with all NaNs treated as equal: IEEE 754 does not specify which NaN an operation gives,
    /// and it does not matter.
    fn bits(x: f64) -> u64 {
        if x.is_nan() {
            f64::NAN.to_bits()
        } else {
            x.to_bits()
        }
    }

    proptest! {
        #[test]
        fn every_width_gives_the_same_bits_for_any_arguments(
            a in prop::array::uniform16(any::<u64>()),
            b in prop::array::uniform16(any::<u64>()),
        ) {
            let [a, b] = [a, b].map(|bits| from_fn(|i| f64::from_bits(bits[i])));
            let scalar: [[f64; 12]; LANES] = from_fn(|i| instructions(a[i], b[i]));
            for results in in_every_width(|| Instructions([Packed(a), Packed(b)])) {
                for (k, lanes) in results.iter().enumerate() {
                    for (lane, expected) in lanes.0.iter().zip(&scalar) {
                        prop_assert_eq!(bits(*lane), bits(expected[k]), "operation {}", k);
                    }
                }
            }
        }
    }

    struct Masks;

    impl SimdKernel for Masks {
        type Done = ();
        fn run<V: Vector>(self) {
            let (one, two) = (V::from(1.0), V::from(2.0));
            let mut mixed = Lanes::from(1.0);
            mixed.0[3] = 3.0;
            mixed.0[5] = f64::NAN;
            let small = V::load(&mixed).at_most(two);
            assert_eq!(small.bits(), !0b10_1000);
            assert_eq!((!small).bits(), 0b10_1000);
            assert_eq!(small.choose(two, one).store().0[3..6], [1.0, 2.0, 1.0]);
            assert_eq!(small.opaque().bits(), small.bits());
            let chosen = small
                .opaque()
                .choose(V::from(-0.0), V::load(&mixed))
                .store();
            assert_eq!(chosen.0[4].to_bits(), (-0.0_f64).to_bits());
            assert!(chosen.0[5].is_nan() && chosen.0[3] == 3.0);
            assert_eq!(small.or(!small).and(small).bits(), small.bits());
            assert_eq!(small.and(!small).bits(), 0);
            assert!(small.or(!small).in_all() && !small.in_all());
        }
    }

    #[test]
    fn masks_act_on_each_lane_and_comparisons_with_nan_are_false() {
        in_every_width(|| Masks);
    }
}
