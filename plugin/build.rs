//! Builds the factory banks, or finds them built, and names them to the crate.

use modes::Recipe;
use modes::factory::{Silent, cached};
use std::env;
use std::error::Error;
use std::path::{Path, PathBuf};

fn main() -> Result<(), Box<dyn Error>> {
    let out = PathBuf::from(env::var_os("OUT_DIR").ok_or("cargo sets OUT_DIR")?);
    let folder = target_folder(&out).join("banks");
    for (name, text) in Recipe::FACTORY {
        let recipe = Recipe::parse(text, name)?;
        let built = cached(&recipe, &folder, false, &Silent)?;
        let variable = format!("IDIOPHONE_BANK_{}", name.to_uppercase());
        println!("cargo::rustc-env={variable}={}", built.path.display());
        println!("cargo::rerun-if-changed={}", built.path.display());
    }
    println!("cargo::rerun-if-changed=build.rs");
    Ok(())
}

/// Cargo's target folder, where `cargo xtask precompute` keeps banks too; `out` itself if it lies in
/// none.
fn target_folder(out: &Path) -> &Path {
    out.ancestors()
        .find(|folder| folder.join("CACHEDIR.TAG").is_file())
        .unwrap_or(out)
}
