//! The onset of slip under dry friction, and other slow slip.
//!
//! At first the slip u = r e is so slow that its direction e relaxes almost instantly to that of the
//! forces. With δ the angle of e from its initial direction,
//!
//! ```text
//! r δ′ = (u′ across e),    r′ = (u′ along e)
//! ```
//!
//! The first equation is arbitrarily stiff as r → 0, and the onset begins at r = 0; r grows like t² if the
//! friction is only just exceeded. So r and δ replace the components of the slip, and the steps are made by
//! collocation, with Newton's method for δ and fixed-point iteration for everything else. Explicit steps
//! take over as soon as the equations are not stiff for them.
//!
//! The onsets of a batch (`ensemble/slip_onset`) share the rules at the end of this file.

use super::phase_system::PhaseSystem;
use crate::error_scale::direction_scale;
use crate::law::DryDynamics;
use crate::real::Real;
use crate::solve::{Collocation, Dense, POINTS, solved};
use crate::state::{COORDINATES, Coordinates};

/// Explicit steps take over when a collocation step spans at most this many relaxation times of the
/// direction. They are several times shorter, but also several times cheaper.
const MAX_EXPLICIT_STIFFNESS: f64 = 10.0;

const MAX_STEPS: usize = 400;

/// A step in which the rates grow by more than this factor is rejected.
const MAX_RATE_GROWTH: f64 = 10.0;

/// A slip begins if its acceleration exceeds −`ROUNDING` times the scale of the accelerations. At loose tolerances
/// sin² φ + cos² φ differs from 1 by up to about 1e-8, and the condition for slip in the rolling and in the sliding
/// equations agrees only to that accuracy.
pub(crate) const ROUNDING: f64 = 1e-6;

/// The safety factor of the step size.
pub(crate) const SAFETY: f64 = 0.8;

/// The steps of an onset and the size of the next one.
pub(super) struct Onset {
    /// The steps from the first slip on; empty if no slip grows.
    pub steps: Vec<Dense<f64, COORDINATES>>,
    /// A first guess for the size of the explicit step that follows.
    pub h: f64,
}

/// The coordinates with the slip in polar form.
#[derive(Clone, Copy)]
struct Polar {
    /// The other coordinates; its slip is not used.
    at: Coordinates<f64>,
    speed: f64,
    /// δ, the angle from the initial direction of the slip, rad.
    turn: f64,
}

/// Rates at a point. r′ and r δ′ replace the slip's rates.
#[derive(Clone, Copy)]
struct Rates {
    at: [f64; COORDINATES],
    speed: f64,
    /// r δ′.
    sideways: f64,
    /// The derivative of r δ′ with respect to δ.
    slope: f64,
}

struct PolarSystem<'a> {
    dry: &'a dyn DryDynamics,
    phase_system: &'a PhaseSystem<'a>,
    direction: [f64; 2],
    method: &'static Collocation,
    tolerance: f64,
    /// Added to r′, so that rounding does not make it negative at the onset.
    offset: f64,
}

/// The result of a collocation step.
struct CollocationStep {
    step: Dense<f64, COORDINATES>,
    end: Polar,
    /// The error relative to the tolerance.
    error: f64,
    /// The step size over the relaxation time of δ.
    relaxation: f64,
    /// The time until the slip stops at the deceleration at the end of the step.
    until_stop: f64,
}

