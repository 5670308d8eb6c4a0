//! The list of a sheet's bodies, and what adds to it.

use super::kit::Kit;
use crate::key_name::key_name;
use egui::{Atom, Button, TextEdit, Ui, vec2};
use std::path::PathBuf;

/// What comes onto the sheet next.
pub(super) enum More {
    /// The mesh in this file.
    File(PathBuf),
    /// One that a dialog asks for.
    Ask,
}

/// Draws the list, if there are several bodies, and the buttons below it; what is to come.
pub(super) fn bodies(ui: &mut Ui, kit: &mut Kit, meshes: &[PathBuf]) -> Option<More> {
    if kit.pieces.len() > 1 {
        name(ui, kit);
        list(ui, kit);
    }
    let mut more = None;
    ui.horizontal(|ui| {
        ui.menu_button("Add a body", |ui| more = menu(ui, kit, meshes))
            .response
            .on_hover_text("Another mesh, or other objects of this one, for keys of its own");
        let objects = kit.pieces.get(kit.at).map_or(0, |p| p.facts.names().len());
        if kit.pieces.len() == 1 && objects > 1 {
            let each = ui.button(format!("{objects} objects, {objects} bodies"));
            if each
                .on_hover_text(
                    "Each object is a body of its own, at its own pitch, on a key of its own",
                )
                .clicked()
            {
                kit.split();
            }
        }
    });
    ui.separator();
    more
}

fn name(ui: &mut Ui, kit: &mut Kit) {
    ui.horizontal(|ui| {
        let label = ui.label("Name");
        let field = TextEdit::singleline(&mut kit.title)
            .char_limit(64)
            .desired_width(220.0);
        ui.add(field).labelled_by(label.id);
    });
}

fn list(ui: &mut Ui, kit: &mut Kit) {
    let mut gone = None;
    for (number, piece) in kit.pieces.iter().enumerate() {
        let [low, high] = piece.keys;
        let keys = if low == high {
            key_name(low)
        } else {
            format!("{}–{}", key_name(low), key_name(high))
        };
        ui.horizontal(|ui| {
            let text = format!("{keys}  {}", piece.title());
            let line = Button::selectable(number == kit.at, (text, Atom::grow()))
                .truncate()
                .min_size(vec2(270.0, 20.0));
            if ui.add(line).clicked() {
                kit.at = number;
            }
            if ui.button("Remove").clicked() {
                gone = Some(number);
            }
        });
    }
    if let Some(number) = gone {
        kit.remove(number);
    }
}

fn menu(ui: &mut Ui, kit: &mut Kit, meshes: &[PathBuf]) -> Option<More> {
    let mut more = None;
    if ui.button("Another of the same mesh").clicked() {
        kit.double();
    }
    for path in meshes {
        let stem = path.file_stem().unwrap_or_default().to_string_lossy();
        if ui.button(format!("{stem} (from your folder)")).clicked() {
            more = Some(More::File(path.clone()));
        }
    }
    if ui.button("A mesh from elsewhere…").clicked() {
        more = Some(More::Ask);
    }
    more
}
