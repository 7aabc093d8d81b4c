//! Slip as it begins out of rest under dry friction, eight at a time.
//!
//! At first the direction of the slip follows the forces at once, and no explicit step is short enough; see
//! the onset of a single motion, in [`motion`](crate::motion). Some steps of collocation lead to where
//! explicit steps can follow. In the direction in which a step begins the slip has the part σ, and across
//! it the part σ q; with the accelerations a along and a′ across,
//!
//! ```text
//! σ′ = a,    σ q′ = a′ − q a
//! ```
//!
//! where the second is stiff, and is solved by Newton's method; everything else by simple iteration, a
//! fixed number of times, so that no fall depends on those beside it.

use super::carried::{Carried, Slipping};
use crate::real::{LANES, Lanes, Real};
use crate::solve::{Collocation, POINTS, RADAU};
use crate::state::Coordinates;
use crate::yardstick::{NEVER_ZERO, turn_size};
use core::hint::black_box;

/// The coordinates that are carried; the slip's are σ and q here.
const N: usize = 10;

/// Those of them that the rates depend on.
const FELT: usize = <Slipping<Lanes> as Carried<Lanes, N>>::FELT;

/// Where σ and q stand.
const ALONG: usize = 0;
const ACROSS: usize = 1;

const ROUNDS: usize = 9;

/// After so many rounds the slopes are as good as those of the solution.
const FRESH_SLOPES: usize = 2;

/// The same for the direction in which a slip begins.
const TURNS: usize = 5;
const FRESH_TURNS: usize = 3;

/// Explicit steps take over where q relaxes no oftener than this in a step of collocation.
const FOLLOWED: f64 = 20.0;

/// So many steps are made at most, and tried in vain.
const MOST_STEPS: usize = 12;

/// A slip that begins, or goes on slowly.
#[derive(Clone, Copy)]
pub(super) struct Beginning {
    at: Coordinates<f64>,
    /// Of the slip, a unit vector along e_x1 and e_y1.
    direction: [f64; 2],
    /// m/s.
    speed: f64,
    /// μ.
    friction: f64,
    /// How long a step to make, by the clock that does not slow down.
    h: f64,
    steps: usize,
}

impl Beginning {
    /// Out of rest in about this direction, a unit vector; `h` is a first guess for the length of a step.
    pub(super) fn from_rest(
        at: &Coordinates<f64>,
        direction: [f64; 2],
        friction: f64,
        h: f64,
    ) -> Self {
        let at = Coordinates {
            slip_x: 0.0,
            slip_y: 0.0,
            ..*at
        };
        Beginning {
            at,
            direction,
            speed: 0.0,
            friction,
            h,
            steps: 0,
        }
    }
}

/// What has become of it.
pub(super) enum Begun {
    /// Here explicit steps can follow, the first of this length.
    Follow(Coordinates<f64>, f64),
    /// Another step of collocation is to be made.
    Again(Beginning),
    /// It cannot be followed in this way.
    Lost,
}

/// Makes a step in each of eight slips.
pub(super) fn begin<F: Fn(Lanes) -> Slipping<Lanes>>(
    law: F,
    beginnings: &[Beginning; LANES],
    tolerance: f64,
) -> impl Iterator<Item = Begun> + use<F> {
    let lanes = |f: fn(&Beginning) -> f64| Lanes(beginnings.each_ref().map(f));
    let starts: [[f64; N]; LANES] =
        beginnings.map(|beginning| <Slipping<f64> as Carried<f64, N>>::of(&beginning.at));
    let mut together = Together {
        slipping: law(lanes(|b| b.friction)),
        direction: [lanes(|b| b.direction[0]), lanes(|b| b.direction[1])],
        start: core::array::from_fn(|i| Lanes(starts.map(|start| start[i]))),
        speed: lanes(|b| b.speed),
        h: lanes(|b| b.h),
        push: Lanes::from(0.0),
        tolerance,
    };
    let found = together.step();
    let beginnings = *beginnings;
    (0..LANES).map(move |lane| found.begun(lane, &beginnings[lane]))
}

