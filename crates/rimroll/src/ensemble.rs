//! Many falls at once, on all processors: each by itself, so that the results do not depend on how
//! many there are of either.

mod carried;
mod dry;
mod lockstep;
mod onset;
mod pool;
mod together;
mod trial;

use crate::body::Body;
use crate::error::InvalidInput;
use crate::motion::{Fall, Options};
use crate::state::State;
use crate::surface::Surface;
#[cfg(feature = "threads")]
use rayon::prelude::*;

/// So many falls go together as one piece of work.
const PIECE: usize = 512;

/// Follows a body from each start, on its surface, through the first turn; on the threads of the pool
/// that it is called from.
///
/// # Errors
/// As [`simulate`](crate::simulate), for the first trial that is refused.
pub fn ensemble(
    body: &Body,
    trials: &[(State, Surface)],
    options: &Options,
) -> Result<Vec<Fall>, InvalidInput> {
    let mut checked = *options;
    for (start, surface) in trials {
        surface.check()?;
        checked = options.checked(body, start)?;
    }
    #[cfg(feature = "threads")]
    let pieces = trials.par_chunks(PIECE);
    #[cfg(not(feature = "threads"))]
    let pieces = trials.chunks(PIECE);
    let falls: Vec<_> = pieces
        .map(|piece| together::together(body, piece, &checked))
        .collect();
    Ok(falls.concat())
}
