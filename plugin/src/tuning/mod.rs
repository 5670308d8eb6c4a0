//! Tuning from outside: a master plug-in that retunes whatever plays in the session, by MTS-ESP.

mod client;
mod error;
mod library;

pub use client::MtsClient;
pub use error::MtsError;
