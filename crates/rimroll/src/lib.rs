//! How round things fall, rock and roll on the rim of their base.
//!
//! Tip a can a little and let it fall back. It seems to slap the table and to rock up on the other side,
//! but never exactly opposite. The base does not in fact slap the table: the contact point runs round the
//! rim through a definite angle in almost no time, and the can rises in a new direction
//! (M. Srinivasan and A. Ruina, *Rocking and rolling: a can that appears to rock might actually roll*, 2007).
//!
//! The closer the motion comes to a face-down collision, the faster the contact point runs and the
//! closer the angle of turn comes to a limit that depends on the body alone:
//!
//! * rolling without slip: π √((A + mR² + mH²)/(A + mH²)), 202.29° for the paper's can;
//! * sliding without friction: π √((A + mR²)/A), 220.97°.
//!
//! This crate computes the whole motion and these limits. It reads no file and no clock and prints nothing.
//! All quantities are in SI units and radians. It uses only `libm` and operations that IEEE 754 defines to
//! the last bit, so results are identical on every machine (`tests/integration/same_bits.rs`).
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
//! Dry friction lies between these limits and has no closed form. The crate computes it by simulation,
//! with separate phases of rolling, sliding and flight and without regularisation.
//!
//! # Reading order
//! * [`body`], [`solids`], [`presets`]: the rolling body.
//! * [`contact_law`]: friction, restitution and resistance of the table.
//! * [`state`]: Euler angles, and the coordinates that stay regular through the near-collision.
//! * [`ground`]: the acceleration of a table that moves.
//! * [`law`]: the equations of motion, one file per law.
//! * [`solve`]: an ODE solver that knows no mechanics.
//! * [`motion`]: [`simulate`], which joins smooth phases at events; [`motion::Sensitivity`], the derivatives
//!   of a motion with respect to its parameters; [`motion::fall`], one turn without a recorded motion.
//! * [`ensemble`](mod@ensemble): many falls at once.
//! * [`shaking`]: many motions on tables that move, of which only the ends and the extremes are kept.
//! * [`polygon`]: bodies on a base with corners.
//! * [`steady`]: motions at a constant tilt, and their stability.
//! * [`turn`]: closed forms, and the near-collision as a problem of its own under any friction.
//! * [`composite_approximation`] and [`small_angle`]: the paper's two approximations.
//! * [`imperfection`]: the theory that the paper rejects.
//!
//! # What it does not do
//! A body is described by its mass, its moments of inertia and its rim. Contact of any other part of the
//! body with the table is not detected. A motion ends with a [`Status`] that says why when it leaves the
//! domain of rigid-body mechanics or of the chosen law.

pub mod body;
pub mod composite_approximation;
pub mod contact_law;
mod ending;
pub mod ensemble;
pub mod error;
mod error_scale;
pub mod ground;
mod impact;
pub mod imperfection;
pub mod law;
pub mod motion;
mod number_format;
mod parallel;
pub mod polygon;
pub mod presets;
pub mod real;
#[cfg(feature = "ground")]
pub mod shaking;
pub mod small_angle;
pub mod solids;
pub mod solve;
pub mod state;
pub mod steady;
pub mod turn;

pub use body::Body;
pub use contact_law::ContactLaw;
pub use ensemble::{Setup, ensemble};
pub use error::InvalidInput;
pub use ground::Ground;
pub use law::{FrictionLaw, IdealLaw};
pub use motion::{Motion, Options, Status, simulate, simulate_on};
#[cfg(feature = "ground")]
pub use shaking::{Shaking, shake_many};
pub use solids::Solid;
pub use state::State;
