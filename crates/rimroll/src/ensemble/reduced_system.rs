//! The reduced systems of a batch. Each holds the equations of one phase in the coordinates on which the
//! outcome depends. The coordinates that enter the rates come first; the ignorable ones follow.

use crate::error_scale::{ErrorScale, slip_speed};
use crate::law::{
    Coulomb, Dynamics, Frictionless, NoSlip, Parameters, Sliding, SlidingDry, SundmanScaling,
};
use crate::motion::slip_onset::{ROUNDING, along_and_across};
use crate::real::Real;
use crate::state::Coordinates;

/// The equations of one phase in N reduced coordinates.
pub(super) trait ReducedSystem<T: Real, const N: usize> {
    /// The number of leading coordinates on which the rates depend.
    const ESSENTIAL: usize;

    /// The system for one body under one gravity. `friction` is the coefficient of static friction while the
    /// rim rolls, that of kinetic friction while it slides, and unused under an ideal law.
    fn new(k: Parameters<T>, friction: T) -> Self;

    /// This system over another number type.
    type With<U: Real>: ReducedSystem<U, N>;

    /// Converts the parameters to another number type.
    fn with_numbers<U: Real>(&self, f: impl Fn(&T) -> U) -> Self::With<U>;

    /// Writes each parameter of the body and its friction into its counterpart.
    fn write_to<U: Real>(&self, to: &mut Self::With<U>, f: impl Fn(&T, &mut U));

    /// The reduced coordinates.
    fn project(u: &Coordinates<T>) -> [T; N];

    /// All coordinates, with 0 for those that the reduced system lacks.
    fn expand(u: &[T; N]) -> Coordinates<T>;

    /// Rates with respect to the independent variable of the phase: τ, or σ in dry slip.
    fn rates(&self, u: &[T; N]) -> [T; N];

    /// The error scales of the coordinates.
    fn scales(&self, u: &[T; N]) -> [T; N];

    /// An event function that is positive while the contact condition of the phase holds.
    fn contact_margin(&self, u: &[T; N]) -> T;

    /// An event function that is negative where a slip is about to stop: its deceleration is then constant
    /// within the tolerance.
    #[inline(always)]
    fn slip_persists(&self, _u: &[T; N], _rates: &[T; N], _tolerance: f64) -> T {
        T::from(1.0)
    }
}

macro_rules! reduces_to {
    ($($name:ident),*; $n:literal) => {
        #[inline(always)]
        fn project(u: &Coordinates<T>) -> [T; $n] {
            [$(u.$name),*]
        }

        #[inline(always)]
        fn expand(u: &[T; $n]) -> Coordinates<T> {
            let [$($name),*] = *u;
            Coordinates { $($name,)* ..Coordinates::zero() }
        }
    };
}

/// Rolling without slip, with unlimited friction or, if `DRY`, with dry static friction.
pub(super) struct ReducedNoSlip<T, const DRY: bool> {
    dynamics: NoSlip<T>,
    /// μ_s².
    static_friction_squared: T,
    error_scale: ErrorScale<T>,
}

impl<T: Real, const DRY: bool> ReducedSystem<T, 7> for ReducedNoSlip<T, DRY> {
    const ESSENTIAL: usize = 5;

    fn new(k: Parameters<T>, static_friction: T) -> Self {
        ReducedNoSlip {
            error_scale: ErrorScale::new(&k),
            dynamics: NoSlip::new(k),
            static_friction_squared: static_friction * static_friction,
        }
    }

    type With<U: Real> = ReducedNoSlip<U, DRY>;

    #[inline(always)]
    fn with_numbers<U: Real>(&self, f: impl Fn(&T) -> U) -> ReducedNoSlip<U, DRY> {
        ReducedNoSlip {
            dynamics: self.dynamics.map(&f),
            static_friction_squared: f(&self.static_friction_squared),
            error_scale: self.error_scale.map(&f),
        }
    }

