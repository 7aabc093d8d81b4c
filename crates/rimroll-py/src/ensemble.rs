//! Many falls at once.

use crate::arguments::{BodyArgument, SurfaceArgument, refusal};
use numpy::{IntoPyArray, PyArray2, PyArrayMethods, PyReadonlyArray1};
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use rimroll::motion::Fall;
use rimroll::{Options, State, Surface, ensemble as ensemble_in_core};

/// What is told of a fall, in the order of [`numbers`].
pub const FALL_COLUMNS: [&str; 13] = [
    "turn",
    "min_tilt",
    "near_time",
    "end_time",
    "end_tilt",
    "end_yaw",
    "end_axial_spin",
    "friction_loss",
    "resistance_loss",
    "impact_loss",
    "slid",
    "flew",
    "steps",
];

fn numbers(fall: &Fall) -> [f64; FALL_COLUMNS.len()] {
    let of_turn =
        |number: fn(&rimroll::motion::Turn) -> f64| fall.turn.as_ref().map_or(f64::NAN, number);
    [
        of_turn(|turn| turn.angle),
        of_turn(|turn| turn.min_tilt),
        of_turn(|turn| turn.t),
        fall.end.t,
        fall.end.tilt(),
        fall.end.yaw,
        fall.end.s,
        fall.end.friction_loss,
        fall.end.resistance_loss,
        fall.end.impact_loss,
        f64::from(u8::from(fall.slid)),
        f64::from(u8::from(fall.flew)),
        fall.work.steps as f64,
    ]
}

/// Arrays of equal length, one entry a start.
#[derive(FromPyObject)]
pub struct StartsArgument<'py> {
    tilt: PyReadonlyArray1<'py, f64>,
    tilt_rate: PyReadonlyArray1<'py, f64>,
    yaw: PyReadonlyArray1<'py, f64>,
    yaw_rate: PyReadonlyArray1<'py, f64>,
    spin: PyReadonlyArray1<'py, f64>,
    spin_rate: PyReadonlyArray1<'py, f64>,
}

impl StartsArgument<'_> {
    pub fn starts(&self) -> impl Iterator<Item = State> + '_ {
        let columns = [
            &self.tilt,
            &self.tilt_rate,
            &self.yaw,
            &self.yaw_rate,
            &self.spin,
            &self.spin_rate,
        ]
        .map(|column| column.as_array());
        let length = columns.iter().map(|column| column.len()).min().unwrap_or(0);
        (0..length).map(move |i| State {
            tilt: columns[0][i],
            tilt_rate: columns[1][i],
            yaw: columns[2][i],
            yaw_rate: columns[3][i],
            spin: columns[4][i],
            spin_rate: columns[5][i],
        })
    }
}

/// The endings by name, and a table with one row a fall and a column for each of [`FALL_COLUMNS`].
/// `grip` has a factor of the friction for each start; `threads` = 0 means as many as there are
/// processors.
#[pyfunction]
#[allow(clippy::too_many_arguments)]
pub fn ensemble<'py>(
    py: Python<'py>,
    body: BodyArgument,
    starts: StartsArgument<'py>,
    surface: SurfaceArgument,
    grip: PyReadonlyArray1<'py, f64>,
    duration: f64,
    gravity: f64,
    rtol: f64,
    topple_tilt: Option<f64>,
    max_steps: usize,
    threads: usize,
) -> PyResult<(Vec<&'static str>, Bound<'py, PyArray2<f64>>)> {
    let options = Options {
        duration,
        gravity,
        rtol,
        topple_tilt,
        max_steps,
    };
    let (body, surface) = (body.body()?, surface.surface()?);
    let grip = grip.as_array();
    let trials: Vec<(State, Surface)> = starts
        .starts()
        .zip(grip.iter())
        .map(|(start, &factor)| (start, surface.with_grip(factor)))
        .collect();
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .build()
        .map_err(|error| PyRuntimeError::new_err(error.to_string()))?;
    let falls = py
        .detach(|| pool.install(|| ensemble_in_core(&body, &trials, &options)))
        .map_err(refusal)?;
    let table: Vec<f64> = falls.iter().flat_map(numbers).collect();
    let table = table
        .into_pyarray(py)
        .reshape([falls.len(), FALL_COLUMNS.len()])?;
    let endings = falls.iter().map(|fall| fall.status.name()).collect();
    Ok((endings, table))
}