impl Found {
    fn begun(&self, lane: usize, beginning: &Beginning) -> Begun {
        let [error, change, relaxation, possible] =
            [self.error, self.change, self.relaxation, self.possible].map(|of_all| of_all.0[lane]);
        // Written so that a NaN is not possible.
        let possible = possible >= 0.0;
        if !possible {
            return Begun::Lost;
        }
        let h = beginning.h;
        let steps = beginning.steps + 1;
        let factor = 0.8 / libm::pow(error.max(1e-9), 1.0 / 7.0);
        // Written so that a NaN is not good.
        let good = error <= 1.0 && change <= 1.0;
        if !good {
            let h = h * factor.clamp(0.1, 0.5);
            let again = Beginning {
                h,
                steps,
                ..*beginning
            };
            return if steps < MOST_STEPS && h > 0.0 {
                Begun::Again(again)
            } else {
                Begun::Lost
            };
        }
        let at = <Slipping<f64> as Carried<f64, N>>::all(&self.end.map(|of_all| of_all.0[lane]));
        let factor = factor.clamp(0.3, 4.0);
        if relaxation * factor < FOLLOWED || steps >= MOST_STEPS {
            return Begun::Follow(at, h / relaxation.max(1.0) / self.clock.0[lane]);
        }
        let speed = at.slip_speed();
        Begun::Again(Beginning {
            at,
            direction: [at.slip_x / speed, at.slip_y / speed],
            speed,
            // Not beyond the end of a slip that is about to stop.
            h: (h * factor).min(0.9 * self.until_stop.0[lane]),
            steps,
            ..*beginning
        })
    }
}

struct Together {
    slipping: Slipping<Lanes>,
    direction: [Lanes; 2],
    start: [Lanes; N],
    speed: Lanes,
    h: Lanes,
    /// What is added to σ′: friction is exceeded where slip begins, but for rounding.
    push: Lanes,
    tolerance: f64,
}

struct Found {
    end: [Lanes; N],
    clock: Lanes,
    /// In what time the slip would stop at the rate at its end.
    until_stop: Lanes,
    /// Over what is tolerated.
    error: Lanes,
    /// In the last round, over what is tolerated.
    change: Lanes,
    /// How often q relaxes in the step.
    relaxation: Lanes,
    /// Not negative where the slip can begin.
    possible: Lanes,
}

/// Rates at the points: of σ in the place of `ALONG`; σ q′ in the place of `ACROSS`.
type Points = [[Lanes; N]; POINTS];

