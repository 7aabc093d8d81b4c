//! Steady motions.

use crate::arguments::{BodyArgument, ideal_law, refusal};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use rimroll::steady::{self, Given};

/// (yaw_rate, axial_spin, nutation_squared) of each steady motion.
#[pyfunction]
#[pyo3(signature = (body, law_name, tilt, yaw_rate, axial_spin, gravity))]
pub fn steady_motions(
    body: BodyArgument,
    law_name: &str,
    tilt: f64,
    yaw_rate: Option<f64>,
    axial_spin: Option<f64>,
    gravity: f64,
) -> PyResult<Vec<(f64, f64, f64)>> {
    let given = match (yaw_rate, axial_spin) {
        (Some(yaw_rate), None) => Given::YawRate(yaw_rate),
        (None, Some(spin)) => Given::AxialSpin(spin),
        (Some(yaw_rate), Some(spin)) => Given::Both(yaw_rate, spin),
        (None, None) => return Err(PyValueError::new_err("no rate is given")),
    };
    let (body, law) = (body.body()?, ideal_law(law_name)?);
    let motions = steady::steady_motions(&body, law, tilt, given, gravity).map_err(refusal)?;
    let numbers = motions
        .iter()
        .map(|one| (one.yaw_rate, one.axial_spin, one.nutation_squared));
    Ok(numbers.collect())
}

#[pyfunction]
pub fn steady_wobble_rate(body: BodyArgument, tilt: f64, gravity: f64) -> PyResult<f64> {
    steady::steady_wobble_rate(&body.body()?, tilt, gravity).map_err(refusal)
}

#[pyfunction]
pub fn spinning_rate(body: BodyArgument, tilt: f64, gravity: f64) -> PyResult<f64> {
    steady::spinning_rate(&body.body()?, tilt, gravity).map_err(refusal)
}

#[pyfunction]
pub fn nutation_ratio(body: BodyArgument, law_name: &str) -> PyResult<f64> {
    Ok(steady::nutation_ratio(&body.body()?, ideal_law(law_name)?))
}

#[pyfunction]
pub fn critical_rolling_spin(body: BodyArgument, gravity: f64) -> PyResult<f64> {
    steady::critical_rolling_spin(&body.body()?, gravity).map_err(refusal)
}

#[pyfunction]
pub fn critical_spinning_rate(body: BodyArgument, gravity: f64) -> PyResult<f64> {
    steady::critical_spinning_rate(&body.body()?, gravity).map_err(refusal)
}
