//! Numbers and angles in messages.

/// A number as a person would type it: with an exponent if it is very small or very large.
pub(crate) fn formatted(value: f64) -> String {
    let size = value.abs();
    if size == 0.0 || (1e-4..1e7).contains(&size) {
        format!("{value}")
    } else {
        format!("{value:e}")
    }
}

/// A time (s) to the microsecond, or in full if it is shorter than a millisecond.
pub(crate) fn formatted_time(t: f64) -> String {
    if t == 0.0 || t >= 1e-3 {
        format!("{t:.6}")
    } else {
        formatted(t)
    }
}

/// The unit of the angles in a sentence.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AngleUnit {
    /// rad.
    Radians,
    /// °.
    Degrees,
}

impl AngleUnit {
    pub(crate) fn formatted(self, angle: f64) -> String {
        match self {
            AngleUnit::Radians => format!("{angle:.6} rad"),
            AngleUnit::Degrees => format!("{:.3}°", angle.to_degrees()),
        }
    }

    /// The angle to one significant digit.
    pub(crate) fn rounded(self, angle: f64) -> String {
        match self {
            AngleUnit::Radians => format!("{angle:.0e} rad"),
            AngleUnit::Degrees => format!("{:.0e}°", angle.to_degrees()),
        }
    }

    pub(crate) fn right_angle(self) -> &'static str {
        match self {
            AngleUnit::Radians => "pi/2",
            AngleUnit::Degrees => "90°",
        }
    }
}
