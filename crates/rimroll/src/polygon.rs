//! Bodies on a base with corners: nuts, square columns, prisms.
//!
//! A round body touches the table with one point of its rim, which runs round smoothly. A body whose base is a
//! regular polygon pivots about one corner at a time, and each change of corner is an impact, which loses energy. In
//! between it moves as a heavy symmetric body about a fixed point off its axis (no slip) or as a body whose corner
//! slides (no friction). The spin is not ignorable: it says which corner is lowest.
//!
//! * [`PolygonalBody`]: the six numbers that enter the motion, and ready-made bodies.
//! * [`Support`]: the corners that carry the body.
//! * [`simulate`]: phases on a corner, on an edge and in flight, joined by impacts (see the files `impact.rs` and
//!   `rebound.rs`).
//! * [`PolygonMotion`]: the computed motion.

mod body;
mod event_detector;
mod impact;
mod motion;
mod pose;
mod rebound;
mod run;
mod step_record;
mod support;
mod turns;
mod vector;

pub use body::PolygonalBody;
pub use motion::{COLUMNS, Observables, PolygonEvent, PolygonEventKind, PolygonMotion};
pub use run::{PolygonOptions, simulate};
pub use support::Support;
