//! The phases of a motion, one after another.

use super::contacts::{Contacts, Phase, SystemVisitor, Transition};
use super::events::{Event, EventKind, Goal, Switch, Watch};
use super::mechanics::{Mechanics, first};
use super::step_record::StepRecord;
use super::track::{Instant, Track};
use super::{FACE_DOWN_TILT, Options, Status, onset};
use crate::error_scale::{ErrorScale, max_brief_change};
use crate::law::Parameters;
use crate::solve::{Implicit, Stepper, System, Work};
use crate::state::{COORDINATES, Coordinates};
use core::f64::consts::PI;
use core::ops::ControlFlow;
use std::sync::Arc;

/// So many phases of no length one after another are no motion.
const MAX_EMPTY_PHASES: usize = 30;

/// A body in flight, level, and no farther from the table than this part of its radius lands flat.
const TOUCHING: f64 = 1e-12;

/// After so many explicit steps it is asked whether implicit ones would do better.
const STIFF_AFTER: usize = 64;

/// What follows a phase.
enum AfterEvent {
    Phase(Phase, PhaseStart),
    EndState(Status),
}

/// How a phase begins: where, and a slip from rest in which direction.
struct PhaseStart {
    u: Coordinates<f64>,
    direction: Option<[f64; 2]>,
}

/// What ends a phase.
enum PhaseEnd {
    By(Switch),
    For(Status),
}

/// A motion in the making.
pub(super) struct Run<'a> {
    contacts: &'a Contacts,
    options: &'a Options,
    watch: Watch<'a>,
    track: Track,
    work: Work,
    next: AfterEvent,
    empty_phases: usize,
    /// Time and yaw at which the last phase ended.
    last_end: (f64, f64),
    /// What the last phase ended by.
    last_switch: Option<Switch>,
}

impl<'a> Run<'a> {
    pub(super) fn new(
        contacts: &'a Arc<Contacts>,
        options: &'a Options,
        goal: Goal,
        start: Coordinates<f64>,
    ) -> Self {
        let next = contacts.settle(&start);
        let phase = match next {
            Transition::Roll => Phase::Rolling,
            Transition::Fly => Phase::Flying,
            Transition::Slide | Transition::BeginToSlip(_) | Transition::Paradox => Phase::Sliding,
        };
        let start = departing(next, start);
        let first = Instant { phase, u: start };
        let mut run = Run {
            contacts,
            options,
            watch: Watch::new(contacts, options, goal, &first),
            track: Track::new(contacts, first, goal.wants_the_way()),
            work: Work::default(),
            next: AfterEvent::EndState(Status::Failed),
            empty_phases: 0,
            last_end: (f64::NAN, f64::NAN),
            last_switch: None,
        };
        run.next = match run.watch.at_start(&first) {
            Some(switch) => run.after(switch, &first),
            None => run.going_on(next, start),
        };
        run
    }

    /// Follows the motion to its end.
    pub(super) fn follow_to_the_end(
        &mut self,
        report: &mut dyn FnMut(f64) -> ControlFlow<()>,
    ) -> Status {
        loop {
            if let Some(PhaseEnd::For(status)) = self.out_of_steps(report)
                && !matches!(self.next, AfterEvent::EndState(_))
            {
                return status;
            }
            match core::mem::replace(&mut self.next, AfterEvent::EndState(Status::Failed)) {
                AfterEvent::EndState(status) => return status,
                AfterEvent::Phase(phase, begin) => {
                    self.next = match self.follow(phase, &begin, report) {
                        PhaseEnd::By(switch) => self.after(switch, &self.track.end()),
                        PhaseEnd::For(status) => AfterEvent::EndState(status),
                    }
                }
            }
        }
    }

    /// What the last phase ended by; none where no phase ended by itself.
    pub(super) fn last_switch(&self) -> Option<Switch> {
        self.last_switch
    }

    pub(super) fn into_parts(self) -> (Track, Vec<Event>, Work) {
        (self.track, self.watch.into_events(), self.work)
    }

    /// Follows one phase to its end.
    fn follow(
        &mut self,
        phase: Phase,
        begin: &PhaseStart,
        report: &mut dyn FnMut(f64) -> ControlFlow<()>,
    ) -> PhaseEnd {
        if let Some(over) = self.out_of_steps(report) {
            return over;
        }
        let contacts = self.contacts;
        let mechanics = contacts.mechanics(phase);
        let (start, h) = match self.slip_slowly(&mechanics, phase, begin) {
            ControlFlow::Continue(begun) => begun,
            ControlFlow::Break(over) => return over,
        };
        let h = h / mechanics.sundman_factor(&start);
        let steps = Steps {
            run: self,
            mechanics: &mechanics,
            phase,
            start: start.into_array(),
            h,
            report,
        };
        contacts.solve(phase, steps)
    }

