//! The user's presets, as files in a folder.

use super::broken::Broken;
use super::files::{free, stem, write};
use super::preset::Preset;
use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};

/// Ending of a preset's file.
const ENDING: &str = "toml";
/// Where deleted ones go, within the folder.
const DELETED: &str = "Deleted";
/// No preset is as long, in bytes.
const LONGEST: u64 = 1 << 20;

/// A folder of presets; it need not be there yet.
#[derive(Clone, Debug)]
pub struct Folder {
    path: PathBuf,
}

impl Folder {
    /// The folder at `path`.
    #[must_use]
    pub fn new(path: PathBuf) -> Self {
        Self { path }
    }

    /// Where it is.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The names of the presets' files, in their order; none if there is no folder.
    #[must_use]
    pub fn files(&self) -> Vec<String> {
        let found = fs::read_dir(&self.path).into_iter().flatten().flatten();
        let name = |entry: fs::DirEntry| {
            let name = entry.file_name().into_string().ok()?;
            let is_preset = Path::new(&name).extension() == Some(OsStr::new(ENDING));
            (is_preset && !name.starts_with('.') && entry.path().is_file()).then_some(name)
        };
        let mut names: Vec<_> = found.filter_map(name).collect();
        names.sort_by_key(|name| name.to_lowercase());
        names
    }

    /// Reads the preset in a file.
    ///
    /// # Errors
    ///
    /// What cannot be read, and why.
    pub fn read(&self, file: &str) -> Result<Preset, Broken> {
        read(&self.path.join(file))
    }

    /// Writes a preset: over `file`, or to a new one, whose name is given.
    ///
    /// # Errors
    ///
    /// What no file can be called, and what the system refuses.
    pub fn save(&self, preset: &Preset, file: Option<&str>) -> Result<String, Broken> {
        let path = match file {
            Some(file) => self.path.join(file),
            None => free(&self.path, &stem(&preset.card.name)?, ENDING),
        };
        write(&path, &preset.text())?;
        Ok(name(&path))
    }

    /// Gives the preset in a file, and the file, another name, which is given.
    ///
    /// # Errors
    ///
    /// As for reading and saving; then all is as it was.
    pub fn rename(&self, file: &str, to: &str) -> Result<String, Broken> {
        let mut preset = self.read(file)?;
        preset.rename(to);
        if stem(&preset.card.name)? == file.trim_end_matches(".toml") {
            return self.save(&preset, Some(file));
        }
        let new = self.save(&preset, None)?;
        let old = self.path.join(file);
        fs::remove_file(&old).map_err(Broken::at(&old))?;
        Ok(new)
    }

    /// Moves a file to the folder of deleted ones, where it is now.
    ///
    /// # Errors
    ///
    /// What the system refuses.
    pub fn delete(&self, file: &str) -> Result<PathBuf, Broken> {
        let bin = self.path.join(DELETED);
        fs::create_dir_all(&bin).map_err(Broken::at(&bin))?;
        let from = self.path.join(file);
        let to = free(&bin, file.trim_end_matches(".toml"), ENDING);
        fs::rename(&from, &to).map_err(Broken::at(&from))?;
        Ok(to)
    }

    /// Copies a preset's file from elsewhere, as it is; the name of the copy.
    ///
    /// # Errors
    ///
    /// What cannot be read as a preset.
    pub fn import(&self, from: &Path) -> Result<String, Broken> {
        let preset = read(from)?;
        self.save(&preset, None)
    }
}

/// Writes a preset to a file anywhere.
///
/// # Errors
///
/// What the system refuses.
pub(super) fn export(preset: &Preset, to: &Path) -> Result<(), Broken> {
    write(to, &preset.text())
}

fn name(path: &Path) -> String {
    let name = path.file_name().unwrap_or_default();
    name.to_string_lossy().into_owned()
}

fn read(path: &Path) -> Result<Preset, Broken> {
    let file = name(path);
    let broken = |what: String| Broken::Text {
        file: file.clone(),
        line: 1,
        what,
    };
    let length = fs::metadata(path).map_err(Broken::at(path))?.len();
    if length > LONGEST {
        let what = "too long for a preset; move the file elsewhere".to_owned();
        return Err(broken(what));
    }
    let bytes = fs::read(path).map_err(Broken::at(path))?;
    let text = String::from_utf8(bytes).map_err(|error| {
        let good = error.utf8_error().valid_up_to();
        let lines = error.as_bytes()[..good]
            .iter()
            .filter(|byte| **byte == b'\n');
        Broken::Text {
            file: file.clone(),
            line: 1 + lines.count(),
            what: "no text in UTF-8; save it so in a text editor".to_owned(),
        }
    })?;
    Preset::read(&text, &file)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::presets::{Card, Sound};

    fn named(name: &str) -> Preset {
        let card = Card {
            name: name.to_owned(),
            ..Card::default()
        };
        Preset::new(card, Sound::default())
    }

    #[test]
    fn presets_are_saved_renamed_and_put_aside() {
        let home = tempfile::tempdir().unwrap();
        let folder = Folder::new(home.path().join("Presets"));
        assert_eq!(folder.files(), [""; 0]);
        assert_eq!(folder.save(&named("B"), None).unwrap(), "B.toml");
        assert_eq!(folder.save(&named("B"), None).unwrap(), "B 2.toml");
        assert_eq!(folder.save(&named("C"), Some("B.toml")).unwrap(), "B.toml");
        assert_eq!(folder.read("B.toml").unwrap().card.name, "C");
        assert_eq!(folder.rename("B 2.toml", "a/b").unwrap(), "a-b.toml");
        assert_eq!(folder.rename("a-b.toml", "a:b").unwrap(), "a-b.toml");
        assert_eq!(folder.read("a-b.toml").unwrap().card.name, "a:b");
        assert_eq!(folder.files(), ["a-b.toml", "B.toml"]);
        assert!(folder.rename("B.toml", "//").is_err());
        let bin = folder.delete("B.toml").unwrap();
        assert!(bin.is_file());
        folder.save(&named("B"), None).unwrap();
        assert_ne!(folder.delete("B.toml").unwrap(), bin);
        assert_eq!(folder.files(), ["a-b.toml"]);
    }

    #[test]
    fn files_go_out_and_come_in_as_they_are() {
        let home = tempfile::tempdir().unwrap();
        let folder = Folder::new(home.path().join("Presets"));
        let out = home.path().join("out.toml");
        let text = "name = \"A\" # from afar\nlater = 1\n[sound]\n";
        export(&Preset::read(text, "a").unwrap(), &out).unwrap();
        assert_eq!(folder.import(&out).unwrap(), "A.toml");
        assert_eq!(
            fs::read_to_string(folder.path().join("A.toml")).unwrap(),
            text
        );
        fs::write(&out, "name = ").unwrap();
        assert!(folder.import(&out).is_err());
        assert!(folder.import(&home.path().join("none.toml")).is_err());
    }

    #[test]
    fn what_is_no_text_is_said_to_be_so() {
        let home = tempfile::tempdir().unwrap();
        let folder = Folder::new(home.path().to_owned());
        fs::write(home.path().join("x.toml"), b"name = \"A\"\n\xff").unwrap();
        let error = folder.read("x.toml").unwrap_err().to_string();
        assert!(error.starts_with("x.toml, line 2: "), "{error}");
        fs::write(
            home.path().join("y.toml"),
            vec![b'#'; (LONGEST + 1) as usize],
        )
        .unwrap();
        assert!(folder.read("y.toml").is_err());
    }
}
