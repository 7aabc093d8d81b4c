//! Invalid input and its messages, which name the field, the value, the bound and the unit.

use crate::ending::Ending;
use crate::number_format::{AngleUnit, formatted};
use thiserror::Error;

/// An input from which no motion can be computed.
///
/// `unit` is empty for a pure number. The messages address the person who typed the value.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum InvalidInput {
    /// A number, or an entry of a table, outside its bound, such as a negative mass.
    #[error("{field}{} {}", place(*index), self.predicate())]
    OutOfBounds {
        /// Its name in the API, or that of its table.
        field: &'static str,
        /// The entry's place in the table, from 0.
        index: Option<usize>,
        /// What was given.
        value: f64,
        /// What it must be, in words.
        bound: String,
        /// Its unit.
        unit: &'static str,
        /// The field whose value the bound depends on and names, if there is one.
        other: Option<&'static str>,
    },
    /// A table with too few entries, or with a different number of entries than its companion.
    #[error("{field} {}", self.predicate())]
    WrongLength {
        /// The table's name in the API.
        field: &'static str,
        /// The required number of entries, in words.
        bound: String,
        /// The number of entries given.
        count: usize,
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

    /// What is wrong, without the name of the value that the sentence begins with, if there is one.
    pub fn predicate(&self) -> String {
        match self {
            InvalidInput::OutOfBounds {
                value, bound, unit, ..
            } => format!("must be {bound}, got {}", with_unit(*value, unit)),
            InvalidInput::WrongLength { bound, count, .. } => {
                format!("must have {bound}, got {count}")
            }
            other => other.to_string(),
        }
    }

    /// States the field that the bound depends on and names.
    pub(crate) fn beside(mut self, field: &'static str) -> InvalidInput {
        if let InvalidInput::OutOfBounds { other, .. } = &mut self {
            *other = Some(field);
        }
        self
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

fn place(index: Option<usize>) -> String {
    index.map_or(String::new(), |index| format!("[{index}]"))
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
        Err(out_of_bounds(field, value, "a finite number", ""))
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
        Err(out_of_bounds(field, value, bound, unit))
    }
}

/// The error of a number; `bound` is what it must be, in words.
pub(crate) fn out_of_bounds(
    field: &'static str,
    value: f64,
    bound: &str,
    unit: &'static str,
) -> InvalidInput {
    InvalidInput::OutOfBounds {
        field,
        index: None,
        value,
        bound: bound.to_owned(),
        unit,
        other: None,
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
    Err(InvalidInput::OutOfBounds {
        field,
        index: Some(index),
        value,
        bound: bound.to_owned(),
        unit,
        other: None,
    })
}

/// Accepts moments of inertia with C ≤ 2A. Flat bodies have C = 2A, so a rounding error is allowed.
pub(crate) fn at_most_twice(axial: f64, transverse: f64) -> Result<(), InvalidInput> {
    if axial > 2.0 * transverse * (1.0 + 4.0 * f64::EPSILON) {
        let most = formatted(2.0 * transverse);
        let bound = format!("at most 2 transverse_inertia = {most} kg m2 (no rigid body has more)");
        return Err(
            out_of_bounds("axial_inertia", axial, &bound, "kg m2").beside("transverse_inertia")
        );
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
