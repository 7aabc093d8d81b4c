//! Many falls at once, on all processors.
//!
//! Each fall has its own steps and its own clock, and comes out the same to the last bit whatever others
//! there are, in whatever order, on however many threads. Falls of the common kind, under one of the
//! paper's two laws or under dry friction, go sixteen at a time in lanes ([`Lanes`](crate::real::Lanes)):
//!
//! * `chunk`, `limits`: some of the trials, with the numbers of each body, and what a fall must not cross unseen;
//! * `reduced_system`: the coordinates that such a fall needs, and their rates, by the laws that hold everywhere;
//! * `lockstep`: one step of sixteen falls, each of its own body, friction and length;
//! * `pool`: sixteen places; looks into a step where something may have happened, and lands on it by
//!   steps made shorter; a fall that is over gives its place to the next;
//! * `onset`: how slip comes out of rest;
//! * `batch`, `dry`: falls under one law, and under dry friction from phase to phase.
//!
//! What is rare, as a flight or a landing on the flat of the base, and every other surface is followed by
//! itself, as [`fall`] does.

mod batch;
mod chunk;
mod dry;
mod limits;
mod lockstep;
mod onset;
mod pool;
mod reduced_system;
mod trial;

use self::batch::{batch, fits_lanes};
use crate::body::Body;
use crate::contact_law::ContactLaw;
use crate::error::InvalidInput;
#[cfg(doc)]
use crate::motion::fall;
use crate::motion::{Fall, Options};
use crate::state::State;
use core::ops::ControlFlow;
#[cfg(feature = "threads")]
use rayon::prelude::*;

/// The most falls that are one piece of work: in lanes they are over in some hundredths of a second, before which
/// the work does not end.
const MAX_CHUNK: usize = 1024;

/// The fewest: toward its end more and more lanes are empty.
const MIN_CHUNK: usize = 128;

/// A fall that goes by itself anyway counts as so many: as a rule it takes as long as some dozens in lanes, and
/// under some laws far longer.
const SCALAR_COST: usize = 32;

/// A trial: what is let go, from where and on what.
pub type Release<'a> = (&'a Body, State, ContactLaw);

/// Follows each body from its start, on its surface, through the first turn; on the threads of the pool
/// that it is called from. Rows of one body are somewhat faster side by side than mixed with others.
///
/// `watch` is called by these threads after each piece of work with the number of falls in it, with 0 before
/// each fall that is followed by itself, and can end the work early, from the first time that it says so: then
/// the falls are those from the first trials on, as far as they are done without a gap.
///
/// # Errors
/// As [`simulate`](crate::simulate), for the first trial that is refused.
pub fn ensemble(
    trials: &[Release<'_>],
    options: &Options,
    watch: impl Fn(usize) -> ControlFlow<()> + Sync,
) -> Result<Vec<Fall>, InvalidInput> {
    for (.., contact_law) in trials {
        contact_law.check()?;
    }
    options.check_all(trials.iter().map(|&(body, start, _)| (body, start)))?;
    let work = |chunk: &[Release<'_>], should_continue: &dyn Fn() -> bool| {
        batch(chunk, options, should_continue)
    };
    Ok(done_in_order(trials, work, watch))
}

/// The trials as pieces of work for some threads: the last are small, so that no thread waits long for another.
fn chunks<'a>(
    mut trials: &'a [Release<'a>],
    threads: usize,
) -> impl Iterator<Item = &'a [Release<'a>]> {
    core::iter::from_fn(move || {
        // One thread waits for none.
        let full = match threads {
            1 => MAX_CHUNK,
            _ => (trials.len() / (4 * threads)).clamp(MIN_CHUNK, MAX_CHUNK),
        };
        let mut size = 0;
        let taken = trials.iter().take_while(|(.., contact_law)| {
            let goes_in = size < full;
            size += if fits_lanes(contact_law) {
                1
            } else {
                SCALAR_COST
            };
            goes_in
        });
        let chunk = trials.split_off(..taken.count())?;
        (!chunk.is_empty()).then_some(chunk)
    })
}

