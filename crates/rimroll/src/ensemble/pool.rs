//! A pool of sixteen lanes for falls in the same phase. The pool locates the events of each fall. A fall that
//! ends its phase leaves its lane to the next fall.

use super::chunk::{ActiveFall, BodyNumbers, Bounds};
use super::lockstep::{EVENT_FUNCTIONS, EventFunction, Lockstep, StepOutcome, lanes_of};
use super::reduced_system::ReducedSystem;
use crate::error_scale::ErrorScale;
use crate::motion::{Status, ToppleTilt};
use crate::real::{LANES, Lanes};
use crate::solve::bracketed_root_in;
use crate::state::Coordinates;

/// The reason why a fall leaves the pool.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Exit {
    /// The fall is complete.
    Over(Status),
    /// The contact condition of the phase ends here.
    ContactEnds,
    /// The slip is about to stop.
    SlipEnds,
    /// The scalar solver must compute the fall.
    NeedsScalar,
}

/// An event that a step has crossed, with a bracket of the step size that ends at the event.
struct Bracket {
    event: EventFunction,
    /// A step size that is too small and one that is too large.
    between: (f64, f64),
    /// The step size after the event.
    next: f64,
    rounds: usize,
}

/// The maximal number of steps to locate an event before the scalar solver takes over.
const MAX_ROUNDS: usize = 40;

/// Sixteen lanes with their falls and equations.
pub(super) struct Pool<'a, A: ReducedSystem<f64, N>, const N: usize> {
    bounds: &'a Bounds,
    lockstep: Lockstep<N>,
    /// The equations of all lanes.
    contact: A::With<Lanes>,
    lane_models: [LaneModel<A>; LANES],
    falls: [Option<ActiveFall>; LANES],
    brackets: [Option<Bracket>; LANES],
    count: usize,
}

/// The body and the friction of one lane.
#[derive(Clone)]
struct LaneModel<A> {
    /// The index of the body in the chunk of work, and the coefficient of friction.
    key: (usize, f64),
    system: A,
    error_scale: ErrorScale<f64>,
    topple: ToppleTilt<f64>,
}

impl<A> LaneModel<A> {
    fn new<const N: usize>(body: &BodyNumbers, friction: f64) -> Self
    where
        A: ReducedSystem<f64, N>,
    {
        LaneModel {
            key: (body.place, friction),
            system: A::new(body.parameters, friction),
            error_scale: body.error_scale,
            topple: body.topple,
        }
    }
}

