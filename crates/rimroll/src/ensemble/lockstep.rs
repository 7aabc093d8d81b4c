//! Sixteen motions, one in each lane, making one step at a time together: each of its own length, good or
//! bad by itself.

use super::limits::{Limits, Topple};
use super::reduced_system::ReducedSystem;
use crate::real::{Bits, Lanes, Mask, Part, SimdKernel, Vector, run_widest};
use crate::solve::Estimate;
use crate::solve::tableau::{ERROR_3, ERROR_5, Row, SOLUTION, STAGES};
use crate::state::Coordinates;

/// Sixteen motions under way.
pub(super) struct Lockstep<const N: usize> {
    /// Where each is.
    pub u: [Lanes; N],
    /// The sizes of the coordinates there.
    scales: [Lanes; N],
    /// How long a step to try.
    pub h: Lanes,
    /// A step no longer than this leads nowhere.
    pub min_h: Lanes,
    /// By how much the next step may be longer.
    growth: Lanes,
    /// The sign of the tilt rate, 0 before it has one.
    pub direction: Lanes,
    /// 0 for a lane that is not to go on by itself, else 1.
    pub free: Lanes,
    /// Steps made.
    pub steps: Lanes,
    /// Where each topples.
    pub topple: Topple<Lanes>,
    /// Where the step that was tried has led.
    pub end: [Lanes; N],
    /// The rates there.
    pub end_rates: [Lanes; N],
    end_scales: [Lanes; N],
    /// How long the next step could be.
    pub next: Lanes,
    /// The least of what must not be negative inside the step.
    pub inside: Lanes,
    /// The rates at each stage of the step, first of all those where it begins.
    stages: [[Lanes; N]; 16],
}

/// What a step may run into.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum EventFunction {
    /// The tilt is extreme.
    Extreme,
    Topple,
    /// Time is up.
    Time,
    /// The contact no longer lasts.
    Contact,
}

/// All of them, in the order of their numbers.
pub(super) const EVENT_FUNCTIONS: [EventFunction; 4] = [
    EventFunction::Extreme,
    EventFunction::Topple,
    EventFunction::Time,
    EventFunction::Contact,
];

const _: () = {
    let mut i = 0;
    while i < EVENT_FUNCTIONS.len() {
        assert!(EVENT_FUNCTIONS[i] as usize == i);
        i += 1;
    }
};

/// What became of the steps that were tried: a bit for each lane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct StepOutcome {
    /// Good enough.
    good: Bits,
    /// Ends beyond each of the marks.
    crossed: [Bits; EVENT_FUNCTIONS.len()],
    /// Nothing is to be decided: either the step was good, nothing happened on the way and the motion has
    /// gone on, or it was not good and a shorter one is to be tried.
    pub settled: Bits,
}

impl StepOutcome {
    /// Whether the step of a lane was good.
    pub(super) fn is_good(&self, lane: usize) -> bool {
        self.good >> lane & 1 == 1
    }

    /// Whether it has led beyond a mark.
    pub(super) fn has_crossed(&self, lane: usize, event: EventFunction) -> bool {
        self.crossed[event as usize] >> lane & 1 == 1
    }
}

impl<const N: usize> Lockstep<N> {
    pub(super) fn new() -> Self {
        let zero = Lanes::from(0.0);
        Lockstep {
            u: [zero; N],
            scales: [Lanes::from(1.0); N],
            h: zero,
            min_h: zero,
            growth: Lanes::from(8.0),
            direction: zero,
            free: zero,
            steps: zero,
            topple: Topple::at(None).map(|&number| Lanes::from(number)),
            end: [zero; N],
            end_rates: [zero; N],
            end_scales: [zero; N],
            next: zero,
            inside: zero,
            stages: [[zero; N]; 16],
        }
    }

    /// Puts a motion into a lane.
    pub(super) fn put(&mut self, lane: usize, u: [f64; N], rates: [f64; N], scales: [f64; N]) {
        for i in 0..N {
            self.u[i].0[lane] = u[i];
            self.stages[0][i].0[lane] = rates[i];
            self.scales[i].0[lane] = scales[i];
        }
        self.growth.0[lane] = 8.0;
    }

    /// Where the motion in a lane is.
    pub(super) fn at(&self, lane: usize) -> [f64; N] {
        core::array::from_fn(|i| self.u[i].0[lane])
    }

