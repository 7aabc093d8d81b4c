//! How round things fall, rock and roll on the rim of their base.
//!
//! Tip a can a little and let it fall upright. It seems to slap the table and rock up on the other side,
//! yet never quite opposite. In truth the base does not slap: its contact point runs round the rim by
//! a definite angle in almost no time, and the can rises again, veered (M. Srinivasan and A. Ruina,
//! *Rocking and rolling: a can that appears to rock might actually roll*, 2007).
//!
//! The closer the motion comes to a face-down collision, the faster the contact point runs, and the
//! nearer the angle of turn comes to a limit that depends on the body alone:
//!
//! * rolling without slip: π √((A + mR² + mH²)/(A + mH²)), 202.29° for the paper's can;
//! * sliding without friction: π √((A + mR²)/A), 220.97°.
//!
//! This crate computes the whole motion and these limits. It is pure: no files, no clock, no printing.
//! SI units and radians throughout. Only operations that IEEE 754 defines to the bit, and `libm`, so that
//! results are the same on every machine (`tests/same_bits.rs`).
//!
//! ```
//! use rimroll::{IdealLaw, Options, State, presets, simulate, turn::turn_limit};
//! use std::ops::ControlFlow;
//!
//! let can = presets::can_2007()?;
//! let start = State { tilt: 0.5236, tilt_rate: -0.5, yaw_rate: 0.005, spin_rate: 0.005, ..State::default() };
//! let motion = simulate(&can, &start, IdealLaw::NoSlip, &Options::default(), |_| ControlFlow::Continue(()))?;
//! let turn = motion.turns[1].angle.to_degrees();
//! let limit = turn_limit(&can, IdealLaw::NoSlip).to_degrees();
//! assert!((turn - limit).abs() < 0.5 && (limit - 202.287).abs() < 0.001);
//! # Ok::<(), rimroll::InvalidInput>(())
//! ```
//!
//! Between these limits lies dry friction, for which there is no closed form: the same crate computes
//! it, with exact phases of rolling, sliding and flight.
//!
//! # Reading order
//! [`body`] and [`solids`]: what rolls. [`contact_law`]: what it rolls on. [`state`]: where it is and how it
//! moves, and the coordinates that stay regular through the near-collision. [`law`]: the equations of
//! motion, one file a law. [`solve`]: a solver that knows no mechanics. [`motion`]: [`simulate`], phases
//! joined by events, [`motion::Sensitivity`], how a motion changes with what it was computed from, and
//! [`motion::fall`], one turn alone; [`ensemble`](mod@ensemble): many falls at once. [`turn`]: closed
//! forms, and the near-collision by itself under any friction. [`pasted`] and [`small_angle`]: the
//! paper's two approximations. [`imperfection`]: the theory that it rejects.
//!
//! # What it does not do
//! A body is its mass, its moments of inertia and its rim: what else of it might touch the table, it
//! does not know. A motion that leaves mechanics, or the law's domain, ends there with a [`Status`] that
//! says so.

pub mod body;
pub mod contact_law;
pub mod ensemble;
pub mod error;
mod error_scale;
mod impact;
pub mod imperfection;
pub mod law;
pub mod motion;
pub mod pasted;
pub mod presets;
pub mod real;
pub mod small_angle;
pub mod solids;
pub mod solve;
pub mod state;
pub mod turn;

pub use body::Body;
pub use contact_law::{ContactLaw, FrictionLaw};
pub use ensemble::{Release, ensemble};
pub use error::InvalidInput;
pub use law::IdealLaw;
pub use motion::{Motion, Options, Status, simulate};
pub use solids::Solid;
pub use state::State;
