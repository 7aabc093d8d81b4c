//! The steps of a base that slides flat or is level and off the table.

use super::Departure;
use super::equations::{LEVEL, LEVEL_TIME, LevelMotion, PLACES, size};
use crate::real::Dual;
use crate::solve::{Dense, Implicit, ImplicitStep, Step, Stepper, Work, bracketed_root};
use crate::state::{COORDINATES, Coordinates};

/// A part of the motion of a level base that slides or flies: its dense output, what ends it, and the work.
pub(in crate::motion) struct LevelPart {
    pub(in crate::motion) dense: Dense<f64, COORDINATES>,
    pub(in crate::motion) departure: Option<Departure>,
    pub(in crate::motion) work: Work,
}

impl LevelMotion<'_> {
    /// The next part of the motion from `u` until `end` (s) at most; `None` if no step is short enough. `h` is the size
    /// of the next step, and `dual` has the same motion on dual numbers.
    pub(in crate::motion) fn next_part(
        &self,
        u: &Coordinates<f64>,
        end: f64,
        h: &mut f64,
        tolerance: f64,
        dual: &LevelMotion<'_, Dual>,
    ) -> Option<LevelPart> {
        let all = u.into_array();
        let start = PLACES.map(|place| all[place]);
        if let Some((_, departure)) = self.departed(&start, None) {
            return Some(LevelPart {
                dense: Dense::empty(all),
                departure: Some(departure),
                work: Work::default(),
            });
        }
        let (dense, work) = if self.can_stop() {
            self.implicit_step(start, end, h, tolerance, dual)?
        } else {
            self.explicit_step(start, end, h, tolerance)?
        };
        let (dense, departure) = self.until_departure(&dense, end);
        Some(LevelPart {
            dense: dense.placed(&all, &PLACES),
            departure,
            work,
        })
    }

    /// A step that does not go far beyond `end`, where the table's acceleration is no longer that of the stretch.
    fn explicit_step(
        &self,
        start: [f64; LEVEL],
        end: f64,
        h: &mut f64,
        tolerance: f64,
    ) -> Option<(Dense<f64, LEVEL>, Work)> {
        let tried = h.min(end - start[LEVEL_TIME]);
        let mut stepper = Stepper::new(self, start, tried, tolerance);
        let step: &mut Step<f64, LEVEL> = stepper.advance().ok()?;
        let is_whole = step.h == end - start[LEVEL_TIME];
        let mut dense = step.dense(self);
        if is_whole {
            dense.end[LEVEL_TIME] = end;
        }
        *h = stepper.h;
        Some((dense, stepper.work))
    }

    /// As [`Self::explicit_step`], for dry friction: the direction of a slow slip relaxes fast to that of the force,
    /// and a slip from rest is slow for long.
    fn implicit_step(
        &self,
        start: [f64; LEVEL],
        end: f64,
        h: &mut f64,
        tolerance: f64,
        dual: &LevelMotion<'_, Dual>,
    ) -> Option<(Dense<f64, LEVEL>, Work)> {
        const OVERSHOOT: f64 = 1.1;
        const MAX_REJECTED: usize = 200;
        let mut steps = Implicit::new(self, dual, start, tolerance);
        let remaining = end - start[LEVEL_TIME];
        *h = h.min(remaining / self.time_rate([start[3], start[4]]));
        while steps.work.rejected < MAX_REJECTED {
            let found = steps.attempt(*h);
            let overshoot = found.as_ref().map_or(0.0, |found| {
                (found.dense.end[LEVEL_TIME] - start[LEVEL_TIME]) / remaining
            });
            let factor = found.as_ref().map_or(0.25, ImplicitStep::next_factor);
            match found {
                Some(found) if overshoot > OVERSHOOT && found.error <= 1.0 => {
                    *h *= (1.0 / overshoot).max(0.1);
                }
                Some(found) if found.error <= 1.0 => {
                    *h *= factor.min(4.0);
                    steps.work.steps += 1;
                    return Some((found.dense, steps.work));
                }
                _ => *h *= factor.min(0.9),
            }
            steps.work.rejected += 1;
        }
        None
    }

    /// A step up to the first departure or to the time `end`.
    fn until_departure(
        &self,
        dense: &Dense<f64, LEVEL>,
        end: f64,
    ) -> (Dense<f64, LEVEL>, Option<Departure>) {
        let mut before = 0.0;
        for x in [0.25, 0.5, 0.75, 1.0] {
            let (from, to) = (dense.at(before), dense.at(x));
            let over = to[LEVEL_TIME] >= end || x == 1.0 && dense.end[LEVEL_TIME] == end;
            if let Some((index, departure)) = self.departed(&to, Some(&from)) {
                let margin = |x: f64| self.margins(&dense.at(x))[index].1;
                let root = bracketed_root(before, x, margin);
                if !over || dense.at(root)[LEVEL_TIME] < end {
                    return (dense.cut(root), Some(departure));
                }
            }
            if over {
                let mut dense = dense.cut(dense.fraction_where(LEVEL_TIME, end));
                dense.end[LEVEL_TIME] = end;
                return (dense, None);
            }
            before = x;
        }
        (dense.clone(), None)
    }

    /// The values that are positive until a departure.
    fn margins(&self, u: &[f64; LEVEL]) -> [(Departure, f64); 3] {
        let [t, _, _, vx, vy, gap, ..] = *u;
        if !self.slides {
            return [
                (Departure::Land, gap),
                (Departure::Stick, 1.0),
                (Departure::Uplift, 1.0),
            ];
        }
        let equations = &self.equations;
        let (_, gravity) = equations.field(self.acceleration(t));
        let friction = equations.friction([vx, vy], gravity);
        let excess_speed = if self.can_stop() {
            size([vx, vy]) - equations.no_speed()
        } else {
            1.0
        };
        [
            (Departure::FallAway, gravity + equations.no_gravity()),
            (
                Departure::Uplift,
                equations.flatness_margin(friction, gravity),
            ),
            (Departure::Stick, excess_speed),
        ]
    }

    /// The first margin that has become negative at `to`, by its index. A slip that has just begun is slow, but it does
    /// not end, and a body that has just left the table is near it.
    fn departed(
        &self,
        to: &[f64; LEVEL],
        from: Option<&[f64; LEVEL]>,
    ) -> Option<(usize, Departure)> {
        let before = from.map(|from| self.margins(from));
        let mut after = self.margins(to).into_iter().enumerate();
        after.find_map(|(i, (departure, margin))| {
            let falls = match (&before, &departure) {
                (Some(before), _) => margin < before[i].1,
                (None, Departure::Stick | Departure::Land) => false,
                (None, _) => true,
            };
            (margin < 0.0 && falls).then_some((i, departure))
        })
    }
}
