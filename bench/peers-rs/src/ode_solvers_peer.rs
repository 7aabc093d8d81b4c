//! ode_solvers: DOP853 and DOPRI5 of Hairer, Nørsett & Wanner.

use crate::ATOL_OVER_RTOL;
use crate::can::{Equations, by_tilt_rate};
use crate::protocol::Question;
use ode_solvers::dop_shared::OutputType;
use ode_solvers::{Dop853, Dopri5, SVector, System};

/// The motion until its tilt has been largest.
struct Rocking<E> {
    equations: E,
    rising: bool,
}

impl<const N: usize, E: Equations<N>> System<f64, SVector<f64, N>> for Rocking<E> {
    fn system(&self, _: f64, u: &SVector<f64, N>, rates: &mut SVector<f64, N>) {
        rates.data.0[0] = self.equations.rates(&u.data.0[0]);
    }

    fn solout(&mut self, _: f64, u: &SVector<f64, N>, _: &SVector<f64, N>) -> bool {
        let rose = self.rising;
        self.rising = u[E::TILT_RATE] > 0.0;
        rose && !self.rising
    }
}

/// From there back to the maximum, with the tilt rate as clock.
struct ToMaximum<E>(E);

impl<const N: usize, E: Equations<N>> System<f64, SVector<f64, N>> for ToMaximum<E> {
    fn system(&self, _: f64, u: &SVector<f64, N>, rates: &mut SVector<f64, N>) {
        rates.data.0[0] = by_tilt_rate(&self.0, &u.data.0[0]);
    }
}

macro_rules! turns_by {
    ($name:ident, $solver:ident) => {
        /// The turn of each start, NaN where the solver gives up.
        pub fn $name<const N: usize, E: Equations<N>>(question: &Question) -> Vec<f64> {
            let rtol = question.tolerance;
            let atol = rtol * ATOL_OVER_RTOL;
            let equations = E::of(question.law);
            let solve = |system, to, h, u| {
                $solver::from_param(
                    system,
                    0.0,
                    to,
                    0.0,
                    u,
                    rtol,
                    atol,
                    0.9,
                    0.0,
                    0.333,
                    6.0,
                    to,
                    h,
                    20_000,
                    100_000,
                    OutputType::Sparse,
                )
            };
            let turn = |start| -> Option<f64> {
                let system = Rocking {
                    equations,
                    rising: false,
                };
                let u = SVector::from(E::begin(start));
                let mut down_and_up = solve(system, 1e3, 0.0, u);
                down_and_up.integrate().ok()?;
                let after = down_and_up.y_out().last()?;
                let p = after[E::TILT_RATE];
                let mut back = $solver::from_param(
                    ToMaximum(equations),
                    p,
                    0.0,
                    0.0,
                    *after,
                    rtol,
                    atol,
                    0.9,
                    0.0,
                    0.333,
                    6.0,
                    p.abs(),
                    -p,
                    20_000,
                    100_000,
                    OutputType::Sparse,
                );
                back.integrate().ok()?;
                Some(back.y_out().last()?[E::YAW])
            };
            question
                .starts
                .iter()
                .map(|start| turn(start).unwrap_or(f64::NAN))
                .collect()
        }
    };
}

turns_by!(dop853, Dop853);
turns_by!(dopri5, Dopri5);
