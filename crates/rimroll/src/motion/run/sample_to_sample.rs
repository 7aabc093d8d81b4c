//! The steps of a run from one sample of the table's record to the next.

use super::{AfterEvent, PhaseStart, Run, StepSize};
use crate::ground::Record;
use crate::law::FrictionLaw;
use crate::motion::contacts::Contacts;
use crate::motion::event_detector::Goal;
use crate::motion::instant::{Instant, Phase};
use crate::motion::options::Options;
use crate::motion::phase_system::IndependentVariable;
use crate::motion::sample_to_sample::{
    Order, Reduced, Rolling, SampleInterval, StepEnd, advanced, reduce,
};
use crate::motion::step_record::StepRecord;
use crate::state::Coordinates;

/// What the steps from sample to sample of a run need.
pub(super) struct SampleSteps {
    rolling: Rolling<f64>,
    record: Record,
    /// The number of samples to pass before such steps are tried again.
    pause: usize,
    /// How often in succession no such step has succeeded.
    failures: u32,
    /// The level of the last steps.
    level: u32,
}

/// A rolling rim that steps from sample to sample of a record: by one step of order 5 or, where that is not accurate enough,
/// by steps of order 8 whose size is that between two samples divided by a power of two.
pub(in crate::motion) struct SampleStep {
    pub rolling: Rolling<f64>,
    pub at: StepEnd<f64>,
    /// The sign of the tilt rate.
    pub direction: f64,
    record: Record,
    /// The index of the last sample, and that of the last one to which steps go.
    index: usize,
    last: usize,
    /// 0 for a step of order 5; above that, 2^(level − 1) steps of order 8 as long as the next one fit between two samples.
    level: u32,
    /// The time since the last sample, in such steps.
    part: u32,
    /// The number of samples passed at level 1 in succession.
    passed: u32,
    /// The number of steps made, and that after which the usual stepper takes over in any case.
    steps: usize,
    max_steps: usize,
    /// The number of evaluations of the rates.
    evaluations: usize,
    /// The number of steps that were not accepted.
    rejected: usize,
    /// The coordinates before the first step.
    before: Coordinates<f64>,
}

/// The largest level.
const MAX_LEVEL: u32 = 9;

/// The square of the error of a step twice as long is at most this many times larger.
const EXCESS: f64 = 1e6;

impl SampleStep {
    /// The next step.
    #[inline]
    pub(in crate::motion) fn between(&self) -> SampleInterval<f64> {
        let samples = self.record.samples();
        let (from, to) = (samples[self.index], samples[self.index + 1]);
        let h = self.record.time(self.index + 1) - self.record.time(self.index);
        let parts = self.parts();
        if parts == 1 {
            return SampleInterval { from, to, h };
        }
        let width = 1.0 / f64::from(parts);
        let at = |part: u32| {
            let x = width * f64::from(part);
            core::array::from_fn(|i| from[i] + x * (to[i] - from[i]))
        };
        SampleInterval {
            from: at(self.part),
            to: at(self.part + 1),
            h: width * h,
        }
    }

    /// The method of the next step.
    #[inline]
    pub(in crate::motion) fn order(&self) -> Order {
        if self.level == 0 {
            Order::Five
        } else {
            Order::Eight
        }
    }

    /// The number of steps between two samples.
    #[inline]
    fn parts(&self) -> u32 {
        1 << self.level.saturating_sub(1)
    }

    /// Accepts a step with this square of its error, relative to the tolerance. Whether another step may follow.
    #[inline]
    pub(in crate::motion) fn accept(&mut self, error_squared: f64) -> bool {
        // The number of samples after which order 5 is tried again.
        const PATIENCE: u32 = 8;
        self.steps += 1;
        self.evaluations += self.cost();
        self.part += 1;
        if self.part == self.parts() {
            self.part = 0;
            self.index += 1;
            self.passed += u32::from(self.level == 1);
        }
        let coarser = match self.level {
            0 => false,
            1 => self.passed >= PATIENCE,
            _ => self.part.is_multiple_of(2) && EXCESS * error_squared < 1.0,
        };
        if coarser {
            self.level -= 1;
            self.part /= 2;
            self.passed = 0;
        }
        self.index < self.last && self.steps < self.max_steps
    }

    /// Whether the tilt rate changes its sign in a step that ends at `end`.
    #[inline]
    fn reverses(&self, end: &StepEnd<f64>) -> bool {
        self.direction * end.u[2] < 0.0
    }

    /// An upper bound of the tilt in a step, rad.
    fn largest_tilt(&self, between: &SampleInterval<f64>, end: &StepEnd<f64>) -> f64 {
        let beyond = |u: &Reduced<f64>| libm::atan2(u[0], u[1]) + u[2].abs() * between.h / 3.0;
        beyond(&self.at.u).max(beyond(&end.u))
    }

    /// The number of evaluations of a step.
    fn cost(&self) -> usize {
        if self.level == 0 { 6 } else { 12 }
    }

    /// Counts a step that is not accepted.
    pub(in crate::motion) fn reject(&mut self) {
        self.rejected += 1;
        self.evaluations += self.cost();
    }

    /// Refines the step, whose error is too large. Whether it is worth another attempt.
    pub(in crate::motion) fn refine(&mut self) -> bool {
        if self.level > 0 {
            self.part *= 2;
        }
        self.level += 1;
        self.passed = 0;
        self.level <= MAX_LEVEL
    }

    /// The time, s.
    fn time(&self) -> f64 {
        let from = self.record.time(self.index);
        if self.part == 0 {
            return from;
        }
        let part = f64::from(self.part) / f64::from(self.parts());
        from + part * (self.record.time(self.index + 1) - from)
    }

