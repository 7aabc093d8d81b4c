//! The table under the body, at rest or moving, and the equations of motion relative to it.
//!
//! The table translates with the acceleration a(t) and does not turn. Relative to it, the equations of every law
//! hold with two changes: gravity is G = g + a_z, and the horizontal inertial force −m (a₁, a₂) acts at the centre
//! of mass, where a₁ = a_x cos ψ + a_y sin ψ and a₂ = −a_x sin ψ + a_y cos ψ are the components along e_x1 and e_y1.
//!
//! A body that rocks in a vertical plane along a straight motion of the table stays in it exactly: no rounding error
//! pushes it out (see [`across_plane`]).
//!
//! The energy relative to the table changes by the work −m a · v of the inertial force, with v the
//! velocity of the centre of mass relative to the table.

use super::{Contact, Dynamics, Friction, FrictionForce, Parameters, Response, Sliding};
use crate::ground::{Ground, Stretch};
use crate::real::{Real, Scalar};
use crate::state::Coordinates;
use std::sync::Arc;

/// The table under the body.
#[derive(Debug, Clone)]
pub(crate) enum Table<T = f64> {
    /// It is at rest.
    AtRest,
    /// It moves.
    Moving(Arc<Ground>),
    /// It moves as in this stretch, also before and after it, so that rates are smooth over a step. Its acceleration is
    /// multiplied by a factor: 1, with a derivative where that by the factor is sought.
    Along(Stretch, T),
}

impl<T: Scalar> Table<T> {
    /// The table that moves with `ground`, or is at rest without one.
    pub(crate) fn new(ground: Option<&Arc<Ground>>) -> Self {
        ground.map_or(Table::AtRest, |ground| Table::Moving(Arc::clone(ground)))
    }

    /// Whether the table moves.
    pub(crate) fn moves(&self) -> bool {
        cfg!(feature = "ground") && !matches!(self, Table::AtRest)
    }

    /// The acceleration of the table.
    #[inline(never)]
    fn acceleration(&self, u: &Coordinates<T>) -> Acceleration<T> {
        let [x, y, vertical] = match self {
            Table::AtRest => [T::from(0.0); 3],
            Table::Along(stretch, factor) => stretch
                .acceleration(u.t)
                .map(|component| *factor * component),
            Table::Moving(ground) => ground.stretch(u.t.value()).acceleration(u.t),
        };
        let (sin, cos) = u.yaw.sin_cos();
        let across = y * cos - x * sin;
        let rounded = across - T::from(across.value());
        Acceleration {
            horizontal: [
                x * cos + y * sin,
                across_plane(across, rounded, T::from(self.straight_peak()), u),
            ],
            vertical,
        }
    }

    /// See [`Ground::straight_peak`].
    fn straight_peak(&self) -> f64 {
        match self {
            Table::AtRest => 0.0,
            Table::Along(stretch, _) => stretch.straight_peak(),
            Table::Moving(ground) => ground.straight_peak(),
        }
    }
}

/// The component of the table's acceleration across e_x1, or `rounded` in its place where it is zero within rounding and
/// the body turns neither about e_x1 nor about its axis. `peak` is [`Ground::straight_peak`], m/s².
///
/// Such a body rocks in the vertical plane through e_x1. If rounding in the components of the acceleration or in the
/// heading pushed it out of this plane, the deviation would grow about a thousandfold at every near-collision.
#[inline(always)]
pub(crate) fn across_plane<T: Real>(across: T, rounded: T, peak: T, u: &Coordinates<T>) -> T {
    let turning = u.w.abs() + u.s.abs() - T::from(f64::MIN_POSITIVE);
    (across.abs() - rounding_across(peak, u.yaw))
        .max(turning)
        .where_negative(rounded, across)
}

