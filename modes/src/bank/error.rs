//! What can be wrong with a bank.

use std::io;
use std::path::PathBuf;
use thiserror::Error;

/// Why bytes are not a bank that can be played.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum BankError {
    /// The file ends too soon.
    #[error(
        "the bank is cut off: {found} bytes of {expected}; copy it again or build it anew with \
         `cargo xtask precompute`"
    )]
    Truncated {
        /// Length that the file states, in bytes.
        expected: u64,
        /// Length found, in bytes.
        found: u64,
    },
    /// The content is not what was written.
    #[error(
        "the bank is damaged: its content does not match its checksum; copy it again or build it \
         anew with `cargo xtask precompute`"
    )]
    Corrupted,
    /// Something else than a bank.
    #[error("this is not an Idiophone bank; choose a file made by `cargo xtask precompute`")]
    Foreign,
    /// Made by a later version of this software.
    #[error(
        "the bank is of format {found}, and the newest that this version reads is {newest}; \
         update Idiophone or build the bank anew with `cargo xtask precompute`"
    )]
    FutureVersion {
        /// Format version of the file.
        found: u32,
        /// Newest format version that can be read.
        newest: u32,
    },
    /// Made by an earlier version of this software.
    #[error(
        "the bank is of format {found}, which this version no longer reads; build it anew with \
         `cargo xtask precompute`"
    )]
    PastVersion {
        /// Format version of the file.
        found: u32,
    },
    /// Whole and undamaged, but not a possible bank.
    #[error("the bank's {field} is {value}, but must be {allowed}; build it anew")]
    Inconsistent {
        /// The field, as in `key 74: mode 3: hz`.
        field: String,
        /// What it holds.
        value: String,
        /// What it may hold.
        allowed: &'static str,
    },
}

/// Why a bank cannot be loaded from or saved to a file.
#[derive(Debug, Error)]
pub enum BankFileError {
    /// The file cannot be read.
    #[error("{}: cannot read the bank: {error}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// What the system says.
        error: io::Error,
    },
    /// The file cannot be written.
    #[error("{}: cannot write the bank: {error}", path.display())]
    Write {
        /// The file.
        path: PathBuf,
        /// What the system says.
        error: io::Error,
    },
    /// What is in the file, or what was to be put in it, is not a bank.
    #[error("{}: {error}", path.display())]
    Content {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        error: BankError,
    },
}

impl BankError {
    pub(super) fn inconsistent(
        field: impl Into<String>,
        value: impl ToString,
        allowed: &'static str,
    ) -> Self {
        Self::Inconsistent {
            field: field.into(),
            value: value.to_string(),
            allowed,
        }
    }

    /// Puts `place` in front of the field of an [`Self::Inconsistent`].
    pub(super) fn within(self, place: impl std::fmt::Display) -> Self {
        match self {
            Self::Inconsistent {
                field,
                value,
                allowed,
            } => Self::Inconsistent {
                field: format!("{place}: {field}"),
                value,
                allowed,
            },
            other => other,
        }
    }
}