/// Integrates a slip, from rest or from its present value, in a direction (unit vector) until explicit
/// steps can take over; `h` is a first guess for the step size.
pub(super) fn integrate(
    dry: &dyn DryDynamics,
    phase_system: &PhaseSystem<'_>,
    start: &Coordinates<f64>,
    direction: [f64; 2],
    from_rest: bool,
    h: f64,
    tolerance: f64,
) -> Onset {
    let mut system = PolarSystem {
        dry,
        phase_system,
        direction,
        method: Collocation::get(),
        tolerance,
        offset: 0.0,
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
    if at.speed > 0.0 && h * system.rates(&at).slope.abs() < MAX_EXPLICIT_STIFFNESS * at.speed {
        return onset;
    }
    if from_rest {
        // The phase begins where friction is exceeded, so a negative r′ there is a rounding error.
        system.offset = (-system.rates(&at).speed).max(0.0);
    }
    let min_step = 1e-12 * h;
    let mut h = h;
    while onset.steps.len() < MAX_STEPS && h > min_step {
        match system.step(&at, h) {
            Some(result) if result.error <= 1.0 => {
                onset.steps.push(result.step);
                at = result.end;
                let growth = growth(SAFETY / libm::pow(result.error.max(1e-9), 1.0 / 7.0));
                onset.h = h / result.relaxation.max(1.0);
                if result.relaxation * growth < MAX_EXPLICIT_STIFFNESS {
                    break;
                }
                h = next_step(h, growth, result.until_stop);
            }
            Some(result) => h *= (SAFETY / libm::pow(result.error, 1.0 / 7.0)).clamp(0.1, 0.5),
            None => h *= 0.25,
        }
    }
    onset
}

impl PolarSystem<'_> {
    fn direction(&self, turn: f64) -> [f64; 2] {
        rotated(self.direction, turn)
    }

    /// The coordinates with the Cartesian slip.
    fn cartesian(&self, polar: &Polar) -> Coordinates<f64> {
        let e = self.direction(polar.turn);
        Coordinates {
            slip_x: polar.speed * e[0],
            slip_y: polar.speed * e[1],
            ..polar.at
        }
    }

    /// The rates, r′ and r δ′.
    fn accelerations(&self, polar: &Polar) -> (Coordinates<f64>, f64, f64) {
        let e = self.direction(polar.turn);
        let u = self.cartesian(polar);
        let (_, rates) = self.dry.slipping(&u, e, polar.speed);
        let [forward, sideways] = along_and_across([rates.slip_x, rates.slip_y], e);
        (rates, forward, sideways)
    }

    fn rates(&self, polar: &Polar) -> Rates {
        // The increment of the central difference, rad.
        const INCREMENT: f64 = 1e-5;
        let sideways_at = |increment: f64| {
            let turn = polar.turn + increment;
            self.accelerations(&Polar { turn, ..*polar }).2
        };
        self.rates_with_slope(
            polar,
            (sideways_at(INCREMENT) - sideways_at(-INCREMENT)) / (2.0 * INCREMENT),
        )
    }

    fn rates_with_slope(&self, polar: &Polar, slope: f64) -> Rates {
        let (rates, speed, sideways) = self.accelerations(polar);
        Rates {
            at: Coordinates {
                slip_x: 0.0,
                slip_y: 0.0,
                ..rates
            }
            .into_array(),
            speed: speed + self.offset,
            sideways,
            slope,
        }
    }

    /// A step of size h; `None` where the iteration does not converge or the slip stops.
    fn step(&self, start: &Polar, h: f64) -> Option<CollocationStep> {
        const MAX_ROUNDS: usize = 60;
        // The slopes are updated in this many rounds; after that they are accurate enough.
        const SLOPE_UPDATES: usize = 2;
        let start_rates = self.rates(start);
        let mut points = crate::solve::RADAU.map(|c| self.euler_step(start, &start_rates, c * h));
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
                return Some(self.result(start, &points, &rates, &turns, h));
            }
            // The iteration has stagnated at the level of rounding errors.
            if round > 8 && change > 0.5 * last_change {
                let converged = change <= 4.0 * self.tolerance;
                return converged.then(|| self.result(start, &points, &rates, &turns, h));
            }
            last_change = change;
            rates = core::array::from_fn(|j| match round {
                ..SLOPE_UPDATES => self.rates(&points[j]),
                _ => self.rates_with_slope(&points[j], rates[j].slope),
            });
        }
        None
    }

    fn euler_step(&self, start: &Polar, rates: &Rates, h: f64) -> Polar {
        let from = start.at.into_array();
        let at = core::array::from_fn(|i| from[i] + h * rates.at[i]);
        Polar {
            at: Coordinates::from_array(&at),
            speed: (start.speed + h * rates.speed).max(0.0),
            turn: start.turn,
        }
    }

    /// δ′ at the points, from r δ′ = sideways + slope · (change of δ), which is linear in the δ′.
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
        // In plane motion the direction is constant.
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

    /// The largest change of the points, relative to the error scales.
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
        let end = self.cartesian(&points[POINTS - 1]);
        let scales = self.phase_system.scales_at_slip_onset(&end);
        Scales {
            speed: scales.slip_x,
            turn: direction_scale(&scales, self.direction, points[POINTS - 1].speed),
            at: scales.into_array(),
        }
    }

    /// The sum of the rates, rad/s.
    fn rate_scale(&self, u: &Coordinates<f64>) -> f64 {
        self.phase_system.error_scale.tilt_rate(u) + u.s.abs()
    }

    fn result(
        &self,
        start: &Polar,
        points: &[Polar; POINTS],
        rates: &[Rates; POINTS],
        turns: &[f64; POINTS],
        h: f64,
    ) -> CollocationStep {
        let scales = self.scales(points);
        let states = points.map(|point| self.cartesian(&point).into_array());
        let step = self
            .method
            .through(h, &self.cartesian(start).into_array(), &states);
        let speeds = core::array::from_fn(|j| rates[j].speed);
        let mut error = self
            .method
            .error(h, &speeds, scales.speed)
            .max(self.method.error(h, turns, scales.turn));
        for i in 0..COORDINATES {
            let rates = core::array::from_fn(|j| rates[j].at[i]);
            error = error.max(self.method.error(h, &rates, scales.at[i]));
        }
        let end = points[POINTS - 1];
        let (before, after) = (
            self.rate_scale(&start.at),
            self.rate_scale(&points[POINTS - 1].at),
        );
        // The collocation equations can have another solution far from the start. A NaN compares as false.
        let is_near = after < MAX_RATE_GROWTH * before;
        if !is_near {
            error = f64::INFINITY;
        }
        CollocationStep {
            step,
            error: error / self.tolerance,
            relaxation: h * rates[POINTS - 1].slope.abs() / end.speed,
            until_stop: until_stop(end.speed, rates[POINTS - 1].speed),
            end,
        }
    }
}

