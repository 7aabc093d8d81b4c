//! Whether it is clear at a glance that nothing happens in a step: from its ends alone, without the
//! polynomial that it takes to look inside.

use crate::law::Parameters;
use crate::solve::Step;
use crate::state::Coordinates;

/// What is looked at keeps away from zero by this part of its change over the step: the cubic through
/// the ends differs from the motion by far less.
const MARGIN: f64 = 0.25;

/// A step of a rim on the table, seen from its ends.
pub(super) struct StepBounds {
    h: f64,
    from: Coordinates<f64>,
    to: Coordinates<f64>,
    from_rates: Coordinates<f64>,
    to_rates: Coordinates<f64>,
}

impl StepBounds {
    #[inline(always)]
    pub fn new<const N: usize>(step: &Step<f64, N>) -> StepBounds {
        StepBounds {
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

    /// Whether a linear function of the coordinates stays above a bound: the cubic with its values and
    /// slopes at the ends lies between its Bernstein coefficients.
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

    /// Whether the table pushes all the time.
    #[inline(always)]
    pub fn stays_pressed(&self, k: &Parameters<f64>) -> bool {
        let (a, b) = (&self.from, &self.to);
        let (da, db) = (&self.from_rates, &self.to_rates);
        let halfway = Coordinates {
            sin: self.middle(a.sin, b.sin, da.sin, db.sin),
            cos: self.middle(a.cos, b.cos, da.cos, db.cos),
            p: self.middle(a.p, b.p, da.p, db.p),
            ..*a
        };
        let dp = 1.5 * (b.p - a.p) / self.h - 0.25 * (da.p + db.p);
        are_clear([k.normal(a, da.p), k.normal(&halfway, dp), k.normal(b, db.p)])
    }

    /// Where it begins, is halfway, and ends.
    pub fn three(&self) -> [Coordinates<f64>; 3] {
        let (a, b) = (self.from.into_array(), self.to.into_array());
        let (da, db) = (self.from_rates.into_array(), self.to_rates.into_array());
        let halfway = core::array::from_fn(|i| self.middle(a[i], b[i], da[i], db[i]));
        [self.from, Coordinates::from_array(&halfway), self.to]
    }

    /// Of the cubic.
    #[inline(always)]
    fn middle(&self, from: f64, to: f64, from_rate: f64, to_rate: f64) -> f64 {
        0.5 * (from + to) + 0.125 * self.h * (from_rate - to_rate)
    }
}

/// Whether values are positive, and their smallest is not small beside their spread: then so is the
/// parabola through three of them.
#[inline(always)]
pub(super) fn are_clear<const M: usize>(values: [f64; M]) -> bool {
    let (mut least, mut most) = (values[0], values[0]);
    for value in values {
        least = if value < least { value } else { least };
        most = if value > most { value } else { most };
    }
    least > MARGIN * (most - least)
}