impl Together {
    fn step(&mut self) -> Found {
        #[cfg(target_arch = "x86_64")]
        if std::arch::is_x86_feature_detected!("avx512f") {
            // SAFETY: the processor has what the function is compiled for.
            return unsafe { self.step_by_avx512() };
        }
        #[cfg(target_arch = "x86_64")]
        if std::arch::is_x86_feature_detected!("avx2") {
            // SAFETY: the processor has what the function is compiled for.
            return unsafe { self.step_by_avx2() };
        }
        self.step_anywhere()
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx512f")]
    unsafe fn step_by_avx512(&mut self) -> Found {
        self.step_anywhere()
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2")]
    unsafe fn step_by_avx2(&mut self) -> Found {
        self.step_anywhere()
    }

    #[inline(always)]
    fn step_anywhere(&mut self) -> Found {
        let method = Collocation::get();
        let zero = Lanes::from(0.0);
        let mut start = self.start;
        (start[ALONG], start[ACROSS]) = (self.speed, zero);
        let from_rest = self.speed.at_most(zero);
        let settled = self.settle(&start);
        let possible = settled.min(self.slipping.can_begin(&start, self.direction));
        let first = self.rates(&start);
        self.push = from_rest.choose((-first[ALONG]).max(zero), zero);
        let mut points: Points = RADAU.map(|c| self.moved(&start, &first, c));
        let mut rates = points;
        let mut slopes = [zero; POINTS];
        let mut change = zero;
        for round in 0..ROUNDS {
            for j in 0..POINTS {
                rates[j] = self.rates(&points[j]);
                if round < FRESH_SLOPES {
                    slopes[j] = self.slope(&points[j]);
                }
            }
            let turns = self.turns(method, &points, &rates, &slopes);
            for j in 0..POINTS {
                rates[j][ACROSS] = turns[j];
            }
            let before = points;
            let last = round + 1 == ROUNDS;
            let count = if last { N } else { FELT };
            self.integrate(method, &start, &rates, &mut points, count);
            if last {
                change = self.change(&before, &points);
            }
        }
        let possible = from_rest.choose(possible, zero);
        self.found(method, &points, &rates, &slopes, change, possible)
    }

    /// Turns the direction of a slip out of rest to the one that it keeps: any other is left at once.
    /// Not negative where one is found close by. By Newton's method.
    #[inline(always)]
    fn settle(&mut self, start: &[Lanes; N]) -> Lanes {
        let zero = Lanes::from(0.0);
        let from_rest = self.speed.at_most(zero);
        let (mut point, mut slope, mut turn) = (*start, zero, zero);
        for round in 0..TURNS {
            if round < FRESH_TURNS {
                slope = self.slope(&point);
            }
            turn = from_rest.choose(self.rates(&point)[ACROSS] / slope, zero);
            point[ACROSS] = point[ACROSS] - turn;
        }
        let q = point[ACROSS].abs();
        self.direction = self.along(point[ACROSS]);
        let size = q + self.direction[1].abs() + Lanes::from(NEVER_ZERO);
        let close = Lanes::from(self.tolerance) * size - turn.abs();
        // A direction attracts when the slip is turned toward it from both sides.
        close.min(-slope).min(Lanes::from(1.0) - q)
    }

    /// The first `count` coordinates at the points, by the rates there.
    #[expect(
        clippy::needless_range_loop,
        reason = "the indices are those of the formulas"
    )]
    #[inline(always)]
    fn integrate(
        &self,
        method: &Collocation,
        start: &[Lanes; N],
        rates: &Points,
        points: &mut Points,
        count: usize,
    ) {
        // Compilers are kept from taking several at once: else they lose the order of the lanes.
        for k in (0..count).map(black_box) {
            for i in (0..POINTS).map(black_box) {
                let mut sum = Lanes::from(0.0);
                for j in 0..POINTS {
                    sum = sum + Lanes::from(method.integral[i][j]) * rates[j][k];
                }
                points[i][k] = start[k] + self.h * sum;
            }
        }
    }

    /// The largest change of what the rates depend on.
    #[inline(always)]
    fn change(&self, before: &Points, after: &Points) -> Lanes {
        let sizes = self.sizes(&after[POINTS - 1]);
        let mut largest = Lanes::from(0.0);
        for k in 0..FELT {
            let mut change = Lanes::from(0.0);
            for i in 0..POINTS {
                change = change.max((after[i][k] - before[i][k]).abs());
            }
            largest = largest.max(change / sizes[k]);
        }
        largest
    }

    /// A first guess for a point.
    #[inline(always)]
    fn moved(&self, start: &[Lanes; N], rates: &[Lanes; N], c: f64) -> [Lanes; N] {
        let mut point = *start;
        for i in 0..N {
            if i != ACROSS {
                point[i] = start[i] + Lanes::from(c) * self.h * rates[i];
            }
        }
        point[ALONG] = point[ALONG].max(Lanes::from(0.0));
        point
    }

    /// The unit vector along a slip with this q.
    #[inline(always)]
    fn along(&self, q: Lanes) -> [Lanes; 2] {
        let one = Lanes::from(1.0);
        let per_length = one / (one + q * q).sqrt();
        let [x, y] = self.direction;
        [per_length * (x - q * y), per_length * (y + q * x)]
    }

    /// With the slip's components in the place of σ and q.
    #[inline(always)]
    fn whole(&self, point: &[Lanes; N]) -> [Lanes; N] {
        let (along, q) = (point[ALONG], point[ACROSS]);
        let [x, y] = self.direction;
        let mut whole = *point;
        whole[ALONG] = along * (x - q * y);
        whole[ACROSS] = along * (y + q * x);
        whole
    }

    #[inline(always)]
    fn rates(&self, point: &[Lanes; N]) -> [Lanes; N] {
        let q = point[ACROSS];
        let mut rates = self
            .slipping
            .rates_against(&self.whole(point), self.along(q));
        let [x, y] = self.direction;
        let along = rates[ALONG] * x + rates[ACROSS] * y;
        let across = rates[ACROSS] * x - rates[ALONG] * y;
        rates[ALONG] = along + self.push;
        rates[ACROSS] = across - q * rates[ALONG];
        rates
    }

