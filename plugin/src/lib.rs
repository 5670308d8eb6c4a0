//! The instrument.

pub mod engine;
