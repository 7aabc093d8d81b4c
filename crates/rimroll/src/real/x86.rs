//! The SIMD registers of x86-64 processors: SSE2 with two numbers, AVX2 with four and AVX-512 with eight. Every such
//! processor has SSE2.
//!
//! SIMD registers are addressed explicitly, because compilers shuffle lanes that are held in arrays: many of the
//! instructions would then only move numbers between lanes.
//!
//! AVX registers are only used in the functions of [`widest`](super::widest) that are compiled for such processors, and
//! in the functions inlined there. So every function that takes a [`Vector`](super::Vector) must be `#[inline(always)]`. It
//! must not contain closures or call `map` on an array, because these would be compiled without AVX.

use super::lanes::{Grouped, LANES, Packed};
use super::register::{FRACTION, ONE_BITS, ROUNDER, Register, SQRT_HALF_BITS, inlined};
use core::arch::x86_64::*;
use core::hint::black_box;

const SQRT_HALF: i64 = SQRT_HALF_BITS.cast_signed();
const ROUNDER_BITS: i64 = ROUNDER.to_bits().cast_signed();

pub(super) type Avx512 = Packed<__m512d, { LANES / 8 }>;
pub(super) type Avx2 = Packed<__m256d, { LANES / 4 }>;
pub(super) type Sse2 = Packed<__m128d, { LANES / 2 }>;

impl Grouped for __m512d {
    type Part = Avx512;
}

/// Two registers for each quantity. All lanes would need four, too many for the sixteen registers of AVX2.
impl Grouped for __m256d {
    type Part = Packed<__m256d, 2>;
}

/// Four registers for each quantity, which hold as many lanes as with AVX2.
impl Grouped for __m128d {
    type Part = Packed<__m128d, 4>;
}

/// Evaluates intrinsics.
macro_rules! instruction {
    ($operation:expr) => {
        // SAFETY: registers of this type exist only in code that runs on processors with these instructions, as
        // the module documentation explains.
        unsafe { $operation }
    };
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
            let k = _mm512_add_epi64(exponent, _mm512_set1_epi64(ROUNDER_BITS));
            let k = _mm512_sub_pd(_mm512_castsi512_pd(k), _mm512_set1_pd(ROUNDER));
            [k, _mm512_castsi512_pd(m)]
        });
    }

    #[inline(always)]
    fn load(numbers: &[f64]) -> __m512d {
        let numbers = &numbers[..Self::WIDTH];
        // SAFETY: the slice has `WIDTH` numbers, and the processor has these registers.
        unsafe { _mm512_loadu_pd(numbers.as_ptr()) }
    }

    #[inline(always)]
    fn store(a: __m512d, numbers: &mut [f64]) {
        let numbers = &mut numbers[..Self::WIDTH];
        // SAFETY: the slice has `WIDTH` numbers, and the processor has these registers.
        unsafe { _mm512_storeu_pd(numbers.as_mut_ptr(), a) }
    }
}

