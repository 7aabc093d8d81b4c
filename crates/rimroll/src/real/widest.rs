//! Selection of the widest SIMD registers of the processor at run time. The results do not depend on the width.

use super::lanes::Vector;
#[cfg(target_arch = "x86_64")]
use super::x86;
#[cfg(target_arch = "x86_64")]
use std::arch::is_x86_feature_detected;

/// Lanes in registers that every processor of the architecture has.
#[cfg(target_arch = "x86_64")]
type AnyProcessor = x86::Sse2;
#[cfg(not(target_arch = "x86_64"))]
type AnyProcessor = super::lanes::Lanes;

/// A computation that is generic over the width of the registers.
pub(crate) trait SimdKernel {
    /// The result.
    type Done;

    /// Runs the computation. This function and every function that it calls with a vector must be
    /// `#[inline(always)]`.
    fn run<V: Vector>(self) -> Self::Done;
}

/// Runs a computation in AVX-512 registers.
///
/// # Safety
/// The processor must have AVX-512F.
#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f")]
unsafe fn in_avx512<T: SimdKernel>(kernel: T) -> T::Done {
    kernel.run::<x86::Avx512>()
}

/// Runs a computation in AVX2 registers.
///
/// # Safety
/// The processor must have AVX2.
#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
unsafe fn in_avx2<T: SimdKernel>(kernel: T) -> T::Done {
    kernel.run::<x86::Avx2>()
}

/// Runs a computation in the widest registers. A debug build contains only one width, which shortens its
/// compilation.
pub(crate) fn run_widest<T: SimdKernel>(kernel: T) -> T::Done {
    #[cfg(target_arch = "x86_64")]
    if !cfg!(debug_assertions) {
        if is_x86_feature_detected!("avx512f") {
            // SAFETY: the processor has AVX-512F.
            return unsafe { in_avx512(kernel) };
        }
        if is_x86_feature_detected!("avx2") {
            // SAFETY: the processor has AVX2.
            return unsafe { in_avx2(kernel) };
        }
    }
    kernel.run::<AnyProcessor>()
}

/// The results in registers of every width that the processor has.
#[cfg(test)]
pub(crate) fn in_every_width<T: SimdKernel>(kernel: impl Fn() -> T) -> Vec<T::Done> {
    let mut done = vec![kernel().run::<AnyProcessor>()];
    #[cfg(target_arch = "x86_64")]
    {
        if is_x86_feature_detected!("avx2") {
            // SAFETY: the processor has AVX2.
            done.push(unsafe { in_avx2(kernel()) });
        }
        if is_x86_feature_detected!("avx512f") {
            // SAFETY: the processor has AVX-512F.
            done.push(unsafe { in_avx512(kernel()) });
        }
    }
    done
}
