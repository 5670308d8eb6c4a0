//! What can be wrong with a recipe.

use std::borrow::Cow;
use std::fmt::Display;
use std::io;
use std::path::PathBuf;
use thiserror::Error;

/// Why a text is not a recipe.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum RecipeError {
    /// Not TOML, or not the fields of a recipe.
    #[error("{file}:{line}:{column}: {message}")]
    Syntax {
        /// The file.
        file: String,
        /// Line, counted from 1.
        line: usize,
        /// Column in characters, counted from 1.
        column: usize,
        /// What is wrong and what is expected.
        message: String,
    },
    /// A value out of its range.
    #[error("{file}: {field} is {value}, but must be {allowed}")]
    Field {
        /// The file.
        file: String,
        /// The field, as in `body.wall_m` or `piece 2: body.wall_m`.
        field: Cow<'static, str>,
        /// What the file says.
        value: String,
        /// What it may say.
        allowed: String,
    },
}

/// Why a recipe cannot be loaded from a file.
#[derive(Debug, Error)]
pub enum RecipeFileError {
    /// The file cannot be read.
    #[error("{}: cannot read the recipe: {error}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// What the system says.
        error: io::Error,
    },
    /// The file is not a recipe.
    #[error(transparent)]
    Content(#[from] RecipeError),
}

/// An error that does not know its file yet.
#[derive(Debug)]
pub(super) enum Fault {
    Syntax {
        line: usize,
        column: usize,
        message: String,
    },
    Field {
        field: Cow<'static, str>,
        value: String,
        allowed: String,
    },
}

impl Fault {
    pub(super) fn field(
        field: &'static str,
        value: impl ToString,
        allowed: impl Into<String>,
    ) -> Self {
        Self::Field {
            field: field.into(),
            value: value.to_string(),
            allowed: allowed.into(),
        }
    }

    /// Puts `place` in front of the field.
    pub(super) fn within(self, place: impl Display) -> Self {
        match self {
            Self::Field {
                field,
                value,
                allowed,
            } => Self::Field {
                field: format!("{place}: {field}").into(),
                value,
                allowed,
            },
            syntax @ Self::Syntax { .. } => syntax,
        }
    }

    pub(super) fn into_error(self, file: &str) -> RecipeError {
        let file = file.to_owned();
        match self {
            Self::Syntax {
                line,
                column,
                message,
            } => RecipeError::Syntax {
                file,
                line,
                column,
                message,
            },
            Self::Field {
                field,
                value,
                allowed,
            } => RecipeError::Field {
                file,
                field,
                value,
                allowed,
            },
        }
    }
}
