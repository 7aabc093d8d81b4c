//! The phases of a motion, one after another.

mod corner_approach;
mod flat_landing;
mod level_phases;
#[cfg(feature = "ground")]
mod sample_to_sample;
mod steps;

#[cfg(feature = "ground")]
pub(super) use self::sample_to_sample::SampleStep;
#[cfg(feature = "ground")]
use self::sample_to_sample::SampleSteps;
use self::steps::Steps;
use super::contacts::{Contacts, Transition};
use super::event::{Event, EventKind};
use super::event_detector::{EventDetector, Goal, TerminalEvent};
use super::instant::{Instant, LEVEL_PHASES, Phase};
use super::options::Options;
use super::phase_system::{IndependentVariable, PhaseSystem};
use super::slip_onset;
use super::step_record::StepRecord;
use super::trajectory::Trajectory;
use crate::ending::{FACE_DOWN_TILT, Status};
use crate::error_scale::{ErrorScale, max_brief_change};
use crate::law::{DynamicsExt, Parameters};
use crate::solve::{Implicit, ImplicitStep, Work};
use crate::state::{COORDINATES, Coordinates, TIME};
use core::f64::consts::PI;
use core::ops::ControlFlow;
use std::sync::Arc;

/// The simulation fails after this many consecutive phases of zero length.
const MAX_EMPTY_PHASES: usize = 30;

/// A level body in flight lands flat if its gap is smaller than this fraction of its radius.
const TOUCHING: f64 = 1e-12;

/// The number of steps from one test for stiffness to the next. Phases may have fewer: where a force depends
/// steeply on a velocity, explicit steps that are barely stable can end each phase by a false event.
const STIFFNESS_TEST_INTERVAL: usize = 64;

/// What follows a phase.
enum AfterEvent {
    Phase(Phase, PhaseStart),
    /// The phase goes on with steps of this size and independent variable.
    #[cfg(feature = "ground")]
    Steps(Phase, PhaseStart, StepSize),
    End(Status),
}

/// How far a motion has been followed.
pub(super) enum Followed {
    /// To its end.
    Ended(Status),
    /// To a sample of the table's record, from which a rolling rim may go on in steps from sample to sample.
    #[cfg(feature = "ground")]
    ToSample(Box<SampleStep>),
}

/// The start of a phase: the coordinates, and the direction of a slip that begins from rest.
#[derive(Clone, Copy)]
struct PhaseStart {
    u: Coordinates<f64>,
    direction: Option<[f64; 2]>,
}

/// The independent variable and the size of the next step.
#[derive(Clone, Copy)]
struct StepSize {
    variable: IndependentVariable,
    h: f64,
}

/// The reason why explicit steps end.
enum StepsEnd {
    Phase(PhaseEnd),
    /// The phase goes on from these coordinates, in the next stretch of the table's motion or with another
    /// independent variable. Without a size, the first step is sought anew.
    Continue(Coordinates<f64>, Option<StepSize>),
}

/// The end of a phase: a terminal event, or the end of the motion without one.
enum PhaseEnd {
    Event(TerminalEvent),
    Motion(Status),
    /// The phase may go on in steps from sample to sample.
    #[cfg(feature = "ground")]
    Sample(Box<SampleStep>),
}

/// A simulation in progress.
pub(super) struct Run<'a> {
    contacts: &'a Arc<Contacts>,
    options: &'a Options,
    detector: EventDetector<'a>,
    trajectory: Trajectory,
    work: Work,
    next: AfterEvent,
    empty_phases: usize,
    /// The number of steps at the last test for stiffness.
    steps_at_stiffness_test: usize,
    /// Time and yaw at the end of the last phase.
    last_end: (f64, f64),
    /// The terminal event of the last phase.
    last_event: Option<TerminalEvent>,
    /// The number of times that the whole base has come down flat.
    landings: u64,
    /// `None` where steps from sample to sample cannot follow the motion.
    #[cfg(feature = "ground")]
    sample_steps: Option<SampleSteps>,
}