impl<'a, A, const N: usize> Pool<'a, A, N>
where
    A: ReducedSystem<f64, N>,
{
    /// An empty pool, whose lanes are prepared for a body without friction.
    pub(super) fn new(body: &BodyNumbers, bounds: &'a Bounds) -> Self {
        let model: LaneModel<A> = LaneModel::new(body, 0.0);
        let mut lockstep = Lockstep::new();
        lockstep.topple = body.topple.map(|&number| Lanes::from(number));
        Pool {
            bounds,
            lockstep,
            contact: model.system.with_numbers(|&number| Lanes::from(number)),
            lane_models: core::array::from_fn(|_| LaneModel::new(body, 0.0)),
            falls: core::array::from_fn(|_| None),
            brackets: core::array::from_fn(|_| None),
            count: 0,
        }
    }

    /// The number of falls in the pool.
    pub(super) fn len(&self) -> usize {
        self.count
    }

    /// Puts a fall into a free lane, which must exist; `h` is a first guess for the step size.
    pub(super) fn put(
        &mut self,
        fall: ActiveFall,
        at: &Coordinates<f64>,
        (body, friction): (&BodyNumbers, f64),
        h: f64,
    ) {
        let Some(lane) = self.falls.iter().position(Option::is_none) else {
            unreachable!("a fall is put only into a pool with a free lane");
        };
        if self.lane_models[lane].key != (body.place, friction) {
            self.prepare(lane, LaneModel::new(body, friction));
        }
        self.count += 1;
        self.lockstep
            .put(lane, A::project(at), &self.lane_models[lane].system);
        self.lockstep.h.0[lane] = h;
        self.lockstep.min_h.0[lane] = 1e-16 * h;
        self.lockstep.direction.0[lane] = fall.direction;
        self.lockstep.free.0[lane] = 1.0;
        self.lockstep.steps.0[lane] = fall.steps;
        self.falls[lane] = Some(fall);
        self.brackets[lane] = None;
    }

    /// Prepares a lane for another body or friction.
    fn prepare(&mut self, lane: usize, model: LaneModel<A>) {
        let write = |number: &f64, lanes: &mut Lanes| lanes.0[lane] = *number;
        model.system.write_to(&mut self.contact, write);
        model.topple.write(&mut self.lockstep.topple, write);
        self.lane_models[lane] = model;
    }

    /// Makes a step of each fall. Each fall that leaves the pool is passed to `leave` with its coordinates.
    pub(super) fn step(&mut self, mut leave: impl FnMut(ActiveFall, Exit, &Coordinates<f64>)) {
        let outcome = self.lockstep.step(&self.contact, self.bounds);
        for lane in lanes_of(!outcome.settled) {
            if self.falls[lane].is_none() {
                continue;
            }
            let exit = if outcome.is_within_tolerance(lane) {
                self.inspect_step(lane, &outcome)
            } else {
                self.shorten(lane)
            };
            let Some((exit, at)) = exit else {
                continue;
            };
            self.lockstep.free.0[lane] = 0.0;
            self.count -= 1;
            if let Some(mut fall) = self.falls[lane].take() {
                fall.direction = self.lockstep.direction.0[lane];
                fall.steps = self.lockstep.steps.0[lane];
                leave(fall, exit, &at);
            }
        }
    }

    /// Handles a step whose error exceeds the tolerance, either while an event is located or at the minimal step
    /// size.
    fn shorten(&mut self, lane: usize) -> Option<(Exit, Coordinates<f64>)> {
        if self.brackets[lane].take().is_some() {
            self.lockstep.free.0[lane] = 1.0;
            self.lockstep.h.0[lane] *= 0.5;
        }
        self.check_step_size(lane)
    }

    /// The exit of a fall whose step size underflows.
    fn check_step_size(&self, lane: usize) -> Option<(Exit, Coordinates<f64>)> {
        // A NaN counts as underflow.
        let exceeds_min = self.lockstep.h.0[lane] > self.lockstep.min_h.0[lane];
        (!exceeds_min).then(|| (Exit::NeedsScalar, A::expand(&self.lockstep.at(lane))))
    }

    /// Handles a step within the tolerance in which an event is possible.
    fn inspect_step(
        &mut self,
        lane: usize,
        outcome: &StepOutcome,
    ) -> Option<(Exit, Coordinates<f64>)> {
        let u = A::expand(&self.lockstep.end_at(lane));
        let steps = self.lockstep.steps.0[lane];
        // A disk can stand on its edge. A body that topples at π/2 also has a vertical base, but it is not on edge.
        let toppled = outcome.has_crossed(lane, EventFunction::Topple)
            && self.lane_models[lane].topple.is_at_most_upright();
        let on_edge = u.cos <= 0.0 && !toppled;
        if u.sin <= self.bounds.flat || on_edge || steps >= self.bounds.max_steps {
            return Some((Exit::NeedsScalar, u));
        }
        if self.lockstep.direction.0[lane] == 0.0 {
            self.lockstep.direction.0[lane] = self
                .bounds
                .sign_of_tilt_rate(&u, &self.lane_models[lane].error_scale);
        }
        let target = self.brackets[lane].as_ref().map(|bracket| bracket.event);
        match (self.first_crossing(lane, target, outcome), target) {
            (Some((event, h)), _) => self.begin_locating(lane, event, h),
            (None, Some(event)) => self.locate(lane, event),
            (None, None) => self.accept_quiet_step(lane),
        }
    }

    /// The first event that the step has crossed, other than the target that is being located, and the step size
    /// that ends there.
    fn first_crossing(
        &self,
        lane: usize,
        target: Option<EventFunction>,
        outcome: &StepOutcome,
    ) -> Option<(EventFunction, f64)> {
        EVENT_FUNCTIONS
            .into_iter()
            .filter(|&event| Some(event) != target && outcome.has_crossed(lane, event))
            .map(|event| (event, self.step_size_to(lane, event)))
            .min_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// An estimate of the step size that ends at an event which the step has crossed.
    fn step_size_to(&self, lane: usize, event: EventFunction) -> f64 {
        let (start, end) = (self.lockstep.at(lane), self.lockstep.end_at(lane));
        let (rates, end_rates) = (
            self.lockstep.rates_at(lane),
            self.lockstep.end_rates_at(lane),
        );
        let h = self.lockstep.h.0[lane];
        let event_value = |u| self.event_value(lane, event, u);
        let slope = |u, rates| h * self.slope(lane, event, u, rates);
        let first = (event_value(&start), slope(&start, &rates));
        let last = (event_value(&end), slope(&end, &end_rates));
        h * fraction_crossed(first, last)
    }

    /// Begins to locate an event: the step is repeated from its start with the size `h`.
    fn begin_locating(
        &mut self,
        lane: usize,
        event: EventFunction,
        h: f64,
    ) -> Option<(Exit, Coordinates<f64>)> {
        let u = A::expand(&self.lockstep.end_at(lane));
        let (rounds, next) = match &self.brackets[lane] {
            Some(bracket) => (bracket.rounds, bracket.next),
            None => (0, self.lockstep.next.0[lane]),
        };
        // A tilt rate without a significant sign can belong to a steady wobble.
        let insignificant = event == EventFunction::Extreme
            && self
                .bounds
                .sign_of_tilt_rate(&u, &self.lane_models[lane].error_scale)
                == 0.0
            && self.brackets[lane].is_none();
        if insignificant || rounds > MAX_ROUNDS {
            return Some((Exit::NeedsScalar, u));
        }
        self.brackets[lane] = Some(Bracket {
            event,
            between: (0.0, self.lockstep.h.0[lane]),
            next,
            rounds: rounds + 1,
        });
        self.lockstep.free.0[lane] = 0.0;
        self.lockstep.h.0[lane] = h;
        None
    }

    /// Handles a step that should end at an event.
    fn locate(&mut self, lane: usize, event: EventFunction) -> Option<(Exit, Coordinates<f64>)> {
        let (end, rates) = (self.lockstep.end_at(lane), self.lockstep.end_rates_at(lane));
        let h = self.lockstep.h.0[lane];
        let event_value = self.event_value(lane, event, &end);
        let missing = -event_value / self.slope(lane, event, &end, &rates);
        let bracket = self.brackets[lane].as_mut()?;
        bracket.rounds += 1;
        if bracket.rounds > MAX_ROUNDS {
            return Some((Exit::NeedsScalar, A::expand(&end)));
        }
        // Either linear extrapolation covers the rest, or even a negligibly short step crosses the event.
        let is_negligible = event_value < 0.0 && h <= CLOSE * bracket.between.1;
        let close = missing.abs() <= CLOSE * h || is_negligible;
        if !close {
            if event_value < 0.0 {
                bracket.between.1 = h;
            } else {
                bracket.between.0 = h;
            }
            let (short, long) = bracket.between;
            let newton = h + missing;
            self.lockstep.h.0[lane] = if short < newton && newton < long {
                newton
            } else {
                0.5 * (short + long)
            };
            return None;
        }
        if self.lockstep.inside.0[lane] < 0.0 {
            // Another event may precede this one.
            self.brackets[lane] = None;
            self.lockstep.free.0[lane] = 1.0;
            self.lockstep.h.0[lane] = 0.5 * h;
            return self.check_step_size(lane);
        }
        let missing = if missing.abs() <= CLOSE * h {
            missing
        } else {
            0.0
        };
        let at = A::expand(&core::array::from_fn(|i| end[i] + missing * rates[i]));
        self.at_event(lane, event, at)
    }

    /// Handles a located event.
    fn at_event(
        &mut self,
        lane: usize,
        event: EventFunction,
        at: Coordinates<f64>,
    ) -> Option<(Exit, Coordinates<f64>)> {
        match event {
            EventFunction::Topple => return Some((Exit::Over(Status::Toppled), at)),
            EventFunction::Contact => return Some((Exit::ContactEnds, at)),
            EventFunction::Time => {
                let t = self.bounds.duration;
                return Some((Exit::Over(Status::Finished), Coordinates { t, ..at }));
            }
            EventFunction::Extreme => {}
        }
        if at.sin <= self.bounds.flat {
            return Some((Exit::NeedsScalar, at));
        }
        let fall = self.falls[lane].as_mut()?;
        if self.lockstep.direction.0[lane] < 0.0 {
            fall.lowest = Some(at);
        } else if fall.lowest.is_some() {
            fall.turned = true;
            return Some((Exit::Over(Status::Finished), at));
        } else {
            fall.from = at;
        }
        self.lockstep.direction.0[lane] = -self.lockstep.direction.0[lane];
        self.lockstep.accept(lane);
        self.lockstep.free.0[lane] = 1.0;
        if let Some(bracket) = self.brackets[lane].take() {
            self.lockstep.h.0[lane] = bracket.next;
        }
        None
    }

    /// Handles a step that has not crossed an event.
    fn accept_quiet_step(&mut self, lane: usize) -> Option<(Exit, Coordinates<f64>)> {
        if self.lockstep.inside.0[lane] < 0.0 {
            // A pair of events may lie inside the step.
            self.lockstep.h.0[lane] *= 0.5;
            return self.check_step_size(lane);
        }
        self.lockstep.accept(lane);
        self.lockstep.h.0[lane] = self.lockstep.next.0[lane];
        let (end, rates) = (self.lockstep.end_at(lane), self.lockstep.end_rates_at(lane));
        let system = &self.lane_models[lane].system;
        let stops = system.slip_persists(&end, &rates, self.bounds.tolerance) < 0.0;
        stops.then(|| (Exit::SlipEnds, A::expand(&end)))
    }

    fn event_value(&self, lane: usize, event: EventFunction, u: &[f64; N]) -> f64 {
        match event {
            EventFunction::Extreme => self.lockstep.direction.0[lane] * A::expand(u).p,
            EventFunction::Topple => self.lane_models[lane].topple.below(&A::expand(u)),
            EventFunction::Time => self.bounds.duration - A::expand(u).t,
            EventFunction::Contact => self.lane_models[lane].system.contact_margin(u),
        }
    }

    /// The derivative of an event function along the motion.
    fn slope(&self, lane: usize, event: EventFunction, u: &[f64; N], rates: &[f64; N]) -> f64 {
        match event {
            // These event functions are linear.
            EventFunction::Extreme | EventFunction::Topple => self.event_value(lane, event, rates),
            EventFunction::Time => -A::expand(rates).t,
            EventFunction::Contact => {
                let nudge = 1e-4 * self.lockstep.h.0[lane];
                let value_after = |nudge: f64| {
                    let u = core::array::from_fn(|i| u[i] + nudge * rates[i]);
                    self.event_value(lane, event, &u)
                };
                (value_after(nudge) - value_after(-nudge)) / (2.0 * nudge)
            }
        }
    }
}

/// The fraction of a step over which linear extrapolation to an event is accurate enough.
const CLOSE: f64 = 1e-6;

/// The fraction of a step at which an event function changes sign, from the cubic Hermite interpolant. Each
/// argument holds the value and the slope (times the step size) at one end.
fn fraction_crossed(first: (f64, f64), last: (f64, f64)) -> f64 {
    // The event function is not a cubic, so further rounds would only refine the root of the cubic. Locating the
    // event corrects the difference.
    const ROUNDS: usize = 4;
    let increment = last.0 - first.0;
    let cubic = |x: f64| {
        let correction = (first.1 - increment) * (1.0 - x) + (increment - last.1) * x;
        first.0 + x * (increment + (1.0 - x) * correction)
    };
    bracketed_root_in(ROUNDS, 0.0, 1.0, cubic)
}

#[cfg(test)]
mod tests {
    use super::super::chunk::ActiveFall;
    use super::super::chunk::Chunk;
    use super::super::reduced_system::{ReducedSliding, ReducedSystem};
    use super::{Exit, Pool};
    use crate::law::FrictionLaw;
    use crate::motion::Options;
    use crate::presets;
    use crate::state::{Coordinates, State};

    #[test]
    fn a_fall_with_negative_normal_force_leaves_the_pool() {
        let can = presets::can_2007().expect("the paper's can");
        let friction = 0.2;
        let releases = [(
            &can,
            State::default(),
            FrictionLaw::coulomb(friction).into(),
        )];
        let options = Options::default();
        let chunk = Chunk::new(&releases, &options);
        let (body, bounds) = (chunk.body(0), &chunk.bounds);
        let phase = ReducedSliding::new(body.parameters, friction);
        // At these tilt rates the normal force would be negative, with increasing or decreasing magnitude.
        for tilt_rate in [-30.0, 30.0] {
            let start = State {
                tilt: 0.5,
                tilt_rate,
                yaw_rate: 0.1,
                ..State::default()
            };
            let at = Coordinates {
                slip_x: 0.1,
                ..Coordinates::from_state(&start)
            };
            assert!(phase.contact_margin(&ReducedSliding::project(&at)) < 0.0);
            let mut pool: Pool<'_, ReducedSliding<f64>, 10> = Pool::new(body, bounds);
            let fall = ActiveFall::new(0, &at, true);
            pool.put(fall, &at, (body, friction), 1e-4);
            let mut left = None;
            for _ in 0..200 {
                pool.step(|_, exit, _| left = Some(exit));
            }
            assert_eq!((left, pool.len()), (Some(Exit::NeedsScalar), 0));
        }
    }
}
