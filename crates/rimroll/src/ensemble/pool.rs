//! Falls whose rims meet the table in the same way, sixteen at a time: each until something happens to it,
//! when its place is free for the next.

use super::carried::Carried;
use super::limits::{Limits, Topple};
use super::lockstep::{Lockstep, MARKS, Mark, Outcome, lanes_of};
use super::piece::BodyNumbers;
use super::trial::Trial;
use crate::motion::Status;
use crate::real::{LANES, Lanes};
use crate::solve::bracketed_in;
use crate::state::Coordinates;
use crate::yardstick::Yardstick;

/// Why a fall leaves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Exit {
    /// It is over.
    Over(Status),
    /// The contact gives way: here it cannot last any longer.
    GivesWay,
    /// The slip has all but stopped.
    Stops,
    /// It meets with what is rare, and is better followed by itself.
    Rare,
}

/// A mark that a step has run over, and how long a step would end at it.
struct Landing {
    mark: Mark,
    /// A step too short, and one too long.
    between: (f64, f64),
    /// How long the next step may be afterwards.
    next: f64,
    rounds: usize,
}

/// So often a landing is tried before the fall counts as rare.
const MOST_ROUNDS: usize = 40;

/// Sixteen places, and the laws there.
pub(super) struct Pool<'a, A: Carried<f64, N>, const N: usize> {
    limits: &'a Limits,
    lockstep: Lockstep<N>,
    /// The laws in all lanes.
    contact: A::Like<Lanes>,
    places: [Place<A>; LANES],
    trials: [Option<Trial>; LANES],
    landings: [Option<Landing>; LANES],
    count: usize,
}

/// A body under a friction in one of the lanes.
#[derive(Clone)]
struct Place<A> {
    /// The place of the body in the piece of work, and the coefficient of friction.
    of: (usize, f64),
    alone: A,
    yardstick: Yardstick<f64>,
    topple: Topple<f64>,
}

impl<A> Place<A> {
    fn new<const N: usize>(body: &BodyNumbers, friction: f64) -> Self
    where
        A: Carried<f64, N>,
    {
        Place {
            of: (body.place, friction),
            alone: A::new(body.parameters, friction),
            yardstick: body.yardstick,
            topple: body.topple,
        }
    }
}