/// A component of the table's acceleration across a heading (rad) that counts as a rounding error, m/s². Half turns may
/// have been added to the heading hundreds of times.
#[inline(always)]
pub(crate) fn rounding_across<T: Real>(peak: T, yaw: T) -> T {
    T::from(2e-13) * peak * (T::from(1.0) + yaw.abs())
}

/// The acceleration of the table along e_x1, e_y1 and e_z, m/s².
#[derive(Clone, Copy)]
pub(crate) struct Acceleration<T> {
    pub horizontal: [T; 2],
    pub vertical: T,
}

impl<T: Real> Acceleration<T> {
    /// The rates of the reduced state under a law that holds relative to the table.
    #[inline(always)]
    pub(crate) fn rates<L: Movable<T>>(&self, dynamics: &L, u: &Coordinates<T>) -> Coordinates<T> {
        let rates = self.gravity(dynamics).reduced_rates(u);
        self.add_to(rates, dynamics, u)
    }

    /// The contact force (times sin φ).
    #[inline(always)]
    pub(crate) fn contact<L: Movable<T>>(&self, dynamics: &L, u: &Coordinates<T>) -> Contact<T> {
        let effect = dynamics.inertial_effect(u, self.horizontal);
        self.gravity(dynamics).contact(u).plus(&effect.contact)
    }

    /// The equations under the gravity g + a_z.
    #[inline(always)]
    fn gravity<L: Movable<T>>(&self, dynamics: &L) -> L {
        let mut under = dynamics.clone();
        under.set_gravity(dynamics.parameters().g + self.vertical);
        under
    }

    /// Adds the effect of the horizontal inertial force to `rates`, and the power of the inertial force.
    #[inline(always)]
    fn add_to<L: Movable<T>>(
        &self,
        rates: Coordinates<T>,
        dynamics: &L,
        u: &Coordinates<T>,
    ) -> Coordinates<T> {
        let k = dynamics.parameters();
        let [along, across] = self.horizontal;
        let InertialEffect { p, w, s, slip, .. } = dynamics.inertial_effect(u, [along, across]);
        let [vx, vy] = dynamics.center_velocity(u);
        let vz = k.rho(u) * u.p + u.gap_rate;
        Coordinates {
            p: rates.p + p,
            w: rates.w + w,
            s: rates.s + s,
            slip_x: rates.slip_x + slip[0],
            slip_y: rates.slip_y + slip[1],
            ground_work: -(u.sin * k.m) * (along * vx + across * vy + self.vertical * vz),
            ..rates
        }
    }
}

/// What the horizontal inertial force adds to the rates of the velocities and to the contact force, all times
/// sin φ.
pub(crate) struct InertialEffect<T> {
    /// dp/dτ.
    pub p: T,
    /// dw/dτ.
    pub w: T,
    /// ds/dτ.
    pub s: T,
    /// The rate of the slip with respect to τ.
    pub slip: [T; 2],
    /// The contact force.
    pub contact: Contact<T>,
}

impl<T: Real> InertialEffect<T> {
    /// The effect on a body that can slip: it stays behind, so the rate of its slip is smaller by the acceleration.
    #[inline(always)]
    pub(crate) fn staying_behind(u: &Coordinates<T>, acceleration: [T; 2]) -> Self {
        let zero = T::from(0.0);
        InertialEffect {
            p: zero,
            w: zero,
            s: zero,
            slip: acceleration.map(|component| -(u.sin * component)),
            contact: Contact {
                along: zero,
                across: zero,
                normal: zero,
            },
        }
    }
}

/// Equations of motion that hold on a table that moves.
pub(crate) trait Movable<T: Real>: Dynamics<T> + Clone {
    /// Replaces gravity by another, m/s².
    fn set_gravity(&mut self, gravity: T);

    /// The effect of the horizontal acceleration of the table (m/s², along e_x1 and e_y1). It is linear in the
    /// acceleration.
    fn inertial_effect(&self, u: &Coordinates<T>, acceleration: [T; 2]) -> InertialEffect<T>;
}

