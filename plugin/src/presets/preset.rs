//! A preset: its card, its sound, and the document that it stands in.

use super::card::Card;
use super::sound::Sound;
use crate::factory;
use crate::params::body::INSTRUMENT;
use toml_edit::DocumentMut;

/// The present version of the format.
pub const FORMAT: i64 = 1;

/// Something in a file that is not understood; it stays there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Notice {
    /// Counted from 1.
    pub line: usize,
    /// What, and what comes of it.
    pub what: String,
}

/// One preset.
#[derive(Clone, Debug)]
pub struct Preset {
    /// What is written about it.
    pub card: Card,
    /// What it sets.
    pub sound: Sound,
    /// What is not understood.
    pub notices: Vec<Notice>,
    /// Ids of parameters whose texts are not understood.
    pub(super) unread: Vec<String>,
    /// With all that is not understood, in its place.
    pub(super) document: DocumentMut,
}

impl Preset {
    /// The name of the instrument that it plays.
    #[must_use]
    pub fn instrument(&self) -> &'static str {
        factory::title(self.sound.get(INSTRUMENT.id).unwrap_or(INSTRUMENT.default))
    }

    /// A new instance's sound, on the instrument of that index.
    #[must_use]
    pub fn init(instrument: usize) -> Self {
        let card = Card {
            name: "Init".to_owned(),
            about: "Everything as in a new instance.".to_owned(),
            ..Card::default()
        };
        Self::new(card, Sound::init(instrument))
    }

    /// The same sound, under another name.
    pub fn rename(&mut self, name: &str) {
        name.trim().clone_into(&mut self.card.name);
        self.write_card();
    }

    /// Its file's content.
    #[must_use]
    pub fn text(&self) -> String {
        self.document.to_string()
    }
}
