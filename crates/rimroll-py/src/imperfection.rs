//! The rim with an imperfection.

use crate::arguments::{BodyArgument, ideal_law, refusal};
use pyo3::prelude::*;
use rimroll::imperfection;

/// Fields of a collision, in the core's order.
type Collision = (f64, f64, f64, f64, Option<f64>, f64, f64, f64);

/// (turn, tipping_rate, energy_kept, collisions)
#[pyfunction]
pub fn imperfect_rim(
    body: BodyArgument,
    angle: f64,
    law_name: &str,
    tipping_rate: f64,
) -> PyResult<(Option<f64>, f64, f64, Vec<Collision>)> {
    let fall =
        imperfection::imperfect_rim(&body.body()?, ideal_law(law_name)?, angle, tipping_rate)
            .map_err(refusal)?;
    let collisions = fall.collisions.iter().map(|c| {
        (
            c.azimuth,
            c.scaled_tilt,
            c.impulse,
            c.held_impulse,
            c.lean_azimuth,
            c.lean_rate,
            c.rise_rate,
            c.energy_kept,
        )
    });
    Ok((
        fall.turn,
        fall.tipping_rate,
        fall.energy_kept,
        collisions.collect(),
    ))
}
