//! Banks kept in a folder, each under the hash of all that decides its content.

use super::{BuildError, Progress, build};
use crate::{Bank, BankFileError, CODE, Recipe, fnv};
use std::io;
use std::path::{Path, PathBuf};

/// Where a bank lies and whether it was there already.
#[derive(Clone, Debug, PartialEq)]
pub struct Built {
    /// The bank.
    pub bank: Bank,
    /// Its file.
    pub path: PathBuf,
    /// Whether it was found rather than built.
    pub found: bool,
}

/// Why there is no bank in the folder.
#[derive(Debug, thiserror::Error)]
pub enum CacheError {
    /// The recipe gave none.
    #[error(transparent)]
    Build(#[from] BuildError),
    /// It cannot be kept.
    #[error(transparent)]
    File(#[from] BankFileError),
    /// The folder cannot be made.
    #[error("{}: cannot make the folder: {error}", path.display())]
    Folder {
        /// The folder.
        path: PathBuf,
        /// What the system says.
        error: io::Error,
    },
}

/// The bank of `recipe` from `folder`, built and put there if this code has not done so before.
/// With `force`, built in any case.
///
/// # Errors
///
/// If the bank cannot be built or written. A file that does not read as a bank is built anew.
pub fn cached(
    recipe: &Recipe,
    folder: &Path,
    force: bool,
    progress: &dyn Progress,
) -> Result<Built, CacheError> {
    let identity = fnv::extend(
        fnv::extend(fnv::START, CODE.as_bytes()),
        recipe.text.as_bytes(),
    );
    let path = folder.join(format!("{}-{identity:016x}.bank", recipe.name));
    if !force && let Ok(bank) = Bank::load(&path) {
        return Ok(Built {
            bank,
            path,
            found: true,
        });
    }
    let bank = build(recipe, progress)?;
    std::fs::create_dir_all(folder).map_err(|error| CacheError::Folder {
        path: folder.to_path_buf(),
        error,
    })?;
    bank.save(&path)?;
    Ok(Built {
        bank,
        path,
        found: false,
    })
}
