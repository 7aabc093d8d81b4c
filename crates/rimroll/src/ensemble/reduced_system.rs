//! What is carried along of a fall while its contact stays the same: of the coordinates only those that
//! the outcome needs. First come those that the law feels; the rest is summed up on the way.

use crate::error_scale::{ErrorScale, slip_speed};
use crate::law::{
    Coulomb, Dynamics, Frictionless, NoSlip, Parameters, Sliding, SlidingDry, SundmanScaling,
};
use crate::real::Real;
use crate::state::Coordinates;

/// A way of meeting the table, by the coordinates that it carries.
pub(super) trait ReducedSystem<T: Real, const N: usize> {
    /// How many coordinates, the first, the rates depend on.
    const ESSENTIAL: usize;

    /// For one body under one gravity; `friction` is what holds or slows the rim, if anything does.
    fn new(k: Parameters<T>, friction: T) -> Self;

    /// The same for other numbers.
    type With<U: Real>: ReducedSystem<U, N>;

    /// The law in another number type.
    fn with_numbers<U: Real>(&self, f: impl Fn(&T) -> U) -> Self::With<U>;

    /// Writes each number of the body and its friction into its counterpart.
    fn write_to<U: Real>(&self, to: &mut Self::With<U>, f: impl Fn(&T, &mut U));

    /// The coordinates that are carried, out of all.
    fn project(u: &Coordinates<T>) -> [T; N];

    /// All coordinates, those not carried being 0.
    fn expand(u: &[T; N]) -> Coordinates<T>;

    /// Rates by the solver's clock.
    fn rates(&self, u: &[T; N]) -> [T; N];

    /// For each coordinate the size that an error is compared with.
    fn scales(&self, u: &[T; N]) -> [T; N];

    /// Positive as long as the contact lasts as it is.
    fn contact_margin(&self, u: &[T; N]) -> T;

    /// Not negative before what is left of a slip can go at the rate at which it stops, to within the
    /// tolerance.
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

/// Rolling; where friction is dry (`DRY`), as long as it holds the rim.
pub(super) struct ReducedNoSlip<T, const DRY: bool> {
    law: NoSlip<T>,
    /// μ_s².
    static_friction_squared: T,
    error_scale: ErrorScale<T>,
}

impl<T: Real, const DRY: bool> ReducedSystem<T, 7> for ReducedNoSlip<T, DRY> {
    const ESSENTIAL: usize = 5;

    fn new(k: Parameters<T>, static_friction: T) -> Self {
        ReducedNoSlip {
            error_scale: ErrorScale::new(&k),
            law: NoSlip::new(k),
            static_friction_squared: static_friction * static_friction,
        }
    }

    type With<U: Real> = ReducedNoSlip<U, DRY>;

    #[inline(always)]
    fn with_numbers<U: Real>(&self, f: impl Fn(&T) -> U) -> ReducedNoSlip<U, DRY> {
        ReducedNoSlip {
            law: self.law.map(&f),
            static_friction_squared: f(&self.static_friction_squared),
            error_scale: self.error_scale.map(&f),
        }
    }

    #[inline(always)]
    fn write_to<U: Real>(&self, to: &mut ReducedNoSlip<U, DRY>, f: impl Fn(&T, &mut U)) {
        self.law.write(&mut to.law, &f);
        f(
            &self.static_friction_squared,
            &mut to.static_friction_squared,
        );
        self.error_scale.write(&mut to.error_scale, &f);
    }

    reduces_to!(sin, cos, p, w, s, yaw, t; 7);

    #[inline(always)]
    fn rates(&self, u: &[T; 7]) -> [T; 7] {
        <Self as ReducedSystem<T, 7>>::project(&self.law.reduced_rates(&Self::expand(u)))
    }

    #[inline(always)]
    fn scales(&self, u: &[T; 7]) -> [T; 7] {
        Self::project(&self.error_scale.scales(&Self::expand(u)))
    }

    /// N sin φ; under dry friction μ_s² N² − T², as long as that is less, times sin² φ.
    #[inline(always)]
    fn contact_margin(&self, u: &[T; 7]) -> T {
        let contact = self.law.contact(&Self::expand(u));
        if !DRY {
            return contact.normal;
        }
        let held = self.static_friction_squared * contact.normal * contact.normal;
        let needed = contact.along * contact.along + contact.across * contact.across;
        contact.normal.where_negative(contact.normal, held - needed)
    }
}

/// Sliding without friction, which changes no spin.
pub(super) struct ReducedFrictionless<T> {
    law: Frictionless<T>,
    error_scale: ErrorScale<T>,
}

impl<T: Real> ReducedSystem<T, 7> for ReducedFrictionless<T> {
    const ESSENTIAL: usize = 4;

    fn new(k: Parameters<T>, _friction: T) -> Self {
        ReducedFrictionless {
            error_scale: ErrorScale::new(&k),
            law: Frictionless::new(k),
        }
    }

    type With<U: Real> = ReducedFrictionless<U>;

    #[inline(always)]
    fn with_numbers<U: Real>(&self, f: impl Fn(&T) -> U) -> ReducedFrictionless<U> {
        ReducedFrictionless {
            law: self.law.map(&f),
            error_scale: self.error_scale.map(&f),
        }
    }

