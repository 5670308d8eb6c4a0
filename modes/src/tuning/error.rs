//! What can be wrong with a scale or a keyboard map.

use std::io;
use std::path::PathBuf;
use thiserror::Error;

/// Why a text is not a scale or a keyboard map.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum ScalaError {
    /// A line is not what it should be.
    #[error("line {line}: \"{found}\": {fault}")]
    Line {
        /// Line, counted from 1.
        line: usize,
        /// The line's text, or the start of it.
        found: String,
        /// What is wrong, and what is allowed.
        fault: String,
    },
    /// The file ends too soon.
    #[error("line {line}: the file ends here, but {missing} must follow")]
    End {
        /// The last line, counted from 1.
        line: usize,
        /// What should follow.
        missing: String,
    },
}

/// Why a tuning cannot be loaded from files.
#[derive(Debug, Error)]
pub enum TuningFileError {
    /// The file cannot be read.
    #[error("{}: cannot read it: {error}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// What the system says.
        error: io::Error,
    },
    /// The file is not a scale, or not a keyboard map.
    #[error("{}: {error}", path.display())]
    Content {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        error: ScalaError,
    },
}
