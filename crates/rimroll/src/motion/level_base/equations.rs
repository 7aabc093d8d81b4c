//! The equations of a body whose base is level, for any number type.
//!
//! See [`level_base`](super).

use crate::ground::Stretch;
use crate::law::{Dynamics, Parameters, rounding_across};
use crate::motion::instant::Phase;
use crate::motion::phase_dynamics::PhaseDynamics;
use crate::real::Scalar;
use crate::solve::System;
use crate::state::{Coordinates, TIME};

/// The tilt at which rocking begins, rad. It is so small that the error is below rounding. It is not zero, because with
/// dt = sin φ dτ no time passes there.
pub(in crate::motion) const UPLIFT_TILT: f64 = 1e-15;

/// The tilt at which a base that falls on a table that moves is flat, rad. It is not zero, because with dt = sin φ dτ no
/// fall reaches zero, and it is above [`UPLIFT_TILT`], from which a body begins to rock.
pub(in crate::motion) const FLAT_TILT: f64 = 1e-13;

/// The number of coordinates that change while a level base slides or flies.
pub(in crate::motion) const LEVEL: usize = 9;

/// The place of the time among them.
pub(in crate::motion) const LEVEL_TIME: usize = 0;

/// The places of those coordinates among all of them: t, x1, y1, slip_x, slip_y, gap, gap_rate, friction_loss and
/// ground_work.
pub(in crate::motion) const PLACES: [usize; LEVEL] = [TIME, 8, 9, 10, 11, 12, 13, 14, 17];

/// The forces on a body whose base is level, at one heading of its coordinates.
#[derive(Clone, Copy)]
pub(in crate::motion) struct LevelEquations<'a, T: Scalar> {
    pub(in crate::motion) k: Parameters<T>,
    /// The cosine and the sine of the yaw, which stays the same.
    heading: [T; 2],
    /// The equations of a rim that slides, for the friction.
    sliding: &'a dyn Dynamics<T>,
    is_dry: bool,
    /// A component of the table's acceleration across the heading that is a rounding error, m/s².
    rounding: f64,
}

impl<'a, T: Scalar> LevelEquations<'a, T> {
    /// The equations at a yaw (rad). `sliding` has the friction, and `is_dry` says whether it is dry. `peak` is that of
    /// a table that moves along a line, m/s², and 0 for any other.
    pub(in crate::motion) fn new(
        k: Parameters<T>,
        yaw: T,
        sliding: &'a dyn Dynamics<T>,
        is_dry: bool,
        peak: f64,
    ) -> Self {
        let (sin, cos) = yaw.sin_cos();
        LevelEquations {
            k,
            heading: [cos, sin],
            sliding,
            is_dry,
            rounding: rounding_across(peak, yaw.value()),
        }
    }

    /// The horizontal acceleration of the table along e_x1 and e_y1, and G, m/s².
    pub(in crate::motion) fn field(&self, [x, y, z]: [T; 3]) -> ([T; 2], T) {
        let [cos, sin] = self.heading;
        let mut across = y * cos - x * sin;
        // As `across_plane` in `law/moving_table.rs`, for a base that does not turn.
        if across.value().abs() < self.rounding {
            across = across - T::from(across.value());
        }
        ([x * cos + y * sin, across], self.k.g + z)
    }

    /// The speed scale √(gR), m/s.
    pub(in crate::motion) fn speed_scale(&self) -> T {
        (self.k.g * self.k.r).sqrt()
    }

    /// A speed that counts as none, m/s.
    pub(in crate::motion) fn no_speed(&self) -> T {
        T::from(1e-12) * self.speed_scale()
    }

    /// The friction on a base that slides, N.
    pub(in crate::motion) fn friction(&self, slip: [T; 2], gravity: T) -> [T; 2] {
        self.sliding.flat_friction(slip, self.k.m * gravity)
    }

    /// The largest |a|/G at which the body stands, where `holding` is the coefficient of static friction.
    pub(in crate::motion) fn standing_limit(&self, holding: f64) -> T {
        T::from(holding).min(self.k.r / self.k.h)
    }

    /// A gravity G that counts as none, m/s². Where a record has −g, rounding decides on the sign of G.
    pub(in crate::motion) fn no_gravity(&self) -> T {
        T::from(1e-12) * self.k.g
    }

    /// Positive while a body stands flat: the margin of the horizontal acceleration, or of G where that is negative or
    /// nothing else can move the body. `holding` is the coefficient of static friction.
    pub(in crate::motion) fn standing_margin(&self, holding: f64, acceleration: [T; 3]) -> T {
        let (horizontal, gravity) = self.field(acceleration);
        let pressing = gravity + self.no_gravity();
        let limit = self.standing_limit(holding);
        if pressing.value() <= 0.0 || limit.value() == f64::INFINITY {
            return pressing;
        }
        limit * pressing - size(horizontal)
    }

    /// Positive while a base that slides stays flat on the table, under this friction (N).
    pub(in crate::motion) fn flatness_margin(&self, friction: [T; 2], gravity: T) -> T {
        self.k.m * gravity * self.k.r - size(friction) * self.k.h
    }

