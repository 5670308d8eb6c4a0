//! What is filled in to save, rename, delete, import and export.

use super::super::theme::{NEAR, SIDE, Theme, body, small, title};
use super::button::word;
use super::session::Session;
use crate::presets::{Broken, Card, Folder, Library, Preset};
use egui::text::{CCursor, CCursorRange};
use egui::{Align2, Id, Key, Label, RichText, Sense, TextEdit, Ui, vec2};
use std::path::Path;

/// A form that is open.
pub(super) struct Form {
    task: Task,
    /// Just opened: its first field takes the keyboard.
    fresh: bool,
}

enum Task {
    Save { card: Card, tags: String },
    Rename { file: String, name: String },
    Delete { file: String },
    Import { path: String },
    Export { preset: Box<Preset>, path: String },
}

/// What has become of a form.
pub(super) enum Outcome {
    /// It is being filled in.
    Open,
    /// It was given up.
    Closed,
    /// What it is for was tried.
    Done(Result<String, Broken>),
}

impl Form {
    fn new(task: Task) -> Self {
        Self { task, fresh: true }
    }

    /// To save under a card like this.
    pub(super) fn save(card: Card) -> Self {
        let tags = card.tags_text();
        Self::new(Task::Save { card, tags })
    }

    /// To give a file's preset another name.
    pub(super) fn rename(file: &str, name: &str) -> Self {
        let [file, name] = [file, name].map(str::to_owned);
        Self::new(Task::Rename { file, name })
    }

    /// To put a file aside.
    pub(super) fn delete(file: &str) -> Self {
        let file = file.to_owned();
        Self::new(Task::Delete { file })
    }

    /// To take in a file.
    pub(super) fn import() -> Self {
        Self::new(Task::Import {
            path: String::new(),
        })
    }

    /// To write a preset to a file.
    pub(super) fn export(preset: Preset, library: &Library) -> Self {
        let path = library.export_path(&preset.card.name);
        let path = path.map_or(String::new(), |path| path.display().to_string());
        let preset = Box::new(preset);
        Self::new(Task::Export { preset, path })
    }

    fn words(&self, session: &Session) -> [&'static str; 2] {
        match &self.task {
            Task::Save { card, .. } if session.library.mine(&card.name).is_some() => {
                ["Save preset", "Replace"]
            }
            Task::Save { .. } => ["Save preset", "Save"],
            Task::Rename { .. } => ["Rename preset", "Rename"],
            Task::Delete { .. } => ["Delete preset", "Delete"],
            Task::Import { .. } => ["Import preset", "Import"],
            Task::Export { .. } => ["Export preset", "Export"],
        }
    }

    /// Draws it; does what it is for if that is wanted.
    pub(super) fn show(&mut self, ui: &mut Ui, session: &mut Session, theme: &Theme) -> Outcome {
        ui.spacing_mut().item_spacing = vec2(SIDE, NEAR);
        let [heading, deed] = self.words(session);
        ui.add(Label::new(
            RichText::new(heading).font(title()).color(theme.text),
        ));
        ui.add_space(NEAR);
        let folder = session.library.folder();
        let entered = self.fields(ui, folder.as_ref(), theme);
        ui.add_space(SIDE);
        let (mut wanted, mut given_up) = (entered, false);
        ui.horizontal(|ui| {
            wanted |= word(ui, deed, true, theme).clicked();
            given_up = word(ui, "Cancel", false, theme).clicked();
        });
        if wanted {
            return Outcome::Done(self.act(session));
        }
        if given_up {
            Outcome::Closed
        } else {
            Outcome::Open
        }
    }

    /// Draws what there is to fill in; whether Enter was pressed there.
    fn fields(&mut self, ui: &mut Ui, folder: Option<&Folder>, theme: &Theme) -> bool {
        let fresh = std::mem::take(&mut self.fresh);
        match &mut self.task {
            Task::Save { card, tags } => {
                let entered = field(ui, "Name", &mut card.name, 1, fresh, theme);
                field(ui, "Kind", &mut card.category, 1, false, theme);
                field(ui, "Tags, with commas between", tags, 1, false, theme);
                card.set_tags(tags);
                field(ui, "Author", &mut card.author, 1, false, theme);
                field(ui, "What it is for", &mut card.about, 3, false, theme);
                entered
            }
            Task::Rename { name, .. } => field(ui, "Name", name, 1, fresh, theme),
            Task::Delete { file } => {
                let text = format!("{file} goes to the folder Deleted beside the presets.");
                note(ui, &text, theme);
                false
            }
            Task::Import { path } => {
                let entered = field(ui, "File to import", path, 1, fresh, theme);
                if let Some(folder) = folder {
                    let path = folder.path().display();
                    let text = format!("What is put into {path} is here too.");
                    note(ui, &text, theme);
                }
                entered
            }
            Task::Export { path, .. } => field(ui, "File to write", path, 1, fresh, theme),
        }
    }

    fn act(&self, session: &mut Session) -> Result<String, Broken> {
        match &self.task {
            Task::Save { card, .. } => {
                session.save(card.clone())?;
                Ok(format!("Saved {}", card.name))
            }
            Task::Rename { file, name } => {
                session.rename(file, name)?;
                Ok(format!("Renamed to {name}"))
            }
            Task::Delete { file } => {
                let to = session.library.delete(file)?;
                Ok(format!("Deleted; it lies in {}", to.display()))
            }
            Task::Import { path } => {
                let path = path.trim().trim_matches('"');
                session.library.import(Path::new(path))?;
                Ok(format!("Imported {path}"))
            }
            Task::Export { preset, path } => {
                let path = path.trim().trim_matches('"');
                session.library.export(preset, Path::new(path))?;
                Ok(format!("Wrote {path}"))
            }
        }
    }
}

/// A field with its name above; whether Enter was pressed in it.
fn field(
    ui: &mut Ui,
    name: &str,
    text: &mut String,
    rows: usize,
    fresh: bool,
    theme: &Theme,
) -> bool {
    let (caption, _) = ui.allocate_exact_size(vec2(ui.available_width(), 18.0), Sense::hover());
    ui.painter().text(
        caption.left_bottom(),
        Align2::LEFT_BOTTOM,
        name,
        small(),
        theme.quiet,
    );
    let edit = if rows > 1 {
        TextEdit::multiline(text).desired_rows(rows)
    } else {
        TextEdit::singleline(text)
    };
    let edit = edit
        .font(body())
        .text_color(theme.text)
        .background_color(theme.ground)
        .desired_width(ui.available_width() - SIDE);
    let response = ui.add(edit).accessible_name(name);
    if fresh {
        response.request_focus();
        select(ui, response.id, text);
    }
    rows == 1 && response.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter))
}

/// What is to be known beside the fields.
fn note(ui: &mut Ui, text: &str, theme: &Theme) {
    let text = RichText::new(text).font(body()).color(theme.quiet);
    ui.add(Label::new(text).wrap());
}

/// Selects all that is in a field, for what is typed to take its place.
fn select(ui: &Ui, id: Id, text: &str) {
    let end = CCursor::new(text.chars().count());
    let mut state = TextEdit::load_state(ui.ctx(), id).unwrap_or_default();
    let all = CCursorRange::two(CCursor::new(0), end);
    state.cursor.set_char_range(Some(all));
    TextEdit::store_state(ui.ctx(), id, state);
}
