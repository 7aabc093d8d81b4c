//! Ensembles: many falls at once, on all processors.
//!
//! Each fall has its own steps and its own time transformation. Its result does not depend, to the last
//! bit, on the other falls, on their order or on the number of threads. Falls under one of the paper's two
//! laws or under dry friction are computed in batches of sixteen lanes ([`Lanes`](crate::real::Lanes)):
//!
//! * `chunk` holds a chunk of work, the parameters of its bodies, the bounds of a fall and a fall in progress;
//! * `reduced_system` defines the coordinates that a batch carries and their rates under the common laws;
//! * `lockstep` makes one step of sixteen falls, each with its own body, friction and step size;
//! * `pool` keeps sixteen lanes filled: it locates the events of a step by shorter steps and replaces each
//!   completed fall by the next one;
//! * `slip_onset` integrates slip from rest;
//! * `dry_friction` computes the falls under dry friction with their changes of phase.
//!
//! All other falls, for example those that fly, land flat on the base or have another contact law, are left
//! to the scalar solver, [`fall`].

mod chunk;
mod dry_friction;
mod lockstep;
mod pool;
mod reduced_system;
mod slip_onset;

pub use chunk::Setup;

use crate::contact_law::ContactLaw;
use crate::error::InvalidInput;
use crate::law::{Coulomb, FrictionLaw};
use crate::motion::{Fall, Options, Status, fall};
use crate::parallel::{map_in_order, threads};
use crate::real::LANES;
use crate::state::Coordinates;
use chunk::{ActiveFall, BodyNumbers, Chunk};
use core::ops::ControlFlow;
use dry_friction::Dry;
use pool::{Exit, Pool};
use reduced_system::{ReducedFrictionless, ReducedNoSlip, ReducedSystem};

/// The maximal size of a chunk of work. In lanes it takes a few hundredths of a second, and the computation can
/// only be stopped after it.
const MAX_CHUNK: usize = 1024;

/// The minimal size of a chunk of work, because lanes stay empty toward the end of a chunk.
const MIN_CHUNK: usize = 128;

/// The weight of a scalar fall in the size of a chunk. It usually takes as long as a few dozen falls in lanes,
/// and far longer under some laws.
const SCALAR_COST: usize = 32;

/// Simulates each body from its start, under its contact law, through the first turn. The work is done on the
/// threads of the current thread pool. Setups with the same body are somewhat faster if they are adjacent.
///
/// `watch` is called on these threads after each chunk of work with the number of falls in it, and with 0
/// before each scalar fall. As soon as it breaks, the computation stops. The result then consists of the falls
/// from the first setup up to the first one that was not computed.
///
/// # Errors
/// As [`simulate`](crate::simulate), for the first setup that is refused.
pub fn ensemble(
    setups: &[Setup<'_>],
    options: &Options,
    watch: impl Fn(usize) -> ControlFlow<()> + Sync,
) -> Result<Vec<Fall>, InvalidInput> {
    for (.., contact_law) in setups {
        contact_law.check()?;
    }
    let starts = setups.iter().map(|&(body, start, _)| (body, start));
    options.check_all(starts, |index| {
        setups[index].2.friction == FrictionLaw::InPlace
    })?;
    let work = |chunk: &[Setup<'_>], should_continue: &dyn Fn() -> bool| {
        batch(chunk, options, should_continue)
    };
    let chunks: Vec<_> = chunks(setups, threads()).collect();
    Ok(map_in_order(&chunks, work, watch))
}

/// Divides the setups into chunks of work. The last chunks are small, so that no thread waits long for another.
fn chunks<'a>(
    mut setups: &'a [Setup<'a>],
    threads: usize,
) -> impl Iterator<Item = &'a [Setup<'a>]> {
    core::iter::from_fn(move || {
        // A single thread never waits.
        let full = match threads {
            1 => MAX_CHUNK,
            _ => (setups.len() / (4 * threads)).clamp(MIN_CHUNK, MAX_CHUNK),
        };
        let mut size = 0;
        let taken = setups.iter().take_while(|(.., contact_law)| {
            let fits = size < full;
            size += if fits_lanes(contact_law) {
                1
            } else {
                SCALAR_COST
            };
            fits
        });
        let chunk = setups.split_off(..taken.count())?;
        (!chunk.is_empty()).then_some(chunk)
    })
}

