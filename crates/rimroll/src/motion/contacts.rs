//! The laws of the possible contacts between rim and table, and the transitions between them.

use super::flat_landing::{on_first_face, work_in_fall};
use super::instant::{Instant, Phase};
use super::level_base::{FLAT_TILT, LevelBase};
use super::phase_dynamics::PhaseDynamics;
use super::slip_onset::{ROUNDING, along_and_across, rotated};
use crate::body::Body;
use crate::contact_law::ContactLaw;
use crate::ending::FACE_DOWN_TILT;
use crate::error_scale::ErrorScale;
use crate::ground::Ground;
use crate::impact;
use crate::law::{
    DryDynamics, Dynamics, DynamicsExt, FrictionLaw, Parameters, Resistance, Response, Table,
};
use crate::real::{Dual, Real, Scalar};
use crate::state::Coordinates;
use core::f64::consts::{FRAC_PI_2, TAU};
use std::borrow::Cow;
use std::sync::Arc;

/// The next phase of a rim on the table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Transition {
    /// The rim rolls.
    Roll,
    /// The rim slides with its present slip.
    Slide,
    /// The rim begins to slip from rest in this direction (unit vector along e_x1, e_y1).
    BeginToSlip([f64; 2]),
    /// The rim leaves the table.
    Fly,
    /// The Painlevé paradox: rigid-body mechanics does not determine the motion.
    Paradox,
}

/// A body that can no longer reach this tilt (rad) stands flat: the gap under the rim is far smaller than the roughness
/// of any surface.
pub const STANDING_TILT: f64 = 1e-7;

/// A fall at a lower rate may be a rounding error, in units of √(g/R).
const SIGNIFICANT_FALL: f64 = 1e-11;

impl Transition {
    /// The phase that follows.
    pub(super) fn phase(self) -> Phase {
        match self {
            Transition::Roll => Phase::Rolling,
            Transition::Fly => Phase::Flying,
            Transition::Slide | Transition::BeginToSlip(_) | Transition::Paradox => Phase::Sliding,
        }
    }
}

/// The equations of motion of a body under a contact law, in each phase.
#[derive(Clone)]
pub struct Contacts {
    parameters: Parameters<f64>,
    contact_law: ContactLaw,
    /// The motion of the table; `None` if it is at rest.
    ground: Option<Arc<Ground>>,
    /// The tolerance of a step.
    tolerance: f64,
    phases: PhaseDynamics<f64>,
    /// See [`Options::flat_gap`](super::options::Options::flat_gap), m.
    flat_gap: f64,
}

impl Contacts {
    /// The equations of a body under a contact law and gravity g (m/s²), for steps with the given tolerance.
    /// A slip below a tenth of the tolerance, relative to the other velocities, counts as none.
    pub(crate) fn new(body: &Body, contact_law: &ContactLaw, gravity: f64, tolerance: f64) -> Self {
        Contacts::on_table(body, contact_law, None, gravity, tolerance)
    }

    /// As [`Contacts::new`], on a table that moves with `ground`.
    pub(crate) fn on_table(
        body: &Body,
        contact_law: &ContactLaw,
        ground: Option<Arc<Ground>>,
        gravity: f64,
        tolerance: f64,
    ) -> Self {
        let parameters = Parameters::new(body, gravity);
        Contacts::from_parts(parameters, contact_law.clone(), ground, tolerance)
    }

    fn from_parts(
        parameters: Parameters<f64>,
        contact_law: ContactLaw,
        ground: Option<Arc<Ground>>,
        tolerance: f64,
    ) -> Self {
        let table = Table::new(ground.as_ref());
        Contacts {
            phases: PhaseDynamics::new(parameters, &contact_law, &table, tolerance),
            parameters,
            contact_law,
            tolerance,
            ground,
            flat_gap: 0.0,
        }
    }

    /// These equations for a base that comes down flat at a gap, m.
    pub(super) fn with_flat_gap(self, flat_gap: f64) -> Contacts {
        Contacts { flat_gap, ..self }
    }

    /// See [`Options::flat_gap`](super::options::Options::flat_gap), m.
    pub(super) fn flat_gap(&self) -> f64 {
        self.flat_gap
    }