    fn out_of_steps(&self, report: &mut dyn FnMut(f64) -> ControlFlow<()>) -> Option<PhaseEnd> {
        if self.work.steps >= self.options.max_steps {
            return Some(PhaseEnd::For(Status::Failed));
        }
        if self.work.steps % 4096 == 4095 && report(self.track.end().t).is_break() {
            return Some(PhaseEnd::For(Status::Interrupted));
        }
        None
    }

    /// Where something relaxes so fast that it alone keeps explicit steps as short as `h`, goes on with
    /// implicit ones; gives a length for the next explicit step.
    fn relax(
        &mut self,
        mechanics: &Mechanics<'_>,
        phase: Phase,
        h: f64,
        report: &mut dyn FnMut(f64) -> ControlFlow<()>,
    ) -> ControlFlow<PhaseEnd, Option<f64>> {
        // Explicit steps are stable up to some 6 relaxations, and accurate rarely beyond 3.
        const STIFF: f64 = 4.0;
        const WORTH_IT: f64 = 20.0;
        let implicit = Implicit::new(mechanics, self.options.step_tolerance());
        let mut u = self.track.end().u.into_array();
        if h * implicit.relaxation(&u) < STIFF {
            return ControlFlow::Continue(None);
        }
        let mut next = None;
        let mut most_growth: f64 = 4.0;
        let mut h = WORTH_IT * h;
        loop {
            if let Some(over) = self.out_of_steps(report) {
                return ControlFlow::Break(over);
            }
            let found = implicit.step(&u, h);
            let error = found.as_ref().map_or(f64::INFINITY, |found| found.error);
            if let Some(found) = found.filter(|found| found.error <= 1.0) {
                self.work.steps += 1;
                u = found.dense.end;
                let dense = found.dense;
                let record = StepRecord::polynomial(phase, dense.clone());
                if let Some(switch) = self.watch.pass(record, &dense, &mut self.track) {
                    return ControlFlow::Break(self.over_by(switch, h));
                }
                next = Some(h);
            } else {
                self.work.rejected += 1;
            }
            // After a step that failed, none is tried that is much longer for a while.
            let most = if error > 1.0 { 1.0 } else { most_growth };
            most_growth = if error > 1.0 {
                1.2
            } else {
                (1.5 * most_growth).min(4.0)
            };
            h *= (0.8 / libm::pow(error.max(1e-9), 1.0 / 7.0)).clamp(0.25, most);
            let explicit = STIFF / implicit.relaxation(&u);
            if h.is_nan() || h <= WORTH_IT * explicit {
                return ControlFlow::Continue(next.map(|_| explicit));
            }
        }
    }

    /// Refuses to turn on the spot for ever.
    fn over_by(&mut self, switch: Switch, step: f64) -> PhaseEnd {
        // In the near-collision by itself time stands still, and only the yaw tells.
        let at = self.track.end();
        let somewhere = (at.t, at.yaw) != self.last_end;
        self.last_end = (at.t, at.yaw);
        if somewhere && self.track.last_step() > 1e-9 * step {
            self.empty_phases = 0;
        } else {
            self.empty_phases += 1;
        }
        if self.empty_phases > MAX_EMPTY_PHASES {
            return PhaseEnd::For(Status::Failed);
        }
        PhaseEnd::By(switch)
    }

    /// The part of a phase in which dry slip is too slow for explicit steps: from where they can go on,
    /// and with what step.
    fn slip_slowly(
        &mut self,
        mechanics: &Mechanics<'_>,
        phase: Phase,
        begin: &PhaseStart,
    ) -> ControlFlow<PhaseEnd, (Coordinates<f64>, f64)> {
        let h = first_step(mechanics, &begin.u);
        let Some(dry) = self.contacts.dry().filter(|_| phase == Phase::Sliding) else {
            return ControlFlow::Continue((begin.u, h));
        };
        let tolerance = self.options.step_tolerance();
        let speed = begin.u.slip_speed();
        let direction = begin
            .direction
            .unwrap_or_else(|| [begin.u.slip_x / speed, begin.u.slip_y / speed]);
        let from_rest = begin.direction.is_some();
        let h = 10.0 * h;
        let slow = onset::begin(dry, mechanics, &begin.u, direction, from_rest, h, tolerance);
        if slow.steps.is_empty() {
            let from = match begin.direction {
                // What cannot be followed from nothing may be from next to nothing.
                Some([x, y]) => {
                    let faint = 10.0 * self.contacts.stopped_speed(&begin.u);
                    Coordinates {
                        slip_x: faint * x,
                        slip_y: faint * y,
                        ..begin.u
                    }
                }
                None => begin.u,
            };
            return ControlFlow::Continue((from, 0.1 * h));
        }
        for dense in slow.steps {
            self.work.steps += 1;
            let h = dense.h;
            let record = StepRecord::polynomial(Phase::Sliding, dense.clone());
            if let Some(switch) = self.watch.pass(record, &dense, &mut self.track) {
                return ControlFlow::Break(self.over_by(switch, h));
            }
            if self.is_stopping(Phase::Sliding) {
                return ControlFlow::Break(self.over_by(Switch::Stop, h));
            }
        }
        ControlFlow::Continue((self.track.end().u, slow.h))
    }

