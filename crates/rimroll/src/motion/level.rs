//! A body whose base is level: it stands flat on the table, slides flat on it, or is level and off the table.
//!
//! Its tilt is zero, where the clock of the other equations, dt = sin φ dτ, stands still. But it only translates, so
//! that a few equations in the time suffice. Relative to the table, with the horizontal acceleration a of the table,
//! G = g + a_z and the friction T on the base:
//!
//! ```text
//! m v̇ = −m a + T,    gap̈ = −G off the table
//! ```
//!
//! A body that stands begins to rock (uplift) where |a| H > G R: it turns about the point of the rim opposite to a. It
//! begins to slide where |a| > μ_s G, unless it rocks before. A body that slides flat begins to rock where |T| H > m G R.
//! The table falls away where G < 0.

use super::contacts::Contacts;
use super::instant::{Instant, Phase};
use super::level_equations::{LEVEL, LevelEquations, LevelMotion, PLACES, size};
use crate::ground::{Ground, Stretch};
use crate::law::Contact;
use crate::real::Real;
use crate::solve::{Dense, Step, Stepper, bracketed_root};
use crate::state::{COORDINATES, Coordinates, TIME};
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
pub(super) struct Level<'a> {
    contacts: &'a Contacts,
    equations: LevelEquations<'a, f64>,
}

impl<'a> Level<'a> {
    pub(super) fn new(contacts: &'a Contacts, yaw: f64) -> Self {
        let k = *contacts.parameters();
        let sliding = contacts.dynamics(Phase::Sliding);
        Level {
            contacts,
            equations: LevelEquations::new(k, yaw, sliding, contacts.is_dry()),
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

    /// Whether a body stands flat at a time, s.
    pub(super) fn stands(&self, t: f64) -> bool {
        let ground = self.contacts.ground();
        let acceleration = ground.map_or([0.0; 3], |ground| ground.acceleration(t));
        self.standing_margin(acceleration) >= 0.0
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
        // On a record, which is linear here, the margin is concave: its minimum is at an end.
        let width = (ground.shortest_period(begin) / SAMPLES).min(end - begin);
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
    pub(super) fn motion(&self, phase: Phase, stretch: Option<Stretch>) -> LevelMotion<'_> {
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

/// A part of the motion of a level base that slides or flies: its dense output, and what ends it.
pub(super) struct LevelPart {
    pub(super) dense: Dense<f64, COORDINATES>,
    pub(super) departure: Option<Departure>,
}

impl LevelMotion<'_> {
    /// The values that are positive until a departure.
    fn margins(&self, u: &[f64; LEVEL]) -> [(Departure, f64); 4] {
        let [t, _, _, vx, vy, gap, ..] = *u;
        if !self.slides {
            return [
                (Departure::Land, gap),
                (Departure::Stick, 1.0),
                (Departure::Uplift, 1.0),
                (Departure::FallAway, 1.0),
            ];
        }
        let equations = &self.equations;
        let (_, gravity) = equations.field(self.acceleration(t));
        let friction = equations.friction([vx, vy], gravity);
        let excess_speed = if self.can_stop() {
            size([vx, vy]) - equations.no_speed()
        } else {
            1.0
        };
        [
            (Departure::FallAway, gravity + equations.no_gravity()),
            (
                Departure::Uplift,
                equations.flatness_margin(friction, gravity),
            ),
            (Departure::Stick, excess_speed),
            (Departure::Land, 1.0),
        ]
    }

    /// The next part of the motion from `u` until `end` (s) at most. `h` is the size of the next step of σ.
    pub(super) fn next_part(
        &self,
        u: &Coordinates<f64>,
        end: f64,
        h: &mut f64,
        tolerance: f64,
    ) -> Option<LevelPart> {
        let all = u.into_array();
        let start = PLACES.map(|place| all[place]);
        if let Some((_, departure)) = self.departed(&start, None) {
            let dense = Dense::empty(all);
            let departure = Some(departure);
            return Some(LevelPart { dense, departure });
        }
        // A step far beyond the end of the stretch would be accurate at its own end only.
        const OVERSHOOT: f64 = 1.1;
        let remaining = end - u.t;
        let limited = |h: f64| h.min(remaining / self.time_rate([u.slip_x, u.slip_y]));
        let mut tried = limited(*h);
        let dense = loop {
            let mut stepper = Stepper::new(self, start, tried, tolerance);
            let step: &mut Step<f64, LEVEL> = stepper.advance().ok()?;
            let elapsed = step.end[0] - u.t;
            if elapsed <= OVERSHOOT * remaining {
                let dense = step.dense(self);
                *h = stepper.h;
                break dense;
            }
            tried = step.h * (remaining / elapsed).max(0.1);
        };
        let placed = |dense: &Dense<f64, LEVEL>| dense.placed(&all, &PLACES);
        let mut before = 0.0;
        for x in [0.25, 0.5, 0.75, 1.0] {
            let (from, to) = (dense.at(before), dense.at(x));
            let over = to[0] >= end;
            if let Some((index, departure)) = self.departed(&to, Some(&from)) {
                let margin = |x: f64| self.margins(&dense.at(x))[index].1;
                let root = bracketed_root(before, x, margin);
                if !over || dense.at(root)[0] < end {
                    let dense = placed(&dense.cut(root));
                    let departure = Some(departure);
                    return Some(LevelPart { dense, departure });
                }
            }
            if over {
                let mut dense = placed(&dense.cut(dense.fraction_where(0, end)));
                dense.end[TIME] = end;
                let departure = None;
                return Some(LevelPart { dense, departure });
            }
            before = x;
        }
        let departure = None;
        Some(LevelPart {
            dense: placed(&dense),
            departure,
        })
    }

    /// The first margin that has become negative at `to`, by its index. A slip that has just begun is slow, but it does
    /// not end, and a body that has just left the table is near it.
    fn departed(
        &self,
        to: &[f64; LEVEL],
        from: Option<&[f64; LEVEL]>,
    ) -> Option<(usize, Departure)> {
        let before = from.map(|from| self.margins(from));
        let mut after = self.margins(to).into_iter().enumerate();
        after.find_map(|(i, (departure, margin))| {
            let falls = match (&before, &departure) {
                (Some(before), _) => margin < before[i].1,
                (None, Departure::Stick | Departure::Land) => false,
                (None, _) => true,
            };
            (margin < 0.0 && falls).then_some((i, departure))
        })
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