/// Equations of motion relative to a table.
#[derive(Debug, Clone)]
pub(crate) struct OnTable<L, T = f64> {
    dynamics: L,
    table: Table<T>,
}

impl<L, T: Scalar> OnTable<L, T> {
    pub(crate) fn new(dynamics: L, table: &Table<T>) -> Self {
        let table = table.clone();
        OnTable { dynamics, table }
    }

    /// The equations on a table at rest.
    pub(crate) fn dynamics(&self) -> &L {
        &self.dynamics
    }

    /// Whether the table moves.
    pub(crate) fn moves(&self) -> bool {
        self.table.moves()
    }

    /// The rates of the reduced state on a table that moves. A step has many copies of the rates, in which this would
    /// take most of the room if it were inlined.
    #[inline(never)]
    fn moving_rates(&self, u: &Coordinates<T>) -> Coordinates<T>
    where
        L: Movable<T>,
    {
        self.table.acceleration(u).rates(&self.dynamics, u)
    }

    /// The contact force (times sin φ) on a table that moves.
    #[inline(never)]
    fn moving_contact(&self, u: &Coordinates<T>) -> Contact<T>
    where
        L: Movable<T>,
    {
        self.table.acceleration(u).contact(&self.dynamics, u)
    }
}

impl<T: Scalar, L: Movable<T>> Dynamics<T> for OnTable<L, T> {
    fn parameters(&self) -> &Parameters<T> {
        self.dynamics.parameters()
    }

    #[inline(always)]
    fn reduced_rates(&self, u: &Coordinates<T>) -> Coordinates<T> {
        if self.table.moves() {
            self.moving_rates(u)
        } else {
            self.dynamics.reduced_rates(u)
        }
    }

    #[inline(always)]
    fn contact(&self, u: &Coordinates<T>) -> Contact<T> {
        if self.table.moves() {
            self.moving_contact(u)
        } else {
            self.dynamics.contact(u)
        }
    }

    #[inline(always)]
    fn center_velocity(&self, u: &Coordinates<T>) -> [T; 2] {
        self.dynamics.center_velocity(u)
    }

    fn slip(&self, u: &Coordinates<T>) -> [T; 2] {
        self.dynamics.slip(u)
    }

    fn constrained_response(&self, u: &Coordinates<T>, moment: [T; 2]) -> Option<Response<T>> {
        self.dynamics.constrained_response(u, moment)
    }

    fn friction_ratio(&self, u: &Coordinates<T>) -> Option<T> {
        self.dynamics.friction_ratio(u)
    }

    fn flat_friction(&self, slip: [T; 2], normal: T) -> [T; 2] {
        self.dynamics.flat_friction(slip, normal)
    }

    #[inline(always)]
    fn consistency(&self, u: &Coordinates<T>) -> T {
        self.dynamics.consistency(u)
    }

    fn is_shaken(&self) -> bool {
        self.table.moves()
    }

    fn table_acceleration(&self, u: &Coordinates<T>) -> [T; 3] {
        let Acceleration {
            horizontal: [along, across],
            vertical,
        } = self.table.acceleration(u);
        [along, across, vertical]
    }

    fn is_conservative(&self) -> bool {
        !self.table.moves() && self.dynamics.is_conservative()
    }
}

impl<F: Friction<f64> + Clone> OnTable<Sliding<f64, F>> {
    /// The contact force (times sin φ) and the rates under a given friction force.
    #[inline]
    pub(crate) fn under_friction(
        &self,
        u: &Coordinates<f64>,
        friction_force: &FrictionForce<f64>,
    ) -> (Contact<f64>, Coordinates<f64>) {
        if !self.table.moves() {
            return self.dynamics.under(u, friction_force);
        }
        let acceleration = self.table.acceleration(u);
        let under = acceleration.gravity(&self.dynamics);
        let (contact, rates) = under.under(u, friction_force);
        (contact, acceleration.add_to(rates, &self.dynamics, u))
    }
}