impl<'a> Run<'a> {
    pub(super) fn new(
        contacts: &'a Arc<Contacts>,
        options: &'a Options,
        goal: Goal,
        start: Coordinates<f64>,
    ) -> Self {
        let stands = LEVEL_PHASES && start.sin == 0.0 && goal.needs_time();
        let next = contacts.settle(&start);
        let phase = if stands {
            Phase::Standing
        } else {
            next.phase()
        };
        let start = if stands {
            start
        } else {
            with_slip_direction(next, start)
        };
        let leading = Instant { phase, u: start };
        let mut run = Run {
            contacts,
            options,
            detector: EventDetector::new(contacts, options, goal, &leading),
            trajectory: Trajectory::new(contacts, leading, goal.needs_trajectory()),
            work: Work::default(),
            next: AfterEvent::End(Status::Failed),
            empty_phases: 0,
            steps_at_stiffness_test: 0,
            last_end: (f64::NAN, f64::NAN),
            last_event: None,
            landings: 0,
            #[cfg(feature = "ground")]
            sample_steps: SampleSteps::new(contacts, options),
        };
        if stands {
            let direction = None;
            run.next = AfterEvent::Phase(
                phase,
                PhaseStart {
                    u: start,
                    direction,
                },
            );
            return run;
        }
        run.next = match run.detector.event_at_start(&leading) {
            Some(event) => run.after(event, &leading),
            None => run.start_phase(next, start),
        };
        run
    }

    /// Runs the simulation to the end of the motion.
    pub(super) fn follow_to_the_end(
        &mut self,
        report: &mut dyn FnMut(f64) -> ControlFlow<()>,
    ) -> Status {
        loop {
            match self.follow(report) {
                Followed::Ended(status) => return status,
                #[cfg(feature = "ground")]
                Followed::ToSample(sample) => self.step_alone(*sample),
            }
        }
    }

    /// Runs the simulation until it ends or until steps from sample to sample may follow.
    pub(super) fn follow(&mut self, report: &mut dyn FnMut(f64) -> ControlFlow<()>) -> Followed {
        loop {
            if let Some(PhaseEnd::Motion(status)) = self.out_of_steps(report)
                && !matches!(self.next, AfterEvent::End(_))
            {
                return Followed::Ended(status);
            }
            let (phase, start, pace) =
                match core::mem::replace(&mut self.next, AfterEvent::End(Status::Failed)) {
                    AfterEvent::End(_) if self.trajectory.is_broken() => {
                        return Followed::Ended(Status::Failed);
                    }
                    AfterEvent::End(status) => return Followed::Ended(status),
                    AfterEvent::Phase(phase, PhaseStart { u, .. }) if phase.is_level() => {
                        self.next = self.follow_level(phase, u, report);
                        continue;
                    }
                    AfterEvent::Phase(phase, start) => (phase, start, None),
                    #[cfg(feature = "ground")]
                    AfterEvent::Steps(phase, start, pace) => (phase, start, Some(pace)),
                };
            self.next = match self.follow_phase(phase, &start, pace, report) {
                _ if self.trajectory.is_broken() => AfterEvent::End(Status::Failed),
                PhaseEnd::Event(event) => self.after(event, &self.trajectory.end()),
                PhaseEnd::Motion(status) => AfterEvent::End(status),
                #[cfg(feature = "ground")]
                PhaseEnd::Sample(sample) => return Followed::ToSample(sample),
            }
        }
    }

    /// The terminal event of the last phase; `None` if no phase had one.
    pub(super) fn last_event(&self) -> Option<TerminalEvent> {
        self.last_event
    }

    pub(super) fn into_parts(self) -> (Trajectory, Vec<Event>, Work) {
        (self.trajectory, self.detector.into_events(), self.work)
    }

    /// Integrates one phase to its end, or to a sample from which steps to further samples can be tried.
    fn follow_phase(
        &mut self,
        phase: Phase,
        phase_start: &PhaseStart,
        mut pace: Option<StepSize>,
        report: &mut dyn FnMut(f64) -> ControlFlow<()>,
    ) -> PhaseEnd {
        if let Some(over) = self.out_of_steps(report) {
            return over;
        }
        let contacts = self.contacts;
        let mut start = *phase_start;
        loop {
            let phases = contacts.phases_from(start.u.t);
            let phase_system = phases.phase_system(phase, IndependentVariable::Regularized);
            let corner = contacts.corner_after(start.u.t);
            let StepSize { variable, h } = match pace {
                Some(pace) => pace,
                None => match self.first_pace(&phase_system, phase, &mut start, corner) {
                    ControlFlow::Continue(Some(pace)) => pace,
                    ControlFlow::Continue(None) => continue,
                    ControlFlow::Break(over) => return over,
                },
            };
            let steps = Steps {
                run: self,
                phase_system: &phase_system,
                phase,
                variable,
                corner,
                start: start.u.into_array(),
                h,
                report,
            };
            match phases.solve(phase, variable, steps) {
                StepsEnd::Phase(over) => return over,
                StepsEnd::Continue(u, next) => {
                    #[cfg(feature = "ground")]
                    if u.t == corner
                        && let Some(sample) = self.on_samples(phase, &u)
                    {
                        return PhaseEnd::Sample(Box::new(sample));
                    }
                    let direction = None;
                    start = PhaseStart { u, direction };
                    pace = next;
                }
            }
        }
    }

