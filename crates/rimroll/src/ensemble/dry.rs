//! Falls under dry friction: those that roll go together, and those that slide; a fall changes from the
//! one to the other and back.

use super::carried::{Carried, Rolling, Slipping};
use super::onset::{Beginning, Begun, begin};
use super::piece::{BodyNumbers, Piece};
use super::pool::{Exit, Pool};
use super::trial::Trial;
use crate::law::{Law, NoSlip};
use crate::motion::{Contacts, Fall, Next, stopped};
use crate::real::LANES;
use crate::state::Coordinates;
use crate::surface::FrictionLaw;

type RollingPool<'a> = Pool<'a, Rolling<f64, true>, 7>;
type SlippingPool<'a> = Pool<'a, Slipping<f64>, 10>;

/// A fall between two phases: where it is, and how long a step to try.
struct Waiting {
    trial: Trial,
    at: Coordinates<f64>,
    h: f64,
}

/// A fall whose slip is to begin.
struct ToSlip {
    trial: Trial,
    beginning: Beginning,
    begun: Option<Begun>,
}

/// How a phase is to begin.
#[expect(clippy::large_enum_variant, reason = "it is taken apart at once")]
enum Begins {
    Rolling(Waiting),
    Slipping(ToSlip),
}

pub(super) struct Dry<'a> {
    piece: &'a Piece<'a>,
    /// The length of a slip's first step, in first steps.
    onset: f64,
    done: &'a mut [Option<Fall>],
}

impl<'a> Dry<'a> {
    pub(super) fn new(piece: &'a Piece<'a>, done: &'a mut [Option<Fall>]) -> Self {
        Dry {
            piece,
            onset: onset_length(piece.limits.tolerance),
            done,
        }
    }

    /// Follows the falls from some of the trials; those that meet with what is rare are left undone.
    pub(super) fn follow(&mut self, waiting: impl Iterator<Item = usize>) {
        let mut waiting = waiting.peekable();
        let Some(&first) = waiting.peek() else { return };
        let (body, limits) = (self.piece.body(first), &self.piece.limits);
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
                Begins::Rolling(waiting) => to_roll.push(waiting),
                Begins::Slipping(waiting) => to_slip.push(waiting),
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
        self.piece.body(trial.index)
    }

    /// Coefficients of friction: of slipping and static.
    fn frictions(&self, trial: &Trial) -> (f64, f64) {
        match self.piece.trials[trial.index].2.friction {
            FrictionLaw::Coulomb {
                friction,
                static_friction,
            } => (friction, static_friction),
            _ => unreachable!("only falls under dry friction are followed here"),
        }
    }

    fn slipping(&self, trial: &Trial) -> Slipping<f64> {
        Slipping::new(self.body(trial).parameters, self.frictions(trial).0)
    }

    fn contacts(&self, trial: &Trial) -> Contacts {
        let (body, _, surface) = &self.piece.trials[trial.index];
        let Piece {
            options, limits, ..
        } = self.piece;
        Contacts::new(body, surface, options.gravity, limits.tolerance)
    }

    /// The next of the trials that begins by rolling; those that begin to slip wait elsewhere.
    fn next(
        &self,
        waiting: &mut impl Iterator<Item = usize>,
        to_slip: &mut Vec<ToSlip>,
    ) -> Option<Waiting> {
        while to_slip.len() < LANES {
            let index = waiting.next()?;
            let at = Coordinates::from_state(&self.piece.trials[index].1);
            let (body, limits) = (self.piece.body(index), &self.piece.limits);
            if !limits.are_far_from(&at, &body.topple) {
                continue;
            }
            let trial = Trial::new(index, &at, false);
            let contacts = self.contacts(&trial);
            match self.going_on(trial, contacts.settle(&at), &at) {
                Some(Begins::Rolling(waiting)) => return Some(waiting),
                Some(Begins::Slipping(waiting)) => to_slip.push(waiting),
                None => {}
            }
        }
        None
    }

    /// How a fall goes on; none where that is rare.
    fn going_on(&self, mut trial: Trial, next: Next, at: &Coordinates<f64>) -> Option<Begins> {
        match next {
            Next::Roll => {
                let h = self.body(&trial).yardstick.first_step(at);
                let at = *at;
                Some(Begins::Rolling(Waiting { trial, at, h }))
            }
            Next::BeginToSlip(direction) => {
                let friction_loss = trial.friction_loss;
                let at = Coordinates {
                    friction_loss,
                    ..*at
                };
                let h = self.onset * self.body(&trial).yardstick.first_step(&at);
                let slipping = self.slipping(&trial);
                let beginning = Beginning::from_rest(&at, direction, slipping, h);
                trial.slid = true;
                Some(Begins::Slipping(ToSlip {
                    trial,
                    beginning,
                    begun: None,
                }))
            }
            Next::Slide | Next::Fly | Next::Paradox => None,
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
        let limits = &self.piece.limits;
        let begun = begin(&beginnings, limits.tolerance);
        for (i, begun) in begun.take(to_slip.len() - first).enumerate() {
            to_slip[first + i].begun = Some(begun);
        }
        for i in (first..to_slip.len()).rev() {
            match to_slip[i].begun.take() {
                Some(Begun::Again(beginning)) => to_slip[i].beginning = beginning,
                Some(Begun::Follow(at, h)) => {
                    let ToSlip { trial, .. } = to_slip.swap_remove(i);
                    // What happens while it begins to slip is left to be found elsewhere.
                    let lasts = self.slipping(&trial).holds(&Slipping::of(&at)) > 0.0;
                    let is_on_its_way = trial.direction * at.p > 0.0;
                    let topple = &self.body(&trial).topple;
                    if lasts && is_on_its_way && limits.are_far_from(&at, topple) {
                        slipped.push(Waiting { trial, at, h });
                    }
                }
                Some(Begun::Lost) | None => drop(to_slip.swap_remove(i)),
            }
        }
    }

    fn after_rolling(&mut self, trial: Trial, exit: Exit, at: &Coordinates<f64>) -> Option<Begins> {
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
            Exit::GivesWay => {
                let against = self.against_friction(&trial, at);
                self.going_on(trial, Next::BeginToSlip(against), at)
            }
            Exit::Stops | Exit::Rare => None,
        }
    }

    fn after_slipping(
        &mut self,
        mut trial: Trial,
        exit: Exit,
        at: &Coordinates<f64>,
    ) -> Option<Begins> {
        match exit {
            Exit::Over(status) => {
                self.done[trial.index] =
                    Some(trial.fall(&self.body(&trial).parameters, status, at));
                None
            }
            Exit::Stops => {
                let contacts = self.contacts(&trial);
                let stopped = stopped(&contacts, at, self.piece.limits.tolerance);
                trial.friction_loss = stopped.friction_loss;
                let rolling = Coordinates {
                    friction_loss: 0.0,
                    ..stopped
                };
                self.going_on(trial, contacts.settle(&rolling), &rolling)
            }
            Exit::GivesWay | Exit::Rare => None,
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
    use super::super::piece::Piece;
    use super::Dry;
    use crate::motion::Options;
    use crate::presets;
    use crate::state::State;
    use crate::surface::FrictionLaw;

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
            let piece = Piece::new(&trials, &options);
            let mut done = vec![None; trials.len()];
            Dry::new(&piece, &mut done).follow(0..trials.len());
            let left = done.iter().filter(|fall| fall.is_none()).count();
            assert_eq!(left, 0, "at {rtol}");
        }
    }
}
