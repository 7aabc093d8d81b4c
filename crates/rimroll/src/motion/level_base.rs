//! A body whose base is level: it stands flat on the table, slides flat on it, or is level and off the table.
//!
//! Its tilt is zero, and with dt = sin φ dτ no time passes there, so the other equations cannot describe it. But it
//! only translates, so a few equations in the time suffice. Relative to the table, with the horizontal acceleration a of the table,
//! G = g + a_z and the friction T on the base:
//!
//! ```text
//! m v̇ = −m a + T,    gap̈ = −G off the table
//! ```
//!
//! A body that stands begins to rock (uplift) where |a| H > G R: it turns about the point of the rim opposite to a. It
//! begins to slide where |a| > μ_s G, unless it rocks before. A body that slides flat begins to rock where |T| H > m G R.
//! The table falls away where G < 0.

mod equations;
mod steps;

use equations::LevelEquations;
pub(super) use equations::{FLAT_TILT, LevelMotion, PLACES, UPLIFT_TILT};

use super::contacts::Contacts;
use super::instant::{Instant, Phase};
use crate::ground::{Ground, Stretch};
use crate::law::Contact;
use crate::real::Real;
use crate::solve::{Dense, bracketed_root};
use crate::state::{COORDINATES, Coordinates};
use equations::size;
use std::sync::Arc;

/// What a body whose base is level does next, and when.
pub(super) enum Departure {
    /// It begins to rock.
    Uplift,
    /// It begins to slide flat.
    Slide,
    /// It stops sliding and stands.
    Stick,
    /// The table falls away.
    FallAway,
    /// It comes back to the table.
    Land,
    /// The time is up.
    Done,
}

/// A body whose base is level, at one heading of its coordinates.
pub(super) struct LevelBase<'a> {
    contacts: &'a Contacts,
    equations: LevelEquations<'a, f64>,
}

impl<'a> LevelBase<'a> {
    pub(super) fn new(contacts: &'a Contacts, yaw: f64) -> Self {
        let k = *contacts.parameters();
        let sliding = contacts.dynamics(Phase::Sliding);
        let peak = contacts
            .ground()
            .map_or(0.0, |ground| ground.straight_peak());
        LevelBase {
            contacts,
            equations: LevelEquations::new(k, yaw, sliding, contacts.is_dry(), peak),
        }
    }

    fn field_at(&self, t: f64) -> ([f64; 2], f64) {
        let ground = self.contacts.ground();
        self.equations
            .field(ground.map_or([0.0; 3], |ground| ground.acceleration(t)))
    }

    /// Positive while a body stands flat.
    fn standing_margin(&self, acceleration: [f64; 3]) -> f64 {
        let holding = self.contacts.holding_friction();
        self.equations.standing_margin(holding, acceleration)
    }

    /// Whether the table presses against the base at a time, s.
    pub(super) fn is_pressed(&self, t: f64) -> bool {
        self.field_at(t).1 > self.equations.no_gravity()
    }

    /// The duration of a bounce of a level body that has just left the table, s, if the table's acceleration stays the same.
    pub(super) fn bounce_time(&self, u: &Coordinates<f64>) -> f64 {
        let (_, gravity) = self.field_at(u.t);
        if u.gap_rate > 0.0 && gravity > 0.0 {
            2.0 * u.gap_rate / gravity
        } else {
            f64::INFINITY
        }
    }

    /// The time at which a body that stands departs, between `begin` and the end of a stretch or `end`; `None` if it
    /// stands throughout.
    pub(super) fn time_of_departure(
        &self,
        ground: &Arc<Ground>,
        begin: f64,
        end: f64,
    ) -> Option<f64> {
        // A pulse that changes direction within less than this fraction of its period is followed.
        const SAMPLES: f64 = 64.0;
        let stretch = ground.stretch(begin);
        let margin = |t: f64| self.standing_margin(stretch.acceleration(t));
        if margin(begin) < 0.0 {
            return Some(begin);
        }
        let period = ground.shortest_period(begin);
        if period == f64::INFINITY {
            // On a record, which is linear here, the margin is concave: its minimum is at an end.
            return (margin(end) < 0.0).then(|| bracketed_root(begin, end, margin));
        }
        let width = (period / SAMPLES).min(end - begin);
        let count = ((end - begin) / width).ceil().max(1.0);
        let time = |i: f64| if i < count { begin + i * width } else { end };
        let mut before = begin;
        let mut i = 0.0;
        while i < count {
            let after = time(i + 1.0);
            let lowest = lowest_between(before, after, margin);
            if margin(lowest) < 0.0 {
                return Some(bracketed_root(before, lowest, margin));
            }
            before = after;
            i += 1.0;
        }
        None
    }

