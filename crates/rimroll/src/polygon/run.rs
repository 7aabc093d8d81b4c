//! Follows a motion from phase to phase.

use super::body::PolygonalBody;
use super::event_detector::{EventDetector, StepEvent, touching, touching_gap};
use super::impact::{self, AfterImpact, Allowed};
use super::motion::{self, Instant, PolygonEvent, PolygonEventKind, PolygonMotion, StepRecord};
use super::pose::{COORDINATES, Pose, SUPPORTED};
use super::support::{Support, SupportedBody};
use super::{dot, length};
use crate::ending::Status;
use crate::error::{InvalidInput, bounded, positive};
use crate::law::IdealLaw;
use crate::motion::STANDARD_GRAVITY;
use crate::solve::{Dense, Stepper, Stuck, Work};
use crate::state::State;
use core::f64::consts::{FRAC_PI_2, PI};
use core::ops::ControlFlow;

/// A corner that would rise by less than this many times the height that counts as touching, and fall back, stays.
const HOP: f64 = 10.0;

/// A start that loses less than this fraction of the kinetic energy is no impact.
const LOSSLESS: f64 = 1e-12;

/// A body whose energy over rest is below this fraction of mgR stands.
const SPENT: f64 = 1e-10;

/// Options of a simulation of a body with corners.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PolygonOptions {
    /// The duration of the motion, s.
    pub duration: f64,
    /// g, m/s².
    pub gravity: f64,
    /// The target error, relative to the size of each quantity. A step may have a fiftieth of it.
    pub rtol: f64,
    /// The tilt at which the body counts as toppled, rad.
    pub topple_tilt: f64,
    /// The maximal number of steps and impacts.
    pub max_steps: usize,
    /// e, the coefficient of restitution of impacts, from 0 (plastic) to 1.
    pub restitution: f64,
}

impl Default for PolygonOptions {
    fn default() -> Self {
        PolygonOptions {
            duration: 2.0,
            gravity: STANDARD_GRAVITY,
            rtol: 1e-10,
            topple_tilt: FRAC_PI_2,
            max_steps: 1_000_000,
            restitution: 0.0,
        }
    }
}

impl PolygonOptions {
    fn check(&self) -> Result<(), InvalidInput> {
        positive("duration", self.duration, "s")?;
        positive("gravity", self.gravity, "m/s2")?;
        let fine = |rtol| (1e-14..=1e-3).contains(&rtol);
        bounded("rtol", self.rtol, fine, "between 1e-14 and 1e-3", "")?;
        let low = |tilt| tilt > 0.0 && tilt <= FRAC_PI_2;
        bounded(
            "topple_tilt",
            self.topple_tilt,
            low,
            "inside (0, pi/2]",
            "rad",
        )?;
        bounded(
            "max_steps",
            self.max_steps as f64,
            |steps| steps >= 1.0,
            ">= 1",
            "",
        )?;
        let part = |e| (0.0..=1.0).contains(&e);
        bounded("restitution", self.restitution, part, "between 0 and 1", "")?;
        Ok(())
    }

    fn step_tolerance(&self) -> f64 {
        (0.02 * self.rtol).max(5e-15)
    }
}

/// The motion of a body with corners from a start: with the centre of mass above the origin and, without friction, at
/// rest except for its fall. At spin 0 corner 0 is the lowest; at spin π/n the body leans over an edge. `watch` receives the
/// time reached after each step and may stop the computation.
///
/// # Errors
/// Refuses options and starts outside their bounds, in particular a tilt of 0.
pub fn simulate(
    body: &PolygonalBody,
    start: &State,
    law: IdealLaw,
    options: &PolygonOptions,
    watch: impl FnMut(f64) -> ControlFlow<()>,
) -> Result<PolygonMotion, InvalidInput> {
    options.check()?;
    start.check()?;
    check_tilt(body, start.tilt, options.topple_tilt)?;
    let mut run = Run::new(body, start, law, options);
    let status = match run.begin() {
        Some(status) => status,
        None => run.follow(watch),
    };
    let turns = motion::turns(&run.first, &run.events, &run.now);
    Ok(PolygonMotion {
        body: *body,
        start: run.first,
        segments: run.segments,
        events: run.events,
        turns,
        status,
        work: run.work,
    })
}

