//! The record of an accepted step: its size and the states at its ends. The dense output is recomputed on
//! demand, to the same bits.

use super::contacts::Contacts;
use super::instant::Phase;
use super::phase_dynamics::SystemVisitor;
use super::phase_system::{IndependentVariable, leading};
use crate::solve::{Dense, Step, System};
#[cfg(feature = "ground")]
use crate::state::Coordinates;
use crate::state::{COORDINATES, TIME};

pub(super) type Polynomial = Dense<f64, COORDINATES>;

/// A step of a phase.
#[derive(Clone)]
pub(super) struct StepRecord {
    pub phase: Phase,
    /// The independent variable of the step.
    pub(super) variable: IndependentVariable,
    /// The step size in the independent variable.
    pub h: f64,
    pub start: [f64; COORDINATES],
    pub end: [f64; COORDINATES],
    /// The dense output of a step that was not made by the explicit method.
    polynomial: Option<Box<Polynomial>>,
}

impl StepRecord {
    /// An explicit step of the first N coordinates; the others keep their values in `constant`.
    #[inline(always)]
    pub fn explicit<const N: usize>(
        (phase, variable): (Phase, IndependentVariable),
        step: &Step<f64, N>,
        constant: &[f64; COORDINATES],
    ) -> StepRecord {
        let widened = |leading: &[f64; N]| {
            let mut coordinates = *constant;
            coordinates[..N].copy_from_slice(leading);
            coordinates
        };
        StepRecord {
            phase,
            variable,
            h: step.h,
            start: widened(&step.start),
            end: widened(&step.end),
            polynomial: None,
        }
    }

    /// A step of h seconds that another method has made. Its dense output is that of the explicit method, whose end
    /// differs from this one within the tolerance.
    #[cfg(feature = "ground")]
    pub fn in_time(
        phase: Phase,
        h: f64,
        start: &Coordinates<f64>,
        end: &Coordinates<f64>,
    ) -> StepRecord {
        StepRecord {
            phase,
            variable: IndependentVariable::Time,
            h,
            start: start.into_array(),
            end: end.into_array(),
            polynomial: None,
        }
    }

    /// A step given by its dense output.
    pub fn polynomial(phase: Phase, dense: Polynomial) -> StepRecord {
        StepRecord {
            phase,
            variable: IndependentVariable::Regularized,
            h: dense.h,
            start: dense.start,
            end: dense.end,
            polynomial: Some(Box::new(dense)),
        }
    }

    pub fn is_polynomial(&self) -> bool {
        self.polynomial.is_some()
    }

    /// The dense output of the step.
    pub fn dense(&self, contacts: &Contacts) -> Polynomial {
        match &self.polynomial {
            Some(dense) => (**dense).clone(),
            None => self.solve(contacts, DenseOutput(self)),
        }
    }

    /// The step shortened to the fraction x. An explicit step is recomputed with that size, so its end has
    /// the full order of the method instead of that of the dense output.
    pub fn cut(&self, contacts: &Contacts, x: f64) -> StepRecord {
        match &self.polynomial {
            Some(dense) => StepRecord::polynomial(self.phase, dense.cut(x)),
            None => self.solve(contacts, Cut(self, x)),
        }
    }

    fn solve<K: SystemVisitor>(&self, contacts: &Contacts, visitor: K) -> K::Output {
        let phases = contacts.phases_from(self.start[TIME]);
        phases.solve(self.phase, self.variable, visitor)
    }

    /// The step recomputed with the size h.
    fn recompute<S: System<f64, N>, const N: usize>(&self, system: &S, h: f64) -> Step<f64, N> {
        Step::recompute(system, &leading(&self.start), h)
    }
}

struct DenseOutput<'a>(&'a StepRecord);

impl SystemVisitor for DenseOutput<'_> {
    type Output = Polynomial;

    fn with<S: System<f64, N>, const N: usize>(self, system: &S) -> Polynomial {
        let DenseOutput(record) = self;
        record
            .recompute(system, record.h)
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
            (record.phase, record.variable),
            &record.recompute(system, x * record.h),
            &record.start,
        )
    }
}
