//! What an event between two phases does to the derivatives.
//!
//! A phase ends where an event function g is zero, so the derivatives there are those at g = 0, among them that of
//! the time. The next phase begins with the derivative of the map that leads to it. (In the terms of nonsmooth
//! mechanics, the two together are the saltation matrix.) In particular:
//!
//! * At a corner of the table's acceleration g is the time itself, and the map is the identity. So the derivatives at a
//!   fixed time are continuous there, although the rates jump.
//! * A body that stands is lifted at a time t_u that depends on the parameters, unless the acceleration of the table
//!   jumps then. The rocking begins at t_u from a tilt and a tilt rate of zero, about the point of the rim opposite to the
//!   acceleration at t_u.
//! * Where the base comes down flat at once, a parameter that takes the motion out of its plane has no
//!   derivative: beside the plane, the contact point runs round the rim instead.

use super::on_moving_table::{Number, ShakenSlope, without};
use super::variation::Variation;
use crate::error::InvalidInput;
use crate::law::{FrictionLaw, IdealLaw};
use crate::motion::Motion;
use crate::motion::contacts::tilting_energy_over_standing;
use crate::motion::instant::Phase;
use crate::motion::landing::{FLAT_TILT, FlatLanding, UPLIFT_TILT, plastic_factor, rocked_over};
use crate::motion::level::levelled;
use crate::motion::step_record::StepRecord;
use crate::real::Real;
use crate::state::{Coordinates, TIME};
use crate::turn::inertias_of;
use core::f64::consts::PI;

/// The end of one step and the start of the next.
pub(super) struct Junction<'a> {
    pub(super) motion: &'a Motion,
    pub(super) variation: &'a Variation,
    pub(super) before: &'a StepRecord,
    pub(super) after: &'a StepRecord,
}

impl Junction<'_> {
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
            _ => {
                return Err(refused(
                    "the contact changes on the way between rolling, sliding and flight",
                ));
            }
        };
        Ok(match after {
            // The state is constant from then on.
            Phase::Lying => Coordinates {
                t: u.t.value.into(),
                ..u
            },
            Phase::Standing => Coordinates {
                t: u.t.value.into(),
                slip_x: 0.0.into(),
                slip_y: 0.0.into(),
                ..u
            },
            _ => u,
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
        end.p < 0.0 && end.sin.abs() <= 2.0 * FLAT_TILT
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
        // The part of gravity by which a continuous margin can differ from zero by rounding.
        const ROUNDING: f64 = 1e-9;
        let contacts = &self.motion.contacts;
        let holding = contacts.holding_friction();
        let from = (Phase::Standing, self.before.end[TIME]);
        let margin = |variation: &Variation, u: &Coordinates<Number>| {
            variation.with_level(contacts, from, u.yaw, |motion| {
                let acceleration = motion.acceleration(u.t);
                motion.equations.standing_margin(holding, acceleration)
            })
        };
        // Where the acceleration jumps, or where nothing holds the body, the time is fixed.
        let jumps = margin(self.variation, u).value < -ROUNDING * self.variation.k.g.value;
        let u = if jumps || holding == 0.0 {
            *u
        } else {
            self.at_event(u, margin)
        };
        match self.after.phase {
            Phase::Rolling | Phase::Sliding => {
                self.variation.with_level(contacts, from, u.yaw, |motion| {
                    let (force, _) = motion.equations.field(motion.acceleration(u.t));
                    motion.equations.uplifted(&u, force)
                })
            }
            _ => u,
        }
    }

    /// A level base that slid or flew changes its contact.
    fn after_level_motion(&self, u: &Coordinates<Number>) -> Coordinates<Number> {
        let contacts = &self.motion.contacts;
        let from = (self.before.phase, self.before.start[TIME]);
        let gravity = |variation: &Variation, u: &Coordinates<Number>| {
            variation.with_level(contacts, from, u.yaw, |motion| {
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
                let friction = |variation: &Variation, u: &Coordinates<Number>| {
                    variation.with_level(contacts, from, u.yaw, |motion| {
                        let gravity = motion.equations.field(motion.acceleration(u.t)).1;
                        let slip = [u.slip_x, u.slip_y];
                        let friction = motion.equations.friction(slip, gravity);
                        (
                            friction,
                            motion.equations.flatness_margin(friction, gravity),
                        )
                    })
                };
                let u = self.at_event(u, |variation, u| friction(variation, u).1);
                let (force, _) = friction(self.variation, &u);
                self.variation.with_level(contacts, from, u.yaw, |motion| {
                    motion.equations.uplifted(&u, force)
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
            self.at_event(u, |_, u| u.sin)
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
        let u = self.at_event(u, |_, u| u.sin);
        let u = self.in_plane(&u);
        let velocity = self.velocity(&u);
        let factor = match self.motion.flat {
            FlatLanding::Smooth(_) => return self.run_round(&u, velocity),
            FlatLanding::Restitution(factor) => factor.into(),
            FlatLanding::Housner | FlatLanding::Stop => {
                plastic_factor(k, self.before.phase == Phase::Rolling)
            }
        };
        Ok(rocked_over(k, &u, factor, velocity))
    }

    /// The coordinates without derivatives (NaN) by those parameters that take a motion out of its plane.
    fn in_plane(&self, u: &Coordinates<Number>) -> Coordinates<Number> {
        // Relative to √(g/R) when the parameter changes by its own size.
        const ROUNDING: f64 = 1e-9;
        let k = self.motion.contacts.parameters();
        let rate = (k.g / k.r).sqrt();
        let sizes: ShakenSlope = [
            1.0, rate, 1.0, rate, 1.0, rate, k.m, k.r, k.h, k.a, k.c, k.g, 1.0,
        ];
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
        if self.motion.contacts.contact_law().resists() {
            return Err(refused(
                "the base comes down flat and smoothly with resistance",
            ));
        }
        let k = &self.variation.k;
        let (j, inertia) = inertias_of(k, law);
        let [from, to] = [self.before.end[0], self.after.start[0]];
        let turn = (j / inertia).sqrt() * Number::from(if to < from { -PI } else { PI });
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
