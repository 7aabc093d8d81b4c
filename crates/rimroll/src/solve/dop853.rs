//! One step of the explicit Runge-Kutta method of order 8 by Dormand and Prince, with an error
//! estimate of orders 5 and 3 and dense output of order 7 (DOP853).
//!
//! Source: Hairer, Nørsett & Wanner, *Solving Ordinary Differential Equations I*, sections II.5,
//! II.6 and II.10. Use it for smooth systems at tolerances from 1e-5 down to rounding.

use super::registers::{OneByOne, Registers};
use super::tableau::{DENSE, ERROR_3, ERROR_5, EXTRA_STAGES, Row, SOLUTION, STAGES};
use super::{Dense, Estimate, System};
use crate::real::Real;

/// A finished step from `start` to `end`.
#[derive(Debug, Clone)]
pub struct Step<T, const N: usize> {
    /// The step's length.
    pub h: T,
    /// State at the start.
    pub start: [T; N],
    /// State at the end.
    pub end: [T; N],
    /// The stages: 12 of the step, the slope at its end, 3 for the dense output.
    stages: [[T; N]; 16],
}

/// Σ weight · stage, summed in the order of the row.
#[inline(always)]
fn weigh<T: Real, const N: usize>(
    with: impl Registers<T, N>,
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

/// u + h Σ weight · stage where the rates are to be asked next, so without the components that they do
/// not feel. The last of the stages has only just been computed: all else is done before it comes in.
#[inline(always)]
fn ahead<T: Real, const N: usize>(
    with: impl Registers<T, N>,
    u: &[T; N],
    h: T,
    row: Row,
    stages: &[[T; N]; 16],
) -> [T; N] {
    let mut at = *u;
    if let [known @ .., (last, weight)] = row {
        if !known.is_empty() {
            let mut sum = [T::from(0.0); N];
            for &(stage, weight) in known {
                with.add(&mut sum, T::from(weight), &stages[stage]);
            }
            with.add(&mut at, h, &sum);
        }
        with.add(&mut at, h * T::from(*weight), &stages[*last]);
    }
    at
}

impl<T: Real, const N: usize> Step<T, N> {
    /// Evaluations of the right-hand side that a step costs, given the rates at its start.
    pub const EVALUATIONS: usize = 12;

    /// A step of length h from `start`, compiled for wide registers where the processor has them.
    pub fn take<S: System<T, N>>(system: &S, start: &[T; N], h: T) -> Self {
        #[cfg(target_arch = "x86_64")]
        {
            #[target_feature(enable = "avx2")]
            unsafe fn wide<T: Real, S: System<T, N>, const N: usize>(
                system: &S,
                start: &[T; N],
                h: T,
            ) -> Step<T, N> {
                Step::take_anywhere(system, start, h)
            }
            if std::arch::is_x86_feature_detected!("avx2") {
                // SAFETY: the processor has what is asked for.
                return unsafe { wide(system, start, h) };
            }
        }
        Step::take_anywhere(system, start, h)
    }

    #[inline(always)]
    fn take_anywhere<S: System<T, N>>(system: &S, start: &[T; N], h: T) -> Self {
        let mut step = Step::still(start, &system.rates(start));
        step.go(
            OneByOne {
                ignorable: S::IGNORABLE,
            },
            system,
            h,
        );
        step
    }

    /// A step of no length, to begin from.
    pub fn still(start: &[T; N], rates: &[T; N]) -> Self {
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

    /// Begins the next step where this one has ended.
    #[inline(always)]
    pub fn begin_next(&mut self) {
        self.start = self.end;
        self.stages[0] = self.stages[12];
    }

    /// Goes from the start by the length h, whatever the step was before. Gives the point of the twelfth
    /// stage: the end, but of a lower order and known earlier; what is not felt is as it was at the start.
    #[inline(always)]
    fn go<S: System<T, N>>(&mut self, with: impl Registers<T, N>, system: &S, h: T) -> [T; N] {
        let (start, stages) = (&self.start, &mut self.stages);
        let mut at;
        // Written out, so that the weights are constants of the code.
        macro_rules! stages {
            ($($i:literal)*) => {$(
                at = ahead(with, start, h, STAGES[$i], stages);
                with.keep(&mut stages[$i + 1], &system.rates(&at));
            )*};
        }
        stages!(0 1 2 3 4 5 6 7 8 9 10);
        self.h = h;
        let sum = weigh(with, SOLUTION, stages);
        self.end = *start;
        with.add(&mut self.end, h, &sum);
        with.add_ignorable(&mut self.end, h, &sum);
        with.keep(&mut stages[12], &system.rates(&self.end));
        at
    }

    /// Rates at the start.
    pub fn start_rates(&self) -> &[T; N] {
        &self.stages[0]
    }

    /// Rates at the end: the first stage of the next step.
    pub fn end_rates(&self) -> &[T; N] {
        &self.stages[12]
    }

    /// The error, by the sizes at both ends: at the end those of the twelfth stage, so that they are at
    /// hand when the last rates come in.
    #[inline(always)]
    fn estimate<S: System<T, N>>(
        &self,
        with: impl Registers<T, N>,
        system: &S,
        before_end: &[T; N],
        tolerance: f64,
    ) -> Estimate<T> {
        let at_start = system.scale(&self.start);
        let at_end = system.scale(before_end);
        let fifth = weigh(with, ERROR_5, &self.stages);
        let third = weigh(with, ERROR_3, &self.stages);
        let [mut fifths, mut thirds] = [[T::from(0.0); 4]; 2];
        for i in 0..N {
            let allowed = T::from(1.0) / (T::from(tolerance) * at_start[i].max(at_end[i]));
            let (fifth, third) = (fifth[i] * allowed, third[i] * allowed);
            fifths[i % 4] = fifths[i % 4] + fifth * fifth;
            thirds[i % 4] = thirds[i % 4] + third * third;
        }
        let [fifth, third] = [fifths, thirds].map(|[a, b, c, d]| (a + b) + (c + d));
        Estimate::new(self.h, fifth, third, N)
    }

    #[inline(always)]
    fn polynomial<S: System<T, N>>(
        &mut self,
        with: impl Registers<T, N>,
        system: &S,
    ) -> Dense<T, N> {
        for (i, row) in EXTRA_STAGES.iter().enumerate() {
            let at = ahead(with, &self.start, self.h, row, &self.stages);
            self.stages[13 + i] = system.rates(&at);
        }
        let h = self.h;
        let rise: [T; N] = core::array::from_fn(|i| self.end[i] - self.start[i]);
        let first = self.stages[0].map(|rate| h * rate);
        let last = self.stages[12].map(|rate| h * rate);
        let mut coefficients = [rise; 7];
        coefficients[1] = core::array::from_fn(|i| first[i] - rise[i]);
        coefficients[2] = core::array::from_fn(|i| T::from(2.0) * rise[i] - (first[i] + last[i]));
        for (coefficient, row) in coefficients[3..].iter_mut().zip(&DENSE) {
            *coefficient = weigh(with, row, &self.stages).map(|v| h * v);
        }
        Dense {
            h,
            start: self.start,
            end: self.end,
            coefficients,
        }
    }
}

/// Something to do in registers of either kind.
trait Job<const N: usize> {
    type Output;

    fn with(self, registers: impl Registers<f64, N>) -> Self::Output;
}

/// Does it in wide registers, where the processor has them: the results are the same.
#[inline(always)]
fn in_registers<const N: usize, J: Job<N>>(ignorable: usize, job: J) -> J::Output {
    #[cfg(target_arch = "x86_64")]
    {
        #[target_feature(enable = "avx2")]
        unsafe fn wide<const N: usize, J: Job<N>>(ignorable: usize, job: J) -> J::Output {
            // SAFETY: AVX2 comes with AVX.
            job.with(unsafe { super::registers::Wide::new(ignorable) })
        }
        if std::arch::is_x86_feature_detected!("avx2") {
            // SAFETY: the processor has what is asked for.
            return unsafe { wide(ignorable, job) };
        }
    }
    job.with(OneByOne { ignorable })
}

impl<const N: usize> Step<f64, N> {
    /// A step of length h from `start`: as [`Step::take`], in the widest registers.
    pub fn again<S: System<f64, N>>(system: &S, start: &[f64; N], h: f64) -> Self {
        struct Go<'a, S, const N: usize>(&'a mut Step<f64, N>, &'a S, f64);
        impl<S: System<f64, N>, const N: usize> Job<N> for Go<'_, S, N> {
            type Output = ();

            #[inline(always)]
            fn with(self, registers: impl Registers<f64, N>) {
                self.0.go(registers, self.1, self.2);
            }
        }
        let mut step = Step::still(start, &system.rates(start));
        in_registers(S::IGNORABLE, Go(&mut step, system, h));
        step
    }

    /// Goes from the start by the length h, whatever the step was before, and estimates the error.
    pub fn attempt<S: System<f64, N>>(
        &mut self,
        system: &S,
        h: f64,
        tolerance: f64,
    ) -> Estimate<f64> {
        struct Attempt<'a, S, const N: usize>(&'a mut Step<f64, N>, &'a S, f64, f64);
        impl<S: System<f64, N>, const N: usize> Job<N> for Attempt<'_, S, N> {
            type Output = Estimate<f64>;

            #[inline(always)]
            fn with(self, registers: impl Registers<f64, N>) -> Estimate<f64> {
                let Attempt(step, system, h, tolerance) = self;
                let before_end = step.go(registers, system, h);
                step.estimate(registers, system, &before_end, tolerance)
            }
        }
        in_registers(S::IGNORABLE, Attempt(self, system, h, tolerance))
    }

    /// The step as a polynomial of its fraction; three more evaluations of the right-hand side.
    pub fn dense<S: System<f64, N>>(&mut self, system: &S) -> Dense<f64, N> {
        struct Open<'a, S, const N: usize>(&'a mut Step<f64, N>, &'a S);
        impl<S: System<f64, N>, const N: usize> Job<N> for Open<'_, S, N> {
            type Output = Dense<f64, N>;

            #[inline(always)]
            fn with(self, registers: impl Registers<f64, N>) -> Dense<f64, N> {
                self.0.polynomial(registers, self.1)
            }
        }
        in_registers(S::IGNORABLE, Open(self, system))
    }
}

