//! Solids of revolution from which a [`Body`](crate::Body) is composed.
//!
//! All solids share the symmetry axis. Heights are measured from the table with the body upright.
//! The moments of inertia are the textbook ones (e.g. Landau & Lifshitz, *Mechanics*, §32);
//! [`Body::from_solids`](crate::Body::from_solids) combines them by the parallel-axis theorem.

use crate::error::{InvalidInput, at_most_twice, finite, not_negative, out_of_bounds, positive};
use core::f64::consts::PI;

/// One part of a body: its mass and its moments of inertia about its own centre of mass (SI units).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Solid {
    /// Mass, kg.
    pub mass: f64,
    /// Height of its centre of mass above the table, m.
    pub height: f64,
    /// Moment of inertia about a horizontal axis through its centre of mass, kg m².
    pub transverse_inertia: f64,
    /// Moment of inertia about the symmetry axis, kg m².
    pub axial_inertia: f64,
}

impl Solid {
    /// Checks the numbers of a solid that was not made by one of the functions below.
    ///
    /// # Errors
    /// Refuses mass ≤ 0, a moment of inertia < 0, C > 2A, and numbers that are not finite.
    pub fn check(&self) -> Result<(), InvalidInput> {
        positive("mass", self.mass, "kg")?;
        finite("height", self.height)?;
        not_negative("transverse_inertia", self.transverse_inertia, "kg m2")?;
        not_negative("axial_inertia", self.axial_inertia, "kg m2")?;
        at_most_twice(self.axial_inertia, self.transverse_inertia)
    }

    /// A solid cylinder of the given mass (kg), radius and length (m), and height `base` (m) of its lower
    /// face.
    ///
    /// # Errors
    /// Refuses mass or radius ≤ 0, length < 0, and numbers that are not finite.
    pub fn cylinder(mass: f64, radius: f64, length: f64, base: f64) -> Result<Solid, InvalidInput> {
        positive("radius", radius, "m")?;
        Solid::hollow_cylinder(mass, 0.0, radius, length, base)
    }

    /// A cylinder with a coaxial bore: mass (kg), inner radius a, outer radius b, length L and height of
    /// the lower face (m). C = m(a² + b²)/2, A = C/2 + m L²/12.
    ///
    /// # Errors
    /// Refuses mass or outer radius ≤ 0, an inner radius outside [0, outer radius], length < 0.
    pub fn hollow_cylinder(
        mass: f64,
        inner_radius: f64,
        outer_radius: f64,
        length: f64,
        base: f64,
    ) -> Result<Solid, InvalidInput> {
        positive("mass", mass, "kg")?;
        positive("outer_radius", outer_radius, "m")?;
        not_negative("inner_radius", inner_radius, "m")?;
        if inner_radius > outer_radius {
            let bound = format!("at most outer_radius = {outer_radius} m");
            let error = out_of_bounds("inner_radius", inner_radius, &bound, "m");
            return Err(error.beside("outer_radius"));
        }
        not_negative("length", length, "m")?;
        finite("base", base)?;
        let axial = 0.5 * mass * (inner_radius * inner_radius + outer_radius * outer_radius);
        Ok(Solid {
            mass,
            height: base + 0.5 * length,
            transverse_inertia: 0.5 * axial + mass * length * length / 12.0,
            axial_inertia: axial,
        })
    }

    /// A thin disk: mass (kg), radius and height (m).
    ///
    /// # Errors
    /// Refuses mass or radius ≤ 0.
    pub fn disk(mass: f64, radius: f64, height: f64) -> Result<Solid, InvalidInput> {
        Solid::cylinder(mass, radius, 0.0, height)
    }

    /// A thin ring: mass (kg), radius and height (m).
    ///
    /// # Errors
    /// Refuses mass or radius ≤ 0.
    pub fn ring(mass: f64, radius: f64, height: f64) -> Result<Solid, InvalidInput> {
        Solid::wall(mass, radius, 0.0, height)
    }

    /// A thin cylindrical wall, open at both ends: mass (kg), radius, length and height of its lower
    /// edge (m).
    ///
    /// # Errors
    /// Refuses mass or radius ≤ 0, length < 0.
    pub fn wall(mass: f64, radius: f64, length: f64, base: f64) -> Result<Solid, InvalidInput> {
        positive("radius", radius, "m")?;
        Solid::hollow_cylinder(mass, radius, radius, length, base)
    }

    /// A filling of the given density (kg/m³), radius, depth and height of its lower face (m). It moves
    /// with the body as if frozen; a real liquid follows the rotation of its container less.
    ///
    /// # Errors
    /// Refuses density, radius or depth ≤ 0.
    pub fn filling(
        density: f64,
        radius: f64,
        depth: f64,
        base: f64,
    ) -> Result<Solid, InvalidInput> {
        positive("density", density, "kg/m3")?;
        positive("radius", radius, "m")?;
        positive("depth", depth, "m")?;
        Solid::cylinder(density * PI * radius * radius * depth, radius, depth, base)
    }
}
