//! The browser boundary of rimroll: conversion only.
//!
//! WebAssembly functions pass only numbers and addresses. A page writes its arguments as doubles at the
//! address given by `exchange::arguments`, calls a function of this crate, and reads the result: doubles at
//! `exchange::numbers`, text at `exchange::text`. A call that the core refuses returns null or `false`
//! and leaves the core's error message as the text.
//!
//! Bodies, contact laws, starts and options are sequences of numbers in the order of their fields; see
//! `exchange::Arguments`.

mod bodies;
mod exchange;
mod motion;
#[cfg(feature = "ground")]
mod shaken;
mod theory;
