//! The trajectory: the accepted steps, which can be evaluated at any time.

use super::contacts::Contacts;
use super::instant::{Instant, Phase};
use super::step_record::{Polynomial, StepRecord};
use crate::solve::Dense;
use crate::state::{COORDINATES, Coordinates, TIME};
use core::ops::{Range, RangeInclusive};
use std::sync::Arc;

/// The accepted steps of a motion.
pub struct Trajectory {
    contacts: Arc<Contacts>,
    start: Instant,
    records: Vec<StepRecord>,
    /// Whether all records are kept, or only the last.
    whole: bool,
    /// Whether a step was refused because its end is not finite.
    broken: bool,
}

impl Trajectory {
    pub(super) fn new(contacts: &Arc<Contacts>, start: Instant, whole: bool) -> Self {
        Trajectory {
            contacts: Arc::clone(contacts),
            start,
            records: Vec::with_capacity(if whole { 256 } else { 1 }),
            whole,
            broken: false,
        }
    }

    /// Adds a step, unless its end is not finite: then the motion cannot go on.
    #[inline(always)]
    pub(super) fn push(&mut self, record: StepRecord) {
        if !Coordinates::from_array(&record.end).is_finite() {
            self.broken = true;
            return;
        }
        if !self.whole {
            self.records.clear();
        }
        self.records.push(record);
    }

    /// Whether the motion cannot go on, because a step was refused.
    pub(super) fn is_broken(&self) -> bool {
        self.broken
    }

    /// Ends the motion with a jump.
    pub(super) fn push_jump(&mut self, to: Instant) {
        let jump = Dense::empty(to.u.into_array());
        self.push(StepRecord::polynomial(to.phase, jump));
    }

    /// The start of the motion.
    pub fn start(&self) -> Instant {
        self.start
    }

    /// The end of the motion computed so far.
    pub fn end(&self) -> Instant {
        self.records.last().map_or(self.start, end_of)
    }

    /// The beginning of each phase.
    pub fn phases(&self) -> impl Iterator<Item = Instant> + '_ {
        let mut before = None;
        let begins = move |record: &StepRecord| {
            let changed = before.replace(record.phase) != Some(record.phase);
            changed.then(|| instant(record.phase, &record.start))
        };
        self.records.iter().filter_map(begins)
    }

    /// The size of the last step.
    pub(super) fn last_step(&self) -> f64 {
        self.records.last().map_or(0.0, |record| record.h)
    }

    /// The start and the ends of all steps. A moment at which the phase or the state jumps appears twice,
    /// before and after the jump.
    pub fn nodes(&self) -> impl Iterator<Item = Instant> + '_ {
        self.sampled(1, 0..self.records.len())
    }

    /// The motion at a time (s). At a jump it is the state after the jump; times outside the motion give
    /// its ends.
    pub fn at(&self, t: f64) -> Instant {
        self.look_up().at(t)
    }

    pub(super) fn records(&self) -> &[StepRecord] {
        &self.records
    }

    /// The index of the step at a time (s) and the fraction of that step; outside the motion those of its
    /// ends.
    pub(super) fn locate(&self, t: f64) -> (usize, f64) {
        self.look_up().locate(t)
    }

    /// The number of steps.
    pub fn steps(&self) -> usize {
        self.records.len()
    }

    /// Evaluates the motion at many times. This is fastest if successive times lie in the same step.
    pub fn look_up(&self) -> LookUp<'_> {
        LookUp {
            trajectory: self,
            cached: None,
        }
    }

    /// The start and `per_step` samples of each step, including its end. They are dense where the motion is
    /// fast.
    pub fn samples(&self, per_step: usize) -> Vec<Instant> {
        self.sampled(per_step, 0..self.records.len()).collect()
    }

    /// The [`Self::samples`] whose time (s) is in a range.
    pub(super) fn samples_in(
        &self,
        times: RangeInclusive<f64>,
        per_step: usize,
    ) -> impl Iterator<Item = Instant> + '_ {
        let (start, end) = (*times.start(), *times.end());
        let first = self.records.partition_point(|step| step.end[TIME] < start);
        let last = self
            .records
            .partition_point(|step| step.start[TIME] <= end)
            .max(first);
        self.sampled(per_step, first..last)
            .filter(move |at| times.contains(&at.t))
    }

    fn sampled(&self, per_step: usize, steps: Range<usize>) -> impl Iterator<Item = Instant> + '_ {
        let start = steps
            .start
            .checked_sub(1)
            .map_or(self.start, |before| end_of(&self.records[before]));
        let inside = move |record: &StepRecord| {
            let (phase, end) = (record.phase, instant(record.phase, &record.end));
            let dense = (per_step > 1).then(|| record.dense(&self.contacts));
            let at = move |i| {
                let dense = dense.as_ref()?;
                Some(instant(phase, &dense.at(i as f64 / per_step as f64)))
            };
            (1..per_step).filter_map(at).chain([end])
        };
        let mut before = (start.phase, start.u.into_array());
        let with_changes = move |record: &StepRecord| {
            let (phase_before, end_before) = before;
            before = (record.phase, record.end);
            let changed = phase_before != record.phase || end_before != record.start;
            let beginning = changed.then(|| instant(record.phase, &record.start));
            beginning.into_iter().chain(inside(record))
        };
        let steps = &self.records[steps];
        core::iter::once(start).chain(steps.iter().flat_map(with_changes))
    }
}

