//! The onset of slip under dry friction, in a batch of sixteen.
//!
//! At first the direction of the slip relaxes almost instantly to that of the forces, so the equations are too
//! stiff for explicit steps, as in the onset of a single motion ([`motion`](crate::motion)). Collocation steps
//! are made until explicit steps can follow. The slip has the component r along its direction at the start of
//! the step and r q across that direction. With the accelerations a along and a′ across,
//!
//! ```text
//! r′ = a,    r q′ = a′ − q a
//! ```
//!
//! The second equation is stiff and is solved by Newton's method; everything else is solved by fixed-point
//! iteration. The number of iterations is fixed, so that no fall depends on its neighbours in the batch.

use super::reduced_system::{ReducedSliding, ReducedSystem};
use crate::error_scale::{NEVER_ZERO, direction_scale};
use crate::motion::slip_onset::{SAFETY, along_and_across, growth, next_step, until_stop};
use crate::real::{LANES, Lanes, Mask, Packed, SimdKernel, Vector, run_widest};
use crate::solve::{Collocation, POINTS, RADAU};
use crate::state::Coordinates;

/// The number of reduced coordinates. Here r and q replace the components of the slip.
const N: usize = 10;

/// The number of leading coordinates on which the rates depend.
const ESSENTIAL: usize = <ReducedSliding<f64> as ReducedSystem<f64, N>>::ESSENTIAL;

/// The index of r.
const ALONG: usize = 0;
/// The index of q.
const ACROSS: usize = 1;

/// The number of iterations. A step that has not converged after them is repeated with a smaller step size.
const ROUNDS: usize = 7;

/// The number of iterations that recompute the slopes for Newton's method. After them the slopes hardly change.
const SLOPE_ROUNDS: usize = 2;

/// The number of Newton iterations for the initial direction of a slip.
const DIRECTION_ROUNDS: usize = 5;
/// The number of these iterations that recompute the slope.
const DIRECTION_SLOPE_ROUNDS: usize = 3;

/// Explicit steps take over when a collocation step spans fewer relaxation times of q than this.
const MAX_EXPLICIT_STIFFNESS: f64 = 40.0;

/// The maximal number of accepted and rejected steps.
const MAX_STEPS: usize = 12;

/// The minimal factor from a rejected step size to the next one.
const MIN_FACTOR: f64 = 0.1;

/// The start of a step in the onset of a slip.
#[derive(Clone, Copy)]
pub(super) struct OnsetStart {
    at: Coordinates<f64>,
    /// The direction of the slip, a unit vector along e_x1 and e_y1.
    direction: [f64; 2],
    /// m/s.
    speed: f64,
    /// The equations of the body under its friction.
    slipping: ReducedSliding<f64>,
    /// The step size in τ.
    h: f64,
    /// The number of steps so far.
    steps: usize,
}

impl OnsetStart {
    /// The start from rest in about this direction (unit vector); `h` is a first guess for the step size.
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

/// The result of a step.
pub(super) enum OnsetResult {
    /// Explicit steps can follow from these coordinates, the first one of this size.
    Follow(Coordinates<f64>, f64),
    /// Another collocation step must follow.
    Again(OnsetStart),
    /// The onset needs the scalar solver.
    Lost,
}

/// Makes a step in each of sixteen onsets.
pub(super) fn step_batch(
    starts: &[OnsetStart; LANES],
    tolerance: f64,
) -> impl Iterator<Item = OnsetResult> + use<> {
    let mut slipping = starts[0]
        .slipping
        .with_numbers(|&number| Lanes::from(number));
    for (lane, start) in starts.iter().enumerate().skip(1) {
        let write = |number: &f64, lanes: &mut Lanes| lanes.0[lane] = *number;
        start.slipping.write_to(&mut slipping, write);
    }
    let lanes = |f: fn(&OnsetStart) -> f64| Packed(starts.each_ref().map(f));
    let states: [[f64; N]; LANES] =
        starts.map(|start| <ReducedSliding<f64> as ReducedSystem<f64, N>>::project(&start.at));
    let onset_step = run_widest(OnsetKernel {
        slipping: &slipping,
        direction: [lanes(|s| s.direction[0]), lanes(|s| s.direction[1])],
        start: core::array::from_fn(|i| Packed(states.map(|state| state[i]))),
        speed: lanes(|s| s.speed),
        h: lanes(|s| s.h),
        tolerance,
    });
    let starts = *starts;
    (0..LANES).map(move |lane| onset_step.result(lane, &starts[lane]))
}

/// The starts of sixteen onsets in lanes.
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
            offset: V::from(0.0),
            tolerance: self.tolerance,
        };
        batch.step()
    }
}

