//! The plug-in's end of the editor.

use super::link::Link;
use super::reporter::Reporter;
use super::saved::{ChosenField, Saved, SavedField};
use super::window::{Window, Windows};
use crate::params::Controls;
use crate::player::Player;
use nice_plug::prelude::Params;
use std::sync::Arc;

/// Everything that an instance keeps for its editor, open or not.
#[derive(Default)]
pub(crate) struct Desk {
    saved: Arc<Saved>,
    link: Arc<Link>,
    windows: Arc<Windows>,
    reporter: Reporter,
}

/// The parameters, and what of the editor is kept with them.
#[derive(Params)]
struct Kept {
    #[nested]
    controls: Arc<Controls>,
    #[persist = "window"]
    saved: SavedField,
    #[persist = "preset"]
    chosen: ChosenField,
}

impl Desk {
    /// What the host keeps.
    pub(crate) fn params(&self, controls: &Arc<Controls>) -> Arc<dyn Params> {
        Arc::new(Kept {
            controls: Arc::clone(controls),
            saved: SavedField(Arc::clone(&self.saved)),
            chosen: ChosenField(Arc::clone(&self.saved)),
        })
    }

    /// What opens windows.
    pub(crate) fn window(&self, controls: &Arc<Controls>) -> Window {
        Window::new(
            Arc::clone(controls),
            Arc::clone(&self.saved),
            Arc::clone(&self.link),
            Arc::clone(&self.windows),
        )
    }

    /// Whether a window is open.
    pub(crate) fn is_open(&self) -> bool {
        self.windows.is_open()
    }

    /// Before a block: plays what has been played in the window.
    pub(crate) fn play(&self, player: &mut Player) {
        for touch in self.link.touches() {
            player.touch(touch);
        }
    }

    /// After a block: lets the window look.
    pub(crate) fn report(&mut self, player: &mut Player, block: [&[f32]; 2]) {
        let (index, engine) = player.stage().present();
        if self.reporter.report(&self.link, index, engine, block) {
            self.windows.repaint();
        }
    }
}
