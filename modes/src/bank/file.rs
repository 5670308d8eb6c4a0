//! Banks in files.

use super::format::{MAX_LEN, PRELUDE_LEN};
use super::read::stated_len;
use super::{Bank, BankError, BankFileError};
use std::fs::{self, File};
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};

impl Bank {
    /// The bank in the file at `path`.
    ///
    /// Of a file that is no bank, only the first bytes are read.
    ///
    /// # Errors
    ///
    /// If the file cannot be read or is not a bank that [`Bank::read`] takes.
    pub fn load(path: impl AsRef<Path>) -> Result<Self, BankFileError> {
        let path = path.as_ref().to_path_buf();
        let mut content = Vec::new();
        let start = File::open(&path).and_then(|file| {
            let mut start = file.take(PRELUDE_LEN as u64);
            start.read_to_end(&mut content)?;
            Ok(start)
        });
        let mut start = match start {
            Ok(start) => start,
            Err(error) => return Err(BankFileError::Read { path, error }),
        };
        let len = match stated_len(&content) {
            Ok(len) => len,
            Err(error) => return Err(BankFileError::Content { path, error }),
        };
        // One byte more than stated shows a file that is too long.
        start.set_limit(len + 1 - PRELUDE_LEN as u64);
        if let Err(error) = start.read_to_end(&mut content) {
            return Err(BankFileError::Read { path, error });
        }
        Self::read(&content).map_err(|error| BankFileError::Content { path, error })
    }

    /// Puts the bank into the file at `path`, whole or not at all: a temporary file beside it
    /// takes its place once it is written.
    ///
    /// # Errors
    ///
    /// If [`Bank::check`] refuses the bank or the file cannot be written.
    pub fn save(&self, path: impl AsRef<Path>) -> Result<(), BankFileError> {
        let path = path.as_ref().to_path_buf();
        if let Err(error) = self.check() {
            return Err(BankFileError::Content { path, error });
        }
        let content = self.write();
        if content.len() as u64 > MAX_LEN {
            let error = BankError::inconsistent("length", content.len(), "at most 1 GiB");
            return Err(BankFileError::Content { path, error });
        }
        write_whole(&path, &content).map_err(|error| BankFileError::Write { path, error })
    }
}

fn write_whole(path: &Path, content: &[u8]) -> io::Result<()> {
    let mut name = path
        .file_name()
        .ok_or(io::ErrorKind::InvalidFilename)?
        .to_owned();
    name.push(format!(".{}.tmp", std::process::id()));
    let temporary = Temporary(path.with_file_name(name));
    let mut file = File::create(&temporary.0)?;
    file.write_all(content)?;
    file.sync_all()?;
    drop(file);
    fs::rename(&temporary.0, path)
}

/// A file that goes when this does, unless it was renamed.
struct Temporary(PathBuf);

impl Drop for Temporary {
    fn drop(&mut self) {
        // After the rename there is nothing left to remove.
        let _ = fs::remove_file(&self.0);
    }
}

#[cfg(test)]
mod tests {
    use super::super::sample::bank;
    use super::*;

    /// A new empty folder, and a name in it.
    fn folder(name: &str) -> PathBuf {
        let folder = std::env::temp_dir().join(format!("idiophone-{name}-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        folder
    }

    #[test]
    fn a_saved_bank_loads() {
        let folder = folder("save");
        let path = folder.join("a.bank");
        bank().save(&path).unwrap();
        bank().save(&path).unwrap();
        assert_eq!(Bank::load(&path).unwrap(), bank());
        assert_eq!(fs::read_dir(&folder).unwrap().count(), 1);
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn an_impossible_bank_leaves_the_file_alone() {
        let folder = folder("refuse");
        let path = folder.join("a.bank");
        bank().save(&path).unwrap();
        let mut bad = bank();
        bad.bodies[1].mass_kg = -1.0;
        let message = bad.save(&path).unwrap_err().to_string();
        assert!(message.contains("a.bank: the bank's key 74: mass_kg is -1"));
        assert_eq!(Bank::load(&path).unwrap(), bank());
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn nothing_half_written_stays_where_no_file_can_be() {
        let folder = folder("folder");
        fs::create_dir(folder.join("a.bank")).unwrap();
        let error = bank().save(folder.join("a.bank")).unwrap_err();
        assert!(matches!(error, BankFileError::Write { .. }));
        assert_eq!(fs::read_dir(&folder).unwrap().count(), 1);
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn errors_name_the_file_on_one_line() {
        let folder = folder("load");
        let path = folder.join("a.bank");
        let missing = Bank::load(&path).unwrap_err();
        assert!(matches!(missing, BankFileError::Read { .. }));
        fs::write(&path, b"RIFF").unwrap();
        let foreign = Bank::load(&path).unwrap_err();
        fs::write(&path, [bank().write(), vec![0]].concat()).unwrap();
        let too_long = Bank::load(&path).unwrap_err();
        let content = |error: &BankFileError| match error {
            BankFileError::Content { error, .. } => Some(error.clone()),
            _ => None,
        };
        assert_eq!(content(&foreign), Some(BankError::Foreign));
        assert_eq!(content(&too_long), Some(BankError::Corrupted));
        for error in [missing, foreign, too_long] {
            let message = error.to_string();
            assert!(message.contains("a.bank: ") && !message.contains('\n'));
        }
        fs::remove_dir_all(folder).unwrap();
    }

    #[cfg(unix)]
    #[test]
    fn endless_files_are_not_read_to_their_end() {
        let error = Bank::load("/dev/zero").unwrap_err();
        assert!(matches!(
            error,
            BankFileError::Content {
                error: BankError::Foreign,
                ..
            }
        ));
    }
}
