//! From a file's text to a preset.

use super::broken::Broken;
use super::card::Card;
use super::line::line;
use super::preset::{FORMAT, Notice, Preset};
use super::sound::{Scala, Sound};
use crate::params::specs;
use toml_edit::{Document, Item, TableLike, TomlError};

impl Preset {
    /// Reads a text; `file` is for messages.
    ///
    /// What a later version has written and what else is not understood is noticed, and stays.
    ///
    /// # Errors
    ///
    /// What is no TOML, has no name or no sound, or has something else where these are.
    pub fn read(text: &str, file: &str) -> Result<Self, Broken> {
        let document = Document::parse(text).map_err(|error| syntax(&error, text, file))?;
        let reader = Reader { text, file };
        let root = document.as_table();
        let card = reader.card(root)?;
        let mut notices = Vec::new();
        reader.format(root, &mut notices);
        let mut unread = Vec::new();
        let Some(table) = root.get("sound").and_then(Item::as_table_like) else {
            let what =
                "there is no sound; write [sound] and below it lines such as gain = \"0.00 dB\"";
            return Err(reader.broken(root.get("sound"), what.to_owned()));
        };
        let values = reader.values(table, &mut notices, &mut unread);
        let scala = reader.scala(root)?;
        Ok(Self {
            card,
            sound: Sound { values, scala },
            notices,
            unread,
            document: document.into_mut(),
        })
    }
}

fn syntax(error: &TomlError, text: &str, file: &str) -> Broken {
    let what = error.message().lines().collect::<Vec<_>>().join(", ");
    Broken::Text {
        file: file.to_owned(),
        line: line(text, error.span()),
        what: format!("{what}; mend the line, or delete it"),
    }
}

/// A text that is being read.
struct Reader<'a> {
    text: &'a str,
    file: &'a str,
}

/// Longest list of what may be written that a message gives.
const LIST: usize = 120;

