//! Slip as it begins out of rest under dry friction, sixteen at a time.
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

use super::reduced_system::{ReducedSliding, ReducedSystem};
use crate::error_scale::{NEVER_ZERO, direction_scale};
use crate::real::{LANES, Lanes, Mask, Packed, SimdKernel, Vector, run_widest};
use crate::solve::{Collocation, POINTS, RADAU};
use crate::state::Coordinates;

/// The coordinates that are carried; the slip's are σ and q here.
const N: usize = 10;

/// Those of them that the rates depend on.
const ESSENTIAL: usize = <ReducedSliding<f64> as ReducedSystem<f64, N>>::ESSENTIAL;

/// Where σ and q stand.
const ALONG: usize = 0;
const ACROSS: usize = 1;

/// Of iteration; a step that has not met by then is tried again shorter.
const ROUNDS: usize = 7;

/// After so many rounds the slopes are as good as those of the solution.
const FRESH_SLOPES: usize = 2;

/// The same for the direction in which a slip begins.
const TURNS: usize = 5;
const FRESH_TURNS: usize = 3;

/// Explicit steps take over where q relaxes no oftener than this in a step of collocation.
const FOLLOWED: f64 = 40.0;

/// So many steps are made at most, and tried in vain.
const MAX_STEPS: usize = 12;

/// A step that failed is tried again by no less than this factor shorter.
const MIN_FACTOR: f64 = 0.1;

/// A slip that begins, or goes on slowly.
#[derive(Clone, Copy)]
pub(super) struct OnsetStart {
    at: Coordinates<f64>,
    /// Of the slip, a unit vector along e_x1 and e_y1.
    direction: [f64; 2],
    /// m/s.
    speed: f64,
    /// The body under its friction.
    slipping: ReducedSliding<f64>,
    /// How long a step to make, by the clock that does not slow down.
    h: f64,
    steps: usize,
}

impl OnsetStart {
    /// Out of rest in about this direction, a unit vector; `h` is a first guess for the length of a step.
    pub(super) fn from_rest(
        at: &Coordinates<f64>,
        direction: [f64; 2],
        slipping: ReducedSliding<f64>,
        h: f64,
    ) -> Self {
        let at = Coordinates {
            slip_x: 0.0,
            slip_y: 0.0,
            ..*at
        };
        OnsetStart {
            at,
            direction,
            speed: 0.0,
            slipping,
            h,
            steps: 0,
        }
    }
}

/// What has become of it.
pub(super) enum OnsetResult {
    /// Here explicit steps can follow, the first of this length.
    Follow(Coordinates<f64>, f64),
    /// Another step of collocation is to be made.
    Again(OnsetStart),
    /// It cannot be followed in this way.
    Lost,
}

/// Makes a step in each of sixteen slips.
pub(super) fn step_batch(
    beginnings: &[OnsetStart; LANES],
    tolerance: f64,
) -> impl Iterator<Item = OnsetResult> + use<> {
    let mut slipping = beginnings[0]
        .slipping
        .with_numbers(|&number| Lanes::from(number));
    for (lane, beginning) in beginnings.iter().enumerate().skip(1) {
        let write = |number: &f64, lanes: &mut Lanes| lanes.0[lane] = *number;
        beginning.slipping.write_to(&mut slipping, write);
    }
    let lanes = |f: fn(&OnsetStart) -> f64| Packed(beginnings.each_ref().map(f));
    let starts: [[f64; N]; LANES] = beginnings
        .map(|beginning| <ReducedSliding<f64> as ReducedSystem<f64, N>>::project(&beginning.at));
    let step_found = run_widest(OnsetKernel {
        slipping: &slipping,
        direction: [lanes(|b| b.direction[0]), lanes(|b| b.direction[1])],
        start: core::array::from_fn(|i| Packed(starts.map(|start| start[i]))),
        speed: lanes(|b| b.speed),
        h: lanes(|b| b.h),
        tolerance,
    });
    let beginnings = *beginnings;
    (0..LANES).map(move |lane| step_found.result(lane, &beginnings[lane]))
}

/// What sixteen slips begin with.
#[derive(Clone, Copy)]
struct OnsetKernel<'a> {
    slipping: &'a ReducedSliding<Lanes>,
    direction: [Lanes; 2],
    start: [Lanes; N],
    speed: Lanes,
    h: Lanes,
    tolerance: f64,
}

impl SimdKernel for OnsetKernel<'_> {
    type Done = OnsetStep;

    #[inline(always)]
    fn run<V: Vector>(self) -> OnsetStep {
        let mut batch = BatchOnset {
            slipping: self.slipping.with_numbers(V::load),
            direction: V::load_all(&self.direction),
            start: V::load_all(&self.start),
            speed: V::load(&self.speed),
            h: V::load(&self.h),
            push: V::from(0.0),
            tolerance: self.tolerance,
        };
        batch.step()
    }
}

