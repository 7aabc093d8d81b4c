//! The contact laws: how the rim meets the table.
//!
//! Each law is one file that fills the trait [`Dynamics`]. It gives the rates of the [`Coordinates`] with
//! respect to the solver's clock τ (dt = sin φ dτ) and the forces on the rim. Symbols and equation
//! names are the paper's; ρ = R cos φ − H sin φ is the horizontal and z = R sin φ + H cos φ the
//! vertical distance from the contact point to the centre of mass.
//!
//! The paper's two laws, [`NoSlip`] and [`Frictionless`], are the limits. Between them the rim
//! slides under a friction that depends on its slip: [`Sliding`] with [`Coulomb`], [`Tabulated`],
//! [`Stribeck`] or [`Viscous`] friction. Dry friction also lets it roll, which is `NoSlip` again, and any contact may
//! end in [`Flight`]; which holds when is decided in [`motion`](crate::motion).
//! [`Resisted`] adds rolling resistance, pivoting friction and air drag to any of them.

mod coulomb;
mod flight;
mod frictionless;
mod no_slip;
mod resisted;
mod sliding;
mod stribeck;
mod tabulated;
mod viscous;

pub use coulomb::Coulomb;
pub use flight::Flight;
pub use frictionless::Frictionless;
pub use no_slip::NoSlip;
pub use resisted::{AirDrag, PivotingFriction, Resistance, Resisted, RollingResistance};
pub(crate) use sliding::{DryDynamics, Pace, SlidingDry};
pub use sliding::{DryFriction, Friction, FrictionForce, Sliding};
pub use stribeck::Stribeck;
pub use tabulated::{MAX_FRICTION, Tabulated};
pub use viscous::Viscous;

use crate::body::Body;
use crate::error::InvalidInput;
use crate::real::{Real, fieldwise};
use crate::state::Coordinates;

/// The body and gravity as the equations of motion use them: the paper's letters, SI units.
#[derive(Debug, Clone, Copy)]
pub struct Parameters<T> {
    /// Mass.
    pub m: T,
    /// Radius of the rim.
    pub r: T,
    /// Height of the centre of mass over the base.
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
    /// [m, R, H, A, C, g], as another kind of number.
    #[inline(always)]
    pub(crate) fn letters<N>(&self) -> [N; 6]
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
    /// Whether a body that leans so far is past its balance point. A disk is not: past the vertical it leans
    /// from its other face.
    pub(crate) fn is_past_balance(&self, tilt: f64) -> bool {
        self.h > 0.0 && tilt > libm::atan2(self.r, self.h)
    }
}

impl<T: Real> Parameters<T> {
    /// The numbers of a body under gravity g (m/s²).
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

    /// ρ: how far the centre of mass lies beside the contact point, toward the base's centre, m.
    #[inline(always)]
    pub fn rho(&self, u: &Coordinates<T>) -> T {
        self.r * u.cos - self.h * u.sin
    }

    /// z: how far the centre of mass lies over the table, m.
    #[inline(always)]
    pub fn z(&self, u: &Coordinates<T>) -> T {
        self.r * u.sin + self.h * u.cos
    }

    /// N sin φ, from vertical momentum N = m (g + z̈) with z̈ = ρ φ̈ − z φ̇².
    #[inline(always)]
    pub(crate) fn normal(&self, u: &Coordinates<T>, dp: T) -> T {
        self.m * (u.sin * self.g + self.rho(u) * dp - u.sin * self.z(u) * u.p * u.p)
    }

    /// How fast a rolling rim carries the centre of mass along e_x1 and e_y1, m/s (appendix A,
    /// Eq. `vG_noslip`, in the frame that yaws but does not tilt).
    #[inline(always)]
    pub(crate) fn rolling_velocity(&self, u: &Coordinates<T>) -> [T; 2] {
        [-self.z(u) * u.p, self.r * u.s - self.h * u.w]
    }

    /// Slip along e_y1 that a sideways force of 1 makes in a second: 1/m + R²/C + H²/A.
    pub(crate) fn sideways_mobility(&self) -> T {
        T::from(1.0) / self.m + self.r * self.r / self.c + self.h * self.h / self.a
    }
}

/// The force of the table on the rim **times sin φ**, which stays finite where the force does not:
/// it is the impulse per unit of the solver's clock.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact<T> {
    /// Friction along e_x1, horizontally from the contact point toward the base's centre.
    pub along: T,
    /// Friction along e_y1 = e_z × e_x1, tangent to the rim.
    pub across: T,
    /// Upward.
    pub normal: T,
}

