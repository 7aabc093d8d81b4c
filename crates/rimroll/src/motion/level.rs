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
use super::landing::UPLIFT_TILT;
use crate::ground::{Ground, Stretch};
use crate::law::{Contact, Dynamics, Parameters};
use crate::solve::{Dense, Step, Stepper, System, bracketed_root};
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

/// The equations of a body whose base is level, at one heading of its coordinates.
pub(super) struct Level<'a> {
    contacts: &'a Contacts,
    k: Parameters<f64>,
    /// The cosine and the sine of the yaw, which stays the same.
    heading: [f64; 2],
}

impl<'a> Level<'a> {
    pub(super) fn new(contacts: &'a Contacts, yaw: f64) -> Self {
        let (sin, cos) = libm::sincos(yaw);
        Level {
            contacts,
            k: *contacts.parameters(),
            heading: [cos, sin],
        }
    }

    /// The horizontal acceleration of the table along e_x1 and e_y1, and G, m/s².
    fn field(&self, [x, y, z]: [f64; 3]) -> ([f64; 2], f64) {
        let [cos, sin] = self.heading;
        ([x * cos + y * sin, y * cos - x * sin], self.k.g + z)
    }

    fn field_at(&self, t: f64) -> ([f64; 2], f64) {
        let ground = self.contacts.ground();
        self.field(ground.map_or([0.0; 3], |ground| ground.acceleration(t)))
    }

    /// The speed scale √(gR), m/s.
    fn speed_scale(&self) -> f64 {
        (self.k.g * self.k.r).sqrt()
    }

    /// A speed that counts as none, m/s.
    fn no_speed(&self) -> f64 {
        1e-12 * self.speed_scale()
    }

    /// The largest |a|/G at which the body stands.
    fn standing_limit(&self) -> f64 {
        let holding = match &self.contacts.contact_law().friction {
            friction if friction.never_slips() => f64::INFINITY,
            friction => friction.static_friction().unwrap_or(0.0),
        };
        holding.min(self.k.r / self.k.h)
    }

    /// A gravity G that counts as none, m/s². Where a record has −g, rounding decides on the sign of G.
    fn no_gravity(&self) -> f64 {
        1e-12 * self.k.g
    }

    /// Positive while a body stands flat: the margin of the horizontal acceleration, or of G where that is negative or
    /// nothing else can move the body.
    fn standing_margin(&self, acceleration: [f64; 3]) -> f64 {
        let (horizontal, gravity) = self.field(acceleration);
        let pressing = gravity + self.no_gravity();
        let limit = self.standing_limit();
        if pressing <= 0.0 || limit == f64::INFINITY {
            return pressing;
        }
        limit * pressing - size(horizontal)
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
        let (_, gravity) = self.field_at(t + 1e-9 * (self.k.r / self.k.g).sqrt());
        let limit = self.standing_limit();
        if gravity <= 0.0 || limit == f64::INFINITY {
            Departure::FallAway
        } else if limit * self.k.h < self.k.r {
            Departure::Slide
        } else {
            Departure::Uplift
        }
    }

    /// The coordinates of a body that begins to slide flat.
    pub(super) fn beginning_to_slide(&self, u: &Coordinates<f64>) -> Coordinates<f64> {
        let ([x, y], _) = self.field_at(u.t);
        let faint = 100.0 * self.no_speed() / size([x, y]).max(f64::MIN_POSITIVE);
        Coordinates {
            slip_x: -faint * x,
            slip_y: -faint * y,
            ..*u
        }
    }

    /// The coordinates of a body that begins to rock. The force that makes it do so points along e_x1 then: it is that
    /// which accelerates the body with the table, or the friction on a base that slides.
    pub(super) fn uplifted(&self, u: &Coordinates<f64>, phase: Phase) -> Coordinates<f64> {
        let force = match phase {
            Phase::SlidingFlat => self.friction(u),
            _ => self.field_at(u.t).0,
        };
        let change = libm::atan2(force[1], force[0]);
        let turned = |[x, y]: [f64; 2]| {
            let (sin, cos) = libm::sincos(change);
            [x * cos + y * sin, y * cos - x * sin]
        };
        let [x1, y1] = turned([u.x1, u.y1]);
        let [slip_x, slip_y] = turned([u.slip_x, u.slip_y]);
        Coordinates {
            yaw: u.yaw + change,
            spin: u.spin - change,
            sin: UPLIFT_TILT,
            cos: 1.0,
            x1,
            y1,
            slip_x,
            slip_y,
            ..*u
        }
    }

    /// The friction on a base that slides, N.
    fn friction(&self, u: &Coordinates<f64>) -> [f64; 2] {
        let (_, gravity) = self.field_at(u.t);
        let dynamics = self.contacts.dynamics(Phase::Sliding);
        dynamics.flat_friction([u.slip_x, u.slip_y], self.k.m * gravity)
    }

    /// The force of the table on a body whose base is level, N.
    pub(super) fn force(&self, at: &Instant) -> Contact<f64> {
        let (horizontal, gravity) = self.field_at(at.t);
        let (friction, normal) = match at.phase {
            Phase::FlyingLevel => ([0.0; 2], 0.0),
            Phase::SlidingFlat => (self.friction(at), self.k.m * gravity),
            _ => (horizontal.map(|a| self.k.m * a), self.k.m * gravity),
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
            level: self,
            dynamics: self.contacts.dynamics(Phase::Sliding),
            stretch,
            slides: phase == Phase::SlidingFlat,
            is_dry: self.contacts.is_dry(),
        }
    }

