//! What the type of a friction law must define: the friction force as a function of the slip, and its parameters.

use crate::error::InvalidInput;
use crate::real::{Real, Scalar};

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

/// A friction law with its parameters, as a user chooses it.
pub trait FrictionModel: Clone + PartialEq + core::fmt::Debug {
    /// The name that users type.
    const NAME: &'static str;

    /// The friction as a function of the slip, for numbers of type `T`.
    type Friction<T: Scalar>: Friction<T> + Clone;

    /// The law with parameters given by name.
    ///
    /// # Errors
    /// Refuses parameters from which no law can be made. Bounds are for [`check`](Self::check).
    fn from_named(given: &NamedParameters<'_>) -> Result<Self, InvalidInput>;

    /// Checks the parameters.
    ///
    /// # Errors
    /// Names the first parameter that is out of bounds.
    fn check(&self) -> Result<(), InvalidInput>;

    /// This law with all coefficients of friction multiplied by `factor`.
    #[must_use]
    fn scaled(&self, factor: f64) -> Self;

    /// The coefficient of Coulomb friction in an impact that begins with this slip speed (m/s); 0 if the
    /// friction does not grow with the normal force.
    fn impact_coefficient<T: Scalar>(&self, slip_speed: T) -> T;

    /// The friction for numbers of type `T`.
    fn friction<T: Scalar>(&self) -> Self::Friction<T>;
}

/// Dry friction: the rim sticks until |T| exceeds the static coefficient times N.
pub trait DryFrictionModel: FrictionModel {
    /// μ_s.
    fn static_friction(&self) -> f64;
}

/// Parameters of a law by the names that users type.
#[derive(Debug, Clone, Copy)]
pub struct NamedParameters<'a> {
    /// Single numbers.
    pub numbers: &'a [(String, f64)],
    /// Lists of numbers.
    pub tables: &'a [(String, Vec<f64>)],
}

impl NamedParameters<'_> {
    /// A number, or 0 if it is missing.
    pub fn number(&self, name: &str) -> f64 {
        self.optional(name).unwrap_or(0.0)
    }

    /// A number that may be missing.
    pub fn optional(&self, name: &str) -> Option<f64> {
        let found = self.numbers.iter().find(|(given, _)| given == name);
        found.map(|&(_, value)| value)
    }

    /// A list of numbers, empty if it is missing.
    pub fn table(&self, name: &str) -> &[f64] {
        let found = self.tables.iter().find(|(given, _)| given == name);
        found.map_or(&[], |(_, values)| values)
    }
}
