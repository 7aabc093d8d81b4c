//! How the rim can meet the table on a given surface, and what follows when one way gives over to
//! another.

use super::mechanics::Mechanics;
use super::track::Instant;
use crate::body::Body;
use crate::contact_law::ContactLaw;
use crate::error_scale::ErrorScale;
use crate::impact;
use crate::law::{
    DryDynamics, Dynamics, Flight, FrictionLaw, NoSlip, Parameters, Resisted, SlidingDynamics,
};
use crate::solve::System;
use crate::state::{COORDINATES, Coordinates, RIGID_COORDINATES};
use core::f64::consts::{FRAC_PI_2, TAU};

/// How the rim meets the table at a moment.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Phase {
    /// It rolls: its lowest point is at rest.
    Rolling,
    /// Its lowest point slips.
    Sliding,
    /// It is off the table.
    Flying,
    /// The body lies on its side: the end of a motion that topples.
    Lying,
}

impl Phase {
    /// The name that the user reads.
    pub fn name(self) -> &'static str {
        match self {
            Phase::Rolling => "rolling",
            Phase::Sliding => "sliding",
            Phase::Flying => "flying",
            Phase::Lying => "lying",
        }
    }
}

/// Something to do with the system of equations that holds in a phase. It is compiled anew for each of
/// the laws that most motions follow.
pub(super) trait SystemVisitor {
    /// What comes of it.
    type Output;

    /// Does it: the first N coordinates are all that change.
    fn with<S: System<f64, N>, const N: usize>(self, system: &S) -> Self::Output;
}

/// What becomes of a rim on the table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Transition {
    /// It rolls.
    Roll,
    /// It slides on with the slip that it has.
    Slide,
    /// It begins to slip in this direction (unit vector along e_x1, e_y1), from rest.
    BeginToSlip([f64; 2]),
    /// It leaves the table.
    Fly,
    /// Rigid-body mechanics does not say.
    Paradox,
}

/// The laws of a body on a surface.
#[derive(Clone)]
pub struct Contacts {
    parameters: Parameters<f64>,
    contact_law: ContactLaw,
    /// Below this part of the velocities at hand a slip counts as none.
    stopped: f64,
    rolling: Resisted<NoSlip<f64>>,
    sliding: SlidingDynamics<f64>,
    flying: Flight<f64>,
}

impl Contacts {
    /// The laws of a body on a surface under gravity g (m/s²), for steps that may err by `tolerance`:
    /// slower than a tenth of that, relative to the velocities at hand, no slip is followed.
    pub(crate) fn new(body: &Body, contact_law: &ContactLaw, gravity: f64, tolerance: f64) -> Self {
        let parameters = Parameters::new(body, gravity);
        Contacts {
            parameters,
            contact_law: contact_law.clone(),
            stopped: 0.1 * tolerance,
            rolling: Resisted::new(NoSlip::new(parameters), contact_law.resistance),
            sliding: SlidingDynamics::new(
                &contact_law.friction,
                contact_law.resistance,
                parameters,
            ),
            flying: Flight::new(parameters),
        }
    }

    /// The law that holds in a phase.
    pub fn dynamics(&self, phase: Phase) -> &dyn Dynamics<f64> {
        match phase {
            Phase::Rolling => &self.rolling,
            Phase::Sliding => self.sliding.dynamics().unwrap_or(&self.rolling),
            // Of a body that lies nothing is asked but its energy.
            Phase::Flying | Phase::Lying => &self.flying,
        }
    }

