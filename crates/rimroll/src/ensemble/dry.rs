//! Falls under dry friction: those that roll go together, and those that slide; a fall changes from the
//! one to the other and back.

use super::chunk::{BodyNumbers, Chunk};
use super::onset::{OnsetResult, OnsetStart, begin};
use super::pool::{Exit, Pool};
use super::reduced_system::{ReducedNoSlip, ReducedSliding, ReducedSystem};
use super::trial::Trial;
use crate::law::Coulomb;
use crate::law::FrictionLaw;
use crate::law::{Dynamics, NoSlip};
use crate::motion::{Contacts, Fall, Transition, stopped};
use crate::real::LANES;
use crate::state::Coordinates;

type RollingPool<'a> = Pool<'a, ReducedNoSlip<f64, true>, 7>;
type SlippingPool<'a> = Pool<'a, ReducedSliding<f64>, 10>;

/// A fall between two phases: where it is, and how long a step to try.
struct Waiting {
    trial: Trial,
    at: Coordinates<f64>,
    h: f64,
}

/// A fall whose slip is to begin.
struct ToSlip {
    trial: Trial,
    beginning: OnsetStart,
    result: Option<OnsetResult>,
}

/// How a phase is to begin.
#[expect(clippy::large_enum_variant, reason = "it is taken apart at once")]
enum PhaseStart {
    ReducedNoSlip(Waiting),
    ReducedSliding(ToSlip),
}

pub(super) struct Dry<'a> {
    chunk: &'a Chunk<'a>,
    /// The length of a slip's first step, in first steps.
    onset: f64,
    done: &'a mut [Option<Fall>],
}

impl<'a> Dry<'a> {
    pub(super) fn new(chunk: &'a Chunk<'a>, done: &'a mut [Option<Fall>]) -> Self {
        Dry {
            chunk,
            onset: onset_length(chunk.limits.tolerance),
            done,
        }
    }

    /// Follows the falls from some of the trials; those that meet with what is rare are left undone.
    pub(super) fn follow(&mut self, waiting: impl Iterator<Item = usize>) {
        let mut waiting = waiting.peekable();
        let Some(&first) = waiting.peek() else { return };
        let (body, limits) = (self.chunk.body(first), &self.chunk.limits);
        let mut rolling = RollingPool::new(body, limits);
        let mut slipping = SlippingPool::new(body, limits);
        let mut to_roll: Vec<Waiting> = Vec::with_capacity(2 * LANES);
        let mut to_slip: Vec<ToSlip> = Vec::with_capacity(2 * LANES);
        let mut slipped: Vec<Waiting> = Vec::with_capacity(2 * LANES);
        loop {
            while rolling.len() < LANES {
                let next = to_roll
                    .pop()
                    .or_else(|| self.next(&mut waiting, &mut to_slip));
                let Some(Waiting { trial, at, h }) = next else {
                    break;
                };
                let (_, held_by) = self.frictions(&trial);
                let body = self.body(&trial);
                rolling.put(trial, &at, (body, held_by), h);
            }
            while slipping.len() < LANES {
                if slipped.is_empty() && (to_slip.len() >= LANES || rolling.len() == 0) {
                    self.begin_to_slip(&mut to_slip, &mut slipped);
                }
                let Some(Waiting { trial, at, h }) = slipped.pop() else {
                    break;
                };
                let (friction, _) = self.frictions(&trial);
                let body = self.body(&trial);
                slipping.put(trial, &at, (body, friction), h);
            }
            if rolling.len() + slipping.len() + to_slip.len() == 0 {
                if waiting.peek().is_some() {
                    // All that were to begin to slip were rare.
                    continue;
                }
                return;
            }
            let most_roll = rolling.len() == LANES || rolling.len() > slipping.len();
            let rolling_goes_on = slipping.len() < LANES && most_roll;
            let mut begin = |begins| match begins {
                PhaseStart::ReducedNoSlip(waiting) => to_roll.push(waiting),
                PhaseStart::ReducedSliding(waiting) => to_slip.push(waiting),
            };
            // So that few lanes are empty: those that slide wait until there are enough of them, or few that roll.
            if rolling_goes_on {
                rolling.step(|trial, exit, at| {
                    self.after_rolling(trial, exit, at).map(&mut begin);
                });
            } else {
                slipping.step(|trial, exit, at| {
                    self.after_slipping(trial, exit, at).map(&mut begin);
                });
            }
        }
    }

