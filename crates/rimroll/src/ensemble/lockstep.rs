//! A batch of sixteen motions, one in each lane. All lanes make a step at once, each with its own step size,
//! and each step is accepted or rejected independently of the others.

use super::chunk::Bounds;
use super::reduced_system::ReducedSystem;
use crate::motion::ToppleTilt;
use crate::real::{Bits, Lanes, Mask, Part, SimdKernel, Vector, run_widest};
use crate::solve::ErrorEstimate;
use crate::solve::tableau::{ERROR_3, ERROR_5, Row, SOLUTION, STAGES};
use crate::state::Coordinates;

/// The state of the batch.
pub(super) struct Lockstep<const N: usize> {
    /// The states at the start of the step.
    pub u: [Lanes; N],
    /// The error scales at the start.
    scales: [Lanes; N],
    /// The size of the step to try.
    pub h: Lanes,
    /// A step size of at most this counts as underflow.
    pub min_h: Lanes,
    /// The maximal factor to the next step size.
    growth: Lanes,
    /// The sign of the tilt rate, or 0 while the sign is not significant.
    pub direction: Lanes,
    /// 1 for a lane that accepts and repeats steps in this module, 0 for one whose steps the pool decides on.
    pub free: Lanes,
    /// The number of accepted steps.
    pub steps: Lanes,
    /// The topple tilts.
    pub topple: ToppleTilt<Lanes>,
    /// The states at the end of the step.
    pub end: [Lanes; N],
    /// The rates at the end.
    pub end_rates: [Lanes; N],
    end_scales: [Lanes; N],
    /// The next step size that the error estimate allows.
    pub next: Lanes,
    /// Negative if an event function for tilt extremes or contact is negative inside the step, or may be.
    pub inside: Lanes,
    /// The contact margins at [`MARGIN_NODES`].
    margins: [Lanes; MARGIN_NODES.len()],
    /// The rates at the stages of the step, beginning with those at its start.
    stages: [[Lanes; N]; 16],
}

/// The places in a step, as fractions of its size, at which the contact margin is computed: the start, three
/// stages, and the end.
const MARGIN_NODES: [f64; 5] = [0.0, 1.0 / 3.0, 3.0 / 5.0, 6.0 / 7.0, 1.0];

/// The event functions. Each is negative after its event.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum EventFunction {
    /// An extreme of the tilt.
    Extreme,
    /// The topple tilt.
    Topple,
    /// The end of the duration.
    Time,
    /// The end of the contact condition.
    Contact,
}

/// All event functions in the order of their indices.
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

/// The outcome of a step, with one bit for each lane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct StepOutcome {
    /// The error is within the tolerance.
    within_tolerance: Bits,
    /// The event function is negative at the end of the step.
    crossed: [Bits; EVENT_FUNCTIONS.len()],
    /// The pool has nothing to decide: the step is within the tolerance and no event is possible, or it was
    /// rejected and a shorter step follows.
    pub settled: Bits,
}

impl StepOutcome {
    /// Whether the error of a lane's step is within the tolerance.
    pub(super) fn is_within_tolerance(&self, lane: usize) -> bool {
        self.within_tolerance >> lane & 1 == 1
    }

