//! Eight motions, one in each lane, making one step at a time together: each of its own length, good or
//! bad by itself.

use super::carried::Carried;
use crate::motion::{FACE_DOWN_TILT, Options};
use crate::real::{LANES, Lanes, Mask, Real};
use crate::solve::Estimate;
use crate::solve::tableau::{ERROR_3, ERROR_5, Row, SOLUTION, STAGES};
use crate::state::Coordinates;
use crate::yardstick::Yardstick;
use core::hint::black_box;

/// Eight motions under way.
pub(super) struct Lockstep<const N: usize> {
    /// Where each is.
    pub u: [Lanes; N],
    /// The rates there.
    pub rates: [Lanes; N],
    /// The sizes of the coordinates there.
    sizes: [Lanes; N],
    /// How long a step to try.
    pub h: Lanes,
    /// By how much the next step may be longer.
    growth: Lanes,
    /// The sign of the tilt rate, 0 before it has one.
    pub direction: Lanes,
    /// 0 for a lane that is not to go on by itself, else 1.
    pub free: Lanes,
    /// Steps made.
    pub steps: Lanes,
    /// Where the step that was tried has led.
    pub end: [Lanes; N],
    /// The rates there.
    pub end_rates: [Lanes; N],
    end_sizes: [Lanes; N],
    /// How long the next step could be.
    pub next: Lanes,
    /// The least of what must not be negative inside the step.
    pub inside: Lanes,
    stages: [[Lanes; N]; 16],
}

/// What must not be crossed unseen.
pub(super) struct Limits {
    /// Sine and cosine of the tilt at which a body counts as toppled.
    pub topple: (f64, f64),
    /// s.
    pub duration: f64,
    /// Below this sine the base may be flat.
    pub flat: f64,
    /// What one step may err, relative to the sizes.
    pub tolerance: f64,
    /// A tilt rate counts as having a sign when it is larger than this part of its size.
    pub significant: f64,
    /// A fall of more steps is followed by itself.
    pub most_steps: f64,
}

impl Limits {
    /// The limits of falls with these options, which have been checked.
    pub(super) fn of(options: &Options) -> Limits {
        Limits {
            // Beyond the tilt π no body gets.
            topple: options.topple_tilt.map_or((0.0, -1.0), libm::sincos),
            duration: options.duration,
            flat: 10.0 * FACE_DOWN_TILT,
            tolerance: options.step_tolerance(),
            significant: 10.0 * options.rtol,
            most_steps: (options.max_steps as f64).min(2000.0) - 1.0,
        }
    }

    /// Whether a fall that starts here has some way to go to a limit.
    pub(super) fn are_far_from(&self, u: &Coordinates<f64>) -> bool {
        let (sin, cos) = self.topple;
        let below_topple = u.cos * sin - u.sin * cos;
        let in_time = u.t < self.duration && self.most_steps > 0.0;
        u.sin > self.flat && u.cos > 0.0 && below_topple > 0.0 && in_time
    }

    /// −1 or 1 when the tilt clearly falls or rises, 0 when it cannot be told.
    pub(super) fn sign_of_tilt_rate(&self, u: &Coordinates<f64>, by: &Yardstick<f64>) -> f64 {
        if u.p.abs() > self.significant * by.tilt_rate(u) {
            u.p.signum()
        } else {
            0.0
        }
    }
}

/// What became of the steps that were tried: a bit for each lane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Outcome {
    /// Good enough.
    pub good: u8,
    /// Good, nothing happened on the way, and the motion has gone on.
    pub quiet: u8,
}

impl<const N: usize> Lockstep<N> {
    pub(super) fn new() -> Self {
        let zero = Lanes::from(0.0);
        Lockstep {
            u: [zero; N],
            rates: [zero; N],
            sizes: [Lanes::from(1.0); N],
            h: zero,
            growth: Lanes::from(8.0),
            direction: zero,
            free: zero,
            steps: zero,
            end: [zero; N],
            end_rates: [zero; N],
            end_sizes: [zero; N],
            next: zero,
            inside: zero,
            stages: [[zero; N]; 16],
        }
    }

