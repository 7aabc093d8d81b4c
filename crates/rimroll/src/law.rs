//! The equations of motion under each contact law.
//!
//! Each law is one file that implements the trait [`Dynamics`]. It gives the rates of the [`Coordinates`]
//! with respect to τ (dt = sin φ dτ, a Sundman time transformation) and the forces on the rim. Symbols and
//! equation names are the paper's; ρ = R cos φ − H sin φ is the horizontal and z = R sin φ + H cos φ the
//! vertical distance from the contact point to the centre of mass.
//!
//! The paper's two laws, [`NoSlip`] and [`Frictionless`], are the ideal limits. [`InPlace`] is no slip on the circle
//! on which the body stood. Between the two limits the rim
//! slides under a friction that depends on its slip: [`Sliding`] with [`Coulomb`], [`Tabulated`],
//! [`Stribeck`] or [`Viscous`] friction. Under dry friction the rim can also roll, which is [`NoSlip`]
//! again, and any contact can end in [`Flight`]; [`motion`](crate::motion) decides which law holds when.
//! [`Resisted`] adds rolling resistance, pivoting friction and air drag to any of them, and `OnTable` the motion
//! of the table.

mod coulomb;
mod flight;
mod friction_law;
mod friction_model;
mod frictionless;
mod in_place;
mod moving_table;
mod no_slip;
mod resistance;
mod sliding;
mod stribeck;
mod tabulated;
mod viscous;

pub use coulomb::{Coulomb, MAX_FRICTION};
pub use flight::Flight;
pub(crate) use friction_law::SlidingDynamics;
pub use friction_law::{FrictionLaw, IdealLaw};
pub use friction_model::{
    DryFriction, DryFrictionModel, Friction, FrictionForce, FrictionModel, NamedParameters,
};
pub use frictionless::Frictionless;
use frictionless::NoFriction;
pub use in_place::InPlace;
#[cfg(feature = "ground")]
pub(crate) use moving_table::{Acceleration, across_plane};
pub(crate) use moving_table::{InertialEffect, Movable, OnTable, Table, rounding_across};
pub use no_slip::NoSlip;
pub(crate) use resistance::RollingDynamics;
pub use resistance::{AirDrag, PivotingFriction, Resistance, Resisted, RollingResistance};
pub use sliding::Sliding;
pub(crate) use sliding::{DryDynamics, SlidingDry, SundmanScaling};
pub use stribeck::Stribeck;
pub use tabulated::Tabulated;
pub use viscous::Viscous;

use crate::body::Body;
use crate::real::{Real, fieldwise};
use crate::state::Coordinates;

/// The parameters of the equations of motion, in the paper's symbols and SI units.
#[derive(Debug, Clone, Copy)]
pub struct Parameters<T> {
    /// Mass.
    pub m: T,
    /// Radius of the rim.
    pub r: T,
    /// Height of the centre of mass above the base.
    pub h: T,
    /// Transverse moment of inertia about the centre of mass.
    pub a: T,
    /// Axial moment of inertia.
    pub c: T,
    /// Gravity, m/s².
    pub g: T,
}

fieldwise!(Parameters { m, r, h, a, c, g; });

impl<T: Copy> Parameters<T> {
    /// [m, R, H, A, C, g], converted to another number type.
    #[inline(always)]
    pub(crate) fn as_array<N>(&self) -> [N; 6]
    where
        T: Into<N>,
    {
        [
            self.m.into(),
            self.r.into(),
            self.h.into(),
            self.a.into(),
            self.c.into(),
            self.g.into(),
        ]
    }
}

impl Parameters<f64> {
    /// Whether the body at this tilt (rad) is beyond its balance point. A disk never is: beyond the
    /// vertical it leans on its other face.
    pub(crate) fn is_past_balance(&self, tilt: f64) -> bool {
        self.h > 0.0 && tilt > libm::atan2(self.r, self.h)
    }
}

impl<T: Real> Parameters<T> {
    /// The parameters of a body under gravity g (m/s²).
    pub fn new(body: &Body, gravity: f64) -> Self {
        Parameters {
            m: body.mass().into(),
            r: body.radius().into(),
            h: body.height().into(),
            a: body.transverse_inertia().into(),
            c: body.axial_inertia().into(),
            g: gravity.into(),
        }
    }

