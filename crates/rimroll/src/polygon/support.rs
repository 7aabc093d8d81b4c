//! The equations of motion of a body on one corner, on an edge or in flight.
//!
//! In the axes of the body, with b from the centre of mass to a corner on the table and I for diag(A, A, C):
//!
//! ```text
//! no slip, a corner:    I_b Ω̇ = mg b × Γ − Ω × I_b Ω,     I_b a = I a + m b × (a × b)
//! no slip, an edge e:   Ω = ω e,   (A + m|b × e|²) ω̇ = e · (mg b × Γ)
//! no friction:          I Ω̇ = Σ N b × Γ − Ω × I Ω,   with the forces N that keep each corner at the height 0.
//! ```
//!
//! Without slip the two corners of an edge carry equal forces: the body is its own mirror image in the plane through the
//! centre of mass across the edge, and rotates about an axis across that plane. So it leaves an edge only by
//! lifting off. Without friction it can turn about the vertical while it lies on an edge, and one force can vanish alone.
//!
//! In flight I Ω̇ = −Ω × I Ω, and the centre of mass falls on a parabola.

use super::body::PolygonalBody;
use super::pose::{COORDINATES, Pose, SUPPORTED};
use super::{Vector, cross, dot, minus, plus, times};
use crate::law::IdealLaw;
use crate::solve::System;

/// The corners that carry the body. Corners are counted round without end: corner k is also corner k + n.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Support {
    /// One corner.
    Corner(i64),
    /// The corners k and k + 1.
    Edge(i64),
    /// Nothing: the body flies, and k is its lowest corner.
    Flight(i64),
    /// All corners; k is the one that was lowest before.
    Face(i64),
}

impl Support {
    /// The name that the user reads.
    pub fn name(self) -> &'static str {
        match self {
            Support::Corner(_) => "corner",
            Support::Edge(_) => "edge",
            Support::Flight(_) => "flight",
            Support::Face(_) => "face",
        }
    }

    /// A corner that carries the body, or the lowest one.
    pub fn corner(self) -> i64 {
        match self {
            Support::Corner(k) | Support::Edge(k) | Support::Flight(k) | Support::Face(k) => k,
        }
    }

    /// The spin at which these corners are lowest, rad.
    pub(super) fn middle_spin(self, body: &PolygonalBody) -> f64 {
        let middle = match self {
            Support::Corner(k) | Support::Flight(k) | Support::Face(k) => k as f64,
            Support::Edge(k) => k as f64 + 0.5,
        };
        -middle * body.corner_angle()
    }

    pub(super) fn is_flight(self) -> bool {
        matches!(self, Support::Flight(_))
    }

    /// Whether the body is carried in the same way; which corner is lowest in flight does not matter.
    pub(super) fn is_same_phase(self, other: Support) -> bool {
        self == other || self.is_flight() && other.is_flight()
    }
}

/// A body on a support, or in flight.
#[derive(Debug, Clone, Copy)]
pub(super) struct SupportedBody {
    pub body: PolygonalBody,
    pub law: IdealLaw,
    pub gravity: f64,
    pub support: Support,
    /// From the centre of mass to the first corner of the support.
    first: Vector,
    /// To the second corner of an edge.
    second: Option<Vector>,
    edge: Vector,
    /// √(g/R), 1/s.
    pub falling_rate: f64,
    /// In flight, the horizontal velocity of the centre of mass, m/s.
    drift: [f64; 2],
}

/// What the table does to the body.
#[derive(Debug, Clone, Copy)]
pub(super) struct Reaction {
    /// Ω̇, rad/s².
    pub acceleration: Vector,
    /// The normal forces at the two corners, N; the second is 0 on one corner.
    pub normal: [f64; 2],
    /// |T|, N.
    pub friction: f64,
}

