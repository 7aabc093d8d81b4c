//! The system of differential equations of one phase, with its error scales and time transformation.

use crate::error_scale::ErrorScale;
use crate::law::{Dynamics, DynamicsExt, Parameters};
use crate::real::Real;
use crate::solve::System;
use crate::state::{COORDINATES, COORDINATES_AT_REST, Coordinates, IGNORABLE, RIGID_COORDINATES};

/// The independent variable of a step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum IndependentVariable {
    /// τ, or σ in dry slip: all rates are bounded.
    Regularized,
    /// The time, so that a step can end at a given time.
    Time,
}

/// The equations of motion under one law, with their error scales.
pub(super) struct PhaseSystem<'a, T = f64, L: ?Sized = dyn Dynamics<T> + 'a> {
    pub dynamics: &'a L,
    pub error_scale: ErrorScale<T>,
    /// Whether they are those of slip under dry friction.
    dry: bool,
    variable: IndependentVariable,
    /// Added to the error scales of the rates of rotation, rad/s.
    rate_floor: T,
    /// The least error scale of the direction of a dry slip, rad.
    direction_floor: T,
    /// Added to the error scales of the work and the losses, J.
    energy_floor: T,
}

impl<'a, T: Real, L: Dynamics<T> + ?Sized> PhaseSystem<'a, T, L> {
    pub(super) fn new(dynamics: &'a L, variable: IndependentVariable) -> Self {
        PhaseSystem {
            dynamics,
            error_scale: ErrorScale::new(dynamics.parameters()),
            dry: false,
            variable,
            rate_floor: T::from(0.0),
            direction_floor: T::from(0.0),
            energy_floor: T::from(0.0),
        }
    }

    /// The system for slip under dry friction, whose regularized independent variable is the σ of
    /// [`ErrorScale::sundman_denominator`].
    pub(super) fn slipping(dynamics: &'a L, variable: IndependentVariable) -> Self {
        PhaseSystem {
            dry: true,
            ..PhaseSystem::new(dynamics, variable)
        }
    }

    /// The system on a table that moves, whose acceleration has rounding errors. They change the rates of rotation by
    /// more than a tolerance relative to the rates themselves, where these are tiny: as a body begins to rock, and in
    /// planar motions. They do the same to a slip across the plane of such a motion. (Under dry friction they change the
    /// direction of the slip. The floor is relative to the slip there, because a slip with errors as large as itself would
    /// not stop.) The rounding errors of the work so far are large beside the energy of a body that begins to rock again.
    pub(super) fn on_moving_table(self, tolerance: f64) -> Self {
        let k = self.dynamics.parameters();
        PhaseSystem {
            rate_floor: rate_floor(k),
            direction_floor: T::from(ROUNDING / tolerance),
            energy_floor: T::from(FLOOR) * k.m * k.g * k.r,
            ..self
        }
    }

    /// dτ/dσ, where σ is the independent variable.
    #[inline(always)]
    pub(super) fn sundman_factor(&self, u: &Coordinates<T>) -> T {
        match self.variable {
            IndependentVariable::Regularized if self.dry => self.error_scale.sundman_factor(u),
            IndependentVariable::Regularized => T::from(1.0),
            IndependentVariable::Time => T::from(1.0) / u.sin,
        }
    }

    /// The rates of all coordinates with respect to the independent variable.
    #[inline(always)]
    fn all_rates(&self, u: &Coordinates<T>) -> [T; COORDINATES] {
        let rates = self.dynamics.rates(u).into_array();
        if !self.dry && self.variable == IndependentVariable::Regularized {
            return rates;
        }
        let factor = self.sundman_factor(u);
        rates.map(|rate| factor * rate)
    }

    /// The error scales while a slip begins under dry friction.
    pub(super) fn scales_at_slip_onset(&self, u: &Coordinates<T>) -> Coordinates<T> {
        let scales = self.error_scale.scales_at_slip_onset(u);
        self.with_direction_floor(Coordinates {
            w: scales.w.max(self.rate_floor),
            s: scales.s.max(self.rate_floor),
            ..scales
        })
    }

