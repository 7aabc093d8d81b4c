//! The registers of four and of eight numbers that x86-64 processors with AVX2 and with AVX-512 have.
//!
//! Of numbers in arrays a compiler, left to itself, loses the order on its way to registers: many of its
//! instructions then do nothing but bring numbers from one place to another.
//!
//! These numbers are made and calculated with only in [`in_avx512`] and [`in_avx2`], which are compiled for such
//! processors, and in what is inlined there. So whatever takes a [`Vector`](super::Vector) has to be
//! `#[inline(always)]`, and has no closures and no `map` of an array: they would be compiled without its registers.

use super::elementary::{FRACTION, ROUNDER, SQRT_HALF_BITS};
use super::lanes::{Grouped, LANES, Packed};
use super::register::{ONE_BITS, Register, inlined};
use super::widest::SimdKernel;
use core::arch::x86_64::*;
use core::hint::black_box;

const SQRT_HALF: i64 = SQRT_HALF_BITS.cast_signed();
const ROUNDED: i64 = ROUNDER.to_bits().cast_signed();

type Avx512 = Packed<__m512d, { LANES / 8 }>;
type Avx2 = Packed<__m256d, { LANES / 4 }>;

impl Grouped for __m512d {
    type Part = Avx512;
}

/// Two at once: there are sixteen registers, and four for each number would not be enough.
impl Grouped for __m256d {
    type Part = Packed<__m256d, 2>;
}

/// Does a task in registers of eight.
///
/// # Safety
/// The processor must have AVX-512F.
#[target_feature(enable = "avx512f")]
pub(super) unsafe fn in_avx512<T: SimdKernel>(task: T) -> T::Done {
    task.run::<Avx512>()
}

/// Does a task in registers of four.
///
/// # Safety
/// The processor must have AVX2.
#[target_feature(enable = "avx2")]
pub(super) unsafe fn in_avx2<T: SimdKernel>(task: T) -> T::Done {
    task.run::<Avx2>()
}

/// An instruction of the processor.
macro_rules! instruction {
    ($operation:expr) => {
        // SAFETY: the processor has it, or there would be no such number: see above.
        unsafe { $operation }
    };
}

/// A shift of whole numbers to the right that keeps the sign, which AVX2 does not have: from 2⁶³ on.
macro_rules! shift_right {
    ($numbers:expr, $by:expr) => {{
        let from_least = _mm256_xor_si256($numbers, _mm256_set1_epi64x(i64::MIN));
        let shifted = _mm256_srli_epi64::<{ $by }>(from_least);
        _mm256_sub_epi64(shifted, _mm256_set1_epi64x(1 << (63 - $by)))
    }};
}

impl Register for __m512d {
    type Flags = __mmask8;
    const WIDTH: usize = 8;

    inlined! {
        all(value: f64) -> __m512d = instruction!(_mm512_set1_pd(value));
        add(a: __m512d, b: __m512d) -> __m512d = instruction!(_mm512_add_pd(a, b));
        sub(a: __m512d, b: __m512d) -> __m512d = instruction!(_mm512_sub_pd(a, b));
        mul(a: __m512d, b: __m512d) -> __m512d = instruction!(_mm512_mul_pd(a, b));
        div(a: __m512d, b: __m512d) -> __m512d = instruction!(_mm512_div_pd(a, b));
        neg(a: __m512d) -> __m512d = instruction!({
            let signs = _mm512_set1_epi64(i64::MIN);
            _mm512_castsi512_pd(_mm512_xor_si512(_mm512_castpd_si512(a), signs))
        });
        sqrt(a: __m512d) -> __m512d = instruction!(_mm512_sqrt_pd(a));
        abs(a: __m512d) -> __m512d = instruction!(_mm512_abs_pd(a));
        max(a: __m512d, b: __m512d) -> __m512d = instruction!(_mm512_max_pd(a, b));
        min(a: __m512d, b: __m512d) -> __m512d = instruction!(_mm512_min_pd(a, b));
        less(a: __m512d, b: __m512d) -> u8 = instruction!(_mm512_cmp_pd_mask::<_CMP_LT_OQ>(a, b));
        at_most(a: __m512d, b: __m512d) -> u8 = instruction!(_mm512_cmp_pd_mask::<_CMP_LE_OQ>(a, b));
        choose(flags: u8, yes: __m512d, no: __m512d) -> __m512d =
            instruction!(_mm512_mask_blend_pd(flags, no, yes));
        and(a: u8, b: u8) -> u8 = a & b;
        or(a: u8, b: u8) -> u8 = a | b;
        not(a: u8) -> u8 = !a;
        bits(a: u8) -> u8 = a;
        ldexp_one(shifted: __m512d) -> __m512d = instruction!({
            let k = _mm512_slli_epi64::<FRACTION>(_mm512_castpd_si512(shifted));
            _mm512_castsi512_pd(_mm512_add_epi64(k, _mm512_set1_epi64(ONE_BITS)))
        });
        approx_16th_root_of(a: __m512d, b: __m512d) -> __m512d = instruction!({
            let logarithm = _mm512_sub_epi64(_mm512_castpd_si512(a), _mm512_castpd_si512(b));
            let root = _mm512_srai_epi64::<4>(logarithm);
            _mm512_castsi512_pd(_mm512_add_epi64(root, _mm512_set1_epi64(ONE_BITS)))
        });
        frexp(x: __m512d) -> [__m512d; 2] = instruction!({
            let bits = _mm512_castpd_si512(x);
            let from_half = _mm512_sub_epi64(bits, _mm512_set1_epi64(SQRT_HALF));
            let exponent = _mm512_srai_epi64::<FRACTION>(from_half);
            let m = _mm512_sub_epi64(bits, _mm512_slli_epi64::<FRACTION>(exponent));
            let k = _mm512_add_epi64(exponent, _mm512_set1_epi64(ROUNDED));
            let k = _mm512_sub_pd(_mm512_castsi512_pd(k), _mm512_set1_pd(ROUNDER));
            [k, _mm512_castsi512_pd(m)]
        });
    }