impl OnsetStep {
    fn result(&self, lane: usize, start: &OnsetStart) -> OnsetResult {
        let [error, change, relaxation, possible, factor] = [
            self.error,
            self.change,
            self.relaxation,
            self.possible,
            self.factor,
        ]
        .map(|lanes| lanes.0[lane]);
        // A NaN counts as not possible.
        let possible = possible >= 0.0;
        if !possible {
            return OnsetResult::Lost;
        }
        let h = start.h;
        let steps = start.steps + 1;
        // A NaN counts as rejected.
        let accepted = error <= 1.0 && change <= 1.0;
        if !accepted {
            let h = h * factor.clamp(MIN_FACTOR, 0.5);
            let again = OnsetStart { h, steps, ..*start };
            return if steps < MAX_STEPS && h > 0.0 {
                OnsetResult::Again(again)
            } else {
                OnsetResult::Lost
            };
        }
        let at = <ReducedSliding<f64> as ReducedSystem<f64, N>>::expand(
            &self.end.map(|lanes| lanes.0[lane]),
        );
        let growth = growth(factor);
        if relaxation * growth < MAX_EXPLICIT_STIFFNESS || steps >= MAX_STEPS {
            return OnsetResult::Follow(at, h / relaxation.max(1.0) / self.sundman_factor.0[lane]);
        }
        let speed = at.slip_speed();
        OnsetResult::Again(OnsetStart {
            at,
            direction: [at.slip_x / speed, at.slip_y / speed],
            speed,
            h: next_step(h, growth, self.until_stop.0[lane]),
            steps,
            ..*start
        })
    }
}

struct BatchOnset<V> {
    slipping: ReducedSliding<V>,
    direction: [V; 2],
    start: [V; N],
    speed: V,
    h: V,
    /// Added to r′, so that rounding does not make it negative at the onset.
    offset: V,
    tolerance: f64,
}

#[derive(Debug, PartialEq)]
struct OnsetStep {
    end: [Lanes; N],
    /// dτ/dσ at the end of the step.
    sundman_factor: Lanes,
    /// The time in τ until the slip stops at the deceleration at the end of the step.
    until_stop: Lanes,
    /// The error relative to the tolerance.
    error: Lanes,
    /// The approximate factor to the next step size.
    factor: Lanes,
    /// The change in the last iteration, relative to the tolerance.
    change: Lanes,
    /// The step size over the relaxation time of q.
    relaxation: Lanes,
    /// Negative where the slip cannot start.
    possible: Lanes,
}

