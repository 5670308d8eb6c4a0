//! What a picture asks of the desktop: the pointer's shape, the clipboard, and folders to be shown.

use super::clipboard::Clipboard;
use super::pointer::Pointer;
use baseview::WindowContext;
use egui::{OutputCommand, PlatformOutput};

/// The desktop, as far as a window needs it.
#[derive(Default)]
pub(super) struct Desktop {
    pub(super) clipboard: Clipboard,
    pointer: Pointer,
}

impl Desktop {
    /// Does what is asked.
    pub(super) fn serve(&mut self, asked: PlatformOutput, window: &WindowContext) {
        self.pointer.show(asked.cursor_icon, window);
        for command in asked.commands {
            match command {
                OutputCommand::CopyText(text) => self.clipboard.put(text),
                OutputCommand::OpenUrl(wanted) => {
                    if let Err(error) = open::that_detached(&wanted.url) {
                        nice_plug::nice_warn!("{}: {error}", wanted.url);
                    }
                }
                OutputCommand::CopyImage(_) | OutputCommand::TextSelectionSettled(_) => {}
            }
        }
    }
}