impl<T: Real> Contact<T> {
    /// So many times this force.
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
    /// Of translation and rotation.
    pub kinetic: T,
    /// m g (z − H): zero when the body stands upright on the table.
    pub potential: T,
}

impl<T: Real> Energy<T> {
    /// Kinetic and potential together.
    pub fn total(&self) -> T {
        self.kinetic + self.potential
    }
}

/// How the rim meets the table.
pub trait Dynamics<T: Real> {
    /// The body and gravity.
    fn parameters(&self) -> &Parameters<T>;

    /// Rates of the coordinates by the solver's clock τ.
    #[inline(always)]
    fn rates(&self, u: &Coordinates<T>) -> Coordinates<T> {
        u.with_place(self.reduced_rates(u), self.center_velocity(u))
    }

    /// The same without spin and place, which nothing else depends on.
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

    /// The force along e_y1 by which the table holds the rim in place against moments (times sin φ)
    /// about e_x2 and e_z2; `None` where it does not hold it.
    fn constraint_reaction(&self, _moment: [T; 2]) -> Option<T> {
        None
    }

    /// What resistance by itself adds to dw/dτ.
    fn resistance_rate(&self, _u: &Coordinates<T>) -> T {
        T::from(0.0)
    }

    /// |T|/N where the law itself sets it, also where nothing presses any more; `None` where friction does not
    /// follow the normal force.
    fn friction_ratio(&self, _u: &Coordinates<T>) -> Option<T> {
        None
    }

    /// Positive as long as the law and rigidity determine the normal force: 1 − a_x z mρ/(A + mρ²),
    /// where a_x is the friction along e_x1 that each newton of normal force brings. At zero is
    /// Painlevé's paradox.
    fn consistency(&self, _u: &Coordinates<T>) -> T {
        T::from(1.0)
    }

    /// Whether slip, gap and losses stay as they are: what [`RIGID_COORDINATES`](crate::state::RIGID_COORDINATES) counts
    /// is then all that changes.
    fn is_conservative(&self) -> bool {
        false
    }

    /// Kinetic energy of a body with angular velocity (w, −φ̇, s) and the law's velocity of its
    /// centre of mass, and potential energy. (Appendix B prints half the potential energy.)
    fn energy(&self, u: &Coordinates<T>) -> Energy<T> {
        let k = self.parameters();
        let [vx, vy] = self.center_velocity(u);
        let vz = k.rho(u) * u.p + u.gap_rate;
        let translation = k.m * (vx * vx + vy * vy + vz * vz);
        let rotation = k.a * (u.p * u.p + u.w * u.w) + k.c * u.s * u.s;
        // z − H without cancellation at small tilt: 1 − cos φ = sin² φ / (1 + cos φ). A disk may lie on
        // its other face, where that would be 0/0.
        const NEVER_ZERO: f64 = 1e-300;
        let lift = k.r * u.sin - k.h * u.sin * u.sin / (T::from(1.0) + u.cos + T::from(NEVER_ZERO));
        Energy {
            kinetic: T::from(0.5) * (translation + rotation),
            potential: k.m * k.g * (lift + u.gap),
        }
    }
}

/// The paper's two laws, for which there are closed forms: between them lies all friction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum IdealLaw {
    /// [`NoSlip`].
    NoSlip,
    /// [`Frictionless`].
    Frictionless,
}

impl IdealLaw {
    /// Both, in the order in which they are listed to the user.
    pub const ALL: [IdealLaw; 2] = [IdealLaw::NoSlip, IdealLaw::Frictionless];

    /// The name that a user types.
    pub fn name(self) -> &'static str {
        match self {
            IdealLaw::NoSlip => "no_slip",
            IdealLaw::Frictionless => "frictionless",
        }
    }

    /// The law of that name; `-` may stand for `_`.
    ///
    /// # Errors
    /// Lists the names when there is none such.
    pub fn from_name(name: &str) -> Result<IdealLaw, InvalidInput> {
        let wanted = name.replace('-', "_");
        IdealLaw::ALL
            .into_iter()
            .find(|law| law.name() == wanted)
            .ok_or_else(|| InvalidInput::UnknownName {
                what: "law",
                name: name.to_owned(),
                choices: IdealLaw::ALL.map(IdealLaw::name).join(", "),
            })
    }

    /// The law for a body under gravity g (m/s²).
    pub fn of(self, body: &Body, gravity: f64) -> Box<dyn Dynamics<f64> + Send + Sync> {
        let parameters = Parameters::new(body, gravity);
        match self {
            IdealLaw::NoSlip => Box::new(NoSlip::new(parameters)),
            IdealLaw::Frictionless => Box::new(Frictionless::new(parameters)),
        }
    }
}
