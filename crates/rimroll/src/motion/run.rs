//! The phases of a motion, one after another.

use super::contacts::{Contacts, Transition};
use super::event::{Event, EventKind};
use super::event_detector::{EventDetector, Goal, TerminalEvent};
use super::instant::{Instant, Phase};
use super::landing::{landed, with_loss};
use super::level::{Departure, Level, levelled};
use super::mechanics::{Clock, Mechanics, leading};
use super::onset;
use super::options::Options;
use super::phase_dynamics::SystemVisitor;
use super::step_record::StepRecord;
use super::track::Track;
use crate::ending::{FACE_DOWN_TILT, Status};
use crate::error_scale::{ErrorScale, max_brief_change};
use crate::law::Parameters;
use crate::solve::{Found, Implicit, Stepper, System, Work};
use crate::state::{COORDINATES, COORDINATES_AT_REST, Coordinates, TIME};
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
    EndState(Status),
}

/// The start of a phase: the coordinates, and the direction of a slip that begins from rest.
#[derive(Clone, Copy)]
struct PhaseStart {
    u: Coordinates<f64>,
    direction: Option<[f64; 2]>,
}

/// The independent variable and the size of the next step.
#[derive(Clone, Copy)]
struct Pace {
    clock: Clock,
    h: f64,
}

/// The reason why explicit steps end.
enum StepsEnd {
    Phase(PhaseEnd),
    /// The phase goes on from these coordinates, in the next stretch of the table's motion or with another
    /// independent variable. Without a pace, the first step is sought anew.
    Continue(Coordinates<f64>, Option<Pace>),
}

/// The end of a phase: a terminal event, or the end of the motion without one.
enum PhaseEnd {
    Event(TerminalEvent),
    Motion(Status),
}

/// A simulation in progress.
pub(super) struct Run<'a> {
    contacts: &'a Arc<Contacts>,
    options: &'a Options,
    detector: EventDetector<'a>,
    track: Track,
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
}

