//! One step of the explicit Runge-Kutta method of order 8 by Dormand and Prince, with an error
//! estimate of orders 5 and 3 and dense output of order 7 (DOP853).
//!
//! Source: Hairer, Nørsett & Wanner, *Solving Ordinary Differential Equations I*, sections II.5,
//! II.6 and II.10. The method suits smooth systems at tolerances from 1e-5 down to rounding.

#[cfg(target_arch = "x86_64")]
use super::stage_sums::AvxSums;
use super::stage_sums::{ScalarSums, StageSums};
use super::tableau::{DENSE, ERROR_3, ERROR_5, EXTRA_STAGES, Row, SOLUTION, STAGES};
use super::{Dense, ErrorEstimate, System};
#[cfg(target_arch = "x86_64")]
use crate::real::Avx2;
use crate::real::{Real, Task, call_vectorized};

/// A finished step from `start` to `end`.
#[derive(Debug, Clone)]
pub struct Step<T, const N: usize> {
    /// The step size.
    pub h: T,
    /// State at the start.
    pub start: [T; N],
    /// State at the end.
    pub end: [T; N],
    /// The stages: 12 of the step, the rates at its end, 3 for the dense output.
    stages: [[T; N]; 16],
}

/// Σ weight · stage, summed in the order of the row.
#[inline(always)]
fn weighted_sum<T: Real, const N: usize>(
    with: impl StageSums<T, N>,
    row: Row,
    stages: &[[T; N]; 16],
) -> [T; N] {
    let mut sum = [T::from(0.0); N];
    for &(stage, weight) in row {
        with.add(&mut sum, T::from(weight), &stages[stage]);
        with.add_ignorable(&mut sum, T::from(weight), &stages[stage]);
    }
    sum
}

/// u + h Σ weight · stage, the argument of the next stage, without its ignorable components. The newest
/// stage is added last, so that the processor can do the rest while that stage is being computed.
#[inline(always)]
fn stage_argument<T: Real, const N: usize>(
    with: impl StageSums<T, N>,
    u: &[T; N],
    h: T,
    row: Row,
    stages: &[[T; N]; 16],
) -> [T; N] {
    let mut argument = *u;
    if let [earlier @ .., (newest, weight)] = row {
        if !earlier.is_empty() {
            let mut sum = [T::from(0.0); N];
            for &(stage, weight) in earlier {
                with.add(&mut sum, T::from(weight), &stages[stage]);
            }
            with.add(&mut argument, h, &sum);
        }
        with.add(&mut argument, h * T::from(*weight), &stages[*newest]);
    }
    argument
}

impl<T: Real, const N: usize> Step<T, N> {
    /// Evaluations of the right-hand side per step, given the rates at its start.
    pub const EVALUATIONS: usize = 12;

