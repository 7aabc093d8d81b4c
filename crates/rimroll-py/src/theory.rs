//! Closed forms, steady motions, the paper's two approximations and the theory that it rejects.

use crate::arguments::{
    BodyArgument, ContactLawArgument, StateArgument, VariedArgument, ideal_law, refusal,
};
use numpy::{IntoPyArray, PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use rimroll::law::DryFriction;
use rimroll::steady::{self, Given};
use rimroll::turn::{Arrival, NearCollision};
use rimroll::{FrictionLaw, composite_approximation, imperfection, small_angle, turn};

/// (tipping_rate, slip, spin, friction_ratio)
type ArrivalNumbers = (f64, f64, f64, f64);

fn arrival_of((tipping_rate, slip, spin, friction_ratio): ArrivalNumbers) -> Arrival {
    Arrival {
        tipping_rate,
        slip,
        spin,
        friction_ratio,
    }
}

#[pyfunction]
pub fn check_contact_law(contact_law: ContactLawArgument) -> PyResult<()> {
    contact_law.contact_law().map(|_| ())
}

/// The coefficient of friction of a tabulated law at slip speeds, m/s.
#[pyfunction]
pub fn friction_at<'py>(
    py: Python<'py>,
    contact_law: ContactLawArgument,
    speeds: PyReadonlyArray1<'py, f64>,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    let FrictionLaw::Tabulated(table) = contact_law.contact_law()?.friction else {
        unreachable!("only tabulated laws are asked for their curve");
    };
    let speeds = speeds.as_array();
    let frictions: Vec<f64> = speeds.iter().map(|&v| table.coefficient(v)).collect();
    Ok(frictions.into_pyarray(py))
}

/// The index of the first invalid contact law and its error, if there is one.
#[pyfunction]
pub fn first_bad_contact_law(
    contact_law: ContactLawArgument,
    varied: VariedArgument<'_>,
) -> PyResult<Option<(usize, PyErr)>> {
    let mut each = contact_law.varied(&varied)?.enumerate();
    Ok(each.find_map(|(row, contact_law)| contact_law.err().map(|error| (row, refusal(error)))))
}

#[pyfunction]
pub fn watershed_slope(body: BodyArgument, tilt: f64, law_name: &str) -> PyResult<f64> {
    turn::exact::watershed_slope(&body.body()?, ideal_law(law_name)?, tilt).map_err(refusal)
}

#[pyfunction]
pub fn arrival(
    py: Python<'_>,
    body: BodyArgument,
    start: StateArgument,
    contact_law: ContactLawArgument,
    gravity: f64,
) -> PyResult<ArrivalNumbers> {
    let (body, start, contact_law) = (body.body()?, start.into(), contact_law.contact_law()?);
    let arrival = py
        .detach(|| Arrival::from_start(&body, &start, &contact_law, gravity))
        .map_err(refusal)?;
    Ok((
        arrival.tipping_rate,
        arrival.slip,
        arrival.spin,
        arrival.friction_ratio,
    ))
}

#[pyfunction]
pub fn turn_limit(
    py: Python<'_>,
    body: BodyArgument,
    contact_law: ContactLawArgument,
    arrival: ArrivalNumbers,
) -> PyResult<f64> {
    let (body, friction) = (body.body()?, contact_law.contact_law()?.friction);
    py.detach(|| turn::turn_limit_of(&body, &friction, &arrival_of(arrival)))
        .map_err(refusal)
}

/// (turn, rising_rate, spin, (slip along e_x1, along e_y1), loss)
type PassageNumbers = (f64, f64, f64, (f64, f64), f64);

#[pyfunction]
pub fn passage(
    py: Python<'_>,
    body: BodyArgument,
    contact_law: ContactLawArgument,
    arrival: ArrivalNumbers,
) -> PyResult<PassageNumbers> {
    let (body, friction) = (body.body()?, contact_law.contact_law()?.friction);
    let passage = py
        .detach(|| turn::passage(&body, &friction, &arrival_of(arrival)))
        .map_err(refusal)?;
    Ok((
        passage.turn,
        passage.rising_rate,
        passage.spin,
        (passage.slip[0], passage.slip[1]),
        passage.loss,
    ))
}

#[pyfunction]
pub fn turn_limit_with_spin(body: BodyArgument, spin: f64, tipping_rate: f64) -> PyResult<f64> {
    turn::turn_limit_with_spin(&body.body()?, spin, tipping_rate).map_err(refusal)
}

#[pyfunction]
pub fn disk_turn_limit(gyration_ratio: f64) -> PyResult<f64> {
    turn::disk_turn_limit(gyration_ratio).map_err(refusal)
}

#[pyfunction]
pub fn tall_turn_limit(body: BodyArgument, law_name: &str) -> PyResult<f64> {
    Ok(turn::tall_turn_limit(&body.body()?, ideal_law(law_name)?))
}

#[pyfunction]
pub fn point_mass_turn_limit(radius: f64, height: f64, law_name: &str) -> PyResult<f64> {
    turn::point_mass_turn_limit(radius, height, ideal_law(law_name)?).map_err(refusal)
}

