//! `bundle`: the plug-in as CLAP and VST3.

use crate::{banks, workspace};
use anyhow::{Context, Result, bail};
use clap::Args;
use std::env;
use std::path::PathBuf;

/// Name of the plug-in's package.
const PACKAGE: &str = "idiophone";

/// Arguments of `bundle`.
#[derive(Args, Debug)]
pub struct Bundle {}

impl Bundle {
    pub(super) fn run(&self) -> Result<()> {
        bundle()?;
        println!("{}", workspace::bundled_clap()?.display());
        println!("{}", workspace::bundled_vst3()?.display());
        Ok(())
    }
}

/// Builds the plug-in for release and bundles it.
pub(super) fn bundle() -> Result<()> {
    for name in banks::names()? {
        banks::precompute(&name, false)?;
    }
    let target = workspace::target_dir()?;
    // Cargo and the bundler look for the workspace and its `bundler.toml` where they are run.
    let before = env::current_dir().context("no working directory")?;
    env::set_current_dir(workspace::root())?;
    let release = ["--release".to_owned()];
    let done = nice_plug_xtask::build(&[PACKAGE.to_owned()], &release)
        .and_then(|()| nice_plug_xtask::bundle(&target, PACKAGE, &release, false));
    env::set_current_dir(before)?;
    done?;
    for bundle in [workspace::bundled_clap()?, workspace::bundled_vst3()?] {
        if !bundle.exists() {
            bail!("{}: was not built", bundle.display());
        }
    }
    Ok(())
}

/// The bundled CLAP plug-in, built first if it is not there.
pub(super) fn bundled_clap() -> Result<PathBuf> {
    let path = workspace::bundled_clap()?;
    if !path.exists() {
        bundle()?;
    }
    Ok(path)
}
