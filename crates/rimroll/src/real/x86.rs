//! The SIMD registers of x86-64 processors: AVX2 with four numbers and AVX-512 with eight.
//!
//! SIMD registers are addressed explicitly, because compilers shuffle lanes that are held in arrays: many of the
//! instructions would then only move numbers between lanes.
//!
//! No safe function executes an instruction that the processor lacks, because
//!
//! * a value of [`Avx2`] or [`Avx512`] exists only if the processor has these instructions;
//! * the register types are private to this file and named only in [`Avx2::run`] and [`Avx512::run`], which need such
//!   a value. Other code knows them only as the type parameter of a kernel that is running in them.
//!
//! So the operations on registers need no proof of their own, not even those that make a number from nothing, such
//! as `From<f64>`, which generic formulas use for their constants.
//!
//! The two functions compile a kernel, with all that is inlined into it, for its registers. So every function that
//! takes a [`Vector`](super::Vector) must be `#[inline(always)]`. It must not contain closures or call `map` on an
//! array, because these would be compiled without AVX and be slow.

use super::lanes::{Grouped, LANES, Packed};
use super::register::{FRACTION, ONE_BITS, ROUNDER, Register, SQRT_HALF_BITS, inlined};
use super::simd_dispatch::{SimdKernel, Task};
use core::arch::x86_64::*;
use core::hint::black_box;
use std::arch::is_x86_feature_detected;

const SQRT_HALF: i64 = SQRT_HALF_BITS.cast_signed();
const ROUNDER_BITS: i64 = ROUNDER.to_bits().cast_signed();

/// Eight numbers.
#[derive(Debug, Clone, Copy)]
#[repr(transparent)]
struct Zmm(__m512d);

/// Four numbers.
#[derive(Debug, Clone, Copy)]
#[repr(transparent)]
struct Ymm(__m256d);

impl Grouped for Zmm {
    type Part = Packed<Zmm, { LANES / 8 }>;
}

/// Two registers for each quantity. All lanes would need four, too many for the sixteen registers of AVX2.
impl Grouped for Ymm {
    type Part = Packed<Ymm, 2>;
}

/// A proof that the processor has AVX-512F.
#[derive(Debug, Clone, Copy)]
pub struct Avx512(());

impl Avx512 {
    /// The proof, if the processor has AVX-512F.
    pub fn detect() -> Option<Self> {
        is_x86_feature_detected!("avx512f").then_some(Avx512(()))
    }

    /// Runs a computation in AVX-512 registers.
    pub fn run<K: SimdKernel>(self, kernel: K) -> K::Done {
        #[target_feature(enable = "avx512f")]
        fn compiled<K: SimdKernel>(kernel: K) -> K::Done {
            kernel.run::<Packed<Zmm, { LANES / 8 }>>()
        }
        // SAFETY: `self` proves that the processor has AVX-512F.
        unsafe { compiled(kernel) }
    }
}

/// A proof that the processor has AVX2.
#[derive(Debug, Clone, Copy)]
pub struct Avx2(());

impl Avx2 {
    /// The proof, if the processor has AVX2.
    pub fn detect() -> Option<Self> {
        is_x86_feature_detected!("avx2").then_some(Avx2(()))
    }

    /// Runs a computation that is compiled for processors with AVX2.
    pub fn call<T: Task>(self, task: T) -> T::Done {
        #[target_feature(enable = "avx2")]
        fn compiled<T: Task>(task: T) -> T::Done {
            task.call()
        }
        // SAFETY: `self` proves that the processor has AVX2.
        unsafe { compiled(task) }
    }

    /// Runs a computation in AVX2 registers.
    pub fn run<K: SimdKernel>(self, kernel: K) -> K::Done {
        struct InYmm<K>(K);
        impl<K: SimdKernel> Task for InYmm<K> {
            type Done = K::Done;

            #[inline(always)]
            fn call(self) -> K::Done {
                self.0.run::<Packed<Ymm, { LANES / 4 }>>()
            }
        }
        self.call(InYmm(kernel))
    }
}

/// Evaluates intrinsics.
macro_rules! instruction {
    ($operation:expr) => {
        // SAFETY: only processors with these instructions get here, as the documentation of the module explains.
        unsafe { $operation }
    };
}

impl Register for Zmm {
    type Flags = __mmask8;
    const WIDTH: usize = 8;
    const OUTLINED: bool = false;

