//! `simulate`, and the tables of numbers that describe a motion.

use crate::arguments::{BodyArgument, ContactLawArgument, RimrollError, StateArgument};
use crate::ground::{CoreGround, FlatArgument, flat_landing};
use crate::watched::followed;
use numpy::{IntoPyArray, PyArray2, PyArrayMethods, PyReadonlyArray1};
use pyo3::prelude::*;
use rimroll::motion::{
    AngleUnit, Instant, SHAKEN_PARAMETERS, Sensitivity, ShakenSensitivity, pose,
};
use rimroll::{InvalidInput, Options, Status, simulate_on};
use std::ops::ControlFlow;
use std::sync::Arc;

/// (angle, min_tilt, t, yaw_rate, start, end, max_tilt)
pub type TurnNumbers = (f64, f64, f64, f64, f64, f64, f64);

/// (gap, contact_speed, passage_time, sound_time, force_ratio, loss_ratio), and which of them are exceeded
type ValidityNumbers = ((f64, f64, f64, f64, f64, f64), [bool; 4]);

/// A computed motion, kept in the core. Tables have one column per moment and one row per quantity.
#[pyclass(frozen)]
pub struct CoreMotion {
    motion: rimroll::Motion,
    /// The derivatives, if requested.
    derivatives: Option<Derivatives>,
}

/// The derivatives of a motion.
enum Derivatives {
    AtRest(Box<Sensitivity>),
    Shaken(Box<ShakenSensitivity>),
}

impl Derivatives {
    /// The derivatives of a motion; `None` if `watch` breaks.
    fn of(
        motion: &rimroll::Motion,
        watch: impl FnMut(f64) -> ControlFlow<()>,
    ) -> Result<Option<Derivatives>, InvalidInput> {
        if motion.moves() {
            let shaken = motion.shaken_sensitivity(watch)?;
            return Ok(shaken.map(|shaken| Derivatives::Shaken(Box::new(shaken))));
        }
        let at_rest = motion.sensitivity(watch)?;
        Ok(at_rest.map(|at_rest| Derivatives::AtRest(Box::new(at_rest))))
    }
}

impl CoreMotion {
    /// All quantities at each moment.
    fn table<'py>(
        &self,
        py: Python<'py>,
        moments: impl Iterator<Item = Instant>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        in_columns(py, moments.map(|at| self.motion.observables(&at)))
    }

    fn derivatives(&self) -> PyResult<&Derivatives> {
        let missing = "ask for the derivatives with simulate(..., jacobian=True)";
        self.derivatives
            .as_ref()
            .ok_or_else(|| RimrollError::new_err(missing))
    }
}

/// The numbers of a turn.
pub fn turn_numbers(turn: &rimroll::motion::Turn) -> TurnNumbers {
    (
        turn.angle,
        turn.min_tilt,
        turn.t,
        turn.yaw_rate,
        turn.start,
        turn.end,
        turn.max_tilt,
    )
}

/// Rows of numbers.
fn in_rows<'py, const COLUMNS: usize>(
    py: Python<'py>,
    rows: &[[f64; COLUMNS]],
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    rows.concat()
        .into_pyarray(py)
        .reshape([rows.len(), COLUMNS])
}

/// A table with one column for each item of an iterator.
pub fn in_columns<const ROWS: usize>(
    py: Python<'_>,
    columns: impl Iterator<Item = [f64; ROWS]>,
) -> PyResult<Bound<'_, PyArray2<f64>>> {
    let mut all = Vec::new();
    // Internal iteration is faster than repeated calls of `next` on a chain of iterators.
    columns.for_each(|column| all.push(column));
    let count = all.len();
    let mut flat = Vec::with_capacity(ROWS * count);
    for row in 0..ROWS {
        flat.extend(all.iter().map(|column| column[row]));
    }
    flat.into_pyarray(py).reshape([ROWS, count])
}

