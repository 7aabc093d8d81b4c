//! What is carried along of a fall while its contact stays the same: of the coordinates only those that
//! the outcome needs. First come those that the law feels; the rest is summed up on the way.

use crate::law::{Coulomb, Frictionless, Law, NoSlip, Parameters, Sliding};
use crate::real::Real;
use crate::state::Coordinates;

/// A way of meeting the table, by the coordinates that it carries.
pub(super) trait Carried<T: Real, const N: usize> {
    /// How many coordinates, the first, the rates depend on.
    const FELT: usize;

    /// For one body under one gravity; `friction` is what holds or slows the rim, if anything does.
    fn new(k: Parameters<T>, friction: T) -> Self;

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

/// √(g/R): the rate of falling, a yardstick for rates.
fn falling_rate<T: Real>(k: &Parameters<T>) -> T {
    (k.g / k.r).sqrt()
}

const NEVER_ZERO: f64 = 1e-200;

/// A rate (rad/s) to compare the tilt rate with.
#[inline(always)]
pub(super) fn tilt_rate_size<T: Real>(u: &Coordinates<T>, falling_rate: T) -> T {
    u.p.abs() + u.w.abs() + u.sin * falling_rate
}

/// Sizes as [`Mechanics`](crate::motion) has them, of all but slip and losses.
#[inline(always)]
fn sizes<T: Real>(u: &Coordinates<T>, falling_rate: T, per_falling_rate: T) -> Coordinates<T> {
    let (one, never_zero) = (T::from(1.0), T::from(NEVER_ZERO));
    Coordinates {
        yaw: one,
        t: per_falling_rate,
        sin: u.sin + never_zero,
        cos: one,
        p: tilt_rate_size(u, falling_rate),
        w: u.w.abs() + u.sin * u.s.abs() + never_zero,
        s: u.s.abs() + u.sin * u.w.abs() + never_zero,
        ..Coordinates::zero()
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
    falling_rate: T,
    per_falling_rate: T,
}

impl<T: Real, const DRY: bool> Carried<T, 7> for Rolling<T, DRY> {
    const FELT: usize = 5;

    fn new(k: Parameters<T>, static_friction: T) -> Self {
        let falling_rate = falling_rate(&k);
        Rolling {
            law: NoSlip::new(k),
            static_friction_squared: static_friction * static_friction,
            falling_rate,
            per_falling_rate: T::from(1.0) / falling_rate,
        }
    }

    carries!(sin, cos, p, w, s, yaw, t; 7);

    #[inline(always)]
    fn rates(&self, u: &[T; 7]) -> [T; 7] {
        <Self as Carried<T, 7>>::of(&self.law.rates_but_place(&Self::all(u)))
    }

    #[inline(always)]
    fn sizes(&self, u: &[T; 7]) -> [T; 7] {
        Self::of(&sizes(
            &Self::all(u),
            self.falling_rate,
            self.per_falling_rate,
        ))
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
    falling_rate: T,
    per_falling_rate: T,
}

impl<T: Real> Carried<T, 7> for Gliding<T> {
    const FELT: usize = 4;

    fn new(k: Parameters<T>, _friction: T) -> Self {
        let falling_rate = falling_rate(&k);
        Gliding {
            law: Frictionless::new(k),
            falling_rate,
            per_falling_rate: T::from(1.0) / falling_rate,
        }
    }

    carries!(sin, cos, p, w, s, yaw, t; 7);

    #[inline(always)]
    fn rates(&self, u: &[T; 7]) -> [T; 7] {
        Self::of(&self.law.rates_but_place(&Self::all(u)))
    }

    #[inline(always)]
    fn sizes(&self, u: &[T; 7]) -> [T; 7] {
        Self::of(&sizes(
            &Self::all(u),
            self.falling_rate,
            self.per_falling_rate,
        ))
    }

    #[inline(always)]
    fn holds(&self, u: &[T; 7]) -> T {
        self.law.contact(&Self::all(u)).normal
    }
}

/// Sliding under dry friction, by a clock that slows down with the slip.
pub(super) struct Slipping<T> {
    law: Sliding<T, Coulomb<T>>,
    falling_rate: T,
    per_falling_rate: T,
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
        let least = |a: T, b: T| -(-a).max(-b);
        least(pushed, least(contact.normal, self.law.inertia(&u, &pull)))
    }

    /// The solver's clock goes as fast as τ times the speed of the slip over this, m/s. How slow is slow
    /// need be known but roughly, and without a root.
    #[inline(always)]
    fn slowed(&self, u: &Coordinates<T>) -> T {
        // A slip this slow, beside the other velocities, is about to end.
        const SLOW: f64 = 0.1;
        let k = self.law.parameters();
        let fall = u.sin * self.falling_rate;
        let rates_squared = u.p * u.p + u.w * u.w + fall * fall;
        speed(u) + T::from(SLOW) * k.r * self.per_falling_rate * rates_squared
    }

    /// How fast the solver's clock goes, as a part of τ.
    #[inline(always)]
    pub(super) fn clock(&self, u: &Coordinates<T>) -> T {
        speed(u) / self.slowed(u)
    }
}

/// Of slip, m/s.
#[inline(always)]
fn speed<T: Real>(u: &Coordinates<T>) -> T {
    (u.slip_x * u.slip_x + u.slip_y * u.slip_y).sqrt()
}

impl<T: Real> Carried<T, 10> for Slipping<T> {
    const FELT: usize = 7;

    fn new(k: Parameters<T>, friction: T) -> Self {
        let falling_rate = falling_rate(&k);
        Slipping {
            law: Sliding::new(k, Coulomb { friction }),
            falling_rate,
            per_falling_rate: T::from(1.0) / falling_rate,
        }
    }

    // The root of the slip's speed is what takes longest, and so it is begun first.
    carries!(slip_x, slip_y, p, w, sin, cos, s, yaw, t, friction_loss; 10);

    #[inline(always)]
    fn rates(&self, u: &[T; 10]) -> [T; 10] {
        let u = Self::all(u);
        let pull = self.law.pull(&u);
        // One division for the clock and for the law.
        let (inertia, slowed) = (self.law.inertia(&u, &pull), self.slowed(&u));
        let per_both = T::from(1.0) / (inertia * slowed);
        let clock = speed(&u) * (inertia * per_both);
        let (_, rates) = self.law.moving(&u, &pull, slowed * per_both);
        Self::of(&rates).map(|rate| clock * rate)
    }

    /// While the rim slips, friction across e_x1 turns what is lost in sideways slip into w and s, and
    /// errors of the three count alike: a slip so slow that its direction follows the forces at once need
    /// not be known as well as the forces are.
    #[inline(always)]
    fn sizes(&self, u: &[T; 10]) -> [T; 10] {
        // Well below what counts as stopped, a tenth of the tolerance.
        const SLOW: f64 = 1e-2;
        let k = self.law.parameters();
        let u = Self::all(u);
        let sizes = sizes(&u, self.falling_rate, self.per_falling_rate);
        let tilting = sizes.p;
        let fallen = self.falling_rate * self.falling_rate;
        Self::of(&Coordinates {
            s: u.s.abs() + u.w.abs() + T::from(NEVER_ZERO),
            slip_x: speed(&u) + T::from(SLOW) * k.r * tilting,
            slip_y: u.slip_y.abs() + k.r * sizes.w,
            friction_loss: k.m * k.r * k.r * (tilting * tilting + u.s * u.s + u.sin * fallen),
            ..sizes
        })
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

    /// As [`Stopping`](crate::motion) has it, without its divisions.
    #[inline(always)]
    fn slips_on(&self, u: &[T; 10], rates: &[T; 10], tolerance: f64) -> T {
        let k = self.law.parameters();
        let (u, rates) = (Self::all(u), Self::all(rates));
        let speed = speed(&u);
        let stopping = -(rates.slip_x * u.slip_x + rates.slip_y * u.slip_y);
        let turning = (rates.slip_x * u.slip_y - rates.slip_y * u.slip_x).abs();
        let rate = u.p.abs() + u.w.abs() + u.s.abs() + self.falling_rate;
        let change = speed * speed * self.clock(&u) * rate;
        let sideways = k.r * (u.w.abs() + u.sin * u.s.abs());
        let brief = T::from((0.1 * tolerance).sqrt()) * stopping - change;
        let straight = T::from(0.1 * tolerance) * sideways * stopping - speed * turning;
        (-brief).max(-straight)
    }
}
