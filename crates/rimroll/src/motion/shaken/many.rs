//! The outcomes of many motions on tables that move. Where steps go from sample to sample of a record, they are made for
//! sixteen motions at once.
//!
//! Each lane holds a run, which does everything else: other steps, events, standing, sliding, flights. A lane goes
//! through the same operations as a run alone, so that all outcomes have the same bits as those of
//! [`shaken`](super::shaken).

use super::{Begun, Shaken};
use crate::motion::run::{Followed, OnSamples, Run};
use crate::motion::samples::lanes::SamplesInLanes;
use crate::motion::samples::{At, Order};
use crate::real::LANES;
use core::ops::ControlFlow;

/// Up to this number of motions are stepped one by one, which is faster than in mostly empty lanes.
const FEW: usize = 2;

/// A motion that steps from sample to sample.
struct InLane<'a> {
    index: usize,
    run: Run<'a>,
    sample: Box<OnSamples>,
}

/// The motions in the lanes and those that wait for one.
struct Many<'a, 'w> {
    begun: &'a [Begun],
    next: usize,
    lanes: [Option<InLane<'a>>; LANES],
    outcomes: Vec<Option<Shaken>>,
    should_continue: &'w dyn Fn() -> bool,
    stopped: bool,
}

/// The outcomes in order. When `should_continue` is false, they end before the first motion that was not computed.
pub(crate) fn many_shaken(begun: &[Begun], should_continue: &dyn Fn() -> bool) -> Vec<Shaken> {
    let mut many = Many {
        begun,
        next: 0,
        lanes: [const { None }; LANES],
        outcomes: vec![None; begun.len()],
        should_continue,
        stopped: false,
    };
    many.compute();
    many.outcomes.into_iter().map_while(|done| done).collect()
}

impl<'a> Many<'a, '_> {
    fn compute(&mut self) {
        for lane in 0..LANES {
            self.refill(lane);
        }
        let first = self.lanes.iter().flatten().next();
        let Some(mut lockstep) = first.map(|first| SamplesInLanes::filled_with(&first.sample))
        else {
            return;
        };
        for (lane, motion) in self.lanes.iter().enumerate() {
            if let Some(motion) = motion {
                lockstep.put(lane, &motion.sample);
            }
        }
        while !self.stopped && self.lanes.iter().flatten().count() > FEW {
            self.step(&mut lockstep);
        }
        if self.stopped {
            return;
        }
        for lane in 0..LANES {
            if let Some(motion) = self.lanes[lane].take() {
                self.finish_alone(motion, lockstep.at(lane));
            }
        }
    }

    /// Makes a step of each motion in the lanes whose next step has the more frequent order.
    fn step(&mut self, lockstep: &mut SamplesInLanes) {
        let count = |order| {
            let orders = self
                .lanes
                .iter()
                .flatten()
                .map(|motion| motion.sample.order());
            orders.filter(|&one| one == order).count()
        };
        let order = if count(Order::Eight) > count(Order::Five) {
            Order::Eight
        } else {
            Order::Five
        };
        let moved = lockstep.step(order);
        for lane in 0..LANES {
            let Some(motion) = &mut self.lanes[lane] else {
                continue;
            };
            if motion.sample.order() != order {
                continue;
            }
            let estimate = lockstep.estimate(lane);
            let goes_on = if moved >> lane & 1 == 1 {
                motion.sample.accept(estimate.relative_squared())
            } else {
                motion.sample.reject();
                !estimate.is_accepted() && motion.sample.refine()
            };
            if goes_on {
                lockstep.aim(lane, motion.sample.order(), &motion.sample.between());
                continue;
            }
            let Some(mut motion) = self.lanes[lane].take() else {
                continue;
            };
            motion.sample.at = lockstep.at(lane);
            motion.run.leave_samples(&motion.sample);
            self.lanes[lane] = self.follow(motion.index, motion.run);
            if self.lanes[lane].is_none() {
                self.refill(lane);
            }
            if let Some(motion) = &self.lanes[lane] {
                lockstep.put(lane, &motion.sample);
            }
        }
    }

    /// Puts the next motion that steps from sample to sample into an empty lane.
    fn refill(&mut self, lane: usize) {
        while self.lanes[lane].is_none() && !self.stopped && self.next < self.begun.len() {
            let index = self.next;
            self.next += 1;
            self.lanes[lane] = self.follow(index, self.begun[index].run());
        }
    }

    /// Follows a motion until it can step from sample to sample; `None` if it ends before.
    fn follow(&mut self, index: usize, mut run: Run<'a>) -> Option<InLane<'a>> {
        let followed = run.follow(&mut |_| self.watch());
        match followed {
            Followed::ToSample(sample) => Some(InLane { index, run, sample }),
            Followed::Ended(status) => {
                if !self.stopped {
                    self.outcomes[index] = Some(self.begun[index].outcome(run, status));
                }
                None
            }
        }
    }

    fn finish_alone(&mut self, mut motion: InLane<'a>, at: At<f64>) {
        motion.sample.at = at;
        let InLane {
            index,
            mut run,
            sample,
        } = motion;
        run.step_alone(*sample);
        let status = run.follow_to_the_end(&mut |_| self.watch());
        if !self.stopped {
            self.outcomes[index] = Some(self.begun[index].outcome(run, status));
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
