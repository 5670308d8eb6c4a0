//! `install`: the bundles into the plug-in folders of this user.

use super::bundle;
use crate::workspace;
use anyhow::{Context, Result};
use clap::Args;
use std::env;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};

/// Arguments of `install`.
#[derive(Args, Debug)]
pub struct Install {
    /// Install into DIR instead of the user's plug-in folders
    #[arg(long, value_name = "DIR")]
    pub dir: Option<PathBuf>,
}

/// Where hosts look for this user's plug-ins.
#[derive(Debug, PartialEq)]
struct Folders {
    clap: PathBuf,
    vst3: PathBuf,
}

impl Install {
    pub(super) fn run(&self) -> Result<()> {
        let folders = match &self.dir {
            Some(dir) => Folders {
                clap: dir.clone(),
                vst3: dir.clone(),
            },
            None => Folders::of_user(env::consts::OS, |name| env::var_os(name))?,
        };
        bundle::bundle()?;
        for (bundle, folder) in [
            (workspace::bundled_clap()?, folders.clap),
            (workspace::bundled_vst3()?, folders.vst3),
        ] {
            println!("{}", place(&bundle, &folder)?.display());
        }
        Ok(())
    }
}

impl Folders {
    fn of_user(os: &str, variable: impl Fn(&str) -> Option<OsString>) -> Result<Self> {
        let base = |name: &str| {
            variable(name)
                .filter(|value| !value.is_empty())
                .map(PathBuf::from)
                .with_context(|| format!("{name} is not set; give a folder with --dir"))
        };
        Ok(match os {
            "macos" => {
                let plug_ins = base("HOME")?.join("Library/Audio/Plug-Ins");
                Self {
                    clap: plug_ins.join("CLAP"),
                    vst3: plug_ins.join("VST3"),
                }
            }
            "windows" => {
                let common = base("LOCALAPPDATA")?.join("Programs").join("Common");
                Self {
                    clap: common.join("CLAP"),
                    vst3: common.join("VST3"),
                }
            }
            _ => Self {
                clap: base("HOME")?.join(".clap"),
                vst3: base("HOME")?.join(".vst3"),
            },
        })
    }
}

/// Copies a bundle into a folder in place of what had its name, and says where it lies.
///
/// The copy is made beside its place and then renamed: a host that has the old plug-in open keeps
/// it, and a copy cut short is not taken for a plug-in.
fn place(bundle: &Path, folder: &Path) -> Result<PathBuf> {
    let name = bundle.file_name().context("a bundle has a name")?;
    let target = folder.join(name);
    let fresh = folder.join(format!(".idiophone.{}.part", std::process::id()));
    let placed = fs::create_dir_all(folder)
        .and_then(|()| copy(bundle, &fresh))
        .and_then(|()| remove(&target))
        .and_then(|()| fs::rename(&fresh, &target));
    if placed.is_err() {
        let _ = remove(&fresh);
    }
    placed.with_context(|| format!("{}: cannot install", target.display()))?;
    Ok(target)
}

fn copy(from: &Path, to: &Path) -> std::io::Result<()> {
    if !from.is_dir() {
        return fs::copy(from, to).map(|_| ());
    }
    fs::create_dir_all(to)?;
    for entry in fs::read_dir(from)? {
        let entry = entry?;
        copy(&entry.path(), &to.join(entry.file_name()))?;
    }
    Ok(())
}

fn remove(path: &Path) -> std::io::Result<()> {
    match fs::symlink_metadata(path) {
        Err(_) => Ok(()),
        Ok(metadata) if metadata.is_dir() => fs::remove_dir_all(path),
        Ok(_) => fs::remove_file(path),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_system_has_its_folders() {
        let home = |name: &str| (name == "HOME").then(|| "/home/ada".into());
        let linux = Folders::of_user("linux", home).unwrap();
        assert_eq!(linux.clap, Path::new("/home/ada/.clap"));
        assert_eq!(linux.vst3, Path::new("/home/ada/.vst3"));
        let mac = Folders::of_user("macos", home).unwrap();
        assert_eq!(mac.vst3, Path::new("/home/ada/Library/Audio/Plug-Ins/VST3"));
        let local = |name: &str| (name == "LOCALAPPDATA").then(|| "local".into());
        let windows = Folders::of_user("windows", local).unwrap();
        assert_eq!(windows.clap, Path::new("local/Programs/Common/CLAP"));
        let error = Folders::of_user("linux", |_| None).unwrap_err();
        assert!(error.to_string().contains("--dir"), "{error}");
    }

    #[test]
    fn files_and_folders_replace_what_was_there() {
        let dir = tempfile::tempdir().unwrap();
        let bundle = dir.path().join("A.vst3");
        fs::create_dir_all(bundle.join("Contents")).unwrap();
        fs::write(bundle.join("Contents/new.so"), "new").unwrap();
        let folder = dir.path().join("to/there");
        fs::create_dir_all(folder.join("A.vst3")).unwrap();
        fs::write(folder.join("A.vst3/stale.so"), "stale").unwrap();
        let target = place(&bundle, &folder).unwrap();
        assert_eq!(target, folder.join("A.vst3"));
        assert!(!target.join("stale.so").exists());
        assert_eq!(
            fs::read_to_string(target.join("Contents/new.so")).unwrap(),
            "new"
        );
        assert_eq!(fs::read_dir(&folder).unwrap().count(), 1);
    }
}
