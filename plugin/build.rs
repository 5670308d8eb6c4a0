//! Builds the factory banks, or finds them built, and lists them for the crate.

use modes::Recipe;
use modes::factory::{Silent, cached};
use std::env;
use std::error::Error;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

fn main() -> Result<(), Box<dyn Error>> {
    let out = PathBuf::from(env::var_os("OUT_DIR").ok_or("cargo sets OUT_DIR")?);
    let folder = target_folder(&out).join("banks");
    let (mut files, mut titles) = (String::new(), String::new());
    for (name, text) in Recipe::FACTORY {
        let recipe = Recipe::parse(text, name)?;
        let built = cached(&recipe, &folder, false, &Silent)?;
        writeln!(files, "    ({name:?}, include_bytes!({:?})),", built.path)?;
        writeln!(titles, "    {:?},", recipe.title)?;
        println!("cargo::rerun-if-changed={}", built.path.display());
    }
    let count = Recipe::FACTORY.len();
    let list = format!(
        "const COUNT: usize = {count};\nconst FILES: [Entry; COUNT] = [\n{files}];\n\
         const TITLES: [&str; COUNT] = [\n{titles}];\n"
    );
    std::fs::write(out.join("banks.rs"), list)?;
    stay_loaded();
    println!("cargo::rerun-if-changed=build.rs");
    Ok(())
}

/// Hosts unload plug-ins while threads of theirs that have been inside still run; what such a thread
/// left to be done at its end must then still be there.
fn stay_loaded() {
    if env::var("CARGO_CFG_TARGET_OS").is_ok_and(|os| os == "linux") {
        println!("cargo::rustc-cdylib-link-arg=-Wl,-z,nodelete");
    }
}

/// Cargo's target folder, where `cargo xtask precompute` keeps banks too; `out` itself if it lies in
/// none.
fn target_folder(out: &Path) -> &Path {
    out.ancestors()
        .find(|folder| folder.join("CACHEDIR.TAG").is_file())
        .unwrap_or(out)
}
