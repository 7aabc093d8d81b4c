//! Falls whose rims meet the table in the same way, sixteen at a time: each until something happens to it,
//! when its place is free for the next.

use super::chunk::BodyNumbers;
use super::limits::{Limits, Topple};
use super::lockstep::{EVENT_FUNCTIONS, EventFunction, Lockstep, StepOutcome, lanes_of};
use super::reduced_system::ReducedSystem;
use super::trial::Trial;
use crate::error_scale::ErrorScale;
use crate::motion::Status;
use crate::real::{LANES, Lanes};
use crate::solve::bracketed_root_in;
use crate::state::Coordinates;

/// Why a fall leaves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Exit {
    /// It is over.
    Over(Status),
    /// The contact gives way: here it cannot last any longer.
    ContactEnds,
    /// The slip has all but stopped.
    SlipEnds,
    /// It meets with what is rare, and is better followed by itself.
    NeedsScalar,
}

/// A mark that a step has run over, and how long a step would end at it.
struct Bracket {
    event: EventFunction,
    /// A step too short, and one too long.
    between: (f64, f64),
    /// How long the next step may be afterwards.
    next: f64,
    rounds: usize,
}

/// So often a landing is tried before the fall counts as rare.
const MAX_ROUNDS: usize = 40;

/// Sixteen places, and the laws there.
pub(super) struct Pool<'a, A: ReducedSystem<f64, N>, const N: usize> {
    limits: &'a Limits,
    lockstep: Lockstep<N>,
    /// The laws in all lanes.
    contact: A::With<Lanes>,
    lane_models: [LaneModel<A>; LANES],
    trials: [Option<Trial>; LANES],
    brackets: [Option<Bracket>; LANES],
    count: usize,
}

/// A body under a friction in one of the lanes.
#[derive(Clone)]
struct LaneModel<A> {
    /// The place of the body in the piece of work, and the coefficient of friction.
    of: (usize, f64),
    alone: A,
    error_scale: ErrorScale<f64>,
    topple: Topple<f64>,
}

impl<A> LaneModel<A> {
    fn new<const N: usize>(body: &BodyNumbers, friction: f64) -> Self
    where
        A: ReducedSystem<f64, N>,
    {
        LaneModel {
            of: (body.place, friction),
            alone: A::new(body.parameters, friction),
            error_scale: body.error_scale,
            topple: body.topple,
        }
    }
}