    /// The derivative of σ q′ by q where only the friction's direction depends on it.
    #[inline(always)]
    fn slope(&self, point: &[Lanes; N]) -> Lanes {
        const NUDGE: f64 = 1e-5;
        let beside = |nudge: f64| {
            let mut point = *point;
            point[ACROSS] = point[ACROSS] + Lanes::from(nudge);
            self.rates(&point)[ACROSS]
        };
        (beside(NUDGE) - beside(-NUDGE)) * Lanes::from(0.5 / NUDGE)
    }

    /// q′ at the points, from σ q′ = what it is + slope · (change of q), which is linear in them.
    #[expect(
        clippy::needless_range_loop,
        reason = "the indices are those of the formulas"
    )]
    #[inline(always)]
    fn turns(
        &self,
        method: &Collocation,
        points: &Points,
        rates: &Points,
        slopes: &[Lanes; POINTS],
    ) -> [Lanes; POINTS] {
        let zero = Lanes::from(0.0);
        let mut matrix = [[zero; POINTS]; POINTS];
        let mut right = [zero; POINTS];
        for i in 0..POINTS {
            for j in 0..POINTS {
                matrix[i][j] = -(slopes[i] * self.h) * Lanes::from(method.integral[i][j]);
            }
            matrix[i][i] = matrix[i][i] + points[i][ALONG];
            right[i] = rates[i][ACROSS] - slopes[i] * points[i][ACROSS];
        }
        // The slopes are negative and the diagonal is large: no pivot is needed.
        for i in 0..POINTS {
            let per_pivot = Lanes::from(1.0) / matrix[i][i];
            for row in i + 1..POINTS {
                let factor = matrix[row][i] * per_pivot;
                for k in i + 1..POINTS {
                    matrix[row][k] = matrix[row][k] - factor * matrix[i][k];
                }
                right[row] = right[row] - factor * right[i];
            }
            matrix[i][i] = per_pivot;
        }
        for i in (0..POINTS).rev() {
            for k in i + 1..POINTS {
                right[i] = right[i] - matrix[i][k] * right[k];
            }
            right[i] = right[i] * matrix[i][i];
        }
        right
    }

    /// What errors are compared with.
    #[inline(always)]
    fn sizes(&self, end: &[Lanes; N]) -> [Lanes; N] {
        let mut sizes = self.slipping.sizes(&self.whole(end));
        let slip = Slipping::<Lanes>::all(&sizes);
        sizes[ACROSS] = turn_size(&slip, self.direction, end[ALONG]);
        sizes
    }

    #[expect(
        clippy::needless_range_loop,
        reason = "the indices are those of the formulas"
    )]
    #[inline(always)]
    fn found(
        &self,
        method: &Collocation,
        points: &Points,
        rates: &Points,
        slopes: &[Lanes; POINTS],
        change: Lanes,
        possible: Lanes,
    ) -> Found {
        let end = points[POINTS - 1];
        let sizes = self.sizes(&end);
        // What the highest power contributes bounds what those left out do.
        let mut error = Lanes::from(0.0);
        for k in 0..N {
            let mut highest = Lanes::from(0.0);
            for j in 0..POINTS {
                highest = highest + Lanes::from(method.last[j]) * rates[j][k];
            }
            error = error.max((Lanes::from(0.05) * self.h * highest / sizes[k]).abs());
        }
        // A slip that does not last is none.
        let mut least = end[ALONG];
        for point in points {
            least = least.min(point[ALONG]);
        }
        let error = least.where_negative(Lanes::from(f64::INFINITY), error);
        let whole = self.whole(&end);
        Found {
            end: whole,
            until_stop: end[ALONG] / (-rates[POINTS - 1][ALONG]).max(Lanes::from(0.0)),
            clock: self.slipping.clock(&Slipping::<Lanes>::all(&whole)),
            error: error * Lanes::from(1.0 / self.tolerance),
            change: change * Lanes::from(50.0 / self.tolerance),
            relaxation: self.h * slopes[POINTS - 1].abs() / end[ALONG],
            possible,
        }
    }
}
