//! diffsol: its explicit Tsitouras 5(4), with its own search for roots.

use crate::ATOL_OVER_RTOL;
use crate::can::Equations;
use crate::protocol::{Question, Start};
use diffsol::{
    NalgebraMat, OdeBuilder, OdeEquations, OdeSolverMethod, OdeSolverStopReason, Vector,
};

type M = NalgebraMat<f64>;

/// The turn of each start, NaN where the solver gives up.
pub fn tsit45<const N: usize, E: Equations<N> + 'static>(
    question: &Question,
) -> Result<Vec<f64>, String> {
    let equations = E::of(question.law);
    // The start is the parameters, so that the problem is set up once.
    let mut problem = OdeBuilder::<M>::new()
        .rtol(question.tolerance)
        .atol([question.tolerance * ATOL_OVER_RTOL])
        .h0(1e-3)
        .p(vec![0.1; N])
        .rhs(move |u: &[f64], _: &[f64], _: f64, rates: &mut [f64]| {
            let u: &[f64; N] = u.try_into().expect("a state");
            rates.copy_from_slice(&equations.rates(u));
        })
        .init(|p: &[f64], _: f64, u: &mut [f64]| u.copy_from_slice(p), N)
        .root(
            |u: &[f64], _: &[f64], _: f64, root: &mut [f64]| root[0] = u[E::TILT_RATE],
            1,
        )
        .build()
        .map_err(|error| error.to_string())?;
    let mut turn = |start: &Start| -> Option<f64> {
        let begin = <M as diffsol::MatrixCommon>::V::from_slice(
            &E::begin(start),
            problem.context().clone(),
        );
        problem.eqn_mut().set_params(&begin);
        let mut solver = problem.tsit45().ok()?;
        let mut extrema = 0;
        for _ in 0..1_000_000 {
            if let OdeSolverStopReason::RootFound(at, _) = solver.step().ok()? {
                extrema += 1;
                if extrema == 2 {
                    return Some(solver.interpolate(at).ok()?.get_index(E::YAW));
                }
            }
        }
        None
    };
    Ok(question
        .starts
        .iter()
        .map(|start| turn(start).unwrap_or(f64::NAN))
        .collect())
}