    inlined! {
        all(value: f64) -> Zmm = Zmm(instruction!(_mm512_set1_pd(value)));
        add(a: Zmm, b: Zmm) -> Zmm = Zmm(instruction!(_mm512_add_pd(a.0, b.0)));
        sub(a: Zmm, b: Zmm) -> Zmm = Zmm(instruction!(_mm512_sub_pd(a.0, b.0)));
        mul(a: Zmm, b: Zmm) -> Zmm = Zmm(instruction!(_mm512_mul_pd(a.0, b.0)));
        div(a: Zmm, b: Zmm) -> Zmm = Zmm(instruction!(_mm512_div_pd(a.0, b.0)));
        neg(a: Zmm) -> Zmm = Zmm(instruction!({
            let signs = _mm512_set1_epi64(i64::MIN);
            _mm512_castsi512_pd(_mm512_xor_si512(_mm512_castpd_si512(a.0), signs))
        }));
        sqrt(a: Zmm) -> Zmm = Zmm(instruction!(_mm512_sqrt_pd(a.0)));
        abs(a: Zmm) -> Zmm = Zmm(instruction!(_mm512_abs_pd(a.0)));
        max(a: Zmm, b: Zmm) -> Zmm = Zmm(instruction!(_mm512_max_pd(a.0, b.0)));
        min(a: Zmm, b: Zmm) -> Zmm = Zmm(instruction!(_mm512_min_pd(a.0, b.0)));
        less(a: Zmm, b: Zmm) -> u8 = instruction!(_mm512_cmp_pd_mask::<_CMP_LT_OQ>(a.0, b.0));
        at_most(a: Zmm, b: Zmm) -> u8 = instruction!(_mm512_cmp_pd_mask::<_CMP_LE_OQ>(a.0, b.0));
        choose(flags: u8, yes: Zmm, no: Zmm) -> Zmm =
            Zmm(instruction!(_mm512_mask_blend_pd(flags, no.0, yes.0)));
        and(a: u8, b: u8) -> u8 = a & b;
        or(a: u8, b: u8) -> u8 = a | b;
        not(a: u8) -> u8 = !a;
        bits(a: u8) -> u8 = a;
        ldexp_one(shifted: Zmm) -> Zmm = Zmm(instruction!({
            let k = _mm512_slli_epi64::<FRACTION>(_mm512_castpd_si512(shifted.0));
            _mm512_castsi512_pd(_mm512_add_epi64(k, _mm512_set1_epi64(ONE_BITS)))
        }));
        approx_16th_root_of(a: Zmm, b: Zmm) -> Zmm = Zmm(instruction!({
            let logarithm = _mm512_sub_epi64(_mm512_castpd_si512(a.0), _mm512_castpd_si512(b.0));
            let root = _mm512_srai_epi64::<4>(logarithm);
            _mm512_castsi512_pd(_mm512_add_epi64(root, _mm512_set1_epi64(ONE_BITS)))
        }));
        frexp(x: Zmm) -> [Zmm; 2] = instruction!({
            let bits = _mm512_castpd_si512(x.0);
            let from_half = _mm512_sub_epi64(bits, _mm512_set1_epi64(SQRT_HALF));
            let exponent = _mm512_srai_epi64::<FRACTION>(from_half);
            let m = _mm512_sub_epi64(bits, _mm512_slli_epi64::<FRACTION>(exponent));
            let k = _mm512_add_epi64(exponent, _mm512_set1_epi64(ROUNDER_BITS));
            let k = _mm512_sub_pd(_mm512_castsi512_pd(k), _mm512_set1_pd(ROUNDER));
            [Zmm(k), Zmm(_mm512_castsi512_pd(m))]
        });
    }

    #[inline(always)]
    fn load(numbers: &[f64]) -> Zmm {
        let numbers = &numbers[..Self::WIDTH];
        // SAFETY: the slice has `WIDTH` numbers, and the processor has these registers, as above.
        Zmm(unsafe { _mm512_loadu_pd(numbers.as_ptr()) })
    }

    #[inline(always)]
    fn store(a: Zmm, numbers: &mut [f64]) {
        let numbers = &mut numbers[..Self::WIDTH];
        // SAFETY: the slice has `WIDTH` numbers, and the processor has these registers, as above.
        unsafe { _mm512_storeu_pd(numbers.as_mut_ptr(), a.0) }
    }
}

/// Flags are numbers with all bits set or none. AVX2 lacks an arithmetic right shift of 64-bit integers, which is done
/// by adding 2⁶³, a logical shift and a subtraction.
impl Register for Ymm {
    type Flags = __m256d;
    const WIDTH: usize = 4;
    const OUTLINED: bool = false;