    /// A step of size h from `start`, with AVX2 instructions where the processor has them.
    pub fn take<S: System<T, N>>(system: &S, start: &[T; N], h: T) -> Self {
        struct Take<'a, S, T, const N: usize>(&'a S, &'a [T; N], T);
        impl<S: System<T, N>, T: Real, const N: usize> Task for Take<'_, S, T, N> {
            type Done = Step<T, N>;

            #[inline(always)]
            fn call(self) -> Step<T, N> {
                Step::take_anywhere(self.0, self.1, self.2)
            }
        }
        call_vectorized(Take(system, start, h))
    }

    #[inline(always)]
    fn take_anywhere<S: System<T, N>>(system: &S, start: &[T; N], h: T) -> Self {
        let with = ScalarSums {
            ignorable: S::IGNORABLE,
        };
        let mut step = Step::empty(start, &system.rates(start));
        // Not unrolled: dual numbers gain nothing from it, and it takes far longer to compile.
        for (i, row) in STAGES.iter().enumerate() {
            let argument = stage_argument(with, start, h, row, &step.stages);
            step.stages[i + 1] = system.rates(&argument);
        }
        step.finish(with, system, h);
        step
    }

    /// A step of size zero, before the first step.
    pub fn empty(start: &[T; N], rates: &[T; N]) -> Self {
        let mut stages = [[T::from(0.0); N]; 16];
        stages[0] = *rates;
        stages[12] = *rates;
        Step {
            h: T::from(0.0),
            start: *start,
            end: *start,
            stages,
        }
    }

    /// Starts the next step at the end of this one.
    #[inline(always)]
    pub fn begin_next(&mut self) {
        self.start = self.end;
        self.stages[0] = self.stages[12];
    }

    /// Computes the step of size h from `start` and overwrites an earlier attempt. Returns the argument of
    /// the twelfth stage, an approximation of the end of lower order that is known earlier. Its ignorable
    /// components have their values at the start.
    #[inline(always)]
    fn compute<S: System<T, N>>(&mut self, with: impl StageSums<T, N>, system: &S, h: T) -> [T; N] {
        let (start, stages) = (&self.start, &mut self.stages);
        let mut argument;
        // Unrolled, so that the weights are compile-time constants.
        macro_rules! stages {
            ($($i:literal)*) => {$(
                argument = stage_argument(with, start, h, STAGES[$i], stages);
                with.store_rates(&mut stages[$i + 1], &system.rates(&argument));
            )*};
        }
        stages!(0 1 2 3 4 5 6 7 8 9 10);
        self.finish(with, system, h);
        argument
    }

    /// Computes the end of a step of size h from its stages, and the rates there.
    #[inline(always)]
    fn finish<S: System<T, N>>(&mut self, with: impl StageSums<T, N>, system: &S, h: T) {
        self.h = h;
        let sum = weighted_sum(with, SOLUTION, &self.stages);
        self.end = self.start;
        with.add(&mut self.end, h, &sum);
        with.add_ignorable(&mut self.end, h, &sum);
        with.store_rates(&mut self.stages[12], &system.rates(&self.end));
    }

    /// Rates at the start.
    pub fn start_rates(&self) -> &[T; N] {
        &self.stages[0]
    }

    /// Rates at the end: the first stage of the next step.
    pub fn end_rates(&self) -> &[T; N] {
        &self.stages[12]
    }

    /// The errors of all components, as the formulas of orders 5 and 3 estimate them.
    pub fn errors(&self) -> [[T; N]; 2] {
        let with = ScalarSums { ignorable: 0 };
        [ERROR_5, ERROR_3].map(|row| weighted_sum(with, row, &self.stages).map(|v| self.h * v))
    }

    /// The error estimate, with the larger of the error scales at both ends. The scales at the end are those
    /// at the twelfth stage, so that they are available before the last rates.
    #[inline(always)]
    fn estimate<S: System<T, N>>(
        &self,
        with: impl StageSums<T, N>,
        system: &S,
        before_end: &[T; N],
        tolerance: f64,
    ) -> ErrorEstimate<T> {
        let at_start = system.scale(&self.start);
        let at_end = system.scale(before_end);
        let fifth = weighted_sum(with, ERROR_5, &self.stages);
        let third = weighted_sum(with, ERROR_3, &self.stages);
        let [mut fifths, mut thirds] = [[T::from(0.0); 4]; 2];
        for i in 0..N {
            let allowed = T::from(1.0) / (T::from(tolerance) * at_start[i].max(at_end[i]));
            let (fifth, third) = (fifth[i] * allowed, third[i] * allowed);
            fifths[i % 4] = fifths[i % 4] + fifth * fifth;
            thirds[i % 4] = thirds[i % 4] + third * third;
        }
        let [fifth, third] = [fifths, thirds].map(|[a, b, c, d]| (a + b) + (c + d));
        ErrorEstimate::new(self.h, fifth, third, N)
    }

    #[inline(always)]
    fn polynomial<S: System<T, N>>(
        &mut self,
        with: impl StageSums<T, N>,
        system: &S,
    ) -> Dense<T, N> {
        for (i, row) in EXTRA_STAGES.iter().enumerate() {
            let argument = stage_argument(with, &self.start, self.h, row, &self.stages);
            self.stages[13 + i] = system.rates(&argument);
        }
        let h = self.h;
        let increment: [T; N] = core::array::from_fn(|i| self.end[i] - self.start[i]);
        let first = self.stages[0].map(|rate| h * rate);
        let last = self.stages[12].map(|rate| h * rate);
        let mut coefficients = [increment; 7];
        coefficients[1] = core::array::from_fn(|i| first[i] - increment[i]);
        coefficients[2] =
            core::array::from_fn(|i| T::from(2.0) * increment[i] - (first[i] + last[i]));
        for (coefficient, row) in coefficients[3..].iter_mut().zip(&DENSE) {
            *coefficient = weighted_sum(with, row, &self.stages).map(|v| h * v);
        }
        Dense {
            h,
            start: self.start,
            end: self.end,
            coefficients,
        }
    }
}

/// A computation that is generic over the kind of registers.
trait Kernel<const N: usize> {
    type Output;

    /// The number of leading ignorable components, known at compile time.
    const IGNORABLE: usize;

    fn with(self, registers: impl StageSums<f64, N>) -> Self::Output;
}

/// Runs the kernel in AVX registers where the processor has AVX2. The results are the same to the last bit.
#[inline(always)]
fn in_registers<const N: usize, K: Kernel<N>>(kernel: K) -> K::Output {
    #[cfg(target_arch = "x86_64")]
    if let Some(proof) = Avx2::detect() {
        return proof.call(InAvx(kernel, proof));
    }
    kernel.with(ScalarSums {
        ignorable: K::IGNORABLE,
    })
}

/// A kernel that runs in AVX registers.
#[cfg(target_arch = "x86_64")]
struct InAvx<K, const N: usize>(K, Avx2);

#[cfg(target_arch = "x86_64")]
impl<K: Kernel<N>, const N: usize> Task for InAvx<K, N> {
    type Done = K::Output;

