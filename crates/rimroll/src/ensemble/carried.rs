//! What is carried along of a fall while its contact stays the same: of the coordinates only those that
//! the outcome needs. First come those that the law feels; the rest is summed up on the way.

use crate::law::{Coulomb, Frictionless, Law, NoSlip, Pace, Parameters, Sliding, SlidingDry};
use crate::real::Real;
use crate::state::Coordinates;
use crate::yardstick::{Yardstick, slip_speed};

/// A way of meeting the table, by the coordinates that it carries.
pub(super) trait Carried<T: Real, const N: usize> {
    /// How many coordinates, the first, the rates depend on.
    const FELT: usize;

    /// For one body under one gravity; `friction` is what holds or slows the rim, if anything does.
    fn new(k: Parameters<T>, friction: T) -> Self;

    /// The same for other numbers.
    type Like<U: Real>: Carried<U, N>;

    /// The law in another number type.
    fn like<U: Real>(&self, f: impl Fn(&T) -> U) -> Self::Like<U>;

    /// Writes each number of the body and its friction into its counterpart.
    fn write_to<U: Real>(&self, to: &mut Self::Like<U>, f: impl Fn(&T, &mut U));

    /// The coordinates that are carried, out of all.
    fn of(u: &Coordinates<T>) -> [T; N];

    /// All coordinates, those not carried being 0.
    fn all(u: &[T; N]) -> Coordinates<T>;

    /// Rates by the solver's clock.
    fn rates(&self, u: &[T; N]) -> [T; N];

    /// For each coordinate the size that an error is compared with.
    fn sizes(&self, u: &[T; N]) -> [T; N];

    /// Positive as long as the contact lasts as it is.
    fn holds(&self, u: &[T; N]) -> T;

    /// Not negative before what is left of a slip can go at the rate at which it stops, to within the
    /// tolerance.
    #[inline(always)]
    fn slips_on(&self, _u: &[T; N], _rates: &[T; N], _tolerance: f64) -> T {
        T::from(1.0)
    }
}

macro_rules! carries {
    ($($name:ident),*; $n:literal) => {
        #[inline(always)]
        fn of(u: &Coordinates<T>) -> [T; $n] {
            [$(u.$name),*]
        }

        #[inline(always)]
        fn all(u: &[T; $n]) -> Coordinates<T> {
            let [$($name),*] = *u;
            Coordinates { $($name,)* ..Coordinates::zero() }
        }
    };
}

/// Rolling; where friction is dry (`DRY`), as long as it holds the rim.
pub(super) struct Rolling<T, const DRY: bool> {
    law: NoSlip<T>,
    /// μ_s².
    static_friction_squared: T,
    yardstick: Yardstick<T>,
}

impl<T: Real, const DRY: bool> Carried<T, 7> for Rolling<T, DRY> {
    const FELT: usize = 5;

    fn new(k: Parameters<T>, static_friction: T) -> Self {
        Rolling {
            yardstick: Yardstick::new(&k),
            law: NoSlip::new(k),
            static_friction_squared: static_friction * static_friction,
        }
    }

    type Like<U: Real> = Rolling<U, DRY>;

    #[inline(always)]
    fn like<U: Real>(&self, f: impl Fn(&T) -> U) -> Rolling<U, DRY> {
        Rolling {
            law: self.law.map(&f),
            static_friction_squared: f(&self.static_friction_squared),
            yardstick: self.yardstick.map(&f),
        }
    }

    #[inline(always)]
    fn write_to<U: Real>(&self, to: &mut Rolling<U, DRY>, f: impl Fn(&T, &mut U)) {
        self.law.write(&mut to.law, &f);
        f(
            &self.static_friction_squared,
            &mut to.static_friction_squared,
        );
        self.yardstick.write(&mut to.yardstick, &f);
    }

    carries!(sin, cos, p, w, s, yaw, t; 7);

    #[inline(always)]
    fn rates(&self, u: &[T; 7]) -> [T; 7] {
        <Self as Carried<T, 7>>::of(&self.law.rates_but_place(&Self::all(u)))
    }

    #[inline(always)]
    fn sizes(&self, u: &[T; 7]) -> [T; 7] {
        Self::of(&self.yardstick.sizes(&Self::all(u)))
    }

    /// N sin φ; under dry friction μ_s² N² − T², as long as that is less, times sin² φ.
    #[inline(always)]
    fn holds(&self, u: &[T; 7]) -> T {
        let contact = self.law.contact(&Self::all(u));
        if !DRY {
            return contact.normal;
        }
        let held = self.static_friction_squared * contact.normal * contact.normal;
        let needed = contact.along * contact.along + contact.across * contact.across;
        contact.normal.where_negative(contact.normal, held - needed)
    }
}

/// Sliding without friction, which changes no spin.
pub(super) struct Gliding<T> {
    law: Frictionless<T>,
    yardstick: Yardstick<T>,
}

impl<T: Real> Carried<T, 7> for Gliding<T> {
    const FELT: usize = 4;

    fn new(k: Parameters<T>, _friction: T) -> Self {
        Gliding {
            yardstick: Yardstick::new(&k),
            law: Frictionless::new(k),
        }
    }

    type Like<U: Real> = Gliding<U>;

    #[inline(always)]
    fn like<U: Real>(&self, f: impl Fn(&T) -> U) -> Gliding<U> {
        Gliding {
            law: self.law.map(&f),
            yardstick: self.yardstick.map(&f),
        }
    }