    /// The law that holds in a phase, as the solver sees it.
    pub(super) fn mechanics(&self, phase: Phase) -> Mechanics<'_> {
        let law = self.dynamics(phase);
        if phase == Phase::Sliding && self.dry().is_some() {
            Mechanics::slipping(law)
        } else {
            Mechanics::new(law)
        }
    }

    /// Does something with the system of equations that holds in a phase.
    pub(super) fn solve<K: SystemVisitor>(&self, phase: Phase, task: K) -> K::Output {
        match (phase, &self.sliding) {
            (Phase::Rolling, _) | (Phase::Sliding, SlidingDynamics::Never)
                if self.rolling.is_conservative() =>
            {
                task.with::<_, RIGID_COORDINATES>(&Mechanics::new(self.rolling.dynamics()))
            }
            (Phase::Sliding, SlidingDynamics::Frictionless(law)) if law.is_conservative() => {
                task.with::<_, RIGID_COORDINATES>(&Mechanics::new(law.dynamics()))
            }
            (Phase::Sliding, SlidingDynamics::Coulomb(law)) => {
                task.with::<_, COORDINATES>(&Mechanics::slipping(law))
            }
            _ => task.with::<_, COORDINATES>(&self.mechanics(phase)),
        }
    }

    /// The body and gravity.
    pub fn parameters(&self) -> &Parameters<f64> {
        &self.parameters
    }

    /// The surface.
    pub fn contact_law(&self) -> &ContactLaw {
        &self.contact_law
    }

    /// The law of sliding under dry friction, where there is dry friction.
    pub(super) fn dry(&self) -> Option<&dyn DryDynamics> {
        self.sliding.dry()
    }

    /// Whether the contact may be lost and found again: the two ideal laws end there instead.
    pub(super) fn can_fly(&self) -> bool {
        self.contact_law.friction.ideal().is_none()
    }

    /// By how much dry friction could hold the rolling rim yet, N sin φ: μ_s N − |T|.
    pub(super) fn friction_cone_margin(&self, u: &Coordinates<f64>) -> f64 {
        let Some(static_friction) = self.contact_law.friction.static_friction() else {
            return 1.0;
        };
        let contact = self.rolling.contact(u);
        static_friction * contact.normal - libm::hypot(contact.along, contact.across)
    }

    /// A speed (m/s) below which a slip or a rebound counts as none.
    pub(super) fn stopped_speed(&self, u: &Coordinates<f64>) -> f64 {
        let k = &self.parameters;
        self.stopped * k.r * ErrorScale::new(k).rate(u)
    }

    /// How a rim on the table goes on.
    pub(crate) fn settle(&self, u: &Coordinates<f64>) -> Transition {
        match self.contact_law.friction {
            FrictionLaw::NoSlip => Transition::Roll,
            FrictionLaw::Frictionless => Transition::Slide,
            _ if self.dry().is_some() && u.slip_speed() <= self.stopped_speed(u) => {
                let pressed = self.rolling.contact(u).normal > 0.0;
                if pressed && self.friction_cone_margin(u) >= 0.0 {
                    Transition::Roll
                } else {
                    self.begin_to_slip(u)
                }
            }
            _ => {
                let law = self.dynamics(Phase::Sliding);
                if law.consistency(u) <= 0.0 {
                    Transition::Paradox
                } else if self.scaled_normal_force(u) >= -1e-14 * self.force_scale(u) {
                    // A flight that rises by a rounding error ends where it begins.
                    Transition::Slide
                } else {
                    Transition::Fly
                }
            }
        }
    }

    /// A force times sin φ, of what throws the rim about, to compare [`Self::scaled_normal_force`] with.
    fn force_scale(&self, u: &Coordinates<f64>) -> f64 {
        let k = &self.parameters;
        let rates = u.p * u.p + u.w * u.w + u.s * u.s;
        k.m * (u.sin * k.g + (k.r + k.h) * rates)
    }

    /// Whether resistance has stopped the contact point's running round the rim for good: the tilt falls to
    /// zero and does not rise again.
    ///
    /// For the tilt to rise, w, which grows at the rate |φ̇| w as the tilt falls, has to reach the size of φ̇.
    /// It cannot where resistance would take a hundred times as much from a w of that size, since
    /// resistance grows beside that rate as the tilt falls on. Of the two signs of w one may lift the rim
    /// off the table, where nothing resists; the other counts.
    pub(super) fn has_stopped_running(&self, phase: Phase, u: &Coordinates<f64>) -> bool {
        const FOR_GOOD: f64 = 100.0;
        if u.p >= 0.0 || u.w.abs() > 0.5 * u.p.abs() {
            return false;
        }
        let law = self.dynamics(phase);
        let taken_from = |w: f64| -w.signum() * law.resistance_rate(&Coordinates { w, ..*u });
        taken_from(u.p).max(taken_from(-u.p)) > FOR_GOOD * u.p * u.p
    }

    /// Positive where a rim that slides is pressed to the table, N sin φ: where it is by its friction, or
    /// where, without the table, it would go through it.
    pub(super) fn scaled_normal_force(&self, u: &Coordinates<f64>) -> f64 {
        let falling = -self.parameters.m * self.flying.rates(u).gap_rate;
        self.dynamics(Phase::Sliding).contact(u).normal.max(falling)
    }

    /// How a rim at rest that friction cannot hold begins to slip: in the direction in which it then
    /// accelerates, which is against the friction that would be needed where that is just too much.
    pub(crate) fn begin_to_slip(&self, u: &Coordinates<f64>) -> Transition {
        let Some(dry) = self.dry() else {
            return Transition::Slide;
        };
        let needed = self.rolling.contact(u);
        let size = libm::hypot(needed.along, needed.across);
        let against = if size > 0.0 {
            [-needed.along / size, -needed.across / size]
        } else {
            [1.0, 0.0]
        };
        if let Some(angle) = kept_angle(dry, u, against) {
            return Transition::BeginToSlip(turned(against, angle));
        }
        const SAMPLES: u32 = 64;
        let angle = |i: u32| TAU * (f64::from(i) / f64::from(SAMPLES) - 0.5);
        let sideways = |angle: f64| onset(dry, u, against, angle).sideways;
        let kept = (0..SAMPLES).filter_map(|i| {
            // A direction attracts when the slip is turned toward it from both sides.
            let (from, to) = (angle(i), angle(i + 1));
            let attracts = sideways(from) >= 0.0 && sideways(to) < 0.0;
            let root = attracts.then(|| crate::solve::bracketed_root(from, to, sideways))?;
            let e = turned(against, root);
            kept_angle(dry, u, e).map(|more| (root.abs(), turned(e, more)))
        });
        match kept.min_by(|a, b| a.0.total_cmp(&b.0)) {
            Some((_, e)) => Transition::BeginToSlip(e),
            None if self.scaled_normal_force(u) < 0.0 => Transition::Fly,
            None => Transition::Paradox,
        }
    }

    /// Whether toppling here means that the side of the body meets the table: not in the air, and the two
    /// ideal laws, which know no landing, leave it at that.
    pub(super) fn falls_on_its_side(&self, at: &Instant) -> bool {
        let on_table = at.phase != Phase::Flying;
        let upright_base = (at.tilt() - FRAC_PI_2).abs() < 1e-9;
        self.can_fly() && self.parameters.h > 0.0 && on_table && upright_base
    }

    /// The body after its side has met the table without rebound: neither tilting nor rising, and
    /// with the horizontal momentum that it had. Where along the side the table has pushed does not
    /// matter. What is left rolls on its side. The rim stays on the table: what ends is the motion of
    /// the centre of mass down and the tilting, ½ (A + mρ²) φ̇².
    pub(super) fn fallen_on_its_side(&self, at: &Instant) -> Instant {
        let k = &self.parameters;
        let [slip_x, slip_y] = self.dynamics(at.phase).slip(at);
        let rho = k.rho(at);
        let u = Coordinates {
            p: 0.0,
            slip_x: slip_x - k.z(at) * at.p,
            slip_y,
            impact_loss: at.impact_loss + 0.5 * (k.a + k.m * rho * rho) * at.p * at.p,
            ..at.u
        };
        let phase = Phase::Lying;
        Instant { phase, u }
    }

    /// The rates at the start of a motion, by the law that then holds.
    pub(crate) fn first_rates(&self, u: &Coordinates<f64>) -> Coordinates<f64> {
        match (self.settle(u), self.dry()) {
            (Transition::Roll, _) => self.rolling.rates(u),
            (Transition::BeginToSlip(e), Some(dry)) => dry.slipping(u, e, u.slip_speed()).1,
            _ => self.dynamics(Phase::Sliding).rates(u),
        }
    }

    /// The coordinates after a landing, and how the rim goes on; none where the impact cannot be followed.
    pub(super) fn land(&self, u: &Coordinates<f64>) -> Option<(Coordinates<f64>, Transition)> {
        let friction = self.contact_law.friction.impact_coefficient(u.slip_speed());
        let restitution = self.contact_law.restitution;
        // Rebounds that fall off by a factor need an end: one that lasts no time to speak of.
        let rest = self.stopped_speed(u);
        let after = impact::resolve(&self.parameters, u, friction, restitution, rest)?;
        let next = if after.gap_rate > 0.0 {
            Transition::Fly
        } else {
            self.settle(&after)
        };
        Some((after, next))
    }
}

