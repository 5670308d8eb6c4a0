//! A plug-in's tuning, which it keeps in its state.

use super::Plugin;
use anyhow::{Context, Result};
use serde_json::Value;

/// The length before the state's JSON, in bytes.
const LENGTH: usize = size_of::<u64>();

impl Plugin {
    /// Tunes the plug-in by the texts of a Scala scale and keyboard map; an empty one is none.
    ///
    /// # Errors
    ///
    /// If the state is not as nice-plug writes it, or is refused.
    pub fn tune(&mut self, scale: &str, keyboard: &str) -> Result<()> {
        let mut state = self.state()?;
        let fields = state["fields"].as_object_mut();
        let fields = fields.context("the plug-in's state has no fields")?;
        for (key, text) in [("scale", scale), ("kbm", keyboard)] {
            // nice-plug has fields as texts of their own JSON.
            let field = Value::from(text).to_string();
            fields.insert(key.to_owned(), Value::from(field));
        }
        self.load_state(&state)
    }

    /// The plug-in's state as nice-plug writes it.
    ///
    /// # Errors
    ///
    /// If it cannot be saved or read.
    pub fn state(&mut self) -> Result<Value> {
        let bytes = self.save()?;
        let text = bytes
            .get(LENGTH..)
            .context("the plug-in's state is empty")?;
        Ok(serde_json::from_slice(text)?)
    }

    /// Puts the plug-in into a state as nice-plug writes it: the length in eight bytes, least first, and
    /// JSON.
    ///
    /// # Errors
    ///
    /// If it refuses the state.
    pub fn load_state(&mut self, state: &Value) -> Result<()> {
        let text = state.to_string();
        let mut bytes = (text.len() as u64).to_le_bytes().to_vec();
        bytes.extend(text.as_bytes());
        self.load(&bytes)
    }
}