    #[inline(always)]
    fn write_to<U: Real>(&self, to: &mut ReducedFrictionless<U>, f: impl Fn(&T, &mut U)) {
        self.law.write(&mut to.law, &f);
        self.error_scale.write(&mut to.error_scale, &f);
    }

    reduces_to!(sin, cos, p, w, s, yaw, t; 7);

    #[inline(always)]
    fn rates(&self, u: &[T; 7]) -> [T; 7] {
        Self::project(&self.law.reduced_rates(&Self::expand(u)))
    }

    #[inline(always)]
    fn scales(&self, u: &[T; 7]) -> [T; 7] {
        Self::project(&self.error_scale.scales(&Self::expand(u)))
    }

    #[inline(always)]
    fn contact_margin(&self, u: &[T; 7]) -> T {
        self.law.contact(&Self::expand(u)).normal
    }
}

/// Sliding under dry friction, by a clock that slows down with the slip.
#[derive(Clone, Copy)]
pub(super) struct ReducedSliding<T> {
    law: SlidingDry<T>,
    error_scale: ErrorScale<T>,
}

impl<T: Real> ReducedSliding<T> {
    /// Rates by the clock that does not slow down, under friction against a slip in a direction.
    #[inline(always)]
    pub(super) fn rates_against(&self, u: &[T; 10], direction: [T; 2]) -> [T; 10] {
        let friction_force = self.law.friction().against(direction);
        let (_, rates) = self
            .law
            .reduced_rates_under(&Self::expand(u), &friction_force);
        Self::project(&rates)
    }

    /// For a slip in a direction out of rest: negative where nothing presses the rim to the table, where
    /// what does is not determined, or where friction would have to push by more than a rounding error.
    #[inline(always)]
    pub(super) fn can_begin(&self, u: &[T; 10], direction: [T; 2]) -> T {
        // At loose tolerances sin² φ + cos² φ = 1, and with it the laws' agreement on when slip begins, is
        // kept to some 1e-8.
        const ROUNDING: f64 = 1e-6;
        let u = Self::expand(u);
        let friction_force = self.law.friction().against(direction);
        let (contact, rates) = self.law.reduced_rates_under(&u, &friction_force);
        let forward = rates.slip_x * direction[0] + rates.slip_y * direction[1];
        let across = rates.slip_y * direction[0] - rates.slip_x * direction[1];
        let friction = contact.along.abs() + contact.across.abs();
        let size =
            friction * self.law.parameters().sideways_mobility() + forward.abs() + across.abs();
        let pushed = forward + T::from(ROUNDING) * size;
        pushed
            .min(contact.normal)
            .min(self.law.inertia(&u, &friction_force))
    }

    /// What errors are compared with while a slip begins.
    #[inline(always)]
    pub(super) fn scales_at_onset(&self, u: &[T; 10]) -> [T; 10] {
        Self::project(&self.error_scale.scales_at_slip_onset(&Self::expand(u)))
    }

    /// How fast the solver's clock goes, as a part of τ.
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
            law: Sliding::new(k, Coulomb::uniform(friction)),
        }
    }

    type With<U: Real> = ReducedSliding<U>;

    #[inline(always)]
    fn with_numbers<U: Real>(&self, f: impl Fn(&T) -> U) -> ReducedSliding<U> {
        ReducedSliding {
            law: self.law.map(&f),
            error_scale: self.error_scale.map(&f),
        }
    }

    #[inline(always)]
    fn write_to<U: Real>(&self, to: &mut ReducedSliding<U>, f: impl Fn(&T, &mut U)) {
        self.law.write(&mut to.law, &f);
        self.error_scale.write(&mut to.error_scale, &f);
    }

    // The root of the slip's speed is what takes longest, and so it is begun first.
    reduces_to!(slip_x, slip_y, p, w, sin, cos, s, yaw, t, friction_loss; 10);

    #[inline(always)]
    fn rates(&self, u: &[T; 10]) -> [T; 10] {
        let u = Self::expand(u);
        let friction_force = self.law.friction_force(&u);
        // One division for the clock and for the law.
        let (inertia, sundman_denominator) = (
            self.law.inertia(&u, &friction_force),
            self.error_scale.sundman_denominator(&u),
        );
        let per_inertia = slip_speed(&u) / (inertia * sundman_denominator);
        let scaling = SundmanScaling {
            factor: inertia * per_inertia,
            per_inertia,
        };
        Self::project(&self.law.rates_under(&u, &friction_force, scaling).1)
    }

    #[inline(always)]
    fn scales(&self, u: &[T; 10]) -> [T; 10] {
        Self::project(&self.error_scale.scales_in_dry_slip(&Self::expand(u)))
    }

    /// As long as it is determined, N sin φ times what is then positive.
    #[inline(always)]
    fn contact_margin(&self, u: &[T; 10]) -> T {
        // What counts as Painlevé's paradox is less.
        const CLEAR: f64 = 1e-3;
        let u = Self::expand(u);
        let clear = self.law.consistency_margin(&u, T::from(CLEAR));
        clear.where_negative(clear, self.law.scaled_normal_force(&u))
    }

    #[inline(always)]
    fn slip_persists(&self, u: &[T; 10], rates: &[T; 10], tolerance: f64) -> T {
        let (u, rates) = (Self::expand(u), Self::expand(rates));
        self.error_scale
            .slip_persists(&u, &rates, self.sundman_factor(&u), tolerance)
    }
}
