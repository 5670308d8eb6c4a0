//! The desktop's clipboard.

use copypasta::{ClipboardContext, ClipboardProvider as _};

/// Opened when it is first needed.
#[derive(Default)]
pub(super) struct Clipboard(Option<ClipboardContext>);

impl Clipboard {
    /// Puts a text there.
    pub(super) fn put(&mut self, text: String) {
        let Some(open) = self.open() else {
            return;
        };
        if let Err(error) = open.set_contents(text) {
            nice_plug::nice_warn!("nothing is copied: {error}");
        }
    }

    /// The text that is there.
    pub(super) fn get(&mut self) -> Option<String> {
        self.open()?.get_contents().ok()
    }

    fn open(&mut self) -> Option<&mut ClipboardContext> {
        if self.0.is_none() {
            match ClipboardContext::new() {
                Ok(open) => self.0 = Some(open),
                Err(error) => nice_plug::nice_warn!("there is no clipboard: {error}"),
            }
        }
        self.0.as_mut()
    }
}
