//! What an event between two phases does to the derivatives.
//!
//! A phase ends where an event function g is zero, so the derivatives there are those at g = 0, among them that of
//! the time. The next phase begins with the derivative of the map that leads to it. (In the terms of nonsmooth
//! mechanics, the two together are the saltation matrix.) In particular:
//!
//! * At a corner of the table's acceleration g is the time itself, and the map is the identity. So the derivatives at a
//!   fixed time are continuous there, although the rates jump.
//! * Where dry friction no longer holds a rim that rolls, g is the friction cone margin, and the map is the identity.
//!   If static and kinetic friction are equal, the rates are continuous there, and so are the derivatives at a fixed time.
//! * A slip that stops leaves two derivatives fewer: afterwards those of the slip are zero.
//! * A rim leaves the table where the normal force is zero, and it lands where the gap is. The map of the landing is the
//!   impact.
//! * A body that stands or slides flat is lifted at a time t_u that depends on the parameters, unless the acceleration of
//!   the table jumps then. The tilt is of second or third order in t − t_u, so the derivatives of tilt and tilt rate at a fixed
//!   time begin at zero. The yaw is the one regular solution of an equation that is singular at t_u: it follows the direction
//!   of the force at the time t, except for terms of second order. So its derivative at a fixed time is that of this
//!   direction; the one at t_u, less ψ̇ ∂t_u, is not, because the computed motion begins with ψ̇ = 0.
//! * Where the base comes down flat at once, a parameter that takes the motion out of its plane has no
//!   derivative: beside the plane, the contact point runs round the rim instead.

use super::shaken_slope::{Number, SHAKEN_PARAMETERS, sizes_of_parameters, without};
use super::variation::Variation;
use super::{values, with_values};
use crate::error::InvalidInput;
use crate::error_scale::ErrorScale;
use crate::impact;
use crate::law::{DynamicsExt, FrictionLaw, IdealLaw};
use crate::motion::Motion;
use crate::motion::contacts::{Contacts, tilting_energy_over_standing};
use crate::motion::flat_landing::{
    FlatLanding, fallen, on_face_of, on_first_face, plastic_factor, rocked_over,
};
use crate::motion::instant::Phase;
use crate::motion::level_base::{FLAT_TILT, LevelMotion, UPLIFT_TILT, levelled};
use crate::motion::slip_onset::along_and_across;
use crate::motion::step_record::StepRecord;
use crate::real::{Dual, Real, Scalar};
use crate::state::{COORDINATES, Coordinates, TIME};
use crate::turn::inertias_of;
use core::f64::consts::PI;

/// The end of one step and the start of the next.
pub(super) struct Saltation<'a> {
    pub(super) motion: &'a Motion,
    pub(super) variation: &'a Variation,
    pub(super) before: &'a StepRecord,
    pub(super) after: &'a StepRecord,
}

