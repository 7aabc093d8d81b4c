//! The phases in which the base is level, and what leads to them and from them.

use super::flat_landing::{fallen_flat, landed, last_fall, with_loss};
use super::{AfterEvent, MAX_EMPTY_PHASES, PhaseEnd, PhaseStart, Run};
use crate::ending::Status;
use crate::motion::event::EventKind;
use crate::motion::flat_landing::{FlatLanding, on_face_of};
use crate::motion::instant::{Instant, LEVEL_PHASES, Phase};
use crate::motion::level_base::LevelMotion;
use crate::motion::level_base::{Departure, LevelBase, levelled};
use crate::motion::step_record::StepRecord;
use crate::real::Dual;
use crate::state::{Coordinates, TIME};
use core::ops::ControlFlow;

/// The length of a search for the moment at which a body that stands departs, in periods of a pulse.
const PERIODS_IN_WINDOW: f64 = 4.0;

/// The number of such searches from one report to the next.
const REPORT_INTERVAL: usize = 256;

impl Run<'_> {
    /// The motion after the whole base has come down flat at once.
    pub(super) fn land_flat(&mut self, at: &Instant) -> AfterEvent {
        // Without the feature `ground`, every motion ends here.
        if !LEVEL_PHASES {
            self.detector.add(EventKind::FaceDown, *at);
            return AfterEvent::End(Status::FaceDown);
        }
        let (fallen, side) = fallen_flat(self.contacts, at);
        // A body that has only just begun to rock lands with rounding errors alone.
        if self.contacts.moves() && self.contacts.hardly_rocks(&fallen) {
            return self.stand(at);
        }
        self.detector.add(EventKind::FaceDown, *at);
        let landing = self.landings;
        self.landings += 1;
        let landed = landed(self.contacts, self.options, (&fallen, side), landing);
        let Some(u) = landed.filter(|_| !self.contacts.turns_on_other_face(at)) else {
            return AfterEvent::End(Status::FaceDown);
        };
        let u = on_face_of(at, &u);
        let next = self.contacts.settle(&u);
        let after = Instant {
            phase: next.phase(),
            u,
        };
        if self.contacts.hardly_rocks(&after) || self.contacts.stays_below_gap(&after) {
            return self.stand(&after);
        }
        self.detector.process_jump(at, after);
        self.start_phase(next, u)
    }

    /// The motion after resistance has stopped the contact point, so that the base comes down flat. What the option `flat`
    /// says follows, except where the body comes to rest.
    pub(super) fn land_stopped(&mut self, at: &Instant) -> AfterEvent {
        let at = &self.on_table(at);
        let moves = self.contacts.moves();
        let comes_to_rest = match self.options.flat {
            FlatLanding::Stop if !moves => self.detector.has_spent_its_energy(at),
            FlatLanding::Stop | FlatLanding::Smooth(_) => self.contacts.holds_contact_point(at),
            FlatLanding::Housner | FlatLanding::Restitution(_) => false,
        };
        if comes_to_rest && !moves {
            self.detector.add(EventKind::Rest, *at);
            return AfterEvent::End(Status::AtRest);
        }
        if moves && self.contacts.hardly_rocks(at) {
            return self.stand(at);
        }
        if self.options.flat == FlatLanding::Stop && !moves {
            return self.land_flat(at);
        }
        let mut fall = last_fall(self.contacts, at);
        let end = self.options.duration;
        let is_over = fall.end[TIME] >= end;
        if is_over {
            fall = fall.cut(fall.fraction_where(TIME, end));
            fall.end[TIME] = end;
        }
        self.trajectory.push(StepRecord::polynomial(at.phase, fall));
        let landed = self.trajectory.end();
        if is_over {
            AfterEvent::End(Status::Finished)
        } else if comes_to_rest {
            self.stand(&landed)
        } else {
            match (self.land_flat(&landed), self.options.flat) {
                // Running round the rim would lift it off the table.
                (AfterEvent::End(Status::FaceDown), FlatLanding::Smooth(_)) => self.stand(&landed),
                (next, _) => next,
            }
        }
    }

    /// A rim that is off the table by less than its errors slides.
    fn on_table(&self, at: &Instant) -> Instant {
        if at.phase != Phase::Flying {
            return *at;
        }
        let phase = Phase::Sliding;
        let (gap, gap_rate) = (0.0, 0.0);
        let u = Coordinates {
            gap,
            gap_rate,
            ..at.u
        };
        let u = with_loss(self.contacts, at, phase, u);
        Instant { phase, u }
    }

    /// A body that stands flat from now on.
    pub(super) fn stand(&mut self, at: &Instant) -> AfterEvent {
        let dynamics = self.contacts.dynamics(at.phase);
        let slides = at.phase != Phase::Rolling;
        let u = levelled(at, slides.then(|| dynamics.center_velocity(at)));
        let is_standing = u.slip_speed() <= self.contacts.stopped_speed(&u);
        let phase = if is_standing {
            Phase::Standing
        } else {
            Phase::SlidingFlat
        };
        // A body that stands does not move at all, not even within rounding.
        let slip = |slip: f64| if is_standing { 0.0 } else { slip };
        let (slip_x, slip_y) = (slip(u.slip_x), slip(u.slip_y));
        let u = with_loss(
            self.contacts,
            at,
            phase,
            Coordinates {
                slip_x,
                slip_y,
                ..u
            },
        );
        self.detector.forget_direction();
        self.detector.add(EventKind::Stand, Instant { phase, u });
        let direction = None;
        AfterEvent::Phase(phase, PhaseStart { u, direction })
    }

    /// Follows a body whose base is level.
    pub(super) fn follow_level(
        &mut self,
        phase: Phase,
        u: Coordinates<f64>,
        report: &mut dyn FnMut(f64) -> ControlFlow<()>,
    ) -> AfterEvent {
        let level = LevelBase::new(self.contacts, u.yaw);
        let end = self.options.duration;
        let followed = match phase {
            Phase::Standing => self.follow_standing(&level, u, end, report),
            _ => self.follow_level_motion(&level, phase, u, end, report),
        };
        let (departure, u) = match followed {
            ControlFlow::Continue(departed) => departed,
            ControlFlow::Break(status) => return AfterEvent::End(status),
        };
        self.depart(&level, phase, departure, u)
    }

    /// Follows a body that stands until it departs.
    fn follow_standing(
        &mut self,
        level: &LevelBase<'_>,
        u: Coordinates<f64>,
        end: f64,
        report: &mut dyn FnMut(f64) -> ControlFlow<()>,
    ) -> ControlFlow<Status, (Departure, Coordinates<f64>)> {
        let mut t = u.t;
        let stands_until = |run: &mut Self, t: f64| {
            let dense = LevelBase::standing(&u, t);
            run.trajectory
                .push(StepRecord::polynomial(Phase::Standing, dense));
            Coordinates { t, ..u }
        };
        let mut windows = 0_usize;
        while let Some(ground) = self.contacts.ground() {
            windows += 1;
            if windows.is_multiple_of(REPORT_INTERVAL) && report(t).is_break() {
                stands_until(self, t);
                return ControlFlow::Break(Status::Interrupted);
            }
            let corner = self.contacts.corner_after(t).min(end);
            let window = corner.min(t + PERIODS_IN_WINDOW * ground.shortest_period(t));
            if window < corner {
                // A pulse whose period is tiny beside the motion would be searched for hours.
                self.work.steps += 1;
                if self.work.steps >= self.options.max_steps {
                    stands_until(self, t);
                    return ControlFlow::Break(Status::Failed);
                }
            }
            if let Some(departure) = level.time_of_departure(ground, t, window) {
                let u = stands_until(self, departure);
                return ControlFlow::Continue((level.departure_from_standing(departure), u));
            }
            t = window;
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
        level: &LevelBase<'_>,
        phase: Phase,
        mut u: Coordinates<f64>,
        end: f64,
        report: &mut dyn FnMut(f64) -> ControlFlow<()>,
    ) -> ControlFlow<Status, (Departure, Coordinates<f64>)> {
        let tolerance = self.options.step_tolerance();
        let k = self.contacts.parameters();
        let contacts = self.contacts;
        let dual_phases = contacts.dual_phases_from(u.t);
        let longest = 1e-3 * (k.r / k.g).sqrt();
        // The first landing is sought after a moment in which the base is off the table.
        let mut h = longest.min(level.bounce_time(&u));
        while u.t < end {
            if let Some(PhaseEnd::Motion(status)) = self.out_of_steps(report) {
                return ControlFlow::Break(status);
            }
            let stretch = contacts.ground().map(|ground| ground.stretch(u.t));
            let corner = stretch.as_ref().map_or(end, |stretch| stretch.end.min(end));
            let yaw = Dual::from(u.yaw);
            let dual = LevelMotion::new(&dual_phases, phase, yaw, stretch.clone(), 1.0.into());
            let motion = level.motion(phase, stretch);
            let Some(part) = motion.next_part(&u, corner, &mut h, tolerance, &dual) else {
                return ControlFlow::Break(Status::Failed);
            };
            self.work = self.work + part.work;
            u = Coordinates::from_array(&part.dense.end);
            self.trajectory
                .push(StepRecord::polynomial(phase, part.dense));
            if let Some(departure) = part.departure {
                return ControlFlow::Continue((departure, u));
            }
        }
        ControlFlow::Continue((Departure::Done, u))
    }

    /// What follows where the motion of a level base changes.
    fn depart(
        &mut self,
        level: &LevelBase<'_>,
        from: Phase,
        departure: Departure,
        u: Coordinates<f64>,
    ) -> AfterEvent {
        let (kind, phase, u) = match departure {
            Departure::Done => return AfterEvent::End(Status::Finished),
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
                return AfterEvent::End(Status::LiftedOff);
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
            return AfterEvent::End(Status::Failed);
        }
        let direction = None;
        AfterEvent::Phase(phase, PhaseStart { u, direction })
    }
}
