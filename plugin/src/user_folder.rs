//! The folder in which a user keeps what belongs to Idiophone.

use std::env;
use std::ffi::OsString;
use std::path::PathBuf;

/// This user's folder for tunings and whatever else is not in the plug-in itself; it may not be
/// there yet. `None` if the system does not say where such folders lie.
///
/// `idiophone` in `XDG_DATA_HOME` or else `~/.local/share` on Linux (XDG Base Directory
/// Specification 0.8), `~/Library/Application Support/Idiophone` on macOS, `%APPDATA%\Idiophone` on
/// Windows.
#[must_use]
pub fn user_folder() -> Option<PathBuf> {
    folder(env::consts::OS, |name| env::var_os(name))
}

fn folder(os: &str, variable: impl Fn(&str) -> Option<OsString>) -> Option<PathBuf> {
    // Elsewhere than from the root, a folder would be wherever the host happens to run.
    let base = |name: &str| {
        variable(name)
            .map(PathBuf::from)
            .filter(|path| path.has_root())
    };
    match os {
        "macos" => Some(base("HOME")?.join("Library/Application Support/Idiophone")),
        "windows" => Some(base("APPDATA")?.join("Idiophone")),
        _ => base("XDG_DATA_HOME")
            .or_else(|| Some(base("HOME")?.join(".local/share")))
            .map(|data| data.join("idiophone")),
    }
}

#[cfg(test)]
mod tests {
    use super::{folder, user_folder};
    use std::ffi::OsString;
    use std::path::Path;

    fn assert_folder(os: &str, variables: &[(&str, &str)], expected: Option<&str>) {
        let variable = |name: &str| {
            let (_, value) = variables.iter().find(|(key, _)| *key == name)?;
            Some(OsString::from(value))
        };
        assert_eq!(folder(os, variable).as_deref(), expected.map(Path::new));
    }

    #[test]
    fn each_system_has_its_place() {
        let home = ("HOME", "/home/ada");
        assert_folder("linux", &[home], Some("/home/ada/.local/share/idiophone"));
        let data = ("XDG_DATA_HOME", "/data");
        assert_folder("linux", &[home, data], Some("/data/idiophone"));
        assert_folder("linux", &[data], Some("/data/idiophone"));
        let support = "/home/ada/Library/Application Support/Idiophone";
        assert_folder("macos", &[home, data], Some(support));
        let roaming = ("APPDATA", "/Users/ada/AppData/Roaming");
        let windows = Path::new(roaming.1).join("Idiophone");
        assert_folder("windows", &[home, roaming], windows.to_str());
    }

    #[test]
    fn what_is_not_set_or_not_absolute_does_not_count() {
        for os in ["linux", "macos", "windows"] {
            assert_folder(os, &[], None);
            let relative = ["HOME", "APPDATA", "XDG_DATA_HOME"].map(|name| (name, "ada"));
            assert_folder(os, &relative, None);
            assert_folder(os, &relative.map(|(name, _)| (name, "")), None);
        }
        let empty = [("XDG_DATA_HOME", ""), ("HOME", "/home/ada")];
        let local = "/home/ada/.local/share/idiophone";
        assert_folder("linux", &empty, Some(local));
    }

    #[test]
    fn it_is_this_users() {
        assert!(user_folder().is_none_or(|folder| folder.is_absolute()));
    }
}
