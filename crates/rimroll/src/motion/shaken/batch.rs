//! The outcomes of many motions on tables that move. Where steps go from sample to sample of a record, they are made for
//! sixteen motions at once.
//!
//! Each lane holds a run, which does everything else: other steps, events, standing, sliding, flights. A lane goes
//! through the same operations as a run alone, so that all outcomes have the same bits as those of
//! [`shaken`](super::shaken). Steps of order 5 and of order 8 are made in lanes of their own. Twice as many motions as
//! lanes are followed, so that one of the two is full.

use super::{PreparedMotion, Shaken};
use crate::ending::Status;
use crate::motion::run::{Followed, Run, SampleStep};
use crate::motion::sample_to_sample::Order;
use crate::motion::sample_to_sample::lanes::SamplesInLanes;
use crate::real::LANES;
use core::ops::ControlFlow;
use std::collections::VecDeque;

/// Up to this number of motions are stepped one by one, which is faster than in mostly empty lanes.
const FEW: usize = 2;

/// The number of motions that are followed at the same time, so that the lanes of one of the two orders are full.
const FOLLOWED: usize = 2 * LANES;

/// A motion that steps from sample to sample.
struct Stepping<'a> {
    index: usize,
    run: Run<'a>,
    sample: Box<SampleStep>,
}

/// The motions whose next step has the same order.
#[derive(Default)]
struct Batch<'a> {
    lanes: [Option<Box<Stepping<'a>>>; LANES],
    waiting: VecDeque<Box<Stepping<'a>>>,
    lockstep: Option<SamplesInLanes>,
}

/// The motions that are followed and those that have not begun.
struct Many<'a, 'w> {
    prepared: &'a [PreparedMotion],
    next: usize,
    followed: usize,
    of_order_5: Batch<'a>,
    of_order_8: Batch<'a>,
    outcomes: Vec<Option<Shaken>>,
    should_continue: &'w dyn Fn() -> bool,
    stopped: bool,
}

/// The outcomes in order. When `should_continue` is false, they end before the first motion that was not computed.
pub(crate) fn shaken_batch(
    prepared: &[PreparedMotion],
    should_continue: &dyn Fn() -> bool,
) -> Vec<Shaken> {
    let mut many = Many {
        prepared,
        next: 0,
        followed: 0,
        of_order_5: Batch::default(),
        of_order_8: Batch::default(),
        outcomes: vec![None; prepared.len()],
        should_continue,
        stopped: false,
    };
    many.compute();
    many.outcomes.into_iter().map_while(|done| done).collect()
}

impl<'a> Batch<'a> {
    /// Puts waiting motions into empty lanes. Returns the number of motions in lanes.
    fn fill(&mut self) -> usize {
        let mut count = 0;
        for (lane, place) in self.lanes.iter_mut().enumerate() {
            if place.is_none()
                && let Some(motion) = self.waiting.pop_front()
            {
                let sample = &motion.sample;
                match &mut self.lockstep {
                    Some(lockstep) => lockstep.put(lane, sample),
                    None => self.lockstep = Some(SamplesInLanes::filled_with(sample)),
                }
                *place = Some(motion);
            }
            count += usize::from(place.is_some());
        }
        count
    }

    /// Makes a step of each motion in a lane. Those that leave the steps of this order are added to `leaving`.
    fn step(&mut self, leaving: &mut Vec<(Box<Stepping<'a>>, Next)>) {
        let Some(lockstep) = &mut self.lockstep else {
            return;
        };
        let stepped = lockstep.step();
        for (lane, place) in self.lanes.iter_mut().enumerate() {
            let Some(motion) = place else {
                continue;
            };
            let Stepping { run, sample, .. } = &mut **motion;
            let (order, estimate) = (sample.order(), lockstep.estimate(lane));
            let reverses = stepped.reverses >> lane & 1 == 1;
            if reverses {
                let end = lockstep.end(lane);
                sample.at = lockstep.at(lane);
                run.pass_extremum(sample, &sample.between(), &end);
                lockstep.turn_back(lane, &end, sample.direction);
            }
            let continues = if reverses || stepped.moved >> lane & 1 == 1 {
                sample.accept(estimate.relative_squared())
            } else {
                sample.reject();
                !estimate.is_accepted() && sample.refine()
            };
            if continues && sample.order() == order {
                lockstep.aim(lane, &sample.between());
                continue;
            }
            sample.at = lockstep.at(lane);
            let next = if continues {
                Next::OtherOrder
            } else {
                Next::UsualSteps
            };
            leaving.extend(place.take().map(|motion| (motion, next)));
        }
    }

    /// Empties the lanes.
    fn take_all(&mut self) -> Vec<Stepping<'a>> {
        let mut all: Vec<_> = self.waiting.drain(..).map(|motion| *motion).collect();
        for (lane, place) in self.lanes.iter_mut().enumerate() {
            if let (Some(mut motion), Some(lockstep)) = (place.take(), &self.lockstep) {
                motion.sample.at = lockstep.at(lane);
                all.push(*motion);
            }
        }
        all
    }
}

/// What follows the steps of one order.
#[derive(Clone, Copy)]
enum Next {
    OtherOrder,
    UsualSteps,
}

impl<'a> Many<'a, '_> {
    fn compute(&mut self) {
        let mut leaving = Vec::new();
        loop {
            while self.followed < FOLLOWED && self.next < self.prepared.len() && !self.stopped {
                let index = self.next;
                self.next += 1;
                self.followed += 1;
                self.follow(index, self.prepared[index].run());
            }
            if self.stopped {
                return;
            }
            if self.followed <= FEW {
                break;
            }
            if self.of_order_5.fill() >= self.of_order_8.fill() {
                self.of_order_5.step(&mut leaving);
            } else {
                self.of_order_8.step(&mut leaving);
            }
            for (motion, next) in leaving.drain(..) {
                match next {
                    Next::OtherOrder => self.wait(motion),
                    Next::UsualSteps => {
                        let Stepping {
                            index,
                            mut run,
                            sample,
                        } = *motion;
                        run.leave_samples(&sample);
                        self.follow(index, run);
                    }
                }
            }
        }
        let mut last = self.of_order_5.take_all();
        last.append(&mut self.of_order_8.take_all());
        for motion in last {
            self.finish_alone(motion);
        }
    }

    /// Lets a motion wait for a lane.
    fn wait(&mut self, motion: Box<Stepping<'a>>) {
        let batch = match motion.sample.order() {
            Order::Five => &mut self.of_order_5,
            Order::Eight => &mut self.of_order_8,
        };
        batch.waiting.push_back(motion);
    }

    /// Follows a motion until it ends or can step from sample to sample.
    fn follow(&mut self, index: usize, mut run: Run<'a>) {
        match run.follow(&mut |_| self.watch()) {
            Followed::ToSample(sample) => self.wait(Box::new(Stepping { index, run, sample })),
            Followed::Ended(status) => self.end(index, run, status),
        }
    }

    fn finish_alone(&mut self, motion: Stepping<'a>) {
        let Stepping {
            index,
            mut run,
            sample,
        } = motion;
        run.step_alone(*sample);
        let status = run.follow_to_the_end(&mut |_| self.watch());
        self.end(index, run, status);
    }

    /// Keeps the outcome of a run that has ended.
    fn end(&mut self, index: usize, run: Run<'a>, status: Status) {
        self.followed -= 1;
        if !self.stopped {
            self.outcomes[index] = Some(self.prepared[index].outcome(run, status));
        }
    }

    fn watch(&mut self) -> ControlFlow<()> {
        self.stopped = self.stopped || !(self.should_continue)();
        if self.stopped {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    }
}