/// Whether falls under a contact law can be computed in lanes.
fn fits_lanes(contact_law: &ContactLaw) -> bool {
    use FrictionLaw::{Coulomb, Frictionless, NoSlip};
    matches!(contact_law.friction, NoSlip | Frictionless | Coulomb { .. }) && !contact_law.resists()
}

/// The falls of a chunk of setups in order. When `should_continue` returns false before a scalar fall, the result
/// ends before that fall. The options and the setups must have been checked.
fn batch(setups: &[Setup<'_>], options: &Options, should_continue: &dyn Fn() -> bool) -> Vec<Fall> {
    let mut falls = Falls {
        chunk: Chunk::new(setups, options),
        done: vec![None; setups.len()],
    };
    falls.conservative::<ReducedNoSlip<f64, false>>(FrictionLaw::NoSlip);
    falls.conservative::<ReducedFrictionless<f64>>(FrictionLaw::Frictionless);
    let dry = |(_, _, contact_law): &Setup<'_>| {
        matches!(contact_law.friction, FrictionLaw::Coulomb(Coulomb { .. }))
            && fits_lanes(contact_law)
    };
    if setups.iter().any(dry) {
        let waiting = (0..setups.len()).filter(|&index| dry(&setups[index]));
        Dry::new(&falls.chunk, &mut falls.done).follow(waiting);
    }
    (0..setups.len())
        .map_while(|index| {
            falls.done[index]
                .take()
                .or_else(|| should_continue().then(|| falls.scalar_fall(index)))
        })
        .collect()
}

struct Falls<'a> {
    chunk: Chunk<'a>,
    done: Vec<Option<Fall>>,
}

