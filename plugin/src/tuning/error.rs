//! Why the MTS-ESP library cannot be used.

use std::path::PathBuf;
use thiserror::Error;

/// Why a library is not that of MTS-ESP.
#[derive(Debug, Error)]
pub enum MtsError {
    /// The system does not load it.
    #[error("{}: cannot load the MTS-ESP library: {error}; install it again", path.display())]
    Load {
        /// The library.
        path: PathBuf,
        /// What the system says.
        error: libloading::Error,
    },
    /// It lacks a function.
    #[error("{}: not an MTS-ESP library: it has no {function}; install it again", path.display())]
    Function {
        /// The library.
        path: PathBuf,
        /// The function.
        function: &'static str,
    },
    /// Its table of frequencies is not where a table can be.
    #[error("{}: the MTS-ESP library has no table of frequencies; install it again", path.display())]
    Table {
        /// The library.
        path: PathBuf,
    },
}
