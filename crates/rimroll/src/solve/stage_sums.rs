//! The weighted sums of stages, which are most of the work of a step, in scalar or in SIMD registers.
//!
//! Each component goes through the same operations in the same order in both, so the results are the same
//! to the last bit.

use crate::real::Real;

/// The operations on state vectors that differ between kinds of registers.
pub(super) trait StageSums<T, const N: usize>: Copy {
    /// sum += weight · stage, for the components that are not ignorable.
    fn add(self, sum: &mut [T; N], weight: T, stage: &[T; N]);

    /// sum += weight · stage, for the ignorable components.
    fn add_ignorable(self, sum: &mut [T; N], weight: T, stage: &[T; N]);

    /// Stores newly computed rates so that they can be loaded again without delay.
    fn store_rates(self, place: &mut [T; N], rates: &[T; N]);
}

/// Scalar operations, for any number type on any processor.
#[derive(Clone, Copy)]
pub(super) struct ScalarSums {
    /// The number of leading ignorable components.
    pub ignorable: usize,
}

impl<T: Real, const N: usize> StageSums<T, N> for ScalarSums {
    #[inline(always)]
    fn add(self, sum: &mut [T; N], weight: T, stage: &[T; N]) {
        for i in self.ignorable..N {
            sum[i] = sum[i] + weight * stage[i];
        }
    }

    #[inline(always)]
    fn add_ignorable(self, sum: &mut [T; N], weight: T, stage: &[T; N]) {
        for i in 0..self.ignorable {
            sum[i] = sum[i] + weight * stage[i];
        }
    }

    #[inline(always)]
    fn store_rates(self, place: &mut [T; N], rates: &[T; N]) {
        *place = *rates;
    }
}

#[cfg(target_arch = "x86_64")]
pub(super) use wide::AvxSums;

#[cfg(target_arch = "x86_64")]
mod wide {
    use super::{ScalarSums, StageSums};
    use crate::real::Avx2;
    use core::arch::x86_64::{
        _mm_add_pd, _mm_loadu_pd, _mm_mul_pd, _mm_set_pd, _mm_set1_pd, _mm_storeu_pd,
        _mm256_add_pd, _mm256_loadu_pd, _mm256_mul_pd, _mm256_set_pd, _mm256_set1_pd,
        _mm256_storeu_pd,
    };

    /// AVX operations: the first four components after the ignorable ones in pairs, the others in fours.
    ///
    /// Combining four scalars into one register takes longer than combining two, and the components on which
    /// the rates depend most come first. Compilers store the rates one by one, and a wide load of them has
    /// to wait until all these stores have reached memory.
    #[derive(Clone, Copy)]
    pub struct AvxSums {
        ignorable: usize,
        _proof: Avx2,
    }

    impl AvxSums {
        /// The operations for a state with `ignorable` leading ignorable components. A processor with AVX2 has AVX.
        pub fn new(proof: Avx2, ignorable: usize) -> Self {
            AvxSums {
                ignorable,
                _proof: proof,
            }
        }
    }

    /// The number of components that are taken in pairs.
    const IN_PAIRS: usize = 4;

    impl<const N: usize> StageSums<f64, N> for AvxSums {
        #[inline(always)]
        fn add(self, sum: &mut [f64; N], weight: f64, stage: &[f64; N]) {
            let (sum, stage) = (&mut sum[self.ignorable..], &stage[self.ignorable..]);
            let (sum_pairs, sum) = sum.split_at_mut(IN_PAIRS.min(sum.len()));
            let (stage_pairs, stage) = stage.split_at(sum_pairs.len());
            let (sum_pairs, sum_odd) = sum_pairs.as_chunks_mut::<2>();
            let (stage_pairs, stage_odd) = stage_pairs.as_chunks::<2>();
            for (sum, stage) in sum_pairs.iter_mut().zip(stage_pairs) {
                // SAFETY: the chunks have two numbers, and every x86-64 processor has SSE2.
                unsafe {
                    let stage = _mm_loadu_pd(stage.as_ptr());
                    let part = _mm_mul_pd(_mm_set1_pd(weight), stage);
                    _mm_storeu_pd(
                        sum.as_mut_ptr(),
                        _mm_add_pd(_mm_loadu_pd(sum.as_ptr()), part),
                    );
                }
            }
            let (sum_fours, sum) = sum.as_chunks_mut::<4>();
            let (stage_fours, stage) = stage.as_chunks::<4>();
            for (sum, stage) in sum_fours.iter_mut().zip(stage_fours) {
                // SAFETY: the chunks have four numbers, and a value of `AvxSums` exists only where the processor has AVX.
                unsafe {
                    let stage = _mm256_loadu_pd(stage.as_ptr());
                    let part = _mm256_mul_pd(_mm256_set1_pd(weight), stage);
                    let more = _mm256_add_pd(_mm256_loadu_pd(sum.as_ptr()), part);
                    _mm256_storeu_pd(sum.as_mut_ptr(), more);
                }
            }
            let odd = sum_odd.iter_mut().zip(stage_odd);
            for (sum, stage) in odd.chain(sum.iter_mut().zip(stage)) {
                *sum += weight * stage;
            }
        }

        #[inline(always)]
        fn add_ignorable(self, sum: &mut [f64; N], weight: f64, stage: &[f64; N]) {
            let ignorable = self.ignorable;
            ScalarSums { ignorable }.add_ignorable(sum, weight, stage);
        }

        #[inline(always)]
        fn store_rates(self, place: &mut [f64; N], rates: &[f64; N]) {
            let (ignorable, place) = place.split_at_mut(self.ignorable);
            let (rates_ignorable, rates) = rates.split_at(self.ignorable);
            ignorable.copy_from_slice(rates_ignorable);
            let (pairs, place) = place.split_at_mut(IN_PAIRS.min(place.len()));
            let (rates_pairs, rates) = rates.split_at(pairs.len());
            let (pairs, odd) = pairs.as_chunks_mut::<2>();
            let (rates_pairs, rates_odd) = rates_pairs.as_chunks::<2>();
            for (place, &[a, b]) in pairs.iter_mut().zip(rates_pairs) {
                // SAFETY: as above.
                unsafe { _mm_storeu_pd(place.as_mut_ptr(), _mm_set_pd(b, a)) };
            }
            let (fours, place) = place.as_chunks_mut::<4>();
            let (rates_fours, rates) = rates.as_chunks::<4>();
            for (place, &[a, b, c, d]) in fours.iter_mut().zip(rates_fours) {
                // SAFETY: as above.
                unsafe { _mm256_storeu_pd(place.as_mut_ptr(), _mm256_set_pd(d, c, b, a)) };
            }
            odd.copy_from_slice(rates_odd);
            place.copy_from_slice(rates);
        }
    }
}
