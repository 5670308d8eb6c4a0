//! From a preset to its file's text.

use super::card::Card;
use super::preset::{FORMAT, Preset};
use super::sound::Sound;
use toml_edit::{Array, DocumentMut, Item, Table, value};

impl Preset {
    /// One that stands in a document of its own.
    #[must_use]
    pub fn new(card: Card, sound: Sound) -> Self {
        let mut preset = Self {
            card,
            sound: Sound::default(),
            notices: Vec::new(),
            unread: Vec::new(),
            document: DocumentMut::new(),
        };
        preset.document["format"] = value(FORMAT);
        preset.write_card();
        preset.set_sound(sound);
        preset
    }

    /// One that goes on from this one: what is not understood of this is in it too.
    #[must_use]
    pub fn with(&self, card: Card, sound: Sound) -> Self {
        let mut preset = self.clone();
        preset.card = card;
        preset.write_card();
        preset.set_sound(sound);
        preset
    }

    /// Writes what is on the card; an empty text only where there was one.
    pub(super) fn write_card(&mut self) {
        let Card {
            name,
            category,
            tags,
            author,
            about,
        } = &self.card;
        let document = &mut self.document;
        let mut put = |key: &str, item: Item, empty: bool| {
            if !empty || document.contains_key(key) {
                document[key] = item;
            }
        };
        put("name", value(name), false);
        put("category", value(category), category.is_empty());
        put("tags", value(Array::from_iter(tags)), tags.is_empty());
        put("author", value(author), author.is_empty());
        put("about", value(about), about.is_empty());
    }

    /// Writes a sound, each parameter as the host shows it. Where a text that is not understood has left
    /// a parameter as new and it still is, that text stays.
    fn set_sound(&mut self, sound: Sound) {
        let said = table(&mut self.document, "sound");
        for (spec, plain) in &sound.values {
            let text = spec.format(*plain);
            let untouched = text == spec.format(spec.default);
            if untouched && self.unread.iter().any(|id| id == spec.id) {
                continue;
            }
            self.unread.retain(|id| id != spec.id);
            said.insert(spec.id, value(text));
        }
        if sound.scala.is_empty() {
            if let Some(table) = self.document.get_mut("tuning").and_then(Item::as_table_mut) {
                table.remove("scale");
                table.remove("keyboard");
            }
        } else {
            let tuning = table(&mut self.document, "tuning");
            tuning.insert("scale", value(&sound.scala.scale));
            tuning.insert("keyboard", value(&sound.scala.keyboard));
        }
        self.sound = sound;
    }
}

/// The table of that name, made if it is not there.
fn table<'a>(document: &'a mut DocumentMut, name: &str) -> &'a mut Table {
    let item = document.entry(name).or_insert_with(toml_edit::table);
    if !item.is_table() {
        let inline = std::mem::take(item);
        *item = Item::Table(inline.into_table().unwrap_or_default());
    }
    item.as_table_mut().expect("it is a table now")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::params::body::{INSTRUMENT, SIZE};
    use crate::params::mallet::{HARDNESS, MALLET};
    use crate::presets::Scala;

    #[test]
    fn a_preset_is_readable_and_reads_back() {
        let card = Card {
            name: "Big \"glass\"".to_owned(),
            tags: vec!["cold".to_owned()],
            ..Card::default()
        };
        let sound = Sound {
            values: vec![(&SIZE, 2.0), (&HARDNESS, 2e9)],
            scala: Scala {
                scale: "! a\nb\n1\n2/1\n".to_owned(),
                keyboard: String::new(),
            },
        };
        let preset = Preset::new(card, sound);
        let text = preset.text();
        assert!(text.contains("\nhard = \"2.00 GPa\"\n"), "{text}");
        let read = Preset::read(&text, "a").unwrap();
        assert_eq!((read.card, read.sound), (preset.card, preset.sound));
        assert_eq!(read.notices, []);
    }

    #[test]
    fn saving_again_loses_nothing_of_what_was_not_understood() {
        let text = "# by hand\nformat = 7\nname = \"A\" # mine\nmood = 3\n\n[sound]\ninstr = \"Glass harp\"\n\
                    mallet = \"carbon\"\nwarp = \"3 x\" # strong\nsize = \"1 x\"\n\n[space]\nroom = 1\n";
        let old = Preset::read(text, "A").unwrap();
        let sound = Sound {
            values: vec![(&INSTRUMENT, 0.0), (&MALLET, 2.0), (&SIZE, 2.0)],
            scala: Scala::default(),
        };
        let new = old.with(old.card.clone(), sound);
        let expected = text
            .replace("\"carbon\"", "\"yarn, medium\"")
            .replace("\"1 x\"", "\"2.00 x\"");
        let lines = |text: &str| -> Vec<String> {
            let bare = |line: &str| line.split(" # mine").next().unwrap_or(line).to_owned();
            text.lines().map(bare).collect()
        };
        assert_eq!(lines(&new.text()), lines(&expected));
    }

    #[test]
    fn a_sound_in_braces_is_written_too() {
        let old = Preset::read(
            "name = \"A\"\nsound = { size = \"1 x\", warp = \"2\" }\n",
            "A",
        )
        .unwrap();
        let sound = Sound {
            values: vec![(&SIZE, 2.0)],
            scala: Scala::default(),
        };
        let new = Preset::read(&old.with(old.card.clone(), sound).text(), "A").unwrap();
        assert_eq!(new.sound.get("size"), Some(2.0));
        assert_eq!(new.notices.len(), 1);
    }
}