impl SupportedBody {
    pub fn new(
        body: &PolygonalBody,
        law: IdealLaw,
        gravity: f64,
        support: Support,
    ) -> SupportedBody {
        let k = support.corner();
        let second = matches!(support, Support::Edge(_)).then(|| body.corner(k + 1));
        SupportedBody {
            body: *body,
            law,
            gravity,
            support,
            first: body.corner(k),
            second,
            edge: body.edge(k),
            falling_rate: (gravity / body.round().radius()).sqrt(),
            drift: [0.0; 2],
        }
    }

    /// In flight with a velocity of the centre of mass (in the body's axes, m/s), from where this support holds the body.
    pub fn released(&self, at: &Pose, rate: Vector, velocity: Vector) -> (SupportedBody, Pose) {
        let flight = Support::Flight(self.support.corner());
        let [x, y, rise] = at.on_table(velocity);
        let supported = SupportedBody {
            drift: [x, y],
            ..SupportedBody::new(&self.body, self.law, self.gravity, flight)
        };
        let pose = Pose {
            rate,
            height: self.height(at),
            rise,
            ..*at
        };
        (supported, pose)
    }

    /// In flight, this body with the corner that is lowest now.
    pub fn with_lowest(&self, at: &Pose) -> SupportedBody {
        let spin = at.state(self.support.middle_spin(&self.body)).spin;
        let lowest = libm::rint(-spin / self.body.corner_angle()) as i64;
        SupportedBody {
            support: Support::Flight(lowest),
            first: self.body.corner(lowest),
            ..*self
        }
    }

    /// The corners that carry the body.
    pub fn corners(&self) -> Vec<i64> {
        match self.support {
            Support::Corner(k) => vec![k],
            Support::Edge(k) => vec![k, k + 1],
            Support::Flight(_) => Vec::new(),
            Support::Face(k) => (k..k + i64::from(self.body.corners())).collect(),
        }
    }

    /// From the centre of mass to the middle of the support or to the lowest corner, in the body's axes, m.
    pub fn middle(&self) -> Vector {
        match (self.support, self.second) {
            (Support::Face(_), _) => [0.0, 0.0, self.first[2]],
            (_, Some(second)) => times(0.5, plus(self.first, 1.0, second)),
            (_, None) => self.first,
        }
    }

    /// The place on the table (x, y) of the centre of mass, given that of the first corner (no slip), of the centre of
    /// mass itself (no friction) or of the top of its parabola (in flight), m.
    pub fn center(&self, at: &Pose, anchor: [f64; 2]) -> [f64; 2] {
        if self.support.is_flight() {
            let since_top = -at.rise / self.gravity;
            return core::array::from_fn(|i| anchor[i] + since_top * self.drift[i]);
        }
        match self.law {
            IdealLaw::NoSlip => {
                let [x, y, _] = at.on_table(self.first);
                [anchor[0] - x, anchor[1] - y]
            }
            IdealLaw::Frictionless => anchor,
        }
    }

    /// The inverse of [`Self::center`].
    pub fn anchor(&self, at: &Pose, center: [f64; 2]) -> [f64; 2] {
        if self.support.is_flight() {
            let since_top = -at.rise / self.gravity;
            return core::array::from_fn(|i| center[i] - since_top * self.drift[i]);
        }
        match self.law {
            IdealLaw::NoSlip => {
                let [x, y, _] = at.on_table(self.first);
                [center[0] + x, center[1] + y]
            }
            IdealLaw::Frictionless => center,
        }
    }

    /// The height of corner k over the table, m, and its rate, m/s.
    pub fn gap(&self, at: &Pose, k: i64) -> (f64, f64) {
        if self.support.is_flight() {
            let corner = self.body.corner(k);
            let rate = at.rise + dot(at.up, cross(at.rate, corner));
            return (at.height + dot(at.up, corner), rate);
        }
        let over = minus(self.body.corner(k), self.first);
        (dot(at.up, over), dot(at.up, cross(at.rate, over)))
    }

