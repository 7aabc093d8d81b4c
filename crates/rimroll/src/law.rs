//! The contact laws: how the rim meets the table.
//!
//! Each law is one file that fills the trait [`Law`]. It gives the rates of the [`Coordinates`] with
//! respect to the solver's clock τ (dt = sin φ dτ) and the forces on the rim. Symbols and equation
//! names are the paper's; ρ = R cos φ − H sin φ is the horizontal and z = R sin φ + H cos φ the
//! vertical distance from the contact point to the centre of mass.

pub mod frictionless;
pub mod no_slip;

pub use frictionless::Frictionless;
pub use no_slip::NoSlip;

use crate::body::Body;
use crate::error::InvalidInput;
use crate::real::Real;
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
    pub fn rho(&self, u: &Coordinates<T>) -> T {
        self.r * u.cos - self.h * u.sin
    }

    /// z: how far the centre of mass lies over the table, m.
    pub fn z(&self, u: &Coordinates<T>) -> T {
        self.r * u.sin + self.h * u.cos
    }

    /// N sin φ, from vertical momentum N = m (g + z̈) with z̈ = ρ φ̈ − z φ̇².
    pub(crate) fn normal(&self, u: &Coordinates<T>, dp: T) -> T {
        self.m * (u.sin * self.g + self.rho(u) * dp - u.sin * self.z(u) * u.p * u.p)
    }
}

/// The force of the table on the rim **times sin φ**, which stays finite where the force does not:
/// it is the impulse per unit of the solver's clock.
#[derive(Debug, Clone, Copy)]
pub struct Contact<T> {
    /// Friction along e_x1, horizontally from the contact point toward the base's centre.
    pub along: T,
    /// Friction along e_y1 = e_z × e_x1, tangent to the rim.
    pub across: T,
    /// Upward.
    pub normal: T,
}

/// Mechanical energy, J.
#[derive(Debug, Clone, Copy)]
pub struct Energy<T> {
    /// Of translation and rotation.
    pub kinetic: T,
    /// m g (z − H): zero when the body stands upright.
    pub potential: T,
}

impl<T: Real> Energy<T> {
    /// Kinetic and potential together.
    pub fn total(&self) -> T {
        self.kinetic + self.potential
    }
}

/// How the rim meets the table.
pub trait Law<T: Real> {
    /// The body and gravity.
    fn parameters(&self) -> &Parameters<T>;

    /// Rates of the coordinates by the solver's clock τ.
    fn rates(&self, u: &Coordinates<T>) -> Coordinates<T>;

    /// The table's force on the rim, times sin φ.
    fn contact(&self, u: &Coordinates<T>) -> Contact<T>;

    /// Horizontal velocity of the centre of mass along e_x1 and e_y1, m/s.
    fn center_velocity(&self, u: &Coordinates<T>) -> [T; 2];

    /// Kinetic energy of a body with angular velocity (w, −φ̇, s) and the law's velocity of its
    /// centre of mass, and potential energy. (Appendix B prints half the potential energy.)
    fn energy(&self, u: &Coordinates<T>) -> Energy<T> {
        let k = self.parameters();
        let [vx, vy] = self.center_velocity(u);
        let vz = k.rho(u) * u.p;
        let translation = k.m * (vx * vx + vy * vy + vz * vz);
        let rotation = k.a * (u.p * u.p + u.w * u.w) + k.c * u.s * u.s;
        // z − H without cancellation at small tilt: 1 − cos φ = sin² φ / (1 + cos φ).
        let lift = k.r * u.sin - k.h * u.sin * u.sin / (T::from(1.0) + u.cos);
        Energy {
            kinetic: T::from(0.5) * (translation + rotation),
            potential: k.m * k.g * lift,
        }
    }
}

/// The laws by name, for choosing one at run time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LawKind {
    /// [`NoSlip`].
    NoSlip,
    /// [`Frictionless`].
    Frictionless,
}

impl LawKind {
    /// Every law, in the order in which they are listed to the user.
    pub const ALL: [LawKind; 2] = [LawKind::NoSlip, LawKind::Frictionless];

    /// The name that a user types.
    pub fn name(self) -> &'static str {
        match self {
            LawKind::NoSlip => "no_slip",
            LawKind::Frictionless => "frictionless",
        }
    }

    /// The law of that name; `-` may stand for `_`.
    ///
    /// # Errors
    /// Lists the names when there is none such.
    pub fn from_name(name: &str) -> Result<LawKind, InvalidInput> {
        let wanted = name.replace('-', "_");
        LawKind::ALL
            .into_iter()
            .find(|law| law.name() == wanted)
            .ok_or_else(|| InvalidInput::UnknownName {
                what: "law",
                name: name.to_owned(),
                choices: LawKind::ALL.map(LawKind::name).join(", "),
            })
    }

    /// The law for a body under gravity g (m/s²).
    pub fn of(self, body: &Body, gravity: f64) -> Box<dyn Law<f64> + Send + Sync> {
        let parameters = Parameters::new(body, gravity);
        match self {
            LawKind::NoSlip => Box::new(NoSlip::new(parameters)),
            LawKind::Frictionless => Box::new(Frictionless::new(parameters)),
        }
    }
}
