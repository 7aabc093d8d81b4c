//! Invalid input and its messages, which name the field, the value, the bound and the unit.

use crate::ending::Ending;
use crate::number_format::{AngleUnit, formatted};
use thiserror::Error;

/// An input from which no motion can be computed.
///
/// `unit` is empty for a pure number. The messages address the person who typed the value.
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
    /// A table with too few entries, or with a different number of entries than its companion.
    #[error("{field} must have {bound}, got {count}")]
    WrongLength {
        /// The table's name in the API.
        field: &'static str,
        /// The required number of entries, in words.
        bound: String,
        /// The number of entries given.
        count: usize,
    },
    /// Two moments of inertia that no rigid body can have together.
    #[error(
        "axial_inertia must be at most 2 transverse_inertia = {} kg m2 (no rigid body has more), got {} kg m2",
        formatted(2.0 * transverse_inertia),
        formatted(*value)
    )]
    AxialInertiaTooLarge {
        /// C, kg m².
        value: f64,
        /// A, kg m².
        transverse_inertia: f64,
    },
    /// An unknown name.
    #[error("unknown {what} {name:?}: choose from {choices}")]
    UnknownName {
        /// The kind of thing that was named.
        what: &'static str,
        /// The name given.
        name: String,
        /// The names to choose from.
        choices: String,
    },
    /// An initial state whose motion has no near-collision.
    #[error("{}", no_near_collision(why, ending.as_ref(), AngleUnit::Radians))]
    NoNearCollision {
        /// Why not.
        why: String,
        /// The ending of the motion that comes in place of one.
        ending: Option<Ending>,
    },
    /// A motion that is not a smooth function of its parameters.
    #[error("no derivative of this motion is offered: {why}")]
    NoSensitivity {
        /// Why not.
        why: String,
    },
    /// A body composed of no solids.
    #[error("solids must name at least one solid, got none")]
    NoSolids,
}

impl InvalidInput {
    /// What is wrong, in a sentence with the angles of a motion in this unit.
    pub fn sentence(&self, unit: AngleUnit) -> String {
        match self {
            InvalidInput::NoNearCollision { why, ending } => {
                no_near_collision(why, ending.as_ref(), unit)
            }
            other => other.to_string(),
        }
    }

    pub(crate) fn no_near_collision(why: &str, ending: Option<Ending>) -> InvalidInput {
        let why = why.to_owned();
        InvalidInput::NoNearCollision { why, ending }
    }
}

fn no_near_collision(why: &str, ending: Option<&Ending>, unit: AngleUnit) -> String {
    let ended = ending.map_or(String::new(), |ending| {
        format!(": {}", ending.sentence(unit))
    });
    format!("this start has no near-collision: {why}{ended}")
}

fn with_unit(value: f64, unit: &str) -> String {
    let formatted = formatted(value);
    if unit.is_empty() {
        formatted
    } else {
        format!("{formatted} {unit}")
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

/// Accepts a finite number for which `holds` is true; `bound` states that condition in words.
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

/// Accepts an entry of a table for which `holds` is true; `bound` states that condition in words.
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

/// Accepts moments of inertia with C ≤ 2A. Flat bodies have C = 2A, so a rounding error is allowed.
pub(crate) fn at_most_twice(axial: f64, transverse: f64) -> Result<(), InvalidInput> {
    if axial > 2.0 * transverse * (1.0 + 4.0 * f64::EPSILON) {
        return Err(InvalidInput::AxialInertiaTooLarge {
            value: axial,
            transverse_inertia: transverse,
        });
    }
    Ok(())
}

/// Accepts a finite number of magnitude at most `max`.
pub(crate) fn within(
    field: &'static str,
    value: f64,
    max: f64,
    bound: &str,
    unit: &'static str,
) -> Result<f64, InvalidInput> {
    bounded(field, value, |v| v.abs() <= max, bound, unit)
}

/// Accepts a positive number of a size with which calculations neither overflow nor underflow.
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
