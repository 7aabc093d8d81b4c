//! Work that Python watches: it reports progress, and Ctrl-C stops it.

#[cfg(target_os = "emscripten")]
mod one_thread;
#[cfg(not(target_os = "emscripten"))]
mod threads;

#[cfg(target_os = "emscripten")]
pub use one_thread::in_threads;
#[cfg(not(target_os = "emscripten"))]
pub use threads::in_threads;

use pyo3::prelude::*;
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering::Relaxed};

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
}