/// A body with corners stands on its base. At a tilt of 90° only one of height 0 does, which then rolls on its side; any
/// other one lies along its length.
fn check_tilt(body: &PolygonalBody, tilt: f64, topple_tilt: f64) -> Result<(), InvalidInput> {
    let round = body.round();
    if topple_tilt < FRAC_PI_2 {
        let bound = "below topple_tilt, which can be at most pi/2";
        return bounded("tilt", tilt, |tilt| tilt < topple_tilt, bound, "rad").map(|_| ());
    }
    let stands = |tilt| tilt < FRAC_PI_2 || tilt == FRAC_PI_2 && round.height() == 0.0;
    let bound = "below pi/2, where a body with corners lies on its side; only one of height 0 can start at pi/2";
    bounded("tilt", tilt, stands, bound, "rad").map(|_| ())
}

/// A simulation in progress.
struct Run<'a> {
    options: &'a PolygonOptions,
    first: Instant,
    now: Instant,
    segments: Vec<StepRecord>,
    events: Vec<PolygonEvent>,
    work: Work,
}

impl<'a> Run<'a> {
    fn new(
        body: &PolygonalBody,
        start: &State,
        law: IdealLaw,
        options: &'a PolygonOptions,
    ) -> Run<'a> {
        let pose = Pose::from_state(start);
        let lowest = libm::rint(-start.spin / body.corner_angle()) as i64;
        let supported = SupportedBody::new(body, law, options.gravity, Support::Corner(lowest));
        let now = Instant {
            t: 0.0,
            pose,
            supported,
            anchor: supported.anchor(&pose, [0.0; 2]),
            lost: 0.0,
        };
        Run {
            options,
            first: now,
            now,
            segments: Vec::new(),
            events: Vec::new(),
            work: Work::default(),
        }
    }

    /// Chooses the support where two corners are the lowest at the start. If they cannot both be at rest, the start is an
    /// impact.
    fn begin(&mut self) -> Option<Status> {
        let Instant {
            supported, pose, ..
        } = self.now;
        let touching = touching(&supported, &pose, supported.support.corner());
        let radius = supported.body.round().radius();
        let still = 1e-12 * radius * (length(pose.rate) + supported.falling_rate);
        let rate = |&k: &i64| supported.gap(&pose, k).1;
        if touching[1..].iter().all(|k| rate(k) > still) {
            return None;
        }
        let sinking = touching.iter().copied().find(|k| rate(k) < -still);
        match (touching.len(), sinking) {
            (2, Some(corner)) => {
                self.carry(self.on(Support::Corner(corner)), pose);
                self.first = self.now;
                None
            }
            (2, None) => self.begin_on_edge(&touching),
            _ => {
                let status = self.touch(&touching, true);
                self.forget_lossless_start();
                status
            }
        }
    }

    /// A start over an edge of which neither corner rises. The middle of the edge is at rest, as the corner is in other starts. If
    /// the body turns about the vertical, the ends of the edge move, and friction stops them in an impact. Which corner that leaves
    /// depends on the sense of the turning, not on the rounding of the spin.
    fn begin_on_edge(&mut self, touching: &[i64]) -> Option<Status> {
        let pose = self.now.pose;
        let left = touching[0].min(touching[1]);
        self.carry(self.on(Support::Edge(left)), pose);
        self.first = self.now;
        let Instant {
            supported, pose, ..
        } = self.now;
        let struck = |allowed| impact::plastic(&supported, &pose, touching, allowed);
        let stays = |after: &AfterImpact| {
            let kinetic = supported.kinetic(&pose);
            kinetic - after.supported.kinetic(&after.pose) <= LOSSLESS * kinetic
        };
        let after = struck(Allowed::Together)
            .filter(stays)
            .or_else(|| struck(Allowed::Any));
        let status = self.strike(after);
        self.forget_lossless_start();
        status
    }

    /// Without a loss nothing has struck the table: the body lay on the edge.
    fn forget_lossless_start(&mut self) {
        let kinetic = self.first.supported.kinetic(&self.first.pose);
        self.events.retain(|event| event.loss > LOSSLESS * kinetic);
        if self.events.is_empty() {
            self.first = self.now;
        }
    }

    /// The body on another support.
    fn on(&self, support: Support) -> SupportedBody {
        let supported = &self.now.supported;
        SupportedBody::new(&supported.body, supported.law, supported.gravity, support)
    }

    /// Goes on from `pose` on another support.
    fn carry(&mut self, supported: SupportedBody, pose: Pose) {
        let center = self.now.supported.center(&self.now.pose, self.now.anchor);
        let pose = pose.normalised();
        self.now = Instant {
            pose,
            supported,
            anchor: supported.anchor(&pose, center),
            ..self.now
        };
    }

    fn follow(&mut self, mut watch: impl FnMut(f64) -> ControlFlow<()>) -> Status {
        loop {
            if let Some(status) = self.phase(&mut watch) {
                return status;
            }
        }
    }

    /// Follows the motion to the end of the phase, and returns the status if it ends there.
    fn phase(&mut self, watch: &mut impl FnMut(f64) -> ControlFlow<()>) -> Option<Status> {
        if let Support::Face(_) = self.now.supported.support {
            self.segments.push(StepRecord::jump(&self.now));
            return Some(Status::AtRest);
        }
        let system = self.now.supported;
        let mut supported = system;
        let rate = length(self.now.pose.rate) + supported.falling_rate;
        let tolerance = self.options.step_tolerance();
        let mut stepper = Steps::new(&system, &self.now.pose, 0.01 / rate, tolerance);
        let before = self.work;
        loop {
            if before.steps + stepper.work().steps + self.events.len() >= self.options.max_steps {
                return Some(Status::Failed);
            }
            if watch(self.now.t).is_break() {
                return Some(Status::Interrupted);
            }
            let Ok(dense) = stepper.advance() else {
                return Some(Status::Failed);
            };
            self.work = before + stepper.work();
            let left = (self.options.duration - self.now.t) / dense.h;
            let mut segment = StepRecord {
                t: self.now.t,
                until: left.min(1.0),
                dense,
                supported,
                anchor: self.now.anchor,
                lost: self.now.lost,
            };
            let found = EventDetector {
                supported: &supported,
                dense: &segment.dense,
                until: segment.until,
                topple_tilt: self.options.topple_tilt,
            }
            .events();
            let whole = segment.until;
            for &(x, event) in &found {
                match event {
                    StepEvent::TiltMax => {
                        self.record(&segment, x / whole, PolygonEventKind::TiltMax)
                    }
                    StepEvent::TiltMin => {
                        self.record(&segment, x / whole, PolygonEventKind::TiltMin)
                    }
                    _ => segment.until = x,
                }
            }
            self.now = segment.at(1.0);
            if supported.support.is_flight() {
                supported = supported.with_lowest(&self.now.pose);
                self.now.supported = supported;
            }
            // A support that cannot carry the body for any time leaves no node once another follows.
            self.segments.pop_if(|last| last.until == 0.0);
            self.segments.push(segment);
            match found.last() {
                Some(&(_, event)) if event.ends_phase() => return self.after(event),
                _ if left <= 1.0 => {
                    self.now.t = self.options.duration;
                    return Some(Status::Finished);
                }
                _ => {}
            }
        }
    }

    fn record(&mut self, segment: &StepRecord, fraction: f64, kind: PolygonEventKind) {
        let at = segment.at(fraction);
        self.events.push(PolygonEvent {
            kind,
            at,
            loss: 0.0,
        });
    }

    /// What follows an event that ends a phase; the status if the motion ends.
    fn after(&mut self, event: StepEvent) -> Option<Status> {
        let Instant {
            supported, pose, ..
        } = self.now;
        let (kind, status) = match event {
            StepEvent::Touch(corner) => {
                return self.touch(&touching(&supported, &pose, corner), false);
            }
            StepEvent::Release(which) => {
                let k = supported.support.corner();
                self.carry(self.on(Support::Corner(k + 1 - which as i64)), pose);
                (PolygonEventKind::CornerLift, None)
            }
            StepEvent::Topple => (PolygonEventKind::Topple, Some(Status::Toppled)),
            _ => {
                let (flying, pose) =
                    supported.released(&pose, pose.rate, supported.velocity(&pose));
                // Without slip, a corner that would have to be pulled down may go down when its friction ceases.
                let leaves = |&k: &i64| flying.gap_acceleration(&pose, k) >= 0.0;
                let slips = supported.law == IdealLaw::Frictionless;
                if !slips && !supported.corners().iter().all(leaves) {
                    return Some(self.lift_off());
                }
                self.carry(flying, pose);
                (PolygonEventKind::LiftOff, None)
            }
        };
        self.events.push(PolygonEvent {
            kind,
            at: self.now,
            loss: 0.0,
        });
        status
    }

    /// The end, where a corner can neither stay on the table nor leave it.
    fn lift_off(&mut self) -> Status {
        self.events.push(PolygonEvent {
            kind: PolygonEventKind::LiftOff,
            at: self.now,
            loss: 0.0,
        });
        Status::LiftedOff
    }

    /// An impact, or corners that come to rest on the table without one. A body that rocks on an edge from end to end with
    /// ever smaller impacts comes to rest on it: the endless sequence ends where hops are lost in rounding.
    fn touch(&mut self, touching: &[i64], is_slow: bool) -> Option<Status> {
        let Instant {
            supported, pose, ..
        } = self.now;
        let pose = pose.normalised();
        let free = impact::resolve(&supported, &pose, touching, self.options.restitution);
        let chatters = |after: &AfterImpact| {
            let down = after.supported.corners();
            let others = touching.iter().filter(|k| !down.contains(k));
            let can_hop = matches!(
                after.supported.support,
                Support::Corner(_) | Support::Flight(_)
            );
            can_hop && others.clone().all(|&k| hops_back(after, k))
        };
        let after = if is_slow || free.as_ref().is_some_and(chatters) {
            impact::plastic(&supported, &pose, touching, Allowed::Together).or(free)
        } else {
            free
        };
        self.strike(after)
    }

    /// An impact with this outcome.
    fn strike(&mut self, after: Option<AfterImpact>) -> Option<Status> {
        let Some(after) = after else {
            return Some(self.lift_off());
        };
        let before = self.now.supported.kinetic(&self.now.pose.normalised());
        self.carry(after.supported, after.pose);
        if self.is_spent() {
            let rate = match self.now.supported.law {
                IdealLaw::NoSlip => [0.0; 3],
                IdealLaw::Frictionless => [0.0, 0.0, self.now.pose.rate[2]],
            };
            let corner = self.now.supported.support.corner();
            self.carry(
                self.on(Support::Face(corner)),
                Pose {
                    rate,
                    ..self.now.pose
                },
            );
        }
        let loss = before - self.now.supported.kinetic(&self.now.pose);
        self.now.lost += loss;
        self.events.push(PolygonEvent {
            kind: PolygonEventKind::Impact,
            at: self.now,
            loss,
        });
        None
    }

    /// Whether next to no energy is left for further rocking.
    fn is_spent(&self) -> bool {
        let Instant {
            supported, pose, ..
        } = &self.now;
        let round = supported.body.round();
        let about_vertical = match supported.law {
            IdealLaw::NoSlip => 0.0,
            IdealLaw::Frictionless => {
                let momentum = dot(pose.up, supported.body.inertia(pose.rate));
                0.5 * momentum * momentum / round.axial_inertia()
            }
        };
        let left = supported.energy_above_rest(pose) - about_vertical;
        let is_level = pose.tilt() < 1e-3 * PI;
        is_level && left < SPENT * round.mass() * supported.gravity * round.radius()
    }
}

