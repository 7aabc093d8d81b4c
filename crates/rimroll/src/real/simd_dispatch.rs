//! Selection of the widest SIMD registers of the processor at run time. The results do not depend on the width.

use super::kernel::{SimdKernel, Task};
#[cfg(target_arch = "x86_64")]
use super::x86::{Avx2, Avx512};

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