impl Falls<'_> {
    fn scalar_fall(&self, index: usize) -> Fall {
        let (body, start, contact_law) = &self.chunk.setups[index];
        match fall(body, start, contact_law, self.chunk.options) {
            Ok(fall) => fall,
            Err(_) => unreachable!("the setups have been checked"),
        }
    }

    /// Computes all falls under one of the paper's two laws.
    fn conservative<A: ReducedSystem<f64, 7>>(&mut self, law: FrictionLaw) {
        let Falls { chunk, done } = self;
        let bounds = &chunk.bounds;
        let waiting = (0..chunk.setups.len()).filter(|&index| {
            let (.., contact_law) = &chunk.setups[index];
            contact_law.friction == law && fits_lanes(contact_law)
        });
        let mut waiting = waiting.peekable();
        let Some(&first) = waiting.peek() else { return };
        let mut pool: Pool<'_, A, 7> = Pool::new(chunk.body(first), bounds);
        let new_contact = |body: &BodyNumbers| (body.place, A::new(body.parameters, 0.0));
        let mut contact = new_contact(chunk.body(first));
        loop {
            while pool.len() < LANES {
                let Some(index) = waiting.next() else { break };
                let (_, start, _) = &chunk.setups[index];
                let (u, body) = (Coordinates::from_state(start), chunk.body(index));
                if contact.0 != body.place {
                    contact = new_contact(body);
                }
                if bounds.are_far_from(&u, &body.topple)
                    && contact.1.contact_margin(&A::project(&u)) > 0.0
                {
                    let fall = ActiveFall::new(index, &u, law != FrictionLaw::NoSlip);
                    pool.put(fall, &u, (body, 0.0), body.error_scale.first_step(&u));
                }
            }
            if pool.len() == 0 {
                return;
            }
            pool.step(|fall, exit, at| {
                let status = match exit {
                    Exit::Over(status) => status,
                    Exit::ContactEnds => Status::LiftedOff,
                    Exit::SlipEnds | Exit::NeedsScalar => return,
                };
                done[fall.index] =
                    Some(fall.result(&chunk.body(fall.index).parameters, status, at));
            });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{MAX_CHUNK, MIN_CHUNK, SCALAR_COST, Setup, chunks};
    use crate::body::Body;
    use crate::contact_law::ContactLaw;
    use crate::law::FrictionLaw;
    use crate::law::IdealLaw;
    use crate::law::Viscous;
    use crate::state::State;

    fn can() -> Body {
        crate::presets::can_2007().expect("the paper's can")
    }

    fn setups(body: &Body, count: usize, contact_law: impl Into<ContactLaw>) -> Vec<Setup<'_>> {
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
    fn chunks_cover_all_setups_in_order_and_shrink_toward_the_end() {
        let can = can();
        for (count, threads) in [(0, 2), (1, 2), (1000, 2), (54_321, 2), (54_321, 32)] {
            let setups = setups(&can, count, IdealLaw::NoSlip);
            let chunks: Vec<_> = chunks(&setups, threads).collect();
            assert_eq!(chunks.concat(), setups);
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
    fn a_chunk_holds_fewer_scalar_falls() {
        let viscous = FrictionLaw::Viscous(Viscous { coefficient: 1.0 });
        let can = can();
        let setups = setups(&can, 1000, viscous);
        let chunks: Vec<_> = chunks(&setups, 2).collect();
        assert_eq!(chunks.concat(), setups);
        let largest = chunks.iter().map(|chunk| chunk.len()).max();
        assert_eq!(largest, Some(MIN_CHUNK / SCALAR_COST));
    }

    #[test]
    fn a_chunk_can_mix_scalar_falls_with_falls_in_lanes() {
        let viscous = FrictionLaw::Viscous(Viscous { coefficient: 1.0 });
        let can = can();
        let rolling = setups(&can, 3000, IdealLaw::NoSlip);
        // Every tenth fall is scalar.
        let setups: Vec<_> = rolling
            .iter()
            .enumerate()
            .map(|(i, (body, start, contact_law))| match i % 10 {
                0 => (*body, *start, ContactLaw::from(&viscous)),
                _ => (*body, *start, contact_law.clone()),
            })
            .collect();
        for (threads, full) in [(1, MAX_CHUNK), (2, 3000 / 8), (8, MIN_CHUNK)] {
            let chunks: Vec<_> = chunks(&setups, threads).collect();
            assert_eq!(chunks.concat(), setups);
            let scalar_falls = |chunk: &[Setup<'_>]| {
                let scalar = chunk
                    .iter()
                    .filter(|(.., contact_law)| contact_law.friction == viscous);
                scalar.count()
            };
            assert!(scalar_falls(chunks[0]) > 0 && scalar_falls(chunks[0]) < chunks[0].len());
            // A scalar fall at the end of a chunk may exceed the intended size.
            for chunk in chunks {
                let size = chunk.len() + (SCALAR_COST - 1) * scalar_falls(chunk);
                assert!(size < full + SCALAR_COST, "{size} on {threads} threads");
            }
        }
    }

    #[cfg(feature = "threads")]
    #[test]
    fn the_computation_can_be_stopped_between_scalar_falls() {
        use super::ensemble;
        use crate::motion::Options;
        use core::ops::ControlFlow;
        use core::sync::atomic::{AtomicUsize, Ordering::Relaxed};

        let can = can();
        let setups: Vec<_> = setups(
            &can,
            100,
            FrictionLaw::Viscous(Viscous { coefficient: 1.0 }),
        )
        .into_iter()
        .map(|(body, start, contact_law)| (body, State { tilt: 0.3, ..start }, contact_law))
        .collect();
        let never_stop = |_| ControlFlow::Continue(());
        let all = ensemble(&setups, &Options::default(), never_stop).expect("valid starts");
        let scalar_falls = AtomicUsize::new(0);
        let watch = |falls| match scalar_falls.fetch_add(usize::from(falls == 0), Relaxed) {
            0..6 => ControlFlow::Continue(()),
            _ => ControlFlow::Break(()),
        };
        let stopped = || ensemble(&setups, &Options::default(), watch);
        let one_thread = rayon::ThreadPoolBuilder::new().num_threads(1).build();
        let falls = one_thread.expect("a pool").install(stopped);
        assert_eq!(falls.expect("valid starts"), all[..6]);
    }
}
