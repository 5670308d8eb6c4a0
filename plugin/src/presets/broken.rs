//! Why a preset or its file cannot be had.

use std::io;
use std::path::{Path, PathBuf};
use thiserror::Error;

/// What is wrong, where, and what helps.
#[derive(Debug, Error)]
pub enum Broken {
    /// The text is no preset.
    #[error("{file}, line {line}: {what}")]
    Text {
        /// Name of the file.
        file: String,
        /// Counted from 1.
        line: usize,
        /// What is wrong there, and the cure.
        what: String,
    },
    /// The system refuses.
    #[error("{}: {error}", path.display())]
    File {
        /// Of the file or folder.
        path: PathBuf,
        /// What it says.
        error: io::Error,
    },
    /// A name that no file can have.
    #[error("\"{0}\" is no name for a preset; write letters or digits")]
    Name(String),
    /// There is no place for a user's files.
    #[error("this system names no folder for a user's files; set HOME")]
    Homeless,
}

impl Broken {
    /// For `map_err`: the system refuses something about `path`.
    pub(super) fn at(path: &Path) -> impl FnOnce(io::Error) -> Self {
        let path = path.to_owned();
        move |error| Self::File { path, error }
    }
}