#[pymethods]
impl CoreMotion {
    /// Time, position and velocity at the accepted steps: the first rows of `nodes`.
    fn poses<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        in_columns(py, self.motion.trajectory.nodes().map(|at| pose(&at)))
    }

    /// All quantities at the accepted steps.
    fn nodes<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        self.table(py, self.motion.trajectory.nodes())
    }

    /// All quantities at the accepted steps and at samples inside each.
    fn samples<'py>(
        &self,
        py: Python<'py>,
        per_step: usize,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        self.table(py, self.motion.trajectory.samples(per_step).into_iter())
    }

    /// Dense output at given times, s.
    fn at<'py>(
        &self,
        py: Python<'py>,
        t: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let t = t.as_array();
        let mut look_up = self.motion.trajectory.look_up();
        self.table(py, t.iter().map(|&t| look_up.at(t)))
    }

    /// The number of steps.
    fn step_count(&self) -> usize {
        self.motion.trajectory.steps()
    }

    /// Dense output at fractions from 0 to 1 of given steps.
    fn inside<'py>(
        &self,
        py: Python<'py>,
        steps: PyReadonlyArray1<'py, i64>,
        fractions: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let (steps, fractions) = (steps.as_array(), fractions.as_array());
        let mut look_up = self.motion.trajectory.look_up();
        let places = steps.iter().zip(fractions.iter());
        self.table(
            py,
            places.filter_map(|(&step, &x)| look_up.inside(usize::try_from(step).ok()?, x)),
        )
    }

    /// Derivatives of the state at times (s) with respect to each parameter, with a row for each of the six quantities
    /// at each time.
    fn jacobian<'py>(
        &self,
        py: Python<'py>,
        t: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let (motion, t) = (&self.motion, t.as_array());
        match self.derivatives()? {
            Derivatives::AtRest(sensitivity) => {
                let at = t.iter().map(|&t| sensitivity.at(motion, t));
                in_rows(py, at.collect::<Vec<_>>().as_flattened())
            }
            Derivatives::Shaken(sensitivity) => {
                let at = t.iter().map(|&t| sensitivity.at(motion, t));
                in_rows(py, at.collect::<Vec<_>>().as_flattened())
            }
        }
    }

    /// Derivatives of the angles of turn with respect to each parameter, with a row for each turn.
    fn turn_jacobian<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        match self.derivatives()? {
            Derivatives::AtRest(sensitivity) => in_rows(py, sensitivity.turns()),
            Derivatives::Shaken(sensitivity) => in_rows(py, sensitivity.turns()),
        }
    }

    /// Derivatives of what became of a shaken body with respect to each parameter: rows for the largest tilt, the times
    /// of uplift and of the end, the displacement of the footprint along x and y and the change of yaw + spin. The row
    /// of an uplift that did not happen is NaN.
    fn outcome_jacobian<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let Derivatives::Shaken(sensitivity) = self.derivatives()? else {
            let why =
                "a motion on a table at rest has no derivatives of what becomes of a shaken body";
            return Err(RimrollError::new_err(why));
        };
        let none = [f64::NAN; SHAKEN_PARAMETERS.len()];
        let [x, y] = sensitivity.residual_displacement();
        let rows = [
            sensitivity.max_tilt(&self.motion),
            sensitivity.uplift_time().unwrap_or(none),
            sensitivity.end_time(),
            x,
            y,
            sensitivity.residual_yaw(),
        ];
        in_rows(py, &rows)
    }

    /// The kinds of the events, and their table.
    fn events<'py>(
        &self,
        py: Python<'py>,
    ) -> PyResult<(Vec<&'static str>, Bound<'py, PyArray2<f64>>)> {
        let events = &self.motion.events;
        let kinds = events.iter().map(|event| event.kind.name()).collect();
        Ok((kinds, self.table(py, events.iter().map(|event| event.at))?))
    }

    /// The phases and the times (s) at which they begin.
    fn phases(&self) -> Vec<(&'static str, f64)> {
        let phases = self.motion.trajectory.phases();
        phases.map(|at| (at.phase.name(), at.t)).collect()
    }

    fn turns(&self) -> Vec<TurnNumbers> {
        self.motion.turns.iter().map(turn_numbers).collect()
    }

    /// The first turn, which a topple or another ending may cut short.
    fn first_turn(&self) -> Option<TurnNumbers> {
        self.motion.first_turn().as_ref().map(turn_numbers)
    }

    /// For each turn: how far the model holds, and which numbers are beyond it.
    fn validity(&self) -> Vec<ValidityNumbers> {
        let numbers = |turn| {
            let validity = self.motion.validity(turn);
            let numbers = (
                validity.gap,
                validity.contact_speed,
                validity.passage_time,
                validity.sound_time,
                validity.force_ratio,
                validity.loss_ratio,
            );
            (numbers, validity.exceeded())
        };
        self.motion.turns.iter().map(numbers).collect()
    }

    #[getter]
    fn status(&self) -> &'static str {
        self.motion.status.name()
    }

    /// The time at which the body overturned, s.
    #[getter]
    fn overturning_time(&self) -> Option<f64> {
        self.motion.overturning_time()
    }

    /// Whether it was not determined whether the body overturns.
    #[getter]
    fn undecided(&self) -> bool {
        self.motion.is_undecided()
    }

    /// Whether the body stands at the end.
    #[getter]
    fn stands(&self) -> bool {
        self.motion.stands()
    }

    /// How it ended, in a sentence with its angles in degrees or radians.
    fn message(&self, degrees: bool) -> String {
        self.motion.ending.sentence(angle_unit(degrees))
    }

    /// (steps, rejected, evaluations)
    #[getter]
    fn work(&self) -> (usize, usize, usize) {
        let work = &self.motion.work;
        (work.steps, work.rejected, work.evaluations)
    }
}

/// The unit of the angles in a sentence.
pub fn angle_unit(degrees: bool) -> AngleUnit {
    match degrees {
        true => AngleUnit::Degrees,
        false => AngleUnit::Radians,
    }
}

#[pyfunction]
#[allow(clippy::too_many_arguments)]
pub fn simulate(
    py: Python<'_>,
    body: BodyArgument,
    start: StateArgument,
    contact_law: ContactLawArgument,
    duration: f64,
    gravity: f64,
    rtol: f64,
    topple_tilt: Option<f64>,
    max_steps: usize,
    progress: Option<Py<PyAny>>,
    jacobian: bool,
    ground: Option<PyRef<'_, CoreGround>>,
    flat: FlatArgument,
) -> PyResult<CoreMotion> {
    let (flat, flat_gap) = flat_landing(&flat)?;
    let options = Options {
        duration,
        gravity,
        rtol,
        topple_tilt,
        flat,
        flat_gap,
        max_steps,
    };
    let ground = ground.map(|ground| Arc::clone(&ground.ground));
    let (body, start, contact_law) = (body.body()?, start.into(), contact_law.contact_law()?);
    followed(py, progress, 1, |mut watch| {
        let motion = simulate_on(ground, &body, &start, contact_law, &options, &mut watch)?;
        let derivatives = match motion.status {
            Status::Interrupted => None,
            _ if jacobian => Derivatives::of(&motion, &mut watch)?,
            _ => None,
        };
        Ok(CoreMotion {
            motion,
            derivatives,
        })
    })
}
