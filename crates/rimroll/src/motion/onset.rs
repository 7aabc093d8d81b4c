//! Slow slip under dry friction, above all as it begins out of rest.
//!
//! At first the slip u = r e is so small that its direction e follows the forces at once: with
//! e turned by δ from where it set out,
//!
//! ```text
//! r δ′ = (u′ across e),    r′ = (u′ along e)
//! ```
//!
//! where the first is stiff without bound as r → 0 (and r = 0 is where it starts; r grows like t²
//! when the friction is just exceeded). So r and δ are carried instead of the slip's components, and
//! steps are made by collocation: Newton's method for δ, simple iteration for everything else. Once
//! explicit steps can follow, they take over.

use super::contacts::turned;
use super::mechanics::Mechanics;
use crate::error_scale::direction_scale;
use crate::law::DryDynamics;
use crate::solve::{Collocation, Dense, POINTS, solved};
use crate::state::{COORDINATES, Coordinates};

/// Explicit steps take over where the direction relaxes no oftener than this in a step of collocation:
/// they are several times shorter, and several times cheaper.
const FOLLOWED: f64 = 10.0;

const MAX_STEPS: usize = 400;

/// A step in which the rates grow by such a factor is none.
const FARTHEST: f64 = 10.0;

/// The steps of an onset and a length for the next one.
pub(super) struct Onset {
    /// From the first slip on; empty when no slip grows from here.
    pub steps: Vec<Dense<f64, COORDINATES>>,
    /// A first guess for the explicit step that follows.
    pub h: f64,
}

/// The coordinates with their slip in polar form.
#[derive(Clone, Copy)]
struct Polar {
    /// Its slip is not used.
    at: Coordinates<f64>,
    speed: f64,
    /// δ, from the direction in which the slip began.
    turn: f64,
}

/// Rates at a point: r′ takes the place of the slip's rates.
#[derive(Clone, Copy)]
struct Rates {
    at: [f64; COORDINATES],
    speed: f64,
    /// r δ′.
    sideways: f64,
    /// Its derivative by δ.
    slope: f64,
}

struct Beginning<'a> {
    dry: &'a dyn DryDynamics,
    mechanics: &'a Mechanics<'a>,
    direction: [f64; 2],
    method: &'static Collocation,
    tolerance: f64,
    /// What is added to r′.
    push: f64,
}

/// A step with its error, over what is tolerated, and how often δ relaxes in a step as long.
struct Found {
    step: Dense<f64, COORDINATES>,
    end: Polar,
    error: f64,
    relaxation: f64,
    /// In what time the slip would stop at the rate at its end.
    until_stop: f64,
}

/// Follows a slip in a direction (unit vector), from rest or from the slip that there is, until
/// explicit steps can; `h` is a first guess for the length of a step.
pub(super) fn begin(
    dry: &dyn DryDynamics,
    mechanics: &Mechanics<'_>,
    start: &Coordinates<f64>,
    direction: [f64; 2],
    from_rest: bool,
    h: f64,
    tolerance: f64,
) -> Onset {
    let mut beginning = Beginning {
        dry,
        mechanics,
        direction,
        method: Collocation::get(),
        tolerance,
        push: 0.0,
    };
    let mut at = Polar {
        at: *start,
        speed: start.slip_speed(),
        turn: 0.0,
    };
    let mut onset = Onset {
        steps: Vec::new(),
        h,
    };
    if at.speed > 0.0 && h * beginning.rates(&at).slope.abs() < FOLLOWED * at.speed {
        return onset;
    }
    if from_rest {
        // Friction is exceeded where the phase begins, but for rounding: slip does not begin backward.
        beginning.push = (-beginning.rates(&at).speed).max(0.0);
    }
    let least = 1e-12 * h;
    let mut h = h;
    while onset.steps.len() < MAX_STEPS && h > least {
        match beginning.step(&at, h) {
            Some(found) if found.error <= 1.0 => {
                onset.steps.push(found.step);
                at = found.end;
                let grow = (0.8 / libm::pow(found.error.max(1e-9), 1.0 / 7.0)).clamp(0.3, 4.0);
                onset.h = h / found.relaxation.max(1.0);
                if found.relaxation * grow < FOLLOWED {
                    break;
                }
                // Not beyond the end of a slip that is about to stop.
                h = (h * grow).min(0.9 * found.until_stop);
            }
            Some(found) => h *= (0.8 / libm::pow(found.error, 1.0 / 7.0)).clamp(0.1, 0.5),
            None => h *= 0.25,
        }
    }
    onset
}