    /// Whether what is left of a dry slip is too brief to be followed.
    fn is_stopping(&self, phase: Phase) -> bool {
        phase == Phase::Sliding
            && self.contacts.dry().is_some_and(|law| {
                let at = self.track.end().u;
                let tolerance = self.options.step_tolerance();
                let error_scale = ErrorScale::new(self.contacts.parameters());
                error_scale.slip_persists(&at, &law.rates(&at), 1.0, tolerance) < 0.0
            })
    }

    /// What follows the switch at which a phase has ended.
    fn after(&mut self, switch: Switch, at: &Instant) -> AfterEvent {
        self.last_switch = Some(switch);
        let end = |run: &mut Self, kind, status| {
            run.watch.note(kind, *at);
            AfterEvent::EndState(status)
        };
        match switch {
            Switch::Done => AfterEvent::EndState(Status::Finished),
            Switch::Topple => {
                self.watch.note(EventKind::Topple, *at);
                if self.contacts.falls_on_its_side(at) {
                    self.track.push_jump(self.contacts.fallen_on_its_side(at));
                }
                AfterEvent::EndState(Status::Toppled)
            }
            Switch::Rest => end(self, EventKind::Rest, Status::AtRest),
            Switch::Paradox => end(self, EventKind::Painleve, Status::Painleve),
            Switch::Flat if at.phase == Phase::Flying => {
                let k = self.contacts.parameters();
                let u = past_upright(k, at);
                // The other side of the rim comes down on the table just as this one leaves it.
                if u.gap < TOUCHING * k.r && u.gap_rate < 0.0 {
                    return end(self, EventKind::FaceDown, Status::FaceDown);
                }
                let phase = Phase::Flying;
                self.watch.note_jump(at, Instant { phase, u });
                let direction = None;
                AfterEvent::Phase(phase, PhaseStart { u, direction })
            }
            Switch::StoppedRunning if self.watch.has_spent_its_energy(at) => {
                end(self, EventKind::Rest, Status::AtRest)
            }
            Switch::Flat | Switch::StoppedRunning => {
                end(self, EventKind::FaceDown, Status::FaceDown)
            }
            Switch::LiftOff if !self.contacts.can_fly() => {
                end(self, EventKind::LiftOff, Status::LiftedOff)
            }
            Switch::LiftOff => self.going_on(Transition::Fly, at.u),
            Switch::Break => {
                let next = match self.contacts.begin_to_slip(at) {
                    // It was only just about to.
                    Transition::Paradox if self.contacts.friction_cone_margin(at) > 0.0 => {
                        Transition::Roll
                    }
                    next => next,
                };
                self.going_on(next, at.u)
            }
            Switch::Stop => {
                let stopped = stopped(self.contacts, at, self.options.step_tolerance());
                let next = self.contacts.settle(&stopped);
                self.going_on(next, stopped)
            }
            Switch::Land => {
                let Some((landed, next)) = self.contacts.land(at) else {
                    return AfterEvent::EndState(Status::Failed);
                };
                let phase = match next {
                    Transition::Fly => Phase::Flying,
                    Transition::Roll => Phase::Rolling,
                    _ => Phase::Sliding,
                };
                let after = Instant { phase, u: landed };
                self.watch.note(EventKind::Land, after);
                self.watch.note_jump(at, after);
                self.going_on(next, landed)
            }
        }
    }

