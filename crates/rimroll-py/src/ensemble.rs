//! Many falls at once.

use crate::arguments::{BodiesArgument, ContactLawArgument, VariedArgument, of_row, refusal};
use crate::watched::in_threads;
use numpy::{IntoPyArray, PyArray2, PyArrayMethods, PyReadonlyArray1};
use pyo3::prelude::*;
use rimroll::motion::Fall;
use rimroll::{Options, Setup, State, ensemble as ensemble_in_core};

/// The numbers of a fall, in the order of [`numbers`].
pub const FALL_COLUMNS: [&str; 14] = [
    "outcome",
    "turn",
    "min_tilt",
    "min_tilt_time",
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
        f64::from(fall.outcome as u8),
        of_turn(|turn| turn.angle),
        of_turn(|turn| turn.min_tilt),
        of_turn(|turn| turn.t),
        fall.end.t,
        fall.end.tilt,
        fall.end.yaw,
        fall.end.axial_spin,
        fall.end.friction_loss,
        fall.end.resistance_loss,
        fall.end.impact_loss,
        f64::from(u8::from(fall.slid)),
        f64::from(u8::from(fall.flew)),
        fall.steps as f64,
    ]
}

/// Arrays of equal length with one entry per start.
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
    pub fn starts(&self) -> PyResult<impl Iterator<Item = State> + '_> {
        let columns = self.columns()?;
        Ok(
            (0..columns[0].len())
                .map(move |i| State::from_numbers(columns.map(|column| column[i]))),
        )
    }

    /// Slices of equal length.
    pub fn columns(&self) -> PyResult<[&[f64]; 6]> {
        let mut columns: [&[f64]; 6] = [&[]; 6];
        for (column, array) in columns.iter_mut().zip(self.arrays()) {
            *column = array.as_slice()?;
        }
        let length = columns.iter().map(|column| column.len()).min();
        Ok(columns.map(|column| &column[..length.unwrap_or(0)]))
    }

    fn arrays(&self) -> [&PyReadonlyArray1<'_, f64>; 6] {
        let StartsArgument {
            tilt,
            tilt_rate,
            yaw,
            yaw_rate,
            spin,
            spin_rate,
        } = self;
        [tilt, tilt_rate, yaw, yaw_rate, spin, spin_rate]
    }
}

/// The index of the first row whose body or start `ensemble` and `exact_turns` refuse under the law of this name, if
/// there is one.
#[pyfunction]
pub fn first_refused(
    bodies: BodiesArgument<'_>,
    starts: StartsArgument<'_>,
    law_name: &str,
    gravity: f64,
    topple_tilt: Option<f64>,
) -> PyResult<Option<usize>> {
    let options = Options {
        gravity,
        topple_tilt,
        ..Options::default()
    };
    let bodies = bodies.bodies()?;
    let rows = starts.starts()?.enumerate();
    let rows = rows.map(|(row, start)| (of_row(&bodies, row), start));
    Ok(options.first_refused(law_name, rows))
}

/// A table with one row per fall and a column for each of [`FALL_COLUMNS`], with outcomes as indices into
/// `OUTCOMES`; and the exception that stopped the work, if any: the rows are then those of the first starts.
/// `varied` has the parameters of the contact law that differ between starts, `friction_scale` a factor of the
/// friction for each start. `threads` = 0 means one per processor. `progress` is called about ten times a
/// second with the number of falls done.
#[pyfunction]
#[allow(clippy::too_many_arguments)]
pub fn ensemble<'py>(
    py: Python<'py>,
    bodies: BodiesArgument<'py>,
    starts: StartsArgument<'py>,
    contact_law: ContactLawArgument,
    varied: VariedArgument<'py>,
    friction_scale: PyReadonlyArray1<'py, f64>,
    duration: f64,
    gravity: f64,
    rtol: f64,
    topple_tilt: Option<f64>,
    max_steps: usize,
    threads: usize,
    progress: Option<Py<PyAny>>,
) -> PyResult<(Bound<'py, PyArray2<f64>>, Option<PyErr>)> {
    let options = Options {
        duration,
        gravity,
        rtol,
        topple_tilt,
        max_steps,
        ..Options::default()
    };
    let bodies = bodies.bodies()?;
    let contact_laws = contact_law.of_rows(&varied)?;
    let friction_scale = friction_scale.as_array();
    let rows = starts.starts()?.zip(friction_scale.iter()).enumerate();
    let setups: Vec<Setup<'_>> = rows
        .map(|(row, (start, &factor))| {
            let contact_law = of_row(&contact_laws, row)
                .clone()
                .with_friction_scaled(factor);
            (of_row(&bodies, row), start, contact_law)
        })
        .collect();
    let (falls, stopped) = in_threads(py, threads, progress.as_ref(), |watched| {
        ensemble_in_core(&setups, &options, |falls| watched.count(falls))
    })?;
    let falls = falls.map_err(refusal)?;
    let table: Vec<f64> = falls.iter().flat_map(numbers).collect();
    let table = table
        .into_pyarray(py)
        .reshape([falls.len(), FALL_COLUMNS.len()])?;
    Ok((table, stopped))
}