/// How a slip from rest would begin in a direction.
struct Onset {
    /// The slip's acceleration across the direction.
    sideways: f64,
    /// The same along it.
    forward: f64,
    /// Of the forces on it, to compare with.
    size: f64,
    normal: f64,
    consistency: f64,
}

impl Onset {
    /// At loose tolerances sin² φ + cos² φ = 1, and with it the laws' agreement on when slip begins, is
    /// kept to some 1e-8.
    fn is_possible(&self) -> bool {
        self.forward >= -1e-6 * self.size && self.normal > 0.0 && self.consistency > 0.0
    }
}

/// The direction close by, as an angle from `base`, that a slip which begins in it keeps: to the
/// last digit, since any other is left at once. By Newton's method.
fn kept_angle(dry: &dyn DryDynamics, u: &Coordinates<f64>, base: [f64; 2]) -> Option<f64> {
    const NUDGE: f64 = 1e-5;
    const CLOSE_BY: f64 = 0.3;
    let sideways = |angle: f64| onset(dry, u, base, angle).sideways;
    let mut angle = 0.0;
    for _ in 0..20 {
        let slope = (sideways(angle + NUDGE) - sideways(angle - NUDGE)) / (2.0 * NUDGE);
        let correction = -sideways(angle) / slope;
        angle += correction;
        if !(slope < 0.0 && angle.abs() < CLOSE_BY) {
            return None;
        }
        if correction.abs() <= 4.0 * f64::EPSILON * angle.abs() {
            break;
        }
    }
    onset(dry, u, base, angle).is_possible().then_some(angle)
}

fn onset(dry: &dyn DryDynamics, u: &Coordinates<f64>, base: [f64; 2], angle: f64) -> Onset {
    let e = turned(base, angle);
    let at_rest = Coordinates {
        slip_x: 0.0,
        slip_y: 0.0,
        ..*u
    };
    let (contact, rates) = dry.slipping(&at_rest, e, 0.0);
    let k = dry.parameters();
    Onset {
        sideways: rates.slip_y * e[0] - rates.slip_x * e[1],
        forward: rates.slip_x * e[0] + rates.slip_y * e[1],
        size: libm::hypot(contact.along, contact.across) * k.sideways_mobility()
            + libm::hypot(rates.slip_x, rates.slip_y),
        normal: contact.normal,
        consistency: dry.consistency_at_onset(&at_rest, e),
    }
}

/// A unit vector turned by an angle.
pub(super) fn turned(e: [f64; 2], angle: f64) -> [f64; 2] {
    let (sin, cos) = libm::sincos(angle);
    [e[0] * cos - e[1] * sin, e[1] * cos + e[0] * sin]
}