    /// What follows where a body cannot stand.
    pub(super) fn departure_from_standing(&self, t: f64) -> Departure {
        // Where G is zero, what it becomes decides.
        let k = &self.equations.k;
        let (_, gravity) = self.field_at(t + 1e-9 * (k.r / k.g).sqrt());
        let holding = self.contacts.holding_friction();
        if gravity <= 0.0 || self.equations.standing_limit(holding) == f64::INFINITY {
            Departure::FallAway
        } else if self.slides_rather_than_rocks() {
            Departure::Slide
        } else {
            Departure::Uplift
        }
    }

    /// Whether a body that stands slides before it rocks.
    fn slides_rather_than_rocks(&self) -> bool {
        let k = &self.equations.k;
        self.contacts.holding_friction() < k.r / k.h
    }

    /// The coordinates of a body that begins to slide flat.
    pub(super) fn beginning_to_slide(&self, u: &Coordinates<f64>) -> Coordinates<f64> {
        let ([x, y], _) = self.field_at(u.t);
        let faint = 100.0 * self.equations.no_speed() / size([x, y]).max(f64::MIN_POSITIVE);
        Coordinates {
            slip_x: -faint * x,
            slip_y: -faint * y,
            ..*u
        }
    }

    /// The coordinates of a body that begins to rock.
    pub(super) fn uplifted(&self, u: &Coordinates<f64>, phase: Phase) -> Coordinates<f64> {
        let force = match phase {
            Phase::SlidingFlat => self.friction(u),
            _ => self.field_at(u.t).0,
        };
        self.equations.uplifted(u, force)
    }

    /// The friction on a base that slides, N.
    fn friction(&self, u: &Coordinates<f64>) -> [f64; 2] {
        let (_, gravity) = self.field_at(u.t);
        self.equations.friction([u.slip_x, u.slip_y], gravity)
    }

    /// The force of the table on a body whose base is level, N.
    pub(super) fn force(&self, at: &Instant) -> Contact<f64> {
        let (horizontal, gravity) = self.field_at(at.t);
        let m = self.equations.k.m;
        let (friction, normal) = match at.phase {
            Phase::FlyingLevel => ([0.0; 2], 0.0),
            Phase::SlidingFlat => (self.friction(at), m * gravity),
            _ => (horizontal.map(|a| m * a), m * gravity),
        };
        Contact {
            along: friction[0],
            across: friction[1],
            normal,
        }
    }

    /// The equations of a base that slides or flies, along a stretch of the table's motion.
    pub(super) fn motion(&self, phase: Phase, stretch: Option<Stretch>) -> LevelMotion<'a> {
        LevelMotion {
            equations: self.equations,
            stretch: stretch.map(|stretch| (stretch, 1.0)),
            slides: phase == Phase::SlidingFlat,
        }
    }

    /// A body that stands from the time in `u` to `end`.
    pub(super) fn standing(u: &Coordinates<f64>, end: f64) -> Dense<f64, COORDINATES> {
        let later = Coordinates { t: end, ..*u };
        Dense::line(end - u.t, u.into_array(), later.into_array())
    }
}

/// A time between two others at which `function` is near its smallest value there. It must have at most one minimum
/// between them.
fn lowest_between(from: f64, to: f64, function: impl Fn(f64) -> f64) -> f64 {
    const ROUNDS: usize = 30;
    let golden = 0.5 * (3.0 - 5.0_f64.sqrt());
    let (mut a, mut b) = (from, to);
    for _ in 0..ROUNDS {
        let (left, right) = (a + golden * (b - a), b - golden * (b - a));
        if function(left) < function(right) {
            b = right;
        } else {
            a = left;
        }
    }
    let inside = 0.5 * (a + b);
    if function(inside) < function(to) {
        inside
    } else {
        to
    }
}

/// The coordinates of a body that comes to stand flat or, with the velocity of a rim that slides (m/s, along e_x1 and
/// e_y1), to slide flat.
pub(super) fn levelled<T: Real>(u: &Coordinates<T>, velocity: Option<[T; 2]>) -> Coordinates<T> {
    let zero = T::from(0.0);
    let [slip_x, slip_y] = velocity.unwrap_or([zero; 2]);
    Coordinates {
        sin: zero,
        // A disk on its other face keeps that face down.
        cos: u.cos.where_negative(T::from(-1.0), T::from(1.0)),
        p: zero,
        w: zero,
        s: zero,
        slip_x,
        slip_y,
        gap: zero,
        gap_rate: zero,
        ..*u
    }
}