    fn body(&self, trial: &Trial) -> &'a BodyNumbers {
        self.chunk.body(trial.index)
    }

    /// Coefficients of friction: of slipping and static.
    fn frictions(&self, trial: &Trial) -> (f64, f64) {
        match self.chunk.trials[trial.index].2.friction {
            FrictionLaw::Coulomb(Coulomb {
                friction,
                static_friction,
            }) => (friction, static_friction),
            _ => unreachable!("only falls under dry friction are followed here"),
        }
    }

    fn slipping(&self, trial: &Trial) -> ReducedSliding<f64> {
        ReducedSliding::new(self.body(trial).parameters, self.frictions(trial).0)
    }

    fn contacts(&self, trial: &Trial) -> Contacts {
        let (body, _, contact_law) = &self.chunk.trials[trial.index];
        let Chunk {
            options, limits, ..
        } = self.chunk;
        Contacts::new(body, contact_law, options.gravity, limits.tolerance)
    }

    /// The next of the trials that begins by rolling; those that begin to slip wait elsewhere.
    fn next(
        &self,
        waiting: &mut impl Iterator<Item = usize>,
        to_slip: &mut Vec<ToSlip>,
    ) -> Option<Waiting> {
        while to_slip.len() < LANES {
            let index = waiting.next()?;
            let at = Coordinates::from_state(&self.chunk.trials[index].1);
            let (body, limits) = (self.chunk.body(index), &self.chunk.limits);
            if !limits.are_far_from(&at, &body.topple) {
                continue;
            }
            let trial = Trial::new(index, &at, false);
            let contacts = self.contacts(&trial);
            match self.going_on(trial, contacts.settle(&at), &at) {
                Some(PhaseStart::ReducedNoSlip(waiting)) => return Some(waiting),
                Some(PhaseStart::ReducedSliding(waiting)) => to_slip.push(waiting),
                None => {}
            }
        }
        None
    }

    /// How a fall goes on; none where that is rare.
    fn going_on(
        &self,
        mut trial: Trial,
        next: Transition,
        at: &Coordinates<f64>,
    ) -> Option<PhaseStart> {
        match next {
            Transition::Roll => {
                let h = self.body(&trial).error_scale.first_step(at);
                let at = *at;
                Some(PhaseStart::ReducedNoSlip(Waiting { trial, at, h }))
            }
            Transition::BeginToSlip(direction) => {
                let friction_loss = trial.friction_loss;
                let at = Coordinates {
                    friction_loss,
                    ..*at
                };
                let h = self.onset * self.body(&trial).error_scale.first_step(&at);
                let slipping = self.slipping(&trial);
                let beginning = OnsetStart::from_rest(&at, direction, slipping, h);
                trial.slid = true;
                Some(PhaseStart::ReducedSliding(ToSlip {
                    trial,
                    beginning,
                    result: None,
                }))
            }
            Transition::Slide | Transition::Fly | Transition::Paradox => None,
        }
    }

    /// The direction (unit vector) against the friction that holds a rolling rim: that in which it begins
    /// to slip, but for what it takes more to let go than to slip.
    fn against_friction(&self, trial: &Trial, at: &Coordinates<f64>) -> [f64; 2] {
        let needed = NoSlip::new(self.body(trial).parameters).contact(at);
        let size = (needed.along * needed.along + needed.across * needed.across).sqrt();
        if size > 0.0 {
            [-needed.along / size, -needed.across / size]
        } else {
            [1.0, 0.0]
        }
    }

    /// Makes a step in the slips of up to sixteen falls that begin.
    fn begin_to_slip(&self, to_slip: &mut Vec<ToSlip>, slipped: &mut Vec<Waiting>) {
        let first = to_slip.len().saturating_sub(LANES);
        let Some(last) = to_slip[first..].last() else {
            return;
        };
        // A lane without a fall of its own repeats the last.
        let beginnings =
            core::array::from_fn(|lane| to_slip.get(first + lane).unwrap_or(last).beginning);
        let limits = &self.chunk.limits;
        let result = begin(&beginnings, limits.tolerance);
        for (i, result) in result.take(to_slip.len() - first).enumerate() {
            to_slip[first + i].result = Some(result);
        }
        for i in (first..to_slip.len()).rev() {
            match to_slip[i].result.take() {
                Some(OnsetResult::Again(beginning)) => to_slip[i].beginning = beginning,
                Some(OnsetResult::Follow(at, h)) => {
                    let ToSlip { trial, .. } = to_slip.swap_remove(i);
                    // What happens while it begins to slip is left to be found elsewhere.
                    let lasts = self
                        .slipping(&trial)
                        .contact_margin(&ReducedSliding::project(&at))
                        > 0.0;
                    let is_on_its_way = trial.direction * at.p > 0.0;
                    let topple = &self.body(&trial).topple;
                    if lasts && is_on_its_way && limits.are_far_from(&at, topple) {
                        slipped.push(Waiting { trial, at, h });
                    }
                }
                Some(OnsetResult::Lost) | None => drop(to_slip.swap_remove(i)),
            }
        }
    }

    fn after_rolling(
        &mut self,
        trial: Trial,
        exit: Exit,
        at: &Coordinates<f64>,
    ) -> Option<PhaseStart> {
        match exit {
            Exit::Over(status) => {
                let friction_loss = trial.friction_loss;
                let at = Coordinates {
                    friction_loss,
                    ..*at
                };
                self.done[trial.index] =
                    Some(trial.fall(&self.body(&trial).parameters, status, &at));
                None
            }
            Exit::ContactEnds => {
                let against = self.against_friction(&trial, at);
                self.going_on(trial, Transition::BeginToSlip(against), at)
            }
            Exit::SlipEnds | Exit::NeedsScalar => None,
        }
    }

    fn after_slipping(
        &mut self,
        mut trial: Trial,
        exit: Exit,
        at: &Coordinates<f64>,
    ) -> Option<PhaseStart> {
        match exit {
            Exit::Over(status) => {
                self.done[trial.index] =
                    Some(trial.fall(&self.body(&trial).parameters, status, at));
                None
            }
            Exit::SlipEnds => {
                let contacts = self.contacts(&trial);
                let stopped = stopped(&contacts, at, self.chunk.limits.tolerance);
                trial.friction_loss = stopped.friction_loss;
                let rolling = Coordinates {
                    friction_loss: 0.0,
                    ..stopped
                };
                self.going_on(trial, contacts.settle(&rolling), &rolling)
            }
            Exit::ContactEnds | Exit::NeedsScalar => None,
        }
    }
}

