//! Files that are dragged over the window.

use baseview::DropData;
use egui::{DroppedFile, DroppedFileHandle, HoveredFile};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Those that hover, and those that have been let go since the last frame.
#[derive(Default)]
pub(super) struct Files {
    hovering: Vec<PathBuf>,
    dropped: Vec<PathBuf>,
}

impl Files {
    /// They are over the window.
    pub(super) fn hover(&mut self, data: &DropData) {
        self.hovering = paths(data);
    }

    /// They have left it.
    pub(super) fn leave(&mut self) {
        self.hovering.clear();
    }

    /// They are let go.
    pub(super) fn fall(&mut self, data: &DropData) {
        self.hovering.clear();
        self.dropped.extend(paths(data));
    }

    /// Those that are over the window or have just been let go.
    pub(super) fn all(&self) -> impl Iterator<Item = &Path> {
        let all = self.hovering.iter().chain(&self.dropped);
        all.map(PathBuf::as_path)
    }

    /// What hovers, for a frame.
    pub(super) fn hovered(&self) -> Vec<HoveredFile> {
        let file = |path: &PathBuf| HoveredFile {
            path: Some(path.clone()),
            ..HoveredFile::default()
        };
        self.hovering.iter().map(file).collect()
    }

    /// What has been let go, once.
    pub(super) fn take(&mut self) -> Vec<DroppedFileHandle> {
        let dropped = std::mem::take(&mut self.dropped).into_iter();
        dropped
            .map(|path| Arc::new(Dropped(path)) as DroppedFileHandle)
            .collect()
    }
}

fn paths(data: &DropData) -> Vec<PathBuf> {
    match data {
        DropData::Files(paths) => paths.clone(),
        _ => Vec::new(),
    }
}

/// A file of the disk.
#[derive(Debug)]
struct Dropped(PathBuf);

impl DroppedFile for Dropped {
    fn path(&self) -> &Path {
        &self.0
    }

    fn bytes(&self) -> Result<Vec<u8>, String> {
        std::fs::read(&self.0).map_err(|error| format!("{}: {error}", self.0.display()))
    }
}
