//! What many tests start from.

pub mod bodies;
pub mod cases;
pub mod motions;
pub mod shaken;