    /// sin φ where the opposite point of the rim is that far above the table.
    pub(super) fn sine_at_gap(&self) -> f64 {
        self.flat_gap / (2.0 * self.parameters.r)
    }

    /// sin φ below which the base counts as flat without a gap.
    fn flat_sine(&self) -> f64 {
        if self.moves() {
            FLAT_TILT
        } else {
            FACE_DOWN_TILT
        }
    }

    /// Whether a gap under the base of a rim on the table decides when it comes down flat.
    pub(super) fn has_gap(&self, phase: Phase) -> bool {
        self.sine_at_gap() > self.flat_sine() && phase != Phase::Flying
    }

    /// An event function: negative where the base is flat, or where the tilt falls below that at which the gap closes.
    pub(super) fn height_over_flat(&self, phase: Phase, u: &Coordinates<f64>) -> f64 {
        if self.has_gap(phase) {
            return (u.sin - self.sine_at_gap()).max(SIGNIFICANT_FALL - self.falling_rate(u));
        }
        if self.moves() && !self.is_falling(u) {
            return 1.0;
        }
        u.sin - self.flat_sine()
    }

    /// These equations with the same friction, but without resistance.
    pub(super) fn without_resistance(&self) -> Contacts {
        let contact_law = ContactLaw {
            resistance: Resistance::default(),
            ..self.contact_law.clone()
        };
        let ground = self.ground().cloned();
        Contacts::from_parts(self.parameters, contact_law, ground, self.tolerance)
    }

    /// The equations of motion in a phase.
    pub fn dynamics(&self, phase: Phase) -> &dyn Dynamics<f64> {
        self.phases.in_phase(phase)
    }

