//! An accepted step as it is kept: where it began and ended and how long it was. Everything between is
//! computed again when it is asked for, to the same bits.

use super::contacts::{Contacts, Phase, SystemVisitor};
use super::mechanics::first;
use crate::solve::{Collocation, Dense, Step, System};
use crate::state::COORDINATES;

pub(super) type Polynomial = Dense<f64, COORDINATES>;

/// A step of a phase.
#[derive(Clone)]
pub(super) struct StepRecord {
    pub phase: Phase,
    /// Its length on the solver's clock.
    pub h: f64,
    pub start: [f64; COORDINATES],
    pub end: [f64; COORDINATES],
    /// What was not made by an explicit step is kept as the polynomial that it is.
    polynomial: Option<Box<Polynomial>>,
}

impl StepRecord {
    /// An explicit step, by which only the first coordinates change from what they are in `rest`.
    #[inline(always)]
    pub fn explicit<const N: usize>(
        phase: Phase,
        step: &Step<f64, N>,
        rest: &[f64; COORDINATES],
    ) -> StepRecord {
        let with_rest = |changed: &[f64; N]| {
            let mut all = *rest;
            all[..N].copy_from_slice(changed);
            all
        };
        StepRecord {
            phase,
            h: step.h,
            start: with_rest(&step.start),
            end: with_rest(&step.end),
            polynomial: None,
        }
    }

    /// A step known as a polynomial.
    pub fn polynomial(phase: Phase, dense: Polynomial) -> StepRecord {
        StepRecord {
            phase,
            h: dense.h,
            start: dense.start,
            end: dense.end,
            polynomial: Some(Box::new(dense)),
        }
    }

    pub fn is_polynomial(&self) -> bool {
        self.polynomial.is_some()
    }

    /// The step as a polynomial.
    pub fn dense(&self, contacts: &Contacts) -> Polynomial {
        match &self.polynomial {
            Some(dense) => (**dense).clone(),
            None => contacts.solve(self.phase, Open(self)),
        }
    }

    /// The step cut at the fraction x: made again with another length, so of the full order, not an
    /// interpolation.
    pub fn cut(&self, contacts: &Contacts, x: f64) -> StepRecord {
        match &self.polynomial {
            Some(dense) => StepRecord::polynomial(self.phase, Collocation::get().cut(dense, x)),
            None => contacts.solve(self.phase, Cut(self, x)),
        }
    }

    /// The step made again with a length of h.
    fn again<S: System<f64, N>, const N: usize>(&self, system: &S, h: f64) -> Step<f64, N> {
        Step::recompute(system, &first(&self.start), h)
    }
}

struct Open<'a>(&'a StepRecord);

impl SystemVisitor for Open<'_> {
    type Output = Polynomial;

    fn with<S: System<f64, N>, const N: usize>(self, system: &S) -> Polynomial {
        let Open(record) = self;
        record
            .again(system, record.h)
            .dense(system)
            .widened(&record.start)
    }
}

struct Cut<'a>(&'a StepRecord, f64);

impl SystemVisitor for Cut<'_> {
    type Output = StepRecord;

    fn with<S: System<f64, N>, const N: usize>(self, system: &S) -> StepRecord {
        let Cut(record, x) = self;
        StepRecord::explicit(
            record.phase,
            &record.again(system, x * record.h),
            &record.start,
        )
    }
}
