//! Trims of single modes in a file: `"bending 2 a" = { level = "-6.00 dB", ringing = "2.00 x" }`.

use super::mode_name::{mode_name, named_mode};
use crate::engine::range::{TRIM_DB, TRIM_RINGING};
use crate::engine::{MOST_TRIMS, Trim, Trims};
use crate::params::Text;
use modes::ModeLabel;
use std::ops::RangeInclusive;
use toml_edit::{InlineTable, Item, Table, TableLike, Value, value};

/// Modes that are not as built.
pub type TrimList = Vec<(ModeLabel, Trim)>;

const LEVEL: (&str, Text) = ("level", Text::Fixed("dB"));
const RINGING: (&str, Text) = ("ringing", Text::Digits("x"));

/// Whether two lists read the same.
pub(super) fn same(one: &TrimList, other: &TrimList) -> bool {
    let said = |list: &TrimList| -> Vec<_> {
        let said = |(label, trim): &(ModeLabel, Trim)| (*label, words(trim));
        list.iter()
            .map(said)
            .filter(|(_, words)| *words != words_of_none())
            .collect()
    };
    said(one) == said(other)
}

fn words(trim: &Trim) -> [String; 2] {
    [
        LEVEL.1.format(trim.level_db),
        RINGING.1.format(trim.ringing),
    ]
}

fn words_of_none() -> [String; 2] {
    words(&Trim::NONE)
}

/// Reads a table; `notice` is told what is not understood, which stays as built, and where.
pub(super) fn read(table: &dyn TableLike, mut notice: impl FnMut(&Item, String)) -> TrimList {
    let mut trims = Trims::NONE;
    for (name, item) in table.iter() {
        let Some(label) = named_mode(name) else {
            notice(
                item,
                format!("there is no mode {name} in this version; kept"),
            );
            continue;
        };
        let Some(entry) = item.as_table_like() else {
            notice(
                item,
                format!(
                    "{name} is not trimmed so; write {{ level = \"-6 dB\", ringing = \"2 x\" }}"
                ),
            );
            continue;
        };
        let mut trim = Trim::NONE;
        for (key, item) in entry.iter() {
            let read = match key {
                "level" => number(item, LEVEL, &TRIM_DB).map(|level_db| trim.level_db = level_db),
                "ringing" => {
                    number(item, RINGING, &TRIM_RINGING).map(|ringing| trim.ringing = ringing)
                }
                _ => Err(format!("there is no {key} of a mode in this version; kept")),
            };
            if let Err(what) = read {
                notice(item, format!("{name}: {what}"));
            }
        }
        if !trims.set(&label, trim) {
            notice(
                item,
                format!("{name} is as built: there is room for {MOST_TRIMS} modes"),
            );
        }
    }
    trims.all().collect()
}

/// One of the numbers, or what is wrong with it.
fn number(
    item: &Item,
    (key, text): (&str, Text),
    range: &RangeInclusive<f64>,
) -> Result<f32, String> {
    let read = item.as_str().and_then(|said| text.parse(said));
    let read = read.filter(|number| range.contains(number));
    let [least, most] = [range.start(), range.end()].map(|end| text.format(*end as f32));
    read.map(|number| number as f32).ok_or_else(|| {
        let said = item.to_string();
        format!(
            "{key} is not to be had as {}; write {least} to {most}",
            said.trim()
        )
    })
}

/// Writes a list over an older one; what was not understood stays.
pub(super) fn write(table: &mut Table, old: &TrimList, new: &TrimList) {
    for (label, _) in old {
        let name = mode_name(label);
        if !new.iter().any(|(other, _)| other == label)
            && let Some(item) = table.get_mut(&name)
        {
            put(item, &Trim::NONE);
            if item.as_table_like().is_none_or(TableLike::is_empty) {
                table.remove(&name);
            }
        }
    }
    for (label, trim) in new {
        let item = table.entry(&mode_name(label)).or_insert(Item::None);
        if !item.is_table_like() {
            *item = Item::Value(Value::InlineTable(InlineTable::new()));
        }
        put(item, trim);
    }
}