    /// Begins the phase that is next, at `u`, and notes that the contact changes.
    fn going_on(&mut self, next: Transition, u: Coordinates<f64>) -> AfterEvent {
        let before = self.track.end().phase;
        let u = departing(next, u);
        let (phase, kind) = match next {
            Transition::Roll => (Phase::Rolling, EventKind::Stick),
            Transition::Slide | Transition::BeginToSlip(_) => (Phase::Sliding, EventKind::Slip),
            Transition::Fly => (Phase::Flying, EventKind::LiftOff),
            Transition::Paradox => {
                let phase = Phase::Sliding;
                self.watch.note(EventKind::Painleve, Instant { phase, u });
                return AfterEvent::EndState(Status::Painleve);
            }
        };
        if phase != before {
            self.watch.note(kind, Instant { phase, u });
        }
        let direction = match next {
            Transition::BeginToSlip(direction) => Some(direction),
            _ => None,
        };
        AfterEvent::Phase(phase, PhaseStart { u, direction })
    }
}

/// The coordinates where a slip begins tell its direction, and with it the forces there: they get a
/// slip that is too small to move anything.
fn departing(next: Transition, u: Coordinates<f64>) -> Coordinates<f64> {
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
    start: [f64; COORDINATES],
    h: f64,
    report: &'r mut dyn FnMut(f64) -> ControlFlow<()>,
}

impl SystemVisitor for Steps<'_, '_> {
    type Output = PhaseEnd;

    fn with<S: System<f64, N>, const N: usize>(self, system: &S) -> PhaseEnd {
        let Steps {
            run,
            mechanics,
            phase,
            start,
            h,
            report,
        } = self;
        let tolerance = run.options.step_tolerance();
        let mut stepper = Stepper::new(system, first(&start), h, tolerance);
        let mut before = run.work;
        loop {
            if let Some(over) = run.out_of_steps(report) {
                return over;
            }
            let Ok(step) = stepper.advance() else {
                return PhaseEnd::For(Status::Failed);
            };
            let h = step.h;
            let switch = if run.watch.is_uneventful(phase, step) {
                run.track.push(StepRecord::explicit(phase, step, &start));
                None
            } else {
                let record = StepRecord::explicit(phase, step, &start);
                let dense = step.dense(system).widened(&start);
                run.watch.pass(record, &dense, &mut run.track)
            };
            run.work = before + stepper.work;
            if let Some(switch) = switch {
                return run.over_by(switch, h);
            }
            run.empty_phases = 0;
            if run.is_stopping(phase) {
                return PhaseEnd::By(Switch::Stop);
            }
            if N == COORDINATES && stepper.work.steps.is_multiple_of(STIFF_AFTER) {
                match run.relax(mechanics, phase, h, report) {
                    ControlFlow::Break(over) => return over,
                    ControlFlow::Continue(None) => {}
                    ControlFlow::Continue(Some(h)) => {
                        let u = run.track.end().u.into_array();
                        stepper = Stepper::new(system, first(&u), h, tolerance);
                        before = run.work;
                    }
                }
            }
        }
    }
}

/// A first guess for the length of a step.
fn first_step(mechanics: &Mechanics<'_>, u: &Coordinates<f64>) -> f64 {
    let h = mechanics.error_scale.first_step(u);
    if u.gap_rate > 0.0 {
        // A bounce lasts 2v/g or so.
        let g = mechanics.law.parameters().g;
        return h.min(0.1 * u.gap_rate / (g * u.sin));
    }
    h
}

/// Where a dry slip that is about to stop has stopped: the last of it goes at the rate at which it stops.
pub(crate) fn stopped(
    contacts: &Contacts,
    at: &Coordinates<f64>,
    tolerance: f64,
) -> Coordinates<f64> {
    let rates = contacts.dynamics(Phase::Sliding).rates(at);
    let stopping = -(rates.slip_x * at.slip_x + rates.slip_y * at.slip_y);
    let time = (at.slip_x * at.slip_x + at.slip_y * at.slip_y) / stopping;
    // Where it stops so slowly that all else would change meanwhile, it counts as stopped now.
    let rate = ErrorScale::new(contacts.parameters()).rate(at);
    let is_brief = stopping > 0.0 && time * rate <= max_brief_change(tolerance);
    Coordinates {
        slip_x: 0.0,
        slip_y: 0.0,
        ..at.plus(if is_brief { time } else { 0.0 }, &rates)
    }
}

/// The same position and motion with the tilt on the other side of upright, (ψ, −φ, θ) =
/// (ψ ± π, φ, θ ∓ π): in a flight through upright the lowest point of the rim changes sides, and its
/// velocity with it. The yaw goes on the way it turns, as it would just beside upright, so that mirror images
/// stay mirror images; a flight in a plane has no such way, and takes +π.
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

/// Follows the near-collision by itself, where sin φ = 0 and time stands still: from `start` until |w|
/// has fallen to `faded` (rad/s) as the body rises.
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
