//! Bodies on a base with corners: nuts, square columns, prisms.
//!
//! A round body touches the table with one point of its rim, which runs round smoothly. A body whose base is a
//! regular polygon pivots about one corner at a time, and each change of corner is an impact, which loses energy. In
//! between it moves as a heavy symmetric body about a fixed point off its axis (no slip) or as a body whose corner
//! slides (no friction). The spin is not ignorable: it says which corner is lowest.
//!
//! * [`PolygonalBody`]: the six numbers that enter the motion, and ready-made bodies.
//! * [`Support`]: the corners that carry the body.
//! * [`simulate`]: phases on a corner, on an edge and in flight, joined by impacts (see the file `impact.rs`).
//! * [`PolygonMotion`]: the computed motion.

mod body;
mod event_detector;
mod impact;
mod motion;
mod pose;
mod run;
mod support;

pub use body::PolygonalBody;
pub use motion::{COLUMNS, Observables, PolygonEvent, PolygonEventKind, PolygonMotion};
pub use run::{PolygonOptions, simulate};
pub use support::Support;

/// A vector in the body frame: components along the axes of the body; the third is the axis of symmetry.
type Vector = [f64; 3];

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Vector, b: Vector) -> Vector {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// a + factor · b.
fn plus(a: Vector, factor: f64, b: Vector) -> Vector {
    core::array::from_fn(|i| a[i] + factor * b[i])
}

fn minus(a: Vector, b: Vector) -> Vector {
    plus(a, -1.0, b)
}

fn times(factor: f64, a: Vector) -> Vector {
    a.map(|component| factor * component)
}

fn length(a: Vector) -> f64 {
    dot(a, a).sqrt()
}
