//! Chunks of work on all threads, with their results in order.

use core::ops::ControlFlow;
#[cfg(feature = "threads")]
use rayon::prelude::*;

/// The number of threads of the current thread pool.
pub(crate) fn threads() -> usize {
    #[cfg(feature = "threads")]
    return rayon::current_num_threads();
    #[cfg(not(feature = "threads"))]
    return 1;
}

/// The results of the chunks, which are started in order on the threads of the current thread pool. They end with
/// the first chunk that is incomplete because the watch stopped the computation.
///
/// `work` computes the results of a chunk. It is also given a function that it calls now and then, and stops when
/// that is false. `watch` is called after each chunk with the number of its results, and with 0 by that function.
#[cfg(feature = "threads")]
pub(crate) fn map_in_order<T: Sync, R: Send>(
    chunks: &[&[T]],
    work: impl Fn(&[T], &dyn Fn() -> bool) -> Vec<R> + Sync,
    watch: impl Fn(usize) -> ControlFlow<()> + Sync,
) -> Vec<R> {
    use core::sync::atomic::{AtomicBool, AtomicUsize, Ordering::Relaxed};
    let (next, stopped) = (AtomicUsize::new(0), AtomicBool::new(false));
    let should_continue_after = |count| {
        if watch(count).is_break() {
            stopped.store(true, Relaxed);
        }
        !stopped.load(Relaxed)
    };
    let work_of_thread = || {
        let mut done = Vec::new();
        while !stopped.load(Relaxed) {
            let index = next.fetch_add(1, Relaxed);
            let Some(chunk) = chunks.get(index) else {
                break;
            };
            let results = work(chunk, &|| should_continue_after(0));
            should_continue_after(results.len());
            done.push((index, results));
        }
        done
    };
    let mut done: Vec<_> = (0..threads().min(chunks.len()))
        .into_par_iter()
        .with_max_len(1)
        .flat_map_iter(|_| work_of_thread())
        .collect();
    done.sort_unstable_by_key(|&(index, _)| index);
    let mut all = Vec::with_capacity(chunks.iter().map(|chunk| chunk.len()).sum());
    for ((_, results), chunk) in done.into_iter().zip(chunks) {
        let is_complete = results.len() == chunk.len();
        all.extend(results);
        if !is_complete {
            break;
        }
    }
    all
}

#[cfg(not(feature = "threads"))]
pub(crate) fn map_in_order<T, R>(
    chunks: &[&[T]],
    work: impl Fn(&[T], &dyn Fn() -> bool) -> Vec<R>,
    watch: impl Fn(usize) -> ControlFlow<()>,
) -> Vec<R> {
    let mut all = Vec::with_capacity(chunks.iter().map(|chunk| chunk.len()).sum());
    for chunk in chunks {
        let results = work(chunk, &|| watch(0).is_continue());
        let (count, is_complete) = (results.len(), results.len() == chunk.len());
        all.extend(results);
        if watch(count).is_break() || !is_complete {
            break;
        }
    }
    all
}