impl OnsetStep {
    fn result(&self, lane: usize, beginning: &OnsetStart) -> OnsetResult {
        let [error, change, relaxation, possible, factor] = [
            self.error,
            self.change,
            self.relaxation,
            self.possible,
            self.factor,
        ]
        .map(|of_all| of_all.0[lane]);
        // Written so that a NaN is not possible.
        let possible = possible >= 0.0;
        if !possible {
            return OnsetResult::Lost;
        }
        let h = beginning.h;
        let steps = beginning.steps + 1;
        // Written so that a NaN is not good.
        let good = error <= 1.0 && change <= 1.0;
        if !good {
            let h = h * factor.clamp(MIN_FACTOR, 0.5);
            let again = OnsetStart {
                h,
                steps,
                ..*beginning
            };
            return if steps < MAX_STEPS && h > 0.0 {
                OnsetResult::Again(again)
            } else {
                OnsetResult::Lost
            };
        }
        let at = <ReducedSliding<f64> as ReducedSystem<f64, N>>::expand(
            &self.end.map(|of_all| of_all.0[lane]),
        );
        let factor = factor.clamp(0.3, 4.0);
        if relaxation * factor < FOLLOWED || steps >= MAX_STEPS {
            return OnsetResult::Follow(at, h / relaxation.max(1.0) / self.clock.0[lane]);
        }
        let speed = at.slip_speed();
        OnsetResult::Again(OnsetStart {
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

struct BatchOnset<V> {
    slipping: ReducedSliding<V>,
    direction: [V; 2],
    start: [V; N],
    speed: V,
    h: V,
    /// What is added to σ′: friction is exceeded where slip begins, but for rounding.
    push: V,
    tolerance: f64,
}

#[derive(Debug, PartialEq)]
struct OnsetStep {
    end: [Lanes; N],
    clock: Lanes,
    /// In what time the slip would stop at the rate at its end.
    until_stop: Lanes,
    /// Over what is tolerated.
    error: Lanes,
    /// By what factor the next step may about be longer.
    factor: Lanes,
    /// In the last round, over what is tolerated.
    change: Lanes,
    /// How often q relaxes in the step.
    relaxation: Lanes,
    /// Not negative where the slip can begin.
    possible: Lanes,
}

/// Rates at the points: of σ in the place of `ALONG`; σ q′ in the place of `ACROSS`.
type Points<V> = [[V; N]; POINTS];

impl<V: Vector> BatchOnset<V> {
    #[inline(always)]
    fn step(&mut self) -> OnsetStep {
        let method = Collocation::get();
        let zero = V::from(0.0);
        let mut start = self.start;
        (start[ALONG], start[ACROSS]) = (self.speed, zero);
        let from_rest = self.speed.at_most(zero);
        let mut possible = zero;
        if from_rest.bits() != 0 {
            let settled = self.settle(&start, from_rest);
            let begins = settled.min(self.slipping.can_begin(&start, self.direction));
            possible = from_rest.choose(begins, zero);
        }
        let first = self.rates(&start);
        self.push = from_rest.choose((-first[ALONG]).max(zero), zero);
        let mut points: Points<V> = [start; POINTS];
        for (point, c) in points.iter_mut().zip(RADAU) {
            *point = self.moved(&start, &first, c);
        }
        let mut rates = points;
        let mut slopes = [zero; POINTS];
        let mut change = zero;
        for round in 0..ROUNDS {
            for j in 0..POINTS {
                rates[j] = self.rates(&points[j]);
                if round < FRESH_SLOPES {
                    slopes[j] = self.slope(&points[j], rates[j][ACROSS]);
                }
            }
            let turns = self.turns(method, &points, &rates, &slopes);
            for j in 0..POINTS {
                rates[j][ACROSS] = turns[j];
            }
            let before = points;
            let last = round + 1 == ROUNDS;
            let count = if last { N } else { ESSENTIAL };
            self.integrate(method, &start, &rates, &mut points, count);
            if last {
                change = self.change(&before, &points);
            }
        }
        self.step_found(method, &points, &rates, &slopes, change, possible)
    }

    /// Turns the direction of a slip out of rest to the one that it keeps: any other is left at once.
    /// Not negative where one is found close by. By Newton's method.
    #[inline(always)]
    fn settle(&mut self, start: &[V; N], from_rest: V::Mask) -> V {
        let zero = V::from(0.0);
        let (mut point, mut slope, mut turn) = (*start, zero, zero);
        for round in 0..TURNS {
            let across = self.rates(&point)[ACROSS];
            if round < FRESH_TURNS {
                slope = self.slope(&point, across);
            }
            turn = from_rest.choose(across / slope, zero);
            point[ACROSS] = point[ACROSS] - turn;
        }
        let q = point[ACROSS].abs();
        // A slip under way keeps its own to the last bit, as where none beside it comes out of rest.
        let ([x, y], [kept_x, kept_y]) = (self.along(point[ACROSS]), self.direction);
        self.direction = [from_rest.choose(x, kept_x), from_rest.choose(y, kept_y)];
        let size = q + self.direction[1].abs() + V::from(NEVER_ZERO);
        let close = V::from(self.tolerance) * size - turn.abs();
        // A direction attracts when the slip is turned toward it from both sides.
        close.min(-slope).min(V::from(1.0) - q)
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
        start: &[V; N],
        rates: &Points<V>,
        points: &mut Points<V>,
        count: usize,
    ) {
        // Compilers are kept from taking several at once: else they lose the order of the lanes.
        for k in (0..count).map(V::opaque) {
            for i in (0..POINTS).map(V::opaque) {
                let mut sum = V::from(0.0);
                for j in 0..POINTS {
                    sum = sum + V::from(method.integral[i][j]) * rates[j][k];
                }
                points[i][k] = start[k] + self.h * sum;
            }
        }
    }

    /// The largest change of what the rates depend on.
    #[inline(always)]
    fn change(&self, before: &Points<V>, after: &Points<V>) -> V {
        let scales = self.scales(&after[POINTS - 1]);
        let mut largest = V::from(0.0);
        for k in 0..ESSENTIAL {
            let mut change = V::from(0.0);
            for i in 0..POINTS {
                change = change.max((after[i][k] - before[i][k]).abs());
            }
            largest = largest.max(change / scales[k]);
        }
        largest
    }

    /// A first guess for a point.
    #[inline(always)]
    fn moved(&self, start: &[V; N], rates: &[V; N], c: f64) -> [V; N] {
        let mut point = *start;
        for i in 0..N {
            if i != ACROSS {
                point[i] = start[i] + V::from(c) * self.h * rates[i];
            }
        }
        point[ALONG] = point[ALONG].max(V::from(0.0));
        point
    }

    /// The unit vector along a slip with this q.
    #[inline(always)]
    fn along(&self, q: V) -> [V; 2] {
        let one = V::from(1.0);
        let per_length = one / (one + q * q).sqrt();
        let [x, y] = self.direction;
        [per_length * (x - q * y), per_length * (y + q * x)]
    }

    /// With the slip's components in the place of σ and q.
    #[inline(always)]
    fn whole(&self, point: &[V; N]) -> [V; N] {
        let (along, q) = (point[ALONG], point[ACROSS]);
        let [x, y] = self.direction;
        let mut whole = *point;
        whole[ALONG] = along * (x - q * y);
        whole[ACROSS] = along * (y + q * x);
        whole
    }

    #[inline(always)]
    fn rates(&self, point: &[V; N]) -> [V; N] {
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

    /// The derivative of σ q′, which is `across` at a point, by q where only the friction's direction depends
    /// on it.
    #[inline(always)]
    fn slope(&self, point: &[V; N], across: V) -> V {
        const NUDGE: f64 = 1e-6;
        let mut beside = *point;
        beside[ACROSS] = beside[ACROSS] + V::from(NUDGE);
        (self.rates(&beside)[ACROSS] - across) * V::from(1.0 / NUDGE)
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
        points: &Points<V>,
        rates: &Points<V>,
        slopes: &[V; POINTS],
    ) -> [V; POINTS] {
        let zero = V::from(0.0);
        let mut matrix = [[zero; POINTS]; POINTS];
        let mut right = [zero; POINTS];
        for i in 0..POINTS {
            for j in 0..POINTS {
                matrix[i][j] = -(slopes[i] * self.h) * V::from(method.integral[i][j]);
            }
            matrix[i][i] = matrix[i][i] + points[i][ALONG];
            right[i] = rates[i][ACROSS] - slopes[i] * points[i][ACROSS];
        }
        // The slopes are negative and the diagonal is large: no pivot is needed.
        for i in 0..POINTS {
            let per_pivot = V::from(1.0) / matrix[i][i];
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
    fn scales(&self, end: &[V; N]) -> [V; N] {
        let mut scales = self.slipping.scales_at_onset(&self.whole(end));
        let slip = ReducedSliding::<V>::expand(&scales);
        scales[ACROSS] = direction_scale(&slip, self.direction, end[ALONG]);
        scales
    }

    #[expect(
        clippy::needless_range_loop,
        reason = "the indices are those of the formulas"
    )]
    #[inline(always)]
    fn step_found(
        &self,
        method: &Collocation,
        points: &Points<V>,
        rates: &Points<V>,
        slopes: &[V; POINTS],
        change: V,
        possible: V,
    ) -> OnsetStep {
        let end = points[POINTS - 1];
        let scales = self.scales(&end);
        // What the highest power contributes bounds what those left out do.
        let mut error = V::from(0.0);
        for k in 0..N {
            let mut highest = V::from(0.0);
            for j in 0..POINTS {
                highest = highest + V::from(method.last[j]) * rates[j][k];
            }
            error = error.max((V::from(0.05) * self.h * highest / scales[k]).abs());
        }
        // A slip that does not last is none.
        let mut least = end[ALONG];
        for point in points {
            least = least.min(point[ALONG]);
        }
        let error = least.where_negative(V::from(f64::INFINITY), error);
        let error = error * V::from(1.0 / self.tolerance);
        let whole = self.whole(&end);
        // The error grows with the seventh power: by an eighth root, 6 % rough, the next step is good enough where
        // this one was not ten thousand times too far off.
        let factor = V::from(0.8) * V::approx_16th_root_of(V::from(1.0), error * error);
        let is_number = error.at_most(V::from(f64::MAX));
        OnsetStep {
            end: V::store_all(whole),
            until_stop: (end[ALONG] / (-rates[POINTS - 1][ALONG]).max(V::from(0.0))).store(),
            clock: self
                .slipping
                .sundman_factor(&ReducedSliding::<V>::expand(&whole))
                .store(),
            error: error.store(),
            factor: is_number.choose(factor, V::from(MIN_FACTOR)).store(),
            // A fifth of the tolerance: the next round would change far less.
            change: (change * V::from(5.0 / self.tolerance)).store(),
            relaxation: (self.h * slopes[POINTS - 1].abs() / end[ALONG]).store(),
            possible: possible.store(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{LANES, N, OnsetKernel, Packed, ReducedSliding, ReducedSystem};
    use crate::law::Parameters;
    use crate::presets;
    use crate::real::{Lanes, in_every_width, run_widest};
    use crate::state::{Coordinates, State};
    use core::array::from_fn;

    #[test]
    fn the_width_of_the_registers_changes_no_bit() {
        let can = presets::can_2007().expect("the paper's can");
        let slipping = ReducedSliding::new(Parameters::new(&can, 9.8), 0.1);
        let slipping = &slipping.with_numbers(|&number| Lanes::from(number));
        // Every other one slips already.
        let speed: Lanes = Packed(from_fn(|lane| 1e-4 * (lane % 2) as f64));
        let starts: [[f64; N]; LANES] = from_fn(|lane| {
            let start = State {
                tilt: 0.02 + 0.001 * lane as f64,
                tilt_rate: -1.0,
                yaw_rate: 20.0,
                ..State::default()
            };
            ReducedSliding::project(&Coordinates {
                slip_x: speed.0[lane],
                ..Coordinates::from_state(&start)
            })
        });
        let done = in_every_width(|| OnsetKernel {
            slipping,
            direction: [Lanes::from(1.0), Lanes::from(0.0)],
            start: from_fn(|i| Packed(starts.map(|start| start[i]))),
            speed,
            h: Lanes::from(1e-5),
            tolerance: 1e-9,
        });
        assert!(done[0].end[0].0.iter().all(|slip| slip.is_finite()));
        for step_found in &done {
            assert_eq!(step_found, &done[0]);
        }
    }

    #[test]
    fn a_slip_under_way_does_not_feel_those_beside_it() {
        let can = presets::can_2007().expect("the paper's can");
        let slipping = ReducedSliding::new(Parameters::new(&can, 9.8), 0.1);
        let slipping = &slipping.with_numbers(|&number| Lanes::from(number));
        let start = State {
            tilt: 0.03,
            tilt_rate: -1.0,
            yaw_rate: 20.0,
            ..State::default()
        };
        // An angle whose sine and cosine are no round numbers.
        let (sin, cos) = libm::sincos(0.7);
        let step_found = |speed: Lanes| {
            let start = ReducedSliding::project(&Coordinates::from_state(&start));
            let mut start = start.map(Lanes::from);
            start[0] = Packed(speed.0.map(|speed| speed * cos));
            start[1] = Packed(speed.0.map(|speed| speed * sin));
            run_widest(OnsetKernel {
                slipping,
                direction: [Lanes::from(cos), Lanes::from(sin)],
                start,
                speed,
                h: Lanes::from(1e-5),
                tolerance: 1e-9,
            })
        };
        let alone = step_found(Lanes::from(1e-4));
        // Every other one begins from rest.
        let mixed = step_found(Packed(from_fn(|lane| 1e-4 * (lane % 2) as f64)));
        for lane in (1..LANES).step_by(2) {
            let [one, other] =
                [&alone, &mixed].map(|step_found| step_found.end.map(|of_all| of_all.0[lane]));
            assert_eq!(one, other, "lane {lane}");
        }
        assert_ne!(alone.end[0].0[0], mixed.end[0].0[0]);
    }
}
