//! The turn of the can by Rust's solvers of differential equations.

mod can;
mod diffsol_peer;
mod ode_solvers_peer;
mod protocol;

use can::{Equations, Printed, Regular};
use protocol::{Question, Repeated};

/// Absolute over relative tolerance; the best, or within a tenth of it, of 1, 1e-2, ... 1e-8.
const ATOL_OVER_RTOL: f64 = 1e-4;

fn answer(question: &Question) -> Result<Vec<f64>, String> {
    if question.task != "turn" {
        return Err(format!("does not do a {}", question.task));
    }
    match question.coordinates.as_str() {
        "regular" => by_method::<7, Regular>(question),
        "printed" => by_method::<6, Printed>(question),
        other => Err(format!("knows no coordinates {other}")),
    }
}

fn by_method<const N: usize, E: Equations<N> + 'static>(
    question: &Question,
) -> Result<Vec<f64>, String> {
    match question.method.as_str() {
        "ode_solvers_dop853" => Ok(ode_solvers_peer::dop853::<N, E>(question)),
        "ode_solvers_dopri5" => Ok(ode_solvers_peer::dopri5::<N, E>(question)),
        "diffsol_tsit45" => diffsol_peer::tsit45::<N, E>(question),
        other => Err(format!("knows no method {other}")),
    }
}

fn main() {
    protocol::serve(Repeated::InTurn, answer);
}
