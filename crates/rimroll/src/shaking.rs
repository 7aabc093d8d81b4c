//! Many motions on tables that move, at once on all processors.
//!
//! A motion goes through the same operations alone and in the lanes of a batch. So its result does not depend, to the
//! last bit, on the others, on their order or on the number of threads.

use crate::body::Body;
use crate::contact_law::ContactLaw;
use crate::error::InvalidInput;
use crate::ground::Ground;
use crate::motion::{Options, PreparedMotion, Shaken, shaken_batch};
use crate::parallel::{map_in_order, threads};
use crate::real::LANES;
use crate::state::State;
use core::ops::ControlFlow;
use std::sync::Arc;

/// What one motion begins with.
#[derive(Debug, Clone)]
pub struct Shaking<'a> {
    /// The body.
    pub body: &'a Body,
    /// The start.
    pub start: State,
    /// Friction, restitution and resistance.
    pub contact_law: ContactLaw,
    /// The motion of the table; `None` for a table at rest.
    pub ground: Option<&'a Arc<Ground>>,
    /// A factor on the acceleration of the table.
    pub scale: f64,
    /// The duration of the motion, s, in place of that of the options.
    pub duration: f64,
}

impl Shaking<'_> {
    fn options(&self, options: &Options) -> Options {
        Options {
            duration: self.duration,
            ..*options
        }
    }

    fn check(&self, options: &Options) -> Result<(), InvalidInput> {
        self.contact_law.check()?;
        let options = self.options(options);
        options.checked_standing_or_tilted(self.body, &self.start)?;
        self.contact_law.friction.start(&self.start).map(drop)
    }

    fn prepared(&self, options: &Options) -> PreparedMotion {
        let ground = self.ground.map(|ground| scaled(ground, self.scale));
        let options = self.options(options);
        match PreparedMotion::new(ground, self.body, &self.start, &self.contact_law, &options) {
            Ok(prepared) => prepared,
            Err(_) => unreachable!("the motions have been checked"),
        }
    }
}

fn scaled(ground: &Arc<Ground>, scale: f64) -> Arc<Ground> {
    if scale == 1.0 {
        return Arc::clone(ground);
    }
    Arc::new(ground.scaled(scale))
}

/// The index of the first motion that [`shake_many`] refuses, if there is one.
pub fn first_refused(shakings: &[Shaking<'_>], options: &Options) -> Option<usize> {
    let mut checks = shakings.iter().map(|shaking| shaking.check(options));
    checks.position(|check| check.is_err())
}

/// The outcomes of many motions in order. The work is done on the threads of the current thread pool.
///
/// `watch` is called on these threads after each chunk of motions with their number, and with 0 every few thousand steps. As soon as it
/// breaks, the computation stops. The result then consists of the outcomes from the first motion up to the first one
/// that was not computed.
///
/// # Errors
/// As [`simulate`](crate::simulate), for the first motion that is refused.
pub fn shake_many(
    shakings: &[Shaking<'_>],
    options: &Options,
    watch: impl Fn(usize) -> ControlFlow<()> + Sync,
) -> Result<Vec<Shaken>, InvalidInput> {
    // An empty list does not make invalid options acceptable.
    options.check_numbers()?;
    shakings
        .iter()
        .try_for_each(|shaking| shaking.check(options))?;
    let work = |chunk: &[Shaking<'_>], should_continue: &dyn Fn() -> bool| {
        let prepared: Vec<_> = chunk
            .iter()
            .map(|shaking| shaking.prepared(options))
            .collect();
        shaken_batch(&prepared, should_continue)
    };
    let chunks: Vec<_> = shakings
        .chunks(chunk_size(shakings.len(), threads()))
        .collect();
    Ok(map_in_order(&chunks, work, watch))
}

/// The number of motions in a chunk of work: enough to fill the lanes of both orders, but few enough for all threads.
fn chunk_size(count: usize, threads: usize) -> usize {
    const MAX: usize = 4 * LANES;
    let fair = count.div_ceil(threads).max(1);
    fair.min((2 * LANES).max(count / (4 * threads))).min(MAX)
}