/// The error scales of the polar coordinates.
struct Scales {
    at: [f64; COORDINATES],
    speed: f64,
    turn: f64,
}

/// The components of a horizontal vector along a unit vector and across it.
#[inline(always)]
pub(crate) fn along_and_across<T: Real>([x, y]: [T; 2], [unit_x, unit_y]: [T; 2]) -> [T; 2] {
    [x * unit_x + y * unit_y, y * unit_x - x * unit_y]
}

/// A unit vector rotated by an angle.
pub(crate) fn rotated(e: [f64; 2], angle: f64) -> [f64; 2] {
    let (sin, cos) = libm::sincos(angle);
    [e[0] * cos - e[1] * sin, e[1] * cos + e[0] * sin]
}

/// The time until a slip of this speed stops if the rate of the speed stays the same.
#[inline(always)]
pub(crate) fn until_stop<T: Real>(speed: T, rate: T) -> T {
    speed / (-rate).max(T::from(0.0))
}

/// The factor from one step size to the next, within the bounds after an accepted step.
pub(crate) fn growth(factor: f64) -> f64 {
    factor.clamp(0.3, 4.0)
}

/// The size of the next step, which must not pass the end of a slip that is about to stop.
pub(crate) fn next_step(h: f64, growth: f64, until_stop: f64) -> f64 {
    (h * growth).min(0.9 * until_stop)
}