    #[inline(always)]
    fn write_to<U: Real>(&self, to: &mut ReducedNoSlip<U, DRY>, f: impl Fn(&T, &mut U)) {
        self.dynamics.write(&mut to.dynamics, &f);
        f(
            &self.static_friction_squared,
            &mut to.static_friction_squared,
        );
        self.error_scale.write(&mut to.error_scale, &f);
    }

    reduces_to!(sin, cos, p, w, s, yaw, t; 7);

    #[inline(always)]
    fn rates(&self, u: &[T; 7]) -> [T; 7] {
        <Self as ReducedSystem<T, 7>>::project(&self.dynamics.reduced_rates(&Self::expand(u)))
    }

    #[inline(always)]
    fn scales(&self, u: &[T; 7]) -> [T; 7] {
        Self::project(&self.error_scale.scales(&Self::expand(u)))
    }

    /// N sin φ, or, under dry friction, (μ_s² N |N| − T²) sin² φ. A margin that were N itself where N is negative
    /// would have a false root where N is 0.
    #[inline(always)]
    fn contact_margin(&self, u: &[T; 7]) -> T {
        let contact = self.dynamics.contact(&Self::expand(u));
        if !DRY {
            return contact.normal;
        }
        let available = self.static_friction_squared * contact.normal * contact.normal.abs();
        let needed = contact.along * contact.along + contact.across * contact.across;
        available - needed
    }
}

/// Sliding without friction. The axial spin is constant.
pub(super) struct ReducedFrictionless<T> {
    dynamics: Frictionless<T>,
    error_scale: ErrorScale<T>,
}

impl<T: Real> ReducedSystem<T, 7> for ReducedFrictionless<T> {
    const ESSENTIAL: usize = 4;

    fn new(k: Parameters<T>, _friction: T) -> Self {
        ReducedFrictionless {
            error_scale: ErrorScale::new(&k),
            dynamics: Frictionless::new(k),
        }
    }

    type With<U: Real> = ReducedFrictionless<U>;

    #[inline(always)]
    fn with_numbers<U: Real>(&self, f: impl Fn(&T) -> U) -> ReducedFrictionless<U> {
        ReducedFrictionless {
            dynamics: self.dynamics.map(&f),
            error_scale: self.error_scale.map(&f),
        }
    }

    #[inline(always)]
    fn write_to<U: Real>(&self, to: &mut ReducedFrictionless<U>, f: impl Fn(&T, &mut U)) {
        self.dynamics.write(&mut to.dynamics, &f);
        self.error_scale.write(&mut to.error_scale, &f);
    }

    reduces_to!(sin, cos, p, w, s, yaw, t; 7);

    #[inline(always)]
    fn rates(&self, u: &[T; 7]) -> [T; 7] {
        Self::project(&self.dynamics.reduced_rates(&Self::expand(u)))
    }

    #[inline(always)]
    fn scales(&self, u: &[T; 7]) -> [T; 7] {
        Self::project(&self.error_scale.scales(&Self::expand(u)))
    }

    #[inline(always)]
    fn contact_margin(&self, u: &[T; 7]) -> T {
        self.dynamics.contact(&Self::expand(u)).normal
    }
}

/// Sliding under dry friction. The independent variable is σ of the Sundman time transformation
/// ([`ErrorScale::sundman_factor`]).
#[derive(Clone, Copy)]
pub(super) struct ReducedSliding<T> {
    dynamics: SlidingDry<T>,
    error_scale: ErrorScale<T>,
}

impl<T: Real> ReducedSliding<T> {
    /// Rates with respect to τ, with the friction that opposes a slip in this direction (unit vector).
    #[inline(always)]
    pub(super) fn rates_against(&self, u: &[T; 10], direction: [T; 2]) -> [T; 10] {
        let friction_force = self.dynamics.friction().against(direction);
        let (_, rates) = self
            .dynamics
            .reduced_rates_under(&Self::expand(u), &friction_force);
        Self::project(&rates)
    }

