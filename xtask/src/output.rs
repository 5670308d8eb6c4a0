//! Files that are either written whole or not at all.

use anyhow::{Context, Result, bail};
use std::fs::{self, File};
use std::path::{Path, PathBuf};

/// A file that takes its name only when it is finished.
///
/// Dropped unfinished, it leaves nothing behind.
pub(crate) struct PendingFile {
    path: PathBuf,
    temporary: PathBuf,
}

impl PendingFile {
    /// Starts a file that is to be called `path`.
    pub(crate) fn create(path: &Path) -> Result<(Self, File)> {
        let Some(name) = path.file_name() else {
            bail!("{}: names no file", path.display());
        };
        if path.is_dir() {
            bail!("{}: cannot write: is a directory", path.display());
        }
        let mut hidden = std::ffi::OsString::from(".");
        hidden.push(name);
        hidden.push(format!(".{}.part", std::process::id()));
        let temporary = path.with_file_name(hidden);
        let file = File::create(&temporary)
            .with_context(|| format!("{}: cannot write", path.display()))?;
        let path = path.to_owned();
        Ok((Self { path, temporary }, file))
    }

    /// Gives the file its name.
    pub(crate) fn finish(self) -> Result<()> {
        fs::rename(&self.temporary, &self.path)
            .with_context(|| format!("{}: cannot write", self.path.display()))
    }
}

impl Drop for PendingFile {
    fn drop(&mut self) {
        // After `finish` the name is gone and this does nothing.
        let _ = fs::remove_file(&self.temporary);
    }
}

/// Writes `bytes` as the whole of `path`.
pub(crate) fn write_whole(path: &Path, bytes: &[u8]) -> Result<()> {
    let (pending, mut file) = PendingFile::create(path)?;
    std::io::Write::write_all(&mut file, bytes)
        .with_context(|| format!("{}: cannot write", path.display()))?;
    drop(file);
    pending.finish()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn unfinished_files_leave_nothing() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("a.wav");
        drop(PendingFile::create(&path).unwrap());
        assert_eq!(fs::read_dir(dir.path()).unwrap().count(), 0);
        write_whole(&path, b"whole").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"whole");
        assert_eq!(fs::read_dir(dir.path()).unwrap().count(), 1);
    }

    #[test]
    fn the_file_is_named_in_the_error() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("missing/a.wav");
        let error = format!("{:#}", write_whole(&path, b"").unwrap_err());
        assert!(error.contains("missing/a.wav: cannot write"), "{error}");
        assert!(write_whole(dir.path(), b"").is_err());
    }
}
