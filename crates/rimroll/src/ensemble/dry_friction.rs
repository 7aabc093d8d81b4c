//! Falls under dry friction. One pool holds the falls that roll and another those that slide; a fall changes
//! between them at the transitions of its contact.

use super::chunk::{ActiveFall, BodyNumbers, Chunk};
use super::pool::{Exit, Pool};
use super::reduced_system::{ReducedNoSlip, ReducedSliding, ReducedSystem};
use super::slip_onset::{OnsetResult, OnsetStart, step_batch};
use crate::law::{Coulomb, Dynamics, FrictionLaw, NoSlip};
use crate::motion::{Contacts, Fall, Transition, stopped};
use crate::real::LANES;
use crate::state::Coordinates;

type RollingPool<'a> = Pool<'a, ReducedNoSlip<f64, true>, 7>;
type SlippingPool<'a> = Pool<'a, ReducedSliding<f64>, 10>;

/// A fall that waits for a lane, with the size of its first step.
struct Waiting {
    fall: ActiveFall,
    at: Coordinates<f64>,
    h: f64,
}

/// A fall at the onset of slip.
struct ToSlip {
    fall: ActiveFall,
    start: OnsetStart,
    result: Option<OnsetResult>,
}

/// The start of the next phase.
#[expect(clippy::large_enum_variant, reason = "it is matched at once")]
enum PhaseStart {
    Rolling(Waiting),
    Slipping(ToSlip),
}

pub(super) struct Dry<'a> {
    chunk: &'a Chunk<'a>,
    /// The size of the first step of an onset, relative to the first step of a phase.
    onset: f64,
    done: &'a mut [Option<Fall>],
}

impl<'a> Dry<'a> {
    pub(super) fn new(chunk: &'a Chunk<'a>, done: &'a mut [Option<Fall>]) -> Self {
        Dry {
            chunk,
            onset: onset_length(chunk.bounds.tolerance),
            done,
        }
    }

    /// Computes the falls of some setups. Those that need the scalar solver keep the result `None`.
    pub(super) fn follow(&mut self, waiting: impl Iterator<Item = usize>) {
        let mut waiting = waiting.peekable();
        let Some(&first) = waiting.peek() else { return };
        let (body, bounds) = (self.chunk.body(first), &self.chunk.bounds);
        let mut rolling = RollingPool::new(body, bounds);
        let mut slipping = SlippingPool::new(body, bounds);
        let mut to_roll: Vec<Waiting> = Vec::with_capacity(2 * LANES);
        let mut to_slip: Vec<ToSlip> = Vec::with_capacity(2 * LANES);
        let mut past_onset: Vec<Waiting> = Vec::with_capacity(2 * LANES);
        loop {
            while rolling.len() < LANES {
                let next = to_roll
                    .pop()
                    .or_else(|| self.next(&mut waiting, &mut to_slip));
                let Some(Waiting { fall, at, h }) = next else {
                    break;
                };
                let (_, static_friction) = self.frictions(&fall);
                let body = self.body(&fall);
                rolling.put(fall, &at, (body, static_friction), h);
            }
            while slipping.len() < LANES {
                if past_onset.is_empty() && (to_slip.len() >= LANES || rolling.len() == 0) {
                    self.step_onsets(&mut to_slip, &mut past_onset);
                }
                let Some(Waiting { fall, at, h }) = past_onset.pop() else {
                    break;
                };
                let (friction, _) = self.frictions(&fall);
                let body = self.body(&fall);
                slipping.put(fall, &at, (body, friction), h);
            }
            if rolling.len() + slipping.len() + to_slip.len() == 0 {
                if waiting.peek().is_some() {
                    // Every fall that waited for its onset needs the scalar solver.
                    continue;
                }
                return;
            }
            let most_roll = rolling.len() == LANES || rolling.len() > slipping.len();
            let step_rolling = slipping.len() < LANES && most_roll;
            let mut enqueue = |start| match start {
                PhaseStart::Rolling(waiting) => to_roll.push(waiting),
                PhaseStart::Slipping(waiting) => to_slip.push(waiting),
            };
            // Stepping the fuller pool keeps few lanes empty: the falls that slide wait until there are sixteen
            // of them or until fewer falls roll.
            if step_rolling {
                rolling.step(|fall, exit, at| {
                    self.after_rolling(fall, exit, at).map(&mut enqueue);
                });
            } else {
                slipping.step(|fall, exit, at| {
                    self.after_slipping(fall, exit, at).map(&mut enqueue);
                });
            }
        }
    }

