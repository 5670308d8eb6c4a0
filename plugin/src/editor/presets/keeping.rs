//! What is heard, as a preset that is kept.

use super::super::chosen::Chosen;
use super::session::Session;
use crate::presets::{Broken, Card, Origin, Preset, Sound};
use nice_plug::prelude::ParamSetter;
use std::path::Path;

impl Session {
    /// The card to save under: the chosen one's, as far as it is the user's to sign.
    pub(super) fn card(&self) -> Card {
        let card = self.preset().map(|preset| preset.card.clone());
        let mut card = card.unwrap_or_default();
        if !matches!(self.chosen().origin(), Some(Origin::User(_))) {
            let mine = self
                .library
                .entries()
                .iter()
                .filter(|entry| entry.is_user_s());
            let mut authors =
                mine.filter_map(|entry| Some(&entry.preset.as_ref().ok()?.card.author));
            card.author = authors.next().cloned().unwrap_or_default();
        }
        card
    }

    /// The sound that is heard as a preset with that card, going on from the chosen one.
    pub(super) fn capture(&self, card: Card) -> Preset {
        let values = self.params.iter().map(|param| (param.spec, param.plain()));
        let sound = Sound {
            values: values
                .filter(|(spec, _)| !Sound::is_player_s(spec))
                .collect(),
            scala: self.scala(),
            trims: self.trims().list(),
        };
        match self.chosen().origin().and(self.preset()) {
            Some(preset) => preset.with(card, sound),
            None => Preset::new(card, sound),
        }
    }

    /// Keeps the sound that is heard under a card.
    pub(super) fn save(&mut self, card: Card) -> Result<(), Broken> {
        let preset = self.capture(card);
        let origin = self.library.save(&preset)?;
        self.saved.choose(Chosen {
            key: origin.key(),
            changed: false,
            tuned: !preset.sound.scala.is_empty(),
        });
        Ok(())
    }

    /// Keeps a preset from elsewhere among the user's, and loads it if that is wanted; its name.
    pub(in super::super) fn bring(
        &mut self,
        from: &Path,
        load: bool,
        setter: &ParamSetter<'_>,
    ) -> Result<String, Broken> {
        let origin = self.library.import(from)?;
        if load {
            self.choose(&origin, setter);
        }
        let entry = self.library.find(&origin);
        Ok(entry.map_or_else(String::new, |entry| entry.name().to_owned()))
    }

    /// Gives one of the user's presets another name; it stays chosen.
    pub(super) fn rename(&mut self, file: &str, to: &str) -> Result<Origin, Broken> {
        let old = Origin::User(file.to_owned());
        let new = self.library.rename(file, to)?;
        let chosen = self.chosen();
        if chosen.origin() == Some(old) {
            let key = new.key();
            self.saved.choose(Chosen { key, ..chosen });
        }
        Ok(new)
    }
}
