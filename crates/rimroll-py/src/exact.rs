//! Turns by quadrature.

use crate::arguments::{BodiesArgument, ideal_law, of_row, refusal};
use crate::ensemble::StartsArgument;
use crate::watched::in_threads;
use numpy::{IntoPyArray, PyArray2, PyArrayMethods};
use pyo3::prelude::*;
use rayon::prelude::*;
use rimroll::motion::PARAMETERS;
use rimroll::turn::exact::{ExactRows, ExactTurn, turn_in_place};
use rimroll::{Body, FrictionLaw, State};

/// The numbers of a turn, in the order of [`numbers`].
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

type Table<'py> = Bound<'py, PyArray2<f64>>;

/// Two rows of indices into `OUTCOMES` (the ending of each turn, and the final outcome of the body); a table
/// with one column per start and a row for each of [`EXACT_COLUMNS`]; and, on request, another table with the
/// derivatives of the turn with respect to each of [`PARAMETERS`], for the two ideal laws only. `threads` = 0 means one
/// per processor. Ctrl-C stops the work.
#[pyfunction]
#[allow(clippy::too_many_arguments)]
pub fn exact_turns<'py>(
    py: Python<'py>,
    bodies: BodiesArgument<'py>,
    starts: StartsArgument<'py>,
    law_name: &str,
    gravity: f64,
    topple_tilt: Option<f64>,
    threads: usize,
    jacobian: bool,
) -> PyResult<(Bound<'py, PyArray2<u8>>, Table<'py>, Option<Table<'py>>)> {
    let bodies = bodies.bodies()?;
    let in_place = law_name == FrictionLaw::InPlace.name();
    let law = (!in_place).then(|| ideal_law(law_name)).transpose()?;
    let columns = starts.columns()?;
    let (results, stopped) = in_threads(py, threads, None, |watched| {
        let should_continue = || watched.count(0).is_continue();
        let rows: Vec<_> = (0..columns[0].len())
            .into_par_iter()
            .map(|row| {
                let start = State::from_numbers(columns.map(|column| column[row]));
                (of_row(&bodies, row), start)
            })
            .collect();
        let (turns, slopes) = match law {
            Some(law) => {
                let exact = ExactRows::new(law, gravity, topple_tilt, &rows);
                let slopes = jacobian.then(|| exact.turn_slopes_while(should_continue));
                let slopes = slopes.transpose()?.flatten();
                (exact.turns_while(should_continue)?, slopes)
            }
            None => {
                let turn = |&(body, ref start): &(&Body, State)| {
                    let turn = || turn_in_place(body, start, gravity, topple_tilt);
                    should_continue().then(turn).transpose()
                };
                // Row by row, so that the error is that of the first row which is refused.
                let turns: Vec<Result<_, _>> = rows.par_iter().map(turn).collect();
                (turns.into_iter().collect::<Result<_, _>>()?, None)
            }
        };
        let turns: Vec<ExactTurn> = turns.unwrap_or_default();
        let codes = |turn: &ExactTurn| [turn.ending as u8, turn.outcome as u8];
        Ok(Results {
            codes: by_columns(&turns, codes),
            table: by_columns(&turns, numbers),
            slopes: slopes.map(|slopes| by_columns(&slopes, |slopes| *slopes)),
        })
    })?;
    if let Some(stopped) = stopped {
        return Err(stopped);
    }
    let results: Results = results.map_err(refusal)?;
    let count = results.codes.len() / 2;
    let reshaped = |table: Vec<f64>, rows| table.into_pyarray(py).reshape([rows, count]);
    Ok((
        results.codes.into_pyarray(py).reshape([2, count])?,
        reshaped(results.table, EXACT_COLUMNS.len())?,
        results
            .slopes
            .map(|slopes| reshaped(slopes, PARAMETERS.len()))
            .transpose()?,
    ))
}

/// The results of the turns, as tables with one row per quantity.
struct Results {
    codes: Vec<u8>,
    table: Vec<f64>,
    slopes: Option<Vec<f64>>,
}

/// The transposed table: the first number of all items, then the second of all items, and so on.
fn by_columns<T: Sync, U: Copy + Default + Send, const N: usize>(
    many: &[T],
    numbers: impl Fn(&T) -> [U; N] + Sync,
) -> Vec<U> {
    let mut table = vec![U::default(); N * many.len()];
    let rows = table.par_chunks_mut(many.len().max(1)).enumerate();
    rows.for_each(|(row, places)| {
        for (place, one) in places.iter_mut().zip(many) {
            *place = numbers(one)[row];
        }
    });
    table
}