    /// The first explicit step of a phase, after dry slip that is too slow for explicit steps. `None` if a corner
    /// of the table's acceleration came first. The start becomes that of the explicit steps.
    fn first_pace(
        &mut self,
        phase_system: &PhaseSystem<'_>,
        phase: Phase,
        start: &mut PhaseStart,
        corner: f64,
    ) -> ControlFlow<PhaseEnd, Option<StepSize>> {
        self.detector.cut_steps_at(corner);
        let begun = self.slow_slip(phase_system, phase, start);
        self.detector.cut_steps_at(f64::INFINITY);
        let direction = None;
        match begun {
            ControlFlow::Continue((u, h)) => {
                *start = PhaseStart { u, direction };
                let h = h / phase_system.sundman_factor(&u);
                let variable = IndependentVariable::Regularized;
                ControlFlow::Continue(Some(StepSize { variable, h }))
            }
            ControlFlow::Break(PhaseEnd::Event(TerminalEvent::Corner)) => {
                let u = self.trajectory.end().u;
                *start = PhaseStart { u, direction };
                ControlFlow::Continue(None)
            }
            ControlFlow::Break(over) => ControlFlow::Break(over),
        }
    }

    fn out_of_steps(&self, report: &mut dyn FnMut(f64) -> ControlFlow<()>) -> Option<PhaseEnd> {
        if self.work.steps >= self.options.max_steps || self.trajectory.is_broken() {
            return Some(PhaseEnd::Motion(Status::Failed));
        }
        if self.steps_until_report() == 0 && report(self.trajectory.end().t).is_break() {
            return Some(PhaseEnd::Motion(Status::Interrupted));
        }
        None
    }

    fn steps_until_report(&self) -> usize {
        4095 - self.work.steps % 4096
    }

    /// Continues from `u` with implicit steps while the system is stiff for explicit steps of size `h`. Returns
    /// the size of the next explicit step if any implicit steps were made.
    fn implicit_steps(
        &mut self,
        phase_system: &PhaseSystem<'_>,
        phase: Phase,
        u: [f64; COORDINATES],
        h: f64,
        report: &mut dyn FnMut(f64) -> ControlFlow<()>,
    ) -> ControlFlow<PhaseEnd, Option<f64>> {
        // An explicit step is stable up to about 6 relaxation times, but rarely accurate beyond 3.
        const STIFF: f64 = 4.0;
        // The first implicit step, in explicit steps, and the shortest that is worth its cost. The first one is
        // longer, because it may have to be repeated with smaller step sizes.
        const FIRST: f64 = 20.0;
        const SHORTEST: f64 = 5.0;
        let phases = self.contacts.dual_phases_from(u[TIME]);
        let dual = phases.phase_system(phase, IndependentVariable::Regularized);
        let before = self.work;
        let tolerance = self.options.step_tolerance();
        let mut implicit = Implicit::new(phase_system, &dual, u, tolerance);
        self.work = before + implicit.work;
        if h * implicit.relaxation() < STIFF {
            return ControlFlow::Continue(None);
        }
        let mut stepped = false;
        let mut max_growth: f64 = 4.0;
        let mut h = FIRST * h;
        loop {
            if let Some(over) = self.out_of_steps(report) {
                return ControlFlow::Break(over);
            }
            let found = implicit.attempt(h);
            let factor = found.as_ref().map_or(0.25, ImplicitStep::next_factor);
            let accepted = found.filter(|found| found.error <= 1.0);
            match &accepted {
                Some(found) => implicit.accept(&found.dense),
                None => implicit.work.rejected += 1,
            }
            self.work = before + implicit.work;
            let is_accepted = accepted.is_some();
            if let Some(ImplicitStep { dense, .. }) = accepted {
                let record = StepRecord::polynomial(phase, dense.clone());
                if let Some(event) = self.detector.process(record, &dense, &mut self.trajectory) {
                    return ControlFlow::Break(self.end_of_phase(event, h));
                }
                stepped = true;
            }
            // After a rejected step the step size grows only slowly for a while.
            let max_factor = if is_accepted { max_growth } else { 1.0 };
            max_growth = if is_accepted {
                (1.5 * max_growth).min(4.0)
            } else {
                1.2
            };
            h *= factor.min(max_factor);
            let stable = STIFF / implicit.relaxation();
            // Written so that a NaN ends it.
            let is_worthwhile = h > SHORTEST * stable;
            if !is_worthwhile {
                // Without relaxation every step is stable, but not every one is accurate.
                return ControlFlow::Continue(stepped.then_some(h.min(stable)));
            }
        }
    }

