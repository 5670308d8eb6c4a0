//! Which code this is.

/// Version and source hash of this crate and the recipes beside it, as in `0.1.0 89abcdef01234567`.
///
/// Banks made by the same recipe and the same `CODE` are the same.
pub const CODE: &str = concat!(
    env!("CARGO_PKG_VERSION"),
    " ",
    env!("IDIOPHONE_SOURCE_HASH")
);

#[cfg(test)]
#[path = "source_hash.rs"]
mod source_hash;

#[cfg(test)]
mod tests {
    use super::CODE;
    use super::source_hash::hash_files;
    use std::fs;
    use std::path::Path;

    #[test]
    fn names_and_contents_count() {
        let folder = std::env::temp_dir().join(format!("idiophone-hash-{}", std::process::id()));
        let hash = |files: &[(&str, &str)]| {
            fs::create_dir_all(folder.join("src/deep")).unwrap();
            for (name, content) in files {
                fs::write(folder.join("src").join(name), content).unwrap();
            }
            let hash = hash_files(&folder, &["src"]).unwrap();
            fs::remove_dir_all(&folder).unwrap();
            hash
        };
        let first = hash(&[("a.rs", "x"), ("deep/b.rs", "y")]);
        assert_eq!(hash(&[("deep/b.rs", "y"), ("a.rs", "x")]), first);
        assert_ne!(hash(&[("a.rs", "x"), ("deep/b.rs", "z")]), first);
        assert_ne!(hash(&[("a.rs", "x"), ("deep/c.rs", "y")]), first);
        assert_ne!(hash(&[("a.rs", "xy"), ("deep/b.rs", "")]), first);
    }

    #[test]
    fn the_code_is_what_is_here() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
        let hash = hash_files(root, &["modes/Cargo.toml", "modes/src", "recipes"]).unwrap();
        assert_eq!(CODE, format!("{} {hash:016x}", env!("CARGO_PKG_VERSION")));
    }
}