/// The results of the pieces of work, which begin in their order, up to the first that was cut short when the
/// watch ended the work.
#[cfg(feature = "threads")]
fn done_in_order<R: Send>(
    trials: &[Release<'_>],
    work: impl Fn(&[Release<'_>], &dyn Fn() -> bool) -> Vec<R> + Sync,
    watch: impl Fn(usize) -> ControlFlow<()> + Sync,
) -> Vec<R> {
    use core::sync::atomic::{AtomicBool, AtomicUsize, Ordering::Relaxed};
    let (next, stopped) = (AtomicUsize::new(0), AtomicBool::new(false));
    let continues_after = |count| {
        if watch(count).is_break() {
            stopped.store(true, Relaxed);
        }
        !stopped.load(Relaxed)
    };
    let threads = rayon::current_num_threads();
    let chunks: Vec<_> = chunks(trials, threads).collect();
    let of_one_thread = || {
        let mut done = Vec::new();
        while !stopped.load(Relaxed) {
            let index = next.fetch_add(1, Relaxed);
            let Some(chunk) = chunks.get(index) else {
                break;
            };
            let results = work(chunk, &|| continues_after(0));
            continues_after(results.len());
            done.push((index, results));
        }
        done
    };
    let mut done: Vec<_> = (0..threads.min(chunks.len()))
        .into_par_iter()
        .with_max_len(1)
        .flat_map_iter(|_| of_one_thread())
        .collect();
    done.sort_unstable_by_key(|&(index, _)| index);
    let mut all = Vec::with_capacity(trials.len());
    for ((_, results), chunk) in done.into_iter().zip(&chunks) {
        let is_whole = results.len() == chunk.len();
        all.extend(results);
        if !is_whole {
            break;
        }
    }
    all
}

#[cfg(not(feature = "threads"))]
fn done_in_order<R>(
    trials: &[Release<'_>],
    work: impl Fn(&[Release<'_>], &dyn Fn() -> bool) -> Vec<R>,
    watch: impl Fn(usize) -> ControlFlow<()>,
) -> Vec<R> {
    let mut all = Vec::with_capacity(trials.len());
    for chunk in chunks(trials, 1) {
        let results = work(chunk, &|| watch(0).is_continue());
        let (count, is_whole) = (results.len(), results.len() == chunk.len());
        all.extend(results);
        if watch(count).is_break() || !is_whole {
            break;
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::{MAX_CHUNK, MIN_CHUNK, Release, SCALAR_COST, chunks};
    use crate::body::Body;
    use crate::contact_law::ContactLaw;
    use crate::law::FrictionLaw;
    use crate::law::IdealLaw;
    use crate::law::Viscous;
    use crate::state::State;

    fn can() -> Body {
        crate::presets::can_2007().expect("the paper's can")
    }

    fn trials(body: &Body, count: usize, contact_law: impl Into<ContactLaw>) -> Vec<Release<'_>> {
        let contact_law = contact_law.into();
        let numbered = |i| State {
            tilt: i as f64,
            ..State::default()
        };
        (0..count)
            .map(|i| (body, numbered(i), contact_law.clone()))
            .collect()
    }

    #[test]
    fn pieces_are_all_of_the_trials_in_order_and_end_small() {
        let can = can();
        for (count, threads) in [(0, 2), (1, 2), (1000, 2), (54_321, 2), (54_321, 32)] {
            let trials = trials(&can, count, IdealLaw::NoSlip);
            let chunks: Vec<_> = chunks(&trials, threads).collect();
            assert_eq!(chunks.concat(), trials);
            let sizes: Vec<usize> = chunks.iter().map(|chunk| chunk.len()).collect();
            assert!(sizes.is_sorted_by(|a, b| a >= b), "{sizes:?}");
            assert!(sizes.iter().all(|&size| size <= MAX_CHUNK), "{sizes:?}");
            assert!(
                sizes.last().is_none_or(|&last| last <= MIN_CHUNK),
                "{sizes:?}"
            );
        }
    }

    #[test]
    fn falls_that_go_by_themselves_are_few_in_a_piece() {
        let viscous = FrictionLaw::Viscous(Viscous { coefficient: 1.0 });
        let can = can();
        let trials = trials(&can, 1000, viscous);
        let chunks: Vec<_> = chunks(&trials, 2).collect();
        assert_eq!(chunks.concat(), trials);
        let most = chunks.iter().map(|chunk| chunk.len()).max();
        assert_eq!(most, Some(MIN_CHUNK / SCALAR_COST));
    }

    #[test]
    fn falls_of_both_kinds_share_the_pieces() {
        let viscous = FrictionLaw::Viscous(Viscous { coefficient: 1.0 });
        let can = can();
        let rolling = trials(&can, 3000, IdealLaw::NoSlip);
        // Every tenth goes by itself.
        let trials: Vec<_> = rolling
            .iter()
            .enumerate()
            .map(|(i, (body, start, contact_law))| match i % 10 {
                0 => (*body, *start, ContactLaw::from(&viscous)),
                _ => (*body, *start, contact_law.clone()),
            })
            .collect();
        for (threads, full) in [(1, MAX_CHUNK), (2, 3000 / 8), (8, MIN_CHUNK)] {
            let chunks: Vec<_> = chunks(&trials, threads).collect();
            assert_eq!(chunks.concat(), trials);
            let alone_in = |chunk: &[Release<'_>]| {
                let alone = chunk
                    .iter()
                    .filter(|(.., contact_law)| contact_law.friction == viscous);
                alone.count()
            };
            assert!(alone_in(chunks[0]) > 0 && alone_in(chunks[0]) < chunks[0].len());
            // The last of a piece may be one that takes it beyond what is full.
            for chunk in chunks {
                let size = chunk.len() + (SCALAR_COST - 1) * alone_in(chunk);
                assert!(size < full + SCALAR_COST, "{size} on {threads}");
            }
        }
    }

    #[cfg(feature = "threads")]
    #[test]
    fn the_work_can_be_ended_amid_falls_that_go_by_themselves() {
        use super::ensemble;
        use crate::motion::Options;
        use core::ops::ControlFlow;
        use core::sync::atomic::{AtomicUsize, Ordering::Relaxed};

        let can = can();
        let trials: Vec<_> = trials(
            &can,
            100,
            FrictionLaw::Viscous(Viscous { coefficient: 1.0 }),
        )
        .into_iter()
        .map(|(body, start, contact_law)| (body, State { tilt: 0.3, ..start }, contact_law))
        .collect();
        let go_on = |_| ControlFlow::Continue(());
        let whole = ensemble(&trials, &Options::default(), go_on).expect("valid starts");
        let result = AtomicUsize::new(0);
        let watch = |falls| match result.fetch_add(usize::from(falls == 0), Relaxed) {
            0..6 => ControlFlow::Continue(()),
            _ => ControlFlow::Break(()),
        };
        let stopped = || ensemble(&trials, &Options::default(), watch);
        let one_thread = rayon::ThreadPoolBuilder::new().num_threads(1).build();
        let falls = one_thread.expect("a pool").install(stopped);
        assert_eq!(falls.expect("valid starts"), whole[..6]);
    }
}
