//! The rolling body: an axisymmetric rigid body on the circular rim of its base.

use crate::error::{InvalidInput, at_most_twice, moderate, not_negative, within};
use crate::solids::Solid;

/// An axisymmetric rigid body whose base is a circle (SI units).
///
/// Only these five numbers enter the motion; the shape above the base does not matter
/// (Srinivasan & Ruina 2007, section III).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Body {
    mass: f64,
    radius: f64,
    height: f64,
    transverse_inertia: f64,
    axial_inertia: f64,
}

impl Body {
    /// A body from its mass m (kg), rim radius R (m), height H of the centre of mass above the base
    /// (m; 0 for a disk), moment of inertia A about any axis through the centre of mass
    /// perpendicular to the symmetry axis and C about that axis (kg m²).
    ///
    /// # Errors
    /// Refuses numbers that are not finite; m, R, A or C outside 1e-60 to 1e60 (SI); H outside 0 to 1e60;
    /// and C > 2A, which no rigid body has, because A = C/2 + ∫z² dm about the centre of mass.
    pub fn new(
        mass: f64,
        radius: f64,
        height: f64,
        transverse_inertia: f64,
        axial_inertia: f64,
    ) -> Result<Body, InvalidInput> {
        let body = Body {
            mass: moderate("mass", mass, "kg")?,
            radius: moderate("radius", radius, "m")?,
            height: within(
                "height",
                not_negative("height", height, "m")?,
                1e60,
                "at most 1e60",
                "m",
            )?,
            transverse_inertia: moderate("transverse_inertia", transverse_inertia, "kg m2")?,
            axial_inertia: moderate("axial_inertia", axial_inertia, "kg m2")?,
        };
        at_most_twice(axial_inertia, transverse_inertia)?;
        Ok(body)
    }

    /// A body composed of coaxial solids, standing on a rim of the given radius (m).
    ///
    /// # Errors
    /// Refuses an empty list and whatever [`Solid::check`] and [`Body::new`] refuse, in particular solids
    /// whose common centre of mass lies below the base (height < 0).
    pub fn from_solids(radius: f64, solids: &[Solid]) -> Result<Body, InvalidInput> {
        if solids.is_empty() {
            return Err(InvalidInput::NoSolids);
        }
        for solid in solids {
            solid.check()?;
        }
        let mass: f64 = solids.iter().map(|s| s.mass).sum();
        let height = solids.iter().map(|s| s.mass * s.height).sum::<f64>() / mass;
        let transverse = solids
            .iter()
            .map(|s| {
                let arm = s.height - height;
                s.transverse_inertia + s.mass * arm * arm
            })
            .sum();
        let axial = solids.iter().map(|s| s.axial_inertia).sum();
        Body::new(mass, radius, height, transverse, axial)
    }

    /// m, kg.
    pub fn mass(&self) -> f64 {
        self.mass
    }

    /// R, radius of the rim, m.
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// H, height of the centre of mass above the base, m.
    pub fn height(&self) -> f64 {
        self.height
    }

    /// A, kg m².
    pub fn transverse_inertia(&self) -> f64 {
        self.transverse_inertia
    }

    /// C, kg m².
    pub fn axial_inertia(&self) -> f64 {
        self.axial_inertia
    }

    /// K = A + mH²: transverse moment of inertia about the centre of the base, kg m².
    pub fn base_inertia(&self) -> f64 {
        self.transverse_inertia + self.mass * self.height * self.height
    }

    /// J = A + mH² + mR²: moment of inertia for tipping about a point of the rim, kg m².
    pub fn rim_inertia(&self) -> f64 {
        self.base_inertia() + self.mass * self.radius * self.radius
    }

    /// φ* with tan φ* = R/H, rad: the tilt at which the centre of mass is directly above the contact point
    /// (an unstable equilibrium); π/2 for a disk.
    pub fn balance_tilt(&self) -> f64 {
        libm::atan2(self.radius, self.height)
    }
}