    /// The rates there.
    pub(super) fn rates_at(&self, lane: usize) -> [f64; N] {
        core::array::from_fn(|i| self.stages[0][i].0[lane])
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
            self.stages[0][i].0[lane] = self.end_rates[i].0[lane];
            self.scales[i].0[lane] = self.end_scales[i].0[lane];
        }
        self.steps.0[lane] += 1.0;
    }

    /// Tries a step of each motion, and takes it where it is good and quiet; `phase` has the body and friction of
    /// each.
    pub(super) fn step<P: ReducedSystem<Lanes, N>>(
        &mut self,
        phase: &P,
        limits: &Limits,
    ) -> StepOutcome {
        run_widest(Step(self, phase, limits))
    }

    #[inline(always)]
    fn step_in<V: Vector, P: ReducedSystem<Lanes, N>>(
        &mut self,
        phase: &P,
        limits: &Limits,
    ) -> StepOutcome {
        self.attempt::<V::Part, P>(phase);
        let phase = phase.with_numbers(V::load);
        let (end, end_rates) = (V::load_all(&self.end), V::load_all(&self.end_rates));
        let scales = phase.scales(&end);
        let estimate = self.estimate(&scales, limits.tolerance);
        let is_number = estimate.error_squared.at_most(V::from(f64::MAX));
        let good = is_number.and(estimate.error_squared.at_most(estimate.allowed));
        let at = P::With::<V>::expand(&end);
        // In the order of `EVENT_FUNCTIONS`.
        let levels = [
            V::load(&self.direction) * at.p,
            self.topple.map(V::load).below(&at),
            V::from(limits.duration) - at.t,
            phase.contact_margin(&end),
        ];
        let slip_persists = phase.slip_persists(&end, &end_rates, limits.tolerance);
        let safety = self.safety(&at, &levels, slip_persists, limits);
        let quiet = good.and(V::from(0.0).at_most(safety)).opaque();
        let shortened = self.choose_next(&estimate, is_number, good, quiet);
        for i in 0..N {
            self.u[i] = quiet.choose(end[i], V::load(&self.u[i])).store();
            self.stages[0][i] = quiet
                .choose(end_rates[i], V::load(&self.stages[0][i]))
                .store();
            self.end_scales[i] = scales[i].store();
            self.scales[i] = quiet.choose(scales[i], V::load(&self.scales[i])).store();
        }
        let zero = V::from(0.0);
        let mut crossed = [0; EVENT_FUNCTIONS.len()];
        for i in 0..EVENT_FUNCTIONS.len() {
            // Written so that a NaN is beyond.
            crossed[i] = (!zero.at_most(levels[i])).bits();
        }
        StepOutcome {
            good: good.bits(),
            crossed,
            settled: quiet.or(shortened).bits(),
        }
    }

    /// One step of the method of order 8, some of the lanes after the other in each stage: while some wait for
    /// the last of a formula, the others begin.
    #[inline(always)]
    fn attempt<V: Part, P: ReducedSystem<Lanes, N>>(&mut self, phase: &P) {
        const { assert!(V::PARTS <= 2) };
        self.inside = Lanes::from(f64::INFINITY);
        // Loaded once: the compiler cannot know that the stages leave the laws as they are.
        let first = phase.with_numbers(|lanes| V::load_part(lanes, 0));
        let last = phase.with_numbers(|lanes| V::load_part(lanes, V::PARTS - 1));
        for i in 0..=STAGES.len() {
            self.stage(i, 0, &first);
            if V::PARTS > 1 {
                self.stage(i, 1, &last);
            }
        }
    }

    /// A stage of the step of some lanes, where the last leads to its end.
    #[inline(always)]
    fn stage<V: Part, P: ReducedSystem<V, N>>(&mut self, i: usize, part: usize, phase: &P) {
        // Asked once rather than for every number.
        assert!(part < V::PARTS, "a part");
        let (u, h) = (V::load_parts(&self.u, part), V::load_part(&self.h, part));
        if i == STAGES.len() {
            let end = combine(&u, h, SOLUTION, &self.stages, part, N);
            V::store_parts(end, &mut self.end, part);
            V::store_parts(phase.rates(&end), &mut self.end_rates, part);
            return;
        }
        let at = before_stage(i, &u, h, &self.stages, part, P::ESSENTIAL);
        V::store_parts(phase.rates(&at), &mut self.stages[i + 1], part);
        // At 1/3, 3/5 and 6/7 of the step.
        if matches!(i, 4 | 8 | 9) {
            let tilting = V::load_part(&self.direction, part) * P::expand(&at).p;
            let inside = V::load_part(&self.inside, part);
            let inside = inside.min(tilting).min(phase.contact_margin(&at));
            inside.store_part(&mut self.inside, part);
        }
    }

    #[expect(
        clippy::needless_range_loop,
        reason = "an iterator's closures might not be inlined"
    )]
    #[inline(always)]
    fn estimate<V: Vector>(&self, end_scales: &[V; N], tolerance: f64) -> Estimate<V> {
        let (mut fifth, mut third) = (V::from(0.0), V::from(0.0));
        for i in 0..N {
            let size = V::load(&self.scales[i]).max(end_scales[i]);
            let per_size = V::from(1.0) / (V::from(tolerance) * size);
            let e5 = weigh::<V, N>(ERROR_5, &self.stages, 0, i) * per_size;
            let e3 = weigh::<V, N>(ERROR_3, &self.stages, 0, i) * per_size;
            fifth = fifth + e5 * e5;
            third = third + e3 * e3;
        }
        Estimate::new(V::load(&self.h), fifth, third, N)
    }

    /// Not negative where the step has crossed nothing that is to be seen.
    #[inline(always)]
    fn safety<V: Vector>(
        &self,
        end: &Coordinates<V>,
        levels: &[V; EVENT_FUNCTIONS.len()],
        slip_persists: V,
        limits: &Limits,
    ) -> V {
        let lifted = end.sin - V::from(limits.flat);
        let direction = V::load(&self.direction);
        // Neither 0, before there is a direction, nor a lane that is held.
        let on_its_way = V::load(&self.free) * direction * direction - V::from(0.5);
        let [extreme, topple, time, contact] = *levels;
        V::load(&self.inside)
            .min(contact)
            .min(extreme)
            .min(topple)
            .min(time)
            .min(lifted)
            .min(end.cos)
            .min(V::from(limits.max_steps) - V::load(&self.steps))
            .min(slip_persists)
            .min(on_its_way)
    }

    /// How long the next step could be; and lets it be so where nothing else is to be decided. It says where
    /// a shorter one is to be tried, and is long enough.
    #[inline(always)]
    fn choose_next<V: Vector>(
        &mut self,
        estimate: &Estimate<V>,
        is_number: V::Mask,
        good: V::Mask,
        quiet: V::Mask,
    ) -> V::Mask {
        let (one, h) = (V::from(1.0), V::load(&self.h));
        let factor = estimate.next_factor().max(V::from(0.2));
        let factor = is_number.choose(factor, V::from(0.1));
        let growth = good.choose(V::load(&self.growth), one);
        let next = h * factor.min(growth);
        let free = V::from(0.5).at_most(V::load(&self.free));
        let shortened = (!good).and(free);
        let steps = V::load(&self.steps);
        self.next = next.store();
        self.h = quiet.or(shortened).choose(next, h).store();
        self.growth = good.choose(V::from(8.0), one).store();
        self.steps = quiet.choose(steps + one, steps).store();
        let is_finite = next.at_most(V::from(f64::MAX));
        let is_long_enough = !next.at_most(V::load(&self.min_h));
        shortened.and(is_finite.and(is_long_enough))
    }
}