/// Coordinates at the collocation points, or their rates. Among the rates, r′ has the index `ALONG` and r q′ the
/// index `ACROSS`.
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
            let converged = self.settle(&start, from_rest);
            let can_begin = converged.min(self.slipping.can_begin(&start, self.direction));
            possible = from_rest.choose(can_begin, zero);
        }
        let first = self.rates(&start);
        self.offset = from_rest.choose((-first[ALONG]).max(zero), zero);
        let mut points: Points<V> = [start; POINTS];
        for (point, c) in points.iter_mut().zip(RADAU) {
            *point = self.first_guess(&start, &first, c);
        }
        let mut rates = points;
        let mut slopes = [zero; POINTS];
        let mut change = zero;
        for round in 0..ROUNDS {
            for j in 0..POINTS {
                rates[j] = self.rates(&points[j]);
                if round < SLOPE_ROUNDS {
                    slopes[j] = self.slope(&points[j], rates[j][ACROSS]);
                }
            }
            let q_rates = self.q_rates(method, &points, &rates, &slopes);
            for j in 0..POINTS {
                rates[j][ACROSS] = q_rates[j];
            }
            let before = points;
            let last = round + 1 == ROUNDS;
            let count = if last { N } else { ESSENTIAL };
            self.integrate(method, &start, &rates, &mut points, count);
            if last {
                change = self.change(&before, &points);
            }
        }
        self.onset_step(method, &points, &rates, &slopes, change, possible)
    }

    /// Rotates the direction of a slip from rest to the nearby direction in which the slip stays, by Newton's
    /// method; the slip leaves any other direction at once. The result is negative if no such direction is found.
    #[inline(always)]
    fn settle(&mut self, start: &[V; N], from_rest: V::Mask) -> V {
        let zero = V::from(0.0);
        let (mut point, mut slope, mut turn) = (*start, zero, zero);
        for round in 0..DIRECTION_ROUNDS {
            let across = self.rates(&point)[ACROSS];
            if round < DIRECTION_SLOPE_ROUNDS {
                slope = self.slope(&point, across);
            }
            turn = from_rest.choose(across / slope, zero);
            point[ACROSS] = point[ACROSS] - turn;
        }
        let q = point[ACROSS].abs();
        // A slip in progress keeps its direction to the last bit, whether or not its neighbours start from rest.
        let ([x, y], [kept_x, kept_y]) = (self.unit_vector(point[ACROSS]), self.direction);
        self.direction = [from_rest.choose(x, kept_x), from_rest.choose(y, kept_y)];
        let scale = q + self.direction[1].abs() + V::from(NEVER_ZERO);
        let close = V::from(self.tolerance) * scale - turn.abs();
        // A direction is stable if the slip rotates toward it from both sides.
        close.min(-slope).min(V::from(1.0) - q)
    }

    /// Computes the first `count` coordinates at the points from the rates there.
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
        // `opaque` keeps compilers from interleaving several sums, which would make them shuffle the lanes.
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

    /// The largest change of a coordinate that enters the rates, relative to its error scale.
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

    /// A first guess for a collocation point, extrapolated from the start at constant q.
    #[inline(always)]
    fn first_guess(&self, start: &[V; N], rates: &[V; N], c: f64) -> [V; N] {
        let mut point = *start;
        for i in 0..N {
            if i != ACROSS {
                point[i] = start[i] + V::from(c) * self.h * rates[i];
            }
        }
        point[ALONG] = point[ALONG].max(V::from(0.0));
        point
    }

    /// The direction (unit vector) of a slip with this q.
    #[inline(always)]
    fn unit_vector(&self, q: V) -> [V; 2] {
        let one = V::from(1.0);
        let per_length = one / (one + q * q).sqrt();
        let [x, y] = self.direction;
        [per_length * (x - q * y), per_length * (y + q * x)]
    }

    /// The reduced coordinates, with the slip's components in place of r and q.
    #[inline(always)]
    fn cartesian(&self, point: &[V; N]) -> [V; N] {
        let (along, q) = (point[ALONG], point[ACROSS]);
        let [x, y] = self.direction;
        let mut cartesian = *point;
        cartesian[ALONG] = along * (x - q * y);
        cartesian[ACROSS] = along * (y + q * x);
        cartesian
    }

    #[inline(always)]
    fn rates(&self, point: &[V; N]) -> [V; N] {
        let q = point[ACROSS];
        let mut rates = self
            .slipping
            .rates_against(&self.cartesian(point), self.unit_vector(q));
        let [along, across] = along_and_across([rates[ALONG], rates[ACROSS]], self.direction);
        rates[ALONG] = along + self.offset;
        rates[ACROSS] = across - q * rates[ALONG];
        rates
    }

    /// The derivative of r q′ with respect to q by a finite difference; in slow slip, it comes from the direction
    /// of the friction. `across` is r q′ at the point.
    #[inline(always)]
    fn slope(&self, point: &[V; N], across: V) -> V {
        const NUDGE: f64 = 1e-6;
        let mut shifted = *point;
        shifted[ACROSS] = shifted[ACROSS] + V::from(NUDGE);
        (self.rates(&shifted)[ACROSS] - across) * V::from(1.0 / NUDGE)
    }

    /// q′ at the points after one Newton iteration, from the linear equations
    /// r q′ = (r q′ at the last iterate) + slope · (change of q).
    #[expect(
        clippy::needless_range_loop,
        reason = "the indices are those of the formulas"
    )]
    #[inline(always)]
    fn q_rates(
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
        // The slopes are negative and the diagonal is large, so no pivoting is needed.
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

    /// The error scales at the end of the step.
    #[inline(always)]
    fn scales(&self, end: &[V; N]) -> [V; N] {
        let mut scales = self.slipping.scales_at_onset(&self.cartesian(end));
        let slip = ReducedSliding::<V>::expand(&scales);
        scales[ACROSS] = direction_scale(&slip, self.direction, end[ALONG]);
        scales
    }

    #[inline(always)]
    fn onset_step(
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
        let mut error = V::from(0.0);
        for k in 0..N {
            let mut of_coordinate = [V::from(0.0); POINTS];
            for j in 0..POINTS {
                of_coordinate[j] = rates[j][k];
            }
            error = error.max(method.error(self.h, &of_coordinate, scales[k]));
        }
        // A step in which r becomes negative is rejected.
        let mut min_slip = end[ALONG];
        for point in points {
            min_slip = min_slip.min(point[ALONG]);
        }
        let error = min_slip.where_negative(V::from(f64::INFINITY), error);
        let error = error * V::from(1.0 / self.tolerance);
        let cartesian = self.cartesian(&end);
        // The error is proportional to the seventh power of the step size. The approximate eighth root, with an
        // error of up to 6 %, is accurate enough unless this error exceeds the tolerance by a factor of ten
        // thousand.
        let factor = V::from(SAFETY) * V::approx_16th_root_of(V::from(1.0), error * error);
        let is_finite = error.at_most(V::from(f64::MAX));
        OnsetStep {
            end: V::store_all(cartesian),
            until_stop: until_stop(end[ALONG], rates[POINTS - 1][ALONG]).store(),
            sundman_factor: self
                .slipping
                .sundman_factor(&ReducedSliding::<V>::expand(&cartesian))
                .store(),
            error: error.store(),
            factor: is_finite.choose(factor, V::from(MIN_FACTOR)).store(),
            // A fifth of the tolerance is small enough, because another iteration would change far less.
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
        // Every other slip is already in progress.
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
        for onset_step in &done {
            assert_eq!(onset_step, &done[0]);
        }
    }

    #[test]
    fn a_slip_in_progress_does_not_depend_on_its_neighbours() {
        let can = presets::can_2007().expect("the paper's can");
        let slipping = ReducedSliding::new(Parameters::new(&can, 9.8), 0.1);
        let slipping = &slipping.with_numbers(|&number| Lanes::from(number));
        let start = State {
            tilt: 0.03,
            tilt_rate: -1.0,
            yaw_rate: 20.0,
            ..State::default()
        };
        // The sine and cosine of this angle have no short binary representation.
        let (sin, cos) = libm::sincos(0.7);
        let onset_step = |speed: Lanes| {
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
        let uniform = onset_step(Lanes::from(1e-4));
        // Every other slip starts from rest.
        let mixed = onset_step(Packed(from_fn(|lane| 1e-4 * (lane % 2) as f64)));
        for lane in (1..LANES).step_by(2) {
            let [one, other] =
                [&uniform, &mixed].map(|onset_step| onset_step.end.map(|lanes| lanes.0[lane]));
            assert_eq!(one, other, "lane {lane}");
        }
        assert_ne!(uniform.end[0].0[0], mixed.end[0].0[0]);
    }
}