impl Saltation<'_> {
    /// The coordinates at the start of the next step, given those at the end of the one before.
    pub(super) fn crossed(
        &self,
        u: &Coordinates<Number>,
    ) -> Result<Coordinates<Number>, InvalidInput> {
        let (before, after) = (self.before.phase, self.after.phase);
        let is_continued = before == after && self.before.end == self.after.start;
        let u = match (before, after) {
            _ if is_continued => *u,
            (Phase::Standing, _) => self.departed(u),
            (Phase::SlidingFlat | Phase::FlyingLevel, _) => self.after_level_motion(u),
            (Phase::Rolling | Phase::Sliding, next) if next.is_level() => self.stood(u)?,
            (Phase::Rolling | Phase::Sliding, Phase::Lying) => self.fallen(u),
            (Phase::Rolling | Phase::Sliding, _) if self.is_flat() => self.landed_flat(u)?,
            (Phase::Flying, _) if self.before.end[0] != self.after.start[0] => {
                return Err(refused("the body passes through upright in flight"));
            }
            (Phase::Flying, _) => self.landed(u)?,
            (Phase::Sliding, Phase::Flying) => self.lifted_off(u),
            (Phase::Sliding, _) => self.stopped_slipping(u),
            (Phase::Rolling, _) => self.let_go(u),
            (Phase::Lying, _) => *u,
        };
        Ok(match after {
            // The state is constant from then on.
            Phase::Lying => Coordinates {
                t: u.t.value.into(),
                ..u
            },
            // A body that departs at once does so when it has come to stand, and not at a time of its own.
            Phase::Standing => Coordinates {
                t: if self.after.start[TIME] == self.after.end[TIME] {
                    u.t
                } else {
                    u.t.value.into()
                },
                slip_x: 0.0.into(),
                slip_y: 0.0.into(),
                ..u
            },
            _ => u,
        })
    }

    /// Friction no longer holds a rim that rolled, or the rim leaves the table.
    fn let_go(&self, u: &Coordinates<Number>) -> Coordinates<Number> {
        let contacts = &self.motion.contacts;
        let t = self.before.start[TIME];
        let contact = |variation: &Variation, u: &Coordinates<Number>| {
            variation
                .phases(contacts, t)
                .in_phase(Phase::Rolling)
                .contact(u)
        };
        let margin = |variation: &Variation, u: &Coordinates<Number>| {
            let force = contact(variation, u);
            let holding = contacts.contact_law().friction.static_friction();
            let friction = force.along.hypot(force.across);
            Number::from(holding.unwrap_or(f64::INFINITY)) * force.normal - friction
        };
        let normal = |variation: &Variation, u: &Coordinates<Number>| contact(variation, u).normal;
        let leaves = self.after.phase == Phase::Flying
            && normal(self.variation, u).value.abs() < margin(self.variation, u).value.abs();
        if leaves {
            self.at_event(u, normal)
        } else {
            self.at_event(u, margin)
        }
    }

    /// A rim that slid leaves the table, where neither friction presses it to the table nor it would penetrate the table
    /// in flight.
    fn lifted_off(&self, u: &Coordinates<Number>) -> Coordinates<Number> {
        let t = self.before.start[TIME];
        self.at_event(u, |variation, u| {
            let phases = variation.phases(&self.motion.contacts, t);
            let falling = -(variation.k.m * phases.flying.rates(u).gap_rate);
            let normal = phases.in_phase(Phase::Sliding).contact(u).normal;
            normal.max(falling)
        })
    }

    /// A dry slip has stopped. The last step ends a little earlier, from where the slip decelerates in a straight line.
    ///
    /// A deviation across that line turns the friction until the slip has stopped along the line and across it, too. So the
    /// time until then and the angle, integrated over it, follow from both components, however the deviation decays.
    fn stopped_slipping(&self, u: &Coordinates<Number>) -> Coordinates<Number> {
        // The part of 1/rate in which the slip has to stop; it stops in far less unless its deceleration is zero, too.
        const BRIEF: f64 = 1e-3;
        let contacts = &self.motion.contacts;
        let t = self.before.start[TIME];
        let phases = self.variation.phases(contacts, t);
        let sliding = phases.in_phase(Phase::Sliding);
        let [x, y] = [u.slip_x.value, u.slip_y.value];
        let line = [x, y].map(|component| component / libm::hypot(x, y));
        let [speed, across] = along_and_across([u.slip_x, u.slip_y], line.map(Number::from));
        let sliding_at = |u: &Coordinates<Number>, speed: Number| {
            let [slip_x, slip_y] = line.map(|component| speed * component.into());
            let u = Coordinates {
                slip_x,
                slip_y,
                ..*u
            };
            (u, sliding.rates(&u))
        };
        let slips = |rates: &Coordinates<Number>| {
            along_and_across([rates.slip_x, rates.slip_y], line.map(Number::from))
        };
        let (straight, rates) = sliding_at(u, speed);
        let half = Number::from(-0.5) * speed / slips(&rates)[0];
        let (half_way, rates) = sliding_at(&straight.plus(half, &rates), Number::from(0.5) * speed);
        let turning = self.turning_rates(&values(&half_way), t);
        let ([forward, sideways], [turning_forward, turning_sideways]) =
            (slips(&rates), slips(&turning));
        let determinant = forward * turning_sideways - sideways * turning_forward;
        let time = (across * turning_forward - speed * turning_sideways) / determinant;
        let angle = (speed * sideways - across * forward) / determinant;
        let stopped = Coordinates {
            slip_x: 0.0.into(),
            slip_y: 0.0.into(),
            ..u.plus(time, &rates).plus(angle, &turning)
        };
        let rate = ErrorScale::new(contacts.parameters()).rate(&values(u));
        let is_brief = (0.0..=BRIEF).contains(&(time.value * rate));
        let undefined = [!is_brief; SHAKEN_PARAMETERS.len()];
        let start = &self.after.start;
        with_values(&without(&stopped, undefined), start)
    }

    /// The derivatives of the rates of a rim that slides by the angle of its slip, in a step that begins at a time, s.
    fn turning_rates(&self, u: &Coordinates<f64>, t: f64) -> Coordinates<Number> {
        let phases = self.motion.contacts.dual_phases_from(t);
        let dual = |value: f64, slope: f64| Dual { value, slope };
        let mut turned = Coordinates::from_array(&u.into_array().map(Dual::from));
        turned.slip_x = dual(u.slip_x, -u.slip_y);
        turned.slip_y = dual(u.slip_y, u.slip_x);
        let rates = phases.in_phase(Phase::Sliding).rates(&turned);
        Coordinates::from_array(&rates.into_array().map(|rate| rate.slope.into()))
    }

    /// The rim has struck the table.
    fn landed(&self, u: &Coordinates<Number>) -> Result<Coordinates<Number>, InvalidInput> {
        let contacts = &self.motion.contacts;
        let law = contacts.contact_law();
        let u = self.at_event(u, |_, u| u.gap);
        let speed = u.slip_x.hypot(u.slip_y);
        let friction = law.friction.impact_coefficient(speed);
        // The slip across e_x1 is zero in a planar motion. Beside it, the direction of friction changes without bound if
        // the slip stops in the impact.
        let is_planar = u.slip_y.value == 0.0 && friction.value > 0.0;
        let beside = u.slip_y.slope.0.map(|slope| is_planar && slope != 0.0);
        let rest = contacts.stopped_speed(&values(&u));
        let after = impact::resolve(&self.variation.k, &u, friction, law.restitution, rest)
            .ok_or_else(|| refused("an impact cannot be followed"))?;
        let after = without(&after, beside);
        Ok(match self.after.phase {
            Phase::Rolling => Coordinates {
                slip_x: 0.0.into(),
                slip_y: 0.0.into(),
                ..after
            },
            _ => after,
        })
    }

    fn at_event(
        &self,
        u: &Coordinates<Number>,
        function: impl Fn(&Variation, &Coordinates<Number>) -> Number,
    ) -> Coordinates<Number> {
        self.variation
            .at_event(&self.motion.contacts, self.before, u, function)
    }

    /// Whether the base came down flat at once.
    fn is_flat(&self) -> bool {
        let end = Coordinates::from_array(&self.before.end);
        let gap = (1.0 + LEVEL) * self.motion.contacts.sine_at_gap();
        let falls = if end.cos < 0.0 {
            end.p > 0.0
        } else {
            end.p < 0.0
        };
        falls && end.sin.abs() <= gap.max(2.0 * FLAT_TILT)
    }

    /// The velocity of the centre of mass of a rim that slides.
    fn velocity(&self, u: &Coordinates<Number>) -> Option<[Number; 2]> {
        let phases = self
            .variation
            .phases(&self.motion.contacts, self.before.start[TIME]);
        (self.before.phase != Phase::Rolling)
            .then(|| phases.in_phase(self.before.phase).center_velocity(u))
    }

    /// A body that stood departs.
    fn departed(&self, u: &Coordinates<Number>) -> Coordinates<Number> {
        if self.after.phase.is_level() {
            return self.at_departure(u);
        }
        let from = (Phase::Standing, self.before.end[TIME]);
        self.with_level(self.variation, from, u.yaw, |motion| {
            let (force, _) = motion.equations.field(motion.acceleration(u.t));
            motion.equations.uplifted(u, force)
        })
    }

    /// The coordinates at the time at which a body that stands or slides flat departs.
    pub(super) fn at_departure(&self, u: &Coordinates<Number>) -> Coordinates<Number> {
        // The part of gravity by which a continuous margin can differ from zero by rounding.
        const ROUNDING: f64 = 1e-9;
        if self.before.phase != Phase::Standing {
            return self.at_event(u, |variation, u| self.flat_friction(variation, u).1);
        }
        let holding = self.motion.contacts.holding_friction();
        let from = (Phase::Standing, self.before.end[TIME]);
        let margin = |variation: &Variation, u: &Coordinates<Number>| {
            self.with_level(variation, from, u.yaw, |motion| {
                let acceleration = motion.acceleration(u.t);
                motion.equations.standing_margin(holding, acceleration)
            })
        };
        // Where the acceleration jumps, or where nothing holds the body, the time is fixed.
        let jumps = margin(self.variation, u).value < -ROUNDING * self.variation.k.g.value;
        if jumps || holding == 0.0 {
            *u
        } else {
            self.at_event(u, margin)
        }
    }

    /// The friction on a base that slides flat, N, and the margin of its flatness.
    fn flat_friction(
        &self,
        variation: &Variation,
        u: &Coordinates<Number>,
    ) -> ([Number; 2], Number) {
        let from = (self.before.phase, self.before.start[TIME]);
        self.with_level(variation, from, u.yaw, |motion| {
            let gravity = motion.equations.field(motion.acceleration(u.t)).1;
            let friction = motion.equations.friction([u.slip_x, u.slip_y], gravity);
            let margin = motion.equations.flatness_margin(friction, gravity);
            (friction, margin)
        })
    }

    fn with_level<R>(
        &self,
        variation: &Variation,
        from: (Phase, f64),
        yaw: Number,
        computation: impl FnOnce(&LevelMotion<'_, Number>) -> R,
    ) -> R {
        variation.with_level(&self.motion.contacts, from, yaw, computation)
    }

    /// A level base that slid or flew changes its contact.
    fn after_level_motion(&self, u: &Coordinates<Number>) -> Coordinates<Number> {
        let contacts = &self.motion.contacts;
        let from = (self.before.phase, self.before.start[TIME]);
        let gravity = |variation: &Variation, u: &Coordinates<Number>| {
            self.with_level(variation, from, u.yaw, |motion| {
                motion.equations.field(motion.acceleration(u.t)).1
            })
        };
        match (self.before.phase, self.after.phase) {
            (Phase::FlyingLevel, _) => {
                let u = self.at_event(u, |_, u| u.gap);
                let gap_rate = if self.after.phase == Phase::FlyingLevel {
                    u.gap_rate * Number::from(-contacts.contact_law().restitution)
                } else {
                    0.0.into()
                };
                let gap = 0.0.into();
                Coordinates { gap, gap_rate, ..u }
            }
            (_, Phase::Standing) => {
                let u = self.at_event(u, |_, u| u.slip_x * u.slip_x + u.slip_y * u.slip_y);
                let [slip_x, slip_y] = [0.0.into(); 2];
                Coordinates {
                    slip_x,
                    slip_y,
                    ..u
                }
            }
            (_, Phase::FlyingLevel) => self.at_event(u, gravity),
            _ => {
                let (force, _) = self.flat_friction(self.variation, u);
                self.with_level(self.variation, from, u.yaw, |motion| {
                    motion.equations.uplifted(u, force)
                })
            }
        }
    }

    /// A body that rocked stands, or slides flat.
    fn stood(&self, u: &Coordinates<Number>) -> Result<Coordinates<Number>, InvalidInput> {
        let has_turned = self.before.end[0] != self.after.start[0];
        let u = if self.is_flat() && has_turned {
            self.landed_flat(u)?
        } else if self.is_flat() {
            // It hardly rocked, and did not go on to the opposite point of the rim.
            self.at_event(u, flat_function(&self.motion.contacts, &self.before.end))
        } else {
            self.at_event(u, |variation, u| {
                tilting_energy_over_standing(&variation.k, u)
            })
        };
        Ok(levelled(&u, self.velocity(&u)))
    }

    /// A body that toppled lies on its side.
    fn fallen(&self, u: &Coordinates<Number>) -> Coordinates<Number> {
        let end = Coordinates::from_array(&self.before.end);
        self.at_event(u, |_, u| tilt_from(&end, u))
    }

    /// The whole base came down flat at once.
    fn landed_flat(&self, u: &Coordinates<Number>) -> Result<Coordinates<Number>, InvalidInput> {
        let k = &self.variation.k;
        let (contacts, end) = (&self.motion.contacts, &self.before.end);
        if is_below_gap(contacts, end) {
            return Err(refused("the base comes down flat from below flat_gap"));
        }
        let at = self.at_event(u, flat_function(contacts, end));
        let first = on_first_face(&at);
        let has_gap = contacts.has_gap(self.before.phase);
        if !has_gap && contacts.is_beside_plane(&values(&first)) {
            return Err(refused("the base comes down flat beside a plane"));
        }
        // Over a gap, a body beside its plane falls and goes on as in it, unless it runs round the rim.
        let is_smooth = matches!(self.motion.flat, FlatLanding::Smooth(_));
        let u = if !has_gap || is_smooth && first.w.value == 0.0 {
            self.in_plane(&first)
        } else {
            first
        };
        let u = if has_gap || u.w.value != 0.0 {
            self.over_gap(&u)
        } else {
            u
        };
        let velocity = self.velocity(&u);
        let factor = match self.motion.flat {
            FlatLanding::Smooth(_) => {
                let after = self.run_round(&u, velocity)?;
                return Ok(on_face_of(&at, &after));
            }
            FlatLanding::Restitution(factor) => factor.into(),
            FlatLanding::Housner | FlatLanding::Stop => {
                plastic_factor(k, self.before.phase == Phase::Rolling)
            }
        };
        Ok(on_face_of(&at, &rocked_over(k, &u, factor, velocity)))
    }

    /// The body with its base flat, at the end of the fall over the gap.
    fn over_gap(&self, u: &Coordinates<Number>) -> Coordinates<Number> {
        let (contacts, phase) = (&self.motion.contacts, self.before.phase);
        let phases = self.variation.phases(contacts, self.before.start[TIME]);
        let friction = &contacts.contact_law().friction;
        fallen(phases.in_phase(phase), friction, phase == Phase::Rolling, u)
    }

    /// The coordinates without derivatives (NaN) by those parameters that take a motion out of its plane.
    fn in_plane(&self, u: &Coordinates<Number>) -> Coordinates<Number> {
        // Relative to √(g/R) when the parameter changes by its own size.
        const ROUNDING: f64 = 1e-9;
        let k = self.motion.contacts.parameters();
        let rate = (k.g / k.r).sqrt();
        let sizes = sizes_of_parameters(k);
        // w = ψ̇ sin φ grows like 1/sin φ in a fall, but not w sin φ.
        let sideways = |i: usize| {
            let (w, s) = (u.w.slope.0[i] * u.sin.value, u.s.slope.0[i]);
            sizes[i] * w.abs().max(s.abs())
        };
        without(u, core::array::from_fn(|i| sideways(i) > ROUNDING * rate))
    }

    /// The limit of a near-collision: the contact point has run round the rim.
    fn run_round(
        &self,
        u: &Coordinates<Number>,
        velocity: Option<[Number; 2]>,
    ) -> Result<Coordinates<Number>, InvalidInput> {
        let law = match (
            self.before.phase,
            &self.motion.contacts.contact_law().friction,
        ) {
            (_, FrictionLaw::NoSlip | FrictionLaw::InPlace) => IdealLaw::NoSlip,
            (_, FrictionLaw::Frictionless) => IdealLaw::Frictionless,
            _ => {
                return Err(refused(
                    "the base comes down flat and smoothly under friction",
                ));
            }
        };
        let spins = u.w.value != 0.0 || u.s.value != 0.0;
        if spins && self.motion.contacts.contact_law().friction != FrictionLaw::InPlace {
            return Err(refused(
                "the base comes down flat and smoothly beside its plane",
            ));
        }
        if self.motion.contacts.contact_law().resists() {
            return Err(refused(
                "the base comes down flat and smoothly with resistance",
            ));
        }
        let k = &self.variation.k;
        let (j, inertia) = inertias_of(k, law);
        let [from, to] = [self.before.end[0], self.after.start[0]];
        // The turn is larger than the change of direction in the fall.
        let side = if to < from { -PI } else { PI };
        let turn = (j / inertia).sqrt() * Number::from(side);
        let (sin, cos) = turn.sin_cos();
        let turned = |[x, y]: [Number; 2]| [x * cos + y * sin, y * cos - x * sin];
        let [x1, y1] = turned([u.x1, u.y1]);
        let after = Coordinates {
            yaw: u.yaw + turn,
            spin: u.spin - turn,
            sin: UPLIFT_TILT.into(),
            cos: 1.0.into(),
            p: u.p.abs(),
            w: 0.0.into(),
            x1,
            y1,
            ..*u
        };
        let Some(velocity) = velocity else {
            return Ok(after);
        };
        let ([vx, vy], [rolling_x, rolling_y]) = (turned(velocity), k.rolling_velocity(&after));
        Ok(Coordinates {
            slip_x: vx - rolling_x,
            slip_y: vy - rolling_y,
            ..after
        })
    }
}

