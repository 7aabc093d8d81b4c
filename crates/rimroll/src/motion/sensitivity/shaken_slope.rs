//! The numbers with which motions on a moving table are repeated: duals with a derivative for each parameter.

use super::PARAMETERS;
use crate::real::{Dual, Slopes};
use crate::state::Coordinates;

/// The parameters of a motion on a table that moves, in the order of [`ShakenSlope`]: [`PARAMETERS`], and the factor s on
/// the acceleration s a(t) of the table, at s = 1.
pub const SHAKEN_PARAMETERS: [&str; PARAMETERS.len() + 1] = {
    let mut names = ["ground_scale"; PARAMETERS.len() + 1];
    let mut i = 0;
    while i < PARAMETERS.len() {
        names[i] = PARAMETERS[i];
        i += 1;
    }
    names
};

/// The derivatives with respect to each of [`SHAKEN_PARAMETERS`]; NaN where there is none.
pub type ShakenSlope = [f64; SHAKEN_PARAMETERS.len()];

pub(super) type Number = Dual<Slopes<{ SHAKEN_PARAMETERS.len() }>>;

/// The coordinates without derivatives (NaN) by those parameters by which some coordinate has none.
pub(super) fn all_or_none(u: &Coordinates<Number>) -> Coordinates<Number> {
    let all = u.into_array();
    let is_undefined = |i: usize| all.iter().any(|dual| dual.slope.0[i].is_nan());
    without(u, core::array::from_fn(is_undefined))
}

/// The coordinates without derivatives (NaN) by some parameters.
pub(super) fn without(
    u: &Coordinates<Number>,
    undefined: [bool; SHAKEN_PARAMETERS.len()],
) -> Coordinates<Number> {
    Coordinates::from_array(&u.into_array().map(|mut dual| {
        for (slope, undefined) in dual.slope.0.iter_mut().zip(undefined) {
            *slope = if undefined { f64::NAN } else { *slope };
        }
        dual
    }))
}
