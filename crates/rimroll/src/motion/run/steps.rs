//! The explicit steps of a phase.

use super::corner_approach::CornerApproach;
use super::{PhaseEnd, Run, STIFFNESS_TEST_INTERVAL, StepSize, StepsEnd};
use crate::ending::Status;
use crate::motion::event_detector::TerminalEvent;
use crate::motion::instant::Phase;
use crate::motion::phase_dynamics::SystemVisitor;
use crate::motion::phase_system::{IndependentVariable, PhaseSystem, leading};
use crate::motion::step_record::StepRecord;
use crate::solve::{Stepper, System, Work};
use crate::state::{COORDINATES, COORDINATES_AT_REST, Coordinates, TIME};
use core::ops::ControlFlow;

/// The explicit steps of a phase.
pub(super) struct Steps<'r, 'a> {
    pub(super) run: &'r mut Run<'a>,
    pub(super) phase_system: &'r PhaseSystem<'r>,
    pub(super) phase: Phase,
    pub(super) variable: IndependentVariable,
    /// The next corner of the table's acceleration, s.
    pub(super) corner: f64,
    pub(super) start: [f64; COORDINATES],
    pub(super) h: f64,
    pub(super) report: &'r mut dyn FnMut(f64) -> ControlFlow<()>,
}

impl SystemVisitor for Steps<'_, '_> {
    type Output = StepsEnd;

    fn with<S: System<f64, N>, const N: usize>(self, system: &S) -> StepsEnd {
        let Steps {
            run,
            phase_system,
            phase,
            variable,
            corner,
            start: mut u,
            mut h,
            report,
        } = self;
        let tolerance = run.options.step_tolerance();
        let approach = CornerApproach {
            phase_system,
            variable,
            corner,
        };
        let mut stepper = Stepper::new(system, leading(&u), h, tolerance);
        let mut before = run.work;
        loop {
            let since_test = run.work.steps - run.steps_at_stiffness_test;
            if N >= COORDINATES_AT_REST
                && since_test >= STIFFNESS_TEST_INTERVAL
                && approach.is_long(&u, stepper.h)
            {
                run.work = before + stepper.work;
                let explicit = approach.regularized(&u, h);
                run.detector.cut_steps_at(corner);
                let implicit = run.implicit_steps(phase_system, phase, u, explicit, report);
                run.detector.cut_steps_at(f64::INFINITY);
                run.steps_at_stiffness_test = run.work.steps;
                match implicit {
                    ControlFlow::Break(PhaseEnd::Event(TerminalEvent::Corner)) => {
                        return StepsEnd::Continue(run.trajectory.end().u, None);
                    }
                    ControlFlow::Break(over) => return StepsEnd::Phase(over),
                    ControlFlow::Continue(None) => stepper.work = Work::default(),
                    ControlFlow::Continue(Some(next)) if variable == IndependentVariable::Time => {
                        let pace = StepSize {
                            variable: IndependentVariable::Regularized,
                            h: next,
                        };
                        return StepsEnd::Continue(run.trajectory.end().u, Some(pace));
                    }
                    ControlFlow::Continue(Some(next)) => {
                        (u, h) = (run.trajectory.end().u.into_array(), next);
                        stepper = Stepper::new(system, leading(&u), h, tolerance);
                    }
                }
                before = run.work;
            }
            if let Some(over) = run.out_of_steps(report) {
                return StepsEnd::Phase(over);
            }
            if let Some(pace) = approach.other_variable(&u, stepper.h) {
                run.work = before + stepper.work;
                return StepsEnd::Continue(Coordinates::from_array(&u), Some(pace));
            }
            let to_corner = approach.limit(&u, &mut stepper.h);
            let Ok(step) = stepper.advance() else {
                return StepsEnd::Phase(PhaseEnd::Motion(Status::Failed));
            };
            h = step.h;
            let at_corner = variable == IndependentVariable::Time && h == to_corner;
            if at_corner {
                step.end[TIME] = corner;
            } else if step.end[TIME] > corner {
                run.work = before + stepper.work;
                return StepsEnd::Continue(
                    Coordinates::from_array(&u),
                    Some(approach.in_time(to_corner)),
                );
            }
            u[..N].copy_from_slice(&step.end);
            let event = if run.detector.is_uneventful(phase, step) {
                run.trajectory
                    .push(StepRecord::explicit((phase, variable), step, &u));
                None
            } else {
                let record = StepRecord::explicit((phase, variable), step, &u);
                let dense = step.dense(system).widened(&u);
                run.detector.process(record, &dense, &mut run.trajectory)
            };
            run.work = before + stepper.work;
            if let Some(event) = event {
                return StepsEnd::Phase(run.end_of_phase(event, h));
            }
            run.empty_phases = 0;
            if run.slip_is_stopping(phase) {
                return StepsEnd::Phase(PhaseEnd::Event(TerminalEvent::SlipEnd));
            }
            if at_corner {
                let u = Coordinates::from_array(&u);
                return StepsEnd::Continue(u, Some(approach.in_time(stepper.h)));
            }
        }
    }
}