/// Implements [`Register`] for SSE2 and AVX2. Their flags are elements with all bits set or none. They lack an
/// arithmetic right shift of 64-bit integers, which is done by adding 2⁶³, a logical shift and a subtraction.
macro_rules! register_without_masks {
    (
        $register:ident of $width:literal,
        $all:ident $load:ident $store:ident
        $add:ident $sub:ident $mul:ident $div:ident $sqrt:ident $max:ident $min:ident
        $xor:ident $and:ident $and_not:ident $or:ident $bits:ident
        ($less:expr) ($at_most:expr);
        $whole:ident $as_whole:ident $as_numbers:ident
        $add_whole:ident $sub_whole:ident $xor_whole:ident $shift_left:ident $shift_right:ident
    ) => {
        impl Register for $register {
            type Flags = $register;
            const WIDTH: usize = $width;

            inlined! {
                all(value: f64) -> $register = instruction!($all(value));
                add(a: $register, b: $register) -> $register = instruction!($add(a, b));
                sub(a: $register, b: $register) -> $register = instruction!($sub(a, b));
                mul(a: $register, b: $register) -> $register = instruction!($mul(a, b));
                div(a: $register, b: $register) -> $register = instruction!($div(a, b));
                neg(a: $register) -> $register = instruction!($xor(a, $all(-0.0)));
                sqrt(a: $register) -> $register = instruction!($sqrt(a));
                abs(a: $register) -> $register = instruction!($and_not($all(-0.0), a));
                max(a: $register, b: $register) -> $register = instruction!($max(a, b));
                min(a: $register, b: $register) -> $register = instruction!($min(a, b));
                less(a: $register, b: $register) -> $register = instruction!($less(a, b));
                at_most(a: $register, b: $register) -> $register = instruction!($at_most(a, b));
                // The blend intrinsic would defeat `opaque`, because compilers turn it back into a comparison. They
                // choose the blend instruction by themselves where the flags are not opaque.
                choose(flags: $register, yes: $register, no: $register) -> $register =
                    instruction!($or($and(flags, yes), $and_not(flags, no)));
                and(a: $register, b: $register) -> $register = instruction!($and(a, b));
                or(a: $register, b: $register) -> $register = instruction!($or(a, b));
                not(a: $register) -> $register = instruction!($xor(a, $as_numbers($whole(-1))));
                opaque(a: $register) -> $register = black_box(a);
                bits(a: $register) -> u8 = instruction!($bits(a)) as u8;
                ldexp_one(shifted: $register) -> $register = instruction!({
                    let k = $shift_left::<{ FRACTION as i32 }>($as_whole(shifted));
                    $as_numbers($add_whole(k, $whole(ONE_BITS)))
                });
                approx_16th_root_of(a: $register, b: $register) -> $register = instruction!({
                    let logarithm = $sub_whole($as_whole(a), $as_whole(b));
                    let shifted = $shift_right::<4>($xor_whole(logarithm, $whole(i64::MIN)));
                    let root = $sub_whole(shifted, $whole(1 << (63 - 4)));
                    $as_numbers($add_whole(root, $whole(ONE_BITS)))
                });
                frexp(x: $register) -> [$register; 2] = instruction!({
                    let bits = $as_whole(x);
                    let from_half = $sub_whole(bits, $whole(SQRT_HALF));
                    let shifted = $shift_right::<{ FRACTION as i32 }>($xor_whole(from_half, $whole(i64::MIN)));
                    let exponent = $sub_whole(shifted, $whole(1 << (63 - FRACTION)));
                    let m = $sub_whole(bits, $shift_left::<{ FRACTION as i32 }>(exponent));
                    let k = $add_whole(exponent, $whole(ROUNDER_BITS));
                    let k = $sub($as_numbers(k), $all(ROUNDER));
                    [k, $as_numbers(m)]
                });
            }

            #[inline(always)]
            fn load(numbers: &[f64]) -> $register {
                let numbers = &numbers[..Self::WIDTH];
                // SAFETY: the slice has `WIDTH` numbers, and the processor has these registers.
                unsafe { $load(numbers.as_ptr()) }
            }

            #[inline(always)]
            fn store(a: $register, numbers: &mut [f64]) {
                let numbers = &mut numbers[..Self::WIDTH];
                // SAFETY: the slice has `WIDTH` numbers, and the processor has these registers.
                unsafe { $store(numbers.as_mut_ptr(), a) }
            }
        }
    };
}

register_without_masks! {
    __m256d of 4,
    _mm256_set1_pd _mm256_loadu_pd _mm256_storeu_pd
    _mm256_add_pd _mm256_sub_pd _mm256_mul_pd _mm256_div_pd _mm256_sqrt_pd _mm256_max_pd _mm256_min_pd
    _mm256_xor_pd _mm256_and_pd _mm256_andnot_pd _mm256_or_pd _mm256_movemask_pd
    (_mm256_cmp_pd::<_CMP_LT_OQ>) (_mm256_cmp_pd::<_CMP_LE_OQ>);
    _mm256_set1_epi64x _mm256_castpd_si256 _mm256_castsi256_pd
    _mm256_add_epi64 _mm256_sub_epi64 _mm256_xor_si256 _mm256_slli_epi64 _mm256_srli_epi64
}

register_without_masks! {
    __m128d of 2,
    _mm_set1_pd _mm_loadu_pd _mm_storeu_pd
    _mm_add_pd _mm_sub_pd _mm_mul_pd _mm_div_pd _mm_sqrt_pd _mm_max_pd _mm_min_pd
    _mm_xor_pd _mm_and_pd _mm_andnot_pd _mm_or_pd _mm_movemask_pd
    (_mm_cmplt_pd) (_mm_cmple_pd);
    _mm_set1_epi64x _mm_castpd_si128 _mm_castsi128_pd
    _mm_add_epi64 _mm_sub_epi64 _mm_xor_si128 _mm_slli_epi64 _mm_srli_epi64
}
