//! What is done in the widest registers that the processor has, with the same bits as in any others.

use super::lanes::Vector;
#[cfg(target_arch = "x86_64")]
use super::x86;
#[cfg(target_arch = "x86_64")]
use std::arch::is_x86_feature_detected;

/// Lanes in registers that every processor of the kind has.
#[cfg(target_arch = "x86_64")]
type AnyProcessor = x86::Sse2;
#[cfg(not(target_arch = "x86_64"))]
type AnyProcessor = super::lanes::Lanes;

/// Something to do with lanes in some registers.
pub(crate) trait SimdKernel {
    /// What comes of it.
    type Done;

    /// Does it: `#[inline(always)]`, as all that it calls with a vector.
    fn run<V: Vector>(self) -> Self::Done;
}

/// Does it in the widest registers. A debug build, which is to be made soon and not to be fast, is compiled for one kind
/// only.
pub(crate) fn run_widest<T: SimdKernel>(task: T) -> T::Done {
    #[cfg(target_arch = "x86_64")]
    if !cfg!(debug_assertions) {
        if is_x86_feature_detected!("avx512f") {
            // SAFETY: the processor has been asked.
            return unsafe { x86::in_avx512(task) };
        }
        if is_x86_feature_detected!("avx2") {
            // SAFETY: the processor has been asked.
            return unsafe { x86::in_avx2(task) };
        }
    }
    task.run::<AnyProcessor>()
}

/// What comes of it in registers of every width that the processor has.
#[cfg(test)]
pub(crate) fn in_every_width<T: SimdKernel>(task: impl Fn() -> T) -> Vec<T::Done> {
    let mut done = vec![task().run::<AnyProcessor>()];
    #[cfg(target_arch = "x86_64")]
    {
        if is_x86_feature_detected!("avx2") {
            // SAFETY: the processor has been asked.
            done.push(unsafe { x86::in_avx2(task()) });
        }
        if is_x86_feature_detected!("avx512f") {
            // SAFETY: the processor has been asked.
            done.push(unsafe { x86::in_avx512(task()) });
        }
    }
    done
}
