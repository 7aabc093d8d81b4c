//! One motion that Python watches: it reports the time reached, and Ctrl-C stops it.

use crate::arguments::refusal;
use pyo3::prelude::*;
use rimroll::InvalidInput;
use std::ops::ControlFlow;

/// Follows a motion on this thread, which lets other threads of Python run meanwhile.
///
/// `follow` calls what it is given after each step, with the time reached. Signals and `progress` are served at every
/// `every`-th call. An exception that they raise stops the computation and is returned.
pub fn followed<T: Send>(
    py: Python<'_>,
    progress: Option<Py<PyAny>>,
    every: usize,
    follow: impl FnOnce(&mut dyn FnMut(f64) -> ControlFlow<()>) -> Result<T, InvalidInput> + Send,
) -> PyResult<T> {
    // An exception raised by a signal handler (KeyboardInterrupt for Ctrl-C) or by `progress`.
    let mut raised = None;
    let report = |t: f64| {
        Python::attach(|py| {
            py.check_signals()?;
            progress
                .as_ref()
                .map_or(Ok(()), |call| call.call1(py, (t,)).map(drop))
        })
    };
    let mut steps = 0_usize;
    let mut watch = |t| {
        steps += 1;
        if !steps.is_multiple_of(every) {
            return ControlFlow::Continue(());
        }
        match report(t) {
            Ok(()) => ControlFlow::Continue(()),
            Err(error) => {
                raised = Some(error);
                ControlFlow::Break(())
            }
        }
    };
    let done = py.detach(|| follow(&mut watch));
    match raised {
        Some(error) => Err(error),
        None => done.map_err(refusal),
    }
}
