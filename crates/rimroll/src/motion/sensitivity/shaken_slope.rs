//! The numbers with which motions on a moving table are repeated: duals with a derivative for each parameter.

use super::PARAMETERS;
use crate::law::Parameters;
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

/// Changes of the parameters that all matter about as much.
pub(super) fn sizes_of_parameters(k: &Parameters<f64>) -> ShakenSlope {
    let (rate, h) = ((k.g / k.r).sqrt(), k.h.max(k.r));
    [
        1.0, rate, 1.0, rate, 1.0, rate, k.m, k.r, h, k.a, k.c, k.g, 1.0,
    ]
}

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

/// The coordinates without the rounding errors of derivatives across the plane of a motion. These would grow about a
/// thousandfold at every near-collision, as those of the coordinates would.
pub(super) fn without_rounding_across(
    k: &Parameters<f64>,
    u: &Coordinates<Number>,
) -> Coordinates<Number> {
    const ROUNDING: f64 = 1e-12;
    let mut u = *u;
    if [u.w, u.s, u.slip_y].iter().any(|x| x.value != 0.0) {
        return u;
    }
    let rate = (k.g / k.r).sqrt();
    for (i, size) in sizes_of_parameters(k).into_iter().enumerate() {
        let [w, s, slip] = [u.w, u.s, u.slip_y].map(|x| size * x.slope.0[i].abs());
        if w.max(s).max(slip / k.r) < ROUNDING * rate {
            (u.w.slope.0[i], u.s.slope.0[i], u.slip_y.slope.0[i]) = (0.0, 0.0, 0.0);
        }
    }
    u
}