/// How long the step of an onset may be at a tolerance, in first steps: its error grows with the seventh
/// power.
fn onset_length(tolerance: f64) -> f64 {
    45.0 * libm::pow(tolerance / 2e-10, 1.0 / 7.0)
}

#[cfg(test)]
mod tests {
    use super::super::chunk::Chunk;
    use super::Dry;
    use crate::law::FrictionLaw;
    use crate::motion::Options;
    use crate::presets;
    use crate::state::State;

    #[test]
    fn a_can_on_a_table_is_never_rare() {
        let can = presets::can_2007().expect("the paper's can");
        // Spread evenly over all decades by multiples of irrational numbers.
        let part = |i: usize, by: f64| (i as f64 * by).fract();
        let trials: Vec<_> = (1..5000)
            .map(|i| {
                let start = State {
                    tilt: 0.3 + 0.3 * part(i, 0.754_877_666),
                    tilt_rate: -part(i, 0.569_840_291),
                    yaw_rate: libm::pow(10.0, -5.0 + 4.0 * part(i, 0.618_033_989)),
                    spin_rate: libm::pow(10.0, -5.0 + 4.0 * part(i, 0.414_213_562)),
                    ..State::default()
                };
                (&can, start, FrictionLaw::coulomb(0.2).into())
            })
            .collect();
        for rtol in [1e-6, 1e-9] {
            let options = Options {
                rtol,
                ..Options::default()
            };
            let chunk = Chunk::new(&trials, &options);
            let mut done = vec![None; trials.len()];
            Dry::new(&chunk, &mut done).follow(0..trials.len());
            let left = done.iter().filter(|fall| fall.is_none()).count();
            assert_eq!(left, 0, "at {rtol}");
        }
    }
}
