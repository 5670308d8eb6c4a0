//! Names the code by a hash of what decides the content of a bank.

#[path = "src/fnv.rs"]
mod fnv;
#[path = "src/source_hash.rs"]
mod source_hash;

use std::path::Path;
use std::{env, io};

/// Relative to the folder that holds this crate. The manifest pins the eigen solver's libraries.
const SOURCES: [&str; 3] = ["modes/Cargo.toml", "modes/src", "recipes"];

fn main() -> io::Result<()> {
    let crate_folder = env::var_os("CARGO_MANIFEST_DIR").ok_or(io::ErrorKind::NotFound)?;
    let root = Path::new(&crate_folder).join("..");
    for source in SOURCES {
        println!("cargo::rerun-if-changed={}", root.join(source).display());
    }
    println!("cargo::rerun-if-changed=build.rs");
    let hash = source_hash::hash_files(&root, &SOURCES)?;
    println!("cargo::rustc-env=IDIOPHONE_SOURCE_HASH={hash:016x}");
    Ok(())
}