    /// Whether an event function is negative at the end of a lane's step.
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
            topple: ToppleTilt::never().map(|&number| Lanes::from(number)),
            end: [zero; N],
            end_rates: [zero; N],
            end_scales: [zero; N],
            next: zero,
            inside: zero,
            margins: [zero; MARGIN_NODES.len()],
            stages: [[zero; N]; 16],
        }
    }

    /// Puts a motion under the equations of `system` into a lane.
    pub(super) fn put<P: ReducedSystem<f64, N>>(&mut self, lane: usize, u: [f64; N], system: &P) {
        let (rates, scales) = (system.rates(&u), system.scales(&u));
        self.margins[0].0[lane] = system.contact_margin(&u);
        for i in 0..N {
            self.u[i].0[lane] = u[i];
            self.stages[0][i].0[lane] = rates[i];
            self.scales[i].0[lane] = scales[i];
        }
        self.growth.0[lane] = 8.0;
    }

    /// The state of a lane at the start of the step.
    pub(super) fn at(&self, lane: usize) -> [f64; N] {
        core::array::from_fn(|i| self.u[i].0[lane])
    }

    /// The rates of a lane at the start of the step.
    pub(super) fn rates_at(&self, lane: usize) -> [f64; N] {
        core::array::from_fn(|i| self.stages[0][i].0[lane])
    }

    /// The state of a lane at the end of the step.
    pub(super) fn end_at(&self, lane: usize) -> [f64; N] {
        core::array::from_fn(|i| self.end[i].0[lane])
    }

    /// The rates of a lane at the end of the step.
    pub(super) fn end_rates_at(&self, lane: usize) -> [f64; N] {
        core::array::from_fn(|i| self.end_rates[i].0[lane])
    }

    /// Advances a lane to the end of its step.
    pub(super) fn accept(&mut self, lane: usize) {
        for i in 0..N {
            self.u[i].0[lane] = self.end[i].0[lane];
            self.stages[0][i].0[lane] = self.end_rates[i].0[lane];
            self.scales[i].0[lane] = self.end_scales[i].0[lane];
        }
        let [start, .., end] = &mut self.margins;
        start.0[lane] = end.0[lane];
        self.steps.0[lane] += 1.0;
    }

    /// Computes a step of each motion under its own body and friction, given by `phase`. Lanes whose error is
    /// within the tolerance and in which no event is possible advance to its end.
    pub(super) fn step<P: ReducedSystem<Lanes, N>>(
        &mut self,
        phase: &P,
        bounds: &Bounds,
    ) -> StepOutcome {
        run_widest(Step(self, phase, bounds))
    }

    #[inline(always)]
    fn step_in<V: Vector, P: ReducedSystem<Lanes, N>>(
        &mut self,
        phase: &P,
        bounds: &Bounds,
    ) -> StepOutcome {
        self.attempt::<V::Part, P>(phase);
        let phase = phase.with_numbers(V::load);
        let (end, end_rates) = (V::load_all(&self.end), V::load_all(&self.end_rates));
        let scales = phase.scales(&end);
        let estimate = self.estimate(&scales, bounds.tolerance);
        let is_finite = estimate.error_squared.at_most(V::from(f64::MAX));
        let within_tolerance = is_finite.and(estimate.error_squared.at_most(estimate.allowed));
        let at = P::With::<V>::expand(&end);
        // In the order of `EVENT_FUNCTIONS`.
        let event_values = [
            V::load(&self.direction) * at.p,
            self.topple.map(V::load).below(&at),
            V::from(bounds.duration) - at.t,
            phase.contact_margin(&end),
        ];
        let [.., end_margin] = &mut self.margins;
        *end_margin = event_values[EventFunction::Contact as usize].store();
        let margins = V::load_all(&self.margins);
        let inside = V::load(&self.inside).min(lowest_dip(&margins));
        self.inside = inside.store();
        let slip_persists = phase.slip_persists(&end, &end_rates, bounds.tolerance);
        let event_margin = self.event_margin(&at, &event_values, slip_persists, bounds);
        let quiet = within_tolerance
            .and(V::from(0.0).at_most(event_margin))
            .opaque();
        let shortened = self.choose_next(&estimate, is_finite, within_tolerance, quiet);
        for i in 0..N {
            self.u[i] = quiet.choose(end[i], V::load(&self.u[i])).store();
            self.stages[0][i] = quiet
                .choose(end_rates[i], V::load(&self.stages[0][i]))
                .store();
            self.end_scales[i] = scales[i].store();
            self.scales[i] = quiet.choose(scales[i], V::load(&self.scales[i])).store();
        }
        let [start_margin, .., end_margin] = margins;
        self.margins[0] = quiet.choose(end_margin, start_margin).store();
        let zero = V::from(0.0);
        let mut crossed = [0; EVENT_FUNCTIONS.len()];
        for i in 0..EVENT_FUNCTIONS.len() {
            // A NaN counts as crossed.
            crossed[i] = (!zero.at_most(event_values[i])).bits();
        }
        StepOutcome {
            within_tolerance: within_tolerance.bits(),
            crossed,
            settled: quiet.or(shortened).bits(),
        }
    }

    /// One step of the method of order 8. Each stage is computed for one part of the lanes after the other, so
    /// that the processor can begin one part while another waits for the end of a dependency chain.
    #[inline(always)]
    fn attempt<V: Part, P: ReducedSystem<Lanes, N>>(&mut self, phase: &P) {
        const { assert!(V::PARTS <= 2) };
        self.inside = Lanes::from(f64::INFINITY);
        // Loaded only once, because the compiler cannot prove that the stages do not change the parameters.
        let first = phase.with_numbers(|lanes| V::load_part(lanes, 0));
        let last = phase.with_numbers(|lanes| V::load_part(lanes, V::PARTS - 1));
        for i in 0..=STAGES.len() {
            self.stage(i, 0, &first);
            if V::PARTS > 1 {
                self.stage(i, 1, &last);
            }
        }
    }

    /// A stage of the step in one part of the lanes. The last stage is the end of the step.
    #[inline(always)]
    fn stage<V: Part, P: ReducedSystem<V, N>>(&mut self, i: usize, part: usize, phase: &P) {
        // Checked here once, so that the compiler drops the check for every number.
        assert!(part < V::PARTS, "part out of range");
        let (u, h) = (V::load_parts(&self.u, part), V::load_part(&self.h, part));
        if i == STAGES.len() {
            let end = combine(&u, h, SOLUTION, &self.stages, part, N);
            V::store_parts(end, &mut self.end, part);
            V::store_parts(phase.rates(&end), &mut self.end_rates, part);
            return;
        }
        let at = stage_argument(i, &u, h, &self.stages, part, P::ESSENTIAL);
        V::store_parts(phase.rates(&at), &mut self.stages[i + 1], part);
        // The stages at the inner nodes of `MARGIN_NODES`.
        let node = match i {
            4 => 1,
            8 => 2,
            9 => 3,
            _ => 0,
        };
        if node > 0 {
            let extreme = V::load_part(&self.direction, part) * P::expand(&at).p;
            let margin = phase.contact_margin(&at);
            margin.store_part(&mut self.margins[node], part);
            let inside = V::load_part(&self.inside, part);
            let inside = inside.min(extreme).min(margin);
            inside.store_part(&mut self.inside, part);
        }
    }

    #[expect(
        clippy::needless_range_loop,
        reason = "an iterator's closures might not be inlined"
    )]
    #[inline(always)]
    fn estimate<V: Vector>(&self, end_scales: &[V; N], tolerance: f64) -> ErrorEstimate<V> {
        let (mut fifth, mut third) = (V::from(0.0), V::from(0.0));
        for i in 0..N {
            let scale = V::load(&self.scales[i]).max(end_scales[i]);
            let per_scale = V::from(1.0) / (V::from(tolerance) * scale);
            let e5 = weighted_sum::<V, N>(ERROR_5, &self.stages, 0, i) * per_scale;
            let e3 = weighted_sum::<V, N>(ERROR_3, &self.stages, 0, i) * per_scale;
            fifth = fifth + e5 * e5;
            third = third + e3 * e3;
        }
        ErrorEstimate::new(V::load(&self.h), fifth, third, N)
    }

    /// The minimum of all event functions and bounds. If it is negative, the pool has to examine the step.
    #[inline(always)]
    fn event_margin<V: Vector>(
        &self,
        end: &Coordinates<V>,
        event_values: &[V; EVENT_FUNCTIONS.len()],
        slip_persists: V,
        bounds: &Bounds,
    ) -> V {
        let above_flat = end.sin - V::from(bounds.flat);
        let direction = V::load(&self.direction);
        // Negative without a direction, and in a lane that the pool controls.
        let free = V::load(&self.free) * direction * direction - V::from(0.5);
        let [extreme, topple, time, contact] = *event_values;
        V::load(&self.inside)
            .min(contact)
            .min(extreme)
            .min(topple)
            .min(time)
            .min(above_flat)
            .min(end.cos)
            .min(V::from(bounds.max_steps) - V::load(&self.steps))
            .min(slip_persists)
            .min(free)
    }

    /// Computes the next step size, and sets it in the lanes where the pool has nothing to decide. The result
    /// marks the lanes that repeat the step with a smaller step size above the minimum.
    #[inline(always)]
    fn choose_next<V: Vector>(
        &mut self,
        estimate: &ErrorEstimate<V>,
        is_finite: V::Mask,
        within_tolerance: V::Mask,
        quiet: V::Mask,
    ) -> V::Mask {
        let (one, h) = (V::from(1.0), V::load(&self.h));
        let factor = estimate.next_factor().max(V::from(0.2));
        let factor = is_finite.choose(factor, V::from(0.1));
        let growth = within_tolerance.choose(V::load(&self.growth), one);
        let next = h * factor.min(growth);
        let free = V::from(0.5).at_most(V::load(&self.free));
        let shortened = (!within_tolerance).and(free);
        let steps = V::load(&self.steps);
        self.next = next.store();
        self.h = quiet.or(shortened).choose(next, h).store();
        self.growth = within_tolerance.choose(V::from(8.0), one).store();
        self.steps = quiet.choose(steps + one, steps).store();
        let is_finite = next.at_most(V::from(f64::MAX));
        let exceeds_min = !next.at_most(V::load(&self.min_h));
        shortened.and(is_finite.and(exceeds_min))
    }
}