    /// The end of a phase by a terminal event, unless the motion makes no progress over many phases.
    fn end_of_phase(&mut self, event: TerminalEvent, step: f64) -> PhaseEnd {
        // In the inner problem of the near-collision time stands still, and only the yaw shows progress.
        let at = self.trajectory.end();
        let progressed = (at.t, at.yaw) != self.last_end;
        self.last_end = (at.t, at.yaw);
        if progressed && self.trajectory.last_step() > 1e-9 * step {
            self.empty_phases = 0;
        } else {
            self.empty_phases += 1;
        }
        if self.empty_phases <= MAX_EMPTY_PHASES {
            PhaseEnd::Event(event)
        } else if self.lies_flat_within_errors(&at) {
            PhaseEnd::Event(TerminalEvent::StoppedRunning)
        } else {
            PhaseEnd::Motion(Status::Failed)
        }
    }

    /// Whether resistance has stopped the contact point on the rim for good, and the tilt is smaller than errors may be.
    ///
    /// A resistance that does not depend on the load can hold the normal force in a balance near zero: without it the
    /// rim would rise, which needs the contact point to run, and so would the resistance. As the tilt falls, the force
    /// becomes smaller than its error, so that the rim seems to leave the table and to land again without end.
    fn lies_flat_within_errors(&self, at: &Instant) -> bool {
        at.sin < self.options.rtol && self.contacts.has_stopped_running(Phase::Sliding, at)
    }

    /// Integrates the beginning of a phase in which dry slip is too slow for explicit steps. Returns the
    /// coordinates and the size of the first explicit step.
    fn slow_slip(
        &mut self,
        phase_system: &PhaseSystem<'_>,
        phase: Phase,
        phase_start: &PhaseStart,
    ) -> ControlFlow<PhaseEnd, (Coordinates<f64>, f64)> {
        let h = first_step(phase_system, &phase_start.u);
        let Some(dry) = self.contacts.dry().filter(|_| phase == Phase::Sliding) else {
            return ControlFlow::Continue((phase_start.u, h));
        };
        let tolerance = self.options.step_tolerance();
        let speed = phase_start.u.slip_speed();
        let direction = phase_start
            .direction
            .unwrap_or_else(|| [phase_start.u.slip_x / speed, phase_start.u.slip_y / speed]);
        let from_rest = phase_start.direction.is_some();
        let h = 10.0 * h;
        let slow = slip_onset::integrate(
            dry,
            phase_system,
            &phase_start.u,
            direction,
            from_rest,
            h,
            tolerance,
        );
        if slow.steps.is_empty() {
            let from = match phase_start.direction {
                // If the onset from rest fails, explicit steps begin from a tiny slip.
                Some([x, y]) => {
                    let faint = 10.0 * self.contacts.stopped_speed(&phase_start.u);
                    Coordinates {
                        slip_x: faint * x,
                        slip_y: faint * y,
                        ..phase_start.u
                    }
                }
                None => phase_start.u,
            };
            return ControlFlow::Continue((from, 0.1 * h));
        }
        for dense in slow.steps {
            self.work.steps += 1;
            let h = dense.h;
            let record = StepRecord::polynomial(Phase::Sliding, dense.clone());
            if let Some(event) = self.detector.process(record, &dense, &mut self.trajectory) {
                return ControlFlow::Break(self.end_of_phase(event, h));
            }
            if self.slip_is_stopping(Phase::Sliding) {
                return ControlFlow::Break(self.end_of_phase(TerminalEvent::SlipEnd, h));
            }
        }
        ControlFlow::Continue((self.trajectory.end().u, slow.h))
    }

