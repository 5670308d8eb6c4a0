//! Where things lie: the repository, the build folder, the bundles.

use anyhow::{Context, Result, bail};
use std::path::{Path, PathBuf};
use std::process::Command;

/// The repository.
pub(crate) fn root() -> &'static Path {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    here.parent().unwrap_or(here)
}

/// The folder that Cargo builds into.
///
/// # Errors
///
/// If Cargo cannot be asked.
pub fn target_dir() -> Result<PathBuf> {
    #[derive(serde::Deserialize)]
    struct Metadata {
        target_directory: PathBuf,
    }
    let output = Command::new("cargo")
        .args(["metadata", "--format-version=1", "--no-deps", "--offline"])
        .current_dir(root())
        .output()
        .context("cannot run cargo")?;
    if !output.status.success() {
        bail!(
            "cargo metadata: {}",
            String::from_utf8_lossy(&output.stderr).trim()
        );
    }
    let metadata: Metadata = serde_json::from_slice(&output.stdout)?;
    Ok(metadata.target_directory)
}

/// The folder of the recipes that come with the repository.
pub(crate) fn recipes() -> PathBuf {
    root().join("recipes")
}

/// The folder that keeps computed banks.
pub(crate) fn banks() -> Result<PathBuf> {
    Ok(target_dir()?.join("banks"))
}

/// The bundled CLAP plug-in, whether or not it is there.
pub(crate) fn bundled_clap() -> Result<PathBuf> {
    Ok(target_dir()?.join("bundled").join("Idiophone.clap"))
}

/// The bundled VST3 plug-in, whether or not it is there.
pub(crate) fn bundled_vst3() -> Result<PathBuf> {
    Ok(target_dir()?.join("bundled").join("Idiophone.vst3"))
}
