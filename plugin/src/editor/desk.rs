//! The plug-in's end of the editor.

use super::link::Link;
use super::reporter::Reporter;
use super::saved::{ChosenField, MapField, Saved, SavedField};
use super::window::Window;
use super::windows::Windows;
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
    #[persist = "map"]
    map: MapField,
    #[persist = "preset"]
    chosen: ChosenField,
}

impl Desk {
    /// What the host keeps.
    pub(crate) fn params(&self, controls: &Arc<Controls>) -> Arc<dyn Params> {
        Arc::new(Kept {
            controls: Arc::clone(controls),
            saved: SavedField(Arc::clone(&self.saved)),
            map: MapField(Arc::clone(&self.saved)),
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

#[cfg(test)]
mod tests {
    use super::Desk;
    use crate::editor::{Chosen, Touch};
    use crate::engine::Outputs;
    use crate::params::heal;
    use crate::player::Player;
    use crate::stage::Stage;
    use crate::tuner::Tuner;
    use modes::tuning::Tuning;
    use nice_plug::prelude::PluginState;
    use std::collections::BTreeMap;
    use std::sync::Arc;

    #[test]
    fn the_chosen_preset_travels_with_the_song_and_an_older_song_has_none() {
        let (desk, controls) = (Desk::default(), Arc::default());
        let params = desk.params(&controls);
        let old = Chosen {
            key: "user/A.toml".to_owned(),
            changed: true,
            tuned: true,
        };
        desk.saved.choose(old.clone());
        let fields = params.serialize_fields();
        let mut older = PluginState {
            version: String::new(),
            params: BTreeMap::new(),
            fields: BTreeMap::new(),
        };
        heal(&mut older);
        params.deserialize_fields(&older.fields);
        assert_eq!(desk.saved.chosen(), Chosen::default());
        params.deserialize_fields(&fields);
        assert_eq!(desk.saved.chosen(), old);
    }

    #[test]
    fn the_map_travels_with_the_song_and_an_older_song_leaves_it() {
        let (desk, controls) = (Desk::default(), Arc::default());
        let params = desk.params(&controls);
        desk.saved.set_map(true);
        let mut fields = params.serialize_fields();
        desk.saved.set_map(false);
        params.deserialize_fields(&fields);
        assert!(desk.saved.map());
        assert!(fields.remove("map").is_some());
        params.deserialize_fields(&fields);
        assert!(desk.saved.map());
    }

    #[test]
    fn a_click_sounds_with_the_first_samples_of_the_next_block() {
        let (desk, controls) = (Desk::default(), Arc::default());
        let stage = Stage::new(0, crate::factory::bank(0), 48e3);
        let tuner = Tuner::new(Tuning::default(), None);
        let mut player = Player::new(stage, tuner, controls, 48e3);
        let mut block = || {
            let (mut left, mut right) = ([0.0f32; 64], [0.0f32; 64]);
            desk.play(&mut player);
            player
                .stage()
                .render(&mut Outputs::main(&mut left, &mut right));
            left.iter().position(|x| *x != 0.0)
        };
        assert_eq!(block(), None);
        desk.link.touch(Touch::Strike {
            key: 60,
            velocity: 0.8,
            position: 0.5,
            across: 0.0,
        });
        // Before the mallet has pressed for a sample nothing moves.
        let onset = block();
        assert!(onset.is_some_and(|frame| frame < 4), "{onset:?}");
    }
}