    /// Whether slip can start from rest in this direction (unit vector). The result is negative if the normal
    /// force is negative or not determined, or if the slip would decelerate by more than a rounding error.
    #[inline(always)]
    pub(super) fn can_begin(&self, u: &[T; 10], direction: [T; 2]) -> T {
        let u = Self::expand(u);
        let friction_force = self.dynamics.friction().against(direction);
        let (contact, rates) = self.dynamics.reduced_rates_under(&u, &friction_force);
        let [along, across] = along_and_across([rates.slip_x, rates.slip_y], direction);
        let friction = contact.along.abs() + contact.across.abs();
        let scale =
            friction * self.dynamics.parameters().sideways_mobility() + along.abs() + across.abs();
        let acceleration = along + T::from(ROUNDING) * scale;
        acceleration
            .min(contact.normal)
            .min(self.dynamics.inertia(&u, &friction_force))
    }

    /// The error scales while a slip begins.
    #[inline(always)]
    pub(super) fn scales_at_onset(&self, u: &[T; 10]) -> [T; 10] {
        Self::project(&self.error_scale.scales_at_slip_onset(&Self::expand(u)))
    }

    /// dτ/dσ.
    #[inline(always)]
    pub(super) fn sundman_factor(&self, u: &Coordinates<T>) -> T {
        self.error_scale.sundman_factor(u)
    }
}

impl<T: Real> ReducedSystem<T, 10> for ReducedSliding<T> {
    const ESSENTIAL: usize = 7;

    fn new(k: Parameters<T>, friction: T) -> Self {
        ReducedSliding {
            error_scale: ErrorScale::new(&k),
            dynamics: Sliding::new(k, Coulomb::uniform(friction)),
        }
    }

    type With<U: Real> = ReducedSliding<U>;

    #[inline(always)]
    fn with_numbers<U: Real>(&self, f: impl Fn(&T) -> U) -> ReducedSliding<U> {
        ReducedSliding {
            dynamics: self.dynamics.map(&f),
            error_scale: self.error_scale.map(&f),
        }
    }

    #[inline(always)]
    fn write_to<U: Real>(&self, to: &mut ReducedSliding<U>, f: impl Fn(&T, &mut U)) {
        self.dynamics.write(&mut to.dynamics, &f);
        self.error_scale.write(&mut to.error_scale, &f);
    }

    // The square root of the slip speed has the longest latency, so the slip comes first.
    reduces_to!(slip_x, slip_y, p, w, sin, cos, s, yaw, t, friction_loss; 10);

    #[inline(always)]
    fn rates(&self, u: &[T; 10]) -> [T; 10] {
        let u = Self::expand(u);
        let friction_force = self.dynamics.friction_force(&u);
        // The Sundman factor and the equations of motion share one division.
        let (inertia, sundman_denominator) = (
            self.dynamics.inertia(&u, &friction_force),
            self.error_scale.sundman_denominator(&u),
        );
        let per_inertia = slip_speed(&u) / (inertia * sundman_denominator);
        let scaling = SundmanScaling {
            factor: inertia * per_inertia,
            per_inertia,
        };
        Self::project(&self.dynamics.rates_under(&u, &friction_force, scaling).1)
    }

    #[inline(always)]
    fn scales(&self, u: &[T; 10]) -> [T; 10] {
        Self::project(&self.error_scale.scales_in_dry_slip(&Self::expand(u)))
    }

    /// The normal force, scaled by a positive factor; negative near the Painlevé paradox.
    #[inline(always)]
    fn contact_margin(&self, u: &[T; 10]) -> T {
        // The scalar solver, which takes over below this consistency, detects the Painlevé paradox at a
        // smaller one.
        const MIN_CONSISTENCY: f64 = 1e-3;
        let u = Self::expand(u);
        let margin = self
            .dynamics
            .consistency_margin(&u, T::from(MIN_CONSISTENCY));
        margin.where_negative(margin, self.dynamics.scaled_normal_force(&u))
    }

    #[inline(always)]
    fn slip_persists(&self, u: &[T; 10], rates: &[T; 10], tolerance: f64) -> T {
        let (u, rates) = (Self::expand(u), Self::expand(rates));
        self.error_scale
            .slip_persists(&u, &rates, self.sundman_factor(&u), tolerance)
    }
}
