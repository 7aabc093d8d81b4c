//! Bodies with corners, and their motions.

use crate::arguments::{BodyArgument, StateArgument, ideal_law, refusal};
use crate::motion::{TurnNumbers, angle_unit, in_columns, turn_numbers};
use crate::watched::followed;
use numpy::{PyArray2, PyReadonlyArray1};
use pyo3::prelude::*;
use rimroll::polygon::{PolygonMotion, PolygonOptions, PolygonalBody, simulate};

/// (corners, mass, radius, height, transverse_inertia, axial_inertia)
type PolygonalBodyNumbers = (u64, f64, f64, f64, f64, f64);

/// Any object with the attributes of `rimroll.PolygonalBody`.
#[derive(FromPyObject)]
pub struct PolygonalBodyArgument {
    corners: u64,
    #[pyo3(attribute("round_body"))]
    round: BodyArgument,
}

impl PolygonalBodyArgument {
    fn body(&self) -> PyResult<PolygonalBody> {
        PolygonalBody::new(self.corners, self.round.body()?).map_err(refusal)
    }
}

#[pyfunction]
pub fn check_polygonal_body(body: PolygonalBodyArgument) -> PyResult<()> {
    body.body().map(|_| ())
}

#[pyfunction]
pub fn housner_ratio(body: PolygonalBodyArgument) -> PyResult<f64> {
    Ok(body.body()?.housner_ratio())
}

#[pyfunction]
pub fn prism(
    mass: f64,
    corners: u64,
    radius: f64,
    length: f64,
    bore: f64,
) -> PyResult<PolygonalBodyNumbers> {
    let body = PolygonalBody::prism(mass, corners, radius, length, bore).map_err(refusal)?;
    let round = body.round();
    Ok((
        corners,
        round.mass(),
        round.radius(),
        round.height(),
        round.transverse_inertia(),
        round.axial_inertia(),
    ))
}

/// A computed motion, kept in the core. Tables have one column per moment and one row per quantity.
#[pyclass(frozen)]
pub struct CorePolygonMotion {
    motion: PolygonMotion,
}

#[pymethods]
impl CorePolygonMotion {
    /// All quantities at the accepted steps and at samples inside each.
    fn samples<'py>(
        &self,
        py: Python<'py>,
        per_step: usize,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        in_columns(py, self.motion.samples(per_step).into_iter())
    }

    /// All quantities at given times, s.
    fn at<'py>(
        &self,
        py: Python<'py>,
        t: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let t = t.as_array();
        in_columns(py, t.iter().map(|&t| self.motion.at(t)))
    }

    /// The kinds of the events, the supports after them, the energies that they took (J), and their table.
    #[allow(clippy::type_complexity)]
    fn events<'py>(
        &self,
        py: Python<'py>,
    ) -> PyResult<(
        Vec<&'static str>,
        Vec<&'static str>,
        Vec<f64>,
        Bound<'py, PyArray2<f64>>,
    )> {
        let events = &self.motion.events;
        Ok((
            events.iter().map(|event| event.kind.name()).collect(),
            events.iter().map(|event| event.support().name()).collect(),
            events.iter().map(|event| event.loss).collect(),
            in_columns(py, events.iter().map(|event| event.observables()))?,
        ))
    }

    /// The kinds of the phases and the times (s) at which they begin.
    fn phases(&self) -> Vec<(&'static str, f64)> {
        let supports = self.motion.supports();
        supports
            .iter()
            .map(|(support, t)| (support.name(), *t))
            .collect()
    }

    fn turns(&self) -> Vec<TurnNumbers> {
        self.motion.turns.iter().map(turn_numbers).collect()
    }

    #[getter]
    fn status(&self) -> &'static str {
        self.motion.status.name()
    }

    /// How it ended, in a sentence with its angles in degrees or radians.
    fn message(&self, degrees: bool) -> String {
        self.motion.message(angle_unit(degrees))
    }

    /// (steps, rejected, evaluations)
    #[getter]
    fn work(&self) -> (usize, usize, usize) {
        let work = &self.motion.work;
        (work.steps, work.rejected, work.evaluations)
    }
}

#[pyfunction]
#[allow(clippy::too_many_arguments)]
pub fn simulate_polygonal_body(
    py: Python<'_>,
    body: PolygonalBodyArgument,
    start: StateArgument,
    law_name: &str,
    duration: f64,
    gravity: f64,
    rtol: f64,
    topple_tilt: Option<f64>,
    max_steps: usize,
    restitution: f64,
    progress: Option<Py<PyAny>>,
) -> PyResult<CorePolygonMotion> {
    let given = PolygonOptions::default();
    let options = PolygonOptions {
        duration,
        gravity,
        rtol,
        topple_tilt: topple_tilt.unwrap_or(given.topple_tilt),
        max_steps,
        restitution,
    };
    let (body, law) = (body.body()?, ideal_law(law_name)?);
    let start = start.into();
    followed(py, progress, 64, |watch| {
        let motion = simulate(&body, &start, law, &options, watch)?;
        Ok(CorePolygonMotion { motion })
    })
}