/// The part by which the tilt at which the gap closes may differ by rounding.
const LEVEL: f64 = 1e-6;

/// Whether the tilt at the end of a step is smaller than that at which the gap under the base closes.
fn is_below_gap(contacts: &Contacts, end: &[f64; COORDINATES]) -> bool {
    Coordinates::from_array(end).sin < (1.0 - LEVEL) * contacts.sine_at_gap()
}

/// The event function of a base that has come down flat at the end of a step: the tilt over that at which the gap closes or,
/// below it, the tilt rate.
pub(super) fn flat_function(
    contacts: &Contacts,
    end: &[f64; COORDINATES],
) -> impl Fn(&Variation, &Coordinates<Number>) -> Number + use<> {
    let half_gap = Number::from(0.5 * contacts.flat_gap());
    let is_below = is_below_gap(contacts, end);
    move |variation, u| {
        if is_below {
            u.p
        } else {
            u.sin - half_gap / variation.k.r
        }
    }
}

/// The sine of the tilt over that at an instant, whose tilt is held.
pub(super) fn tilt_from(held: &Coordinates<f64>, u: &Coordinates<Number>) -> Number {
    let [sin, cos]: [Number; 2] = [held.sin.into(), held.cos.into()];
    u.sin * cos - u.cos * sin
}

/// The error for a motion whose derivatives are not computed.
pub(super) fn refused(why: &str) -> InvalidInput {
    InvalidInput::NoSensitivity {
        why: why.to_owned(),
    }
}