    inlined! {
        all(value: f64) -> Ymm = Ymm(instruction!(_mm256_set1_pd(value)));
        add(a: Ymm, b: Ymm) -> Ymm = Ymm(instruction!(_mm256_add_pd(a.0, b.0)));
        sub(a: Ymm, b: Ymm) -> Ymm = Ymm(instruction!(_mm256_sub_pd(a.0, b.0)));
        mul(a: Ymm, b: Ymm) -> Ymm = Ymm(instruction!(_mm256_mul_pd(a.0, b.0)));
        div(a: Ymm, b: Ymm) -> Ymm = Ymm(instruction!(_mm256_div_pd(a.0, b.0)));
        neg(a: Ymm) -> Ymm = Ymm(instruction!(_mm256_xor_pd(a.0, _mm256_set1_pd(-0.0))));
        sqrt(a: Ymm) -> Ymm = Ymm(instruction!(_mm256_sqrt_pd(a.0)));
        abs(a: Ymm) -> Ymm = Ymm(instruction!(_mm256_andnot_pd(_mm256_set1_pd(-0.0), a.0)));
        max(a: Ymm, b: Ymm) -> Ymm = Ymm(instruction!(_mm256_max_pd(a.0, b.0)));
        min(a: Ymm, b: Ymm) -> Ymm = Ymm(instruction!(_mm256_min_pd(a.0, b.0)));
        less(a: Ymm, b: Ymm) -> __m256d = instruction!(_mm256_cmp_pd::<_CMP_LT_OQ>(a.0, b.0));
        at_most(a: Ymm, b: Ymm) -> __m256d = instruction!(_mm256_cmp_pd::<_CMP_LE_OQ>(a.0, b.0));
        // The blend intrinsic would defeat `opaque`, because compilers turn it back into a comparison. They
        // choose the blend instruction by themselves where the flags are not opaque.
        choose(flags: __m256d, yes: Ymm, no: Ymm) -> Ymm =
            Ymm(instruction!(_mm256_or_pd(_mm256_and_pd(flags, yes.0), _mm256_andnot_pd(flags, no.0))));
        and(a: __m256d, b: __m256d) -> __m256d = instruction!(_mm256_and_pd(a, b));
        or(a: __m256d, b: __m256d) -> __m256d = instruction!(_mm256_or_pd(a, b));
        not(a: __m256d) -> __m256d = instruction!(_mm256_xor_pd(a, _mm256_castsi256_pd(_mm256_set1_epi64x(-1))));
        opaque(a: __m256d) -> __m256d = black_box(a);
        bits(a: __m256d) -> u8 = instruction!(_mm256_movemask_pd(a)) as u8;
        ldexp_one(shifted: Ymm) -> Ymm = Ymm(instruction!({
            let k = _mm256_slli_epi64::<{ FRACTION as i32 }>(_mm256_castpd_si256(shifted.0));
            _mm256_castsi256_pd(_mm256_add_epi64(k, _mm256_set1_epi64x(ONE_BITS)))
        }));
        approx_16th_root_of(a: Ymm, b: Ymm) -> Ymm = Ymm(instruction!({
            let logarithm = _mm256_sub_epi64(_mm256_castpd_si256(a.0), _mm256_castpd_si256(b.0));
            let shifted = _mm256_srli_epi64::<4>(_mm256_xor_si256(logarithm, _mm256_set1_epi64x(i64::MIN)));
            let root = _mm256_sub_epi64(shifted, _mm256_set1_epi64x(1 << (63 - 4)));
            _mm256_castsi256_pd(_mm256_add_epi64(root, _mm256_set1_epi64x(ONE_BITS)))
        }));
        frexp(x: Ymm) -> [Ymm; 2] = instruction!({
            let bits = _mm256_castpd_si256(x.0);
            let from_half = _mm256_sub_epi64(bits, _mm256_set1_epi64x(SQRT_HALF));
            let shifted = _mm256_srli_epi64::<{ FRACTION as i32 }>(_mm256_xor_si256(from_half, _mm256_set1_epi64x(i64::MIN)));
            let exponent = _mm256_sub_epi64(shifted, _mm256_set1_epi64x(1 << (63 - FRACTION)));
            let m = _mm256_sub_epi64(bits, _mm256_slli_epi64::<{ FRACTION as i32 }>(exponent));
            let k = _mm256_add_epi64(exponent, _mm256_set1_epi64x(ROUNDER_BITS));
            let k = _mm256_sub_pd(_mm256_castsi256_pd(k), _mm256_set1_pd(ROUNDER));
            [Ymm(k), Ymm(_mm256_castsi256_pd(m))]
        });
    }

    #[inline(always)]
    fn load(numbers: &[f64]) -> Ymm {
        let numbers = &numbers[..Self::WIDTH];
        // SAFETY: the slice has `WIDTH` numbers, and the processor has these registers, as above.
        Ymm(unsafe { _mm256_loadu_pd(numbers.as_ptr()) })
    }

    #[inline(always)]
    fn store(a: Ymm, numbers: &mut [f64]) {
        let numbers = &mut numbers[..Self::WIDTH];
        // SAFETY: the slice has `WIDTH` numbers, and the processor has these registers, as above.
        unsafe { _mm256_storeu_pd(numbers.as_mut_ptr(), a.0) }
    }
}