/// Whether corner k, which an impact has just freed, rises by next to nothing and falls back.
fn hops_back(after: &AfterImpact, k: i64) -> bool {
    let AfterImpact { supported, pose } = after;
    let rate = supported.gap(pose, k).1;
    let acceleration = supported.gap_acceleration(pose, k);
    acceleration < 0.0 && rate * rate < -2.0 * acceleration * HOP * touching_gap(supported, pose)
}

/// The steps of a phase.
enum Steps<'a> {
    OnSupport(
        &'a SupportedBody,
        Box<Stepper<'a, SupportedBody, SUPPORTED>>,
    ),
    InFlight(
        &'a SupportedBody,
        Box<Stepper<'a, SupportedBody, COORDINATES>>,
    ),
}

impl<'a> Steps<'a> {
    /// From a pose, with a first guess of the step (s) and a tolerance.
    fn new(supported: &'a SupportedBody, from: &Pose, h: f64, tolerance: f64) -> Steps<'a> {
        match supported.support.is_flight() {
            true => {
                let stepper = Stepper::new(supported, from.into_array(), h, tolerance);
                Steps::InFlight(supported, Box::new(stepper))
            }
            false => {
                let stepper = Stepper::new(supported, from.on_support(), h, tolerance);
                Steps::OnSupport(supported, Box::new(stepper))
            }
        }
    }

    fn work(&self) -> Work {
        match self {
            Steps::OnSupport(_, stepper) => stepper.work,
            Steps::InFlight(_, stepper) => stepper.work,
        }
    }

    /// The next step as a polynomial.
    fn advance(&mut self) -> Result<Dense<f64, COORDINATES>, Stuck> {
        match self {
            Steps::OnSupport(supported, stepper) => {
                let step = stepper.advance()?.dense(*supported);
                Ok(step.widened(&[0.0; COORDINATES]))
            }
            Steps::InFlight(supported, stepper) => Ok(stepper.advance()?.dense(*supported)),
        }
    }
}
