//! What a step does most: sums of weighted stages, one number after another or four at a time.
//!
//! Each number goes through the same operations in the same order either way, so the results are the
//! same to the last bit.

use crate::real::Real;

/// A way of calculating with the components of a state that are felt, all but the first few.
pub(super) trait Registers<T, const N: usize>: Copy {
    /// sum + weight · stage.
    fn add(self, sum: &mut [T; N], weight: T, stage: &[T; N]);

    /// The same for the others.
    fn add_ignorable(self, sum: &mut [T; N], weight: T, stage: &[T; N]);

    /// Puts freshly computed rates where they can be taken up again at once.
    fn keep(self, place: &mut [T; N], rates: &[T; N]);
}

/// One after another: whatever the number, whatever the processor.
#[derive(Clone, Copy)]
pub(super) struct OneByOne {
    /// How many components, the first, are not felt.
    pub ignorable: usize,
}

impl<T: Real, const N: usize> Registers<T, N> for OneByOne {
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
    fn keep(self, place: &mut [T; N], rates: &[T; N]) {
        *place = *rates;
    }
}

#[cfg(target_arch = "x86_64")]
pub(super) use wide::Wide;

#[cfg(target_arch = "x86_64")]
mod wide {
    use super::{OneByOne, Registers};
    use core::arch::x86_64::{
        _mm_add_pd, _mm_loadu_pd, _mm_mul_pd, _mm_set_pd, _mm_set1_pd, _mm_storeu_pd,
        _mm256_add_pd, _mm256_loadu_pd, _mm256_mul_pd, _mm256_set_pd, _mm256_set1_pd,
        _mm256_storeu_pd,
    };

    /// The first four that are felt two by two, since a processor takes longer to put four together, and
    /// what is felt most comes first; the others four by four.
    ///
    /// A compiler left to itself stores rates one by one, and they cannot be loaded together before they
    /// have all arrived in memory.
    #[derive(Clone, Copy)]
    pub struct Wide {
        ignorable: usize,
    }

    impl Wide {
        /// With the first `ignorable` components not felt.
        ///
        /// # Safety
        /// The processor must have AVX.
        pub unsafe fn new(ignorable: usize) -> Self {
            Wide { ignorable }
        }
    }

    /// How many are taken two by two.
    const IN_PAIRS: usize = 4;

    impl<const N: usize> Registers<f64, N> for Wide {
        #[inline(always)]
        fn add(self, sum: &mut [f64; N], weight: f64, stage: &[f64; N]) {
            let (sum, stage) = (&mut sum[self.ignorable..], &stage[self.ignorable..]);
            let (sum_pairs, sum) = sum.split_at_mut(IN_PAIRS.min(sum.len()));
            let (stage_pairs, stage) = stage.split_at(sum_pairs.len());
            let (sum_pairs, sum_odd) = sum_pairs.as_chunks_mut::<2>();
            let (stage_pairs, stage_odd) = stage_pairs.as_chunks::<2>();
            for (sum, stage) in sum_pairs.iter_mut().zip(stage_pairs) {
                // SAFETY: there are two numbers, and every processor of this kind can do this.
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
                // SAFETY: there are four numbers, and the processor has AVX, or this would not be here.
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
            OneByOne { ignorable }.add_ignorable(sum, weight, stage);
        }

        #[inline(always)]
        fn keep(self, place: &mut [f64; N], rates: &[f64; N]) {
            let (ignorable, place) = place.split_at_mut(self.ignorable);
            let (rates_unfelt, rates) = rates.split_at(self.ignorable);
            ignorable.copy_from_slice(rates_unfelt);
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
