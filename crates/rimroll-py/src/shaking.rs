//! Many motions on tables that move, at once.

use crate::arguments::{BodiesArgument, ContactLawArgument, VariedArgument, of_row, refusal};
use crate::ensemble::StartsArgument;
use crate::ground::{CoreGround, FlatArgument, flat_landing};
use crate::watched::in_threads;
use numpy::{IntoPyArray, PyArray2, PyArrayMethods, PyReadonlyArray1};
use pyo3::exceptions::PyIndexError;
use pyo3::prelude::*;
use rimroll::motion::Shaken;
use rimroll::{
    Body, ContactLaw, Ground, Options, Shaking, Status, shake_many as shake_many_in_core, shaking,
};
use std::sync::Arc;

/// The numbers of a motion, in the order of [`numbers`].
pub const SHAKEN_COLUMNS: [&str; 17] = [
    "status",
    "overturning_time",
    "undecided",
    "stands",
    "max_tilt",
    "max_tilt_time",
    "uplift_time",
    "end_time",
    "end_tilt",
    "end_x",
    "end_y",
    "end_yaw",
    "friction_loss",
    "resistance_loss",
    "impact_loss",
    "ground_work",
    "steps",
];

/// The names of the statuses in the order of their codes.
pub fn statuses() -> [&'static str; 8] {
    Status::ALL.map(Status::name)
}

fn numbers(shaken: &Shaken) -> [f64; SHAKEN_COLUMNS.len()] {
    [
        f64::from(shaken.status as u8),
        shaken.overturning_time.unwrap_or(f64::NAN),
        f64::from(shaken.undecided),
        f64::from(shaken.stands),
        shaken.max_tilt,
        shaken.max_tilt_time,
        shaken.uplift_time.unwrap_or(f64::NAN),
        shaken.end_time,
        shaken.end_tilt,
        shaken.residual_displacement[0],
        shaken.residual_displacement[1],
        shaken.residual_yaw,
        shaken.friction_loss,
        shaken.resistance_loss,
        shaken.impact_loss,
        shaken.ground_work,
        shaken.steps as f64,
    ]
}

/// What many motions begin with, one row each.
#[derive(FromPyObject)]
pub struct ShakingsArgument<'py> {
    bodies: BodiesArgument<'py>,
    starts: StartsArgument<'py>,
    contact_law: ContactLawArgument,
    /// The parameters of the contact law that differ between rows.
    varied: VariedArgument<'py>,
    grounds: Vec<PyRef<'py, CoreGround>>,
    /// For each row the index of its ground.
    ground: PyReadonlyArray1<'py, i64>,
    scale: PyReadonlyArray1<'py, f64>,
    duration: PyReadonlyArray1<'py, f64>,
}

/// The parts of [`ShakingsArgument`] to which rows refer.
struct Parts {
    bodies: Vec<Body>,
    contact_laws: Vec<ContactLaw>,
    grounds: Vec<Arc<Ground>>,
}

impl ShakingsArgument<'_> {
    fn parts(&self) -> PyResult<Parts> {
        let grounds = self.grounds.iter();
        Ok(Parts {
            bodies: self.bodies.bodies()?,
            contact_laws: self.contact_law.of_rows(&self.varied)?,
            grounds: grounds.map(|ground| Arc::clone(&ground.ground)).collect(),
        })
    }

    fn rows<'a>(&self, parts: &'a Parts) -> PyResult<Vec<Shaking<'a>>> {
        let (ground, scale) = (self.ground.as_slice()?, self.scale.as_slice()?);
        let numbers = ground.iter().zip(scale).zip(self.duration.as_slice()?);
        let rows = self.starts.starts()?.zip(numbers).enumerate();
        rows.map(|(row, (start, ((&ground, &scale), &duration)))| {
            let ground = usize::try_from(ground).ok();
            let ground = ground.and_then(|index| parts.grounds.get(index));
            Ok(Shaking {
                body: of_row(&parts.bodies, row),
                start,
                contact_law: of_row(&parts.contact_laws, row).clone(),
                ground: Some(ground.ok_or_else(|| PyIndexError::new_err("no such ground"))?),
                scale,
                duration,
            })
        })
        .collect()
    }
}

/// The index of the first row that `shake_many` refuses, if there is one.
#[pyfunction]
pub fn first_refused_shaking(
    shakings: ShakingsArgument<'_>,
    gravity: f64,
    topple_tilt: Option<f64>,
) -> PyResult<Option<usize>> {
    let options = Options {
        gravity,
        topple_tilt,
        ..Options::default()
    };
    let parts = shakings.parts()?;
    Ok(shaking::first_refused(&shakings.rows(&parts)?, &options))
}

/// A table with one row per motion and a column for each of [`SHAKEN_COLUMNS`], with statuses as indices into
/// `STATUSES`; and the exception that stopped the work, if any: the rows are then the first ones. `threads` = 0 means
/// one per processor. `progress` is called about ten times a second with the number of motions done.
#[pyfunction]
#[allow(clippy::too_many_arguments)]
pub fn shake_many<'py>(
    py: Python<'py>,
    shakings: ShakingsArgument<'py>,
    gravity: f64,
    rtol: f64,
    topple_tilt: Option<f64>,
    max_steps: usize,
    flat: FlatArgument,
    threads: usize,
    progress: Option<Py<PyAny>>,
) -> PyResult<(Bound<'py, PyArray2<f64>>, Option<PyErr>)> {
    let (flat, flat_gap) = flat_landing(&flat)?;
    let options = Options {
        gravity,
        rtol,
        topple_tilt,
        max_steps,
        flat,
        flat_gap,
        ..Options::default()
    };
    let parts = shakings.parts()?;
    let rows = shakings.rows(&parts)?;
    let (outcomes, stopped) = in_threads(py, threads, progress.as_ref(), |watched| {
        shake_many_in_core(&rows, &options, |count| watched.count(count))
    })?;
    let outcomes = outcomes.map_err(refusal)?;
    let table: Vec<f64> = outcomes.iter().flat_map(numbers).collect();
    let table = table
        .into_pyarray(py)
        .reshape([outcomes.len(), SHAKEN_COLUMNS.len()])?;
    Ok((table, stopped))
}