/// Negative if the contact margin may be negative between two of its nodes.
#[inline(always)]
fn lowest_dip<V: Vector>(margins: &[V; MARGIN_NODES.len()]) -> V {
    dip(0, margins).min(dip(1, margins)).min(dip(2, margins))
}

/// Negative if a parabola through three margins from node `i` on falls and then rises, and its minimum is below a
/// quarter of the middle margin. (Closures would not be inlined, and so not use the registers.)
#[inline(always)]
fn dip<V: Vector>(i: usize, margins: &[V; MARGIN_NODES.len()]) -> V {
    let [x, y, z] = [MARGIN_NODES[i], MARGIN_NODES[i + 1], MARGIN_NODES[i + 2]];
    let before = (margins[i + 1] - margins[i]) * V::from(1.0 / (y - x));
    let after = (margins[i + 2] - margins[i + 1]) * V::from(1.0 / (z - y));
    let curvature = (after - before) * V::from(1.0 / (z - x));
    let first_slope = before - V::from(y - x) * curvature;
    let slope = before + V::from(y - x) * curvature;
    let last_slope = after + V::from(z - y) * curvature;
    // The minimum is lower than the middle margin by slope²/(4 curvature).
    let depth = V::from(3.0) * curvature * margins[i + 1] - slope * slope;
    depth.max(first_slope).max(-last_slope)
}

