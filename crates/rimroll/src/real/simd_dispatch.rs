//! Computations that are compiled for the instructions of a processor, and the selection of its widest SIMD registers at
//! run time. The results do not depend on the width.

use super::lanes::Vector;
#[cfg(target_arch = "x86_64")]
use super::x86::{Avx2, Avx512};

/// A computation that is generic over the width of the registers.
pub(crate) trait SimdKernel {
    /// The result.
    type Done;

    /// Runs the computation. This function and every function that it calls with a vector must be
    /// `#[inline(always)]`.
    fn run<V: Vector>(self) -> Self::Done;
}

/// A computation in which compilers use the registers as they like.
pub(crate) trait Task {
    /// The result.
    type Done;

    /// Runs the computation. This function must be `#[inline(always)]`.
    fn call(self) -> Self::Done;
}

/// Runs a computation on any processor.
fn run_anywhere<K: SimdKernel>(kernel: K) -> K::Done {
    kernel.run::<super::lanes::Lanes>()
}

/// Runs a computation in the widest registers. A debug build contains only one width, which shortens its
/// compilation.
pub(crate) fn run_widest<K: SimdKernel>(kernel: K) -> K::Done {
    #[cfg(target_arch = "x86_64")]
    if !cfg!(debug_assertions) {
        if let Some(registers) = Avx512::detect() {
            return registers.run(kernel);
        }
        if let Some(registers) = Avx2::detect() {
            return registers.run(kernel);
        }
    }
    run_anywhere(kernel)
}

/// Runs a computation that is compiled for AVX2 where the processor has it.
pub(crate) fn call_vectorized<T: Task>(task: T) -> T::Done {
    #[cfg(target_arch = "x86_64")]
    if let Some(avx2) = Avx2::detect() {
        return avx2.call(task);
    }
    task.call()
}

/// The results in registers of every width that the processor has.
#[cfg(test)]
pub(crate) fn in_every_width<K: SimdKernel>(kernel: impl Fn() -> K) -> Vec<K::Done> {
    let mut done = vec![run_anywhere(kernel())];
    #[cfg(target_arch = "x86_64")]
    {
        done.extend(Avx2::detect().map(|registers| registers.run(kernel())));
        done.extend(Avx512::detect().map(|registers| registers.run(kernel())));
    }
    done
}