    #[inline(always)]
    fn call(self) -> K::Output {
        self.0.with(AvxSums::new(self.1, K::IGNORABLE))
    }
}

impl<const N: usize> Step<f64, N> {
    /// A step of size h from `start`, the same as [`Step::take`] but in explicitly addressed registers.
    pub fn recompute<S: System<f64, N>>(system: &S, start: &[f64; N], h: f64) -> Self {
        struct Compute<'a, S, const N: usize>(&'a mut Step<f64, N>, &'a S, f64);
        impl<S: System<f64, N>, const N: usize> Kernel<N> for Compute<'_, S, N> {
            type Output = ();
            const IGNORABLE: usize = S::IGNORABLE;

            #[inline(always)]
            fn with(self, registers: impl StageSums<f64, N>) {
                self.0.compute(registers, self.1, self.2);
            }
        }
        let mut step = Step::empty(start, &system.rates(start));
        in_registers(Compute(&mut step, system, h));
        step
    }

    /// Computes the step of size h from `start`, overwrites an earlier attempt, and estimates the error.
    pub fn attempt<S: System<f64, N>>(
        &mut self,
        system: &S,
        h: f64,
        tolerance: f64,
    ) -> ErrorEstimate<f64> {
        struct Attempt<'a, S, const N: usize>(&'a mut Step<f64, N>, &'a S, f64, f64);
        impl<S: System<f64, N>, const N: usize> Kernel<N> for Attempt<'_, S, N> {
            type Output = ErrorEstimate<f64>;
            const IGNORABLE: usize = S::IGNORABLE;

            #[inline(always)]
            fn with(self, registers: impl StageSums<f64, N>) -> ErrorEstimate<f64> {
                let Attempt(step, system, h, tolerance) = self;
                let before_end = step.compute(registers, system, h);
                step.estimate(registers, system, &before_end, tolerance)
            }
        }
        in_registers(Attempt(self, system, h, tolerance))
    }

    /// The dense output, which costs three more evaluations of the right-hand side.
    pub fn dense<S: System<f64, N>>(&mut self, system: &S) -> Dense<f64, N> {
        struct Polynomial<'a, S, const N: usize>(&'a mut Step<f64, N>, &'a S);
        impl<S: System<f64, N>, const N: usize> Kernel<N> for Polynomial<'_, S, N> {
            type Output = Dense<f64, N>;
            const IGNORABLE: usize = S::IGNORABLE;

            #[inline(always)]
            fn with(self, registers: impl StageSums<f64, N>) -> Dense<f64, N> {
                self.0.polynomial(registers, self.1)
            }
        }
        in_registers(Polynomial(self, system))
    }
}

#[cfg(test)]
mod tests {
    use super::{ScalarSums, Step, System};

    /// A chain of `N` − 2 coupled oscillators with two ignorable components.
    struct Chain<const N: usize>;

    impl<const N: usize> System<f64, N> for Chain<N> {
        const IGNORABLE: usize = 2;

        fn rates(&self, u: &[f64; N]) -> [f64; N] {
            let (chain, m) = (&u[2..], N - 2);
            let coupled = |i: usize| chain[(i + 1) % m] * chain[i] - 0.7 * chain[(i + m - 1) % m];
            core::array::from_fn(|i| match i {
                0 => chain.iter().sum(),
                1 => chain[0] * chain[m - 1],
                _ => coupled(i - 2),
            })
        }

        fn scale(&self, u: &[f64; N]) -> [f64; N] {
            u.map(|value| 1.0 + value.abs())
        }
    }

    /// 1, 3, 8, 11 and 15 components that are not ignorable cover none, one and several registers of each
    /// width, with and without a remainder.
    #[test]
    fn the_width_of_the_registers_changes_no_bit() {
        compare::<3>();
        compare::<5>();
        compare::<10>();
        compare::<13>();
        compare::<17>();
    }

    fn compare<const N: usize>() {
        let chain = Chain::<N>;
        let start: [f64; N] =
            core::array::from_fn(|i| 0.3 + 0.1 * i as f64 - 0.02 * (i * i) as f64);
        let ignorable = ScalarSums {
            ignorable: Chain::<N>::IGNORABLE,
        };
        for h in [1e-3, 0.07, 0.3] {
            let mut wide = Step::recompute(&chain, &start, h);
            let mut plain = Step::empty(&start, &chain.rates(&start));
            let before_end = plain.compute(ignorable, &chain, h);
            assert_eq!(wide.stages, plain.stages);
            assert_eq!(wide.end, plain.end);
            let wide_error = wide.attempt(&chain, h, 1e-9);
            let plain_error = plain.estimate(ignorable, &chain, &before_end, 1e-9);
            assert_eq!(wide_error.allowed, plain_error.allowed);
            assert_eq!(wide_error.error_squared, plain_error.error_squared);
            let (wide, plain) = (wide.dense(&chain), plain.polynomial(ignorable, &chain));
            assert_eq!(wide.at(0.3), plain.at(0.3));
        }
    }
}
