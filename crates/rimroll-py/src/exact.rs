//! Turns by quadrature.

use crate::arguments::{BodyArgument, ideal_law, refusal};
use crate::ensemble::{StartsArgument, Watched};
use numpy::{IntoPyArray, PyArray1, PyArray2, PyArrayMethods};
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use rimroll::State;
use rimroll::motion::PARAMETERS;
use rimroll::turn::exact::{Ending, Exact, ExactTurn};
use std::sync::mpsc::channel;

/// What is told of a turn, in the order of [`numbers`].
pub const EXACT_COLUMNS: [&str; 6] = ["turn", "min_tilt", "max_tilt", "min_time", "time", "yaw"];

fn numbers(turn: &ExactTurn) -> [f64; EXACT_COLUMNS.len()] {
    [
        turn.turn,
        turn.min_tilt,
        turn.max_tilt,
        turn.min_time,
        turn.time,
        turn.yaw,
    ]
}

/// The endings by name, in the order of their codes.
pub fn statuses() -> Vec<&'static str> {
    Ending::ALL.map(Ending::name).to_vec()
}

type Table<'py> = Bound<'py, PyArray2<f64>>;

/// Codes of the endings, a table with one row a start and a column for each of [`EXACT_COLUMNS`], and
/// if asked for another with the turn's derivative by each of [`PARAMETERS`]. `threads` = 0 means as
/// many as there are processors. Ctrl-C stops the work.
#[pyfunction]
#[allow(clippy::too_many_arguments)]
pub fn exact_turns<'py>(
    py: Python<'py>,
    body: BodyArgument,
    starts: StartsArgument<'py>,
    law_name: &str,
    gravity: f64,
    topple_tilt: Option<f64>,
    threads: usize,
    jacobian: bool,
) -> PyResult<(Bound<'py, PyArray1<u8>>, Table<'py>, Option<Table<'py>>)> {
    let exact = Exact::new(&body.body()?, ideal_law(law_name)?, gravity, topple_tilt);
    let exact = exact.map_err(refusal)?;
    let starts: Vec<State> = starts.starts().collect();
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .build()
        .map_err(|error| PyRuntimeError::new_err(error.to_string()))?;
    let watched = Watched::default();
    let work = || {
        let goes_on = || watched.count(0).is_continue();
        let slopes = jacobian.then(|| exact.turn_slopes_while(&starts, goes_on));
        let turns = exact.turns_while(&starts, goes_on)?;
        Ok((turns.unwrap_or_default(), slopes.transpose()?.flatten()))
    };
    let (done, stopped) = py.detach(|| {
        std::thread::scope(|scope| {
            let (tell, told) = channel();
            let done = scope.spawn(|| {
                let done = pool.install(work);
                drop(tell);
                done
            });
            let stopped = watched.until_done(&told, None);
            (done.join(), stopped)
        })
    });
    if let Some(stopped) = stopped {
        return Err(stopped);
    }
    let (turns, slopes) = done
        .map_err(|_| PyRuntimeError::new_err("the quadrature has come to grief"))?
        .map_err(refusal)?;
    let code = |turn: &ExactTurn| Ending::ALL.iter().position(|&ending| ending == turn.ending);
    let codes: Vec<u8> = turns
        .iter()
        .map(|turn| code(turn).unwrap_or(0) as u8)
        .collect();
    let rows = turns.len();
    let table = turns.iter().flat_map(numbers).collect();
    let slopes = slopes.map(|slopes| slopes.into_iter().flatten().collect());
    Ok((
        codes.into_pyarray(py),
        reshaped(py, table, rows, EXACT_COLUMNS.len())?,
        slopes
            .map(|slopes| reshaped(py, slopes, rows, PARAMETERS.len()))
            .transpose()?,
    ))
}

fn reshaped(py: Python<'_>, numbers: Vec<f64>, rows: usize, columns: usize) -> PyResult<Table<'_>> {
    numbers.into_pyarray(py).reshape([rows, columns])
}
