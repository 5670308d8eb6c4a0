//! What is asked of one body.

use super::piece::{Piece, RULES, Tuned};
use super::quiet;
use crate::editor::theme::Theme;
use crate::key_name::key_name;
use egui::{ComboBox, DragValue, PopupCloseBehavior, Ui};
use modes::{NAMED_MATERIALS, Up};

/// Draws the fields; whether keys were set.
pub(super) fn fields(ui: &mut Ui, piece: &mut Piece, theme: &Theme) -> bool {
    let (name, count) = (piece.facts.file_name(), piece.facts.triangles);
    quiet(ui, format!("{name}: {count} triangles"), theme);
    objects(ui, piece);
    materials(ui, piece);
    size(ui, piece);
    upright(ui, piece, theme);
    let set = keys(ui, piece);
    tuning(ui, piece);
    set
}

fn objects(ui: &mut Ui, piece: &mut Piece) {
    let Some(text) = piece.chosen() else {
        return;
    };
    let mut wanted = None;
    ComboBox::from_label("Objects")
        .selected_text(text)
        .truncate()
        .close_behavior(PopupCloseBehavior::CloseOnClickOutside)
        .show_ui(ui, |ui| {
            if ui
                .selectable_label(piece.objects.is_empty(), "all in one")
                .clicked()
            {
                wanted = Some(Vec::new());
            }
            for name in piece.facts.names() {
                let mut on = piece.objects.iter().any(|own| own == name);
                if ui.checkbox(&mut on, name).changed() {
                    let mut objects = piece.objects.clone();
                    objects.retain(|own| own != name);
                    if on {
                        objects.push(name.to_owned());
                    }
                    wanted = Some(objects);
                }
            }
        });
    if let Some(objects) = wanted {
        piece.choose(objects);
    }
}

fn materials(ui: &mut Ui, piece: &mut Piece) {
    ComboBox::from_label("Material")
        .selected_text(piece.material)
        .show_ui(ui, |ui| {
            for entry in NAMED_MATERIALS {
                let m = &entry.material;
                let figures = format!(
                    "{:.0} kg/m³, λ {:.1} GPa, μ {:.1} GPa\n{}",
                    m.density_kg_m3,
                    1e-9 * m.lambda_pa,
                    1e-9 * m.mu_pa,
                    entry.source
                );
                ui.selectable_value(&mut piece.material, entry.name, entry.name)
                    .on_hover_text(figures);
            }
        });
}

fn size(ui: &mut Ui, piece: &mut Piece) {
    ui.horizontal(|ui| {
        let size = DragValue::new(&mut piece.size_mm)
            .range(1.0..=10_000.0)
            .suffix(" mm");
        let label = ui.label("Longest side");
        ui.add(size).labelled_by(label.id);
    });
    ui.horizontal(|ui| {
        ui.checkbox(&mut piece.hollow, "Hollow, with a wall of");
        let wall = DragValue::new(&mut piece.wall_mm)
            .range(0.2..=1000.0)
            .suffix(" mm");
        ui.add_enabled(piece.hollow, wall);
    });
}

fn upright(ui: &mut Ui, piece: &mut Piece, theme: &Theme) {
    ui.horizontal(|ui| {
        ui.label("Up is").on_hover_text(
            "The file's axis that points up, towards a listener who stands before it",
        );
        for up in Up::ALL {
            ui.radio_value(&mut piece.up, up, up.name());
        }
        let told = match piece.facts.up {
            Some(up) if up == piece.up => format!("guessed: it stands on {} = 0", up.name()),
            Some(up) => format!("though it stands on {} = 0", up.name()),
            None => "a guess: the mesh does not show it".to_owned(),
        };
        quiet(ui, told, theme);
    });
}

/// Lowest and highest key; whether either was set.
fn keys(ui: &mut Ui, piece: &mut Piece) -> bool {
    let mut set = false;
    ui.horizontal(|ui| {
        ui.label("Keys");
        let [low, high] = &mut piece.keys;
        for (key, name) in [(&mut *low, "Lowest key"), (&mut *high, "Highest key")] {
            let field = DragValue::new(key)
                .range(0..=127)
                .speed(0.2)
                .custom_formatter(|key, _| named(key))
                .custom_parser(|text| numbered(text).map(f64::from));
            let response = ui.add(field).accessible_name(name);
            set |= response.on_hover_text(name).changed();
        }
        *high = (*high).max(*low);
    });
    set
}

fn named(key: f64) -> String {
    #[expect(clippy::cast_sign_loss, reason = "keys are not negative")]
    let key = key.clamp(0.0, 127.0) as u8;
    key_name(key)
}

/// The key of that name or number.
fn numbered(text: &str) -> Option<u8> {
    let text = text.trim();
    let number = text.parse().ok().filter(|key| *key < 128);
    number.or_else(|| (0..128).find(|key| key_name(*key).eq_ignore_ascii_case(text)))
}

fn tuning(ui: &mut Ui, piece: &mut Piece) {
    ComboBox::from_label("Changes from key to key")
        .selected_text(RULES[piece.rule].1)
        .show_ui(ui, |ui| {
            for (place, (_, name)) in RULES.iter().enumerate() {
                ui.selectable_value(&mut piece.rule, place, *name);
            }
        });
    let tuned = piece.is_tuned();
    ui.add_enabled_ui(tuned, |ui| {
        ui.horizontal(|ui| {
            ui.label("Tuned by its partial");
            for mode in Tuned::ALL {
                ui.radio_value(&mut piece.tuned, mode, mode.name());
            }
            let number = DragValue::new(&mut piece.number).range(1..=1000).speed(0.1);
            ui.add_enabled(piece.tuned == Tuned::Number, number)
                .on_hover_text("Counted from the lowest, which is 1");
        });
    });
}

#[cfg(test)]
mod tests {
    use super::{named, numbered};

    #[test]
    fn keys_are_read_as_they_are_written() {
        for key in 0..128 {
            assert_eq!(numbered(&named(f64::from(key))), Some(key));
            assert_eq!(numbered(&format!(" {key}")), Some(key));
        }
        assert_eq!(numbered("c#4"), Some(61));
        assert_eq!((numbered("128"), numbered("H2")), (None, None));
    }
}
