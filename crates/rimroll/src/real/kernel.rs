//! Computations that are compiled for the instructions of a processor.

use super::lanes::Vector;

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
