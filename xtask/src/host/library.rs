//! A plug-in file and what it says it holds.

use super::Plugin;
use anyhow::{Context, Result, anyhow};
use clack_host::entry::{LibraryEntry, PluginEntry};
use std::ffi::{CStr, CString};
use std::path::{Path, PathBuf};

/// An opened plug-in file.
#[derive(Clone)]
pub struct Library {
    pub(super) entry: PluginEntry,
    pub(super) path: PathBuf,
}

/// One plug-in of a file, as it describes itself to a host that scans it.
#[derive(Clone, Debug, PartialEq)]
pub struct Descriptor {
    /// Unique identifier, in reverse domain order.
    pub id: String,
    /// Name shown to the user.
    pub name: String,
    /// Who makes it.
    pub vendor: String,
    /// Its version.
    pub version: String,
    /// What it does, in a few words.
    pub description: String,
    /// CLAP's names for what kind of plug-in it is.
    pub features: Vec<String>,
}

impl Library {
    /// Opens a `.clap`, or the bare dynamic library inside one.
    ///
    /// # Errors
    ///
    /// If the file does not exist or exports no CLAP entry point.
    pub fn open(path: &Path) -> Result<Self> {
        let text = CString::new(path.to_string_lossy().as_bytes())?;
        let entry = if path.is_dir() {
            // SAFETY: a plug-in is trusted as any host must trust it.
            #[expect(unsafe_code, reason = "loading a dynamic library")]
            unsafe {
                PluginEntry::load(path)
            }
        } else {
            // SAFETY: as above; the entry point found is CLAP's by its name.
            #[expect(unsafe_code, reason = "loading a dynamic library")]
            unsafe {
                LibraryEntry::load_from_path(path)
                    .and_then(|library| PluginEntry::load_from(library, &text))
            }
        };
        Ok(Self {
            entry: entry.with_context(|| format!("{}: not a CLAP plug-in", path.display()))?,
            path: path.to_owned(),
        })
    }

    /// The plug-ins in the file.
    #[must_use]
    pub fn descriptors(&self) -> Vec<Descriptor> {
        let text = |text: Option<&CStr>| {
            text.map(|text| text.to_string_lossy().into_owned())
                .unwrap_or_default()
        };
        let Some(factory) = self.entry.get_plugin_factory() else {
            return Vec::new();
        };
        factory
            .plugin_descriptors()
            .map(|plugin| Descriptor {
                id: text(plugin.id()),
                name: text(plugin.name()),
                vendor: text(plugin.vendor()),
                version: text(plugin.version()),
                description: text(plugin.description()),
                features: plugin.features().map(|f| text(Some(f))).collect(),
            })
            .collect()
    }

    /// An instance of the first plug-in in the file.
    ///
    /// # Errors
    ///
    /// If the file holds none or it refuses to start.
    pub fn instantiate(&self) -> Result<Plugin> {
        let first = self
            .descriptors()
            .into_iter()
            .next()
            .ok_or_else(|| anyhow!("{}: holds no plug-in", self.path.display()))?;
        Plugin::new(self, &first.id)
    }
}
