//! A sampled record of the table's acceleration.

use super::pulse::MAX_ACCELERATION;
use crate::error::{InvalidInput, entry, out_of_bounds, positive};
use crate::real::Real;
use std::sync::Arc;

/// Samples at equal intervals, with straight lines between them.
#[derive(Debug, Clone, PartialEq)]
pub struct Record {
    step: f64,
    samples: Arc<[[f64; 3]]>,
}

/// The straight line between two samples.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Segment {
    begin: f64,
    pub(super) end: f64,
    pub(super) value: [f64; 3],
    pub(super) slope: [f64; 3],
}

impl Record {
    pub(super) fn new(step: f64, samples: Vec<[f64; 3]>) -> Result<Record, InvalidInput> {
        positive("step", step, "s")?;
        if samples.len() < 2 {
            return Err(wrong_length("at least 2 samples".to_owned(), samples.len()));
        }
        for (index, sample) in samples.iter().enumerate() {
            for &value in sample {
                let is_fit = |a: f64| a.abs() <= MAX_ACCELERATION;
                let bound = "between -1e9 and 1e9";
                entry("acceleration", index, value, is_fit, bound, "m/s2")?;
            }
        }
        let samples = samples.into();
        Ok(Record { step, samples })
    }

    /// The time between two samples, s.
    pub fn step(&self) -> f64 {
        self.step
    }

    /// The acceleration along x, y and z at each sample, m/s².
    pub fn samples(&self) -> &[[f64; 3]] {
        &self.samples
    }

    /// The time of the last sample, s.
    pub(super) fn duration(&self) -> f64 {
        self.time(self.samples.len() - 1)
    }

    /// The time of a sample, s.
    pub(crate) fn time(&self, index: usize) -> f64 {
        index as f64 * self.step
    }

    /// The index of the sample at exactly this time (s).
    pub(crate) fn index_of(&self, t: f64) -> Option<usize> {
        let index = (t / self.step + 0.5) as usize;
        (self.time(index) == t).then_some(index)
    }

    /// The number of samples after the first whose times are less than `t` (s).
    pub(crate) fn steps_until(&self, t: f64) -> usize {
        let about = (t / self.step) as usize;
        if self.time(about) < t {
            about
        } else {
            about.saturating_sub(1)
        }
    }

    /// The index of the last sample at or before a time t >= 0 (s).
    pub(super) fn sample_before(&self, t: f64) -> usize {
        self.index(t).min(self.samples.len() - 1)
    }

    /// The whole part of t/step, 0 for a negative time.
    fn index(&self, t: f64) -> usize {
        // A negative quotient becomes 0. Rounding can put a time at a sample into the segment before it.
        let index = (t / self.step) as usize;
        if index > 0 && t < self.time(index) {
            index - 1
        } else if t >= self.time(index + 1) {
            index + 1
        } else {
            index
        }
    }

    /// The segment that contains a time (s) or begins there; `None` after the last sample and before t = 0.
    pub(super) fn segment(&self, t: f64) -> Option<Segment> {
        let segment = self.segment_after(self.index(t))?;
        (t >= 0.0).then_some(segment)
    }

    /// The segment that begins at a sample; `None` for the last.
    pub(super) fn segment_after(&self, index: usize) -> Option<Segment> {
        let [from, to] = [self.samples.get(index)?, self.samples.get(index + 1)?];
        let (begin, end) = (self.time(index), self.time(index + 1));
        Some(Segment {
            begin,
            end,
            value: *from,
            slope: core::array::from_fn(|i| (to[i] - from[i]) / (end - begin)),
        })
    }

    /// The sum of two records with the same times of samples.
    pub(super) fn plus(&self, other: &Record) -> Result<Record, InvalidInput> {
        if self.step != other.step {
            let bound = format!("that of the record it is added to, {} s", self.step);
            return Err(out_of_bounds("step", other.step, &bound, "s"));
        }
        let (mine, theirs) = (&self.samples, &other.samples);
        if mine.len() != theirs.len() {
            let bound = format!(
                "as many samples as the record it is added to, {}",
                mine.len()
            );
            return Err(wrong_length(bound, theirs.len()));
        }
        let sum = |(a, b): (&[f64; 3], &[f64; 3])| core::array::from_fn(|i| a[i] + b[i]);
        Ok(Record {
            step: self.step,
            samples: mine.iter().zip(theirs.iter()).map(sum).collect(),
        })
    }

    pub(super) fn mapped(&self, map: impl Fn([f64; 3]) -> [f64; 3]) -> Record {
        Record {
            step: self.step,
            samples: self.samples.iter().map(|&sample| map(sample)).collect(),
        }
    }
}

fn wrong_length(bound: String, count: usize) -> InvalidInput {
    let field = "acceleration";
    InvalidInput::WrongLength {
        field,
        bound,
        count,
    }
}

impl Segment {
    #[inline(always)]
    pub(super) fn acceleration<T: Real>(&self, t: T) -> [T; 3] {
        let elapsed = t - T::from(self.begin);
        core::array::from_fn(|i| T::from(self.value[i]) + T::from(self.slope[i]) * elapsed)
    }
}