    #[inline(always)]
    fn load(numbers: &[f64]) -> __m512d {
        let numbers = &numbers[..Self::WIDTH];
        // SAFETY: there are so many numbers, and the processor has the register.
        unsafe { _mm512_loadu_pd(numbers.as_ptr()) }
    }

    #[inline(always)]
    fn store(a: __m512d, numbers: &mut [f64]) {
        let numbers = &mut numbers[..Self::WIDTH];
        // SAFETY: there are so many places, and the processor has the register.
        unsafe { _mm512_storeu_pd(numbers.as_mut_ptr(), a) }
    }
}

impl Register for __m256d {
    type Flags = __m256d;
    const WIDTH: usize = 4;

    inlined! {
        all(value: f64) -> __m256d = instruction!(_mm256_set1_pd(value));
        add(a: __m256d, b: __m256d) -> __m256d = instruction!(_mm256_add_pd(a, b));
        sub(a: __m256d, b: __m256d) -> __m256d = instruction!(_mm256_sub_pd(a, b));
        mul(a: __m256d, b: __m256d) -> __m256d = instruction!(_mm256_mul_pd(a, b));
        div(a: __m256d, b: __m256d) -> __m256d = instruction!(_mm256_div_pd(a, b));
        neg(a: __m256d) -> __m256d = instruction!(_mm256_xor_pd(a, _mm256_set1_pd(-0.0)));
        sqrt(a: __m256d) -> __m256d = instruction!(_mm256_sqrt_pd(a));
        abs(a: __m256d) -> __m256d = instruction!(_mm256_andnot_pd(_mm256_set1_pd(-0.0), a));
        max(a: __m256d, b: __m256d) -> __m256d = instruction!(_mm256_max_pd(a, b));
        min(a: __m256d, b: __m256d) -> __m256d = instruction!(_mm256_min_pd(a, b));
        less(a: __m256d, b: __m256d) -> __m256d = instruction!(_mm256_cmp_pd::<_CMP_LT_OQ>(a, b));
        at_most(a: __m256d, b: __m256d) -> __m256d = instruction!(_mm256_cmp_pd::<_CMP_LE_OQ>(a, b));
        // Flags are all bits or none. The instruction for this is made a comparison by compilers, and so undoes
        // what `opaque` is for; where they may see through this, they choose it themselves.
        choose(flags: __m256d, yes: __m256d, no: __m256d) -> __m256d =
            instruction!(_mm256_or_pd(_mm256_and_pd(flags, yes), _mm256_andnot_pd(flags, no)));
        and(a: __m256d, b: __m256d) -> __m256d = instruction!(_mm256_and_pd(a, b));
        or(a: __m256d, b: __m256d) -> __m256d = instruction!(_mm256_or_pd(a, b));
        not(a: __m256d) -> __m256d = instruction!(
            _mm256_xor_pd(a, _mm256_castsi256_pd(_mm256_set1_epi64x(-1)))
        );
        opaque(a: __m256d) -> __m256d = black_box(a);
        bits(a: __m256d) -> u8 = instruction!(_mm256_movemask_pd(a)) as u8;
        ldexp_one(shifted: __m256d) -> __m256d = instruction!({
            let k = _mm256_slli_epi64::<{ FRACTION as i32 }>(_mm256_castpd_si256(shifted));
            _mm256_castsi256_pd(_mm256_add_epi64(k, _mm256_set1_epi64x(ONE_BITS)))
        });
        approx_16th_root_of(a: __m256d, b: __m256d) -> __m256d = instruction!({
            let logarithm = _mm256_sub_epi64(_mm256_castpd_si256(a), _mm256_castpd_si256(b));
            let root = shift_right!(logarithm, 4);
            _mm256_castsi256_pd(_mm256_add_epi64(root, _mm256_set1_epi64x(ONE_BITS)))
        });
        frexp(x: __m256d) -> [__m256d; 2] = instruction!({
            let bits = _mm256_castpd_si256(x);
            let from_half = _mm256_sub_epi64(bits, _mm256_set1_epi64x(SQRT_HALF));
            let exponent = shift_right!(from_half, FRACTION as i32);
            let m = _mm256_sub_epi64(bits, _mm256_slli_epi64::<{ FRACTION as i32 }>(exponent));
            let k = _mm256_add_epi64(exponent, _mm256_set1_epi64x(ROUNDED));
            let k = _mm256_sub_pd(_mm256_castsi256_pd(k), _mm256_set1_pd(ROUNDER));
            [k, _mm256_castsi256_pd(m)]
        });
    }

    #[inline(always)]
    fn load(numbers: &[f64]) -> __m256d {
        let numbers = &numbers[..Self::WIDTH];
        // SAFETY: there are so many numbers, and the processor has the register.
        unsafe { _mm256_loadu_pd(numbers.as_ptr()) }
    }

    #[inline(always)]
    fn store(a: __m256d, numbers: &mut [f64]) {
        let numbers = &mut numbers[..Self::WIDTH];
        // SAFETY: there are so many places, and the processor has the register.
        unsafe { _mm256_storeu_pd(numbers.as_mut_ptr(), a) }
    }
}