    /// The coordinates of a body that begins to rock. The force that makes it do so points along e_x1 then: it is that
    /// which accelerates the body with the table, or the friction on a base that slides.
    pub(in crate::motion) fn uplifted(&self, u: &Coordinates<T>, force: [T; 2]) -> Coordinates<T> {
        let change = force[1].atan2(force[0]);
        let turned = |[x, y]: [T; 2]| {
            let (sin, cos) = change.sin_cos();
            [x * cos + y * sin, y * cos - x * sin]
        };
        let [x1, y1] = turned([u.x1, u.y1]);
        // The friction, which points along e_x1 now, is opposite to the slip. So no slip along e_y1 is left but rounding.
        let [slip_x, _] = turned([u.slip_x, u.slip_y]);
        let slip_y = T::from(0.0);
        Coordinates {
            yaw: u.yaw + change,
            spin: u.spin - change,
            sin: T::from(UPLIFT_TILT),
            cos: T::from(1.0),
            x1,
            y1,
            slip_x,
            slip_y,
            ..*u
        }
    }
}

/// The equations of motion of a level base that slides or flies, along a stretch of the table's motion whose
/// acceleration is multiplied by a factor.
pub(in crate::motion) struct LevelMotion<'a, T: Scalar = f64> {
    pub(in crate::motion) equations: LevelEquations<'a, T>,
    pub(in crate::motion) stretch: Option<(Stretch, T)>,
    pub(in crate::motion) slides: bool,
}

impl<'a, T: Scalar> LevelMotion<'a, T> {
    /// Under these laws at a yaw (rad), along a stretch of the table's motion whose acceleration is multiplied by `factor`.
    pub(in crate::motion) fn new(
        phases: &'a PhaseDynamics<T>,
        phase: Phase,
        yaw: T,
        stretch: Option<Stretch>,
        factor: T,
    ) -> Self {
        let sliding = phases.in_phase(Phase::Sliding);
        let is_dry = phases.sliding.is_dry();
        let peak = stretch.as_ref().map_or(0.0, Stretch::straight_peak);
        LevelMotion {
            equations: LevelEquations::new(*sliding.parameters(), yaw, sliding, is_dry, peak),
            stretch: stretch.map(|stretch| (stretch, factor)),
            slides: phase == Phase::SlidingFlat,
        }
    }

    /// The acceleration of the table at a time (s), m/s².
    pub(in crate::motion) fn acceleration(&self, t: T) -> [T; 3] {
        let Some((stretch, factor)) = &self.stretch else {
            return [T::from(0.0); 3];
        };
        stretch.acceleration(t).map(|component| *factor * component)
    }

    /// The rates with respect to the time.
    pub(in crate::motion) fn rates_in_time(&self, u: &[T; LEVEL]) -> [T; LEVEL] {
        let zero = T::from(0.0);
        let [t, _, _, vx, vy, _, gap_rate, ..] = *u;
        let k = &self.equations.k;
        let acceleration = self.acceleration(t);
        let ([ax, ay], gravity) = self.equations.field(acceleration);
        let [fx, fy] = if self.slides {
            self.equations.friction([vx, vy], gravity)
        } else {
            [zero; 2]
        };
        let falling = if self.slides { zero } else { -gravity };
        let work = -k.m * (ax * vx + ay * vy + acceleration[2] * gap_rate);
        let (dvx, dvy) = (fx / k.m - ax, fy / k.m - ay);
        let loss = -(fx * vx + fy * vy);
        [
            T::from(1.0),
            vx,
            vy,
            dvx,
            dvy,
            gap_rate,
            falling,
            loss,
            work,
        ]
    }

    /// dt/dσ: the direction of dry friction on a base that is about to stop changes at a rate that grows like 1/|v|.
    pub(in crate::motion) fn time_rate(&self, velocity: [T; 2]) -> T {
        if self.slides && self.equations.is_dry {
            let speed = size(velocity);
            speed / (speed + T::from(0.03) * self.equations.speed_scale())
        } else {
            T::from(1.0)
        }
    }

    /// Whether dry friction can stop the base.
    pub(in crate::motion) fn can_stop(&self) -> bool {
        self.slides && self.equations.is_dry
    }
}

impl<T: Scalar> System<T, LEVEL> for LevelMotion<'_, T> {
    #[inline(never)]
    fn rates(&self, u: &[T; LEVEL]) -> [T; LEVEL] {
        let factor = self.time_rate([u[3], u[4]]);
        self.rates_in_time(u).map(|rate| factor * rate)
    }

    fn scale(&self, u: &[T; LEVEL]) -> [T; LEVEL] {
        let [_, x, y, vx, vy, gap, gap_rate, ..] = *u;
        let Parameters { m, r, .. } = self.equations.k;
        let unit = self.equations.speed_scale();
        let speed = size([vx, vy]);
        // A slip that begins or ends keeps some digits of its direction.
        let slow = T::from(if self.can_stop() { 1e-8 } else { 1e-3 }) * unit;
        let distance = r + size([x, y]);
        let fastest = speed + gap_rate.abs() + unit;
        let energy = m * fastest * fastest;
        [
            r / unit,
            distance,
            distance,
            speed + slow,
            speed + slow,
            gap + T::from(1e-6) * r,
            gap_rate.abs() + T::from(1e-6) * unit,
            energy,
            energy,
        ]
    }
}

/// The length of a horizontal vector.
pub(in crate::motion) fn size<T: Scalar>([x, y]: [T; 2]) -> T {
    x.hypot(y)
}