    #[inline(always)]
    fn write_to<U: Real>(&self, to: &mut Gliding<U>, f: impl Fn(&T, &mut U)) {
        self.law.write(&mut to.law, &f);
        self.yardstick.write(&mut to.yardstick, &f);
    }

    carries!(sin, cos, p, w, s, yaw, t; 7);

    #[inline(always)]
    fn rates(&self, u: &[T; 7]) -> [T; 7] {
        Self::of(&self.law.rates_but_place(&Self::all(u)))
    }

    #[inline(always)]
    fn sizes(&self, u: &[T; 7]) -> [T; 7] {
        Self::of(&self.yardstick.sizes(&Self::all(u)))
    }

    #[inline(always)]
    fn holds(&self, u: &[T; 7]) -> T {
        self.law.contact(&Self::all(u)).normal
    }
}

/// Sliding under dry friction, by a clock that slows down with the slip.
#[derive(Clone, Copy)]
pub(super) struct Slipping<T> {
    law: SlidingDry<T>,
    yardstick: Yardstick<T>,
}

impl<T: Real> Slipping<T> {
    /// Rates by the clock that does not slow down, under friction against a slip in a direction.
    #[inline(always)]
    pub(super) fn rates_against(&self, u: &[T; 10], direction: [T; 2]) -> [T; 10] {
        let pull = self.law.friction().against(direction);
        let (_, rates) = self.law.under_but_place(&Self::all(u), &pull);
        Self::of(&rates)
    }

    /// For a slip in a direction out of rest: negative where nothing presses the rim to the table, where
    /// what does is not determined, or where friction would have to push by more than a rounding error.
    #[inline(always)]
    pub(super) fn can_begin(&self, u: &[T; 10], direction: [T; 2]) -> T {
        // At loose tolerances sin² φ + cos² φ = 1, and with it the laws' agreement on when slip begins, is
        // kept to some 1e-8.
        const ROUNDING: f64 = 1e-6;
        let u = Self::all(u);
        let pull = self.law.friction().against(direction);
        let (contact, rates) = self.law.under_but_place(&u, &pull);
        let forward = rates.slip_x * direction[0] + rates.slip_y * direction[1];
        let across = rates.slip_y * direction[0] - rates.slip_x * direction[1];
        let friction = contact.along.abs() + contact.across.abs();
        let size =
            friction * self.law.parameters().sideways_mobility() + forward.abs() + across.abs();
        let pushed = forward + T::from(ROUNDING) * size;
        pushed.min(contact.normal).min(self.law.inertia(&u, &pull))
    }

    /// What errors are compared with while a slip begins.
    #[inline(always)]
    pub(super) fn sizes_as_it_begins(&self, u: &[T; 10]) -> [T; 10] {
        Self::of(&self.yardstick.sizes_as_dry_slip_begins(&Self::all(u)))
    }

    /// How fast the solver's clock goes, as a part of τ.
    #[inline(always)]
    pub(super) fn clock(&self, u: &Coordinates<T>) -> T {
        self.yardstick.clock(u)
    }
}

impl<T: Real> Carried<T, 10> for Slipping<T> {
    const FELT: usize = 7;

    fn new(k: Parameters<T>, friction: T) -> Self {
        Slipping {
            yardstick: Yardstick::new(&k),
            law: Sliding::new(k, Coulomb { friction }),
        }
    }

    type Like<U: Real> = Slipping<U>;

    #[inline(always)]
    fn like<U: Real>(&self, f: impl Fn(&T) -> U) -> Slipping<U> {
        Slipping {
            law: self.law.map(&f),
            yardstick: self.yardstick.map(&f),
        }
    }

    #[inline(always)]
    fn write_to<U: Real>(&self, to: &mut Slipping<U>, f: impl Fn(&T, &mut U)) {
        self.law.write(&mut to.law, &f);
        self.yardstick.write(&mut to.yardstick, &f);
    }

    // The root of the slip's speed is what takes longest, and so it is begun first.
    carries!(slip_x, slip_y, p, w, sin, cos, s, yaw, t, friction_loss; 10);

    #[inline(always)]
    fn rates(&self, u: &[T; 10]) -> [T; 10] {
        let u = Self::all(u);
        let pull = self.law.pull(&u);
        // One division for the clock and for the law.
        let (inertia, slowed) = (self.law.inertia(&u, &pull), self.yardstick.slowed(&u));
        let per_inertia = slip_speed(&u) / (inertia * slowed);
        let pace = Pace {
            clock: inertia * per_inertia,
            per_inertia,
        };
        Self::of(&self.law.moving(&u, &pull, pace).1)
    }

    #[inline(always)]
    fn sizes(&self, u: &[T; 10]) -> [T; 10] {
        Self::of(&self.yardstick.sizes_in_dry_slip(&Self::all(u)))
    }

    /// As long as it is determined, N sin φ times what is then positive.
    #[inline(always)]
    fn holds(&self, u: &[T; 10]) -> T {
        // What counts as Painlevé's paradox is less.
        const CLEAR: f64 = 1e-3;
        let u = Self::all(u);
        let clear = self.law.clearance(&u, T::from(CLEAR));
        clear.where_negative(clear, self.law.pressing(&u))
    }

    #[inline(always)]
    fn slips_on(&self, u: &[T; 10], rates: &[T; 10], tolerance: f64) -> T {
        let (u, rates) = (Self::all(u), Self::all(rates));
        self.yardstick
            .slips_on(&u, &rates, self.clock(&u), tolerance)
    }
}
