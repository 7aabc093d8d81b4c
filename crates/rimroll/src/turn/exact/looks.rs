//! The first place where a function of the tilt is negative, by looking at it here and there.

use super::LOOKS;
use crate::solve::bracketed;

/// Where a function that is not negative at first changes its sign, be it for less than from one look to
/// the next.
pub(super) fn first_sign_change(from: f64, to: f64, f: impl Fn(f64) -> f64) -> Option<f64> {
    let looks = (LOOKS as f64).max((to - from).abs() / 0.2) as usize;
    let at = |i: usize| from + (to - from) * i as f64 / looks as f64;
    let seen: Vec<f64> = (0..=looks).map(|i| f(at(i))).collect();
    (0..=looks).find_map(|i| {
        let (before, after) = (i.saturating_sub(1), (i + 1).min(looks));
        let beyond = if i > 0 && seen[i] < 0.0 {
            Some(at(i))
        } else if may_dip(&seen, i) {
            negative_between(at(before), at(after), &f)
        } else {
            None
        };
        beyond.map(|beyond| bracketed(at(before), beyond, &f))
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
