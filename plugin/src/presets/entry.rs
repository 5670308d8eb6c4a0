//! A line of the library.

use super::preset::Preset;
use std::sync::Arc;

/// Where a preset comes from.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Origin {
    /// The plug-in itself; with the preset's name.
    Factory(String),
    /// The user's folder; with the file's name.
    User(String),
}

impl Origin {
    /// As it is kept: `factory/Soft yarn` or `user/Mine.toml`.
    #[must_use]
    pub fn key(&self) -> String {
        match self {
            Self::Factory(name) => format!("factory/{name}"),
            Self::User(file) => format!("user/{file}"),
        }
    }

    /// Back from [`Origin::key`].
    #[must_use]
    pub fn from_key(key: &str) -> Option<Self> {
        let (kind, name) = key.split_once('/')?;
        match kind {
            "factory" => Some(Self::Factory(name.to_owned())),
            "user" => Some(Self::User(name.to_owned())),
            _ => None,
        }
    }
}

/// One preset of the library, or a file that should be one.
#[derive(Clone, Debug)]
pub struct Entry {
    /// Whence.
    pub origin: Origin,
    /// The preset, or why there is none.
    pub preset: Result<Arc<Preset>, String>,
    /// Whether the user has marked it.
    pub favourite: bool,
}

impl Entry {
    /// Its name; of a broken one, its file's.
    #[must_use]
    pub fn name(&self) -> &str {
        match (&self.preset, &self.origin) {
            (Ok(preset), _) => &preset.card.name,
            (Err(_), Origin::Factory(name) | Origin::User(name)) => name,
        }
    }

    /// Whether it is the user's own.
    #[must_use]
    pub fn is_user_s(&self) -> bool {
        matches!(self.origin, Origin::User(_))
    }
}

#[cfg(test)]
mod tests {
    use super::Origin;

    #[test]
    fn keys_read_back() {
        for origin in [
            Origin::Factory("Yarn, soft / slow".to_owned()),
            Origin::User("a b.toml".to_owned()),
        ] {
            assert_eq!(Origin::from_key(&origin.key()), Some(origin));
        }
        assert_eq!(Origin::from_key("cloud/x"), None);
        assert_eq!(Origin::from_key("x"), None);
    }
}