/// The computation of a step: the motions, their equations and their bounds.
struct Step<'a, P, const N: usize>(&'a mut Lockstep<N>, &'a P, &'a Bounds);

impl<P: ReducedSystem<Lanes, N>, const N: usize> SimdKernel for Step<'_, P, N> {
    type Done = StepOutcome;

    #[inline(always)]
    fn run<V: Vector>(self) -> StepOutcome {
        let Step(lockstep, phase, bounds) = self;
        lockstep.step_in::<V, P>(phase, bounds)
    }
}

/// The argument of the stage that follows `made` finished stages.
#[inline(always)]
fn stage_argument<V: Part, const N: usize>(
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

/// The number of terms to which sums over a row are unrolled.
const TERMS: usize = 9;

const _: () = {
    let mut i = 0;
    while i < STAGES.len() {
        assert!(STAGES[i].len() <= TERMS);
        i += 1;
    }
    assert!(SOLUTION.len() <= TERMS && ERROR_5.len() <= TERMS && ERROR_3.len() <= TERMS);
};

/// Σ weight · stage of a coordinate, summed in the order of the row. The terms are unrolled, so that the
/// weights are compile-time constants.
#[inline(always)]
fn weighted_sum<V: Part, const N: usize>(
    row: Row,
    stages: &[[Lanes; N]; 16],
    part: usize,
    i: usize,
) -> V {
    let i = V::opaque(i);
    // Checked here once, so that the compiler drops the check for every term.
    assert!(i < N, "coordinate out of range");
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

/// u + h Σ weight · stage for the first `count` coordinates; the others keep their values.
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
        *end = *end + h * weighted_sum(row, stages, part, i);
    }
    end
}

/// The indices of the bits that are set.
pub(super) fn lanes_of(mut bits: Bits) -> impl Iterator<Item = usize> {
    core::iter::from_fn(move || {
        let lane = (bits != 0).then(|| bits.trailing_zeros() as usize)?;
        bits &= bits - 1;
        Some(lane)
    })
}

#[cfg(test)]
mod tests {
    use super::super::chunk::Bounds;
    use super::super::reduced_system::{
        ReducedFrictionless, ReducedNoSlip, ReducedSliding, ReducedSystem,
    };
    use super::{Lockstep, StepOutcome};
    use crate::law::Parameters;
    use crate::motion::Options;
    use crate::presets;
    use crate::real::{LANES, Lanes, SimdKernel, Vector, in_every_width};
    use crate::state::{Coordinates, State};

    /// Sixteen cans with different starts.
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
            lockstep.put(lane, u, phase);
            lockstep.h.0[lane] = 1e-3;
            lockstep.direction.0[lane] = -1.0;
            lockstep.free.0[lane] = 1.0;
        }
        lockstep
    }

    /// A computation of twenty steps.
    struct Steps<'a, P>(&'a P, &'a Bounds);

    impl<P: ReducedSystem<Lanes, N>, const N: usize> SimdKernel for (Steps<'_, P>, Lockstep<N>) {
        type Done = (Vec<StepOutcome>, Lockstep<N>);

        fn run<V: Vector>(self) -> Self::Done {
            let (Steps(phase, bounds), mut lockstep) = self;
            let step = |_| lockstep.step_in::<V, P>(phase, bounds);
            ((0..20).map(step).collect(), lockstep)
        }
    }

    fn assert_same_steps_in_every_width<P: ReducedSystem<f64, N>, const N: usize>(friction: f64) {
        let can = presets::can_2007().expect("the paper's can");
        let phase = P::new(Parameters::new(&can, 9.8), friction);
        let in_lanes = phase.with_numbers(|&number| Lanes::from(number));
        let bounds = Bounds::of(&Options::default());
        let steps = || (Steps(&in_lanes, &bounds), cans(&phase));
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
        assert_same_steps_in_every_width::<ReducedNoSlip<f64, false>, 7>(0.0);
        // With this much friction the rim does not slip.
        assert_same_steps_in_every_width::<ReducedNoSlip<f64, true>, 7>(20.0);
        assert_same_steps_in_every_width::<ReducedFrictionless<f64>, 7>(0.0);
        assert_same_steps_in_every_width::<ReducedSliding<f64>, 10>(0.2);
    }
}