    /// Whether a dry slip is about to stop so soon that its end is one straight step.
    fn slip_is_stopping(&self, phase: Phase) -> bool {
        phase == Phase::Sliding
            && self.contacts.dry().is_some_and(|dry| {
                let at = self.trajectory.end().u;
                let tolerance = self.options.step_tolerance();
                let error_scale = ErrorScale::new(self.contacts.parameters());
                error_scale.slip_persists(&at, &dry.rates(&at), 1.0, tolerance) < 0.0
            })
    }

    /// The continuation after the terminal event of a phase.
    fn after(&mut self, event: TerminalEvent, at: &Instant) -> AfterEvent {
        self.last_event = Some(event);
        let end = |run: &mut Self, kind, status| {
            run.detector.add(kind, *at);
            AfterEvent::End(status)
        };
        match event {
            TerminalEvent::Done => AfterEvent::End(Status::Finished),
            TerminalEvent::Corner => {
                let start = PhaseStart {
                    u: at.u,
                    direction: None,
                };
                AfterEvent::Phase(at.phase, start)
            }
            TerminalEvent::Topple => {
                self.detector.add(EventKind::Topple, *at);
                if self.contacts.falls_on_its_side(at) {
                    self.trajectory
                        .push_jump(self.contacts.fallen_on_its_side(at));
                }
                AfterEvent::End(Status::Toppled)
            }
            TerminalEvent::Rest if self.contacts.moves() => self.stand(at),
            TerminalEvent::Rest => end(self, EventKind::Rest, Status::AtRest),
            TerminalEvent::Paradox => end(self, EventKind::Painleve, Status::Painleve),
            TerminalEvent::Flat if at.phase == Phase::Flying => {
                let k = self.contacts.parameters();
                let u = past_upright(k, at);
                // The opposite side of the rim meets the table just as this side leaves it.
                if u.gap < TOUCHING * k.r && u.gap_rate < 0.0 {
                    return end(self, EventKind::FaceDown, Status::FaceDown);
                }
                let phase = Phase::Flying;
                self.detector.process_jump(at, Instant { phase, u });
                let direction = None;
                AfterEvent::Phase(phase, PhaseStart { u, direction })
            }
            TerminalEvent::Flat => self.land_flat(at),
            TerminalEvent::StoppedRunning => self.land_stopped(at),
            TerminalEvent::LiftOff if !self.contacts.can_fly() => {
                end(self, EventKind::LiftOff, Status::LiftedOff)
            }
            TerminalEvent::LiftOff => self.start_phase(Transition::Fly, at.u),
            TerminalEvent::SlipOnset => {
                let next = match self.contacts.begin_to_slip(at) {
                    // The friction has only just been exceeded, within rounding.
                    Transition::Paradox if self.contacts.friction_cone_margin(at) > 0.0 => {
                        Transition::Roll
                    }
                    next => next,
                };
                self.start_phase(next, at.u)
            }
            TerminalEvent::SlipEnd => {
                let stopped = stopped(self.contacts, at, self.options.step_tolerance());
                let next = self.contacts.settle(&stopped);
                self.start_phase(next, stopped)
            }
            TerminalEvent::Land => {
                let Some((landed, next)) = self.contacts.resolve_impact(at) else {
                    return AfterEvent::End(Status::Failed);
                };
                let after = Instant {
                    phase: next.phase(),
                    u: landed,
                };
                self.detector.add(EventKind::Land, after);
                self.detector.process_jump(at, after);
                self.start_phase(next, landed)
            }
        }
    }

    /// Starts the next phase at `u` and adds the event of the change of contact.
    fn start_phase(&mut self, next: Transition, u: Coordinates<f64>) -> AfterEvent {
        self.start_phase_from(self.trajectory.end().phase, next, u)
    }

