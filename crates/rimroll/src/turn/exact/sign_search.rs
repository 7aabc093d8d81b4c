//! The first place where a function of the tilt is negative, by looking at it here and there.
//!
//! The slope of the tilt's energy G is known, too, and how far rounding can be off: its minima are found as
//! roots of the slope, however narrow the stretch in which it is negative, and a minimum whose sign
//! rounding decides is [`Unclear`].

use super::SAMPLES;
use crate::solve::bracketed_root;

/// Farther apart, in η, looks at G may miss a minimum: what makes one, gravity and the energies of yaw and
/// spin, changes over about a unit of η.
const FARTHEST: f64 = 0.25;

/// The fewest steps from look to look.
const FEWEST: f64 = 8.0;

/// Where rounding decides what becomes of the body.
pub(super) struct Unclear;

/// G at some η.
#[derive(Debug, Clone, Copy)]
pub(super) struct Energy {
    /// G.
    pub(super) drive: f64,
    /// dG/dη.
    pub(super) slope: f64,
    /// A bound of the rounding error of G.
    pub(super) rounding: f64,
}

/// Where G, not negative at `from`, first is zero on the way to `to`.
pub(super) fn first_turn_back(
    from: f64,
    to: f64,
    energy: impl Fn(f64) -> Energy,
) -> Result<Option<f64>, Unclear> {
    let drive = |eta: f64| energy(eta).drive;
    let mut before = (from, energy(from));
    for eta in steps(from, to) {
        let after = (eta, energy(eta));
        if let Some(low) = minimum_between(before, after, &energy) {
            let least = energy(low);
            if least.drive.abs() <= least.rounding {
                return Err(Unclear);
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
        return Err(Unclear);
    }
    Ok(None)
}

/// Whether G is surely positive between two η, at which it may be zero.
pub(super) fn is_clear(from: f64, to: f64, energy: impl Fn(f64) -> Energy) -> bool {
    let mut before = (from, energy(from));
    steps(from, to).all(|eta| {
        let after = (eta, energy(eta));
        let low = minimum_between(before, after, &energy).map(&energy);
        before = after;
        let positive = |at: Energy| at.drive > at.rounding;
        low.is_none_or(positive) && (eta == to || positive(after.1))
    })
}

/// η from look to look, without the first.
fn steps(from: f64, to: f64) -> impl Iterator<Item = f64> {
    let count = ((to - from).abs() / FARTHEST).max(FEWEST) as usize;
    (1..=count).map(move |i| {
        if i == count {
            to
        } else {
            from + (to - from) * i as f64 / count as f64
        }
    })
}

/// Where G is least between two looks, if it falls after the one and rises before the other.
fn minimum_between(
    (from, before): (f64, Energy),
    (to, after): (f64, Energy),
    energy: impl Fn(f64) -> Energy,
) -> Option<f64> {
    let way = (to - from).signum();
    let has_minimum = way * before.slope < 0.0 && way * after.slope > 0.0;
    has_minimum.then(|| bracketed_root(from, to, |eta| energy(eta).slope))
}

/// Where a function that is not negative at first changes its sign, be it for less than from one look to
/// the next.
pub(super) fn first_sign_change(from: f64, to: f64, f: impl Fn(f64) -> f64) -> Option<f64> {
    let sign_search = (SAMPLES as f64).max((to - from).abs() / 0.2) as usize;
    let at = |i: usize| from + (to - from) * i as f64 / sign_search as f64;
    let seen: Vec<f64> = (0..=sign_search).map(|i| f(at(i))).collect();
    (0..=sign_search).find_map(|i| {
        let (before, after) = (i.saturating_sub(1), (i + 1).min(sign_search));
        let beyond = if i > 0 && seen[i] < 0.0 {
            Some(at(i))
        } else if may_dip(&seen, i) {
            negative_between(at(before), at(after), &f)
        } else {
            None
        };
        beyond.map(|beyond| bracketed_root(at(before), beyond, &f))
    })
}

/// Whether a function that has been seen in equal steps may be negative next to its i-th value, the least of
/// those around it. A parabola is lower between two of them by an eighth of their second difference at most.
fn may_dip(seen: &[f64], i: usize) -> bool {
    const MARGIN: f64 = 4.0;
    let last = seen.len() - 1;
    let middle = i.clamp(1, last - 1);
    let bend = seen[middle - 1] - 2.0 * seen[middle] + seen[middle + 1];
    let is_least = (i == 0 || seen[i] <= seen[i - 1]) && (i == last || seen[i] <= seen[i + 1]);
    is_least && seen[i] < MARGIN / 8.0 * bend
}

/// A place where a function with one minimum between two others is negative, by golden sections.
fn negative_between(mut from: f64, mut to: f64, f: impl Fn(f64) -> f64) -> Option<f64> {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    /// Of the golden sections: the last is of a 1e-4 of the first.
    const SECTIONS: usize = 20;
    let section = |from: f64, to: f64| {
        let x = from + GOLDEN * (to - from);
        (x, f(x))
    };
    // The one is nearer to `to`, the other to `from`.
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