/// A step to be tried: the motions, their phase and their limits.
struct Step<'a, P, const N: usize>(&'a mut Lockstep<N>, &'a P, &'a Limits);

impl<P: ReducedSystem<Lanes, N>, const N: usize> SimdKernel for Step<'_, P, N> {
    type Done = StepOutcome;

    #[inline(always)]
    fn run<V: Vector>(self) -> StepOutcome {
        let Step(lockstep, phase, limits) = self;
        lockstep.step_in::<V, P>(phase, limits)
    }
}

/// Where the next stage after some is to be made.
#[inline(always)]
fn before_stage<V: Part, const N: usize>(
    made: usize,
    u: &[V; N],
    h: V,
    stages: &[[Lanes; N]; 16],
    part: usize,
    count: usize,
) -> [V; N] {
    macro_rules! rows {
        ($($row:literal)*) => {
            match made {
                $($row => combine(u, h, STAGES[$row], stages, part, count),)*
                _ => unreachable!("a step has no more stages"),
            }
        };
    }
    rows!(0 1 2 3 4 5 6 7 8 9 10)
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
/// compiled: hence the terms are written out.
#[inline(always)]
fn weigh<V: Part, const N: usize>(row: Row, stages: &[[Lanes; N]; 16], part: usize, i: usize) -> V {
    let i = V::opaque(i);
    // Asked once rather than for every term.
    assert!(i < N, "a coordinate");
    let (first, weight) = row[0];
    let mut sum = V::from(weight) * V::load_part(&stages[first][i], part);
    macro_rules! add {
        ($($term:literal)*) => {
            $(if let Some(&(stage, weight)) = row.get($term) {
                sum = sum + V::from(weight) * V::load_part(&stages[stage][i], part);
            })*
        };
    }
    add!(1 2 3 4 5 6 7 8);
    sum
}

/// u + h Σ weight · stage of the first `count` coordinates; the others stay.
#[inline(always)]
fn combine<V: Part, const N: usize>(
    u: &[V; N],
    h: V,
    row: Row,
    stages: &[[Lanes; N]; 16],
    part: usize,
    count: usize,
) -> [V; N] {
    let mut end = *u;
    for (i, end) in end.iter_mut().enumerate().take(count) {
        *end = *end + h * weigh(row, stages, part, i);
    }
    end
}

/// The lanes of a set of bits.
pub(super) fn lanes_of(mut bits: Bits) -> impl Iterator<Item = usize> {
    core::iter::from_fn(move || {
        let lane = (bits != 0).then(|| bits.trailing_zeros() as usize)?;
        bits &= bits - 1;
        Some(lane)
    })
}

#[cfg(test)]
mod tests {
    use super::super::limits::Limits;
    use super::super::reduced_system::{
        ReducedFrictionless, ReducedNoSlip, ReducedSliding, ReducedSystem,
    };
    use super::{Lockstep, StepOutcome};
    use crate::law::Parameters;
    use crate::motion::Options;
    use crate::presets;
    use crate::real::{LANES, Lanes, SimdKernel, Vector, in_every_width};
    use crate::state::{Coordinates, State};

    /// Sixteen cans, each a little otherwise.
    fn cans<P: ReducedSystem<f64, N>, const N: usize>(phase: &P) -> Lockstep<N> {
        let mut lockstep = Lockstep::new();
        for lane in 0..LANES {
            let part = lane as f64 / LANES as f64;
            let start = State {
                tilt: 0.2 + 0.2 * part,
                tilt_rate: -2.0 - part,
                yaw_rate: 0.1,
                ..State::default()
            };
            let u = P::project(&Coordinates {
                slip_x: -0.1 * part,
                slip_y: 0.01,
                ..Coordinates::from_state(&start)
            });
            lockstep.put(lane, u, phase.rates(&u), phase.scales(&u));
            lockstep.h.0[lane] = 1e-3;
            lockstep.direction.0[lane] = -1.0;
            lockstep.free.0[lane] = 1.0;
        }
        lockstep
    }

    /// Twenty steps.
    struct Steps<'a, P>(&'a P, &'a Limits);

    impl<P: ReducedSystem<Lanes, N>, const N: usize> SimdKernel for (Steps<'_, P>, Lockstep<N>) {
        type Done = (Vec<StepOutcome>, Lockstep<N>);

        fn run<V: Vector>(self) -> Self::Done {
            let (Steps(phase, limits), mut lockstep) = self;
            let step = |_| lockstep.step_in::<V, P>(phase, limits);
            ((0..20).map(step).collect(), lockstep)
        }
    }

    fn assert_steps_alike<P: ReducedSystem<f64, N>, const N: usize>(friction: f64) {
        let can = presets::can_2007().expect("the paper's can");
        let phase = P::new(Parameters::new(&can, 9.8), friction);
        let in_lanes = phase.with_numbers(|&number| Lanes::from(number));
        let limits = Limits::of(&Options::default());
        let steps = || (Steps(&in_lanes, &limits), cans(&phase));
        let done = in_every_width(steps);
        let (first_outcomes, first) = &done[0];
        assert!(first.steps.0.iter().all(|&steps| steps > 5.0));
        for (outcomes, lockstep) in &done {
            assert_eq!(outcomes, first_outcomes);
            assert_eq!((lockstep.u, lockstep.h), (first.u, first.h));
        }
    }

    #[test]
    fn the_width_of_the_registers_changes_no_bit() {
        assert_steps_alike::<ReducedNoSlip<f64, false>, 7>(0.0);
        // So much that it holds.
        assert_steps_alike::<ReducedNoSlip<f64, true>, 7>(20.0);
        assert_steps_alike::<ReducedFrictionless<f64>, 7>(0.0);
        assert_steps_alike::<ReducedSliding<f64>, 10>(0.2);
    }
}