    /// As [`Self::start_phase`], after the phase `before`.
    fn start_phase_from(
        &mut self,
        before: Phase,
        next: Transition,
        u: Coordinates<f64>,
    ) -> AfterEvent {
        let u = with_slip_direction(next, u);
        let (phase, kind) = match next {
            Transition::Roll => (Phase::Rolling, EventKind::Stick),
            Transition::Slide | Transition::BeginToSlip(_) => (Phase::Sliding, EventKind::Slip),
            Transition::Fly => (Phase::Flying, EventKind::LiftOff),
            Transition::Paradox => {
                let phase = Phase::Sliding;
                self.detector.add(EventKind::Painleve, Instant { phase, u });
                return AfterEvent::End(Status::Painleve);
            }
        };
        if phase != before {
            self.detector.add(kind, Instant { phase, u });
        }
        let direction = match next {
            Transition::BeginToSlip(direction) => Some(direction),
            _ => None,
        };
        AfterEvent::Phase(phase, PhaseStart { u, direction })
    }
}

/// The coordinates at the start of a phase. Where a slip begins from rest they get an infinitesimal slip in
/// its direction, which determines the forces there and is too small to have any other effect.
fn with_slip_direction(next: Transition, u: Coordinates<f64>) -> Coordinates<f64> {
    const NO_SPEED: f64 = 1e-150;
    match next {
        Transition::BeginToSlip([slip_x, slip_y]) => Coordinates {
            slip_x: NO_SPEED * slip_x,
            slip_y: NO_SPEED * slip_y,
            ..u
        },
        _ => u,
    }
}

/// A first guess for the step size.
fn first_step(phase_system: &PhaseSystem<'_>, u: &Coordinates<f64>) -> f64 {
    let h = phase_system.error_scale.first_step(u);
    if u.gap_rate > 0.0 {
        // A bounce lasts about 2v/g.
        let g = phase_system.dynamics.parameters().g;
        return h.min(0.1 * u.gap_rate / (g * u.sin));
    }
    h
}

/// The coordinates at which a dry slip that is about to stop has stopped, if it decelerates at its present
/// rate.
pub(crate) fn stopped(
    contacts: &Contacts,
    at: &Coordinates<f64>,
    tolerance: f64,
) -> Coordinates<f64> {
    let rates = contacts.dynamics(Phase::Sliding).rates(at);
    let stopping = -(rates.slip_x * at.slip_x + rates.slip_y * at.slip_y);
    let time = (at.slip_x * at.slip_x + at.slip_y * at.slip_y) / stopping;
    // If the other velocities would change before the slip stops, it counts as stopped now.
    let rate = ErrorScale::new(contacts.parameters()).rate(at);
    let is_brief = stopping > 0.0 && time * rate <= max_brief_change(tolerance);
    Coordinates {
        slip_x: 0.0,
        slip_y: 0.0,
        ..at.plus(if is_brief { time } else { 0.0 }, &rates)
    }
}

/// The same position and motion with the tilt on the other side of upright, (ψ, −φ, θ) =
/// (ψ ± π, φ, θ ∓ π). In a flight through upright the lowest point of the rim changes sides, and so does its
/// velocity. The yaw jumps in the direction in which it turns, as in a passage just beside upright, so that
/// mirror images stay mirror images. In a plane flight, which has no such direction, it jumps by +π.
fn past_upright(k: &Parameters<f64>, u: &Coordinates<f64>) -> Coordinates<f64> {
    let half_turn = if u.w < 0.0 { -PI } else { PI };
    Coordinates {
        yaw: u.yaw + half_turn,
        spin: u.spin - half_turn,
        sin: FACE_DOWN_TILT,
        p: -u.p,
        w: -u.w,
        x1: -u.x1,
        y1: -u.y1,
        slip_x: -u.slip_x,
        slip_y: -u.slip_y - 2.0 * k.r * u.s,
        gap_rate: u.gap_rate + 2.0 * k.rho(u) * u.p,
        ..*u
    }
}

/// Simulates the inner problem of the near-collision, in which sin φ = 0 and time stands still, from `start`
/// until |w| has fallen to `faded` (rad/s) as the body rises.
pub(crate) fn pass_near_collision(
    contacts: &Arc<Contacts>,
    start: Coordinates<f64>,
    faded: f64,
    options: &Options,
) -> (Trajectory, Status) {
    let mut run = Run::new(contacts, options, Goal::Passed(faded), start);
    let status = run.follow_to_the_end(&mut |_| ControlFlow::Continue(()));
    (run.trajectory, status)
}
