//! What is refused, and how it is said: the field, the value, the bound and the unit.

use thiserror::Error;

/// An input that no motion can be computed from.
///
/// `unit` is empty for a pure number. The texts are written for the person who typed the value.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum InvalidInput {
    /// A number that is not finite.
    #[error("{field} must be a finite number, got {value}")]
    NotFinite {
        /// Its name in the API.
        field: &'static str,
        /// What was given.
        value: f64,
    },
    /// A number outside its bound, such as a negative mass.
    #[error("{field} must be {bound}, got {}", with_unit(*value, unit))]
    OutOfBounds {
        /// Its name in the API.
        field: &'static str,
        /// What was given.
        value: f64,
        /// What it must be, in words.
        bound: String,
        /// Its unit.
        unit: &'static str,
    },
    /// An entry of a table outside its bound.
    #[error("{field}[{index}] must be {bound}, got {}", with_unit(*value, unit))]
    EntryOutOfBounds {
        /// The table's name in the API.
        field: &'static str,
        /// The entry's place in it, from 0.
        index: usize,
        /// What was given.
        value: f64,
        /// What it must be, in words.
        bound: String,
        /// Its unit.
        unit: &'static str,
    },
    /// A table with too few entries, or another number of them than the table beside it.
    #[error("{field} must have {bound}, got {count}")]
    WrongLength {
        /// The table's name in the API.
        field: &'static str,
        /// How many it must have, in words.
        bound: String,
        /// How many were given.
        count: usize,
    },
    /// Two numbers that no rigid body can have together.
    #[error(
        "axial_inertia must be at most 2 transverse_inertia = {} kg m2 (no rigid body has more), got {} kg m2",
        shown(2.0 * transverse_inertia),
        shown(*value)
    )]
    AxialInertiaTooLarge {
        /// C, kg m².
        value: f64,
        /// A, kg m².
        transverse_inertia: f64,
    },
    /// A name that stands for nothing.
    #[error("unknown {what} {name:?}: choose from {choices}")]
    UnknownName {
        /// What kind of thing was named.
        what: &'static str,
        /// The name given.
        name: String,
        /// The names there are.
        choices: String,
    },
    /// A start whose motion has no near-collision to describe.
    #[error("this start has no near-collision: {why}")]
    NoNearCollision {
        /// Why not.
        why: String,
    },
    /// A motion that is not smooth in what it was computed from.
    #[error("no derivative of this motion is offered: {why}")]
    NoSensitivity {
        /// Why not.
        why: String,
    },
    /// A body composed of no solids.
    #[error("solids must name at least one solid, got none")]
    NoSolids,
}

fn with_unit(value: f64, unit: &str) -> String {
    let shown = shown(value);
    if unit.is_empty() {
        shown
    } else {
        format!("{shown} {unit}")
    }
}

/// A number as a person would type it: with an exponent when it is very small or large.
pub(crate) fn shown(value: f64) -> String {
    let size = value.abs();
    if size == 0.0 || (1e-4..1e7).contains(&size) {
        format!("{value}")
    } else {
        format!("{value:e}")
    }
}

/// Accepts a finite number.
pub(crate) fn finite(field: &'static str, value: f64) -> Result<f64, InvalidInput> {
    if value.is_finite() {
        Ok(value)
    } else {
        Err(InvalidInput::NotFinite { field, value })
    }
}

/// Accepts a finite number for which `holds`; `bound` says in words what that asks.
pub(crate) fn bounded(
    field: &'static str,
    value: f64,
    holds: impl Fn(f64) -> bool,
    bound: &str,
    unit: &'static str,
) -> Result<f64, InvalidInput> {
    if holds(finite(field, value)?) {
        Ok(value)
    } else {
        Err(InvalidInput::OutOfBounds {
            field,
            value,
            bound: bound.to_owned(),
            unit,
        })
    }
}

/// Accepts an entry of a table for which `holds`; `bound` says in words what that asks.
pub(crate) fn entry(
    field: &'static str,
    index: usize,
    value: f64,
    holds: impl Fn(f64) -> bool,
    bound: &str,
    unit: &'static str,
) -> Result<(), InvalidInput> {
    if holds(value) {
        return Ok(());
    }
    Err(InvalidInput::EntryOutOfBounds {
        field,
        index,
        value,
        bound: bound.to_owned(),
        unit,
    })
}

/// Accepts moments of inertia with C ≤ 2A, but for the rounding of a flat body's, where C = 2A.
pub(crate) fn at_most_twice(axial: f64, transverse: f64) -> Result<(), InvalidInput> {
    if axial > 2.0 * transverse * (1.0 + 4.0 * f64::EPSILON) {
        return Err(InvalidInput::AxialInertiaTooLarge {
            value: axial,
            transverse_inertia: transverse,
        });
    }
    Ok(())
}

/// Accepts a finite number no farther from zero than `most`.
pub(crate) fn within(
    field: &'static str,
    value: f64,
    most: f64,
    bound: &str,
    unit: &'static str,
) -> Result<f64, InvalidInput> {
    bounded(field, value, |v| v.abs() <= most, bound, unit)
}

/// Accepts a number above zero of a size that calculations do not overflow with.
pub(crate) fn moderate(
    field: &'static str,
    value: f64,
    unit: &'static str,
) -> Result<f64, InvalidInput> {
    positive(field, value, unit)?;
    let moderate = |v| (1e-60..=1e60).contains(&v);
    bounded(field, value, moderate, "between 1e-60 and 1e60", unit)
}

/// Accepts a finite number above zero.
pub(crate) fn positive(
    field: &'static str,
    value: f64,
    unit: &'static str,
) -> Result<f64, InvalidInput> {
    bounded(field, value, |v| v > 0.0, "> 0", unit)
}

/// Accepts a finite number that is not negative.
pub(crate) fn not_negative(
    field: &'static str,
    value: f64,
    unit: &'static str,
) -> Result<f64, InvalidInput> {
    bounded(field, value, |v| v >= 0.0, ">= 0", unit)
}