impl Beginning<'_> {
    fn direction(&self, turn: f64) -> [f64; 2] {
        turned(self.direction, turn)
    }

    /// The coordinates with their slip put in.
    fn whole(&self, polar: &Polar) -> Coordinates<f64> {
        let e = self.direction(polar.turn);
        Coordinates {
            slip_x: polar.speed * e[0],
            slip_y: polar.speed * e[1],
            ..polar.at
        }
    }

    /// (rates, r′, r δ′)
    fn accelerations(&self, polar: &Polar) -> (Coordinates<f64>, f64, f64) {
        let e = self.direction(polar.turn);
        let u = self.whole(polar);
        let (_, rates) = self.dry.slipping(&u, e, polar.speed);
        let forward = rates.slip_x * e[0] + rates.slip_y * e[1];
        let sideways = rates.slip_y * e[0] - rates.slip_x * e[1];
        (rates, forward, sideways)
    }

    fn rates(&self, polar: &Polar) -> Rates {
        const NUDGE: f64 = 1e-5;
        let beside = |nudge: f64| {
            let turn = polar.turn + nudge;
            self.accelerations(&Polar { turn, ..*polar }).2
        };
        self.rates_given(polar, (beside(NUDGE) - beside(-NUDGE)) / (2.0 * NUDGE))
    }

    fn rates_given(&self, polar: &Polar, slope: f64) -> Rates {
        let (rates, speed, sideways) = self.accelerations(polar);
        Rates {
            at: Coordinates {
                slip_x: 0.0,
                slip_y: 0.0,
                ..rates
            }
            .into_array(),
            speed: speed + self.push,
            sideways,
            slope,
        }
    }

    /// A step of length h; none where the iteration does not settle or the slip does not last.
    fn step(&self, start: &Polar, h: f64) -> Option<Found> {
        const MAX_ROUNDS: usize = 60;
        // After so many rounds the slopes are as good as those of the solution.
        const FRESH_SLOPES: usize = 2;
        let first = self.rates(start);
        let mut points = crate::solve::RADAU.map(|c| self.moved(start, &first, c * h));
        let mut rates = points.map(|point| self.rates(&point));
        let mut last_change = f64::INFINITY;
        for round in 0..MAX_ROUNDS {
            let turns = self.turn_rates(start, &points, &rates, h);
            let next = self.integrated(start, &rates, &turns, h);
            let change = self.change(&points, &next);
            points = next;
            if round > 0 && points.iter().any(|point| point.speed <= 0.0) {
                return None;
            }
            if change <= 0.02 * self.tolerance {
                return Some(self.found(start, &points, &rates, &turns, h));
            }
            // Rounding keeps the last changes from getting smaller.
            if round > 8 && change > 0.5 * last_change {
                let settled = change <= 4.0 * self.tolerance;
                return settled.then(|| self.found(start, &points, &rates, &turns, h));
            }
            last_change = change;
            rates = core::array::from_fn(|j| match round {
                ..FRESH_SLOPES => self.rates(&points[j]),
                _ => self.rates_given(&points[j], rates[j].slope),
            });
        }
        None
    }

    fn moved(&self, start: &Polar, rates: &Rates, h: f64) -> Polar {
        let from = start.at.into_array();
        let at = core::array::from_fn(|i| from[i] + h * rates.at[i]);
        Polar {
            at: Coordinates::from_array(&at),
            speed: (start.speed + h * rates.speed).max(0.0),
            turn: start.turn,
        }
    }

    /// δ′ at the points, from r δ′ = sideways + slope · (change of δ), which is linear in them.
    fn turn_rates(
        &self,
        start: &Polar,
        points: &[Polar; POINTS],
        rates: &[Rates; POINTS],
        h: f64,
    ) -> [f64; POINTS] {
        let mut matrix = [[0.0; POINTS]; POINTS];
        let mut right = [0.0; POINTS];
        for i in 0..POINTS {
            let slope = rates[i].slope;
            matrix[i] = self.method.integral[i].map(|weight| -slope * h * weight);
            matrix[i][i] += points[i].speed;
            right[i] = rates[i].sideways + slope * (start.turn - points[i].turn);
        }
        // Exactly in a plane there is nothing to turn.
        if right == [0.0; POINTS] {
            return right;
        }
        solved(matrix, right)
    }

    fn integrated(
        &self,
        start: &Polar,
        rates: &[Rates; POINTS],
        turns: &[f64; POINTS],
        h: f64,
    ) -> [Polar; POINTS] {
        let from = start.at.into_array();
        self.method.integral.map(|row| {
            let mut at = from;
            let (mut speed, mut turn) = (start.speed, start.turn);
            for (j, weight) in row.into_iter().enumerate() {
                let weight = h * weight;
                for (coordinate, rate) in at.iter_mut().zip(&rates[j].at) {
                    *coordinate += weight * rate;
                }
                speed += weight * rates[j].speed;
                turn += weight * turns[j];
            }
            Polar {
                at: Coordinates::from_array(&at),
                speed,
                turn,
            }
        })
    }

    /// The largest change of the points, each coordinate by its own size.
    fn change(&self, before: &[Polar; POINTS], after: &[Polar; POINTS]) -> f64 {
        let scales = self.scales(after);
        let mut change: f64 = 0.0;
        for (a, b) in before.iter().zip(after) {
            let (x, y) = (a.at.into_array(), b.at.into_array());
            for i in 0..COORDINATES {
                change = change.max((x[i] - y[i]).abs() / scales.at[i]);
            }
            change = change.max((a.speed - b.speed).abs() / scales.speed);
            change = change.max((a.turn - b.turn).abs() / scales.turn);
        }
        change
    }

    fn scales(&self, points: &[Polar; POINTS]) -> Scales {
        let end = self.whole(&points[POINTS - 1]);
        let scales = self.mechanics.error_scale.scales_at_slip_onset(&end);
        Scales {
            speed: scales.slip_x,
            turn: direction_scale(&scales, self.direction, points[POINTS - 1].speed),
            at: scales.into_array(),
        }
    }

    /// All the rates together, rad/s.
    fn rate_scale(&self, u: &Coordinates<f64>) -> f64 {
        self.mechanics.error_scale.tilt_rate(u) + u.s.abs()
    }

    fn found(
        &self,
        start: &Polar,
        points: &[Polar; POINTS],
        rates: &[Rates; POINTS],
        turns: &[f64; POINTS],
        h: f64,
    ) -> Found {
        let scales = self.scales(points);
        let states = points.map(|point| self.whole(&point).into_array());
        let step = self
            .method
            .through(h, &self.whole(start).into_array(), &states);
        // What the highest power contributes bounds what those left out do.
        let of_highest = |value: &dyn Fn(usize) -> f64, size: f64| {
            let coefficient: f64 = (0..POINTS).map(|j| self.method.last[j] * value(j)).sum();
            (0.05 * h * coefficient / size).abs()
        };
        let mut error: f64 = of_highest(&|j| rates[j].speed, scales.speed)
            .max(of_highest(&|j| turns[j], scales.turn));
        for i in 0..COORDINATES {
            error = error.max(of_highest(&|j| rates[j].at[i], scales.at[i]));
        }
        let end = points[POINTS - 1];
        let (before, after) = (
            self.rate_scale(&start.at),
            self.rate_scale(&points[POINTS - 1].at),
        );
        // So far from the start the equations may have another solution. Written so that a NaN is far.
        let near = after < FARTHEST * before;
        if !near {
            error = f64::INFINITY;
        }
        Found {
            step,
            error: error / self.tolerance,
            relaxation: h * rates[POINTS - 1].slope.abs() / end.speed,
            until_stop: end.speed / (-rates[POINTS - 1].speed).max(0.0),
            end,
        }
    }
}

/// What to compare changes with.
struct Scales {
    at: [f64; COORDINATES],
    speed: f64,
    turn: f64,
}