impl<'a, A, const N: usize> Pool<'a, A, N>
where
    A: ReducedSystem<f64, N>,
{
    /// No falls yet; the laws of the lanes are at first those of a body without friction.
    pub(super) fn new(body: &BodyNumbers, limits: &'a Limits) -> Self {
        let place: LaneModel<A> = LaneModel::new(body, 0.0);
        let mut lockstep = Lockstep::new();
        lockstep.topple = body.topple.map(|&number| Lanes::from(number));
        Pool {
            limits,
            lockstep,
            contact: place.alone.with_numbers(|&number| Lanes::from(number)),
            lane_models: core::array::from_fn(|_| LaneModel::new(body, 0.0)),
            trials: core::array::from_fn(|_| None),
            brackets: core::array::from_fn(|_| None),
            count: 0,
        }
    }

    /// How many falls are under way.
    pub(super) fn len(&self) -> usize {
        self.count
    }

    /// Takes in a fall of a body under a friction, where there is a place; `h` is a first guess for the length of
    /// a step.
    pub(super) fn put(
        &mut self,
        trial: Trial,
        at: &Coordinates<f64>,
        (body, friction): (&BodyNumbers, f64),
        h: f64,
    ) {
        let Some(lane) = self.trials.iter().position(Option::is_none) else {
            unreachable!("a fall is put where there is a place");
        };
        if self.lane_models[lane].of != (body.place, friction) {
            self.prepare(lane, LaneModel::new(body, friction));
        }
        self.count += 1;
        let (u, alone) = (A::project(at), &self.lane_models[lane].alone);
        self.lockstep
            .put(lane, u, alone.rates(&u), alone.scales(&u));
        self.lockstep.h.0[lane] = h;
        self.lockstep.min_h.0[lane] = 1e-16 * h;
        self.lockstep.direction.0[lane] = trial.direction;
        self.lockstep.free.0[lane] = 1.0;
        self.lockstep.steps.0[lane] = trial.steps;
        self.trials[lane] = Some(trial);
        self.brackets[lane] = None;
    }

    /// Makes a lane that of another body or friction.
    fn prepare(&mut self, lane: usize, place: LaneModel<A>) {
        let write = |number: &f64, lanes: &mut Lanes| lanes.0[lane] = *number;
        place.alone.write_to(&mut self.contact, write);
        place.topple.write(&mut self.lockstep.topple, write);
        self.lane_models[lane] = place;
    }

    /// Makes a step of each fall; those that leave are handed to `leave` with where they then are.
    pub(super) fn step(&mut self, mut leave: impl FnMut(Trial, Exit, &Coordinates<f64>)) {
        let outcome = self.lockstep.step(&self.contact, self.limits);
        for lane in lanes_of(!outcome.settled) {
            if self.trials[lane].is_none() {
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
            if let Some(mut trial) = self.trials[lane].take() {
                trial.direction = self.lockstep.direction.0[lane];
                trial.steps = self.lockstep.steps.0[lane];
                leave(trial, exit, &at);
            }
        }
    }

    /// After a step that was not good enough, on the way to a mark or already too short.
    fn shorten(&mut self, lane: usize) -> Option<(Exit, Coordinates<f64>)> {
        if self.brackets[lane].take().is_some() {
            self.lockstep.free.0[lane] = 1.0;
            self.lockstep.h.0[lane] *= 0.5;
        }
        self.long_enough(lane)
    }

    fn long_enough(&self, lane: usize) -> Option<(Exit, Coordinates<f64>)> {
        // Written so that a NaN is too short.
        let long_enough = self.lockstep.h.0[lane] > self.lockstep.min_h.0[lane];
        (!long_enough).then(|| (Exit::NeedsScalar, A::expand(&self.lockstep.at(lane))))
    }

    /// After a good step on which something may have happened.
    fn inspect_step(
        &mut self,
        lane: usize,
        outcome: &StepOutcome,
    ) -> Option<(Exit, Coordinates<f64>)> {
        let u = A::expand(&self.lockstep.end_at(lane));
        let steps = self.lockstep.steps.0[lane];
        // A disk may stand on its edge; what topples at π/2 has its base upright, too.
        let toppled = outcome.has_crossed(lane, EventFunction::Topple)
            && self.lane_models[lane].topple.is_at_most_upright();
        let on_edge = u.cos <= 0.0 && !toppled;
        if u.sin <= self.limits.flat || on_edge || steps >= self.limits.max_steps {
            return Some((Exit::NeedsScalar, u));
        }
        if self.lockstep.direction.0[lane] == 0.0 {
            self.lockstep.direction.0[lane] = self
                .limits
                .sign_of_tilt_rate(&u, &self.lane_models[lane].error_scale);
        }
        let target = self.brackets[lane].as_ref().map(|bracket| bracket.event);
        match (self.first_crossing(lane, target, outcome), target) {
            (Some((event, h)), _) => self.begin_locating(lane, event, h),
            (None, Some(event)) => self.locate(lane, event),
            (None, None) => self.accept_quiet_step(lane),
        }
    }

    /// The first mark that the step has run over, other than the target that it is to land at, and how long a
    /// step would end there.
    fn first_crossing(
        &self,
        lane: usize,
        target: Option<EventFunction>,
        outcome: &StepOutcome,
    ) -> Option<(EventFunction, f64)> {
        EVENT_FUNCTIONS
            .into_iter()
            .filter(|&event| Some(event) != target && outcome.has_crossed(lane, event))
            .map(|event| (event, self.crossing_length(lane, event)))
            .min_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// How long a step would about end at a mark that one has run over.
    fn crossing_length(&self, lane: usize, event: EventFunction) -> f64 {
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

    /// Sets out for a mark, from where the step began.
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
        // A tilt rate without a clear sign may be that of a steady wobble.
        let unclear = event == EventFunction::Extreme
            && self
                .limits
                .sign_of_tilt_rate(&u, &self.lane_models[lane].error_scale)
                == 0.0
            && self.brackets[lane].is_none();
        if unclear || rounds > MAX_ROUNDS {
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

    /// After a step that was to end at a mark.
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
        // Either what is missing can go straight, or the mark was passed by next to nothing.
        let is_beside = event_value < 0.0 && h <= CLOSE * bracket.between.1;
        let close = missing.abs() <= CLOSE * h || is_beside;
        if !close {
            if event_value < 0.0 {
                bracket.between.1 = h;
            } else {
                bracket.between.0 = h;
            }
            let (short, long) = bracket.between;
            let begin_locating = h + missing;
            self.lockstep.h.0[lane] = if short < begin_locating && begin_locating < long {
                begin_locating
            } else {
                0.5 * (short + long)
            };
            return None;
        }
        if self.lockstep.inside.0[lane] < 0.0 {
            // Something else may have happened before.
            self.brackets[lane] = None;
            self.lockstep.free.0[lane] = 1.0;
            self.lockstep.h.0[lane] = 0.5 * h;
            return self.long_enough(lane);
        }
        let missing = if missing.abs() <= CLOSE * h {
            missing
        } else {
            0.0
        };
        let at = A::expand(&core::array::from_fn(|i| end[i] + missing * rates[i]));
        self.at_event(lane, event, at)
    }

    /// What happens at a mark.
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
                let t = self.limits.duration;
                return Some((Exit::Over(Status::Finished), Coordinates { t, ..at }));
            }
            EventFunction::Extreme => {}
        }
        if at.sin <= self.limits.flat {
            return Some((Exit::NeedsScalar, at));
        }
        let trial = self.trials[lane].as_mut()?;
        if self.lockstep.direction.0[lane] < 0.0 {
            trial.lowest = Some(at);
        } else if trial.lowest.is_some() {
            trial.turned = true;
            return Some((Exit::Over(Status::Finished), at));
        } else {
            trial.from = at;
        }
        self.lockstep.direction.0[lane] = -self.lockstep.direction.0[lane];
        self.lockstep.accept(lane);
        self.lockstep.free.0[lane] = 1.0;
        if let Some(bracket) = self.brackets[lane].take() {
            self.lockstep.h.0[lane] = bracket.next;
        }
        None
    }

    /// After a step that has run over nothing.
    fn accept_quiet_step(&mut self, lane: usize) -> Option<(Exit, Coordinates<f64>)> {
        if self.lockstep.inside.0[lane] < 0.0 {
            // There may have been something on the way.
            self.lockstep.h.0[lane] *= 0.5;
            return self.long_enough(lane);
        }
        self.lockstep.accept(lane);
        self.lockstep.h.0[lane] = self.lockstep.next.0[lane];
        let (end, rates) = (self.lockstep.end_at(lane), self.lockstep.end_rates_at(lane));
        let alone = &self.lane_models[lane].alone;
        let stops = alone.slip_persists(&end, &rates, self.limits.tolerance) < 0.0;
        stops.then(|| (Exit::SlipEnds, A::expand(&end)))
    }

    fn event_value(&self, lane: usize, event: EventFunction, u: &[f64; N]) -> f64 {
        match event {
            EventFunction::Extreme => self.lockstep.direction.0[lane] * A::expand(u).p,
            EventFunction::Topple => self.lane_models[lane].topple.below(&A::expand(u)),
            EventFunction::Time => self.limits.duration - A::expand(u).t,
            EventFunction::Contact => self.lane_models[lane].alone.contact_margin(u),
        }
    }

    /// How the level changes along the motion.
    fn slope(&self, lane: usize, event: EventFunction, u: &[f64; N], rates: &[f64; N]) -> f64 {
        match event {
            // These are linear.
            EventFunction::Extreme | EventFunction::Topple => self.event_value(lane, event, rates),
            EventFunction::Time => -A::expand(rates).t,
            EventFunction::Contact => {
                let nudge = 1e-4 * self.lockstep.h.0[lane];
                let beside = |nudge: f64| {
                    let u = core::array::from_fn(|i| u[i] + nudge * rates[i]);
                    self.event_value(lane, event, &u)
                };
                (beside(nudge) - beside(-nudge)) / (2.0 * nudge)
            }
        }
    }
}