    /// The acceleration of the height of corner k over the table, m/s².
    pub fn gap_acceleration(&self, at: &Pose, k: i64) -> f64 {
        let (over, falling) = match self.support {
            Support::Flight(_) => (self.body.corner(k), self.gravity),
            _ => (minus(self.body.corner(k), self.first), 0.0),
        };
        let turning = dot(cross(at.up, at.rate), cross(at.rate, over));
        turning + dot(at.up, cross(self.reaction(at).acceleration, over)) - falling
    }

    /// The height of the centre of mass, m.
    pub fn height(&self, at: &Pose) -> f64 {
        match self.support {
            Support::Flight(_) => at.height,
            _ => -dot(self.first, at.up),
        }
    }

    /// The velocity of the centre of mass in the body's axes, m/s.
    pub fn velocity(&self, at: &Pose) -> Vector {
        if self.support.is_flight() {
            let [x, y] = self.drift;
            return at.in_body([x, y, at.rise]);
        }
        match self.law {
            // Both ends of an edge are at rest. At a start with a yaw rate its middle is.
            IdealLaw::NoSlip => cross(self.middle(), at.rate),
            IdealLaw::Frictionless => times(self.rise(at), at.up),
        }
    }

    /// The rate of the height of the centre of mass, m/s.
    pub fn rise(&self, at: &Pose) -> f64 {
        match self.support {
            Support::Flight(_) => at.rise,
            _ => -dot(cross(self.first, at.up), at.rate),
        }
    }

    /// Kinetic energy, J.
    pub fn kinetic(&self, at: &Pose) -> f64 {
        let velocity = self.velocity(at);
        0.5 * self.body.mass() * dot(velocity, velocity)
            + 0.5 * dot(at.rate, self.body.inertia(at.rate))
    }

    /// Kinetic and potential energy over the body at rest on its face, J.
    pub fn energy_above_rest(&self, at: &Pose) -> f64 {
        // z − H = R sin φ cos β − H sin² φ / (1 + cos φ), where the difference would cancel.
        let base = dot(self.first, [at.up[0], at.up[1], 0.0]);
        let sin = at.sin_tilt();
        let sunk = self.body.round().height() * sin * sin / (1.0 + at.up[2]);
        let risen = match self.support {
            Support::Flight(_) => at.height - self.body.round().height(),
            _ => -(base + sunk),
        };
        self.kinetic(at) + self.body.mass() * self.gravity * risen
    }

    /// The angular acceleration and the forces of the table.
    pub fn reaction(&self, at: &Pose) -> Reaction {
        let acting = |acceleration, normal| Reaction {
            acceleration,
            normal: [normal, 0.0],
            friction: 0.0,
        };
        match (self.support, self.law) {
            (Support::Face(_), _) => acting([0.0; 3], self.body.mass() * self.gravity),
            (Support::Flight(_), _) => acting(self.free_acceleration(at), 0.0),
            (_, IdealLaw::NoSlip) => self.reaction_without_slip(at),
            (_, IdealLaw::Frictionless) => self.reaction_without_friction(at),
        }
    }

    /// Ω̇ without a force of the table, rad/s².
    fn free_acceleration(&self, at: &Pose) -> Vector {
        let gyroscopic = cross(at.rate, self.body.inertia(at.rate));
        times(-1.0, self.body.per_inertia(gyroscopic))
    }

    fn angular_acceleration_without_slip(&self, at: &Pose) -> Vector {
        let (body, b) = (&self.body, self.first);
        let moment = times(body.mass() * self.gravity, cross(b, at.up));
        if self.second.is_some() {
            let rate = dot(self.edge, moment) / body.edge_inertia(self.support.corner());
            return times(rate, self.edge);
        }
        let gyroscopic = cross(at.rate, body.inertia_about(b, at.rate));
        body.per_inertia_about(b, minus(moment, gyroscopic))
    }

