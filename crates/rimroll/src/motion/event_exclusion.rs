//! Exclusion tests for events in a step, from the values and rates at its ends alone. They spare the dense
//! output of steps that cannot contain an event.

use crate::law::Parameters;
use crate::solve::Step;
use crate::state::Coordinates;

/// The tested function must differ from zero by this fraction of its change over the step, since the cubic
/// Hermite interpolant differs slightly from the motion.
const MARGIN: f64 = 0.25;

/// The cubic Hermite interpolant of a step of a rim on the table.
pub(super) struct EventExclusion {
    h: f64,
    from: Coordinates<f64>,
    to: Coordinates<f64>,
    from_rates: Coordinates<f64>,
    to_rates: Coordinates<f64>,
}

impl EventExclusion {
    #[inline(always)]
    pub fn new<const N: usize>(step: &Step<f64, N>) -> EventExclusion {
        EventExclusion {
            h: step.h,
            from: Coordinates::from_first(&step.start),
            to: Coordinates::from_first(&step.end),
            from_rates: Coordinates::from_first(step.start_rates()),
            to_rates: Coordinates::from_first(step.end_rates()),
        }
    }

    pub fn end(&self) -> &Coordinates<f64> {
        &self.to
    }

    /// Whether a linear function of the coordinates stays above a bound. A cubic lies between its smallest
    /// and its largest Bernstein coefficient.
    #[inline(always)]
    pub fn stays_above(&self, bound: f64, linear: impl Fn(&Coordinates<f64>) -> f64) -> bool {
        let (from, to) = (linear(&self.from) - bound, linear(&self.to) - bound);
        let third = self.h / 3.0;
        are_clear([
            from,
            from + third * linear(&self.from_rates),
            to - third * linear(&self.to_rates),
            to,
        ])
    }

    /// Whether the normal force stays positive.
    #[inline(always)]
    pub fn keeps_contact(&self, k: &Parameters<f64>) -> bool {
        let (a, b) = (&self.from, &self.to);
        let (da, db) = (&self.from_rates, &self.to_rates);
        let midpoint = Coordinates {
            sin: self.midpoint(a.sin, b.sin, da.sin, db.sin),
            cos: self.midpoint(a.cos, b.cos, da.cos, db.cos),
            p: self.midpoint(a.p, b.p, da.p, db.p),
            ..*a
        };
        let dp = 1.5 * (b.p - a.p) / self.h - 0.25 * (da.p + db.p);
        are_clear([
            k.normal(a, da.p),
            k.normal(&midpoint, dp),
            k.normal(b, db.p),
        ])
    }

    /// The coordinates at the start, the midpoint and the end.
    pub fn three_points(&self) -> [Coordinates<f64>; 3] {
        let (a, b) = (self.from.into_array(), self.to.into_array());
        let (da, db) = (self.from_rates.into_array(), self.to_rates.into_array());
        let midpoint = core::array::from_fn(|i| self.midpoint(a[i], b[i], da[i], db[i]));
        [self.from, Coordinates::from_array(&midpoint), self.to]
    }

    /// The cubic at the midpoint.
    #[inline(always)]
    fn midpoint(&self, from: f64, to: f64, from_rate: f64, to_rate: f64) -> f64 {
        0.5 * (from + to) + 0.125 * self.h * (from_rate - to_rate)
    }
}

/// Whether all values are positive and the smallest exceeds a quarter of their spread. Then the parabola
/// through three of them is positive, too.
#[inline(always)]
pub(super) fn are_clear<const M: usize>(values: [f64; M]) -> bool {
    let (mut min, mut max) = (values[0], values[0]);
    for value in values {
        min = if value < min { value } else { min };
        max = if value > max { value } else { max };
    }
    min > MARGIN * (max - min)
}
