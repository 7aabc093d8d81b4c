//! The topple tilt, as both steppers detect it.

use crate::real::{Real, fieldwise};
use crate::state::Coordinates;

/// The tilt at which a body counts as toppled, by its sine and cosine.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ToppleTilt<T> {
    sin: T,
    cos: T,
}

fieldwise!(ToppleTilt { sin, cos; });

impl ToppleTilt<f64> {
    /// The topple tilt, rad.
    pub(crate) fn at(tilt: f64) -> Self {
        let (sin, cos) = libm::sincos(tilt);
        ToppleTilt { sin, cos }
    }

    /// A topple tilt of π, which no body reaches.
    pub(crate) fn never() -> Self {
        ToppleTilt {
            sin: 0.0,
            cos: -1.0,
        }
    }

    /// Whether the topple tilt is π/2. The cosine of the double next to π/2 is 6e-17.
    pub(crate) fn is_upright(&self) -> bool {
        self.cos.abs() < 1e-15
    }

    /// Whether the topple tilt is at most π/2, where the base is vertical.
    pub(crate) fn is_at_most_upright(&self) -> bool {
        self.cos > -1e-9
    }
}

impl<T: Real> ToppleTilt<T> {
    /// sin(topple tilt − φ), an event function that is positive below the topple tilt and negative above it.
    #[inline(always)]
    pub(crate) fn below(&self, u: &Coordinates<T>) -> T {
        u.cos * self.sin - u.sin * self.cos
    }
}
