//! Many falls at once, on all processors: each by itself, so that the results do not depend on how
//! many there are of either.

use crate::body::Body;
use crate::error::InvalidInput;
use crate::motion::{Fall, Options, fall};
use crate::state::State;
use crate::surface::Surface;
#[cfg(feature = "threads")]
use rayon::prelude::*;

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
    #[cfg(feature = "threads")]
    let trials = trials.par_iter();
    #[cfg(not(feature = "threads"))]
    let trials = trials.iter();
    let falls: Vec<_> = trials
        .map(|(start, surface)| fall(body, start, surface, options))
        .collect();
    falls.into_iter().collect()
}