impl<'a, A, const N: usize> Pool<'a, A, N>
where
    A: Carried<f64, N>,
{
    /// No falls yet; the laws of the lanes are at first those of a body without friction.
    pub(super) fn new(body: &BodyNumbers, limits: &'a Limits) -> Self {
        let place: Place<A> = Place::new(body, 0.0);
        let mut lockstep = Lockstep::new();
        lockstep.topple = body.topple.map(|&number| Lanes::from(number));
        Pool {
            limits,
            lockstep,
            contact: place.alone.like(|&number| Lanes::from(number)),
            places: core::array::from_fn(|_| Place::new(body, 0.0)),
            trials: core::array::from_fn(|_| None),
            landings: core::array::from_fn(|_| None),
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
        if self.places[lane].of != (body.place, friction) {
            self.prepare(lane, Place::new(body, friction));
        }
        self.count += 1;
        let (u, alone) = (A::of(at), &self.places[lane].alone);
        self.lockstep.put(lane, u, alone.rates(&u), alone.sizes(&u));
        self.lockstep.h.0[lane] = h;
        self.lockstep.least_h.0[lane] = 1e-16 * h;
        self.lockstep.direction.0[lane] = trial.direction;
        self.lockstep.free.0[lane] = 1.0;
        self.lockstep.steps.0[lane] = trial.steps;
        self.trials[lane] = Some(trial);
        self.landings[lane] = None;
    }

    /// Makes a lane that of another body or friction.
    fn prepare(&mut self, lane: usize, place: Place<A>) {
        let write = |number: &f64, lanes: &mut Lanes| lanes.0[lane] = *number;
        place.alone.write_to(&mut self.contact, write);
        place.topple.write(&mut self.lockstep.topple, write);
        self.places[lane] = place;
    }

    /// Makes a step of each fall; those that leave are handed to `leave` with where they then are.
    pub(super) fn step(&mut self, mut leave: impl FnMut(Trial, Exit, &Coordinates<f64>)) {
        let outcome = self.lockstep.step(&self.contact, self.limits);
        for lane in lanes_of(!outcome.settled) {
            if self.trials[lane].is_none() {
                continue;
            }
            let exit = if outcome.is_good(lane) {
                self.attend(lane, &outcome)
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
        if self.landings[lane].take().is_some() {
            self.lockstep.free.0[lane] = 1.0;
            self.lockstep.h.0[lane] *= 0.5;
        }
        self.long_enough(lane)
    }

    fn long_enough(&self, lane: usize) -> Option<(Exit, Coordinates<f64>)> {
        // Written so that a NaN is too short.
        let long_enough = self.lockstep.h.0[lane] > self.lockstep.least_h.0[lane];
        (!long_enough).then(|| (Exit::Rare, A::all(&self.lockstep.at(lane))))
    }

    /// After a good step on which something may have happened.
    fn attend(&mut self, lane: usize, outcome: &Outcome) -> Option<(Exit, Coordinates<f64>)> {
        let u = A::all(&self.lockstep.end_at(lane));
        let steps = self.lockstep.steps.0[lane];
        // A disk may stand on its edge; what topples at π/2 has its base upright, too.
        let toppled =
            outcome.is_beyond(lane, Mark::Topple) && self.places[lane].topple.is_at_most_upright();
        let on_edge = u.cos <= 0.0 && !toppled;
        if u.sin <= self.limits.flat || on_edge || steps >= self.limits.most_steps {
            return Some((Exit::Rare, u));
        }
        if self.lockstep.direction.0[lane] == 0.0 {
            self.lockstep.direction.0[lane] = self
                .limits
                .sign_of_tilt_rate(&u, &self.places[lane].yardstick);
        }
        let target = self.landings[lane].as_ref().map(|landing| landing.mark);
        match (self.run_over(lane, target, outcome), target) {
            (Some((mark, h)), _) => self.aim(lane, mark, h),
            (None, Some(mark)) => self.land(lane, mark),
            (None, None) => self.go_on(lane),
        }
    }

    /// The first mark that the step has run over, other than the target that it is to land at, and how long a
    /// step would end there.
    fn run_over(
        &self,
        lane: usize,
        target: Option<Mark>,
        outcome: &Outcome,
    ) -> Option<(Mark, f64)> {
        MARKS
            .into_iter()
            .filter(|&mark| Some(mark) != target && outcome.is_beyond(lane, mark))
            .map(|mark| (mark, self.crossing(lane, mark)))
            .min_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// How long a step would about end at a mark that one has run over.
    fn crossing(&self, lane: usize, mark: Mark) -> f64 {
        let (start, end) = (self.lockstep.at(lane), self.lockstep.end_at(lane));
        let (rates, end_rates) = (
            self.lockstep.rates_at(lane),
            self.lockstep.end_rates_at(lane),
        );
        let h = self.lockstep.h.0[lane];
        let level = |u| self.level(lane, mark, u);
        let slope = |u, rates| h * self.slope(lane, mark, u, rates);
        let first = (level(&start), slope(&start, &rates));
        let last = (level(&end), slope(&end, &end_rates));
        h * fraction_crossed(first, last)
    }

    /// Sets out for a mark, from where the step began.
    fn aim(&mut self, lane: usize, mark: Mark, h: f64) -> Option<(Exit, Coordinates<f64>)> {
        let u = A::all(&self.lockstep.end_at(lane));
        let (rounds, next) = match &self.landings[lane] {
            Some(landing) => (landing.rounds, landing.next),
            None => (0, self.lockstep.next.0[lane]),
        };
        // A tilt rate without a clear sign may be that of a steady wobble.
        let unclear = mark == Mark::Extreme
            && self
                .limits
                .sign_of_tilt_rate(&u, &self.places[lane].yardstick)
                == 0.0
            && self.landings[lane].is_none();
        if unclear || rounds > MOST_ROUNDS {
            return Some((Exit::Rare, u));
        }
        self.landings[lane] = Some(Landing {
            mark,
            between: (0.0, self.lockstep.h.0[lane]),
            next,
            rounds: rounds + 1,
        });
        self.lockstep.free.0[lane] = 0.0;
        self.lockstep.h.0[lane] = h;
        None
    }

    /// After a step that was to end at a mark.
    fn land(&mut self, lane: usize, mark: Mark) -> Option<(Exit, Coordinates<f64>)> {
        let (end, rates) = (self.lockstep.end_at(lane), self.lockstep.end_rates_at(lane));
        let h = self.lockstep.h.0[lane];
        let level = self.level(lane, mark, &end);
        let missing = -level / self.slope(lane, mark, &end, &rates);
        let landing = self.landings[lane].as_mut()?;
        landing.rounds += 1;
        if landing.rounds > MOST_ROUNDS {
            return Some((Exit::Rare, A::all(&end)));
        }
        // Either what is missing can go straight, or the mark was passed by next to nothing.
        let is_beside = level < 0.0 && h <= CLOSE * landing.between.1;
        let close = missing.abs() <= CLOSE * h || is_beside;
        if !close {
            if level < 0.0 {
                landing.between.1 = h;
            } else {
                landing.between.0 = h;
            }
            let (short, long) = landing.between;
            let aim = h + missing;
            self.lockstep.h.0[lane] = if short < aim && aim < long {
                aim
            } else {
                0.5 * (short + long)
            };
            return None;
        }
        if self.lockstep.inside.0[lane] < 0.0 {
            // Something else may have happened before.
            self.landings[lane] = None;
            self.lockstep.free.0[lane] = 1.0;
            self.lockstep.h.0[lane] = 0.5 * h;
            return self.long_enough(lane);
        }
        let missing = if missing.abs() <= CLOSE * h {
            missing
        } else {
            0.0
        };
        let at = A::all(&core::array::from_fn(|i| end[i] + missing * rates[i]));
        self.arrive(lane, mark, at)
    }

    /// What happens at a mark.
    fn arrive(
        &mut self,
        lane: usize,
        mark: Mark,
        at: Coordinates<f64>,
    ) -> Option<(Exit, Coordinates<f64>)> {
        match mark {
            Mark::Topple => return Some((Exit::Over(Status::Toppled), at)),
            Mark::Contact => return Some((Exit::GivesWay, at)),
            Mark::Time => {
                let t = self.limits.duration;
                return Some((Exit::Over(Status::Finished), Coordinates { t, ..at }));
            }
            Mark::Extreme => {}
        }
        if at.sin <= self.limits.flat {
            return Some((Exit::Rare, at));
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
        if let Some(landing) = self.landings[lane].take() {
            self.lockstep.h.0[lane] = landing.next;
        }
        None
    }

    /// After a step that has run over nothing.
    fn go_on(&mut self, lane: usize) -> Option<(Exit, Coordinates<f64>)> {
        if self.lockstep.inside.0[lane] < 0.0 {
            // There may have been something on the way.
            self.lockstep.h.0[lane] *= 0.5;
            return self.long_enough(lane);
        }
        self.lockstep.accept(lane);
        self.lockstep.h.0[lane] = self.lockstep.next.0[lane];
        let (end, rates) = (self.lockstep.end_at(lane), self.lockstep.end_rates_at(lane));
        let alone = &self.places[lane].alone;
        let stops = alone.slips_on(&end, &rates, self.limits.tolerance) < 0.0;
        stops.then(|| (Exit::Stops, A::all(&end)))
    }

    fn level(&self, lane: usize, mark: Mark, u: &[f64; N]) -> f64 {
        match mark {
            Mark::Extreme => self.lockstep.direction.0[lane] * A::all(u).p,
            Mark::Topple => self.places[lane].topple.below(&A::all(u)),
            Mark::Time => self.limits.duration - A::all(u).t,
            Mark::Contact => self.places[lane].alone.holds(u),
        }
    }

    /// How the level changes along the motion.
    fn slope(&self, lane: usize, mark: Mark, u: &[f64; N], rates: &[f64; N]) -> f64 {
        match mark {
            // These are linear.
            Mark::Extreme | Mark::Topple => self.level(lane, mark, rates),
            Mark::Time => -A::all(rates).t,
            Mark::Contact => {
                let nudge = 1e-4 * self.lockstep.h.0[lane];
                let beside = |nudge: f64| {
                    let u = core::array::from_fn(|i| u[i] + nudge * rates[i]);
                    self.level(lane, mark, &u)
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
    bracketed_in(ROUNDS, 0.0, 1.0, cubic)
}

#[cfg(test)]
mod tests {
    use super::super::carried::{Carried, Slipping};
    use super::super::piece::Piece;
    use super::super::trial::Trial;
    use super::{Exit, Pool};
    use crate::motion::Options;
    use crate::presets;
    use crate::state::{Coordinates, State};
    use crate::surface::FrictionLaw;

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
        let piece = Piece::new(&releases, &options);
        let (body, limits) = (piece.body(0), &piece.limits);
        let phase = Slipping::new(body.parameters, friction);
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
            assert!(phase.holds(&Slipping::of(&at)) < 0.0);
            let mut pool: Pool<'_, Slipping<f64>, 10> = Pool::new(body, limits);
            let trial = Trial::new(0, &at, true);
            pool.put(trial, &at, (body, friction), 1e-4);
            let mut left = None;
            for _ in 0..200 {
                pool.step(|_, exit, _| left = Some(exit));
            }
            assert_eq!((left, pool.len()), (Some(Exit::Rare), 0));
        }
    }
}
