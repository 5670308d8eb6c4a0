//! Ways into the window: files that are dragged over it and dropped, or chosen in a dialog.

mod delivery;
mod picked;
mod veil;

pub(super) use picked::Picked;

use super::instruments::Instruments;
use super::presets::Session;
use super::theme::Theme;
use crate::notices::{Notice, Subject};
use crate::presets::Scala;
use delivery::{Delivery, name, stranger};
use egui::{DroppedFileHandle, Ui};
use modes::tuning::{KeyboardMap, Scale};
use nice_plug::prelude::ParamSetter;
use std::path::{Path, PathBuf};
use veil::veil;

/// How long is told what has come of files, in s.
const TOLD_S: f64 = 8.0;

/// Where files go.
pub(super) struct Rooms<'a> {
    pub(super) instruments: &'a Instruments,
    pub(super) session: &'a mut Session,
}

/// What has come of the files that came last.
#[derive(Default)]
pub(super) struct Doors {
    told: String,
    until_s: f64,
}

impl Doors {
    /// Shows what would come of files that hover, and takes those that are let go or chosen.
    pub(super) fn show(
        &mut self,
        ui: &Ui,
        rooms: Rooms<'_>,
        theme: &Theme,
        setter: &ParamSetter<'_>,
    ) {
        let (hovering, dropped) = ui.input(|input| {
            let hovering = input.raw.hovered_files.iter();
            let paths: Vec<PathBuf> = hovering.filter_map(|file| file.path.clone()).collect();
            (paths, input.raw.dropped_files.clone())
        });
        if !hovering.is_empty() {
            let delivery = Delivery::of(hovering.iter().map(PathBuf::as_path));
            let good = delivery.strangers.len() < hovering.len();
            veil(ui, &delivery.promise(), good, theme);
        }
        let picked = rooms.instruments.picked().take();
        if !dropped.is_empty() || !picked.is_empty() {
            let picked = picked.iter().map(PathBuf::as_path);
            let delivery = Delivery::of(dropped.iter().map(path).chain(picked));
            self.until_s = ui.input(|input| input.time) + TOLD_S;
            self.told = take(delivery, rooms, setter).join("; ");
            // What was drawn before the files came is drawn anew.
            ui.ctx().request_repaint();
        }
    }

    /// What has come of the files that came last, for some seconds.
    pub(super) fn told(&self, ui: &Ui) -> Option<String> {
        let left_s = self.until_s - ui.input(|input| input.time);
        if self.told.is_empty() || left_s <= 0.0 {
            return None;
        }
        ui.ctx()
            .request_repaint_after(std::time::Duration::from_secs_f64(left_s));
        Some(self.told.clone())
    }
}

fn path(file: &DroppedFileHandle) -> &Path {
    file.path()
}

/// Takes files in; what to say of those that are done at once. What is wrong with others becomes a notice.
fn take(delivery: Delivery, rooms: Rooms<'_>, setter: &ParamSetter<'_>) -> Vec<String> {
    let Rooms {
        instruments,
        session,
    } = rooms;
    let mut done = Vec::new();
    let mut wrong: Vec<String> = delivery
        .strangers
        .iter()
        .map(|path| stranger(path))
        .collect();
    let mut note = |outcome: Result<String, String>| match outcome {
        Ok(told) => done.push(told),
        Err(reason) => wrong.push(reason),
    };
    for (number, path) in delivery.presets.iter().enumerate() {
        let brought = session.bring(path, number == 0, setter);
        let told = brought.map(|name| format!("{name} is among your presets"));
        note(told.map_err(|broken| broken.to_string()));
    }
    if let Some(tuned) = tune(&delivery, session, setter) {
        note(tuned);
    }
    let mut banks = delivery.banks.into_iter();
    if let Some(first) = banks.next() {
        instruments.open(first);
    }
    instruments.library().offer(banks);
    if !delivery.meshes.is_empty() {
        instruments.shape(delivery.meshes);
    }
    let notices = instruments.notices();
    notices.clear(Subject::Dropped);
    if let Some(first) = wrong.first() {
        let more = match wrong.len() {
            1 => String::new(),
            count => format!("; and {} more", count - 1),
        };
        notices.post(Notice {
            subject: Subject::Dropped,
            text: format!("{first}{more}"),
            cure: None,
        });
    }
    done
}

/// Tunes by the first scale and the first keyboard map, in one step; `None` if there is neither.
fn tune(
    delivery: &Delivery,
    session: &mut Session,
    setter: &ParamSetter<'_>,
) -> Option<Result<String, String>> {
    let scale = delivery.scales.first();
    let keyboard = delivery.keyboards.first();
    let names: Vec<_> = scale
        .into_iter()
        .chain(keyboard)
        .map(|path| name(path))
        .collect();
    if names.is_empty() {
        return None;
    }
    let names = names.join(" and ");
    let read = || {
        let now = session.scala();
        let scale = scale.map(|path| Scale::load_text(path)).transpose()?;
        let keyboard = keyboard
            .map(|path| KeyboardMap::load_text(path))
            .transpose()?;
        Ok(Scala {
            scale: scale.unwrap_or(now.scale),
            keyboard: keyboard.unwrap_or(now.keyboard),
        })
    };
    let tuned = read().map_err(|error: modes::tuning::TuningFileError| error.to_string());
    Some(tuned.map(|scala| {
        session.tune(&scala, format!("tuning by {names}"), setter);
        format!("Tuned by {names}; Ctrl+Z takes it back")
    }))
}
