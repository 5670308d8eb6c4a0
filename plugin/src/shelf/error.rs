//! Why a bank cannot be the user's own instrument.

use modes::{BankError, BankFileError};
use std::io;
use std::path::PathBuf;
use thiserror::Error;

/// What is wrong with it, and what would help.
#[derive(Debug, Error)]
pub enum OwnError {
    /// Its file.
    #[error(transparent)]
    File(#[from] BankFileError),
    /// No copy of its file, or of a mesh's, can be kept.
    #[error("{}: cannot be copied into your folder of banks: {error}", path.display())]
    Copy {
        /// The file.
        path: PathBuf,
        /// What the system says.
        error: io::Error,
    },
    /// Its content, in a song.
    #[error("\"{title}\": {error}")]
    Bank {
        /// What the song calls it; its name without a title.
        title: String,
        /// What is wrong with it.
        error: BankError,
    },
    /// It has nothing to strike.
    #[error("\"{title}\" has no body that can be struck; build it with keys within 0 to 127")]
    Silent {
        /// What it is called.
        title: String,
    },
    /// It is too large to travel in a song.
    #[error(
        "\"{title}\" takes {found_mib} MiB, and a song carries {most_mib} at most; build it with fewer \
         keys or a lower highest_hz"
    )]
    Large {
        /// What it is called.
        title: String,
        /// What it takes, in MiB.
        found_mib: usize,
        /// What it may take, in MiB.
        most_mib: usize,
    },
    /// The song keeps it in a way that came later.
    #[error(
        "\"{title}\" is kept as of layout {found}, and the newest that this version reads is {newest}; \
         update Idiophone"
    )]
    Newer {
        /// What the song calls it.
        title: String,
        /// Layout in the song.
        found: u32,
        /// Newest layout that can be read.
        newest: u32,
    },
    /// What the song keeps is damaged.
    #[error("\"{title}\" is damaged in the song ({what}); load its file again")]
    Damaged {
        /// What the song calls it, as far as that can be read.
        title: String,
        /// What shows it.
        what: String,
    },
}
