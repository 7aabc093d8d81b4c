//! Many falls at once, on all processors.
//!
//! Each fall has its own steps and its own clock, and comes out the same to the last bit whatever others
//! there are, in whatever order, on however many threads. Falls of the common kind, under one of the
//! paper's two laws or under dry friction, go sixteen at a time in lanes ([`Lanes`](crate::real::Lanes)):
//!
//! * `carried`: the coordinates that such a fall needs, and their rates, by the laws that hold everywhere;
//! * `lockstep`: one step of sixteen falls, each of its own length;
//! * `pool`: sixteen places; looks into a step where something may have happened, and lands on it by
//!   steps made shorter; a fall that is over gives its place to the next;
//! * `onset`: how slip comes out of rest;
//! * `together`, `dry`: falls under one law, and under dry friction from phase to phase.
//!
//! What is rare, as a flight or a landing on the flat of the base, and every other surface is followed by
//! itself, as [`fall`] does.

mod carried;
mod dry;
mod lockstep;
mod onset;
mod pool;
mod together;
mod trial;

use crate::body::Body;
use crate::error::InvalidInput;
#[cfg(doc)]
use crate::motion::fall;
use crate::motion::{Fall, Options};
use crate::state::State;
use crate::surface::Surface;
use core::ops::ControlFlow;
#[cfg(feature = "threads")]
use rayon::prelude::*;

/// So many falls are one piece of work: together they last some thousandths of a second, and some tenths
/// where all of them are rare.
const PIECE: usize = 512;

/// Follows a body from each start, on its surface, through the first turn; on the threads of the pool
/// that it is called from.
///
/// `watch` is called by these threads after each piece of work with the number of falls in it, and can
/// end the work early: then the falls are those from the first trials on, as far as they are done.
///
/// # Errors
/// As [`simulate`](crate::simulate), for the first trial that is refused.
pub fn ensemble(
    body: &Body,
    trials: &[(State, Surface)],
    options: &Options,
    watch: impl Fn(usize) -> ControlFlow<()> + Sync,
) -> Result<Vec<Fall>, InvalidInput> {
    // Options are checked where nothing starts, too, by a start that no option refuses.
    let any = State {
        tilt: f64::MIN_POSITIVE,
        ..State::default()
    };
    let checked = options.checked(body, &any)?;
    for (start, surface) in trials {
        surface.check()?;
        checked.check(start)?;
    }
    let work = |piece: &[(State, Surface)]| together::together(body, piece, &checked);
    let pieces = done_in_order(trials, work, watch);
    let mut falls = Vec::with_capacity(trials.len());
    falls.extend(pieces.into_iter().map_while(|piece| piece).flatten());
    Ok(falls)
}

/// The results of the pieces of work, which begin in their order; `None` for those that were not begun
/// before the watch ended the work.
#[cfg(feature = "threads")]
fn done_in_order<R: Send>(
    trials: &[(State, Surface)],
    work: impl Fn(&[(State, Surface)]) -> R + Sync,
    watch: impl Fn(usize) -> ControlFlow<()> + Sync,
) -> Vec<Option<R>> {
    use core::sync::atomic::{AtomicBool, AtomicUsize, Ordering::Relaxed};
    let (next, stopped) = (AtomicUsize::new(0), AtomicBool::new(false));
    let pieces: Vec<_> = trials.chunks(PIECE).collect();
    let of_one_thread = || {
        let mut done = Vec::new();
        while !stopped.load(Relaxed) {
            let index = next.fetch_add(1, Relaxed);
            let Some(piece) = pieces.get(index) else {
                break;
            };
            done.push((index, work(piece)));
            if watch(piece.len()).is_break() {
                stopped.store(true, Relaxed);
            }
        }
        done
    };
    let threads = rayon::current_num_threads().min(pieces.len());
    let done: Vec<_> = (0..threads)
        .into_par_iter()
        .with_max_len(1)
        .flat_map_iter(|_| of_one_thread())
        .collect();
    let mut results: Vec<_> = pieces.iter().map(|_| None).collect();
    for (index, result) in done {
        results[index] = Some(result);
    }
    results
}

#[cfg(not(feature = "threads"))]
fn done_in_order<R>(
    trials: &[(State, Surface)],
    work: impl Fn(&[(State, Surface)]) -> R,
    watch: impl Fn(usize) -> ControlFlow<()>,
) -> Vec<Option<R>> {
    let mut going_on = true;
    trials
        .chunks(PIECE)
        .map(|piece| {
            let result = going_on.then(|| work(piece))?;
            going_on = watch(piece.len()).is_continue();
            Some(result)
        })
        .collect()
}