#[pyfunction]
pub fn needed_friction(body: BodyArgument) -> PyResult<f64> {
    Ok(turn::needed_friction(&body.body()?))
}

#[pyfunction]
pub fn painleve_friction(body: BodyArgument) -> PyResult<f64> {
    Ok(turn::painleve_friction(&body.body()?))
}

#[pyfunction]
pub fn error_law_coefficient(
    body: BodyArgument,
    law_name: &str,
    tipping_rate: f64,
    gravity: f64,
) -> PyResult<f64> {
    turn::error_law_coefficient(&body.body()?, ideal_law(law_name)?, tipping_rate, gravity)
        .map_err(refusal)
}

#[pyfunction]
pub fn balance_tilt(body: BodyArgument) -> PyResult<f64> {
    Ok(body.body()?.balance_tilt())
}

#[pyfunction]
pub fn lift_off_rate(body: BodyArgument, gravity: f64) -> PyResult<f64> {
    turn::lift_off_rate(&body.body()?, gravity).map_err(refusal)
}

#[pyfunction]
pub fn slip_rate(body: BodyArgument, gravity: f64) -> PyResult<f64> {
    turn::slip_rate(&body.body()?, gravity).map_err(refusal)
}

/// `f` at each time.
fn map<'py>(
    py: Python<'py>,
    t: PyReadonlyArray1<'py, f64>,
    f: impl Fn(f64) -> f64,
) -> Bound<'py, PyArray1<f64>> {
    let values: Vec<f64> = t.as_array().iter().map(|&t| f(t)).collect();
    values.into_pyarray(py)
}

/// The near-collision in isolation; times from its smallest tilt, s.
#[pyclass(frozen)]
pub struct CoreNearCollision {
    near: NearCollision,
}

#[pymethods]
impl CoreNearCollision {
    #[new]
    fn new(
        body: BodyArgument,
        law_name: &str,
        min_tilt: f64,
        tipping_rate: f64,
        direction: f64,
    ) -> PyResult<Self> {
        let near = NearCollision::new(
            &body.body()?,
            ideal_law(law_name)?,
            min_tilt,
            tipping_rate,
            direction,
        );
        Ok(CoreNearCollision {
            near: near.map_err(refusal)?,
        })
    }

    fn tilt<'py>(
        &self,
        py: Python<'py>,
        t: PyReadonlyArray1<'py, f64>,
    ) -> Bound<'py, PyArray1<f64>> {
        map(py, t, |t| self.near.tilt(t))
    }

    fn yaw<'py>(
        &self,
        py: Python<'py>,
        t: PyReadonlyArray1<'py, f64>,
    ) -> Bound<'py, PyArray1<f64>> {
        map(py, t, |t| self.near.yaw(t))
    }

    fn yaw_rate<'py>(
        &self,
        py: Python<'py>,
        t: PyReadonlyArray1<'py, f64>,
    ) -> Bound<'py, PyArray1<f64>> {
        map(py, t, |t| self.near.yaw_rate(t))
    }

    /// Rows (t, tilt, yaw) of the lean vector's motion, one column per sample.
    fn lean_vector<'py>(&self, py: Python<'py>, until: f64) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let samples = small_angle::lean_vector(&self.near, until).map_err(refusal)?;
        let flat: Vec<f64> = (0..3)
            .flat_map(|i| samples.iter().map(move |sample| sample[i]))
            .collect();
        flat.into_pyarray(py).reshape([3, samples.len()])
    }
}

/// The composite approximation; times from the release, s.
#[pyclass(frozen)]
pub struct CoreComposite {
    composite: composite_approximation::Composite,
}

#[pymethods]
impl CoreComposite {
    #[new]
    fn new(
        body: BodyArgument,
        start: StateArgument,
        law_name: &str,
        gravity: f64,
    ) -> PyResult<Self> {
        let composite = composite_approximation::composite(
            &body.body()?,
            &start.into(),
            ideal_law(law_name)?,
            gravity,
        );
        Ok(CoreComposite {
            composite: composite.map_err(refusal)?,
        })
    }

    fn tilt<'py>(
        &self,
        py: Python<'py>,
        t: PyReadonlyArray1<'py, f64>,
    ) -> Bound<'py, PyArray1<f64>> {
        map(py, t, |t| self.composite.tilt(t))
    }

    fn yaw<'py>(
        &self,
        py: Python<'py>,
        t: PyReadonlyArray1<'py, f64>,
    ) -> Bound<'py, PyArray1<f64>> {
        map(py, t, |t| self.composite.yaw(t))
    }

    /// (time, half_width, min_tilt, tipping_rate, stretch)
    #[getter]
    fn numbers(&self) -> (f64, f64, f64, f64, f64) {
        let near = &self.composite.near_collision;
        (
            self.composite.time,
            self.composite.half_width,
            near.min_tilt,
            near.tipping_rate,
            near.stretch,
        )
    }
}

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