impl Reader<'_> {
    fn line(&self, item: Option<&Item>) -> usize {
        line(self.text, item.and_then(Item::span))
    }

    fn broken(&self, item: Option<&Item>, what: String) -> Broken {
        Broken::Text {
            file: self.file.to_owned(),
            line: self.line(item),
            what,
        }
    }

    /// A text that may be missing.
    fn words(&self, table: &dyn TableLike, key: &str) -> Result<String, Broken> {
        let Some(item) = table.get(key) else {
            return Ok(String::new());
        };
        let text = item.as_str().map(str::to_owned);
        text.ok_or_else(|| {
            self.broken(
                Some(item),
                format!("{key} is no text; put it in quotation marks"),
            )
        })
    }

    fn card(&self, root: &dyn TableLike) -> Result<Card, Broken> {
        let name = self.words(root, "name")?.trim().to_owned();
        if name.is_empty() {
            let what = "there is no name; write a line such as name = \"Soft yarn\"";
            return Err(self.broken(root.get("name"), what.to_owned()));
        }
        let mut tags = Vec::new();
        if let Some(item) = root.get("tags") {
            let wrong = || {
                let what = "tags are no list of texts; write tags = [\"warm\", \"soft\"]";
                self.broken(Some(item), what.to_owned())
            };
            for tag in item.as_array().ok_or_else(wrong)? {
                tags.push(tag.as_str().ok_or_else(wrong)?.to_owned());
            }
        }
        Ok(Card {
            name,
            category: self.words(root, "category")?,
            tags,
            author: self.words(root, "author")?,
            about: self.words(root, "about")?,
        })
    }

    fn format(&self, root: &dyn TableLike, notices: &mut Vec<Notice>) {
        let item = root.get("format");
        let format = item.and_then(Item::as_integer).unwrap_or(FORMAT);
        if format > FORMAT {
            notices.push(Notice {
                line: self.line(item),
                what: format!(
                    "written by a later version, in format {format}; this one knows {FORMAT} and loads what it \
                     understands"
                ),
            });
        }
    }

    fn values(
        &self,
        table: &dyn TableLike,
        notices: &mut Vec<Notice>,
        unread: &mut Vec<String>,
    ) -> Vec<(&'static crate::params::Spec, f32)> {
        let mut values = Vec::new();
        for (id, item) in table.iter() {
            let mut notice = |what| {
                let line = self.line(Some(item));
                notices.push(Notice { line, what });
            };
            let Some(spec) = specs().find(|spec| spec.id == id) else {
                notice(format!("there is no parameter {id} in this version; kept"));
                continue;
            };
            match item.as_str().and_then(|text| spec.parse(text)) {
                Some(value) => values.push((spec, value)),
                None => {
                    unread.push(id.to_owned());
                    let said = item.to_string();
                    let mut allowed = spec.allowed();
                    if allowed.len() > LIST {
                        allowed = format!("one of the names that {} lists", spec.name);
                    }
                    notice(format!(
                        "{} is not to be had as {}; {} instead, write {allowed}",
                        spec.name,
                        said.trim(),
                        spec.format(spec.default)
                    ));
                }
            }
        }
        values
    }

    fn scala(&self, root: &dyn TableLike) -> Result<Scala, Broken> {
        let Some(item) = root.get("tuning") else {
            return Ok(Scala::default());
        };
        let table = item.as_table_like().ok_or_else(|| {
            let what = "tuning is no table; write [tuning] and below it scale = '''…'''";
            self.broken(Some(item), what.to_owned())
        })?;
        Ok(Scala {
            scale: self.words(table, "scale")?,
            keyboard: self.words(table, "keyboard")?,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FUTURE: &str = "\
        format = 7\nname = \"Glass\"\nmood = \"blue\"\n\n[sound]\ninstr = \"Glass harp\"\nwarp = \"3 x\"\n\
        size = \"2 x\"\n\n[space]\nroom = \"hall\"\n";

    #[test]
    fn what_is_not_understood_is_noticed_and_the_rest_loads() {
        let preset = Preset::read(FUTURE, "Glass.toml").unwrap();
        assert_eq!(preset.sound.get("size"), Some(2.0));
        assert_eq!(preset.sound.get("instr"), None);
        let lines: Vec<_> = preset.notices.iter().map(|notice| notice.line).collect();
        assert_eq!(lines, [1, 6, 7]);
        assert!(preset.notices[1].what.contains("Glass harp"));
        assert!(preset.notices[1].what.contains("Wind chimes"));
        assert!(preset.notices[2].what.contains("warp"));
        assert_eq!(preset.text(), FUTURE);
    }

    #[test]
    fn what_is_broken_says_where_and_what_helps() {
        for (text, line, says) in [
            ("name = \"A\"\n[sound\n", 2, "mend"),
            ("name = \"A\"\nsize = \n", 2, "mend"),
            ("[sound]\n", 1, "name = "),
            ("name = \" \"\n[sound]\n", 1, "name = "),
            ("name = \"A\"\n", 1, "[sound]"),
            ("name = \"A\"\nsound = 3\n", 2, "[sound]"),
            ("name = \"A\"\ntags = \"soft\"\n[sound]\n", 2, "tags = ["),
            ("name = \"A\"\n\nabout = 3\n[sound]\n", 3, "quotation marks"),
            ("name = \"A\"\ntuning = 1\n[sound]\n", 2, "[tuning]"),
        ] {
            let error = Preset::read(text, "A.toml").unwrap_err().to_string();
            assert!(
                error.starts_with(&format!("A.toml, line {line}: ")),
                "{error}"
            );
            assert!(error.contains(says), "{error}");
        }
    }

    #[test]
    fn any_truncation_is_read_or_refused() {
        let text = crate::presets::factory()[0].text();
        for end in (0..text.len()).filter(|end| text.is_char_boundary(*end)) {
            let _ = Preset::read(&text[..end], "cut.toml");
        }
    }
}
