//! Builds the factory banks, or finds them built, and lists them and the presets for the crate.

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
    presets(&out)?;
    stay_loaded();
    println!("cargo::rerun-if-changed=build.rs");
    Ok(())
}

/// Lists the factory's presets in the order of their names.
fn presets(out: &Path) -> Result<(), Box<dyn Error>> {
    let folder = Path::new(&env::var("CARGO_MANIFEST_DIR")?).join("../presets");
    println!("cargo::rerun-if-changed={}", folder.display());
    let mut paths = Vec::new();
    for entry in std::fs::read_dir(&folder)? {
        let path = entry?.path();
        if path.extension().is_some_and(|ending| ending == "toml") {
            paths.push(path);
        }
    }
    paths.sort();
    let mut list = format!("const FILES: [Entry; {}] = [\n", paths.len());
    for path in &paths {
        let name = path.file_name().unwrap_or_default();
        writeln!(list, "    ({name:?}, include_str!({path:?})),")?;
    }
    Ok(std::fs::write(out.join("presets.rs"), list + "];\n")?)
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
