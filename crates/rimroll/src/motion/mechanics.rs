//! The mechanics of one phase as the solver sees it.

use crate::error_scale::ErrorScale;
use crate::law::Dynamics;
use crate::real::Real;
use crate::solve::System;
use crate::state::{COORDINATES, Coordinates, IGNORABLE, RIGID_COORDINATES};

/// A law, and the sizes that errors are compared with.
pub(super) struct Mechanics<'a, T = f64, L: ?Sized = dyn Dynamics<T> + 'a> {
    pub law: &'a L,
    pub error_scale: ErrorScale<T>,
    /// Whether it is the law of slip under dry friction.
    dry: bool,
}

impl<'a, T: Real, L: Dynamics<T> + ?Sized> Mechanics<'a, T, L> {
    pub(super) fn new(law: &'a L) -> Self {
        Mechanics {
            law,
            error_scale: ErrorScale::new(law.parameters()),
            dry: false,
        }
    }

    /// For slip under dry friction, by a clock that slows down with it.
    pub(super) fn slipping(law: &'a L) -> Self {
        Mechanics {
            dry: true,
            ..Mechanics::new(law)
        }
    }

    /// How fast the solver's clock goes, as a part of τ.
    #[inline(always)]
    pub(super) fn sundman_factor(&self, u: &Coordinates<T>) -> T {
        if self.dry {
            self.error_scale.sundman_factor(u)
        } else {
            T::from(1.0)
        }
    }

    #[inline(always)]
    fn scales(&self, u: &Coordinates<T>) -> Coordinates<T> {
        if self.dry {
            self.error_scale.scales_in_dry_slip(u)
        } else {
            self.error_scale.scales(u)
        }
    }
}

/// Every coordinate.
impl<T: Real, L: Dynamics<T> + ?Sized> System<T, COORDINATES> for Mechanics<'_, T, L> {
    const IGNORABLE: usize = IGNORABLE;

    #[inline(always)]
    fn rates(&self, u: &[T; COORDINATES]) -> [T; COORDINATES] {
        let u = Coordinates::from_array(u);
        let rates = self.law.rates(&u).into_array();
        if !self.dry {
            return rates;
        }
        let clock = self.sundman_factor(&u);
        rates.map(|rate| clock * rate)
    }

    #[inline(always)]
    fn scale(&self, u: &[T; COORDINATES]) -> [T; COORDINATES] {
        self.scales(&Coordinates::from_array(u)).into_array()
    }
}

/// Those that say where the body is and how it turns, under a law by which
/// [only they change](Dynamics::is_conservative).
impl<T: Real, L: Dynamics<T> + ?Sized> System<T, RIGID_COORDINATES> for Mechanics<'_, T, L> {
    const IGNORABLE: usize = IGNORABLE;

    #[inline(always)]
    fn rates(&self, u: &[T; RIGID_COORDINATES]) -> [T; RIGID_COORDINATES] {
        first(&self.law.rates(&Coordinates::from_first(u)).into_array())
    }

    #[inline(always)]
    fn scale(&self, u: &[T; RIGID_COORDINATES]) -> [T; RIGID_COORDINATES] {
        first(&self.scales(&Coordinates::from_first(u)).into_array())
    }
}

/// The first of them.
#[inline(always)]
pub(super) fn first<T: Copy, const N: usize>(all: &[T; COORDINATES]) -> [T; N] {
    core::array::from_fn(|i| all[i])
}
