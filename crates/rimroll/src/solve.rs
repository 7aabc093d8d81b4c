//! A solver for smooth autonomous systems u′ = f(u): it knows no mechanics.
//!
//! [`Stepper`] advances by steps of its own choice; each [`Step`] can be evaluated anywhere inside
//! (dense output) and asked where a function of the state changes sign (events). What relaxes too fast
//! for explicit steps is done by [`Collocation`].

mod collocation;
mod dense;
mod dop853;
mod root;
mod stiff;
mod tableau;

pub use collocation::{Collocation, POINTS, RADAU, solved};
pub use dense::Dense;
pub use dop853::Step;
pub use root::bracketed;
pub use stiff::Implicit;

/// An autonomous system of N first-order equations.
pub trait System<const N: usize> {
    /// u′ = f(u).
    fn rates(&self, u: &[f64; N]) -> [f64; N];

    /// For each component the size that an error is to be compared with.
    fn scale(&self, u: &[f64; N]) -> [f64; N];

    /// How many components, the first, change in every case: the others cost nothing where
    /// [`System::only_first`] says so.
    const FIRST: usize = N;

    /// Whether only the first components change.
    fn only_first(&self) -> bool {
        false
    }

    /// How many components change.
    fn changing(&self) -> usize {
        if self.only_first() { Self::FIRST } else { N }
    }
}

/// Why no further step could be made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stuck {
    /// The rates are not finite or change too fast for any step.
    StepUnderflow,
}

/// How much work was done.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Work {
    /// Steps accepted.
    pub steps: usize,
    /// Steps tried again shorter.
    pub rejected: usize,
    /// Evaluations of the right-hand side.
    pub evaluations: usize,
}

impl core::ops::Add for Work {
    type Output = Work;
    fn add(self, other: Work) -> Work {
        Work {
            steps: self.steps + other.steps,
            rejected: self.rejected + other.rejected,
            evaluations: self.evaluations + other.evaluations,
        }
    }
}

/// Steps through a system with the error of each step held below a tolerance.
pub struct Stepper<'a, S, const N: usize> {
    system: &'a S,
    tolerance: f64,
    u: [f64; N],
    rates: [f64; N],
    h: f64,
    step: Option<Step<N>>,
    /// Work so far.
    pub work: Work,
}

impl<'a, S: System<N>, const N: usize> Stepper<'a, S, N> {
    /// A solver at the start `u`; `h` is a first guess for the step and need not be good.
    pub fn new(system: &'a S, u: [f64; N], h: f64, tolerance: f64) -> Self {
        Stepper {
            system,
            tolerance,
            u,
            rates: system.rates(&u),
            h,
            step: None,
            work: Work {
                evaluations: 1,
                ..Work::default()
            },
        }
    }

    /// Makes one step, as long as the tolerance allows.
    ///
    /// The next step is chosen as h · 0.9 err^(−1/8), within a factor of 5 down and 8 up (Hairer,
    /// Nørsett & Wanner 1993, section II.4).
    ///
    /// # Errors
    /// When no step is short enough.
    pub fn advance(&mut self) -> Result<&mut Step<N>, Stuck> {
        let mut grow_at_most = 8.0;
        loop {
            let step = Step::take(self.system, &self.u, &self.rates, self.h);
            self.work.evaluations += Step::<N>::EVALUATIONS;
            let error = step.error(self.system, self.tolerance);
            // Written so that a NaN is refused.
            if error <= 1.0 {
                let factor = 0.9 / libm::pow(error.max(1e-12), 0.125);
                self.u = step.end;
                self.rates = step.end_rates;
                self.h *= factor.clamp(0.2, grow_at_most);
                self.work.steps += 1;
                return Ok(self.step.insert(step));
            }
            self.work.rejected += 1;
            grow_at_most = 1.0;
            self.h *= if error.is_finite() {
                (0.9 / libm::pow(error, 0.125)).clamp(0.2, 1.0)
            } else {
                0.1
            };
            if self.h < 1e-280 || self.work.rejected > 1000 + 10 * self.work.steps {
                return Err(Stuck::StepUnderflow);
            }
        }
    }
}