/// Writes one; what is as built is not said.
fn put(item: &mut Item, trim: &Trim) {
    let Some(entry) = item.as_table_like_mut() else {
        return;
    };
    let none = words_of_none();
    for (((key, _), said), usual) in [LEVEL, RINGING].into_iter().zip(words(trim)).zip(none) {
        if said == usual {
            entry.remove(key);
        } else {
            entry.insert(key, value(said));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::presets::{Preset, Sound};

    fn read_text(text: &str) -> Preset {
        Preset::read(text, "A.toml").unwrap()
    }

    fn label(name: &str) -> ModeLabel {
        named_mode(name).unwrap()
    }

    fn trim(level_db: f32, ringing: f32) -> Trim {
        Trim { level_db, ringing }
    }

    #[test]
    fn trims_are_readable_and_read_back() {
        let mut trims = Trims::NONE;
        trims.set(&label("bending 2 a"), trim(-6.0, 2.0));
        trims.set(&label("wall (2,3) b"), trim(1.5, 1.0));
        let sound = Sound {
            trims: trims.all().collect(),
            ..Sound::default()
        };
        let preset = Preset::init(0).with(Preset::init(0).card, sound);
        let text = preset.text();
        let end = "\n[trims]\n\"bending 2 a\" = { level = \"-6.00 dB\", ringing = \"2.00 x\" }\n\
                   \"wall (2,3) b\" = { level = \"1.50 dB\" }\n";
        assert!(text.ends_with(end), "{text}");
        let read = read_text(&text);
        assert_eq!(
            (&read.sound.trims, &*read.notices),
            (&preset.sound.trims, &[][..])
        );
        let bare = read.with(read.card.clone(), Sound::default());
        assert!(!bare.text().contains("bending"), "{}", bare.text());
    }

    #[test]
    fn what_is_not_understood_is_noticed_and_stays_word_for_word() {
        let text = "name = \"A\"\n[sound]\n\n[trims]\n\"warp 3\" = { level = \"-6 dB\" } # later\n\
                    \"bending 1 a\" = { level = \"-3.00 dB\", pan = \"left\" }\n\
                    \"bending 2 a\" = { level = \"loud\" }\n\"bending 3 a\" = 7\n\
                    \"bending 4 a\" = { ringing = \"9 x\" }\n";
        let preset = read_text(text);
        let lines: Vec<_> = preset.notices.iter().map(|notice| notice.line).collect();
        assert_eq!(lines, [5, 6, 7, 8, 9]);
        assert!(
            preset.notices[4].what.contains("0.125 x to 8.00 x"),
            "{:?}",
            preset.notices
        );
        assert_eq!(
            preset.sound.trims,
            [(label("bending 1 a"), trim(-3.0, 1.0))]
        );
        assert_eq!(preset.text(), text);
        let again = preset.with(preset.card.clone(), preset.sound.clone());
        assert_eq!(again.text(), text);
        let bare = preset.with(preset.card.clone(), Sound::default());
        assert_eq!(
            bare.text(),
            text.replace("level = \"-3.00 dB\", pan", "pan")
        );
        let set = Sound {
            trims: vec![(label("bending 3 a"), trim(-1.0, 1.0))],
            ..Sound::default()
        };
        let set = preset.with(preset.card.clone(), set).text();
        assert!(
            set.contains("\n\"bending 3 a\" = { level = \"-1.00 dB\" }\n"),
            "{set}"
        );
        assert!(
            set.contains("\"warp 3\" = { level = \"-6 dB\" } # later"),
            "{set}"
        );
    }

    #[test]
    fn more_than_there_is_room_for_stays_in_the_file() {
        let mut text = "name = \"A\"\n[sound]\n[trims]\n".to_owned();
        for index in 1..=MOST_TRIMS + 1 {
            text += &format!("\"mode {index}\" = {{ level = \"-6.00 dB\" }}\n");
        }
        let preset = read_text(&text);
        assert_eq!(preset.sound.trims.len(), MOST_TRIMS);
        assert_eq!(preset.notices.len(), 1);
        assert_eq!(
            preset
                .with(preset.card.clone(), preset.sound.clone())
                .text(),
            text
        );
    }

    #[test]
    fn lists_that_read_the_same_are_the_same() {
        let list = |level_db| vec![(label("mode 1"), trim(level_db, 1.0))];
        assert!(same(&list(-3.0), &list(-3.001)));
        assert!(!same(&list(-3.0), &list(-3.1)));
        assert!(same(&list(0.001), &TrimList::new()));
    }
}