    fn body(&self, fall: &ActiveFall) -> &'a BodyNumbers {
        self.chunk.body(fall.index)
    }

    /// The coefficients of kinetic and static friction.
    fn frictions(&self, fall: &ActiveFall) -> (f64, f64) {
        match self.chunk.setups[fall.index].2.friction {
            FrictionLaw::Coulomb(Coulomb {
                friction,
                static_friction,
            }) => (friction, static_friction),
            _ => unreachable!("all these falls are under dry friction"),
        }
    }

    fn slipping(&self, fall: &ActiveFall) -> ReducedSliding<f64> {
        ReducedSliding::new(self.body(fall).parameters, self.frictions(fall).0)
    }

    fn contacts(&self, fall: &ActiveFall) -> Contacts {
        let (body, _, contact_law) = &self.chunk.setups[fall.index];
        let Chunk {
            options, bounds, ..
        } = self.chunk;
        Contacts::new(body, contact_law, options.gravity, bounds.tolerance)
    }

    /// The next fall that starts with rolling. Falls that start with slip are added to `to_slip`.
    fn next(
        &self,
        waiting: &mut impl Iterator<Item = usize>,
        to_slip: &mut Vec<ToSlip>,
    ) -> Option<Waiting> {
        while to_slip.len() < LANES {
            let index = waiting.next()?;
            let at = Coordinates::from_state(&self.chunk.setups[index].1);
            let (body, bounds) = (self.chunk.body(index), &self.chunk.bounds);
            if !bounds.are_far_from(&at, &body.topple) {
                continue;
            }
            let fall = ActiveFall::new(index, &at, false);
            let contacts = self.contacts(&fall);
            match self.phase_after(fall, contacts.settle(&at), &at) {
                Some(PhaseStart::Rolling(waiting)) => return Some(waiting),
                Some(PhaseStart::Slipping(waiting)) => to_slip.push(waiting),
                None => {}
            }
        }
        None
    }

    /// The start of the phase after a transition; `None` if the fall needs the scalar solver.
    fn phase_after(
        &self,
        mut fall: ActiveFall,
        next: Transition,
        at: &Coordinates<f64>,
    ) -> Option<PhaseStart> {
        match next {
            Transition::Roll => {
                let h = self.body(&fall).error_scale.first_step(at);
                let at = *at;
                Some(PhaseStart::Rolling(Waiting { fall, at, h }))
            }
            Transition::BeginToSlip(direction) => {
                let friction_loss = fall.friction_loss;
                let at = Coordinates {
                    friction_loss,
                    ..*at
                };
                let h = self.onset * self.body(&fall).error_scale.first_step(&at);
                let slipping = self.slipping(&fall);
                let start = OnsetStart::from_rest(&at, direction, slipping, h);
                fall.slid = true;
                Some(PhaseStart::Slipping(ToSlip {
                    fall,
                    start,
                    result: None,
                }))
            }
            Transition::Slide | Transition::Fly | Transition::Paradox => None,
        }
    }

    /// The direction (unit vector) opposite to the static friction on a rolling rim. The slip starts in this
    /// direction, apart from the effect of the drop from static to kinetic friction.
    fn against_friction(&self, fall: &ActiveFall, at: &Coordinates<f64>) -> [f64; 2] {
        let needed = NoSlip::new(self.body(fall).parameters).contact(at);
        let size = (needed.along * needed.along + needed.across * needed.across).sqrt();
        if size > 0.0 {
            [-needed.along / size, -needed.across / size]
        } else {
            [1.0, 0.0]
        }
    }

    /// Makes a step in the onsets of up to sixteen falls.
    fn step_onsets(&self, to_slip: &mut Vec<ToSlip>, past_onset: &mut Vec<Waiting>) {
        let first = to_slip.len().saturating_sub(LANES);
        let Some(last) = to_slip[first..].last() else {
            return;
        };
        // Unused lanes repeat the last onset.
        let starts = core::array::from_fn(|lane| to_slip.get(first + lane).unwrap_or(last).start);
        let bounds = &self.chunk.bounds;
        let results = step_batch(&starts, bounds.tolerance);
        for (i, result) in results.take(to_slip.len() - first).enumerate() {
            to_slip[first + i].result = Some(result);
        }
        for i in (first..to_slip.len()).rev() {
            match to_slip[i].result.take() {
                Some(OnsetResult::Again(start)) => to_slip[i].start = start,
                Some(OnsetResult::Follow(at, h)) => {
                    let ToSlip { fall, .. } = to_slip.swap_remove(i);
                    // If an event happened during the onset, the scalar solver locates it.
                    let keeps_contact = self
                        .slipping(&fall)
                        .contact_margin(&ReducedSliding::project(&at))
                        > 0.0;
                    let keeps_direction = fall.direction * at.p > 0.0;
                    let topple = &self.body(&fall).topple;
                    if keeps_contact && keeps_direction && bounds.are_far_from(&at, topple) {
                        past_onset.push(Waiting { fall, at, h });
                    }
                }
                Some(OnsetResult::Lost) | None => drop(to_slip.swap_remove(i)),
            }
        }
    }

    fn after_rolling(
        &mut self,
        fall: ActiveFall,
        exit: Exit,
        at: &Coordinates<f64>,
    ) -> Option<PhaseStart> {
        match exit {
            Exit::Over(status) => {
                let friction_loss = fall.friction_loss;
                let at = Coordinates {
                    friction_loss,
                    ..*at
                };
                self.done[fall.index] =
                    Some(fall.result(&self.body(&fall).parameters, status, &at));
                None
            }
            Exit::ContactEnds => {
                let direction = self.against_friction(&fall, at);
                self.phase_after(fall, Transition::BeginToSlip(direction), at)
            }
            Exit::SlipEnds | Exit::NeedsScalar => None,
        }
    }

    fn after_slipping(
        &mut self,
        mut fall: ActiveFall,
        exit: Exit,
        at: &Coordinates<f64>,
    ) -> Option<PhaseStart> {
        match exit {
            Exit::Over(status) => {
                self.done[fall.index] = Some(fall.result(&self.body(&fall).parameters, status, at));
                None
            }
            Exit::SlipEnds => {
                let contacts = self.contacts(&fall);
                let stopped = stopped(&contacts, at, self.chunk.bounds.tolerance);
                fall.friction_loss = stopped.friction_loss;
                let rolling = Coordinates {
                    friction_loss: 0.0,
                    ..stopped
                };
                self.phase_after(fall, contacts.settle(&rolling), &rolling)
            }
            Exit::ContactEnds | Exit::NeedsScalar => None,
        }
    }
}

/// The size of the first step of an onset at a tolerance, relative to the first step of a phase. The error of
/// the step is proportional to the seventh power of its size.
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
    fn a_can_on_a_table_never_needs_the_scalar_solver() {
        let can = presets::can_2007().expect("the paper's can");
        // Multiples of irrational numbers spread the starts evenly over all decades.
        let part = |i: usize, by: f64| (i as f64 * by).fract();
        let setups: Vec<_> = (1..5000)
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
            let chunk = Chunk::new(&setups, &options);
            let mut done = vec![None; setups.len()];
            Dry::new(&chunk, &mut done).follow(0..setups.len());
            let left = done.iter().filter(|fall| fall.is_none()).count();
            assert_eq!(left, 0, "rtol {rtol}");
        }
    }
}