    #[inline(always)]
    fn scales(&self, u: &Coordinates<T>) -> Coordinates<T> {
        let scales = if self.dry {
            self.with_direction_floor(self.error_scale.scales_in_dry_slip(u))
        } else if cfg!(feature = "ground") {
            let scales = self.error_scale.scales(u);
            let slip_floor = self.error_scale.radius * self.rate_floor;
            Coordinates {
                slip_x: scales.slip_x + slip_floor,
                slip_y: scales.slip_y + slip_floor,
                ..scales
            }
        } else {
            self.error_scale.scales(u)
        };
        Coordinates {
            p: scales.p + self.rate_floor,
            w: scales.w + self.rate_floor,
            s: scales.s + self.rate_floor,
            friction_loss: scales.friction_loss + self.energy_floor,
            resistance_loss: scales.resistance_loss + self.energy_floor,
            impact_loss: scales.impact_loss + self.energy_floor,
            ground_work: scales.ground_work + self.energy_floor,
            ..scales
        }
    }

    /// These error scales of a dry slip with the floor of its direction.
    #[inline(always)]
    fn with_direction_floor(&self, scales: Coordinates<T>) -> Coordinates<T> {
        Coordinates {
            slip_y: scales.slip_y.max(self.direction_floor * scales.slip_x),
            ..scales
        }
    }
}

/// All coordinates, as on a table that moves. A step calls these functions often, so that they would take much room if
/// they were inlined.
impl<T: Real, L: Dynamics<T> + ?Sized> System<T, COORDINATES> for PhaseSystem<'_, T, L> {
    #[inline(never)]
    fn rates(&self, u: &[T; COORDINATES]) -> [T; COORDINATES] {
        self.all_rates(&Coordinates::from_array(u))
    }

    #[inline(never)]
    fn scale(&self, u: &[T; COORDINATES]) -> [T; COORDINATES] {
        self.scales(&Coordinates::from_array(u)).into_array()
    }
}

/// The coordinates that can change on a table at rest.
impl<T: Real, L: Dynamics<T> + ?Sized> System<T, COORDINATES_AT_REST> for PhaseSystem<'_, T, L> {
    const IGNORABLE: usize = IGNORABLE;

    #[inline(always)]
    fn rates(&self, u: &[T; COORDINATES_AT_REST]) -> [T; COORDINATES_AT_REST] {
        leading(&self.all_rates(&Coordinates::from_first(u)))
    }

    #[inline(always)]
    fn scale(&self, u: &[T; COORDINATES_AT_REST]) -> [T; COORDINATES_AT_REST] {
        leading(&self.scales(&Coordinates::from_first(u)).into_array())
    }
}

/// The coordinates that describe the body's position and rotation, under a law that
/// [changes no others](Dynamics::is_conservative).
impl<T: Real, L: Dynamics<T> + ?Sized> System<T, RIGID_COORDINATES> for PhaseSystem<'_, T, L> {
    const IGNORABLE: usize = IGNORABLE;

    #[inline(always)]
    fn rates(&self, u: &[T; RIGID_COORDINATES]) -> [T; RIGID_COORDINATES] {
        leading(
            &self
                .dynamics
                .rates(&Coordinates::from_first(u))
                .into_array(),
        )
    }

    #[inline(always)]
    fn scale(&self, u: &[T; RIGID_COORDINATES]) -> [T; RIGID_COORDINATES] {
        leading(&self.scales(&Coordinates::from_first(u)).into_array())
    }
}

/// The floors of error scales on a table that moves, relative to natural units.
const FLOOR: f64 = 1e-3;

/// The error of a step in the direction of a dry slip on a table that moves (rad) that is due to rounding.
const ROUNDING: f64 = 1e-14;

/// What is added to the error scales of the rates of rotation on a table that moves, rad/s.
pub(super) fn rate_floor<T: Real>(k: &Parameters<T>) -> T {
    T::from(FLOOR) * (k.g / k.r).sqrt()
}

/// The first N coordinates.
#[inline(always)]
pub(super) fn leading<T: Copy, const N: usize>(coordinates: &[T; COORDINATES]) -> [T; N] {
    core::array::from_fn(|i| coordinates[i])
}