    /// A body that stands from the time in `u` to `end`.
    pub(super) fn standing(u: &Coordinates<f64>, end: f64) -> Dense<f64, COORDINATES> {
        let later = Coordinates { t: end, ..*u };
        Dense::line(end - u.t, u.into_array(), later.into_array())
    }
}

fn size([x, y]: [f64; 2]) -> f64 {
    libm::hypot(x, y)
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

/// The equations of motion of a level base that slides or flies.
pub(super) struct LevelMotion<'a> {
    level: &'a Level<'a>,
    dynamics: &'a dyn Dynamics<f64>,
    stretch: Option<Stretch>,
    slides: bool,
    is_dry: bool,
}

/// The number of coordinates that change in such a motion.
const LEVEL: usize = 9;

/// The places of those coordinates among all of them: t, x1, y1, slip_x, slip_y, gap, gap_rate, friction_loss and
/// ground_work.
const PLACES: [usize; LEVEL] = [TIME, 8, 9, 10, 11, 12, 13, 14, 17];

/// A part of such a motion: its dense output, and what ends it.
pub(super) struct LevelPart {
    pub(super) dense: Dense<f64, COORDINATES>,
    pub(super) departure: Option<Departure>,
}

impl LevelMotion<'_> {
    /// The rates with respect to the time.
    fn rates_in_time(&self, u: &[f64; LEVEL]) -> [f64; LEVEL] {
        let [t, _, _, vx, vy, _, gap_rate, ..] = *u;
        let k = &self.level.k;
        let acceleration = self
            .stretch
            .as_ref()
            .map_or([0.0; 3], |s| s.acceleration(t));
        let ([ax, ay], gravity) = self.level.field(acceleration);
        let [fx, fy] = if self.slides {
            self.dynamics.flat_friction([vx, vy], k.m * gravity)
        } else {
            [0.0; 2]
        };
        let falling = if self.slides { 0.0 } else { -gravity };
        let work = -k.m * (ax * vx + ay * vy + acceleration[2] * gap_rate);
        let (dvx, dvy) = (fx / k.m - ax, fy / k.m - ay);
        let loss = -(fx * vx + fy * vy);
        [1.0, vx, vy, dvx, dvy, gap_rate, falling, loss, work]
    }

    /// dt/dσ: the direction of dry friction on a base that is about to stop changes at a rate that grows like 1/|v|.
    fn time_rate(&self, [vx, vy]: [f64; 2]) -> f64 {
        if self.slides && self.is_dry {
            let speed = size([vx, vy]);
            speed / (speed + 0.03 * self.level.speed_scale())
        } else {
            1.0
        }
    }

    /// The values that are positive until a departure.
    fn margins(&self, u: &[f64; LEVEL]) -> [(Departure, f64); 4] {
        let [t, _, _, vx, vy, gap, ..] = *u;
        let k = &self.level.k;
        let acceleration = self
            .stretch
            .as_ref()
            .map_or([0.0; 3], |s| s.acceleration(t));
        let gravity = k.g + acceleration[2];
        if !self.slides {
            return [
                (Departure::Land, gap),
                (Departure::Stick, 1.0),
                (Departure::Uplift, 1.0),
                (Departure::FallAway, 1.0),
            ];
        }
        let friction = self.dynamics.flat_friction([vx, vy], k.m * gravity);
        let stops = self.is_dry;
        [
            (Departure::FallAway, gravity + self.level.no_gravity()),
            (
                Departure::Uplift,
                k.m * gravity * k.r - size(friction) * k.h,
            ),
            (
                Departure::Stick,
                if stops {
                    size([vx, vy]) - self.level.no_speed()
                } else {
                    1.0
                },
            ),
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

impl System<f64, LEVEL> for LevelMotion<'_> {
    #[inline(never)]
    fn rates(&self, u: &[f64; LEVEL]) -> [f64; LEVEL] {
        let factor = self.time_rate([u[3], u[4]]);
        self.rates_in_time(u).map(|rate| factor * rate)
    }

    fn scale(&self, u: &[f64; LEVEL]) -> [f64; LEVEL] {
        let [_, x, y, vx, vy, gap, gap_rate, ..] = *u;
        let Parameters { m, r, .. } = self.level.k;
        let unit = self.level.speed_scale();
        let speed = size([vx, vy]);
        let slow = if self.slides && self.is_dry {
            self.level.no_speed()
        } else {
            1e-3 * unit
        };
        let distance = r + size([x, y]);
        let energy = m * (speed + gap_rate.abs() + unit) * (speed + gap_rate.abs() + unit);
        [
            r / unit,
            distance,
            distance,
            speed + slow,
            speed + slow,
            gap + 1e-6 * r,
            gap_rate.abs() + 1e-6 * unit,
            energy,
            energy,
        ]
    }
}

/// The coordinates of a body that comes to stand flat or to slide flat.
pub(super) fn levelled(contacts: &Contacts, at: &Instant) -> Coordinates<f64> {
    let slides = at.phase != Phase::Rolling;
    let [vx, vy] = contacts.dynamics(at.phase).center_velocity(at);
    // A disk on its other face keeps that face down.
    let (sin, cos) = (0.0, if at.cos < 0.0 { -1.0 } else { 1.0 });
    Coordinates {
        sin,
        cos,
        p: 0.0,
        w: 0.0,
        s: 0.0,
        slip_x: if slides { vx } else { 0.0 },
        slip_y: if slides { vy } else { 0.0 },
        gap: 0.0,
        gap_rate: 0.0,
        ..at.u
    }
}