impl<'a> Run<'a> {
    pub(super) fn new(
        contacts: &'a Arc<Contacts>,
        options: &'a Options,
        goal: Goal,
        start: Coordinates<f64>,
    ) -> Self {
        let stands = start.sin == 0.0 && goal.needs_time();
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
            track: Track::new(contacts, leading, goal.needs_track()),
            work: Work::default(),
            next: AfterEvent::EndState(Status::Failed),
            empty_phases: 0,
            steps_at_stiffness_test: 0,
            last_end: (f64::NAN, f64::NAN),
            last_event: None,
            landings: 0,
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
            if let Some(PhaseEnd::Motion(status)) = self.out_of_steps(report)
                && !matches!(self.next, AfterEvent::EndState(_))
            {
                return status;
            }
            match core::mem::replace(&mut self.next, AfterEvent::EndState(Status::Failed)) {
                AfterEvent::EndState(status) => return status,
                AfterEvent::Phase(phase, PhaseStart { u, .. }) if phase.is_level() => {
                    self.next = self.follow_level(phase, u, report);
                }
                AfterEvent::Phase(phase, phase_start) => {
                    self.next = match self.follow_phase(phase, &phase_start, report) {
                        PhaseEnd::Event(event) => self.after(event, &self.track.end()),
                        PhaseEnd::Motion(status) => AfterEvent::EndState(status),
                    }
                }
            }
        }
    }

    /// The terminal event of the last phase; `None` if no phase had one.
    pub(super) fn last_event(&self) -> Option<TerminalEvent> {
        self.last_event
    }

    pub(super) fn into_parts(self) -> (Track, Vec<Event>, Work) {
        (self.track, self.detector.into_events(), self.work)
    }

    /// Integrates one phase to its end.
    fn follow_phase(
        &mut self,
        phase: Phase,
        phase_start: &PhaseStart,
        report: &mut dyn FnMut(f64) -> ControlFlow<()>,
    ) -> PhaseEnd {
        if let Some(over) = self.out_of_steps(report) {
            return over;
        }
        let contacts = self.contacts;
        let (mut start, mut pace) = (*phase_start, None);
        loop {
            let phases = contacts.phases_from(start.u.t);
            let mechanics = phases.mechanics(phase, Clock::Regularized);
            let corner = contacts.corner_after(start.u.t);
            let Pace { clock, h } = match pace {
                Some(pace) => pace,
                None => match self.first_pace(&mechanics, phase, &mut start, corner) {
                    ControlFlow::Continue(Some(pace)) => pace,
                    ControlFlow::Continue(None) => continue,
                    ControlFlow::Break(over) => return over,
                },
            };
            let steps = Steps {
                run: self,
                mechanics: &mechanics,
                phase,
                clock,
                corner,
                start: start.u.into_array(),
                h,
                report,
            };
            match phases.solve(phase, clock, steps) {
                StepsEnd::Phase(over) => return over,
                StepsEnd::Continue(u, next) => {
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
        mechanics: &Mechanics<'_>,
        phase: Phase,
        start: &mut PhaseStart,
        corner: f64,
    ) -> ControlFlow<PhaseEnd, Option<Pace>> {
        self.detector.cut_steps_at(corner);
        let begun = self.slow_slip(mechanics, phase, start);
        self.detector.cut_steps_at(f64::INFINITY);
        let direction = None;
        match begun {
            ControlFlow::Continue((u, h)) => {
                *start = PhaseStart { u, direction };
                let h = h / mechanics.sundman_factor(&u);
                let clock = Clock::Regularized;
                ControlFlow::Continue(Some(Pace { clock, h }))
            }
            ControlFlow::Break(PhaseEnd::Event(TerminalEvent::Corner)) => {
                let u = self.track.end().u;
                *start = PhaseStart { u, direction };
                ControlFlow::Continue(None)
            }
            ControlFlow::Break(over) => ControlFlow::Break(over),
        }
    }

    fn out_of_steps(&self, report: &mut dyn FnMut(f64) -> ControlFlow<()>) -> Option<PhaseEnd> {
        if self.work.steps >= self.options.max_steps {
            return Some(PhaseEnd::Motion(Status::Failed));
        }
        if self.work.steps % 4096 == 4095 && report(self.track.end().t).is_break() {
            return Some(PhaseEnd::Motion(Status::Interrupted));
        }
        None
    }

    /// Continues from `u` with implicit steps while the system is stiff for explicit steps of size `h`. Returns
    /// the size of the next explicit step if any implicit steps were made.
    fn implicit_steps(
        &mut self,
        mechanics: &Mechanics<'_>,
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
        let dual = phases.mechanics(phase, Clock::Regularized);
        let before = self.work;
        let tolerance = self.options.step_tolerance();
        let mut implicit = Implicit::new(mechanics, &dual, u, tolerance);
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
            let error = found.as_ref().map_or(f64::INFINITY, |found| found.error);
            let accepted = found.filter(|found| found.error <= 1.0);
            match &accepted {
                Some(found) => implicit.accept(&found.dense),
                None => implicit.work.rejected += 1,
            }
            self.work = before + implicit.work;
            if let Some(Found { dense, .. }) = accepted {
                let record = StepRecord::polynomial(phase, dense.clone());
                if let Some(event) = self.detector.process(record, &dense, &mut self.track) {
                    return ControlFlow::Break(self.end_of_phase(event, h));
                }
                stepped = true;
            }
            // After a rejected step the step size grows only slowly for a while.
            let max_factor = if error > 1.0 { 1.0 } else { max_growth };
            max_growth = if error > 1.0 {
                1.2
            } else {
                (1.5 * max_growth).min(4.0)
            };
            h *= (0.8 / libm::pow(error.max(1e-9), 1.0 / 7.0)).clamp(0.25, max_factor);
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
        let at = self.track.end();
        let progressed = (at.t, at.yaw) != self.last_end;
        self.last_end = (at.t, at.yaw);
        if progressed && self.track.last_step() > 1e-9 * step {
            self.empty_phases = 0;
        } else {
            self.empty_phases += 1;
        }
        if self.empty_phases > MAX_EMPTY_PHASES {
            return PhaseEnd::Motion(Status::Failed);
        }
        PhaseEnd::Event(event)
    }

    /// Integrates the beginning of a phase in which dry slip is too slow for explicit steps. Returns the
    /// coordinates and the size of the first explicit step.
    fn slow_slip(
        &mut self,
        mechanics: &Mechanics<'_>,
        phase: Phase,
        phase_start: &PhaseStart,
    ) -> ControlFlow<PhaseEnd, (Coordinates<f64>, f64)> {
        let h = first_step(mechanics, &phase_start.u);
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
        let slow = onset::integrate(
            dry,
            mechanics,
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
            if let Some(event) = self.detector.process(record, &dense, &mut self.track) {
                return ControlFlow::Break(self.end_of_phase(event, h));
            }
            if self.slip_is_stopping(Phase::Sliding) {
                return ControlFlow::Break(self.end_of_phase(TerminalEvent::SlipEnd, h));
            }
        }
        ControlFlow::Continue((self.track.end().u, slow.h))
    }

    /// Whether a dry slip is about to stop so soon that its end is one straight step.
    fn slip_is_stopping(&self, phase: Phase) -> bool {
        phase == Phase::Sliding
            && self.contacts.dry().is_some_and(|dry| {
                let at = self.track.end().u;
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
            AfterEvent::EndState(status)
        };
        match event {
            TerminalEvent::Done => AfterEvent::EndState(Status::Finished),
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
                    self.track.push_jump(self.contacts.fallen_on_its_side(at));
                }
                AfterEvent::EndState(Status::Toppled)
            }
            TerminalEvent::Rest | TerminalEvent::StoppedRunning if self.contacts.moves() => {
                self.stand(at)
            }
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
            TerminalEvent::StoppedRunning if self.detector.has_spent_its_energy(at) => {
                end(self, EventKind::Rest, Status::AtRest)
            }
            TerminalEvent::Flat => self.land_flat(at),
            TerminalEvent::StoppedRunning => end(self, EventKind::FaceDown, Status::FaceDown),
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
                    return AfterEvent::EndState(Status::Failed);
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

    /// The motion after the whole base has come down flat at once.
    fn land_flat(&mut self, at: &Instant) -> AfterEvent {
        self.detector.add(EventKind::FaceDown, *at);
        let landing = self.landings;
        self.landings += 1;
        let Some(u) = landed(self.contacts, self.options, at, landing) else {
            return AfterEvent::EndState(Status::FaceDown);
        };
        let next = self.contacts.settle(&u);
        let after = Instant {
            phase: next.phase(),
            u,
        };
        if self.contacts.hardly_rocks(&u) {
            return self.stand(&after);
        }
        self.detector.process_jump(at, after);
        self.start_phase(next, u)
    }

    /// A body that stands flat from now on.
    fn stand(&mut self, at: &Instant) -> AfterEvent {
        let u = levelled(self.contacts, at);
        let is_standing = u.slip_speed() <= self.contacts.stopped_speed(&u);
        let phase = if is_standing {
            Phase::Standing
        } else {
            Phase::SlidingFlat
        };
        let u = with_loss(self.contacts, at, phase, u);
        self.detector.forget_direction();
        self.detector.add(EventKind::Stand, Instant { phase, u });
        let direction = None;
        AfterEvent::Phase(phase, PhaseStart { u, direction })
    }

    /// Follows a body whose base is level.
    fn follow_level(
        &mut self,
        phase: Phase,
        u: Coordinates<f64>,
        report: &mut dyn FnMut(f64) -> ControlFlow<()>,
    ) -> AfterEvent {
        let level = Level::new(self.contacts, u.yaw);
        let end = self.options.duration;
        let followed = match phase {
            Phase::Standing => self.follow_standing(&level, u, end, report),
            _ => self.follow_level_motion(&level, phase, u, end, report),
        };
        let (departure, u) = match followed {
            ControlFlow::Continue(departed) => departed,
            ControlFlow::Break(status) => return AfterEvent::EndState(status),
        };
        self.depart(&level, phase, departure, u)
    }

    /// Follows a body that stands until it departs.
    fn follow_standing(
        &mut self,
        level: &Level<'_>,
        u: Coordinates<f64>,
        end: f64,
        report: &mut dyn FnMut(f64) -> ControlFlow<()>,
    ) -> ControlFlow<Status, (Departure, Coordinates<f64>)> {
        let mut t = u.t;
        let stands_until = |run: &mut Self, t: f64| {
            let dense = Level::standing(&u, t);
            run.track
                .push(StepRecord::polynomial(Phase::Standing, dense));
            Coordinates { t, ..u }
        };
        let mut stretches = 0_usize;
        while let Some(ground) = self.contacts.ground() {
            stretches += 1;
            if stretches.is_multiple_of(4096) && report(t).is_break() {
                stands_until(self, t);
                return ControlFlow::Break(Status::Interrupted);
            }
            let corner = self.contacts.corner_after(t).min(end);
            if let Some(departure) = level.time_of_departure(ground, t, corner) {
                let u = stands_until(self, departure);
                return ControlFlow::Continue((level.departure_from_standing(departure), u));
            }
            t = corner;
            if t >= end {
                break;
            }
        }
        let u = stands_until(self, end);
        ControlFlow::Continue((Departure::Done, u))
    }

    /// Follows a body that slides flat or is level off the table, until it departs.
    fn follow_level_motion(
        &mut self,
        level: &Level<'_>,
        phase: Phase,
        mut u: Coordinates<f64>,
        end: f64,
        report: &mut dyn FnMut(f64) -> ControlFlow<()>,
    ) -> ControlFlow<Status, (Departure, Coordinates<f64>)> {
        let tolerance = self.options.step_tolerance();
        let k = self.contacts.parameters();
        let mut h = 1e-3 * (k.r / k.g).sqrt();
        while u.t < end {
            if let Some(PhaseEnd::Motion(status)) = self.out_of_steps(report) {
                return ControlFlow::Break(status);
            }
            let stretch = self.contacts.ground().map(|ground| ground.stretch(u.t));
            let corner = stretch.as_ref().map_or(end, |stretch| stretch.end.min(end));
            let motion = level.motion(phase, stretch);
            let Some(part) = motion.next_part(&u, corner, &mut h, tolerance) else {
                return ControlFlow::Break(Status::Failed);
            };
            self.work.steps += 1;
            u = Coordinates::from_array(&part.dense.end);
            self.track.push(StepRecord::polynomial(phase, part.dense));
            if let Some(departure) = part.departure {
                return ControlFlow::Continue((departure, u));
            }
        }
        ControlFlow::Continue((Departure::Done, u))
    }

    /// What follows where the motion of a level base changes.
    fn depart(
        &mut self,
        level: &Level<'_>,
        from: Phase,
        departure: Departure,
        u: Coordinates<f64>,
    ) -> AfterEvent {
        let (kind, phase, u) = match departure {
            Departure::Done => return AfterEvent::EndState(Status::Finished),
            Departure::Uplift => {
                let u = level.uplifted(&u, from);
                let next = self.contacts.settle(&u);
                let phase = next.phase();
                self.detector.add(EventKind::Uplift, Instant { phase, u });
                return self.start_phase_from(phase, next, u);
            }
            Departure::FallAway if !self.contacts.can_fly() => {
                self.detector
                    .add(EventKind::LiftOff, Instant { phase: from, u });
                return AfterEvent::EndState(Status::LiftedOff);
            }
            Departure::FallAway => (EventKind::LiftOff, Phase::FlyingLevel, u),
            Departure::Slide => {
                let u = level.beginning_to_slide(&u);
                (EventKind::Slip, Phase::SlidingFlat, u)
            }
            Departure::Stick => {
                let stopped = Coordinates {
                    slip_x: 0.0,
                    slip_y: 0.0,
                    ..u
                };
                (EventKind::Stick, Phase::Standing, stopped)
            }
            Departure::Land => {
                let u = self.contacts.landed_level(&u);
                let phase = if u.gap_rate > 0.0 {
                    Phase::FlyingLevel
                } else if u.slip_speed() > 0.0 {
                    Phase::SlidingFlat
                } else {
                    Phase::Standing
                };
                (EventKind::Land, phase, u)
            }
        };
        self.detector.add(kind, Instant { phase, u });
        self.empty_phases = if self.last_end == (u.t, u.yaw) {
            self.empty_phases + 1
        } else {
            0
        };
        self.last_end = (u.t, u.yaw);
        if self.empty_phases > MAX_EMPTY_PHASES {
            return AfterEvent::EndState(Status::Failed);
        }
        let direction = None;
        AfterEvent::Phase(phase, PhaseStart { u, direction })
    }

    /// Starts the next phase at `u` and adds the event of the change of contact.
    fn start_phase(&mut self, next: Transition, u: Coordinates<f64>) -> AfterEvent {
        self.start_phase_from(self.track.end().phase, next, u)
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
                return AfterEvent::EndState(Status::Painleve);
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

/// The explicit steps of a phase.
struct Steps<'r, 'a> {
    run: &'r mut Run<'a>,
    mechanics: &'r Mechanics<'r>,
    phase: Phase,
    clock: Clock,
    /// The next corner of the table's acceleration, s.
    corner: f64,
    start: [f64; COORDINATES],
    h: f64,
    report: &'r mut dyn FnMut(f64) -> ControlFlow<()>,
}

impl SystemVisitor for Steps<'_, '_> {
    type Output = StepsEnd;

    fn with<S: System<f64, N>, const N: usize>(self, system: &S) -> StepsEnd {
        let Steps {
            run,
            mechanics,
            phase,
            clock,
            corner,
            start: mut u,
            mut h,
            report,
        } = self;
        let tolerance = run.options.step_tolerance();
        let approach = Approach {
            mechanics,
            clock,
            corner,
        };
        let mut stepper = Stepper::new(system, leading(&u), h, tolerance);
        let mut before = run.work;
        loop {
            let since_test = run.work.steps - run.steps_at_stiffness_test;
            if N >= COORDINATES_AT_REST && since_test >= STIFFNESS_TEST_INTERVAL {
                run.work = before + stepper.work;
                let explicit = approach.regularized(&u, h);
                run.detector.cut_steps_at(corner);
                let implicit = run.implicit_steps(mechanics, phase, u, explicit, report);
                run.detector.cut_steps_at(f64::INFINITY);
                run.steps_at_stiffness_test = run.work.steps;
                match implicit {
                    ControlFlow::Break(PhaseEnd::Event(TerminalEvent::Corner)) => {
                        return StepsEnd::Continue(run.track.end().u, None);
                    }
                    ControlFlow::Break(over) => return StepsEnd::Phase(over),
                    ControlFlow::Continue(None) => stepper.work = Work::default(),
                    ControlFlow::Continue(Some(next)) if clock == Clock::Time => {
                        let pace = Pace {
                            clock: Clock::Regularized,
                            h: next,
                        };
                        return StepsEnd::Continue(run.track.end().u, Some(pace));
                    }
                    ControlFlow::Continue(Some(next)) => {
                        (u, h) = (run.track.end().u.into_array(), next);
                        stepper = Stepper::new(system, leading(&u), h, tolerance);
                    }
                }
                before = run.work;
            }
            if let Some(over) = run.out_of_steps(report) {
                return StepsEnd::Phase(over);
            }
            if let Some(pace) = approach.other_clock(&u, stepper.h) {
                run.work = before + stepper.work;
                return StepsEnd::Continue(Coordinates::from_array(&u), Some(pace));
            }
            let to_corner = approach.limit(&u, &mut stepper.h);
            let Ok(step) = stepper.advance() else {
                return StepsEnd::Phase(PhaseEnd::Motion(Status::Failed));
            };
            h = step.h;
            let at_corner = clock == Clock::Time && h == to_corner;
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
                run.track
                    .push(StepRecord::explicit((phase, clock), step, &u));
                None
            } else {
                let record = StepRecord::explicit((phase, clock), step, &u);
                let dense = step.dense(system).widened(&u);
                run.detector.process(record, &dense, &mut run.track)
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

/// How steps approach the next corner of the table's acceleration, at which one has to end.
///
/// With respect to τ or σ, the size of the step that ends there is not known before. So a step that comes near the
/// corner is made with respect to the time. In a near-collision, whose steps are far shorter than the time to the
/// corner, steps are made with respect to τ.
struct Approach<'a> {
    mechanics: &'a Mechanics<'a>,
    clock: Clock,
    /// The corner, s; infinite if there is none.
    corner: f64,
}

impl Approach<'_> {
    /// dt/dτ or dt/dσ.
    fn time_rate(&self, u: &[f64; COORDINATES]) -> f64 {
        let u = Coordinates::from_array(u);
        u.sin * self.mechanics.sundman_factor(&u)
    }

    /// A step of size h in the regularized variable.
    fn regularized(&self, u: &[f64; COORDINATES], h: f64) -> f64 {
        match self.clock {
            Clock::Regularized => h,
            Clock::Time => h / self.time_rate(u),
        }
    }

    /// A step of h seconds.
    fn in_time(&self, h: f64) -> Pace {
        let clock = Clock::Time;
        Pace { clock, h }
    }

    /// The pace of a step from `u` if it should be made with respect to the other variable.
    fn other_clock(&self, u: &[f64; COORDINATES], h: f64) -> Option<Pace> {
        // The fractions of the time to the corner beyond which the variable is changed. They differ, so that it does
        // not change to and fro.
        const NEAR: f64 = 0.25;
        const FAR: f64 = 0.02;
        if self.corner == f64::INFINITY {
            return (self.clock == Clock::Time).then(|| Pace {
                clock: Clock::Regularized,
                h: self.regularized(u, h),
            });
        }
        let remaining = self.corner - u[TIME];
        match self.clock {
            Clock::Regularized => {
                let h = h * self.time_rate(u);
                (h > NEAR * remaining).then(|| self.in_time(h))
            }
            Clock::Time => (h < FAR * remaining).then(|| Pace {
                clock: Clock::Regularized,
                h: self.regularized(u, h),
            }),
        }
    }

    /// Limits the size of a step with respect to the time. Returns the time to the corner.
    fn limit(&self, u: &[f64; COORDINATES], h: &mut f64) -> f64 {
        let remaining = self.corner - u[TIME];
        if self.clock == Clock::Time {
            // Two equal steps are better than a long and a very short one.
            *h = if *h >= remaining {
                remaining
            } else {
                h.min(0.5 * remaining)
            };
        }
        remaining
    }
}

/// A first guess for the step size.
fn first_step(mechanics: &Mechanics<'_>, u: &Coordinates<f64>) -> f64 {
    let h = mechanics.error_scale.first_step(u);
    if u.gap_rate > 0.0 {
        // A bounce lasts about 2v/g.
        let g = mechanics.dynamics.parameters().g;
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
) -> (Track, Status) {
    let mut run = Run::new(contacts, options, Goal::Passed(faded), start);
    let status = run.follow_to_the_end(&mut |_| ControlFlow::Continue(()));
    (run.track, status)
}
