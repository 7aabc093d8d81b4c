//! What the two laws have in common: the tilt by itself.
//!
//! Under both laws the other velocities follow from the tilt alone, so that energy says how fast the
//! tilt changes at each tilt: I φ̇² = G(φ). The clock is η = ln y with y = tan(φ/2), dφ = sin φ dη,
//! by which a near-collision, however near, is no shorter than the rest of the motion.

use crate::real::Real;

/// The terms of G are known to within this part of their size: some roundings.
pub(super) const ROUNDING: f64 = 16.0 * f64::EPSILON;

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

    /// How large the terms are of which G is the difference at a point: those of energy and weight, and those
    /// of yaw and spin, J.
    fn terms(&self, point: &Point<T>) -> [T; 2];

    /// A bound of the rounding error of G at a point, J.
    #[inline(always)]
    fn rounding(&self, point: &Point<T>, _eta: T) -> T {
        let [weight, turning] = self.terms(point);
        T::from(ROUNDING) * (weight + turning)
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

#[cfg(test)]
mod tests {
    use super::{Pace, Tilting};
    use crate::law::Parameters;
    use crate::presets;
    use crate::state::State;
    use crate::turn::exact::fundamental::Fundamental;
    use crate::turn::exact::rolling::Rolling;
    use crate::turn::exact::sliding::Sliding;
    use crate::turn::exact::start::Start;

    /// How far dψ/dη and dt/dη are from w √(I/G) and sin φ √(I/G), relative to these, and at how many tilts.
    fn off(motion: &impl Tilting<f64>) -> (f64, usize) {
        let rates = |pace: Pace<f64>| [pace.yaw, pace.time].map(|part| part / pace.square.sqrt());
        let etas = (-60..0).map(|i| 0.1 * f64::from(i));
        let moving = etas.filter(|&eta| motion.at(libm::exp(eta), eta).drive > 0.0);
        moving.fold((0.0, 0), |(most, count), eta| {
            let y = libm::exp(eta);
            let (quick, plain) = (
                rates(motion.pace(y, eta)),
                rates(Pace::of(&motion.at(y, eta))),
            );
            let off = (0..2).map(|i| (quick[i] / plain[i] - 1.0).abs());
            (off.fold(most, f64::max), count + 1)
        })
    }

    #[test]
    fn the_pace_without_divisions_is_that_of_the_motion_at_its_tilt() {
        let k = Parameters::new(&presets::can_2007().unwrap(), 9.8);
        let start = Start::of(&State {
            tilt: 0.5,
            tilt_rate: -2.0,
            yaw_rate: 0.7,
            spin_rate: -0.4,
            ..State::default()
        });
        let table = Fundamental::new(k, 1.0);
        // Near the smallest tilt G is a small difference, a hundredth of its parts at the least here.
        for (off, count) in [
            off(&Rolling::new(&table, &start)),
            off(&Sliding::new(k, &start)),
        ] {
            assert!(count > 20, "{count}");
            assert!(off < 1e-13, "{off:e}");
        }
    }
}
