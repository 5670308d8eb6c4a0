//! Tuning from outside: texts in the song, and a master plug-in that retunes whatever plays in the
//! session, by MTS-ESP.

mod client;
mod error;
mod library;
mod texts;

pub use client::MtsClient;
pub use error::MtsError;
pub use texts::{KeyboardText, ScaleText, TuningTexts};
