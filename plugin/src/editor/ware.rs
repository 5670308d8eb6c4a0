//! What a file is by its name.

use std::path::Path;

/// What can be brought to the window.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Ware {
    /// Becomes an instrument.
    Mesh,
    /// Is one.
    Bank,
    /// Tunes.
    Scale,
    /// Says which key plays which degree of a scale.
    Keyboard,
    /// Sets parameters.
    Preset,
}

impl Ware {
    /// All, with how their files end.
    pub(super) const ALL: [(Self, &'static str); 5] = [
        (Self::Mesh, "obj"),
        (Self::Bank, "bank"),
        (Self::Scale, "scl"),
        (Self::Keyboard, "kbm"),
        (Self::Preset, "toml"),
    ];

    /// What a file is; nothing that can be used if it ends otherwise.
    pub(super) fn of(path: &Path) -> Option<Self> {
        let end = path.extension()?;
        let found = Self::ALL
            .iter()
            .find(|(_, usual)| end.eq_ignore_ascii_case(usual));
        found.map(|(ware, _)| *ware)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_are_known_by_their_ends() {
        let of = |name: &str| Ware::of(Path::new(name));
        assert_eq!(of("/x/Bell.OBJ"), Some(Ware::Mesh));
        assert_eq!(of("bell.old.bank"), Some(Ware::Bank));
        assert_eq!(of("31.scl"), Some(Ware::Scale));
        assert_eq!(of("white.kbm"), Some(Ware::Keyboard));
        assert_eq!(of("Soft.toml"), Some(Ware::Preset));
        for other in ["bell", "bell.png", ".obj", "obj", ""] {
            assert_eq!(of(other), None, "{other}");
        }
    }
}