    fn reaction_without_slip(&self, at: &Pose) -> Reaction {
        let acceleration = self.angular_acceleration_without_slip(at);
        let arm = times(-1.0, self.first);
        let of_center = plus(
            cross(acceleration, arm),
            1.0,
            cross(at.rate, cross(at.rate, arm)),
        );
        let force = times(self.body.mass(), plus(of_center, self.gravity, at.up));
        let normal = dot(force, at.up);
        let along = plus(force, -normal, at.up);
        let share = if self.second.is_some() { 0.5 } else { 1.0 };
        Reaction {
            acceleration,
            normal: [share * normal, (1.0 - share) * normal],
            friction: dot(along, along).sqrt(),
        }
    }

    fn reaction_without_friction(&self, at: &Pose) -> Reaction {
        let body = &self.body;
        let gyroscopic = body.per_inertia(cross(at.rate, body.inertia(at.rate)));
        let turning = cross(cross(at.up, at.rate), at.rate);
        let lever = |b| cross(b, at.up);
        // The acceleration that a force must add at each corner.
        let missing = |b| self.gravity + dot(lever(b), gyroscopic) - dot(b, turning);
        let mobility = |a, b| 1.0 / body.mass() + dot(lever(a), body.per_inertia(lever(b)));
        let first = self.first;
        let normal = match self.second {
            None => [missing(first) / mobility(first, first), 0.0],
            Some(second) => {
                let (a, b) = (mobility(first, first), mobility(second, second));
                let c = mobility(first, second);
                let determinant = a * b - c * c;
                let (p, q) = (missing(first), missing(second));
                [(b * p - c * q) / determinant, (a * q - c * p) / determinant]
            }
        };
        let mut moment = times(normal[0], lever(first));
        if let Some(second) = self.second {
            moment = plus(moment, normal[1], lever(second));
        }
        Reaction {
            acceleration: minus(body.per_inertia(moment), gyroscopic),
            normal,
            friction: 0.0,
        }
    }
}

impl System<f64, SUPPORTED> for SupportedBody {
    fn rates(&self, u: &[f64; SUPPORTED]) -> [f64; SUPPORTED] {
        let at = Pose::supported(*u);
        let acceleration = match self.law {
            IdealLaw::NoSlip => self.angular_acceleration_without_slip(&at),
            IdealLaw::Frictionless => self.reaction_without_friction(&at).acceleration,
        };
        let (up, heading) = at.kinematics();
        Pose {
            up,
            rate: acceleration,
            heading,
            ..at
        }
        .on_support()
    }

    /// The lean decides which corner is lowest, so its error is relative to its own size; so is that of the rates.
    fn scale(&self, u: &[f64; SUPPORTED]) -> [f64; SUPPORTED] {
        const SMALL: f64 = 1e-6;
        let at = Pose::supported(*u);
        let lean = at.sin_tilt() + SMALL;
        let rate = dot(at.rate, at.rate).sqrt() + SMALL.sqrt() * self.falling_rate;
        [lean, lean, 1.0, rate, rate, rate, 1.0]
    }
}

/// Flight.
impl System<f64, COORDINATES> for SupportedBody {
    fn rates(&self, u: &[f64; COORDINATES]) -> [f64; COORDINATES] {
        let at = Pose::from_array(u);
        let (up, heading) = at.kinematics();
        Pose {
            up,
            rate: self.free_acceleration(&at),
            heading,
            height: at.rise,
            rise: -self.gravity,
        }
        .into_array()
    }

    fn scale(&self, u: &[f64; COORDINATES]) -> [f64; COORDINATES] {
        let [a, b, c, p, q, r, heading] = <SupportedBody as System<f64, SUPPORTED>>::scale(
            self,
            &Pose::from_array(u).on_support(),
        );
        let radius = self.body.round().radius();
        [
            a,
            b,
            c,
            p,
            q,
            r,
            heading,
            radius,
            radius * self.falling_rate,
        ]
    }
}
