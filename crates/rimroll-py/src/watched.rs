//! Work that Python watches: it reports progress, and Ctrl-C stops it.

use crate::arguments::refusal;
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use rimroll::InvalidInput;
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering::Relaxed};
#[cfg(not(target_os = "emscripten"))]
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
#[cfg(not(target_os = "emscripten"))]
use std::time::Duration;

/// Work of which Python knows how much is done, and which it can stop.
#[derive(Default)]
pub struct Watched {
    done: AtomicUsize,
    stop: AtomicBool,
}

impl Watched {
    pub fn count(&self, falls: usize) -> ControlFlow<()> {
        self.done.fetch_add(falls, Relaxed);
        if self.stop.load(Relaxed) {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    }

    fn look(&self, py: Python<'_>, progress: Option<&Py<PyAny>>) -> PyResult<()> {
        py.check_signals()?;
        if let Some(progress) = progress {
            progress.call1(py, (self.done.load(Relaxed),))?;
        }
        Ok(())
    }

    /// Waits for the work, handles Ctrl-C and reports progress. An exception from Python stops the work and
    /// is returned.
    #[cfg(not(target_os = "emscripten"))]
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

/// Runs some work on a pool of threads (0 means one per processor), while this thread handles Ctrl-C and
/// reports progress about ten times a second. The result includes the exception that stopped the work, if any.
#[cfg(not(target_os = "emscripten"))]
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

/// Runs some work on the thread of Python where there is no other, as in Pyodide, and then handles Ctrl-C and
/// reports progress. The result includes the exception from Python, if any.
#[cfg(target_os = "emscripten")]
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