    /// All coordinates.
    fn coordinates(&self) -> Coordinates<f64> {
        self.coordinates_with(&self.at.u, self.time())
    }

    /// All coordinates at another time, s.
    fn coordinates_with(&self, u: &Reduced<f64>, t: f64) -> Coordinates<f64> {
        advanced(&self.before, u, t)
    }
}

impl SampleSteps {
    /// `None` where such steps cannot follow the motion.
    pub(super) fn new(contacts: &Contacts, options: &Options) -> Option<Self> {
        let law = contacts.contact_law();
        let rolls = law.friction == FrictionLaw::NoSlip || contacts.is_dry();
        let record = contacts.ground()?.record_alone()?;
        let fits = rolls && !law.resists();
        fits.then(|| SampleSteps {
            rolling: Rolling::new(contacts, options),
            record: record.clone(),
            pause: 0,
            failures: 0,
            level: 0,
        })
    }
}

impl Run<'_> {
    /// The motion at a sample from which steps to further samples can be tried.
    pub(super) fn on_samples(&mut self, phase: Phase, u: &Coordinates<f64>) -> Option<SampleStep> {
        // The range of angles in which sine and cosine are accurate.
        const MAX_YAW: f64 = 9e5;
        let direction = self.detector.direction();
        let max_steps = self.options.max_steps.saturating_sub(self.work.steps);
        let max_steps = max_steps.min(self.steps_until_report());
        let steps = self.sample_steps.as_mut()?;
        if phase != Phase::Rolling || direction == 0.0 {
            return None;
        }
        if steps.pause > 0 {
            steps.pause -= 1;
            return None;
        }
        let index = steps.record.index_of(u.t)?;
        let goal = match self.detector.goal() {
            Goal::Time(end) | Goal::End(end) => end,
            Goal::Turn(_) | Goal::Passed(_) => return None,
        };
        // The motion and the record end in later steps.
        let samples = steps.record.samples();
        let last = steps.record.steps_until(goal).min(samples.len() - 1);
        let fits = index < last && max_steps > 0 && u.yaw.abs() < MAX_YAW;
        fits.then(|| SampleStep {
            at: steps.rolling.at(&reduce(u), samples[index]),
            rolling: steps.rolling,
            direction,
            record: steps.record.clone(),
            index,
            last,
            level: steps.level,
            part: 0,
            passed: 0,
            steps: 0,
            evaluations: 1,
            rejected: 0,
            max_steps,
            before: *u,
        })
    }

    /// Steps from sample to sample as long as possible.
    pub(in crate::motion) fn step_alone(&mut self, mut sample: SampleStep) {
        let mut u = sample.before;
        loop {
            let between = sample.between();
            let attempt = sample.rolling.attempt_alone(
                sample.order(),
                &sample.at,
                &between,
                sample.direction,
            );
            if !attempt.is_accepted() {
                sample.reject();
                if !attempt.estimate.is_accepted() && sample.refine() {
                    continue;
                }
                break;
            }
            if sample.reverses(&attempt.end) {
                self.pass_extremum(&mut sample, &between, &attempt.end);
            }
            sample.at = attempt.end;
            let continues = sample.accept(attempt.estimate.relative_squared());
            if self.detector.goal().needs_trajectory() {
                let end = sample.coordinates();
                self.trajectory
                    .push(StepRecord::in_time(Phase::Rolling, between.h, &u, &end));
                u = end;
            }
            if !continues {
                break;
            }
        }
        self.leave_samples(&sample);
    }

    /// Adds the extremum of the tilt in a step that ends at `end`.
    pub(in crate::motion) fn pass_extremum(
        &mut self,
        sample: &mut SampleStep,
        between: &SampleInterval<f64>,
        end: &StepEnd<f64>,
    ) {
        let is_maximum = sample.direction > 0.0;
        sample.direction = -sample.direction;
        let is_wanted = self.detector.goal().needs_trajectory()
            || is_maximum && sample.largest_tilt(between, end) > self.detector.largest_maximum();
        let extremum = is_wanted.then(|| {
            let (order, at) = (sample.order(), &sample.at);
            let (x, u) = sample.rolling.extremum(order, at, between, end);
            let u = sample.coordinates_with(&u, sample.time() + x * between.h);
            let phase = Phase::Rolling;
            Instant { phase, u }
        });
        self.detector.reverse(sample.direction, extremum);
    }

    /// Continues with the usual steps from where the steps from sample to sample have ended.
    pub(in crate::motion) fn leave_samples(&mut self, sample: &SampleStep) {
        let (phase, made) = (Phase::Rolling, sample.steps);
        // Without a step not even rounding changes the coordinates.
        let u = if made > 0 {
            sample.coordinates()
        } else {
            sample.before
        };
        if made > 0 && !self.detector.goal().needs_trajectory() {
            self.trajectory.push_jump(Instant { phase, u });
        }
        self.work.steps += made;
        self.work.evaluations += sample.evaluations;
        self.work.rejected += sample.rejected;
        self.steps_at_stiffness_test += made;
        if let Some(steps) = &mut self.sample_steps {
            steps.level = sample.level.min(MAX_LEVEL);
            if made > 0 {
                (steps.pause, steps.failures) = (0, 0);
            } else {
                const MAX_DOUBLINGS: u32 = 5;
                steps.pause = (1 << steps.failures) - 1;
                steps.failures = (steps.failures + 1).min(MAX_DOUBLINGS);
            }
        }
        if made > 0 {
            self.empty_phases = 0;
        }
        let h = sample.record.step();
        let variable = IndependentVariable::Time;
        let start = PhaseStart { u, direction: None };
        self.next = AfterEvent::Steps(phase, start, StepSize { variable, h });
    }
}
