//! A rigid body on a base that is a regular polygon.

use super::{Vector, cross, dot, length, minus, plus, times};
use crate::body::Body;
use crate::error::{InvalidInput, bounded, positive};
use core::f64::consts::PI;

/// A rigid body whose base is a regular polygon, with equal moments of inertia about all axes through the centre of
/// mass perpendicular to the axis of symmetry. Every body that an n-fold rotation about the axis maps onto itself has
/// such moments, for n ≥ 3.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PolygonalBody {
    /// The body on the rim through the corners.
    round: Body,
    corners: u32,
}

impl PolygonalBody {
    /// The fewest and the most corners of a base.
    pub const CORNERS: core::ops::RangeInclusive<u32> = 3..=100_000;

    /// A body from the number of its corners and the body on the round rim through them, whose radius is the distance
    /// of the corners from the axis.
    ///
    /// # Errors
    /// Refuses fewer than 3 or more than 100 000 corners.
    pub fn new(corners: u64, round: Body) -> Result<PolygonalBody, InvalidInput> {
        let known = u32::try_from(corners).ok();
        let known = known.filter(|corners| PolygonalBody::CORNERS.contains(corners));
        let allowed = |_| known.is_some();
        bounded(
            "corners",
            corners as f64,
            allowed,
            "between 3 and 100000",
            "",
        )?;
        let corners = known.unwrap_or(*PolygonalBody::CORNERS.start());
        Ok(PolygonalBody { round, corners })
    }

    /// A uniform prism: mass (kg), number of corners, distance of the corners from the axis (m), length (m), and the
    /// radius of a coaxial round bore (m; 0 for none).
    ///
    /// With the area and the polar second moment of the cross-section, n R² sin(2π/n)/2 − πa² and
    /// n R⁴ sin(2π/n) (2 + cos(2π/n))/12 − πa⁴/2, C is m times their ratio and A = C/2 + m L²/12.
    ///
    /// # Errors
    /// Refuses numbers that are not positive (a bore may be 0), a bore as wide as the incircle, and what
    /// [`PolygonalBody::new`] refuses.
    pub fn prism(
        mass: f64,
        corners: u64,
        radius: f64,
        length: f64,
        bore: f64,
    ) -> Result<PolygonalBody, InvalidInput> {
        positive("mass", mass, "kg")?;
        positive("radius", radius, "m")?;
        positive("length", length, "m")?;
        let count = corners.max(3) as f64;
        let incircle = radius * libm::cos(PI / count);
        let narrow = |bore| (0.0..incircle).contains(&bore);
        bounded(
            "bore",
            bore,
            narrow,
            "inside [0, radius of the incircle)",
            "m",
        )?;
        let (sin, cos) = libm::sincos(2.0 * PI / count);
        let (outer, inner) = (radius * radius, bore * bore);
        let area = 0.5 * count * sin * outer - PI * inner;
        let polar = count * sin * (2.0 + cos) * outer * outer / 12.0 - 0.5 * PI * inner * inner;
        let axial = mass * polar / area;
        let transverse = 0.5 * axial + mass * length * length / 12.0;
        let round = Body::new(mass, radius, 0.5 * length, transverse, axial)?;
        PolygonalBody::new(corners, round)
    }

    /// n.
    pub fn corners(&self) -> u32 {
        self.corners
    }

    /// The body on the round rim through the corners.
    pub fn round(&self) -> &Body {
        &self.round
    }

    /// 2π/n, the angle from corner to corner, rad.
    pub fn corner_angle(&self) -> f64 {
        2.0 * PI / f64::from(self.corners)
    }

    /// The factor by which a plastic impact changes the tilt rate of a plane rocking from one edge to the opposite one
    /// (Housner 1963), for an even number of corners: 1 − 2ma²/(A + mH² + ma²) with the distance a of the edges
    /// from the axis. Where it is negative the body stays down.
    pub fn housner_ratio(&self) -> f64 {
        let arm = self.round.radius() * libm::cos(0.5 * self.corner_angle());
        let lever = self.round.mass() * arm * arm;
        1.0 - 2.0 * lever / (self.round.base_inertia() + lever)
    }

    pub(super) fn mass(&self) -> f64 {
        self.round.mass()
    }

    /// The material azimuth of corner k, counted round without end, rad. Corner 0 is lowest at spin 0.
    fn azimuth(&self, k: i64) -> f64 {
        let k = k.rem_euclid(i64::from(self.corners));
        PI + k as f64 * self.corner_angle()
    }

    /// From the centre of mass to corner k.
    pub(super) fn corner(&self, k: i64) -> Vector {
        let (sin, cos) = libm::sincos(self.azimuth(k));
        let radius = self.round.radius();
        [radius * cos, radius * sin, -self.round.height()]
    }

    /// The unit vector along the edge from corner k to corner k + 1.
    pub(super) fn edge(&self, k: i64) -> Vector {
        let along = minus(self.corner(k + 1), self.corner(k));
        times(1.0 / length(along), along)
    }

    /// I a, about the centre of mass.
    pub(super) fn inertia(&self, a: Vector) -> Vector {
        let (transverse, axial) = (self.round.transverse_inertia(), self.round.axial_inertia());
        [transverse * a[0], transverse * a[1], axial * a[2]]
    }

    /// I⁻¹ a.
    pub(super) fn per_inertia(&self, a: Vector) -> Vector {
        let (transverse, axial) = (self.round.transverse_inertia(), self.round.axial_inertia());
        [a[0] / transverse, a[1] / transverse, a[2] / axial]
    }

    /// I a + m b × (a × b): the angular momentum about a point at b, at rest, of a body that rotates with a.
    pub(super) fn inertia_about(&self, b: Vector, a: Vector) -> Vector {
        plus(self.inertia(a), self.mass(), cross(b, cross(a, b)))
    }

    /// The inverse of [`Self::inertia_about`], by the formula of Sherman and Morrison.
    pub(super) fn per_inertia_about(&self, b: Vector, a: Vector) -> Vector {
        let (mass, round) = (self.mass(), &self.round);
        let far = mass * dot(b, b);
        let diagonal = [
            round.transverse_inertia() + far,
            round.transverse_inertia() + far,
            round.axial_inertia() + far,
        ];
        let divided = |v: Vector| core::array::from_fn(|i| v[i] / diagonal[i]);
        let (alone, back): (Vector, Vector) = (divided(a), divided(b));
        plus(
            alone,
            mass * dot(b, alone) / (1.0 - mass * dot(b, back)),
            back,
        )
    }

    /// A + m(H² + a²): the moment of inertia about edge k.
    pub(super) fn edge_inertia(&self, k: i64) -> f64 {
        let arm = cross(self.corner(k), self.edge(k));
        self.round.transverse_inertia() + self.mass() * dot(arm, arm)
    }
}
