//! Work on other threads while this one serves Python.

use super::Watched;
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use std::sync::atomic::Ordering::Relaxed;
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::Duration;

/// Runs some work on a pool of threads (0 means one per processor), while this thread handles Ctrl-C and
/// reports progress about ten times a second. The result includes the exception that stopped the work, if any.
pub fn in_threads<R: Send>(
    py: Python<'_>,
    threads: usize,
    progress: Option<&Py<PyAny>>,
    work: impl FnOnce(&Watched) -> R + Send,
) -> PyResult<(R, Option<PyErr>)> {
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .build()
        .map_err(|error| PyRuntimeError::new_err(error.to_string()))?;
    let watched = &Watched::default();
    let (done, stopped) = py.detach(|| {
        std::thread::scope(|scope| {
            let (sender, receiver) = channel();
            let done = scope.spawn(|| {
                let done = pool.install(|| work(watched));
                drop(sender);
                done
            });
            let stopped = watched.until_done(&receiver, progress);
            (done.join(), stopped)
        })
    });
    let done =
        done.map_err(|_| PyRuntimeError::new_err("internal error: a worker thread panicked"))?;
    Ok((done, stopped))
}

impl Watched {
    /// Waits for the work, handles Ctrl-C and reports progress. An exception from Python stops the work and
    /// is returned.
    fn until_done(&self, receiver: &Receiver<()>, progress: Option<&Py<PyAny>>) -> Option<PyErr> {
        const POLLING_INTERVAL: Duration = Duration::from_millis(100);
        let mut stopped = None;
        loop {
            let over = receiver.recv_timeout(POLLING_INTERVAL) != Err(RecvTimeoutError::Timeout);
            if stopped.is_none() {
                stopped = Python::attach(|py| self.look(py, progress)).err();
                self.stop.store(stopped.is_some(), Relaxed);
            }
            if over {
                return stopped;
            }
        }
    }
}
