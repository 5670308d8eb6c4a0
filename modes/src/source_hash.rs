//! A hash of source files, to tell which code made a bank.

use crate::fnv;
use std::io;
use std::path::{Path, PathBuf};

/// Hash of all files under `folders`, their paths relative to `root`, and their contents.
pub(crate) fn hash_files(root: &Path, folders: &[&str]) -> io::Result<u64> {
    let mut files = Vec::new();
    for folder in folders {
        list_files(root, folder, &mut files)?;
    }
    files.sort();
    let mut hash = fnv::START;
    for (name, path) in files {
        let content = std::fs::read(path)?;
        for part in [name.as_bytes(), &content] {
            hash = fnv::extend(hash, &(part.len() as u64).to_le_bytes());
            hash = fnv::extend(hash, part);
        }
    }
    Ok(hash)
}

/// Names relative to `root` with `/` on every system, so that the order is the same on all.
fn list_files(root: &Path, name: &str, files: &mut Vec<(String, PathBuf)>) -> io::Result<()> {
    let path = root.join(name);
    if path.is_file() {
        files.push((name.to_owned(), path));
        return Ok(());
    }
    for entry in std::fs::read_dir(path)? {
        let entry = entry?.file_name();
        list_files(root, &format!("{name}/{}", entry.to_string_lossy()), files)?;
    }
    Ok(())
}