/// A landing so close to its mark, as a part of the step, that what is missing can go straight.
const CLOSE: f64 = 1e-6;

/// The fraction of a step at which a level changes sign, by the cubic through its values and slopes (times
/// the step) at the ends.
fn fraction_crossed(first: (f64, f64), last: (f64, f64)) -> f64 {
    // The motion is no cubic: more digits of the root would be those of the cubic alone, and a landing that
    // sets out for it corrects what is missing.
    const ROUNDS: usize = 4;
    let rise = last.0 - first.0;
    let cubic = |x: f64| {
        let beside = (first.1 - rise) * (1.0 - x) + (rise - last.1) * x;
        first.0 + x * (rise + (1.0 - x) * beside)
    };
    bracketed_root_in(ROUNDS, 0.0, 1.0, cubic)
}

#[cfg(test)]
mod tests {
    use super::super::chunk::Chunk;
    use super::super::reduced_system::{ReducedSliding, ReducedSystem};
    use super::super::trial::Trial;
    use super::{Exit, Pool};
    use crate::law::FrictionLaw;
    use crate::motion::Options;
    use crate::presets;
    use crate::state::{Coordinates, State};

    #[test]
    fn a_fall_whose_contact_does_not_last_leaves() {
        let can = presets::can_2007().expect("the paper's can");
        let friction = 0.2;
        let releases = [(
            &can,
            State::default(),
            FrictionLaw::coulomb(friction).into(),
        )];
        let options = Options::default();
        let chunk = Chunk::new(&releases, &options);
        let (body, limits) = (chunk.body(0), &chunk.limits);
        let phase = ReducedSliding::new(body.parameters, friction);
        // So fast that the rim is pulled off the table, harder and harder or ever less.
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
            let mut pool: Pool<'_, ReducedSliding<f64>, 10> = Pool::new(body, limits);
            let trial = Trial::new(0, &at, true);
            pool.put(trial, &at, (body, friction), 1e-4);
            let mut left = None;
            for _ in 0..200 {
                pool.step(|_, exit, _| left = Some(exit));
            }
            assert_eq!((left, pool.len()), (Some(Exit::NeedsScalar), 0));
        }
    }
}