    /// Puts a motion into a lane.
    pub(super) fn put(&mut self, lane: usize, u: [f64; N], rates: [f64; N], sizes: [f64; N]) {
        for i in 0..N {
            self.u[i].0[lane] = u[i];
            self.rates[i].0[lane] = rates[i];
            self.sizes[i].0[lane] = sizes[i];
        }
        self.growth.0[lane] = 8.0;
    }

    /// Where the motion in a lane is.
    pub(super) fn at(&self, lane: usize) -> [f64; N] {
        core::array::from_fn(|i| self.u[i].0[lane])
    }

    /// The rates there.
    pub(super) fn rates_at(&self, lane: usize) -> [f64; N] {
        core::array::from_fn(|i| self.rates[i].0[lane])
    }

    /// Where the step that was tried in a lane has led.
    pub(super) fn end_at(&self, lane: usize) -> [f64; N] {
        core::array::from_fn(|i| self.end[i].0[lane])
    }

    /// The rates there.
    pub(super) fn end_rates_at(&self, lane: usize) -> [f64; N] {
        core::array::from_fn(|i| self.end_rates[i].0[lane])
    }

    /// Takes the step that a lane has tried.
    pub(super) fn accept(&mut self, lane: usize) {
        for i in 0..N {
            self.u[i].0[lane] = self.end[i].0[lane];
            self.rates[i].0[lane] = self.end_rates[i].0[lane];
            self.sizes[i].0[lane] = self.end_sizes[i].0[lane];
        }
        self.steps.0[lane] += 1.0;
    }