    /// The equations of all phases for steps that begin at a time (s). Where the table moves, they are those of
    /// the stretch of its motion that contains this time.
    pub(super) fn phases_from(&self, t: f64) -> Cow<'_, PhaseDynamics<f64>> {
        if self.moves() {
            Cow::Owned(self.varied_phases_from(self.parameters, 1.0, t))
        } else {
            Cow::Borrowed(&self.phases)
        }
    }

    /// [`Self::phases_from`] on dual numbers, for Jacobians.
    pub(super) fn dual_phases_from(&self, t: f64) -> PhaseDynamics<Dual> {
        let [m, r, h, a, c, g] = self.parameters.as_array();
        let parameters = Parameters { m, r, h, a, c, g };
        self.varied_phases_from(parameters, 1.0.into(), t)
    }

    /// [`Self::phases_from`] for other numbers: with these parameters, and with the acceleration of the table multiplied
    /// by `factor`.
    pub(super) fn varied_phases_from<T: Scalar>(
        &self,
        parameters: Parameters<T>,
        factor: T,
        t: f64,
    ) -> PhaseDynamics<T> {
        let stretch = self.ground().map(|ground| ground.stretch(t));
        let table = stretch.map_or(Table::AtRest, |stretch| Table::Along(stretch, factor));
        PhaseDynamics::new(parameters, &self.contact_law, &table, self.tolerance)
    }

    /// The first time after `t` at which the acceleration of the table has a corner, s; infinite if there is none.
    pub(super) fn corner_after(&self, t: f64) -> f64 {
        self.ground()
            .map_or(f64::INFINITY, |ground| ground.stretch(t).end)
    }

    /// The motion of the table, if it moves.
    pub(super) fn ground(&self) -> Option<&Arc<Ground>> {
        self.ground.as_ref().filter(|_| cfg!(feature = "ground"))
    }

    /// The largest |T|/N of a base that stands flat and does not slip.
    pub(super) fn holding_friction(&self) -> f64 {
        match &self.contact_law.friction {
            friction if friction.never_slips() => f64::INFINITY,
            friction => friction.static_friction().unwrap_or(0.0),
        }
    }

    /// The tolerance of a step.
    pub(super) fn tolerance(&self) -> f64 {
        self.tolerance
    }

    /// Whether the friction is dry.
    pub(super) fn is_dry(&self) -> bool {
        self.dry().is_some()
    }

    /// Whether the table moves.
    pub(crate) fn moves(&self) -> bool {
        self.ground().is_some()
    }

    /// The body and gravity.
    pub fn parameters(&self) -> &Parameters<f64> {
        &self.parameters
    }

    /// The contact law.
    pub fn contact_law(&self) -> &ContactLaw {
        &self.contact_law
    }

    /// The equations of sliding under dry friction, if the friction is dry.
    pub(super) fn dry(&self) -> Option<&dyn DryDynamics> {
        self.phases.sliding.dry()
    }

    /// Whether motions can contain flights. Where they cannot, they end at a lift-off instead.
    pub(super) fn can_fly(&self) -> bool {
        self.contact_law.friction.covers_flight()
    }

    /// The margin of a rolling rim to the friction cone, (μ_s N − |T|) sin φ.
    pub(super) fn friction_cone_margin(&self, u: &Coordinates<f64>) -> f64 {
        let Some(static_friction) = self.contact_law.friction.static_friction() else {
            return 1.0;
        };
        let contact = self.dynamics(Phase::Rolling).contact(u);
        static_friction * contact.normal - libm::hypot(contact.along, contact.across)
    }

    /// A speed (m/s) below which a slip or a rebound counts as none.
    pub(super) fn stopped_speed(&self, u: &Coordinates<f64>) -> f64 {
        let k = &self.parameters;
        0.1 * self.tolerance * k.r * ErrorScale::new(k).rate(u)
    }

    /// The next phase of a rim on the table.
    pub(crate) fn settle(&self, u: &Coordinates<f64>) -> Transition {
        match self.contact_law.friction {
            FrictionLaw::NoSlip | FrictionLaw::InPlace => Transition::Roll,
            FrictionLaw::Frictionless => Transition::Slide,
            _ if self.dry().is_some() && u.slip_speed() <= self.stopped_speed(u) => {
                let in_contact = self.dynamics(Phase::Rolling).contact(u).normal > 0.0;
                if in_contact && self.friction_cone_margin(u) >= 0.0 {
                    Transition::Roll
                } else {
                    self.begin_to_slip(u)
                }
            }
            _ => {
                let dynamics = self.dynamics(Phase::Sliding);
                if dynamics.consistency(u) <= 0.0 {
                    Transition::Paradox
                } else if self.scaled_normal_force(u) >= -1e-14 * self.force_scale(u) {
                    // The tolerance avoids flights that are due to a rounding error.
                    Transition::Slide
                } else {
                    Transition::Fly
                }
            }
        }
    }

    /// The scale of [`Self::scaled_normal_force`]: weight and inertial forces, times sin φ.
    fn force_scale(&self, u: &Coordinates<f64>) -> f64 {
        let k = &self.parameters;
        let rates = u.p * u.p + u.w * u.w + u.s * u.s;
        k.m * (u.sin * k.g + (k.r + k.h) * rates)
    }

    /// Whether the tilt falls at a rate beyond rounding.
    pub(super) fn is_falling(&self, u: &Coordinates<f64>) -> bool {
        self.falling_rate(u) > SIGNIFICANT_FALL
    }

    /// Whether a disk lies on its other face under a law that keeps it in place. With its other face down it does not wobble in
    /// place, but turns about the axis as it falls, and what follows is not determined.
    pub(super) fn turns_on_other_face(&self, u: &Coordinates<f64>) -> bool {
        u.cos < 0.0 && self.contact_law.friction == FrictionLaw::InPlace
    }

    /// The rate at which the face that is down falls, in units of √(g/R).
    fn falling_rate(&self, u: &Coordinates<f64>) -> f64 {
        let k = &self.parameters;
        let rate = if u.cos < 0.0 { u.p } else { -u.p };
        rate * (k.r / k.g).sqrt()
    }

    /// An event function on a table that moves. It is negative where the tilt falls and the energy of tilting does not
    /// suffice for a tilt of more than about [`STANDING_TILT`], so that the body stands flat from now on. Where the
    /// table shakes it too much for that, it begins to rock anew, in the direction in which it is shaken then.
    pub(super) fn excess_over_standing(&self, u: &Coordinates<f64>) -> f64 {
        let k = &self.parameters;
        if !self.is_falling(u) || !LevelBase::new(self, u.yaw).is_pressed(u.t) {
            return 1.0;
        }
        tilting_energy_over_standing(k, u)
    }

    /// Whether a body at the beginning of its rocking has too little energy to reach a tilt of [`STANDING_TILT`].
    pub(super) fn hardly_rocks(&self, u: &Coordinates<f64>) -> bool {
        let k = &self.parameters;
        let inertia = k.a + k.m * (k.r * k.r + k.h * k.h);
        0.5 * inertia * u.p * u.p < k.m * k.g * k.r * STANDING_TILT
    }

    /// Whether a body at the beginning of its rocking has too little energy to reach the tilt at which the gap closes.
    pub(super) fn stays_below_gap(&self, at: &Instant) -> bool {
        let k = &self.parameters;
        let rolls = at.phase == Phase::Rolling;
        let height = if rolls { k.h } else { 0.0 };
        let inertia = k.a + k.m * (k.r * k.r + height * height);
        let sin = self.sine_at_gap();
        let cos = (1.0 - sin * sin).sqrt();
        let at_gap = Coordinates {
            sin,
            cos,
            ..on_first_face(&at.u)
        };
        let weight = k.m * k.g * (k.z(&at_gap) - k.h);
        let work = work_in_fall(self.dynamics(at.phase), rolls, &at_gap);
        0.5 * inertia * at.p * at.p < weight + work
    }

    /// Whether a body comes down flat beside a vertical plane. Without a gap, rounding errors alone may take it out of its
    /// plane by a small angle.
    pub(super) fn is_beside_plane(&self, u: &Coordinates<f64>) -> bool {
        const ROUNDED_DIRECTION: f64 = 0.1;
        let has_gap = self.sine_at_gap() > self.flat_sine();
        let in_plane = if has_gap { 0.0 } else { ROUNDED_DIRECTION };
        u.w.abs() > in_plane * u.p.abs()
    }

    /// Whether resistance has stopped the motion of the contact point along the rim for good, so that the
    /// tilt falls to zero and does not rise again.
    ///
    /// For the tilt to rise, w, which grows at the rate |φ̇| w as the tilt falls, has to reach the size of
    /// φ̇. It cannot if resistance would reduce a w of that size a hundred times as fast, since resistance
    /// grows relative to that rate as the tilt falls further. A w of one sign can lift the rim off the table,
    /// where there is no resistance; the other sign is decisive then.
    pub(super) fn has_stopped_running(&self, phase: Phase, u: &Coordinates<f64>) -> bool {
        const MIN_RATIO: f64 = 100.0;
        if self.falling_rate(u) <= 0.0 || u.w.abs() > 0.5 * u.p.abs() || self.turns_on_other_face(u)
        {
            return false;
        }
        self.running_deceleration(phase, u) > MIN_RATIO * u.p * u.p
    }

    /// Whether resistance would stop the contact point even at the tilt from which the base has come down flat with the
    /// tilt rate in `u`, so that the body comes to rest where it would run round the rim.
    pub(super) fn holds_contact_point(&self, at: &Instant) -> bool {
        let k = &self.parameters;
        let energy = tilting_energy(k, &Coordinates { w: 0.0, ..at.u });
        let sin = (energy / (k.m * k.g * k.r)).min(1.0);
        let cos = (1.0 - sin * sin).sqrt();
        let there = Coordinates {
            sin,
            cos,
            ..on_first_face(at)
        };
        self.running_deceleration(at.phase, &there) > there.p * there.p
    }

    /// The larger rate (with respect to τ) at which resistance reduces a w as large as φ̇, of either sign.
    fn running_deceleration(&self, phase: Phase, u: &Coordinates<f64>) -> f64 {
        let dynamics = self.dynamics(phase);
        let deceleration =
            |w: f64| -w.signum() * dynamics.resistance_rate(&Coordinates { w, ..*u });
        deceleration(u.p).max(deceleration(-u.p))
    }

    /// The coordinates after the impulse of resistance that stops the contact point of a rim, with its work.
    pub(super) fn without_running(&self, phase: Phase, at: &Coordinates<f64>) -> Coordinates<f64> {
        let k = &self.parameters;
        let dynamics = self.dynamics(phase);
        let moment = [1.0, 0.0];
        let constrained = dynamics.constrained_response(at, moment);
        let response = constrained.unwrap_or_else(|| Response::to(k, moment, 0.0));
        let impulse = -at.w / response.w;
        let s = at.s + impulse * response.s;
        // A rim that slides keeps the velocity of its centre of mass.
        let across = if constrained.is_none() {
            k.h * -at.w - k.r * (s - at.s)
        } else {
            0.0
        };
        let u = Coordinates {
            w: 0.0,
            s,
            slip_y: at.slip_y + across,
            ..*at
        };
        let taken = dynamics.energy(at).total() - dynamics.energy(&u).total();
        Coordinates {
            resistance_loss: at.resistance_loss + taken,
            ..u
        }
    }

    /// N sin φ of a rim that slides or, if larger, m sin φ times the downward acceleration that the rim would
    /// have in flight. It is positive where friction presses the rim to the table, or where the rim would
    /// penetrate the table in flight.
    pub(super) fn scaled_normal_force(&self, u: &Coordinates<f64>) -> f64 {
        let falling = -self.parameters.m * self.phases.flying.rates(u).gap_rate;
        self.dynamics(Phase::Sliding).contact(u).normal.max(falling)
    }

    /// The onset of slip of a rim at rest that friction cannot hold. It slips in the direction in which it
    /// then accelerates. If friction is only just exceeded, that is opposite to the friction needed to stick.
    pub(crate) fn begin_to_slip(&self, u: &Coordinates<f64>) -> Transition {
        let Some(dry) = self.dry() else {
            return Transition::Slide;
        };
        let needed = self.dynamics(Phase::Rolling).contact(u);
        let size = libm::hypot(needed.along, needed.across);
        let against = if size > 0.0 {
            [-needed.along / size, -needed.across / size]
        } else {
            [1.0, 0.0]
        };
        if let Some(angle) = stable_angle(dry, u, against) {
            return Transition::BeginToSlip(rotated(against, angle));
        }
        const SAMPLES: u32 = 64;
        let angle = |i: u32| TAU * (f64::from(i) / f64::from(SAMPLES) - 0.5);
        let sideways = |angle: f64| onset(dry, u, against, angle).sideways;
        let stable = (0..SAMPLES).filter_map(|i| {
            // A direction is stable if the slip on both sides of it turns toward it.
            let (from, to) = (angle(i), angle(i + 1));
            let is_stable = sideways(from) >= 0.0 && sideways(to) < 0.0;
            let root = is_stable.then(|| crate::solve::bracketed_root(from, to, sideways))?;
            let e = rotated(against, root);
            stable_angle(dry, u, e).map(|more| (root.abs(), rotated(e, more)))
        });
        match stable.min_by(|a, b| a.0.total_cmp(&b.0)) {
            Some((_, e)) => Transition::BeginToSlip(e),
            None if self.scaled_normal_force(u) < 0.0 => Transition::Fly,
            None => Transition::Paradox,
        }
    }

    /// Whether toppling means here that the side of the body strikes the table. It does not in flight, nor
    /// under laws without flight, which have no impacts.
    pub(super) fn falls_on_its_side(&self, at: &Instant) -> bool {
        let on_table = at.phase != Phase::Flying;
        let upright_base = (at.tilt() - FRAC_PI_2).abs() < 1e-9;
        self.can_fly() && self.parameters.h > 0.0 && on_table && upright_base
    }

    /// The body after its side has struck the table without rebound. The tilt rate and the vertical velocity
    /// of the centre of mass become zero, which dissipates ½ (A + mρ²) φ̇²; the horizontal momentum is
    /// conserved. The position of the impulse along the side does not matter. The rim stays on the table.
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

    /// The rates at the start of a motion, under the law that holds there.
    pub(crate) fn first_rates(&self, u: &Coordinates<f64>) -> Coordinates<f64> {
        match (self.settle(u), self.dry()) {
            (Transition::Roll, _) => self.dynamics(Phase::Rolling).rates(u),
            (Transition::BeginToSlip(e), Some(dry)) => dry.slipping(u, e, u.slip_speed()).1,
            _ => self.dynamics(Phase::Sliding).rates(u),
        }
    }

    /// The coordinates after a level base has struck the table. The rebound is slower by the coefficient of restitution;
    /// the horizontal velocity stays the same.
    pub(super) fn landed_level(&self, u: &Coordinates<f64>) -> Coordinates<f64> {
        // A geometric sequence of rebounds needs an end: slower rebounds are ignored.
        const SLOW: f64 = 1e-9;
        let k = &self.parameters;
        let rebound = -self.contact_law.restitution * u.gap_rate;
        let is_slow = rebound < SLOW * (k.g * k.r).sqrt();
        let gap_rate = if is_slow { 0.0 } else { rebound };
        let lost = 0.5 * k.m * (u.gap_rate * u.gap_rate - gap_rate * gap_rate);
        Coordinates {
            gap: 0.0,
            gap_rate,
            impact_loss: u.impact_loss + lost,
            ..*u
        }
    }

    /// The coordinates after an impact and the next phase; `None` where the impact cannot be computed.
    pub(super) fn resolve_impact(
        &self,
        u: &Coordinates<f64>,
    ) -> Option<(Coordinates<f64>, Transition)> {
        let friction = self.contact_law.friction.impact_coefficient(u.slip_speed());
        let restitution = self.contact_law.restitution;
        // A geometric sequence of rebounds needs an end: rebounds slower than this speed are ignored.
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

/// The energy of tilting above that with which a body reaches a tilt of [`STANDING_TILT`], J.
pub(super) fn tilting_energy_over_standing<T: Real>(k: &Parameters<T>, u: &Coordinates<T>) -> T {
    tilting_energy(k, u) - k.m * k.g * k.r * T::from(STANDING_TILT)
}

/// The energy of tilting of a body whose tilt is small, J.
fn tilting_energy<T: Real>(k: &Parameters<T>, u: &Coordinates<T>) -> T {
    let (rho, z) = (k.rho(u), k.z(u));
    let tilting = (k.a + k.m * (rho * rho + z * z)) * u.p * u.p + k.a * u.w * u.w;
    T::from(0.5) * tilting + k.m * k.g * k.r * u.sin
}

/// The onset of a slip from rest in a trial direction.
struct TrialOnset {
    /// The slip's acceleration across the direction.
    sideways: f64,
    /// The slip's acceleration along the direction.
    forward: f64,
    /// The scale of the accelerations.
    size: f64,
    normal: f64,
    consistency: f64,
}

impl TrialOnset {
    fn is_possible(&self) -> bool {
        self.forward >= -ROUNDING * self.size && self.normal > 0.0 && self.consistency > 0.0
    }
}

/// The angle from `base` to a nearby direction that is constant as the slip begins, to the last digit,
/// because the slip would leave any other direction at once. It is found by Newton's method.
fn stable_angle(dry: &dyn DryDynamics, u: &Coordinates<f64>, base: [f64; 2]) -> Option<f64> {
    const INCREMENT: f64 = 1e-5;
    const MAX_ANGLE: f64 = 0.3;
    let sideways = |angle: f64| onset(dry, u, base, angle).sideways;
    let mut angle = 0.0;
    for _ in 0..20 {
        let slope = (sideways(angle + INCREMENT) - sideways(angle - INCREMENT)) / (2.0 * INCREMENT);
        let correction = -sideways(angle) / slope;
        angle += correction;
        if !(slope < 0.0 && angle.abs() < MAX_ANGLE) {
            return None;
        }
        if correction.abs() <= 4.0 * f64::EPSILON * angle.abs() {
            break;
        }
    }
    onset(dry, u, base, angle).is_possible().then_some(angle)
}

fn onset(dry: &dyn DryDynamics, u: &Coordinates<f64>, base: [f64; 2], angle: f64) -> TrialOnset {
    let e = rotated(base, angle);
    let at_rest = Coordinates {
        slip_x: 0.0,
        slip_y: 0.0,
        ..*u
    };
    let (contact, rates) = dry.slipping(&at_rest, e, 0.0);
    let k = dry.parameters();
    let [forward, sideways] = along_and_across([rates.slip_x, rates.slip_y], e);
    TrialOnset {
        sideways,
        forward,
        size: libm::hypot(contact.along, contact.across) * k.sideways_mobility()
            + libm::hypot(rates.slip_x, rates.slip_y),
        normal: contact.normal,
        consistency: dry.consistency_at_onset(&at_rest, e),
    }
}