/// Evaluates a motion at one time after another and caches the dense output of the last step used.
pub struct LookUp<'a> {
    trajectory: &'a Trajectory,
    cached: Option<(usize, Polynomial)>,
}

impl LookUp<'_> {
    /// As [`Trajectory::at`].
    pub fn at(&mut self, t: f64) -> Instant {
        let Trajectory { start, records, .. } = self.trajectory;
        if t <= start.t {
            return *start;
        }
        match self.cached(t) {
            Some((index, dense)) => {
                let x = dense.fraction_where(TIME, t);
                instant(records[index].phase, &dense.at(x))
            }
            None => self.trajectory.end(),
        }
    }

    /// The motion at a fraction, from 0 to 1, of a step; `None` if there is no such step.
    pub fn inside(&mut self, step: usize, fraction: f64) -> Option<Instant> {
        let record = self.trajectory.records.get(step)?;
        if fraction <= 0.0 {
            return Some(instant(record.phase, &record.start));
        }
        if fraction >= 1.0 {
            return Some(end_of(record));
        }
        let dense = self.dense_output(step)?;
        Some(instant(record.phase, &dense.at(fraction)))
    }

    fn locate(&mut self, t: f64) -> (usize, f64) {
        if t <= self.trajectory.start.t {
            return (0, 0.0);
        }
        match self.cached(t) {
            Some((index, dense)) => (index, dense.fraction_where(TIME, t)),
            None => (self.trajectory.records.len().saturating_sub(1), 1.0),
        }
    }

    /// The step that contains a time; `None` after the end.
    fn cached(&mut self, t: f64) -> Option<(usize, &Polynomial)> {
        let records = &self.trajectory.records;
        let index = records.partition_point(|record| record.end[TIME] <= t);
        Some((index, self.dense_output(index)?))
    }

    /// The dense output of a step.
    fn dense_output(&mut self, index: usize) -> Option<&Polynomial> {
        let Trajectory {
            contacts, records, ..
        } = self.trajectory;
        let record = records.get(index)?;
        if self.cached.as_ref().is_none_or(|cached| cached.0 != index) {
            self.cached = Some((index, record.dense(contacts)));
        }
        self.cached.as_ref().map(|cached| &cached.1)
    }
}

fn instant(phase: Phase, u: &[f64; COORDINATES]) -> Instant {
    Instant {
        phase,
        u: Coordinates::from_array(u),
    }
}

fn end_of(record: &StepRecord) -> Instant {
    instant(record.phase, &record.end)
}
