//! The friction force on a rim that slips, as a function of the slip.

use crate::real::Real;

/// The friction force T = N a + b on a rim that slips, as components along e_x1 and e_y1.
///
/// The vector a is stored as `numerator`/`denominator`, which saves a division: dry friction is −μu/|u|.
#[derive(Debug, Clone, Copy)]
pub struct FrictionForce<T> {
    /// a times `denominator`.
    pub numerator: [T; 2],
    /// Positive.
    pub denominator: T,
    /// b, in newtons; `None` where friction is proportional to the normal force.
    pub load_independent: Option<[T; 2]>,
}

impl<T: Real> FrictionForce<T> {
    /// The friction −`factor` · `slip` · N.
    #[inline(always)]
    pub fn proportional_to_normal(slip: [T; 2], factor: T) -> Self {
        FrictionForce::with_denominator(slip, factor, T::from(1.0))
    }

    /// The friction −`factor` · `slip` · N / `denominator`.
    #[inline(always)]
    pub fn with_denominator(slip: [T; 2], factor: T, denominator: T) -> Self {
        let against = -factor;
        FrictionForce {
            numerator: [against * slip[0], against * slip[1]],
            denominator,
            load_independent: None,
        }
    }
}

/// A friction force that is a function of the slip.
pub trait Friction<T: Real> {
    /// The friction force at a slip (m/s, along e_x1 and e_y1).
    fn friction_force(&self, slip: [T; 2]) -> FrictionForce<T>;
}

/// Dry friction: T = −μ(|u|) N u/|u| at any slip u ≠ 0. A rim that does not slip sticks and rolls.
pub trait DryFriction<T: Real>: Friction<T> {
    /// μ at this slip speed (m/s), which may be 0.
    fn coefficient(&self, speed: T) -> T;

    /// The implementation of [`Friction::friction_force`] for dry friction.
    #[inline(always)]
    fn dry_friction_force(&self, slip: [T; 2]) -> FrictionForce<T> {
        let speed = (slip[0] * slip[0] + slip[1] * slip[1]).sqrt();
        FrictionForce::with_denominator(slip, self.coefficient(speed), speed)
    }
}
