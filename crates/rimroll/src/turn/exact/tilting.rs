//! What the two laws have in common: the tilt by itself.
//!
//! Under both laws the other velocities follow from the tilt alone, so that energy says how fast the
//! tilt changes at each tilt: I φ̇² = G(φ). The clock is η = ln y with y = tan(φ/2), dφ = sin φ dη,
//! by which a near-collision, however near, is no shorter than the rest of the motion.

use crate::real::Real;

/// The motion at one tilt.
#[derive(Debug, Clone, Copy)]
pub(super) struct Point<T> {
    /// sin φ.
    pub(super) sin: T,
    /// cos φ.
    pub(super) cos: T,
    /// w = ψ̇ sin φ, rad/s.
    pub(super) w: T,
    /// s = θ̇ + ψ̇ cos φ, rad/s.
    pub(super) s: T,
    /// I, kg m²: J = A + mH² + mR² without slip, A + mρ² without friction.
    pub(super) inertia: T,
    /// G = I φ̇², J.
    pub(super) drive: T,
    /// dG/dη.
    pub(super) slope: T,
}

/// How fast yaw and time go by the tilt's clock: dψ/dη = `yaw`/√`square`, dt/dη = `time`/√`square`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pace<T> {
    pub(super) yaw: T,
    pub(super) time: T,
    /// Positive as G is.
    pub(super) square: T,
}

impl<T: Real> Pace<T> {
    /// dψ = w √(I/G) dη, dt = sin φ √(I/G) dη.
    #[inline(always)]
    pub(super) fn of(point: &Point<T>) -> Self {
        Pace {
            yaw: point.w * point.inertia,
            time: point.sin * point.inertia,
            square: point.inertia * point.drive,
        }
    }
}

/// Numbers that stay the same all through a motion and, together with the body's, determine it.
pub(super) type Conserved<T> = [T; 4];

/// A motion under one of the laws, from a start.
pub(super) trait Tilting<T: Real> {
    /// The numbers that make one motion of a body differ from another.
    fn conserved(&self) -> Conserved<T>;

    /// The motion where tan(φ/2) is y, whose logarithm is η.
    fn at(&self, y: T, eta: T) -> Point<T>;

    /// How fast yaw and time go there. Where it takes only this, a law may know how to do without divisions.
    #[inline(always)]
    fn pace(&self, y: T, eta: T) -> Pace<T> {
        Pace::of(&self.at(y, eta))
    }

    /// About where the tilt is smallest: tan(φ/2).
    fn lowest(&self) -> T;

    /// About where it is largest, but for the energy of yaw and spin; not a number for a start with
    /// the energy to pass the balance point.
    fn highest(&self) -> T;

    /// About how much farther than a largest tilt at y the drive has its next root, in η.
    fn gap_beyond(&self, y: T) -> T;

    /// Of the sign of the table's push N, and finite.
    fn pressing(&self, point: &Point<T>) -> T;

    /// About what that is, at a tilt, where the body rests on the table.
    fn resting(&self, point: &Point<T>) -> T;

    /// Positive where it is sure that the table pushes all the way between two tilts, the second below
    /// the balance point; it may not be sure.
    fn surely_pressing(&self, low: &Point<T>, high: &Point<T>) -> T;
}

/// sin φ and 1 − cos φ.
#[inline(always)]
pub(super) fn sin_and_versine<T: Real>(y: T) -> (T, T) {
    let sin = T::from(2.0) * y / (T::from(1.0) + y * y);
    (sin, sin * y)
}

/// How much farther, in η, the tilt's energy has its next root, but for yaw and spin, for a largest
/// tilt at y = tan(φ/2): R sin φ + H cos φ is there the same again.
#[inline(always)]
pub(super) fn gap_beyond<T: Real>(radius: T, height: T, y: T) -> T {
    let (sin, versine) = sin_and_versine(y);
    let two = T::from(2.0);
    let rise = radius * sin - height * versine;
    let next = rise / (rise + two * height) / y;
    // A little less than ln(next/y). Past the balance point yaw or spin hold the body back, and where the
    // next root is cannot be told: far, until the rule says otherwise.
    let gap = two * (next - y) / (next + y);
    gap.where_negative(two, gap)
}

/// tan(φ/2) where a centre of mass R beside and H over the rim is `rise` over H: R sin φ + H cos φ =
/// H + rise.
#[inline(always)]
pub(super) fn half_tangent_at_rise<T: Real>(radius: T, height: T, rise: T) -> T {
    let two = T::from(2.0);
    rise / (radius + (radius * radius - rise * (rise + two * height)).sqrt())
}
