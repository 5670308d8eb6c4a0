//! Files that are brought together, sorted by what they are.

use super::super::ware::Ware;
use std::path::{Path, PathBuf};

/// What is brought.
#[derive(Debug, Default, PartialEq)]
pub(super) struct Delivery {
    pub(super) meshes: Vec<PathBuf>,
    pub(super) banks: Vec<PathBuf>,
    pub(super) scales: Vec<PathBuf>,
    pub(super) keyboards: Vec<PathBuf>,
    pub(super) presets: Vec<PathBuf>,
    /// What is of no use here.
    pub(super) strangers: Vec<PathBuf>,
}

impl Delivery {
    /// Sorts files by their names.
    pub(super) fn of<'a>(paths: impl Iterator<Item = &'a Path>) -> Self {
        let mut delivery = Self::default();
        for path in paths {
            delivery.pile(Ware::of(path)).push(path.to_path_buf());
        }
        delivery
    }

    fn pile(&mut self, ware: Option<Ware>) -> &mut Vec<PathBuf> {
        match ware {
            Some(Ware::Mesh) => &mut self.meshes,
            Some(Ware::Bank) => &mut self.banks,
            Some(Ware::Scale) => &mut self.scales,
            Some(Ware::Keyboard) => &mut self.keyboards,
            Some(Ware::Preset) => &mut self.presets,
            None => &mut self.strangers,
        }
    }

    /// What happens if they are let go, in one line each.
    pub(super) fn promise(&self) -> Vec<String> {
        let mesh = self.meshes.first().map(|first| match self.meshes.len() {
            1 => format!("Drop to make an instrument of {}", name(first)),
            count => format!(
                "Drop to make a kit of {} and {} more",
                name(first),
                count - 1
            ),
        });
        let firsts = [
            (&self.banks, "play"),
            (&self.presets, "load"),
            (&self.scales, "tune by"),
            (&self.keyboards, "map the keys by"),
        ];
        let firsts = firsts.into_iter().filter_map(|(pile, deed)| {
            let first = pile.first()?;
            Some(format!("Drop to {deed} {}", name(first)))
        });
        let others = [
            (&self.banks, "bank", "banks", "into your folder"),
            (&self.presets, "preset", "presets", "among yours"),
        ];
        let others = others
            .into_iter()
            .filter_map(|(pile, one, many, where_to)| {
                let more = pile.len().checked_sub(2)? + 1;
                let (goes, what) = if more == 1 {
                    ("goes", one)
                } else {
                    ("go", many)
                };
                Some(format!("{more} more {what} {goes} {where_to}"))
            });
        let unused = [(&self.scales, "scale"), (&self.keyboards, "keyboard map")];
        let unused = unused.into_iter().filter_map(|(pile, what)| {
            let unused = pile.get(1)?;
            Some(format!("One {what} at a time: {} stays", name(unused)))
        });
        let strangers = self.strangers.first().map(|first| stranger(first));
        mesh.into_iter()
            .chain(firsts)
            .chain(others)
            .chain(unused)
            .chain(strangers)
            .collect()
    }
}

/// What is said of a file that is of no use here.
pub(super) fn stranger(path: &Path) -> String {
    if path.is_dir() {
        return format!("{} is a folder: drop the files that are in it", name(path));
    }
    format!(
        "{}: Idiophone reads meshes (.obj), banks (.bank), scales (.scl), keyboard maps (.kbm) and presets \
         (.toml)",
        name(path)
    )
}

/// The last part of a path.
pub(super) fn name(path: &Path) -> String {
    let name = path.file_name().unwrap_or_default();
    name.to_string_lossy().into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn promise(names: &[&str]) -> Vec<String> {
        Delivery::of(names.iter().map(Path::new)).promise()
    }

    #[test]
    fn one_file_is_promised_what_it_is_for() {
        for (file, promised) in [
            ("/x/bell.obj", "Drop to make an instrument of bell.obj"),
            ("bell.bank", "Drop to play bell.bank"),
            ("Soft.toml", "Drop to load Soft.toml"),
            ("31.scl", "Drop to tune by 31.scl"),
            ("white.kbm", "Drop to map the keys by white.kbm"),
        ] {
            assert_eq!(promise(&[file]), [promised]);
        }
        assert_eq!(promise(&[]), [""; 0]);
    }

    #[test]
    fn of_several_the_first_is_used_and_the_others_have_their_place() {
        assert_eq!(
            promise(&["a.bank", "b.bank", "a.obj", "b.obj", "c.obj"]),
            [
                "Drop to make a kit of a.obj and 2 more",
                "Drop to play a.bank",
                "1 more bank goes into your folder",
            ]
        );
        assert_eq!(
            promise(&["a.scl", "b.scl", "a.kbm"]),
            [
                "Drop to tune by a.scl",
                "Drop to map the keys by a.kbm",
                "One scale at a time: b.scl stays",
            ]
        );
    }

    #[test]
    fn what_is_of_no_use_is_told_what_would_be() {
        let told = promise(&["/x/photo.png"]);
        assert!(told[0].starts_with("photo.png: Idiophone reads meshes (.obj)"));
        for (_, end) in Ware::ALL {
            assert!(told[0].contains(&format!("(.{end})")), "{end}");
        }
        let folder = std::env::temp_dir();
        assert!(stranger(&folder).contains("is a folder"));
    }
}
