//! The mechanics of one phase as the solver sees it.

use crate::law::Law;
use crate::real::Real;
use crate::solve::System;
use crate::state::{COORDINATES, Coordinates, MOVING, UNFELT};

/// A law, and the sizes that errors are compared with.
pub(super) struct Mechanics<'a, T = f64, L: ?Sized = dyn Law<T> + 'a> {
    pub law: &'a L,
    mass: T,
    radius: T,
    /// √(g/R): the rate of falling, a yardstick for rates.
    pub falling_rate: T,
    slows_with_slip: bool,
}

impl<'a, T: Real, L: Law<T> + ?Sized> Mechanics<'a, T, L> {
    pub(super) fn new(law: &'a L) -> Self {
        let k = law.parameters();
        Mechanics {
            law,
            mass: k.m,
            radius: k.r,
            falling_rate: (k.g / k.r).sqrt(),
            slows_with_slip: false,
        }
    }

    /// For dry friction, whose direction changes at a rate that grows like 1/|u| as the slip ends: a
    /// clock that slows down with the slip makes the end as smooth as the rest.
    pub(super) fn slowing_with_slip(law: &'a L) -> Self {
        Mechanics {
            slows_with_slip: true,
            ..Mechanics::new(law)
        }
    }

    /// How fast the solver's clock goes, as a part of τ.
    #[inline(always)]
    pub(super) fn clock(&self, u: &Coordinates<T>) -> T {
        // A slip this slow, beside the other velocities, is about to end.
        const SLOW: f64 = 0.05;
        if !self.slows_with_slip {
            return T::from(1.0);
        }
        let fall = u.sin * self.falling_rate;
        let speed = speed(u);
        let slow = T::from(SLOW) * self.radius * (u.p * u.p + u.w * u.w + fall * fall).sqrt();
        speed / (speed + slow)
    }

    /// A speed (m/s) to compare sideways slip with: what w and s, which are held to their own sizes,
    /// make of it.
    pub(super) fn sideways_speed(&self, u: &Coordinates<T>) -> T {
        self.radius * (u.w.abs() + u.sin * u.s.abs())
    }

    /// A rate (rad/s) to compare the tilt rate with.
    #[inline(always)]
    pub(super) fn tilt_rate_scale(&self, u: &Coordinates<T>) -> T {
        u.p.abs() + u.w.abs() + u.sin * self.falling_rate
    }
}

/// Of slip, m/s.
#[inline(always)]
fn speed<T: Real>(u: &Coordinates<T>) -> T {
    (u.slip_x * u.slip_x + u.slip_y * u.slip_y).sqrt()
}

impl<T: Real, L: Law<T> + ?Sized> Mechanics<'_, T, L> {
    /// w and s obey linear equations and pass through the tipping phase as small as the start made
    /// them, to become large in the collision; so each is held to its own size, with a floor of what
    /// the other one feeds into it. sin φ is held to its own size for the same reason. The slip
    /// across e_x1 feeds w and is fed by it: an error of the one is as good as one of the other. A slow
    /// slip is about to begin or to end, and its direction matters less the slower it is.
    #[inline(always)]
    fn sizes(&self, u: &Coordinates<T>) -> Coordinates<T> {
        const NEVER_ZERO: f64 = 1e-200;
        // Well below what counts as stopped, a tenth of the tolerance.
        const SLOW: f64 = 1e-2;
        const SMALL_GAP: f64 = 1e-6;
        let never_zero = T::from(NEVER_ZERO);
        let (one, small_gap) = (T::from(1.0), T::from(SMALL_GAP));
        let tilting = self.tilt_rate_scale(u);
        let speed = speed(u) + T::from(SLOW) * self.radius * tilting;
        let sideways = u.w.abs() + u.sin * u.s.abs();
        let fallen = self.falling_rate * self.falling_rate;
        let away = self.radius + u.x1.abs() + u.y1.abs();
        let energy = self.mass
            * self.radius
            * self.radius
            * (tilting * tilting + u.s * u.s + u.sin * fallen);
        Coordinates {
            yaw: one,
            spin: one,
            t: one / self.falling_rate,
            sin: u.sin + never_zero,
            cos: one,
            p: tilting,
            w: sideways + never_zero,
            s: u.s.abs() + u.sin * u.w.abs() + never_zero,
            x1: away,
            y1: away,
            slip_x: speed,
            slip_y: u.slip_y.abs() + speed * sideways / tilting + never_zero,
            gap: u.gap.abs() + small_gap * self.radius,
            gap_rate: u.gap_rate.abs() + small_gap * self.radius * self.falling_rate,
            friction_loss: energy,
            resistance_loss: energy,
            impact_loss: energy,
        }
    }
}

/// Every coordinate.
impl<T: Real, L: Law<T> + ?Sized> System<T, COORDINATES> for Mechanics<'_, T, L> {
    const UNFELT: usize = UNFELT;

    #[inline(always)]
    fn rates(&self, u: &[T; COORDINATES]) -> [T; COORDINATES] {
        let u = Coordinates::from_array(u);
        let rates = self.law.rates(&u).into_array();
        if !self.slows_with_slip {
            return rates;
        }
        let clock = self.clock(&u);
        rates.map(|rate| clock * rate)
    }

    #[inline(always)]
    fn scale(&self, u: &[T; COORDINATES]) -> [T; COORDINATES] {
        self.sizes(&Coordinates::from_array(u)).into_array()
    }
}

/// Those that say where the body is and how it turns, under a law by which
/// [only they change](Law::only_moves).
impl<T: Real, L: Law<T> + ?Sized> System<T, MOVING> for Mechanics<'_, T, L> {
    const UNFELT: usize = UNFELT;

    #[inline(always)]
    fn rates(&self, u: &[T; MOVING]) -> [T; MOVING] {
        first(&self.law.rates(&Coordinates::from_first(u)).into_array())
    }

    #[inline(always)]
    fn scale(&self, u: &[T; MOVING]) -> [T; MOVING] {
        first(&self.sizes(&Coordinates::from_first(u)).into_array())
    }
}

/// The first of them.
#[inline(always)]
pub(super) fn first<T: Copy, const N: usize>(all: &[T; COORDINATES]) -> [T; N] {
    core::array::from_fn(|i| all[i])
}
