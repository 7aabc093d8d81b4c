//! Work on the thread of Python where there is no other, as in Pyodide.

use super::Watched;
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;

/// Runs some work on this thread, and then handles Ctrl-C and reports progress. The result includes the
/// exception from Python, if any.
pub fn in_threads<R: Send>(
    py: Python<'_>,
    _threads: usize,
    progress: Option<&Py<PyAny>>,
    work: impl FnOnce(&Watched) -> R + Send,
) -> PyResult<(R, Option<PyErr>)> {
    if rayon::current_thread_index().is_none() {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(1)
            .use_current_thread()
            .build()
            .map_err(|error| PyRuntimeError::new_err(error.to_string()))?;
        // From now on this thread belongs to the pool, which must live as long.
        std::mem::forget(pool);
    }
    let watched = &Watched::default();
    let done = work(watched);
    Ok((done, watched.look(py, progress).err()))
}