    /// Tries a step of each motion, and takes it where it is good and quiet.
    pub(super) fn step<P: Carried<Lanes, N>>(&mut self, phase: &P, limits: &Limits) -> Outcome {
        #[cfg(target_arch = "x86_64")]
        if std::arch::is_x86_feature_detected!("avx512f") {
            // SAFETY: the processor has what the function is compiled for.
            return unsafe { self.step_by_avx512(phase, limits) };
        }
        #[cfg(target_arch = "x86_64")]
        if std::arch::is_x86_feature_detected!("avx2") {
            // SAFETY: the processor has what the function is compiled for.
            return unsafe { self.step_by_avx2(phase, limits) };
        }
        self.step_anywhere(phase, limits)
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx512f")]
    unsafe fn step_by_avx512<P: Carried<Lanes, N>>(
        &mut self,
        phase: &P,
        limits: &Limits,
    ) -> Outcome {
        self.step_anywhere(phase, limits)
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2")]
    unsafe fn step_by_avx2<P: Carried<Lanes, N>>(&mut self, phase: &P, limits: &Limits) -> Outcome {
        self.step_anywhere(phase, limits)
    }

    #[inline(always)]
    fn step_anywhere<P: Carried<Lanes, N>>(&mut self, phase: &P, limits: &Limits) -> Outcome {
        self.attempt(phase);
        self.end_sizes = phase.sizes(&self.end);
        let estimate = self.estimate(limits.tolerance);
        let is_number = estimate.error_squared.at_most(Lanes::from(f64::MAX));
        let good = is_number.and(estimate.error_squared.at_most(estimate.allowed));
        let quiet = good.and(Lanes::from(0.0).at_most(self.safety(phase, limits)));
        self.choose_next(&estimate, is_number, good, quiet);
        for i in 0..N {
            self.u[i] = quiet.choose(self.end[i], self.u[i]);
            self.rates[i] = quiet.choose(self.end_rates[i], self.rates[i]);
            self.sizes[i] = quiet.choose(self.end_sizes[i], self.sizes[i]);
        }
        Outcome {
            good: good.bits(),
            quiet: quiet.bits(),
        }
    }

    /// One step of the method of order 8.
    #[inline(always)]
    fn attempt<P: Carried<Lanes, N>>(&mut self, phase: &P) {
        self.stages[0] = self.rates;
        self.inside = Lanes::from(f64::INFINITY);
        for i in 0..STAGES.len() {
            let at = self.before_stage(i, P::FELT);
            self.stages[i + 1] = phase.rates(&at);
            // At 1/3, 3/5 and 6/7 of the step.
            if matches!(i, 4 | 8 | 9) {
                let tilting = self.direction * P::all(&at).p;
                self.inside = self.inside.min(tilting).min(phase.holds(&at));
            }
        }
        self.end = combine(&self.u, self.h, SOLUTION, &self.stages, N);
        self.end_rates = phase.rates(&self.end);
    }

    /// Where the next stage after some is to be made.
    #[inline(always)]
    fn before_stage(&self, made: usize, count: usize) -> [Lanes; N] {
        macro_rules! rows {
            ($($row:literal)*) => {
                match made {
                    $($row => combine(&self.u, self.h, STAGES[$row], &self.stages, count),)*
                    _ => unreachable!("a step has no more stages"),
                }
            };
        }
        rows!(0 1 2 3 4 5 6 7 8 9 10)
    }

    #[inline(always)]
    fn estimate(&self, tolerance: f64) -> Estimate<Lanes> {
        let zero = Lanes::from(0.0);
        let (mut fifth, mut third) = (zero, zero);
        for i in 0..N {
            let per_size =
                Lanes::from(1.0) / (Lanes::from(tolerance) * self.sizes[i].max(self.end_sizes[i]));
            let e5 = weigh(ERROR_5, &self.stages, i) * per_size;
            let e3 = weigh(ERROR_3, &self.stages, i) * per_size;
            fifth = fifth + e5 * e5;
            third = third + e3 * e3;
        }
        Estimate::new(self.h, fifth, third, N)
    }

    /// Not negative where the step has crossed nothing that is to be seen.
    #[inline(always)]
    fn safety<P: Carried<Lanes, N>>(&self, phase: &P, limits: &Limits) -> Lanes {
        let u = P::all(&self.end);
        let (sin, cos) = limits.topple;
        let below_topple = u.cos * Lanes::from(sin) - u.sin * Lanes::from(cos);
        let in_time = Lanes::from(limits.duration) - u.t;
        let lifted = u.sin - Lanes::from(limits.flat);
        // Neither 0, before there is a direction, nor a lane that is held.
        let on_its_way = self.free * self.direction * self.direction - Lanes::from(0.5);
        self.inside
            .min(phase.holds(&self.end))
            .min(self.direction * u.p)
            .min(below_topple)
            .min(in_time)
            .min(lifted)
            .min(u.cos)
            .min(Lanes::from(limits.most_steps) - self.steps)
            .min(phase.slips_on(&self.end, &self.end_rates, limits.tolerance))
            .min(on_its_way)
    }

    /// How long the next step could be; and lets it be so where nothing else is to be decided.
    #[inline(always)]
    fn choose_next(
        &mut self,
        estimate: &Estimate<Lanes>,
        is_number: Mask,
        good: Mask,
        quiet: Mask,
    ) {
        let one = Lanes::from(1.0);
        let factor = is_number.choose(next_factors(estimate), Lanes::from(0.1));
        let growth = good.choose(self.growth, one);
        self.next = self.h * factor.min(growth);
        let free = Lanes::from(0.5).at_most(self.free);
        let goes_on = quiet.or((!good).and(free));
        self.h = goes_on.choose(self.next, self.h);
        self.growth = good.choose(Lanes::from(8.0), one);
        self.steps = quiet.choose(self.steps + one, self.steps);
    }
}

/// By what factors the next steps may be longer.
#[inline(always)]
fn next_factors(estimate: &Estimate<Lanes>) -> Lanes {
    let Estimate {
        error_squared,
        allowed,
    } = estimate;
    let mut factors = Lanes::from(0.2);
    for lane in 0..LANES {
        let alone = Estimate {
            error_squared: error_squared.0[lane],
            allowed: allowed.0[lane],
        };
        factors.0[lane] = alone.next_factor();
    }
    factors.max(Lanes::from(0.2))
}

/// How many terms of a row are written out.
const TERMS: usize = 9;

const _: () = {
    let mut i = 0;
    while i < STAGES.len() {
        assert!(STAGES[i].len() <= TERMS);
        i += 1;
    }
    assert!(SOLUTION.len() <= TERMS && ERROR_5.len() <= TERMS && ERROR_3.len() <= TERMS);
};

/// Σ weight · stage of a coordinate, summed in the order of the row, which is to be known when this is
/// compiled. The terms are written out, and compilers kept from taking several coordinates together: else
/// they lose the order of the lanes.
#[inline(always)]
fn weigh<const N: usize>(row: Row, stages: &[[Lanes; N]; 16], i: usize) -> Lanes {
    let (i, mut sum) = (black_box(i), Lanes::from(0.0));
    // Asked once rather than for every term.
    assert!(i < N, "a coordinate");
    macro_rules! add {
        ($($term:literal)*) => {
            $(if let Some(&(stage, weight)) = row.get($term) {
                sum = sum + Lanes::from(weight) * stages[stage][i];
            })*
        };
    }
    add!(0 1 2 3 4 5 6 7 8);
    sum
}

/// u + h Σ weight · stage of the first `count` coordinates; the others stay.
#[inline(always)]
fn combine<const N: usize>(
    u: &[Lanes; N],
    h: Lanes,
    row: Row,
    stages: &[[Lanes; N]; 16],
    count: usize,
) -> [Lanes; N] {
    let mut end = *u;
    for (i, end) in end.iter_mut().enumerate().take(count) {
        *end = *end + h * weigh(row, stages, i);
    }
    end
}

/// The lanes of a set of bits.
pub(super) fn lanes_of(bits: u8) -> impl Iterator<Item = usize> {
    (0..LANES).filter(move |lane| bits >> lane & 1 == 1)
}

#[cfg(test)]
mod tests {
    use super::super::carried::{Carried, Slipping};
    use super::{Limits, Lockstep};
    use crate::law::Parameters;
    use crate::motion::Options;
    use crate::presets;
    use crate::real::{LANES, Lanes};
    use crate::state::{Coordinates, State};

    /// Eight cans that slide, each a little otherwise.
    fn sliding(k: Parameters<f64>) -> Lockstep<10> {
        let mut lockstep = Lockstep::new();
        let alone = Slipping::new(k, 0.2);
        for lane in 0..LANES {
            let part = lane as f64 / LANES as f64;
            let start = State {
                tilt: 0.2 + 0.2 * part,
                tilt_rate: -2.0 - part,
                yaw_rate: 0.1,
                ..State::default()
            };
            let u = Slipping::<f64>::of(&Coordinates {
                slip_x: -0.1 * part,
                slip_y: 0.01,
                ..Coordinates::from_state(&start)
            });
            lockstep.put(lane, u, alone.rates(&u), alone.sizes(&u));
            lockstep.h.0[lane] = 1e-3;
            lockstep.direction.0[lane] = -1.0;
            lockstep.free.0[lane] = 1.0;
        }
        lockstep
    }

    #[test]
    fn the_width_of_the_vectors_changes_no_bit() {
        let can = presets::can_2007().expect("the paper's can");
        let k = Parameters::new(&can, 9.8);
        let limits = Limits::of(&Options::default());
        let together = Slipping::new(k.map(Lanes::from), Lanes::from(0.2));
        let (mut wide, mut plain) = (sliding(k), sliding(k));
        for _ in 0..20 {
            let outcome = wide.step(&together, &limits);
            assert_eq!(outcome, plain.step_anywhere(&together, &limits));
        }
        assert!(wide.steps.0.iter().all(|&steps| steps > 5.0));
        assert_eq!((wide.u, wide.h), (plain.u, plain.h));
    }
}
