//! The browser boundary of rimroll: conversion only.
//!
//! WebAssembly passes numbers and addresses, nothing else. So a page writes its arguments as doubles
//! where [`exchange::arguments`] says, calls a function here, and reads what it answers: doubles at
//! [`exchange::numbers`], words at [`exchange::text`]. A call that the core refuses says so by what it
//! returns (null or `false`) and leaves the core's sentence in the text.
//!
//! Bodies, surfaces, starts and options are runs of numbers in the order of their fields; see
//! [`asked`].

mod asked;
mod bodies;
mod exchange;
mod falls;
mod motion;
mod theory;
