//! Search for the first sign change of a function of the tilt, by sampling.
//!
//! For the tilt's energy G, the slope and a rounding error bound are known, too. Its minima are found as
//! roots of the slope, so an interval of negative G is found however narrow it is. A minimum whose sign
//! depends on rounding errors is [`Undecided`].

use crate::solve::bracketed_root;

/// Number of samples in the search for the first root of a function.
pub(super) const SAMPLES: usize = 24;

/// Maximum spacing of the samples in η. With larger spacing, a minimum of G could be missed: the terms that cause one,
/// gravity and the energies of yaw and spin, vary over about one unit of η.
const MAX_SPACING: f64 = 0.25;

/// Minimum number of steps between samples.
const MIN_STEPS: f64 = 8.0;

/// The outcome depends on rounding errors.
pub(super) struct Undecided;

/// The tilt's energy G at some η.
#[derive(Debug, Clone, Copy)]
pub(super) struct Energy {
    /// G, J.
    pub(super) drive: f64,
    /// dG/dη, J.
    pub(super) slope: f64,
    /// Rounding error bound of G, J.
    pub(super) rounding: f64,
}

/// The first zero of G between `from`, where G is not negative, and `to`.
pub(super) fn first_turning_point(
    from: f64,
    to: f64,
    energy: impl Fn(f64) -> Energy,
) -> Result<Option<f64>, Undecided> {
    let drive = |eta: f64| energy(eta).drive;
    let mut before = (from, energy(from));
    for eta in steps(from, to) {
        let after = (eta, energy(eta));
        if let Some(low) = minimum_between(before, after, &energy) {
            let least = energy(low);
            if least.drive.abs() <= least.rounding {
                return Err(Undecided);
            }
            if least.drive < 0.0 {
                return Ok(Some(bracketed_root(before.0, low, drive)));
            }
        }
        if after.1.drive < 0.0 {
            return Ok(Some(bracketed_root(before.0, eta, drive)));
        }
        before = after;
    }
    if before.1.drive <= before.1.rounding {
        return Err(Undecided);
    }
    Ok(None)
}

/// Whether G is positive beyond rounding errors between two η. At both ends it may be zero.
pub(super) fn is_positive_between(from: f64, to: f64, energy: impl Fn(f64) -> Energy) -> bool {
    let mut before = (from, energy(from));
    steps(from, to).all(|eta| {
        let after = (eta, energy(eta));
        let low = minimum_between(before, after, &energy).map(&energy);
        before = after;
        let positive = |at: Energy| at.drive > at.rounding;
        low.is_none_or(positive) && (eta == to || positive(after.1))
    })
}

/// The η of the samples, without the first.
fn steps(from: f64, to: f64) -> impl Iterator<Item = f64> {
    let count = ((to - from).abs() / MAX_SPACING).max(MIN_STEPS) as usize;
    (1..=count).map(move |i| {
        if i == count {
            to
        } else {
            from + (to - from) * i as f64 / count as f64
        }
    })
}

/// The minimum of G between two samples, if G decreases at the first and increases at the second.
fn minimum_between(
    (from, before): (f64, Energy),
    (to, after): (f64, Energy),
    energy: impl Fn(f64) -> Energy,
) -> Option<f64> {
    let way = (to - from).signum();
    let has_minimum = way * before.slope < 0.0 && way * after.slope > 0.0;
    has_minimum.then(|| bracketed_root(from, to, |eta| energy(eta).slope))
}

/// The first sign change of a function that is not negative at `from`. Intervals of negative values that are shorter
/// than the spacing of the samples are found, too.
pub(super) fn first_sign_change(from: f64, to: f64, f: impl Fn(f64) -> f64) -> Option<f64> {
    let intervals = (SAMPLES as f64).max((to - from).abs() / 0.2) as usize;
    let at = |i: usize| from + (to - from) * i as f64 / intervals as f64;
    let values: Vec<f64> = (0..=intervals).map(|i| f(at(i))).collect();
    (0..=intervals).find_map(|i| {
        let (before, after) = (i.saturating_sub(1), (i + 1).min(intervals));
        let beyond = if i > 0 && values[i] < 0.0 {
            Some(at(i))
        } else if may_dip(&values, i) {
            negative_between(at(before), at(after), &f)
        } else {
            None
        };
        beyond.map(|beyond| bracketed_root(at(before), beyond, &f))
    })
}

/// Whether a function sampled in equal steps may be negative next to its i-th value, if that is a local minimum of the
/// samples. The minimum of a parabola is below the samples by at most an eighth of their second difference.
fn may_dip(values: &[f64], i: usize) -> bool {
    const MARGIN: f64 = 4.0;
    let last = values.len() - 1;
    let middle = i.clamp(1, last - 1);
    let bend = values[middle - 1] - 2.0 * values[middle] + values[middle + 1];
    let is_least =
        (i == 0 || values[i] <= values[i - 1]) && (i == last || values[i] <= values[i + 1]);
    is_least && values[i] < MARGIN / 8.0 * bend
}

/// A point between two others where a function with one minimum is negative, by golden-section search.
fn negative_between(mut from: f64, mut to: f64, f: impl Fn(f64) -> f64) -> Option<f64> {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    /// Number of golden sections. The last interval is 1e-4 of the first.
    const SECTIONS: usize = 20;
    let section = |from: f64, to: f64| {
        let x = from + GOLDEN * (to - from);
        (x, f(x))
    };
    // `one` is nearer to `to`, `other` to `from`.
    let (mut one, mut other) = (section(from, to), section(to, from));
    for _ in 0..SECTIONS {
        for (x, value) in [other, one] {
            if value < 0.0 {
                return Some(x);
            }
        }
        if one.1 < other.1 {
            from = other.0;
            other = one;
            one = section(from, to);
        } else {
            to = one.0;
            one = other;
            other = section(to, from);
        }
    }
    None
}