    /// ρ: horizontal distance from the contact point to the centre of mass, toward the base's centre, m.
    #[inline(always)]
    pub fn rho(&self, u: &Coordinates<T>) -> T {
        self.r * u.cos - self.h * u.sin
    }

    /// z: height of the centre of mass above the contact point, m.
    #[inline(always)]
    pub fn z(&self, u: &Coordinates<T>) -> T {
        self.r * u.sin + self.h * u.cos
    }

    /// N sin φ with N = m (g + z̈), z̈ = ρ φ̈ − z φ̇² and `dp` = φ̈ sin φ.
    #[inline(always)]
    pub(crate) fn normal(&self, u: &Coordinates<T>, dp: T) -> T {
        self.m * (u.sin * self.g + self.rho(u) * dp - u.sin * self.z(u) * u.p * u.p)
    }

    /// Horizontal velocity of the centre of mass along e_x1 and e_y1 when the rim does not slip, m/s
    /// (appendix A, Eq. `vG_noslip`, in the frame that yaws but does not tilt).
    #[inline(always)]
    pub(crate) fn rolling_velocity(&self, u: &Coordinates<T>) -> [T; 2] {
        [-self.z(u) * u.p, self.r * u.s - self.h * u.w]
    }

    /// The smallest coefficient of friction at which the Painlevé paradox begins at the tilt of `u`, for a slip
    /// along e_x1.
    pub(crate) fn painleve_friction(&self, u: &Coordinates<T>) -> T {
        let (rho, z) = (self.rho(u), self.z(u));
        ((self.a + self.m * rho * rho) / (self.m * rho * z)).abs()
    }

    /// The change of the slip along e_y1 per unit of impulse along e_y1, 1/kg: 1/m + R²/C + H²/A.
    pub(crate) fn sideways_mobility(&self) -> T {
        T::from(1.0) / self.m + self.r * self.r / self.c + self.h * self.h / self.a
    }
}

/// The force of the table on the rim **times sin φ**, which stays finite where the force does not. It is
/// the impulse per unit of τ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact<T> {
    /// Friction along e_x1: horizontal, from the contact point toward the base's centre.
    pub along: T,
    /// Friction along e_y1 = e_z × e_x1: tangent to the rim.
    pub across: T,
    /// Normal force, upward.
    pub normal: T,
}

impl<T: Real> Contact<T> {
    /// The sum of two forces.
    #[inline(always)]
    pub(crate) fn plus(&self, other: &Self) -> Self {
        Contact {
            along: self.along + other.along,
            across: self.across + other.across,
            normal: self.normal + other.normal,
        }
    }

    /// This force multiplied by `factor`.
    #[inline(always)]
    pub(crate) fn times(&self, factor: T) -> Self {
        Contact {
            along: factor * self.along,
            across: factor * self.across,
            normal: factor * self.normal,
        }
    }
}

/// Mechanical energy, J.
#[derive(Debug, Clone, Copy)]
pub struct Energy<T> {
    /// Energy of translation and rotation.
    pub kinetic: T,
    /// m g (z − H): zero when the body stands upright on the table.
    pub potential: T,
}

impl<T: Real> Energy<T> {
    /// Kinetic plus potential energy.
    pub fn total(&self) -> T {
        self.kinetic + self.potential
    }
}

/// What applied moments about e_x2 and e_z2 add to the rates and to the force on the rim, where they and the reactions
/// of the table are multiplied by sin φ.
#[derive(Debug, Clone, Copy)]
pub struct Response<T> {
    /// dw/dτ.
    pub w: T,
    /// ds/dτ.
    pub s: T,
    /// The reaction of the table along e_y1.
    pub across: T,
}

impl<T: Real> Response<T> {
    /// The response to moments and to a reaction along e_y1.
    #[inline(always)]
    pub(crate) fn to(k: &Parameters<T>, [about_x, about_z]: [T; 2], across: T) -> Self {
        Response {
            w: (about_x + k.h * across) / k.a,
            s: (about_z - k.r * across) / k.c,
            across,
        }
    }
}

/// The equations of motion and the contact force under one law.
pub trait Dynamics<T: Real> {
    /// The body and gravity.
    fn parameters(&self) -> &Parameters<T>;

