//! Tunings from files.

use super::lines::decode;
use super::{KeyboardMap, ScalaError, Scale, Tuning, TuningFileError};
use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

/// Longest file, in bytes: whatever is longer is neither a scale nor a map.
const MAX_LEN: u64 = 1 << 20;

impl Scale {
    /// The scale in the `.scl` file at `path`.
    ///
    /// # Errors
    ///
    /// If the file cannot be read or [`Self::parse`] refuses it.
    pub fn load(path: &Path) -> Result<Self, TuningFileError> {
        load(path, Self::parse)
    }

    /// The text of the `.scl` file at `path`, in which [`Self::parse`] finds a scale.
    ///
    /// # Errors
    ///
    /// As [`Self::load`].
    pub fn load_text(path: &Path) -> Result<String, TuningFileError> {
        load(path, |file| Self::parse(file).map(|_| decode(file)))
    }
}

impl KeyboardMap {
    /// The map in the `.kbm` file at `path`.
    ///
    /// # Errors
    ///
    /// If the file cannot be read or [`Self::parse`] refuses it.
    pub fn load(path: &Path) -> Result<Self, TuningFileError> {
        load(path, Self::parse)
    }

    /// The text of the `.kbm` file at `path`, in which [`Self::parse`] finds a map.
    ///
    /// # Errors
    ///
    /// As [`Self::load`].
    pub fn load_text(path: &Path) -> Result<String, TuningFileError> {
        load(path, |file| Self::parse(file).map(|_| decode(file)))
    }
}

impl Tuning {
    /// The tuning of a `.scl` and a `.kbm` file; in place of one that is not given, twelve equal
    /// steps to the octave, or one degree to a key with degree 0 on key 60 and 440 Hz on key 69.
    ///
    /// # Errors
    ///
    /// Names the file that cannot be read or is not what it should be.
    pub fn load(scl: Option<&Path>, kbm: Option<&Path>) -> Result<Self, TuningFileError> {
        let scale = scl.map(Scale::load).transpose()?.unwrap_or_default();
        let map = kbm.map(KeyboardMap::load).transpose()?.unwrap_or_default();
        Ok(Self::new(&scale, &map))
    }
}

fn load<T>(
    path: &Path,
    parse: impl Fn(&[u8]) -> Result<T, ScalaError>,
) -> Result<T, TuningFileError> {
    let content = read(path).map_err(|error| TuningFileError::Read {
        path: path.to_path_buf(),
        error,
    })?;
    parse(&content).map_err(|error| TuningFileError::Content {
        path: path.to_path_buf(),
        error,
    })
}

fn read(path: &Path) -> io::Result<Vec<u8>> {
    let mut content = Vec::new();
    let mut file = File::open(path)?.take(MAX_LEN + 1);
    file.read_to_end(&mut content)?;
    if file.limit() == 0 {
        let message = "longer than 1 MiB; choose a scale (.scl) or a keyboard map (.kbm)";
        return Err(io::Error::new(io::ErrorKind::FileTooLarge, message));
    }
    Ok(content)
}
