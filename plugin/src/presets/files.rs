//! Files that are whole or not there, under names that every system takes.

use super::broken::Broken;
use std::fs::{self, File};
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process;
use std::sync::atomic::{AtomicU32, Ordering};

/// Longest name of a file without its number and ending, in characters.
const LONGEST: usize = 80;

/// Names that Windows keeps for itself.
const TAKEN: [&str; 6] = ["con", "prn", "aux", "nul", "com", "lpt"];

/// Writes beside `path` and renames, so that a reader finds the old file or the new one.
pub(super) fn write(path: &Path, text: &str) -> Result<(), Broken> {
    static NUMBER: AtomicU32 = AtomicU32::new(0);
    let number = NUMBER.fetch_add(1, Ordering::Relaxed);
    let folder = path.parent().unwrap_or(Path::new("."));
    fs::create_dir_all(folder).map_err(Broken::at(folder))?;
    let beside = folder.join(format!(".{}-{number}.part", process::id()));
    let written = File::create(&beside).and_then(|mut file| {
        file.write_all(text.as_bytes())?;
        file.sync_all()
    });
    let done = written.and_then(|()| fs::rename(&beside, path));
    done.map_err(|error| {
        let _ = fs::remove_file(&beside);
        Broken::at(path)(error)
    })
}

/// The stem of a file for a preset of that name.
pub(super) fn stem(name: &str) -> Result<String, Broken> {
    let safe = |c: char| !c.is_control() && !"/\\:*?\"<>|".contains(c);
    let kept = name.chars().map(|c| if safe(c) { c } else { '-' });
    let stem: String = kept.take(LONGEST).collect();
    let stem = stem.trim_matches(|c: char| c == '.' || c.is_whitespace());
    if !stem.chars().any(char::is_alphanumeric) {
        return Err(Broken::Name(name.to_owned()));
    }
    let small = stem.to_lowercase();
    let device = small.split('.').next().unwrap_or_default();
    let device = device.trim_end_matches(|c: char| c.is_ascii_digit());
    Ok(if TAKEN.contains(&device) {
        format!("{stem} preset")
    } else {
        stem.to_owned()
    })
}

/// A name in `folder` that no file has: the stem's, or with a number.
pub(super) fn free(folder: &Path, stem: &str, ending: &str) -> PathBuf {
    let plain = folder.join(format!("{stem}.{ending}"));
    let numbered = (2u32..).map(|number| folder.join(format!("{stem} {number}.{ending}")));
    let mut all = std::iter::once(plain.clone()).chain(numbered);
    // `symlink_metadata`: a link to nowhere takes a name too.
    let found = all.find(|path| path.symlink_metadata().is_err());
    found.unwrap_or(plain)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_suit_every_system() {
        assert_eq!(stem("Soft yarn").unwrap(), "Soft yarn");
        assert_eq!(stem("../../etc: a?").unwrap(), "-..-etc- a-");
        assert_eq!(stem("Com1").unwrap(), "Com1 preset");
        assert_eq!(stem(&"ä".repeat(300)).unwrap().chars().count(), LONGEST);
        for name in ["", " . ", "///"] {
            assert!(stem(name).is_err(), "{name}");
        }
    }

    #[test]
    fn files_are_replaced_and_nothing_stays_beside() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("deep/a.toml");
        write(&path, "one").unwrap();
        write(&path, "two").unwrap();
        assert_eq!(fs::read_to_string(&path).unwrap(), "two");
        assert_eq!(fs::read_dir(path.parent().unwrap()).unwrap().count(), 1);
        let next = free(path.parent().unwrap(), "a", "toml");
        assert!(next.ends_with("a 2.toml"));
    }

    #[test]
    fn what_cannot_be_written_leaves_what_was() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a");
        fs::create_dir_all(path.join("b")).unwrap();
        assert!(write(&path, "x").is_err());
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }
}