    /// Rates of the reduced state: all but spin and position, on which no rate depends.
    fn reduced_rates(&self, u: &Coordinates<T>) -> Coordinates<T>;

    /// The table's force on the rim, times sin φ.
    fn contact(&self, u: &Coordinates<T>) -> Contact<T>;

    /// Horizontal velocity of the centre of mass along e_x1 and e_y1, m/s.
    fn center_velocity(&self, u: &Coordinates<T>) -> [T; 2];

    /// Horizontal velocity of the rim's lowest point along e_x1 and e_y1, m/s.
    fn slip(&self, u: &Coordinates<T>) -> [T; 2] {
        let [vx, vy] = self.center_velocity(u);
        let [rolling_x, rolling_y] = self.parameters().rolling_velocity(u);
        [vx - rolling_x, vy - rolling_y]
    }

    /// The response to applied moments about e_x2 and e_z2 (times sin φ) where the law holds the rim along e_y1;
    /// `None` where it does not.
    fn constrained_response(&self, _u: &Coordinates<T>, _moment: [T; 2]) -> Option<Response<T>> {
        None
    }

    /// The contribution of resistance to dw/dτ, as if it did not fade out at small tilts: whether it stops the contact
    /// point must not depend on that.
    fn resistance_rate(&self, _u: &Coordinates<T>) -> T {
        T::from(0.0)
    }

    /// |T|/N where the law prescribes it, even at N = 0; `None` where friction is not proportional to the
    /// normal force.
    fn friction_ratio(&self, _u: &Coordinates<T>) -> Option<T> {
        None
    }

    /// The friction on a base that lies flat and slips (m/s, along e_x1 and e_y1) under a normal force (N).
    fn flat_friction(&self, _slip: [T; 2], _normal: T) -> [T; 2] {
        [T::from(0.0); 2]
    }

    /// Positive as long as the law and rigidity determine the normal force: 1 − a_x z mρ/(A + mρ²),
    /// where a_x is the friction along e_x1 per unit of normal force. Zero is the Painlevé paradox.
    fn consistency(&self, _u: &Coordinates<T>) -> T {
        T::from(1.0)
    }

    /// Whether the table moves.
    fn is_shaken(&self) -> bool {
        false
    }

    /// The acceleration of the table along e_x1, e_y1 and e_z, m/s².
    fn table_acceleration(&self, _u: &Coordinates<T>) -> [T; 3] {
        [T::from(0.0); 3]
    }

    /// Whether slip, gap and losses are constant, so that only the first
    /// [`RIGID_COORDINATES`](crate::state::RIGID_COORDINATES) coordinates change.
    fn is_conservative(&self) -> bool {
        false
    }
}

/// What follows from the equations of any law. It is separate from [`Dynamics`], so that it is not compiled again for each
/// law that is called through `dyn Dynamics`.
pub trait DynamicsExt<T: Real>: Dynamics<T> {
    /// Rates of all coordinates with respect to τ.
    #[inline(always)]
    fn rates(&self, u: &Coordinates<T>) -> Coordinates<T> {
        u.with_spin_and_center(self.reduced_rates(u), self.center_velocity(u))
    }

    /// Kinetic energy, from the angular velocity (w, −φ̇, s) and the law's velocity of the centre of mass,
    /// and potential energy. (Erratum: appendix B prints half the potential energy.)
    fn energy(&self, u: &Coordinates<T>) -> Energy<T> {
        let k = self.parameters();
        let [vx, vy] = self.center_velocity(u);
        let vz = k.rho(u) * u.p + u.gap_rate;
        let translation = k.m * (vx * vx + vy * vy + vz * vz);
        let rotation = k.a * (u.p * u.p + u.w * u.w) + k.c * u.s * u.s;
        // z − H without cancellation at small tilt: 1 − cos φ = sin² φ / (1 + cos φ). The added number
        // avoids 0/0 for a disk on its other face.
        const NEVER_ZERO: f64 = 1e-300;
        let lift = k.r * u.sin - k.h * u.sin * u.sin / (T::from(1.0) + u.cos + T::from(NEVER_ZERO));
        Energy {
            kinetic: T::from(0.5) * (translation + rotation),
            potential: k.m * k.g * (lift + u.gap),
        }
    }
}

impl<T: Real, L: Dynamics<T> + ?Sized> DynamicsExt<T> for L {}