#[cfg(test)]
mod tests {
    use super::{OneByOne, Step, System};

    /// A chain of `N` − 2 coupled oscillators, and two sums that none of them feels.
    struct Chain<const N: usize>;

    impl<const N: usize> System<f64, N> for Chain<N> {
        const IGNORABLE: usize = 2;

        fn rates(&self, u: &[f64; N]) -> [f64; N] {
            let (felt, m) = (&u[2..], N - 2);
            let coupled = |i: usize| felt[(i + 1) % m] * felt[i] - 0.7 * felt[(i + m - 1) % m];
            core::array::from_fn(|i| match i {
                0 => felt.iter().sum(),
                1 => felt[0] * felt[m - 1],
                _ => coupled(i - 2),
            })
        }

        fn scale(&self, u: &[f64; N]) -> [f64; N] {
            u.map(|value| 1.0 + value.abs())
        }
    }

    /// With 1, 3, 8, 11 and 15 that are felt: none, one and more of each width, and odd ones.
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
        let ignorable = OneByOne {
            ignorable: Chain::<N>::IGNORABLE,
        };
        for h in [1e-3, 0.07, 0.3] {
            let mut wide = Step::again(&chain, &start, h);
            let mut plain = Step::still(&start, &chain.rates(&start));
            let before_end = plain.go(ignorable, &chain, h);
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
